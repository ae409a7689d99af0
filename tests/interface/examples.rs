//! The examples compile without warnings and print the same as C and as C++. The harness ends like another program
//! that flies the same scene.

use std::process::{Command, Output};

use crate::support::c_programs::{
    C_AND_CPP, built_to, compiler_of, library_folder, prints_alike, shared_library, succeed,
};
use crate::support::{headers, project_file};

fn text(bytes: &[u8]) -> &str {
    std::str::from_utf8(bytes).unwrap()
}

#[test]
fn the_small_examples_run() {
    let text = prints_alike("minimal", &["c_examples/minimal.c"], &C_AND_CPP, &[]);
    // Schuler's loop holds a drift of 0.01 deg/h for an hour to about a mile.
    assert!(text.contains(" m east, -1") && text.ends_with(" m north\n"), "{text}");

    let text = prints_alike("recommend_example", &["c_examples/recommend.c"], &C_AND_CPP, &[]);
    assert!(text.contains("meets 1 m an hour") && text.contains("flown for an hour: "), "{text}");

    let text = prints_alike("budget_example", &["c_examples/budget.c"], &C_AND_CPP, &[]);
    assert!(text.contains("can be left out") && text.contains("left out: "), "{text}");

    let text = prints_alike("bus_example", &["c_examples/bus.c"], &C_AND_CPP, &[]);
    assert!(text.contains("label 310") && text.contains("heading magnetic 87.0000 deg"), "{text}");

    let text = prints_alike("unit_day", &["c_examples/unit_day.c"], &C_AND_CPP, &[]);
    let states: Vec<&str> = text.lines().map(|line| line[10..27].trim_end()).collect();
    let first = ["off", "test", "coarse alignment", "fine alignment", "ready", "navigation"];
    assert_eq!(states, [&first[..], &["realignment", "ready", "navigation", "power-down", "off"]].concat());
    let east_m = |line: &str| line.split_whitespace().nth_back(5).unwrap().parse::<f64>().unwrap().abs();
    let lines: Vec<&str> = text.lines().collect();
    assert!(east_m(lines[6]) > 100.0 && east_m(lines[7]) < 1.0, "{text}");

    let text = prints_alike("cpp_host", &["c_examples/cpp_host.cpp"], &C_AND_CPP[1..], &[]);
    assert!(
        text.contains("line 3: flight.builtin = \"petrol\": no such flight; did you mean patrol?"),
        "{text}"
    );
    assert!(
        text.contains("R50: not before 84.4 min") && text.contains("gyro.markov_time_s[1] = 0"),
        "{text}"
    );
}

/// R50 and R95 are given from the end of a Schuler period on. Each program that shows them asks the library for it.
#[test]
fn rates_need_a_schuler_period_at_every_door() {
    let folder = library_folder("rates");
    let harness = built_to("c99", &["c_examples/harness.c"], &folder, "harness");
    for (duration_s, is_given) in [(600, false), (5063, false), (5065, true)] {
        let scene = format!(
            "[flight]\nrate_hz = 1\n[[manoeuvre]]\nkind = \"rest\"\nduration_s = {duration_s}\n[gyro]\nbias_deg_h = 0.01\n"
        );
        std::fs::write(folder.join("scene.toml"), scene).unwrap();
        let output = succeed(Command::new(&harness).arg("scene.toml").current_dir(&folder));
        let text = text(&output.stdout);
        let is_left_out = text.contains("R50 and R95: not before 84.4 min, a Schuler period");
        assert_eq!((text.contains(" nmi/h"), is_left_out), (is_given, !is_given), "{duration_s} s: {text}");
    }
    for program in [
        "c_examples/harness.c",
        "c_examples/cpp_host.cpp",
        "apps/emulator/display_page.h",
        "apps/page/values.mjs",
    ] {
        let source = std::fs::read_to_string(project_file(program)).unwrap();
        assert!(source.contains("cep_rate_m_s") && source.contains("has_rates"), "{program}");
    }
}

/// The numbers of a line of text.
fn numbers(text: &str) -> Vec<f64> {
    let words = text.split(|c: char| !(c.is_ascii_digit() || c == '.'));
    words.filter_map(|word| word.parse().ok()).collect()
}

