//! The files of requirements: their text in TOML, and those that are built in.

use std::ffi::OsStr;
use std::path::{Path, PathBuf};

use sins::scene::nearest;
use toml::de::{DeTable, DeValue};

use super::requirement::{HOUR_S, LIMITS, QUANTITIES, Requirement};
use crate::failure::Failure;
use crate::given::read_text;

/// The built-in requirements: name and text.
pub const BUILTIN: [(&str, &str); 3] = [
    ("airliner", include_str!("requirements/airliner.toml")),
    ("navigation_grade", include_str!("requirements/navigation_grade.toml")),
    ("rnp10", include_str!("requirements/rnp10.toml")),
];

/// Largest number of requirements in a file.
const MOST: usize = 100;

/// The requirements of the file or the built-in name `given`; the file, if it is one.
pub fn load(given: &OsStr) -> Result<(Vec<Requirement>, Option<PathBuf>), Failure> {
    let path = Path::new(given);
    if let Some((name, text)) = BUILTIN.iter().find(|(name, _)| given == *name) {
        return Ok((parse(text, Path::new(name))?, None));
    }
    if path.extension().is_none() && !path.exists() {
        let hint = match nearest(&path.to_string_lossy(), BUILTIN.iter().map(|(name, _)| *name)) {
            Some(near) => format!("did you mean {near}?"),
            None => format!("built in are {}", BUILTIN.map(|(name, _)| name).join(", ")),
        };
        return Err(Failure::of_file(path, &format!("no such requirement; {hint}")));
    }
    let text = String::from_utf8(read_text(path)?).map_err(|error| Failure::of_input(path, &error))?;
    Ok((parse(&text, path)?, Some(path.to_owned())))
}

fn parse(text: &str, path: &Path) -> Result<Vec<Requirement>, Failure> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let file = File { text, path };
    let root = DeTable::parse(text)
        .map_err(|error| file.failure(error.span().map_or(0, |span| span.start), &error.message()))?;
    let (mut title, mut source, mut items) = (String::new(), String::new(), Vec::new());
    for (key, value) in root.get_ref() {
        match (key.get_ref().as_ref(), value.get_ref()) {
            ("title", DeValue::String(text)) => title = text.to_string(),
            ("source", DeValue::String(text)) => source = text.to_string(),
            ("requirement", DeValue::Array(array)) => items = array.iter().collect(),
            (name, _) => {
                let what = format!("{name}: expected title and source, texts, and [[requirement]]");
                return Err(file.failure(key.span().start, &what));
            }
        }
    }
    if items.is_empty() || items.len() > MOST {
        let what = format!("{} items [[requirement]]: expected 1 to {MOST}", items.len());
        return Err(Failure::of_file(path, &what));
    }
    let read = |item: &toml::Spanned<DeValue<'_>>| match item.get_ref() {
        DeValue::Table(table) => {
            let item = Item { table, at: item.span().start, file: &file };
            item.requirement(&title, &source)
        }
        _ => Err(file.failure(item.span().start, &"expected [[requirement]]")),
    };
    items.into_iter().map(read).collect()
}

/// A text and its path, for failures with their line.
struct File<'a> {
    text: &'a str,
    path: &'a Path,
}

impl File<'_> {
    fn failure(&self, at: usize, what: &dyn std::fmt::Display) -> Failure {
        let before = self.text.get(..at).unwrap_or_default();
        Failure::of_line(self.path, 1 + before.matches('\n').count() as u64, what)
    }
}

/// The table of a requirement, which begins `at` this byte.
struct Item<'a> {
    table: &'a DeTable<'a>,
    at: usize,
    file: &'a File<'a>,
}

