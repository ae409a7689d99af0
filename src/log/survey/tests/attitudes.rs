//! One flight with the attitudes of many loggers: each is read as it was flown, or asked about.

use super::super::super::FlightLog;
use super::conventions::{Row, assert_asks, flight, look, table, written};
use crate::scene::Scene;
use crate::truth::FlightSample;

/// The flight with an attitude, as roll, pitch and heading in degrees.
fn attitude(row: &Row) -> [f64; 3] {
    let is_turning = (20.0..40.0).contains(&row[0]);
    [if is_turning { 12.0 } else { 0.1 }, 2.5, row[5]]
}

#[test]
fn an_attitude_without_units_is_of_the_unit_in_which_the_heading_follows_the_track() {
    let rows = flight(47.3, 8.4);
    let text = |names: &str, of: fn([f64; 3]) -> [f64; 3], rows: &[Row]| {
        table(&format!("t,lat,lon,alt,{names}"), rows, |_, row| {
            let [roll, pitch, heading] = of(attitude(row));
            let place = format!("{:.1},{:.8},{:.8},{:.3}", row[0], row[1], row[2], row[3]);
            format!("{place},{roll:.6},{pitch:.6},{heading:.6}")
        })
    };
    let radians = |angles: [f64; 3]| angles.map(f64::to_radians);
    for (names, of) in [
        ("roll,pitch,yaw", radians as fn([f64; 3]) -> [f64; 3]),
        ("roll,pitch,yaw", |angles| angles),
        ("AngleRoll (rad),AnglePitch (rad),AngleHeading (rad)", radians),
        ("roll_rad,pitch_rad,heading_rad", radians),
        ("Roll[deg],Pitch[deg],Heading[deg]", |angles| angles),
    ] {
        let (found, samples) = look(&text(names, of, &rows));
        let samples = samples.unwrap_or_else(|error| panic!("{error:?} {found:?}"));
        for (sample, row) in samples.iter().zip(&rows) {
            let expected = attitude(row).map(f64::to_radians);
            let found = [sample.euler.roll, sample.euler.pitch, sample.euler.heading];
            let is_near = |axis: usize| (found[axis] - expected[axis]).abs() < 1e-5;
            assert!((0..3).all(is_near), "{names}: {found:?}, not {expected:?}");
        }
    }
    // Names that say another unit, or more than the angle: not read, and not passed over.
    for (names, answer) in [
        ("roll_cd,pitch_cd,yaw_cd", ", scale = 0.01 }"),
        ("Roll (mrad),Pitch (mrad),Yaw (mrad)", ", unit = \"rad\", scale = 0.001 }"),
        ("ekf_roll_est,ekf_pitch_est,heading", "heading = \"heading\"  # degrees"),
        ("roll,pitch,Yaw angle of EKF", "attitude = \"coordinated\"  # they are something else"),
    ] {
        assert_asks(&text(names, |angles| angles.map(|angle| 100.0 * angle), &rows), answer);
    }
    for names in ["roll_rate,pitch_rate,yaw_rate", "DesRoll,DesPitch,DesYaw", "roll_in,pitch_in,heading"] {
        let (found, _) = look(&text(names, |angles| angles, &rows));
        assert!(found.questions.is_empty(), "{names}: {found:?}");
    }
    for names in [
        "Roulis,Tangage,Cap",
        "Querneigung,Längsneigung,Kurs (steuerkurs)",
        "AHRS Roll,AHRS Pitch,heading (magnetic)",
    ] {
        let (found, samples) = look(&text(names, |angles| angles, &rows));
        let is_read = samples.as_ref().is_ok_and(|samples| samples[0].euler.pitch > 0.04);
        assert!(is_read || names.contains("Kurs"), "{names}: {found:?} {samples:?}");
    }
    // A flight to the north has a small heading in degrees.
    let mut north = rows.clone();
    for (index, row) in north.iter_mut().enumerate() {
        *row = [row[0], 47.0 + 7.2e-5 * index as f64, 8.4, row[3], 40.0, 3.0 + 0.01 * (index % 7) as f64];
    }
    let level = |angles: [f64; 3]| [0.1, angles[1], angles[2]];
    let (found, samples) = look(&text("roll,pitch,yaw", level, &north));
    assert!((samples.unwrap()[0].euler.heading.to_degrees() - 3.0).abs() < 1e-5, "{found:?}");
    // A position in another unit tells too.
    let minutes = table("t,lat,lon,alt,speed (m/s),course,roll,pitch,yaw", &rows, |_, row| {
        let [roll, pitch, heading] = attitude(row).map(f64::to_radians);
        let place = format!("{:.1},{},{},{:.3}", row[0], written(2, row[1]), written(2, row[2]), row[3]);
        format!("{place},{:.2},{:.1},{roll:.6},{pitch:.6},{heading:.6}", row[4], row[5])
    });
    let (found, samples) = look(&minutes);
    assert!((samples.unwrap()[0].euler.heading - 20.0_f64.to_radians()).abs() < 1e-5, "{found:?}");
    // Without motion nothing tells.
    let mut rest = rows.clone();
    rest.iter_mut().for_each(|row| *row = [row[0], 47.0, 8.4, row[3], 0.0, 3.0]);
    assert_asks(&text("roll,pitch,yaw", radians, &rest), "are they radians?");
    // Anticlockwise from the east, in either unit.
    for of in [
        (|[roll, pitch, heading]| [roll, -pitch, 90.0 - heading]) as fn([f64; 3]) -> [f64; 3],
        |[roll, pitch, heading]| [roll, -pitch, 90.0 - heading].map(f64::to_radians),
    ] {
        let found = assert_asks(&text("roll,pitch,yaw", of, &rows), "from the east");
        assert!(!found.text.contains("heading") && !found.text.contains("coordinated"), "{found:?}");
        assert_asks(&text("roll,pitch,yaw", of, &rows[..90]), "anticlockwise from east");
        // One of the answers is right.
        let answers = &found.questions[0].answers;
        let right = answers.iter().filter(|answer| {
            let keys: String =
                answer.lines().map(|line| line.split("  #").next().unwrap().to_owned() + "\n").collect();
            let scene = format!("[flight]\nfile = \"a.csv\"\n[log]\n{}{keys}", found.text);
            let scene = Scene::parse(scene.as_bytes()).unwrap_or_else(|faults| panic!("{faults:?}"));
            let log = FlightLog::parse_with(text("roll,pitch,yaw", of, &rows).as_bytes(), &scene.log);
            let is_right = |(sample, row): (&FlightSample, &Row)| {
                let expected = attitude(row).map(f64::to_radians);
                let heading = (sample.euler.heading - expected[2]).rem_euclid(core::f64::consts::TAU);
                (sample.euler.pitch - expected[1]).abs() < 1e-5
                    && heading.min(core::f64::consts::TAU - heading) < 1e-5
            };
            log.is_ok_and(|log| log.samples().iter().zip(&rows).all(is_right))
        });
        assert_eq!(right.count(), 1, "{answers:?}");
    }
}

