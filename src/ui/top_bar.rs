//! The top bar: which aircraft, what to compare with, a link to share, back and forth, theme.

use std::sync::Arc;

use egui::containers::menu::menu_style;
use egui::style::{ScrollStyle, StyleModifier};
use egui::{Align, Button, ComboBox, Layout, RichText, Ui, Vec2};

use super::app::{Action, Ghost};
use super::theme::{self, Look, Palette};
use crate::content::{Aircraft, Status};
use crate::flight::plane::Plane;
use crate::scenario::Scenario;

/// What the bar has to know beside the scenario.
#[derive(Clone, Copy, Debug)]
pub struct Bar<'a> {
    /// Every aircraft that can be chosen.
    pub aircraft: &'a [Arc<Aircraft>],
    /// The scenario on screen.
    pub scenario: &'a Scenario,
    /// The pinned state, if any.
    pub ghost: Option<&'a Ghost>,
    /// Whether there is something to undo and to redo.
    pub history: (bool, bool),
    /// Whether the bar needs two rows.
    pub narrow: bool,
    /// Whether there is room for the flight condition and the name of the pinned state.
    pub roomy: bool,
}

/// Draws the bar and gives what the person asked for.
pub fn top_bar_ui(ui: &mut Ui, bar: Bar<'_>) -> Option<Action> {
    if bar.narrow {
        let first = |ui: &mut Ui| {
            let action = aircraft_ui(ui, bar);
            status_ui(ui, bar.scenario);
            ui.with_layout(Layout::right_to_left(Align::Center), help_ui).inner.or(action)
        };
        let second = |ui: &mut Ui| {
            let action = plane_ui(ui, bar);
            tools_from_the_right(ui, bar).or(action)
        };
        let action = ui.horizontal(first).inner;
        return ui.horizontal(second).inner.or(action);
    }
    let row = |ui: &mut Ui| {
        theme::heading(ui, RichText::new("Eigenwing").font(theme::semibold(17.0)), 1);
        ui.add_space(6.0);
        let action = aircraft_ui(ui, bar);
        status_ui(ui, bar.scenario);
        let action = plane_ui(ui, bar).or(action);
        tools_from_the_right(ui, bar).or(action)
    };
    ui.horizontal(row).inner
}

fn tools_from_the_right(ui: &mut Ui, bar: Bar<'_>) -> Option<Action> {
    ui.with_layout(Layout::right_to_left(Align::Center), |ui| tools_ui(ui, bar)).inner
}

fn aircraft_ui(ui: &mut Ui, bar: Bar<'_>) -> Option<Action> {
    let mut action = None;
    let now = &bar.scenario.aircraft;
    let chooser = ComboBox::from_id_salt("aircraft")
        // As tall as the page; where that is not enough, a scroll bar says so before the pointer is there.
        .height((ui.ctx().content_rect().bottom() - ui.max_rect().bottom() - 60.0).max(160.0))
        .popup_style(StyleModifier::new(|style| {
            menu_style(style);
            style.spacing.scroll =
                ScrollStyle { bar_width: 8.0, foreground_color: true, ..ScrollStyle::solid() };
        }))
        .width(if bar.roomy { 330.0 } else { 190.0 })
        .truncate()
        .selected_text(if bar.roomy {
            format!("{} · {}", now.name, now.condition)
        } else {
            now.name.clone()
        });
    let chooser = chooser.show_ui(ui, |ui| {
        for aircraft in bar.aircraft {
            let status = match aircraft.status {
                Status::Verified => "✓",
                Status::Unverified => "unverified",
            };
            let text = format!("{} · {} · {status}", aircraft.name, aircraft.condition);
            let choice = ui.selectable_label(aircraft.key == now.key, text);
            if choice.on_hover_text(&aircraft.status_reason).clicked() {
                action = Some(Action::Load(aircraft.clone()));
                ui.close();
            }
        }
    });
    let response = theme::name_chooser(chooser, "Aircraft", &now.name);
    response.on_hover_text(format!("{} · {}\n{}", now.name, now.condition, now.source));
    action
}

/// The status of the plane on screen.
fn status_ui(ui: &mut Ui, scenario: &Scenario) {
    let palette = Palette::of(ui);
    let Some(notes) = scenario.aircraft.notes_of(scenario.plane) else { return };
    let (text, color) = match notes.status {
        Status::Verified => ("✓ verified", palette.good),
        Status::Unverified => ("unverified", palette.warning),
    };
    ui.label(RichText::new(text).font(theme::small()).color(color)).on_hover_text(&notes.status_reason);
}

/// Longitudinal or lateral–directional, where the aircraft has both.
fn plane_ui(ui: &mut Ui, bar: Bar<'_>) -> Option<Action> {
    let mut action = None;
    bar.scenario.aircraft.lateral_notes.as_ref()?;
    let words = if bar.narrow { ["Long.", "Lateral"] } else { ["Longitudinal", "Lateral–directional"] };
    for (plane, text) in [Plane::Longitudinal, Plane::Lateral].into_iter().zip(words) {
        if ui.selectable_label(bar.scenario.plane == plane, text).clicked() {
            action = Some(Action::Turn(plane));
        }
    }
    action
}

/// The sheet of keys, which nobody finds by pressing one.
fn help_ui(ui: &mut Ui) -> Option<Action> {
    let least = Vec2::new(if theme::is_for_fingers(ui) { 34.0 } else { 0.0 }, 0.0);
    let button = theme::bare_button(ui, true, Button::new("?").min_size(least));
    let button = button.accessible_name("Help: all keys").on_hover_text("Help: all keys (?)");
    button.clicked().then_some(Action::Help)
}

/// The tools, from the right edge inwards where there is room.
fn tools_ui(ui: &mut Ui, bar: Bar<'_>) -> Option<Action> {
    let mut action = None;
    // A sign alone is too narrow for a finger.
    let (gap, least) = match (theme::is_for_fingers(ui), bar.narrow) {
        (true, _) => (4.0, 34.0),
        (false, true) => (6.0, 0.0),
        (false, false) => (12.0, 0.0),
    };
    ui.spacing_mut().item_spacing.x = gap;
    let least = Vec2::new(least, 0.0);
    if !bar.narrow {
        action = help_ui(ui);
    }
    let look = Look::of(ui.ctx()).next();
    let button = theme::bare_button(ui, true, Button::new(look.sign()).min_size(least));
    if button.accessible_name(look.text()).on_hover_text(format!("{} (T)", look.text())).clicked() {
        look.set(ui.ctx());
    }
    let mut tool = |text: &str, name: &str, enabled: bool, asked: Action| {
        let button = theme::bare_button(ui, enabled, Button::new(text).min_size(least));
        if button.accessible_name(name).on_hover_text(name).clicked() {
            action = Some(asked);
        }
    };
    tool("↷", "Redo", bar.history.1, Action::Redo);
    tool("↶", "Undo", bar.history.0, Action::Undo);
    match bar.ghost {
        Some(ghost) => tool("Unpin", &format!("Unpin “{}”", ghost.name), true, Action::Unpin),
        None => tool("Pin ghost", "Pin this state, to compare what comes next with it", true, Action::Pin),
    }
    let share = if bar.narrow { "Share" } else { "Share link" };
    tool(share, "Share link: copy the whole scene as a link (key L)", true, Action::CopyLink);
    if let Some(ghost) = bar.ghost
        && bar.roomy
    {
        let palette = Palette::of(ui);
        ui.label(RichText::new(format!("○ pinned: {}", ghost.name)).font(theme::small()).color(palette.weak));
    }
    action
}
