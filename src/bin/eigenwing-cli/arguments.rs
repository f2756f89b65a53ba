//! The arguments of the command line.

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand};
use eigenwing::export::Scene;
use eigenwing::key::Keyed as _;
use eigenwing::scenario::{Dimension, Notation, Parameter, Units};

use crate::shown_units::ShownUnits;

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
        #[command(flatten)]
        units: TableUnits,
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
        #[command(flatten)]
        units: TableUnits,
    },
    /// Eigenvalues, named modes, verdicts, approximations and handling qualities
    #[command(alias = "analyze")]
    Analyse {
        #[command(flatten)]
        subject: SubjectArguments,
        #[command(flatten)]
        output: Output,
        #[command(flatten)]
        units: TableUnits,
    },
    /// Why the modes stand elsewhere than in the aircraft's file: by which derivatives, and by which formula
    Why {
        #[command(flatten)]
        subject: SubjectArguments,
        /// JSON with every digit
        #[arg(long)]
        json: bool,
    },
    /// What is in a file of another program, or of matrices: what was read as what, what is missing, what looks wrong
    Read {
        /// A file of AVL (.st, .sys), XFLR5, VSPAERO (.stab), Digital DATCOM or JSBSim, or matrices as MATLAB, Python, JSON or CSV
        #[arg(value_name = "FILE")]
        file: PathBuf,
        #[command(flatten)]
        fills: FillArguments,
        /// Write the aircraft as an aircraft file, which every command takes
        #[arg(long, conflicts_with = "json")]
        toml: bool,
        /// JSON with every digit
        #[arg(long)]
        json: bool,
    },
    /// The motion after a disturbance; its size and length are parameters: --set elevator=0.02 --set time=120
    Respond {
        #[command(flatten)]
        subject: SubjectArguments,
        #[command(flatten)]
        disturbance: DisturbanceArguments,
        /// Steps between the samples [default: 600]
        #[arg(long, value_name = "N")]
        steps: Option<usize>,
        #[command(flatten)]
        output: Output,
        #[command(flatten)]
        units: TableUnits,
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
        #[command(flatten)]
        units: TableUnits,
    },
    /// Write a link to a scene of the page: an aircraft of the list, what is set on it, a disturbance; or a link with changes to it
    Link {
        #[command(flatten)]
        subject: SubjectArguments,
        #[command(flatten)]
        disturbance: DisturbanceArguments,
        /// Address of the page, to stand before the link
        #[arg(long, value_name = "URL")]
        address: Option<String>,
        /// JSON, with what of --link can't be used
        #[arg(long)]
        json: bool,
    },
    /// Take a scene along: python, notebook, matlab, latex, toml, json, jsbsim; derivatives, poles, modes, response, frequency,
    /// chart (CSV); levels (JSON); poles-figure, response-figure, frequency-figure, chart-figure,
    /// aircraft-figure (SVG); poles-png, response-png, frequency-png, chart-png, aircraft-png; page, to print (HTML)
    Export {
        /// What it becomes
        #[arg(value_name = "TARGET")]
        target: String,
        #[command(flatten)]
        subject: SubjectArguments,
        #[command(flatten)]
        disturbance: DisturbanceArguments,
        /// Units of lengths in figures, LaTeX and CSV, si or ft [default: those of the link, or of the source and SI]
        #[arg(long, value_name = "UNITS", value_parser = units)]
        units: Option<Units>,
        /// A file to write it into, instead of printing it; a figure in a file that ends in .png is a picture
        #[arg(short, long, value_name = "FILE")]
        output: Option<PathBuf>,
    },
    /// Prove lessons: links, goals, solutions, choices, numbers, words; glossary.toml and references.toml stand beside them
    Check {
        /// A lesson, FILE.md
        #[arg(value_name = "FILE", required = true)]
        files: Vec<PathBuf>,
    },
    /// Write the completions of a shell, which its own manual says where to put
    Completions {
        /// The shell
        shell: clap_complete::Shell,
    },
    /// Write the manual as man pages, one for each command
    #[command(hide = true)]
    Manual {
        /// Where to
        #[arg(value_name = "FOLDER")]
        folder: PathBuf,
    },
    /// Grade what was handed in to a lesson: every goal again on its scene, every answer against the model
    Grade(GradeArguments),
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
        #[command(flatten)]
        units: TableUnits,
    },
}

/// A lesson, and what was handed in to it.
#[derive(Args)]
pub struct GradeArguments {
    /// The lesson, FILE.md, as it was given to the class
    #[arg(value_name = "LESSON")]
    pub lesson: PathBuf,
    /// Reports as the page saves them, folders of them, or tables of links from a form, FILE.csv
    #[arg(value_name = "REPORTS", required = true)]
    pub reports: Vec<PathBuf>,
    /// Write the answers of the class as one page to show, FILE.html
    #[arg(long, value_name = "FILE")]
    pub page: Option<PathBuf>,
    /// Say on that page who answered what
    #[arg(long, requires = "page")]
    pub names: bool,
    #[command(flatten)]
    pub output: Output,
}

