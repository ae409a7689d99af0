//! Records that cannot be identified: each is named with its cause.

use sins::signal::Increment;

use super::*;

/// What `identify` says of a record along aerobatics whose rows are changed.
fn refused(change: impl Fn(usize, &mut RecordedIncrement)) -> String {
    let aerobatics = flight("aerobatics");
    let mut record = Unit::default().record(&aerobatics, MINUTES);
    record.iter_mut().enumerate().for_each(|(row, one)| change(row, one));
    let answer = identify(&path(&aerobatics, MINUTES), &record, &Request::default());
    answer.err().map_or("accepted".to_owned(), |error| error.to_string())
}

/// What makes a record unfit is named, with its size.
#[test]
fn a_record_that_does_not_fit_is_named() {
    let aerobatics = flight("aerobatics");
    let path = path(&aerobatics, MINUTES);
    let record = Unit::default().record(&aerobatics, MINUTES);
    let refused = |record: &[RecordedIncrement]| {
        identify(&path, record, &Request::default())
            .err()
            .map_or("accepted".to_owned(), |error| error.to_string())
    };
    assert_eq!(refused(&record), "accepted");
    let changed = |change: &dyn Fn(usize, &mut RecordedIncrement)| {
        let mut record = record.clone();
        record.iter_mut().enumerate().for_each(|(row, one)| change(row, one));
        record
    };
    let degrees = changed(&|_, one| one.increment.angle /= DEG);
    assert!(refused(&degrees).starts_with("record.angle = 57.2"), "{}", refused(&degrees));
    let in_g = changed(&|_, one| one.increment.velocity /= G);
    assert!(refused(&in_g).starts_with("record.velocity = 0.10"), "{}", refused(&in_g));
    let reversed = changed(&|_, one| one.increment.velocity *= -1.0);
    assert!(refused(&reversed).contains("opposite sign"), "{}", refused(&reversed));
    let other = Unit::default().record(&flight("commuter"), MINUTES);
    assert!(refused(&other).contains("of another motion"), "{}", refused(&other));
    let rest = Unit::default().record(&flight("rest"), MINUTES);
    assert!(refused(&rest).contains("of another motion"), "{}", refused(&rest));
}

/// The begin of the answer, and what is wrong with a row.
type Fault<'a> = (&'a str, &'a dyn Fn(usize, &mut RecordedIncrement));

/// The cause is named, and no other one.
#[test]
fn faults_of_sensors_and_clocks_are_named() {
    let faults: [Fault<'_>; 13] = [
        ("record.angle = 0.99", &|_, one| one.increment.angle.y *= -1.0),
        ("record.angle = 0.99", &|_, one| one.increment.angle *= -1.0),
        ("record.velocity = 0.99", &|_, one| one.increment.velocity.y *= -1.0),
        ("record.velocity = 0.99", &|_, one| one.increment.velocity.swap_rows(0, 1)),
        ("record.angle.z = 0: value of this sensor", &|_, one| one.increment.angle.z = 0.0),
        ("record.velocity.x = 5", &|_, one| one.increment.velocity.x = 5.0 * one.interval_s),
        ("record.angle.y = ", &|row, one| one.increment.angle.y += if row == 3000 { 30.0 } else { 0.0 }),
        ("gyro.scale_factor[2] = 0.3", &|_, one| one.increment.angle.z *= 1.3),
        ("record.drift = -0.00199", &|_, one| one.time_s *= 1.002),
        ("record.angle = 1000", &|_, one| one.increment.angle *= 1e3),
        ("record.velocity = 0.001", &|_, one| one.increment.velocity *= 1e-3),
        ("record.time_s = 86400", &|row, one| one.time_s += if row > 3000 { 86400.0 } else { 0.0 }),
        ("record.velocity.y = ", &|row, one| {
            one.increment.velocity.y += if row == 3000 { 30.0 } else { 0.0 }
        }),
    ];
    let answers: Vec<String> = faults.iter().map(|(_, change)| refused(change)).collect();
    for ((named, _), answer) in faults.iter().zip(&answers) {
        assert!(answer.starts_with(named), "{named}: {answers:#?}");
    }
    assert!(answers[..4].iter().all(|answer| answer.contains("left-handed axes")), "{answers:#?}");
    for spike in [6, 12] {
        assert!(answers[spike].contains("a spike. It is at [s] 120"), "{answers:#?}");
    }
    // Sensors that are worse than expected are found by a wider prior.
    let biased = |prior: Prior| {
        let aerobatics = flight("aerobatics");
        let gyro = TriadParameters { bias: Vector3::new(0.0, DEG, 0.0), ..Unit::default().gyro };
        let record = Unit { gyro, ..Default::default() }.record(&aerobatics, MINUTES);
        identify(&path(&aerobatics, MINUTES), &record, &Request { prior, ..Default::default() })
    };
    let error = biased(Prior::of(Grade::Tactical)).unwrap_err().to_string();
    assert!(error.starts_with("gyro.bias[1] = 0.017"), "{error}");
    assert!(biased(Prior::of(Grade::Consumer)).is_ok());
}

