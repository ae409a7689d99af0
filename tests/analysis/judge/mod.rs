//! Findings of the judge: none of level doubtful in good flights, and the faults of logs with their reasons.

pub mod faults;
pub mod flights;

use nalgebra::Vector3;
use sins::earth::{Earth, Geodetic};
use sins::judge::{Finding, Judge, Kind, Level};
use sins::math::Euler;
use sins::truth::{FlightSample, IntakeLimits};
use sins::units::STANDARD_GRAVITY;

/// The findings in `samples`.
fn judged(samples: &[FlightSample]) -> Vec<Finding> {
    let mut judge = Judge::new(Earth::default(), IntakeLimits::default().max_acceleration_m_s2).unwrap();
    for sample in samples {
        judge.push(sample).unwrap();
    }
    judge.findings().collect()
}

/// Each good flight, at 50, 10, 5, 2 and 1 Hz, with and without velocities.
#[test]
fn good_flights_are_not_doubtful() {
    let (flights, mut count) = (flights::all(), 0);
    for flight in &flights {
        for rate_hz in [100.0, 50.0, 10.0, 5.0, 2.0, 1.0] {
            let with = flight.at(rate_hz);
            for (label, samples) in [("with", with.clone()), ("without", flights::without_velocities(&with))]
            {
                count += 1;
                for finding in judged(&samples) {
                    println!(
                        "{} {rate_hz} Hz {label} velocities: {:?}: {finding}",
                        flight.name, finding.level
                    );
                    assert!(finding.level < Level::Doubtful, "{} {rate_hz} Hz: {finding}", flight.name);
                }
            }
        }
    }
    println!("{count} flights");
    // The built-in scenes, the logs and the vehicles.
    assert!(flights.len() >= 20 && count == 12 * flights.len(), "{count} of {} flights", flights.len());
}

/// The nose of a glider follows a third of the climb of the air: neither its velocities nor its pitch alone make that a height in feet.
#[test]
fn a_glider_in_thermals_has_no_height_in_feet() {
    for rate_hz in [50.0, 10.0, 1.0] {
        let samples = flights::glider_in_thermals(rate_hz).samples;
        for samples in [flights::without_velocities(&samples), samples] {
            let doubts: Vec<_> =
                judged(&samples).into_iter().filter(|finding| finding.level >= Level::Doubtful).collect();
            assert_eq!(doubts, [], "{rate_hz} Hz");
        }
    }
}

/// Any piece of a good flight is good: a few manoeuvres alone do not look like a fault.
#[test]
fn pieces_of_good_flights_are_not_doubtful() {
    let (flights, mut count, mut doubtful) = (flights::all(), 0, Vec::new());
    for flight in &flights {
        let before = count;
        for (rate_hz, has_velocity) in [(10.0, true), (10.0, false), (2.0, false), (1.0, true)] {
            let rows = flight.at(rate_hz);
            let samples = if has_velocity { rows } else { flights::without_velocities(&rows) };
            for length_s in [30.0, 60.0, 120.0, 300.0] {
                let length = (length_s * rate_hz) as usize;
                for begin in (0..samples.len().saturating_sub(length)).step_by(length / 5) {
                    count += 1;
                    let findings = judged(&samples[begin..begin + length]);
                    let doubts = findings.iter().filter(|finding| finding.level >= Level::Doubtful);
                    let told =
                        |found| format!("{} {rate_hz} Hz, {length} rows from {begin}: {found}", flight.name);
                    doubtful.extend(doubts.map(told));
                }
            }
        }
        assert!(count > before, "no piece of {} was judged", flight.name);
    }
    println!("{count} pieces");
    assert!(doubtful.is_empty(), "{doubtful:#?}");
    assert!(flights.len() >= 20, "{}", flights.len());
}

/// Uneven sampling with right stamps, which differ by up to a fifth of the interval, is not scatter about a steady clock.
#[test]
fn uneven_samples_are_right() {
    for name in ["racetrack", "commuter", "aerobatics"] {
        let flight = sins::scene::builtin(name).unwrap().flight().unwrap();
        let samples: Vec<_> = (0..4000)
            .map(|k| {
                let time_s = f64::from(k) * 0.1 + 0.02 * f64::from(k * 7919 % 101) / 101.0;
                let sample = flight.sample_at(time_s).unwrap();
                FlightSample { v_n: None, ..sample }
            })
            .collect();
        assert_eq!(judged(&samples), []);
    }
}

/// Simulators of a point turn at once: their roll is that of each moment, and changes from one row to the next, at any phase of the rows.
#[test]
fn a_bank_that_changes_at_once_is_not_on_another_clock() {
    let (earth, speed, turn) = (Earth::default(), 60.0, 0.05);
    for rate_hz in [50.0, 10.0, 5.0, 2.0] {
        for begin_s in [0.0, 0.05, 0.3, 0.45, 0.7, 0.95] {
            let mut place = Geodetic { latitude_rad: 0.8, longitude_rad: 0.2, height_m: 600.0 };
            let (mut heading, mut samples) = (0.3_f64, Vec::new());
            let count = (240.0 * rate_hz) as usize;
            for k in 0..count {
                let time_s = k as f64 / rate_hz;
                let rate_of =
                    |time_s: f64| if (time_s - begin_s).rem_euclid(60.0) < 20.0 { turn } else { 0.0 };
                let roll = (speed * rate_of(time_s) / STANDARD_GRAVITY).atan();
                let euler = Euler { roll, pitch: 0.03, heading };
                let v_n = Some(Vector3::new(speed * heading.sin(), speed * heading.cos(), 0.0));
                samples.push(FlightSample {
                    time_s,
                    place,
                    v_n,
                    euler,
                    omega_ib_b: None,
                    f_b: None,
                    temperature_c: None,
                });
                let step_s = 1.0 / (rate_hz * 40.0);
                for part in 0..40 {
                    let half = 0.5 * rate_of(time_s + f64::from(part) * step_s + 1e-9) * step_s;
                    heading += half;
                    let radii = earth.radii(place.latitude_rad.sin());
                    place.latitude_rad +=
                        speed * heading.cos() * step_s / (radii.meridian_m + place.height_m);
                    let across_m = (radii.transverse_m + place.height_m) * place.latitude_rad.cos();
                    place.longitude_rad += speed * heading.sin() * step_s / across_m;
                    heading += half;
                }
            }
            for samples in [flights::without_velocities(&samples), samples] {
                let found = judged(&samples);
                let late = found.iter().find(|finding| finding.kind == Kind::AttitudeLate);
                assert!(late.is_none(), "{rate_hz} Hz, from {begin_s} s on: {}", late.unwrap());
            }
        }
    }
}

/// The memory does not grow with the samples.
#[test]
fn a_judge_has_64_kilobytes_at_most() {
    let samples = flights::scene("commuter", 50.0).samples;
    let began = std::time::Instant::now();
    let findings = judged(&samples);
    let each_ns = began.elapsed().as_secs_f64() * 1e9 / samples.len() as f64;
    println!("{} samples, {each_ns:.0} ns each, {} bytes, {findings:?}", samples.len(), size_of::<Judge>());
    assert!(size_of::<Judge>() < 64 << 10);
}
