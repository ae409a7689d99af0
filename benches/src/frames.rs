//! Why the mechanization navigates in Earth-fixed axes: accuracy and time against wander-azimuth and
//! geographic axes, in one run on the same exact increments, two subsamples, exact body part.
//!
//! Wander-azimuth axes with equally good Earth terms are as accurate where truncation dominates (coning). Where rounding dominates,
//! their error is larger: 4.0e-7 m instead of 3.4e-9 m in the loop. Earth-fixed axes take less time.
//! Gravity is `Earth::gravity` for all. It is timed with its default, the closed form, which takes and returns Cartesian vectors.
//! Somigliana's formula takes latitude and height; written out for wander axes, it would make these the faster ones.
//!
//! `cargo run --release --manifest-path benches/Cargo.toml --bin frames`

mod reference;
mod wander;

use std::error::Error;
use std::hint::black_box;
use std::time::Instant;

use nalgebra::Vector3;
use reference::Reference;
use sins::earth::state::{BodyAxes, EarthFixedState};
use sins::earth::{Earth, Ellipsoid, Geodetic, GravityModel};
use sins::math::{relative_rotation, rotation_vector};
use sins::mechanization::{BodyMotion, Frame, Mechanization, Scheme, VerticalAid};
use sins::signal::Increment;
use wander::Wander;

/// One of the mechanizations.
trait Navigator: Copy {
    /// One update of length `t` [s].
    fn update(&mut self, increments: &[Increment], t: f64);

    /// Damps the vertical channel by a barometric height [m] over an interval `t` [s].
    fn damp_vertical(&mut self, barometer_m: f64, t: f64);

    /// The solution; `None` if the axes are singular.
    fn state(&self, earth: &Earth) -> Option<EarthFixedState>;
}

impl Navigator for Mechanization {
    #[inline]
    fn update(&mut self, increments: &[Increment], t: f64) {
        self.update(increments, t);
    }

    #[inline]
    fn damp_vertical(&mut self, barometer_m: f64, t: f64) {
        self.aid_vertical(&VerticalAid::Barometer { height_m: barometer_m }, t);
    }

    fn state(&self, earth: &Earth) -> Option<EarthFixedState> {
        self.check().ok()?;
        Some(self.navigation(BodyAxes::default()).earth_fixed(earth))
    }
}

impl Navigator for Wander {
    #[inline]
    fn update(&mut self, increments: &[Increment], t: f64) {
        self.update(increments, t);
    }

    #[inline]
    fn damp_vertical(&mut self, barometer_m: f64, t: f64) {
        self.damp_vertical(barometer_m, t);
    }

    fn state(&self, _: &Earth) -> Option<EarthFixedState> {
        Some(self.state())
    }
}

/// The body part alone, which all mechanizations share.
#[derive(Clone, Copy)]
struct BodyPart;

impl Navigator for BodyPart {
    #[inline]
    fn update(&mut self, increments: &[Increment], _: f64) {
        black_box(BodyMotion::exact(increments));
    }

    fn damp_vertical(&mut self, _: f64, _: f64) {}

    fn state(&self, _: &Earth) -> Option<EarthFixedState> {
        None
    }
}

/// Largest errors on the way: horizontal position [m] and velocity [m/s], attitude against the Earth [rad].
#[derive(Clone, Copy, Default)]
struct Worst([f64; 3]);

impl Worst {
    fn look(&mut self, earth: &Earth, computed: &EarthFixedState, exact: &(EarthFixedState, Geodetic)) {
        let (exact, place) = exact;
        let (_, _, up) = earth.east_north_up(place);
        let horizontal = |v: Vector3<f64>| (v - up * up.dot(&v)).norm();
        let errors = [
            horizontal(computed.r_e - exact.r_e),
            horizontal(computed.v_e - exact.v_e),
            rotation_vector(&relative_rotation(&exact.q_eb, &computed.q_eb)).norm(),
        ];
        for (worst, error) in self.0.iter_mut().zip(errors) {
            *worst = worst.max(error);
        }
    }
}

