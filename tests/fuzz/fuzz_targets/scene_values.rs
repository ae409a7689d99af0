//! Any bytes as values for a scene, through the C interface, by libFuzzer. See `src/texts.rs`.
#![no_main]

use std::ffi::CString;
use std::ptr::null_mut;

use libfuzzer_sys::fuzz_target;
use sins::abi::{SINS_OK, sins_scene_create_builtin, sins_scene_destroy};
use sins_fuzz::{parse_scene, set_values, text_of};

fuzz_target!(|bytes: &[u8]| {
    let values: Vec<u8> = bytes.iter().copied().filter(|&byte| byte != 0).collect();
    let values = CString::new(values).expect("no zero byte");
    let mut scene = null_mut();
    // SAFETY: a terminated name, a place for a handle, living handles.
    unsafe {
        assert_eq!(sins_scene_create_builtin(c"aerobatics".as_ptr(), &mut scene), SINS_OK);
        let before = text_of(scene);
        if set_values(scene, &values) == SINS_OK {
            let written = text_of(scene).expect("a scene is written");
            sins_scene_destroy(parse_scene(&written));
        } else {
            assert_eq!(text_of(scene), before, "a rejected change");
        }
        sins_scene_destroy(scene);
    }
});
