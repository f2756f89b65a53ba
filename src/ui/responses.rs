//! The response pane: which disturbance, how strong, and the motion that follows, as small multiples on one time axis.

use egui::{ComboBox, Rect, RichText, Ui, Vec2};
use egui_plot::PlotPoint;
use nalgebra::Vector4;

use super::derivatives::{self, Rows};
use super::response_plot::{Curve, Curves, ResponsePlot};
use super::theme::{self, Palette};
use crate::content::LengthUnit;
use crate::flight::analysis::Motion;
use crate::flight::plane::Plane;
use crate::flight::response::Response;
use crate::flight::states::{Lateral, Longitudinal};
use crate::number::significant;
use crate::scenario::{Dimension, DisturbanceKind, Parameter, Scenario};

/// The small plots with their ranges, and the cursor that they share.
#[derive(Debug, Default)]
pub struct Responses {
    plots: [ResponsePlot; 6],
    /// Time under the pointer \[s\].
    cursor: Option<f64>,
    /// Whether the flow angle is shown as the velocity it is made of: w, v.
    velocity_for_angle: bool,
}

/// What one curve shows.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Quantity {
    symbol: &'static str,
    dimension: Dimension,
    /// Row of the state vector.
    state: usize,
    /// Over the airspeed, which turns w into α and v into β.
    over_speed: bool,
}

const fn quantity(symbol: &'static str, dimension: Dimension, state: usize) -> Quantity {
    Quantity { symbol, dimension, state, over_speed: false }
}

const fn flow_angle(symbol: &'static str, state: usize) -> Quantity {
    Quantity { symbol, dimension: Dimension::Angle, state, over_speed: true }
}

const U: Quantity = quantity("Δu", Dimension::Speed, Longitudinal::U.index());
const W: Quantity = quantity("Δw", Dimension::Speed, Longitudinal::W.index());
const ALPHA: Quantity = flow_angle("Δα", Longitudinal::W.index());
const Q: Quantity = quantity("q", Dimension::AngularRate, Longitudinal::Q.index());
const THETA: Quantity = quantity("Δθ", Dimension::Angle, Longitudinal::Theta.index());
const V: Quantity = quantity("v", Dimension::Speed, Lateral::V.index());
const BETA: Quantity = flow_angle("β", Lateral::V.index());
const P: Quantity = quantity("p", Dimension::AngularRate, Lateral::P.index());
const R: Quantity = quantity("r", Dimension::AngularRate, Lateral::R.index());
const PHI: Quantity = quantity("φ", Dimension::Angle, Lateral::Phi.index());

/// What the plots of a plane show.
struct Shown {
    /// The four states, the flow angle among them.
    states: [Quantity; 4],
    /// The flow angle, and the velocity that can stand in its place.
    angle: Quantity,
    velocity: Quantity,
    /// The rate of the phase portrait, over the flow angle.
    rate: Quantity,
    /// The two on the buttons that choose, and the axis of the phase portrait.
    words: [&'static str; 3],
}

const fn shown(plane: Plane) -> Shown {
    match plane {
        Plane::Longitudinal => Shown {
            states: [U, ALPHA, Q, THETA],
            angle: ALPHA,
            velocity: W,
            rate: Q,
            words: ["α", "w", "α in deg"],
        },
        Plane::Lateral => Shown {
            states: [BETA, P, R, PHI],
            angle: BETA,
            velocity: V,
            rate: P,
            words: ["β", "v", "β in deg"],
        },
    }
}

impl Quantity {
    /// One SI unit of the state in the shown unit, at an airspeed \[m/s\].
    fn scale(self, scenario: &Scenario, speed: f64) -> f64 {
        let unit = self.dimension.in_si(scenario.aircraft.length_unit);
        if self.over_speed { 1.0 / (speed * unit) } else { 1.0 / unit }
    }
}

/// A scenario with what follows from it.
#[derive(Clone, Copy, Debug)]
pub struct Studied<'a> {
    /// What is studied.
    pub scenario: &'a Scenario,
    /// The motion that follows.
    pub motion: &'a Motion,
}

