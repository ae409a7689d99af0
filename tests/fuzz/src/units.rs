//! Units: a panel in any hands, over a flight; status, outputs and snapshots at any moment.

use std::ptr::null_mut;

use sins::abi::*;

use crate::call;
use crate::host::{Host, init};
use crate::motion::Motion;
use crate::settings::{some_gyro, some_options};
use crate::snapshots::{frozen, sentence};

const SAMPLES: usize = 24;

fn saved(unit: *mut sins_unit) -> Vec<u8> {
    let (mut bytes, mut size) = (vec![0_u8; SINS_UNIT_SNAPSHOT_MAX_SIZE], 0);
    let status = call!(sins_unit_snapshot_save(unit, bytes.as_mut_ptr().cast(), bytes.len(), &mut size));
    assert_eq!(status, SINS_OK);
    bytes.truncate(size);
    bytes
}

/// A unit with its simulator, and at times a twin of both that was loaded from their snapshots.
struct Pair {
    unit: *mut sins_unit,
    sim: *mut sins_sim,
    twin: Option<(*mut sins_unit, *mut sins_sim)>,
}

impl Pair {
    /// Makes a call on both, whose answers must agree.
    fn call(&self, call: impl Fn(*mut sins_unit, *mut sins_sim) -> sins_status) -> sins_status {
        let status = call(self.unit, self.sim);
        if let Some((unit, sim)) = self.twin {
            assert!(call(unit, sim) == status, "another answer from the unit that was loaded");
        }
        status
    }

    fn loaded(&self) -> (*mut sins_unit, *mut sins_sim) {
        let (mut unit, mut sim) = (null_mut(), null_mut());
        assert_eq!(call!(sins_unit_create(std::ptr::null(), SINS_UNIT_OFF, &mut unit)), SINS_OK);
        assert_eq!(call!(sins_create(std::ptr::null(), &mut sim)), SINS_OK);
        let (of_unit, of_sim) = (saved(self.unit), frozen(self.sim));
        let status = call!(sins_unit_snapshot_load(unit, of_unit.as_ptr().cast(), of_unit.len()));
        assert!(status == SINS_OK, "an unaltered snapshot was refused: {}", sentence(null_mut()));
        let status = call!(sins_snapshot_load(sim, of_sim.as_ptr().cast(), of_sim.len()));
        assert!(status == SINS_OK, "an unaltered snapshot was refused: {}", sentence(sim));
        (unit, sim)
    }

    fn compare(&self) {
        if let Some((unit, sim)) = self.twin {
            let is_same = saved(unit) == saved(self.unit) && frozen(sim) == frozen(self.sim);
            assert!(is_same, "the unit that was loaded went on otherwise");
        }
    }

    fn part(&mut self) {
        if let Some((unit, sim)) = self.twin.take() {
            assert_eq!(call!(sins_unit_destroy(unit)), SINS_OK);
            assert_eq!(call!(sins_destroy(sim)), SINS_OK);
        }
    }
}

