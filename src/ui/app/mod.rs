//! The application: its state, one frame, and the few things that are not edits of a slider.

mod actions;
mod core_module;
mod course;
mod events;
mod frame;
mod greeting;
mod history;
mod import;
mod layout;
mod lecture;
mod lesson;
mod panes;
mod pinned;
mod present;
mod records;
mod spoken;
mod staged;
mod take_along;

use std::rc::Rc;
use std::sync::Arc;

use egui::{Context, Frame, Margin, Panel, Ui};

pub use actions::Action;
pub use core_module::{CoreRequest, OwnFile};
pub use course::FileRequest;
pub use pinned::Pinned;

use self::course::{CourseState, LessonPane};
use self::events::Events;
use self::history::{History, Scene};
use self::present::Lecture;
use self::spoken::Verdict;
use self::staged::Held;

use crate::content::{Aircraft, ContentError, TextFile, embedded_aircraft};
use crate::findings::Findings;
use crate::flight::aircraft::plane::{ByPlane, Plane};
use crate::flight::modes::mode_name::ModeName;
use crate::lesson::Records;
use crate::scenario::link::{self, Notice};
use crate::scenario::{Choice, Hidden, Scenario, Source, View};
use crate::ui::curtain::Curtain;
use crate::ui::embed::Embedding;
use crate::ui::equations::EquationsPane;
use crate::ui::feedback::LeastGainSaid;
use crate::ui::flight_pane::FlightPane;
use crate::ui::import::Importing;
use crate::ui::influence::Strongest;
use crate::ui::keys;
use crate::ui::poles::{DragPhase, PoleMap};
use crate::ui::present::Deck;
use crate::ui::responses::Responses;
use crate::ui::room;
use crate::ui::share::{Offer, Share};
use crate::ui::source_sheet::source_sheet_ui;
use crate::ui::take_along::TakeAlong;
use crate::ui::theme::{self, Look, Palette};
use crate::ui::top_bar::{Bar, top_bar_ui};
use crate::ui::why::Why;
use crate::words;

/// Below this width the page is a phone's.
const PHONE: f32 = 700.0;
/// Below this width the top bar has two rows, as on a phone.
const CRAMPED: f32 = 860.0;
/// Below this width the modes stand under the responses, not beside them.
const TABLET: f32 = 1180.0;

/// From this width the top bar has room for the less common tools.
const AMPLE: f32 = 1320.0;

/// The panes of a phone, of which one is on screen below the pole map.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum PhonePane {
    /// The step of a lesson that is open.
    Lesson,
    #[default]
    Derivatives,
    /// The pole map, where there is no room to have it above all panes.
    Poles,
    Modes,
    Response,
    Aircraft,
    Equations,
}

/// The panes as they are at the moment: what nobody wants to find again, or send to others.
#[derive(Debug, Default)]
struct Panes {
    poles: PoleMap,
    responses: Responses,
    flight: FlightPane,
    equations: EquationsPane,
    /// Whether the sheet of keys is open.
    help: bool,
    /// Whether the sheet of lessons is open.
    lessons: bool,
    /// The sheet that makes a frame of the scene, where it is open.
    embed: Option<Embedding>,
    /// The sheet that takes the scene along, where it is open.
    take_along: Option<TakeAlong>,
    /// How often something was taken along.
    times_taken: u64,
    /// A text that is to be copied in the next frame.
    copied: Option<String>,
    /// The sheet of a person's own aircraft, where it is open.
    import: Option<Importing>,
    /// How many questions about files have been asked.
    files_asked: u64,
    /// What the core as a module is to be asked.
    core_requests: Vec<CoreRequest>,
    /// Whether the sheet of references is open.
    references: bool,
    course: CourseState,
    lesson: LessonPane,
    /// Files that are to be read for the page.
    file_requests: Vec<FileRequest>,
    /// Whether files can be chosen and saved.
    has_files: bool,
    /// Whether figures can become pictures, and pages be printed.
    has_pictures: bool,
    /// Whether the line for a first visit is on screen.
    greets: bool,
    /// Whether the sheet of the aircraft's source is open.
    source: bool,
    /// What the sliders are narrowed down to.
    search: String,
    /// Key of the slider that the help card speaks of.
    explained: &'static str,
    /// Key of the slider that the person is at, whose path is drawn.
    touched: Option<&'static str>,
    /// Key of a slider to go to.
    asked: Option<&'static str>,
    strongest: Strongest,
    /// What came of the last search for a least gain.
    least_gain: Option<LeastGainSaid>,
    why: Why,
    phone_pane: PhonePane,
    /// The mode that is flown alone: its plane, its place among the modes, and its name.
    held: Option<(Plane, usize, ModeName)>,
    /// What disturbed each plane, for how long it was watched \[s\], and how fast it was played, before a mode was flown alone.
    before_flight: ByPlane<Option<(Choice, f64, f64)>>,
    /// What is locked, as it was when the frame began; nothing where another scene has been opened since.
    locked: Option<Held>,
    /// The lecture, while there is one.
    lecture: Option<Lecture>,
    /// The verdict that was last on screen.
    verdict: Option<Verdict>,
    /// What was done in the lecture before the page was loaded again, and how long ago it began \[s\].
    kept_lecture: Option<(String, f64)>,
    /// The lecture that is being made of links.
    deck: Option<Deck>,
    /// Whether the page stands in a frame of another page.
    is_framed: bool,
    /// The look that the link of the scene has put in force.
    lent: Option<Look>,
    /// Height of the bar and of what stands above the panes \[points\].
    above: f32,
    /// The size of type that is in force.
    type_size: Option<f32>,
    /// Whether this frame has said why nothing can be shown; once is enough.
    problem_said: bool,
}

