//! The top bar: which aircraft, what to compare with, a link to share, back and forth, theme.

use std::sync::Arc;

use egui::containers::menu::menu_style;
use egui::style::{ScrollStyle, StyleModifier};
use egui::{Button, Color32, ComboBox, FontId, Popup, Response, RichText, TextStyle, TextWrapMode, Ui, Vec2};

use super::app::{Action, Pinned};
use super::curtain::Curtain;
use super::theme::{self, Look, Palette};
use crate::content::{Aircraft, Status};
use crate::flight::aircraft::plane::Plane;
use crate::scenario::{Hidden, Lock, Scenario};
use crate::words;

/// Everything that the bar has to know.
#[derive(Clone, Copy, Debug)]
pub struct Bar<'a> {
    /// Every aircraft that can be chosen.
    pub aircraft: &'a [Arc<Aircraft>],
    /// The scenario on screen.
    pub scenario: &'a Scenario,
    /// The pinned state, if any.
    pub pinned: Option<&'a Pinned>,
    /// Whether there is something to undo and to redo.
    pub history: (bool, bool),
    /// Whether the page stays with what was opened on it.
    pub kept: bool,
    /// Whether the bar needs two rows.
    pub narrow: bool,
    /// Whether there is room for the flight condition and the name of the pinned state.
    pub roomy: bool,
    /// Whether there is room for the less common tools too.
    pub ample: bool,
}

/// Left and right of the list of aircraft, with its scroll bar.
const LIST_MARGINS: f32 = 56.0;

/// Draws the bar and gives what the person asked for.
pub fn top_bar_ui(ui: &mut Ui, bar: Bar<'_>) -> Option<Action> {
    if bar.narrow {
        let first = |ui: &mut Ui| {
            let action = aircraft_ui(ui, bar);
            let action = status_ui(ui, bar.scenario).or(action);
            from_the_right(ui, true, None, vec![Tool::help()]).or(action)
        };
        let second = |ui: &mut Ui| {
            let action = plane_ui(ui, bar);
            tools_ui(ui, bar).or(action)
        };
        let action = ui.horizontal(first).inner;
        return ui.horizontal(second).inner.or(action);
    }
    let row = |ui: &mut Ui| {
        theme::heading(ui, RichText::new("Eigenwing").font(theme::semibold(theme::sizes(ui).brand)), 1);
        ui.add_space(6.0);
        let action = aircraft_ui(ui, bar);
        let action = status_ui(ui, bar.scenario).or(action);
        let action = plane_ui(ui, bar).or(action);
        tools_ui(ui, bar).or(action)
    };
    ui.horizontal(row).inner
}

fn aircraft_ui(ui: &mut Ui, bar: Bar<'_>) -> Option<Action> {
    let mut action = None;
    let curtain = Curtain::of(ui);
    if curtain.hides(Hidden::AircraftName) {
        ui.label(RichText::new(words::view::NAME_HIDDEN).color(Palette::of(ui).weak));
        return None;
    }
    let now = &bar.scenario.aircraft;
    // The same for every aircraft, so that nothing beside it moves when another is chosen.
    let width = if bar.roomy { 360.0 } else { 190.0 };
    let chooser = ComboBox::from_id_salt("aircraft")
        // As tall as the page; where that is not enough, a scroll bar says so before the pointer is there.
        .height((ui.ctx().content_rect().bottom() - ui.max_rect().bottom() - 60.0).max(160.0))
        .popup_style(StyleModifier::new(|style| {
            menu_style(style);
            style.spacing.scroll =
                ScrollStyle { bar_width: 8.0, foreground_color: true, ..ScrollStyle::solid() };
        }))
        .width(width)
        .truncate()
        .selected_text(if bar.roomy {
            format!("{} · {}", now.name, now.condition)
        } else {
            now.name.clone()
        });
    // On a phone the longest of them have two lines.
    let room = ui.content_rect().width() - LIST_MARGINS;
    let is_sourced = !curtain.hides_source();
    let list = |ui: &mut Ui| {
        if bar.narrow {
            ui.set_max_width(room);
            ui.style_mut().wrap_mode = Some(TextWrapMode::Wrap);
        }
        for aircraft in bar.aircraft {
            let status = match aircraft.status {
                Status::Verified => "✓",
                Status::Unverified => "unverified",
            };
            let text = format!("{} · {} · {status}", aircraft.name, aircraft.condition);
            let choice = ui.selectable_label(aircraft.key == now.key, text);
            let choice = if is_sourced { choice.on_hover_text(&aircraft.source) } else { choice };
            if choice.clicked() {
                action = Some(Action::Load(aircraft.clone()));
                ui.close();
            }
        }
        if !bar.kept {
            ui.separator();
            let own = ui.button("Your own aircraft …");
            if own.on_hover_text("A file, or matrices that you paste (O)").clicked() {
                action = Some(Action::Import);
                ui.close();
            }
        }
    };
    let fixed = |ui: &mut Ui| {
        ui.set_max_width(width);
        curtain.lock_ui(ui, Lock::Aircraft, |ui| chooser.show_ui(ui, list))
    };
    let chooser = ui.scope(fixed).inner;
    let response = theme::name_chooser(chooser, "Aircraft", &now.name);
    let source = if curtain.hides_source() { "" } else { now.source.as_str() };
    response.on_hover_text(format!("{} · {}\n{source}", now.name, now.condition).trim_end());
    action
}

