//! The figures of a run in their order, and those of radial error and sensor errors.

use crate::drawing::axis::{Axis, TimeAxis};
use crate::drawing::figure::Figure;
use crate::drawing::pen::Pen;
use crate::drawing::plot::{Drawing, Trace, WIDTH};
use crate::drawing::scales::{TIME_TICKS, panel, time_label};
use crate::drawing::series::{Points, block_means, magnitude, mean, straight_line, thinned};
use crate::failure::Failure;
use crate::report::errors::{self, ATTITUDE, POSITION, VELOCITY};
use crate::report::run::{Run, SENSOR_AXES};
use crate::report::spectrum;
use crate::report::trajectory;
use crate::units::{self, Unit, fitting, significant, time_text, with_unit};

/// The radial error is fitted from here on [s], as the library's accuracy figures are.
const FIT_FROM_S: f64 = 300.0;

/// The line of 1 nmi/h is drawn where the largest error is within this factor of it.
const COMPARABLE: f64 = 30.0;

/// Means drawn over noisy sensor errors.
const MEANS: usize = 100;

/// All figures of `run`, in reading order; without the ones that would be empty.
pub fn figures(run: &Run) -> Result<Vec<Figure>, Failure> {
    let mut figures = vec![trajectory::figure(run)?];
    for quantity in [&ATTITUDE, &VELOCITY, &POSITION] {
        figures.push(errors::figure(run, quantity)?);
    }
    figures.push(radial(run)?);
    figures.extend(spectrum::figure(run)?);
    figures.extend(sensor(run, "Gyro errors", &run.gyro_error_rad_s, units::DEG_PER_HOUR)?);
    figures.extend(sensor(run, "Accelerometer errors", &run.accel_error_m_s2, units::MICRO_G)?);
    Ok(figures)
}

/// `values` over time, thinned, in the units of the axes.
pub fn over_time(run: &Run, time: &TimeAxis, values: &[f64], unit: Unit) -> Points {
    scaled(thinned(&run.time_s, values), time, unit)
}

fn scaled(points: Points, time: &TimeAxis, unit: Unit) -> Points {
    points.into_iter().map(|(t, y)| (t / time.seconds, y / unit.si)).collect()
}

/// The straight line through the radial error [m], [m/s].
struct Growth {
    from_s: f64,
    level: f64,
    slope: f64,
}

/// None for flights that end before the line would begin. The slope is that of the summary, which is of every second where the
/// records are fewer: one figure, one number.
fn growth(run: &Run, radius: &[f64]) -> Option<Growth> {
    let window = run.time_s.iter().position(|t| *t >= FIT_FROM_S)?;
    let (times, radius) = (&run.time_s[window..], &radius[window..]);
    let (level, slope) = match run.summary.value("slope_nmi_h") {
        Some(_) => {
            let slope = run.summary.number("slope_nmi_h")? * units::NMI_PER_HOUR.si;
            (mean(radius) - slope * mean(times), slope)
        }
        None if times.len() > 1 => straight_line(times, radius),
        None => return None,
    };
    Some(Growth { from_s: times[0], level, slope })
}

/// Horizontal position error with its straight line and that of 1 nmi/h.
fn radial(run: &Run) -> Result<Figure, Failure> {
    let title = "Radial position error".to_owned();
    let time = Axis::time(run.duration_s(), TIME_TICKS);
    let [east, north, _] = &run.errors.position_m;
    let radius: Vec<f64> = east.iter().zip(north).map(|(east, north)| east.hypot(*north)).collect();
    let largest = magnitude(&radius);
    let unit = fitting(largest, units::LENGTH);

    let line = |(level, slope): (f64, f64), from: f64, to: f64| {
        scaled(vec![(from, level + slope * from), (to, level + slope * to)], &time, unit)
    };
    let end = run.duration_s();
    let mut traces = vec![Trace::new(Pen::Computed, over_time(run, &time, &radius, unit))];
    let mut legend = vec![(Pen::Computed, "horizontal distance from truth".to_owned())];
    let rate = match growth(run, &radius) {
        Some(Growth { from_s, level, slope }) => {
            let rate =
                format!("{} {}", significant(slope / units::NMI_PER_HOUR.si), units::NMI_PER_HOUR.name);
            let words = format!("least-squares line from {} on, slope {rate}", time_text(from_s));
            traces.push(Trace::new(Pen::Fit, line((level, slope), from_s, end)));
            legend.push((Pen::Fit, words));
            rate
        }
        None => format!("none, it counts from {} on", time_text(FIT_FROM_S)),
    };
    let mile = units::NMI_PER_HOUR.si;
    if largest < COMPARABLE * mile * end && mile * end < COMPARABLE * largest {
        traces.push(Trace::new(Pen::NauticalMile, line((0.0, mile), 0.0, end.min(1.05 * largest / mile))));
        legend.push((Pen::NauticalMile, "1 nmi/h".to_owned()));
    }
    let note = format!("Largest: {}. Slope of the straight line: {rate}.", with_unit(largest, units::LENGTH));
    let panels = vec![panel(format!("radial position error [{}]", unit.name), 260.0, 6, traces)];
    let drawing = Drawing { width: WIDTH, x_label: time_label(&time), x: time.axis, panels };
    let svg = drawing.svg(&format!("{title} over time. {note}"))?;
    Ok(Figure { title, legend, drawings: vec![svg], note })
}

