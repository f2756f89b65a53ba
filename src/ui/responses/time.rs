//! The motion over time: small multiples on one time axis with one cursor, whole or split into its modes.

use egui::containers::menu::{MenuButton, MenuConfig};
use egui::style::StyleModifier;
use egui::{PopupCloseBehavior, Rect, Ui, Vec2};

use super::curves::units;
use super::legend::{self, Entry};
use super::{CacheKey, Canvas, curves, kept, line, note_ui, plain_line};
use crate::few;
use crate::findings::Findings;
use crate::flight::aircraft::plane::Plane;
use crate::flight::motion::modal_decomposition::SplitError;
use crate::flight::motion::outputs::Output;
use crate::scenario::Quantity;
use crate::ui::chart::{Curve, Pattern, PlotContent, SmallPlot};
use crate::ui::derivatives::Rows;
use crate::ui::theme;

/// Least height of a small plot \[points\].
const LEAST_HEIGHT: f32 = 120.0;
/// Height of one as high as wide, for fingers.
const TALL: f32 = 300.0;
const GAP: Vec2 = Vec2::new(12.0, 6.0);

/// The plots over time, and where the cursor is.
#[derive(Debug, Default)]
pub struct TimePlots {
    plots: Vec<SmallPlot>,
    /// Time under the pointer \[s\].
    hovered: Option<f64>,
    /// Time of the playback \[s\].
    pub played: Option<f64>,
    sheet: Option<(Key, CachedPlots)>,
}

/// What is shown, of which outputs, and whether split.
type Key = (CacheKey, Vec<Output>, bool);

/// What the plots show.
#[derive(Debug)]
struct CachedPlots {
    pictures: Vec<PlotContent>,
    entries: Vec<Entry>,
    /// Why the motion isn't split.
    unsplit: Option<SplitError>,
}

impl CachedPlots {
    fn of(canvas: Canvas<'_>, chosen: &[Output], split: bool) -> Self {
        let Canvas { findings, pinned, view, palette, curtain, .. } = canvas;
        let scenario = findings.scenario();
        let length = scenario.length_unit();
        let mut pictures: Vec<PlotContent> = Vec::new();
        let mut unsplit = None;
        let duration = scenario.disturbance.sizes.time.max(1e-3);
        for &output in chosen {
            let (quantity, symbol, unit) = units(output, scenario);
            let linear = |of: &Findings, pattern, color| curves::linear(of, output, unit, pattern, color);
            let mut drawn: Vec<Curve> = linear(findings, Pattern::Full, palette.text).into_iter().collect();
            if split {
                match curves::parts(findings, output, unit, (palette, curtain)) {
                    Ok(parts) => drawn.extend(parts),
                    Err(error) => unsplit = Some(error),
                }
            }
            if view.shows_flight() {
                drawn.extend(curves::nonlinear(findings, output, unit, palette));
            }
            // The pinned state is drawn in the units of the one on screen.
            drawn.extend(pinned.and_then(|pinned| linear(pinned, Pattern::Dashed, palette.pinned)));
            if output == Output::Height {
                drawn.extend(curves::ground(findings, 0.0..=duration, unit, palette));
            }
            let small_until = findings.flown_motion().and_then(|motion| motion.small_until);
            let grounds =
                small_until.map(|time| (time..=duration, palette.unstable_half)).into_iter().collect();
            let picture = PlotContent { grounds, ..PlotContent::of_time(quantity.symbol, symbol, drawn) };
            pictures.push(canvas.veiled(picture));
        }
        let entries = legend::curves(&pictures);
        if let Some((quantities, dimension, curves)) = curves::inputs(findings, palette) {
            let symbol = quantities.first().copied().unwrap_or_default();
            let unit = dimension.symbol(length);
            pictures.push(PlotContent { quantities, ..PlotContent::of_time(symbol, unit, curves) });
        }
        for (symbol, dimension, curves) in curves::by_law(findings, view.shows_flight(), palette) {
            let unit = dimension.symbol(length);
            pictures.push(canvas.veiled(PlotContent::of_time(symbol, unit, curves)));
        }
        for picture in &mut pictures {
            picture.x_range = Some(0.0..=duration);
        }
        Self { pictures, entries, unsplit }
    }
}

impl TimePlots {
    /// Time under the pointer \[s\].
    pub fn hovered(&self) -> Option<f64> {
        self.hovered
    }

    /// Forgets the time under the pointer.
    pub fn leave(&mut self) {
        self.hovered = None;
    }

    /// Where the cursor stands \[s\]: under the pointer, else where the playback is.
    fn cursor(&self) -> Option<f64> {
        self.hovered.or(self.played)
    }

