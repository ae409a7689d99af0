//! What a reader must know before the curves: faults of the truth, gaps, failures, updates, and outputs that are not valid.

use sins::unit::{KEEP_S, State};

use crate::report::overview;
use crate::report::run::Run;
use crate::report::summary::Row;
use crate::units::{LENGTH, time_text, with_unit};

/// Acceleration above which a truth is to be looked at [m/s²].
const HARD_M_S2: f64 = 200.0;

/// The remarks of `run`, each a sentence or two.
pub fn warnings(run: &Run) -> Vec<String> {
    let (notes, doubts): (Vec<&str>, Vec<&str>) =
        run.summary.findings().partition(|finding| finding.contains(": note: "));
    let mut said: Vec<String> = doubts.iter().map(|finding| format!("Flight data: {finding}.")).collect();
    if !notes.is_empty() {
        let notes = counted(notes.len() as f64, "note");
        said.push(format!("Flight data: {notes}, among the settings and figures of the run."));
    }
    let count = |key: &str| run.summary.number(key).filter(|count| *count > 0.0);
    let text = |key: &str| run.summary.row(key).map(Row::text).unwrap_or_default();
    if count("interrupted").is_some() {
        said.push("The flight was stopped before its end.".to_owned());
    }
    if let Some(samples) = count("inconsistent_samples") {
        let largest = with_unit(run.summary.number("inconsistency_max_m").unwrap_or(0.0), LENGTH);
        said.push(format!(
            "In {} of the truth the position contradicts the velocity, by up to {largest} in an interval.",
            counted(samples, "sample")
        ));
    }
    if let Some(row) = run.summary.row("truth_acceleration_max_m_s2")
        && run.summary.number(&row.key).is_some_and(|acceleration| acceleration > HARD_M_S2)
    {
        let when = row.label.rsplit(", ").next().unwrap_or_default();
        said.push(format!("The truth accelerates by {}, {when}.", row.text()));
    }
    if let Some(gaps) = count("gaps") {
        said.push(format!(
            "{} in the truth, the longest of {}: the path in a gap is assumed.",
            counted(gaps, "gap"),
            text("gap_longest_s")
        ));
    }
    for (key, what) in [("gyro_saturated_steps", "Gyros"), ("accel_saturated_steps", "Accelerometers")] {
        said.extend(count(key).map(|steps| {
            format!(
                "{what} were beyond their range in {}: their range limited what they measured.",
                counted(steps, "step")
            )
        }));
    }
    said.extend(overview::failures(run).map(|failures| format!("Failures: {failures}.")));
    let updates = run.summary.value("updates_text").filter(|updates| !["", "none"].contains(updates));
    said.extend(updates.map(|updates| format!("Updates by fixes: {updates}.")));
    said.extend(invalid_outputs(run));
    said.extend(kept_solution(run));
    if run.model.is_none() && run.is_of_paper() {
        said.push("The error differential equations (error data 1) were off.".to_owned());
    }
    if let Some(times) = run.model_invalid_s() {
        said.push(format!(
            "The error differential equations were outside their validity {}: misalignment above 2 degrees or displacement above 100 km.",
            between(times)
        ));
    }
    if let Some(times) = run.near_pole_s() {
        said.push(format!(
            "Near a pole {}: the up misalignment, and the east and north velocity errors, have no meaning there.",
            between(times)
        ));
    }
    said
}

fn between((from_s, to_s): (f64, f64)) -> String {
    match (time_text(from_s), time_text(to_s)) {
        (from, to) if from == to => format!("at {from}"),
        (from, to) => format!("between {from} and {to}"),
    }
}

fn counted(count: f64, what: &str) -> String {
    format!("{count} {what}{}", if count == 1.0 { "" } else { "s" })
}

/// When the unit did not navigate, so that a position or a velocity of it was not valid.
fn invalid_outputs(run: &Run) -> Option<String> {
    let ends = run.states.iter().skip(1).map(|(from_s, _)| *from_s).chain([run.duration_s()]);
    let mut spans: Vec<(f64, f64)> = Vec::new();
    for (&(from_s, state), until_s) in run.states.iter().zip(ends) {
        match spans.last_mut() {
            _ if state == State::Navigation => {}
            Some(last) if last.1 == from_s => last.1 = until_s,
            _ => spans.push((from_s, until_s)),
        }
    }
    let spans: Vec<String> = spans.into_iter().map(between).collect();
    (!spans.is_empty()).then(|| format!("The unit does not navigate {}.", spans.join(", and ")))
}

/// What the curves of a solution show that the unit does not show.
fn kept_solution(run: &Run) -> Option<String> {
    let shows = |state: State| matches!(state, State::Ready | State::Navigation | State::Realignment);
    run.states.iter().any(|(_, state)| !shows(*state)).then(|| {
        format!(
            "While the unit shows no position, it sets its solution to the truth each {KEEP_S} s: the sawtooth in the curves there is no \
             error that it shows."
        )
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::run::tests::made;

    #[test]
    fn what_a_reader_must_know_is_said() {
        let mut run = made(13, |name, t| match name {
            "model_error_flags" if t >= 20.0 => 2.0,
            "navigation_error_flags" if t == 50.0 => 1.0,
            _ => 0.0,
        });
        run.summary.rows.extend(
            [
                ("interrupted", "1", ""),
                ("gaps", "1", ""),
                ("gap_longest_s", "2", "s"),
                ("inconsistent_samples", "8", ""),
                ("inconsistency_max_m", "2299.9", "m"),
                ("gyro_saturated_steps", "7", ""),
                ("accel_saturated_steps", "1", ""),
                ("failures_text", "gyro z dead", ""),
                ("updates_text", "position at 5 min", ""),
            ]
            .map(|(key, value, unit)| Row::made(key, value, unit)),
        );
        let hard = Row::made("truth_acceleration_max_m_s2", "4500", "m/s2");
        run.summary.rows.push(Row { label: "truth: largest acceleration, at 63 s".into(), ..hard });
        let ready = (30.0, State::Ready);
        run.states = vec![(0.0, State::Off), ready, (60.0, State::Navigation), (90.0, State::Fault)];
        let said = warnings(&run);
        let expected = [
            "The flight was stopped before its end.",
            "In 8 samples of the truth the position contradicts the velocity, by up to 2.300 km in an interval.",
            "The truth accelerates by 4500 m/s2, at 63 s.",
            "1 gap in the truth, the longest of 2 s: the path in a gap is assumed.",
            "Gyros were beyond their range in 7 steps: their range limited what they measured.",
            "Accelerometers were beyond their range in 1 step: their range limited what they measured.",
            "Failures: gyro z dead.",
            "Updates by fixes: position at 5 min.",
            "The unit does not navigate between 0 s and 60 s, and between 90 s and 2 min.",
            "While the unit shows no position, it sets its solution to the truth each 60 s: the sawtooth in the curves there is no \
             error that it shows.",
            "The error differential equations were outside their validity between 20 s and 2 min: misalignment above 2 degrees or \
             displacement above 100 km.",
            "Near a pole at 50 s: the up misalignment, and the east and north velocity errors, have no meaning there.",
        ];
        assert_eq!(said, expected);
        assert!(warnings(&made(3, |_, _| 0.0)).is_empty());
    }
}
