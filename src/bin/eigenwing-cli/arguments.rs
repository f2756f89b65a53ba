//! The arguments of the command line.

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand};

/// See how an aircraft moves when it is disturbed, without a window.
#[derive(Parser)]
#[command(name = "eigenwing-cli", version, about, max_term_width = 100)]
pub struct Arguments {
    #[command(subcommand)]
    pub command: Command,
}

#[derive(Subcommand)]
pub enum Command {
    /// The aircraft of the list
    List {
        #[command(flatten)]
        output: Output,
    },
    /// The parameters that can be set on an aircraft or swept, with their values in SI
    Parameters {
        #[command(flatten)]
        subject: SubjectArguments,
        #[command(flatten)]
        output: Output,
    },
    /// What can be read of an aircraft, by key, with its values in SI: columns of a sweep, goals and numbers of a lesson
    Measures {
        #[command(flatten)]
        subject: SubjectArguments,
        /// Those with nothing to read too, each with its reason
        #[arg(long)]
        all: bool,
        #[command(flatten)]
        output: Output,
    },
    /// Eigenvalues, named modes, verdicts, approximations and handling qualities
    #[command(alias = "analyze")]
    Analyse {
        #[command(flatten)]
        subject: SubjectArguments,
        #[command(flatten)]
        output: Output,
    },
    /// Why the modes stand elsewhere than in the aircraft's file: by which derivatives, and by which formula
    Why {
        #[command(flatten)]
        subject: SubjectArguments,
        /// JSON with every digit
        #[arg(long)]
        json: bool,
    },
    /// The motion after a disturbance; its size and length are parameters: --set elevator=0.02 --set time=120
    Respond {
        #[command(flatten)]
        subject: SubjectArguments,
        /// longitudinal or lateral [default: that of the disturbance]
        #[arg(long, value_name = "NAME")]
        plane: Option<String>,
        /// elevator, throttle, vertical-gust, head-gust, rudder, aileron, side-gust, turbulence, release or mode
        #[arg(long, value_name = "NAME")]
        disturbance: Option<String>,
        /// step, pulse, doublet, 3-2-1-1, sine or sweep; of a gust 1-cosine, step or sine
        #[arg(long, value_name = "NAME")]
        shape: Option<String>,
        /// Key of the mode that is flown alone, such as "short-period"
        #[arg(long, value_name = "NAME")]
        mode: Option<String>,
        /// Steps between the samples [default: 600]
        #[arg(long, value_name = "N")]
        steps: Option<usize>,
        /// Fly the same in six degrees of freedom, too, without linearising
        #[arg(long)]
        nonlinear: bool,
        /// Split every output into the parts of the modes
        #[arg(long)]
        split: bool,
        #[command(flatten)]
        output: Output,
    },
    /// Gain and phase of an output over the frequency of an input (Bode), with the peaks that modes make
    Frequency {
        #[command(flatten)]
        subject: SubjectArguments,
        /// longitudinal or lateral [default: that of the disturbance or the output]
        #[arg(long, value_name = "NAME")]
        plane: Option<String>,
        /// elevator, throttle, vertical-gust, head-gust, rudder, aileron or side-gust
        #[arg(long, value_name = "NAME")]
        disturbance: Option<String>,
        /// Key of an output as `respond` names it, such as theta [default: q or beta]
        #[arg(long = "output", value_name = "KEY")]
        watched: Option<String>,
        /// First angular frequency in rad/s [default: below all modes]
        #[arg(long, value_name = "VALUE", allow_negative_numbers = true)]
        from: Option<f64>,
        /// Last angular frequency in rad/s [default: above all modes]
        #[arg(long, value_name = "VALUE", allow_negative_numbers = true)]
        to: Option<f64>,
        /// Number of frequencies, both ends among them [default: 400]
        #[arg(long, value_name = "N")]
        points: Option<usize>,
        #[command(flatten)]
        output: Output,
    },
    /// Prove lessons: links, goals, solutions, choices, numbers, words; glossary.toml and references.toml stand beside them
    Check {
        /// A lesson, FILE.md
        #[arg(value_name = "FILE", required = true)]
        files: Vec<PathBuf>,
    },
    /// The modes along a range of one parameter, and where stability changes
    Sweep {
        #[command(flatten)]
        subject: SubjectArguments,
        /// Key of the parameter
        #[arg(long, value_name = "KEY")]
        parameter: String,
        /// First value, SI and radians
        #[arg(long, value_name = "VALUE", allow_negative_numbers = true)]
        from: f64,
        /// Last value, SI and radians
        #[arg(long, value_name = "VALUE", allow_negative_numbers = true)]
        to: f64,
        /// Number of values, both ends among them
        #[arg(long, value_name = "N", default_value_t = 51)]
        points: usize,
        /// Key of a measure to read at every value instead of the modes, such as phugoid.period; may be given again
        #[arg(long = "measure", value_name = "KEY")]
        measures: Vec<String>,
        #[command(flatten)]
        output: Output,
    },
}

/// An aircraft, and the values set on it.
#[derive(Args)]
pub struct SubjectArguments {
    /// An aircraft of the list, or an aircraft file, FILE.toml
    #[arg(value_name = "AIRCRAFT", required_unless_present = "matrix", conflicts_with = "matrix")]
    pub aircraft: Option<String>,
    /// Bare A and B with named states: FILE.json, FILE.csv or FILE.m
    #[arg(long, value_name = "FILE")]
    pub matrix: Option<PathBuf>,
    /// A parameter and its value, SI and radians; may be given again
    #[arg(long, value_name = "KEY=VALUE", value_parser = setting)]
    pub set: Vec<(String, f64)>,
    /// Class of MIL-F-8785C that levels are judged for: I, II, II-C, III or IV [default: that of the aircraft's file]
    #[arg(long, value_name = "CLASS")]
    pub class: Option<String>,
    /// Category of flight phase that levels are judged for: A, A-combat, B or C
    #[arg(long, value_name = "CATEGORY")]
    pub category: Option<String>,
}

#[derive(Args)]
#[group(multiple = false)]
pub struct Output {
    /// JSON with every digit
    #[arg(long)]
    json: bool,
    /// CSV with every digit
    #[arg(long)]
    csv: bool,
}

#[derive(Clone, Copy)]
pub enum Format {
    Table,
    Json,
    Csv,
}

impl Output {
    pub const fn format(&self) -> Format {
        match (self.json, self.csv) {
            (true, _) => Format::Json,
            (_, true) => Format::Csv,
            _ => Format::Table,
        }
    }
}

fn setting(text: &str) -> Result<(String, f64), String> {
    let (key, value) = text.split_once('=').ok_or("expected KEY=VALUE")?;
    // A minus sign as the tables print it.
    let value = value.trim();
    let value = value.replace('−', "-").parse().map_err(|_| format!("\"{value}\" is not a number"))?;
    Ok((key.trim().to_owned(), value))
}
