//! The files that the program writes: complete or not at all, never one of its inputs, and never a file of another program.
//!
//! Each file is written to a temporary file in the same folder, with an unpredictable name, and renamed at the end. So a
//! half-written file is never visible, and two runs of one name leave the file of one of them. A temporary file is locked while it is
//! written: without a lock it is one of a program that was killed, and the next output into the folder removes it. An existing file is replaced if it
//! has the mark of the program's own files; any other file needs `--force`. A device, a FIFO or a link is never replaced.

use std::fs::{File, Metadata};
use std::io::{BufWriter, ErrorKind, Read, Write};
use std::path::{Path, PathBuf};
use std::rc::Rc;

use tempfile::{Builder, NamedTempFile, TempPath};

use crate::failure::{Failure, Kind};
use crate::interrupt::Temporary;

/// Length of the beginning of a file in which the mark of this program must be [bytes].
const MARK_WITHIN: u64 = 4096;

/// Beginning and end of the name of a temporary file.
const PREFIX: &str = ".sins-";
const SUFFIX: &str = ".part";

/// Outputs of a run of the program, with the rules for replacing files.
#[derive(Debug, Default)]
pub struct Outputs {
    rules: Rc<Rules>,
    /// Outputs that this run has opened.
    taken: Vec<PathBuf>,
}

/// Rules for replacing existing files.
#[derive(Debug, Default)]
struct Rules {
    inputs: Vec<(PathBuf, Identity)>,
    force: bool,
}

/// Identity of a file, the same for all its names and links.
#[derive(Debug, PartialEq)]
struct Identity {
    device: u64,
    index: u64,
}

impl Identity {
    #[cfg(unix)]
    fn of(path: &Path) -> Option<Self> {
        use std::os::unix::fs::MetadataExt;
        // Standard input is a file too if it was redirected.
        let path = if path == Path::new("-") { Path::new("/dev/stdin") } else { path };
        let metadata = std::fs::metadata(path).ok()?;
        Some(Self { device: metadata.dev(), index: metadata.ino() })
    }

    #[cfg(windows)]
    fn of(path: &Path) -> Option<Self> {
        use winapi_util::{HandleRef, file::information};
        let information = if path == Path::new("-") {
            information(HandleRef::stdin())
        } else {
            information(&File::open(path).ok()?)
        };
        let information = information.ok()?;
        Some(Self { device: information.volume_serial_number(), index: information.file_index() })
    }
}

impl Outputs {
    /// `inputs` are never replaced; with `force`, files that this program did not write are replaced.
    pub fn new(inputs: &[PathBuf], force: bool) -> Self {
        let identified = inputs.iter().filter_map(|path| Some((path.clone(), Identity::of(path)?)));
        Self { rules: Rc::new(Rules { inputs: identified.collect(), force }), taken: Vec::new() }
    }

    /// Makes the folder `path` and the folders above it.
    pub fn folder(&self, path: &Path) -> Result<(), Failure> {
        std::fs::create_dir_all(path).map_err(|error| {
            Failure::of_kind(Kind::Failed, format!("{}: the folder cannot be made: {error}", path.display()))
        })
    }

    /// Whether no file has this name: none that exists, unless with `force`, and none of these outputs.
    pub fn is_free(&self, path: &Path) -> bool {
        let is_taken = self.taken.iter().any(|taken| taken.file_name() == path.file_name());
        !is_taken && (self.rules.force || !path.exists())
    }

