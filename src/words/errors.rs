//! Why something can't be had, in a sentence: its speeds and heights in the unit of length that is shown, or in SI.

use std::fmt::{Display, Formatter, Result};

use super::mode;
use crate::content::LengthUnit;
use crate::findings::Problem;
use crate::flight::aircraft::aircraft_model::ModelError;
use crate::flight::aircraft::atmosphere::{AtmosphereError, CEILING};
use crate::flight::aircraft::coefficients::AirframeError;
use crate::flight::aircraft::condition::ConditionError;
use crate::flight::aircraft::knobs::{Knob, KnobError};
use crate::flight::aircraft::plane::Plane;
use crate::flight::analysis::AnalysisError;
use crate::flight::modes::eigen::EigenError;
use crate::flight::modes::inverse::InverseError;
use crate::flight::motion::flight_path::{Reason, Stop};
use crate::flight::motion::modal_decomposition::SplitError;
use crate::flight::motion::six_dof::SixDofError;
use crate::number::{fixed, significant, trimmed};
use crate::scenario::Dimension;

/// An error whose sentence has its numbers in a unit of length. The sentence of the error alone has SI.
#[derive(Clone, Copy, Debug)]
pub struct Told<'a, E>(pub &'a E, pub LengthUnit);

/// The sentence of the error alone.
macro_rules! told_in_si {
    ($($error:ty),*) => {$(
        impl Display for $error {
            fn fmt(&self, f: &mut Formatter<'_>) -> Result {
                Told(self, LengthUnit::Metre).fmt(f)
            }
        }
    )*};
}

told_in_si!(AtmosphereError, ConditionError, ModelError, AnalysisError, SixDofError, Stop);

/// A speed \[m/s\] with its unit.
fn speed_of(speed: f64, length: LengthUnit, digits: impl Fn(f64) -> String) -> String {
    with_unit(Dimension::AirSpeed, speed, length, digits)
}

fn with_unit(dimension: Dimension, value: f64, length: LengthUnit, digits: impl Fn(f64) -> String) -> String {
    format!("{} {}", digits(value / dimension.in_si(length)), dimension.symbol(length))
}

impl Display for Told<'_, Problem> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        match self.0 {
            Problem::Analysis(error) => Told(error, self.1).fmt(f),
            Problem::NoData => self.0.fmt(f),
        }
    }
}

impl Display for Told<'_, AtmosphereError> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        let altitude = with_unit(Dimension::Length, self.0.altitude, self.1, |x| fixed(x, 0));
        let thousands = |x: f64| format!("{} {:03}", (x / 1000.0).trunc(), (x % 1000.0).trunc());
        let top = with_unit(Dimension::Length, CEILING, self.1, thousands);
        write!(
            f,
            "the altitude of {altitude} is outside the standard atmosphere used here, sea level to {top}"
        )
    }
}

impl Display for Told<'_, ConditionError> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        let Self(error, length) = *self;
        match *error {
            ConditionError::NoSpeed { speed } => {
                let speed = speed_of(speed, length, |x| trimmed(x, 4));
                write!(f, "the airspeed must be positive, not {speed}: without air there is no lift")
            }
            ConditionError::TooSteep { gamma0_deg } => {
                let angle = fixed(gamma0_deg, 0);
                write!(
                    f,
                    "the flight path of {angle}° is steeper than the 60° up to which this model is used"
                )
            }
            ConditionError::Altitude(ref error) => Told(error, length).fmt(f),
            ConditionError::Stall { needed, cl_max, speed } => write!(
                f,
                "the wing would need C_L {} at {}; this aircraft is taken to stall at {}",
                fixed(needed, 2),
                speed_of(speed, length, |x| fixed(x, 1)),
                fixed(cl_max, 2)
            ),
            ConditionError::Mach { mach, mach_min, mach_max } => write!(
                f,
                "Mach {} is outside {mach_min} to {mach_max}, where this aircraft’s coefficients hold",
                fixed(mach, 3)
            ),
            ConditionError::NoLiftSlope { cl_alpha } => {
                let slope = fixed(cl_alpha, 3);
                write!(
                    f,
                    "C_Lα is {slope}: lift that does not grow with the angle of attack cannot be trimmed"
                )
            }
        }
    }
}