impl Studied<'_> {
    fn curve(&self, quantity: Quantity, in_units_of: &Scenario) -> Curve {
        // The pinned state is drawn in the units of the one on screen; its flow angle is over its own speed.
        let scale = quantity.scale(in_units_of, self.motion.speed);
        let Response { dt, states, .. } = &self.motion.response;
        let row = quantity.state;
        let point = |(k, x): (usize, &Vector4<f64>)| PlotPoint::new(k as f64 * dt, x[row] * scale);
        let points = states.iter().enumerate().map(point).collect();
        Curve { points, small: self.small() }
    }

    /// How many samples, from the first, are of a small disturbance.
    fn small(&self) -> usize {
        let Response { dt, states, .. } = &self.motion.response;
        self.motion.small_until.map_or(states.len(), |time| (time / dt).round() as usize)
    }

    /// The input as it is: its edges upright.
    fn input(&self) -> Curve {
        let experiment = self.scenario.disturbance.experiment(self.motion.plane);
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

    fn kind(&self) -> DisturbanceKind {
        self.scenario.disturbance.kind(self.motion.plane)
    }

    fn input_dimension(&self) -> Dimension {
        match self.kind() {
            DisturbanceKind::ElevatorStep
            | DisturbanceKind::ElevatorPulse
            | DisturbanceKind::AileronPulse
            | DisturbanceKind::RudderPulse => Dimension::Angle,
            DisturbanceKind::ThrottleStep => Dimension::Percent,
            DisturbanceKind::VerticalGust | DisturbanceKind::SideGust => Dimension::AirSpeed,
        }
    }

    /// A vertical gust is shown upward positive, against z.
    fn input_sign(&self) -> f64 {
        if self.kind() == DisturbanceKind::VerticalGust { -1.0 } else { 1.0 }
    }

    fn input_symbol(&self) -> &'static str {
        match self.kind() {
            DisturbanceKind::ElevatorStep | DisturbanceKind::ElevatorPulse => "δ_e",
            DisturbanceKind::ThrottleStep => "δ_t",
            DisturbanceKind::VerticalGust => "w_g ↑",
            DisturbanceKind::AileronPulse => "δ_a",
            DisturbanceKind::RudderPulse => "δ_r",
            DisturbanceKind::SideGust => "v_g",
        }
    }
}

/// The row of the disturbance and its rows of numbers; edits `scenario` in place.
pub fn disturbance_ui(ui: &mut Ui, scenario: &mut Scenario) {
    let plane = scenario.plane;
    let kind = scenario.disturbance.kind(plane);
    let chooser = ComboBox::from_id_salt("disturbance").selected_text(kind.text()).width(130.0);
    let chooser = chooser.show_ui(ui, |ui| {
        for &other in DisturbanceKind::of(plane) {
            if ui.selectable_label(kind == other, other.text()).clicked() {
                *scenario.disturbance.kind_mut(plane) = other;
                ui.close();
            }
        }
    });
    theme::name_chooser(chooser, "Disturbance", kind.text());
    let keys = scenario.disturbance.kind(plane).parameters();
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
            let [angle, velocity, _] = shown(scenario.plane).words;
            let hover = "The flow angle, or the velocity it is made of: α = w/U₀, β = v/V";
            ui.selectable_value(&mut self.velocity_for_angle, false, angle).on_hover_text(hover);
            ui.selectable_value(&mut self.velocity_for_angle, true, velocity).on_hover_text(hover);
        });
    }

    /// Draws the plots over all the room there is.
    pub fn show(&mut self, ui: &mut Ui, studied: Studied<'_>, ghost: Option<Studied<'_>>, rows: Rows) {
        if let Some(time) = studied.motion.small_until {
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
        let Shown { states, angle, velocity, rate, words } = shown(studied.motion.plane);
        for (i, mut quantity) in states.into_iter().enumerate() {
            if self.velocity_for_angle && quantity == angle {
                quantity = velocity;
            }
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
        let symbol = studied.input_symbol();
        let curves =
            Curves { symbol, unit: dimension.symbol(length), against: ("t", "s"), now: &input, ghost: None };
        self.plots[4].show(ui, place(4), &curves, &mut cursor);

        let path = phase_portrait(studied, angle, rate);
        let pinned = ghost.map(|ghost| phase_portrait(ghost, angle, rate));
        let curves = Curves {
            symbol: rate.symbol,
            unit: "deg/s",
            against: (angle.symbol, words[2]),
            now: &path,
            ghost: pinned.as_ref(),
        };
        let mark =
            cursor.and_then(|t| path.points.get((t / studied.motion.response.dt).round() as usize).copied());
        self.plots[5].show_path(ui, place(5), &curves, mark);
        self.cursor = cursor;
    }
}

/// A rate over a flow angle, both in degrees.
fn phase_portrait(studied: Studied<'_>, angle: Quantity, rate: Quantity) -> Curve {
    let over = studied.curve(angle, studied.scenario);
    let of = studied.curve(rate, studied.scenario);
    let points = over.points.iter().zip(&of.points).map(|(over, of)| PlotPoint::new(over.y, of.y)).collect();
    Curve { points, small: over.small }
}
