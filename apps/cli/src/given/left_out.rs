//! What the studies of errors (`budget`, `curve`, `recommend`) leave out of a scene.

use super::Given;
use crate::terminal::say;

impl Given {
    /// Says what a study of the errors of the sensors leaves out of this scene, and in which direction its figures err.
    pub fn say_left_out(&self) {
        self.left_out().iter().for_each(|sentence| say(&format!("{}: {sentence}", self.name)));
    }

    /// The same of a study of the errors of the algorithm, which an alignment and failures do not change.
    pub fn say_without_updates(&self) {
        self.without_updates().iter().for_each(|sentence| say(&format!("{}: {sentence}", self.name)));
    }

    /// What a study of the errors of the sensors leaves out.
    pub fn left_out(&self) -> Vec<String> {
        let scene = &self.scene;
        let left_out = [
            (scene.unit.start.is_some(), "unit: the errors that its alignment leaves are not in the figures"),
            (!scene.failures.is_empty(), "failures: the errors that they cause are not in the figures"),
        ];
        let planned = left_out.into_iter().filter(|(is_planned, _)| *is_planned);
        let sentences = planned.map(|(_, what)| format!("without its {what}, which are too small"));
        sentences.chain(self.without_updates()).collect()
    }

    /// What a study of the errors of the algorithm leaves out.
    pub fn without_updates(&self) -> Option<String> {
        let why = "the errors grow where an update would bound them, and the figures are too large";
        (!self.scene.updates.is_empty()).then(|| format!("without its updates: {why}"))
    }
}
