//! The textbook formula that has a change, with the terms that it is made of.
//!
//! An approximation may be good for one aircraft and still miss what a change does to it: Lanchester's phugoid knows nothing of M_q.
//! So the formula told is the simplest that is near the exact number before and after, and near the exact change.

use super::subject::Side;
use crate::flight::aircraft::axes::StabilityAxes;
use crate::flight::aircraft::states::Lateral::{P, Phi, R, V};
use crate::flight::aircraft::states::Longitudinal::{Q, Theta, U, W};
use crate::flight::aircraft::states::entry;
use crate::flight::analysis::PlaneAnalysis;
use crate::flight::modes::approximations::{ApproximationName, DownwashLag, ModeValue};
use crate::flight::modes::mode_name::ModeName;
use crate::flight::modes::quartic::polynomial;

/// Good, of the number and of the change: the simplest formula with no larger errors is told.
const GOOD: (f64, f64) = (0.05, 0.15);
/// If there is none, the simplest that is good of the change and no worse than this of the number.
const FAIR: (f64, f64) = (0.5, 0.15);
/// A formula as it is written may leave out what the slope of the flight path adds, by no more than this fraction.
const LEFT_OUT: f64 = 0.02;
/// Beyond this error of either a formula doesn't have it.
const BEYOND: f64 = 0.3;

/// What a formula gives.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Measured {
    /// ωₙ² \[1/s²\].
    Frequency,
    /// 2ζωₙ \[1/s\].
    Damping,
    /// λ \[1/s\].
    Root,
}

/// A formula with its numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct Formula {
    /// The approximation that it is of.
    pub name: ApproximationName,
    /// What it gives.
    pub measured: Measured,
    /// Relative error of what it gives, approximate/exact − 1.
    pub error: f64,
    /// Error of the change that it gives, over the change.
    pub missed: f64,
    /// What it is made of.
    pub terms: Terms,
}

/// What a formula is made of: numbers in the order in which it is written.
#[derive(Clone, Debug, PartialEq)]
pub enum Terms {
    /// They add up.
    Sum(Vec<f64>),
    /// The first two over the last two.
    Quotient([f64; 2], [f64; 2]),
}

impl Terms {
    /// What they make.
    pub fn value(&self) -> f64 {
        match self {
            Self::Sum(terms) => terms.iter().sum(),
            Self::Quotient(over, under) => (over[0] + over[1]) / (under[0] + under[1]),
        }
    }
}

/// The formula that has a change of a mode, before and after; `exact` is ωₙ, 2ζωₙ or λ.
pub(super) fn with_change(
    sides: [Side<'_>; 2],
    mode: ModeName,
    measured: Measured,
    exact: [f64; 2],
) -> Option<[Formula; 2]> {
    use ApproximationName as Name;
    let candidates: &[Name] = match (mode, measured) {
        (ModeName::ShortPeriod, _) => &[Name::ShortPeriodTwoStates],
        (ModeName::Phugoid, Measured::Frequency) => {
            &[Name::PhugoidTwoStates, Name::PhugoidResidualised, Name::PhugoidQuartic]
        }
        (ModeName::Phugoid, _) => &[Name::PhugoidTwoStates, Name::PhugoidQuartic],
        (ModeName::DutchRoll, _) => &[Name::DutchRollTwoStates],
        (ModeName::RollSubsidence, _) => &[Name::RollDamping],
        (ModeName::Spiral, _) => &[Name::SpiralWithGravity, Name::SpiralPolynomial],
        _ => &[],
    };
    let tried: Vec<Tried> =
        candidates.iter().filter_map(|&name| Tried::of(sides, name, measured, exact)).collect();
    // The ends of the quartic say nothing that one could picture, so they come after those that do.
    let is_plain = |tried: &&Tried| !matches!(tried.name, Name::PhugoidQuartic | Name::SpiralPolynomial);
    let within =
        |(error, missed): (f64, f64)| move |tried: &&Tried| tried.error() <= error && tried.missed <= missed;
    let plain = |limits| tried.iter().filter(is_plain).find(within(limits));
    let good = plain(GOOD).or_else(|| plain(FAIR));
    let best = || {
        let worst = |tried: &&Tried| tried.error().max(tried.missed);
        let best = tried.iter().min_by(|a, b| worst(a).total_cmp(&worst(b)));
        best.filter(|tried| worst(tried) <= BEYOND)
    };
    let Tried { name, errors, missed } = *good.or_else(best)?;
    let of = |side: Side<'_>, error: f64| {
        // Of ωₙ it is half of that of ωₙ².
        let error = if measured == Measured::Frequency { (1.0 + error).powi(2) - 1.0 } else { error };
        Some(Formula { name, measured, error, missed, terms: terms(side, name, measured)? })
    };
    Some([of(sides[0], errors[0])?, of(sides[1], errors[1])?])
}

/// A formula, and how far it is off.
#[derive(Clone, Copy, Debug)]
struct Tried {
    name: ApproximationName,
    errors: [f64; 2],
    /// Error of the change over the change.
    missed: f64,
}

