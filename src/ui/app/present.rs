//! The lecture: what a presenter's keys do to the scene, and the slide on the screen.

use std::collections::BTreeMap;
use std::sync::Arc;

use egui::accesskit::{Live, Role};
use egui::{
    Align2, Button, CentralPanel, Event, Frame, Id, Key, Rect, RichText, Sense, Ui, UiBuilder, Vec2,
    WidgetInfo,
};

use super::course::LessonPane;
use super::{App, Pinned};
use crate::key::Keyed as _;
use crate::lesson::said;
use crate::lesson::{Kind, Part as PartOfStep, Record};
use crate::number::trimmed;
use crate::scenario::view::{Instant, Tab};
use crate::scenario::{Parameter, Part, Scenario, Source, View, Written};
use crate::ui::curtain::Curtain;
use crate::ui::derivatives::Rows;
use crate::ui::present::{
    self, Arranged, Asked, Content, Measured, Plots, Presentation, Pressed, Stroke, Told, arranged, blank_ui,
    magnify, modes_ui, offered, panes, pieces, places, sliders_height, sliders_ui, spotlight_ui, strokes,
};
use crate::ui::theme::{self, Palette};
use crate::words;

/// Around a slide \[points\].
const MARGIN: f32 = 16.0;
/// Size of its title, of one that is long, and of the words above a response.
const TITLE: [f32; 2] = [22.0, 18.0];
const CAPTION: f32 = 14.0;
/// Size of the clock.
const CLOCK: f32 = 13.0;
/// Room for the way back to the workbench, and how near the pointer is when it comes into sight.
const LEAVE: f32 = 26.0;
const NEAR: f32 = 70.0;
/// A press is a finger's that was on the screen so shortly before \[s\].
const TAP: f64 = 1.0;
/// Thickness of the line that tells how far the lecture is.
const LINE: f32 = 2.0;

/// A lecture, and what of the page belongs to it.
#[derive(Debug)]
pub(super) struct Lecture {
    shown: Presentation,
    /// Whether it is on the screen.
    is_on: bool,
    /// Slides as they were left.
    left: BTreeMap<usize, Left>,
    /// What the model says, by slide and question, once it was needed.
    truths: BTreeMap<(usize, usize), Option<String>>,
    /// What the person had done in the lesson before.
    record: Option<Record>,
    /// Size of everything before.
    zoom: f32,
    /// Whether the notes are asked for.
    wants_notes: bool,
    /// When a finger was last on the screen \[s\].
    touched: f64,
}

/// A slide as it was left.
#[derive(Debug)]
struct Left {
    scenario: Scenario,
    pinned: Option<Arc<Pinned>>,
    view: View,
    instant: Instant,
}

impl App {
    /// The lecture, while the scene fills the screen.
    pub fn presentation(&self) -> Option<&Presentation> {
        self.panes.lecture.as_ref().filter(|_| self.view.presents).map(|lecture| &lecture.shown)
    }

    /// Whether the notes of the lecture were asked for since this was last called.
    pub fn take_notes_wish(&mut self) -> bool {
        self.panes.lecture.as_mut().is_some_and(|lecture| std::mem::take(&mut lecture.wants_notes))
    }

    /// Goes on with a lecture that was on the screen before the page was loaded again, and began so long ago \[s\]. Says whether one is on
    /// the screen.
    pub fn take_up_lecture(&mut self, kept: &str, age: f64) -> bool {
        if self.view.presents {
            self.panes.kept_lecture = Some((kept.to_owned(), age));
        }
        self.view.presents
    }

