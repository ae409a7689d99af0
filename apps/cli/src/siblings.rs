//! Files of an autopilot beside that of its positions: one message or topic a file.

use std::path::Path;

use sins::log::Survey;

/// A file beside that of a known format.
struct Sibling {
    /// Format of the positions, and what the name of their file has.
    format: &'static str,
    own: &'static str,
    /// What the name of this file has instead.
    its: &'static str,
    /// Its keys of `[log]`, each with its column.
    keys: &'static [(&'static str, &'static str)],
}

const ARDUPILOT: &str = "ArduPilot (POS)";
const PX4: &str = "PX4 (vehicle_global_position)";
const OF_FILTER: &[(&str, &str)] = &[("north", "\"VN\""), ("east", "\"VE\""), ("up", "\"VD\", sign = -1")];

/// The files that are known. Of two with the same keys, the first that is there is taken.
const SIBLINGS: [Sibling; 5] = [
    Sibling {
        format: ARDUPILOT,
        own: "POS",
        its: "ATT",
        keys: &[("roll", "\"Roll\""), ("pitch", "\"Pitch\""), ("heading", "\"Yaw\"")],
    },
    Sibling { format: ARDUPILOT, own: "POS", its: "XKF1", keys: OF_FILTER },
    Sibling { format: ARDUPILOT, own: "POS", its: "NKF1", keys: OF_FILTER },
    Sibling {
        format: PX4,
        own: "vehicle_global_position",
        its: "vehicle_attitude",
        keys: &[("q0", "\"q[0]\""), ("q1", "\"q[1]\""), ("q2", "\"q[2]\""), ("q3", "\"q[3]\"")],
    },
    Sibling {
        format: PX4,
        own: "vehicle_global_position",
        its: "vehicle_local_position",
        keys: &[("north", "\"vx\""), ("east", "\"vy\""), ("up", "\"vz\", sign = -1")],
    },
];

/// Adds the keys of the files that are beside the log at `path`.
pub fn add(path: &Path, found: &mut Survey) {
    let name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
    for Sibling { format, own, its, keys } in SIBLINGS {
        let Some(at) = name.rfind(own).filter(|_| found.format == Some(format)) else { continue };
        let file = format!("{}{its}{}", &name[..at], &name[at + own.len()..]);
        let is_plain = !file.contains(['"', '\\', ':']) && !file.chars().any(char::is_control);
        let is_new = !found.text.lines().any(|line| line.starts_with(&format!("{} = ", keys[0].0)));
        if !(is_plain && is_new && path.with_file_name(&file).is_file()) {
            continue;
        }
        for (key, column) in keys {
            found.text += &format!("{key} = {{ col = {column}, file = \"{file}\" }}\n");
        }
        if matches!(keys[0].0, "roll" | "q0") {
            found.text = found.text.replace("attitude = \"coordinated\"\n", "");
            found.doubts.retain(|doubt| !doubt.contains("coordinated"));
        }
    }
}