/// A filter of the host closes the loop: its errors have the sizes that it predicts, also after an outage of its receiver.
///
/// The limits are for 40 runs, 99.9 %. The normalized squares of a moment are chi-square of 600 degrees of freedom, and there are 30
/// moments: the quantile 1 - 0.0005 / 30 of a normal number is 4.15. The position error at the end of the outage is mostly along two
/// axes: at least 40 degrees of freedom, chi-square quantiles 0.37 and 1.84, whose roots limit the ratio. During the fixes each
/// component takes a new value within ten seconds: 40 runs of 18 values of two components, 3.3 of their standard deviations.
#[test]
fn a_filter_of_the_host_closes_the_loop() {
    let log = project_file("c_examples/flights/fighter_aerobatics.csv");
    let folder = library_folder("gnss_filter");
    let program = built_to("c99", &["c_examples/gnss_filter.c"], &folder, "gnss_filter");
    let output = succeed(Command::new(program).arg(log).arg("40"));
    let found = numbers(text(&output.stdout));
    println!("{}", text(&output.stdout));
    let &[40.0, ratio, 60.0, error_m, predicted_m, 15.0, 30.0, least, most] = &found[..] else {
        panic!("{found:?}")
    };
    assert!((ratio - 1.0).abs() < 3.3 / f64::sqrt(2.0 * 40.0 * 18.0 * 2.0), "{ratio}");
    let share = error_m / predicted_m;
    assert!((0.61..1.36).contains(&share) && predicted_m > 8.0, "{share}");
    let scatter = 4.15 * f64::sqrt(2.0 / (15.0 * 40.0));
    let (low, high) = (1.0 - scatter, 1.0 + scatter);
    assert!(least > low && most < high, "{least} {most}");
    println!("figure: {ratio:.2}; {least:.2} to {most:.2} (limits {low:.2} and {high:.2})");
}

/// The aircraft of the front end's cockpit, which needs no Windows: ideal sensors return to its truth.
#[test]
fn the_aircraft_of_the_cockpit_flies_and_lands() {
    let text = prints_alike("aircraft", &["tests/emulator/aircraft.cpp"], &["c++17", "c++20"], &[]);
    println!("figure: {}", text.trim_end().replace("aircraft: ", "").replace("e-0", "e-"));
}

/// The packets of the front end's live flight, which need no Windows.
#[test]
fn the_packets_of_the_front_end_are_flown_or_named() {
    let text = prints_alike("live", &["tests/emulator/live.cpp"], &["c++17", "c++20"], &[]);
    let found: Vec<&str> = text.lines().map(|line| line.trim_start_matches("live: ")).collect();
    println!("figure: {}", found.join("; ").replace("e-0", "e-"));
}

#[test]
fn the_example_of_the_readme_prints_what_it_says() {
    let readme = std::fs::read_to_string(project_file("README.md")).unwrap();
    let (_, rest) = readme.split_once("```c\n").unwrap();
    let (program, _) = rest.split_once("```").unwrap();
    let source = library_folder("readme").join("readme.c");
    std::fs::write(&source, program).unwrap();
    let text = prints_alike("readme", &[source.to_str().unwrap()], &C_AND_CPP, &[]);
    assert!(program.contains(&format!("/* {} */", text.trim_end())), "{text}");
}

/// The only block of C of a page of `docs`.
fn block_of(page: &str) -> String {
    let text = std::fs::read_to_string(project_file(page)).unwrap();
    let blocks: Vec<&str> = text.split("```c\n").skip(1).collect();
    assert_eq!(blocks.len(), 1, "{page}");
    blocks[0].split_once("```").unwrap().0.to_owned()
}

#[test]
fn a_pilots_update_removes_the_position_error() {
    let folder = library_folder("landmark");
    std::fs::write(folder.join("landmark.h"), block_of("docs/close_the_loop.md")).unwrap();
    let host = std::fs::read_to_string(project_file("tests/c/landmark.c")).unwrap();
    let check = project_file("tests/c/check.h");
    let source = folder.join("landmark.c");
    std::fs::write(&source, host.replace("\"check.h\"", &format!("{check:?}"))).unwrap();
    prints_alike("landmark", &[source.to_str().unwrap()], &C_AND_CPP, &[]);
}

#[test]
fn the_shim_with_old_exports_gives_the_errors_of_the_library() {
    let shim = library_folder("old_program").join("old_sins.c");
    std::fs::write(&shim, block_of("docs/paper.md")).unwrap();
    prints_alike("old_program", &[shim.to_str().unwrap(), "tests/c/old_program.c"], &C_AND_CPP, &[]);
}

