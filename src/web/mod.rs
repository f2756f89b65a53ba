//! The browser's side: what a page needs that a window doesn't. It neither computes nor draws.

pub mod mirror;
