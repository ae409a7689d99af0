//! The C side, built and run: layout, call patterns, and the examples.

#[path = "support/c_side.rs"]
mod c_side;

use std::process::Command;

use c_side::{
    STRICT, c_compiler, cpp_compiler, library_folder, link, project_file, run_test_program, succeed,
};
use sins::abi::{sins_accel_params, sins_gyro_params};
use sins::sensors::{PARAMETERS, Sensor};

/// Size and offsets of the structs of sensor parameters, for `layout.c`: numbers one behind the other, from the eighth byte on.
fn sensor_layout() -> String {
    let of = |name: &str, sensor: Sensor, size: usize| {
        let stated = name.replacen("sins_", "sins_sizeof_", 1).to_uppercase();
        let (mut offset, mut text) = (8, format!("SIZE({name}, {stated}, {size});\n"));
        for (parameter, field) in PARAMETERS.iter().filter_map(|row| Some((row, row.of(sensor)?))) {
            text += &format!("AT({name}, {}, {offset});\n", field.name());
            offset += 8 * parameter.shape.count();
        }
        assert_eq!(offset, size, "{name}");
        text
    };
    of("sins_gyro_params", Sensor::Gyro, size_of::<sins_gyro_params>())
        + &of("sins_accel_params", Sensor::Accelerometer, size_of::<sins_accel_params>())
}

#[test]
fn structs_are_laid_out_alike_under_every_packing_and_language() {
    let folder = library_folder("layout");
    std::fs::write(folder.join("sensor_layout.h"), sensor_layout()).unwrap();
    for packing in ["-DNO_PACKING", "-fpack-struct=4", "-fpack-struct=1"] {
        for (mut compiler, standard) in
            [(c_compiler(), &["-std=c99"][..]), (cpp_compiler(), &["-x", "c++", "-std=c++11"][..])]
        {
            compiler.args(standard).arg(packing).args(STRICT).arg("-fsyntax-only").arg("-I").arg(&folder);
            compiler.arg("-I").arg(project_file("include")).arg(project_file("tests/c/layout.c"));
            succeed(&mut compiler);
        }
    }
}

#[test]
fn the_header_alone_is_c90_and_cpp98() {
    let header = project_file("include/sins.h");
    succeed(c_compiler().args(["-x", "c", "-std=c90", "-fsyntax-only"]).args(STRICT).arg(&header));
    succeed(cpp_compiler().args(["-x", "c++", "-std=c++98", "-fsyntax-only"]).args(STRICT).arg(&header));
}

#[test]
fn any_call_pattern_gives_the_same_bits() {
    run_test_program("run");
}

#[test]
fn a_snapshot_goes_on_to_the_same_bits_in_any_handle() {
    run_test_program("snapshot");
}

#[test]
fn a_recommendation_is_flown_and_a_refused_one_writes_nothing() {
    run_test_program("recommend");
}

#[test]
fn a_budget_has_its_rows_and_a_refused_one_writes_nothing() {
    run_test_program("budget");
}

#[test]
fn examples_compile_without_a_warning_as_c99_and_as_cpp11() {
    for source in ["minimal", "recommend", "budget"].map(|name| format!("c_examples/{name}.c")) {
        for (mut compiler, standard) in
            [(c_compiler(), &["-std=c99"][..]), (cpp_compiler(), &["-x", "c++", "-std=c++11"][..])]
        {
            compiler.args(standard).args(STRICT).arg("-fsyntax-only").arg("-I").arg(project_file("include"));
            succeed(compiler.arg(project_file(&source)));
        }
    }
}

/// What a program prints, compiled as C99 and as C++11 alike.
fn prints_as_both(name: &str, sources: &[&str], arguments: &[&str]) -> String {
    let folder = library_folder(name);
    let as_c = link(c_compiler(), &["-std=c99"], sources, &folder, name);
    let as_cpp = link(cpp_compiler(), &["-x", "c++", "-std=c++11"], sources, &folder, &format!("{name}_cpp"));
    let [text, other] = [as_c, as_cpp].map(|program| {
        let output = succeed(Command::new(program).args(arguments).current_dir(&folder));
        String::from_utf8(output.stdout).unwrap()
    });
    assert_eq!(text, other);
    text
}

#[test]
fn the_small_examples_run() {
    let text = prints_as_both("minimal", &["c_examples/minimal.c"], &[]);
    // Schuler's loop holds a drift of 0.01 deg/h for an hour to about a mile.
    assert!(text.contains(" m east, -1") && text.ends_with(" m north\n"), "{text}");

    let text = prints_as_both("recommend_example", &["c_examples/recommend.c"], &[]);
    assert!(text.contains("meets 1 m an hour") && text.contains("flown for an hour: "), "{text}");

    let text = prints_as_both("budget_example", &["c_examples/budget.c"], &[]);
    assert!(text.contains("can be left out") && text.contains("left out: "), "{text}");

    let folder = library_folder("cpp_host");
    let cpp_host = link(cpp_compiler(), &["-std=c++11"], &["c_examples/cpp_host.cpp"], &folder, "cpp_host");
    let text = String::from_utf8(succeed(&mut Command::new(cpp_host)).stdout).unwrap();
    assert!(text.contains("nmi/h") && text.contains("gyro.markov_time_s[1] = 0"), "{text}");
}

#[test]
fn the_example_of_the_readme_prints_what_it_says() {
    let readme = std::fs::read_to_string(project_file("README.md")).unwrap();
    let (_, rest) = readme.split_once("```c\n").unwrap();
    let (program, _) = rest.split_once("```").unwrap();
    let source = library_folder("readme").join("readme.c");
    std::fs::write(&source, program).unwrap();
    let text = prints_as_both("readme", &[source.to_str().unwrap()], &[]);
    assert!(program.contains(&format!("/* {} */", text.trim_end())), "{text}");
}
