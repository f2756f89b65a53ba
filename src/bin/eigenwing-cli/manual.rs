//! The manual and the completions, written from the arguments themselves.

use std::path::Path;

use clap::CommandFactory as _;
use clap_complete::Shell;

use crate::arguments::Arguments;
use crate::input::InputError;

/// The completions of a shell.
pub fn completions(shell: Shell) -> String {
    let mut command = Arguments::command();
    let name = command.get_name().to_owned();
    let mut text = Vec::new();
    clap_complete::generate(shell, &mut command, name, &mut text);
    String::from_utf8_lossy(&text).into_owned()
}

/// Writes a man page for the program and one for each command into a folder.
pub fn write(folder: &Path) -> Result<String, InputError> {
    clap_mangen::generate_to(Arguments::command(), folder)
        .map_err(|error| InputError::Unwritable { path: folder.to_owned(), error })?;
    Ok(String::new())
}
