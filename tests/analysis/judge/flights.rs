//! Good flights: embedded scenes, logs of a flight dynamics simulator, and vehicles that do not fly like aeroplanes.

use nalgebra::Vector3;
use sins::earth::{Earth, Geodetic};
use sins::math::Euler;
use sins::scene::{BUILTIN_SCENES, builtin};
use sins::truth::FlightSample;

use crate::support::{DEG, Table};

pub type Samples = Vec<FlightSample>;

/// A good flight at its own rate.
pub struct Good {
    pub name: String,
    pub rate_hz: f64,
    pub samples: Samples,
}

/// The most of a flight that is judged [s].
const LONGEST_S: f64 = 1200.0;

/// The embedded scene `name` at a rate, its first 20 minutes.
pub fn scene(name: &str, rate_hz: f64) -> Good {
    let scene = builtin(name).unwrap();
    let flight = scene.flight().unwrap();
    let count = (flight.duration_s().min(LONGEST_S) * rate_hz).floor() as usize + 1;
    let samples = (0..count).map(|k| flight.sample_at(k as f64 / rate_hz).unwrap()).collect();
    Good { name: name.to_owned(), rate_hz, samples }
}

/// A log of the examples.
pub fn log(name: &str) -> Good {
    let samples = Table::csv(&format!("c_examples/flights/{name}.csv")).samples(false);
    let rate_hz = 1.0 / (samples[1].time_s - samples[0].time_s);
    Good { name: name.to_owned(), rate_hz, samples }
}

/// Motion in a plane about a place: velocity, height and attitude of a time.
pub fn vehicle(name: &str, rate_hz: f64, motion: impl Fn(f64) -> (Vector3<f64>, Euler)) -> Good {
    let earth = Earth::default();
    let mut place = Geodetic { latitude_rad: 48.0 * DEG, longitude_rad: 11.0 * DEG, height_m: 500.0 };
    // Simpson's rule over each interval, on the ellipsoid.
    let rate = |place: &Geodetic, v: &Vector3<f64>| {
        let radii = earth.radii(place.latitude_rad.sin());
        let (east, north) = (radii.transverse_m + place.height_m, radii.meridian_m + place.height_m);
        Vector3::new(v.y / north, v.x / (east * place.latitude_rad.cos()), v.z)
    };
    let moved = |place: &Geodetic, change: Vector3<f64>| Geodetic {
        latitude_rad: place.latitude_rad + change.x,
        longitude_rad: place.longitude_rad + change.y,
        height_m: place.height_m + change.z,
    };
    let t = 1.0 / rate_hz;
    let mut samples = Vec::new();
    for k in 0..(600.0 * rate_hz) as usize {
        let time_s = k as f64 * t;
        let (v_n, euler) = motion(time_s);
        samples.push(FlightSample {
            time_s,
            place,
            v_n: Some(v_n),
            euler,
            omega_ib_b: None,
            f_b: None,
            temperature_c: None,
        });
        let [middle, end] = [motion(time_s + 0.5 * t).0, motion(time_s + t).0];
        let first = rate(&place, &v_n);
        let half = rate(&moved(&place, first * (0.5 * t)), &middle);
        let whole = rate(&moved(&place, half * t), &end);
        place = moved(&place, (first + half * 4.0 + whole) * (t / 6.0));
    }
    Good { name: name.to_owned(), rate_hz, samples }
}

/// From 0 to 1 within a time, smoothly.
fn eased(t: f64, begin_s: f64, end_s: f64) -> f64 {
    let x = ((t - begin_s) / (end_s - begin_s)).clamp(0.0, 1.0);
    x * x * x * (10.0 - 15.0 * x + 6.0 * x * x)
}

