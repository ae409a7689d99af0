//! `sins log`: what a log has, and a smooth path of it that flies.

use crate::judged::{circle, faulty, write};
use crate::support::{done, folder, numbers, project_file, read, rejected, rows, run};

#[test]
fn a_log_is_looked_at() {
    let folder = folder("look");
    write(&folder.join("good.csv"), &circle(10, 60), true);
    let said = done(&folder, &["log", "good.csv"]);
    assert_eq!(said, "good.csv: 601 rows over 60 s, 10 Hz, with velocities\nnothing is doubtful\n");
    faulty(&folder);
    let (code, said, errors) = run(&folder, &["log", "float32.csv"]);
    assert_eq!((code, errors.as_str()), (2, "float32.csv: a flight of this log is refused\n"));
    assert!(said.contains("without velocities\nfloat32.csv: unusable: positions step by"), "{said}");
    assert_eq!(done(&folder, &["log", "good.csv", "--strict"]), done(&folder, &["log", "good.csv"]));
    let (code, said, errors) = run(&folder, &["log", "reversed.csv", "--strict"]);
    assert!(code == 1 && said.contains(": doubtful: ") && errors.contains("refused (--strict)"), "{errors}");
    assert!(rejected(&folder, &["log", "good.csv", "--smooth"]).contains("--output"));
}

/// The first record of a log without velocities has the mean velocity up to the second row.
#[test]
fn the_first_record_of_positions_alone_has_a_velocity() {
    let folder = folder("first_velocity");
    write(&folder.join("flight.csv"), &circle(10, 20), false);
    done(&folder, &["fly", "flight.csv", "-q"]);
    let (names, records) = numbers(&folder.join("sins_out/flight.csv"));
    for (name, expected) in [("north", 80.0), ("east", 0.0)] {
        for of in ["truth", "navigation"] {
            let column = format!("{of}_velocity_{name}_m_s");
            let place = names.iter().position(|name| *name == column).unwrap();
            // It turns by 3 degrees a second: a quarter of a degree in 0.05 s, and the radius of the Earth is a mean one.
            assert!((records[0][place] - expected).abs() < 0.5, "{column}: {}", records[0][place]);
        }
    }
}

