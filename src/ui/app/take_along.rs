//! The scene taken along: asked of the core, saved or copied.

use egui::Ui;
use serde::Deserialize;
use serde_json::{Value, json};

use super::App;
use super::core_module::CoreRequest;
use super::course::FileRequest;
use crate::content::TextFile;
use crate::export::Target;
use crate::key::Keyed as _;
use crate::scenario::link;
use crate::scenario::view::Pane;
use crate::ui::copy;
use crate::ui::curtain::Curtain;
use crate::ui::take_along::{Means, TakeAlong, take_along_sheet_ui};

/// What the core has written.
#[derive(Deserialize)]
struct WrittenFile {
    text: String,
    file: String,
    notices: Vec<String>,
}

impl App {
    /// Opens the sheet. What is hidden on the page would stand in every file.
    pub(super) fn open_take_along(&mut self, ui: &Ui) {
        if Curtain::of(ui).hides_anything() {
            return self.share.show(ui, HIDDEN);
        }
        self.panes.take_along.get_or_insert_default();
    }

    /// Opens it with what a pane has.
    pub(super) fn take_pane_along(&mut self, ui: &Ui, pane: Pane) {
        self.open_take_along(ui);
        if let Some(sheet) = &mut self.panes.take_along {
            *sheet = TakeAlong::of_pane(pane, self.view.response.tab);
        }
    }

    /// Has the scene printed as a page of paper. What is hidden on the page would stand there.
    pub(super) fn print(&mut self, ui: &Ui) {
        if Curtain::of(ui).hides_anything() {
            return self.share.show(ui, NOT_PRINTED);
        }
        let request = self.request_for(Target::Page);
        self.ask(CoreRequest::Print(request.to_string()));
        ui.request_repaint();
    }

    /// The scene in a form: by its link, behind the address of this page, and an aircraft that has no room in it beside it.
    fn request_for(&self, target: Target) -> Value {
        let link = format!("{}#{}", self.share.address, self.link_of_scene(&self.view));
        let aircraft = &self.scenario.aircraft;
        let beside = if link::own::has_room(aircraft) { None } else { aircraft.own.as_deref() };
        match beside {
            Some(own) => json!({ "link": link, "toml": own, "target": target.key() }),
            None => json!({ "link": link, "target": target.key() }),
        }
    }

    /// Hands the page of paper on, or says why there is none.
    pub(super) fn take_page(&mut self, answer: Result<String, String>) {
        let page = answer.and_then(|json| read(&json));
        match page {
            Ok(WrittenFile { text, .. }) if self.panes.has_pictures => {
                self.panes.file_requests.push(FileRequest::Print(text));
            }
            Ok(WrittenFile { text, file, .. }) if self.panes.has_files => {
                self.panes.file_requests.push(FileRequest::Save(TextFile::new(&file, &text)));
                self.share.tell(&format!("Saved: {file}. A browser prints it"));
            }
            Ok(_) => self.share.tell("A page can be printed in a browser only"),
            Err(problem) => self.share.tell(&format!("⚠ {problem}")),
        }
    }

    /// Copies what is under the pointer, where the key was pressed in this frame.
    pub(super) fn copy_by_key(&mut self, ui: &Ui) {
        let Some(text) = copy::take(ui.ctx()) else { return };
        if Curtain::of(ui).hides_anything() {
            return self.share.show(ui, NOT_COPIED);
        }
        if text.is_empty() {
            return self.share.show(ui, NOTHING_THERE);
        }
        let lines = text.trim_end().lines().count();
        let said = match text.trim_end().lines().next() {
            Some(first) if lines == 1 => format!("Copied: {first}"),
            _ => format!("Copied: a table of {lines} lines"),
        };
        ui.copy_text(text);
        self.share.show(ui, &said);
    }

    /// The sheet, where it is open.
    pub(super) fn take_along_ui(&mut self, ui: &Ui) {
        if let Some(text) = self.panes.copied.take() {
            ui.copy_text(text);
        }
        let Some(mut sheet) = self.panes.take_along.take() else { return };
        let means = Means { files: self.panes.has_files, pictures: self.panes.has_pictures };
        let shown = take_along_sheet_ui(ui, &mut sheet, means);
        if shown.prints {
            self.print(ui);
        }
        if let Some(target) = shown.wanted {
            sheet.wait(target);
        }
        self.panes.take_along = shown.is_wanted.then_some(sheet);
        if let Some(target) = shown.wanted {
            let request = self.request_for(target).to_string();
            self.panes.times_taken += 1;
            self.ask(CoreRequest::TakeAlong { request, number: self.panes.times_taken });
            ui.request_repaint();
        }
    }

    /// Saves or copies what the core has written, unless the sheet was closed before it came, or waits for something else.
    pub(super) fn take(&mut self, number: u64, answer: Result<String, String>) {
        let is_last = number == self.panes.times_taken;
        let waiting = self.panes.take_along.as_mut().filter(|sheet| is_last && sheet.is_waiting());
        let Some(sheet) = waiting else { return };
        let written = answer.and_then(|json| read(&json));
        let (said, written) = match written {
            Ok(written) => (Ok(written.notices.clone()), Some(written)),
            Err(problem) => (Err(problem), None),
        };
        let copies = sheet.take(said);
        let Some(WrittenFile { text, file, .. }) = written else { return };
        if sheet.wants_picture(&file) {
            let svg = TextFile::new(&file, &text);
            self.panes.file_requests.push(FileRequest::Picture { svg, copies });
            return;
        }
        let told = if copies { format!("Copied: {file}") } else { format!("Saved: {file}") };
        if copies {
            self.panes.copied = Some(text);
        } else {
            self.panes.file_requests.push(FileRequest::Save(TextFile::new(&file, &text)));
        }
        self.share.say(told.clone());
        sheet.tell(told);
    }
}

/// What the core has answered.
fn read(json: &str) -> Result<WrittenFile, String> {
    serde_json::from_str(json).map_err(|error| format!("The answer can’t be read: {error}."))
}

/// Why nothing is printed.
const NOT_PRINTED: &str = "Nothing can be printed while something is hidden";
/// Why nothing is copied.
const NOT_COPIED: &str = "Nothing can be copied while something is hidden";
/// The same where the pointer is on nothing that has a text.
const NOTHING_THERE: &str = "Point at a number, a table or a curve first";

/// Why the sheet doesn't open.
const HIDDEN: &str = "Nothing can be taken along while something is hidden";
