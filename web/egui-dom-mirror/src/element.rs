//! An element of the page, and what it shows.

use egui::accesskit::{NodeId, Toggled};
use wasm_bindgen::JsCast as _;
use web_sys::{Document, Element, HtmlElement, HtmlInputElement};

use crate::picture::{Change, Picture, State};

/// An element and what it shows.
pub struct Shown {
    /// The element.
    pub element: Element,
    /// Picture as last written.
    pub picture: Picture,
    /// What stands in it, in order.
    pub children: Vec<NodeId>,
    /// Whether somebody is typing into it: until they are done its text is theirs.
    typing: bool,
}

impl Shown {
    /// A new element, not yet in its place.
    pub fn new(document: &Document, id: NodeId, picture: Picture) -> Option<Self> {
        let element = document.create_element(picture.kind.tag()).ok()?;
        set(&element, "data-id", &id.0.to_string());
        let blank = Picture::blank(picture.kind);
        let mut shown = Self { element, picture: blank, children: Vec::new(), typing: false };
        shown.update(picture);
        Some(shown)
    }

    /// Writes what differs.
    pub fn update(&mut self, picture: Picture) {
        for change in picture.changes_from(&self.picture) {
            self.write(change);
        }
        self.picture = picture;
    }

    fn write(&self, change: Change<'_>) {
        match change {
            Change::Remove(name) => {
                // Only a name that isn't one could fail.
                let _ = self.element.remove_attribute(name);
            }
            Change::Set(name, value) => set(&self.element, name, value),
            Change::Text(text) => self.element.set_text_content(Some(text)),
            Change::State(state) if !self.typing => self.write_state(state),
            Change::State(_) => {}
            Change::Side(name, pixels) => {
                if let Some(element) = self.element.dyn_ref::<HtmlElement>() {
                    // Only a property that isn't one could fail.
                    let _ = element.style().set_property(name, &format!("{pixels}px"));
                }
            }
        }
    }

    fn write_state(&self, state: &State) {
        let Some(input) = self.element.dyn_ref::<HtmlInputElement>() else { return };
        match state {
            State::Value(value) => input.set_value(value),
            State::Toggled(toggled) => {
                input.set_checked(*toggled == Toggled::True);
                input.set_indeterminate(*toggled == Toggled::Mixed);
            }
            State::None => {}
        }
    }

    /// The browser has changed the element's own state: it is to be written again, whatever egui makes of it.
    pub fn forget_state(&mut self) {
        self.picture.forget_state();
    }

    /// From now on its text is not written.
    pub fn begin_typing(&mut self) {
        self.typing = true;
    }

    /// Its text is written again, whatever egui made of it.
    pub fn finish_typing(&mut self) {
        self.typing = false;
        self.forget_state();
    }
}

fn set(element: &Element, name: &str, value: &str) {
    // Only a name that isn't one could fail.
    let _ = element.set_attribute(name, value);
}
