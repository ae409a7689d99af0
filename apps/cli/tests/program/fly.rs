//! `sins fly`, `sins scene`, `sins keys`, `sins recommend`: the first commands of a new user.

use crate::support::{done, folder, log, names, numbers, project_file, read, rejected, run, with_log};

/// The value of a row of a summary.
fn figure(summary: &str, key: &str) -> String {
    let begin = format!("{key},");
    let line =
        summary.lines().find(|line| line.starts_with(&begin)).unwrap_or_else(|| panic!("{key}: {summary}"));
    line.split(',').nth(1).unwrap().to_owned()
}

#[test]
fn a_first_flight_and_its_page() {
    let folder = folder("first");
    let said =
        done(&folder, &["fly", "simulation2", "--set", "flight.hours=0.2", "--set", "gyro.bias_deg_h=0.1"]);
    assert!(said.contains(" 0.1 deg/h,") && said.contains(" 10 micro-g,"), "{said}");
    assert!(said.replace('\\', "/").contains("in sins_out/simulation2.csv"), "{said}");
    let said = done(&folder, &["report", "sins_out/simulation2.csv", "sins_out/simulation2_summary.csv"]);
    assert!(said.replace('\\', "/").starts_with("\nwritten\n  sins_out/report.html "), "{said}");
    let page = read(folder.join("sins_out/report.html"));
    assert!(page.contains("simulation2") && page.contains("Gyro errors"));
    // Page and summary show the same slope.
    let slope: f64 =
        figure(&read(folder.join("sins_out/simulation2_summary.csv")), "slope_nmi_h").parse().unwrap();
    let words =
        page.split("Slope of the straight line: ").nth(1).and_then(|rest| rest.split(' ').next()).unwrap();
    assert!((slope - words.parse::<f64>().unwrap()).abs() <= 6e-4 * slope.abs(), "{slope} {words}");
    // All outputs are below one folder.
    assert_eq!(names(&folder), ["sins_out"]);
}

/// The first line answers, in the words of the page: also without errors, with an alignment, a height that diverges, and short of a rate.
#[test]
fn the_answer_stands_first() {
    let folder = folder("answer");
    let unit = "[flight]\nrate_hz = 2\n[[manoeuvre]]\nkind = \"rest\"\nduration_s = 6600\n[gyro]\npreset = \"navigation\"\n[unit]\n\
        start = \"off\"\n[[panel]]\nkind = \"align\"\nat_s = 10\n[[panel]]\nkind = \"true_position\"\nat_s = 60\n[[panel]]\n\
        kind = \"nav\"\nat_s = 700\n";
    std::fs::write(folder.join("unit.toml"), unit).unwrap();
    std::fs::write(folder.join("late.toml"), unit.replace("at_s = 700", "at_s = 6500")).unwrap();
    let never = unit.rsplit_once("[[panel]]").unwrap().0;
    std::fs::write(folder.join("never.toml"), never).unwrap();
    let mut flights = 0;
    for (name, arguments, answer) in [
        (
            "hour",
            &["rest", "--preset", "navigation", "--set", "flight.hours=1"][..],
            "After 60 min the INS is ",
        ),
        (
            "ideal",
            &["rest", "--preset", "ideal", "--set", "flight.hours=0.1"],
            "In 6 min there is no error beyond rounding: at most ",
        ),
        ("long", &["rest", "--preset", "navigation", "--set", "flight.hours=1.5"], ", R50 "),
        (
            "high",
            &["rest", "--preset", "tactical", "--set", "options.vertical=free", "--set", "flight.hours=0.5"],
            " too ",
        ),
        ("model", &["simulation2", "--set", "flight.hours=0.1"], "; the error equations agree to "),
        ("unit", &["unit.toml"], " since NAV at "),
        ("late", &["late.toml"], ", in NAV since "),
        ("never", &["never.toml"], "In 110 min the unit did not navigate."),
    ] {
        let said = done(&folder, &[&["fly"], arguments, &["--name", name]].concat());
        let first = said.lines().next().unwrap();
        assert!(first.contains(answer), "{name}: {said}");
        assert_eq!(first.contains(", R50 "), ["long", "unit"].contains(&name), "{name}: {first}");
        done(&folder, &["report", &format!("sins_out/{name}.csv"), "--force"]);
        let page = read(folder.join("sins_out/report.html"));
        let (_, lead) = page.split_once("<p class=\"lead\">").unwrap();
        assert_eq!(lead.split("</p>").next().unwrap(), first, "{name}");
        flights += 1;
    }
    println!("figure: `fly` and the page say the same of {flights} flights");
}

