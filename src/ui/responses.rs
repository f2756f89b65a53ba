//! The response pane: which disturbance, how strong, and the motion that follows, as small multiples on one time axis.

use egui::{ComboBox, Rect, RichText, Ui, Vec2};
use egui_plot::PlotPoint;
use nalgebra::Vector4;

use super::derivatives::{self, Rows};
use super::response_plot::{Curve, Curves, ResponsePlot};
use super::theme::{self, Palette};
use crate::content::LengthUnit;
use crate::flight::Analysis;
use crate::flight::linear::Longitudinal;
use crate::flight::response::Response;
use crate::number::significant;
use crate::scenario::{Dimension, DisturbanceKind, Parameter, Scenario};

/// The small plots with their ranges, and the cursor that they share.
#[derive(Debug, Default)]
pub struct Responses {
    plots: [ResponsePlot; 6],
    /// Time under the pointer \[s\].
    cursor: Option<f64>,
    /// Whether the second plot shows w instead of α = w/U₀.
    w_instead_of_alpha: bool,
}

/// What one curve shows.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Quantity {
    symbol: &'static str,
    dimension: Dimension,
    state: Longitudinal,
}

const U: Quantity = Quantity { symbol: "Δu", dimension: Dimension::Speed, state: Longitudinal::U };
const W: Quantity = Quantity { symbol: "Δw", dimension: Dimension::Speed, state: Longitudinal::W };
/// α = w/U₀: of the angles' dimension, which tells it from w.
const ALPHA: Quantity = Quantity { symbol: "Δα", dimension: Dimension::Angle, state: Longitudinal::W };
const Q: Quantity = Quantity { symbol: "q", dimension: Dimension::AngularRate, state: Longitudinal::Q };
const THETA: Quantity = Quantity { symbol: "Δθ", dimension: Dimension::Angle, state: Longitudinal::Theta };

impl Quantity {
    /// One SI unit of the state in the shown unit.
    fn scale(self, scenario: &Scenario) -> f64 {
        let unit = self.dimension.in_si(scenario.aircraft.length_unit);
        if self == ALPHA { 1.0 / (scenario.model.u0 * unit) } else { 1.0 / unit }
    }
}

/// A scenario with what follows from it.
#[derive(Clone, Copy, Debug)]
pub struct Studied<'a> {
    /// What is studied.
    pub scenario: &'a Scenario,
    /// What follows.
    pub analysis: &'a Analysis,
}

impl Studied<'_> {
    fn curve(&self, quantity: Quantity, in_units_of: &Scenario) -> Curve {
        // The pinned state is drawn in the units of the one on screen; α is over its own U₀.
        let scale =
            if quantity == ALPHA { quantity.scale(self.scenario) } else { quantity.scale(in_units_of) };
        let Response { dt, states, .. } = &self.analysis.response;
        let row = quantity.state.index();
        let point = |(k, x): (usize, &Vector4<f64>)| PlotPoint::new(k as f64 * dt, x[row] * scale);
        let points = states.iter().enumerate().map(point).collect();
        Curve { points, small: self.small() }
    }

    /// How many samples, from the first, are of a small disturbance.
    fn small(&self) -> usize {
        let Response { dt, states, .. } = &self.analysis.response;
        self.analysis.small_until.map_or(states.len(), |time| (time / dt).round() as usize)
    }

    /// The input as it is: its edges upright.
    fn input(&self) -> Curve {
        let experiment = self.scenario.disturbance.experiment();
        let scale = 1.0 / self.input_dimension().in_si(LengthUnit::Metre) * self.input_sign();
        let end = experiment.grid.duration;
        let mut points = vec![PlotPoint::new(0.0, 0.0)];
        for (time, value) in experiment.input.switches().filter(|&(time, _)| time < end) {
            let before = points.last().map_or(0.0, |point| point.y);
            points.push(PlotPoint::new(time, before));
            points.push(PlotPoint::new(time, value * scale));
        }
        let last = points.last().map_or(0.0, |point| point.y);
        points.push(PlotPoint::new(end, last));
        Curve { small: points.len(), points }
    }

    fn input_dimension(&self) -> Dimension {
        match self.scenario.disturbance.kind {
            DisturbanceKind::ElevatorStep | DisturbanceKind::ElevatorPulse => Dimension::Angle,
            DisturbanceKind::VerticalGust => Dimension::AirSpeed,
        }
    }

    /// A gust is shown upward positive, against z.
    fn input_sign(&self) -> f64 {
        if self.input_dimension() == Dimension::AirSpeed { -1.0 } else { 1.0 }
    }
}

