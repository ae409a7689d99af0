//! Whether the record keeps what the identified sensors predict, as a table for the terminal and as JSON.

use sins::analysis::identify::check::{Agreement, Check, CheckRequest, Span, TruthSigma};
use sins::units::ARCMIN;

use crate::failure::Failure;
use crate::units::{significant, time_text, two_digits};

/// A key of `--truth-sigma`: its name, the size of its unit in SI, and what it sets.
type Key = (&'static str, f64, fn(&mut TruthSigma) -> &mut f64);
const KEYS: [Key; 4] = [
    ("position_m", 1.0, |sigma| &mut sigma.position_m),
    ("velocity_m_s", 1.0, |sigma| &mut sigma.velocity_m_s),
    ("tilt_arcmin", ARCMIN, |sigma| &mut sigma.tilt_rad),
    ("heading_arcmin", ARCMIN, |sigma| &mut sigma.heading_rad),
];

/// The errors of the truth of texts such as "velocity_m_s=0.03".
pub fn truth_sigma(texts: &[String]) -> Result<TruthSigma, Failure> {
    let mut truth = TruthSigma::default();
    for text in texts {
        let expected = || {
            let [first, second, third, fourth] = KEYS.map(|(name, ..)| name);
            let keys = format!("{first}, {second}, {third} or {fourth}");
            Failure::new(format!(
                "--truth-sigma {text}: expected NAME=NUMBER with one of {keys} and 0 or more"
            ))
        };
        let (key, value) = text.split_once('=').ok_or_else(expected)?;
        let (_, si, place) = KEYS.iter().find(|(name, ..)| *name == key.trim()).ok_or_else(expected)?;
        let value = value.trim().parse::<f64>().ok().filter(|value| value.is_finite() && *value >= 0.0);
        *place(&mut truth) = value.ok_or_else(expected)? * si;
        // The library states its limit in SI, the user's unit is that of the key.
        if let Err(error) = (CheckRequest { truth, ..CheckRequest::default() }).validate() {
            let most = error.rule.limits().1.unwrap_or(f64::MAX) / si;
            return Err(Failure::new(format!("--truth-sigma {text}: must be at most {}", significant(most))));
        }
    }
    Ok(truth)
}

/// The table.
pub fn text(check: &Check, truth: &TruthSigma) -> String {
    let mut text = format!(
        "\ncheck: the figures above are those of the first half of the rows that the path has. In the other half, of {}, the record was\n\
         navigated from many starts. {} twins, sensors that were drawn from these figures, flew the same starts.\n\
         Half of the flights are horizontally within [m], with 95 % intervals:\n\n",
        time_text(check.length_s),
        check.twins
    );
    text += &row(["after", "flights (apart)", "as recorded", "errors removed", "predicted", "verdict"]);
    for span in &check.spans {
        text += &line(span);
    }
    if let Some(duration_s) = check.diverged_s {
        text += &format!(
            "  {:<7}left out, and what is longer: half of the flights of the record or of a twin diverge\n",
            time_text(duration_s)
        );
    }
    text += &format!("\n{}\n", verdict(check, truth));
    text
}

fn row([after, flights, free, real, predicted, verdict]: [&str; 6]) -> String {
    format!("  {after:<7}{flights:<17}{free:<13}{real:<30}{predicted:<30}{verdict}\n")
}

fn line(span: &Span) -> String {
    let with = |value: f64, (low, high): (f64, f64)| {
        format!("{} ({} to {})", significant(value), significant(low), significant(high))
    };
    row([
        &time_text(span.duration_s),
        &format!("{} ({})", span.flights, span.apart),
        &if span.free_m.is_finite() { significant(span.free_m) } else { "diverged".to_owned() },
        &with(span.real_m, span.real_interval_m),
        &with(span.predicted_m, span.predicted_interval_m),
        &words(&span.agreement),
    ])
}

fn words(agreement: &Agreement) -> String {
    match agreement {
        Agreement::Agrees => "agrees".to_owned(),
        Agreement::TooGood(factor) => format!("the model is too good by {}", two_digits(*factor)),
        Agreement::TooBad(factor) => format!("the model is too bad by {}", two_digits(*factor)),
    }
}

/// The verdict in words.
pub fn verdict(check: &Check, truth: &TruthSigma) -> String {
    let is_exact = *truth == TruthSigma::default();
    match check.agreement {
        Agreement::Agrees if is_exact => "the prediction agrees with the record".to_owned(),
        Agreement::Agrees => {
            "the prediction agrees with the record, with the errors of the path that --truth-sigma states"
                .to_owned()
        }
        Agreement::TooGood(_) if is_exact => format!(
            "{}; the path is taken for exact, --truth-sigma states its errors",
            words(&check.agreement)
        ),
        _ if is_exact => words(&check.agreement),
        _ => format!("{}, with the errors of the path that --truth-sigma states", words(&check.agreement)),
    }
}

/// The text of an object.
pub fn json(check: &Check) -> String {
    let spans: Vec<String> = check.spans.iter().map(span_json).collect();
    format!(
        "\"check\": {{\"length_s\": {}, \"twins\": {}, \"diverged_s\": {}, {},\n\"spans\": [\n{}\n]}}",
        check.length_s,
        check.twins,
        check.diverged_s.map_or("null".to_owned(), |duration_s| duration_s.to_string()),
        agreement_json(&check.agreement),
        spans.join(",\n")
    )
}

fn span_json(span: &Span) -> String {
    let Span { real_interval_m: real, predicted_interval_m: predicted, .. } = span;
    // A flight that diverged has no distance.
    let or_null = |distance_m: f64| match distance_m.is_finite() {
        true => distance_m.to_string(),
        false => "null".to_owned(),
    };
    format!(
        "  {{\"duration_s\": {}, \"flights\": {}, \"apart\": {}, \"free_m\": {}, \"real_m\": {}, \"real_low_m\": {}, \"real_high_m\": {}, \
         \"real_rms_m\": {}, \"predicted_m\": {}, \"predicted_low_m\": {}, \"predicted_high_m\": {}, \"predicted_rms_m\": {}, {}}}",
        span.duration_s,
        span.flights,
        span.apart,
        or_null(span.free_m),
        or_null(span.real_m),
        or_null(real.0),
        or_null(real.1),
        or_null(span.real_rms_m),
        or_null(span.predicted_m),
        or_null(predicted.0),
        or_null(predicted.1),
        or_null(span.predicted_rms_m),
        agreement_json(&span.agreement)
    )
}

fn agreement_json(agreement: &Agreement) -> String {
    let (word, factor) = match agreement {
        Agreement::Agrees => ("agrees", 1.0),
        Agreement::TooGood(factor) => ("too_good", *factor),
        Agreement::TooBad(factor) => ("too_bad", *factor),
    };
    format!("\"verdict\": \"{word}\", \"factor\": {factor}")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(texts: &[&str]) -> Result<TruthSigma, String> {
        let texts: Vec<String> = texts.iter().map(|text| (*text).to_owned()).collect();
        truth_sigma(&texts).map_err(|failure| failure.to_string())
    }

    #[test]
    fn errors_of_the_truth_are_read() {
        let sigma = read(&["velocity_m_s=0.03", "tilt_arcmin=2"]).unwrap();
        assert_eq!((sigma.velocity_m_s, sigma.tilt_rad, sigma.position_m), (0.03, 2.0 * ARCMIN, 0.0));
        for wrong in ["velocity=1", "tilt_arcmin", "position_m=-1", "position_m=inf", "position_m=x"] {
            let error = read(&[wrong]).unwrap_err();
            assert!(error.starts_with(&format!("--truth-sigma {wrong}: expected NAME=NUMBER")), "{error}");
        }
        // A limit is in the unit of its key: 0.3 rad are 1031 arcmin.
        for (wrong, limit) in [
            ("tilt_arcmin=1032", "1031"),
            ("heading_arcmin=1e9", "1031"),
            ("position_m=1e5", "10000"),
            ("velocity_m_s=1001", "1000"),
        ] {
            assert_eq!(
                read(&[wrong]).unwrap_err(),
                format!("--truth-sigma {wrong}: must be at most {limit}")
            );
        }
        assert!(read(&["tilt_arcmin=1031"]).is_ok());
    }
}
