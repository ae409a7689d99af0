//! The errors over time: their mean, the bands of 1 and 3 sigma, some of the runs, and the limits of requirements; the radial error
//! in quantiles.

use super::flight::LEAST_SPEED;
use super::plan::{Data, Due};
use super::requirement::{Measure, along_cross};
use super::results::State;
use super::study::{Quantity, Study};
use super::table::Row;
use crate::drawing::axis::TimeAxis;
use crate::drawing::figure::Figure;
use crate::drawing::pen::Pen;
use crate::drawing::plot::Trace;
use crate::drawing::scales::{over_time, panel, scaled, time_axis};
use crate::drawing::series::Points;
use crate::failure::Failure;
use crate::planned;
use crate::rows::EAST_NORTH_UP;
use crate::units::{Family, LENGTH, Unit, fitting, fitting_axis, with_unit};

/// Mean and bands of one quantity, a panel for each axis.
pub fn figure(study: &Study, quantity: &Quantity) -> Result<Figure, Failure> {
    let of = |axis: usize| {
        let (place, name) = (quantity.first + axis, EAST_NORTH_UP[axis]);
        let limits = Limits::of(study, Measure::State(place));
        let lines =
            Lines::of(study, limits, |row| (row.mean()[place], row.sigma()[place]), |state, _| state[place]);
        (name, lines)
    };
    let lines: Vec<_> = (0..study.axes(quantity)).map(of).collect();
    let note = if lines.len() < 3 { " Up is not shown: the vertical channel follows the truth." } else { "" };
    bands(study, &format!("Errors of the {}", quantity.name), quantity.name, quantity.family, &lines, note)
}

/// Mean and bands of the position error along the truth's track and across it.
pub fn track(study: &Study) -> Result<Figure, Failure> {
    let of = |axis: usize, name, measure| {
        let figures = move |row: &Row| (row.track_mean()[axis], row.track_sigma()[axis]);
        let value = move |state: &State, track_rad| along_cross(state, track_rad)[axis];
        (name, Lines::of(study, Limits::of(study, measure), figures, value))
    };
    let lines = [of(0, "along", Measure::Along), of(1, "across", Measure::Cross)];
    let note = format!(
        " The track has the direction of the true velocity, or below {LEAST_SPEED} m/s the heading; across is positive to its right."
    );
    bands(study, "Position error along the track and across it", "position", LENGTH, &lines, &note)
}

/// Mean and bands of the errors `lines` with their names, a panel for each.
fn bands(
    study: &Study,
    title: &str,
    name: &str,
    family: &Family,
    lines: &[(&str, Lines)],
    more: &str,
) -> Result<Figure, Failure> {
    let largest = lines.iter().map(|(_, lines)| lines.size()).fold(0.0, f64::max);
    let time = time_axis(study.given.duration_s);
    let panels = lines.iter().map(|(axis, lines)| {
        let unit = fitting_axis(lines.size(), largest, family);
        panel(format!("{name} {axis} [{}]", unit.name), 130.0, 5, lines.traces(&time, unit))
    });
    let mut panels: Vec<_> = panels.collect();
    let events = planned::events(&study.given.scene);
    events.mark(&time, &mut panels);
    let drawn = study.results.drawn.len();
    let mut legend = vec![
        (Pen::Computed, "mean of the runs".to_owned()),
        (Pen::Band, "mean ± 1σ".to_owned()),
        (Pen::OuterBand, "mean ± 3σ".to_owned()),
        (Pen::Record, if drawn == 1 { "the run".to_owned() } else { format!("the first {drawn} runs") }),
    ];
    legend.extend(lines.iter().flat_map(|(_, lines)| lines.limits.legend()).take(1));
    legend.extend(events.legend(&time));
    let sigma = |(axis, lines): &(&str, Lines)| {
        format!("{axis} {}", with_unit(lines.sigma.last().copied().unwrap_or(0.0), family))
    };
    let sigmas: Vec<String> = lines.iter().map(sigma).collect();
    let note = format!("1σ at the end: {}.{more}", sigmas.join(", "));
    Figure::new(title, " over time, mean and bands of 1 and 3 sigma", legend, &over_time(time, panels), note)
}

/// Largest limit that is drawn, over the largest error that is drawn.
const MOST_ABOVE: f64 = 6.0;

/// The limits of the requirements on one error over time [s], [SI]. A limit is a line until the time when it is due.
struct Limits(Vec<Points>);

impl Limits {
    fn of(study: &Study, measure: Measure) -> Self {
        let dues = study.plan.requirements.iter().filter(|due| due.requirement.measure == measure);
        let begin = |due: &Due| (due.grows_from_s.unwrap_or(0.0), due.requirement.limit_at(0.0));
        Self(dues.map(|due| vec![begin(due), (due.time_s, due.limit)]).collect())
    }

