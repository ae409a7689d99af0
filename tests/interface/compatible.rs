//! What a release promised of its C interface, the next one keeps, or it has another SINS_HEADER_ABI: the declarations of the headers,
//! and the sizes and offsets of `tests/c/layout.c`, compared with those of the last release.

use std::collections::BTreeMap;
use std::process::Command;

use crate::support::project_file;

const LAYOUT: &str = "tests/c/layout.c";

/// Each function, constant and field with what is declared of it, and each offset and size.
type Promises = BTreeMap<String, String>;

fn without_comments(text: &str) -> String {
    let mut rest = text;
    let mut kept = String::new();
    while let Some((before, comment)) = rest.split_once("/*") {
        kept.push_str(before);
        rest = comment.split_once("*/").unwrap().1;
    }
    kept + rest
}

/// Words with one blank between them.
fn words(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// The last name in a text: of a field behind its type, without its number of elements.
fn last_name(text: &str) -> &str {
    let text = text.split('[').next().unwrap().trim_end();
    let start = text.rfind(|letter: char| !letter.is_alphanumeric() && letter != '_');
    &text[start.map_or(0, |at| at + 1)..]
}

/// Adds what a header declares. Numbers of the version change with each release; sizes are in the layout.
fn add_header(header: &str, promises: &mut Promises) {
    let header = without_comments(header);
    let is_joined = |line: &&str| !line.ends_with('\\');
    for line in header.lines().filter(is_joined) {
        if let Some((name, value)) = line.strip_prefix("#define ").and_then(|line| line.split_once(' '))
            && !["SINS_VERSION", "SINS_FUNCTIONS", "SINS_API", "SINS_CALL"]
                .iter()
                .any(|own| name.starts_with(own))
        {
            promises.insert(name.to_owned(), words(value));
        }
    }
    let code: String =
        header.lines().filter(|line| !line.starts_with('#')).flat_map(|line| [line, " "]).collect();
    let mut rest = code.as_str();
    while let Some(end) = rest.find([';', '{']) {
        let head = words(&rest[..end]);
        if rest[end..].starts_with(';') {
            if let Some((declared, _)) =
                head.split_once('(').filter(|(declared, _)| declared.contains("SINS_API"))
            {
                promises.insert(last_name(declared).to_owned(), head.clone());
            } else if head.starts_with("typedef ") {
                promises
                    .insert(format!("typedef {}", last_name(head.split(')').next().unwrap())), head.clone());
            }
            rest = &rest[end + 1..];
            continue;
        }
        let kind = last_name(&head).to_owned();
        if head.contains("extern") {
            rest = &rest[end + 1..];
            continue;
        }
        let (body, behind) = rest[end + 1..].split_once('}').unwrap();
        if head.contains("enum") {
            for constant in body.split(',').filter(|constant| !constant.trim().is_empty()) {
                let (name, value) = constant.split_once('=').unwrap();
                if !name.trim().starts_with("SINS_SIZEOF_") {
                    promises.insert(name.trim().to_owned(), words(value));
                }
            }
        } else {
            for field in body.split(';').filter(|field| !field.trim().is_empty()) {
                promises.insert(format!("{kind}.{}", last_name(field.trim_end_matches(')'))), words(field));
            }
        }
        rest = behind;
    }
}

/// Adds sizes and offsets.
fn add_layout(layout: &str, promises: &mut Promises) {
    for line in layout.lines() {
        let of = |name: &str| {
            let inner = line.strip_prefix(name)?.strip_prefix('(')?.strip_suffix(");")?;
            Some(inner.split(", ").map(str::to_owned).collect::<Vec<_>>())
        };
        if let Some(at) = of("AT") {
            promises.insert(format!("offset of {}.{}", at[0], at[1]), at[2].clone());
        } else if let Some(size) = of("SIZE") {
            promises.insert(format!("size of {}", size[0]), size[2].clone());
        }
    }
}

/// What a release promises whose files `read` gives.
fn promises(headers: &[String], read: impl Fn(&str) -> String) -> Promises {
    let mut all = Promises::new();
    for header in headers {
        add_header(&read(header), &mut all);
    }
    add_layout(&read(LAYOUT), &mut all);
    all
}

fn may_grow(name: &str) -> bool {
    name.starts_with("size of ") || name == "SINS_FINDINGS_MAX"
}

/// What is no longer kept of what was promised. Structs may grow at their end, and anything may be added; with another
/// SINS_HEADER_ABI, nothing is promised.
fn broken(old: &Promises, new: &Promises) -> Vec<String> {
    let number = |all: &Promises, name: &str| all[name].parse::<u64>().unwrap();
    let (was, is) = (number(old, "SINS_HEADER_ABI"), number(new, "SINS_HEADER_ABI"));
    if is > was {
        return Vec::new();
    }
    let kept = |name: &String, promised: &String| match new.get(name) {
        None => Some(format!("{name} is gone")),
        // Numbers of what a later library has more of.
        Some(_) if may_grow(name) && number(new, name) >= number(old, name) => None,
        Some(now) if now != promised => Some(format!("{name} was `{promised}`, now `{now}`")),
        Some(_) => None,
    };
    old.iter().filter_map(|(name, promised)| kept(name, promised)).collect()
}

fn headers_here() -> Vec<String> {
    let folder = std::fs::read_dir(project_file("include")).unwrap();
    let names = folder.map(|file| format!("include/{}", file.unwrap().file_name().to_str().unwrap()));
    let mut names: Vec<String> = names.filter(|name| name.ends_with(".h")).collect();
    names.sort();
    names
}

fn here(path: &str) -> String {
    std::fs::read_to_string(project_file(path)).unwrap()
}

#[test]
fn each_break_of_the_interface_is_seen_and_what_is_added_is_none() {
    let headers = headers_here();
    let old = promises(&headers, here);
    assert!(old.len() > 1500 && broken(&old, &old).is_empty(), "{}", old.len());
    let changed = |file: &str, from: &str, to: &str| {
        let new = promises(&headers, |path| {
            let text = here(path);
            assert!(path != file || text.contains(from), "{file}: {from}");
            if path == file { text.replacen(from, to, 1) } else { text }
        });
        broken(&old, &new)
    };
    let sins = "include/sins.h";
    for (file, from, to, names) in [
        (sins, "SINS_API sins_status SINS_CALL sins_destroy(sins_sim *sim);", "", "sins_destroy is gone"),
        (sins, "sins_destroy(sins_sim *sim)", "sins_destroy(sins_sim *sim, int32_t how)", "sins_destroy was"),
        (
            sins,
            "uint32_t SINS_CALL sins_abi_version",
            "uint64_t SINS_CALL sins_abi_version",
            "sins_abi_version was",
        ),
        (sins, "SINS_GAP = 4", "SINS_GAP = 6", "SINS_GAP was `4`, now `6`"),
        (sins, "#define SINS_PPM 1.0e-6", "#define SINS_PPM 1.0e-3", "SINS_PPM was"),
        (sins, "double position_enu_m[3];", "float position_enu_m[3];", "position_enu_m was"),
        (sins, "double height_m;", "double altitude_m;", "height_m is gone"),
        (
            LAYOUT,
            "AT(sins_options, seed, 48);",
            "AT(sins_options, seed, 56);",
            "offset of sins_options.seed was `48`",
        ),
        (
            LAYOUT,
            "SINS_SIZEOF_OPTIONS, 104)",
            "SINS_SIZEOF_OPTIONS, 96)",
            "size of sins_options was `104`, now `96`",
        ),
    ] {
        let said = changed(file, from, to);
        assert!(said.iter().any(|one| one.contains(names)), "{from}: {said:?}");
    }
    for (file, from, to) in [
        (sins, "/** Returns the version", "SINS_API void SINS_CALL sins_new(void); /** Returns the version"),
        (sins, "SINS_GAP = 4,", "SINS_GAP = 4, SINS_NEW = 9,"),
        (sins, "#define SINS_PPM 1.0e-6", "#define SINS_PPM  1.0e-6 /* another comment */"),
        (LAYOUT, "SINS_SIZEOF_OPTIONS, 104)", "SINS_SIZEOF_OPTIONS, 112)"),
        (sins, "#define SINS_VERSION_MINOR 1", "#define SINS_VERSION_MINOR 2"),
        ("include/sins_flight.h", "#define SINS_FINDINGS_MAX ", "#define SINS_FINDINGS_MAX 1"),
    ] {
        assert_eq!(changed(file, from, to), [""; 0], "{to}");
    }
    // A break that is said by the number is none.
    let new = promises(&headers, |path| {
        here(path).replace("SINS_HEADER_ABI 1", "SINS_HEADER_ABI 2").replace("SINS_GAP = 4", "SINS_GAP = 6")
    });
    assert_eq!(broken(&old, &new), [""; 0]);
}

/// Without git, or before the first release, there is none to compare with.
#[test]
fn the_interface_of_the_last_release_is_kept() {
    let git = |arguments: &[&str]| {
        let output = Command::new("git").args(arguments).current_dir(project_file("")).output().ok()?;
        output.status.success().then(|| String::from_utf8(output.stdout).unwrap())
    };
    let Some(tag) = git(&["describe", "--tags", "--abbrev=0", "--match", "v[0-9]*"]) else {
        println!("no release before this one");
        return;
    };
    let tag = tag.trim();
    let shown =
        |path: &str| git(&["show", &format!("{tag}:{path}")]).unwrap_or_else(|| panic!("{tag}: {path}"));
    let of_tag = git(&["ls-tree", "--name-only", tag, "include/"]).unwrap();
    let of_tag: Vec<String> = of_tag.lines().filter(|name| name.ends_with(".h")).map(str::to_owned).collect();
    let said = broken(&promises(&of_tag, shown), &promises(&headers_here(), here));
    assert_eq!(said, [""; 0], "changed since {tag} with the same SINS_HEADER_ABI");
}
