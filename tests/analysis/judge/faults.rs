//! Faults that logs have, put into good flights: each is found, with its reason.

use nalgebra::Vector3;
use sins::judge::{Finding, Kind, Level};
use sins::math::{Euler, SPLIT_MIX_STEP, mix, wrap_angle};
use sins::truth::FlightSample;

use super::flights::{self, Good, Samples, without_velocities};
use super::judged;
use crate::support::DEG;

/// Radius of the Earth [m], for sizes of damage.
const RADIUS_M: f64 = 6.37e6;

/// Uniform numbers from -1 to 1. The figures of `analysis::smooth_cep` depend on them.
pub struct Draws(pub u64);

impl Draws {
    pub fn uniform(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(1);
        (mix(self.0.wrapping_mul(SPLIT_MIX_STEP)) >> 11) as f64 / 2f64.powi(52) - 1.0
    }

    /// Nearly normal, of deviation 1.
    pub fn normal(&mut self) -> f64 {
        (0..12).map(|_| self.uniform()).sum::<f64>() / 2.0
    }
}

pub fn each(samples: &[FlightSample], mut damage: impl FnMut(usize, &mut FlightSample)) -> Samples {
    let mut damaged = samples.to_vec();
    damaged.iter_mut().enumerate().for_each(|(k, sample)| damage(k, sample));
    damaged
}

pub fn move_by(sample: &mut FlightSample, east_m: f64, north_m: f64, up_m: f64) {
    sample.place.latitude_rad += north_m / RADIUS_M;
    sample.place.longitude_rad += east_m / (RADIUS_M * sample.place.latitude_rad.cos());
    sample.place.height_m += up_m;
}

pub fn float32(samples: &[FlightSample]) -> Samples {
    let single = |angle: f64| f64::from((angle / DEG) as f32) * DEG;
    each(&without_velocities(samples), |_, sample| {
        sample.place.latitude_rad = single(sample.place.latitude_rad);
        sample.place.longitude_rad = single(sample.place.longitude_rad);
    })
}

pub fn noisy(samples: &[FlightSample], sigma_m: f64) -> Samples {
    let mut draws = Draws(1);
    each(&without_velocities(samples), |_, sample| {
        let [east, north, up] = [(); 3].map(|()| sigma_m * draws.normal());
        move_by(sample, east, north, 1.5 * up);
    })
}

/// A receiver of a fifth of the rate, its fixes repeated.
pub fn held(samples: &[FlightSample]) -> Samples {
    let mut last = samples[0].place;
    each(&without_velocities(samples), |k, sample| {
        if k % 5 == 0 {
            last = sample.place;
        }
        sample.place = last;
    })
}

/// One fix in twenty repeats the one before.
pub fn stale(samples: &[FlightSample]) -> Samples {
    let mut last = samples[0].place;
    each(&without_velocities(samples), |k, sample| {
        if k % 20 == 7 {
            sample.place = last;
        }
        last = sample.place;
    })
}

/// The flights that are damaged.
fn moving() -> Vec<Good> {
    let scenes = ["racetrack", "commuter", "aerobatics", "patrol"].map(|name| flights::scene(name, 50.0));
    let logs = ["airliner_cruise", "fighter_aerobatics"].map(flights::log);
    scenes.into_iter().chain(logs).collect()
}

/// Damages each flight at a rate, and looks for a finding of one of the `kinds`, at least of a level. The flights without.
fn missed(
    kinds: &[Kind],
    least: Level,
    rate_hz: f64,
    damage: impl Fn(&[FlightSample]) -> Samples,
) -> Vec<String> {
    let mut missed = Vec::new();
    for flight in moving() {
        let findings = judged(&damage(&flight.at(rate_hz)));
        for finding in &findings {
            println!("{} {rate_hz} Hz: {:?} {:?}: {finding}", flight.name, finding.level, finding.kind);
        }
        if !findings.iter().any(|finding| kinds.contains(&finding.kind) && finding.level >= least) {
            println!("{} {rate_hz} Hz: no {kinds:?}", flight.name);
            missed.push(flight.name);
        }
    }
    missed
}

const NONE: [&str; 0] = [];

