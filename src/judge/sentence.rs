//! Sentences of findings. They are written without memory of the heap.

use core::fmt::{self, Write};

use super::finding::{Clue, Finding, Kind, MIRRORED, RADIANS, ZERO};

impl fmt::Display for Finding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (figure, at) = (Digits(self.figure), Digits(self.at.time_s));
        let degrees = Digits(self.figure / crate::base::units::DEG);
        match (self.kind, self.clue) {
            (Kind::TimeOrder, _) => {
                write!(
                    f,
                    "{}: not later than the one before, first at {at} s",
                    Counted(self.count, "time stamp")
                )
            }
            (Kind::NearStamps, _) => {
                let shortest = Digits(1e3 * self.figure);
                write!(
                    f,
                    "{} much nearer to the one before than the others, down to {shortest} ms at {at} s",
                    Counted(self.count, "time stamp")
                )
            }
            (Kind::Gaps, _) if self.count == 1 => {
                write!(f, "a gap of {figure} s in the time stamps, before {at} s")
            }
            (Kind::Gaps, _) => {
                let count = self.count;
                write!(f, "{count} gaps in the time stamps, the longest of {figure} s, before {at} s")
            }
            (Kind::TimeUnit, _) => write!(f, "the vehicle moves at {figure} m/s (is the time in ms or us?)"),
            (Kind::StampJitter, _) => {
                write!(f, "time stamps scatter by {} ms about a steady clock", Digits(1e3 * self.figure))
            }
            (Kind::CoarsePositions, clue) => {
                let word = if clue == Clue::Float32 { " (32-bit floats?)" } else { "" };
                write!(f, "positions step by {figure} m{word}")
            }
            (Kind::NoisyPositions, clue) => {
                write!(f, "positions have {figure} m of noise")?;
                known(f, &clue)
            }
            (Kind::NoisyVelocities, _) => write!(f, "velocities have {figure} m/s of noise"),
            (Kind::NoisyAttitude, _) => write!(f, "attitude has {degrees} deg of noise"),
            (Kind::CoarseAttitude, _) => write!(f, "attitude steps by {degrees} deg"),
            (Kind::UnreadContradicts, clue) => {
                let verb = if self.count == 1 {
                    "is not read, and contradicts"
                } else {
                    "are not read, and contradict"
                };
                write!(f, "{} {verb} what flies", Counted(self.count, "column"))?;
                match clue {
                    Clue::Known(quantity) => {
                        write!(f, ": the {quantity}{}", if self.count > 1 { " first of all" } else { "" })
                    }
                    _ => Ok(()),
                }
            }
            (Kind::VelocityLate, _) => {
                let word = if self.figure < 0.0 { "early" } else { "late" };
                let delay = Digits(self.figure.abs());
                write!(f, "velocity is {delay} s too {word} for the positions (is it on another clock?)")
            }
            (Kind::HeldRows, _) => {
                let percent = Digits(100.0 * self.figure);
                write!(
                    f,
                    "{percent} % of the moving rows repeat the position of the row before (a slower receiver, or stale fixes?)"
                )
            }
            (Kind::Spike, _) => {
                write!(f, "a position is {figure} m beside the path of its neighbours at {at} s")
            }
            (Kind::Acceleration, clue) => {
                write!(f, "the flight accelerates by {figure} m/s2 at {at} s")?;
                match clue {
                    Clue::Limit(limit) => {
                        write!(f, ", and options.max_acceleration_m_s2 is {}", Digits(limit))
                    }
                    _ => Ok(()),
                }
            }
            (Kind::NotYetFixed, _) => {
                write!(f, "the first {} hold a value from before the first fix", Counted(self.count, "row"))
            }
            (Kind::VelocityUnit, clue) => velocity_sentence(f, self.figure, &clue),
            (Kind::VelocityContradicts, _) => {
                let percent = Digits(100.0 * self.figure);
                write!(
                    f,
                    "velocity contradicts the positions by {percent} % of the displacement, and no simple factor or exchange of axes explains it"
                )
            }
            (Kind::VelocityAtTimes, _) => {
                write!(f, "velocity contradicts the positions by up to {figure} m, at {at} s")
            }
            (Kind::VerticalUnit, clue) => {
                write!(f, "the climb is {figure} times the velocity up")?;
                known(f, &clue)
            }
            (Kind::AttitudeTurned, clue) => {
                let name = if let Clue::Known(name) = clue { name } else { "attitude" };
                write!(f, "{name} is {degrees} deg in straight flight (are its axes turned?)")
            }
            (Kind::HeadingUnit, Clue::Known(MIRRORED)) => {
                write!(f, "heading and roll turn, and the track does not follow ({MIRRORED}?)")
            }
            (Kind::HeadingUnit, clue) => {
                f.write_str("heading turns against the track")?;
                known(f, &clue)
            }
            (Kind::HeadingOffTrack, _) => write!(
                f,
                "heading is off the track by {degrees} deg (a magnetic heading, or flight sideways?)"
            ),
            (Kind::AngleThroughWrap, clue) => {
                let angle = if let Clue::Known(name) = clue { name } else { "an angle" };
                write!(f, "{angle} sweeps backwards through a turn at {degrees} deg/s at {at} s")?;
                if self.count > 1 {
                    write!(f, ", {} times", self.count)?;
                }
                f.write_str(" (interpolated through its wrap?)")
            }
            (Kind::RollSign, Clue::Known("opposite sign")) => write!(
                f,
                "roll has the opposite sign of the turns (slope {figure}): positive is right wing down"
            ),
            (Kind::RollSign, Clue::Known(RADIANS)) => {
                write!(f, "roll is {figure} of the bank of the turns ({RADIANS}?)")
            }
            (Kind::PitchSign, Clue::Known(RADIANS)) => {
                write!(f, "pitch is {figure} of the angle of the path ({RADIANS}?)")
            }
            (Kind::RollUnexplained, clue @ Clue::Known(_)) => {
                write!(f, "roll is {figure} times the bank of the turns")?;
                known(f, &clue)
            }
            (Kind::RollSign, clue) => {
                write!(f, "roll does not explain the turns (slope {figure}), and pitch does")?;
                known(f, &clue)
            }
            (Kind::RollUnexplained, _) => {
                write!(f, "roll does not explain the turns (slope {figure}, expected about 1)")
            }
            (Kind::PitchSign, _) => {
                write!(f, "pitch has the opposite sign of the climb (slope {figure}): positive is nose up")
            }
            (Kind::AttackNegative, _) => {
                write!(
                    f,
                    "the nose points {} deg below the path",
                    Digits(-self.figure / crate::base::units::DEG)
                )
            }
            (Kind::HeightUnit, _) => write!(
                f,
                "the path climbs {} times as steeply as the nose points (is the height in feet?)",
                Digits(1.0 / self.figure)
            ),
            (Kind::HeightAboveAir, _) => write!(
                f,
                "it flies level at {} km at {at} s, where no air carries it (is the height in millimetres?)",
                Digits(self.figure / 1000.0)
            ),
            (Kind::AttitudeHeld, Clue::Known(ZERO)) => {
                let away = Digits(self.figure / crate::base::units::DEG);
                write!(f, "{ZERO} from {at} s on, and {away} deg from that in the rows beside")?;
                if self.count > 1 { write!(f, " ({} times)", self.count) } else { Ok(()) }
            }
            (Kind::AttitudeHeld, clue) => {
                let what = if let Clue::Known(name) = clue { name } else { "attitude" };
                let turn = Digits((self.figure / crate::base::units::DEG).abs());
                write!(f, "{what} stays the same from {at} s on, while the track turns by {turn} deg")?;
                if self.count > 1 { write!(f, " ({} times)", self.count) } else { Ok(()) }
            }
            (Kind::AttitudeLate, clue) => {
                let name = if let Clue::Known(name) = clue { name } else { "roll" };
                let word = if self.figure < 0.0 { "early" } else { "late" };
                let delay = Digits(self.figure.abs());
                write!(f, "{name} is {delay} s too {word} for the turns (is the attitude on another clock?)")
            }
        }?;
        if self.acceleration_m_s2 > 0.0 {
            write!(f, "; this makes {} m/s2 of false acceleration", Digits(self.acceleration_m_s2))?;
        }
        if self.ins_error_m > 0.0 {
            write!(f, "; an INS with ideal sensors errs by up to {} m", Digits(self.ins_error_m))?;
        }
        Ok(())
    }
}

