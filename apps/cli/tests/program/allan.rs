//! `sins allan` from the command line to the files.

use std::path::Path;

use sins_allan::Point;

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
    let joined = done(&folder, &["allan", "gap.csv", "-o", "joined.svg"]);
    let words = "gap.csv: 500 samples at 100.0 Hz, 5 s; 1 gap, 0 s in all: 2 pieces are joined";
    assert!(joined.starts_with(words), "{joined}");
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
        let is_of_file = !arguments.contains(&"out.png");
        assert_eq!(is_of_file, errors.contains("begins:\n   1 | # a turntable\n   2 | time_s,"), "{errors}");
    }
    assert!(!folder.join("out.svg").exists(), "nothing is drawn of a bad log");
}

/// Linear congruential numbers from 0 to 1. The figures of `docs/effects.md` and the bandwidth that is found here depend on them.
fn uniform(state: &mut u64) -> f64 {
    *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    (*state >> 11) as f64 / (1_u64 << 53) as f64
}

/// White noise of N [°/√h] at 100 Hz, of sums of uniform numbers, and a motion that is added.
fn noise(rows: usize, n: f64, motion: impl Fn(f64) -> f64) -> Vec<f64> {
    let mut state = 1;
    let mut normal = || (0..12).map(|_| uniform(&mut state) - 0.5).sum::<f64>();
    let sigma = n / 60.0 * 10.0;
    (0..rows).map(|k| sigma * normal() + motion(k as f64 * 0.01)).collect()
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
        ("mean", Some("below 0.060 s are left out of the fit: each value is the mean of 4 of the sensor")),
        ("twice", Some("each value stands 2 times: a sensor of 50.00 Hz in rows of 100.0 Hz")),
        ("low_pass", Some("the values are those behind a low-pass of first order at about 5.6 Hz")),
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

/// A record with one value that stands out, or that stands still in half of it, gets no interval: none would hold.
#[test]
fn a_faulty_record_gets_no_interval() {
    let folder = folder("faulty");
    let mut spike = noise(60_000, 0.66, |_| 0.0);
    spike[30_000] = 50.0;
    save(&folder.join("spike.csv"), spike.iter().copied());
    let stuck = noise(60_000, 0.66, |_| 0.0)
        .into_iter()
        .enumerate()
        .map(|(k, value)| if k < 30_000 { value } else { 0.0 });
    save(&folder.join("stuck.csv"), stuck);
    for (name, words) in [("spike", "single values stand out"), ("stuck", "one value stands for 300.0 s")] {
        let table = done(&folder, &["allan", &format!("{name}.csv"), "--rate", "100", "--still"]);
        assert!(table.contains("No interval would hold: ") && table.contains(words), "{table}");
        assert!(
            table.lines().any(|line| line.starts_with("  N ") && line.ends_with("without an interval")),
            "{table}"
        );
        let errors = run(
            &folder,
            &["allan", &format!("{name}.csv"), "--rate", "100", "--still", "--write", "s.toml", "--force"],
        )
        .2;
        assert!(errors.contains("nothing to write") && !folder.join("s.toml").exists(), "{errors}");
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

/// White noise of N = 0.66 °/√h with stamps as they come: jitter of a bus, lost rows, gaps, dates.
#[test]
fn stamps_scatter_and_rows_are_lost() {
    let folder = folder("stamps");
    let white = noise(60_000, 0.66, |_| 0.0);
    let table = |name: &str, header: &str, stamp: &dyn Fn(usize) -> Option<String>| {
        let rows =
            white.iter().enumerate().filter_map(|(k, value)| Some(format!("{},{value:.9e}\n", stamp(k)?)));
        std::fs::write(folder.join(name), format!("{header}\n{}", rows.collect::<String>())).unwrap();
    };
    table("batches.csv", "time_s,gyro_x_deg_s", &|k| {
        Some(format!("{:.4}", (k / 4 * 4) as f64 / 100.0 + (k % 4) as f64 * 2e-4))
    });
    table("gaps.csv", "t,GyrX", &|k| {
        (!(20_000..30_000).contains(&k) && k % 7000 != 6000).then(|| format!("{}", 10_000 * k))
    });
    table("dates.csv", "when,GyrX", &|k| {
        let (minute, second) = (k / 6000 % 60, k % 6000);
        Some(format!("2024-05-01T23:{:02}:{:02}.{:02}Z", 50 + minute, second / 100, second % 100))
    });
    table("lossy.csv", "time_s,gyro_x_deg_s", &|k| (k % 20 != 0).then(|| format!("{:.2}", k as f64 / 100.0)));
    for (name, arguments, said) in [
        ("batches.csv", &[][..], "stamps scatter by up to 2.9"),
        ("gaps.csv", &["--columns", "t=us,GyrX=°/s"], "7 gaps, 100.1 s in all: 8 pieces are joined"),
        ("dates.csv", &["--columns", "when=iso,GyrX=deg/s"], "60000 samples at 100.0 Hz, 10 min; 95 %"),
        ("lossy.csv", &["--rate", "100"], "57000 samples at 100.0 Hz (--rate"),
    ] {
        let table = done(&folder, &[&["allan", name, "--force"], arguments].concat());
        let [n, low, high] = random_walk(&table);
        assert!(
            table.contains(said) && low < 0.66 && 0.66 < high && high < 1.05 * low && low < n,
            "{name}: {table}"
        );
    }
    let errors = rejected(&folder, &["allan", "lossy.csv"]);
    assert!(
        errors.contains("2999 gaps, and the longest piece between them has 19 rows")
            && errors.contains("--rate 100.0"),
        "{errors}"
    );
    let errors = rejected(&folder, &["allan", "dates.csv"]);
    assert!(
        errors.contains("--columns: when, GyrX") && errors.contains("   2 | 2024-05-01T23:50:00.00Z,"),
        "{errors}"
    );
    // Rows with the second in which they came.
    table("seconds.csv", "time_s,gyro_x_deg_s", &|k| Some(format!("{}", k / 100)));
    let [n, low, high] = random_walk(&done(&folder, &["allan", "seconds.csv"]));
    assert!(low < 0.66 && 0.66 < high && high < 1.05 * low, "{n} {low} {high}");
    for columns in ["GyrX=deg_s,GyrX=deg_s", "when=iso,when=deg_s"] {
        let errors = rejected(&folder, &["allan", "dates.csv", "--columns", columns]);
        assert!(errors.contains("stands there twice"), "{errors}");
    }
    std::fs::write(folder.join("twice.csv"), "time_s,w_deg_s,w_deg_s\n".to_owned() + &"0,1,2\n".repeat(60))
        .unwrap();
    let errors = rejected(&folder, &["allan", "twice.csv"]);
    assert!(errors.contains("two columns are named \"w_deg_s\""), "{errors}");
    let errors = rejected(&folder, &["allan", "dates.csv", "--columns", "GyrX=deg_s"]);
    assert!(errors.contains("--columns \"NAME=s\""), "{errors}");
}

/// What the records of 24 sensors show is written as scenes; their flights give records with the same curves.
#[test]
fn what_was_found_flies() {
    let folder = folder("closure");
    let mut state = 7;
    let mut from = |low: f64, high: f64| low * (high / low).powf(uniform(&mut state));
    let (mut points, mut apart) = (0, 0);
    let seeds = &["1", "2", "3", "4"][..if cfg!(feature = "long-tests") { 4 } else { 2 }];
    for seed in seeds {
        let mut axes =
            |low: f64, high: f64| format!("[{}, {}, {}]", from(low, high), from(low, high), from(low, high));
        let scene = format!(
            "[flight]\nbuiltin = \"rest\"\nhours = 2\nrate_hz = 10\n\
            [gyro]\nrandom_walk_deg_sqrt_h = {}\nflicker_deg_h = {}\nrate_random_walk_deg_h_sqrt_h = {}\n\
            [accelerometer]\nrandom_walk_micro_g_sqrt_hz = {}\nflicker_micro_g = {}\nramp_micro_g_h = {}\n",
            axes(0.01, 1.0),
            axes(0.1, 100.0),
            axes(0.1, 100.0),
            axes(10.0, 1000.0),
            axes(1.0, 300.0),
            axes(1.0, 1000.0),
        );
        std::fs::write(folder.join("set.toml"), scene).unwrap();
        let run = |scene: &str, seed: &str, points: &str| {
            let seed = format!("options.seed={seed}");
            done(&folder, &["fly", scene, "--set", &seed, "--imu", "imu.csv", "--quiet", "--force"]);
            done(
                &folder,
                &["allan", "sins_out/imu.csv", "--csv", points, "--write", "found.toml", "--force"],
            );
            read(folder.join(points))
        };
        let [first, second] = [("set.toml", *seed, "first.csv"), ("found.toml", "99", "second.csv")]
            .map(|(scene, seed, points)| run(scene, seed, points));
        assert_eq!(first.lines().count(), second.lines().count());
        for (one, other) in first.lines().zip(second.lines()).skip(1) {
            let band = |line: &str| {
                let fields: Vec<f64> = line.split(',').skip(1).map(|field| field.parse().unwrap()).collect();
                let point = Point { tau_s: fields[0], variance: fields[1] * fields[1], degrees: fields[4] };
                point.interval(0.999)
            };
            let (first, second) = (band(one), band(other));
            points += 1;
            // The coefficients explain a deviation within its interval or within 5 %.
            let is_apart = |low: f64, high: f64| low > high * 1.05f64.powi(2);
            if is_apart(first.low, second.high) || is_apart(second.low, first.high) {
                apart += 1;
                println!("seed {seed}:\n{one}\n{other}");
            }
        }
    }
    println!("figure: `allan`, flown and measured again: {apart} of {points} deviations lie apart");
    assert!(points > 6 * 30 * seeds.len() && apart == 0, "{apart} of {points}");
}

/// An axis without noise stays an axis.
#[test]
fn axes_keep_their_places() {
    let folder = folder("axes");
    let white = noise(6000, 0.66, |_| 0.0);
    let rows: String = white.iter().map(|value| format!("0,{value:.9e},{:.9e}\n", value * 2.0)).collect();
    std::fs::write(folder.join("dead.csv"), format!("gyro_x_deg_s,gyro_y_deg_s,gyro_z_deg_s\n{rows}"))
        .unwrap();
    let (code, _, errors) = run(&folder, &["allan", "dead.csv", "--rate", "100", "--write", "dead.toml"]);
    assert!(code == 0 && errors.contains("left out: column \"gyro_x_deg_s\""), "{errors}");
    let scene = read(folder.join("dead.toml"));
    assert!(
        scene.contains("random_walk_deg_sqrt_h = [0, 0.6")
            && scene.contains("# x: left out: no noise\n# y: gyro_y_deg_s"),
        "{scene}"
    );
    // What was edited is not lost.
    let (code, _, errors) = run(&folder, &["allan", "dead.csv", "--rate", "100", "--write", "dead.toml"]);
    assert!(code == 2 && errors.contains("--force"), "{errors}");
}

/// A column of times is no signal, whatever unit it is given; and a table has a limit of columns, before any work on them.
#[test]
fn times_and_too_many_columns_are_rejected() {
    let folder = folder("columns");
    save(&folder.join("white.csv"), noise(100, 0.66, |_| 0.0).into_iter());
    let rows: String =
        (0..100).map(|k| format!("{},{},{}\n", f64::from(k) / 100.0, k % 7, 10_000 * k)).collect();
    std::fs::write(folder.join("imu.csv"), format!("time_s,gyro_x_deg_s,time_us\n{rows}")).unwrap();
    for columns in ["time_s:rad_s", "time_s=deg", "gyro_x_deg_s,time_s=m_s2", "time_us=rad_s,gyro_x_deg_s"] {
        for more in [&[][..], &["--rate", "100"], &["--still"]] {
            let errors = rejected(&folder, &[&["allan", "imu.csv", "--columns", columns], more].concat());
            assert!(
                errors.contains("has the times of the rows, which are no output of a sensor"),
                "{errors}"
            );
        }
    }
    done(&folder, &["allan", "imu.csv", "--columns", "time_s=s", "--still"]);
    let names: Vec<String> = (0..1_000_000).map(|place| format!("w{place}_deg_s")).collect();
    std::fs::write(folder.join("wide.csv"), names.join(",") + "\n").unwrap();
    let errors = rejected(&folder, &["allan", "wide.csv", "--rate", "100"]);
    assert!(errors.contains("wide.csv:1: 1000000 columns: a table has at most 1000"), "{errors}");
}
