//! With the feature `manual`: `sins manual FOLDER` writes the manual pages and the completions of the command line, at the places that
//! they have below `/usr/share`. It is no command of the command line, so what is written is that of the program without the feature.

use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::{fs, io};

use clap::CommandFactory;
use clap_complete::Shell;

use crate::terminal;

/// Where each shell looks for the completions of all users, below `/usr/share`. CMakeLists.txt has the folder of Debian's zsh.
const COMPLETIONS: [(Shell, &str); 3] = [
    (Shell::Bash, "bash-completion/completions/sins"),
    (Shell::Fish, "fish/vendor_completions.d/sins.fish"),
    (Shell::Zsh, "zsh/site-functions/_sins"),
];

/// The folder of `sins manual FOLDER`.
pub fn folder(arguments: impl IntoIterator<Item = OsString>) -> Option<PathBuf> {
    let mut arguments = arguments.into_iter().skip(1);
    match (arguments.next(), arguments.next(), arguments.next()) {
        (Some(word), Some(folder), None) if word == "manual" => Some(folder.into()),
        _ => None,
    }
}

/// Writes all of it below the folder.
pub fn write<C: CommandFactory>(folder: &Path) -> ExitCode {
    match write_all::<C>(folder) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            terminal::say(&format!("{}: {error}", folder.display()));
            ExitCode::FAILURE
        }
    }
}

fn write_all<C: CommandFactory>(folder: &Path) -> io::Result<()> {
    let pages = folder.join("man/man1");
    fs::create_dir_all(&pages)?;
    // Without pages for the words `help`, which only repeat the others.
    clap_mangen::generate_to(C::command().disable_help_subcommand(true), &pages)?;
    for (shell, place) in COMPLETIONS {
        let path = folder.join(place);
        path.parent().map_or(Ok(()), fs::create_dir_all)?;
        let mut script = Vec::new();
        clap_complete::generate(shell, &mut C::command(), "sins", &mut script);
        fs::write(path, script)?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::CommandLine;

    #[test]
    fn each_command_has_a_page() {
        let folder = tempfile::tempdir().unwrap();
        write_all::<CommandLine>(folder.path()).unwrap();
        let page = |name: &str| {
            let path = folder.path().join("man/man1").join(format!("{name}.1"));
            fs::read_to_string(path).unwrap_or_else(|error| panic!("{name}: {error}"))
        };
        assert!(page("sins").contains("130"), "the exit codes");
        let command = CommandLine::command();
        let names: Vec<&str> = command.get_subcommands().map(clap::Command::get_name).collect();
        assert!(names.len() >= 12 && !names.contains(&"manual"), "{names:?}");
        for name in names {
            assert!(page(&format!("sins-{name}")).contains(name));
        }
        assert!(page("sins-scene-write").contains("set"));
        for (_, place) in COMPLETIONS {
            assert!(fs::read_to_string(folder.path().join(place)).unwrap().contains("ensemble"), "{place}");
        }
    }

    #[test]
    fn only_these_words_ask_for_it() {
        let asked = |words: &[&str]| folder(words.iter().map(OsString::from));
        assert_eq!(asked(&["sins", "manual", "here"]), Some("here".into()));
        for other in
            [&["sins", "manual"][..], &["sins", "fly", "manual"], &["sins", "manual", "a", "b"], &["sins"]]
        {
            assert_eq!(asked(other), None, "{other:?}");
        }
    }
}
