//! What contradictions between velocities and positions do to an INS with ideal sensors.

use nalgebra::Vector3;

use super::row::Row;
use crate::earth::Earth;
use crate::truth::Answer;

/// Time after which the answer is advanced [s].
const STEP_S: f64 = 1.0;

#[derive(Debug, Clone)]
pub(super) struct InducedError {
    answer: Answer,
    pending_e: Vector3<f64>,
    pending_s: f64,
    v_e: Option<Vector3<f64>>,
    /// Largest horizontal error of the position [m].
    pub largest_m: f64,
}

impl InducedError {
    pub fn new() -> Self {
        Self { answer: Answer::new(), pending_e: Vector3::zeros(), pending_s: 0.0, v_e: None, largest_m: 0.0 }
    }

    /// Adds a row.
    pub fn add(&mut self, earth: &Earth, row: &Row) {
        let v_e = row.v_e();
        if let (Some(now), Some(before)) = (v_e, self.v_e) {
            self.pending_e += (now + before) * (0.5 * row.interval_s) - row.d_e;
            self.pending_s += row.interval_s;
        }
        self.v_e = v_e;
        if self.pending_s < STEP_S {
            return;
        }
        let r_e = earth.to_earth_fixed(&row.place);
        let gravity_e = earth.gravity(&r_e);
        self.answer.advance(earth, &r_e, &gravity_e, &self.pending_e, self.pending_s);
        (self.pending_e, self.pending_s) = (Vector3::zeros(), 0.0);
        let (position_e, _) = self.answer.now(earth, &r_e, &gravity_e);
        self.largest_m = self.largest_m.max(position_e.norm_squared().sqrt());
    }
}

#[cfg(test)]
mod tests {
    use crate::base::math::Euler;
    use crate::earth::Earth;
    use crate::judge::Judge;
    use crate::truth::FlightSample;
    use crate::truth::STEPS;

    /// Rows 100 s apart whose clock jumps by every size that a stamp allows: an INS takes at most 401 steps for a row, and one more for its
    /// errors now, and a jump that no INS flies is no error of an INS.
    #[test]
    fn a_jump_of_the_clock_takes_a_bounded_number_of_steps() {
        let earth = Earth::default();
        let mut most = 0_u64;
        for jump_s in [0.0, 999.0, 1001.0, 1e5, 1.7e9, 0.99 * FlightSample::LATEST_S] {
            let mut judge = Judge::new(earth, 2000.0).unwrap();
            let before = STEPS.get();
            for k in 0..20 {
                let time_s = 100.0 * f64::from(k) + if k < 10 { 0.0 } else { jump_s };
                let mut sample = FlightSample::at_rest(time_s, Default::default(), Euler::default());
                sample.v_n.iter_mut().for_each(|v| v.x = 1e-3);
                let so_far = STEPS.get();
                judge.push(&sample).unwrap();
                most = most.max(STEPS.get() - so_far);
            }
            let steps = STEPS.get() - before;
            assert!((20..=20 * 402).contains(&steps), "{jump_s} s: {steps} steps");
            // 1 mm/s for 2000 s, and for the longest interval.
            assert!(judge.effect.largest_m < 4.0, "{jump_s} s: {} m", judge.effect.largest_m);
        }
        println!("figure: at most {most}");
    }
}