    /// Begins or ends the lecture, brings it to the step of the lesson that is open, and does what the keys of the presenter ask for.
    pub(super) fn attend_presentation(&mut self, ui: &Ui) {
        if !self.view.presents {
            return self.leave_presentation(ui);
        }
        let (address, slide, count) = match self.session() {
            Some(session) => (session.address().to_owned(), session.place().step, session.steps().len()),
            None => (String::new(), 0, 1),
        };
        let (started, zoom) = (ui.input(|input| input.time), ui.zoom_factor());
        let record = self.session().map(|session| session.record().clone());
        let begins = |lecture: &Lecture| lecture.shown.address != address;
        if self.panes.lecture.as_ref().is_none_or(begins) {
            let is_on = self.panes.lecture.as_ref().is_some_and(|lecture| lecture.is_on);
            let zoom = self.panes.lecture.as_ref().filter(|_| is_on).map_or(zoom, |lecture| lecture.zoom);
            let mut shown = Presentation { address, started, ..Presentation::default() };
            if let Some((kept, age)) = &self.panes.kept_lecture
                && let (address, slides) = Presentation::slides_of(kept)
                && address == shown.address
            {
                (shown.slides, shown.started) = (slides, started - age);
                self.panes.kept_lecture = None;
            }
            let (left, truths) = Default::default();
            let lecture = Lecture {
                shown,
                is_on,
                left,
                truths,
                record: None,
                zoom,
                wants_notes: false,
                touched: f64::NEG_INFINITY,
            };
            self.panes.lecture = Some(Lecture { record: record.clone(), ..lecture });
        }
        let Some(lecture) = &mut self.panes.lecture else { return };
        (lecture.shown.slide, lecture.shown.count) = (slide, count);
        if !lecture.is_on {
            (lecture.is_on, lecture.zoom, lecture.record) = (true, zoom, record);
            theme::present(ui.ctx(), true);
            self.panes.touched = None;
            self.announce();
        }
        let is_blank = self.presentation().is_some_and(|lecture| lecture.is_blank);
        let is_covered = self.panes.help || self.panes.lessons || self.panes.source || self.panes.references;
        for stroke in strokes(ui, (is_blank, is_covered)) {
            self.strike(ui, stroke);
        }
        magnify(ui, self.presentation().and_then(|lecture| lecture.magnified));
    }

    /// Back to the workbench, if the lecture is on the screen; what was done on its slides is there when it goes on.
    fn leave_presentation(&mut self, ui: &Ui) {
        let is_revealed = self.is_shown_revealed();
        let Some(lecture) = self.panes.lecture.as_mut().filter(|lecture| lecture.is_on) else { return };
        lecture.is_on = false;
        lecture.shown.magnified = None;
        lecture.shown.is_blank = false;
        // What the room has seen needs no answer any more.
        self.view.stage = lecture.shown.stage(&self.view.stage, is_revealed);
        theme::present(ui.ctx(), false);
        ui.ctx().set_zoom_factor(lecture.zoom);
        if let (Some(record), LessonPane::Open(session)) = (lecture.record.take(), &mut self.panes.lesson) {
            session.forget(record);
            // With what was done in another tab meanwhile.
            self.join_lesson(&self.records.clone());
        }
        magnify(ui, None);
        ui.request_discard("the workbench is of another size");
    }

    /// Makes the screen as high as a slide.
    pub(super) fn fit_screen(&mut self, ui: &Ui) {
        let zoom = present::zoom(ui);
        if (zoom / ui.zoom_factor() - 1.0).abs() > 1e-3 {
            ui.ctx().set_zoom_factor(zoom);
            ui.request_discard("the screen is of another size");
        }
    }

    /// How many times the slide on screen has something to reveal: its questions, or what a scene alone hides.
    fn reveals(&self) -> usize {
        match self.session().and_then(|session| session.step()) {
            Some(step) => step.predictions().count(),
            None => usize::from(!self.view.stage.hidden().is_empty()),
        }
    }

    /// Whether all of the slide on screen has been revealed.
    pub(super) fn is_shown_revealed(&self) -> bool {
        let revealed = self.panes.lecture.as_ref().map_or(0, |lecture| lecture.shown.revealed());
        (1..=revealed).contains(&self.reveals())
    }

