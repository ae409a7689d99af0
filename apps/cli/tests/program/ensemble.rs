//! `sins ensemble`: the files are the same for any number of threads and after any interruption; statistics are compared with the
//! runs.

use std::path::Path;

use crate::support::{done, folder, names, numbers, project_file, read, rejected, result, run, sins};

/// Three minutes with sensors of navigation grade and both error data. With the 150 runs of `order`, these are three blocks of 64
/// runs, of which the last is not full.
const SCENE: [&str; 9] = [
    "simulation2",
    "--preset",
    "navigation",
    "--set",
    "flight.hours=0.05",
    "--set",
    "flight.rate_hz=10",
    "--set",
    "options.error_model=rk4",
];

const FILES: [&str; 3] =
    ["simulation2_ensemble.csv", "simulation2_ensemble.html", "simulation2_ensemble_runs.csv"];

fn order<'a>(more: &[&'a str]) -> Vec<&'a str> {
    [&["ensemble"], &SCENE[..], &["--runs", "150"], more].concat()
}

/// The files, the page without its foot, which has date and command line.
fn bytes(out: &Path) -> [String; 3] {
    FILES.map(|name| {
        let text = read(out.join(name));
        text.split_once("<footer>").map_or(text.clone(), |(page, _)| page.to_owned())
    })
}

/// Rows of a file by the names of its columns, without empty fields.
fn table(path: &Path) -> Vec<std::collections::HashMap<String, f64>> {
    let mut reader = csv::Reader::from_path(path).unwrap();
    let names: Vec<String> = reader.headers().unwrap().iter().map(str::to_owned).collect();
    let row = |record: csv::StringRecord| {
        let fields = names.iter().cloned().zip(record.iter().map(str::to_owned).collect::<Vec<_>>());
        fields
            .filter(|(_, text)| !text.is_empty())
            .map(|(name, text)| (name, text.parse().unwrap()))
            .collect()
    };
    reader.records().map(|record| row(record.unwrap())).collect()
}

#[test]
fn any_number_of_threads_writes_the_same_files() {
    let folder = folder("threads");
    for threads in ["1", "2", "3"] {
        done(&folder, &order(&["-q", "--threads", threads, "--out", threads]));
        assert_eq!(names(&folder.join(threads)), FILES, "{threads}");
        assert!(bytes(&folder.join(threads)) == bytes(&folder.join("1")), "{threads}");
    }
    let runs = table(&folder.join("1").join(FILES[2])).len();
    println!("figure: {} files of {runs} runs to the byte", FILES.len());
    // Other runs have other errors.
    done(&folder, &order(&["-q", "--first-run", "1", "--out", "first"]));
    assert!(bytes(&folder.join("first"))[0] != bytes(&folder.join("1"))[0]);
}

/// An order that runs long enough to be interrupted.
#[cfg(unix)]
fn long<'a>(more: &[&'a str]) -> Vec<&'a str> {
    let flight = ["--set", "flight.hours=0.1", "--set", "flight.rate_hz=100", "--meets", "navigation_grade"];
    [&order(&flight)[..], more].concat()
}

/// Sends `signal` after the checkpoint exists, which comes with the first block. Returns the exit code and the messages.
#[cfg(unix)]
fn interrupted(folder: &Path, out: &str, signal: &str, more: &[&str]) -> (i32, String) {
    use std::process::Stdio;
    use std::time::{Duration, Instant};

    let order = long(&[&["--threads", "1", "--out", out], more].concat());
    let child = sins(folder, &order).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    let checkpoint = folder.join(out).join("simulation2_ensemble.checkpoint");
    let deadline = Instant::now() + Duration::from_secs(120);
    while !checkpoint.exists() {
        assert!(Instant::now() < deadline, "no checkpoint came");
        std::thread::sleep(Duration::from_millis(10));
    }
    let kill = format!("kill -{signal} {}", child.id());
    assert!(std::process::Command::new("sh").args(["-c", &kill]).status().unwrap().success());
    let (code, said, errors) = result(&child.wait_with_output().unwrap());
    assert_eq!(said, "");
    (code, errors)
}

