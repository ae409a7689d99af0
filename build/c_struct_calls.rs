//! `tests/c/every_struct.h`: every function with each pointer to a struct that states its size.

use super::c_calls::{Replaced, arguments, destroy, made, pointee, variables};
use super::model::{Function, Interface, Type};

const HEAD: &str = "\
/* Calls every function with `pointer` for each pointer to a struct that states its size. OUTPUT_SIZES(type, call) and
 * INPUT_SIZES(type, call) try the sizes; ENDED(handle, destroy, call) destroys what the call has made.
 *
 * This file is written by build/ from the Rust sources; do not edit it. */

#ifndef EVERY_STRUCT_H
#define EVERY_STRUCT_H

#include \"every_call.h\"
";

/// Structs that a function reads and writes.
const READ_TOO: [&str; 4] =
    ["sins_statistics_add", "sins_statistics_merge", "sins_scene_prepare", "sins_scene_prepare_ensemble"];

/// Statistics of no run have no figures.
const PREPARED: &str = "    CHECK(sins_ensemble_get_statistics(ensemble, 0, statistics) == SINS_OK);\n";

/// Structs that a function takes only after other calls, or only several of: `tests/c/struct_sizes.c` has them.
const BY_HAND: [(&str, &str); 10] = [
    ("sins_run", "records"),
    ("sins_error_budget", "rows"),
    ("sins_bus_words", "words"),
    ("sins_ensemble_get_all_errors", "errors"),
    ("sins_scene_get_fault", "fault"),
    ("sins_scene_get_manoeuvres", "manoeuvres"),
    ("sins_log_parse", "fault"),
    ("sins_recommend", "samples"),
    ("sins_error_budget", "samples"),
    ("sins_log_create", "samples"),
];

pub fn write(interface: &Interface) -> String {
    let lines = calls(interface, true) + &calls(interface, false);
    let handles: Vec<String> = interface
        .handles
        .iter()
        .map(|handle| format!("{handle} *{}", handle.trim_start_matches("sins_")))
        .collect();
    format!(
        "{HEAD}\n/* First the structs that functions write: the calls behind them change what the handles stand for. */\n\
         static inline void every_struct({})\n{{\n{}{PREPARED}{lines}}}\n\n#endif\n",
        handles.join(", "),
        variables(interface, &lines, "all")
    )
}

/// A line for each pointer to a struct that functions write, or read.
fn calls(interface: &Interface, writes: bool) -> String {
    let mut lines = String::new();
    for function in &interface.functions {
        for (index, argument) in function.arguments.iter().enumerate() {
            let is_written = matches!(argument.kind, Type::Mut(_)) && !READ_TOO.contains(&&*function.name);
            let Some(kind) =
                pointee(&argument.kind).filter(|kind| is_written == writes && is_sized(interface, kind))
            else {
                continue;
            };
            if BY_HAND.contains(&(&function.name, &argument.name)) {
                continue;
            }
            let name = if writes { "OUTPUT_SIZES" } else { "INPUT_SIZES" };
            lines += &format!("    {name}({kind}, {});\n", call(interface, function, index));
        }
    }
    lines
}

/// Whether a type is a struct that states its size.
fn is_sized(interface: &Interface, kind: &str) -> bool {
    let of_kind = interface.structs.iter().find(|one| one.name == kind);
    of_kind.is_some_and(|one| one.fields[0].name == "struct_size")
}

/// The call with `pointer` for an argument, which destroys what it makes.
fn call(interface: &Interface, function: &Function, index: usize) -> String {
    let call =
        format!("{}({})", function.name, arguments(interface, function, Some((index, Replaced::Pointer))));
    match function.arguments.iter().find_map(|argument| made(&argument.kind)) {
        Some(handle) => {
            let noun = handle.trim_start_matches("sins_");
            format!("ENDED(made_{noun}, {}, {call})", destroy(handle))
        }
        None => call,
    }
}
