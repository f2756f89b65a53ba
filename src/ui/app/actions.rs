//! What is not the edit of a number: done by a key, a button or at the end of a frame.

use std::sync::Arc;

use egui::Ui;

use super::history::Scene;
use super::{App, PhonePane, Pinned};
use crate::content::Aircraft;
use crate::findings::{seen_in, watched_at};
use crate::flight::aircraft::plane::Plane;
use crate::scenario::view::{Instant, Pace, Pane};
use crate::scenario::{Choice, Disturbance, Scenario, Source, link};
use crate::ui::copy;
use crate::ui::keys::Command;
use crate::ui::theme::Look;
use crate::words;

/// Something a person asked for that isn't the edit of a number. Applied last in a frame, in one place.
#[derive(Clone, Debug, PartialEq)]
pub enum Action {
    /// Study another aircraft.
    Load(Arc<Aircraft>),
    /// Study the other plane of motion.
    Turn(Plane),
    /// Pin this state.
    Pin,
    /// Pin another aircraft as it is.
    PinAircraft(Arc<Aircraft>),
    /// Unpin what is pinned.
    Unpin,
    /// Go back one step.
    Undo,
    /// Go forward one step.
    Redo,
    /// Copy the whole scene as a link.
    CopyLink,
    /// Open the sheet of keys.
    Help,
    /// Open the sheet of lessons.
    Lessons,
    /// Fill the screen with the scene.
    Present,
    /// Open the sheet of the aircraft's source.
    Source,
    /// Open the sheet that takes the scene along.
    TakeAlong,
    /// Open the sheet of a person's own aircraft.
    Import,
    /// Study an aircraft of one's own, with what its file says was changed.
    LoadOwn(Arc<Aircraft>),
}

impl App {
    /// Does what a key asks for, or says what is to be done last in the frame.
    pub(super) fn obey(&mut self, ui: &Ui, command: Command) -> Option<Action> {
        match command {
            Command::Undo => return Some(Action::Undo),
            Command::Redo => return Some(Action::Redo),
            Command::Pin => return Some(if self.pinned.is_some() { Action::Unpin } else { Action::Pin }),
            Command::CopyLink => return Some(Action::CopyLink),
            Command::Embed if self.panes.embed.is_some() => self.panes.embed = None,
            Command::Embed => self.panes.embed = (!self.panes.is_framed).then(|| self.embedding()),
            Command::Print => self.print(ui),
            Command::Copy => copy::ask(ui.ctx()),
            Command::TakeAlong if self.panes.take_along.is_some() => self.panes.take_along = None,
            Command::TakeAlong => self.open_take_along(ui),
            Command::Import if self.panes.import.is_some() => self.panes.import = None,
            Command::Import => self.open_import(ui),
            Command::Play => self.panes.flight.toggle(),
            Command::Maximise(pane) => {
                self.view.maximised = (self.view.maximised != Some(pane)).then_some(pane);
                self.go_to_equations();
            }
            // What is in front first.
            Command::Restore if self.panes.help || self.panes.source => {
                (self.panes.help, self.panes.source) = (false, false);
            }
            Command::Restore => self.view.maximised = None,
            Command::Present => self.view.presents = true,
            Command::Look => Look::of(ui.ctx()).next().set(ui.ctx()),
            Command::Units => self.scenario.units = self.scenario.units.next(),
            Command::Notation => self.scenario.notation = self.scenario.notation.next(),
            Command::Help => self.panes.help = !self.panes.help,
        }
        None
    }

    /// On a phone the equations stand alone in a pane of their own.
    pub(super) fn go_to_equations(&mut self) {
        if self.view.maximised == Some(Pane::Equations) {
            self.panes.phone_pane = PhonePane::Equations;
        }
    }

