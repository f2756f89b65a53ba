//! The motion over time: small multiples on one time axis with one cursor, whole or split into its modes.

use egui::containers::menu::{MenuButton, MenuConfig};
use egui::style::StyleModifier;
use egui::{PopupCloseBehavior, Rect, Ui, Vec2};

use super::legend::{self, Entry};
use super::studied::units;
use super::{Basis, Seen, kept, note_ui, word};
use crate::content::LengthUnit;
use crate::flight::aircraft::plane::{ByPlane, Plane};
use crate::flight::motion::modal_sum::SplitError;
use crate::flight::motion::outputs::Output;
use crate::scenario::Quantity;
use crate::scenario::link::Sight;
use crate::ui::chart::{Pattern, Picture, SmallPlot};
use crate::ui::derivatives::Rows;

/// Least height of a small plot \[points\].
const LEAST_HEIGHT: f32 = 120.0;
const GAP: Vec2 = Vec2::new(12.0, 6.0);

/// The plots over time as a person has set them up.
#[derive(Debug)]
pub struct TimePlots {
    /// What is shown, of each plane.
    pub chosen: ByPlane<Vec<Output>>,
    /// Whether the parts of the modes are shown.
    pub split: bool,
    plots: Vec<SmallPlot>,
    /// Time under the pointer \[s\].
    hovered: Option<f64>,
    /// Time of the playback \[s\].
    pub played: Option<f64>,
    sheet: Option<(Key, Sheet)>,
}

/// What is shown, of which outputs, and whether split.
type Key = (Basis, Vec<Output>, bool);

/// What the plots show.
#[derive(Debug)]
struct Sheet {
    pictures: Vec<Picture>,
    entries: Vec<Entry>,
    /// Why the motion isn't split.
    unsplit: Option<SplitError>,
}

impl Sheet {
    fn of(seen: Seen<'_>, chosen: &[Output], split: bool) -> Self {
        let Seen { studied, ghost, palette, .. } = seen;
        let mut pictures: Vec<Picture> = Vec::new();
        let mut unsplit = None;
        let duration = studied.duration().max(1e-3);
        for &output in chosen {
            let (quantity, symbol, unit) = units(output, studied.scenario);
            let mut curves = vec![studied.curve(output, unit, Pattern::Full, palette.text)];
            if split {
                match studied.parts(output, unit, palette) {
                    Ok(parts) => curves.extend(parts),
                    Err(error) => unsplit = Some(error),
                }
            }
            curves.extend(studied.flown(output, unit, palette));
            if let Some(ghost) = ghost {
                // The pinned state is drawn in the units of the one on screen.
                curves.push(ghost.curve(output, unit, Pattern::Dashed, palette.ghost));
            }
            let beyond = studied.motion.small_until.map(|time| time..=duration);
            pictures.push(Picture { beyond, ..Picture::of_time(quantity.symbol, symbol, curves) });
        }
        let entries = legend::curves(&pictures);
        if let Some((quantities, dimension, curves)) = studied.inputs(palette) {
            let symbol = quantities.first().copied().unwrap_or_default();
            let unit = dimension.symbol(LengthUnit::Metre);
            pictures.push(Picture { quantities, ..Picture::of_time(symbol, unit, curves) });
        }
        for picture in &mut pictures {
            picture.x_range = Some(0.0..=duration);
        }
        Self { pictures, entries, unsplit }
    }
}

impl Default for TimePlots {
    fn default() -> Self {
        let Sight { shown, split, .. } = Sight::default();
        Self { chosen: shown, split, plots: Vec::new(), hovered: None, played: None, sheet: None }
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

    /// Which outputs, and whether split.
    pub fn choosers_ui(&mut self, ui: &mut Ui, plane: Plane) {
        let chosen = &mut self.chosen[plane];
        // Boxes to tick have their outline, which the style of menus takes away.
        let config = MenuConfig::new().style(StyleModifier::default());
        let config = config.close_behavior(PopupCloseBehavior::CloseOnClickOutside);
        let button = MenuButton::new("Show ▾").config(config);
        let (response, _) = button.ui(ui, |ui| {
            for &output in Output::of(plane) {
                let quantity = Quantity::of(output);
                let mut on = chosen.contains(&output);
                if ui.checkbox(&mut on, format!("{} · {}", word(quantity), quantity.name)).clicked() {
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
        ui.checkbox(&mut self.split, "Split into modes").on_hover_text(
            "Every linear motion is a sum of its modes: each in its colour, together the dark line",
        );
    }

    /// Draws the plots over all the room there is.
    pub fn show(&mut self, ui: &mut Ui, seen: Seen<'_>) {
        let chosen = &self.chosen[seen.studied.plane()];
        let (cursor, before) = (self.cursor(), self.hovered);
        let key = (Basis::of(seen), chosen.clone(), self.split);
        let Sheet { pictures, entries, unsplit } =
            kept(&mut self.sheet, key, || Sheet::of(seen, chosen, self.split));
        if let Some(error) = unsplit {
            note_ui(ui, &format!("No split into modes: {error}."));
        }
        legend::legend_ui(ui, entries, seen.beside);
        let places = grid(ui, pictures.len(), seen.rows);
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

/// Places for `count` plots, in the order of reading, over all the room there is.
pub fn grid(ui: &mut Ui, count: usize, rows: Rows) -> Vec<Rect> {
    let width = ui.available_width();
    let columns = match rows {
        Rows::Touch => 1,
        Rows::Dense if width > 600.0 && count > 4 => 3,
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
