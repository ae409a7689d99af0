//! Lines that are not too long.

/// The lines of a comment, each behind `mark`; longer ones are broken between words.
pub fn comment(mark: &str, lines: &[String], width: usize) -> String {
    let mut text = String::new();
    for line in lines {
        let mut column = mark.len();
        text += mark;
        for word in line.split(' ') {
            if column + 1 + word.len() > width {
                text = text + "\n" + mark;
                column = mark.len();
            }
            text = text + " " + word;
            column += 1 + word.len();
        }
        text.truncate(text.trim_end().len());
        text += "\n";
    }
    text
}

/// A statement, broken behind commas; `mark` says that it goes on in the next line, which stands four columns further right.
pub fn broken(statement: &str, width: usize, mark: &str) -> String {
    let indent = " ".repeat(4 + statement.len() - statement.trim_start().len());
    let mut text = String::new();
    let mut column = 0;
    for part in statement.split_inclusive(", ") {
        if column + part.len() + mark.len() > width {
            text.truncate(text.trim_end().len());
            text = text + mark + "\n" + &indent;
            column = indent.len();
        }
        text += part;
        column += part.len();
    }
    text + "\n"
}
