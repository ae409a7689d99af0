//! Parameters that are asked for: lever arm, g-sensitivity and asymmetry, beside the others.

use nalgebra::{Matrix3, Vector3};
use sins::analysis::identify::check::{CheckRequest, Truth, check, identify_first_half};
use sins::analysis::identify::{Also, Estimate, Identified, Prior, Request, identify, listed};
use sins::sensors::{Grade, TriadParameters};
use sins::{Error, Options};

use super::{Coverage, DEG, Draws, G, RATE_HZ, Unit, drawn, flight, in_block_axes, normal, path, times};

const ALL: Also = Also { lever_arm: true, g_sensitivity: true, asymmetry: true };
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
        let asked = || listed(&one).into_iter().skip(47);
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
    assert!(list.len() == 65 && list[..47].iter().all(|one| one.reason.as_deref() != Some("not asked for")));
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
