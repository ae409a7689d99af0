//! Each field of each struct that comes in from C, set to an invalid number: refused, and the outputs are the same to the bit.

use std::cell::Cell;
use std::collections::BTreeSet;
use std::ptr::{null, null_mut};

use sins::abi::*;

use crate::support;
#[cfg(feature = "identify")]
use crate::support::draws::Draws;

/// A struct as its 8-byte words: the size and flags, then numbers or pairs of integers.
struct Words(Vec<u64>);

impl Words {
    /// All zero, except for size and flags.
    fn new<T>(flags: u32) -> Self {
        let mut words = vec![0; size_of::<T>() / 8];
        words[0] = size_of::<T>() as u64 | u64::from(flags) << 32;
        Self(words)
    }

    fn with(mut self, word: usize, value: f64) -> Self {
        self.0[word] = value.to_bits();
        self
    }

    /// Puts two integers into a word.
    fn with_pair(mut self, word: usize, low: u32, high: u32) -> Self {
        self.0[word] = u64::from(low) | u64::from(high) << 32;
        self
    }

    fn pointer<T>(&self) -> *const T {
        assert_eq!(self.0.len() * 8, size_of::<T>());
        self.0.as_ptr().cast()
    }
}

/// An output struct, all zero.
fn output<T>() -> Words {
    Words::new::<T>(0)
}

/// All that can be read of a simulator, as bits.
fn outputs(sim: *mut sins_sim) -> Vec<u64> {
    let mut all = Vec::new();
    let mut read = |mut words: Words, get: &dyn Fn(*mut u64) -> sins_status| {
        let status = get(words.0.as_mut_ptr());
        all.push(status as u64);
        all.extend(words.0);
    };
    // SAFETY: each buffer has the size of its struct, and says so.
    unsafe {
        read(output::<sins_navigation>(), &|to| sins_get_truth(sim, to.cast()));
        read(output::<sins_navigation>(), &|to| sins_get_navigation(sim, to.cast()));
        read(output::<sins_imu>(), &|to| sins_get_imu(sim, to.cast()));
        read(output::<sins_errors>(), &|to| sins_get_errors(sim, SINS_ERRORS_NAVIGATION, to.cast()));
        read(output::<sins_accuracy>(), &|to| sins_get_accuracy(sim, to.cast()));
        read(output::<sins_options>(), &|to| sins_get_options(sim, to.cast()));
    }
    all
}

/// Asserts that the sentence of the last failure agrees with the error struct.
fn sentence_and_struct_agree(sim: *const sins_sim) {
    let mut info = output::<sins_error_info>();
    let mut text = [0_u8; 512];
    // SAFETY: a struct and a buffer of their sizes; a handle of this test.
    let info = unsafe {
        assert_eq!(sins_last_error_info(sim, info.0.as_mut_ptr().cast()), SINS_OK);
        assert_eq!(sins_last_error(sim, text.as_mut_ptr().cast(), text.len(), null_mut()), SINS_OK);
        *info.pointer::<sins_error_info>()
    };
    let text_of =
        |bytes: &[u8]| std::ffi::CStr::from_bytes_until_nul(bytes).unwrap().to_str().unwrap().to_owned();
    let (sentence, field) = (text_of(&text), text_of(&info.field.map(|byte| byte as u8)));
    let has = |flag: sins_error_info_flags| info.flags & flag != 0;
    assert!(info.status == SINS_ERROR_INVALID_ARGUMENT && !field.is_empty(), "{sentence}");
    let number = |value: f64| match has(SINS_ERROR_INFO_INTEGER) {
        true => format!("{value}"),
        false => sins::Value::Real(value).to_string(),
    };
    let index = if info.index < 0 { String::new() } else { format!("[{}]", info.index) };
    let (place, rest) = sentence.split_once(": ").unwrap();
    if has(SINS_ERROR_INFO_VALUE) {
        let (place, value) = place.split_once(" = ").unwrap();
        let digits: f64 = value.parse().unwrap();
        assert_eq!(place, format!("{field}{index}"), "{sentence}");
        assert!(digits == info.value || digits.is_nan() && info.value.is_nan(), "{sentence}: {}", info.value);
        assert!(!(value.contains(['.', 'e', 'N', 'f']) && has(SINS_ERROR_INFO_INTEGER)), "{sentence}");
    } else {
        assert_eq!(place, format!("{field}{index}"), "{sentence}");
    }
    let limits = match (has(SINS_ERROR_INFO_MINIMUM), has(SINS_ERROR_INFO_MAXIMUM)) {
        (true, true) if info.minimum == info.maximum => number(info.minimum),
        (true, true) => format!("{} to {}", number(info.minimum), number(info.maximum)),
        (true, false) => number(info.minimum),
        (false, true) => number(info.maximum),
        (false, false) => String::new(),
    };
    assert!(rest.contains(&limits), "{sentence}: not {limits}");
    let names_sample = [" (samples[", " (increments["].iter().any(|place| sentence.contains(place));
    assert_eq!(info.sample >= 0, names_sample, "{sentence}");
}

