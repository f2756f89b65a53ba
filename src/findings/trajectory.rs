//! The aircraft at one moment of a motion: where it is, where it points, what pushes it. A function of time, so that a playback
//! scrubs and never drifts.

use nalgebra::{Vector2, Vector4};

use super::Findings;
use crate::flight::aircraft::aircraft_model::AircraftModel;
use crate::flight::aircraft::plane::Plane;
use crate::flight::aircraft::states::{AILERON, Lateral, Longitudinal};
use crate::flight::analysis::{Motion, STANDARD_GRAVITY};
use crate::flight::motion::flight_path::{Bite, FlightPath};
use crate::flight::motion::outputs::Output;
use crate::flight::motion::servos::as_array;
use crate::flight::{Channel, Start};
use crate::scenario::{Notation, Scenario};

/// The largest angle that a mode flown alone is made to show \[rad\].
const EXAGGERATED_TO: f64 = 0.25;

/// Drag over weight where no source gives it: for the eye, as of an aircraft that glides ten to one.
const DRAG_FOR_THE_EYE: f64 = 0.1;

/// A motion as the aircraft flies it on screen: the linear one, or the nonlinear where that is asked for.
#[derive(Clone, Copy, Debug)]
pub struct Trajectory<'a> {
    /// The scenario that it follows from.
    pub scenario: &'a Scenario,
    /// The linear motion, under the law of feedback where there is one.
    pub motion: &'a Motion,
    /// The nonlinear flight, shown in its place.
    flight: Option<&'a FlightPath>,
}

/// The aircraft at one moment. Angles in radians, lengths in metres, SI.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pose {
    /// φ, θ of the fuselage and ψ, with the trim's own.
    pub attitude: [f64; 3],
    /// p, q, r, not exaggerated.
    pub rates: [f64; 3],
    /// Angle of attack of the fuselage, with the trim's own.
    pub alpha: f64,
    /// Sideslip.
    pub beta: f64,
    /// North (along the steady flight), east, down, from where the motion began.
    pub position: [f64; 3],
    /// Where undisturbed flight would have brought it.
    pub steady_position: [f64; 3],
    /// δe, δa with the right aileron up positive, δr.
    pub deflections: [f64; 3],
    /// Lift, weight, thrust and drag over the weight of the reference, in body axes of the fuselage.
    pub forces: [[f64; 3]; 4],
}

/// A moment that pushes or damps a motion, −1 to 1 of the largest of its kind in the motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MomentArrow {
    /// Its symbol.
    pub symbol: &'static str,
    /// Body axis that it turns about: 0 for x, 1 for y, 2 for z.
    pub axis: usize,
    /// Its size, positive as the right hand turns.
    pub size: f64,
    /// Whether it damps (follows a rate), or pushes (follows a flow angle).
    pub damps: bool,
}

impl Findings {
    /// The motion as it is flown; the nonlinear flight if that is asked for and there is one.
    pub fn trajectory(&self, nonlinear: bool) -> Option<Trajectory<'_>> {
        let motion = self.flown_motion()?;
        let flight = if nonlinear { self.flight() } else { None };
        let flight =
            flight.and_then(|flight| flight.as_ref().ok()).filter(|flight| !flight.samples.is_empty());
        Some(Trajectory { scenario: &self.scenario, motion, flight })
    }
}

