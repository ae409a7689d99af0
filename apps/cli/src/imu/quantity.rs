//! Quantity of a column, from its name: known names, units in brackets, and units at the end.

use sins::log::{ImuColumn, TimeFormat, imu_units};
use sins::scene::listed;

use crate::failure::Failure;

/// Sensor of a column.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sensor {
    Gyro,
    Accelerometer,
}

/// A sensor's output in a unit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Quantity {
    /// Its name in `[imu]`, as "deg/s".
    pub unit: &'static str,
    pub sensor: Sensor,
    /// Angle or velocity over an interval, not their rate.
    pub is_increment: bool,
    /// Size of the unit in rad/s, m/s², rad or m/s.
    pub si: f64,
}

/// The quantities, one for each unit of `[imu]`.
fn quantities() -> impl Iterator<Item = Quantity> {
    imu_units().map(|unit| Quantity {
        unit: unit.name,
        sensor: if unit.is_gyro { Sensor::Gyro } else { Sensor::Accelerometer },
        is_increment: unit.is_increment,
        si: unit.si,
    })
}

/// A column to read.
#[derive(Debug, Clone, PartialEq)]
pub struct Wanted {
    pub name: String,
    /// Unit of the column, if the name does not say it.
    pub unit: Option<String>,
}

/// A column of the command line: NAME or NAME=UNIT.
pub fn wanted(text: &str) -> Result<Wanted, String> {
    let (name, unit) = match text.rsplit_once('=').or_else(|| text.rsplit_once(':')) {
        Some((name, unit)) => (name, Some(plain_unit(unit))),
        None => (text, None),
    };
    Ok(Wanted { name: name.trim().to_owned(), unit })
}

/// A unit as the ends of names have it: deg/s and deg s^-1 are deg_s, m/s² is m_s2.
fn plain_unit(text: &str) -> String {
    let text = text.trim().replace("dps", "deg/s").replace(['°', 'º'], "deg").replace(['µ', 'μ'], "u");
    let text = text.replace(" s^-", "/s").replace(" s-", "/s").replace("*s^-", "/s").replace("/s1", "/s");
    text.replace('/', "_").replace('²', "2").replace(['^', ' '], "")
}

/// The columns with the three of a sensor in the order x, y, z, if one letter of their names says it.
fn in_order(mut columns: Vec<(String, Quantity)>) -> Vec<(String, Quantity)> {
    for of_sensor in columns.chunk_by_mut(|one, next| one.1.sensor == next.1.sensor) {
        let names: Vec<Vec<char>> =
            of_sensor.iter().map(|(name, _)| name.to_lowercase().chars().collect()).collect();
        let [first, second, third] = &names[..] else { continue };
        let places = first.iter().zip(second).zip(third).map(|((a, b), c)| [*a, *b, *c]);
        let differing: Vec<[char; 3]> =
            places.filter(|letters| letters.iter().any(|letter| *letter != letters[0])).collect();
        let is_as_long = second.len() == first.len() && third.len() == first.len();
        if let [letters] = differing[..]
            && is_as_long
            && ['x', 'y', 'z'].iter().all(|axis| letters.contains(axis))
        {
            let mut ordered: Vec<(char, (String, Quantity))> =
                letters.into_iter().zip(of_sensor.iter().cloned()).collect();
            ordered.sort_by_key(|(axis, _)| *axis);
            of_sensor.iter_mut().zip(ordered).for_each(|(place, (_, column))| *place = column);
        }
    }
    columns
}

