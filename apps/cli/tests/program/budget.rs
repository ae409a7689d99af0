//! `sins budget`: which effects matter, from the command line to the files.

use crate::support::{Row, folder, number, project_file, read, rejected, rows, run};

#[test]
fn the_patrol_and_a_log_have_their_budgets() {
    let folder = folder("budgets");
    let log = project_file("c_examples/flights/airliner_cruise.csv");
    let limits = ["--position", "2", "--attitude", "10"];
    let scenes =
        ["budget", "--hours", "0.05", "--runs", "8", "simulation2", log.to_str().unwrap(), "-o", "out"];
    let (code, said, errors) = run(&folder, &[&scenes[..], &limits].concat());
    assert_eq!(code, 0, "{errors}");
    let out = folder.join("out");
    let all = rows(&out.join("budget.csv"));
    let of = |scene: &str| all.iter().filter(|row| row["scene"] == scene).collect::<Vec<&Row>>();
    let (patrol, airliner) = (of("simulation2"), of("airliner_cruise"));
    let names = |rows: &[&Row]| rows.iter().map(|row| row["effect"].clone()).collect::<Vec<String>>();
    // Effects: the paper's two errors of two sensors, and the five errors that a navigation grade states. The four other rows are
    // no effects.
    assert_eq!((patrol.len(), airliner.len()), (4 + 4, 5 + 4));
    for rows in [&patrol, &airliner] {
        let count = rows.len();
        assert_eq!(
            names(&rows[count - 4..]),
            ["mechanization", "not their sum", "root sum of squares", "all together"]
        );
        let sizes: Vec<f64> = rows[..count - 4].iter().map(|row| number(row, "position_m")).collect();
        // The error of the mechanization is smaller than the error of any sensor. All errors together are more than half of the
        // largest.
        assert!(sizes.iter().all(|size| *size > 100.0 * number(rows[count - 4], "position_m")), "{sizes:?}");
        assert!(number(rows[count - 1], "position_m") > 0.5 * sizes[0]);
        let sum = sizes.iter().map(|size| size * size).sum::<f64>().sqrt();
        assert!((number(rows[count - 2], "position_m") / sum - 1.0).abs() < 1e-5);
        assert!(number(rows[count - 3], "position_m") < 1e-3 * number(rows[count - 1], "position_m"));
    }
    // Three minutes of a bias b of 1e-5 g along three axes: the error is at most b t^2/2 of three axes. The patrol has turned by
    // less than 1.5 rad by then, so the error is at least a tenth of b t^2/2 of two axes.
    let bias = patrol.iter().find(|row| row["key"] == "accelerometer.bias_micro_g").unwrap();
    let along_one = 0.5 * 9.80665e-5 * 180.0f64.powi(2);
    let axes = number(bias, "end_position_m") / along_one;
    assert!((0.1 * 2f64.sqrt()..3f64.sqrt()).contains(&axes) && bias["kind"] == "deterministic", "{axes}");
    // A row that is no effect cannot be left out, and neither can the largest effect.
    assert!(patrol[4..].iter().chain(&airliner[5..]).all(|row| row["can_be_left_out"] == "0"));
    assert_eq!(patrol[0]["can_be_left_out"], "0");
    assert!(airliner.iter().any(|row| row["can_be_left_out"] == "1"));
    assert_eq!(airliner[0]["can_be_left_out"], "0");

    let table = read(out.join("table.md"));
    let (printed, _) = said.split_once("\nwritten\n").unwrap();
    assert!(table.ends_with(printed) && table.contains("can be left out"));
    for name in ["simulation2.svg", "airliner_cruise.svg", "budget.html"] {
        assert!(read(out.join(name)).contains("gyro angle random walk"), "{name}");
    }
}

#[test]
fn a_bad_order_is_rejected() {
    let folder = folder("bad");
    assert!(rejected(&folder, &["budget", "--preset", "best"]).contains("best"));
    assert!(rejected(&folder, &["budget", "missing.csv"]).contains("missing.csv"));
}
