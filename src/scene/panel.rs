//! The unit of a scene, and what its crew does: `[unit]`, `[[panel]]`.

use core::f64::consts::{FRAC_PI_2, TAU};

use super::Scene;
use super::schedule::{LATEST_START_S, MAX_ITEMS, ROUNDING, TIMES_S};
use crate::base::error::{Error, Rule, check_range, check_within};
use crate::simulator::Simulator;
use crate::unit::{AlignmentKind, Mode, Power, Unit, UnitParameters};

/// The unit of a scene.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct UnitPlan {
    /// Position of the mode selector at the start, OFF or NAV; `None`: the scene has no unit.
    pub start: Option<Mode>,
    /// How it aligns.
    pub alignment: AlignmentKind,
    /// Times and limits.
    pub parameters: UnitParameters,
}

/// What is done at the panel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Action {
    /// The selector is turned.
    Select(Mode),
    /// A position is entered.
    Position,
    /// The true position is entered.
    TruePosition,
    /// A heading is entered.
    Heading,
    /// The supply of power changes.
    Power(Power),
    /// The button of the test is pressed.
    Test,
}

impl Default for Action {
    fn default() -> Self {
        Self::Select(Mode::Align)
    }
}

/// What is done, and when.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct PlannedAction {
    /// What is done.
    pub action: Action,
    /// Its time since the start of the flight \[s\].
    pub at_s: f64,
    /// Latitude, of [`Action::Position`] \[rad\].
    pub latitude_rad: f64,
    /// Longitude, of [`Action::Position`] \[rad\].
    pub longitude_rad: f64,
    /// Heading, of [`Action::Heading`] \[rad\].
    pub heading_rad: f64,
}

impl PlannedAction {
    // Ranges of a latitude, and of a longitude and a heading.
    pub(super) const LATITUDES_RAD: (f64, f64) = (-FRAC_PI_2, FRAC_PI_2);
    pub(super) const ANGLES_RAD: (f64, f64) = (-TAU, TAU);

    /// Checks every field.
    pub fn validate(&self) -> Result<(), Error> {
        check_within("panel.at_s", self.at_s, TIMES_S)?;
        check_within("panel.latitude_rad", self.latitude_rad, Self::LATITUDES_RAD)?;
        check_within("panel.longitude_rad", self.longitude_rad, Self::ANGLES_RAD)?;
        check_within("panel.heading_rad", self.heading_rad, Self::ANGLES_RAD)
    }

    fn act(&self, unit: &mut Unit, simulator: &Simulator) -> Result<(), Error> {
        match self.action {
            Action::Select(mode) => unit.select(mode),
            Action::Position => unit.enter_position(self.latitude_rad, self.longitude_rad)?,
            Action::TruePosition => {
                if let Some(truth) = simulator.truth()? {
                    let place = &truth.navigation.place;
                    unit.enter_position(place.latitude_rad, place.longitude_rad)?;
                }
            }
            Action::Heading => unit.enter_heading(self.heading_rad)?,
            Action::Power(power) => unit.set_power(power),
            Action::Test => unit.press_test(),
        }
        Ok(())
    }
}

impl Scene {
    /// Plans another action at the panel, which has been validated.
    pub fn add_action(&mut self, planned: PlannedAction) -> Result<(), Error> {
        check_range("actions at the panel", (self.panel.len() + 1) as f64, 0.0, MAX_ITEMS as f64)?;
        self.panel.push(planned);
        Ok(())
    }

    /// The unit of the scene; `None`: it has none.
    pub fn unit(&self) -> Result<Option<Unit>, Error> {
        let UnitPlan { start, alignment, parameters } = &self.unit;
        let Some(mode) = start else { return Ok(None) };
        let mut unit = Unit::new(parameters, *mode)?;
        unit.set_alignment(*alignment);
        Ok(Some(unit))
    }

    /// Does what is planned at the panel in the last interval of `simulator`, updates the unit, and gives it fixes: to be called after each
    /// step.
    /// `start_s` is the time stamp of the flight's first sample. An error of an action has its index; the other actions were made and the
    /// unit was updated.
    pub fn update_unit(&self, unit: &mut Unit, simulator: &mut Simulator, start_s: f64) -> Result<(), Error> {
        check_range("flight_start_s", start_s, -LATEST_START_S, LATEST_START_S)?;
        let Some(imu) = simulator.imu() else { return unit.update(simulator) };
        let end_s = imu.time_s - start_s - ROUNDING * imu.interval_s;
        let due = end_s - imu.interval_s..end_s;
        let mut acted = Ok(());
        for (index, planned) in
            self.panel.iter().enumerate().filter(|(_, planned)| due.contains(&planned.at_s))
        {
            acted = acted.and(planned.act(unit, simulator).map_err(|error| match error.rule {
                Rule::Sentence(words) if error.field.is_empty() => {
                    Error { field: "panel", index: Some(index), ..Error::bad_state(words) }
                }
                _ => error,
            }));
        }
        unit.update(simulator)?;
        self.push_fixes(unit, simulator, start_s)?;
        acted
    }
}
