//! The unit of a scene: its states as a file and in the summary, and its words of ARINC 429.

use crate::support::{done, folder, number, numbers, project_file, read, rejected, rows, run};

const SCENE: &str = "
[flight]
latitude_deg = -34.5
longitude_deg = -151.2
rate_hz = 20
[[manoeuvre]]
kind = \"rest\"
duration_s = 120
[unit]
start = \"off\"
alignment_s = 60
[[panel]]
kind = \"nav\"
at_s = 10
[[panel]]
kind = \"true_position\"
at_s = 30
[[panel]]
kind = \"off\"
at_s = 110
";

#[test]
fn the_states_are_a_file_and_stand_in_the_summary_and_on_the_page() {
    let folder = folder("unit_states");
    std::fs::write(folder.join("box.toml"), SCENE).unwrap();
    done(&folder, &["fly", "box.toml", "-q"]);
    let rows = read(folder.join("sins_out/box_unit.csv"));
    let mut states: Vec<&str> = rows.lines().skip(1).map(|row| row.split(',').nth(1).unwrap()).collect();
    states.dedup();
    let expected = ["off", "test", "coarse alignment", "fine alignment", "navigation", "power-down", "off"];
    assert_eq!(states, expected);
    assert!(rows.contains(",fine alignment,") && rows.contains(",rates attitude heading position velocity,"));
    let summary = read(folder.join("sins_out/box_summary.csv"));
    assert!(
        summary.contains("unit_5_state,navigation,") && summary.contains("unit_5_from_s,75"),
        "{summary}"
    );
    done(&folder, &["report", "sins_out/box.csv"]);
    assert!(read(folder.join("sins_out/report.html")).contains("ALIGN"));
    // An entry at the wrong moment ends the flight with its reason.
    std::fs::write(folder.join("late.toml"), SCENE.replace("at_s = 30", "at_s = 115")).unwrap();
    let (code, _, errors) = run(&folder, &["fly", "late.toml", "-q"]);
    assert_eq!(code, 1);
    assert!(errors.contains("panel[1]: a position can be entered during an alignment"), "{errors}");
}

/// In flight the unit aligns on the updates of the velocity; without them it never does.
#[test]
fn an_alignment_in_flight_needs_updates_of_the_velocity() {
    const FLIGHT: &str = "
[flight]
latitude_deg = 47
height_m = 5000
speed_m_s = 150
rate_hz = 50
[[manoeuvre]]
kind = \"turn\"
heading_change_deg = 90
bank_deg = 30
[[manoeuvre]]
kind = \"straight\"
duration_s = 300
[gyro]
preset = \"navigation\"
[accelerometer]
preset = \"navigation\"
[unit]
start = \"off\"
alignment = \"in_flight\"
[[panel]]
kind = \"nav\"
at_s = 1
";
    const UPDATES: &str = "
[[update]]
kind = \"velocity\"
at_s = 2
every_s = 1
sigma_m_s = [0.1, 0.1, 0.1]
";
    let folder = folder("unit_in_flight");
    for (name, text, last) in
        [("with", [FLIGHT, UPDATES].concat(), "navigation"), ("without", FLIGHT.into(), "coarse alignment")]
    {
        std::fs::write(folder.join(name).with_extension("toml"), text).unwrap();
        done(&folder, &["fly", &format!("{name}.toml"), "-q"]);
        let rows = read(folder.join(format!("sins_out/{name}_unit.csv")));
        let row = rows.lines().last().unwrap();
        assert_eq!(row.split(',').nth(1), Some(last), "{row}");
        assert_eq!(row.contains("no-position"), name == "without");
    }
}

