//! The response pane: which disturbance, how strong, and the motion that follows: over time, as phase portraits, over frequency,
//! and in numbers.

mod disturbance;
mod figures;
mod frequency;
mod legend;
mod phase;
mod studied;
mod time;

use egui::{Rect, RichText, Ui};

use super::derivatives::Rows;
use super::theme::{self, Palette};
use crate::flight::aircraft::plane::Plane;
use crate::flight::modes::mode::Mode;
use crate::flight::motion::outputs::Output;
use crate::number::significant;
use crate::scenario::link::{Sight, Tab};
use crate::scenario::{Quantity, Scenario};

pub use studied::Studied;

/// The pane as a person has set it up; nothing of it is studied.
#[derive(Debug, Default)]
pub struct Responses {
    /// In which way the motion is shown.
    pub tab: Tab,
    /// Whether the nonlinear flight is drawn beside the linear motion.
    pub nonlinear: bool,
    /// What the rows of choosers leave free at their end.
    beside: Option<Rect>,
    time: time::TimePlots,
    phase: phase::PhasePlots,
    frequency: frequency::FrequencyPlots,
}

impl Responses {
    /// Heading and choosers; edits the disturbance in place. `modes` are those that can be flown alone.
    pub fn choosers_ui(&mut self, ui: &mut Ui, scenario: &mut Scenario, modes: &[Mode]) {
        ui.horizontal_wrapped(|ui| {
            theme::heading(ui, RichText::new("Response to").heading(), 2);
            disturbance::disturbance_ui(ui, scenario, modes);
        });
        ui.horizontal_wrapped(|ui| {
            for tab in Tab::ALL {
                ui.selectable_value(&mut self.tab, tab, tab.text());
            }
            ui.add_space(8.0);
            match self.tab {
                Tab::Time => self.time.choosers_ui(ui, scenario.plane),
                Tab::Phase => self.phase.choosers_ui(ui, scenario.plane),
                Tab::Frequency => self.frequency.choosers_ui(ui, scenario.plane),
                Tab::Figures => {}
            }
            if matches!(self.tab, Tab::Time | Tab::Phase) {
                ui.checkbox(&mut self.nonlinear, "Nonlinear").on_hover_text(
                    "The six rigid-body equations, integrated, beside the linear model. Raise the factor × to see them part",
                );
            }
            let free = ui.available_rect_before_wrap();
            // Of several rows, the last.
            let row = Rect::from_x_y_ranges(free.x_range(), ui.cursor().y_range());
            self.beside = Some(row.with_min_x(row.left() + 8.0));
        });
    }

    /// What is shown, for a link.
    pub fn sight(&self, sight: &mut Sight) {
        sight.shown = self.time.chosen.clone();
        sight.split = self.time.split;
        sight.portraits = self.phase.pairs;
        sight.frequency_of = self.frequency.outputs;
    }

    /// Shows what a link shows.
    pub fn look(&mut self, sight: &Sight) {
        self.time.chosen = sight.shown.clone();
        self.time.split = sight.split;
        self.phase.pairs = sight.portraits;
        self.frequency.outputs = sight.frequency_of;
    }

    /// Time under the pointer \[s\].
    pub fn hovered(&self) -> Option<f64> {
        self.time.hovered().filter(|_| self.tab == Tab::Time)
    }

    /// Forgets what the pointer was on: for frames in which the plots aren't drawn.
    pub fn leave(&mut self) {
        self.time.leave();
    }

    /// Where the cursor stands while the pointer is elsewhere \[s\].
    pub fn set_time(&mut self, time: f64) {
        self.time.played = Some(time).filter(|time| *time > 0.0);
    }

    /// Whether the nonlinear flight is wanted.
    pub fn shows_flight(&self) -> bool {
        self.nonlinear && matches!(self.tab, Tab::Time | Tab::Phase)
    }

    /// Draws the motion over all the room there is.
    pub fn show(&mut self, ui: &mut Ui, studied: Studied<'_>, ghost: Option<Studied<'_>>, rows: Rows) {
        if let Some(time) = studied.motion.small_until
            && self.tab != Tab::Frequency
        {
            note_ui(
                ui,
                &format!(
                    "From t = {} s this is no small disturbance any more: the linear model means nothing there. A smaller factor × keeps it small for longer.",
                    significant(time, 3)
                ),
            );
        }
        let studied = Studied { flight: studied.flight.filter(|_| self.shows_flight()), ..studied };
        if let Some(end) = studied.end_of_flight() {
            note_ui(ui, &end);
        }
        let beside = self.beside.take();
        let seen = Seen { studied, ghost, palette: Palette::of(ui), rows, beside };
        match self.tab {
            Tab::Time => self.time.show(ui, seen),
            Tab::Phase => self.phase.show(ui, seen, self.time.played),
            Tab::Frequency => self.frequency.show(ui, seen),
            Tab::Figures => figures::figures_ui(ui, studied, ghost),
        }
    }
}

/// What a tab draws, and where.
#[derive(Clone, Copy, Debug)]
struct Seen<'a> {
    studied: Studied<'a>,
    /// The pinned state.
    ghost: Option<Studied<'a>>,
    palette: &'static Palette,
    rows: Rows,
    /// Where the legend goes if it fits.
    beside: Option<Rect>,
}

/// What pictures are made of: they stay the same as long as it does.
#[derive(Clone, Debug, PartialEq)]
struct Basis {
    scenario: Scenario,
    pinned: Option<Scenario>,
    is_flown: bool,
    palette: &'static Palette,
}

impl Basis {
    fn of(seen: Seen<'_>) -> Self {
        Self {
            scenario: seen.studied.scenario.clone(),
            pinned: seen.ghost.map(|ghost| ghost.scenario.clone()),
            is_flown: seen.studied.flight.is_some(),
            palette: seen.palette,
        }
    }
}

/// What was made of `key`; it is made again only where the key has changed.
fn kept<K: PartialEq, T>(held: &mut Option<(K, T)>, key: K, make: impl FnOnce() -> T) -> &mut T {
    if held.as_ref().is_some_and(|(of, _)| *of != key) {
        *held = None;
    }
    let (_, made) = held.get_or_insert_with(|| (key, make()));
    made
}

/// A line that says what is the matter.
fn note_ui(ui: &mut Ui, text: &str) {
    ui.label(RichText::new(text).font(theme::small()).color(Palette::of(ui).bad));
}

/// A chooser of one output.
fn output_ui(ui: &mut Ui, name: &str, plane: Plane, output: &mut Output) {
    let now = Quantity::of(*output);
    let chooser = egui::ComboBox::from_id_salt(name).width(56.0).selected_text(word(now));
    let chooser = chooser.show_ui(ui, |ui| {
        for &other in Output::of(plane) {
            let quantity = Quantity::of(other);
            let text = format!("{} · {}", word(quantity), quantity.name);
            if ui.selectable_label(*output == other, text).clicked() {
                *output = other;
                ui.close();
            }
        }
    });
    theme::name_chooser(chooser, name, now.name);
}

/// A quantity's symbol as plain text.
fn word(quantity: Quantity) -> String {
    super::symbol::Symbol::parse(quantity.symbol).plain()
}

#[cfg(test)]
mod tests {
    use super::kept;

    #[test]
    fn what_is_kept_is_made_again_when_its_key_changes_and_only_then() {
        let (mut held, mut made) = (None, 0);
        let keys = ["a", "a", "b", "b", "a"];
        let given = keys.map(|key| {
            *kept(&mut held, key, || {
                made += 1;
                key
            })
        });
        assert_eq!((given, made), (keys, 3));
    }
}