    /// A file to be written. An existing file is replaced if it has `mark` near its beginning.
    pub fn file(&mut self, path: &Path, mark: &str) -> Result<OutputFile, Failure> {
        let folder = match path.parent() {
            Some(folder) if folder != Path::new("") => folder,
            _ => Path::new("."),
        };
        let Some(name) = path.file_name() else {
            return Err(Failure::new(format!("{}: expected the name of a file", path.display())));
        };
        if let Some(why) = unfit(&name.to_string_lossy()) {
            return Err(Failure::of_file(path, &why));
        }
        let folder_itself = folder.canonicalize().map_err(|error| Failure::of_output(path, &error))?;
        let place = folder_itself.join(name);
        if self.taken.iter().any(|taken| is_same(taken, &place)) {
            return Err(Failure::new(format!("{}: two outputs have this name", path.display())));
        }
        self.rules.check(path, mark)?;
        let mut temporary = Temporary::lock();
        let mut builder = Builder::new();
        builder.prefix(PREFIX).suffix(SUFFIX);
        #[cfg(unix)]
        {
            use std::os::unix::fs::PermissionsExt;
            // The permissions of any new file: the user's mask is applied.
            builder.permissions(std::fs::Permissions::from_mode(0o666));
        }
        remove_abandoned(&folder_itself);
        let file = locked(&builder, &folder_itself).map_err(|error| Failure::of_output(path, &error))?;
        temporary.add(file.path());
        self.taken.push(place);
        let (file, temporary) = file.into_parts();
        Ok(OutputFile {
            path: path.to_owned(),
            writer: Some((BufWriter::new(file), temporary)),
            mark: mark.to_owned(),
            rules: Rc::clone(&self.rules),
        })
    }

    /// Writes a whole file.
    pub fn write(&mut self, path: &Path, mark: &str, text: &str) -> Result<(), Failure> {
        self.file(path, mark)?.finish(text)
    }
}

/// A temporary file with the lock of its program. Another program may have removed the file before it was locked.
fn locked(builder: &Builder<'_, '_>, folder: &Path) -> std::io::Result<NamedTempFile> {
    loop {
        let file = builder.tempfile_in(folder)?;
        // A file system without locks: no file is taken for abandoned there.
        let is_locked = file.as_file().lock().is_ok();
        if !is_locked || file.path().exists() {
            return Ok(file);
        }
    }
}

/// Removes the temporary files of programs that were killed: nobody holds their locks.
fn remove_abandoned(folder: &Path) {
    for entry in std::fs::read_dir(folder).into_iter().flatten().flatten() {
        let name = entry.file_name();
        let name = name.to_string_lossy();
        let is_ours = name.starts_with(PREFIX) && name.ends_with(SUFFIX);
        if is_ours
            && entry.file_type().is_ok_and(|kind| kind.is_file())
            && let Ok(file) = File::open(entry.path())
            && file.try_lock().is_ok()
        {
            let _ = std::fs::remove_file(entry.path());
        }
    }
}

impl Rules {
    /// Checks that `path` may be written.
    fn check(&self, path: &Path, mark: &str) -> Result<(), Failure> {
        let metadata = match std::fs::symlink_metadata(path) {
            Ok(metadata) => metadata,
            Err(error) if error.kind() == ErrorKind::NotFound => return Ok(()),
            Err(error) => return Err(Failure::of_output(path, &error)),
        };
        let identity = Identity::of(path);
        if let Some((input, _)) = self.inputs.iter().find(|(_, input)| Some(input) == identity.as_ref()) {
            let what = format!("is the input {}; choose another name for the output", input.display());
            return Err(Failure::of_file(path, &what));
        }
        if !metadata.is_file() {
            let what = format!("is {}: only plain files are replaced", kind_of(&metadata));
            return Err(Failure::of_file(path, &what));
        }
        if !self.force && metadata.len() > 0 && !is_own(path, mark) {
            // A file without a mark, such as a scene, is edited by users.
            let what = match mark {
                "" => "exists already; --force replaces it",
                _ => "exists already, and this program did not write it; --force replaces it",
            };
            return Err(Failure::of_file(path, &what));
        }
        Ok(())
    }
}

/// Whether the paths are the same; on Windows without regard to case.
fn is_same(one: &Path, other: &Path) -> bool {
    if cfg!(windows) {
        one.to_string_lossy().to_lowercase() == other.to_string_lossy().to_lowercase()
    } else {
        one == other
    }
}

