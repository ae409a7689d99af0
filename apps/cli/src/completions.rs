//! `sins completions`: the command line for shells.

use clap::CommandFactory;
use clap_complete::Shell;

use crate::failure::Failure;
use crate::terminal::print;

/// Prints completions for a shell: `sins completions bash > ~/.local/share/bash-completion/completions/sins`
#[derive(Debug, clap::Args)]
pub struct Order {
    pub shell: Shell,
}

pub fn run<C: CommandFactory>(order: &Order) -> Result<(), Failure> {
    let mut script = Vec::new();
    clap_complete::generate(order.shell, &mut C::command(), "sins", &mut script);
    print(&String::from_utf8_lossy(&script))
}
