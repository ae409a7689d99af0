//! Lines that are not too long.

/// The lines of a comment, each behind `mark`; a paragraph with a line that is too long is broken anew between its words.
pub fn comment(mark: &str, lines: &[String], width: usize) -> String {
    let fits = |line: &String| mark.len() + 1 + line.len() <= width;
    let mut text = String::new();
    for (index, paragraph) in lines.split(String::is_empty).enumerate() {
        if index > 0 {
            text = text + mark.trim_end() + "\n";
        }
        let broken =
            if paragraph.iter().all(fits) { paragraph } else { &filled(paragraph, width - mark.len() - 1) };
        text.extend(broken.iter().map(|line| format!("{mark} {line}\n")));
    }
    text
}

/// The words of a paragraph in lines that are as long as they may be.
pub fn filled(paragraph: &[String], width: usize) -> Vec<String> {
    let mut lines = vec![String::new()];
    for word in paragraph.iter().flat_map(|line| line.split(' ')) {
        let line = lines.last_mut().expect("there is one");
        if line.is_empty() {
            *line = word.to_owned();
        } else if line.len() + 1 + word.len() <= width {
            *line = format!("{line} {word}");
        } else {
            lines.push(word.to_owned());
        }
    }
    lines
}

/// A statement, broken behind its `separator`s; `mark` says that it goes on in the next line, which stands four columns further right.
pub fn broken(statement: &str, separator: &str, width: usize, mark: &str) -> String {
    let indent = " ".repeat(4 + statement.len() - statement.trim_start().len());
    let mut text = String::new();
    let mut column = 0;
    for part in statement.split_inclusive(separator) {
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
