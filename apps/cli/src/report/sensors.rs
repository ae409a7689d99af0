//! The errors of the sensors over time.

use crate::drawing::figure::Figure;
use crate::drawing::pen::Pen;
use crate::drawing::plot::Trace;
use crate::drawing::scales::{line, over_time, panel, scaled, time_axis};
use crate::drawing::series::{block_means, magnitude, mean};
use crate::failure::Failure;
use crate::report::figures::LOWER;
use crate::report::run::Run;
use crate::units::{Unit, significant, time_text};

/// Axes of a triad of sensors.
const AXES: [&str; 3] = ["x", "y", "z"];

/// Number of means that are drawn over noisy sensor errors.
const MEANS: usize = 100;

/// Errors of a triad of sensors: the records and their means over stretches; `None` if there are no errors.
pub fn figure(run: &Run, title: &str, values: &[Vec<f64>; 3], unit: Unit) -> Result<Option<Figure>, Failure> {
    if values.iter().all(|values| magnitude(values) == 0.0) {
        return Ok(None);
    }
    let time = time_axis(run.duration_s());
    // Each record has the mean since the previous record; the first record has none.
    let (time_s, values) = (&run.time_s[1..], values.each_ref().map(|values| &values[1..]));
    let mut panels: Vec<_> = AXES
        .iter()
        .zip(values)
        .map(|(axis, values)| {
            let means = scaled(block_means(time_s, values, MEANS), &time, unit);
            let traces = vec![
                Trace::new(Pen::Record, line(time_s, values, &time, unit)),
                Trace::new(Pen::Computed, means),
            ];
            panel(format!("{axis} [{}]", unit.name), 100.0, 5, traces)
        })
        .collect();
    run.events.mark(&time, &mut panels);
    let stretch = time_text(run.duration_s() / MEANS as f64);
    let mut legend = vec![
        (Pen::Record, "measured minus ideal, each record".to_owned()),
        (Pen::Computed, format!("mean over {stretch}")),
    ];
    legend.extend(run.events.legend(&time));
    let drawing = over_time(time, panels).of_height(LOWER);
    let [x, y, z] = values.map(|values| significant(mean(values) / unit.si));
    let note = format!("Mean over the run: x {x}, y {y}, z {z} {}.", unit.name);
    Figure::new(title, " over time", legend, &drawing, note).map(Some)
}
