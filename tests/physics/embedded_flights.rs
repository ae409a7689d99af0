//! Embedded flights: the requested geometry, and samples that are consistent with each other.

use nalgebra::Vector3;
use sins::earth::Earth;
use sins::truth::FlightSample;
use sins::truth::flight::{Channel, Flight, FlightStart, Manoeuvre, Sinusoid, Sinusoids};

use crate::support::{DEG, G, patrol};

fn start() -> FlightStart {
    FlightStart {
        latitude_rad: 48.0 * DEG,
        longitude_rad: 0.2,
        height_m: 1000.0,
        speed_m_s: 150.0,
        heading_rad: 30.0 * DEG,
        ..Default::default()
    }
}

fn every_manoeuvre() -> Vec<Manoeuvre> {
    let none = Sinusoid { channel: Channel::Roll, amplitude: 0.01, frequency_hz: 1.0, phase_rad: 0.3 };
    let terms = [
        none,
        Sinusoid { channel: Channel::Pitch, phase_rad: 1.8, ..none },
        Sinusoid { channel: Channel::Course, amplitude: 0.2, frequency_hz: 0.05, phase_rad: 0.0 },
        Sinusoid { channel: Channel::Speed, amplitude: 2.0, frequency_hz: 0.2, phase_rad: 0.0 },
        Sinusoid { channel: Channel::Climb, amplitude: 0.02, frequency_hz: 0.1, phase_rad: 0.0 },
    ];
    vec![
        Manoeuvre::Straight { duration_s: 20.0 },
        Manoeuvre::Accelerate { duration_s: 30.0, speed_change_m_s: 50.0 },
        Manoeuvre::Climb { duration_s: 60.0, height_change_m: 800.0, ramp_s: 10.0 },
        Manoeuvre::Turn { heading_change_rad: -120.0 * DEG, bank_rad: 40.0 * DEG, ramp_s: 4.0 },
        Manoeuvre::Roll { duration_s: 6.0, turns: 1.0 },
        Manoeuvre::Loop { duration_s: 25.0, turns: 1.0, ramp_s: 5.0 },
        Manoeuvre::STurn { duration_s: 60.0, heading_change_rad: 0.5, turns: 2.0, ramp_s: 8.0 },
        Manoeuvre::Sinusoids { duration_s: 40.0, ramp_s: 5.0, sinusoids: Sinusoids::of(&terms) },
        Manoeuvre::Accelerate { duration_s: 60.0, speed_change_m_s: -200.0 },
        Manoeuvre::Rest { duration_s: 10.0 },
    ]
}

fn position(flight: &Flight, time_s: f64) -> Vector3<f64> {
    Earth::default().to_earth_fixed(&flight.sample_at(time_s).unwrap().place)
}

fn velocity(flight: &Flight, time_s: f64) -> Vector3<f64> {
    let sample = flight.sample_at(time_s).unwrap();
    let (east, north, up) = Earth::default().east_north_up(&sample.place);
    let v = sample.v_n.unwrap();
    east * v.x + north * v.y + up * v.z
}

/// Displacement is the integral of velocity, over any interval: Gauss's rule of five nodes against the positions.
#[test]
fn position_is_the_integral_of_velocity() {
    let flight = Flight::new(&start(), &every_manoeuvre()).unwrap();
    let nodes = [
        (0.046_910_077_030_668, 0.118_463_442_528_094_5),
        (0.230_765_344_947_158_5, 0.239_314_335_249_683_2),
        (0.5, 0.284_444_444_444_444_4),
        (0.769_234_655_052_841_5, 0.239_314_335_249_683_2),
        (0.953_089_922_969_332, 0.118_463_442_528_094_5),
    ];
    let step = 0.05;
    let mut time = 0.0;
    while time + step < flight.duration_s() {
        let integral: Vector3<f64> =
            nodes.iter().map(|(u, weight)| velocity(&flight, time + u * step) * (weight * step)).sum();
        let difference = position(&flight, time + step) - position(&flight, time) - integral;
        // Earth-fixed coordinates are rounded to 1 nm; four roundings meet here.
        assert!(difference.norm() < 8e-9, "{time}: {:e}", difference.norm());
        time += step;
    }
}

