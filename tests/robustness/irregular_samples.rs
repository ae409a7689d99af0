//! Samples as old hosts send them: any rate, jitter, losses, duplicates, clocks that jump, teleports, coarse logs, fields that are
//! not a number.

use core::f64::consts::TAU;

use nalgebra::Vector3;
use sins::sensors::{TriadParameters, paper_simulation2};
use sins::truth::FlightSample;
use sins::truth::flight::{Channel, Flight, FlightStart, Manoeuvre, Sinusoid, Sinusoids};
use sins::{Error, ErrorKind, ErrorSource, Options, Simulator};

use crate::support::draws::Draws;
use crate::support::{Worst, fly, options_at, patrol, resting_sample};

/// The recommended options, with the vertical channel following the truth and with the times of the stamps themselves.
fn own_stamps() -> Options {
    Options { intake: Default::default(), ..options_at(100.0) }
}

/// Sample of the patrol at `time_s` after the start of its swings [s].
fn at(flight: &Flight, time_s: f64) -> FlightSample {
    FlightSample { time_s, ..flight.sample_at(600.0 + time_s).unwrap() }
}

fn flown(samples: impl Iterator<Item = FlightSample>) -> Worst {
    fly(&mut Simulator::new(&own_stamps()).unwrap(), samples, 1)
}

/// 5 min of patrol from 1 to 1000 Hz: the error falls with the rate down to the rounding of the samples, some nanometres.
#[test]
fn rates_from_1_to_1000_hz() {
    let flight = patrol(1200.0);
    let errors = [1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0, 1000.0].map(|rate_hz| {
        let worst = flown((0..=(300.0 * rate_hz) as u32).map(|k| at(&flight, f64::from(k) / rate_hz)));
        println!(
            "{rate_hz} Hz: {:.1e} m, {:.1e} m/s, {:.1e} rad",
            worst.position_m, worst.velocity_m_s, worst.misalignment_rad
        );
        (rate_hz, worst.position_m)
    });
    for pair in errors.windows(2) {
        let [(slow_hz, slow_m), (fast_hz, fast_m)] = [pair[0], pair[1]];
        // The order is three, less a half for motions of 0.3 to 0.5 Hz that slow samples do not resolve.
        let rounding = 1e-8;
        assert!(
            fast_m < slow_m * (slow_hz / fast_hz).powf(2.5) + rounding,
            "{slow_hz} {slow_m:e} {fast_hz} {fast_m:e}"
        );
    }
    let figures = [0, 3, 6, 9].map(|k| {
        let (rate_hz, error_m) = errors[k];
        let size = if error_m < 0.01 { format!("{error_m:.1e}") } else { format!("{error_m:.1}") };
        format!("{size} m at {rate_hz} Hz")
    });
    println!("figure: {}", figures.join(", "));
}

/// Half an interval of jitter at 100 Hz, so that samples come 0.2 to 20 ms apart, and each tenth lost: the physics is the same,
/// at the accuracy of the longest intervals.
#[test]
fn jitter_of_half_an_interval_and_losses() {
    let flight = patrol(1200.0);
    let jittered = |lost: bool| {
        let samples = (1..30_000_u32)
            .filter(move |k| !lost || k % 10 != 7)
            .map(|k| at(&flight, f64::from(k) / 100.0 + Draws::new(k.into()).within(-0.0049, 0.0049)));
        flown(samples.collect::<Vec<_>>().into_iter())
    };
    let steady = flown((0..15_000_u32).map(|k| at(&flight, f64::from(k) / 50.0)));
    let worst_m = [false, true].map(|lost| {
        let worst = jittered(lost);
        println!(
            "jitter of ±50 %, one of ten lost {lost}: {:.1e} m, {:.1e} m/s; 50 Hz steadily {:.1e} m",
            worst.position_m, worst.velocity_m_s, steady.position_m
        );
        // Uneven stencils lose an order at their ends. Samples are 20 ms apart at the most, or 30 with a loss: 2 to 3⁴/2⁴ of
        // 50 Hz. Each sample adds an ulp of the attitude, 2e-16 rad, over 0.2 ms.
        let longest: f64 = if lost { 1.5 } else { 1.0 };
        let share = 10.0 * longest.powi(4);
        assert!(worst.position_m < share * steady.position_m + 1e-7, "{worst:?}");
        // The same bound, with the rounding over the 300 s.
        assert!(worst.velocity_m_s < share * steady.velocity_m_s + 1e-7 / 300.0, "{worst:?}");
        worst.position_m
    });
    println!(
        "figure: jitter {:.1e} m; lost samples {:.1e} m; regular samples at 50 Hz {:.1e} m",
        worst_m[0], worst_m[1], steady.position_m
    );
}

