//! `sins curve --quick`: what accuracy costs, from the command line to the files.

use std::collections::HashMap;
use std::path::Path;
use std::process::Command;

type Row = HashMap<String, String>;

fn rows(path: &Path) -> Vec<Row> {
    let mut reader = csv::Reader::from_path(path).unwrap();
    reader.deserialize().map(Result::unwrap).collect()
}

fn number(row: &Row, column: &str) -> f64 {
    row[column].parse().unwrap_or_else(|_| panic!("{column}: {row:?}"))
}

/// The row of `scheme` with two subsamples in `frame` at `rate_hz`.
fn find<'a>(rows: &'a [Row], scheme: &str, frame: &str, rate_hz: &str) -> &'a Row {
    let wanted = [("scheme", scheme), ("subsamples", "2"), ("frame", frame), ("rate_hz", rate_hz)];
    rows.iter().find(|row| wanted.iter().all(|(column, value)| row[*column] == *value)).unwrap()
}

#[test]
fn accuracy_and_its_cost_are_measured() {
    let out = Path::new(env!("CARGO_TARGET_TMPDIR")).join("curve");
    let _ = std::fs::remove_dir_all(&out);
    let counts = Path::new(env!("CARGO_TARGET_TMPDIR")).join("counts.csv");
    std::fs::write(
        &counts,
        "scheme,subsamples,updates_per_sample,frame,instructions_per_step\nexact,2,1,Earth-fixed,5060\n",
    )
    .unwrap();
    let log = Path::new(env!("CARGO_MANIFEST_DIR")).join("../c_examples/flights/airliner_cruise.csv");
    let output = Command::new(env!("CARGO_BIN_EXE_sins"))
        .args(["curve", "--quick", "--flight", "aerobatics", "--flight", "pole", "--instructions"])
        .arg(&counts)
        .arg("-o")
        .arg(&out)
        .arg(&log)
        .output()
        .unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));

    let all = rows(&out.join("curve.csv"));
    let of = |scene: &str| all.iter().filter(|row| row["scene"] == scene).cloned().collect::<Vec<Row>>();
    let (aerobatics, pole, airliner) = (of("aerobatics"), of("pole"), of("airliner_cruise"));
    assert_eq!((aerobatics.len(), pole.len()), (6 * 26, 6 * 26));
    // 50, 25 and 12.5 Hz.
    assert_eq!(airliner.len(), 3 * 26);

    // The paper's scheme errs by the first order of the rotation in a step, the default by the third.
    for rate in ["200", "400"] {
        let paper = number(find(&aerobatics, "paper", "geographic", rate), "position_m");
        let default = number(find(&aerobatics, "exact", "Earth-fixed", rate), "position_m");
        assert!(paper > 1000.0 * default, "{rate} Hz: {paper:e} {default:e}");
    }
    assert_eq!(find(&aerobatics, "exact", "Earth-fixed", "100")["instructions_per_step"], "5060");
    let singular = find(&pole, "paper", "geographic", "100");
    assert!(singular["status"].contains("latitude") && singular["position_m"].is_empty(), "{singular:?}");

    for scene in [&aerobatics, &pole, &airliner] {
        let measured: Vec<&Row> = scene.iter().filter(|row| row["status"].is_empty()).collect();
        let place = |row: &Row| (number(row, "cost_ns_per_s"), number(row, "position_m"));
        let mut front: Vec<_> =
            measured.iter().filter(|row| row["on_front"] == "1").map(|row| place(row)).collect();
        front.sort_by(|a, b| a.0.total_cmp(&b.0));
        // The columns are rounded.
        assert!(front.windows(2).all(|pair| pair[1].1 <= pair[0].1), "{front:?}");
        for (cost, error) in measured.iter().map(|row| place(row)) {
            let is_covered = front.iter().any(|(c, e)| *c <= cost + 1.0 && *e <= error * 1.001);
            assert!(is_covered, "{cost} {error} {front:?}");
        }
    }

    let scenes = rows(&out.join("scenes.csv"));
    for scene in &scenes {
        // Ten nanometres: the floor of what is told is then a micrometre.
        let known = number(scene, "reference_position_m");
        assert!(known > 0.0 && known < 1e-8, "{scene:?}");
        let sensors = ["navigation_grade_m", "tactical_grade_m"].map(|column| number(scene, column));
        // In rolls and 5 g the scatter of scale factors counts, which the source of the tactical grade does not state.
        assert!(sensors[0] > 0.01 && sensors[1] > sensors[0], "{scene:?}");
    }
    let table = std::fs::read_to_string(out.join("table.md")).unwrap();
    let (_, table) = table.split_once("\n\n").unwrap();
    assert_eq!(table.lines().count(), 2 + 3);
    assert!(String::from_utf8_lossy(&output.stdout).starts_with(table) && table.contains("100 m in 2 min"));
    for name in ["aerobatics", "pole", "airliner_cruise"] {
        assert!(std::fs::read_to_string(out.join(name).with_extension("svg")).unwrap().contains("<svg"));
    }
}

#[test]
fn a_bad_order_is_refused() {
    let run = |arguments: &[&str]| {
        let output = Command::new(env!("CARGO_BIN_EXE_sins")).arg("curve").args(arguments).output().unwrap();
        (output.status.code(), String::from_utf8_lossy(&output.stderr).into_owned())
    };
    let (code, errors) = run(&["--flight", "moon", "-o", "nowhere"]);
    assert!(code == Some(2) && errors.contains("moon"), "{errors}");
    let out = Path::new(env!("CARGO_TARGET_TMPDIR")).join("refused");
    let (code, errors) = run(&["-o", out.to_str().unwrap(), "missing.csv"]);
    assert!(code == Some(2) && errors.contains("missing.csv"), "{errors}");
}
