//! What was found, in the units of data sheets.

use sins::analysis::identify::{Estimate, Identified, NoiseEstimate, SensorNoise, TriadEstimate};
use sins::units::{ARCSEC, DEG_PER_HOUR, DEG_PER_SQRT_HOUR, PPM};

use crate::units::{MICRO_G, Unit};

pub const AXES: [&str; 3] = ["x", "y", "z"];

/// A parameter of one sensor.
pub struct Line {
    /// Key of a scene that has it.
    pub key: &'static str,
    pub name: String,
    pub unit: Unit,
    pub estimate: Estimate,
    /// A motion that shows it: more than the record has, as less noise would too.
    pub shown_by: String,
}

/// A coefficient of noise of one sensor.
pub struct NoiseLine {
    pub key: &'static str,
    pub name: String,
    pub unit: Unit,
    pub estimate: NoiseEstimate,
}

/// One triad: its section of a scene and its lines.
pub struct Sheet {
    pub section: &'static str,
    pub sensor: &'static str,
    pub lines: Vec<Line>,
    pub noises: Vec<NoiseLine>,
}

const fn unit(name: &'static str, si: f64) -> Unit {
    Unit { name, si }
}

/// Gyros and accelerometers.
pub fn sheets(found: &Identified) -> [Sheet; 2] {
    let hour = 60.0;
    let gyro = Sheet {
        section: "gyro",
        sensor: "gyro",
        lines: lines(&found.gyro, ("bias_deg_h", unit("°/h", DEG_PER_HOUR)), false),
        noises: noises(
            &found.noise[..3],
            [
                ("random_walk_deg_sqrt_h", unit("°/√h", DEG_PER_SQRT_HOUR)),
                ("flicker_deg_h", unit("°/h", DEG_PER_HOUR)),
                ("rate_random_walk_deg_h_sqrt_h", unit("°/h/√h", DEG_PER_HOUR / hour)),
            ],
        ),
    };
    let accel = Sheet {
        section: "accelerometer",
        sensor: "accelerometer",
        lines: lines(&found.accel, ("bias_micro_g", MICRO_G), true),
        noises: noises(
            &found.noise[3..],
            [
                ("random_walk_micro_g_sqrt_hz", unit("µg/√Hz", MICRO_G.si)),
                ("flicker_micro_g", MICRO_G),
                ("acceleration_random_walk_micro_g_sqrt_h", unit("µg/√h", MICRO_G.si / hour)),
            ],
        ),
    };
    [gyro, accel]
}

fn lines(triad: &TriadEstimate, (bias, bias_unit): (&'static str, Unit), is_force: bool) -> Vec<Line> {
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
        lines.push(Line { key: bias, name, unit: bias_unit, estimate, shown_by });
    }
    for (axis, letter) in AXES.into_iter().enumerate() {
        let (name, estimate) = (format!("scale factor {letter}"), triad.elements[axis][axis]);
        let unit = unit("ppm", PPM);
        lines.push(Line { key: "scale_factor_ppm", name, unit, estimate, shown_by: motion(axis) });
    }
    for (row, column) in (0..9).map(|k| (k / 3, k % 3)).filter(|(row, column)| row != column) {
        let name = format!("misalignment {}{}", AXES[row], AXES[column]);
        let (estimate, unit) = (triad.elements[row][column], unit("arcsec", ARCSEC));
        lines.push(Line { key: "misalignment_arcsec", name, unit, estimate, shown_by: motion(column) });
    }
    lines
}

fn noises(of: &[SensorNoise], keys: [(&'static str, Unit); 3]) -> Vec<NoiseLine> {
    let kinds = [
        ("white noise", (|noise| noise.random_walk) as fn(&SensorNoise) -> NoiseEstimate),
        ("flicker", |noise| noise.flicker),
        ("random walk", |noise| noise.rate_random_walk),
    ];
    let all = kinds.into_iter().zip(keys).flat_map(|((name, part), (key, unit))| {
        of.iter().zip(AXES).map(move |(noise, axis)| NoiseLine {
            key,
            name: format!("{name} {axis}"),
            unit,
            estimate: part(noise),
        })
    });
    all.collect()
}
