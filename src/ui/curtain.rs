//! What the page doesn't show, and what stays as it is: hung once a frame, and asked by every view.
//!
//! A riddle isn't answered by a tooltip: what is hidden is neither drawn nor told to a screen reader. Modes whose names are hidden
//! are numbered by |λ|, the largest first, and all have one colour ([`Palette::of`](super::theme::Palette::of)).

use std::sync::Arc;

use egui::{Context, Id, Response, Ui};

use crate::few;
use crate::flight::modes::mode::Mode;
use crate::flight::modes::mode_name::ModeName;
use crate::scenario::{Hidden, Lock, Parameter, Stage};
use crate::words;

/// What isn't shown, and what is locked.
#[derive(Debug, Default, PartialEq)]
pub struct Curtain {
    /// What is hidden and locked.
    stage: Stage,
    /// Whether nothing leads to another scene than those that were opened here from outside.
    is_kept: bool,
    /// The modes by |λ|, the largest first, where their names are hidden.
    modes: Vec<ModeName>,
}

impl Curtain {
    /// The curtain of a stage; of one that is `revealed` nothing is hidden.
    pub fn new(stage: &Stage, revealed: bool, modes: &[Mode]) -> Self {
        let stage = if revealed { stage.clone().hiding(Vec::new()) } else { stage.clone() };
        let names = |index: usize| modes[index].naming.name;
        let modes = if stage.hides(Hidden::Names) {
            by_size(modes).into_iter().map(names).collect()
        } else {
            Vec::new()
        };
        Self { stage, modes, is_kept: false }
    }

    /// The same on a page that is to stay with what was opened on it.
    pub fn keeping(self, is_kept: bool) -> Self {
        Self { is_kept, ..self }
    }

    /// Hangs it for all views that are drawn next.
    pub fn hang(self, ctx: &Context) {
        let hung = ctx.data(|data| data.get_temp::<Arc<Self>>(id()));
        if hung.is_none_or(|hung| *hung != self) {
            ctx.data_mut(|data| data.insert_temp(id(), Arc::new(self)));
        }
    }

    /// The one that hangs.
    pub fn of(ui: &Ui) -> Arc<Self> {
        Self::on(ui.ctx())
    }

    /// The one that hangs.
    pub fn on(ctx: &Context) -> Arc<Self> {
        ctx.data(|data| data.get_temp(id())).unwrap_or_default()
    }

    /// Whether something is hidden.
    pub fn hides(&self, what: Hidden) -> bool {
        self.stage.hides(what)
    }

    /// Whether any of these is hidden.
    pub fn hides_any(&self, what: &[Hidden]) -> bool {
        what.iter().any(|what| self.hides(*what))
    }

    /// Whether sentences on a mode are hidden that tell its name, or a number of it.
    pub fn hides_sentences(&self) -> bool {
        self.hides_any(&[Hidden::Names, Hidden::Numbers])
    }

    /// Whether it is hidden what would move a mode, and how.
    pub fn hides_influence(&self) -> bool {
        self.hides_any(&[Hidden::Names, Hidden::Numbers, Hidden::Reasons])
    }

    /// Whether values of the motion are hidden where the pointer is.
    pub fn hides_values(&self) -> bool {
        self.hides_any(&[Hidden::Numbers, Hidden::Curves])
    }

    /// Whether what the source says of the aircraft is hidden: it has names of modes, their numbers, and the aircraft's own.
    pub fn hides_source(&self) -> bool {
        self.stage.hidden().iter().any(|hidden| *hidden != Hidden::Curves)
    }

    /// Whether anything is hidden.
    pub fn hides_anything(&self) -> bool {
        !self.stage.hidden().is_empty()
    }

    /// A mode as a title.
    pub fn title(&self, name: ModeName) -> &'static str {
        if self.hides(Hidden::Names) {
            words::mode::numbered(self.number(name))
        } else {
            words::mode::title(name)
        }
    }

    /// A mode after an article within a sentence.
    pub fn in_a_sentence(&self, name: ModeName) -> &'static str {
        if self.hides(Hidden::Names) {
            words::mode::numbered_in_a_sentence(self.number(name))
        } else {
            words::mode::in_a_sentence(name)
        }
    }

    /// The telling numbers of a mode, as far as they may be told.
    pub fn numbers(&self, mode: &Mode) -> Option<String> {
        match (self.hides(Hidden::Numbers), self.hides(Hidden::Verdicts)) {
            (true, _) => None,
            (false, true) => Some(words::mode::plain_numbers(mode)).filter(|numbers| !numbers.is_empty()),
            (false, false) => Some(words::mode::numbers(mode)),
        }
    }

    /// Indices of modes in the order in which they are told.
    pub fn order(&self, modes: &[Mode]) -> Vec<usize> {
        if self.hides(Hidden::Names) { by_size(modes) } else { (0..modes.len()).collect() }
    }

    /// The name of an aircraft, or what stands for it.
    pub fn aircraft<'a>(&self, name: &'a str) -> &'a str {
        if self.hides(Hidden::AircraftName) { words::view::AN_AIRCRAFT } else { name }
    }

    /// Whether the page stays with what was opened on it: it offers no other lesson, and no way out of one.
    pub fn keeps(&self) -> bool {
        self.is_kept
    }

    /// Whether something stays as it is.
    pub fn locks(&self, what: Lock) -> bool {
        self.stage.locks_up(what)
    }

    /// Whether a parameter stays as it is.
    pub fn locks_parameter(&self, parameter: &Parameter) -> bool {
        self.stage.locks_parameter(parameter)
    }

    /// Whether the slider of a parameter is offered.
    pub fn offers(&self, parameter: &Parameter) -> bool {
        self.stage.offers(parameter.key)
    }

    /// Whether a parameter may be moved by something other than its slider: it is offered, and not locked.
    pub fn frees(&self, parameter: &Parameter) -> bool {
        self.stage.offers(parameter.key) && !self.locks_parameter(parameter)
    }

    /// What can't be worked where something is locked.
    pub fn lock_ui<R>(&self, ui: &mut Ui, what: Lock, contents: impl FnOnce(&mut Ui) -> R) -> R {
        let is_locked = self.locks(what);
        if !is_locked {
            return contents(ui);
        }
        let inner = ui.scope(|ui| {
            ui.disable();
            contents(ui)
        });
        locked(inner.response);
        inner.inner
    }

    /// Place of a mode among those that are numbered, from 0.
    fn number(&self, name: ModeName) -> Option<usize> {
        self.modes.iter().position(|other| *other == name)
    }
}

/// Says on hover that something can't be changed.
pub fn locked(response: Response) -> Response {
    response.on_hover_text(words::view::LOCKED).on_disabled_hover_text(words::view::LOCKED)
}

fn id() -> Id {
    Id::unique("curtain")
}

fn by_size(modes: &[Mode]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..modes.len()).collect();
    few::sort_by(&mut order, |a, b| modes[*b].lambda.norm().total_cmp(&modes[*a].lambda.norm()));
    order
}
