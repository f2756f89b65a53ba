//! What is in the panes: each draws what follows from the scenario, and may edit it in place.

use std::rc::Rc;

use egui::{Align, Layout, RichText, Ui};

use super::layout::CORNER;
use super::{Action, App, Panes, PhonePane};
use crate::findings::{Findings, Remark, Trajectory};
use crate::scenario::view::{Marks, Pane};
use crate::scenario::{Hidden, Lock, Page, Parameter, Source, View, parameters};
use crate::ui::curtain::Curtain;
use crate::ui::derivatives::{Chosen, Rows, derivatives_ui};
use crate::ui::equations::{Size, Wish};
use crate::ui::mode_cards::{Card, banner_ui, card_ui, verdicts_ui};
use crate::ui::overall_level::overall_level_ui;
use crate::ui::poles::{PoleMapContent, shows_approximations, shows_levels};
use crate::ui::slider_search::{Filter, is_listed};
use crate::ui::theme::{self, Palette};
use crate::words;

impl App {
    pub(super) fn derivatives_ui(&mut self, ui: &mut Ui, rows: Rows) {
        if !self.view.page.is_of(&self.scenario) {
            self.view.page = Page::of(&self.scenario);
        }
        let (last, is_stale) = self.shown();
        let (mut enlarge, mut wish) = (false, Wish::default());
        self.panes.touched = {
            let Panes { search, asked, equations: of_equations, .. } = &mut self.panes;
            let View { page, stage, equations, maximised, .. } = &mut self.view;
            let beside = *page == Page::Matrix && *maximised != Some(Pane::Equations);
            let chosen = Chosen { page, search, stage, asked: asked.take(), equations: &mut enlarge };
            let above = |ui: &mut Ui| {
                if beside {
                    let show = |ui: &mut Ui| {
                        if is_stale {
                            ui.disable();
                        }
                        of_equations.show(ui, &last, equations, (Size::Beside, true))
                    };
                    wish = ui.scope(show).inner;
                }
            };
            derivatives_ui(ui, &mut self.scenario, chosen, rows, (&self.findings, &last), above)
        };
        self.grant(ui, Wish { enlarge: enlarge || wish.enlarge, ..wish });
        self.panes.explained = self.panes.touched.unwrap_or(self.panes.explained);
        let filter = Filter { search: &self.panes.search, stage: &self.view.stage };
        let listed = |p: &&Parameter| is_listed(p, &self.scenario, self.view.page, filter);
        if Parameter::find(self.panes.explained).filter(listed).is_none() {
            let first = parameters().find(listed);
            self.panes.explained = first.map_or("", |p| p.key);
        }
        if rows == Rows::Dense {
            crate::ui::derivatives::help_ui(ui, self.panes.explained);
        }
    }

    /// The equations alone.
    pub(super) fn equations_ui(&mut self, ui: &mut Ui) {
        let findings = self.shown_ui(ui);
        let leads = self.has_sliders();
        let view = &mut self.view.equations;
        let wish = self.panes.equations.show(ui, &findings, view, (Size::Alone, leads));
        if !leads {
            // No slider takes it back.
            self.panes.touched = None;
        }
        self.grant(ui, wish);
    }

    /// Goes to the slider that is asked for in the equations, or puts them alone.
    fn grant(&mut self, ui: &Ui, Wish { touched, asked, enlarge }: Wish) {
        self.panes.touched = touched.or(self.panes.touched);
        let stays = Curtain::of(ui).locks(Lock::View);
        let is_in_reach = |parameter: &&Parameter| !stays || parameter.page == Some(self.view.page);
        if let Some(parameter) = asked.filter(is_in_reach) {
            self.view.page = parameter.page.unwrap_or(self.view.page);
            self.panes.asked = Some(parameter.key);
            self.panes.phone_pane = PhonePane::Derivatives;
            ui.request_repaint();
        }
        if enlarge {
            self.view.maximised = Some(Pane::Equations);
            self.go_to_equations();
            ui.request_repaint();
        }
    }

    pub(super) fn aircraft_ui(&mut self, ui: &mut Ui) {
        let findings = self.shown_ui(ui);
        if let Some(trajectory) = flown(ui, &findings, &self.view, &mut self.panes) {
            self.panes.flight.show(ui, &mut self.view.flight, trajectory);
            self.panes.responses.set_time(self.panes.flight.time());
        }
    }

    /// Lets the playback go on where the aircraft is not on screen.
    pub(super) fn play(&mut self, ui: &Ui) {
        let (findings, _) = self.shown();
        flown(ui, &findings, &self.view, &mut self.panes);
        self.panes.responses.set_time(self.panes.flight.time());
    }

    pub(super) fn poles_ui(&mut self, ui: &mut Ui) {
        let findings = self.shown_ui(ui);
        let Some(plane) = findings.plane() else { return };
        let curtain = Curtain::of(ui);
        // The path of a slider tells what it would do.
        let touched = self.panes.touched.and_then(Parameter::find);
        let touched = touched.filter(|_| !curtain.hides(Hidden::Reasons));
        let locus = touched.map(|parameter| (parameter, findings.locus(parameter)));
        let locus = locus.as_ref().map(|(parameter, locus)| (*parameter, locus.as_ref()));
        let pinned = self.pinned_findings.as_ref().map(|pinned| pinned.modes());
        let Marks { approximations, levels } = self.view.marks;
        let marks = Marks {
            approximations: approximations && shows_approximations(&curtain),
            levels: levels && shows_levels(&curtain),
        };
        let findings = findings.as_ref();
        self.panes.poles.show(ui, PoleMapContent { findings, plane, pinned, marks, locus });
    }

