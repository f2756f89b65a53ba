//! A slider that knows where its reference is: rail, tick at the reference, handle. The wheel does not move it.

use std::ops::RangeInclusive;

use egui::accesskit::{Action, ActionData};
use egui::{Event, Key, Rect, Response, Sense, Shape, Stroke, Ui, Vec2, WidgetInfo, emath};

use super::theme::Palette;
use super::{arrow_keys, finger};
use crate::number::nice_step;

/// Most fine steps from one end to the other; the next round step makes it fewer.
const FINE_STEPS: f64 = 300.0;
/// Coarse steps, with Shift or the page keys.
const COARSE: f64 = 10.0;
const HANDLE_RADIUS: f32 = 6.0;

/// A slider in the unit in which its value is shown.
#[derive(Debug)]
pub struct ReferenceSlider<'a> {
    /// Name for screen readers and tests.
    pub name: &'a str,
    /// The value and its unit in words, for screen readers.
    pub value_text: String,
    /// Value.
    pub value: f64,
    /// Reach of the rail; the value may lie outside.
    pub range: RangeInclusive<f64>,
    /// Where the tick stands, and where a double click or Delete goes.
    pub reference: f64,
    /// The part of the rail where what is set exists; all of it where there is none.
    pub exists: Option<RangeInclusive<f64>>,
    /// Where something else has moved what the value means, marked by a triangle.
    pub in_effect: Option<f64>,
}

