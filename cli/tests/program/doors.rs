//! Random scenes with unit, panel, updates, failures, temperature and logs end with the same errors, to the bit, through every door:
//! `sins fly`, the C host, run 0 of an ensemble flown alone, and side by side if there is no unit. A scene that an entry at the wrong
//! moment ends is ended by each.

use std::path::Path;
use std::process::Command;

use crate::random_scenes::random_scene;
use crate::same_records::link;
use crate::support::{folder, numbers, read, run};

/// Number of scenes.
const SCENES: u64 = if cfg!(feature = "long-tests") { 300 } else { 60 };

/// The nine errors of the navigation at the end by `sins fly`; `None`: it ended before.
fn by_fly(folder: &Path) -> Option<Vec<f64>> {
    let (code, _, errors) = run(folder, &["fly", "scene.toml", "-q", "--force"]);
    if code != 0 {
        assert!(code == 1 && errors.contains("panel"), "{code}: {errors}");
        return None;
    }
    let (columns, rows) = numbers(&folder.join("sins_out/scene.csv"));
    let first = columns.iter().position(|name| name == "navigation_error_position_east_m").unwrap();
    Some(rows.last().unwrap()[first..first + 9].to_vec())
}

/// The same by the C host.
fn by_host(folder: &Path, host: &Path) -> Option<Vec<f64>> {
    let output = Command::new(host).arg("scene.toml").current_dir(folder).output().unwrap();
    let errors = String::from_utf8_lossy(&output.stderr);
    if !output.status.success() {
        assert!(errors.contains("sins_play_run: at ") && errors.contains("panel"), "{errors}");
        return None;
    }
    let text = String::from_utf8(output.stdout).unwrap();
    let kinds = ["position m ", "velocity m/s ", "misalignment rad "];
    let rows = text.lines().filter(|line| kinds.iter().any(|kind| line.starts_with(kind)));
    Some(rows.map(|row| row.split_whitespace().rev().nth(1).unwrap().parse().unwrap()).collect())
}

/// The same of the first of `runs` runs.
fn by_ensemble(folder: &Path, runs: &str) -> Option<Vec<f64>> {
    let (code, _, errors) = run(folder, &["ensemble", "scene.toml", "-q", "--force", "--runs", runs]);
    if code != 0 {
        assert!(code == 1 && errors.contains("panel"), "{code}: {errors}");
        return None;
    }
    let text = read(folder.join("sins_out/scene_ensemble_runs.csv"));
    let row = text.lines().nth(1).unwrap();
    Some(row.split(',').skip(2).take(9).map(|value| value.parse().unwrap()).collect())
}

#[test]
fn random_scenes_end_alike_through_every_door() {
    let host = link("doors_harness", "c_examples/harness.c");
    let (mut units, mut logs, mut stopped) = (0, 0, 0);
    for seed in 1000..1000 + SCENES {
        let folder = folder(&format!("scene_{seed}"));
        let scene = random_scene(seed, true);
        std::fs::write(folder.join("scene.toml"), &scene.text).unwrap();
        if let Some(log) = &scene.log {
            std::fs::write(folder.join("random.csv"), log).unwrap();
        }
        let end = by_fly(&folder);
        let bits =
            |end: Option<Vec<f64>>| end.map(|end| end.into_iter().map(f64::to_bits).collect::<Vec<_>>());
        let expected = bits(end);
        assert_eq!(bits(by_host(&folder, &host)), expected, "C host, {seed}:\n{}", scene.text);
        for runs in ["1", "3"] {
            // Other runs may be ended where the first is not.
            let found = bits(by_ensemble(&folder, runs));
            assert!(
                found == expected || runs == "3" && found.is_none(),
                "{runs} runs, {seed}:\n{}",
                scene.text
            );
        }
        units += u32::from(scene.text.contains("[unit]"));
        logs += u32::from(scene.log.is_some());
        stopped += u32::from(expected.is_none());
    }
    println!("{SCENES} scenes: {units} units, {logs} logs, {stopped} stopped");
    assert!(u64::from(units.min(logs)) > SCENES / 5 && u64::from(stopped) < SCENES / 4);
}
