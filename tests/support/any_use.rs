//! Random hosts that keep the rules: options, realistic and absurd sensors, gaps, samples in the queue, failures, jumps and
//! increments, up to the ends of their ranges. The same seed gives the same host.

use nalgebra::{Matrix3, Vector3};
use sins::Options;
use sins::earth::Geodetic;
use sins::earth::state::{BodyAxes, Navigation, StateErrors};
use sins::errors::correction::{Compensation, Correction};
use sins::math::Euler;
use sins::mechanization::{Frame, Scheme, VerticalMode};
use sins::sensors::{
    AltimeterParameters, Axis, Failure, GravityDisturbanceParameters, GravityField, InitialErrorParameters,
    SensorOutput, TriadParameters,
};
use sins::signal::Increment;
use sins::signal::mounting::MountingParameters;
use sins::truth::{FlightSample, IntakeLimits};

use super::draws::Draws;
use super::moments::Call;

impl Draws {
    /// 0 in four of eight cases, `usual` in three, and up to `end` in one.
    fn size(&mut self, usual: f64, end: f64) -> f64 {
        match self.below(8) {
            0..4 => 0.0,
            4..7 => usual,
            _ => self.within(0.0, end),
        }
    }

    fn sizes(&mut self, usual: f64, end: f64) -> Vector3<f64> {
        Vector3::from_fn(|_, _| self.size(usual, end))
    }

    fn signed(&mut self, usual: f64, end: f64) -> Vector3<f64> {
        Vector3::from_fn(|_, _| self.size(usual, end) * self.of(&[-1.0, 1.0]))
    }

    fn matrix(&mut self, usual: f64, end: f64) -> Matrix3<f64> {
        Matrix3::from_fn(|_, _| self.size(usual, end) * self.of(&[-1.0, 1.0]))
    }
}

/// A host, the options of its simulator, and the motion of its vehicle.
pub struct Host {
    draws: Draws,
    pub options: Options,
    /// Whether the sensor errors go up to the ends of their ranges.
    absurd: bool,
    with_velocity: bool,
    with_rates: bool,
    with_force: bool,
    temperature_c: Option<f64>,
    period_s: f64,
    time_s: f64,
    place: Geodetic,
    v_n: Vector3<f64>,
    /// Amplitude [rad] and angular frequency [rad/s] of the rolling.
    roll: (f64, f64),
    waiting: usize,
    navigates: bool,
}

const QUARTER: f64 = std::f64::consts::FRAC_PI_2;

impl Host {
    pub fn new(seed: u64) -> Self {
        let mut draws = Draws::new(seed);
        let max_gap_s: f64 = draws.of(&[2.5, 2.5, 100.0, 1e3]);
        let period_s: f64 = draws.of(&[5e-5, 1e-3, 0.01, 0.01, 0.1, 1.0, 2.5, max_gap_s]);
        let closed_loop_time_s = draws.one_in(4).then_some((4.0 * max_gap_s).max(30.0));
        let options = Options {
            frame: draws.of(&[Frame::EarthFixed, Frame::Geographic]),
            scheme: draws.of(&[Scheme::Exact, Scheme::Paper, Scheme::Polynomial]),
            subsamples: 1 + draws.below(5),
            updates_per_sample: draws.of(&[1, 1, 1, 2, 3, 16]),
            vertical: draws.of(&[VerticalMode::Damped, VerticalMode::FollowTruth, VerticalMode::Free]),
            error_model: draws.one_in(2),
            axes: draws.of(&[BodyAxes::RightForwardUp, BodyAxes::ForwardRightDown]),
            closed_loop_time_s,
            intake: IntakeLimits {
                max_gap_s,
                max_acceleration_m_s2: draws.of(&[2000.0, 1e6]),
                period_s: draws.one_in(3).then_some(period_s),
            },
            truth_summary: draws.one_in(2),
            covariance: draws.one_in(3),
            ..Default::default()
        };
        Self {
            options,
            absurd: draws.one_in(2),
            with_velocity: !draws.one_in(5),
            with_rates: draws.one_in(2),
            with_force: draws.one_in(4),
            temperature_c: draws.one_in(2).then(|| draws.of(&[20.0, -60.0, 85.0])),
            period_s,
            time_s: draws.of(&[0.0, 1_700_000_000.123_456_7, -1e10, 9.9e9]),
            place: Geodetic {
                latitude_rad: draws.of(&[0.0, 0.7, -1.2, 1.5607, QUARTER]),
                longitude_rad: draws.of(&[2.0, -3.1]),
                height_m: draws.of(&[0.0, 1e4, -20e3, 2000e3]),
            },
            v_n: Vector3::from_fn(|axis, _| {
                let most = if axis == 2 { 0.0 } else { 300.0 };
                draws.of(&[0.0, 1.0]) * draws.within(-most, most)
            }),
            roll: (draws.of(&[0.0, 0.1, 0.63, 0.7]), draws.of(&[1.0, std::f64::consts::TAU, 20.0])),
            waiting: 0,
            navigates: draws.one_in(8),
            draws,
        }
    }

