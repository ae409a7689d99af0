//! The live run: packet by packet, until Ctrl-C, the wanted time, or silence.

use std::net::SocketAddr;
use std::path::PathBuf;
use std::time::Instant;

use super::answer::Answers;
use super::gate::{Gate, Passed};
use super::leg::{Blank, Leg};
use super::link::{LARGEST, Source, Target};
use super::packet::{Format, Refused};
use super::traffic::Traffic;
use crate::failure::{Failure, Kind};
use crate::fly::{Shown, Stopped};
use crate::given::{Given, of_sample};
use crate::interrupt;
use crate::output::Outputs;
use crate::report;
use crate::terminal::{print, say};
use crate::units::six_digits;

/// Number of samples after which the period of packets without a time is compared with the motion, and the largest deviation.
const COMPARED: u64 = 200;
const OFF_PERIOD: f64 = 0.02;

/// A live run before its first packet.
pub struct Live<'a> {
    pub given: &'a Given,
    pub format: Format,
    pub source: Source,
    pub gate: Gate,
    pub answers: Option<(Target, Answers)>,
    pub record: Option<&'a str>,
    pub seconds: f64,
    pub silence_s: f64,
    pub is_quiet: bool,
    pub force: bool,
    pub folder: PathBuf,
    pub name: String,
    pub outputs: Outputs,
}

/// What the packets have led to.
struct Progress<'a> {
    /// The flight, or the files of the one to come.
    leg: Option<Leg<'a>>,
    blank: Option<Blank>,
    traffic: Traffic,
    began: Instant,
    last_flown: Option<Instant>,
    /// Flown before this flight [s].
    flown_s: f64,
    /// Whole seconds that were shown.
    shown_s: u64,
    is_compared: bool,
    records: Vec<PathBuf>,
}

impl<'a> Live<'a> {
    pub fn run(mut self) -> Result<(), Failure> {
        let mut progress = Progress {
            leg: None,
            blank: Some(self.blank(1)?),
            traffic: Traffic::default(),
            began: Instant::now(),
            last_flown: None,
            flown_s: 0.0,
            shown_s: 0,
            is_compared: false,
            records: Vec::new(),
        };
        self.print(&format!("listening at udp:{} for {}\n", self.source.place()?, self.format.name()))?;
        let ended = self.listen(&mut progress);
        let finished = self.finish(progress);
        ended.and(finished)
    }

    fn print(&self, text: &str) -> Result<(), Failure> {
        if self.is_quiet { Ok(()) } else { print(text) }
    }

    fn blank(&mut self, number: u64) -> Result<Blank, Failure> {
        Blank::open(self.given, &mut self.outputs, &self.folder, &self.name, self.record, number)
    }

    fn listen(&mut self, progress: &mut Progress<'a>) -> Result<(), Failure> {
        let mut buffer = vec![0; LARGEST];
        while !interrupt::is_asked() && progress.run_s() < self.seconds {
            let Some((length, sender)) = self.source.receive(&mut buffer)? else {
                let silence = progress.last_flown.map_or(0.0, |last| last.elapsed().as_secs_f64());
                if silence > self.silence_s {
                    return self.print(&format!("no packet that can be flown for {} s\n", self.silence_s));
                }
                continue;
            };
            let came = Instant::now();
            progress.traffic.received += 1;
            match self.pass(&buffer[..length], sender) {
                Ok(Passed::End) => return self.print("the aircraft was moved\n"),
                Ok(passed) => self.fly(progress, passed, came, &buffer[..length])?,
                Err(refused) => {
                    if progress.traffic.refuse(refused.why) && !self.is_quiet {
                        say(&format!("first packet {}: {}", refused.why.words(), refused.sentence));
                    }
                }
            }
        }
        Ok(())
    }

    /// What becomes of a datagram.
    fn pass(&mut self, datagram: &[u8], sender: SocketAddr) -> Result<Passed, Refused> {
        self.source.check(sender)?;
        let passed = self.gate.take(self.format.decode(datagram)?)?;
        if self.source.hold(sender) && !self.is_quiet {
            say(&format!("packets come from {sender}"));
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
                    self.print("the aircraft was moved: another flight begins\n")?;
                    progress.flown_s = progress.run_s();
                    self.end_leg(progress)?;
                }
                let blank = match progress.blank.take() {
                    Some(blank) => blank,
                    None => self.blank(progress.traffic.flights + 1)?,
                };
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
        if matches!(passed, Passed::Begin(_) | Passed::GoOn(..)) {
            progress.last_flown = Some(came);
        }
        Ok(())
    }

    /// Prints a line for each second of flight.
    fn show(&self, progress: &mut Progress<'a>, shown: &Shown) -> Result<(), Failure> {
        let run_s = progress.run_s();
        if !progress.is_compared && progress.traffic.flown >= COMPARED {
            progress.is_compared = true;
            self.compare();
        }
        // A second of samples that binary numbers do not hold exactly.
        let whole_s = (run_s + 1e-6) as u64;
        if whole_s > progress.shown_s {
            progress.shown_s = whole_s;
            if let Some(leg) = &mut progress.leg {
                leg.check()?;
                leg.doubts().iter().for_each(|words| say(&format!("packets: {words}")));
            }
            self.print(&format!("{whole_s:>6} s  {}\n", line(shown, &progress.traffic)))?;
        }
        Ok(())
    }

    /// Warns of a stated rate that the motion contradicts.
    fn compare(&self) {
        let (Some(stated_s), Some(measured_s)) =
            (self.given.scene.options.intake.period_s, self.gate.measured_s())
        else {
            return;
        };
        if (measured_s / stated_s - 1.0).abs() > OFF_PERIOD {
            let [measured, stated] = [measured_s, stated_s].map(|period_s| format!("{:.2}", 1.0 / period_s));
            say(&format!(
                "warning: between packets the aircraft moves as at {measured} Hz, and {stated} Hz were stated (--rate-hz)"
            ));
        }
    }

    /// Ends the flight with its files.
    fn end_leg(&self, progress: &mut Progress<'a>) -> Result<(), Failure> {
        let Some(leg) = progress.leg.take() else { return Ok(()) };
        if let Some((records, words)) = leg.end()? {
            progress.records.push(records);
            self.print(&format!("\n{words}\n"))?;
        }
        Ok(())
    }

    fn finish(self, mut progress: Progress<'a>) -> Result<(), Failure> {
        self.end_leg(&mut progress)?;
        let traffic = progress.traffic.text();
        if progress.records.is_empty() {
            let kind = if interrupt::is_asked() { Kind::Interrupted } else { Kind::Input };
            return Err(Failure::of_kind(kind, format!("no interval was flown\n{}", traffic.trim_end())));
        }
        if self.is_quiet {
            return Ok(());
        }
        print(&traffic)?;
        report::run(&report::Order {
            runs: progress.records,
            output: Some(self.folder.join(format!("{}.html", self.name))),
            picture: None,
            force: self.force,
        })
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
