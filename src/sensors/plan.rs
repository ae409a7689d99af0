//! The order of the effects, and which of them are active.

use core::ops::Range;

/// The effects in order along the path of the signal. Size and Bandwidth change the input. Linear to Temperature are errors
/// that depend on the input. Bias to AddedFailure are added biases and noise. DeadZone to Outage act on the output.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Effect {
    Size,
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
    AddedFailure,
    DeadZone,
    Range,
    Quantization,
    Outage,
}

impl Effect {
    /// Number of effects.
    pub const COUNT: usize = 18;

    /// Whether it changes the input of the sensors.
    fn is_before_input(self) -> bool {
        matches!(self, Self::Size | Self::Bandwidth)
    }

    /// Whether it changes the input, or is an error that depends on the input.
    fn is_on_signal(self) -> bool {
        self.is_before_input()
            || matches!(
                self,
                Self::Linear | Self::Asymmetry | Self::Quadratic | Self::GSensitivity | Self::Temperature
            )
    }

    /// Whether this build leaves the effect out. Such builds show the cost of an effect that is off (benches/effects.sh).
    #[inline(always)]
    const fn is_left_out(self) -> bool {
        match self {
            Self::Size => cfg!(sins_without = "size_effect"),
            Self::Bandwidth => cfg!(sins_without = "bandwidth"),
            Self::Linear => cfg!(sins_without = "linear"),
            Self::Asymmetry => cfg!(sins_without = "asymmetry"),
            Self::Quadratic => cfg!(sins_without = "quadratic"),
            Self::GSensitivity => cfg!(sins_without = "g_sensitivity"),
            Self::Temperature => cfg!(sins_without = "temperature"),
            Self::Bias => cfg!(sins_without = "bias"),
            Self::GaussMarkov => cfg!(sins_without = "gauss_markov"),
            Self::Flicker => cfg!(sins_without = "flicker"),
            Self::RateRandomWalk => cfg!(sins_without = "rate_random_walk"),
            Self::Ramp => cfg!(sins_without = "ramp"),
            Self::RandomWalk => cfg!(sins_without = "random_walk"),
            Self::AddedFailure | Self::Outage => cfg!(sins_without = "failures"),
            Self::DeadZone => cfg!(sins_without = "dead_zone"),
            Self::Range => cfg!(sins_without = "range"),
            Self::Quantization => cfg!(sins_without = "quantization"),
        }
    }
}

/// The active effects, in the order in which they act on an increment.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Plan {
    effects: [Effect; Effect::COUNT],
    /// Effects 0 to `before_input` change the input. Effects `before_input` to `on_signal` are errors that depend on the
    /// input. The others, up to `count`, do not depend on it.
    before_input: u8,
    on_signal: u8,
    count: u8,
}

impl Plan {
    /// A plan without effects.
    pub const IDEAL: Self =
        Self { effects: [Effect::Bias; Effect::COUNT], before_input: 0, on_signal: 0, count: 0 };

    /// A plan of the effects that are called for, in order.
    pub fn new(calls: &[(Effect, bool); Effect::COUNT]) -> Self {
        let mut plan = Self::IDEAL;
        let active = |(effect, is_called_for): &&(Effect, bool)| *is_called_for && !effect.is_left_out();
        for &(effect, _) in calls.iter().filter(active) {
            plan.effects[usize::from(plan.count)] = effect;
            plan.count += 1;
            plan.before_input += u8::from(effect.is_before_input());
            plan.on_signal += u8::from(effect.is_on_signal());
        }
        plan
    }

    /// Whether there is nothing to do.
    pub fn is_ideal(&self) -> bool {
        self.count == 0
    }

    /// Whether an effect changes the input or depends on it.
    #[inline]
    pub fn acts_on_signal(&self) -> bool {
        self.on_signal > 0
    }

    /// The steps that change the input.
    #[inline]
    pub fn before_input(&self) -> Range<usize> {
        0..usize::from(self.before_input)
    }

    /// The steps whose errors depend on the input.
    #[inline]
    pub fn of_input(&self) -> Range<usize> {
        usize::from(self.before_input)..usize::from(self.on_signal)
    }

    /// The steps that do not depend on the input.
    #[inline]
    pub fn after_signal(&self) -> Range<usize> {
        usize::from(self.on_signal)..usize::from(self.count)
    }

    /// All steps.
    pub fn steps(&self) -> Range<usize> {
        0..usize::from(self.count)
    }

    /// The effect of a step.
    #[inline]
    pub fn effect(&self, step: usize) -> Effect {
        let effect = self.effects[step];
        // With this check, the compiler removes the code of a left-out effect wherever effects are distinguished.
        assert!(!effect.is_left_out());
        effect
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_plan_is_the_effects_called_for_in_order() {
        let all = [
            Effect::Size,
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
            Effect::AddedFailure,
            Effect::DeadZone,
            Effect::Range,
            Effect::Quantization,
            Effect::Outage,
        ];
        let plan = Plan::new(&all.map(|effect| (effect, true)));
        let steps = plan.before_input().chain(plan.of_input()).chain(plan.after_signal());
        assert_eq!(steps.map(|i| plan.effect(i)).collect::<Vec<_>>(), all);
        assert_eq!((plan.before_input(), plan.of_input()), (0..2, 2..7));
        let some = [Effect::Bandwidth, Effect::RandomWalk, Effect::Bias];
        let plan = Plan::new(&all.map(|effect| (effect, some.contains(&effect))));
        assert_eq!((plan.before_input(), plan.of_input(), plan.after_signal()), (0..1, 1..1, 1..3));
        assert_eq!([0, 1, 2].map(|i| plan.effect(i)), [Effect::Bandwidth, Effect::Bias, Effect::RandomWalk]);
        assert!(Plan::new(&all.map(|effect| (effect, false))).is_ideal() && !plan.is_ideal());
    }
}
