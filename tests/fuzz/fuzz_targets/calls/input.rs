//! Arguments out of a fuzzer's bytes: mostly plausible, sometimes anything.

/// Numbers at which something may change.
const NUMBERS: [f64; 32] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    1e-300,
    5e-324,
    1e-9,
    1e-3,
    0.0078125,
    0.01,
    0.1,
    0.5,
    std::f64::consts::FRAC_PI_2,
    -std::f64::consts::FRAC_PI_2,
    1.5707,
    std::f64::consts::PI,
    -std::f64::consts::PI,
    10.0,
    100.0,
    1e3,
    7000.0,
    2e4,
    2e6,
    2.1e7,
    1e8,
    1e10,
    -1e10,
    1e300,
    f64::MAX,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::NAN,
];

/// The rest of the fuzzer's bytes; zeros when they are used up.
pub struct Input<'a> {
    bytes: &'a [u8],
}

impl<'a> Input<'a> {
    pub fn new(bytes: &'a [u8]) -> Self {
        Self { bytes }
    }

    pub fn is_empty(&self) -> bool {
        self.bytes.is_empty()
    }

    pub fn byte(&mut self) -> u8 {
        let Some((&first, rest)) = self.bytes.split_first() else { return 0 };
        self.bytes = rest;
        first
    }

    /// Below `count`.
    pub fn below(&mut self, count: usize) -> usize {
        usize::from(self.byte()) % count
    }

    pub fn word(&mut self) -> u64 {
        u64::from_le_bytes(std::array::from_fn(|_| self.byte()))
    }

    pub fn number(&mut self) -> f64 {
        match self.byte() {
            kind @ 0..32 => NUMBERS[usize::from(kind)],
            32..96 => f64::from_bits(self.word()),
            kind => f64::from(self.byte() as i8) * 10f64.powi(i32::from(kind) % 16 - 12),
        }
    }

    /// `value` as a host's struct in just as many bytes as its struct_size says, a few words of it changed.
    pub fn changed<T: Copy>(&mut self, value: T) -> Block {
        let mut block = Block::of(&value);
        let words = block.bytes.len() / 8;
        for _ in 0..self.below(4) {
            let at = 8 * self.below(words);
            let word = match (at, self.byte()) {
                // struct_size, with its reserved neighbour.
                (0, kind @ 0..200) => self.head(size_of::<T>(), kind),
                (_, 0..128) => self.number().to_bits(),
                (_, 128..160) => self.word(),
                // A pair of small integers.
                (_, _) => u64::from(self.byte()) << 32 | u64::from(self.byte() % 12),
            };
            block.bytes[at..at + 8].copy_from_slice(&word.to_le_bytes());
        }
        block.resized()
    }

    fn head(&mut self, size: usize, kind: u8) -> u64 {
        match kind {
            0..150 => (size + self.below(4)) as u64 | u64::from(self.byte() % 16) << 32,
            150..180 => (8 * self.below(64)) as u64,
            _ => self.word(),
        }
    }
}

/// A struct as the bytes that a host has of it.
pub struct Block {
    pub bytes: Vec<u8>,
}

impl Block {
    pub fn of<T: Copy>(value: &T) -> Self {
        // SAFETY: the structs of the interface have no padding.
        let bytes =
            unsafe { std::slice::from_raw_parts(std::ptr::from_ref(value).cast::<u8>(), size_of::<T>()) };
        Self { bytes: bytes.to_vec() }
    }

    /// As long as its struct_size says, so that the sanitizer sees a touch beyond; garbage is refused before it is.
    fn resized(mut self) -> Self {
        let stated =
            u32::from_le_bytes([self.bytes[0], self.bytes[1], self.bytes[2], self.bytes[3]]) as usize;
        self.bytes.resize(if stated <= 1 << 16 { stated.max(4) } else { 4 }, 0);
        self.bytes.shrink_to_fit();
        self
    }

    pub fn pointer<T>(&mut self) -> *mut T {
        self.bytes.as_mut_ptr().cast()
    }

    /// Whether no number is infinite or none; integers below 2^52 and pairs of small ones look like small numbers.
    pub fn is_finite(&self) -> bool {
        let mut words = self.bytes.chunks_exact(8);
        words.all(|word| f64::from_le_bytes(std::array::from_fn(|i| word[i])).is_finite())
    }
}
