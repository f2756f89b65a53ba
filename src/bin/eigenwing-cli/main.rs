//! The command line: the same analysis as on the page, without one.
//!
//! ```sh
//! cargo run --no-default-features --features cli --bin eigenwing-cli -- analyse navion
//! ```
//!
//! A table for people, or `--json` or `--csv` for programs. Bad input is one line on the error output and exit code 1; a command
//! that can't be understood is exit code 2.

mod arguments;
mod csv_output;
mod frequency_table;
mod input;
mod lesson_check;
mod response_table;
mod tables;

use std::io::{ErrorKind, Write as _};
use std::process::ExitCode;

use arguments::{Arguments, Command, Format};
use clap::Parser as _;
use clap::error::ErrorKind as Misuse;
use eigenwing::export::{
    self, FrequencyRequest, ResponseRequest, Sweep, SweepPoint, SweepReport, SweepRequest,
};
use eigenwing::findings::Findings;
use indicatif::{ProgressBar, ProgressStyle};
use serde::Serialize;

use input::InputError;

fn main() -> ExitCode {
    let arguments = match Arguments::try_parse() {
        Ok(arguments) => arguments,
        Err(error) => return misused(&error),
    };
    match answer(&arguments.command) {
        Ok(text) => print(&text),
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

/// Output of a command.
fn answer(command: &Command) -> Result<String, InputError> {
    Ok(match command {
        Command::List { output } => {
            let list = export::list();
            match output.format() {
                Format::Table => tables::list(&list),
                Format::Json => json(&list),
                Format::Csv => csv_output::list(&list),
            }
        }
        Command::Parameters { subject, output } => {
            let parameters = export::parameters_of(&subject.read()?);
            match output.format() {
                Format::Table => tables::parameters(&parameters),
                Format::Json => json(&parameters),
                Format::Csv => csv_output::parameters(&parameters),
            }
        }
        Command::Measures { subject, all, output } => {
            let measures = export::measures_of(&Findings::of(subject.read()?), *all);
            match output.format() {
                Format::Table => tables::measures(&measures),
                Format::Json => json(&measures),
                Format::Csv => csv_output::measures(&measures),
            }
        }
        Command::Analyse { subject, output } => {
            let report = export::analyse(&Findings::of(subject.read()?))?;
            match output.format() {
                Format::Table => tables::analysis(&report),
                Format::Json => json(&report),
                Format::Csv => csv_output::analysis(&report),
            }
        }
        Command::Why { subject, json: as_json } => {
            let report = export::why(&subject.read()?)?;
            if *as_json { json(&report) } else { tables::why(&report) }
        }
        Command::Respond { subject, plane, disturbance, shape, mode, steps, nonlinear, split, output } => {
            let request = ResponseRequest {
                plane: plane.clone(),
                disturbance: disturbance.clone(),
                shape: shape.clone(),
                mode: mode.clone(),
                steps: *steps,
                nonlinear: *nonlinear,
                split: *split,
            };
            let report = export::respond(&subject.read()?, &request)?;
            match output.format() {
                Format::Table => response_table::response(&report),
                Format::Json => json(&report),
                Format::Csv => {
                    csv_output::response_notes(&report).iter().for_each(|note| eprintln!("note: {note}"));
                    csv_output::response(&report)
                }
            }
        }
        Command::Frequency { subject, plane, disturbance, watched, from, to, points, output } => {
            let request = FrequencyRequest {
                plane: plane.clone(),
                disturbance: disturbance.clone(),
                output: watched.clone(),
                from: *from,
                to: *to,
                points: *points,
            };
            let report = export::frequency(&subject.read()?, &request)?;
            match output.format() {
                Format::Table => frequency_table::frequency(&report),
                Format::Json => json(&report),
                Format::Csv => csv_output::frequency(&report),
            }
        }
        Command::Check { files } => lesson_check::check(files)?,
        Command::Sweep { subject, parameter, from, to, points, measures, output } => {
            let request = SweepRequest {
                parameter: parameter.clone(),
                from: *from,
                to: *to,
                points: *points,
                measures: measures.clone(),
            };
            let report = swept(Sweep::new(subject.read()?, &request)?);
            match output.format() {
                Format::Table if measures.is_empty() => tables::sweep(&report),
                Format::Table => tables::measured_sweep(&report),
                Format::Json => json(&report),
                Format::Csv if measures.is_empty() => csv_output::sweep(&report),
                Format::Csv => csv_output::measured_sweep(&report),
            }
        }
    })
}

/// The report of a sweep, with a bar on a terminal while it takes its time.
fn swept(mut sweep: Sweep) -> SweepReport {
    /// As many points are done before a bar could be seen.
    const SOON_DONE: usize = 500;
    let bar = if sweep.len() > SOON_DONE {
        let style = ProgressStyle::with_template("{bar:40} {pos} of {len} points, {eta} left");
        // Draws on the error output, and only if that is a terminal.
        let bar = ProgressBar::new(sweep.len() as u64);
        bar.with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
    } else {
        ProgressBar::hidden()
    };
    let points: Vec<SweepPoint> = sweep.by_ref().inspect(|_| bar.inc(1)).collect();
    bar.finish_and_clear();
    sweep.report_of(points)
}

fn json(answer: &impl Serialize) -> String {
    // Only maps whose keys are no texts can't be written, and there are none.
    serde_json::to_string_pretty(answer).map_or_else(|error| error.to_string(), |text| text + "\n")
}

/// Prints an answer. Whoever reads it may stop early, as `head` does; that is no error.
fn print(text: &str) -> ExitCode {
    let mut out = std::io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            eprintln!("error: cannot write the answer: {error}");
            ExitCode::FAILURE
        }
        _ => ExitCode::SUCCESS,
    }
}

/// Help as clap prints it; anything else in one line.
fn misused(error: &clap::Error) -> ExitCode {
    match error.kind() {
        Misuse::DisplayHelp | Misuse::DisplayVersion | Misuse::DisplayHelpOnMissingArgumentOrSubcommand => {
            error.exit()
        }
        _ => {
            let text = error.to_string();
            let said: Vec<&str> = text
                .lines()
                .map(str::trim)
                .take_while(|line| !line.starts_with("Usage:") && !line.starts_with("For more"))
                .filter(|line| !line.is_empty())
                .collect();
            eprintln!("{}", said.join(" ").replace(" tip: ", "; "));
            ExitCode::from(2)
        }
    }
}
