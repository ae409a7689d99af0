//! What the judge finds, as data: the sentence is made only when the finding is displayed.

/// What a finding means for a flight of these samples.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Level {
    /// It is true, and harms little.
    Note = 0,
    /// The flight is not that of the vehicle in every respect: the errors of an INS on it are to be doubted.
    Doubtful = 1,
    /// The errors of an INS on this flight say nothing.
    Unusable = 2,
}

impl Level {
    /// Its word.
    pub fn word(self) -> &'static str {
        match self {
            Self::Note => "note",
            Self::Doubtful => "doubtful",
            Self::Unusable => "unusable",
        }
    }
}

/// What was found, and what the figure of the finding is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// Time stamps that are not later than the one before; figure: number of them.
    TimeOrder = 0,
    /// A time stamp much nearer to the one before than the others; figure: the shortest interval [s].
    NearStamps = 1,
    /// Intervals of more than 2.5 times each of the two before; figure: the longest [s].
    Gaps = 2,
    /// Time in milliseconds or microseconds; figure: speed as if it was in seconds [m/s].
    TimeUnit = 3,
    /// Time stamps that scatter about a steady clock; figure: their scatter [s].
    StampJitter = 4,
    /// Positions in coarse steps; figure: the step [m].
    CoarsePositions = 5,
    /// Positions with noise, without velocities; figure: noise of a component [m].
    NoisyPositions = 6,
    /// Velocities with noise; figure: noise of a component [m/s].
    NoisyVelocities = 7,
    /// Rows that repeat the position of the row before, while the vehicle moves; figure: share of the moving rows [1].
    HeldRows = 8,
    /// A position beside the path of its neighbours; figure: the largest distance [m].
    Spike = 9,
    /// An acceleration that few vehicles have; figure: the largest [m/s²].
    Acceleration = 10,
    /// Rows at the start that hold a value from before the first fix, such as 0, from which the next row jumps; figure: number of rows.
    NotYetFixed = 11,
    /// Velocity in another unit or axes than its name says; figure: size of the velocity over that of the displacement [1].
    VelocityUnit = 12,
    /// Velocity that is no multiple of the displacement; figure: the unexplained share of the displacement [1].
    VelocityContradicts = 13,
    /// Velocity that contradicts the positions at some times; figure: the largest unexplained displacement [m].
    VelocityAtTimes = 14,
    /// Velocity up that is a multiple of the climb; figure: climb over velocity up [1].
    VerticalUnit = 15,
    /// Heading with another sign or unit, or a path that is mirrored against it; figure: how well it follows the track as it is, 0 to 1.
    HeadingUnit = 16,
    /// Heading off the track by a constant angle; figure: the angle [rad].
    HeadingOffTrack = 17,
    /// An angle that sweeps through a whole turn backwards: it was interpolated through its wrap; figure: the largest false rate [rad/s].
    AngleThroughWrap = 18,
    /// Roll with the wrong sign, or in radians; figure: its slope on the bank that the turns need [1].
    RollSign = 19,
    /// Roll that the turns do not explain; figure: its slope on the bank that the turns need [1].
    RollUnexplained = 20,
    /// Pitch with the wrong sign, or in radians; figure: its slope on the angle of the path [1].
    PitchSign = 21,
    /// A nose that points below the path; figure: mean of pitch less angle of the path [rad].
    AttackNegative = 22,
    /// Height in feet; figure: slope of pitch on the angle of the path [1].
    HeightUnit = 23,
    /// Attitude, heading or roll that stays the same to the last bit while the track turns, or an attitude of 0, 0, 0 for a while; figure:
    /// the largest turn of the track, or how far the attitude is from 0 beside it [rad].
    AttitudeHeld = 24,
    /// Attitude that follows the turns late; figure: the delay, negative if it is early [s].
    AttitudeLate = 25,
    /// Attitude with noise; figure: noise of an angle [rad].
    NoisyAttitude = 26,
    /// Velocity that follows the positions late; figure: the delay, negative if it is early [s].
    VelocityLate = 27,
    /// Attitude in steps; figure: the step of an angle [rad].
    CoarseAttitude = 28,
    /// Columns of a log that are not read contradict what flies; figure: number of them.
    UnreadContradicts = 29,
    /// Level flight above the air: height in a smaller unit than metres; figure: the height [m].
    HeightAboveAir = 30,
    /// Roll, or pitch above the path, that is far off in straight flight; figure: the angle [rad].
    AttitudeTurned = 31,
}

/// What a path is whose attitude turns otherwise.
pub(super) const MIRRORED: &str = "latitude and longitude are exchanged, or one has lost its sign";

/// What an attitude is for a while.
pub(super) const ZERO: &str = "attitude is 0, 0, 0";

/// What an angle is that is too small by 57.3.
pub(super) const RADIANS: &str = "radians taken for degrees";

/// What explains a finding.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Clue {
    None,
    /// Steps of numbers of 32 bits.
    Float32,
    /// The largest value that the options allow.
    Limit(f64),
    /// Name of what it would be right as.
    Known(&'static str),
    /// Velocity in the unit of this name, with east and north exchanged, and each with the opposite sign.
    Velocity {
        unit: &'static str,
        exchanged: bool,
        opposite: [bool; 3],
    },
}

