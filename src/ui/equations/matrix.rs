//! A and B as a board has them: a column a state and an input, a row a rate, each entry a button that leads to its slider.

use std::sync::Arc;

use egui::accesskit::Role;
use egui::{
    Color32, CornerRadius, Galley, Id, Key, Pos2, Rect, Response, ScrollArea, Sense, Stroke, StrokeKind, Ui,
    Vec2, WidgetInfo,
};

use super::formula::Writing;
use crate::findings::Equations;
use crate::findings::equations::{COLUMNS, ROWS, STATES};
use crate::flight::modes::mode_name::ModeName;
use crate::ui::symbol::Symbol;
use crate::ui::theme::{self, Palette};
use crate::ui::{arrow_keys, copy, influence};
use crate::words;
use crate::words::sensitivity::NOTHING;

/// Sizes of type that entries may have, beside the sliders and where they are alone \[points\].
const SMALL: [f32; 2] = [11.0, 14.0];
const LARGE: [f32; 2] = [13.0, 34.0];
/// Lines of the large entries' type that a pane is to have room for.
const LINES: f32 = 22.0;
/// The same where a room looks on, without words below.
const LINES_FOR_A_ROOM: f32 = 10.5;
/// The size at which entries are measured, to find the one that fits.
const MEASURED: f32 = 20.0;
// In sizes of type.
const PADDING: f32 = 0.45;
const GAP: f32 = 0.7;
const ROW: f32 = 1.75;
const LARGE_ROW: f32 = 2.3;
const BRACKET: f32 = 0.3;
/// Height of a row for a finger \[points\].
const TOUCH_ROW: f32 = 40.0;
/// Greatest share of a mode's colour in the ground of an entry: words on it stay legible.
const DEEPEST: f32 = 0.42;
/// Height of the bar of an entry \[points\].
const BAR: f32 = 3.0;

/// A place in the matrices: row, and column with those of B after those of A.
pub(super) type Place = (usize, usize);

/// Beside all of them.
pub(super) const NOWHERE: Place = (ROWS, COLUMNS);

/// What is drawn.
#[derive(Clone, Copy, Debug)]
pub(super) struct Matrices<'a> {
    pub writing: Writing<'a>,
    /// The mode whose colours they have: its place, its name, and that in a sentence.
    pub mode: Option<(usize, ModeName, &'a str)>,
    pub chosen: Place,
    /// Whether they are alone, in large type.
    pub is_large: bool,
    pub by_finger: bool,
}

/// What a person did with the matrices.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Picked {
    /// The entry that is at hand from now on.
    pub chosen: Option<Place>,
    /// The entry that the pointer is over.
    pub hovered: Option<Place>,
    /// The entry whose slider is asked for.
    pub asked: Option<Place>,
    /// Whether the keyboard has gone to the chosen one.
    is_moved: bool,
}

/// The matrices in a size of type, before they have a place.
struct Layout {
    size: f32,
    entries: Vec<Vec<Arc<Galley>>>,
    rates: Vec<Arc<Galley>>,
    columns: Vec<Arc<Galley>>,
    widths: [f32; COLUMNS],
    rate_width: f32,
}

impl Layout {
    fn of(ui: &Ui, matrices: &Matrices<'_>, size: f32) -> Self {
        let palette = Palette::of(ui);
        let Equations { plane, convention, .. } = *matrices.writing.equations;
        let galley = |text: &str, color: Color32| {
            let job = Symbol::parse(text).job(size, color);
            ui.painter().layout_job(job)
        };
        let entry = |row: usize, column: usize| galley(&matrices.writing.entry(row, column), palette.text);
        let row = |row: usize| (0..COLUMNS).map(|column| entry(row, column)).collect();
        let entries: Vec<Vec<Arc<Galley>>> = (0..ROWS).map(row).collect();
        let rates: Vec<_> = words::equations::rates(plane, convention.notation)
            .iter()
            .map(|rate| galley(rate, palette.text))
            .collect();
        let columns: Vec<_> = words::equations::columns(plane, convention.notation)
            .iter()
            .map(|state| galley(state, palette.weak))
            .collect();
        let width = |column: usize| {
            let of_column = entries.iter().map(|row| row[column].size().x).chain([columns[column].size().x]);
            of_column.fold(size, f32::max) + 2.0 * PADDING * size
        };
        let widths = std::array::from_fn(width);
        let rate_width = rates.iter().map(|rate| rate.size().x).fold(0.0, f32::max);
        Self { size, entries, rates, columns, widths, rate_width }
    }

    fn width(&self) -> f32 {
        self.rate_width + self.widths.iter().sum::<f32>() + (2.0 * GAP + 4.0 * BRACKET) * self.size + 4.0
    }
}

