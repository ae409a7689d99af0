//! Scenes from a file, in the C harness: what they set and fly.

#[path = "support/c_side.rs"]
mod c_side;
#[path = "support/scenes.rs"]
mod scenes;

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::process::Command;

use c_side::{library_folder, project_file, succeed};
use scenes::{SANITIZED, build, folder, harness, run};

/// The records of a flight.
fn fly(folder: &Path, arguments: &[&str], name: &str) -> Vec<u8> {
    let (code, errors) = run(folder, &[arguments, &["--quiet", "--name", name]].concat());
    assert_eq!((code, errors.as_str()), (0, ""), "{arguments:?}");
    std::fs::read(folder.join(format!("sins_out/{name}.csv"))).unwrap()
}

#[test]
fn keys_words_and_manoeuvres_arrive_in_si() {
    let folder = library_folder("scene_units");
    succeed(Command::new(build(&folder, "tests/c/scene.c", &SANITIZED, "scene")).current_dir(&folder));
}

#[test]
fn a_scene_flies_as_the_same_options_do_to_the_bit() {
    let folder = folder("same");
    let scene = project_file("c_examples/scenes/patrol.toml");
    let short = ["--hours", "0.05", "--every", "1"];
    let patrol = fly(&folder, &[&[scene.to_str().unwrap()], &short[..]].concat(), "file");
    assert!(patrol.iter().filter(|&&byte| byte == b'\n').count() == 1 + 181);
    assert!(
        patrol
            == fly(
                &folder,
                &[&["simulation2", "--vertical", "follow", "--error-model", "rk4"], &short[..]].concat(),
                "options"
            )
    );

    // Every number and word that is an option as well, in another order.
    let text = "[options]\nsignal = 'closed-loop'\nclosed_loop_time_s = 20\nseed = 5\nrun = 6\nscheme = 'paper'\n\
        frame = 'geographic'\nsubsamples = 3\nupdates_per_sample = 2\nvertical = 'damped'\ngravity = 'somigliana'\n\
        earth = 'grs80'\naxes = 'frd'\nerror_model = 'off'\n\
        [flight]\nbuiltin = 'aerobatics'\nhours = 0.01\nrate_hz = 50\n\
        [gyro]\nbias_deg_h = [0.1, 0.2, -0.3]\nbias_sigma_deg_h = 0.7\nrandom_walk_deg_sqrt_h = 0.01\n\
        markov_sigma_deg_h = 0.3\nmarkov_time_s = 300\nscale_factor_ppm = 100\nmisalignment_arcsec = 5\n\
        [accelerometer]\npreset = 'tactical'\nbias_micro_g = [1, 2, 3.5]\nscale_factor_ppm = -40\n\
        [altimeter]\nbias_m = 3\nnoise_m = 0.5\nmarkov_sigma_m = 2\nmarkov_time_s = 90\nscale_factor_ppm = 70\nlag_s = 0.2\n\
        [start]\nposition_m = [1, 2, 3]\nvelocity_m_s = [0.1, 0.2, 0.3]\nmisalignment_arcmin = [1, 2, 3]\n\
        alignment = 'gyrocompass'\n[output]\nevery_s = 0.5\n";
    let options = "embedded aerobatics --hours 0.01 --rate 50 --signal closed-loop --closed-loop-time 20 --seed 5 --run 6 \
        --scheme paper --frame geographic --subsamples 3 --updates 2 --vertical damped --gravity somigliana --earth grs80 \
        --axes frd --no-model --gyro-bias 0.1,0.2,-0.3 --gyro-bias-sigma 0.7 --gyro-arw 0.01 --gyro-markov-sigma 0.3 \
        --gyro-markov-time 300 --gyro-scale 100 --gyro-misalignment 5 --accel-bias 1,2,3.5 --accel-preset tactical \
        --accel-scale -40 --baro-bias 3 --baro-noise 0.5 --baro-markov-sigma 2 --baro-markov-time 90 --baro-scale 70 \
        --baro-lag 0.2 --initial-position 1,2,3 --initial-velocity 0.1,0.2,0.3 --initial-misalignment 1,2,3 \
        --alignment gyrocompass --every 0.5";
    let options: Vec<&str> = options.split_whitespace().collect();
    let expected = fly(&folder, &options, "options");
    for (name, text) in [
        ("lf", text.to_owned()),
        ("crlf", text.replace('\n', "\r\n")),
        ("bom", format!("\u{feff}{text}")),
        ("tail", text.trim_end().to_owned()),
        ("spaced", text.replace('\n', " # why\n\n\t ").replace('[', "[ ").replace(']', "\t]")),
    ] {
        let scene = format!("{name}.toml");
        std::fs::write(folder.join(&scene), text).unwrap();
        assert!(fly(&folder, &[&scene], name) == expected, "{name}");
    }

    // The command line has the last word.
    let other = text.replace("[0.1, 0.2, -0.3]", "99").replace("seed = 5", "seed = 8");
    std::fs::write(folder.join("other.toml"), &other).unwrap();
    let overridden = ["other.toml", "--gyro-bias", "0.1,0.2,-0.3", "--seed", "5"];
    assert!(other != text && fly(&folder, &["other.toml"], "other") != expected);
    assert!(fly(&folder, &overridden, "2014") == expected);
}