    /// What else the pole map shows, and what the drag of a pole moves.
    pub(super) fn pole_choices_ui(&mut self, ui: &mut Ui, rows: Rows) {
        if self.findings.plane().is_some() {
            let View { page, marks, .. } = &mut self.view;
            self.panes.poles.choices.show(ui, &self.findings, *page, marks, rows);
        }
    }

    pub(super) fn responses_ui(&mut self, ui: &mut Ui, rows: Rows) {
        let view = &mut self.view.response;
        ui.scope(|ui| {
            if rows == Rows::Dense {
                ui.set_max_width(ui.available_width() - CORNER);
            }
            self.panes.responses.choosers_ui(ui, &mut self.scenario, view, self.findings.modes());
        });
        let findings = self.shown_ui(ui);
        if findings.motion().is_some() {
            let view = &mut self.view.response;
            self.panes.responses.show(ui, view, &findings, self.pinned_findings.as_ref(), rows);
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
        let (findings, is_stale) = self.shown();
        if findings.plane().is_none() || Curtain::of(ui).hides(Hidden::Reasons) {
            return;
        }
        let Panes { strongest, touched, explained, asked, phone_pane, .. } = &mut self.panes;
        let page = self.view.page;
        let show = |ui: &mut Ui| {
            if is_stale {
                ui.disable();
            }
            strongest.show(ui, &findings, page)
        };
        let wish = ui.scope(show).inner;
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
        let (findings, is_stale) = self.shown();
        self.problem_ui(ui, is_stale);
        let (Some(plane), Ok(analysis)) = (findings.plane(), findings.analysis()) else { return None };
        // What stands below may be of other panes.
        ui.scope(|ui| {
            if is_stale {
                ui.disable();
            }
            verdicts_ui(ui, plane, analysis.margins, self.scenario.aircraft.length_unit);
            overall_level_ui(ui, analysis, &mut self.scenario.task);
        });
        let Some(Remark::MixedUnits(gravity)) = findings.remarks().first().copied() else { return None };
        if Curtain::of(ui).hides(Hidden::Numbers) {
            return None;
        }
        let warning = words::stability::mixed_units(gravity);
        banner_ui(ui, &format!("⚠ {warning}"), palette.warning, palette.warning_ground);
        let same_unit = self.aircraft.iter().find(|aircraft| aircraft.key == "lesson")?;
        let offered = self.pinned.is_none() && ui.button("Compare with gravity in the same unit").clicked();
        offered.then(|| Action::PinAircraft(same_unit.clone()))
    }

    /// A card for each mode, in the columns that `column` tells.
    pub(super) fn cards_ui(&mut self, column: impl Fn(usize) -> usize, columns: &mut [Ui]) {
        let (findings, is_stale) = self.shown();
        let Some(analysed) = findings.plane() else { return };
        if is_stale {
            columns.iter_mut().for_each(Ui::disable);
        }
        let pinned = self.pinned_findings.clone();
        if let Some(ui) = columns.first().filter(|ui| !Curtain::of(ui).hides_influence()) {
            self.panes.why.update(ui, pinned.as_ref(), &findings);
        }
        let choice = self.scenario.disturbance.choices[self.scenario.plane];
        let last = analysed.modes.len().saturating_sub(1);
        let mut asked = None;
        let order = columns.first().map(|ui| Curtain::of(ui).order(&analysed.modes)).unwrap_or_default();
        for (place, i) in order.into_iter().enumerate() {
            let mode = &analysed.modes[i];
            let pinned = pinned.iter().flat_map(|pinned| pinned.modes());
            let before = pinned.into_iter().find(|other| other.naming.name == mode.naming.name);
            let flown = choice.source == Source::OneMode && choice.mode.min(last) == i;
            let card = Card { plane: analysed, mode, before, flown };
            // Columns would stretch every line to their width.
            let ragged = Layout::top_down(Align::Min);
            let card = |ui: &mut Ui| card_ui(ui, card, &mut self.view.details, &mut self.panes.why);
            if columns[column(place)].with_layout(ragged, card).inner {
                asked = Some((i, flown));
            }
        }
        if let Some((index, flown)) = asked {
            self.fly(index, flown);
        }
    }

    /// What the rest of a pane draws. Where nothing follows from the scenario it says so first, and what followed last is dimmed.
    fn shown_ui(&mut self, ui: &mut Ui) -> Rc<Findings> {
        let (findings, is_stale) = self.shown();
        self.problem_ui(ui, is_stale);
        if is_stale {
            ui.disable();
        }
        findings
    }

    /// Why nothing follows: a sentence in the pane that comes first, and a remark in the others.
    fn problem_ui(&mut self, ui: &mut Ui, is_stale: bool) {
        let Some(problem) = self.findings.problem() else { return };
        let palette = Palette::of(ui);
        if std::mem::replace(&mut self.panes.problem_said, true) {
            let text = if is_stale { words::sliders::AS_IT_WAS } else { words::sliders::NOTHING };
            ui.label(RichText::new(text).font(theme::small()).color(palette.bad));
        } else {
            banner_ui(ui, &format!("⚠ This can't be analysed: {problem}."), palette.bad, palette.bad_ground);
        }
    }
}

/// The motion on screen as it is flown, brought to the moment of the playback, or to that of the cursor in the plots.
fn flown<'a>(ui: &Ui, findings: &'a Findings, view: &View, panes: &mut Panes) -> Option<Trajectory<'a>> {
    let trajectory = findings.trajectory(view.response.shows_flight())?;
    panes.flight.advance(ui, view.flight.pace, trajectory.end());
    if let Some(time) = panes.responses.hovered() {
        panes.flight.seek(time);
    }
    Some(trajectory)
}
