//! The level of an aircraft as a whole: it is as good as its worst criterion.

use super::handling_qualities::{Level, Verdict};
use crate::flight::modes::mode::Mode;
use crate::flight::modes::mode_name::ModeName;
use crate::flight::modes::stability::Stability;

/// The worst level, and the criterion that governs it.
#[derive(Clone, Debug, PartialEq)]
pub struct OverallLevel<'a> {
    /// The worst level of all criteria; `None` where something grows that no paragraph here judges, and the rest isn't the worst
    /// already: then no level can be told.
    pub level: Option<Level>,
    /// The verdict that has it; of several the first.
    pub governing: &'a Verdict,
    /// Names of the modes that grow and that no paragraph here judges.
    pub unjudged: Vec<ModeName>,
}

/// The overall level of the verdicts and modes of each plane; `None` where nothing is judged.
pub fn overall_level<'a>(
    planes: impl Iterator<Item = (&'a [Verdict], &'a [Mode])>,
) -> Option<OverallLevel<'a>> {
    let mut overall: Option<(Level, &Verdict)> = None;
    let mut unjudged = Vec::new();
    for (verdicts, modes) in planes {
        for verdict in verdicts {
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
    let level = (unjudged.is_empty() || worst == Level::Beyond).then_some(worst);
    Some(OverallLevel { level, governing, unjudged })
}
