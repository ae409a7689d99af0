//! The figures on the terminal.

use std::path::Path;

use nalgebra::Vector3;
use sins::units::{ARCMIN, NMI_PER_HOUR};

use super::figures::Figures;
use super::shown::Reason;
use crate::planned;
use crate::units::{six_digits, time_text};

/// Text of the summary, its answer first; `records` is the path of the records.
pub fn text(figures: &Figures, records: &Path) -> String {
    format!("{}\n\n", figures.sentence())
        + &setting(figures, records)
        + &closure(figures)
        + &accuracy(figures)
}

/// `value` as text, in scientific notation if fixed-point notation would not show its digits.
fn number(value: f64) -> String {
    let size = value.abs();
    let text = match size {
        0.0 => "0".to_owned(),
        0.01..1e7 => format!("{value:.3}"),
        _ => format!("{value:.3e}"),
    };
    format!("  {text:>14}")
}

fn setting(figures: &Figures, records: &Path) -> String {
    let (given, flown) = (figures.given, figures.flown);
    let mut text = format!("{}: {}\n", figures.name, given.title);
    let mut line = |what: &str, value: String| text += &format!("  {what:<15} {value}\n");
    line("scene", given.origin.clone());
    for (what, section) in [
        ("gyros", "gyro"),
        ("accelerometers", "accelerometer"),
        ("altimeter", "altimeter"),
        ("mounting", "mounting"),
        ("disturbance", "gravity"),
    ] {
        line(what, figures.set_in(section));
    }
    line("start errors", figures.start());
    if let Some(unit) = figures.unit() {
        line("unit", unit);
        line("valid at end", flown.shown_at_end.clone().unwrap_or_default());
        if !flown.reasons.is_empty() {
            line("invalid for", flown.reasons.iter().map(Reason::text).collect::<Vec<_>>().join("; "));
        }
    }
    line("failures", planned::failures(figures.scene()));
    line("updates", figures.updates());
    line("options", figures.set_in("options"));
    if let Some(gaps) = given.gaps_text() {
        line("gaps", gaps);
    }
    let interrupted = if figures.is_interrupted { ", stopped before the end" } else { "" };
    line(
        "flown",
        format!(
            "{} s ({}) at {} Hz, {} steps of {:.0} ns{interrupted}",
            six_digits(figures.accuracy.duration_s),
            time_text(figures.accuracy.duration_s),
            six_digits(figures.rate_hz()),
            flown.steps,
            figures.ns_per_step(),
        ),
    );
    let beyond = flown.beyond_range.iter().zip(["gyros", "accelerometers"]);
    let beyond =
        beyond.filter(|(steps, _)| **steps > 0).map(|(steps, what)| format!("{what} in {steps} steps"));
    let beyond: Vec<String> = beyond.collect();
    if !beyond.is_empty() {
        line("beyond range", beyond.join(", "));
    }
    let every = six_digits(figures.every_s);
    for (_, value, unit, label, time_s) in figures.truth() {
        line("truth", format!("{label} {} {unit}, at {} s", six_digits(value), six_digits(time_s)));
    }
    line("records", format!("{}, one each {every} s, in {}", flown.records, records.display()));
    text
}

fn closure(figures: &Figures) -> String {
    let closure = &figures.closure;
    let mut text = format!(
        "\nclosure: navigation - truth at the end; the truth causes the part by which its velocities contradict its positions\n\
         {:<32}  {:>14}  {:>14}  {:>14}\n",
        "", "east", "north", "up"
    );
    let mut axes = |what: &str, values: &Vector3<f64>, count: usize| {
        let numbers: String = values.iter().take(count).copied().map(number).collect();
        text += &format!("  {what:<30}{numbers}\n");
    };
    axes("position [m]", &closure.position_n, 3);
    axes("  caused by the truth", &closure.host_position_n, 2);
    axes("  caused by sensors, simulator", &(closure.position_n - closure.host_position_n), 2);
    axes("velocity [m/s]", &closure.velocity_n, 3);
    axes("  caused by the truth", &closure.host_velocity_n, 2);
    axes("  caused by sensors, simulator", &(closure.velocity_n - closure.host_velocity_n), 2);
    if figures.flown.has_axes() {
        axes("rms velocity error [m/s]", &figures.accuracy.velocity_rms_n, 3);
    }
    let trim = &figures.trim;
    if figures.scene().options.closed_loop_time_s.is_some() {
        text += &format!(
            "  largest trim of the closed loop: {:.2e} rad/s, {:.2e} m/s2\n",
            trim.rate_rad_s, trim.force_m_s2
        );
    }
    if closure.inconsistent_samples > 0 {
        text += &format!(
            "  {} samples contradict their velocity, by up to {:.2e} m\n",
            closure.inconsistent_samples, closure.inconsistency_max_m
        );
    }
    text
}

fn accuracy(figures: &Figures) -> String {
    let flown = figures.flown;
    let mut text = "\naccuracy of this run (one run, no statistics of many)\n".to_owned();
    let mut counted = String::new();
    let mut line =
        |what: &str, value: f64, unit: &str| text += &format!("  {what:<72}{} {unit}\n", number(value));
    if let Some(navigation) = figures.navigation().filter(|_| figures.slope().is_ok()) {
        let [from, until] = [navigation.from_s, navigation.until_s].map(six_digits);
        counted = format!(
            "  rates and slope: from the begin of the navigation (NAV) at {from} s to its end at {until} s\n"
        );
    }
    if let Ok(rates) = figures.rates() {
        for (what, value_m_s) in [
            (
                "rms of RER = sqrt(mean RER^2), RER = horizontal error / time since NAV",
                rates.radial_error_rate_rms_m_s,
            ),
            ("R50 = 0.8326 sqrt(mean RER^2)", rates.cep_rate_m_s()),
            ("R95 = 1.7308 sqrt(mean RER^2)", rates.radial_95_rate_m_s()),
        ] {
            line(what, value_m_s / NMI_PER_HOUR, "nmi/h");
        }
    }
    if let Ok(slope_m_s) = figures.slope() {
        let what = "slope of the least-squares line through the horizontal error";
        line(what, slope_m_s / NMI_PER_HOUR, "nmi/h");
    }
    line("largest |position error| of the records", flown.largest[0], "m");
    if flown.has_axes() {
        line("largest |velocity error| of the records", flown.largest[1], "m/s");
        line("largest |misalignment| of the records", flown.largest[2] / ARCMIN, "arcmin");
    }
    if figures.scene().options.error_model {
        let what = "largest |error data 1 - error data 2| of the records, position";
        line(what, flown.largest_difference[0], "m");
        let what = "largest |error data 1 - error data 2| of the records, velocity";
        line(what, flown.largest_difference[1], "m/s");
    }
    if flown.near_pole > 0 {
        text += &format!(
            "  {} of {} records are near a pole: they are not in the figures of velocity and misalignment\n",
            flown.near_pole, flown.records
        );
    }
    for (what, why) in [("RER, R50, R95", figures.rates().err()), ("slope", figures.slope().err())] {
        text += &why.map_or(String::new(), |why| format!("  {what}: {why}\n"));
    }
    text += &counted;
    text
}
