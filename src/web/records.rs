//! What the person has done in their lessons and the aircraft they have brought, in the browser's storage, and whether they have been here before.

use std::cell::Cell;
use std::rc::Rc;

use egui::Context;
use wasm_bindgen::JsCast as _;
use wasm_bindgen::closure::Closure;
use web_sys::{Storage, StorageEvent};

use super::address::{host, storage};
use crate::ui::App;

/// Name of the records in the browser's storage.
const RECORDS: &str = "eigenwing.records";

/// Name of the person's own aircraft in the browser's storage.
const AIRCRAFT: &str = "eigenwing.aircraft";

/// Name of the mark that the line for a first visit was dismissed.
const GREETED: &str = "eigenwing.greeted";

/// Said once where the storage is full.
const FULL: &str =
    "This browser has no room to keep what you do here: save what you need before you leave the page";

/// The records as they are stored.
#[derive(Debug)]
pub struct KeptRecords {
    storage: Option<Storage>,
    records: Item,
    aircraft: Item,
    /// Whether another tab has stored records that nobody has taken up yet.
    heard: Rc<Cell<bool>>,
    /// Whether the line for a first visit is on screen.
    greets: bool,
    /// Whether it was said that the storage is full.
    is_full: bool,
}

/// One item of the storage.
#[derive(Debug)]
struct Item {
    name: &'static str,
    /// As this page last read or wrote it.
    known: Option<String>,
}

impl Item {
    const fn new(name: &'static str) -> Self {
        Self { name, known: None }
    }

    /// What was stored since by a page in another tab, or by the last visit, and what was known of before.
    fn of_others(&mut self, storage: &Storage) -> Option<[String; 2]> {
        let stored = storage.get_item(self.name).ok().flatten();
        if stored == self.known {
            return None;
        }
        let known = std::mem::replace(&mut self.known, stored.clone());
        Some([stored?, known.unwrap_or_default()])
    }

    /// Stores it, and says whether there was room.
    fn set(&mut self, storage: &Storage, text: String) -> bool {
        let is_stored = storage.set_item(self.name, &text).is_ok();
        if is_stored {
            self.known = Some(text);
        }
        is_stored
    }
}

impl KeptRecords {
    /// Takes up what was done before, and greets who hasn't been here. A page in a frame greets nobody: its host has its own words.
    pub fn start(ctx: &Context, app: &mut App) -> Self {
        let storage = web_sys::window().as_ref().and_then(storage);
        let (mut records, mut aircraft) = (Item::new(RECORDS), Item::new(AIRCRAFT));
        if let Some([stored, known]) = storage.as_ref().and_then(|storage| records.of_others(storage)) {
            app.take_up_records(&stored, &known);
        }
        if let Some([stored, known]) = storage.as_ref().and_then(|storage| aircraft.of_others(storage)) {
            app.take_up_aircraft(&stored, &known);
        }
        let is_greeted = |storage: &Storage| storage.get_item(GREETED).ok().flatten().is_some();
        let greets = host().is_none() && storage.as_ref().is_some_and(|storage| !is_greeted(storage));
        if greets {
            app.greet();
        }
        Self { storage, records, aircraft, heard: hear(ctx), greets, is_full: false }
    }

    /// Stores what has been done, beside what another tab has stored meanwhile, and that the line for a first visit was dismissed.
    pub fn follow(&mut self, ctx: &Context, app: &mut App) {
        let Some(storage) = &self.storage else { return };
        let mut has_room = true;
        let is_heard = self.heard.take();
        let mut is_wanted = app.take_changed_records().is_some();
        if (is_heard || is_wanted)
            && let Some([others, known]) = self.records.of_others(storage)
        {
            // Where both have written at the same moment, something of this page is missing there.
            is_wanted |= app.take_up_records(&others, &known);
            ctx.request_repaint();
        }
        if is_wanted {
            has_room &= self.records.set(storage, app.records_as_json());
        }
        if let Some(mut aircraft) = app.take_changed_aircraft() {
            if let Some([others, known]) = self.aircraft.of_others(storage) {
                app.take_up_aircraft(&others, &known);
                aircraft = app.take_changed_aircraft().unwrap_or(aircraft);
            }
            has_room &= self.aircraft.set(storage, aircraft);
        }
        if self.greets && !app.greets() {
            // Without room the next visit is greeted again.
            let _ = storage.set_item(GREETED, "yes");
            self.greets = false;
        }
        if !has_room && !self.is_full {
            self.is_full = true;
            app.tell(FULL);
            ctx.request_repaint();
        }
    }
}

/// Hears of records that another tab stores, with a frame to take them up.
fn hear(ctx: &Context) -> Rc<Cell<bool>> {
    let heard = Rc::<Cell<bool>>::default();
    let (hearing, ctx) = (heard.clone(), ctx.clone());
    let hear = Closure::<dyn FnMut(StorageEvent)>::new(move |event: StorageEvent| {
        if event.key().as_deref() == Some(RECORDS) {
            hearing.set(true);
            ctx.request_repaint();
        }
    });
    if let Some(window) = web_sys::window() {
        // A page that can't be told takes them up before it stores its own.
        let _ = window.add_event_listener_with_callback("storage", hear.into_js_value().unchecked_ref());
    }
    heard
}
