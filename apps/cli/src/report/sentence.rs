//! A run in one sentence, and whether its errors are more than rounding.

use crate::answer::{self, Answer};
use crate::drawing::series::magnitude;
use crate::report::run::Run;
use crate::units::NMI_PER_HOUR;

/// Whether the errors of `run` are those of rounding.
pub fn is_rounding(run: &Run) -> bool {
    answer::is_rounding(largest(&run.errors.position_m), largest(&run.errors.velocity_m_s))
}

/// The errors at the end, their growth, and how well the error equations agree.
pub fn sentence(run: &Run) -> String {
    let figure = |key| run.summary.number(key);
    // A summary without a begin of NAV is that of a unit that did not navigate; a record of another program has no summary.
    let nav_from_s = figure("nav_from_s").or_else(|| figure("interrupted").is_none().then_some(0.0));
    if nav_from_s.is_some() && is_rounding(run) {
        return answer::of_rounding(run.duration_s(), largest(&run.errors.position_m));
    }
    let radius = radius(run);
    let last = |values: &[f64]| values.last().copied().unwrap_or(0.0);
    let answer = Answer {
        duration_s: run.duration_s(),
        end_m: (last(&radius), last(&run.errors.position_m[2])),
        largest_m: magnitude(&radius),
        follows_height: run.follows_height(),
        is_stopped: figure("interrupted") == Some(1.0),
        nav_from_s,
        r50: figure("r50_nmi_h").map(|rate| rate * NMI_PER_HOUR.si),
        difference_m: figure("max_model_difference_position_m").filter(|_| run.model.is_some()),
    };
    answer.sentence()
}

/// Largest length of the vectors with these components.
fn largest([east, north, up]: &[Vec<f64>; 3]) -> f64 {
    let lengths = east.iter().zip(north).zip(up).map(|((east, north), up)| east.hypot(*north).hypot(*up));
    lengths.fold(0.0, f64::max)
}

/// Horizontal distance from the truth [m].
pub fn radius(run: &Run) -> Vec<f64> {
    let [east, north, _] = &run.errors.position_m;
    east.iter().zip(north).map(|(east, north)| east.hypot(*north)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::run::tests::made;
    use crate::report::summary::Row;

    #[test]
    fn a_run_is_one_sentence() {
        let far = |scale: f64| {
            made(2000, move |name, t| match name {
                "navigation_error_position_east_m" => scale * 3.0 * t,
                "navigation_error_position_north_m" => scale * 4.0 * t,
                "model_error_flags" => 4.0,
                _ => 0.0,
            })
        };
        let mut run = far(0.1);
        assert_eq!(sentence(&run), "After 5.6 h the INS is 9.995 km off.");
        run.summary.rows.push(Row::made("r50_nmi_h", "0.25", "nmi/h"));
        run.errors.position_m[2] = vec![-20e3; 2000];
        assert_eq!(
            sentence(&run),
            "After 5.6 h the INS is 9.995 km off, R50 0.2500 nmi/h, and 20.00 km too low."
        );
        run.errors.position_m[0][1000] = 30e3;
        run.summary.rows.push(Row::made("vertical", "follow", ""));
        assert!(sentence(&run).starts_with("After 5.6 h the INS is 9.995 km off, at most 30.27 km, R50 "));

        let rounding = far(1e-12);
        assert_eq!(sentence(&rounding), "In 5.6 h there is no error beyond rounding: at most 9.995×10⁻⁸ m.");
        let runs = [rounding, far(0.1), far(0.2), far(0.05)];
        assert_eq!(runs.each_ref().map(is_rounding), [true, false, false, false]);
    }
}
