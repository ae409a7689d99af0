//! Failures of the sensors, marked over time.

use super::axis::TimeAxis;
use super::figure::Legend;
use super::pen::Pen;
use super::plot::{Mark, Panel};

/// Begin of a failure, and its end, unless it lasts [s].
pub type Span = (f64, Option<f64>);

/// Marks begin and end of each failure within `time` in all `panels`. Its number stands above the first of them.
pub fn mark(failures: &[Span], time: &TimeAxis, panels: &mut [Panel]) {
    for (number, (from_s, until_s)) in (1..).zip(failures) {
        for (place, panel) in panels.iter_mut().enumerate() {
            let text = if place == 0 { number.to_string() } else { String::new() };
            let ends = [(Some(*from_s), text), (*until_s, String::new())];
            for (at_s, text) in ends.into_iter().filter_map(|(at_s, text)| Some((at_s?, text))) {
                let at = at_s / time.seconds;
                if at <= time.axis.high {
                    panel.marks.push(Mark { at, pen: Pen::Failure, text });
                }
            }
        }
    }
}

/// Meaning of the marks, if there are any.
pub fn legend(failures: &[Span]) -> Legend {
    match failures.first() {
        Some(_) => vec![(Pen::Failure, "failure: begin, with its number, and end".to_owned())],
        None => Vec::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drawing::scales::{panel, time_axis};

    #[test]
    fn begin_and_end_within_the_run_are_marked() {
        let time = time_axis(120.0);
        let panels = || [0, 1].map(|_| panel("p".into(), 100.0, 4, Vec::new()));
        let mut without = panels();
        mark(&[], &time, &mut without);
        assert!(without.iter().all(|panel| panel.marks.is_empty()) && legend(&[]).is_empty());

        let failures = [(30.0, Some(60.0)), (90.0, None), (90.0, Some(1e3)), (121.0, None)];
        let mut with = panels();
        mark(&failures, &time, &mut with);
        let marks = |panel: &Panel| -> Vec<(f64, String)> {
            panel.marks.iter().map(|mark| ((mark.at * time.seconds).round(), mark.text.clone())).collect()
        };
        let expected = [(30.0, "1"), (60.0, ""), (90.0, "2"), (90.0, "3")];
        assert_eq!(marks(&with[0]), expected.map(|(at_s, text)| (at_s, text.to_owned())));
        assert_eq!(marks(&with[1]), expected.map(|(at_s, _)| (at_s, String::new())));
        assert_eq!(legend(&failures).len(), 1);
    }
}
