//! The application: its state, one frame, and the few things that are not edits of a slider.

mod layout;
mod panes;
mod scene;

use std::sync::Arc;

use egui::util::undoer::Undoer;
use egui::{Context, Frame, Margin, Panel, Ui};

pub use scene::Ghost;
use scene::{Scene, name};

use crate::content::{Aircraft, ContentError, embedded_aircraft};
use crate::flight::aircraft::plane::{ByPlane, Plane};
use crate::flight::analysis::PlaneAnalysis;
use crate::flight::modes::mode_name::ModeName;
use crate::flight::{Analysis, AnalysisError};
use crate::scenario::link::{self, Details, LinkView, Pane, Sight};
use crate::scenario::{Choice, Disturbance, Page, Scenario, Source, seen_in};
use crate::ui::flight_pane::FlightPane;
use crate::ui::influence::Strongest;
use crate::ui::keys::{self, Command};
use crate::ui::memo::Memo;
use crate::ui::poles::{Hand, PoleMap};
use crate::ui::responses::Responses;
use crate::ui::share::Share;
use crate::ui::theme::{self, Look, Palette};
use crate::ui::top_bar::{Bar, top_bar_ui};

/// Below this width the page is a phone's.
const PHONE: f32 = 700.0;
/// Below this width the top bar has two rows, as on a phone.
const CRAMPED: f32 = 860.0;
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
    /// Copy the whole scene as a link.
    CopyLink,
    /// Open the sheet of keys.
    Help,
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
    /// The pane that is alone beside the sliders.
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
    /// Key of a slider to go to.
    asked: Option<&'static str>,
    strongest: Strongest,
    phone_pane: PhonePane,
    details: Details,
    /// The mode that is flown alone: its plane, its place among the modes, and its name.
    held: Option<(Plane, usize, ModeName)>,
    /// What disturbed each plane, and for how long it was watched \[s\], before a mode was flown alone.
    before_flight: ByPlane<Option<(Choice, f64)>>,
}

