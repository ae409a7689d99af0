//! What a unit has to the outside: its panel, and the words for its state.

use crate::snapshot::codes;

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

/// The supply of power.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Power {
    /// From the aircraft.
    #[default]
    Aircraft,
    /// From the battery.
    Battery,
    /// None: the unit is off, whatever the selector says, and stores nothing.
    None,
}

codes!(Power { Aircraft = 0 "aircraft_power", Battery = 1 "battery", None = 2 "no_power" });

/// How an alignment at rest is made.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum AlignmentKind {
    /// Levelling and gyrocompassing on the measured increments.
    #[default]
    Gyrocompass,
    /// Levelling on the measured increments, with the heading that was stored. Without one, as `Gyrocompass`.
    StoredHeading,
    /// A shorter time, which a simulation allows itself: then the true attitude, with the errors of the start that are given.
    Fast,
    /// The same at once.
    Instant,
}

codes!(AlignmentKind { Gyrocompass = 0 "gyrocompass", StoredHeading = 1 "stored_heading", Fast = 2 "fast", Instant = 3 "instant" });

/// What a unit is doing.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum State {
    /// It is off, and shows nothing.
    #[default]
    Off,
    /// Test after power-up.
    Test,
    /// Alignment before the first vertical.
    CoarseAlignment,
    /// Alignment, with an attitude.
    FineAlignment,
    /// Aligned, and waiting for the selector.
    Ready,
    /// Navigation.
    Navigation,
    /// Fast realignment after a flight.
    Realignment,
    /// Levelling of the attitude in flight.
    Erection,
    /// Attitude without navigation.
    Attitude,
    /// Failed, until it is switched off.
    Fault,
    /// Switched off, and storing position and heading.
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
    pub const ALL_WORDS: [&'static str; Self::WORDS.len()] = crate::scene::first_words(Self::WORDS);

    /// The state in words, as a program shows it.
    pub fn words(self) -> &'static str {
        Self::WORDS[self as usize].0
    }

    /// The state of these words.
    pub fn of_words(words: &str) -> Option<Self> {
        Self::WORDS.iter().find(|(of, _)| *of == words).map(|(_, state)| *state)
    }
}

/// Why a unit is not ready, or has failed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Reasons {
    /// No position has been entered.
    pub no_position: bool,
    /// The entered position is far from the stored one: enter it again, or another one.
    pub position_disagrees: bool,
    /// The gyros find another latitude than the entered one.
    pub latitude_disagrees: bool,
    /// The unit moves: the alignment starts again at rest.
    pub motion: bool,
    /// The latitude is too high for an alignment.
    pub latitude_too_high: bool,
    /// A gyro or an accelerometer has no signal.
    pub no_signal: bool,
    /// The battery is empty.
    pub battery_empty: bool,
}

crate::snapshot::stored!(Reasons {
    no_position,
    position_disagrees,
    latitude_disagrees,
    motion,
    latitude_too_high,
    no_signal,
    battery_empty
});

/// Which outputs of a unit are valid.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Validity {
    /// Angular rates and accelerations.
    pub rates: bool,
    /// Roll and pitch.
    pub attitude: bool,
    /// Heading.
    pub heading: bool,
    /// Latitude and longitude.
    pub position: bool,
    /// Velocity and height.
    pub velocity: bool,
}

/// What the unit stores when it is switched off, and compares at the next start.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Stored {
    /// Latitude \[rad\].
    pub latitude_rad: f64,
    /// Longitude \[rad\].
    pub longitude_rad: f64,
    /// True heading \[rad\].
    pub heading_rad: f64,
}

crate::snapshot::stored!(Stored { latitude_rad: 1.6, longitude_rad: 3.2, heading_rad: 6.3 });

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
    pub stored: Option<Stored>,
}
