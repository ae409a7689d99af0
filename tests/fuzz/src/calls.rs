//! The call that a record stands for.

use std::ffi::{CStr, c_char};
use std::ptr::null_mut;

use sins::abi::*;

use crate::call;
use crate::host::{Host, look_at_all};
use crate::settings::some_options;

impl Host {
    pub fn call(&mut self) {
        match self.input.byte() {
            96..112 => {
                let place = self.place();
                self.push(place);
            }
            112..120 => {
                let place = self.place();
                self.step(place);
            }
            120..128 => self.run(),
            128..136 => self.set_gyro(),
            136..144 => self.set_accel(),
            144..148 => self.set_altimeter(),
            148..152 => self.set_initial_errors(),
            152..158 => self.set_failure(),
            158..161 => self.set_mounting(),
            161 => self.correct(),
            162..165 => self.set_gravity(),
            165..168 => self.set_preset(),
            168..172 => {
                let place = self.place();
                self.start_navigating_or_not(place, true);
            }
            172..175 => {
                let place = self.place();
                self.push_imu(place);
            }
            175 => {
                let place = self.place();
                self.reposition(place);
            }
            176 => {
                let place = self.place();
                self.move_truth(place);
            }
            177 => {
                let place = self.place();
                self.move_time(place);
            }
            178 => {
                let place = self.place();
                self.reset(place);
            }
            179..184 => {
                let options = some_options(&mut self.input);
                let mut options = self.input.argument(options);
                let place = self.place();
                self.make(place, &mut options);
            }
            184 => self.destroy(),
            185..193 => self.follow(),
            193..196 => self.thaw(),
            196..198 => self.tamper(),
            198..206 if self.input.one_in(16) => self.forge(),
            206..208 => {
                let place = self.place();
                look_at_all(self.sims[place].handle);
            }
            208 if self.input.one_in(4) => self.create_flight(),
            209..211 => self.board(),
            211 => self.sample_flight(),
            212..214 => self.hear(),
            214 => names(i32::from(self.input.byte() as i8)),
            215 if self.dear_calls > 0 && self.input.one_in(256) => {
                self.dear_calls -= 1;
                if self.input.byte() < 128 { self.recommend() } else { self.budget() }
            }
            216 => self.misuse(),
            // A text takes the time of about a hundred steps.
            217..219 if self.input.one_in(8) => self.make_scene(),
            219..221 if self.input.one_in(8) => self.change_scene(),
            221 if self.input.one_in(8) => {
                if self.input.one_in(2) {
                    self.play_scene()
                } else {
                    self.fly_scene()
                }
            }
            222 if self.input.one_in(8) => self.log(),
            223 if self.input.one_in(8) => self.misuse_scene(),
            224 if self.input.one_in(4) => self.fly_ensemble(),
            225 if self.input.one_in(4) => self.fly_unit(),
            // Most calls fly.
            _ => self.fly(),
        }
        self.watch_follower();
    }

    fn destroy(&mut self) {
        let place = self.place();
        let sim = std::mem::replace(&mut self.sims[place].handle, null_mut());
        self.follower.part(place, sim);
        let expected = if sim.is_null() { SINS_ERROR_BAD_HANDLE } else { SINS_OK };
        assert_eq!(call!(sins_destroy(sim)), expected);
        assert_eq!(call!(sins_step(sim)), SINS_ERROR_BAD_HANDLE);
        // Each place always has a simulator to fly with.
        self.make(place, &mut crate::input::Argument::of(&crate::host::init::<sins_options>()));
    }

    /// Calls with invalid handles.
    fn misuse(&mut self) {
        let sim = std::ptr::without_provenance_mut(self.input.word() as usize);
        let flight = self.flight();
        look_at_all(sim);
        assert_eq!(call!(sins_step(sim)), SINS_ERROR_BAD_HANDLE);
        assert_eq!(call!(sins_reset(flight.cast())), SINS_ERROR_BAD_HANDLE);
        assert_eq!(call!(sins_flight_destroy(self.sims[0].handle.cast())), SINS_ERROR_BAD_HANDLE);
    }

    fn hear(&mut self) {
        let mut text = vec![0x55_u8; self.input.below(256)];
        let mut needed = 0;
        let buffer = if text.is_empty() { null_mut() } else { text.as_mut_ptr().cast::<c_char>() };
        let place = self.place();
        let sim = if self.input.one_in(4) { null_mut() } else { self.sims[place].handle };
        let status = call!(sins_last_error(sim, buffer, text.len(), &mut needed));
        if status == SINS_OK && !text.is_empty() {
            assert!(std::str::from_utf8(&text[..needed - 1]).is_ok() && text[needed - 1] == 0);
        }
        let mut info = crate::host::init::<sins_error_info>();
        assert_eq!(call!(sins_last_error_info(sim, &mut info)), SINS_OK);
    }
}

/// Calls that need no handle.
fn names(status: sins_status) {
    assert_eq!(sins_abi_version(), SINS_HEADER_ABI);
    for text in [sins_version_string(), sins_status_string(status)] {
        // SAFETY: the texts are the library's.
        assert!(unsafe { CStr::from_ptr(text) }.to_str().is_ok_and(|text| !text.is_empty()));
    }
}
