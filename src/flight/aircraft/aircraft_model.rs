//! An aircraft as a person may edit it, from whatever its source has, and the linear models that follow.

use thiserror::Error;

use super::coefficients::{Airframe, Coefficients};
use super::condition::{
    ConditionError, FlightCondition, Reference, SteadyFlight, Validity, at_lift, steady_flight,
};
use super::derivatives::{LateralDerivatives, LongitudinalDerivatives, lateral_model, longitudinal_model};
use super::knobs::{KnobError, Knobs};
use super::plane::{ByPlane, Plane, PlaneModel, Trim};
use super::real::{Dual64, Real, constant};
use crate::flight::aircraft::inertia::Inertia;

/// Everything editable of an aircraft, starting where its source starts.
#[derive(Clone, Debug, PartialEq)]
pub enum AircraftModel {
    /// From coefficients: every slider and every knob.
    Coefficients(CoefficientModel),
    /// From dimensional derivatives at one trim: every derivative.
    Derivatives(DerivativeModel),
    /// From bare matrices: every entry.
    Matrices(MatrixModel),
}

/// An aircraft given by coefficients.
#[derive(Clone, Debug, PartialEq)]
pub struct CoefficientModel<T = f64> {
    /// Mass and geometry of the reference.
    pub airframe: Airframe<T>,
    /// The source's steady flight.
    pub reference: Reference,
    /// How far from it the coefficients hold.
    pub validity: Validity,
    /// Steady flight now.
    pub condition: FlightCondition<T>,
    /// Knobs now.
    pub knobs: Knobs<T>,
    /// Coefficients of the reference, as edited.
    pub coefficients: Coefficients<T>,
}

/// An aircraft given by dimensional derivatives.
#[derive(Clone, Debug, PartialEq)]
pub struct DerivativeModel<T = f64> {
    /// The steady flight; α₀ is not zero in body axes.
    pub trim: Trim<T>,
    /// Moments of inertia in the axes of the derivatives, where the source has them. The linear models need only the ratios
    /// in [`LateralDerivatives`]; the gyroscopic moments of nonlinear flight need all four.
    pub inertia: Option<Inertia<T>>,
    /// Longitudinal derivatives.
    pub longitudinal: Option<LongitudinalDerivatives<T>>,
    /// Lateral derivatives, unprimed.
    pub lateral: Option<LateralDerivatives<T>>,
}

/// An aircraft given by its matrices.
pub type MatrixModel = ByPlane<Option<PlaneModel>>;

/// The linear models of both planes. A plane without data, or with a problem, leaves the other alone.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Models<T = f64> {
    /// The models.
    pub planes: ByPlane<Option<PlaneModel<T>>>,
    /// Why a plane that has data has no model.
    pub problems: Vec<ModelError>,
}

