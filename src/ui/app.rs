//! The application: its state, one frame, and the few things that are not edits of a slider.

use std::sync::Arc;

use egui::util::undoer::Undoer;
use egui::{CentralPanel, Context, Frame, Key, Margin, Modifiers, Panel, RichText, ScrollArea, Ui};

use super::derivatives::{Chosen, Outlook, Rows, derivatives_ui};
use super::memo::{Followed, Memo};
use super::mode_cards::{Card, Details, banner_ui, card_ui, units_warning, verdicts_ui};
use super::poles::{Hand, PoleMap, Seen};
use super::responses::{Responses, Studied};
use super::theme::{self, Palette};
use super::top_bar::{Bar, top_bar_ui};
use crate::content::{Aircraft, ContentError, embedded_aircraft};
use crate::flight::analysis::PlaneAnalysis;
use crate::flight::modes::Mode;
use crate::flight::plane::Plane;
use crate::flight::{Analysis, AnalysisError};
use crate::scenario::{Choice, Disturbance, Page, Parameter, Scenario, Source, parameters};

/// Below this width the page is a phone's.
const PHONE: f32 = 700.0;
/// Below this width the modes stand under the responses, not beside them.
const TABLET: f32 = 1180.0;

/// Something a person asked for that isn't the edit of a number. Applied last in a frame, in one place.
#[derive(Clone, Debug, PartialEq)]
pub enum Action {
    /// Study another aircraft.
    Load(Arc<Aircraft>),
    /// Study the other plane of motion.
    Turn(Plane),
    /// Keep this state to compare with.
    Pin,
    /// Keep another aircraft as it is to compare with.
    CompareWith(Arc<Aircraft>),
    /// Compare no more.
    Unpin,
    /// Go back one step.
    Undo,
    /// Go forward one step.
    Redo,
}

/// A pinned state.
#[derive(Clone, Debug, PartialEq)]
pub struct Ghost {
    /// What it is called on screen.
    pub name: String,
    /// The state.
    pub scenario: Scenario,
}

/// The panes of a phone, of which one is on screen below the pole map.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum PhonePane {
    #[default]
    Derivatives,
    Modes,
    Response,
}

/// How a person looks at the scenario: not part of what is studied.
#[derive(Debug)]
struct View {
    poles: PoleMap,
    responses: Responses,
    page: Page,
    /// What the sliders are narrowed down to.
    search: String,
    /// Key of the slider that the help card speaks of.
    explained: &'static str,
    /// Key of the slider that the person is at, whose path is drawn.
    touched: Option<&'static str>,
    phone_pane: PhonePane,
    details: Details,
    /// What disturbed each plane before a mode was flown alone.
    before_flight: [Option<Choice>; 2],
}

/// The page.
#[derive(Debug)]
pub struct App {
    aircraft: Vec<Arc<Aircraft>>,
    content_errors: Vec<ContentError>,
    scenario: Scenario,
    ghost: Option<Ghost>,
    memo: Memo,
    ghost_memo: Memo,
    history: Undoer<Scenario>,
    view: View,
}

impl App {
    /// The page as it opens: the first aircraft, an elevator step. Sets fonts and colours of `ctx`.
    ///
    /// An error is a page without a single aircraft.
    pub fn new(ctx: &Context) -> Result<Self, ContentError> {
        theme::install(ctx);
        let (aircraft, mut content_errors) = embedded_aircraft();
        let aircraft: Vec<Arc<Aircraft>> = aircraft.into_iter().map(Arc::new).collect();
        let Some(first) = aircraft.first() else {
            return Err(content_errors.swap_remove(0));
        };
        Ok(Self {
            scenario: Scenario::new(first.clone()),
            aircraft,
            content_errors,
            ghost: None,
            memo: Memo::default(),
            ghost_memo: Memo::default(),
            history: Undoer::default(),
            view: View {
                poles: PoleMap::default(),
                responses: Responses::default(),
                page: Page::Coefficients,
                search: String::new(),
                explained: "cm_alpha",
                touched: None,
                phone_pane: PhonePane::default(),
                details: Details::default(),
                before_flight: [None; 2],
            },
        })
    }

