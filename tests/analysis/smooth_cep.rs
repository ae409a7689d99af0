//! What an INS says of a log that was damaged and smoothed: the radii of many runs at its end, against those on the undamaged flight.
//!
//! The ordinary test flies two transports and four damages, with 50 runs of navigation grade; `--features long-tests` flies all
//! transports and all damages, with 100 runs of navigation and of industrial grade, and aerobatics.

use sins::earth::Earth;
use sins::ensemble::Ensemble;
use sins::log::smooth::{SmoothOptions, Smoothed};
use sins::sensors::{Grade, StreamKey};
use sins::truth::{FlightSample, IntakeLimits};
use sins::{ErrorParameters, ErrorSource, Options, Simulator};

use crate::judge::faults::{Draws, each, float32, held, move_by, noisy, stale};
use crate::judge::flights::{self, Good, Samples, without_velocities};
use crate::support::DEG;

/// Rate at which the flights are flown [Hz], and the most of them [s].
const RATE_HZ: f64 = 50.0;
const LONGEST_S: f64 = 600.0;

/// Radii within which half and 95 % of the runs are at the end [m].
pub fn radii(samples: &[FlightSample], grade: Grade, runs: usize) -> [f64; 2] {
    let (gyro, accel) = grade.parameters();
    let errors = ErrorParameters { gyro, accel, initial: grade.start(), ..ErrorParameters::default() };
    let options = Options {
        error_model: false,
        intake: IntakeLimits { period_s: Some(1.0 / RATE_HZ), ..IntakeLimits::default() },
        key: StreamKey { seed: 5, run: 0 },
        ..Options::default()
    };
    let mut template = Simulator::new(&options).unwrap();
    errors.set_to(&mut template).unwrap();
    let mut ensemble = Ensemble::new(&template, 0, runs).unwrap();
    for sample in samples {
        ensemble.push_sample(sample).unwrap();
        ensemble.step().unwrap();
    }
    // The statistics have buckets of 1 %: too coarse here.
    let errors =
        (0..runs as u64).map(|run| ensemble.errors(run, ErrorSource::Navigation).unwrap().unwrap().1);
    let mut radii: Vec<f64> = errors.map(|errors| errors.position_n.xy().norm()).collect();
    radii.sort_by(f64::total_cmp);
    [50, 95].map(|percent| radii[(runs * percent).div_ceil(100) - 1])
}

/// Rounds the positions to steps of an angle [rad] and of the height [m].
fn stepped(samples: &[FlightSample], angle: f64, height_m: f64) -> Samples {
    each(&without_velocities(samples), |_, sample| {
        let place = &mut sample.place;
        place.latitude_rad = (place.latitude_rad / angle).round() * angle;
        place.longitude_rad = (place.longitude_rad / angle).round() * angle;
        place.height_m = (place.height_m / height_m).round() * height_m;
    })
}

fn lost(samples: &[FlightSample]) -> Samples {
    let rows = samples.iter().enumerate().filter(|(k, _)| k % 10 != 3);
    without_velocities(&rows.map(|(_, sample)| *sample).collect::<Samples>())
}

fn spiked(samples: &[FlightSample]) -> Samples {
    each(&without_velocities(samples), |k, sample| {
        if k % 100 == 50 {
            move_by(sample, 300.0, 0.0, 0.0);
        }
    })
}

/// Stamps that scatter by up to `size_s` about those at which the positions were taken.
fn scattered(samples: &[FlightSample], size_s: f64) -> Samples {
    let mut draws = Draws(3);
    let last = samples.len() - 1;
    each(&without_velocities(samples), |k, sample| {
        sample.time_s += if k == 0 || k == last { 0.0 } else { size_s * draws.uniform() };
    })
}

/// Each tenth row again, 60 us later.
fn doubled(samples: &[FlightSample]) -> Samples {
    let mut list = Samples::new();
    for (k, sample) in stepped(samples, 1e-7 * DEG, 0.01).iter().enumerate() {
        list.push(*sample);
        if k % 10 == 5 {
            list.push(FlightSample { time_s: sample.time_s + 60e-6, ..*sample });
        }
    }
    list
}

