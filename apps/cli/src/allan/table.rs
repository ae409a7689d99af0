//! Coefficients as text, and as a table on the terminal.

use sins_allan::{Filter, Term};

use super::analysis::{Analysis, Coefficient};
use super::sheet;
use crate::imu::Log;
use crate::units::{Unit, in_unit, significant, time_text};

/// Value and interval in `unit`; for a coefficient that is not resolved, the upper limit.
pub fn value(coefficient: &Coefficient, unit: Unit) -> String {
    let Some(interval) = coefficient.interval else {
        return format!("{} {}, without an interval", significant(coefficient.value / unit.si), unit.name);
    };
    let [value, low, high] =
        [coefficient.value, interval.low, interval.high].map(|value| significant(value / unit.si));
    if coefficient.is_at_bound() || !interval.high.is_finite() {
        "not shown by this record".to_owned()
    } else if coefficient.is_resolved() {
        format!("{value} ({low} to {high}) {}", unit.name)
    } else {
        format!("below {high} {}", unit.name)
    }
}

/// A coefficient with its interval, in the unit of data sheets.
pub fn on_sheet(analysis: &Analysis, coefficient: &Coefficient) -> String {
    value(coefficient, sheet::coefficient(analysis.sensor, coefficient.term))
}

/// Density of a resolved random walk, the second unit of data sheets.
pub fn density(analysis: &Analysis, coefficient: &Coefficient) -> Option<String> {
    let is_quoted = coefficient.term == Term::RandomWalk && coefficient.is_resolved();
    is_quoted.then(|| in_unit(coefficient.value, sheet::density(analysis.sensor)))
}

/// Part of the rows that may be those before, where a sensor is sometimes late.
const FEW_REPEATS: f64 = 0.1;

/// An averaging time.
fn tau(seconds: f64) -> String {
    if seconds < 10.0 { format!("{} s", about(seconds)) } else { time_text(seconds) }
}

/// A number with two digits.
fn about(value: f64) -> String {
    let place = 1 - value.log10().floor() as i32;
    let scale = 10f64.powi(place);
    format!("{:.*}", place.max(0) as usize, (value * scale).round() / scale)
}

/// What makes the values depend on their neighbours.
fn dependence(analysis: &Analysis) -> String {
    let times = (1.0 / (1.0 - analysis.repeats)).round();
    if analysis.repeats > FEW_REPEATS {
        // Repeated by a fixed number, or now and then.
        let is_regular = (analysis.repeats * times / (times - 1.0) - 1.0).abs() < 0.02;
        if is_regular {
            let rate_hz = 1.0 / analysis.estimates[0].tau_s;
            let [sensor, log] = [rate_hz / times, rate_hz].map(significant);
            return format!("each value stands {times} times: a sensor of {sensor} Hz in rows of {log} Hz");
        }
        let percent = 100.0 * analysis.repeats;
        return format!(
            "{percent:.0} % of the values are those of the row before: the sensor is slower than the log"
        );
    }
    match analysis.filter {
        Some(Filter::FirstOrder(hz)) => format!("the values are those behind a low-pass of first order at about {} Hz", about(hz)),
        Some(Filter::SecondOrder(hz)) => format!("the values are those behind a low-pass of second order at about {} Hz", about(hz)),
        Some(Filter::Mean(rows)) => {
            let about = if rows < 6 { "" } else { "about " };
            format!("each value is the mean of {about}{rows} of the sensor")
        },
        None => "neighbouring values depend on each other, as behind a low-pass, by averaging, or at the upper end of flicker noise".to_owned(),
    }
}

