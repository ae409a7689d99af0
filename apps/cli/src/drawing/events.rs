//! Failures of the sensors and corrections of the solution, marked over time.

use super::axis::TimeAxis;
use super::figure::Legend;
use super::pen::Pen;
use super::plot::{Mark, Panel};

/// Begin of a failure, and its end, unless it lasts [s].
pub type Span = (f64, Option<f64>);

/// Largest number of marks of one update: more lines would hide the curves.
const MOST_MARKS: usize = 50;

/// An update by fixes: the time of the first [s], and the time from one to the next [s], if it is repeated.
pub type Update = (f64, Option<f64>);

/// What happens to a solution from outside, and what changes its errors in a moment.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Events {
    pub failures: Vec<Span>,
    pub updates: Vec<Update>,
    /// When the unit corrected the solution: the ends of its alignments [s].
    pub alignments_s: Vec<f64>,
}

impl Events {
    /// Marks the events within `time` in all `panels`. The number of a failure stands above the first of them.
    pub fn mark(&self, time: &TimeAxis, panels: &mut [Panel]) {
        let end_s = time.axis.high * time.seconds;
        let corrections = self.updates.iter().flat_map(|update| times(*update, end_s).0);
        for at_s in corrections.chain(self.alignments_s.iter().copied()) {
            for panel in panels.iter_mut() {
                push(panel, time, at_s, Pen::Correction, String::new());
            }
        }
        for (number, (from_s, until_s)) in (1..).zip(&self.failures) {
            for (place, panel) in panels.iter_mut().enumerate() {
                let text = if place == 0 { number.to_string() } else { String::new() };
                push(panel, time, *from_s, Pen::Failure, text);
                if let Some(until_s) = until_s {
                    push(panel, time, *until_s, Pen::Failure, String::new());
                }
            }
        }
    }

    /// Meaning of the marks within `time`, if there are any.
    pub fn legend(&self, time: &TimeAxis) -> Legend {
        let end_s = time.axis.high * time.seconds;
        let mut legend = Legend::new();
        let mut words: Vec<String> = Vec::new();
        for update in &self.updates {
            let (marked, all) = times(*update, end_s);
            match all {
                0 => continue,
                _ if marked.len() < all => words.push(format!("the first of {all} updates by fixes")),
                _ => words.push("update by a fix".to_owned()),
            }
        }
        words.dedup();
        if !self.alignments_s.is_empty() {
            words.push("end of an alignment, which corrects the solution".to_owned());
        }
        if !words.is_empty() {
            legend.push((Pen::Correction, words.join("; ")));
        }
        if !self.failures.is_empty() {
            legend.push((Pen::Failure, "failure: begin, with its number, and end".to_owned()));
        }
        legend
    }
}

/// The times of an update until `end_s` that are marked, and the number of all.
fn times((at_s, every_s): Update, end_s: f64) -> (Vec<f64>, usize) {
    if at_s > end_s {
        return (Vec::new(), 0);
    }
    let Some(every_s) = every_s else { return (vec![at_s], 1) };
    let all = 1 + ((end_s - at_s) / every_s) as usize;
    let marked = if all > MOST_MARKS { 1 } else { all };
    ((0..marked).map(|count| at_s + count as f64 * every_s).collect(), all)
}

fn push(panel: &mut Panel, time: &TimeAxis, at_s: f64, pen: Pen, text: String) {
    let at = at_s / time.seconds;
    if at <= time.axis.high {
        panel.marks.push(Mark { at, pen, text });
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drawing::scales::{panel, time_axis};

    fn marks(panel: &Panel, time: &TimeAxis) -> Vec<(f64, Pen, String)> {
        panel
            .marks
            .iter()
            .map(|mark| ((mark.at * time.seconds).round(), mark.pen, mark.text.clone()))
            .collect()
    }

    #[test]
    fn begin_and_end_within_the_run_are_marked() {
        let time = time_axis(120.0);
        let panels = || [0, 1].map(|_| panel("p".into(), 100.0, 4, Vec::new()));
        let (mut without, none) = (panels(), Events::default());
        none.mark(&time, &mut without);
        assert!(without.iter().all(|panel| panel.marks.is_empty()) && none.legend(&time).is_empty());

        let failures = vec![(30.0, Some(60.0)), (90.0, None), (90.0, Some(1e3)), (121.0, None)];
        let (mut with, events) = (panels(), Events { failures, ..Events::default() });
        events.mark(&time, &mut with);
        let expected = [(30.0, "1"), (60.0, ""), (90.0, "2"), (90.0, "3")];
        let of =
            |text: fn(&'static str) -> String| expected.map(|(at_s, word)| (at_s, Pen::Failure, text(word)));
        assert_eq!(marks(&with[0], &time), of(str::to_owned));
        assert_eq!(marks(&with[1], &time), of(|_| String::new()));
        assert_eq!(events.legend(&time).len(), 1);
    }

    #[test]
    fn corrections_are_marked_and_too_many_are_counted() {
        let time = time_axis(120.0);
        let mut panels = [panel("p".into(), 100.0, 4, Vec::new())];
        let events = Events {
            updates: vec![(100.0, Some(10.0)), (500.0, None)],
            alignments_s: vec![60.0],
            ..Events::default()
        };
        events.mark(&time, &mut panels);
        let of = |at_s| (at_s, Pen::Correction, String::new());
        assert_eq!(marks(&panels[0], &time), [100.0, 110.0, 120.0, 60.0].map(of));
        let words = "update by a fix; end of an alignment, which corrects the solution";
        assert_eq!(events.legend(&time), [(Pen::Correction, words.to_owned())]);

        let events = Events { updates: vec![(1.0, Some(1.0))], ..Events::default() };
        let mut panels = [panel("p".into(), 100.0, 4, Vec::new())];
        events.mark(&time, &mut panels);
        assert_eq!(marks(&panels[0], &time), [of(1.0)]);
        assert_eq!(events.legend(&time)[0].1, "the first of 120 updates by fixes");
    }
}
