//! The one table of adjustable quantities. A row is a slider, a name for screen readers, and a range that tests walk to
//! both ends. One file a page of sliders.

mod added;
mod coefficients;
mod dimensional;
mod disturbance;
mod feedback;
mod knobs;
mod matrix;
mod rate;
mod rows;
mod written;

use std::ops::RangeInclusive;

pub use rows::parameters;
use thiserror::Error;
pub use written::Written;

use super::{Dimension, Scenario, Sizes};
use crate::content::Aircraft;
use crate::flight::aircraft::aircraft_model::{AircraftModel, DerivativeModel, Models};
use crate::flight::aircraft::coefficients::{Coefficients, LateralCoefficients, LongitudinalCoefficients};
use crate::flight::aircraft::condition::FlightCondition;
use crate::flight::aircraft::derivatives::{LateralDerivatives, LongitudinalDerivatives};
use crate::flight::aircraft::knobs::Knobs;
use crate::flight::aircraft::plane::Plane;
use crate::flight::feedback::Law;
use crate::key::keys;
use crate::number::trimmed;

/// A page of sliders.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Page {
    /// Nondimensional coefficients, and the knobs that move them.
    Coefficients,
    /// Dimensional derivatives.
    Dimensional,
    /// Entries of A and B.
    Matrix,
    /// Gains of a law of feedback, and its filters.
    Feedback,
}

keys! {
    Page {
        Coefficients => "coefficients",
        Dimensional => "dimensional",
        Matrix => "matrix",
        Feedback => "feedback",
    }
}

impl Page {
    /// Those of the derivatives pane, in its order.
    pub const ALL: [Self; 4] = [Self::Coefficients, Self::Dimensional, Self::Matrix, Self::Feedback];

    /// Whether an aircraft goes back that far.
    pub fn is_of(self, scenario: &Scenario) -> bool {
        match self {
            Self::Coefficients => matches!(scenario.edited.aircraft_model, AircraftModel::Coefficients(_)),
            Self::Dimensional => !matches!(scenario.edited.aircraft_model, AircraftModel::Matrices(_)),
            Self::Matrix | Self::Feedback => true,
        }
    }

    /// The first page that an aircraft has.
    pub fn of(scenario: &Scenario) -> Self {
        Self::ALL.into_iter().find(|page| page.is_of(scenario)).unwrap_or(Self::Matrix)
    }
}

/// Variable that a parameter multiplies, or subject that it belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Group {
    /// Knobs of the aircraft and its flight.
    Aircraft,
    /// Speed u, and the steady forces.
    Speed,
    /// Angle of attack, or w.
    AngleOfAttack,
    /// Its rate, or ẇ.
    AngleOfAttackRate,
    /// Pitch rate q.
    PitchRate,
    /// Sideslip, or v.
    Sideslip,
    /// Roll rate p.
    RollRate,
    /// Yaw rate r.
    YawRate,
    /// Gravity: θ or φ.
    Attitude,
    /// Elevator.
    Elevator,
    /// Throttle.
    Throttle,
    /// Aileron.
    Aileron,
    /// Rudder.
    Rudder,
    /// Mach number.
    Mach,
    /// Washouts and lags on the way of a feedback.
    Filters,
    /// The disturbance.
    Disturbance,
}

impl Group {
    /// The groups of the derivatives pane, in its order: what can be seen on an aircraft, its stiffness and damping, then the
    /// rest, and last what is next to nothing at low speed.
    pub const DERIVATIVES: [Self; 15] = [
        Self::Aircraft,
        Self::AngleOfAttack,
        Self::PitchRate,
        Self::AngleOfAttackRate,
        Self::Sideslip,
        Self::RollRate,
        Self::YawRate,
        Self::Speed,
        Self::Attitude,
        Self::Elevator,
        Self::Throttle,
        Self::Aileron,
        Self::Rudder,
        Self::Filters,
        Self::Mach,
    ];
}

/// Place of a parameter in the scenario.
#[derive(Clone, Copy, Debug)]
enum Place {
    LongitudinalCoefficient(fn(&mut LongitudinalCoefficients) -> &mut f64),
    LateralCoefficient(fn(&mut LateralCoefficients) -> &mut f64),
    Knob(fn(&mut Knobs) -> &mut f64),
    Condition(fn(&mut FlightCondition) -> &mut f64),
    LongitudinalDerivative(fn(&mut LongitudinalDerivatives) -> &mut f64),
    LateralDerivative(fn(&mut LateralDerivatives) -> &mut f64),
    /// Entry of A: row, column, and −1 where the book writes it with a minus sign.
    A(Plane, usize, usize, f64),
    /// Entry of B: row and column.
    B(Plane, usize, usize),
    Feedback(fn(&mut Law) -> &mut f64),
    Disturbance(fn(&mut Sizes) -> &mut f64),
}

