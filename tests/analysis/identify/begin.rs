//! Where the fit begins: the piece of a long path to which a record belongs, and the axes of blocks that are turned by any angle.

use nalgebra::{Quaternion, Vector3};
use sins::analysis::identify::{Request, identify};
use sins::math::{rotation_matrix, rotation_vector};

use super::super::support::draws::Draws;
use super::{MINUTES, RATE_HZ, Unit, flight, normal, path};

/// Three minutes of a flight are found on all of it, quiet ones and those whose motion is repeated in other minutes, with the shift stated
/// and without. Nothing is said of the clock where it is not seen.
#[test]
fn three_minutes_of_a_flight_are_found_on_all_of_it() {
    let mut asked = 0;
    for (name, length_s) in [("patrol", 1080.0), ("commuter", 1080.0), ("aerobatics", 400.0)] {
        let flight = flight(name);
        let path = path(&flight, (0.0, length_s));
        let unit = Unit { behind_s: 3.7, ..Default::default() };
        let record = unit.record(&flight, (0.0, length_s));
        for piece in record.chunks_exact((180.0 * RATE_HZ) as usize) {
            let at = format!("{name}, from {} s", piece[0].time_s);
            for shift_s in [None, Some(3.0)] {
                let request = Request { shift_s, ..Default::default() };
                let one = match identify(&path, piece, &request) {
                    // Turns of a patrol are like those of its next round.
                    Err(error) if name == "patrol" && shift_s.is_none() => {
                        let text = error.to_string();
                        let numbers: Vec<f64> =
                            text.split([' ', ':']).filter_map(|word| word.parse().ok()).collect();
                        let is_named = numbers.iter().any(|number| (number - unit.behind_s).abs() < 0.5);
                        assert!(text.contains("and so does another one") && is_named, "{at}: {text}");
                        asked += 1;
                        continue;
                    }
                    answer => answer.unwrap_or_else(|error| panic!("{at}: {error}")),
                };
                let off_s = (one.offset_s.value - unit.behind_s).abs();
                let is_right = off_s < 5.0 * one.offset_s.sigma;
                assert!(is_right || !one.offset_s.is_seen(), "{at}: {:?}", one.offset_s);
                for sensor in 0..6 {
                    let bias = if sensor < 3 { one.gyro.bias[sensor] } else { one.accel.bias[sensor - 3] };
                    assert!(bias.value.abs() < 5.0 * bias.sigma, "{at}: {bias:?}");
                }
            }
        }
        // Three minutes of the path, and a record of the whole flight.
        let (from, to) = (length_s / 3.0, length_s / 3.0 + 180.0);
        let request = Request { shift_s: (name == "patrol").then_some(3.0), ..Default::default() };
        let piece = super::path(&flight, (from, to));
        let one = identify(&piece, &record, &request).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert!(
            (one.offset_s.value - unit.behind_s).abs() < 5.0 * one.offset_s.sigma,
            "{name}: {:?}",
            one.offset_s
        );
    }
    assert!(asked <= 4, "{asked} of 6");
}

/// A cruise straight on shows no clock: its record is not placed on the whole flight by chance, nor is the record of the whole flight
/// placed on its path.
#[test]
fn a_quiet_piece_needs_its_shift() {
    let commuter = flight("commuter");
    let (whole_s, cruise_s) = ((0.0, 1080.0), (506.0, 692.0));
    let (whole, cruise) = (path(&commuter, whole_s), path(&commuter, cruise_s));
    for run in 0..3 {
        let unit = Unit { behind_s: 129_511.2, run, ..Default::default() };
        let pairs = [(&whole, cruise_s), (&cruise, whole_s)];
        for (path, of_record) in pairs {
            let answer = identify(path, &unit.record(&commuter, of_record), &Request::default());
            let answer = answer.err().map_or("accepted".to_owned(), |error| error.to_string());
            let is_asked = answer.contains("must be stated") || answer.contains("so does another one");
            assert!(is_asked || answer.contains("of another motion"), "{run} {of_record:?}: {answer}");
        }
    }
}

/// Blocks that are turned by any rotation, those halfway between two exchanges of axes too.
#[test]
fn a_block_that_is_turned_by_any_rotation_is_found() {
    let aerobatics = flight("aerobatics");
    let path = path(&aerobatics, MINUTES);
    let mut draws = Draws::new(5);
    let drawn = (0..11).map(|_| Quaternion::from(nalgebra::Vector4::from_fn(|_, _| normal(&mut draws))));
    // 60 degrees about (1, 1, 1).
    let halfway =
        Quaternion::new(3f64.sqrt() / 2.0, 1.0 / 12f64.sqrt(), 1.0 / 12f64.sqrt(), 1.0 / 12f64.sqrt());
    for turned in drawn.collect::<Vec<_>>().into_iter().chain([halfway]).map(|one| one.normalize()) {
        let unit = Unit { rotation: rotation_matrix(&turned), ..Default::default() };
        let one = identify(&path, &unit.record(&aerobatics, MINUTES), &Request::default())
            .unwrap_or_else(|error| panic!("{turned}: {error}"));
        let mounting = rotation_matrix(&sins::math::rotation_quaternion(&Vector3::from_fn(|axis, _| {
            one.mounting[axis].value
        })));
        let off = unit.rotation * (mounting * one.axes.exchange).transpose();
        let off = off - nalgebra::Matrix3::identity();
        let sigma = one.mounting.iter().map(|angle| angle.sigma).fold(0.0, f64::max);
        assert!(
            off.norm() < 10.0 * sigma,
            "{turned}: {:e} of {sigma:e}, {:?}",
            off.norm(),
            rotation_vector(&turned)
        );
    }
}
