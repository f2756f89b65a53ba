//! A person's own aircraft: opened by drop, choice or paste, reviewed, used, kept on this device until deleted.

use std::sync::Arc;

use egui::{Event, Ui};

use super::App;
use super::actions::Action;
use super::core_module::{CoreRequest, OwnFile};
use super::course::FileRequest;
use crate::content::{Aircraft, FILES, TextFile, edits_in, lines_with_key};
use crate::scenario::{Lock, Scenario, link};
use crate::ui::curtain::Curtain;
use crate::ui::import::{ImportWish, Importing, ReviewSheet, import_sheet_ui};
use crate::ui::keys::Wish;
use crate::words;

/// Name of a text that was pasted.
const PASTED: &str = "pasted text";

/// Begins the key of a person's own aircraft, so that none of those that ship has it.
const OWN: &str = "own-";

/// Most letters of a name that stand in a key.
const LONGEST: usize = 40;

impl App {
    /// Goes where the sheet of keys leads.
    pub(super) fn follow_wish(&mut self, ui: &Ui, wish: Option<Wish>) {
        match wish {
            Some(Wish::Lessons) => self.panes.lessons = true,
            Some(Wish::TakeAlong) => self.open_take_along(ui),
            Some(Wish::Import) => self.open_import(ui),
            None => {}
        }
    }

    /// Opens the sheet.
    pub(super) fn open_import(&mut self, ui: &Ui) {
        if self.is_kept() || Curtain::of(ui).locks(Lock::Aircraft) {
            return self.share.show(ui, words::view::KEPT);
        }
        self.panes.import.get_or_insert_default();
    }

    /// Goes through files that a person has brought.
    pub(super) fn review_files(&mut self, files: Vec<OwnFile>) {
        self.panes.import = Some(Importing::of(files));
        self.read_files();
    }

    fn read_files(&mut self) {
        let Some(sheet) = &mut self.panes.import else { return };
        let Some(file) = sheet.files.first().cloned() else { return };
        sheet.wait();
        self.panes.files_asked += 1;
        let mass = sheet.files.get(1).cloned();
        let fills = serde_json::json!(sheet.fills).to_string();
        self.ask(CoreRequest::ReadFile { file, mass, fills, number: self.panes.files_asked });
    }

    /// Takes the review of a file, unless the sheet was closed before it came, or another has been asked for since.
    pub(super) fn take_review(&mut self, number: u64, answer: Result<String, String>) {
        let is_last = number == self.panes.files_asked;
        let Some(sheet) = self.panes.import.as_mut().filter(|sheet| is_last && sheet.is_waiting()) else {
            return;
        };
        let reads_again = sheet.take(answer.and_then(|json| {
            serde_json::from_str::<ReviewSheet>(&json)
                .map_err(|error| format!("The answer can’t be read: {error}."))
        }));
        if reads_again {
            self.read_files();
        }
    }

    /// Says in the sheet why a file can't be had.
    pub(super) fn refuse_file(&mut self, problem: String) {
        self.panes.import.get_or_insert_default().refuse(problem);
    }

    /// The sheet, where it is open. Gives what is to be studied.
    pub(super) fn import_ui(&mut self, ui: &Ui) -> Option<Action> {
        self.take_pasted(ui);
        let mut sheet = self.panes.import.take()?;
        let kept: Vec<String> = self.kept_aircraft().map(|aircraft| aircraft.name.clone()).collect();
        // One that a link has brought is on screen, and in no list.
        let shown = &self.scenario.aircraft;
        let is_here = self.aircraft.iter().any(|aircraft| aircraft.key == shown.key);
        let unkept = (shown.own.is_some() && !is_here).then(|| shown.name.clone());
        let (wish, is_wanted) =
            import_sheet_ui(ui, &mut sheet, (&kept, unkept.as_deref()), self.panes.has_files);
        self.panes.import = is_wanted.then_some(sheet);
        let wish = wish?;
        ui.request_repaint();
        match wish {
            ImportWish::Pick => self.panes.file_requests.push(FileRequest::Pick),
            ImportWish::Paste(text) => self.review_files(vec![pasted(text)]),
            ImportWish::Read => self.read_files(),
            ImportWish::Back => self.panes.import = Some(Importing::default()),
            ImportWish::Use(text) => match self.keep(&text) {
                Ok(aircraft) => {
                    self.panes.import = None;
                    return Some(Action::LoadOwn(aircraft));
                }
                Err(problem) => self.refuse_file(problem),
            },
            ImportWish::Keep => {
                let text = self.scenario.aircraft.own.clone().unwrap_or_default();
                match self.keep(&text) {
                    // The same numbers under a key of this device: what was changed on it stays.
                    Ok(aircraft) => self.scenario.aircraft = aircraft,
                    Err(problem) => self.refuse_file(problem),
                }
            }
            ImportWish::Load(index) => {
                let aircraft = self.kept_aircraft().nth(index).cloned();
                self.panes.import = None;
                return aircraft.map(Action::LoadOwn);
            }
            ImportWish::Delete(index) => {
                let key = self.kept_aircraft().nth(index).map(|aircraft| aircraft.key.clone());
                self.aircraft.retain(|aircraft| Some(&aircraft.key) != key.as_ref());
                self.own_files.retain(|file| Some(&file.name) != key.as_ref());
                self.own_files_changed = true;
            }
        }
        None
    }

