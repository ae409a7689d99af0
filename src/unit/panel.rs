//! What a unit has to the outside: its panel, and the words for its state.

use crate::base::error::{Error, check_range};
#[cfg(feature = "scenes")]
use crate::base::joined::first_words;
use crate::base::snapshot::codes;

/// The mode selector.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Mode {
    /// Switched off.
    #[default]
    Off,
    /// Alignment; the unit stays ready when it is aligned.
    Align,
    /// Navigation, after an alignment if the unit is not aligned.
    Navigate,
    /// Attitude and an entered heading, without navigation.
    Attitude,
}

codes!(Mode { Off = 0 "off", Align = 1 "align", Navigate = 2 "nav", Attitude = 3 "att" });

/// Supplies of power.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Power {
    /// The aircraft.
    #[default]
    Aircraft,
    /// The battery, which lasts battery_s.
    Battery,
    /// None: the unit is off at once, and stores nothing.
    None,
}

codes!(Power { Aircraft = 0 "aircraft_power", Battery = 1 "battery", None = 2 "no_power" });

/// Kinds of alignment.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum AlignmentKind {
    /// Levelling and gyrocompassing on the measured increments.
    #[default]
    Gyrocompass,
    /// Levelling on the measured increments, with the stored heading. Without one, and when the aircraft has moved since the unit was
    /// switched on, a gyrocompass.
    StoredHeading,
    /// Only in a simulation: after fast_alignment_s the unit has the true state, with the errors of sins_initial_errors that need no
    /// alignment, drawn for this run. The vehicle may move. Until then only rates and forces are valid. An entered position is not used.
    Fast,
    /// The same at once, without a test after power-up.
    Instant,
    /// In flight, on positions and velocities of another sensor: see sins_unit_push_fix().
    InFlight,
}

codes!(AlignmentKind {
    Gyrocompass = 0 "gyrocompass", StoredHeading = 1 "stored_heading", Fast = 2 "fast", Instant = 3 "instant", InFlight = 4 "in_flight",
});

/// What a unit is doing.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum State {
    /// Off: it shows nothing.
    #[default]
    Off,
    /// The test after power-up.
    Test,
    /// Alignment without an attitude yet; also while the unit moves and cannot align.
    CoarseAlignment,
    /// Alignment, with an attitude; from its half on with a heading, if a latitude was entered, or is stored and the aircraft stands where
    /// the unit was switched on, and the sensors show north as accurately as heading_limit_rad. In flight it begins when the first windows
    /// show an attitude, and the heading is valid when it is as accurate as in_flight_heading_rad. An alignment of kind
    /// SINS_UNIT_ALIGNMENT_FAST shows neither.
    FineAlignment,
    /// Aligned: it waits for SINS_UNIT_NAV, and continues to align. Its velocity is valid if it was aligned in flight.
    Ready,
    /// Navigation.
    Navigation,
    /// Fast realignment of a parked aircraft: velocity and tilt are removed, the heading is kept. An entered position is taken.
    Realignment,
    /// ATT: levelling. The aircraft should fly straight and level.
    Erection,
    /// ATT: attitude by the gyros, which slowly follows the apparent vertical. In a long turn it follows a false one. It lags behind the
    /// vertical by erection_time_s times the rate of the Earth and of the motion over it: 0.5 deg at rest on the equator.
    Attitude,
    /// Failed: it shows nothing until it is switched off.
    Fault,
    /// Switched off: it has stored position and heading, if they were valid.
    PowerDown,
}

codes!(State {
    Off = 0 "off", Test = 1 "test", CoarseAlignment = 2 "coarse alignment", FineAlignment = 3 "fine alignment", Ready = 4 "ready",
    Navigation = 5 "navigation", Realignment = 6 "realignment", Erection = 7 "erection", Attitude = 8 "attitude", Fault = 9 "fault",
    PowerDown = 10 "power-down",
});

