//! Words to bytes.

use super::envelope::{HEADER_BYTES, seal};

/// Words between one byte of flags and the next.
pub(super) const GROUP: usize = 8;

/// Writes a snapshot; what does not fit is counted.
pub(crate) struct Writer<'a> {
    out: &'a mut [u8],
    len: usize,
    /// Words that wait for their flags.
    group: [u64; GROUP],
    waiting: usize,
}

impl<'a> Writer<'a> {
    pub fn new(out: &'a mut [u8]) -> Self {
        Self { out, len: HEADER_BYTES, group: [0; GROUP], waiting: 0 }
    }

    #[inline]
    pub fn word(&mut self, word: u64) {
        self.group[self.waiting] = word;
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
        const MOST: usize = 1 + GROUP * size_of::<u64>();
        // The flags are known last and stand first.
        let mut bytes = [0; MOST];
        let (mut flags, mut end) = (0, 1);
        for (bit, &word) in self.group[..self.waiting].iter().enumerate() {
            if word != 0 {
                flags |= 1 << bit;
                bytes[end..end + size_of::<u64>()].copy_from_slice(&word.to_le_bytes());
                end += size_of::<u64>();
            }
        }
        bytes[0] = flags;
        if let Some(out) = self.out.get_mut(self.len..self.len + end) {
            out.copy_from_slice(&bytes[..end]);
        }
        self.len += end;
        self.waiting = 0;
    }

    /// Completes the snapshot and gives its length: it is whole only if there was room for that.
    pub fn finish(mut self) -> usize {
        if self.waiting > 0 {
            self.flush();
        }
        if let Some(snapshot) = self.out.get_mut(..self.len) {
            seal(snapshot);
        }
        self.len
    }
}