/// Reason why no file can have this name, or `None`. On Windows some names are devices, whatever their ending, and a colon selects
/// another stream of a file.
fn unfit(name: &str) -> Option<&'static str> {
    if !cfg!(windows) {
        None
    } else if is_device_of_windows(name) {
        Some("is the name of a device of Windows, whatever its ending")
    } else if name.contains(':') {
        Some("no file has a colon in its name on Windows")
    } else {
        None
    }
}

/// Whether Windows treats a file of this name as a device.
pub fn is_device_of_windows(name: &str) -> bool {
    let stem = name.split(['.', ':']).next().unwrap_or_default().trim_end().to_uppercase();
    let numbered = ["COM", "LPT"].iter().find_map(|port| stem.strip_prefix(port));
    let is_port = numbered.is_some_and(|number| {
        let mut digits = number.chars();
        digits.next().is_some_and(|digit| matches!(digit, '0'..='9' | '¹' | '²' | '³'))
            && digits.next().is_none()
    });
    is_port || ["CON", "PRN", "AUX", "NUL", "CONIN$", "CONOUT$"].contains(&stem.as_str())
}

fn kind_of(metadata: &Metadata) -> &'static str {
    match metadata {
        metadata if metadata.is_dir() => "a folder",
        metadata if metadata.is_symlink() => "a link",
        _ => "a device or a pipe",
    }
}

/// Whether the file has `mark` near its beginning, as files that the program wrote.
fn is_own(path: &Path, mark: &str) -> bool {
    let mut begin = Vec::new();
    let read = File::open(path).and_then(|file| file.take(MARK_WITHIN).read_to_end(&mut begin));
    read.is_ok() && !mark.is_empty() && begin.windows(mark.len()).any(|part| part == mark.as_bytes())
}

/// A file that is being written; without [`Self::commit`] it is removed.
#[derive(Debug)]
pub struct OutputFile {
    path: PathBuf,
    /// `None` after the file is finished.
    writer: Option<(BufWriter<File>, TempPath)>,
    mark: String,
    rules: Rc<Rules>,
}

impl OutputFile {
    /// Path of the finished file.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Writes buffered data to the disk, and reports an error of the disk.
    pub fn check(&mut self) -> Result<(), Failure> {
        self.flush().map_err(|error| Failure::of_output(&self.path, &error))
    }

    /// Puts the file in place.
    pub fn commit(mut self) -> Result<(), Failure> {
        self.check()?;
        // Another program may have put a file there in the meantime.
        self.rules.check(&self.path, &self.mark)?;
        // The file is locked until it has its name.
        let Some((_writer, temporary)) = self.writer.take() else { return Ok(()) };
        let mut list = Temporary::lock();
        list.forget(&temporary);
        temporary.persist(&self.path).map_err(|error| Failure::of_output(&self.path, &error.error))
    }

    /// Writes `content` and puts the file in place.
    pub fn finish(mut self, content: impl AsRef<[u8]>) -> Result<(), Failure> {
        self.write_all(content.as_ref()).map_err(|error| Failure::of_output(&self.path, &error))?;
        self.commit()
    }
}

impl Write for OutputFile {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        match &mut self.writer {
            Some((writer, _)) => writer.write(bytes),
            None => Err(ErrorKind::BrokenPipe.into()),
        }
    }

    fn flush(&mut self) -> std::io::Result<()> {
        self.writer.as_mut().map_or(Ok(()), |(writer, _)| writer.flush())
    }
}

impl Drop for OutputFile {
    fn drop(&mut self) {
        if let Some((_, temporary)) = self.writer.take() {
            let mut list = Temporary::lock();
            list.forget(&temporary);
            drop(temporary);
        }
    }
}

#[cfg(test)]
mod tests;
