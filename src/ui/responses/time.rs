//! The motion over time: small multiples on one time axis with one cursor, whole or split into its modes.

use egui::containers::menu::{MenuButton, MenuConfig};
use egui::style::StyleModifier;
use egui::{PopupCloseBehavior, Rect, Ui, Vec2};

use super::curves::units;
use super::legend::{self, Entry};
use super::{CacheKey, Canvas, curves, kept, line, note_ui, plain_line};
use crate::content::LengthUnit;
use crate::findings::Findings;
use crate::flight::aircraft::plane::Plane;
use crate::flight::motion::modal_decomposition::SplitError;
use crate::flight::motion::outputs::Output;
use crate::scenario::Quantity;
use crate::ui::chart::{Curve, Pattern, PlotContent, SmallPlot};
use crate::ui::derivatives::Rows;

/// Least height of a small plot \[points\].
const LEAST_HEIGHT: f32 = 120.0;
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
            let small_until = findings.motion().and_then(|motion| motion.small_until);
            let beyond = small_until.map(|time| time..=duration);
            let picture = PlotContent { beyond, ..PlotContent::of_time(quantity.symbol, symbol, drawn) };
            pictures.push(canvas.veiled(picture));
        }
        let entries = legend::curves(&pictures);
        if let Some((quantities, dimension, curves)) = curves::inputs(findings, palette) {
            let symbol = quantities.first().copied().unwrap_or_default();
            let unit = dimension.symbol(LengthUnit::Metre);
            pictures.push(PlotContent { quantities, ..PlotContent::of_time(symbol, unit, curves) });
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
        legend::legend_ui(ui, entries, canvas.beside);
        let places = grid(ui, pictures.len(), canvas.rows);
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
                chosen.sort_by_key(|output| Output::of(plane).iter().position(|other| other == output));
            }
        }
    });
    response.accessible_name("Quantities shown").on_hover_text("Which quantities are shown");
    ui.checkbox(split, "Split into modes").on_hover_text(
        "Every linear motion is a sum of its modes: each in its colour, together the dark line",
    );
}

/// Places for `count` plots, in the order of reading, over all the room there is.
pub fn grid(ui: &mut Ui, count: usize, rows: Rows) -> Vec<Rect> {
    let width = ui.available_width();
    let columns = match rows {
        Rows::Touch => 1,
        Rows::Dense if width > 600.0 && (count == 3 || count > 4) => 3,
        Rows::Dense => 2,
    };
    let columns = columns.min(count.max(1));
    let down = count.div_ceil(columns).max(1);
    let least = LEAST_HEIGHT * down as f32;
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
