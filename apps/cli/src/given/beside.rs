//! Files beside a log, which its `[log]` names.

use std::io;
use std::path::{Path, PathBuf};

use sins::scene::excerpt;

use crate::failure::Failure;

/// The path of the file `name` beside the log at `path`: a plain file in the folder of the log, or in that to which a link to the log
/// leads. The text that names it may be another's, and a message can quote what was read.
pub fn beside(path: &Path, name: &str) -> Result<PathBuf, Failure> {
    if path == Path::new("-") {
        let what = format!("{} is looked for beside a file, not beside standard input", excerpt(name));
        return Err(Failure::of_file(path, &what));
    }
    let folder = path.parent().unwrap_or(Path::new(""));
    let beside = folder.join(name);
    let unread = |error: io::Error| Failure::of_input(&beside, &error);
    let place = beside.canonicalize().map_err(unread)?;
    let folders = [Path::new(".").join(folder).canonicalize(), path.canonicalize().map(in_folder)];
    if !folders.into_iter().flatten().any(|folder| in_folder(place.clone()) == folder) {
        return Err(Failure::of_file(
            &beside,
            &"is a link to another folder: expected a file beside the log",
        ));
    }
    // A pipe would wait for its other end.
    if !place.is_file() {
        return Err(Failure::of_file(&beside, &"is no plain file: expected one beside the log"));
    }
    Ok(beside)
}

fn in_folder(mut place: PathBuf) -> PathBuf {
    place.pop();
    place
}
