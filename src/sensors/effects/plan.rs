//! The active effects, in the order in which they act on an increment.

use core::ops::Range;

use super::Name;

/// Stages along the path of the signal, in order.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Stage {
    OnInput,
    DrawnOfInput,
    OfInput,
    Added,
    OnOutput,
}

/// Where an effect acts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum EffectPlace {
    /// On the signal, or with an error that depends on it.
    OfSignal,
    /// With an error that does not depend on the signal: the place among the effects that do so.
    Added(usize),
    /// On the output.
    OfOutput,
}

impl Name {
    fn place(self) -> EffectPlace {
        match self.stage() {
            Stage::OnInput | Stage::DrawnOfInput | Stage::OfInput => EffectPlace::OfSignal,
            Stage::Added => {
                let before = Self::ALL.iter().take_while(|name| **name != self);
                EffectPlace::Added(before.filter(|name| name.stage() == Stage::Added).count())
            }
            Stage::OnOutput => EffectPlace::OfOutput,
        }
    }
}

/// The active effects.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Plan {
    effects: [Name; Name::ALL.len()],
    /// Number of active effects up to the end of each stage.
    ends: [u8; Stage::OnOutput as usize + 1],
}

impl Plan {
    /// A plan without effects.
    pub const IDEAL: Self =
        Self { effects: [Name::ALL[0]; Name::ALL.len()], ends: [0; Stage::OnOutput as usize + 1] };

    /// A plan of the effects that are called for, in order.
    pub fn new(calls: &[(Name, bool)]) -> Self {
        let mut plan = Self::IDEAL;
        let active = calls.iter().filter(|(_, is_called_for)| *is_called_for && !cfg!(sins_bare));
        for (place, &(effect, _)) in active.enumerate() {
            plan.effects[place] = effect;
            plan.ends[effect.stage() as usize..].iter_mut().for_each(|end| *end += 1);
        }
        plan
    }

    /// Whether there is nothing to do.
    pub fn is_ideal(&self) -> bool {
        self.all().is_empty()
    }

    /// All steps.
    #[inline(always)]
    pub fn all(&self) -> Range<usize> {
        self.between(0, self.ends[Stage::OnOutput as usize])
    }

    /// The steps of a stage.
    #[inline(always)]
    pub fn of(&self, stage: Stage) -> Range<usize> {
        let before = if stage == Stage::OnInput { 0 } else { self.ends[stage as usize - 1] };
        self.between(before, self.ends[stage as usize])
    }

    /// In a bare build, which shows what effects cost that are off, the compiler removes the code of all effects.
    #[inline(always)]
    fn between(&self, first: u8, end: u8) -> Range<usize> {
        if cfg!(sins_bare) { 0..0 } else { usize::from(first)..usize::from(end) }
    }

    /// The effect of a step.
    #[inline(always)]
    pub fn effect(&self, step: usize) -> Name {
        self.effects[step]
    }

    /// Where the active effects act, in order.
    pub fn places(&self) -> impl Iterator<Item = EffectPlace> {
        self.all().map(|step| self.effect(step).place())
    }

    /// An effect is among the steps of its own stage only.
    #[cold]
    pub fn never() -> ! {
        unreachable!("an effect of another stage")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_plan_is_the_effects_called_for_in_order() {
        let plan_of = |is_called_for: &dyn Fn(Name) -> bool| {
            let calls: Vec<_> = Name::ALL.iter().map(|&name| (name, is_called_for(name))).collect();
            Plan::new(&calls)
        };
        let stages = [Stage::OnInput, Stage::DrawnOfInput, Stage::OfInput, Stage::Added, Stage::OnOutput];
        let plan = plan_of(&|_| true);
        assert_eq!(plan.all().map(|step| plan.effect(step)).collect::<Vec<_>>(), Name::ALL);
        for stage in stages {
            assert!(
                plan.of(stage).all(|step| plan.effect(step).stage() == stage) && !plan.of(stage).is_empty()
            );
        }
        assert!(stages.into_iter().flat_map(|stage| plan.of(stage)).eq(plan.all()));

        let some = [Name::Bandwidth, Name::Bias, Name::RandomWalk];
        let plan = plan_of(&|name| some.contains(&name));
        assert_eq!(stages.map(|stage| plan.of(stage)), [0..1, 1..1, 1..1, 1..3, 3..3]);
        assert_eq!([0, 1, 2].map(|step| plan.effect(step)), some);
        assert!(plan_of(&|_| false).is_ideal() && !plan.is_ideal());
    }
}
