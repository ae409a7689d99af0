//! Parameters that are asked for: lever arm, g-sensitivity, asymmetry and temperature, beside the others.

use nalgebra::{Matrix3, Vector3};
use sins::analysis::identify::check::{CheckRequest, Truth, check, identify_first_half};
use sins::analysis::identify::{Also, Estimate, IdealPath, Identified, Prior, Request, identify, listed};
use sins::sensors::{Grade, TriadParameters};
use sins::truth::FlightSample;
use sins::truth::flight::Flight;
use sins::{Error, Options};

use super::{
    Coverage, DEG, Draws, G, RATE_HZ, Unit, drawn, flight, in_block_axes, normal, path, temperature_c, times,
};

const ALL: Also = Also { lever_arm: true, g_sensitivity: true, asymmetry: true, temperature: false };
const WARM: Also = Also { lever_arm: false, g_sensitivity: false, asymmetry: false, temperature: true };
const TRIALS: u64 = if cfg!(feature = "long-tests") { 48 } else { 16 };

/// Sensors of industrial grade with errors of all kinds.
fn unit(draws: &mut Draws, prior: &Prior, run: u64) -> Unit {
    let mut gyro =
        drawn(draws, prior.gyro_bias, prior.gyro_scale_factor, prior.gyro_misalignment, 0.15 * DEG / 60.0);
    let mut accel =
        drawn(draws, prior.accel_bias, prior.accel_scale_factor, prior.accel_misalignment, 100e-6 * G);
    gyro.g_sensitivity = Matrix3::from_fn(|_, _| prior.g_sensitivity * normal(draws));
    gyro.scale_factor_asymmetry = Vector3::from_fn(|_, _| prior.gyro_asymmetry * normal(draws));
    accel.scale_factor_asymmetry = Vector3::from_fn(|_, _| prior.accel_asymmetry * normal(draws));
    let lever_b = Vector3::from_fn(|_, _| 0.3 * normal(draws));
    Unit { gyro, accel, lever_b, behind_s: draws.within(-0.08, 0.08), run, ..Default::default() }
}

fn request(prior: Prior, also: Also) -> Request {
    Request { prior, also, ..Default::default() }
}

