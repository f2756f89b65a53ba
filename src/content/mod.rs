//! The aircraft that ship with the page: read from TOML in the source's own units, converted once to SI.

pub mod aircraft;
mod aircraft_file;
mod airframe_file;
mod published;
mod reader;
mod units;

pub use aircraft::{Aircraft, ContentError, LengthUnit, Status};

/// The files in the order of the chooser. To add an aircraft, add its file and its line.
pub const FILES: [(&str, &str); 3] = [
    ("navion.toml", include_str!("../../assets/aircraft/navion.toml")),
    ("lesson.toml", include_str!("../../assets/aircraft/lesson.toml")),
    ("lesson-printed.toml", include_str!("../../assets/aircraft/lesson-printed.toml")),
];

/// Reads every aircraft that ships; a file that can't be read gives its error and the rest still load.
pub fn embedded_aircraft() -> (Vec<Aircraft>, Vec<ContentError>) {
    let (mut aircraft, mut errors) = (Vec::new(), Vec::new());
    for (file, text) in FILES {
        match Aircraft::from_toml(file, text) {
            Ok(read) => aircraft.push(read),
            Err(error) => errors.push(error),
        }
    }
    (aircraft, errors)
}