#[test]
#[cfg(unix)]
fn an_interrupted_ensemble_goes_on_to_the_same_files() {
    let folder = folder("interrupted");
    let whole = long(&["-q", "--out", "whole"]);
    done(&folder, &whole);
    let (code, errors) = interrupted(&folder, "asked", "INT", &[]);
    assert_eq!(code, 130, "{errors}");
    assert!(errors.contains(" of 150 runs are in asked/simulation2_ensemble.checkpoint"), "{errors}");
    assert_eq!(names(&folder.join("asked")), ["simulation2_ensemble.checkpoint"]);
    assert_eq!(interrupted(&folder, "killed", "KILL", &[]).0, -1);
    for out in ["asked", "killed"] {
        let (code, _, errors) = run(&folder, &long(&["--threads", "2", "--out", out]));
        assert!(code == 0 && errors.contains(" of 150 runs are flown"), "{errors}");
        assert!(bytes(&folder.join(out)) == bytes(&folder.join("whole")), "{out}");
        let verdicts = |out: &str| read(folder.join(out).join("simulation2_ensemble_meets.csv"));
        assert_eq!(verdicts(out), verdicts("whole"));
        assert!(!folder.join(out).join("simulation2_ensemble.checkpoint").exists());
    }
    // Gravity is beyond the range of the accelerometers in all runs, also in those before the end, and no run meets the requirement.
    let range = ["--set", "accelerometer.range_g=0.999"];
    assert_eq!(interrupted(&folder, "range", "KILL", &range).0, -1);
    let (code, said, errors) = run(&folder, &long(&[&range[..], &["--out", "range"]].concat()));
    assert!(code == 3 && errors.contains(" of 150 runs are flown"), "{errors}");
    assert!(said.contains("Accelerometers were beyond their range in 150 of 150 runs"), "{said}");
}

#[test]
#[cfg(unix)]
fn a_checkpoint_that_is_damaged_or_foreign_is_rejected() {
    let folder = folder("foreign");
    assert_eq!(interrupted(&folder, "out", "INT", &[]).0, 130);
    let path = folder.join("out/simulation2_ensemble.checkpoint");
    let good = std::fs::read(&path).unwrap();
    let again = long(&["--out", "out"]);
    for (more, words) in [
        (&["--set", "options.seed=7"][..], "is that of another command: it has \"scene "),
        (&["--set", "gyro.bias_sigma_deg_h=0.02"], "is that of another command: it has \"scene "),
        (&["--first-run", "3"], "\"first run 0\" where this command has \"first run 3\""),
        (&["--every", "9"], "\"seconds between rows "),
        (&["--meets", "rnp10"], "it has \"requirements "),
    ] {
        let errors = rejected(&folder, &[&again[..], more].concat());
        assert!(errors.contains(words), "{more:?}: {errors}");
        assert!(std::fs::read(&path).unwrap() == good, "{more:?}");
    }
    // Damage in every part of the file: its text, the blocks, statistics, ends, the checksum. The file is also cut there.
    for at in [30, 200, 300, 5000, good.len() / 2, good.len() - 9, good.len() - 1] {
        let mut damaged = good.clone();
        damaged[at] ^= 0x10;
        std::fs::write(&path, &damaged).unwrap();
        assert!(rejected(&folder, &again).contains("is damaged"), "{at}");
        std::fs::write(&path, &good[..at]).unwrap();
        assert!(rejected(&folder, &again).contains("is damaged"), "cut at {at}");
        assert!(std::fs::read(&path).unwrap() == good[..at]);
    }
    std::fs::write(&path, "somebody's own").unwrap();
    assert!(rejected(&folder, &again).contains("--force"));
    assert_eq!(read(&path), "somebody's own");
}

