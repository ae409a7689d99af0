//! The table at the top of the page: the main figures, a row for each run.

use maud::{Markup, html};

use crate::drawing::document::table;
use crate::report::run::Run;
use crate::report::sentence::is_rounding;
use crate::units::{self, time_text, with_unit};

/// A column of the table: its title, and its figure of a run, `None` if the run has none.
struct Column {
    title: &'static str,
    value: fn(&Run) -> Option<String>,
}

/// Titles of the columns with a sentence.
const SENSORS: &str = "Sensor errors";
const FAILURES: &str = "Failures";

const COLUMNS: [Column; 10] = [
    Column { title: "Motion", value: |run| text(run, "motion") },
    Column { title: "Time flown", value: |run| Some(time_text(run.duration_s())) },
    Column { title: SENSORS, value: sensors },
    Column { title: FAILURES, value: failures },
    Column { title: "Largest position error", value: position },
    Column {
        title: "Largest velocity error",
        value: |run| text(run, "max_velocity_m_s").filter(|_| !is_rounding(run)),
    },
    Column { title: "R50", value: radial_error_rate },
    Column { title: "Largest difference from the error equations, position", value: model_difference },
    Column { title: "Simulator’s own error", value: own_error },
    Column { title: "Time per step", value: |run| text(run, "ns_per_step") },
];

/// The table, with the meaning of its columns below.
pub fn overview(runs: &[Run]) -> Markup {
    let is_used = |column: &&Column| runs.iter().any(|run| (column.value)(run).is_some());
    let columns: Vec<&Column> = COLUMNS.iter().filter(is_used).collect();
    let heads = ["Run"].into_iter().chain(columns.iter().map(|column| column.title));
    let heads = heads.map(str::to_owned).collect();
    let row = |(place, run): (usize, &Run)| {
        let name = html! {
            a href={ "#run-" (place + 1) } { (run.title()) }
            @if run.title() != run.name { " " code { (run.name) } }
        };
        (name, html! { @for column in &columns { (cell(column, run)) } })
    };
    html! {
        section {
            h2 { @if runs.len() > 1 { "The runs" } @else { "In figures" } }
            div.table tabindex="0" {
                (table(Some("runs"), heads, runs.iter().enumerate().map(row)))
            }
            p.source {
                "Errors: navigation minus truth; the error equations compute them independently. "
                "R50: 0.8326 rms of horizontal position error / time since NAV, the CEP rate; for a navigation longer than a Schuler period, \
                 84.4 min, without updates. "
                "Simulator’s own error: horizontal position error at the end with ideal sensors, less the part that "
                "comes from inconsistent flight data. Time per step: truth, sensors, navigation and error equations, if they are on."
                @if runs.len() > 1 { " " a href="#comparison" { "All settings and figures of the runs" } "." }
            }
        }
    }
}

fn cell(column: &Column, run: &Run) -> Markup {
    match (column.value)(run) {
        Some(value) => {
            html! { td.sensors[[SENSORS, FAILURES].contains(&column.title)] data-label=(column.title) { (value) } }
        }
        None => html! { td.none { "–" } },
    }
}

fn text(run: &Run, key: &str) -> Option<String> {
    run.summary.row(key).map(crate::report::summary::Row::text)
}

/// Errors of the sensors in words; "none" if there are no errors.
pub fn sensors(run: &Run) -> Option<String> {
    match (run.summary.value("gyro_text")?, run.summary.value("accel_text")?) {
        ("none", "none") => Some("none".to_owned()),
        (gyros, accelerometers) => Some(format!("gyros: {gyros}; accelerometers: {accelerometers}")),
    }
}

/// Failures of the sensors in words, numbered if there are several.
pub fn failures(run: &Run) -> Option<String> {
    text(run, "failures_text").filter(|text| text != "none")
}

fn position(run: &Run) -> Option<String> {
    if is_rounding(run) { Some("no error beyond rounding".to_owned()) } else { text(run, "max_position_m") }
}

