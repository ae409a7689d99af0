//! The time of packets that carry none: each is a whole number n of periods T after the one before it.
//!
//! n = d·v / (v² T): d is the way between the two, v the mean of their velocities. At rest, n is 1.

use sins::earth::Earth;
use sins::truth::FlightSample;

/// Below this speed the way does not tell the time [m/s].
pub const LEAST_SPEED_M_S: f64 = 2.0;

/// Largest way that the velocity does not explain [m], and its share of the whole way. A turn in which packets were lost bends the way.
const UNEXPLAINED_M: f64 = 1.0;
const UNEXPLAINED: f64 = 0.1;

/// When a packet came after the one before it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum After {
    /// This number of periods later, from 1; 0: less than half a period.
    Periods(f64),
    /// So many periods earlier.
    Earlier(f64),
    /// The velocity does not explain the way [m].
    Jump(f64),
}

/// Compares the way between packets with their velocities.
#[derive(Debug, Clone)]
pub struct Ticks {
    earth: Earth,
    pub period_s: f64,
    /// Sums over packets in motion: ways along the velocity [m], and what the velocity explains of them in n periods [m].
    ways_m: [f64; 2],
}

impl Ticks {
    pub fn new(earth: Earth, period_s: f64) -> Self {
        Self { earth, period_s, ways_m: [0.0; 2] }
    }

    /// When `sample` came after `last`.
    pub fn after(&mut self, last: &FlightSample, sample: &FlightSample) -> After {
        let (way_e, [east, north, up]) = self.earth.displacement(&sample.place, &last.place);
        let velocity = |sample: &FlightSample| sample.v_n.unwrap_or_default();
        let mean = 0.5 * (velocity(last) + velocity(sample));
        let speed = mean.norm();
        let way = nalgebra::Vector3::new(way_e.dot(&east), way_e.dot(&north), way_e.dot(&up));
        if speed < LEAST_SPEED_M_S {
            let is_near = way.norm() < UNEXPLAINED_M;
            return if is_near { After::Periods(1.0) } else { After::Jump(way.norm()) };
        }
        let along_m = way.dot(&mean) / speed;
        let aside_m = (way - mean * (along_m / speed)).norm();
        if aside_m > UNEXPLAINED_M + UNEXPLAINED * along_m.abs() {
            return After::Jump(way.norm());
        }
        let count = (along_m / (speed * self.period_s)).round();
        if count < 0.0 {
            return After::Earlier(-count);
        }
        if count > 0.0 {
            self.ways_m[0] += along_m;
            self.ways_m[1] += speed * self.period_s * count;
        }
        After::Periods(count)
    }

    /// The period that the motion shows [s]; `None`: there was none.
    pub fn measured_s(&self) -> Option<f64> {
        let [found, explained] = self.ways_m;
        (explained > 0.0).then(|| self.period_s * found / explained)
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::Vector3;
    use sins::earth::Geodetic;
    use sins::math::Euler;

    use super::*;

    /// A level turn of 0.1 rad/s at 100 m/s, at 60 Hz.
    fn at(tick: f64) -> FlightSample {
        let (time_s, rate, speed) = (tick / 60.0, 0.1, 100.0);
        let heading = rate * time_s;
        let (sin, cos) = heading.sin_cos();
        let radius_m = 6_378_137.0 + 1000.0;
        let place = Geodetic {
            latitude_rad: speed / rate * sin / radius_m,
            longitude_rad: speed / rate * (1.0 - cos) / radius_m,
            height_m: 1000.0,
        };
        let euler = Euler { heading, ..Euler::default() };
        let v_n = Some(Vector3::new(speed * sin, speed * cos, 0.0));
        FlightSample { v_n, ..FlightSample::at_rest(0.0, place, euler) }
    }

    #[test]
    fn lost_and_early_packets_are_found_by_their_way() {
        let mut ticks = Ticks::new(Earth::default(), 1.0 / 60.0);
        for (from, to, found) in [
            (0.0, 1.0, After::Periods(1.0)),
            (100.0, 104.0, After::Periods(4.0)),
            (100.0, 220.0, After::Periods(120.0)),
            (7.0, 5.0, After::Earlier(2.0)),
            (7.0, 7.3, After::Periods(0.0)),
        ] {
            assert_eq!(ticks.after(&at(from), &at(to)), found, "{from} {to}");
        }
        let mut aside = at(11.0);
        aside.place.longitude_rad += 1e-5;
        assert!(matches!(ticks.after(&at(10.0), &aside), After::Jump(_)));
    }

    /// The meridian's radius of curvature at the equator is 0.67 % below the radius of the test's sphere.
    #[test]
    fn the_motion_shows_the_period() {
        let mut ticks = Ticks::new(Earth::default(), 1.0 / 50.0);
        for tick in 0..100 {
            assert_eq!(ticks.after(&at(f64::from(tick)), &at(f64::from(tick + 1))), After::Periods(1.0));
        }
        let measured_s = ticks.measured_s().unwrap();
        assert!((measured_s * 60.0 - 1.0).abs() < 0.008, "{measured_s}");
    }

    #[test]
    fn at_rest_each_packet_is_a_period() {
        let mut ticks = Ticks::new(Earth::default(), 0.1);
        let rest = FlightSample::at_rest(0.0, Geodetic::default(), Euler::default());
        assert_eq!(ticks.after(&rest, &rest), After::Periods(1.0));
        assert_eq!(ticks.measured_s(), None);
        let mut moved = rest;
        moved.place.latitude_rad = 1e-6;
        assert!(matches!(ticks.after(&rest, &moved), After::Jump(_)));
    }
}
