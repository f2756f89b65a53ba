//! The lessons that ship, as text; `lesson` reads them.

/// Lessons: name of the file and text, in the order in which they are offered.
pub const LESSONS: [(&str, &str); 6] = [
    ("frames.md", include_str!("../../assets/lessons/frames.md")),
    ("forces.md", include_str!("../../assets/lessons/forces.md")),
    ("longitudinal.md", include_str!("../../assets/lessons/longitudinal.md")),
    ("lateral.md", include_str!("../../assets/lessons/lateral.md")),
    ("workshop.md", include_str!("../../assets/lessons/workshop.md")),
    ("hangar.md", include_str!("../../assets/lessons/hangar.md")),
];

/// The glossary of all lessons.
pub const GLOSSARY: &str = include_str!("../../assets/lessons/glossary.toml");

/// The references of all lessons.
pub const REFERENCES: &str = include_str!("../../assets/lessons/references.toml");
