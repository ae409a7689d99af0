//! Paths of damaged logs: near the undamaged flight, and without a doubt of the judge.

use sins::ErrorKind;
use sins::earth::{Earth, Geodetic};
use sins::judge::{Judge, Kind, Level};
use sins::log::smooth::{SmoothOptions, Smoothed};
use sins::math::Euler;
use sins::truth::FlightSample;

use crate::judge::faults::{float32, held, move_by, noisy, stale};
use crate::judge::flights::{self, Good, Samples, without_velocities};
use crate::support::DEG;

/// Root mean square distance [m], velocity [m/s] and angle of the attitude [rad] of a path from the flight at the flight's own times,
/// without the first and the last 5 s.
fn apart(flight: &Good, smoothed: &Smoothed) -> [f64; 3] {
    let (earth, [start_s, end_s]) = (Earth::default(), smoothed.span_s());
    let (mut sums, mut count) = ([0.0; 3], 0.0);
    for truth in
        flight.samples.iter().filter(|truth| truth.time_s >= start_s + 5.0 && truth.time_s <= end_s - 5.0)
    {
        let path = smoothed.sample_at(truth.time_s).unwrap();
        let (displacement, _) = earth.displacement(&path.place, &truth.place);
        let [a, b] = [&path, truth].map(|sample| sins::math::attitude_from_euler(&sample.euler));
        let angle = sins::math::rotation_vector(&sins::math::relative_rotation(&a, &b));
        let velocity = path.v_n.unwrap() - truth.v_n.unwrap();
        for (sum, vector) in sums.iter_mut().zip([displacement, velocity, angle]) {
            *sum += vector.norm_squared();
        }
        count += 1.0;
    }
    sums.map(|sum| (sum / count).sqrt())
}

fn smoothed(samples: &[FlightSample]) -> Smoothed {
    Smoothed::new(&Earth::default(), samples, &SmoothOptions::default()).unwrap()
}

/// The path of `samples` at 50 Hz has no doubt.
fn judged(name: &str, path: &Smoothed) {
    let mut judge = Judge::new(Earth::default(), 2000.0).unwrap();
    let [start_s, end_s] = path.span_s();
    for k in 0..=((end_s - start_s) * 50.0) as usize {
        judge.push(&path.sample_at(start_s + k as f64 / 50.0).unwrap()).unwrap();
    }
    for finding in judge.findings() {
        assert!(finding.level < Level::Doubtful, "{name}: {finding}");
    }
}

fn flown() -> Vec<Good> {
    let scenes = ["racetrack", "commuter", "patrol"].map(|name| flights::scene(name, 50.0));
    scenes.into_iter().chain([flights::log("airliner_cruise")]).collect()
}

/// A receiver that stands still for 20 s while the vehicle flies on has no fixes there: neither rests nor jumps are flown.
#[test]
fn fixes_that_froze_are_left_out() {
    for flight in flown() {
        let mut rows = without_velocities(&flight.at(1.0));
        let mut frozen = 0;
        for first in (60..rows.len() - 40).step_by(250) {
            let place = rows[first].place;
            let (way, _) = Earth::default().displacement(&place, &rows[first + 19].place);
            frozen += if way.norm() > 200.0 { 19 } else { 0 };
            rows[first..(first + 20)].iter_mut().for_each(|row| row.place = place);
        }
        let path = smoothed(&rows);
        judged(&flight.name, &path);
        let held = path.findings.iter().find(|finding| finding.kind == Kind::HeldRows);
        assert!(held.is_some(), "{}: {:?}", flight.name, path.findings);
        let [start_s, end_s] = path.span_s();
        let velocity = |k: usize| path.sample_at(start_s + k as f64 / 50.0).unwrap().v_n.unwrap();
        let steps = 1..=((end_s - start_s) * 50.0) as usize;
        let largest = steps.map(|k| (velocity(k) - velocity(k - 1)).norm() * 50.0).fold(0.0, f64::max);
        println!("{}: {largest:.1} m/s2, {} left out", flight.name, path.left_out);
        assert!(path.left_out >= frozen && largest < 30.0, "{}: {largest}", flight.name);
    }
}

