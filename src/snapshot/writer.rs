//! Words to bytes.

use super::envelope::{HEADER_BYTES, SnapshotOf, seal};
use crate::error::{Error, ErrorKind, Rule};

/// Words between their sizes and the next sizes.
pub(super) const GROUP: usize = 8;
/// Size of a word: nothing, a byte, all of it.
pub(super) const NOTHING: u16 = 0;
pub(super) const BYTE: u16 = 1;
pub(super) const WHOLE: u16 = 2;

const SIZES_BYTES: usize = size_of::<u16>();
const WORD_BYTES: usize = size_of::<u64>();
/// Bytes of a group at the most.
const GROUP_BYTES: usize = SIZES_BYTES + GROUP * WORD_BYTES;

/// The length of a snapshot, if it fits a buffer of `capacity` bytes.
pub(crate) fn fitting(length: usize, capacity: usize) -> Result<usize, Error> {
    if length <= capacity {
        return Ok(length);
    }
    let rule = Rule::AtLeast("is too small for the snapshot; needed:", length as f64);
    Err(Error::of(ErrorKind::BufferTooSmall, "capacity", capacity, rule))
}

/// Writes a snapshot; what does not fit is counted.
pub(crate) struct Writer<'a> {
    of: SnapshotOf,
    out: &'a mut [u8],
    len: usize,
    /// Words that wait for their sizes.
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

    /// Completes the snapshot and gives its length: it is whole only if there was room for that.
    pub fn finish(mut self) -> usize {
        if self.waiting > 0 {
            // What is missing of the last group is zero: no bytes.
            self.group[self.waiting..].fill(0);
            self.flush();
        }
        if let Some(snapshot) = self.out.get_mut(..self.len) {
            seal(snapshot, self.of);
        }
        self.len
    }
}

/// Sizes and words; how many bytes they take of `out`.
#[inline]
fn encode(words: &[u64; GROUP], out: &mut [u8; GROUP_BYTES]) -> usize {
    let (mut sizes, mut end) = (0, SIZES_BYTES);
    if words.iter().fold(0, |all, word| all | word) != 0 {
        for (place, &word) in words.iter().enumerate() {
            // Each is written whole, and the next one over what of it is not needed.
            out[end..end + WORD_BYTES].copy_from_slice(&word.to_le_bytes());
            let (is_there, is_whole) = (u16::from(word != 0), u16::from(word > 0xff));
            sizes |= (is_there * BYTE + is_whole * (WHOLE - BYTE)) << (2 * place);
            end += usize::from(is_there) + usize::from(is_whole) * (WORD_BYTES - 1);
        }
    }
    out[..SIZES_BYTES].copy_from_slice(&u16::to_le_bytes(sizes));
    end
}