/// A recorder whose columns have no unit in their names.
struct Recorder {
    /// Column of times, and its unit [s]. Others write GyrX in other units: only a table with this column is of the recorder.
    time: (&'static str, f64),
    /// Names without the axis.
    gyro: (&'static str, &'static str),
    accel: (&'static str, &'static str),
}

/// Evidence: the messages IMU of ArduPilot, the topic sensor_combined of PX4, the exports of MT Manager of Xsens and of the Control Center
/// of VectorNav; sensor_msgs/Imu of ROS by `rostopic echo -p` and by bagpy, in the units of REP 103.
const RECORDERS: [Recorder; 6] = [
    Recorder { time: ("TimeUS", 1e-6), gyro: ("Gyr", "rad_s"), accel: ("Acc", "m_s2") },
    Recorder {
        time: ("timestamp", 1e-6),
        gyro: ("gyro_rad", "rad_s"),
        accel: ("accelerometer_m_s2", "m_s2"),
    },
    Recorder { time: ("SampleTimeFine", 1e-4), gyro: ("Gyr_", "rad_s"), accel: ("Acc_", "m_s2") },
    Recorder { time: ("TimeStartup", 1e-9), gyro: ("Gyro", "rad_s"), accel: ("Accel", "m_s2") },
    Recorder {
        time: ("field.header.stamp", 1e-9),
        gyro: ("field.angular_velocity", "rad_s"),
        accel: ("field.linear_acceleration", "m_s2"),
    },
    Recorder {
        time: ("Time", 1.0),
        gyro: ("angular_velocity", "rad_s"),
        accel: ("linear_acceleration", "m_s2"),
    },
];
const AXES: [&str; 9] = ["X", "Y", "Z", "[0]", "[1]", "[2]", ".x", ".y", ".z"];

impl Recorder {
    /// The recorder of a table with these columns.
    fn of(names: &[String]) -> Option<&'static Self> {
        RECORDERS.iter().find(|recorder| {
            let has_time = names.iter().any(|name| name == recorder.time.0);
            has_time && names.iter().any(|name| recorder.quantity(name).is_some())
        })
    }

    fn quantity(&self, name: &str) -> Option<Quantity> {
        let stem = AXES.iter().find_map(|axis| name.strip_suffix(axis))?;
        of_unit([self.gyro, self.accel].into_iter().find(|(known, _)| *known == stem)?.1)
    }
}

/// The quantity of a unit in the form of the ends of names.
fn of_unit(unit: &str) -> Option<Quantity> {
    quantities().find(|quantity| plain_unit(quantity.unit) == unit)
}

/// Words that mark the name of a column of increments. Other columns, such as latitude_rad, have none of them.
const INCREMENT_WORDS: [&str; 2] = ["increment", "delta"];

/// Largest number of columns that are analysed.
const MOST: usize = 6;

/// How a column of time stamps is written.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Stamp {
    /// As numbers of this unit [s].
    Number(f64),
    Clock(TimeFormat),
}

/// Units of time stamps. A column time_s, time_ms, time_us or time_ns needs none.
const STAMPS: [(&str, Stamp); 6] = [
    ("s", Stamp::Number(1.0)),
    ("ms", Stamp::Number(1e-3)),
    ("us", Stamp::Number(1e-6)),
    ("ns", Stamp::Number(1e-9)),
    ("iso", Stamp::Clock(TimeFormat::Iso)),
    ("hms", Stamp::Clock(TimeFormat::Hms)),
];

/// The column of time stamps: the wanted one with a unit of time, or the one whose name says it.
pub fn stamps(names: &[String], wanted: &[Wanted]) -> Option<(String, Stamp)> {
    let own = |(unit, stamp): &(&str, Stamp)| {
        let name = names.iter().find(|name| in_small(name) == format!("time_{unit}"))?;
        Some((name.clone(), *stamp))
    };
    let chosen = wanted.iter().find_map(|wanted| Some((wanted.name.clone(), stamp(wanted)?)));
    let known = |recorder: &Recorder| (recorder.time.0.to_owned(), Stamp::Number(recorder.time.1));
    let in_brackets = |name: &String| {
        let (stem, unit) = in_brackets(name)?;
        let is_time = stem.to_lowercase().contains("time");
        let unit = OF_NAMES.iter().find(|(known, _)| *known == unit)?.1;
        is_time.then(|| (name.clone(), unit))
    };
    chosen
        .or_else(|| OF_NAMES.iter().find_map(own))
        .or_else(|| Recorder::of(names).map(known))
        .or_else(|| names.iter().find_map(in_brackets))
}

