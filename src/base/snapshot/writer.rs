//! The writer of snapshots: words to bytes.

use super::envelope::{HEADER_BYTES, SnapshotOf, seal};
use crate::base::error::{Error, ErrorKind, Rule};

/// Number of words in a group, which follow their sizes.
pub(super) const GROUP: usize = 8;
/// Codes of the size of a word: left out, one byte, eight bytes.
pub(super) const NOTHING: u16 = 0;
pub(super) const BYTE: u16 = 1;
pub(super) const WHOLE: u16 = 2;

const SIZES_BYTES: usize = size_of::<u16>();
const WORD_BYTES: usize = size_of::<u64>();
/// Largest number of bytes of a group.
const GROUP_BYTES: usize = SIZES_BYTES + GROUP * WORD_BYTES;

/// The length of a snapshot, if it fits a buffer of `capacity` bytes.
pub(crate) fn fitting(length: usize, capacity: usize) -> Result<usize, Error> {
    if length <= capacity {
        return Ok(length);
    }
    let rule = Rule::AtLeast("is too small for the snapshot; needed:", length.into());
    Err(Error::of(ErrorKind::BufferTooSmall, "capacity", capacity, rule))
}

/// Writes a snapshot. Bytes that do not fit into the buffer are only counted.
pub(crate) struct Writer<'a> {
    of: SnapshotOf,
    out: &'a mut [u8],
    len: usize,
    /// Words of the group that is not complete yet.
    group: [u64; GROUP],
    waiting: usize,
}

impl<'a> Writer<'a> {
    pub fn new(out: &'a mut [u8], of: SnapshotOf) -> Self {
        Self { of, out, len: HEADER_BYTES, group: [0; GROUP], waiting: 0 }
    }

    #[inline]
    pub fn word(&mut self, word: u64) {
        self.group[self.waiting % GROUP] = word;
        self.waiting += 1;
        if self.waiting == GROUP {
            self.flush();
        }
    }

    /// A small integer, or a count.
    pub fn count(&mut self, count: usize) {
        self.word(count as u64);
    }

    pub fn flag(&mut self, flag: bool) {
        self.word(u64::from(flag));
    }

    #[inline(never)]
    fn flush(&mut self) {
        let rest = self.out.get_mut(self.len..).unwrap_or_default();
        if let Some(room) = rest.first_chunk_mut() {
            self.len += encode(&self.group, room);
        } else {
            let mut bytes = [0; GROUP_BYTES];
            let length = encode(&self.group, &mut bytes);
            if let Some(room) = rest.get_mut(..length) {
                room.copy_from_slice(&bytes[..length]);
            }
            self.len += length;
        }
        self.waiting = 0;
    }

    /// Completes the snapshot and returns its length. The snapshot is complete only if the buffer has this length.
    pub fn finish(mut self) -> usize {
        if self.waiting > 0 {
            // The words that are missing in the last group are zero, which takes no bytes.
            self.group[self.waiting..].fill(0);
            self.flush();
        }
        if let Some(snapshot) = self.out.get_mut(..self.len) {
            seal(snapshot, self.of);
        }
        self.len
    }
}

/// Puts sizes and words into `out`. Returns how many bytes they take.
#[inline]
fn encode(words: &[u64; GROUP], out: &mut [u8; GROUP_BYTES]) -> usize {
    let (mut sizes, mut end) = (0, SIZES_BYTES);
    if words.iter().fold(0, |all, word| all | word) != 0 {
        for (place, &word) in words.iter().enumerate() {
            // Each word is written with all its bytes; the next one overwrites the bytes that are not needed.
            out[end..end + WORD_BYTES].copy_from_slice(&word.to_le_bytes());
            let (is_there, is_whole) = (u16::from(word != 0), u16::from(word > 0xff));
            sizes |= (is_there * BYTE + is_whole * (WHOLE - BYTE)) << (2 * place);
            end += usize::from(is_there) + usize::from(is_whole) * (WORD_BYTES - 1);
        }
    }
    out[..SIZES_BYTES].copy_from_slice(&u16::to_le_bytes(sizes));
    end
}
