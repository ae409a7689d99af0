//! What a snapshot keeps of the chain.

use nalgebra::Vector3;

use super::{Chain, Extension};
use crate::earth::Earth;
use crate::error::{Error, Rule};
use crate::mechanization::Mechanization;
use crate::simulator::disturbance::Disturbance;
use crate::simulator::interval::LastInterval;
use crate::simulator::mounted::block_at_start;
use crate::simulator::start::Start;
use crate::simulator::{Imperfections, ImuInterval, Options};
use crate::snapshot::{COUNT, Numbers, Reader, Stored, Writer};
use crate::truth::TruthPoint;

/// The values are read into a chain that was made at the current point. Only the sums of the increments are stored.
impl Stored for Chain {
    fn save(&self, to: &mut Writer<'_>) {
        let Self {
            options: _,
            earth: _,
            generator,
            signals: _,
            parts: _,
            last: _,
            north_unknown,
            mechanization,
            error_model,
            compensation,
            measured: _,
            is_corrected,
            accuracy,
            intervals,
            closure,
            closed_loop,
            block,
            disturbance,
            covariance,
            summary,
            is_plain: _,
            views: _,
        } = self;
        summary.iter().for_each(|summary| summary.save(to));
        covariance.iter().for_each(|covariance| covariance.save(to));
        generator.save(to);
        self.imu().save(to);
        self.last.vertical_unaided().unwrap_or_default().save(to);
        to.flag(*north_unknown);
        block.iter().for_each(|block| block.save(to));
        disturbance.iter().for_each(|disturbance| disturbance.save(to));
        mechanization.save(to);
        if let Some(model) = error_model {
            model.save(to);
        }
        compensation.save(to);
        to.flag(*is_corrected);
        accuracy.save(to);
        intervals.save(to);
        closure.save(to);
        if let Some(closed_loop) = closed_loop {
            closed_loop.save(to);
        }
    }

    fn load(&mut self, from: &mut Reader<'_>) -> Result<(), Error> {
        if let Some(summary) = &mut self.summary {
            summary.load(from)?;
        }
        self.covariance.iter_mut().try_for_each(|covariance| covariance.load(from))?;
        self.generator.load(from)?;
        let mut imu: Option<ImuInterval> = None;
        imu.load(from)?;
        let vertical_unaided = from.flag()?;
        self.last = imu.map_or(LastInterval::None, |imu| LastInterval::Loaded { imu, vertical_unaided });
        self.north_unknown = from.flag()?;
        if let Some(block) = &mut self.block {
            block.load(from)?;
        }
        if let Some(disturbance) = &mut self.disturbance {
            disturbance.load(from)?;
        }
        self.mechanization.load(from)?;
        if let Some(model) = &mut self.error_model {
            model.load(from)?;
        }
        self.compensation.load(from)?;
        self.is_corrected = from.flag()?;
        self.accuracy.load(from)?;
        from.enter("snapshot: intervals");
        Numbers::load(&mut self.intervals, from, COUNT)?;
        self.closure.load(from)?;
        if let Some(closed_loop) = &mut self.closed_loop {
            closed_loop.load(from)?;
        }
        self.check()
    }
}

impl Chain {
    /// The point that the chain of a snapshot has reached: the first of the points `behind`, newest first.
    pub fn flown_to<'a>(
        behind: &[Option<&'a TruthPoint>; 3],
        from: &mut Reader<'_>,
    ) -> Result<&'a TruthPoint, Error> {
        if let [Some(current), ..] = *behind {
            return Ok(current);
        }
        from.enter("snapshot: samples that were flown");
        Err(from.refused(0.0, Rule::Sentence("must be at least 1 in flight")))
    }

    /// A chain at the point `current`, into which the chain of a snapshot can be read.
    pub fn to_load(
        options: &Options,
        earth: Earth,
        current: &TruthPoint,
        imperfections: &Imperfections,
    ) -> Self {
        let navigator = Mechanization::new(earth, options.frame, options.scheme, &current.state);
        let extension = Extension {
            block: imperfections
                .mounting()
                .map(|mounting| block_at_start(mounting, options, &earth, current, None)),
            disturbance: imperfections.gravity.is_on().then(|| Disturbance::new(Vector3::zeros())),
            sensors_state: current.state,
        };
        Self::new(options, earth, current, &Start::TRUE, navigator, true, extension)
    }

    /// Gives the generator the past points `behind`, newest first.
    pub fn look_back(&mut self, behind: &[Option<&TruthPoint>; 3]) {
        self.generator.look_back(behind);
    }
}