#[test]
fn no_output_is_an_input() {
    let folder = folder("inputs");
    let header = "time_s,latitude_rad,longitude_rad,height_m,roll_rad,pitch_rad,heading_rad";
    let rows: String = (0..=10).map(|t| format!("{t},0.7,2.0,50,0,0,1\n")).collect();
    for ending in [".csv", "_runs.csv", ".html", ".checkpoint"] {
        let name = format!("a_ensemble{ending}");
        std::fs::write(folder.join(&name), format!("{header}\n{rows}")).unwrap();
        let errors = rejected(&folder, &["ensemble", "--log", &name, "--name", "a", "--out", ".", "--force"]);
        assert!(errors.contains("is the input"), "{errors}");
        assert_eq!(names(&folder), [name.as_str()]);
        std::fs::remove_file(folder.join(&name)).unwrap();
    }
    for (more, words) in [
        (&["--runs", "0"][..], "'0' for '--runs <RUNS>': expected a whole number from 1 to 10000000"),
        (&["--runs", "1e3"], "'1e3' for '--runs <RUNS>': expected a whole number from 1 to 10000000"),
        (&["--threads", "0"], "expected a whole number from 1 to 4096"),
        (&["--first-run", "-1"], "expected a whole number from 0 to 18446744073709551615"),
        (&["--every", "1e-9"], "--every"),
        (&["--every", "nan"], "--every"),
        (&["--name", "a/b"], "without a folder"),
        (&["--first-run", "18446744073709551615"], "--first-run"),
    ] {
        let errors = rejected(&folder, &[&["ensemble", "rest", "--preset", "navigation"], more].concat());
        assert!(errors.contains(words), "{errors}");
    }
}

/// Mean, sigma, root mean square and radii of the last row are compared with the errors of the runs, and these with runs flown
/// alone.
#[test]
fn statistics_are_those_of_the_runs() {
    let folder = folder("statistics");
    done(&folder, &order(&["-q", "--first-run", "40"]));
    let out = folder.join("sins_out");
    let runs = table(&out.join("simulation2_ensemble_runs.csv"));
    let rows = table(&out.join("simulation2_ensemble.csv"));
    let end = rows.iter().rfind(|row| row["error_data"] == 2.0).unwrap();
    let count = runs.len() as f64;
    assert_eq!((end["runs"], end["diverged"], runs[0]["run"]), (count, 0.0, 40.0));
    // The statistics count in units of 2^-`resolution`, so a sum is right to half a unit for each run.
    let mut share = 0.0_f64;
    for (quantity, unit, resolution) in
        [("position", "m", 22), ("velocity", "m_s", 29), ("misalignment", "rad", 45)]
    {
        let step = 0.5f64.powi(resolution);
        for axis in ["east", "north", "up"] {
            let name = format!("{quantity}_{axis}_{unit}");
            let values: Vec<f64> = runs.iter().map(|run| run[&name]).collect();
            let mean = values.iter().sum::<f64>() / count;
            let square = values.iter().map(|value| value * value).sum::<f64>() / count;
            let sigma =
                (values.iter().map(|value| (value - mean).powi(2)).sum::<f64>() / (count - 1.0)).sqrt();
            for (what, expected) in [("mean", mean), ("sigma", sigma), ("rms", square.sqrt())] {
                let found = end[&format!("{what}_{name}")];
                // The file has ten digits.
                let (error, limit) = ((found - expected).abs(), step + 1e-9 * expected.abs());
                assert!(error <= limit, "{what}_{name}: {found} {expected}");
                share = share.max(error / limit);
            }
        }
    }
    let mut radii: Vec<f64> = runs.iter().map(|run| run["radial_m"]).collect();
    radii.sort_by(f64::total_cmp);
    assert!((end["largest_m"] - radii[radii.len() - 1]).abs() < 1e-6);
    let (half_class, mut of_radius) = (0.005, 0.0_f64);
    for (name, share) in [("cep50_m", 0.5), ("r95_m", 0.95)] {
        let exact = radii[(share * count).ceil() as usize - 1];
        let error = (end[name] / exact - 1.0).abs();
        assert!(error <= half_class + 1e-9, "{name}: {} {exact}", end[name]);
        of_radius = of_radius.max(error);
    }
    // A run flown alone.
    let flown = [40, 40 + runs.len() as u64 - 1];
    for run in flown {
        let alone = format!("options.run={run}");
        let more = ["--set", &alone, "--set", "output.every_s=1", "-q", "--name", "alone"];
        done(&folder, &[&["fly"], &SCENE[..], &more].concat());
        let (columns, records) = numbers(&out.join("alone.csv"));
        let last = &records[records.len() - 1];
        let of_ensemble = &runs[(run - 40) as usize];
        for (column, value) in columns.iter().zip(last) {
            if let Some(name) = column.strip_prefix("navigation_error_")
                && let Some(expected) = of_ensemble.get(name)
            {
                assert_eq!(value.to_bits(), expected.to_bits(), "run {run}: {name}");
            }
        }
    }
    let page = read(out.join("simulation2_ensemble.html"));
    for outside in ["://", "<script src", "NaN", "inf,", "\"inf"] {
        assert!(!page.contains(outside), "{outside}");
    }
    for drawn in ["class=\"band\"", "class=\"outer-band\"", "class=\"run\"", "class=\"count\"", "CEP50"] {
        assert!(page.contains(drawn), "{drawn}");
    }
    let (percent, limit_percent) = (100.0 * of_radius, 100.0 * half_class);
    println!(
        "figure: statistics to {share:.2} of resolution and last digit (limit 1), radii to {percent:.2} % \
        (limit {limit_percent} %); {} runs to the bit",
        flown.len()
    );
}

