//! What the stage hides and locks, and how large it is: brought into force once a frame.

use std::sync::Arc;

use egui::Ui;

use super::{App, Pinned};
use crate::scenario::view::FlightView;
use crate::scenario::{Lock, Scenario, View};
use crate::ui::curtain::Curtain;
use crate::ui::lesson::Session;
use crate::ui::theme::Look;

/// The narrowest page that has room for everything \[points\].
const NARROWEST: f32 = 320.0;

/// The scene as it was when the frame began, where something of it stays so.
#[derive(Debug)]
pub(super) struct Held {
    scenario: Scenario,
    view: View,
    pinned: Option<Arc<Pinned>>,
}

impl App {
    /// Hangs the curtain for what is drawn next. A step whose questions are answered hides nothing any more.
    pub(super) fn hang_curtain(&self, ui: &Ui) {
        let modes = self.findings.flown_modes();
        let curtain = match self.presentation() {
            Some(lecture) => {
                Curtain::new(&lecture.stage(&self.view.stage, self.is_shown_revealed()), false, modes)
            }
            None => {
                let revealed = self.session().is_some_and(Session::is_revealed);
                Curtain::new(&self.view.stage, revealed, modes)
            }
        };
        curtain.keeping(self.is_kept()).hang(ui.ctx());
    }

    /// Makes type as large as the stage has it, beside what a person has chosen, but never so large that the page is too narrow.
    pub(super) fn fit_type(&mut self, ui: &Ui) {
        if self.view.presents {
            return self.fit_screen(ui);
        }
        let before = self.panes.type_size.unwrap_or(1.0);
        let most = (ui.content_rect().width() * before / NARROWEST).max(1.0);
        let now = (self.view.stage.type_size as f32).min(most);
        if before != now {
            ui.ctx().set_zoom_factor(ui.ctx().zoom_factor() * now / before);
            self.panes.type_size = Some(now);
        }
    }

    /// Puts the look of the scene's link in force, until a person chooses another: then the link has none any more.
    pub(super) fn fit_look(&mut self, ui: &Ui) {
        let ctx = ui.ctx();
        if self.panes.lent != self.view.look {
            Look::lend(self.view.look, ctx);
        } else if self.view.look.is_some() && Look::lent(ctx).is_none() {
            self.view.look = None;
        }
        self.panes.lent = self.view.look;
    }

    /// Remembers what is locked, before anything can move it.
    pub(super) fn take_hold(&mut self) {
        let held =
            || Held { scenario: self.scenario.clone(), view: self.view.clone(), pinned: self.pinned.clone() };
        self.panes.locked = self.view.stage.locks_anything().then(held);
    }

    /// Puts back what is locked, whatever has moved it: a key, a screen reader, undo.
    pub(super) fn hold_locked(&mut self) {
        let Some(Held { scenario, view, pinned }) = &self.panes.locked else { return };
        let stage = &self.view.stage;
        stage.hold(scenario, &mut self.scenario);
        if stage.locks_up(Lock::View) {
            // How fast it is played is no part of the picture, nor is who looks at it.
            let flight = FlightView { pace: self.view.flight.pace, ..view.flight };
            let View { presents, look, .. } = self.view;
            self.view = View { stage: stage.clone(), presents, look, flight, ..view.clone() };
            self.pinned.clone_from(pinned);
        }
    }
}
