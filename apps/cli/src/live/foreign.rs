//! Packets that are no samples, by what they are: the message says what to change in the flight simulator.

use super::packet::{Format, Refused, Why};

/// What FlightGear is to send.
const NATIVE_FDM: &str = "start FlightGear with --native-fdm=socket,out,60,HOST,PORT,udp";

/// What to use instead of a packet that lacks quantities or digits.
const GENERIC: &str = "send lines of --format generic";

/// What X-Plane is to send.
const PLUGIN: &str = "switch it off, and let the plugin PI_sins_live.py send --format generic";

/// Beginnings of packets: what they are, and what to change.
const BEGINNINGS: [(&[u8], &str, &str); 19] = [
    (b"DATA", "X-Plane's data output", PLUGIN),
    (b"RREF", "X-Plane's answer to RREF", PLUGIN),
    (b"RPOS", "X-Plane's answer to RPOS", PLUGIN),
    (b"RADR", "X-Plane's answer to RADR", PLUGIN),
    (b"BECN", "X-Plane's beacon", PLUGIN),
    (b"DREF", "a request to X-Plane", "send samples here, and requests to X-Plane"),
    (b"CMND", "a request to X-Plane", "send samples here, and requests to X-Plane"),
    (b"XGPS", "a message for ForeFlight, without a vertical velocity", GENERIC),
    (b"XATT", "a message for ForeFlight, without a position", GENERIC),
    (b"XTRA", "a message for ForeFlight about other aircraft", GENERIC),
    (b"FGFS", "FlightGear's multiplayer packet", NATIVE_FDM),
    (b"SFGF", "FlightGear's multiplayer packet, little-endian", NATIVE_FDM),
    (b"<LABELS>", "JSBSim's output of type SOCKET", "use type=\"FLIGHTGEAR\" protocol=\"UDP\""),
    (b"<", "a text in XML", GENERIC),
    (b"$", "a sentence of NMEA 0183, without an attitude", GENERIC),
    (b"!AI", "a sentence of NMEA 0183 about ships", GENERIC),
    (b"#bundle", "a message of Open Sound Control", GENERIC),
    (b"MSG,", "a message of an ADS-B receiver", GENERIC),
    (b"[", "an array in JSON", "send one object for each sample"),
];

/// What a packet that `wanted` cannot decode is; `None`: nobody knows.
pub fn recognized(packet: &[u8], wanted: Format) -> Option<Refused> {
    let (what, mut change) = known(packet, wanted)?;
    if change == NATIVE_FDM && wanted != Format::Fgfs {
        change += ", and use --format fgfs";
    }
    Some(Refused::new(Why::Foreign, format!("{} bytes: {what}; {change}", packet.len())))
}

fn known(packet: &[u8], wanted: Format) -> Option<(String, String)> {
    let of = |what: &str, change: &str| Some((what.to_owned(), change.to_owned()));
    let others = [Format::Fgfs, Format::Generic, Format::Json].into_iter().filter(|format| *format != wanted);
    for format in others {
        if format.is(packet) {
            let name = format.name();
            return of(&format!("a sample of format {name}"), &format!("use --format {name}"));
        }
    }
    if let Some(native) = native(packet) {
        return Some(native);
    }
    let text = packet.trim_ascii_start();
    if wanted != Format::Json && text.starts_with(b"{") {
        return of("an object in JSON", "use --format json, with its ten keys");
    }
    if let Some((_, what, change)) = BEGINNINGS.iter().find(|(begin, ..)| text.starts_with(begin)) {
        return of(what, change);
    }
    match packet {
        [0x7e, .., 0x7e] => of("a message of GDL 90", GENERIC),
        [0xfe, length, ..] if packet.len() == usize::from(*length) + 8 => {
            of("a message of MAVLink 1", GENERIC)
        }
        [0xfd, length, ..] if [12, 25].contains(&(packet.len().wrapping_sub(usize::from(*length)))) => {
            of("a message of MAVLink 2", GENERIC)
        }
        // Protocol version, exercise, type, family, time stamp of 4 bytes, length.
        [4..=7, _, 1, 1, _, _, _, _, high, low, ..]
            if packet.len() == usize::from(u16::from_be_bytes([*high, *low])) =>
        {
            of("an entity state of DIS (IEEE 1278)", GENERIC)
        }
        _ => None,
    }
}

/// FlightGear's packets that are no sample: of another kind, of another version, or in the byte order of the sender.
fn native(packet: &[u8]) -> Option<(String, String)> {
    let (begin, length) = (*packet.first_chunk()?, packet.len());
    for (version, order) in [(u32::from_be_bytes(begin), ""), (u32::from_le_bytes(begin), ", little-endian")]
    {
        let what = match (version, length) {
            (24, 408) | (25, 552) if order.is_empty() => {
                let what = "FlightGear's native FDM packet";
                return Some((what.to_owned(), "use --format fgfs".to_owned()));
            }
            (24, 408) | (25, 552) => {
                let what = format!("the native FDM packet, version {version}, little-endian");
                return Some((
                    what,
                    "send every number in network byte order, the highest byte first".into(),
                ));
            }
            (27, 744) | (20..=28, 500..=800) => "native controls (native-ctrls)",
            // 104 bytes if the sender packs its struct, 112 as a compiler aligns it; each further tank has 4.
            (3..=8, 84..=260) => "native values for a panel (native-gui)",
            (10..=25, 200..=560) => "native FDM packet, of another version or length",
            _ => continue,
        };
        let change = if what.contains("FDM") {
            "versions 24 with 408 bytes and 25 with 552 are flown"
        } else {
            NATIVE_FDM
        };
        return Some((format!("FlightGear's {what}, version {version}{order}"), change.to_owned()));
    }
    None
}

