//! The whole page under ten thousand random events: it never stops, never shows a number that is none, and undo finds
//! the way back. A character without a glyph is a failure of the harness.

use chacha20::ChaCha8Rng;
use chacha20::rand_core::{Rng as _, SeedableRng as _};
use egui::accesskit::{Action, ActionData, ActionRequest, NodeId, Role, TreeId};
use egui::{
    Event, Key, Modifiers, MouseWheelSource, MouseWheelUnit, PointerButton, Pos2, TouchDeviceId, TouchId,
    TouchPhase, Vec2,
};
use egui_kittest::Harness;
use egui_kittest::kittest::NodeT as _;
use eigenwing::content::embedded_aircraft;
use eigenwing::scenario::{Scenario, parameters};
use eigenwing::ui::App;

/// Events on a page of each size.
const EVENTS: usize = 2_500;
/// After so many events undo goes back to the start: the history keeps a hundred steps.
const EVENTS_A_LEG: usize = 500;
/// The page is read every so many frames.
const FRAMES_A_READING: usize = 8;

/// Of the page's own table, of its controls, and of egui.
const KEYS: [Key; 33] = [
    Key::Z,
    Key::Y,
    Key::Space,
    Key::P,
    Key::A,
    Key::R,
    Key::Escape,
    Key::G,
    Key::L,
    Key::T,
    Key::Questionmark,
    Key::Slash,
    Key::Tab,
    Key::ArrowLeft,
    Key::ArrowRight,
    Key::ArrowUp,
    Key::ArrowDown,
    Key::Home,
    Key::End,
    Key::PageUp,
    Key::PageDown,
    Key::Delete,
    Key::Backspace,
    Key::Enter,
    Key::Plus,
    Key::Minus,
    Key::Equals,
    Key::Num0,
    Key::Num1,
    Key::Comma,
    Key::Period,
    Key::C,
    Key::V,
];

/// What a person might type or paste. Not the very words that the page is searched for.
const TEXTS: [&str; 20] = [
    "0", "1", "7", "-", "−", ".", ",", "e", "E9", "1e308", "-1e308", "1e-320", "nan", "INFINITY", "C_mα",
    "q", "/", "?", " ", "½",
];

const MODIFIERS: [Modifiers; 5] = [
    Modifiers::NONE,
    Modifiers::SHIFT,
    Modifiers::COMMAND,
    Modifiers::ALT,
    Modifiers::COMMAND.plus(Modifiers::SHIFT),
];

const PAGES: [&str; 3] = ["coefficients", "dimensional", "matrix"];
const TABS: [&str; 4] = ["time", "phase", "frequency", "figures"];
/// How the panes are looked at.
const SIGHTS: [&str; 6] = [
    "",
    "&follows=250",
    "&pane=response&split=modes",
    "&camera=-40.12.140&drawn=earth.rates&rate=4&loop=off",
    "&lon.show=nz.x&lat.show=y.v&lon.phase=h.x.u.u&lat.frequency_of=ny",
    "&marks=approximations.levels&details=shape.levels.approximations",
];

/// The same numbers on every machine.
struct Dice(ChaCha8Rng);

impl Dice {
    fn below(&mut self, count: usize) -> usize {
        (self.0.next_u64() % count as u64) as usize
    }

    fn one_in(&mut self, count: usize) -> bool {
        self.below(count) == 0
    }

    fn of<T: Copy>(&mut self, choices: &[T]) -> T {
        choices[self.below(choices.len())]
    }