#[test]
fn the_frame_function_keeps_the_errors_over_pauses_and_slews() {
    let folder = library_folder("frame");
    std::fs::write(folder.join("frame.h"), block_of("docs/flight_simulators.md")).unwrap();
    let host = std::fs::read_to_string(project_file("tests/c/frame.c")).unwrap();
    let check = project_file("tests/c/check.h");
    let source = folder.join("frame.c");
    std::fs::write(&source, host.replace("\"check.h\"", &format!("{check:?}"))).unwrap();
    prints_alike("frame", &[source.to_str().unwrap()], &C_AND_CPP, &[]);
}

/// The program in the first comment of `sins.h`, without the stars.
fn first_program() -> String {
    let header = std::fs::read_to_string(project_file("include/sins.h")).unwrap();
    let (_, rest) = header.split_once(" *     #include <stdio.h>\n").unwrap();
    let (program, _) = rest.split_once("\n *     }\n").unwrap();
    let lines = program.lines().map(|line| line.trim_start_matches(" *").strip_prefix("     ").unwrap_or(""));
    format!("#include <stdio.h>\n{}\n}}\n", lines.collect::<Vec<_>>().join("\n"))
}

#[test]
fn the_first_page_of_the_header_is_short_and_its_program_prints_what_it_says() {
    let header = std::fs::read_to_string(project_file("include/sins.h")).unwrap();
    let line_of = |part: &str| header.lines().position(|line| line.contains(part)).unwrap() + 1;
    assert!(line_of(" */") <= 60 && line_of("SINS_CALL sins_") < 150);
    let source = library_folder("first_page").join("host.c");
    std::fs::write(&source, first_program()).unwrap();
    let text = prints_alike("first_page", &[source.to_str().unwrap()], &C_AND_CPP, &[]);
    assert!(header.contains(&format!("which prints \"{}\"", text.trim_end())), "{text}");
}

/// The examples in the comments of the headers, each between two fences.
fn examples() -> Vec<String> {
    let headers = headers();
    let fenced = headers.split(" * ```c\n").skip(1).map(|rest| rest.split_once(" * ```\n").unwrap().0);
    let line = |line: &str| line.trim_start_matches(" *").to_owned() + "\n";
    fenced.map(|text| text.lines().map(line).collect()).collect()
}

/// One program has them all, in their order, after the hour of the first page. What they print stands behind `//`.
#[test]
fn the_examples_of_the_functions_print_what_they_say() {
    let (begin, _) =
        first_program().split_once("    printf(").map(|(a, b)| (a.to_owned(), b.to_owned())).unwrap();
    let examples = examples();
    assert!(examples.len() >= 14);
    let blocks: String = examples.iter().map(|text| format!("    {{\n{text}    }}\n")).collect();
    let program = format!("{begin}{blocks}    return sins_destroy(sim);\n}}\n");
    let source = library_folder("header_examples").join("examples.c");
    std::fs::write(&source, program.replace("\"sins.h\"", "\"sins_functions.h\"")).unwrap();
    let text = prints_alike("header_examples", &[source.to_str().unwrap()], &C_AND_CPP, &[]);
    let expected: Vec<&str> = examples
        .iter()
        .flat_map(|text| text.lines())
        .filter_map(|line| Some(line.split_once("  // ")?.1))
        .collect();
    assert_eq!(text.lines().collect::<Vec<_>>(), expected);
    println!("figure: {} programs and parts", 1 + examples.len());
}

#[test]
fn the_harness_flies_alike_as_c_and_as_cpp() {
    for scene in ["c_examples/scenes/fighter.toml", "coning"] {
        let path = project_file(scene);
        let scene = if path.exists() { path.to_str().unwrap() } else { scene };
        let text = prints_alike("harness_example", &["c_examples/harness.c"], &C_AND_CPP, &[scene]);
        assert!(text.contains("error equations") && text.contains("closure, "), "{text}");
    }
}

/// `tests/platforms.sh` and `tests/windows.sh` run the same check with hosts of 32 bits and of x87 arithmetic.
#[test]
fn the_host_that_loads_the_library_flies_or_says_why_it_cannot() {
    for standard in C_AND_CPP {
        let (compiler, language) = compiler_of(standard);
        let compiler = format!("{} -x {language} -std={standard}", compiler.get_program().display());
        succeed(Command::new(project_file("tests/loading.sh")).arg(compiler).arg(shared_library()));
    }
}

