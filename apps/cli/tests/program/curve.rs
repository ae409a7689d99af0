//! `sins curve --quick`: what accuracy costs, from the command line to the files.

use crate::support::{Row, folder, number, project_file, read, rejected, rows, run};

/// The row of `scheme` with two subsamples in `frame` at `rate_hz`.
fn find<'a>(rows: &'a [Row], scheme: &str, frame: &str, rate_hz: &str) -> &'a Row {
    let wanted = [("scheme", scheme), ("subsamples", "2"), ("frame", frame), ("rate_hz", rate_hz)];
    rows.iter().find(|row| wanted.iter().all(|(column, value)| row[*column] == *value)).unwrap()
}

/// What `--quick` says of an hour of straight legs and turns holds for the whole hour: the configuration that it names for an error of 1 m
/// is flown whole. The coarse one that would do in the first two minutes has a hundred times the error in the hour, and is said to have.
#[test]
fn a_quick_survey_of_a_long_scene_holds_for_the_whole_of_it() {
    let folder = folder("quick");
    let (code, said, errors) = run(&folder, &["curve", "racetrack", "--quick", "-o", "out"]);
    assert_eq!(code, 0, "{errors}");
    assert!(errors.contains("; judged by its 4 hardest pieces of 60 s, at "), "{errors}");
    assert!(said.contains(" (predicted from its hardest minutes) | 60 min |"), "{said}");
    let all = rows(&folder.join("out/curve.csv"));
    let whole_m = |row: &Row| {
        let set = |key: &str, value: &str| ["--set".to_owned(), format!("{key}={value}")];
        let mut order: Vec<String> = ["fly", "racetrack", "-q"].map(str::to_owned).into();
        for key in ["scheme", "subsamples", "updates_per_sample", "frame"] {
            order.extend(set(&format!("options.{key}"), &row[key]));
        }
        order.extend(set("flight.rate_hz", &row["rate_hz"]));
        let (code, _, errors) = run(&folder, &order.iter().map(String::as_str).collect::<Vec<_>>());
        assert_eq!(code, 0, "{errors}");
        let summary = rows(&folder.join("sins_out/racetrack_summary.csv"));
        number(summary.iter().find(|figure| figure["key"] == "max_position_m").unwrap(), "value")
    };
    let cheapest = all
        .iter()
        .filter(|row| row["on_front"] == "1" && number(row, "position_m") <= 1.0)
        .min_by(|a, b| number(a, "cost_ns_per_s").total_cmp(&number(b, "cost_ns_per_s")))
        .unwrap();
    assert!(whole_m(cheapest) <= 1.0, "{cheapest:?}");
    let coarse = find(&all, "paper", "geographic", "10");
    let (said_m, flown_m) = (number(coarse, "position_m"), whole_m(coarse));
    assert!(flown_m > 100.0 && said_m >= flown_m, "{said_m} {flown_m}");
}

#[test]
fn accuracy_and_its_cost_are_measured() {
    let folder = folder("curve");
    std::fs::write(
        folder.join("counts.csv"),
        "scheme,subsamples,updates_per_sample,frame,instructions_per_step\nexact,2,1,earth,5060\n",
    )
    .unwrap();
    let log = project_file("c_examples/flights/airliner_cruise.csv");
    let flights = ["curve", "--quick", "--flight", "aerobatics", "--flight", "pole"];
    let more = ["--instructions", "counts.csv", "-o", "out", log.to_str().unwrap()];
    let (code, said, errors) = run(&folder, &[&flights[..], &more].concat());
    assert_eq!(code, 0, "{errors}");

    let out = folder.join("out");
    let all = rows(&out.join("curve.csv"));
    let of = |scene: &str| all.iter().filter(|row| row["scene"] == scene).cloned().collect::<Vec<Row>>();
    let (aerobatics, pole, airliner) = (of("aerobatics"), of("pole"), of("airliner_cruise"));
    assert_eq!((aerobatics.len(), pole.len()), (6 * 26, 6 * 26));
    // The log is flown at 50, 25 and 12.5 Hz.
    assert_eq!(airliner.len(), 3 * 26);

    // The error of the paper's scheme is of first order in the rotation of a step, the error of the default of third order.
    for rate in ["200", "400"] {
        let paper = number(find(&aerobatics, "paper", "geographic", rate), "position_m");
        let default = number(find(&aerobatics, "exact", "earth", rate), "position_m");
        assert!(paper > 1000.0 * default, "{rate} Hz: {paper:e} {default:e}");
    }
    assert_eq!(find(&aerobatics, "exact", "earth", "100")["instructions_per_step"], "5060");
    let singular = find(&pole, "paper", "geographic", "100");
    assert!(singular["status"].contains("latitude") && singular["position_m"].is_empty(), "{singular:?}");

    for scene in [&aerobatics, &pole, &airliner] {
        let measured: Vec<&Row> = scene.iter().filter(|row| row["status"].is_empty()).collect();
        let place = |row: &Row| (number(row, "cost_ns_per_s"), number(row, "position_m"));
        let mut front: Vec<_> =
            measured.iter().filter(|row| row["on_front"] == "1").map(|row| place(row)).collect();
        front.sort_by(|a, b| a.0.total_cmp(&b.0));
        // The tolerances are for the rounding of the columns.
        assert!(front.windows(2).all(|pair| pair[1].1 <= pair[0].1), "{front:?}");
        for (cost, error) in measured.iter().map(|row| place(row)) {
            let is_covered = front.iter().any(|(c, e)| *c <= cost + 1.0 && *e <= error * 1.001);
            assert!(is_covered, "{cost} {error} {front:?}");
        }
    }

    let scenes = rows(&out.join("scenes.csv"));
    for scene in &scenes {
        // With an uncertainty of ten nanometres, the floor of the reported errors is a micrometre.
        let known = number(scene, "reference_position_m");
        assert!(known > 0.0 && known < 1e-8, "{scene:?}");
        let sensors = ["navigation_grade_m", "tactical_grade_m"].map(|column| number(scene, column));
        // In rolls and at 5 g the scatter of scale factors matters, which the source of the tactical grade does not state.
        assert!(sensors[0] > 0.01 && sensors[1] > sensors[0], "{scene:?}");
    }
    let table = read(out.join("table.md"));
    let (_, table) = table.split_once("\n\n").unwrap();
    assert_eq!(table.lines().count(), 2 + 3);
    assert!(said.starts_with(table) && table.contains("| scene | flown for | 100 m |"));
    for name in ["aerobatics", "pole", "airliner_cruise"] {
        assert!(read(out.join(name).with_extension("svg")).contains("<svg"));
        assert!(read(out.join("curve.html")).contains(&format!("<h3>{name}: ")), "{name}");
    }
}

