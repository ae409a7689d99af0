//! Calls of the fuzzed host that make, change and fly a scene.

use std::ffi::CString;
use std::ptr::{null, null_mut, without_provenance_mut};

use sins::abi::*;
use sins::scene::BUILTIN_SCENES;

use crate::call;
use crate::host::{Host, init};
use crate::settings::*;
use crate::texts::{
    check_faults, check_log, parse_scene, set_values, some_log, some_scene, some_values, text_of, written,
};

/// Longest flight that is created [s]. A longer one takes long to create; a host reads the duration before.
const LONG_S: f64 = 1e4;

impl Host {
    /// Makes another scene: from a text, built in, or the default.
    pub fn make_scene(&mut self) {
        let mut scene = null_mut();
        match self.input.below(8) {
            0 => assert_eq!(call!(sins_scene_create(&mut scene)), SINS_OK),
            1 => {
                let (name, _) = self.input.pick(BUILTIN_SCENES);
                let name = std::ffi::CString::new(name).unwrap_or_default();
                assert_eq!(call!(sins_scene_create_builtin(name.as_ptr(), &mut scene)), SINS_OK);
                let status = call!(sins_scene_create_builtin(c"none".as_ptr(), &mut scene));
                assert_eq!(status, SINS_ERROR_INVALID_ARGUMENT);
            }
            _ => scene = parse_scene(&some_scene(&mut self.input)),
        }
        let old = std::mem::replace(&mut self.scene, scene);
        let expected = if old.is_null() { SINS_ERROR_BAD_HANDLE } else { SINS_OK };
        assert_eq!(call!(sins_scene_destroy(old)), expected);
    }

    pub fn log(&mut self) {
        check_log(&some_log(&mut self.input));
    }

    /// Changes the scene. A change that fails changes nothing, and a scene that can be written
    /// reads back to the same text.
    fn changing_scene(&mut self, change: impl FnOnce(*mut sins_scene) -> sins_status) {
        let scene = self.scene;
        let before = text_of(scene);
        let status = change(scene);
        let after = text_of(scene);
        assert!(status == SINS_OK || before == after, "a call that failed changed a scene");
        if let Some(after) = after {
            let again = parse_scene(&after);
            let is_same = text_of(again).as_ref() == Some(&after);
            assert!(
                is_same,
                "a scene that was set reads back as another [{}]",
                String::from_utf8_lossy(&after)
            );
            assert_eq!(call!(sins_scene_destroy(again)), SINS_OK);
        }
    }

    pub fn change_scene(&mut self) {
        let input = &mut self.input;
        match input.below(7) {
            0 | 1 => {
                let values = some_values(input);
                self.changing_scene(|scene| set_values(scene, &values));
            }
            2 => self.change_items(),
            3 => self.change_manoeuvres(),
            4 => self.change_text(),
            5 => self.give_log_file(),
            _ => self.read_failures(),
        }
    }

    /// Sets the items of a list in another order: some items twice, some removed, some new.
    fn change_items(&mut self) {
        let list = self.input.pick(&["manoeuvre", "failure", "update", "gyro"]);
        let mut items = String::new();
        for _ in 0..self.input.below(5) {
            let path = CString::new(format!("{list}[{}]", self.input.below(4))).unwrap_or_default();
            let scene = self.scene;
            let item = written(|buffer, capacity, needed| {
                call!(sins_scene_get_value(scene, path.as_ptr(), buffer, capacity, needed))
            });
            let other = self.input.pick(&[
                "",
                "[[manoeuvre]]\nkind = \"rest\"\nduration_s = 9\n",
                "[[update]]\nkind = \"position\"\nat_s = 0.01\nevery_s = 0.05\nsigma_m = 30\n",
                "[output]\nquiet = true\n",
            ]);
            items
                .push_str(&item.map_or(other.to_owned(), |item| String::from_utf8_lossy(&item).into_owned()));
        }
        let list = CString::new(list).unwrap_or_default();
        let items = CString::new(items).unwrap_or_default();
        self.changing_scene(|scene| call!(sins_scene_set_items(scene, list.as_ptr(), items.as_ptr())));
        check_faults(self.scene);
    }

