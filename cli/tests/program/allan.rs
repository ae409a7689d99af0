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
    assert!(errors.contains("--rate"), "{errors}");
    let said = done(&folder, &["allan", "gap.csv", "-o", "counted.svg", "--rate", "100"]);
    assert!(
        said.starts_with("gap.csv: 500 samples at 100.0 Hz (--rate; the time stamps are not used)"),
        "{said}"
    );
    log(&path, 500, 321, 0);
    for (arguments, expected) in [
        (&["-o", "out.svg", "--columns", "gyro_z_deg_s,mode:deg_s"][..], ":3: column 3 (mode)"),
        (&["-o", "out.svg", "--columns", "gyro_q_deg_s"], "\"gyro_q_deg_s\""),
        (&["-o", "out.png"], "out.png"),
    ] {
        let errors = rejected(&folder, &[&["allan", "gap.csv"], arguments].concat());
        assert!(errors.contains(expected), "{arguments:?}: {errors}");
    }
    assert!(!folder.join("out.svg").exists(), "nothing is drawn of a bad log");
}

/// White noise of N [°/√h] at 100 Hz, of sums of uniform numbers, and a motion that is added.
fn noise(rows: usize, n: f64, motion: impl Fn(f64) -> f64) -> Vec<f64> {
    let mut state = 1_u64;
    let mut uniform = move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 53) as f64 - 0.5
    };
    let sigma = n / 60.0 * 10.0;
    (0..rows).map(|k| sigma * (0..12).map(|_| uniform()).sum::<f64>() + motion(k as f64 * 0.01)).collect()
}

fn save(path: &Path, values: impl Iterator<Item = f64>) {
    let rows: Vec<String> = values.map(|value| format!("{value:.9e}\n")).collect();
    std::fs::write(path, format!("gyro_x_deg_s\n{}", rows.concat())).unwrap();
}

/// N with its interval, as the table has them.
fn random_walk(table: &str) -> [f64; 3] {
    let line = table.lines().find(|line| line.starts_with("  N ")).unwrap();
    let numbers = line.split(|mark: char| !(mark.is_ascii_digit() || mark == '.'));
    let numbers: Vec<f64> = numbers.filter_map(|word| word.parse().ok()).collect();
    [numbers[0], numbers[1], numbers[2]]
}

/// Records as sensors give them: neighbours depend on each other, and N stays what it is.
#[test]
fn filtered_averaged_and_repeated_records_have_their_noise() {
    let folder = folder("dependent");
    let white = noise(60_000, 0.66, |_| 0.0);
    let mean = |width: usize| white.windows(width).map(move |four| four.iter().sum::<f64>() / width as f64);
    save(&folder.join("white.csv"), white.iter().copied());
    save(&folder.join("mean.csv"), mean(4));
    save(&folder.join("twice.csv"), white.iter().flat_map(|value| [value / 2f64.sqrt(); 2]));
    let mut state = 0.0;
    let low_pass = white.iter().map(|value| {
        state += 0.3 * (value - state);
        state
    });
    save(&folder.join("low_pass.csv"), low_pass.skip(100));
    for (name, remark) in [
        ("white", None),
        ("mean", Some("neighbouring values depend on each other")),
        ("twice", Some("50 % of the values are those of the row before: the sensor is slower than the log")),
        ("low_pass", Some("neighbouring values depend on each other")),
    ] {
        let table = done(
            &folder,
            &["allan", &format!("{name}.csv"), "--rate", "100", "--csv", "points.csv", "--force"],
        );
        let [n, low, high] = random_walk(&table);
        assert!(low < n && n < high && low < 0.66 && 0.66 < high && high < 1.15 * low, "{name}: {table}");
        assert_eq!(remark.is_some(), table.contains("are left out of the fit"), "{name}: {table}");
        assert!(remark.is_none_or(|remark| table.contains(remark)), "{name}: {table}");
        let fit = read(folder.join("points_fit.csv"));
        let quantization = fit.lines().nth(1).unwrap();
        assert_eq!(
            remark.is_some(),
            quantization.contains(",0.000000000e0,0.000000000e0,,rad"),
            "{quantization}"
        );
    }
}

/// A sensor is not in motion because its noise is large; one in motion is rejected, unless the user knows better.
#[test]
fn motion_is_not_noise() {
    let folder = folder("motion");
    save(&folder.join("noisy.csv"), noise(60_000, 27.0, |_| 0.0).into_iter());
    save(&folder.join("turned.csv"), noise(60_000, 0.66, |t| if t > 300.0 { 5.0 } else { 0.0 }).into_iter());
    save(&folder.join("slow.csv"), noise(60_000, 0.66, |t| 2.0 * (t / 60.0).sin()).into_iter());
    let [n, low, high] = random_walk(&done(&folder, &["allan", "noisy.csv", "--rate", "100"]));
    assert!(low < 27.0 && 27.0 < high && (n / 27.0 - 1.0).abs() < 0.05, "{n} {low} {high}");
    for name in ["turned.csv", "slow.csv"] {
        let errors = rejected(&folder, &["allan", name, "--rate", "100"]);
        assert!(errors.contains("in motion") && errors.contains("--still"), "{errors}");
        let table = done(&folder, &["allan", name, "--rate", "100", "--still"]);
        assert!(table.starts_with(name), "{table}");
    }
}