#[cfg(feature = "scenes")]
impl State {
    /// The words of all states, in the order of their codes.
    pub const ALL_WORDS: [&'static str; Self::WORDS.len()] = first_words(Self::WORDS);
}

/// Makes a struct of flags: each with its name, its meaning and its bit, the bits from 1 on in the order given.
macro_rules! flags {
    ($(#[$of_type:meta])* $type:ident { $(#[doc = $meaning:literal] $flag:ident,)* }) => {
        $(#[$of_type])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
        pub struct $type {
            $(#[doc = $meaning] pub $flag: bool,)*
        }

        crate::base::snapshot::stored!($type { $($flag),* });

        impl $type {
            /// Name and meaning of each flag, in the order of the bits.
            pub const FLAGS: [(&'static str, &'static str); [$($meaning),*].len()] =
                [$((stringify!($flag), $meaning)),*];

            /// The flags, in the order of the bits.
            pub fn all(&self) -> [bool; Self::FLAGS.len()] {
                [$(self.$flag),*]
            }

            /// The flags as bits.
            pub fn bits(&self) -> u32 {
                self.all().iter().enumerate().map(|(bit, is_set)| u32::from(*is_set) << bit).sum()
            }

            /// The flags of `bits`; those that it does not know are left out.
            pub fn of_bits(bits: u32) -> Self {
                let mut flags = (0..).map(|bit| bits >> bit & 1 != 0);
                let mut next = || flags.next().unwrap_or_default();
                Self { $($flag: next()),* }
            }

            /// The names of the flags that are set, as a program shows them: "no-position motion".
            #[cfg(feature = "scenes")]
            pub fn words(&self) -> String {
                let set = Self::FLAGS.iter().zip(self.all()).filter(|(_, is_set)| *is_set);
                set.map(|((name, _), _)| name.replace('_', "-")).collect::<Vec<_>>().join(" ")
            }
        }
    };
}

flags!(
    /// Why a unit is not ready, or has failed.
    Reasons {
        /// No position was entered where the aircraft stands; in flight: no fix came for a minute.
        no_position,
        /// The entered position is far from the stored one: enter it again, or another one.
        position_disagrees,
        /// The gyros find another latitude than the entered one.
        latitude_disagrees,
        /// The unit moves: the alignment starts again at rest.
        motion,
        /// The latitude is too high for an alignment.
        latitude_too_high,
        /// A gyro or an accelerometer has no signal.
        no_signal,
        /// The battery is empty.
        battery_empty,
        /// In flight: the heading is not accurate enough yet; turns or changes of speed show it.
        turns_needed,
        /// The sensors do not show north as accurately as heading_limit_rad asks, or showed none when the simulator started.
        north_unknown,
    }
);

flags!(
    /// Which outputs of a unit are valid.
    Validity {
        /// Angular rates and specific forces.
        rates,
        /// Roll and pitch.
        attitude,
        /// Heading.
        heading,
        /// Latitude and longitude.
        position,
        /// Velocity and height.
        velocity,
    }
);

/// What the unit stores when it is switched off, and compares at the next start.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct StoredAlignment {
    /// Latitude \[rad\].
    pub latitude_rad: f64,
    /// Longitude \[rad\].
    pub longitude_rad: f64,
    /// True heading \[rad\].
    pub heading_rad: f64,
}

crate::base::snapshot::stored!(StoredAlignment { latitude_rad: 1.6, longitude_rad: 3.2, heading_rad: 6.3 } then |stored, _| stored.validate());

impl StoredAlignment {
    /// Checks every field.
    pub fn validate(&self) -> Result<(), Error> {
        use core::f64::consts::{FRAC_PI_2, PI, TAU};
        check_range("latitude_rad", self.latitude_rad, -FRAC_PI_2, FRAC_PI_2)?;
        check_range("longitude_rad", self.longitude_rad, -PI, PI)?;
        check_range("heading_rad", self.heading_rad, 0.0, TAU)
    }
}

/// What a unit reports of itself.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Status {
    /// What it is doing.
    pub state: State,
    /// The mode selector.
    pub selector: Mode,
    /// The annunciator ALIGN: lit during an alignment and a realignment.
    pub align: bool,
    /// ALIGN flashes: the crew has to do something, see `reasons`.
    pub align_flashes: bool,
    /// The annunciator NAV RDY.
    pub navigation_ready: bool,
    /// The annunciator FAULT.
    pub fault: bool,
    /// The annunciator ON BATT.
    pub on_battery: bool,
    /// The test of the panel is on.
    pub in_test: bool,
    /// Why it is not ready, or has failed.
    pub reasons: Reasons,
    /// Which outputs are valid.
    pub validity: Validity,
    /// Time to the end of the alignment, or of the erection \[s\]; 0: none is in progress.
    pub to_go_s: f64,
    /// Time in navigation since the alignment \[s\].
    pub in_navigation_s: f64,
    /// Magnitude of the latitude that the gyros found in the last alignment \[rad\].
    pub found_latitude_rad: Option<f64>,
    /// What is stored.
    pub stored: Option<StoredAlignment>,
}