/// R50 and the slope count from NAV: those of the errors of the records over the time since then. An update after it leaves none.
#[test]
fn rates_count_from_nav() {
    let folder = folder("unit_rates");
    let text = SCENE.replace("duration_s = 120", "duration_s = 5200").replace("at_s = 110", "at_s = 5160");
    let bias = "[accelerometer]\nbias_micro_g = 50\n[output]\nevery_s = 1\n";
    let update = |at_s: u32| format!("[[update]]\nkind = \"position\"\nat_s = {at_s}\nsigma_m = [9, 9, 9]\n");
    let fly = |name: &str, more: &str| {
        std::fs::write(folder.join(name).with_extension("toml"), [&text, bias, more].concat()).unwrap();
        done(&folder, &["fly", &format!("{name}.toml")])
    };
    let figure = |name: &str, key: &str| {
        let summary = rows(&folder.join(format!("sins_out/{name}_summary.csv")));
        summary.into_iter().find(|row| row["key"] == key).unwrap()
    };
    let said = fly("whole", "");
    let from_s = number(&figure("whole", "nav_from_s"), "value");
    assert!((from_s - 75.0).abs() < 0.5, "{from_s}");
    assert!(
        said.contains(&format!("from the begin of the navigation (NAV) at {from_s} s to its end at 5160")),
        "{said}"
    );
    let (names, records) = numbers(&folder.join("sins_out/whole.csv"));
    let column = |name: &str| names.iter().position(|other| other == name).unwrap();
    let [east, north] = ["east", "north"].map(|axis| column(&format!("navigation_error_position_{axis}_m")));
    let squares: Vec<f64> = records
        .iter()
        .map(|row| (row[0] - from_s, row[east].hypot(row[north])))
        .filter(|(t, _)| (300.0..5160.0 - from_s).contains(t))
        .map(|(t, radius)| (radius / t).powi(2))
        .collect();
    let r50 = (2f64.ln() * squares.iter().sum::<f64>() / squares.len() as f64).sqrt() * 3600.0 / 1852.0;
    let found = number(&figure("whole", "r50_nmi_h"), "value");
    // The samples and the records are each a second, at other fractions of it: over 4800 s they differ by less than 1e-3.
    assert!(r50 > 0.01 && (found / r50 - 1.0).abs() < 1e-3, "{found} {r50}");
    done(&folder, &["report", "sins_out/whole.csv"]);
    assert!(read(folder.join("sins_out/report.html")).contains(" since NAV at "));

    fly("before", &update(60));
    assert_ne!(figure("before", "r50_nmi_h")["value"], "none");
    let said = fly("after", &update(2000));
    assert!(said.contains("RER, R50, R95: none: an update after NAV starts the errors anew"), "{said}");
    assert_eq!(figure("after", "slope_nmi_h")["value"], "none");
    done(&folder, &["report", "sins_out/after.csv"]);
    let page = read(folder.join("sins_out/report.html"));
    // The update and the end of the alignment, in three panels of three errors, in the radial error and in the panels of the
    // accelerometers.
    assert_eq!(page.matches("<path class=\"correction\"").count(), 2 * (3 * 3 + 1 + 3));
    assert!(page.contains("update by a fix; end of an alignment, which corrects the solution"));
    assert!(page.contains("sets its solution to the truth each 60 s: the sawtooth"));
}

/// A limit that grows counts from NAV; one that is due before is rejected.
#[test]
fn a_growing_limit_counts_from_nav() {
    let folder = folder("unit_limit");
    std::fs::copy(project_file("c_examples/scenes/day.toml"), folder.join("day.toml")).unwrap();
    let requirement = |time_h: &str| {
        let limit =
            format!("quantity = \"position_horizontal\"\npercent = 50\nlimit_nmi_h = 9\ntime_h = {time_h}\n");
        std::fs::write(folder.join("limit.toml"), format!("[[requirement]]\n{limit}")).unwrap();
    };
    let order =
        ["ensemble", "day.toml", "--hours", "0.25", "--runs", "2", "--meets", "limit.toml", "--threads", "1"];
    requirement("0.25");
    let (code, said, errors) = run(&folder, &order);
    assert_eq!(code, 4, "two runs decide nothing: {errors}");
    let verdict = rows(&folder.join("sins_out/day_ensemble_meets.csv")).remove(0);
    // The selector is turned to NAV at 700 s, and the unit takes it with the next interval.
    let grown_s = number(&verdict, "limit_si") / (9.0 * 1852.0 / 3600.0);
    assert!((grown_s - 200.0).abs() <= 0.1, "{grown_s}");
    assert!(said.contains("after 15 min, which grows from NAV at 11.7 min on"), "{said}");
    requirement("0.19");
    let errors = rejected(&folder, &order);
    assert!(errors.contains("position_horizontal is due before the unit navigates, 700"), "{errors}");
}

