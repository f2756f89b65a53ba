//! Which slider moves which mode: bars beside a slider, and the few derivatives that move the modes most.

use egui::{Rect, Response, RichText, Sense, Ui, Vec2};

use super::curtain::Curtain;
use super::symbol::Symbol;
use super::theme::{self, Palette};
use crate::findings::{Findings, RowSensitivity, by_strength};
use crate::flight::modes::mode::Mode;
use crate::scenario::parameters::Group;
use crate::scenario::{Page, Parameter};
use crate::words;
use crate::words::sensitivity::NOTHING;

/// Width of a bar beside a slider, with its gap.
pub const BAR_WIDTH: f32 = 5.5;
/// The least length of a bar.
const SHORTEST: f32 = 1.0;
/// Derivatives in the list.
const LISTED: usize = 6;
/// Height of a bar in the list with its gap, and room for a symbol.
const LANE: f32 = 5.0;
const SYMBOL_WIDTH: f32 = 64.0;

/// How much of its greatest length a bar has: all of it for a tenth of |λ| and more. A square root keeps the weak ones visible.
pub fn share(strength: f64) -> f32 {
    (strength / 0.1).min(1.0).sqrt() as f32
}

/// Upright bars on the left of a place, one a mode: how strongly ten per cent of a parameter move it.
pub fn paint_bars(ui: &Ui, row: &RowSensitivity, modes: &[Mode], place: Rect) {
    let palette = Palette::of(ui);
    let bottom = place.center().y + 9.0;
    // A law adds modes, but no room.
    let width = BAR_WIDTH.min(place.width() / modes.len().max(1) as f32);
    for (i, index) in Curtain::of(ui).order(modes).into_iter().enumerate() {
        let (Some(mode), Some(strength)) = (modes.get(index), row.strengths.get(index)) else { continue };
        let Some(strength) = strength.filter(|strength| *strength >= NOTHING) else { continue };
        let tall = share(strength) * (place.height() - 8.0).min(18.0);
        let left = place.left() + width * i as f32;
        let top = bottom - tall.max(SHORTEST);
        let bar = Rect::from_min_max(
            egui::pos2(left, top),
            egui::pos2(left + width - if width < BAR_WIDTH { 1.0 } else { 1.5 }, bottom),
        );
        ui.painter().rect_filled(bar, 0.0, palette.mode(mode.naming.name));
    }
}

/// A click or a touch on the list.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ListClick {
    /// Key of the slider that is pointed at.
    pub touched: Option<&'static str>,
    /// Key of the slider that is asked for.
    pub asked: Option<&'static str>,
}

/// The derivatives that move the modes most. They keep their places while something is dragged.
#[derive(Debug, Default)]
pub struct Strongest {
    keys: Vec<&'static str>,
}

impl Strongest {
    /// Draws the list, each derivative with a bar a mode. The longest bar is as long as there is room.
    pub fn show(&mut self, ui: &mut Ui, findings: &Findings, page: Page) -> ListClick {
        let (rows, modes) = (findings.sensitivities(page), findings.flown_modes());
        let find = |key: &str| rows.iter().find(|row| row.key == key);
        let is_dragged = ui.input(|input| input.pointer.any_down());
        if !is_dragged || self.keys.iter().any(|key| find(key).is_none()) {
            self.keys = strongest(rows, modes.len());
        }
        let listed: Vec<_> = self.keys.iter().filter_map(|key| find(key)).collect();
        let strengths = listed.iter().flat_map(|row| row.strengths.iter().copied().flatten());
        let largest = strengths.fold(NOTHING, f64::max);
        let mut wish = ListClick::default();
        if listed.is_empty() {
            return wish;
        }
        ui.add_space(6.0);
        let title = words::sliders::strongest(page);
        let title = RichText::new(title).font(theme::semibold(theme::sizes(ui).small));
        theme::heading(ui, title.color(Palette::of(ui).weak), 3);
        ui.scope(|ui| {
            ui.spacing_mut().item_spacing.y = 0.0;
            for row in listed {
                let Some(parameter) = Parameter::find(row.key) else { continue };
                let shown = parameter.written(findings.scenario().convention());
                let response = row_ui(ui, parameter, (row, shown.symbol), modes, largest);
                if response.hovered() || response.has_focus() {
                    wish.touched = Some(row.key);
                }
                if response.clicked() {
                    wish.asked = Some(row.key);
                }
                if !Curtain::of(ui).hides_influence() {
                    response.on_hover_text(format!(
                        "{}: {}",
                        parameter.name,
                        words::sensitivity::of_row(row, modes, (shown.in_si, shown.unit))
                    ));
                }
            }
        });
        wish
    }
}

/// In turn the strongest of each mode that isn't there yet; not the knobs, which move all derivatives at once.
fn strongest(rows: &[RowSensitivity], modes: usize) -> Vec<&'static str> {
    let is_derivative =
        |key: &&str| Parameter::find(key).is_some_and(|parameter| parameter.group != Group::Aircraft);
    let of_mode = |i| by_strength(rows, i).into_iter().filter(is_derivative);
    let mut of_modes: Vec<_> = (0..modes).map(of_mode).collect();
    let mut keys = Vec::new();
    while keys.len() < LISTED {
        let before = keys.len();
        for of_mode in &mut of_modes {
            if let Some(key) = of_mode.find(|key| !keys.contains(key))
                && keys.len() < LISTED
            {
                keys.push(key);
            }
        }
        if keys.len() == before {
            break;
        }
    }
    keys
}

/// A symbol and its bars, one below the other: a button as wide as there is room. A square root keeps weak ones visible.
fn row_ui(
    ui: &mut Ui,
    parameter: &Parameter,
    (row, symbol): (&RowSensitivity, &str),
    modes: &[Mode],
    largest: f64,
) -> Response {
    let palette = Palette::of(ui);
    let symbol = Symbol::parse(symbol);
    let height = (LANE * modes.len() as f32 + 6.0).max(ui.spacing().interact_size.y);
    let size = Vec2::new(ui.available_width(), height);
    let (place, response) = ui.allocate_exact_size(size, Sense::click());
    let name = format!("To the slider of {} {}", parameter.name, symbol.plain());
    response.widget_info(|| egui::WidgetInfo::labeled(egui::accesskit::Role::Button, ui.is_enabled(), &name));
    if response.hovered() {
        ui.painter().rect_filled(place, 4.0, palette.field);
    }
    theme::focus_ring(ui, &response);
    let galley = symbol.fitting(ui, theme::sizes(ui).symbol, palette.text, SYMBOL_WIDTH - 8.0);
    let start = place.left_center() + Vec2::new(4.0, -0.5 * galley.size().y);
    ui.painter().galley(start, galley, palette.text);
    let room = place.width() - SYMBOL_WIDTH - 4.0;
    let mut corner = place.left_center() + Vec2::new(SYMBOL_WIDTH, -0.5 * LANE * modes.len() as f32);
    for index in Curtain::of(ui).order(modes) {
        let (Some(mode), Some(strength)) = (modes.get(index), row.strengths.get(index)) else { continue };
        // No strength: two roots meet, and whatever moves them moves them at no finite rate.
        let length = room * strength.map_or(1.0, |strength| (strength / largest).sqrt() as f32);
        let bar = Rect::from_min_size(corner, Vec2::new(length.max(SHORTEST), LANE - 1.0));
        ui.painter().rect_filled(bar, 0.0, palette.mode(mode.naming.name));
        corner.y += LANE;
    }
    response
}
