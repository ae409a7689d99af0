//! Recorded series, prepared for a plot: thinned without losing an extremum, averaged, differenced, fitted.

/// Points of a plotted line.
pub type Points = Vec<(f64, f64)>;

/// Largest number of points of a plotted line.
pub const MOST_POINTS: usize = 1000;

/// Largest number of corners of a plotted track. Laps over one another need more than a line over time.
pub const MOST_CORNERS: usize = 2000;

/// At most about [`MOST_POINTS`] of the records (`x`, `y`): first, last, and the smallest and largest `y` of each
/// stretch.
pub fn thinned(x: &[f64], y: &[f64]) -> Points {
    pick(&stretches(y.len(), MOST_POINTS / 2, |range| extrema(y, range)), x, y)
}

/// Places of the corners that represent the curve (`x`, `y`) within `tolerance` (Douglas and Peucker 1973). The tolerance is doubled
/// until there are at most [`MOST_CORNERS`] corners.
pub fn outline(x: &[f64], y: &[f64], tolerance: f64) -> Vec<usize> {
    let mut tolerance = tolerance;
    loop {
        let kept = corners(x, y, tolerance);
        if kept.len() <= MOST_CORNERS || tolerance <= 0.0 {
            return kept;
        }
        tolerance *= 2.0;
    }
}

fn corners(x: &[f64], y: &[f64], tolerance: f64) -> Vec<usize> {
    let mut kept: Vec<usize> = [0, y.len() - 1].into();
    let mut open = vec![(0, y.len() - 1)];
    while let Some((from, to)) = open.pop() {
        let (dx, dy) = (x[to] - x[from], y[to] - y[from]);
        let length = dx.hypot(dy);
        let distance = |k: usize| {
            let (px, py) = (x[k] - x[from], y[k] - y[from]);
            if length > 0.0 { (px * dy - py * dx).abs() / length } else { px.hypot(py) }
        };
        let farthest = (from + 1..to).map(|k| (k, distance(k))).max_by(|a, b| a.1.total_cmp(&b.1));
        if let Some((middle, _)) = farthest.filter(|(_, distance)| *distance > tolerance) {
            kept.push(middle);
            open.extend([(from, middle), (middle, to)]);
        }
    }
    kept.sort_unstable();
    kept.dedup();
    kept
}

/// Means over `blocks` stretches of the records, each at the mean `x` of its stretch.
pub fn block_means(x: &[f64], y: &[f64], blocks: usize) -> Points {
    let size = y.len().div_ceil(blocks).max(1);
    x.chunks(size).zip(y.chunks(size)).map(|(x, y)| (mean(x), mean(y))).collect()
}

/// Mean; zero without values.
pub fn mean(values: &[f64]) -> f64 {
    if values.is_empty() { 0.0 } else { values.iter().sum::<f64>() / values.len() as f64 }
}

/// `a` less `b`, record by record.
pub fn difference(a: &[f64], b: &[f64]) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| a - b).collect()
}

/// Largest magnitude.
pub fn magnitude(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most, value| value.abs().max(most))
}

/// Smallest and largest value; `None` without values.
pub fn range(values: impl IntoIterator<Item = f64>) -> Option<(f64, f64)> {
    values.into_iter().fold(None, |range, value| match range {
        None => Some((value, value)),
        Some((low, high)) => Some((value.min(low), value.max(high))),
    })
}

/// Smallest and largest of the values that a logarithmic axis can show; (1, 1) if there are none.
pub fn positive_range(values: impl IntoIterator<Item = f64>) -> (f64, f64) {
    range(values.into_iter().filter(|value| *value > 0.0 && value.is_finite())).unwrap_or((1.0, 1.0))
}

/// Smallest and largest `y` of all `lines`; (0, 0) without points.
pub fn bounds<'a>(lines: impl IntoIterator<Item = &'a Points>) -> (f64, f64) {
    range(lines.into_iter().flatten().map(|point| point.1)).unwrap_or_default()
}

/// Straight line of least squares y = a + b x as (a, b); b is zero if all `x` are equal.
pub fn straight_line(x: &[f64], y: &[f64]) -> (f64, f64) {
    let (middle, level) = (mean(x), mean(y));
    let spread: f64 = x.iter().map(|x| (x - middle).powi(2)).sum();
    let product: f64 = x.iter().zip(y).map(|(x, y)| (x - middle) * (y - level)).sum();
    let slope = if spread > 0.0 { product / spread } else { 0.0 };
    (level - slope * middle, slope)
}