    /// Does what a key of the presenter asks for.
    fn strike(&mut self, ui: &Ui, stroke: Stroke) {
        let reveals = self.reveals();
        let is_revealed = self.is_shown_revealed();
        let question = self.question();
        let Some(lecture) = &mut self.panes.lecture else { return };
        let shown = &mut lecture.shown;
        match stroke {
            Stroke::Next if shown.revealed() < reveals => {
                let slide = shown.current_mut();
                (slide.revealed, slide.veil) = (slide.revealed + 1, None);
                self.show_answer(question.map_or(0, |asked| asked.question));
            }
            Stroke::Next => {
                let next = shown.slide + 1;
                self.turn_to(next);
            }
            Stroke::Back => {
                let before = shown.slide.saturating_sub(1);
                self.turn_to(before);
            }
            Stroke::First => self.turn_to(0),
            Stroke::Last => {
                let last = shown.count.saturating_sub(1);
                self.turn_to(last);
            }
            Stroke::Blank => shown.is_blank = !shown.is_blank,
            Stroke::Veil => shown.turn_veil(&self.view.stage, is_revealed),
            Stroke::Magnify => {
                let at = ui.input(|input| input.pointer.latest_pos()).unwrap_or(ui.content_rect().center());
                shown.magnified = if shown.magnified.is_some() { None } else { Some(at) };
            }
            Stroke::Play => self.panes.flight.toggle(),
            Stroke::Reasons => {
                let reasons = &mut shown.current_mut().reasons;
                let all = 0..present::MOST_CHOICES;
                if reasons.is_empty() { reasons.extend(all) } else { reasons.clear() }
            }
            Stroke::Hand { choice, adds } => {
                shown.count_hand(question.map_or(0, |asked| asked.question), choice, adds);
            }
            Stroke::NoHands => {
                shown.current_mut().hands.remove(&question.map_or(0, |asked| asked.question));
            }
            Stroke::Clock => shown.shows_clock = !shown.shows_clock,
            Stroke::Again => self.open_again(),
            Stroke::Notes => lecture.wants_notes = true,
            Stroke::Leave if shown.magnified.is_some() => shown.magnified = None,
            Stroke::Leave => {
                self.view.presents = false;
                self.leave_presentation(ui);
            }
        }
        ui.request_repaint();
    }

    /// The question that the slide on screen is at.
    fn question(&self) -> Option<Asked> {
        let revealed = self.panes.lecture.as_ref().map_or(0, |lecture| lecture.shown.revealed());
        Asked::of(self.session()?.step()?, revealed)
    }

    /// Goes to another slide, which is as it was left, or as its file has it.
    fn turn_to(&mut self, slide: usize) {
        let instant = self.panes.flight.instant();
        let LessonPane::Open(session) = &mut self.panes.lesson else { return };
        let Some(lecture) = &mut self.panes.lecture else { return };
        if slide == lecture.shown.slide || slide >= lecture.shown.count {
            return;
        }
        let left = Left {
            scenario: self.scenario.clone(),
            pinned: self.pinned.clone(),
            view: self.view.clone(),
            instant,
        };
        lecture.left.insert(lecture.shown.slide, left);
        lecture.shown.slide = slide;
        lecture.shown.magnified = None;
        session.go_to(slide, &self.aircraft);
        match lecture.left.remove(&slide) {
            Some(Left { scenario, pinned, view, instant }) => {
                self.scenario = scenario;
                self.pinned = pinned;
                self.view = View { presents: true, ..view };
                self.panes.flight.begin(instant);
                self.panes.flight.keep_overlays();
                self.panes.locked = None;
                self.refresh();
            }
            None => {
                self.open_step();
                // What was answered before the page was loaded again.
                let revealed = self.panes.lecture.as_ref().map_or(0, |lecture| lecture.shown.revealed());
                (0..revealed).for_each(|question| self.show_answer(question));
            }
        }
        self.panes.touched = None;
        self.announce();
    }

    /// The scene of the slide as its file has it; of a scene alone, all numbers at their references.
    fn open_again(&mut self) {
        if self.session().is_some() {
            self.open_step();
        } else {
            self.panes.flight.begin(Instant::default());
        }
    }

    /// Has a screen reader say the title of the slide.
    fn announce(&mut self) {
        if let Some(title) = self.session().and_then(|session| Some(session.step()?.title.clone())) {
            self.share.say(title);
        }
    }

    /// Shows the scene that has the answer to a question, beside what was on screen before; none where that has it.
    fn show_answer(&mut self, question: usize) {
        let step = self.session().and_then(|session| session.step());
        let asked = step.and_then(|step| step.predictions().nth(question));
        let opened =
            asked.and_then(|asked| asked.after.as_ref()).and_then(|scene| scene.open(&self.aircraft));
        if let Some(opened) = opened {
            let before = opened.pinned.unwrap_or_else(|| self.scenario.clone());
            self.pinned = Some(Arc::new(Pinned::new(before)));
            self.scenario = opened.scenario;
            self.panes.locked = None;
            self.refresh();
        }
    }

