//! The points that are worth their cost.

use super::survey::{Measured, Point, Survey};
use crate::units::two_digits;

/// Marks the Pareto front: a point is on the front if no other point is both as cheap and as accurate.
pub fn mark(points: &mut [Point]) {
    let mut order: Vec<(usize, Measured)> =
        points.iter().enumerate().filter_map(|(k, point)| Some((k, *point.eligible()?))).collect();
    order.sort_by(|(_, a), (_, b)| {
        a.cost_ns.total_cmp(&b.cost_ns).then(a.position_m().total_cmp(&b.position_m()))
    });
    let mut best = f64::INFINITY;
    for (k, measured) in order {
        if measured.position_m() < best {
            best = measured.position_m();
            points[k].is_on_front = true;
        }
    }
}

/// The front from the cheapest to the most accurate.
pub fn front(points: &[Point]) -> Vec<(&Point, &Measured)> {
    let on_front = points.iter().filter(|point| point.is_on_front);
    let mut front: Vec<_> = on_front.filter_map(|point| Some((point, point.eligible()?))).collect();
    front.sort_by(|(_, a), (_, b)| a.cost_ns.total_cmp(&b.cost_ns));
    front
}

/// The cheapest point with a position error of at most `position_m` [m].
pub fn cheapest(points: &[Point], position_m: f64) -> Option<(&Point, &Measured)> {
    front(points).into_iter().find(|(_, measured)| measured.position_m() <= position_m)
}

/// The rung that beats `point`, with the ratio of their errors: the most accurate of the cheaper rungs of the default family at the
/// same rate, if `point` is of that family and its error is more than `floor_m` [m] larger. Cost is counted in instructions,
/// because clocks are noisy.
pub fn beaten_by<'a>(points: &'a [Point], point: &Point, floor_m: f64) -> Option<(&'a Point, f64)> {
    let instructions = |point: &Point| point.configuration.rung.instructions(point.configuration.frame);
    let own_m = point.eligible().filter(|_| point.configuration.is_default_family())?.position_m();
    points
        .iter()
        .filter(|other| other.configuration.is_default_family() && other.rate_hz == point.rate_hz)
        .filter(|other| instructions(other) < instructions(point))
        .filter_map(|other| Some((other, other.eligible()?.position_m())))
        .min_by(|(_, a), (_, b)| a.total_cmp(b))
        .filter(|(_, other_m)| own_m > other_m + floor_m)
        .map(|(other, other_m)| (other, own_m / other_m))
}

/// A line for each rung of the default family that is beaten on a scene. The line has the better rung, the rate with the largest
/// ratio of errors, and the number of rates.
pub fn costlier_and_less_accurate(surveys: &[Survey]) -> Vec<String> {
    let mut lines = Vec::new();
    for survey in surveys {
        let beaten: Vec<_> = survey
            .points
            .iter()
            .filter_map(|point| Some((point, beaten_by(&survey.points, point, survey.floor.position_m)?)))
            .collect();
        let mut names: Vec<String> = beaten.iter().map(|(point, _)| point.configuration.name()).collect();
        names.sort();
        names.dedup();
        for name in names {
            let own: Vec<_> = beaten.iter().filter(|(point, _)| point.configuration.name() == name).collect();
            if let Some((point, (other, factor))) = own.iter().max_by(|a, b| a.1.1.total_cmp(&b.1.1)) {
                lines.push(format!(
                    "{}: {name} is costlier and less accurate than {} at {} Hz, {} times its error; beaten at {}",
                    survey.name,
                    other.configuration.name(),
                    point.rate_hz,
                    two_digits(*factor),
                    if own.len() == 1 {
                        "this rate only".to_owned()
                    } else {
                        format!("{} rates", own.len())
                    },
                ));
            }
        }
    }
    lines
}

#[cfg(test)]
pub mod tests {
    use super::*;
    use crate::curve::configuration::Configuration;
    use crate::curve::reference::Judgement;
    use sins::analysis::recommend::SolutionError;
    use sins::mechanization::Frame;

    /// A point of the configuration `index` of the matrix.
    pub fn made(index: usize, cost_ns: f64, position_m: f64) -> Point {
        let error = SolutionError { position_m, ..Default::default() };
        Point {
            configuration: Configuration::all()[index],
            rate_hz: 50.0,
            is_undersampled: false,
            measured: Ok(Measured { cost_ns, judgement: Judgement { error, at_floor: [false; 3] } }),
            is_on_front: false,
        }
    }

    #[test]
    fn the_front_only_improves() {
        let mut points = vec![
            made(2, 10.0, 1.0),
            made(3, 20.0, 2.0),
            made(4, 30.0, 0.5),
            made(5, 30.0, 0.4),
            made(6, 40.0, 0.4),
            Point { is_undersampled: true, ..made(7, 1.0, 1e-9) },
            Point { measured: Err("singular".into()), ..made(8, 0.0, 0.0) },
        ];
        mark(&mut points);
        let on: Vec<bool> = points.iter().map(|point| point.is_on_front).collect();
        assert_eq!(on, [true, false, false, true, false, false, false]);
        let position = |limit| cheapest(&points, limit).map(|(_, measured)| measured.cost_ns);
        assert_eq!((position(1.0), position(0.99), position(0.1)), (Some(10.0), Some(30.0), None));
    }

    #[test]
    fn beaten_rungs_are_listed() {
        let mut points =
            vec![made(3, 1.0, 1e-3), made(4, 1.0, 36.420_022), made(3, 1.0, 1e-3), made(5, 1.0, 2e-3)];
        (points[2].rate_hz, points[3].rate_hz) = (20.0, 20.0);
        let again =
            [Point { rate_hz: 10.0, ..points[0].clone() }, Point { rate_hz: 10.0, ..points[1].clone() }];
        points.extend(again);
        let lines = costlier_and_less_accurate(&[Survey::made("loop", 1.0, points, [0.0; 2])]);
        assert!(lines[0].ends_with("36000 times its error; beaten at 2 rates"), "{}", lines[0]);
        assert!(lines[1].ends_with("2.0 times its error; beaten at this rate only"), "{}", lines[1]);
    }

    #[test]
    fn a_costlier_rung_that_is_less_accurate_is_found() {
        // Earth-fixed: paper 1 and 2, exact 1 to 5, polynomial 1 to 5.
        let points = vec![made(3, 1.0, 1e-3), made(4, 1.0, 2e-3), made(5, 1.0, 1.01e-3), made(1, 1.0, 1e-9)];
        let beaten = |k: usize| beaten_by(&points, &points[k], 1e-4);
        assert_eq!(beaten(1), Some((&points[0], 2.0)));
        assert_eq!((beaten(0), beaten(2)), (None, None), "cheapest; within the floor");
        assert_eq!(beaten(3), None, "the paper's is not of the family");
        let geographic = Point {
            configuration: Configuration { frame: Frame::Geographic, ..points[1].configuration },
            ..points[1].clone()
        };
        assert_eq!(beaten_by(&points, &geographic, 0.0), None);
    }
}
