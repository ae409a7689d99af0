//! The header of a snapshot: its kind, version, length and checksum.

use crate::base::error::{Error, ErrorKind, Rule};
use crate::base::math::{SPLIT_MIX_STEP, mix};

/// Version of the format that this library writes, the only one so far.
pub const FORMAT_VERSION: u32 = 1;

/// Kinds of snapshots.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SnapshotOf {
    /// A snapshot of a simulator.
    Simulator,
    /// A snapshot of an ensemble.
    Ensemble,
    /// A snapshot of a unit.
    Unit,
    /// A snapshot of a scene in flight.
    Play,
}

impl SnapshotOf {
    fn magic(self) -> [u8; 8] {
        match self {
            Self::Simulator => *b"SINSsnap",
            Self::Ensemble => *b"SINSruns",
            Self::Unit => *b"SINSunit",
            Self::Play => *b"SINSplay",
        }
    }
}

/// Size of the header: magic, version, length and checksum [bytes].
pub(super) const HEADER_BYTES: usize = 24;

/// Place of the checksum [bytes].
const CHECKSUM: core::ops::Range<usize> = 16..24;

/// Writes magic, version, length and checksum into the first 24 bytes of a snapshot, before its words. Tests that alter words need
/// this. A shorter snapshot stays as it is.
pub fn seal(snapshot: &mut [u8], of: SnapshotOf) {
    let length = snapshot.len() as u32;
    let Some(header) = snapshot.get_mut(..HEADER_BYTES) else { return };
    header[..8].copy_from_slice(&of.magic());
    header[8..12].copy_from_slice(&FORMAT_VERSION.to_le_bytes());
    header[12..16].copy_from_slice(&length.to_le_bytes());
    let checksum = checksum(snapshot);
    snapshot[CHECKSUM].copy_from_slice(&checksum.to_le_bytes());
}

/// The words of a snapshot, if its header is valid.
pub(super) fn open(snapshot: &[u8], of: SnapshotOf) -> Result<&[u8], Error> {
    let damaged = |field, value: usize, rule| Err(Error::of(ErrorKind::Snapshot, field, value, rule));
    let Some(header) = snapshot.get(..HEADER_BYTES) else {
        let rule = Rule::AtLeast("is cut off; bytes that the header alone needs:", HEADER_BYTES.into());
        return damaged("snapshot size", snapshot.len(), rule);
    };
    let number = |at: usize| u32::from_le_bytes(core::array::from_fn(|byte| header[at + byte]));
    if header[..8] != of.magic() {
        let kinds = [SnapshotOf::Simulator, SnapshotOf::Ensemble, SnapshotOf::Unit, SnapshotOf::Play];
        let words = match kinds.into_iter().find(|kind| header[..8] == kind.magic()) {
            Some(SnapshotOf::Simulator) => "snapshot: it is one of a simulator",
            Some(SnapshotOf::Ensemble) => "snapshot: it is one of an ensemble",
            Some(SnapshotOf::Unit) => "snapshot: it is one of a unit",
            Some(SnapshotOf::Play) => "snapshot: it is one of a scene in flight",
            None => "snapshot: these bytes are not a snapshot",
        };
        return Err(Error { kind: ErrorKind::Snapshot, ..Error::bad_state(words) });
    }
    let version = number(8) as usize;
    if version != FORMAT_VERSION as usize {
        let rule = Rule::Exactly("is of another release; this one reads version", FORMAT_VERSION.into());
        return damaged("snapshot format version", version, rule);
    }
    let length = number(12);
    if length != snapshot.len() as u32 {
        let rule = Rule::Exactly("is not the size that was saved:", length.into());
        return damaged("snapshot size", snapshot.len(), rule);
    }
    if header[CHECKSUM] != checksum(snapshot).to_le_bytes() {
        return Err(Error {
            kind: ErrorKind::Snapshot,
            ..Error::bad_state("snapshot: its checksum is wrong; bytes were altered")
        });
    }
    Ok(&snapshot[HEADER_BYTES..])
}

/// Adds a word to the hash: both halves of a long product, so that each bit of word and hash changes all bits of the result.
#[inline]
fn folded(hash: u64, word: u64) -> u64 {
    let product = u128::from(hash ^ word) * u128::from(SPLIT_MIX_STEP);
    (product >> 64) as u64 ^ product as u64
}

/// Hash of all bytes except its own, eight at a time; the last ones are padded with zeros.
fn checksum(snapshot: &[u8]) -> u64 {
    let mut hash = SPLIT_MIX_STEP;
    for part in [&snapshot[..CHECKSUM.start], &snapshot[CHECKSUM.end..]] {
        let (words, rest) = part.as_chunks();
        hash = words.iter().fold(hash, |hash, word| folded(hash, u64::from_le_bytes(*word)));
        let mut last = [0; 8];
        last[..rest.len()].copy_from_slice(rest);
        hash = folded(hash, u64::from_le_bytes(last));
    }
    mix(hash)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_header_is_as_documented_and_seals_what_is_behind_it() {
        let mut bytes = vec![0; 27];
        bytes[24..].copy_from_slice(&[7, 8, 9]);
        seal(&mut bytes, SnapshotOf::Simulator);
        assert_eq!(&bytes[..16], b"SINSsnap\x01\0\0\0\x1b\0\0\0");
        assert_eq!(open(&bytes, SnapshotOf::Simulator), Ok(&[7, 8, 9][..]));
    }

    #[test]
    fn each_damage_has_its_words() {
        let mut good = vec![0; 40];
        seal(&mut good, SnapshotOf::Simulator);
        let altered = |at: usize, change: u8| {
            let mut bytes = good.clone();
            bytes[at] ^= change;
            open(&bytes, SnapshotOf::Simulator).unwrap_err().to_string()
        };
        assert_eq!(altered(0, 1), "snapshot: these bytes are not a snapshot");
        let other = open(&good, SnapshotOf::Ensemble).unwrap_err();
        assert_eq!(other.to_string(), "snapshot: it is one of a simulator");
        assert_eq!(
            altered(8, 3),
            "snapshot format version = 2: is of another release; this one reads version 1"
        );
        assert_eq!(altered(12, 1), "snapshot size = 40: is not the size that was saved: 41");
        for at in 16..40 {
            assert_eq!(altered(at, 0x80), "snapshot: its checksum is wrong; bytes were altered");
        }
        let cut = |length: usize| open(&good[..length], SnapshotOf::Simulator).unwrap_err().to_string();
        assert_eq!(cut(39), "snapshot size = 39: is not the size that was saved: 40");
        assert_eq!(cut(23), "snapshot size = 23: is cut off; bytes that the header alone needs: 24");
    }
}
