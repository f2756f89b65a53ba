//! The aircraft that ship with the page: read from TOML in the source's own units, converted once to SI. And bare matrices
//! from elsewhere.

pub mod aircraft;
mod aircraft_file;
mod airframe_file;
pub mod import;
pub mod lessons;
mod matrix;
mod matrix_file;
mod published;
pub(crate) mod reader;
mod shape_file;
pub mod shapes;
mod text_file;
mod units;

pub use aircraft::{Aircraft, ContentError, LengthUnit, Status};
pub use aircraft_file::{edits_in, lines_with_key};
pub use matrix::MatrixFormat;
pub use text_file::{NotText, TextFile};

/// The files in the order of the chooser. To add an aircraft, add its file and its line.
pub const FILES: [(&str, &str); 18] = [
    ("navion.toml", include_str!("../../assets/aircraft/navion.toml")),
    ("lesson.toml", include_str!("../../assets/aircraft/lesson.toml")),
    ("lesson-printed.toml", include_str!("../../assets/aircraft/lesson-printed.toml")),
    ("navion-nelson.toml", include_str!("../../assets/aircraft/navion-nelson.toml")),
    ("b747-approach.toml", include_str!("../../assets/aircraft/b747-approach.toml")),
    ("b747-cruise-etkin.toml", include_str!("../../assets/aircraft/b747-cruise-etkin.toml")),
    ("b747-fc9.toml", include_str!("../../assets/aircraft/b747-fc9.toml")),
    ("b747-fc8.toml", include_str!("../../assets/aircraft/b747-fc8.toml")),
    ("b747-fc10.toml", include_str!("../../assets/aircraft/b747-fc10.toml")),
    ("b747-fc7.toml", include_str!("../../assets/aircraft/b747-fc7.toml")),
    ("a4d.toml", include_str!("../../assets/aircraft/a4d.toml")),
    ("nt33a.toml", include_str!("../../assets/aircraft/nt33a.toml")),
    ("x15.toml", include_str!("../../assets/aircraft/x15.toml")),
    ("c47.toml", include_str!("../../assets/aircraft/c47.toml")),
    ("bristol-f2b.toml", include_str!("../../assets/aircraft/bristol-f2b.toml")),
    ("cessna-172.toml", include_str!("../../assets/aircraft/cessna-172.toml")),
    ("cherokee-180.toml", include_str!("../../assets/aircraft/cherokee-180.toml")),
    ("citation.toml", include_str!("../../assets/aircraft/citation.toml")),
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