    /// What the model says to the question of the slide, and which goals are met.
    fn told(&mut self) -> Told {
        let asked = self.question();
        let (Some(session), Some(lecture)) = (
            match &self.panes.lesson {
                LessonPane::Open(session) => Some(session),
                _ => None,
            },
            &mut self.panes.lecture,
        ) else {
            return Told::default();
        };
        let Some(step) = session.step() else { return Told::default() };
        let met =
            step.tasks().map(|task| task.is_met(session.start(), &self.findings, &self.aircraft)).collect();
        let Some(Asked { question, .. }) = asked else { return Told { truth: None, met } };
        let truth = lecture.truths.entry((lecture.shown.slide, question)).or_insert_with(|| {
            let prediction = step.predictions().nth(question)?;
            if matches!(prediction.kind, Kind::Choose { .. }) {
                return None;
            }
            let truth = prediction.truth(session.start(), &self.aircraft)?;
            let convention = session.start().scenario().convention();
            Some(said::truth(prediction, &truth, convention))
        });
        Told { truth: truth.clone(), met }
    }

    /// The slide over all of the screen.
    pub(super) fn present_ui(&mut self, ui: &mut Ui) {
        self.refresh();
        self.hang_curtain(ui);
        let ground = Frame::new().fill(Palette::of(ui).pane);
        CentralPanel::default().frame(ground).show(ui, |ui| {
            if self.presentation().is_some_and(|lecture| lecture.is_blank) {
                blank_ui(ui);
                self.go_on_unseen_at_all(ui);
                return;
            }
            let whole = ui.max_rect();
            let room = whole.shrink2(Vec2::new(MARGIN, 0.0)).with_max_y(whole.bottom() - LINE - 8.0);
            let top = self.title_ui(ui, room.with_min_y(room.top() + 10.0));
            self.progress_ui(ui, whole);
            let by_touch = self.slide_ui(ui, room.with_min_y(top + 8.0));
            let leaves = leave_ui(ui, whole).then_some(Stroke::Leave);
            if let Some(stroke) = leaves.or(by_touch) {
                self.strike(ui, stroke);
            }
            if ui.input(|input| input.key_down(Key::S)) && !ui.text_edit_focused() {
                spotlight_ui(ui);
            }
        });
    }

    /// What goes on while nothing of it is on screen.
    fn go_on_unseen_at_all(&mut self, ui: &Ui) {
        self.panes.responses.leave();
        self.play(ui);
    }

    /// The heading of the slide, and the clock; gives the height down to which it reaches.
    fn title_ui(&self, ui: &Ui, room: Rect) -> f32 {
        let palette = Palette::of(ui);
        let clock = self.clock(ui).map(|text| {
            ui.painter().text(
                room.right_top() + Vec2::new(-LEAVE, 5.0),
                Align2::RIGHT_TOP,
                text,
                egui::FontId::proportional(CLOCK),
                palette.weak,
            )
        });
        let title = match self.session().and_then(|session| session.step()) {
            Some(step) => step.title.clone(),
            None => {
                let aircraft = &self.scenario.aircraft;
                let name = Curtain::of(ui).aircraft(&aircraft.name).to_owned();
                if name == aircraft.name { format!("{name} · {}", aircraft.condition) } else { name }
            }
        };
        let width = room.width() - LEAVE - clock.map_or(0.0, |clock| clock.width() + MARGIN);
        let set = |size: f32| ui.painter().layout(title.clone(), theme::semibold(size), palette.text, width);
        let galley =
            Some(set(TITLE[0])).filter(|galley| galley.rows.len() == 1).unwrap_or_else(|| set(TITLE[1]));
        let place = Rect::from_min_size(room.min, galley.size());
        ui.painter().galley(room.min, galley, palette.text);
        let response = ui.interact(place, Id::unique("title of a slide"), Sense::hover());
        response.widget_info(|| WidgetInfo::labeled(Role::Label, true, title.as_str()));
        ui.ctx().accesskit_node_builder(response.id, |node| {
            node.set_role(Role::Heading);
            node.set_level(1);
            node.set_live(Live::Polite);
        });
        place.bottom()
    }

