//! Builds, serves and tests the page: `cargo xtask --help`.

mod browser_tests;
mod chromium;
mod core_module;
mod crate_sizes;
mod finish_page;
mod layers;
mod licences;
mod packages;
mod page;
mod page_size;
mod process;
mod project;
mod stages;
mod tools;

use std::net::IpAddr;
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
    /// Run every check and test, stopping at the first failure
    Test,
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
        Task::Test => stages::run_all(&project),
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