/// A flight that diverges does not answer as one that reached its end.
#[test]
fn a_flight_that_was_stopped_says_so_first() {
    let folder = folder("stopped");
    let order =
        ["fly", "rest", "--preset", "consumer", "--set", "options.vertical=free", "--set", "flight.hours=20"];
    let (code, said, _) = run(&folder, &order);
    assert_eq!(code, 1);
    assert!(said.starts_with("The flight was stopped after "), "{said}");
    done(&folder, &["report", "sins_out/rest.csv"]);
    assert!(
        read(folder.join("sins_out/report.html")).contains("<p class=\"lead\">The flight was stopped after ")
    );
    let runs = [
        "ensemble",
        "rest",
        "--preset",
        "consumer",
        "--set",
        "options.vertical=free",
        "--hours",
        "0.12",
        "--runs",
        "40",
    ];
    run(&folder, &runs);
    let page = read(folder.join("sins_out/rest_ensemble.html"));
    let (_, lead) = page.split_once("<p class=\"lead\">").unwrap();
    assert!(lead[..60].contains(" of the 40 runs diverged. After 7.2 min half of "), "{}", &lead[..200]);
}

/// Rolls of the fighter are faster than the range of its gyros: the error hangs on that, and it is said.
#[test]
fn sensors_beyond_their_range_are_said() {
    let folder = folder("range");
    let log = project_file("c_examples/flights/fighter_aerobatics.csv");
    for (range, is_beyond) in [("125", true), ("300", false)] {
        let set = format!("gyro.range_deg_s={range}");
        let said =
            done(&folder, &["fly", log.to_str().unwrap(), "--set", &set, "--name", "fighter", "--force"]);
        assert_eq!(said.contains("\n  beyond range    gyros in "), is_beyond, "{said}");
        let summary = read(folder.join("sins_out/fighter_summary.csv"));
        let row = summary.lines().find(|line| line.starts_with("gyro_saturated_steps,")).unwrap();
        assert_eq!(row.starts_with("gyro_saturated_steps,0,"), !is_beyond, "{row}");
        assert!(summary.contains("\naccel_saturated_steps,0,"), "{summary}");
        let page = done(&folder, &["report", "sins_out/fighter.csv", "--force", "-o", "page.html"]);
        let has = read(folder.join("page.html")).contains("Gyros were beyond their range in ");
        assert_eq!(has, is_beyond, "{page}");
    }
}

/// The slope is computed from 300 s on: one sample gives none, which is reported as none and not as 0. Rates need a Schuler period.
#[test]
fn a_short_flight_has_no_rates() {
    let folder = folder("short");
    for (seconds, has_slope, has_rates) in [
        (100, false, false),
        (300, false, false),
        (302, true, false),
        (5063, true, false),
        (5065, true, true),
    ] {
        let hours = format!("{}", f64::from(seconds) / 3600.0);
        let order = ["fly", "rest", "--preset", "tactical", "--hours", &hours, "--set", "flight.rate_hz=1"];
        let said = done(&folder, &order);
        let summary = read(folder.join("sins_out/rest_summary.csv"));
        for key in ["rer_rms_nmi_h", "r50_nmi_h", "r95_nmi_h"] {
            assert_eq!(figure(&summary, key) != "none", has_rates, "{key} after {seconds} s");
        }
        assert_eq!(figure(&summary, "slope_nmi_h") != "none", has_slope, "{seconds} s");
        assert_eq!(said.contains("R50 = "), has_rates, "{said}");
        assert_eq!(
            said.contains("RER, R50, R95: none: they need 84.4 min of navigation, a Schuler period"),
            !has_rates
        );
        assert_eq!(said.contains("slope: none before 300 s of navigation"), !has_slope, "{said}");
        let page = |name: &str| {
            done(&folder, &["report", "sins_out/rest.csv", "-o", name]);
            read(folder.join(name))
        };
        let page = page("page.html");
        assert_eq!(page.contains("Slope of the straight line: none"), !has_slope);
        assert_eq!(page.contains(", R50 "), has_rates);
    }
}

