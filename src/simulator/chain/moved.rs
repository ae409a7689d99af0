//! Jumps of the host's time or of its truth, after which the INS continues with its errors.

use super::Chain;
use crate::base::error::{Error, ErrorKind, Rule};
use crate::earth::state::{EarthFixedState, Navigation};
use crate::errors::CarriedErrors;
use crate::mechanization::Mechanization;
use crate::signal::SignalGenerator;
use crate::signal::mounting::Block;
use crate::simulator::Imperfections;
use crate::simulator::chain::view::Views;
use crate::simulator::disturbance::Disturbance;
use crate::simulator::start::rate_at_start;
use crate::truth::TruthPoint;

/// State of the sensors' own point before and after a jump. With a mounting, this point is the block's.
struct Jump {
    from: (EarthFixedState, Navigation),
    to: (EarthFixedState, Navigation),
}

impl Chain {
    /// Moves all clocks by `shift_s` [s]. The last interval then ended at `time_s` [s].
    pub fn move_time(&mut self, shift_s: f64, time_s: f64) {
        self.last.move_to(time_s);
        self.accuracy.move_time(shift_s);
        if let Some(closed_loop) = &mut self.closed_loop {
            closed_loop.move_time(shift_s);
        }
    }

    /// Follows a jump of the truth from `from` to `to`. The solution and the error model keep their errors. On an error nothing has
    /// changed.
    #[inline(never)]
    pub fn move_truth(
        &mut self,
        from: &TruthPoint,
        to: &TruthPoint,
        imperfections: &mut Imperfections,
    ) -> Result<(), Error> {
        self.options.check_truth(to)?;
        let block = self.block.map(|block| block.turning_at(rate_at_start(&self.earth, to, None)));
        let jump = self.jump(block.as_ref(), from, to);
        let mechanization = self.carried(&self.mechanization, &jump)?;
        self.check_in(&mechanization, block.as_ref())?;
        let shadow = match self.closed_loop.as_mut().and_then(|closed_loop| closed_loop.shadow_mut().copied())
        {
            Some(shadow) => Some(self.carried(&shadow, &jump)?),
            None => None,
        };
        self.go_on(&jump, mechanization, shadow, (from, to), imperfections);
        self.block = block;
        self.generator = SignalGenerator::new(self.earth.rate_rad_s);
        self.closure.turn(&self.earth, from.place(), to.place());
        imperfections.go_on(to.height_m() - from.height_m());
        if let Some(disturbance) = &mut self.disturbance {
            *disturbance = Disturbance::new(imperfections.gravity.at(&self.earth, to));
        }
        self.move_time(to.time_s - from.time_s, to.time_s);
        Ok(())
    }

    /// Takes the velocity of the truth at `point`, which was 0 so far and is now known. The velocity of the solution increases by
    /// the same amount.
    #[cold]
    #[inline(never)]
    pub fn take_first_velocity(&mut self, point: &TruthPoint, imperfections: &Imperfections) {
        let mut without = *point;
        without.state.v_e.fill(0.0);
        let block = self.block;
        let jump = self.jump(block.as_ref(), &without, point);
        // Only the velocity changes: a place with the position error exists at this height, because it is the current place.
        let Ok(mechanization) = self.carried(&self.mechanization, &jump) else { return };
        if self.check_in(&mechanization, block.as_ref()).is_err() {
            return;
        }
        let shadow = self
            .closed_loop
            .as_mut()
            .and_then(|closed_loop| closed_loop.shadow_mut().copied())
            .and_then(|shadow| self.carried(&shadow, &jump).ok());
        self.go_on(&jump, mechanization, shadow, (&without, point), imperfections);
    }

    /// The jump of the sensors' own point from `from` to `to`. At `to` the sensors are in `block`.
    fn jump(&self, block: Option<&Block>, from: &TruthPoint, to: &TruthPoint) -> Jump {
        let at = |block: Option<&Block>, point: &TruthPoint| match block {
            Some(block) => {
                let state = block.state(point);
                (state, state.navigation(&self.earth, self.options.axes))
            }
            None => (point.state, point.navigation(&self.earth, self.options.axes)),
        };
        Jump { from: at(self.block.as_ref(), from), to: at(block, to) }
    }

    /// `navigator` after the jump, with its errors.
    fn carried(&self, navigator: &Mechanization, jump: &Jump) -> Result<Mechanization, Error> {
        let errors = CarriedErrors::of(&self.earth, &navigator.state(), &jump.from.1);
        let Some(state) = errors.at(&self.earth, &jump.to.1) else {
            let error = navigator.minus(&jump.from.0).r_e.norm_squared().sqrt();
            let rule =
                Rule::Sentence("cannot be kept: there is no place with this error at the sample's height");
            return Err(Error::of(ErrorKind::Diverged, "navigated position error [m]", error, rule));
        };
        let moved = navigator.moved_to(&state);
        moved.check()?;
        Ok(moved)
    }

    fn go_on(
        &mut self,
        jump: &Jump,
        mechanization: Mechanization,
        shadow: Option<Mechanization>,
        (from, to): (&TruthPoint, &TruthPoint),
        imperfections: &Imperfections,
    ) {
        self.mechanization = mechanization;
        let at = |(state, _): &(EarthFixedState, Navigation), point: &TruthPoint| {
            (self.earth.vertical(&state.r_e), state.v_e, point.is_near_pole())
        };
        if let Some(model) = &mut self.error_model {
            *model = model.moved(&at(&jump.from, from), &at(&jump.to, to));
        }
        for covariance in &mut *self.covariance {
            let last = (from, self.block.as_ref());
            covariance.move_truth(
                last,
                &at(&jump.from, from),
                &at(&jump.to, to),
                &imperfections.parameters(),
            );
        }
        if let Some(closed_loop) = &mut self.closed_loop {
            if let (Some(old), Some(new)) = (closed_loop.shadow_mut(), shadow) {
                *old = new;
            }
            closed_loop.go_on(&self.mechanization, &jump.to.0, to.time_s);
        }
        self.views = Views::default();
    }
}
