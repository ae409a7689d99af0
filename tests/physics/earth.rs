//! Conversions between geodetic and Earth-fixed coordinates, to a nanometre from -10 km to 100 km, poles included; radii of curvature;
//! normal gravity and its gradient.

use std::f64::consts::FRAC_PI_2;

use nalgebra::Vector3;
use sins::earth::{Earth, Ellipsoid, Geodetic, GravityModel};

/// Latitude [rad], longitude [rad], height [m]; x, y, z [m] of WGS-84 in 40-digit arithmetic, rounded to doubles.
const EXACT: [[f64; 6]; 16] = [
    [0.0, 0.0, 0.0, 6378137.0, 0.0, 0.0],
    [FRAC_PI_2, 0.0, -10000.0, 3.912497690818735e-10, 0.0, 6346752.314245179],
    [-FRAC_PI_2, 2.5, 100000.0, -3.1884340338855795e-10, 2.3818313165871337e-10, -6456752.314245179],
    [1e-09, -3.1, 10.0, -6372630.861310067, -265207.57735690445, 0.00633544932729282],
    [1.5707963257948965, 1.0, 5000.0, 0.003460417202351277, 0.005389280481470585, 6361752.314245179],
    [1.5707953267948966, -2.0, 0.0, -2.6631706424901833, -5.819134016508841, 6356752.314241979],
    [
        0.38591132195366407,
        1.5184222925573807,
        100000.0,
        314336.7537552183,
        5996278.366712101,
        2423454.1716183606,
    ],
    [
        -1.4789235831894498,
        -0.21588973050549853,
        0.0,
        573475.8735134039,
        -125767.59124444588,
        -6329764.24677977,
    ],
    [
        0.46778009684994193,
        2.517655088193911,
        -10000.0,
        -4616206.648054431,
        3323069.6198069025,
        2854124.463547381,
    ],
    [
        -0.4025688635343554,
        2.313837475392799,
        20000.0,
        -3984543.101698478,
        4337239.940853249,
        -2491230.1733690305,
    ],
    [
        0.13740909800082157,
        0.4643506601884728,
        -10000.0,
        5640517.224646234,
        2825217.321670666,
        866494.8191510042,
    ],
    [0.725916870687392, -0.5768113747600521, 0.0, 4004279.7064512894, -2605266.886346973, 4211817.352308862],
    [
        1.3073244674788531,
        1.6687558362310102,
        0.0,
        -162968.21538463974,
        1658303.4967556144,
        6135988.7548064245,
    ],
    [
        0.8224458426463721,
        -2.6882686997096292,
        100000.0,
        -3969739.9418226657,
        -1933903.458017981,
        4724336.492524035,
    ],
    [
        0.3688009142636064,
        -2.344328819584306,
        -10000.0,
        -4151852.437482989,
        -4251569.3523174925,
        2281297.5050397385,
    ],
    [1.483139089615724, -3.1066334981070014, 0.0, -559895.7961199818, -19581.461953368525, 6332182.435124129],
];

/// Half a unit in the last place of 6.4e6 m on three axes is 0.8 nm; the rounding of the sines adds as much at the worst.
#[test]
fn geodetic_to_earth_fixed_is_exact_to_a_nanometre() {
    let earth = Earth::default();
    for [latitude_rad, longitude_rad, height_m, x, y, z] in EXACT {
        let r_e = earth.to_earth_fixed(&Geodetic { latitude_rad, longitude_rad, height_m });
        let error = (r_e - Vector3::new(x, y, z)).norm();
        assert!(error < 1.3e-9, "{latitude_rad} {longitude_rad} {height_m}: {error:e}");
    }
}

/// The way back: height to a nanometre, the angles to half a unit in their last place and a nanometre.
#[test]
fn earth_fixed_to_geodetic_is_exact_to_a_nanometre() {
    let earth = Earth::default();
    for [latitude_rad, longitude_rad, height_m, x, y, z] in EXACT {
        let place = earth.to_geodetic(&Vector3::new(x, y, z));
        let r = 6.5e6;
        let from_axis = x.hypot(y);
        assert!((place.height_m - height_m).abs() < 1.3e-9, "{latitude_rad}: {}", place.height_m);
        let latitude = (place.latitude_rad - latitude_rad).abs() * r;
        assert!(latitude < 1.3e-9 + f64::EPSILON * r, "{latitude_rad}: {latitude:e} m");
        if from_axis > 1.0 {
            let longitude = (place.longitude_rad - longitude_rad).abs() * from_axis;
            assert!(longitude < 1.3e-9 + 2.0 * f64::EPSILON * from_axis, "{longitude_rad}: {longitude:e} m");
        }
    }
}

/// All over the globe and at every height, on every ellipsoid, the way there and back loses a nanometre and the rounding of
/// the angles.
#[test]
fn there_and_back_again_everywhere() {
    for ellipsoid in [Ellipsoid::Wgs84, Ellipsoid::Cgcs2000, Ellipsoid::Grs80, Ellipsoid::Krassovsky1940] {
        let earth = Earth::new(ellipsoid, GravityModel::Normal);
        for i in -90..=90 {
            for height_m in [-10e3, 0.0, 1e4, 1e5] {
                let latitude_rad = f64::from(i).to_radians();
                let longitude_rad = f64::from(i * 7 % 180).to_radians();
                let r_e = earth.to_earth_fixed(&Geodetic { latitude_rad, longitude_rad, height_m });
                let back = earth.to_earth_fixed(&earth.to_geodetic(&r_e));
                assert!((back - r_e).norm() < 3e-9, "{i} {height_m}: {:e}", (back - r_e).norm());
            }
        }
    }
}

