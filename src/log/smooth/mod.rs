//! Makes a path that an INS can fly from the rows of a log: noise, coarse steps, repeats, outliers and stamps that scatter are smoothed.
//!
//! The horizontal position is the unit normal of the ellipsoid, three numbers that are regular at the poles and at the date line; the
//! attitude is the quaternion, which is regular at the zenith. Each is a quintic spline (`spline`) whose cut-off follows from the spectrum
//! of the rows (`spectrum`), with weights against outliers (`fit`). The velocity is the exact derivative of the position, so that
//! nothing contradicts. All functions give the same bits on every platform.

mod coordinated;
mod fit;
mod fresh;
mod jumps;
mod rows;
mod simplex;
mod spectrum;
mod spline;

use core::f64::consts::{FRAC_1_SQRT_2, PI};

use nalgebra::{Quaternion, Vector3};

use crate::base::error::{Error, ErrorKind, Rule, check_range};
use crate::base::math::{Euler, atan2, attitude_from_euler, euler_from_attitude, exp, hypot, ln, sin_cos};
use crate::base::memory::room;
use crate::earth::{Earth, Geodetic};
use crate::judge::Finding;
use crate::truth::FlightSample;
use fit::{Curve, Samples};
use jumps::Corrections;
use rows::Rows;

/// Acceleration that the steps of the heights may leave [m/s²].
const STEP_NOISE_M_S2: f64 = 1.0;

/// Largest number of steps of a path: this one, and more for each row.
const MOST_STEPS: usize = 5_000_000;
const STEPS_OF_ROW: usize = 10;

/// Rejects a path over `span_s` [s] in steps of `step_s` [s] that has many more steps than rows. Rows in bursts, with gaps between
/// them, would take any memory.
fn check_steps(span_s: f64, step_s: f64, rows: usize) -> Result<(), Error> {
    let most = MOST_STEPS.saturating_add(STEPS_OF_ROW.saturating_mul(rows)) as f64;
    if span_s / step_s <= most {
        return Ok(());
    }
    let rule = Rule::AtLeast(
        "is too short for the span of the rows; at least a share of it,",
        (span_s / most).into(),
    );
    Err(Error::invalid("usual_interval_s", step_s, rule))
}

/// Cut-off over the rate of the rows below which noise was smoothed; length of an end without support, in 1/f_c. Of it, at most a share of
/// a long flight is cut, or some seconds, of a short flight a larger share.
const SMOOTHED: f64 = 0.25;
const END: f64 = 0.5;
const MOST_OF_LONG: f64 = 0.01;
const MOST_S: f64 = 3.0;
const MOST_OF_SHORT: f64 = 0.1;

/// Largest cut-off of the path of a filter, in rates of its corrections: of what alternates from one to the next, at half that rate, it
/// leaves a tenth.
const CORRECTED: f64 = 0.35;

/// Share of the rows on which the heights of a filter are new: rounding repeats some.
const LIVE: f64 = 0.99;

/// What an assumed attitude costs: CEP50 and R95 of an INS on the path differ from those on the flight by at most these shares, in nine of
/// ten cases, for aeroplanes, and for gliders that circle and ships; and by at most this factor for what stops or hovers.
/// Evidence: `analysis::smooth_assumed`, and the table of `docs/your_log.md`.
pub const ASSUMED_ATTITUDE_COSTS: [f64; 3] = [0.1, 0.3, 3.0];

/// How rows become a path.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct SmoothOptions {
    /// White noise of a horizontal component of the position [m]; `None`: it is found from the rows.
    pub position_sigma_m: Option<f64>,
    /// White noise of an angle of the attitude [rad]; `None`: it is found from the rows.
    pub attitude_sigma_rad: Option<f64>,
    /// Angle of attack of a coordinated flight [rad], whose attitude follows from the path; `None`: the attitude is that of the rows.
    pub coordinated_attack_rad: Option<f64>,
}

/// What was found of a part of the path.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SmoothedPart {
    /// Motion above this frequency is lost [Hz].
    pub cutoff_hz: f64,
    /// Noise of a component [m or rad].
    pub noise: f64,
    /// Rows without weight: outliers.
    pub outliers: u64,
    /// Largest residual of the rows with weight [m or rad].
    pub largest: f64,
    /// Its time stamp [s].
    pub largest_at_s: f64,
}