#[test]
fn records_are_spaced_as_they_are_wanted() {
    let folder = folder("spaced");
    let fly = |settings: &[&str]| {
        done(&folder, &[&["fly", "rest", "-q", "--set", "flight.hours=0.05"], settings].concat());
        numbers(&folder.join("sins_out/rest.csv")).1.iter().map(|row| row[0]).collect::<Vec<f64>>()
    };
    let times = fly(&["--set", "output.every_s=2.5"]);
    assert!(times.len() == 73 && times.windows(2).all(|pair| (pair[1] - pair[0] - 2.5).abs() < 1e-9));
    // The end of the flight has a record, whatever the spacing.
    let times = fly(&["--set", "output.every_s=0.7"]);
    assert_eq!((times.len(), times[257], times[258]), (259, 179.9, 180.0));
    // By default about 2000 of 18 000 intervals have records.
    assert_eq!(fly(&[]).len(), 2001);
    let errors = rejected(&folder, &["fly", "rest", "--set", "output.every_s=0.001"]);
    assert!(
        errors.contains("output.every_s = 0.001: must be at least the sample interval, 0.01"),
        "{errors}"
    );
}

/// If the scene requests it, the summary reports the extremes of the true motion, which reveal a log in wrong units.
#[test]
fn the_true_motion_is_summed_up() {
    let folder = folder("truth");
    let fly = |settings: &[&str]| {
        let said = done(&folder, &[&["fly", "aerobatics", "--name", "run"], settings].concat());
        (said, read(folder.join("sins_out/run_summary.csv")))
    };
    let (said, summary) = fly(&[]);
    assert!(!summary.contains("truth_rate_max_rad_s") && !said.contains("largest angular rate"));
    let (said, summary) = fly(&["--set", "options.truth_summary=on"]);
    let rate: f64 = figure(&summary, "truth_rate_max_rad_s").parse().unwrap();
    // Three rolls in 6 s, by a step that is smooth to the third derivative, with a largest slope of 35/16. The mean over an
    // interval, 1/600 of the 6 s, is smaller by (1/600)² of the curvature.
    let expected = 35.0 / 16.0 * std::f64::consts::PI;
    assert!((rate / expected - 1.0).abs() < 1e-4, "{rate}");
    assert!(said.contains("truth           largest angular rate"), "{said}");
}

/// The start of a preset is that of its grade, and a flight says which start it used.
#[test]
fn a_flight_says_how_it_started() {
    let folder = folder("started");
    for (arguments, said) in [
        (&["--preset", "navigation"][..], "alignment gyrocompass, length of the alignment 600 s"),
        (
            &["--preset", "tactical", "--set", "start.alignment_s=60"],
            "alignment level, length of the alignment 60 s",
        ),
        (
            &["--preset", "navigation", "--set", "start.preset=ideal"],
            "none: true position, velocity and attitude",
        ),
        (&[], "none: true position, velocity and attitude"),
    ] {
        let shown = done(&folder, &[&["fly", "rest", "--set", "flight.hours=0.01"], arguments].concat());
        let summary = read(folder.join("sins_out/rest_summary.csv"));
        assert!(shown.contains(said) && summary.contains(said), "{shown}");
    }
}

/// If the covariance is on, nine columns of standard deviations follow, and the page has the envelope.
#[test]
fn standard_deviations_are_recorded_and_drawn() {
    let folder = folder("sigmas");
    let fly = |settings: &[&str]| {
        let fixed =
            ["fly", "rest", "-q", "--preset", "navigation", "--set", "flight.hours=0.05", "--name", "run"];
        done(&folder, &[&fixed, settings].concat());
        numbers(&folder.join("sins_out/run.csv"))
    };
    let without = fly(&[]);
    let with = fly(&["--set", "options.covariance=on"]);
    assert_eq!(with.0.len(), without.0.len() + 9);
    assert!(with.0[without.0.len()].starts_with("sigma_position_east"));
    for (row, other) in with.1.iter().zip(&without.1) {
        assert_eq!(row[..other.len()], other[..], "the errors are the same");
    }
    let sigma = |row: &Vec<f64>| row[without.0.len()];
    assert!(sigma(&with.1[0]) >= 0.0 && with.1.last().is_some_and(|last| sigma(last) > sigma(&with.1[1])));
    done(&folder, &["report", "sins_out/run.csv", "-o", "page.html"]);
    assert!(read(folder.join("page.html")).contains("class=\"sigma\""));
}

