//! Files of the flight data recorder of X-Plane (FDR): read, said what was assumed, and flown.

use std::path::Path;

use crate::judged::circle;
use crate::support::{done, folder, rejected, run};

/// The circle as X-Plane writes it, with times as `time` writes them.
fn fdr(time: fn(f64) -> String) -> String {
    let rows: String = circle(2, 60)
        .into_iter()
        .map(|[t, latitude, longitude, height, roll, pitch, heading, ..]| {
            let feet = height / 0.3048;
            format!(
                "{}, {longitude:.9}, {latitude:.9}, {feet:.3}, {heading:.4}, {pitch:.4}, {roll:.4}, 29.92\n",
                time(t)
            )
        })
        .collect();
    format!(
        "A\n4\n\nCOMM, made up\nACFT, Aircraft/x.acf\nTAIL, N1\nDATE, 05/01/2026\nPRES,29.92\nDISA,0\nWIND,230,16\n\
         DREF, sim/cockpit2/gauges/actuators/barometer_setting_in_hg_pilot 1.0\n\nCOMM, degrees\n{rows}"
    )
}

fn of_day(t: f64) -> String {
    let t = (t + 86_370.0) % 86_400.0;
    format!("{:02}:{:02}:{:04.1}", t as u32 / 3600, t as u32 / 60 % 60, t % 60.0)
}

fn smoothed(folder: &Path, more: &[&str]) -> Vec<Vec<f64>> {
    let (code, _, errors) =
        run(folder, &[&["log", "flight.fdr", "--smooth", "-o", "truth.csv", "--force"], more].concat());
    assert_eq!(code, 0, "{errors}");
    let text = std::fs::read_to_string(folder.join("truth.csv")).unwrap();
    let row = |line: &str| line.split(',').map(|field| field.parse().unwrap()).collect();
    text.lines().skip(2).map(row).collect()
}

#[test]
fn a_file_of_x_plane_flies() {
    let folder = folder("flies");
    let text = fdr(of_day);
    for text in [text.clone(), text.replace('\n', "\r\n"), text.replace('\n', "\r"), fdr(|t| format!("{t}"))]
    {
        std::fs::write(folder.join("flight.fdr"), text).unwrap();
        let (code, _, errors) = run(&folder, &["fly", "-q", "flight.fdr", "--preset", "navigation"]);
        let note = "flight.fdr: note: FDR record, 121 rows 0.5 s apart: headings are magnetic, with the variation 0 unless \
            log.variation sets it; altitudes are above the sea, with the geoid 0 m unless log.geoid sets it\n";
        assert!(code == 0 && errors.contains(note), "{errors}");
        // The path is that of the circle, and its attitude that of the file: a roll of 90 degrees or another order of columns would differ.
        let truth = smoothed(&folder, &[]);
        let (own, read) = (circle(2, 60), |row: &Vec<f64>| [row[1], row[2], row[3], row[7], row[8], row[9]]);
        // A path may begin some rows late; it ends with the last.
        let middle_s = truth[truth.len() - 1][0] - 30.0;
        let middle = truth.iter().min_by(|a, b| (a[0] - middle_s).abs().total_cmp(&(b[0] - middle_s).abs()));
        let [latitude, longitude, height, roll, pitch, heading] = read(middle.unwrap());
        let expected = own[60];
        assert!(
            (latitude - expected[1]).abs() < 1e-6 && (longitude - expected[2]).abs() < 1e-6,
            "{middle:?}"
        );
        assert!((height - expected[3]).abs() < 0.1, "{middle:?}");
        assert!(
            (roll - expected[4]).abs() < 0.1 && (pitch - expected[5]).abs() < 0.1,
            "{middle:?}, not {expected:?}"
        );
        let turn = (heading - expected[6] + 540.0).rem_euclid(360.0) - 180.0;
        assert!(turn.abs() < 0.5, "{middle:?}, not {expected:?}");
    }
    let heading = |rows: &[Vec<f64>]| rows[rows.len() / 2][9];
    let magnetic = heading(&smoothed(&folder, &[]));
    std::fs::write(folder.join("columns.toml"), "[log]\nvariation = 4.5\n").unwrap();
    let turned = heading(&smoothed(&folder, &["--columns", "columns.toml"])) - magnetic;
    assert!(((turned - 4.5 + 540.0).rem_euclid(360.0) - 180.0).abs() < 1e-6, "{turned}");
    // What the file is decides, not its name.
    std::fs::copy(folder.join("flight.fdr"), folder.join("flight.txt")).unwrap();
    assert!(done(&folder, &["log", "flight.txt"]).contains("121 rows over 60 s, 2 Hz"));
}

#[test]
fn broken_files_of_x_plane_are_rejected() {
    let folder = folder("broken");
    let text = fdr(of_day);
    let first = text.lines().position(|line| line.starts_with("23:59")).unwrap();
    let line = first + 1;
    let row = text.lines().nth(first).unwrap();
    let cells: Vec<&str> = row.split(", ").collect();
    for (from, to, expected) in [
        (
            "A\n4\n",
            "A\n3\n",
            "flight.fdr:2: FDR version 3: expected version 4, whose rows are time".to_owned(),
        ),
        (
            cells[0],
            "23:61:00",
            format!("flight.fdr:{line}: zulu time: expected hh:mm:ss, found \"23:61:00\""),
        ),
        (cells[1], "x", format!("flight.fdr:{line}: longitude: expected a finite number, found \"x\"")),
        (row, &cells[..6].join(","), format!("flight.fdr:{line}: the line ends before the roll")),
        (cells[2], "95", format!("flight.fdr:{line}: latitude_deg = 95: must be from -90 to 90")),
    ] {
        std::fs::write(folder.join("flight.fdr"), text.replacen(from, to, 1)).unwrap();
        let said = rejected(&folder, &["fly", "flight.fdr"]);
        assert!(said.contains(&expected), "{said}, not {expected}");
    }
    std::fs::write(folder.join("flight.fdr"), "A\n4\nTAIL, N1\n").unwrap();
    assert!(rejected(&folder, &["fly", "flight.fdr"]).contains("flight.fdr: no rows behind the keywords"));
}
