//! The exact reference signals of `tests/data`: truth samples, and exact increments over each half interval.

use std::collections::HashMap;
use std::error::Error;
use std::path::Path;

use nalgebra::Vector3;
use sins::earth::state::{BodyAxes, EarthFixedState, Navigation};
use sins::earth::{Earth, Geodetic};
use sins::math::{Euler, attitude_from_euler};
use sins::signal::Increment;

/// A reference flight.
pub struct Reference {
    /// States at the sample times, and their places.
    pub truth: Vec<(EarthFixedState, Geodetic)>,
    /// Increments, two in each interval.
    pub increments: Vec<Increment>,
    /// Interval between two samples [s].
    pub period_s: f64,
}

impl Reference {
    /// Reads the flight `name` over `earth`.
    pub fn load(name: &str, earth: &Earth) -> Result<Self, Box<dyn Error>> {
        let truth = columns(&format!("{name}_truth.packed"))?;
        let increments = columns(&format!("{name}_increments.packed"))?;
        let place = vectors(&truth, ["latitude_rad", "longitude_rad", "height_m"])?;
        let v_n = vectors(&truth, ["velocity_east_m_s", "velocity_north_m_s", "velocity_up_m_s"])?;
        let euler = vectors(&truth, ["roll_rad", "pitch_rad", "heading_rad"])?;
        let angle = vectors(&increments, ["angle_x_rad", "angle_y_rad", "angle_z_rad"])?;
        let velocity = vectors(&increments, ["velocity_x_m_s", "velocity_y_m_s", "velocity_z_m_s"])?;

        let state = |((place, v_n), euler): ((&Vector3<f64>, &Vector3<f64>), &Vector3<f64>)| {
            let place = Geodetic { latitude_rad: place.x, longitude_rad: place.y, height_m: place.z };
            let q_nb = attitude_from_euler(&Euler { roll: euler.x, pitch: euler.y, heading: euler.z });
            (Navigation::new(place, *v_n, q_nb, BodyAxes::default()).earth_fixed(earth), place)
        };
        let pairs = angle.into_iter().zip(velocity);
        Ok(Self {
            truth: place.iter().zip(&v_n).zip(&euler).map(state).collect(),
            increments: pairs.map(|(angle, velocity)| Increment { angle, velocity }).collect(),
            period_s: *truth.get("time_s").and_then(|times| times.get(1)).ok_or("no column time_s")?,
        })
    }
}

type Columns = HashMap<String, Vec<f64>>;

fn vectors(columns: &Columns, names: [&str; 3]) -> Result<Vec<Vector3<f64>>, Box<dyn Error>> {
    let column = |name| columns.get(name).ok_or_else(|| format!("no column {name}"));
    let (x, y, z) = (column(names[0])?, column(names[1])?, column(names[2])?);
    Ok(x.iter().zip(y).zip(z).map(|((&x, &y), &z)| Vector3::new(x, y, z)).collect())
}

/// The columns of a file written by `tests/data/reference.py`, which describes the format.
fn columns(name: &str) -> Result<Columns, Box<dyn Error>> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/data").join(name);
    let bytes = std::fs::read(&path).map_err(|error| format!("{}: {error}", path.display()))?;
    let mut file = Packed { rest: bytes.strip_prefix(b"SINSPACK").ok_or("not a packed file")? };
    let mut columns = Columns::new();
    for _ in 0..file.byte()? {
        let length = usize::from(file.byte()?);
        let name = String::from_utf8(file.bytes(length)?.to_vec())?;
        let (decimals, order) = (file.byte()?, file.byte()?);
        let count = u32::from_le_bytes(file.bytes(4)?.try_into()?);
        let mut values = (0..count).map(|_| file.integer()).collect::<Result<Vec<i128>, _>>()?;
        // Differences of order d begin at value d: sum them up from the highest order.
        for start in (1..=usize::from(order)).rev() {
            for i in start..values.len() {
                values[i] += values[i - 1];
            }
        }
        let scale = 10_u128.checked_pow(u32::from(decimals)).ok_or("too many decimals")? as f64;
        columns.insert(name, values.into_iter().map(|value| value as f64 / scale).collect());
    }
    Ok(columns)
}

/// The part of a packed file that is still to be read.
struct Packed<'a> {
    rest: &'a [u8],
}

impl<'a> Packed<'a> {
    fn bytes(&mut self, count: usize) -> Result<&'a [u8], &'static str> {
        let (head, rest) = self.rest.split_at_checked(count).ok_or("the packed file ends early")?;
        self.rest = rest;
        Ok(head)
    }

    fn byte(&mut self) -> Result<u8, &'static str> {
        Ok(self.bytes(1)?[0])
    }

    /// Reads an integer in zigzag code, with 7 bits in a byte, low bits first.
    fn integer(&mut self) -> Result<i128, &'static str> {
        let (mut zigzag, mut shift) = (0_u128, 0);
        loop {
            let byte = self.byte()?;
            zigzag |= u128::from(byte & 127) << shift;
            shift += 7;
            if byte < 128 {
                return Ok((zigzag >> 1) as i128 ^ -((zigzag & 1) as i128));
            }
        }
    }
}
