//! One node of the tree as one element of the page.

use egui::accesskit::{Action, HasPopup, Node, NodeId, Orientation, Role, Toggled};
use wasm_bindgen::JsCast as _;
use web_sys::{Document, Element, HtmlElement, HtmlInputElement};

/// What an element is, as far as its tag and its events go.
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
    fn of(node: &Node, holder: Option<Self>, name: &str) -> Option<Self> {
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
            Role::Dialog | Role::AlertDialog => Self::Holder("dialog"),
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

    fn input_type(self) -> Option<&'static str> {
        match self {
            Self::Slider => Some("range"),
            Self::CheckBox => Some("checkbox"),
            Self::Radio => Some("radio"),
            // Not "number", which neither shows a unit nor takes a true minus.
            Self::SpinButton | Self::Text => Some("text"),
            _ => None,
        }
    }

    fn role(self) -> Option<&'static str> {
        match self {
            Self::SpinButton => Some("spinbutton"),
            Self::ComboBox => Some("combobox"),
            Self::Item(role) | Self::Other(role) | Self::Holder(role) => Some(role),
            _ => None,
        }
    }

    /// Whether its name is its text, rather than an attribute.
    fn is_named_by_text(self) -> bool {
        matches!(self, Self::Words | Self::Heading(_) | Self::Item(_) | Self::Button)
    }
}

/// All that a page shows of a node.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// What it is.
    pub kind: Kind,
    /// Whether egui can focus it.
    pub focusable: bool,
    text: String,
    state: State,
    attributes: Vec<(&'static str, String)>,
    /// Left, top, width and height in CSS pixels.
    bounds: Option<[f64; 4]>,
}

/// What a person changes in the element itself; it isn't among its attributes.
#[derive(Clone, Debug, PartialEq)]
enum State {
    /// Nothing, or not known: the browser has changed it.
    None,
    Value(String),
    Toggled(Toggled),
}

impl Picture {
    /// None for nodes that only arrange others.
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

/// An element and what it shows.
pub struct Shown {
    /// In the page.
    pub element: Element,
    /// As last written.
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
        let blank = Picture {
            kind: picture.kind,
            focusable: false,
            text: String::new(),
            state: State::None,
            attributes: Vec::new(),
            bounds: None,
        };
        let mut shown = Self { element, picture: blank, children: Vec::new(), typing: false };
        shown.update(picture);
        Some(shown)
    }

    /// Writes what differs.
    pub fn update(&mut self, picture: Picture) {
        if self.picture == picture {
            return;
        }
        let old = &self.picture;
        if old.attributes != picture.attributes {
            for (name, _) in &old.attributes {
                if !picture.attributes.iter().any(|(kept, _)| kept == name) {
                    // Only a name that isn't one could fail.
                    let _ = self.element.remove_attribute(name);
                }
            }
            for new in &picture.attributes {
                if !old.attributes.contains(new) {
                    set(&self.element, new.0, &new.1);
                }
            }
        }
        if old.text != picture.text {
            self.element.set_text_content(Some(&picture.text));
        }
        // After the attributes: a range takes no value outside its limits.
        if let Some(input) = self.element.dyn_ref::<HtmlInputElement>()
            && old.state != picture.state
            && !self.typing
        {
            match &picture.state {
                State::Value(value) => input.set_value(value),
                State::Toggled(toggled) => {
                    input.set_checked(*toggled == Toggled::True);
                    input.set_indeterminate(*toggled == Toggled::Mixed);
                }
                State::None => {}
            }
        }
        if let (Some(new), Some(element)) = (picture.bounds, self.element.dyn_ref::<HtmlElement>()) {
            let style = element.style();
            for (side, name) in ["left", "top", "width", "height"].into_iter().enumerate() {
                if old.bounds.map(|old| old[side]) != Some(new[side]) {
                    // Only a property that isn't one could fail.
                    let _ = style.set_property(name, &format!("{}px", new[side]));
                }
            }
        }
        self.picture = picture;
    }

    /// The browser has changed the element's own state: it is to be written again, whatever egui makes of it.
    pub fn forget_state(&mut self) {
        self.picture.state = State::None;
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
