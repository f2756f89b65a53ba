//! What was done on the slides of a lecture, in the storage of the tab: who reloads the page in the middle of a lecture goes on with it.

use egui::Context;
use web_sys::Storage;

use crate::ui::App;

/// Names in the storage of the tab: what was done, and when the lecture began by the clock on the wall \[ms since 1970\].
const LECTURE: &str = "eigenwing.lecture";
const BEGAN: &str = "eigenwing.lecture-began";

/// The lecture as it is stored.
#[derive(Debug, Default)]
pub struct KeptLecture {
    storage: Option<Storage>,
    stored: String,
}

impl KeptLecture {
    /// Takes up what was done before the page was loaded again.
    pub fn start(app: &mut App) -> Self {
        // The storage of the tab, so that a lecture of last week is not gone on with.
        let storage = web_sys::window().and_then(|window| window.session_storage().ok().flatten());
        let item = |name| storage.as_ref().and_then(|storage| storage.get_item(name).ok().flatten());
        let began = item(BEGAN).and_then(|began| began.parse::<f64>().ok());
        // A clock that was set back says that it has yet to begin.
        let age = |began: f64| (1e-3 * (js_sys::Date::now() - began)).max(0.0);
        let taken_up =
            item(LECTURE).zip(began).filter(|(kept, began)| app.take_up_lecture(kept, age(*began)));
        let stored = taken_up.map(|(kept, _)| kept).unwrap_or_default();
        Self { storage, stored }
    }

    /// Stores what has been done in the lecture on screen, and when it began: as long ago as it has lasted, whatever has been done to the
    /// clock on the wall since.
    pub fn follow(&mut self, ctx: &Context, app: &App) {
        // A scene alone, or a lesson that is on its way, has nothing to be kept.
        let Some(lecture) = app.presentation().filter(|lecture| !lecture.address.is_empty()) else { return };
        let kept = lecture.kept();
        if kept == self.stored {
            return;
        }
        let began = js_sys::Date::now() - 1e3 * (ctx.input(|input| input.time) - lecture.started);
        if let Some(storage) = &self.storage {
            // Full or forbidden: it lasts as long as the page is open.
            let _ = storage.set_item(LECTURE, &kept);
            let _ = storage.set_item(BEGAN, &began.to_string());
        }
        self.stored = kept;
    }
}
