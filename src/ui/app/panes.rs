//! What is in the panes: each draws what follows from the scenario, and may edit it in place.

use std::rc::Rc;

use egui::{Align, Layout, RichText, Ui};

use super::layout::CORNER;
use super::{Action, App, Panes, PhonePane};
use crate::findings::{Findings, Remark, Trajectory};
use crate::scenario::view::{Marks, Pane, Tab};
use crate::scenario::{Hidden, Lock, Page, Parameter, Scenario, Source, View, parameters};
use crate::ui::curtain::Curtain;
use crate::ui::derivatives::{Chosen, Rows, derivatives_ui};
use crate::ui::equations::{Size, Wish};
use crate::ui::feedback::{LeastGainSaid, least_gain_ui, legend_ui, switch_ui, told_ui};
use crate::ui::mode_cards::{Card, banner_ui, card_ui, verdicts_ui};
use crate::ui::overall_level::overall_level_ui;
use crate::ui::poles::{PoleMapContent, page_of_drag, shows_approximations, shows_levels};
use crate::ui::slider_search::{Filter, is_listed};
use crate::ui::theme::{self, Palette};
use crate::words;

impl App {
    pub(super) fn derivatives_ui(&mut self, ui: &mut Ui, rows: Rows) {
        if !self.view.page.is_of(&self.scenario) {
            self.view.page = Page::of(&self.scenario);
        }
        let (last, is_stale) = self.shown();
        let (mut enlarge, mut wish, mut least, mut chart) = (false, Wish::default(), None, None);
        self.panes.touched = {
            let Panes { search, asked, equations: of_equations, least_gain, .. } = &mut self.panes;
            let View { page, stage, equations, maximised, shows_open, .. } = &mut self.view;
            let beside = *page == Page::Matrix && *maximised != Some(Pane::Equations);
            let has_gains = *page == Page::Feedback;
            let (asked, equations_asked) = (asked.take(), &mut enlarge);
            let chosen = Chosen { page, search, stage, asked, equations: equations_asked, chart: &mut chart };
            let above = |ui: &mut Ui| {
                if has_gains {
                    ui.horizontal_wrapped(|ui| {
                        switch_ui(ui, &last, shows_open);
                        least = least_gain_ui(ui, &last, least_gain.as_ref());
                    });
                }
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
        if let Some(gain) = least {
            self.panes.least_gain = Some(LeastGainSaid::of(&self.findings, &mut self.scenario, gain));
            self.view.shows_open = false;
        }
        self.grant(ui, Wish { enlarge: enlarge || wish.enlarge, ..wish });
        if let Some(parameter) = chart {
            self.chart_over(ui, parameter);
        }
        self.panes.explained = self.panes.touched.unwrap_or(self.panes.explained);
        let filter = Filter { search: &self.panes.search, stage: &self.view.stage };
        let listed = |p: &&Parameter| is_listed(p, &self.scenario, self.view.page, filter);
        if Parameter::find(self.panes.explained).filter(listed).is_none() {
            let first = parameters().find(listed);
            self.panes.explained = first.map_or("", |p| p.key);
        }
        if rows == Rows::Dense {
            crate::ui::explanation::help_ui(ui, self.panes.explained, self.scenario.convention());
        }
    }

    /// Opens the chart over a slider, with the measure that was charted last.
    fn chart_over(&mut self, ui: &Ui, parameter: &'static Parameter) {
        let response = &mut self.view.response;
        (response.tab, response.chart[self.scenario.plane].over) = (Tab::Chart, Some(parameter));
        if self.view.maximised.is_some() {
            self.view.maximised = Some(Pane::Response);
        }
        self.panes.phone_pane = PhonePane::Response;
        ui.request_repaint();
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
    fn grant(&mut self, ui: &Ui, Wish { touched, asked, enlarge, notation }: Wish) {
        self.scenario.notation = notation.unwrap_or(self.scenario.notation);
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
        let Some(plane) = findings.flown() else { return };
        let curtain = Curtain::of(ui);
        // The path of a slider tells what it would do.
        let touched = self.panes.touched.and_then(Parameter::find);
        // While the loop is shown open no gain does anything.
        let is_done = |p: &&Parameter| p.page != Some(Page::Feedback) || !findings.is_opened();
        let touched = touched.filter(is_done).filter(|_| !curtain.hides(Hidden::Reasons));
        let locus = touched.map(|parameter| (parameter, findings.locus(parameter)));
        let locus = locus.as_ref().map(|(parameter, locus)| (*parameter, locus.as_ref()));
        let pinned = self.pinned_findings.as_ref().map(|pinned| pinned.flown_modes());
        let Marks { approximations, levels } = self.view.marks;
        let marks = Marks {
            approximations: approximations && shows_approximations(&curtain),
            levels: levels && shows_levels(&curtain),
        };
        let findings = findings.as_ref();
        legend_ui(ui, findings);
        self.panes.poles.show(ui, PoleMapContent { findings, plane, pinned, marks, locus });
    }

    /// What else the pole map shows, and what the drag of a pole moves.
    pub(super) fn pole_choices_ui(&mut self, ui: &mut Ui, rows: Rows) {
        if self.findings.plane().is_some() {
            let View { page, marks, .. } = &mut self.view;
            let page = page_of_drag(&self.findings, *page);
            self.panes.poles.choices.show(ui, &self.findings, page, marks, rows);
        }
    }

    pub(super) fn responses_ui(&mut self, ui: &mut Ui, rows: Rows) {
        let view = &mut self.view.response;
        ui.scope(|ui| {
            if rows == Rows::Dense {
                ui.set_max_width(ui.available_width() - CORNER);
            }
            self.panes.responses.choosers_ui(ui, &mut self.scenario, view, &self.findings);
        });
        self.motion_ui(ui, rows);
    }

    /// The responses without their choosers.
    pub(super) fn motion_ui(&mut self, ui: &mut Ui, rows: Rows) {
        let findings = self.shown_ui(ui);
        if findings.motion().is_some() {
            let edited = (&mut self.scenario, &mut self.view.response);
            self.panes.responses.show(ui, edited, &findings, self.pinned_findings.as_ref(), rows);
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
        let (Some(plane), Ok(analysis)) = (findings.flown(), findings.analysis()) else { return None };
        // What stands below may be of other panes.
        ui.scope(|ui| {
            if is_stale {
                ui.disable();
            }
            told_ui(ui, &findings);
            verdicts_ui(ui, plane, analysis.margins, self.scenario.convention());
            overall_level_ui(ui, &findings, &mut self.scenario.task);
        });
        let Some(Remark::MixedUnits(gravity)) = findings.remarks().first().copied() else { return None };
        if Curtain::of(ui).hides(Hidden::Numbers) {
            return None;
        }
        let warning = words::stability::mixed_units(gravity);
        banner_ui(ui, &format!("⚠ {warning}"), palette.warning, palette.warning_ground);
        let same_unit = self.aircraft.iter().find(|aircraft| aircraft.key == "lesson")?;
        let can_pin = self.pinned.is_none()
            && ![Lock::Aircraft, Lock::View].map(|lock| Curtain::of(ui).locks(lock)).contains(&true);
        let offered = can_pin && ui.button("Compare with gravity in the same unit").clicked();
        offered.then(|| Action::PinAircraft(same_unit.clone()))
    }

    /// A card for each mode, in the columns that `column` tells.
    pub(super) fn cards_ui(&mut self, column: impl Fn(usize) -> usize, columns: &mut [Ui]) {
        let (findings, is_stale) = self.shown();
        let Some(analysed) = findings.flown() else { return };
        if is_stale {
            columns.iter_mut().for_each(Ui::disable);
        }
        let pinned = self.pinned_findings.clone();
        if let Some(ui) = columns.first().filter(|ui| !Curtain::of(ui).hides_influence()) {
            self.panes.why.update(ui, pinned.as_ref(), &findings);
        }
        if let Some(ui) = columns.first_mut() {
            self.panes.why.under_law_ui(ui);
        }
        let Scenario { disturbance, plane, notation, .. } = self.scenario;
        let choice = disturbance.choices[plane];
        let last = analysed.modes.len().saturating_sub(1);
        let mut asked = None;
        let order = columns.first().map(|ui| Curtain::of(ui).order(&analysed.modes)).unwrap_or_default();
        for (place, i) in order.into_iter().enumerate() {
            let mode = &analysed.modes[i];
            let pinned = pinned.iter().flat_map(|pinned| pinned.flown_modes());
            let before = pinned.into_iter().find(|other| other.naming.name == mode.naming.name);
            let flown = choice.source == Source::OneMode && choice.mode.min(last) == i;
            let whole =
                findings.law_flown().and_then(|flown| flown.modes.get(i).map(|mode| (mode, &flown.closed)));
            let card = Card { plane: analysed, mode, whole, before, flown, notation };
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
    pub(super) fn shown_ui(&mut self, ui: &mut Ui) -> Rc<Findings> {
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
            let problem = words::Told(&problem, self.findings.scenario().length_unit());
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
