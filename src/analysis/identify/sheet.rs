//! What was found, in the units of data sheets.

use super::{Estimate, Identified, NoiseEstimate, SensorNoise, TriadEstimate};
use crate::base::figures::{MICRO_G, Unit};
use crate::base::units::{ARCSEC, DEG_PER_HOUR, DEG_PER_SQRT_HOUR, PPM, STANDARD_GRAVITY};

/// Names of the axes.
pub const AXES: [&str; 3] = ["x", "y", "z"];

/// A parameter of one sensor.
pub struct Line {
    /// Key of a scene that has it, in the section of the triad; empty: in another one.
    pub key: &'static str,
    /// "bias x".
    pub name: String,
    /// Its unit in data sheets and scenes.
    pub unit: Unit,
    /// Its SI unit.
    pub si: &'static str,
    /// What was found [SI unit].
    pub estimate: Estimate,
    /// A motion that shows it: more than the record has, as less noise would too.
    pub shown_by: String,
}

/// A coefficient of noise of one sensor.
pub struct NoiseLine {
    /// Key of a scene that has it.
    pub key: &'static str,
    /// "white noise x".
    pub name: String,
    /// Its unit in data sheets and scenes.
    pub unit: Unit,
    /// Its SI unit.
    pub si: &'static str,
    /// What was found [SI unit].
    pub estimate: NoiseEstimate,
}

/// One triad: its section of a scene and its lines.
pub struct Sheet {
    /// Section of a scene that has it.
    pub section: &'static str,
    /// Parameters that each fit has.
    pub lines: Vec<Line>,
    /// Those of [`super::Also`], whether they are asked for or not.
    pub also: Vec<Line>,
    /// Coefficients of the noise.
    pub noises: Vec<NoiseLine>,
    /// Temperature at which the biases hold [°C], if their changes with it are asked for.
    pub reference_c: Option<f64>,
}

impl Sheet {
    /// The parameters of the fit.
    pub fn fitted(&self) -> impl Iterator<Item = &Line> {
        self.lines.iter().chain(self.also.iter().filter(|line| line.estimate.prior > 0.0))
    }
}

const fn unit(name: &'static str, si: f64) -> Unit {
    Unit { name, si }
}

/// Gyros and accelerometers.
pub fn sheets(found: &Identified) -> [Sheet; 2] {
    let hour = 60.0;
    let gyro = Sheet {
        section: "gyro",
        lines: lines(&found.gyro, ("bias_deg_h", unit("°/h", DEG_PER_HOUR), "rad/s"), false),
        also: g_sensitivities(found)
            .chain(asymmetries(&found.gyro, "turns about"))
            .chain(warmings(
                &found.gyro,
                ("bias_temperature_deg_h_per_k", unit("°/h/K", DEG_PER_HOUR), "(rad/s)/K"),
            ))
            .collect(),
        reference_c: found.reference_c,
        noises: noises(
            &found.noise[..3],
            [
                ("random_walk_deg_sqrt_h", unit("°/√h", DEG_PER_SQRT_HOUR), "rad/sqrt(s)"),
                ("flicker_deg_h", unit("°/h", DEG_PER_HOUR), "rad/s"),
                ("rate_random_walk_deg_h_sqrt_h", unit("°/h/√h", DEG_PER_HOUR / hour), "(rad/s)/sqrt(s)"),
            ],
        ),
    };
    let accel = Sheet {
        section: "accelerometer",
        lines: lines(&found.accel, ("bias_micro_g", MICRO_G, "m/s2"), true),
        also: lever_arms(found)
            .chain(asymmetries(&found.accel, "forces along"))
            .chain(warmings(
                &found.accel,
                ("bias_temperature_micro_g_per_k", unit("µg/K", MICRO_G.si), "(m/s2)/K"),
            ))
            .collect(),
        reference_c: found.reference_c,
        noises: noises(
            &found.noise[3..],
            [
                ("random_walk_micro_g_sqrt_hz", unit("µg/√Hz", MICRO_G.si), "(m/s)/sqrt(s)"),
                ("flicker_micro_g", MICRO_G, "m/s2"),
                (
                    "acceleration_random_walk_micro_g_sqrt_h",
                    unit("µg/√h", MICRO_G.si / hour),
                    "(m/s2)/sqrt(s)",
                ),
            ],
        ),
    };
    [gyro, accel]
}

