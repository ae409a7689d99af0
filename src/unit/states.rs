//! What the unit does in its states, and how it goes from one to another.

use super::alignment::AlignmentProgress;
use super::{AlignmentKind, KEEP_S, Mode, Power, Reasons, State, StoredAlignment, Unit, UnitParameters};
use crate::base::error::Error;
use crate::earth::state::StateErrors;
use crate::errors::NavigationErrors;
use crate::errors::correction::Correction;
use crate::simulator::{ErrorSource, ImuInterval, Simulator};
use crate::truth::TruthPoint;

/// Least number of windows of an alignment.
const WINDOWS: f64 = 20.0;

impl Unit {
    /// Whether an alignment or a realignment is in progress.
    pub(super) fn aligns(&self) -> bool {
        matches!(self.state, State::CoarseAlignment | State::FineAlignment | State::Realignment)
    }

    /// Whether the unit shows the solution of the simulator.
    pub(super) fn shows_solution(&self) -> bool {
        matches!(self.state, State::Ready | State::Navigation | State::Realignment)
    }

    pub(super) fn enter(&mut self, state: State) {
        (self.state, self.state_s) = (state, 0.0);
        if matches!(state, State::Navigation | State::Erection) {
            self.switched_on_e = None;
        }
        if !self.aligns() && state != State::Ready {
            self.forget_entries();
        }
    }

    /// Power, and the built-in test of the sensors.
    pub(super) fn supply(&mut self, imu: &ImuInterval) {
        let dt = imu.interval_s;
        self.test_s = (self.test_s - dt).max(0.0);
        if matches!(self.state, State::Off | State::PowerDown) {
            return;
        }
        let parameters = &self.parameters;
        self.on_battery_s = if self.power == Power::Battery { self.on_battery_s + dt } else { 0.0 };
        let is_empty = parameters.battery_s != 0.0 && self.on_battery_s > parameters.battery_s;
        if self.power == Power::None || is_empty {
            self.reasons.battery_empty = is_empty;
            self.enter(State::Off);
            return;
        }
        self.has_signal = !(imu.flags.gyro_invalid || imu.flags.accel_invalid);
        if !self.has_signal {
            self.invalid_s += dt;
            if self.invalid_s > self.limits.fault_s {
                self.reasons.no_signal = true;
                self.enter(State::Fault);
            } else if self.state != State::Attitude {
                self.start_anew();
            }
        }
    }

    /// Keeps a solution that is not shown near the truth.
    pub(super) fn keep(&mut self, dt: f64, simulator: &mut Simulator) -> Result<(), Error> {
        self.kept_s = if self.shows_solution() { 0.0 } else { self.kept_s + dt };
        if self.kept_s < KEEP_S {
            return Ok(());
        }
        self.kept_s = 0.0;
        remove_errors(simulator, &StateErrors::NONE)
    }

    /// Follows the selector, and continues what the state does.
    pub(super) fn go_on(&mut self, dt: f64, simulator: &mut Simulator) -> Result<(), Error> {
        if self.selector == Mode::Off && !matches!(self.state, State::Off | State::PowerDown) {
            self.power_down(simulator)?;
        }
        match self.state {
            State::Off if self.selector != Mode::Off && self.has_power() => self.power_up(simulator),
            State::Off | State::Fault => return Ok(()),
            State::PowerDown => return self.switch_off(simulator),
            _ => {}
        }
        let parameters = self.limits;
        match (self.state, self.selector) {
            (State::Test, _) => {
                let is_over =
                    self.state_s >= parameters.power_up_test_s || self.kind == AlignmentKind::Instant;
                match self.selector {
                    _ if !is_over => {}
                    Mode::Attitude => self.begin(State::Erection, simulator),
                    _ => self.begin(State::CoarseAlignment, simulator),
                }
            }
            (State::Erection | State::Attitude, Mode::Attitude) => {}
            (_, Mode::Attitude) => self.begin(State::Erection, simulator),
            (State::Erection | State::Attitude, _) => self.begin(State::CoarseAlignment, simulator),
            (State::Ready, Mode::Navigate) => self.enter(State::Navigation),
            (State::Navigation, Mode::Align) => self.leave_navigation(&parameters, simulator)?,
            _ => {}
        }
        if !matches!(self.state, State::Test | State::Navigation) {
            self.sense(dt, &parameters, simulator)?;
        }
        Ok(())
    }

    fn has_power(&self) -> bool {
        self.power != Power::None && !(self.power == Power::Battery && self.reasons.battery_empty)
    }

    fn power_up(&mut self, simulator: &Simulator) {
        self.reasons = Reasons::default();
        (self.found_latitude_rad, self.latitude_failures) = (None, 0);
        self.switched_on_e = simulator.true_point().map(|point| point.state.r_e);
        (self.in_navigation_s, self.on_battery_s, self.invalid_s) = (0.0, 0.0, 0.0);
        self.enter(State::Test);
    }

