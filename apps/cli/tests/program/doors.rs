//! Every scene ends alike through every door, to the bit: the scenes of `c_examples`, the built-in ones, and random ones with unit, panel,
//! updates, failures, temperature and logs. The doors here are the interface in Rust, C and C++, the C host, `sins fly`, and run 0 of an
//! ensemble, flown alone, and side by side if there is no unit. Other hosts fly the same files to the same ends.txt: tests/hosts.sh.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::atomic::{AtomicU64, AtomicUsize, Ordering::Relaxed};

use crate::same_records::link;
use crate::scenes::{End, FlownScene, end_of, line, named_scenes, random_scene};
use crate::support::{folder, numbers, read, result, run};

/// Number of random scenes.
const RANDOM: u64 = if cfg!(feature = "long-tests") { 300 } else { 30 };
/// Longest time for which the examples are flown, and the built-in scenes [s].
const LONGEST_S: [f64; 2] = if cfg!(feature = "long-tests") { [2e4, 2e4] } else { [700.0, 60.0] };

/// The nine errors of the navigation.
fn errors(end: &End) -> Option<&[u64]> {
    end.as_ref().map(|words| &words[..9])
}

fn bits(numbers: impl IntoIterator<Item = f64>) -> End {
    Some(numbers.into_iter().map(f64::to_bits).collect())
}

/// Whether a program of exit code `code` ended early, which only an entry at the wrong moment explains.
fn has_stopped(code: i32, words: &str) -> bool {
    assert!(code == 0 || code == 1 && words.contains("panel"), "{code}: {words}");
    code != 0
}

/// By `sins fly`: the errors, then place, velocity and attitude of the navigation, or validity and state of the unit.
fn by_fly(folder: &Path, name: &str, has_unit: bool) -> End {
    let (scene, out) = (format!("{name}.toml"), format!("{name}_fly"));
    let (code, _, words) = run(folder, &["fly", &scene, "-q", "--force", "-o", &out, "--name", "run"]);
    if has_stopped(code, &words) {
        return None;
    }
    let (columns, rows) = numbers(&folder.join(format!("{name}_fly/run.csv")));
    let at = |name: &str| columns.iter().position(|column| column == name).unwrap();
    let [errors, navigation] = ["navigation_error_position_east_m", "navigation_latitude_rad"].map(at);
    let row = rows.last().unwrap();
    let mut end = row[errors..errors + 9].to_vec();
    if !has_unit {
        end.extend(&row[navigation..navigation + 9]);
    }
    bits(end)
}

/// The state of the unit at the end, by `sins fly`.
fn state_by_fly(folder: &Path, name: &str) -> String {
    let text = read(folder.join(format!("{name}_fly/run_unit.csv")));
    text.lines().last().unwrap().split(',').nth(1).unwrap().to_owned()
}

/// The errors by the C host.
fn by_host(folder: &Path, name: &str, host: &Path) -> End {
    let output = Command::new(host).arg(format!("{name}.toml")).current_dir(folder).output().unwrap();
    let (code, said, words) = result(&output);
    if has_stopped(code, &words) {
        return None;
    }
    let kinds = ["position m ", "velocity m/s ", "misalignment rad "];
    let rows = said.lines().filter(|line| kinds.iter().any(|kind| line.starts_with(kind)));
    bits(rows.map(|row| row.split_whitespace().rev().nth(1).unwrap().parse().unwrap()))
}

/// The errors of the first of `runs` runs; an error: what is not random has no ensemble.
fn by_ensemble(folder: &Path, name: &str, runs: &str) -> Result<End, ()> {
    let (scene, out) = (format!("{name}.toml"), format!("{name}_{runs}"));
    let order = ["ensemble", &scene, "-q", "--force", "--runs", runs, "-o", &out, "--name", "run"];
    let (code, _, words) = run(folder, &order);
    if code == 2 && words.contains("nothing is random") {
        return Err(());
    }
    if has_stopped(code, &words) {
        return Ok(None);
    }
    let text = read(folder.join(format!("{out}/run_ensemble_runs.csv")));
    let row = text.lines().nth(1).unwrap();
    Ok(bits(row.split(',').skip(2).take(9).map(|value| value.parse().unwrap())))
}

