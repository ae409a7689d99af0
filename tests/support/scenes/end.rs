//! How a scene ends.

use sins::ErrorSource;
use sins::abi::sins_unit_status;
use sins::scene::{Play, Shown};

/// How the flight of a scene ends: the bits of the nine errors of the navigation, then of what the INS shows: place, velocity, roll,
/// pitch, heading, and the words of its validity and its state. `None`: an entry at the wrong moment ended it.
pub type End = Option<Vec<u64>>;

/// Flies to the end.
pub fn end_of(play: &mut Play) -> End {
    loop {
        match play.fly_next() {
            Ok(Some(_)) => {}
            Ok(None) => break,
            Err(stopped) => {
                assert!(stopped.to_string().contains("panel"), "{stopped}");
                return None;
            }
        }
    }
    let (_, errors) = play.simulator().errors(ErrorSource::Navigation).unwrap().unwrap();
    let Shown { status, navigation } = play.shown().unwrap().unwrap();
    let (place, euler) = (navigation.place, navigation.euler);
    let mut numbers = [errors.position_n, errors.velocity_n, errors.misalignment_n, navigation.v_n]
        .map(<[f64; 3]>::from)
        .to_vec();
    numbers.insert(3, [place.latitude_rad, place.longitude_rad, place.height_m]);
    numbers.push([euler.roll, euler.pitch, euler.heading]);
    let mut end: Vec<u64> = numbers.concat().into_iter().map(f64::to_bits).collect();
    let status = sins_unit_status::from(&status);
    end.extend([u64::from(status.validity), status.state as u64]);
    Some(end)
}

/// A line of ends.txt: name and end, in the words of `apps/cli/tests/program/door.c`.
pub fn line(name: &str, end: &End) -> String {
    let Some(words) = end else { return format!("{name} stopped\n") };
    let (numbers, [validity, state]) = words.split_last_chunk().unwrap();
    let numbers: Vec<String> = numbers.iter().map(|word| format!("{word:016x}")).collect();
    format!("{name} {} {validity} {state}\n", numbers.join(" "))
}
