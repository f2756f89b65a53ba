//! The keys of the page, in one table: what they do is read from here, and so is the sheet that lists them.

use egui::{Grid, Key, Modal, Modifiers, Popup, RichText, ScrollArea, Ui};

use super::arrow_keys;
use super::theme::{self, Palette};
use crate::scenario::view::Pane;

impl Pane {
    /// The key of the keyboard that maximises it, as shown.
    pub fn shortcut(self) -> &'static str {
        let of_pane = SHORTCUTS.iter().find(|shortcut| shortcut.command == Command::Maximise(self));
        of_pane.map_or("", |shortcut| shortcut.shown)
    }
}

/// What a key asks for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Command {
    /// Go back one step.
    Undo,
    /// Go forward one step.
    Redo,
    /// Copy the scene as a link.
    CopyLink,
    /// Pin the state, or unpin it.
    Pin,
    /// Play the response, or pause.
    Play,
    /// A pane alone beside the sliders, or back.
    Maximise(Pane),
    /// Whatever is over the page, away.
    Restore,
    /// The next look.
    Look,
    /// The sheet of keys.
    Help,
}

struct Shortcut {
    modifiers: Modifiers,
    key: Key,
    shown: &'static str,
    command: Command,
    text: &'static str,
}

const fn plain(key: Key, shown: &'static str, command: Command, text: &'static str) -> Shortcut {
    Shortcut { modifiers: Modifiers::NONE, key, shown, command, text }
}

const fn control(key: Key, shown: &'static str, command: Command, text: &'static str) -> Shortcut {
    Shortcut { modifiers: Modifiers::COMMAND, key, shown, command, text }
}

/// The longer combination of a key stands after the shorter: they are tried from the end.
const SHORTCUTS: [Shortcut; 13] = [
    control(Key::Z, "Ctrl Z", Command::Undo, "Undo; a whole drag is one step"),
    Shortcut {
        modifiers: Modifiers::COMMAND.plus(Modifiers::SHIFT),
        key: Key::Z,
        shown: "Ctrl Shift Z",
        command: Command::Redo,
        text: "Redo",
    },
    control(Key::Y, "Ctrl Y", Command::Redo, "Redo"),
    plain(Key::Space, "Space", Command::Play, "Play or pause the aircraft"),
    plain(Key::P, "P", Command::Maximise(Pane::Poles), "Maximise the pole map, or restore it"),
    plain(Key::A, "A", Command::Maximise(Pane::Aircraft), "Maximise the aircraft, or restore it"),
    plain(Key::R, "R", Command::Maximise(Pane::Response), "Maximise the response, or restore it"),
    plain(Key::E, "E", Command::Maximise(Pane::Equations), "The equations alone and large, or back"),
    plain(Key::Escape, "Esc", Command::Restore, "Restore the maximised pane"),
    plain(Key::G, "G", Command::Pin, "Pin this state, or unpin it"),
    plain(Key::L, "L", Command::CopyLink, "Copy the whole scene as a link"),
    plain(Key::T, "T", Command::Look, "Light, dark, projector"),
    plain(Key::Questionmark, "?", Command::Help, "This sheet"),
];

/// Keys that a control takes for itself while it has focus.
const OF_CONTROLS: [(&str, &str); 10] = [
    ("Tab, Shift Tab", "To the next control, and the one before"),
    ("← →", "On a slider: a fine step; with Shift ten times as far"),
    ("Home, End", "On a slider: to its ends"),
    ("Delete", "On a slider: back to its reference, as by double click"),
    ("/", "Find a derivative"),
    ("Enter", "In a field: take the number; Esc leaves it as it was"),
    ("Arrow keys", "On a pole: move it; on the aircraft: turn the camera"),
    ("+ −", "On the pole map and the aircraft: nearer, farther"),
    ("0, Home", "On the pole map: all poles in sight; 1 to 4 on the aircraft: standard views"),
    ("Double click", "On the heading of a pane: maximise it, or restore it"),
];

