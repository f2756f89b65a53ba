//! Which line is what: one compact line above the plots, of what they show and nothing else.

use std::sync::Arc;

use egui::{Color32, Galley, Id, Pos2, Rect, Sense, Stroke, Ui, Vec2, WidgetInfo, accesskit::Role};

use super::Canvas;
use crate::few;
use crate::ui::chart::{self, Pattern, PlotContent, Primitive, SAMPLE};
use crate::ui::theme::{self, Palette};

/// Between a sample and its words, and between two of them.
const GAPS: (f32, f32) = (4.0, 12.0);
const LINE_HEIGHT: f32 = 17.0;

/// What is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Mark {
    /// A curve.
    Curve(Pattern),
    /// An upright line.
    Upright,
    /// A dot.
    Dot,
    /// A ring.
    Ring,
}

impl Mark {
    /// How a screen reader tells it from the others.
    const fn text(self) -> &'static str {
        match self {
            Self::Curve(Pattern::Full) => "full line",
            Self::Curve(Pattern::Dashed) => "dashed",
            Self::Curve(Pattern::Dotted) => "dotted",
            Self::Curve(Pattern::Filled) => "filled",
            Self::Upright => "upright line",
            Self::Dot => "dot",
            Self::Ring => "ring",
        }
    }
}

/// A mark, its colour and its name.
#[derive(Clone, Debug, PartialEq)]
pub struct Entry {
    /// What is drawn.
    pub mark: Mark,
    /// Its colour.
    pub color: Color32,
    /// What it is.
    pub name: String,
}

/// The curves of all pictures, each name once: first the whole motions, then the parts.
pub fn curves(pictures: &[PlotContent]) -> Vec<Entry> {
    let mut entries: Vec<Entry> = Vec::new();
    for curve in pictures.iter().flat_map(|picture| &picture.curves) {
        if !entries.iter().any(|entry| entry.name == curve.name) {
            let (color, name) = (curve.color, curve.name.to_owned());
            entries.push(Entry { mark: Mark::Curve(curve.pattern), color, name });
        }
    }
    few::sort_by_key(&mut entries, |entry| entry.mark == Mark::Curve(Pattern::Filled));
    entries
}

/// The same in the words of whoever looks on: two aircraft by their names, one by what it was and is.
pub fn for_a_room(entries: &[Entry], canvas: Canvas<'_>) -> Vec<Entry> {
    let Canvas { findings, pinned: Some(pinned), curtain, .. } = canvas else { return entries.to_vec() };
    let [now, before] = [findings, pinned].map(|findings| &findings.scenario().aircraft.name);
    let told =
        if now == before { ["now", "before"] } else { [now, before].map(|name| curtain.aircraft(name)) };
    let names = ["linear", "pinned"].into_iter().zip(told);
    let mut entries = entries.to_vec();
    for (name, told) in names {
        entries
            .iter_mut()
            .filter(|entry| entry.name == name)
            .for_each(|entry| told.clone_into(&mut entry.name));
    }
    entries
}

/// Draws the legend into `beside`, where it fits there, else in lines of its own.
pub fn legend_ui(ui: &mut Ui, entries: &[Entry], beside: Option<Rect>) {
    // What is drawn once needs no name before a room.
    if entries.is_empty() || entries.len() == 1 && theme::is_for_a_room(ui) {
        return;
    }
    let palette = Palette::of(ui);
    let layout =
        |entry: &Entry| ui.painter().layout_no_wrap(entry.name.clone(), theme::small(), palette.weak);
    let galleys: Vec<Arc<Galley>> = entries.iter().map(layout).collect();
    let wide = |galley: &Galley| SAMPLE + GAPS.0 + galley.size().x;
    let whole = galleys.iter().map(|galley| wide(galley) + GAPS.1).sum::<f32>() - GAPS.1;
    let beside = beside.filter(|room| whole <= room.width());
    let width = beside.map_or(ui.available_width(), |room| room.width());
    let mut places: Vec<Vec2> = Vec::new();
    let mut at = Vec2::ZERO;
    for galley in &galleys {
        if at.x > 0.0 && at.x + wide(galley) > width {
            at = Vec2::new(0.0, at.y + LINE_HEIGHT);
        }
        places.push(at);
        at.x += wide(galley) + GAPS.1;
    }
    let (area, response) = match beside {
        Some(room) => {
            let top = room.center().y - 0.5 * LINE_HEIGHT;
            let area = Rect::from_min_size(egui::pos2(room.left(), top), Vec2::new(whole, LINE_HEIGHT));
            (area, ui.interact(area, Id::unique("legend"), Sense::hover()))
        }
        None => ui.allocate_exact_size(Vec2::new(width, at.y + LINE_HEIGHT), Sense::hover()),
    };
    let said: Vec<String> =
        entries.iter().map(|entry| format!("{}, {}", entry.name, entry.mark.text())).collect();
    response.widget_info(|| WidgetInfo::labeled(Role::Label, true, format!("Legend: {}", said.join("; "))));
    for ((entry, galley), place) in entries.iter().zip(galleys).zip(places) {
        let left = area.min + place + Vec2::new(0.0, 0.5 * LINE_HEIGHT);
        chart::paint(ui.painter(), vec![sample(left, entry.mark, entry.color)]);
        let text = left + Vec2::new(SAMPLE + GAPS.0, -0.5 * galley.size().y);
        ui.painter().galley(text, galley, palette.weak);
    }
}

/// A sample of a mark, as long as [`SAMPLE`] and with the middle of its left end here.
fn sample(left: Pos2, mark: Mark, color: Color32) -> Primitive {
    let middle = left + Vec2::new(0.5 * SAMPLE, 0.0);
    match mark {
        Mark::Curve(pattern) => chart::sample(left, pattern, color),
        Mark::Upright => {
            let ends = [6.0, -6.0].map(|y| middle + Vec2::new(0.0, y));
            Primitive::line(ends, Stroke::new(1.2, color), Pattern::Dashed)
        }
        Mark::Dot => Primitive::Dot(middle, chart::DOT, color),
        Mark::Ring => Primitive::Ring(middle, chart::DOT, color),
    }
}
