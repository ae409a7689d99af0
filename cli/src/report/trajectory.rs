//! The flown path: ground track and height.

use std::ops::Range;

use sins::earth::{Earth, Ellipsoid, Geodetic, GravityModel};

use crate::drawing::axis::Axis;
use crate::drawing::figure::Figure;
use crate::drawing::pen::Pen;
use crate::drawing::plot::{Dot, Drawing, Panel, Trace, WIDTH};
use crate::drawing::scales::{equal_axes, line, over_time, time_axis};
use crate::drawing::series::{Points, bounds, magnitude, outline, range};
use crate::failure::Failure;
use crate::report::run::{Places, Run};
use crate::units::{KILOMETRE, LENGTH, METRE, Unit, fitting, time_text, with_unit};

/// Mean radius of the Earth [m], for the length of an arc from its chord.
const EARTH_RADIUS_M: f64 = 6.371e6;

/// Smallest extents of the axes [m]: of a track at rest, and of a constant height.
const LEAST_TRACK_M: f64 = 1.0;
const LEAST_HEIGHT_M: f64 = 10.0;

/// Ratio of the extent of a track to the smallest detail that is drawn.
const TRACK_RESOLUTION: f64 = 2000.0;

/// A path of the truth that is longer than its extent times this ratio covers the same ground repeatedly. Then only its first and
/// last [`SHOWN`] extents of path are drawn.
const REPEATS: f64 = 20.0;
const SHOWN: f64 = 4.0;

/// East and north [m].
type Track = (Vec<f64>, Vec<f64>);

/// Ground track, and height over time.
pub fn figure(run: &Run) -> Result<Figure, Failure> {
    let (truth, navigation) = (local(&run.truth, &run.truth), local(&run.navigation, &run.truth));
    let stretch_s = stretch_s(run.duration_s(), &truth);
    let mut legend = vec![(Pen::Reference, "truth".to_owned()), (Pen::Computed, "navigation".to_owned())];
    let mut note = String::new();
    if let Some(stretch_s) = stretch_s {
        let stretch = time_text(stretch_s);
        legend[1].1 = format!("navigation, first {stretch}");
        legend.push((Pen::Late, format!("navigation, last {stretch}")));
        note = format!(
            "Drawn: the first and the last {stretch} of {}, of the height the first. ",
            time_text(run.duration_s())
        );
    }
    legend.extend([(Pen::Start, "start".to_owned()), (Pen::End, "end of the true path".to_owned())]);
    let (track, track_note) = track(run, &truth, &navigation, stretch_s)?;
    let (height, height_note) = height(run, stretch_s.unwrap_or(run.duration_s()))?;
    note += &format!("{track_note} {height_note}");
    Ok(Figure { title: "Trajectory".to_owned(), legend, drawings: vec![track, height], note })
}

/// Duration of the parts at both ends of the truth that are drawn, in whole minutes [s]; `None` if all of it is drawn.
fn stretch_s(duration_s: f64, (east, north): &Track) -> Option<f64> {
    let path: f64 = (1..east.len()).map(|k| (east[k] - east[k - 1]).hypot(north[k] - north[k - 1])).sum();
    let [east, north] = [east, north].map(|values| extremes(values));
    let extent = (east.1 - east.0).max(north.1 - north.0);
    (path > REPEATS * extent).then(|| (SHOWN * extent / path * duration_s / 60.0).ceil() * 60.0)
}

/// The lines of the ground track [m].
fn lines(run: &Run, truth: &Track, navigation: &Track, stretch_s: Option<f64>) -> Vec<(Pen, Points)> {
    let count = run.time_s.len();
    let parts = match stretch_s {
        None => vec![(Pen::Reference, truth, 0..count), (Pen::Computed, navigation, 0..count)],
        Some(stretch_s) => {
            let first = 0..run.time_s.partition_point(|t| *t <= stretch_s);
            let last = run.time_s.partition_point(|t| *t < run.duration_s() - stretch_s)..count;
            vec![
                (Pen::Reference, truth, first.clone()),
                (Pen::Reference, truth, last.clone()),
                (Pen::Computed, navigation, first),
                (Pen::Late, navigation, last),
            ]
        }
    };
    let extent =
        [truth, navigation].into_iter().map(|(e, n)| magnitude(e).max(magnitude(n))).fold(0.0, f64::max);
    let drawn = |(east, north): &Track, part: Range<usize>| {
        outline(&east[part.clone()], &north[part], extent / TRACK_RESOLUTION)
    };
    parts.into_iter().map(|(pen, track, part)| (pen, drawn(track, part))).collect()
}

