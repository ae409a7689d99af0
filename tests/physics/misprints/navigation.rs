//! The navigation equations (7) to (24), as the scheme "paper" computes them.

use nalgebra::{UnitQuaternion, Vector3};
use sins::earth::{Earth, Geodetic};
use sins::mechanization::Scheme;
use sins::signal::Increment;
use sins::truth::FlightSample;
use sins::truth::flight::Flight;
use sins::{ErrorSource, Options};

use super::{Apart, assert_on_page, attitude, flights, gravity, radii, rates, samples, simulator};
use crate::support;

/// What differs from the corrected equations with the paper's approximations.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Other {
    Nothing,
    /// (10): radii without the height.
    RadiiWithoutHeight,
    /// The text behind (14): C in the place of its transpose.
    Transposed,
    /// (11) to (13): the sum of the angles is the rotation vector.
    AngleIsRotation,
    /// (17): limits of the integral reversed.
    LimitsReversed,
    /// (18), (19): one half twice.
    HalfTwice,
    /// (18), (19): one half never.
    HalfNever,
    /// (22) to (24): no interval.
    NoInterval,
    /// Without the approximation of (7) and (14): both turns of the attitude apart.
    BothTurns,
    /// Without that of (21): rates and gravity of the middle of the interval.
    Middle,
    /// Without that of (22) to (24): the mean velocity of the interval.
    MeanVelocity,
}

struct Navigator {
    earth: Earth,
    other: Other,
    place: Geodetic,
    v: Vector3<f64>,
    q: UnitQuaternion<f64>,
    /// Change of the velocity in the last interval.
    dv: Vector3<f64>,
}

impl Navigator {
    fn new(other: Other, sample: &FlightSample) -> Self {
        let q = UnitQuaternion::from_rotation_matrix(&attitude(sample));
        let v = sample.v_n.unwrap();
        Self { earth: Earth::default(), other, place: sample.place, v, q, dv: Vector3::zeros() }
    }

    fn advance(&mut self, [first, second]: [Increment; 2], t: f64) {
        let (theta, velocity) = (first.angle + second.angle, first.velocity + second.velocity);
        let coning = first.angle.cross(&second.angle) * (2.0 / 3.0);
        let rotation = if self.other == Other::AngleIsRotation { theta } else { theta + coning };
        let sculling =
            (first.angle.cross(&second.velocity) + first.velocity.cross(&second.angle)) * (2.0 / 3.0);
        let force = velocity + theta.cross(&velocity) * 0.5 + sculling;

        let (mut latitude, mut height, mut v) = (self.place.latitude_rad, self.place.height_m, self.v);
        if self.other == Other::Middle {
            let (m, _) = radii(&self.earth, latitude, height);
            (latitude, height, v) = (latitude + 0.5 * t * v.y / m, height + 0.5 * t * v.z, v + 0.5 * self.dv);
        }
        let with_height = radii(&self.earth, latitude, height);
        let of_transport = if self.other == Other::RadiiWithoutHeight {
            radii(&self.earth, latitude, 0.0)
        } else {
            with_height
        };
        let (earth_rate, transport) = rates(&self.earth, latitude, &v, of_transport);
        let zeta = (earth_rate + transport) * t;
        let half = match self.other {
            Other::LimitsReversed => -0.5,
            Other::HalfTwice => 0.25,
            Other::HalfNever => 1.0,
            _ => 0.5,
        };
        let force_n = self.q * force;
        let steady = gravity(&self.earth, latitude, height) - (earth_rate * 2.0 + transport).cross(&v);
        let dv = force_n - zeta.cross(&force_n) * half + steady * t;
        let in_body = if self.other == Other::Transposed { self.q * zeta } else { self.q.inverse() * zeta };
        self.q = match self.other {
            Other::BothTurns => UnitQuaternion::new(-zeta) * self.q * UnitQuaternion::new(rotation),
            _ => self.q * UnitQuaternion::new(rotation - in_body),
        };
        self.q.renormalize();
        let velocity = if self.other == Other::MeanVelocity { self.v + dv * 0.5 } else { self.v };
        let moved = velocity * if self.other == Other::NoInterval { 1.0 } else { t };
        let (m, n) = radii(&self.earth, self.place.latitude_rad, self.place.height_m);
        self.place.longitude_rad += moved.x / (n * self.place.latitude_rad.cos());
        self.place.latitude_rad += moved.y / m;
        self.place.height_m += moved.z;
        (self.v, self.dv) = (self.v + dv, dv);
    }

