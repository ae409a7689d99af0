//! The radial position error over time, with its growth.

use crate::drawing::figure::Figure;
use crate::drawing::pen::Pen;
use crate::drawing::plot::Trace;
use crate::drawing::scales::{line, over_time, panel, scaled, time_axis};
use crate::drawing::series::{magnitude, mean, straight_line};
use crate::failure::Failure;
use crate::report::figures::LOWER;
use crate::report::run::Run;
use crate::units::{self, fitting, significant, time_text, with_unit};

/// Time since NAV from which the radial error is fitted [s], the same as in the library's accuracy figures.
const FIT_FROM_S: f64 = 300.0;

/// The line of 1 nmi/h is drawn if the ratio of the largest error and the line is within this factor.
const COMPARABLE: f64 = 30.0;

/// The straight line through the radial error [m], [m/s].
struct Growth {
    from_s: f64,
    until_s: f64,
    level: f64,
    slope: f64,
}

/// The straight line; `None` for flights that end before its beginning. The slope is taken from the summary, so that page and
/// summary show the same number. The summary's slope is computed from each second if the records are farther apart.
fn growth(run: &Run, radius: &[f64]) -> Option<Growth> {
    let number = |key: &str, default: f64| run.summary.number(key).unwrap_or(default);
    let [from_s, until_s] = [number("window_start_s", FIT_FROM_S), number("nav_until_s", f64::INFINITY)];
    let end = run.time_s.partition_point(|t| *t <= until_s);
    let window = run.time_s[..end].iter().position(|t| *t >= from_s)?;
    let (times, radius) = (&run.time_s[window..end], &radius[window..end]);
    let (level, slope) = match run.summary.value("slope_nmi_h") {
        Some(_) => {
            let slope = run.summary.number("slope_nmi_h")? * units::NMI_PER_HOUR.si;
            (mean(radius) - slope * mean(times), slope)
        }
        None if times.len() > 1 => straight_line(times, radius),
        None => return None,
    };
    Some(Growth { from_s: times[0], until_s: *times.last()?, level, slope })
}

/// Horizontal position error with its straight line and the line of 1 nmi/h.
pub fn figure(run: &Run) -> Result<Figure, Failure> {
    let time = time_axis(run.duration_s());
    let [east, north, _] = &run.errors.position_m;
    let radius: Vec<f64> = east.iter().zip(north).map(|(east, north)| east.hypot(*north)).collect();
    let largest = magnitude(&radius);
    let unit = fitting(largest, units::LENGTH);

    let straight = |(level, slope): (f64, f64), from: f64, to: f64| {
        scaled(vec![(from, level + slope * from), (to, level + slope * to)], &time, unit)
    };
    let end = run.duration_s();
    let mut traces = vec![Trace::new(Pen::Computed, line(&run.time_s, &radius, &time, unit))];
    let mut legend = vec![(Pen::Computed, "horizontal distance from truth".to_owned())];
    let rate = match growth(run, &radius) {
        Some(Growth { from_s, until_s, level, slope }) => {
            let rate =
                format!("{} {}", significant(slope / units::NMI_PER_HOUR.si), units::NMI_PER_HOUR.name);
            let text = format!("least-squares line from {} on, slope {rate}", time_text(from_s));
            traces.push(Trace::new(Pen::Fit, straight((level, slope), from_s, until_s)));
            legend.push((Pen::Fit, text));
            rate
        }
        None => format!("none, it counts from {} after NAV on", time_text(FIT_FROM_S)),
    };
    let mile = units::NMI_PER_HOUR.si;
    if largest < COMPARABLE * mile * end && mile * end < COMPARABLE * largest {
        traces
            .push(Trace::new(Pen::NauticalMile, straight((0.0, mile), 0.0, end.min(1.05 * largest / mile))));
        legend.push((Pen::NauticalMile, "1 nmi/h".to_owned()));
    }
    let note = format!("Largest: {}. Slope of the straight line: {rate}.", with_unit(largest, units::LENGTH));
    let mut panels = [panel(format!("radial position error [{}]", unit.name), 260.0, 6, traces)];
    run.events.mark(&time, &mut panels);
    legend.extend(run.events.legend(&time));
    Figure::new(
        "Radial position error",
        " over time",
        legend,
        &over_time(time, panels.into()).of_height(LOWER),
        note,
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::run::tests::made;

    #[test]
    fn the_slope_is_that_of_the_summary() {
        let mut run = made(400, |name, t| if name == "navigation_error_position_north_m" { t } else { 0.0 });
        run.summary.rows.push(crate::report::summary::Row::made("slope_nmi_h", "0.6178", "nmi/h"));
        assert!(figure(&run).unwrap().note.ends_with("0.6178 nmi/h."));
        if let Some(row) = run.summary.rows.last_mut() {
            (row.value, row.unit) = ("none".into(), String::new());
        }
        assert!(figure(&run).unwrap().note.contains("Slope of the straight line: none"));
        let short = figure(&made(20, |_, t| t)).unwrap();
        assert!(
            short.note.contains("none, it counts from")
                && short.legend.iter().all(|(pen, _)| *pen != Pen::Fit)
        );
    }

    #[test]
    fn the_slope_is_reported_in_nautical_miles_an_hour() {
        let run =
            made(
                400,
                |name, t| if name == "navigation_error_position_north_m" { 1852.0 / 3600.0 * t } else { 0.0 },
            );
        let figure = figure(&run).unwrap();
        assert!(figure.note.ends_with("1.000 nmi/h."), "{}", figure.note);
        assert!(figure.legend.iter().any(|(pen, _)| *pen == Pen::NauticalMile));
    }
}
