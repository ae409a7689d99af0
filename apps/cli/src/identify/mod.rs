//! Which errors real sensors have: a record of an IMU compared with what perfect sensors measure along the same path.
//!
//! The data flow is `command` → `record` → [`sins::analysis::identify`] → `table`, `scene`, `json`; `check` prints whether the
//! rest of the record agrees, and `document` draws all of it, with the `residual`, by `diagram`.

mod check;
mod command;
mod diagram;
mod document;
mod json;
mod limits;
mod record;
mod residual;
mod scene;
mod table;

pub use command::Order;

use std::path::Path;

use nalgebra::Vector3;
use sins::Error;
use sins::analysis::identify::check::{Check, CheckRequest, Truth, check as fly_twins, identify_first_half};
use sins::analysis::identify::text::MARK;
use sins::analysis::identify::{IdealPath, Identified, Request, identify};
use sins::analysis::recommend::Refusal;
use sins::truth::FlightSample;
use sins::units::{DEG, STANDARD_GRAVITY as G};

use crate::drawing::document::PAGE_MARK;
use crate::drawing::file::PICTURE_MARK;
use crate::failure::Failure;
use crate::given::{Given, of_sample};
use crate::output::Outputs;
use crate::progress::Progress;
use crate::terminal::{print, quoted};
use crate::units::{rounded, significant, time_text};
use crate::written;
use document::Shown;
use record::SensorRecord;
use residual::Residual;

/// Identifies the sensors of the record of `order`, writes the scene and prints the table.
pub fn run(order: &Order) -> Result<(), Failure> {
    order.check_inputs()?;
    let request = order.request()?;
    let of_check = order.check_request()?;
    let given = Given::load(Some(&order.truth), None, &order.settings, &order.trust, command::FOR_LOGS)?;
    given.say_left_out();
    let mut inputs = given.inputs.clone();
    inputs.push(order.imu.clone());
    inputs.extend(order.imu_map.clone());
    let output = order.output();
    let mut outputs = Outputs::new(&inputs, order.force);
    let file = outputs.file(&output, MARK)?;
    let page = order.page.as_ref().map(|page| outputs.file(page, PAGE_MARK)).transpose()?;
    let picture = order.picture.as_ref().map(|picture| outputs.file(picture, PICTURE_MARK)).transpose()?;
    let record = SensorRecord::read(order, &given.scene)?;
    let lever_arm_b = given.scene.errors.mounting.lever_arm_m;
    if order.check && lever_arm_b != Vector3::zeros() {
        return Err(Failure::new(
            "mounting.lever_arm_m: --check flies from the point of the path; expected the path of the sensors' own place",
        ));
    }
    if request.also.lever_arm && lever_arm_b != Vector3::zeros() {
        return Err(Failure::new(
            "mounting.lever_arm_m: moves the path to the sensors, and --also lever-arm finds how far they are from it; expected one of both",
        ));
    }
    let residual_on = |path: &IdealPath, found: &Identified| {
        let path = found.path_of_sensors(path.clone()).map_err(|error| Failure::new(error.to_string()))?;
        Ok::<_, Failure>(Residual::new(&path, &record, found))
    };
    let (found, checked, residual) = match &of_check {
        Some(of_check) => {
            let truth = flown(&given, |samples| Truth::fly(&given.scene.simulator_options(), samples))?;
            let (found, checked) = identify_and_check(order, &truth, &record, &request, of_check)?;
            let residual = page.is_some().then(|| residual_on(truth.path(), &found)).transpose()?;
            (found, Some(checked), residual)
        }
        None => {
            let path = flown(&given, |samples| IdealPath::fly(&given.scene.simulator_options(), samples))?;
            let path = match lever_arm_b == Vector3::zeros() {
                true => path,
                false => {
                    path.with_lever_arm(&lever_arm_b).map_err(|error| Failure::new(error.to_string()))?
                }
            };
            let found = identify(&path, &record.increments, &request)
                .map_err(|error| Failure::of_file(order.record(), &sentence(&error, &record, order)))?;
            let residual = page.is_some().then(|| residual_on(&path, &found)).transpose()?;
            (found, None, residual)
        }
    };
    file.finish(scene::text(order, &given, &record, &found)?)?;
    if let (Some(picture), Some(checked)) = (picture, &checked) {
        picture.finish(document::picture(checked)?)?;
    }
    if let (Some(page), Some(residual)) = (page, residual) {
        let checked = checked.as_ref().zip(of_check.as_ref());
        let shown = Shown { given: &given, record: &record, found: &found, checked, residual };
        page.finish(document::page(shown)?)?;
    }
    if order.json {
        return print(&json::text(&record, &found, checked.as_ref()));
    }
    print(&table::text(&given, &record, &found))?;
    if let (Some(checked), Some(of_check)) = (&checked, &of_check) {
        print(&check::text(checked, &of_check.truth))?;
    }
    let next = match (&order.page, given.scene.is_log() && scene::is_read_plainly(&given)) {
        (Some(page), _) => written::open(page),
        (None, true) => {
            format!("`sins ensemble {}` shows how far such an INS drifts on this path", quoted(&output))
        }
        (None, false) => {
            format!("`sins ensemble {} --log LOG.csv` flies these sensors on another path", quoted(&output))
        }
    };
    let paths: Vec<&Path> = [Some(output.as_path()), order.page.as_deref(), order.picture.as_deref()]
        .into_iter()
        .flatten()
        .collect();
    print(&written::text(&paths, Some(&next)))
}

