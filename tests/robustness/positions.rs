//! Positions as old hosts send them: contradicting their own velocities, rounded, and without velocities.

use nalgebra::{Vector2, Vector3};
use sins::earth::Geodetic;
use sins::mechanization::VerticalMode;
use sins::truth::FlightSample;
use sins::{Error, ErrorKind, ErrorSource, Options, Simulator};

use crate::support::{DEG, options_at, patrol, resting_sample};

/// Positions that move with a velocity of zero, and the other way round: the run is flown, each sample is flagged, and the
/// closure is attributed to the host.
#[test]
fn velocity_that_contradicts_position_is_the_hosts_own() {
    let (mut flagged, mut worst) = (0, 0.0f64);
    for (position_m_s, velocity_m_s) in [(5.0, 0.0), (0.0, 5.0), (5.0, -5.0)] {
        let mut simulator = Simulator::new(&options_at(100.0)).unwrap();
        let meridian_m = simulator.options().earth().radii((39.9 * DEG).sin()).meridian_m;
        for k in 0..=6000 {
            let time_s = f64::from(k) / 100.0;
            let mut sample = resting_sample(time_s);
            sample.place.latitude_rad += position_m_s * time_s / meridian_m;
            sample.v_n = Some(Vector3::new(0.0, velocity_m_s, 0.0));
            simulator.push_sample(&sample).unwrap();
            simulator.step().unwrap();
        }
        let (_, _, closure) = simulator.accuracy().unwrap().unwrap();
        assert!(simulator.truth().unwrap().unwrap().inconsistent);
        assert!(simulator.navigation().unwrap().unwrap().inconsistent);
        println!(
            "position at {position_m_s} m/s, velocity {velocity_m_s} m/s, 60 s: {} flagged, closure {:.1} m, host's share {:.1} m",
            closure.inconsistent_samples, closure.position_n.y, closure.host_position_n.y
        );
        assert_eq!(closure.inconsistent_samples, 6000);
        let expected = (velocity_m_s - position_m_s) * 60.0;
        // Schuler's pendulum reduces the expected error by (t/806 s)²/6.
        assert!((closure.position_n.y / expected - 1.0).abs() < 2e-3, "{}", closure.position_n);
        assert!(
            (closure.host_position_n.y / closure.position_n.y - 1.0).abs() < 2e-3,
            "{}",
            closure.host_position_n
        );
        flagged += closure.inconsistent_samples;
        let [flown, of_host] =
            [closure.position_n.y / expected, closure.host_position_n.y / closure.position_n.y];
        worst = worst.max((flown - 1.0).abs()).max((of_host - 1.0).abs());
    }
    println!("figure: all {flagged}, to {:.2} % (limit 0.2 %)", 100.0 * worst);
}

