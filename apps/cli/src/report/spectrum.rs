//! Spectrum of the horizontal velocity errors: where the Schuler, Foucault and daily oscillations show.

use std::f64::consts::TAU;

use realfft::RealFftPlanner;
use sins::errors::SCHULER_S;

use crate::drawing::axis::Axis;
use crate::drawing::figure::Figure;
use crate::drawing::pen::Pen;
use crate::drawing::plot::{Drawing, LEFT, Mark, PANEL_WIDTH, Panel, Trace, WIDTH};
use crate::drawing::series::{Points, mean, straight_line};
use crate::failure::Failure;
use crate::report::run::Run;
use crate::units::{SPEED, fitting, time_text, with_unit};

/// One day [s].
const DAY_S: f64 = 86_400.0;

/// A spectrum is drawn for runs longer than this number of Schuler periods.
const LEAST_PERIODS: f64 = 3.0;

/// Smallest number of records for which a spectrum is drawn.
const LEAST_RECORDS: usize = 64;

/// The shortest period that is drawn [s], unless the records are farther apart.
const SHORTEST_S: f64 = 300.0;

/// Number of decades that are drawn below the highest line.
const DECADES: f64 = 5.0;

/// Number of points of a drawn line. Each is the highest amplitude of a stretch of the axis.
const STRETCHES: usize = 500;

/// Factor by which zeros lengthen the record, so that the peak of a line between two frequencies is found.
const PADDING: usize = 4;

/// Smallest distance of two ticks of the period [drawing units].
const TICK_ROOM: f64 = 66.0;

/// An oscillation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpectralLine {
    pub period_s: f64,
    /// Amplitude of a sinusoid of this period [unit of the record].
    pub amplitude: f64,
}

/// Expected periods, their mark in the drawing and their text in the legend.
struct Expected {
    pen: Pen,
    periods_s: Vec<f64>,
    mark: &'static str,
    text: String,
}

/// Amplitudes of the record (`time_s`, `values`) by decreasing period: straight line removed, Hann window,
/// A(f) = 2 |Σ w v exp(-i 2π f t)| / Σ w.
pub fn spectrum(time_s: &[f64], values: &[f64]) -> Result<Vec<SpectralLine>, Failure> {
    let (level, slope) = straight_line(time_s, values);
    let (values, step) = uniform(time_s, values);
    let count = values.len();
    let window = |k: usize| 0.5 - 0.5 * (TAU * k as f64 / count as f64).cos();
    let transform = RealFftPlanner::<f64>::new().plan_fft_forward(count * PADDING);
    let mut input = transform.make_input_vec();
    for (k, (place, value)) in input.iter_mut().zip(&values).enumerate() {
        *place = window(k) * (value - level - slope * k as f64 * step);
    }
    let mut output = transform.make_output_vec();
    transform
        .process(&mut input, &mut output)
        .map_err(|error| Failure::new(format!("the spectrum could not be computed: {error}")))?;
    let weight: f64 = (0..count).map(window).sum();
    let length_s = (count * PADDING) as f64 * step;
    let line = |(k, value): (usize, &realfft::num_complex::Complex<f64>)| SpectralLine {
        period_s: length_s / k as f64,
        amplitude: 2.0 * value.norm() / weight,
    };
    Ok(output.iter().enumerate().skip(1).map(line).collect())
}

/// The same number of values at equal intervals, linearly interpolated between the records, and their interval [s].
fn uniform(time_s: &[f64], values: &[f64]) -> (Vec<f64>, f64) {
    let count = values.len();
    let step = (time_s[count - 1] - time_s[0]) / (count - 1) as f64;
    let mut right = 1;
    let at = |k: usize| {
        let t = time_s[0] + k as f64 * step;
        while right + 1 < count && time_s[right] < t {
            right += 1;
        }
        let share = (t - time_s[right - 1]) / (time_s[right] - time_s[right - 1]);
        values[right - 1] + share.clamp(0.0, 1.0) * (values[right] - values[right - 1])
    };
    ((0..count).map(at).collect(), step)
}