#[test]
fn coarse_and_noisy_positions_are_found() {
    use Level::{Doubtful, Unusable};
    assert_eq!(missed(&[Kind::CoarsePositions], Unusable, 50.0, float32), NONE);
    for (sigma_m, rate_hz, level) in [(2.5, 10.0, Unusable), (2.5, 1.0, Doubtful), (0.5, 10.0, Unusable)] {
        let noisy = |samples: &[FlightSample]| noisy(samples, sigma_m);
        assert_eq!(missed(&[Kind::NoisyPositions], level, rate_hz, noisy), NONE);
    }
    let coarse = |samples: &[FlightSample]| {
        let round = |angle: f64| (angle / DEG * 1e5).round() / 1e5 * DEG;
        each(&without_velocities(samples), |_, sample| {
            sample.place.latitude_rad = round(sample.place.latitude_rad);
            sample.place.longitude_rad = round(sample.place.longitude_rad);
            sample.place.height_m = (sample.place.height_m / 7.62).round() * 7.62;
        })
    };
    assert_eq!(missed(&[Kind::CoarsePositions], Doubtful, 10.0, coarse), NONE);
}

/// Rows that are lost: three times, for a different time.
#[test]
fn gaps_are_found() {
    let samples = flights::scene("patrol", 10.0).samples;
    let kept = samples
        .iter()
        .enumerate()
        .filter(|(k, _)| !(100..103).contains(k) && !(200..215).contains(k) && !(400..402).contains(k));
    let kept: Vec<_> = kept.map(|(_, sample)| *sample).collect();
    for samples in [kept.clone(), without_velocities(&kept)] {
        let findings = judged(&samples);
        assert_eq!(findings.len(), 1, "{findings:?}");
        let words = "3 gaps in the time stamps, the longest of 1.6 s, before 21.5 s";
        assert_eq!((findings[0].level, findings[0].to_string().as_str()), (Level::Note, words));
    }
    assert!(judged(&samples).is_empty());
}

#[test]
fn held_rows_spikes_and_rows_before_the_first_fix_are_found() {
    use Level::{Doubtful, Unusable};
    assert_eq!(missed(&[Kind::HeldRows], Unusable, 50.0, held), NONE);
    assert_eq!(missed(&[Kind::HeldRows], Doubtful, 10.0, stale), NONE);
    // A receiver that froze once, for 20 s: the share is that of these rows.
    for flight in moving() {
        let rows = without_velocities(&flight.at(10.0));
        let middle = rows.len() / 2;
        let frozen = each(&rows, |k, sample| {
            if (middle..=middle + 200).contains(&k) {
                sample.place = rows[middle].place;
            }
        });
        let found = judged(&frozen).into_iter().find(|finding| finding.kind == Kind::HeldRows).unwrap();
        let share = 200.0 / rows.len() as f64;
        assert!((found.figure / share - 1.0).abs() < 0.1, "{}: {} for {share}", flight.name, found.figure);
        assert_eq!(found.at.row, middle as u64 + 1, "{}", flight.name);
    }
    for metres in [100.0, 800.0] {
        let spike = |samples: &[FlightSample]| {
            let middle = samples.len() / 2;
            each(&without_velocities(samples), |k, sample| {
                move_by(sample, if k == middle { metres } else { 0.0 }, 0.0, 0.0);
            })
        };
        assert_eq!(missed(&[Kind::Spike], Unusable, 1.0, spike), NONE);
    }
    // Zeros; zeros and the height of the geoid; a default place.
    for (height_m, degrees) in [(0.0, 0.0), (-38.2, 0.0), (2000.0, 1.0)] {
        let before = |samples: &[FlightSample]| {
            let first = samples[0].place;
            each(&without_velocities(samples), |k, sample| {
                let place = &mut sample.place;
                place.height_m += 2000.0;
                if k < 5 {
                    *place = first;
                    place.height_m = if degrees == 0.0 { height_m } else { first.height_m + height_m };
                    place.latitude_rad -= degrees * DEG * place.latitude_rad.signum();
                }
            })
        };
        assert_eq!(missed(&[Kind::NotYetFixed], Unusable, 1.0, before), NONE, "{height_m} {degrees}");
    }
}

