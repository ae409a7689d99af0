//! The words of a snapshot: after the header, groups of eight words. 16 bits before each group give the sizes of
//! its words.

use std::iter::repeat_n;

const HEADER_BYTES: usize = 24;

/// The words of a snapshot that was saved.
pub fn words_of(snapshot: &[u8]) -> Vec<u64> {
    let mut rest = &snapshot[HEADER_BYTES.min(snapshot.len())..];
    let mut words = Vec::new();
    while let Some((&sizes, mut bytes)) = rest.split_first_chunk() {
        let sizes = u16::from_le_bytes(sizes);
        for place in 0..8 {
            let size = [0, 1, 8, 0][usize::from(sizes >> (2 * place) & 3)].min(bytes.len());
            let (word, behind) = bytes.split_at(size);
            words.push(u64::from_le_bytes(std::array::from_fn(|at| word.get(at).copied().unwrap_or(0))));
            bytes = behind;
        }
        rest = bytes;
    }
    words
}

/// A snapshot of these words with a valid header and checksum.
pub fn snapshot_of(words: &[u64]) -> Vec<u8> {
    let mut snapshot: Vec<u8> = repeat_n(0, HEADER_BYTES).collect();
    for group in words.chunks(8) {
        let mut sizes = 0;
        let mut bytes = Vec::new();
        for (place, &word) in group.iter().enumerate() {
            let (size, length) = if word == 0 {
                (0, 0)
            } else if word <= 0xff {
                (1, 1)
            } else {
                (2, 8)
            };
            sizes |= size << (2 * place);
            bytes.extend_from_slice(&word.to_le_bytes()[..length]);
        }
        snapshot.extend(u16::to_le_bytes(sizes));
        snapshot.extend(bytes);
    }
    sins::snapshot::seal(&mut snapshot, sins::snapshot::SnapshotOf::Simulator);
    snapshot
}