/// Bad samples, each with its name and the kind of its refusal.
fn bad_samples(good: &FlightSample) -> Vec<(&'static str, FlightSample, ErrorKind)> {
    let mut bad = Vec::new();
    let mut add = |what, kind, change: &dyn Fn(&mut FlightSample)| {
        let mut sample = *good;
        change(&mut sample);
        bad.push((what, sample, kind));
    };
    let (late, gap, jump) = (ErrorKind::TimeOrder, ErrorKind::Discontinuity, ErrorKind::Discontinuity);
    add("the same stamp again", late, &|s| s.time_s -= 0.01);
    add("reversed by a sample", late, &|s| s.time_s -= 0.02);
    add("reversed by an hour", late, &|s| s.time_s -= 3600.0);
    add("10 µs after", late, &|s| s.time_s -= 0.00999);
    add("3 s late", gap, &|s| s.time_s += 3.0);
    add("an hour late", gap, &|s| s.time_s += 3600.0);
    for (what, metres) in
        [("teleport by 15 m", 15.0), ("by 1 km", 1e3), ("by 1000 km", 1e6), ("by 15 m south", -15.0)]
    {
        add(what, jump, &|s| s.place.latitude_rad += metres / 6.37e6);
        add(what, jump, &|s| s.place.longitude_rad += metres / 6.37e6 / s.place.latitude_rad.cos());
        add(what, jump, &|s| s.place.height_m += metres.min(1e5));
    }
    add("velocity by 100 m/s", jump, &|s| s.v_n = s.v_n.map(|v| v + Vector3::x() * 100.0));
    add("velocity reversed", jump, &|s| s.v_n = s.v_n.map(|v| -v));
    add("upside down", jump, &|s| s.euler.roll += std::f64::consts::PI);
    type Field = fn(&mut FlightSample) -> &mut f64;
    let fields: [Field; 16] = [
        |s| &mut s.time_s,
        |s| &mut s.place.latitude_rad,
        |s| &mut s.place.longitude_rad,
        |s| &mut s.place.height_m,
        |s| &mut s.v_n.as_mut().unwrap().x,
        |s| &mut s.v_n.as_mut().unwrap().y,
        |s| &mut s.v_n.as_mut().unwrap().z,
        |s| &mut s.euler.roll,
        |s| &mut s.euler.pitch,
        |s| &mut s.euler.heading,
        |s| &mut s.omega_ib_b.get_or_insert_default().x,
        |s| &mut s.omega_ib_b.get_or_insert_default().y,
        |s| &mut s.omega_ib_b.get_or_insert_default().z,
        |s| &mut s.f_b.get_or_insert_default().x,
        |s| &mut s.f_b.get_or_insert_default().y,
        |s| &mut s.f_b.get_or_insert_default().z,
    ];
    for field in fields {
        for value in [f64::NAN, -f64::NAN, f64::INFINITY, f64::NEG_INFINITY, f64::MAX, f64::MIN] {
            add("no number, infinite or out of range", ErrorKind::InvalidArgument, &|s| *field(s) = value);
        }
    }
    bad
}

