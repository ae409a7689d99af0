//! Times of rows.

use super::mapping::{LogMapping, TimeFormat};

const DAY_S: f64 = 86400.0;

/// Largest offset of a zone from UTC.
const LARGEST_OFFSET_H: f64 = 14.0;

/// The times of the rows, one after the other.
#[derive(Debug)]
pub struct Clock {
    format: TimeFormat,
    rate_hz: f64,
    rows: u64,
    /// Day of the first row.
    first_day: Option<i64>,
    /// Days since the first row, and the time of day of the last row [s].
    days: f64,
    last_s: f64,
}

impl Clock {
    /// For rows whose times `mapping` describes.
    pub fn new(mapping: &LogMapping) -> Self {
        Self {
            format: mapping.time_format,
            rate_hz: mapping.rate_hz.unwrap_or(1.0),
            rows: 0,
            first_day: None,
            days: 0.0,
            last_s: f64::NEG_INFINITY,
        }
    }

    /// Whether the time is written as a number.
    pub fn is_number(&self) -> bool {
        self.format == TimeFormat::Number
    }

    /// What a cell must be, in words.
    pub fn expected(&self) -> &'static str {
        match self.format {
            TimeFormat::Hms => "hh:mm:ss",
            TimeFormat::Mmss => "mm:ss",
            TimeFormat::Iso => "a date and a time, as 2024-05-01T12:30:00Z",
            TimeFormat::Dmy => "a date and a time, as 31.05.2024 12:30:00",
            TimeFormat::Mdy => "a date and a time, as 05/31/2024 12:30:00",
            TimeFormat::Number | TimeFormat::Row => "a finite number",
        }
    }

    /// Time of a further row [s], whose cell is `text` if the log has one.
    pub fn next(&mut self, text: &str) -> Option<f64> {
        self.rows += 1;
        match self.format {
            TimeFormat::Number => of_number(text),
            TimeFormat::Row => Some((self.rows - 1) as f64 / self.rate_hz),
            TimeFormat::Mmss => stopwatch(text),
            TimeFormat::Hms => {
                let time_s = time_of_day(without_zone(text))?;
                if time_s < self.last_s - 0.5 * DAY_S {
                    self.days += 1.0;
                }
                self.last_s = time_s;
                Some(self.days * DAY_S + time_s)
            }
            TimeFormat::Iso | TimeFormat::Dmy | TimeFormat::Mdy => {
                let (day, time_s) = date_and_time(text, self.format)?;
                let first = *self.first_day.get_or_insert(day);
                Some((day - first) as f64 * DAY_S + time_s)
            }
        }
    }
}

/// A number, also with the unit of seconds behind it, as durations are written: 0.1 sec.
fn of_number(text: &str) -> Option<f64> {
    let bare = ["sec", "s"].iter().find_map(|unit| text.strip_suffix(unit)).unwrap_or(text);
    bare.trim_end().parse().ok().filter(|time_s: &f64| time_s.is_finite())
}

/// A number of digits alone, with decimals where `is_last`.
fn digits(text: &str, is_last: bool) -> Option<f64> {
    let is_valid = |letter: char| letter.is_ascii_digit() || (is_last && letter == '.');
    let begins = text.starts_with(|letter: char| letter.is_ascii_digit());
    (begins && text.chars().all(is_valid)).then(|| text.parse().ok()).flatten()
}

