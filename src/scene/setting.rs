//! Settings: values that are set in addition to the text of a scene.

use core::ops::Range;

use super::fault::Faults;
use super::key::{Key, Target};
use super::site::{Site, ValuePath};
use super::value::Value;

/// A value that takes the place of the text's.
#[derive(Debug)]
pub(super) struct Setting {
    pub path: ValuePath,
    /// Whether the scene has the item that it sets.
    pub is_used: bool,
    pub span: Range<usize>,
    text: String,
    value: Value,
}

impl Setting {
    /// Whether it sets a key of a section or an item.
    pub fn is_of(&self, site: Site, key: usize) -> bool {
        (self.path.site, self.path.key) == (site, key)
    }

    /// Whether it puts the default back.
    pub fn is_default(&self) -> bool {
        self.text.is_empty()
    }

    /// Its value, as its key takes it: a text needs no quotes, whatever it is.
    pub fn value_for(&self, key: &Key) -> Value {
        match (key.target, &self.value) {
            (_, value @ Value::Text(_)) => value.clone(),
            (Target::Text { .. }, _) => Value::Text(self.text.clone()),
            (_, value) => value.clone(),
        }
    }
}

/// The settings of paths and values; notes what is wrong with a path.
pub(super) fn take_settings(settings: &[(&str, &str)], faults: &mut Faults<'_>) -> Vec<Setting> {
    let mut taken: Vec<Setting> = Vec::new();
    for (index, (path, text)) in settings.iter().enumerate() {
        // Each unknown key is compared with all keys.
        if faults.are_many() {
            break;
        }
        let span = faults.setting_span(index);
        match ValuePath::read(path) {
            Ok(path) => {
                taken.retain(|earlier| earlier.path != path);
                faults.name(&span, path.site, Some(path.key));
                let (value, text) = (Value::of_setting(text), (*text).to_owned());
                taken.push(Setting { path, is_used: false, span, text, value });
            }
            Err(sentence) => faults.add(&span, sentence),
        }
    }
    taken
}
