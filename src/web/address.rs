//! The scene in the address bar and in the browser's storage, and what comes from there.
//!
//! The fragment follows the scene once an edit has ended, never while something is dragged. It is replaced, not pushed: *back*
//! leaves the page, undo is the page's own. Until the first edit it stays as the sender wrote it, with what this version left out.

use egui::Ui;
use wasm_bindgen::JsValue;
use web_sys::{Storage, Window};

use crate::ui::App;

/// Least time between two writings \[s\]; browsers forbid more than about three a second.
const INTERVAL: f64 = 0.5;

/// Name of the last scene in the browser's storage.
const LAST_SCENE: &str = "eigenwing.last-scene";

/// The state of the address bar.
#[derive(Debug, Default)]
pub struct AddressBar {
    /// The fragment as it was last read or written, with its `#`.
    fragment: String,
    /// The link of the scene that stands there.
    link: String,
    /// When the scene was last written, in egui's time \[s\].
    written: f64,
}

impl AddressBar {
    /// Opens the scene of the fragment, or else the one of the last visit.
    pub fn start(app: &mut App) -> Self {
        let Some(window) = web_sys::window() else { return Self::default() };
        let fragment = fragment(&window);
        let address = window.location().href().unwrap_or_default();
        let address = address.split('#').next().unwrap_or_default();
        app.set_address(address.to_owned());
        let mut bar = Self { fragment, ..Self::default() };
        if bar.fragment.len() > 1 {
            app.open(&bar.fragment);
            keep(&window, &app.link());
        } else if let Some(last) = last_scene(&window) {
            app.open(&last);
            bar.write(&window, app.link());
        }
        bar.link = app.link();
        bar
    }

    /// Opens a fragment that has come into the address bar. Before a frame is drawn.
    pub fn read(&mut self, app: &mut App) {
        let Some(window) = web_sys::window() else { return };
        let fragment = fragment(&window);
        if fragment != self.fragment {
            app.open(&fragment);
            self.link = app.link();
            keep(&window, &self.link);
            self.fragment = fragment;
        }
    }

    /// Writes the scene if it has changed. After a frame was drawn; asks for another only where there is something to write.
    pub fn follow(&mut self, ui: &Ui, app: &App) {
        let (now, dragging) = ui.input(|input| (input.time, input.pointer.any_down()));
        if dragging {
            // The frame of the release comes here again.
            return;
        }
        let link = app.link();
        if link == self.link {
            return;
        }
        let wait = self.written + INTERVAL - now;
        if wait > 0.0 {
            ui.request_repaint_after_secs(wait as f32);
        } else if let Some(window) = web_sys::window() {
            self.written = now;
            self.write(&window, link);
        }
    }

    fn write(&mut self, window: &Window, link: String) {
        let replaced = window.history().and_then(|history| {
            history.replace_state_with_url(&JsValue::NULL, "", Some(&format!("#{link}")))
        });
        // Some browsers forbid it to a page in a frame: then the address stays as it is, and nothing else is lost.
        if replaced.is_ok() {
            self.fragment = fragment(window);
        }
        keep(window, &link);
        self.link = link;
    }
}

fn fragment(window: &Window) -> String {
    window.location().hash().unwrap_or_default()
}

/// The window of the page around this one, where it stands in a frame.
pub(super) fn host() -> Option<Window> {
    let window = web_sys::window()?;
    let parent = window.parent().ok().flatten()?;
    (!js_sys::Object::is(&parent, &window)).then_some(parent)
}

/// A browser may forbid storage, or have none left.
pub(super) fn storage(window: &Window) -> Option<Storage> {
    window.local_storage().ok().flatten()
}

fn last_scene(window: &Window) -> Option<String> {
    storage(window)?.get_item(LAST_SCENE).ok().flatten()
}

fn keep(window: &Window, link: &str) {
    if let Some(storage) = storage(window) {
        // Full or forbidden: the scene is still in the address bar.
        let _ = storage.set_item(LAST_SCENE, link);
    }
}
