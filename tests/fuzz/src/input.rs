//! A call as a record of bytes, and the arguments that are made from it.

use sins::math::{SPLIT_MIX_STEP, mix};

use crate::trace;

/// Bytes of a record.
pub const RECORD: usize = 32;

/// One call with its arguments. A record of zeros is the simplest call.
pub type Record = [u8; RECORD];

/// The records of a file or of a fuzzer's input. The last one is padded with zeros.
pub fn records(bytes: &[u8]) -> Vec<Record> {
    let record = |chunk: &[u8]| std::array::from_fn(|at| chunk.get(at).copied().unwrap_or(0));
    bytes.chunks(RECORD).map(record).collect()
}

/// SplitMix64. The kept corpus depends on its words.
pub struct Random(pub u64);

impl Random {
    pub fn word(&mut self) -> u64 {
        let word = mix(self.0);
        self.0 = self.0.wrapping_add(SPLIT_MIX_STEP);
        word
    }

    pub fn record(&mut self) -> Record {
        let words: [u64; RECORD / 8] = std::array::from_fn(|_| self.word());
        std::array::from_fn(|at| words[at / 8].to_le_bytes()[at % 8])
    }
}

/// Special numbers that are not the ends of ranges.
const NUMBERS: [f64; 16] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    5e-324,
    1e-300,
    0.0078125,
    1.5707,
    7000.0,
    2.1e7,
    1e10,
    1e300,
    f64::MAX,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::NAN,
];

/// The unread bytes of a record, followed by a random stream whose seed is the whole record.
pub struct Input {
    record: Record,
    at: usize,
    more: Random,
}

impl Input {
    pub fn new(record: &Record) -> Self {
        let (words, _) = record.as_chunks();
        let hash = words.iter().fold(0, |hash, &word| Random(hash ^ u64::from_le_bytes(word)).word());
        Self { record: *record, at: 0, more: Random(hash) }
    }

    pub fn byte(&mut self) -> u8 {
        self.at += 1;
        match self.record.get(self.at - 1) {
            Some(&byte) => byte,
            None => self.more.word() as u8,
        }
    }

    /// A number below `count`, which is at most 256.
    pub fn below(&mut self, count: usize) -> usize {
        usize::from(self.byte()) % count
    }

    /// True in one of `cases` cases.
    pub fn one_in(&mut self, cases: usize) -> bool {
        self.below(cases) == cases - 1
    }

    pub fn word(&mut self) -> u64 {
        u64::from_le_bytes(std::array::from_fn(|_| self.byte()))
    }

    pub fn pick<T: Copy>(&mut self, choices: &[T]) -> T {
        choices[self.below(choices.len())]
    }

    /// Any number, also a special or invalid one.
    pub fn number(&mut self) -> f64 {
        match self.byte() {
            kind @ 0..64 => NUMBERS[usize::from(kind) % NUMBERS.len()],
            64..80 => f64::from_bits(self.word()),
            kind => f64::from(self.byte() as i8) * 10f64.powi(i32::from(kind) % 16 - 12),
        }
    }

    /// A number of a range: an end, a number some decades below the higher end, or any number between.
    pub fn within(&mut self, (low, high): (f64, f64)) -> f64 {
        let kind = self.byte();
        let size = match kind % 4 {
            0 => high,
            1 if low > 0.0 => return low,
            1 => high * f64::from(self.byte()) / 255.0,
            _ => high * 10f64.powi(-i32::from(kind / 4 % 10)),
        };
        if low < 0.0 && kind >= 128 { (-size).max(low) } else { size.max(low) }
    }

    /// `value` as a host's struct, sometimes with altered words. It has exactly the number of bytes that its
    /// struct_size states.
    pub fn argument<T: Copy + std::fmt::Debug>(&mut self, value: T) -> Argument {
        let alterations = match self.byte() {
            0..224 => 0,
            kind => 1 + usize::from(kind) % 3,
        };
        self.altered(value, alterations)
    }

    /// `value` as a host's struct with `alterations` altered words.
    pub fn altered<T: Copy + std::fmt::Debug>(&mut self, value: T, alterations: usize) -> Argument {
        let mut argument = Argument::of(&value);
        for _ in 0..alterations {
            let at = 8 * self.below(argument.bytes.len() / 8);
            let word = match (at, self.byte()) {
                // struct_size, with its reserved neighbour.
                (0, kind @ 0..200) => self.head(size_of::<T>(), kind),
                (_, 0..144) => self.number().to_bits(),
                (_, 144..160) => self.word(),
                // A pair of small integers.
                (_, _) => u64::from(self.byte()) << 32 | u64::from(self.byte() % 12),
            };
            argument.bytes[at..at + 8].copy_from_slice(&word.to_le_bytes());
        }
        argument.resize();
        argument.is_null = alterations == 3 && self.one_in(4);
        argument.is_altered = alterations > 0;
        argument.note::<T>();
        argument
    }

    fn head(&mut self, size: usize, kind: u8) -> u64 {
        match kind {
            0..150 => (size + self.below(4)) as u64 | u64::from(self.byte() % 16) << 32,
            150..180 => (8 * self.below(64)) as u64,
            _ => self.word(),
        }
    }
}

/// A struct as bytes.
pub struct Argument {
    pub bytes: Vec<u8>,
    is_null: bool,
    /// Whether a call with this struct may fail.
    pub is_altered: bool,
}

impl Argument {
    pub fn of<T: Copy>(value: &T) -> Self {
        // SAFETY: the structs of the interface have no padding.
        let bytes =
            unsafe { std::slice::from_raw_parts(std::ptr::from_ref(value).cast::<u8>(), size_of::<T>()) };
        Self { bytes: bytes.to_vec(), is_null: false, is_altered: false }
    }

    /// Makes the bytes exactly as long as struct_size states, so that the sanitizer detects an access beyond them.
    /// The library rejects a much larger size before it reads further.
    fn resize(&mut self) {
        let stated =
            u32::from_le_bytes([self.bytes[0], self.bytes[1], self.bytes[2], self.bytes[3]]) as usize;
        self.bytes.resize(if stated <= 1 << 16 { stated.max(4) } else { 4 }, 0);
        self.bytes.shrink_to_fit();
    }

    pub fn pointer<T>(&mut self) -> *mut T {
        if self.is_null { std::ptr::null_mut() } else { self.bytes.as_mut_ptr().cast() }
    }

    /// The struct, if it has the size of this release.
    pub fn value<T: Copy>(&self) -> Option<T> {
        // SAFETY: the structs of the interface are numbers.
        (self.bytes.len() == size_of::<T>())
            .then(|| unsafe { self.bytes.as_ptr().cast::<T>().read_unaligned() })
    }

    fn note<T: Copy + std::fmt::Debug>(&self) {
        trace::note(|| match self.value::<T>() {
            _ if self.is_null => "NULL".into(),
            Some(value) => trace::without_zeros(&format!("{value:?}")),
            None => format!("{} of {} bytes", std::any::type_name::<T>(), self.bytes.len()),
        });
    }

    /// Whether all numbers are finite. Integers below 2^52 and pairs of small integers look like small numbers. UINT64_MAX is a value
    /// of `more_runs`; no arithmetic makes a NaN with these bits.
    pub fn is_finite(&self) -> bool {
        let (words, _) = self.bytes.as_chunks();
        words.iter().all(|&word| word == [0xff; 8] || f64::from_le_bytes(word).is_finite())
    }
}
