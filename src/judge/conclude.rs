//! The findings that follow from the statistics.

use super::attitude::{Attitudes, PitchFault};
use super::blocks::Level as BlockLevel;
use super::finding::{Clue, Finding, Kind, Level, MIRRORED, RADIANS, ZERO};
use super::held::Held;
use super::velocity::Wrong;
use super::{Judge, MAX_FINDINGS};
use crate::base::math::hypot;
use crate::base::units::STANDARD_GRAVITY as G;

/// False acceleration above which a finding is a note, doubtful, unusable [m/s²]. An asymmetry of 100 ppm rectifies 1 m/s² to 8 µg;
/// 50 m/s² saturates the sensors of many grades.
const ACCELERATION_LEVELS: [f64; 3] = [1.0, 2.0, 50.0];

/// Largest accelerations of vehicles: 15 g in manoeuvres, and 50 g when they touch the ground [m/s²].
const MANOEUVRE_M_S2: f64 = 150.0;
const JOLT_M_S2: f64 = 500.0;

/// Noise that is none of a receiver [m], and as a share of the way of a row.
const GROSS_M: f64 = 50.0;
const GROSS: f64 = 0.6;

/// Share of the moving rows that may be held.
const HELD_SHARE: f64 = 0.005;

/// Unexplained share of the displacement above which velocities are unusable.
const CONTRADICTION: f64 = 0.1;

/// Error of an INS with ideal sensors above which late velocities, and noise of the attitude, are doubtful [m].
const LATE_ERROR_M: f64 = 5.0;
const NOISE_ERROR_M: f64 = 10.0;

/// Drift of the attitude about an axis: each row adds this share of the product of the white noises about the two others [1]. Between rows
/// the rotation vector is a cubic through both attitudes and the rates of their stencils; two subsamples a row miss this of its coning.
/// Evidence: INSs with ideal sensors at 10 to 50 Hz with 0.25 to 1 deg of noise err by 0.76 to 0.93 of it, rms of 8 runs each.
const CONING: f64 = 0.1285;

/// Largest interval at which noise of an attitude is told from its motion [s], and ratio of its differences above which it is: those of
/// drones in gusts, at 10 Hz, have 0.86.
const OFTEN_S: f64 = 0.125;
const WHITE: f64 = 0.92;

/// Time over which a tilt is integrated at most: a fifth of a Schuler period [s].
const LONGEST_S: f64 = 1000.0;

/// Velocities contradict the positions by a share of the displacement, and nothing explains it.
fn contradicts(share: f64, ins_error_m: f64) -> Finding {
    let level = if share > CONTRADICTION { Level::Unusable } else { Level::Doubtful };
    Finding { ins_error_m, ..Finding::new(Kind::VelocityContradicts, level, share) }
}

/// Findings as they are collected.
struct Findings {
    list: [Option<Finding>; MAX_FINDINGS],
    count: usize,
}

impl Findings {
    fn add(&mut self, finding: Finding) {
        if let Some(place) = self.list.get_mut(self.count) {
            *place = Some(finding);
            self.count += 1;
        }
    }
}

/// The level of a false acceleration [m/s²]; `None`: it does not matter.
fn level_of(acceleration_m_s2: f64) -> Option<Level> {
    let [note, doubtful, unusable] = ACCELERATION_LEVELS;
    match acceleration_m_s2 {
        a if a > unusable => Some(Level::Unusable),
        a if a > doubtful => Some(Level::Doubtful),
        a if a > note => Some(Level::Note),
        _ => None,
    }
}

impl Judge {
    /// What is found in the samples so far, the worst first.
    pub fn findings(&self) -> impl Iterator<Item = Finding> + Clone + use<> {
        let mut found = Findings { list: [None; MAX_FINDINGS], count: 0 };
        if self.rows > 1 {
            self.find_in_stamps(&mut found);
            self.find_in_positions(&mut found);
            self.find_in_velocities(&mut found);
            if self.has_attitude {
                self.find_in_attitudes(&mut found);
            }
        }
        found.list.iter_mut().flatten().for_each(|own| own.is_of_path = self.is_path);
        for finding in self.of_rows.iter().flatten() {
            if !found.list.iter().flatten().any(|own| own.kind == finding.kind) {
                found.add(*finding);
            }
        }
        let rank = |finding: &Option<Finding>| core::cmp::Reverse(finding.map(|finding| finding.level));
        found.list.sort_by_key(rank);
        found.list.into_iter().flatten()
    }

