//! The part of the propagation that a snapshot keeps.

use super::propagation::Propagation;
use super::root::{LARGEST, Root};
use super::stretch::Stretch;
use crate::base::error::Error;
use crate::base::snapshot::{Numbers, Reader, Stored, Writer};

/// Before a flight only the walks continue.
impl Propagation {
    pub fn save_waiting(&self, to: &mut Writer<'_>) {
        Numbers::save(&self.root.walks, to);
    }

    pub fn load_waiting(&mut self, from: &mut Reader<'_>) -> Result<(), Error> {
        from.enter("snapshot: covariance");
        Numbers::load(&mut self.root.walks, from, LARGEST)?;
        from.require(self.root.walks.iter().all(|walk| *walk >= 0.0), 0.0, "must not be negative")
    }
}

impl Stored for Propagation {
    fn save(&self, to: &mut Writer<'_>) {
        let Root { sensitivities, factor, mean, mean_was_beyond, walks: _, channel } = &self.root;
        self.save_waiting(to);
        sensitivities.iter().chain(factor).chain([mean]).for_each(|column| Numbers::save(column, to));
        mean_was_beyond.save(to);
        channel.save(to);
        self.stretch.save(to);
    }

    fn load(&mut self, from: &mut Reader<'_>) -> Result<(), Error> {
        self.load_waiting(from)?;
        let Root { sensitivities, factor, mean, mean_was_beyond, walks: _, channel } = &mut self.root;
        let columns = sensitivities.iter_mut().chain(factor).chain([mean]);
        columns.into_iter().try_for_each(|column| Numbers::load(column, from, LARGEST))?;
        *mean_was_beyond = from.flag()?;
        channel.load(from)?;
        self.stretch = Stretch::EMPTY;
        self.stretch.load(from)
    }
}
