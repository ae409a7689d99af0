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

/// A file that cannot have its name at the end has a free one: nothing that was computed is lost.
#[test]
fn what_comes_in_between_is_not_replaced() {
    let (folder, _) = folder();
    let path = folder.path().join("out.csv");
    for (own, expected) in [("out_2.csv", 3), ("out_3.csv", 4)] {
        let file = Outputs::new(&[], false).file(&path, MARK);
        let file = file.unwrap();
        std::fs::write(&path, "somebody's").unwrap();
        let words = file.finish("time_s,own\n").unwrap_err().to_string();
        assert!(words.contains("--force") && words.ends_with(own), "{words}");
        assert_eq!((read(&path).as_str(), names(folder.path()).len()), ("somebody's", expected));
        assert_eq!(read(&folder.path().join(own)), "time_s,own\n");
        std::fs::remove_file(&path).unwrap();
    }
    // A folder cannot be replaced by a file.
    let file = Outputs::new(&[], true).file(&path, MARK).unwrap();
    std::fs::create_dir(&path).unwrap();
    assert!(file.finish("time_s,own\n").unwrap_err().to_string().ends_with("out_4.csv"));
}

#[test]
fn a_new_file_takes_the_place_of_no_other() {
    let (folder, log) = folder();
    let path = folder.path().join("out.csv");
    std::fs::write(&path, "time_s,own\n1\n").unwrap();
    let mut outputs = Outputs::new(&[], false);
    assert!(outputs.new_file(&path, MARK).unwrap().is_none(), "its own mark does not matter");
    let other = folder.path().join("other.csv");
    let file = outputs.new_file(&other, MARK).unwrap().unwrap();
    assert!(Outputs::new(&[], true).new_file(&other, MARK).unwrap().is_none(), "another run writes it");
    assert!(outputs.new_file(&other, MARK).unwrap().is_none(), "the same run writes it");
    // Also if the file has appeared in the meantime.
    std::fs::write(&other, "time_s,own\n2\n").unwrap();
    assert!(file.finish("time_s,own\n3\n").unwrap_err().to_string().ends_with("other_2.csv"));
    assert_eq!(read(&other), "time_s,own\n2\n");
    let mut forced = Outputs::new(std::slice::from_ref(&log), true);
    forced.new_file(&path, MARK).unwrap().unwrap().finish("time_s,own\n4\n").unwrap();
    assert_eq!(read(&path), "time_s,own\n4\n");
    assert!(forced.new_file(&log, MARK).unwrap_err().to_string().contains("is the input"));
}

/// A published file has its name while it is still written.
#[test]
fn a_file_grows_in_its_place() {
    let (folder, _) = folder();
    let path = folder.path().join("out.csv");
    for long in [true, false] {
        let mut file = Outputs::new(&[], true).file(&path, MARK).unwrap();
        let begin = if long { "time_s,own and more than the signature of a part\n" } else { "a\n" };
        file.write_all(begin.as_bytes()).unwrap();
        file.publish().unwrap();
        assert_eq!((read(&path).as_str(), names(folder.path()).len()), (begin, 2));
        writeln!(file, "1").unwrap();
        file.check().unwrap();
        assert_eq!(read(&path), format!("{begin}1\n"));
        writeln!(file, "2").unwrap();
        if long {
            file.commit_lines().unwrap();
        } else {
            drop(file);
        }
        assert_eq!(read(&path), format!("{begin}1\n2\n"));
    }
}

/// The first bytes are those of the output, however short it is, and reserved room is given back.
#[test]
fn a_part_has_its_signature_until_it_is_whole() {
    let (folder, _) = folder();
    let path = folder.path().join("out.csv");
    for length in [0, 1, 27, 28, 29, 100_000] {
        let content: String = "0123456789".chars().cycle().take(length).collect();
        let mut outputs = Outputs::new(&[], true);
        let mut file = outputs.file(&path, MARK).unwrap();
        file.reserve(1000).unwrap();
        let part = read(&folder.path().join(".sins-out.csv.part"));
        assert!(part.starts_with("# unfinished output of sins\n") && part.len() == 1028, "{part}");
        file.finish(&content).unwrap();
        assert!(read(&path) == content && names(folder.path()).len() == 2, "{length}");
    }
}

/// Files whose names look like those of parts, and are none, stay; so does a part that is being written.
#[test]
fn only_parts_that_nobody_writes_are_removed() {
    let (folder, _) = folder();
    let place = |name: &str| folder.path().join(name);
    let of_others =
        [(".sins-notes.part", "somebody's"), (".sins-.part", ""), (".sins-AbCdEf.part", "# unfinished")];
    for (name, text) in of_others {
        std::fs::write(place(name), text).unwrap();
    }
    std::fs::create_dir(place(".sins-folder.part")).unwrap();
    std::fs::write(place(".sins-killed.csv.part"), "# unfinished output of sins\n1,2\n3,").unwrap();
    let written = Outputs::new(&[], false).file(&place("written.csv"), MARK).unwrap();
    Outputs::new(&[], false).write(&place("out.csv"), MARK, "time_s,own\n").unwrap();
    let left = names(folder.path());
    assert!(left.contains(&".sins-written.csv.part".to_owned()) && left.len() == 7, "{left:?}");
    for (name, text) in of_others {
        assert_eq!(read(&place(name)), text);
    }
    written.finish("time_s,own\n").unwrap();
    // An output whose part would have the name of such a file is refused.
    let words = rejected(&mut Outputs::new(&[], true), &place("notes"));
    assert!(words.contains(".sins-notes.part is in the way"), "{words}");
    assert_eq!(read(&place(".sins-notes.part")), "somebody's");
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
    let file = Outputs::new(&[], false).file(&path, MARK).unwrap();
    for force in [false, true] {
        let words = rejected(&mut Outputs::new(&[], force), &path);
        assert!(words.contains("another run of sins is writing it"), "{words}");
    }
    file.finish("time_s,own\n1\n").unwrap();
    Outputs::new(&[], false).write(&path, MARK, "time_s,own\n2\n").unwrap();
    assert_eq!(read(&path), "time_s,own\n2\n");
}
