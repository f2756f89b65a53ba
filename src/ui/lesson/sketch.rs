//! A question for a curve: drawn by mouse or finger, moved point by point by arrow keys, or set in numbers.

use egui::{
    Button, CollapsingHeader, Grid, Pos2, RichText, Sense, Stroke, Ui, Vec2, WidgetInfo, accesskit::Role,
};

use super::pad;
use super::place::read;
use super::text::Context;
use crate::flight::motion::outputs::Output;
use crate::lesson::drawing::{self, KNOTS, POINTS};
use crate::lesson::{Answer, Given, Truth};
use crate::number::{fixed, round_up, significant};
use crate::scenario::Quantity;
use crate::ui::arrow_keys;
use crate::ui::chart::{Chart, Pattern, PlotPoint, Primitive, View, paint};
use crate::ui::number_field::number_field_ui;
use crate::ui::theme::{self, Palette};

/// Height of the pad.
const HEIGHT: f32 = 190.0;
/// An arrow key moves a point by this part of the height.
const FINE: f64 = 1.0 / 40.0;

/// Room for a time and its number.
const PAIR: f32 = 100.0;

/// Where the hand is on the pad.
#[derive(Clone, Copy, Debug, Default)]
pub struct Hand {
    /// What it drew last, while it draws.
    at: Option<(usize, f64)>,
    /// The point that the arrow keys move.
    knot: usize,
}

