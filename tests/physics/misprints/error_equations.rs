//! The error equations (4) to (6).

use nalgebra::{SMatrix, SVector, Vector3};
use sins::earth::Earth;
use sins::sensors::TriadParameters;
use sins::truth::flight::Flight;
use sins::{ErrorSource, Options};

use super::{Apart, assert_on_page, attitude, flights, gravity, radii, rates, samples, simulator};
use crate::support::{self, DEG_PER_HOUR, G};

/// Constant errors of the paper's simulation 2, the same on each axis of the body.
const GYRO: f64 = 0.01 * DEG_PER_HOUR;
const ACCEL: f64 = 1e-5 * G;

/// Step of the integration [s].
const STEP_S: f64 = 0.1;

/// What is printed in the place of the right term.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Printed {
    Nothing,
    /// (1), (2): no constant drift of the gyros.
    NoConstant,
    /// (4): + eps.
    PlusEps,
    /// (4), third row: + vE tan L/(RM + h)² dh.
    AzimuthByHeight,
    /// (5), first row: RM in the term of dvE.
    EastRadius,
    /// (5), first row: dL in the place of dh.
    EastByLatitude,
    /// (5), second row: one radius for both parts.
    NorthRadius,
    /// (5), third row: no gradient of gravity.
    NoGradient,
    /// (4) to (6): the radii do not change with latitude.
    ConstantRadii,
}

/// φ [rad], δv [m/s], δL [rad], δλ [rad], δh [m].
type States = SVector<f64, 9>;

/// The truth at an instant, east-north-up.
struct Truth {
    latitude_rad: f64,
    height_m: f64,
    v: Vector3<f64>,
    f: Vector3<f64>,
    eps: Vector3<f64>,
    nabla: Vector3<f64>,
}

impl Truth {
    fn at(earth: &Earth, flight: &Flight, time_s: f64) -> Self {
        let sample = flight.sample_at(time_s).unwrap();
        let (latitude_rad, height_m) = (sample.place.latitude_rad, sample.place.height_m);
        // The derivative of the velocity by four neighbours, or at the ends of the flight by those on one side.
        let h = 0.01;
        let middle = time_s.clamp(2.0 * h, flight.duration_s() - 2.0 * h);
        let velocity = |k: f64| flight.sample_at(middle + k * h).unwrap().v_n.unwrap();
        let by_centre =
            ((velocity(1.0) - velocity(-1.0)) * 8.0 - (velocity(2.0) - velocity(-2.0))) / (12.0 * h);
        let v = sample.v_n.unwrap();
        let (earth_rate, transport) = rates(earth, latitude_rad, &v, radii(earth, latitude_rad, height_m));
        let f = by_centre + (earth_rate * 2.0 + transport).cross(&v) - gravity(earth, latitude_rad, height_m);
        let c = attitude(&sample);
        Self {
            latitude_rad,
            height_m,
            v,
            f,
            eps: c * Vector3::repeat(GYRO),
            nabla: c * Vector3::repeat(ACCEL),
        }
    }

