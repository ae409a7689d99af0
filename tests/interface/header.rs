//! The shared library exports exactly what the headers declare.

use std::collections::{BTreeMap, BTreeSet};
use std::process::Command;

use crate::support::c_programs::shared_library;
use crate::support::{headers, project_file, without_comments};

/// Names that follow `SINS_CALL` in the header.
fn declared() -> BTreeSet<String> {
    let header = headers();
    let after = header.split("SINS_CALL ").skip(1);
    after
        .filter_map(|text| text.split('(').next())
        .filter(|name| name.starts_with("sins_"))
        .map(str::to_owned)
        .collect()
}

/// The words of the header outside of comments: names and numbers.
fn words() -> BTreeSet<String> {
    let code = without_comments(&headers());
    let is_of_word = |c: char| c.is_alphanumeric() || c == '_' || c == '.';
    code.split(|c| !is_of_word(c)).filter(|word| !word.is_empty()).map(str::to_owned).collect()
}

/// Ada, Fortran and Pascal do not distinguish upper from lower case.
#[test]
fn no_two_names_differ_in_case_alone() {
    let mut spellings = BTreeMap::<String, BTreeSet<String>>::new();
    for word in words() {
        spellings.entry(word.to_lowercase()).or_default().insert(word);
    }
    assert!(spellings.len() > 400);
    spellings.retain(|_, spellings| spellings.len() > 1);
    assert!(spellings.is_empty(), "{spellings:?}");
}

/// In Ada and Fortran a floating-point literal has a decimal point.
#[test]
fn a_number_with_an_exponent_has_a_point() {
    let is_number = |word: &&String| word.starts_with(|c: char| c.is_ascii_digit());
    let pointless: Vec<_> = words()
        .iter()
        .filter(is_number)
        .filter(|word| word.contains('e') && !word.contains('.'))
        .cloned()
        .collect();
    assert!(pointless.is_empty(), "{pointless:?}");
}

/// Integer constants are in enumerations, except for those that a host uses in `#if` or as the size of an array.
#[test]
fn constants_are_in_enumerations_and_something_names_each() {
    let header = headers();
    let whole = |line: &&str| {
        line.split(' ').nth(2).is_some_and(|value| value.trim_matches(['(', ')']).parse::<i64>().is_ok())
    };
    let macros: Vec<&str> =
        header.lines().filter(|line| line.starts_with("#define ")).filter(whole).collect();
    let named = |line: &str| {
        ["HEADER_ABI", "VERSION_", "MAX_SIZE", "FINDINGS_MAX", "IDENTIFIED_PARAMETERS"]
            .iter()
            .any(|part| line.contains(part))
    };
    assert!(macros.len() == 9 && macros.iter().all(|line| named(line)), "{macros:?}");

    let enumerations = header.split("\ntypedef enum ").skip(1).map(|text| text.split(' ').next().unwrap());
    let enumerations: Vec<&str> = enumerations.filter(|name| *name != "sins_status_code").collect();
    let is_named = |name: &str| {
        let mention = format!("enum {name}");
        let ends = |rest: &str| !rest.starts_with(|c: char| c == '_' || c.is_alphanumeric());
        header.split(&mention).skip(1).filter(|rest| ends(rest) && !rest.starts_with(" {")).count() > 0
    };
    let silent: Vec<&&str> = enumerations.iter().filter(|name| !is_named(name)).collect();
    assert!(enumerations.len() >= 20 && silent.is_empty(), "{silent:?}");
}

/// The functions of one of the tables of `sins_functions.h`.
fn table(name: &str) -> BTreeSet<String> {
    let tables = std::fs::read_to_string(project_file("include/sins_functions.h")).unwrap();
    let (_, table) = tables.split_once(&format!("#define {name}(X) \\\n")).unwrap();
    let rows = table.lines().map_while(|line| line.trim().strip_prefix("X("));
    rows.map(|row| row.split(", ").nth(1).unwrap().to_owned()).collect()
}

/// The tables have each declared function once. `functions.c` checks the signatures.
#[test]
fn the_tables_of_functions_have_each() {
    let tables = ["SINS_FUNCTIONS_ENGINE", "SINS_FUNCTIONS_SCENES", "SINS_FUNCTIONS_IDENTIFY"].map(table);
    assert_eq!(tables.iter().flatten().cloned().collect::<BTreeSet<_>>(), declared());
    assert_eq!(tables.iter().map(BTreeSet::len).sum::<usize>(), declared().len());
}

