//! The application: its state, one frame, and the few things that are not edits of a slider.

use std::sync::Arc;

use egui::util::undoer::Undoer;
use egui::{
    Button, CentralPanel, Context, Frame, Id, Margin, Panel, Rect, RichText, ScrollArea, Sense, Ui,
    UiBuilder, Vec2,
};

use super::derivatives::{Chosen, Outlook, Rows, derivatives_ui};
use super::flight_pane::FlightPane;
use super::keys::{self, Command, Pane};
use super::memo::{Followed, Memo};
use super::mode_cards::{Card, Details, banner_ui, card_ui, units_warning, verdicts_ui};
use super::poles::{Hand, PoleMap, Seen};
use super::responses::{Responses, Studied, seen_in};
use super::share::Share;
use super::theme::{self, Look, Palette};
use super::top_bar::{Bar, top_bar_ui};
use crate::content::{Aircraft, ContentError, embedded_aircraft};
use crate::flight::analysis::PlaneAnalysis;
use crate::flight::modes::Mode;
use crate::flight::plane::Plane;
use crate::flight::{Analysis, AnalysisError};
use crate::scenario::link::{self, LinkView};
use crate::scenario::{Choice, Disturbance, Flown, Page, Parameter, Scenario, Source, parameters};

/// Below this width the page is a phone's.
const PHONE: f32 = 700.0;
/// Below this width the top bar has two rows, as on a phone.
const CRAMPED: f32 = 860.0;
/// Below this width the modes stand under the responses, not beside them.
const TABLET: f32 = 1180.0;
/// From this width on two panes of a tablet stand beside each other.
const BESIDE: f32 = 560.0;
/// Between panes.
const PANE_GAP: f32 = 10.0;

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
    /// Copy the whole scene as a link.
    CopyLink,
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
    Aircraft,
}

