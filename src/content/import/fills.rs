//! What a person has typed into the fields of a review: keys and values as text.

use std::collections::{BTreeMap, BTreeSet};

use super::quantities::quantity;
use crate::content::matrix::draft::number;

/// A value that stands for what the review itself suggests.
const SUGGESTED: &str = "suggested";

/// The key under which every suggestion is taken at once.
const ALL: &str = "all";

/// The keys of choices and names; other fields are numbers.
pub(super) const CHOICES: [&str; 9] =
    ["units", "angles", "states", "inputs", "length_unit", "control_unit", "sideslip_row", "basis", "case"];

/// The values that were typed, and which of them something has asked for.
#[derive(Clone, Debug, Default)]
pub(super) struct Fills {
    given: BTreeMap<String, String>,
    used: BTreeSet<String>,
    /// The keys whose suggestions were taken, one by one.
    taken: BTreeSet<String>,
    all_suggested: bool,
}

/// One of a unit in SI: the SI unit of the quantities that it is one of, its name, its size.
const UNITS: [(&str, &str, f64); 26] = [
    ("kg", "g", 1e-3),
    ("kg", "lb", 0.453_592_37),
    ("kg", "slug", 14.593_902_937_206_364),
    ("kg", "t", 1000.0),
    ("m", "ft", 0.3048),
    ("m", "in", 0.0254),
    ("m", "cm", 0.01),
    ("m", "mm", 0.001),
    ("m", "km", 1000.0),
    ("m²", "ft2", 0.092_903_04),
    ("m²", "ft²", 0.092_903_04),
    ("m²", "m2", 1.0),
    ("m/s", "ft/s", 0.3048),
    ("m/s", "kt", 0.514_444_444_444_444_4),
    ("m/s", "kts", 0.514_444_444_444_444_4),
    ("m/s", "km/h", 1.0 / 3.6),
    ("m/s", "mph", 0.447_04),
    ("kg m²", "slug ft2", 1.355_817_948_331_4),
    ("kg m²", "slug ft²", 1.355_817_948_331_4),
    ("kg m²", "kg m2", 1.0),
    ("kg/m³", "slug/ft3", 515.378_818_393_194),
    ("kg/m³", "slug/ft³", 515.378_818_393_194),
    ("kg/m³", "kg/m3", 1.0),
    ("°", "deg", 1.0),
    ("°", "rad", 180.0 / std::f64::consts::PI),
    ("m/s²", "ft/s2", 0.3048),
];

/// The size of a unit in that of a quantity; `None` for one that isn't known here.
pub(super) fn factor(of: &str, name: &str) -> Option<f64> {
    let is_it = |(unit, known, _): &&(&str, &str, f64)| *unit == of && *known == name;
    if name == of { Some(1.0) } else { UNITS.iter().find(is_it).map(|&(_, _, factor)| factor) }
}

impl Fills {
    pub fn new(given: &BTreeMap<String, String>) -> Result<Self, String> {
        let mut given: BTreeMap<String, String> =
            given.iter().map(|(key, value)| (key.trim().to_owned(), value.trim().to_owned())).collect();
        let all_suggested = match given.remove(ALL) {
            Some(value) if value == SUGGESTED => true,
            Some(value) => return Err(format!("{ALL}: expected “{SUGGESTED}”, found “{value}”")),
            None => false,
        };
        Ok(Self { given, all_suggested, ..Self::default() })
    }

    /// The text of a key, unless it stands for the suggestion.
    pub fn text(&mut self, key: &str) -> Option<String> {
        let text = self.given.get(key)?;
        self.used.insert(key.to_owned());
        (text != SUGGESTED).then(|| text.clone())
    }

    /// Whether what is suggested for a key is taken; asked only where something is.
    pub fn takes_suggestion(&mut self, key: &str) -> bool {
        let is_given = self.given.get(key).is_some_and(|value| value == SUGGESTED);
        if is_given {
            self.taken.insert(key.to_owned());
        }
        is_given || self.all_suggested
    }

    /// The number of a key in SI, with a unit behind it or in `unit`.
    pub fn number(&mut self, key: &str, unit: &str) -> Result<Option<f64>, String> {
        let Some(text) = self.text(key) else { return Ok(None) };
        let plain = text.replace('−', "-");
        let end = plain
            .char_indices()
            .find(|&(at, c)| {
                let is_exponent = matches!(c, 'e' | 'E')
                    && plain[at + 1..]
                        .starts_with(|next: char| next.is_ascii_digit() || matches!(next, '+' | '-'));
                !(c.is_ascii_digit() || matches!(c, '.' | ',' | '+' | '-') || is_exponent)
            })
            .map_or(plain.len(), |(at, _)| at);
        let (digits, behind) = (plain[..end].trim().replace(',', "."), plain[end..].trim());
        let factor = if behind.is_empty() { Some(1.0) } else { factor(unit, behind) };
        match (number(&digits), factor) {
            (Some(x), Some(factor)) if x.is_finite() => Ok(Some(x * factor)),
            (Some(_), None) => {
                Err(format!("{key}: {behind} is not a unit known here; expected a number in {unit}"))
            }
            _ => Err(format!("{key}: expected a number, found “{text}”")),
        }
    }

    /// A key that nothing asked for: one that nothing could, and any once the review has asked for everything.
    pub fn stranger(&self, is_whole: bool) -> Option<&str> {
        let is_known =
            |key: &str| CHOICES.contains(&key) || key.starts_with("ConGrp") || quantity(key).is_some();
        let mut unused = self.given.keys().map(String::as_str).filter(|key| !self.used.contains(*key));
        unused.find(|key| is_whole || !is_known(key))
    }

    /// A key whose suggestion was to be taken, where nothing was suggested.
    pub fn without_suggestion(&self) -> Option<&str> {
        let is_it = |(key, value): &(&String, &String)| *value == SUGGESTED && !self.taken.contains(*key);
        self.given.iter().find(is_it).map(|(key, _)| key.as_str())
    }
}
