//! What is followed along the way: a parameter, and a mode of either end.

use crate::flight::analysis::PlaneAnalysis;
use crate::flight::modes::mode::Mode;
use crate::flight::modes::mode_name::ModeName;
use crate::flight::modes::second_order::{DUTCH_ROLL, PHUGOID, SHORT_PERIOD, second_order};
use crate::scenario::Scenario;

/// A parameter before and after \[SI\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moved {
    /// Its key, or that of a ratio of inertias.
    pub key: &'static str,
    /// Before.
    pub from: f64,
    /// After.
    pub to: f64,
}

/// One end of a change.
#[derive(Clone, Copy, Debug)]
pub(super) struct Side<'a> {
    pub plane: &'a PlaneAnalysis,
    pub scenario: &'a Scenario,
}

impl Side<'_> {
    pub fn find(&self, name: ModeName) -> Option<&Mode> {
        find(&self.plane.modes, name)
    }
}

/// What is followed along the way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Subject {
    /// An oscillation, or the two real roots that it parts into.
    Pair([ModeName; 3]),
    /// A real root.
    Root(ModeName),
}

impl Subject {
    /// Of a mode as it is now; `None` where there was none of that kind.
    pub fn of(mode: &Mode, [before, after]: [&[Mode]; 2]) -> Option<Self> {
        let name = mode.naming.name;
        let was = before.iter().find(|other| other.naming.name == name);
        if let Some(was) = was
            && was.is_oscillatory() == mode.is_oscillatory()
        {
            return Some(if mode.is_oscillatory() { Self::Pair(family(name)) } else { Self::Root(name) });
        }
        let family = family(name);
        second_order(before, family).and(second_order(after, family)).map(|_| Self::Pair(family))
    }
}

/// The names of an oscillation and of the roots it parts into.
fn family(name: ModeName) -> [ModeName; 3] {
    let families = [SHORT_PERIOD, PHUGOID, DUTCH_ROLL];
    families.into_iter().find(|family| family.contains(&name)).unwrap_or([name; 3])
}

pub(super) fn find(modes: &[Mode], name: ModeName) -> Option<&Mode> {
    modes.iter().find(|mode| mode.naming.name == name)
}