    /// x' = F x + u, term by term.
    fn system(&self, earth: &Earth, printed: Printed) -> (SMatrix<f64, 9, 9>, States) {
        let (ve, vn, vu) = (self.v.x, self.v.y, self.v.z);
        let (fe, fn_, fu) = (self.f.x, self.f.y, self.f.z);
        let (s, c) = self.latitude_rad.sin_cos();
        let (t, sec) = (s / c, 1.0 / c);
        let (m, n) = radii(earth, self.latitude_rad, self.height_m);
        let (m2, n2) = (m * m, n * n);
        let derivative = |of: fn((f64, f64)) -> f64| {
            let d = 1e-4;
            let at = |sign: f64| of(radii(earth, self.latitude_rad + sign * d, self.height_m));
            (at(1.0) - at(-1.0)) / (2.0 * d)
        };
        let (dm, dn) = match printed {
            Printed::ConstantRadii => (0.0, 0.0),
            _ => (derivative(|(m, _)| m), derivative(|(_, n)| n)),
        };
        let (wn, wu) = (earth.rate_rad_s * c, earth.rate_rad_s * s);
        let (we_, wn_, wu_) = (-vn / m, wn + ve / n, wu + ve * t / n);
        let g = |dl: f64, dh: f64| gravity(earth, self.latitude_rad + dl, self.height_m + dh);
        let g_h = (g(0.0, 100.0) - g(0.0, -100.0)) / 200.0;
        let g_l = (g(1e-4, 0.0) - g(-1e-4, 0.0)) / 2e-4;
        let (up_h, up_l) = if printed == Printed::NoGradient { (0.0, 0.0) } else { (g_h.z, g_l.z) };
        let azimuth_h = if printed == Printed::AzimuthByHeight { ve * t / m2 } else { -ve * t / n2 };
        let east_v = if printed == Printed::EastRadius { (vn * t - vu) / m } else { (vn * t - vu) / n };
        let east = (ve * vu - ve * vn * t) / n2;
        let (east_h, east_l) = if printed == Printed::EastByLatitude { (0.0, east) } else { (east, 0.0) };
        let north_h = if printed == Printed::NorthRadius {
            (ve * ve * t + vn * vu) / m2
        } else {
            ve * ve * t / n2 + vn * vu / m2
        };
        let rows: [&[(usize, f64)]; 9] = [
            &[(1, wu_), (2, -wn_), (4, -1.0 / m), (6, vn * dm / m2), (8, vn / m2)],
            &[(0, -wu_), (2, we_), (3, 1.0 / n), (6, -wu - ve * dn / n2), (8, -ve / n2)],
            &[
                (0, wn_),
                (1, -we_),
                (3, t / n),
                (6, wn + ve * sec * sec / n - ve * t * dn / n2),
                (8, azimuth_h),
            ],
            &[
                (1, -fu),
                (2, fn_),
                (3, east_v),
                (4, 2.0 * wu + ve * t / n),
                (5, -(2.0 * wn + ve / n)),
                (6, 2.0 * wn * vn + ve * vn * sec * sec / n + 2.0 * wu * vu + east * dn + east_l),
                (8, east_h),
            ],
            &[
                (0, fu),
                (2, -fe),
                (3, -2.0 * (wu + ve * t / n)),
                (4, -vu / m),
                (5, -vn / m),
                (
                    6,
                    -(2.0 * wn + ve * sec * sec / n) * ve + ve * ve * t * dn / n2 + vn * vu * dm / m2 + g_l.y,
                ),
                (8, north_h + g_h.y),
            ],
            &[
                (0, -fn_),
                (1, fe),
                (3, 2.0 * (wn + ve / n)),
                (4, 2.0 * vn / m),
                (6, -2.0 * wu * ve - (vn * vn * dm / m2 + ve * ve * dn / n2) + up_l),
                (8, -(vn * vn / m2 + ve * ve / n2) + up_h),
            ],
            &[(4, 1.0 / m), (6, -vn * dm / m2), (8, -vn / m2)],
            &[(3, sec / n), (6, ve * sec * t / n - ve * sec * dn / n2), (8, -ve * sec / n2)],
            &[(5, 1.0)],
        ];
        let mut f = SMatrix::zeros();
        for (row, terms) in rows.into_iter().enumerate() {
            terms.iter().for_each(|&(column, term)| f[(row, column)] = term);
        }
        let eps = match printed {
            Printed::PlusEps => -self.eps,
            Printed::NoConstant => Vector3::zeros(),
            _ => self.eps,
        };
        let mut u = States::zeros();
        u.fixed_rows_mut::<3>(0).copy_from(&-eps);
        u.fixed_rows_mut::<3>(3).copy_from(&self.nabla);
        (f, u)
    }

    /// Position error [m] of a solution.
    fn metres(&self, earth: &Earth, x: &States) -> Vector3<f64> {
        let (m, n) = radii(earth, self.latitude_rad, self.height_m);
        Vector3::new(x[7] * n * self.latitude_rad.cos(), x[6] * m, x[8])
    }
}