/// A sample: its number from 0, and its time stamp [s].
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct At {
    /// Number of the sample, the first pushed is 0.
    pub row: u64,
    /// Its time stamp [s].
    pub time_s: f64,
}

/// A finding. [`core::fmt::Display`] writes its sentence.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Finding {
    /// What was found.
    pub kind: Kind,
    /// What it means.
    pub level: Level,
    /// Where: the first sample, or the sample where it is largest.
    pub at: At,
    /// How often; 0: the whole flight.
    pub count: u64,
    /// Its figure, see [`Kind`].
    pub figure: f64,
    /// False acceleration that is flown for it; 0: none, or unknown [m/s²].
    pub acceleration_m_s2: f64,
    /// Largest horizontal error of an INS with ideal sensors for it, during the flight; 0: none, or unknown [m].
    pub ins_error_m: f64,
    pub(super) clue: Clue,
    /// Whether it is one of the rows of a smoothed path, and not flown: they were repaired, or are not used.
    pub is_of_rows: bool,
    /// Whether it is one of a smoothed path.
    pub is_of_path: bool,
}

struct WithRemedy(Finding);

/// Noise of positions that no receiver has [m].
const TWO_VEHICLES_M: f64 = 500.0;

impl core::fmt::Display for WithRemedy {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self.0.is_of_rows {
            true => write!(f, "{} ({})", self.0, self.0.remedy()),
            false => write!(f, "{}. Remedy: {}", self.0, self.0.remedy()),
        }
    }
}

#[cfg(feature = "scenes")]
impl Finding {
    /// `late` of `rows` rows were left out of a path because their stamps are not later than the one before; the first is `at`.
    pub(crate) fn of_late_rows(late: u64, rows: u64, at: At) -> Self {
        let is_doubtful = late as f64 > LATE_SHARE * rows as f64;
        let level = if is_doubtful { Level::Doubtful } else { Level::Note };
        Self { at, count: late, is_of_rows: true, ..Self::new(Kind::TimeOrder, level, late as f64) }
    }

    /// The rows of a path have a noise of `noise_m` [m] about it, if that is more than one vehicle makes.
    pub(crate) fn of_scatter(noise_m: f64) -> Option<Self> {
        let found = Self::new(Kind::NoisyPositions, Level::Unusable, noise_m);
        Some(found).filter(Self::is_of_two)
    }

    /// `count` columns that are not read contradict what flies, the first of them as this quantity.
    pub(crate) fn of_unread(count: u64, quantity: &'static str) -> Self {
        let found = Self::new(Kind::UnreadContradicts, Level::Doubtful, count as f64);
        Self { count, clue: Clue::Known(quantity), ..found }
    }

    /// Whether velocities contradict the positions so much that these or the times may be wrong as well, by a sign, exchanged, or by a
    /// factor that is no unit of speeds. Below that, between rows of 1 s, a slow vehicle may do it.
    fn is_open(&self) -> bool {
        let is_of_speeds = |unit| ["knots", "ft/s", "km/h", "mph"].contains(&unit);
        let is_explained = match self.clue {
            Clue::Velocity { unit, exchanged, opposite: [east, north, _] } => {
                is_of_speeds(unit) && !exchanged && !east && !north
            }
            _ => false,
        };
        let is_of_velocities = matches!(self.kind, Kind::VelocityContradicts | Kind::VelocityUnit);
        is_of_velocities && self.level == Level::Unusable && !is_explained
    }

    /// Whether positions have so much noise, or such steps [m], that no smoothing repairs them: those of several vehicles, or of lost
    /// digits.
    fn is_gross(&self) -> bool {
        const STEP_M: f64 = 150.0;
        match self.kind {
            Kind::NoisyPositions => self.clue != Clue::None,
            Kind::CoarsePositions => self.figure > STEP_M,
            _ => false,
        }
    }

    /// It, found in the rows that a path was fitted to, at the sample `row` of the path: what the path does not have is a note, unless it
    /// may be the path that is wrong.
    pub(crate) fn of_rows(self, row: u64) -> Self {
        let at = At { row, ..self.at };
        let is_in_path = matches!(
            self.kind,
            Kind::TimeUnit
                | Kind::VerticalUnit
                | Kind::HeadingUnit
                | Kind::HeadingOffTrack
                | Kind::AngleThroughWrap
                | Kind::RollSign
                | Kind::RollUnexplained
                | Kind::PitchSign
                | Kind::AttackNegative
                | Kind::HeightUnit
                | Kind::HeightAboveAir
                | Kind::AttitudeTurned
                | Kind::AttitudeHeld
                | Kind::AttitudeLate
        ) || self.is_of_two();
        match is_in_path {
            true => Self { at, ..self },
            false => Self {
                level: if self.is_open() || self.is_gross() { Level::Doubtful } else { Level::Note },
                acceleration_m_s2: 0.0,
                ins_error_m: 0.0,
                is_of_rows: true,
                at,
                ..self
            },
        }
    }
}

