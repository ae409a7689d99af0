//! The box of the INS: its panel as inputs, what it reports and shows as outputs. It exists if `unit.start` of the scene says so.

use sins::earth::Geodetic;
use sins::unit::{Mode, Power, Reasons, State, Status, Unit, UnitNavigation, Validity};
use sins::{Error, ErrorKind, Simulator};

use crate::outputs::Number;
use crate::values::{Value, Values};
use crate::variable::{Role, Variable};
use crate::{corrections, inputs};

/// The numbers that are entered, behind the reals of the corrections.
#[rustfmt::skip]
const ENTRIES: [Number; 9] = [
    ("panel.latitude_rad", "rad", 1.0, "latitude that is entered"),
    ("panel.longitude_rad", "rad", 1.0, "longitude that is entered"),
    ("panel.heading_rad", "rad", 1.0, "heading that is entered in ATT"),
    ("fix.latitude_rad", "rad", 1.0, "latitude of a fix for an alignment in flight"),
    ("fix.longitude_rad", "rad", 1.0, "its longitude"),
    ("fix.height_m", "m", 1000.0, "its height above the ellipsoid"),
    ("fix.velocity_enu_m_s[1]", "m/s", 100.0, "its velocity east"),
    ("fix.velocity_enu_m_s[2]", "m/s", 100.0, "its velocity north"),
    ("fix.velocity_enu_m_s[3]", "m/s", 100.0, "its velocity up"),
];

/// Selector and power; the first word leaves them as the scene has them.
const MODES: [&str; 5] = ["scene", "off", "align", "nav", "att"];
const POWERS: [&str; 4] = ["scene", "aircraft_power", "battery", "no_power"];

/// Places in the row of integers, behind the count of the corrections.
const MODE: usize = 1;
const POWER: usize = 2;
const POSITIONS: usize = 3;
const HEADINGS: usize = 4;
const FIXES: usize = 5;

/// Place of the test in the row of booleans.
const TEST: usize = 0;

/// Place behind it: that of the first parameter that turns a group of inputs off.
pub const SWITCHES: usize = TEST + 1;

/// Numbers of entries and of fixes that the master has counted.
pub type Counts = [i32; 3];

/// The inputs as variables.
pub fn inputs() -> impl Iterator<Item = Variable> {
    let numbers = ENTRIES.iter().map(|&(name, unit, nominal, doc)| {
        let variable = Variable::new(name, Role::Input, Value::Real(0.0), doc).in_unit(unit, 1.0);
        Variable { nominal, ..variable }
    });
    let words = |name: &str, words: &'static [&'static str], doc: &str| {
        let doc = format!("{doc}; scene: as the scene has it");
        Variable { words: Some(words), ..Variable::new(name, Role::Input, Value::Integer(1), doc) }
    };
    let count = |name: &str, what: &str| {
        let doc = format!("number of entries; a step at which it has changed takes the {what}");
        Variable::new(name, Role::Input, Value::Integer(0), doc)
    };
    let test =
        Variable::new("panel.test", Role::Input, Value::Boolean(false), "the button of the test is pressed");
    numbers.chain([
        words("panel.mode", &MODES, "mode selector"),
        words("panel.power", &POWERS, "supply of power"),
        count("panel.position_count", "position"),
        count("panel.heading_count", "heading"),
        count("fix.count", "fix"),
        test,
    ])
}

/// The numbers of entries and of fixes that the master has counted.
pub fn counts(values: &Values) -> Counts {
    [POSITIONS, HEADINGS, FIXES].map(|place| values.integers[place])
}

fn entries(values: &Values) -> [f64; ENTRIES.len()] {
    std::array::from_fn(|k| values.reals[inputs::COUNT + corrections::REALS + k])
}

