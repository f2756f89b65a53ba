//! What is on screen: one file for each thing. Views draw [`Findings`](crate::findings::Findings) and compute nothing; controls
//! edit the [`Scenario`](crate::scenario::Scenario) and the [`View`](crate::scenario::View) in place.

pub mod aircraft;
mod app;
mod arrow_keys;
mod chart;
mod curtain;
mod derivatives;
mod equations;
mod finger;
mod flight_pane;
mod fonts;
mod influence;
mod kept;
mod keys;
mod labels;
mod lesson;
mod look;
mod mode_cards;
mod number_field;
mod overall_level;
mod palette;
mod phasors;
mod poles;
mod responses;
mod share;
mod slider;
mod slider_search;
mod source_sheet;
mod symbol;
mod theme;
mod top_bar;
mod why;

pub use app::{App, FileRequest};
pub use look::Look;
