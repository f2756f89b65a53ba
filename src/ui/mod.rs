//! What draws: egui only, neither a window nor a browser.

pub mod fonts;
pub mod symbol;
