//! Files of other people: recognised by what is in them, read into one review, and made an aircraft like any other.
//!
//! ```text
//! bytes ── encoding ──► text ── detect ──► reader ──► Sheet ── from_… ──► Review ──► aircraft file
//!                                           ▲ fills, typed by a person ▲
//! ```
//!
//! | file | what |
//! |---|---|
//! | [`review`] | the sheet as data: what was read, what is missing, what looks wrong; the forms of files |
//! | `encoding`, `notation`, `detect` | bytes as text, other programs’ ways of writing a matrix, and the form that it is in |
//! | `fills`, `quantities`, `sheet` | what was typed; what there is to fill in; a review in the making |
//! | `scan`, `cases` | numbers in printed logs; which of several cases counts |
//! | `avl`, `avl_system`, `xflr5`, `control_sets`, `vspaero`, `datcom`, `jsbsim` | readers of other programs’ files |
//! | `naming`, `matrix_names`, `system`, `part`, `parting`, `further` | states and inputs of matrices, the two planes in them, and what stands beside the four |
//! | `checks` | what A says of its own units |
//! | `from_coefficients`, `from_derivatives`, `from_matrices`, `aircraft_text` | what is missing is asked for, and the aircraft is written |
//!
//! Nothing is mended in silence: a value that isn't in the file is typed, or a suggestion that was taken.

mod aircraft_text;
mod avl;
mod avl_system;
mod cases;
mod checks;
mod control_sets;
mod datcom;
mod detect;
mod encoding;
mod fills;
mod from_coefficients;
mod from_derivatives;
mod from_matrices;
mod further;
mod jsbsim;
mod matrix_names;
mod naming;
mod notation;
mod part;
mod parting;
mod quantities;
pub mod review;
mod scan;
mod sheet;
mod system;
mod vspaero;
mod xflr5;

use std::collections::BTreeMap;

use super::aircraft::{Aircraft, ContentError};
use super::matrix::draft::Problem;
use super::matrix::{form_bare, form_csv, form_json, form_matlab, plain_signs};
use crate::key::nearest;
use detect::Found;
pub(crate) use encoding::decode;
use fills::Fills;
use review::{Basis, Form, Review};
use sheet::Sheet;

/// A file as it comes from a person: its name, without a folder, and its bytes.
#[derive(Clone, Copy, Debug)]
pub struct FileBytes<'b> {
    /// Its name.
    pub name: &'b str,
    /// What is in it.
    pub bytes: &'b [u8],
}

