//! The errors over time: their mean, the bands of 1 and 3 sigma, and some of the runs; the radial error in quantiles.

use sins::ErrorSource;

use super::study::{Quantity, Study};
use crate::drawing::axis::TimeAxis;
use crate::drawing::figure::Figure;
use crate::drawing::pen::Pen;
use crate::drawing::plot::Trace;
use crate::drawing::scales::{over_time, panel, scaled, time_axis};
use crate::drawing::series::Points;
use crate::failure::Failure;
use crate::record::EAST_NORTH_UP;
use crate::units::{LENGTH, Unit, fitting, fitting_axis, with_unit};

/// Mean and bands of one quantity, a panel for each axis.
pub fn figure(study: &Study, quantity: &Quantity) -> Result<Figure, Failure> {
    let lines: Vec<Lines> =
        (0..study.axes(quantity)).map(|axis| Lines::of(study, quantity.first + axis)).collect();
    let largest = lines.iter().map(Lines::size).fold(0.0, f64::max);
    let time = time_axis(study.given.duration_s);
    let panels = lines.iter().enumerate().map(|(axis, lines)| {
        let unit = fitting_axis(lines.size(), largest, quantity.family);
        let caption = format!("{} {} [{}]", quantity.name, EAST_NORTH_UP[axis], unit.name);
        panel(caption, 130.0, 5, lines.traces(&time, unit))
    });
    let panels = panels.collect();
    let drawn = study.results.drawn.len();
    let legend = vec![
        (Pen::Computed, "mean of the runs".to_owned()),
        (Pen::Band, "mean ± 1σ".to_owned()),
        (Pen::OuterBand, "mean ± 3σ".to_owned()),
        (Pen::Record, if drawn == 1 { "the run".to_owned() } else { format!("the first {drawn} runs") }),
    ];
    let sigmas: Vec<String> = lines
        .iter()
        .zip(EAST_NORTH_UP)
        .map(|(lines, axis)| {
            format!("{axis} {}", with_unit(lines.sigma.last().copied().unwrap_or(0.0), quantity.family))
        })
        .collect();
    let mut note = format!("1σ at the end: {}.", sigmas.join(", "));
    if lines.len() < 3 {
        note += " Up is not shown: the vertical channel follows the truth.";
    }
    let title = format!("Errors of the {}", quantity.name);
    let axes = " over time, mean and bands of 1 and 3 sigma";
    Figure::new(title, axes, legend, &over_time(time, panels), note)
}

/// One error over time [s], [SI].
struct Lines {
    time_s: Vec<f64>,
    mean: Vec<f64>,
    sigma: Vec<f64>,
    runs: Vec<Points>,
}

impl Lines {
    /// The error at `place` of a [`State`](super::results::State).
    fn of(study: &Study, place: usize) -> Self {
        let start_s = study.given.start_s;
        let rows = study.of(ErrorSource::Navigation);
        let time_s: Vec<f64> = rows.iter().map(|row| row.time_s - start_s).collect();
        let run = |path: &Vec<_>| {
            let value = |state: &super::results::State| state[place];
            time_s.iter().copied().zip(path.iter().map(value)).collect()
        };
        Self {
            mean: rows.iter().map(|row| row.mean()[place]).collect(),
            sigma: rows.iter().map(|row| row.sigma()[place]).collect(),
            runs: study.results.drawn.iter().map(run).collect(),
            time_s,
        }
    }

    /// Largest magnitude that is drawn.
    fn size(&self) -> f64 {
        let band = self.mean.iter().zip(&self.sigma).map(|(mean, sigma)| mean.abs() + 3.0 * sigma);
        let runs = self.runs.iter().flatten().map(|(_, value)| value.abs());
        band.chain(runs).fold(0.0, f64::max)
    }

    /// Traces, the widest first, because each is drawn over the traces before it.
    fn traces(&self, time: &TimeAxis, unit: Unit) -> Vec<Trace> {
        let scaled = |points: Points| scaled(points, time, unit);
        let mut traces = vec![
            Trace::new(Pen::OuterBand, scaled(self.band(3.0))),
            Trace::new(Pen::Band, scaled(self.band(1.0))),
        ];
        traces.extend(self.runs.iter().map(|run| Trace::new(Pen::Record, scaled(run.clone()))));
        let mean = self.time_s.iter().copied().zip(self.mean.iter().copied()).collect();
        traces.push(Trace::new(Pen::Computed, scaled(mean)));
        traces
    }

    /// Outline of the band: its upper edge, then its lower edge backwards.
    fn band(&self, sigmas: f64) -> Points {
        let edge = |sign: f64| {
            let values =
                self.mean.iter().zip(&self.sigma).map(move |(mean, sigma)| mean + sign * sigmas * sigma);
            self.time_s.iter().copied().zip(values)
        };
        edge(1.0).chain(edge(-1.0).rev()).collect()
    }
}

/// Distances from the truth within which half, 95 % and all of the runs are.
pub fn radial(study: &Study) -> Result<Figure, Failure> {
    let time = time_axis(study.given.duration_s);
    let rows = study.of(ErrorSource::Navigation);
    let unit = fitting(rows.iter().map(|row| row.figures.largest_radial_m).fold(0.0, f64::max), LENGTH);
    let start_s = study.given.start_s;
    let line = |pen, value: fn(&super::table::Row) -> f64| {
        let point = |row: &&super::table::Row| ((row.time_s - start_s) / time.seconds, value(row) / unit.si);
        Trace::new(pen, rows.iter().map(point).collect())
    };
    let traces = vec![
        line(Pen::Record, |row| row.figures.largest_radial_m),
        line(Pen::Fit, |row| row.figures.r95_m),
        line(Pen::Computed, |row| row.figures.cep50_m),
    ];
    let legend = vec![
        (Pen::Computed, "CEP50: half of the runs are nearer".to_owned()),
        (Pen::Fit, "R95: 95 % of the runs are nearer".to_owned()),
        (Pen::Record, "the largest of the runs".to_owned()),
    ];
    let note = rows.last().map_or(String::new(), |row| {
        let [cep50, r95, largest] = [row.figures.cep50_m, row.figures.r95_m, row.figures.largest_radial_m]
            .map(|size| with_unit(size, LENGTH));
        format!("At the end: CEP50 {cep50}, R95 {r95}, largest {largest}.")
    });
    let panels = vec![panel(format!("horizontal error [{}]", unit.name), 400.0, 6, traces)];
    Figure::new("Horizontal position error", " over time", legend, &over_time(time, panels), note)
}
