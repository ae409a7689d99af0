//! The scene whose sensors have what was found.

use std::path::Path;

use sins::analysis::identify::Identified;
use sins::earth::state::BodyAxes;
use sins::log::LogMapping;
use sins::scene::{FlightSource, Scene};
use sins::units::DEG;

use super::command::Order;
use super::sheet::{Line, NoiseLine, Sheet, sheets};
use super::table;
use crate::failure::{Failure, printable};
use crate::given::Given;
use crate::units::rounded;

/// The begin of such a scene.
pub const MARK: &str = "# sensors that sins identify found";

/// Boresight below which none is written [rad].
const NO_TURN: f64 = 1e-9;

/// The text of the scene. What was not seen is a comment.
pub fn text(order: &Order, given: &Given, found: &Identified) -> Result<String, Failure> {
    let axes = given.scene.options.axes;
    let mut text = format!(
        "{MARK} in {}{}, with intervals of 95 %. Noise is that of the record and of the path together.\n\n{}",
        if order.check { "the first half of the common rows of " } else { "" },
        printable(&order.imu.display().to_string()),
        flight(order, given)
    );
    if axes == BodyAxes::ForwardRightDown {
        text += "\n[options]\naxes = \"frd\"\n";
    }
    text += &mounting(found, axes);
    for sheet in sheets(found) {
        text += &section(&sheet);
    }
    match Scene::parse(text.as_bytes()) {
        Ok(_) => Ok(text),
        Err(faults) => {
            let sentences: Vec<String> = faults.iter().map(|fault| fault.sentence.clone()).collect();
            Err(Failure::new(format!("a scene cannot have what was found: {}", sentences.join("; "))))
        }
    }
}

/// Whether a scene that names the log of the path reads it in the same way.
pub fn is_read_plainly(given: &Given) -> bool {
    let is_pipe = matches!(&given.scene.flight, FlightSource::Log(file) if file == "-");
    *given.scene.log == LogMapping::default() && !is_pipe
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

/// The attitude of the block in the vehicle.
fn mounting(found: &Identified, axes: BodyAxes) -> String {
    let words = table::axes(&found.axes.exchange, found.axes.is_seen);
    let euler = found.boresight(axes);
    if [euler.roll, euler.pitch, euler.heading].iter().all(|angle| angle.abs() < NO_TURN) {
        return format!("\n# axes: {words}\n");
    }
    let angles = [euler.roll, euler.pitch, euler.heading].map(|angle| rounded(angle / DEG, 9));
    format!("\n# axes: {words}\n[mounting]\nboresight_deg = [{}, {}, {}]\n", angles[0], angles[1], angles[2])
}

/// Values of the parameters that were seen on at least one axis, the standard deviations that are left, and comments about the others.
fn section(Sheet { section, lines, noises, .. }: &Sheet) -> String {
    let mut text = format!("\n[{section}]\n");
    for of_key in lines.chunk_by(|a, b| a.key == b.key) {
        let key = of_key[0].key;
        let is_matrix = of_key.len() == 6;
        let value =
            |line: &Line, of: f64| if line.estimate.is_seen() { rounded(of / line.unit.si, 6) } else { 0.0 };
        if of_key.iter().any(|line| line.estimate.is_seen()) {
            let values = |of: &dyn Fn(&Line) -> f64| {
                let numbers: Vec<f64> = of_key.iter().map(|line| value(line, of(line))).collect();
                let numbers = if is_matrix { beside_diagonal(&numbers) } else { numbers };
                numbers.iter().map(f64::to_string).collect::<Vec<_>>().join(", ")
            };
            let unit = unit(key);
            let stem = key.strip_suffix(unit).unwrap_or(key);
            text += &format!("{key} = [{}]\n", values(&|line| line.estimate.value));
            text += &format!("{stem}_sigma{unit} = [{}]\n", values(&|line| line.estimate.sigma));
        }
        for line in of_key {
            text += &format!("# {}: {}\n", line.name, table::seen(line));
        }
    }
    for of_key in noises.chunk_by(|a, b| a.key == b.key) {
        let value = |line: &NoiseLine| match line.estimate.low > 0.0 {
            true => rounded(line.estimate.value / line.unit.si, 6),
            false => 0.0,
        };
        if of_key.iter().any(|line| line.estimate.low > 0.0) {
            let values: Vec<String> = of_key.iter().map(|line| value(line).to_string()).collect();
            text += &format!("{} = [{}]\n", of_key[0].key, values.join(", "));
        }
        for line in of_key {
            text += &format!("# {}: {}\n", line.name, table::of_noise(line));
        }
    }
    text
}

/// The unit at the end of a key.
fn unit(key: &str) -> &'static str {
    ["_deg_h", "_micro_g", "_ppm", "_arcsec"].into_iter().find(|unit| key.ends_with(unit)).unwrap_or("")
}

/// Nine elements of six beside the diagonal, row by row.
fn beside_diagonal(six: &[f64]) -> Vec<f64> {
    let mut rest = six.iter().copied();
    (0..9).map(|k| if k % 4 == 0 { 0.0 } else { rest.next().unwrap_or(0.0) }).collect()
}