/// The intervals hold, those of the other parameters too, and most parameters are seen. What an increment has beside all that was found
/// is its noise.
#[test]
fn what_is_asked_for_is_found() {
    let (aerobatics, span_s) = (flight("aerobatics"), (0.0, 400.0));
    let along = path(&aerobatics, span_s);
    let prior = Prior::of(Grade::Industrial);
    let mut draws = Draws::new(17);
    let kinds = ["lever arm", "g-sensitivity", "asymmetry", "bias", "scale factor"];
    let mut found: [Coverage; 5] = Default::default();
    let (mut seen, mut of) = (0, 0);
    for run in 0..TRIALS {
        let unit = unit(&mut draws, &prior, run);
        let record = unit.record(&aerobatics, span_s);
        let one =
            identify(&along, &record, &request(prior, ALL)).unwrap_or_else(|error| panic!("{run}: {error}"));
        // Of another rotation, the axes of the block have those of the misalignments that both triads have in common.
        let (errors, _) = in_block_axes(&unit, Vector3::zeros());
        let of_vehicle = one.rotation.transpose();
        let matrix = Matrix3::from_fn(|row, column| one.g_sensitivity[row][column].value) * one.rotation;
        let lever_b = of_vehicle * Vector3::from(one.lever_arm.map(|part| part.value));
        for axis in 0..3 {
            found[0].add(&Estimate { value: lever_b[axis], ..one.lever_arm[axis] }, unit.lever_b[axis]);
            for column in 0..3 {
                let turned = Estimate { value: matrix[(axis, column)], ..one.g_sensitivity[axis][column] };
                found[1].add(&turned, unit.gyro.g_sensitivity[(axis, column)]);
            }
            let parts = [(&one.gyro, &unit.gyro), (&one.accel, &unit.accel)];
            for ((triad, truth), error) in parts.into_iter().zip(&errors) {
                found[2].add(&triad.asymmetry[axis], truth.scale_factor_asymmetry[axis]);
                found[3].add(&triad.bias[axis], truth.bias[axis]);
                found[4].add(&triad.elements[axis][axis], error[(axis, axis)]);
            }
        }
        let asked = || listed(&one).into_iter().skip(47).filter(|one| !one.name.contains("temperature"));
        (seen, of) = (seen + asked().filter(|one| one.reason.is_none()).count(), of + asked().count());
        let of_sensors = one.path_of_sensors(along.clone()).unwrap();
        let rests: Vec<Vector3<f64>> =
            record.iter().filter_map(|row| Some(one.residual(&of_sensors, row)?.velocity)).collect();
        // Differences have little of the slow noise.
        let square: f64 = rests.windows(2).map(|two| (two[1] - two[0]).norm_squared() / 6.0).sum();
        let white = square / (rests.len() - 1) as f64 / (unit.accel.random_walk.x.powi(2) / RATE_HZ);
        assert!((0.9..1.6).contains(&white), "{run}: {white}");
    }
    for (name, kind) in kinds.iter().zip(&found) {
        println!("{name}: {:.1} % of {} intervals hold", 100.0 * kind.held / kind.of, kind.of);
    }
    println!("{seen} of {of} are seen");
    for (name, kind) in kinds.iter().zip(&found) {
        assert!((0.85..=1.0).contains(&(kind.held / kind.of)), "{name}");
    }
    let all = found.iter().fold((0.0, 0.0), |sum, kind| (sum.0 + kind.held, sum.1 + kind.of));
    println!("all: {:.1} %", 100.0 * all.0 / all.1);
    assert!((0.88..=0.98).contains(&(all.0 / all.1)), "{}", all.0 / all.1);
    assert!(seen * 10 > of * 8, "{seen} of {of}");
}

/// Without being asked for they are listed as such, and nothing of the fit has them.
#[test]
fn what_is_not_asked_for_is_said_so() {
    let aerobatics = flight("aerobatics");
    let (along, record) =
        (path(&aerobatics, (0.0, 200.0)), Unit::default().record(&aerobatics, (0.0, 200.0)));
    let of = |also: Also| identify(&along, &record, &request(Prior::default(), also)).unwrap();
    let none = of(Also::default());
    let list = listed(&none);
    assert!(list.len() == 71 && list[..47].iter().all(|one| one.reason.as_deref() != Some("not asked for")));
    for one in &list[47..] {
        assert_eq!(
            (one.value, one.sigmas, one.reason.as_deref()),
            (0.0, (0.0, 0.0), Some("not asked for")),
            "{one:?}"
        );
    }
    let one = of(Also { g_sensitivity: true, ..Also::default() });
    assert!(one.g_sensitivity.iter().flatten().all(Estimate::is_seen));
    assert_eq!((one.lever_arm, one.accel.asymmetry), Default::default());
    // The rest is told as before, a little less well.
    let sigmas =
        |of: &Identified| [of.gyro.bias[0].sigma, of.accel.bias[0].sigma, of.gyro.elements[0][1].sigma];
    for (with, without) in sigmas(&one).into_iter().zip(sigmas(&none)) {
        assert!((0.95..3.0).contains(&(with / without)), "{with} {without}");
    }
}