/// The structs that were tried, and the number of bad values that were refused.
#[derive(Default)]
struct Tried {
    structs: BTreeSet<String>,
    refused: usize,
}

impl Tried {
    /// Puts not-a-number, infinity and the largest numbers into each word of `good`, a `T`, except for the first word and the
    /// `free` words, which may hold anything: each is refused, and `read` gives the same. The simulator `remembers` keeps the
    /// reason, or the thread if `remembers` is null.
    fn each_word<T>(
        &mut self,
        good: &Words,
        free: &[usize],
        read: &dyn Fn() -> Vec<u64>,
        remembers: *const sins_sim,
        call: &dyn Fn(*const T) -> sins_status,
    ) {
        let name = std::any::type_name::<T>().rsplit("::").next().unwrap();
        let before = read();
        for word in (1..good.0.len()).filter(|word| !free.contains(word)) {
            for value in [f64::NAN, -f64::NAN, f64::INFINITY, f64::NEG_INFINITY, f64::MAX, f64::MIN] {
                let bad = Words(good.0.clone()).with(word, value);
                assert_eq!(
                    call(bad.pointer()),
                    SINS_ERROR_INVALID_ARGUMENT,
                    "{name}, word {word} = {value}, of {:x?}",
                    good.0
                );
                sentence_and_struct_agree(remembers);
                self.refused += 1;
            }
        }
        assert_eq!(read(), before, "{name}");
        assert_eq!(call(good.pointer()), SINS_OK, "{name}: it was nothing else");
        self.structs.insert(name.to_owned());
    }
}

fn created() -> *mut sins_sim {
    let mut sim = null_mut();
    // SAFETY: a place for the handle; no options.
    assert_eq!(unsafe { sins_create(null(), &mut sim) }, SINS_OK);
    sim
}

/// Words of a sample: time, latitude, longitude, height, velocity, roll, pitch, heading, rate, force, temperature.
fn sample(time_s: f64) -> Words {
    let flags = SINS_SAMPLE_ANGULAR_RATE | SINS_SAMPLE_SPECIFIC_FORCE | SINS_SAMPLE_TEMPERATURE;
    Words::new::<sins_flight_sample>(flags).with(1, time_s).with(2, 0.7).with(16, 9.8)
}

/// Structs that set a simulator up, move it and make it fail.
fn simulators(tried: &mut Tried) {
    let sim = created();
    let read = || outputs(sim);
    // SAFETY: for all calls: the words have the size of the struct, the handles belong to this test.
    unsafe {
        for k in 0..3 {
            assert_eq!(sins_push_sample(sim, sample(f64::from(k)).pointer()), SINS_OK);
            sins_step(sim);
        }
        tried.each_word(&sample(3.0), &[], &read, sim, &|words| sins_push_sample(sim, words));
        let good = Words::new::<sins_correction>(0);
        tried.each_word(&good, &[], &read, sim, &|words| sins_correct(sim, words));
        let good = Words::new::<sins_gyro_params>(0);
        tried.each_word(&good, &[], &read, sim, &|words| sins_set_gyro(sim, words));
        let good = Words::new::<sins_accel_params>(0);
        tried.each_word(&good, &[], &read, sim, &|words| sins_set_accel(sim, words));
        let good = Words::new::<sins_altimeter_params>(0);
        tried.each_word(&good, &[], &read, sim, &|words| sins_set_altimeter(sim, words));
        // Kind, then size, density, interval, duration, probability.
        let failure = |kind: i32| Words::new::<sins_failure>(0).with_pair(1, kind as u32, 0);
        for good in [
            failure(SINS_FAILURE_STUCK),
            failure(SINS_FAILURE_DEAD),
            failure(SINS_FAILURE_BIAS_STEP).with(2, 1e-3),
            failure(SINS_FAILURE_SPIKES).with(2, 1e-3).with(4, 1.0).with(5, 0.1),
            failure(SINS_FAILURE_NOISE).with(3, 1e-3),
            failure(SINS_FAILURE_DROP_OUTS).with(4, 1.0),
            failure(SINS_FAILURE_DROP_OUTS).with(6, 0.5),
            failure(SINS_FAILURE_NONE),
        ] {
            tried.each_word(&good, &[], &read, sim, &|words| {
                sins_set_failure(sim, SINS_SENSOR_GYRO, 1, words)
            });
        }
        tried.each_word(&sample(3.0), &[], &read, sim, &|words| sins_move_truth(sim, words));
        tried.each_word(&sample(3.0), &[], &read, sim, &|words| sins_reposition(sim, words));
        let good = Words::new::<sins_initial_errors>(0);
        tried.each_word(&good, &[], &read, sim, &|words| sins_set_initial_errors(sim, words));
        sins_reset(sim);
        let good = Words::new::<sins_mounting>(0);
        tried.each_word(&good, &[], &read, sim, &|words| sins_set_mounting(sim, words));
        let good = Words::new::<sins_gravity_params>(0);
        tried.each_word(&good, &[], &read, sim, &|words| sins_set_gravity_disturbance(sim, words));
        // The angles of the start are not read.
        let start = Words::new::<sins_navigation>(0).with(2, 0.7).with(11, 1.0);
        tried.each_word(&start, &[8, 9, 10], &read, sim, &|words| sins_start_navigation(sim, words));
        let parts = Words::new::<sins_imu_increment>(0).with(1, 0.01).with_pair(2, 5, 0);
        tried.each_word(&parts, &[], &read, sim, &|words| sins_push_imu(sim, words));
        assert_eq!(sins_destroy(sim), SINS_OK);

        // Seed and run may be anything.
        let made = Cell::new(null_mut());
        let good = Words::new::<sins_options>(0);
        let address = || vec![made.get() as u64];
        tried.each_word(&good, &[6, 7], &address, null(), &|words| sins_create(words, made.as_ptr()));
        assert_eq!(sins_destroy(made.get()), SINS_OK);
    }
}