impl ReferenceSlider<'_> {
    /// Draws it and gives the value that the person has set, if any.
    pub fn show(&self, ui: &mut Ui, size: Vec2) -> (Response, Option<f64>) {
        let (rect, mut response) = ui.allocate_exact_size(size, Sense::click_and_drag());
        // A finger that goes up or down over the slider scrolls the page.
        let held = finger::works_on(ui, &response);
        let asked = held
            .then(|| self.by_pointer(&response, rect))
            .flatten()
            .or_else(|| self.by_key(ui, &response))
            .or_else(|| self.by_request(ui, &response));
        let asked = if response.double_clicked() { Some(self.reference) } else { asked };
        let new = asked.filter(|&value| value != self.value);
        if new.is_some() {
            response.mark_changed();
        }
        if held && (response.drag_started() || response.clicked()) {
            response.request_focus();
        }
        self.tell(ui, &response);
        self.paint(ui, &response, rect, new.unwrap_or(self.value));
        (response, new)
    }

    fn span(&self) -> f64 {
        self.range.end() - self.range.start()
    }

    /// A round step, so that steps end on numbers a person can read.
    fn step(&self) -> f64 {
        nice_step(self.span() / FINE_STEPS)
    }

    fn rail(rect: Rect) -> (f32, f32) {
        (rect.left() + HANDLE_RADIUS + 1.0, rect.right() - HANDLE_RADIUS - 1.0)
    }

    fn x_of(&self, rect: Rect, value: f64) -> f32 {
        let (left, right) = Self::rail(rect);
        let fraction = ((value - self.range.start()) / self.span()).clamp(0.0, 1.0);
        left + fraction as f32 * (right - left)
    }

    fn value_at(&self, rect: Rect, x: f32) -> f64 {
        let (left, right) = Self::rail(rect);
        let fraction = f64::from((x - left) / (right - left)).clamp(0.0, 1.0);
        self.range.start() + fraction * self.span()
    }

    /// The roundest number under the pointer, and the reference itself when the pointer is upon its tick.
    fn by_pointer(&self, response: &Response, rect: Rect) -> Option<f64> {
        let x = response.interact_pointer_pos()?.x;
        if (x - self.x_of(rect, self.reference)).abs() < 1.5 {
            return Some(self.reference);
        }
        Some(emath::smart_aim::best_in_range_f64(self.value_at(rect, x - 0.5), self.value_at(rect, x + 0.5)))
    }

    fn by_key(&self, ui: &Ui, response: &Response) -> Option<f64> {
        if !response.has_focus() {
            return None;
        }
        arrow_keys::keep(ui, response);
        ui.input(|input| {
            // Shift as each key came with it: one that was pressed elsewhere on the page is handed on with its own.
            // Page up and down edit nothing: a presenter's clicker sends them.
            let arrow = |event: &Event| match event {
                Event::Key { key: Key::ArrowRight | Key::ArrowUp, pressed: true, modifiers, .. } => {
                    if modifiers.shift {
                        COARSE
                    } else {
                        1.0
                    }
                }
                Event::Key { key: Key::ArrowLeft | Key::ArrowDown, pressed: true, modifiers, .. } => {
                    if modifiers.shift {
                        -COARSE
                    } else {
                        -1.0
                    }
                }
                _ => 0.0,
            };
            let steps = input.events.iter().map(arrow).sum();
            if input.key_pressed(Key::Home) {
                Some(*self.range.start())
            } else if input.key_pressed(Key::End) {
                Some(*self.range.end())
            } else if input.key_pressed(Key::Delete) || input.key_pressed(Key::Backspace) {
                Some(self.reference)
            } else {
                self.stepped(steps)
            }
        })
    }

    fn by_request(&self, ui: &Ui, response: &Response) -> Option<f64> {
        ui.input(|input| {
            let set = input
                .accesskit_action_requests(response.id, Action::SetValue)
                .filter_map(|request| match request.data {
                    Some(ActionData::NumericValue(value)) if value.is_finite() => {
                        Some(value.clamp(*self.range.start(), *self.range.end()))
                    }
                    _ => None,
                })
                .last();
            let steps = input.num_accesskit_action_requests(response.id, Action::Increment) as f64
                - input.num_accesskit_action_requests(response.id, Action::Decrement) as f64;
            set.or_else(|| self.stepped(steps))
        })
    }

    /// Moves by steps along a grid of round numbers; a step stops at the end of the rail, and from outside the
    /// rail it never jumps inwards past the end.
    fn stepped(&self, steps: f64) -> Option<f64> {
        if steps == 0.0 {
            return None;
        }
        let step = self.step();
        let next = ((self.value / step).round() + steps) * step;
        let low = self.range.start().min(self.value);
        let high = self.range.end().max(self.value);
        Some(next.clamp(low, high))
    }

    fn tell(&self, ui: &Ui, response: &Response) {
        response.widget_info(|| WidgetInfo::slider(ui.is_enabled(), self.value, self.name));
        ui.ctx().accesskit_node_builder(response.id, |node| {
            node.set_value(self.value_text.as_str());
            if self.exists.as_ref().is_some_and(|exists| !exists.contains(&self.value)) {
                node.set_description("There is nothing to analyse at this value");
            }
            node.set_min_numeric_value(self.range.start().min(self.value));
            node.set_max_numeric_value(self.range.end().max(self.value));
            node.set_numeric_value_step(self.step());
            node.add_action(Action::SetValue);
            node.add_action(Action::Increment);
            node.add_action(Action::Decrement);
        });
    }

    fn paint(&self, ui: &Ui, response: &Response, rect: Rect, value: f64) {
        let palette = Palette::of(ui);
        let painter = ui.painter();
        let (left, right) = Self::rail(rect);
        let y = rect.center().y;
        let (x, tick) = (self.x_of(rect, value), self.x_of(rect, self.reference));
        painter.hline(left..=right, y, Stroke::new(3.0, palette.hairline));
        // The fill runs from the reference: how far, and which way, this has been moved.
        painter.hline(tick.min(x)..=tick.max(x), y, Stroke::new(3.0, palette.accent));
        if let Some(exists) = &self.exists {
            let (from, to) = (self.x_of(rect, *exists.start()), self.x_of(rect, *exists.end()));
            for part in [left..=from, to..=right].into_iter().filter(|part| part.end() - part.start() > 1.0) {
                // Nothing to slide on: dots in place of the rail.
                painter.hline(part.clone(), y, Stroke::new(3.0, palette.pane));
                let ends = [part.start(), part.end()].map(|x| egui::pos2(*x, y));
                painter.extend(Shape::dotted_line(&ends, palette.bad, 4.0, 1.0));
            }
        }
        painter.vline(tick, y - 6.5..=y + 6.5, Stroke::new(1.5, palette.pinned));
        if let Some(moved) = self.in_effect {
            let tip = egui::pos2(self.x_of(rect, moved), y + 3.0);
            let foot = [tip + Vec2::new(4.0, 7.0), tip + Vec2::new(-4.0, 7.0)];
            painter.add(Shape::convex_polygon(vec![tip, foot[0], foot[1]], palette.warning, Stroke::NONE));
        }
        let outside = !self.range.contains(&value);
        let line = if outside { palette.bad } else { palette.strong };
        let held = response.is_pointer_button_down_on() || response.hovered();
        // A disc on a disc has a tenth of the corners of a circle with an outline, and there is one on every row.
        let radius = if held { HANDLE_RADIUS + 1.0 } else { HANDLE_RADIUS };
        painter.circle_filled(egui::pos2(x, y), radius + 1.0, line);
        painter.circle_filled(egui::pos2(x, y), radius - 1.0, palette.pane);
        if response.has_focus() {
            painter.circle_stroke(egui::pos2(x, y), HANDLE_RADIUS + 3.5, Stroke::new(2.0, palette.accent));
        }
    }
}
