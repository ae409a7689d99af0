//! Where a value of a scene is: `gyro.bias_deg_h`, `gyro.bias_deg_h[1]`, `manoeuvre[3].sinusoid[0].phase_deg`.

use core::fmt;

use super::key::{Key, Section, Target};
use super::table::{KEYS, names_of, of_section};
use crate::base::text::{excerpt, nearest, unknown};

/// A section, or an item of a list.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Site {
    pub section: Section,
    /// Place of the item in its list, from 0; of a sinusoid that of its manoeuvre first. 0 where there is no list.
    pub item: [usize; 2],
}

/// Where a value is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ValuePath {
    pub site: Site,
    /// Index of the key in [`KEYS`].
    pub key: usize,
    /// Whether it is the key that takes the quantity in SI.
    pub in_si: bool,
    /// Which number of the key, from 0; `None`: all of them.
    pub element: Option<usize>,
}

impl From<Section> for Site {
    fn from(section: Section) -> Self {
        Self { section, item: [0; 2] }
    }
}

impl Site {
    /// The site that `text` names, or what is wrong with it.
    pub fn read(text: &str) -> Result<Self, String> {
        let (mut name, mut item, mut places) = (String::new(), [0; 2], 0);
        for part in text.split('.') {
            let (word, place) = subscript(part);
            name.push_str(if name.is_empty() { "" } else { "." });
            name.push_str(word);
            if let Some(place) = place {
                item[places.min(1)] = place;
                places += 1;
            }
        }
        let Some(section) = Section::ALL.into_iter().find(|section| section.name() == name) else {
            let names = Section::ALL.into_iter().map(Section::name);
            return Err(unknown("section", text, nearest(&name, names)));
        };
        let site = Self { section, item };
        if places == section.lists() { Ok(site) } else { Err(format!("{}: expected {site}", excerpt(text))) }
    }
}

impl fmt::Display for Site {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut places = self.item[..self.section.lists()].iter();
        for (index, part) in self.section.name().split('.').enumerate() {
            write!(f, "{}{part}", if index > 0 { "." } else { "" })?;
            if let Some(place) = places.next() {
                write!(f, "[{place}]")?;
            }
        }
        Ok(())
    }
}

impl ValuePath {
    /// The place that `text` names, or what is wrong with it.
    pub fn read(text: &str) -> Result<Self, String> {
        let Some((site, name)) = text.rsplit_once('.') else {
            return Err(format!("{}: expected section.key", excerpt(text)));
        };
        let site = Site::read(site)?;
        let (name, element) = subscript(name);
        let is_it = |key: &Key| key.name == name || key.si_name() == Some(name);
        let Some((index, key)) = of_section(site.section).find(|(_, key)| is_it(key)) else {
            return Err(unknown("key", name, nearest(name, names_of(site.section))));
        };
        let count = match key.target {
            Target::Numbers { shape, .. } if shape.count() > 1 => shape.count(),
            _ => 0,
        };
        if element.is_some_and(|element| element >= count) {
            return Err(format!("{}: {} has {count} elements", excerpt(text), key.path()));
        }
        Ok(Self { site, key: index, in_si: name != key.name, element })
    }

    /// The key.
    pub fn key(&self) -> &'static Key {
        &KEYS[self.key]
    }
}

impl fmt::Display for ValuePath {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}.{}", self.site, self.key().name)?;
        self.element.map_or(Ok(()), |element| write!(f, "[{element}]"))
    }
}

/// A name without the number in brackets behind it, and that number.
fn subscript(text: &str) -> (&str, Option<usize>) {
    let number = |text: &str| {
        let is_plain = text.bytes().all(|byte| byte.is_ascii_digit());
        if is_plain { text.parse().ok() } else { None }
    };
    let parts = text.strip_suffix(']').and_then(|text| text.split_once('['));
    match parts.and_then(|(name, place)| Some((name, number(place)?))) {
        Some((name, place)) => (name, Some(place)),
        None => (text, None),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_are_read_and_written() {
        for text in ["gyro", "failure[0]", "manoeuvre[12]", "manoeuvre[3].sinusoid[5]"] {
            assert_eq!(Site::read(text).unwrap().to_string(), text);
        }
        let path = ValuePath::read("manoeuvre[3].sinusoid[1].phase_rad").unwrap();
        assert_eq!((path.site.item, path.key().name, path.in_si), ([3, 1], "phase_deg", true));
        assert_eq!(ValuePath::read("gyro.misalignment_arcsec[8]").unwrap().element, Some(8));
        for (text, words) in [
            ("gyro", "gyro: expected section.key"),
            ("gryo.bias_deg_h", "no such section: gryo; did you mean gyro?"),
            ("gyro.bais_deg_h", "no such key: bais_deg_h; did you mean bias_deg_h?"),
            ("gyro[0].bias_deg_h", "gyro[0]: expected gyro"),
            ("failure.kind", "failure: expected failure[0]"),
            ("manoeuvre[2].sinusoid.phase_deg", "manoeuvre[2].sinusoid: expected manoeuvre[2].sinusoid[0]"),
            ("failure[-1].kind", "no such section: failure[-1]"),
            ("gyro.bias_deg_h[3]", "gyro.bias_deg_h[3]: gyro.bias_deg_h has 3 elements"),
            ("options.seed[0]", "options.seed[0]: options.seed has 0 elements"),
        ] {
            let told = ValuePath::read(text).unwrap_err();
            assert!(told.starts_with(words), "{told}, not {words}");
        }
    }
}
