//! Integers of 128 bits as two words of 64, the low one first.

/// Number `index` of `words`.
#[inline]
pub(super) fn at(words: &[u64], index: usize) -> i128 {
    (u128::from(words[2 * index]) | u128::from(words[2 * index + 1]) << 64) as i128
}

/// Adds to number `index` of `words`.
#[inline]
pub(super) fn add(words: &mut [u64], index: usize, number: i128) {
    let sum = at(words, index) + number;
    words[2 * index] = sum as u64;
    words[2 * index + 1] = (sum >> 64) as u64;
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_add_up_and_leave_their_neighbours() {
        let mut words = [0; 6];
        let mut sum = 0;
        for number in [1, -3, 1 << 64, (1 << 126) - 12345, -(1 << 126), -(1 << 64)] {
            add(&mut words, 1, number);
            sum += number;
            assert_eq!([0, 1, 2].map(|index| at(&words, index)), [0, sum, 0]);
        }
        add(&mut words, 0, -2);
        assert_eq!(words[..2], [u64::MAX - 1, u64::MAX]);
    }
}