/// The spectrum with the expected periods; `None` for short runs and for runs without errors.
pub fn figure(run: &Run) -> Result<Option<Figure>, Failure> {
    let duration_s = run.duration_s();
    if duration_s <= LEAST_PERIODS * SCHULER_S || run.time_s.len() < LEAST_RECORDS {
        return Ok(None);
    }
    let [east, north, _] = &run.errors.velocity_m_s;
    let (east, north) = (spectrum(&run.time_s, east)?, spectrum(&run.time_s, north)?);
    let (low, high) = (SHORTEST_S.max(2.0 * run.spacing_s()).log10(), duration_s.log10());
    let (peak_east, peak_north) = (strongest(&east, low, high), strongest(&north, low, high));
    let peak = peak_east.amplitude.max(peak_north.amplitude);
    if peak <= 0.0 {
        return Ok(None);
    }
    let unit = fitting(peak, SPEED);
    let top = (peak / unit.si).log10() + 0.3;
    let bottom = top - DECADES;
    let mut traces = Vec::new();
    for (pen, lines) in [(Pen::East, &east), (Pen::North, &north)] {
        let parts = above(envelope(lines, low, high, unit.si), bottom);
        traces.extend(parts.into_iter().map(|points| Trace::new(pen, points)));
    }
    let caption = format!("amplitude of velocity error [{}]", unit.name);
    let mut panel = Panel::new(caption, Axis::decades(bottom, top, 6), 260.0, traces);

    let mut legend = vec![(Pen::East, "east".to_owned()), (Pen::North, "north".to_owned())];
    for expected in expected(duration_s, mean(&run.truth.latitude_rad)) {
        for at in
            expected.periods_s.iter().map(|period| period.log10()).filter(|at| (low..=high).contains(at))
        {
            panel.marks.push(Mark { at, pen: expected.pen, text: expected.mark.to_owned() });
        }
        legend.push((expected.pen, expected.text));
    }
    let note = format!(
        "Strongest line: east {} at {}, north {} at {}. Straight line removed, Hann window; lines closer than {:.3} \
         cycles an hour are not resolved.",
        with_unit(peak_east.amplitude, SPEED),
        time_text(peak_east.period_s),
        with_unit(peak_north.amplitude, SPEED),
        time_text(peak_north.period_s),
        2.0 * 3600.0 / duration_s,
    );
    let x = Axis::periods(low, high, (high - low) * TICK_ROOM / PANEL_WIDTH);
    let drawing = Drawing { width: WIDTH, left: LEFT, x, x_label: "period".to_owned(), panels: vec![panel] };
    let title = "Spectrum of the horizontal velocity errors";
    Figure::new(title, ", amplitude over period", legend, &drawing, note).map(Some)
}

/// The strongest line between the logarithms `low` and `high` of its period.
fn strongest(lines: &[SpectralLine], low: f64, high: f64) -> SpectralLine {
    let shown = lines.iter().filter(|line| (low..=high).contains(&line.period_s.log10()));
    let none = SpectralLine { period_s: 0.0, amplitude: 0.0 };
    shown.fold(none, |most, line| if line.amplitude > most.amplitude { *line } else { most })
}

/// Periods of the errors that physics predicts for a vehicle at rest at the latitude.
fn expected(duration_s: f64, latitude_rad: f64) -> Vec<Expected> {
    let schuler = "Schuler period, 84.4 min".to_owned();
    let mut all =
        vec![Expected { pen: Pen::Schuler, periods_s: vec![SCHULER_S], mark: "84.4 min", text: schuler }];
    if let Some((foucault_s, short, long)) = foucault(latitude_rad) {
        let [foucault, first, second] = [foucault_s, short, long].map(time_text);
        let text =
            format!("Schuler split by Foucault ({foucault} at the mean latitude): {first} and {second}");
        all.push(Expected { pen: Pen::Foucault, periods_s: vec![short, long], mark: "", text });
    }
    if duration_s >= DAY_S {
        all.push(Expected { pen: Pen::Day, periods_s: vec![DAY_S], mark: "24 h", text: "24 h".to_owned() });
    }
    all
}

/// Foucault period 24 h / |sin L|, and the two periods into which it splits Schuler's period [s]; `None` near the equator.
fn foucault(latitude_rad: f64) -> Option<(f64, f64, f64)> {
    let sine = latitude_rad.sin().abs();
    if sine < 0.02 {
        return None;
    }
    let frequency = sine / DAY_S;
    Some((1.0 / frequency, 1.0 / (1.0 / SCHULER_S + frequency), 1.0 / (1.0 / SCHULER_S - frequency)))
}