    /// What is studied.
    pub fn scenario(&self) -> &Scenario {
        &self.scenario
    }

    /// What followed from it in the last frame.
    pub fn analysis(&self) -> Option<&Result<Analysis, AnalysisError>> {
        self.memo.followed().map(|followed| &followed.analysis)
    }

    /// What followed for the plane on screen, where all went well.
    pub fn plane(&self) -> Option<&PlaneAnalysis> {
        self.memo.plane()
    }

    /// How often anything was computed.
    pub fn computations(&self) -> u64 {
        self.memo.computations() + self.ghost_memo.computations()
    }

    /// One frame.
    pub fn ui(&mut self, ui: &mut Ui) {
        let mut action = shortcuts(ui);
        let width = ui.content_rect().width();
        let phone = width < PHONE;
        let palette = Palette::of(ui);
        // First of all, so that the sliders are drawn where the drag of a pole has brought them.
        let mut hand = self.view.poles.edit(ui, &mut self.scenario, &self.memo, self.view.page);
        if hand == Hand::Takes {
            // A drag is one step, whatever was edited just before it and however long it takes.
            self.history.add_undo(&self.scenario);
            hand = self.view.poles.edit(ui, &mut self.scenario, &self.memo, self.view.page);
        }
        let bar = Frame::new().fill(palette.pane).inner_margin(Margin::symmetric(14, 8));
        action = Panel::top("top bar")
            .frame(bar)
            .show(ui, |ui| {
                top_bar_ui(
                    ui,
                    Bar {
                        aircraft: &self.aircraft,
                        scenario: &self.scenario,
                        ghost: self.ghost.as_ref(),
                        history: (
                            self.history.has_undo(&self.scenario),
                            self.history.has_redo(&self.scenario),
                        ),
                        narrow: phone,
                        roomy: width >= TABLET,
                    },
                )
            })
            .inner
            .or(action);
        action = if phone { self.phone_ui(ui) } else { self.desk_ui(ui, width >= TABLET) }.or(action);
        if let Some(action) = action {
            self.apply(action);
        }
        if !self.memo.is_of(&self.scenario, self.view.page) {
            // Something drawn after a view has edited the scenario: draw this frame again before it is shown.
            ui.request_discard("the scenario changed");
        }
        match hand {
            Hand::LetsGo => self.history.add_undo(&self.scenario),
            Hand::Takes | Hand::Holds => {}
            Hand::Away => self.history.feed_state(ui.input(|input| input.time), &self.scenario),
        }
    }

    /// Sliders left, poles and responses in the middle, modes right or, on a tablet, below.
    fn desk_ui(&mut self, ui: &mut Ui, wide: bool) -> Option<Action> {
        let palette = Palette::of(ui);
        let side = Frame::new().fill(palette.pane).inner_margin(Margin::symmetric(12, 10));
        Panel::left("derivatives")
            .exact_size(if wide { 362.0 } else { 344.0 })
            .resizable(false)
            .frame(side)
            .show(ui, |ui| {
                self.derivatives_ui(ui, Rows::Dense);
            });
        self.ghost_memo_refresh();
        let mut action = None;
        if wide {
            action = Panel::right("modes")
                .exact_size(286.0)
                .resizable(false)
                .frame(side)
                .show(ui, |ui| {
                    let modes = |ui: &mut Ui| self.modes_ui(ui);
                    ScrollArea::vertical().id_salt("modes").auto_shrink(false).show(ui, modes).inner
                })
                .inner;
        }
        let ground = Frame::new().fill(palette.background).inner_margin(Margin::same(10));
        let middle = |ui: &mut Ui| {
            if wide {
                let poles = 0.46 * ui.available_height();
                self.pole_pane_ui(ui, poles);
                self.response_pane_ui(ui, Rows::Dense);
                return None;
            }
            ScrollArea::vertical()
                .id_salt("middle")
                .auto_shrink(false)
                .show(ui, |ui| {
                    let action = self.verdicts_ui(ui);
                    self.pole_pane_ui(ui, 250.0);
                    self.response_pane_ui(ui, Rows::Dense);
                    ui.columns(2, |columns| {
                        self.cards_ui(|i| i % 2, columns);
                    });
                    action
                })
                .inner
        };
        CentralPanel::default().frame(ground).show(ui, middle).inner.or(action)
    }

