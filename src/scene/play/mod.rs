//! A scene in flight: simulator, unit, samples and plan in one object.
//!
//! A [`Play`] flies a scene sample by sample: [`Play::fly_next`] takes the next sample of the scene, [`Play::push`] one of the host. Both
//! do all that the scene plans: temperature, failures and updates before the push, the panel and the unit after the step.
//! An [`Itinerary`] is a play without its simulator and its unit: what flies many of them at once has one.

mod itinerary;
mod snapshot;
mod source;
mod spacing;

pub use itinerary::{Itinerary, Stopped};
pub use source::Source;
pub use spacing::Spacing;

use std::sync::Arc;

use super::Scene;
use crate::base::error::Error;
use crate::simulator::{Simulator, Solution};
use crate::truth::{FlightSample, Pushed};
use crate::unit::{State, Status, Unit, UnitNavigation, Validity};

/// What an INS shows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shown {
    /// State and validity; without a unit, the INS navigates.
    pub status: Status,
    /// The navigation, as far as it is valid.
    pub navigation: UnitNavigation,
}

/// A scene in flight, which owns its simulator and its unit. (The C interface keeps them behind handles of their own beside the same
/// [`Itinerary`]: `PlayHandles`.)
#[derive(Debug, Clone)]
pub struct Play {
    itinerary: Itinerary,
    simulator: Box<[Simulator; 1]>,
    unit: Option<Unit>,
}

impl Play {
    /// `scene` before its first sample, on the samples of `source`.
    pub fn new(scene: Arc<Scene>, source: Source) -> Result<Self, Error> {
        let (simulator, unit) = (scene.simulator()?, scene.unit()?);
        Ok(Self { itinerary: Itinerary::new(scene, source)?, simulator, unit })
    }

    /// Flies to the next sample of the scene; `None`: the flight is over. After an error the next call tries the same interval again. No
    /// allocation.
    pub fn fly_next(&mut self) -> Result<Option<Pushed>, Stopped> {
        let [simulator] = &mut *self.simulator;
        self.itinerary.fly_next(simulator, self.unit.as_mut())
    }

    /// Flies to a sample of the host. A sample that is rejected changes nothing of what later samples lead to. No allocation.
    pub fn push(&mut self, sample: &FlightSample) -> Result<Pushed, Stopped> {
        let [simulator] = &mut *self.simulator;
        self.itinerary.push(simulator, self.unit.as_mut(), sample)
    }

    /// Flies until a record is due; false: the flight was over. The first sample and the last one have a
    /// record.
    pub fn run(&mut self) -> Result<bool, Stopped> {
        while self.fly_next()?.is_some() {
            if self.itinerary.is_due() {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// The plan and the place in it.
    pub fn itinerary(&self) -> &Itinerary {
        &self.itinerary
    }

    /// The same, for the spacing of records and the errors of the sensors since the last one.
    pub fn itinerary_mut(&mut self) -> &mut Itinerary {
        &mut self.itinerary
    }

    /// Takes over what another scene plans: [`Itinerary::set_plan`].
    pub fn set_plan(&mut self, scene: &Scene) -> Result<(), Error> {
        let [simulator] = &mut *self.simulator;
        self.itinerary.set_plan(simulator, scene)
    }

    /// The simulator, for every read.
    pub fn simulator(&self) -> &Simulator {
        &self.simulator[0]
    }

    /// The simulator, for corrections, repositions and what else a host does between two samples.
    pub fn simulator_mut(&mut self) -> &mut Simulator {
        &mut self.simulator[0]
    }

    /// The unit, if the scene has one.
    pub fn unit(&self) -> Option<&Unit> {
        self.unit.as_ref()
    }

    /// The unit, for a host that has a panel of its own, with its simulator, for fixes.
    pub fn unit_mut(&mut self) -> Option<(&mut Unit, &mut Simulator)> {
        let [simulator] = &mut *self.simulator;
        self.unit.as_mut().map(|unit| (unit, simulator))
    }

    /// Gives a scene without a unit one that stands beside it, such as one that navigates already.
    pub fn set_unit(&mut self, unit: Unit) {
        self.unit = Some(unit);
    }

    /// What the INS shows now; `None`: before the first interval.
    pub fn shown(&self) -> Result<Option<Shown>, Error> {
        shown(self.simulator(), self.unit())
    }
}

/// What an INS with `simulator`, and a unit if it has one, shows.
pub(crate) fn shown(simulator: &Simulator, unit: Option<&Unit>) -> Result<Option<Shown>, Error> {
    if !simulator.has_started() {
        return Ok(None);
    }
    if let Some(unit) = unit {
        return Ok(Some(Shown { status: unit.status(), navigation: unit.navigation(simulator)? }));
    }
    let Some(Solution { time_s, navigation, .. }) = simulator.navigation()? else { return Ok(None) };
    let validity = Validity { rates: false, attitude: true, heading: true, position: true, velocity: true };
    let status = Status { state: State::Navigation, validity, ..Status::default() };
    let navigation = UnitNavigation {
        time_s,
        validity,
        place: navigation.place,
        v_n: navigation.v_n,
        euler: navigation.euler,
        ..UnitNavigation::default()
    };
    Ok(Some(Shown { status, navigation }))
}