    /// The next call.
    pub fn call(&mut self) -> Call {
        if self.navigates {
            return self.call_of_a_navigator();
        }
        match self.draws.below(40) {
            0 => Call::Gyro(self.gyro()),
            1 => Call::Accel(self.accel()),
            2 => Call::Altimeter(self.altimeter()),
            3 => self.failure(),
            4 if self.draws.one_in(3) => {
                self.waiting = 1;
                self.time_s += self.period_s;
                Call::Reposition(self.sample())
            }
            5 if self.draws.one_in(2) => self.jump(),
            5 if self.draws.one_in(6) => {
                self.waiting = 0;
                Call::Reset
            }
            6 if self.draws.one_in(2) => self.correction(),
            6 => Call::Initial(self.initial()),
            7 => Call::Mounting(self.mounting()),
            8 => Call::Gravity(self.gravity()),
            9..25 if self.waiting > 0 => {
                self.waiting -= 1;
                Call::Step
            }
            _ => {
                self.waiting += 1;
                self.move_on();
                Call::Push(self.sample())
            }
        }
    }

    /// A pause, or a slew.
    fn jump(&mut self) -> Call {
        if self.draws.one_in(2) {
            self.time_s =
                self.draws.of(&[0.0, 1_700_000_000.123_456_7, -9.9e9, 9.9e9, self.time_s + 1.0, -1e10]);
            return Call::MoveTime(self.time_s);
        }
        self.waiting = 0;
        self.time_s += self.period_s;
        self.place.latitude_rad = self.draws.of(&[0.0, 0.7, -1.2, 1.5607, QUARTER, -1.5697]);
        self.place.longitude_rad = self.draws.of(&[2.0, -3.1]);
        self.place.height_m = self.draws.of(&[0.0, 1e4, -20e3, 2000e3, self.place.height_m]);
        Call::MoveTruth(self.sample())
    }

    fn call_of_a_navigator(&mut self) -> Call {
        let draws = &mut self.draws;
        match draws.below(20) {
            0 => Call::Gyro(self.gyro()),
            1 => Call::Accel(self.accel()),
            2 => self.failure(),
            4 if draws.one_in(2) => self.correction(),
            4 => self.jump(),
            3 => {
                let q_nb = sins::math::attitude_from_euler(&Euler { roll: 0.3, pitch: -0.1, heading: 2.0 });
                let start = Navigation::new(self.place, self.v_n, q_nb, self.options.axes);
                Call::Start(self.time_s, Box::new(start))
            }
            _ => {
                let increments = (0..=draws.below(5)).map(|_| Increment {
                    angle: Vector3::from_fn(|_, _| draws.within(-0.3, 0.3)),
                    velocity: Vector3::from_fn(|_, _| draws.within(-20.0, 20.0)),
                });
                let increments = increments.collect();
                Call::Imu(increments, self.period_s.min(10.0))
            }
        }
    }

