//! Keys that are pressed while an element of the mirror has the browser's focus, as egui would have had them from the canvas.

use egui::{Event, Key, Modifiers};
use web_sys::KeyboardEvent;

/// Adds what egui is to hear of a key, and keeps the browser from doing with it what it would do with the page.
pub fn hear(key: &KeyboardEvent, events: &mut Vec<Event>) {
    let pressed = key.type_() == "keydown";
    let modifiers = Modifiers {
        alt: key.alt_key(),
        ctrl: key.ctrl_key(),
        shift: key.shift_key(),
        mac_cmd: key.meta_key(),
        command: key.ctrl_key() || key.meta_key(),
    };
    let name = key.key();
    // A letter has a name of one character, a key that writes nothing has a longer one.
    let writes = pressed && name.chars().count() == 1 && !modifiers.command && !modifiers.alt;
    if writes {
        events.push(Event::Text(name.clone()));
    }
    let physical_key = Key::from_name(&key.code());
    if let Some(key) = Key::from_name(&name).or(physical_key) {
        events.push(Event::Key { key, physical_key, pressed, repeat: false, modifiers });
    }
    let moves = matches!(name.as_str(), "Tab" | "Backspace") || name.starts_with("Arrow");
    if writes || moves {
        key.prevent_default();
    }
}
