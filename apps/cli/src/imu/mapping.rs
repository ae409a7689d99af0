//! The `[imu]` of a file or of a scene.

use std::path::Path;

use sins::log::LogMapping;
use sins::scene::Scene;

use crate::failure::Failure;
use crate::given::Settings;

/// The `[imu]` of a scene; `None`: it has none.
pub fn of_scene(scene: &Scene) -> Option<&LogMapping> {
    Some(&*scene.imu).filter(|mapping| **mapping != LogMapping::of_imu())
}

/// The `[imu]` of the file of --imu-map, with what `set` (--set) sets of `imu` in addition.
pub fn of_file(path: &Path, set: &[String]) -> Result<LogMapping, Failure> {
    if path == Path::new("-") {
        let what = "expected the name of a file: standard input is a record (--imu -), and no description";
        return Err(Failure::new(format!("--imu-map -: {what}")));
    }
    let of_imu = set.iter().filter(|text| text.trim_start().starts_with("imu.")).cloned();
    let settings = Settings { columns: Some(path.to_owned()), set: of_imu.collect(), ..Settings::default() };
    let scene = settings.mappings()?;
    let what = "expected a section [imu] with the columns of the record, as gyro_x = { col = \"wx\", unit = \"deg/s\" }";
    scene.as_ref().and_then(of_scene).cloned().ok_or_else(|| Failure::of_file(path, &what))
}