/// Draws the matrices as large as they fit; where they don't, they scroll sideways in a box of their own.
pub(super) fn matrices_ui(ui: &mut Ui, matrices: Matrices<'_>) -> Picked {
    let room = ui.available_width();
    let [smallest, largest] = if matrices.is_large { LARGE } else { SMALL };
    let measured = Layout::of(ui, &matrices, MEASURED).width();
    // In half points, so that a number that gets a digit more doesn't make all others tremble.
    let fitting = (2.0 * MEASURED * room / measured).floor() / 2.0;
    // What is seen at once has room for the words below too.
    let lines = if theme::is_for_a_room(ui) { LINES_FOR_A_ROOM } else { LINES };
    let highest = if matrices.is_large { (ui.clip_rect().height() / lines).floor() } else { largest };
    let layout = Layout::of(ui, &matrices, fitting.min(highest).clamp(smallest, largest));
    if layout.width() <= room + 1.0 {
        return board_ui(ui, matrices, &layout);
    }
    let area = ScrollArea::horizontal().id_salt(("matrices", matrices.is_large)).auto_shrink([false, true]);
    area.show(ui, |ui| board_ui(ui, matrices, &layout)).inner
}

fn board_ui(ui: &mut Ui, matrices: Matrices<'_>, layout: &Layout) -> Picked {
    let palette = Palette::of(ui);
    let size = layout.size;
    let is_airy = matrices.is_large && !theme::is_for_a_room(ui);
    let height = if is_airy { LARGE_ROW * size } else { ROW * size };
    let height = if matrices.by_finger { height.max(TOUCH_ROW) } else { height.round() };
    let head = (1.5 * size).round();
    let total = Vec2::new(layout.width(), head + ROWS as f32 * height + 2.0);
    let (board, _) = ui.allocate_exact_size(total, Sense::hover());
    copy::offer(ui, board, &|| {
        let number = |row, column| matrices.writing.number(row, column).0.replace('−', "-");
        let row = |row: usize| (0..COLUMNS).map(|column| number(row, column)).collect::<Vec<_>>().join("\t");
        (0..ROWS).map(row).collect::<Vec<_>>().join("\n") + "\n"
    });
    let bracket = BRACKET * size;
    let left = board.left() + layout.rate_width + 2.0 + 0.5 * GAP * size + bracket;
    let x_of = |column: usize| {
        let before: f32 = layout.widths[..column].iter().sum();
        let gap = if column >= STATES { 0.9 * GAP * size + 2.0 * bracket } else { 0.0 };
        left + before + gap
    };
    let top = board.top() + head;
    let cell = |(row, column): Place| {
        let corner = Pos2::new(x_of(column), top + row as f32 * height);
        Rect::from_min_size(corner, Vec2::new(layout.widths[column], height))
    };
    for (column, galley) in layout.columns.iter().enumerate() {
        let middle = x_of(column) + 0.5 * layout.widths[column];
        let at = Pos2::new(middle - 0.5 * galley.size().x, board.top() + 0.5 * (head - galley.size().y));
        ui.painter().galley(at, galley.clone(), palette.weak);
    }
    let mut picked = Picked::default();
    for (row, galley) in layout.rates.iter().enumerate() {
        let middle = top + (row as f32 + 0.5) * height;
        let at = Pos2::new(board.left() + 2.0, middle - 0.5 * galley.size().y);
        let place = Rect::from_min_max(
            Pos2::new(board.left(), middle - 0.5 * height),
            Pos2::new(left - bracket, middle + 0.5 * height),
        );
        if row == matrices.chosen.0 {
            let whole = Rect::from_min_max(place.min, Pos2::new(board.right(), place.bottom()));
            ui.painter().rect_filled(whole, CornerRadius::same(4), palette.field);
        }
        ui.painter().galley(at, galley.clone(), palette.text);
        // Not a stop of the Tab key: the arrow keys go from row to row.
        if ui
            .interact(place, Id::unique(("row of the equations", matrices.is_large, row)), Sense::CLICK)
            .clicked()
        {
            picked.chosen = Some((row, matrices.chosen.1));
        }
    }
    for row in 0..ROWS {
        for column in 0..COLUMNS {
            entry_ui(
                ui,
                &matrices,
                (row, column),
                cell((row, column)),
                &layout.entries[row][column],
                &mut picked,
            );
        }
    }
    if let Some(place) = picked.chosen.filter(|_| picked.is_moved) {
        // Not before all are drawn: what is no stop of the Tab key gives the focus back.
        ui.memory_mut(|memory| memory.request_focus(entry_id(&matrices, place)));
    }
    let line = Stroke::new((0.07 * size).max(1.2), palette.text);
    for (first, last) in [(0, STATES - 1), (STATES, COLUMNS - 1)] {
        let (x0, x1) = (x_of(first) - 0.3 * bracket, x_of(last) + layout.widths[last] + 0.3 * bracket);
        let (y0, y1) = (top, top + ROWS as f32 * height);
        for (x, inward) in [(x0, bracket), (x1, -bracket)] {
            let corner = |x: f32, y: f32| Pos2::new(x, y);
            let points = vec![corner(x + inward, y0), corner(x, y0), corner(x, y1), corner(x + inward, y1)];
            ui.painter().line(points, line);
        }
    }
    picked
}

