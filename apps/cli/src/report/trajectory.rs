//! The flown path: ground track and height.

use crate::drawing::axis::Axis;
use crate::drawing::figure::Figure;
use crate::drawing::pen::Pen;
use crate::drawing::plot::{Dot, Drawing, LEFT, Panel, Trace, WIDTH};
use crate::drawing::scales::{equal_axes, over_time, scaled, time_axis};
use crate::drawing::series::{Points, bounds, outline, range};
use crate::failure::Failure;
use crate::report::path::{Path, Point, RESOLUTION};
use crate::report::run::Run;
use crate::units::{KILOMETRE, LENGTH, METRE, fitting, time_text, with_unit};

/// Smallest extents of the axes [m]: of a track at rest, and of a constant height.
const LEAST_TRACK_M: f64 = 1.0;
const LEAST_HEIGHT_M: f64 = 10.0;

/// A path of the truth that is longer than its extent times this ratio covers the same ground repeatedly. Then only its first and
/// last [`SHOWN`] extents of path are drawn.
const REPEATS: f64 = 20.0;
const SHOWN: f64 = 4.0;

/// Number of places of a line of the track at which a cursor finds the time, also where the line is straight.
const LEAST_PLACES: usize = 200;

/// Height of the axes of the height, and of all else in the figure but the axes of the track [drawing units].
const HEIGHT: f64 = 120.0;
const AROUND: f64 = 2.0 * 79.0;

/// Ground track, and height over time, `height` high [drawing units].
pub fn figure(run: &Run, height: f64) -> Result<Figure, Failure> {
    let truth = Path::of(&run.truth, &run.truth, &run.time_s);
    let navigation = Path::of(&run.navigation, &run.truth, &run.time_s);
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
    legend.extend(run.rows.iter().map(|_| (Pen::Row, "rows of the log".to_owned())));
    legend.extend([(Pen::Start, "start".to_owned()), (Pen::End, "end of the true path".to_owned())]);
    let (track, track_note) = track(run, [&truth, &navigation], stretch_s, height - HEIGHT - AROUND)?;
    let (heights, height_note) = heights(run, [&truth, &navigation], stretch_s.unwrap_or(run.duration_s()))?;
    note += &format!("{track_note} {height_note}{}", between(run, &truth));
    Ok(Figure { title: "Trajectory".to_owned(), legend, drawings: vec![track, heights], note })
}

/// How the path between the records was found, if they are far apart.
fn between(run: &Run, truth: &Path) -> String {
    let spacing = time_text(run.spacing_s());
    match (truth.pieces.len() - 1, truth.points.len() > run.time_s.len()) {
        (0, false) => String::new(),
        (0, true) => format!(" Between records {spacing} apart, the path is that of their velocities."),
        _ => format!(
            " The records, {spacing} apart, do not show the whole path: where there is no line, it is not known."
        ),
    }
}

/// Duration of the parts at both ends of the truth that are drawn, in whole minutes [s]; `None` if all of it is drawn.
fn stretch_s(duration_s: f64, truth: &Path) -> Option<f64> {
    let (length, extent) = (truth.length_m(), truth.extent_m());
    (length > REPEATS * extent).then(|| (SHOWN * extent / length * duration_s / 60.0).ceil() * 60.0)
}

/// A line of the ground track: east and north [m], and the time of each point [s].
type TrackLine = (Pen, Points, Vec<f64>);

/// The lines of the ground track.
fn lines(run: &Run, [truth, navigation]: [&Path; 2], stretch_s: Option<f64>) -> Vec<TrackLine> {
    let end_s = run.duration_s();
    let parts = match stretch_s {
        None => vec![(Pen::Reference, truth, 0.0, end_s), (Pen::Computed, navigation, 0.0, end_s)],
        Some(stretch_s) => {
            let last_s = end_s - stretch_s;
            vec![
                (Pen::Reference, truth, 0.0, stretch_s),
                (Pen::Reference, truth, last_s, end_s),
                (Pen::Computed, navigation, 0.0, stretch_s),
                (Pen::Late, navigation, last_s, end_s),
            ]
        }
    };
    let tolerance = truth.extent_m().max(navigation.extent_m()) / RESOLUTION;
    let drawn = |pen: Pen, piece: &[Point]| {
        let (east, north): (Vec<f64>, Vec<f64>) =
            piece.iter().map(|point| (point.east_m, point.north_m)).unzip();
        let mut kept = outline(&east, &north, tolerance);
        kept.extend((0..piece.len()).step_by(piece.len().div_ceil(LEAST_PLACES)));
        kept.sort_unstable();
        kept.dedup();
        let points = kept.iter().map(|&k| (east[k], north[k])).collect();
        (pen, points, kept.iter().map(|&k| piece[k].time_s).collect())
    };
    parts
        .into_iter()
        .flat_map(|(pen, path, from_s, to_s)| path.within(from_s, to_s).map(move |piece| drawn(pen, piece)))
        .collect()
}