impl Display for KnobError {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        let (knob, value) = match *self {
            Self::NoGeometry(knob) => return f.write_str(no_geometry(knob)),
            Self::Range { knob, value } => (knob, trimmed(value, 4)),
        };
        match knob {
            Knob::Mass => write!(f, "the mass ratio must be positive, not {value}"),
            Knob::Inertia => write!(f, "the ratio of a moment of inertia must be positive, not {value}"),
            Knob::CentreOfGravity => {
                write!(f, "the shift of the centre of gravity must be within one mean chord, not {value}")
            }
            Knob::Tail => write!(f, "the ratio of tail areas must be zero or more, not {value}"),
            Knob::Fin => write!(f, "the ratio of fin areas must be zero or more, not {value}"),
            Knob::Dihedral => write!(f, "the change of dihedral must be within 0.6 rad, not {value}"),
        }
    }
}

const fn no_geometry(knob: Knob) -> &'static str {
    match knob {
        Knob::Tail => "the horizontal tail cannot be changed: this aircraft’s data has no tail arm",
        Knob::Fin => "the fin cannot be changed: this aircraft’s data has no fin arm",
        Knob::Dihedral => {
            "the dihedral cannot be changed: this aircraft’s data has no taper ratio of the wing"
        }
        Knob::Mass | Knob::Inertia | Knob::CentreOfGravity => {
            "this knob cannot be turned: this aircraft’s data has no geometry for it"
        }
    }
}

impl Display for AirframeError {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        match *self {
            Self::NotPositive { key, value } => {
                write!(f, "{key} must be a positive number, not {}", trimmed(value, 4))
            }
            Self::ProductOfInertia { ixz, limit } => write!(
                f,
                "Ixz is {} kg m², but no body has |Ixz| ≥ √(Ix Iz) = {} kg m²",
                significant(ixz, 5),
                significant(limit, 5)
            ),
        }
    }
}

impl Display for Told<'_, ModelError> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        match *self.0 {
            ModelError::Condition(ref error) => Told(error, self.1).fmt(f),
            ModelError::Knob(error) => error.fmt(f),
            ModelError::Inertia { ratio } => write!(
                f,
                "Ixz² is {} times Ix Iz; no body has as much as 1: lower Ixz, or raise Ix or Iz",
                fixed(ratio, 3)
            ),
            ModelError::Heave { denominator } => write!(
                f,
                "1 − Zẇ is {}: the air carried along cancels the aircraft’s mass",
                significant(denominator, 3)
            ),
            ModelError::NotFinite { plane: Plane::Longitudinal } => f.write_str(
                "the longitudinal model has an entry that is not a finite number: a value is too large or too small",
            ),
            ModelError::NotFinite { plane: Plane::Lateral } => f.write_str(
                "the lateral model has an entry that is not a finite number: a value is too large or too small",
            ),
        }
    }
}

impl Display for EigenError {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        f.write_str(match self {
            Self::NotFinite => {
                "the motion cannot be computed: an entry of the state matrix is not a finite number, or is too large"
            }
            Self::NotConverged => {
                "the eigenvalues of this state matrix could not be found: the iteration did not settle"
            }
        })
    }
}

impl Display for Told<'_, AnalysisError> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        match *self.0 {
            AnalysisError::AircraftModel(ref error) => Told(error, self.1).fmt(f),
            AnalysisError::Eigen(error) => error.fmt(f),
            AnalysisError::TrimSpeed(speed) => {
                let speed = speed_of(speed, self.1, |x| trimmed(x, 4));
                write!(f, "the trim speed must be a positive number, not {speed}")
            }
        }
    }
}

