//! A part: the file that is written until an output is whole. It stands beside the output and is called `.sins-NAME.part`.
//!
//! It is made exclusively, so it also reserves the name of the output: of two runs of the program at the same time, the second is
//! refused. While it is written, it is locked and has [`SIGNATURE`] in the place of its own first bytes. A part that nobody has locked
//! is one of a program that was killed: the next output into the folder removes it. A file without the signature is never removed.

use std::ffi::OsString;
use std::fs::File;
use std::io::{self, BufWriter, ErrorKind, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::time::Duration;

use tempfile::{Builder, TempPath};

use super::names::Identity;
use crate::interrupt::Temporary;

/// Beginning and end of the name of a part.
const PREFIX: &str = ".sins-";
const SUFFIX: &str = ".part";

/// The first bytes of a part.
const SIGNATURE: &[u8] = b"# unfinished output of sins\n";

/// How often, and after which wait, a file without the signature is looked at again: its program may be about to write it.
const LOOKS: usize = 10;
const WAIT: Duration = Duration::from_millis(20);

/// Number of bytes that are read at once where the last line is searched.
const BLOCK: u64 = 4096;

/// Why there can be no part.
pub enum Taken {
    /// A running program writes the output into this part.
    Running(PathBuf),
    /// A file that is no part has its name.
    InTheWay(PathBuf),
    Disk(io::Error),
}

/// A file that is being written. It is removed if it is dropped before it has its name.
#[derive(Debug)]
pub struct Part {
    /// `None` when it has its name. Dropped before the writer, whose lock keeps others away.
    listed: Option<Listed>,
    writer: BufWriter<File>,
    /// The first bytes of the output, which are written last.
    held: Vec<u8>,
    /// The first error of the disk, in words.
    refused: Option<String>,
}

impl Part {
    /// The part of the output at `place`.
    pub fn open(place: &Path) -> Result<Self, Taken> {
        let folder = place.parent().unwrap_or(Path::new("."));
        let mut prefix = OsString::from(PREFIX);
        prefix.push(place.file_name().unwrap_or_default());
        let mut name = prefix.clone();
        name.push(SUFFIX);
        let path = folder.join(name);
        let mut list = Temporary::lock();
        remove_abandoned_in(folder);
        let mut builder = Builder::new();
        builder.prefix(&prefix).suffix(SUFFIX).rand_bytes(0);
        #[cfg(unix)]
        {
            use std::os::unix::fs::PermissionsExt;
            // The permissions of any new file: the user's mask is applied.
            builder.permissions(std::fs::Permissions::from_mode(0o666));
        }
        let mut looks = 0;
        let (mut file, temporary) = loop {
            match builder.tempfile_in(folder) {
                Ok(file) => break file.into_parts(),
                Err(error) if error.kind() == ErrorKind::AlreadyExists => match remove_abandoned(&path) {
                    Found::Nothing => {}
                    Found::Running => return Err(Taken::Running(path)),
                    Found::Another if looks == LOOKS => return Err(Taken::InTheWay(path)),
                    Found::Another => std::thread::sleep(WAIT),
                },
                Err(error) => return Err(Taken::Disk(error)),
            }
            looks += 1;
        };
        // A file system may have no locks. Then no part is taken for abandoned there.
        let _ = file.lock();
        list.add(&temporary);
        drop(list);
        let listed = Some(Listed(Some(temporary)));
        file.write_all(SIGNATURE).map_err(Taken::Disk)?;
        Ok(Self { listed, writer: BufWriter::new(file), held: Vec::new(), refused: None })
    }

    /// Takes `size` bytes of the disk, so that so many bytes can be written later even if the disk is full.
    pub fn reserve(&mut self, size: usize) -> io::Result<()> {
        let place = self.writer.stream_position()?;
        self.writer.write_all(&vec![b' '; size])?;
        self.writer.seek(SeekFrom::Start(place))?;
        Ok(())
    }

    /// The first error of the disk, in words; `None`: it has taken all bytes.
    pub fn refused(&self) -> Option<&str> {
        self.refused.as_deref()
    }

    /// Ends the file behind the last whole line that the disk has taken. Number of lines that this leaves out.
    pub fn cut(&mut self) -> io::Result<u64> {
        // Another writer, without what the disk has refused.
        let writer = BufWriter::new(self.writer.get_ref().try_clone()?);
        let (mut file, rest) = std::mem::replace(&mut self.writer, writer).into_parts();
        let left_out = rest.unwrap_or_default().iter().filter(|byte| **byte == b'\n').count();
        let first = if self.listed.is_some() { SIGNATURE.len() as u64 } else { 0 };
        let end = match last_line_end(&mut file, first)? {
            Some(end) => end,
            None => {
                let held = self.held.iter().rposition(|byte| *byte == b'\n').map_or(0, |newline| newline + 1);
                self.held.truncate(held);
                first
            }
        };
        file.set_len(end)?;
        file.seek(SeekFrom::Start(end))?;
        Ok(left_out as u64)
    }

    /// Gives the file its name. Unless `may_replace`, no file may have it. What is written later stands in that file.
    pub fn place(&mut self, path: &Path, may_replace: bool) -> io::Result<()> {
        self.complete()?;
        let Some(listed) = &mut self.listed else { return Ok(()) };
        // The file is locked until it has its name.
        listed.persist(path, may_replace)?;
        self.listed = None;
        // Others may read it from now on.
        let _ = self.writer.get_ref().unlock();
        Ok(())
    }

    /// Whether the file has its name.
    pub fn is_placed(&self) -> bool {
        self.listed.is_none()
    }

    /// Writes what is in the buffer, and the first bytes.
    fn complete(&mut self) -> io::Result<()> {
        let end = self.writer.stream_position()?;
        self.writer.flush()?;
        if self.listed.is_none() {
            return Ok(());
        }
        let size = if self.held.len() < SIGNATURE.len() { self.held.len() as u64 } else { end };
        self.writer.seek(SeekFrom::Start(0))?;
        self.writer.write_all(&self.held)?;
        self.writer.seek(SeekFrom::Start(size))?;
        self.writer.get_ref().set_len(size)
    }
}

impl Write for Part {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let room = SIGNATURE.len() - self.held.len();
        if room > 0 && self.listed.is_some() {
            let (held, _) = bytes.split_at(room.min(bytes.len()));
            self.held.extend(held);
            return Ok(held.len());
        }
        self.writer.write(bytes).inspect_err(|error| note(&mut self.refused, error))
    }

    fn flush(&mut self) -> io::Result<()> {
        self.writer.flush().inspect_err(|error| note(&mut self.refused, error))
    }
}