/// A log rounded to 1e-7° and 1 cm, or to single precision: with velocities the positions cost only their own rounding,
/// without velocities the velocity is derived from the positions.
#[test]
fn a_log_of_seven_decimals_and_centimetres() {
    let flight = patrol(1200.0);
    let at = |time_s: f64| FlightSample { time_s, ..flight.sample_at(600.0 + time_s).unwrap() };
    type Round = fn(f64) -> f64;
    let decimal: [Round; 2] =
        [|angle| (angle / DEG * 1e7).round() / 1e7 * DEG, |height_m| (height_m * 100.0).round() / 100.0];
    let single: [Round; 2] =
        [|angle| f64::from((angle / DEG) as f32) * DEG, |height_m| f64::from(height_m as f32)];
    // Half a step of latitude and longitude: 2^-18 and 2^-17 degrees at 40° and 116°.
    let decimal_m = 0.5e-7 * DEG * 6.4e6 * 2.0_f64.sqrt();
    let (mut positions, mut velocities) = (Vec::new(), Vec::new());
    let single_m = 0.5_f64.powi(18) * DEG * 6.4e6 * (0.25 + (40.0 * DEG).cos().powi(2)).sqrt();
    for (label, [round, round_height], step_m, velocity, rate_hz) in [
        ("1e-7° and 1 cm with velocities", decimal, decimal_m, true, 100.0),
        ("single precision with velocities", single, single_m, true, 100.0),
        ("1e-7° and 1 cm without", decimal, decimal_m, false, 100.0),
        ("1e-7° and 1 cm without", decimal, decimal_m, false, 10.0),
    ] {
        let mut simulator =
            Simulator::new(&Options { intake: Default::default(), ..options_at(100.0) }).unwrap();
        for k in 0..=(300.0 * rate_hz) as u32 {
            let mut sample = at(f64::from(k) / rate_hz);
            let Geodetic { latitude_rad, longitude_rad, height_m } = sample.place;
            sample.place = Geodetic {
                latitude_rad: round(latitude_rad),
                longitude_rad: round(longitude_rad),
                height_m: round_height(height_m),
            };
            if !velocity {
                sample.v_n = None;
            }
            simulator.push_sample(&sample).unwrap();
            simulator.step().unwrap();
        }
        let (_, errors) = simulator.errors(ErrorSource::Navigation).unwrap().unwrap();
        let exact = at(300.0);
        let navigated = simulator.navigation().unwrap().unwrap().navigation;
        let off = (navigated.v_n - exact.v_n.unwrap()).norm();
        println!(
            "log of {label} at {rate_hz} Hz: {:.1e} m, {off:.1e} m/s off the true velocity",
            errors.position_n.norm()
        );
        if velocity {
            positions.push(format!("{:.1e} m", errors.position_n.norm()));
            // The first and the last position are off by half a step each; gravity leans with them.
            assert!(errors.position_n.norm() < 3.0 * step_m, "{}", errors.position_n);
            assert!(off < 9.8 * step_m / 6.4e6 * 300.0, "{off:e}");
        } else {
            velocities.push(format!("{off:.2} m/s at {rate_hz} Hz"));
            // Weights 11/6, 3, 3/2, 1/3 over the interval on half a step each, at the end and, once, at the start.
            let noise = 6.7 * step_m * rate_hz;
            assert!(off < noise + 0.5 / rate_hz * 6.0, "{off:e} {noise}");
        }
    }
    println!("figure: {}; {}", positions.join(", "), velocities.join(", "));
}

/// Exact positions alone: the first velocity is the mean over the first interval. Its error δv lasts no longer than an interval
/// T, so that the INS is off by at most T δv, which swings with ω² = g/R. The velocity of comparison also has roundings of the
/// position over T.
#[test]
fn positions_alone_miss_the_first_velocity() {
    let flight = patrol(1200.0);
    let rate_hz = 50.0;
    let at = |k: u32| {
        let time_s = f64::from(k) / rate_hz;
        FlightSample { time_s, ..flight.sample_at(300.0 + time_s).unwrap() }
    };
    let mut simulator = Simulator::new(&options_at(rate_hz)).unwrap();
    let earth = simulator.options().earth();
    for k in 0..=30_000 {
        simulator.push_sample(&FlightSample { v_n: None, ..at(k) }).unwrap();
        simulator.step().unwrap();
    }
    let [first, second] = [0, 1].map(|k| earth.to_earth_fixed(&at(k).place));
    let (east, north, _) = earth.east_north_up(&at(0).place);
    let mean = (second - first) * rate_hz;
    let missed = Vector2::new(mean.dot(&east), mean.dot(&north)) - at(0).v_n.unwrap().xy();
    let (_, errors) = simulator.errors(ErrorSource::Navigation).unwrap().unwrap();
    let off_m = missed.norm() / rate_hz;
    assert!(errors.position_n.norm() < off_m, "{} {off_m:e}", errors.position_n);
    let off_m_s = 1.24e-3 * off_m;
    assert!(errors.velocity_n.norm() < off_m_s, "{} {off_m_s:e}", errors.velocity_n);
    let off = (simulator.navigation().unwrap().unwrap().navigation.v_n - at(30_000).v_n.unwrap()).norm();
    assert!(off < off_m_s + 7e-9 * rate_hz, "{off:e}");
    println!("figure: {:.1e} m (limit {off_m:.1e} m)", errors.position_n.norm());
}

