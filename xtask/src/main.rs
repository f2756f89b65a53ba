//! Builds, serves and tests the page: `cargo xtask --help`.

mod browser_tests;
mod build_single;
mod chromium;
mod compress;
mod core_module;
mod crate_sizes;
mod debian;
mod files;
mod finish_page;
mod firefox;
mod fuzz;
mod layers;
mod licences;
mod offline;
mod package;
mod package_lesson;
mod packages;
mod page;
mod page_size;
mod process;
mod project;
mod scripts;
mod stages;
mod tools;
mod webkit;

use std::net::IpAddr;
use std::path::PathBuf;
use std::process::ExitCode;

use clap::{Parser, Subcommand};

use crate::project::Project;

#[derive(Parser)]
#[command(name = "cargo xtask", about = "Builds, serves and tests Eigenwing")]
struct Arguments {
    #[command(subcommand)]
    task: Task,
}

#[derive(Subcommand)]
enum Task {
    /// Build the release page and serve it, installing what is missing
    Serve {
        #[arg(long, default_value_t = 8080)]
        port: u16,
        #[arg(long, default_value = "127.0.0.1")]
        address: IpAddr,
    },
    /// Build the release page into dist/, installing what is missing
    Build,
    /// Put a lesson with the program and the course into a single .html, which opens without a server
    BuildSingle {
        /// The lesson, a Markdown file
        lesson: PathBuf,
    },
    /// Make a package of a lesson for a learning platform, by SCORM 1.2
    PackageLesson {
        /// The lesson, a Markdown file
        lesson: PathBuf,
    },
    /// Make the packages to publish: the core for npm, the command line with its manual and completions
    Package,
    /// Run every check and test, stopping at the first failure
    Test,
    /// Read bytes that nobody wrote as links, aircraft, matrices, lessons, reports, files of other programs and requests
    Fuzz {
        /// One of these; all without it
        target: Option<String>,
        /// How long each is read
        #[arg(long, default_value_t = 60)]
        seconds: u64,
    },
    /// Put random scenarios through the analysis, and report what came of them
    Soak {
        /// How many
        #[arg(default_value_t = 1_000_000)]
        scenarios: u64,
        #[arg(long, default_value_t = 1)]
        seed: u64,
    },
    /// Use the built page at random for a long time, and watch its memory
    SoakBrowser {
        #[arg(long, default_value_t = 60)]
        minutes: u32,
        #[arg(long, default_value_t = 1)]
        seed: u32,
    },
    /// Check licences, sources and duplicates of all dependencies with cargo-deny
    Deny,
    /// Complete a page that Trunk has just built; Trunk.toml calls this
    #[command(hide = true)]
    FinishPage,
}

fn main() -> ExitCode {
    let project = Project::find();
    let outcome = match Arguments::parse().task {
        Task::Serve { port, address } => page::serve(&project, address, port),
        Task::Build => page::build(&project),
        Task::BuildSingle { lesson } => build_single::build(&project, &lesson).map(|_| ()),
        Task::PackageLesson { lesson } => package_lesson::build(&project, &lesson).map(|_| ()),
        Task::Package => package::build(&project),
        Task::Test => stages::run_all(&project),
        Task::Fuzz { target, seconds } => fuzz::run(&project, target.as_deref(), seconds),
        Task::Soak { scenarios, seed } => fuzz::soak(&project, scenarios, seed),
        Task::SoakBrowser { minutes, seed } => browser_tests::soak(&project, minutes, seed),
        Task::Deny => licences::check(&project),
        Task::FinishPage => finish_page::finish(&project),
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::FAILURE
        }
    }
}
