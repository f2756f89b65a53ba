//! What follows when something happens to an element.

use egui::accesskit::{Action, ActionData};

use crate::kind::Kind;

/// Something that happened to an element, as far as anything follows from it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Happened<'a> {
    /// It has got the browser's focus.
    FocusIn,
    /// It has lost it.
    FocusOut,
    /// It was clicked, or a screen reader's equal of that.
    Click,
    /// Its value is now this.
    Input(&'a str),
    /// The browser takes its value for final.
    Change,
    /// This key went down on it.
    KeyDown(&'a str),
    /// This key came up on it.
    KeyUp(&'a str),
}

/// What follows from it.
#[derive(Clone, Debug, PartialEq)]
pub enum Answer {
    /// Nothing.
    Nothing,
    /// The element has no use for the key, so egui gets it.
    Key,
    /// As Enter or Tab would do in egui: what was typed counts from here.
    Done,
    /// Somebody types what is no value yet.
    Typing,
    /// egui is asked for this.
    Ask(Action, Option<ActionData>),
}

/// What follows when this happens to an element of this kind; `focusable` is whether egui can focus its widget, `with_shift`
/// whether the Shift key is down.
pub fn answer(kind: Kind, focusable: bool, with_shift: bool, happened: Happened<'_>) -> Answer {
    match (happened, kind) {
        (Happened::KeyDown(key) | Happened::KeyUp(key), _) if !kind.uses_key(key) => Answer::Key,
        (Happened::FocusOut, _) => Answer::Done,
        (Happened::Change | Happened::KeyDown("Enter"), kind) if kind.is_typed() => Answer::Done,
        (Happened::FocusIn, _) if focusable => Answer::Ask(Action::Focus, None),
        (Happened::Click, kind) if kind.is_pressed() => Answer::Ask(Action::Click, None),
        // The widget knows its steps, and what they are with Shift; the browser would take a hundredth of the range.
        (Happened::KeyDown(key), Kind::Slider) if key.starts_with("Arrow") && with_shift => Answer::Key,
        (Happened::KeyDown("ArrowRight" | "ArrowUp"), Kind::Slider) => Answer::Ask(Action::Increment, None),
        (Happened::KeyDown("ArrowLeft" | "ArrowDown"), Kind::Slider) => Answer::Ask(Action::Decrement, None),
        (Happened::Input(text), Kind::Slider | Kind::SpinButton) => match number(text) {
            Some(number) => Answer::Ask(Action::SetValue, Some(ActionData::NumericValue(number))),
            None => Answer::Typing,
        },
        (Happened::Input(text), Kind::Text) => {
            Answer::Ask(Action::SetValue, Some(ActionData::Value(text.into())))
        }
        _ => Answer::Nothing,
    }
}

/// What a person typed: `−0.68`, or `42.5 kg` with its unit.
fn number(typed: &str) -> Option<f64> {
    typed.split_whitespace().next()?.replace('−', "-").parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn set(number: f64) -> Answer {
        Answer::Ask(Action::SetValue, Some(ActionData::NumericValue(number)))
    }

    #[test]
    fn a_number_is_read_with_its_unit_and_a_true_minus() {
        for (typed, value) in [("60", 60.0), ("−0.68", -0.68), (" 42.5 kg", 42.5), ("1e-3", 1e-3)] {
            assert_eq!(answer(Kind::SpinButton, true, false, Happened::Input(typed)), set(value), "{typed}");
        }
        for typed in ["", "−", "kg", "1,5"] {
            assert_eq!(
                answer(Kind::SpinButton, true, false, Happened::Input(typed)),
                Answer::Typing,
                "{typed}"
            );
        }
    }

    #[test]
    fn an_arrow_on_a_slider_is_a_step_of_the_widget() {
        for (key, action) in [
            ("ArrowRight", Action::Increment),
            ("ArrowUp", Action::Increment),
            ("ArrowLeft", Action::Decrement),
            ("ArrowDown", Action::Decrement),
        ] {
            let asked = answer(Kind::Slider, true, false, Happened::KeyDown(key));
            assert_eq!(asked, Answer::Ask(action, None), "{key}");
            assert_eq!(answer(Kind::Slider, true, false, Happened::KeyUp(key)), Answer::Nothing, "{key}");
        }
        // A longer step is the widget's own.
        let asked = answer(Kind::Slider, true, true, Happened::KeyDown("ArrowRight"));
        assert_eq!(asked, Answer::Key);
        // The browser's own step, which it tells of as an input.
        assert_eq!(answer(Kind::Slider, true, false, Happened::KeyDown("Home")), Answer::Nothing);
        assert_eq!(answer(Kind::Slider, true, false, Happened::Input("20")), set(20.0));
    }

    #[test]
    fn a_key_without_a_use_here_is_the_canvas_s() {
        for (kind, key) in [(Kind::Text, "Tab"), (Kind::Slider, "z"), (Kind::Button, "ArrowLeft")] {
            assert_eq!(answer(kind, true, false, Happened::KeyDown(key)), Answer::Key, "{kind:?} {key}");
            assert_eq!(answer(kind, true, false, Happened::KeyUp(key)), Answer::Key, "{kind:?} {key}");
        }
        assert_eq!(answer(Kind::Text, true, false, Happened::KeyDown("z")), Answer::Nothing);
    }

    #[test]
    fn what_was_typed_counts_from_enter_and_from_when_the_field_is_left() {
        for happened in [Happened::KeyDown("Enter"), Happened::Change, Happened::FocusOut] {
            assert_eq!(answer(Kind::SpinButton, true, false, happened), Answer::Done, "{happened:?}");
        }
        assert_eq!(answer(Kind::CheckBox, true, false, Happened::Change), Answer::Nothing);
    }

    #[test]
    fn a_click_presses_what_can_be_pressed_and_nothing_else() {
        for kind in [Kind::Button, Kind::CheckBox, Kind::ComboBox, Kind::Item("option")] {
            let asked = answer(kind, true, false, Happened::Click);
            assert_eq!(asked, Answer::Ask(Action::Click, None), "{kind:?}");
        }
        for kind in [Kind::Slider, Kind::Words, Kind::Holder("region")] {
            assert_eq!(answer(kind, true, false, Happened::Click), Answer::Nothing, "{kind:?}");
        }
    }

    #[test]
    fn egui_focuses_what_it_can_focus() {
        let focus = |focusable| answer(Kind::Button, focusable, false, Happened::FocusIn);
        assert_eq!(focus(true), Answer::Ask(Action::Focus, None));
        assert_eq!(focus(false), Answer::Nothing);
    }

    #[test]
    fn text_is_handed_over_as_it_stands() {
        let asked = answer(Kind::Text, true, false, Happened::Input("B − 747"));
        assert_eq!(asked, Answer::Ask(Action::SetValue, Some(ActionData::Value("B − 747".into()))));
    }
}