    /// Reads a log whose roll stands in another file, and gives this file, or one that no `[log]` names.
    fn give_log_file(&mut self) {
        let values = c"log.roll = { col = \"r\", file = \"r.csv\" }";
        if self.input.one_in(2) {
            self.changing_scene(|scene| call!(sins_scene_set_values(scene, values.as_ptr())));
        }
        let scene = self.scene;
        let mut names = Vec::new();
        while let Some(name) = written(|buffer, capacity, needed| {
            call!(sins_scene_log_file_name(scene, names.len(), buffer, capacity, needed))
        }) {
            names.push(name);
        }
        let given = self.input.pick(&[c"r.csv", c"other.csv", c""]);
        let text =
            self.input.pick(&["time_s,r,pitch_deg,heading_deg\n0,1,0,0\n1,2,0,0\n", "time_s,r\n0,x\n", ""]);
        let status = call!(sins_scene_give_log_file(scene, given.as_ptr(), text.as_ptr().cast(), text.len()));
        let is_named = names.iter().any(|name| name == given.to_bytes());
        assert_eq!(status == SINS_OK, is_named, "{given:?}");
        let (log, mut made) =
            ("time_s,latitude_deg,longitude_deg,height_m\n0,48,11,0\n1,48,11,0\n", null_mut());
        call!(sins_log_parse(log.as_ptr().cast(), log.len(), scene, &mut made, &mut init()));
        assert!(made.is_null() || call!(sins_log_destroy(made)) == SINS_OK);
    }

    fn change_manoeuvres(&mut self) {
        let start = sins_flight_start {
            latitude_rad: self.input.pick(&[0.7, 1.57, -1.2]),
            speed_m_s: self.input.pick(&[200.0, 0.0, 8000.0]),
            ..init()
        };
        let (start, manoeuvre) = (self.input.argument(start), some_manoeuvre(&mut self.input));
        let (mut start, mut manoeuvre) = (start, self.input.argument(manoeuvre));
        let repeat = self.input.pick(&[1, 1, 2, 4096, 4097, 0]);
        let (from, list) = (start.pointer(), manoeuvre.pointer());
        self.changing_scene(|scene| call!(sins_scene_set_manoeuvres(scene, from, list, 1, repeat)));
        let (scene, mut count, mut again) = (self.scene, 0, 0);
        let status =
            call!(sins_scene_get_manoeuvres(scene, null_mut(), null_mut(), 0, &mut count, &mut again));
        if status != SINS_OK || count == 0 {
            return;
        }
        let mut start = init::<sins_flight_start>();
        let mut list = vec![init::<sins_manoeuvre>(); count];
        let places = list.as_mut_ptr();
        let status =
            call!(sins_scene_get_manoeuvres(scene, &mut start, places, count, &mut count, &mut again));
        assert_eq!(status, SINS_OK);
        // Manoeuvres that were read are accepted and give the same flight.
        let before = text_of(scene);
        let status = call!(sins_scene_set_manoeuvres(scene, &start, places, count, again));
        assert_eq!(status, SINS_OK, "manoeuvres that were read are refused");
        let is_builtin = before.as_ref().is_some_and(|text| text.windows(7).any(|part| part == b"builtin"));
        assert!(is_builtin || text_of(scene) == before, "manoeuvres that were read are others");
    }

    fn change_text(&mut self) {
        let which = self.input.below(8) as i32;
        let text = self.input.pick(&[c"", c"patrol", c"a \"b\" \\ c", c"../x.csv", c"\xff", c"a\nb"]);
        self.changing_scene(|scene| call!(sins_scene_set_text(scene, which, text.as_ptr())));
        let scene = self.scene;
        written(|buffer, capacity, needed| {
            call!(sins_scene_get_text(scene, which, buffer, capacity, needed))
        });
    }

    fn read_failures(&self) {
        call!(sins_scene_get_options(self.scene, &mut init()));
        let mut count = 0;
        if call!(sins_scene_get_failure_count(self.scene, &mut count)) == SINS_OK {
            for index in 0..=count {
                let status = call!(sins_scene_get_failure(self.scene, index, &mut init()));
                assert_eq!(status == SINS_OK, index < count);
            }
        }
    }