fn known(f: &mut fmt::Formatter<'_>, clue: &Clue) -> fmt::Result {
    match clue {
        Clue::Known(name) => write!(f, " ({name}?)"),
        _ => Ok(()),
    }
}

fn velocity_sentence(f: &mut fmt::Formatter<'_>, ratio: f64, clue: &Clue) -> fmt::Result {
    let Clue::Velocity { unit, exchanged, opposite } = clue else {
        return write!(f, "velocity is {} times the displacement", Digits(ratio));
    };
    let mut parts = 0;
    let mut part = |f: &mut fmt::Formatter<'_>| {
        parts += 1;
        f.write_str(if parts > 1 { ", and " } else { "" })
    };
    if *unit != "m/s" {
        part(f)?;
        write!(f, "velocity is {} times the displacement ({unit}?)", Digits(ratio))?;
    }
    if *exchanged {
        part(f)?;
        f.write_str("velocity east and north are exchanged")?;
    }
    for (name, _) in ["east", "north", "up"].iter().zip(opposite).filter(|(_, is_opposite)| **is_opposite) {
        part(f)?;
        write!(f, "velocity {name} has the opposite sign")?;
    }
    Ok(())
}

/// A count and its noun.
struct Counted(u64, &'static str);

impl fmt::Display for Counted {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {}{}", self.0, self.1, if self.0 == 1 { "" } else { "s" })
    }
}

/// A number with three or four significant digits, and all those before the point.
struct Digits(f64);

impl fmt::Display for Digits {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let size = self.0.abs();
        let decimals = match size {
            _ if size >= 1000.0 || size == 0.0 => return write!(f, "{:.0}", self.0),
            _ if size >= 100.0 => 1,
            _ if size >= 1.0 => 2,
            _ if size >= 0.01 => 4,
            _ => return write!(f, "{:.2e}", self.0),
        };
        let mut text = Text { bytes: [0; 16], length: 0 };
        write!(text, "{:.decimals$}", self.0)?;
        let written = core::str::from_utf8(&text.bytes[..text.length]).map_err(|_| fmt::Error)?;
        f.write_str(written.trim_end_matches('0').trim_end_matches('.'))
    }
}

/// A short text on the stack.
struct Text {
    bytes: [u8; 16],
    length: usize,
}

impl fmt::Write for Text {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        let end = self.length + text.len();
        self.bytes.get_mut(self.length..end).ok_or(fmt::Error)?.copy_from_slice(text.as_bytes());
        self.length = end;
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_the_digits_that_matter() {
        let texts =
            [0.0, 19602.4, 683.25, 1.9438, -0.0304, 0.000_06, 5.0, 100.0].map(|x| Digits(x).to_string());
        assert_eq!(texts, ["0", "19602", "683.2", "1.94", "-0.0304", "6.00e-5", "5", "100"]);
    }
}