    /// From −1 to 1.
    fn signed(&mut self) -> f64 {
        (self.0.next_u64() >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    fn offset(&mut self, size: Vec2) -> Vec2 {
        Vec2::new(self.signed() as f32, self.signed() as f32) * size
    }
}

/// What can be aimed at.
#[derive(Clone, Copy, Debug)]
struct Target {
    id: NodeId,
    role: Role,
    middle: Pos2,
}

/// A page and the hands upon it.
struct Visit {
    page: Harness<'static, Option<App>>,
    aircraft: Vec<String>,
    dice: Dice,
    size: Vec2,
    targets: Vec<Target>,
    at: Pos2,
    held: Option<PointerButton>,
    fingers: [bool; 2],
    /// Of egui \[s\].
    time: f64,
    events: usize,
    frames: usize,
    readings: usize,
    edits: usize,
}

impl Visit {
    fn new(size: Vec2, seed: u64) -> Self {
        let page = Harness::builder().with_size(size).build_ui_state(
            |ui, app: &mut Option<App>| {
                app.get_or_insert_with(|| App::new(ui.ctx()).expect("an aircraft")).ui(ui);
            },
            None,
        );
        Self {
            page,
            aircraft: embedded_aircraft().0.into_iter().map(|aircraft| aircraft.key).collect(),
            dice: Dice(ChaCha8Rng::seed_from_u64(seed)),
            size,
            targets: Vec::new(),
            at: Pos2::ZERO,
            held: None,
            fingers: [false; 2],
            time: 100.0,
            events: 0,
            frames: 0,
            readings: 0,
            edits: 0,
        }
    }

    fn scenario(&self) -> &Scenario {
        self.page.state().as_ref().expect("the page has been drawn").scenario()
    }

    fn push(&mut self, event: Event) {
        self.page.input_mut().events.push(event);
        self.events += 1;
    }

    /// Draws a frame with all that has happened since the last.
    fn frame(&mut self, dt: f64) {
        self.time += dt;
        self.page.input_mut().time = Some(self.time);
        self.page.step();
        self.frames += 1;
        if self.frames.is_multiple_of(FRAMES_A_READING) {
            self.read();
        }
    }

    /// Every number and text of the page is one that a person can read.
    fn read(&mut self) {
        let (size, events) = (self.size, self.events);
        let screen = Vec2::new(size.x, size.y);
        self.targets.clear();
        for node in self.page.root().children_recursive() {
            let node = node.accesskit_node();
            let label = node.label().unwrap_or_default();
            let data = node.data();
            // What a person types into a field is theirs.
            let typed = matches!(node.role(), Role::TextInput | Role::TextRun);
            let value = node.value().filter(|_| !typed).unwrap_or_default();
            for text in [&*label, &*value, data.description().unwrap_or_default()] {
                assert!(is_told(text), "{size}, after {events} events: {:?} says {text}", node.role());
            }
            let numbers = [
                data.numeric_value(),
                data.min_numeric_value(),
                data.max_numeric_value(),
                data.numeric_value_step(),
            ];
            for number in numbers.into_iter().flatten() {
                assert!(number.is_finite(), "{size}, after {events} events: {label} is {number}");
            }
            let Some(bounds) = node.bounding_box() else { continue };
            assert!(
                [bounds.x0, bounds.y0, bounds.x1, bounds.y1].into_iter().all(f64::is_finite),
                "{size}, after {events} events: {label} is at {bounds:?}"
            );
            let middle =
                Pos2::new((0.5 * (bounds.x0 + bounds.x1)) as f32, (0.5 * (bounds.y0 + bounds.y1)) as f32);
            let is_control = !matches!(node.role(), Role::TextRun | Role::Label | Role::GenericContainer);
            if is_control && middle.to_vec2().max(Vec2::ZERO).min(screen) == middle.to_vec2() {
                self.targets.push(Target { id: node.locate().0, role: node.role(), middle });
            }
        }
        for parameter in parameters().filter(|p| p.applies(self.scenario())) {
            let value = parameter.get(self.scenario());
            assert!(value.is_finite(), "{size}, after {events} events: {} is {value}", parameter.key);
        }
        self.readings += 1;
    }

    /// Mostly upon something.
    fn aim(&mut self) -> Pos2 {
        let size = self.size;
        if self.targets.is_empty() || self.dice.one_in(4) {
            // A little beyond the window too.
            return (0.5 * size + self.dice.offset(0.52 * size)).to_pos2();
        }
        let i = self.dice.below(self.targets.len());
        self.targets[i].middle + self.dice.offset(Vec2::splat(3.0))
    }

    fn go(&mut self, to: Pos2) {
        self.at = to;
        self.push(Event::PointerMoved(to));
    }

    fn button(&mut self, button: PointerButton, pressed: bool) {
        let modifiers = if self.dice.one_in(12) { self.dice.of(&MODIFIERS) } else { Modifiers::NONE };
        self.push(Event::PointerButton { pos: self.at, button, pressed, modifiers });
        self.held = pressed.then_some(button);
    }

    fn key(&mut self, key: Key, modifiers: Modifiers) {
        for pressed in [true, false] {
            self.push(Event::Key { key, physical_key: None, pressed, repeat: false, modifiers });
        }
    }

    /// A finger as a browser tells of it: the first is the pointer too.
    fn touch(&mut self, finger: usize) {
        let (down, lift) = (self.fingers[finger], self.dice.one_in(3));
        let phase = match (down, lift) {
            (false, _) => TouchPhase::Start,
            (true, false) => TouchPhase::Move,
            (true, true) => self.dice.of(&[TouchPhase::End, TouchPhase::Cancel]),
        };
        let pos = if down { self.at + self.dice.offset(Vec2::splat(80.0)) } else { self.aim() };
        let is_first = finger == 0;
        if is_first {
            self.go(pos);
            if !down || lift {
                self.button(PointerButton::Primary, !down);
            }
        }
        let (device_id, id) = (TouchDeviceId(0), TouchId(finger as u64));
        self.push(Event::Touch { device_id, id, phase, pos, force: None });
        self.fingers[finger] = !(down && lift);
        if is_first && !self.fingers[0] {
            self.push(Event::PointerGone);
        }
    }

    /// What a screen reader asks of something on the page.
    fn ask(&mut self) {
        if self.targets.is_empty() {
            return;
        }
        let target = self.dice.of(&self.targets.clone());
        let number = match self.dice.below(6) {
            0 => f64::NAN,
            1 => self.dice.of(&[f64::INFINITY, f64::NEG_INFINITY, f64::MAX, f64::MIN_POSITIVE, -0.0]),
            _ => self.dice.signed() * 10_f64.powi(self.dice.below(7) as i32 - 3),
        };
        let (action, data) = match (target.role, self.dice.below(4)) {
            (Role::Slider, 0) => (Action::Increment, None),
            (Role::Slider, 1) => (Action::Decrement, None),
            (Role::Slider, _) => (Action::SetValue, Some(ActionData::NumericValue(number))),
            (Role::TextInput, 0..=2) => {
                (Action::SetValue, Some(ActionData::Value(format!("{:e}", number.abs().min(1e9)).into())))
            }
            (_, 0) => (Action::Focus, None),
            _ => (Action::Click, None),
        };
        let request = ActionRequest { action, target_tree: TreeId::ROOT, target_node: target.id, data };
        self.push(Event::AccessKitActionRequest(request));
    }

    /// One thing that a person does.
    fn act(&mut self) {
        match self.dice.below(20) {
            // A click, or two, or a press that is let go later.
            0..=4 => {
                let to = self.aim();
                self.go(to);
                let button =
                    if self.dice.one_in(8) { PointerButton::Secondary } else { PointerButton::Primary };
                let clicks = self.dice.of(&[1, 1, 1, 2]);
                for _ in 0..clicks {
                    self.button(button, true);
                    self.button(button, false);
                }
            }
            5 | 6 => {
                let to = self.aim();
                self.go(to);
                self.button(PointerButton::Primary, true);
            }
            7..=9 => {
                let to = self.at + self.dice.offset(Vec2::splat(120.0));
                self.go(to);
                if let Some(button) = self.held.filter(|_| self.dice.one_in(2)) {
                    self.button(button, false);
                }
            }
            10 | 11 => {
                let key = self.dice.of(&KEYS);
                // Most keys of the page are plain ones.
                let modifiers = if self.dice.one_in(3) { self.dice.of(&MODIFIERS) } else { Modifiers::NONE };
                self.key(key, modifiers);
            }
            12 if self.dice.one_in(4) => {
                let key = self.dice.of(&[Key::Z, Key::Y]);
                self.key(key, Modifiers::COMMAND);
            }
            12 | 13 => {
                let text = self.dice.of(&TEXTS).to_owned();
                let event = if self.dice.one_in(4) { Event::Paste(text) } else { Event::Text(text) };
                self.push(event);
                if self.dice.one_in(2) {
                    self.key(Key::Enter, Modifiers::NONE);
                }
            }
            14 => {
                let modifiers = self.dice.of(&MODIFIERS);
                let delta = self.dice.offset(Vec2::splat(40.0));
                let unit = self.dice.of(&[MouseWheelUnit::Point, MouseWheelUnit::Line, MouseWheelUnit::Page]);
                let (phase, source) = (TouchPhase::Move, MouseWheelSource::Unknown);
                self.push(Event::MouseWheel { unit, delta, phase, source, modifiers });
            }
            15 => {
                let factor = self.dice.of(&[0.5, 0.97, 1.03, 2.0]);
                self.push(Event::Zoom(factor));
            }
            16 | 17 => {
                let finger = usize::from(self.dice.one_in(3));
                self.touch(finger);
            }
            18 => self.ask(),
            _ => {
                let event = self.dice.of(&[0, 1, 2]);
                self.push(match event {
                    0 => Event::PointerGone,
                    1 => Event::WindowFocused(false),
                    _ => Event::WindowFocused(true),
                });
            }
        }
    }

    /// Another aircraft and plane, seen another way.
    fn open_another(&mut self) {
        let i = self.dice.below(self.aircraft.len());
        let plane = self.dice.of(&["lon", "lat"]);
        let (page, tab) = (self.dice.of(&PAGES), self.dice.of(&TABS));
        let flight = self.dice.of(&["linear", "nonlinear"]);
        let seen = self.dice.of(&SIGHTS);
        let link =
            format!("v=1&ac={}&plane={plane}&page={page}&tab={tab}&flight={flight}{seen}", self.aircraft[i]);
        self.page.state_mut().as_mut().expect("the page has been drawn").open(&link);
    }

    /// Hands off, and what was typed is given up.
    fn let_go(&mut self) {
        for finger in 0..2 {
            if std::mem::take(&mut self.fingers[finger]) {
                let (device_id, id, pos) = (TouchDeviceId(0), TouchId(finger as u64), self.at);
                let phase = TouchPhase::End;
                self.page.input_mut().events.push(Event::Touch { device_id, id, phase, pos, force: None });
            }
        }
        if let Some(button) = self.held.take() {
            let (pos, modifiers) = (self.at, Modifiers::NONE);
            let released = Event::PointerButton { pos, button, pressed: false, modifiers };
            self.page.input_mut().events.push(released);
        }
        self.page.input_mut().events.push(Event::WindowFocused(true));
        self.page.input_mut().events.push(Event::PointerGone);
        // A field, a list, a sheet and a maximised pane may be in front, one over the other.
        for _ in 0..4 {
            self.page.key_press(Key::Escape);
            self.frame(0.1);
        }
        self.frame(2.0);
        self.frame(2.0);
    }

    /// A number of events, and all the way back.
    fn leg(&mut self) {
        let start = self.done();
        let end = self.events + EVENTS_A_LEG;
        while self.events < end {
            for _ in 0..=self.dice.below(14) {
                self.act();
            }
            if self.dice.one_in(15) {
                self.open_another();
            }
            let dt = self.dice.of(&[0.02, 0.1, 1.2, 1.2]);
            self.frame(dt);
        }
        self.let_go();
        let size = self.size;
        let mut steps = 0;
        loop {
            let before = (self.scenario().clone(), self.link());
            self.page.key_press_modifiers(Modifiers::COMMAND, Key::Z);
            self.frame(0.1);
            if (self.scenario().clone(), self.link()) == before {
                break;
            }
            steps += 1;
            assert!(steps < 100, "{size}: a leg is to fit into the history");
        }
        self.edits += steps;
        assert!(self.done() == start, "{size}, after {} events: {steps} undone", self.events);
    }

    /// What a person has done to the scenario: a time shown that follows is none of it.
    fn done(&self) -> Scenario {
        let mut scenario = self.scenario().clone();
        if scenario.disturbance.follows {
            scenario.disturbance.sizes.time = 0.0;
        }
        scenario
    }

    /// The whole scene, the pinned state too.
    fn link(&self) -> String {
        self.page.state().as_ref().expect("the page has been drawn").link()
    }
}

/// Whether a text has no number in it that is none, as Rust writes them.
fn is_told(text: &str) -> bool {
    !text.contains('∞')
        && text.split(|c: char| !c.is_alphanumeric()).all(|word| !["NaN", "inf"].contains(&word))
}

#[test]
fn a_number_that_is_none_would_be_found() {
    for text in ["ζ NaN", "T inf s", "σ = −inf", "∞"] {
        assert!(!is_told(text), "{text}");
    }
    for text in ["ζ 0.70 · T 2.42 s", "infinite", "“nan” is not a number"] {
        assert!(is_told(text), "{text}");
    }
}

fn survives(size: Vec2, seed: u64) {
    let mut visit = Visit::new(size, seed);
    visit.read();
    for _ in 0..EVENTS / EVENTS_A_LEG {
        visit.leg();
    }
    let Visit { events, frames, readings, edits, .. } = visit;
    println!("{size}: {events} events in {frames} frames, read {readings} times, {edits} steps undone");
    assert!(events >= EVENTS && readings >= 20 && edits >= 10, "the events reach the page");
}

#[test]
fn a_wide_page_survives_random_events_shows_only_numbers_and_undo_finds_back() {
    survives(Vec2::new(1440.0, 900.0), 1);
}

#[test]
fn a_tablet_page_survives_random_events_shows_only_numbers_and_undo_finds_back() {
    survives(Vec2::new(1024.0, 768.0), 2);
}

#[test]
fn a_phone_page_survives_random_events_shows_only_numbers_and_undo_finds_back() {
    survives(Vec2::new(390.0, 844.0), 3);
}

#[test]
fn the_smallest_page_survives_random_events_shows_only_numbers_and_undo_finds_back() {
    survives(Vec2::new(320.0, 480.0), 4);
}
