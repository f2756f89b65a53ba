//! The review of a file: what was read as what, what is missing, what looks wrong.

use egui::{CollapsingHeader, Grid, RichText, ScrollArea, Ui};

use super::field::field_ui;
use super::review_sheet::{Eigenvalues, ReviewSheet};
use super::{ImportWish, Importing};
use crate::number::significant;
use crate::ui::finger;
use crate::ui::theme::{self, Palette};

/// Draws it. Gives what is wanted, and whether the sheet is to be closed.
pub fn review_ui(ui: &mut Ui, sheet: &mut Importing) -> (Option<ImportWish>, bool) {
    let mut taken = Vec::new();
    let room = (ui.content_rect().height() - 220.0).max(120.0);
    let review = sheet.review.take();
    let contents = |ui: &mut Ui| {
        if let Some(review) = &review {
            head_ui(ui, review);
            doubts_ui(ui, review, &mut taken);
            fields_ui(ui, review, sheet, &mut taken);
            remarks_ui(ui, review);
            read_ui(ui, review);
        } else if let Some(file) = sheet.files.first().filter(|_| sheet.waits) {
            ui.label(format!("“{}”", file.name));
        }
    };
    finger::scroll_area_ui(ui, "review", ScrollArea::vertical().max_height(room), contents);
    ui.add_space(6.0);
    if sheet.waits {
        ui.label("It is being read.");
    }
    if let Some(problem) = &sheet.problem {
        ui.label(RichText::new(format!("⚠ {problem}")).color(Palette::of(ui).bad));
    }
    let text = review.as_ref().and_then(|review| review.aircraft.clone());
    let missing =
        review.as_ref().map_or(0, |review| review.fields.iter().filter(|field| field.is_missing()).count());
    if missing > 0 {
        ui.label(RichText::new("The aircraft waits for what is missing.").font(theme::small()));
    }
    let mut wish = None;
    let buttons = |ui: &mut Ui| {
        let is_ready = text.is_some() && !sheet.waits;
        if ui.add_enabled_ui(is_ready, |ui| ui.button("Use this aircraft")).inner.clicked() {
            wish = text.clone().map(ImportWish::Use);
        }
        if ui.button("Another file").clicked() {
            wish = Some(ImportWish::Back);
        }
        ui.button("Cancel").clicked()
    };
    let closes = ui.horizontal_wrapped(buttons).inner;
    sheet.review = review;
    if !taken.is_empty() {
        for (key, value) in taken {
            if value.trim().is_empty() {
                sheet.fills.remove(&key);
            } else {
                sheet.fills.insert(key, value);
            }
        }
        wish = wish.or(Some(ImportWish::Read));
    }
    (wish, closes)
}

fn head_ui(ui: &mut Ui, review: &ReviewSheet) {
    ui.label(
        RichText::new(format!("{}: {}", review.file, review.format_name))
            .font(theme::semibold(theme::sizes(ui).value)),
    );
    if !review.title.is_empty() && review.title != review.file {
        ui.label(format!("“{}”", review.title));
    }
    for Eigenvalues { plane, values } in &review.eigenvalues {
        let values: Vec<String> =
            values.iter().filter(|[_, im]| *im >= 0.0).map(|value| eigenvalue(*value)).collect();
        ui.label(format!("Eigenvalues, {plane}: {}", values.join(", ")));
    }
}

fn eigenvalue([re, im]: [f64; 2]) -> String {
    if im == 0.0 { significant(re, 5) } else { format!("{} ± {}i", significant(re, 5), significant(im, 5)) }
}

/// What looks wrong, each with its remedy.
fn doubts_ui(ui: &mut Ui, review: &ReviewSheet, taken: &mut Vec<(String, String)>) {
    let palette = Palette::of(ui);
    for doubt in &review.doubts {
        ui.add_space(6.0);
        let color = if doubt.stops { palette.bad } else { palette.warning };
        ui.label(RichText::new(format!("⚠ {}", doubt.sentence)).color(color));
        if doubt.remedy.is_empty() {
            continue;
        }
        let told: Vec<String> = doubt.remedy.iter().map(|remedy| review.told(remedy)).collect();
        if ui.button(format!("Take {}", told.join(", "))).clicked() {
            taken.extend(doubt.remedy.iter().map(|remedy| (remedy.key.clone(), remedy.value.clone())));
        }
    }
}

/// What can be filled in, what is missing first.
fn fields_ui(ui: &mut Ui, review: &ReviewSheet, sheet: &mut Importing, taken: &mut Vec<(String, String)>) {
    if review.fields.is_empty() {
        return;
    }
    ui.add_space(8.0);
    theme::heading(ui, RichText::new("To fill in").font(theme::semibold(theme::sizes(ui).value)), 3);
    for is_missing in [true, false] {
        for field in review.fields.iter().filter(|field| field.is_missing() == is_missing) {
            ui.push_id(&field.key, |ui| {
                taken.extend(field_ui(ui, field, &mut sheet.typed).map(|value| (field.key.clone(), value)));
            });
        }
    }
}

fn remarks_ui(ui: &mut Ui, review: &ReviewSheet) {
    if review.remarks.is_empty() {
        return;
    }
    ui.add_space(8.0);
    theme::heading(ui, RichText::new("What was made of it").font(theme::semibold(theme::sizes(ui).value)), 3);
    for remark in &review.remarks {
        ui.label(remark);
    }
}

/// Each number that was read.
fn read_ui(ui: &mut Ui, review: &ReviewSheet) {
    if review.read.is_empty() {
        return;
    }
    ui.add_space(8.0);
    let title = format!("What was read ({})", review.read.len());
    CollapsingHeader::new(title).show(ui, |ui| {
        let table = |ui: &mut Ui| {
            for read in &review.read {
                ui.label(if read.line == 0 { "–".to_owned() } else { format!("line {}", read.line) });
                ui.label(RichText::new(&read.text).monospace());
                let value = read.value.map(|value| significant(value, 6)).unwrap_or_default();
                ui.label(format!("{} {value} {}", read.meaning, read.unit).trim_end());
                ui.end_row();
            }
        };
        Grid::new("read").num_columns(3).striped(true).show(ui, table);
    });
}