    /// Moves to the next sample: mostly by the period, sometimes by a gap up to the longest allowed one.
    fn move_on(&mut self) {
        let most = self.options.intake.max_gap_s;
        let gap = match self.draws.below(20) {
            // The rounding of stamps is added, which the library accepts.
            0 => most + 2.0 * f64::EPSILON * self.time_s.abs(),
            1 => self.draws.within(0.0, most),
            2 => 1.0,
            _ => self.period_s,
        };
        let dt = match self.options.intake.period_s {
            Some(period_s) => (gap / period_s).round().max(1.0) * period_s,
            None => gap.max(5e-5),
        };
        self.time_s += dt;
        if self.time_s.abs() > 9.99e9 {
            self.time_s = self.time_s.signum() * 9.99e9 + dt;
        }
        let radius = 6.37e6 + self.place.height_m;
        let cos = self.place.latitude_rad.cos().max(1e-6);
        self.place.latitude_rad += self.v_n.y * dt / radius;
        self.place.longitude_rad += self.v_n.x * dt / (radius * cos);
        if self.draws.one_in(30) {
            self.v_n.x += self.draws.within(-5.0, 5.0);
        }
    }

    fn sample(&mut self) -> FlightSample {
        let (amplitude, frequency) = self.roll;
        // Near the ends of the range, the rounding of the time stamp alone makes the roll jump by a degree.
        let phase = frequency * self.time_s;
        let roll = amplitude * phase.sin();
        let roll_rate = amplitude * frequency * phase.cos();
        let along = match self.options.axes {
            BodyAxes::RightForwardUp => Vector3::y(),
            BodyAxes::ForwardRightDown => Vector3::x(),
        };
        FlightSample {
            time_s: self.time_s,
            place: self.place,
            v_n: self.with_velocity.then_some(self.v_n),
            euler: Euler { roll, pitch: 0.1, heading: 1.0 },
            omega_ib_b: self.with_rates.then_some(along * roll_rate),
            f_b: self.with_force.then(|| Vector3::new(0.1, 0.2, 9.8)),
            temperature_c: self.temperature_c,
        }
    }

    fn gyro(&mut self) -> TriadParameters {
        let mut gyro = self.triad(1e-5, 100.0);
        gyro.g_sensitivity = self.draws.matrix(1e-6, if self.absurd { 1.0 } else { 1e-5 });
        gyro
    }

    fn accel(&mut self) -> TriadParameters {
        let end = if self.absurd { 1.0 } else { 1e-5 };
        let mut accel = self.triad(1e-3, 1e4);
        accel.lever_arm_m = self.draws.matrix(0.05, if self.absurd { 100.0 } else { 0.1 });
        accel.vibration_rectification_s2_m = self.draws.signed(1e-6, end);
        accel
    }

    fn triad(&mut self, usual: f64, end: f64) -> TriadParameters {
        let (absurd, with_temperature) = (self.absurd, self.temperature_c.is_some());
        let draws = &mut self.draws;
        if draws.one_in(4) {
            return TriadParameters {
                bias: draws.signed(usual, if absurd { end } else { usual }),
                ..Default::default()
            };
        }
        let (end, one) = if absurd { (end, 1.0) } else { (10.0 * usual, 1e-3) };
        let mut misalignment = draws.matrix(1e-4, one);
        misalignment.set_diagonal(&Vector3::zeros());
        let thermal = if with_temperature { 1e-3 } else { 0.0 };
        TriadParameters {
            bias: draws.signed(usual, end),
            bias_sigma: draws.sizes(usual, end),
            markov_sigma: draws.sizes(usual, end),
            markov_time_s: Vector3::from_fn(|_, _| draws.of(&[1e-9, 0.1, 300.0, 1e15])),
            random_walk: draws.sizes(usual, end),
            rate_random_walk: draws.sizes(1e-2 * usual, end),
            ramp: draws.signed(1e-6 * usual, end),
            flicker: draws.sizes(usual, end),
            quantization: draws.sizes(1e-6, one),
            scale_factor: draws.signed(1e-4, one),
            scale_factor_asymmetry: draws.signed(1e-4, one),
            scale_factor_nonlinearity: draws.signed(1e-6, one),
            misalignment,
            range: draws.sizes(50.0, 1e6),
            bandwidth_hz: draws.sizes(50.0, 1e6).map(|f| if f == 0.0 { f } else { f + 1e-3 }),
            dead_zone: draws.sizes(usual, usual),
            reference_temperature_c: 20.0,
            bias_temperature: draws.signed(usual, end) * thermal,
            bias_temperature2: draws.signed(usual, usual) * thermal,
            scale_factor_temperature: draws.signed(1e-3, one) * thermal,
            scale_factor_temperature2: draws.signed(1e-6, 1e-6) * thermal,
            ..Default::default()
        }
    }