    /// The pole map stays on top; one of the other panes is below it.
    fn phone_ui(&mut self, ui: &mut Ui) -> Option<Action> {
        let palette = Palette::of(ui);
        let ground = Frame::new().fill(palette.pane).inner_margin(Margin::symmetric(10, 6));
        self.ghost_memo_refresh();
        Panel::top("poles").exact_size(266.0).resizable(false).frame(ground).show(ui, |ui| {
            ui.horizontal(|ui| self.pole_choices_ui(ui, Rows::Touch));
            self.poles_ui(ui);
        });
        Panel::top("panes").frame(ground).show(ui, |ui| {
            ui.horizontal(|ui| {
                ui.spacing_mut().interact_size.y = theme::TOUCH_HEIGHT - 8.0;
                for (pane, text) in [
                    (PhonePane::Derivatives, "Derivatives"),
                    (PhonePane::Modes, "Modes"),
                    (PhonePane::Response, "Response"),
                ] {
                    ui.selectable_value(&mut self.view.phone_pane, pane, text);
                }
            });
        });
        let pane = |ui: &mut Ui| match self.view.phone_pane {
            PhonePane::Derivatives => {
                self.derivatives_ui(ui, Rows::Touch);
                None
            }
            PhonePane::Modes => {
                ScrollArea::vertical()
                    .id_salt("modes")
                    .auto_shrink(false)
                    .show(ui, |ui| self.modes_ui(ui))
                    .inner
            }
            PhonePane::Response => {
                let responses = |ui: &mut Ui| self.responses_ui(ui, Rows::Touch);
                ScrollArea::vertical().id_salt("responses").auto_shrink(false).show(ui, responses);
                None
            }
        };
        CentralPanel::default().frame(ground).show(ui, pane).inner
    }

    fn derivatives_ui(&mut self, ui: &mut Ui, rows: Rows) {
        if !self.view.page.is_of(&self.scenario) {
            self.view.page = Page::of(&self.scenario);
        }
        self.memo.refresh(&self.scenario, self.view.page);
        let followed = self.memo.followed();
        let outlook = Outlook {
            sensitivities: followed.map_or(&[], |followed| &followed.sensitivities),
            modes: self.memo.plane().map_or(&[], |plane| &plane.modes),
        };
        self.view.touched = {
            let View { page, search, .. } = &mut self.view;
            derivatives_ui(ui, &mut self.scenario, Chosen { page, search }, rows, outlook)
        };
        self.view.explained = self.view.touched.unwrap_or(self.view.explained);
        let (page, scenario) = (self.view.page, &self.scenario);
        if !Parameter::find(self.view.explained).is_some_and(|p| p.is_shown(scenario, page)) {
            let first = parameters().find(|p| p.is_shown(scenario, page));
            self.view.explained = first.map_or("", |p| p.key);
        }
        if rows == Rows::Dense {
            super::derivatives::help_ui(ui, self.view.explained);
        }
    }

    fn ghost_memo_refresh(&mut self) {
        if let Some(ghost) = &mut self.ghost {
            // Compared is what the same disturbance does to both.
            ghost.scenario.disturbance = self.scenario.disturbance;
            ghost.scenario.plane = self.scenario.plane;
            self.ghost_memo.refresh(&ghost.scenario, Page::Disturbance);
        }
    }

    fn pole_pane_ui(&mut self, ui: &mut Ui, height: f32) {
        theme::pane(Palette::of(ui)).show(ui, |ui| {
            ui.set_height(height);
            ui.horizontal(|ui| {
                theme::heading(ui, RichText::new("Pole map").heading(), 2);
                self.pole_choices_ui(ui, Rows::Dense);
            });
            self.poles_ui(ui);
        });
    }

