//! The whole scene as text for an address bar: `v=1&ac=navion&speed=60&cm_alpha=-0.5`.
//!
//! One codec serves the address bar, the copied link and the last session. Its keys are listed in `docs/LINKS.md`.
//!
//! * One vocabulary with requests of the command line and of JavaScript: the words that are written are their keys. Others that
//!   were published are read.
//! * Only what differs is written: from the aircraft's file, and from the first disturbance a person sees.
//! * A key is a parameter's key of the table, or a word of [`words`]; its meaning and its unit never change. The unit is the one
//!   on screen, with lengths in metres.
//! * `add.` before the key of a derivative or matrix entry is what is added to the value that follows from the rest, so the order
//!   of a link doesn't matter. Without it the key sets the value itself, after everything else: for links written by hand.
//! * `pin.` before a key belongs to the pinned state, whose disturbance is always that of the scene.
//! * `own=` is the aircraft itself, where it is none of those that ship: see [`own`].
//! * Reading is total. What can't be used is left out, and a [`Notice`] says so.

mod handed_in;
mod lesson_place;
mod notice;
mod number;
pub mod own;
mod pieces;
mod view;
mod words;

use std::sync::Arc;

pub use handed_in::HandedIn;
pub use lesson_place::LessonPlace;
pub use notice::Notice;
pub use pieces::LONGEST;

use super::{Choice, Notation, Parameter, Scenario, Source, Units, View, parameters};
use crate::content::{Aircraft, LengthUnit};
use crate::flight::aircraft::plane::Plane;
use crate::flight::feedback::analyse_loop;
use crate::flight::modes::mode_name::ModeName;
use crate::flight::verdicts::mil_f_8785c::{Category, Class};
use crate::flight::verdicts::task::Task;
use crate::key::Keyed;
use pieces::Pieces;

/// The version that is written. It rises when a link of this kind can't be understood any more by what came before.
const VERSION: u32 = 1;

/// The scene that a link leads to.
#[derive(Clone, Debug, PartialEq)]
pub struct Opened {
    /// The scenario that is studied.
    pub scenario: Scenario,
    /// The units that the link names, if it names any.
    pub units: Option<Units>,
    /// The notation that it names, likewise.
    pub notation: Option<Notation>,
    /// The state pinned beside it; its disturbance and plane are those of the scene.
    pub pinned: Option<Scenario>,
    /// How it is looked at.
    pub view: View,
    /// The lesson that is open beside it.
    pub lesson: Option<LessonPlace>,
    /// Whose work it is, if it was handed in.
    pub handed_in: Option<HandedIn>,
    /// The parts that were left out, and why.
    pub notices: Vec<Notice>,
}

/// The scene as a link, without the `#`.
pub fn write(scenario: &Scenario, view: &View, pinned: Option<&Scenario>) -> String {
    let mut pieces = vec![("v".to_owned(), VERSION.to_string())];
    write_own(scenario, "", &mut pieces);
    write_aircraft(scenario, "", &mut pieces);
    if scenario.plane != Plane::Longitudinal {
        pieces.push(("plane".to_owned(), scenario.plane.in_links()));
    }
    write_disturbance(scenario, &mut pieces);
    if scenario.units != Units::default() {
        pieces.push((words::UNITS.to_owned(), scenario.units.in_links()));
    }
    if scenario.notation != Notation::default() {
        pieces.push((words::NOTATION.to_owned(), scenario.notation.in_links()));
    }
    pieces.extend(view.write(scenario));
    if let Some(pinned) = pinned {
        if *pinned.aircraft != *scenario.aircraft {
            write_own(pinned, words::PINNED, &mut pieces);
        }
        write_aircraft(pinned, words::PINNED, &mut pieces);
    }
    joined(pieces)
}

/// The aircraft itself, where it is none of those that ship. It stands before its key, so that no link ends in a hyphen.
fn write_own(scenario: &Scenario, prefix: &str, pieces: &mut Vec<(String, String)>) {
    if let Some(packed) = own::written(&scenario.aircraft) {
        pieces.push((format!("{prefix}{}", words::OWN), packed));
    }
}

/// The aircraft and what was done to it.
fn write_aircraft(scenario: &Scenario, prefix: &str, pieces: &mut Vec<(String, String)>) {
    pieces.push((format!("{prefix}ac"), scenario.aircraft.key.clone()));
    write_edits(scenario, prefix, pieces);
}

