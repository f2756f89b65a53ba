//! How far the numbers of an aircraft can be trusted.

use crate::content::Status;
use crate::flight::aircraft::plane::Plane;

/// The status of an aircraft's data as a mark; of an aircraft that has been changed its file's status says nothing any more.
pub const fn mark(status: Status, is_edited: bool) -> &'static str {
    match (status, is_edited) {
        (_, true) => "modified",
        (Status::Verified, false) => "✓ verified",
        (Status::Unverified, false) => "unverified",
    }
}

/// The status of an aircraft in a sentence.
pub fn sentence(name: &str, status: Status, is_edited: bool) -> String {
    match (status, is_edited) {
        (Status::Verified, false) => "verified".to_owned(),
        (Status::Unverified, false) => "unverified".to_owned(),
        (Status::Verified, true) => format!("modified from {name}, which is verified as its file has it"),
        (Status::Unverified, true) => format!("modified from {name}, which is unverified"),
    }
}

/// The sheet of an aircraft's source.
pub const SHEET: &str = "Source and remarks";

/// The source on the sheet.
pub const SOURCE: &str = "Source";

/// The remarks on the sheet.
pub const REMARKS: &str = "Remarks";

/// The sheet of an aircraft that has been changed.
pub const OF_FILE: &str = "It is modified here. What follows is said of its file.";

/// The status of one plane of motion.
pub const fn of_plane(plane: Plane, status: Status) -> &'static str {
    match (plane, status) {
        (Plane::Longitudinal, Status::Verified) => "Longitudinal motion: verified",
        (Plane::Longitudinal, Status::Unverified) => "Longitudinal motion: unverified",
        (Plane::Lateral, Status::Verified) => "Lateral–directional motion: verified",
        (Plane::Lateral, Status::Unverified) => "Lateral–directional motion: unverified",
    }
}

/// The mark as a button that opens the sheet, for a screen reader.
pub const fn button(status: Status, is_edited: bool) -> &'static str {
    match (status, is_edited) {
        (_, true) => "modified: source and remarks",
        (Status::Verified, false) => "✓ verified: source and remarks",
        (Status::Unverified, false) => "unverified: source and remarks",
    }
}

/// The reason of a status; of an aircraft that has been changed, with what it was changed from.
pub fn reason(name: &str, status: Status, reason: &str, is_edited: bool) -> String {
    match (status, is_edited) {
        (_, false) => reason.to_owned(),
        (Status::Verified, true) => {
            format!("This is modified from {name}, which is verified as its file has it. {reason}")
        }
        (Status::Unverified, true) => format!("This is modified from {name}, which is unverified. {reason}"),
    }
}
