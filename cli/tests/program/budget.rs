//! `sins budget`: which effects matter, from the command line to the files.

use std::collections::HashMap;
use std::path::Path;
use std::process::Command;

type Row = HashMap<String, String>;

fn number(row: &Row, column: &str) -> f64 {
    row[column].parse().unwrap_or_else(|_| panic!("{column}: {row:?}"))
}

#[test]
fn the_patrol_and_a_log_have_their_budgets() {
    let out = Path::new(env!("CARGO_TARGET_TMPDIR")).join("budget_report");
    let _ = std::fs::remove_dir_all(&out);
    let log = Path::new(env!("CARGO_MANIFEST_DIR")).join("../c_examples/flights/airliner_cruise.csv");
    let output = Command::new(env!("CARGO_BIN_EXE_sins"))
        .args([
            "budget",
            "--hours",
            "0.05",
            "--runs",
            "8",
            "simulation2",
            "--position",
            "2",
            "--attitude",
            "10",
        ])
        .arg(&log)
        .arg("-o")
        .arg(&out)
        .output()
        .unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));

    let mut reader = csv::Reader::from_path(out.join("budget.csv")).unwrap();
    let all: Vec<Row> = reader.deserialize().map(Result::unwrap).collect();
    let of = |scene: &str| all.iter().filter(|row| row["scene"] == scene).collect::<Vec<&Row>>();
    let (patrol, airliner) = (of("simulation2"), of("airliner_cruise"));
    let names = |rows: &[&Row]| rows.iter().map(|row| row["effect"].clone()).collect::<Vec<String>>();
    // The paper's two errors of two sensors; the five that a navigation grade states.
    assert_eq!((patrol.len(), airliner.len()), (4 + 3, 5 + 3));
    for rows in [&patrol, &airliner] {
        let count = rows.len();
        assert_eq!(names(&rows[count - 3..]), ["mechanization", "not their sum", "all together"]);
        let sizes: Vec<f64> = rows[..count - 3].iter().map(|row| number(row, "position_m")).collect();
        // The mechanization errs less than any sensor, and all together more than half of the largest.
        assert!(sizes.iter().all(|size| *size > 100.0 * number(rows[count - 3], "position_m")), "{sizes:?}");
        assert!(number(rows[count - 1], "position_m") > 0.5 * sizes[0]);
        assert!(number(rows[count - 2], "position_m") < 1e-3 * number(rows[count - 1], "position_m"));
    }
    // Three minutes of 1e-5 g along three axes: no more than b t^2/2 of them all, and as the patrol has turned by less than
    // 1.5 rad by then, no less than a tenth of two.
    let bias = patrol.iter().find(|row| row["field"] == "accel.bias_m_s2").unwrap();
    let along_one = 0.5 * 9.80665e-5 * 180.0f64.powi(2);
    let axes = number(bias, "end_position_m") / along_one;
    assert!((0.1 * 2f64.sqrt()..3f64.sqrt()).contains(&axes) && bias["kind"] == "deterministic", "{axes}");
    // What is no effect cannot be left out, nor the largest of them.
    assert!(patrol[4..].iter().chain(&airliner[5..]).all(|row| row["can_be_left_out"] == "0"));
    assert_eq!(patrol[0]["can_be_left_out"], "0");
    assert!(airliner.iter().any(|row| row["can_be_left_out"] == "1"));
    assert_eq!(airliner[0]["can_be_left_out"], "0");

    let table = std::fs::read_to_string(out.join("table.md")).unwrap();
    assert!(table.ends_with(&*String::from_utf8_lossy(&output.stdout)) && table.contains("can be left out"));
    for name in ["simulation2.svg", "airliner_cruise.svg", "budget.html"] {
        assert!(
            std::fs::read_to_string(out.join(name)).unwrap().contains("gyro angle random walk"),
            "{name}"
        );
    }
}

#[test]
fn a_bad_order_is_refused() {
    let run = |arguments: &[&str]| {
        let output = Command::new(env!("CARGO_BIN_EXE_sins")).arg("budget").args(arguments).output().unwrap();
        (output.status.code(), String::from_utf8_lossy(&output.stderr).into_owned())
    };
    let (code, errors) = run(&["--preset", "best", "-o", "nowhere"]);
    assert!(code == Some(2) && errors.contains("best"), "{errors}");
    let out = Path::new(env!("CARGO_TARGET_TMPDIR")).join("budget_refused");
    let (code, errors) = run(&["-o", out.to_str().unwrap(), "missing.csv"]);
    assert!(code == Some(2) && errors.contains("missing.csv"), "{errors}");
}
