//! The aircraft pane: the aircraft in flight over the ground, what acts on it, and the controls of its playback.
//!
//! [`Picture`] says what to draw at one moment; [`AircraftView`] draws it and keeps how a person looks at it. Neither
//! knows where the motion comes from. A playback's time is the only clock, and its caller's.

mod airframe;
mod arrows;
mod camera;
mod labels;
mod landscape;
mod overlays;
mod picture;
mod playback;
mod transport;
mod turn;
mod view;

pub use picture::{Attitude, Axis, Figures, Forces, Moment, Picture};
pub use playback::Playback;
pub use transport::{transport_height, transport_ui};
pub use turn::{turn_height, turn_ui};
pub use view::AircraftView;