#[test]
fn what_was_meant_is_reported() {
    let folder = folder("meant");
    for (arguments, words) in [
        (&["reprot"][..], "'report'"),
        (&["fly", "simulaton2"], "did you mean simulation2?"),
        (&["fly", "patrol", "--sett", "a=b"], "'--set'"),
        (&["fly", "patrol", "--set", "gyro.bais_deg_h=1"], "bias_deg_h?"),
        (&["fly", "patrol", "--preset", "tacticle"], "--preset tacticle: gyro.preset"),
        (&["fly", "patrol", "--set", "gyro.bias_deg_h"], "expected KEY=VALUE"),
        (&["fly"], "no scene was given"),
        (&["fly", "nowhere.csv"], "nowhere.csv: cannot be read"),
        (&["fly", "nowhere.toml"], "nowhere.toml: cannot be read"),
        (&["fly", "patrol", "--name", "a/b"], "without a folder"),
        (&["fly", "aerobatics", "--set", "flight.hours=9"], "flight.hours = 9: must be at most"),
        (&["recommend", "patrol"], "--position"),
        (&["recommend", "patrol", "--position", "-1"], "--position"),
        (&["ensemble", "patrol", "--runs", "-1"], "--runs"),
    ] {
        let errors = rejected(&folder, arguments);
        assert!(errors.contains(words), "{arguments:?}: {errors}");
    }
    assert_eq!(names(&folder), [""; 0]);
}

#[test]
fn scenes_are_listed_checked_and_written() {
    let folder = folder("scenes");
    let list = done(&folder, &["scene", "list"]);
    assert!(
        list.lines().count() == sins::scene::BUILTIN_SCENES.len() && list.contains("over_the_pole  "),
        "{list}"
    );
    let text = done(&folder, &["scene", "write", "simulation2", "--set", "flight.hours=0.05"]);
    std::fs::write(folder.join("own.toml"), &text).unwrap();
    let said = done(&folder, &["scene", "check", "own.toml"]);
    // The title of 48 hours is not that of 3 minutes.
    assert!(
        said.starts_with("own.toml: The first 3 min of \"Closed figure-eights")
            && said.contains("3 min at 100 Hz"),
        "{said}"
    );
    done(&folder, &["fly", "own.toml", "-q"]);
    done(&folder, &["fly", "simulation2", "-q", "--set", "flight.hours=0.05"]);
    assert_eq!(read(folder.join("sins_out/own.csv")), read(folder.join("sins_out/simulation2.csv")));
    // An existing scene is the user's own.
    let order = ["scene", "write", "patrol", "-o", "own.toml"];
    assert!(rejected(&folder, &order).contains("--force"));
    done(&folder, &[&order[..], &["--force"]].concat());
    for scene in ["drone", "fighter", "patrol", "resets", "trainer"] {
        let path = project_file(&format!("c_examples/scenes/{scene}.toml"));
        done(&folder, &["scene", "check", path.to_str().unwrap()]);
    }
}

#[test]
fn the_scene_of_the_page_flies() {
    let folder = folder("page");
    let page = read(project_file("docs/scenes.md"));
    let (text, _) = page.split_once("```toml\n").unwrap().1.split_once("```").unwrap();
    let flights = project_file("c_examples/flights");
    std::fs::write(
        folder.join("own.toml"),
        text.replace("../flights", &flights.to_str().unwrap().replace('\\', "/")),
    )
    .unwrap();
    done(&folder, &["fly", "own.toml", "-q", "--set", "flight.hours=0.02"]);
    assert!(folder.join("sins_out/own.csv").exists());
}

#[test]
fn keys_and_completions_are_printed() {
    let folder = folder("keys");
    let keys = done(&folder, &["keys"]);
    for section in ["[flight]", "[[manoeuvre.sinusoid]]", "[gyro]", "[[failure]]", "[output]"] {
        assert!(keys.contains(section), "{section}");
    }
    assert!(keys.contains("; one number for all axes, or three [deg/h]; in SI bias_rad_s"));
    for shell in ["bash", "zsh", "fish", "powershell"] {
        assert!(done(&folder, &["completions", shell]).contains("recommend"), "{shell}");
    }
}

/// A reader that closes the pipe early is no failure.
#[test]
#[cfg(unix)]
fn a_closed_pipe_is_no_failure() {
    let folder = folder("pipe");
    let script = format!("'{}' keys | true; exit ${{PIPESTATUS:-0}}", env!("CARGO_BIN_EXE_sins"));
    let output =
        std::process::Command::new("sh").args(["-c", &script]).current_dir(&folder).output().unwrap();
    assert_eq!(String::from_utf8_lossy(&output.stderr), "");
}