/// Range of a slider.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Extent {
    /// From `low` to `high` times the size of the reference value, or of `floor` where that is larger.
    /// The floor is in units of 1/s or 1/s² and is taken times or over V where the parameter's unit has a length.
    Relative { low: f64, high: f64, floor: f64 },
    /// From zero to five times standard gravity, and beyond where the reference itself is beyond.
    Gravity,
    /// Fixed, SI.
    Fixed { low: f64, high: f64 },
}

/// An adjustable quantity: a row of the table.
#[derive(Clone, Debug)]
pub struct Parameter {
    /// Short name, never changed once published.
    pub key: &'static str,
    /// Symbol as the book writes it, in the notation of the page's symbols.
    pub symbol: &'static str,
    /// Name in words, for screen readers and the help card.
    pub name: &'static str,
    /// The page it stands on; `None` for the size of a disturbance, which stands with the choosers of that.
    pub page: Option<Page>,
    /// The plane whose page shows it; `None` for both.
    pub plane: Option<Plane>,
    /// Its group on the page.
    pub group: Group,
    /// Its dimension, for its unit.
    pub dimension: Dimension,
    /// Its meaning, in a sentence.
    pub meaning: &'static str,
    /// The sign that stabilises, or the effect of a positive or a larger value.
    pub sign: &'static str,
    /// The part of the aircraft that it comes from; the relation that a knob uses; empty for a disturbance.
    pub origin: &'static str,
    place: Place,
    extent: Extent,
}

/// A key stands for its row.
impl PartialEq for Parameter {
    fn eq(&self, other: &Self) -> bool {
        self.key == other.key
    }
}

/// Refusal of a value.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum ValueError {
    /// The text isn't a number.
    NotANumber(String),
    /// NaN or infinite.
    NotFinite,
    /// Between two whole numbers, where only those mean something.
    NotWhole,
    /// Beyond anything with a meaning.
    Absurd {
        /// The refused value, in the shown unit.
        value: String,
        /// Least accepted value, in the shown unit.
        low: String,
        /// Greatest accepted value, in the shown unit.
        high: String,
        /// The shown unit.
        unit: &'static str,
    },
}

/// A derivative may be typed up to this many times its slider's extent; beyond that it is a slip of the finger.
const TYPED_BEYOND: f64 = 100.0;

impl Parameter {
    /// Whether this aircraft has it: its source goes back that far, and the number is not zero by its structure.
    pub fn applies(&self, scenario: &Scenario) -> bool {
        self.value(scenario).is_some()
    }

    /// Whether it sizes a disturbance, and is no part of the aircraft.
    pub fn is_of_disturbance(&self) -> bool {
        matches!(self.place, Place::Disturbance(_))
    }

    /// Whether it is a gain of a law of feedback, and no washout or lag.
    pub fn is_gain(&self) -> bool {
        matches!(self.place, Place::Feedback(_)) && self.group != Group::Filters
    }

    /// Whether it is the time constant of a washout or a lag on the way of a feedback, of which zero is none.
    pub fn is_filter(&self) -> bool {
        self.group == Group::Filters
    }

    /// Whether it stands on a page for the plane on screen.
    pub fn is_shown(&self, scenario: &Scenario, page: Page) -> bool {
        let of_plane = self.plane.is_none_or(|plane| plane == scenario.plane);
        self.page == Some(page) && of_plane && self.applies(scenario)
    }

    /// Its value \[SI\]; zero where the aircraft has none.
    pub fn get(&self, scenario: &Scenario) -> f64 {
        self.value(scenario).unwrap_or(0.0)
    }

    /// Its value \[SI\] among the coefficients that are in effect, where knobs and flight condition have moved it away from its own.
    pub fn in_effect(&self, scenario: &Scenario, coefficients: &Coefficients) -> Option<f64> {
        let moved = match self.place {
            Place::LongitudinalCoefficient(of) => read(of, &coefficients.longitudinal),
            Place::LateralCoefficient(of) => read(of, coefficients.lateral.as_ref()?),
            Place::Knob(_)
            | Place::Condition(_)
            | Place::LongitudinalDerivative(_)
            | Place::LateralDerivative(_)
            | Place::A(..)
            | Place::B(..)
            | Place::Feedback(_)
            | Place::Disturbance(_) => return None,
        };
        let own = self.value(scenario)?;
        ((moved - own).abs() > 1e-9 * own.abs().max(moved.abs())).then_some(moved)
    }

