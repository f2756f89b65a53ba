//! What is on screen: one file for each thing. Views draw [`Findings`](crate::findings::Findings) and compute nothing; controls
//! edit the [`Scenario`](crate::scenario::Scenario) and the [`View`](crate::scenario::View) in place.

pub mod aircraft;
mod app;
mod arrow_keys;
mod chart;
mod copy;
mod curtain;
mod derivatives;
mod embed;
mod equations;
mod explanation;
mod feedback;
mod finger;
mod flight_pane;
mod follows;
mod fonts;
mod import;
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
mod present;
mod responses;
mod room;
mod share;
mod slider;
mod slider_search;
mod source_sheet;
mod symbol;
mod take_along;
mod theme;
mod top_bar;
mod why;

pub use app::{App, CoreRequest, FileRequest, OwnFile};
pub use look::Look;
pub use present::{Cue, Presentation};
