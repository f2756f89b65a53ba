//! Why a mode has moved, on its card: one sentence, and the parts and the formula where a person asks for more.
//!
//! Found when the cards are drawn and the hand rests. While something is dragged the sentences stay, dimmed, so that no card jumps.

use std::rc::Rc;

use egui::{Button, RichText, Ui, Vec2};

use super::curtain::Curtain;
use super::mode_cards::hold_place;
use super::symbol::prose;
use super::theme::{self, Palette};
use crate::findings::Findings;
use crate::findings::change::{Change, reference_of};
use crate::flight::modes::mode_name::ModeName;
use crate::scenario::Scenario;
use crate::words;
use crate::words::change::Reasons;

/// Why the modes have moved.
#[derive(Debug, Default)]
pub struct Why {
    /// The aircraft as its file has it.
    reference: Option<Rc<Findings>>,
    known: Option<Known>,
    /// Whether the sentences are of another state than the one on screen.
    is_stale: bool,
    /// Whether a law that is shown closed keeps them from being told.
    is_under_law: bool,
    /// Whether the parts and the formula are shown, of all modes alike.
    is_open: bool,
}

/// The reasons between two states.
#[derive(Debug)]
struct Known {
    before: Rc<Findings>,
    after: Rc<Findings>,
    is_since_pin: bool,
    reasons: Vec<(ModeName, Reasons)>,
}

impl Why {
    /// Finds the reasons for what is on screen, since the pinned state or else since the aircraft's file; nothing while a hand moves.
    pub fn update(&mut self, ui: &Ui, pinned: Option<&Rc<Findings>>, after: &Rc<Findings>) {
        let now = after.scenario();
        let pinned = pinned.filter(|pinned| pinned.scenario().aircraft.key == now.aircraft.key);
        let before = pinned.cloned().unwrap_or_else(|| self.reference(now));
        let is_alone = after.plane().is_some_and(|plane| plane.model.further.is_none());
        self.is_under_law =
            after.is_fed_back() && is_alone && before.scenario().edited != after.scenario().edited;
        // Reasons are told of the aircraft alone.
        if [&before, after].into_iter().any(|findings| findings.flies_otherwise()) {
            self.known = None;
            return;
        }
        if let Some(known) = &self.known
            && is_same(&known.before, &before)
            && is_same(&known.after, after)
        {
            self.is_stale = false;
            return;
        }
        let is_of_this = |known: &Known| {
            let of = known.after.scenario();
            of.plane == now.plane && of.aircraft.key == now.aircraft.key
        };
        self.is_stale = ui.input(|input| input.pointer.any_down());
        if self.is_stale {
            self.known = self.known.take().filter(is_of_this);
            return;
        }
        let convention = now.convention();
        let reasons = Change::between(&before, after).map_or_else(Vec::new, |change| {
            let of = |mode| words::change::reasons(&change, mode, convention);
            change.modes.iter().filter_map(|mode| Some((mode.name, of(mode)?))).collect()
        });
        self.known = Some(Known { before, after: after.clone(), is_since_pin: pinned.is_some(), reasons });
    }

    /// Where the reasons are, while a law that is shown closed keeps them from being told.
    pub fn under_law_ui(&self, ui: &mut Ui) {
        if self.is_under_law && !Curtain::of(ui).hides_influence() {
            let text = RichText::new(words::change::UNDER_LAW).font(theme::small());
            ui.label(text.color(Palette::of(ui).weak));
        }
    }

    fn reference(&mut self, now: &Scenario) -> Rc<Findings> {
        let is_of_this = |findings: &&Rc<Findings>| {
            let of = findings.scenario();
            of.plane == now.plane && of.aircraft == now.aircraft
        };
        let known = self.reference.as_ref().filter(is_of_this).cloned();
        let reference = known.unwrap_or_else(|| Rc::new(Findings::of(reference_of(now))));
        self.reference = Some(reference.clone());
        reference
    }

    /// The sentences on one mode; nothing where it has not moved, or reasons are hidden.
    pub fn show(&mut self, ui: &mut Ui, name: ModeName) {
        let Some(known) = self.known.as_ref().filter(|_| !Curtain::of(ui).hides_influence()) else { return };
        let Some((_, reasons)) = known.reasons.iter().find(|(of, _)| *of == name) else { return };
        let palette = Palette::of(ui);
        let color = if self.is_stale { palette.weak } else { palette.text };
        let since = if known.is_since_pin { words::change::SINCE_PIN } else { words::change::SINCE_FILE };
        let mode = words::mode::in_a_sentence(name);
        ui.horizontal(|ui| {
            ui.spacing_mut().button_padding = Vec2::new(5.0, 1.0);
            let title = RichText::new(words::change::TITLE).font(theme::semibold(theme::sizes(ui).small));
            ui.label(title.color(palette.weak)).on_hover_text(since);
            if reasons.more.is_empty() {
                return;
            }
            let text = if self.is_open { "Less" } else { "More" };
            let button = Button::new(RichText::new(text).font(theme::small()));
            let button = ui.add(button).accessible_name(format!("{text} on why the {mode} moved"));
            hold_place(ui, &button, name, "why");
            if button.on_hover_text(words::change::MORE_MEANING).clicked() {
                self.is_open = !self.is_open;
            }
        });
        ui.label(prose(&reasons.headline, theme::small(), color));
        for text in reasons.more.iter().filter(|_| self.is_open) {
            ui.label(prose(text, theme::small(), color));
        }
    }
}

/// Whether two findings are of the same aircraft in the same plane, whatever disturbs it.
fn is_same(one: &Rc<Findings>, other: &Rc<Findings>) -> bool {
    let (a, b) = (one.scenario(), other.scenario());
    Rc::ptr_eq(one, other) || a.plane == b.plane && a.edited == b.edited && a.aircraft.key == b.aircraft.key
}