    /// Begins an alignment, or the erection of ATT.
    fn begin(&mut self, state: State, simulator: &Simulator) {
        self.look_at(simulator);
        self.place_e = simulator.true_point().map(|point| point.state.r_e);
        self.alignment = AlignmentProgress::default();
        self.motion = Default::default();
        self.inertial = Default::default();
        (self.heading_entered, self.realigned) = (false, false);
        self.reasons = Reasons::default();
        (self.in_navigation_s, self.invalid_s) = (0.0, 0.0);
        self.enter(state);
    }

    /// Begins what is in progress anew: an alignment that must not know of what was before, or an erection.
    pub(super) fn start_anew(&mut self) {
        self.realigned &= !self.reasons.north_unknown;
        let state = match self.state {
            State::Ready | State::Realignment if self.realigned => State::Realignment,
            State::CoarseAlignment | State::FineAlignment | State::Ready | State::Realignment => {
                State::CoarseAlignment
            }
            State::Erection | State::Attitude => State::Erection,
            _ => return,
        };
        self.alignment = AlignmentProgress::default();
        self.heading_entered = false;
        let Reasons { latitude_disagrees, latitude_too_high, north_unknown, .. } = &mut self.reasons;
        (*latitude_disagrees, *latitude_too_high, *north_unknown) = (false, false, false);
        if self.state != state {
            self.enter(state);
        }
    }

    /// Whether the solution is slow enough for a realignment.
    fn is_parked(parameters: &UnitParameters, simulator: &Simulator) -> Result<bool, Error> {
        let speed = simulator
            .navigation()?
            .map_or(0.0, |solution| solution.navigation.v_n.xy().norm_squared().sqrt());
        Ok(speed < parameters.realignment_speed_m_s)
    }

    /// Stops an alignment of an aircraft that moves. A realignment loses the navigation at a speed that is too high for it.
    fn stop_for_motion(&mut self, parameters: &UnitParameters, simulator: &Simulator) -> Result<(), Error> {
        self.start_anew();
        self.switched_on_e = None;
        if self.realigned && !Self::is_parked(parameters, simulator)? {
            return self.leave_navigation(parameters, simulator);
        }
        Ok(())
    }

    /// ALIGN after a flight: parked, a realignment, which needs a heading; in motion the navigation is lost.
    fn leave_navigation(&mut self, parameters: &UnitParameters, simulator: &Simulator) -> Result<(), Error> {
        let is_parked = Self::is_parked(parameters, simulator)?;
        let realigns = is_parked && !self.reasons.north_unknown;
        self.begin(if realigns { State::Realignment } else { State::CoarseAlignment }, simulator);
        self.realigned = realigns;
        self.reasons.motion = !is_parked && self.kind != AlignmentKind::InFlight;
        Ok(())
    }

    /// Stores position and heading, if they are valid.
    fn power_down(&mut self, simulator: &Simulator) -> Result<(), Error> {
        let navigated = self.state == State::Navigation;
        let is_valid = self.shows_solution() && !self.reasons.north_unknown;
        if let (true, Some(solution)) = (is_valid, simulator.navigation()?) {
            let navigation = &solution.navigation;
            self.stored = Some(StoredAlignment {
                latitude_rad: navigation.place.latitude_rad,
                longitude_rad: navigation.place.longitude_rad,
                heading_rad: navigation.euler.heading,
            });
        }
        self.enter(State::PowerDown);
        self.realigned = navigated;
        Ok(())
    }

    /// OFF, after the time for storing; before, back to work if the selector says so.
    fn switch_off(&mut self, simulator: &Simulator) -> Result<(), Error> {
        let parameters = self.limits;
        if self.selector == Mode::Navigate && self.realigned && self.state_s <= parameters.quick_off_s {
            return self.leave_navigation(&parameters, simulator);
        }
        if self.state_s >= parameters.power_down_s {
            self.realigned = false;
            self.enter(State::Off);
        }
        Ok(())
    }

    /// Takes the increments of the interval where the unit itself needs them.
    fn sense(
        &mut self,
        dt: f64,
        parameters: &UnitParameters,
        simulator: &mut Simulator,
    ) -> Result<(), Error> {
        let mut velocity_i = nalgebra::Vector3::zeros();
        let mut updates = 0;
        while let Some((increments, update_s)) = simulator.measured_update(updates) {
            velocity_i += self.inertial.turn(increments, update_s);
            updates += 1;
        }
        if updates == 0 {
            velocity_i = self.inertial.turn(&[self.measured], dt);
        }
        if matches!(self.state, State::Erection | State::Attitude) {
            self.erect(&velocity_i, dt, parameters);
            return Ok(());
        }
        self.align(&velocity_i, dt, parameters, simulator)
    }

