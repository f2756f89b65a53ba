//! A formula set on the page: fractions, roots, marks above letters, indices, and matrices.

use std::sync::Arc;

use egui::accesskit::Role;
use egui::{
    Color32, FontFamily, FontId, Galley, Pos2, Response, ScrollArea, Sense, Stroke, Ui, Vec2, WidgetInfo,
};

use crate::lesson::formula::{Accent, Formula};
use crate::ui::chart::{Pattern, Primitive, paint};
use crate::ui::fonts;
use crate::ui::theme::{self, Palette};

// In sizes of the type.
/// Height of the axis on which fractions and signs stand.
const AXIS: f32 = 0.25;
/// From the middle of a line of text down to its baseline, in sizes of the text.
const BASELINE: f32 = 0.364;
/// Room around a sign.
const AROUND: f32 = 0.24;
const SCRIPT: f32 = 0.7;
const DROP: f32 = 0.17;
const RISE: f32 = 0.36;
/// Between the line of a fraction and what is above and below it.
const GAP: f32 = 0.14;
/// Between the columns and the rows of a matrix.
const COLUMNS: f32 = 1.0;
const ROWS: f32 = 0.36;
/// Letters of the maths face are smaller than those of the text.
const LARGER: f32 = 1.15;
/// A wide formula is set smaller, down to this; beyond that it scrolls sideways.
const LEAST: f32 = 0.7;

/// A piece that is set: its size about the left end of its baseline, and what it is drawn with.
#[derive(Default)]
struct Set {
    width: f32,
    ascent: f32,
    descent: f32,
    parts: Vec<(Vec2, Part)>,
}

enum Part {
    Text(Arc<Galley>),
    Line(Vec<Vec2>, f32),
    Dot(f32),
}

impl Set {
    /// Adds another piece, its baseline moved to the right and down.
    fn add(&mut self, by: Vec2, other: Self) {
        self.width = self.width.max(by.x + other.width);
        self.ascent = self.ascent.max(other.ascent - by.y);
        self.descent = self.descent.max(other.descent + by.y);
        self.parts.extend(other.parts.into_iter().map(|(at, part)| (at + by, part)));
    }

    fn height(&self) -> f32 {
        self.ascent + self.descent
    }
}

/// Sets pieces of formulas.
struct Setter<'u> {
    ui: &'u Ui,
    color: Color32,
}

/// Draws a formula within a line of text that text alone can't set.
pub fn inline_ui(ui: &mut Ui, formula: &Formula) {
    let (body, color) = (theme::body().size, Palette::of(ui).text);
    let size = LARGER * body;
    let set = Setter { ui, color }.set(formula, size);
    let half = (set.ascent - BASELINE * body).max(set.descent + BASELINE * body);
    let line = ui.text_style_height(&egui::TextStyle::Body);
    // One that is hardly higher than the line takes no more room than the line.
    let height = if 2.0 * half > 1.6 * line { 2.0 * half } else { line };
    let (rect, response) = ui.allocate_exact_size(Vec2::new(set.width, height), Sense::HOVER);
    draw(ui, &set, Pos2::new(rect.left(), rect.center().y + BASELINE * body), size);
    tell(&response, formula);
}

/// A formula that is set and has no place yet.
pub struct Display {
    set: Set,
    size: f32,
    told: String,
}

impl Display {
    /// A formula on a line of its own in text of a size, smaller where it would be wider than the room.
    pub fn of(ui: &Ui, formula: &Formula, text_size: f32, room: f32) -> Self {
        let setter = Setter { ui, color: Palette::of(ui).text };
        let mut size = 1.1 * LARGER * text_size;
        let mut set = setter.set(formula, size);
        if set.width > room {
            size *= (room / set.width).max(LEAST);
            set = setter.set(formula, size);
        }
        Self { set, size, told: formula.in_words() }
    }

    /// Its width and height.
    pub fn extent(&self) -> Vec2 {
        Vec2::new(self.set.width, self.set.height())
    }

    /// Draws it with its left top corner here.
    pub fn show(&self, ui: &Ui, left_top: Pos2, id: egui::Id) {
        draw(ui, &self.set, left_top + Vec2::new(0.0, self.set.ascent), self.size);
        let response = ui.interact(egui::Rect::from_min_size(left_top, self.extent()), id, Sense::HOVER);
        response.widget_info(|| WidgetInfo::labeled(Role::Label, true, self.told.as_str()));
    }
}

