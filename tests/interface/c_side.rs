//! The C side, built and run: layout and call patterns.

use crate::support::c_programs::{
    STRICT, c_compiler, compiler_of, cpp_compiler, prints_alike, run_test_program, succeed,
};
use crate::support::project_file;

#[test]
fn structs_are_laid_out_alike_under_every_packing_and_language() {
    for packing in ["-DNO_PACKING", "-fpack-struct=4", "-fpack-struct=1"] {
        for (mut compiler, standard) in
            [(c_compiler(), &["-std=c99"][..]), (cpp_compiler(), &["-x", "c++", "-std=c++11"][..])]
        {
            compiler.args(standard).arg(packing).args(STRICT).arg("-fsyntax-only");
            compiler.arg("-I").arg(project_file("include")).arg(project_file("tests/c/layout.c"));
            succeed(&mut compiler);
        }
    }
}

#[test]
fn each_header_alone_is_c90_and_cpp98() {
    for name in [
        "sins.h",
        "sins_flight.h",
        "sins_analysis.h",
        "sins_unit.h",
        "sins_ensemble.h",
        "sins_scene.h",
        "sins_functions.h",
    ] {
        let header = project_file("include").join(name);
        for standard in ["c90", "c99", "c11", "c++98", "c++17"] {
            let (mut compiler, language) = compiler_of(standard);
            let standard = format!("-std={standard}");
            succeed(compiler.args(["-x", language, &standard, "-fsyntax-only"]).args(STRICT).arg(&header));
        }
    }
}

#[test]
fn the_table_of_functions_fits_their_declarations() {
    for (mut compiler, standard) in
        [(c_compiler(), &["-std=c99"][..]), (cpp_compiler(), &["-x", "c++", "-std=c++11"][..])]
    {
        compiler.args(standard).args(STRICT).arg("-fsyntax-only").arg("-I").arg(project_file("include"));
        succeed(compiler.arg(project_file("tests/c/functions.c")));
    }
}

/// A host may treat warnings as errors, so the headers must have none.
#[test]
fn the_headers_are_clean_under_the_warnings_of_strict_projects() {
    let of_both =
        ["-Wconversion", "-Wsign-conversion", "-Wundef", "-Wshadow", "-Wcast-qual", "-Wdouble-promotion"];
    for standard in ["c99", "c11", "c++98", "c++11", "c++20"] {
        let (mut compiler, language) = compiler_of(standard);
        compiler
            .args(["-x", language, &format!("-std={standard}"), "-fsyntax-only"])
            .args(STRICT)
            .args(of_both);
        if language == "c++" {
            compiler.arg("-Wold-style-cast");
        }
        succeed(compiler.arg("-I").arg(project_file("include")).arg(project_file("tests/c/strict.c")));
    }
}

/// `sins.hpp`, in the oldest and a newer standard.
#[test]
fn the_wrapper_owns_handles_and_throws_the_right_sentences() {
    prints_alike("wrapper", &["tests/c/wrapper.cpp"], &["c++11", "c++17"], &[]);
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
fn runs_of_an_ensemble_are_the_simulators_of_their_numbers() {
    run_test_program("ensemble");
}

#[test]
fn a_recommendation_is_flown_and_a_refused_one_writes_nothing() {
    run_test_program("recommend");
}

#[test]
fn a_budget_has_its_rows_and_a_refused_one_writes_nothing() {
    run_test_program("budget");
}

/// Errors that were set on a simulator come back from its increments, and a bad push or record changes nothing.
#[test]
fn errors_of_a_record_are_identified_and_a_bad_one_is_answered() {
    run_test_program("identify");
}