impl Tried {
    fn of(
        sides: [Side<'_>; 2],
        name: ApproximationName,
        measured: Measured,
        exact: [f64; 2],
    ) -> Option<Self> {
        let [before, after] = sides.map(|side| value(side.plane, name, measured));
        let given = [before?, after?];
        for (side, given) in sides.into_iter().zip(given) {
            let given = if measured == Measured::Frequency { given * given } else { given };
            if (terms(side, name, measured)?.value() / given - 1.0).abs() > LEFT_OUT {
                return None;
            }
        }
        let missed = ((given[1] - given[0]) / (exact[1] - exact[0]) - 1.0).abs();
        let errors = [given[0] / exact[0] - 1.0, given[1] / exact[1] - 1.0];
        errors.iter().chain([&missed]).all(|x| x.is_finite()).then_some(Self { name, errors, missed })
    }

    fn error(&self) -> f64 {
        self.errors[0].abs().max(self.errors[1].abs())
    }
}

/// ωₙ, 2ζωₙ or λ as an approximation gives it.
fn value(plane: &PlaneAnalysis, name: ApproximationName, measured: Measured) -> Option<f64> {
    let approximation = plane.approximations.iter().find(|approximation| approximation.name == name)?;
    match (measured, approximation.value?) {
        (Measured::Frequency, ModeValue::SecondOrder { natural_frequency, .. }) => Some(natural_frequency),
        (Measured::Damping, ModeValue::SecondOrder { natural_frequency, damping_ratio }) => {
            Some(2.0 * damping_ratio? * natural_frequency)
        }
        (Measured::Root, ModeValue::Root(root)) => Some(root),
        _ => None,
    }
}

/// The terms of a formula, in stability axes as everywhere in the textbooks.
fn terms(side: Side<'_>, name: ApproximationName, measured: Measured) -> Option<Terms> {
    use ApproximationName as Name;
    let model = StabilityAxes::of(&side.plane.model);
    let model = model.model();
    let (a, v) = (&model.a, model.trim.speed);
    let [b3, c2, d1, e0] = polynomial(a);
    let longitudinal = || {
        let lag = DownwashLag::of(side.scenario.edited.derivatives().ok().flatten().as_ref());
        (lag.unfold(a), lag.m_wdot * lag.alpha0.cos())
    };
    let sum = |terms: &[f64]| Some(Terms::Sum(terms.to_vec()));
    match (name, measured) {
        // ωₙ² = Z_w M_q − V M_w
        (Name::ShortPeriodTwoStates, Measured::Frequency) => {
            let (plain, _) = longitudinal();
            sum(&[entry(&plain, W, W) * entry(&plain, Q, Q), -v * entry(&plain, Q, W)])
        }
        // 2ζωₙ = −(Z_w + M_q + V M_ẇ)
        (Name::ShortPeriodTwoStates, _) => {
            let (plain, m_wdot) = longitudinal();
            sum(&[-entry(&plain, W, W), -entry(&plain, Q, Q), -v * m_wdot])
        }
        // ωₙ² = −Z_u g/V
        (Name::PhugoidTwoStates, Measured::Frequency) => {
            let (plain, _) = longitudinal();
            let g = -entry(&plain, U, Theta) / model.trim.gamma0.cos();
            sum(&[-entry(&plain, W, U) * g / v])
        }
        // 2ζωₙ = −X_u
        (Name::PhugoidTwoStates, _) => sum(&[-entry(a, U, U)]),
        // ωₙ² = g (M_w Z_u − M_u Z_w)/(Z_w M_q − V M_w): det Aᵣ in level flight
        (Name::PhugoidResidualised, Measured::Frequency) => {
            let (plain, _) = longitudinal();
            let g = -entry(&plain, U, Theta) / model.trim.gamma0.cos();
            let [z_u, z_w] = [entry(&plain, W, U), entry(&plain, W, W)];
            let [m_u, m_w, m_q] = [U, W, Q].map(|state| entry(&plain, Q, state));
            Some(Terms::Quotient([g * m_w * z_u, -g * m_u * z_w], [z_w * m_q, -entry(&plain, W, Q) * m_w]))
        }
        // ωₙ² = E/C
        (Name::PhugoidQuartic, Measured::Frequency) => Some(Terms::Quotient([e0, 0.0], [c2, 0.0])),
        // 2ζωₙ = D/C − B E/C²
        (Name::PhugoidQuartic, _) => sum(&[d1 / c2, -b3 * e0 / (c2 * c2)]),
        // ωₙ² = V N′_v + Y_v N′_r
        (Name::DutchRollTwoStates, Measured::Frequency) => {
            sum(&[v * entry(a, R, V), entry(a, V, V) * entry(a, R, R)])
        }
        // 2ζωₙ = −(Y_v + N′_r)
        (Name::DutchRollTwoStates, _) => sum(&[-entry(a, V, V), -entry(a, R, R)]),
        // λ = L′_p
        (Name::RollDamping, _) => sum(&[entry(a, P, P)]),
        // λ = −(g/V)(L′_v N′_r − N′_v L′_r) / (L′_v (N′_p − g/V) − N′_v L′_p)
        (Name::SpiralWithGravity, _) => {
            let rate = entry(a, V, Phi) / model.trim.gamma0.cos() / v;
            let [l_v, n_v] = [entry(a, P, V), entry(a, R, V)];
            let over = [-rate * l_v * entry(a, R, R), rate * n_v * entry(a, P, R)];
            Some(Terms::Quotient(over, [l_v * (entry(a, R, P) - rate), -n_v * entry(a, P, P)]))
        }
        // λ = −E/D
        (Name::SpiralPolynomial, _) => Some(Terms::Quotient([-e0, 0.0], [d1, 0.0])),
        _ => None,
    }
}