/// Every bad sample is pushed before each good one of a noisy run: each is refused with its kind, the simulator does not change
/// in any inner field, and the run continues to the same bits as without bad samples.
#[test]
fn bad_samples_are_refused_and_leave_no_trace() {
    let flight = patrol(1200.0);
    let (gyro, accel) = paper_simulation2();
    let noisy = |options: &Options| {
        let mut simulator = Simulator::new(options).unwrap();
        simulator.set_gyro(&gyro).unwrap();
        simulator.set_accel(&accel).unwrap();
        simulator
    };
    let (mut refused, mut passed) = (0, 0);
    for (label, options, velocity) in [
        ("own stamps", own_stamps(), true),
        ("stated period", options_at(100.0), true),
        ("no velocity", own_stamps(), false),
    ] {
        let (mut plagued, mut quiet) = (noisy(&options), noisy(&options));
        for k in 0..8 {
            let mut good = at(&flight, f64::from(k) / 100.0);
            for (what, mut bad, kind) in bad_samples(&good) {
                let kinematic = what.starts_with("velocity");
                // The first two samples define place and speed: before them no sample is a teleport.
                let is_judged = kind == ErrorKind::InvalidArgument || k > 2;
                if !is_judged || (!velocity && kinematic) {
                    continue;
                }
                if !velocity && bad.v_n.is_some_and(|v| v.iter().all(|v| v.abs() < 1e4)) {
                    bad.v_n = None;
                }
                let before = format!("{plagued:?}");
                let error = plagued.push_sample(&bad).expect_err(what);
                let kinds = [
                    kind,
                    if kind == ErrorKind::Discontinuity && label == "stated period" {
                        ErrorKind::TimeOrder
                    } else {
                        kind
                    },
                ];
                assert!(kinds.contains(&error.kind), "{label}, {what}: {error}");
                assert_eq!(before, format!("{plagued:?}"), "{label}, {what}");
                refused += 1;
            }
            if !velocity {
                good.v_n = None;
            }
            passed += 1;
            for simulator in [&mut plagued, &mut quiet] {
                simulator.push_sample(&good).unwrap();
                simulator.step().unwrap();
            }
        }
        assert_eq!(format!("{plagued:?}"), format!("{quiet:?}"), "{label}");
    }
    println!("figure: {refused} bad samples between {passed} good ones");
}

/// A clock jump of up to the longest gap is a long interval. With a stated period it is noise, lost samples, or refused.
#[test]
fn jumps_of_the_clock_from_1_ms_to_an_hour() {
    let after_jump = |options: &Options, jump_s: f64| -> Result<f64, Error> {
        let mut simulator = Simulator::new(options).unwrap();
        let mut worst_m = 0.0_f64;
        for k in 0..100 {
            let time_s = f64::from(k) / 100.0 + if k >= 50 { jump_s } else { 0.0 };
            simulator.push_sample(&resting_sample(time_s))?;
            simulator.step().unwrap();
            let (_, errors) = simulator.errors(ErrorSource::Navigation).unwrap().unwrap();
            // The error of one interval, in which the force turns with the Earth: g W² T⁴/6.
            let own_m = 9.8 * (7.3e-5_f64).powi(2) * jump_s.powi(4) / 6.0;
            assert!(errors.position_n.norm() < 1e-8 + own_m, "{jump_s} {errors:?}");
            worst_m = worst_m.max(errors.position_n.norm());
        }
        Ok(worst_m)
    };
    let mut worst_m = 0.0_f64;
    for jump_s in [0.001, 0.01, 0.1, 1.0, 2.49] {
        worst_m = worst_m.max(after_jump(&own_stamps(), jump_s).unwrap());
    }
    for jump_s in [2.5, 10.0, 3600.0] {
        assert_eq!(after_jump(&own_stamps(), jump_s).unwrap_err().kind, ErrorKind::Discontinuity, "{jump_s}");
    }
    // With a stated period, less than 0.4 of it is noise of the host, whole periods are lost samples, anything else is refused.
    for jump_s in [0.001, 0.0039, 0.01, 1.0, 2.48] {
        worst_m = worst_m.max(after_jump(&options_at(100.0), jump_s).unwrap());
    }
    assert_eq!(after_jump(&options_at(100.0), 0.005).unwrap_err().kind, ErrorKind::TimeOrder);
    assert_eq!(after_jump(&options_at(100.0), 3600.0).unwrap_err().kind, ErrorKind::Discontinuity);
    println!("figure: {worst_m:.1e} m");
}

