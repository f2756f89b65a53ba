//! Keys that are pressed while an element of the mirror has the browser's focus, as egui would have had them from the canvas.

use egui::{Event, Key, Modifiers};

/// A key that went down or came up.
#[derive(Clone, Debug)]
pub struct KeyStroke {
    /// Its name with the layout and the modifiers: `a`, `A`, `Tab`.
    pub name: String,
    /// Its name by its place on the keyboard: `KeyA`.
    pub code: String,
    /// Whether it went down.
    pub pressed: bool,
    /// The modifiers that were down with it.
    pub modifiers: Modifiers,
}

impl KeyStroke {
    /// What egui is to hear of it.
    pub fn events(&self) -> Vec<Event> {
        let text = self.writes().then(|| Event::Text(self.name.clone()));
        let physical_key = Key::from_name(&self.code);
        let key = Key::from_name(&self.name).or(physical_key);
        let (pressed, modifiers) = (self.pressed, self.modifiers);
        let stroke = key.map(|key| Event::Key { key, physical_key, pressed, repeat: false, modifiers });
        text.into_iter().chain(stroke).collect()
    }

    /// Whether the browser would do something with the page that egui is to do with the canvas.
    pub fn is_kept_from_the_page(&self) -> bool {
        self.writes() || matches!(self.name.as_str(), "Tab" | "Backspace") || self.name.starts_with("Arrow")
    }

    /// A letter has a name of one character, a key that writes nothing has a longer one.
    fn writes(&self) -> bool {
        self.pressed && self.name.chars().count() == 1 && !self.modifiers.command && !self.modifiers.alt
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn down(name: &str, code: &str, modifiers: Modifiers) -> KeyStroke {
        KeyStroke { name: name.to_owned(), code: code.to_owned(), pressed: true, modifiers }
    }

    fn key(key: Key, pressed: bool, modifiers: Modifiers) -> Event {
        Event::Key { key, physical_key: Some(key), pressed, repeat: false, modifiers }
    }

    #[test]
    fn a_letter_is_text_and_a_key() {
        let stroke = down("z", "KeyZ", Modifiers::NONE);
        assert_eq!(stroke.events(), [Event::Text("z".to_owned()), key(Key::Z, true, Modifiers::NONE)]);
        assert!(stroke.is_kept_from_the_page());
    }

    #[test]
    fn a_command_writes_nothing_and_stays_the_browser_s_too() {
        let stroke = down("z", "KeyZ", Modifiers::COMMAND);
        assert_eq!(stroke.events(), [key(Key::Z, true, Modifiers::COMMAND)]);
        assert!(!stroke.is_kept_from_the_page());
    }

    #[test]
    fn a_key_that_comes_up_writes_nothing() {
        let stroke = KeyStroke { pressed: false, ..down("z", "KeyZ", Modifiers::NONE) };
        assert_eq!(stroke.events(), [key(Key::Z, false, Modifiers::NONE)]);
    }

    #[test]
    fn keys_that_move_would_scroll_the_page_or_leave_it() {
        for (name, egui_key) in
            [("Tab", Key::Tab), ("ArrowDown", Key::ArrowDown), ("Backspace", Key::Backspace)]
        {
            let stroke = down(name, name, Modifiers::NONE);
            assert_eq!(stroke.events(), [key(egui_key, true, Modifiers::NONE)]);
            assert!(stroke.is_kept_from_the_page(), "{name}");
        }
        assert!(!down("F5", "F5", Modifiers::NONE).is_kept_from_the_page());
    }

    #[test]
    fn a_letter_that_egui_has_no_key_for_is_the_key_of_its_place() {
        let events = down("ж", "Semicolon", Modifiers::NONE).events();
        assert_eq!(events[1], key(Key::Semicolon, true, Modifiers::NONE));
    }
}
