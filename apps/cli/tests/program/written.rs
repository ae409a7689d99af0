//! What a command says at its end: each file that it has written, with its size, and the next step.

use std::collections::BTreeSet;
use std::path::Path;

use crate::support::{done, folder, names, project_file, run};

/// The files below `folder`, with `/`.
fn files(folder: &Path) -> BTreeSet<String> {
    let mut all = BTreeSet::new();
    for name in names(folder) {
        let path = folder.join(&name);
        match path.is_dir() {
            true => all.extend(files(&path).into_iter().map(|below| format!("{name}/{below}"))),
            false => _ = all.insert(name),
        }
    }
    all
}

#[test]
fn every_file_is_named_with_its_size_and_then_the_next_step() {
    let folder = folder("list");
    std::fs::copy(project_file("c_examples/scenes/day.toml"), folder.join("day.toml")).unwrap();
    let budget =
        ["budget", "simulation2", "--hours", "0.02", "--runs", "8", "--position", "2", "-o", "budget"];
    let ensemble = [
        "ensemble",
        "patrol",
        "--preset",
        "navigation",
        "--runs",
        "2",
        "--hours",
        "0.02",
        "--meets",
        "airliner",
    ];
    let fly = ["fly", "day.toml", "--hours", "0.02", "--imu", "imu.csv", "--bus", "words.csv"];
    let rest = ["fly", "rest", "--preset", "tactical", "--hours", "0.1", "--imu", "rest_imu.csv"];
    let allan = ["allan", "sins_out/rest_imu.csv", "--csv", "points.csv", "--write", "noise.toml"];
    for (order, next) in [
        (&fly[..], "`sins report sins_out/day.csv` draws the flight"),
        (&rest, "`sins report sins_out/rest.csv` draws the flight"),
        (&["report", "sins_out/day.csv", "--picture", "day.svg"], "open sins_out/report.html in a browser"),
        (&allan, "`sins fly noise.toml --imu IMU.csv` makes a record that can be compared"),
        (&budget, "open budget/budget.html in a browser"),
        (&ensemble, "open sins_out/patrol_ensemble.html in a browser"),
        (
            &["curve", "--flight", "rest", "--quick", "-o", "curve"],
            "`sins recommend SCENE --position METRES` chooses the options of a scene",
        ),
    ] {
        let before = files(&folder);
        let (code, said, errors) = run(&folder, order);
        assert!([0, 4].contains(&code), "{order:?}: {errors}");
        let (_, list) = said.split_once("\nwritten\n").unwrap_or_else(|| panic!("{order:?}: {said}"));
        let (list, last) = list.split_once("next: ").unwrap();
        assert_eq!(last.replace('\\', "/"), format!("{next}\n"), "{order:?}");
        let mut named = BTreeSet::new();
        for line in list.lines() {
            let words: Vec<&str> = line.split_whitespace().collect();
            let [path, size, unit] = words[..] else { panic!("{line}") };
            let unit = match unit {
                "B" => 1.0,
                "kB" => 1e3,
                _ => 1e6,
            };
            let found = std::fs::metadata(folder.join(path)).unwrap().len() as f64;
            assert!((size.parse::<f64>().unwrap() * unit - found).abs() <= 0.05 * unit, "{line}: {found}");
            named.insert(path.replace('\\', "/"));
        }
        let new: BTreeSet<String> = files(&folder).difference(&before).cloned().collect();
        assert_eq!(named, new, "{order:?}");
    }
    let said = done(&folder, &["recommend", "rest", "--position", "1"]);
    let next = said.lines().last().unwrap();
    let order =
        next.strip_prefix("next: `sins ").and_then(|rest| rest.strip_suffix("` flies with them")).unwrap();
    let order: Vec<&str> = order.split(' ').chain(["--hours", "0.01", "-q"]).collect();
    done(&folder, &order);
}