    /// Its value \[SI\], if the aircraft has it.
    fn value(&self, scenario: &Scenario) -> Option<f64> {
        let edited = &scenario.edited;
        let derivatives = || edited.derivatives().ok()?;
        self.value_among(
            &edited.aircraft_model,
            derivatives,
            || edited.models().ok(),
            &scenario.law,
            &scenario.disturbance.sizes,
        )
    }

    /// Its value \[SI\] before anything is edited or chosen; zero where the aircraft has none.
    fn baseline(&self, scenario: &Scenario) -> f64 {
        let Aircraft { aircraft_model, baseline, .. } = &*scenario.aircraft;
        let (derivatives, models) = (|| baseline.derivatives.clone(), || Some(baseline.models.clone()));
        self.value_among(aircraft_model, derivatives, models, &Law::default(), &Sizes::default())
            .unwrap_or(0.0)
    }

    fn value_among(
        &self,
        aircraft_model: &AircraftModel,
        derivatives: impl FnOnce() -> Option<DerivativeModel>,
        models: impl FnOnce() -> Option<Models>,
        law: &Law,
        sizes: &Sizes,
    ) -> Option<f64> {
        let of_coefficients = match aircraft_model {
            AircraftModel::Coefficients(aircraft_model) => Some(aircraft_model),
            AircraftModel::Derivatives(_) | AircraftModel::Matrices(_) => None,
        };
        match self.place {
            Place::LongitudinalCoefficient(of) => {
                of_coefficients.map(|aircraft_model| read(of, &aircraft_model.coefficients.longitudinal))
            }
            Place::LateralCoefficient(of) => Some(read(of, of_coefficients?.coefficients.lateral.as_ref()?)),
            Place::Knob(of) => of_coefficients.map(|aircraft_model| read(of, &aircraft_model.knobs)),
            Place::Condition(of) => of_coefficients.map(|aircraft_model| read(of, &aircraft_model.condition)),
            Place::LongitudinalDerivative(of) => Some(read(of, derivatives()?.longitudinal.as_ref()?)),
            Place::LateralDerivative(of) => Some(read(of, derivatives()?.lateral.as_ref()?)),
            Place::A(plane, row, column, sign) => {
                Some(sign * models()?.planes[plane].as_ref()?.a[(row, column)])
            }
            Place::B(plane, row, column) => Some(models()?.planes[plane].as_ref()?.b[(row, column)]),
            Place::Feedback(of) => {
                let is_there = self.plane.is_none_or(|plane| aircraft_model.has(plane));
                is_there.then(|| read(of, law))
            }
            Place::Disturbance(of) => Some(read(of, sizes)),
        }
    }

    /// Sets it to a value \[SI\] that [`Self::check`] has accepted; does nothing where the aircraft has none.
    ///
    /// A value that follows from others is set by an offset on it.
    pub fn set(&self, scenario: &mut Scenario, value: f64) {
        if let Some(before) = self.value(scenario) {
            self.shift(scenario, before, value);
        }
    }

    /// The same where the value before is known.
    pub(crate) fn shift(&self, scenario: &mut Scenario, before: f64, value: f64) {
        if let Some((offset, sign)) = self.offset(&mut scenario.edited.offsets) {
            *offset += sign * (value - before);
        } else if let Some(own) = self.own(scenario) {
            *own = value;
            // A time that is set stays as it is set.
            scenario.disturbance.follows &= self.key != "time";
        }
    }

