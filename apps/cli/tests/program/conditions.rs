//! Scenes from a file: mounting, gravity, temperature, failures and updates act on a flight as computed in closed form.

use std::fmt::Write as _;
use std::path::Path;

use crate::support::{done, folder, read, rejected};

const DEG_PER_HOUR: f64 = std::f64::consts::PI / 180.0 / 3600.0;

/// Two minutes at rest, a sample each second, without random errors; the increments are written, one part a second.
const REST: &str = "[options]\nsubsamples = 1\n[output]\nimu = 'imu.csv'\n[flight]\nbuiltin = 'rest'\n\
    hours = 0.03333333333333333\nrate_hz = 1\n";

/// Flies a scene and returns the text of its increments.
fn fly(folder: &Path, text: &str) -> String {
    std::fs::write(folder.join("scene.toml"), text).unwrap();
    done(folder, &["fly", "scene.toml", "--quiet"]);
    read(folder.join("sins_out/imu.csv"))
}

/// A column of a table.
fn column(table: &str, name: &str) -> Vec<f64> {
    let mut lines = table.lines();
    let at = lines.next().unwrap().split(',').position(|found| found == name).unwrap();
    lines.map(|line| line.split(',').nth(at).unwrap().parse().unwrap()).collect()
}

/// Measurement of the second flight less the measurement of the first, each second.
fn more(undisturbed: &str, other: &str, name: &str) -> Vec<f64> {
    let pairs = column(undisturbed, name).into_iter().zip(column(other, name));
    pairs.map(|(undisturbed, other)| other - undisturbed).collect()
}

#[test]
fn a_turned_block_and_disturbed_gravity_are_measured() {
    let folder = folder("world");
    let undisturbed = fly(&folder, REST);
    let turned = fly(&folder, &format!("{REST}[mounting]\nboresight_deg = [0, 0, 90]\n"));
    // At rest with heading north, the x axis of the turned block points south and senses the opposite component of the Earth rate.
    let north = column(&undisturbed, "angle_increment_y_rad");
    let south = column(&turned, "angle_increment_x_rad");
    for (north, south) in north.iter().zip(&south) {
        // A rotation of an angle below 1e-4, by a sine and a cosine that each have a rounding error.
        assert!(*north > 5e-5 && (north + south).abs() < 8.0 * f64::EPSILON * 1e-4, "{north:e} {south:e}");
    }
    let heavy = fly(&folder, &format!("{REST}[gravity]\nanomaly_mgal = 100\n"));
    for error in more(&undisturbed, &heavy, "velocity_increment_z_m_s") {
        // 100 mGal are 1e-3 m/s2. The error is a difference of two numbers below 10.
        assert!((error - 1e-3).abs() < 4.0 * f64::EPSILON * 10.0, "{error:e}");
    }
}

