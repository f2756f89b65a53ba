//! What an element shows of a node, and what differs from one frame to the next.

use egui::accesskit::{Action, HasPopup, Node, Orientation, Toggled};

use crate::kind::Kind;

/// Id of the list that a combo box has opened; no two are open at once.
const LIST: &str = "mirror-list";

/// What an element shows of a node: all of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// Kind of the element.
    pub kind: Kind,
    /// Whether egui can focus it.
    pub focusable: bool,
    text: String,
    state: State,
    attributes: Vec<(&'static str, String)>,
    /// Left, top, width and height in CSS pixels.
    bounds: Option<[f64; 4]>,
}

/// Part of an element that a person changes in it; it isn't among its attributes.
#[derive(Clone, Debug, PartialEq)]
pub enum State {
    /// Nothing, or not known: the browser has changed it.
    None,
    /// Value of an input.
    Value(String),
    /// Tick of a check box or a radio button.
    Toggled(Toggled),
}

/// Something to be written.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Change<'a> {
    /// An attribute is no more.
    Remove(&'static str),
    /// An attribute has this value.
    Set(&'static str, &'a str),
    /// The text is this.
    Text(&'a str),
    /// The state is this.
    State(&'a State),
    /// A side of the bounds: its property, and CSS pixels.
    Side(&'static str, f64),
}

impl Picture {
    /// Picture of a new element.
    pub fn blank(kind: Kind) -> Self {
        Self {
            kind,
            focusable: false,
            text: String::new(),
            state: State::None,
            attributes: Vec::new(),
            bounds: None,
        }
    }

    /// Picture of a node inside a holder of this kind; `None` for nodes that only arrange others.
    pub fn of(node: &Node, holder: Option<Kind>, name: &str, zoom: f64) -> Option<Self> {
        let kind = Kind::of(node, holder, name)?;
        let value = node.value().unwrap_or_default();
        let text = match kind {
            Kind::Words | Kind::Heading(_) if name.is_empty() => value,
            Kind::ComboBox => value,
            kind if kind.is_named_by_text() => name,
            _ => "",
        };
        let state = match (kind, node.toggled()) {
            (Kind::Slider, _) => State::Value(node.numeric_value().unwrap_or_default().to_string()),
            (Kind::SpinButton | Kind::Text, _) => State::Value(value.to_owned()),
            (Kind::CheckBox | Kind::Radio, toggled) => State::Toggled(toggled.unwrap_or(Toggled::False)),
            _ => State::None,
        };
        let bounds = node.bounds().filter(|_| !kind.holds()).map(|bounds| {
            // Tenths of a pixel are enough, and don't tremble.
            [bounds.x0, bounds.y0, bounds.width(), bounds.height()]
                .map(|points| (points * zoom * 10.0).round() / 10.0)
        });
        Some(Self {
            kind,
            focusable: node.supports_action(Action::Focus),
            text: text.to_owned(),
            state,
            attributes: attributes(kind, node, name),
            bounds,
        })
    }

    /// What is to be written where the old picture was, in this order: a range takes no value outside its limits.
    pub fn changes_from<'a>(&'a self, old: &Self) -> Vec<Change<'a>> {
        let mut changes = Vec::new();
        let is_gone = |name: &&str| !self.attributes.iter().any(|(kept, _)| kept == name);
        changes.extend(old.attributes.iter().map(|&(name, _)| name).filter(is_gone).map(Change::Remove));
        let new = self.attributes.iter().filter(|attribute| !old.attributes.contains(attribute));
        changes.extend(new.map(|(name, value)| Change::Set(name, value)));
        if old.text != self.text {
            changes.push(Change::Text(&self.text));
        }
        if old.state != self.state {
            changes.push(Change::State(&self.state));
        }
        for (side, name) in ["left", "top", "width", "height"].into_iter().enumerate() {
            let [old, new] = [old, self].map(|picture| picture.bounds.map(|bounds| bounds[side]));
            if let Some(new) = new.filter(|_| old != new) {
                changes.push(Change::Side(name, new));
            }
        }
        changes
    }

    /// The browser has changed the element's own state: it is to be written again, whatever egui makes of it.
    pub fn forget_state(&mut self) {
        self.state = State::None;
    }

    /// Its name, and what it is or what it is set to.
    pub fn spoken(&self) -> (String, String) {
        let attribute =
            |name| self.attributes.iter().find(|(kept, _)| *kept == name).map(|(_, value)| value.clone());
        let name = attribute("aria-label").unwrap_or_else(|| self.text.clone());
        let value = match (&self.state, self.kind) {
            (State::Toggled(Toggled::True), _) => "checked".to_owned(),
            (State::Toggled(_), _) => "not checked".to_owned(),
            (State::Value(value), _) => attribute("aria-valuetext").unwrap_or_else(|| value.clone()),
            (State::None, Kind::ComboBox) => self.text.clone(),
            (State::None, Kind::Button) if attribute("aria-pressed").as_deref() == Some("true") => {
                "pressed".to_owned()
            }
            (State::None, Kind::Button) => "button".to_owned(),
            (State::None, _) => attribute("role").unwrap_or_default(),
        };
        (name, value)
    }
}

fn attributes(kind: Kind, node: &Node, name: &str) -> Vec<(&'static str, String)> {
    let mut list = Vec::new();
    let mut put = |attribute, value: &str| list.push((attribute, value.to_owned()));
    if let Some(input_type) = kind.input_type() {
        put("type", input_type);
    }
    if let Some(role) = kind.role() {
        put("role", role);
    }
    if kind == Kind::Holder("listbox") {
        put("id", LIST);
    }
    if kind.holds() {
        put("data-holds", "");
    } else if kind.is_pressed() || kind.input_type().is_some() {
        put("tabindex", "-1");
    }
    if !kind.is_named_by_text() && !name.is_empty() {
        put("aria-label", name);
    }
    // Often the tooltip, which is also what names it if nothing else does.
    if let Some(description) = node.description().filter(|description| *description != name) {
        put("aria-description", description);
    }
    if node.is_disabled() {
        put(if matches!(kind.tag(), "input" | "button") { "disabled" } else { "aria-disabled" }, "true");
    }
    let pressed = node.toggled().map(|toggled| if toggled == Toggled::True { "true" } else { "false" });
    match (kind, pressed) {
        (Kind::Button, Some(pressed)) => put("aria-pressed", pressed),
        (Kind::Item("option" | "tab"), pressed) => put("aria-selected", pressed.unwrap_or("false")),
        _ => {}
    }
    if kind == Kind::ComboBox {
        put("aria-haspopup", "listbox");
        if node.is_expanded() == Some(true) {
            put("aria-controls", LIST);
        }
    } else if let Some(popup) = node.has_popup() {
        put(
            "aria-haspopup",
            match popup {
                HasPopup::Menu => "menu",
                HasPopup::Listbox => "listbox",
                HasPopup::Tree => "tree",
                HasPopup::Grid => "grid",
                HasPopup::Dialog => "dialog",
            },
        );
    }
    // egui tells this of what folds; a combo box's user has to: `node.set_expanded(combo.inner.is_some())`.
    if let Some(expanded) = node.is_expanded() {
        put("aria-expanded", if expanded { "true" } else { "false" });
    }
    if let Some(orientation) = node.orientation() {
        put("aria-orientation", if orientation == Orientation::Vertical { "vertical" } else { "horizontal" });
    }
    if kind == Kind::Text
        && let Some(placeholder) = node.placeholder().filter(|placeholder| !placeholder.is_empty())
    {
        put("placeholder", placeholder);
    }
    if kind == Kind::Slider {
        // Any value may be read back and set, not just those on a grid.
        put("step", "any");
    }
    let (least, most, now) = match kind {
        Kind::Slider => ("min", "max", None),
        Kind::SpinButton | Kind::Other(_) => ("aria-valuemin", "aria-valuemax", Some("aria-valuenow")),
        _ => return list,
    };
    let numbers = [
        (Some(least), node.min_numeric_value()),
        (Some(most), node.max_numeric_value()),
        (now, node.numeric_value()),
    ];
    for (attribute, number) in numbers {
        if let (Some(attribute), Some(number)) = (attribute, number) {
            list.push((attribute, number.to_string()));
        }
    }
    if let Some(value) = node.value().filter(|value| !value.is_empty()) {
        list.push(("aria-valuetext", value.to_owned()));
    }
    list
}

#[cfg(test)]
mod tests {
    use egui::accesskit::{Rect, Role};

    use super::*;

    fn slider(value: f64) -> Node {
        let mut node = Node::new(Role::Slider);
        node.set_numeric_value(value);
        node.set_min_numeric_value(20.0);
        node.set_max_numeric_value(90.0);
        node.set_value(format!("{value} m/s"));
        node.set_bounds(Rect { x0: 10.0, y0: 20.0, x1: 110.04, y1: 40.0 });
        node
    }

    fn picture(node: &Node, name: &str) -> Picture {
        Picture::of(node, None, name, 1.0).expect("it shows something")
    }

    #[test]
    fn a_new_slider_is_written_with_its_limits_before_its_value() {
        let picture = picture(&slider(60.0), "Speed");
        let value = State::Value("60".to_owned());
        let changes = [
            Change::Set("type", "range"),
            Change::Set("tabindex", "-1"),
            Change::Set("aria-label", "Speed"),
            Change::Set("step", "any"),
            Change::Set("min", "20"),
            Change::Set("max", "90"),
            Change::Set("aria-valuetext", "60 m/s"),
            Change::State(&value),
            Change::Side("left", 10.0),
            Change::Side("top", 20.0),
            Change::Side("width", 100.0),
            Change::Side("height", 20.0),
        ];
        assert_eq!(picture.changes_from(&Picture::blank(Kind::Slider)), changes);
    }

    #[test]
    fn only_what_differs_is_written() {
        let [old, new] = [60.0, 61.0].map(|value| picture(&slider(value), "Speed"));
        assert_eq!(old.changes_from(&old), []);
        let value = State::Value("61".to_owned());
        let changes = [Change::Set("aria-valuetext", "61 m/s"), Change::State(&value)];
        assert_eq!(new.changes_from(&old), changes);
    }

    #[test]
    fn an_attribute_that_is_no_more_is_removed() {
        let mut node = Node::new(Role::Button);
        let enabled = picture(&node, "Undo");
        node.set_disabled();
        let disabled = picture(&node, "Undo");
        assert_eq!(disabled.changes_from(&enabled), [Change::Set("disabled", "true")]);
        assert_eq!(enabled.changes_from(&disabled), [Change::Remove("disabled")]);
    }

    #[test]
    fn a_state_that_was_forgotten_is_written_again() {
        let mut shown = picture(&slider(60.0), "Speed");
        shown.forget_state();
        let same = picture(&slider(60.0), "Speed");
        assert_eq!(same.changes_from(&shown), [Change::State(&State::Value("60".to_owned()))]);
    }

    #[test]
    fn bounds_are_in_css_pixels_to_a_tenth() {
        let picture = Picture::of(&slider(60.0), None, "Speed", 1.5).expect("it shows something");
        assert_eq!(picture.bounds, Some([15.0, 30.0, 150.1, 30.0]));
    }

    #[test]
    fn what_holds_others_has_no_bounds_of_its_own() {
        let mut node = Node::new(Role::Region);
        node.set_bounds(Rect { x0: 0.0, y0: 0.0, x1: 1.0, y1: 1.0 });
        assert_eq!(picture(&node, "Modes").bounds, None);
    }

    #[test]
    fn a_button_is_named_by_its_text_and_a_combo_box_shows_what_is_chosen() {
        assert_eq!(picture(&Node::new(Role::Button), "Undo").text, "Undo");
        let mut node = Node::new(Role::ComboBox);
        node.set_value("Navion");
        let picture = picture(&node, "Aircraft");
        assert_eq!(picture.text, "Navion");
        assert_eq!(picture.spoken(), ("Aircraft".to_owned(), "Navion".to_owned()));
    }

    #[test]
    fn a_combo_box_that_is_open_names_its_list() {
        let mut node = Node::new(Role::ComboBox);
        let controls =
            |node: &Node| picture(node, "Aircraft").attributes.contains(&("aria-controls", LIST.to_owned()));
        assert!(!controls(&node));
        node.set_expanded(true);
        assert!(controls(&node));
        assert!(picture(&Node::new(Role::ListBox), "Aircraft").attributes.contains(&("id", LIST.to_owned())));
    }

    #[test]
    fn a_tooltip_that_repeats_the_name_is_not_said_twice() {
        let described = |text: &str| {
            let mut node = Node::new(Role::Button);
            node.set_description(text);
            picture(&node, "Undo").attributes.contains(&("aria-description", text.to_owned()))
        };
        assert!(described("Takes back the last step"));
        assert!(!described("Undo"));
    }

    #[test]
    fn name_and_value_are_what_a_screen_reader_would_say() {
        let spoken = |role: Role, toggled: Option<Toggled>| {
            let mut node = Node::new(role);
            if let Some(toggled) = toggled {
                node.set_toggled(toggled);
            }
            picture(&node, "Wind").spoken().1
        };
        assert_eq!(spoken(Role::CheckBox, Some(Toggled::True)), "checked");
        assert_eq!(spoken(Role::CheckBox, None), "not checked");
        assert_eq!(spoken(Role::Button, None), "button");
        assert_eq!(spoken(Role::Button, Some(Toggled::True)), "pressed");
        assert_eq!(spoken(Role::Tab, None), "tab");
        assert_eq!(picture(&slider(60.0), "Speed").spoken().1, "60 m/s");
    }
}