/// Structs of the start of an embedded flight and of each kind of manoeuvre.
fn flights(tried: &mut Tried) {
    // Latitude, longitude, height, speed.
    let start = |speed_m_s: f64| Words::new::<sins_flight_start>(0).with(1, 0.7).with(4, speed_m_s);
    // Kind and number of sinusoids; duration, ramp, speed, height, heading, bank, turns; channels in pairs; six of amplitude,
    // frequency and phase each.
    let manoeuvre = |kind: i32| Words::new::<sins_manoeuvre>(0).with_pair(1, kind as u32, 0);
    let mut sinusoids =
        manoeuvre(SINS_MANOEUVRE_SINUSOIDS).with_pair(1, SINS_MANOEUVRE_SINUSOIDS as u32, 6).with(2, 60.0);
    for pair in 0..3 {
        sinusoids = sinusoids.with_pair(9 + pair, 2 * pair as u32, 2 * pair as u32 + 1);
    }
    for term in 12..18 {
        sinusoids = sinusoids.with(term, 0.01).with(term + 6, 0.1).with(term + 12, 1.0);
    }
    let good = [
        manoeuvre(SINS_MANOEUVRE_REST).with(2, 60.0),
        manoeuvre(SINS_MANOEUVRE_STRAIGHT).with(2, 60.0),
        manoeuvre(SINS_MANOEUVRE_ACCELERATE).with(2, 60.0).with(4, 20.0),
        manoeuvre(SINS_MANOEUVRE_CLIMB).with(2, 60.0).with(3, 5.0).with(5, 100.0),
        manoeuvre(SINS_MANOEUVRE_TURN).with(3, 5.0).with(6, 1.0).with(7, 0.5),
        manoeuvre(SINS_MANOEUVRE_ROLL).with(2, 60.0).with(8, 1.0),
        manoeuvre(SINS_MANOEUVRE_LOOP).with(2, 60.0).with(3, 5.0).with(8, 1.0),
        manoeuvre(SINS_MANOEUVRE_S_TURN).with(2, 60.0).with(3, 5.0).with(6, 0.3).with(8, 2.0),
        sinusoids,
    ];
    let made = Cell::new(null_mut());
    let address = || vec![made.get() as u64];
    let create = |start: *const sins_flight_start, manoeuvre: *const sins_manoeuvre| {
        // SAFETY: one manoeuvre, and a place for the handle.
        unsafe { sins_flight_create(start, manoeuvre, 1, made.as_ptr()) }
    };
    let destroy = || {
        // SAFETY: the handle belongs to this test.
        assert_eq!(unsafe { sins_flight_destroy(made.replace(null_mut())) }, SINS_OK);
    };
    for (kind, manoeuvre) in good.iter().enumerate() {
        let start = start(if kind == 0 { 0.0 } else { 100.0 });
        tried.each_word(manoeuvre, &[], &address, null(), &|words| create(start.pointer(), words));
        destroy();
    }
    tried.each_word(&start(100.0), &[], &address, null(), &|words| create(words, good[1].pointer()));
    destroy();
}