/// The samples of the path, flown by `fly` with perfect sensors.
fn flown<T>(
    given: &Given,
    fly: impl FnOnce(&mut dyn Iterator<Item = Result<FlightSample, Error>>) -> Result<T, Refusal>,
) -> Result<T, Failure> {
    let _flying = Progress::working(format!("flying {} with perfect sensors", given.name));
    let refused = |refusal: Refusal| {
        let place = refusal.sample.map_or_else(|| given.origin.clone(), |index| given.place(index));
        Failure::new(format!("{place}: {}", of_sample(&refusal.error)))
    };
    let temperature_c = |index: usize| Some(given.scene.temperature?.at(given.time_s(index)));
    let samples = (0..given.count).map(|index| {
        let sample = given.sample(index)?;
        Ok(FlightSample { temperature_c: sample.temperature_c.or_else(|| temperature_c(index)), ..sample })
    });
    fly(&mut { samples }).map_err(refused)
}

/// Identifies the sensors in the first half of the record, and checks them in the other one.
fn identify_and_check(
    order: &Order,
    truth: &Truth,
    record: &SensorRecord,
    request: &Request,
    of_check: &CheckRequest,
) -> Result<(Identified, Check), Failure> {
    let unfit = |error: Error| Failure::of_file(order.record(), &sentence(&error, record, order));
    let (found, other_half) = identify_first_half(truth, &record.increments, request).map_err(unfit)?;
    let _flying = Progress::working(format!("flying {} twins", of_check.twins));
    match fly_twins(truth, &found, other_half, of_check) {
        Ok(checked) => Ok((found, checked)),
        Err(error) => Err(Failure::of_file(order.record(), &format!("the half that is checked: {error}"))),
    }
}

/// How many times too large or small signals are that were written in another unit, and which.
const UNITS: [(&str, f64, &str); 12] = [
    ("record.angle", 1.0 / DEG, "are the rates in deg/s, read as rad/s?"),
    ("record.angle", DEG, "are the rates in rad/s, read as deg/s?"),
    ("record.angle", 1e3, "are the rates in thousandths of the unit that was read, as mdps?"),
    ("record.angle", 1e3 / DEG, "are the rates in mdps, read as rad/s?"),
    ("record.angle", 1e-3, "are the rates in a unit 1000 times as large as the one that was read?"),
    ("record.velocity", 1.0 / G, "are the forces in g, read as m/s²?"),
    ("record.velocity", G, "are the forces in m/s², read as g?"),
    ("record.velocity", 1e3, "are the forces in thousandths of the unit that was read, as mg?"),
    ("record.velocity", 1e3 / G, "are the forces in mg, read as m/s²?"),
    ("record.velocity", 1e-3, "are the forces in a unit 1000 times as large as the one that was read?"),
    ("record.velocity", 1e6, "are the forces in µg, read as g?"),
    ("record.velocity", 1e6 / G, "are the forces in µg, read as m/s²?"),
];
/// Part by which a size may be off that of the other unit.
const NEAR: f64 = 0.1;