#[test]
fn bad_time_stamps_are_found() {
    let near = |samples: &[FlightSample]| {
        let mut damaged = Vec::new();
        for (k, sample) in without_velocities(samples).iter().enumerate() {
            damaged.push(*sample);
            if k % 50 == 20 {
                damaged.push(FlightSample { time_s: sample.time_s + 60e-6, ..*sample });
            }
        }
        damaged
    };
    assert_eq!(missed(&[Kind::NearStamps], Level::Unusable, 10.0, near), NONE);
    let scatter = |samples: &[FlightSample]| {
        let mut draws = Draws(2);
        each(&without_velocities(samples), |_, sample| sample.time_s += 0.02 * draws.uniform())
    };
    assert_eq!(missed(&[Kind::StampJitter], Level::Unusable, 10.0, scatter), NONE);
    let milliseconds =
        |samples: &[FlightSample]| each(&without_velocities(samples), |_, sample| sample.time_s *= 1000.0);
    assert_eq!(missed(&[Kind::TimeUnit], Level::Unusable, 10.0, milliseconds), NONE);
    let late = |samples: &[FlightSample]| {
        each(samples, |k, sample| {
            if k == 100 {
                sample.time_s -= 1.0;
            }
        })
    };
    assert_eq!(missed(&[Kind::TimeOrder], Level::Unusable, 10.0, late), NONE);
}

#[test]
fn velocities_in_other_units_and_axes_are_found() {
    let of_each = |change: &dyn Fn(Vector3<f64>) -> Vector3<f64>| {
        let damage =
            |samples: &[FlightSample]| each(samples, |_, sample| sample.v_n = sample.v_n.map(change));
        missed(&[Kind::VelocityUnit, Kind::VerticalUnit], Level::Unusable, 10.0, damage)
    };
    for factor in [1.0 / 0.514444, 1.0 / 0.3048, 3.6, 1.0 / 0.44704] {
        assert_eq!(of_each(&|v| v * factor), NONE);
    }
    assert_eq!(of_each(&|v| Vector3::new(v.y, v.x, v.z)), NONE);
    assert_eq!(of_each(&|v| Vector3::new(v.x, -v.y, v.z)), NONE);
    // The racetrack is level.
    assert_eq!(of_each(&|v| Vector3::new(v.x, v.y, -v.z)), ["racetrack"]);
    let feet = |samples: &[FlightSample]| each(samples, |_, sample| sample.place.height_m /= 0.3048);
    assert_eq!(missed(&[Kind::VerticalUnit], Level::Unusable, 10.0, feet), ["racetrack"]);
    // The velocity up in ft/min, beside others in knots or m/s: it is said of each by itself.
    for (factor, unit) in [(1852.0 / 3600.0, Some("knots?")), (1.0, None)] {
        let climbs =
            |flight: &Good| ["commuter", "patrol", "airliner_cruise"].contains(&flight.name.as_str());
        for flight in moving().into_iter().filter(climbs) {
            let damaged = each(&flight.at(10.0), |_, sample| {
                let of = |v: Vector3<f64>| Vector3::new(v.x / factor, v.y / factor, v.z * 60.0 / 0.3048);
                sample.v_n = sample.v_n.map(of);
            });
            let told: Vec<String> = judged(&damaged).iter().map(Finding::to_string).collect();
            let has = |words: &str| told.iter().any(|told| told.contains(words));
            assert!(has("velocity in ft/min?"), "{} {unit:?}: {told:?}", flight.name);
            assert_eq!(has("times the displacement"), unit.is_some(), "{} {unit:?}: {told:?}", flight.name);
            assert!(unit.is_none_or(has), "{} {unit:?}: {told:?}", flight.name);
        }
    }
}

#[test]
fn two_reversed_velocities_are_found() {
    for rate_hz in [50.0, 2.0] {
        let reversed = |samples: &[FlightSample]| {
            let middle = samples.len() / 2;
            each(samples, |k, sample| {
                if k == middle || k == middle + 7 {
                    sample.v_n = sample.v_n.map(|v| -v);
                }
            })
        };
        assert_eq!(missed(&[Kind::VelocityAtTimes], Level::Doubtful, rate_hz, reversed), NONE);
    }
}