#[test]
fn the_example_scenes_and_the_readmes_fly() {
    let folder = folder("examples");
    let scenes = std::fs::read_dir(project_file("c_examples/scenes")).unwrap();
    let mut paths: Vec<PathBuf> = scenes.map(|entry| entry.unwrap().path()).collect();
    assert_eq!(paths.len(), 4);

    let readme = std::fs::read_to_string(project_file("README.md")).unwrap();
    let (text, _) = readme.split_once("```toml\n").unwrap().1.split_once("```").unwrap();
    let flights = project_file("c_examples/flights").to_str().unwrap().to_owned();
    paths.push(folder.join("readme.toml"));
    std::fs::write(&paths[4], text.replace("../flights", &flights)).unwrap();

    for path in paths {
        let text = std::fs::read_to_string(&path).unwrap();
        assert!(text.parse::<toml::Table>().is_ok(), "{}", path.display());
        let records = fly(&folder, &[path.to_str().unwrap(), "--hours", "0.02", "--every", "1"], "example");
        // A row each second of 72 s, one of the start, and the header.
        assert_eq!(records.iter().filter(|&&byte| byte == b'\n').count(), 74, "{}", path.display());
    }
    let imu = std::fs::read_to_string(folder.join("fighter_imu.csv")).unwrap();
    assert_eq!(imu.lines().count(), 1 + 7200);
}

/// The fields of a struct in the header that are no housekeeping.
fn fields(header: &str, name: &str) -> Vec<String> {
    let (_, rest) = header.split_once(&format!("typedef struct {name} {{")).unwrap();
    let (body, _) = rest.split_once('}').unwrap();
    let members = body.lines().map(str::trim).filter(|line| {
        ["int32_t ", "uint32_t ", "uint64_t ", "double "].iter().any(|kind| line.starts_with(kind))
    });
    let names = members.map(|line| {
        let name = line.trim_end_matches(';').split_whitespace().last().unwrap();
        name.split('[').next().unwrap().to_owned()
    });
    names.filter(|name| !["struct_size", "reserved", "reserved2"].contains(&name.as_str())).collect()
}

/// Those of gyros and accelerometers come from one table with their keys in the library.
#[test]
fn every_field_of_the_structs_has_a_key_and_every_key_is_told() {
    let output = succeed(Command::new(harness()).arg("--keys"));
    let page = String::from_utf8(output.stdout).unwrap();
    let told: BTreeSet<&str> = page.split(['\n', ' ', ';']).collect();
    let header = std::fs::read_to_string(project_file("include/sins.h")).unwrap();
    let mut count = 0;
    for (name, prefix) in [
        ("sins_options", "options"),
        ("sins_altimeter_params", "altimeter"),
        ("sins_initial_errors", "initial"),
        ("sins_mounting", "mounting"),
        ("sins_gravity_params", "gravity"),
        ("sins_failure", "failure"),
        ("sins_flight_start", "start"),
        ("sins_manoeuvre", "manoeuvre"),
    ] {
        for field in fields(&header, name) {
            let field = format!("{prefix}.{field}");
            // The flight is on the simulator's Earth; sinusoids have a section of their own.
            let by_another = [
                "start.earth",
                "manoeuvre.sinusoid_count",
                "manoeuvre.channel",
                "manoeuvre.amplitude",
                "manoeuvre.frequency_hz",
                "manoeuvre.phase_rad",
            ];
            assert!(
                told.contains(field.as_str()) || by_another.contains(&field.as_str()),
                "{field} has no key"
            );
            count += 1;
        }
    }
    assert!(count > 60, "{count}");
    let table = std::fs::read_to_string(project_file("c_examples/harness/option_table.c")).unwrap();
    for key in [
        "channel",
        "amplitude_deg",
        "amplitude_m_s",
        "frequency_hz",
        "phase_deg",
        "file",
        "builtin",
        "imu",
        "sensor",
        "axis",
        "from_s",
        "until_s",
    ] {
        assert!(told.contains(key) && table.contains(&format!("\"{key}\"")), "{key}");
    }
}