/// Accelerometers with biases of 1 g (1 sigma) and a free vertical channel: within six minutes some runs leave the range of
/// heights, others do not.
#[test]
fn diverged_runs_are_reported_by_number_and_left_out() {
    let folder = folder("diverged");
    let settings = [
        "flight.hours=0.1",
        "flight.rate_hz=1",
        "options.vertical=free",
        "accelerometer.bias_sigma_micro_g=1000000",
    ];
    let set = settings.iter().flat_map(|setting| ["--set", setting]);
    let order: Vec<&str> = ["ensemble", "rest", "--runs", "70"].into_iter().chain(set).collect();
    let said = done(&folder, &order);
    let out = folder.join("sins_out");
    let runs = table(&out.join("rest_ensemble_runs.csv"));
    let diverged: Vec<u64> =
        runs.iter().filter(|run| run["diverged"] == 1.0).map(|run| run["run"] as u64).collect();
    assert!(diverged.len() > 2 && diverged.len() < 68, "{diverged:?}");
    assert!(runs.iter().all(|run| (run["diverged"] == 1.0) != run.contains_key("radial_m")));
    let reported: Vec<String> = diverged.iter().take(20).map(u64::to_string).collect();
    assert!(said.contains(&format!("{} diverged: {}", diverged.len(), reported.join(", "))), "{said}");
    let rows = table(&out.join("rest_ensemble.csv"));
    let end = &rows[rows.len() - 1];
    assert_eq!((end["runs"], end["diverged"]), (70.0, diverged.len() as f64));
    assert_eq!(rows[0]["diverged"], 0.0);
    assert!(read(out.join("rest_ensemble.html")).contains("left out of the statistics"));
}

