//! FlightGear's native FDM packet (`net_fdm.hxx`): big-endian, without padding.
//!
//! | offset | | unit |
//! |---|---|---|
//! | 0 | version, 32 bits; 4 more are padding | |
//! | 8, 16 | longitude, geodetic latitude, double | rad |
//! | 24 | altitude above mean sea level, double | m |
//! | 36, 40, 44 | roll, pitch, true heading, float | rad |
//! | 72 | climb rate, float | ft/s |
//! | 76, 80, 84 | velocity north, east, down, float | ft/s |
//! | 88, 92, 96 | velocity forward, right, down along the body, float | ft/s |
//!
//! The rest is heights above ground, rates, accelerations, engines, tanks, gear, Unix time and control surfaces. Version 25 has
//! 144 bytes of tanks more.

use nalgebra::Vector3;
use sins::earth::Geodetic;
use sins::math::{Euler, attitude_from_euler, rotate_inverse};
use sins::truth::FlightSample;
use sins::unit::UnitNavigation;

use super::packet::{Refused, Why};

/// Versions and their lengths [bytes].
const VERSIONS: [(u32, usize); 2] = [(24, 408), (25, 552)];

/// International foot [m].
const FOOT_M: f64 = 0.3048;

const LONGITUDE: usize = 8;
const LATITUDE: usize = 16;
const ALTITUDE: usize = 24;
const ROLL: usize = 36;
const PITCH: usize = 40;
const HEADING: usize = 44;
const CLIMB_RATE: usize = 72;
const NORTH: usize = 76;
const EAST: usize = 80;
const DOWN: usize = 84;
const FORWARD: usize = 88;
const RIGHT: usize = 92;
const BELOW: usize = 96;

/// The sample in a packet, which carries no time. The altitude is taken for the height.
pub fn decode(packet: &[u8]) -> Result<FlightSample, Refused> {
    if VERSIONS.iter().all(|(_, length)| packet.len() != *length) {
        let sentence = format!("{} bytes: version 24 has 408, version 25 has 552", packet.len());
        return Err(Refused::new(Why::Length, sentence));
    }
    let version = u32::from_be_bytes(bytes(packet, 0));
    if !VERSIONS.contains(&(version, packet.len())) {
        let sentence = format!("version {version} in {} bytes: must be 24 or 25", packet.len());
        return Err(Refused::new(Why::Version, sentence));
    }
    if is_swapped(packet) {
        let sentence = "the version is big-endian, and longitude, latitude and altitude are little-endian; send every number in network \
            byte order, the highest byte first";
        return Err(Refused::new(Why::Foreign, sentence));
    }
    let double = |name: &str, at: usize| finite(name, f64::from_be_bytes(bytes(packet, at)));
    let float = |name: &str, at: usize| finite(name, f32::from_be_bytes(bytes(packet, at)).into());
    let velocity = |name: &str, at: usize| Ok(FOOT_M * float(name, at)?);
    Ok(FlightSample {
        time_s: 0.0,
        place: Geodetic {
            latitude_rad: double("latitude", LATITUDE)?,
            longitude_rad: double("longitude", LONGITUDE)?,
            height_m: double("altitude", ALTITUDE)?,
        },
        v_n: Some(Vector3::new(
            velocity("v_east", EAST)?,
            velocity("v_north", NORTH)?,
            -velocity("v_down", DOWN)?,
        )),
        euler: Euler {
            roll: float("phi", ROLL)?,
            pitch: float("theta", PITCH)?,
            heading: float("psi", HEADING)?,
        },
        omega_ib_b: None,
        f_b: None,
        temperature_c: None,
    })
}

/// The packet of what an INS shows: position, attitude and velocity. The rest is that of `received`, otherwise 0.
pub fn encode(shown: &UnitNavigation, received: Option<&[u8]>) -> Vec<u8> {
    let (version, length) = VERSIONS[0];
    let mut packet = received.map_or_else(|| vec![0; length], <[u8]>::to_vec);
    if received.is_none() {
        packet[..4].copy_from_slice(&version.to_be_bytes());
    }
    let UnitNavigation { place, v_n, euler, .. } = shown;
    for (at, value) in
        [(LONGITUDE, place.longitude_rad), (LATITUDE, place.latitude_rad), (ALTITUDE, place.height_m)]
    {
        packet[at..at + 8].copy_from_slice(&value.to_be_bytes());
    }
    // Right, forward, up.
    let body = rotate_inverse(&attitude_from_euler(euler), v_n);
    let velocities = [
        (CLIMB_RATE, v_n.z),
        (NORTH, v_n.y),
        (EAST, v_n.x),
        (DOWN, -v_n.z),
        (FORWARD, body.y),
        (RIGHT, body.x),
        (BELOW, -body.z),
    ];
    let angles = [(ROLL, euler.roll), (PITCH, euler.pitch), (HEADING, euler.heading)];
    for (at, value) in velocities.map(|(at, m_s)| (at, m_s / FOOT_M)).into_iter().chain(angles) {
        packet[at..at + 4].copy_from_slice(&(value as f32).to_be_bytes());
    }
    packet
}