/// The row of the disturbance and its rows of numbers; edits `scenario` in place.
pub fn disturbance_ui(ui: &mut Ui, scenario: &mut Scenario) {
    let kind = scenario.disturbance.kind;
    let chooser = ComboBox::from_id_salt("disturbance").selected_text(kind.text()).width(130.0);
    let chooser = chooser.show_ui(ui, |ui| {
        for other in DisturbanceKind::ALL {
            if ui.selectable_label(kind == other, other.text()).clicked() {
                scenario.disturbance.kind = other;
                ui.close();
            }
        }
    });
    theme::name_chooser(chooser, "Disturbance", kind.text());
    let keys: &[&str] = match scenario.disturbance.kind {
        DisturbanceKind::ElevatorStep => &["step", "time"],
        DisturbanceKind::ElevatorPulse => &["pulse", "pulse_for", "time"],
        DisturbanceKind::VerticalGust => &["gust", "time"],
    };
    for parameter in keys.iter().filter_map(|key| Parameter::find(key)) {
        derivatives::compact_ui(ui, scenario, parameter);
    }
}

impl Responses {
    /// Heading and choosers; edits the disturbance in place.
    pub fn choosers_ui(&mut self, ui: &mut Ui, scenario: &mut Scenario) {
        ui.horizontal_wrapped(|ui| {
            theme::heading(ui, RichText::new("Response to").heading(), 2);
            disturbance_ui(ui, scenario);
            ui.selectable_value(&mut self.w_instead_of_alpha, false, "α")
                .on_hover_text("Angle of attack, α = w/U₀");
            ui.selectable_value(&mut self.w_instead_of_alpha, true, "w")
                .on_hover_text("Velocity along z, downward positive");
        });
    }

    /// Draws the plots over all the room there is.
    pub fn show(&mut self, ui: &mut Ui, studied: Studied<'_>, ghost: Option<Studied<'_>>, rows: Rows) {
        if let Some(time) = studied.analysis.small_until {
            let text = format!(
                "From t = {} s this is no small disturbance any more: the linear model means nothing there.",
                significant(time, 3)
            );
            ui.label(RichText::new(text).font(theme::small()).color(Palette::of(ui).bad));
        }
        self.plots_ui(ui, studied, ghost, rows);
    }

    fn plots_ui(&mut self, ui: &mut Ui, studied: Studied<'_>, ghost: Option<Studied<'_>>, rows: Rows) {
        let columns = if rows == Rows::Touch {
            1
        } else if ui.available_width() > 620.0 {
            3
        } else {
            2
        };
        let count_down = 6 / columns;
        let height = if rows == Rows::Touch {
            6.0 * 130.0
        } else {
            ui.available_height().max(130.0 * count_down as f32)
        };
        let (area, response) =
            ui.allocate_exact_size(Vec2::new(ui.available_width(), height), egui::Sense::hover());
        if !response.contains_pointer() {
            self.cursor = None;
        }
        let gap = 12.0;
        let cell = Vec2::new(
            (area.width() - gap * (columns as f32 - 1.0)) / columns as f32,
            (area.height() - 8.0 * (count_down as f32 - 1.0)) / count_down as f32,
        );
        let place = |i: usize| {
            let (row, column) = ((i / columns) as f32, (i % columns) as f32);
            Rect::from_min_size(area.min + Vec2::new(column * (cell.x + gap), row * (cell.y + 8.0)), cell)
        };
        let length = studied.scenario.aircraft.length_unit;
        let mut cursor = self.cursor;
        let second = if self.w_instead_of_alpha { W } else { ALPHA };
        for (i, quantity) in [U, second, Q, THETA].into_iter().enumerate() {
            let now = studied.curve(quantity, studied.scenario);
            let pinned = ghost.map(|ghost| ghost.curve(quantity, studied.scenario));
            let curves = Curves {
                symbol: quantity.symbol,
                unit: quantity.dimension.symbol(length),
                against: ("t", "s"),
                now: &now,
                ghost: pinned.as_ref(),
            };
            self.plots[i].show(ui, place(i), &curves, &mut cursor);
        }
        let input = studied.input();
        let dimension = studied.input_dimension();
        let symbol = if dimension == Dimension::Angle { "δ_e" } else { "w_g ↑" };
        let curves =
            Curves { symbol, unit: dimension.symbol(length), against: ("t", "s"), now: &input, ghost: None };
        self.plots[4].show(ui, place(4), &curves, &mut cursor);

        let path = phase_portrait(studied);
        let pinned = ghost.map(phase_portrait);
        let curves = Curves {
            symbol: "q",
            unit: "deg/s",
            against: ("Δα", "α in deg"),
            now: &path,
            ghost: pinned.as_ref(),
        };
        let mark = cursor
            .and_then(|t| path.points.get((t / studied.analysis.response.dt).round() as usize).copied());
        self.plots[5].show_path(ui, place(5), &curves, mark);
        self.cursor = cursor;
    }
}

/// q over α, both in degrees.
fn phase_portrait(studied: Studied<'_>) -> Curve {
    let alpha = studied.curve(ALPHA, studied.scenario);
    let q = studied.curve(Q, studied.scenario);
    let points = alpha.points.iter().zip(&q.points).map(|(alpha, q)| PlotPoint::new(alpha.y, q.y)).collect();
    Curve { points, small: alpha.small }
}