/// The last run has the largest number of a run.
#[test]
fn the_last_run_of_all_can_be_flown() {
    let folder = folder("last_run");
    let last = u64::MAX.to_string();
    let order = |first: &str, runs: &str| {
        let scene = ["ensemble", "rest", "-q", "--set", "flight.hours=0.001", "--out", "out"];
        run(&folder, &[&scene[..], &["--first-run", first, "--runs", runs]].concat())
    };
    let (code, _, errors) = order(&last, "1");
    assert_eq!(code, 0, "{errors}");
    let runs = read(folder.join("out/rest_ensemble_runs.csv"));
    assert!(runs.contains(&format!("\n{last},")), "{runs}");
    let (code, _, errors) = order(&last, "2");
    assert!(code != 0 && errors.contains("the last run below 2^64"), "{errors}");
}

/// Each verdict counts the runs of the file of runs; the exit code is that of the worst verdict.
#[test]
fn requirements_are_met_or_not_or_undecided() {
    let folder = folder("meets");
    let requirement = |quantity: &str, percent: u32, limit: &str| {
        format!("[[requirement]]\nquantity = \"{quantity}\"\npercent = {percent}\n{limit}\n")
    };
    let write = |name: &str, text: &str| std::fs::write(folder.join(name), text).unwrap();
    write("met.toml", &requirement("position_horizontal", 50, "limit_km = 9\ntime_h = 0.02"));
    write("undecided.toml", &requirement("position_cross", 99, "limit_km = 9"));
    let own =
        requirement("position_along", 60, "limit_m = 7") + &requirement("position_cross", 60, "limit_m = 7");
    let own = own + &requirement("position_horizontal", 60, "limit_nmi_h = 0.06");
    write("not.toml", &(own + &requirement("velocity_horizontal", 99, "limit_m_s = 1e-3")));
    for (meets, code, words) in [
        ("met.toml", 0, ""),
        (
            "undecided.toml",
            4,
            "150 of 150 runs, 100.0 % (97.5 to 100.0 %): undecided: 231 more runs would decide",
        ),
        ("not.toml", 3, "velocity_horizontal: 99 % of the flights within 1.000 mm/s after 3 min: "),
    ] {
        let (found, said, errors) =
            run(&folder, &order(&["-q", "--meets", meets, "--out", &meets[..3], "--threads", "3"]));
        assert_eq!((found, said.as_str()), (code, ""), "{errors}");
        assert!(errors.contains(words), "{errors}");
        assert!(!folder.join(&meets[..3]).join("simulation2_ensemble.checkpoint").exists());
    }
    let at = |name: &str| folder.join("not").join(name);
    let runs = table(&at("simulation2_ensemble_runs.csv"));
    let verdicts = read(at("simulation2_ensemble_meets.csv"));
    let speed = |run: &std::collections::HashMap<String, f64>| {
        run["velocity_east_m_s"].hypot(run["velocity_north_m_s"])
    };
    let limit_m = 0.06 * 1852.0 * 0.05;
    let inside = [
        runs.iter().filter(|run| run["position_along_m"].abs() <= 7.0).count(),
        runs.iter().filter(|run| run["position_cross_m"].abs() <= 7.0).count(),
        runs.iter().filter(|run| run["radial_m"] <= limit_m).count(),
        runs.iter().filter(|run| speed(run) <= 1e-3).count(),
    ];
    for (line, inside) in verdicts.lines().skip(1).zip(inside) {
        assert!(line.contains(&format!(",150,{inside},")), "{line}");
    }
    // The count says something, and along and across are the position, turned.
    assert!((1..150).contains(&inside[0]) && (1..150).contains(&inside[2]), "{inside:?}");
    for run in &runs {
        assert!((run["position_along_m"].hypot(run["position_cross_m"]) - run["radial_m"]).abs() < 1e-9);
    }
    let page = read(at("simulation2_ensemble.html"));
    assert!(
        page.contains("class=\"limit\"") && page.contains("Position error along the track and across it")
    );
    // One thread and other pieces: the same verdicts.
    run(&folder, &order(&["-q", "--meets", "not.toml", "--out", "one", "--threads", "1"]));
    assert_eq!(read(folder.join("one/simulation2_ensemble_meets.csv")), verdicts);
}