#[test]
fn attitudes_of_another_sign_or_unit_are_found() {
    let of_each = |kind: Kind, least: Level, change: &dyn Fn(&mut FlightSample)| {
        let damage = |samples: &[FlightSample]| each(samples, |_, sample| change(sample));
        missed(&[kind], least, 10.0, damage)
    };
    // The airliner turns by 50° only, in a wind that changes.
    let heading = |change: fn(f64) -> f64| {
        of_each(Kind::HeadingUnit, Level::Unusable, &move |sample| {
            sample.euler.heading = change(sample.euler.heading);
        })
    };
    assert_eq!(heading(|angle| -angle), ["airliner_cruise"]);
    assert_eq!(heading(|angle| angle / DEG), ["airliner_cruise"]);
    // The fighter is inverted half of its time: its roll does not explain the turns.
    let roll = of_each(Kind::RollSign, Level::Unusable, &|sample| sample.euler.roll *= -1.0);
    assert_eq!(roll, ["fighter_aerobatics"]);
    let exchanged = of_each(Kind::RollSign, Level::Unusable, &|sample| {
        let euler = &mut sample.euler;
        (euler.roll, euler.pitch) = (euler.pitch, euler.roll);
    });
    assert_eq!(exchanged, ["aerobatics"]);
    // Those that fly in all directions.
    let magnetic =
        of_each(Kind::HeadingOffTrack, Level::Doubtful, &|sample| sample.euler.heading -= 9.0 * DEG);
    assert_eq!(magnetic, ["commuter", "airliner_cruise"]);
    // Those that are nearly level.
    let pitch = of_each(Kind::PitchSign, Level::Unusable, &|sample| sample.euler.pitch *= -1.0);
    assert_eq!(pitch, ["racetrack", "patrol", "airliner_cruise"]);
    let feet = of_each(Kind::HeightUnit, Level::Doubtful, &|sample| {
        sample.v_n = None;
        sample.place.height_m /= 0.3048;
    });
    assert_eq!(feet, ["racetrack", "airliner_cruise", "fighter_aerobatics"]);
}

/// The heading swings about north, and was interpolated by number from each fifth row.
#[test]
fn headings_interpolated_through_north_are_found() {
    let wrapped = |samples: &[FlightSample]| {
        let turned = each(samples, |k, sample| {
            sample.euler.heading = (0.06 * (k as f64 * 0.05).sin()).rem_euclid(360.0 * DEG);
        });
        each(&turned, |k, sample| {
            let (before, after) = (k / 5 * 5, (k / 5 * 5 + 5).min(turned.len() - 1));
            let share = (k - before) as f64 / (after - before).max(1) as f64;
            let [first, second] = [before, after].map(|k| turned[k].euler.heading);
            sample.euler.heading = first + share * (second - first);
        })
    };
    for rate_hz in [50.0, 5.0] {
        assert_eq!(missed(&[Kind::AngleThroughWrap], Level::Doubtful, rate_hz, wrapped), NONE);
    }
}

/// Frozen from the time of the fastest turn of the track on, as by a unit that is read again before it has new attitudes.
#[test]
fn attitudes_that_stay_the_same_in_a_turn_are_found() {
    let track = |sample: &FlightSample| sample.v_n.map_or(0.0, |v| v.x.atan2(v.y));
    for rate_hz in [10.0, 1.0] {
        let frozen = |samples: &[FlightSample]| {
            let length = (20.0 * rate_hz) as usize;
            let turn = |k: usize| {
                let parts = samples[k..k + length].windows(2);
                parts.map(|pair| wrap_angle(track(&pair[1]) - track(&pair[0]))).sum::<f64>().abs()
            };
            let begin = (0..samples.len() - length).max_by(|a, b| turn(*a).total_cmp(&turn(*b))).unwrap();
            each(samples, |k, sample| {
                if (begin..begin + length).contains(&k) {
                    sample.euler = samples[begin].euler;
                }
            })
        };
        assert_eq!(missed(&[Kind::AttitudeHeld], Level::Doubtful, rate_hz, frozen), NONE);
    }
    let never = |samples: &[FlightSample]| {
        each(&without_velocities(samples), |_, sample| sample.euler = samples[0].euler)
    };
    assert_eq!(missed(&[Kind::AttitudeHeld], Level::Doubtful, 10.0, never), NONE);
}