/// Structs with which options and budgets are requested.
fn questions(tried: &mut Tried) {
    let samples: Vec<u64> = (0..20).flat_map(|k| sample(f64::from(k)).0).collect();
    let (samples, count) = (samples.as_ptr().cast::<sins_flight_sample>(), 20);

    // Duration, position, velocity, attitude, margin.
    let requirement = Words::new::<sins_requirement>(0).with(2, 100.0);
    let (options, cost) = (Cell::new(output::<sins_options>().0), Cell::new(output::<sins_cost>().0));
    let answer = || [&options, &cost].into_iter().flat_map(copied).collect::<Vec<u64>>();
    tried.each_word(&requirement, &[], &answer, null(), &|words| {
        written(&options, |options| {
            // SAFETY: the number of samples is `count`; outputs of their structs' sizes.
            written(&cost, |cost| unsafe {
                sins_recommend(null(), samples, count, words, options.cast(), cost.cast())
            })
        })
    });

    // Runs, position, velocity, attitude.
    let request = Words::new::<sins_budget_request>(0).with_pair(1, 8, 0).with(2, 1.0);
    let (rows, budget) = (Cell::new(output::<sins_budget_row>().0), Cell::new(output::<sins_budget>().0));
    let answer = || [&rows, &budget].into_iter().flat_map(copied).collect::<Vec<u64>>();
    tried.each_word(&request, &[], &answer, null(), &|words| {
        written(&rows, |rows| {
            // SAFETY: as above; only pointers that may be null are null.
            written(&budget, |budget| unsafe {
                sins_error_budget(null(), samples, count, words, rows.cast(), 1, null_mut(), budget.cast())
            })
        })
    });
}

/// Structs of a unit and of its words.
fn units(tried: &mut Tried) {
    let made = Cell::new(null_mut());
    let address = || vec![made.get() as u64];
    // SAFETY: for all calls: the words have the size of the struct, the handle belongs to this test.
    unsafe {
        let good = Words::new::<sins_unit_params>(0);
        tried.each_word(&good, &[], &address, null(), &|words| {
            sins_unit_create(words, SINS_UNIT_OFF, made.as_ptr())
        });
        let mut sim = null_mut();
        assert_eq!(sins_create(null(), &mut sim), SINS_OK);
        let fix = Words::new::<sins_unit_fix>(0);
        tried.each_word(&fix, &[], &address, null(), &|words| sins_unit_push_fix(made.get(), sim, words));
        assert_eq!((sins_destroy(sim), sins_unit_destroy(made.get())), (SINS_OK, SINS_OK));
    }
    let count = Cell::new(0);
    let due = || vec![count.get() as u64];
    let words = |status: *const sins_unit_status, navigation: *const sins_unit_navigation, inputs| {
        // SAFETY: as above; no word is due in a millisecond from 1 ms on.
        unsafe { sins_bus_words(status, navigation, inputs, 0.001, 0.002, null_mut(), 0, count.as_ptr()) }
    };
    // State and mode; annunciators and reasons; validity and minutes; times, latitudes, longitude, heading.
    let status = Words::new::<sins_unit_status>(0);
    let navigation = Words::new::<sins_unit_navigation>(0);
    let inputs =
        Words::new::<sins_bus_inputs>(0).with_pair(1, SINS_BUS_WIND | SINS_BUS_MAGNETIC_VARIATION, 0);
    tried.each_word(&status, &[], &due, null(), &|bad| words(bad, navigation.pointer(), null()));
    tried.each_word(&navigation, &[], &due, null(), &|bad| words(status.pointer(), bad, null()));
    tried.each_word(&inputs, &[], &due, null(), &|bad| words(status.pointer(), navigation.pointer(), bad));
}

/// A path and a record of a minute at rest on the equator, which can be checked.
#[cfg(feature = "identify")]
fn at_rest() -> *mut sins_identify {
    let request =
        sins_identify_request { flags: SINS_IDENTIFY_STATES, prior: SINS_GRADE_TACTICAL, ..support::init() };
    let mut made = null_mut();
    let mut draws = Draws::new(5);
    // SAFETY: the structs have their sizes, and the handle is new.
    unsafe {
        assert_eq!(sins_identify_create(null(), &request, &mut made), SINS_OK);
        for row in 0..600 {
            let time_s = 0.1 * f64::from(row);
            let sample = sins_flight_sample { time_s, ..support::init() };
            assert_eq!(sins_identify_push_samples(made, &sample, 1), SINS_OK);
            let mut noisy = |mean: f64, size: f64| 0.1 * mean + draws.within(-size, size);
            let increment = sins_recorded_increment {
                time_s,
                interval_s: 0.1,
                angle_rad: [noisy(0.0, 1e-6), noisy(7.292e-5, 1e-6), noisy(0.0, 1e-6)],
                velocity_m_s: [noisy(0.0, 1e-4), noisy(0.0, 1e-4), noisy(9.78, 1e-4)],
                ..support::init()
            };
            assert_eq!(sins_identify_push_increments(made, &increment, 1), SINS_OK);
        }
    }
    made
}

