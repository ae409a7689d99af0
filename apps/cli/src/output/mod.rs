//! The files that the program writes: complete or not at all, never one of its inputs, and never a file of another program.
//!
//! Each file is a [`part`] until it is complete, so a half-written file is never visible, and a second run that would write it at
//! the same time is refused. An existing file is replaced if it has the mark of the program's own files; any other file needs `--force`.
//! A device, a FIFO or a link is never replaced. A file that cannot have its name at the end gets a free one.

mod names;
mod part;

use std::fs::File;
use std::io::{ErrorKind, Read, Write};
use std::path::{Path, PathBuf};
use std::rc::Rc;

use crate::failure::{Failure, Kind};
use names::{Identity, is_same, kind_of, unfit};
use part::{Part, Taken};

#[cfg(any(windows, test))]
pub use names::is_device_of_windows;
pub use names::numbered;

/// Length of the beginning of a file in which the mark of this program must be [bytes].
const MARK_WITHIN: u64 = 4096;

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

/// The mark of files that their users edit: none has it, so they are replaced by `--force` only.
pub const NO_MARK: &str = "\0";

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

    /// Makes the folder of an output.
    pub fn folder_of(&self, path: &Path) -> Result<(), Failure> {
        path.parent().map_or(Ok(()), |folder| self.folder(folder))
    }

    /// A file to be written. An existing file is replaced if it has `mark` near its beginning.
    pub fn file(&mut self, path: &Path, mark: &str) -> Result<OutputFile, Failure> {
        let place = place(path)?;
        if self.is_taken(&place) {
            return Err(Failure::new(format!("{}: two outputs have this name", path.display())));
        }
        self.rules.check(path, mark)?;
        match self.open(path, place, mark) {
            Ok(file) => Ok(file),
            Err(Taken::Running(part)) => {
                let what = format!(
                    "another run of sins is writing it, into {}; choose another name",
                    part.display()
                );
                Err(Failure::of_file(path, &what))
            }
            Err(taken) => Err(refused(path, taken)),
        }
    }

    /// A file that takes the place of no other, without `--force`; `None`: there is one, or another run is writing it.
    pub fn new_file(&mut self, path: &Path, mark: &str) -> Result<Option<OutputFile>, Failure> {
        let place = place(path)?;
        if self.is_taken(&place) || !self.rules.force && std::fs::symlink_metadata(path).is_ok() {
            return Ok(None);
        }
        self.rules.check(path, mark)?;
        match self.open(path, place, mark) {
            Ok(file) => Ok(Some(OutputFile { is_new: !self.rules.force, ..file })),
            Err(Taken::Running(_)) => Ok(None),
            Err(taken) => Err(refused(path, taken)),
        }
    }

    /// Writes a whole file.
    pub fn write(&mut self, path: &Path, mark: &str, text: &str) -> Result<(), Failure> {
        self.file(path, mark)?.finish(text)
    }

    /// Whether this run has opened an output there.
    fn is_taken(&self, place: &Path) -> bool {
        self.taken.iter().any(|taken| is_same(taken, place))
    }

    fn open(&mut self, path: &Path, place: PathBuf, mark: &str) -> Result<OutputFile, Taken> {
        let part = Part::open(&place)?;
        self.taken.push(place);
        let (mark, rules) = (mark.to_owned(), Rc::clone(&self.rules));
        Ok(OutputFile { path: path.to_owned(), part, mark, rules, is_new: false })
    }
}

/// The place of an output with the name `path`, if a file can have the name.
fn place(path: &Path) -> Result<PathBuf, Failure> {
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
    let folder = folder.canonicalize().map_err(|error| Failure::of_output(path, &error))?;
    Ok(folder.join(name))
}

fn refused(path: &Path, taken: Taken) -> Failure {
    match taken {
        Taken::Disk(error) => Failure::of_output(path, &error),
        Taken::Running(part) | Taken::InTheWay(part) => {
            let what = format!("{} is in the way: this program did not write it", part.display());
            Failure::of_file(path, &what)
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
    part: Part,
    mark: String,
    rules: Rc<Rules>,
    /// Whether it takes the place of no other file.
    is_new: bool,
}

impl OutputFile {
    /// Path of the finished file.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Takes `size` bytes of the disk, so that so many bytes can be written later even if the disk is full.
    pub fn reserve(&mut self, size: usize) -> Result<(), Failure> {
        self.part.reserve(size).map_err(|error| Failure::of_output(&self.path, &error))
    }

    /// Writes buffered data to the disk, and reports an error of the disk.
    pub fn check(&mut self) -> Result<(), Failure> {
        // The first error is remembered.
        let _ = self.flush();
        self.part.refused().map_or(Ok(()), |why| Err(Failure::of_output(&self.path, &why)))
    }

    /// Writes buffered data to the disk. If the disk does not take all, the file ends behind the last whole line that it has taken. Number
    /// of lines that this leaves out.
    pub fn settle(&mut self) -> u64 {
        match self.check() {
            Ok(()) => 0,
            Err(_) => self.part.cut().unwrap_or_default(),
        }
    }

    /// Puts the file in place. What is written later stands in it.
    pub fn publish(&mut self) -> Result<(), Failure> {
        if self.part.is_placed() {
            return Ok(());
        }
        let checked = self.rules.check(&self.path, &self.mark);
        let placed = checked.and_then(|()| {
            let placed = self.part.place(&self.path, !self.is_new);
            placed.map_err(|error| Failure::of_output(&self.path, &error))
        });
        let Err(failure) = placed else { return Ok(()) };
        // Another program has put a file there in the meantime, or does not let it go: nothing that was computed is lost.
        let free = (2..1000).map(|number| numbered(&self.path, number));
        for path in free {
            match self.part.place(&path, false) {
                Ok(()) => {
                    let sentence = format!("{failure}; what was to be written is {}", path.display());
                    self.path = path;
                    return Err(Failure::of_kind(Kind::Unwritten, sentence));
                }
                Err(error) if error.kind() == ErrorKind::AlreadyExists => {}
                Err(_) => break,
            }
        }
        Err(Failure::of_kind(Kind::Unwritten, failure.to_string()))
    }

    /// Puts the file in place, if the disk has taken all of it.
    pub fn commit(mut self) -> Result<(), Failure> {
        self.check()?;
        self.publish()?;
        self.check()
    }

    /// Puts a file of lines in place with all lines that the disk has taken, and reports an error of the disk.
    pub fn commit_lines(mut self) -> Result<(), Failure> {
        self.settle();
        self.publish()?;
        self.check().map_err(|failure| failure.with(&"what was written before is kept"))
    }

    /// Writes `content` and puts the file in place.
    pub fn finish(mut self, content: impl AsRef<[u8]>) -> Result<(), Failure> {
        self.write_all(content.as_ref()).map_err(|error| Failure::of_output(&self.path, &error))?;
        self.commit()
    }
}

impl Write for OutputFile {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        self.part.write(bytes)
    }

    fn flush(&mut self) -> std::io::Result<()> {
        self.part.flush()
    }
}

#[cfg(test)]
mod tests;
