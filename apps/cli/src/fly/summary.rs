//! The figures as a file: a row for each, with key, value, unit and label.

use nalgebra::Vector3;
use sins::errors::AccuracyFigures;
use sins::units::NMI_PER_HOUR;

use super::figures::Figures;
use super::shown::Reason;
use crate::failure::{Failure, printable};
use crate::planned;
use crate::rows;
use crate::rows::EAST_NORTH_UP;
use crate::units::six_digits;

/// Beginning of every summary.
pub const MARK: &str = "key,value,unit,label\nname,";

/// Number of bytes that no summary exceeds, unless its scene has hundreds of failures and updates.
pub const LONGEST: usize = 1 << 15;

/// Text of the file. A figure that does not exist has the value "none".
pub fn text(figures: &Figures) -> Result<String, Failure> {
    let mut summary = Rows(Vec::new());
    settings(figures, &mut summary);
    flight(figures, &mut summary);
    closure(figures, &mut summary);
    accuracy(figures, &mut summary);
    summary.text("library_version", env!("CARGO_PKG_VERSION"), "library version");
    rows::text(&["key", "value", "unit", "label"], &summary.0)
}

struct Rows(Vec<[String; 4]>);

impl Rows {
    fn add(&mut self, key: &str, value: String, unit: &str, label: &str) {
        self.0.push([key.to_owned(), value, unit.to_owned(), label.to_owned()]);
    }

    fn text(&mut self, key: &str, value: &str, label: &str) {
        self.add(key, printable(value), "", label);
    }

    fn number(&mut self, key: &str, value: f64, unit: &str, label: &str) {
        self.add(key, rows::number(value), unit, label);
    }

    fn whole(&mut self, key: &str, value: u64, label: &str) {
        self.add(key, value.to_string(), "", label);
    }

    fn axes(&mut self, key: &str, unit: &str, values: &Vector3<f64>, label: &str) {
        let (name, end) = key.split_once("{}").unwrap_or((key, ""));
        for (axis, value) in EAST_NORTH_UP.into_iter().zip(values) {
            self.number(&format!("{name}{axis}{end}"), *value, unit, &format!("{label}, {axis}"));
        }
    }
}

fn settings(figures: &Figures, rows: &mut Rows) {
    let (given, scene) = (figures.given, figures.scene());
    rows.text("name", figures.name, "name");
    rows.text("scene", &given.origin, "scene");
    rows.text("scene_text", &given.title, "scene in words");
    rows.text("motion", if scene.is_log() { "recorded" } else { "computed" }, "motion");
    for (key, label) in [
        ("scheme", "mechanization scheme"),
        ("frame", "navigation frame"),
        ("signal", "ideal signals"),
        ("earth", "ellipsoid"),
        ("gravity", "gravity model"),
        ("axes", "sensor axes"),
        ("vertical", "vertical channel"),
        ("error_model", "error differential equations"),
        ("subsamples", "subsamples of an update"),
        ("updates_per_sample", "updates in each sample interval"),
        ("seed", "random seed"),
        ("run", "Monte Carlo run number"),
    ] {
        let value = scene.value(&format!("options.{key}")).unwrap_or_default();
        rows.text(key, value.trim_matches('"'), label);
    }
    rows.number("rate_hz", figures.rate_hz(), "Hz", "sample rate (mean over the flight)");
    for (key, section, label) in [
        ("gyro_text", "gyro", "gyro errors"),
        ("accel_text", "accelerometer", "accelerometer errors"),
        ("altimeter_text", "altimeter", "altimeter errors"),
        ("mounting_text", "mounting", "mounting of the sensor block"),
        ("gravity_text", "gravity", "gravity disturbance"),
    ] {
        rows.text(key, &figures.set_in(section), label);
    }
    rows.text("start_text", &figures.start(), "initial errors");
    rows.text("failures_text", &planned::failures(scene), "failures");
    rows.text("updates_text", &figures.updates(), "updates by fixes");
    for (number, (at_s, every_s)) in (1..).zip(planned::times_of_updates(scene)) {
        for (key, time_s) in [("at", Some(at_s)), ("every", every_s)] {
            if let Some(time_s) = time_s {
                rows.number(
                    &format!("update_{number}_{key}_s"),
                    time_s,
                    "s",
                    &format!("update {number}, {key}"),
                );
            }
        }
    }
    for (number, (from_s, until_s)) in (1..).zip(planned::spans(scene)) {
        for (end, time_s) in [("from", Some(from_s)), ("until", until_s)] {
            if let Some(time_s) = time_s {
                let label = format!("failure {number}, {end}");
                rows.number(&format!("failure_{number}_{end}_s"), time_s, "s", &label);
            }
        }
    }
}