    /// The level of the worst finding.
    pub fn worst(&self) -> Option<Level> {
        self.findings().map(|finding| finding.level).max()
    }

    fn has_velocity(&self) -> bool {
        self.last.is_some_and(|last| last.v_n.is_some())
    }

    /// The level of a false acceleration of positions [m/s²], which nobody flies if the samples have velocities.
    fn of_positions(&self, acceleration_m_s2: f64) -> Option<Level> {
        let level = level_of(acceleration_m_s2);
        if self.has_velocity() { level.map(|_| Level::Note) } else { level }
    }

    fn find_in_stamps(&self, found: &mut Findings) {
        let usual_s = self.stamps.usual_s();
        if self.late > 0 {
            let own = Finding::new(Kind::TimeOrder, Level::Unusable, self.late as f64);
            found.add(Finding { at: self.first_late, count: self.late, ..own });
        }
        if let Some((shortest_s, at)) = self.stamps.shortest {
            let level = if self.has_velocity() { Level::Doubtful } else { Level::Unusable };
            let own = Finding::new(Kind::NearStamps, level, shortest_s);
            found.add(Finding { at, count: self.stamps.near, ..own });
        }
        if self.stamps.gaps > 0 {
            let own = Finding::new(Kind::Gaps, Level::Note, self.stamps.longest.value);
            found.add(Finding { at: self.stamps.longest.at, count: self.stamps.gaps, ..own });
        }
        let step_m = self.resolution.horizontal_m();
        if let Some(jitter_s) = self.stamps.jitter_s(step_m) {
            let speed = self.positions.speed_m_s();
            let acceleration = 6f64.sqrt() * speed * jitter_s / (usual_s * usual_s);
            let level = self.of_positions(acceleration).unwrap_or(Level::Note);
            let own = Finding::new(Kind::StampJitter, level, jitter_s);
            found.add(Finding { acceleration_m_s2: self.flown(acceleration), ..own });
        }
        let duration_s = self.last.map_or(0.0, |last| last.time_s) - self.first_s;
        let (extent_m, mean) = (self.positions.extent_m(), self.positions.extent_m() / duration_s);
        if extent_m > 100.0 && mean < 0.3 && usual_s >= 5.0 {
            found.add(Finding::new(Kind::TimeUnit, Level::Unusable, mean));
        }
    }

    /// A false acceleration of positions, if it is flown.
    fn flown(&self, acceleration_m_s2: f64) -> f64 {
        if self.has_velocity() { 0.0 } else { acceleration_m_s2 }
    }

    fn find_in_positions(&self, found: &mut Findings) {
        let usual_s = self.stamps.usual_s();
        let per_metre = 6f64.sqrt() / (usual_s * usual_s);
        let steps_m = self.resolution.steps_m;
        let (mut coarse, mut noisy) = ((0.0, 0.0), 0.0_f64);
        for (axis, &step_m) in steps_m.iter().enumerate() {
            let rounding_m = self.noise.rounding(axis, step_m);
            if rounding_m > coarse.0 {
                coarse = (rounding_m, step_m);
            }
            // Rounding looks like noise: of a steady motion, up to half of the step.
            let sigma_m = self.noise.sigma(axis);
            if rounding_m == 0.0 || sigma_m > step_m {
                noisy = noisy.max(sigma_m);
            }
        }
        // Held rows, and wrong stamps, look like noise.
        let is_explained =
            self.find_held(found) || self.stamps.jitter_s(self.resolution.horizontal_m()).is_some();
        let clue = if self.resolution.is_float32 { Clue::Float32 } else { Clue::None };
        if let Some(level) = self.of_positions(per_metre * coarse.0).filter(|_| !is_explained) {
            let own = Finding::new(Kind::CoarsePositions, level, coarse.1);
            found.add(Finding { acceleration_m_s2: self.flown(per_metre * coarse.0), clue, ..own });
        }
        if let Some(level) = self.of_positions(per_metre * noisy).filter(|_| !is_explained) {
            // Stamps of whole seconds make less.
            let is_gross = noisy > GROSS_M.max(GROSS * self.positions.speed_m_s() * usual_s);
            let clue =
                if is_gross { Clue::Known("the rows are those of several vehicles") } else { Clue::None };
            let own = Finding::new(Kind::NoisyPositions, level, noisy);
            found.add(Finding { acceleration_m_s2: self.flown(per_metre * noisy), clue, ..own });
        }
        let step_m = self.resolution.horizontal_m() + steps_m[2];
        let spikes = self.positions.spikes(usual_s, step_m);
        let unfixed = self.positions.unfixed();
        if unfixed > 0 {
            let own = Finding::new(Kind::NotYetFixed, Level::Unusable, unfixed as f64);
            found.add(Finding { count: unfixed, ..own });
        } else if spikes > 0 {
            let farthest = self.positions.farthest;
            let acceleration = 2.0 * farthest.value / (usual_s * usual_s);
            let level = self.of_positions(acceleration).unwrap_or(Level::Note);
            let own = Finding::new(Kind::Spike, level, farthest.value);
            let acceleration_m_s2 = self.flown(acceleration);
            found.add(Finding { at: farthest.at, count: spikes, acceleration_m_s2, ..own });
        }
        if let Some((at, height_m)) = self.above_air.found {
            found.add(Finding { at, ..Finding::new(Kind::HeightAboveAir, Level::Doubtful, height_m) });
        }
        self.find_acceleration(found);
    }

