//! Scenes from a file, in the C harness: what they are refused for, and that no text does harm.

#[path = "support/c_side.rs"]
mod c_side;
#[path = "support/scenes.rs"]
mod scenes;
#[path = "scene_faults/spoiled.rs"]
mod spoiled;

use std::fmt::Write as _;

use scenes::{folder, run};

/// A flight to be flown with what a case sets.
const REST: &str = "[flight]\nbuiltin = \"rest\"\n";

#[test]
fn every_fault_is_told_with_its_line() {
    let folder = folder("faults");
    let sinusoid = "[[manoeuvre]]\nkind = 'sinusoids'\nduration_s = 9\n[[manoeuvre.sinusoid]]\n";
    let long_line = format!("# {}\n", "x".repeat(5000));
    let long_name = format!("{} = 1\n", "x".repeat(64));
    let huge = "# x\n".repeat(300_000);
    let many = "[[manoeuvre]]\nkind = 'rest'\n".repeat(1025);
    for (text, expected) in [
        // Names.
        ("[gyro]\nbais_deg_h = 1", ":2: gyro.bais_deg_h: unknown key; did you mean bias_deg_h?"),
        ("[gyro]\nbias_rad_s = 1", ":2: gyro.bias_rad_s: unknown key; did you mean bias_deg_h?"),
        (
            "[accelerometer]\nlever_arm_m = [1]",
            ":2: accelerometer.lever_arm_m: unknown key; did you mean mounting.lever_arm_m?",
        ),
        (
            "[accelerometer]\nlever_arm_cm = [1]",
            ":2: accelerometer.lever_arm_cm: unknown key; did you mean lever_arm_mm?",
        ),
        ("[gyro]\nlag_s = 1", ":2: gyro.lag_s: unknown key; did you mean altimeter.lag_s?"),
        ("[giro]\nbias_deg_h = 1", ":1: [giro]: unknown section; did you mean [gyro]?"),
        ("[[manoevre]]\n", ":1: [manoevre]: unknown section; did you mean [[manoeuvre]]?"),
        ("bias = 1\n", ":1: bias: expected a [section] before it"),
        ("[manoeuvre]\n", ":1: [manoeuvre]: expected [[manoeuvre]]"),
        ("[[gyro]]\n", ":1: [[gyro]]: expected [gyro]"),
        // Twice.
        ("[gyro]\nbias_deg_h = 1\n\nbias_deg_h = 1", ":4: gyro.bias_deg_h: stands already in line 2"),
        ("[gyro]\n[start]\n[gyro]", ":3: [gyro]: stands already in line 1"),
        // Types.
        (
            "[gyro]\nbias_deg_h = '1'",
            ":2: gyro.bias_deg_h = \"1\": expected one number for all axes, or three",
        ),
        (
            "[gyro]\nbias_deg_h = [1, 2]",
            ":2: gyro.bias_deg_h = an array of 2: expected one number for all axes, or three",
        ),
        ("[gyro]\nbias_deg_h = []", ":2: gyro.bias_deg_h = an array of 0: expected one number"),
        (
            "[gyro]\nmisalignment_arcsec = [1, 2, 3]",
            ":2: gyro.misalignment_arcsec = an array of 3: expected one number for all elements off the diagonal, or nine",
        ),
        ("[altimeter]\nbias_m = true", ":2: altimeter.bias_m = true: expected a number"),
        ("[options]\nseed = -1", ":2: options.seed = -1: expected a whole number"),
        ("[options]\nsubsamples = 2.0", ":2: options.subsamples = 2: expected a whole number"),
        (
            "[options]\nscheme = 'exakt\\u001b'",
            ":2: options.scheme = \"exakt\\u001b\": expected exact|paper|polynomial",
        ),
        (
            "[options]\nscheme = \"exakt\\u001b\"",
            ":2: options.scheme = \"exakt?\": expected exact|paper|polynomial",
        ),
        ("[output]\nquiet = 1", ":2: output.quiet = 1: expected true or false"),
        ("[output]\nfolder = ''", ":2: output.folder = \"\": expected DIR"),
        (
            "[flight]\nhours = 0\nbuiltin = 'rest'",
            ":2: flight.hours = 0: expected a number, from 1e-05 to 100000 [h]",
        ),
        // What is no TOML, and what of it is not taken.
        ("[gyro\n", ":1: expected ] behind the name"),
        ("[[manoeuvre]\n", ":1: expected ]] behind the name"),
        ("[gyro] x\n", ":1: expected the end of the line"),
        ("[gyro]\nbias_deg_h\n", ":2: expected = behind the name"),
        ("[gyro]\nbias_deg_h =\n", ":2: expected a value"),
        ("[gyro]\n= 1\n", ":2: expected a [section] or a name = value"),
        ("[gyro]\nbias_deg_h = [1,\n 2,\n x]", ":4: expected a value"),
        ("[gyro]\n\"bias_deg_h\" = 1", ":2: names in quotes are not accepted"),
        ("gyro.bias_deg_h = 1", ":1: names with dots are not accepted before =; begin a [section]"),
        ("[gyro]\nbias_deg_h = { x = 1 }", ":2: tables in braces are not accepted"),
        ("[output]\nname = \"\"\"a\"\"\"", ":2: strings over several lines are not accepted"),
        ("[output]\nname = 'a", ":2: a string without its closing quote"),
        ("[output]\nname = \"\\d\"", ":2: \\ with no escape"),
        ("[gyro]\nbias_deg_h = inf", ":2: inf and nan are not accepted"),
        ("[gyro]\nbias_deg_h = 0x10", ":2: hexadecimal, octal and binary numbers are not accepted"),
        ("[gyro]\nbias_deg_h = 1.", ":2: not a number as TOML writes it"),
        ("[gyro]\nbias_deg_h = 1979-05-27", ":2: dates and times are not accepted"),
        ("[gyro]\nbias_deg_h = 99999999999999999999", ":2: a whole number beyond 64 bits"),
        ("[gyro]\nbias_deg_h = [[1, 2, 3]]", ":2: arrays in arrays are not accepted"),
        ("[gyro]\nbias_deg_h = [1,1,1,1,1,1,1,1,1,1]", ":2: an array of more than 9 numbers"),
        (&long_name, ":1: a name of more than 63 characters"),
        (&long_line, ":1: a line of more than 4096 bytes"),
        (&huge, ":1: the text is longer than 1 MiB"),
        ("# a\n\0", ":2: a zero byte; expected text"),
        ("# a\rb", ":1: a carriage return without a line feed"),
        ("# \u{7f}", ":1: a control character; expected text"),
        // The library's sentence, at the key that sets the field.
        (
            "[gyro]\n\nbias_deg_h = [0, 1e9, 0]",
            ":3: gyro.bias_deg_h: gyro.bias_rad_s[1] = 4848.13681109536: must be from -100 to 100",
        ),
        (
            "[accelerometer]\npreset = 'tactical'\nscale_factor_ppm = 2e6",
            ":3: accelerometer.scale_factor_ppm: accel.scale_factor[0] = 2: must be from -1 to 1",
        ),
        (
            "[gyro]\nmisalignment_arcsec = [\n1,1,1,1,1,1,1,1,1]",
            ":2: gyro.misalignment_arcsec: gyro.misalignment_rad[0]",
        ),
        (
            "#\n[gyro]\nmarkov_sigma_deg_h = 1",
            ":2: gyro.markov_time_s: gyro.markov_time_s[0] = 0: must be from 1e-9 to 1e15 where gyro.markov_sigma_rad_s is not 0",
        ),
        (
            "[options]\nvertical = 'damped'\n[altimeter]\nlag_s = 1e7",
            ":4: altimeter.lag_s: altimeter.lag_s = 1e7: must be from 0 to",
        ),
        (
            "[options]\nseed = 1\nsubsamples = 9",
            ":3: options.subsamples: options.subsamples = 9: must be from 0 to 5",
        ),
        (
            "[options]\nclosed_loop_time_s = 9",
            ":2: options.closed_loop_time_s: options.closed_loop_time_s = 9: must be 0 without",
        ),
        (
            "[start]\nposition_sigma_m = -1",
            ":2: start.position_sigma_m: initial.position_sigma_enu_m[0] = -1: must be from 0",
        ),
        (
            "[mounting]\n\nlever_arm_m = [0, 0, 101]",
            ":3: mounting.lever_arm_m: mounting.lever_arm_m[2] = 101: must be from -100 to 100",
        ),
        (
            "[mounting]\nboresight_error_arcsec = [0, 648001, 0]",
            ":2: mounting.boresight_error_arcsec: mounting.boresight_error_rad[1] = 3.14159",
        ),
        ("[mounting]\nlever_arm_m = 1", ":2: mounting.lever_arm_m = 1: expected three numbers"),
        (
            "[gravity]\nanomaly_mgal = 10001",
            ":2: gravity.anomaly_mgal: gravity.anomaly_m_s2 = 0.10001: must be from -0.1 to 0.1",
        ),
        (
            "[gravity]\ndeflection_east_sigma_arcsec = 5",
            ":1: gravity.deflection_east_distance_km: gravity.deflection_east_distance_m = 0: must be from 1 to 1e9",
        ),
        // What does not go together.
        (
            "[altimeter]\nbias_m = 1",
            ":2: altimeter.bias_m: altimeter errors act with the vertical channel damped alone",
        ),
        (
            "[flight]\nbuiltin = 'rest'\ntemperature_change_c_h = 1",
            ":3: flight.temperature_change_c_h: only with temperature_c",
        ),
        (
            "[flight]\nbuiltin = 'rest'\ntemperature_c = -274",
            ":3: flight.temperature_c = -274: expected a number, from -273.15 to 1000 [deg C]",
        ),
        ("[output]\nname = 'a/b'", ":2: output.name: \"a/b\" has a folder"),
        ("[options]\nsample_period_s = 0.01", ":2: options.sample_period_s: only for a log"),
        (
            "[[manoeuvre]]\nkind = 'rest'\nduration_s = 9",
            ": [flight]: expected one alone of file, builtin or [[manoeuvre]]s",
        ),
    ] {
        let text = if text.contains("builtin") { text.to_owned() } else { format!("{text}\n{REST}") };
        std::fs::write(folder.join("bad.toml"), text).unwrap();
        let (code, errors) = run(&folder, &["bad.toml"]);
        assert!(
            code == 2 && errors.starts_with("bad.toml:") && errors.contains(expected),
            "{expected}\n{errors}"
        );
    }
    let dead = "[[failure]]\nsensor = 'gyro'\naxis = 'x'\nkind = 'dead'\n";
    let step = dead.replace("dead", "bias_step");
    let crowd = (0..65).map(|i| format!("{dead}from_s = {i}\nuntil_s = {}\n", i + 1)).collect::<String>();
    for (text, expected) in [
        ("", "bad.toml: [flight]: expected a flight: file, builtin or [[manoeuvre]]s"),
        (
            "[gyro]\n\n[flight]\nhours = 1",
            "bad.toml:3: [flight]: expected a flight: file, builtin or [[manoeuvre]]s",
        ),
        ("[flight]\n\nfile = 'none.csv'", "bad.toml:3: flight.file: none.csv: No such file"),
        ("[flight]\nfile = '../none/none.csv'", "bad.toml:2: flight.file: ../none/none.csv: No such file"),
        ("[flight]\nbuiltin = 'nowhere'", "bad.toml:2: flight.builtin: nowhere: no such flight"),
        ("[flight]\nbuiltin = 'aerobatics'\nhours = 9", "bad.toml:3: flight.hours: 9: the flight lasts 0."),
        (
            "[flight]\nbuiltin = 'rest'\n[output]\nevery_s = 0.001",
            "bad.toml:4: output.every_s: 0.001: expected at least the sample interval",
        ),
        ("[flight]\nbuiltin = 'rest'\nheight_m = 5", "bad.toml:3: flight.height_m: only for [[manoeuvre]]s"),
        (
            "[flight]\nfile = 'a.csv'\nrate_hz = 5",
            "bad.toml:3: flight.rate_hz: a flight log has its own time stamps",
        ),
        ("[[manoeuvre]]\nduration_s = 9", "bad.toml:1: [[manoeuvre]]: expected its kind"),
        (&many, "bad.toml:2049: [[manoeuvre]]: more than 1024"),
        (
            "[[manoeuvre.sinusoid]]\nchannel = 'roll'",
            "bad.toml:1: [[manoeuvre.sinusoid]]: expected right behind its [[manoeuvre]]",
        ),
        (sinusoid, "bad.toml:4: [[manoeuvre.sinusoid]]: expected its channel"),
        (
            &format!("{sinusoid}channel = 'roll'\namplitude_m_s = 1"),
            "bad.toml:6: manoeuvre.sinusoid.amplitude_m_s: not of this channel; expected amplitude_deg",
        ),
        (
            &format!("{sinusoid}channel = 'speed'\namplitude_deg = 1"),
            "bad.toml:6: manoeuvre.sinusoid.amplitude_deg: not of this channel; expected amplitude_m_s",
        ),
        (
            &format!("{sinusoid}channel = 'roll'{}", "\n[[manoeuvre.sinusoid]]\nchannel = 'roll'".repeat(6)),
            "bad.toml:16: [[manoeuvre.sinusoid]]: more than 6",
        ),
        ("[[failure]]\naxis = 'x'", "bad.toml:1: [[failure]]: expected its sensor"),
        ("[[failure]]\nsensor = 'gyro'", "bad.toml:1: [[failure]]: expected its kind"),
        ("[[failure]]\nsensor = 'gyro'\nkind = 'dead'", "bad.toml:1: [[failure]]: expected its axis"),
        (
            "[[failure]]\nsensor = 'altimeter'\naxis = 'x'\nkind = 'dead'",
            "bad.toml:3: failure.axis: the altimeter has one output alone",
        ),
        (
            &format!("{dead}from_s = 5\nuntil_s = 5"),
            "bad.toml:6: failure.until_s: 5: expected more than from_s, 5",
        ),
        (
            &format!("{dead}from_s = -1"),
            "bad.toml:5: failure.from_s = -1: expected a number, from 0 to 1e+09 [s]",
        ),
        (
            &format!("{step}size_micro_g = 5"),
            "bad.toml:5: failure.size_micro_g: not of this sensor; expected size_deg_h",
        ),
        (
            &format!("{step}size_deg_h = 5\ndensity_m_sqrt_hz = 5"),
            "bad.toml:6: failure.density_m_sqrt_hz: not of this sensor; expected density_deg_sqrt_h",
        ),
        // The library's sentence: at the key, or where the failure begins.
        (
            &format!("{step}#\nsize_deg_h = 1e9"),
            "bad.toml:6: failure.size_deg_h: failure.size = 4848.13681109536: must be from -100 to 100",
        ),
        (
            &format!("{dead}probability = 1"),
            "bad.toml:5: failure.probability: failure.probability = 1: must be 0",
        ),
        (
            "\n[[failure]]\nsensor = 'gyro'\naxis = 'x'\nkind = 'spikes'\nsize_deg_h = 1",
            "bad.toml:2: failure.interval_s: failure.interval_s = 0: must be from 0.0001 to 1e9",
        ),
        (
            &format!("{dead}until_s = 9\n{dead}from_s = 8.5"),
            "bad.toml:6: [[failure]]: overlaps in time with that of line 1, of the same output",
        ),
        (
            "[flight]\nbuiltin = 'rest'\n[[failure]]\nsensor = 'altimeter'\nkind = 'dead'",
            "bad.toml:3: [[failure]]: the altimeter acts with the vertical channel damped alone",
        ),
        (&crowd, "bad.toml:385: [[failure]]: more than 64"),
        // The second manoeuvre is at fault: its key, or where it begins.
        (
            "[[manoeuvre]]\nkind = 'rest'\nduration_s = 9\n[[manoeuvre]]\nkind = 'rest'\n#\nbank_deg = 9\nduration_s = 1",
            "bad.toml:7: manoeuvre.bank_deg: manoeuvre.bank_rad[1] = ",
        ),
        (
            "[[manoeuvre]]\nkind = 'rest'\nduration_s = 9\n[[manoeuvre]]\nkind = 'turn'\nheading_change_deg = 9\nbank_deg = 9",
            "bad.toml:4: manoeuvre: speed_m_s[1] = 0: must be greater than 0",
        ),
        (
            "[[manoeuvre]]\nkind = 'sinusoids'\nduration_s = 9",
            "bad.toml:1: manoeuvre: manoeuvre.sinusoid_count[0] = 0: must be from 1 to 6",
        ),
        (
            "[flight]\nlatitude_deg = 91\n[[manoeuvre]]\nkind = 'rest'\nduration_s = 9",
            "bad.toml:2: flight.latitude_deg: start.latitude_rad = ",
        ),
    ] {
        std::fs::write(folder.join("bad.toml"), text).unwrap();
        let (code, errors) = run(&folder, &["bad.toml"]);
        assert!(code == 2 && errors.starts_with(expected), "{expected}\n{errors}");
    }
}

