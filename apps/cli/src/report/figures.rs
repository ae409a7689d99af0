//! The figures of a run in their order.

use crate::drawing::figure::Figure;
use crate::failure::Failure;
use crate::report::errors::{self, ATTITUDE, POSITION, VELOCITY};
use crate::report::run::Run;
use crate::report::{radial, sensors, spectrum, trajectory};
use crate::units;

/// Height of the figures below those of the errors [drawing units].
pub const LOWER: f64 = 440.0;

/// The trajectory and the position errors of `run`, side by side.
pub fn first(run: &Run) -> Result<[Figure; 2], Failure> {
    let height = errors::height(run);
    Ok([trajectory::figure(run, height)?, errors::figure(run, &POSITION)?])
}

/// The other figures of `run` in reading order, except for empty figures. Two that stand side by side have one height.
pub fn others(run: &Run) -> Result<Vec<Figure>, Failure> {
    let mut figures = vec![errors::figure(run, &VELOCITY)?, errors::figure(run, &ATTITUDE)?];
    figures.push(radial::figure(run)?);
    figures.extend(spectrum::figure(run)?);
    figures.extend(sensors::figure(run, "Gyro errors", &run.gyro_error_rad_s, units::DEG_PER_HOUR)?);
    figures.extend(sensors::figure(run, "Accelerometer errors", &run.accel_error_m_s2, units::MICRO_G)?);
    Ok(figures)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::run::tests::made;

    fn titles(run: &Run) -> Vec<String> {
        let figures = first(run).unwrap().into_iter().chain(others(run).unwrap());
        figures.map(|figure| figure.title).collect()
    }

    #[test]
    fn a_run_of_zeros_still_has_its_figures() {
        let titles = titles(&made(3, |_, _| 0.0));
        assert_eq!(titles.len(), 5, "trajectory, three errors, radial: {titles:?}");
    }

    #[test]
    fn sensor_errors_and_spectrum_come_where_there_is_something() {
        let run = made(3000, |name, t| match name {
            "gyro_error_z_rad_s" => 1e-8,
            "navigation_error_velocity_east_m_s" => (t / 806.0).sin(),
            _ => 0.0,
        });
        let titles = titles(&run);
        assert!(
            titles.iter().any(|title| title.starts_with("Spectrum"))
                && titles.contains(&"Gyro errors".into())
        );
        assert!(!titles.contains(&"Accelerometer errors".into()));
    }
}
