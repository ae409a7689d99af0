//! The planned failures of a scene, in words and as times, and its planned updates in words.

use sins::scene::{PlannedFailure, PlannedUpdate, Scene, Updated};
use sins::sensors::{Axis, SensorOutput};
use sins::units::DEG_PER_SQRT_HOUR;

use crate::drawing::events::{Events, Span, Update};
use crate::units::{DEG_PER_HOUR, MICRO_G, six_digits};

/// Each failure with its time, numbered if there are several; "none" if there are no failures.
pub fn failures(scene: &Scene) -> String {
    let numbered = |(number, planned)| format!("{number} {}", words(planned));
    match scene.failures.as_slice() {
        [] => "none".to_owned(),
        [planned] => words(planned),
        several => (1..).zip(several).map(numbered).collect::<Vec<String>>().join(", "),
    }
}

/// Each update with its time; "none" if there are no updates.
pub fn updates(scene: &Scene) -> String {
    match scene.updates.as_slice() {
        [] => "none".to_owned(),
        updates => updates.iter().map(update_text).collect::<Vec<String>>().join(", "),
    }
}

pub fn spans(scene: &Scene) -> Vec<Span> {
    let span = |planned: &PlannedFailure| {
        let until_s = planned.failing.until_s;
        (planned.failing.from_s, until_s.is_finite().then_some(until_s))
    };
    scene.failures.iter().map(span).collect()
}

/// The times of the updates.
pub fn times_of_updates(scene: &Scene) -> Vec<Update> {
    let times =
        |planned: &PlannedUpdate| (planned.at_s, Some(planned.every_s).filter(|every_s| every_s.is_finite()));
    scene.updates.iter().map(times).collect()
}

/// What is planned, to be marked over time.
pub fn events(scene: &Scene) -> Events {
    Events { failures: spans(scene), updates: times_of_updates(scene), ..Events::default() }
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
    let (kind, [size, density, interval_s, duration_s, probability]) = planned.failure.fields();
    let (size_si, density_si, units) = match planned.output {
        SensorOutput::Gyro(_) => (DEG_PER_HOUR.si, DEG_PER_SQRT_HOUR, ["deg/h", "deg/sqrt(h)"]),
        SensorOutput::Accelerometer(_) => (MICRO_G.si, MICRO_G.si, ["micro-g", "micro-g/sqrt(Hz)"]),
        SensorOutput::Altimeter => (1.0, 1.0, ["m", "m/sqrt(Hz)"]),
    };
    let mut text = format!("{output} {}", kind.replace("drop_", "drop-").replace('_', " "));
    for (number, si, unit) in [(size, size_si, units[0]), (density, density_si, units[1])] {
        if number != 0.0 {
            text += &format!(" {} {unit}", six_digits(number / si));
        }
    }
    let rest = [("each", interval_s, " s"), ("for", duration_s, " s"), ("with probability", probability, "")];
    let rest = rest.iter().filter(|(_, number, _)| *number != 0.0);
    let rest: Vec<String> = rest.map(|(word, number, unit)| format!("{word} {number}{unit}")).collect();
    if !rest.is_empty() {
        text += &format!(", {},", rest.join(" "));
    }
    let until_s = planned.failing.until_s;
    let until = if until_s.is_finite() { format!("{until_s} s") } else { "the end".to_owned() };
    format!("{text} {} s to {until}", planned.failing.from_s)
}

fn update_text(planned: &PlannedUpdate) -> String {
    let PlannedUpdate { updated, at_s, every_s, sigma_n } = planned;
    let (what, axes, unit) = match updated {
        Updated::Position => ("position", 3, "m"),
        Updated::HorizontalPosition => ("horizontal position", 2, "m"),
        Updated::Velocity => ("velocity", 3, "m/s"),
    };
    let every = if every_s.is_finite() { format!(" every {every_s} s") } else { String::new() };
    let sigma = &sigma_n.as_slice()[..axes];
    let is_same = sigma.iter().all(|size| *size == sigma[0]);
    let sizes: Vec<String> = sigma[..if is_same { 1 } else { axes }].iter().map(f64::to_string).collect();
    format!("{what} {at_s} s{every} sigma {} {unit}", sizes.join(" "))
}
