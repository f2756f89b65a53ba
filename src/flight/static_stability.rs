//! Static stability: which way the first moment points, a statement apart from what happens afterwards.

use super::linear::{Longitudinal, LongitudinalModel};

/// Whether a small departure meets a restoring tendency.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StaticVerdict {
    /// det A > 0: no real root can sit to the right of the origin alone.
    Stable,
    /// det A = 0 within rounding: a displaced aircraft has nowhere it prefers.
    Neutral,
    /// det A < 0: a real root grows.
    Unstable,
}

/// Static longitudinal stability and the numbers behind it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StaticStability {
    /// The verdict, from the sign of det A.
    pub verdict: StaticVerdict,
    /// det A = λ₁λ₂λ₃λ₄ \[1/s⁴\], the constant term of the characteristic polynomial.
    pub determinant: f64,
    /// Pitch stiffness M_w \[1/(m·s)\]: negative when a gust that raises α pitches the nose down.
    pub m_w: f64,
}

/// Static longitudinal stability of a model.
///
/// With the states of this model det A = g cos θ₀ (Zu Mw − Mu Zw) (Etkin & Reid, *Dynamics of Flight*, §6.5,
/// criterion E > 0). The verdict says nothing about oscillations: those are dynamic stability.
pub fn static_stability(model: &LongitudinalModel) -> StaticStability {
    let determinant = model.a.determinant();
    // Rounding of a 4×4 determinant: a few ulps of the product of the row lengths (Hadamard's bound).
    let rounding = 1e-13 * model.a.row_iter().map(|row| row.norm()).product::<f64>();
    let verdict = if determinant.abs() <= rounding {
        StaticVerdict::Neutral
    } else if determinant > 0.0 {
        StaticVerdict::Stable
    } else {
        StaticVerdict::Unstable
    };
    let (q, w) = (Longitudinal::Q.index(), Longitudinal::W.index());
    StaticStability { verdict, determinant, m_w: model.a[(q, w)] }
}