/// Draws a formula on a line of its own.
pub fn display_ui(ui: &mut Ui, formula: &Formula) {
    let size = 1.1 * LARGER * theme::body().size;
    let room = ui.available_width();
    let setter = Setter { ui, color: Palette::of(ui).text };
    let (mut set, mut size) = (setter.set(formula, size), size);
    if set.width > room {
        size *= (room / set.width).max(LEAST);
        set = setter.set(formula, size);
    }
    let (wide, margin) = (set.width > room, 0.3 * size);
    let draw_ui = |ui: &mut Ui| {
        let extent = Vec2::new(set.width.max(if wide { 0.0 } else { room }), set.height() + 2.0 * margin);
        let (rect, response) = ui.allocate_exact_size(extent, Sense::HOVER);
        let left = rect.left() + 0.5 * (rect.width() - set.width).max(0.0);
        draw(ui, &set, Pos2::new(left, rect.top() + margin + set.ascent), size);
        tell(&response, formula);
    };
    if wide {
        ScrollArea::horizontal().show(ui, draw_ui);
    } else {
        draw_ui(ui);
    }
}

/// A screen reader hears it in words.
fn tell(response: &Response, formula: &Formula) {
    response.widget_info(|| WidgetInfo::labeled(Role::Label, true, formula.in_words()));
}

fn draw(ui: &Ui, set: &Set, origin: Pos2, size: f32) {
    let color = Palette::of(ui).text;
    let width = (0.055 * size).max(1.0);
    for (at, part) in &set.parts {
        let at = origin + *at;
        match part {
            Part::Text(galley) => {
                ui.painter().galley(at, galley.clone(), color);
            }
            Part::Line(points, heavier) => {
                let points = points.iter().map(|point| at + *point).collect();
                let stroke = Stroke::new(width * heavier, color);
                paint(ui.painter(), vec![Primitive::Line { points, stroke, pattern: Pattern::Full }]);
            }
            Part::Dot(radius) => {
                ui.painter().circle_filled(at, *radius, color);
            }
        }
    }
}