/// Accelerations do not jump: the second difference of velocity over a short step is that of a smooth function, also at the
/// joints of manoeuvres.
#[test]
fn acceleration_and_attitude_are_continuous() {
    let flight = Flight::new(&start(), &every_manoeuvre()).unwrap();
    let step = 1e-3;
    let mut time = step;
    while time + step < flight.duration_s() {
        let [before, now, after] = [-step, 0.0, step].map(|d| velocity(&flight, time + d));
        let jump = (before + after - 2.0 * now).norm() / step;
        // A jerk of at most 40 m/s³ over 1 ms, and the rounding of 200 m/s.
        assert!(jump < 0.05, "{time}: {jump} m/s² between two milliseconds");
        let [a, b] = [0.0, step].map(|d| flight.sample_at(time + d).unwrap().euler);
        let turn = sins::math::relative_rotation(
            &sins::math::attitude_from_euler(&a),
            &sins::math::attitude_from_euler(&b),
        );
        assert!(sins::math::rotation_vector(&turn).norm() < 3.0 * step, "{time}");
        time += 0.037;
    }
}

/// One and a half circles at 30° of bank have the radius v²/(g tan φ).
#[test]
fn a_turn_has_the_radius_of_its_bank() {
    let bank = 30.0 * DEG;
    let turn = Manoeuvre::Turn { heading_change_rad: 540.0 * DEG, bank_rad: bank, ramp_s: 5.0 };
    let flight = Flight::new(&start(), &[turn]).unwrap();
    let rate = G * bank.tan() / 150.0;
    assert!((flight.duration_s() - (540.0 * DEG / rate + 5.0)).abs() < 1e-9);
    // Over half a turn in the middle the chord is a diameter.
    let middle = 0.5 * flight.duration_s();
    let half = 0.5 * std::f64::consts::PI / rate;
    let chord = (position(&flight, middle + half) - position(&flight, middle - half)).norm();
    // The height over the ellipsoid is 1 km; the Earth curves away from the plane by 1e-7 of the chord.
    assert!((chord / (2.0 * 150.0 / rate) - 1.0).abs() < 1e-6, "{chord}");
    let sample = flight.sample_at(middle).unwrap();
    assert!((sample.euler.roll - bank).abs() < 1e-12, "right turn, right wing down");
    assert!((sample.place.height_m - 1000.0).abs() < 1e-9);
}

#[test]
fn a_loop_is_round_and_comes_back() {
    let looping = Manoeuvre::Loop { duration_s: 40.0, turns: 1.0, ramp_s: 8.0 };
    let flight = Flight::new(&start(), &[looping]).unwrap();
    let rate = std::f64::consts::TAU / 32.0;
    let heights: Vec<f64> =
        (0..=400).map(|k| flight.sample_at(f64::from(k) / 10.0).unwrap().place.height_m).collect();
    let top = heights.iter().cloned().fold(f64::MIN, f64::max);
    // Between the ramps the loop is a circle of radius v / rate; in the ramps it is wider.
    let diameter = 2.0 * 150.0 / rate;
    assert!(top - 1000.0 > diameter && top - 1000.0 < 1.3 * diameter, "{top} {diameter}");
    assert!((heights[400] - 1000.0).abs() < 1.0, "{}", heights[400]);
    let upside_down = flight.sample_at(20.0).unwrap();
    assert!((upside_down.euler.roll.abs() - std::f64::consts::PI).abs() < 1e-6, "{:?}", upside_down.euler);
}