fn radial_error_rate(run: &Run) -> Option<String> {
    text(run, "r50_nmi_h").filter(|text| text != "none" && !is_rounding(run))
}

fn model_difference(run: &Run) -> Option<String> {
    run.model.as_ref()?;
    text(run, "max_model_difference_position_m").filter(|_| !is_rounding(run))
}

/// Horizontal closure less the part of the flight data; `None` if there are other errors.
fn own_error(run: &Run) -> Option<String> {
    let is_none =
        |key: &str| run.summary.value(key).is_some_and(|text| text.split(':').next() == Some("none"));
    let may_lack = |key: &str| run.summary.value(key).is_none() || is_none(key);
    if !["gyro_text", "accel_text", "start_text"].into_iter().all(is_none)
        || !["mounting_text", "gravity_text", "failures_text", "updates_text"].into_iter().all(may_lack)
    {
        return None;
    }
    let own = |axis: &str| {
        let figure = |what: &str| run.summary.number(&format!("{what}_position_{axis}_m"));
        Some(figure("closure")? - figure("host")?)
    };
    Some(with_unit(own("east")?.hypot(own("north")?), units::LENGTH))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::run::tests::made;
    use crate::report::summary::Row;

    fn with(rows: &[(&str, &str, &str)]) -> Run {
        let mut run =
            made(3, |name, _| if name.starts_with("navigation_error_position") { 1.0 } else { 0.0 });
        run.summary.rows.extend(rows.iter().map(|(key, value, unit)| Row::made(key, value, unit)));
        run
    }

    #[test]
    fn the_simulators_own_error_is_that_of_ideal_sensors() {
        let ideal = [
            ("gyro_text", "none", ""),
            ("accel_text", "none", ""),
            ("start_text", "none: true position, velocity and attitude", ""),
            ("closure_position_east_m", "0.005", "m"),
            ("closure_position_north_m", "0.001", "m"),
            ("host_position_east_m", "0.002", "m"),
            ("host_position_north_m", "-0.003", "m"),
        ];
        assert_eq!(own_error(&with(&ideal)).as_deref(), Some("5.000 mm"));
        assert_eq!(own_error(&with(&ideal[1..])), None);
        let disturbed = [&ideal[..], &[("gravity_text", "anomaly 5 mGal", "")]].concat();
        assert_eq!(own_error(&with(&disturbed)), None);
        assert_eq!(sensors(&with(&ideal)).as_deref(), Some("none"));
    }

    #[test]
    fn sensor_errors_are_reported_as_the_summary_has_them() {
        let run = with(&[("gyro_text", "bias 0.01 deg/h", ""), ("accel_text", "none", "")]);
        assert_eq!(sensors(&run).as_deref(), Some("gyros: bias 0.01 deg/h; accelerometers: none"));
        assert_eq!(sensors(&with(&[])), None);
    }

    #[test]
    fn rates_are_reported_where_the_summary_has_them() {
        let run = with(&[("r50_nmi_h", "none", "")]);
        assert_eq!(radial_error_rate(&run), None);
        let long = with(&[("r50_nmi_h", "0.25", "nmi/h")]);
        let html = overview(&[run, long]).into_string();
        assert!(html.contains("<td class=\"none\">–</td>") && html.contains("1.234 km"));
        assert!(
            !html.contains("Failures") && !html.contains("error equations, position"),
            "columns without a value"
        );
    }

    #[test]
    fn rounding_is_not_reported_as_figures() {
        let mut run = made(3, |_, _| 0.5e-9);
        run.summary.rows.push(Row::made("max_velocity_m_s", "1e-9", "m/s"));
        let html = overview(&[run]).into_string();
        assert!(html.contains("no error beyond rounding") && !html.contains("1.234 km"));
        assert!(!html.contains("m/s"), "{html}");
    }
}