/// Reads files and what was typed into the fields of their review: one file, or AVL's derivatives with its mass file.
///
/// An error is a file that can't be read at all; what is missing or looks wrong stands in the review.
pub fn review(files: &[FileBytes<'_>], fills: &BTreeMap<String, String>) -> Result<Review, ContentError> {
    let mut texts = Vec::new();
    for file in files {
        let error =
            |problem: &str| ContentError { file: file.name.to_owned(), line: 1, problem: problem.to_owned() };
        let (text, encoding) = decode(file.bytes).ok_or_else(|| {
            error("this is no text file; expected matrices or the output of a program as text")
        })?;
        if text.trim().is_empty() {
            return Err(error("the file is empty; expected matrices A and B, or the output of a program"));
        }
        // What stands in an aircraft file stays as it is; its ends of lines may be those of old Macs.
        let is_own = detect::is_own_file(file.name, &text) && (text.contains('\n') || !text.contains('\r'));
        let text = if is_own {
            text.into_owned()
        } else {
            let at = |(line, problem)| ContentError { file: file.name.to_owned(), line, problem };
            notation::plain(&text).map_err(at)?.into_owned()
        };
        texts.push((file.name, text, encoding));
    }
    let is_mass = |(_, text, _): &&(&str, String, Option<&str>)| detect::is_mass_file(text);
    let mass = texts.iter().find(is_mass).filter(|_| texts.len() > 1);
    if let ([.., (name, ..)], None) = (&texts[..], mass)
        && texts.len() > 1
    {
        let problem =
            "this is no mass file of AVL (Lunit, Munit, rows of masses); another file is opened alone";
        return Err(ContentError { file: (*name).to_owned(), line: 1, problem: problem.to_owned() });
    }
    let Some((name, text, encoding)) = texts.iter().find(|text| !is_mass(text) || texts.len() == 1) else {
        return Err(ContentError {
            file: String::new(),
            line: 1,
            problem: "expected a file, found none".to_owned(),
        });
    };
    let at = |name: &str| {
        let file = name.to_owned();
        move |(line, problem): Problem| ContentError { file, line, problem }
    };
    let mass =
        mass.map(|(name, text, _)| avl::MassFile::read(&plain_signs(text)).map_err(at(name))).transpose()?;
    let form = match detect::form(name, &text.replace('−', "-").replace('\u{a0}', " ")) {
        Found::Form(form) => form,
        Found::Other(sentence) => return Err(at(name)((1, sentence.to_owned()))),
    };
    if mass.is_some() && form != Form::AvlStability {
        let problem = format!("this is {}; a mass file belongs to AVL’s derivatives (ST) only", form.name());
        return Err(at(name)((1, problem)));
    }
    let fills = Fills::new(fills).map_err(|problem| at(name)((1, problem)))?;
    let mut sheet = Sheet::new(name, form, fills);
    if let Some(encoding) = encoding {
        sheet.remark(format!("The text is in {encoding}."));
    }
    // An aircraft file is kept as it is: its sentences have true minus signs.
    let text = if form == Form::AircraftFile { text.clone() } else { plain_signs(text) };
    read(&mut sheet, form, name, &text, mass.as_ref())?;
    let is_whole = sheet.review.aircraft.is_some();
    if let Some(stranger) = sheet.fills.stranger(is_whole) {
        let keys =
            fills::CHOICES.into_iter().chain(quantities::QUANTITIES.iter().map(|quantity| quantity.key));
        let meant = nearest(stranger, keys).filter(|key| *key != stranger);
        let meant = meant.map(|key| format!("; did you mean “{key}”?"));
        let problem = format!("{}{}", unasked(stranger), meant.unwrap_or_default());
        return Err(at(name)((1, problem)));
    }
    if let Some(key) = sheet.fills.without_suggestion().filter(|_| is_whole) {
        let problem = format!("{key}: nothing is suggested for it here; expected a value");
        return Err(at(name)((1, problem)));
    }
    // What an aircraft file would refuse is told before anybody uses it.
    if let Some(text) = &sheet.review.aircraft
        && let Err(error) = Aircraft::from_toml(name, text)
    {
        sheet.stop(
            "aircraft",
            format!("There is no aircraft with these numbers: {}.", error.problem),
            Vec::new(),
        );
        sheet.review.aircraft = None;
    }
    Ok(sheet.review)
}

/// The sentence about a value for a field that the review of a file doesn't have.
pub fn unasked(key: &str) -> String {
    format!("nothing in this file waits for “{key}”")
}

fn read(
    sheet: &mut Sheet,
    form: Form,
    name: &str,
    text: &str,
    mass: Option<&avl::MassFile>,
) -> Result<(), ContentError> {
    let at = |(line, problem): Problem| ContentError { file: name.to_owned(), line, problem };
    if form == Form::AircraftFile {
        let aircraft = Aircraft::from_toml(name, text)?;
        sheet.set_basis(Basis::OwnFile);
        sheet.review.title = aircraft.name;
        sheet.review.aircraft = Some(text.to_owned());
        return Ok(());
    }
    let is_printed =
        matches!(form, Form::AvlStability | Form::AvlSystem | Form::Xflr5 | Form::Vspaero | Form::Datcom);
    // Blanks that don't break are those of a page or a text processor.
    let blank = if is_printed { text.replace('\u{a0}', " ") } else { text.to_owned() };
    let with_points = scan::decimal_points(&blank).filter(|_| is_printed);
    if with_points.is_some() {
        sheet.remark("The commas in its numbers were read as points.");
    }
    let text = with_points.as_deref().unwrap_or(&blank);
    if matches!(form, Form::AvlStability | Form::Xflr5) {
        for (line, text) in (1..).zip(text.lines()) {
            for (name, word) in scan::unreadable(text) {
                sheet.warn(
                    "unreadable",
                    format!("{name} on line {line} is “{word}”, which is no number."),
                    Vec::new(),
                );
            }
        }
    }
    let mut by_derivatives = false;
    let mut has_table = false;
    match form {
        Form::AircraftFile => {}
        Form::Json => sheet.matrices = Some(form_json::read(text).map_err(at)?),
        Form::Table => sheet.matrices = Some(form_csv::read(text).map_err(at)?),
        Form::Script => sheet.matrices = Some(form_matlab::read(text).map_err(at)?),
        Form::Numbers => sheet.matrices = Some(form_bare::read(text).map_err(at)?),
        Form::AvlSystem => avl_system::read(sheet, text).map_err(at)?,
        Form::JsbsimJson => jsbsim::read_json(sheet, text).map_err(at)?,
        Form::JsbsimScicos => jsbsim::read_scicos(sheet, text).map_err(at)?,
        Form::Xflr5 => by_derivatives = xflr5::read(sheet, text).map_err(at)?,
        Form::AvlStability => {
            avl::read(sheet, text, mass).map_err(at)?;
            has_table = true;
        }
        Form::Vspaero => {
            vspaero::read(sheet, text).map_err(at)?;
            has_table = true;
        }
        Form::Datcom => {
            datcom::read(sheet, text).map_err(at)?;
            has_table = true;
        }
    }
    let completed = if let Some(draft) = sheet.matrices.take() {
        from_matrices::complete(sheet, draft)
    } else if by_derivatives {
        from_derivatives::complete(sheet)
    } else if has_table {
        from_coefficients::complete(sheet)
    } else {
        Ok(())
    };
    completed.map_err(at)
}

impl Review {
    /// The text of an aircraft file, or in one sentence what stands in its way.
    pub fn text(&self) -> Result<&str, ContentError> {
        if let Some(text) = &self.aircraft {
            return Ok(text);
        }
        let missing = self.fields.iter().filter(|field| field.required && field.value.is_none());
        let missing: Vec<String> = missing.map(review::Field::told).collect();
        let stops = self.doubts.iter().filter(|doubt| doubt.stops);
        let mut sentences: Vec<String> = stops.map(review::Doubt::told).collect();
        if !missing.is_empty() {
            sentences.push(format!("the file doesn’t say {}", missing.join("; ")));
        }
        let line = self.doubts.iter().find(|doubt| doubt.stops).map_or(1, |doubt| doubt.line.max(1));
        Err(ContentError { file: self.file.clone(), line, problem: sentences.join(" ") })
    }

    /// The aircraft, or in one sentence what stands in its way.
    pub fn aircraft(&self) -> Result<Aircraft, ContentError> {
        Aircraft::own(&self.file, self.text()?)
    }

    /// What a reader of the aircraft's numbers must know: what was made of the file, and what looks wrong in it.
    fn notes(&self) -> Vec<String> {
        self.remarks.iter().cloned().chain(self.doubts.iter().map(|doubt| doubt.sentence.clone())).collect()
    }
}