#[test]
fn the_temperature_changes_steadily_and_a_log_gives_its_own() {
    let folder = folder("temperature");
    let gyro = "[gyro]\nreference_temperature_c = 15\nbias_temperature_deg_h_per_k = [1, 0, 0]\n";
    let undisturbed = fly(&folder, REST);
    let warming = format!("{REST}temperature_c = 20\ntemperature_change_c_h = 3600\n{gyro}");
    let warm = fly(&folder, &warming);
    let errors = more(&undisturbed, &warm, "angle_increment_x_rad");
    assert_eq!(errors.len(), 120);
    for (second, error) in errors.iter().enumerate() {
        // 5 K at the beginning and 1 K/s, in the middle of the second. The error is a difference of two numbers below 1e-3.
        let expected = (5.0 + second as f64 + 0.5) * DEG_PER_HOUR;
        assert!((error - expected).abs() < 4.0 * f64::EPSILON * 1e-3, "{second}: {error:e} {expected:e}");
    }
    assert!(more(&undisturbed, &warm, "angle_increment_y_rad").iter().all(|&error| error == 0.0));

    let mut log =
        String::from("time_s,latitude_deg,longitude_deg,height_m,velocity_east_m_s,velocity_north_m_s,");
    log += "velocity_up_m_s,roll_deg,pitch_deg,heading_deg,temperature_c\n";
    for second in 0..=120 {
        writeln!(log, "{second},39.9,116.4,50,0,0,0,0,0,0,{}", 20 + second).unwrap();
    }
    std::fs::write(folder.join("log.csv"), &log).unwrap();
    let flight = "[output]\nimu = 'imu.csv'\n[options]\nsubsamples = 1\nsample_period_s = 1\n[flight]\nfile = 'log.csv'\n";
    let by_column = fly(&folder, &format!("{flight}{gyro}"));

    // A log without the column uses the keys, from its first time stamp on.
    let late = |line: &str| {
        let (time, rest) = line.split_once(',').unwrap();
        let (rest, _) = rest.rsplit_once(',').unwrap();
        let time = time.parse::<f64>().map_or(time.to_owned(), |time| (time + 50.0).to_string());
        format!("{time},{rest}\n")
    };
    std::fs::write(folder.join("log.csv"), log.lines().map(late).collect::<String>()).unwrap();
    let keys = "temperature_c = 20\ntemperature_change_c_h = 3600\n";
    let shifted = fly(&folder, &format!("{flight}{keys}{gyro}"));
    assert_eq!(column(&shifted, "angle_increment_x_rad"), column(&by_column, "angle_increment_x_rad"));
    let cold = fly(&folder, flight);
    let errors = more(&cold, &by_column, "angle_increment_x_rad");
    assert!((errors[119] - 124.5 * DEG_PER_HOUR).abs() < 4.0 * f64::EPSILON * 1e-3, "{:e}", errors[119]);

    // Coefficients without a temperature, and two temperatures, are refused.
    for (text, log, expected) in [
        (format!("{REST}{gyro}"), String::new(), "scene.toml: at 0"),
        (
            format!("{flight}{keys}"),
            log,
            "scene.toml:8: flight.temperature_c: the log has a column of that name",
        ),
    ] {
        std::fs::write(folder.join("log.csv"), log).unwrap();
        std::fs::write(folder.join("scene.toml"), text).unwrap();
        let errors = rejected(&folder, &["fly", "scene.toml", "--quiet"]);
        assert!(errors.starts_with(expected), "{expected}\n{errors}");
    }
}

/// The seconds, from 0, in which a column differs.
fn seconds(undisturbed: &str, other: &str, name: &str) -> Vec<usize> {
    let errors = more(undisturbed, other, name);
    (0..errors.len()).filter(|&second| errors[second] != 0.0).collect()
}

#[test]
fn a_failure_acts_between_its_times() {
    let folder = folder("failures");
    let failure = |output: &str, body: &str| format!("[[failure]]\nsensor = {output}\nkind = {body}\n");
    let undisturbed = fly(&folder, REST);

    // Of two failures of one output, the later one is written first. One ends and the other begins at 70 s.
    let steps = failure("'gyro'\naxis = 'x'", "'bias_step'\nsize_deg_h = -50\nfrom_s = 70\nuntil_s = 80")
        + &failure("'gyro'\naxis = 'x'", "'bias_step'\nsize_deg_h = 100\nfrom_s = 30\nuntil_s = 70")
        // Times between samples: the failure acts from the first step after its begin until the first step after its end.
        + &failure("'accelerometer'\naxis = 'z'", "'dead'\nfrom_s = 40.5\nuntil_s = 43.2")
        + &failure("'gyro'\naxis = 'y'", "'none'\nfrom_s = 1")
        + &failure("'gyro'\naxis = 'z'", "'bias_step'\nsize_deg_h = 1\nfrom_s = 115");
    let failed = fly(&folder, &format!("{REST}{steps}"));
    for (second, error) in more(&undisturbed, &failed, "angle_increment_x_rad").into_iter().enumerate() {
        let step = match second {
            30..70 => 100.0,
            70..80 => -50.0,
            _ => 0.0,
        };
        // The difference of two numbers below 1e-3; without a failure the numbers are identical.
        let tolerance = if step == 0.0 { 0.0 } else { 4.0 * f64::EPSILON * 1e-3 };
        assert!((error - step * DEG_PER_HOUR).abs() <= tolerance, "{second}: {error:e}");
    }
    assert_eq!(seconds(&undisturbed, &failed, "angle_increment_y_rad"), []);
    assert_eq!(seconds(&undisturbed, &failed, "angle_increment_z_rad"), [115, 116, 117, 118, 119]);
    assert_eq!(seconds(&undisturbed, &failed, "velocity_increment_z_m_s"), [41, 42, 43]);
    assert_eq!(column(&failed, "velocity_increment_z_m_s")[41..44], [0.0; 3]);
    assert_eq!(seconds(&undisturbed, &failed, "velocity_increment_x_m_s"), []);
    let summary = read(folder.join("sins_out/scene_summary.csv"));
    let reported = "3 accelerometer z dead 40.5 s to 43.2 s, 4 gyro z bias step 1 deg/h 115 s to the end";
    assert!(summary.contains(reported), "{summary}");

    // 49 times a 49th of a second is less than a second by rounding. The step still begins at 1 s.
    let fast = REST.replace("rate_hz = 1\n", "rate_hz = 49\n").replace("0.03333333333333333", "0.001");
    let step = failure("'gyro'\naxis = 'x'", "'bias_step'\nsize_deg_h = 100\nfrom_s = 1\nuntil_s = 2");
    let (undisturbed, failed) = (fly(&folder, &fast), fly(&folder, &format!("{fast}{step}")));
    let steps: Vec<usize> = (49..98).collect();
    assert_eq!(seconds(&undisturbed, &failed, "angle_increment_x_rad"), steps);
}