/// Of sensors without noise, as perfect ones of this library, no intervals can be found: the record is named.
#[test]
fn sensors_without_noise_are_named() {
    let flight = flight("aerobatics");
    let (gyro, accel) = (TriadParameters::default(), TriadParameters::default());
    let record = Unit { gyro, accel, ..Default::default() }.record(&flight, MINUTES);
    let error = identify(&path(&flight, MINUTES), &record, &Request::default()).unwrap_err().to_string();
    assert!(error.contains("as that of a sensor without noise"), "{error}");
}

/// A record of five minutes is found on the path of 16 hours if its shift is stated, also to some seconds.
#[test]
fn a_short_record_is_found_on_a_long_path() {
    let commuter = flight("commuter");
    let from_s = 300.0;
    let unit = Unit { behind_s: 1234.5, ..Default::default() };
    let record = unit.record(&commuter, (from_s, from_s + 300.0));
    // Behind the flight is rest.
    let mut path = path(&commuter, (0.0, 700.0));
    let still = sins::signal::Increment {
        velocity: Vector3::new(0.0, 0.0, G * 10.0),
        ..sins::signal::Increment::ZERO
    };
    for k in 1..5700 {
        path.push(700.0 + 10.0 * f64::from(k), 10.0, &still).unwrap();
    }
    for off_s in [0.0, 7.0] {
        let offset_s = Some(unit.behind_s + off_s);
        let one = identify(&path, &record, &Request { shift_s: offset_s, ..Default::default() }).unwrap();
        assert!((one.offset_s.value - unit.behind_s).abs() < 1e-3, "{off_s}: {:?}", one.offset_s);
    }
    let error = identify(&path, &record, &Request { shift_s: Some(1e6), ..Default::default() });
    assert_eq!(
        error.unwrap_err().to_string(),
        "request.shift_s = 1000000: leaves the path and the record no time in common"
    );
}

/// Forces that change sign have a small mean: their changes tell that all three are reversed, which is another fault than one sign.
#[test]
fn forces_of_both_signs_that_are_reversed_are_named() {
    let (mut path, mut record) = (IdealPath::default(), Vec::new());
    let interval_s = 0.02;
    let mut draws = Draws::new(3);
    for row in 1..6000_u32 {
        let time_s = interval_s * f64::from(row);
        let wave = |amplitude: f64, [x, y, z]: [f64; 3]| {
            amplitude * Vector3::new((x * time_s).sin(), (y * time_s).sin(), (z * time_s).sin())
        };
        let angle = wave(0.5 * interval_s, [0.7, 1.1, 1.7]);
        let velocity = wave(8.0 * interval_s, [0.9, 1.3, 0.53]);
        path.push(time_s, interval_s, &Increment { angle, velocity }).unwrap();
        let mut noise = |size: f64| Vector3::from_fn(|_, _| draws.within(-size, size));
        // The bias along the mean of the path's forces hides their sign.
        let velocity = velocity + noise(1e-3) + Vector3::repeat(-0.4 * interval_s);
        let increment = Increment { angle: angle + noise(1e-5), velocity };
        record.push(RecordedIncrement { time_s, interval_s, increment });
    }
    let said = |signs: [f64; 3]| {
        let mut record = record.clone();
        record.iter_mut().for_each(|row| row.increment.velocity.component_mul_assign(&Vector3::from(signs)));
        let answer = identify(&path, &record, &Request::default());
        answer.err().map_or("accepted".to_owned(), |error| error.to_string())
    };
    assert_eq!(said([1.0; 3]), "accepted");
    let reversed = said([-1.0; 3]);
    assert!(
        reversed.starts_with("record.velocity = -0.99") && reversed.contains("opposite sign"),
        "{reversed}"
    );
    let one = said([1.0, 1.0, -1.0]);
    assert!(one.starts_with("record.velocity = 0.99") && one.contains("left-handed axes"), "{one}");
}

/// A path whose positions are late against its attitude has other forces than the sensors measured. That is what is said, and no jump of a
/// clock and no bad sensor.
#[test]
fn forces_that_the_path_has_not_are_named() {
    let aerobatics = flight("aerobatics");
    let record = Unit::default().record(&aerobatics, MINUTES);
    let said = |late_s: f64| {
        let samples = times(MINUTES).map(|time_s| {
            let late = aerobatics.sample_at((time_s - late_s).max(MINUTES.0))?;
            Ok(FlightSample { place: late.place, v_n: late.v_n, ..aerobatics.sample_at(time_s)? })
        });
        let path = IdealPath::fly(&Options::default(), samples).unwrap();
        let answer = identify(&path, &record, &Request::default());
        answer.err().map_or("accepted".to_owned(), |error| error.to_string())
    };
    assert_eq!(said(0.0), "accepted");
    for late_s in [0.4, 0.7, 1.0] {
        let words = said(late_s);
        println!("positions {late_s} s late: {words}");
        assert!(words.starts_with("record.velocity."), "{words}");
        assert!(words.contains("at least 0.8 if the path has its forces"), "{words}");
    }
}

