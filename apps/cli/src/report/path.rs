//! A recorded path on a plane around the start, with the curve between records that are far apart.

use std::ops::Range;

use sins::earth::{Earth, Ellipsoid, Geodetic, GravityModel};

use crate::drawing::series::range;
use crate::report::run::Places;

/// Mean radius of the Earth [m], for the length of an arc from its chord.
const EARTH_RADIUS_M: f64 = 6.371e6;

/// Ratio of the extent of a path to the smallest detail that is drawn.
pub const RESOLUTION: f64 = 2000.0;

/// Largest number of parts of the curve between two records.
const MOST_PARTS: usize = 32;

/// Smallest and largest ratio of the distance of two records to the way between them at which the curve is drawn. A vehicle that comes
/// back in between has flown another way; a longer distance contradicts the velocities, and is drawn straight.
const CURVED: (f64, f64) = (0.35, 1.1);

/// Distance below which a vehicle stands [m].
const STANDS_M: f64 = 10.0;

/// A point of a path: time since the start [s], east and north of the start, height [m].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Point {
    pub time_s: f64,
    pub east_m: f64,
    pub north_m: f64,
    pub height_m: f64,
}

/// A path, in pieces: between two pieces the records do not say where the vehicle was.
#[derive(Debug, Default)]
pub struct Path {
    pub points: Vec<Point>,
    pub pieces: Vec<Range<usize>>,
}

impl Path {
    /// The path of the records at `time_s` [s], on a plane around the first place of `origin`.
    pub fn of(path: &Places, origin: &Places, time_s: &[f64]) -> Self {
        let (east, north) = local(path, origin, 0.0);
        // A second later by the velocity: the direction of the velocity on the plane.
        let (east_later, north_later) = local(path, origin, 1.0);
        let record = |k: usize| {
            let point =
                Point { time_s: time_s[k], east_m: east[k], north_m: north[k], height_m: path.height_m[k] };
            let velocity = [east_later[k] - east[k], north_later[k] - north[k], path.velocity_m_s[2][k]];
            (point, velocity)
        };
        let extent = extent(&east).max(extent(&north));
        let mut made = Self { points: vec![record(0).0], pieces: Vec::new() };
        let mut begin = 0;
        for k in 1..time_s.len() {
            match between(record(k - 1), record(k), extent / RESOLUTION) {
                Some(points) => made.points.extend(points),
                None => {
                    made.pieces.push(begin..made.points.len());
                    begin = made.points.len();
                }
            }
            made.points.push(record(k).0);
        }
        made.pieces.push(begin..made.points.len());
        made
    }

    /// Length of the path [m].
    pub fn length_m(&self) -> f64 {
        let way = |pair: &[Point]| (pair[1].east_m - pair[0].east_m).hypot(pair[1].north_m - pair[0].north_m);
        self.points.windows(2).map(way).sum()
    }

    /// Largest extent east or north [m].
    pub fn extent_m(&self) -> f64 {
        let of = |value: fn(&Point) -> f64| extent(&self.points.iter().map(value).collect::<Vec<_>>());
        of(|point| point.east_m).max(of(|point| point.north_m))
    }

    /// The pieces from one time to another [s].
    pub fn within(&self, from_s: f64, to_s: f64) -> impl Iterator<Item = &[Point]> {
        self.pieces.iter().filter_map(move |piece| {
            let points = &self.points[piece.clone()];
            let first = points.partition_point(|point| point.time_s < from_s);
            let last = points.partition_point(|point| point.time_s <= to_s);
            (first < last).then(|| &points[first..last])
        })
    }
}

/// The points between two records, each with its velocity [m/s], on the cubic curve with their places and velocities; `None`: the path
/// is not known. A straight line has no points.
fn between(from: (Point, [f64; 3]), to: (Point, [f64; 3]), tolerance_m: f64) -> Option<Vec<Point>> {
    let ((from, v0), (to, v1)) = (from, to);
    let t = to.time_s - from.time_s;
    let (right, up) = (to.east_m - from.east_m, to.north_m - from.north_m);
    let way = 0.5 * t * (v0[0].hypot(v0[1]) + v1[0].hypot(v1[1]));
    let ratio = right.hypot(up) / way;
    if way < STANDS_M || ratio > CURVED.1 {
        return Some(Vec::new());
    }
    // A straight line where the curve is as good as straight, though the speeds at the records are not those in between.
    let sag = t / 8.0 * (v1[0] - v0[0]).hypot(v1[1] - v0[1]);
    if ratio < CURVED.0 {
        return (sag < tolerance_m).then(Vec::new);
    }
    let sag = sag.max(t / 8.0 * (v1[2] - v0[2]).abs());
    let parts = ((sag / tolerance_m).sqrt().ceil() as usize).clamp(1, MOST_PARTS);
    let cubic = |u: f64, p0: f64, p1: f64, v0: f64, v1: f64| {
        let (a, b) = (u * u * (3.0 - 2.0 * u), u * (1.0 - u));
        p0 + a * (p1 - p0) + t * b * ((1.0 - u) * v0 - u * v1)
    };
    let at = |part: usize| {
        let u = part as f64 / parts as f64;
        Point {
            time_s: from.time_s + u * t,
            east_m: cubic(u, from.east_m, to.east_m, v0[0], v1[0]),
            north_m: cubic(u, from.north_m, to.north_m, v0[1], v1[1]),
            height_m: cubic(u, from.height_m, to.height_m, v0[2], v1[2]),
        }
    };
    Some((1..parts).map(at).collect())
}

