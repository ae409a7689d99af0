//! What follows from the table of effects.

/// Makes [`Effects`](super::Effects), and the names of the effects for a [`Plan`](super::Plan).
macro_rules! effects {
    ($($stage:ident { $($field:ident: $Type:ident $([$($number:literal),*])?,)* })*) => {
        $($(use $field::$Type;)*)*

        /// The effects of a triad by the names of their files, in the order in which they act.
        pub const EFFECTS: &[&str] = &[$($(stringify!($field),)*)*];

        /// Names of the effects, in the order of the table.
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        enum Name {
            $($($Type,)*)*
        }

        impl Name {
            const ALL: &[Self] = &[$($(Self::$Type,)*)*];

            fn stage(self) -> Stage {
                match self {
                    $($(Self::$Type => Stage::$stage,)*)*
                }
            }
        }

        /// The effects of a triad, and which of them are active.
        #[derive(Debug, Clone, PartialEq)]
        pub(super) struct Effects {
            plan: Plan,
            $($(pub $field: $Type,)*)*
        }

        stored!(Effects { $($($field,)*)* } rebuilt { plan });

        impl Effects {
            /// No effects. Random effects, if ever switched on, draw from the streams of `key`. Inlined, to save stack: the value is
            /// made in its final place.
            #[inline(always)]
            pub fn new(key: StreamKey, sensor: Sensor) -> Self {
                let source = sensor.source();
                Self {
                    plan: Plan::IDEAL,
                    $($($field: $Type::new(&EffectStreams { key, source, numbers: &[$($($number),*)?] }),)*)*
                }
            }

            /// Takes validated parameters, and decides which effects act from now on.
            pub fn set(&mut self, parameters: &TriadParameters) {
                self.plan = Plan::new(&[$($((Name::$Type, self.$field.set(parameters)),)*)*]);
            }

            /// Takes the length of the increments to come [s].
            pub fn set_interval(&mut self, dt: f64) {
                $($(self.$field.set_interval(dt);)*)*
            }

            /// Begins a sample interval. [`Self::undo`] can undo it.
            pub fn begin_interval(&mut self, conditions: &Conditions) {
                $($(self.$field.begin_interval(conditions);)*)*
            }

            /// Follows a jump of the signals.
            pub fn reposition(&mut self) {
                $($(self.$field.reposition();)*)*
            }

            /// Undoes the last interval of the active effects.
            #[cold]
            pub fn undo(&mut self) {
                for step in self.plan.all() {
                    match self.plan.effect(step) {
                        $($(Name::$Type => self.$field.undo(),)*)*
                    }
                }
            }

            /// Visits the states of the active effects that differ from run to run.
            pub fn visit(&mut self, visitor: &mut impl Visitor) {
                for step in self.plan.all() {
                    match self.plan.effect(step) {
                        $($(Name::$Type => self.$field.visit(visitor),)*)*
                    }
                }
            }
        }

        const _: () = check_numbers(&[$($($($($number,)*)?)*)*]);

        $(effects! { @$stage $($field: $Type [$($($number),*)?],)* })*
    };

    (@OnInput $($field:ident: $Type:ident $numbers:tt,)*) => {
        impl Effects {
            /// Turns `input`, the triad's part of `ideal`, into the input of its sensors.
            #[inline(always)]
            fn sense_input(&mut self, ideal: &Increment, dt: f64, input: &mut Vector3<f64>) {
                for_active!(self, OnInput, $($Type => self.$field.apply(&ideal.angle, dt, input),)*);
            }

            #[inline(always)]
            fn keep_input(&mut self) {
                for_active!(self, OnInput, $($Type => self.$field.keep(),)*);
            }

            /// Change of the input [u] at the constant angular rate `rate` [rad/s].
            fn steady_change(&self, rate: &Vector3<f64>) -> Vector3<f64> {
                [$(self.$field.steady_change(rate)),*].iter().sum()
            }

            fn follow_input(&mut self, other: &Self) {
                $(self.$field.clone_from(&other.$field);)*
            }
        }
    };

    (@DrawnOfInput $($field:ident: $Type:ident $numbers:tt,)*) => {
        impl Effects {
            #[inline(always)]
            fn drawn_error(&self, step: usize, input: &Input) -> Vector3<f64> {
                match self.plan.effect(step) {
                    $(Name::$Type => self.$field.error(input),)*
                    _ => Plan::never(),
                }
            }

            fn steady_drawn_error(&self, input: &Input, temperature_c: Option<f64>) -> Vector3<f64> {
                [$(self.$field.steady_error(input, temperature_c)),*].iter().sum()
            }

            #[inline(always)]
            fn add_drawn_each(&self, states: &mut States<'_>, inputs: &[Input], outputs: &mut BatchOutputs<'_>) {
                for_active!(self, DrawnOfInput, $($Type => $Type::apply_each(states, inputs, outputs),)*);
            }
        }
    };

    (@OfInput $($field:ident: $Type:ident $numbers:tt,)*) => {
        /// Number of errors that depend on the input and are the same in all runs.
        const SHARED_ERRORS: usize = [$(Name::$Type),*].len();

        impl Effects {
            #[inline(always)]
            fn error_of_input(&self, step: usize, input: &Input) -> Vector3<f64> {
                match self.plan.effect(step) {
                    $(Name::$Type => self.$field.error(input),)*
                    _ => Plan::never(),
                }
            }

            fn steady_error_of_input(&self, input: &Input, temperature_c: Option<f64>) -> Vector3<f64> {
                [$(self.$field.steady_error(input, temperature_c)),*].iter().sum()
            }

            fn follow_errors(&mut self, other: &Self) {
                $(self.$field.clone_from(&other.$field);)*
            }
        }
    };

    (@Added $($field:ident: $Type:ident $numbers:tt,)*) => {
        impl Effects {
            /// Adds the errors of an interval that do not depend on the input.
            #[inline]
            pub fn add(&mut self, dt: f64, sensor: Sensor, measured: &mut [Increment]) {
                for_active!(self, Added, $($Type => self.$field.apply(dt, Outputs::new(sensor, measured)),)*);
            }

            /// [`Self::add`] for the runs of a batch.
            #[inline(always)]
            pub fn add_each(&self, states: &mut States<'_>, outputs: &mut BatchOutputs<'_>) {
                for_active!(self, Added, $($Type => self.$field.apply_each(states, outputs),)*);
            }

            fn steady_added(&self) -> Vector3<f64> {
                [$(self.$field.value()),*].iter().sum()
            }
        }

        /// The processes of the effects, each at the number of its first stream, which is the order of snapshots.
        pub(crate) const OF_SIGNAL: [Processes; STREAM_NUMBERS] = {
            let mut all = [Processes::NONE; STREAM_NUMBERS];
            $(<$Type as Added>::PROCESSES.put(&$numbers, &mut all);)*
            all
        };
    };

    (@OnOutput $($field:ident: $Type:ident $numbers:tt,)*) => {
        impl Effects {
            /// Applies the effects that act on the output.
            #[inline]
            pub fn finish(&mut self, dt: f64, sensor: Sensor, measured: &mut [Increment]) {
                for_active!(self, OnOutput, $($Type => self.$field.apply(dt, Outputs::new(sensor, measured)),)*);
            }

            /// [`Self::finish`] for the runs of a batch.
            #[inline(always)]
            pub fn finish_each(&self, states: &mut States<'_>, outputs: &mut BatchOutputs<'_>) {
                for_active!(self, OnOutput, $($Type => self.$field.apply_each(states, outputs),)*);
            }

            fn limit(&self, signal: &mut Vector3<f64>) {
                $(self.$field.limit(signal);)*
            }
        }
    };
}
pub(super) use effects;

/// Does what its type says for each active effect of a stage, in order.
macro_rules! for_active {
    ($self:ident, $stage:ident, $($Type:ident => $act:expr,)*) => {
        for step in $self.plan.of(Stage::$stage) {
            match $self.plan.effect(step) {
                $(Name::$Type => $act,)*
                _ => Plan::never(),
            }
        }
    };
}
pub(super) use for_active;
