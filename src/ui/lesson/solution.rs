//! A solution, played as movements of sliders that can be followed, one after the other; and the way back.

use egui::Ui;

use super::Wish;
use crate::findings::Findings;
use crate::lesson::{Move, moves};
use crate::scenario::Scenario;
use crate::ui::symbol::prose;
use crate::ui::theme::{self, Palette};

/// How long a slider moves, and how long it rests before the next \[s\].
const MOVES: f64 = 1.0;
const RESTS: f64 = 0.4;

/// A solution that is being played, or has been.
#[derive(Debug)]
pub struct Played {
    /// The scene before it.
    mine: Scenario,
    /// The scene of the solution.
    solved: Scenario,
    moves: Vec<Move>,
    /// When it began \[s\]; `None` once it is at its end.
    begun: Option<f64>,
}

impl Played {
    /// Begins at the scene on screen; with reduced motion it is at its end at once.
    pub fn begin(ui: &Ui, now: &Findings, solved: Scenario) -> Self {
        let mine = now.scenario().clone();
        let moves = moves(&mine, &solved);
        let is_still = ui.style().animation_time == 0.0;
        Self {
            begun: Some(if is_still { f64::NEG_INFINITY } else { ui.input(|input| input.time) }),
            mine,
            solved,
            moves,
        }
    }

    /// The scene at this time; `None` where nothing moves any more.
    fn scene(&mut self, time: f64) -> Option<Scenario> {
        let gone = (time - self.begun?) / (MOVES + RESTS);
        if gone >= self.moves.len() as f64 {
            self.begun = None;
            return Some(self.solved.clone());
        }
        let mut scene = self.mine.clone();
        for (number, step) in self.moves.iter().enumerate() {
            let share = (gone - number as f64) * (MOVES + RESTS) / MOVES;
            if share <= 0.0 {
                break;
            }
            // Begins and ends gently.
            let share = share.min(1.0);
            step.set(&mut scene, share * share * (3.0 - 2.0 * share));
        }
        Some(scene)
    }

    /// Draws what is moved, and plays on. Gives the scene of this moment, or one's own again; says then that it is over.
    pub fn ui(&mut self, ui: &mut Ui) -> (Option<Wish>, bool) {
        let palette = Palette::of(ui);
        let time = ui.input(|input| input.time);
        let at = self.begun.map_or(f64::INFINITY, |begun| (time - begun) / (MOVES + RESTS));
        for (number, step) in self.moves.iter().enumerate() {
            let is_moving = (number as f64..number as f64 + 1.0).contains(&at);
            let mark = if is_moving {
                "▶"
            } else if at >= number as f64 + 1.0 {
                "✓"
            } else {
                "○"
            };
            let sentence = format!(
                "{mark} {}, {}",
                step.parameter.written(self.mine.convention()).symbol,
                step.in_words(&self.mine)
            );
            let color = if is_moving { palette.text } else { palette.weak };
            ui.label(prose(&sentence, theme::body(), color));
        }
        let scene = self.scene(time);
        if scene.is_some() {
            ui.request_repaint();
        }
        if ui.button("Back to my scene").clicked() {
            return (Some(Wish::Set(Box::new(self.mine.clone()))), true);
        }
        (scene.map(|scene| Wish::Set(Box::new(scene))), false)
    }
}