    /// The number itself, where it follows from nothing and the aircraft has it.
    fn own<'a>(&self, scenario: &'a mut Scenario) -> Option<&'a mut f64> {
        let of_coefficients = match &mut scenario.edited.aircraft_model {
            AircraftModel::Coefficients(aircraft_model) => Some(aircraft_model),
            AircraftModel::Derivatives(_) | AircraftModel::Matrices(_) => None,
        };
        match self.place {
            Place::LongitudinalCoefficient(of) => Some(of(&mut of_coefficients?.coefficients.longitudinal)),
            Place::LateralCoefficient(of) => Some(of(of_coefficients?.coefficients.lateral.as_mut()?)),
            Place::Knob(of) => Some(of(&mut of_coefficients?.knobs)),
            Place::Condition(of) => Some(of(&mut of_coefficients?.condition)),
            Place::Feedback(of) => Some(of(&mut scenario.law)),
            Place::Disturbance(of) => Some(of(&mut scenario.disturbance.sizes)),
            Place::LongitudinalDerivative(_) | Place::LateralDerivative(_) | Place::A(..) | Place::B(..) => {
                None
            }
        }
    }

    /// Takes back what was done to it: the value of the aircraft's file, or no offset on what follows from the rest.
    pub fn reset(&self, scenario: &mut Scenario) {
        if self.added(scenario).is_some() {
            self.set_added(scenario, 0.0);
        } else {
            self.set(scenario, self.baseline(scenario));
            // The time shown follows the motion until somebody sets it.
            scenario.disturbance.follows |= self.key == "time";
        }
    }

    /// Sets it to a value \[SI\]; at its reference nothing is left of an edit.
    pub fn set_or_reset(&self, scenario: &mut Scenario, value: f64) {
        if value == self.reference(scenario) {
            self.reset(scenario);
        } else {
            self.set(scenario, value);
        }
    }

    /// The value that [`Self::reset`] leads to \[SI\].
    pub fn reference(&self, scenario: &Scenario) -> f64 {
        match self.added(scenario) {
            Some(offset) => self.get(scenario) - offset,
            None => self.baseline(scenario),
        }
    }

    /// Whether it differs from its reference.
    pub fn is_edited(&self, scenario: &Scenario) -> bool {
        match self.added(scenario) {
            Some(offset) => offset != 0.0,
            None => self.get(scenario) != self.baseline(scenario),
        }
    }

    /// The physical range of its slider \[SI\]. A typed value may lie outside.
    ///
    /// It belongs to the aircraft's file, not to what has been edited: a slider doesn't move under the hand.
    pub fn range(&self, scenario: &Scenario) -> RangeInclusive<f64> {
        let reference = self.baseline(scenario);
        match self.extent {
            Extent::Relative { low, high, floor } => {
                let speed = scenario.aircraft.speed();
                let floor = match self.dimension {
                    Dimension::Speed | Dimension::Acceleration => floor * speed,
                    Dimension::PerLengthSecond | Dimension::PerLength => floor / speed,
                    _ => floor,
                };
                let size = reference.abs().max(floor);
                low * size..=high * size
            }
            Extent::Gravity => {
                let reach = (5.0 * crate::flight::analysis::STANDARD_GRAVITY).max(1.25 * reference.abs());
                0.0..=reach
            }
            Extent::Fixed { low, high } => low..=high,
        }
    }

    /// A change of it that one would notice \[SI\]: ten per cent of its size, or a sixtieth of its slider where it is near zero.
    pub fn notable_change(&self, scenario: &Scenario) -> f64 {
        let range = self.range(scenario);
        (0.1 * self.get(scenario).abs()).max((range.end() - range.start()) / 60.0)
    }

    /// Range that [`Self::check`] accepts \[SI\].
    pub fn accepted(&self, scenario: &Scenario) -> RangeInclusive<f64> {
        let range = self.range(scenario);
        match self.extent {
            Extent::Fixed { .. } => range,
            Extent::Relative { .. } | Extent::Gravity => {
                let reach = TYPED_BEYOND * range.start().abs().max(range.end().abs());
                -reach..=reach
            }
        }
    }

    /// Accepts or refuses a value \[SI\] that was typed or came from outside.
    pub fn check(&self, scenario: &Scenario, value: f64) -> Result<f64, ValueError> {
        self.check_within(scenario, value, self.accepted(scenario))
    }

    fn check_within(
        &self,
        scenario: &Scenario,
        value: f64,
        accepted: RangeInclusive<f64>,
    ) -> Result<f64, ValueError> {
        if !value.is_finite() {
            return Err(ValueError::NotFinite);
        }
        if self.dimension == Dimension::Count && value.fract() != 0.0 {
            return Err(ValueError::NotWhole);
        }
        if accepted.contains(&value) {
            return Ok(value);
        }
        let written = self.written(scenario.convention());
        let shown = |si: f64| trimmed(si / written.in_si, 4);
        Err(ValueError::Absurd {
            value: shown(value),
            low: shown(*accepted.start()),
            high: shown(*accepted.end()),
            unit: written.unit,
        })
    }

    /// Reads typed text in the shown unit; `−` counts as minus and a comma as a decimal point.
    pub fn parse(&self, scenario: &Scenario, text: &str) -> Result<f64, ValueError> {
        let plain = text.trim().replace('−', "-").replace(',', ".");
        let shown: f64 = plain.parse().map_err(|_| ValueError::NotANumber(text.trim().to_owned()))?;
        self.check(scenario, shown * self.written(scenario.convention()).in_si)
    }
}

fn read<T: Copy>(of: fn(&mut T) -> &mut f64, from: &T) -> f64 {
    let mut copy = *from;
    *of(&mut copy)
}