/// Attitudes with noise, in steps of 0.1 deg.
fn rough(samples: &[FlightSample]) -> Samples {
    let mut draws = Draws(4);
    each(&noisy(samples, 2.5), |_, sample| {
        let euler = &mut sample.euler;
        for angle in [&mut euler.roll, &mut euler.pitch, &mut euler.heading] {
            *angle = ((*angle + 0.5 * DEG * draws.normal()) / (0.1 * DEG)).round() * (0.1 * DEG);
        }
    })
}

/// A damage: its name, the rate of its rows [Hz], and whether the attitude is taken as that of a coordinated flight.
struct Damage {
    name: &'static str,
    rate_hz: f64,
    is_coordinated: bool,
    apply: fn(&[FlightSample]) -> Samples,
}

const DAMAGES: [Damage; 13] = {
    const fn with(
        name: &'static str,
        rate_hz: f64,
        is_coordinated: bool,
        apply: fn(&[FlightSample]) -> Samples,
    ) -> Damage {
        Damage { name, rate_hz, is_coordinated, apply }
    }
    [
        with("2.5 m of noise", 10.0, false, |samples| noisy(samples, 2.5)),
        with("float32", 50.0, false, float32),
        with("fixes held for five rows", 50.0, false, held),
        with("1 % outliers of 300 m", 5.0, false, spiked),
        with("2.5 m of noise", 1.0, false, |samples| noisy(samples, 2.5)),
        with("2.5 m, 0.5 deg in steps of 0.1 deg", 5.0, false, rough),
        with("steps of 1e-6 deg and 25 ft", 5.0, false, |samples| stepped(samples, 1e-6 * DEG, 7.62)),
        with("a tenth lost, 0.5 m", 10.0, false, |samples| lost(&noisy(samples, 0.5))),
        with("stamps scatter by 20 ms", 10.0, false, |samples| scattered(samples, 0.02)),
        with("rows 60 us apart", 10.0, false, doubled),
        with("ADS-B: 1e-5 deg, 25 ft, a twentieth stale, no attitude", 1.0, true, |samples| {
            stale(&stepped(samples, 1e-5 * DEG, 7.62))
        }),
        with("2.5 m, no attitude", 1.0, true, |samples| noisy(samples, 2.5)),
        with("no attitude", 10.0, true, without_velocities),
    ]
};

fn transports() -> Vec<Good> {
    let scenes = ["racetrack", "commuter", "patrol"].map(|name| flights::scene(name, RATE_HZ));
    let mut flights: Vec<Good> = [flights::log("airliner_cruise")].into_iter().chain(scenes).collect();
    for flight in &mut flights {
        flight.samples.retain(|sample| sample.time_s - LONGEST_S < 1e-9);
    }
    flights
}

/// Radii on the smoothed path of a damaged flight over those on the flight, less one [%]: of half and of 95 % of the runs.
struct Compared {
    #[cfg_attr(not(feature = "long-tests"), expect(dead_code, reason = "named in what the long tests find"))]
    of: (String, Grade),
    percent: [f64; 2],
}

