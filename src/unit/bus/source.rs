//! What the words show, from the status and the navigation of a unit and the inputs of the host.

use nalgebra::Vector3;

use super::word::WordStatus;
use crate::base::math::{Euler, atan2, attitude_from_euler, hypot, rotate, sin_cos};
use crate::base::units::STANDARD_GRAVITY;
use crate::earth::state::BodyAxes;
use crate::unit::{State, Status, UnitNavigation};

const KNOT: f64 = 1852.0 / 3600.0;
const FOOT: f64 = 0.3048;

/// What makes a value valid.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Group {
    Always,
    Rates,
    Attitude,
    Heading,
    Position,
    Velocity,
    /// Heading and magnetic variation.
    Magnetic,
    /// Velocity and magnetic variation.
    MagneticTrack,
    /// Velocity and a wind of the host.
    Wind,
}

/// What the host knows beside the unit.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Inputs {
    /// Speed of the wind [m/s] and direction from which it blows [rad].
    pub wind: Option<(f64, f64)>,
    /// Magnetic variation, east positive [rad].
    pub variation_rad: Option<f64>,
    /// Axes of the simulator.
    pub axes: BodyAxes,
    /// Source/destination identifier, 0 to 3.
    pub source: u32,
}

/// The quantities of the words. Vectors along forward, right, down.
pub struct Source {
    pub shown: UnitNavigation,
    pub status: Status,
    inputs: Inputs,
    pub rate: Vector3<f64>,
    pub force_g: Vector3<f64>,
    /// Acceleration, east-north-up.
    pub acceleration_g: Vector3<f64>,
}

impl Source {
    pub fn new(shown: &UnitNavigation, status: &Status, inputs: &Inputs) -> Self {
        let vehicle = |vector: &Vector3<f64>| match inputs.axes {
            BodyAxes::ForwardRightDown => *vector,
            BodyAxes::RightForwardUp => Vector3::new(vector.y, vector.x, -vector.z),
        };
        let force_g = vehicle(&shown.force_b) / STANDARD_GRAVITY;
        let Euler { roll, pitch, heading } = shown.euler;
        let q_nb = attitude_from_euler(&Euler { roll, pitch, heading });
        let up_forward = Vector3::new(force_g.y, force_g.x, -force_g.z);
        let acceleration_g = rotate(&q_nb, &up_forward) - Vector3::z();
        Self {
            shown: *shown,
            status: *status,
            inputs: *inputs,
            rate: vehicle(&shown.rate_b),
            force_g,
            acceleration_g,
        }
    }

    /// Status of a word of this group.
    pub fn status_of(&self, group: Group) -> WordStatus {
        let valid = &self.shown.validity;
        let is_valid = match group {
            Group::Always => true,
            Group::Rates => valid.rates,
            Group::Attitude => valid.attitude,
            Group::Heading => valid.heading,
            Group::Position => valid.position,
            Group::Velocity => valid.velocity,
            Group::Magnetic => valid.heading && self.inputs.variation_rad.is_some(),
            Group::MagneticTrack => valid.velocity && self.inputs.variation_rad.is_some(),
            Group::Wind => valid.velocity && self.inputs.wind.is_some(),
        };
        match self.status.state {
            _ if self.status.in_test => WordStatus::FunctionalTest,
            State::Fault if group != Group::Always => WordStatus::FailureWarning,
            _ if is_valid => WordStatus::Normal,
            _ => WordStatus::NoComputedData,
        }
    }

    pub fn knots(speed_m_s: f64) -> f64 {
        speed_m_s / KNOT
    }

    fn ground_speed_m_s(&self) -> f64 {
        hypot(self.shown.v_n.x, self.shown.v_n.y)
    }

    pub fn ground_speed_kt(&self) -> f64 {
        Self::knots(self.ground_speed_m_s())
    }

    pub fn heading_deg(&self) -> f64 {
        self.shown.euler.heading.to_degrees()
    }

    /// The track; below 50 kt the heading.
    pub fn track_deg(&self) -> f64 {
        if self.ground_speed_kt() < 50.0 {
            return self.heading_deg();
        }
        atan2(self.shown.v_n.x, self.shown.v_n.y).to_degrees()
    }

