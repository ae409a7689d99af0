//! Which packets are flown, and at what time. A pure function of the packets: it reads no clock.

use sins::Error;
use sins::ErrorKind;
use sins::truth::{FlightSample, Intake, Pushed};

use super::packet::{Refused, Why};
use super::ticks::{After, LEAST_SPEED_M_S, Ticks};
use crate::given::{of_sample, unit_of_interval};

/// So many jumps in a row are no wrong packet: the flight simulator has moved the aircraft.
const JUMPS: u32 = 3;

/// What is done while the aircraft stands still in flight.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum Pause {
    /// The time of the pause is left out
    Cut,
    /// The packets are flown as they are
    Fly,
}

/// What is done when the flight simulator moves the aircraft, or its clock.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum Jump {
    /// A new flight begins, with files of its own
    Restart,
    /// The program ends
    End,
}

/// A packet that is not refused.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Passed {
    /// The first sample of a flight.
    Begin(FlightSample),
    /// The next sample, and whether it ends a gap.
    GoOn(FlightSample, bool),
    /// A sample of a pause, or between two periods: it is not flown.
    Standing,
    /// The aircraft was moved, and the program is to end.
    End,
}

/// Passes packets in the order of their time.
#[derive(Debug, Clone)]
pub struct Gate {
    /// The checks of the simulator: what passes here is accepted there.
    intake: Intake,
    max_gap_s: f64,
    pause: Pause,
    jump: Jump,
    /// For packets without a time.
    ticks: Option<Ticks>,
    /// The packet before, with its time.
    last: Option<FlightSample>,
    /// Length of the pauses in this flight [s].
    paused_s: f64,
    jumps: u32,
}

impl Gate {
    pub fn new(intake: Intake, max_gap_s: f64, ticks: Option<Ticks>, pause: Pause, jump: Jump) -> Self {
        Self { intake, max_gap_s, pause, jump, ticks, last: None, paused_s: 0.0, jumps: 0 }
    }

    /// The period that the motion between packets without a time shows [s].
    pub fn measured_s(&self) -> Option<f64> {
        self.ticks.as_ref()?.measured_s()
    }

    /// Takes the next packet.
    pub fn take(&mut self, mut packet: FlightSample) -> Result<Passed, Refused> {
        packet.validate().map_err(|error| refused(Why::Range, &error))?;
        let Some(last) = self.last else { return self.begin(packet) };
        let stands = last.place == packet.place && last.euler == packet.euler;
        let pauses = stands && packet.v_n.is_some_and(|v_n| v_n.norm() >= LEAST_SPEED_M_S);
        if let Some(ticks) = &mut self.ticks {
            if pauses && self.pause == Pause::Cut {
                return Ok(Passed::Standing);
            }
            let period_s = ticks.period_s;
            // In a pause that is flown, there is no way between packets.
            let after = if pauses { After::Periods(1.0) } else { ticks.after(&last, &packet) };
            match after {
                After::Periods(0.0) => return Ok(Passed::Standing),
                After::Periods(count) => {
                    packet.time_s = period_s * ((last.time_s / period_s).round() + count)
                }
                After::Earlier(count) if count * period_s <= self.max_gap_s => {
                    let sentence = format!("{count} periods before the packet that came before it");
                    return Err(Refused::new(Why::Late, sentence));
                }
                After::Earlier(_) => return self.jumped(packet, "the position went back"),
                After::Jump(way_m) => {
                    return self.jumped(
                        packet,
                        &format!("a way of {way_m:.1} m that the velocity does not explain"),
                    );
                }
            }
        } else if packet.time_s <= last.time_s {
            if packet.time_s == last.time_s && stands {
                return Ok(Passed::Standing);
            }
            let sentence = format!("time_s = {}: not later than {}", packet.time_s, last.time_s);
            if last.time_s - packet.time_s > self.max_gap_s {
                return self.jumped(packet, &sentence);
            }
            return Err(Refused::new(Why::Late, sentence));
        } else if pauses && self.pause == Pause::Cut {
            self.paused_s += packet.time_s - last.time_s;
            self.last = Some(packet);
            return Ok(Passed::Standing);
        }
        let flown = FlightSample { time_s: packet.time_s - self.paused_s, ..packet };
        match self.intake.push(&flown) {
            Ok(pushed) => {
                self.intake.take();
                (self.last, self.jumps) = (Some(packet), 0);
                Ok(Passed::GoOn(flown, pushed == Pushed::BehindGap))
            }
            Err(error) => match error.kind {
                ErrorKind::Discontinuity if error.field == "sample.time_s" => {
                    // The first interval of a flight shows the unit of the stamps.
                    let is_first = self.intake.behind()[1].is_none();
                    let unit = if is_first { unit_of_interval(packet.time_s - last.time_s) } else { "" };
                    self.jumped(packet, &(of_sample(&error) + unit))
                }
                ErrorKind::Discontinuity => self.jumped(packet, &of_sample(&error)),
                ErrorKind::TimeOrder => Err(refused(Why::Period, &error)),
                _ => Err(refused(Why::Range, &error)),
            },
        }
    }

