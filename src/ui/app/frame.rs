//! The page in a frame of another page: it stays with what was opened on it, tells how high it would like to be, and on a page of
//! its own there is a sheet that makes such a frame.

use egui::{Context, Ui};

use super::{App, PHONE};
use crate::scenario::view::Pane;
use crate::scenario::{Hidden, Part, Stage, View};
use crate::ui::curtain::Curtain;
use crate::ui::embed::{Embedding, embed_sheet_ui};
use crate::ui::room;
use crate::words;

/// Height of the whole workbench, and the most that a stage asks for \[CSS pixels\].
const HEIGHTS: [f32; 2] = [860.0, 1200.0];

impl App {
    /// Says that the page stands in a frame of another page, which has its own words of welcome, look and way on.
    pub fn stand_in_frame(&mut self) {
        self.panes.is_framed = true;
    }

    /// Whether the page stays with what was opened on it: in a frame that shows something, not the whole workbench.
    pub(super) fn is_kept(&self) -> bool {
        self.panes.is_framed && (self.has_lesson() || self.view.stage != Stage::default())
    }

    /// The height that shows all of the stage at the page's present width, and not more \[CSS pixels\]. As of the last frame.
    pub fn wished_height(&self, ctx: &Context) -> f32 {
        let [workbench, most] = HEIGHTS;
        if !self.has_lesson() && self.view.stage == Stage::default() {
            return workbench;
        }
        let page = ctx.content_rect();
        let on_stage = |panes: [Pane; 2]| panes.into_iter().any(|pane| self.view.stage.has(pane.part()));
        let rows = [[Pane::Poles, Pane::Aircraft], [Pane::Response, Pane::Equations]];
        let rows = rows.into_iter().filter(|panes| on_stage(*panes)).count();
        let points = if page.width() < PHONE {
            // The pole map, and below it one of the others, which scrolls.
            self.panes.above + Self::height_on_phone(self.view.stage.has(Part::Poles))
        } else {
            let scrolled = room::missing(ctx).map_or(0.0, |missing| page.height() + missing);
            scrolled.max(self.panes.above + Self::height_of_rows(rows))
        };
        (points * ctx.zoom_factor()).ceil().min(most)
    }

    /// The scene as it stands, to be put into a frame.
    pub(super) fn embedding(&self) -> Embedding {
        Embedding::new(self.view.stage.clone())
    }

    /// The sheet that makes a frame of the scene, where it is open.
    pub(super) fn embed_ui(&mut self, ui: &Ui) {
        let Some(mut embedding) = self.panes.embed.take() else { return };
        let view = View { stage: embedding.stage().clone(), ..self.view.clone() };
        let address = format!("{}#{}", self.share.address, self.link_with(&view, false));
        let name =
            Curtain::of(ui).hides(Hidden::AircraftName) || embedding.stage().hides(Hidden::AircraftName);
        let name = if name { words::view::AN_AIRCRAFT } else { &self.scenario.aircraft.name };
        let html = embedding.html(&address, &format!("Eigenwing: {name}"));
        let shown = embed_sheet_ui(ui, &mut embedding, &html);
        if shown.copies {
            ui.copy_text(html);
            self.share.show(ui, COPIED);
        }
        self.panes.embed = shown.is_wanted.then_some(embedding);
    }
}

/// What is said when the frame has been copied.
const COPIED: &str = "Frame copied";
