//! Eigenwing: how an aircraft moves when it is disturbed.
//!
//! ```text
//! assets/aircraft/*.toml ── content ──┐                       ┌─ poles, modes, responses, the aircraft in flight (`ui`)
//!                                     ▼                       │
//!           slider ───────────────► Scenario ──► Findings ────┼─ command line, JSON, JavaScript (`export`)
//!             ▲                    (document)    (derived)    │
//!             └──────────────── `ui`, once a frame ───────────┘
//! ```
//!
//! A [`Scenario`](scenario::Scenario) is plain data: what is studied. [`Findings`](findings::Findings) are everything that
//! follows from it, found by the functions of [`flight`] when they are first asked for, and read alike by everything on the right.
//! Nothing flows from right to left but edits of the scenario.
//!
//! | module | in one line | knows nothing of |
//! |---|---|---|
//! | [`number`] | numbers as a person reads them | everything |
//! | [`few`] | sorting of a few values, in few bytes | everything |
//! | [`key`] | names of values for programs: files, links, requests, answers | everything |
//! | [`flight`] | the mathematics: numbers in, numbers out | files, clock, egui, web, log, globals |
//! | [`shape`] | what an aircraft looks like: faces lofted from its geometry, in the order to draw them | files, colours, screens |
//! | [`content`] | the aircraft that ship with the page, read and checked once; files from elsewhere, reviewed before they are used | egui, web |
//! | [`scenario`] | what is being studied and how it is looked at, the one table of adjustable quantities, and the scene as a link | egui, web |
//! | [`findings`] | everything that follows from a scenario, each result found once | egui, web |
//! | [`words`] | sentences for what follows | egui, files |
//! | [`lesson`] | lessons: steps that ask before they show, goals on measures, and the check of a lesson | egui, files |
//! | [`export`] | what other programs ask and read, as JSON | egui |
//! | `ui` (feature `ui`) | one file for each thing on screen | how anything is computed |
//! | `web` (in a browser), `main.rs` (feature `app`) | a canvas, a window | how anything is computed or drawn |
//! | `bin/` (features `cli`, `javascript`) | the command line; the core as a JavaScript module | how anything is computed |
//!
//! A module may use those above it, never those below.
//!
//! # The Navion in ten lines
//!
//! ```
//! use eigenwing::content::embedded_aircraft;
//! use eigenwing::flight::modes::mode_name::ModeName;
//! use eigenwing::scenario::{Parameter, Scenario};
//!
//! let (aircraft, _) = embedded_aircraft();
//! let navion = aircraft.into_iter().find(|aircraft| aircraft.key == "navion").expect("it ships");
//! let mut scenario = Scenario::new(navion.into());
//! // Less stiff in pitch than the source's −0.683.
//! Parameter::find("cm_alpha").expect("a row of the table").set(&mut scenario, -0.5);
//! let analysis = scenario.analyse().expect("it flies");
//! let Some(Ok(longitudinal)) = &analysis.planes.longitudinal else { panic!("it has longitudinal data") };
//! let names: Vec<ModeName> = longitudinal.modes.iter().map(|mode| mode.naming.name).collect();
//! assert_eq!(names, [ModeName::ShortPeriod, ModeName::Phugoid]);
//! assert!(longitudinal.modes.iter().all(|mode| mode.lambda.re < 0.0));
//! ```

pub mod content;
pub mod export;
pub mod few;
pub mod findings;
pub mod flight;
pub mod key;
pub mod lesson;
pub mod number;
pub mod scenario;
pub mod shape;
#[cfg(feature = "ui")]
pub mod ui;
#[cfg(all(feature = "app", target_arch = "wasm32"))]
pub mod web;
pub mod words;