/// The name and the unit of "name [unit]" or "name (unit)".
fn in_brackets(name: &str) -> Option<(&str, String)> {
    let text = name.trim().strip_suffix([']', ')'])?;
    let at = text.rfind(['[', '('])?;
    let (stem, unit) = (text[..at].trim(), plain_unit(&text[at + 1..]));
    (!stem.is_empty()).then_some((stem, unit))
}

/// Units of time that the end of a name can have.
const OF_NAMES: &[(&str, Stamp)] = STAMPS.split_at(4).0;

/// Whether a column of this name has the times of the rows.
fn is_time(name: &str) -> bool {
    OF_NAMES.iter().any(|(unit, _)| in_small(name).strip_prefix("time_") == Some(unit))
}

fn stamp(wanted: &Wanted) -> Option<Stamp> {
    let unit = wanted.unit.as_deref()?;
    STAMPS.into_iter().find(|(name, _)| *name == unit).map(|(_, stamp)| stamp)
}

/// A name that has capitals alone, in small letters.
fn in_small(name: &str) -> String {
    if name.chars().any(char::is_lowercase) { name.to_owned() } else { name.to_lowercase() }
}

/// Quantity with the unit in brackets or at the end of `name`, after an underscore, or that of its recorder.
fn by_name(name: &str, recorder: Option<&Recorder>) -> Option<Quantity> {
    let small = in_small(name);
    let in_brackets = in_brackets(&small).and_then(|(_, unit)| of_unit(&unit));
    let at_end = || {
        let plain = plain_unit(&small);
        let is_at_end = |unit: &str| plain.strip_suffix(unit).is_some_and(|stem| stem.ends_with('_'));
        quantities()
            .filter(|quantity| is_at_end(&plain_unit(quantity.unit)))
            .max_by_key(|quantity| quantity.unit.len())
    };
    in_brackets.or_else(at_end).or_else(|| recorder?.quantity(name))
}

/// Columns of the header `names` that are analysed. The argument `flag` of the command line chooses them.
pub fn choose(names: &[String], wanted: &[Wanted], flag: &str) -> Result<Vec<(String, Quantity)>, Failure> {
    let recorder = Recorder::of(names);
    let wanted_before = |place: usize, name: &str| wanted[..place].iter().any(|before| before.name == name);
    for (place, wanted) in wanted.iter().enumerate() {
        let Wanted { name, .. } = wanted;
        if !names.contains(name) {
            let header = listed(names.iter().map(String::as_str));
            return Err(Failure::new(format!(
                "expected a column \"{name}\" in the header, which has {header}"
            )));
        }
        if wanted_before(place, name) {
            return Err(Failure::new(format!("{flag}: \"{name}\" stands there twice")));
        }
        if is_time(name) && stamp(wanted).is_none() && wanted.unit.is_some() {
            return Err(Failure::new(format!(
                "{flag}: \"{name}\" has the times of the rows, which are no output of a sensor; rename it if it has others"
            )));
        }
    }
    if let Some(name) =
        names.iter().enumerate().find_map(|(place, name)| names[..place].contains(name).then_some(name))
        && (wanted.is_empty() && by_name(name, recorder).is_some()
            || wanted.iter().any(|wanted| wanted.name == *name))
    {
        return Err(Failure::new(format!("two columns are named \"{name}\": give them names of their own")));
    }
    let mut wanted = wanted.iter().filter(|wanted| stamp(wanted).is_none()).peekable();
    let chosen = if wanted.peek().is_none() {
        let is_sensor = |name: &str, quantity: &Quantity| {
            !quantity.is_increment || INCREMENT_WORDS.iter().any(|word| name.to_lowercase().contains(word))
        };
        let all = names.iter().filter_map(|name| Some((name.clone(), by_name(name, recorder)?)));
        in_order(all.filter(|(name, quantity)| is_sensor(name, quantity)).collect())
    } else {
        wanted.map(|wanted| find(wanted, recorder)).collect::<Result<Vec<_>, _>>()?
    };
    match chosen.len() {
        1..=MOST => Ok(chosen),
        0 => {
            let header = listed(names.iter().map(String::as_str));
            Err(Failure::new(format!(
                "no name of a column ends with the unit of a rate or force; choose columns with {flag}: {header}"
            )))
        }
        count => {
            let names: Vec<&str> = chosen.iter().map(|(name, _)| name.as_str()).collect();
            let names = names.join(", ");
            Err(Failure::new(format!(
                "expected up to {MOST} columns, found {count}; choose some with {flag}: {names}"
            )))
        }
    }
}