/// A path that was smoothed lacks fast motion, of which the sensors measured the forces. Compared below the cut-off, the biases are right.
#[test]
fn a_smoothed_path_is_compared_below_its_cutoff() {
    let aerobatics = flight("aerobatics");
    let biases = Vector3::new(5e-3, -3e-3, 4e-3) * G;
    let unit = Unit::default();
    let unit = Unit { accel: TriadParameters { bias: biases, ..unit.accel }, ..unit };
    let mut record = unit.record(&aerobatics, MINUTES);
    let mut draws = Draws::new(61);
    // Three shakes of each axis, between 1.3 and 6 Hz.
    let shakes: Vec<(f64, Vector3<f64>)> = (0..3)
        .map(|_| (1.3 + 4.7 * draws.unit(), Vector3::from_fn(|_, _| 6.0 * (draws.unit() - 0.5))))
        .collect();
    for row in &mut record {
        for (hz, size) in &shakes {
            row.increment.velocity += size * (std::f64::consts::TAU * hz * row.time_s).sin() * row.interval_s;
        }
    }
    let path = path(&aerobatics, MINUTES);
    let with = |cutoff_hz: Option<f64>| {
        let request = Request { prior: Prior::of(Grade::Industrial), cutoff_hz, ..Request::default() };
        identify(&path, &record, &request)
    };
    let whole = with(None).map(|found| found.accel.bias[0].sigma);
    let found = with(Some(0.45)).unwrap();
    for axis in 0..3 {
        let bias = found.accel.bias[axis];
        assert!(
            (bias.value - biases[axis]).abs() < 4.0 * bias.sigma,
            "{axis}: {bias:?}, not {}",
            biases[axis]
        );
        assert!(
            whole.as_ref().is_ok_and(|sigma| bias.sigma < 0.5 * sigma) || whole.is_err(),
            "{whole:?} {bias:?}"
        );
    }
    for (cutoff_hz, named) in [
        (0.0, "request.cutoff_hz = 0: must be from 0.001"),
        (f64::NAN, "request.cutoff_hz = NaN"),
        (0.1, "record.blocks = "),
    ] {
        let error = with(Some(cutoff_hz)).unwrap_err().to_string();
        assert!(error.starts_with(named), "{error}");
    }
}

/// What the model has not, and would take for misalignments: late accelerometers, and those of another place, are named with their size;
/// gyros that sense forces are told. Along the path of their place the sensors are found.
#[test]
fn what_is_beyond_the_model_is_named() {
    let aerobatics = flight("aerobatics");
    let (from_s, to_s) = (MINUTES.0 + 1.0, MINUTES.1);
    let along = path(&aerobatics, (from_s, to_s));
    let refused = |record: &[RecordedIncrement]| {
        let error = identify(&along, record, &Request::default()).unwrap_err();
        (error.field, error.value.unwrap().as_f64(), error.to_string())
    };
    let record = Unit::default().record(&aerobatics, (from_s, to_s));
    let of_gyros = identify(&along, &record, &Request::default()).unwrap();
    assert_eq!(of_gyros.left_g_sensitivity, None);
    for late_s in [0.004, -0.004] {
        let mut record = record.clone();
        let early = Unit::default().record(&aerobatics, (from_s - late_s, to_s - late_s));
        for (row, before) in record.iter_mut().zip(&early) {
            row.increment.velocity = before.increment.velocity;
        }
        let (field, found_s, said) = refused(&record);
        assert!(field == "record.velocity_delay_s" && (found_s / late_s - 1.0).abs() < 0.1, "{said}");
    }
    let lever_b = Vector3::new(0.2, 0.2, -0.1);
    let record = Unit { lever_b, ..Unit::default() }.record(&aerobatics, (from_s, to_s));
    let (field, found_m, said) = refused(&record);
    assert!(field == "record.lever_arm_m" && (found_m / 0.3 - 1.0).abs() < 0.1, "{said}");
    let of_place = identify(&along.clone().with_lever_arm(&lever_b).unwrap(), &record, &Request::default());
    let misalignment = &of_place.unwrap().accel.elements[2][0];
    assert!(misalignment.value.abs() < 4.0 * misalignment.sigma, "{misalignment:?}");
    let sensing = TriadParameters { g_sensitivity: Matrix3::identity() * 2e-5, ..Unit::default().gyro };
    let record = Unit { gyro: sensing, ..Unit::default() }.record(&aerobatics, (from_s, to_s));
    let size = identify(&along, &record, &Request::default()).unwrap().left_g_sensitivity.unwrap();
    assert!((size / 2e-5 - 1.0).abs() < 0.2, "{size}");
}