#[test]
fn a_requirement_that_does_not_fit_is_rejected() {
    let folder = folder("unfit");
    for (text, words) in [
        ("quantity = \"position_up\"\nlimit_m = 1", "position_up has no error: options.vertical is follow"),
        ("quantity = \"position_east\"\nlimit_m = 1\ntime_h = 3", "due after the flight, which lasts 3 min"),
        (
            "quantity = \"position_east\"\nlimit_m = 1\nflights_over_h = 3",
            "no requirement applies to a flight of 3 min",
        ),
        ("quantity = \"position_east\"\nlimit_m_s = 1", "own.toml:4: limit_m_s: is no unit of position_east"),
    ] {
        std::fs::write(folder.join("own.toml"), format!("[[requirement]]\npercent = 95\n{text}\n")).unwrap();
        let errors = rejected(&folder, &order(&["--meets", "own.toml"]));
        assert!(errors.contains(words), "{errors}");
    }
    assert!(rejected(&folder, &order(&["--meets", "rnp"])).contains("did you mean rnp10?"));
}

/// Of runs that all diverged there are no figures, of one run there is no scatter.
#[test]
fn figures_that_do_not_exist_are_empty() {
    let folder = folder("no_figures");
    let falling = ["--set", "options.vertical=free", "--set", "accelerometer.bias_sigma_micro_g=1000000"];
    let ensemble = |runs: &str, hours: &str, more: &[&str]| {
        let hours = format!("flight.hours={hours}");
        let scene = ["ensemble", "rest", "--runs", runs, "--set", "flight.rate_hz=1", "--set", &hours];
        let ended = run(&folder, &[&scene[..], more].concat());
        let rows = read(folder.join("sins_out/rest_ensemble.csv"));
        (ended, rows.lines().last().unwrap().split(',').map(str::to_owned).collect::<Vec<_>>())
    };
    let ((code, said, errors), row) = ensemble("3", "3", &falling);
    assert_eq!((code, errors.as_str()), (1, "every run diverged before the end\n"));
    assert!(said.contains("\n  none: no run reached the end\n"), "{said}");
    assert!(said.contains("\n  errors of: accelerometer\n"), "{said}");
    assert!(ensemble("1", "0.1", &["--force"]).0.1.contains("\n  errors of: nothing: all runs are equal\n"));
    // Errors that are given are the same in each run.
    for given in ["gyro.bias_deg_h=1", "flight.rate_hz=1"] {
        let errors = rejected(&folder, &["ensemble", "rest", "--runs", "2", "--set", given]);
        assert!(errors.starts_with("rest (built in): nothing is random"), "{errors}");
    }
    assert_eq!(row[..5], ["10800.000000", "2", "3", "3", "0"]);
    assert!(row.len() == 36 && row[5..].iter().all(String::is_empty), "{row:?}");
    let ((code, said, _), row) = ensemble("1", "0.1", &["--preset", "tactical"]);
    assert!(code == 0 && said.contains("position mean") && !said.contains("1 sigma"), "{said}");
    let is_empty = |column: usize| row[column].is_empty();
    assert!(
        (5..36).all(|column| is_empty(column) == ((14..23).contains(&column) || column == 32)),
        "{row:?}"
    );
}

/// The errors of run `run` of a scene at its end, by `sins fly`.
fn end_of_fly(folder: &Path, scene: &[&str], run: u64) -> Vec<u64> {
    let key = format!("options.run={run}");
    done(folder, &[&["fly"], scene, &["-q", "--set", &key, "--name", "one", "--force"]].concat());
    let (columns, rows) = numbers(&folder.join("sins_out/one.csv"));
    let first = columns.iter().position(|name| name == "navigation_error_position_east_m").unwrap();
    rows.last().unwrap()[first..first + 9].iter().map(|value| value.to_bits()).collect()
}

