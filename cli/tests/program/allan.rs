//! `sins allan` from the command line to the files.

use std::path::Path;

use crate::support::{done, folder, read, rejected, run};

/// A turn at 10 °/s, measured in pulses of a thousandth of a degree while the turntable shakes. The motion of the shaking is
/// subtracted again. Q is 0.001° / √12. Row `gap` and the rows after it are `late` steps late.
fn log(path: &Path, rows: u32, gap: u32, late: u32) {
    let mut text = "# a turntable\ntime_s,gyro_z_deg_s,mode\n".to_owned();
    let angle = |k: u32| {
        let t = f64::from(k) * 0.01;
        let shaking = 3.0 * (0.7 * t).sin() + 0.012_34 * (61.8 * t).sin();
        ((10.0 * t + shaking) * 1e3).round() / 1e3 - shaking
    };
    for k in 0..rows {
        let stamp = f64::from(k + if k < gap { 0 } else { late }) * 0.01;
        text += &format!("{stamp:.2},{:.9},turn\n", (angle(k + 1) - angle(k)) / 0.01);
    }
    std::fs::write(path, text).unwrap();
}

#[test]
fn a_log_becomes_a_picture_a_page_and_tables() {
    let folder = folder("good");
    log(&folder.join("turn.csv"), 20_000, u32::MAX, 0);
    let table = done(&folder, &["allan", "turn.csv", "-o", "a.svg", "--csv", "p.csv"]);
    assert!(table.starts_with("turn.csv: 20000 samples at 100.0 Hz, 3.3 min"), "{table}");
    let fit = read(folder.join("p_fit.csv"));
    let row: Vec<&str> = fit.lines().nth(1).unwrap().split(',').collect();
    assert_eq!((row[0], row[1], row[5]), ("gyro_z_deg_s", "Q", "rad"));
    let [low, high] = [row[3], row[4]].map(|field| field.parse::<f64>().unwrap());
    let q = 0.001f64.to_radians() / 12f64.sqrt();
    assert!(low < q && q < high && high < 1.1 * low, "{low:e} {q:e} {high:e}");
    let curve = read(folder.join("p.csv"));
    assert!(curve.starts_with("column,averaging_time_s,deviation,low,high,degrees_of_freedom,fit\n"));

    // A column without noise does not hide the other.
    let constant = read(folder.join("turn.csv")).replace(",mode", ",gyro_x_deg_s").replace(",turn", ",0");
    std::fs::write(folder.join("constant.csv"), constant).unwrap();
    let (code, again, errors) = run(&folder, &["allan", "constant.csv", "-o", "c.svg"]);
    let words =
        "left out: column \"gyro_x_deg_s\": increments = 0: expected noise, found this value throughout";
    assert!(code == 0 && errors.contains(words) && again.contains("gyro_z_deg_s"), "{again}{errors}");

    let columns = ["--columns", "gyro_z_deg_s:deg_h", "--rate", "100"];
    done(&folder, &[&["allan", "turn.csv", "-o", "a.html"], &columns[..]].concat());
    for (file, begin) in [("a.svg", "<svg"), ("a.html", "<!DOCTYPE html>")] {
        assert!(read(folder.join(file)).starts_with(begin), "{file}");
    }
}

#[test]
fn bad_logs_and_orders_are_reported() {
    let folder = folder("bad");
    let path = folder.join("gap.csv");
    // The comment is line 1, the header line 2, row k line k + 3.
    log(&path, 500, 321, 1);
    let errors = rejected(&folder, &["allan", "gap.csv", "-o", "out.svg"]);
    assert!(errors.contains("gap.csv:324: column time_s"), "{errors}");
    log(&path, 500, 321, 0);
    for (arguments, expected) in [
        (&["-o", "out.svg", "--columns", "gyro_z_deg_s,mode:deg_s"][..], ":3: column 3 (mode)"),
        (&["-o", "out.svg", "--columns", "gyro_q_deg_s"], "\"gyro_q_deg_s\""),
        (&["-o", "out.svg", "--rate", "200"], ":4: column time_s"),
        (&["-o", "out.png"], "out.png"),
    ] {
        let errors = rejected(&folder, &[&["allan", "gap.csv"], arguments].concat());
        assert!(errors.contains(expected), "{arguments:?}: {errors}");
    }
    assert!(!folder.join("out.svg").exists(), "nothing is drawn of a bad log");
}
