//! The planned failures of a scene, in words and as times.

use sins::scene::{PlannedFailure, Scene};
use sins::sensors::{Axis, Failure, SensorOutput};

use crate::drawing::failures::Span;

/// Each failure with its time, numbered if there are several; "none" if there are no failures.
pub fn text(scene: &Scene) -> String {
    let numbered = |(number, planned)| format!("{number} {}", words(planned));
    match scene.failures.as_slice() {
        [] => "none".to_owned(),
        [planned] => words(planned),
        several => (1..).zip(several).map(numbered).collect::<Vec<String>>().join(", "),
    }
}

pub fn spans(scene: &Scene) -> Vec<Span> {
    let span = |planned: &PlannedFailure| {
        let until_s = planned.failing.until_s;
        (planned.failing.from_s, until_s.is_finite().then_some(until_s))
    };
    scene.failures.iter().map(span).collect()
}

fn words(planned: &PlannedFailure) -> String {
    let axis = |axis: Axis| match axis {
        Axis::X => "x",
        Axis::Y => "y",
        Axis::Z => "z",
    };
    let output = match planned.output {
        SensorOutput::Gyro(which) => format!("gyro {}", axis(which)),
        SensorOutput::Accelerometer(which) => format!("accelerometer {}", axis(which)),
        SensorOutput::Altimeter => "altimeter".to_owned(),
    };
    let kind = match planned.failure {
        Failure::Stuck => "stuck",
        Failure::Dead => "dead",
        Failure::BiasStep { .. } => "bias step",
        Failure::Spikes { .. } => "spikes",
        Failure::Noise { .. } => "noise",
        Failure::DropOuts { .. } => "drop-outs",
    };
    let until_s = planned.failing.until_s;
    let until = if until_s.is_finite() { format!("{until_s} s") } else { "the end".to_owned() };
    format!("{output} {kind} {} s to {until}", planned.failing.from_s)
}
