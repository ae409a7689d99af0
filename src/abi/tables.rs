//! The tables of handles, one for each kind of object, and what concerns all of them.

use super::registry::Registry;
use crate::ensemble::Ensemble;
use crate::flight::Flight;
#[cfg(feature = "scenes")]
use crate::log::FlightLog;
#[cfg(feature = "scenes")]
use crate::scene::{Fault, Scene};
use crate::simulator::Simulator;

/// Each in a slice of one, which unlike a `Box` can be made without aborting.
pub(super) static SIMULATORS: Registry<Box<[Simulator]>> = Registry::new(1);
pub(super) static FLIGHTS: Registry<Flight> = Registry::new(2);
#[cfg(feature = "scenes")]
pub(super) static SCENES: Registry<SceneText> = Registry::new(3);
#[cfg(feature = "scenes")]
pub(super) static LOGS: Registry<FlightLog> = Registry::new(4);
pub(super) static ENSEMBLES: Registry<Ensemble> = Registry::new(5);

/// What a text was: a scene, or what is wrong with it.
#[cfg(feature = "scenes")]
pub(super) enum SceneText {
    Scene(Box<Scene>),
    Faults(Vec<Fault>),
}

/// Whether this thread is inside a call on a handle.
pub(super) fn is_inside_a_handle() -> bool {
    #[cfg(feature = "scenes")]
    if SCENES.is_in_use_here() || LOGS.is_in_use_here() {
        return true;
    }
    SIMULATORS.is_in_use_here() || FLIGHTS.is_in_use_here() || ENSEMBLES.is_in_use_here()
}

/// In a process that was forked: what other threads had in use is lost.
#[cfg(unix)]
pub(super) fn lose_what_others_use() {
    SIMULATORS.lose_what_others_use();
    FLIGHTS.lose_what_others_use();
    ENSEMBLES.lose_what_others_use();
    #[cfg(feature = "scenes")]
    {
        SCENES.lose_what_others_use();
        LOGS.lose_what_others_use();
    }
}