/// What fingers do, where there may be no keyboard.
const BY_FINGER: [(&str, &str); 7] = [
    ("Tap a symbol", "What it means, and how it moves the modes"),
    ("Hold", "On a button, a chip or a number: what it means"),
    ("Sideways", "On a slider or a plot: moves it; on the aircraft: turns it"),
    ("Up, down", "Scrolls, wherever the finger is"),
    ("On a pole", "Moves it, whichever way the finger goes; a tap tells of it"),
    ("Two fingers", "On the pole map or the aircraft: move it, nearer or farther"),
    ("Double tap", "On a slider: back to its reference"),
];

/// On a narrower page the sheet has one column.
const NARROW: f32 = 520.0;

/// What the person's keys ask for; nothing while they type in a field.
pub fn command(ui: &Ui) -> Option<Command> {
    let typing = ui.text_edit_focused();
    // Space presses the button that has focus. A slider, a pole or the aircraft has no use for it.
    let focused = ui.memory(|memory| memory.focused()).is_some_and(|id| !arrow_keys::are_of(ui, id));
    // Esc closes what is in front first.
    let listing = Popup::is_any_open(ui.ctx());
    ui.input_mut(|input| {
        SHORTCUTS.iter().rev().find_map(|shortcut| {
            // A field has its own undo.
            let taken =
                typing || (focused && shortcut.key == Key::Space) || (listing && shortcut.key == Key::Escape);
            // “?” is on another key of every keyboard, mostly with Shift; Esc is also a field's way to give up.
            let pressed = if matches!(shortcut.key, Key::Questionmark | Key::Escape) {
                !taken && input.key_pressed(shortcut.key)
            } else {
                !taken && input.consume_key(shortcut.modifiers, shortcut.key)
            };
            pressed.then_some(shortcut.command)
        })
    })
}

/// The sheet of all keys, over the page. Says whether it is still wanted, and whether the lessons are wanted instead.
pub fn sheet_ui(ui: &Ui) -> (bool, bool) {
    let palette = Palette::of(ui);
    let frame = egui::Frame::popup(ui.style()).inner_margin(16);
    let modal = Modal::new(egui::Id::unique("keys")).frame(frame).show(ui, |ui| {
        ui.set_max_width((ui.content_rect().width() - 64.0).min(460.0));
        let heading = |ui: &mut Ui, text: &str| {
            theme::heading(ui, RichText::new(text).heading().size(theme::sizes(ui).sheet), 2);
        };
        let by_finger = theme::is_for_fingers(ui);
        heading(ui, if by_finger { "By finger" } else { "Keys" });
        let own = SHORTCUTS.iter().map(|shortcut| (shortcut.shown, shortcut.text));
        let narrow = ui.content_rect().width() < NARROW;
        let rows = |ui: &mut Ui, rows: &mut dyn Iterator<Item = (&str, &str)>| {
            for (keys, text) in rows {
                ui.label(RichText::new(keys).font(theme::semibold(theme::sizes(ui).value)));
                ui.label(text);
                if narrow {
                    ui.add_space(4.0);
                } else {
                    ui.end_row();
                }
            }
        };
        // In a low window they scroll, between the heading and the button.
        let room = ui.content_rect().height() - 150.0;
        ScrollArea::vertical().max_height(room).show(ui, |ui| {
            if by_finger {
                rows(ui, &mut BY_FINGER.into_iter());
                heading(ui, "Keys");
            }
            let mut keys = own.chain(OF_CONTROLS);
            if narrow {
                // What a key does stands below it.
                rows(ui, &mut keys);
            } else {
                Grid::new("keys").spacing([18.0, 1.0]).show(ui, |ui| rows(ui, &mut keys));
            }
        });
        ui.add_space(4.0);
        let note = "The scroll wheel never changes a number. On a Mac, Ctrl is the command key.";
        ui.label(RichText::new(note).font(theme::small()).color(palette.weak));
        ui.add_space(4.0);
        ui.horizontal(|ui| {
            let close = ui.button("Close").clicked();
            // On a phone the bar has no room for it.
            (close, ui.button("Lessons").clicked())
        })
        .inner
    });
    let (close, lessons) = modal.inner;
    (!(close || lessons || modal.should_close()), lessons)
}
