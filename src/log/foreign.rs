//! Files of other kinds that are taken for scenes and tables: what they are, by their beginning.

use core::fmt;

/// Number of bytes that are looked at.
const LOOKED_AT: usize = 4096;

/// What a file is that is neither a scene nor a table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Foreign {
    /// A flight record in the format of the International Gliding Commission, which is read as a log.
    Igc,
    /// A track in the GPS Exchange Format, which is read as a log.
    Gpx,
    /// A file of the flight data recorder of X-Plane, which is read as a log.
    Fdr,
    /// A file of another kind, in words with an article.
    Other(&'static str),
}

impl Foreign {
    /// Whether it is read as a log.
    pub fn is_record(self) -> bool {
        !matches!(self, Self::Other(_))
    }
}

impl fmt::Display for Foreign {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Igc => "a flight record of a glider (IGC)",
            Self::Gpx => "a track of a receiver (GPX)",
            Self::Fdr => "a flight record of X-Plane (FDR)",
            Self::Other(what) => what,
        })
    }
}

/// Place of bytes in a file, the bytes, and what the file is.
const BYTES: [(usize, &[u8], &str); 32] = [
    (0, b"PK\x03\x04", "a compressed file (zip, also of a workbook or a KMZ)"),
    (0, b"\x1f\x8b", "a compressed file (gzip)"),
    (0, b"BZh", "a compressed file (bzip2)"),
    (0, b"\xfd7zXZ", "a compressed file (xz)"),
    (0, b"\x28\xb5\x2f\xfd", "a compressed file (zstd)"),
    (0, b"7z\xbc\xaf", "a compressed file (7z)"),
    (0, b"Rar!", "a compressed file (rar)"),
    (257, b"ustar", "an archive (tar)"),
    (0, b"\xff\xfe", "a text in UTF-16, not in UTF-8"),
    (0, b"\xfe\xff", "a text in UTF-16, not in UTF-8"),
    (0, b"\xd0\xcf\x11\xe0", "a workbook (xls)"),
    (0, b"%PDF", "a document (PDF)"),
    (0, b"\x89PNG", "a picture (PNG)"),
    (0, b"MATLAB 5.0 MAT-file", "data of MATLAB (mat)"),
    (0, b"\x89HDF", "data in HDF5"),
    (0, b"CDF\x01", "data in NetCDF"),
    (0, b"CDF\x02", "data in NetCDF"),
    (0, b"PAR1", "data in Parquet"),
    (0, b"ARROW1", "data in Arrow"),
    (0, b"\x93NUMPY", "an array of NumPy (npy)"),
    (0, b"SQLite format 3", "a database (SQLite)"),
    (0, b"ULog\x01\x12\x35", "a log of PX4 (ULog)"),
    (0, b"\xa3\x95", "a log of ArduPilot (DataFlash)"),
    (0, b"FMT, 128, 89,", "a log of ArduPilot (DataFlash, as text)"),
    (0, b"#ROSBAG", "a log of ROS (bag)"),
    (0, b"\x89MCAP", "a log of ROS (MCAP)"),
    (8, b".FIT", "a log of a sports watch (FIT)"),
    (0, b"\xb5\x62", "messages of a receiver (UBX)"),
    (0, b"\xd3\x00", "messages of a receiver (RTCM)"),
    (60, b"RINEX VERSION", "observations of a receiver (RINEX)"),
    (0, b"#airframe_info", "a log of a cockpit (Garmin)"),
    (0, b"SINSsnap", "a snapshot"),
];

/// Beginning of a text or of the name of its first element, and what the text is.
const WORDS: [(&str, &str); 12] = [
    ("<kml", "a map (KML)"),
    ("<TrainingCenterDatabase", "a log of a sports watch (TCX)"),
    ("<html", "a page (HTML)"),
    ("<!DOCTYPE", "a page (HTML)"),
    ("<svg", "a picture (SVG)"),
    ("<", "a text in XML"),
    ("$", "sentences of a receiver (NMEA 0183)"),
    ("!AIV", "sentences about ships (NMEA 0183)"),
    ("{", "a text in JSON"),
    ("[{", "a text in JSON"),
    ("[\n{", "a text in JSON"),
    ("[\n  {", "a text in JSON"),
];