    /// Does what was asked for; whatever was edited just before it is a step of its own.
    pub(super) fn apply(&mut self, action: Action, ui: &Ui) {
        let before = self.scene();
        match action {
            Action::Undo => {
                let undone = self.history.undo(&before);
                return self.restore(undone);
            }
            Action::Redo => {
                let redone = self.history.redo(&before);
                return self.restore(redone);
            }
            Action::CopyLink => {
                let link = self.link_with_instant();
                self.share.copy(ui, &link, !self.panes.is_framed);
                if !link::own::has_room(&self.scenario.aircraft) {
                    self.share.warn(ui, words::view::TOO_LONG_FOR_A_LINK);
                }
                return;
            }
            Action::Help => {
                self.panes.help = true;
                return;
            }
            Action::Source => {
                self.panes.source = true;
                return;
            }
            Action::Present => {
                self.view.presents = true;
                return;
            }
            Action::Lessons => {
                self.panes.lessons = true;
                return;
            }
            Action::TakeAlong => return self.open_take_along(ui),
            Action::Import => return self.open_import(ui),
            Action::LoadOwn(aircraft) => self.scenario = self.with_own(aircraft),
            Action::Load(aircraft) => self.scenario = self.scenario.with_aircraft(aircraft),
            Action::Turn(plane) => self.scenario.plane = plane,
            Action::Pin => self.pinned = Some(Arc::new(Pinned::new(before.scenario.clone()))),
            Action::PinAircraft(aircraft) => {
                self.pinned = Some(Arc::new(Pinned::new(self.scenario.with_aircraft(aircraft))));
            }
            Action::Unpin => self.pinned = None,
        }
        self.rest_in_another(&before.scenario);
        self.history.end_step(&before);
        self.history.keep(ui, &self.scene());
    }

    /// Another aircraft or plane begins at time zero, at rest: it is another motion.
    fn rest_in_another(&mut self, before: &Scenario) {
        let Scenario { aircraft, plane, .. } = &self.scenario;
        if (&before.aircraft.key, before.plane) != (&aircraft.key, *plane) {
            self.panes.flight.begin(Instant::default());
        }
    }

    /// Flies a mode alone, long enough to see what becomes of it, or goes back to what was before.
    pub(super) fn fly(&mut self, index: usize, flown: bool) {
        let plane = self.scenario.plane;
        let mode = self.findings.flown_modes().get(index);
        let (length, rate) = (mode.map(seen_in), mode.map(watched_at));
        let pace = &mut self.view.flight.pace;
        let disturbance = &mut self.scenario.disturbance;
        let before = &mut self.panes.before_flight[plane];
        if flown {
            let standard = Disturbance::default();
            let (choice, time, rate) =
                before.unwrap_or((standard.choices[plane], standard.sizes.time, Pace::default().rate));
            pace.rate = rate;
            disturbance.choices[plane] = choice;
            disturbance.sizes.time = time;
            self.panes.flight.pause();
            return;
        }
        let choice = disturbance.choices[plane];
        if choice.source != Source::OneMode {
            *before = Some((choice, disturbance.sizes.time, pace.rate));
        }
        disturbance.choices[plane] = Choice { source: Source::OneMode, mode: index, ..choice };
        disturbance.sizes.time = length.unwrap_or(disturbance.sizes.time);
        // As fast as it can be watched.
        pace.rate = rate.map_or(pace.rate, Pace::nearest_rate);
        self.panes.flight.start();
        // On a phone the aircraft is on another page than the card.
        self.panes.phone_pane = PhonePane::Aircraft;
    }

    /// Keeps flying the mode that is flown alone where another has come before it in the order of the modes.
    pub(super) fn hold_mode(&mut self) {
        let plane = self.scenario.plane;
        let choice = self.scenario.disturbance.choices[plane];
        let modes = self.findings.flown_modes();
        if choice.source != Source::OneMode || modes.is_empty() {
            self.panes.held = None;
            return;
        }
        let name = |index: usize| modes.get(index).map(|mode| mode.naming.name);
        let moved_to = match self.panes.held {
            Some((of, index, held)) if (of, index) == (plane, choice.mode) && name(index) != Some(held) => {
                modes.iter().position(|mode| mode.naming.name == held)
            }
            _ => None,
        };
        // One that a law had beside the four may be gone.
        let index = moved_to.unwrap_or(choice.mode).min(modes.len() - 1);
        self.panes.held = name(index).map(|name| (plane, index, name));
        self.scenario.disturbance.choices[plane].mode = index;
    }

    fn restore(&mut self, scene: Option<Scene>) {
        if let Some(Scene { scenario, pinned }) = scene {
            let before = std::mem::replace(&mut self.scenario, scenario);
            self.pinned = pinned;
            self.rest_in_another(&before);
        }
    }
}
