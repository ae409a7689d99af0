//! The damped vertical channel against the closed form of its three poles, in steps of any length.

use nalgebra::Vector3;
use sins::earth::{Earth, Geodetic};
use sins::math::Euler;
use sins::mechanization::{VerticalLoop, VerticalMode};
use sins::sensors::{InitialErrorParameters, TriadParameters};
use sins::truth::{FlightSample, IntakeLimits};
use sins::{ErrorSource, Options, Simulator};

use crate::support::{options_at, resting_sample};

const TAU_S: f64 = VerticalLoop::TIME_CONSTANT_S;

/// Height error of a vertical channel that started `height_m` too high, otherwise right: exp(-x) (1 - 2 x + x²/2), x = t/τ.
fn after_a_height_error(height_m: f64, time_s: f64) -> f64 {
    let x = time_s / TAU_S;
    height_m * (-x).exp() * (1.0 - 2.0 * x + 0.5 * x * x)
}

/// Height error under the accelerometer bias `a` [m/s²] since the start: a t²/2 exp(-t/τ).
fn under_a_bias(a: f64, time_s: f64) -> f64 {
    0.5 * a * time_s * time_s * (-time_s / TAU_S).exp()
}

/// A navigator's vertical channel: the free channel in closed form, h'' = κ h + a, corrected by the loop.
struct Channel {
    height_m: f64,
    velocity_m_s: f64,
    acceleration_m_s2: f64,
    channel: VerticalLoop,
}

impl Channel {
    fn new(height_m: f64, acceleration_m_s2: f64) -> Self {
        Self { height_m, velocity_m_s: 0.0, acceleration_m_s2, channel: VerticalLoop::new() }
    }

    fn step(&mut self, t: f64) {
        let root = VerticalLoop::GRAVITY_GRADIENT.sqrt();
        let (sinh, half) = ((root * t).sinh() / root, (0.5 * root * t).sinh() / root);
        // κ h + a and its growth: cosh - 1 = 2 sinh².
        let force = VerticalLoop::GRAVITY_GRADIENT * self.height_m + self.acceleration_m_s2;
        self.height_m += self.velocity_m_s * sinh + force * 2.0 * half * half;
        let grown = 2.0 * VerticalLoop::GRAVITY_GRADIENT * half * half;
        self.velocity_m_s += self.velocity_m_s * grown + force * sinh;
        let correction = self.channel.correct(self.height_m, t);
        self.height_m += correction.height_m;
        self.velocity_m_s += correction.velocity_up_m_s;
    }
}

/// Intervals of about `t` [s] that differ by up to a factor of 9.
fn uneven(t: f64) -> impl Iterator<Item = f64> {
    (0..).map(move |k: u32| t * 3f64.powf((f64::from(k) * 2.4).sin()))
}

/// On the way d rises to 0.231 h/τ² and returns. The residual is bent by t²/12 of d more than d accounts for: the loop takes this
/// for an error of the barometer and follows it, in total 1.46 times at the most, and κ adds 3 %. A step rounds 10 m to 2e-15 m,
/// and a rate to this over t.
#[test]
fn a_height_error_goes_as_the_three_poles_in_even_and_uneven_steps() {
    for t in [1e-3, 0.01, 0.1, 1.0, 10.0] {
        let even: Vec<f64> = vec![t; (1000.0 / t).ceil() as usize];
        let uneven: Vec<f64> = uneven(t).take(even.len()).collect();
        for steps in [even, uneven] {
            let mut channel = Channel::new(10.0, 0.0);
            let (mut time_s, mut worst, mut longest) = (0.0, 0.0f64, 0.0f64);
            for &step in &steps {
                channel.step(step);
                time_s += step;
                longest = longest.max(step / TAU_S);
                worst = worst.max((channel.height_m - after_a_height_error(10.0, time_s)).abs());
            }
            println!("{t} s: {:.1e} of a height error", worst / 10.0);
            let missed = 0.231 / 12.0 * longest * longest;
            assert!(worst < 10.0 * missed * 1.46 * 1.03 + 2e-15 * steps.len() as f64, "{t} s: {worst:e} m");
        }
    }
}