/// Share of the rows above which rows that are left out for their stamps are doubtful: they are no single packets that came late.
#[cfg(feature = "scenes")]
const LATE_SHARE: f64 = 0.01;

impl Finding {
    /// One of the whole flight, without further figures.
    pub(super) fn new(kind: Kind, level: Level, figure: f64) -> Self {
        Self {
            kind,
            level,
            at: At::default(),
            count: 0,
            figure,
            acceleration_m_s2: 0.0,
            ins_error_m: 0.0,
            clue: Clue::None,
            is_of_rows: false,
            is_of_path: false,
        }
    }

    /// What was done about it in the rows of a smoothed path.
    fn repair(&self) -> &'static str {
        match self.kind {
            Kind::TimeOrder if self.level > Level::Note => {
                "these rows are left out; are they those of another vehicle, or of another flight?"
            }
            Kind::TimeOrder | Kind::NearStamps | Kind::HeldRows | Kind::NotYetFixed => {
                "these rows are left out"
            }
            Kind::Gaps => "the path bridges them",
            Kind::VelocityUnit | Kind::VelocityContradicts if self.level > Level::Note => {
                "the velocity of the path is flown instead; if the velocity of the rows is right, their positions or times are wrong"
            }
            Kind::NoisyVelocities
            | Kind::VelocityUnit
            | Kind::VelocityContradicts
            | Kind::VelocityLate
            | Kind::VelocityAtTimes => "the velocity of the path is flown instead",
            _ => "smoothed",
        }
    }

    /// It as a sentence, and what to do about it.
    pub fn with_remedy(&self) -> impl core::fmt::Display {
        WithRemedy(*self)
    }

    /// Whether positions scatter so much that they are hardly those of one vehicle.
    fn is_of_two(&self) -> bool {
        self.kind == Kind::NoisyPositions && self.figure > TWO_VEHICLES_M
    }

    /// What to do about it; of one of rows, what was done.
    pub fn remedy(&self) -> &'static str {
        if self.is_of_rows {
            return self.repair();
        }
        if self.is_of_two() {
            return "if the rows are those of several vehicles, leave the others out";
        }
        match self.kind {
            Kind::NearStamps
            | Kind::StampJitter
            | Kind::CoarsePositions
            | Kind::NoisyPositions
            | Kind::HeldRows
            | Kind::Spike
            | Kind::NoisyVelocities
            | Kind::Acceleration
            | Kind::VelocityAtTimes
                if self.is_of_path =>
            {
                "state the noise of the rows (log.position_sigma_m), or leave those out that are wrong"
            }
            Kind::NoisyAttitude | Kind::CoarseAttitude if self.is_of_path => {
                "state the noise of the attitude of the rows (log.attitude_sigma_deg)"
            }
            Kind::TimeOrder => "sort the rows, or leave the late ones out",
            Kind::NearStamps => "leave one of each pair out, or smooth the log",
            Kind::Gaps => "if the vehicle manoeuvred there, fill the gaps",
            Kind::TimeUnit => "state the unit of the time",
            Kind::StampJitter
            | Kind::CoarsePositions
            | Kind::NoisyPositions
            | Kind::HeldRows
            | Kind::Spike => "smooth the log, or give the velocities",
            Kind::NoisyVelocities | Kind::NoisyAttitude | Kind::CoarseAttitude => "smooth the log",
            Kind::Acceleration => "if the vehicle does not do this, smooth the log",
            Kind::NotYetFixed => "leave these rows out",
            Kind::VelocityUnit | Kind::VerticalUnit => "state the unit and the axes of the velocity",
            Kind::VelocityContradicts => "give the velocity against the ground, or leave it out",
            Kind::VelocityLate => "correct the time of the velocity, or leave the velocity out",
            Kind::VelocityAtTimes => "correct these rows, or smooth the log",
            Kind::AttitudeTurned => "state the axes of the attitude: add = ... and sign = ... turn it",
            Kind::HeadingUnit if self.clue == Clue::Known(MIRRORED) => {
                "check latitude, longitude and their signs"
            }
            Kind::HeadingUnit | Kind::RollSign | Kind::PitchSign => {
                "state the unit and the sign of the angle"
            }
            Kind::HeadingOffTrack => "if it is a magnetic heading, add the variation",
            Kind::AngleThroughWrap => "unwrap the angle before interpolating it, or a smaller step",
            Kind::RollUnexplained if self.clue != Clue::None => "state the units of roll, time and position",
            Kind::RollUnexplained => {
                "right for a vehicle on wheels or in a hover, else check unit and sign of roll"
            }
            Kind::AttackNegative => "right for a helicopter, else check the sign of pitch",
            Kind::HeightUnit | Kind::HeightAboveAir => "state the unit of the height",
            Kind::AttitudeHeld => "correct these attitudes, or set attitude = \"coordinated\" in [log]",
            Kind::UnreadContradicts => "compare them, and correct the log, or its columns and units in [log]",
            Kind::AttitudeLate => {
                "correct the time of the attitude, or set attitude = \"coordinated\" in [log]"
            }
        }
    }
}
