//! `sins curve --quick`: what accuracy costs, from the command line to the files.

use crate::support::{Row, folder, number, project_file, read, rejected, rows, run};

/// The row of `scheme` with two subsamples in `frame` at `rate_hz`.
fn find<'a>(rows: &'a [Row], scheme: &str, frame: &str, rate_hz: &str) -> &'a Row {
    let wanted = [("scheme", scheme), ("subsamples", "2"), ("frame", frame), ("rate_hz", rate_hz)];
    rows.iter().find(|row| wanted.iter().all(|(column, value)| row[*column] == *value)).unwrap()
}

#[test]
fn accuracy_and_its_cost_are_measured() {
    let folder = folder("curve");
    std::fs::write(
        folder.join("counts.csv"),
        "scheme,subsamples,updates_per_sample,frame,instructions_per_step\nexact,2,1,Earth-fixed,5060\n",
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
    }
}

#[test]
fn a_bad_order_is_rejected() {
    let folder = folder("bad");
    assert!(rejected(&folder, &["curve", "--flight", "moon"]).contains("moon"));
    assert!(rejected(&folder, &["curve", "missing.csv"]).contains("missing.csv"));
}
