//! The textbooks' literal approximations beside the exact modes, with the error of each.
//!
//! All are in the stability axes of the trim, and each is the number of the formula printed beside it: V is the airspeed, g free
//! fall, Z_w, M_w and so on the derivatives before the ẇ terms are solved for. Where only matrices are known, their entries
//! stand for the derivatives, as if there were no ẇ terms. Sources: McRuer, Ashkenas & Graham, *Aircraft Dynamics and Automatic Control*, 1973, §§5–6;
//! Nelson, *Flight Stability and Automatic Control*, 2nd ed., §§4–5; Lanchester, *Aerodonetics*, 1908.

use nalgebra::{Complex, Matrix4, Vector4};

use super::mode::Mode;
use super::mode_name::ModeName;
use super::quartic::polynomial;
use super::second_order::{DUTCH_ROLL, PHUGOID, SHORT_PERIOD, SecondOrder, second_order};
use crate::flight::aircraft::aircraft_model::DerivativeModel;
use crate::flight::aircraft::axes::StabilityAxes;
use crate::flight::aircraft::plane::{Plane, PlaneModel};
use crate::flight::aircraft::states::Lateral::{P, Phi, R, V};
use crate::flight::aircraft::states::Longitudinal::{self, Q, Theta, U, W};
use crate::flight::aircraft::states::entry;
use crate::key::keys;

/// Which approximation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ApproximationName {
    /// Short period from w and q at constant speed.
    ShortPeriodTwoStates,
    /// Short period from q alone.
    ShortPeriodPitchOnly,
    /// Phugoid as Lanchester had it.
    PhugoidLanchester,
    /// Phugoid from u and θ at constant angle of attack.
    PhugoidTwoStates,
    /// Phugoid with w and q following at once.
    PhugoidResidualised,
    /// Phugoid from the end of the characteristic polynomial.
    PhugoidQuartic,
    /// Dutch roll from v and r.
    DutchRollTwoStates,
    /// Dutch roll from r alone.
    DutchRollYawOnly,
    /// Roll subsidence from p alone.
    RollDamping,
    /// Spiral from the last two coefficients of the characteristic polynomial.
    SpiralPolynomial,
    /// Spiral with gravity kept.
    SpiralWithGravity,
    /// Spiral in the short form of Nelson.
    SpiralQuick,
}

keys! {
    ApproximationName {
        ShortPeriodTwoStates => "short-period-two-states",
        ShortPeriodPitchOnly => "short-period-pitch-only",
        PhugoidLanchester => "phugoid-lanchester",
        PhugoidTwoStates => "phugoid-two-states",
        PhugoidResidualised => "phugoid-residualised",
        PhugoidQuartic => "phugoid-quartic",
        DutchRollTwoStates => "dutch-roll-two-states",
        DutchRollYawOnly => "dutch-roll-yaw-only",
        RollDamping => "roll-damping",
        SpiralPolynomial => "spiral-polynomial",
        SpiralWithGravity => "spiral-with-gravity",
        SpiralQuick => "spiral-quick",
    }
}

impl ApproximationName {
    /// Whether it is the first that a course would name of its mode: one for each.
    pub const fn is_principal(self) -> bool {
        matches!(
            self,
            Self::ShortPeriodTwoStates
                | Self::PhugoidTwoStates
                | Self::DutchRollTwoStates
                | Self::RollDamping
                | Self::SpiralWithGravity
        )
    }

    /// The mode that it approximates.
    pub const fn concerns(self) -> ModeName {
        match self {
            Self::ShortPeriodTwoStates | Self::ShortPeriodPitchOnly => ModeName::ShortPeriod,
            Self::PhugoidLanchester
            | Self::PhugoidTwoStates
            | Self::PhugoidResidualised
            | Self::PhugoidQuartic => ModeName::Phugoid,
            Self::DutchRollTwoStates | Self::DutchRollYawOnly => ModeName::DutchRoll,
            Self::RollDamping => ModeName::RollSubsidence,
            Self::SpiralPolynomial | Self::SpiralWithGravity | Self::SpiralQuick => ModeName::Spiral,
        }
    }
}

/// The numbers of an approximation, or of the exact mode beside it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ModeValue {
    /// An oscillation, or two roots taken together.
    SecondOrder {
        /// Natural frequency ωₙ \[rad/s\].
        natural_frequency: f64,
        /// Damping ratio ζ, where the approximation gives one.
        damping_ratio: Option<f64>,
    },
    /// A real root λ \[1/s\].
    Root(f64),
}

/// One approximation beside the exact mode.
#[derive(Clone, Debug, PartialEq)]
pub struct Approximation {
    /// Which.
    pub name: ApproximationName,
    /// Its result; `None` where it gives nothing (a negative ωₙ², a division by zero).
    pub value: Option<ModeValue>,
    /// The exact mode of the same kind; `None` where the aircraft has none.
    pub exact: Option<ModeValue>,
}