    /// The minutes since the start, where they are on screen.
    fn clock(&self, ui: &Ui) -> Option<String> {
        let lecture = self.presentation().filter(|lecture| lecture.shows_clock)?;
        let minutes = ((ui.input(|input| input.time) - lecture.started) / 60.0).max(0.0);
        ui.request_repaint_after_secs((60.0 * (1.0 - minutes.fract())) as f32 + 0.1);
        Some(format!("{} min", minutes.floor()))
    }

    /// A line at the foot: how far the lecture is.
    fn progress_ui(&self, ui: &Ui, whole: Rect) {
        let Some(Presentation { slide, count, .. }) = self.presentation() else { return };
        if *count > 1 {
            let share = (slide + 1) as f32 / *count as f32;
            let line = whole.with_min_y(whole.bottom() - LINE);
            let palette = Palette::of(ui);
            ui.painter().rect_filled(line, 0.0, palette.hairline);
            ui.painter().rect_filled(
                line.with_max_x(whole.left() + share * whole.width()),
                0.0,
                palette.accent,
            );
        }
    }

    /// Words, sliders and panes. Gives what a finger at the edge asks for.
    fn slide_ui(&mut self, ui: &mut Ui, room: Rect) -> Option<Stroke> {
        let told = self.told();
        let staged = panes(&self.view);
        let asked = self.question();
        let waits = asked.is_some_and(|asked| !asked.is_answered);
        let has_task = self
            .session()
            .and_then(|session| session.step())
            .is_some_and(|step| step.parts.iter().any(|part| matches!(part, PartOfStep::Task(_))));
        let sliders = if waits && has_task { Vec::new() } else { offered(&self.view.stage, &self.scenario) };
        let plots = self.plots();
        let content = Content { panes: &staged, plots, sliders: sliders.len(), asks: asked.is_some() };
        let arranged = self.arranged(ui, room, content, &told);
        let Arranged { words, at, scene } = arranged;
        let pressed = words.show(ui, at.min);
        let mut held = Rect::NOTHING;
        if let Some(scene) = scene {
            let (scene, below) =
                scene.split_top_bottom_at_y(scene.bottom() - sliders_height(sliders.len(), scene.width()));
            if !sliders.is_empty() {
                held = below;
                self.panes.touched = sliders_ui(ui, below, &sliders, &mut self.scenario);
                self.hold_locked();
                self.refresh();
                self.hang_curtain(ui);
            }
            for (part, place) in places(&staged, scene, plots) {
                self.staged_ui(ui, part, place);
            }
        }
        if !staged.contains(&Part::Response) || scene.is_none() {
            self.panes.responses.leave();
        }
        if !staged.contains(&Part::Aircraft) || scene.is_none() {
            self.play(ui);
        }
        let by_touch = self.tapped(ui, held);
        match pressed {
            Some(Pressed::Scene(link)) => self.open_scene(&link),
            Some(Pressed::Choice(choice)) => self.press_choice(choice, waits),
            None => return by_touch,
        }
        ui.request_repaint();
        None
    }

    /// The small plots of the response, as many as there are with room for all.
    fn plots(&self) -> Plots {
        let response = &self.view.response;
        let motion = self.findings.motion();
        let moves = motion.is_some_and(|motion| !motion.experiment.inputs.is_empty());
        let has_end = motion.is_some_and(|motion| motion.small_until.is_some());
        // Each of the others as high as two.
        let of_time = response.shown[self.scenario.plane].len() + usize::from(moves);
        let count = if response.tab == Tab::Time { of_time } else { 2 };
        Plots { count, has_legend: self.pinned.is_some(), has_end }
    }

    /// Words and panes where they have room.
    fn arranged(&self, ui: &Ui, room: Rect, content: Content<'_>, told: &Told) -> Arranged {
        let step = self.session().and_then(|session| session.step());
        let start = self.session().map_or(&*self.findings, |session| session.start());
        let measured = Measured { start, aircraft: &self.aircraft };
        let asked = self.question();
        let answered = asked.map(|asked| Asked { is_answered: true, ..asked });
        let at = |asked: Option<Asked>, level: usize| match (step, self.presentation()) {
            (Some(step), Some(lecture)) => pieces(step, lecture, (asked, told), level),
            _ => Vec::new(),
        };
        arranged(ui, room, content, |level| at(asked, level), |level| at(answered, level), measured)
    }

