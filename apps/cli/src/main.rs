//! `sins`: flies scenes of the strapdown INS simulator and reports on them.
//!
//! A module for each command; `given` has the scene that they fly, `output` the files that they write, `drawing` their pictures.
#![forbid(unsafe_code)]

mod allan;
mod answer;
mod budget;
mod bus;
mod completions;
mod curve;
mod drawing;
#[cfg(test)]
#[allow(dead_code, reason = "these tests use a part of it")]
#[path = "../../../tests/support/draws.rs"]
mod draws;
mod ensemble;
mod failure;
mod fly;
mod given;
mod identify;
mod imu;
mod interrupt;
mod limits;
mod lines;
mod live;
mod log;
#[cfg(feature = "manual")]
mod manual;
mod output;
mod parallel;
#[cfg(test)]
mod parsed;
mod places;
mod planned;
mod progress;
mod recommend;
mod report;
mod rows;
mod scene;
mod siblings;
mod table;
mod terminal;
mod units;
mod written;

use std::ffi::OsString;
use std::process::ExitCode;

use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{CommandFactory, FromArgMatches, Parser};

use failure::{EXIT_CODES, Failure};

/// Simulates a strapdown inertial navigation system, and shows its errors.
#[derive(Debug, Parser)]
#[command(name = "sins", version, after_help = EXIT_CODES, max_term_width = 100)]
struct CommandLine {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, clap::Subcommand)]
enum Command {
    Fly(fly::Order),
    Live(live::Order),
    Ensemble(ensemble::Order),
    Log(log::Order),
    Report(report::Order),
    Allan(allan::Order),
    Identify(identify::Order),
    Budget(budget::Order),
    Curve(curve::Order),
    Recommend(recommend::Order),
    /// Lists the keys of a scene: values, unit and meaning of each
    Keys {
        /// Only the sections whose name begins with this word, as gyro, or the keys whose name contains it
        #[arg(value_name = "WORD")]
        word: Option<String>,
        /// As a table of comma-separated values, with limits, defaults, SI units and the items that have the key
        #[arg(long, conflicts_with = "word")]
        fields: bool,
    },
    #[command(subcommand)]
    Scene(scene::Order),
    #[command(subcommand)]
    Bus(bus::Order),
    Completions(completions::Order),
}

/// Reads the command line. A negative number is a value, whose limits the program then states, and no option.
fn read_from(arguments: impl IntoIterator<Item = OsString>) -> Result<CommandLine, clap::Error> {
    let command = CommandLine::command().mut_subcommands(|command| command.allow_negative_numbers(true));
    CommandLine::from_arg_matches(&command.try_get_matches_from(arguments)?)
}

fn main() -> ExitCode {
    #[cfg(feature = "manual")]
    if let Some(folder) = manual::folder(std::env::args_os()) {
        return manual::write::<CommandLine>(&folder);
    }
    let command = match read_from(std::env::args_os()) {
        Ok(line) => line.command,
        Err(error) => return answer(&error),
    };
    match interrupt::catch().and_then(|()| run(&command)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            terminal::say(&failure.to_string());
            failure.code()
        }
    }
}

fn run(command: &Command) -> Result<(), Failure> {
    match command {
        Command::Fly(order) => fly::run(order),
        Command::Live(order) => live::run(order),
        Command::Ensemble(order) => ensemble::run(order),
        Command::Log(order) => log::run(order),
        Command::Report(order) => report::run(order),
        Command::Allan(order) => allan::run(order),
        Command::Identify(order) => identify::run(order),
        Command::Budget(order) => budget::run(order),
        Command::Curve(order) => curve::run(order),
        Command::Recommend(order) => recommend::run(order),
        Command::Keys { word: None, fields: false } => scene::print_keys(),
        Command::Keys { word: Some(word), fields: false } => scene::print_keys_of(word),
        Command::Keys { fields: true, .. } => scene::print_key_fields(),
        Command::Scene(order) => scene::run(order),
        Command::Bus(order) => bus::run(order),
        Command::Completions(order) => completions::run::<CommandLine>(order),
    }
}