fn find(wanted: &Wanted, recorder: Option<&Recorder>) -> Result<(String, Quantity), Failure> {
    let Wanted { name, unit } = wanted;
    let quantity = match unit {
        Some(unit) => of_unit(unit),
        None => by_name(name, recorder),
    };
    let quantity = quantity.ok_or_else(|| {
        let times = STAMPS.iter().map(|stamp| stamp.0.to_owned());
        let units: Vec<String> =
            quantities().map(|quantity| plain_unit(quantity.unit)).chain(times).collect();
        let units = listed(units.iter().map(String::as_str));
        Failure::new(format!("column \"{name}\": expected its unit as NAME=UNIT, one of {units}"))
    })?;
    Ok((name.clone(), quantity))
}

/// The quantity of a column of `[imu]`: by the unit that stands there, otherwise by its name.
pub fn mapped(column: &ImuColumn) -> Result<Quantity, Failure> {
    let ImuColumn { key, name, unit, is_gyro, .. } = column;
    let sensor = if *is_gyro { Sensor::Gyro } else { Sensor::Accelerometer };
    let of_sensor = || quantities().filter(|quantity| quantity.sensor == sensor);
    let found = match *unit {
        "" => by_name(name, None),
        unit => of_sensor().find(|quantity| quantity.unit == unit),
    };
    let units = listed(of_sensor().map(|quantity| quantity.unit));
    match found {
        Some(quantity) if quantity.sensor == sensor => Ok(quantity),
        Some(quantity) => Err(Failure::new(format!(
            "{key}.unit: the name of the column {name} says {}: expected one of {units}",
            quantity.unit
        ))),
        None => Err(Failure::new(format!(
            "{key}.unit: the name of the column {name} says no unit: expected one of {units}"
        ))),
    }
}

/// The name of the unit of time stamps, if they are numbers in one.
pub fn unit_of_time(si: f64) -> Option<&'static str> {
    OF_NAMES.iter().find(|(_, stamp)| *stamp == Stamp::Number(si)).map(|(unit, _)| *unit)
}

#[cfg(test)]
mod tests {
    use super::*;
    use sins::units::DEG_PER_HOUR;

    fn names(header: &str) -> Vec<String> {
        header.split(',').map(str::to_owned).collect()
    }

    fn chosen(header: &str, wanted: &[(&str, Option<&str>)]) -> Result<Vec<(String, Quantity)>, String> {
        let wanted = wanted
            .iter()
            .map(|(name, unit)| Wanted { name: (*name).to_owned(), unit: unit.map(str::to_owned) });
        choose(&names(header), &wanted.collect::<Vec<_>>(), "--columns")
            .map_err(|failure| failure.to_string())
    }

    #[test]
    fn units_are_reported_by_the_end_of_the_name() {
        for (name, unit) in [
            ("gyro_x_rad_s", "rad_s"),
            ("angle_increment_x_rad", "rad"),
            ("w_deg_h", "deg_h"),
            ("force_z_m_s2", "m_s2"),
            ("velocity_increment_x_m_s", "m_s"),
            ("a_mg", "mg"),
            ("a_g", "g"),
            ("gx_dps", "deg_s"),
            ("GYRO_X_DEG_S", "deg_s"),
            ("ACC_Z_MG", "mg"),
        ] {
            assert_eq!(plain_unit(by_name(name, None).unwrap().unit), unit, "{name}");
        }
        for name in ["time_s", "rad_s", "heading", "omg", "temperature_c"] {
            assert_eq!(by_name(name, None), None, "{name}");
        }
    }