/// A smooth path.
#[derive(Debug, Clone)]
pub struct Smoothed {
    earth: Earth,
    normals: Curve<3>,
    heights: Curve<1>,
    attitudes: Curve<4>,
    /// Times [s] and temperatures [°C] of the rows.
    temperatures: Vec<(f64, f64)>,
    span_s: [f64; 2],
    /// Time that is cut from the start of the rows: an INS is aligned there, and the path is not supported on both sides [s].
    pub cut_s: f64,
    /// Number of jumps that were taken out, and usual time between two of them [s], if the rows are the path of a filter that is corrected.
    pub corrections: Option<(u64, f64)>,
    /// Rows whose position was left out: from before the first fix, repeats, and rows too near to the row before.
    pub left_out: u64,
    /// Whether the stamps were replaced by those of a steady clock.
    pub is_steady_clock: bool,
    /// What was found in the rows.
    pub findings: Vec<Finding>,
    /// Whether the attitude was assumed, see [`SmoothOptions::coordinated_attack_rad`].
    pub is_coordinated: bool,
}

impl Smoothed {
    /// A path through `samples`. Their velocities, rates and forces are not used: those of the path follow from its derivatives.
    pub fn new(earth: &Earth, samples: &[FlightSample], options: &SmoothOptions) -> Result<Self, Error> {
        for (field, sigma) in [
            ("position_sigma_m", options.position_sigma_m),
            ("attitude_sigma_rad", options.attitude_sigma_rad),
        ] {
            sigma.map_or(Ok(()), |sigma| check_range(field, sigma, 1e-9, 1e4))?;
        }
        let rows = rows::rows(earth, samples, options.coordinated_attack_rad.is_none())?;
        let Rows { samples, times_s, .. } = &rows;
        let middle = samples[samples.len() / 2].place;
        let scale_m = earth.radii(sin_cos(middle.latitude_rad).0).transverse_m;
        let mut places = room(samples.len())?;
        places.extend(samples.iter().map(|sample| {
            let up = earth.east_north_up(&sample.place).2 * scale_m;
            [up.x, up.y, up.z, sample.place.height_m]
        }));
        let [horizontal_m, up_m] = rows.steps_m;
        // A filter has a place of its own in each row.
        let is_live = rows.places.len() == samples.len();
        let step_m = horizontal_m.max(up_m);
        let corrections = if is_live { jumps::without_jumps(times_s, &places, step_m)? } else { None };
        // Horizontal positions of few digits hide their jumps, and not those of the heights.
        let has_heights = rows.heights.len() as f64 >= LIVE * samples.len() as f64;
        let of_heights = match &corrections {
            None if has_heights => jumps::without_jumps_of_heights(times_s, &places, up_m)?,
            _ => None,
        };
        let said = |found: &Corrections| (found.count, found.interval_s);
        let capped_hz = |found: &Option<Corrections>| {
            found.as_ref().map_or(f64::INFINITY, |found| CORRECTED / found.interval_s)
        };
        let corrected_hz = capped_hz(&corrections);
        let heights_hz = corrected_hz.min(capped_hz(&of_heights));
        let is_corrected = corrections.as_ref().or(of_heights.as_ref()).map(said);
        if let Some(found) = corrections {
            places = found.places;
        }
        if let Some(found) = of_heights {
            places.iter_mut().zip(&found.places).for_each(|(place, found)| place[3] = found[3]);
        }
        let placed_s = times_of(times_s, &rows.places)?;
        let mut normals = room(placed_s.len())?;
        normals.extend(rows.places.iter().map(|&row| {
            let [x, y, z, _] = places[row];
            [x, y, z]
        }));
        // A normal has two horizontal components in three numbers.
        let sigma = options.position_sigma_m.map(|sigma| sigma * (2.0_f64 / 3.0).sqrt());
        let step = horizontal_m * (2.0_f64 / 3.0).sqrt();
        let normals = Curve::through(&Samples {
            times_s: &placed_s,
            values: &normals,
            sigma,
            cap_hz: corrected_hz,
            step,
        })?;
        let climbed_s = times_of(times_s, &rows.heights)?;
        let mut heights = room(climbed_s.len())?;
        heights.extend(rows.heights.iter().map(|&row| [places[row][3]]));
        let period_s = fit::median(climbed_s.windows(2).map(|two| two[1] - two[0]))?;
        let cap_hz = step_cutoff_hz(up_m, period_s).min(heights_hz);
        let heights = Curve::through(&Samples {
            times_s: &climbed_s,
            values: &heights,
            sigma: None,
            cap_hz,
            step: up_m,
        })?;
        let turned_s = times_of(times_s, &rows.attitudes)?;
        let quaternions = match options.coordinated_attack_rad {
            Some(_) => Vec::new(),
            None => {
                let mut eulers = room(turned_s.len())?;
                eulers.extend(rows.attitudes.iter().map(|&row| samples[row].euler));
                quaternions(&turned_s, &eulers)?
            }
        };
        let mut temperatures = room(samples.len())?;
        temperatures.extend(
            times_s.iter().zip(samples).filter_map(|(time_s, sample)| Some((*time_s, sample.temperature_c?))),
        );
        let mut span_s = [times_s[0], times_s[times_s.len() - 1]];
        for own_s in [&placed_s, &climbed_s, &turned_s] {
            span_s = [span_s[0].max(own_s[0]), span_s[1].min(own_s[own_s.len() - 1])];
        }
        let ends_s = span_s;
        let is_coordinated = options.coordinated_attack_rad.is_some();
        let path_s = supported_s(ends_s, normals.cutoff_hz, &placed_s, is_coordinated);
        let path = coordinated::Path { earth, normals: &normals, heights: &heights };
        let attitudes = match options.coordinated_attack_rad {
            Some(attack_rad) => {
                let cutoff_hz = normals.cutoff_hz.min(coordinated::CUTOFF_HZ);
                span_s[0] = supported_s(ends_s, cutoff_hz, &placed_s, true);
                coordinated::attitudes(&path, ends_s, path_s, samples.len(), attack_rad)?
            }
            None => {
                span_s[0] = path_s;
                // A quaternion has half of the angle in four numbers.
                let sigma = options.attitude_sigma_rad.map(|sigma| sigma * (0.75_f64 / 4.0).sqrt());
                let cap_hz = f64::INFINITY;
                Curve::through(&Samples {
                    times_s: &turned_s,
                    values: &quaternions,
                    sigma,
                    cap_hz,
                    step: 0.0,
                })?
            }
        };
        Ok(Self {
            earth: *earth,
            normals,
            heights,
            attitudes,
            temperatures,
            span_s,
            cut_s: span_s[0] - ends_s[0],
            corrections: is_corrected,
            left_out: rows.left_out,
            is_steady_clock: rows.is_steady_clock,
            findings: rows.findings,
            is_coordinated,
        })
    }

