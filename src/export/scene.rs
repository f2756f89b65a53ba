//! The scene that a request is about: an aircraft as it is set, or all that a link holds.

use std::sync::Arc;

use super::error::ExportError;
use crate::content::{Aircraft, FILES, edits_in, embedded_aircraft};
use crate::key::nearest;
use crate::scenario::link::{self, LessonPlace, Notice, Opened};
use crate::scenario::{Parameter, Scenario, View, parameters};

/// An aircraft as it is set, its disturbance, and how it is looked at. Of a link all this is what a request begins with.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// The scenario.
    pub scenario: Scenario,
    /// The state pinned beside it.
    pub pinned: Option<Scenario>,
    /// How it is looked at.
    pub view: View,
    /// The lesson that is open beside it.
    pub lesson: Option<LessonPlace>,
    /// What of a link can't be used, in sentences; none without a link.
    pub notices: Vec<String>,
    /// Address of the page before the `#` of a link; empty where nobody told one.
    pub(super) address: String,
    /// The text of the aircraft's file; `None` for bare matrices.
    pub(super) file: Option<String>,
    /// The sizes of disturbances that the request itself sets: one that its disturbance doesn't have is refused, while a link keeps
    /// those of every disturbance.
    pub(super) sizes: Vec<&'static Parameter>,
}

/// A scenario as the page opens it.
impl From<Scenario> for Scene {
    fn from(scenario: Scenario) -> Self {
        let sizes = parameters().filter(|p| p.is_of_disturbance() && p.is_edited(&scenario)).collect();
        let view = View::of(&scenario);
        let address = String::new();
        Self { scenario, pinned: None, view, lesson: None, notices: Vec::new(), address, file: None, sizes }
    }
}

impl Scene {
    /// The scene that a link leads to. Another aircraft than the one it names would answer wrongly, so one that isn't there is an
    /// error; all else that can't be used is left out with a notice. `own` is the text of an aircraft that is too long for the link,
    /// which names it by its key.
    pub(super) fn of_link(text: &str, own: Option<&str>) -> Result<Self, ExportError> {
        let no_link = || {
            let found: String = text.chars().take(40).collect();
            let problem = format!("expected a link such as \"#v=1&ac=navion&speed=60\", found \"{found}\"");
            ExportError::Request(problem)
        };
        if !link::is_link(text) {
            return Err(no_link());
        }
        let mut aircraft: Vec<Arc<Aircraft>> = embedded_aircraft().0.into_iter().map(Arc::new).collect();
        if let Some(own) = own {
            aircraft.push(Arc::new(Aircraft::own("aircraft.toml", own)?));
        }
        let Opened { scenario, pinned, view, lesson, handed_in: _, notices, units: _, notation: _ } =
            link::read(text, &aircraft).ok_or_else(no_link)?;
        let unknown = notices.iter().find_map(|notice| match notice {
            Notice::Aircraft { key, .. } => Some(key.clone()),
            _ => None,
        });
        if let Some(broken) = notices.iter().find(|notice| matches!(notice, Notice::Own { .. })) {
            return Err(ExportError::Request(broken.to_string()));
        }
        if let Some(name) = unknown {
            let nearest = nearest(&name, aircraft.iter().map(|aircraft| aircraft.key.as_str()));
            return Err(ExportError::UnknownAircraft { name, nearest });
        }
        let notices = notices.iter().map(ToString::to_string).collect();
        let own = scenario.aircraft.own.as_deref();
        let file = own.or_else(|| listed(&scenario.aircraft.key)).map(str::to_owned);
        let address = text.split_once('#').map_or("", |(address, _)| address.trim()).to_owned();
        Ok(Self { scenario, pinned, view, lesson, notices, address, file, sizes: Vec::new() })
    }

    /// The scene of an aircraft file, with what was changed there.
    pub(super) fn of_file(aircraft: Aircraft, text: &str) -> Self {
        let mut scenario = Scenario::new(Arc::new(aircraft));
        let notices = edits_in(text).map_or_else(Vec::new, |edits| link::edit(&mut scenario, &edits));
        let notices = notices.iter().map(ToString::to_string).collect();
        Self { notices, file: Some(text.to_owned()), ..scenario.into() }
    }

    /// The scene as a link, behind the address of the page where that is known; `None` where a link can't hold it.
    pub(super) fn link(&self) -> Option<String> {
        let link = || link::write(&self.scenario, &self.view, self.pinned.as_ref());
        self.has_link().then(|| format!("{}#{}", self.address, link()))
    }

    /// Whether a link can hold it: its aircraft is one of the list, or a person's own that isn't too long for one.
    pub(super) fn has_link(&self) -> bool {
        let aircraft = &self.scenario.aircraft;
        let is_listed = self.file.is_some() && self.file.as_deref() == listed(&aircraft.key);
        is_listed || link::own::written(aircraft).is_some()
    }
}

/// The text of a file of the list.
fn listed(key: &str) -> Option<&'static str> {
    FILES.iter().find(|(file, _)| file.strip_suffix(".toml") == Some(key)).map(|(_, text)| *text)
}