/// The page.
#[derive(Debug)]
pub struct App {
    aircraft: Vec<Arc<Aircraft>>,
    content_errors: Vec<ContentError>,
    scenario: Scenario,
    ghost: Option<Arc<Ghost>>,
    memo: Memo,
    ghost_memo: Memo,
    history: Undoer<Scene>,
    /// The analysis that the time shown has followed, by its number.
    followed: u64,
    share: Share,
    view: View,
    /// Whether this frame has said why nothing can be shown; once is enough.
    problem_said: bool,
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
            followed: 0,
            share: Share::default(),
            problem_said: false,
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
                asked: None,
                strongest: Strongest::default(),
                phone_pane: PhonePane::default(),
                details: Details::default(),
                held: None,
                before_flight: ByPlane::default(),
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
        let ghost = self.ghost.as_ref().map(|ghost| self.compared(ghost));
        let Responses { tab, nonlinear, .. } = self.view.responses;
        link::write(&self.scenario, &LinkView { page, tab, nonlinear, ghost, sight: self.sight() })
    }

    /// How the scene is looked at, as far as a link carries it.
    fn sight(&self) -> Sight {
        let View { poles, responses, flight, maximised, details, .. } = &self.view;
        let mut sight = Sight {
            marks: poles.choices.marks,
            details: *details,
            maximised: *maximised,
            ..Sight::default()
        };
        responses.sight(&mut sight);
        flight.sight(&mut sight);
        sight
    }

    fn look(&mut self, sight: &Sight) {
        let View { poles, responses, flight, maximised, details, .. } = &mut self.view;
        poles.choices.marks = sight.marks;
        *details = sight.details;
        *maximised = sight.maximised;
        responses.look(sight);
        flight.look(sight);
    }

    /// Opens the scene of a link, and says what of it can't be used. Undo goes back to what was on screen before.
    pub fn open(&mut self, link: &str) {
        let Some(opened) = link::read(link, &self.aircraft) else { return };
        if self.computations() > 0 {
            self.history.add_undo(&self.scene());
        }
        self.ghost = opened.view.ghost.map(|scenario| Arc::new(Ghost { name: name(&scenario), scenario }));
        self.scenario = opened.scenario;
        self.view.page = opened.view.page;
        self.view.responses.tab = opened.view.tab;
        self.view.responses.nonlinear = opened.view.nonlinear;
        self.look(&opened.view.sight);
        self.view.before_flight = ByPlane::default();
        // Before anyone asks for the link: it is to change by what a person does only.
        self.memo.refresh(&self.scenario, self.view.page);
        if let Some(plane) = self.memo.plane() {
            self.scenario.follow(plane);
        }
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
        self.problem_said = false;
        // First of all, so that the sliders are drawn where the drag of a pole has brought them.
        let mut hand = self.view.poles.edit(ui, &mut self.scenario, &self.memo, self.view.page);
        if hand == Hand::Takes {
            // A drag is one step, whatever was edited just before it and however long it takes.
            self.history.add_undo(&self.scene());
            hand = self.view.poles.edit(ui, &mut self.scenario, &self.memo, self.view.page);
        }
        if ui.input(|input| input.pointer.any_pressed()) {
            // What was edited just before a drag is a step of its own.
            self.history.add_undo(&self.scene());
        }
        let mut action = keys::command(ui).and_then(|command| self.obey(ui, command));
        let width = ui.content_rect().width();
        let phone = width < PHONE;
        if theme::make_room(ui.ctx(), phone) {
            ui.request_discard("controls are of another height from now on");
        }
        let palette = Palette::of(ui);
        let scene = self.scene();
        let bar = Frame::new().fill(palette.pane).inner_margin(Margin::symmetric(14, 8));
        action = Panel::top("top bar")
            .frame(bar)
            .show(ui, |ui| {
                top_bar_ui(
                    ui,
                    Bar {
                        aircraft: &self.aircraft,
                        scenario: &self.scenario,
                        ghost: self.ghost.as_deref(),
                        history: (self.history.has_undo(&scene), self.history.has_redo(&scene)),
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
        self.follow(ui);
        self.hold_mode();
        if !self.memo.is_of(&self.scenario, self.view.page) {
            // Something drawn after a view has edited the scenario: draw this frame again before it is shown.
            ui.request_discard("the scenario changed");
        }
        let (is_held, is_let_go) = ui.input(|input| (input.pointer.any_down(), input.pointer.any_released()));
        match hand {
            _ if is_let_go => self.keep(ui),
            Hand::LetsGo => self.keep(ui),
            Hand::Takes | Hand::Holds => {}
            // However long a slider is held still, its drag isn't over.
            Hand::Away if is_held => {}
            Hand::Away => self.history.feed_state(ui.input(|input| input.time), &self.scene()),
        }
    }

    /// What a person has done, as it stands.
    fn scene(&self) -> Scene {
        Scene { scenario: self.scenario.clone(), ghost: self.ghost.clone() }
    }

    /// Makes a step of undo of the scene as it stands. What was undone before it can't be done again.
    fn keep(&mut self, ui: &Ui) {
        let scene = self.scene();
        self.history.feed_state(ui.input(|input| input.time), &scene);
        self.history.add_undo(&scene);
    }

    fn restore(&mut self, scene: Option<Scene>) {
        if let Some(Scene { scenario, ghost }) = scene {
            (self.scenario, self.ghost) = (scenario, ghost);
        }
    }

    /// Lets the time shown follow the motion, never while something is dragged; the axes ease to it.
    fn follow(&mut self, ui: &Ui) {
        let analysed = self.memo.computations();
        let is_known = self.followed == analysed || !self.memo.is_of(&self.scenario, self.view.page);
        if is_known || ui.input(|input| input.pointer.any_down()) {
            return;
        }
        self.followed = analysed;
        if let Some(plane) = self.memo.plane() {
            self.scenario.follow(plane);
        }
    }

    /// Keeps flying the mode that is flown alone where another has come before it in the order of the modes.
    fn hold_mode(&mut self) {
        let plane = self.scenario.plane;
        let choice = self.scenario.disturbance.choices[plane];
        let Some(analysed) = self.memo.plane().filter(|_| choice.source == Source::OneMode) else {
            self.view.held = None;
            return;
        };
        let name = |index: usize| analysed.modes.get(index).map(|mode| mode.naming.name);
        let moved_to = match self.view.held {
            Some((of, index, held)) if (of, index) == (plane, choice.mode) && name(index) != Some(held) => {
                analysed.modes.iter().position(|mode| mode.naming.name == held)
            }
            _ => None,
        };
        let index = moved_to.unwrap_or(choice.mode);
        self.view.held = name(index).map(|name| (plane, index, name));
        self.scenario.disturbance.choices[plane].mode = index;
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

    /// Flies a mode alone, long enough to see what becomes of it, or goes back to what was before.
    fn fly(&mut self, index: usize, flown: bool) {
        let plane = self.scenario.plane;
        let length = self.memo.plane().and_then(|plane| Some(seen_in(plane.modes.get(index)?)));
        let disturbance = &mut self.scenario.disturbance;
        let before = &mut self.view.before_flight[plane];
        if flown {
            let standard = Disturbance::default();
            let (choice, time) = before.unwrap_or((standard.choices[plane], standard.sizes.time));
            disturbance.choices[plane] = choice;
            disturbance.sizes.time = time;
            self.view.flight.pause();
            return;
        }
        let choice = disturbance.choices[plane];
        if choice.source != Source::OneMode {
            *before = Some((choice, disturbance.sizes.time));
        }
        disturbance.choices[plane] = Choice { source: Source::OneMode, mode: index, ..choice };
        disturbance.sizes.time = length.unwrap_or(disturbance.sizes.time);
        self.view.flight.start();
        // On a phone the aircraft is on another page than the card.
        self.view.phone_pane = PhonePane::Aircraft;
    }

    fn apply(&mut self, action: Action, ui: &Ui) {
        // Whatever was edited just before it is a step of its own.
        let before = self.scene();
        match action {
            Action::Undo => {
                let undone = self.history.undo(&before).cloned();
                return self.restore(undone);
            }
            Action::Redo => {
                let redone = self.history.redo(&before).cloned();
                return self.restore(redone);
            }
            Action::CopyLink => return self.share.copy(ui, &self.link()),
            Action::Help => {
                self.view.help = true;
                return;
            }
            Action::Load(aircraft) => self.scenario = self.scenario.with_aircraft(aircraft),
            Action::Turn(plane) => self.scenario.plane = plane,
            Action::Pin => {
                self.ghost =
                    Some(Arc::new(Ghost { name: name(&before.scenario), scenario: before.scenario.clone() }))
            }
            Action::CompareWith(aircraft) => {
                let name = aircraft.name.clone();
                self.ghost = Some(Arc::new(Ghost { name, scenario: self.scenario.with_aircraft(aircraft) }));
            }
            Action::Unpin => self.ghost = None,
        }
        self.history.add_undo(&before);
        self.keep(ui);
    }
}
