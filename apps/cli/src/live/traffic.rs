//! What came in and went out: packets by what became of them, their spacing, and the time to the answers.

use std::time::Duration;

use super::delays::Delays;
use super::packet::Why;
use crate::units::six_digits;

/// Number of intervals whose median is the usual one.
const USUAL: usize = 31;

/// Counts, in constant memory.
#[derive(Debug, Clone, Default)]
pub struct Traffic {
    pub received: u64,
    pub flown: u64,
    pub standing: u64,
    pub flights: u64,
    pub gaps: u64,
    refused: [u64; Why::ALL.len()],
    /// The last intervals that were flown [s], and how many there were.
    intervals_s: [f64; USUAL],
    count: usize,
    /// Sum of all intervals [s], and of the usual ones in it.
    sum_s: f64,
    usual: f64,
    lost: u64,
    /// Time stamp and arrival of the last sample [s].
    last_s: Option<[f64; 2]>,
    /// Difference of the intervals of arrivals and of time stamps [s]: sum of squares, number, largest.
    jitter: (f64, u64, f64),
    pub answers: Delays,
    pub not_sent: u64,
}

impl Traffic {
    /// Counts a packet that is refused. Whether it is the first one for this reason.
    pub fn refuse(&mut self, why: Why) -> bool {
        let count = &mut self.refused[why as usize];
        *count += 1;
        *count == 1
    }

    /// Counts the first sample of a flight.
    pub fn begin(&mut self, time_s: f64, arrival_s: f64) {
        self.flights += 1;
        self.flown += 1;
        self.last_s = Some([time_s, arrival_s]);
    }

    /// Counts the next sample.
    pub fn go_on(&mut self, time_s: f64, arrival_s: f64, ends_gap: bool) {
        self.flown += 1;
        self.gaps += u64::from(ends_gap);
        if let Some([last_s, last_arrival_s]) = self.last_s {
            let interval_s = time_s - last_s;
            self.intervals_s[self.count % USUAL] = interval_s;
            self.count += 1;
            let periods = (interval_s / self.usual_s()).round().max(1.0);
            self.lost += periods as u64 - 1;
            self.sum_s += interval_s;
            self.usual += periods;
            let late_s = (arrival_s - last_arrival_s - interval_s).abs();
            let (squares, count, largest_s) = &mut self.jitter;
            *squares += late_s * late_s;
            *count += 1;
            *largest_s = largest_s.max(late_s);
        }
        self.last_s = Some([time_s, arrival_s]);
    }

    /// Counts a sample that is not flown.
    pub fn stand(&mut self, arrival_s: f64) {
        self.standing += 1;
        if let Some([_, last_arrival_s]) = &mut self.last_s {
            *last_arrival_s = arrival_s;
        }
    }

    /// Median of the last intervals [s].
    fn usual_s(&self) -> f64 {
        let mut sorted = self.intervals_s;
        let sorted = &mut sorted[..self.count.min(USUAL)];
        sorted.sort_by(f64::total_cmp);
        // The lower one of two: lost packets lengthen intervals.
        sorted.get(sorted.len().saturating_sub(1) / 2).copied().unwrap_or(0.0)
    }

    /// Mean period of the samples, as if none had been lost [s]; `None` before the second one.
    pub fn period_s(&self) -> Option<f64> {
        (self.usual > 0.0).then(|| self.sum_s / self.usual)
    }

    pub fn lost(&self) -> u64 {
        self.lost
    }

    fn refusals(&self) -> impl Iterator<Item = (Why, u64)> {
        Why::ALL.into_iter().zip(self.refused).filter(|(_, count)| *count > 0)
    }

    /// Number of refused packets, by reason.
    pub fn refused(&self) -> String {
        let words: Vec<String> =
            self.refusals().map(|(why, count)| format!("{count} {}", why.words())).collect();
        if words.is_empty() { "none".to_owned() } else { words.join(", ") }
    }

    /// The counts in words, a line for each.
    pub fn text(&self) -> String {
        let mut text = String::new();
        let mut line = |what: &str, value: String| text += &format!("  {what:<15} {value}\n");
        let Self { received, flown, standing, gaps, .. } = self;
        line(
            "packets",
            format!(
                "{received} received, {flown} flown, {standing} in pauses or between samples, {} lost, {gaps} gaps",
                self.lost
            ),
        );
        line("refused", self.refused());
        if let Some(period_s) = self.period_s() {
            let [milliseconds, rate_hz] = [1e3 * period_s, 1.0 / period_s].map(six_digits);
            line("period", format!("{milliseconds} ms ({rate_hz} Hz)"));
        }
        let (squares, count, largest_s) = self.jitter;
        if count > 0 {
            let rms_s = (squares / count as f64).sqrt();
            line("jitter", format!("{} rms, {} at most", milliseconds(rms_s), milliseconds(largest_s)));
        }
        if self.answers.count() > 0 {
            let [median, late] = [0.5, 0.999].map(|part| milliseconds(self.answers.quantile_s(part)));
            let sent = self.answers.count();
            line(
                "answers",
                format!("{sent} sent, {} not sent; after {median} (median), {late} (99.9 %)", self.not_sent),
            );
        }
        text
    }

    /// Counts an answer that was sent `delay` after its packet came.
    pub fn answer(&mut self, delay: Duration) {
        self.answers.add(delay.as_secs_f64());
    }
}

fn milliseconds(time_s: f64) -> String {
    format!("{:.3} ms", 1e3 * time_s)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every tenth packet of 50 Hz is lost; each arrives 2 ms late in turns.
    #[test]
    fn losses_period_and_jitter_are_found() {
        let mut traffic = Traffic::default();
        for tick in (0..1000_u32).filter(|tick| tick % 10 != 5) {
            let (time_s, late_s) = (f64::from(tick) * 0.02, f64::from(tick % 2) * 0.002);
            match tick {
                0 => traffic.begin(time_s, time_s),
                _ => traffic.go_on(time_s, time_s + late_s, false),
            }
        }
        assert_eq!((traffic.flown, traffic.lost()), (900, 100));
        assert!((traffic.period_s().unwrap() - 0.02).abs() < 1e-12);
        let (squares, count, largest_s) = traffic.jitter;
        // Over a lost packet of odd number, both neighbours are even.
        assert!((largest_s - 0.002).abs() < 1e-9 && count == 899);
        assert!((squares - 799.0 * 4e-6).abs() < 1e-9, "{squares}");
        assert!(traffic.text().contains("900 flown") && traffic.text().contains("20 ms (50 Hz)"));
    }

    #[test]
    fn refused_packets_are_named() {
        let mut traffic = Traffic::default();
        assert_eq!(traffic.refused(), "none");
        assert!(traffic.refuse(Why::Length) && !traffic.refuse(Why::Length) && traffic.refuse(Why::Late));
        assert_eq!(traffic.refused(), "2 of another length, 1 late or repeated");
        assert_eq!(Why::ALL.map(|why| why as usize), [0, 1, 2, 3, 4, 5, 6, 7, 8, 9]);
    }
}
