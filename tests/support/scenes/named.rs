//! The scenes of the repository.

use std::path::Path;

use sins::scene::{BUILTIN_SCENES, FlightSource, Scene, builtin};

use super::FlownScene;

fn cut(mut scene: Scene, longest_s: f64) -> Scene {
    if let Ok(flown_s) = scene.flown_s() {
        scene.duration_s = Some(flown_s.min(longest_s));
    }
    scene
}

/// The scenes of `c_examples/scenes`, then the built-in ones, each cut to its longest time. The day of a unit is whole.
pub fn named_scenes([example_s, builtin_s]: [f64; 2]) -> Vec<FlownScene> {
    let examples =
        Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().map(|above| above.join("c_examples/scenes"));
    let folder = examples.into_iter().find(|folder| folder.is_dir()).unwrap();
    let mut files: Vec<_> = std::fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    files.sort();
    let mut scenes: Vec<FlownScene> = files.iter().map(|path| example(path, example_s)).collect();
    assert!(scenes.len() > 5);
    scenes.extend(BUILTIN_SCENES.iter().map(|(name, _)| {
        let text = cut(builtin(name).unwrap(), builtin_s).write();
        FlownScene { name: format!("builtin_{name}"), text, log: None }
    }));
    scenes
}

fn example(path: &Path, longest_s: f64) -> FlownScene {
    let name = path.file_stem().unwrap().to_str().unwrap().to_owned();
    let mut scene = Scene::parse(&std::fs::read(path).unwrap()).unwrap();
    let mut log = None;
    if let FlightSource::Log(file) = &mut scene.flight {
        log = Some(std::fs::read_to_string(path.with_file_name(&*file)).unwrap());
        *file = format!("{name}.csv");
    }
    if scene.unit.start.is_none() {
        scene = cut(scene, longest_s);
    }
    FlownScene { text: scene.write(), name, log }
}