/// A sample of a coning motion at a fixed place, 100 a second: `TIME_S,LATITUDE_DEG,...` of a log.
fn coning(k: usize) -> String {
    let t = k as f64 / 100.0;
    let (sin, cos) = (4.0 * std::f64::consts::PI * t).sin_cos();
    format!("{t},40,116,0,{},{},{}\n", 3.0 * sin, 3.0 * cos, (60.0 * t) % 360.0)
}

/// The configuration of a cell, such as "exact 2 × 2 @ 12.5 Hz, 14 µs": scheme, subsamples, updates, rate.
fn configuration(cell: &str) -> (String, String, String, f64) {
    let (algorithm, rest) = cell.trim().split_once(" @ ").unwrap();
    let rate_hz = rest.split_once(" Hz").unwrap().0.parse().unwrap();
    let (algorithm, updates) = algorithm.split_once(" × ").unwrap_or((algorithm, "1"));
    let (scheme, subsamples) = algorithm.split_once(' ').unwrap();
    (scheme.to_owned(), subsamples.to_owned(), updates.to_owned(), rate_hz)
}

/// Each configuration that the table names for a limit is flown over the whole log, at its rate: the position error, which grows faster
/// than in proportion to time in coning, stays within the limit.
#[test]
fn the_table_of_a_log_holds_over_the_log() {
    let folder = folder("coning");
    let header = "time_s,latitude_deg,longitude_deg,height_m,roll_deg,pitch_deg,heading_deg\n";
    let log = |step: usize| header.to_owned() + &(0..=6000).step_by(step).map(coning).collect::<String>();
    std::fs::write(folder.join("coning.csv"), log(1)).unwrap();
    let (code, said, errors) = run(&folder, &["curve", "coning.csv", "-o", "out"]);
    assert_eq!(code, 0, "{errors}");
    let row = said.lines().find(|line| line.starts_with("| coning")).unwrap();
    let cells: Vec<&str> = row.split('|').collect();
    assert_eq!(cells[2].trim(), "60 s");
    let mut distinct = std::collections::BTreeSet::new();
    for (cell, limit_m) in cells[3..7].iter().zip([100.0, 1.0, 0.01, 0.001]) {
        let (scheme, subsamples, updates, rate_hz) = configuration(cell);
        std::fs::write(folder.join("thin.csv"), log((100.0 / rate_hz).round() as usize)).unwrap();
        let settings = [
            format!("options.scheme={scheme}"),
            format!("options.subsamples={subsamples}"),
            format!("options.updates_per_sample={updates}"),
            format!("output.every_s={}", 1.0 / rate_hz),
        ];
        let mut arguments = vec!["fly", "thin.csv", "-o", "flown", "--force"];
        settings.iter().for_each(|setting| arguments.extend(["--set", setting]));
        assert_eq!(run(&folder, &arguments).0, 0);
        let axes = ["east", "north", "up"].map(|axis| format!("navigation_error_position_{axis}_m"));
        let error_m = |row: &Row| axes.iter().map(|axis| number(row, axis).powi(2)).sum::<f64>().sqrt();
        let records = rows(&folder.join("flown/thin.csv"));
        assert!(number(records.last().unwrap(), "time_s") > 59.9);
        let worst = records.iter().map(error_m).fold(0.0, f64::max);
        assert!(worst <= limit_m, "{cell}: {worst} m of {limit_m} m");
        distinct.insert((scheme, subsamples, updates));
    }
    assert!(distinct.len() >= 3, "{row}");
}

#[test]
fn a_bad_order_is_rejected() {
    let folder = folder("bad");
    assert!(rejected(&folder, &["curve", "--flight", "moon"]).contains("moon"));
    assert!(rejected(&folder, &["curve", "missing.csv"]).contains("missing.csv"));
}
