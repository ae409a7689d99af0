//! Which errors real sensors have: a record of an IMU compared with what perfect sensors measure along the same path.
//!
//! The data flow is `command` → `record` → [`sins::analysis::identify`] → `sheet` → `table`, `scene`, `json`.

mod command;
mod json;
mod record;
mod scene;
mod sheet;
mod table;

pub use command::Order;

use sins::Error;
use sins::analysis::identify::{IdealPath, identify};
use sins::analysis::recommend::Refusal;

use crate::failure::Failure;
use crate::given::{Given, of_sample};
use crate::output::Outputs;
use crate::progress::Progress;
use crate::terminal::{print, quoted};
use crate::units::rounded;
use crate::written;
use record::Record;

/// Identifies the sensors of the record of `order`, writes the scene and prints the table.
pub fn run(order: &Order) -> Result<(), Failure> {
    let request = order.request()?;
    let given = Given::load(Some(&order.truth), None, &order.settings, &order.trust, command::FOR_LOGS)?;
    given.say_left_out();
    let mut inputs = given.inputs.clone();
    inputs.push(order.imu.clone());
    let output = order.output();
    let file = Outputs::new(&inputs, order.force).file(&output, scene::MARK)?;
    let record = Record::read(order)?;
    let path = {
        let _flying = Progress::working(format!("flying {} with perfect sensors", given.name));
        let refused = |refusal: Refusal| {
            let place = refusal.sample.map_or_else(|| given.origin.clone(), |index| given.place(index));
            Failure::new(format!("{place}: {}", of_sample(&refusal.error)))
        };
        let samples = (0..given.count).map(|index| given.sample(index));
        IdealPath::fly(&given.scene.simulator_options(), samples).map_err(refused)?
    };
    let found = identify(&path, &record.increments, &request)
        .map_err(|error| Failure::of_file(&order.imu, &sentence(&error)))?;
    let text = scene::text(order, &given, &found)?;
    file.finish(text)?;
    if order.json {
        return print(&json::text(&record, &found));
    }
    print(&table::text(&given, &record, &found))?;
    let next = match given.scene.is_log() {
        true => format!("`sins ensemble {}` shows how far such an INS drifts on this path", quoted(&output)),
        false => {
            format!("`sins ensemble {} --log LOG.csv` flies these sensors on another path", quoted(&output))
        }
    };
    print(&written::text(&[output], Some(&next)))
}

/// What makes the record unfit, with what was probably meant.
fn sentence(error: &Error) -> String {
    let value = error.value.map(|value| value.as_f64());
    let meant = match (error.field, value) {
        ("record.angle", Some(50.0..65.0)) => "; are the rates in deg/s, read as rad/s?",
        ("record.angle", Some(0.015..0.02)) => "; are the rates in rad/s, read as deg/s?",
        ("record.velocity", Some(0.09..0.115)) => "; are the forces in g, read as m/s²?",
        ("record.velocity", Some(8.5..11.0)) => "; are the forces in m/s², read as g?",
        ("record.velocity", Some(..0.0)) => "; --reversed reads them with the other sign",
        ("record.motion", _) => "; is it of the same flight?",
        ("request.offset_s", _) => " (--shift)",
        ("request.axes", _) => " (--axes)",
        _ => "",
    };
    let value = value.map(|value| rounded(value, 4));
    match value {
        Some(value) => format!(
            "{} = {value}: {}{meant}",
            error.field,
            Error { field: "", value: None, index: None, ..*error }
        ),
        None => format!("{error}{meant}"),
    }
}