/// Why there is no model.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum ModelError {
    /// There is no such steady flight.
    Condition(#[from] ConditionError),
    /// A knob cannot stand so.
    Knob(#[from] KnobError),
    /// Ixz too large for Ix and Iz.
    Inertia {
        /// Ixz²/(Ix Iz).
        ratio: f64,
    },
    /// 1 − Zẇ = 0.
    Heave {
        /// 1 − Zẇ.
        denominator: f64,
    },
    /// Overflow or NaN.
    NotFinite {
        /// Which plane.
        plane: Plane,
    },
}

impl ModelError {
    /// The plane that it concerns; `None` where there is no such steady flight, so neither plane.
    pub const fn plane(&self) -> Option<Plane> {
        match self {
            Self::Condition(_) | Self::Knob(_) => None,
            Self::Inertia { .. } => Some(Plane::Lateral),
            Self::Heave { .. } => Some(Plane::Longitudinal),
            Self::NotFinite { plane } => Some(*plane),
        }
    }
}

/// The steps between coefficients and matrices, for showing.
#[derive(Clone, Debug, PartialEq)]
pub struct TrimmedModel<T = f64> {
    /// The steady flight.
    pub flight: SteadyFlight<T>,
    /// Airframe with the knobs applied.
    pub airframe: Airframe<T>,
    /// Coefficients with knobs and condition applied.
    pub coefficients: Coefficients<T>,
    /// Dimensional derivatives and trim, stability axes.
    pub derivatives: DerivativeModel<T>,
}

impl CoefficientModel {
    /// An aircraft in its reference condition.
    pub fn new(
        airframe: Airframe,
        reference: Reference,
        validity: Validity,
        coefficients: Coefficients,
    ) -> Self {
        let condition = reference.condition;
        Self { airframe, reference, validity, condition, knobs: Knobs::default(), coefficients }
    }

    /// The same with numbers that are constant, to put a parameter among them.
    pub fn constant(&self) -> CoefficientModel<Dual64> {
        CoefficientModel {
            airframe: self.airframe.constant(),
            reference: self.reference,
            validity: self.validity,
            condition: constant(&self.condition),
            knobs: constant(&self.knobs),
            coefficients: Coefficients {
                longitudinal: constant(&self.coefficients.longitudinal),
                lateral: self.coefficients.lateral.as_ref().map(constant),
            },
        }
    }
}

impl<T: Real> CoefficientModel<T> {
    /// Knobs, then condition, then dimensional derivatives.
    pub fn derive(&self) -> Result<TrimmedModel<T>, ModelError> {
        let (airframe, coefficients) = self.knobs.apply(&self.airframe, &self.coefficients)?;
        let flight =
            steady_flight(&self.condition, &self.reference, &self.validity, &airframe, &coefficients)?;
        let coefficients = at_lift(&coefficients, &flight, &self.reference);
        let inertia = airframe.stability_inertia(self.reference.alpha0, flight.alpha_change);
        let longitudinal =
            LongitudinalDerivatives::from_coefficients(&coefficients.longitudinal, &airframe, &flight);
        let lateral = coefficients
            .lateral
            .map(|c| LateralDerivatives::from_coefficients(&c, &airframe, &inertia, &flight));
        let FlightCondition { speed, gamma0, .. } = self.condition;
        let trim = Trim { speed, alpha0: 0.0, gamma0, gravity: self.reference.gravity };
        let inertia = Some(Inertia { ix: inertia.ix, iy: airframe.iy, iz: inertia.iz, ixz: inertia.ixz });
        let derivatives = DerivativeModel { trim, inertia, longitudinal: Some(longitudinal), lateral };
        Ok(TrimmedModel { flight, airframe, coefficients, derivatives })
    }
}

impl DerivativeModel {
    /// The same with numbers that are constant, to put a parameter among them.
    pub fn constant(&self) -> DerivativeModel<Dual64> {
        let Trim { speed, alpha0, gamma0, gravity } = self.trim;
        DerivativeModel {
            trim: Trim { speed: speed.into(), alpha0, gamma0: gamma0.into(), gravity },
            inertia: self.inertia.as_ref().map(constant),
            longitudinal: self.longitudinal.as_ref().map(constant),
            lateral: self.lateral.as_ref().map(constant),
        }
    }
}

impl<T: Real> DerivativeModel<T> {
    /// The models; a problem of one plane leaves the other.
    pub fn models(&self) -> Models<T> {
        let mut models =
            Models { planes: ByPlane { longitudinal: None, lateral: None }, problems: Vec::new() };
        if let Some(d) = &self.longitudinal {
            let denominator = 1.0 - d.z_wdot.re();
            let made = if denominator.abs() < 1e-9 {
                Err(ModelError::Heave { denominator })
            } else {
                finite(longitudinal_model(d, &self.trim))
            };
            models.planes.longitudinal = models.kept(made);
        }
        if let Some(d) = &self.lateral {
            let ratio = (d.ixz_over_ix * d.ixz_over_iz).re();
            let made = if ratio < 1.0 {
                finite(lateral_model(d, &self.trim))
            } else {
                Err(ModelError::Inertia { ratio })
            };
            models.planes.lateral = models.kept(made);
        }
        models
    }
}

impl<T: Real> Models<T> {
    fn kept(&mut self, made: Result<PlaneModel<T>, ModelError>) -> Option<PlaneModel<T>> {
        match made {
            Ok(model) => Some(model),
            Err(problem) => {
                self.problems.push(problem);
                None
            }
        }
    }
}

fn finite<T: Real>(model: PlaneModel<T>) -> Result<PlaneModel<T>, ModelError> {
    let further = model.further.as_ref().is_none_or(|further| further.is_finite());
    let good = further && model.a.iter().chain(&model.b).all(|x| x.re().is_finite());
    if good { Ok(model) } else { Err(ModelError::NotFinite { plane: model.plane }) }
}

impl AircraftModel {
    /// The linear models. An error means that there is no such steady flight, so neither plane has a model.
    pub fn models(&self) -> Result<Models, ModelError> {
        match self {
            Self::Coefficients(aircraft_model) => Ok(aircraft_model.derive()?.derivatives.models()),
            Self::Derivatives(aircraft_model) => Ok(aircraft_model.models()),
            Self::Matrices(aircraft_model) => {
                let mut models = Models::default();
                models.planes =
                    aircraft_model.clone().map(|model| model.and_then(|m| models.kept(finite(m))));
                Ok(models)
            }
        }
    }

    /// Whether there are data of a plane.
    pub fn has(&self, plane: Plane) -> bool {
        match self {
            Self::Coefficients(aircraft_model) => {
                plane == Plane::Longitudinal || aircraft_model.coefficients.lateral.is_some()
            }
            Self::Derivatives(aircraft_model) => match plane {
                Plane::Longitudinal => aircraft_model.longitudinal.is_some(),
                Plane::Lateral => aircraft_model.lateral.is_some(),
            },
            Self::Matrices(aircraft_model) => aircraft_model[plane].is_some(),
        }
    }

    /// The same aircraft with its dimensional derivatives free: from coefficients they are derived once and the knobs
    /// are left behind. Bare matrices have no derivatives.
    pub fn to_derivatives(&self) -> Result<Option<DerivativeModel>, ModelError> {
        match self {
            Self::Coefficients(aircraft_model) => Ok(Some(aircraft_model.derive()?.derivatives)),
            Self::Derivatives(aircraft_model) => Ok(Some(aircraft_model.clone())),
            Self::Matrices(_) => Ok(None),
        }
    }
}