impl Item<'_> {
    fn requirement(&self, title: &str, source: &str) -> Result<Requirement, Failure> {
        let others = ["quantity", "percent", "time_h", "flights_over_h", "flights_up_to_h"];
        let known = || others.into_iter().chain(LIMITS.iter().map(|(name, ..)| *name));
        for (key, _) in self.table {
            let name = key.get_ref().as_ref();
            if !known().any(|known| known == name) {
                let hint =
                    nearest(name, known()).map_or(String::new(), |near| format!("; did you mean {near}?"));
                return Err(self.file.failure(key.span().start, &format!("{name}: no such key{hint}")));
            }
        }
        let names = || QUANTITIES.iter().map(|(name, ..)| *name);
        let (quantity, measure, family) = match self.table.get("quantity").map(|value| value.get_ref()) {
            Some(DeValue::String(name)) => QUANTITIES.into_iter().find(|(known, ..)| known == name),
            _ => None,
        }
        .ok_or_else(|| {
            self.failure("quantity", &format!("expected one of {}", names().collect::<Vec<_>>().join(", ")))
        })?;
        let percent = self.number("percent", 0.0)?.filter(|percent| *percent < 100.0);
        let percent =
            percent.ok_or_else(|| self.failure("percent", &"expected a number above 0 and below 100"))?;
        let given: Vec<_> = LIMITS.iter().filter(|(name, ..)| self.table.contains_key(*name)).collect();
        let &[&(key, si, of, grows)] = &given[..] else {
            return Err(self.failure("quantity", &"expected one limit, such as limit_m or limit_nmi_h"));
        };
        if of != family {
            return Err(self.failure(key, &format!("is no unit of {quantity}")));
        }
        let limit = si * self.number(key, 0.0)?.unwrap_or_default();
        let hours = |key| Ok::<_, Failure>(self.number(key, 0.0)?.map(|hours| hours * HOUR_S));
        let applies_s =
            [hours("flights_over_h")?.unwrap_or(0.0), hours("flights_up_to_h")?.unwrap_or(f64::INFINITY)];
        Ok(Requirement {
            title: title.to_owned(),
            source: source.to_owned(),
            quantity,
            measure,
            family,
            percent,
            limit,
            grows,
            time_s: hours("time_h")?,
            applies_s,
        })
    }

    /// The number of `key`, above `low`; `None` if it is not given.
    fn number(&self, key: &str, low: f64) -> Result<Option<f64>, Failure> {
        let Some(value) = self.table.get(key) else { return Ok(None) };
        let number = match value.get_ref() {
            DeValue::Integer(integer) => integer.as_str().replace('_', "").parse().ok(),
            DeValue::Float(float) => float.as_str().replace('_', "").parse().ok(),
            _ => None,
        };
        match number.filter(|number: &f64| number.is_finite() && *number > low) {
            Some(number) => Ok(Some(number)),
            None => Err(self.failure(key, &format!("expected a number above {low}"))),
        }
    }

    /// Failure about `key`, or about the whole requirement if it lacks the key.
    fn failure(&self, key: &str, what: &dyn std::fmt::Display) -> Failure {
        let at = self.table.get_key_value(key).map_or(self.at, |(key, _)| key.span().start);
        self.file.failure(at, &format!("{key}: {what}"))
    }
}

#[cfg(test)]
mod tests {
    use super::super::requirement::NMI;
    use super::*;

    #[test]
    fn every_built_in_requirement_is_read_and_names_its_source() {
        for (name, text) in BUILTIN {
            let read = parse(text, Path::new(name)).unwrap();
            assert!(read.iter().all(|one| !one.title.is_empty() && !one.source.is_empty()), "{name}");
            assert!(include_str!("command.rs").contains(name), "the help names {name}");
        }
        let (read, path) = load(OsStr::new("airliner")).unwrap();
        assert_eq!((read.len(), path), (3, None));
        // Two nautical miles an hour after three hours; 20 nautical miles.
        assert_eq!(read[0].limit_at(3.0 * HOUR_S), 6.0 * NMI);
        assert_eq!(read[1].limit_at(HOUR_S), 20.0 * NMI);
        let applies = |hours: f64| [&read[0], &read[1]].map(|one| one.applies(hours * HOUR_S));
        assert_eq!((applies(10.0), applies(10.1)), ([true, false], [false, true]));
    }

    /// A text that is too long is no requirement: its end could have another one.
    #[test]
    fn no_requirement_is_left_out() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("long.toml");
        let item = "[[requirement]]\nquantity = \"position_up\"\npercent = 95\nlimit_m = 1\n";
        let filled = |length: usize| format!("{item}#{}\n{item}", " ".repeat(length - 2 - 2 * item.len()));
        std::fs::write(&path, filled(1 << 20)).unwrap();
        assert_eq!(load(path.as_os_str()).unwrap().0.len(), 2);
        std::fs::write(&path, filled((1 << 20) + 1)).unwrap();
        let failure = load(path.as_os_str()).unwrap_err().to_string();
        assert!(failure.ends_with("long.toml: a text has at most 1048576 bytes, and this one has more"));
    }

    #[test]
    fn faults_name_line_and_key() {
        let item = "[[requirement]]\nquantity = \"position_up\"\npercent = 95\n";
        for (text, fault) in [
            ("", "0 items [[requirement]]: expected 1 to 100"),
            ("titel = \"a\"\n", "1: titel: expected title"),
            ("x = \n", "1: "),
            ("[[requirement]]\npercent = 9\n", "1: quantity: expected one of position_horizontal, "),
            (item, "2: quantity: expected one limit"),
            (&format!("{item}limit_m = 1\nlimit_km = 1\n"), "2: quantity: expected one limit"),
            (&format!("{item}limit_kn = 1\n"), "4: limit_kn: is no unit of position_up"),
            (&format!("{item}limit_m = -1\n"), "4: limit_m: expected a number above 0"),
            (&format!("{item}limit_m = nan\n"), "4: limit_m: expected a number above 0"),
            (&format!("{item}limit_m = 1\ntime = 1\n"), "5: time: no such key; did you mean time_h?"),
            (&item.replace("95", "100"), "3: percent: expected a number above 0 and below 100"),
        ] {
            let failure = parse(text, Path::new("a.toml")).unwrap_err().to_string();
            assert!(
                failure.starts_with(&format!("a.toml:{fault}")) || failure.contains(fault),
                "{text}: {failure}"
            );
        }
    }
}
