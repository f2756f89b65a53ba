//! What is in the panes: each is given what follows from the scenario, and edits it in place.

use egui::{Align, Layout, RichText, Ui};

use super::{Action, App, Ghost, PhonePane, View};
use crate::flight::aircraft::plane::Plane;
use crate::flight::modes::mode::Mode;
use crate::scenario::{Flown, Page, Parameter, Scenario, Source, parameters};
use crate::ui::derivatives::{Chosen, Outlook, Rows, derivatives_ui, is_listed};
use crate::ui::memo::{Followed, Memo};
use crate::ui::mode_cards::{Card, banner_ui, card_ui, verdicts_ui};
use crate::ui::poles::Seen;
use crate::ui::responses::Studied;
use crate::ui::theme::Palette;
use crate::words;

impl App {
    pub(super) fn derivatives_ui(&mut self, ui: &mut Ui, rows: Rows) {
        if !self.view.page.is_of(&self.scenario) {
            self.view.page = Page::of(&self.scenario);
        }
        self.memo.refresh(&self.scenario, self.view.page);
        let followed = self.memo.followed();
        let outlook = Outlook {
            sensitivities: followed.map_or(&[], |followed| &followed.sensitivities),
            modes: self.memo.plane().map_or(&[], |plane| &plane.modes),
            coefficients: followed.and_then(|followed| followed.coefficients.as_ref()),
        };
        self.view.touched = {
            let View { page, search, asked, .. } = &mut self.view;
            let chosen = Chosen { page, search, asked: asked.take() };
            derivatives_ui(ui, &mut self.scenario, chosen, rows, outlook)
        };
        self.view.explained = self.view.touched.unwrap_or(self.view.explained);
        let listed = |p: &&Parameter| is_listed(p, &self.scenario, self.view.page, &self.view.search);
        if Parameter::find(self.view.explained).filter(listed).is_none() {
            let first = parameters().find(listed);
            self.view.explained = first.map_or("", |p| p.key);
        }
        if rows == Rows::Dense {
            crate::ui::derivatives::help_ui(ui, self.view.explained);
        }
    }

    pub(super) fn ghost_memo_refresh(&mut self) {
        if let Some(ghost) = &self.ghost {
            let mut compared = self.compared(ghost);
            let own = compared.disturbance.choices[compared.plane].mode;
            let flown = self.memo.plane().and_then(|plane| plane.modes.get(own)).map(|mode| mode.naming.name);
            // The second time where its modes weren't known before.
            for _ in 0..2 {
                // Of one mode alone the same mode, whatever its place among the others.
                let modes = self.ghost_memo.plane().map_or(&[][..], |plane| &plane.modes);
                let place = modes.iter().position(|mode| Some(mode.naming.name) == flown);
                compared.disturbance.choices[compared.plane].mode = place.unwrap_or(own);
                self.ghost_memo.refresh(&compared, Page::Disturbance);
            }
        }
    }

    /// A pinned state as it is compared: what the same disturbance does to both.
    pub(super) fn compared(&self, ghost: &Ghost) -> Scenario {
        let Scenario { disturbance, plane, .. } = self.scenario;
        Scenario { disturbance, plane, ..ghost.scenario.clone() }
    }

    pub(super) fn aircraft_ui(&mut self, ui: &mut Ui) {
        let Self { memo, scenario, view, problem_said, .. } = self;
        match flown(ui, memo, scenario, view) {
            Some(flown) => {
                view.flight.show(ui, flown);
                view.responses.set_time(view.flight.time());
            }
            None => problem_ui(ui, memo.followed(), scenario.plane, problem_said),
        }
    }

    /// Lets the playback go on where the aircraft is not on screen.
    pub(super) fn play(&mut self, ui: &Ui) {
        flown(ui, &mut self.memo, &self.scenario, &mut self.view);
        self.view.responses.set_time(self.view.flight.time());
    }