    /// Displacement from this solution to another [m].
    fn to(&self, other: &Self) -> Vector3<f64> {
        let (m, n) = radii(&self.earth, self.place.latitude_rad, self.place.height_m);
        let turn = |angle: f64| angle.sin().atan2(angle.cos());
        Vector3::new(
            turn(other.place.longitude_rad - self.place.longitude_rad) * n * self.place.latitude_rad.cos(),
            turn(other.place.latitude_rad - self.place.latitude_rad) * m,
            other.place.height_m - self.place.height_m,
        )
    }
}

const OTHERS: [(&str, Other); 10] = [
    ("(10)", Other::RadiiWithoutHeight),
    ("(11) to (13)", Other::AngleIsRotation),
    ("behind (14)", Other::Transposed),
    ("(17)", Other::LimitsReversed),
    ("(18), (19), twice", Other::HalfTwice),
    ("(18), (19), never", Other::HalfNever),
    ("(22) to (24)", Other::NoInterval),
    ("(7), (14)", Other::BothTurns),
    ("(21)", Other::Middle),
    ("(22) to (24), Euler", Other::MeanVelocity),
];

/// How far each solution is from that of the corrected equations within the hour.
fn flown(flight: &Flight) -> [Apart; OTHERS.len()] {
    let first = flight.sample_at(0.0).unwrap();
    let mut simulator = simulator(&Options { scheme: Scheme::Paper, ..Default::default() });
    let mut right = Navigator::new(Other::Nothing, &first);
    let mut all = OTHERS.map(|(_, other)| (Navigator::new(other, &first), Apart::default()));
    let (mut own, mut scheme) = (Apart::default(), Apart::default());
    for (k, sample) in samples(flight).enumerate() {
        support::step(&mut simulator, &sample);
        if k == 0 {
            continue;
        }
        let (increments, t) = simulator.measured_update(0).unwrap();
        let increments: [Increment; 2] = increments.try_into().unwrap();
        assert!(simulator.measured_update(1).is_none());
        right.advance(increments, t);
        // A solution that is lost ends near a pole.
        for (navigator, apart) in
            all.iter_mut().filter(|(navigator, _)| navigator.place.latitude_rad.abs() < 1.55)
        {
            navigator.advance(increments, t);
            apart.add(&right.to(navigator));
        }
        let navigation = simulator.navigation().unwrap().unwrap().navigation;
        let library = Navigator { place: navigation.place, ..Navigator::new(Other::Nothing, &sample) };
        own.add(&right.to(&library));
        scheme.add(&support::errors(&simulator, ErrorSource::Navigation).position_n);
    }
    println!("errors of the scheme {scheme:?}; own equations against it {own:?}");
    // Rounding of the position, 1e-9 m, which the free vertical channel multiplies by cosh(6.3), 280.
    assert!(own.horizontal_m < 1e-6 && own.vertical_m < 1e-5, "{own:?}");
    all.map(|(_, apart)| apart)
}

/// The corrected equations are those of the library's scheme "paper", and each misprint is found by what it does.
#[test]
fn what_misprints_of_the_navigation_equations_do() {
    let [patrol, straight] = flights().map(|flight| flown(&flight));
    let rows = OTHERS.iter().zip(patrol.into_iter().zip(straight));
    assert_on_page(rows.map(|((what, _), (patrol, straight))| (*what, [patrol, straight])));
}
