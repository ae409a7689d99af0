//! Why the mechanization navigates in Earth-fixed axes: accuracy and time against wander-azimuth and geographic axes,
//! in one run on the same exact increments, two subsamples, exact body part, free vertical channel.
//!
//! `cargo run --release --manifest-path benches/Cargo.toml --bin frames`

mod reference;
mod wander;

use std::error::Error;
use std::hint::black_box;
use std::time::Instant;

use nalgebra::Vector3;
use reference::Reference;
use sins::earth::{Earth, Ellipsoid, Geodetic, GravityModel};
use sins::math::{relative_rotation, rotation_vector};
use sins::mechanization::{BodyMotion, Frame, Mechanization, Scheme};
use sins::signal::Increment;
use sins::state::{BodyAxes, EarthFixedState};
use wander::Wander;

/// One of the mechanizations.
trait Navigator: Copy {
    /// One update of length `t` [s].
    fn update(&mut self, increments: &[Increment], t: f64);

    /// The solution; none where the axes are singular.
    fn state(&self, earth: &Earth) -> Option<EarthFixedState>;
}

impl Navigator for Mechanization {
    #[inline]
    fn update(&mut self, increments: &[Increment], t: f64) {
        self.update(increments, t);
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

    fn state(&self, _: &Earth) -> Option<EarthFixedState> {
        Some(self.state())
    }
}

/// The body part alone, which all of them share.
#[derive(Clone, Copy)]
struct BodyPart;

impl Navigator for BodyPart {
    #[inline]
    fn update(&mut self, increments: &[Increment], _: f64) {
        black_box(BodyMotion::exact(increments));
    }

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

/// Flies the whole reference; none if the axes become singular on the way.
fn fly(mut navigator: impl Navigator, earth: &Earth, reference: &Reference) -> Option<Worst> {
    let mut worst = Worst::default();
    for (pair, truth) in reference.increments.chunks_exact(2).zip(&reference.truth[1..]) {
        navigator.update(pair, reference.period_s);
        worst.look(earth, &navigator.state(earth)?, truth);
    }
    Some(worst)
}

fn accuracy() -> Result<(), Box<dyn Error>> {
    // The field in which the references were made.
    let earth = Earth::new(Ellipsoid::Wgs84, GravityModel::Somigliana);
    println!("largest errors: horizontal position [m], horizontal velocity [m/s], attitude [rad]\n");
    println!("{:12}{:^27}{:^27}{:^27}", "", "Earth-fixed", "wander azimuth", "geographic");
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
                None => print!(" {:^26}", "singular"),
            }
        }
        println!();
    }
    Ok(())
}

/// Time of an update [ns] over `increments`, in one batch.
fn batch(mut navigator: impl Navigator, increments: &[Increment], t: f64) -> f64 {
    let begin = Instant::now();
    for pair in increments.chunks_exact(2) {
        navigator.update(black_box(pair), t);
    }
    black_box(&navigator);
    2e9 * begin.elapsed().as_secs_f64() / increments.len() as f64
}

/// The least of many batches; the mechanizations take turns, so that the machine's mood meets them all alike.
fn time() -> Result<(), Box<dyn Error>> {
    const ROUNDS: usize = 2000;
    let earth = Earth::default();
    let reference = Reference::load("fig8", &earth)?;
    let (increments, t) = (&reference.increments[..2000], reference.period_s);
    let (start, _) = reference.truth.first().ok_or("no truth")?;
    let crates = |frame| Mechanization::new(earth, frame, Scheme::Exact, start);
    let mut least = [f64::INFINITY; 4];
    for _ in 0..ROUNDS {
        let times = [
            batch(crates(Frame::EarthFixed), increments, t),
            batch(Wander::new(earth, start), increments, t),
            batch(crates(Frame::Geographic), increments, t),
            batch(BodyPart, increments, t),
        ];
        for (least, time) in least.iter_mut().zip(times) {
            *least = least.min(time);
        }
    }
    println!("\ntime of an update, default gravity [ns], and its ratio to Earth-fixed\n");
    for (name, ns) in ["Earth-fixed", "wander azimuth", "geographic", "body part"].iter().zip(least) {
        println!("{name:16}{ns:7.1}{:7.2}", ns / least[0]);
    }
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    accuracy()?;
    time()
}
