//! A scenario with what follows from it, as curves in shown units.

use egui::Color32;

use crate::content::LengthUnit;
use crate::flight::Channel;
use crate::flight::aircraft::plane::Plane;
use crate::flight::analysis::Motion;
use crate::flight::modes::mode::Mode;
use crate::flight::motion::flight_path::FlightPath;
use crate::flight::motion::modal_sum::SplitError;
use crate::flight::motion::outputs::Output;
use crate::flight::motion::six_dof::SixDofError;
use crate::scenario::{Dimension, Quantity, Scenario};
use crate::ui::chart::{Curve, Pattern, PlotPoint};
use crate::ui::theme::Palette;
use crate::words;

/// A scenario with what follows from it.
#[derive(Clone, Copy, Debug)]
pub struct Studied<'a> {
    /// What is studied.
    pub scenario: &'a Scenario,
    /// The motion that follows.
    pub motion: &'a Motion,
    /// The modes of its model.
    pub modes: &'a [Mode],
    /// The nonlinear flight through the same, or why there is none, where it is asked for.
    pub flight: Option<&'a Result<FlightPath, SixDofError>>,
}

impl Studied<'_> {
    /// The plane of motion.
    pub fn plane(&self) -> Plane {
        self.motion.model.plane
    }

    /// How many samples, from the first, are of a small disturbance, and the one after.
    pub fn small(&self) -> usize {
        let response = &self.motion.response;
        self.motion
            .small_until
            .map_or(response.states.len(), |time| (time / response.dt).round() as usize + 1)
    }

    /// Time of the last sample wanted \[s\].
    pub fn duration(&self) -> f64 {
        self.scenario.disturbance.sizes.time
    }

    /// An output as a curve of time.
    pub fn curve(&self, output: Output, unit: f64, pattern: Pattern, color: Color32) -> Curve {
        let name = if pattern == Pattern::Full { "linear" } else { "pinned" };
        self.timed(name, self.motion.values(output), unit, pattern, color)
    }

    /// An output of the nonlinear flight as a curve of time, where it is asked for and there is one.
    pub fn flown(&self, output: Output, unit: f64, palette: &Palette) -> Option<Curve> {
        let flight = self.flight?.as_ref().ok()?;
        let values = output.of_flight(&self.motion.model, flight).into_iter().enumerate();
        let points: Vec<PlotPoint> =
            values.map(|(k, value)| PlotPoint::new(k as f64 * flight.dt, value / unit)).collect();
        Some(Curve::new("nonlinear", points, palette.nonlinear, Pattern::Dotted))
    }

    /// Why there is no nonlinear flight, or where it ends.
    pub fn end_of_flight(&self) -> Option<String> {
        match self.flight? {
            Ok(flight) => flight.stop.map(|stop| format!("Nonlinear flight ends: {stop}.")),
            Err(error) => Some(format!("No nonlinear flight: {error}.")),
        }
    }

    /// The parts of the modes of an output, each in its colour.
    pub fn parts(&self, output: Output, unit: f64, palette: &Palette) -> Result<Vec<Curve>, SplitError> {
        let sum = self.motion.split(self.modes, output)?;
        let largest = |values: &[f64]| values.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        let whole = sum.parts.iter().map(|part| largest(part)).fold(0.0, f64::max);
        let mut curves: Vec<Curve> = self
            .modes
            .iter()
            .zip(sum.parts)
            .map(|(mode, part)| {
                let name = mode.naming.name;
                self.timed(words::mode::title(name), part, unit, Pattern::Filled, palette.mode(name))
            })
            .collect();
        // Rounding is no part.
        if largest(&sum.rest) > 1e-6 * whole {
            curves.push(self.timed(
                "no mode: input and drift",
                sum.rest,
                unit,
                Pattern::Filled,
                palette.ghost,
            ));
        }
        Ok(curves)
    }

    fn timed(
        &self,
        name: &'static str,
        values: Vec<f64>,
        unit: f64,
        pattern: Pattern,
        color: Color32,
    ) -> Curve {
        let dt = self.motion.response.dt;
        let point = |(k, value): (usize, f64)| PlotPoint::new(k as f64 * dt, value / unit);
        let points = values.into_iter().enumerate().map(point).collect();
        Curve::new(name, points, color, pattern).drawn_for(self.small())
    }

    /// The inputs as they are, their edges upright, with the symbol of each and the dimension of all; none where nothing moves.
    pub fn inputs(&self, palette: &Palette) -> Option<(Vec<&'static str>, Dimension, Vec<Curve>)> {
        let experiment = &self.motion.experiment;
        let end = experiment.grid.duration;
        let mut shown = None;
        let mut symbols = Vec::new();
        let mut curves = Vec::new();
        for (i, (channel, input)) in experiment.inputs.iter().enumerate() {
            let (symbol, name, dimension, sign) = input_words(self.plane(), *channel);
            let unit = sign * dimension.in_si(LengthUnit::Metre);
            let mut times: Vec<f64> = (0..=experiment.grid.steps).map(|k| experiment.grid.time(k)).collect();
            for edge in input.edges().filter(|&edge| edge > 0.0 && edge < end) {
                // On either side of it, so that it stands upright.
                times.extend([edge - 1e-9 * end, edge]);
            }
            times.sort_by(f64::total_cmp);
            let points: Vec<PlotPoint> =
                times.into_iter().map(|t| PlotPoint::new(t, input.at(t) / unit)).collect();
            let (color, pattern) =
                if i == 0 { (palette.text, Pattern::Full) } else { (palette.weak, Pattern::Dashed) };
            curves.push(Curve::new(name, points, color, pattern));
            symbols.push(symbol);
            shown.get_or_insert(dimension);
        }
        shown.map(|dimension| (symbols, dimension, curves))
    }
}

/// Symbol, name, dimension and the sign in which an input is shown: gusts as a pilot speaks of them, against z and x.
pub const fn input_words(plane: Plane, channel: Channel) -> (&'static str, &'static str, Dimension, f64) {
    match (plane, channel) {
        (Plane::Longitudinal, Channel::First) => ("δ_e", "elevator", Dimension::Angle, 1.0),
        (Plane::Longitudinal, Channel::Second) => ("δ_t", "throttle", Dimension::ShareOfWeight, 1.0),
        (Plane::Lateral, Channel::First) => ("δ_a", "aileron", Dimension::Angle, 1.0),
        (Plane::Lateral, Channel::Second) => ("δ_r", "rudder", Dimension::Angle, 1.0),
        (_, Channel::AirAlong) => ("u_g", "air from ahead", Dimension::AirSpeed, -1.0),
        (Plane::Longitudinal, Channel::AirAcross) => ("w_g", "rising air", Dimension::AirSpeed, -1.0),
        (Plane::Lateral, Channel::AirAcross) => ("v_g", "air to the right", Dimension::AirSpeed, 1.0),
    }
}

/// Symbol, unit's symbol, and one of the unit in SI.
pub fn units(output: Output, scenario: &Scenario) -> (Quantity, &'static str, f64) {
    let quantity = Quantity::of(output);
    let length = scenario.aircraft.length_unit;
    (quantity, quantity.dimension.symbol(length), quantity.dimension.in_si(length))
}