/// A minute at rest with a row each second, then five seconds of rolling with twenty rows each second.
#[test]
fn a_piece_of_an_uneven_log_is_found_by_its_time_stamps() {
    let folder = folder("uneven");
    let rest = (0..60).map(|second| (f64::from(second), 0.0));
    let rolling = (0..=100).map(|step| (60.0 + f64::from(step) / 20.0, 5.0 * (f64::from(step) * 0.1).sin()));
    let rows = rest.chain(rolling).map(|(time_s, roll)| format!("{time_s},45,10,100,{roll},0,0\n"));
    let header = "time_s,latitude_deg,longitude_deg,height_m,roll_deg,pitch_deg,heading_deg\n";
    std::fs::write(folder.join("log.csv"), header.to_owned() + &rows.collect::<String>()).unwrap();
    let recommend = |arguments: &[&str]| {
        done(&folder, &[&["recommend", "log.csv", "--position", "1"][..], arguments].concat())
    };
    let rolling = recommend(&["--from", "60", "--piece", "5"]);
    let verdict = "judged by 5 s from 60 s, of 65 s: no other part is harder\n";
    assert!(rolling.contains(verdict), "{rolling}");
    let rest = recommend(&["--from", "20", "--piece", "30"]);
    let verdict = "judged by 30 s from 20 s, of 65 s: may not hold elsewhere, with a larger rate at 6";
    assert!(rest.contains(verdict), "{rest}");
    // So are its records, and the rows of an ensemble.
    let fly = ["fly", "log.csv", "--preset", "tactical", "--set", "output.every_s=5"];
    assert!(done(&folder, &fly).contains("  records         14, one each 5 s, in "));
    done(&folder, &["ensemble", "log.csv", "--runs", "2", "--every", "5"]);
    let multiples: Vec<f64> = (0..=13).map(|k| 5.0 * f64::from(k)).collect();
    for name in ["log.csv", "log_ensemble.csv"] {
        let (_, rows) = numbers(&folder.join("sins_out").join(name));
        assert_eq!(rows.iter().map(|row| row[0]).collect::<Vec<_>>(), multiples, "{name}");
    }
    let errors = rejected(&folder, &["fly", "log.csv", "--set", "flight.hours=5"]);
    assert!(
        errors.contains("flight.duration_s = 18000: must be at most the duration of the log: 65"),
        "{errors}"
    );
    let errors = rejected(&folder, &["recommend", "log.csv", "--position", "1", "--from", "-5"]);
    assert_eq!(errors, "--from -5: the piece must begin in the scene; it lasts 65 s\n");
}

#[test]
fn options_are_recommended_and_too_much_is_reported() {
    let folder = folder("recommend");
    let scene = ["recommend", "aerobatics", "--piece", "30", "--hours", "0.01"];
    let said = done(&folder, &[&scene[..], &["--position", "1"]].concat());
    assert!(said.contains("[options]\nscheme = \"") && said.contains("algorithms were tried"), "{said}");
    assert!(!said.contains("a step takes"), "{said}");
    // The rolls come after 30 s.
    assert!(said.contains("may not hold elsewhere, with a larger rate at "), "{said}");
    let hard = done(&folder, &["recommend", "rest", "--piece", "30", "--position", "1"]);
    assert!(hard.contains("no other part is harder"), "{hard}");
    let timed = done(&folder, &[&scene[..], &["--position", "1", "--time-steps"]].concat());
    let (answer, _) = said.split_once("next: ").unwrap();
    assert!(timed.starts_with(answer) && timed.contains("a step takes "), "{timed}");
    // The printed options are a valid part of a scene.
    let options = said.split("\n\n").next().unwrap();
    std::fs::write(folder.join("own.toml"), format!("[flight]\nbuiltin = \"aerobatics\"\n{options}\n"))
        .unwrap();
    done(&folder, &["scene", "check", "own.toml"]);
    let (code, said, errors) = run(&folder, &[&scene[..], &["--position", "1e-12"]].concat());
    assert!(code == 3 && errors.contains("no options meet") && said.contains("[options]"), "{code} {errors}");
}

/// The scheme and the subsamples of an answer of `sins recommend`, which has one update a sample.
fn recommended(said: &str) -> (String, u32) {
    let value = |key: &str| {
        let line = said.lines().find_map(|line| line.strip_prefix(key)).unwrap_or_else(|| panic!("{said}"));
        line.trim_matches([' ', '=', '"']).to_owned()
    };
    assert_eq!(value("updates_per_sample"), "1");
    (value("scheme"), value("subsamples").parse().unwrap())
}