/// Places of the smallest and the largest value in `range`.
fn extrema(y: &[f64], range: std::ops::Range<usize>) -> Vec<usize> {
    let least = range.clone().min_by(|a, b| y[*a].total_cmp(&y[*b]));
    let most = range.max_by(|a, b| y[*a].total_cmp(&y[*b]));
    least.into_iter().chain(most).collect()
}

/// First and last of `length` places, and the places that `keep` finds in each of `count` stretches, in order.
fn stretches(length: usize, count: usize, keep: impl Fn(std::ops::Range<usize>) -> Vec<usize>) -> Vec<usize> {
    if length <= 2 * count {
        return (0..length).collect();
    }
    let mut kept: Vec<usize> =
        (0..count).flat_map(|k| keep(k * length / count..(k + 1) * length / count)).collect();
    kept.extend([0, length - 1]);
    kept.sort_unstable();
    kept.dedup();
    kept
}

fn pick(places: &[usize], x: &[f64], y: &[f64]) -> Points {
    places.iter().map(|&place| (x[place], y[place])).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thinning_keeps_extrema_and_ends() {
        let x: Vec<f64> = (0..100_000).map(f64::from).collect();
        let mut y: Vec<f64> = x.iter().map(|x| (x * 0.37).sin()).collect();
        (y[31_337], y[77_001], y[0], y[99_999]) = (5.0, -7.0, 0.25, 0.75);
        let points = thinned(&x, &y);
        assert!(points.len() <= MOST_POINTS + 2, "{}", points.len());
        assert!(points.windows(2).all(|pair| pair[0].0 < pair[1].0));
        for kept in [(31_337.0, 5.0), (77_001.0, -7.0), (0.0, 0.25), (99_999.0, 0.75)] {
            assert!(points.contains(&kept), "{kept:?}");
        }
    }

    #[test]
    fn a_short_record_is_kept_whole() {
        assert_eq!(thinned(&[0.0, 1.0, 2.0], &[3.0, 4.0, 3.5]), [(0.0, 3.0), (1.0, 4.0), (2.0, 3.5)]);
    }

    #[test]
    fn an_outline_stays_within_its_tolerance() {
        let angle: Vec<f64> = (0..50_000).map(|k| f64::from(k) * 1e-3).collect();
        let (x, y): (Vec<f64>, Vec<f64>) = angle.iter().map(|a| (a.cos(), a.sin())).unzip();
        let points = pick(&outline(&x, &y, 1e-3), &x, &y);
        // A chord of the unit circle that bulges by e spans 2 acos(1 - e); eight laps have 70 to 140 chords each.
        assert!((500..1200).contains(&points.len()), "{}", points.len());
        for pair in points.windows(2) {
            let middle = ((pair[0].0 + pair[1].0) / 2.0).hypot((pair[0].1 + pair[1].1) / 2.0);
            assert!(1.0 - middle <= 1e-3 + 1e-6, "{middle}");
        }
    }

    #[test]
    fn an_outline_of_noise_is_limited() {
        let x: Vec<f64> = (0..20_000).map(f64::from).collect();
        let y: Vec<f64> = x.iter().map(|x| (x * x).sin()).collect();
        assert!(outline(&x, &y, 1e-9).len() <= MOST_CORNERS);
    }

    #[test]
    fn a_straight_line_is_found() {
        let x = [1.0, 2.0, 4.0, 7.0];
        let (a, b) = straight_line(&x, &x.map(|x| 3.0 - 0.5 * x));
        // Sums of four terms below 10: a few units in the last place.
        assert!((a - 3.0).abs() < 8.0 * 10.0 * f64::EPSILON && (b + 0.5).abs() < 8.0 * f64::EPSILON);
    }

    #[test]
    fn means_of_blocks() {
        assert_eq!(block_means(&[0.0, 1.0, 2.0, 3.0], &[1.0, 3.0, 5.0, 5.0], 2), [(0.5, 2.0), (2.5, 5.0)]);
    }
}
