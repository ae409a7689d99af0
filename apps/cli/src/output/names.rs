//! Names of files: what no file can be called, which numbers distinguish files, and what stands there already.

use std::fs::{File, Metadata};
use std::path::{Path, PathBuf};

/// Identity of a file, the same for all its names and links.
#[derive(Debug, PartialEq)]
pub struct Identity {
    device: u64,
    index: u64,
}

impl Identity {
    /// The file at `path`; "-" is standard input, which is a file too if it was redirected.
    #[cfg(unix)]
    pub fn of(path: &Path) -> Option<Self> {
        use std::os::unix::fs::MetadataExt;
        let path = if path == Path::new("-") { Path::new("/dev/stdin") } else { path };
        let metadata = std::fs::metadata(path).ok()?;
        Some(Self { device: metadata.dev(), index: metadata.ino() })
    }

    #[cfg(unix)]
    pub fn of_open(file: &File) -> Option<Self> {
        use std::os::unix::fs::MetadataExt;
        let metadata = file.metadata().ok()?;
        Some(Self { device: metadata.dev(), index: metadata.ino() })
    }

    /// The file at `path`; "-" is standard input, which is a file too if it was redirected.
    #[cfg(windows)]
    pub fn of(path: &Path) -> Option<Self> {
        use winapi_util::{HandleRef, file::information};
        if path == Path::new("-") {
            return information(HandleRef::stdin()).ok().as_ref().map(Self::in_information);
        }
        Self::of_open(&File::open(path).ok()?)
    }

    #[cfg(windows)]
    pub fn of_open(file: &File) -> Option<Self> {
        winapi_util::file::information(file).ok().as_ref().map(Self::in_information)
    }

    #[cfg(windows)]
    fn in_information(information: &winapi_util::file::Information) -> Self {
        Self { device: information.volume_serial_number(), index: information.file_index() }
    }
}

/// `path` with a number behind the name, from 2; the number 1 is `path` itself.
pub fn numbered(path: &Path, number: u64) -> PathBuf {
    if number == 1 {
        return path.to_owned();
    }
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    let ending = path.extension().map_or(String::new(), |ending| format!(".{}", ending.to_string_lossy()));
    path.with_file_name(format!("{stem}_{number}{ending}"))
}

/// Whether the paths are the same; on Windows without regard to case.
pub fn is_same(one: &Path, other: &Path) -> bool {
    if cfg!(windows) {
        one.to_string_lossy().to_lowercase() == other.to_string_lossy().to_lowercase()
    } else {
        one == other
    }
}

/// Reason why no file can have this name, or `None`. On Windows some names are devices, whatever their ending, and a colon selects
/// another stream of a file.
pub fn unfit(name: &str) -> Option<&'static str> {
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

pub fn kind_of(metadata: &Metadata) -> &'static str {
    match metadata {
        metadata if metadata.is_dir() => "a folder",
        metadata if metadata.is_symlink() => "a link",
        _ => "a device or a pipe",
    }
}
