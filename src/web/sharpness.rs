//! The canvas held to the pixels of the screen.
//!
//! eframe sets its size by a `ResizeObserver`. That one is silent where only the pixels change, as on the way to another
//! screen, and where a browser's tools play a phone it tells of the pixels of the screen that is really there.

use wasm_bindgen::JsCast as _;
use web_sys::HtmlCanvasElement;

/// The browser rounds edges to pixels, so that it may have one more or less.
const ROUNDED: f64 = 1.5;

/// Mends the size of the canvas where it isn't that of its place on the screen; then the next frame is drawn in it.
pub fn keep(ctx: &egui::Context) {
    let Some(window) = web_sys::window() else { return };
    let canvas = window.document().and_then(|document| document.get_element_by_id(super::CANVAS));
    let Some(canvas) = canvas.and_then(|canvas| canvas.dyn_into::<HtmlCanvasElement>().ok()) else { return };
    let ratio = window.device_pixel_ratio();
    let wanted = [canvas.client_width(), canvas.client_height()].map(|size| f64::from(size) * ratio);
    let is = [canvas.width(), canvas.height()].map(f64::from);
    // A canvas that is nowhere, as in a hidden frame, has no size to keep.
    if wanted.into_iter().zip(is).any(|(wanted, is)| wanted >= 1.0 && (wanted - is).abs() > ROUNDED) {
        canvas.set_width(wanted[0].round() as u32);
        canvas.set_height(wanted[1].round() as u32);
        ctx.request_repaint();
    }
}
