//! The state of an instance as bytes, which other machines can load too.

use std::path::PathBuf;

use crate::inputs;
use crate::instance::{Flight, Instance, Phase, Taken};
use crate::table::table;
use crate::values::Values;
use crate::variable::Role;

/// Mark at the beginning of a state.
const MARK: &[u8; 8] = b"SINSFMU2";

const DAMAGED: &str = "no state of this unit, or a damaged one";

const PHASES: [Phase; 4] = [Phase::Instantiated, Phase::Initializing, Phase::Stepping, Phase::Terminated];

/// The state of `instance`, and its hash.
pub fn save(instance: &Instance) -> Result<Vec<u8>, String> {
    let mut state = write(instance)?;
    let hash = hash(&state);
    state.extend(hash.to_le_bytes());
    Ok(state)
}

fn write(instance: &Instance) -> Result<Vec<u8>, String> {
    let mut to = Vec::with_capacity(16 << 10);
    to.extend(MARK);
    to.push(PHASES.iter().position(|phase| *phase == instance.phase).unwrap_or(0) as u8);
    to.extend(instance.is_set.map(u8::from));
    to.extend(instance.end_s.to_le_bytes());
    let Values { reals, integers, booleans, strings } = &instance.values;
    reals.iter().for_each(|value| to.extend(value.to_le_bytes()));
    integers.iter().for_each(|value| to.extend(value.to_le_bytes()));
    to.extend(booleans.iter().map(|&value| u8::from(value)));
    for text in strings {
        to.extend((text.len() as u64).to_le_bytes());
        to.extend(text.as_bytes());
    }
    let Some(flight) = &instance.flight else {
        to.push(0);
        return Ok(to);
    };
    to.push(1);
    to.push(u8::from(flight.taken.is_some()));
    if let Some(Taken { time_s, inputs, corrections, entries }) = &flight.taken {
        to.extend(time_s.to_le_bytes());
        inputs.iter().for_each(|value| to.extend(value.to_le_bytes()));
        to.extend(corrections.to_le_bytes());
        entries.iter().for_each(|count| to.extend(count.to_le_bytes()));
    }
    let from = to.len();
    to.resize(from + flight.play.snapshot_size(), 0);
    flight.play.save_snapshot(&mut to[from..]).map_err(|error| error.to_string())?;
    Ok(to)
}

/// Hash of a state without its hash: FNV-1a of 64 bits.
fn hash(state: &[u8]) -> u64 {
    let fold = |hash: u64, byte: &u8| (hash ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3);
    state.iter().fold(0xcbf2_9ce4_8422_2325, fold)
}

/// The instance of a state. Its scene is made anew if its parameters differ from the parameters of `now`.
pub fn load(state: &[u8], now: &Instance) -> Result<Instance, String> {
    let (state, own_hash) = state.split_last_chunk().ok_or(DAMAGED)?;
    if hash(state).to_le_bytes() != *own_hash {
        return Err(DAMAGED.to_owned());
    }
    read(state, now.resources.clone(), now).ok_or(DAMAGED)?
}

/// Reads an instance; `None` if `state` ends too early or is no state.
fn read(state: &[u8], resources: Option<PathBuf>, now: &Instance) -> Option<Result<Instance, String>> {
    let mut from = Reader { rest: state.strip_prefix(MARK)? };
    let mut instance = Instance::new(resources);
    instance.phase = *PHASES.get(usize::from(from.byte()?))?;
    for is_set in &mut instance.is_set {
        *is_set = from.flag()?;
    }
    instance.end_s = from.number()?;
    let Values { reals, integers, booleans, strings } = &mut instance.values;
    for value in reals {
        *value = from.number()?;
    }
    for value in integers {
        *value = from.integer()?;
    }
    for value in booleans {
        *value = from.flag()?;
    }
    for text in strings {
        *text = String::from_utf8(from.part()?.to_vec()).ok()?;
    }
    if !from.flag()? {
        let is_flying = instance.phase == Phase::Stepping;
        return (from.rest.is_empty() && !is_flying).then_some(Ok(instance));
    }
    let has_taken = from.flag()?;
    let taken = match has_taken {
        true => Some(Taken {
            time_s: from.number()?,
            inputs: (0..inputs::COUNT).map(|_| from.number()).collect::<Option<Vec<f64>>>()?,
            corrections: from.integer()?,
            entries: [from.integer()?, from.integer()?, from.integer()?],
        }),
        false => None,
    };
    Some(with_flight(instance, taken, from, now))
}

/// The instance with its scene in flight, from a snapshot.
fn with_flight(
    mut instance: Instance,
    taken: Option<Taken>,
    from: Reader<'_>,
    now: &Instance,
) -> Result<Instance, String> {
    let mut flight = match &now.flight {
        Some(flight) if have_same_parameters(&instance.values, &now.values) => flight.clone(),
        _ => Flight::new(&instance.values, instance.resources.as_ref())?,
    };
    flight.play.load_snapshot(from.rest).map_err(|error| error.to_string())?;
    flight.taken = taken;
    instance.flight = Some(flight);
    Ok(instance)
}

/// Whether all parameters are the same, to the bit.
fn have_same_parameters(one: &Values, other: &Values) -> bool {
    let table = table();
    [Role::Fixed, Role::Tunable].into_iter().flat_map(|role| table.of_role(role)).all(|(variable, place)| {
        let base = variable.start.base();
        one.get(base, place) == other.get(base, place)
    })
}

/// The bytes that are still to be read.
struct Reader<'s> {
    rest: &'s [u8],
}

impl Reader<'_> {
    fn bytes<const N: usize>(&mut self) -> Option<[u8; N]> {
        let (bytes, rest) = self.rest.split_first_chunk::<N>()?;
        self.rest = rest;
        Some(*bytes)
    }

    /// A part behind its length.
    fn part(&mut self) -> Option<&[u8]> {
        let length = usize::try_from(u64::from_le_bytes(self.bytes()?)).ok()?;
        let (part, rest) = self.rest.split_at_checked(length)?;
        self.rest = rest;
        Some(part)
    }

    fn byte(&mut self) -> Option<u8> {
        self.bytes().map(|[byte]| byte)
    }

    fn flag(&mut self) -> Option<bool> {
        match self.byte()? {
            0 => Some(false),
            1 => Some(true),
            _ => None,
        }
    }

    fn number(&mut self) -> Option<f64> {
        self.bytes().map(f64::from_le_bytes)
    }

    fn integer(&mut self) -> Option<i32> {
        self.bytes().map(i32::from_le_bytes)
    }
}
