//! Texts of any bytes.

use std::io::Write as _;
use std::process::{Command, Stdio};

use super::c_side::{library_folder, project_file};
use super::scenes::{SANITIZED, build};

/// Whatever the bytes are: no harm is done, and what is taken is TOML.
#[test]
fn spoiled_scenes_do_no_harm_and_what_is_taken_is_toml() {
    let rounds = if cfg!(feature = "long-tests") { 200_000 } else { 4_000 };
    let folder = library_folder("scene_texts");
    let program = build(&folder, "tests/c/scene_texts.c", &SANITIZED, "scene_texts");
    let mut seeds = vec![
        b"\xef\xbb\xbf[flight]\r\nbuiltin = 'rest' # x\r\nhours = 1_0.5e-1\r\n[gyro]\r\nbias_deg_h = [ 1, +2.5,\r\n-3, ]\r\n"
            .to_vec(),
        b"[[manoeuvre]]\nkind=\"sinusoids\"\nduration_s=9\n[[ manoeuvre . sinusoid ]]\nchannel=\"r\\u006fll\"\n[output]\nquiet=true\n"
            .to_vec(),
    ];
    for name in ["patrol", "fighter", "drone", "trainer"] {
        seeds.push(std::fs::read(project_file(&format!("c_examples/scenes/{name}.toml"))).unwrap());
    }
    const PIECES: [&[u8]; 24] = [
        b"[",
        b"]",
        b"[[",
        b"]]",
        b"\"",
        b"'",
        b"'''",
        b"\\",
        b"\\u00e9",
        b"#",
        b"\n",
        b"\r\n",
        b"\r",
        b"\0",
        b"\xc3\xa9",
        b"\xed\xa0\x80",
        b"_",
        b".",
        b"0",
        b"e9",
        b"-",
        b"true",
        b"= 1\n",
        b" = [1, 2, 3]\n",
    ];
    let mut state = 1u64;
    let mut draw = |below: usize| {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (state >> 33) as usize % below
    };
    let mut texts = Vec::new();
    for round in 0..rounds {
        let mut text = seeds[round % seeds.len()].clone();
        for _ in 0..1 + draw(3) {
            let at = draw(text.len() + 1);
            let end = (at + draw(12)).min(text.len());
            match draw(4) {
                0 => drop(text.splice(at..end, [])),
                1 => drop(text.splice(at..at, PIECES[draw(PIECES.len())].iter().copied())),
                2 => drop(text.splice(at..end.min(at + 1), [draw(256) as u8])),
                _ => {
                    let piece = text[at..end].to_vec();
                    let to = draw(text.len() + 1);
                    drop(text.splice(to..to, piece));
                }
            }
        }
        texts.push(text);
    }
    let mut child = Command::new(program)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(std::fs::File::create(folder.join("errors.txt")).unwrap())
        .spawn()
        .unwrap();
    let mut input = child.stdin.take().unwrap();
    let all: Vec<u8> =
        texts.iter().flat_map(|text| [&(text.len() as u32).to_le_bytes()[..], text].concat()).collect();
    let writer = std::thread::spawn(move || input.write_all(&all));
    let output = child.wait_with_output().unwrap();
    writer.join().unwrap().unwrap();
    assert!(output.status.success(), "see {}", folder.join("errors.txt").display());
    assert_eq!(output.stdout.len(), rounds);
    let mut taken = 0;
    for (text, answer) in texts.iter().zip(&output.stdout) {
        if *answer == b'1' {
            let text = std::str::from_utf8(text).unwrap();
            let parsed = text.strip_prefix('\u{feff}').unwrap_or(text).parse::<toml::Table>();
            assert!(parsed.is_ok(), "taken, but no TOML:\n{text}\n{parsed:?}");
            taken += 1;
        }
    }
    // Neither answer is the only one.
    assert!(taken > rounds / 20 && taken < rounds - rounds / 20, "{taken} of {rounds}");
}
