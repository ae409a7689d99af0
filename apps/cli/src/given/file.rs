//! Input files: opened, and texts as a whole.

use std::fs::File;
use std::io::{Cursor, Read};
use std::path::Path;

use sins::scene::MAX_TEXT;

use super::kind::FileKind;
use crate::failure::Failure;

/// Number of bytes that show what a file is.
pub const BEGIN: u64 = 4096;

/// Most bytes of a log or a record that is read as a whole: a pipe may have no end.
const MOST_BYTES: u64 = 1 << 34;

/// Opens an input; a device is rejected.
pub fn open(path: &Path) -> Result<File, Failure> {
    reject_device(path)?;
    File::open(path).map_err(|error| Failure::of_input(path, &error))
}

/// Rejects a device: it has no end, or waits for a keyboard.
fn reject_device(path: &Path) -> Result<(), Failure> {
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

/// The bytes of the log or record at `path`, as a whole.
pub fn read_whole(path: &Path, input: impl Read) -> Result<Vec<u8>, Failure> {
    read_at_most(MOST_BYTES, path, input)
}

fn read_at_most(most: u64, path: &Path, input: impl Read) -> Result<Vec<u8>, Failure> {
    let mut bytes = Vec::new();
    input.take(most + 1).read_to_end(&mut bytes).map_err(|error| Failure::of_input(path, &error))?;
    if bytes.len() as u64 > most {
        return Err(Failure::of_file(path, &format!("has more than {most} bytes")));
    }
    Ok(bytes)
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_input_without_an_end_is_rejected() {
        let read = |input: &mut dyn Read| read_at_most(4, Path::new("-"), input);
        assert_eq!(read(&mut &b"1234"[..]).unwrap(), b"1234");
        assert!(read(&mut std::io::repeat(b'1')).unwrap_err().to_string().ends_with("has more than 4 bytes"));
    }
}