    pub(super) fn poles_ui(&mut self, ui: &mut Ui) {
        self.memo.refresh(&self.scenario, self.view.page);
        let touched = self.view.touched.and_then(Parameter::find);
        self.memo.refresh_locus(&self.scenario, touched);
        let ghost = ghost_modes(self.ghost.as_deref(), &self.ghost_memo);
        match self.memo.plane() {
            Some(plane) => {
                let locus = touched.zip(self.memo.locus());
                self.view.poles.show(ui, Seen { scenario: &self.scenario, plane, ghost, locus });
            }
            None => problem_ui(ui, self.memo.followed(), self.scenario.plane, &mut self.problem_said),
        }
    }

    /// What else the pole map shows, and what the drag of a pole moves.
    pub(super) fn pole_choices_ui(&mut self, ui: &mut Ui, rows: Rows) {
        self.memo.refresh(&self.scenario, self.view.page);
        if let (Some(plane), Some(followed)) = (self.memo.plane(), self.memo.followed()) {
            let choices = &mut self.view.poles.choices;
            choices.show(ui, &self.scenario, plane, &followed.sensitivities, self.view.page, rows);
        }
    }

    pub(super) fn responses_ui(&mut self, ui: &mut Ui, rows: Rows) {
        let Self { memo, scenario, ghost, ghost_memo, view, problem_said, .. } = self;
        memo.refresh(scenario, view.page);
        view.responses.choosers_ui(ui, scenario, memo.plane().map_or(&[], |plane| &plane.modes));
        if !memo.is_of(scenario, view.page) {
            // The aircraft and what is pinned have been brought to the disturbance as it was.
            ui.request_discard("the disturbance changed");
            memo.refresh(scenario, view.page);
        }
        if view.responses.shows_flight() {
            memo.refresh_flight();
        }
        match studied(memo) {
            Some(now) => {
                let ghost = ghost.as_ref().and_then(|_| studied(ghost_memo));
                view.responses.show(ui, now, ghost, rows);
            }
            None => problem_ui(ui, memo.followed(), scenario.plane, problem_said),
        }
    }

    /// Verdicts, and a card for each mode.
    pub(super) fn modes_ui(&mut self, ui: &mut Ui) -> Option<Action> {
        let action = self.verdicts_ui(ui);
        self.cards_ui(|_| 0, std::slice::from_mut(ui));
        self.strongest_ui(ui);
        action
    }

    /// The derivatives that move the modes most; each leads to its slider.
    pub(super) fn strongest_ui(&mut self, ui: &mut Ui) {
        let (Some(plane), Some(followed)) = (self.memo.plane(), self.memo.followed()) else { return };
        let View { strongest, touched, explained, asked, phone_pane, .. } = &mut self.view;
        let wish = strongest.show(ui, &self.scenario, &followed.sensitivities, &plane.modes);
        *touched = wish.touched.or(*touched);
        *explained = wish.touched.unwrap_or(*explained);
        if wish.asked.is_some() {
            *asked = wish.asked;
            *phone_pane = PhonePane::Derivatives;
            ui.request_repaint();
        }
    }

    /// The verdicts, and what stands in their way: the warning about units, a file that could not be read.
    pub(super) fn verdicts_ui(&mut self, ui: &mut Ui) -> Option<Action> {
        let palette = Palette::of(ui);
        for error in &self.content_errors {
            let text = format!("An aircraft could not be read: {error}");
            banner_ui(ui, &text, palette.warning, palette.warning_ground);
        }
        self.memo.refresh(&self.scenario, self.view.page);
        let (Some(plane), Some(Ok(analysis))) = (self.memo.plane(), self.analysis()) else {
            problem_ui(ui, self.memo.followed(), self.scenario.plane, &mut self.problem_said);
            return None;
        };
        verdicts_ui(ui, plane, analysis.margins, self.scenario.aircraft.length_unit);
        let warning = words::stability::mixed_units(analysis)?;
        banner_ui(ui, &format!("⚠ {warning}"), palette.warning, palette.warning_ground);
        let same_unit = self.aircraft.iter().find(|aircraft| aircraft.key == "lesson")?;
        let offered = self.ghost.is_none() && ui.button("Compare with gravity in the same unit").clicked();
        offered.then(|| Action::CompareWith(same_unit.clone()))
    }