/// A table of somebody else's: its columns are found, and the next command flies it.
#[test]
fn columns_are_found_and_fly() {
    let folder = folder("map");
    std::fs::copy(project_file("c_examples/flights/cockpit.csv"), folder.join("cockpit.csv")).unwrap();
    let errors = rejected(&folder, &["log", "cockpit.csv"]);
    assert!(
        errors.contains("missing columns: time_s")
            && errors.contains("`sins log cockpit.csv --map columns.toml`"),
        "{errors}"
    );
    let said = done(&folder, &["log", "cockpit.csv", "--map", "map.toml"]);
    for words in [
        "the columns are of the format Garmin G1000\n",
        "not sure: heading and track",
        ": note: the first 8 rows hold a value from before the first fix (these rows are left out)",
    ] {
        assert!(said.contains(words), "{words}: {said}");
    }
    assert!(said.ends_with("next: `sins fly cockpit.csv --columns map.toml`\n"), "{said}");
    let (code, _, errors) = run(&folder, &["fly", "cockpit.csv", "--columns", "map.toml", "--name", "found"]);
    assert_eq!(code, 0, "{errors}");
    // The same path as by the columns that were written by hand, but for the variation, which only the pilot knows, and the geoid.
    let scene = project_file("c_examples/scenes/cockpit.toml").display().to_string();
    run(&folder, &["fly", &scene, "--name", "known"]);
    let [found, known] = ["found", "known"].map(|name| rows(&folder.join(format!("sins_out/{name}.csv"))));
    assert!(found.len() > 100 && found.len() == known.len(), "{} {}", found.len(), known.len());
    for (found, known) in found.iter().zip(&known) {
        for (name, off) in
            [("truth_latitude_rad", 0.0), ("truth_longitude_rad", 0.0), ("truth_height_m", 38.0)]
        {
            let [found, known] = [found, known].map(|row| row[name].parse::<f64>().unwrap());
            assert!((known - found - off).abs() < 1e-6 * known.abs(), "{name}: {found} {known}");
        }
    }

    // Written again it is the same; what the user has added is not lost.
    assert_eq!(done(&folder, &["log", "cockpit.csv", "--map", "map.toml"]), said);
    let edited = read(folder.join("map.toml")) + "geoid = 38\n";
    std::fs::write(folder.join("map.toml"), &edited).unwrap();
    let (code, _, errors) = run(&folder, &["log", "cockpit.csv", "--map", "map.toml"]);
    assert!(code == 2 && errors.contains("map.toml") && read(folder.join("map.toml")) == edited, "{errors}");
    std::fs::copy(folder.join("cockpit.csv"), folder.join("cockpit.txt")).unwrap();
    let said = done(&folder, &["log", "cockpit.txt", "--map", "text.toml"]);
    assert!(said.ends_with("next: `sins fly cockpit.txt --columns text.toml`\n"), "{said}");
    assert_eq!(run(&folder, &["fly", "cockpit.txt", "--columns", "text.toml", "--quiet"]).0, 0);
    // --log takes it too, and a scene stays one.
    for given in [&["--log", "cockpit.txt"][..], &["rest", "--log", "cockpit.txt"]] {
        assert_eq!(
            run(&folder, &[&["fly", "--columns", "text.toml", "-q", "--force"], given].concat()).0,
            0,
            "{given:?}"
        );
    }

    let errors = rejected(&folder, &["log", "cockpit.csv", "--map", "cockpit.csv"]);
    assert!(errors.contains("is the input cockpit.csv"), "{errors}");
    std::fs::write(folder.join("numbers.csv"), "1,2,3\n4,5,6\n").unwrap();
    let errors = rejected(&folder, &["log", "numbers.csv", "--map", "numbers.toml"]);
    assert!(
        errors.contains("no line at its beginning has known names") && !folder.join("numbers.toml").exists(),
        "{errors}"
    );
}

/// Each of the faults that smoothing is the remedy of: the path flies without a doubt, and near the circle.
#[test]
fn faulty_logs_fly_when_they_are_smoothed() {
    let folder = folder("smooth");
    faulty(&folder);
    let truth = circle(50, 150);
    for log in ["float32", "zeros", "spike", "held", "reversed"] {
        let (file, smooth) = (format!("{log}.csv"), format!("{log}_smooth.csv"));
        let (code, said, errors) = run(&folder, &["log", &file, "--smooth", "-o", &smooth]);
        assert!(code == 0 && said.starts_with(&format!("\nwritten\n  {smooth} ")), "{said}{errors}");
        assert!(
            errors.contains("position: motion above ") && errors.contains(" Hz is lost; noise "),
            "{errors}"
        );
        assert_eq!(errors.contains("the velocities of the log are not used"), log == "reversed", "{errors}");
        assert!(read(folder.join(&smooth)).starts_with("# smoothed by sins log\ntime_s,latitude_deg,"));
        let mut largest = 0.0_f64;
        // At its ends a path is stiffer: 20 s are six times 1 / (2π f) of the lowest cut-off.
        for row in rows_of(&folder.join(&smooth)).iter().filter(|row| (20.0..130.0).contains(&row[0])) {
            let at = ((row[0] * 50.0).round() as usize).min(truth.len() - 1);
            let north = (row[1] - truth[at][1]) * 111_200.0;
            let east = (row[2] - truth[at][2]) * 111_200.0 * 0.682;
            largest = largest.max(north.hypot(east));
        }
        println!("{log}: {largest:.3} m");
        // A step of 32 bits here is 0.42 m.
        assert!(largest < 1.0, "{log}: {largest} m");
        done(&folder, &["fly", "-q", "--strict", &smooth]);
    }
    // The same bytes again, in a new file and over the old one; a log that the user wrote is not replaced.
    let before = read(folder.join("spike_smooth.csv"));
    for file in ["again.csv", "spike_smooth.csv"] {
        let (code, said, errors) = run(&folder, &["log", "spike.csv", "--smooth", "-o", file]);
        assert!(code == 0 && said.starts_with(&format!("\nwritten\n  {file} ")), "{said}{errors}");
        assert!(read(folder.join(file)) == before, "{file}");
    }
    let errors = rejected(&folder, &["log", "spike.csv", "--smooth", "-o", "spike.csv"]);
    assert!(errors.contains("is the input spike.csv"), "{errors}");
}