    /// A choice that is pressed has one hand more; once it is answered it tells why it is wrong, or no longer.
    fn press_choice(&mut self, choice: usize, waits: bool) {
        let question = self.question().map_or(0, |asked| asked.question);
        let Some(lecture) = &mut self.panes.lecture else { return };
        if waits {
            return lecture.shown.count_hand(question, choice, true);
        }
        let reasons = &mut lecture.shown.current_mut().reasons;
        if !reasons.remove(&choice) {
            reasons.insert(choice);
        }
    }

    /// A pane with what it shows and nothing else.
    fn staged_ui(&mut self, ui: &mut Ui, part: Part, place: Rect) {
        let builder = UiBuilder::new().id_salt(("presented", part.key())).max_rect(place);
        let ui = &mut ui.new_child(builder);
        // A unit stands behind the last number of an axis.
        ui.set_clip_rect(place.expand2(Vec2::new(0.7 * MARGIN, 3.0)).intersect(ui.clip_rect()));
        match part {
            Part::Poles => self.poles_ui(ui),
            Part::Aircraft => self.aircraft_ui(ui),
            Part::Equations => self.equations_ui(ui),
            Part::Modes => {
                let findings = self.shown_ui(ui);
                modes_ui(ui, &findings);
            }
            Part::Response => {
                let caption = self.caption(ui);
                ui.label(RichText::new(caption).font(theme::semibold(CAPTION)));
                self.motion_ui(ui, Rows::Dense);
            }
            Part::Derivatives => {}
        }
    }

    /// What the motion is a response to.
    fn caption(&self, ui: &Ui) -> String {
        let plane = self.scenario.plane;
        let choice = self.scenario.disturbance.choices[plane];
        if choice.source == Source::OneMode {
            let modes = self.findings.flown_modes();
            let mode = modes.get(choice.mode.min(modes.len().saturating_sub(1)));
            return mode.map_or_else(String::new, |mode| {
                format!("{} alone", Curtain::of(ui).title(mode.naming.name))
            });
        }
        let size = choice.parameters(plane).into_iter().next().and_then(Parameter::find).map(|parameter| {
            let Written { unit, in_si, .. } = parameter.written(self.scenario.convention());
            format!(", {} {unit}", trimmed(parameter.get(&self.scenario) / in_si, 3))
        });
        format!("{}{}", words::disturbance::choice(&choice), size.unwrap_or_default().trim_end())
    }

    /// What a finger asks for that has tapped: in the left third the slide before, in the right third the next, between them to play. Not
    /// on what it works.
    fn tapped(&mut self, ui: &Ui, held: Rect) -> Option<Stroke> {
        let lecture = self.panes.lecture.as_mut()?;
        let (now, at) = ui.input(|input| {
            if input.events.iter().any(|event| matches!(event, Event::Touch { .. })) {
                lecture.touched = input.time;
            }
            (input.time, input.pointer.interact_pos().filter(|_| input.pointer.primary_clicked()))
        });
        let at = at.filter(|at| now - lecture.touched < TAP && !held.contains(*at))?;
        Some(match at.x / ui.content_rect().width() {
            share if share < 1.0 / 3.0 => Stroke::Back,
            share if share > 2.0 / 3.0 => Stroke::Next,
            _ => Stroke::Play,
        })
    }
}

/// The way back to the workbench for fingers and mice, in the corner; in sight only where it is wanted. Says whether it is pressed.
fn leave_ui(ui: &mut Ui, whole: Rect) -> bool {
    let corner = whole.right_top();
    let (by_finger, pointer) = ui.input(|input| (input.has_touch_screen(), input.pointer.hover_pos()));
    if !by_finger && pointer.is_none_or(|at| at.distance(corner) > NEAR) {
        return false;
    }
    let place = Rect::from_min_size(corner + Vec2::new(-LEAVE - 6.0, 6.0), Vec2::splat(LEAVE));
    let sign = RichText::new("✕").size(CAPTION).color(Palette::of(ui).weak);
    let button = ui.put(place, Button::new(sign).frame(false));
    button.accessible_name("Back to the workbench").on_hover_text("Back to the workbench (Esc)").clicked()
}