/// A receiver that stands still has an attitude that does not: without it a turn of more than a quarter is refused, and a smaller one is
/// flown with the attitude of a straight line.
#[test]
fn an_attitude_outlives_a_fix_that_froze() {
    for (rate_hz, length_s, limit_deg) in [(10.0, 60.0, 0.05), (1.0, 60.0, 0.5), (10.0, 25.0, 0.05)] {
        let flight = flights::scene("racetrack", 50.0);
        let mut rows = without_velocities(&flight.at(rate_hz));
        let turns = |k: &usize| rows[*k].euler.roll.abs() > 0.2;
        let first = (0..rows.len()).find(turns).unwrap() - (10.0 * rate_hz) as usize;
        let (place, last) = (rows[first].place, first + (length_s * rate_hz) as usize);
        rows[first..last].iter_mut().for_each(|row| row.place = place);
        let path = smoothed(&rows);
        let [_, _, angle] = apart(&flight, &path);
        println!("{rate_hz} Hz, {length_s} s: {:.4} deg", angle / DEG);
        assert!(angle < limit_deg * DEG, "{rate_hz} Hz, {length_s} s: {} deg", angle / DEG);
    }
}

/// Noise of a horizontal component, whose vertical part is half larger. The path is nearer to the flight than the rows; its velocity errs
/// by the deviation that a cut-off of half the rate of turn of these flights leaves, and not by the noise over the interval.
#[test]
fn noise_is_smoothed() {
    for flight in flown() {
        for (rate_hz, sigma_m, limit_m_s) in [(10.0, 2.5, 0.5), (1.0, 2.5, 0.7), (10.0, 0.5, 0.2)] {
            let path = smoothed(&noisy(&flight.at(rate_hz), sigma_m));
            let [p, v, a] = apart(&flight, &path);
            let (found, name) = (path.position(), &flight.name);
            println!(
                "{name} {rate_hz} Hz {sigma_m} m: {p:.2} m, {v:.3} m/s, {:.4} deg; {:.2} Hz, noise {:.2} m",
                a / DEG,
                found.cutoff_hz,
                found.noise
            );
            let of_rows_m = sigma_m * (2.0_f64 + 1.5 * 1.5).sqrt();
            assert!(p < of_rows_m && v < limit_m_s, "{name}");
            // The noise that is found is that of the log.
            assert!((0.8..1.25).contains(&(found.noise / sigma_m)), "{name} {}", found.noise);
            judged(name, &path);
        }
    }
}

/// Steps, repeats, lost and spiked rows of an otherwise exact log.
#[test]
fn damage_is_repaired() {
    let spiked = |samples: &[FlightSample]| -> Samples {
        let mut list = without_velocities(samples);
        (50..list.len()).step_by(100).for_each(|k| move_by(&mut list[k], 300.0, 0.0, 0.0));
        list
    };
    let lost = |samples: &[FlightSample]| -> Samples {
        let mut list = without_velocities(samples);
        let mut k = 0;
        list.retain(|_| {
            k += 1;
            k % 10 != 3
        });
        list
    };
    type Damage<'a> = &'a dyn Fn(&[FlightSample]) -> Samples;
    let damages: [(&str, f64, Damage, [f64; 2]); 5] = [
        ("float32", 50.0, &float32, [0.5, 0.1]),
        ("held", 50.0, &held, [0.05, 0.05]),
        ("stale", 10.0, &stale, [0.05, 0.05]),
        ("spiked", 5.0, &spiked, [0.5, 0.3]),
        ("lost", 10.0, &lost, [0.05, 0.05]),
    ];
    for flight in flown() {
        for (damage, rate_hz, apply, limits) in damages {
            let path = smoothed(&apply(&flight.at(rate_hz)));
            let [p, v, a] = apart(&flight, &path);
            println!(
                "{} {damage}: {p:.4} m, {v:.4} m/s, {:.4} deg, {:.2} Hz",
                flight.name,
                a / DEG,
                path.position().cutoff_hz
            );
            assert!(p < limits[0] && v < limits[1], "{} {damage}", flight.name);
            judged(&flight.name, &path);
        }
    }
}