#[test]
fn attitudes_on_another_clock_are_found() {
    for (delay_s, rate_hz) in [(2, 10), (-2, 10), (1, 10), (2, 1)] {
        let late = |samples: &[FlightSample]| {
            let rows = delay_s * rate_hz;
            each(samples, |k, sample| {
                let source = (k as i64 - rows).clamp(0, samples.len() as i64 - 1);
                sample.euler = samples[source as usize].euler;
            })
        };
        // In aerobatics hardly any roll is that of a turn.
        let mut unseen = missed(&[Kind::AttitudeLate], Level::Doubtful, rate_hz as f64, late);
        unseen.retain(|name| !name.contains("aerobatics"));
        assert_eq!(unseen, NONE, "{delay_s} s at {rate_hz} Hz");
    }
}

/// A heading alone that is late, where turns begin and end.
#[test]
fn headings_on_another_clock_are_found() {
    for (delay_s, rate_hz) in [(3, 10), (3, 4), (3, 1)] {
        let late = |samples: &[FlightSample]| {
            each(samples, |k, sample| {
                let source = (k as i64 - delay_s * rate_hz).clamp(0, samples.len() as i64 - 1);
                sample.euler.heading = samples[source as usize].euler.heading;
            })
        };
        // In aerobatics the roll does not show an aeroplane.
        let mut unseen = missed(&[Kind::AttitudeLate], Level::Doubtful, rate_hz as f64, late);
        unseen.retain(|name| !name.contains("aerobatics"));
        assert_eq!(unseen, NONE, "{delay_s} s at {rate_hz} Hz");
    }
}

/// A column of headings that is 0, or that stops: roll and pitch go on. In aerobatics the roll does not show an aeroplane.
#[test]
fn headings_that_stay_the_same_are_found() {
    for rate_hz in [10.0, 4.0, 1.0] {
        let zero = |samples: &[FlightSample]| each(samples, |_, sample| sample.euler.heading = 0.0);
        let stops = |samples: &[FlightSample]| {
            let from = samples.len() / 4;
            each(samples, |k, sample| sample.euler.heading = samples[k.min(from)].euler.heading)
        };
        for mut unseen in [
            missed(&[Kind::AttitudeHeld], Level::Doubtful, rate_hz, zero),
            missed(&[Kind::AttitudeHeld], Level::Doubtful, rate_hz, stops),
        ] {
            unseen.retain(|name| !name.contains("aerobatics"));
            assert_eq!(unseen, NONE, "{rate_hz} Hz");
        }
    }
}

/// A source that has no attitude for three seconds, or for one row, and writes 0, 0, 0.
#[test]
fn attitudes_of_zero_for_a_while_are_found() {
    for rate_hz in [50.0, 10.0, 1.0] {
        let flight = flights::aeroplane_in_wind(rate_hz);
        let away = |sample: &FlightSample| {
            let Euler { roll, pitch, heading } = sample.euler;
            [roll, pitch, heading].map(|angle| wrap_angle(angle).abs()).into_iter().fold(0.0, f64::max)
        };
        for length in [1, (3.0 * rate_hz) as usize] {
            let is_far =
                |k: &usize| [*k, k + length + 1].iter().all(|k| away(&flight.samples[*k]) > 11.0 * DEG);
            let begin = 1 + (100..).find(is_far).unwrap();
            let lost = each(&flight.samples, |k, sample| {
                if (begin..begin + length).contains(&k) {
                    sample.euler = Euler { roll: 0.0, pitch: 0.0, heading: 0.0 };
                }
            });
            let found = judged(&lost);
            let own = found.iter().find(|finding| finding.kind == Kind::AttitudeHeld);
            let own = own.unwrap_or_else(|| panic!("{rate_hz} Hz, {length}: {found:?}"));
            assert!(own.level == Level::Doubtful && own.at.row == begin as u64 && own.count == 1, "{own}");
            assert!(own.to_string().starts_with("attitude is 0, 0, 0 from "), "{own}");
        }
    }
    // A car without roll and pitch, in whole degrees, turns through north by 12 degrees a row.
    let flight = flights::aeroplane_in_wind(1.0);
    let car = each(&flight.samples, |k, sample| {
        sample.euler = Euler { roll: 0.0, pitch: 0.0, heading: (12 * k % 360) as f64 * DEG };
    });
    assert!(
        judged(&car).iter().all(|finding| !finding.to_string().contains("0, 0, 0")),
        "{:?}",
        judged(&car)
    );
}

