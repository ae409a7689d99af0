//! What the page of a flight says and marks.

use crate::support::{done, folder, read, sins};

/// Flies a built-in scene with settings, and returns its page.
fn page(name: &str, scene: &str, settings: &[&str]) -> String {
    let folder = folder(name);
    let mut arguments = vec!["fly", scene, "--quiet", "--name", "run"];
    settings.iter().for_each(|setting| arguments.extend(["--set", setting]));
    done(&folder, &arguments);
    done(&folder, &["report", "sins_out/run.csv"]);
    read(folder.join("sins_out/report.html"))
}

#[test]
fn failures_are_named_and_marked() {
    let folder = folder("failures");
    let failure =
        "[[failure]]\nsensor = 'gyro'\naxis = 'z'\nkind = 'bias_step'\nsize_deg_h = 100\nfrom_s = 60\n";
    let text = format!("[flight]\nbuiltin = 'aerobatics'\nhours = 0.05\n{failure}until_s = 90\n");
    std::fs::write(folder.join("scene.toml"), text).unwrap();
    done(&folder, &["fly", "scene.toml", "--quiet"]);
    done(&folder, &["report", "sins_out/scene.csv"]);
    let page = read(folder.join("sins_out/report.html"));
    assert_eq!(
        page.matches("gyro z bias step 100 deg/h 60 s to 90 s").count(),
        3,
        "overview, heading, settings"
    );
    // Begin and end in three panels of three errors, in the radial error and in the three panels of the gyros.
    let marks = page.matches("<path class=\"failure\"").count();
    assert_eq!(marks, 2 * (3 * 3 + 1 + 3));
    assert!(page.contains("<circle class=\"end\""));
    done(&folder, &["ensemble", "scene.toml", "--preset", "tactical", "--runs", "16", "--quiet"]);
    let page = read(folder.join("sins_out/scene_ensemble.html"));
    assert!(page.contains("Failures: gyro z bias step 100 deg/h 60 s to 90 s."));
    // In the panels of three errors, of the error along and across the track, and of the horizontal error.
    assert_eq!(page.matches("<path class=\"failure\"").count(), 2 * (3 * 3 + 2 + 1));
}

#[test]
fn only_a_simulation_of_the_paper_has_the_names_of_the_paper() {
    let settings = ["flight.hours=0.02"];
    let paper = page("paper", "simulation2", &settings);
    assert!(paper.contains("(figure 3 of the paper)") && paper.contains("data 2: navigation minus truth"));
    for (name, model) in [("other", "off"), ("other_model", "rk4")] {
        let model = format!("options.error_model={model}");
        let other = page(name, "aerobatics", &["flight.hours=0.02", &model]);
        // The style sheet has classes of the curves' schemes.
        let (_, body) = other.split_once("</style>").unwrap();
        for word in ["the paper", "data 1", "data 2", "Data 1", "Data 2"] {
            assert!(!body.contains(word), "{name}: {word}");
        }
    }
}

#[test]
fn a_flight_with_ideal_sensors_shows_the_error_of_the_simulator() {
    let settings = ["flight.hours=0.02"];
    assert!(page("ideal", "aerobatics", &settings).contains("data-label=\"Simulator’s own error\""));
    let biased = ["flight.hours=0.02", "gyro.bias_deg_h=0.01"];
    assert!(!page("biased", "aerobatics", &biased).contains("data-label=\"Simulator’s own error\""));
}

#[test]
fn the_page_of_an_ensemble_names_its_errors() {
    let folder = folder("ensemble");
    let settings = ["--set", "flight.hours=0.01", "--set", "options.error_model=rk4", "--preset", "tactical"];
    done(
        &folder,
        &[&["ensemble", "aerobatics", "--runs", "16", "--quiet", "--out", "."], &settings[..]].concat(),
    );
    let page = read(folder.join("aerobatics_ensemble.html"));
    let (_, body) = page.split_once("</style>").unwrap();
    assert!(body.contains("RMS, navigation") && body.contains("RMS, model"));
    assert!(!body.to_lowercase().contains("data 2") && !body.contains("the paper"));
}

