//! Tests that no file is lost that must not be lost.

use super::*;

const MARK: &str = "time_s,own";

/// A folder with a log that this program did not write.
fn folder() -> (tempfile::TempDir, PathBuf) {
    let folder = tempfile::tempdir().unwrap();
    let log = folder.path().join("log.csv");
    std::fs::write(&log, "time_s,latitude_rad\n0,0\n").unwrap();
    (folder, log)
}

fn read(path: &Path) -> String {
    std::fs::read_to_string(path).unwrap()
}

/// Names of all entries of the folder.
fn names(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).unwrap();
    let mut names: Vec<String> =
        entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

fn rejected(outputs: &mut Outputs, path: &Path) -> String {
    outputs.file(path, MARK).unwrap_err().to_string()
}

#[test]
fn a_file_is_whole_or_not_there() {
    let (folder, _) = folder();
    let path = folder.path().join("out.csv");
    let mut file = Outputs::new(&[], false).file(&path, MARK).unwrap();
    file.write_all(b"time_s,own\n1\n").unwrap();
    assert!(!path.exists() && names(folder.path()).len() == 2, "a temporary file beside it");
    file.commit().unwrap();
    assert_eq!((read(&path).as_str(), names(folder.path()).len()), ("time_s,own\n1\n", 2));

    // The file is dropped: the old file stays, and nothing else.
    let mut file = Outputs::new(&[], false).file(&path, MARK).unwrap();
    file.write_all(b"half").unwrap();
    drop(file);
    assert_eq!((read(&path).as_str(), names(folder.path()).len()), ("time_s,own\n1\n", 2));
}

#[test]
fn no_output_is_an_input_whatever_its_name() {
    let (folder, log) = folder();
    let place = |name: &str| folder.path().join(name);
    std::fs::hard_link(&log, place("hard.csv")).unwrap();
    #[cfg(unix)]
    std::os::unix::fs::symlink(&log, place("soft.csv")).unwrap();
    for force in [false, true] {
        let mut outputs = Outputs::new(std::slice::from_ref(&log), force);
        let more = if cfg!(unix) { "soft.csv" } else { "LOG.CSV" };
        for name in ["log.csv", "./log.csv", "hard.csv", more] {
            let words = rejected(&mut outputs, &place(name));
            assert!(words.contains("is the input"), "{name}: {words}");
        }
    }
    assert_eq!(read(&log), "time_s,latitude_rad\n0,0\n");
}

#[test]
fn files_of_others_need_force_and_own_ones_do_not() {
    let (folder, log) = folder();
    let mut outputs = Outputs::new(&[], false);
    assert!(rejected(&mut outputs, &log).contains("--force"));
    assert_eq!(read(&log), "time_s,latitude_rad\n0,0\n");
    Outputs::new(&[], true).write(&log, MARK, "time_s,own\n2\n").unwrap();
    Outputs::new(&[], false).write(&log, MARK, "time_s,own\n3\n").unwrap();
    assert_eq!(read(&log), "time_s,own\n3\n");
    // Replacing an empty file loses nothing.
    let empty = folder.path().join("empty");
    std::fs::write(&empty, "").unwrap();
    Outputs::new(&[], false).write(&empty, MARK, "time_s,own\n").unwrap();
}

#[test]
fn what_comes_in_between_is_not_replaced() {
    let (folder, _) = folder();
    let path = folder.path().join("out.csv");
    let file = Outputs::new(&[], false).file(&path, MARK).unwrap();
    std::fs::write(&path, "somebody's").unwrap();
    assert!(file.finish("time_s,own\n").unwrap_err().to_string().contains("--force"));
    assert_eq!((read(&path).as_str(), names(folder.path()).len()), ("somebody's", 2));
}

#[test]
#[cfg(unix)]
fn links_pipes_and_devices_stay_what_they_are() {
    let (folder, log) = folder();
    let place = |name: &str| folder.path().join(name);
    std::os::unix::fs::symlink(&log, place("link")).unwrap();
    std::os::unix::fs::symlink("/dev/null", place("null")).unwrap();
    std::os::unix::fs::symlink(place("nowhere"), place("dangling")).unwrap();
    assert!(std::process::Command::new("mkfifo").arg(place("pipe")).status().unwrap().success());
    let mut outputs = Outputs::new(&[], true);
    for name in ["link", "null", "dangling", "pipe", "/dev/null", "."] {
        let words = rejected(&mut outputs, &place(name));
        assert!(words.contains("only plain files") || words.contains("name of a file"), "{name}: {words}");
    }
    assert!(!place("nowhere").exists() && read(&log).starts_with("time_s"));
}

#[test]
fn devices_of_windows_are_known_by_their_names() {
    for name in ["con", "CON.csv", "nul .txt", "Com1", "LPT³.a.b", "conin$", "aux:x"] {
        assert!(is_device_of_windows(name), "{name}");
    }
    for name in ["console.csv", "com10", "com", "lpt", "a.con", "nul1", ".csv", ""] {
        assert!(!is_device_of_windows(name), "{name}");
    }
    assert_eq!(unfit("con").is_some(), cfg!(windows));
}

#[test]
fn two_outputs_of_one_name_are_rejected() {
    let (folder, _) = folder();
    std::fs::create_dir(folder.path().join("sub")).unwrap();
    let mut outputs = Outputs::new(&[], false);
    let _first = outputs.file(&folder.path().join("out.csv"), MARK).unwrap();
    assert!(rejected(&mut outputs, &folder.path().join("sub/../out.csv")).contains("two outputs"));
}

#[test]
fn two_runs_of_one_name_do_not_mix() {
    let (folder, _) = folder();
    let path = folder.path().join("out.csv");
    let mut files = [0, 1].map(|_| Outputs::new(&[], false).file(&path, MARK).unwrap());
    for line in 0..1000 {
        for (k, file) in files.iter_mut().enumerate() {
            writeln!(file, "{}", if line == 0 { MARK.to_owned() } else { format!("{k},{line}") }).unwrap();
        }
    }
    files.into_iter().for_each(|file| file.commit().unwrap());
    let text = read(&path);
    assert_eq!(text.lines().count(), 1000);
    assert!(text.lines().skip(1).all(|line| line.starts_with("1,")), "of one run alone");
}