/// Errors of position, velocity and misalignment at the end with all their digits: against the truth, and by the error equations.
type EndErrors = Vec<[String; 2]>;

fn printed_end(output: &Output) -> EndErrors {
    let lines = text(&output.stdout).lines();
    let rows = lines.filter(|line| {
        ["position m ", "velocity m/s ", "misalignment rad "].iter().any(|kind| line.starts_with(kind))
    });
    rows.map(|line| {
        let mut fields = line.split_whitespace().rev().map(str::to_owned);
        let model = fields.next().unwrap();
        [fields.next().unwrap(), model]
    })
    .collect()
}

/// The same scene, flown with the few lines that a host needs. The log is named by its own path.
#[test]
fn a_program_of_forty_lines_ends_with_the_same_errors() {
    let folder = library_folder("fighter");
    let scene = project_file("c_examples/scenes/fighter.toml");
    let log = project_file("c_examples/flights/fighter_aerobatics.csv");
    let [short, harness] =
        [("tests/c/fighter.c", "fighter"), ("c_examples/harness.c", "harness")].map(|(source, name)| {
            let program = built_to("c99", &[source], &folder, name);
            succeed(Command::new(program).args([&scene, &log]))
        });
    let rows: Vec<Vec<&str>> = text(&short.stdout).lines().map(|line| line.split(' ').collect()).collect();
    let found: Vec<&str> = (0..9).map(|k| rows[k % 3][k / 3]).collect();
    assert_eq!(found, printed_end(&harness).iter().map(|[error, _]| error).collect::<Vec<_>>());
}

#[test]
fn the_harness_names_every_fault_and_its_place() {
    let folder = library_folder("harness_faults");
    let harness = built_to("c99", &["c_examples/harness.c"], &folder, "harness");
    let write = |name: &str, text: &str| std::fs::write(folder.join(name), text).unwrap();
    let gap = "\n".repeat(8);
    write(
        "scene.toml",
        &format!(
            "[flight]\nbuiltin = \"rest\"\n{gap}[gyro]\nbais_deg_h = 1\n[accelerometer]\nscale_factor_ppm = 2e6\n"
        ),
    );
    write("no_log.toml", "[flight]\nfile = \"none.csv\"\n");
    write("gap.toml", "[flight]\nfile = \"gap.csv\"\n");
    let columns = "time_s,latitude_rad,longitude_rad,height_m,roll_rad,pitch_rad,heading_rad\n";
    write("gap.csv", &format!("{columns}0,0,0,0,0,0,0\n1,0,0,0,0,0,0\n9,0,0,0,0,0,0\n"));
    write("bad.csv", &format!("{columns}0,0,0,0,0,0,0\n1,0,x,0,0,0,0\n"));
    for (arguments, expected) in [
        (&["petrol"][..], &["sins_scene_create_builtin: ", "SINS_ERROR_INVALID_ARGUMENT"][..]),
        (&["none.toml"], &["none.toml: No such file"]),
        (&["no_log.toml"], &["none.csv: No such file"]),
        (&["patrol", "bad.csv"], &["bad.csv:3:3: ", "\"x\""]),
        (&["gap.toml"], &["sins_play_run: at 9 s, line 4 of the log: ", "SINS_ERROR_DISCONTINUITY"]),
    ] {
        let output = Command::new(&harness).args(arguments).current_dir(&folder).output().unwrap();
        assert_eq!(output.status.code(), Some(1), "{arguments:?}");
        for words in expected {
            assert!(text(&output.stderr).contains(words), "{arguments:?}: {}", text(&output.stderr));
        }
    }
    // All faults of a text at once, as docs/scenes.md shows them.
    let page = std::fs::read_to_string(project_file("docs/scenes.md")).unwrap();
    let output = Command::new(&harness).arg("scene.toml").current_dir(&folder).output().unwrap();
    assert_eq!((output.status.code(), text(&output.stderr).lines().count()), (Some(1), 2));
    assert!(text(&output.stderr).lines().all(|line| page.contains(line)), "{}", text(&output.stderr));
    assert_eq!(Command::new(&harness).output().unwrap().status.code(), Some(2));
}
