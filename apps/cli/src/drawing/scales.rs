//! Scales that drawings of different reports share: a time axis, y axes with zero, equal scales of east and north.

use super::axis::{Axis, TimeAxis};
use super::plot::{Drawing, LEFT, PANEL_WIDTH, Panel, Trace, WIDTH};
use super::series::{Points, bounds, thinned};
use crate::units::Unit;

/// Largest number of ticks of a time axis.
const TIME_TICKS: usize = 8;

/// The time axis of a run that lasts `duration_s` [s].
pub fn time_axis(duration_s: f64) -> TimeAxis {
    Axis::time(duration_s, TIME_TICKS)
}

/// A drawing of `panels` above one another, on one time axis.
pub fn over_time(time: TimeAxis, panels: Vec<Panel>) -> Drawing {
    let x_label = format!("time since the start [{}]", time.unit);
    Drawing { width: WIDTH, left: LEFT, x_label, x: time.axis, panels }
}

/// Points (time [s], value [SI]) in the units of their axes.
pub fn scaled(points: Points, time: &TimeAxis, unit: Unit) -> Points {
    points.into_iter().map(|(t, y)| (t / time.seconds, y / unit.si)).collect()
}

/// The records (`time_s`, `values`), thinned, in the units of their axes.
pub fn line(time_s: &[f64], values: &[f64], time: &TimeAxis, unit: Unit) -> Points {
    scaled(thinned(time_s, values), time, unit)
}

/// A panel whose y axis covers its traces and zero.
pub fn panel(caption: String, height: f64, ticks: usize, traces: Vec<Trace>) -> Panel {
    let (low, high) = bounds(traces.iter().map(|trace| &trace.points));
    Panel::new(caption, Axis::around(low.min(0.0), high.max(0.0), 0.0, ticks), height, traces)
}

/// Axes in `unit` with equal scales around `east` and `north`, each from low to high [m], for a panel of `height` [drawing units]. An
/// axis covers at least `least` [m].
pub fn equal_axes(east: (f64, f64), north: (f64, f64), least: f64, unit: Unit, height: f64) -> (Axis, Axis) {
    let span = |(low, high): (f64, f64)| (high - low).max(least);
    let scale = equal_scale(span(east), span(north), height);
    let centred = |(low, high): (f64, f64), units: f64| {
        let (middle, half) = ((low + high) / 2.0 / unit.si, units / scale / 2.0 / unit.si);
        Axis::linear(middle - half, middle + half, 6)
    };
    (centred(east, PANEL_WIDTH), centred(north, height))
}

/// Drawing units for one metre, the same on both axes of a panel of `height`.
fn equal_scale(east: f64, north: f64, height: f64) -> f64 {
    let margin = 1.12;
    (PANEL_WIDTH / (east * margin)).min(height / (north * margin))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn axes_are_equal_and_hold_the_track() {
        for (east, north) in [(10.0, 1.0), (1.0, 10.0), (3.0, 3.0)] {
            let scale = equal_scale(east, north, 300.0);
            assert!(PANEL_WIDTH / scale >= east && 300.0 / scale >= north);
        }
    }
}