    fn begin(&mut self, mut packet: FlightSample) -> Result<Passed, Refused> {
        if self.ticks.is_some() {
            packet.time_s = 0.0;
        }
        self.intake.restart(&packet).map_err(|error| refused(Why::Range, &error))?;
        self.intake.take();
        (self.last, self.paused_s, self.jumps) = (Some(packet), 0.0, 0);
        Ok(Passed::Begin(packet))
    }

    /// Refuses a packet that does not follow from the ones before it, until there are several in a row.
    fn jumped(&mut self, packet: FlightSample, sentence: &str) -> Result<Passed, Refused> {
        self.jumps += 1;
        match self.jump {
            _ if self.jumps < JUMPS => Err(Refused::new(Why::Jump, sentence)),
            Jump::Restart => self.begin(packet),
            Jump::End => Ok(Passed::End),
        }
    }
}

fn refused(why: Why, error: &Error) -> Refused {
    Refused::new(why, of_sample(error))
}

#[cfg(test)]
mod tests {
    use nalgebra::Vector3;
    use sins::Options;
    use sins::earth::Geodetic;
    use sins::math::Euler;

    use super::*;

    /// North at 100 m/s along a meridian at the equator, whose radius of curvature is `MERIDIAN_M`.
    fn at(time_s: f64) -> FlightSample {
        const MERIDIAN_M: f64 = 6_335_439.327_292_819;
        let place = Geodetic { latitude_rad: 100.0 * time_s / MERIDIAN_M, ..Geodetic::default() };
        let v_n = Some(Vector3::new(0.0, 100.0, 0.0));
        FlightSample { v_n, ..FlightSample::at_rest(time_s, place, Euler::default()) }
    }

    fn gate(period_s: Option<f64>, pause: Pause, jump: Jump) -> Gate {
        let mut options = Options::default();
        options.intake.period_s = period_s;
        let intake = Intake::new(options.earth(), options.axes, options.intake).unwrap();
        let ticks = period_s.map(|period_s| Ticks::new(options.earth(), period_s));
        Gate::new(intake, options.intake.max_gap_s, ticks, pause, jump)
    }

    /// Time stamps of the samples that are flown.
    fn flown(gate: &mut Gate, packets: impl IntoIterator<Item = FlightSample>) -> Vec<f64> {
        let passed = packets.into_iter().map(|packet| gate.take(packet));
        let time_s = |passed| match passed {
            Ok(Passed::Begin(sample) | Passed::GoOn(sample, _)) => Some(sample.time_s),
            _ => None,
        };
        passed.filter_map(time_s).collect()
    }

    #[test]
    fn packets_pass_in_the_order_of_their_time() {
        let mut gate = gate(None, Pause::Cut, Jump::Restart);
        assert_eq!(flown(&mut gate, [0.0, 0.1, 0.3, 0.2, 0.3, 0.4].map(at)), [0.0, 0.1, 0.3, 0.4]);
        assert_eq!(gate.take(at(0.4)), Ok(Passed::Standing));
        let why = |gate: &mut Gate, packet| gate.take(packet).unwrap_err().why;
        assert_eq!(why(&mut gate, at(0.35)), Why::Late);
        let high = FlightSample { place: Geodetic { height_m: 3e6, ..at(0.5).place }, ..at(0.5) };
        assert_eq!(why(&mut gate, high), Why::Range);
        assert_eq!(gate.take(at(2.5)), Ok(Passed::GoOn(at(2.5), true)));
    }

