//! What the INS believes, as datagrams.

use sins::Error;
use sins::bus::{Inputs, words};

use super::{json, native, nmea};
use crate::fly::{Shown, bus_line};

/// Formats of an answer.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum Send {
    /// FlightGear's native FDM packet: a second FlightGear shows the world of the INS
    Fgfs,
    /// A JSON object: the keys of a sample, and the state; null is not valid
    Json,
    /// Sentences of NMEA 0183, $INGGA, $INRMC and $INHDT, five times a second
    Nmea,
    /// ARINC 429 words that are due, a line for each, with the columns of `sins fly --bus`
    Bus,
}

/// Largest datagram of lines [bytes]: one packet of any network.
const LARGEST: usize = 1200;

/// Longest time whose words are sent [s].
const LONGEST_S: f64 = 10.0;

/// Makes answers.
#[derive(Debug)]
pub struct Answers {
    send: Send,
    inputs: Inputs,
    /// Number of the last interval between sentences.
    sentence: Option<i64>,
}

impl Answers {
    pub fn new(send: Send, inputs: Inputs) -> Self {
        Self { send, inputs, sentence: None }
    }

    /// The datagrams after the interval from `from_s` [s] to the time that is shown. `received` is the packet of FlightGear at its end.
    pub fn make(
        &mut self,
        shown: &Shown,
        from_s: f64,
        received: Option<&[u8]>,
    ) -> Result<Vec<Vec<u8>>, Error> {
        let (navigation, validity) = (&shown.navigation, &shown.navigation.validity);
        Ok(match self.send {
            Send::Fgfs if validity.position && validity.velocity => {
                vec![native::encode(navigation, received)]
            }
            Send::Fgfs => Vec::new(),
            Send::Json => vec![json::encode(navigation, shown.status.state.words()).into_bytes()],
            Send::Nmea => {
                let number = (navigation.time_s / nmea::INTERVAL_S + 1e-6).floor() as i64;
                if self.sentence.replace(number) == Some(number) {
                    return Ok(Vec::new());
                }
                vec![nmea::sentences(navigation).into_bytes()]
            }
            Send::Bus => {
                let to_s = navigation.time_s;
                let mut due = Vec::new();
                words(
                    &shown.status,
                    navigation,
                    &self.inputs,
                    (from_s.max(to_s - LONGEST_S), to_s),
                    |word| due.extend(bus_line(&word)),
                )?;
                datagrams(&due)
            }
        })
    }
}

/// Lines in datagrams that are not too large.
fn datagrams(lines: &[String]) -> Vec<Vec<u8>> {
    let mut datagrams: Vec<Vec<u8>> = Vec::new();
    for line in lines {
        match datagrams.last_mut() {
            Some(datagram) if datagram.len() + line.len() < LARGEST => {
                datagram.extend_from_slice(line.as_bytes());
                datagram.push(b'\n');
            }
            _ => datagrams.push(format!("{line}\n").into_bytes()),
        }
    }
    datagrams
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_fill_datagrams() {
        let lines: Vec<String> = (0..100).map(|k| format!("{k:0>50}")).collect();
        let datagrams = datagrams(&lines);
        assert!(datagrams.len() == 5 && datagrams.iter().all(|datagram| datagram.len() <= LARGEST));
        let text = String::from_utf8(datagrams.concat()).unwrap();
        assert_eq!(text, lines.join("\n") + "\n");
        assert!(super::datagrams(&[]).is_empty());
    }
}
