//! The level of an aircraft as a whole: it is as good as its worst criterion.

use super::handling_qualities::{Level, Verdict};
use crate::flight::modes::mode::Mode;
use crate::flight::modes::mode_name::ModeName;
use crate::flight::modes::stability::Stability;

/// The worst level, and the criterion that governs it.
#[derive(Clone, Debug, PartialEq)]
pub struct OverallLevel<'a> {
    /// The worst level of all criteria; `None` where flight has something in it that no paragraph here judges, and the rest isn't the
    /// worst already: then no level can be told.
    pub level: Option<Level>,
    /// The verdict that has it; of several the first.
    pub governing: &'a Verdict,
    /// Names of the modes that no paragraph here judges: those that grow, and oscillations of the aircraft.
    pub unjudged: Vec<ModeName>,
    /// Why no level can be told, where nothing grows unjudged.
    pub left_open: Option<&'a Verdict>,
}

/// The overall level of the verdicts and modes of each plane; `None` where nothing is judged.
pub fn overall_level<'a>(
    planes: impl Iterator<Item = (&'a [Verdict], &'a [Mode])>,
) -> Option<OverallLevel<'a>> {
    let mut overall: Option<(Level, &Verdict)> = None;
    let mut unjudged = Vec::new();
    let mut left_open = None;
    for (verdicts, modes) in planes {
        for verdict in verdicts {
            if verdict.leaves_open() {
                left_open = left_open.or(Some(verdict));
            }
            if let Some(level) = verdict.level
                && overall.is_none_or(|(worst, _)| level > worst)
            {
                overall = Some((level, verdict));
            }
        }
        let is_judged =
            |name: ModeName| verdicts.iter().any(|v| v.level.is_some() && v.modes.contains(&name));
        let growing = modes.iter().filter(|mode| mode.stability == Stability::Unstable);
        unjudged.extend(growing.map(|mode| mode.naming.name).filter(|name| !is_judged(*name)));
    }
    let (worst, governing) = overall?;
    let left_open = left_open.filter(|_| unjudged.is_empty());
    unjudged.extend(left_open.iter().flat_map(|verdict| verdict.modes.iter().copied()));
    let is_told = worst == Level::Beyond || (unjudged.is_empty() && left_open.is_none());
    Some(OverallLevel { level: is_told.then_some(worst), governing, unjudged, left_open })
}