/// Logarithms of period and amplitude for periods between `low` and `high`: the highest amplitude of each stretch.
fn envelope(lines: &[SpectralLine], low: f64, high: f64, unit: f64) -> Points {
    let mut points: Vec<(usize, (f64, f64))> = Vec::new();
    for line in lines.iter().rev() {
        let (x, y) = (line.period_s.log10(), (line.amplitude / unit).log10());
        if !(low..=high).contains(&x) {
            continue;
        }
        let stretch = ((x - low) / (high - low) * STRETCHES as f64) as usize;
        match points.last_mut() {
            Some((last, point)) if *last == stretch => {
                if y > point.1 {
                    *point = (x, y);
                }
            }
            _ => points.push((stretch, (x, y))),
        }
    }
    points.into_iter().map(|(_, point)| point).collect()
}

/// The parts of a line above `bottom`, each with its ends at `bottom`.
fn above(points: Points, bottom: f64) -> Vec<Points> {
    let mut parts: Vec<Points> = vec![Vec::new()];
    for (x, y) in points {
        let point = (x, y.max(bottom));
        match parts.last_mut() {
            Some(part) if y > bottom || part.last().is_some_and(|last| last.1 > bottom) => part.push(point),
            _ => parts.push(vec![point]),
        }
    }
    parts.retain(|part| part.len() > 1);
    parts
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;

    /// A Schuler oscillation with bias and drift in 48 h: the highest line is at 84.4 min within a padded bin. A Hann window at d
    /// bins from its middle has the gain sin(πd) / (πd (1 - d²)), d ≤ 1/8 with fourfold padding. The leakage from the line at
    /// negative frequency, 68 bins away, falls with the cube of the distance: 1 / (π 68³) = 1e-6.
    #[test]
    fn a_schuler_line_is_found() {
        let time_s: Vec<f64> = (0..=17_280).map(|k| f64::from(k) * 10.0).collect();
        let values: Vec<f64> =
            time_s.iter().map(|t| 0.3 + 1e-6 * t + 0.5 * (TAU * t / SCHULER_S + 0.7).cos()).collect();
        let lines = spectrum(&time_s, &values).unwrap();
        let highest = lines.iter().max_by(|a, b| a.amplitude.total_cmp(&b.amplitude)).unwrap();
        let bin_hz = 1.0 / (PADDING as f64 * 172_800.0);
        assert!((1.0 / highest.period_s - 1.0 / SCHULER_S).abs() <= bin_hz, "{highest:?}");
        let off = 0.5 / PADDING as f64;
        let least = (PI * off).sin() / (PI * off * (1.0 - off * off));
        assert!((0.5 * least - 1e-6..0.5 + 1e-6).contains(&highest.amplitude), "{highest:?}");
    }

    #[test]
    fn uneven_records_are_put_on_even_times() {
        let time_s = [0.0, 1.0, 1.5, 4.0];
        let (values, step) = uniform(&time_s, &time_s.map(|t| 2.0 * t + 1.0));
        assert!((step - 4.0 / 3.0).abs() < f64::EPSILON);
        for (k, value) in values.iter().enumerate() {
            assert!((value - (2.0 * k as f64 * step + 1.0)).abs() < 16.0 * f64::EPSILON);
        }
    }

    #[test]
    fn a_line_is_cut_at_the_bottom() {
        let line =
            [3.0, 1.0, -4.0, -5.0, -6.0, 2.0, 4.0].iter().enumerate().map(|(k, y)| (k as f64, *y)).collect();
        let parts = above(line, 0.0);
        assert_eq!(
            parts,
            [vec![(0.0, 3.0), (1.0, 1.0), (2.0, 0.0)], vec![(4.0, 0.0), (5.0, 2.0), (6.0, 4.0)]]
        );
    }

    #[test]
    fn foucault_splits_the_schuler_line() {
        let (period, short, long) = foucault(30f64.to_radians()).unwrap();
        assert!((period / 3600.0 - 48.0).abs() < 1e-9 && short < SCHULER_S && SCHULER_S < long);
        assert!((1.0 / short - 1.0 / long - 2.0 / period).abs() < 1e-18);
        assert_eq!(foucault(0.0), None);
    }
}
