//! What the studies of errors (`budget`, `curve`, `recommend`) leave out of a scene.

use super::Given;
use crate::terminal::say;

impl Given {
    /// Says what a study of the errors of the sensors leaves out of this scene, and in which direction its figures err.
    pub fn say_left_out(&self) {
        let scene = &self.scene;
        let left_out = [
            (scene.unit.start.is_some(), "unit: the errors that its alignment leaves are not in the figures"),
            (!scene.failures.is_empty(), "failures: the errors that they cause are not in the figures"),
        ];
        for (_, what) in left_out.into_iter().filter(|(is_planned, _)| *is_planned) {
            say(&format!("{}: without its {what}, which are too small", self.name));
        }
        self.say_without_updates();
    }

    /// The same of a study of the errors of the algorithm, which an alignment and failures do not change.
    pub fn say_without_updates(&self) {
        if !self.scene.updates.is_empty() {
            let why = "the errors grow where an update would bound them, and the figures are too large";
            say(&format!("{}: without its updates: {why}", self.name));
        }
    }
}