impl Host {
    /// A unit from its creation to its end.
    pub fn fly_unit(&mut self) {
        let options = some_options(&mut self.input);
        let gyro = some_gyro(&mut self.input);
        let (mut sim, mut unit) = (null_mut(), null_mut());
        if call!(sins_create(&options, &mut sim)) != SINS_OK {
            return;
        }
        call!(sins_set_gyro(sim, &gyro));
        let mut params = init::<sins_unit_params>();
        params.power_up_test_s = self.input.pick(&[0.0, 1e-3, 0.1]);
        params.alignment_s = self.input.pick(&[0.0, 1e-3, 0.5, 1e6]);
        params.coarse_alignment_s = self.input.pick(&[0.0, 1e-3, 1.0]);
        params.erection_s = self.input.pick(&[0.0, 1e-3, 1.0]);
        params.realignment_s = self.input.pick(&[0.0, 1e-3, 1.0]);
        params.fault_s = self.input.pick(&[0.0, 1e-3, f64::NAN]);
        params.battery_s = self.input.pick(&[0.0, 0.1]);
        let mode = i32::from(self.input.byte() % 5) - 1;
        if call!(sins_unit_create(&params, mode, &mut unit)) == SINS_OK {
            self.handle_panel(unit, sim);
            let good = saved(unit);
            let mut other = null_mut();
            assert_eq!(call!(sins_unit_create(std::ptr::null(), SINS_UNIT_OFF, &mut other)), SINS_OK);
            let load =
                |bytes: &[u8]| call!(sins_unit_snapshot_load(other, bytes.as_ptr().cast(), bytes.len()));
            let loaded = load(&good);
            assert!(loaded == SINS_OK, "an unaltered snapshot was refused: {}", sentence(null_mut()));
            assert!(saved(other) == good);
            let mut forged = good;
            let at = 24 + self.input.below(forged.len() - 24);
            forged[at] ^= self.input.byte();
            sins::snapshot::seal(&mut forged, sins::snapshot::SnapshotOf::Unit);
            if load(&forged) == SINS_OK {
                self.handle_panel(other, sim);
            }
            assert_eq!(call!(sins_unit_get_params(unit, &mut params)), SINS_OK);
            assert_eq!(call!(sins_unit_set_params(other, &params)), SINS_OK);
            assert_eq!(call!(sins_unit_destroy(other)), SINS_OK);
            assert_eq!(call!(sins_unit_destroy(unit)), SINS_OK);
        }
        assert_eq!(call!(sins_destroy(sim)), SINS_OK);
        assert_eq!(call!(sins_unit_update(unit, sim)), SINS_ERROR_BAD_HANDLE);
    }

    fn handle_panel(&mut self, unit: *mut sins_unit, sim: *mut sins_sim) {
        let mut options = init();
        call!(sins_get_options(sim, &mut options));
        let mut motion = Motion::new(&mut self.input, &options);
        // At rest most alignments end.
        let rests = self.input.one_in(2);
        let mut pair = Pair { unit, sim, twin: None };
        for _ in 0..SAMPLES {
            let choice = i32::from(self.input.byte() % 6) - 1;
            let sample = motion.sample();
            let place = [sample.latitude_rad, sample.longitude_rad, sample.height_m];
            let numbers = [0.0, 0.7, -1.6, 7.0, 1e300, f64::NAN];
            let any = [self.input.pick(&numbers), self.input.pick(&numbers), self.input.pick(&numbers)];
            let is_true = self.input.byte() < 160;
            let [one, two, three] = if is_true { place } else { any };
            match self.input.byte() % 14 {
                0..3 => pair.call(|unit, _| call!(sins_unit_select(unit, choice))),
                3 => pair.call(|unit, _| call!(sins_unit_set_power(unit, choice))),
                4 => pair.call(|unit, _| call!(sins_unit_set_alignment(unit, choice))),
                5 => pair.call(|unit, _| call!(sins_unit_press_test(unit))),
                6 => pair.call(|unit, _| call!(sins_unit_enter_heading(unit, one))),
                7 => pair.call(|unit, _| call!(sins_unit_set_stored(unit, one, two, three))),
                8..12 => {
                    let velocity_enu_m_s = if is_true { sample.velocity_enu_m_s } else { [two, three, one] };
                    let fix = sins_unit_fix {
                        latitude_rad: one,
                        longitude_rad: two,
                        height_m: three,
                        velocity_enu_m_s,
                        ..init()
                    };
                    pair.call(|unit, sim| call!(sins_unit_push_fix(unit, sim, &fix)))
                }
                _ => pair.call(|unit, _| call!(sins_unit_enter_position(unit, one, two))),
            };
            self.maybe_twin(&mut pair);
            let next = motion.next(&mut self.input);
            let mut sample = next.sample();
            if rests {
                sample = sins_flight_sample { time_s: next.time_s, ..motion.sample() };
                sample.velocity_enu_m_s = [0.0; 3];
                motion.time_s = next.time_s;
            } else {
                motion = next;
            }
            match self.input.byte() {
                0..4 => pair.call(|_, sim| call!(sins_reposition(sim, &sample))),
                4..8 => pair.call(|_, sim| call!(sins_move_truth(sim, &sample))),
                _ => pair.call(|_, sim| call!(sins_push_sample(sim, &sample))),
            };
            self.maybe_twin(&mut pair);
            let stepped = pair.call(|_, sim| call!(sins_step(sim)));
            self.maybe_twin(&mut pair);
            if stepped == SINS_OK && !self.input.one_in(32) {
                pair.call(|unit, sim| call!(sins_unit_update(unit, sim)));
            }
            pair.compare();
            let (mut status, mut shown) = (init::<sins_unit_status>(), init::<sins_unit_navigation>());
            assert_eq!(call!(sins_unit_get_status(unit, &mut status)), SINS_OK);
            assert!((0..=10).contains(&status.state) && status.to_go_s >= 0.0 && status.to_go_s <= 2e6);
            let read = call!(sins_unit_get_navigation(unit, sim, &mut shown));
            if read != SINS_OK {
                // No INS can start at the first sample.
                assert!(matches!(read, SINS_ERROR_SINGULAR | SINS_ERROR_DIVERGED), "{read}");
                assert_eq!(read, call!(sins_get_navigation(sim, &mut init())));
            }
            self.send_words(&status, &shown);
            let angles =
                [shown.roll_rad, shown.pitch_rad, shown.heading_rad, shown.latitude_rad, shown.longitude_rad];
            let vectors = [shown.velocity_enu_m_s, shown.angular_rate_rad_s, shown.specific_force_m_s2];
            assert!(
                angles.iter().chain(vectors.iter().flatten()).all(|number| number.is_finite()),
                "not a number"
            );
        }
        pair.part();
    }

