//! The equations as the paper prints them, beside the corrected ones, on an hour of two flights: what each misprint does. The tables of
//! `docs/paper.md` have these figures.
//!
//! `cargo test -p tests --test physics misprints:: -- --nocapture` prints them.

mod error_equations;
mod navigation;

use nalgebra::Vector3;
use sins::earth::{Earth, Geodetic};
use sins::math::attitude_from_euler;
use sins::scene::builtin;
use sins::truth::FlightSample;
use sins::truth::flight::{Flight, FlightStart, Manoeuvre};
use sins::{Options, Simulator, mechanization};

use crate::support::{DEG, project_file};

const SECONDS: u32 = 3600;
const RATE_HZ: f64 = 100.0;

/// The patrol of the paper's simulations, whose turns average constant errors of the sensors, and straight flight to the north-east at
/// the same height and speed.
fn flights() -> [Flight; 2] {
    let start = FlightStart {
        latitude_rad: 40.0 * DEG,
        longitude_rad: 116.4 * DEG,
        height_m: 8000.0,
        speed_m_s: 200.0,
        heading_rad: 45.0 * DEG,
        ..Default::default()
    };
    let straight = Manoeuvre::Straight { duration_s: f64::from(SECONDS) };
    [builtin("simulation2").unwrap().flight().unwrap(), Flight::new(&start, &[straight]).unwrap()]
}

/// A simulator with the axes and the free vertical channel of the paper.
fn simulator(options: &Options) -> Simulator {
    let options = Options {
        frame: mechanization::Frame::Geographic,
        vertical: mechanization::VerticalMode::Free,
        intake: sins::truth::IntakeLimits { period_s: Some(1.0 / RATE_HZ), ..Default::default() },
        ..*options
    };
    Simulator::new(&options).unwrap()
}

/// Samples of the hour.
fn samples(flight: &Flight) -> impl Iterator<Item = FlightSample> {
    (0..=SECONDS * RATE_HZ as u32).map(move |k| flight.sample_at(f64::from(k) / RATE_HZ).unwrap())
}

/// Radii of curvature with the height, RM + h and RN + h [m].
fn radii(earth: &Earth, latitude_rad: f64, height_m: f64) -> (f64, f64) {
    let s = latitude_rad.sin();
    let w2 = 1.0 - earth.eccentricity2 * s * s;
    let n = earth.equatorial_radius_m / w2.sqrt();
    (n * (1.0 - earth.eccentricity2) / w2 + height_m, n + height_m)
}

/// Gravity east-north-up [m/s²].
fn gravity(earth: &Earth, latitude_rad: f64, height_m: f64) -> Vector3<f64> {
    let place = Geodetic { latitude_rad, longitude_rad: 0.0, height_m };
    let (r_e, [east, north, up]) = earth.to_earth_fixed_with_axes(&place);
    let g = earth.gravity(&r_e);
    Vector3::new(g.dot(&east), g.dot(&north), g.dot(&up))
}

/// Rates of the Earth and of the axes against the Earth, east-north-up [rad/s], with the given radii [m].
fn rates(
    earth: &Earth,
    latitude_rad: f64,
    v: &Vector3<f64>,
    (m, n): (f64, f64),
) -> (Vector3<f64>, Vector3<f64>) {
    let (s, c) = latitude_rad.sin_cos();
    let earth_rate = Vector3::new(0.0, earth.rate_rad_s * c, earth.rate_rad_s * s);
    (earth_rate, Vector3::new(-v.y / m, v.x / n, v.x * s / c / n))
}

/// Rotation matrix from the axes of the body, right-forward-up, to east-north-up.
fn attitude(sample: &FlightSample) -> nalgebra::Rotation3<f64> {
    nalgebra::UnitQuaternion::new_unchecked(attitude_from_euler(&sample.euler)).to_rotation_matrix()
}

/// Largest distances of two solutions within the hour.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
struct Apart {
    horizontal_m: f64,
    vertical_m: f64,
}

impl Apart {
    fn add(&mut self, difference_m: &Vector3<f64>) {
        self.horizontal_m = self.horizontal_m.max(difference_m.xy().norm());
        self.vertical_m = self.vertical_m.max(difference_m.z.abs());
    }

    /// Two cells of the page.
    fn cells(&self) -> String {
        format!("{} | {}", length(self.horizontal_m), length(self.vertical_m))
    }
}

/// A length with two digits. A solution that is lost has no digits.
fn length(metres: f64) -> String {
    let rounded: f64 = format!("{metres:.1e}").parse().unwrap();
    match rounded {
        1e6.. => "over 1000 km".to_owned(),
        1e4.. => format!("{} km", rounded / 1e3),
        1e-2.. => format!("{rounded} m"),
        ..1e-6 => "below 1e-6 m".to_owned(),
        _ => format!("{rounded:e} m"),
    }
}

/// Prints the rows, one cell for each flight, and finds them in the page: the equation at the beginning, the figures at the end.
fn assert_on_page(rows: impl IntoIterator<Item = (&'static str, [Apart; 2])>) {
    let page = std::fs::read_to_string(project_file("docs/paper.md")).unwrap();
    let mut missing = Vec::new();
    for (what, [patrol, straight]) in rows {
        let end = format!("| {} | {} |", patrol.cells(), straight.cells());
        println!("{what} {end}");
        if !page.lines().any(|line| line.starts_with(&format!("| {what} |")) && line.ends_with(&end)) {
            missing.push(format!("{what} {end}"));
        }
    }
    assert!(missing.is_empty(), "docs/paper.md has no rows with these ends:\n{}", missing.join("\n"));
}
