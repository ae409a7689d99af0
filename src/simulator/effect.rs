//! What can be set and left out alone, effect by effect.

use super::ErrorParameters;
use crate::base::joined::{joined, total};
use crate::base::parameter::Row;
use crate::sensors::{ALTIMETER, GRAVITY, INITIAL, PARAMETERS, Sensor};
use crate::signal::mounting::MOUNTING;

/// An effect that can be set and left out alone.
#[derive(Debug, Clone, Copy)]
pub struct BudgetEffect {
    /// Name of the effect.
    pub name: &'static str,
    /// The field of the interface that sets it; 0 there leaves it out.
    pub field: &'static str,
    /// Whether it is drawn anew each run.
    pub is_random: bool,
}

/// The effects of a table.
macro_rules! of {
    ($table:expr) => {
        &effects::<{ count($table) }>($table)
    };
}

/// All of them: of gravity, of the sensors as their table has them, of the altimeter, of the start and of the mounting.
pub static EFFECTS: &[BudgetEffect] = &joined::<BudgetEffect, { total(PARTS) }>(PARTS);

const PARTS: &[&[BudgetEffect]] = &[
    of!(Table::Rows(&GRAVITY)),
    of!(Table::Triad(Sensor::Gyro)),
    of!(Table::Triad(Sensor::Accelerometer)),
    of!(Table::Backwards(&ALTIMETER)),
    of!(Table::Rows(&INITIAL)),
    of!(Table::Rows(&MOUNTING)),
];

/// A table of parameters.
#[derive(Clone, Copy)]
enum Table {
    Triad(Sensor),
    Rows(&'static [Row]),
    /// From the last row to the first.
    Backwards(&'static [Row]),
}

impl Table {
    const fn len(self) -> usize {
        match self {
            Self::Triad(_) => PARAMETERS.len(),
            Self::Rows(rows) | Self::Backwards(rows) => rows.len(),
        }
    }

    /// The effect of a row, if the row has one of its own.
    const fn effect(self, row: usize) -> Option<BudgetEffect> {
        let (field, is_random) = match self {
            Self::Triad(sensor) => (PARAMETERS[row].of(sensor), PARAMETERS[row].is_random),
            Self::Rows(rows) => (Some(rows[row].field), rows[row].is_random),
            Self::Backwards(rows) => return Self::Rows(rows).effect(rows.len() - 1 - row),
        };
        match field {
            Some(field) if !field.effect.is_empty() => {
                Some(BudgetEffect { name: field.effect, field: field.path, is_random })
            }
            _ => None,
        }
    }
}

/// Number of effects of a table.
const fn count(table: Table) -> usize {
    let (mut row, mut count) = (0, 0);
    while row < table.len() {
        if table.effect(row).is_some() {
            count += 1;
        }
        row += 1;
    }
    count
}

/// The effects of a table.
const fn effects<const N: usize>(table: Table) -> [BudgetEffect; N] {
    let none = BudgetEffect { name: "", field: "", is_random: false };
    let mut effects = [none; N];
    let (mut row, mut count) = (0, 0);
    while row < table.len() {
        if let Some(effect) = table.effect(row) {
            effects[count] = effect;
            count += 1;
        }
        row += 1;
    }
    effects
}

impl BudgetEffect {
    /// Whether it is set. Not inlined, as [`Self::copy`]: its copy of the parameters is not on the stack while the budget flies.
    #[inline(never)]
    fn is_set(&self, from: &ErrorParameters) -> bool {
        { *from }.numbers_of(self.field).any(|number| *number != 0.0)
    }

    /// Copies the numbers of its field, and those of its correlation time or distance.
    #[inline(never)]
    fn copy(&self, from: &ErrorParameters, to: &mut ErrorParameters) {
        let mut from = *from;
        for path in super::with_time(self.field) {
            to.numbers_of(path).zip(from.numbers_of(path)).for_each(|(to, from)| *to = *from);
        }
    }

    /// Those that `parameters` set, in order.
    pub fn set_in(parameters: &ErrorParameters) -> impl Iterator<Item = &'static Self> {
        EFFECTS.iter().filter(|effect| effect.is_set(parameters))
    }

    /// `parameters` with nothing but this effect.
    pub(crate) fn alone(&self, parameters: &ErrorParameters) -> ErrorParameters {
        let mut alone = parameters.ideal();
        self.copy(parameters, &mut alone);
        alone
    }

    /// `parameters` with nothing but what is drawn.
    pub(crate) fn random_of(parameters: &ErrorParameters) -> ErrorParameters {
        let mut random = parameters.ideal();
        Self::set_in(parameters)
            .filter(|effect| effect.is_random)
            .for_each(|effect| effect.copy(parameters, &mut random));
        random
    }

    /// Takes this effect out of `parameters`.
    pub(crate) fn leave_out(&self, parameters: &mut ErrorParameters) {
        self.copy(&ErrorParameters::default(), parameters);
    }
}

impl PartialEq for BudgetEffect {
    fn eq(&self, other: &Self) -> bool {
        self.field == other.field
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sensors::{Alignment, TriadParameters};

    /// Every field: one of a table is in it; another one does not compile until it stands here, and fails until it has its line.
    fn everything() -> ErrorParameters {
        let triad = |sensor| {
            let mut triad = TriadParameters::default();
            let rows = triad.numbers_mut().into_iter().zip(PARAMETERS);
            rows.filter(|(_, row)| row.of(sensor).is_some()).for_each(|(numbers, _)| numbers.fill(1.0));
            triad
        };
        let mut all = ErrorParameters {
            gyro: triad(Sensor::Gyro),
            accel: triad(Sensor::Accelerometer),
            ..ErrorParameters::default()
        };
        all.initial.alignment = Alignment::LevelAndGyrocompass;
        for row in super::super::rows() {
            all.numbers_of(row.field.path).for_each(|number| *number = 1.0);
        }
        all
    }

    #[test]
    fn every_field_belongs_to_one_effect() {
        let all = everything();
        assert_eq!(BudgetEffect::set_in(&all).count(), EFFECTS.len());
        assert_eq!(BudgetEffect::set_in(&all.ideal()).count(), 0);
        let (mut together, mut left) = (all.ideal(), all);
        for effect in EFFECTS {
            let set: Vec<&BudgetEffect> = BudgetEffect::set_in(&effect.alone(&all)).collect();
            assert_eq!(set, [effect]);
            effect.copy(&all, &mut together);
            effect.leave_out(&mut left);
        }
        assert_eq!(together, all);
        assert_eq!(left, all.ideal());
    }

    #[test]
    fn names_and_fields_are_distinct_and_fit_the_interface() {
        for (index, effect) in EFFECTS.iter().enumerate() {
            // char effect[32], field[48] with a terminator.
            assert!(effect.name.len() < 32 && effect.field.len() < 48, "{}", effect.name);
            for other in &EFFECTS[..index] {
                assert!(effect.name != other.name && effect.field != other.field, "{}", effect.name);
            }
        }
    }

    /// A correlation time or distance without a standard deviation is no effect, nor is a mounting that is believed.
    #[test]
    fn what_is_off_is_no_effect() {
        let mut parameters = ErrorParameters::default();
        parameters.gyro.markov_time_s.x = 100.0;
        parameters.accel.bias.y = -0.0;
        parameters.gravity.anomaly.distance_m = 1e4;
        parameters.mounting.lever_arm_m.x = 5.0;
        parameters.mounting.boresight.heading = 1.0;
        assert_eq!(BudgetEffect::set_in(&parameters).count(), 0);
    }
}