    /// The aircraft of the list that are kept on this device.
    fn kept_aircraft(&self) -> impl Iterator<Item = &Arc<Aircraft>> {
        let is_kept = |aircraft: &&Arc<Aircraft>| self.own_files.iter().any(|file| file.name == aircraft.key);
        self.aircraft.iter().filter(is_kept)
    }

    /// What was pasted over the page, not into a field: a file or matrices.
    fn take_pasted(&mut self, ui: &Ui) {
        if ui.text_edit_focused() || self.view.presents {
            return;
        }
        let pasted_text = ui.input(|input| {
            input.events.iter().find_map(|event| match event {
                Event::Paste(text) => Some(text.clone()),
                _ => None,
            })
        });
        let Some(text) = pasted_text.filter(|text| !text.trim().is_empty()) else { return };
        self.open_import(ui);
        if self.panes.import.is_some() {
            self.review_files(vec![pasted(text)]);
        }
    }

    /// Puts an aircraft into the list and keeps it on this device; one that is there already is that.
    fn keep(&mut self, text: &str) -> Result<Arc<Aircraft>, String> {
        if let Some((file, _)) = FILES.iter().find(|(_, shipped)| *shipped == text)
            && let Some(shipped) = self.aircraft.iter().find(|it| file.strip_suffix(".toml") == Some(&it.key))
        {
            return Ok(shipped.clone());
        }
        let aircraft = Aircraft::own("aircraft", text).map_err(|error| error.to_string())?;
        let mut number = 1;
        let (key, text) = loop {
            let key = own_key(&aircraft.name, number);
            let text = with_key(text, &key);
            match self.aircraft.iter().find(|aircraft| aircraft.key == key) {
                Some(same) if same.own.as_deref() == Some(&text) => return Ok(same.clone()),
                Some(_) => number += 1,
                None => break (key, text),
            }
        };
        let aircraft = Arc::new(Aircraft::own("aircraft", &text).map_err(|error| error.to_string())?);
        self.aircraft.push(aircraft.clone());
        self.own_files.push(TextFile::new(&key, &text));
        self.own_files_changed = true;
        Ok(aircraft)
    }

    /// The scene with an aircraft of one's own, and what its file says was changed on it.
    pub(super) fn with_own(&self, aircraft: Arc<Aircraft>) -> Scenario {
        let edits = aircraft.own.as_deref().and_then(edits_in);
        let mut scenario = self.scenario.with_aircraft(aircraft);
        if let Some(edits) = edits {
            link::edit(&mut scenario, &edits);
        }
        scenario
    }

    /// Takes up the aircraft that are kept on this device, as JSON, where `known` were kept when this page last read or wrote them. What
    /// another tab has deleted is deleted here, and what was deleted here stays so. One that can't be read any more stays there, and one
    /// that another tab has kept by the name of one that is here gets a name of its own.
    pub fn take_up_aircraft(&mut self, json: &str, known: &str) {
        let read = |json: &str| serde_json::from_str::<Vec<TextFile>>(json).ok();
        let Some(files) = read(json) else { return };
        let known = read(known).unwrap_or_default();
        for gone in known.iter().filter(|file| !files.contains(file)) {
            if self.own_files.contains(gone) {
                self.aircraft.retain(|aircraft| aircraft.key != gone.name);
                self.own_files.retain(|file| file != gone);
            }
        }
        for file in files {
            if self.own_files.contains(&file) || known.contains(&file) {
                continue;
            }
            if let Ok(aircraft) = Aircraft::own("aircraft", &file.text) {
                match self.aircraft.iter().find(|other| other.key == aircraft.key) {
                    None => self.aircraft.push(Arc::new(aircraft)),
                    Some(other) if other.own.as_deref() == Some(&file.text) => {}
                    Some(_) => {
                        // It has just been read, so it is kept.
                        let _ = self.keep(&file.text);
                        continue;
                    }
                }
            }
            self.own_files.push(file);
        }
        self.own_files_changed = true;
    }

    /// The aircraft that are kept on this device, as JSON, where they have changed since they were last asked for.
    pub fn take_changed_aircraft(&mut self) -> Option<String> {
        std::mem::take(&mut self.own_files_changed).then(|| serde_json::json!(self.own_files).to_string())
    }
}

fn pasted(text: String) -> OwnFile {
    OwnFile { name: PASTED.to_owned(), bytes: text.into_bytes() }
}

/// A key after a name.
fn own_key(name: &str, number: usize) -> String {
    let letters = name.chars().map(|c| if c.is_ascii_alphanumeric() { c.to_ascii_lowercase() } else { '-' });
    let words: String = letters.take(LONGEST).collect();
    let words: Vec<&str> = words.split('-').filter(|word| !word.is_empty()).collect();
    let name = if words.is_empty() { "aircraft".to_owned() } else { words.join("-") };
    if number == 1 { format!("{OWN}{name}") } else { format!("{OWN}{name}-{number}") }
}

/// The text of an aircraft file with another key.
fn with_key(text: &str, key: &str) -> String {
    let lines = lines_with_key(text, "key");
    lines.map(|(line, is_key)| if is_key { format!("key = \"{key}\"\n") } else { line.to_owned() }).collect()
}