fn write_edits(scenario: &Scenario, prefix: &str, pieces: &mut Vec<(String, String)>) {
    let reference = Scenario::new(scenario.aircraft.clone());
    for p in parameters().filter(|p| !p.is_of_disturbance()) {
        let (key, value, usual) = match p.added(scenario) {
            Some(offset) => (format!("{prefix}{}{}", words::ADDED, p.key), offset, 0.0),
            None => (format!("{prefix}{}", p.key), p.get(scenario), p.get(&reference)),
        };
        if value != usual {
            pieces.push((key, number::write(value, unit(p))));
        }
    }
    write_task(scenario, prefix, pieces);
}

/// The task that levels are judged for, where it differs from that of the aircraft's file.
fn write_task(scenario: &Scenario, prefix: &str, pieces: &mut Vec<(String, String)>) {
    let (Some(task), usual) = (scenario.task, scenario.aircraft.task) else { return };
    if usual.is_none_or(|usual| usual.class != task.class) {
        pieces.push((format!("{prefix}{}", words::CLASS), task.class.in_links()));
    }
    if usual.is_none_or(|usual| usual.category != task.category) {
        pieces.push((format!("{prefix}{}", words::CATEGORY), task.category.in_links()));
    }
}

fn write_disturbance(scenario: &Scenario, pieces: &mut Vec<(String, String)>) {
    let reference = Scenario::new(scenario.aircraft.clone());
    for plane in Plane::ALL {
        let (choice, usual) = (scenario.disturbance.choices[plane], reference.disturbance.choices[plane]);
        let mut differing = |key, differs: bool, word: String| {
            if differs {
                pieces.push((format!("{}.{key}", plane.short()), word));
            }
        };
        let Choice { source, control_shape, gust_shape, mode } = choice;
        differing("source", source != usual.source, source.in_links());
        differing("shape", control_shape != usual.control_shape, control_shape.in_links());
        differing("gust", gust_shape != usual.gust_shape, gust_shape.in_links());
        differing("mode", mode != usual.mode, (mode + 1).to_string());
    }
    let disturbance = &scenario.disturbance;
    for p in parameters().filter(|p| p.is_of_disturbance()) {
        let is_time = p.key == words::TIME;
        // A time that stays is always told: without a word it follows.
        let stays = is_time && !disturbance.follows;
        if p.get(scenario) != p.get(&reference) || stays {
            let key = if is_time && disturbance.follows { words::FOLLOWS } else { p.key };
            pieces.push((key.to_owned(), number::write(p.get(scenario), unit(p))));
        }
    }
}

/// What was done to an aircraft, in the words and units of a link: `cg=16&cm_alpha=-0.5`.
pub fn edits(scenario: &Scenario) -> String {
    let mut pieces = Vec::new();
    write_edits(scenario, "", &mut pieces);
    joined(pieces)
}

/// Does to an aircraft what [`edits`] tells; what can't be used is told.
pub fn edit(scenario: &mut Scenario, edits: &str) -> Vec<Notice> {
    let mut pieces = Pieces::split(edits);
    read_edits(&mut pieces, "", scenario);
    pieces.finish()
}

fn joined(pieces: Vec<(String, String)>) -> String {
    let pieces: Vec<String> = pieces.into_iter().map(|(key, value)| format!("{key}={value}")).collect();
    pieces.join("&")
}

/// One of a key's unit in SI: that on screen, but never in feet, so that it is the same for every aircraft.
fn unit(parameter: &Parameter) -> f64 {
    parameter.dimension.in_si(LengthUnit::Metre)
}

/// Whether text is a link, or an address with one: it says its version or its aircraft.
pub fn is_link(text: &str) -> bool {
    let link = text.split_once('#').map_or(text, |(_, link)| link).trim();
    link.split('&').any(|piece| ["v=", "ac=", "own="].iter().any(|start| piece.starts_with(start)))
}