/// Position errors [m] at the steps of the hour, by the classical fourth-order Runge-Kutta method.
fn flown(printed: Printed, truth: &[Truth]) -> Vec<Vector3<f64>> {
    let earth = Earth::default();
    let mut x = States::zeros();
    let mut found = vec![Vector3::zeros()];
    let mut systems = truth.iter().map(|truth| truth.system(&earth, printed));
    let mut start = systems.next().unwrap();
    for interval in truth[1..].chunks_exact(2) {
        let (middle, end) = (systems.next().unwrap(), systems.next().unwrap());
        let rate = |(f, u): &(SMatrix<f64, 9, 9>, States), x: States| f * x + u;
        let k1 = rate(&start, x);
        let k2 = rate(&middle, x + k1 * (0.5 * STEP_S));
        let k3 = rate(&middle, x + k2 * (0.5 * STEP_S));
        let k4 = rate(&end, x + k3 * STEP_S);
        x += (k1 + k2 * 2.0 + k3 * 2.0 + k4) * (STEP_S / 6.0);
        start = end;
        found.push(interval[1].metres(&earth, &x));
    }
    found
}

fn truth(flight: &Flight) -> Vec<Truth> {
    let earth = Earth::default();
    let nodes = (2.0 * f64::from(super::SECONDS) / STEP_S) as u32;
    (0..=nodes).map(|k| Truth::at(&earth, flight, 0.5 * STEP_S * f64::from(k))).collect()
}

fn apart(one: &[Vector3<f64>], other: &[Vector3<f64>]) -> Apart {
    let mut apart = Apart::default();
    one.iter().zip(other).for_each(|(one, other)| apart.add(&(one - other)));
    apart
}

/// Position errors of the hour by the library's error data 1.
fn library(flight: &Flight) -> Vec<Vector3<f64>> {
    let mut simulator = simulator(&Options { error_model: true, ..Default::default() });
    simulator.set_gyro(&TriadParameters { bias: Vector3::repeat(GYRO), ..Default::default() }).unwrap();
    simulator.set_accel(&TriadParameters { bias: Vector3::repeat(ACCEL), ..Default::default() }).unwrap();
    let mut errors = vec![Vector3::zeros()];
    for (k, sample) in samples(flight).enumerate() {
        support::step(&mut simulator, &sample);
        if k > 0 && k % (STEP_S * super::RATE_HZ) as usize == 0 {
            errors.push(support::errors(&simulator, ErrorSource::Model).position_n);
        }
    }
    errors
}

/// The corrected equations are those of the library, and each misprint is found by what it does.
#[test]
fn what_misprints_of_the_error_equations_do() {
    let flights = flights();
    let truths = flights.each_ref().map(truth);
    let right = truths.each_ref().map(|truth| flown(Printed::Nothing, truth));
    for (flight, right) in flights.iter().zip(&right) {
        let library = library(flight);
        assert_eq!(library.len(), right.len());
        let own = apart(right, &library);
        let last = right.last().unwrap();
        println!("errors after the hour {:.1?}; own equations against error data 1 {own:?}", last.as_slice());
        // Products of errors are dropped in both; what is left is the interpolation of the truth.
        assert!(own.horizontal_m < 1e-6 * last.norm() && own.vertical_m < 1e-6 * last.norm(), "{own:?}");
    }
    let rows = [
        ("(1), (2)", Printed::NoConstant),
        ("(4), all rows", Printed::PlusEps),
        ("(4), third row", Printed::AzimuthByHeight),
        ("(5), first row, δvE", Printed::EastRadius),
        ("(5), first row, δh", Printed::EastByLatitude),
        ("(5), second row", Printed::NorthRadius),
        ("(5), third row", Printed::NoGradient),
        ("(4) to (6)", Printed::ConstantRadii),
    ];
    assert_on_page(rows.map(|(what, printed)| {
        (what, core::array::from_fn(|k| apart(&flown(printed, &truths[k]), &right[k])))
    }));
}