/// Seconds of hh:mm:ss, hh:mm, hhmmss or hhmmssmmm; with AM or PM behind it 12 hours are counted twice.
fn time_of_day(text: &str) -> Option<f64> {
    let letters = text.len().checked_sub(2).and_then(|at| text.split_at_checked(at));
    let half = letters.filter(|(_, half)| ["am", "pm"].contains(&half.to_ascii_lowercase().as_str()));
    if let Some((twelve, half)) = half {
        let time_s = time_of_day(twelve.trim_end())?;
        let hour = (3600.0..13.0 * 3600.0).contains(&time_s).then_some(time_s % (0.5 * DAY_S))?;
        return Some(if half.eq_ignore_ascii_case("pm") { hour + 0.5 * DAY_S } else { hour });
    }
    let parts: Vec<&str> = match text.split(':').collect::<Vec<_>>().as_slice() {
        [whole] if whole.is_ascii() => match whole.find('.').unwrap_or(whole.len()) {
            // A number has no zeros before it.
            hours @ (5 | 6) => vec![&whole[..hours - 4], &whole[hours - 4..hours - 2], &whole[hours - 2..]],
            // Milliseconds without a point.
            count @ (8 | 9) if count == whole.len() => {
                let (seconds, milliseconds) = whole.split_at(count - 3);
                return Some(time_of_day(seconds)? + 1e-3 * digits(milliseconds, false)?);
            }
            _ => return None,
        },
        [_] => return None,
        parts if parts.len() <= 3 => parts.to_vec(),
        _ => return None,
    };
    let hours = digits(parts[0], false)?;
    let minutes = digits(parts[1], false)?;
    let seconds = parts.get(2).map_or(Some(0.0), |text| digits(text, true))?;
    (hours < 24.0 && minutes < 60.0 && seconds < 61.0).then_some((hours * 60.0 + minutes) * 60.0 + seconds)
}

/// Seconds of mm:ss or h:mm:ss.
fn stopwatch(text: &str) -> Option<f64> {
    let (minutes, seconds) = text.rsplit_once(':')?;
    let below_60 = |text, is_last| digits(text, is_last).filter(|number| *number < 60.0);
    let minutes = match minutes.split_once(':') {
        Some((hours, minutes)) => 60.0 * digits(hours, false)? + below_60(minutes, false)?,
        None => digits(minutes, false)?,
    };
    Some(60.0 * minutes + below_60(seconds, true)?).filter(|time_s| time_s.is_finite())
}

/// A time without the name of universal time behind it.
fn without_zone(text: &str) -> &str {
    let without = |zone: &str| {
        let (time, end) = text.split_at_checked(text.len().checked_sub(zone.len())?)?;
        end.eq_ignore_ascii_case(zone).then_some(time.trim_end())
    };
    ["UTC", "GMT", "Z"].into_iter().find_map(without).unwrap_or(text)
}

/// Day, and the seconds since its midnight, in UTC if an offset is given.
fn date_and_time(text: &str, format: TimeFormat) -> Option<(i64, f64)> {
    let count = text.find(|letter: char| !letter.is_ascii_digit()).unwrap_or(text.len());
    // A date without marks, and a date and a time that are one number, whose century may be missing.
    let (date, time) = match (format, count) {
        (TimeFormat::Iso, 12 | 14) => text.split_at_checked(count - 6)?,
        _ => text.split_once(['T', ' '])?,
    };
    let [first, second, third] = match (format, date.len()) {
        (TimeFormat::Iso, 8) if count >= 8 => [&date[..4], &date[4..6], &date[6..]],
        (TimeFormat::Iso, 6) if count == 12 => [&date[..2], &date[2..4], &date[4..]],
        _ => date.split(['-', '/', '.']).collect::<Vec<_>>().try_into().ok()?,
    };
    let [year, month, day] = match format {
        TimeFormat::Dmy => [third, second, first],
        TimeFormat::Mdy => [third, first, second],
        _ if first.len() != 4 && count != 12 => return None,
        _ => [first, second, third],
    };
    let [year, month, day] = [digits(year, false)?, digits(month, false)?, digits(day, false)?];
    let year = if count == 12 { 2000.0 + year } else { year };
    if !(1.0..=9999.0).contains(&year) || !(1.0..=12.0).contains(&month) || !(1.0..=31.0).contains(&day) {
        return None;
    }
    let time = without_zone(time.trim());
    let (time, offset_s) = match time.rfind(['+', '-']) {
        None => (time, 0.0),
        Some(at) => {
            let (hours, minutes) = match time[at + 1..].split_once(':') {
                Some(parts) => parts,
                None if time.len() == at + 5 => time[at + 1..].split_at_checked(2)?,
                None => (&time[at + 1..], "0"),
            };
            let (hours, minutes) = (digits(hours, false)?, digits(minutes, false)?);
            if hours > LARGEST_OFFSET_H || minutes >= 60.0 {
                return None;
            }
            let offset_s = (hours * 60.0 + minutes) * 60.0;
            (&time[..at], if time[at..].starts_with('-') { -offset_s } else { offset_s })
        }
    };
    let time_s = time_of_day(time)? - offset_s;
    let carried = (time_s / DAY_S).floor();
    let day = day_number(year as i64, month as i64, day as i64) + carried as i64;
    Some((day, time_s - carried * DAY_S))
}