/// The errors of each run at the end of an ensemble, in its file.
fn ends(folder: &Path, name: &str) -> Vec<Vec<u64>> {
    let (_, rows) = numbers(&folder.join(format!("sins_out/{name}_ensemble_runs.csv")));
    rows.iter().map(|row| row[2..11].iter().map(|value| value.to_bits()).collect()).collect()
}

#[test]
fn a_scene_with_a_unit_flies_each_run_with_its_unit() {
    let folder = folder("ensemble_unit");
    let day = crate::support::project_file("c_examples/scenes/day.toml");
    let scene = [day.to_str().unwrap(), "--set", "flight.rate_hz=5"];
    for threads in ["1", "2", "3"] {
        let name = format!("day{threads}");
        let more = ["-q", "--runs", "3", "--every", "300", "--threads", threads, "--name", &name];
        done(&folder, &[&["ensemble"], &scene[..], &more].concat());
    }
    let at = |ending: &str| {
        [1, 2, 3].map(|threads| read(folder.join(format!("sins_out/day{threads}_ensemble{ending}"))))
    };
    for ending in [".csv", "_runs.csv"] {
        let [one, two, three] = at(ending);
        assert!(one == two && one == three, "{ending}");
    }
    let found = ends(&folder, "day1");
    for (run, end) in (0..).zip(&found) {
        assert_eq!(*end, end_of_fly(&folder, &scene, run), "run {run}");
    }
    // The unit aligns until 700 s, navigates until 3960 s, and is off at the end.
    let rows = table(&folder.join("sins_out/day1_ensemble.csv"));
    for row in &rows {
        let navigates = (900.0..=3900.0).contains(&row["time_s"]);
        let expected = if row["error_data"] == 3.0 && !navigates { 0.0 } else { 3.0 };
        assert_eq!(row["runs"], expected, "{row:?}");
        assert_eq!(row.contains_key("cep50_m"), expected > 0.0, "{row:?}");
    }
    assert_eq!(rows.iter().filter(|row| row["error_data"] == 3.0).count(), rows.len() / 2);
    let page = read(folder.join("sins_out/day1_ensemble.html"));
    let words = "The unit shows invalid outputs from 0 s to 10 min in up to 3 of 3 runs, at 67.3 min in up to 3 of 3 runs.";
    assert!(page.contains(words), "{}", page.find("The unit shows").map_or("", |at| &page[at..at + 200]));
}

/// A single run is flown by a simulator, several side by side: the bits are the same, with failures, updates and runs that diverge.
#[test]
fn a_single_run_has_the_bits_of_many() {
    let folder = folder("few_runs");
    let resets = crate::support::project_file("c_examples/scenes/resets.toml");
    let resets = [resets.to_str().unwrap(), "--set", "flight.rate_hz=5", "--set", "options.error_model=rk4"];
    let falling =
        ["rest", "--set", "options.vertical=free", "--set", "accelerometer.bias_sigma_micro_g=20000"];
    let falling = [&falling[..], &["--set", "flight.rate_hz=1", "--set", "flight.hours=3"]].concat();
    for (name, scene) in [("resets", &resets[..]), ("falling", &falling)] {
        let mut apart = Vec::new();
        for (first, runs) in [("0", "5"), ("0", "2"), ("2", "1"), ("3", "2")] {
            let more = ["-q", "--runs", runs, "--first-run", first, "--name", name, "--force"];
            run(&folder, &[&["ensemble"], scene, &more].concat());
            let text = read(folder.join(format!("sins_out/{name}_ensemble_runs.csv")));
            apart.extend(text.lines().skip(1).map(str::to_owned));
        }
        let (together, apart) = apart.split_at(5);
        assert_eq!(together, apart, "{name}");
        assert!(name == "resets" || together.iter().any(|line| line.contains(",1,,")), "{together:?}");
    }
}