/// It rests, climbs by 60 m over one place, flies a leg, hovers, flies another, and descends over the last place.
pub fn drone_over_one_place(rate_hz: f64) -> Good {
    vehicle("drone over one place", rate_hz, |t| {
        let leg = |begin_s: f64, end_s: f64| eased(t, begin_s, begin_s + 6.0) - eased(t, end_s - 6.0, end_s);
        let speed = 8.0 * leg(40.0, 120.0) + 6.0 * leg(200.0, 300.0);
        let up = 4.0 * (leg(10.0, 31.0) - leg(400.0, 421.0));
        let heading = 0.5 + 2.0 * eased(t, 130.0, 150.0);
        (
            Vector3::new(speed * heading.sin(), speed * heading.cos(), up),
            Euler { roll: 0.0, pitch: -0.01 * speed, heading },
        )
    })
}

/// Its climb is that of the air, and its nose hardly follows: by pitch alone, its height could be in feet.
pub fn glider_in_thermals(rate_hz: f64) -> Good {
    vehicle("glider in thermals", rate_hz, |t| {
        let climb =
            3.0 * (eased(t, 40.0, 55.0) - eased(t, 180.0, 195.0)) + 4.0 * eased(t, 300.0, 315.0) - 1.5;
        let turn = 0.25 * (eased(t, 40.0, 46.0) - eased(t, 180.0, 186.0) + eased(t, 300.0, 306.0));
        let heading = 0.25 * (t - 43.0).clamp(0.0, 140.0) + 0.25 * (t - 303.0).max(0.0);
        let v = Vector3::new(27.0 * heading.sin() + 6.0, 27.0 * heading.cos() - 3.0, climb);
        (v, Euler { roll: (27.0 * turn / 9.81).atan(), pitch: 0.05 + 0.3 * climb / 27.0, heading })
    })
}

/// It turns to both sides by up to an angle \[rad\] and 0.065 rad/s, at a speed in a wind of a time \[m/s\].
fn aeroplane_in_turns(rate_hz: f64, by: f64, speed: f64, wind: impl Fn(f64) -> [f64; 2]) -> Good {
    vehicle("aeroplane in the wind", rate_hz, |t| {
        let phase = 0.065 / by * t;
        let (heading, turn) = (0.4 + by * phase.sin(), 0.065 * phase.cos());
        let [east, north] = wind(t);
        let v = Vector3::new(speed * heading.sin() + east, speed * heading.cos() + north, 0.5);
        (v, Euler { roll: (speed * turn / 9.81).atan(), pitch: 0.05, heading })
    })
}

/// It turns to both sides in a wind of a third of its speed.
pub fn aeroplane_in_wind(rate_hz: f64) -> Good {
    aeroplane_in_turns(rate_hz, 1.3, 45.0, |_| [12.0, -9.0])
}

/// Turns of 22° to both sides: slowly in a steady wind, and faster in one that grows by 20 m/s in its ten minutes.
pub fn aeroplanes_in_little_turns(rate_hz: f64) -> [Good; 2] {
    [
        aeroplane_in_turns(rate_hz, 22.0 * DEG, 45.0, |_| [4.0, -3.0]),
        aeroplane_in_turns(rate_hz, 22.0 * DEG, 90.0, |t| [t / 30.0, 5.0]),
    ]
}