/// What is wrong in the rows of a path is said of the path: where it is not flown, as a note.
#[test]
fn what_the_rows_had_is_said_of_their_path() {
    let folder = folder("rows");
    let smooth = ["--set", "log.smooth=auto"];
    let flown = |file: &str| run(&folder, &[&["fly", "-q", "--strict", file][..], &smooth].concat());
    faulty(&folder);
    for (log, words) in [
        (
            "knots.csv",
            "note: velocity is 1.94 times the displacement (knots?) (the velocity of the path is flown instead)",
        ),
        (
            "zeros.csv",
            "zeros.csv:2: note: the first 5 rows hold a value from before the first fix (these rows are left out)",
        ),
        ("held.csv", "note: 90 % of the moving rows repeat the position of the row before"),
    ] {
        let (code, _, errors) = flown(log);
        assert!(code == 0 && errors.contains(words), "{log}: {errors}");
    }
    // Velocities that contradict the positions stay doubtful, since it may be the positions or the times that are wrong.
    type Change = fn(&mut [f64; 9]);
    let changes: [(&str, Change); 5] = [
        ("mirrored", |row| row[2] = -row[2]),
        ("exchanged", |row| (row[1], row[2]) = (row[2] + 30.0, row[1] - 39.0)),
        ("quick", |row| row[0] /= 2.5),
        ("hundredths", |row| row[0] *= 100.0),
        ("wind", |row| row[7] += 25.0),
    ];
    for (log, change) in changes {
        let mut rows = circle(10, 150);
        rows.iter_mut().for_each(change);
        let file = format!("{log}.csv");
        write(&folder.join(&file), &rows, true);
        let (code, _, errors) = flown(&file);
        let words = "if the velocity of the rows is right, their positions or times are wrong";
        let is_doubtful = |line: &str| line.contains(": doubtful: velocity ") && line.contains(words);
        assert!(code != 0 && errors.lines().any(is_doubtful), "{log}: {errors}");
    }
    // No path can be fitted to these rows: the error says what may be the cause.
    let mut slow = circle(10, 15);
    for k in 0..slow.len() {
        let fix = slow[k / 10 * 10];
        slow[k][1..4].copy_from_slice(&fix[1..4]);
    }
    write(&folder.join("slow.csv"), &slow, false);
    let (code, _, errors) = flown("slow.csv");
    let words =
        "rows that are not repeats, to fit a path to them: 20; is it this? 90 % of the moving rows repeat";
    assert!(code == 2 && errors.contains(words), "{errors}");
    // A second flight, or another vehicle, behind the first.
    let rows = circle(10, 150);
    write(&folder.join("twice.csv"), &[&rows[..], &rows[..400]].concat(), true);
    let late = "twice.csv:1503: doubtful: 400 time stamps: not later than the one before, first at 0 s (these rows are left out; are they those of another vehicle";
    let (code, _, errors) = flown("twice.csv");
    assert!(code == 1 && errors.contains(late) && errors.contains("refused (--strict)"), "{errors}");
    std::fs::write(folder.join("smooth.toml"), "[log]\nsmooth = \"auto\"\n").unwrap();
    for command in [
        &["log", "twice.csv", "--columns", "smooth.toml"][..],
        &["log", "twice.csv", "--smooth", "-o", "s.csv"],
    ] {
        let (code, said, errors) = run(&folder, command);
        assert!(code == 0 && (said + &errors).contains(late), "{errors}");
    }
    // Another vehicle between the rows, 15 km off.
    std::fs::write(folder.join("track.toml"), "[log]\nattitude = \"coordinated\"\n").unwrap();
    let other = |row: &[f64; 9]| {
        let mut other = *row;
        (other[0], other[1], other[2]) = (row[0] + 0.04, row[1] + 0.1, row[2] + 0.1);
        [*row, other]
    };
    write(&folder.join("two.csv"), &rows.iter().flat_map(other).collect::<Vec<_>>(), false);
    let (code, _, errors) =
        run(&folder, &[&["fly", "-q", "two.csv", "--columns", "track.toml"][..]].concat());
    assert!(
        code == 2 && errors.contains("unusable: positions have ") && errors.contains("several vehicles"),
        "{errors}"
    );
    // One packet that came late.
    let mut late = rows.clone();
    late.swap(700, 701);
    write(&folder.join("late.csv"), &late, true);
    let (code, _, errors) = flown("late.csv");
    assert!(
        code == 0 && errors.contains("note: 1 time stamp: not later than the one before, first at 70 s"),
        "{errors}"
    );
}