/// A column of rolls that is 0 for half of a minute, in which the vehicle turns farthest: the rest shows that it banks.
#[test]
fn rolls_that_are_lost_in_a_turn_are_found() {
    for rate_hz in [10.0, 4.0, 1.0] {
        let flight = flights::aeroplane_in_wind(rate_hz);
        let length = (30.0 * rate_hz) as usize;
        let samples = &flight.samples;
        let turn = |k: usize| wrap_angle(samples[k + length].euler.heading - samples[k].euler.heading).abs();
        let begin = (0..samples.len() - length).max_by(|a, b| turn(*a).total_cmp(&turn(*b))).unwrap();
        let lost = each(samples, |k, sample| {
            if (begin..begin + length).contains(&k) {
                sample.euler.roll = 0.0;
            }
        });
        let found = judged(&lost);
        let own = found.iter().find(|finding| finding.kind == Kind::AttitudeHeld);
        let own = own.unwrap_or_else(|| panic!("{rate_hz} Hz, {:.0} deg: {found:?}", turn(begin) / DEG));
        assert!(own.level == Level::Doubtful && own.to_string().starts_with("roll stays the same"), "{own}");
    }
}

/// A heading with a constant error, as a wander angle is, in flights of two to four minutes that turn, in the wind.
#[test]
fn constant_errors_of_headings_are_found() {
    for length_s in [120.0, 240.0] {
        for error_deg in [20.0, -40.0] {
            let flight = flights::aeroplane_in_wind(10.0);
            let rows = &flight.samples[..(length_s * 10.0) as usize];
            let found = judged(&each(rows, |_, sample| sample.euler.heading += error_deg * DEG));
            let own = found.iter().find(|finding| finding.kind == Kind::HeadingOffTrack);
            let own = own.unwrap_or_else(|| panic!("{length_s} s {error_deg}: {found:?}"));
            assert_eq!(own.level, Level::Doubtful, "{own}");
            assert!((own.figure / DEG - error_deg).abs() < 3.0, "{length_s} s {error_deg}: {own}");
            assert!(judged(rows).is_empty(), "{:?}", judged(rows));
        }
    }
}

type Change = fn(f64) -> f64;

/// The same of a flight that turns by 22° only: large constant errors, and headings of another unit or sign.
#[test]
fn headings_of_little_turns_are_judged() {
    let pieces = |flight: &Good| [0..6000, 0..2400, 3600..6000].map(|rows| flight.samples[rows].to_vec());
    for rows in flights::aeroplanes_in_little_turns(10.0).iter().flat_map(pieces) {
        assert_eq!(judged(&rows), []);
        let found_of = |change: &dyn Fn(f64) -> f64, kind: Kind| {
            let found = judged(&each(&rows, |_, sample| sample.euler.heading = change(sample.euler.heading)));
            let own = found.iter().find(|finding| finding.kind == kind).cloned();
            own.unwrap_or_else(|| {
                panic!("{} rows at {:?}, {:?}, {kind:?}: {found:?}", rows.len(), rows[0].v_n, change(1.0))
            })
        };
        for error_deg in [40.0, -42.0] {
            let found = found_of(&|heading| heading + error_deg * DEG, Kind::HeadingOffTrack);
            assert_eq!(found.level, Level::Doubtful, "{found}");
            assert!((found.figure / DEG - error_deg).abs() < 13.0, "{error_deg}: {found}");
        }
        let changes: [(&str, Change); 4] = [
            ("opposite sign", |heading| -heading),
            ("degrees taken for radians", |heading| heading / DEG),
            ("radians taken for degrees?", |heading| heading * DEG),
            ("radians taken for degrees, anticlockwise", |heading| (90.0 * DEG - heading) * DEG),
        ];
        for (words, change) in changes {
            let found = found_of(&change, Kind::HeadingUnit);
            assert_eq!(found.level, Level::Unusable, "{found}");
            assert!(found.to_string().contains(words), "{words}: {found}");
        }
    }
}