/// What a file is that is neither a scene nor a table; `None`: nobody knows.
pub fn foreign(file: &[u8]) -> Option<Foreign> {
    let begin = &file[..file.len().min(LOOKED_AT)];
    let stands = |at: usize, bytes: &[u8]| begin.get(at..).is_some_and(|rest| rest.starts_with(bytes));
    if let Some((.., what)) = BYTES.iter().find(|(at, bytes, _)| stands(*at, bytes)) {
        return Some(Foreign::Other(what));
    }
    // A text may have some by mistake.
    let control = begin.iter().filter(|byte| byte.is_ascii_control() && !byte.is_ascii_whitespace()).count();
    if control * 20 > begin.len() {
        return Some(Foreign::Other("a binary file"));
    }
    let text = String::from_utf8_lossy(begin).replace("\r\n", "\n").replace('\r', "\n");
    let text = text.trim_start_matches('\u{feff}').trim_start();
    let element = text.starts_with('<').then(|| first_element(text)).flatten().unwrap_or(text);
    let words =
        || WORDS.iter().find(|(word, _)| element.starts_with(word)).map(|(_, what)| Foreign::Other(what));
    let track = element.starts_with("<gpx").then_some(Foreign::Gpx);
    of_lines(text).or(track).or_else(words)
}

/// The text from the first element of XML on, behind its head and its comments.
fn first_element(text: &str) -> Option<&str> {
    let places = text.match_indices('<').map(|(at, _)| &text[at..]);
    places.into_iter().find(|rest| rest[1..].starts_with(|letter: char| letter.is_ascii_alphabetic()))
}

/// What a text is by its lines.
fn of_lines(text: &str) -> Option<Foreign> {
    let first = text.lines().next()?.trim_end();
    // B, time, latitude, longitude.
    let is_fix = |line: &str| {
        let letters = line.as_bytes();
        letters.len() > 24
            && letters[0] == b'B'
            && letters[1..14].iter().all(u8::is_ascii_digit)
            && matches!(letters[14], b'N' | b'S')
            && letters[15..23].iter().all(u8::is_ascii_digit)
    };
    if text.lines().any(|line| line.starts_with("HFDTE") || is_fix(line)) {
        return Some(Foreign::Igc);
    }
    let is_record = |line: &str| {
        ["COMM,", "ACFT,", "TAIL,", "DATE,", "DREF,", "DATA,"].iter().any(|word| line.starts_with(word))
    };
    if matches!(first, "A" | "I") && text.lines().any(is_record) {
        return Some(Foreign::Fdr);
    }
    if first.contains("_real,_time") && first.contains('|') {
        return Some(Foreign::Other("a data output of X-Plane (Data.txt)"));
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_of_other_kinds_are_known() {
        let padded = |at: usize, bytes: &[u8]| [vec![b' '; at], bytes.to_vec()].concat();
        for (at, bytes, what) in BYTES {
            assert_eq!(foreign(&padded(at, bytes)), Some(Foreign::Other(what)));
        }
        for (text, what) in [
            ("AXCS123\r\nHFDTE250726\r\nB1201014807038N01131000EA0054500580\r\n", "IGC"),
            ("AXCS123\nB1201014807038N01131000EA0054500580\n", "IGC"),
            ("A\n2\n\nCOMM, a flight\nACFT, Aircraft/x.acf\n", "FDR"),
            ("I\n3\nDATA, 1,2,3\n", "FDR"),
            ("A\r4\rTAIL,N1\r", "FDR"),
            ("\u{feff}<?xml version=\"1.0\"?>\n<!-- a > b --><gpx version=\"1.1\">", "GPX"),
            ("<?xml version=\"1.0\"?><kml>", "KML"),
            ("<fdm_config>", "XML"),
            ("<!DOCTYPE html>\n<html>", "HTML"),
            ("$GPGGA,123519\n", "NMEA"),
            ("{\"a\": 1}", "JSON"),
            ("[{\"a\": 1}]", "JSON"),
            ("   _real,_time |   _totl,_time |\n", "Data.txt"),
            ("a\0b", "a binary file"),
        ] {
            assert!(foreign(text.as_bytes()).unwrap().to_string().contains(what), "{text}");
        }
    }

    #[test]
    fn scenes_logs_and_texts_are_none_of_them() {
        for text in [
            "",
            "[flight]\nbuiltin = \"rest\"\n",
            "[[panel]]\n",
            "# <gpx>\n[flight]\n",
            "time_s,latitude_rad\n0,1\n",
            "A\n",
            "hello, world\n",
            "Bias = 1\n",
            "title = \"\u{e9}\"\n",
            "time_s,latitude_rad,longitude_rad\n0,1\0,2\n",
        ] {
            assert_eq!(foreign(text.as_bytes()), None, "{text}");
        }
    }
}
