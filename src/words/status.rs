//! How far the numbers of an aircraft can be trusted.

use crate::content::Status;

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