/// An update at a sample shows in the next record; from then on the position error grows from the error of the fix.
#[test]
fn an_update_acts_from_its_time_on() {
    let folder = folder("updates");
    let with = |lines: &str| {
        let rest = REST.replace("subsamples = 1\n", "subsamples = 1\ncovariance = 'on'\n");
        format!("{rest}[start]\nposition_m = [3000, 0, 0]\n{lines}")
    };
    let update = "[[update]]\nkind = \"position\"\nat_s = 30\nevery_s = 60\nsigma_m = [10, 10, 0]\n";
    let flown = |lines: &str| (fly(&folder, &with(lines)), read(folder.join("sins_out/scene.csv")));
    let ((free_imu, free), (updated_imu, updated)) = (flown(""), flown(update));
    assert!(free_imu == updated_imu, "the sensors measure what they measured");
    let time_s = column(&updated, "time_s");
    let changed = seconds(&free, &updated, "navigation_error_position_east_m");
    assert_eq!(time_s[changed[0]], 31.0);
    let east_m = column(&updated, "navigation_error_position_east_m");
    for (time_s, error) in time_s.into_iter().zip(&east_m) {
        assert!(if time_s < 30.5 { *error > 2990.0 } else { error.abs() < 100.0 }, "{time_s}: {error}");
    }
    assert_eq!(seconds(&free, &updated, "sigma_position_east_m"), []);
    let summary = read(folder.join("sins_out/scene_summary.csv"));
    let reported = "updates_text,\"position 30 s every 60 s sigma 10 10 0 m; not in the covariance\"";
    assert!(summary.contains(&reported.replace('"', "")), "{summary}");
}

/// A flight whose first time stamp is not 0: times of failures count from its first sample.
#[test]
fn failures_of_a_log_count_from_its_first_sample() {
    let folder = folder("late");
    let flight = "[output]\nimu = 'imu.csv'\n[options]\nsubsamples = 1\nvertical = 'damped'\nsample_period_s = 1\n\
        [flight]\nfile = 'log.csv'\n";
    let gyro = "[[failure]]\nsensor = 'gyro'\naxis = 'x'\nkind = 'noise'\ndensity_deg_sqrt_h = 3\nfrom_s = 30\nuntil_s = 33\n";
    let altimeter = "[[failure]]\nsensor = 'altimeter'\nkind = 'bias_step'\nsize_m = 40\nfrom_s = 60\n";
    let mut log =
        String::from("time_s,latitude_deg,longitude_deg,height_m,velocity_east_m_s,velocity_north_m_s,");
    log += "velocity_up_m_s,roll_deg,pitch_deg,heading_deg\n";
    for second in 0..=120 {
        writeln!(log, "{},39.9,116.4,50,0,0,0,0,0,0", 1000 + second).unwrap();
    }
    std::fs::write(folder.join("log.csv"), log).unwrap();
    let height = || column(&read(folder.join("sins_out/scene.csv")), "navigation_height_m");
    let undisturbed = fly(&folder, flight);
    let undisturbed_height = height();
    let failed = fly(&folder, &format!("{flight}{gyro}"));
    assert_eq!(seconds(&undisturbed, &failed, "angle_increment_x_rad"), [30, 31, 32]);

    // The first record is at the start, the 61st at 60 s. The loop raises the height, following the altimeter.
    assert!(fly(&folder, &format!("{flight}{altimeter}")) == undisturbed);
    let apart: Vec<f64> =
        height().iter().zip(&undisturbed_height).map(|(failed, undisturbed)| failed - undisturbed).collect();
    assert!(apart.len() == 121 && apart[..=60].iter().all(|&apart| apart == 0.0), "{apart:?}");
    assert!(apart[61..].iter().all(|&apart| apart > 0.0), "{apart:?}");
}