    /// A card for each mode, in the columns that `column` tells.
    pub(super) fn cards_ui(&mut self, column: impl Fn(usize) -> usize, columns: &mut [Ui]) {
        self.memo.refresh(&self.scenario, self.view.page);
        let Some(analysed) = self.memo.plane() else { return };
        let ghost = ghost_modes(self.ghost.as_deref(), &self.ghost_memo);
        let choice = self.scenario.disturbance.choices[self.scenario.plane];
        let last = analysed.modes.len().saturating_sub(1);
        let mut asked = None;
        for (i, mode) in analysed.modes.iter().enumerate() {
            let before =
                ghost.and_then(|ghost| ghost.iter().find(|other| other.naming.name == mode.naming.name));
            let flown = choice.source == Source::OneMode && choice.mode.min(last) == i;
            let card = Card { plane: analysed, mode, before, flown };
            // Columns would stretch every line to their width.
            let ragged = Layout::top_down(Align::Min);
            let card = |ui: &mut Ui| card_ui(ui, card, &mut self.view.details);
            if columns[column(i)].with_layout(ragged, card).inner {
                asked = Some((i, flown));
            }
        }
        if let Some((index, flown)) = asked {
            self.fly(index, flown);
        }
    }
}

fn ghost_modes<'a>(ghost: Option<&Ghost>, memo: &'a Memo) -> Option<&'a [Mode]> {
    ghost?;
    memo.plane().map(|plane| plane.modes.as_slice())
}

fn studied(memo: &Memo) -> Option<Studied<'_>> {
    Some(Studied {
        scenario: memo.scenario()?,
        motion: memo.motion()?,
        modes: &memo.plane()?.modes,
        flight: memo.flight(),
    })
}

/// Why there is nothing to draw: a sentence in the pane that comes first, and a remark in the others.
fn problem_ui(ui: &mut Ui, followed: Option<&Followed>, plane: Plane, is_said: &mut bool) {
    let problem = match followed.map(|followed| &followed.analysis) {
        Some(Ok(analysis)) => match &analysis.planes[plane] {
            Some(Err(error)) => error.to_string(),
            Some(Ok(_)) | None => "the source has no data for this plane of motion".to_owned(),
        },
        Some(Err(error)) => error.to_string(),
        None => return,
    };
    let palette = Palette::of(ui);
    if std::mem::replace(is_said, true) {
        ui.label(RichText::new("Nothing to show while this can't be analysed.").color(palette.weak));
    } else {
        banner_ui(ui, &format!("⚠ This can't be analysed: {problem}."), palette.bad, palette.bad_ground);
    }
}

/// The motion on screen as it is flown, brought to the moment of the playback, or to that of the cursor in the plots.
fn flown<'a>(ui: &Ui, memo: &'a mut Memo, scenario: &'a Scenario, view: &mut View) -> Option<Flown<'a>> {
    memo.refresh(scenario, view.page);
    let shows_flight = view.responses.shows_flight();
    if shows_flight {
        memo.refresh_flight();
    }
    let motion = memo.motion()?;
    let flight = memo.flight().filter(|_| shows_flight);
    let flight = flight.and_then(|flight| flight.as_ref().ok()).filter(|flight| !flight.samples.is_empty());
    let flown = Flown { scenario, motion, flight };
    view.flight.advance(ui, flown.end());
    if let Some(time) = view.responses.hovered() {
        view.flight.seek(time);
    }
    Some(flown)
}
