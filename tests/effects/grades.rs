//! The grades of sensors.

use nalgebra::Vector3;
use sins::sensors::{Grade, Sensor, StreamKey, Triad, TriadParameters, paper_simulation2};

use crate::support::DEG;

const GRADES: [Grade; 5] =
    [Grade::Strategic, Grade::Navigation, Grade::Tactical, Grade::Industrial, Grade::Consumer];

/// Each grade is valid, and noisier than the one before.
#[test]
fn grades_are_in_order() {
    let mut walks = Vec::new();
    for grade in GRADES {
        let (gyro, accel) = grade.parameters();
        gyro.validate(Sensor::Gyro).unwrap();
        accel.validate(Sensor::Accelerometer).unwrap();
        grade.start().validate().unwrap();
        walks.push(gyro.random_walk.x);
    }
    assert!(walks.is_sorted(), "{walks:?}");
    assert_eq!(Grade::PaperSimulation2.parameters(), paper_simulation2());
}

/// Sensors of a grade scatter: no grade has a scale factor error or a misalignment that is the same in all its sensors.
#[test]
fn grades_scatter_about_the_ideal() {
    for grade in GRADES {
        let (gyro, accel) = grade.parameters();
        for triad in [gyro, accel] {
            assert_eq!((triad.scale_factor, triad.misalignment), Default::default(), "{grade:?}");
        }
    }
}

/// The angle between two axes of the industrial grade is off square by 0.1°, 1 σ: the mean square of 4000 runs is within five
/// of its standard deviations.
#[test]
fn industrial_axes_are_off_square_as_stated() {
    let (gyro, accel) = Grade::Industrial.parameters();
    for (sensor, misalignment_sigma) in
        [(Sensor::Gyro, gyro.misalignment_sigma), (Sensor::Accelerometer, accel.misalignment_sigma)]
    {
        let runs = 4000;
        let mut squares = Vector3::zeros();
        for run in 0..runs {
            let mut triad = Triad::new(StreamKey { seed: 1, run }, sensor);
            triad.set(&TriadParameters { misalignment_sigma, ..Default::default() });
            let errors = [0, 1, 2].map(|axis| {
                let unit = Vector3::ith(axis, 1.0);
                triad.steady_error(&unit, &unit, None)
            });
            let between = |i: usize, j: usize| errors[i][j] + errors[j][i];
            let angles = Vector3::new(between(0, 1), between(1, 2), between(2, 0));
            squares += angles.component_mul(&angles) / runs as f64;
        }
        let bound = 5.0 * (2.0 / runs as f64).sqrt();
        let ratios = squares / (0.1 * DEG).powi(2);
        assert!(ratios.iter().all(|ratio| (ratio - 1.0).abs() < bound), "{sensor:?}: {ratios}");
    }
}