    /// Finds accelerations, if no other finding explains them.
    fn find_acceleration(&self, found: &mut Findings) {
        let explains = |finding: &Finding| {
            finding.kind == Kind::NotYetFixed
                || finding.acceleration_m_s2 > 0.0 && finding.level == Level::Unusable
                || finding.kind == Kind::NearStamps
        };
        if found.list.iter().flatten().any(explains) {
            return;
        }
        let (jump, flown) = (self.positions.acceleration, self.positions.flown);
        let limit = self.max_acceleration_m_s2;
        let (level, largest, clue) = if flown.value > limit {
            (Level::Unusable, flown, Clue::Limit(limit))
        } else {
            // With velocities a jump of the positions is not flown, and theirs is.
            let largest = if self.has_velocity() { flown } else { jump };
            if largest.value < MANOEUVRE_M_S2 {
                return;
            }
            // A smooth path touches no ground.
            let level = if self.is_path || largest.value > JOLT_M_S2 { Level::Doubtful } else { Level::Note };
            (level, largest, Clue::None)
        };
        let own = Finding::new(Kind::Acceleration, level, largest.value);
        found.add(Finding { at: largest.at, count: 1, clue, ..own });
    }

    fn is_held(&self) -> bool {
        let (moving, held) = (self.positions.moving, self.positions.held);
        held > 1 && held as f64 > HELD_SHARE * moving as f64
    }

    /// Finds held rows; whether there are any.
    fn find_held(&self, found: &mut Findings) -> bool {
        let (moving, held) = (self.positions.moving, self.positions.held);
        if !self.is_held() {
            return false;
        }
        let share = held as f64 / moving as f64;
        let usual_s = self.stamps.usual_s();
        // A held row is a step of the distance of a row or more, and back.
        let acceleration = 2.0 * self.positions.speed_m_s() / usual_s;
        let level = self.of_positions(acceleration).unwrap_or(Level::Note);
        let own = Finding::new(Kind::HeldRows, level, share);
        let at = self.positions.first_held.unwrap_or_default();
        let acceleration_m_s2 = self.flown(acceleration);
        found.add(Finding { at, count: held, acceleration_m_s2, ..own });
        true
    }

    /// Time that blocks need, so that noise is 3 % of their displacement [s].
    fn block_s(&self) -> f64 {
        let noise_m = self.noise.recent().max(self.noise.recent_up()) + self.resolution.horizontal_m();
        (30.0 * noise_m / self.positions.speed_m_s().max(0.1)).max(self.stamps.usual_s()).max(2.0)
    }

