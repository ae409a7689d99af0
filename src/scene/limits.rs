//! The limits of the numbers of a key, from the range in its row.

use super::key::{Key, Target};
use crate::base::parameter::Range;

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

/// A number with this limit is any number.
pub const ANY: f64 = 1e300;

/// The limits of a key; of a key of several kinds of items the widest. `None`: there are none, or they depend on other values.
pub fn limits(key: &Key) -> Option<Limits> {
    let (range, si) = match key.target {
        Target::Numbers { range, unit, .. } => (range?, unit.si),
        Target::Count { range, .. } => (range?, 1.0),
        _ => return None,
    };
    let (low, high) = range.ends();
    // Without the process whose correlation time it is, such a number may be 0.
    let low = if range.needed_by().is_some() { 0.0 } else { low };
    let zero_is_off = matches!(range, Range::OffOr(..) | Range::OrDefault(..));
    let is_within = |number: f64| (low..=high).contains(&(number * si));
    let limits =
        Limits { low: in_unit(low / si, is_within), high: in_unit(high / si, is_within), zero_is_off };
    (high < ANY).then_some(limits)
}

/// A limit in a unit: of its neighbours the shortest one that is accepted.
fn in_unit(limit: f64, is_within: impl Fn(f64) -> bool) -> f64 {
    let near = [limit.next_down(), limit, limit.next_up()].into_iter().filter(|number| is_within(*number));
    near.min_by_key(|number| number.to_string().len()).unwrap_or(limit)
}