/// A log of positions alone.
#[test]
fn a_log_without_attitude_flies_with_a_coordinated_one() {
    let folder = folder("coordinated");
    let text: String = circle(5, 150)
        .iter()
        .map(|[t, latitude, longitude, height, ..]| format!("{t},{latitude},{longitude},{height}\n"))
        .collect();
    std::fs::write(folder.join("track.csv"), format!("time_s,latitude_deg,longitude_deg,height_m\n{text}"))
        .unwrap();
    assert!(rejected(&folder, &["log", "track.csv"]).contains("missing columns: roll_rad or roll_deg"));
    let (code, _, errors) =
        run(&folder, &["log", "track.csv", "--smooth", "-o", "truth.csv", "--coordinated", "2"]);
    assert!(code == 0 && errors.contains("attitude: assumed, that of a coordinated flight"), "{errors}");
    done(&folder, &["fly", "-q", "--strict", "truth.csv"]);
    // atan(80 m/s 3 deg/s / g) = 23.1 deg; the nose points 2 deg above the path.
    for row in rows_of(&folder.join("truth.csv")).iter().filter(|row| (20.0..130.0).contains(&row[0])) {
        assert!((row[7] - 23.1).abs() < 0.3 && (row[8] - 2.0).abs() < 0.4, "{row:?}");
    }
    // An attitude that is not flown is not judged: neither columns of the log, nor their absence.
    let east: String = (0..3000)
        .map(|k| format!("{},47,{},500,10,20,{}\n", f64::from(k) * 0.1, 8.0 + f64::from(k) * 1e-4, k % 360))
        .collect();
    let header = "time_s,latitude_deg,longitude_deg,height_m,roll_deg,pitch_deg,heading_deg\n";
    std::fs::write(folder.join("east.csv"), format!("{header}{east}")).unwrap();
    let said = done(&folder, &["log", "east.csv", "--coordinated"]);
    assert!(
        said.contains("attitude: assumed, that of a coordinated flight without wind; CEP50 and R95 of an INS differ in nine of ten cases by up to 10 %")
            && said.ends_with("nothing is doubtful\n"),
        "{said}"
    );
}

fn rows_of(path: &std::path::Path) -> Vec<Vec<f64>> {
    let text = read(path);
    let rows = text.lines().filter(|line| !line.starts_with('#')).skip(1);
    rows.map(|line| line.split(',').map(|field| field.parse().unwrap()).collect()).collect()
}
