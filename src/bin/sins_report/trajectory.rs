//! The flown path: ground track and height.

use sins::earth::{Earth, Ellipsoid, Geodetic, GravityModel};

use crate::axis::Axis;
use crate::failure::Failure;
use crate::figures::{Figure, TIME_TICKS, over_time, time_label};
use crate::pen::Pen;
use crate::plot::{Drawing, PANEL_WIDTH, Panel, Trace};
use crate::run::{Places, Run};
use crate::series::{Points, bounds, magnitude, outline};
use crate::units::{KILOMETRE, LENGTH, METRE, Unit, fitting, with_unit};

/// Mean radius of the Earth [m], for the length of an arc over its chord.
const EARTH_RADIUS_M: f64 = 6.371e6;

/// A track at rest is shown in a square of this side [m], a constant height in a strip of [`LEAST_HEIGHT_M`].
const LEAST_TRACK_M: f64 = 1.0;
const LEAST_HEIGHT_M: f64 = 10.0;

/// A track keeps the details down to its extent over this number.
const TRACK_RESOLUTION: f64 = 2000.0;

/// Ground track, and height over time.
pub fn figure(run: &Run) -> Result<Figure, Failure> {
    let (track, track_note) = track(run)?;
    let (height, height_note) = height(run)?;
    let legend = vec![
        (Pen::Reference, "truth".to_owned()),
        (Pen::Computed, "navigation".to_owned()),
        (Pen::Start, "start".to_owned()),
    ];
    let note = format!("{track_note} {height_note}");
    Ok(Figure { title: "Trajectory".to_owned(), legend, drawings: vec![track, height], note })
}

/// Track east and north of the start, equal axes, and what it says in words.
fn track(run: &Run) -> Result<(String, String), Failure> {
    let (truth_east, truth_north) = local(&run.truth, &run.truth);
    let (east, north) = local(&run.navigation, &run.truth);
    let extent = [&truth_east, &truth_north, &east, &north]
        .into_iter()
        .fold(0.0, |most: f64, v| most.max(magnitude(v)));
    let tolerance = extent / TRACK_RESOLUTION;
    let truth = outline(&truth_east, &truth_north, tolerance);
    let navigation = outline(&east, &north, tolerance);
    let unit = fitting(extent.max(LEAST_TRACK_M), LENGTH);
    let [truth, navigation] = [truth, navigation]
        .map(|points| points.into_iter().map(|(e, n)| (e / unit.si, n / unit.si)).collect::<Points>());

    let least = LEAST_TRACK_M / unit.si;
    let north_range = bounds([&truth, &navigation]);
    let east_range =
        bounds(&[&truth, &navigation].map(|line| line.iter().map(|(e, n)| (*n, *e)).collect::<Points>()));
    let (width, height, scale) = equal_scale(span(east_range).max(least), span(north_range).max(least));
    let centred = |(low, high): (f64, f64), units: f64, ticks: usize| {
        let middle = (low + high) / 2.0;
        Axis::linear(middle - units / scale / 2.0, middle + units / scale / 2.0, ticks)
    };
    let traces = vec![Trace::new(Pen::Reference, truth), Trace::new(Pen::Computed, navigation)];
    let mut panel = Panel::new(
        format!("north of the start [{}]", unit.name),
        centred(north_range, height, 6),
        height,
        traces,
    );
    panel.start = Some((0.0, 0.0));
    let drawing = Drawing {
        x: centred(east_range, width, 6),
        x_label: format!("east of the start [{}]", unit.name),
        panels: vec![panel],
    };
    let far = truth_east.iter().zip(&truth_north).fold(0.0, |most: f64, (e, n)| most.max(e.hypot(*n)));
    let note = format!(
        "Farthest from the start: {}. Start at latitude {:.4}°, longitude {:.4}°.",
        with_unit(far, LENGTH),
        run.truth.latitude_rad[0].to_degrees(),
        run.truth.longitude_rad[0].to_degrees(),
    );
    Ok((drawing.svg(&format!("Ground track, equal axes. {note}"))?, note))
}

/// Height over time.
fn height(run: &Run) -> Result<(String, String), Failure> {
    let time = Axis::time(run.duration_s(), TIME_TICKS);
    let of = |values: &[f64], unit: Unit| over_time(run, &time, values, unit);
    let lines = [of(&run.truth.height_m, METRE), of(&run.navigation.height_m, METRE)];
    let (low, high) = bounds(&lines);
    let unit = if high - low >= KILOMETRE.si { KILOMETRE } else { METRE };
    let traces = vec![
        Trace::new(Pen::Reference, of(&run.truth.height_m, unit)),
        Trace::new(Pen::Computed, of(&run.navigation.height_m, unit)),
    ];
    let y = Axis::around(low / unit.si, high / unit.si, LEAST_HEIGHT_M / unit.si, 5);
    let panels = vec![Panel::new(format!("height above the ellipsoid [{}]", unit.name), y, 120.0, traces)];
    let note = format!("Heights {low:.1} m to {high:.1} m.");
    let drawing = Drawing { x_label: time_label(&time), x: time.axis, panels };
    Ok((drawing.svg(&format!("Height above the ellipsoid over time. {note}"))?, note))
}

/// East and north [m] of the first place of `origin`, by distance and bearing from there (azimuthal equidistant), so
/// that tracks over a pole or over the date line stay whole.
fn local(path: &Places, origin: &Places) -> (Vec<f64>, Vec<f64>) {
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

fn span((low, high): (f64, f64)) -> f64 {
    high - low
}

/// Width and height of the panel and the drawing units for one plotted unit, the same on both axes.
fn equal_scale(east: f64, north: f64) -> (f64, f64, f64) {
    let margin = 1.12;
    let height = (PANEL_WIDTH * north / east).clamp(0.35 * PANEL_WIDTH, 0.75 * PANEL_WIDTH);
    (PANEL_WIDTH, height, (PANEL_WIDTH / (east * margin)).min(height / (north * margin)))
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
    fn axes_are_equal_and_hold_the_track() {
        for (east, north) in [(10.0, 1.0), (1.0, 10.0), (3.0, 3.0)] {
            let (width, height, scale) = equal_scale(east, north);
            assert!(width / scale >= east && height / scale >= north);
        }
    }
}
