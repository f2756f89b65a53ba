//! What the person has done in their lessons, in the browser's storage, and whether they have been here before.

use web_sys::Storage;

use super::address::storage;
use crate::ui::App;

/// Name of the records in the browser's storage.
const RECORDS: &str = "eigenwing.records";

/// Name of the mark that the line for a first visit was dismissed.
const GREETED: &str = "eigenwing.greeted";

/// The records as they are stored.
#[derive(Debug)]
pub struct KeptRecords {
    storage: Option<Storage>,
    /// Whether the line for a first visit is on screen.
    greets: bool,
}

impl KeptRecords {
    /// Takes up what was done before, and greets who hasn't been here. A page in a frame greets nobody: its host has its own words.
    pub fn start(app: &mut App) -> Self {
        let window = web_sys::window();
        let storage = window.as_ref().and_then(storage);
        let stored = |name| storage.as_ref().and_then(|storage| storage.get_item(name).ok().flatten());
        if let Some(records) = stored(RECORDS) {
            app.take_up_records(&records);
        }
        let is_alone = window.is_some_and(|window| {
            let parent = window.parent().ok().flatten();
            parent.is_some_and(|parent| js_sys::Object::is(&parent, &window))
        });
        let greets = is_alone && storage.is_some() && stored(GREETED).is_none();
        if greets {
            app.greet();
        }
        Self { storage, greets }
    }

    /// Stores what has been done, and that the line for a first visit was dismissed.
    pub fn follow(&mut self, app: &mut App) {
        let set = |name, text: &str| {
            if let Some(storage) = &self.storage {
                // Full or forbidden: it lasts as long as the page is open.
                let _ = storage.set_item(name, text);
            }
        };
        if let Some(records) = app.take_changed_records() {
            set(RECORDS, &records);
        }
        if self.greets && !app.greets() {
            set(GREETED, "yes");
            self.greets = false;
        }
    }
}