/// The status of the plane on screen, a button that opens the sheet of the source.
fn status_ui(ui: &mut Ui, scenario: &Scenario) -> Option<Action> {
    let palette = Palette::of(ui);
    if Curtain::of(ui).hides_source() {
        return None;
    }
    let notes = scenario.aircraft.plane_notes[scenario.plane].as_ref()?;
    let is_edited = scenario.is_edited();
    let text = words::status::mark(notes.status, is_edited);
    let color = match (notes.status, is_edited) {
        (_, true) => palette.weak,
        (Status::Verified, false) => palette.good,
        (Status::Unverified, false) => palette.warning,
    };
    let button = Button::new(RichText::new(text).font(theme::small()).color(color));
    let response =
        theme::bare_button(ui, true, button).accessible_name(words::status::button(notes.status, is_edited));
    let reason =
        words::status::reason(&scenario.aircraft.name, notes.status, &notes.status_reason, is_edited);
    let is_pressed = response.on_hover_text(remarks(&reason, &scenario.aircraft)).clicked();
    is_pressed.then_some(Action::Source)
}

/// The reason of a status, and below it the remarks on the aircraft's source.
fn remarks(status_reason: &str, aircraft: &Aircraft) -> String {
    let notes = aircraft.notes.iter().map(String::as_str);
    std::iter::once(status_reason).chain(notes).collect::<Vec<_>>().join("\n\n")
}

/// Longitudinal or lateral–directional, where the aircraft has both.
fn plane_ui(ui: &mut Ui, bar: Bar<'_>) -> Option<Action> {
    let mut action = None;
    bar.scenario.aircraft.plane_notes.lateral.as_ref()?;
    let short = ["Long.", "Lateral"];
    Curtain::of(ui).lock_ui(ui, Lock::Plane, |ui| {
        for (plane, short) in Plane::ALL.into_iter().zip(short) {
            let text = if bar.narrow { short } else { words::view::plane(plane) };
            if ui.selectable_label(bar.scenario.plane == plane, text).clicked() {
                action = Some(Action::Turn(plane));
            }
        }
    });
    action
}

/// A button of the bar that is its words alone.
struct Tool {
    text: &'static str,
    name: String,
    hover: String,
    is_enabled: bool,
    does: Does,
}

/// What a tool does.
enum Does {
    Ask(Action),
    Dress(Look),
    /// Opens a list of tools for which the bar has no room.
    List(Vec<Tool>),
}

impl Tool {
    fn new(text: &'static str, name: impl Into<String>, action: Action) -> Self {
        let name = name.into();
        Self { text, hover: name.clone(), name, is_enabled: true, does: Does::Ask(action) }
    }

    /// The sheet of keys, which nobody finds by pressing one.
    fn help() -> Self {
        Self { hover: "Help: all keys (?)".to_owned(), ..Self::new("?", "Help: all keys", Action::Help) }
    }

    /// Those for which there is no room.
    fn more(tools: Vec<Self>) -> Self {
        let names: Vec<&str> = tools.iter().map(|tool| tool.name.as_str()).collect();
        let (name, hover) = ("More".to_owned(), names.join("; "));
        Self { text: "⋯", name, hover, is_enabled: true, does: Does::List(tools) }
    }
}

