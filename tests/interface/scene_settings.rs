//! Keys that are set in addition to the text of a scene, and values that are read from a scene.

use sins::scene::{Scene, keys};

const TEXT: &str = "\
[flight]
builtin = \"patrol\"
hours = 0.5
[gyro]
preset = \"tactical\"
bias_deg_h = [1, 2, 3]
[options]
subsamples = 9
";

fn set(text: &str, settings: &[(&str, &str)]) -> Result<Scene, Vec<String>> {
    let reported = |faults: Vec<sins::scene::Fault>| faults.iter().map(ToString::to_string).collect();
    Scene::parse_with(text.as_bytes(), settings).map_err(reported)
}

/// A setting has the same effect as the value in the text. It may have any kind, be in SI, be in a section that the text lacks, or
/// replace an invalid value.
#[test]
fn a_setting_is_as_the_text_with_it() {
    let settings = [
        ("options.subsamples", "3"),
        ("options.scheme", "paper"),
        ("gyro.bias_deg_h", "7"),
        ("gyro.bias_deg_h", "[0.1, -2e-3, 0]"),
        ("gyro.scale_factor_sigma", "1e-4"),
        ("altimeter.bias_m", "12"),
        ("options.vertical", "\"damped\""),
        ("output.quiet", "true"),
        ("flight.title", "2026 = a year"),
    ];
    let written = "\
[flight]
builtin = \"patrol\"
hours = 0.5
title = \"2026 = a year\"
[gyro]
preset = \"tactical\"
bias_deg_h = [0.1, -2e-3, 0]
scale_factor_sigma = 1e-4
[options]
subsamples = 3
scheme = \"paper\"
vertical = \"damped\"
[altimeter]
bias_m = 12
[output]
quiet = true
";
    assert_eq!(set(TEXT, &settings), set(written, &[]));
    // A preset is applied first, wherever it is written. The other values of the text stay.
    let consumer = set(TEXT, &[("gyro.preset", "consumer"), ("options.subsamples", "2")]).unwrap();
    let bias = [1.0, 2.0, 3.0].map(|bias: f64| bias * (core::f64::consts::PI / 648_000.0));
    assert_eq!(consumer.errors.gyro.bias.as_slice(), bias);
    assert_eq!(consumer.errors.gyro.random_walk, sins::sensors::Grade::Consumer.parameters().0.random_walk);
}

/// The fault of a setting has line 0 and the number of the setting as its column. A fault of the text has its line. The sentences
/// are the same.
#[test]
fn faults_have_the_number_of_their_setting() {
    let settings = [
        ("gyro.bais_deg_h", "1"),
        ("gyro.bias_deg_h", "1"),
        ("gryo.bias_deg_h", "1"),
        ("failure.size_m", "1"),
        ("seed", "1"),
        ("options.scheme", "exakt"),
        ("accelerometer.scale_factor_ppm", "3e6"),
        ("flight.hours", "1\n[output]\nquiet = true"),
        ("flight.rate_hz", "nan"),
        ("output.name", "a/b"),
        ("gyro.bias_deg_h", "1,5"),
        ("altimeter.bias_m", "1,5e-3"),
    ];
    let faults = set(TEXT, &settings).unwrap_err();
    for (fault, begin) in faults.iter().zip([
        "8:1: options.subsamples = 9: must be from 1 to 5",
        "0:1: no such key: bais_deg_h; did you mean bias_deg_h?",
        "0:3: no such section: gryo; did you mean gyro?",
        "0:4: failure: expected failure[0]",
        "0:5: seed: expected section.key",
        "0:6: options.scheme = \"exakt\": expected exact, paper, polynomial",
        "0:7: accelerometer.scale_factor_ppm[0] = 3000000: must be from -1000000 to 1000000",
        "0:8: flight.hours = ",
        "0:9: flight.rate_hz = ",
        "0:10: output.name: must be a name without a folder",
        "0:11: gyro.bias_deg_h = \"1,5\": expected one number for all axes, or three [deg/h]; decimals follow a point",
        "0:12: altimeter.bias_m = \"1,5e-3\": expected a number [m]; decimals follow a point",
    ]) {
        assert!(fault.starts_with(begin), "{fault}, not {begin}");
    }
    assert_eq!(faults.len(), 12, "{faults:?}");
}

/// Every key of a section in single brackets can be read and set. Setting the value that was read changes nothing.
#[test]
fn every_key_can_be_set_and_read() {
    let scene = set(TEXT, &[("options.subsamples", "2")]).unwrap();
    let text = scene.write();
    let mut count = 0;
    for key in keys().iter().filter(|key| !key.is_list && key.section != "flight" && key.name != "preset") {
        let path = format!("{}.{}", key.section, key.name);
        let value = scene.value(&path).unwrap_or_else(|| panic!("{path}"));
        // A key without a value is not written. A key that needs other keys is rejected without them.
        if value.is_empty() || key.section == "altimeter" || key.name == "closed_loop_time_s" {
            continue;
        }
        let again = set(&text, &[(path.as_str(), value.as_str())]);
        assert_eq!(again.as_ref(), Ok(&scene), "{path} = {value}");
        count += 1;
    }
    assert!(count > 80, "{count}");
    assert_eq!((scene.value("failure.kind"), scene.value("gyro.nothing")), (None, None));
    let set: Vec<String> =
        scene.changed_keys().iter().map(|key| format!("{}.{}", key.section, key.name)).collect();
    assert!(
        set.contains(&"gyro.bias_deg_h".into()) && !set.contains(&"options.subsamples".into()),
        "{set:?}"
    );
}