/// Track east and north of the start, with equal axes, and its note.
fn track(
    run: &Run,
    truth: &Track,
    navigation: &Track,
    stretch_s: Option<f64>,
) -> Result<(String, String), Failure> {
    let lines = lines(run, truth, navigation, stretch_s);
    let (east, north): Track = lines.iter().flat_map(|(_, points)| points).copied().unzip();
    let unit = fitting(magnitude(&east).max(magnitude(&north)).max(LEAST_TRACK_M), LENGTH);
    let (x, y, height) = equal_axes(extremes(&east), extremes(&north), LEAST_TRACK_M, unit);
    let scaled = |points: Points| points.into_iter().map(|(e, n)| (e / unit.si, n / unit.si)).collect();
    let traces = lines.into_iter().map(|(pen, points)| Trace::new(pen, scaled(points))).collect();
    let caption = format!("north of the start [{}]", unit.name);
    let mut panel = Panel::new(caption, y, height, traces);
    let end = |values: &[f64]| values.last().map_or(0.0, |value| value / unit.si);
    panel.dots.extend([
        Dot { at: (0.0, 0.0), pen: Pen::Start, radius: 6.0 },
        Dot { at: (end(&truth.0), end(&truth.1)), pen: Pen::End, radius: 6.0 },
    ]);
    let x_label = format!("east of the start [{}]", unit.name);
    let drawing = Drawing { width: WIDTH, x, x_label, panels: vec![panel] };
    let far = truth.0.iter().zip(&truth.1).fold(0.0, |most: f64, (e, n)| most.max(e.hypot(*n)));
    let note = format!(
        "Farthest from the start: {}. Start at latitude {:.4}°, longitude {:.4}°.",
        with_unit(far, LENGTH),
        run.truth.latitude_rad[0].to_degrees(),
        run.truth.longitude_rad[0].to_degrees(),
    );
    Ok((drawing.svg(&format!("Ground track, equal axes. {note}"))?, note))
}

/// Height over the first `shown_s`.
fn height(run: &Run, shown_s: f64) -> Result<(String, String), Failure> {
    let time = time_axis(shown_s);
    let shown = run.time_s.partition_point(|t| *t <= shown_s);
    let of = |places: &Places, unit: Unit| line(&run.time_s, &places.height_m[..shown], &time, unit);
    let (low, high) = bounds(&[of(&run.truth, METRE), of(&run.navigation, METRE)]);
    let unit = if high - low >= KILOMETRE.si { KILOMETRE } else { METRE };
    let traces = vec![
        Trace::new(Pen::Reference, of(&run.truth, unit)),
        Trace::new(Pen::Computed, of(&run.navigation, unit)),
    ];
    let y = Axis::around(low / unit.si, high / unit.si, LEAST_HEIGHT_M / unit.si, 5);
    let panels = vec![Panel::new(format!("height above the ellipsoid [{}]", unit.name), y, 120.0, traces)];
    let (low, high) = extremes(&run.truth.height_m);
    let note = format!("Heights {low:.1} m to {high:.1} m.");
    let drawing = over_time(time, panels);
    Ok((drawing.svg(&format!("Height above the ellipsoid over time. {note}"))?, note))
}

/// Distances east and north [m] from the first place of `origin`, in the azimuthal equidistant projection, so that tracks over a
/// pole or over the date line stay connected.
fn local(path: &Places, origin: &Places) -> Track {
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
            let chord = earth.to_earth_fixed(&place(path, record)) - start_e;
            let (x, y) = (chord.dot(&east), chord.dot(&north));
            let level = x.hypot(y);
            let half = chord.norm() / (2.0 * EARTH_RADIUS_M);
            let arc = 2.0 * EARTH_RADIUS_M * half.min(1.0).asin();
            let stretch = if level > 0.0 { arc / level } else { 0.0 };
            (x * stretch, y * stretch)
        })
        .unzip()
}

/// Smallest and largest of the records.
fn extremes(values: &[f64]) -> (f64, f64) {
    range(values.iter().copied()).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn path(places: &[(f64, f64)]) -> Places {
        let (latitude_rad, longitude_rad) =
            places.iter().map(|(l, o)| (l.to_radians(), o.to_radians())).unzip();
        Places { latitude_rad, longitude_rad, height_m: vec![0.0; places.len()] }
    }

    #[test]
    fn a_minute_of_latitude_is_a_nautical_mile() {
        let path = path(&[(45.0, 10.0), (45.0 + 1.0 / 60.0, 10.0)]);
        let (east, north) = local(&path, &path);
        // Meridian radius at 45°: 6 367 382 m.
        assert!(
            (north[1] - 6_367_382.0 / 10_800.0 * std::f64::consts::PI).abs() < 0.01 && east[1].abs() < 1e-6
        );
    }

    #[test]
    fn a_track_over_the_pole_is_straight() {
        let path = path(&[(89.0, 30.0), (89.0, -150.0)]);
        let (east, north) = local(&path, &path);
        assert!(
            (north[1] - 2.0 * 111_694.0).abs() < 300.0 && east[1].abs() < 1e-3,
            "{} {}",
            east[1],
            north[1]
        );
    }

    #[test]
    fn of_a_track_that_repeats_itself_the_ends_are_drawn() {
        // 60 laps of a circle in 10 h: a lap of 10 min is 3.14 extents of path.
        let angle: Vec<f64> = (0..=3600).map(|k| f64::from(k) * std::f64::consts::TAU / 60.0).collect();
        let circle: Track = angle.iter().map(|a| (1000.0 * a.cos(), 1000.0 * a.sin())).unzip();
        assert_eq!(stretch_s(36_000.0, &circle), Some(13.0 * 60.0));
        let straight: Track = (0..10).map(|k| (f64::from(k), 0.0)).unzip();
        assert_eq!(stretch_s(10.0, &straight), None);
        assert_eq!(stretch_s(10.0, &(vec![0.0; 3], vec![0.0; 3])), None, "at rest");

        let run = crate::report::run::tests::made(3601, |_, _| 0.0);
        let drawn = lines(&run, &circle, &circle, Some(780.0));
        let pens: Vec<Pen> = drawn.iter().map(|(pen, _)| *pen).collect();
        assert_eq!(pens, [Pen::Reference, Pen::Reference, Pen::Computed, Pen::Late]);
        assert!(drawn.iter().all(|(_, points)| points.len() > 70), "at least a lap of 79 records");
    }
}
