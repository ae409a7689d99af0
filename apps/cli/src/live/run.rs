//! The live run: packet by packet, until Ctrl-C, the wanted time, or silence.

use std::net::SocketAddr;
use std::path::PathBuf;
use std::time::{Duration, Instant};

use super::answer::Answers;
use super::blank::{Blank, Names};
use super::gate::{Gate, Passed};
use super::leg::{Ended, Leg};
use super::link::{LARGEST, Source, Target};
use super::packet::{Format, Refused};
use super::traffic::Traffic;
use super::voice::Voice;
use crate::failure::{Failure, Kind};
use crate::fly::{Shown, Stopped};
use crate::given::{Given, of_sample};
use crate::interrupt;
use crate::output::{OutputFile, Outputs};
use crate::report;
use crate::units::six_digits;
use crate::written;

/// Number of samples after which the period of packets without a time is compared with the motion, and the largest deviation.
const COMPARED: u64 = 200;
const OFF_PERIOD: f64 = 0.02;

/// Time without a packet after which the program says where it listens.
const SILENCE: Duration = Duration::from_secs(5);

/// A live run before its first packet.
pub struct Live<'a> {
    pub given: &'a Given,
    pub format: Format,
    pub source: Source,
    pub gate: Gate,
    pub answers: Option<(Target, Answers)>,
    pub seconds: f64,
    pub silence_s: f64,
    pub voice: Voice,
    pub names: Names,
    pub outputs: Outputs,
}

/// What the packets have led to.
struct Progress<'a> {
    /// The flight, or the files of the one to come.
    leg: Option<Leg<'a>>,
    blank: Option<Blank>,
    /// The number of the newest flight, in the names of its files.
    number: u64,
    page: Option<OutputFile>,
    traffic: Traffic,
    began: Instant,
    /// When the last packet that was not refused came.
    last_good: Option<Instant>,
    /// When the last packet came, and whether it is said that none has come since.
    last: (Instant, bool),
    /// Flown before this flight [s].
    flown_s: f64,
    /// Whole seconds that were shown.
    shown_s: u64,
    is_compared: bool,
    records: Vec<PathBuf>,
    /// Failures of files: the session goes on.
    failures: Vec<Failure>,
}

impl<'a> Live<'a> {
    pub fn run(mut self) -> Result<(), Failure> {
        let mut blank = self.blank(1, !self.voice.is_quiet())?;
        let now = Instant::now();
        let mut progress = Progress {
            leg: None,
            number: blank.number,
            page: blank.page.take(),
            blank: Some(blank),
            traffic: Traffic::default(),
            began: now,
            last_good: None,
            last: (now, false),
            flown_s: 0.0,
            shown_s: 0,
            is_compared: false,
            records: Vec::new(),
            failures: Vec::new(),
        };
        self.voice.print(&format!("listening at {}\n", self.place()?));
        let ended = self.listen(&mut progress);
        self.finish(progress, ended)
    }

    /// Where it listens, and for what.
    fn place(&self) -> Result<String, Failure> {
        Ok(format!("udp:{} for {}", self.source.place()?, self.format.name()))
    }

    /// The files of the next flight.
    fn blank(&mut self, first: u64, with_page: bool) -> Result<Blank, Failure> {
        let blank = Blank::open(self.given, &mut self.outputs, &self.names, first, with_page)?;
        if blank.number != first {
            self.voice.say(&format!("there are files of earlier flights; this one is {}", blank.name));
        }
        Ok(blank)
    }