/// The vertical that is followed in one pass from position to position equals the one that is computed anew.
#[test]
fn the_followed_vertical_is_the_vertical() {
    let earth = Earth::default();
    let at = |k: i32| {
        let latitude_rad = 1.2 + 3e-7 * f64::from(k);
        earth.to_earth_fixed(&Geodetic { latitude_rad, longitude_rad: 0.5, height_m: 12e3 + f64::from(k) })
    };
    let mut track = earth.track(&at(0));
    for k in 1..1000 {
        let (followed, fresh) = (earth.follow(&mut track, &at(k)), earth.vertical(&at(k)));
        assert!((followed.up_e - fresh.up_e).norm() < 4.0 * f64::EPSILON, "{k}");
        assert!((followed.height_m - fresh.height_m).abs() < 4e-9, "{k}");
    }
}

#[test]
fn radii_of_wgs84_at_equator_and_pole() {
    let earth = Earth::default();
    let equator = earth.radii(0.0);
    let pole = earth.radii(1.0);
    // a (1 - e²) and a²/b, from the defining constants with 20 digits.
    assert!((equator.meridian_m - 6_335_439.327_292_819).abs() < 2e-9);
    assert_eq!(equator.transverse_m, 6_378_137.0);
    assert!((pole.meridian_m - 6_399_593.625_758_493).abs() < 4e-9);
    assert!((pole.transverse_m - pole.meridian_m).abs() < 2e-9);
}

fn at(earth: &Earth, latitude_deg: f64, height_m: f64) -> Vector3<f64> {
    earth.to_earth_fixed(&Geodetic { latitude_rad: latitude_deg.to_radians(), longitude_rad: 0.4, height_m })
}

#[test]
fn gravity_on_the_ellipsoid_is_the_published_one() {
    // NIMA TR8350.2 table 3.4, Moritz 2000, Chinese standard of CGCS2000.
    let mut worst: f64 = 0.0;
    for (ellipsoid, equator, pole) in [
        (Ellipsoid::Wgs84, 9.780_325_335_9, 9.832_184_937_8),
        (Ellipsoid::Grs80, 9.780_326_771_5, 9.832_186_368_5),
        (Ellipsoid::Cgcs2000, 9.780_325_336_1, 9.832_184_937_9),
    ] {
        let earth = Earth::new(ellipsoid, GravityModel::Normal);
        for (latitude, published) in [(0.0, equator), (90.0, pole)] {
            worst = worst.max((earth.gravity(&at(&earth, latitude, 0.0)).norm() - published).abs());
        }
    }
    println!("normal gravity on the ellipsoid: {worst:.1e} m/s² from the published values");
    assert!(worst < 2e-10);
}

#[test]
fn the_ellipsoid_is_a_level_surface_and_both_models_agree_on_it() {
    let normal = Earth::new(Ellipsoid::Wgs84, GravityModel::Normal);
    let somigliana = Earth::new(Ellipsoid::Wgs84, GravityModel::Somigliana);
    for latitude in [-90.0, -45.0, -1e-9, 0.0, 30.0, 60.0, 89.999_999, 90.0] {
        let r_e = at(&normal, latitude, 0.0);
        let difference = (normal.gravity(&r_e) - somigliana.gravity(&r_e)).norm();
        println!("closed form less Somigliana's formula at {latitude}°: {difference:.1e} m/s²");
        assert!(difference < 1e-14 * 9.8 * 4.0);
    }
}

#[test]
fn north_component_at_height_is_the_one_that_most_tools_miss() {
    // 8 and 16.6 micro-g at 10 and 20 km, 45° (curvature of the plumb line).
    let earth = Earth::default();
    for (height, micro_g) in [(10_000.0, 8.0), (20_000.0, 16.6)] {
        let r_e = at(&earth, 45.0, height);
        let (_, north, _) = earth.east_north_up(&earth.to_geodetic(&r_e));
        let component = earth.gravity(&r_e).dot(&north) / 9.806_65e-6;
        assert!((component + micro_g).abs() < 0.4, "{component}");
    }
}

/// Compares the gradient with central differences of the field. Errors: the truncated harmonics (1e-6) and, in the
/// differences, d²/r² of the third derivative and the rounding 1e-15/d.
#[test]
fn gradient_is_the_derivative_of_gravity() {
    for model in [GravityModel::Normal, GravityModel::Somigliana] {
        let earth = Earth::new(Ellipsoid::Wgs84, model);
        for (latitude, height) in [(0.0, 0.0), (39.9, 10_000.0), (-62.0, -300.0), (90.0, 5e4)] {
            let r_e = at(&earth, latitude, height);
            let gradient = earth.gravity_gradient(&r_e);
            let d = 2_000.0;
            for axis in 0..3 {
                let mut step = Vector3::zeros();
                step[axis] = d;
                let difference = (earth.gravity(&(r_e + step)) - earth.gravity(&(r_e - step))) / (2.0 * d);
                let error = (gradient.column(axis) - difference).norm();
                assert!(error < 1.5e-12 * 2.0, "{model:?} {latitude} {axis}: {error:e}");
            }
        }
    }
}