/// The compilation of the library and `layout.c` check that the sizes are right.
#[test]
fn the_size_of_each_struct_is_stated() {
    let header = headers();
    let layout = std::fs::read_to_string(project_file("tests/c/layout.c")).unwrap();
    let structs: Vec<&str> =
        header.lines().filter_map(|line| line.strip_prefix("typedef struct ")?.strip_suffix(" {")).collect();
    assert!(structs.len() > 20);
    for name in structs {
        let constant = name.replacen("sins_", "sins_sizeof_", 1).to_uppercase();
        assert!(header.contains(&format!("    {constant} = ")), "{name}");
        assert!(layout.contains(&format!("SIZE({name}, {constant}, ")), "{name}");
    }
}

#[test]
fn exported_symbols_are_exactly_the_interface() {
    let output = Command::new("nm").args(["-D", "--defined-only"]).arg(shared_library()).output().unwrap();
    assert!(output.status.success());
    let exported: BTreeSet<String> = String::from_utf8(output.stdout)
        .unwrap()
        .lines()
        .filter_map(|line| line.split_whitespace().last().map(str::to_owned))
        .collect();
    let mut expected = table("SINS_FUNCTIONS_ENGINE");
    assert!(expected.len() >= 27, "{expected:?}");
    if cfg!(feature = "scenes") {
        expected.append(&mut table("SINS_FUNCTIONS_SCENES"));
    }
    if cfg!(feature = "identify") {
        expected.append(&mut table("SINS_FUNCTIONS_IDENTIFY"));
    }
    assert_eq!(exported, expected);
}

/// Results have the same bits in every build and on every machine. Therefore no dependency may call the platform's mathematical
/// functions, with any of its features.
#[test]
fn the_library_needs_no_mathematics_of_the_platform() {
    let output = Command::new("readelf").arg("-d").arg(shared_library()).output().unwrap();
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(text.contains("[libc.so") && !text.contains("[libm.so"), "{text}");
}

/// The files of the project with this extension, without what is built.
fn files_with(extension: &str, folder: &std::path::Path, found: &mut Vec<std::path::PathBuf>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        if path.is_dir() && name != "target" && !name.starts_with('.') && name != "node_modules" {
            files_with(extension, &path, found);
        } else if path.extension().is_some_and(|of_file| of_file == extension) {
            found.push(path);
        }
    }
}

/// Pages, and the first lines of sources, name files that exist.
#[test]
fn files_that_pages_and_sources_name_exist() {
    const FOLDERS: [&str; 10] = [
        "src/",
        "tests/",
        "apps/",
        "bindings/",
        "build/",
        "benches/",
        "c_examples/",
        "docs/",
        "release/",
        "include/",
    ];
    let root = project_file("");
    let (mut pages, mut sources) = (Vec::new(), Vec::new());
    files_with("md", &root, &mut pages);
    files_with("rs", &root, &mut sources);
    let mut count = 0;
    for file in pages.iter().chain(&sources) {
        let text = std::fs::read_to_string(file).unwrap();
        let is_source = sources.contains(file);
        let lines = text.lines().filter(|line| !is_source || line.starts_with("//!"));
        let text: String = lines.flat_map(|line| [line, "\n"]).collect();
        for named in text.split(['`', '(', ')', ' ', '\n']) {
            let named = named.split(['#', ',', ':']).next().unwrap().trim_end_matches(['.', ';']);
            let is_path = FOLDERS.iter().any(|folder| named.starts_with(folder))
                && std::path::Path::new(named).extension().is_some_and(|end| end.len() <= 4)
                && !named.contains(['*', '{', '$', '<', '[']);
            // A package has the header as pages.
            if is_path && !named.contains("NAME") && !named.starts_with("docs/sins.h/") {
                let exists = file.ancestors().skip(1).any(|folder| folder.join(named).exists());
                assert!(exists, "{}: {named}", file.display());
                count += 1;
            }
        }
    }
    assert!(count > 150, "{count}");
}

/// The claims of the crate name tests that exist.
#[test]
fn tests_that_the_crate_names_exist() {
    let text = std::fs::read_to_string(project_file("src/lib.rs")).unwrap();
    let paths: Vec<&str> = text.split('`').filter(|words| words.starts_with("tests/")).collect();
    assert!(paths.len() > 30, "{paths:?}");
    for path in paths {
        assert!(project_file(path).exists(), "{path}");
    }
}