    /// Flies the scene for some samples.
    pub fn fly_scene(&mut self) {
        let (mut sim, mut flight, mut setup) = (null_mut(), null_mut(), init::<sins_scene_setup>());
        if call!(sins_scene_get_setup(self.scene, &mut setup)) != SINS_OK
            || call!(sins_scene_create_simulator(self.scene, &mut sim)) != SINS_OK
        {
            return;
        }
        let mut samples = init::<sins_scene_samples>();
        if call!(sins_scene_get_samples(self.scene, null(), &mut samples)) == SINS_OK {
            assert!(samples.count >= 1 && samples.record_every >= 1 && samples.duration_s >= 0.0);
        }
        let mut unit = null_mut();
        call!(sins_scene_create_unit(self.scene, &mut unit));
        if setup.flown_s <= LONG_S && call!(sins_scene_create_flight(self.scene, &mut flight)) == SINS_OK {
            for k in 0..self.input.below(16) {
                let mut sample = init();
                let time_s = k as f64 / setup.rate_hz;
                if call!(sins_flight_sample_at(flight, time_s, &mut sample)) != SINS_OK {
                    break;
                }
                let status = call!(sins_scene_prepare(self.scene, sim, 0.0, &mut sample));
                if status != SINS_OK || call!(sins_push_sample(sim, &sample)) < 0 {
                    break;
                }
                call!(sins_step(sim));
                call!(sins_scene_update_unit(self.scene, unit, sim, 0.0));
            }
            assert_eq!(call!(sins_flight_destroy(flight)), SINS_OK);
        }
        assert!(unit.is_null() || call!(sins_unit_destroy(unit)) == SINS_OK);
        assert_eq!(call!(sins_destroy(sim)), SINS_OK);
    }

    /// Flies the scene as a whole for some samples, and goes on from a snapshot.
    pub fn play_scene(&mut self) {
        let (mut play, mut setup) = (null_mut(), init::<sins_scene_setup>());
        if call!(sins_scene_get_setup(self.scene, &mut setup)) != SINS_OK
            || setup.flown_s > LONG_S
            || call!(sins_play_create(self.scene, null(), &mut play)) != SINS_OK
        {
            return;
        }
        let (mut sim, mut unit) = (null_mut(), null_mut());
        assert_eq!(call!(sins_play_get_simulator(play, &mut sim)), SINS_OK);
        call!(sins_play_get_unit(play, &mut unit));
        for _ in 0..self.input.below(16) {
            if self.input.one_in(3) {
                let sample = self.sims[0].motion.sample();
                call!(sins_play_push(play, &sample));
            }
            if call!(sins_play_next(play)) < 0 {
                break;
            }
            call!(sins_play_get_shown(play, &mut init(), &mut init()));
            if self.input.one_in(4) {
                assert_eq!(call!(sins_play_set_plan(play, self.scene)), SINS_OK);
            }
        }
        let (mut bytes, mut size) = (vec![0_u8; SINS_PLAY_SNAPSHOT_MAX_SIZE], 0);
        let status = call!(sins_play_snapshot_save(play, bytes.as_mut_ptr().cast(), bytes.len(), &mut size));
        assert_eq!(status, SINS_OK);
        assert_eq!(call!(sins_play_snapshot_load(play, bytes.as_ptr().cast(), size)), SINS_OK);
        let (mut records, mut written) = ([init::<sins_record>(); 2], 0);
        if setup.flown_s * setup.rate_hz < 1e4 {
            call!(sins_play_run_imu(play, &mut init::<sins_imu>(), 1, &mut written));
            call!(sins_play_run(play, records.as_mut_ptr(), 2, &mut written));
        }
        assert_eq!(call!(sins_play_destroy(play)), SINS_OK);
        assert_eq!(call!(sins_destroy(sim)), SINS_ERROR_BAD_HANDLE);
    }

    /// Calls with invalid handles, and calls that need no handle.
    pub fn misuse_scene(&mut self) {
        let scene = without_provenance_mut(self.input.word() as usize);
        assert_eq!(call!(sins_scene_set_values(scene, c"".as_ptr())), SINS_ERROR_BAD_HANDLE);
        assert_eq!(call!(sins_scene_destroy(self.sims[0].handle.cast())), SINS_ERROR_BAD_HANDLE);
        assert_eq!(call!(sins_log_destroy(self.scene.cast())), SINS_ERROR_BAD_HANDLE);
        assert_eq!(call!(sins_scene_parse(null(), 1, &mut null_mut())), SINS_ERROR_NULL_POINTER);
        let index = self.input.below(16);
        let name = written(|buffer, capacity, needed| {
            call!(sins_scene_builtin_name(index, buffer, capacity, needed))
        });
        assert_eq!(name.is_some(), index < BUILTIN_SCENES.len());
        written(|buffer, capacity, needed| call!(sins_scene_write_keys(buffer, capacity, needed)));
        let (index, mut key) = (self.input.byte(), init::<sins_scene_key>());
        let status = call!(sins_scene_get_key(usize::from(index), &mut key));
        assert!(status == SINS_OK || status == SINS_ERROR_INVALID_ARGUMENT);
    }
}