/// Opens a link, with or without its `#` and what stands before that; `None` only without a single aircraft.
pub fn read(link: &str, aircraft: &[Arc<Aircraft>]) -> Option<Opened> {
    let mut pieces = Pieces::split(link);
    let handed_in = HandedIn::read(&mut pieces);
    let lesson = LessonPlace::read(&mut pieces);
    read_version(&mut pieces);
    let mut scenario = Scenario::new(aircraft.first()?.clone());
    let (own, key) = (pieces.take(words::OWN), pieces.take("ac"));
    let listed = |key: &String| aircraft.iter().find(|aircraft| aircraft.key == *key).cloned();
    let instead = scenario.aircraft.name.clone();
    // Numbers of one aircraft make no sense on another: where it isn't there, its edits are left out.
    let found = match (own.map(|packed| own::read(&packed)), key) {
        (Some(Ok(own)), _) => Ok(Arc::new(own)),
        (Some(Err(problem)), _) => Err(Notice::Own { problem, instead }),
        (None, None) => Ok(scenario.aircraft.clone()),
        (None, Some(key)) => {
            let told = || Notice::Aircraft { key: notice::quoted(&key), instead, edited: false };
            listed(&key).ok_or_else(told)
        }
    };
    match found {
        Ok(found) => {
            scenario = Scenario::new(found);
            read_edits(&mut pieces, "", &mut scenario);
        }
        Err(mut told) => {
            let any = take_edits(&mut pieces, "");
            if let Notice::Aircraft { edited, .. } = &mut told {
                *edited = any;
            }
            pieces.notices.push(told);
        }
    }
    read_plane(&mut pieces, &mut scenario);
    read_disturbance(&mut pieces, &mut scenario);
    let units = pieces.take_as(words::UNITS, Units::by_key);
    scenario.units = units.unwrap_or_default();
    let notation = pieces.take_as(words::NOTATION, Notation::by_key);
    scenario.notation = notation.unwrap_or_default();
    let pinned = read_pinned(&mut pieces, &scenario, aircraft);
    let view = View::read(&mut pieces, &scenario);
    Some(Opened { scenario, units, notation, pinned, view, lesson, handed_in, notices: pieces.finish() })
}

fn read_version(pieces: &mut Pieces) {
    let Some(version) = pieces.take("v") else { return };
    match version.parse::<u32>() {
        Ok(VERSION) => {}
        Ok(newer) if newer > VERSION => pieces.notices.push(Notice::Newer),
        Ok(_) | Err(_) => pieces.notices.push(Notice::Version { text: notice::quoted(&version) }),
    }
}

/// What was done to the aircraft: first what is free, then what is added to the rest, then values of the rest.
fn read_edits(pieces: &mut Pieces, prefix: &str, scenario: &mut Scenario) {
    read_task(pieces, prefix, scenario);
    let reference = Scenario::new(scenario.aircraft.clone());
    let of_aircraft = |p: &&Parameter| !p.is_of_disturbance();
    for p in parameters().filter(of_aircraft) {
        let key = match p.added(scenario) {
            Some(_) => format!("{prefix}{}{}", words::ADDED, p.key),
            None => format!("{prefix}{}", p.key),
        };
        let Some(text) = pieces.take(&key) else { continue };
        if !p.applies(&reference) {
            pieces.notices.push(Notice::not_of(p, &scenario.aircraft));
        } else if p.added(scenario).is_some() {
            let accepted = number::read(&text, unit(p)).and_then(|x| p.check_added(scenario, x));
            if let Some(value) = pieces.accept(&key, p, accepted) {
                p.set_added(scenario, value);
            }
        } else {
            let accepted = number::read(&text, unit(p)).and_then(|x| p.check(scenario, x));
            if let Some(value) = pieces.accept(&key, p, accepted) {
                p.set(scenario, value);
            }
        }
    }
    for p in parameters().filter(of_aircraft).filter(|p| p.added(&reference).is_some()) {
        let key = format!("{prefix}{}", p.key);
        let Some(text) = pieces.take(&key) else { continue };
        if !p.applies(&reference) {
            pieces.notices.push(Notice::not_of(p, &scenario.aircraft));
        } else if !p.applies(scenario) {
            pieces.notices.push(Notice::NoFlight { name: p.name });
        } else {
            let accepted = number::read(&text, unit(p)).and_then(|x| p.check(scenario, x));
            if let Some(value) = pieces.accept(&key, p, accepted) {
                p.set(scenario, value);
            }
        }
    }
}

/// The task that levels are judged for. One word alone stands beside what the aircraft's file says, or what is judged at first.
fn read_task(pieces: &mut Pieces, prefix: &str, scenario: &mut Scenario) {
    let class = pieces.take_as(&format!("{prefix}{}", words::CLASS), Class::by_key);
    let category = pieces.take_as(&format!("{prefix}{}", words::CATEGORY), Category::by_key);
    if class.is_some() || category.is_some() {
        let Task { class: usual_class, category: usual_category } = scenario.task.unwrap_or_default();
        scenario.task =
            Some(Task { class: class.unwrap_or(usual_class), category: category.unwrap_or(usual_category) });
    }
}

/// Takes every edit of an aircraft out of the link; whether there were any.
fn take_edits(pieces: &mut Pieces, prefix: &str) -> bool {
    let mut any = false;
    for key in [words::CLASS, words::CATEGORY] {
        any |= pieces.take(&format!("{prefix}{key}")).is_some();
    }
    for p in parameters().filter(|p| !p.is_of_disturbance()) {
        any |= pieces.take(&format!("{prefix}{}", p.key)).is_some();
        any |= pieces.take(&format!("{prefix}{}{}", words::ADDED, p.key)).is_some();
    }
    any
}