    fn response_pane_ui(&mut self, ui: &mut Ui, rows: Rows) {
        theme::pane(Palette::of(ui)).show(ui, |ui| {
            ui.set_min_height(ui.available_height().max(320.0) - 2.0);
            self.responses_ui(ui, rows);
        });
    }

    fn poles_ui(&mut self, ui: &mut Ui) {
        self.memo.refresh(&self.scenario, self.view.page);
        let touched = self.view.touched.and_then(Parameter::find);
        self.memo.refresh_locus(&self.scenario, touched);
        let ghost = ghost_modes(self.ghost.as_ref(), &self.ghost_memo);
        match self.memo.plane() {
            Some(plane) => {
                let locus = touched.zip(self.memo.locus());
                self.view.poles.show(ui, Seen { scenario: &self.scenario, plane, ghost, locus });
            }
            None => problem_ui(ui, self.memo.followed(), self.scenario.plane),
        }
    }

    /// What else the pole map shows, and what the drag of a pole moves.
    fn pole_choices_ui(&mut self, ui: &mut Ui, rows: Rows) {
        self.memo.refresh(&self.scenario, self.view.page);
        if let (Some(plane), Some(followed)) = (self.memo.plane(), self.memo.followed()) {
            let choices = &mut self.view.poles.choices;
            choices.show(ui, &self.scenario, plane, &followed.sensitivities, self.view.page, rows);
        }
    }

    fn responses_ui(&mut self, ui: &mut Ui, rows: Rows) {
        let Self { memo, scenario, ghost, ghost_memo, view, .. } = self;
        memo.refresh(scenario, view.page);
        view.responses.choosers_ui(ui, scenario, memo.plane().map_or(&[], |plane| &plane.modes));
        memo.refresh(scenario, view.page);
        if view.responses.shows_flight() {
            memo.refresh_flight();
        }
        match studied(scenario, memo) {
            Some(now) => {
                let ghost = ghost.as_ref().and_then(|ghost| studied(&ghost.scenario, ghost_memo));
                view.responses.show(ui, now, ghost, rows);
            }
            None => problem_ui(ui, memo.followed(), scenario.plane),
        }
    }

    /// Verdicts, and a card for each mode.
    fn modes_ui(&mut self, ui: &mut Ui) -> Option<Action> {
        let action = self.verdicts_ui(ui);
        self.cards_ui(|_| 0, std::slice::from_mut(ui));
        action
    }

    /// The verdicts, and what stands in their way: the warning about units, a file that could not be read.
    fn verdicts_ui(&mut self, ui: &mut Ui) -> Option<Action> {
        let palette = Palette::of(ui);
        for error in &self.content_errors {
            let text = format!("An aircraft could not be read: {error}");
            banner_ui(ui, &text, palette.warning, palette.warning_ground);
        }
        self.memo.refresh(&self.scenario, self.view.page);
        let (Some(plane), Some(Ok(analysis))) = (self.memo.plane(), self.analysis()) else {
            problem_ui(ui, self.memo.followed(), self.scenario.plane);
            return None;
        };
        verdicts_ui(ui, plane, analysis.margins, self.scenario.aircraft.length_unit);
        let warning = units_warning(analysis)?;
        banner_ui(ui, &format!("⚠ {warning}"), palette.warning, palette.warning_ground);
        let same_unit = self.aircraft.iter().find(|aircraft| aircraft.key == "lesson")?;
        let offered = self.ghost.is_none() && ui.button("Compare with gravity in the same unit").clicked();
        offered.then(|| Action::CompareWith(same_unit.clone()))
    }

