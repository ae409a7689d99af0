//! Dots that would cover each other stand beside each other.

/// A circle: its centre right and down, its radius [drawing units].
pub type Circle = (f64, f64, f64);

/// How far each of `circles` is moved sideways, so that none covers another within `width` [drawing units]. Larger circles are placed
/// first, and each goes to the nearest free place. If no place is free, it stays.
pub fn shifts(circles: &[Circle], width: f64) -> Vec<f64> {
    let mut order: Vec<usize> = (0..circles.len()).collect();
    order.sort_by(|a, b| circles[*b].2.total_cmp(&circles[*a].2));
    let mut shifts = vec![0.0; circles.len()];
    let mut placed: Vec<Circle> = Vec::new();
    for place in order {
        let (x, y, radius) = circles[place];
        let free = candidates((x, y, radius), &placed)
            .into_iter()
            .filter(|to| *to == x || (radius..=width - radius).contains(to))
            .find(|to| placed.iter().all(|other| !covers((*to, y, radius), *other)));
        let to = free.unwrap_or(x);
        shifts[place] = to - x;
        placed.push((to, y, radius));
    }
    shifts
}

/// Its own place, and those at which `circle` touches one of `placed`, the nearest first.
fn candidates((x, y, radius): Circle, placed: &[Circle]) -> Vec<f64> {
    let beside = placed.iter().filter_map(|(other_x, other_y, other_radius)| {
        let (apart, up) = (radius + other_radius, y - other_y);
        let aside = apart.powi(2) - up.powi(2);
        (aside > 0.0).then(|| [other_x - aside.sqrt(), other_x + aside.sqrt()])
    });
    let mut places: Vec<f64> = [x].into_iter().chain(beside.flatten()).collect();
    places.sort_by(|a, b| (a - x).abs().total_cmp(&(b - x).abs()));
    places
}

/// Whether two circles have more than a point in common, to rounding.
fn covers(a: Circle, b: Circle) -> bool {
    (a.0 - b.0).hypot(a.1 - b.1) < (a.2 + b.2) * (1.0 - 1e-9)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn moved(circles: &[Circle], width: f64) -> Vec<Circle> {
        let shifts = shifts(circles, width);
        circles.iter().zip(shifts).map(|((x, y, radius), shift)| (x + shift, *y, *radius)).collect()
    }

    #[test]
    fn circles_that_cover_each_other_are_side_by_side_and_others_stay() {
        let circles = [(50.0, 50.0, 6.0), (50.0, 53.0, 6.0), (51.0, 50.0, 10.0), (200.0, 50.0, 6.0)];
        let moved = moved(&circles, 300.0);
        assert_eq!((moved[2], moved[3]), (circles[2], circles[3]), "the largest, and one that is alone");
        assert!(moved[0].0 < 51.0 && moved[1].0 > 51.0, "{moved:?}");
    }

    #[test]
    fn no_circle_covers_another_while_there_is_room() {
        let mut random = 7_u64;
        let mut next = || {
            random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (random >> 11) as f64 / (1_u64 << 53) as f64
        };
        for _ in 0..50 {
            let circles: Vec<Circle> =
                (0..60).map(|_| (20.0 + 560.0 * next(), 400.0 * next(), 2.0 + 8.0 * next())).collect();
            let moved = moved(&circles, 600.0);
            for (k, a) in moved.iter().enumerate() {
                assert!(moved[..k].iter().all(|b| !covers(*a, *b)), "{a:?}");
                assert!(a.0 - a.2 >= 0.0 && a.0 + a.2 <= 600.0 || a.0 == circles[k].0, "{a:?}");
            }
        }
        // More than there is room for: they stay, and end.
        let crowd = vec![(5.0, 5.0, 5.0); 40];
        assert_eq!(shifts(&crowd, 30.0).iter().filter(|shift| **shift != 0.0).count(), 2);
    }
}