fn read_plane(pieces: &mut Pieces, scenario: &mut Scenario) {
    let Some(plane) = pieces.take_as("plane", Plane::by_key) else { return };
    if scenario.aircraft.plane_notes[plane].is_some() {
        scenario.plane = plane;
    } else {
        pieces.notices.push(Notice::Plane { aircraft: scenario.aircraft.name.clone() });
    }
}

fn read_disturbance(pieces: &mut Pieces, scenario: &mut Scenario) {
    for plane in Plane::ALL {
        let key = |word| format!("{}.{word}", plane.short());
        let source = pieces.take_as(&key("source"), |word| one_of(Source::of(plane), word));
        let shape = pieces.take_as(&key("shape"), |word| one_of(Source::Elevator.shapes(), word));
        let gust = pieces.take_as(&key("gust"), |word| one_of(Source::VerticalGust.shapes(), word));
        let mode = pieces.take_as(&key("mode"), |word| mode_of(scenario, plane, word));
        let choice = &mut scenario.disturbance.choices[plane];
        choice.source = source.unwrap_or(choice.source);
        choice.control_shape = shape.unwrap_or(choice.control_shape);
        choice.gust_shape = gust.unwrap_or(choice.gust_shape);
        choice.mode = mode.unwrap_or(choice.mode);
    }
    if let Some(time) = Parameter::find(words::TIME)
        && let Some(value) = read_number(pieces, words::FOLLOWS, time, scenario)
    {
        time.set(scenario, value);
        scenario.disturbance.follows = true;
    }
    for p in parameters().filter(|p| p.is_of_disturbance()) {
        if let Some(value) = read_number(pieces, p.key, p, scenario) {
            p.set(scenario, value);
        }
    }
}

/// The place of a mode in the order of the modes: by its number, counted from one, or by its key or name.
fn mode_of(scenario: &Scenario, plane: Plane, word: &str) -> Option<usize> {
    let place = words::place_of_mode(word);
    if place.is_some_and(|place| place < 4) {
        return place;
    }
    let law = &scenario.law;
    let analysis = scenario.analyse().ok()?;
    let open = analysis.planes[plane].as_ref()?.as_ref().ok()?;
    let names: Vec<ModeName> = if law.is_open(plane) && open.model.further.is_none() {
        open.modes.iter().map(|mode| mode.naming.name).collect()
    } else {
        let closed = analyse_loop(&open.model, law, None).ok()?;
        closed.modes.iter().map(|mode| mode.mode.naming.name).collect()
    };
    place.filter(|place| *place < names.len()).or_else(|| {
        let wanted = ModeName::by_key(word)?;
        names.iter().position(|name| *name == wanted)
    })
}

/// The value of a key in a list, where it is one of `fitting`.
fn one_of<T: Keyed>(fitting: &[T], word: &str) -> Option<T> {
    T::by_key(word).filter(|value| fitting.contains(value))
}

/// The number of a key, where there is one that the parameter accepts \[SI\].
fn read_number(pieces: &mut Pieces, key: &str, p: &Parameter, scenario: &Scenario) -> Option<f64> {
    let text = pieces.take(key)?;
    let accepted = number::read(&text, unit(p)).and_then(|x| p.check(scenario, x));
    pieces.accept(key, p, accepted)
}

fn read_pinned(pieces: &mut Pieces, scene: &Scenario, aircraft: &[Arc<Aircraft>]) -> Option<Scenario> {
    if !pieces.has_prefix(words::PINNED) {
        return None;
    }
    let own = pieces.take(&format!("{}{}", words::PINNED, words::OWN));
    let key = pieces.take(&format!("{}ac", words::PINNED));
    let pinned = match (own.map(|packed| own::read(&packed)), &key) {
        (Some(own), _) => own.ok().map(Arc::new),
        (None, None) => Some(scene.aircraft.clone()),
        (None, Some(key)) if *key == scene.aircraft.key => Some(scene.aircraft.clone()),
        (None, Some(key)) => aircraft.iter().find(|aircraft| aircraft.key == *key).cloned(),
    };
    let Some(pinned) = pinned else {
        take_edits(pieces, words::PINNED);
        pieces.notices.push(Notice::Pinned { key: notice::quoted(key.as_deref().unwrap_or_default()) });
        return None;
    };
    let mut pinned = Scenario::new(pinned);
    read_edits(pieces, words::PINNED, &mut pinned);
    Some(Scenario { disturbance: scene.disturbance, plane: scene.plane, ..pinned }.shown_as(scene))
}