/// Heights in millimetres or centimetres, without velocities: nothing flies level above the air. An orbit, a free fall and a rocket
/// that goes on are no level flights.
#[test]
fn level_flight_above_the_air_is_doubtful() {
    let above = |samples: &[FlightSample]| {
        judged(samples).into_iter().find(|finding| finding.kind == Kind::HeightAboveAir)
    };
    for name in ["racetrack", "commuter", "patrol"] {
        for rate_hz in [50.0, 10.0, 1.0] {
            let rows = without_velocities(&flights::scene(name, rate_hz).samples);
            assert_eq!(above(&rows), None);
            let highest_m = rows.iter().map(|row| row.place.height_m).fold(0.0, f64::max);
            for height_m in [400e3, 1500e3] {
                let factor = height_m / highest_m;
                let found = above(&each(&rows, |_, sample| sample.place.height_m *= factor));
                let found = found.unwrap_or_else(|| panic!("{name} {rate_hz} Hz {height_m}"));
                assert_eq!(found.level, Level::Doubtful);
                assert!(found.figure >= 100e3, "{found}");
            }
        }
    }
    let still = Euler { roll: 0.0, pitch: 0.0, heading: 0.0 };
    let height_of = |begin_m: f64, up: fn(f64) -> f64| {
        let mut samples = flights::vehicle("", 1.0, |_| (Vector3::new(200.0, 0.0, 0.0), still)).samples;
        for sample in &mut samples {
            sample.place.height_m = begin_m + up(sample.time_s);
        }
        samples.retain(|sample| sample.place.height_m > 0.0);
        without_velocities(&samples)
    };
    assert!(above(&height_of(200e3, |_| 0.0)).is_some());
    assert_eq!(above(&height_of(200e3, |t| (2000.0 - 0.5 * 9.2 * t) * t)), None, "a free fall");
    assert_eq!(above(&height_of(100e3, |t| 0.5 * 10.0 * t * t)), None, "2 g upwards");
    let orbit = flights::vehicle("", 1.0, |_| (Vector3::new(7400.0, 0.0, 0.0), still)).samples;
    let orbit = each(&without_velocities(&orbit), |_, sample| sample.place.height_m = 300e3);
    assert_eq!(above(&orbit), None);
}

/// A roll in radians beside a heading in degrees.
#[test]
fn a_roll_in_radians_is_found() {
    let radians = |samples: &[FlightSample]| each(samples, |_, sample| sample.euler.roll *= DEG);
    let mut unseen = missed(&[Kind::RollSign], Level::Unusable, 10.0, radians);
    unseen.retain(|name| !name.contains("aerobatics"));
    assert_eq!(unseen, NONE);
}

/// Times that count tenths of a second, or run twice or half as fast, and a roll of another size: the roll is not the bank of the turns.
#[test]
fn times_and_rolls_in_another_unit_are_found_by_the_turns() {
    for (time, roll) in [(10.0, 1.0), (2.0, 1.0), (0.5, 1.0), (1.0, 3.0)] {
        let other = |samples: &[FlightSample]| {
            each(&without_velocities(samples), |_, sample| {
                sample.time_s *= time;
                sample.euler.roll *= roll;
            })
        };
        let mut unseen = missed(&[Kind::RollUnexplained], Level::Doubtful, 10.0, other);
        unseen.retain(|name| !name.contains("aerobatics"));
        // Twice as fast, the racetrack would bank by more than 75°.
        let expected = if time == 0.5 { &["racetrack"][..] } else { &[] };
        assert_eq!(unseen, expected, "{time} {roll}");
    }
}

/// Axes of the attitude that are turned: the roll is 90° or 180°, or the pitch 90°, in straight flight.
#[test]
fn attitudes_with_turned_axes_are_found() {
    for (roll, pitch) in [(90.0, 0.0), (180.0, 0.0), (-90.0, 0.0), (0.0, 80.0)] {
        let turned = |samples: &[FlightSample]| {
            each(samples, |_, sample| {
                sample.euler.roll += roll * DEG;
                sample.euler.pitch += pitch * DEG;
            })
        };
        let mut unseen = missed(&[Kind::AttitudeTurned], Level::Doubtful, 10.0, turned);
        unseen.retain(|name| !name.contains("aerobatics"));
        assert_eq!(unseen, NONE, "{roll} {pitch}");
    }
}

