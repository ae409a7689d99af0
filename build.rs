//! Writes the structs of the table of sensor parameters and the C header from the sources of `src/abi`.
//!
//! The header goes to the build's own folder, where a test compares it with the committed `include/sins.h`;
//! `SINS_WRITE_HEADER=1 cargo build` renews the committed one.

#[path = "src/abi/header/enumerations.rs"]
mod enumerations;
#[allow(dead_code, reason = "the crate uses the rest")]
#[path = "src/sensors/parameter.rs"]
mod parameter;
#[path = "src/abi/header/sensor_structs.rs"]
mod sensor_structs;
#[path = "src/abi/header/sizes.rs"]
mod sizes;
#[path = "src/sensors/table.rs"]
mod table;
#[allow(dead_code, reason = "the crate uses the rest")]
#[path = "src/units.rs"]
mod units;

use std::path::{Path, PathBuf};
use std::{env, fs};

use enumerations::Enumeration;

/// Longest line of the header.
const WIDTH: usize = 118;

/// Effects of the sensors that the library can be built without, to show what their being off costs: benches/effects.sh.
const EFFECTS: [&str; 18] = [
    "size_effect",
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
const SOURCES: [&str; 32] = [
    "version",
    "failure",
    "options",
    "simulator",
    "last_error",
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
    "scene_failure",
    "log",
    "recommend",
    "budget",
    "budget_answer",
];

fn main() {
    println!("cargo:rerun-if-changed=src/abi");
    for source in ["build.rs", "src/sensors/parameter.rs", "src/sensors/table.rs", "src/units.rs"] {
        println!("cargo:rerun-if-changed={source}");
    }
    println!("cargo:rerun-if-env-changed=SINS_WRITE_HEADER");

    let names = format!("{EFFECTS:?}");
    println!("cargo:rustc-check-cfg=cfg(sins_without, values({}))", names.trim_matches(['[', ']']));
    println!("cargo:rerun-if-env-changed=SINS_WITHOUT");
    for effect in env::var("SINS_WITHOUT").unwrap_or_default().split_whitespace() {
        assert!(EFFECTS.contains(&effect), "SINS_WITHOUT: {effect} is none of {names}");
        println!("cargo:rustc-cfg=sins_without=\"{effect}\"");
    }

    let root = PathBuf::from(variable("CARGO_MANIFEST_DIR"));
    let out = PathBuf::from(variable("OUT_DIR"));
    let interface = out.join("sensor_params.rs");
    write(&out.join("triad_parameters.rs"), &sensor_structs::triad());
    write(&interface, &sensor_structs::interface());

    let header = header(&root, &interface, &out.join("sizes.rs"));
    let generated = out.join("sins.h");
    write(&generated, &header);
    if env::var_os("SINS_WRITE_HEADER").is_some() {
        write(&root.join("include/sins.h"), &header);
    }
    println!("cargo:rustc-env=SINS_GENERATED_HEADER={}", generated.display());
}

fn variable(name: &str) -> String {
    env::var(name).unwrap_or_else(|_| panic!("cargo sets {name}"))
}

fn write(path: &Path, text: &str) {
    fs::write(path, text).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
}

/// The header, of the sources of `src/abi` and of the structs in `sensor_params`; checks of the sizes in it go to the file
/// `size_checks`.
fn header(root: &Path, sensor_params: &Path, size_checks: &Path) -> String {
    let abi = root.join("src/abi");
    let preamble = fs::read_to_string(abi.join("preamble.h")).expect("src/abi/preamble.h is readable");
    let sources = SOURCES.map(|name| abi.join(name).with_extension("rs"));
    let mut found = Vec::new();
    for source in &sources {
        enumerations::find(&fs::read_to_string(source).expect("a source is readable"), &mut found);
    }
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
            // Declared in the preamble: opaque. And the enumerations.
            exclude: ["sins_sim", "sins_flight", "sins_scene", "sins_log"]
                .map(str::to_owned)
                .into_iter()
                .chain(found.iter().flat_map(Enumeration::names))
                .collect(),
            ..Default::default()
        },
        ..Default::default()
    };
    let builder = cbindgen::Builder::new().with_config(config).with_src(sensor_params);
    let builder = sources.iter().fold(builder, |builder, source| builder.with_src(source));
    let mut declarations = Vec::new();
    builder.generate().expect("src/abi parses").write(&mut declarations);
    let declarations = String::from_utf8(declarations).expect("the sources are UTF-8");

    let declarations = tidy(declarations.trim());
    let enumerations = enumerations::declare(&found);
    let sizes = sizes::of_structs(&declarations);
    write(size_checks, &sizes::check(&sizes));
    let (structs, functions) = declarations.split_at(first_function(&declarations));
    let sizes = sizes::declare(&sizes);
    format!(
        "{preamble}\n{enumerations}\n{structs}{sizes}\n\n{functions}\n\n#ifdef __cplusplus\n}}\n#endif\n\n#endif /* SINS_H */\n"
    )
}

/// Where the comment of the first function begins.
fn first_function(declarations: &str) -> usize {
    let function = declarations.find("SINS_API").expect("there are functions");
    declarations[..function].rfind("\n\n").expect("structs come first") + 2
}

/// A prototype that cbindgen broke over lines, as one, or with its arguments on a line of their own. It gets the calling
/// convention, for which cbindgen has no place.
fn prototype<'a>(first: &str, lines: &mut impl Iterator<Item = &'a str>) -> String {
    let mut text = first.to_owned();
    while !text.ends_with(");") {
        let separator = if text.ends_with('(') { "" } else { " " };
        text = text + separator + lines.next().expect("a prototype has an end").trim();
    }
    let (head, arguments) = text.split_once('(').expect("a prototype has arguments");
    let name = head.rfind([' ', '*']).expect("a prototype has a result") + 1;
    let head = format!("{}SINS_CALL {}", &head[..name], &head[name..]);
    let text = format!("{head}({arguments}");
    if text.len() <= WIDTH {
        return text;
    }
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

/// A comment of one line on that line, a longer one with a star a line.
fn comment(indent: &str, lines: &[impl AsRef<str>]) -> Vec<String> {
    if let [only] = lines {
        return vec![format!("{indent}/* {} */", only.as_ref())];
    }
    let starred = lines.iter().map(|text| format!("{indent} * {}", text.as_ref()).trim_end().to_owned());
    [format!("{indent}/*")].into_iter().chain(starred).chain([format!("{indent} */")]).collect()
}

/// Comments as [`comment`] writes them, and no blank line between constants of one family.
fn tidy(declarations: &str) -> String {
    let mut out: Vec<String> = Vec::new();
    let mut open: Option<Vec<&str>> = None;
    let mut family = "";
    let mut lines = declarations.lines();
    while let Some(line) = lines.next() {
        let indent = &line[..line.len() - line.trim_start().len()];
        match (line.trim(), open.take()) {
            ("/*", None) => open = Some(Vec::new()),
            ("*/", Some(lines)) => {
                out.extend(comment(&indent[..indent.len().saturating_sub(1)], &lines));
            }
            (text, Some(mut lines)) => {
                lines.push(text);
                open = Some(lines);
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
                    out.push(format!("#define {name} {value}"));
                }
                None if text.starts_with("SINS_API") => out.push(prototype(text, &mut lines)),
                None => out.push(line.to_owned()),
            },
        }
    }
    out.join("\n")
}