/// Number of a day of the Gregorian calendar: years begin with March, so that the leap day is the last.
fn day_number(year: i64, month: i64, day: i64) -> i64 {
    let (year, month) = if month > 2 { (year, month - 3) } else { (year - 1, month + 9) };
    365 * year + year / 4 - year / 100 + year / 400 + (153 * month + 2) / 5 + day
}

#[cfg(test)]
mod tests {
    use super::*;

    fn times(format: TimeFormat, texts: &[&str]) -> Vec<Option<f64>> {
        let mut clock =
            Clock::new(&LogMapping { time_format: format, rate_hz: Some(50.0), ..LogMapping::default() });
        texts.iter().map(|text| clock.next(text)).collect()
    }

    #[test]
    fn times_of_each_format() {
        use TimeFormat::{Dmy, Hms, Iso, Mdy, Mmss, Number, Row};
        assert_eq!(times(Number, &["1.5", "x"]), [Some(1.5), None]);
        assert_eq!(times(Row, &["", "7", ""]), [Some(0.0), Some(0.02), Some(0.04)]);
        let over_midnight =
            ["23:59:59.5", "00:00:00.5", "000001", "23:00", "24:00:00", "1:2", "12", "-1:00:00"];
        let expected = [Some(86399.5), Some(86400.5), Some(86401.0), Some(169200.0), None, None, None, None];
        let mut found = times(Hms, &over_midnight);
        // 1:2 is one hour and two minutes, of the day after.
        assert_eq!(found.remove(5), Some(2.0 * DAY_S + 3720.0));
        found.insert(5, None);
        assert_eq!(found, expected);
        let dates = [
            "2024-02-28T23:59:59.25Z",
            "2024-02-29 00:00:00",
            "2024-03-01T01:00:00+02:00",
            "2024-03-01T00:00:00-0100",
            "2025-02-28T00:00:00Z",
            "2024-13-01T00:00:00Z",
            "2024-02-28",
            "2024-02-29T00:00:00+99:00",
            "2024-02-29T00:00:00+01:60",
        ];
        let expected = [
            Some(86399.25),
            Some(DAY_S),
            Some(1.0 * DAY_S + 23.0 * 3600.0),
            Some(2.0 * DAY_S + 3600.0),
            Some(366.0 * DAY_S),
            None,
            None,
            None,
            None,
        ];
        assert_eq!(times(Iso, &dates), expected);
        assert_eq!(times(Iso, &["2024/02/28 12:00", "28.02.24 12:00"]), [Some(0.5 * DAY_S), None]);
        let days = ["28.11.2026 13:05:09.25", "29-11-2026 00:00:00", "11/28/2026 1:05:09"];
        assert_eq!(times(Dmy, &days), [Some(47109.25), Some(DAY_S), None]);
        assert_eq!(times(Dmy, &["31/12/26 00:00", "1/1/27 00:00"]), [Some(0.0), Some(DAY_S)]);
        let months =
            ["11/28/2026 1:05:09 PM", "11/28/2026 12:00:01 am", "11/29/2026 12:00 PM", "28.11.2026 13:05"];
        assert_eq!(times(Mdy, &months), [Some(47109.0), Some(1.0), Some(1.5 * DAY_S), None]);
        let zones = ["2026-05-03 09:14:00 UTC", "2026-05-03T09:14:01 gmt", "2026-05-03 09:14:02z"];
        assert_eq!(times(Iso, &zones), [33240.0, 33241.0, 33242.0].map(Some));
        assert_eq!(times(Hms, &["09:14:00 UTC", "91401.5", "0914020"]), [Some(33240.0), Some(33241.5), None]);
        let shown = ["00:59.5", "61:00", "1:01:01", "1:60:00", "1:60", "7", ":5"];
        let expected = [Some(59.5), Some(3660.0), Some(3661.0), None, None, None, None];
        assert_eq!(times(Mmss, &shown), expected);
        assert_eq!(times(Hms, &["1:00:00 PM", "13:00:00 PM", "0:10 AM"]), [Some(46800.0), None, None]);
    }
}