/// The page.
#[derive(Debug)]
pub struct App {
    aircraft: Vec<Arc<Aircraft>>,
    content_errors: Vec<ContentError>,
    /// What is studied.
    scenario: Scenario,
    /// The state that is pinned beside it.
    pinned: Option<Arc<Pinned>>,
    /// How a person looks at them.
    view: View,
    /// What follows from the scenario, as it was when [`App::refresh`] last came by.
    findings: Rc<Findings>,
    /// The last of them from which something followed, shown where nothing follows any more.
    last_good: Rc<Findings>,
    /// What follows from the pinned state, put through the same disturbance.
    pinned_findings: Option<Rc<Findings>>,
    /// How often anything was found anew, so that tests can see that nothing is computed twice.
    computations: u64,
    history: History,
    share: Share,
    panes: Panes,
    /// What the person has done in their lessons.
    records: Records,
    /// Whether they have changed since they were last taken.
    records_changed: bool,
    /// Files of a person's own aircraft that are kept on this device.
    own_files: Vec<TextFile>,
    /// Whether they have changed since they were last taken.
    own_files_changed: bool,
    events: Events,
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
        let mut scenario = Scenario::new(first.clone());
        // The stick comes back, so that the first thing to be seen is a climb. A link without a word of it has the opposite.
        scenario.disturbance.sizes.elevator = -scenario.disturbance.sizes.elevator;
        let findings = Rc::new(Findings::of(scenario.clone()));
        Ok(Self {
            aircraft,
            content_errors,
            view: View::of(&scenario),
            last_good: findings.clone(),
            findings,
            scenario,
            pinned: None,
            pinned_findings: None,
            computations: 0,
            history: History::default(),
            share: Share::default(),
            panes: Panes { explained: "cm_alpha", ..Panes::default() },
            records: Records::default(),
            records_changed: false,
            own_files: Vec::new(),
            own_files_changed: false,
            events: Events::default(),
        })
    }

    /// What is studied.
    pub fn scenario(&self) -> &Scenario {
        &self.scenario
    }

    /// What followed from it in the last frame.
    pub fn findings(&self) -> &Findings {
        &self.findings
    }

    /// How often anything was found anew.
    pub fn computations(&self) -> u64 {
        self.computations
    }

    /// The whole scene as a link, without the `#`.
    pub fn link(&self) -> String {
        self.link_with(&self.view, true)
    }

    /// The same with the instant at which the playback is: what a person sends on. The address bar leaves it out, since it changes in
    /// every frame.
    pub fn link_with_instant(&self) -> String {
        let mut view = self.view.clone();
        view.flight.instant = self.panes.flight.instant();
        self.link_with(&view, false)
    }

    /// The scene as a link, with the lesson that is open; one that is on this device only where the link stays here.
    fn link_with(&self, view: &View, stays: bool) -> String {
        let place = self.lesson_place(stays).map(|place| place.in_link()).unwrap_or_default();
        self.link_of_scene(view) + &place
    }

    fn link_of_scene(&self, view: &View) -> String {
        let pinned = self.pinned.as_ref().map(|pinned| &pinned.scenario);
        link::write(&self.scenario, view, pinned)
    }

    /// Opens the scene of a link, and says what of it can't be used. Undo goes back to what was on screen before.
    pub fn open(&mut self, link: &str) {
        let Some(opened) = link::read(link, &self.aircraft) else { return };
        if self.findings.is_analysed() {
            self.history.end_step(&self.scene());
        }
        self.pinned = opened.pinned.map(|scenario| Arc::new(Pinned::new(scenario)));
        // Who reads feet goes on reading feet.
        let units = opened.units.unwrap_or(self.scenario.units);
        let notation = opened.notation.unwrap_or(self.scenario.notation);
        self.scenario = Scenario { units, notation, ..opened.scenario };
        self.view = opened.view;
        self.go_to_equations();
        // From here on it is that of the playback.
        self.panes.flight.begin(std::mem::take(&mut self.view.flight.instant));
        self.panes.responses.leave();
        self.panes.flight.keep_overlays();
        self.panes.before_flight = ByPlane::default();
        // Before anyone asks for the link: it is to change by what a person does only.
        self.refresh();
        self.scenario.disturbance.sizes.time = self.findings.time_shown();
        self.panes.locked = None;
        let hides_name = self.view.stage.hides(Hidden::AircraftName);
        let told =
            |notice: Notice| if hides_name { notice.unnamed(words::view::AN_AIRCRAFT) } else { notice };
        if let Some(place) = opened.lesson {
            self.want_lesson(place);
        }
        self.share.opened(opened.notices.into_iter().map(told).collect());
    }

    /// Tells the address of the page, which stands before the `#` of a copied link.
    pub fn set_address(&mut self, address: String) {
        self.share.address = address;
    }

    /// A sentence that a screen reader is to say, once.
    pub fn take_unsaid(&mut self) -> Option<String> {
        self.share.take_unsaid()
    }

    /// One frame: what hand and keys do, the sliders, everything that follows from them, and in the end what was asked for.
    pub fn ui(&mut self, ui: &mut Ui) {
        self.panes.problem_said = false;
        self.attend_lesson(ui);
        self.attend_presentation(ui);
        self.fit_type(ui);
        self.fit_look(ui);
        room::begin(ui.ctx());
        self.hang_curtain(ui);
        self.take_hold();
        // First of all, so that the sliders are drawn where the drag of a pole has brought them.
        let hand = self.drag_pole(ui);
        let by_key = keys::command(ui).and_then(|command| self.obey(ui, command));
        self.hold_locked();

        let width = ui.content_rect().width();
        let (phone, wide) = (width < PHONE && !self.view.presents, width >= TABLET);
        if theme::make_room(ui.ctx(), phone) {
            ui.request_discard("controls are of another height from now on");
        }
        let asked = if self.view.presents {
            self.present_ui(ui);
            None
        } else {
            self.workbench_ui(ui, width, (phone, wide))
        };
        self.hold_locked();
        self.lessons_ui(ui);
        self.deck_ui(ui);
        self.embed_ui(ui);
        self.take_along_ui(ui);
        let by_import = self.import_ui(ui);
        if self.panes.help {
            let (help, wish) = keys::sheet_ui(ui, &mut self.scenario);
            self.panes.help = help;
            self.follow_wish(ui, wish);
            self.hold_locked();
        }
        if self.panes.source && !Curtain::of(ui).hides_source() {
            let is_edited = self.scenario.is_edited();
            self.panes.source = source_sheet_ui(ui, &self.scenario.aircraft, is_edited);
        }

        if let Some(action) = asked.or(by_key).or(by_import) {
            self.apply(action, ui);
            self.hold_locked();
            // What it changed beside the scenario, such as a pin, is drawn in the next frame, which no event may bring.
            ui.request_repaint();
        }
        self.copy_by_key(ui);
        match self.share.word_ui(ui) {
            Some(Offer::Embed) => self.panes.embed = Some(self.embedding()),
            Some(Offer::TakeAlong) => self.open_take_along(ui),
            None => {}
        }
        self.follow(ui);
        self.hold_mode();
        if !self.is_found() {
            // Something drawn after a view has edited the scenario: draw this frame again before it is shown.
            ui.request_discard("the scenario changed");
        }
        self.history.settle(ui, hand, &self.scene());
        self.keep_record(ui);
        self.say_verdict(ui);
        self.note_events(ui);
    }

    /// The bar, the sliders and the panes. Gives what was asked for in them.
    fn workbench_ui(&mut self, ui: &mut Ui, width: f32, (phone, wide): (bool, bool)) -> Option<Action> {
        let by_bar = self.top_bar_ui(ui, width);
        self.share.notices_ui(ui);
        self.greeting_ui(ui);
        self.panes.above = ui.content_rect().height() - ui.available_height();
        self.refresh();
        self.hang_curtain(ui);
        if !phone && self.has_sliders() {
            self.sliders_ui(ui, wide);
            self.hold_locked();
            // Everything else is drawn as the sliders are now.
            self.refresh();
            self.hang_curtain(ui);
        }
        let by_pane = if phone { self.phone_ui(ui) } else { self.desk_ui(ui, wide) };
        by_pane.or(by_bar)
    }

    /// Moves a pole that is dragged or moved by key.
    fn drag_pole(&mut self, ui: &Ui) -> DragPhase {
        let edit = |app: &mut Self| app.panes.poles.edit(ui, &mut app.scenario, &app.findings, app.view.page);
        let hand = edit(self);
        if hand == DragPhase::Takes || ui.input(|input| input.pointer.any_pressed()) {
            // A drag is one step, whatever was edited just before it and however long it takes.
            self.history.end_step(&self.scene());
        }
        if hand == DragPhase::Takes { edit(self) } else { hand }
    }

    fn top_bar_ui(&self, ui: &mut Ui, width: f32) -> Option<Action> {
        let scene = self.scene();
        let bar = Bar {
            aircraft: &self.aircraft,
            scenario: &self.scenario,
            pinned: self.pinned.as_deref(),
            history: (self.history.has_undo(&scene), self.history.has_redo(&scene)),
            kept: self.is_kept(),
            narrow: width < CRAMPED,
            roomy: width >= TABLET,
            ample: width >= AMPLE,
        };
        let frame = Frame::new().fill(Palette::of(ui).pane).inner_margin(Margin::symmetric(14, 8));
        let contents = |ui: &mut Ui| {
            theme::landmark(ui, "Page bar");
            top_bar_ui(ui, bar)
        };
        Panel::top("top bar").frame(frame).show(ui, contents).inner
    }

    /// What a person has done, as it stands.
    fn scene(&self) -> Scene {
        Scene { scenario: self.scenario.clone(), pinned: self.pinned.clone() }
    }

    /// Whether the findings are of the scenario as it is, and as it is shown.
    fn is_found(&self) -> bool {
        *self.findings.scenario() == self.scenario && self.findings.is_opened() == self.view.shows_open
    }

    /// Takes new findings where the scenario or the pinned state is another: the only place that does.
    fn refresh(&mut self) {
        if !self.is_found() {
            let findings = self.findings.after(self.scenario.clone()).opened(self.view.shows_open);
            self.findings = Rc::new(findings);
            self.computations += 1;
        }
        if self.findings.plane().is_some() {
            self.last_good = self.findings.clone();
        }
        let Some(pinned) = &self.pinned else {
            self.pinned_findings = None;
            return;
        };
        let disturbed = self.as_disturbed(pinned);
        if self.pinned_findings.as_ref().is_none_or(|findings| *findings.scenario() != disturbed) {
            self.pinned_findings = Some(Rc::new(Findings::of(disturbed)));
            self.computations += 1;
        }
    }

    /// What the panes draw: what follows from the scenario, or where nothing does, what followed last from the same aircraft in the
    /// same plane; and whether it is that.
    fn shown(&self) -> (Rc<Findings>, bool) {
        let of = self.last_good.scenario();
        let (aircraft, plane) = (&self.scenario.aircraft, self.scenario.plane);
        let is_of_this =
            of.plane == plane && of.aircraft.key == aircraft.key && self.last_good.plane().is_some();
        if self.findings.plane().is_none() && is_of_this {
            (self.last_good.clone(), true)
        } else {
            (self.findings.clone(), false)
        }
    }

    /// A pinned state put through the disturbance of the scene; of one mode alone through the mode of the same name, whatever its
    /// place among the others.
    fn as_disturbed(&self, pinned: &Pinned) -> Scenario {
        let Scenario { disturbance, plane, .. } = self.scenario;
        let mut disturbed =
            Scenario { disturbance, plane, ..pinned.scenario.clone() }.shown_as(&self.scenario);
        let choice = disturbance.choices[plane];
        let flown = self.findings.flown_modes().get(choice.mode).filter(|_| choice.source == Source::OneMode);
        if let Some(flown) = flown {
            let is_known = |findings: &&Rc<Findings>| {
                let Scenario { edited, law, plane: of, .. } = findings.scenario();
                (edited, law, *of) == (&disturbed.edited, &disturbed.law, plane)
            };
            let known = self.pinned_findings.as_ref().filter(is_known).cloned();
            let known = known.unwrap_or_else(|| Rc::new(Findings::of(disturbed.clone())));
            let place = known.flown_modes().iter().position(|mode| mode.naming.name == flown.naming.name);
            disturbed.disturbance.choices[plane].mode = place.unwrap_or(choice.mode);
        }
        disturbed
    }

    /// Lets the time shown follow the motion, never while something is dragged; the axes ease to it.
    fn follow(&mut self, ui: &Ui) {
        let is_known = *self.findings.scenario() == self.scenario;
        if is_known && !ui.input(|input| input.pointer.any_down()) {
            self.scenario.disturbance.sizes.time = self.findings.time_shown();
        }
    }
}