/// A log of positions alone loses samples in straight flight. Half a step ε of its grid makes errors of (11/6 + 3 + 3/2 + 1/3) ε/t
/// in a velocity, as many times that over t in the acceleration before a gap T, and 2 ε/t, of it twice over t, in those behind
/// it. Between its ends a gap's path misses T²/12 of the accelerations' difference.
#[test]
fn a_gap_in_positions_alone_costs_what_their_noise_does() {
    let half_step_m = 0.5e-7 * DEG * 6.4e6 * 2.0_f64.sqrt();
    let mut figures = Vec::new();
    for (rate_hz, gap_s) in [(100.0, 1.0), (100.0, 2.5), (50.0, 0.2), (50.0, 1.0), (50.0, 2.5), (1000.0, 2.5)]
    {
        let mut simulator = Simulator::new(&Options::default()).unwrap();
        let (mut time_s, mut worst_m): (f64, f64) = (0.0, 0.0);
        for k in 0..2000 {
            time_s += if k == 500 { gap_s } else { 1.0 / rate_hz };
            let mut sample = FlightSample { v_n: None, ..resting_sample(time_s) };
            let longitude_deg = 100.0 * time_s / 4.9e6 / DEG;
            sample.place.longitude_rad = (longitude_deg * 1e7).round() / 1e7 * DEG;
            sample.place.height_m = ((1000.0 + 0.1 * time_s) * 100.0).round() / 100.0;
            simulator.push_sample(&sample).unwrap();
            simulator.step().unwrap();
            if k > 0 {
                let (_, errors) = simulator.errors(ErrorSource::Navigation).unwrap().unwrap();
                worst_m = worst_m.max(errors.position_n.norm());
            }
        }
        let intervals = gap_s * rate_hz;
        let bound_m = half_step_m * (3.0 + (6.7 * 6.7 + 2.0 * 6.7) * intervals * intervals / 12.0);
        assert!(worst_m < bound_m, "{worst_m} {bound_m}");
        figures.push(format!("{gap_s} s at {rate_hz} Hz {worst_m:.1} m (limit {bound_m:.0} m)"));
    }
    println!("figure: {}", figures.join("; "));
}

/// Positions alone: a leap is refused, whether by 11 m at 100 Hz or by more; a high speed is not, 8 km/s like 5 m/s.
#[test]
fn without_velocities_leaps_are_refused_and_speed_is_none() {
    let with_step = |speed_m_s: f64, rate_hz: f64, leap_m: f64, leaps_at: u32| -> Result<f64, Error> {
        let mut simulator =
            Simulator::new(&Options { vertical: VerticalMode::FollowTruth, ..Default::default() }).unwrap();
        for k in 0..20 {
            let mut sample = FlightSample { v_n: None, ..resting_sample(f64::from(k) / rate_hz) };
            let way_m = speed_m_s * sample.time_s + if k >= leaps_at { leap_m } else { 0.0 };
            // Along the equator, a circle.
            sample.place = Geodetic { latitude_rad: 0.0, longitude_rad: way_m / 6_378_137.0, height_m: 0.0 };
            simulator.push_sample(&sample)?;
            simulator.step().unwrap();
        }
        Ok(simulator.truth().unwrap().unwrap().navigation.v_n.x)
    };
    let (mut least_m, mut least_hz) = (f64::MAX, 0.0);
    for rate_hz in [1.0, 10.0, 100.0] {
        for speed in [0.0, 5.0, 250.0, 8000.0] {
            let found = with_step(speed, rate_hz, 0.0, 0).unwrap();
            // The cubic's own error on a circle, and 1 nm over an interval.
            assert!((found - speed).abs() < 1e-6 * speed + 7e-9 * rate_hz, "{found} {speed}");
            // The path that 2000 m/s² makes in the time, up to three intervals in the mean velocity, is not a leap.
            let slack_m = 10.0 + 3000.0 / (rate_hz * rate_hz);
            for leaps_at in [2, 3, 4, 10] {
                for leap_m in [1.1 * slack_m, 20.0 * slack_m, -1.1 * slack_m] {
                    let error = with_step(speed, rate_hz, leap_m, leaps_at).unwrap_err();
                    assert_eq!(error.kind, ErrorKind::Discontinuity, "{error}");
                    if leap_m.abs() < least_m {
                        (least_m, least_hz) = (leap_m.abs(), rate_hz);
                    }
                }
            }
        }
        // A speed beyond the limit is refused, from the first interval on.
        assert_eq!(with_step(21e3, rate_hz, 0.0, 0).unwrap_err().kind, ErrorKind::Discontinuity);
    }
    println!("figure: {least_m:.0} m at {least_hz} Hz");
}