    /// Units in brackets, and names of recorders: these only beside the column of times that the recorder writes.
    #[test]
    fn units_of_recorders_need_their_times() {
        for (name, unit) in [
            ("w_RS_S_x [rad s^-1]", "rad_s"),
            ("AngleRateX (rad/s)", "rad_s"),
            ("Gyro X [mdps]", "mdeg_s"),
            ("gyro [°/s]", "deg_s"),
            ("AccelX (m/s^2)", "m_s2"),
            ("a_RS_S_x [m s^-2]", "m_s2"),
        ] {
            assert_eq!(plain_unit(by_name(name, None).unwrap().unit), unit, "{name}");
        }
        for (header, time) in [
            ("TimeUS,GyrX,AccZ", ("TimeUS", 1e-6)),
            ("timestamp,gyro_rad[0],accelerometer_m_s2[2]", ("timestamp", 1e-6)),
            ("PacketCounter,SampleTimeFine,Gyr_X,Acc_Z", ("SampleTimeFine", 1e-4)),
            ("TimeStartup,GyroX,AccelZ", ("TimeStartup", 1e-9)),
            (
                "%time,field.header.stamp,field.angular_velocity.x,field.linear_acceleration.z",
                ("field.header.stamp", 1e-9),
            ),
            ("Time,header.seq,angular_velocity.x,linear_acceleration.z", ("Time", 1.0)),
        ] {
            let units: Vec<&str> = chosen(header, &[]).unwrap().iter().map(|column| column.1.unit).collect();
            assert_eq!(units, ["rad/s", "m/s2"], "{header}");
            assert_eq!(stamps(&names(header), &[]), Some((time.0.to_owned(), Stamp::Number(time.1))));
            let others = header.replace(time.0, "when");
            assert!(chosen(&others, &[]).unwrap_err().contains("--columns"), "{others}");
        }
        let capitals = names("TIME_MS,GYRO_X_DEG_S");
        assert_eq!(stamps(&capitals, &[]), Some(("TIME_MS".to_owned(), Stamp::Number(1e-3))));
        // Times of an unknown recorder have an unknown unit.
        assert_eq!(stamps(&names("timestamp,wx_deg_s"), &[]), None);
        let nanoseconds = "timestamp [ns]";
        assert_eq!(
            stamps(&names("timestamp [ns],wx_deg_s"), &[]),
            Some((nanoseconds.into(), Stamp::Number(1e-9)))
        );
    }

    #[test]
    fn attitudes_and_velocities_are_no_increments() {
        let columns = chosen("time_s,roll_rad,velocity_up_m_s,gyro_x_deg_s,delta_v_m_s", &[]).unwrap();
        let names: Vec<&str> = columns.iter().map(|(name, _)| name.as_str()).collect();
        assert_eq!(names, ["gyro_x_deg_s", "delta_v_m_s"]);
    }

    #[test]
    fn columns_are_chosen_and_given_units() {
        let columns = chosen("t,wx,roll_rad", &[("roll_rad", None), ("wx", Some("deg_h"))]).unwrap();
        assert!(columns[0].1.is_increment && columns[1].1.si == DEG_PER_HOUR);
        assert!(chosen("t,wx", &[("wx", None)]).unwrap_err().contains("NAME=UNIT"));
        assert!(chosen("t,wx", &[("wy", None)]).unwrap_err().contains("\"wy\""));
        assert!(chosen("t,wx", &[]).unwrap_err().contains("--columns"));
        let header = names("t,time_ms,wx_deg_s");
        let iso = [Wanted { name: "t".into(), unit: Some("iso".into()) }];
        assert_eq!(stamps(&header, &iso), Some(("t".into(), Stamp::Clock(TimeFormat::Iso))));
        assert_eq!(stamps(&header, &[]), Some(("time_ms".into(), Stamp::Number(1e-3))));
        assert_eq!(choose(&header, &iso, "--columns").unwrap()[0].0, "wx_deg_s");
        for time in ["time_s", "time_ms", "time_us", "time_ns"] {
            let errors = chosen(&format!("{time},wx"), &[(time, Some("rad_s"))]).unwrap_err();
            assert!(errors.contains(&format!("\"{time}\" has the times of the rows")), "{errors}");
        }
        assert!(chosen("a_g,b_g,c_g,d_g,e_g,f_g,h_g", &[]).unwrap_err().contains("found 7"));
    }
}