/// An aircraft, and the values set on it.
#[derive(Args)]
pub struct SubjectArguments {
    /// An aircraft of the list, a file that `read` can read, or a link
    #[arg(
        value_name = "AIRCRAFT",
        required_unless_present_any = ["matrix", "link"],
        conflicts_with_all = ["matrix", "link"]
    )]
    pub aircraft: Option<String>,
    /// A link of the page in quotes, '#v=1&ac=navion&speed=60', or an address with one. It has its own words and units (degrees,
    /// per cent); whatever else is given counts above it
    #[arg(long, value_name = "LINK", conflicts_with = "matrix")]
    pub link: Option<String>,
    /// A file in place of an aircraft of the list
    #[arg(long, value_name = "FILE")]
    pub matrix: Option<PathBuf>,
    #[command(flatten)]
    pub fills: FillArguments,
    /// A parameter and its value, SI and radians, or with the unit of the page behind it: cg=0.16 or cg=16%, elevator=2deg; may
    /// be given again
    #[arg(long, value_name = "KEY=VALUE", value_parser = setting)]
    pub set: Vec<(String, f64)>,
    /// The notation of formulas, equations and scripts: w-v, or alpha-beta with α = w/V and β = v/V; numbers by their keys, JSON
    /// and CSV are of w and v always [default: that of the link, or w-v]
    #[arg(long, value_name = "NOTATION", value_parser = notation)]
    pub notation: Option<Notation>,
    /// Class of MIL-F-8785C that levels are judged for: I, II, II-C, III or IV [default: that of the link or of the aircraft's file]
    #[arg(long, value_name = "CLASS")]
    pub class: Option<String>,
    /// Category of flight phase that levels are judged for: A, A-combat, B or C
    #[arg(long, value_name = "CATEGORY")]
    pub category: Option<String>,
}

/// What a file doesn't say.
#[derive(Args)]
pub struct FillArguments {
    /// What the file doesn't say, by the keys that `read` tells: mass=1247, mass=2750lb, units=SI, case=3, states='u w q theta';
    /// =suggested takes what is likely, all=suggested all of that; may be given again
    #[arg(long = "fill", value_name = "KEY=VALUE", value_parser = fill)]
    pub fill: Vec<(String, String)>,
    /// AVL's mass file beside its derivatives
    #[arg(long, value_name = "FILE")]
    pub mass_file: Option<PathBuf>,
}

/// A disturbance, and how its motion is told.
#[derive(Args)]
pub struct DisturbanceArguments {
    /// longitudinal or lateral [default: that of the link or the disturbance]
    #[arg(long, value_name = "NAME")]
    pub plane: Option<String>,
    /// elevator, throttle, vertical-gust, head-gust, rudder, aileron, side-gust, turbulence, release or mode
    #[arg(long, value_name = "NAME")]
    pub disturbance: Option<String>,
    /// step, pulse, doublet, 3-2-1-1, sine or sweep; of a gust 1-cosine, step or sine
    #[arg(long, value_name = "NAME")]
    pub shape: Option<String>,
    /// The mode that is flown alone, by its key, such as "short-period", or its number
    #[arg(long, value_name = "NAME")]
    pub mode: Option<String>,
    /// Fly the same in six degrees of freedom, too, without linearising; =false where the link does
    #[arg(long, value_name = "BOOL", num_args = 0..=1, require_equals = true, default_missing_value = "true")]
    pub nonlinear: Option<bool>,
    /// Split every output into the parts of the modes; =false where the link does
    #[arg(long, value_name = "BOOL", num_args = 0..=1, require_equals = true, default_missing_value = "true")]
    pub split: Option<bool>,
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

#[derive(Args)]
pub struct TableUnits {
    /// Units of the tables, si or ft, which is feet and degrees; JSON and CSV are in SI and radians always [default: those of the
    /// link, or si]
    #[arg(long, value_name = "UNITS", value_parser = units, conflicts_with_all = ["json", "csv"])]
    units: Option<Units>,
}

impl TableUnits {
    /// The units of the table of a scene, which is told in them from now on.
    pub fn of(&self, scene: &mut Scene) -> ShownUnits {
        scene.scenario.units = self.units.unwrap_or(scene.scenario.units);
        ShownUnits::of(scene.scenario.units)
    }
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

fn units(text: &str) -> Result<Units, String> {
    Units::by_key(text).ok_or_else(|| "expected si or ft".to_owned())
}

fn notation(text: &str) -> Result<Notation, String> {
    Notation::by_key(text).ok_or_else(|| "expected w-v or alpha-beta".to_owned())
}

fn fill(text: &str) -> Result<(String, String), String> {
    let (key, value) = text.split_once('=').ok_or("expected KEY=VALUE")?;
    Ok((key.trim().to_owned(), value.trim().to_owned()))
}

fn setting(text: &str) -> Result<(String, f64), String> {
    let (key, value) = text.split_once('=').ok_or("expected KEY=VALUE")?;
    let (key, value) = (key.trim(), value.trim());
    // A key that isn't known is told with those that are like it, once the aircraft is.
    let dimension = Parameter::find(key).map_or(Dimension::Number, |parameter| parameter.dimension);
    let value = dimension.read(value).ok_or_else(|| format!("\"{value}\" is not a number"))?;
    Ok((key.to_owned(), value))
}
