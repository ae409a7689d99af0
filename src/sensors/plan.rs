//! The order of the effects, and which of them are active.

use core::ops::Range;

/// The effects along the path of the signal. The first two change what the proof mass feels; the next four are errors of
/// that, temperature's too, then come additive biases and noise, with those of failures, and last what the output electronics
/// do, and failures of the output.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Effect {
    LeverArms,
    Bandwidth,
    Linear,
    Asymmetry,
    Quadratic,
    GSensitivity,
    Temperature,
    Bias,
    GaussMarkov,
    Flicker,
    RateRandomWalk,
    Ramp,
    RandomWalk,
    Disturbance,
    DeadZone,
    Range,
    Quantization,
    Outage,
}

impl Effect {
    /// Number of effects.
    pub const COUNT: usize = 18;

    /// Whether it acts before the errors of what is felt.
    fn is_before_felt(self) -> bool {
        matches!(self, Self::LeverArms | Self::Bandwidth)
    }
}

/// The active effects in order: what is to be done for an increment.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Plan {
    effects: [Effect; Effect::COUNT],
    /// Of these the first so many change what is felt.
    before_felt: u8,
    count: u8,
}

impl Plan {
    /// Nothing.
    pub const IDEAL: Self = Self { effects: [Effect::Bias; Effect::COUNT], before_felt: 0, count: 0 };

    /// The effects, in order, that are called for.
    pub fn new(calls: &[(Effect, bool); Effect::COUNT]) -> Self {
        let mut plan = Self::IDEAL;
        for &(effect, _) in calls.iter().filter(|(_, is_called_for)| *is_called_for) {
            plan.effects[usize::from(plan.count)] = effect;
            plan.count += 1;
            plan.before_felt += u8::from(effect.is_before_felt());
        }
        plan
    }

    /// Whether there is nothing to do.
    pub fn is_ideal(&self) -> bool {
        self.count == 0
    }

    /// The steps that change what is felt.
    #[inline]
    pub fn before_felt(&self) -> Range<usize> {
        0..usize::from(self.before_felt)
    }

    /// The steps after those.
    #[inline]
    pub fn after_felt(&self) -> Range<usize> {
        usize::from(self.before_felt)..usize::from(self.count)
    }

    /// What is done at a step.
    #[inline]
    pub fn effect(&self, step: usize) -> Effect {
        self.effects[step]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_plan_is_the_effects_called_for_in_order() {
        let all = [
            Effect::LeverArms,
            Effect::Bandwidth,
            Effect::Linear,
            Effect::Asymmetry,
            Effect::Quadratic,
            Effect::GSensitivity,
            Effect::Temperature,
            Effect::Bias,
            Effect::GaussMarkov,
            Effect::Flicker,
            Effect::RateRandomWalk,
            Effect::Ramp,
            Effect::RandomWalk,
            Effect::Disturbance,
            Effect::DeadZone,
            Effect::Range,
            Effect::Quantization,
            Effect::Outage,
        ];
        let plan = Plan::new(&all.map(|effect| (effect, true)));
        assert_eq!(
            plan.before_felt().chain(plan.after_felt()).map(|i| plan.effect(i)).collect::<Vec<_>>(),
            all
        );
        assert_eq!(plan.before_felt(), 0..2);
        let some = [Effect::Bandwidth, Effect::RandomWalk, Effect::Bias];
        let plan = Plan::new(&all.map(|effect| (effect, some.contains(&effect))));
        assert_eq!((plan.before_felt(), plan.after_felt()), (0..1, 1..3));
        assert_eq!([0, 1, 2].map(|i| plan.effect(i)), [Effect::Bandwidth, Effect::Bias, Effect::RandomWalk]);
        assert!(Plan::new(&all.map(|effect| (effect, false))).is_ideal() && !plan.is_ideal());
    }
}