    fn find_in_velocities(&self, found: &mut Findings) {
        if !self.has_velocity() {
            return;
        }
        let usual_s = self.stamps.usual_s();
        let sigma = (0..3).map(|axis| self.velocity_noise.sigma(axis)).fold(0.0, f64::max);
        let acceleration_m_s2 = 2f64.sqrt() * sigma / usual_s;
        if let Some(level) = level_of(acceleration_m_s2) {
            found.add(Finding { acceleration_m_s2, ..Finding::new(Kind::NoisyVelocities, level, sigma) });
        }
        let ins_error_m = self.effect.largest_m;
        let enough = |level: &BlockLevel| level.velocities.is_enough();
        let velocities = self.blocks.level(self.block_s(), enough).map(|level| &level.velocities);
        let wrong = velocities.and_then(|velocities| velocities.wrong());
        let vertical = velocities.and_then(|velocities| velocities.vertical());
        let any = self.blocks.level(0.0, |_| true).map(|level| &level.velocities);
        let outlier = any.and_then(|velocities| velocities.outlier());
        // Positions that are held are late themselves.
        let delay_s = self.lateness.delay_s(usual_s).filter(|_| !self.is_held());
        match (wrong, vertical, delay_s) {
            // The signed exchanges include the vertical, if it has the unit of the others.
            (Some(Wrong { ratio, clue, is_up_apart, .. }), ..) if clue != Clue::None => {
                let own = Finding::new(Kind::VelocityUnit, Level::Unusable, ratio);
                found.add(Finding { ins_error_m, clue, ..own });
                if let Some((slope, clue)) = vertical.filter(|_| is_up_apart) {
                    found.add(Finding { clue, ..Finding::new(Kind::VerticalUnit, Level::Unusable, slope) });
                }
            }
            (wrong, Some((slope, clue)), _) => {
                let level = if clue == Clue::None { Level::Doubtful } else { Level::Unusable };
                let horizontal = wrong.filter(|wrong| !wrong.is_up_alone);
                // The error is that of the larger fault.
                let of_up_m = if horizontal.is_some() { 0.0 } else { ins_error_m };
                if let Some(Wrong { share, .. }) = horizontal {
                    found.add(contradicts(share, ins_error_m));
                }
                let own = Finding::new(Kind::VerticalUnit, level, slope);
                found.add(Finding { clue, ins_error_m: of_up_m, ..own });
            }
            (_, None, Some(delay_s)) => {
                let is_doubtful = ins_error_m > LATE_ERROR_M;
                let level = if is_doubtful { Level::Doubtful } else { Level::Note };
                let own = Finding::new(Kind::VelocityLate, level, delay_s);
                found.add(Finding { ins_error_m, ..own });
            }
            (Some(Wrong { share, .. }), None, None) => found.add(contradicts(share, ins_error_m)),
            (None, None, None) => {
                if let Some((apart_m, at, count)) = outlier {
                    let own = Finding::new(Kind::VelocityAtTimes, Level::Doubtful, apart_m);
                    found.add(Finding { at, count, ins_error_m, ..own });
                }
            }
        }
    }

    /// Finds white noise of the attitude, or that of its steps. Ideal gyros sense it, and the steps of an INS do not commute: its attitude
    /// walks at random.
    fn find_attitude_noise(&self, found: &mut Findings) {
        let duration_s = self.last.map_or(0.0, |last| last.time_s) - self.first_s;
        let (rows, length_s) = (duration_s / self.stamps.usual_s(), duration_s.min(LONGEST_S));
        let ins_error_m = |[roll, pitch, heading]: [f64; 3]| {
            let drift = CONING * heading * hypot(roll, pitch) * rows.sqrt();
            // The deviation of the second integral of a random walk is its last value times t²/√20.
            G * drift * length_s * length_s / 20f64.sqrt()
        };
        // Gusts are white to rows that are rare.
        let is_often = self.stamps.usual_s() <= OFTEN_S;
        let white =
            [0, 1, 2].map(|axis| if is_often { self.attitude_noise.sigma_above(axis, WHITE) } else { 0.0 });
        let steps = self.angle_steps.steps_rad();
        let stairs = [0, 1, 2].map(|axis| white[axis].max(self.attitude_noise.of_stairs(axis, steps[axis])));
        let of = |kind, sigmas, figures: [f64; 3]| {
            (kind, ins_error_m(sigmas), figures.into_iter().fold(0.0, f64::max))
        };
        let noise = of(Kind::NoisyAttitude, white, white);
        let coarse = of(Kind::CoarseAttitude, stairs, steps);
        let (kind, ins_error_m, figure) = if coarse.1 > 2.0 * noise.1 { coarse } else { noise };
        if ins_error_m > 0.1 * NOISE_ERROR_M {
            let level = if ins_error_m > NOISE_ERROR_M { Level::Doubtful } else { Level::Note };
            found.add(Finding { ins_error_m, ..Finding::new(kind, level, figure) });
        }
    }

