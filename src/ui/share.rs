//! What a person sees of links: a word that one was copied, and what was left out of one that was opened. Other short words stand where
//! the first does.

use egui::accesskit::Live;
use egui::{Align2, Area, Frame, Id, Margin, Order, Panel, RichText, Ui, Vec2};

use super::theme::{self, Palette};
use crate::scenario::link::Notice;

/// How long the word stands \[s\].
const STANDS: f64 = 3.0;

/// The same of a word with a button \[s\].
const OFFER_STANDS: f64 = 6.0;

/// The same of a sentence \[s\].
const SENTENCE_STANDS: f64 = 10.0;

/// What is longer than so many characters is a sentence, and has lines \[points\] of this width.
const WORD: usize = 70;
const SENTENCE_WIDTH: f32 = 460.0;

/// At most so many notices are shown; a link of pure noise has hundreds.
const SHOWN: usize = 4;

/// What a word about a link offers to do next.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Offer {
    /// A frame of the scene.
    Embed,
    /// The scene for another program.
    TakeAlong,
}

/// State of links on screen.
#[derive(Debug, Default)]
pub struct Share {
    /// The address before the `#` of a link; empty in a window, which has no address.
    pub address: String,
    notices: Vec<Notice>,
    /// A word near the foot of the page.
    word: String,
    /// Whether it offers to embed the scene.
    offers: bool,
    /// Time of egui at which the word goes \[s\].
    until: Option<f64>,
    /// A sentence for a screen reader that hasn't been said yet.
    unsaid: Option<String>,
}

impl Share {
    /// Copies a link and says so, and that it can be embedded where that `is_offered`.
    pub fn copy(&mut self, ui: &Ui, link: &str, is_offered: bool) {
        ui.copy_text(format!("{}#{link}", self.address));
        self.show(ui, COPIED);
        self.offers = is_offered;
        if is_offered {
            self.until = Some(ui.input(|input| input.time) + OFFER_STANDS);
        }
    }

    /// Shows a word for a moment, and says it.
    pub fn show(&mut self, ui: &Ui, word: &str) {
        self.word = word.to_owned();
        self.offers = false;
        self.until = Some(ui.input(|input| input.time) + STANDS);
        self.unsaid = Some(word.to_owned());
        ui.request_repaint();
    }

    /// Says something else of a link just copied, as long as a sentence needs.
    pub fn warn(&mut self, ui: &Ui, sentence: &str) {
        self.show(ui, sentence);
        self.until = Some(ui.input(|input| input.time) + SENTENCE_STANDS);
    }

    /// Takes what was left out of a link just opened.
    pub fn opened(&mut self, notices: Vec<Notice>) {
        self.unsaid = (!notices.is_empty()).then(|| lines(&notices).join(" "));
        self.notices = notices;
    }

    /// Has a screen reader say a sentence.
    pub fn say(&mut self, sentence: String) {
        self.offers = false;
        self.unsaid = Some(sentence);
    }

    /// Says a sentence near the foot of the page, for a while, and to a screen reader.
    pub fn tell(&mut self, sentence: &str) {
        self.word = sentence.to_owned();
        // From the next frame on.
        self.until = Some(f64::INFINITY);
        self.unsaid = Some(sentence.to_owned());
    }

    /// A sentence for a screen reader, once.
    pub fn take_unsaid(&mut self) -> Option<String> {
        self.unsaid.take()
    }

    /// The notices, over the whole width, until they are dismissed.
    pub fn notices_ui(&mut self, ui: &mut Ui) {
        if self.notices.is_empty() {
            return;
        }
        let palette = Palette::of(ui);
        let ground = Frame::new().fill(palette.warning_ground).inner_margin(Margin::symmetric(14, 7));
        let dismissed = Panel::top("notices").frame(ground).show(ui, |ui| {
            for line in lines(&self.notices) {
                let text = RichText::new(format!("⚠ {line}"))
                    .font(theme::semibold(theme::sizes(ui).value))
                    .color(palette.warning);
                ui.label(text);
            }
            ui.button("Dismiss").on_hover_text("Hide what was left out of the link").clicked()
        });
        if dismissed.inner {
            self.notices.clear();
        }
    }

    /// The word near the foot of the page, for a moment; what is asked for in it.
    pub fn word_ui(&mut self, ui: &Ui) -> Option<Offer> {
        let until = self.until?;
        let now = ui.input(|input| input.time);
        let until = if until.is_finite() { until } else { now + SENTENCE_STANDS };
        self.until = Some(until);
        let rest = until - now;
        if rest <= 0.0 {
            self.until = None;
            return None;
        }
        ui.request_repaint_after_secs(rest as f32);
        let palette = Palette::of(ui);
        let word_ui = |ui: &mut Ui| {
            let font = theme::semibold(theme::sizes(ui).body);
            let word = ui.label(RichText::new(&self.word).font(font).color(palette.good));
            ui.ctx().accesskit_node_builder(word.id, |node| node.set_live(Live::Polite));
            if !self.offers {
                return None;
            }
            let embed = ui.button("Embed this …").on_hover_text("A frame for a page of yours (M)");
            let take = ui.button("Take along …").on_hover_text("A script, a file, data or a figure (X)");
            let embeds = embed.clicked().then_some(Offer::Embed);
            embeds.or(take.clicked().then_some(Offer::TakeAlong))
        };
        let area = Area::new(Id::unique("link copied")).order(Order::Foreground).interactable(self.offers);
        let area = area.anchor(Align2::CENTER_BOTTOM, Vec2::new(0.0, -28.0));
        let shown = area.show(ui, |ui| {
            Frame::new()
                .fill(palette.good_ground)
                .corner_radius(8)
                .inner_margin(Margin::symmetric(14, 9))
                .show(ui, |ui| {
                    if self.word.chars().count() <= WORD {
                        return ui.horizontal(word_ui).inner;
                    }
                    ui.set_max_width((ui.content_rect().width() - 56.0).min(SENTENCE_WIDTH));
                    ui.vertical(word_ui).inner
                })
                .inner
        });
        if shown.inner.is_some() {
            self.until = None;
        } else if self.offers && shown.response.contains_pointer() {
            // Not while somebody is on the way to its button.
            self.until = Some(until.max(now + 1.0));
        }
        shown.inner
    }
}

const COPIED: &str = "Link copied";

/// The notices as sentences, and how many more there are.
fn lines(notices: &[Notice]) -> Vec<String> {
    let mut lines: Vec<String> = notices.iter().take(SHOWN).map(Notice::to_string).collect();
    match notices.len().saturating_sub(SHOWN) {
        0 => {}
        1 => lines.push("One more part of the link was left out.".to_owned()),
        more => lines.push(format!("{more} more parts of the link were left out.")),
    }
    lines
}
