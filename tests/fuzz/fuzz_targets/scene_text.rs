//! Any bytes as the text of a scene, through the C interface, by libFuzzer. See `src/texts.rs`.
#![no_main]

use libfuzzer_sys::fuzz_target;
use sins::abi::sins_scene_destroy;
use sins_fuzz::parse_scene;

fuzz_target!(|bytes: &[u8]| {
    // SAFETY: a living handle.
    unsafe { sins_scene_destroy(parse_scene(bytes)) };
});
