//! Text for the terminal.

use super::flight::FlyingTime;
use super::plan::Data;
use super::study::{QUANTITIES, Study};
use super::verdict::{self, Judged};
use crate::units::{LENGTH, brief, time_text, usual, with_unit};

/// The statistics at the end, and how fast the runs were flown.
pub fn text(study: &Study, judged: &[Judged], flown: &FlyingTime, threads: usize) -> String {
    let given = study.given;
    let mut text =
        format!("{}: {}\n  {}; {}\n", study.name, given.title, study.runs(), time_text(given.duration_s));
    text += &format!("  errors of: {}\n\n", errors(study));
    text += &format!("  {:<30}{:>12}{:>12}{:>12}\n", "at the end", "east", "north", "up");
    if let Some(row) = study.end(Data::Navigation)
        && row.good() == 0
    {
        text += "  none: no run reached the end\n";
    } else if let Some(row) = study.end(Data::Navigation) {
        let is_one = row.good() == 1;
        let figures = &row.figures;
        for quantity in &QUANTITIES {
            let part = quantity.first..quantity.first + study.axes(quantity);
            let largest = row.rms()[part.clone()].iter().copied().fold(0.0, f64::max);
            let unit = usual(largest, quantity.family);
            for (what, values) in [("mean", row.mean()), ("1 sigma", row.sigma()), ("RMS", row.rms())] {
                if is_one && what != "mean" {
                    continue; // one run has no scatter
                }
                let values = &values[part.clone()];
                let head = format!("{} {what} [{}]", quantity.name, unit.name);
                let numbers: String = values
                    .iter()
                    .map(|value| format!("{:>12}", crate::units::significant(value / unit.si)))
                    .collect();
                text += &format!("  {head:<30}{numbers}\n");
            }
        }
        let [cep50, r95, largest] =
            [figures.cep50_m, figures.r95_m, figures.largest_radial_m].map(|size| brief(size, LENGTH));
        text += &format!("  horizontal position error: CEP50 {cep50}, R95 {r95}, largest {largest}\n");
        if let Some(shown) = study.end(Data::Shown) {
            let (valid, all) = (shown.figures.runs - shown.figures.diverged, figures.runs);
            let [cep50, r95] = [shown.figures.cep50_m, shown.figures.r95_m].map(|size| brief(size, LENGTH));
            let sizes = if shown.good() > 0 { format!(": CEP50 {cep50}, R95 {r95}") } else { String::new() };
            text += &format!("  shown as valid by the unit in {valid} of {all} runs{sizes}\n");
        }
        if !is_one {
            let [along, cross] = [0, 1].map(|axis| with_unit(row.track_sigma()[axis], LENGTH));
            text += &format!("  1 sigma along the track {along}, across the track {cross}\n");
        }
    }
    text += &study.beyond_range().map(|sentence| format!("  {sentence}\n")).collect::<String>();
    text += &verdict::text(judged);
    if flown.steps > 0 {
        text += &format!(
            "  {:.3e} steps of a run in {}: {:.1} ns each, on {threads} thread{}\n",
            flown.steps as f64,
            time_text(flown.seconds),
            1e9 * flown.seconds / flown.steps as f64,
            if threads == 1 { "" } else { "s" }
        );
    }
    text
}

/// The sections of the scene that set errors, in words.
fn errors(study: &Study) -> String {
    let set = study.given.scene.changed_keys();
    let sections = ["gyro", "accelerometer", "altimeter", "start", "mounting", "gravity"];
    let mut words: Vec<&str> =
        sections.into_iter().filter(|section| set.iter().any(|key| key.section == *section)).collect();
    if !study.given.scene.failures.is_empty() {
        words.push("failures");
    }
    if words.is_empty() { "nothing: all runs are equal".to_owned() } else { words.join(", ") }
}