    fn find_in_attitudes(&self, found: &mut Findings) {
        self.find_attitude_noise(found);
        for (wrap, name) in self.wraps.iter().zip(["heading", "roll"]) {
            if wrap.count > 0 {
                let own = Finding::new(Kind::AngleThroughWrap, Level::Doubtful, wrap.fastest.value);
                found.add(Finding { at: wrap.fastest.at, count: wrap.count, clue: Clue::Known(name), ..own });
            }
        }
        if self.zeros.count > 0 {
            let own = Finding::new(Kind::AttitudeHeld, Level::Doubtful, self.zeros.farthest.value);
            let (at, count) = (self.zeros.farthest.at, self.zeros.count);
            found.add(Finding { at, count, clue: Clue::Known(ZERO), ..own });
        }
        let enough = |level: &BlockLevel| level.attitudes.is_enough();
        let Some(attitudes) = self.blocks.level(self.block_s(), enough).map(|level| &level.attitudes) else {
            return;
        };
        if let Some((follows, clue)) = attitudes.heading_unit() {
            found.add(Finding { clue, ..Finding::new(Kind::HeadingUnit, Level::Unusable, follows) });
        } else if let Some(follows) = attitudes.straight.mirrored() {
            let own = Finding::new(Kind::HeadingUnit, Level::Unusable, follows);
            found.add(Finding { clue: Clue::Known(MIRRORED), ..own });
        } else if let Some((angle, level)) = attitudes.heading_offset() {
            found.add(Finding::new(Kind::HeadingOffTrack, level, angle));
        }
        if let Some((angle, name)) = attitudes.straight.off() {
            let own = Finding::new(Kind::AttitudeTurned, Level::Doubtful, angle);
            found.add(Finding { clue: Clue::Known(name), ..own });
        }
        if self.zeros.count == 0 {
            find_held_or_late(attitudes, found);
        }
        match attitudes.roll() {
            Some((slope, clue @ Clue::Known(_))) => {
                found.add(Finding { clue, ..Finding::new(Kind::RollSign, Level::Unusable, slope) });
            }
            other => {
                if let Some(slope) = attitudes.rolls_otherwise() {
                    let clue = Clue::Known("roll, time or position is in another unit");
                    found
                        .add(Finding { clue, ..Finding::new(Kind::RollUnexplained, Level::Doubtful, slope) });
                } else if let Some((slope, _)) = other {
                    found.add(Finding::new(Kind::RollUnexplained, Level::Note, slope));
                }
            }
        }
        match attitudes.pitch() {
            // With velocities the climb itself shows its unit.
            Some((_, PitchFault::HeightInFeet)) if self.has_velocity() => {}
            Some((slope, PitchFault::HeightInFeet)) => {
                found.add(Finding::new(Kind::HeightUnit, Level::Doubtful, slope));
            }
            Some((slope, fault)) => {
                let clue = if fault == PitchFault::Radians { Clue::Known(RADIANS) } else { Clue::None };
                found.add(Finding { clue, ..Finding::new(Kind::PitchSign, Level::Unusable, slope) });
            }
            None => {
                if let Some(angle) = attitudes.negative_attack() {
                    found.add(Finding::new(Kind::AttackNegative, Level::Note, angle));
                }
            }
        }
    }
}

/// Angles that stay the same in a turn, or come late.
fn find_held_or_late(attitudes: &Attitudes, found: &mut Findings) {
    let of = |held: Option<(Held, u64)>, name: &'static str| held.map(|held| (held, name));
    let held = of(attitudes.held(), "attitude").or(of(attitudes.heading_held(), "heading"));
    if let Some(((held, count), name)) = held.or(of(attitudes.roll_held(), "roll")) {
        let own = Finding::new(Kind::AttitudeHeld, Level::Doubtful, held.turn);
        let clue = Clue::Known(name);
        found.add(Finding { at: held.begin, count, clue, ..own });
    } else if let Some(delay_s) = attitudes.roll_delay_s() {
        found.add(Finding::new(Kind::AttitudeLate, Level::Doubtful, delay_s));
    } else if let Some(delay_s) = attitudes.heading_delay_s() {
        let own = Finding::new(Kind::AttitudeLate, Level::Doubtful, delay_s);
        found.add(Finding { clue: Clue::Known("heading"), ..own });
    }
}
