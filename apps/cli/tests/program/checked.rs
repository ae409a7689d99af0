//! `sins scene check`: every fault of a scene with its line, its limit and the reason for the limit.

use std::path::Path;

use crate::support::{folder, rejected};

const FLIGHT: &str = "[flight]\nlatitude_deg = 40\nheight_m = 1000\nspeed_m_s = 200\nrate_hz = 50\n";

/// The faults of a scene, without the name of its file.
fn faults(folder: &Path, text: &str) -> Vec<String> {
    std::fs::write(folder.join("scene.toml"), text).unwrap();
    let errors = rejected(folder, &["scene", "check", "scene.toml"]);
    errors.lines().map(|line| line.strip_prefix("scene.toml:").unwrap().to_owned()).collect()
}

/// All manoeuvres are checked, beside whatever else is wrong, each at the speed with which it begins.
#[test]
fn faults_of_manoeuvres_stand_beside_all_others_with_the_reason_of_their_limit() {
    let folder = folder("manoeuvres");
    let text = [
        FLIGHT,
        "[[manoeuvre]]\nkind = \"accelerate\"\nduration_s = 10\nspeed_change_m_s = -100\n", // 6
        "[[manoeuvre]]\nkind = \"climb\"\nduration_s = 20\nheight_change_m = 5000\n",       // 10
        "[[manoeuvre]]\nkind = \"accelerate\"\nduration_s = 1\nspeed_change_m_s = -300\n",  // 14
        "[[manoeuvre]]\nkind = \"rest\"\nduration_s = 5\n",                                 // 18
        "[[manoeuvre]]\nkind = \"turn\"\nheading_change_deg = 90\nbank_deg = 89.9\n",       // 21
        "[gyro]\nbias_deg_h = 1e99\n",                                                      // 25
    ]
    .concat();
    let expected = [
        "13:1: manoeuvre.height_change_m = 5000: must be from -1350 to 1350: 20 s at 100 m/s, less a ramp of 5 s, with a climb angle below 64 deg",
        "17:1: manoeuvre.speed_change_m_s = -300: must be from -100 to 9900: the speed before it is 100 m/s, and it must stay from 0 to 10000 m/s",
        "24:1: manoeuvre.bank_deg = 89.9: must be from ",
        "26:1: gyro.bias_deg_h[0] = 1e99: must be from ",
    ];
    let found = faults(&folder, &text);
    assert_eq!(found.len(), expected.len(), "{found:#?}");
    for (found, expected) in found.iter().zip(expected) {
        assert!(found.starts_with(expected), "{found}");
    }
    // A manoeuvre that is flown again begins with another speed.
    let again =
        "repeat = 200\n[[manoeuvre]]\nkind = \"accelerate\"\nduration_s = 10\nspeed_change_m_s = 100\n";
    let found = faults(&folder, &[FLIGHT, again].concat());
    let expected = "10:1: manoeuvre.speed_change_m_s = 100: must be from -10000 to 0: the speed before it is 10000 m/s, and it must stay \
        from 0 to 10000 m/s (time 99 of 200)";
    assert_eq!(found, [expected]);
    // The limit is the one that flies.
    let flies = |height_m: f64| {
        let climb =
            format!("[[manoeuvre]]\nkind = \"climb\"\nduration_s = 20\nheight_change_m = {height_m}\n");
        std::fs::write(folder.join("limit.toml"), [FLIGHT, &climb].concat()).unwrap();
        crate::support::run(&folder, &["scene", "check", "limit.toml"]).0 == 0
    };
    assert!(flies(2700.0) && !flies(2701.0));
}

/// What an item of an unknown kind uses and needs is not known, so nothing else is said of it, nor of the speed behind it.
#[test]
fn an_unknown_kind_is_one_fault() {
    let folder = folder("kinds");
    let text = [
        FLIGHT,
        "[[manoeuvre]]\nkind = \"acelerate\"\nduration_s = 10\nspeed_change_m_s = -200\n",
        "[[manoeuvre]]\nkind = \"rest\"\nduration_s = 5\n",
        "[[failure]]\nsensor = \"gyro\"\nkind = \"ded\"\nfrom_s = 1\n",
        "[[failure]]\nsensor = \"giro\"\naxis = \"x\"\nkind = \"dead\"\nfrom_s = 1\n",
        "[[update]]\nkind = \"positon\"\nsigma_m_s = [1, 1, 1]\n",
        "[unit]\nstart = \"off\"\n[[panel]]\nkind = \"nov\"\nheading_deg = 3\n",
    ]
    .concat();
    let found = faults(&folder, &text);
    for (found, begin) in found.iter().zip([
        "7:8: manoeuvre.kind = \"acelerate\"",
        "15:8: failure.kind = \"ded\"",
        "18:10: failure.sensor = \"giro\"",
        "23:8: update.kind = \"positon\"",
        "28:8: panel.kind = \"nov\"",
    ]) {
        assert!(found.starts_with(begin), "{found}");
    }
    assert_eq!(found.len(), 5, "{found:#?}");
}

#[test]
fn a_panel_without_a_unit_is_reported_at_the_panel() {
    let folder = folder("panel");
    let rest = "[[manoeuvre]]\nkind = \"straight\"\nduration_s = 50\n[[panel]]\nkind = \"nav\"\nat_s = 1\n";
    let found = faults(&folder, &[FLIGHT, rest].concat());
    assert_eq!(found, ["9:1: panel: needs a unit: unit.start must be off or nav"]);
}
