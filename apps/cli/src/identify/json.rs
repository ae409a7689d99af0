//! What was found as JSON, in SI units.

use sins::analysis::identify::check::Check;
use sins::analysis::identify::sheet::{Sheet, sheets};
use sins::analysis::identify::{Estimate, Identified};

use super::check;
use super::record::SensorRecord;

/// The text of an object.
pub fn text(record: &SensorRecord, found: &Identified, checked: Option<&Check>) -> String {
    let exchange: Vec<String> = found.axes.exchange.row_iter().map(|row| list(row.iter().copied())).collect();
    let rotation: Vec<String> = found.rotation.row_iter().map(|row| list(row.iter().copied())).collect();
    let mounting: Vec<String> = found.mounting.iter().map(estimate).collect();
    let parts: Vec<String> = sheets(found).iter().map(sensor).chain(checked.map(check::json)).collect();
    format!(
        "{{\n\"rows\": {}, \"interval_s\": {}, \"blocks\": {}, \"block_s\": {},\n\"clock_shift_s\": {},\n\"clock_drift\": {},\n\
         \"axes\": {{\"exchange\": [{}], \"seen\": {}}},\n\"mounting_rad\": [{}],\n\"g_sensitivity_rad_s_per_m_s2\": {},\n\"rotation\": [{}],\n{}\n}}\n",
        record.increments.len(),
        record.interval_s,
        found.blocks,
        found.block_s,
        estimate(&found.offset_s),
        estimate(&found.drift),
        exchange.join(", "),
        found.axes.is_seen,
        mounting.join(", "),
        found.left_g_sensitivity.map_or("null".to_owned(), |size| size.to_string()),
        rotation.join(", "),
        parts.join(",\n")
    )
}

fn sensor(sheet: &Sheet) -> String {
    let parameters = sheet.fitted().map(|line| format!("  \"{}\": {}", line.name, estimate(&line.estimate)));
    let noises = sheet.noises.iter().map(|line| {
        let noise = line.estimate;
        format!(
            "  \"{}\": {{\"value\": {}, \"low\": {}, \"high\": {}, \"seen\": {}}}",
            line.name,
            noise.value,
            noise.low,
            noise.high,
            noise.is_seen()
        )
    });
    let all: Vec<String> = parameters.chain(noises).collect();
    format!("\"{}\": {{\n{}\n}}", sheet.section, all.join(",\n"))
}

fn estimate(estimate: &Estimate) -> String {
    let (low, high) = estimate.interval();
    format!(
        "{{\"value\": {}, \"low\": {low}, \"high\": {high}, \"sigma\": {}, \"prior\": {}, \"seen\": {}}}",
        estimate.value,
        estimate.sigma,
        estimate.prior,
        estimate.is_seen()
    )
}

fn list(values: impl Iterator<Item = f64>) -> String {
    let values: Vec<String> = values.map(|value| value.to_string()).collect();
    format!("[{}]", values.join(", "))
}
