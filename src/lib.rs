//! Eigenwing: how an aircraft moves when it is disturbed.
//!
//! ```text
//! assets/aircraft/*.toml ── content ──┐                               ┌─ pole map
//!                                     ▼                               ├─ mode cards
//!           slider ───────────────► Scenario ──► flight::analyse ─────┼─ responses
//!             ▲                    (edited)      (pure) = Analysis    └─ static and dynamic verdict
//!             └──────────────────────── ui, once a frame ─────────────────┘
//! ```
//!
//! | module | in one line | knows nothing of |
//! |---|---|---|
//! | [`number`] | numbers as a person reads them | everything |
//! | [`flight`] | the mathematics: numbers in, numbers out | files, clock, egui, web, log, globals |
//! | [`shape`] | what an aircraft looks like: faces lofted from its geometry, in the order to draw them | files, colours, screens |
//! | [`content`] | the aircraft that ship with the page, read and checked once; files from elsewhere, as text | egui, web |
//! | [`scenario`] | what is being studied, the one table of adjustable quantities, and the scene as a link | egui, web |
//! | [`words`] | sentences for what follows | egui, files |
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
pub mod flight;
pub mod number;
pub mod scenario;
pub mod shape;
#[cfg(feature = "ui")]
pub mod ui;
#[cfg(all(feature = "app", target_arch = "wasm32"))]
pub mod web;
pub mod words;
