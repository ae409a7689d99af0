//! Progress on a terminal: completed part, speed and remaining time. Nothing of it goes into a file or a pipe.

use std::io::Read;
use std::process::{Command, Stdio};

use crate::support::{folder, run};

/// Output of the program on a terminal, until `is_enough`; the program is ended there.
fn on_a_terminal(folder: &std::path::Path, arguments: &str, is_enough: impl Fn(&str) -> bool) -> String {
    let order = format!("'{}' {arguments}", env!("CARGO_BIN_EXE_sins"));
    let mut terminal = Command::new("script");
    // Without a kind of terminal no line is drawn.
    terminal
        .args(["-qec", &order, "/dev/null"])
        .env("TERM", "xterm")
        .current_dir(folder)
        .stdin(Stdio::null())
        .stdout(Stdio::piped());
    let mut terminal = terminal.spawn().unwrap();
    let (mut said, mut part) = (Vec::new(), [0; 4096]);
    let mut output = terminal.stdout.take().unwrap();
    let text = loop {
        let size = output.read(&mut part).unwrap();
        said.extend(&part[..size]);
        let text = String::from_utf8_lossy(&said).into_owned();
        if size == 0 || is_enough(&text) {
            break text;
        }
    };
    // Without its terminal the program ends.
    let _ = terminal.kill();
    terminal.wait().unwrap();
    text
}

#[test]
fn a_terminal_sees_how_far_how_fast_and_how_long_still() {
    let folder = folder("terminal");
    for (arguments, words) in [
        ("fly simulation2 --set flight.hours=8 --set output.every_s=60", "flying: "),
        ("budget simulation2 --hours 0.3", "flying each effect alone: "),
        ("ensemble simulation2 --set flight.hours=0.2 --runs 256 --threads 1", "flying 256 runs: "),
    ] {
        let line_of = |said: &str| said.split(words).find(|line| line.contains(" left")).map(str::to_owned);
        let said = on_a_terminal(&folder, arguments, |said| line_of(said).is_some());
        let line = line_of(&said).unwrap_or_else(|| panic!("{arguments}: {said}"));
        assert!(line.contains(" %, ") && line.contains(" simulated seconds a second, "), "{line}");
    }
    let (code, said, errors) = run(&folder, &["budget", "simulation2", "--hours", "0.15"]);
    assert!(code == 0 && !(said + &errors).contains(" left"), "{errors}");
}
