//! An aircraft from dimensional derivatives that were read, over mass and inertia.

use super::aircraft_text::AircraftText;
use super::from_coefficients::{of, say_senses, turn_elevator};
use super::review::Basis;
use super::sheet::Sheet;
use crate::content::matrix::draft::Problem;
use crate::flight::aircraft::derivatives::{LATERAL_DERIVATIVES, LONGITUDINAL_DERIVATIVES};
use crate::flight::analysis::STANDARD_GRAVITY;
use crate::number::trimmed;

/// Completes the sheet and, where nothing is missing, writes the aircraft. The derivatives are in stability axes.
pub(super) fn complete(sheet: &mut Sheet) -> Result<(), Problem> {
    sheet.set_basis(Basis::Derivatives);
    let speed = sheet.needed("speed", None)?;
    let gravity = sheet.value("gravity")?.unwrap_or(STANDARD_GRAVITY);
    let gamma0 = sheet.value("gamma0_deg")?.unwrap_or(0.0);
    let altitude = sheet.value("altitude")?;
    if altitude.is_none() {
        sheet.remark("The altitude is taken as 0; in these derivatives the air is already.");
    }
    let mut airframe = Vec::new();
    for key in ["mass", "S", "c", "b", "Ix", "Iy", "Iz", "Ixz"] {
        airframe.push((key, sheet.value(key)?));
    }
    let mut zeros = Vec::new();
    let mut read = |sheet: &mut Sheet, key: &'static str, required: bool| {
        let value = if required { sheet.needed(key, None)? } else { sheet.value(key)? };
        if value.is_none() && !required {
            zeros.push(key);
        }
        Ok::<_, Problem>((key, value))
    };
    let mut longitudinal = Vec::new();
    for row in &LONGITUDINAL_DERIVATIVES {
        // Without an elevator there is nothing to say of it.
        longitudinal.push(read(sheet, row.field.key, row.field.required && row.field.key != "Mde")?);
    }
    turn_elevator(sheet, &mut longitudinal, "Mde");
    let has_lateral = sheet.value("Yv")?.is_some();
    let mut lateral = Vec::new();
    for row in LATERAL_DERIVATIVES.iter().filter(|_| has_lateral) {
        lateral.push(read(sheet, row.field.key, row.field.required)?);
    }
    if !zeros.is_empty() {
        sheet.remark(format!("Not in the file, and taken as zero: {}.", zeros.join(", ")));
    }
    say_senses(sheet, &lateral, ["Lda", "Ndr"]);
    if sheet.waits() {
        return Ok(());
    }
    let condition = format!("{} m/s", trimmed(speed.unwrap_or_default(), 4));
    let review = &sheet.review;
    let mut text = AircraftText::new(&review.title, &condition, &review.file, &review.notes());
    text.word("basis", "derivatives");
    text.word("units", "SI");
    text.word("axes", "stability");
    text.word("angles", "rad");
    text.block("flight");
    text.number("altitude", altitude.unwrap_or(0.0));
    text.optional("speed", speed);
    text.number("gravity", gravity);
    text.number("gamma0_deg", gamma0);
    text.block("airframe");
    airframe.iter().for_each(|&(key, value)| text.optional(key, value));
    text.word("inertia_axes", "stability");
    text.block("longitudinal");
    text.unverified();
    // A file without an elevator has it at zero.
    longitudinal.iter().for_each(|&(key, value)| {
        text.optional(key, if key == "Mde" { value.or(Some(0.0)) } else { value });
    });
    if has_lateral {
        text.block("lateral");
        text.unverified();
        text.word("form", "unprimed");
        text.word("positive_aileron", if of(&lateral, "Lda") < 0.0 { "rolls left" } else { "rolls right" });
        text.word("positive_rudder", if of(&lateral, "Ndr") > 0.0 { "nose right" } else { "nose left" });
        lateral.iter().for_each(|&(key, value)| text.optional(key, value));
    }
    sheet.review.aircraft = Some(text.finish());
    Ok(())
}