/// A sentence for each entry and fix of a unit without a box, where they have no effect.
pub fn without_a_box(values: &Values, counted: Counts) -> Vec<String> {
    let names = ["panel.position_count", "panel.heading_count", "fix.count"];
    let entered =
        names.iter().zip(counts(values).into_iter().zip(counted)).filter(|(_, (now, before))| now != before);
    entered
        .map(|(name, _)| format!("{name}: nothing is entered: without unit.start there is no box"))
        .collect()
}

/// Gives the unit, after its update, the fix of the inputs if it is a new one.
pub fn push_fix(
    values: &Values,
    [_, _, fixes]: Counts,
    unit: &mut Unit,
    simulator: &mut Simulator,
) -> Result<(), Error> {
    if counts(values)[2] == fixes {
        return Ok(());
    }
    let [_, _, _, latitude_rad, longitude_rad, height_m, east, north, up] = entries(values);
    unit.push_fix(simulator, Geodetic { latitude_rad, longitude_rad, height_m }, [east, north, up].into())
}

/// Does at the panel what the inputs say. An entry at the wrong moment is no fault of the simulation: a sentence for each is returned. A
/// number out of its range is an error.
pub fn act(
    values: &Values,
    [positions, headings, _]: Counts,
    unit: &mut Unit,
) -> Result<Vec<String>, String> {
    let word = |name: &str, place: usize, count: usize| {
        let number = values.integers[place];
        let index = number.checked_sub(1).and_then(|index| usize::try_from(index).ok());
        let index = index.filter(|index| *index < count);
        index.ok_or_else(|| format!("{name} = {number}: must be from 1 to {count}"))
    };
    let modes = [None, Some(Mode::Off), Some(Mode::Align), Some(Mode::Navigate), Some(Mode::Attitude)];
    let powers = [None, Some(Power::Aircraft), Some(Power::Battery), Some(Power::None)];
    if let Some(mode) = modes[word("panel.mode", MODE, modes.len())?] {
        unit.select(mode);
    }
    if let Some(power) = powers[word("panel.power", POWER, powers.len())?] {
        unit.set_power(power);
    }
    if values.booleans[TEST] {
        unit.press_test();
    }
    let [latitude_rad, longitude_rad, heading_rad, ..] = entries(values);
    let mut refused = Vec::new();
    let mut enter = |name: &str, entered: Result<(), Error>| match entered {
        Err(error) if error.kind == ErrorKind::BadState => {
            refused.push(format!("{name}: nothing is entered: {error}"));
            Ok(())
        }
        other => other.map_err(|error| format!("panel.{error}")),
    };
    let now = counts(values);
    if now[0] != positions {
        enter("panel.position_count", unit.enter_position(latitude_rad, longitude_rad))?;
    }
    if now[1] != headings {
        enter("panel.heading_count", unit.enter_heading(heading_rad))?;
    }
    Ok(refused)
}

/// What it shows, and times.
#[rustfmt::skip]
const NUMBERS: [Number; 17] = [
    ("status.to_go_s", "s", 100.0, "time to the end of an alignment, a realignment or an erection"),
    ("status.in_navigation_s", "s", 1000.0, "time in navigation since the alignment"),
    ("shown.latitude_rad", "rad", 1.0, "shown latitude"),
    ("shown.longitude_rad", "rad", 1.0, "shown longitude"),
    ("shown.height_m", "m", 1e4, "shown height above the ellipsoid"),
    ("shown.velocity_east_m_s", "m/s", 100.0, "shown velocity, east"),
    ("shown.velocity_north_m_s", "m/s", 100.0, "shown velocity, north"),
    ("shown.velocity_up_m_s", "m/s", 10.0, "shown velocity, up"),
    ("shown.roll_rad", "rad", 1.0, "shown roll"),
    ("shown.pitch_rad", "rad", 1.0, "shown pitch"),
    ("shown.heading_rad", "rad", 1.0, "shown heading"),
    ("shown.rate_rad_s[1]", "rad/s", 1.0, "shown angular rate, body axis x"),
    ("shown.rate_rad_s[2]", "rad/s", 1.0, "shown angular rate, body axis y"),
    ("shown.rate_rad_s[3]", "rad/s", 1.0, "shown angular rate, body axis z"),
    ("shown.force_m_s2[1]", "m/s2", 10.0, "shown specific force, body axis x"),
    ("shown.force_m_s2[2]", "m/s2", 10.0, "shown specific force, body axis y"),
    ("shown.force_m_s2[3]", "m/s2", 10.0, "shown specific force, body axis z"),
];