/// The errors are removed from the other half of the record, and twins have them. A lever arm is refused.
#[test]
fn sensors_with_them_are_checked() {
    let (aerobatics, span_s) = (flight("aerobatics"), (0.0, 400.0));
    let truth =
        Truth::fly(&Options::default(), times(span_s).map(|time_s| aerobatics.sample_at(time_s))).unwrap();
    let sensing = TriadParameters {
        g_sensitivity: Matrix3::from_element(2e-5),
        scale_factor_asymmetry: Vector3::repeat(2e-3),
        ..Unit::default().gyro
    };
    let record = Unit { gyro: sensing, ..Unit::default() }.record(&aerobatics, span_s);
    let drift_m = |also: Also| {
        let (found, other) = identify_first_half(&truth, &record, &request(Prior::default(), also))?;
        let found = check(&truth, &found, other, &CheckRequest { twins: 40, ..Default::default() })?;
        let span = found.spans.last().unwrap();
        println!("{also:?}: {:?}, {:.2} m for {:.2} m", found.agreement, span.real_m, span.predicted_m);
        Ok::<_, Error>((found.agreement, span.real_m))
    };
    let asked = Also { lever_arm: false, ..ALL };
    let ((agreement, with_m), (_, without_m)) = (drift_m(asked).unwrap(), drift_m(Also::default()).unwrap());
    assert_eq!(agreement, sins::analysis::identify::check::Agreement::Agrees);
    assert!(with_m < 0.5 * without_m, "{with_m} {without_m}");
    let refused = drift_m(ALL).unwrap_err().to_string();
    assert!(refused.starts_with("request.also.lever_arm"), "{refused}");
}

/// The samples of a flight with a temperature.
fn warm(
    flight: &Flight,
    span_s: (f64, f64),
    warmth: fn(f64) -> f64,
) -> impl Iterator<Item = Result<FlightSample, Error>> {
    times(span_s).map(move |time_s| {
        Ok(FlightSample { temperature_c: Some(warmth(time_s)), ..flight.sample_at(time_s)? })
    })
}

/// Biases hold at the mean temperature of the record; the intervals of both hold, and those of the changes are seen.
#[test]
fn changes_of_biases_with_temperature_are_found() {
    let (aerobatics, span_s) = (flight("aerobatics"), (0.0, 400.0));
    let along = IdealPath::fly(&Options::default(), warm(&aerobatics, span_s, temperature_c)).unwrap();
    let prior = Prior::of(Grade::Industrial);
    let mut draws = Draws::new(18);
    let (mut changes, mut biases) = (Coverage::default(), Coverage::default());
    for run in 0..TRIALS {
        let unit = unit(&mut draws, &prior, run);
        let warming = |draws: &mut Draws, triad: &TriadParameters, size: f64| TriadParameters {
            bias_temperature: Vector3::from_fn(|_, _| size * normal(draws)),
            reference_temperature_c: 25.0,
            bias: triad.bias,
            random_walk: triad.random_walk,
            flicker: triad.flicker,
            rate_random_walk: triad.rate_random_walk,
            ..Default::default()
        };
        let gyro = warming(&mut draws, &unit.gyro, prior.gyro_bias_temperature);
        let accel = warming(&mut draws, &unit.accel, prior.accel_bias_temperature);
        let unit = Unit { gyro, accel, warms: true, behind_s: unit.behind_s, run, ..Default::default() };
        let record = unit.record(&aerobatics, span_s);
        let one =
            identify(&along, &record, &request(prior, WARM)).unwrap_or_else(|error| panic!("{run}: {error}"));
        let reference_c = one.reference_c.unwrap();
        assert!((reference_c - 30.0).abs() < 0.1, "{reference_c}");
        for (triad, truth) in [(&one.gyro, &unit.gyro), (&one.accel, &unit.accel)] {
            for axis in 0..3 {
                let change = truth.bias_temperature[axis];
                assert!(triad.bias_temperature[axis].is_seen(), "{run}: {:?}", triad.bias_temperature[axis]);
                changes.add(&triad.bias_temperature[axis], change);
                biases.add(&triad.bias[axis], truth.bias[axis] + change * (reference_c - 25.0));
            }
        }
    }
    for (name, kind) in [("changes", &changes), ("biases", &biases)] {
        println!("{name}: {:.1} % of {} intervals hold", 100.0 * kind.held / kind.of, kind.of);
        assert!((0.88..=0.99).contains(&(kind.held / kind.of)), "{name}");
    }
}