#[cfg(test)]
mod tests {
    use super::super::text::COLUMNS;
    use super::*;

    /// A packet with this version, in big-endian or little-endian order.
    fn native_packet(version: u32, length: usize, is_little: bool) -> Vec<u8> {
        let begin = if is_little { version.to_le_bytes() } else { version.to_be_bytes() };
        let mut packet = begin.to_vec();
        packet.resize(length, 0);
        packet
    }

    fn of(begin: &[u8], length: usize) -> Vec<u8> {
        let mut packet = begin.to_vec();
        packet.resize(length, 1);
        packet
    }

    #[test]
    fn packets_of_others_are_named() {
        let line = b"1,2,3,4,5,6,7,8,9,10".to_vec();
        let members: Vec<String> = COLUMNS.iter().map(|name| format!("\"{name}\":1")).collect();
        let json = format!("{{{}}}", members.join(",")).into_bytes();
        let mut entity = of(&[7, 1, 1, 1, 0, 0, 0, 0, 0, 144], 144);
        entity[9] = 144;
        for (format, packet, words) in [
            (
                Format::Fgfs,
                native_packet(24, 408, true),
                "408 bytes: the native FDM packet, version 24, little-endian; send",
            ),
            (
                Format::Fgfs,
                native_packet(25, 552, true),
                "552 bytes: the native FDM packet, version 25, little-endian",
            ),
            (
                Format::Fgfs,
                native_packet(27, 744, false),
                "744 bytes: FlightGear's native controls (native-ctrls), version 27; start",
            ),
            (
                Format::Fgfs,
                native_packet(27, 744, true),
                "native controls (native-ctrls), version 27, little-endian; start",
            ),
            (
                Format::Fgfs,
                native_packet(7, 104, false),
                "104 bytes: FlightGear's native values for a panel (native-gui), version 7",
            ),
            (
                Format::Fgfs,
                native_packet(8, 112, false),
                "112 bytes: FlightGear's native values for a panel (native-gui), version 8",
            ),
            (Format::Json, native_packet(27, 744, false), "HOST,PORT,udp, and use --format fgfs"),
            (
                Format::Json,
                native_packet(7, 224, false),
                "(native-gui), version 7; start FlightGear with --native-fdm=",
            ),
            (
                Format::Fgfs,
                native_packet(22, 384, false),
                "of another version or length, version 22; versions 24",
            ),
            (Format::Generic, native_packet(24, 408, false), "a sample of format fgfs; use --format fgfs"),
            (Format::Json, native_packet(24, 408, true), "version 24, little-endian; send"),
            (Format::Fgfs, line.clone(), "20 bytes: a sample of format generic; use --format generic"),
            (Format::Json, line, "a sample of format generic"),
            (Format::Fgfs, json.clone(), "a sample of format json; use --format json"),
            (Format::Generic, json, "a sample of format json"),
            (Format::Fgfs, b" {\"lat\":1}".to_vec(), "an object in JSON; use --format json"),
            (Format::Fgfs, of(b"DATA*", 5 + 4 * 36), "149 bytes: X-Plane's data output; switch it off"),
            (Format::Generic, of(b"DATA\0", 41), "X-Plane's data output"),
            (Format::Json, of(b"RREF,", 13), "X-Plane's answer to RREF; switch"),
            (Format::Fgfs, of(b"RPOS4", 69), "X-Plane's answer to RPOS"),
            (Format::Fgfs, of(b"BECN\0", 30), "X-Plane's beacon"),
            (Format::Fgfs, of(b"DREF", 509), "a request to X-Plane"),
            (Format::Fgfs, b"XGPSMSFS,-80.11,34.55,1200.1,359.05,55.6".to_vec(), "a message for ForeFlight"),
            (
                Format::Generic,
                b"XATTX-Plane,180.2,0.1,0.2".to_vec(),
                "a message for ForeFlight, without a position",
            ),
            (Format::Generic, b"$GPRMC,123519,A*6A\r\n".to_vec(), "a sentence of NMEA 0183"),
            (Format::Generic, of(b"FGFS", 240), "FlightGear's multiplayer packet"),
            (
                Format::Generic,
                b"<LABELS>, Time".to_vec(),
                "JSBSim's output of type SOCKET; use type=\"FLIGHTGEAR\"",
            ),
            (Format::Fgfs, vec![0x7e, 0, 1, 2, 0x7e], "a message of GDL 90"),
            (Format::Fgfs, of(&[0xfe, 9], 17), "a message of MAVLink 1"),
            (Format::Fgfs, of(&[0xfd, 9], 21), "a message of MAVLink 2"),
            (Format::Fgfs, entity, "an entity state of DIS"),
            (Format::Json, b"[{}]".to_vec(), "an array in JSON; send one object"),
        ] {
            let refused = format.decode(&packet).unwrap_err();
            assert!(
                refused.why == Why::Foreign && refused.sentence.contains(words),
                "{format:?} {words}: {refused:?}"
            );
        }
        // What nobody knows is refused for its length or its syntax.
        for (format, packet) in
            [(Format::Fgfs, vec![9; 100]), (Format::Generic, b"a,b".to_vec()), (Format::Json, b"x".to_vec())]
        {
            assert_ne!(format.decode(&packet).unwrap_err().why, Why::Foreign);
        }
    }
}