/// Each answer is flown over the whole scene: its error is within the limit, and that of one subsample less is beyond it. The
/// ramp is ten minutes of rest before the motion.
#[test]
fn recommended_options_hold_over_the_whole_scene() {
    let folder = folder("whole");
    let ramp = "[flight]\nspeed_m_s = 0\nrate_hz = 25\n[[manoeuvre]]\nkind = \"rest\"\nduration_s = 600\n\
                [[manoeuvre]]\nkind = \"accelerate\"\nspeed_change_m_s = 200\nduration_s = 40\n\
                [[manoeuvre]]\nkind = \"roll\"\nturns = 3\nduration_s = 9\n\
                [[manoeuvre]]\nkind = \"turn\"\nheading_change_deg = 360\nbank_deg = 70\nramp_s = 4\n";
    std::fs::write(folder.join("ramp.toml"), ramp).unwrap();
    let log = project_file("c_examples/flights/fighter_aerobatics.csv").to_str().unwrap().to_owned();
    for (scene, rate, limit_m) in [
        ("ramp.toml", "flight.rate_hz=25", 0.1),
        ("aerobatics", "flight.rate_hz=25", 0.1),
        ("over_the_pole", "flight.rate_hz=25", 0.01),
        (&*log, "flight.latitude_deg=0", 0.01),
    ] {
        let limit = limit_m.to_string();
        let settings: &[&str] = if scene == log { &[scene] } else { &[scene, "--set", rate] };
        let said = done(&folder, &[&["recommend"], settings, &["--position", &limit]].concat());
        assert!(said.contains("judged by the whole scene"), "{said}");
        let (scheme, subsamples) = recommended(&said);
        let error_m = |subsamples: u32| -> f64 {
            let options = [format!("options.scheme={scheme}"), format!("options.subsamples={subsamples}")];
            let options = ["--set", &options[0], "--set", &options[1], "--name", "flown", "-q"];
            done(&folder, &[&["fly"], settings, &options].concat());
            figure(&read(folder.join("sins_out/flown_summary.csv")), "max_position_m").parse().unwrap()
        };
        let (answer_m, cheaper_m) = (error_m(subsamples), error_m(subsamples - 1));
        println!("{scene}: {scheme} {subsamples}: {answer_m} m, one less {cheaper_m} m, limit {limit_m} m");
        assert!(answer_m <= limit_m && cheaper_m > limit_m, "{scene}: {answer_m} {cheaper_m}");
    }
}

/// Slow coning for half an hour is harder than a short violent roll: the answer by parts of a long scene holds when it is flown.
#[test]
fn coning_in_a_long_scene_is_not_overlooked() {
    let folder = folder("coned");
    let sinusoid = |channel: &str, phase_deg: f64| {
        format!(
            "[[manoeuvre.sinusoid]]\nchannel = \"{channel}\"\namplitude_deg = 1\nfrequency_hz = 2\nphase_deg = {phase_deg}\n"
        )
    };
    let long = "[flight]\nspeed_m_s = 150\nrate_hz = 100\n[[manoeuvre]]\nkind = \"roll\"\nturns = 2\nduration_s = 4\n\
                [[manoeuvre]]\nkind = \"turn\"\nheading_change_deg = 90\nbank_deg = 60\n\
                [[manoeuvre]]\nkind = \"straight\"\nduration_s = 1800\n\
                [[manoeuvre]]\nkind = \"sinusoids\"\nduration_s = 1800\nramp_s = 5\n";
    let text = [long.to_owned(), sinusoid("roll", 0.0), sinusoid("pitch", 90.0)].concat();
    std::fs::write(folder.join("coned.toml"), text).unwrap();
    let said = done(&folder, &["recommend", "coned.toml", "--position", "0.1"]);
    assert!(said.contains("judged by 2 pieces"), "the manoeuvres, and the coning: {said}");
    let (scheme, subsamples) = recommended(&said);
    let options = [format!("options.scheme={scheme}"), format!("options.subsamples={subsamples}")];
    done(&folder, &["fly", "coned.toml", "--set", &options[0], "--set", &options[1], "-q"]);
    let error_m: f64 =
        figure(&read(folder.join("sins_out/coned_summary.csv")), "max_position_m").parse().unwrap();
    println!("{scheme} {subsamples}: {error_m} m");
    assert!(error_m < 0.1, "{error_m}");
}

