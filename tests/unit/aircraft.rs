//! An aircraft with a simulator and a unit: it stands, sways, taxis and flies.

use nalgebra::Vector3;
use rand_distr::{Distribution, StandardNormal};
use sins::earth::{Earth, Geodetic};
use sins::math::Euler;
use sins::sensors::{StreamKey, TriadParameters};
use sins::truth::{FlightSample, IntakeLimits};
use sins::unit::{AlignmentKind, Mode, State, Status, Unit, UnitNavigation, UnitParameters};
use sins::{ErrorSource, Options, Simulator};

use crate::support::{DEG, DEG_PER_HOUR, G};

/// How the aircraft moves; it goes on from where it is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Motion {
    /// It stands.
    Rest,
    /// It sways in gusts: 0.1° in roll, pitch and heading, 1 cm to each side, at 0.3 Hz.
    Sway,
    /// It accelerates along its heading [m/s²], up to a speed [m/s].
    Drive { acceleration: f64, to: f64 },
    /// It turns at this rate [rad/s], banked so that no side force is felt.
    Turn(f64),
}

/// Another sensor of the aircraft: one fix a second, with white errors.
#[derive(Clone)]
pub struct Receiver {
    pub draws: rand_xoshiro::Xoshiro256PlusPlus,
    pub sigma_m: f64,
    pub sigma_m_s: f64,
}

impl Receiver {
    pub fn new(seed: u64, sigma_m: f64, sigma_m_s: f64) -> Self {
        Self { draws: rand::SeedableRng::seed_from_u64(seed), sigma_m, sigma_m_s }
    }

    pub fn errors(&mut self, sigma: f64) -> Vector3<f64> {
        Vector3::from_fn(|_, _| sigma * Distribution::<f64>::sample(&StandardNormal, &mut self.draws))
    }
}

#[derive(Clone)]
pub struct Aircraft {
    pub simulator: Simulator,
    pub receiver: Option<Receiver>,
    pub unit: Unit,
    kind: AlignmentKind,
    pub rate_hz: f64,
    samples: u64,
    place: Geodetic,
    speed: f64,
    heading: f64,
    bank: f64,
    /// How fast it can roll [rad/s].
    pub roll_rate: f64,
    is_updated: bool,
    /// The temperature is 20 °C plus this times the time [°C/s]; `None`: it is not known.
    pub warming: Option<f64>,
}

/// The gyros and accelerometers of the paper: 0.01 °/h, 0.005 °/√h, 50 µg, 10 µg/√Hz.
pub fn papers_sensors() -> (TriadParameters, TriadParameters) {
    let each = Vector3::repeat;
    let gyro = TriadParameters {
        bias: each(0.01 * DEG_PER_HOUR),
        random_walk: each(0.005 * DEG / 60.0),
        ..Default::default()
    };
    let accel = TriadParameters { bias: each(50e-6 * G), random_walk: each(10e-6 * G), ..Default::default() };
    (gyro, accel)
}

impl Aircraft {
    pub fn new(
        latitude_deg: f64,
        run: u64,
        rate_hz: f64,
        sensors: &(TriadParameters, TriadParameters),
    ) -> Self {
        let key = StreamKey { seed: 17, run };
        let intake = IntakeLimits { period_s: Some(1.0 / rate_hz), ..IntakeLimits::default() };
        let options = Options { key, intake, ..Options::default() };
        let mut simulator = Simulator::new(&options).unwrap();
        simulator.set_gyro(&sensors.0).unwrap();
        simulator.set_accel(&sensors.1).unwrap();
        let place = Geodetic { latitude_rad: latitude_deg * DEG, longitude_rad: 0.3, height_m: 100.0 };
        let unit = Unit::new(&UnitParameters::default(), Mode::Off).unwrap();
        let receiver = None;
        Self {
            simulator,
            receiver,
            unit,
            kind: AlignmentKind::default(),
            rate_hz,
            samples: 0,
            place,
            speed: 0.0,
            heading: 0.7,
            bank: 0.0,
            roll_rate: f64::INFINITY,
            is_updated: true,
            warming: None,
        }
    }

    pub fn ideal(latitude_deg: f64) -> Self {
        Self::new(latitude_deg, 0, 10.0, &Default::default())
    }

    /// Moves for `seconds` and returns what the unit reports in the end.
    pub fn go(&mut self, motion: Motion, seconds: f64) -> Status {
        let end = self.samples + (seconds * self.rate_hz).round() as u64;
        while self.samples < end {
            self.step(motion);
        }
        self.unit.status()
    }

    /// Moves until the unit is in `state`; returns after how long [s].
    pub fn until(&mut self, motion: Motion, state: State, at_most_s: f64) -> f64 {
        let start = self.samples;
        while self.unit.status().state != state {
            self.step(motion);
            let seconds = (self.samples - start) as f64 / self.rate_hz;
            assert!(seconds <= at_most_s, "{:?} after {seconds} s", self.unit.status());
        }
        (self.samples - start) as f64 / self.rate_hz
    }