impl Approximation {
    /// The root that it gives \[1/s\], the upper one of a pair, the slower one of two real ones; `None` where it gives no root,
    /// or a frequency without damping.
    pub fn root(&self) -> Option<Complex<f64>> {
        let root = match self.value? {
            ModeValue::Root(root) => Complex::from(root),
            ModeValue::SecondOrder { natural_frequency: wn, damping_ratio: zeta } => {
                // λ = −ζωₙ ± ωₙ√(ζ² − 1)
                let zeta = zeta?;
                let part = wn * (zeta * zeta - 1.0).abs().sqrt();
                if zeta.abs() < 1.0 {
                    Complex::new(-zeta * wn, part)
                } else {
                    // The product of the two is ωₙ², which loses no digits.
                    Complex::from(-wn * wn / (zeta * wn + part.copysign(zeta)))
                }
            }
        };
        (root.re.is_finite() && root.im.is_finite()).then_some(root)
    }

    /// Relative error of ωₙ or of the root, approximate/exact − 1; `None` where either is missing.
    pub fn error(&self) -> Option<f64> {
        match (self.value?, self.exact?) {
            (
                ModeValue::SecondOrder { natural_frequency: approximate, .. },
                ModeValue::SecondOrder { natural_frequency: exact, .. },
            )
            | (ModeValue::Root(approximate), ModeValue::Root(exact)) => relative_error(approximate, exact),
            _ => None,
        }
    }

    /// Relative error of ζ, approximate/exact − 1; `None` where either is missing.
    pub fn damping_error(&self) -> Option<f64> {
        match (self.value?, self.exact?) {
            (
                ModeValue::SecondOrder { damping_ratio: Some(approximate), .. },
                ModeValue::SecondOrder { damping_ratio: Some(exact), .. },
            ) => relative_error(approximate, exact),
            _ => None,
        }
    }
}

/// Zero where it is but rounding: a formula may be exact.
fn relative_error(approximate: f64, exact: f64) -> Option<f64> {
    let error = approximate / exact - 1.0;
    error.is_finite().then_some(if error.abs() < 1e-12 { 0.0 } else { error })
}

/// The derivatives by ẇ, in the axes of their source.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DownwashLag {
    /// Z_ẇ, without dimension.
    pub z_wdot: f64,
    /// M_ẇ \[1/m\].
    pub m_wdot: f64,
    /// Angle of attack of those axes \[rad\].
    pub alpha0: f64,
}

impl DownwashLag {
    /// The derivatives of an aircraft; none where only matrices are known.
    pub fn of(derivatives: Option<&DerivativeModel>) -> Self {
        let lag = derivatives.and_then(|aircraft_model| {
            let d = aircraft_model.longitudinal?;
            Some(Self { z_wdot: d.z_wdot, m_wdot: d.m_wdot, alpha0: aircraft_model.trim.alpha0 })
        });
        lag.unwrap_or_default()
    }

    /// A in stability axes as it is before the ẇ terms are solved for: every entry less what ẇ adds to its row.
    pub fn unfold(self, a: &Matrix4<f64>) -> Matrix4<f64> {
        // ẇ of those axes is u̇ sin α₀ + ẇ cos α₀, their z axis [sin α₀, cos α₀]
        let (sin, cos) = self.alpha0.sin_cos();
        let rate = a.row(U.index()) * sin + a.row(W.index()) * cos;
        a - Vector4::new(self.z_wdot * sin, self.z_wdot * cos, self.m_wdot, 0.0) * rate
    }
}

/// Every approximation for the plane of `model`, in a fixed order; `modes` are its exact modes.
pub fn approximations(model: &StabilityAxes, lag: DownwashLag, modes: &[Mode]) -> Vec<Approximation> {
    let model = model.model();
    match model.plane {
        Plane::Longitudinal => longitudinal(model, lag, modes),
        Plane::Lateral => lateral(model, modes),
    }
}

fn longitudinal(model: &PlaneModel, lag: DownwashLag, modes: &[Mode]) -> Vec<Approximation> {
    use ApproximationName as Name;
    let a = &model.a;
    let plain = lag.unfold(a);
    let [x_u, z_u, z_w] = [entry(&plain, U, U), entry(&plain, W, U), entry(&plain, W, W)];
    let [m_w, m_q, m_wdot] = [entry(&plain, Q, W), entry(&plain, Q, Q), lag.m_wdot * lag.alpha0.cos()];
    // Its entry of weight is g cos γ₀.
    let (v, g) = (model.trim.speed, -entry(&plain, U, Theta) / model.trim.gamma0.cos());
    let short_period = second_order(modes, SHORT_PERIOD).map(full);
    let phugoid = second_order(modes, PHUGOID).map(full);
    // ωₙ² = −Zu g/V, 2ζωₙ = −Xu
    let two_states = SecondOrder::of(-x_u, -z_u * g / v);
    vec![
        Approximation {
            name: Name::ShortPeriodTwoStates,
            value: SecondOrder::of(-(z_w + m_q + v * m_wdot), z_w * m_q - v * m_w).map(full),
            exact: short_period,
        },
        Approximation {
            name: Name::ShortPeriodPitchOnly,
            value: SecondOrder::of(-(m_q + v * m_wdot), -v * m_w).map(full),
            exact: short_period,
        },
        Approximation {
            name: Name::PhugoidLanchester,
            value: frequency_only(std::f64::consts::SQRT_2 * g / v),
            exact: phugoid,
        },
        Approximation { name: Name::PhugoidTwoStates, value: two_states.map(full), exact: phugoid },
        Approximation { name: Name::PhugoidResidualised, value: residualised(a).map(full), exact: phugoid },
        Approximation { name: Name::PhugoidQuartic, value: quartic(a).map(full), exact: phugoid },
    ]
}