fn note(refused: &mut Option<String>, error: &io::Error) {
    // The writer goes on after a signal.
    if error.kind() != ErrorKind::Interrupted {
        refused.get_or_insert_with(|| error.to_string());
    }
}

/// The path of a part, in the list of files that a signal removes. The file is removed when it is dropped.
#[derive(Debug)]
struct Listed(Option<TempPath>);

impl Listed {
    fn persist(&mut self, path: &Path, may_replace: bool) -> io::Result<()> {
        let mut list = Temporary::lock();
        let Some(temporary) = self.0.take() else { return Ok(()) };
        list.forget(&temporary);
        let placed = match may_replace {
            true => temporary.persist(path),
            false => temporary.persist_noclobber(path).or_else(|error| match error.error.kind() {
                // Not every file system can do both in one call.
                kind if kind != ErrorKind::AlreadyExists && std::fs::symlink_metadata(path).is_err() => {
                    error.path.persist(path)
                }
                _ => Err(error),
            }),
        };
        placed.map_err(|error| {
            list.add(&error.path);
            self.0 = Some(error.path);
            error.error
        })
    }
}

impl Drop for Listed {
    fn drop(&mut self) {
        if let Some(temporary) = self.0.take() {
            let mut list = Temporary::lock();
            list.forget(&temporary);
            drop(temporary);
        }
    }
}

/// What has the name of a part.
enum Found {
    Nothing,
    /// A part that a running program writes.
    Running,
    /// A file that is no part.
    Another,
}

/// Removes the part at `path` if it is one of a program that was killed: it begins with the signature, and nobody has its lock.
fn remove_abandoned(path: &Path) -> Found {
    match std::fs::symlink_metadata(path) {
        Ok(metadata) if metadata.is_file() => {}
        Ok(_) => return Found::Another,
        Err(_) => return Found::Nothing,
    }
    let Ok(mut file) = File::open(path) else { return Found::Another };
    if file.try_lock().is_err() {
        return Found::Running;
    }
    // While it was opened, its program may have given it its name, and another may have begun a part.
    if Identity::of_open(&file) != Identity::of(path) {
        return Found::Nothing;
    }
    let mut begin = [0; SIGNATURE.len()];
    if file.read_exact(&mut begin).is_err() || begin != SIGNATURE {
        return Found::Another;
    }
    // Its lock is held until it is gone: no other program takes it for its own.
    let _ = std::fs::remove_file(path);
    Found::Nothing
}

/// Removes the parts of programs that were killed.
fn remove_abandoned_in(folder: &Path) {
    for entry in std::fs::read_dir(folder).into_iter().flatten().flatten() {
        let name = entry.file_name();
        let name = name.to_string_lossy();
        if name.starts_with(PREFIX) && name.ends_with(SUFFIX) {
            remove_abandoned(&entry.path());
        }
    }
}

/// The place behind the last line feed from `first` on.
fn last_line_end(file: &mut File, first: u64) -> io::Result<Option<u64>> {
    let mut end = file.stream_position()?;
    let mut block = Vec::new();
    while end > first {
        let begin = end.saturating_sub(BLOCK).max(first);
        block.resize((end - begin) as usize, 0);
        file.seek(SeekFrom::Start(begin))?;
        file.read_exact(&mut block)?;
        if let Some(newline) = block.iter().rposition(|byte| *byte == b'\n') {
            return Ok(Some(begin + newline as u64 + 1));
        }
        end = begin;
    }
    Ok(None)
}
