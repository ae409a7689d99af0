//! The content security policy of a page: its own script and its own styles, and no network.

use hmac_sha256::Hash;

/// A policy under which a page runs `script`, looks as `styles` say, and does and loads nothing else.
pub fn policy(script: Option<&str>, styles: &[&str]) -> String {
    let sources =
        |texts: &mut dyn Iterator<Item = &str>| texts.map(|text| format!(" {}", source(text))).collect();
    let styles: String = sources(&mut styles.iter().copied());
    let script: String = sources(&mut script.into_iter());
    let script = if script.is_empty() { " 'none'" } else { &script };
    format!("default-src 'none'; script-src{script}; style-src{styles}; base-uri 'none'; form-action 'none'")
}

/// A text that may stand in an element of the page, by its hash.
fn source(text: &str) -> String {
    const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let hash = Hash::hash(text.as_bytes());
    let mut base64 = String::new();
    for three in hash.chunks(3) {
        let bits = (0..3).fold(0, |bits, k| bits << 8 | usize::from(three.get(k).copied().unwrap_or(0)));
        for k in 0..4 {
            base64.push(if k <= three.len() { char::from(DIGITS[bits >> (18 - 6 * k) & 63]) } else { '=' });
        }
    }
    format!("'sha256-{base64}'")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_source_is_the_hash_of_the_standard() {
        // FIPS 180-2, appendix B; in base64.
        assert_eq!(source("abc"), "'sha256-ungWv48Bz+pBQUDeXa4iI7ADYaOWF3qctBD/YfIAFa0='");
        assert_eq!(source(""), "'sha256-47DEQpj8HBSa+/TImW+5JCeuQeRkm5NMpJWZG3hSuFU='");
    }
}
