//! The tables of handles, one for each kind of object, and the functions that go through all of them.

#[cfg(feature = "scenes")]
use std::sync::Arc;

use super::registry::Registry;
#[cfg(feature = "identify")]
use crate::analysis::identify::Feed;
use crate::ensemble::Ensemble;
use crate::judge::Judge;
#[cfg(feature = "scenes")]
use crate::log::FlightLog;
#[cfg(feature = "scenes")]
use crate::scene::{Fault, Itinerary, Scene};
use crate::simulator::Simulator;
use crate::truth::flight::Flight;
use crate::unit::Unit;

/// Simulators, each made by [`crate::base::memory::only`], as memory for it can be missing.
pub(in crate::abi) static SIMULATORS: Registry<Box<[Simulator; 1]>, 1> = Registry::new();
pub(in crate::abi) static FLIGHTS: Registry<Flight, 2> = Registry::new();
#[cfg(feature = "scenes")]
pub(in crate::abi) static SCENES: Registry<SceneText, 3> = Registry::new();
#[cfg(feature = "scenes")]
pub(in crate::abi) static LOGS: Registry<Arc<FlightLog>, 4> = Registry::new();
pub(in crate::abi) static ENSEMBLES: Registry<Ensemble, 5> = Registry::new();
pub(in crate::abi) static UNITS: Registry<Unit, 6> = Registry::new();
#[cfg(feature = "scenes")]
pub(in crate::abi) static PLAYS: Registry<PlayHandles, 7> = Registry::new();
/// Judges, each made as simulators are.
pub(in crate::abi) static JUDGES: Registry<Box<[Judge; 1]>, 8> = Registry::new();
/// Paths with their records, likewise.
#[cfg(feature = "identify")]
pub(in crate::abi) static IDENTIFIES: Registry<Box<[Feed; 1]>, 9> = Registry::new();

/// The result of reading a text: a scene, unless the text has faults.
#[cfg(feature = "scenes")]
pub(in crate::abi) struct SceneText {
    pub scene: Option<Box<Scene>>,
    /// The faults of the text, or of the change of the scene that was rejected last.
    pub faults: Vec<Fault>,
    /// The names and contents of files beside the log.
    pub files: Vec<(String, Vec<u8>)>,
}

/// A scene in flight, whose simulator and unit have handles of their own, which the host may use too; therefore no `scene::Play`, which
/// owns both.
#[cfg(feature = "scenes")]
pub(in crate::abi) struct PlayHandles {
    pub itinerary: Itinerary,
    /// Key of the simulator.
    pub sim: usize,
    /// Key of the unit, if the scene has one.
    pub unit: Option<usize>,
}

#[cfg(feature = "scenes")]
impl Drop for PlayHandles {
    fn drop(&mut self) {
        SIMULATORS.remove(self.sim);
        self.unit.map(|unit| UNITS.remove(unit));
    }
}

/// Whether this thread is inside a call on a handle.
pub(in crate::abi) fn is_inside_a_handle() -> bool {
    #[cfg(feature = "scenes")]
    if SCENES.is_in_use_here() || LOGS.is_in_use_here() || PLAYS.is_in_use_here() {
        return true;
    }
    #[cfg(feature = "identify")]
    if IDENTIFIES.is_in_use_here() {
        return true;
    }
    SIMULATORS.is_in_use_here()
        || FLIGHTS.is_in_use_here()
        || ENSEMBLES.is_in_use_here()
        || UNITS.is_in_use_here()
        || JUDGES.is_in_use_here()
}

/// Called in a forked process: objects that other threads had in use are lost.
#[cfg(unix)]
pub(in crate::abi) fn lose_what_others_use() {
    SIMULATORS.lose_what_others_use();
    FLIGHTS.lose_what_others_use();
    ENSEMBLES.lose_what_others_use();
    UNITS.lose_what_others_use();
    JUDGES.lose_what_others_use();
    #[cfg(feature = "identify")]
    IDENTIFIES.lose_what_others_use();
    #[cfg(feature = "scenes")]
    {
        SCENES.lose_what_others_use();
        LOGS.lose_what_others_use();
        PLAYS.lose_what_others_use();
    }
}