/// A block at rest that warms up by 20 K, as in a chamber, whose gyros drift by much more than their noise: it has no other motion.
#[test]
fn a_block_that_warms_up_at_rest_is_at_rest() {
    let (rest, span_s) = (flight("rest"), (0.0, 400.0));
    let along = IdealPath::fly(&Options::default(), warm(&rest, span_s, temperature_c)).unwrap();
    let drifts = Vector3::new(3e-4, -1e-4, 2e-5);
    let gyro = TriadParameters { bias_temperature: drifts, ..Unit::default().gyro };
    let record = Unit { gyro, warms: true, ..Unit::default() }.record(&rest, span_s);
    let one = identify(&along, &record, &request(Prior::default(), WARM)).unwrap();
    for axis in 0..3 {
        let Estimate { value, sigma, .. } = one.gyro.bias_temperature[axis];
        assert!((value - drifts[axis]).abs() < 4.0 * sigma && sigma < 1e-5, "{axis}: {value} {sigma}");
    }
}

/// A steady temperature shows no change of a bias, and a path without one is refused.
#[test]
fn a_steady_temperature_tells_no_change() {
    let (aerobatics, span_s) = (flight("aerobatics"), (0.0, 200.0));
    let record = Unit { warms: true, ..Default::default() }.record(&aerobatics, span_s);
    let steady = IdealPath::fly(&Options::default(), warm(&aerobatics, span_s, |_| 30.0)).unwrap();
    let one = identify(&steady, &record, &request(Prior::default(), WARM)).unwrap();
    assert!((one.reference_c.unwrap() - 30.0).abs() < 1e-9);
    assert!(!one.gyro.bias_temperature.iter().chain(&one.accel.bias_temperature).any(Estimate::is_seen));
    assert!(one.gyro.bias.iter().all(Estimate::is_seen));
    let error = identify(&path(&aerobatics, span_s), &record, &request(Prior::default(), WARM)).unwrap_err();
    assert_eq!(error.to_string(), "request.also.temperature: needs samples of the path with a temperature");
}

/// What is left of a record has no change with temperature. The other half of it is warmer: its biases are those of its temperature, and
/// twins have them too.
#[test]
fn a_warmer_half_is_checked() {
    let (aerobatics, span_s) = (flight("aerobatics"), (0.0, 400.0));
    let truth = Truth::fly(&Options::default(), warm(&aerobatics, span_s, temperature_c)).unwrap();
    let gyro = TriadParameters { bias_temperature: Vector3::repeat(2e-5), ..Unit::default().gyro };
    let record = Unit { gyro, warms: true, ..Unit::default() }.record(&aerobatics, span_s);
    let checked = |also: Also| {
        let (found, other) = identify_first_half(&truth, &record, &request(Prior::default(), also)).unwrap();
        let found = check(&truth, &found, other, &CheckRequest { twins: 40, ..Default::default() }).unwrap();
        let span = *found.spans.last().unwrap();
        println!("{also:?}: {:?}, {:.2} m for {:.2} m", found.agreement, span.real_m, span.predicted_m);
        (found.agreement, span.real_m, span.predicted_m)
    };
    let ((agreement, with_m, predicted_m), (_, without_m, _)) = (checked(WARM), checked(Also::default()));
    assert_eq!(agreement, sins::analysis::identify::check::Agreement::Agrees);
    assert!(with_m < 0.5 * without_m && predicted_m < without_m, "{with_m} {without_m}");
    let one = identify(truth.path(), &record, &request(Prior::default(), WARM)).unwrap();
    let rests: Vec<Vector3<f64>> = record
        .iter()
        .filter_map(|row| Some(one.residual(truth.path(), row)?.angle / row.interval_s))
        .collect();
    let mean = |rows: &[Vector3<f64>]| rows.iter().sum::<Vector3<f64>>() / rows.len() as f64;
    let quarter = rests.len() / 4;
    let change = mean(&rests[3 * quarter..]) - mean(&rests[..quarter]);
    let warmed = 15.0 * 2e-5;
    assert!(change.amax() < 0.1 * warmed, "{change}");
}