    /// A pause in which the clock runs on is left out: the flight goes on as if there had been none.
    #[test]
    fn a_pause_is_left_out() {
        let paused = |time_s| FlightSample { time_s, ..at(0.25) };
        let packets =
            [at(0.0), at(0.25), paused(0.5), paused(600.0), FlightSample { time_s: 600.25, ..at(0.5) }];
        let mut cut = gate(None, Pause::Cut, Jump::Restart);
        assert_eq!(flown(&mut cut, packets), [0.0, 0.25, 0.5]);
        let mut flying = gate(None, Pause::Fly, Jump::End);
        // The standstill of a quarter of a second is an error of 25 m in the truth; that of ten minutes is a jump.
        assert_eq!(flown(&mut flying, packets), [0.0, 0.25, 0.5]);
        // Without a time, packets that stand still take none.
        let mut ticking = gate(Some(0.25), Pause::Cut, Jump::Restart);
        assert_eq!(flown(&mut ticking, packets), [0.0, 0.25, 0.5]);
    }

    /// One packet far away is wrong; three are a new place.
    #[test]
    fn a_jump_is_believed_the_third_time() {
        let far = |time_s: f64| {
            let sample = at(time_s);
            FlightSample { place: Geodetic { longitude_rad: 1.0, ..sample.place }, ..sample }
        };
        for period_s in [None, Some(0.1)] {
            let mut restart = gate(period_s, Pause::Cut, Jump::Restart);
            assert_eq!(flown(&mut restart, [at(0.0), at(0.1), far(0.2), at(0.3)]).len(), 3);
            assert_eq!(restart.take(far(0.4)).unwrap_err().why, Why::Jump);
            assert_eq!(restart.take(far(0.5)).unwrap_err().why, Why::Jump);
            assert!(matches!(restart.take(far(0.6)), Ok(Passed::Begin(_))));
            assert!(matches!(restart.take(far(0.7)), Ok(Passed::GoOn(_, false))));
            let mut end = gate(period_s, Pause::Cut, Jump::End);
            assert_eq!(flown(&mut end, [at(0.0), at(0.1), far(0.2), far(0.3)]).len(), 2);
            assert_eq!(end.take(far(0.4)), Ok(Passed::End));
        }
    }

    /// Stamps in another unit than seconds make each packet a jump.
    #[test]
    fn the_unit_of_stamps_is_asked_for() {
        for (unit, words) in [(1e3, "in ms?"), (1e6, "in microseconds?"), (1e9, "in nanoseconds?")] {
            let mut gate = gate(None, Pause::Cut, Jump::Restart);
            let packet = |tick: f64| FlightSample { time_s: tick * 0.02 * unit, ..at(tick * 0.02) };
            assert!(matches!(gate.take(packet(0.0)), Ok(Passed::Begin(_))));
            let refused = gate.take(packet(1.0)).unwrap_err();
            assert!(refused.why == Why::Jump && refused.sentence.ends_with(words), "{refused:?}");
        }
        // A gap in a flight whose intervals are known.
        let mut gate = gate(None, Pause::Cut, Jump::Restart);
        flown(&mut gate, [0.0, 0.1, 0.2].map(at));
        assert!(!gate.take(at(60.0)).unwrap_err().sentence.contains("are the stamps"));
    }

    /// The clock of a flight that was loaded again starts anew.
    #[test]
    fn a_clock_that_goes_back_is_a_jump() {
        let mut gate = gate(None, Pause::Cut, Jump::Restart);
        flown(&mut gate, [100.0, 100.1].map(at));
        let again = [0.0, 0.1, 0.2, 0.3].map(|time_s| gate.take(at(time_s)));
        assert!(
            again[..2].iter().all(|passed| passed.as_ref().is_err_and(|refused| refused.why == Why::Jump))
        );
        assert_eq!(again[2..], [Ok(Passed::Begin(at(0.2))), Ok(Passed::GoOn(at(0.3), false))]);
    }

    /// Packets without a time are exactly a whole number of periods after the first one.
    #[test]
    fn packets_without_a_time_are_on_their_period() {
        let period_s = 1.0 / 60.0;
        let mut gate = gate(Some(period_s), Pause::Cut, Jump::Restart);
        let ticks = [0, 1, 2, 5, 6, 4, 6, 7];
        let packets = ticks.map(|tick| FlightSample { time_s: 0.0, ..at(f64::from(tick) * period_s) });
        let expected: Vec<f64> = [0, 1, 2, 5, 6, 7].iter().map(|tick| f64::from(*tick) * period_s).collect();
        assert_eq!(flown(&mut gate, packets), expected);
    }
}
