//! The reader of snapshots: bytes back to words.

use super::envelope::{SnapshotOf, open};
use super::writer::{BYTE, GROUP, NOTHING, WHOLE};
use crate::base::error::{Error, ErrorKind, Rule, Value};

/// Reads a snapshot.
pub(crate) struct Reader<'a> {
    rest: &'a [u8],
    /// Sizes of the words to come, lowest bits first.
    sizes: u16,
    /// Number of words for which there are sizes.
    left: usize,
    /// The name of what is being read, for messages.
    field: &'static str,
}

impl<'a> Reader<'a> {
    /// Reads a whole snapshot with `read`. All errors become errors of the snapshot, except for missing memory.
    pub fn read<T>(
        snapshot: &'a [u8],
        of: SnapshotOf,
        read: impl FnOnce(&mut Self) -> Result<T, Error>,
    ) -> Result<T, Error> {
        let mut from = Self { rest: open(snapshot, of)?, sizes: 0, left: 0, field: "" };
        let made = read(&mut from).map_err(|error| match error.kind {
            ErrorKind::OutOfMemory => error,
            _ => Error { kind: ErrorKind::Snapshot, ..error },
        })?;
        if from.rest.is_empty() && from.sizes == 0 {
            return Ok(made);
        }
        let rule = Rule::Zero(": the snapshot has bytes after its end");
        Err(Error::of(ErrorKind::Snapshot, "snapshot bytes left over", from.rest.len(), rule))
    }

    /// Sets the name, in messages, of what is read next.
    pub fn enter(&mut self, field: &'static str) {
        self.field = field;
    }

    pub fn word(&mut self) -> Result<u64, Error> {
        if self.left == 0 {
            (self.sizes, self.left) = (u16::from_le_bytes(self.bytes()?), GROUP);
        }
        let size = self.sizes & 3;
        self.sizes >>= 2;
        self.left -= 1;
        let (word, smallest) = match size {
            NOTHING => (0, 0),
            BYTE => (u64::from(u8::from_le_bytes(self.bytes()?)), 1),
            WHOLE => (u64::from_le_bytes(self.bytes()?), 256),
            _ => return Err(self.refused(size, Rule::Sentence("is not a code for the size of a number"))),
        };
        if word < smallest {
            return Err(self.refused(word, Rule::Sentence("is not stored in its shortest form")));
        }
        Ok(word)
    }

    fn bytes<const N: usize>(&mut self) -> Result<[u8; N], Error> {
        let Some((bytes, rest)) = self.rest.split_first_chunk() else { return Err(self.ended()) };
        self.rest = rest;
        Ok(*bytes)
    }

    /// A count from 0 to `most`.
    pub fn count(&mut self, most: usize) -> Result<usize, Error> {
        let word = self.word()?;
        if word > most as u64 {
            return Err(self.refused(word, Rule::BetweenIntegers(0, most as u64)));
        }
        Ok(word as usize)
    }

    pub fn flag(&mut self) -> Result<bool, Error> {
        Ok(self.count(1)? == 1)
    }

    /// Number of bytes to come.
    pub fn bytes_left(&self) -> usize {
        self.rest.len()
    }

    /// Rejects `value` of the current field if it is not `good`.
    pub fn require(&self, good: bool, value: f64, words: &'static str) -> Result<(), Error> {
        if good { Ok(()) } else { Err(self.refused(value, Rule::Sentence(words))) }
    }

    /// The error of a value of the current field that breaks `rule`.
    pub fn refused(&self, value: impl Into<Value>, rule: Rule) -> Error {
        Error::of(ErrorKind::Snapshot, self.field, value, rule)
    }

    fn ended(&self) -> Error {
        let rule = Rule::Sentence("the snapshot ends before it");
        Error { value: None, ..self.refused(0.0, rule) }
    }
}

/// For the model checker Kani, as in `abi::boundary::key`. Untried.
#[cfg(kani)]
mod proofs {
    use super::*;

    /// Every header of a group before any bytes: a word has the size that the header states, in its shortest form, or is rejected.
    #[kani::proof]
    #[kani::unwind(9)]
    fn every_header_of_a_group_is_read_or_rejected() {
        let bytes: [u8; 2 + 8 * GROUP] = kani::any();
        let length: usize = kani::any();
        kani::assume(length <= bytes.len());
        let mut from = Reader { rest: &bytes[..length], sizes: 0, left: 0, field: "" };
        for place in 0..GROUP {
            let Ok(word) = from.word() else { return };
            match u16::from_le_bytes([bytes[0], bytes[1]]) >> (2 * place) & 3 {
                NOTHING => assert!(word == 0),
                BYTE => assert!((1..256).contains(&word)),
                size => assert!(size == WHOLE && word >= 256),
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::envelope::{HEADER_BYTES, seal};
    use super::super::writer::Writer;
    use super::*;

    const OF: SnapshotOf = SnapshotOf::Unit;

    /// A sealed snapshot of one group: each word has its least value for its size, or `below` that.
    fn group(sizes: u16, below: u64) -> Vec<u8> {
        let mut bytes = vec![0; HEADER_BYTES];
        bytes.extend(sizes.to_le_bytes());
        for place in 0..GROUP {
            match sizes >> (2 * place) & 3 {
                BYTE => bytes.push((1 - below) as u8),
                WHOLE => bytes.extend((256 - below).to_le_bytes()),
                _ => {}
            }
        }
        seal(&mut bytes, OF);
        bytes
    }

    fn words(snapshot: &[u8]) -> Result<[u64; GROUP], Error> {
        Reader::read(snapshot, OF, |from| {
            let mut words = [0; GROUP];
            for word in &mut words {
                *word = from.word()?;
            }
            Ok(words)
        })
    }

    /// Every header of a group: it is rejected, or its words are written back as the same bytes.
    #[test]
    fn every_header_of_a_group_is_read_or_rejected() {
        for sizes in 0..=u16::MAX {
            let codes = [0, 1, 2, 3, 4, 5, 6, 7].map(|place| sizes >> (2 * place) & 3);
            let snapshot = group(sizes, 0);
            let Ok(words) = words(&snapshot) else {
                assert!(codes.contains(&3), "{sizes:04x}");
                continue;
            };
            assert_eq!(words, codes.map(|code| [0, 1, 256][usize::from(code)]));
            let mut again = vec![0; snapshot.len()];
            let mut writer = Writer::new(&mut again, OF);
            words.iter().for_each(|word| writer.word(*word));
            assert_eq!((writer.finish(), again), (snapshot.len(), snapshot), "{sizes:04x}");
        }
    }

    /// No word has a second form, and nothing follows the last.
    #[test]
    fn every_header_of_longer_forms_is_rejected() {
        for sizes in 1..=u16::MAX {
            assert!(words(&group(sizes, 1)).is_err(), "{sizes:04x}");
        }
        for bytes in 1..20 {
            let mut snapshot = group(0, 0);
            snapshot.extend(vec![0; bytes]);
            seal(&mut snapshot, OF);
            assert!(words(&snapshot).is_err(), "{bytes}");
        }
    }
}