/// Writes the scenes, and ends.txt with their ends. The folder is complete when it has its name.
fn written(scenes: &[FlownScene], ends: &str) -> PathBuf {
    let folder = folder("writing");
    scenes.iter().for_each(|scene| scene.write(&folder));
    std::fs::write(folder.join("ends.txt"), ends).unwrap();
    let complete = folder.with_file_name("complete");
    let _ = std::fs::remove_dir_all(&complete);
    std::fs::rename(&folder, &complete).unwrap();
    complete
}

#[test]
fn every_scene_ends_alike_through_every_door() {
    let host = link("doors_harness", "c_examples/harness.c");
    let mut scenes = named_scenes(LONGEST_S);
    scenes.extend((1000..1000 + RANDOM).map(|seed| random_scene(seed, true)));
    let ends: Vec<End> = scenes.iter().map(|scene| end_of(&mut scene.play())).collect();
    let text: String = scenes.iter().zip(&ends).map(|(scene, end)| line(&scene.name, end)).collect();
    let folder = written(&scenes, &text);
    for (name, source) in
        [("door_c", "apps/cli/tests/program/door.c"), ("door_cpp", "apps/cli/tests/program/door.cpp")]
    {
        let names = scenes.iter().map(|scene| &scene.name);
        let output = Command::new(link(name, source)).arg(&folder).args(names).output().unwrap();
        let (code, found, words) = result(&output);
        assert_eq!(code, 0, "{words}");
        let differs = found.lines().zip(text.lines()).find(|(found, expected)| found != expected);
        assert!(found == text, "{source}: {differs:?}");
    }

    // The longest scenes are the first ones.
    let (next, lanes) = (AtomicUsize::new(0), AtomicU64::new(0));
    std::thread::scope(|scope| {
        for _ in 0..2 {
            scope.spawn(|| {
                while let Some(scene) = scenes.get(next.fetch_add(1, Relaxed)) {
                    lanes.fetch_add(u64::from(by_programs(&folder, scene, &host)), Relaxed);
                }
            });
        }
    });
    let count = |is: fn(&FlownScene) -> bool| scenes.iter().filter(|scene| is(scene)).count() as u64;
    let (units, logs) = (count(has_unit), count(|scene| scene.log.is_some()));
    let (stopped, lanes) = (ends.iter().filter(|end| end.is_none()).count() as u64, lanes.into_inner());
    println!("{} scenes: {units} units, {logs} logs, {stopped} stopped, {lanes} side by side", scenes.len());
    assert!(units.min(logs).min(lanes) > RANDOM / 5 && stopped < RANDOM / 3);
}

fn has_unit(scene: &FlownScene) -> bool {
    scene.scene().unit.start.is_some()
}

/// Flies a scene by the programs. Returns whether it was flown side by side with other runs.
fn by_programs(folder: &Path, scene: &FlownScene, host: &Path) -> bool {
    let (name, has_unit) = (scene.name.as_str(), has_unit(scene));
    let mut play = scene.play();
    let end = end_of(&mut play);
    let state = play.unit().map(|unit| unit.status().state.word());
    let found = by_fly(folder, name, has_unit);
    let expected = end.as_ref().map(|words| &words[..if has_unit { 9 } else { 18 }]);
    assert_eq!(found.as_deref(), expected, "sins fly, {name}");
    if let (Some(state), Some(_)) = (state, &end) {
        assert_eq!(state_by_fly(folder, name), state, "sins fly, {name}");
    }
    assert_eq!(by_host(folder, name, host).as_deref(), errors(&end), "C host, {name}");
    assert_eq!(by_ensemble(folder, name, "1").unwrap().as_deref(), errors(&end), "1 run, {name}");
    let Ok(found) = by_ensemble(folder, name, "3") else { return false };
    // Other runs may be ended where the first is not.
    assert!(found.is_none() && has_unit || found.as_deref() == errors(&end), "3 runs, {name}");
    !has_unit
}