/// Errors of a triad of sensors, the records and their running mean; none where there are no errors.
fn sensor(run: &Run, title: &str, values: &[Vec<f64>; 3], unit: Unit) -> Result<Option<Figure>, Failure> {
    if values.iter().all(|values| magnitude(values) == 0.0) {
        return Ok(None);
    }
    let time = Axis::time(run.duration_s(), TIME_TICKS);
    // Each record has the mean since the one before, the first none.
    let (time_s, values) = (&run.time_s[1..], values.each_ref().map(|values| &values[1..]));
    let panels = SENSOR_AXES.iter().zip(values).map(|(axis, values)| {
        let means = scaled(block_means(time_s, values, MEANS), &time, unit);
        let traces = vec![
            Trace::new(Pen::Record, scaled(thinned(time_s, values), &time, unit)),
            Trace::new(Pen::Computed, means),
        ];
        panel(format!("{axis} [{}]", unit.name), 100.0, 5, traces)
    });
    let drawing =
        Drawing { width: WIDTH, x_label: time_label(&time), panels: panels.collect(), x: time.axis };
    let stretch = time_text(run.duration_s() / MEANS as f64);
    let legend = vec![
        (Pen::Record, "measured minus ideal, each record".to_owned()),
        (Pen::Computed, format!("mean over {stretch}")),
    ];
    let [x, y, z] = values.map(|values| significant(mean(values) / unit.si));
    let note = format!("Mean over the run: x {x}, y {y}, z {z} {}.", unit.name);
    let svg = drawing.svg(&format!("{title} over time. {note}"))?;
    Ok(Some(Figure { title: title.to_owned(), legend, drawings: vec![svg], note }))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::run::tests::made;

    fn titles(run: &Run) -> Vec<String> {
        figures(run).unwrap().into_iter().map(|figure| figure.title).collect()
    }

    #[test]
    fn a_run_of_zeros_still_has_its_figures() {
        let titles = titles(&made(3, |_, _| 0.0));
        assert_eq!(titles.len(), 5, "trajectory, three errors, radial: {titles:?}");
    }

    #[test]
    fn sensor_errors_and_spectrum_come_where_there_is_something() {
        let run = made(3000, |name, t| match name {
            "gyro_error_z_rad_s" => 1e-8,
            "navigation_error_velocity_east_m_s" => (t / 806.0).sin(),
            _ => 0.0,
        });
        let titles = titles(&run);
        assert!(
            titles.iter().any(|title| title.starts_with("Spectrum"))
                && titles.contains(&"Gyro errors".into())
        );
        assert!(!titles.contains(&"Accelerometer errors".into()));
    }

    #[test]
    fn the_slope_is_that_of_the_summary() {
        let mut run = made(400, |name, t| if name == "navigation_error_position_north_m" { t } else { 0.0 });
        let row = crate::report::summary::Row {
            key: "slope_nmi_h".into(),
            value: "0.6178".into(),
            unit: "nmi/h".into(),
            label: String::new(),
        };
        run.summary.rows.push(row);
        assert!(radial(&run).unwrap().note.ends_with("0.6178 nmi/h."));
        if let Some(row) = run.summary.rows.last_mut() {
            (row.value, row.unit) = ("none".into(), String::new());
        }
        assert!(radial(&run).unwrap().note.contains("Slope of the straight line: none"));
        let short = radial(&made(20, |_, t| t)).unwrap();
        assert!(
            short.note.contains("none, it counts from")
                && short.legend.iter().all(|(pen, _)| *pen != Pen::Fit)
        );
    }

    #[test]
    fn the_slope_is_told_in_nautical_miles_an_hour() {
        let run =
            made(
                400,
                |name, t| if name == "navigation_error_position_north_m" { 1852.0 / 3600.0 * t } else { 0.0 },
            );
        let figure = radial(&run).unwrap();
        assert!(figure.note.ends_with("1.000 nmi/h."), "{}", figure.note);
        assert!(figure.legend.iter().any(|(pen, _)| *pen == Pen::NauticalMile));
    }
}