/// The hardest parts of a scene that is too long to be flown as a whole.
#[test]
fn a_long_scene_is_judged_by_its_hardest_parts() {
    let folder = folder("hardest");
    let long = "[flight]\nspeed_m_s = 150\nrate_hz = 100\n[[manoeuvre]]\nkind = \"straight\"\nduration_s = 3000\n\
                [[manoeuvre]]\nkind = \"roll\"\nturns = 2\nduration_s = 8\n\
                [[manoeuvre]]\nkind = \"straight\"\nduration_s = 1000\n";
    std::fs::write(folder.join("long.toml"), long).unwrap();
    let said = done(&folder, &["recommend", "long.toml", "--position", "1"]);
    let line = said.lines().find(|line| line.starts_with("judged by")).unwrap();
    let begins: Vec<f64> =
        line.split(" s").filter_map(|words| words.rsplit([' ', ',']).next()?.parse().ok()).collect();
    // 60 s, where each piece begins, and the whole of 4008 s.
    assert!(
        line.contains("largest rate, force, vibration and coning") && begins.len() >= 3,
        "{line} {begins:?}"
    );
    let pieces = &begins[1..begins.len() - 1];
    assert!(pieces.iter().any(|from_s| (from_s..&(from_s + 60.0)).contains(&&3004.0)), "{line}");
    // Two turns in 8 s are 90 deg/s on average.
    let line = said.lines().find_map(|line| line.strip_prefix("  largest rate ")).unwrap();
    let (rate_deg_s, rest) = line.split_once(" deg/s at ").unwrap();
    let at_s: f64 = rest.split_once(" s, ").unwrap().0.parse().unwrap();
    assert!(rate_deg_s.parse::<f64>().unwrap() > 90.0 && (3000.0..3008.0).contains(&at_s), "{line}");
}

/// Near a pole, velocity and misalignment have no east and north, so they have no figures.
#[test]
fn near_a_pole_there_are_no_figures_of_velocity() {
    let folder = folder("pole");
    std::fs::write(folder.join("pole.csv"), log().replace(",0.7,", ",1.5707,")).unwrap();
    let said = done(&folder, &["fly", "pole.csv"]);
    let words =
        "  11 of 11 records are near a pole: they are not in the figures of velocity and misalignment\n";
    assert!(said.contains(words) && !said.contains("velocity error"), "{said}");
    let summary = read(folder.join("sins_out/pole_summary.csv"));
    assert!(summary.contains("\nrecords_near_pole,11,") && !summary.contains("max_velocity"), "{summary}");
}

/// A scene that is written into another folder finds its log, and a scene is not replaced without --force.
#[test]
fn a_scene_written_elsewhere_finds_its_log() {
    let folder = with_log("elsewhere");
    std::fs::create_dir(folder.join("scenes")).unwrap();
    std::fs::write(folder.join("scenes/own.toml"), "[flight]\nfile = \"../logs/mylog.csv\"\n").unwrap();
    let write = ["scene", "write", "scenes/own.toml", "-o", "other.toml"];
    done(&folder, &write);
    done(&folder, &["scene", "check", "other.toml"]);
    assert_eq!(rejected(&folder, &write), "other.toml: exists already; --force replaces it\n");
}

#[test]
fn hours_are_those_of_the_command_line_and_every_file_is_named() {
    let folder = folder("hours_and_files");
    let day = project_file("c_examples/scenes/day.toml");
    let day = day.to_str().unwrap();
    let said = done(&folder, &["fly", day, "--hours", "1.08", "--imu", "imu.csv", "--bus", "words.csv"])
        .replace('\\', "/");
    let (_, listed) = said.split_once("\nwritten\n").unwrap();
    for file in ["day.csv", "imu.csv", "day_unit.csv", "words.csv", "day_summary.csv"] {
        let path = format!("sins_out/{file}");
        let line = listed
            .lines()
            .find(|line| line.trim_start().starts_with(&path))
            .unwrap_or_else(|| panic!("{said}"));
        let size = std::fs::metadata(folder.join(&path)).unwrap().len() as f64;
        let words: Vec<&str> = line.split_whitespace().rev().take(2).collect();
        let unit = match words[0] {
            "B" => 1.0,
            "kB" => 1e3,
            _ => 1e6,
        };
        assert!((words[1].parse::<f64>().unwrap() * unit / size - 1.0).abs() < 0.05, "{line}: {size}");
    }
    assert!(said.ends_with("next: `sins report sins_out/day.csv` draws the flight\n"), "{said}");
    // What is said of a flight with a unit, which navigates here at its end.
    assert!(said.contains("  start errors    those that the alignment of the unit leaves\n"), "{said}");
    assert!(
        said.contains("; 10.0 min of alignment\n  valid at end    rates, attitude, heading, position, velocity; wrong by: position "),
        "{said}"
    );
    assert!(said.contains("\n  invalid for     no-position 15.1 s to "), "{said}");
    assert!(
        said.contains("none: they need 84.4 min of navigation, a Schuler period, and it navigated 53.1 min")
            && said.contains("NAV) at 700.05 s")
            && !said.contains("R50 ="),
        "{said}"
    );
    let ended = numbers(&folder.join("sins_out/day.csv")).1.last().unwrap()[0];
    assert_eq!(ended, 3888.0);
    done(&folder, &["ensemble", "patrol", "--preset", "navigation", "--runs", "2", "--hours", "0.05", "-q"]);
    let ended = read(folder.join("sins_out/patrol_ensemble.csv"));
    assert!(ended.lines().last().unwrap().starts_with("180.000000,"));
    for command in ["fly", "ensemble"] {
        let errors = rejected(&folder, &[command, "patrol", "--hours", "60"]);
        assert!(
            errors.contains("--hours 60: ") && errors.contains("at most the duration of the flight: 48"),
            "{errors}"
        );
    }
}

