//! Drawings of what was found: parameters on their priors, the residual over time, and drifts by duration.

use sins::analysis::identify::check::{Check, Span};
use sins::analysis::identify::sheet::{AXES, Line, Sheet};
use sins::analysis::identify::text::with_interval;

use super::residual::Residual;
use crate::drawing::axis::{Axis, Scale};
use crate::drawing::figure::Legend;
use crate::drawing::pen::Pen;
use crate::drawing::plot::{Dot, Drawing, LEFT, Label, Mark, Panel, Trace, WIDTH};
use crate::drawing::series::{Points, block_means, bounds, positive_range, thinned};
use crate::units::{MICRO_G, Unit, significant, six_digits, time_text};

/// Width of the names of parameters, and height of a row, of a panel over time and of the drifts [drawing units].
const NAMES: f64 = 150.0;
const ROW: f64 = 20.0;
const PANEL: f64 = 100.0;
const DRIFTS: f64 = 300.0;
/// Radius of a dot [drawing units].
const RADIUS: f64 = 3.0;
/// Half of a 95 % interval, in standard deviations.
const HALF: f64 = 1.96;
/// Means over time of a residual.
const MEANS: usize = 100;
const DEG_PER_HOUR: Unit = Unit { name: "°/h", si: sins::units::DEG_PER_HOUR };
/// Beyond both sides of the durations, in decades.
const BESIDE: f64 = 0.1;

pub fn legend_of_priors() -> Legend {
    let entry = |pen, text: &str| (pen, text.to_owned());
    vec![
        entry(Pen::Band, "95 % interval before the record"),
        entry(Pen::Random, "with the record"),
        entry(Pen::PaleRandom, "with the record, not seen"),
    ]
}

/// The parameters of a triad as intervals, in standard deviations of their priors.
pub fn priors(sheet: &Sheet) -> Drawing {
    let lines: Vec<&Line> = sheet.fitted().collect();
    let count = lines.len();
    // The first line is the highest.
    let row = |k: usize| (count - 1 - k) as f64;
    let ends = |line: &Line| {
        let (low, high) = line.estimate.interval();
        (low / line.estimate.prior, high / line.estimate.prior)
    };
    let far = lines.iter().copied().map(ends).fold(HALF, |far, (low, high)| far.max(-low).max(high));
    let (low, high) = (-0.5, count as f64 - 0.5);
    let band = vec![(-HALF, low), (HALF, low), (HALF, high), (-HALF, high), (-HALF, low)];
    let bars = lines.iter().enumerate().map(|(k, line)| {
        let (low, high) = ends(line);
        Trace { label: Some(label(line)), ..Trace::new(pen(line), vec![(low, row(k)), (high, row(k))]) }
    });
    let ticks = lines.iter().enumerate().rev().map(|(k, line)| (row(k), line.name.clone())).collect();
    let y = Axis { low, high, ticks, scale: Scale::Names };
    let traces = core::iter::once(Trace::new(Pen::Band, band)).chain(bars).collect();
    let mut panel = Panel::new(format!("{}, on its prior", sheet.section), y, count as f64 * ROW, traces);
    // A narrow interval has a dot.
    panel.dots = lines
        .iter()
        .enumerate()
        .map(|(k, line)| Dot {
            at: (line.estimate.value / line.estimate.prior, row(k)),
            pen: Pen::Run,
            radius: RADIUS,
            label: Some(label(line)),
        })
        .collect();
    let x = Axis::linear(-1.05 * far, 1.05 * far, 6);
    let x_label = "standard deviations of the prior".to_owned();
    Drawing { width: WIDTH, left: NAMES, x, x_label, panels: vec![panel] }
}

fn pen(line: &Line) -> Pen {
    if line.estimate.is_seen() { Pen::Random } else { Pen::PaleRandom }
}

fn label(line: &Line) -> Label {
    let value = with_interval(&line.estimate, line.unit.si, line.unit.name);
    Label { text: format!("{}: {value}", line.name), values: [value, line.name.clone()] }
}

pub fn legend_of_residuals() -> Legend {
    vec![(Pen::Record, "rows".to_owned()), (Pen::Computed, "means".to_owned())]
}

