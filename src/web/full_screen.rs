//! The whole screen for a lecture, by the browser's own means. Esc leaves the full screen and the lecture, both at once.

use egui::Context;
use js_sys::{Function, Promise, Reflect};
use wasm_bindgen::JsCast as _;
use wasm_bindgen_futures::{JsFuture, spawn_local};
use web_sys::Document;

use super::address::host;
use crate::ui::App;

/// Whether a lecture is on, and whether it has the whole screen.
#[derive(Debug, Default)]
pub struct FullScreen {
    presents: bool,
    is_full: bool,
    /// Whether the browser wants a gesture first: the next key or click that a person presses is one.
    waits: bool,
}

impl FullScreen {
    /// Asks for the whole screen as a lecture begins, or with the first key where a link has begun it, gives it back as it ends, and ends it with the full screen. After a frame was drawn;
    /// the screen that becomes smaller brings one.
    pub fn follow(&mut self, ctx: &Context, app: &mut App) {
        let Some(document) = web_sys::window().and_then(|window| window.document()) else { return };
        let is_full = document.fullscreen_element().is_some();
        if self.is_full && !is_full && self.presents {
            app.end_lecture();
            ctx.request_repaint();
        }
        self.is_full = is_full;
        let presents = app.presentation().is_some();
        // The first gesture may be the one that ends the lecture.
        if self.waits {
            self.waits = !is_full && presents && !request(&document);
        }
        if presents == self.presents {
            return;
        }
        self.presents = presents;
        if presents {
            self.waits = !request(&document) && host().is_none();
        } else if is_full {
            self.is_full = false;
            document.exit_fullscreen();
        }
    }
}

/// Asks for the whole screen, and says whether it could. A browser grants it to a key or a click only, some never: then the lecture fills
/// the window.
fn request(document: &Document) -> bool {
    // Without a gesture, as where a link presents, a browser refuses and complains.
    let gesture = || {
        let navigator = web_sys::window()?.navigator();
        let activation = Reflect::get(&navigator, &"userActivation".into()).ok()?;
        Reflect::get(&activation, &"isActive".into()).ok()?.as_bool()
    };
    if gesture() == Some(false) {
        return false;
    }
    let Some(page) = document.document_element() else { return true };
    let request =
        Reflect::get(&page, &"requestFullscreen".into()).ok().and_then(|f| f.dyn_into::<Function>().ok());
    let asked = request.and_then(|request| request.call0(&page).ok());
    if let Some(promise) = asked.and_then(|asked| asked.dyn_into::<Promise>().ok()) {
        spawn_local(async move {
            // Refused without a gesture.
            let _ = JsFuture::from(promise).await;
        });
    }
    true
}
