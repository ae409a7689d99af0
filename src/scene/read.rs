//! The reader of scenes: every fault of a text, each at its place.

use core::ops::Range;

use toml::de::{DeTable, DeValue};

use super::draft::{Draft, FAILURE_KINDS, FailureDraft, KINDS, ManoeuvreDraft, SinusoidDraft};
use super::fault::{Fault, Faults, excerpt, nearest};
use super::key::{Key, Section, Target};
use super::table::{self, KEYS};
use super::value::{Value, put};
use super::{BUILTIN_SCENES, MAX_TEXT, Scene};
use crate::error::{Error, Rule};
use crate::flight::{Channel, MAX_MANOEUVRES, MAX_SINUSOIDS, Manoeuvre};
use crate::mechanization::VerticalMode;
use crate::sensors::{Sensor, SensorOutput};

type Span = Range<usize>;

/// A section, or an item of a list: where its head stands, and where those of its keys that the text sets, by their
/// place in the table.
#[derive(Debug, Clone, Default)]
struct Item {
    head: Span,
    keys: Vec<(usize, Span)>,
}

impl Item {
    /// Where the key of `name` stands.
    fn key(&self, name: &str) -> Option<&Span> {
        self.keys.iter().find(|(index, _)| KEYS[*index].name == name).map(|(_, span)| span)
    }

    /// The key that the text sets for the field of an error, and where.
    fn of_field(&self, field: &str) -> Option<(&'static Key, &Span)> {
        let sets = |key: &Key| !field.is_empty() && key.field().starts_with(field);
        self.keys.iter().find(|(index, _)| sets(&KEYS[*index])).map(|(index, span)| (&KEYS[*index], span))
    }
}

impl Scene {
    /// The scene of a text in TOML (UTF-8); or all that is wrong with it.
    pub fn parse(text: &[u8]) -> Result<Self, Vec<Fault>> {
        let whole = |sentence: String| vec![Fault { line: 1, column: 1, sentence }];
        if text.len() > MAX_TEXT {
            return Err(whole(format!("{} bytes: a scene has at most {MAX_TEXT}", text.len())));
        }
        let text = core::str::from_utf8(text).map_err(|error| {
            let before = &text[..error.valid_up_to()];
            let line = 1 + before.iter().filter(|&&byte| byte == b'\n').count();
            vec![Fault { line, column: 1, sentence: "not UTF-8".to_owned() }]
        })?;
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let (root, errors) = DeTable::parse_recoverable(text);
        let mut reader = Reader {
            faults: Faults::new(text),
            draft: Draft::from(&Self::default()),
            sections: Section::ALL.map(|_| Item::default()),
            manoeuvres: Vec::new(),
            items: Vec::new(),
        };
        for error in &errors {
            reader.faults.add(&error.span().unwrap_or(0..0), error.message());
        }
        if errors.is_empty() {
            reader.read_root(root.get_ref());
            reader.check_together();
            reader.check_values();
        }
        reader.into_scene()
    }
}

struct Reader<'t> {
    faults: Faults<'t>,
    draft: Draft,
    sections: [Item; Section::ALL.len()],
    manoeuvres: Vec<Manoeuvre>,
    /// Where each manoeuvre stands.
    items: Vec<Item>,
}