/// Flies the whole reference; `None` if the axes become singular on the way.
fn fly(mut navigator: impl Navigator, earth: &Earth, reference: &Reference) -> Option<Worst> {
    let mut worst = Worst::default();
    for (pair, truth) in reference.increments.chunks_exact(2).zip(&reference.truth[1..]) {
        navigator.update(pair, reference.period_s);
        worst.look(earth, &navigator.state(earth)?, truth);
    }
    Some(worst)
}

fn accuracy() -> Result<(), Box<dyn Error>> {
    // The gravity field with which the references were made.
    let earth = Earth::new(Ellipsoid::Wgs84, GravityModel::Somigliana);
    println!("largest errors, free vertical channel: horizontal position r and velocity v, attitude psi\n");
    println!("{:12}{:>27}{:>27}{:>27}", "", "Earth-fixed", "wander azimuth", "geographic");
    println!("{:12}{}", "", "    r [m]  v [m/s] psi[rad]".repeat(3));
    for name in ["fig8", "loop", "scurve", "cone1", "polar", "pole_static"] {
        let reference = Reference::load(name, &earth)?;
        let (start, _) = reference.truth.first().ok_or("no truth")?;
        let crates = |frame| Mechanization::new(earth, frame, Scheme::Exact, start);
        print!("{name:12}");
        for worst in [
            fly(crates(Frame::EarthFixed), &earth, &reference),
            fly(Wander::new(earth, start), &earth, &reference),
            fly(crates(Frame::Geographic), &earth, &reference),
        ] {
            match worst {
                Some(Worst([r, v, psi])) => print!(" {r:8.1e} {v:8.1e} {psi:8.1e}"),
                None => print!(" {:>26}", "singular"),
            }
        }
        println!();
    }
    Ok(())
}

/// Time of an update [ns] over `increments`, in one batch; with `BAROMETER`, it includes the vertical loop.
fn batch<const BAROMETER: bool>(mut navigator: impl Navigator, increments: &[Increment], t: f64) -> f64 {
    let begin = Instant::now();
    for pair in increments.chunks_exact(2) {
        navigator.update(black_box(pair), t);
        if BAROMETER {
            navigator.damp_vertical(black_box(3000.0), t);
        }
    }
    black_box(&navigator);
    2e9 * begin.elapsed().as_secs_f64() / increments.len() as f64
}

/// One batch of each navigator. Batches take turns, so that changes of the machine's speed affect all alike.
fn round<const BAROMETER: bool>(reference: &Reference, earth: Earth, start: &EarthFixedState) -> [f64; 4] {
    let (increments, t) = (&reference.increments[..2000], reference.period_s);
    let crates = |frame| Mechanization::new(earth, frame, Scheme::Exact, start);
    [
        batch::<BAROMETER>(crates(Frame::EarthFixed), increments, t),
        batch::<BAROMETER>(Wander::new(earth, start), increments, t),
        batch::<BAROMETER>(crates(Frame::Geographic), increments, t),
        batch::<BAROMETER>(BodyPart, increments, t),
    ]
}

/// Prints the shortest times of many batches.
fn time() -> Result<(), Box<dyn Error>> {
    const ROUNDS: usize = 2000;
    let earth = Earth::default();
    let reference = Reference::load("fig8", &earth)?;
    let (start, _) = reference.truth.first().ok_or("no truth")?;
    let mut least = [[f64::INFINITY; 4]; 2];
    for _ in 0..ROUNDS {
        let times = [round::<false>(&reference, earth, start), round::<true>(&reference, earth, start)];
        for (least, time) in least.as_flattened_mut().iter_mut().zip(times.as_flattened()) {
            *least = least.min(*time);
        }
    }
    let [free, damped] = least;
    println!("\ntime of an update [ns], and its ratio to Earth-fixed\n");
    println!("{:16}{:>16}{:>18}", "", "free vertical", "barometric loop");
    let names = ["Earth-fixed", "wander azimuth", "geographic", "body part alone"];
    for (k, name) in names.iter().enumerate() {
        let (ns, ratio) = (free[k], free[k] / free[0]);
        print!("{name:16}{ns:9.1}{ratio:7.2}");
        println!("{:11.1}{:7.2}", damped[k], damped[k] / damped[0]);
    }
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    accuracy()?;
    time()
}