/// What makes the record unfit, with what was probably meant.
fn sentence(error: &Error, record: &SensorRecord, order: &Order) -> String {
    let value = error.value.map(|value| value.as_f64());
    let read_as = format!(
        "read as {} of rows at {} Hz",
        time_text(record.increments.len() as f64 * record.interval_s),
        significant(1.0 / record.interval_s)
    );
    // Another unit than that of all rows is no fault of a row.
    let is_size = error.index.is_none() && ["record.angle", "record.velocity"].contains(&error.field);
    let unit = |value: f64| {
        let is_near = |factor: f64| is_size && (value / factor - 1.0).abs() < NEAR;
        if is_near(record.interval_s) {
            return Some("; are these increments, read as rates?".to_owned());
        }
        let mut units = UNITS.iter().filter(|(field, factor, _)| *field == error.field && is_near(*factor));
        units.next().map(|(_, _, words)| format!("; {words}"))
    };
    let meant = match (error.field, value) {
        ("record.velocity", Some(..0.0)) if is_size => match (order.reversed, record.is_described) {
            (true, _) => "; leave out --reversed".to_owned(),
            (false, true) => "; --reversed reads them with the other sign, as another sign of the accelerometers in [imu] does".to_owned(),
            (false, false) => "; --reversed reads them with the other sign".to_owned(),
        },
        ("record.motion", _) => {
            format!(
                "; is it of the same flight? It is {read_as}; --shift finds a short record on a long path"
            )
        }
        ("record.blocks" | "record.interval_s" | "record.drift", _) => format!("; it is {read_as}"),
        ("gyro.bias" | "gyro.scale_factor" | "gyro.misalignment", _)
        | ("accelerometer.bias" | "accelerometer.scale_factor" | "accelerometer.misalignment", _)
        | ("gyro.g_sensitivity" | "gyro.asymmetry" | "accelerometer.asymmetry", _)
        | ("gyro.bias_temperature" | "accelerometer.bias_temperature", _) => {
            let wider = if order.prior == "consumer" { "" } else { "; --prior consumer is wider" };
            wider.to_owned()
        }
        ("record.velocity", Some(value)) if is_size && unit(value).is_none() && value < 0.7 => {
            "; has gravity been taken out, or is a sensor beyond its range?".to_owned()
        }
        ("record.velocity.x" | "record.velocity.y" | "record.velocity.z", Some(-1.0..=1.0))
            if error.index.is_none() && order.cutoff.is_none() && error.to_string().contains("few or late fixes") =>
        {
            "; --cutoff HZ compares only the motion below HZ: `sins log` states the frequency above which a smoothed path has lost it".to_owned()
        }
        ("record.lever_arm_m", _) if !order.check => {
            "; mounting.lever_arm_m of the path's scene moves the path to the sensors, --also lever-arm finds it".to_owned()
        }
        ("request.shift_s", _) => " (--shift)".to_owned(),
        ("request.axes", _) => " (--axes)".to_owned(),
        ("request.also.temperature", _) => {
            "; temperature_c is a column of the log of the path, also by `temperature` of its [log], or a key of [flight]".to_owned()
        }
        (_, value) => value.and_then(unit).unwrap_or_default(),
    };
    let Some(value) = value.map(|value| rounded(value, 4)) else { return format!("{error}{meant}") };
    let at = match error.index {
        Some(row) if error.field.starts_with("record.") => {
            record.increments.get(row).map_or(String::new(), |row| format!(" at {} s", row.time_s))
        }
        Some(index) => format!("[{index}]"),
        None => String::new(),
    };
    let rule = Error { field: "", value: None, index: None, ..*error };
    format!("{}{at} = {value}: {rule}{meant}", error.field)
}
