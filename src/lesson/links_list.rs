//! A lecture out of a list of links, one a line, as a person pastes it. It is written as the text of a lesson and read like any other.

use std::sync::Arc;

use super::links_line::{Line, Row};
use super::moves::moves;
use crate::content::Aircraft;
use crate::findings::Findings;
use crate::scenario::link::{self, Opened};
use crate::scenario::{Hidden, Scenario, Source};
use crate::words;

/// Slides that a lecture has at most; what comes after them is left out.
const MOST: usize = 200;

/// A lecture out of links.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LinksList {
    /// Its title; empty where the list has none.
    pub title: String,
    /// Its slides, in order.
    pub slides: Vec<LinkSlide>,
    /// What of the list can't be used, each a sentence.
    pub left_out: Vec<String>,
}

/// One link of the list.
#[derive(Clone, Debug, PartialEq)]
pub struct LinkSlide {
    /// Its heading.
    pub title: String,
    /// Its scene, with the `#`.
    pub link: String,
    /// How long it is to take \[min\].
    pub minutes: Option<f64>,
    /// What the list says of it besides: lines of plain text.
    pub notes: Vec<String>,
    /// What of the link can't be used, each a sentence.
    pub faults: Vec<String>,
}

/// Words of a link that make no scene: they would lead out of the lecture.
const NOT_OF_SLIDES: [&str; 3] = ["lesson", "step", "present"];

impl LinksList {
    /// Reads a list; an error is a sentence that says why there is no lecture in it.
    ///
    /// A line has a link, with or without an address before its `#`, and if it likes a heading before or after it: `Title: https://…#v=1…`,
    /// `[Title](#v=1…)`, the cells of a table. Minutes stand in brackets, `(3 min)`, or in a cell of their own; numbers alone that begin with
    /// zero and rise are the minutes at which slides begin. A line without a link is the heading of the bare link in the next line, the title
    /// of the lecture where it comes first, or else a note.
    pub fn read(text: &str, aircraft: &[Arc<Aircraft>]) -> Result<Self, String> {
        let mut list = Self::default();
        let mut begins: Vec<Option<f64>> = Vec::new();
        // Lines without a link since the last one, and whether the last of them stands right above.
        let (mut waiting, mut is_above) = (Vec::<String>::new(), false);
        for (number, line) in text.lines().enumerate() {
            let rows = match Line::read(line) {
                Line::Nothing => {
                    is_above = false;
                    continue;
                }
                Line::Text(words) => {
                    waiting.push(words);
                    is_above = true;
                    continue;
                }
                Line::Rows(rows) => rows,
            };
            for Row { link, title, minutes, begins: begins_at } in rows {
                let number = number + 1;
                if list.slides.len() == MOST {
                    list.left_out.push(format!("All after the first {MOST} links is left out."));
                    return Ok(list.timed(&begins));
                }
                let above = if title.is_empty() && is_above { waiting.pop() } else { None };
                let title = above.clone().unwrap_or(title);
                match LinkSlide::of(&link, title, minutes, aircraft) {
                    Ok(slide) => {
                        list.take_notes(&mut waiting);
                        list.slides.push(slide);
                        begins.push(begins_at);
                    }
                    Err(problem) => {
                        waiting.extend(above);
                        list.left_out.push(format!("Line {number}: {problem}"));
                    }
                }
                is_above = false;
            }
        }
        if list.slides.is_empty() {
            let problem = list.left_out.into_iter().next();
            return Err(problem.unwrap_or_else(|| {
                "There is no link to a scene in it: expected one a line, such as #v=1&ac=navion".to_owned()
            }));
        }
        list.take_notes(&mut waiting);
        Ok(list.timed(&begins))
    }

    /// Gives lines without a link to where they belong.
    fn take_notes(&mut self, waiting: &mut Vec<String>) {
        let mut lines = waiting.drain(..);
        match self.slides.last_mut() {
            Some(slide) => slide.notes.extend(lines),
            None => {
                if self.title.is_empty() {
                    self.title = lines.next().unwrap_or_default();
                }
                // Nothing is lost: what else stands before the first slide is in the way of none.
                self.left_out.extend(lines.map(|line| format!("“{line}” stands before the first link.")));
            }
        }
    }

    /// The same, with the minutes that follow from numbers alone: times at which slides begin, or how long each takes.
    fn timed(mut self, numbers: &[Option<f64>]) -> Self {
        let all: Option<Vec<f64>> = numbers.iter().copied().collect();
        let rise = all.filter(|all| all.first() == Some(&0.0) && all.len() > 1 && all.is_sorted());
        for (place, slide) in self.slides.iter_mut().enumerate() {
            let lasts = match &rise {
                Some(begins) => begins.get(place + 1).map(|next| next - begins[place]),
                None => numbers.get(place).copied().flatten(),
            };
            slide.minutes = slide.minutes.or(lasts.filter(|minutes| *minutes > 0.0));
        }
        self
    }

