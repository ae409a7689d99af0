//! What the INS believes, as datagrams.

use sins::Error;
use sins::unit::bus::{Inputs, words};

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
    /// The same words as 32 bits each, the highest byte first; the label is in the last byte
    Words,
}

/// Largest datagram of words [bytes]: one packet of any network.
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
            Send::Json => vec![json::encode(navigation, shown.status.state.word()).into_bytes()],
            Send::Nmea => {
                let number = (navigation.time_s / nmea::INTERVAL_S + 1e-6).floor() as i64;
                if self.sentence.replace(number) == Some(number) {
                    return Ok(Vec::new());
                }
                vec![nmea::sentences(navigation).into_bytes()]
            }
            Send::Bus | Send::Words => {
                let to_s = navigation.time_s;
                let interval = (from_s.max(to_s - LONGEST_S), to_s);
                let mut due = Vec::new();
                words(&shown.status, navigation, &self.inputs, interval, |word| {
                    if self.send == Send::Words {
                        due.push(word.word.to_be_bytes().to_vec());
                    } else {
                        due.extend(bus_line(&word).map(|line| format!("{line}\n").into_bytes()));
                    }
                })?;
                datagrams(&due)
            }
        })
    }
}

/// Words in datagrams that are not too large.
fn datagrams(words: &[Vec<u8>]) -> Vec<Vec<u8>> {
    let mut datagrams: Vec<Vec<u8>> = Vec::new();
    for word in words {
        match datagrams.last_mut() {
            Some(datagram) if datagram.len() + word.len() <= LARGEST => datagram.extend(word),
            _ => datagrams.push(word.clone()),
        }
    }
    datagrams
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_fill_datagrams() {
        let words: Vec<Vec<u8>> = (0..100).map(|k| format!("{k:0>50}\n").into_bytes()).collect();
        let datagrams = datagrams(&words);
        assert!(datagrams.len() == 5 && datagrams.iter().all(|datagram| datagram.len() <= LARGEST));
        assert_eq!(datagrams.concat(), words.concat());
        assert!(super::datagrams(&[]).is_empty());
    }
}