#[test]
fn a_quaternion_is_read_if_its_heading_follows_the_track() {
    let rows = flight(47.3, 8.4);
    let text = |names: &str, of: fn([f64; 4]) -> [f64; 4]| {
        table(&format!("t,lat,lon,alt,{names}"), &rows, |_, row| {
            // Heading about down, then pitch about right, then roll about forward.
            let [roll, pitch, heading] = attitude(row).map(|angle| (0.5 * angle.to_radians()).sin_cos());
            let ((sr, cr), (sp, cp), (sh, ch)) = (roll, pitch, heading);
            let q = [
                cr * cp * ch + sr * sp * sh,
                sr * cp * ch - cr * sp * sh,
                cr * sp * ch + sr * cp * sh,
                cr * cp * sh - sr * sp * ch,
            ];
            let q = of(q).map(|part| format!("{part:.9}")).join(",");
            format!("{:.1},{:.8},{:.8},{:.3},{q}", row[0], row[1], row[2], row[3])
        })
    };
    for (names, of) in [
        ("qw,qx,qy,qz", (|q| q) as fn([f64; 4]) -> [f64; 4]),
        ("qx,qy,qz,qw", |[w, x, y, z]| [x, y, z, w]),
        ("q0,q1,q2,q3", |[w, x, y, z]| [w, -x, -y, -z]),
    ] {
        let (found, samples) = look(&text(names, of));
        for (sample, row) in samples.unwrap_or_else(|error| panic!("{error:?} {found:?}")).iter().zip(&rows) {
            let expected = attitude(row).map(f64::to_radians);
            let read = [sample.euler.roll, sample.euler.pitch, sample.euler.heading];
            assert!(
                (0..3).all(|axis| (read[axis] - expected[axis]).abs() < 1e-6),
                "{names}: {read:?}, not {expected:?}"
            );
        }
    }
    // Forward-left-up to east-north-up, as in ROS.
    let of_ros = |[w, x, y, z]: [f64; 4]| {
        let half = core::f64::consts::FRAC_1_SQRT_2;
        [half * (w + z), half * (x + y), half * (x - y), half * (w - z)]
    };
    assert_asks(&text("qw,qx,qy,qz", of_ros), "of which axes is it?");
}
