//! A run in one sentence, and whether its errors are more than rounding.

use crate::drawing::series::magnitude;
use crate::report::run::Run;
use crate::report::summary::Row;
use crate::units::{LENGTH, time_text, with_unit};

/// Largest errors that are rounding: a thousand roundings of the Earth's radius [m], and of a tenth of the speed of a bullet [m/s].
const ROUNDING_M: f64 = 1e-6;
const ROUNDING_M_S: f64 = 1e-9;

/// Ratio of the largest error to that at the end from which both are reported.
const PASSED: f64 = 1.2;

/// Whether the errors of `run` are those of rounding.
pub fn is_rounding(run: &Run) -> bool {
    let below = |three: &[Vec<f64>; 3], limit: f64| three.iter().all(|values| magnitude(values) <= limit);
    below(&run.errors.position_m, ROUNDING_M) && below(&run.errors.velocity_m_s, ROUNDING_M_S)
}

/// The errors at the end, their growth, and how well the error equations agree.
pub fn sentence(run: &Run) -> String {
    let after = time_text(run.duration_s());
    let radius = radius(run);
    let largest = magnitude(&radius);
    let figure = |key: &str| run.summary.row(key).filter(|row| row.value != "none").map(Row::text);
    if is_rounding(run) {
        let size = run.errors.position_m.iter().map(|values| magnitude(values)).fold(0.0, f64::max);
        return format!("In {after} there is no error beyond rounding: at most {}.", with_unit(size, LENGTH));
    }
    let end = radius.last().copied().unwrap_or(0.0);
    let mut sentence = format!("After {after} the INS is {} off", with_unit(end, LENGTH));
    if largest > PASSED * end {
        sentence += &format!(", at most {}", with_unit(largest, LENGTH));
    }
    if let Some(rate) = figure("r50_nmi_h") {
        let from_s = run.summary.number("nav_from_s").filter(|from_s| *from_s > 0.0);
        let since = from_s.map_or(String::new(), |from_s| format!(" since NAV at {}", time_text(from_s)));
        sentence += &format!(", R50 {rate}{since}");
    }
    let up = run.errors.position_m[2].last().copied().unwrap_or(0.0);
    if !run.follows_height() && up.abs() > end {
        let side = if up > 0.0 { "high" } else { "low" };
        sentence += &format!(", and {} too {side}", with_unit(up.abs(), LENGTH));
    }
    if let Some(difference) = figure("max_model_difference_position_m").filter(|_| run.model.is_some()) {
        sentence += &format!("; the error equations agree to {difference}");
    }
    sentence + "."
}

/// Horizontal distance from the truth [m].
pub fn radius(run: &Run) -> Vec<f64> {
    let [east, north, _] = &run.errors.position_m;
    east.iter().zip(north).map(|(east, north)| east.hypot(*north)).collect()
}

/// The run that says most: the one with the largest horizontal error; the first one if all errors are rounding.
pub fn most_telling(runs: &[Run]) -> usize {
    let size = |run: &Run| if is_rounding(run) { 0.0 } else { magnitude(&radius(run)) };
    let sizes = runs.iter().map(size).enumerate();
    sizes.fold((0, 0.0), |most, (place, size)| if size > most.1 { (place, size) } else { most }).0
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::run::tests::made;

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
        assert_eq!(sentence(&rounding), "In 5.6 h there is no error beyond rounding: at most 7.996×10⁻⁸ m.");
        let runs = [rounding, far(0.1), far(0.2), far(0.05)];
        assert_eq!((most_telling(&runs), most_telling(&runs[..1])), (2, 0));
        assert_eq!(runs.each_ref().map(is_rounding), [true, false, false, false]);
    }
}