    /// The lecture as the text of a lesson.
    pub fn to_lesson(&self) -> String {
        let title = in_one_line(&self.title);
        let title = if title.is_empty() { "Lecture" } else { &title };
        let mut text = format!("+++\ntitle = {}\nlecture = true\n+++\n", quoted(title));
        for slide in &self.slides {
            let heading = in_one_line(&slide.title);
            let heading = heading.trim_matches(|c: char| c == '#' || c.is_whitespace());
            let heading = if heading.is_empty() { "Scene" } else { heading };
            text += &format!("\n## {heading}\n```scene\nlink = {}\n```\n", quoted(&slide.link));
            if slide.minutes.is_some() || !slide.notes.is_empty() {
                let minutes = slide.minutes.map_or_else(String::new, |minutes| format!(" {minutes} min"));
                let notes: Vec<String> = slide.notes.iter().map(|line| escaped(&in_one_line(line))).collect();
                text += &format!("```notes{minutes}\n{}\n```\n", notes.join("\n\n"));
            }
        }
        text
    }

    /// How long it is to take \[min\], where the list says so.
    pub fn minutes(&self) -> Option<f64> {
        self.slides.iter().filter_map(|slide| slide.minutes).reduce(|sum, minutes| sum + minutes)
    }
}

impl LinkSlide {
    /// The slide of a link, with a heading of its own where it has none; an error says why there is none.
    fn of(
        link: &str,
        title: String,
        minutes: Option<f64>,
        aircraft: &[Arc<Aircraft>],
    ) -> Result<Self, String> {
        let is_of_scene = |piece: &&str| {
            let key = piece.split('=').next().unwrap_or_default();
            !NOT_OF_SLIDES.contains(&key)
        };
        let pieces: Vec<&str> = link.trim_start_matches('#').split('&').collect();
        let scene: Vec<&str> = pieces.iter().copied().filter(is_of_scene).collect();
        if scene.len() < pieces.len() && scene.iter().all(|piece| piece.starts_with("v=")) {
            return Err("the link leads to a lesson, not to a scene".to_owned());
        }
        let link = format!("#{}", scene.join("&"));
        let opened = link::read(&link, aircraft).ok_or("there is no aircraft")?;
        let title = if title.is_empty() { title_of(&opened) } else { title };
        let faults = opened.notices.iter().map(ToString::to_string).collect();
        Ok(Self { title, link, minutes, notes: Vec::new(), faults })
    }
}

/// The heading of a scene that has none: whose it is and what disturbs it, as far as its stage tells.
fn title_of(opened: &Opened) -> String {
    let Opened { scenario, view, .. } = opened;
    let choice = scenario.disturbance.choices[scenario.plane];
    let is_told = choice.source == Source::OneMode && !view.stage.hides(Hidden::Names);
    let flown = is_told
        .then(|| Findings::of(scenario.clone()).flown_modes().get(choice.mode).map(|mode| mode.naming.name))
        .flatten();
    let name = (!view.stage.hides(Hidden::AircraftName)).then_some(scenario.aircraft.name.as_str());
    let moved = moves(&Scenario::new(scenario.aircraft.clone()), scenario);
    let changed: Vec<&str> = moved
        .iter()
        .map(|moved| moved.parameter)
        .filter(|parameter| !parameter.is_of_disturbance())
        .map(|parameter| parameter.name)
        .collect();
    words::scene::title(name, &changed, &words::scene::disturbed(&choice, flown))
}

/// Text without what would end its line.
fn in_one_line(text: &str) -> String {
    let words = text.split(|c: char| c.is_control() || c.is_whitespace()).filter(|word| !word.is_empty());
    words.collect::<Vec<_>>().join(" ")
}

/// Text in quotes, as TOML reads it.
fn quoted(text: &str) -> String {
    format!("\"{}\"", text.replace('\\', "\\\\").replace('"', "\\\""))
}

/// A line as Markdown that shows it as it is.
fn escaped(line: &str) -> String {
    let mut text = String::new();
    for (at, c) in line.char_indices() {
        let is_of_list = match c {
            '-' | '+' | '=' => at == 0,
            '.' | ')' => line[..at].bytes().all(|byte| byte.is_ascii_digit()) && at > 0,
            _ => false,
        };
        if is_of_list || "\\`*_[]<>$#&|!~".contains(c) {
            text.push('\\');
        }
        text.push(c);
    }
    text
}
