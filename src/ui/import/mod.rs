//! The sheet of a person's own aircraft: files are opened, reviewed, and made an aircraft like any other; those that are kept on this
//! device are listed, and deleted.
//!
//! | file | in one line |
//! |---|---|
//! | `open` | where no file is open: a file, a paste, the list of what is kept |
//! | `review_sheet` | the review of a file, as the core tells it |
//! | `review_ui` | what was read as what, what is missing, what looks wrong |
//! | `field` | one thing to fill in |

mod field;
mod open;
mod review_sheet;
mod review_ui;

use std::collections::BTreeMap;

use egui::{Frame, Id, Modal, RichText, Ui};

pub use review_sheet::ReviewSheet;

use super::app::OwnFile;
use super::theme;
use crate::content::import::unasked;

/// The sheet as it stands.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Importing {
    /// The files that are gone through: one, or AVL's derivatives with its mass file.
    pub files: Vec<OwnFile>,
    /// What was typed into the fields and taken.
    pub fills: BTreeMap<String, String>,
    /// What is being typed.
    typed: BTreeMap<String, String>,
    /// The matrices that are being pasted.
    pasted: String,
    /// What is in the files.
    review: Option<ReviewSheet>,
    /// Why there is none, or why what was typed last can't be taken.
    problem: Option<String>,
    /// Whether an answer is on its way.
    waits: bool,
}

/// What is wanted in the sheet.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ImportWish {
    /// To choose a file.
    Pick,
    /// To read a text that was pasted.
    Paste(String),
    /// To read the files again, with what was typed.
    Read,
    /// To use the aircraft, the text of its file.
    Use(String),
    /// To study a kept aircraft, by its place in the list.
    Load(usize),
    /// To delete one.
    Delete(usize),
    /// To keep the aircraft on screen.
    Keep,
    /// To go back to where no file is open.
    Back,
}

impl Importing {
    /// Goes through files.
    pub fn of(files: Vec<OwnFile>) -> Self {
        Self { files, waits: true, ..Self::default() }
    }

    /// Waits for an answer.
    pub fn wait(&mut self) {
        self.waits = true;
    }

    /// Whether an answer is on its way.
    pub const fn is_waiting(&self) -> bool {
        self.waits
    }

    /// Takes a review, or why there is none; whether the files are to be read again, without a value whose field is gone.
    pub fn take(&mut self, review: Result<ReviewSheet, String>) -> bool {
        self.waits = false;
        match review {
            Ok(review) => {
                let value =
                    |key: &String| review.fields.iter().find(|field| field.key == *key)?.value.clone();
                // What was taken is shown as it was taken.
                self.typed.retain(|key, _| value(key).is_none());
                (self.review, self.problem) = (Some(review), None);
            }
            Err(problem) => {
                // Another choice since has taken the field away.
                let gone = self.fills.keys().find(|key| problem.contains(&unasked(key))).cloned();
                if let Some(key) = gone {
                    self.fills.remove(&key);
                    return true;
                }
                self.problem = Some(problem);
            }
        }
        false
    }

    /// Says why something can't be had.
    pub fn refuse(&mut self, problem: String) {
        (self.problem, self.waits) = (Some(problem), false);
    }
}

/// Draws the sheet, with the names of the aircraft that are kept and that of a link which isn't. Gives what is wanted, and whether the sheet is still wanted.
pub fn import_sheet_ui(
    ui: &Ui,
    sheet: &mut Importing,
    (kept, unkept): (&[String], Option<&str>),
    has_files: bool,
) -> (Option<ImportWish>, bool) {
    let frame = Frame::popup(ui.style()).inner_margin(16);
    let modal = Modal::new(Id::unique("import")).frame(frame).show(ui, |ui| {
        ui.set_max_width((ui.content_rect().width() - 64.0).min(640.0));
        let title = if sheet.files.is_empty() { "Your own aircraft" } else { "What is in the file" };
        theme::heading(ui, RichText::new(title).heading().size(theme::sizes(ui).sheet), 2);
        if sheet.files.is_empty() {
            open::open_ui(ui, sheet, (kept, unkept), has_files)
        } else {
            review_ui::review_ui(ui, sheet)
        }
    });
    let closes = modal.should_close();
    let (wish, is_closed) = modal.inner;
    (wish, !closes && !is_closed)
}