fn lateral(model: &PlaneModel, modes: &[Mode]) -> Vec<Approximation> {
    use ApproximationName as Name;
    let a = &model.a;
    let (y_v, v, g) = (entry(a, V, V), model.trim.speed, entry(a, V, Phi) / model.trim.gamma0.cos());
    let [l_v, l_p, l_r] = [entry(a, P, V), entry(a, P, P), entry(a, P, R)];
    let [n_v, n_p, n_r] = [entry(a, R, V), entry(a, R, P), entry(a, R, R)];
    let dutch_roll = second_order(modes, DUTCH_ROLL).map(full);
    let root = |name: ModeName| {
        modes.iter().find(|mode| mode.naming.name == name).map(|mode| ModeValue::Root(mode.lambda.re))
    };
    let spiral = root(ModeName::Spiral);
    // L'v N'r − N'v L'r, which is zero for a neutral spiral
    let neutral = l_v * n_r - n_v * l_r;
    let [_, _, d, e] = polynomial(a);
    vec![
        Approximation {
            name: Name::DutchRollTwoStates,
            value: SecondOrder::of(-(y_v + n_r), v * n_v + y_v * n_r).map(full),
            exact: dutch_roll,
        },
        Approximation {
            name: Name::DutchRollYawOnly,
            value: SecondOrder::of(-n_r, v * n_v).map(full),
            exact: dutch_roll,
        },
        Approximation {
            name: Name::RollDamping,
            value: finite_root(l_p),
            exact: root(ModeName::RollSubsidence),
        },
        Approximation { name: Name::SpiralPolynomial, value: finite_root(-e / d), exact: spiral },
        Approximation {
            name: Name::SpiralWithGravity,
            value: finite_root(-(g / v) * neutral / (l_v * (n_p - g / v) - n_v * l_p)),
            exact: spiral,
        },
        Approximation { name: Name::SpiralQuick, value: finite_root(neutral / l_v), exact: spiral },
    ]
}

fn full(motion: SecondOrder) -> ModeValue {
    ModeValue::SecondOrder {
        natural_frequency: motion.natural_frequency,
        damping_ratio: Some(motion.damping_ratio),
    }
}

fn frequency_only(natural_frequency: f64) -> Option<ModeValue> {
    (natural_frequency.is_finite() && natural_frequency > 0.0)
        .then_some(ModeValue::SecondOrder { natural_frequency, damping_ratio: None })
}

fn finite_root(root: f64) -> Option<ModeValue> {
    root.is_finite().then_some(ModeValue::Root(root))
}

/// Phugoid with w and q in balance at every moment: Aᵣ = A₁₁ − A₁₂ A₂₂⁻¹ A₂₁, 1 = (u, θ), 2 = (w, q).
fn residualised(a: &Matrix4<f64>) -> Option<SecondOrder> {
    // A₂₂ = [Zw, V; Mw, Mq]
    let [z_w, v, m_w, m_q] = [entry(a, W, W), entry(a, W, Q), entry(a, Q, W), entry(a, Q, Q)];
    let det = z_w * m_q - v * m_w;
    // w and q for a unit of the slow state: −A₂₂⁻¹ A₂₁
    let follow = |slow: Longitudinal| {
        let (z, m) = (entry(a, W, slow), entry(a, Q, slow));
        [-(m_q * z - v * m) / det, -(z_w * m - m_w * z) / det]
    };
    let reduced = |row: Longitudinal, column: Longitudinal| {
        let [w, q] = follow(column);
        entry(a, row, column) + entry(a, row, W) * w + entry(a, row, Q) * q
    };
    let [uu, u_theta] = [reduced(U, U), reduced(U, Theta)];
    let [theta_u, theta_theta] = [reduced(Theta, U), reduced(Theta, Theta)];
    SecondOrder::of(-(uu + theta_theta), uu * theta_theta - u_theta * theta_u)
}

/// Phugoid from the slow end of the quartic: λ² + (D/C − B E/C²) λ + E/C.
fn quartic(a: &Matrix4<f64>) -> Option<SecondOrder> {
    let [b, c, d, e] = polynomial(a);
    SecondOrder::of(d / c - b * e / (c * c), e / c)
}
