//! The inputs of the truth at the start of a step.

use core::f64::consts::FRAC_PI_2;

use nalgebra::Vector3;
use sins::Error;
use sins::earth::Geodetic;
use sins::log::quantity_of;
use sins::math::{Euler, atan2, attitude_from_euler, sin_cos};
use sins::truth::FlightSample;
use sins::units::TEMPERATURE_RANGE_C;

use crate::panel;
use crate::values::{Value, Values};
use crate::variable::{Role, Variable};

/// Mean radius of the Earth [m].
const EARTH_RADIUS_M: f64 = 6.371e6;

/// Speed of a position whose velocity cannot be 0 [m/s].
const MOVES_M_S: f64 = 1.0;

/// Place of the velocity among the inputs.
const VELOCITY_AT: usize = 6;

/// Inputs that a master sets together. They are the first reals of the table, in this order.
struct Group {
    name: &'static str,
    /// The parameter that turns the group off; a group without one is required.
    switch: Option<&'static str>,
    inputs: &'static [Input],
}

/// Name, unit, limits, usual size, meaning.
type Input = (&'static str, &'static str, (f64, f64), f64, &'static str);

const fn of_size(largest: f64) -> (f64, f64) {
    (-largest, largest)
}

// Limits of the values of a sample.
const LATITUDE: (f64, f64) = of_size(FRAC_PI_2);
const LONGITUDE: (f64, f64) = of_size(FlightSample::MAX_LONGITUDE_RAD);
const HEIGHT: (f64, f64) = FlightSample::HEIGHT_RANGE_M;
const ANGLE: (f64, f64) = of_size(FlightSample::MAX_ANGLE_RAD);
const VELOCITY: (f64, f64) = of_size(FlightSample::MAX_VELOCITY_M_S);
const RATE: (f64, f64) = of_size(FlightSample::MAX_RATE_RAD_S);
const FORCE: (f64, f64) = of_size(FlightSample::MAX_FORCE_M_S2);

#[rustfmt::skip]
const GROUPS: [Group; 6] = [
    Group { name: "position", switch: None, inputs: &[
        ("truth.latitude_rad", "rad", LATITUDE, 1.0, "geodetic latitude"),
        ("truth.longitude_rad", "rad", LONGITUDE, 1.0, "longitude, east positive"),
        ("truth.height_m", "m", HEIGHT, 1e4, "height above the ellipsoid"),
    ] },
    Group { name: "attitude", switch: None, inputs: &[
        ("truth.roll_rad", "rad", ANGLE, 1.0, "roll, right wing down positive; any number of turns"),
        ("truth.pitch_rad", "rad", ANGLE, 1.0, "pitch, nose up positive"),
        ("truth.heading_rad", "rad", ANGLE, 1.0, "heading, clockwise from true north"),
    ] },
    Group { name: "velocity", switch: Some("use_velocity"), inputs: &[
        ("truth.velocity_east_m_s", "m/s", VELOCITY, 100.0, "velocity against the Earth, east"),
        ("truth.velocity_north_m_s", "m/s", VELOCITY, 100.0, "velocity against the Earth, north"),
        ("truth.velocity_up_m_s", "m/s", VELOCITY, 10.0, "velocity against the Earth, up"),
    ] },
    Group { name: "angular rate", switch: Some("use_rates"), inputs: &[
        ("truth.rate_rad_s[1]", "rad/s", RATE, 1.0, "angular rate against inertial space, sensor axis x"),
        ("truth.rate_rad_s[2]", "rad/s", RATE, 1.0, "angular rate against inertial space, sensor axis y"),
        ("truth.rate_rad_s[3]", "rad/s", RATE, 1.0, "angular rate against inertial space, sensor axis z"),
    ] },
    Group { name: "specific force", switch: Some("use_forces"), inputs: &[
        ("truth.force_m_s2[1]", "m/s2", FORCE, 10.0, "specific force, sensor axis x"),
        ("truth.force_m_s2[2]", "m/s2", FORCE, 10.0, "specific force, sensor axis y"),
        ("truth.force_m_s2[3]", "m/s2", FORCE, 10.0, "specific force, sensor axis z"),
    ] },
    Group { name: "temperature", switch: Some("use_temperature"), inputs: &[
        ("truth.temperature_c", "deg C", TEMPERATURE_RANGE_C, 20.0, "temperature of the gyros and accelerometers"),
    ] },
];

/// Number of inputs of the truth.
pub const COUNT: usize = {
    let (mut group, mut count) = (0, 0);
    while group < GROUPS.len() {
        count += GROUPS[group].inputs.len();
        group += 1;
    }
    count
};

/// The inputs of the truth as variables.
pub fn variables() -> impl Iterator<Item = Variable> {
    GROUPS.iter().flat_map(|group| {
        let rest = if group.switch.is_none() { "" } else { "; off until the master sets it" };
        group.inputs.iter().map(move |&(name, unit, limits, nominal, doc)| {
            let variable = Variable::new(name, Role::Input, Value::Real(0.0), format!("{doc}{rest}"));
            Variable { nominal, limits: Some(limits), ..variable.in_unit(unit, 1.0) }
        })
    })
}

/// The parameters that turn optional groups off, as variables.
pub fn switches() -> impl Iterator<Item = Variable> {
    GROUPS.iter().filter_map(|group| {
        let doc = format!(
            "whether the inputs of the {} count if the master sets them; false where a tool sets inputs that are not connected",
            group.name
        );
        Some(Variable::new(group.switch?, Role::Fixed, Value::Boolean(true), doc))
    })
}

/// The variable that an error about a sample is about.
pub fn name_of(error: &Error) -> Option<&'static str> {
    // The time is an argument of the step.
    let place = quantity_of(error)?;
    let names = GROUPS.iter().flat_map(|group| group.inputs).map(|input| input.0);
    ["currentCommunicationPoint"].into_iter().chain(names).nth(place)
}

