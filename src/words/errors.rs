//! Why something can't be had, in a sentence.

use std::fmt::{Display, Formatter, Result};

use super::mode;
use crate::flight::aircraft::aircraft_model::ModelError;
use crate::flight::aircraft::atmosphere::AtmosphereError;
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

impl Display for AtmosphereError {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        let altitude = fixed(self.altitude, 0);
        write!(
            f,
            "the altitude of {altitude} m is outside the standard atmosphere used here, sea level to 20 000 m"
        )
    }
}

impl Display for ConditionError {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        match *self {
            Self::NoSpeed { speed } => {
                let speed = trimmed(speed, 4);
                write!(f, "the airspeed must be positive, not {speed} m/s: without air there is no lift")
            }
            Self::TooSteep { gamma0_deg } => {
                let angle = fixed(gamma0_deg, 0);
                write!(
                    f,
                    "the flight path of {angle}° is steeper than the 60° up to which this model is used"
                )
            }
            Self::Altitude(error) => error.fmt(f),
            Self::Stall { needed, cl_max, speed } => write!(
                f,
                "the wing would need C_L {} at {} m/s; this aircraft is taken to stall at {}",
                fixed(needed, 2),
                fixed(speed, 1),
                fixed(cl_max, 2)
            ),
            Self::Mach { mach, mach_min, mach_max } => write!(
                f,
                "Mach {} is outside {mach_min} to {mach_max}, where this aircraft’s coefficients hold",
                fixed(mach, 3)
            ),
            Self::NoLiftSlope { cl_alpha } => {
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

impl Display for ModelError {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        match *self {
            Self::Condition(error) => error.fmt(f),
            Self::Knob(error) => error.fmt(f),
            Self::Inertia { ratio } => write!(
                f,
                "Ixz² is {} times Ix Iz; no body has as much as 1: lower Ixz, or raise Ix or Iz",
                fixed(ratio, 3)
            ),
            Self::Heave { denominator } => write!(
                f,
                "1 − Zẇ is {}: the air carried along cancels the aircraft’s mass",
                significant(denominator, 3)
            ),
            Self::NotFinite { plane: Plane::Longitudinal } => f.write_str(
                "the longitudinal model has an entry that is not a finite number: a value is too large or too small",
            ),
            Self::NotFinite { plane: Plane::Lateral } => f.write_str(
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

impl Display for AnalysisError {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        match *self {
            Self::AircraftModel(error) => error.fmt(f),
            Self::Eigen(error) => error.fmt(f),
            Self::TrimSpeed(speed) => {
                write!(f, "the trim speed must be a positive number, not {} m/s", trimmed(speed, 4))
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

impl Display for SixDofError {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        match *self {
            Self::AircraftModel(error) => error.fmt(f),
            Self::Matrices => f.write_str(
                "this aircraft is given by its matrices, which hold for small disturbances only: flight far from the trim \
                 needs coefficients or derivatives",
            ),
            Self::NoLongitudinal => {
                f.write_str("without longitudinal data nothing is known of what holds the aircraft up")
            }
            Self::NoInertia => f.write_str(
                "the product of inertia is known but not Ix, Iy and Iz, without which the gyroscopic moments are not",
            ),
            Self::Trim { speed, theta_deg } => write!(
                f,
                "a trim at {} m/s and a pitch angle of {}° cannot be flown from",
                trimmed(speed, 4),
                fixed(theta_deg, 0)
            ),
            Self::NoBalance { residual } => write!(
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
impl Display for Stop {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        let time = fixed(self.time, 1);
        let degrees = |angle: f64| fixed(angle.to_degrees().abs(), 1);
        match self.reason {
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
                "at {time} s the airspeed is {} m/s, half the trim speed away from it, and this aircraft’s derivatives hold \
                 only near the trim",
                fixed(speed, 1)
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
