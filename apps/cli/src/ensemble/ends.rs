//! Errors at the end of the runs: scatter of the positions with the ellipses of 50 and 95 %, histogram of the radial error.

use super::plan::Data;
use super::study::Study;
use super::table::radial;
use crate::drawing::axis::Axis;
use crate::drawing::figure::Figure;
use crate::drawing::pen::Pen;
use crate::drawing::plot::{Dot, Drawing, LEFT, Mark, Panel, Trace, WIDTH};
use crate::drawing::scales::equal_axes;
use crate::drawing::series::{Points, range};
use crate::failure::Failure;
use crate::units::{LENGTH, fitting};

/// Largest number of dots; the first runs have dots.
const MOST_DOTS: usize = 2000;

/// Height of the axes [drawing units].
const HEIGHT: f64 = 320.0;

/// Number of corners of a drawn ellipse.
const CORNERS: usize = 120;

/// Smallest and largest number of bars of the histogram. Between these, it is the square root of the number of runs.
const BARS: (f64, f64) = (8.0, 60.0);

/// Mean and covariance of the horizontal position; the covariance as its Cholesky factor [m].
#[derive(Debug, Clone, Copy)]
struct Normal {
    mean: [f64; 2],
    east: f64,
    north_by_east: f64,
    north: f64,
}

impl Normal {
    fn new(mean: [f64; 2], sigma: [f64; 2], covariance: f64) -> Self {
        let east = sigma[0];
        let north_by_east = if east > 0.0 { covariance / east } else { 0.0 };
        let north = (sigma[1].powi(2) - north_by_east.powi(2)).max(0.0).sqrt();
        Self { mean, east, north_by_east, north }
    }

    /// Distance of a place from the mean, in sigmas of its direction.
    fn distance(&self, place: [f64; 2]) -> f64 {
        let quotient = |value: f64, scale: f64| if scale > 0.0 { value / scale } else { 0.0 };
        let along = quotient(place[0] - self.mean[0], self.east);
        let across = quotient(place[1] - self.mean[1] - self.north_by_east * along, self.north);
        along.hypot(across)
    }

    /// Ellipse of the places at one distance.
    fn ellipse(&self, distance: f64) -> Points {
        let corner = |k: usize| {
            let (sine, cosine) = (k as f64 / CORNERS as f64 * std::f64::consts::TAU).sin_cos();
            let east = self.mean[0] + distance * self.east * cosine;
            (east, self.mean[1] + distance * (self.north_by_east * cosine + self.north * sine))
        };
        (0..=CORNERS).map(corner).collect()
    }
}

/// Distance within which there is a share of a normal distribution in the plane [sigma].
fn within(share: f64) -> f64 {
    (-2.0 * (1.0 - share).ln()).sqrt()
}

/// The scatter; `None` if every run diverged.
pub fn scatter(study: &Study) -> Result<Option<Figure>, Failure> {
    let places: Vec<[f64; 2]> = study.ends().map(|end| [end[0], end[1]]).collect();
    let Some(row) = study.end(Data::Navigation).filter(|_| !places.is_empty()) else {
        return Ok(None);
    };
    let (mean, sigma) = (row.mean(), row.sigma());
    let normal = Normal::new([mean[0], mean[1]], [sigma[0], sigma[1]], row.east_north());
    let ellipses =
        [(Pen::Computed, 0.5), (Pen::Fit, 0.95)].map(|(pen, share)| (pen, normal.ellipse(within(share))));
    let dots = &places[..places.len().min(MOST_DOTS)];

    // The axes contain the truth.
    let all = ellipses.iter().flat_map(|(_, points)| points.iter().copied());
    let all = all.chain(dots.iter().map(|place| (place[0], place[1]))).chain([(0.0, 0.0)]);
    let (east, north): (Vec<f64>, Vec<f64>) = all.unzip();
    let [east, north] = [east, north].map(|values| range(values).unwrap_or_default());
    let size = (east.1 - east.0).max(north.1 - north.0);
    let unit = fitting(size, LENGTH);
    // Ellipses without width, and equal runs, still have axes.
    let (x, y) = equal_axes(east, north, size.max(1e-9) * 1e-3, unit, HEIGHT);
    let scaled = |(east, north): (f64, f64)| (east / unit.si, north / unit.si);
    let traces = ellipses.map(|(pen, points)| Trace::new(pen, points.into_iter().map(scaled).collect()));
    let caption = format!("north [{}]", unit.name);
    let mut panel = Panel::new(caption, y, HEIGHT, traces.into());
    let dot =
        |place: &[f64; 2]| Dot { at: scaled((place[0], place[1])), pen: Pen::Run, radius: 2.5, label: None };
    panel.dots.extend(dots.iter().map(dot));
    panel.dots.push(Dot { at: (0.0, 0.0), pen: Pen::Start, radius: 5.0, label: None });
    let x_label = format!("east [{}]", unit.name);
    let drawing = Drawing { width: WIDTH, left: LEFT, x, x_label, panels: vec![panel] };

    let share = |share: f64| {
        let inside = places.iter().filter(|place| normal.distance(**place) <= within(share)).count();
        100.0 * inside as f64 / places.len() as f64
    };
    let note = format!(
        "Of the runs {:.1} % are within the ellipse of 50 %, {:.1} % within that of 95 %.",
        share(0.5),
        share(0.95)
    );
    let which =
        if dots.len() < places.len() { format!("the first {} runs", dots.len()) } else { "a run".to_owned() };
    let legend = vec![
        (Pen::Run, format!("position error of {which}")),
        (Pen::Start, "truth".to_owned()),
        (Pen::Computed, "ellipse of 50 % of a normal distribution".to_owned()),
        (Pen::Fit, "ellipse of 95 %".to_owned()),
    ];
    Figure::new("Positions at the end", ", equal axes", legend, &drawing, note).map(Some)
}

