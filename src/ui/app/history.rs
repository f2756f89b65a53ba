//! Undo and redo: what a person has done, in steps.

use std::sync::Arc;

use egui::Ui;
use egui::util::undoer::Undoer;

use super::Pinned;
use crate::scenario::Scenario;
use crate::ui::poles::DragPhase;

/// The steps that a person has gone.
#[derive(Debug, Default)]
pub(super) struct History(Undoer<Scene>);

impl History {
    /// Ends a step with the scene as it stands: what comes next is another.
    pub fn end_step(&mut self, scene: &Scene) {
        self.0.add_undo(scene);
    }

    /// Makes a step of the scene as it stands. What was undone before it can't be done again.
    pub fn keep(&mut self, ui: &Ui, scene: &Scene) {
        self.0.feed_state(ui.input(|input| input.time), scene);
        self.0.add_undo(scene);
    }

    /// Takes note of the scene at the end of a frame. A drag is one step, however long it is held still.
    pub fn settle(&mut self, ui: &Ui, hand: DragPhase, scene: &Scene) {
        let (is_held, is_let_go) = ui.input(|input| (input.pointer.any_down(), input.pointer.any_released()));
        match hand {
            _ if is_let_go => self.keep(ui, scene),
            DragPhase::LetsGo => self.keep(ui, scene),
            DragPhase::Takes | DragPhase::Holds => {}
            DragPhase::Away if is_held => {}
            DragPhase::Away => self.0.feed_state(ui.input(|input| input.time), scene),
        }
    }

    /// Whether there is a step to go back from a scene.
    pub fn has_undo(&self, scene: &Scene) -> bool {
        self.0.has_undo(scene)
    }

    /// Whether there is a step to go forward from it.
    pub fn has_redo(&self, scene: &Scene) -> bool {
        self.0.has_redo(scene)
    }

    /// The scene a step back from another.
    pub fn undo(&mut self, scene: &Scene) -> Option<Scene> {
        self.0.undo(scene).cloned()
    }

    /// The scene a step forward.
    pub fn redo(&mut self, scene: &Scene) -> Option<Scene> {
        self.0.redo(scene).cloned()
    }
}

/// The scene that undo brings back: everything that a person does, but not how they look at it.
#[derive(Clone)]
pub(super) struct Scene {
    pub scenario: Scenario,
    pub pinned: Option<Arc<Pinned>>,
}

impl PartialEq for Scene {
    /// A time shown that follows is nothing that a person has done: it may differ.
    fn eq(&self, other: &Self) -> bool {
        let (a, b) = (&self.scenario, &other.scenario);
        let follow = a.disturbance.follows && b.disturbance.follows;
        let same = a == b
            || follow && {
                let mut a = a.clone();
                a.disturbance.sizes.time = b.disturbance.sizes.time;
                a == *b
            };
        // Mostly it is the very same, and needs no look at its numbers.
        let both_pinned = (self.pinned.as_ref(), other.pinned.as_ref());
        same && match both_pinned {
            (Some(a), Some(b)) => Arc::ptr_eq(a, b) || a == b,
            (a, b) => a.is_none() && b.is_none(),
        }
    }
}