/// Draws the axes with the sketch; once the answer is final, with the motion.
pub fn sketch_ui(
    ui: &mut Ui,
    output: Output,
    given: &mut Given,
    hand: &mut Hand,
    truth: Option<&Truth>,
    context: Context<'_>,
) {
    let palette = Palette::of(ui);
    let Some(Truth::Curve { values: found, dt }) = truth else { return };
    let quantity = Quantity::of(output);
    let length = context.start.scenario().length_unit();
    let (symbol, unit) = (quantity.dimension.symbol(length), quantity.dimension.in_si(length));
    let duration = (*dt * found.len().saturating_sub(1) as f64).max(1e-3);
    let largest = found.iter().fold(0.0, |most: f64, value| most.max(value.abs())).max(1e-9) / unit;
    // As far down as up, so that the axes don't tell the way.
    let top = round_up(1.3 * largest);
    let (rect, response) = pad::room(ui, HEIGHT, if given.is_final { Sense::HOVER } else { Sense::drag() });
    let chart = Chart { rect, view: View { left: 0.0, right: duration, bottom: -top, top } };
    let ground = vec![Primitive::Rectangle(rect, palette.field)];
    pad::axes(ui, &chart, ground, (quantity.symbol, symbol), ("t", "s"));
    let mut drawn = match &given.answer {
        Some(Answer::Sketch(values)) => values.clone(),
        _ => Vec::new(),
    };
    if given.is_final {
        let line = |values: &[f64], color, width, pattern| {
            let last = values.len().saturating_sub(1).max(1) as f64;
            let at = |(k, value): (usize, &f64)| {
                chart.position(PlotPoint::new(duration * k as f64 / last, value / unit))
            };
            let points = values.iter().enumerate().map(at).collect();
            Primitive::Line { points, stroke: Stroke::new(width, color), pattern }
        };
        let model = line(found, palette.text, 1.8, Pattern::Full);
        let yours = line(&drawn, palette.link(), 2.4, Pattern::Dashed);
        paint(&ui.painter_at(rect), vec![model, yours]);
        let name = format!("Your sketch of {} beside the model’s", quantity.name);
        response.widget_info(|| WidgetInfo::labeled(Role::Image, true, name.as_str()));
        let legend =
            [(Pattern::Dashed, palette.link(), "your sketch"), (Pattern::Full, palette.text, "the model")];
        pad::legend_ui(ui, if drawn.is_empty() { &legend[1..] } else { &legend });
        return;
    }
    if response.dragged()
        && let Some(at) = response.interact_pointer_pos()
    {
        response.request_focus();
        let at = chart.at(at.clamp(rect.min + Vec2::splat(1.0), rect.max - Vec2::splat(1.0)));
        let to = ((at.x / duration * (POINTS - 1) as f64).round() as usize, at.y * unit);
        drawing::stroke(&mut drawn, hand.at, to);
        hand.at = Some(to);
    } else {
        hand.at = None;
    }
    if response.has_focus() {
        arrow_keys::keep(ui, &response);
        let (right, up) = pad::arrows(ui);
        hand.knot = (hand.knot as f64 + right).clamp(0.0, (KNOTS - 1) as f64) as usize;
        if up != 0.0 {
            let value = drawing::knot(&drawn, hand.knot) + up * FINE * 2.0 * top * unit;
            drawing::set_knot(&mut drawn, hand.knot, value.clamp(-top * unit, top * unit));
        }
    }
    pad::focus(ui, &response);
    paint_sketch(ui, &chart, palette, &drawn, unit, response.has_focus().then_some(hand.knot));
    let at = |knot: usize| fixed(drawing::share(knot) * duration, if duration < 20.0 { 1 } else { 0 });
    let value = significant(drawing::knot(&drawn, hand.knot) / unit, 3);
    let name = format!("Your sketch of {}: {value} {symbol} at {} s", quantity.name, at(hand.knot));
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, name.as_str()));
    ui.ctx().accesskit_node_builder(response.id, |node| {
        node.set_description("Left and right choose a point in time, up and down move it.");
    });
    ui.horizontal_wrapped(|ui| {
        if ui.add_enabled(!drawn.is_empty(), Button::new("Clear the sketch")).clicked() {
            drawn.clear();
            hand.knot = 0;
        }
        let told = if drawn.is_empty() {
            "Draw from left to right, or use the arrow keys."
        } else if drawing::is_whole(&drawn) {
            "Draw over it to change it."
        } else {
            "Go on to the right edge."
        };
        ui.label(RichText::new(told).font(theme::small()).color(palette.weak));
    });
    CollapsingHeader::new(RichText::new("In numbers").font(theme::small())).show(ui, |ui| {
        let across = ((ui.available_width() / PAIR) as usize).max(1);
        Grid::new("numbers").spacing((6.0, 4.0)).show(ui, |ui| {
            for knot in 0..KNOTS {
                let shown = significant(drawing::knot(&drawn, knot) / unit, 3);
                let name = format!("{} at {} s [{symbol}]", quantity.name, at(knot));
                ui.label(RichText::new(format!("{} s", at(knot))).font(theme::small()));
                let id = ui.scope_id().with(knot);
                let field = number_field_ui(ui, id, &name, &shown, (44.0, theme::sizes(ui).small), read);
                if let Some(typed) = field.accepted {
                    drawing::set_knot(&mut drawn, knot, typed * unit);
                }
                if (knot + 1) % across == 0 {
                    ui.end_row();
                }
            }
        });
    });
    given.answer = (!drawn.is_empty()).then_some(Answer::Sketch(drawn));
}

/// The sketch as far as it is drawn, and the point that the arrow keys move.
fn paint_sketch(ui: &Ui, chart: &Chart, palette: &Palette, drawn: &[f64], unit: f64, knot: Option<usize>) {
    let position = |share: f64, value: f64| -> Pos2 {
        chart.position(PlotPoint::new(chart.view.right * share, value / unit))
    };
    let line: Vec<Pos2> = drawn
        .iter()
        .enumerate()
        .map(|(number, value)| position(number as f64 / (POINTS - 1) as f64, *value))
        .collect();
    let stroke = Stroke::new(2.2, palette.link());
    let painter = ui.painter_at(chart.rect.expand(4.0));
    if let (Some(end), false) = (line.last().copied(), drawing::is_whole(drawn)) {
        painter.circle_filled(end, 4.0, palette.link());
    }
    paint(&painter, vec![Primitive::Line { points: line, stroke, pattern: Pattern::Full }]);
    if let Some(knot) = knot {
        let at = position(drawing::share(knot), drawing::knot(drawn, knot));
        painter.circle_filled(at, 6.0, palette.pane);
        painter.circle_stroke(at, 6.0, Stroke::new(2.2, palette.link()));
    }
}