    /// Time stamps of the start and of the end [s].
    pub fn span_s(&self) -> [f64; 2] {
        self.span_s
    }

    /// The sample at a time stamp from the start to the end [s], with the velocity.
    pub fn sample_at(&self, time_s: f64) -> Result<FlightSample, Error> {
        check_range("time_s", time_s, self.span_s[0], self.span_s[1])?;
        let path = coordinated::Path { earth: &self.earth, normals: &self.normals, heights: &self.heights };
        let (place, v_n) = path.at(time_s);
        let [w, x, y, z] = self.attitudes.at(time_s, 0);
        let euler = euler_from_attitude(&Quaternion::new(w, x, y, z).normalize());
        let temperature_c = self.temperature_at(time_s);
        Ok(FlightSample { time_s, place, v_n: Some(v_n), euler, omega_ib_b: None, f_b: None, temperature_c })
    }

    /// What was found of the horizontal position [m].
    pub fn position(&self) -> SmoothedPart {
        part(&self.normals, (3.0_f64 / 2.0).sqrt())
    }

    /// What was found of the height [m].
    pub fn height(&self) -> SmoothedPart {
        part(&self.heights, 1.0)
    }

    /// What was found of the attitude [rad].
    pub fn attitude(&self) -> SmoothedPart {
        part(&self.attitudes, (4.0_f64 / 0.75).sqrt())
    }

