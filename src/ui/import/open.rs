//! The sheet where no file is open.

use egui::{RichText, ScrollArea, TextEdit, Ui};

use super::{ImportWish, Importing};
use crate::ui::finger;
use crate::ui::theme::{self, Palette};

/// Draws it. Gives what is wanted, and whether the sheet is to be closed.
pub fn open_ui(
    ui: &mut Ui,
    sheet: &mut Importing,
    (kept, unkept): (&[String], Option<&str>),
    has_files: bool,
) -> (Option<ImportWish>, bool) {
    let mut wish = None;
    let room = (ui.content_rect().height() - 180.0).max(120.0);
    let contents = |ui: &mut Ui| {
        ui.label(KNOWN);
        if has_files && ui.button("Open a file …").clicked() {
            wish = Some(ImportWish::Pick);
        }
        ui.label(
            RichText::new("Files can also be dropped on this page. They stay on this device.")
                .font(theme::small()),
        );
        ui.add_space(8.0);
        let field = TextEdit::multiline(&mut sheet.pasted).code_editor().desired_rows(4).hint_text(HINT);
        ui.add(field.desired_width(f32::INFINITY)).accessible_name("Matrices or a file, as text");
        if ui.button("Read the text").clicked() && !sheet.pasted.trim().is_empty() {
            wish = Some(ImportWish::Paste(sheet.pasted.clone()));
        }
        if let Some(problem) = &sheet.problem {
            ui.label(RichText::new(format!("⚠ {problem}")).color(Palette::of(ui).bad));
        }
        if let Some(name) = unkept {
            ui.add_space(8.0);
            ui.horizontal_wrapped(|ui| {
                ui.label(format!("{name} came with a link"));
                if ui.button("Keep it on this device").clicked() {
                    wish = Some(ImportWish::Keep);
                }
            });
        }
        if !kept.is_empty() {
            ui.add_space(8.0);
            theme::heading(
                ui,
                RichText::new("On this device").font(theme::semibold(theme::sizes(ui).value)),
                3,
            );
        }
        for (index, name) in kept.iter().enumerate() {
            ui.horizontal_wrapped(|ui| {
                if ui.button(name).clicked() {
                    wish = Some(ImportWish::Load(index));
                }
                if ui.button("Delete").accessible_name(format!("Delete {name}")).clicked() {
                    wish = Some(ImportWish::Delete(index));
                }
            });
        }
    };
    finger::scroll_area_ui(ui, "own aircraft", ScrollArea::vertical().max_height(room), contents);
    ui.add_space(6.0);
    let closes = ui.button("Close").clicked();
    (wish, closes)
}

/// What can be opened.
const KNOWN: &str = "Matrices as MATLAB, Python, JSON or CSV text; files of AVL (.st, .sys), XFLR5, VSPAERO, Digital DATCOM and \
    JSBSim; an aircraft file of this page.";

/// What a paste may look like.
const HINT: &str = "A = [ … ]; B = [ … ]";
