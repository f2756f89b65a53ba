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
mod grade;
mod grade_table;
mod input;
mod lesson_check;
mod manual;
mod picture;
mod response_table;
mod review_table;
mod shown_units;
mod tables;
mod taken;

use std::io::{ErrorKind, Write as _};
use std::process::ExitCode;

use arguments::{Arguments, Command, DisturbanceArguments, Format};
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
        Ok(answer) => print(&answer),
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

/// Output of a command.
fn answer(command: &Command) -> Result<Vec<u8>, InputError> {
    let text = match command {
        Command::List { output } => {
            let list = export::list();
            match output.format() {
                Format::Table => tables::list(&list),
                Format::Json => json(&list),
                Format::Csv => csv_output::list(&list),
            }
        }
        Command::Parameters { subject, output, units } => {
            let mut scene = subject.read()?;
            let units = units.of(&mut scene);
            let parameters = export::parameters_of(&scene.scenario);
            match output.format() {
                Format::Table => tables::parameters(&parameters, units),
                Format::Json => json(&parameters),
                Format::Csv => csv_output::parameters(&parameters),
            }
        }
        Command::Measures { subject, all, output, units } => {
            let mut scene = subject.read()?;
            let units = units.of(&mut scene);
            let measures = export::measures_of(&Findings::of(scene.scenario), *all);
            match output.format() {
                Format::Table => tables::measures(&measures, units),
                Format::Json => json(&measures),
                Format::Csv => csv_output::measures(&measures),
            }
        }
        Command::Analyse { subject, output, units } => {
            let mut scene = subject.read()?;
            let units = units.of(&mut scene);
            let report = export::analyse(&scene).map_err(|error| units.told(error))?;
            match output.format() {
                Format::Table => tables::analysis(&report, units, scene.scenario.notation),
                Format::Json => json(&report),
                Format::Csv => csv_output::analysis(&report),
            }
        }
        Command::Why { subject, json: as_json } => {
            let report = export::why(&subject.read()?)?;
            if *as_json { json(&report) } else { tables::why(&report) }
        }
        Command::Read { file, fills, toml, json: as_json } => {
            let review = fills.review(file)?;
            match (toml, as_json) {
                (true, _) => review.text().map_err(export::ExportError::from)?.to_owned(),
                (_, true) => json(&review),
                _ => review_table::review(&review),
            }
        }
        Command::Respond { subject, disturbance, steps, output, units } => {
            let DisturbanceArguments { plane, disturbance, shape, mode, nonlinear, split } = disturbance;
            let request = ResponseRequest {
                plane: plane.clone(),
                disturbance: disturbance.clone(),
                shape: shape.clone(),
                mode: mode.clone(),
                steps: *steps,
                nonlinear: *nonlinear,
                split: *split,
            };
            let mut scene = subject.read()?;
            let units = units.of(&mut scene);
            let report = export::respond(&scene, &request).map_err(|error| units.told(error))?;
            report.notices.iter().skip(scene.notices.len()).for_each(|notice| eprintln!("note: {notice}"));
            match output.format() {
                Format::Table => response_table::response(&report, units),
                Format::Json => json(&report),
                Format::Csv => {
                    csv_output::response_notes(&report).iter().for_each(|note| eprintln!("note: {note}"));
                    csv_output::response(&report)
                }
            }
        }
        Command::Frequency { subject, plane, disturbance, watched, from, to, points, output, units } => {
            let request = FrequencyRequest {
                plane: plane.clone(),
                disturbance: disturbance.clone(),
                output: watched.clone(),
                from: *from,
                to: *to,
                points: *points,
            };
            let mut scene = subject.read()?;
            let units = units.of(&mut scene);
            let report = export::frequency(&scene, &request).map_err(|error| units.told(error))?;
            match output.format() {
                Format::Table => frequency_table::frequency(&report, units),
                Format::Json => json(&report),
                Format::Csv => csv_output::frequency(&report),
            }
        }
        Command::Link { subject, disturbance, address, json: as_json } => {
            let report = export::link_to(&subject.read()?, &disturbance.request(), address.as_deref())?;
            if *as_json { json(&report) } else { report.link + "\n" }
        }
        Command::Export { target, subject, disturbance, units, output } => {
            let mut scene = subject.read()?;
            scene.scenario.units = units.unwrap_or(scene.scenario.units);
            return taken::take(target, &scene, &disturbance.request(), output.as_deref());
        }
        Command::Completions { shell } => manual::completions(*shell),
        Command::Manual { folder } => manual::write(folder)?,
        Command::Check { files } => lesson_check::check(files)?,
        Command::Grade(arguments) => grade::grade(arguments)?,
        Command::Sweep { subject, parameter, from, to, points, measures, output, units } => {
            let request = SweepRequest {
                parameter: parameter.clone(),
                from: *from,
                to: *to,
                points: *points,
                measures: measures.clone(),
            };
            let mut scene = subject.read()?;
            let units = units.of(&mut scene);
            let report = swept(Sweep::new(scene, &request)?);
            match output.format() {
                Format::Table if measures.is_empty() => tables::sweep(&report, units),
                Format::Table => tables::measured_sweep(&report, units),
                Format::Json => json(&report),
                Format::Csv if measures.is_empty() => csv_output::sweep(&report),
                Format::Csv => csv_output::measured_sweep(&report),
            }
        }
    };
    Ok(text.into_bytes())
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
fn print(answer: &[u8]) -> ExitCode {
    let mut out = std::io::stdout().lock();
    match out.write_all(answer).and_then(|()| out.flush()) {
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
