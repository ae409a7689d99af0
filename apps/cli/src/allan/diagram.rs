//! The curve of one column on logarithmic axes: deviation, band, fit, and the asymptotes of the terms that are resolved.

use sins_allan::Term;

use super::analysis::{Analysis, Coefficient, Deviation};
use super::sheet;
use crate::drawing::axis::Axis;
use crate::drawing::figure::Legend;
use crate::drawing::pen::Pen;
use crate::drawing::plot::{Drawing, LEFT, Note, PANEL_WIDTH, Panel, Trace, WIDTH};
use crate::drawing::series::{Points, bounds};
use crate::units::in_unit;

/// Height of the axes [drawing units].
const HEIGHT: f64 = 300.0;

/// Room below the curve, for labels, and above it, as parts of the height of the curve.
const ROOM_BELOW: f64 = 0.2;
const ROOM_ABOVE: f64 = 0.04;

/// Smallest part of the fitted deviation that a term has where its asymptote is drawn.
const SHARE: f64 = 0.3;

/// Number of intervals of a smooth line.
const SMOOTH: usize = 100;

/// Distance from the middle of a label up to its line, room below the line for the label, and width of a letter [drawing units].
const BELOW: f64 = 13.0;
const LABEL: f64 = 24.0;
const LETTER: f64 = 8.0;

/// What stands at the line before which averaging times are left out of the fit.
const LEFT_OUT: &str = "left out";

/// Legend of the lines.
pub fn legend() -> Legend {
    let entry = |pen, text: &str| (pen, text.to_owned());
    vec![
        entry(Pen::Computed, "deviation"),
        entry(Pen::Band, "95 % interval"),
        entry(Pen::Fit, "fit"),
        entry(Pen::Asymptote, "one term"),
    ]
}

/// The drawing of one column.
pub fn drawing(analysis: &Analysis) -> Drawing {
    let unit = sheet::deviation(analysis.sensor);
    let measured = curve(analysis, |estimate| estimate.deviation);
    let (low, high) = (curve(analysis, |e| e.interval.low), curve(analysis, |e| e.interval.high));
    let mut band = high.clone();
    band.extend(low.iter().rev());
    band.extend(high.first());
    let (bottom, top) = bounds([&low, &high]);
    let (bottom, top) = (bottom - ROOM_BELOW * (top - bottom), top + ROOM_ABOVE * (top - bottom));
    let (left, right) = (measured[0].0, measured[measured.len() - 1].0);
    let mut traces = vec![Trace::new(Pen::Band, band)];
    let mut notes = Vec::new();
    // Nothing is known of the terms at times that are left out.
    let from = analysis.from_s.map_or(left, f64::log10);
    for coefficient in analysis.coefficients.iter().filter(|coefficient| coefficient.is_resolved()) {
        let line = asymptote(analysis, coefficient, (from, right), bottom + LABEL / HEIGHT * (top - bottom));
        notes.extend(label(analysis, coefficient, &line, (left, right)));
        traces.push(Trace::new(Pen::Asymptote, line));
    }
    if analysis.from_s.is_some() {
        traces.push(Trace::new(Pen::Axis, vec![(from, bottom), (from, top)]));
        let half = 0.5 * LETTER * LEFT_OUT.len() as f64;
        let knee = (from - left) / (right - left) * PANEL_WIDTH;
        let shift = ((knee - half).max(half) - knee, -LETTER);
        notes.push(Note { at: (from, bottom), shift, pen: Pen::Text, text: LEFT_OUT.to_owned() });
    }
    let fitted = |place: f64| (place, (analysis.fit.variance(10f64.powf(place)).sqrt() / unit.si).log10());
    let fit: Points = places((from, right)).map(fitted).collect();
    traces.extend(within(&fit, (bottom, top)).map(|part| Trace::new(Pen::Fit, part.to_vec())));
    traces.push(Trace::new(Pen::Computed, measured));
    let caption = format!("Allan deviation [{}]", unit.name);
    let mut panel = Panel::new(caption, Axis::decades(bottom, top, 6), HEIGHT, traces);
    panel.notes = notes;
    let x = Axis::decades(left, right, 8);
    Drawing { width: WIDTH, left: LEFT, x, x_label: "averaging time [s]".to_owned(), panels: vec![panel] }
}

/// Logarithms of averaging time and of `value` in the unit of the axis.
fn curve(analysis: &Analysis, value: impl Fn(&Deviation) -> f64) -> Points {
    let unit = sheet::deviation(analysis.sensor);
    analysis.estimates.iter().map(|e| (e.tau_s.log10(), (value(e) / unit.si).log10())).collect()
}

/// The parts of a curve from low to high. A line from the end of one part to the begin of the next would go along the edge.
fn within(curve: &[(f64, f64)], (low, high): (f64, f64)) -> impl Iterator<Item = &[(f64, f64)]> {
    curve.split(move |point| !(low..=high).contains(&point.1)).filter(|part| !part.is_empty())
}

