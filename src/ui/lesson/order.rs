//! A question for an order: things that are moved up and down.

use egui::{Button, Key, RichText, Ui, UiBuilder};

use super::text::Context;
use crate::few;
use crate::findings::measures::Measure;
use crate::lesson::{Answer, Given, Item, Truth};
use crate::ui::arrow_keys;
use crate::ui::theme::{self, Palette};
use crate::words;

/// Draws the things in their order; once the answer is final, with the number of each and the right order.
pub fn order_ui(
    ui: &mut Ui,
    items: &[Item],
    measure: Measure,
    given: &mut Given,
    truth: Option<&Truth>,
    context: Context<'_>,
) {
    let said = match &given.answer {
        Some(Answer::Order(order)) => Some(order.clone()),
        _ => None,
    };
    if !given.is_final {
        let mut order = said.unwrap_or_else(|| first_order(items));
        move_ui(ui, items, &mut order);
        // It stands in an order from the start.
        given.answer = Some(Answer::Order(order));
        return;
    }
    let Some(Truth::Values(values)) = truth else { return };
    let convention = context.start.scenario().convention();
    let mut right: Vec<usize> = (0..values.len()).collect();
    few::sort_by(&mut right, |&a, &b| values[a].total_cmp(&values[b]));
    let palette = Palette::of(ui);
    let says = |number: usize| items.get(number).map_or_else(String::new, |item| item.says.plain());
    for (place, number) in said.unwrap_or_default().into_iter().enumerate() {
        let is_right = right.get(place) == Some(&number);
        let (mark, color) = if is_right { ("✓", palette.good) } else { ("✗", palette.bad) };
        ui.label(RichText::new(format!("{mark} {}. {}", place + 1, says(number))).color(color));
    }
    let in_words = |number: usize| {
        let value = values
            .get(number)
            .map_or_else(String::new, |value| words::measure::value(measure, *value, convention));
        format!("{} ({value})", says(number))
    };
    let list: Vec<String> = right.into_iter().map(in_words).collect();
    ui.label(format!("By {}: {}.", words::measure::name(measure), list.join(", then ")));
}

/// By their words, so that the order of the file gives nothing away.
fn first_order(items: &[Item]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..items.len()).collect();
    few::sort_by_key(&mut order, |&number| items.get(number).map(|item| item.says.plain()));
    order
}

/// Rows with buttons; an arrow key moves the thing whose button has the focus, and the focus goes with it.
fn move_ui(ui: &mut Ui, items: &[Item], order: &mut [usize]) {
    let last = order.len().saturating_sub(1);
    let mut moved = None;
    for (place, &number) in order.iter().enumerate() {
        let Some(item) = items.get(number) else { continue };
        let says = item.says.plain();
        // Of the thing, wherever it stands, so that the focus stays on its button.
        let row = UiBuilder::new().scope_id(ui.scope_id().with(number));
        ui.scope_builder(row, |ui| {
            ui.horizontal(|ui| {
                let above = place.checked_sub(1);
                let below = (place < last).then_some(place + 1);
                for (sign, way, to) in [("↑", "up", above), ("↓", "down", below)] {
                    let name = format!("Move “{says}” {way}");
                    let response = ui.add(Button::new(sign)).accessible_name(name);
                    if response.has_focus() {
                        arrow_keys::keep(ui, &response);
                        let pressed = |key| ui.input(|input| input.key_pressed(key));
                        let to = if pressed(Key::ArrowUp) {
                            above
                        } else if pressed(Key::ArrowDown) {
                            below
                        } else {
                            None
                        };
                        moved = to.map(|to| (place, to)).or(moved);
                    }
                    if response.clicked() {
                        moved = to.map(|to| (place, to)).or(moved);
                    }
                }
                ui.label(RichText::new(format!("{}. {says}", place + 1)).font(theme::body()));
            });
        });
    }
    if let Some((from, to)) = moved {
        order.swap(from, to);
        ui.request_repaint();
    }
}
