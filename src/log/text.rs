//! The text in the bytes of a table.

use std::borrow::Cow;

use crate::base::error::Error;
use crate::base::memory::room;

/// The letters of Windows-1252 from 0x80 to 0x9F. Its other bytes are those of Latin-1.
const FROM_0X80: [char; 32] = [
    '€', '\u{81}', '‚', 'ƒ', '„', '…', '†', '‡', 'ˆ', '‰', 'Š', '‹', 'Œ', '\u{8d}', 'Ž', '\u{8f}', '\u{90}',
    '‘', '’', '“', '”', '•', '–', '—', '˜', '™', 'š', '›', 'œ', '\u{9d}', 'ž', 'Ÿ',
];

/// The text of a table: UTF-16 behind a byte order mark, UTF-8, or else Windows-1252. A mark is left out. Where every line ends with CR
/// alone, LF stands instead.
pub fn decoded(bytes: &[u8]) -> Result<Cow<'_, str>, Error> {
    let text = match bytes {
        [0xff, 0xfe, units @ ..] => Cow::Owned(of_utf_16(units, u16::from_le_bytes)?),
        [0xfe, 0xff, units @ ..] => Cow::Owned(of_utf_16(units, u16::from_be_bytes)?),
        _ => {
            let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
            match core::str::from_utf8(bytes) {
                Ok(text) => Cow::Borrowed(text),
                Err(_) => Cow::Owned(collected(bytes.iter().map(|byte| windows_1252(*byte)))?),
            }
        }
    };
    if text.contains('\n') || !text.contains('\r') {
        return Ok(text);
    }
    collected(text.chars().map(|letter| if letter == '\r' { '\n' } else { letter })).map(Cow::Owned)
}

/// Pairs of bytes without a meaning, and a single byte at the end, become the mark of a replaced letter.
fn of_utf_16(bytes: &[u8], unit: fn([u8; 2]) -> u16) -> Result<String, Error> {
    let pairs = bytes.chunks(2).map(|pair| if let [a, b] = *pair { unit([a, b]) } else { 0xfffd });
    collected(char::decode_utf16(pairs).map(|letter| letter.unwrap_or(char::REPLACEMENT_CHARACTER)))
}

fn windows_1252(byte: u8) -> char {
    let special = byte.checked_sub(0x80).and_then(|place| FROM_0X80.get(usize::from(place)));
    special.copied().unwrap_or(char::from(byte))
}

fn collected(letters: impl Iterator<Item = char> + Clone) -> Result<String, Error> {
    let size = letters.clone().map(char::len_utf8).sum();
    // No bytes are a text: only their room is taken.
    let mut text = String::from_utf8(room(size)?).unwrap_or_default();
    text.extend(letters);
    Ok(text)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_encoding_gives_the_same_text() {
        let text = "Höhe [m],\"20 °C – €\"\nž,😀\n";
        let units: Vec<u16> = text.encode_utf16().collect();
        let bytes = |mark: [u8; 2], bytes: fn(u16) -> [u8; 2]| {
            let all = units.iter().flat_map(|unit| bytes(*unit));
            mark.into_iter().chain(all).collect::<Vec<u8>>()
        };
        for bytes in [
            text.as_bytes().to_vec(),
            [b"\xef\xbb\xbf", text.as_bytes()].concat(),
            bytes([0xff, 0xfe], u16::to_le_bytes),
            bytes([0xfe, 0xff], u16::to_be_bytes),
        ] {
            assert_eq!(decoded(&bytes).unwrap(), text);
        }
        assert_eq!(decoded(b"H\xf6he [m],20 \xb0C \x96 \x80\r\n").unwrap(), "Höhe [m],20 °C – €\r\n");
        assert_eq!(decoded(b"t,lat\r0,48\r").unwrap(), "t,lat\n0,48\n");
        assert_eq!(decoded(b"a\r\nb\rc").unwrap(), "a\r\nb\rc");
        assert_eq!(decoded(b"\xff\xfea\0b").unwrap(), "a\u{fffd}");
        assert_eq!(decoded(b"").unwrap(), "");
    }
}