impl Setter<'_> {
    fn set(&self, formula: &Formula, size: f32) -> Set {
        match formula {
            Formula::Row(pieces) => self.row(pieces, size),
            Formula::Letter(letter) => self.text(&letter.to_string(), fonts::maths(), size),
            Formula::Number(text) => self.text(text, fonts::maths(), size),
            Formula::Mark(mark) => self.text(&mark.to_string(), fonts::maths(), size),
            Formula::Sign(sign) => self.text(&sign.to_string(), fonts::maths(), size),
            Formula::Function(name) => self.text(name, fonts::maths_upright(), size),
            Formula::Words(text) => self.text(text, FontFamily::Proportional, 0.86 * size),
            Formula::Space(room) => Set { width: room * size, ..Set::default() },
            Formula::Accent(accent, base) => self.accent(*accent, base, size),
            Formula::Script { base, lowered, raised } => {
                let mut set = self.set(base, size);
                let (tall, deep) = (set.ascent > 0.8 * size, set.descent > 0.3 * size);
                let x = set.width + 0.03 * size;
                let (rise, drop) = (
                    if tall { set.ascent - 0.3 * size } else { RISE * size },
                    if deep { set.descent } else { DROP * size },
                );
                for (script, y) in [(raised, -rise), (lowered, drop)] {
                    if let Some(script) = script {
                        set.add(Vec2::new(x, y), self.set(script, SCRIPT * size));
                    }
                }
                set
            }
            Formula::Fraction(above, below) => self.fraction(above, below, size),
            Formula::Root(inner) => self.root(inner, size),
            Formula::Fenced(left, inner, right) => self.fenced(*left, inner, *right, size),
            Formula::Matrix(rows) => self.matrix(rows, size),
        }
    }

    fn text(&self, text: &str, family: FontFamily, size: f32) -> Set {
        let galley = self.ui.painter().layout_no_wrap(text.to_owned(), FontId::new(size, family), self.color);
        let row = galley.rows.first();
        let baseline = row.and_then(|row| Some(row.pos.y + row.glyphs.first()?.pos.y)).unwrap_or(0.0);
        let is_low = |c: char| "acemnorsuvwxzαγεηικμνοπρστυχψω·−=→,.".contains(c);
        let is_deep = |c: char| "gjpqyβγζημξρφχψ,;()[]{}|".contains(c);
        Set {
            width: galley.size().x,
            ascent: if text.chars().all(is_low) { 0.47 * size } else { 0.7 * size },
            descent: if text.chars().any(is_deep) { 0.21 * size } else { 0.02 * size },
            parts: vec![(Vec2::new(0.0, -baseline), Part::Text(galley))],
        }
    }

    fn row(&self, pieces: &[Formula], size: f32) -> Set {
        let mut set = Set::default();
        let mut x = 0.0;
        // Where nothing stands to the left of it, a sign belongs to what follows.
        let mut is_start = true;
        for (number, piece) in pieces.iter().enumerate() {
            let (before, after) = match piece {
                Formula::Sign(_) if is_start => (0.0, 0.06),
                Formula::Sign(_) => (AROUND, AROUND),
                Formula::Function(_) => (if is_start { 0.0 } else { 0.15 }, 0.15),
                Formula::Mark(',' | ';') => (0.0, 0.2),
                Formula::Fraction(..) => (0.06, 0.06),
                Formula::Fenced(..) => (0.04, 0.16),
                _ => (0.0, 0.03),
            };
            let next = self.set(piece, size);
            x += before * size;
            let width = next.width;
            set.add(Vec2::new(x, 0.0), next);
            x += width + if number + 1 < pieces.len() { after * size } else { 0.0 };
            is_start = matches!(piece, Formula::Sign(_) | Formula::Mark('(' | '['));
        }
        set.width = x;
        set
    }

    fn fraction(&self, above: &Formula, below: &Formula, size: f32) -> Set {
        let smaller = 0.88 * size;
        let (above, below) = (self.set(above, smaller), self.set(below, smaller));
        let width = above.width.max(below.width) + 0.24 * size;
        let axis = AXIS * size;
        let mut set = Set { width, ..Set::default() };
        let line = vec![Vec2::new(0.04 * size, -axis), Vec2::new(width - 0.04 * size, -axis)];
        set.parts.push((Vec2::ZERO, Part::Line(line, 1.0)));
        let up = -axis - GAP * size - above.descent;
        let down = -axis + GAP * size + below.ascent;
        set.add(Vec2::new(0.5 * (width - above.width), up), above);
        set.add(Vec2::new(0.5 * (width - below.width), down), below);
        set
    }

    fn root(&self, inner: &Formula, size: f32) -> Set {
        let inner = self.set(inner, size);
        let (top, bottom) = (inner.ascent.max(0.6 * size) + 0.14 * size, inner.descent.max(0.05 * size));
        let sign = 0.62 * size;
        let width = sign + inner.width + 0.06 * size;
        let mut set = Set { width, ascent: top + 0.05 * size, descent: bottom, parts: Vec::new() };
        let thin = vec![Vec2::new(0.05 * size, -0.22 * size), Vec2::new(0.17 * size, -0.3 * size)];
        let thick = vec![Vec2::new(0.17 * size, -0.3 * size), Vec2::new(0.36 * size, bottom)];
        let rest =
            vec![Vec2::new(0.36 * size, bottom), Vec2::new(sign - 0.06 * size, -top), Vec2::new(width, -top)];
        for (line, heavier) in [(thin, 1.0), (thick, 1.7), (rest, 1.0)] {
            set.parts.push((Vec2::ZERO, Part::Line(line, heavier)));
        }
        set.add(Vec2::new(sign, 0.0), inner);
        set
    }

    fn accent(&self, accent: Accent, base: &Formula, size: f32) -> Set {
        let mut set = self.set(base, size);
        // The middle of a letter that leans is to the right at its top.
        let middle = 0.5 * set.width + 0.06 * size;
        let y = -set.ascent - 0.14 * size;
        let at = |x: f32, y: f32| Vec2::new(x, y);
        let half = 0.5 * set.width.max(0.4 * size);
        match accent {
            Accent::Dot => set.parts.push((at(middle, y), Part::Dot(0.065 * size))),
            Accent::TwoDots => {
                for side in [-0.12, 0.12] {
                    set.parts.push((at(middle + side * size, y), Part::Dot(0.06 * size)));
                }
            }
            Accent::Bar => {
                let line = vec![at(middle - half, y), at(middle + half, y)];
                set.parts.push((Vec2::ZERO, Part::Line(line, 1.0)));
            }
            Accent::Hat => {
                let (left, right) = (middle - 0.18 * size, middle + 0.18 * size);
                let line =
                    vec![at(left, y + 0.06 * size), at(middle, y - 0.08 * size), at(right, y + 0.06 * size)];
                set.parts.push((Vec2::ZERO, Part::Line(line, 1.0)));
            }
            Accent::Arrow => {
                let (tip, barb) = (middle + half, 0.1 * size);
                let shaft = vec![at(middle - half, y), at(tip, y)];
                let head = vec![at(tip - barb, y - barb), at(tip, y), at(tip - barb, y + barb)];
                for line in [shaft, head] {
                    set.parts.push((Vec2::ZERO, Part::Line(line, 1.0)));
                }
            }
        }
        set.ascent += 0.24 * size;
        set
    }

    fn fenced(&self, left: Option<char>, inner: &Formula, right: Option<char>, size: f32) -> Set {
        let inner = self.set(inner, size);
        let (top, bottom) = (inner.ascent + 0.08 * size, inner.descent + 0.08 * size);
        let is_tall = top + bottom > 1.25 * size;
        let mut set = Set::default();
        let mut x = 0.0;
        let bracket = |set: &mut Set, x: f32, bracket: Option<char>| -> f32 {
            let Some(bracket) = bracket else { return 0.0 };
            if !is_tall {
                let mark = self.text(&bracket.to_string(), fonts::maths(), size);
                let width = mark.width;
                set.add(Vec2::new(x, 0.0), mark);
                return width;
            }
            let width = 0.3 * size;
            let points = tall(bracket, 0.22 * size, top, bottom);
            set.parts.push((Vec2::new(x + 0.04 * size, 0.0), Part::Line(points, 1.1)));
            width
        };
        x += bracket(&mut set, x, left);
        let width = inner.width;
        set.add(Vec2::new(x, 0.0), inner);
        x += width;
        x += bracket(&mut set, x, right);
        set.width = x;
        if is_tall {
            (set.ascent, set.descent) = (top, bottom);
        }
        set
    }

    fn matrix(&self, rows: &[Vec<Formula>], size: f32) -> Set {
        let cells: Vec<Vec<Set>> =
            rows.iter().map(|row| row.iter().map(|cell| self.set(cell, size)).collect()).collect();
        let columns = cells.iter().map(Vec::len).max().unwrap_or(0);
        let widest = |column: usize| {
            cells.iter().filter_map(|row| row.get(column)).map(|cell| cell.width).fold(0.0, f32::max)
        };
        let widths: Vec<f32> = (0..columns).map(widest).collect();
        let most =
            |row: &[Set], part: fn(&Set) -> f32, least: f32| row.iter().map(part).fold(least, f32::max);
        let heights: Vec<(f32, f32)> = cells
            .iter()
            .map(|row| {
                (most(row, |cell| cell.ascent, 0.6 * size), most(row, |cell| cell.descent, 0.1 * size))
            })
            .collect();
        let gaps = ROWS * size * heights.len().saturating_sub(1) as f32;
        let whole: f32 = heights.iter().map(|(up, down)| up + down).sum::<f32>() + gaps;
        let mut set = Set::default();
        let mut y = -AXIS * size - 0.5 * whole;
        for (row, (up, down)) in cells.into_iter().zip(heights) {
            y += up;
            let mut x = 0.1 * size;
            for (cell, width) in row.into_iter().zip(&widths) {
                set.add(Vec2::new(x + 0.5 * (width - cell.width), y), cell);
                x += width + COLUMNS * size;
            }
            y += down + ROWS * size;
        }
        set.width =
            widths.iter().sum::<f32>() + COLUMNS * size * columns.saturating_sub(1) as f32 + 0.2 * size;
        set
    }
}