/// The foot says when, by which command, by which version and on which machine the page was written.
#[test]
fn the_foot_of_a_page_says_how_it_was_written() {
    let folder = folder("foot");
    done(&folder, &["fly", "rest", "--quiet", "--set", "flight.hours=0.01"]);
    let mut order = sins(&folder, &["report", "sins_out/rest.csv", "-o", "a page.html"]);
    assert!(order.env("SOURCE_DATE_EPOCH", "951782400").status().unwrap().success());
    let page = read(folder.join("a page.html"));
    let (_, foot) = page.split_once("<footer>").unwrap();
    let version = env!("CARGO_PKG_VERSION");
    let line = format!(
        "Written on 2000-02-29 00:00 UTC by sins {version}: <code>sins report sins_out/rest.csv -o &quot;a page.html&quot;</code>"
    );
    assert!(foot.contains(&line), "{foot}");
    assert!(foot.contains(std::env::consts::ARCH) && foot.contains(" thread"), "{foot}");
}

/// The first words of a page are true: a title that speaks of what a setting has replaced is not said.
#[test]
fn a_title_is_that_of_what_is_flown() {
    let folder = folder("titles");
    let own = "[flight]\ntitle = \"A hop in the north by a tactical INS\"\nlatitude_deg = 70\nspeed_m_s = 100\n[[manoeuvre]]\n\
        kind = \"straight\"\nduration_s = 60\n[gyro]\npreset = \"tactical\"\n[[failure]]\nsensor = \"gyro\"\nkind = \"stuck\"\n\
        axis = \"x\"\nfrom_s = 30\n";
    std::fs::write(folder.join("own.toml"), own).unwrap();
    let log: String = (0..=60).map(|t| format!("{t},0.7,2.0,50,0,0,1\n")).collect();
    let header = "time_s,latitude_rad,longitude_rad,height_m,roll_rad,pitch_rad,heading_rad\n";
    std::fs::write(folder.join("parked.csv"), format!("{header}{log}")).unwrap();
    let hop = "A hop in the north by a tactical INS";
    let (paper, parked) = ("The paper's simulation 2: a patrol", "At rest, level, heading north");
    for (scene, set, title) in [
        ("own.toml", &[][..], hop),
        ("own.toml", &["--set", "options.seed=7", "--set", "flight.rate_hz=50"], hop),
        ("own.toml", &["--set", "flight.latitude_deg=70", "--set", "flight.hours=0.016666666666666666"], hop),
        ("own.toml", &["--set", "flight.hours=0.01"], "The first 36 s of \"A hop in the north"),
        ("own.toml", &["--set", "flight.title=Another"], "Another"),
        ("own.toml", &["--set", "flight.latitude_deg=10"], "Flight of 1 manoeuvre"),
        ("own.toml", &["--set", "manoeuvre[0].duration_s=50"], "Flight of 1 manoeuvre"),
        ("own.toml", &["--set", "gyro.bias_deg_h=0.5"], "Flight of 1 manoeuvre"),
        ("own.toml", &["--preset", "navigation"], "Flight of 1 manoeuvre"),
        ("own.toml", &["--set", "failure[0].axis=y"], "Flight of 1 manoeuvre"),
        ("simulation2", &["--set", "flight.builtin=rest", "--set", "flight.hours=1"], parked),
        (
            "simulation2",
            &["--set", "flight.hours=0.02"],
            "The first 72 s of \"The paper's simulation 2: a patrol",
        ),
        ("simulation2", &["--preset", "paper2", "--set", "flight.rate_hz=1"], paper),
        (
            "simulation2",
            &["--preset", "tactical", "--set", "flight.hours=0.02"],
            "The first 72 s of \"Closed figure-eights",
        ),
        (
            "patrol",
            &["--set", "flight.hours=1.5"],
            "\"Closed figure-eights at 8000 m and 200 m/s\", flown for 90 min",
        ),
    ] {
        let said = done(&folder, &[&["scene", "check", scene], set].concat());
        let (_, words) = said.split_once(": ").unwrap();
        assert!(words.starts_with(title), "{scene} {set:?}: {said}");
    }
    // The page of such a run, and of a log in the place of a flight.
    let parking = ["flight.builtin=rest", "flight.hours=1"];
    let parked = page("parked", "simulation2", &parking);
    assert!(parked.contains("<h1>At rest, level, heading north</h1>"));
    assert!(!parked.contains("a patrol") && !parked.contains("of the paper"));
    done(&folder, &["fly", "own.toml", "--log", "parked.csv", "-q"]);
    assert!(read(folder.join("sins_out/parked_summary.csv")).contains("scene_text,recorded flight,"));
    // A scene that is written keeps a title as long as it is true.
    let kept = |set: &[&str]| {
        done(&folder, &[&["scene", "write", "simulation2"], set].concat()).contains("a patrol of 48 hours")
    };
    assert!(
        kept(&["--set", "options.seed=3"])
            && !kept(&["--set", "flight.hours=1"])
            && !kept(&["--preset", "tactical"])
    );
}
