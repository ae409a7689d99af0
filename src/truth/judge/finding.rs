//! What the judge finds, as data: the sentence is made only when the finding is displayed.

/// What a finding means for a flight of these samples.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Level {
    /// It is true, and harms little.
    Note,
    /// The flight is not that of the vehicle in every respect: the errors of an INS on it are to be doubted.
    Doubtful,
    /// The errors of an INS on this flight say nothing.
    Unusable,
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

/// What was found. [`Finding::figure`] is given with each.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// Time stamps that are not later than the one before; figure: number of them.
    TimeOrder,
    /// A time stamp much nearer to the one before than the others; figure: the shortest interval [s].
    NearStamps,
    /// Intervals of more than 2.5 times each of the two before; figure: the longest [s].
    Gaps,
    /// Time in milliseconds or microseconds; figure: speed as if it was in seconds [m/s].
    TimeUnit,
    /// Time stamps that scatter about a steady clock; figure: their scatter [s].
    StampJitter,
    /// Positions in coarse steps; figure: the step [m].
    CoarsePositions,
    /// Positions with noise, without velocities; figure: noise of a component [m].
    NoisyPositions,
    /// Velocities with noise; figure: noise of a component [m/s].
    NoisyVelocities,
    /// Rows that repeat the position of the row before, while the vehicle moves; figure: share of the moving rows [1].
    HeldRows,
    /// A position beside the path of its neighbours; figure: the largest distance [m].
    Spike,
    /// An acceleration that few vehicles have; figure: the largest [m/s²].
    Acceleration,
    /// Rows at the start that hold a value from before the first fix, such as 0, from which the next row jumps; figure: number of rows.
    NotYetFixed,
    /// Velocity in another unit or axes than its name says; figure: size of the velocity over that of the displacement [1].
    VelocityUnit,
    /// Velocity that is no multiple of the displacement; figure: the unexplained share of the displacement [1].
    VelocityContradicts,
    /// Velocity that contradicts the positions at some times; figure: the largest unexplained displacement [m].
    VelocityAtTimes,
    /// Velocity up that is a multiple of the climb; figure: climb over velocity up [1].
    VerticalUnit,
    /// Heading with another sign or unit; figure: how well it follows the track as it is, 0 to 1.
    HeadingUnit,
    /// Heading off the track by a constant angle; figure: the angle [rad].
    HeadingOffTrack,
    /// An angle that sweeps through a whole turn backwards: it was interpolated through its wrap; figure: the largest false rate [rad/s].
    AngleThroughWrap,
    /// Roll with the wrong sign; figure: its slope on the bank that the turns need [1].
    RollSign,
    /// Roll that the turns do not explain; figure: its slope on the bank that the turns need [1].
    RollUnexplained,
    /// Pitch with the wrong sign; figure: its slope on the angle of the path [1].
    PitchSign,
    /// A nose that points below the path; figure: mean of pitch less angle of the path [rad].
    AttackNegative,
    /// Height in feet; figure: slope of pitch on the angle of the path [1].
    HeightUnit,
}

impl Kind {
    /// Whether it compares the attitude with the path, or an angle of the attitude with itself.
    pub fn is_of_attitude(self) -> bool {
        matches!(
            self,
            Self::HeadingUnit
                | Self::HeadingOffTrack
                | Self::AngleThroughWrap
                | Self::RollSign
                | Self::RollUnexplained
                | Self::PitchSign
                | Self::AttackNegative
                | Self::HeightUnit
        )
    }
}

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
}

impl Finding {
    /// What to do about it.
    pub fn remedy(&self) -> &'static str {
        match self.kind {
            Kind::TimeOrder => "sort the rows, or leave the late ones out",
            Kind::NearStamps => "leave one of each pair out, or smooth the log",
            Kind::Gaps => "if the vehicle manoeuvred there, fill the gaps",
            Kind::TimeUnit => "state the unit of the time",
            Kind::StampJitter
            | Kind::CoarsePositions
            | Kind::NoisyPositions
            | Kind::HeldRows
            | Kind::Spike => "smooth the log, or give the velocities",
            Kind::NoisyVelocities => "smooth the log",
            Kind::Acceleration => "if the vehicle does not do this, smooth the log",
            Kind::NotYetFixed => "leave these rows out",
            Kind::VelocityUnit | Kind::VerticalUnit => "state the unit and the axes of the velocity",
            Kind::VelocityContradicts => "give the velocity against the ground, or leave it out",
            Kind::VelocityAtTimes => "correct these rows, or smooth the log",
            Kind::HeadingUnit | Kind::RollSign | Kind::PitchSign => {
                "state the unit and the sign of the angle"
            }
            Kind::HeadingOffTrack => "if it is a magnetic heading, add the variation",
            Kind::AngleThroughWrap => "unwrap the angle before interpolating it, or a smaller step",
            Kind::RollUnexplained => {
                "right for a vehicle on wheels or in a hover, else check unit and sign of roll"
            }
            Kind::AttackNegative => "right for a helicopter, else check the sign of pitch",
            Kind::HeightUnit => "state the unit of the height",
        }
    }
}