/// What is known of real sensors, and the increments that they measured.
#[cfg(feature = "identify")]
fn sensors(tried: &mut Tried) {
    let made = Cell::new(null_mut());
    let address = || vec![made.get() as u64];
    // SAFETY: the functions read `T`s and write a handle.
    unsafe {
        // Grade and axes; axes; shift of the clock.
        let request = Words::new::<sins_identify_request>(SINS_IDENTIFY_SHIFT);
        tried.each_word(&request, &[], &address, null(), &|words| {
            sins_identify_create(null(), words, made.as_ptr())
        });
        let increment = Words::new::<sins_recorded_increment>(0).with(2, 0.01);
        tried.each_word(&increment, &[], &address, null(), &|words| {
            sins_identify_push_increments(made.get(), words, 1)
        });
        assert_eq!(sins_identify_destroy(made.get()), SINS_OK);
        // Twins; errors of the path.
        made.set(at_rest());
        let of_check = Words::new::<sins_identify_check_request>(40);
        tried.each_word(&of_check, &[], &address, null(), &|words| {
            sins_identify_check(made.get(), words, null_mut())
        });
        assert_eq!(sins_identify_destroy(made.get()), SINS_OK);
    }
}

/// Calls `call` with the words as its output.
fn written(words: &Cell<Vec<u64>>, call: impl FnOnce(*mut u64) -> sins_status) -> sins_status {
    let mut inside = words.take();
    let status = call(inside.as_mut_ptr());
    words.set(inside);
    status
}

fn copied(words: &Cell<Vec<u64>>) -> Vec<u64> {
    let inside = words.take();
    words.set(inside.clone());
    inside
}

/// The structs that any function of the header takes.
fn structs_that_come_in() -> BTreeSet<String> {
    let header = support::headers();
    let name = |text: &str| text.split(|c: char| c != '_' && !c.is_alphanumeric()).next().unwrap().to_owned();
    let is_struct = |name: &String| header.contains(&format!("typedef struct {name} {{"));
    header.split("const ").skip(1).map(name).filter(is_struct).collect()
}

/// Errors of a run that are added to statistics may be any numbers: out of the range of the sums they are counted, and change no sum.
#[test]
fn errors_of_a_run_may_be_any_numbers() {
    for word in 1..size_of::<sins_errors>() / 8 - 1 {
        for value in [f64::NAN, f64::INFINITY, -1e300] {
            let errors = Words::new::<sins_errors>(0).with(word, value);
            let mut statistics: sins_statistics = support::init();
            // SAFETY: both structs have their sizes.
            let status = unsafe { sins_statistics_add(&mut statistics, errors.pointer()) };
            assert_eq!((status, statistics.runs, statistics.diverged), (SINS_OK, 1, 0), "{word} {value}");
            // Position, velocity and misalignment are summed.
            let is_summed = (2..5).contains(&word) || (8..14).contains(&word);
            assert_eq!(statistics.out_of_range, u64::from(is_summed), "{word} {value}");
        }
    }
}

#[test]
fn every_field_of_every_struct() {
    let mut tried = Tried::default();
    simulators(&mut tried);
    flights(&mut tried);
    questions(&mut tried);
    units(&mut tried);
    let mut expected = structs_that_come_in();
    #[cfg(feature = "identify")]
    sensors(&mut tried);
    #[cfg(not(feature = "identify"))]
    expected.retain(|name| !name.starts_with("sins_identif") && name != "sins_recorded_increment");
    println!("figure: {} values; the sentence and `sins_last_error_info` agree on each", tried.refused);
    // sins_statistics has integers alone: c/ensemble.c and statistics.rs damage it.
    assert!(expected.remove("sins_statistics"));
    // These are written as a line, with any numbers: interface/scene_records.rs.
    assert!(expected.remove("sins_record") && expected.remove("sins_covariance"));
    assert!(expected.remove("sins_errors")); // below
    assert_eq!(tried.structs, expected);
}
