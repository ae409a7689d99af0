//! For tests: parses the arguments of a command.

use clap::{Args, Parser};

#[derive(Debug, Parser)]
struct Line<O: Args> {
    #[command(flatten)]
    order: O,
}

/// The parsed order, or the error of the arguments.
pub fn parsed<O: Args>(arguments: &[&str]) -> Result<O, String> {
    let line = Line::try_parse_from([&["sins"], arguments].concat());
    line.map(|line| line.order).map_err(|error| error.to_string())
}
