//! What a screen reader is told beside the element that it is at: that the verdict has become another.

use egui::Ui;

use super::App;
use crate::flight::aircraft::plane::Plane;
use crate::flight::modes::stability::Stability;
use crate::scenario::Hidden;
use crate::ui::curtain::Curtain;
use crate::words;

/// The verdict that was last on screen.
pub(super) type Verdict = (Plane, Stability);

impl App {
    /// Says the verdict on the plane where it has become another, at the end of a frame; never while something is dragged.
    pub(super) fn say_verdict(&mut self, ui: &Ui) {
        if self.view.presents || ui.input(|input| input.pointer.any_down()) {
            return;
        }
        let told = self.findings.flown().filter(|_| !Curtain::of(ui).hides(Hidden::Verdicts));
        let now = told.map(|plane| (plane.model.plane, plane.dynamic_stability));
        let before = std::mem::replace(&mut self.panes.verdict, now);
        if let (Some(plane), Some(now), Some(before)) = (told, now, before)
            && now.0 == before.0
            && now.1 != before.1
        {
            self.share.say(words::stability::dynamic_sentence(plane));
        }
    }
}
