//! The shapes that ship with the page, each used by one aircraft or several.

use super::reader::ContentError;
use crate::shape::Shape;

/// The files by the name that an aircraft's file gives them. To add a shape, add its file and its line.
pub const SHAPES: [(&str, &str); 11] = [
    ("a4d", include_str!("../../assets/shapes/a4d.toml")),
    ("b747", include_str!("../../assets/shapes/b747.toml")),
    ("bristol-f2b", include_str!("../../assets/shapes/bristol-f2b.toml")),
    ("c47", include_str!("../../assets/shapes/c47.toml")),
    ("cessna-172", include_str!("../../assets/shapes/cessna-172.toml")),
    ("cherokee-180", include_str!("../../assets/shapes/cherokee-180.toml")),
    ("citation", include_str!("../../assets/shapes/citation.toml")),
    ("navion", include_str!("../../assets/shapes/navion.toml")),
    ("nt33a", include_str!("../../assets/shapes/nt33a.toml")),
    ("trainer", include_str!("../../assets/shapes/trainer.toml")),
    ("x15", include_str!("../../assets/shapes/x15.toml")),
];

/// The shape of an aircraft of which nothing is known.
pub const USUAL_SHAPE: &str = "trainer";

/// Reads a shape that ships; `None` where there is none of that name.
pub fn embedded_shape(key: &str) -> Option<Result<Shape, ContentError>> {
    let (key, text) = SHAPES.iter().find(|(known, _)| *known == key)?;
    Some(Shape::from_toml(&format!("{key}.toml"), text))
}