/// Samples lost in a weave of 4 g, its bank at up to 170 °/s, at 100 Hz: attitude and velocity are right after the gap, and the
/// position error of the gap does not grow.
#[test]
fn a_gap_in_a_weave_leaves_what_its_interpolation_missed() {
    let (speed_m_s, swing_rad, frequency_hz) = (250.0, 0.19, 0.125);
    let terms = [Sinusoid { channel: Channel::Course, amplitude: swing_rad, frequency_hz, phase_rad: 0.0 }];
    let start = FlightStart { speed_m_s, height_m: 3000.0, ..FlightStart::default() };
    let weave = Manoeuvre::Sinusoids { duration_s: 200.0, ramp_s: 10.0, sinusoids: Sinusoids::of(&terms) };
    let flight = Flight::new(&start, &[weave]).unwrap();
    let errors = |lost: core::ops::Range<u32>| {
        let mut simulator = Simulator::new(&own_stamps()).unwrap();
        let [mut after, mut worst] = [0.0_f64; 2];
        for k in (0..19_000).filter(|k| !lost.contains(k)) {
            simulator.push_sample(&flight.sample_at(f64::from(k) / 100.0).unwrap()).unwrap();
            simulator.step().unwrap();
            if k >= lost.end {
                let error = simulator.errors(ErrorSource::Navigation).unwrap().unwrap().1.position_n.norm();
                after = if k == lost.end { error } else { after };
                worst = worst.max(error);
            }
        }
        [after, worst]
    };
    let [_, without] = errors(0..0);
    let mut growth = 0.0_f64;
    let largest = [20, 50, 100, 200, 249].map(|gap| {
        let mut largest = 0.0_f64;
        let gap_s = f64::from(gap) / 100.0;
        // Interpolation of the velocity by values and slopes at the ends of the gap, v⁗ T⁵/720, and the slopes' own error.
        let interpolation = speed_m_s * swing_rad * (TAU * frequency_hz).powi(4) * gap_s.powi(5) / 720.0;
        for phase in 0..4 {
            let first = 5000 + 200 * phase;
            let [after, worst] = errors(first..first + gap - 1);
            println!("{gap_s} s lost: {after:.1e} m, in 130 s {worst:.1e} m");
            assert!(after < 4.0 * interpolation + 1e-4, "{gap_s} s: {after} m, {interpolation} m");
            assert!(worst < after + 2.0 * without, "{gap_s} s: {worst} m, {after} m, {without} m");
            (largest, growth) = (largest.max(after), growth.max(worst - after));
        }
        largest
    });
    let [short, second, long] = [0, 2, 4].map(|k| largest[k]);
    let why = "because the path in between is unknown";
    let growth = format!("{:.1} mm, without the gap {:.1} mm", 1e3 * growth, 1e3 * without);
    println!("figure: {short:.1e}, {second:.3}, {long:.1} m, {why}; {growth}");
}

/// A slew to another place, speed and attitude: from the first interval on the ideal signals are those of a flight that was
/// always there, except for the first stencils of two and three points.
#[test]
fn a_reposition_makes_no_spike() {
    let flight = patrol(1200.0);
    let mut through = Simulator::new(&own_stamps()).unwrap();
    let mut slewed = Simulator::new(&own_stamps()).unwrap();
    for simulator in [&mut through, &mut slewed] {
        let set = TriadParameters { bandwidth_hz: Vector3::repeat(30.0), ..Default::default() };
        simulator.set_accel(&set).unwrap();
    }
    for k in 0..100 {
        through.push_sample(&at(&flight, f64::from(k) / 100.0)).unwrap();
        through.step().unwrap();
        slewed.push_sample(&resting_sample(f64::from(k) / 100.0)).unwrap();
        slewed.step().unwrap();
    }
    // From here on both simulators fly the same flight.
    through.push_sample(&at(&flight, 1.0)).unwrap();
    through.step().unwrap();
    slewed.reposition(&at(&flight, 1.0)).unwrap();
    let (mut force, mut rate): (f64, f64) = (0.0, 0.0);
    for k in 101..200 {
        for simulator in [&mut through, &mut slewed] {
            simulator.push_sample(&at(&flight, f64::from(k) / 100.0)).unwrap();
            simulator.step().unwrap();
        }
        let [a, b] = [&through, &slewed].map(|simulator| simulator.imu().unwrap());
        force = force.max((a.ideal.velocity - b.ideal.velocity).norm() / 0.01);
        rate = rate.max((a.ideal.angle - b.ideal.angle).norm() / 0.01);
        // The filters start in the steady state of their first increment: they are off by no more than the signal changes.
        assert!((b.measured.velocity - b.ideal.velocity).norm() / 0.01 < 1.0, "{k}");
        let (_, errors) = slewed.errors(ErrorSource::Navigation).unwrap().unwrap();
        assert!(errors.velocity_n.norm() < 0.05 && errors.position_n.norm() < 0.05, "{errors:?}");
    }
    println!("figure: {force:.1e} m/s², {rate:.1e} rad/s");
    // Δv and Δθ come from the samples; the force turns within an interval by the order T² a'': (0.01 s · 2 rad/s)² of 10 m/s².
    assert!(force < 4e-3 && rate < 1e-6, "{force:e} {rate:e}");
}
