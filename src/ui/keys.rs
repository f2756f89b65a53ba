//! The keys of the page, in one table: what they do is read from here, and so is the sheet that lists them.

use egui::{Button, FontId, Grid, Key, Modal, Modifiers, Popup, RichText, ScrollArea, Ui};

use super::arrow_keys;
use super::curtain::Curtain;
use super::present;
use super::theme::{self, Palette};
use crate::key::Keyed as _;
use crate::scenario::view::Pane;
use crate::scenario::{Lock, Notation, Scenario, Units};
use crate::words;

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
    /// The sheet that makes a frame of the scene.
    Embed,
    /// The sheet that takes the scene along.
    TakeAlong,
    /// The scene as a page of paper.
    Print,
    /// What is under the pointer, copied.
    Copy,
    /// The sheet of a person's own aircraft.
    Import,
    /// Pin the state, or unpin it.
    Pin,
    /// Play the response, or pause.
    Play,
    /// A pane alone beside the sliders, or back.
    Maximise(Pane),
    /// Whatever is over the page, away.
    Restore,
    /// The scene fills the screen.
    Present,
    /// The next look.
    Look,
    /// The next units.
    Units,
    /// The other notation of the equations.
    Notation,
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
const SHORTCUTS: [Shortcut; 21] = [
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
    plain(Key::M, "M", Command::Embed, "Embed the scene in a page of yours"),
    plain(Key::X, "X", Command::TakeAlong, "Take the scene along: script, file, data, figure"),
    plain(Key::C, "C", Command::Copy, "Copy the number, table or curve under the pointer"),
    plain(Key::O, "O", Command::Import, "Open an aircraft of your own: a file, or matrices"),
    plain(Key::F, "F", Command::Present, "Present: the scene fills the screen, in large type"),
    plain(Key::T, "T", Command::Look, "Light, dark, projector"),
    plain(Key::U, "U", Command::Units, "Units: as in the source, metres, feet"),
    plain(Key::N, "N", Command::Notation, "Notation of the equations: w and v, or α and β"),
    control(Key::P, "Ctrl P", Command::Print, "Print the scene on a page of paper"),
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

/// What is wanted instead of the sheet of keys: what a phone has no room for in its bar.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wish {
    /// The lessons.
    Lessons,
    /// The sheet that takes the scene along.
    TakeAlong,
    /// The sheet of a person's own aircraft.
    Import,
}

/// The choice of a notation.
pub fn notation_ui(ui: &mut Ui, notation: &mut Notation, font: &FontId) {
    for other in Notation::VALUES {
        let name = RichText::new(words::view::notation(*other)).font(font.clone());
        let choice = ui.add(Button::selectable(*notation == *other, name));
        if choice.clicked() {
            *notation = *other;
        }
        choice.on_hover_text(words::view::NOTATION_MEANING);
    }
}

/// The sheet of all keys, over the page, with the choices of units and notation, for which a phone has no key. Says whether it is still wanted, and
/// what is wanted instead.
pub fn sheet_ui(ui: &Ui, scenario: &mut Scenario) -> (bool, Option<Wish>) {
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
        let room = ui.content_rect().height() - 200.0;
        ScrollArea::vertical().max_height(room).show(ui, |ui| {
            if by_finger {
                rows(ui, &mut BY_FINGER.into_iter());
                heading(ui, "Keys");
            }
            let mut keys = own.chain(OF_CONTROLS).chain(present::SHEET);
            if narrow {
                // What a key does stands below it.
                rows(ui, &mut keys);
            } else {
                Grid::new("keys").spacing([18.0, 1.0]).show(ui, |ui| rows(ui, &mut keys));
            }
        });
        ui.add_space(4.0);
        let note = "The scroll wheel never changes a number. On a Mac, Ctrl is the command key.";
        for note in [note, concat!("Eigenwing ", env!("CARGO_PKG_VERSION"))] {
            ui.label(RichText::new(note).font(theme::small()).color(palette.weak));
        }
        ui.add_space(4.0);
        ui.horizontal_wrapped(|ui| {
            ui.label("Units:");
            Curtain::of(ui).lock_ui(ui, Lock::View, |ui| {
                for other in Units::VALUES {
                    ui.selectable_value(&mut scenario.units, *other, words::view::units(*other));
                }
            });
        });
        ui.horizontal_wrapped(|ui| {
            ui.label("Equations in:").on_hover_text(words::view::NOTATION_MEANING);
            Curtain::of(ui)
                .lock_ui(ui, Lock::View, |ui| notation_ui(ui, &mut scenario.notation, &theme::body()));
        });
        ui.add_space(4.0);
        ui.horizontal_wrapped(|ui| {
            let close = ui.button("Close").clicked();
            let mut wish = None;
            if !Curtain::of(ui).keeps() {
                let ways = [
                    ("Lessons", Wish::Lessons),
                    ("Take along …", Wish::TakeAlong),
                    ("Own aircraft …", Wish::Import),
                ];
                for (text, way) in ways {
                    wish = ui.button(text).clicked().then_some(way).or(wish);
                }
            }
            (close, wish)
        })
        .inner
    });
    let (close, wish) = modal.inner;
    (!(close || wish.is_some() || modal.should_close()), wish)
}