/// Remark about values that are none of a noise, averaging times that are left out, and what the coefficients do not explain.
pub fn remark(analysis: &Analysis) -> Option<String> {
    if let Some(fault) = &analysis.fault {
        return Some(format!("No interval would hold: {fault}."));
    }
    if let Some(from_s) = analysis.from_s {
        let (from, cause) = (tau(from_s), dependence(analysis));
        return Some(format!("Averaging times below {from} are left out of the fit: {cause}."));
    }
    let what = "something else is in the record, as a Gauss-Markov process or a vibration, and the coefficients have taken what they \
                could of it";
    let missed = analysis.unexplained().map(|missed| {
        let ratio = significant(missed.deviation / missed.fitted);
        format!("At {} the deviation is {ratio} times the fit: {what}.", tau(missed.tau_s))
    });
    let disagree = || format!("Fits to shorter and to longer averaging times disagree: {what}.");
    (!analysis.is_explained).then(|| missed.unwrap_or_else(disagree))
}

/// The log in one line.
pub fn source(log: &Log) -> String {
    let rate = significant(1.0 / log.interval_s);
    let counted = log.counted();
    let remarks: String = log.remarks.iter().map(|remark| format!("; {remark}")).collect();
    format!(
        "{}: {} samples at {rate} Hz{counted}, {}{remarks}",
        log.name,
        log.count(),
        time_text(log.duration_s())
    )
}

/// The table for the terminal.
pub fn table(log: &Log, analyses: &[Analysis]) -> String {
    let mut text = format!("{}; 95 % intervals\n", source(log));
    for analysis in analyses {
        text += &format!("\n{}\n", analysis.name);
        for coefficient in &analysis.coefficients {
            let term = coefficient.term;
            let density = density(analysis, coefficient).map(|text| format!(", {text}")).unwrap_or_default();
            text += &format!(
                "  {} {:<25}{}{density}\n",
                term.letter(),
                sheet::name(analysis.sensor, term),
                on_sheet(analysis, coefficient),
            );
        }
        if let Some(remark) = remark(analysis) {
            text += &format!("  {remark}\n");
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::super::analysis::tests::made;
    use super::*;

    #[test]
    fn what_is_not_resolved_is_reported_as_below() {
        let log = made(20_000, 0.0);
        let text = table(&log, &Analysis::of_log(&log).unwrap());
        assert!(text.starts_with("made.csv: 20000 samples at 100.0 Hz, 3.3 min; 95 % intervals\n"), "{text}");
        assert_eq!(text.matches(" below ").count(), 4, "{text}");
        assert!(text.contains("N angle random walk        0.034") && text.contains("°/h/√Hz"), "{text}");
    }

    /// A fit that allows no negative coefficients leaves some coefficients on an end of their interval.
    #[test]
    fn an_estimate_on_its_own_bound_is_no_finding() {
        use sins_allan::Interval;
        let text = |value: f64, low: f64, high: f64| {
            let interval = Interval { low, high };
            on_sheet_unit(&Coefficient {
                term: Term::Flicker,
                value,
                interval: Some(interval),
                written: None,
            })
        };
        assert_eq!(text(0.0, 0.0, f64::INFINITY), "not shown by this record");
        let without = Coefficient { term: Term::Flicker, value: 2.0, interval: None, written: None };
        assert_eq!(on_sheet_unit(&without), "2.000 u, without an interval");
        assert_eq!(text(2.0, 1.0, 3.0), "2.000 (1.000 to 3.000) u");
        assert_eq!(text(2.0, 0.0, 2.0), "not shown by this record");
        assert_eq!(text(2.0, 0.9, 2.0), "not shown by this record");
        assert_eq!(text(2.0, 1.9, 2.0), "2.000 (1.900 to 2.000) u");
        assert_eq!(
            (text(0.0, 0.0, 2.0), text(1.0, 0.0, 2.0)),
            ("below 2.000 u".into(), "below 2.000 u".into())
        );
    }

    fn on_sheet_unit(coefficient: &Coefficient) -> String {
        value(coefficient, Unit { name: "u", si: 1.0 })
    }

    #[test]
    fn what_is_not_explained_is_remarked() {
        let log = made(20_000, 2.0);
        assert!(table(&log, &Analysis::of_log(&log).unwrap()).contains(" times the fit: "));
    }
}
