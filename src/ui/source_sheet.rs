//! The sheet that tells where an aircraft's numbers come from, how far they can be trusted, and what is to be remarked on them.

use egui::{Frame, Id, Modal, RichText, ScrollArea, Ui};

use super::theme;
use crate::content::Aircraft;
use crate::flight::aircraft::plane::Plane;
use crate::words;

/// Widest that lines are read with ease.
const WIDEST: f32 = 560.0;

/// The sheet over the page. Says whether it is still wanted.
pub fn source_sheet_ui(ui: &Ui, aircraft: &Aircraft, is_edited: bool) -> bool {
    let frame = Frame::popup(ui.style()).inner_margin(16);
    let modal = Modal::new(Id::unique("source")).frame(frame).show(ui, |ui| {
        ui.set_max_width((ui.content_rect().width() - 64.0).min(WIDEST));
        let title = RichText::new(words::status::SHEET).heading().size(theme::sizes(ui).sheet);
        theme::heading(ui, title, 2);
        // In a low window the text scrolls, between the heading and the button.
        let room = ui.content_rect().height() - 150.0;
        ScrollArea::vertical().max_height(room).show(ui, |ui| text_ui(ui, aircraft, is_edited));
        ui.add_space(8.0);
        ui.button("Close").clicked()
    });
    !(modal.inner || modal.should_close())
}

fn text_ui(ui: &mut Ui, aircraft: &Aircraft, is_edited: bool) {
    ui.label(format!("{}, {}", aircraft.name, aircraft.condition));
    if is_edited {
        ui.label(words::status::OF_FILE);
    }
    let section = |ui: &mut Ui, title: &str| {
        ui.add_space(8.0);
        theme::heading(ui, RichText::new(title).font(theme::semibold(theme::sizes(ui).value)), 3);
    };
    section(ui, words::status::SOURCE);
    ui.label(&aircraft.source);
    for plane in Plane::ALL {
        let Some(notes) = &aircraft.plane_notes[plane] else { continue };
        section(ui, words::status::of_plane(plane, notes.status));
        ui.label(&notes.status_reason);
        if notes.source != aircraft.source {
            ui.label(&notes.source);
        }
    }
    if !aircraft.notes.is_empty() {
        section(ui, words::status::REMARKS);
        for note in &aircraft.notes {
            ui.label(note);
        }
    }
}