    /// A card for each mode, in the columns that `column` tells.
    fn cards_ui(&mut self, column: impl Fn(usize) -> usize, columns: &mut [Ui]) {
        self.memo.refresh(&self.scenario, self.view.page);
        let Some(analysed) = self.memo.plane() else { return };
        let ghost = ghost_modes(self.ghost.as_ref(), &self.ghost_memo);
        let choice = *self.scenario.disturbance.choice(self.scenario.plane);
        let last = analysed.modes.len().saturating_sub(1);
        let mut asked = None;
        for (i, mode) in analysed.modes.iter().enumerate() {
            let before =
                ghost.and_then(|ghost| ghost.iter().find(|other| other.naming.name == mode.naming.name));
            let flown = choice.source == Source::OneMode && choice.mode.min(last) == i;
            let card = Card { plane: analysed, mode, before, flown };
            if card_ui(&mut columns[column(i)], card, &mut self.view.details) {
                asked = Some((i, flown));
            }
        }
        if let Some((index, flown)) = asked {
            self.fly(index, flown);
        }
    }

    /// Flies a mode alone, or goes back to what was before.
    fn fly(&mut self, index: usize, flown: bool) {
        let plane = self.scenario.plane;
        let choice = self.scenario.disturbance.choice_mut(plane);
        let before = &mut self.view.before_flight[plane as usize];
        if flown {
            let standard = *Disturbance::default().choice(plane);
            *choice = before.take().unwrap_or(standard);
            return;
        }
        if choice.source != Source::OneMode {
            *before = Some(*choice);
        }
        *choice = Choice { source: Source::OneMode, mode: index, ..*choice };
    }

    fn apply(&mut self, action: Action) {
        match action {
            Action::Load(aircraft) => self.scenario = self.scenario.with_aircraft(aircraft),
            Action::Turn(plane) => self.scenario.plane = plane,
            Action::Pin => self.ghost = Some(Ghost { name: self.name(), scenario: self.scenario.clone() }),
            Action::CompareWith(aircraft) => {
                self.ghost = Some(Ghost {
                    name: aircraft.name.clone(),
                    scenario: self.scenario.with_aircraft(aircraft),
                });
            }
            Action::Unpin => self.ghost = None,
            Action::Undo => {
                if let Some(before) = self.history.undo(&self.scenario) {
                    self.scenario = before.clone();
                }
            }
            Action::Redo => {
                if let Some(after) = self.history.redo(&self.scenario) {
                    self.scenario = after.clone();
                }
            }
        }
    }

    fn name(&self) -> String {
        let edited = if self.scenario.is_edited() { ", edited" } else { "" };
        format!("{}{edited}", self.scenario.aircraft.name)
    }
}

fn ghost_modes<'a>(ghost: Option<&Ghost>, memo: &'a Memo) -> Option<&'a [Mode]> {
    ghost?;
    memo.plane().map(|plane| plane.modes.as_slice())
}

fn studied<'a>(scenario: &'a Scenario, memo: &'a Memo) -> Option<Studied<'a>> {
    Some(Studied { scenario, motion: memo.motion()?, modes: &memo.plane()?.modes, flight: memo.flight() })
}

/// Why there is nothing to draw.
fn problem_ui(ui: &mut Ui, followed: Option<&Followed>, plane: Plane) {
    let problem = match followed.map(|followed| &followed.analysis) {
        Some(Ok(analysis)) => match analysis.of(plane) {
            Some(Err(error)) => error.to_string(),
            Some(Ok(_)) | None => "the source has no data for this plane of motion".to_owned(),
        },
        Some(Err(error)) => error.to_string(),
        None => return,
    };
    let palette = Palette::of(ui);
    banner_ui(ui, &format!("⚠ This can't be analysed: {problem}."), palette.bad, palette.bad_ground);
}

fn shortcuts(ui: &Ui) -> Option<Action> {
    ui.input_mut(|input| {
        if input.consume_key(Modifiers::COMMAND | Modifiers::SHIFT, Key::Z)
            || input.consume_key(Modifiers::COMMAND, Key::Y)
        {
            Some(Action::Redo)
        } else if input.consume_key(Modifiers::COMMAND, Key::Z) {
            Some(Action::Undo)
        } else {
            None
        }
    })
}
