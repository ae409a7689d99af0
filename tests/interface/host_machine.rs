//! Effects of a host and its machine on the library: programs in C, built and run. `tests/README.md` has the table.

use crate::support::c_programs::{library_folder, run_test_program, succeed, test_program};
use crate::support::{headers, project_file, without_comments};
use std::path::PathBuf;

#[test]
fn misuse_of_every_function_is_answered() {
    run_test_program("misuse");
}

#[test]
fn struct_sizes_from_zero_to_twice_are_answered() {
    run_test_program("struct_sizes");
}

#[test]
fn sentences_name_field_value_and_limit() {
    run_test_program("sentences");
}

/// Each function and struct of the header is in the test programs. A new one fails this test until it is
/// added there.
#[test]
fn every_function_and_struct_is_in_the_programs() {
    let header = headers();
    let code = |path: PathBuf| without_comments(&std::fs::read_to_string(path).unwrap());
    let wrapper: String =
        ["sins", "sins_handle", "sins_flight", "sins_analysis", "sins_unit", "sins_ensemble", "sins_scene"]
            .map(|name| format!("include/{name}.hpp"))
            .map(|path| code(project_file(&path)))
            .concat();
    let [calls, structs, sizes, states, scene, stack] = [
        "tests/c/every_call.h",
        "tests/c/every_struct.h",
        "tests/c/struct_sizes.c",
        "tests/c/float_environment.c",
        "tests/c/scene.h",
        "tests/c/stack.c",
    ]
    .map(|path| code(project_file(path)));
    let fuzzed: Vec<String> = std::fs::read_dir(project_file("tests/fuzz/src"))
        .unwrap()
        .map(|file| code(file.unwrap().path()))
        .collect();
    let mut missing = Vec::new();
    for prototype in header.split("SINS_CALL ").skip(1).filter(|text| text.starts_with("sins_")) {
        let (name, _) = prototype.split_once('(').unwrap();
        if ![&states, &scene, &calls].iter().any(|program| program.contains(&format!("{name}("))) {
            missing.push(format!("{name} in float_environment.c"));
        }
        // The wrapper calls the function or passes it on.
        if !['(', ')', ','].iter().any(|behind| wrapper.contains(&format!("{name}{behind}"))) {
            missing.push(format!("{name} in sins.hpp"));
        }
        if ![&stack, &calls].iter().any(|program| program.contains(&format!("{name}("))) {
            missing.push(format!("{name} in stack.c"));
        }
        if !fuzzed.iter().any(|source| source.contains(&format!("{name}("))) {
            missing.push(format!("{name} in the fuzz target calls"));
        }
    }
    for definition in header.split("typedef struct ").skip(1) {
        let (name, body) = definition.split_once(' ').unwrap();
        let is_sized = body.trim_start_matches(['{', '\n', ' ']).starts_with("/** sizeof(");
        let is_tried = [&structs, &sizes].iter().any(|calls| calls.contains(&format!("_SIZES({name}, ")));
        if is_sized && !is_tried {
            missing.push(format!("{name} in struct_sizes.c"));
        }
    }
    assert!(missing.is_empty(), "{missing:#?}");
}

#[test]
fn a_handle_destroyed_under_its_users_is_gone_for_all() {
    run_test_program("destroyed");
}

#[test]
fn threads_are_serialised_by_handle() {
    run_test_program("threads");
}

#[test]
fn a_handle_that_its_own_thread_is_inside_is_answered() {
    run_test_program("reentry");
}

/// `tests/platforms.sh` and `tests/windows.sh` check the digests on other machines.
#[test]
fn digests_of_five_flights_are_the_pinned_ones() {
    run_test_program("digests");
}

#[test]
fn the_hosts_floating_point_state_does_not_matter_and_is_kept() {
    run_test_program("float_environment");
}

#[test]
fn a_real_time_frame_makes_no_allocation_and_no_system_call() {
    run_test_program("real_time");
}

#[test]
fn the_library_comes_and_goes_and_two_copies_of_it_are_strangers() {
    let folder = library_folder("unload");
    let copies = ["libsins.so", "second.so"].map(|name| folder.join(name));
    std::fs::copy(&copies[0], &copies[1]).unwrap();
    succeed(test_program("unload", &folder).args(copies));
}

#[test]
fn every_call_fits_on_a_small_stack() {
    run_test_program("stack");
}

#[test]
fn memory_that_runs_out_is_told() {
    run_test_program("out_of_memory");
}