#[test]
fn all_faults_of_a_file_are_told_and_those_of_the_command_line_by_their_option() {
    let folder = folder("more_faults");
    let mut text = String::from(REST);
    for _ in 0..30 {
        writeln!(text, "[x]").unwrap();
    }
    std::fs::write(folder.join("many.toml"), text).unwrap();
    let (code, errors) = run(&folder, &["many.toml"]);
    assert!(code == 2 && errors.lines().count() == 20 && errors.contains("many.toml:22: "), "{errors}");

    std::fs::write(folder.join("good.toml"), format!("{REST}[gyro]\nbias_deg_h = 1\n[output]\nname = 'a'\n"))
        .unwrap();
    for (arguments, expected) in [
        (
            &["good.toml", "--gyro-bias", "1e9"][..],
            "sins_harness: --gyro-bias: gyro.bias_rad_s[0] = 4848.13681109536: must be",
        ),
        (
            &["good.toml", "--gyro-bias", "x"],
            "sins_harness: --gyro-bias x: expected one number for all axes, or three",
        ),
        (&["good.toml", "--motion", "rest"], "sins_harness: --motion: only simulation1 and simulation2"),
        (&["good.toml", "--name", "a/b"], "sins_harness: --name: \"a/b\" has a folder"),
        (&["good.toml", "--baro-bias", "1"], "sins_harness: --baro-bias: altimeter errors act with"),
        (&["none.toml"], "sins_harness: none.toml: No such file"),
        (&["good.scene"], "sins_harness: good.scene: no such scene; expected simulation1"),
    ] {
        let (code, errors) = run(&folder, arguments);
        assert!(code == 2 && errors.starts_with(expected), "{expected}\n{errors}");
    }
    std::fs::create_dir(folder.join("folder.toml")).unwrap();
    let (code, errors) = run(&folder, &["folder.toml"]);
    assert!(code == 2 && errors.contains("folder.toml: "), "{errors}");
    std::fs::write(folder.join("latin.toml"), b"[flight]\n\n# caf\xe9\n").unwrap();
    let (code, errors) = run(&folder, &["latin.toml"]);
    assert_eq!(
        (code, errors.as_str()),
        (2, "latin.toml:3: a byte that is no UTF-8; save the file as UTF-8\n")
    );
}
