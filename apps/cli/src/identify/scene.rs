//! The scene whose sensors have what was found.

use std::path::Path;

use nalgebra::Vector3;
use sins::analysis::identify::Identified;
use sins::analysis::identify::text::{FIGURES, MARK, sections, temperature};
use sins::log::LogMapping;
use sins::scene::{FlightSource, Scene, Temperature};

use super::command::Order;
use super::record::SensorRecord;
use crate::failure::{Failure, printable};
use crate::given::Given;
use crate::imu::imu_text;

/// The text of the scene. What was not seen is a comment.
pub fn text(
    order: &Order,
    given: &Given,
    record: &SensorRecord,
    found: &Identified,
) -> Result<String, Failure> {
    let mapping = record.mapping.as_ref().map_or(String::new(), |mapping| {
        format!(
            "\n# How the record was read; --imu-map with this file reads another one in the same way.\n{}",
            imu_text(mapping)
        )
    });
    let text = format!(
        "{MARK} in {}{}, {FIGURES}\n\n{}{}{mapping}",
        if order.check { "the first half of the common rows of " } else { "" },
        printable(&order.record().display().to_string()),
        flight(order, given) + &of_sensors(given, found),
        with_lever_arm(sections(found, given.scene.options.axes), given)
    );
    match Scene::parse(text.as_bytes()) {
        Ok(_) => Ok(text),
        Err(faults) => {
            let sentences: Vec<String> = faults.iter().map(|fault| fault.sentence.clone()).collect();
            Err(Failure::new(format!("a scene cannot have what was found: {}", sentences.join("; "))))
        }
    }
}

/// The sections with the lever arm of the path's scene.
fn with_lever_arm(sections: String, given: &Given) -> String {
    let lever_arm_m = given.scene.errors.mounting.lever_arm_m;
    if lever_arm_m == Vector3::zeros() {
        return sections;
    }
    let [x, y, z] = [lever_arm_m.x, lever_arm_m.y, lever_arm_m.z];
    let own = format!("[mounting]\nlever_arm_m = [{x}, {y}, {z}]\n");
    match sections.contains("[mounting]\n") {
        true => sections.replacen("[mounting]\n", &own, 1),
        false => format!("{sections}\n{own}"),
    }
}

/// Whether a scene that names the log of the path reads it in the same way.
pub fn is_read_plainly(given: &Given) -> bool {
    let is_pipe = matches!(&given.scene.flight, FlightSource::Log(file) if file == "-");
    *given.scene.log == LogMapping::default() && !is_pipe
}

/// The keys of \[flight\] with the temperature of the sensors, if what was found needs one: that of the path's scene, or that at which the
/// biases hold. A log with a temperature of its own needs none, and refuses one.
fn of_sensors(given: &Given, found: &Identified) -> String {
    let constant = temperature(found);
    let has_own = || given.sample(0).is_ok_and(|sample| sample.temperature_c.is_some());
    match given.scene.temperature {
        _ if constant.is_empty() || has_own() => String::new(),
        Some(Temperature { at_start_c, change_c_s }) => {
            format!("temperature_c = {at_start_c}\ntemperature_change_c_h = {}\n", change_c_s * 3600.0)
        }
        None => constant,
    }
}

/// The flight of the path, if another scene can name it.
fn flight(order: &Order, given: &Given) -> String {
    let truth = Path::new(&order.truth);
    match &given.scene.flight {
        FlightSource::Log(_) if !is_read_plainly(given) => {
            "# The log of the path needs the [log] with which it was read: fly these sensors on it by --log and --columns.\n\
             [flight]\nbuiltin = \"rest\"\n"
                .to_owned()
        }
        FlightSource::Log(file) => {
            let path = if given.scene.is_log() && crate::given::is_log(&order.truth) {
                truth
            } else {
                Path::new(file)
            };
            let full = std::fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
            let near = order.output().parent().map(Path::to_owned).and_then(|folder| {
                let folder = if folder.as_os_str().is_empty() { ".".into() } else { folder };
                let folder = std::fs::canonicalize(folder).ok()?;
                full.strip_prefix(folder).ok().map(Path::to_owned)
            });
            let name = near.unwrap_or(full).display().to_string();
            format!("[flight]\nfile = {}\n", quoted(&name))
        }
        FlightSource::Builtin(name) => format!("[flight]\nbuiltin = {}\n", quoted(name)),
        FlightSource::Path(_) if given.inputs.is_empty() => {
            format!("[flight]\nbuiltin = {}\n", quoted(&given.name))
        }
        FlightSource::Path(_) => {
            "# The flight of the path is in a scene of its own: fly these sensors on a log by --log.\n\
             [flight]\nbuiltin = \"rest\"\n"
                .to_owned()
        }
    }
}

fn quoted(text: &str) -> String {
    format!("\"{}\"", printable(text).replace('\\', "\\\\").replace('"', "\\\""))
}