/// Distances east and north [m] from the first place of `origin`, in the azimuthal equidistant projection, so that tracks over a
/// pole or over the date line stay connected; `later_s` [s] later by the velocity of each record.
pub fn local(path: &Places, origin: &Places, later_s: f64) -> (Vec<f64>, Vec<f64>) {
    let earth = Earth::new(Ellipsoid::Wgs84, GravityModel::Normal);
    let height_m = origin.height_m[0];
    let place = |path: &Places, record: usize| Geodetic {
        latitude_rad: path.latitude_rad[record],
        longitude_rad: path.longitude_rad[record],
        height_m,
    };
    let start = place(origin, 0);
    let start_e = earth.to_earth_fixed(&start);
    let (east, north, _) = earth.east_north_up(&start);
    (0..path.latitude_rad.len())
        .map(|record| {
            let here = place(path, record);
            let (own_east, own_north, _) = earth.east_north_up(&here);
            let [v_east, v_north, _] = path.velocity_m_s.each_ref().map(|axis| axis[record] * later_s);
            let place_e = earth.to_earth_fixed(&here) + own_east * v_east + own_north * v_north;
            let chord = place_e - start_e;
            let (x, y) = (chord.dot(&east), chord.dot(&north));
            let level = x.hypot(y);
            let half = chord.norm() / (2.0 * EARTH_RADIUS_M);
            let arc = 2.0 * EARTH_RADIUS_M * half.min(1.0).asin();
            let stretch = if level > 0.0 { arc / level } else { 0.0 };
            (x * stretch, y * stretch)
        })
        .unzip()
}

fn extent(values: &[f64]) -> f64 {
    range(values.iter().copied()).map_or(0.0, |(low, high)| high - low)
}

#[cfg(test)]
pub mod tests {
    use super::*;

    /// Places without velocities.
    pub fn places(places: &[(f64, f64)]) -> Places {
        let (latitude_rad, longitude_rad) =
            places.iter().map(|(l, o)| (l.to_radians(), o.to_radians())).unzip();
        let zeros = || vec![0.0; places.len()];
        Places { latitude_rad, longitude_rad, height_m: zeros(), velocity_m_s: [zeros(), zeros(), zeros()] }
    }

    #[test]
    fn a_minute_of_latitude_is_a_nautical_mile() {
        let path = places(&[(45.0, 10.0), (45.0 + 1.0 / 60.0, 10.0)]);
        let (east, north) = local(&path, &path, 0.0);
        // Meridian radius at 45°: 6 367 382 m.
        assert!(
            (north[1] - 6_367_382.0 / 10_800.0 * std::f64::consts::PI).abs() < 0.01 && east[1].abs() < 1e-6
        );
    }

    #[test]
    fn a_track_over_the_pole_is_straight() {
        let path = places(&[(89.0, 30.0), (89.0, -150.0)]);
        let (east, north) = local(&path, &path, 0.0);
        assert!(
            (north[1] - 2.0 * 111_694.0).abs() < 300.0 && east[1].abs() < 1e-3,
            "{} {}",
            east[1],
            north[1]
        );
    }

    /// A circle of 1 km at 10 m/s, `step` [rad] from record to record.
    fn circle(step: f64, records: usize) -> (Places, Vec<f64>) {
        let angles: Vec<f64> = (0..records).map(|k| k as f64 * step).collect();
        let metre = (1.0 / 6_335_439.0_f64).to_degrees();
        let equator = (1.0 / 6_378_137.0_f64).to_degrees();
        let at: Vec<(f64, f64)> =
            angles.iter().map(|a| (1000.0 * a.sin() * metre, 1000.0 * a.cos() * equator)).collect();
        let mut path = places(&at);
        path.velocity_m_s[0] = angles.iter().map(|a| -10.0 * a.sin()).collect();
        path.velocity_m_s[1] = angles.iter().map(|a| 10.0 * a.cos()).collect();
        (path, angles.iter().map(|a| a * 100.0).collect())
    }

    /// The cubic curve leaves a circle by (1 - cos) of a fourth-order error: with 8 records a turn by 4e-4 of the radius.
    #[test]
    fn records_that_are_far_apart_are_joined_by_a_curve() {
        let step = std::f64::consts::TAU / 8.0;
        let (path, time_s) = circle(step, 20);
        let made = Path::of(&path, &path, &time_s);
        assert_eq!(made.pieces.len(), 1);
        assert!(made.points.len() > 100, "{}", made.points.len());
        for point in &made.points {
            let radius = (point.east_m + 1000.0).hypot(point.north_m);
            assert!((radius - 1000.0).abs() < 1.0, "{point:?} {radius}");
        }
        assert!(made.points.windows(2).all(|pair| pair[0].time_s < pair[1].time_s));
        let part = made.within(time_s[2], time_s[3]).next().unwrap();
        assert_eq!((part[0].time_s, part[part.len() - 1].time_s), (time_s[2], time_s[3]));
    }

    #[test]
    fn between_records_that_are_too_far_apart_there_is_no_line() {
        let (path, time_s) = circle(0.93 * std::f64::consts::TAU, 20);
        let made = Path::of(&path, &path, &time_s);
        assert_eq!(made.pieces.len(), 20);
        assert!(made.points.len() == 20 && made.within(0.0, 1e9).all(|piece| piece.len() == 1));
        // Without velocities, and at rest, there are straight lines.
        let still = places(&[(45.0, 10.0), (45.1, 10.0), (45.1, 10.0)]);
        assert_eq!(Path::of(&still, &still, &[0.0, 10.0, 20.0]).within(0.0, 20.0).count(), 1);
    }
}
