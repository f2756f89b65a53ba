//! Words on the picture: each beside what it names.

use std::collections::HashMap;
use std::sync::Arc;

use egui::text::{LayoutJob, TextFormat};
use egui::{Color32, CornerRadius, FontId, Galley, Id, Painter, Pos2, Rect, Vec2};

use super::arrows::Tip;
use crate::ui::labels::{MERGED, Placement, RememberedPlace, Silhouette, Wanted, draw_leader};
use crate::ui::symbol::Symbol;
use crate::ui::theme::{self, Palette};

const MARGIN: Vec2 = Vec2::new(4.0, 1.0);
/// In a narrower pane there are symbols only, no words.
const SMALL: f32 = 420.0;
/// Side of the square around the head of an arrow on which no label lies.
const HEAD: f32 = 8.0;
/// What a leader costs beside its length: a label rather lies on the aircraft.
const LEADER: f32 = 25.0;

/// Labels to be placed when all are known.
#[derive(Debug, Default)]
pub(super) struct Labels(Vec<Label>);

/// What stands after a symbol.
#[derive(Clone, Debug)]
pub(super) enum Words {
    /// Nothing.
    None,
    /// A name, for which a small pane has no room.
    Name(&'static str),
    /// A number with its unit.
    Value(String),
    /// A force: its name, and its size where that is known.
    Force(&'static str, Option<String>),
}

impl Words {
    /// The same without what is measured.
    pub fn without_numbers(self) -> Self {
        match self {
            Self::Value(_) => Self::None,
            Self::Force(name, _) => Self::Force(name, None),
            Self::None | Self::Name(_) => self,
        }
    }
}

#[derive(Debug)]
struct Label {
    symbol: String,
    words: Words,
    color: Color32,
    tip: Tip,
}

impl Labels {
    /// A symbol and words after it, beside the tip of an arrow.
    pub fn add(&mut self, symbol: &str, words: Words, color: Color32, tip: Tip) {
        self.0.push(Label { symbol: symbol.to_owned(), words, color, tip });
    }

    /// Draws all of them where there is room, and tells where: at the tips of their arrows, beside the aircraft and off all arrows if that can be.
    pub fn paint(
        self,
        painter: &Painter,
        pane: Rect,
        taken: &[Rect],
        silhouette: &Arc<Silhouette>,
        palette: &Palette,
    ) -> Vec<(String, Rect)> {
        let sizes = theme::sizes(painter.ctx());
        let is_small = pane.width() < SMALL;
        let mut placement = Placement::new(pane.shrink(3.0));
        taken.iter().for_each(|taken| placement.keep_clear(taken.expand(1.0)));
        placement.shun_silhouette(silhouette.clone());
        for Label { tip, .. } in &self.0 {
            placement.keep_clear(Rect::from_center_size(tip.at, Vec2::splat(HEAD)));
            placement.shun_arrow(&tip.line);
        }
        // Where each stood in the frame before, in a pane of this size: it stays there while it can.
        let id = Id::unique("labels on the aircraft");
        let before: Option<(Vec2, HashMap<String, RememberedPlace>)> =
            painter.ctx().data(|data| data.get_temp(id));
        let before =
            before.filter(|(size, _)| *size == pane.size()).map(|(_, kept)| kept).unwrap_or_default();
        let mut now = HashMap::new();
        let mut places = Vec::new();
        for label in self.0.iter().filter(|label| pane.contains(label.tip.at)) {
            let galley = painter.layout_job(label.job(is_small, sizes));
            let wanted = self.wanted(label, &galley);
            let kept = before.get(label.key()).copied();
            let Some((place, kept)) = placement.label(&wanted, kept, true) else { continue };
            now.insert(label.key().to_owned(), kept);
            if let Some(leader) = place.leader {
                draw_leader(painter, leader, palette);
            }
            painter.rect_filled(place.rect, CornerRadius::same(4), palette.label_ground());
            painter.galley(place.rect.min + MARGIN, galley, label.color);
            places.push((label.symbol.clone(), place.rect));
        }
        painter.ctx().data_mut(|data| data.insert_temp(id, (pane.size(), now)));
        places
    }

    fn wanted(&self, label: &Label, galley: &Galley) -> Wanted {
        let at = label.tip.at;
        let others: Vec<Pos2> =
            self.0.iter().map(|other| other.tip.at).filter(|other| other.distance(at) > MERGED).collect();
        Wanted {
            own: vec![at],
            others,
            half: Rect::EVERYTHING,
            sizes: vec![galley.size() + 2.0 * MARGIN],
            first: 0,
            towards: Some(label.tip.towards),
            leader: LEADER,
        }
    }
}

impl Label {
    /// What it is known by from one frame to the next.
    fn key(&self) -> &str {
        match &self.words {
            Words::Force(name, _) => name,
            Words::None | Words::Name(_) | Words::Value(_) => &self.symbol,
        }
    }

    /// Symbol and words; without a name in a small pane.
    fn job(&self, is_small: bool, sizes: &theme::Sizes) -> LayoutJob {
        let mut job = Symbol::parse(&self.symbol).job(sizes.inline_symbol, self.color);
        let words = match &self.words {
            Words::None => None,
            Words::Name(name) => (!is_small).then(|| (*name).to_owned()),
            Words::Value(value) => Some(value.clone()),
            Words::Force(name, None) => Some((*name).to_owned()),
            Words::Force(name, Some(size)) => Some(format!("{name} {size}")),
        };
        if let Some(words) = words {
            let gap = if self.symbol.is_empty() { 0.0 } else { 4.0 };
            job.append(&words, gap, TextFormat::simple(FontId::proportional(sizes.small), self.color));
        }
        job
    }
}