#[test]
fn climbs_speeds_and_courses_are_the_ones_asked_for() {
    let flight = Flight::new(&start(), &every_manoeuvre()).unwrap();
    let at = |time: f64| flight.sample_at(time).unwrap();
    assert!((at(50.0).v_n.unwrap().norm() - 200.0).abs() < 1e-11);
    assert!((at(110.0).place.height_m - 1800.0).abs() < 1e-6, "{}", at(110.0).place.height_m);
    let turned = at(110.0 + 120.0 * DEG / (G * (40.0 * DEG).tan() / 200.0) + 4.0);
    // Meridians converge on the way: a degree of longitude is 0.74° of course at 48°.
    assert!((turned.euler.heading / DEG - 270.0).abs() < 0.2, "{}", turned.euler.heading / DEG);
    let end = at(flight.duration_s());
    assert_eq!(end.v_n.unwrap().norm(), 0.0);
    assert_eq!(at(flight.duration_s() - 5.0).place, end.place, "at rest");
}

/// Straight flight is a geodesic: from 60° N, course 90°, the highest latitude of the great circle is at its start, and half
/// way round it is 60° S.
#[test]
fn straight_flight_is_a_geodesic() {
    let start = FlightStart {
        latitude_rad: 60.0 * DEG,
        heading_rad: 90.0 * DEG,
        speed_m_s: 250.0,
        ..Default::default()
    };
    let flight = Flight::new(&start, &[Manoeuvre::Straight { duration_s: 80_100.0 }]).unwrap();
    let lowest = (0..8010)
        .map(|k| flight.sample_at(f64::from(k) * 10.0).unwrap().place.latitude_rad)
        .fold(f64::MAX, f64::min);
    // By symmetry of the ellipsoid exactly 60° S; between two samples it is lower by less than 1e-7.
    assert!((lowest + 60.0 * DEG).abs() < 1e-6, "{}", lowest / DEG);
}

/// The patrol over 48 h keeps its accuracy at any time, and in any order of calls.
#[test]
fn a_long_patrol_is_exact_at_any_time() {
    let flight = patrol(48.0 * 3600.0);
    let late = flight.sample_at(172_000.123).unwrap();
    flight.sample_at(1.0).unwrap();
    assert_eq!(flight.sample_at(172_000.123).unwrap(), late);
    let integral =
        (0..10).map(|k| velocity(&flight, 172_000.05 + 0.1 * f64::from(k)) * 0.1).sum::<Vector3<f64>>();
    let moved = position(&flight, 172_001.0) - position(&flight, 172_000.0);
    // Midpoint rule over 0.1 s: h²/24 of the jerk, 1 m/s³, times a second.
    assert!((moved - integral).norm() < 1e-3);
}

#[test]
fn bad_manoeuvres_are_refused_with_their_index() {
    let stop = Manoeuvre::Accelerate { duration_s: 10.0, speed_change_m_s: -150.0 };
    for (manoeuvres, field, index) in [
        (
            vec![Manoeuvre::Straight { duration_s: 1.0 }, Manoeuvre::Straight { duration_s: -1.0 }],
            "manoeuvre.duration_s",
            1,
        ),
        (vec![Manoeuvre::Rest { duration_s: 1.0 }], "speed_m_s", 0),
        (vec![stop, Manoeuvre::Turn { heading_change_rad: 1.0, bank_rad: 0.5, ramp_s: 1.0 }], "speed_m_s", 1),
        (
            vec![Manoeuvre::Accelerate { duration_s: 1.0, speed_change_m_s: -151.0 }],
            "manoeuvre.speed_change_m_s",
            0,
        ),
        (vec![Manoeuvre::Roll { duration_s: 1.0, turns: 0.5 }], "manoeuvre.turns", 0),
        (
            vec![Manoeuvre::Climb { duration_s: 10.0, height_change_m: 1500.0, ramp_s: 1.0 }],
            "manoeuvre.height_change_m",
            0,
        ),
        (
            vec![Manoeuvre::Turn { heading_change_rad: f64::NAN, bank_rad: 0.5, ramp_s: 1.0 }],
            "manoeuvre.heading_change_rad",
            0,
        ),
    ] {
        let error = Flight::new(&start(), &manoeuvres).unwrap_err();
        assert_eq!((error.field, error.index), (field, Some(index)), "{error}");
    }
    assert!(Flight::new(&start(), &[]).is_err());
    let flight = Flight::new(&start(), &[Manoeuvre::Straight { duration_s: 1.0 }]).unwrap();
    assert!(
        flight.sample_at(-0.1).is_err()
            && flight.sample_at(1.1).is_err()
            && flight.sample_at(f64::NAN).is_err()
    );
}

