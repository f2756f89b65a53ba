//! The stage: what of the page is on. A workbench has everything; a lesson's step, a slide or an embedded frame has what it is about.

use crate::key::keys;

/// What of the page is on.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Stage {
    /// The parts that are on, in the order of [`Part::VALUES`](crate::key::Keyed::VALUES); all where it is empty.
    parts: Vec<Part>,
    /// Keys of the parameters that are offered as sliders, in the order of the table; all where it is empty.
    pub offered: Vec<&'static str>,
}

/// A part of the page that can be on or off.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Part {
    /// The sliders.
    Derivatives,
    /// The pole map.
    Poles,
    /// The aircraft in flight.
    Aircraft,
    /// The responses.
    Response,
    /// The verdicts, and the cards of the modes.
    Modes,
}

keys! {
    Part {
        Derivatives => "derivatives",
        Poles => "poles",
        Aircraft => "aircraft",
        Response => "response",
        Modes => "modes",
    }
}

impl Stage {
    /// A stage with these parts on; with everything where there are none.
    pub fn with(mut parts: Vec<Part>) -> Self {
        parts.sort();
        parts.dedup();
        Self { parts, ..Self::default() }
    }

    /// The parts that were named; none where everything is on.
    pub fn parts(&self) -> &[Part] {
        &self.parts
    }

    /// Whether a part is on.
    pub fn has(&self, part: Part) -> bool {
        self.parts.is_empty() || self.parts.contains(&part)
    }

    /// Whether a parameter is offered, by its key.
    pub fn offers(&self, key: &str) -> bool {
        self.offered.is_empty() || self.offered.contains(&key)
    }
}
