//! Input files: opened, and texts as a whole.

use std::fs::File;
use std::io::{Cursor, Read};
use std::path::Path;

use sins::scene::MAX_TEXT;

use super::kind::FileKind;
use crate::failure::Failure;

/// Number of bytes that show what a file is.
pub const BEGIN: u64 = 4096;

/// Opens an input; a device is rejected.
pub fn open(path: &Path) -> Result<File, Failure> {
    reject_device(path)?;
    File::open(path).map_err(|error| Failure::of_input(path, &error))
}

/// Rejects a device: it has no end, or waits for a keyboard.
pub fn reject_device(path: &Path) -> Result<(), Failure> {
    if is_device(path) {
        return Err(Failure::of_file(path, &"is a device: expected a file or a pipe"));
    }
    Ok(())
}

fn is_device(path: &Path) -> bool {
    #[cfg(unix)]
    {
        use std::os::unix::fs::FileTypeExt;
        let is_one = |metadata: std::fs::Metadata| {
            metadata.file_type().is_char_device() || metadata.file_type().is_block_device()
        };
        std::fs::metadata(path).is_ok_and(is_one)
    }
    #[cfg(windows)]
    {
        path.file_name().is_some_and(|name| crate::output::is_device_of_windows(&name.to_string_lossy()))
    }
}

/// The text of a scene or of requirements, as a whole: a longer one is rejected, and not cut.
pub fn read_text(path: &Path) -> Result<Vec<u8>, Failure> {
    let mut bytes = Vec::new();
    let read = open(path)?.take(MAX_TEXT as u64 + 1).read_to_end(&mut bytes);
    read.map_err(|error| Failure::of_input(path, &error))?;
    if bytes.len() <= MAX_TEXT {
        return Ok(bytes);
    }
    Err(match FileKind::of(&bytes) {
        Some(what) => Failure::of_file(path, &format!("is {what}: expected a text in TOML")),
        None => {
            Failure::of_file(path, &format!("a text has at most {MAX_TEXT} bytes, and this one has more"))
        }
    })
}

/// Opens a table, unless its beginning shows that it is a file of another kind; "-" means standard input. The table, and its size, 0 for
/// a pipe [bytes].
pub fn open_table(path: &Path) -> Result<(impl Read + use<>, u64), Failure> {
    let (mut file, size): (Box<dyn Read>, u64) = if path == Path::new("-") {
        (Box::new(std::io::stdin().lock()), 0)
    } else {
        let file = open(path)?;
        let size = file.metadata().map_or(0, |metadata| metadata.len());
        (Box::new(file), size)
    };
    let mut begin = Vec::new();
    let read = (&mut file).take(BEGIN).read_to_end(&mut begin);
    read.map_err(|error| Failure::of_input(path, &error))?;
    match FileKind::of(&begin) {
        // The program's own tables have messages of their own.
        Some(what) if !begin.starts_with(b"time_s,") => {
            Err(Failure::of_file(path, &format!("is {what}: expected a table of comma-separated values")))
        }
        _ => Ok((Cursor::new(begin).chain(file), size)),
    }
}