impl Reader<'_> {
    fn section(&self, section: Section) -> &Item {
        &self.sections[section as usize]
    }

    fn read_root(&mut self, root: &DeTable<'_>) {
        for (name, value) in root {
            let (name, span) = (name.get_ref().as_ref(), name.span());
            let section = Section::ALL.into_iter().find(|section| section.name() == name);
            match (section, value.get_ref()) {
                (Some(section), DeValue::Table(section_table)) if !section.is_list() => {
                    let item = self.read_keys(section, span, section_table);
                    self.sections[section as usize] = item;
                }
                (Some(section), DeValue::Array(array)) if section.is_list() => {
                    for element in array.iter() {
                        let head = element.span();
                        match element.get_ref() {
                            DeValue::Table(item) if section == Section::Manoeuvre => {
                                self.read_manoeuvre(head, item);
                            }
                            DeValue::Table(item) => self.read_failure(head, item),
                            _ => self.faults.add(&head, format!("expected [[{name}]]")),
                        }
                    }
                }
                (Some(section), _) if section.is_list() => {
                    self.faults.add(&span, format!("{name}: expected [[{name}]], in double brackets"));
                }
                (Some(_), _) => self.faults.add(&span, format!("{name}: expected [{name}], in brackets")),
                (None, DeValue::Table(_) | DeValue::Array(_)) => {
                    let names = Section::ALL.into_iter().map(Section::name);
                    self.faults.add(&span, unknown("section", name, nearest(name, names)));
                }
                (None, _) => {
                    let sentence = format!("{}: expected a [section] before it", excerpt(name));
                    self.faults.add(&span, sentence);
                }
            }
        }
    }

    /// Reads the keys of a section in the order of the table, so that a preset comes before what differs from it.
    fn read_keys(&mut self, section: Section, head: Span, section_table: &DeTable<'_>) -> Item {
        let mut item = Item { head, keys: Vec::new() };
        for (index, key) in table::of_section(section) {
            let mut first: Option<&str> = None;
            for (name, in_si) in [(Some(key.name), false), (key.si_name(), true)] {
                let found =
                    name.and_then(|name| section_table.get_key_value(name).map(|found| (name, found)));
                let Some((name, (at, value))) = found else { continue };
                if let Some(first) = first {
                    self.faults.add(&at.span(), format!("{name}: the same quantity as {first}; give one"));
                    continue;
                }
                first = Some(name);
                item.keys.push((index, at.span()));
                if let Err(sentence) = put(&mut self.draft, key, in_si, &Value::of(value.get_ref())) {
                    self.faults.add(&value.span(), sentence);
                }
            }
        }
        for (name, value) in section_table {
            let (name, span) = (name.get_ref().as_ref(), name.span());
            let is_sinusoids = section == Section::Manoeuvre && name == "sinusoid";
            let names =
                || table::of_section(section).flat_map(|(_, key)| [Some(key.name), key.si_name()]).flatten();
            if is_sinusoids && !matches!(value.get_ref(), DeValue::Array(_)) {
                self.faults.add(&span, "sinusoid: expected [[manoeuvre.sinusoid]], in double brackets");
            } else if !is_sinusoids && !names().any(|known| known == name) {
                self.faults.add(&span, unknown("key", name, nearest(name, names())));
            }
        }
        item
    }

    fn read_manoeuvre(&mut self, head: Span, section_table: &DeTable<'_>) {
        self.draft.manoeuvre = ManoeuvreDraft::default();
        let item = self.read_keys(Section::Manoeuvre, head.clone(), section_table);
        if let Some(DeValue::Array(sinusoids)) = section_table.get("sinusoid").map(|value| value.get_ref()) {
            for sinusoid in sinusoids.iter() {
                match sinusoid.get_ref() {
                    DeValue::Table(item) => self.read_sinusoid(sinusoid.span(), item),
                    _ => self.faults.add(&sinusoid.span(), "expected [[manoeuvre.sinusoid]]"),
                }
            }
        }
        let (kind, uses) = KINDS[self.draft.manoeuvre.kind];
        if item.key("kind").is_none() {
            self.faults.add(&head, "[[manoeuvre]]: expected its kind");
        } else {
            for (index, span) in &item.keys {
                let name = KEYS[*index].name;
                if name != "kind" && !uses.contains(&name) {
                    self.faults.add(span, format!("manoeuvre.{name}: {kind} does not use it"));
                }
            }
            if kind != "sinusoids" && !self.draft.manoeuvre.sinusoids.is_empty() {
                self.faults.add(&head, format!("[[manoeuvre.sinusoid]]: {kind} has none"));
            }
        }
        if self.items.len() == MAX_MANOEUVRES {
            self.faults.add(&head, format!("[[manoeuvre]]: more than {MAX_MANOEUVRES}"));
            return;
        }
        self.manoeuvres.push(self.draft.manoeuvre.to_manoeuvre());
        self.items.push(item);
    }

    fn read_sinusoid(&mut self, head: Span, section_table: &DeTable<'_>) {
        self.draft.sinusoid = SinusoidDraft::default();
        let item = self.read_keys(Section::Sinusoid, head.clone(), section_table);
        let is_speed = self.draft.sinusoid.channel == Channel::Speed;
        let (own, other) =
            if is_speed { ("amplitude_m_s", "amplitude_deg") } else { ("amplitude_deg", "amplitude_m_s") };
        if item.key("channel").is_none() {
            self.faults.add(&head, "[[manoeuvre.sinusoid]]: expected its channel");
        } else if let Some(span) = item.key(other) {
            self.faults.add(span, format!("sinusoid.{other}: not of this channel; expected {own}"));
        }
        if self.draft.manoeuvre.sinusoids.len() == MAX_SINUSOIDS {
            self.faults
                .add(&head, format!("[[manoeuvre.sinusoid]]: more than {MAX_SINUSOIDS} in a manoeuvre"));
            return;
        }
        self.draft.manoeuvre.sinusoids.push(self.draft.sinusoid.to_sinusoid());
    }

    fn read_failure(&mut self, head: Span, section_table: &DeTable<'_>) {
        self.draft.failure = FailureDraft::default();
        let item = self.read_keys(Section::Failure, head.clone(), section_table);
        for name in ["sensor", "kind"] {
            if item.key(name).is_none() {
                self.faults.add(&head, format!("[[failure]]: expected its {name}"));
                return;
            }
        }
        let failure = self.draft.failure.clone();
        match (failure.sensor == 2, item.key("axis")) {
            (true, Some(span)) => self.faults.add(span, "failure.axis: the altimeter has one output alone"),
            (false, None) => self.faults.add(&head, "[[failure]]: expected its axis"),
            _ => {}
        }
        let (kind, uses) = FAILURE_KINDS[failure.kind];
        for (index, span) in &item.keys {
            let (name, field) = (KEYS[*index].name, KEYS[*index].field());
            let is_quantity =
                |quantity: &&str| field.strip_prefix("failure.").is_some_and(|f| f.starts_with(*quantity));
            let is_general = ["sensor", "axis", "kind", "from_s", "until_s"].contains(&name);
            if !is_general && !uses.iter().any(is_quantity) {
                self.faults.add(span, format!("failure.{name}: {kind} does not use it"));
            } else if let Some(own) = table::of_sensor(&KEYS[*index], failure.sensor) {
                self.faults.add(span, format!("failure.{name}: not of this sensor; expected {own}"));
            }
        }
        match failure.to_planned() {
            Ok(Some(planned)) => {
                if let Err(error) = self.draft.scene.add_failure(planned) {
                    self.faults.add(&head, error.to_string());
                }
            }
            Ok(None) => {}
            Err(error) => self.add_error(&error, &item),
        }
    }

    /// What single keys cannot tell: whether they go together.
    fn check_together(&mut self) {
        let flight = self.section(Section::Flight).clone();
        let sources = [flight.key("file").is_some(), flight.key("builtin").is_some(), !self.items.is_empty()];
        let head = if flight.keys.is_empty() { &(0..0) } else { &flight.head };
        match sources.iter().filter(|is_there| **is_there).count() {
            0 => self.faults.add(head, "[flight]: expected a flight: file, builtin or [[manoeuvre]]s"),
            1 => {}
            _ => self.faults.add(head, "[flight]: expected one alone of file, builtin and [[manoeuvre]]s"),
        }
        if let Some(span) = flight.key("builtin")
            && !BUILTIN_SCENES.iter().any(|(name, _)| *name == self.draft.builtin)
        {
            let names = || BUILTIN_SCENES.iter().map(|(name, _)| *name);
            let near = nearest(&self.draft.builtin, names());
            let listed = near.map_or(names().collect::<Vec<_>>().join(", "), |near| format!("{near}?"));
            let sentence =
                format!("flight.builtin = \"{}\": no such flight; {listed}", excerpt(&self.draft.builtin));
            self.faults.add(span, sentence);
        }
        if sources[0]
            && let Some(span) = flight.key("rate_hz")
        {
            self.faults.add(span, "flight.rate_hz: a flight log has its own time stamps");
        }
        if !sources[0]
            && let Some(span) = self.section(Section::Options).key("sample_period_s").cloned()
        {
            self.faults
                .add(&span, "options.sample_period_s: only of a log; this flight is sampled at rate_hz");
        }
        if !sources[2] {
            for (index, span) in &flight.keys {
                let key = &KEYS[*index];
                if key.field().starts_with("start.") || key.name == "repeat" {
                    self.faults.add(
                        span,
                        format!("{}: only with [[manoeuvre]]s; this flight has its own start", key.path()),
                    );
                }
            }
        }
        if flight.key("temperature_c").is_none()
            && let Some(span) = flight.key("temperature_change_c_h")
        {
            self.faults
                .add(span, "flight.temperature_change_c_h: only with temperature_c, from which it goes on");
        }
        self.check_altimeter();
        if let Some(span) = self.section(Section::Options).key("closed_loop_time_s").cloned()
            && !self.draft.closed_loop
        {
            self.faults.add(&span, "options.closed_loop_time_s: only with signal = \"closed-loop\"");
        }
        if let Some(span) = self.section(Section::Output).key("name").cloned()
            && self.draft.scene.output.name.contains(['/', '\\'])
        {
            self.faults
                .add(&span, "output.name: has a folder; expected a name without, the folder by itself");
        }
    }

    fn check_altimeter(&mut self) {
        if self.draft.scene.options.vertical == VerticalMode::Damped {
            return;
        }
        let altimeter = self.section(Section::Altimeter).clone();
        if !altimeter.keys.is_empty() {
            self.faults.add(&altimeter.head, "[altimeter]: acts with options.vertical = \"damped\" alone");
        }
        if self.draft.scene.failures.iter().any(|planned| planned.output == SensorOutput::Altimeter) {
            let head = self.section(Section::Options).head.clone();
            self.faults
                .add(&head, "[options]: a failure of the altimeter acts with vertical = \"damped\" alone");
        }
    }

    /// The limits of the library, each fault in turn: a value that is refused is put back to its default and the rest checked.
    fn check_values(&mut self) {
        self.check(Section::Options, |draft| draft.clone().into_scene(Vec::new()).options.validate());
        self.check(Section::Gyro, |draft| draft.scene.gyro.validate(Sensor::Gyro));
        self.check(Section::Accelerometer, |draft| draft.scene.accel.validate(Sensor::Accelerometer));
        self.check(Section::Altimeter, |draft| draft.scene.altimeter.validate());
        self.check(Section::Start, |draft| draft.scene.initial.validate());
        self.check(Section::Mounting, |draft| draft.scene.mounting.validate());
        self.check(Section::Gravity, |draft| draft.scene.gravity.validate());
        self.check(Section::Flight, |draft| draft.start.validate());
    }

    fn check(&mut self, section: Section, validate: impl Fn(&Draft) -> Result<(), Error>) {
        let item = self.section(section).clone();
        while let Err(error) = validate(&self.draft) {
            self.add_error(&error, &item);
            let Some((key, _)) = item.of_field(error.field) else { return };
            if self.faults.are_many() || !self.put_back(key) {
                return;
            }
        }
    }

    /// The default in place of the value of a key; whether that was another value.
    fn put_back(&mut self, key: &Key) -> bool {
        let mut default = Draft::from(&Scene::default());
        match key.target {
            Target::Numbers { place, .. } => {
                let mut has_changed = false;
                for (number, default) in place.of(&mut self.draft).into_iter().zip(place.of(&mut default)) {
                    has_changed |= number.to_bits() != default.to_bits();
                    *number = *default;
                }
                has_changed
            }
            Target::Count { get, set, .. } => {
                let has_changed = get(&self.draft) != get(&default);
                set(&mut self.draft, get(&default));
                has_changed
            }
            _ => false,
        }
    }

    /// Notes an error of the library at the key that set the field.
    fn add_error(&mut self, error: &Error, item: &Item) {
        match item.of_field(error.field) {
            Some((key, span)) => self.faults.add(span, sentence(error, key)),
            None => self.faults.add(&item.head, error.to_string()),
        }
    }

    /// The flight, as far as it can be checked without integrating it.
    fn check_flight(&mut self, scene: &Scene) {
        if scene.is_log() {
            return;
        }
        if let Err(error) = scene.flown_s() {
            let of_manoeuvre = error.index.map(|index| index % self.items.len().max(1));
            let item = match of_manoeuvre.and_then(|index| self.items.get(index)) {
                Some(item) => item.clone(),
                None => self.section(Section::Flight).clone(),
            };
            self.add_error(&Error { index: None, ..error }, &item);
        }
    }

    fn into_scene(mut self) -> Result<Scene, Vec<Fault>> {
        let manoeuvres = core::mem::take(&mut self.manoeuvres);
        let scene = self.draft.clone().into_scene(manoeuvres);
        if self.faults.is_empty() {
            self.check_flight(&scene);
        }
        if self.faults.is_empty() { Ok(scene) } else { Err(self.faults.into_list()) }
    }
}