fn places((left, right): (f64, f64)) -> impl Iterator<Item = f64> {
    (0..=SMOOTH).map(move |k| left + (right - left) * k as f64 / SMOOTH as f64)
}

/// The line of one term, where the term matters and the line is above `bottom`.
fn asymptote(analysis: &Analysis, coefficient: &Coefficient, ends: (f64, f64), bottom: f64) -> Points {
    let unit = sheet::deviation(analysis.sensor);
    let at = |place: f64| {
        let tau_s = 10f64.powf(place);
        let deviation = coefficient.value * coefficient.term.shape(tau_s).sqrt();
        let is_seen = deviation > SHARE * analysis.fit.variance(tau_s).sqrt();
        is_seen.then_some((place, (deviation / unit.si).log10())).filter(|point| point.1 > bottom)
    };
    places(ends).filter_map(at).collect()
}

/// Label with the value of a term, on the empty side of its line. Its place is where the term makes most of the deviation,
/// otherwise the low end of the line.
fn label(
    analysis: &Analysis,
    coefficient: &Coefficient,
    line: &Points,
    (left, right): (f64, f64),
) -> Option<Note> {
    let term = coefficient.term;
    let share = |place: f64| {
        let tau_s = 10f64.powf(place);
        coefficient.value.powi(2) * term.shape(tau_s) / analysis.fit.variance(tau_s)
    };
    let main: Vec<f64> = line.iter().map(|point| point.0).filter(|place| share(*place) > 0.5).collect();
    let ends = [line.first()?, line.last()?];
    let lowest = if ends[0].1 < ends[1].1 { ends[0].0 } else { ends[1].0 };
    let wanted = main.get(main.len() / 2).copied().unwrap_or(lowest);
    let value = in_unit(coefficient.value, sheet::coefficient(analysis.sensor, term));
    let text = format!("{} {value}", term.letter());
    let half = 0.5 * LETTER * text.chars().count() as f64;
    let aside = match term {
        Term::Quantization | Term::RandomWalk => -half,
        Term::Flicker => 0.0,
        Term::RateRandomWalk | Term::Ramp => half,
    };
    let at = *line.iter().min_by(|a, b| (a.0 - wanted).abs().total_cmp(&(b.0 - wanted).abs()))?;
    // The text stays within the axes.
    let middle = (at.0 - left) / (right - left) * PANEL_WIDTH;
    let aside = (middle + aside).clamp(half, PANEL_WIDTH - half) - middle;
    Some(Note { at, shift: (aside, BELOW), pen: Pen::Text, text })
}

#[cfg(test)]
mod tests {
    use super::super::analysis::tests::made;
    use super::*;

    #[test]
    fn a_curve_that_leaves_the_diagram_is_interrupted() {
        let curve: Points = [0.5, 2.0, -1.0, 0.2, 0.8, 1.5].into_iter().map(|y| (0.0, y)).collect();
        let parts: Vec<usize> = within(&curve, (0.0, 1.0)).map(<[_]>::len).collect();
        assert_eq!(parts, [1, 2]);
    }

    #[test]
    fn times_that_are_left_out_are_marked() {
        let mut log = made(20_000, 0.0);
        let four = |values: &[f64]| 0.25 * values.iter().sum::<f64>();
        log.series[0].increments = log.series[0].increments.windows(4).map(four).collect();
        log.pieces = vec![log.series[0].increments.len()];
        let analysis = &Analysis::of_log(&log).unwrap()[0];
        let panel = &drawing(analysis).panels[0];
        let knee = panel.traces.iter().find(|trace| trace.pen == Pen::Axis).unwrap();
        let from = analysis.from_s.unwrap().log10();
        assert_eq!(knee.points, [(from, panel.y.low), (from, panel.y.high)]);
        assert!(panel.notes.iter().any(|note| note.text == LEFT_OUT));
    }

    #[test]
    fn only_what_is_resolved_has_an_asymptote() {
        let analysis = &Analysis::of_log(&made(20_000, 0.0)).unwrap()[0];
        let drawing = drawing(analysis);
        let panel = &drawing.panels[0];
        let pens: Vec<Pen> = panel.traces.iter().map(|trace| trace.pen).collect();
        assert_eq!(pens, [Pen::Band, Pen::Asymptote, Pen::Fit, Pen::Computed]);
        // N = 1e-5 rad/√s is 0.0344 °/√h.
        assert!(
            panel.notes.len() == 1 && panel.notes[0].text.starts_with("N 0.034"),
            "{}",
            panel.notes[0].text
        );
        let line = &panel.traces[1].points;
        let slope = (line[90].1 - line[10].1) / (line[90].0 - line[10].0);
        assert!((slope + 0.5).abs() < 1e-9, "{slope}");
        for trace in &panel.traces {
            let is_inside = |(x, y): &(f64, f64)| {
                (drawing.x.low..=drawing.x.high).contains(x) && (panel.y.low..=panel.y.high).contains(y)
            };
            assert!(trace.points.iter().all(is_inside), "{:?}", trace.pen);
        }
    }
}