/// A tall bracket as a line, in a box of this width.
fn tall(bracket: char, width: f32, top: f32, bottom: f32) -> Vec<Vec2> {
    let at = |x: f32, y: f32| Vec2::new(x * width, -top + y * (top + bottom));
    match bracket {
        '[' => vec![at(0.8, 0.0), at(0.0, 0.0), at(0.0, 1.0), at(0.8, 1.0)],
        ']' => vec![at(0.2, 0.0), at(1.0, 0.0), at(1.0, 1.0), at(0.2, 1.0)],
        '(' => (0..=16).map(|k| k as f32 / 16.0).map(|y| at(4.0 * (y - 0.5).powi(2), y)).collect(),
        ')' => (0..=16).map(|k| k as f32 / 16.0).map(|y| at(1.0 - 4.0 * (y - 0.5).powi(2), y)).collect(),
        '{' => vec![
            at(1.0, 0.0),
            at(0.5, 0.05),
            at(0.5, 0.45),
            at(0.0, 0.5),
            at(0.5, 0.55),
            at(0.5, 0.95),
            at(1.0, 1.0),
        ],
        '}' => vec![
            at(0.0, 0.0),
            at(0.5, 0.05),
            at(0.5, 0.45),
            at(1.0, 0.5),
            at(0.5, 0.55),
            at(0.5, 0.95),
            at(0.0, 1.0),
        ],
        _ => vec![at(0.5, 0.0), at(0.5, 1.0)],
    }
}