#[test]
fn a_word_that_is_no_command_is_answered_with_the_command_that_does_it() {
    let folder = folder("commands");
    for (word, command) in [("run", "fly SCENE"), ("list", "scene list"), ("plot", "report RECORDS.csv")] {
        let errors = rejected(&folder, &[word]);
        assert!(errors.contains(&format!("tip: `sins {command}`")), "{errors}");
    }
    // So is an option; one that begins as another does, or is nearly another, is answered with that.
    for (option, tip) in [
        ("--duration", "tip: --hours HOURS"),
        ("--seed", "tip: --set options.seed=N"),
        ("--dt", "tip: --set flight.rate_hz=HZ"),
        ("--hour", "'--hours'"),
        ("--pres", "'--preset'"),
    ] {
        let errors = rejected(&folder, &["fly", "patrol", option, "1"]);
        assert!(errors.contains(tip), "{errors}");
    }
    for (word, command) in [("ens", "'ensemble'"), ("rec", "'recommend'"), ("bud", "'budget'")] {
        let errors = rejected(&folder, &[word]);
        assert!(errors.contains(command), "{errors}");
    }
    for (key, meant) in [("gyro.bias", "bias_deg_h"), ("flight.hour", "hours")] {
        let errors = rejected(&folder, &["fly", "patrol", "--set", &format!("{key}=1")]);
        assert!(errors.ends_with(&format!("did you mean {meant}?\n")), "{errors}");
    }
    // A slip of the pen is answered with the nearest command alone.
    let errors = rejected(&folder, &["flly"]);
    assert!(errors.contains("'fly'") && !errors.contains("`sins"), "{errors}");
}

/// The summary says whether the alignment at rest is one of a vehicle that rests: by velocities, by positions, and in a log.
#[test]
fn a_start_in_motion_is_said() {
    let folder = folder("start_in_motion");
    let log = |step: f64| {
        let row = |t: u32| format!("{t},{},0,50,0,0,0\n", 0.5 + step * f64::from(t));
        format!(
            "time_s,latitude_rad,longitude_rad,height_m,roll_rad,pitch_rad,heading_rad\n{}",
            (0..=20).map(row).collect::<String>()
        )
    };
    // 1e-5 rad of latitude are 64 m.
    std::fs::write(folder.join("moves.csv"), log(1e-5)).unwrap();
    std::fs::write(folder.join("rests.csv"), log(0.0)).unwrap();
    let moves = "aligned as at rest (the flight begins in motion, at ";
    for (flown, more, words) in [
        ("patrol", &["--preset", "navigation"][..], format!("{moves}200 m/s) and drawn: ")),
        ("patrol", &["--set", "start.alignment=gyrocompass"], format!("{moves}200 m/s): alignment")),
        ("racetrack", &["--preset", "tactical"], moves.to_owned()),
        ("moves.csv", &["--preset", "navigation"], format!("{moves}63.")),
        ("commuter", &["--preset", "navigation"], "aligned at rest and drawn: ".to_owned()),
        ("rests.csv", &["--preset", "navigation"], "aligned at rest and drawn: ".to_owned()),
        ("patrol", &[], "none: true position, velocity and attitude".to_owned()),
        ("patrol", &["--set", "start.velocity_m_s=[1, 0, 0]"], "given: velocity error".to_owned()),
    ] {
        let order = ["fly", flown, "--force", "--name", "run", "--hours", "0.004"];
        let (code, said, errors) = run(&folder, &[&order[..], more].concat());
        assert_eq!(code, 0, "{errors}");
        assert!(said.contains(&format!("  start errors    {words}")), "{flown} {more:?}: {said}");
        let summary = read(folder.join("sins_out/run_summary.csv"));
        let text = summary.lines().find_map(|line| line.strip_prefix("start_text,")).unwrap();
        assert!(text.trim_start_matches('"').starts_with(&words), "{text}");
    }
}