/// Track east and north of the start, with equal axes, and its note.
fn track(
    run: &Run,
    paths: [&Path; 2],
    stretch_s: Option<f64>,
    height: f64,
) -> Result<(String, String), Failure> {
    let lines = lines(run, paths, stretch_s);
    let all = || lines.iter().flat_map(|(_, points, _)| points);
    let east = range(all().map(|point| point.0)).unwrap_or_default();
    let north = range(all().map(|point| point.1)).unwrap_or_default();
    let largest =
        [east.0, east.1, north.0, north.1].into_iter().fold(LEAST_TRACK_M, |most, at| at.abs().max(most));
    let unit = fitting(largest, LENGTH);
    let (x, y) = equal_axes(east, north, LEAST_TRACK_M, unit, height);
    let traces = lines.into_iter().map(|(pen, points, time_s)| {
        let points = points.into_iter().map(|(e, n)| (e / unit.si, n / unit.si)).collect();
        Trace { time_s, ..Trace::new(pen, points) }
    });
    let caption = format!("north of the start [{}]", unit.name);
    let rows = run.rows.iter().flat_map(|rows| rows.dots(&run.truth, unit.si));
    let is_inside = |dot: &Dot| (x.low..=x.high).contains(&dot.at.0) && (y.low..=y.high).contains(&dot.at.1);
    let rows: Vec<Dot> = rows.filter(is_inside).collect();
    let mut panel = Panel::new(caption, y, height, traces.collect());
    panel.dots.extend(rows);
    panel.time = Some(time_axis(run.duration_s()));
    let truth = paths[0];
    let end =
        truth.points.last().map_or((0.0, 0.0), |point| (point.east_m / unit.si, point.north_m / unit.si));
    panel.dots.extend([
        Dot { at: (0.0, 0.0), pen: Pen::Start, radius: 6.0, label: None },
        Dot { at: end, pen: Pen::End, radius: 6.0, label: None },
    ]);
    let x_label = format!("east of the start [{}]", unit.name);
    let drawing = Drawing { width: WIDTH, left: LEFT, x, x_label, panels: vec![panel] };
    let far = truth.points.iter().fold(0.0, |most: f64, point| most.max(point.east_m.hypot(point.north_m)));
    let note = format!(
        "Farthest from the start: {}. Start at latitude {:.4}°, longitude {:.4}°.",
        with_unit(far, LENGTH),
        run.truth.latitude_rad[0].to_degrees(),
        run.truth.longitude_rad[0].to_degrees(),
    );
    Ok((drawing.svg(&format!("Ground track, equal axes. {note}"))?, note))
}

/// Height over the first `shown_s`.
fn heights(run: &Run, paths: [&Path; 2], shown_s: f64) -> Result<(String, String), Failure> {
    let time = time_axis(shown_s);
    let drawn = paths.map(|path| {
        let pieces = path.within(0.0, shown_s);
        pieces
            .map(|piece| piece.iter().map(|point| (point.time_s, point.height_m)).collect())
            .collect::<Vec<Points>>()
    });
    let (low, high) = bounds(drawn.iter().flatten());
    let unit = if high - low >= KILOMETRE.si { KILOMETRE } else { METRE };
    let thinned = |points: &Points| {
        let (at, height): (Vec<f64>, Vec<f64>) = points.iter().copied().unzip();
        scaled(crate::drawing::series::thinned(&at, &height), &time, unit)
    };
    let pens = [Pen::Reference, Pen::Computed];
    let traces = pens
        .into_iter()
        .zip(&drawn)
        .flat_map(|(pen, pieces)| pieces.iter().map(move |points| Trace::new(pen, thinned(points))));
    let traces = traces.collect();
    let y = Axis::around(low / unit.si, high / unit.si, LEAST_HEIGHT_M / unit.si, 5);
    let panels = vec![Panel::new(format!("height above the ellipsoid [{}]", unit.name), y, HEIGHT, traces)];
    let (low, high) = range(run.truth.height_m.iter().copied()).unwrap_or_default();
    let note = format!("Heights {low:.1} m to {high:.1} m.");
    let drawing = over_time(time, panels);
    Ok((drawing.svg(&format!("Height above the ellipsoid over time. {note}"))?, note))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A path through these places [m], a record each ten seconds.
    fn path(places: impl Iterator<Item = (f64, f64)>) -> Path {
        let point = |(k, (east_m, north_m)): (usize, (f64, f64))| Point {
            time_s: 10.0 * k as f64,
            east_m,
            north_m,
            height_m: 0.0,
        };
        let points: Vec<Point> = places.enumerate().map(point).collect();
        Path { pieces: std::iter::once(0..points.len()).collect(), points }
    }

    #[test]
    fn of_a_track_that_repeats_itself_the_ends_are_drawn() {
        // 60 laps of a circle in 10 h: a lap of 10 min is 3.14 extents of path.
        let angle = (0..=3600).map(|k| f64::from(k) * std::f64::consts::TAU / 60.0);
        let circle = path(angle.map(|a| (1000.0 * a.cos(), 1000.0 * a.sin())));
        assert_eq!(stretch_s(36_000.0, &circle), Some(13.0 * 60.0));
        assert_eq!(stretch_s(10.0, &path((0..10).map(|k| (f64::from(k), 0.0)))), None);
        assert_eq!(stretch_s(10.0, &path([(0.0, 0.0); 3].into_iter())), None, "at rest");

        let run = crate::report::run::tests::made(3601, |_, _| 0.0);
        let drawn = lines(&run, [&circle, &circle], Some(780.0));
        let pens: Vec<Pen> = drawn.iter().map(|(pen, ..)| *pen).collect();
        assert_eq!(pens, [Pen::Reference, Pen::Reference, Pen::Computed, Pen::Late]);
        assert!(drawn.iter().all(|(_, points, _)| points.len() > 70), "at least a lap of 79 records");
        assert!(drawn.iter().all(|(_, points, time_s)| points.len() == time_s.len()));
        assert_eq!((drawn[3].2[0], drawn[3].2.last()), (36_000.0 - 780.0, Some(&36_000.0)));
    }
}