/// Words for which there is no command, and the command that does what they say.
const MEANT: [(&[&str], &str); 8] = [
    (&["run", "simulate", "sim", "start"], "fly SCENE"),
    (&["list", "ls", "scenes", "builtin"], "scene list"),
    (&["check", "validate", "lint"], "scene check SCENE.toml"),
    (&["new", "init", "write", "show"], "scene write NAME"),
    (&["plot", "draw", "view", "page"], "report RECORDS.csv"),
    (&["montecarlo", "monte-carlo", "runs", "mc"], "ensemble SCENE"),
    (&["listen", "stream", "serve"], "live SCENE"),
    (&["set", "params", "parameters", "options"], "keys"),
];

/// Words for which there is no option, and what does what they say.
const MEANT_OPTIONS: [(&[&str], &str); 7] = [
    (
        &["--duration", "--time", "--length", "--seconds", "--minutes"],
        "--hours HOURS, or --set flight.hours=HOURS",
    ),
    (&["--output", "--output-dir", "--folder", "--dir"], "--out DIR, or -o FILE for one file"),
    (&["--seed"], "--set options.seed=N"),
    (&["--run", "--n", "--count"], "--runs N of `sins ensemble`; --set options.run=N flies one run"),
    (&["--dt", "--rate", "--hz", "--frequency", "--step"], "--set flight.rate_hz=HZ"),
    (&["--grade", "--sensors", "--imu-grade"], "--preset GRADE"),
    (&["--param", "--params", "--config", "--key"], "--set section.key=value; `sins keys` lists the keys"),
];

/// What was meant by a word that is no command, or no option.
fn meant(error: &clap::Error) -> Option<String> {
    let given = |kind| match error.get(kind) {
        Some(ContextValue::String(word)) => Some(word.as_str()),
        _ => None,
    };
    let of = |words: &[(&[&str], &'static str)], word: &str| {
        words.iter().find(|(words, _)| words.contains(&word)).map(|(_, meant)| *meant)
    };
    if let Some(command) = given(ContextKind::InvalidSubcommand) {
        return of(&MEANT, command).map(|meant| format!("`sins {meant}`"));
    }
    let option = given(ContextKind::InvalidArg).filter(|_| error.kind() == ErrorKind::UnknownArgument)?;
    of(&MEANT_OPTIONS, option).map(str::to_owned)
}

/// Help, the version, or what is wrong with the command line.
fn answer(error: &clap::Error) -> ExitCode {
    let text = error.render().to_string();
    let is_asked_for = matches!(error.kind(), ErrorKind::DisplayHelp | ErrorKind::DisplayVersion);
    if is_asked_for {
        return match terminal::print(&text) {
            Ok(()) => ExitCode::SUCCESS,
            Err(failure) => failure.code(),
        };
    }
    terminal::say(text.trim_end());
    if let Some(meant) = meant(error) {
        terminal::say(&format!("\n  tip: {meant}"));
    }
    ExitCode::from(2)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_command_line_is_consistent() {
        CommandLine::command().debug_assert();
    }

    #[test]
    fn the_page_of_scenes_has_all_commands_and_scenes() {
        let page = include_str!("../../../docs/scenes.md");
        let has_row = |name: &str| page.lines().any(|line| line.starts_with('|') && line.contains(name));
        for command in CommandLine::command().get_subcommands() {
            let name = command.get_name();
            assert!([" ", "`"].iter().any(|end| has_row(&format!("`sins {name}{end}"))), "sins {name}");
        }
        for (name, _) in sins::scene::BUILTIN_SCENES {
            assert!(has_row(&format!("`{name}`")), "{name}");
        }
    }

    #[test]
    fn what_was_meant_is_reported() {
        let words = |arguments: &[&str]| {
            read_from(arguments.iter().map(OsString::from)).unwrap_err().render().to_string()
        };
        assert!(words(&["sins", "reprot"]).contains("'report'"));
        assert!(words(&["sins", "fly", "patrol", "--quite"]).contains("'--quiet'"));
        assert!(words(&["sins", "--version"]).contains(env!("CARGO_PKG_VERSION")));
        let help = words(&["sins", "--help"]);
        assert!(help.contains("Exit codes") && help.contains("130"), "{help}");
    }
}