/// Annunciators.
const LAMPS: [(&str, &str); 6] = [
    ("align", "annunciator ALIGN"),
    ("align_flashes", "ALIGN flashes: the crew has to do something"),
    ("navigation_ready", "annunciator NAV RDY"),
    ("fault", "annunciator FAULT"),
    ("on_battery", "annunciator ON BATT"),
    ("in_test", "a test is on"),
];

/// Number of flags.
pub const FLAGS: usize = LAMPS.len() + Reasons::FLAGS.len() + Validity::FLAGS.len();

/// Annunciators, reasons and validity: name and meaning.
pub fn flags() -> impl Iterator<Item = (String, String)> {
    let lamps = LAMPS.iter().map(|(name, meaning)| (format!("status.{name}"), (*meaning).to_owned()));
    let of = |prefix: &'static str, kind: &'static str| {
        move |(name, meaning): &(&str, &str)| {
            (format!("status.{prefix}{name}"), format!("{kind}:{}", meaning.trim_end_matches('.')))
        }
    };
    lamps
        .chain(Reasons::FLAGS.iter().map(of("", "reason")))
        .chain(Validity::FLAGS.iter().map(of("valid_", "valid")))
}

/// Number of reals that are outputs.
pub const COUNT: usize = NUMBERS.len();

/// The reals: name, unit, usual size, meaning of each output.
pub fn numbers() -> impl Iterator<Item = (String, &'static str, f64, String)> {
    NUMBERS.iter().map(|&(name, unit, nominal, doc)| {
        (name.to_owned(), unit, nominal, format!("{doc}; 0 while it is not valid"))
    })
}

/// The state, an enumeration.
pub fn state() -> Variable {
    let variable = Variable::new("status.state", Role::Output, Value::Integer(1), "what the box is doing");
    Variable { words: Some(&State::ALL_WORDS), ..variable }
}

/// What the box has to say after a step: the state, the numbers, the flags.
pub struct Report {
    pub state: i32,
    pub numbers: [f64; COUNT],
    pub flags: [bool; FLAGS],
}

/// The report of a box, or of none.
pub fn report(unit: Option<&Unit>, simulator: &Simulator) -> Result<Report, Error> {
    let (status, shown) = match unit {
        Some(unit) => (unit.status(), unit.navigation(simulator)?),
        None => (Status::default(), UnitNavigation::default()),
    };
    let UnitNavigation { place, v_n, euler, rate_b, force_b, .. } = &shown;
    let mut numbers = [status.to_go_s, status.in_navigation_s].into_iter().chain(
        [
            [place.latitude_rad, place.longitude_rad, place.height_m],
            (*v_n).into(),
            [euler.roll, euler.pitch, euler.heading],
            (*rate_b).into(),
            (*force_b).into(),
        ]
        .into_iter()
        .flatten(),
    );
    let lamps = [
        status.align,
        status.align_flashes,
        status.navigation_ready,
        status.fault,
        status.on_battery,
        status.in_test,
    ];
    let mut flags = lamps.into_iter().chain(status.reasons.all()).chain(status.validity.all());
    Ok(Report {
        state: status.state as i32 + 1,
        numbers: std::array::from_fn(|_| numbers.next().unwrap_or_default()),
        flags: std::array::from_fn(|_| flags.next().unwrap_or_default()),
    })
}