/// The first interval has no residual before it, and takes all that it finds for a height error. An initial velocity error v has
/// grown evenly to v t by then, so the loop feeds back v t²/2 too much through each gain: 3/τ in height, 3/τ² in velocity, 1/τ³ in d.
/// From there the poles move the error. What is left is of the next order in t/τ, and the bend of the residual by d, which rises to
/// 0.271 v/τ, as with a height error.
#[test]
fn the_response_to_an_initial_velocity_error_is_of_second_order_in_the_interval() {
    let velocity = 1.0;
    let mut figures = Vec::new();
    for rate_hz in [1.0, 10.0, 100.0] {
        let t = 1.0 / rate_hz;
        let mut channel = Channel { velocity_m_s: velocity, ..Channel::new(0.0, 0.0) };
        let missed = velocity * t * t / TAU_S;
        let (mut worst, mut largest) = (0.0f64, 0.0f64);
        for k in 1..=(600.0 * rate_hz) as u32 {
            channel.step(t);
            let x = f64::from(k) * t / TAU_S;
            let response = velocity * TAU_S * (-x).exp() * x * (1.0 - 0.5 * x);
            let error = channel.height_m - response;
            let expected = -0.5 * missed * (-x).exp() * (3.0 - 3.0 * x + 0.5 * x * x);
            assert!(
                (error - expected).abs() < missed * (0.271 / 12.0 * 1.46 * 1.03 + 9.0 * t / TAU_S) + 1e-12,
                "{k}: {error:e} {expected:e}"
            );
            worst = worst.max(error.abs());
            largest = largest.max(response.abs());
        }
        println!("{rate_hz} Hz: {:.2e} of the largest response", worst / largest);
        assert!(
            (worst / largest / (t * t) / 6.5e-4 - 1.0).abs() < 2.0 * t / TAU_S + 0.002,
            "the header's figure"
        );
        figures.push(format!("{:.1e}", worst / largest));
    }
    println!("figure: of an initial velocity error {}", figures.join(", "));
}

/// Response to the bend of the residual by an acceleration of 1 that the loop has still to find, with its share in κ:
/// (3 λ s² + 3 λ² s + λ³ + κ s)/(s + λ)³ of the share that d has not found, exp(-x) (1 + x + x²/2).
fn to_what_is_not_found(time_s: f64) -> f64 {
    let x = time_s / TAU_S;
    let of_gradient = VerticalLoop::GRAVITY_GRADIENT * TAU_S * TAU_S * (x.powi(2) / 2.0 - x.powi(5) / 120.0);
    (-x).exp() * (3.0 * x + x.powi(3) / 6.0 - x.powi(4) / 12.0 + x.powi(5) / 120.0 + of_gradient)
}

/// An acceleration a bends the residual within an interval by a s (s - t)/2. While the loop has not found a, it takes the mean,
/// -a t²/12, for an error of the barometer's height. The first interval, without a residual before it, takes all that it finds
/// for a height error: 3/4 a t² t/τ too much correction, 9 t/τ of a t²/12, and 2 of the velocity's.
#[test]
fn the_response_to_a_bias_is_of_second_order_in_the_interval() {
    let bias = 1e-2f64;
    let mut before = None;
    let mut figures = Vec::new();
    for rate_hz in [1.0, 10.0, 100.0] {
        let t = 1.0 / rate_hz;
        let missed = bias * t * t / 12.0;
        let mut channel = Channel::new(0.0, bias);
        let mut worst = 0.0f64;
        for k in 1..=(600.0 * rate_hz) as u32 {
            channel.step(t);
            let time_s = f64::from(k) * t;
            let error = channel.height_m - under_a_bias(bias, time_s);
            let expected = -missed * to_what_is_not_found(time_s);
            assert!(
                (error - expected).abs() < missed * 11.0 * t / TAU_S + 1e-12,
                "{time_s} s: {error:e} {expected:e}"
            );
            worst = worst.max(error.abs());
        }
        // The largest response is at 2 τ.
        let share = worst / under_a_bias(bias, 2.0 * TAU_S);
        figures.push(format!("{share:.1e}"));
        if let Some(before) = before.replace(worst) {
            let order = f64::log10(before / worst);
            assert!((order - 2.0).abs() < 0.05, "order {order}");
        }
    }
    println!("figure: fractions of {} of the response, second order", figures.join(", "));
}

