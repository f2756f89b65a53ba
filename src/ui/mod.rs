//! What is on screen: one file for each thing. Views read an [`Analysis`](crate::flight::Analysis) and never
//! compute one; controls edit the [`Scenario`](crate::scenario::Scenario) and nothing else.

pub mod aircraft;
mod app;
mod arrow_keys;
mod chart;
mod derivatives;
mod finger;
mod flight_pane;
mod fonts;
mod influence;
mod kept;
mod keys;
mod labels;
mod mode_cards;
mod number_field;
mod palette;
mod phasors;
mod poles;
mod responses;
mod share;
mod slider;
mod symbol;
mod theme;
mod top_bar;

pub use app::App;
