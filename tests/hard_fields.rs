//! Each field of each struct that comes in from C, as a number that is none: refused, and the outputs are the same to the bit.

use std::ptr::null_mut;

use sins::abi::*;

/// A struct as the 8-byte words that it is made of: the size and flags, then numbers or pairs of integers.
struct Words(Vec<u64>);

impl Words {
    /// All zero but for size and flags.
    fn new<T>(flags: u32) -> Self {
        let mut words = vec![0; size_of::<T>() / 8];
        words[0] = size_of::<T>() as u64 | u64::from(flags) << 32;
        Self(words)
    }

    fn with(mut self, word: usize, value: f64) -> Self {
        self.0[word] = value.to_bits();
        self
    }

    fn pointer<T>(&self) -> *const T {
        assert_eq!(self.0.len() * 8, size_of::<T>());
        self.0.as_ptr().cast()
    }
}

/// All that can be read of a simulator, as bits.
fn outputs(sim: *mut sins_sim) -> Vec<u64> {
    let mut all = Vec::new();
    let mut read = |size: usize, get: &dyn Fn(*mut u64) -> sins_status| {
        let mut words = vec![0_u64; size / 8];
        words[0] = size as u64;
        let status = get(words.as_mut_ptr());
        all.push(status as u64);
        all.extend(words);
    };
    // SAFETY: each buffer has the size of its struct, and says so.
    unsafe {
        read(size_of::<sins_navigation>(), &|to| sins_get_truth(sim, to.cast()));
        read(size_of::<sins_navigation>(), &|to| sins_get_navigation(sim, to.cast()));
        read(size_of::<sins_imu>(), &|to| sins_get_imu(sim, to.cast()));
        read(size_of::<sins_errors>(), &|to| sins_get_errors(sim, SINS_ERRORS_NAVIGATION, to.cast()));
        read(size_of::<sins_accuracy>(), &|to| sins_get_accuracy(sim, to.cast()));
        read(size_of::<sins_options>(), &|to| sins_get_options(sim, to.cast()));
    }
    all
}

/// Puts no number, infinity and the largest numbers into each word but the first and those `free` to hold anything.
fn each_word_is_checked(
    name: &str,
    good: &Words,
    free: &[usize],
    sim: *mut sins_sim,
    call: &dyn Fn(&Words) -> sins_status,
) {
    let before = outputs(sim);
    let mut refused = 0;
    for word in (1..good.0.len()).filter(|word| !free.contains(word)) {
        for value in [f64::NAN, -f64::NAN, f64::INFINITY, f64::NEG_INFINITY, f64::MAX, f64::MIN] {
            let bad = Words(good.0.clone()).with(word, value);
            assert_eq!(call(&bad), SINS_ERROR_INVALID_ARGUMENT, "{name}, word {word} = {value}");
            refused += 1;
        }
    }
    assert_eq!(outputs(sim), before, "{name}");
    println!("{name}: {refused} bad values refused");
    assert_eq!(call(good), SINS_OK, "{name}: it was nothing else");
}

fn created() -> *mut sins_sim {
    let mut sim = null_mut();
    // SAFETY: a place for the handle; no options.
    assert_eq!(unsafe { sins_create(std::ptr::null(), &mut sim) }, SINS_OK);
    sim
}

/// Words of a sample: time, latitude, longitude, height, velocity, roll, pitch, heading, rate, force, temperature.
fn sample(time_s: f64) -> Words {
    let flags = SINS_SAMPLE_ANGULAR_RATE | SINS_SAMPLE_SPECIFIC_FORCE | SINS_SAMPLE_TEMPERATURE;
    Words::new::<sins_flight_sample>(flags).with(1, time_s).with(2, 0.7).with(16, 9.8)
}

#[test]
fn every_field_of_every_struct() {
    // SAFETY: of all calls: words are as many as the struct has, handles are of this test.
    let push = |sim, words: &Words| unsafe { sins_push_sample(sim, words.pointer()) };
    let sim = created();
    for k in 0..3 {
        assert_eq!(push(sim, &sample(f64::from(k))), SINS_OK);
        // SAFETY: as above.
        unsafe { sins_step(sim) };
    }
    each_word_is_checked("sins_flight_sample", &sample(3.0), &[], sim, &|words| push(sim, words));
    // SAFETY: as above.
    unsafe {
        each_word_is_checked("sins_gyro_params", &Words::new::<sins_gyro_params>(0), &[], sim, &|words| {
            sins_set_gyro(sim, words.pointer())
        });
        each_word_is_checked("sins_accel_params", &Words::new::<sins_accel_params>(0), &[], sim, &|words| {
            sins_set_accel(sim, words.pointer())
        });
        each_word_is_checked(
            "sins_altimeter_params",
            &Words::new::<sins_altimeter_params>(0),
            &[],
            sim,
            &|words| sins_set_altimeter(sim, words.pointer()),
        );
        each_word_is_checked("sins_reposition", &sample(3.0), &[], sim, &|words| {
            sins_reposition(sim, words.pointer())
        });
        each_word_is_checked(
            "sins_initial_errors",
            &Words::new::<sins_initial_errors>(0),
            &[],
            sim,
            &|words| sins_set_initial_errors(sim, words.pointer()),
        );
        sins_reset(sim);
        each_word_is_checked("sins_mounting", &Words::new::<sins_mounting>(0), &[], sim, &|words| {
            sins_set_mounting(sim, words.pointer())
        });
        let gravity = Words::new::<sins_gravity_params>(0);
        each_word_is_checked("sins_gravity_params", &gravity, &[], sim, &|words| {
            sins_set_gravity_disturbance(sim, words.pointer())
        });
        // Its angles are not read.
        let start = Words::new::<sins_navigation>(0).with(2, 0.7).with(11, 1.0);
        let untouched = [8, 9, 10];
        each_word_is_checked("sins_navigation", &start, &untouched, sim, &|words| {
            sins_start_navigation(sim, words.pointer())
        });
        let mut parts = Words::new::<sins_imu_increment>(0).with(1, 0.01);
        parts.0[2] = 5;
        each_word_is_checked("sins_imu_increment", &parts, &[], sim, &|words| {
            sins_push_imu(sim, words.pointer())
        });
        // Seed and run may be anything.
        let other = std::cell::Cell::new(null_mut());
        each_word_is_checked("sins_options", &Words::new::<sins_options>(0), &[6, 7], sim, &|words| {
            let mut made = null_mut();
            let status = sins_create(words.pointer(), &mut made);
            other.set(made);
            status
        });
        assert_eq!(sins_destroy(other.get()), SINS_OK);
        assert_eq!(sins_destroy(sim), SINS_OK);
    }
}
