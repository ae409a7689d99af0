//! What a snapshot keeps of the chain.

use nalgebra::Vector3;

use super::{Chain, Extension};
use crate::base::error::Error;
use crate::base::snapshot::{COUNT, Numbers, Reader, Stored, Writer};
use crate::earth::Earth;
use crate::mechanization::Mechanization;
use crate::signal::MAX_INCREMENTS;
use crate::simulator::disturbance::Disturbance;
use crate::simulator::imu::LastInterval;
use crate::simulator::start::{Start, block_at_start};
use crate::simulator::{Imperfections, ImuInterval, Options};
use crate::truth::TruthPoint;

/// The values are read into a chain that was made at the current point: the parts that it has are those of the snapshot. Of the last
/// interval the sums of the increments are stored, and the increments on which the INS navigated, which a unit reads.
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
        summary.as_slice().save(to);
        covariance.save(to);
        generator.save(to);
        self.imu().save(to);
        to.count(self.flown_on().len());
        self.flown_on().save(to);
        self.last.vertical_unaided().unwrap_or_default().save(to);
        north_unknown.save(to);
        block.as_slice().save(to);
        disturbance.as_slice().save(to);
        mechanization.save(to);
        error_model.as_slice().save(to);
        compensation.save(to);
        is_corrected.save(to);
        accuracy.save(to);
        intervals.save(to);
        closure.save(to);
        closed_loop.as_slice().save(to);
    }

    fn load(&mut self, from: &mut Reader<'_>) -> Result<(), Error> {
        self.summary.as_mut_slice().load(from)?;
        self.covariance.load(from)?;
        self.generator.load(from)?;
        let mut imu: Option<ImuInterval> = None;
        imu.load(from)?;
        from.enter("snapshot: increments");
        let count = from.count(MAX_INCREMENTS.min(self.signals.measured.len()))?;
        self.signals.measured[..count].load(from)?;
        self.parts = 0..count;
        let vertical_unaided = from.flag()?;
        self.last = imu.map_or(LastInterval::None, |imu| LastInterval::Summed { imu, vertical_unaided });
        self.north_unknown = from.flag()?;
        self.block.as_mut_slice().load(from)?;
        self.disturbance.as_mut_slice().load(from)?;
        self.mechanization.load(from)?;
        self.error_model.as_mut_slice().load(from)?;
        self.compensation.load(from)?;
        self.is_corrected = from.flag()?;
        self.accuracy.load(from)?;
        from.enter("snapshot: intervals");
        Numbers::load(&mut self.intervals, from, COUNT)?;
        self.closure.load(from)?;
        self.closed_loop.as_mut_slice().load(from)?;
        self.check()
    }
}

impl Chain {
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
