//! The foot of a page: when, by which command, by which version and on which machine it was written.

use std::time::{SystemTime, UNIX_EPOCH};

use maud::{Markup, html};

use crate::failure::printable;
use crate::terminal::quoted;

/// The foot of a page that is written now.
pub fn foot() -> Markup {
    let words = std::env::args_os().skip(1).map(quoted);
    let command = words.fold("sins".to_owned(), |all, word| all + " " + &word);
    html! {
        footer {
            p { "Written on " (date(now_s())) " by sins " (env!("CARGO_PKG_VERSION")) ": " code { (printable(&command)) } }
            p { (machine()) }
        }
    }
}

/// Time since 1970 [s]; that of SOURCE_DATE_EPOCH, if it is set, so that a page can be written again to the same bytes.
fn now_s() -> u64 {
    let fixed = std::env::var("SOURCE_DATE_EPOCH").ok().and_then(|text| text.parse().ok());
    fixed.unwrap_or_else(|| SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |since| since.as_secs()))
}

/// Date and time of day in UTC. Days are counted in eras of 400 years, which begin with March: leap days end a year.
fn date(seconds: u64) -> String {
    const ERA: u64 = 146_097;
    let days = seconds / 86_400 + 719_468;
    let (era, day) = (days / ERA, days % ERA);
    let year = (day - day / 1460 + day / 36_524 - day / (ERA - 1)) / 365;
    let day = day - (365 * year + year / 4 - year / 100);
    let month = (5 * day + 2) / 153;
    let day = day - (153 * month + 2) / 5 + 1;
    let (year, month) = if month < 10 { (year, month + 3) } else { (year + 1, month - 9) };
    let (hour, minute) = (seconds / 3600 % 24, seconds / 60 % 60);
    format!("{:04}-{month:02}-{day:02} {hour:02}:{minute:02} UTC", year + 400 * era)
}

/// Operating system, processor and number of threads.
fn machine() -> String {
    let system = format!("{} on {}", std::env::consts::OS, std::env::consts::ARCH);
    let threads = crate::parallel::cores();
    let model = std::fs::read_to_string("/proc/cpuinfo").ok().and_then(|text| {
        let line = text.lines().find(|line| line.starts_with("model name"))?;
        Some(line.split_once(':')?.1.trim().to_owned())
    });
    let threads = format!("{threads} thread{}", if threads == 1 { "" } else { "s" });
    let parts = [Some(system), model.map(|model| printable(&model)), Some(threads)];
    parts.into_iter().flatten().collect::<Vec<_>>().join(", ") + "."
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Known days: the first, both ends of a leap day, the turns of centuries.
    #[test]
    fn dates_are_those_of_the_calendar() {
        for (seconds, text) in [
            (0, "1970-01-01 00:00 UTC"),
            (951_782_399, "2000-02-28 23:59 UTC"),
            (951_782_400, "2000-02-29 00:00 UTC"),
            (951_868_800, "2000-03-01 00:00 UTC"),
            (1_704_067_199, "2023-12-31 23:59 UTC"),
            (4_107_542_400, "2100-03-01 00:00 UTC"),
            (4_107_542_399, "2100-02-28 23:59 UTC"),
        ] {
            assert_eq!(date(seconds), text, "{seconds}");
        }
    }

    #[test]
    fn words_of_a_command_are_quoted_where_they_must_be() {
        let words = ["a.csv", "gyro.bias_deg_h=0.01", "two words", "", "x;y"].map(quoted);
        assert_eq!(words, ["a.csv", "gyro.bias_deg_h=0.01", "\"two words\"", "\"\"", "\"x;y\""]);
    }
}
