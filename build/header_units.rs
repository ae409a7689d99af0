//! Units of data sheets, from the macros of the header's preamble: `#define SINS_ARCMIN (SINS_DEG / 60.0)  /* minute of arc [rad] */`.

use super::model::Unit;

/// All of them. A definition is a number or a name, or two of them with `*` or `/` between.
pub fn read(preamble: &str) -> Vec<Unit> {
    let mut units: Vec<Unit> = Vec::new();
    let (_, text) = preamble.split_once("/* Units:").expect("the preamble has units");
    for line in text.lines().skip(1).take_while(|line| line.starts_with("#define ")) {
        let (definition, doc) = line["#define ".len()..].split_once("/*").expect("a unit has a comment");
        let (name, value) = definition.split_once(' ').expect("a unit has a value");
        let value = value.trim().trim_matches(['(', ')']);
        let number = |text: &str| match text.parse() {
            Ok(number) => number,
            Err(_) => units.iter().find(|unit| unit.name == text).expect("a unit stands above").value,
        };
        let value: f64 = match value.split(' ').collect::<Vec<_>>()[..] {
            [value] => number(value),
            [left, "*", right] => number(left) * number(right),
            [left, "/", right] => number(left) / number(right),
            _ => panic!("{line}: not a unit that other languages are told"),
        };
        let doc = vec![doc.trim_end_matches("*/").trim().to_owned()];
        units.push(Unit { name: name.to_owned(), value, doc });
    }
    units
}