impl Trajectory<'_> {
    /// How much larger than it is the motion is shown: only a mode flown alone is, by a round factor.
    pub fn exaggeration(&self) -> f64 {
        if !self.is_one_mode() {
            return 1.0;
        }
        let outputs = match self.motion.model.plane {
            Plane::Longitudinal => [Output::AngleOfAttack, Output::PitchAngle],
            Plane::Lateral => [Output::Sideslip, Output::BankAngle],
        };
        let largest = outputs
            .into_iter()
            .map(|output| self.motion.values(output).into_iter().fold(0.0, |most: f64, x| most.max(x.abs())))
            .fold(1e-9, f64::max);
        let factor = (EXAGGERATED_TO / largest).clamp(1.0, 100.0);
        [50.0, 20.0, 10.0, 5.0, 4.0, 3.0, 2.0].into_iter().find(|round| *round <= factor).unwrap_or(1.0)
    }

    /// Whether one mode is flown alone, and so may be exaggerated: of a linear motion only.
    pub fn is_one_mode(&self) -> bool {
        matches!(self.motion.experiment.start, Start::Mode { .. }) && self.flight.is_none()
    }

    /// Time of the last sample \[s\].
    pub fn end(&self) -> f64 {
        match self.flight {
            Some(flight) => flight.samples.len().saturating_sub(1) as f64 * flight.dt,
            None => self.motion.response.states.len().saturating_sub(1) as f64 * self.motion.response.dt,
        }
    }

    /// Time of the last sample at which the motion can be flown \[s\]: a linear one only while it is a small disturbance.
    pub fn flown_until(&self) -> f64 {
        let last_small = self.motion.small_until.filter(|_| self.flight.is_none());
        last_small.map_or(self.end(), |time| (time - self.motion.response.dt).max(0.0))
    }

    /// Where limits of the controls hold the law back; of a nonlinear flight under one.
    pub fn bites(&self) -> &[Bite] {
        self.flight.map_or(&[], |flight| &flight.bites)
    }

    /// The aircraft at a time \[s\]; after [`Self::flown_until`] it stays where it was.
    pub fn pose(&self, time: f64, exaggeration: f64) -> Pose {
        let trim = &self.motion.model.trim;
        let t = time.clamp(0.0, self.flown_until());
        let values = |output: Output| self.at(output, t);
        let large = |output: Output| exaggeration * values(output);
        let fuselage = self.fuselage_incidence();
        let (position, steady_position) = self.position(t, exaggeration);
        let mut pose = Pose {
            attitude: [large(Output::BankAngle), large(Output::PitchAngle), large(Output::Heading)],
            rates: [Output::RollRate, Output::PitchRate, Output::YawRate].map(values),
            alpha: trim.alpha0 + fuselage + large(Output::AngleOfAttack),
            beta: large(Output::Sideslip),
            position,
            steady_position,
            deflections: self.deflections(t),
            forces: Default::default(),
        };
        pose.attitude[1] += trim.theta0() + fuselage;
        pose.forces = self.forces(&pose, values(Output::NormalLoad), values(Output::ForwardSpeed));
        pose
    }

    /// Where it is, and where undisturbed flight would have brought it.
    fn position(&self, t: f64, exaggeration: f64) -> ([f64; 3], [f64; 3]) {
        let trim = &self.motion.model.trim;
        let level = [trim.speed * trim.gamma0.cos() * t, 0.0, -trim.speed * trim.gamma0.sin() * t];
        let strayed = [self.at(Output::Distance, t), self.at(Output::Offset, t), -self.at(Output::Height, t)];
        ([0, 1, 2].map(|k| level[k] + exaggeration * strayed[k]), level)
    }

    /// All of where it is going to be and has been, as [`Self::path`].
    pub fn whole_path(&self, exaggeration: f64) -> Vec<[f64; 3]> {
        const POINTS: usize = 600;
        let step = self.end() / POINTS as f64;
        (0..=POINTS).map(|k| self.position(step * k as f64, exaggeration).0).collect()
    }

    /// Half of the way from where the path begins to where it ends \[m\].
    pub fn path_reach(&self, exaggeration: f64) -> f64 {
        let [start, end] = [0.0, self.end()].map(|t| self.position(t, exaggeration).0);
        0.5 * (0..3).map(|k| (end[k] - start[k]).powi(2)).sum::<f64>().sqrt()
    }

    /// Where it has been since `seconds` before a time, the oldest first, up to then: north, east, down \[m\].
    pub fn path(&self, time: f64, seconds: f64, exaggeration: f64) -> Vec<[f64; 3]> {
        const POINTS: usize = 60;
        let end = time.min(self.flown_until());
        let start = (end - seconds).max(0.0);
        (0..=POINTS)
            .map(|k| {
                let t = start + (end - start) * k as f64 / POINTS as f64;
                self.position(t, exaggeration).0
            })
            .collect()
    }

    /// The moments that push and damp the motion of a mode flown alone; none otherwise.
    pub fn moments(&self, time: f64) -> Vec<MomentArrow> {
        if !self.is_one_mode() {
            return Vec::new();
        }
        let (a, states) = (&self.motion.model.a, &self.motion.response.states);
        let (x, _) = self.state(time.min(self.flown_until()));
        let by = |velocity, angle| match self.scenario.notation {
            Notation::Velocities => velocity,
            Notation::Angles => angle,
        };
        let rows: &[(&'static str, usize, usize, usize, bool)] = match self.motion.model.plane {
            Plane::Longitudinal => &[
                (by("M′_w w", "M′_α α"), 1, Longitudinal::Q.index(), Longitudinal::W.index(), false),
                ("M′_q q", 1, Longitudinal::Q.index(), Longitudinal::Q.index(), true),
            ],
            Plane::Lateral => &[
                (by("N′_v v", "N′_β β"), 2, Lateral::R.index(), Lateral::V.index(), false),
                ("N′_r r", 2, Lateral::R.index(), Lateral::R.index(), true),
                (by("L′_v v", "L′_β β"), 0, Lateral::P.index(), Lateral::V.index(), false),
                ("L′_p p", 0, Lateral::P.index(), Lateral::P.index(), true),
            ],
        };
        let size = |row: usize, column: usize, x: &Vector4<f64>| a[(row, column)] * x[column];
        // Of one axis all are drawn to one scale, so that they can be compared.
        let largest = |axis: usize| {
            let of_axis = rows.iter().filter(|row| row.1 == axis);
            let sizes = of_axis
                .flat_map(|&(_, _, row, column, _)| states.iter().map(move |x| size(row, column, x).abs()));
            sizes.fold(f64::MIN_POSITIVE, f64::max)
        };
        rows.iter()
            .map(|&(symbol, axis, row, column, damps)| MomentArrow {
                symbol,
                axis,
                size: size(row, column, &x) / largest(axis),
                damps,
            })
            .collect()
    }

    fn at(&self, output: Output, t: f64) -> f64 {
        if let Some(flight) = self.flight {
            return output.of_flight_at(&self.motion.model, flight, t);
        }
        if output.plane() != self.motion.model.plane {
            return 0.0;
        }
        let row = output.row(&self.motion.model, &self.motion.forced);
        let (x, path) = self.state(t);
        row.states.dot(&x) + row.path.dot(&path) + row.direct(&self.motion.forced, t)
    }

    /// State and path at a time, straight between the samples.
    fn state(&self, t: f64) -> (Vector4<f64>, Vector2<f64>) {
        let response = &self.motion.response;
        let (k, fraction) = place(t, response.dt, response.states.len());
        let next = (k + 1).min(response.states.len().saturating_sub(1));
        let between = |a: f64, b: f64| a + fraction * (b - a);
        (
            response.states[k].zip_map(&response.states[next], between),
            response.path[k].zip_map(&response.path[next], between),
        )
    }

    fn deflections(&self, t: f64) -> [f64; 3] {
        let [elevator, aileron, rudder] = self.controls(t);
        // Bare matrices may count δa either way, which is told by what it does: L_δa > 0 rolls to the right.
        let counted_left = matches!(self.scenario.edited.aircraft_model, AircraftModel::Matrices(_))
            && self.motion.model.plane == Plane::Lateral
            && self.motion.model.b[(Lateral::P.index(), AILERON)] < 0.0;
        let sense = if counted_left { -1.0 } else { 1.0 };
        [elevator, sense * aileron, rudder]
    }

    /// Elevator, aileron and rudder: what the pilot does, and the law.
    fn controls(&self, t: f64) -> [f64; 3] {
        if let Some(flight) = self.flight {
            let (k, fraction) = place(t, flight.dt, flight.samples.len());
            let at = |k: usize| flight.samples.get(k).map_or([0.0; 4], |sample| as_array(&sample.controls));
            let (before, after) = (at(k), at((k + 1).min(flight.samples.len().saturating_sub(1))));
            return [0, 2, 3].map(|i| before[i] + fraction * (after[i] - before[i]));
        }
        let of = |channel: Channel, input: usize| -> f64 {
            let inputs = &self.motion.experiment.inputs;
            let by_pilot: f64 =
                inputs.iter().filter(|(of, _)| *of == channel).map(|(_, input)| input.at(t)).sum();
            by_pilot + self.motion.by_law.as_ref().map_or(0.0, |inputs| inputs[input].at(t))
        };
        let [first, second] = [of(Channel::First, 0), of(Channel::Second, 1)];
        match self.motion.model.plane {
            Plane::Longitudinal => [first, 0.0, 0.0],
            Plane::Lateral => [0.0, first, second],
        }
    }

    /// Weight of the reference \[N\], in which forces are counted; `None` where no source gives the mass.
    pub fn reference_weight(&self) -> Option<f64> {
        let mass = match &self.scenario.edited.aircraft_model {
            AircraftModel::Coefficients(aircraft_model) => Some(aircraft_model.reference.mass),
            AircraftModel::Derivatives(_) | AircraftModel::Matrices(_) => {
                self.scenario.aircraft.particulars.mass
            }
        };
        Some(mass? * STANDARD_GRAVITY)
    }

    /// Whether drag and thrust follow from the aircraft's figures; else they are drawn for the eye, each the other's equal in trim.
    pub fn is_drag_known(&self) -> bool {
        self.weight_and_drag().is_some()
    }

    /// Weight over that of the reference, and D/L from C_D/C_L.
    fn weight_and_drag(&self) -> Option<(f64, f64)> {
        let AircraftModel::Coefficients(aircraft_model) = &self.scenario.edited.aircraft_model else {
            return None;
        };
        let derived = aircraft_model.derive().ok()?;
        let c = derived.coefficients.longitudinal;
        let gravity = self.motion.model.trim.gravity / STANDARD_GRAVITY;
        let weight = derived.airframe.mass / aircraft_model.reference.mass * gravity;
        (c.cl > 0.0).then_some((weight, c.cd / c.cl))
    }

    /// In trim L = W cos γ₀, D from C_D and T = D + W sin γ₀; disturbed, the lift follows the load factor, D ≈ D₀ (1 + 2u/V),
    /// and the thrust stays, along the steady flight as the trim has it.
    fn forces(&self, pose: &Pose, load_change: f64, u: f64) -> [[f64; 3]; 4] {
        let (weight, drag_per_lift) = self.weight_and_drag().unwrap_or((1.0, DRAG_FOR_THE_EYE));
        let trim = &self.motion.model.trim;
        let (sin_climb, cos_climb) = trim.gamma0.sin_cos();
        let lift = weight * (cos_climb + load_change);
        let steady_drag = weight * cos_climb * drag_per_lift;
        let drag = steady_drag * (1.0 + 2.0 * u / trim.speed);
        let thrust = steady_drag + weight * sin_climb;
        let ((sin_a, cos_a), (sin_b, cos_b)) = (pose.alpha.sin_cos(), pose.beta.sin_cos());
        let trim_alpha = trim.alpha0 + self.fuselage_incidence();
        let [phi, theta, _] = pose.attitude;
        let down = [-theta.sin(), theta.cos() * phi.sin(), theta.cos() * phi.cos()];
        [
            [lift * sin_a, 0.0, -lift * cos_a],
            down.map(|x| weight * x),
            [thrust * trim_alpha.cos(), 0.0, thrust * trim_alpha.sin()],
            [-drag * cos_a * cos_b, -drag * sin_b, -drag * sin_a * cos_b],
        ]
    }

    /// Angle of attack of the fuselage in the steady flight \[rad\].
    pub fn steady_alpha(&self) -> f64 {
        self.motion.model.trim.alpha0 + self.fuselage_incidence()
    }

    /// Angle of attack of the fuselage beyond the α₀ of the model's axes \[rad\]: of stability axes all of it.
    fn fuselage_incidence(&self) -> f64 {
        match &self.scenario.edited.aircraft_model {
            AircraftModel::Coefficients(aircraft_model) => {
                let change = aircraft_model.derive().map_or(0.0, |derived| derived.flight.alpha_change);
                aircraft_model.reference.alpha0 + change
            }
            AircraftModel::Derivatives(_) | AircraftModel::Matrices(_) => 0.0,
        }
    }
}

/// The sample at or before a time, and the share of the way to the next.
fn place(t: f64, dt: f64, samples: usize) -> (usize, f64) {
    let last = samples.saturating_sub(1);
    let position = if dt > 0.0 { (t / dt).clamp(0.0, last as f64) } else { 0.0 };
    (position as usize, position.fract())
}
