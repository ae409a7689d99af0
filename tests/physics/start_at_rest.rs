//! What the header says of errors at the start.

use nalgebra::Vector3;
use sins::earth::{Earth, Geodetic};
use sins::sensors::{Alignment, InitialErrorParameters};
use sins::{ErrorSource, Options, Simulator};

use crate::support::{DEG, G, resting_sample};

fn started(initial: &InitialErrorParameters, height_m: f64) -> Simulator {
    let mut simulator = Simulator::new(&Options::default()).unwrap();
    simulator.set_initial_errors(initial).unwrap();
    let mut sample = resting_sample(0.0);
    sample.place.height_m = height_m;
    simulator.push_sample(&sample).unwrap();
    simulator
}

/// Laid off at the height of the solution, measured at that of the truth: larger by the ratio of the radii.
#[test]
fn a_position_error_reads_back_larger_by_its_height_error() {
    let position_n = Vector3::new(3000.0, 3000.0, 100.0);
    let simulator = started(&InitialErrorParameters { position_n, ..Default::default() }, 0.0);
    let read = simulator.errors(ErrorSource::Navigation).unwrap().unwrap().1.position_n;
    let radii = Earth::default().radii((39.9 * DEG).sin());
    let (mut off, mut limit) = (0.0_f64, f64::MAX);
    for (read, radius_m) in [(read.x, radii.transverse_m), (read.y, radii.meridian_m)] {
        let larger = read - 3000.0;
        println!("{larger:.4} m");
        let of_second_order = 3000.0 * (3000.0f64.hypot(3000.0) / radius_m).powi(2);
        assert!((larger - 3000.0 * 100.0 / radius_m).abs() < of_second_order, "{larger} m");
        assert!((larger - 0.046).abs() < of_second_order, "the header's figure");
        off = off.max((larger - 3000.0 * 100.0 / radius_m).abs());
        limit = limit.min(of_second_order);
    }
    assert!((read.z - 100.0).abs() < 1e-8);
    println!("figure: {:.1} mm (limit {:.1} mm, the second order)", 1e3 * off, 1e3 * limit);
}

/// Ideal sensors level along normal gravity.
#[test]
fn levelling_follows_normal_gravity_at_height() {
    let initial = InitialErrorParameters { alignment: Alignment::LevelAndGyrocompass, ..Default::default() };
    let simulator = started(&initial, 9000.0);
    let tilt = simulator.errors(ErrorSource::Navigation).unwrap().unwrap().1.misalignment_n;
    let limit = 1e-14;
    assert!(tilt.norm() < limit, "{tilt}");
    let earth = Earth::default();
    let place = Geodetic { latitude_rad: 45.0 * DEG, longitude_rad: 0.0, height_m: 9000.0 };
    let gravity_e = earth.gravity(&earth.to_earth_fixed(&place));
    let north_e = Vector3::new(-place.latitude_rad.sin(), 0.0, place.latitude_rad.cos());
    let micro_g = gravity_e.dot(&north_e).abs() / (1e-6 * G);
    assert!((micro_g - 7.5).abs() < 0.05, "the header's figure: {micro_g}");
    println!("figure: {:.1e} rad (limit {limit:e} rad)", tilt.norm());
}