    /// Temperature, linear between the rows [°C].
    fn temperature_at(&self, time_s: f64) -> Option<f64> {
        let list = &self.temperatures;
        let behind = list.partition_point(|(at_s, _)| *at_s < time_s).min(list.len().checked_sub(1)?);
        let before = behind.saturating_sub(1);
        let ((t0, c0), (t1, c1)) = (list[before], list[behind]);
        let share = if t1 > t0 { ((time_s - t0) / (t1 - t0)).clamp(0.0, 1.0) } else { 0.0 };
        Some(c0 + share * (c1 - c0))
    }
}

/// The first of the times of rows from which a curve through them is supported on both sides: one that is much smoother than its rows
/// extrapolates at its ends, with several times the errors. The second derivative is wrong at the ends of any curve.
fn supported_s(span_s: [f64; 2], cutoff_hz: f64, times_s: &[f64], of_second: bool) -> f64 {
    let length_s = span_s[1] - span_s[0];
    let period_s = length_s / (times_s.len() - 1) as f64;
    if cutoff_hz * period_s >= SMOOTHED && !of_second {
        return span_s[0];
    }
    // A flight that is cut is shorter, and so are the errors that grow in it.
    let most_s = (MOST_OF_LONG * length_s).max(MOST_S).min(MOST_OF_SHORT * length_s);
    let cut_s = span_s[0] + (END / cutoff_hz).min(most_s);
    // The steps of the path stay those of the rows.
    times_s.iter().copied().find(|time_s| *time_s >= cut_s).unwrap_or(span_s[0])
}

/// The times of some rows.
fn times_of(times_s: &[f64], rows: &[usize]) -> Result<Vec<f64>, Error> {
    let mut list = room(rows.len())?;
    list.extend(rows.iter().map(|&row| times_s[row]));
    Ok(list)
}

fn part<const N: usize>(curve: &Curve<N>, scale: f64) -> SmoothedPart {
    let (largest, largest_at_s) = curve.largest;
    SmoothedPart {
        cutoff_hz: curve.cutoff_hz,
        noise: curve.noise * scale,
        outliers: curve.outliers,
        largest: largest * scale,
        largest_at_s,
    }
}

/// The cut-off at which steps of `step_m` [m] leave the acceleration [`STEP_NOISE_M_S2`]: σ (2π)² f^2.5 √(π T/9), σ = step/√12. A staircase
/// has the spectrum of motion.
fn step_cutoff_hz(step_m: f64, period_s: f64) -> f64 {
    if step_m == 0.0 {
        return f64::INFINITY;
    }
    let noise = step_m / 12f64.sqrt() * 4.0 * PI * PI * (PI / 9.0 * period_s).sqrt();
    exp(0.4 * ln(STEP_NOISE_M_S2 / noise))
}

/// Attitudes as quaternions of continuous sign. Rows that turn by more than 90° each do not define the motion.
fn quaternions(times_s: &[f64], attitudes: &[Euler]) -> Result<Vec<[f64; 4]>, Error> {
    let mut list: Vec<[f64; 4]> = room(attitudes.len())?;
    for (time_s, euler) in times_s.iter().zip(attitudes) {
        let q = attitude_from_euler(euler);
        let mut numbers = [q.w, q.i, q.j, q.k];
        if let Some(last) = list.last() {
            let cosine: f64 = last.iter().zip(&numbers).map(|(a, b)| a * b).sum();
            if cosine.abs() < FRAC_1_SQRT_2 {
                let rule = Rule::Sentence(
                    "time of a row that turns by more than 90 degrees: the rows are too rare for this attitude, or rows before it were left out",
                );
                return Err(Error::of(ErrorKind::Discontinuity, "sample.time_s", *time_s, rule));
            }
            if cosine < 0.0 {
                numbers = numbers.map(|number| -number);
            }
        }
        list.push(numbers);
    }
    Ok(list)
}

/// Geodetic position of a normal and a height, the normal of any length.
fn place_of(normal: &Vector3<f64>, height_m: f64) -> Geodetic {
    Geodetic {
        latitude_rad: atan2(normal.z, hypot(normal.x, normal.y)),
        longitude_rad: atan2(normal.y, normal.x),
        height_m,
    }
}

/// Euler angles as a quaternion's numbers.
fn numbers_of(euler: &Euler) -> [f64; 4] {
    let q = attitude_from_euler(euler);
    [q.w, q.i, q.j, q.k]
}