    fn altimeter(&mut self) -> AltimeterParameters {
        let end = if self.absurd { 1e5 } else { 10.0 };
        let draws = &mut self.draws;
        AltimeterParameters {
            bias_m: draws.size(1.0, end),
            markov_sigma_m: draws.size(1.0, end),
            markov_time_s: draws.of(&[1e-9, 60.0, 1e15]),
            noise_m: draws.size(1.0, end),
            scale_factor: draws.size(1e-3, 1e-2),
            lag_s: draws.size(0.5, 1e6),
        }
    }

    fn failure(&mut self) -> Call {
        let absurd = self.absurd;
        let draws = &mut self.draws;
        let axis = draws.of(&[Axis::X, Axis::Y, Axis::Z]);
        let (output, usual, end) = match draws.below(3) {
            0 => (SensorOutput::Gyro(axis), 1e-3, 100.0),
            1 => (SensorOutput::Accelerometer(axis), 0.1, 1e4),
            _ => (SensorOutput::Altimeter, 10.0, 1e5),
        };
        let size = if absurd { draws.size(usual, end) } else { usual };
        let interval_s = draws.of(&[1e-4, 0.05, 3.0, 1e9]);
        let failure = match draws.below(8) {
            0 => Failure::Stuck,
            1 => Failure::Dead,
            2 => Failure::BiasStep { size },
            3 => Failure::Spikes { size, interval_s, duration_s: draws.of(&[1e-9, 1e-4]) },
            4 => Failure::Noise { density: size },
            5 => Failure::DropOuts { interval_s: 0.0, probability: 0.3 },
            6 => Failure::DropOuts { interval_s, probability: 0.0 },
            _ => return Call::Failure(output, None),
        };
        Call::Failure(output, Some(failure))
    }

    fn initial(&mut self) -> InitialErrorParameters {
        let draws = &mut self.draws;
        InitialErrorParameters {
            position_n: draws.signed(10.0, 1e4),
            velocity_n: draws.signed(0.1, 10.0),
            misalignment_n: draws.signed(1e-3, 0.5),
            ..Default::default()
        }
    }

    fn mounting(&mut self) -> MountingParameters {
        let end = if self.absurd { 100.0 } else { 5.0 };
        let draws = &mut self.draws;
        let angles = |draws: &mut Draws| Euler {
            roll: draws.size(0.01, 3.0),
            pitch: draws.size(0.01, 1.0),
            heading: draws.size(0.01, 3.0),
        };
        MountingParameters {
            lever_arm_m: draws.signed(2.0, end),
            boresight: angles(draws),
            lever_arm_error_m: draws.signed(0.01, end),
            boresight_error: angles(draws),
        }
    }

    fn correction(&mut self) -> Call {
        let share = if self.absurd { 1.0 } else { 1e-3 };
        let draws = &mut self.draws;
        Call::Correct(Box::new(Correction {
            errors: StateErrors {
                position_n: draws.signed(10.0, 1e6 * share),
                velocity_n: draws.signed(0.1, 1e4 * share),
                misalignment_n: draws.signed(1e-3, 3.0 * share),
            },
            sensors: Compensation {
                gyro_bias: draws.signed(1e-6, 100.0 * share),
                gyro_scale_factor: draws.signed(1e-4, 0.5 * share),
                accel_bias: draws.signed(1e-3, 1e4 * share),
                accel_scale_factor: draws.signed(1e-4, 0.5 * share),
            },
        }))
    }

    fn gravity(&mut self) -> GravityDisturbanceParameters {
        let draws = &mut self.draws;
        let mut field = |end: f64| GravityField {
            mean: draws.size(0.1 * end, end),
            sigma: draws.size(0.1 * end, end),
            distance_m: draws.of(&[1.0, 4e4, 1e9]),
        };
        GravityDisturbanceParameters {
            deflection_north: field(0.01),
            deflection_east: field(0.01),
            anomaly: field(0.1),
        }
    }
}
