//! The minimum of a function of four parameters: the simplex of Nelder and Mead 1965.

/// Largest number of steps, and differences of cost and parameters at which the simplex has arrived.
const STEPS: usize = 1000;
const COST: f64 = 1e-3;
const SIZE: f64 = 1e-3;

type Point = ([f64; 4], f64);

/// The parameters with the least `cost` near `start`, and that cost.
pub(super) fn minimum(cost: &impl Fn(&[f64; 4]) -> f64, start: [f64; 4]) -> Point {
    let point = |x: [f64; 4]| (x, cost(&x));
    let mut simplex: [Point; 5] = core::array::from_fn(|corner| {
        let mut x = start;
        if corner > 0 {
            let own = &mut x[corner - 1];
            *own = if *own == 0.0 { 0.2 } else { *own * 1.05 };
        }
        point(x)
    });
    for _ in 0..STEPS {
        simplex.sort_by(|a, b| a.1.total_cmp(&b.1));
        let [best, .., second, worst] = simplex;
        let size = simplex.iter().flat_map(|corner| (0..4).map(move |k| (corner.0[k] - best.0[k]).abs()));
        if worst.1 - best.1 < COST && size.fold(0.0, f64::max) < SIZE {
            break;
        }
        let mean: [f64; 4] =
            core::array::from_fn(|k| simplex[..4].iter().map(|corner| corner.0[k]).sum::<f64>() / 4.0);
        let along = |share: f64| point(core::array::from_fn(|k| mean[k] + share * (worst.0[k] - mean[k])));
        let reflected = along(-1.0);
        if reflected.1 < best.1 {
            let expanded = along(-2.0);
            simplex[4] = if expanded.1 < reflected.1 { expanded } else { reflected };
        } else if reflected.1 < second.1 {
            simplex[4] = reflected;
        } else {
            let contracted = along(if reflected.1 < worst.1 { -0.5 } else { 0.5 });
            if contracted.1 < reflected.1.min(worst.1) {
                simplex[4] = contracted;
            } else {
                for corner in &mut simplex[1..] {
                    *corner = point(core::array::from_fn(|k| 0.5 * (corner.0[k] + best.0[k])));
                }
            }
        }
    }
    simplex
        .into_iter()
        .reduce(|best, next| if next.1 < best.1 { next } else { best })
        .unwrap_or((start, f64::INFINITY))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_minimum_of_a_bent_valley_is_found() {
        let valley = |x: &[f64; 4]| {
            let (a, b) = (x[1] - x[0] * x[0], x[3] - x[2]);
            100.0 * a * a + (1.0 - x[0]) * (1.0 - x[0]) + 10.0 * b * b + (x[2] - 3.0) * (x[2] - 3.0)
        };
        let (x, cost) = minimum(&valley, [-1.0, 1.0, 0.0, 0.0]);
        assert!(cost < 1e-2 && (x[2] - 3.0).abs() < 0.1, "{x:?} {cost}");
    }
}