impl Display for InverseError {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        f.write_str(match self {
            Self::Question => {
                "the bounds, scales and the wanted pole must be finite, with the present values within the bounds"
            }
            Self::NoModel => "the aircraft can’t be computed at the present values",
        })
    }
}

impl Display for Told<'_, SixDofError> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        match *self.0 {
            SixDofError::AircraftModel(ref error) => Told(error, self.1).fmt(f),
            SixDofError::Matrices => f.write_str(
                "this aircraft is given by its matrices, which hold for small disturbances only: flight far from the trim \
                 needs coefficients or derivatives",
            ),
            SixDofError::NoLongitudinal => {
                f.write_str("without longitudinal data nothing is known of what holds the aircraft up")
            }
            SixDofError::NoInertia => f.write_str(
                "the product of inertia is known but not Ix, Iy and Iz, without which the gyroscopic moments are not",
            ),
            SixDofError::Trim { speed, theta_deg } => write!(
                f,
                "a trim at {} and a pitch angle of {}° cannot be flown from",
                speed_of(speed, self.1, |x| trimmed(x, 4)),
                fixed(theta_deg, 0)
            ),
            SixDofError::NoBalance { residual } => write!(
                f,
                "no trim was found: an acceleration of {} m/s² or rad/s² is left",
                significant(residual, 2)
            ),
        }
    }
}

impl Display for SplitError {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        match *self {
            Self::Dependent { name, condition } => write!(
                f,
                "the {} shares its shape with another mode here (condition {}): the parts would be huge and cancel each \
                 other, so the split says nothing",
                mode::in_a_sentence(name),
                significant(condition, 4)
            ),
            Self::Drift { name } => write!(
                f,
                "the {} neither dies away nor grows, so its part in the path cannot be told from steady drift",
                mode::in_a_sentence(name)
            ),
        }
    }
}

/// Where and why a nonlinear flight stopped.
impl Display for Told<'_, Stop> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        let Self(stop, length) = *self;
        let time = fixed(stop.time, 1);
        let degrees = |angle: f64| fixed(angle.to_degrees().abs(), 1);
        match stop.reason {
            Reason::AngleOfAttack(alpha) if alpha < 0.0 => write!(
                f,
                "at {time} s the angle of attack is {}° below the trim’s, and beyond that this aircraft’s data mean nothing",
                degrees(alpha)
            ),
            Reason::AngleOfAttack(alpha) => write!(
                f,
                "at {time} s the angle of attack is {}° above the trim’s, and beyond that this aircraft’s data mean nothing",
                degrees(alpha)
            ),
            Reason::Sideslip(beta) if beta < 0.0 => write!(
                f,
                "at {time} s the sideslip is {}° to the left, and beyond that this aircraft’s data mean nothing",
                degrees(beta)
            ),
            Reason::Sideslip(beta) => write!(
                f,
                "at {time} s the sideslip is {}° to the right, and beyond that this aircraft’s data mean nothing",
                degrees(beta)
            ),
            Reason::Mach(mach) => write!(
                f,
                "at {time} s the Mach number is {}, and beyond that this aircraft’s coefficients do not hold",
                fixed(mach, 2)
            ),
            Reason::Airspeed(speed) => write!(
                f,
                "at {time} s the airspeed is {}, half the trim speed away from it, and this aircraft’s derivatives hold \
                 only near the trim",
                speed_of(speed, length, |x| fixed(x, 1))
            ),
            Reason::NoLateralData => write!(
                f,
                "at {time} s something moves the aircraft out of its plane of symmetry, and it has no lateral data"
            ),
            Reason::TooFast => {
                write!(f, "at {time} s the motion is too fast or too large to be followed any further")
            }
            Reason::Input => write!(f, "at {time} s a control or the wind is not a finite number"),
        }
    }
}
