//! The keys of a presenter, in one place, and those that clickers send. They are taken before anything else of a frame sees them, so
//! that none of them moves a slider, a pole or the aircraft that has the focus.

use egui::{Event, FocusDirection, Key, Modifiers, Popup, Ui};

/// What a key asks for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stroke {
    /// The answer, or the next slide.
    Next,
    /// The slide before.
    Back,
    /// The first slide.
    First,
    /// The last slide.
    Last,
    /// A black screen.
    Blank,
    /// Names and numbers hidden or shown.
    Veil,
    /// What is under the pointer larger, or all again.
    Magnify,
    /// Play the motion, or pause.
    Play,
    /// Why the wrong choices are wrong.
    Reasons,
    /// One hand for a choice, counted from 0, or one less.
    Hand {
        /// The choice.
        choice: usize,
        /// Whether it is one more.
        adds: bool,
    },
    /// No hands for the question.
    NoHands,
    /// The time since the start, or no longer.
    Clock,
    /// The scene of the slide as it was at its start.
    Again,
    /// The notes.
    Notes,
    /// Back to the workbench.
    Leave,
}

/// Keys and what they do, for the sheet of keys.
pub const SHEET: [(&str, &str); 13] = [
    ("Page Down → ↓ Space", "Presenting: the answer, then the next slide"),
    ("Page Up ← ↑", "The slide before, as it was left; Home and End: the first and the last"),
    ("B .", "A black screen; any key brings the slide back"),
    ("H", "Names and numbers hidden, or shown"),
    ("S", "While it is held, a spotlight at the pointer"),
    ("Z", "Twice as large about the pointer, or all again"),
    ("P", "Play the motion, or pause"),
    ("1 to 9", "One hand for a choice, with Shift one less; 0: none"),
    ("W", "Why the wrong choices are wrong"),
    ("R", "The scene of the slide again as it was at its start"),
    ("C", "The minutes since the start"),
    ("N", "The notes, in a window of their own"),
    ("Esc", "Back to the workbench, with the scene as it stands"),
];

/// What a key asks for while a scene is presented.
fn stroke(key: Key, physical: Option<Key>, modifiers: Modifiers) -> Option<Stroke> {
    // Where figures stand on the keyboard, whatever Shift makes of them.
    let figure = [physical, Some(key)].into_iter().flatten().find_map(figure);
    if let Some(figure) = figure {
        return Some(match figure.checked_sub(1) {
            Some(choice) => Stroke::Hand { choice, adds: !modifiers.shift },
            None => Stroke::NoHands,
        });
    }
    Some(match key {
        Key::PageDown | Key::ArrowRight | Key::ArrowDown | Key::Space | Key::Enter => Stroke::Next,
        Key::PageUp | Key::ArrowLeft | Key::ArrowUp | Key::Backspace => Stroke::Back,
        Key::Home => Stroke::First,
        Key::End => Stroke::Last,
        Key::B | Key::Period => Stroke::Blank,
        Key::H => Stroke::Veil,
        Key::Z => Stroke::Magnify,
        Key::P => Stroke::Play,
        Key::W => Stroke::Reasons,
        Key::C => Stroke::Clock,
        Key::R => Stroke::Again,
        Key::N => Stroke::Notes,
        Key::Escape | Key::F => Stroke::Leave,
        _ => return None,
    })
}

fn figure(key: Key) -> Option<usize> {
    const FIGURES: [Key; 10] = [
        Key::Num0,
        Key::Num1,
        Key::Num2,
        Key::Num3,
        Key::Num4,
        Key::Num5,
        Key::Num6,
        Key::Num7,
        Key::Num8,
        Key::Num9,
    ];
    FIGURES.iter().position(|figure| *figure == key)
}

/// Takes the keys of a presenter out of the input, and says what they ask for, in order. A key that is held asks once.
///
/// While a person types a number, only the keys of a clicker are taken. Under a sheet none is, so that Escape closes it.
pub fn strokes(ui: &Ui, (is_blank, is_covered): (bool, bool)) -> Vec<Stroke> {
    let types = ui.text_edit_focused();
    if !is_blank && (is_covered || Popup::is_any_open(ui.ctx())) {
        return Vec::new();
    }
    let mut asked = Vec::new();
    ui.input_mut(|input| {
        input.events.retain(|event| {
            let Event::Key { key, physical_key, pressed, repeat, modifiers } = event else {
                // The letter of a key that is taken types nothing.
                return types || !matches!(event, Event::Text(_));
            };
            let is_plain = !(modifiers.command || modifiers.ctrl || modifiers.alt);
            let is_press = *pressed && !*repeat;
            if is_blank && is_plain {
                // Any key brings the slide back, and does nothing else.
                if is_press && asked.is_empty() {
                    asked.push(Stroke::Blank);
                }
                return false;
            }
            let stroke = stroke(*key, *physical_key, *modifiers).filter(|_| is_plain);
            let stroke = stroke.filter(|_| !types || matches!(key, Key::PageDown | Key::PageUp));
            if is_press {
                asked.extend(stroke);
            }
            // The key of the spotlight is only held.
            stroke.is_none() && (*key != Key::S || !is_plain)
        });
    });
    if !asked.is_empty() {
        // egui has noted by now where an arrow key would bring the focus.
        ui.memory_mut(|memory| memory.move_focus(FocusDirection::None));
    }
    asked
}
