//! Snapshots that a forger makes, with the right checksum.

use sins::snapshot::{SnapshotOf, seal};

use super::draws::Draws;

/// Words of a snapshot after its header.
pub fn words(snapshot: &[u8]) -> Vec<u64> {
    let mut rest = &snapshot[24..];
    let mut words = Vec::new();
    while let Some((sizes, mut bytes)) = rest.split_first_chunk() {
        for place in 0..8 {
            let length = [0, 1, 8][usize::from(u16::from_le_bytes(*sizes) >> (2 * place) & 3)];
            let mut word = [0; 8];
            word[..length].copy_from_slice(&bytes[..length]);
            bytes = &bytes[length..];
            words.push(u64::from_le_bytes(word));
        }
        rest = bytes;
    }
    words
}

/// A snapshot made of `words`, with its checksum.
pub fn forge(words: &[u64], of: SnapshotOf) -> Vec<u8> {
    let mut bytes = vec![0; 24];
    for group in words.chunks(8) {
        let (mut sizes, mut body) = (0_u16, Vec::<u8>::new());
        for (place, word) in group.iter().enumerate() {
            let (size, length) = match word {
                0 => (0, 0),
                1..256 => (1, 1),
                _ => (2, 8),
            };
            sizes |= size << (2 * place);
            body.extend(&word.to_le_bytes()[..length]);
        }
        bytes.extend(sizes.to_le_bytes());
        bytes.extend(body);
    }
    seal(&mut bytes, of);
    bytes
}

/// A value that a forger would put in place of a word.
pub fn wild(draws: &mut Draws, word: u64) -> u64 {
    let value = f64::from_bits(word);
    match draws.below(16) {
        0 => f64::NAN.to_bits(),
        1 => f64::INFINITY.to_bits(),
        2 => f64::MAX.to_bits(),
        3 => 1e300_f64.to_bits(),
        4 => 1e12_f64.to_bits(),
        5 => (-1e9_f64).to_bits(),
        6 => 1,
        7 => 0,
        8 => u64::MAX,
        9 => (-value).to_bits(),
        10 => (value * 1.000_001).to_bits(),
        11 => (value * 1e3).to_bits(),
        12 => draws.below(20) as u64,
        13 => word ^ (1 << draws.below(64)),
        14 => 1e-310_f64.to_bits(),
        _ => draws.next(),
    }
}
