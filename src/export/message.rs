//! Messages between the page in a frame and the page around it: `docs/EMBEDDING.md` lists them.

use serde::Serialize;
use serde_json::Value;

use super::Event;
use crate::key::{Keyed as _, nearest};
use crate::lesson::Records;
use crate::scenario::view::Look;

/// A message to the page around the frame.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Message {
    /// Version of the protocol.
    #[cfg_attr(test, ts(type = "1"))]
    eigenwing: u64,
    #[serde(flatten)]
    event: Event,
}

impl Message {
    /// The version of the protocol that this is.
    pub const VERSION: u64 = 1;

    /// What has happened, as a message.
    pub const fn new(event: Event) -> Self {
        Self { eigenwing: Self::VERSION, event }
    }

    /// As JSON.
    pub fn to_json(&self) -> String {
        // Every key is text and every number finite, so there is nothing that JSON can't say.
        serde_json::to_string(self).unwrap_or_default()
    }
}

/// What the page around the frame asks for.
#[derive(Clone, Debug, PartialEq)]
pub enum Request {
    /// Open a scene, or a lesson.
    Open(String),
    /// Look so; with `None` as the person has chosen, or their system has it.
    Look(Option<Look>),
    /// Tell what the person has done in their lessons.
    AskReport,
    /// Go on with what the person has done elsewhere.
    TakeUp(Box<Records>),
}

/// The types of requests.
const TYPES: [&str; 4] = ["open", "look", "ask-report", "take-up"];

impl Request {
    /// Out of JSON. `None` is a message of others, which is none of ours; an error is one sentence.
    pub fn read(json: &str) -> Option<Result<Self, String>> {
        let message: Value = serde_json::from_str(json).ok()?;
        let version = message.get("eigenwing")?;
        Some(if version.as_u64() == Some(Message::VERSION) {
            Self::of(&message)
        } else {
            Err(format!("Expected \"eigenwing\": {}, found {version}.", Message::VERSION))
        })
    }

    fn of(message: &Value) -> Result<Self, String> {
        let text = |key: &str| {
            let found = message.get(key).and_then(Value::as_str);
            found.ok_or_else(|| format!("Expected \"{key}\" as text."))
        };
        let kind = text("type")?;
        match kind {
            "open" => Ok(Self::Open(text("link")?.to_owned())),
            "look" => match text("look")? {
                SYSTEM => Ok(Self::Look(None)),
                word => Look::by_key(word)
                    .map(|look| Self::Look(Some(look)))
                    .ok_or_else(|| "Expected \"look\" as light, dark, projector or system.".to_owned()),
            },
            "ask-report" => Ok(Self::AskReport),
            "take-up" => {
                let records = message.get("records").ok_or("Expected \"records\" of a report.")?;
                let records = Records::read(&records.to_string());
                records
                    .map(|records| Self::TakeUp(Box::new(records)))
                    .map_err(|error| format!("These are no records of a report: {error}."))
            }
            _ => {
                let meant = nearest(kind, TYPES.into_iter());
                let meant = meant.map_or_else(
                    || format!("Expected {}.", TYPES.join(", ")),
                    |meant| format!("Is {meant} meant?"),
                );
                Err(format!("No message is of this type. {meant}"))
            }
        }
    }
}

/// Word for the look that the person has without the page around the frame.
const SYSTEM: &str = "system";
