//! A place and an attitude in the vehicle.

use nalgebra::{Quaternion, Vector3};
use sins::earth::state::{BodyAxes, EarthFixedState};
use sins::math::{Euler, attitude_from_euler, rotate, rotate_inverse, rotation_quaternion};
use sins::signal::mounting::{MountingParameters, Placement};
use sins::truth::FlightSample;

const EARTH_RATE: f64 = 7.292_115e-5;

/// A point, its angular rate and a block away from it.
fn scene(axes: BodyAxes) -> (EarthFixedState, Vector3<f64>, Placement) {
    let point = EarthFixedState {
        r_e: Vector3::new(4e6, -3e6, 4e6),
        v_e: Vector3::new(100.0, 50.0, -200.0),
        q_eb: attitude_from_euler(&Euler { roll: 0.3, pitch: -0.7, heading: 4.0 }),
    };
    let boresight = Euler { roll: 1.0, pitch: 0.4, heading: 2.5 };
    let placement = Placement::new(Vector3::new(3.0, -7.0, 1.5), &boresight, axes);
    (point, Vector3::new(0.5, -1.2, 0.3), placement)
}

#[test]
fn there_and_back_is_where_it_was() {
    for axes in [BodyAxes::RightForwardUp, BodyAxes::ForwardRightDown] {
        let (point, omega_ib_b, placement) = scene(axes);
        let block = placement.block(&point, &omega_ib_b, EARTH_RATE);
        let omega_is_s = rotate_inverse(&placement.q_bs, &omega_ib_b);
        let back = placement.reference_point(&block, &omega_is_s, EARTH_RATE);
        // Rounding: half a unit in the last place of 4e6 m there and one back; a few units of 200 m/s and of 1.
        assert!((back.r_e - point.r_e).amax() < 2.0 * 4e6 * f64::EPSILON);
        assert!((back.v_e - point.v_e).amax() < 8.0 * 200.0 * f64::EPSILON);
        assert!((back.q_eb - point.q_eb).norm() < 8.0 * f64::EPSILON);
    }
}

/// The velocity of the block is the derivative of its place in Earth-fixed axes, by central differences of h = 1e-3 s:
/// |ω|³ l h²/6 = 3e-6 of truncation, 4e6 eps/h = 9e-7 m/s of rounding.
#[test]
fn the_blocks_velocity_is_the_derivative_of_its_place() {
    let (point, omega_ib_b, placement) = scene(BodyAxes::RightForwardUp);
    let omega_eb_b = omega_ib_b - rotate_inverse(&point.q_eb, &Vector3::new(0.0, 0.0, EARTH_RATE));
    let h = 1e-3;
    let at = |t: f64| {
        let q_eb = point.q_eb * rotation_quaternion(&(omega_eb_b * t));
        placement.block(
            &EarthFixedState { r_e: point.r_e + point.v_e * t, v_e: point.v_e, q_eb },
            &omega_ib_b,
            EARTH_RATE,
        )
    };
    let difference = (at(h).r_e - at(-h).r_e) / (2.0 * h) - at(0.0).v_e;
    assert!(difference.norm() < 5e-6, "{difference:?}");
}

/// A block that is turned right by a quarter turn has its forward axis along the wing. It is the same block in both conventions
/// of axes.
#[test]
fn boresight_angles_mean_the_same_block_in_any_axes() {
    let quarter = Euler { heading: core::f64::consts::FRAC_PI_2, ..Euler::default() };
    let near = |a: Vector3<f64>, b: Vector3<f64>| (a - b).norm() < 8.0 * f64::EPSILON;
    let rfu = Placement::new(Vector3::zeros(), &quarter, BodyAxes::RightForwardUp).q_bs;
    assert!(near(rotate(&rfu, &Vector3::y()), Vector3::x()));
    let frd = Placement::new(Vector3::zeros(), &quarter, BodyAxes::ForwardRightDown).q_bs;
    assert!(near(rotate(&frd, &Vector3::x()), Vector3::y()));
    let rolled = Euler { roll: 0.1, ..Euler::default() };
    let frd = Placement::new(Vector3::zeros(), &rolled, BodyAxes::ForwardRightDown).q_bs;
    assert!(
        near(rotate(&frd, &Vector3::y()), Vector3::new(0.0, 0.1f64.cos(), 0.1f64.sin())),
        "right wing down"
    );
    let level = Placement::new(Vector3::zeros(), &Euler::default(), BodyAxes::ForwardRightDown).q_bs;
    assert_eq!(level, Quaternion::identity());
}

/// They have the range of the attitude of a flight sample: any number of turns, up to the limit where an angle loses its
/// digits.
#[test]
fn boresight_angles_have_the_range_of_a_samples_attitude() {
    let turned = |heading| MountingParameters {
        boresight: Euler { heading, ..Euler::default() },
        ..MountingParameters::default()
    };
    let limit = FlightSample::MAX_ANGLE_RAD;
    for heading in [limit, -limit] {
        assert_eq!(turned(heading).validate(), Ok(()));
        let mut sample = FlightSample { euler: turned(heading).boresight, ..FlightSample::default() };
        assert_eq!(sample.validate(), Ok(()));
        sample.euler.heading *= 1.0 + f64::EPSILON;
        assert!(sample.validate().is_err());
        let refused = turned(heading * (1.0 + f64::EPSILON)).validate().unwrap_err();
        assert!(refused.to_string().starts_with("mounting.boresight_rad[2] = "), "{refused}");
        assert!(refused.to_string().ends_with(": must be from -10000 to 10000"), "{refused}");
    }
}