/// No simulator takes a flight that leaves the heights allowed for samples. It is refused with the manoeuvre; up to the limit
/// it is flown. A swing of the climb angle by A about 0 at the speed v and the frequency f rises in a half swing by v/(2π f)
/// times the integral of sin(A sin x) from 0 to π: 2 (A - A³/9) and less than A⁵/100 more.
#[test]
fn heights_that_no_sample_may_have_are_refused_with_their_manoeuvre() {
    let (low_m, high_m) = FlightSample::HEIGHT_RANGE_M;
    let climb = |from_m: f64, height_change_m: f64| {
        let start = FlightStart { height_m: from_m, speed_m_s: 9000.0, ..start() };
        let climb = Manoeuvre::Climb { duration_s: 5000.0, height_change_m, ramp_s: 50.0 };
        Flight::new(&start, &[Manoeuvre::Straight { duration_s: 10.0 }, climb])
    };
    for (from_m, change_m) in [(high_m - 1e5, 1e5 + 1.0), (low_m + 1e4, -1e4 - 1.0), (0.0, 1e7), (0.0, -1e7)]
    {
        let error = climb(from_m, change_m).unwrap_err();
        assert_eq!((error.field, error.index), ("height reached in manoeuvre", Some(1)), "{error}");
        assert!(error.to_string().ends_with(": must be from -20000 to 2000000"), "{error}");
        let (reached_m, end_m) = (error.value.unwrap().as_f64(), from_m + change_m);
        // The end of the climb, or of its first piece that exceeds the limit.
        assert!(reached_m.abs() <= end_m.abs() + 1e-6, "{error}");
        assert!(change_m.abs() == 1e7 || (reached_m - end_m).abs() < 1e-6, "{error}");
    }
    for (from_m, change_m) in [(high_m - 1e5, 1e5 - 1.0), (low_m + 1e4, -1e4 + 1.0)] {
        let flight = climb(from_m, change_m).unwrap();
        assert_eq!(flight.sample_at(flight.duration_s()).unwrap().validate(), Ok(()));
    }

    let (amplitude, frequency_hz) = (0.1, 1e-3);
    let term = Sinusoid { channel: Channel::Climb, amplitude, frequency_hz, phase_rad: 0.0 };
    let manoeuvre =
        Manoeuvre::Sinusoids { duration_s: 3000.0, ramp_s: 1e-3, sinusoids: Sinusoids::of(&[term]) };
    let speed_m_s = 1000.0;
    let swing_m =
        speed_m_s / (std::f64::consts::TAU * frequency_hz) * 2.0 * (amplitude - amplitude.powi(3) / 9.0);
    let rounding_m = swing_m * amplitude.powi(4) / 100.0 + 1e-3 * speed_m_s;
    for (margin_m, is_flown) in [(rounding_m, true), (-rounding_m, false)] {
        let start = FlightStart { height_m: high_m - swing_m - margin_m, speed_m_s, ..start() };
        let flight = Flight::new(&start, &[manoeuvre]);
        assert_eq!(flight.is_ok(), is_flown, "{margin_m} m below the limit: {:?}", flight.err());
    }
}