fn entry_id(matrices: &Matrices<'_>, (row, column): Place) -> Id {
    Id::unique(("entry", matrices.is_large, row, column))
}

/// An entry: its colour, its number or symbol, and what is said of it.
fn entry_ui(
    ui: &mut Ui,
    matrices: &Matrices<'_>,
    place: Place,
    cell: Rect,
    galley: &Arc<Galley>,
    picked: &mut Picked,
) {
    let palette = Palette::of(ui);
    let is_chosen = place == matrices.chosen;
    // One stop of the Tab key; from there the arrow keys go on.
    let sense = if is_chosen { Sense::click() } else { Sense::CLICK };
    let response = ui.interact(cell, entry_id(matrices, place), sense);
    if let Some((index, name, _)) = matrices.mode {
        let strength = matrices.writing.equations.strength(index, place.0, place.1);
        if let Some(strength) = strength.filter(|strength| *strength >= NOTHING) {
            let share = influence::share(strength);
            let ground = palette.mode(name).gamma_multiply(DEEPEST * share);
            ui.painter().rect_filled(cell.shrink(1.0), CornerRadius::same(3), ground);
            let bar = Rect::from_min_size(
                Pos2::new(cell.left() + 2.0, cell.bottom() - BAR - 1.0),
                Vec2::new((share * (cell.width() - 4.0)).max(1.0), BAR),
            );
            ui.painter().rect_filled(bar, CornerRadius::ZERO, palette.mode(name));
        }
    }
    ui.painter().galley(cell.center() - 0.5 * galley.size(), galley.clone(), palette.text);
    if response.hovered() {
        picked.hovered = Some(place);
        ui.painter().rect_stroke(
            cell.shrink(1.0),
            CornerRadius::same(3),
            Stroke::new(1.0, palette.accent),
            StrokeKind::Inside,
        );
    }
    if response.has_focus() {
        ui.painter().rect_stroke(
            cell,
            CornerRadius::same(4),
            Stroke::new(2.0, palette.accent),
            StrokeKind::Inside,
        );
        arrow_keys::keep(ui, &response);
        let moved = moved_by_keys(ui, place);
        if moved != place {
            picked.chosen = Some(moved);
            picked.is_moved = true;
        }
        if ui.input(|input| input.key_pressed(Key::Enter)) {
            picked.asked = Some(place);
        }
    } else if is_chosen {
        ui.painter().rect_stroke(
            cell,
            CornerRadius::same(4),
            Stroke::new(1.0, palette.weak),
            StrokeKind::Inside,
        );
    }
    if response.clicked() && !ui.input(|input| input.key_pressed(Key::Enter)) {
        picked.chosen = Some(place);
        picked.asked = Some(place);
    }
    tell(ui, matrices, place, response);
}

/// Where the arrow keys go from an entry.
fn moved_by_keys(ui: &Ui, (row, column): Place) -> Place {
    ui.input(|input| {
        let presses = |forward, back| input.num_presses(forward) as isize - input.num_presses(back) as isize;
        let row = row.saturating_add_signed(presses(Key::ArrowDown, Key::ArrowUp)).min(ROWS - 1);
        let column = column.saturating_add_signed(presses(Key::ArrowRight, Key::ArrowLeft)).min(COLUMNS - 1);
        (row, column)
    })
}

/// The place of an entry, its symbol and its value, for a screen reader and under the pointer.
fn tell(ui: &Ui, matrices: &Matrices<'_>, (row, column): Place, response: Response) {
    let Matrices { writing, mode, .. } = matrices;
    let equations = writing.equations;
    let (number, unit) = writing.number(row, column);
    let mut sentence = words::equations::place(equations.plane, equations.convention.notation, (row, column));
    if let Some(symbol) = writing.symbol(row, column) {
        sentence.push_str(&format!(": {}", Symbol::parse(&symbol).plain()));
    }
    sentence.push_str(format!(" = {number} {unit}").trim_end());
    copy::offer(ui, response.rect, &|| sentence.clone());
    if let Some((index, _, name)) = mode
        && let Some(strength) = equations.strength(*index, row, column).filter(|_| column < STATES)
    {
        sentence.push_str(&format!("; {}", words::equations::strength(strength, name)));
    }
    response.widget_info(|| WidgetInfo::labeled(Role::Button, ui.is_enabled(), &sentence));
    let hover = match equations.slider(row, column) {
        Some((parameter, _)) => format!("{}: {sentence}", parameter.name),
        None => sentence,
    };
    response.on_hover_text(hover);
}