/// The simulator at the pole, where Coriolis has no effect. It adds the true gradient less the loop's, which acts on the response
/// to an acceleration, at most 1/λ² of it.
#[test]
fn the_simulators_response_is_that_of_the_three_poles() {
    let place = Geodetic { latitude_rad: std::f64::consts::FRAC_PI_2, longitude_rad: 0.0, height_m: 0.0 };
    let earth = Earth::default();
    let gradient = earth.gravity_gradient(&earth.to_earth_fixed(&place))[(2, 2)];
    let bias = 1e-2;
    let mut figures = Vec::new();
    for rate_hz in [1.0, 10.0, 100.0] {
        let options = Options { vertical: VerticalMode::Damped, error_model: true, ..options_at(rate_hz) };
        let mut simulator = Simulator::new(&options).unwrap();
        let up = Vector3::new(0.0, 0.0, bias);
        simulator.set_accel(&TriadParameters { bias: up, ..Default::default() }).unwrap();
        let (mut worst, mut apart) = (0.0f64, 0.0f64);
        for k in 0..=(400.0 * rate_hz) as u32 {
            let time_s = f64::from(k) / rate_hz;
            simulator.push_sample(&FlightSample::at_rest(time_s, place, Euler::default())).unwrap();
            simulator.step().unwrap();
            let [navigation, model] = [ErrorSource::Navigation, ErrorSource::Model]
                .map(|source| simulator.errors(source).unwrap().unwrap().1.position_n.z);
            worst = worst.max((navigation - under_a_bias(bias, time_s)).abs());
            apart = apart.max((navigation - model).abs());
        }
        let largest = under_a_bias(bias, 2.0 * TAU_S);
        println!(
            "{rate_hz} Hz: {:.1e} of the response, error data 1 {:.1e}",
            worst / largest,
            apart / largest
        );
        let missed = 1.3 * bias / (12.0 * rate_hz * rate_hz);
        let other_gradient = (gradient - VerticalLoop::GRAVITY_GRADIENT).abs() * TAU_S * TAU_S;
        // Height over radius is the next order of the field.
        assert!(worst < missed + largest * (other_gradient + 1.5 * largest / 6.4e6) + 4e-9, "{worst}");
        assert!(apart < largest * 1.5 * largest / 6.4e6 + 4e-9, "{apart}");
        figures.push(format!("{:.1e}", worst / largest));
    }
    println!("figure: {} with the true gradient", figures.join(", "));
}

/// Height error [m] of a navigator that starts `height_m` too high, after 100 time constants at rest, 60 intervals at the least.
fn left_at_rest(interval_s: f64, updates_per_sample: usize, height_m: f64) -> f64 {
    let intake = IntakeLimits { max_gap_s: interval_s, ..Default::default() };
    let options = Options { intake, updates_per_sample, ..Default::default() };
    let mut simulator = Simulator::new(&options).unwrap();
    let position_n = Vector3::new(0.0, 0.0, height_m);
    simulator.set_initial_errors(&InitialErrorParameters { position_n, ..Default::default() }).unwrap();
    for k in 0..=(100.0 * TAU_S / interval_s).max(60.0) as u32 {
        simulator.push_sample(&resting_sample(f64::from(k) * interval_s)).unwrap();
        simulator.step().unwrap();
    }
    simulator.errors(ErrorSource::Navigation).unwrap().unwrap().1.position_n.z
}

/// Up to the longest interval that a sample may end, flown in one update or in 16, the loop forgets a height error, except for
/// the swing in the east that Coriolis makes of it, 2 W cos L · 10 m. This swing comes back as 2 W cos L of itself over λ².
#[test]
fn the_loop_is_stable_at_any_interval() {
    let coriolis = 2.0 * 7.292_115e-5 * 39.9f64.to_radians().cos() * TAU_S;
    for interval_s in [1.0, 20.0, 60.0, 100.0, 300.0, 600.0, 1000.0] {
        for updates in [1, 4, 16] {
            let left = left_at_rest(interval_s, updates, 10.0) - left_at_rest(interval_s, updates, 0.0);
            println!("{interval_s} s, {updates} updates: {left:.1e} m of 10 m");
            assert!(left.abs() < 10.0 * coriolis * coriolis, "{interval_s} s, {updates} updates: {left} m");
        }
    }
}

/// After an outage the residual before it gives no rate: except for the d that was found until then, up to 1/τ² of it in a second,
/// the loop begins like a new one.
#[test]
fn an_outage_of_the_barometer_is_no_rate() {
    let (mut new, mut interrupted) = (VerticalLoop::new(), VerticalLoop::new());
    interrupted.correct(1.0, 1.0);
    interrupted.skip();
    let (expected, found) = (new.correct(60.0, 1.0), interrupted.correct(60.0, 1.0));
    assert!((found.height_m - expected.height_m).abs() < 1.0 / (TAU_S * TAU_S), "{found:?} {expected:?}");
    assert!(
        (found.velocity_up_m_s - expected.velocity_up_m_s).abs() < 1.0 / (TAU_S * TAU_S),
        "{found:?} {expected:?}"
    );
}