/// Angle between the attitudes of two sets of inputs [rad].
pub fn turn_rad(before: &[f64], now: &[f64]) -> f64 {
    let attitude = |inputs: &[f64]| {
        let at = GROUPS[0].inputs.len();
        attitude_from_euler(&Euler { roll: inputs[at], pitch: inputs[at + 1], heading: inputs[at + 2] })
    };
    let turn = attitude(before).conjugate() * attitude(now);
    2.0 * atan2(turn.imag().norm(), turn.w.abs())
}

/// The sample at `time_s` [s] with the inputs in `values`; `is_set` marks the inputs that the master has set.
pub fn sample(time_s: f64, values: &Values, is_set: &[bool; COUNT]) -> Result<FlightSample, String> {
    let mut from = 0;
    let mut parts = [None; GROUPS.len()];
    let mut switches = values.booleans[panel::SWITCHES..].iter();
    for (group, part) in GROUPS.iter().zip(&mut parts) {
        let places = from..from + group.inputs.len();
        from = places.end;
        if group.switch.is_some() && switches.next() == Some(&false) {
            continue;
        }
        let missing = places.clone().find(|&place| !is_set[place]);
        if let Some(missing) = missing {
            if group.switch.is_none() || is_set[places.clone()].contains(&true) {
                let name = group.inputs[missing - places.start].0;
                return Err(format!("{name} is not connected: the {} is incomplete", group.name));
            }
            continue;
        }
        let mut vector = Vector3::zeros();
        vector.iter_mut().zip(&values.reals[places]).for_each(|(to, value)| *to = *value);
        *part = Some(vector);
    }
    let [place, euler, v_n, omega_ib_b, f_b, temperature] = parts;
    let (place, euler) = (place.unwrap_or_default(), euler.unwrap_or_default());
    Ok(FlightSample {
        time_s,
        place: Geodetic { latitude_rad: place.x, longitude_rad: place.y, height_m: place.z },
        v_n,
        euler: Euler { roll: euler.x, pitch: euler.y, heading: euler.z },
        omega_ib_b,
        f_b,
        temperature_c: temperature.map(|vector| vector.x),
    })
}

/// Sentences about inputs that no vehicle has, as if a tool had set inputs that are not connected to 0. `before` are the inputs
/// `interval_s` \[s\] ago.
pub fn unconnected(sample: &FlightSample, before: &[f64], interval_s: f64) -> Vec<&'static str> {
    let is_zero = |vector: Option<Vector3<f64>>| vector == Some(Vector3::zeros());
    let Geodetic { latitude_rad, longitude_rad, height_m } = sample.place;
    let moved_m = Vector3::new(
        EARTH_RADIUS_M * (latitude_rad - before[0]),
        EARTH_RADIUS_M * (longitude_rad - before[1]) * sin_cos(latitude_rad).1,
        height_m - before[2],
    );
    let moves = before[VELOCITY_AT..][..3] == [0.0; 3] && moved_m.norm() > MOVES_M_S * interval_s;
    let signs = [
        (
            is_zero(sample.v_n) && moves,
            "truth.velocity_* are 0, but the position moves: if they are not connected, set use_velocity to false",
        ),
        (
            is_zero(sample.omega_ib_b),
            "truth.rate_rad_s is 0, but the Earth turns: if it is not connected, set use_rates to false",
        ),
        (
            is_zero(sample.f_b),
            "truth.force_m_s2 is 0, as in free fall: if it is not connected, set use_forces to false",
        ),
    ];
    signs.into_iter().filter_map(|(is_there, text)| is_there.then_some(text)).collect()
}