/// Key of a scene, its unit, and the SI unit.
type Key = (&'static str, Unit, &'static str);

fn lines(triad: &TriadEstimate, (bias, bias_unit, bias_si): Key, is_force: bool) -> Vec<Line> {
    let mut lines = Vec::new();
    let motion = |axis: usize| {
        let axis = AXES[axis];
        match is_force {
            true => format!(
                "more tilts by 20° that bring gravity along {axis} and off it, or accelerations along {axis}"
            ),
            false => format!("more turns about {axis} in both directions"),
        }
    };
    for (axis, letter) in AXES.into_iter().enumerate() {
        let shown_by = match is_force {
            true => format!("more turns that point {letter} elsewhere"),
            false => "a longer record".to_owned(),
        };
        let (name, estimate) = (format!("bias {letter}"), triad.bias[axis]);
        lines.push(Line { key: bias, name, unit: bias_unit, si: bias_si, estimate, shown_by });
    }
    for (axis, letter) in AXES.into_iter().enumerate() {
        let (name, estimate) = (format!("scale factor {letter}"), triad.elements[axis][axis]);
        let unit = unit("ppm", PPM);
        lines.push(Line { key: "scale_factor_ppm", name, unit, si: "1", estimate, shown_by: motion(axis) });
    }
    for (row, column) in (0..9).map(|k| (k / 3, k % 3)).filter(|(row, column)| row != column) {
        let name = format!("misalignment {}{}", AXES[row], AXES[column]);
        let (estimate, unit) = (triad.elements[row][column], unit("arcsec", ARCSEC));
        let (key, shown_by) = ("misalignment_arcsec", motion(column));
        lines.push(Line { key, name, unit, si: "rad", estimate, shown_by });
    }
    lines
}

fn g_sensitivities(found: &Identified) -> impl Iterator<Item = Line> {
    (0..9).map(|k| (k / 3, k % 3)).map(|(row, column)| Line {
        key: "g_sensitivity_deg_h_per_g",
        name: format!("g-sensitivity {}{}", AXES[row], AXES[column]),
        unit: unit("°/h/g", DEG_PER_HOUR / STANDARD_GRAVITY),
        si: "(rad/s)/(m/s2)",
        estimate: found.g_sensitivity[row][column],
        shown_by: format!("more tilts that bring gravity along {} and off it", AXES[column]),
    })
}

fn asymmetries(triad: &TriadEstimate, motion: &'static str) -> impl Iterator<Item = Line> {
    triad.asymmetry.into_iter().zip(AXES).map(move |(estimate, axis)| Line {
        key: "scale_factor_asymmetry_ppm",
        name: format!("asymmetry {axis}"),
        unit: unit("ppm", PPM),
        si: "1",
        estimate,
        shown_by: format!("more {motion} {axis} in both directions"),
    })
}

fn warmings(triad: &TriadEstimate, (key, unit, si): Key) -> impl Iterator<Item = Line> {
    triad.bias_temperature.into_iter().zip(AXES).map(move |(estimate, axis)| Line {
        key,
        name: format!("bias/temperature {axis}"),
        unit,
        si,
        estimate,
        shown_by: "a larger change of the temperature".to_owned(),
    })
}

/// Their key is one of another section.
fn lever_arms(found: &Identified) -> impl Iterator<Item = Line> {
    found.lever_arm.into_iter().zip(AXES).map(|(estimate, axis)| Line {
        key: "",
        name: format!("lever arm {axis}"),
        unit: unit("m", 1.0),
        si: "m",
        estimate,
        shown_by: format!("more turns about other axes than {axis}"),
    })
}

fn noises(of: &[SensorNoise], keys: [Key; 3]) -> Vec<NoiseLine> {
    let kinds = [
        ("white noise", (|noise| noise.random_walk) as fn(&SensorNoise) -> NoiseEstimate),
        ("flicker", |noise| noise.flicker),
        ("random walk", |noise| noise.rate_random_walk),
    ];
    let all = kinds.into_iter().zip(keys).flat_map(|((name, part), (key, unit, si))| {
        of.iter().zip(AXES).map(move |(noise, axis)| NoiseLine {
            key,
            name: format!("{name} {axis}"),
            unit,
            si,
            estimate: part(noise),
        })
    });
    all.collect()
}
