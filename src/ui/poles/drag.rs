//! A pole under the hand: what holds it, where it is wanted, and what came of it.

use std::fmt::Display;
use std::rc::Rc;

use egui::Vec2;
use nalgebra::Complex;

use crate::findings::{Findings, PlacementError};
use crate::flight::modes::mode::Mode;
use crate::flight::modes::mode_name::ModeName;
use crate::scenario::{Page, Scenario};
use crate::ui::chart::Chart;
use crate::ui::curtain::Curtain;
use crate::words;

/// The move of a pole by a person's hand in this frame.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum DragPhase {
    /// Nothing.
    #[default]
    Away,
    /// Takes hold of it; it has not moved yet.
    Takes,
    /// Holds it.
    Holds,
    /// Lets it go.
    LetsGo,
}

/// A pole that is held.
#[derive(Debug)]
pub struct DraggedPole {
    /// Which of the maps it is held on.
    pub map: usize,
    /// The aircraft when it was taken: every place is solved for from there, so that the way makes no difference.
    pub start: Rc<Findings>,
    /// Its mode then.
    pub mode: Mode,
    /// Keys of what may move.
    pub movers: Vec<&'static str>,
    /// The page that they are on.
    pub page: Page,
    /// From the pole to the pointer when it was taken.
    pub grip: Vec2,
    /// Whether the lower one of the pair is held.
    pub lower: bool,
    /// Where it was wanted last, in the upper half.
    pub wanted: Option<Complex<f64>>,
}

impl DraggedPole {
    /// Where the pointer wants it \[1/s\], in the upper half; a real root stays on the axis.
    pub fn wanted(&self, chart: &Chart, pointer: egui::Pos2) -> Complex<f64> {
        let at: Complex<f64> = chart.at(pointer - self.grip).into();
        if self.mode.is_oscillatory() {
            // Across the real axis lies the conjugate.
            Complex::new(at.re, if self.lower { (-at.im).max(0.0) } else { at.im.max(0.0) })
        } else {
            Complex::from(at.re)
        }
    }

    /// The end that is held of a pair.
    pub fn side(&self, lambda: Complex<f64>) -> Complex<f64> {
        if self.lower { lambda.conj() } else { lambda }
    }
}

/// What came of the last move.
#[derive(Debug)]
pub struct Outcome {
    /// Whose pole.
    pub name: ModeName,
    /// Why it is not where it was wanted.
    pub obstacle: Option<String>,
    /// Where it is \[1/s\].
    pub lambda: Complex<f64>,
    /// Where it was wanted \[1/s\].
    pub wanted: Complex<f64>,
}

/// Moves the pole of `mode` by what may move on a page, by name and sentence.
pub fn place(
    findings: &Findings,
    mode: &Mode,
    wanted: Complex<f64>,
    (movers, page): (&[&str], Page),
) -> (Option<Scenario>, Outcome) {
    let name = mode.naming.name;
    let in_notation = |reason: &dyn Display| {
        words::notation::prose(&reason.to_string(), findings.scenario().notation).into_owned()
    };
    let placed = match page {
        Page::Feedback if findings.is_opened() && findings.closed_loop().is_some() => {
            Err(PlacementError::ShownOpen)
        }
        Page::Feedback if movers.is_empty() => Err(PlacementError::NoGainChosen),
        _ => findings.place_pole(mode, wanted, movers),
    };
    match placed {
        Ok(placed) => {
            let obstacle = placed.obstacle.map(|obstacle| in_notation(&obstacle));
            let outcome = Outcome { name, obstacle, lambda: placed.lambda, wanted: placed.wanted };
            (Some(placed.scenario), outcome)
        }
        Err(error) => {
            (None, Outcome { name, obstacle: Some(in_notation(&error)), lambda: mode.lambda, wanted })
        }
    }
}

impl Outcome {
    /// Why it is not there, in a sentence.
    pub fn sentence(&self, curtain: &Curtain) -> Option<String> {
        let obstacle = self.obstacle.as_ref()?;
        Some(format!("{} can’t follow: {obstacle}.", curtain.title(self.name)))
    }
}