/// The histogram; `None` if every run diverged.
pub fn histogram(study: &Study) -> Result<Option<Figure>, Failure> {
    let radii: Vec<f64> = study.ends().map(radial).collect();
    let largest = radii.iter().copied().fold(0.0, f64::max);
    let Some(row) = study.end(Data::Navigation).filter(|_| largest > 0.0) else {
        return Ok(None);
    };
    let unit = fitting(largest, LENGTH);
    let bars = (radii.len() as f64).sqrt().round().clamp(BARS.0, BARS.1) as usize;
    let mut counts = vec![0u32; bars];
    for radius in &radii {
        let place = (radius / largest * bars as f64) as usize;
        counts[place.min(bars - 1)] += 1;
    }
    let edge = |bar: usize| largest / unit.si * bar as f64 / bars as f64;
    let mut outline: Points = vec![(0.0, 0.0)];
    for (bar, count) in counts.iter().enumerate() {
        outline.extend([(edge(bar), f64::from(*count)), (edge(bar + 1), f64::from(*count))]);
    }
    outline.extend([(edge(bars), 0.0), (0.0, 0.0)]);
    let most = counts.iter().copied().max().unwrap_or(1);
    let y = Axis::linear(0.0, 1.08 * f64::from(most), 6);
    let mut panel = Panel::new("runs", y, HEIGHT, vec![Trace::new(Pen::Count, outline)]);
    let (cep50, r95) = (row.figures.cep50_m, row.figures.r95_m);
    let mark = |at: f64, pen, text: &str| Mark { at: at / unit.si, pen, text: text.to_owned() };
    panel.marks.extend([mark(cep50, Pen::Computed, "CEP50"), mark(r95, Pen::Fit, "R95")]);
    let limits = study.plan.requirements.iter().filter(|due| due.is_of_end(study.plan)).map(|due| due.limit);
    panel.marks.extend(limits.filter(|limit| *limit < largest).map(|limit| mark(limit, Pen::Limit, "limit")));
    let x = Axis::linear(0.0, 1.04 * largest / unit.si, 6);
    let x_label = format!("horizontal position error [{}]", unit.name);
    let drawing = Drawing { width: WIDTH, left: LEFT, x, x_label, panels: vec![panel] };
    let beyond = |limit: f64| radii.iter().filter(|radius| **radius > limit).count();
    let note =
        format!("Beyond CEP50 are {} of {} runs, beyond R95 {}.", beyond(cep50), radii.len(), beyond(r95));
    let legend = vec![
        (Pen::Count, "how many runs end so far from the truth".to_owned()),
        (Pen::Computed, "CEP50".to_owned()),
        (Pen::Fit, "R95".to_owned()),
    ];
    let title = "Horizontal position error at the end";
    Figure::new(title, ": histogram", legend, &drawing, note).map(Some)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_ellipse_is_at_one_distance() {
        let normal = Normal::new([3.0, -1.0], [2.0, 5.0], 6.0);
        for (east, north) in normal.ellipse(within(0.5)) {
            let (x, y) = (east - 3.0, north + 1.0);
            // x' C^-1 x of C = [4 6; 6 25], det 64.
            let form = (25.0 * x * x - 12.0 * x * y + 4.0 * y * y) / 64.0;
            assert!((form - 2.0 * 2f64.ln()).abs() < 1e-12, "{form}");
            assert!((normal.distance([east, north]).powi(2) - form).abs() < 1e-12);
        }
        // Ellipses without width, in one direction or in both.
        for sigma in [[0.0, 5.0], [2.0, 0.0], [0.0, 0.0]] {
            let flat = Normal::new([0.0, 0.0], sigma, 0.0);
            assert!(flat.ellipse(2.0).iter().all(|(east, north)| east.is_finite() && north.is_finite()));
            assert!(flat.distance([1.0, 1.0]).is_finite());
        }
    }

    #[test]
    fn shares_of_a_circular_normal_distribution() {
        assert!((within(0.5) - 1.177_410).abs() < 1e-6 && (within(0.95) - 2.447_747).abs() < 1e-6);
    }
}