/// The residual of the three sensors of part `part` over time; `fitted_s` is the end of what was identified, if it is not the end of all.
pub fn residuals(residual: &Residual, part: usize, fitted_s: Option<f64>) -> Drawing {
    let unit = [DEG_PER_HOUR, MICRO_G][part];
    let name = ["gyro", "accelerometer"][part];
    let first_s = residual.times_s[0];
    let over_s = residual.times_s[residual.times_s.len() - 1] - first_s;
    let time = Axis::time(over_s, 8);
    let times: Vec<f64> = residual.times_s.iter().map(|time_s| (time_s - first_s) / time.seconds).collect();
    let panels = AXES.iter().enumerate().map(|(axis, letter)| {
        let increments = &residual.increments[3 * part + axis];
        let values: Vec<f64> = increments.iter().map(|value| value / residual.interval_s / unit.si).collect();
        let rows = thinned(&times, &values);
        let (low, high) = bounds([&rows]);
        let traces = vec![
            Trace::new(Pen::Record, rows),
            Trace::new(Pen::Computed, block_means(&times, &values, MEANS)),
        ];
        let caption = format!("{name} {letter} [{}]", unit.name);
        let mut panel = Panel::new(caption, Axis::around(low, high, 0.0, 4), PANEL, traces);
        panel.marks.extend(fitted_s.map(|fitted_s| Mark {
            at: (fitted_s - first_s) / time.seconds,
            pen: Pen::Limit,
            text: if axis == 0 { "end of the fit".to_owned() } else { String::new() },
        }));
        panel
    });
    let panels = panels.collect();
    Drawing { width: WIDTH, left: LEFT, x: time.axis, x_label: format!("time [{}]", time.unit), panels }
}

pub fn legend_of_drifts() -> Legend {
    let entry = |pen, text: &str| (pen, text.to_owned());
    vec![
        entry(Pen::Computed, "the record, errors removed"),
        entry(Pen::Asymptote, "the record as it is"),
        entry(Pen::Fit, "predicted"),
        entry(Pen::Band, "95 % of the twins"),
    ]
}

/// Distances that half of the flights keep, of the record and of its twins, by the duration of the flights.
pub fn drifts(check: &Check) -> Drawing {
    let at = |span: &Span, distance_m: f64| (span.duration_s.log10(), distance_m.log10());
    let line = |distance_m: fn(&Span) -> f64| -> Points {
        let seen = check.spans.iter().filter(|span| distance_m(span) > 0.0 && distance_m(span).is_finite());
        seen.map(|span| at(span, distance_m(span))).collect()
    };
    let (low, high) = (line(|span| span.predicted_interval_m.0), line(|span| span.predicted_interval_m.1));
    let mut band = high.clone();
    band.extend(low.iter().rev());
    band.extend(high.first());
    let mut traces = vec![
        Trace::new(Pen::Band, band),
        Trace::new(Pen::Asymptote, line(|span| span.free_m)),
        Trace::new(Pen::Fit, line(|span| span.predicted_m)),
        Trace::new(Pen::Computed, line(|span| span.real_m)),
    ];
    for span in &check.spans {
        let (low_m, high_m) = span.real_interval_m;
        if low_m > 0.0 && high_m.is_finite() {
            traces.push(Trace::new(Pen::Computed, vec![at(span, low_m), at(span, high_m)]));
        }
    }
    let all = traces.iter().flat_map(|trace| &trace.points);
    let (least, most) = positive_range(all.map(|point| 10f64.powf(point.1)));
    let y = Axis::decades(least.log10() - BESIDE, most.log10() + BESIDE, 6);
    let caption = "distance from the path [m]".to_owned();
    let mut panel = Panel::new(caption, y, DRIFTS, traces);
    panel.dots = check
        .spans
        .iter()
        .filter(|span| span.real_m > 0.0 && span.real_m.is_finite())
        .map(|span| Dot {
            at: at(span, span.real_m),
            pen: Pen::Run,
            radius: RADIUS,
            label: Some(of_span(span)),
        })
        .collect();
    let ends = [check.spans.first(), check.spans.last()]
        .map(|span| span.map_or(0.0, |span| span.duration_s.log10()));
    let mut x = Axis::decades(ends[0] - BESIDE, ends[1] + BESIDE, 8);
    // There are few durations, and none but the first is a power of ten.
    x.ticks = check
        .spans
        .iter()
        .map(|span| (span.duration_s.log10(), six_digits(span.duration_s).to_string()))
        .collect();
    Drawing {
        width: NAMES + WIDTH - LEFT,
        left: LEFT,
        x,
        x_label: "duration of a flight [s]".to_owned(),
        panels: vec![panel],
    }
}

fn of_span(span: &Span) -> Label {
    let text = format!(
        "after {}: {} m, predicted {} m",
        time_text(span.duration_s),
        significant(span.real_m),
        significant(span.predicted_m)
    );
    Label { text, values: [significant(span.duration_s), significant(span.real_m)] }
}