#[test]
fn rows_too_few_or_too_rare_are_refused() {
    let flight = flights::scene("aerobatics", 50.0);
    let refused = |samples: &[FlightSample]| {
        Smoothed::new(&Earth::default(), samples, &SmoothOptions::default()).unwrap_err().to_string()
    };
    let text = refused(&flight.at(50.0)[..19]);
    assert!(text.contains("samples = 19"), "{text}");
    let text = refused(&flight.at(0.2));
    assert!(text.contains("more than 90 degrees"), "{text}");
}

/// Without an attitude: the same flight in calm air, whose angle of attack is known.
#[test]
fn a_coordinated_attitude_is_that_of_the_turns() {
    let flight = flights::scene("racetrack", 50.0);
    let options = SmoothOptions { coordinated_attack_rad: Some(0.0), ..SmoothOptions::default() };
    let mut samples = without_velocities(&flight.at(10.0));
    samples.iter_mut().for_each(|sample| sample.euler = Default::default());
    let path = Smoothed::new(&Earth::default(), &samples, &options).unwrap();
    let [_, _, angle] = apart(&flight, &path);
    println!("{:.3} deg", angle / DEG);
    assert!(angle < 0.5 * DEG);
    let inverted = flights::scene("aerobatics", 50.0).at(10.0);
    let error = Smoothed::new(&Earth::default(), &inverted, &options).unwrap_err().to_string();
    assert!(error.contains("coordinated attitude is not defined"), "{error}");
}

/// Heights that are all 0, as those of a table without one, stay 0.
#[test]
fn a_height_of_zero_is_a_height() {
    let flight = &flown()[0];
    let flat: Vec<FlightSample> = noisy(&flight.at(1.0), 1.0)
        .into_iter()
        .map(|mut sample| {
            sample.place.height_m = 0.0;
            sample
        })
        .collect();
    let path = smoothed(&flat);
    let [start_s, end_s] = path.span_s();
    for k in 0..100 {
        let sample = path.sample_at(start_s + (end_s - start_s) * f64::from(k) / 99.0).unwrap();
        assert!(sample.place.height_m.abs() < 1e-3, "{sample:?}");
    }
}

/// Two flights in one file, or one wrong stamp: no path leads from one to the other.
#[test]
fn a_gap_of_an_hour_is_not_bridged() {
    let flight = &flown()[0];
    let mut rows = flight.at(1.0);
    let later = rows.len() / 2;
    rows[later..].iter_mut().for_each(|row| row.time_s += 3600.0);
    let error = Smoothed::new(&Earth::default(), &rows, &SmoothOptions::default()).unwrap_err();
    assert_eq!(error.index, Some(later));
    let text = error.to_string();
    assert!(
        text.ends_with("= 3601: a path is fitted to one flight at a time, whose gaps are at most 300"),
        "{text}"
    );
    rows[later..].iter_mut().for_each(|row| row.time_s -= 3400.0);
    smoothed(&rows);
}

/// Bursts of rows, with gaps between them that are bridged: the path would have millions of steps for each row.
#[test]
fn bursts_of_rows_take_no_memory() {
    let coordinated = SmoothOptions { coordinated_attack_rad: Some(0.0), ..SmoothOptions::default() };
    for (burst_s, gap_s, options) in
        [(1e-6, 299.0, SmoothOptions::default()), (1e-6, 299.0, coordinated), (1e6, 1e6, coordinated)]
    {
        let row = |k: u32| {
            let time_s = f64::from(k / 20) * gap_s + f64::from(k) * burst_s;
            let place = Geodetic { latitude_rad: 1e-6 * f64::from(k), ..Geodetic::default() };
            FlightSample::at_rest(time_s, place, Euler::default())
        };
        let rows: Vec<FlightSample> = (0..400).map(row).collect();
        let error = Smoothed::new(&Earth::default(), &rows, &options).unwrap_err();
        assert_eq!((error.kind, error.field), (ErrorKind::InvalidArgument, "usual_interval_s"), "{error}");
    }
}