    fn align(
        &mut self,
        velocity_i: &nalgebra::Vector3<f64>,
        dt: f64,
        parameters: &UnitParameters,
        simulator: &mut Simulator,
    ) -> Result<(), Error> {
        let point = simulator.true_point();
        let (place_e, temperature_c) =
            (point.map(|point| point.state.r_e), point.and_then(TruthPoint::temperature_c));
        self.stand_at(place_e, parameters);
        if self.aligns_in_flight() {
            self.reasons.motion = false;
            self.alignment.elapsed_s += dt;
            self.alignment.in_flight.feel(velocity_i, dt);
            return Ok(());
        }
        let is_made_up = self.is_made_up();
        if is_made_up && self.state == State::Ready {
            return Ok(());
        }
        let moves = self.motion.feel(velocity_i, place_e, dt, parameters);
        let is_tested = self.alignment.elapsed_s >= parameters.motion_inhibition_s;
        if moves && is_tested && !is_made_up {
            self.reasons.motion = true;
        }
        if self.reasons.motion {
            if self.motion.still_s < parameters.still_s {
                return self.stop_for_motion(parameters, simulator);
            }
            self.reasons.motion = false;
        }
        let whole_s = self.length_s(parameters);
        let window_s = self.window_s(whole_s, parameters);
        if self.alignment.elapsed_s == 0.0 {
            self.alignment.temperature_c = temperature_c;
        }
        let acceleration_e = simulator.true_acceleration_e().unwrap_or_default();
        let is_shown = self.alignment.advance(velocity_i, &self.inertial.q_is, &acceleration_e, dt, window_s);
        if is_shown == Some(false) && !is_made_up {
            self.reasons.motion = true;
            self.motion.still_s = 0.0;
            return self.stop_for_motion(parameters, simulator);
        }
        self.note_north(is_shown.is_some(), simulator);
        let elapsed_s = self.alignment.elapsed_s;
        let has_attitude = elapsed_s >= parameters.coarse_alignment_s - 0.5 * dt;
        if self.state == State::CoarseAlignment && has_attitude && self.alignment.newest().is_some() {
            self.enter(State::FineAlignment);
        }
        let is_over = elapsed_s >= whole_s - 0.5 * dt || self.state == State::Ready;
        if is_over && (is_shown.is_some() || is_made_up) {
            self.finish(parameters, simulator)?;
        }
        Ok(())
    }

    /// Whether the alignment in progress is one that only a simulation can make.
    pub(super) fn is_made_up(&self) -> bool {
        matches!(self.kind, AlignmentKind::Fast | AlignmentKind::Instant) && !self.realigned
    }

    /// Length of the alignment in progress \[s\].
    pub(super) fn length_s(&self, parameters: &UnitParameters) -> f64 {
        if self.realigned {
            return parameters.realignment_s;
        }
        match self.kind {
            AlignmentKind::Instant => 0.0,
            AlignmentKind::Fast => parameters.fast_alignment_s,
            AlignmentKind::InFlight => parameters.in_flight_alignment_s,
            _ if self.stored_heading_rad().is_some() => parameters.stored_heading_alignment_s,
            // Without a latitude the unit waits as long as at the largest one.
            _ => parameters.alignment_at_s(self.latitude_rad().unwrap_or(parameters.max_latitude_rad)),
        }
    }

    /// The entered latitude, else the stored one as long as the aircraft stands where the unit was switched on.
    pub(super) fn latitude_rad(&self) -> Option<f64> {
        let stored = self.stored.filter(|_| self.switched_on_e.is_some());
        self.entered.map(|entry| entry.latitude_rad).or(stored.map(|stored| stored.latitude_rad))
    }

    /// Length of the next window \[s\]: the rest of the alignment is a multiple of it.
    fn window_s(&self, whole_s: f64, parameters: &UnitParameters) -> f64 {
        if self.realigned || whole_s == 0.0 {
            return parameters.realignment_s;
        }
        // With a stored heading only the last window matters.
        let windows = if self.stored_heading_rad().is_some() { 1.0 } else { WINDOWS };
        let longest_s = parameters.coarse_alignment_s.min(whole_s / windows);
        let rest_s = whole_s - self.alignment.elapsed_s;
        if rest_s > 0.1 * longest_s { rest_s / (rest_s / longest_s).ceil() } else { longest_s }
    }
}

/// Sets the errors of the solution of the simulator to `errors`. Without a truth nothing changes.
pub(super) fn remove_errors(simulator: &mut Simulator, errors: &StateErrors) -> Result<(), Error> {
    if simulator.refuse_while_navigating().is_err() {
        return Ok(());
    }
    let Some((_, present)) = simulator.errors(ErrorSource::Navigation)? else { return Ok(()) };
    correct(simulator, &present)?;
    let StateErrors { position_n, velocity_n, misalignment_n } = errors;
    let wanted =
        StateErrors { position_n: -position_n, velocity_n: -velocity_n, misalignment_n: -misalignment_n };
    if *errors == StateErrors::NONE {
        Ok(())
    } else {
        simulator.correct(&Correction { errors: wanted, ..Correction::default() })
    }
}

/// Removes `errors` from the solution of the simulator, whose heading is known then.
pub(super) fn correct(simulator: &mut Simulator, errors: &NavigationErrors) -> Result<(), Error> {
    let NavigationErrors { position_n, velocity_n, misalignment_n, .. } = *errors;
    let errors = StateErrors { position_n, velocity_n, misalignment_n };
    simulator.correct(&Correction { errors, ..Correction::default() })?;
    simulator.find_north();
    Ok(())
}