    /// Between any two calls the pair may be saved: the twin that is loaded goes on to the same bits.
    fn maybe_twin(&mut self, pair: &mut Pair) {
        if self.input.one_in(24) {
            pair.part();
            pair.twin = Some(pair.loaded());
        }
    }

    /// All words of a tenth of a second are decoded again; any word may be decoded.
    fn send_words(&mut self, status: &sins_unit_status, shown: &sins_unit_navigation) {
        let mut inputs = init::<sins_bus_inputs>();
        inputs.flags = u32::from(self.input.byte() % 9);
        inputs.source = u32::from(self.input.byte() % 5);
        inputs.axes = i32::from(self.input.byte() % 3);
        inputs.magnetic_variation_rad = self.input.pick(&[0.0, 1.0, f64::NAN]);
        let (mut words, mut count) = ([init::<sins_bus_word>(); 256], 0);
        let (from_s, to_s) =
            (self.input.pick(&[0.0, -3.05, 1e9]), self.input.pick(&[0.1, -2.9, 1e9 + 0.125, f64::NAN]));
        let sent = call!(sins_bus_words(
            status,
            shown,
            &inputs,
            from_s,
            to_s,
            words.as_mut_ptr(),
            words.len(),
            &mut count
        ));
        let mut label = init::<sins_bus_label>();
        if sent == SINS_OK {
            for word in &words[..count] {
                assert_eq!(
                    call!(sins_bus_decode(word.word, inputs.flags & SINS_BUS_REVERSED_LABEL, &mut label)),
                    SINS_OK
                );
                assert!(label.value.is_finite() && label.label == word.label);
                assert_ne!(label.status, SINS_BUS_ILLEGAL_VALUE);
            }
        }
        if call!(sins_bus_decode(self.input.word() as u32, 0, &mut label)) == SINS_OK {
            let is_legal = (label.minimum..=label.maximum).contains(&label.value);
            assert!(if label.status == SINS_BUS_NORMAL {
                is_legal
            } else {
                is_legal || label.value.is_nan()
            });
            assert!(label.status != SINS_BUS_ILLEGAL_VALUE || label.value.is_nan());
        }
        call!(sins_bus_get_label(self.input.below(64), &mut label));
    }
}