#[test]
fn studies_say_what_they_leave_out() {
    let folder = folder("left_out");
    let scene = crate::support::project_file("c_examples/scenes/day.toml");
    let scene = scene.to_str().unwrap();
    let (_, _, errors) = run(&folder, &["recommend", scene, "--position", "100"]);
    assert!(!errors.contains("without"), "{errors}");
    let resets = crate::support::project_file("c_examples/scenes/resets.toml");
    let (_, _, errors) =
        run(&folder, &["recommend", resets.to_str().unwrap(), "--position", "100", "--hours", "0.1"]);
    assert!(
        errors.starts_with("resets: without its updates: ") && errors.contains("too large\n"),
        "{errors}"
    );
    let (_, _, errors) = run(&folder, &["budget", scene, "--hours", "0.05"]);
    assert!(errors.starts_with("day: without its unit: ") && errors.contains("too small\n"), "{errors}");
}

/// Rolls of the fighter are faster than the range of its gyros: all errors of the runs hang on that, and text and page say it, of runs
/// side by side, one by one, and of runs with a unit.
#[test]
fn sensors_beyond_their_range_are_said_of_the_runs() {
    let folder = folder("range");
    let log = project_file("c_examples/flights/fighter_aerobatics.csv");
    let unit = "unit.start=nav";
    for (runs, range, more, is_beyond) in [
        ("21", "125", None, true),
        ("1", "125", None, true),
        ("3", "125", Some(unit), true),
        ("21", "300", None, false),
    ] {
        let set = format!("gyro.range_deg_s={range}");
        let order = [
            "ensemble",
            log.to_str().unwrap(),
            "--runs",
            runs,
            "--set",
            &set,
            "--set",
            "gyro.bias_sigma_deg_h=1",
        ];
        let more = more.map_or(vec![], |unit| vec!["--set", unit]);
        let (code, said, errors) = run(&folder, &[&order[..], &more, &["--name", "f", "--force"]].concat());
        assert_eq!(code, 0, "{errors}");
        let words = format!("Gyros were beyond their range in {runs} of {runs} runs");
        assert_eq!(said.contains(&words), is_beyond, "{said}");
        assert_eq!(
            read(folder.join("sins_out/f_ensemble.html")).contains(&words),
            is_beyond,
            "{runs} {range}"
        );
        assert!(!said.contains("Accelerometers were"), "{said}");
    }
}

/// CEP50 and R95 with their intervals are the first sentence, their picture is the first, and notes on the log are below the pictures.
#[test]
fn the_page_answers_first() {
    let folder = folder("answer");
    let row = |t: usize| format!("{t},48,{},500,0,0,90,75\n", 11.0 + 0.001 * t as f64);
    let log: String = (0..=120).map(row).collect();
    let header = "time_s,latitude_deg,longitude_deg,height_m,roll_deg,pitch_deg,heading_deg,vel_e\n";
    std::fs::write(folder.join("east.csv"), format!("{header}{log}")).unwrap();
    let page_of = |runs: &str| {
        let arguments = ["ensemble", "east.csv", "--preset", "navigation", "--runs", runs, "-q", "--force"];
        let (code, _, errors) = run(&folder, &arguments);
        assert_eq!(code, 0, "{errors}");
        read(folder.join("sins_out/east_ensemble.html"))
    };
    let page = page_of("100");
    let order = [
        "<p class=\"lead\">After 2 min half of the 100 runs are within ",
        " of the truth (CEP50; ",
        " to ",
        "), and 95 % within ",
        " of the truth (R95; ",
        " to ",
        "<a href=\"#notes\">",
        "<figure><h3>Horizontal position error</h3>",
        "<h3>Errors of the position</h3>",
        "id=\"notes\"",
        "is it velocity_east_m_s?",
        "At the end",
    ];
    let mut rest = page.as_str();
    for what in order {
        (_, rest) = rest.split_once(what).unwrap_or_else(|| panic!("{what}: {page}"));
    }
    // Few runs have no upper end of R95, and one has no statistics.
    assert!(page_of("20").contains("the runs are too few for an upper end"));
    assert!(page_of("1").contains(" off in the only run."));
}
