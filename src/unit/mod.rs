//! The unit: an INS as the rest of an aircraft knows it, with a mode selector, an alignment, and a status.
//!
//! A [`Unit`] stands beside a [`Simulator`]. The host pushes samples and makes steps as without a unit, and calls [`Unit::update`] after
//! each step. The unit reads the measured increments of the step. While it aligns, it finds the attitude from them (`alignment`). Its
//! result becomes the solution of the simulator by a [`Correction`]. From then on the unit shows the navigation of the simulator.
//! While the unit does not navigate, it keeps the solution of the simulator near the truth, so that it cannot diverge unseen.
//!
//! ```text
//! OFF ─► test ─► coarse ─► fine alignment ─► ready ─► navigation ─► power-down ─► OFF
//!          │                 ▲    (motion: from the start)    │  ▲
//!          └► erection ─► attitude                realignment ◄┘──┘          fault: until OFF
//! ```

mod aligned;
mod alignment;
pub mod bus;
mod enter;
mod in_flight;
mod inertial;
mod north;
mod output;
mod panel;
mod parameters;
mod snapshot;
mod states;
mod table;

pub use output::UnitNavigation;
pub use panel::{AlignmentKind, Mode, Power, Reasons, State, Status, StoredAlignment, Validity};
pub use parameters::UnitParameters;
pub use table::UNIT;

use nalgebra::{Quaternion, Vector3};

use crate::base::error::Error;
use crate::earth::state::BodyAxes;
use crate::signal::Increment;
use crate::simulator::{ImuInterval, Simulator};
use alignment::AlignmentProgress;
use enter::Entry;
use inertial::{Inertial, Motion};

/// While the unit does not navigate, the solution of the simulator is brought back to the truth after this time \[s\].
pub const KEEP_S: f64 = 60.0;

/// A unit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unit {
    /// As they were set.
    parameters: UnitParameters,
    /// The same with the defaults in place of zeros.
    limits: UnitParameters,
    kind: AlignmentKind,
    selector: Mode,
    power: Power,
    state: State,
    /// Time in the state \[s\].
    state_s: f64,
    /// Time of the last update \[s\].
    time_s: Option<f64>,
    /// The position that was entered.
    entered: Option<Entry>,
    /// The position that was entered and refused because it is far from the stored one.
    refused: Option<Entry>,
    /// Where the aircraft was at the last update in an alignment, Earth-fixed axes \[m\].
    place_e: Option<Vector3<f64>>,
    stored: Option<StoredAlignment>,
    /// Where the unit was switched on, Earth-fixed axes \[m\], as long as the aircraft stands there with the stored heading.
    switched_on_e: Option<Vector3<f64>>,
    /// Rotates block axes to the axes of the vehicle.
    q_bs: Quaternion<f64>,
    axes: BodyAxes,
    inertial: Inertial,
    motion: Motion,
    alignment: AlignmentProgress,
    /// In ATT: rotates the level axes to inertial axes.
    q_il: Quaternion<f64>,
    /// In ATT a heading was entered.
    heading_entered: bool,
    /// The solution was levelled again after a flight; its heading was kept.
    realigned: bool,
    reasons: Reasons,
    found_latitude_rad: Option<f64>,
    latitude_failures: usize,
    /// Whether gyros and accelerometers had a signal in the last interval.
    has_signal: bool,
    /// Time since the first update \[s\].
    age_s: f64,
    /// Clocks \[s\].
    invalid_s: f64,
    on_battery_s: f64,
    kept_s: f64,
    test_s: f64,
    in_navigation_s: f64,
    /// Measured increment of the last interval, block axes, and its length \[s\].
    measured: Increment,
    interval_s: f64,
}

impl Unit {
    /// A unit with its selector at OFF; or at NAV, which navigates from the first step with the start of the simulator.
    pub fn new(parameters: &UnitParameters, mode: Mode) -> Result<Self, Error> {
        parameters.validate()?;
        let state = match mode {
            Mode::Off => State::Off,
            Mode::Navigate => State::Navigation,
            Mode::Align | Mode::Attitude => {
                return Err(Error::bad_state("a unit starts at OFF, or aligned at NAV"));
            }
        };
        Ok(Self {
            parameters: *parameters,
            limits: parameters.with_defaults(),
            kind: AlignmentKind::default(),
            selector: mode,
            power: Power::default(),
            state,
            state_s: 0.0,
            time_s: None,
            entered: None,
            refused: None,
            place_e: None,
            stored: None,
            switched_on_e: None,
            q_bs: Quaternion::identity(),
            axes: BodyAxes::default(),
            inertial: Inertial::default(),
            motion: Motion::default(),
            alignment: AlignmentProgress::default(),
            q_il: Quaternion::identity(),
            heading_entered: false,
            realigned: false,
            reasons: Reasons::default(),
            found_latitude_rad: None,
            latitude_failures: 0,
            has_signal: true,
            age_s: 0.0,
            invalid_s: 0.0,
            on_battery_s: 0.0,
            kept_s: 0.0,
            test_s: 0.0,
            in_navigation_s: 0.0,
            measured: Increment::ZERO,
            interval_s: 1.0,
        })
    }

    /// The parameters, as they were set.
    pub fn parameters(&self) -> &UnitParameters {
        &self.parameters
    }

    /// Sets the parameters; they act at once.
    pub fn set_parameters(&mut self, parameters: &UnitParameters) -> Result<(), Error> {
        parameters.validate()?;
        (self.parameters, self.limits) = (*parameters, parameters.with_defaults());
        Ok(())
    }

    /// Takes the last step of `simulator`, and corrects its solution when an alignment ends. To be called after each step.
    pub fn update(&mut self, simulator: &mut Simulator) -> Result<(), Error> {
        let Some(imu) = simulator.imu() else {
            return Err(Error::bad_state("the simulator has made no step yet"));
        };
        if self.time_s == Some(imu.time_s) {
            return Err(Error::bad_state("the unit has taken this step already"));
        }
        self.note(&imu, simulator);
        if self.state == State::Navigation && self.selector == Mode::Navigate {
            self.in_navigation_s += imu.interval_s;
            return Ok(());
        }
        self.work(imu.interval_s, simulator)
    }

    /// Takes over the interval.
    fn note(&mut self, imu: &ImuInterval, simulator: &Simulator) {
        let dt = imu.interval_s;
        let begun_s = imu.time_s - dt;
        let has_jumped = simulator.is_first_interval();
        if self.shows_solution() && (has_jumped || self.time_s.is_none()) {
            self.reasons.north_unknown = simulator.lacks_north();
        }
        match self.time_s {
            None => self.look_at(simulator),
            Some(time_s) => {
                if has_jumped {
                    self.switched_on_e = None;
                    self.forget_entries();
                }
                if has_jumped || (time_s - begun_s).abs() > 0.5 * dt {
                    self.motion = Motion::default();
                    self.start_anew();
                }
            }
        }
        self.time_s = Some(imu.time_s);
        self.age_s += dt;
        self.state_s += dt;
        self.measured = imu.compensated;
        self.interval_s = dt;
        self.supply(imu);
    }

    /// What the unit does in an interval without navigation, or to begin or end it. If the simulator rejects a correction, the unit
    /// stays as it was, and tries again with the next interval.
    #[inline(never)]
    fn work(&mut self, dt: f64, simulator: &mut Simulator) -> Result<(), Error> {
        let before = *self;
        let done = self.keep(dt, simulator).and_then(|()| self.go_on(dt, simulator));
        if done.is_err() {
            *self = before;
        }
        done
    }
}