/// Time, label, value and status of the words of a flight.
fn words(text: &str) -> Vec<(f64, String, String)> {
    let row = |line: &str| {
        let fields: Vec<&str> = line.split(',').collect();
        (fields[0].parse().unwrap(), fields[1].to_owned(), format!("{} {}", fields[3], fields[5]))
    };
    text.lines().skip(1).map(row).collect()
}

/// With a delay of 100 ms, the words begin to be valid 100 ms later.
#[test]
fn words_on_the_bus_have_their_delay() {
    let folder = folder("unit_bus");
    std::fs::write(folder.join("box.toml"), SCENE).unwrap();
    done(&folder, &["fly", "box.toml", "-q", "--bus", "now.csv"]);
    done(&folder, &["fly", "box.toml", "-q", "--bus", "late.csv", "--bus-delay", "100"]);
    let of = |name: &str| words(&read(folder.join("sins_out").join(name)));
    let (now, late) = (of("now.csv"), of("late.csv"));
    let begin = |all: &[(f64, String, String)], status: &str| {
        all.iter().find(|(_, label, value)| label == "310" && value.ends_with(status)).unwrap().0
    };
    // 310 is sent each 0.1 s.
    let difference = begin(&late, " normal") - begin(&now, " normal");
    assert!((difference - 0.1).abs() < 1e-9, "{difference}");
    let latitude =
        &now.iter().rfind(|(_, label, value)| label == "310" && value.ends_with(" normal")).unwrap().2;
    assert!(latitude.starts_with("-34.500"), "{latitude}");
    // A scene without a unit has one that navigates.
    done(&folder, &["fly", "rest", "-q", "--bus", "rest_words.csv"]);
    let rest = of("rest_words.csv");
    assert!(rest.len() > 1000 && rest.iter().all(|(_, _, value)| !value.ends_with("failure-warning")));
    let errors = rejected(&folder, &["fly", "rest", "-q", "--bus", "rest_words.csv", "--bus-delay", "300"]);
    assert!(errors.contains("--bus-delay 300: must be from 0 to 200"), "{errors}");
}

#[test]
fn the_labels_are_those_of_the_page_and_words_are_decoded() {
    let folder = folder("bus_labels");
    let page = read(project_file("docs/bus.md"));
    let labels = done(&folder, &["bus", "labels"]);
    assert!(page.contains(&labels), "docs/bus.md lacks the table that sins bus labels prints");
    let decoded = done(&folder, &["bus", "decode", "e40000c8", "72222509"]);
    assert_eq!(decoded, "310 latitude 45.0000 deg normal\n011 longitude -122.375 deg normal\n");
    assert_eq!(
        done(&folder, &["bus", "decode", "--reversed", "e4000013"]),
        "310 latitude 45.0000 deg normal\n"
    );
    let illegal = done(&folder, &["bus", "decode", "04f30021", "00bc000a", "84575021"]);
    let lines = "041 set latitude - deg illegal-value: digit[2] = 15: must be from 0 to 9\n\
                 012 ground speed - kt illegal-value: digit[2] = 15: must be from 0 to 9\n\
                 041 set latitude - deg illegal-value: digit[3] = 7: must be from 0 to 5\n";
    assert_eq!(illegal, lines);
    let reversed = rejected(&folder, &["bus", "decode", "--reversed", "e40000c8"]);
    assert!(reversed.contains("label bits not reversed? 310 would be latitude"), "{reversed}");
    let reasons = [
        ("e40000c9", "word = e40000c9: has an even parity"),
        ("e4000013", "label 023 is not in the table; label bits reversed? 310 would be latitude"),
        ("00000001", "word = 00000001: label 001 is not in the table\n"),
        ("bus", "hexadecimal"),
    ];
    for (word, reason) in reasons {
        let errors = rejected(&folder, &["bus", "decode", word]);
        assert!(errors.contains(reason), "{errors}");
    }
}