/// How a person looks at the scenario: not part of what is studied.
#[derive(Debug)]
struct View {
    poles: PoleMap,
    responses: Responses,
    flight: FlightPane,
    /// The pane that is over the whole page.
    maximised: Option<Pane>,
    /// Whether the sheet of keys is open.
    help: bool,
    page: Page,
    /// What the sliders are narrowed down to.
    search: String,
    /// Key of the slider that the help card speaks of.
    explained: &'static str,
    /// Key of the slider that the person is at, whose path is drawn.
    touched: Option<&'static str>,
    phone_pane: PhonePane,
    details: Details,
    /// What disturbed each plane, and for how long it was watched \[s\], before a mode was flown alone.
    before_flight: [Option<(Choice, f64)>; 2],
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
    share: Share,
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
            share: Share::default(),
            view: View {
                poles: PoleMap::default(),
                responses: Responses::default(),
                flight: FlightPane::default(),
                maximised: None,
                help: false,
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

    /// The whole scene as a link, without the `#`.
    pub fn link(&self) -> String {
        let usual = LinkView::of(&self.scenario);
        let page = if self.view.page.is_of(&self.scenario) { self.view.page } else { usual.page };
        let ghost = self.ghost.as_ref().map(|ghost| ghost.scenario.clone());
        let Responses { tab, nonlinear, .. } = self.view.responses;
        link::write(&self.scenario, &LinkView { page, tab, nonlinear, ghost })
    }

    /// Opens the scene of a link, and says what of it can't be used. Undo goes back to what was on screen before.
    pub fn open(&mut self, link: &str) {
        let Some(opened) = link::read(link, &self.aircraft) else { return };
        if self.computations() > 0 {
            self.history.add_undo(&self.scenario);
        }
        self.ghost = opened.view.ghost.map(|scenario| Ghost { name: name(&scenario), scenario });
        self.scenario = opened.scenario;
        self.view.page = opened.view.page;
        self.view.responses.tab = opened.view.tab;
        self.view.responses.nonlinear = opened.view.nonlinear;
        self.view.before_flight = [None; 2];
        self.share.opened(opened.notices);
    }

    /// Tells the address of the page, which stands before the `#` of a copied link.
    pub fn set_address(&mut self, address: String) {
        self.share.address = address;
    }

    /// A sentence that a screen reader is to say, once.
    pub fn take_unsaid(&mut self) -> Option<String> {
        self.share.take_unsaid()
    }

    /// One frame.
    pub fn ui(&mut self, ui: &mut Ui) {
        // First of all, so that the sliders are drawn where the drag of a pole has brought them.
        let mut hand = self.view.poles.edit(ui, &mut self.scenario, &self.memo, self.view.page);
        if hand == Hand::Takes {
            // A drag is one step, whatever was edited just before it and however long it takes.
            self.history.add_undo(&self.scenario);
            hand = self.view.poles.edit(ui, &mut self.scenario, &self.memo, self.view.page);
        }
        let mut action = keys::command(ui).and_then(|command| self.obey(ui, command));
        let width = ui.content_rect().width();
        let phone = width < PHONE;
        let palette = Palette::of(ui);
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
                        narrow: width < CRAMPED,
                        roomy: width >= TABLET,
                    },
                )
            })
            .inner
            .or(action);
        self.share.notices_ui(ui);
        action = if phone { self.phone_ui(ui) } else { self.desk_ui(ui, width >= TABLET) }.or(action);
        if self.view.help {
            self.view.help = keys::sheet_ui(ui);
        }
        if let Some(action) = action {
            self.apply(action, ui);
            // What it changed beside the scenario, such as a pin, is drawn in the next frame, which no event may bring.
            ui.request_repaint();
        }
        self.share.copied_ui(ui);
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

    /// Does what a key asks for, or says what is to be done last in the frame.
    fn obey(&mut self, ui: &Ui, command: Command) -> Option<Action> {
        match command {
            Command::Undo => return Some(Action::Undo),
            Command::Redo => return Some(Action::Redo),
            Command::Pin => return Some(if self.ghost.is_some() { Action::Unpin } else { Action::Pin }),
            Command::CopyLink => return Some(Action::CopyLink),
            Command::Play => self.view.flight.toggle(),
            Command::Maximise(pane) => {
                self.view.maximised = (self.view.maximised != Some(pane)).then_some(pane);
            }
            Command::Restore => {
                self.view.maximised = None;
                self.view.help = false;
            }
            Command::Look => Look::of(ui.ctx()).next().set(ui.ctx()),
            Command::Help => self.view.help = !self.view.help,
        }
        None
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
            if let Some(pane) = self.view.maximised {
                let room = ui.available_rect_before_wrap();
                self.pane_ui(ui, pane, room);
                return None;
            }
            if wide {
                let room = ui.available_rect_before_wrap();
                let (above, response) = room.split_top_bottom_at_y(room.top() + 0.47 * room.height());
                let (poles, aircraft) = above.split_left_right_at_fraction(0.56);
                let gap = 0.5 * PANE_GAP;
                self.pane_ui(ui, Pane::Poles, inset(poles, [0.0, gap, 0.0, gap]));
                self.pane_ui(ui, Pane::Aircraft, inset(aircraft, [gap, 0.0, 0.0, gap]));
                self.pane_ui(ui, Pane::Response, inset(response, [0.0, 0.0, gap, 0.0]));
                return None;
            }
            ScrollArea::vertical()
                .id_salt("middle")
                .auto_shrink(false)
                .show(ui, |ui| {
                    let action = self.verdicts_ui(ui);
                    let width = ui.available_width();
                    let beside = width >= BESIDE;
                    if beside {
                        let (_, above) = ui.allocate_space(Vec2::new(width, 330.0));
                        let (poles, aircraft) = above.split_left_right_at_fraction(0.5);
                        let gap = 0.5 * PANE_GAP;
                        self.pane_ui(ui, Pane::Poles, inset(poles, [0.0, gap, 0.0, 0.0]));
                        self.pane_ui(ui, Pane::Aircraft, inset(aircraft, [gap, 0.0, 0.0, 0.0]));
                    }
                    let below: &[(Pane, f32)] = if beside {
                        &[(Pane::Response, 480.0)]
                    } else {
                        &[(Pane::Poles, 290.0), (Pane::Response, 560.0), (Pane::Aircraft, 360.0)]
                    };
                    for &(pane, height) in below {
                        let (_, room) = ui.allocate_space(Vec2::new(width, height));
                        self.pane_ui(ui, pane, room);
                    }
                    let count = if beside { 2 } else { 1 };
                    ui.columns(count, |columns| {
                        self.cards_ui(|i| i % count, columns);
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
                    (PhonePane::Aircraft, "Aircraft"),
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
            PhonePane::Aircraft => {
                self.view.flight.toolbar_ui(ui);
                self.aircraft_ui(ui);
                None
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

    /// A pane in its frame over all of `room`; its heading takes it over the whole page by double click or its button.
    fn pane_ui(&mut self, ui: &mut Ui, pane: Pane, room: Rect) {
        // A place of its own: what is put into it moves nothing outside.
        let ui = &mut ui.new_child(UiBuilder::new().id_salt(pane).max_rect(room));
        let frame = theme::pane(Palette::of(ui));
        let inner = room - frame.total_margin();
        // Before what is drawn over it, so that controls on it come first. Not a stop of the Tab key: its button is.
        let heading = Rect::from_min_size(room.min, Vec2::new(room.width(), 34.0));
        let turned = ui.interact(heading, Id::unique(("heading", pane)), Sense::CLICK).double_clicked();
        ui.painter().add(frame.paint(inner));
        ui.scope_builder(UiBuilder::new().max_rect(inner), |ui| {
            ui.set_clip_rect(room.intersect(ui.clip_rect()));
            match pane {
                Pane::Poles => {
                    ui.horizontal(|ui| {
                        theme::heading(ui, RichText::new("Pole map").heading(), 2);
                        self.pole_choices_ui(ui, Rows::Dense);
                    });
                    self.poles_ui(ui);
                }
                Pane::Aircraft => {
                    ui.horizontal(|ui| {
                        theme::heading(ui, RichText::new("Aircraft").heading(), 2);
                        ui.add_space(4.0);
                        self.view.flight.toolbar_ui(ui);
                    });
                    self.aircraft_ui(ui);
                }
                Pane::Response => self.responses_ui(ui, Rows::Dense),
            }
        });
        let maximised = self.view.maximised == Some(pane);
        let corner = Rect::from_min_size(room.right_top() + Vec2::new(-32.0, 5.0), Vec2::splat(24.0));
        let name = format!("{} over the whole page", pane.text());
        let sign = RichText::new(if maximised { "■" } else { "□" }).color(Palette::of(ui).weak);
        let button = ui.put(corner, Button::selectable(false, sign)).accessible_name(&name);
        let hover =
            if maximised { "Back to its place (Esc)".to_owned() } else { format!("{name} ({})", pane.key()) };
        if button.on_hover_text(hover).clicked() || turned {
            self.view.maximised = (!maximised).then_some(pane);
        }
    }

    fn aircraft_ui(&mut self, ui: &mut Ui) {
        let Self { memo, scenario, view, .. } = self;
        memo.refresh(scenario, view.page);
        if view.responses.shows_flight() {
            memo.refresh_flight();
        }
        match memo.motion() {
            Some(motion) => {
                let flight = memo.flight().filter(|_| view.responses.shows_flight());
                let flight = flight
                    .and_then(|flight| flight.as_ref().ok())
                    .filter(|flight| !flight.samples.is_empty());
                let flown = Flown { scenario, motion, flight };
                view.flight.advance(ui, flown.end());
                if let Some(time) = view.responses.hovered() {
                    view.flight.seek(time);
                }
                view.flight.show(ui, flown);
                view.responses.set_time(view.flight.time());
            }
            None => problem_ui(ui, memo.followed(), scenario.plane),
        }
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

    /// Flies a mode alone, long enough to see what becomes of it, or goes back to what was before.
    fn fly(&mut self, index: usize, flown: bool) {
        let plane = self.scenario.plane;
        let length = self.memo.plane().and_then(|plane| Some(seen_in(plane.modes.get(index)?)));
        let disturbance = &mut self.scenario.disturbance;
        let before = &mut self.view.before_flight[plane as usize];
        if flown {
            let standard = Disturbance::default();
            let (choice, time) = before.take().unwrap_or((*standard.choice(plane), standard.sizes.time));
            *disturbance.choice_mut(plane) = choice;
            disturbance.sizes.time = time;
            return;
        }
        let choice = *disturbance.choice(plane);
        if choice.source != Source::OneMode {
            *before = Some((choice, disturbance.sizes.time));
        }
        *disturbance.choice_mut(plane) = Choice { source: Source::OneMode, mode: index, ..choice };
        disturbance.sizes.time = length.unwrap_or(disturbance.sizes.time);
    }

    fn apply(&mut self, action: Action, ui: &Ui) {
        match action {
            Action::Load(aircraft) => self.scenario = self.scenario.with_aircraft(aircraft),
            Action::Turn(plane) => self.scenario.plane = plane,
            Action::Pin => {
                self.ghost = Some(Ghost { name: name(&self.scenario), scenario: self.scenario.clone() })
            }
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
            Action::CopyLink => self.share.copy(ui, &self.link()),
        }
    }
}

/// What a pinned state is called.
fn name(scenario: &Scenario) -> String {
    let edited = if scenario.is_edited() { ", edited" } else { "" };
    format!("{}{edited}", scenario.aircraft.name)
}

/// A rectangle smaller by so much on its left, right, top and bottom.
fn inset(rect: Rect, [left, right, top, bottom]: [f32; 4]) -> Rect {
    Rect::from_min_max(rect.min + Vec2::new(left, top), rect.max - Vec2::new(right, bottom))
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
