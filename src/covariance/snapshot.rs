//! What a snapshot keeps of the propagation.

use super::propagation::{Propagation, Root};
use super::stretch::Stretch;
use crate::error::Error;
use crate::snapshot::{Numbers, Reader, Stored, Writer};

/// For errors: more than any that is propagated, with squares that are finite.
const ERRORS: f64 = 1e140;

impl Stored for Propagation {
    fn save(&self, to: &mut Writer<'_>) {
        let Root { sensitivities, factor, walks, channel } = &self.root;
        sensitivities.iter().chain(factor).for_each(|column| Numbers::save(column, to));
        Numbers::save(walks, to);
        channel.save(to);
        self.stretch.save(to);
    }

    fn load(&mut self, from: &mut Reader<'_>) -> Result<(), Error> {
        from.enter("snapshot: covariance");
        let Root { sensitivities, factor, walks, channel } = &mut self.root;
        sensitivities.iter_mut().chain(factor).try_for_each(|column| Numbers::load(column, from, ERRORS))?;
        Numbers::load(walks, from, ERRORS)?;
        from.require(walks.iter().all(|walk| *walk >= 0.0), 0.0, "must not be negative")?;
        channel.load(from)?;
        self.stretch = Stretch::EMPTY;
        self.stretch.load(from)
    }
}
