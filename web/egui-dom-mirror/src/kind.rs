//! Roles of nodes as elements of a page.

use egui::accesskit::{Action, Node, Role};

/// Kind of an element, as far as its tag and its events go.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A value on a range.
    Slider,
    /// A number to type.
    SpinButton,
    /// Text to type.
    Text,
    /// Ticked or not.
    CheckBox,
    /// One of several.
    Radio,
    /// Does something.
    Button,
    /// A button that opens a list and shows what is chosen in it.
    ComboBox,
    /// One of a list, a menu or a row of tabs, with this ARIA role.
    Item(&'static str),
    /// A heading of this level.
    Heading(usize),
    /// Words.
    Words,
    /// Something else with a name and this ARIA role: a picture, a bar that fills.
    Other(&'static str),
    /// Holds others, with this ARIA role.
    Holder(&'static str),
}

impl Kind {
    /// Kind of a node inside a holder of this kind; `None` for one that only arranges others.
    pub fn of(node: &Node, holder: Option<Self>, name: &str) -> Option<Self> {
        Some(match node.role() {
            Role::Slider => Self::Slider,
            Role::SpinButton | Role::NumberInput => Self::SpinButton,
            // A drag value that is being typed into.
            Role::TextInput if node.numeric_value().is_some() => Self::SpinButton,
            Role::TextInput | Role::MultilineTextInput | Role::SearchInput | Role::PasswordInput => {
                Self::Text
            }
            Role::CheckBox | Role::Switch => Self::CheckBox,
            Role::RadioButton => Self::Radio,
            Role::Button | Role::ListBoxOption if holder == Some(Self::Holder("listbox")) => {
                Self::Item("option")
            }
            Role::Button if holder == Some(Self::Holder("menu")) => Self::Item("menuitem"),
            Role::MenuItem => Self::Item("menuitem"),
            Role::Tab => Self::Item("tab"),
            Role::Link => Self::Item("link"),
            Role::Button | Role::DefaultButton | Role::DisclosureTriangle | Role::ColorWell => Self::Button,
            Role::ComboBox => Self::ComboBox,
            Role::Heading => Self::Heading(node.level().unwrap_or(2).clamp(1, 6)),
            Role::Label | Role::Paragraph => Self::Words,
            Role::Image | Role::Canvas | Role::Figure | Role::GraphicsDocument if !name.is_empty() => {
                Self::Other("img")
            }
            Role::ProgressIndicator => Self::Other("progressbar"),
            Role::Meter => Self::Other("meter"),
            Role::Splitter => Self::Other("separator"),
            Role::ListBox => Self::Holder("listbox"),
            Role::Menu => Self::Holder("menu"),
            Role::TabList => Self::Holder("tablist"),
            Role::TabPanel => Self::Holder("tabpanel"),
            Role::List => Self::Holder("list"),
            Role::ListItem => Self::Holder("listitem"),
            Role::RadioGroup => Self::Holder("radiogroup"),
            Role::Toolbar => Self::Holder("toolbar"),
            Role::Main => Self::Holder("main"),
            Role::Banner | Role::Header => Self::Holder("banner"),
            Role::ContentInfo | Role::Footer => Self::Holder("contentinfo"),
            Role::Navigation => Self::Holder("navigation"),
            Role::Complementary => Self::Holder("complementary"),
            Role::Status => Self::Holder("status"),
            Role::Alert => Self::Holder("alert"),
            Role::Tooltip => Self::Holder("tooltip"),
            // Without a name these say nothing.
            _ if name.is_empty() => return None,
            Role::Dialog | Role::AlertDialog => Self::Holder("dialog"),
            Role::Region | Role::Pane | Role::Section => Self::Holder("region"),
            Role::Group | Role::GenericContainer | Role::ScrollView | Role::Window => Self::Holder("group"),
            _ if node.supports_action(Action::Click) => Self::Button,
            _ => Self::Words,
        })
    }

    /// The tag that it is written as; one element can't change it.
    pub fn tag(self) -> &'static str {
        match self {
            Self::Slider | Self::SpinButton | Self::Text | Self::CheckBox | Self::Radio => "input",
            Self::Button | Self::ComboBox => "button",
            Self::Item(_) | Self::Other(_) | Self::Holder(_) => "div",
            Self::Heading(1) => "h1",
            Self::Heading(2) => "h2",
            Self::Heading(3) => "h3",
            Self::Heading(4) => "h4",
            Self::Heading(5) => "h5",
            Self::Heading(_) => "h6",
            Self::Words => "p",
        }
    }

    /// Whether what is inside the node goes inside the element.
    pub fn holds(self) -> bool {
        matches!(self, Self::Holder(_))
    }

    /// Whether a click on it is a click on the widget.
    pub fn is_pressed(self) -> bool {
        matches!(self, Self::CheckBox | Self::Radio | Self::Button | Self::ComboBox | Self::Item(_))
    }

    /// Whether it does something with a key itself: the browser, or an action that follows.
    pub fn uses_key(self, key: &str) -> bool {
        match self {
            Self::SpinButton | Self::Text => !matches!(key, "Tab" | "Escape"),
            Self::Slider => key.starts_with("Arrow") || matches!(key, "Home" | "End" | "PageUp" | "PageDown"),
            Self::CheckBox | Self::Radio => key == " ",
            Self::Button | Self::ComboBox => matches!(key, " " | "Enter"),
            _ => false,
        }
    }

    /// Whether one types into it.
    pub fn is_typed(self) -> bool {
        matches!(self, Self::SpinButton | Self::Text)
    }

    /// Type of its `input`, if it is one.
    pub fn input_type(self) -> Option<&'static str> {
        match self {
            Self::Slider => Some("range"),
            Self::CheckBox => Some("checkbox"),
            Self::Radio => Some("radio"),
            // Not "number", which neither shows a unit nor takes a true minus.
            Self::SpinButton | Self::Text => Some("text"),
            _ => None,
        }
    }

    /// ARIA role, where the tag doesn't say it.
    pub fn role(self) -> Option<&'static str> {
        match self {
            Self::SpinButton => Some("spinbutton"),
            Self::ComboBox => Some("combobox"),
            Self::Item(role) | Self::Other(role) | Self::Holder(role) => Some(role),
            _ => None,
        }
    }

    /// Whether its name is its text, rather than an attribute.
    pub fn is_named_by_text(self) -> bool {
        matches!(self, Self::Words | Self::Heading(_) | Self::Item(_) | Self::Button)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn kind_of(role: Role, name: &str) -> Option<Kind> {
        Kind::of(&Node::new(role), None, name)
    }

    #[test]
    fn roles_become_elements_with_the_same_meaning() {
        let table = [
            (Role::Slider, "input", Some("range"), None),
            (Role::SpinButton, "input", Some("text"), Some("spinbutton")),
            (Role::TextInput, "input", Some("text"), None),
            (Role::CheckBox, "input", Some("checkbox"), None),
            (Role::RadioButton, "input", Some("radio"), None),
            (Role::Button, "button", None, None),
            (Role::ComboBox, "button", None, Some("combobox")),
            (Role::Tab, "div", None, Some("tab")),
            (Role::Label, "p", None, None),
            (Role::Image, "div", None, Some("img")),
            (Role::ListBox, "div", None, Some("listbox")),
            (Role::Dialog, "div", None, Some("dialog")),
            (Role::Region, "div", None, Some("region")),
            (Role::Window, "div", None, Some("group")),
        ];
        for (role, tag, input_type, aria) in table {
            let kind = kind_of(role, "Speed").expect("it has a name");
            assert_eq!((kind.tag(), kind.input_type(), kind.role()), (tag, input_type, aria), "{role:?}");
        }
    }

    #[test]
    fn what_only_arranges_others_leaves_no_trace() {
        for role in
            [Role::GenericContainer, Role::Pane, Role::Dialog, Role::Window, Role::Image, Role::Unknown]
        {
            assert_eq!(kind_of(role, ""), None, "{role:?}");
        }
    }

    #[test]
    fn headings_keep_their_level_within_six() {
        for (level, tag) in [(1, "h1"), (3, "h3"), (6, "h6"), (9, "h6")] {
            let mut node = Node::new(Role::Heading);
            node.set_level(level);
            assert_eq!(Kind::of(&node, None, "Modes").map(Kind::tag), Some(tag));
        }
        assert_eq!(kind_of(Role::Heading, "Modes").map(Kind::tag), Some("h2"));
    }

    #[test]
    fn buttons_in_a_list_are_its_items() {
        let button = Node::new(Role::Button);
        let within = |role| Kind::of(&button, Some(Kind::Holder(role)), "Navion");
        assert_eq!(within("listbox"), Some(Kind::Item("option")));
        assert_eq!(within("menu"), Some(Kind::Item("menuitem")));
        assert_eq!(within("dialog"), Some(Kind::Button));
    }

    #[test]
    fn a_number_that_is_being_typed_is_still_a_number() {
        let mut node = Node::new(Role::TextInput);
        assert_eq!(Kind::of(&node, None, "Speed"), Some(Kind::Text));
        node.set_numeric_value(60.0);
        assert_eq!(Kind::of(&node, None, "Speed"), Some(Kind::SpinButton));
    }

    #[test]
    fn what_can_be_clicked_is_a_button_if_it_is_nothing_else() {
        let mut node = Node::new(Role::Unknown);
        assert_eq!(Kind::of(&node, None, "Plot"), Some(Kind::Words));
        node.add_action(Action::Click);
        assert_eq!(Kind::of(&node, None, "Plot"), Some(Kind::Button));
    }

    #[test]
    fn an_element_keeps_the_keys_that_it_has_a_use_for() {
        let table = [
            (Kind::Slider, "ArrowLeft", true),
            (Kind::Slider, "a", false),
            (Kind::Text, "a", true),
            (Kind::Text, "Tab", false),
            (Kind::Text, "Escape", false),
            (Kind::CheckBox, " ", true),
            (Kind::CheckBox, "Enter", false),
            (Kind::Button, "Enter", true),
            (Kind::Words, " ", false),
        ];
        for (kind, key, uses) in table {
            assert_eq!(kind.uses_key(key), uses, "{kind:?} {key}");
        }
    }
}