    /// Draws the plots over all the room there is.
    pub fn show(&mut self, ui: &mut Ui, canvas: Canvas<'_>) {
        let chosen = &canvas.view.shown[canvas.findings.scenario().plane];
        let split = canvas.view.split;
        let (cursor, before) = (self.cursor(), self.hovered);
        let key = (CacheKey::of(canvas), chosen.clone(), split);
        let CachedPlots { pictures, entries, unsplit } =
            kept(&mut self.sheet, key, || CachedPlots::of(canvas, chosen, split));
        if let Some(error) = unsplit {
            note_ui(ui, &format!("No split into modes: {error}."));
        }
        let is_for_a_room = theme::is_for_a_room(ui);
        if is_for_a_room {
            legend::legend_ui(ui, &legend::for_a_room(entries, canvas), canvas.beside);
        } else {
            legend::legend_ui(ui, entries, canvas.beside);
        }
        let count = if is_for_a_room { most(ui, pictures.len()) } else { pictures.len() };
        let places = grid(ui, count, canvas.rows);
        self.plots.resize_with(self.plots.len().max(places.len()), SmallPlot::default);
        let mut hovered = None;
        for ((plot, picture), place) in self.plots.iter_mut().zip(pictures).zip(places) {
            hovered = plot.show(ui, place, picture, cursor).or(hovered);
        }
        self.hovered = hovered;
        if before != hovered {
            // The plots drawn before the pointer's see it in the next frame.
            ui.request_repaint();
        }
    }
}

/// Which outputs, and whether split.
pub fn choosers_ui(ui: &mut Ui, plane: Plane, chosen: &mut Vec<Output>, split: &mut bool) {
    // Boxes to tick have their outline, which the style of menus takes away.
    let config = MenuConfig::new().style(StyleModifier::default());
    let config = config.close_behavior(PopupCloseBehavior::CloseOnClickOutside);
    let button = MenuButton::new("Show ▾").config(config);
    let (response, _) = button.ui(ui, |ui| {
        for &output in Output::of(plane) {
            let quantity = Quantity::of(output);
            let mut on = chosen.contains(&output);
            let shown = ui.checkbox(&mut on, line(ui, quantity));
            if shown.accessible_name(plain_line(quantity)).clicked() {
                if on {
                    chosen.push(output);
                } else if chosen.len() > 1 {
                    chosen.retain(|other| *other != output);
                }
                // In the order of the list, whatever the order of the clicks.
                few::sort_by_key(chosen, |output| Output::of(plane).iter().position(|other| other == output));
            }
        }
    });
    response.accessible_name("Quantities shown").on_hover_text("Which quantities are shown");
    ui.checkbox(split, "Split into modes").on_hover_text(
        "Every linear motion is a sum of its modes: each in its colour, together the dark line",
    );
}

/// Least height of a small plot for a room \[points\].
const LEAST_FOR_A_ROOM: f32 = 76.0;
/// From this width on plots for a room stand beside each other.
const BESIDE: f32 = 300.0;

/// How many plots a room can read at once in the room that there is: rather fewer than smaller.
fn most(ui: &Ui, count: usize) -> usize {
    let down = (ui.available_height() / (LEAST_FOR_A_ROOM + GAP.y)).floor().max(1.0) as usize;
    let across = columns(ui, count, Rows::Dense);
    count.min(down * across)
}

/// Height that `count` plots need for a room to read all of them in a room of this size \[points\].
pub fn height_for_a_room(size: Vec2, count: usize) -> f32 {
    count.div_ceil(columns_for_a_room(size, count)) as f32 * (LEAST_FOR_A_ROOM + GAP.y)
}

/// How many of `count` plots for a room stand beside each other. Curves over time want to be wide.
fn columns_for_a_room(size: Vec2, count: usize) -> usize {
    let height = size.y / count.max(1) as f32;
    if count < 2 || size.x < BESIDE || height > 1.3 * LEAST_FOR_A_ROOM { 1 } else { 2 }
}

/// How many of `count` plots stand beside each other.
fn columns(ui: &Ui, count: usize, rows: Rows) -> usize {
    let width = ui.available_width();
    let columns = match rows {
        Rows::Touch => 1,
        Rows::Dense if theme::is_for_a_room(ui) => columns_for_a_room(ui.available_size(), count),
        Rows::Dense if width > 600.0 && (count == 3 || count > 4) => 3,
        Rows::Dense => 2,
    };
    columns.min(count.max(1))
}

/// Places for `count` plots, in the order of reading, over all the room there is.
pub fn grid(ui: &mut Ui, count: usize, rows: Rows) -> Vec<Rect> {
    grid_of(ui, count, rows, LEAST_HEIGHT)
}

/// The same for plots as high as they are wide.
pub fn tall_grid(ui: &mut Ui, count: usize, rows: Rows) -> Vec<Rect> {
    let least = if rows == Rows::Touch { ui.available_width().min(TALL) } else { LEAST_HEIGHT };
    grid_of(ui, count, rows, least)
}

fn grid_of(ui: &mut Ui, count: usize, rows: Rows, least: f32) -> Vec<Rect> {
    let width = ui.available_width();
    let columns = columns(ui, count, rows);
    let down = count.div_ceil(columns).max(1);
    let least = if theme::is_for_a_room(ui) { 0.0 } else { least * down as f32 };
    let height = if rows == Rows::Touch { least } else { ui.available_height().max(least) };
    let (area, _) = ui.allocate_exact_size(Vec2::new(width, height), egui::Sense::hover());
    let cell = Vec2::new(
        (area.width() - GAP.x * (columns as f32 - 1.0)) / columns as f32,
        (area.height() - GAP.y * (down as f32 - 1.0)) / down as f32,
    );
    (0..count)
        .map(|i| {
            let (row, column) = ((i / columns) as f32, (i % columns) as f32);
            Rect::from_min_size(area.min + Vec2::new(column * (cell.x + GAP.x), row * (cell.y + GAP.y)), cell)
        })
        .collect()
}
