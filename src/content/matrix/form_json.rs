//! Matrices as JSON. What a program adds that says nothing of the motion is passed over; a key that isn't known is told, since it may be
//! a setting with a slip of the pen.

use serde::Deserialize;
use serde::de::IgnoredAny;

use super::draft::{At, Draft, Entry, Problem};

#[derive(Default, Deserialize)]
#[serde(deny_unknown_fields, default)]
struct Form {
    units: Option<String>,
    angles: Option<String>,
    #[serde(alias = "V")]
    speed: Option<f64>,
    #[serde(alias = "U0")]
    u0: Option<f64>,
    alpha0_deg: Option<f64>,
    gamma0_deg: Option<f64>,
    #[serde(alias = "title")]
    name: Option<String>,
    #[serde(alias = "state_names")]
    states: Option<Vec<String>>,
    #[serde(alias = "input_names")]
    inputs: Option<Vec<String>>,
    #[serde(rename = "A")]
    a: Option<Vec<Vec<f64>>>,
    #[serde(rename = "B")]
    b: Option<Vec<Vec<f64>>>,
    #[serde(rename = "C")]
    _c: IgnoredAny,
    #[serde(rename = "D")]
    _d: IgnoredAny,
    #[serde(rename = "outputs", alias = "output_names")]
    _outputs: IgnoredAny,
    #[serde(rename = "description", alias = "comment")]
    _description: IgnoredAny,
    #[serde(rename = "source")]
    _source: IgnoredAny,
}

pub(in crate::content) fn read(text: &str) -> Result<Draft, Problem> {
    let form: Form = serde_json::from_str(text).map_err(|error| (error.line().max(1), said_by(&error)))?;
    let line = |key: &str| {
        let quoted = format!("\"{key}\"");
        text.lines().position(|line| line.contains(&quoted)).map_or(1, |k| k + 1)
    };
    let rows = |key: &str, rows: Vec<Vec<f64>>| {
        let line = line(key);
        Entry::Rows(rows.into_iter().map(|value| At { line, value }).collect())
    };
    let entries = [
        ("units", form.units.map(Entry::Text)),
        ("angles", form.angles.map(Entry::Text)),
        ("speed", form.speed.map(Entry::Number)),
        ("u0", form.u0.map(Entry::Number)),
        ("alpha0_deg", form.alpha0_deg.map(Entry::Number)),
        ("gamma0_deg", form.gamma0_deg.map(Entry::Number)),
        ("name", form.name.map(Entry::Text)),
        ("states", form.states.map(Entry::Names)),
        ("inputs", form.inputs.map(Entry::Names)),
        ("A", form.a.map(|a| rows("A", a))),
        ("B", form.b.map(|b| rows("B", b))),
    ];
    let mut draft = Draft::default();
    for (key, entry) in entries {
        if let Some(entry) = entry {
            draft.set(key, line(key), entry)?;
        }
    }
    Ok(draft)
}

/// The reader's own words without its "at line 3 column 7", for the line stands in front already, and in words of people.
fn said_by(error: &serde_json::Error) -> String {
    let text = error.to_string();
    let text = text.split(" at line ").next().unwrap_or_default();
    if let Some(key) = text.strip_prefix("unknown field `").and_then(|rest| rest.split('`').next()) {
        return format!(
            "\"{key}\" is no key known here; expected units, angles, speed or u0, alpha0_deg, gamma0_deg, name, states, inputs, A and B"
        );
    }
    text.replace("expected f64", "expected a number").replace("expected a sequence", "expected a list")
}
