//! The sheet "A lecture from links": links are pasted, put in order, named, presented and saved.

use std::sync::Arc;

use egui::{Event, Frame, Id, Modal, RichText, ScrollArea, TextEdit, Ui, Vec2};

use crate::content::Aircraft;
use crate::lesson::{LinkSlide, LinksList, said};
use crate::ui::finger;
use crate::ui::theme::{self, Palette};

/// Room for the number of a slide \[points\].
const NUMBER: f32 = 20.0;

/// A lecture that is being made of links.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Deck {
    /// What has been pasted and isn't taken yet.
    pasted: String,
    /// Why nothing could be taken.
    problem: Option<String>,
    /// Name of the file that it has been saved or presented as.
    pub file: Option<String>,
    /// What has been taken.
    pub list: LinksList,
}

/// What a person wants of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DeckWish {
    /// Present it.
    Present,
    /// Save it as the file of a lesson.
    Save,
}

/// What is done to a slide.
#[derive(Clone, Copy)]
enum Edit {
    Up(usize),
    Down(usize),
    Delete(usize),
}

impl Deck {
    /// Takes the links of a text, after those that it has. Nothing of the text is lost where there is none.
    pub fn take(&mut self, text: &str, aircraft: &[Arc<Aircraft>]) {
        match LinksList::read(text, aircraft) {
            Ok(read) => {
                if self.list.title.is_empty() {
                    self.list.title = read.title;
                }
                self.list.slides.extend(read.slides);
                self.list.left_out = read.left_out;
                self.problem = None;
                self.pasted.clear();
            }
            Err(problem) => {
                self.problem = Some(problem);
                text.clone_into(&mut self.pasted);
            }
        }
    }

    /// Draws the sheet. Gives what is wanted, and whether the sheet is still wanted itself.
    pub fn show(&mut self, ui: &Ui, aircraft: &[Arc<Aircraft>], has_files: bool) -> (Option<DeckWish>, bool) {
        let frame = Frame::popup(ui.style()).inner_margin(16);
        let room = ui.content_rect().size();
        let modal = Modal::new(Id::unique("deck")).frame(frame).show(ui, |ui| {
            ui.set_max_width((room.x - 64.0).min(640.0));
            theme::heading(
                ui,
                RichText::new("A lecture from links").heading().size(theme::sizes(ui).sheet),
                2,
            );
            ui.label("Each link is a slide. A line may have a title before or after its link, and minutes: (3 min).");
            let area = ScrollArea::vertical().max_height((room.y - 220.0).max(140.0));
            finger::scroll_area_ui(ui, "deck", area, |ui| {
                self.field_ui(ui, aircraft);
                self.slides_ui(ui);
            });
            ui.add_space(8.0);
            ui.horizontal_wrapped(|ui| {
                let has_slides = !self.list.slides.is_empty();
                let mut wish = None;
                if has_slides && ui.button("Present").clicked() {
                    wish = Some(DeckWish::Present);
                }
                if has_slides && has_files && ui.button("Save as a lesson file").clicked() {
                    wish = Some(DeckWish::Save);
                }
                (wish, ui.button("Close").clicked())
            })
            .inner
        });
        let (wish, closes) = modal.inner;
        (wish, !closes && !modal.should_close())
    }

    /// Where links are pasted. What is pasted is taken at once, what is typed by the button.
    fn field_ui(&mut self, ui: &mut Ui, aircraft: &[Arc<Aircraft>]) {
        let field = TextEdit::multiline(&mut self.pasted)
            .hint_text("Paste links here, one a line")
            .desired_rows(3)
            .desired_width(f32::INFINITY);
        let response = ui.add(field).accessible_name("Links, one a line");
        let is_pasted = response.changed()
            && ui.input(|input| input.events.iter().any(|event| matches!(event, Event::Paste(_))));
        let is_asked = !self.pasted.trim().is_empty() && ui.button("Add these links").clicked();
        if is_pasted || is_asked {
            let text = self.pasted.clone();
            self.take(&text, aircraft);
            ui.request_repaint();
        }
        let palette = Palette::of(ui);
        for sentence in self.problem.iter().chain(&self.list.left_out) {
            ui.label(RichText::new(format!("⚠ {sentence}")).color(palette.bad));
        }
    }

    fn slides_ui(&mut self, ui: &mut Ui) {
        if self.list.slides.is_empty() {
            return;
        }
        ui.add_space(8.0);
        ui.horizontal_wrapped(|ui| {
            let title = TextEdit::singleline(&mut self.list.title).hint_text("Lecture").desired_width(260.0);
            ui.add(title).accessible_name("Title of the lecture");
            let count = match self.list.slides.len() {
                1 => "1 slide".to_owned(),
                count => format!("{count} slides"),
            };
            let minutes = self.list.minutes().map(said::minutes);
            ui.label(minutes.map_or(count.clone(), |minutes| format!("{count} · {minutes}")));
        });
        ui.add_space(4.0);
        let (mut edit, count) = (None, self.list.slides.len());
        for (place, slide) in self.list.slides.iter_mut().enumerate() {
            let row = ui.horizontal_top(|ui| slide_ui(ui, slide, (place, count)));
            edit = row.inner.or(edit);
        }
        match edit {
            Some(Edit::Up(place)) => self.list.slides.swap(place, place - 1),
            Some(Edit::Down(place)) => self.list.slides.swap(place, place + 1),
            Some(Edit::Delete(place)) => {
                self.list.slides.remove(place);
            }
            None => return,
        }
        ui.request_repaint();
    }
}

/// A row: number, title with what is wrong below it, and what can be done to it.
fn slide_ui(ui: &mut Ui, slide: &mut LinkSlide, (place, count): (usize, usize)) -> Option<Edit> {
    let number = place + 1;
    let (button, gap) = (ui.spacing().interact_size.y, ui.spacing().item_spacing.x);
    // A square for each thing that can be done, and the number.
    let width = ui.available_width() - 3.0 * (button.max(26.0) + gap) - NUMBER - 2.0 * gap;
    ui.allocate_ui(Vec2::new(NUMBER, button), |ui| ui.label(number.to_string()));
    ui.vertical(|ui| {
        ui.set_width(width.max(80.0));
        let title = TextEdit::singleline(&mut slide.title).desired_width(f32::INFINITY);
        ui.add(title).accessible_name(format!("Title of slide {number}"));
        if let Some(minutes) = slide.minutes {
            ui.label(RichText::new(said::minutes(minutes)).font(theme::small()));
        }
        for fault in &slide.faults {
            let text = RichText::new(format!("⚠ {fault}")).font(theme::small());
            ui.label(text.color(Palette::of(ui).warning));
        }
    });
    let mut edit = None;
    ui.horizontal(|ui| {
        let mut button = |sign: &str, says: &str, is_there: bool, does: Edit| {
            let button = egui::Button::new(sign);
            let response = ui.add_enabled(is_there, button).accessible_name(format!("{says} slide {number}"));
            if response.on_hover_text(says).clicked() {
                edit = Some(does);
            }
        };
        button("↑", "Move up", place > 0, Edit::Up(place));
        button("↓", "Move down", number < count, Edit::Down(place));
        button("×", "Delete", true, Edit::Delete(place));
    });
    edit
}
