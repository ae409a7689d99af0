//! Files of other kinds than a command expects: what they are, by their beginning.

use std::io::Read;
use std::path::Path;

use sins::log::{decoded, foreign};

use super::file::{BEGIN, open};

/// What a file is; `None`: nobody knows, or it is what it is taken for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FileKind {
    /// Records of `sins fly`.
    Records,
    /// Another file of this program, in words.
    Own(&'static str),
    /// A file of another program.
    Foreign(sins::log::Foreign),
}

/// The beginnings of the files of this program.
const OWN: [(&[u8], FileKind); 5] = [
    (b"sins ensemble checkpoint", FileKind::Own("a checkpoint of sins ensemble")),
    (b"key,value,unit,label", FileKind::Own("a summary of sins fly")),
    (b"time_s,truth_latitude_rad", FileKind::Records),
    (b"time_s,error_data,runs,", FileKind::Own("a table of sins ensemble, which has a page of its own")),
    (b"time_s,update_s,part,parts", FileKind::Own("increments of sins fly, which sins allan reads")),
];

impl FileKind {
    /// What the file with this beginning is.
    pub fn of(begin: &[u8]) -> Option<Self> {
        let own = OWN.iter().find(|(mark, _)| begin.starts_with(mark)).map(|(_, kind)| *kind);
        own.or_else(|| foreign(begin).map(Self::Foreign))
    }
}

impl std::fmt::Display for FileKind {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Records => f.write_str("records of sins fly, which sins report draws"),
            Self::Own(what) => f.write_str(what),
            Self::Foreign(kind) => kind.fmt(f),
        }
    }
}

/// Whether the bytes of a file are a flight record.
pub fn is_record(file: &[u8]) -> bool {
    decoded(file).is_ok_and(|text| foreign(text.as_bytes()).is_some_and(sins::log::Foreign::is_record))
}

/// Whether the file at `path` is a flight record, by its beginning.
pub fn is_record_at(path: &Path) -> bool {
    let mut begin = Vec::new();
    let is_read =
        path.is_file() && open(path).is_ok_and(|file| file.take(BEGIN).read_to_end(&mut begin).is_ok());
    is_read && is_record(&begin)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn own_files_are_known_and_logs_are_none() {
        for (mark, kind) in OWN {
            assert_eq!(FileKind::of(&[mark, b",x\n"].concat()), Some(kind));
        }
        assert_eq!(FileKind::of(b"time_s,latitude_rad\n"), None);
        assert_eq!(FileKind::of(b"%PDF").unwrap().to_string(), "a document (PDF)");
    }
}