/// Latitude and longitude exchanged, or without a sign: heading and roll turn, and the track does not follow.
#[test]
fn mirrored_paths_are_found_by_heading_and_roll() {
    let mirrors: [fn(&mut FlightSample); 3] = [
        |sample| {
            let place = &mut sample.place;
            (place.latitude_rad, place.longitude_rad) = (0.5 * place.longitude_rad, 0.5 * place.latitude_rad);
        },
        |sample| sample.place.latitude_rad *= -1.0,
        |sample| sample.place.longitude_rad *= -1.0,
    ];
    for mirror in mirrors {
        let other = |samples: &[FlightSample]| each(&without_velocities(samples), |_, sample| mirror(sample));
        let mut unseen = missed(&[Kind::HeadingUnit], Level::Unusable, 10.0, other);
        unseen.retain(|name| !name.contains("aerobatics") && name != "airliner_cruise");
        assert_eq!(unseen, NONE);
    }
}

/// A pitch in radians beside a heading in degrees.
#[test]
fn a_pitch_in_radians_is_found() {
    let radians = |samples: &[FlightSample]| each(samples, |_, sample| sample.euler.pitch *= DEG);
    let unseen = missed(&[Kind::PitchSign], Level::Unusable, 10.0, radians);
    assert_eq!(unseen, ["racetrack", "patrol", "airliner_cruise"]);
}

/// White noise of the attitude, with exact velocities: an INS with ideal sensors walks off.
#[test]
fn noise_of_the_attitude_is_found() {
    for rate_hz in [10.0, 50.0] {
        let noisy = |samples: &[FlightSample]| {
            let mut draws = Draws(3);
            each(samples, |_, sample| {
                sample.euler.roll += 0.5 * DEG * draws.normal();
                sample.euler.pitch += 0.5 * DEG * draws.normal();
                sample.euler.heading += 0.5 * DEG * draws.normal();
            })
        };
        assert_eq!(missed(&[Kind::NoisyAttitude], Level::Doubtful, rate_hz, noisy), NONE);
    }
}

/// An attitude in whole degrees. Hundredths of a degree, as recorders have them, are none of it.
#[test]
fn steps_of_the_attitude_are_found() {
    let rounded = |samples: &[FlightSample], step: f64| {
        each(samples, |_, sample| {
            let euler = &mut sample.euler;
            for angle in [&mut euler.roll, &mut euler.pitch, &mut euler.heading] {
                *angle = (*angle / step).round() * step;
            }
        })
    };
    for rate_hz in [10.0, 50.0] {
        let whole = |samples: &[FlightSample]| rounded(samples, DEG);
        assert_eq!(missed(&[Kind::CoarseAttitude], Level::Doubtful, rate_hz, whole), NONE);
        for flight in moving() {
            let samples = flight.at(rate_hz);
            let fine = judged(&rounded(&samples, 0.01 * DEG));
            assert!(
                fine.iter().all(|finding| finding.kind != Kind::CoarseAttitude),
                "{}: {fine:?}",
                flight.name
            );
        }
    }
}

/// Velocities on another clock: the delay is found, to a tenth.
#[test]
fn late_velocities_are_found() {
    for (delay_s, rate_hz) in [(1.0, 4.0), (0.2, 10.0), (-0.5, 10.0), (2.0, 1.0)] {
        let late = |samples: &[FlightSample]| {
            let rows = (delay_s * rate_hz) as i64;
            each(samples, |k, sample| {
                let source = (k as i64 - rows).clamp(0, samples.len() as i64 - 1);
                sample.v_n = samples[source as usize].v_n;
            })
        };
        for flight in moving() {
            let found = judged(&late(&flight.at(rate_hz)));
            let own = found.iter().find(|finding| finding.kind == Kind::VelocityLate);
            println!("{} {delay_s} s: {own:?}", flight.name);
            let own = own.unwrap_or_else(|| panic!("{} {delay_s} s: {found:?}", flight.name));
            assert!((own.figure / delay_s - 1.0).abs() < 0.1, "{} {delay_s} s: {own}", flight.name);
        }
    }
}

/// Stamps that run at half the speed in a climb: both the contradiction and the climb are found, and the largest comes first.
#[test]
fn a_simulator_that_is_twice_as_fast_is_unusable() {
    let slow = |samples: &[FlightSample]| each(samples, |_, sample| sample.time_s *= 0.5);
    let kinds = [Kind::VelocityContradicts, Kind::VelocityUnit];
    assert_eq!(missed(&kinds, Level::Unusable, 8.0, slow), NONE);
}
