//! Figures for paper, as SVG: as wide as the text of a page, in the colours of the light page, with words as outlines.
//!
//! | file | in one line |
//! |---|---|
//! | `ink` | colours, and how a number of the drawing is written |
//! | `letters` | words as outlines |
//! | `plot` | a frame with round numbers on its axes, curves, and the document around it |
//! | `poles` | the pole map |
//! | `response` | the motion over time |
//! | `frequency` | gain and phase over frequency |
//! | `chart` | a measure over a slider |
//! | `aircraft` | the aircraft |

mod aircraft;
mod chart;
mod frequency;
mod ink;
mod letters;
mod plot;
mod poles;
mod response;

use crate::findings::Findings;
use crate::words;

pub(super) use aircraft::aircraft;
pub(super) use chart::chart;
pub(super) use frequency::frequency;
pub(super) use letters::without_outline;
pub(super) use poles::poles;
pub(super) use response::{plain, response};

/// What flies, below the title of a figure, where that is not the aircraft alone: "…, under the law".
fn how(findings: &Findings) -> String {
    if findings.poles_of_other().is_empty() {
        return String::new();
    }
    let [shown, _] = words::feedback::legend(findings.is_opened(), findings.is_fed_back());
    format!(", {shown}")
}