    pub fn stand(&mut self, seconds: f64) -> Status {
        self.go(Motion::Rest, seconds)
    }

    /// ALIGN at rest, with the true position, until the unit is ready.
    pub fn align(&mut self) {
        self.unit.select(Mode::Align);
        self.stand(20.0);
        self.enter_true_position();
        self.until(Motion::Rest, State::Ready, 2000.0);
    }

    pub fn enter_true_position(&mut self) {
        self.unit.enter_position(self.place.latitude_rad, self.place.longitude_rad).unwrap();
    }

    pub fn place(&self) -> Geodetic {
        self.place
    }

    pub fn speed(&self) -> f64 {
        self.speed
    }

    /// How the unit aligns.
    pub fn kind(&self) -> AlignmentKind {
        self.kind
    }

    pub fn set_alignment(&mut self, kind: AlignmentKind) {
        self.kind = kind;
        self.unit.set_alignment(kind);
    }

    pub fn heading(&self) -> f64 {
        self.heading
    }

    pub fn errors(&self) -> sins::errors::NavigationErrors {
        self.simulator.errors(ErrorSource::Navigation).unwrap().unwrap().1
    }

    pub fn navigation(&self) -> UnitNavigation {
        self.unit.navigation(&self.simulator).unwrap()
    }

    fn roll_to(&mut self, bank: f64, dt: f64) {
        let most = self.roll_rate * dt;
        self.bank += (bank - self.bank).clamp(-most, most);
    }

    /// A step of the simulator alone.
    pub fn step_without_update(&mut self, motion: Motion) {
        self.is_updated = false;
        self.step(motion);
        self.is_updated = true;
    }

    fn step(&mut self, motion: Motion) {
        let dt = 1.0 / self.rate_hz;
        let time_s = self.samples as f64 * dt;
        self.samples += 1;
        let before = self.speed;
        let mut euler = Euler { roll: self.bank, pitch: 0.0, heading: self.heading };
        let (mut place, mut sway) = (self.place, Vector3::zeros());
        let earth = Earth::default();
        let east_north = |place: &Geodetic, v_n: Vector3<f64>| {
            let (east, north, _) = earth.east_north_up(place);
            let r_e = earth.to_earth_fixed(place) + east * v_n.x + north * v_n.y;
            Geodetic { height_m: place.height_m, ..earth.to_geodetic(&r_e) }
        };
        match motion {
            Motion::Rest => self.bank = 0.0,
            Motion::Sway => {
                let omega = std::f64::consts::TAU * 0.3;
                let (sin, cos) = (omega * time_s).sin_cos();
                let (angle, size) = (0.1 * DEG * sin, 0.01);
                euler = Euler { roll: euler.roll + angle, pitch: angle, heading: euler.heading + angle };
                place = east_north(&place, Vector3::new(size * sin, size * sin, 0.0));
                sway = Vector3::new(size * omega * cos, size * omega * cos, 0.0);
            }
            Motion::Drive { acceleration, to } => {
                let change = (to - self.speed).clamp(-acceleration * dt, acceleration * dt);
                self.speed += change;
                self.roll_to(0.0, dt);
            }
            Motion::Turn(rate) => {
                self.heading += rate * dt;
                self.roll_to((rate * self.speed / G).atan(), dt);
            }
        }
        if motion == Motion::Rest {
            self.speed = 0.0;
        }
        let direction = Vector3::new(self.heading.sin(), self.heading.cos(), 0.0);
        let mean = direction * (0.5 * (before + self.speed));
        self.place = east_north(&self.place, mean * dt);
        if motion != Motion::Sway {
            place = self.place;
            euler = Euler { roll: self.bank, pitch: 0.0, heading: self.heading };
        }
        let sample = FlightSample {
            time_s,
            place,
            v_n: Some(direction * self.speed + sway),
            euler,
            temperature_c: self.warming.map(|rate| 20.0 + rate * time_s),
            ..Default::default()
        };
        self.simulator.push_sample(&sample).unwrap();
        if self.simulator.step().unwrap() == sins::Step::Done && self.is_updated {
            self.unit.update(&mut self.simulator).unwrap();
            let is_due = (self.samples - 1).is_multiple_of(self.rate_hz.round() as u64);
            if let (Some(receiver), true) = (&mut self.receiver, is_due) {
                let metres = receiver.errors(receiver.sigma_m);
                let place = Geodetic { height_m: place.height_m + metres.z, ..east_north(&place, metres) };
                let v_n = direction * self.speed + sway + receiver.errors(receiver.sigma_m_s);
                self.unit.push_fix(&mut self.simulator, place, v_n).unwrap();
            }
        }
    }
}