fn unknown(what: &str, name: &str, near: Option<&str>) -> String {
    let near = near.map_or(String::new(), |near| format!("; {near}?"));
    format!("no such {what}: {}{near}", excerpt(name))
}

/// The library's error in the words and the unit of `key`.
fn sentence(error: &Error, key: &Key) -> String {
    let Target::Numbers { unit, .. } = key.target else { return error.to_string() };
    let in_unit = |number: f64| if unit.si == 1.0 { number } else { rounded(number / unit.si) };
    let rule = match error.rule {
        Rule::Between(low, high) => Rule::Between(in_unit(low), in_unit(high)),
        Rule::OffOr(low, high) => Rule::OffOr(in_unit(low), in_unit(high)),
        Rule::NeededBy(low, high, field) => Rule::NeededBy(in_unit(low), in_unit(high), field),
        Rule::Below(limit) => Rule::Below(in_unit(limit)),
        Rule::AtLeast(words, number) => Rule::AtLeast(words, in_unit(number)),
        Rule::AtMost(words, number) => Rule::AtMost(words, in_unit(number)),
        Rule::Exactly(words, number) => Rule::Exactly(words, in_unit(number)),
        Rule::WordsAnd(words, number) => Rule::WordsAnd(words, in_unit(number)),
        other => other,
    };
    let in_units = Error { field: "", value: None, rule, ..*error };
    let index = error.index.map_or(String::new(), |index| format!("[{index}]"));
    let value = error.value.map_or(String::new(), |value| format!(" = {}", in_unit(value.as_f64())));
    format!("{}{index}{value}: {in_units}", key.path())
}

/// Six digits: enough for a limit, and none that rounding made.
fn rounded(number: f64) -> f64 {
    format!("{number:.5e}").parse().unwrap_or(number)
}
