//! The samples of a log, one after the other: what a simulator would refuse, and the gaps that it bridges.

use sins::log::FlightLog;
use sins::scene::Scene;
use sins::truth::{Intake, Pushed};
use sins::{Error, ErrorKind};

use super::words::of_sample;

/// Gaps of a log: intervals of more than 2.5 times each of the two before, which are bridged; also a first interval of more than
/// 2.5 times the second.
#[derive(Debug, Clone, Copy, Default)]
pub struct Gaps {
    /// Number of gaps.
    pub count: u64,
    /// The longest gap [s].
    pub longest_s: f64,
    /// Index of the sample behind the longest gap.
    pub index: usize,
}

/// Takes the first `count` samples of `log` as a simulator of `scene` does. Its gaps; or the first sample that the simulator
/// refuses, and why.
pub fn find(scene: &Scene, log: &FlightLog, count: usize) -> Result<Gaps, (usize, Error)> {
    let options = &scene.options;
    let at = |index| move |error| (index, error);
    let mut intake = Intake::new(options.earth(), options.axes, options.intake).map_err(at(0))?;
    let (mut gaps, mut last_s, mut before_s) = (Gaps::default(), 0.0, 0.0);
    for (index, sample) in log.samples().iter().take(count).enumerate() {
        let length_s = sample.time_s - last_s;
        let is_behind = intake.push(sample).map_err(at(index))? == Pushed::BehindGap;
        let first = (index == 2 && before_s > 2.5 * length_s).then_some((before_s, 1));
        for (length_s, index) in is_behind.then_some((length_s, index)).into_iter().chain(first) {
            gaps.count += 1;
            if length_s > gaps.longest_s {
                (gaps.longest_s, gaps.index) = (length_s, index);
            }
        }
        intake.take();
        (last_s, before_s) = (sample.time_s, length_s);
    }
    Ok(gaps)
}

/// Why a simulator of `scene` refuses a sample of `log`, from the error of it.
pub fn refusal(scene: &Scene, log: &FlightLog, error: &Error) -> String {
    let is_gap = error.kind == ErrorKind::Discontinuity && error.field == "sample.time_s";
    of_sample(error) + if is_gap { unit_of_stamps(scene, log) } else { "" }
}

/// What the stamps of a log may be whose usual interval is longer than a gap may be; empty: they are in seconds.
fn unit_of_stamps(scene: &Scene, log: &FlightLog) -> &'static str {
    let samples = log.samples();
    let mut intervals: Vec<f64> = samples.windows(2).map(|pair| pair[1].time_s - pair[0].time_s).collect();
    let middle = (intervals.len() - 1) / 2;
    let usual_s = *intervals.select_nth_unstable_by(middle, f64::total_cmp).1;
    if usual_s > scene.options.intake.max_gap_s { unit_of_interval(usual_s) } else { "" }
}

/// What an interval that is too long for one in seconds [s] may be in.
pub fn unit_of_interval(interval_s: f64) -> &'static str {
    match interval_s {
        ..5e3 => "; are the stamps in ms?",
        ..5e6 => "; are the stamps in microseconds?",
        _ => "; are the stamps in nanoseconds?",
    }
}