/// The tools, up to the right edge; in the order of reading, which is that of the Tab key.
fn tools_ui(ui: &mut Ui, bar: Bar<'_>) -> Option<Action> {
    let look = Look::of(ui.ctx()).next();
    let curtain = Curtain::of(ui);
    let share = if bar.narrow { "Share" } else { "Share link" };
    let share = Tool::new(share, "Share link: copy the whole scene as a link (key L)", Action::CopyLink);
    let pin = match bar.pinned {
        Some(pinned) => {
            Tool::new("Unpin", format!("Unpin “{}”", curtain.aircraft(&pinned.name)), Action::Unpin)
        }
        None => Tool::new("Pin", "Pin this state, to compare what comes next with it", Action::Pin),
    };
    let dress = Tool {
        text: look.sign(),
        name: look.text().to_owned(),
        hover: format!("{} (T)", look.text()),
        is_enabled: true,
        does: Does::Dress(look),
    };
    let pin = Tool { is_enabled: !curtain.locks(Lock::View), ..pin };
    let undo = Tool { is_enabled: bar.history.0, ..Tool::new("↶", "Undo", Action::Undo) };
    let redo = Tool { is_enabled: bar.history.1, ..Tool::new("↷", "Redo", Action::Redo) };
    let mut tools = vec![share, pin, undo, redo];
    // Each stands in the bar, or where there is no room in the list behind one sign.
    let mut more = Vec::new();
    let mut add = |place: usize, has_room: bool, tool: Tool| {
        if has_room { tools.insert(place, tool) } else { more.push(tool) }
    };
    if !bar.kept {
        add(0, !bar.narrow, Tool::new("Lessons", "Lessons: begin with a question", Action::Lessons));
    }
    let hover = "Present: the scene fills the screen, in large type (F)".to_owned();
    add(1, bar.roomy, Tool { hover, ..Tool::new("Present", "Present the scene", Action::Present) });
    if !bar.kept {
        let hover = "Take along: a script, a file, data or a figure (X)".to_owned();
        let take = Tool::new("Take along", "Take the scene along", Action::TakeAlong);
        add(3, bar.ample, Tool { hover, ..take });
    }
    if !bar.kept {
        // The page around a frame has a look of its own.
        let last = if bar.narrow { &mut more } else { &mut tools };
        last.push(dress);
    }
    if !more.is_empty() {
        tools.push(Tool::more(more));
    }
    if !bar.narrow {
        tools.push(Tool::help());
    }
    let pinned = bar
        .pinned
        .filter(|_| bar.roomy)
        .map(|pinned| format!("○ pinned: {}", curtain.aircraft(&pinned.name)));
    from_the_right(ui, bar.narrow, pinned.as_deref(), tools)
}

/// Shows a remark and tools up to the right edge, and gives what was asked for.
fn from_the_right(ui: &mut Ui, narrow: bool, remark: Option<&str>, tools: Vec<Tool>) -> Option<Action> {
    // A sign alone is too narrow for a finger.
    let (gap, least): (f32, f32) = match (theme::is_for_fingers(ui), narrow) {
        (true, _) => (4.0, 34.0),
        (false, true) => (6.0, 0.0),
        (false, false) => (12.0, 0.0),
    };
    // Laid out from the right they would be in the wrong order for the Tab key, so their widths are added up first.
    let width = |text: &str, font: FontId| {
        ui.painter().layout_no_wrap(text.to_owned(), font, Color32::PLACEHOLDER).size().x
    };
    let font = TextStyle::Button.resolve(ui.style());
    let of_tools = tools.iter().map(|tool| width(tool.text, font.clone()).max(least));
    let of_remark = remark.map(|remark| width(remark, theme::small()));
    let all: Vec<f32> = of_remark.into_iter().chain(of_tools).collect();
    let (needed, gaps) = (all.iter().sum::<f32>(), all.len().saturating_sub(1) as f32);
    // Where they don't fit, a phone's width enlarged, they stand closer. One more gap is before the first.
    let gap = gap.min((ui.available_width() - needed) / (gaps + 1.0)).max(0.0);
    ui.spacing_mut().item_spacing.x = gap;
    ui.add_space((ui.available_width() - needed - gap * gaps).max(0.0));
    if let Some(remark) = remark {
        ui.label(RichText::new(remark).font(theme::small()).color(Palette::of(ui).weak));
    }
    let mut action = None;
    for tool in tools {
        let button = Button::new(tool.text).min_size(Vec2::new(least, 0.0));
        let response = theme::bare_button(ui, tool.is_enabled, button);
        let response = response.accessible_name(tool.name).on_hover_text(tool.hover);
        match tool.does {
            Does::Ask(asked) if response.clicked() => action = Some(asked),
            Does::Dress(look) if response.clicked() => look.set(ui.ctx()),
            Does::List(tools) => action = list_ui(&response, tools).or(action),
            Does::Ask(_) | Does::Dress(_) => {}
        }
    }
    action
}

/// The list below the button that has more tools, once it is open.
fn list_ui(button: &Response, tools: Vec<Tool>) -> Option<Action> {
    let list = |ui: &mut Ui| {
        let mut action = None;
        for tool in tools {
            // A sign alone says little in a list of words.
            let text = if matches!(tool.does, Does::Dress(_)) { &tool.name } else { tool.text };
            let is_pressed = ui.button(text).accessible_name(&tool.name).on_hover_text(tool.hover).clicked();
            match tool.does {
                Does::Ask(asked) if is_pressed => action = Some(asked),
                Does::Dress(look) if is_pressed => look.set(ui.ctx()),
                Does::Ask(_) | Does::Dress(_) | Does::List(_) => {}
            }
        }
        action
    };
    Popup::menu(button).show(list)?.inner
}
