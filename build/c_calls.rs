//! `tests/c/every_call.h`: every function of each handle with valid arguments, and every function with null for each pointer that may
//! not be null.

use std::collections::BTreeSet;

use super::model::{Function, Interface, Type};

const HEAD: &str = "\
/* Calls every function that takes a handle with valid arguments; `answer` gets each status. null_calls() calls every function with
 * null for each pointer that may not be null.
 *
 * This file is written by build/ from the Rust sources; do not edit it. */

#ifndef EVERY_CALL_H
#define EVERY_CALL_H

#include \"scene.h\"

typedef void every_call_answer(const char *call, sins_status status, void *context);

/* Asserts that the answer is the status at `context`. */
static inline void every_answer_is(const char *call, sins_status status, void *context)
{
    if (status != *(const sins_status *)context) {
        fprintf(stderr, \"%s gives %d\\n\", call, (int)status);
    }
    CHECK(status == *(const sins_status *)context);
}

#ifndef EVERY_CALL
#define EVERY_CALL(call) answer(#call, call, context)
#endif

/* A program with a small stack has `static` here. */
#ifndef EVERY_CALL_STORAGE
#define EVERY_CALL_STORAGE
#endif
";

/// Contents of structs that are not valid if they are zero, or that say more if they are not.
const CONTENTS: [(&str, &str); 10] = [
    ("gyro_params", "gyro_params[0] = scene_gyro();"),
    ("accel_params", "accel_params[0] = scene_accel();"),
    ("altimeter_params", "altimeter_params[0] = scene_altimeter();"),
    ("initial_errors", "initial_errors[0] = scene_initial_errors();"),
    ("flight_sample", "flight_sample[1].time_s = 0.01;"),
    ("navigation", "navigation[0].quaternion_nb[0] = 1.0;"),
    ("imu_increment", "imu_increment[0].interval_s = 0.01;\n    imu_increment[0].count = 1;"),
    ("flight_start", "flight_start[0].speed_m_s = 100.0;"),
    (
        "manoeuvre",
        "manoeuvre[0].duration_s = manoeuvre[1].duration_s = 60.0;\n    manoeuvre[0].kind = manoeuvre[1].kind = SINS_MANOEUVRE_STRAIGHT;",
    ),
    ("requirement", "requirement[0].position_m = 1.0;"),
];

/// Texts that are arguments.
const TEXTS: [(&str, &str); 6] = [
    ("path", "gyro.bias_deg_h[1]"),
    ("values", "gyro.bias_deg_h[1] = 0.5"),
    ("list", "failure"),
    ("items", ""),
    ("text", "another"),
    ("name", "patrol"),
];

/// Numbers that are arguments, and that 0 is not.
const NUMBERS: [(&str, &str); 4] =
    [("grade", "SINS_GRADE_CONSUMER"), ("word", "0x600000cb"), ("radius_m", "1.0"), ("percent", "95.0")];

/// Pointers that may be null, of all functions or of one.
const MAY_BE_NULL: [(&str, &[&str]); 19] = [
    ("", &["written", "needed"]),
    ("sins_identify_create", &["options", "request"]),
    ("sins_identify_solve", &["identified"]),
    ("sins_identify_check", &["request", "check"]),
    ("sins_create", &["options"]),
    ("sins_unit_create", &["params"]),
    ("sins_judge_create", &["options"]),
    ("sins_bus_words", &["inputs", "words"]),
    ("sins_recommend", &["configured"]),
    ("sins_error_budget", &["configured", "request", "budget"]),
    ("sins_record_line", &["record", "sensor_errors", "covariance"]),
    ("sins_scene_get_samples", &["log"]),
    ("sins_play_create", &["log"]),
    ("sins_play_get_shown", &["status", "navigation"]),
    ("sins_scene_get_manoeuvres", &["start", "repeat"]),
    ("sins_log_parse", &["scene", "fault"]),
    ("sins_ensemble_create", &["configured"]),
    ("sins_ensemble_get_runs", &["first_run", "runs"]),
    ("sins_log_get_sample", &["line"]),
];

pub fn write(interface: &Interface) -> String {
    let mut text = HEAD.to_owned();
    for handle in &interface.handles {
        let mut of_handle: Vec<&Function> =
            interface.functions.iter().filter(|one| is_call_of(one, handle)).collect();
        // What reads and what sets stands first: after the others the state has changed.
        of_handle.sort_by_key(|one| (!one.name.contains("_get_"), !one.name.contains("_set_")));
        let noun = handle.trim_start_matches("sins_");
        let name = if noun == "sim" { "every_call".to_owned() } else { format!("every_{noun}_call") };
        let other = match noun {
            "scene" | "unit" => "sins_sim *sim, ",
            "play" => "sins_scene *scene, ",
            _ => "",
        };
        let lines: String = of_handle
            .iter()
            .map(|one| format!("    EVERY_CALL({}({}));\n", one.name, arguments(interface, one, None)))
            .collect();
        text += &format!(
            "\n/* All functions of a {handle}, except those that destroy it and that read its last failure. */\nstatic inline void \
             {name}({handle} *{noun}, {other}every_call_answer *answer, void *context)\n{{\n{}{}{}}}\n",
            variables(interface, &lines, noun),
            lines,
            end(&of_handle)
        );
    }
    text + &other_calls(interface) + &null_calls(interface) + "\n#endif\n"
}

/// The functions of no handle; those that need a simulator or a scene get it.
fn other_calls(interface: &Interface) -> String {
    let is_other = |one: &&Function| {
        let is_of_handle = interface.handles.iter().any(|handle| is_call_of(one, handle));
        let is_left_out = one.name.ends_with("destroy") || one.name.starts_with("sins_last_error");
        !is_of_handle && !is_left_out && returns_status(one)
    };
    let mut lines = String::new();
    for one in interface.functions.iter().filter(is_other) {
        lines += &format!("    EVERY_CALL({}({}));\n", one.name, arguments(interface, one, None));
        lines += &end(&[one]);
    }
    format!(
        "\n/* All functions of no handle. */\nstatic inline void every_other_call(sins_sim *sim, sins_scene *scene, every_call_answer \
         *answer, void *context)\n{{\n{}{lines}}}\n",
        variables(interface, &lines, "other")
    )
}

fn returns_status(function: &Function) -> bool {
    function.result == Type::Named("sins_status".to_owned())
}

/// Whether this argument of this function may be null.
pub fn may_be_null(function: &str, argument: &str) -> bool {
    MAY_BE_NULL.iter().any(|(of, may)| (of.is_empty() || *of == function) && may.contains(&argument))
}

/// Whether a function is one of a handle that every state of the handle answers alike.
fn is_call_of(function: &Function, handle: &str) -> bool {
    let noun = handle.trim_start_matches("sins_");
    let takes = function
        .arguments
        .first()
        .is_some_and(|first| first.name == noun && pointee(&first.kind) == Some(handle));
    takes && !function.name.ends_with("destroy") && !function.name.starts_with("sins_last_error")
}

/// The struct or handle that a type points to.
pub fn pointee(kind: &Type) -> Option<&str> {
    match kind {
        Type::Const(target) | Type::Mut(target) => match &**target {
            Type::Named(name) => Some(name),
            _ => None,
        },
        _ => None,
    }
}

/// The handle that a function makes.
pub fn made(kind: &Type) -> Option<&str> {
    if let Type::Mut(target) = kind { pointee(target) } else { None }
}

fn null_calls(interface: &Interface) -> String {
    let is_here = |one: &&Function| !one.name.starts_with("sins_last_error") && returns_status(one);
    let functions: Vec<&Function> = interface.functions.iter().filter(is_here).collect();
    let mut lines = String::new();
    for function in &functions {
        for (index, argument) in function.arguments.iter().enumerate() {
            let is_pointer = matches!(argument.kind, Type::Const(_) | Type::Mut(_));
            let is_handle =
                pointee(&argument.kind).is_some_and(|name| interface.handles.iter().any(|one| one == name));
            if is_pointer && !is_handle && !may_be_null(&function.name, &argument.name) {
                lines += &format!(
                    "    EVERY_CALL({}({}));\n",
                    function.name,
                    arguments(interface, function, Some((index, Replaced::Null)))
                );
            }
        }
    }
    let handles: String = interface
        .handles
        .iter()
        .map(|handle| format!("{handle} *{}, ", handle.trim_start_matches("sins_")))
        .collect();
    format!(
        "\n/* Every function with null for each pointer that may not be null. */\nstatic inline void null_calls({handles}every_call_answer \
         *answer, void *context)\n{{\n{}{lines}}}\n",
        variables(interface, &lines, "all")
    )
}

/// What stands for one argument of a call.
#[derive(Clone, Copy, PartialEq)]
pub enum Replaced {
    Null,
    /// `pointer`, to one struct.
    Pointer,
}

/// The arguments of a call, of which one may be replaced.
pub fn arguments(interface: &Interface, function: &Function, replaced: Option<(usize, Replaced)>) -> String {
    let of = |index: usize| -> String {
        let argument = &function.arguments[index];
        let is_buffer = function.is_array(index);
        match replaced {
            Some((at, Replaced::Null)) if at == index => return "NULL".to_owned(),
            Some((at, Replaced::Pointer)) if at == index => return "pointer".to_owned(),
            Some((at, Replaced::Pointer)) if at + 1 == index && argument.kind == Type::Size => {
                return "1".to_owned();
            }
            Some((_, Replaced::Pointer))
                if pointee(&argument.kind) == Some("sins_sim")
                    && may_be_null(&function.name, &argument.name) =>
            {
                return "NULL".to_owned();
            }
            _ => {}
        }
        if let Some(handle) = made(&argument.kind) {
            return format!("&made_{}", handle.trim_start_matches("sins_"));
        }
        if let Some(name) = pointee(&argument.kind) {
            let noun = name.trim_start_matches("sins_");
            return match noun {
                "log" if index > 0 => "NULL".to_owned(),
                _ if function.arguments[..index].iter().any(|before| pointee(&before.kind) == Some(name)) => {
                    format!("{noun} + 1")
                }
                _ => noun.to_owned(),
            };
        }
        let before = index.checked_sub(1).map(|before| &function.arguments[before].kind);
        match &argument.kind {
            Type::Const(target) if **target == Type::Char && !is_buffer => {
                let (_, text) =
                    TEXTS.iter().find(|(name, _)| *name == argument.name).expect("a text has contents");
                format!("\"{text}\"")
            }
            Type::Const(target) | Type::Mut(target) => match **target {
                Type::Char => "(char *)bytes".to_owned(),
                Type::Void => "bytes".to_owned(),
                Type::Double => "numbers".to_owned(),
                Type::Int32 => "&choice".to_owned(),
                Type::Uint32 => "&flags".to_owned(),
                Type::Uint64 => "&word".to_owned(),
                _ => "&size".to_owned(),
            },
            Type::Size => match before {
                Some(kind)
                    if pointee(kind)
                        .is_some_and(|name| interface.structs.iter().any(|one| one.name == name)) =>
                {
                    "2".to_owned()
                }
                Some(Type::Const(target)) if **target == Type::Void => "size".to_owned(),
                // sins_record_line(): the errors of the six sensors.
                Some(Type::Const(target)) if **target == Type::Double => "6".to_owned(),
                Some(Type::Const(target)) if **target == Type::Char => "1".to_owned(),
                Some(Type::Mut(target)) if matches!(**target, Type::Char | Type::Void) => {
                    "sizeof bytes".to_owned()
                }
                _ if argument.name == "runs" || argument.name == "repeat" || argument.name == "every" => {
                    "1".to_owned()
                }
                _ => "0".to_owned(),
            },
            Type::Uint64 => "SCENE_FIRST_RUN".to_owned(),
            kind => {
                let number =
                    NUMBERS.iter().find(|(name, _)| *name == argument.name).map(|(_, number)| *number);
                number.unwrap_or(if *kind == Type::Double { "0.0" } else { "0" }).to_owned()
            }
        }
    };
    (0..function.arguments.len()).map(of).collect::<Vec<_>>().join(", ")
}

/// The variables that calls use, with their contents.
pub fn variables(interface: &Interface, calls: &str, noun: &str) -> String {
    let words: BTreeSet<&str> = calls.split(|c: char| !c.is_alphanumeric() && c != '_').collect();
    let (mut declared, mut set) = (String::new(), String::new());
    for one in &interface.structs {
        let name = one.name.trim_start_matches("sins_");
        if words.contains(name) {
            declared += &format!("    EVERY_CALL_STORAGE {} {name}[2];\n", one.name);
            set += &format!("    SINS_INIT({name}[0]);\n    SINS_INIT({name}[1]);\n");
            let contents = CONTENTS.iter().filter(|(of, _)| *of == name);
            set.extend(contents.map(|(_, contents)| format!("    {contents}\n")));
        }
    }
    for handle in &interface.handles {
        let name = format!("made_{}", handle.trim_start_matches("sins_"));
        if words.contains(&*name) {
            declared += &format!("    {handle} *{name} = NULL;\n");
        }
    }
    if noun == "scene" {
        declared += "    sins_ensemble *ensemble = scene_ensemble();\n    sins_unit *unit = scene_unit();\n";
    }
    let size = if noun == "sim" { "SINS_SNAPSHOT_MAX_SIZE" } else { "SCENE_RUNS * SINS_SNAPSHOT_MAX_SIZE" };
    for (name, line) in [
        ("bytes", format!("EVERY_CALL_STORAGE unsigned char bytes[{size}] = \"\";")),
        ("size", "size_t size = 0;".to_owned()),
        ("choice", "int32_t choice = 0;".to_owned()),
        ("flags", "uint32_t flags = 0;".to_owned()),
        ("word", "uint64_t word = 0;".to_owned()),
        ("numbers", "double numbers[6] = {0.0};".to_owned()),
    ] {
        if words.contains(name) {
            declared += &format!("    {line}\n");
        }
    }
    declared + &set
}

/// The function that destroys a handle.
pub fn destroy(handle: &str) -> String {
    if handle == "sins_sim" { "sins_destroy".to_owned() } else { format!("{handle}_destroy") }
}

/// Destroys what the calls made, but for handles that they lend.
fn end(functions: &[&Function]) -> String {
    let mut text = String::new();
    let making = functions.iter().filter(|one| !one.name.contains("_get_"));
    for handle in making.flat_map(|one| &one.arguments).filter_map(|argument| made(&argument.kind)) {
        let noun = handle.trim_start_matches("sins_");
        text += &format!("    CHECK(made_{noun} == NULL || {}(made_{noun}) == SINS_OK);\n", destroy(handle));
    }
    if functions.iter().any(|one| one.name == "sins_scene_prepare_ensemble") {
        text +=
            "    CHECK(sins_ensemble_destroy(ensemble) == SINS_OK && sins_unit_destroy(unit) == SINS_OK);\n";
    }
    text
}
