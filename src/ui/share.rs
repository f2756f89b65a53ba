//! What a person sees of links: a word that one was copied, and what was left out of one that was opened.

use egui::accesskit::Live;
use egui::{Align2, Area, Frame, Id, Margin, Order, Panel, RichText, Ui, Vec2};

use super::theme::{self, Palette};
use crate::scenario::link::Notice;

/// How long the word stands \[s\].
const STANDS: f64 = 3.0;

/// At most so many notices are shown; a link of pure noise has hundreds.
const SHOWN: usize = 4;

/// State of links on screen.
#[derive(Debug, Default)]
pub struct Share {
    /// The address before the `#` of a link; empty in a window, which has no address.
    pub address: String,
    notices: Vec<Notice>,
    /// Time of egui at which the word goes \[s\].
    until: Option<f64>,
    /// A sentence for a screen reader that hasn't been said yet.
    unsaid: Option<String>,
}

impl Share {
    /// Copies a link and says so.
    pub fn copy(&mut self, ui: &Ui, link: &str) {
        ui.copy_text(format!("{}#{link}", self.address));
        self.until = Some(ui.input(|input| input.time) + STANDS);
        self.unsaid = Some(COPIED.to_owned());
    }

    /// Takes what was left out of a link just opened.
    pub fn opened(&mut self, notices: Vec<Notice>) {
        self.unsaid = (!notices.is_empty()).then(|| lines(&notices).join(" "));
        self.notices = notices;
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

    /// The word that a link was copied, near the foot of the page, for a moment.
    pub fn copied_ui(&mut self, ui: &Ui) {
        let Some(until) = self.until else { return };
        let rest = until - ui.input(|input| input.time);
        if rest <= 0.0 {
            self.until = None;
            return;
        }
        ui.request_repaint_after_secs(rest as f32);
        let palette = Palette::of(ui);
        let area = Area::new(Id::unique("link copied")).order(Order::Foreground).interactable(false);
        area.anchor(Align2::CENTER_BOTTOM, Vec2::new(0.0, -28.0)).show(ui, |ui| {
            Frame::new()
                .fill(palette.good_ground)
                .corner_radius(8)
                .inner_margin(Margin::symmetric(14, 9))
                .show(ui, |ui| {
                    let word = ui.label(
                        RichText::new(COPIED)
                            .font(theme::semibold(theme::sizes(ui).body))
                            .color(palette.good),
                    );
                    ui.ctx().accesskit_node_builder(word.id, |node| node.set_live(Live::Polite));
                });
        });
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
