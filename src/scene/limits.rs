//! The limits of the numbers of a key. The checks of the library state them in their errors: a check is called with a number beyond
//! every limit, and its error is read.

use super::draft::{Draft, FailureDraft, NO_UPDATE, planned_update};
use super::key::{Key, Section, Target};
use super::table::{SENSORS, of_sensor};
use super::value::{Value, put};
use super::{PlannedUpdate, Scene, Updated};
use crate::base::error::{Error, Rule};
use crate::sensors::FailureFields;
use crate::truth::flight::{Channel, Manoeuvre, ManoeuvreFields, Sinusoid, Sinusoids};

/// Least and greatest allowed number of a key, in its unit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits {
    /// The least.
    pub low: f64,
    /// The greatest.
    pub high: f64,
    /// Whether 0 is allowed too, and means none.
    pub zero_is_off: bool,
}

/// Beyond every limit.
const BEYOND: f64 = 1e300;

/// The limits of a key; of a key of several kinds of items the widest. `None`: there are none, or they depend on other values.
pub fn limits(key: &Key) -> Option<Limits> {
    let of_kinds = match key.section {
        Section::Manoeuvre => of_manoeuvre(key),
        Section::Sinusoid => of_sinusoid(key),
        Section::Failure => of_failure(key),
        Section::Update => of_update(key),
        Section::Panel => vec![of_action(key)],
        _ => vec![of_section(key)],
    };
    of_kinds.into_iter().flatten().reduce(|one, other| Limits {
        low: one.low.min(other.low),
        high: one.high.max(other.high),
        zero_is_off: one.zero_is_off && other.zero_is_off,
    })
}

/// Puts a value beyond every limit. Returns whether the key takes numbers.
fn exceed(draft: &mut Draft, key: &Key) -> bool {
    match key.target {
        Target::Numbers { shape, .. } => {
            let value = match shape.single_sets(1) {
                Some(_) => Value::Number(BEYOND),
                None => Value::Numbers(vec![BEYOND; shape.count()]),
            };
            put(draft, key, true, &value).is_ok()
        }
        Target::Count { set, .. } => {
            set(draft, u64::MAX);
            true
        }
        _ => false,
    }
}

/// The limits that the error of a check states, if it is about `key`.
fn stated(key: &Key, checked: Result<(), Error>) -> Option<Limits> {
    let error = checked.err()?;
    let name = |field: &'static str| field.split_once('.').map_or(field, |(_, name)| name);
    let (Some(low), Some(high)) = error.rule.limits() else { return None };
    if !name(key.field()).starts_with(name(error.field)) {
        return None;
    }
    let si = if let Target::Numbers { unit, .. } = key.target { unit.si } else { 1.0 };
    let zero_is_off = matches!(error.rule, Rule::OffOr(..) | Rule::DefaultOr(..));
    let is_within = |number: f64| (low..=high).contains(&(number * si));
    Some(Limits { low: in_unit(low / si, is_within), high: in_unit(high / si, is_within), zero_is_off })
}

/// A limit in a unit: of its neighbours the shortest one that is accepted.
fn in_unit(limit: f64, is_within: impl Fn(f64) -> bool) -> f64 {
    let near = [limit.next_down(), limit, limit.next_up()].into_iter().filter(|number| is_within(*number));
    near.min_by_key(|number| number.to_string().len()).unwrap_or(limit)
}

fn of_section(key: &Key) -> Option<Limits> {
    let mut draft = Draft::from(&Scene::default());
    draft.closed_loop = true;
    if !exceed(&mut draft, key) {
        return None;
    }
    let rest = vec![Manoeuvre::Rest { duration_s: 3600.0 }];
    let whole = |draft: Draft| draft.into_scene(rest).flown_s().map(|_| ());
    stated(key, draft.validate(key.section).and_then(|()| whole(draft)))
}

/// Speeds at the start of a manoeuvre. A limit that is not the same at both depends on the flight, and is not stated.
const SPEEDS_M_S: [f64; 2] = [100.0, 200.0];

fn of_flight(key: &Key, manoeuvre: &Manoeuvre) -> Option<Limits> {
    let [one, other] = SPEEDS_M_S.map(|speed_m_s| stated(key, manoeuvre.validate(speed_m_s)));
    one.filter(|_| one == other)
}

/// A manoeuvre of any kind, within all limits.
fn some_manoeuvre(kind: usize) -> ManoeuvreFields {
    ManoeuvreFields {
        kind,
        duration_s: 1e3,
        speed_change_m_s: 1.0,
        height_change_m: 1.0,
        heading_change_rad: 1.0,
        bank_rad: 0.5,
        turns: 1.0,
        sinusoids: Sinusoids::of(&[Sinusoid::NONE]),
        ..ManoeuvreFields::default()
    }
}

fn of_manoeuvre(key: &Key) -> Vec<Option<Limits>> {
    let of_kind = |kind| {
        let mut draft = Draft::from(&Scene::default());
        draft.manoeuvre = some_manoeuvre(kind);
        let is_used = key.is_used(&draft) && exceed(&mut draft, key);
        if is_used { of_flight(key, &draft.manoeuvre.kind()?) } else { None }
    };
    (0..ManoeuvreFields::KINDS.len()).map(of_kind).collect()
}

fn of_sinusoid(key: &Key) -> Vec<Option<Limits>> {
    let of_channel = |(_, channel): &(&str, _)| {
        let mut draft = Draft::from(&Scene::default());
        draft.sinusoid = Sinusoid { channel: *channel, ..Sinusoid::NONE };
        if !key.is_used(&draft) || !exceed(&mut draft, key) {
            return None;
        }
        let sinusoids = Sinusoids::of(&[draft.sinusoid]);
        of_flight(key, &Manoeuvre::Sinusoids { duration_s: 1e3, ramp_s: 5.0, sinusoids })
    };
    Channel::WORDS.iter().map(of_channel).collect()
}

fn of_failure(key: &Key) -> Vec<Option<Limits>> {
    let mut all = Vec::new();
    for sensor in (0..SENSORS.len()).filter(|sensor| of_sensor(key, *sensor).is_none()) {
        for kind in 1..FailureFields::KINDS.len() {
            let mut draft = Draft::from(&Scene::default());
            // Drop-outs are random without an interval.
            let interval_s = if key.name == "probability" { 0.0 } else { 1.0 };
            let fields = FailureFields { kind, interval_s, duration_s: 1e-3, ..FailureFields::default() };
            draft.failure = FailureDraft { sensor, fields, ..FailureDraft::default() };
            if exceed(&mut draft, key) {
                all.push(stated(key, draft.failure.to_planned().map(|_| ())));
            }
        }
    }
    all
}

fn of_update(key: &Key) -> Vec<Option<Limits>> {
    let of_kind = |&(_, updated): &(&str, _)| {
        let mut draft = Draft::from(&Scene::default());
        draft.update = PlannedUpdate { updated, at_s: 1.0, ..NO_UPDATE };
        let is_used = key.is_used(&draft) && exceed(&mut draft, key);
        if is_used { stated(key, planned_update(&draft.update).map(|_| ())) } else { None }
    };
    Updated::WORDS.iter().map(of_kind).collect()
}

fn of_action(key: &Key) -> Option<Limits> {
    let mut draft = Draft::from(&Scene::default());
    if exceed(&mut draft, key) { stated(key, draft.action.validate()) } else { None }
}