/// Each damage of a flight with each grade; what no path can be fitted to is told.
fn compared(flight: &Good, damages: &[Damage], grades: &[Grade], runs: usize) -> Vec<Compared> {
    let every = if flight.rate_hz > 1.5 * RATE_HZ { 2 } else { 1 };
    let truth: Samples = flight.samples.iter().step_by(every).copied().collect();
    assert!((truth[1].time_s - truth[0].time_s - 1.0 / RATE_HZ).abs() < 1e-9, "{}", flight.name);
    let whole = truth.len();
    let of_truth: Vec<[f64; 2]> = grades.iter().map(|grade| radii(&truth, *grade, runs)).collect();
    let mut all = Vec::new();
    for damage in damages {
        let what = format!("{} {} Hz, {}", flight.name, damage.rate_hz, damage.name);
        let rows = (damage.apply)(&flight.at(damage.rate_hz));
        let coordinated_attack_rad = damage.is_coordinated.then_some(0.0);
        let options = SmoothOptions { coordinated_attack_rad, ..SmoothOptions::default() };
        let smoothed = match Smoothed::new(&Earth::default(), &rows, &options) {
            Ok(smoothed) => smoothed,
            Err(error) => {
                println!("{what}: {error}");
                continue;
            }
        };
        let [start_s, end_s] = smoothed.span_s();
        let of_path = truth.iter().map(|sample| sample.time_s);
        let of_path = of_path.filter(|time_s| (start_s..=end_s).contains(time_s));
        let path: Samples = of_path.map(|time_s| smoothed.sample_at(time_s).unwrap()).collect();
        // A path may begin behind the first row: both fly the same time.
        let in_common = |sample: &&FlightSample| (start_s..=end_s).contains(&sample.time_s);
        let truth: Samples = truth.iter().filter(in_common).copied().collect();
        for (grade, of_truth) in grades.iter().zip(&of_truth) {
            let of_truth = if truth.len() == whole { *of_truth } else { radii(&truth, *grade, runs) };
            let of_path = radii(&path, *grade, runs);
            let percent = [0, 1].map(|place| 100.0 * (of_path[place] / of_truth[place] - 1.0));
            let [half, most] = percent;
            println!("{what}, {grade:?}: CEP50 {:.2} m {half:+.1} %, R95 {most:+.1} %", of_truth[0]);
            all.push(Compared { of: (what.clone(), *grade), percent });
        }
    }
    all
}

#[test]
fn an_ins_errs_on_smoothed_logs_as_on_the_flight() {
    let is_whole = cfg!(feature = "long-tests");
    let (runs, grades): (usize, &[Grade]) =
        if is_whole { (100, &[Grade::Navigation, Grade::Industrial]) } else { (50, &[Grade::Navigation]) };
    let damages = &DAMAGES[..if is_whole { DAMAGES.len() } else { 4 }];
    let mut ratios = Vec::new();
    for flight in transports().iter().take(if is_whole { 4 } else { 2 }) {
        let all = compared(flight, damages, grades, runs);
        assert_eq!(all.len(), damages.len() * grades.len(), "{}", flight.name);
        ratios.extend(all.iter().flat_map(|one| one.percent));
    }
    let within = |percent: f64| {
        100.0 * ratios.iter().filter(|ratio| ratio.abs() <= percent).count() as f64 / ratios.len() as f64
    };
    println!("{} figures: {:.0} % within 2 %, {:.0} % within 5 %", ratios.len(), within(2.0), within(5.0));
    assert!(within(2.0) >= 90.0 && within(5.0) >= 97.0);
}

/// Whether a gyro of a grade is beyond its range on a flight.
#[cfg(feature = "long-tests")]
fn is_beyond_range(flight: &Good, grade: Grade) -> bool {
    let mut simulator = Simulator::new(&Options::default()).unwrap();
    simulator.set_gyro(&grade.parameters().0).unwrap();
    flight.samples.iter().any(|sample| {
        simulator.push_sample(sample).unwrap();
        simulator.step().unwrap();
        simulator.imu().is_some_and(|imu| imu.flags.gyro_saturated)
    })
}

/// Rolls, loops and 5 g: within 12 %, unless a gyro is beyond its range, on which the error then hangs, or no path can be fitted.
#[cfg(feature = "long-tests")]
#[test]
fn an_ins_errs_on_smoothed_aerobatics_nearly_as_on_the_flight() {
    let grades = [Grade::Navigation, Grade::Industrial];
    let (mut count, mut beyond) = (0, 0);
    for flight in [flights::log("fighter_aerobatics"), flights::scene("aerobatics", RATE_HZ)] {
        let is_beyond = grades.map(|grade| is_beyond_range(&flight, grade));
        for one in compared(&flight, &DAMAGES, &grades, 100) {
            let is_near = one.percent.iter().all(|percent| percent.abs() <= 12.0);
            let may_differ = is_beyond[usize::from(one.of.1 == Grade::Industrial)];
            assert!(is_near || may_differ, "{:?}: {:?} %", one.of, one.percent);
            (count, beyond) = (count + 1, beyond + usize::from(!is_near));
        }
    }
    println!("{count} figures, {beyond} beyond 12 % with a gyro beyond its range");
    assert!(count > 30 && beyond < 6);
}