    fn listen(&mut self, progress: &mut Progress<'a>) -> Result<(), Failure> {
        let mut buffer = vec![0; LARGEST];
        while !interrupt::is_asked() && progress.run_s() < self.seconds {
            let silence_s = progress.last_good.map_or(0.0, |last| last.elapsed().as_secs_f64());
            if silence_s > self.silence_s {
                self.voice.print(&format!("no packet that can be flown for {} s\n", self.silence_s));
                return Ok(());
            }
            let Some((length, sender)) = self.source.receive(&mut buffer)? else {
                self.say_silence(progress)?;
                continue;
            };
            let came = Instant::now();
            progress.last = (came, false);
            progress.traffic.received += 1;
            match self.pass(&buffer[..length], sender) {
                Ok(Passed::End) => {
                    self.voice.print("the aircraft was moved\n");
                    return Ok(());
                }
                Ok(passed) => {
                    progress.last_good = Some(came);
                    self.fly(progress, passed, came, &buffer[..length])?;
                }
                Err(refused) => {
                    if progress.traffic.refuse(refused.why) {
                        self.voice.say(&format!(
                            "first packet {}: {}",
                            refused.why.words(),
                            refused.sentence
                        ));
                    }
                }
            }
        }
        Ok(())
    }

    /// Says where it listens when no packet has come for [`SILENCE`].
    fn say_silence(&mut self, progress: &mut Progress<'a>) -> Result<(), Failure> {
        let (last, is_said) = &mut progress.last;
        if *is_said || last.elapsed() < SILENCE {
            return Ok(());
        }
        *is_said = true;
        let machines = match self.source.place()?.ip() {
            ip if ip.is_loopback() => ", from this machine alone (--from udp:0.0.0.0:PORT: from others too)",
            _ => "",
        };
        self.voice.say(&format!(
            "no packet for {} s; listening at {}{machines}",
            SILENCE.as_secs(),
            self.place()?
        ));
        Ok(())
    }

    /// What becomes of a datagram.
    fn pass(&mut self, datagram: &[u8], sender: SocketAddr) -> Result<Passed, Refused> {
        self.source.check(sender)?;
        let passed = self.gate.take(self.format.decode(datagram)?)?;
        if self.source.hold(sender) {
            self.voice.say(&format!("packets come from {sender}"));
        }
        Ok(passed)
    }

    fn fly(
        &mut self,
        progress: &mut Progress<'a>,
        passed: Passed,
        came: Instant,
        datagram: &[u8],
    ) -> Result<(), Failure> {
        let arrival_s = came.duration_since(progress.began).as_secs_f64();
        match passed {
            Passed::End => {}
            Passed::Standing => progress.traffic.stand(arrival_s),
            Passed::Begin(sample) => {
                if progress.leg.is_some() {
                    self.voice.print("the aircraft was moved: another flight begins\n");
                    progress.flown_s = progress.run_s();
                    self.end_leg(progress, false);
                }
                let blank = match progress.blank.take() {
                    Some(blank) => blank,
                    None => self.blank(progress.number + 1, false)?,
                };
                progress.number = blank.number;
                progress.leg = Some(Leg::new(self.given, blank, sample)?);
                progress.traffic.begin(sample.time_s, arrival_s);
            }
            Passed::GoOn(sample, ends_gap) => {
                let Some(leg) = &mut progress.leg else { return Ok(()) };
                let from_s = leg.last_s();
                let stopped = |stopped| match stopped {
                    Stopped::Output(failure) => failure,
                    Stopped::Sample(error) => Failure::of_kind(
                        Kind::Failed,
                        format!("at {} s: {}", six_digits(sample.time_s), of_sample(&error)),
                    ),
                };
                let flight = leg.go_on(sample).map_err(stopped)?;
                let shown = flight.shown()?;
                if let Some((target, answers)) = &mut self.answers {
                    let received = (self.format == Format::Fgfs).then_some(datagram);
                    for answer in answers.make(&shown, from_s, received)? {
                        match target.send(&answer) {
                            true => progress.traffic.answer(came.elapsed()),
                            false => progress.traffic.not_sent += 1,
                        }
                    }
                }
                progress.traffic.go_on(sample.time_s, arrival_s, ends_gap);
                self.show(progress, &shown)?;
            }
        }
        Ok(())
    }

