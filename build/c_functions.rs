//! `include/sins_functions.h`: the functions of the interface as a table that the preprocessor goes through.

use super::c_types::{argument_list, declaration};
use super::model::{Function, Interface};

const HEAD: &str = "\
/*
 * sins_functions.h - all functions of the library as a table, for hosts that look them up by themselves: by GetProcAddress() or dlsym().
 *
 *   #define DECLARE(result, name, arguments) result (SINS_CALL *name) arguments;
 *   struct functions { SINS_FUNCTIONS(DECLARE) };
 *
 * SINS_FUNCTIONS_SCENES are those that a library without the feature \"scenes\" lacks, SINS_FUNCTIONS_IDENTIFY without \"identify\".
 *
 * This file is written by build/ from the Rust sources; do not edit it.
 */

#ifndef SINS_FUNCTIONS_H
#define SINS_FUNCTIONS_H

#include \"sins_analysis.h\"
#include \"sins_scene.h\"
";

pub fn write(interface: &Interface) -> String {
    let table = |name: &str, feature: Option<&str>| {
        let functions = interface.functions.iter().filter(|one| one.feature == feature);
        let rows: Vec<String> = functions.map(|one| row(interface, one)).collect();
        format!("#define {name}(X) \\\n{}\n", rows.join(" \\\n"))
    };
    let engine = table("SINS_FUNCTIONS_ENGINE", None);
    let scenes = table("SINS_FUNCTIONS_SCENES", Some("scenes"));
    let identify = table("SINS_FUNCTIONS_IDENTIFY", Some("identify"));
    format!(
        "{HEAD}\n{engine}\n{scenes}\n{identify}\n\
         #define SINS_FUNCTIONS(X) SINS_FUNCTIONS_ENGINE(X) SINS_FUNCTIONS_SCENES(X) SINS_FUNCTIONS_IDENTIFY(X)\n\n\
         #endif /* SINS_FUNCTIONS_H */\n"
    )
}

fn row(interface: &Interface, function: &Function) -> String {
    let arguments = argument_list(interface, function).join(", ").replace("struct ", "");
    let result = declaration(interface, &function.result, "");
    format!("    X({}, {}, ({arguments}))", result.trim_end(), function.name)
}
