//! How deep a text nests.

use toml_parser::Source;
use toml_parser::lexer::TokenKind;

/// Brackets that may be open at once: the parser takes a kilobyte of stack for each. A scene needs two.
pub const MAX_NESTING: usize = 8;

/// Where a text nests deeper than [`MAX_NESTING`] [bytes].
pub fn too_deep(text: &str) -> Option<usize> {
    let mut depth = 0_usize;
    for token in Source::new(text).lex() {
        match token.kind() {
            TokenKind::LeftSquareBracket | TokenKind::LeftCurlyBracket => depth += 1,
            TokenKind::RightSquareBracket | TokenKind::RightCurlyBracket => depth = depth.saturating_sub(1),
            _ => {}
        }
        if depth > MAX_NESTING {
            return Some(token.span().start());
        }
    }
    None
}
