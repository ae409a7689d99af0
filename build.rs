//! Writes the C header from the sources of `src/abi`, and names the shared library.
//!
//! The header goes to the build's own folder, where a test compares it with the committed `include/sins.h`;
//! `SINS_WRITE_HEADER=1 cargo build` renews the committed one.

use std::path::{Path, PathBuf};
use std::{env, fs};

/// Longest line of the header.
const WIDTH: usize = 118;

/// Effects of the sensors that the library can be built without, to show what their being off costs: benches/effects.sh.
const EFFECTS: [&str; 18] = [
    "lever_arms",
    "bandwidth",
    "linear",
    "asymmetry",
    "quadratic",
    "g_sensitivity",
    "temperature",
    "bias",
    "gauss_markov",
    "flicker",
    "rate_random_walk",
    "ramp",
    "random_walk",
    "failures",
    "dead_zone",
    "range",
    "quantization",
    "altimeter",
];

/// In the order in which a reader of the header wants them.
const SOURCES: [&str; 30] = [
    "version",
    "failure",
    "options",
    "simulator",
    "gyro",
    "accel",
    "altimeter",
    "sensor_failure",
    "initial",
    "mounting",
    "gravity",
    "sample",
    "run",
    "solution",
    "accuracy",
    "truth_summary",
    "record",
    "navigator",
    "snapshot",
    "preset",
    "manoeuvre",
    "flight",
    "scene",
    "fault_report",
    "scene_settings",
    "scene_flight",
    "log",
    "recommend",
    "budget",
    "budget_answer",
];

fn main() {
    println!("cargo:rerun-if-changed=src/abi");
    println!("cargo:rerun-if-changed=build.rs");
    println!("cargo:rerun-if-env-changed=SINS_WRITE_HEADER");

    let names = format!("{EFFECTS:?}");
    println!("cargo:rustc-check-cfg=cfg(sins_without, values({}))", names.trim_matches(['[', ']']));
    println!("cargo:rerun-if-env-changed=SINS_WITHOUT");
    for effect in env::var("SINS_WITHOUT").unwrap_or_default().split_whitespace() {
        assert!(EFFECTS.contains(&effect), "SINS_WITHOUT: {effect} is none of {names}");
        println!("cargo:rustc-cfg=sins_without=\"{effect}\"");
    }

    let root = PathBuf::from(variable("CARGO_MANIFEST_DIR"));
    let header = header(&root);
    let generated = PathBuf::from(variable("OUT_DIR")).join("sins.h");
    fs::write(&generated, &header).expect("the build folder is writable");
    if env::var_os("SINS_WRITE_HEADER").is_some() {
        fs::write(root.join("include/sins.h"), &header).expect("include/sins.h is writable");
    }
    println!("cargo:rustc-env=SINS_GENERATED_HEADER={}", generated.display());

    // The number is SINS_ABI_VERSION: libraries of another one do not take this one's place.
    if variable("CARGO_CFG_TARGET_OS") == "linux" {
        println!("cargo:rustc-cdylib-link-arg=-Wl,-soname,libsins.so.1");
    }
}

fn variable(name: &str) -> String {
    env::var(name).unwrap_or_else(|_| panic!("cargo sets {name}"))
}

fn header(root: &Path) -> String {
    let abi = root.join("src/abi");
    let preamble = fs::read_to_string(abi.join("preamble.h")).expect("src/abi/preamble.h is readable");
    let config = cbindgen::Config {
        language: cbindgen::Language::C,
        no_includes: true,
        documentation_style: cbindgen::DocumentationStyle::C,
        style: cbindgen::Style::Both,
        usize_is_size_t: true,
        line_length: WIDTH,
        tab_width: 4,
        function: cbindgen::FunctionConfig {
            prefix: Some("SINS_API".to_owned()),
            args: cbindgen::Layout::Auto,
            ..Default::default()
        },
        export: cbindgen::ExportConfig {
            // Declared in the preamble: opaque.
            exclude: vec![
                "sins_sim".to_owned(),
                "sins_flight".to_owned(),
                "sins_scene".to_owned(),
                "sins_log".to_owned(),
            ],
            ..Default::default()
        },
        ..Default::default()
    };
    let builder = SOURCES.iter().fold(cbindgen::Builder::new().with_config(config), |builder, name| {
        builder.with_src(abi.join(name).with_extension("rs"))
    });
    let mut declarations = Vec::new();
    builder.generate().expect("src/abi parses").write(&mut declarations);
    let declarations = String::from_utf8(declarations).expect("the sources are UTF-8");

    // cbindgen has no place for a calling convention.
    let declarations = declarations.replace("sins_status sins_", "sins_status SINS_CALL sins_");
    let declarations = tidy(declarations.trim());
    format!("{preamble}\n{declarations}\n\n#ifdef __cplusplus\n}}\n#endif\n\n#endif /* SINS_H */\n")
}

/// A prototype that cbindgen broke over lines, as one, or with its arguments on a line of their own.
fn prototype<'a>(lines: &mut impl Iterator<Item = &'a str>) -> String {
    let mut text = String::from("SINS_API");
    for line in lines {
        let separator = if text.ends_with('(') { "" } else { " " };
        text = text + separator + line.trim();
        if text.ends_with(");") {
            break;
        }
    }
    if text.len() <= WIDTH {
        return text;
    }
    let Some((head, arguments)) = text.split_once('(') else { return text };
    let mut broken = format!("{head}(\n   ");
    let mut column = 3;
    for argument in arguments.split_inclusive(", ").map(str::trim) {
        if column + 1 + argument.len() > WIDTH {
            broken.push_str("\n   ");
            column = 3;
        }
        broken = broken + " " + argument;
        column += 1 + argument.len();
    }
    broken
}

/// One-line comments on one line, longer ones with a star a line, negative constants in parentheses, and no blank line
/// between constants of one family.
fn tidy(declarations: &str) -> String {
    let mut out: Vec<String> = Vec::new();
    let mut comment: Option<Vec<&str>> = None;
    let mut family = "";
    let mut lines = declarations.lines();
    while let Some(line) = lines.next() {
        let indent = &line[..line.len() - line.trim_start().len()];
        match (line.trim(), comment.take()) {
            ("/*", None) => comment = Some(Vec::new()),
            ("*/", Some(lines)) => {
                let indent = &indent[..indent.len().saturating_sub(1)];
                match lines[..] {
                    [only] => out.push(format!("{indent}/* {only} */")),
                    _ => {
                        out.push(format!("{indent}/*"));
                        out.extend(
                            lines.iter().map(|text| format!("{indent} * {text}").trim_end().to_owned()),
                        );
                        out.push(format!("{indent} */"));
                    }
                }
            }
            (text, Some(mut lines)) => {
                lines.push(text);
                comment = Some(lines);
            }
            (text, None) => match text.strip_prefix("#define ").and_then(|define| define.split_once(' ')) {
                Some((name, value)) => {
                    let this = name.split('_').nth(1).unwrap_or(name);
                    let comment =
                        out.iter().rposition(|line| line.trim_start().starts_with("/*")).unwrap_or(0);
                    if this == family && comment > 0 && out[comment - 1].is_empty() {
                        out.remove(comment - 1);
                    }
                    family = this;
                    let value = if value.starts_with('-') { format!("({value})") } else { value.to_owned() };
                    out.push(format!("#define {name} {value}"));
                }
                None if text == "SINS_API" => out.push(prototype(&mut lines)),
                None => out.push(line.to_owned()),
            },
        }
    }
    out.join("\n")
}