    /// Without those that would make errors of `size` too small to see.
    fn visible(mut self, size: f64) -> Self {
        self.0.retain(|points| points.iter().all(|(_, limit)| *limit <= MOST_ABOVE * size));
        self
    }

    fn legend(&self) -> Option<(Pen, String)> {
        self.0.first().map(|_| (Pen::Limit, "limit of the requirement".to_owned()))
    }

    fn size(&self) -> f64 {
        self.0.iter().flatten().map(|(_, limit)| *limit).fold(0.0, f64::max)
    }

    /// The limits, with this sign.
    fn traces(&self, sign: f64, time: &TimeAxis, unit: Unit) -> impl Iterator<Item = Trace> {
        let signed = move |points: &Points| points.iter().map(|(t, limit)| (*t, sign * limit)).collect();
        self.0.iter().map(move |points| Trace::new(Pen::Limit, scaled(signed(points), time, unit)))
    }
}

/// One error over time [s], [SI].
struct Lines {
    time_s: Vec<f64>,
    mean: Vec<f64>,
    sigma: Vec<f64>,
    runs: Vec<Points>,
    limits: Limits,
}

impl Lines {
    /// An error of which `figures` gives mean and sigma, and `value` that of a run with the direction of the track.
    fn of(
        study: &Study,
        limits: Limits,
        figures: impl Fn(&Row) -> (f64, f64),
        value: impl Fn(&State, f64) -> f64,
    ) -> Self {
        let rows = study.of(Data::Navigation);
        let time_s: Vec<f64> = rows.iter().map(|row| row.time_s - study.given.start_s).collect();
        let (mean, sigma) = rows.iter().map(|row| figures(row)).unzip();
        let run = |path: &Vec<State>| {
            let points = time_s.iter().zip(&rows).zip(path);
            points.map(|((time_s, row), state)| (*time_s, value(state, row.track_rad))).collect()
        };
        let runs = study.results.drawn.iter().map(run).collect();
        let without = Self { mean, sigma, runs, limits: Limits(Vec::new()), time_s };
        Self { limits: limits.visible(without.size()), ..without }
    }

    /// Largest magnitude that is drawn.
    fn size(&self) -> f64 {
        let band = self.mean.iter().zip(&self.sigma).map(|(mean, sigma)| mean.abs() + 3.0 * sigma);
        let runs = self.runs.iter().flatten().map(|(_, value)| value.abs());
        band.chain(runs).fold(self.limits.size(), f64::max)
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
        traces.extend([1.0, -1.0].into_iter().flat_map(|sign| self.limits.traces(sign, time, unit)));
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
    let rows = study.of(Data::Navigation);
    let largest = rows.iter().map(|row| row.figures.largest_radial_m).fold(0.0, f64::max);
    let limits = Limits::of(study, Measure::Horizontal(0)).visible(largest);
    let unit = fitting(limits.size().max(largest), LENGTH);
    let start_s = study.given.start_s;
    let line = |pen, value: fn(&Row) -> f64| {
        let point = |row: &&Row| ((row.time_s - start_s) / time.seconds, value(row) / unit.si);
        Trace::new(pen, rows.iter().map(point).collect())
    };
    let mut traces = vec![
        line(Pen::Record, |row| row.figures.largest_radial_m),
        line(Pen::Fit, |row| row.figures.r95_m),
        line(Pen::Computed, |row| row.figures.cep50_m),
    ];
    traces.extend(limits.traces(1.0, &time, unit));
    let mut legend = vec![
        (Pen::Computed, "CEP50: half of the runs are nearer".to_owned()),
        (Pen::Fit, "R95: 95 % of the runs are nearer".to_owned()),
        (Pen::Record, "the largest of the runs".to_owned()),
    ];
    legend.extend(limits.legend());
    let note = rows.last().map_or(String::new(), |row| {
        let [cep50, r95, largest] = [row.figures.cep50_m, row.figures.r95_m, row.figures.largest_radial_m]
            .map(|size| with_unit(size, LENGTH));
        format!("At the end: CEP50 {cep50}, R95 {r95}, largest {largest}.")
    });
    let mut panels = vec![panel(format!("horizontal error [{}]", unit.name), 370.0, 6, traces)];
    let events = planned::events(&study.given.scene);
    events.mark(&time, &mut panels);
    legend.extend(events.legend(&time));
    Figure::new("Horizontal position error", " over time", legend, &over_time(time, panels), note)
}