fn flight(figures: &Figures, rows: &mut Rows) {
    let flown = figures.flown;
    for (number, (from_s, state)) in (1..).zip(&flown.states) {
        rows.text(&format!("unit_{number}_state"), state.word(), &format!("state {number} of the unit"));
        rows.number(
            &format!("unit_{number}_from_s"),
            *from_s,
            "s",
            &format!("state {number} of the unit, from"),
        );
    }
    for (number, Reason { words, from_s, until_s }) in (1..).zip(&flown.reasons) {
        rows.text(
            &format!("unit_reason_{number}_text"),
            words,
            &format!("reason {number} for outputs that are not valid"),
        );
        for (end, time_s) in [("from", from_s), ("until", until_s)] {
            let label = format!("reason {number}, {end}");
            rows.number(&format!("unit_reason_{number}_{end}_s"), *time_s, "s", &label);
        }
    }
    if let Some(shown) = &flown.shown_at_end {
        rows.text("unit_end_text", shown, "what the unit shows at the end");
    }
    rows.number("duration_s", figures.accuracy.duration_s, "s", "simulated time");
    rows.whole("steps", flown.steps, "navigation steps (sample intervals)");
    let [gyro, accel] = flown.beyond_range;
    rows.whole("gyro_saturated_steps", gyro, "steps in which a gyro was beyond its range");
    rows.whole("accel_saturated_steps", accel, "steps in which an accelerometer was beyond its range");
    rows.number("ns_per_step", figures.ns_per_step(), "ns", "computing time of a step (wall clock)");
    let label = "stopped before the end of the flight (0: no, 1: yes)";
    rows.whole("interrupted", u64::from(figures.is_interrupted), label);
    rows.whole("records", flown.records, "records written");
    rows.whole("gaps", figures.given.gaps.count, "gaps in the log, which were bridged");
    rows.number("gap_longest_s", figures.given.gaps.longest_s, "s", "longest gap in the log");
    let label = "rows of the log that the smooth path was fitted to";
    rows.whole("log_rows", figures.given.rows_of_path().len() as u64, label);
    for (number, finding) in (1..).zip(&figures.given.findings) {
        rows.text(
            &format!("finding_{number}_text"),
            finding,
            &format!("finding {number} in the flight data"),
        );
    }
    for (key, value, unit, label, time_s) in figures.truth() {
        rows.number(key, value, unit, &format!("truth: {label}, at {} s", six_digits(time_s)));
    }
}

fn closure(figures: &Figures, rows: &mut Rows) {
    let (closure, trim) = (&figures.closure, &figures.trim);
    rows.axes("closure_position_{}_m", "m", &closure.position_n, "final position error (closure)");
    rows.axes("closure_velocity_{}_m_s", "m/s", &closure.velocity_n, "final velocity error (closure)");
    let label = "part of the final position error due to inconsistent flight data";
    rows.axes("host_position_{}_m", "m", &closure.host_position_n, label);
    let label = "part of the final velocity error due to inconsistent flight data";
    rows.axes("host_velocity_{}_m_s", "m/s", &closure.host_velocity_n, label);
    let label = "inconsistency of the flight data: largest displacement by velocity - by position in a step";
    rows.number("inconsistency_max_m", closure.inconsistency_max_m, "m", label);
    let label = "flight samples whose position contradicts their velocity";
    rows.whole("inconsistent_samples", closure.inconsistent_samples, label);
    rows.number("trim_rate_max_rad_s", trim.rate_rad_s, "rad/s", "largest trim of the closed loop, gyros");
    let label = "largest trim of the closed loop, accelerometers";
    rows.number("trim_force_max_m_s2", trim.force_m_s2, "m/s2", label);
}

fn accuracy(figures: &Figures, rows: &mut Rows) {
    let (accuracy, flown) = (&figures.accuracy, figures.flown);
    let rates = figures.rates().ok();
    for (key, value_m_s, label) in [
        (
            "rer_rms_nmi_h",
            rates.map(|rates| rates.radial_error_rate_rms_m_s),
            "rms radial error rate RER (horizontal position error / time since NAV)",
        ),
        (
            "r50_nmi_h",
            rates.map(AccuracyFigures::cep_rate_m_s),
            "R50 = 0.8326 rms(RER), the CEP rate since NAV",
        ),
        ("r95_nmi_h", rates.map(AccuracyFigures::radial_95_rate_m_s), "R95 = 1.7308 rms(RER), since NAV"),
        (
            "slope_nmi_h",
            figures.slope().ok(),
            "growth of the horizontal position error since NAV (slope of the least-squares line)",
        ),
    ] {
        match value_m_s {
            Some(value_m_s) => rows.number(key, value_m_s / NMI_PER_HOUR, "nmi/h", label),
            None => rows.text(key, "none", label),
        }
    }
    if let Some(navigation) = figures.navigation() {
        rows.number("nav_from_s", navigation.from_s, "s", "NAV: error rates and growth count from this time");
        rows.number("nav_until_s", navigation.until_s, "s", "end of the navigation");
        let start_s = navigation.from_s + navigation.figures.window_start_s;
        rows.number("window_start_s", start_s, "s", "error rates and growth are evaluated from this time on");
    }
    rows.number("max_position_m", flown.largest[0], "m", "largest position error");
    if flown.has_axes() {
        rows.axes("velocity_rms_{}_m_s", "m/s", &accuracy.velocity_rms_n, "rms velocity error");
        rows.number("max_velocity_m_s", flown.largest[1], "m/s", "largest velocity error");
        rows.number("max_misalignment_rad", flown.largest[2], "rad", "largest misalignment");
    }
    let label = "records near a pole, which are not in the figures of velocity and misalignment";
    rows.whole("records_near_pole", flown.near_pole, label);
    for (key, value, unit, label) in [
        (
            "max_model_difference_position_m",
            flown.largest_difference[0],
            "m",
            "largest difference from the error equations, position",
        ),
        (
            "max_model_difference_velocity_m_s",
            flown.largest_difference[1],
            "m/s",
            "largest difference from the error equations, velocity",
        ),
    ] {
        if figures.scene().options.error_model {
            rows.number(key, value, unit, label);
        } else {
            rows.text(key, "none", label);
        }
    }
}