/// Whether the doubles are numbers of an aircraft in the other byte order alone.
fn is_swapped(packet: &[u8]) -> bool {
    let is_usual = |value: f64| value == 0.0 || (1e-9..1e8).contains(&value.abs());
    let all = |read: fn([u8; 8]) -> f64| {
        [LONGITUDE, LATITUDE, ALTITUDE].into_iter().all(|at| is_usual(read(bytes(packet, at))))
    };
    !all(f64::from_be_bytes) && all(f64::from_le_bytes)
}

fn bytes<const N: usize>(packet: &[u8], at: usize) -> [u8; N] {
    std::array::from_fn(|k| packet[at + k])
}

fn finite(name: &str, value: f64) -> Result<f64, Refused> {
    if value.is_finite() { Ok(value) } else { Err(Refused::not_a_number(name, value)) }
}

#[cfg(test)]
mod tests {
    use sins::unit::Validity;

    use super::*;

    fn shown() -> UnitNavigation {
        UnitNavigation {
            time_s: 3.0,
            validity: Validity::default(),
            place: Geodetic { latitude_rad: -0.7, longitude_rad: 2.5, height_m: 1234.5 },
            v_n: Vector3::new(30.0, -40.0, 2.0),
            euler: Euler { roll: 0.3, pitch: -0.1, heading: 2.4 },
            ..UnitNavigation::default()
        }
    }

    /// Doubles come back to the bit, floats to half a unit in the last place.
    #[test]
    fn what_is_encoded_is_decoded() {
        let shown = shown();
        let packet = encode(&shown, None);
        assert_eq!(packet.len(), 408);
        let sample = decode(&packet).unwrap();
        assert_eq!(sample.place, shown.place);
        let pairs = [
            (sample.euler.roll, shown.euler.roll),
            (sample.euler.pitch, shown.euler.pitch),
            (sample.euler.heading, shown.euler.heading),
        ];
        let v_n = sample.v_n.unwrap();
        for (found, sent) in pairs.into_iter().chain((0..3).map(|k| (v_n[k], shown.v_n[k]))) {
            assert!((found - sent).abs() <= 0.5 * f64::from(f32::EPSILON) * sent.abs(), "{found} {sent}");
        }
        // North, in ft/s, at byte 76.
        assert_eq!(packet[76..80], (-40.0_f32 / 0.3048).to_be_bytes());
        let at = |k: usize| f64::from(f32::from_be_bytes(bytes(&packet, k)));
        let speed = (at(88).powi(2) + at(92).powi(2) + at(96).powi(2)).sqrt() * FOOT_M;
        assert!((speed - shown.v_n.norm()).abs() < 1e-5);
    }

    #[test]
    fn the_rest_of_a_received_packet_goes_back() {
        let mut received = vec![7; 552];
        received[..4].copy_from_slice(&25_u32.to_be_bytes());
        let packet = encode(&shown(), Some(&received));
        assert_eq!((packet.len(), &packet[100..]), (552, &received[100..]));
        assert_eq!((&packet[32..36], &packet[48..72]), (&received[32..36], &received[48..72]));
        assert_eq!(decode(&packet).unwrap().place, shown().place);
    }

    #[test]
    fn wrong_packets_are_named() {
        let good = encode(&shown(), None);
        let why = |packet: &[u8]| {
            let refused = decode(packet).unwrap_err();
            (refused.why, refused.sentence)
        };
        assert_eq!(
            why(&good[..407]),
            (Why::Length, "407 bytes: version 24 has 408, version 25 has 552".into())
        );
        assert_eq!(why(&[]).0, Why::Length);
        let with = |at: usize, bytes: &[u8]| {
            let mut packet = good.clone();
            packet[at..at + bytes.len()].copy_from_slice(bytes);
            packet
        };
        assert_eq!(why(&with(0, &25_u32.to_be_bytes())).1, "version 25 in 408 bytes: must be 24 or 25");
        // A little-endian sender, of all numbers or of the doubles alone.
        assert_eq!(why(&with(0, &24_u32.to_le_bytes())).0, Why::Version);
        let mut swapped = good.clone();
        [8, 16, 24].into_iter().for_each(|at| swapped[at..at + 8].reverse());
        let (kind, sentence) = why(&swapped);
        assert!(kind == Why::Foreign && sentence.contains("altitude are little-endian"), "{sentence}");
        for (name, at) in [("longitude", 8), ("latitude", 16), ("altitude", 24)] {
            let found = why(&with(at, &f64::NAN.to_be_bytes()));
            assert_eq!(found, (Why::NotANumber, format!("{name} = NaN: must be a finite number")));
        }
        for (name, at) in
            [("phi", 36), ("theta", 40), ("psi", 44), ("v_north", 76), ("v_east", 80), ("v_down", 84)]
        {
            let found = why(&with(at, &f32::INFINITY.to_be_bytes()));
            assert_eq!(found, (Why::NotANumber, format!("{name} = inf: must be a finite number")));
        }
    }
}
