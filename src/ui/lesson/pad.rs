//! A pad to draw on: two axes with round numbers, within the pane of the lesson, so that it is there on a phone too.

use egui::{Align2, Color32, FontId, Pos2, Rect, Response, Sense, Stroke, StrokeKind, Ui, Vec2};

use crate::ui::chart::{Chart, Pattern, PlotPoint, Primitive, Room, SAMPLE, Scale, View, paint, sample};
use crate::ui::symbol::Symbol;
use crate::ui::theme::{self, Palette};

/// Room for the numbers left of the axes and below them.
const GUTTER: Vec2 = Vec2::new(38.0, 15.0);
/// Room above for what the axes are.
const TITLE: f32 = 18.0;
/// Greatest width.
const WIDEST: f32 = 440.0;
/// How far the numbers of an axis may reach beyond it.
const OVERHANG: f32 = 10.0;

/// Takes room for a pad of a height; gives the rectangle within its axes.
pub fn room(ui: &mut Ui, height: f32, sense: Sense) -> (Rect, Response) {
    let size = Vec2::new(ui.available_width().min(WIDEST), height);
    let (whole, _) = ui.allocate_exact_size(size, Sense::HOVER);
    let rect =
        Rect::from_min_max(whole.min + Vec2::new(GUTTER.x, TITLE), whole.max - Vec2::new(OVERHANG, GUTTER.y));
    let response = ui.interact(rect, ui.scope_id().with("pad"), sense);
    (rect, response)
}

/// Draws the axes on grounds of their own: grid, zero, numbers, and what they measure: symbol and unit upward, then across.
pub fn axes(ui: &Ui, chart: &Chart, grounds: Vec<Primitive>, upward: (&str, &str), across: (&str, &str)) {
    let palette = Palette::of(ui);
    let (rect, View { left, right, bottom, top }) = (chart.rect, chart.view);
    let font = FontId::proportional(theme::sizes(ui).tick);
    let painter = ui.painter();
    let extent = |text: &str| painter.layout_no_wrap(text.to_owned(), font.clone(), palette.weak).size();
    let width = |text: &str| extent(text).x;
    let height = extent("0").y;
    let ticks = [
        Scale::Even.ticks(
            &(left..=right),
            Room { length: rect.width(), apart: 36.0, extent: &width, overhang: OVERHANG },
        ),
        Scale::Even.ticks(
            &(bottom..=top),
            Room { length: rect.height(), apart: 26.0, extent: &|_| height, overhang: 1.0 },
        ),
    ];
    let line =
        |ends: [Pos2; 2], color: Color32| Primitive::line(ends, Stroke::new(1.0, color), Pattern::Full);
    let at = |x: f64, y: f64| chart.position(PlotPoint::new(x, y));
    let mut list = grounds;
    list.extend(ticks[0].iter().map(|t| line([at(t.value, bottom), at(t.value, top)], palette.hairline)));
    list.extend(ticks[1].iter().map(|t| line([at(left, t.value), at(right, t.value)], palette.hairline)));
    if bottom < 0.0 && top > 0.0 {
        list.push(line([at(left, 0.0), at(right, 0.0)], palette.pinned));
    }
    if left < 0.0 && right > 0.0 {
        list.push(line([at(0.0, bottom), at(0.0, top)], palette.pinned));
    }
    paint(painter, list);
    for tick in &ticks[0] {
        let below = Pos2::new(at(tick.value, 0.0).x, rect.bottom() + 1.0);
        painter.text(below, Align2::CENTER_TOP, &tick.label, font.clone(), palette.weak);
    }
    for tick in &ticks[1] {
        let beside = Pos2::new(rect.left() - 4.0, at(0.0, tick.value).y);
        painter.text(beside, Align2::RIGHT_CENTER, &tick.label, font.clone(), palette.weak);
    }
    painter.rect_stroke(rect, 3.0, Stroke::new(1.0, palette.hairline), StrokeKind::Inside);
    let size = theme::sizes(ui).inline_symbol;
    let mut job = Symbol::parse(upward.0).job(size, palette.text);
    let weak = || egui::TextFormat::simple(theme::small(), palette.weak);
    job.append(&format!(" {}  over  ", upward.1), 0.0, weak());
    Symbol::parse(across.0).append_to(&mut job, size, palette.text);
    job.append(&format!(" {}", across.1), 0.0, weak());
    let title = painter.layout_job(job);
    painter.galley(rect.min - Vec2::new(0.0, TITLE), title, palette.text);
}

/// Draws the frame of a pad that has the focus.
pub fn focus(ui: &Ui, response: &Response) {
    if response.has_focus() {
        let ring = Stroke::new(2.0, Palette::of(ui).accent);
        ui.painter().rect_stroke(response.rect, 3.0, ring, StrokeKind::Outside);
    }
}

/// A row that says what is drawn how.
pub fn legend_ui(ui: &mut Ui, entries: &[(Pattern, Color32, &str)]) {
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().interact_size.y = 0.0;
        for (pattern, color, name) in entries {
            let (rect, _) = ui.allocate_exact_size(Vec2::new(SAMPLE, 12.0), Sense::HOVER);
            paint(ui.painter(), vec![sample(rect.left_center(), *pattern, *color)]);
            ui.label(egui::RichText::new(*name).font(theme::small()));
            ui.add_space(8.0);
        }
    });
}

/// How many steps the arrow keys ask for to the right and up, with Shift ten at once.
pub fn arrows(ui: &Ui) -> (f64, f64) {
    use egui::{Event, Key};
    let mut steps = (0.0, 0.0);
    ui.input(|input| {
        for event in &input.events {
            let Event::Key { key, pressed: true, modifiers, .. } = event else { continue };
            let step = if modifiers.shift { 10.0 } else { 1.0 };
            match key {
                Key::ArrowRight => steps.0 += step,
                Key::ArrowLeft => steps.0 -= step,
                Key::ArrowUp => steps.1 += step,
                Key::ArrowDown => steps.1 -= step,
                _ => {}
            }
        }
    });
    steps
}