    /// Prints a line for each second of flight.
    fn show(&mut self, progress: &mut Progress<'a>, shown: &Shown) -> Result<(), Failure> {
        let run_s = progress.run_s();
        if !progress.is_compared && progress.traffic.flown >= COMPARED {
            progress.is_compared = true;
            self.compare();
        }
        // A second of samples that binary numbers do not hold exactly.
        let whole_s = (run_s + 1e-6) as u64;
        if whole_s > progress.shown_s {
            progress.shown_s = whole_s;
            self.voice.print(&format!("{whole_s:>6} s  {}\n", line(shown, &progress.traffic)));
            if let Some(leg) = &mut progress.leg {
                leg.check()?;
                leg.doubts().iter().for_each(|words| self.voice.say(&format!("packets: {words}")));
            }
        }
        Ok(())
    }

    /// Warns of a stated rate that the motion contradicts.
    fn compare(&mut self) {
        let (Some(stated_s), Some(measured_s)) =
            (self.given.scene.options.intake.period_s, self.gate.measured_s())
        else {
            return;
        };
        if (measured_s / stated_s - 1.0).abs() > OFF_PERIOD {
            let [measured, stated] = [measured_s, stated_s].map(|period_s| format!("{:.2}", 1.0 / period_s));
            self.voice.say(&format!(
                "warning: between packets the aircraft moves as at {measured} Hz, and {stated} Hz were stated (--rate-hz)"
            ));
        }
    }

    /// Ends the flight with its files. `is_stopped`: by an error.
    fn end_leg(&mut self, progress: &mut Progress<'a>, is_stopped: bool) {
        let Some(leg) = progress.leg.take() else { return };
        match leg.end(is_stopped) {
            Ok(None) => {}
            Ok(Some(Ended { records, words, written })) => {
                progress.records.push(records);
                progress.failures.extend(written.err());
                self.voice.print(&format!("\n{words}\n"));
            }
            Err(failure) => progress.failures.push(failure),
        }
    }

    /// Ends the session with all its files, whatever has ended it.
    fn finish(mut self, mut progress: Progress<'a>, ended: Result<(), Failure>) -> Result<(), Failure> {
        self.end_leg(&mut progress, ended.is_err());
        let Progress { traffic, records, page, mut failures, .. } = progress;
        // The files say themselves what the disk did not take.
        let is_said = |failure: &Failure| failure.kind() == Kind::Unwritten && !failures.is_empty();
        if let Some(failure) = ended.err().filter(|failure| !is_said(failure)) {
            failures.insert(0, failure);
        }
        if records.is_empty() && failures.is_empty() {
            let kind = if interrupt::is_asked() { Kind::Interrupted } else { Kind::Input };
            let sentence = format!("no interval was flown\n{}", traffic.text().trim_end());
            return Err(Failure::of_kind(kind, sentence));
        }
        self.voice.print(&traffic.text());
        if let Some(page) = page.filter(|_| !records.is_empty()) {
            let path = page.path().to_owned();
            match report::draw(&records, page, None) {
                Ok(()) => self.voice.print(&written::text(&[&path], Some(&written::open(&path)))),
                Err(failure) => {
                    let hint = written::report(&records).unwrap_or_default();
                    failures.push(failure.with(&hint));
                }
            }
        }
        failures.extend(self.voice.end());
        Failure::each(failures.into_iter().map(Err))
    }
}

impl Progress<'_> {
    /// Flown in all [s].
    fn run_s(&self) -> f64 {
        self.flown_s + self.leg.as_ref().map_or(0.0, Leg::flown_s)
    }
}

/// What the INS is doing, its error, and the packets so far.
fn line(shown: &Shown, traffic: &Traffic) -> String {
    let status = &shown.status;
    let mut words = status.state.word().to_owned();
    if status.to_go_s > 0.0 {
        words += &format!(", {:.0} s to go", status.to_go_s);
    }
    let error = match status.validity.position {
        true => {
            // Adding 0 turns -0 into 0.
            let [east, north, up] =
                shown.position_error_n.map(|error_m| (10.0 * error_m).round() / 10.0 + 0.0).into();
            format!("position error {east:.1} m east, {north:.1} m north, {up:.1} m up")
        }
        false => "no position".to_owned(),
    };
    format!(
        "{words}; {error}; {} flown, {} lost, refused: {}",
        traffic.flown,
        traffic.lost(),
        traffic.refused()
    )
}