    pub fn magnetic(&self, true_deg: f64) -> f64 {
        true_deg - self.inputs.variation_rad.unwrap_or(0.0).to_degrees()
    }

    /// 0 to 360.
    pub fn whole_turn(degrees: f64) -> f64 {
        let turned = degrees - 360.0 * (degrees / 360.0).floor();
        // Rounded to a tenth it would be 360.0.
        if turned >= 359.95 { 0.0 } else { turned }
    }

    pub fn wind_speed_kt(&self) -> f64 {
        self.inputs.wind.map_or(0.0, |(speed, _)| Self::knots(speed))
    }

    pub fn wind_direction_deg(&self) -> f64 {
        self.inputs.wind.map_or(0.0, |(_, direction)| direction.to_degrees())
    }

    pub fn flight_path_deg(&self) -> f64 {
        atan2(self.shown.v_n.z, self.ground_speed_m_s()).to_degrees()
    }

    /// Horizontal acceleration along a direction.
    pub fn along_g(&self, direction_deg: f64) -> f64 {
        let (sin, cos) = sin_cos(direction_deg.to_radians());
        self.acceleration_g.x * sin + self.acceleration_g.y * cos
    }

    pub fn flight_path_g(&self) -> f64 {
        let speed = self.shown.v_n.norm_squared().sqrt();
        if speed > 0.0 { self.acceleration_g.dot(&self.shown.v_n) / speed } else { 0.0 }
    }

    pub fn track_rate_deg_s(&self) -> f64 {
        let (v, a) = (&self.shown.v_n, self.acceleration_g * STANDARD_GRAVITY);
        let square = v.x * v.x + v.y * v.y;
        if self.ground_speed_kt() < 50.0 { 0.0 } else { ((a.x * v.y - a.y * v.x) / square).to_degrees() }
    }

    pub fn pitch_rate_deg_s(&self) -> f64 {
        let (sin, cos) = sin_cos(self.shown.euler.roll);
        (self.rate.y * cos - self.rate.z * sin).to_degrees()
    }

    pub fn roll_rate_deg_s(&self) -> f64 {
        let (sin, cos) = sin_cos(self.shown.euler.roll);
        let tan = crate::base::math::tan(self.shown.euler.pitch);
        (self.rate.x + tan * (self.rate.y * sin + self.rate.z * cos)).to_degrees()
    }

    pub fn altitude_ft(&self) -> f64 {
        self.shown.place.height_m / FOOT
    }

    pub fn vertical_ft_min(&self) -> f64 {
        self.shown.v_n.z * 60.0 / FOOT
    }

    /// Vertical speed with the change of kinetic energy.
    pub fn potential_ft_min(&self) -> f64 {
        (self.shown.v_n.z + self.shown.v_n.dot(&self.acceleration_g)) * 60.0 / FOOT
    }

    /// The bits of the word 270, from its bit 11 up.
    pub fn discretes(&self) -> f64 {
        let (status, reasons) = (&self.status, &self.status.reasons);
        let minutes = (status.to_go_s / 60.0).ceil().min(7.0) as u32;
        let alignment =
            matches!(status.state, State::CoarseAlignment | State::FineAlignment | State::Realignment);
        let bits = [
            alignment,
            matches!(status.state, State::Erection | State::Attitude),
            status.state == State::Navigation,
            status.state == State::Attitude && status.validity.heading,
            !status.validity.attitude,
            false,
            status.on_battery,
            false,
            status.fault,
            false,
            reasons.position_disagrees || reasons.latitude_disagrees || reasons.north_unknown,
            reasons.no_position,
            reasons.motion,
            false,
            reasons.latitude_too_high,
            minutes & 1 != 0,
            minutes & 2 != 0,
            minutes & 4 != 0,
            reasons.latitude_disagrees,
        ];
        f64::from(bits.iter().enumerate().map(|(at, bit)| u32::from(*bit) << at).sum::<u32>())
    }
}