/// Vehicles that do not fly like aeroplanes, at 50 Hz.
pub fn vehicles() -> Vec<Good> {
    let level = |heading: f64| Euler { roll: 0.0, pitch: 0.0, heading };
    let forward = |speed: f64, heading: f64| Vector3::new(speed * heading.sin(), speed * heading.cos(), 0.0);
    vec![
        // Gusts move it by decimetres.
        vehicle("hover", 50.0, |t| {
            let v = Vector3::new(0.3 * (0.7 * t).sin(), 0.2 * (0.9 * t).cos(), 0.1 * (0.4 * t).sin());
            (v, Euler { roll: 0.02 * (0.7 * t).cos(), pitch: -0.02 * (0.9 * t).sin(), heading: 0.3 })
        }),
        vehicle("taxi", 50.0, |t| {
            let heading = 0.8 * (0.05 * t).sin();
            (forward(8.0, heading), level(heading))
        }),
        vehicle("car", 50.0, |t| {
            let heading = 0.02 * t + 0.4 * (0.1 * t).sin();
            (forward(25.0, heading), level(heading))
        }),
        // Its body leans out of the turns, as that of each car.
        vehicle("car that leans", 50.0, |t| {
            let (heading, turn) = (0.02 * t + 0.4 * (0.1 * t).sin(), 0.02 + 0.04 * (0.1 * t).cos());
            (forward(25.0, heading), Euler { roll: -0.15 * (25.0 * turn / 9.8), ..level(heading) })
        }),
        // It enters a bend and has not left it: the lean grows as the rate of it falls.
        vehicle("car in a bend", 50.0, |t| {
            let phase = t.min(300.0) * 0.005;
            let heading = 0.05 * (1.0 - phase.cos()) / 0.005 + 0.05 * (t - 300.0).max(0.0);
            (
                forward(25.0, heading),
                Euler { roll: -0.15 * (25.0 * 0.05 * phase.sin() / 9.8), ..level(heading) },
            )
        }),
        // 3 g upwards for half a minute, then coasting, and down by a parachute: its attitude is at the zenith.
        vehicle("rocket", 50.0, |t| {
            let up = if t < 30.0 { 30.0 * t } else { (900.0 - 9.5 * (t - 30.0)).max(-100.0) };
            (Vector3::new(0.5 * t.min(30.0), 0.0, up), Euler { roll: 0.0, pitch: 89.0 * DEG, heading: 0.0 })
        }),
        vehicle("balloon", 50.0, |t| {
            let v = Vector3::new(6.0 + (0.02 * t).sin(), 2.0 * (0.013 * t).cos(), 4.0);
            (v, Euler { roll: 0.05 * (1.1 * t).sin(), pitch: 0.05 * (1.3 * t).cos(), heading: 0.1 * t })
        }),
        vehicle("helicopter sideways", 50.0, |t| {
            let heading = 0.5 + 0.004 * t;
            (forward(15.0, heading + 90.0 * DEG), Euler { roll: 0.1, pitch: 0.03, heading })
        }),
        // Its nose points to the middle of its circle: its pitch is the bank of the turn, to either side.
        vehicle("drone that orbits", 50.0, |t| {
            let (track, pitch) = (0.16 * t, -(8.0 * 0.16 / 9.8));
            (forward(8.0, track), Euler { roll: 0.01, pitch, heading: track + 90.0 * DEG })
        }),
        drone_over_one_place(50.0),
        // Its heading has nothing to do with its track.
        vehicle("drone with a heading of its own", 50.0, |t| {
            let track = 1.8 * (0.11 * t).sin() + 1.1 * (0.067 * t).cos();
            let heading = 2.5 * (0.09 * t + 1.0).sin() + 0.8 * (0.05 * t).cos();
            let (bank, along) = (0.1 * (0.11 * t).cos(), track - heading);
            let euler = Euler { roll: bank * along.cos(), pitch: bank * along.sin(), heading };
            (forward(9.0 + 3.0 * (0.13 * t).sin(), track), euler)
        }),
        vehicle("drone at rest", 50.0, |_| (Vector3::zeros(), level(1.0))),
        // Turns on the spot: its heading passes through north again and again.
        vehicle("drone that pirouettes", 50.0, |t| {
            let heading = (1.5 * t) % (360.0 * DEG);
            (Vector3::new(0.1 * (0.3 * t).sin(), 0.0, 0.0), level(heading))
        }),
    ]
}

/// All good flights.
pub fn all() -> Vec<Good> {
    let scenes = BUILTIN_SCENES.iter().map(|(name, _)| scene(name, 50.0));
    let logs = ["airliner_cruise", "fighter_aerobatics"].map(log);
    scenes.chain(logs).chain(vehicles()).collect()
}

impl Good {
    /// The flight at a lower rate.
    pub fn at(&self, rate_hz: f64) -> Samples {
        let every = (self.rate_hz / rate_hz).round().max(1.0) as usize;
        self.samples.iter().step_by(every).copied().collect()
    }
}

/// The same without velocities.
pub fn without_velocities(samples: &[FlightSample]) -> Samples {
    samples.iter().map(|sample| FlightSample { v_n: None, ..*sample }).collect()
}
