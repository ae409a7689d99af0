//! The states of a unit as a band over time.

use sins::unit::State;

use crate::drawing::axis::{Axis, Scale, TimeAxis};
use crate::drawing::figure::{Figure, Legend};
use crate::drawing::pen::Pen;
use crate::drawing::plot::{Panel, Trace};
use crate::drawing::scales::{over_time, time_axis};
use crate::failure::Failure;
use crate::report::run::Run;

/// The steps of the band, from below.
const LEVELS: [&str; 5] = ["OFF", "ALIGN", "NAV", "ATT", "FAULT"];

fn level(state: State) -> usize {
    match state {
        State::Off | State::Test | State::PowerDown => 0,
        State::CoarseAlignment | State::FineAlignment | State::Ready | State::Realignment => 1,
        State::Navigation => 2,
        State::Erection | State::Attitude => 3,
        State::Fault => 4,
    }
}

/// The band; `None`: the run has no unit.
pub fn band(run: &Run, time: &TimeAxis) -> Option<Panel> {
    let highest = run.states.iter().map(|(_, state)| level(*state)).max()?.max(2);
    let ends = run.states.iter().skip(1).map(|(from_s, _)| *from_s).chain([run.duration_s()]);
    let steps = run.states.iter().zip(ends).flat_map(|(&(from_s, state), until_s)| {
        [from_s, until_s].map(|at_s| (at_s / time.seconds, level(state) as f64))
    });
    let ticks = LEVELS[..=highest].iter().enumerate().map(|(at, word)| (at as f64, (*word).to_owned()));
    let y = Axis { low: -0.3, high: highest as f64 + 0.3, ticks: ticks.collect(), scale: Scale::Names };
    let trace = Trace::new(Pen::Computed, steps.collect());
    Some(Panel::new("unit", y, 22.0 * (highest as f64 + 1.0), vec![trace]))
}

/// The band as a figure; `None`: the run has no unit.
pub fn figure(run: &Run) -> Result<Option<Figure>, Failure> {
    let time = time_axis(run.duration_s());
    let Some(band) = band(run, &time) else { return Ok(None) };
    let drawing = over_time(time, vec![band]);
    Figure::new("States of the unit", " over time", Legend::new(), &drawing, String::new()).map(Some)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drawing::scales::time_axis;
    use crate::report::run::tests::made;

    #[test]
    fn the_band_steps_where_the_state_changes() {
        let mut run = made(13, |_, _| 0.0);
        let time = time_axis(run.duration_s());
        assert!(band(&run, &time).is_none());
        run.states = vec![(0.0, State::Off), (30.0, State::Ready), (60.0, State::Navigation)];
        let panel = band(&run, &time).unwrap();
        let steps: Vec<(f64, f64)> =
            panel.traces[0].points.iter().map(|(at, level)| ((at * time.seconds).round(), *level)).collect();
        assert_eq!(steps, [(0.0, 0.0), (30.0, 0.0), (30.0, 1.0), (60.0, 1.0), (60.0, 2.0), (120.0, 2.0)]);
        assert_eq!(panel.y.ticks.last().unwrap().1, "NAV");
    }
}
