//! Static stability: which way the first moment points, a statement apart from what happens afterwards.
//!
//! In pitch it is the stiffness, M_w < 0: a nose that is lifted must come down again. Sideways there are two, on the moments
//! that a sideslip calls up: the nose must turn into the wind, N_v > 0, and the wings away from it, L_v < 0 (Etkin & Reid,
//! *Dynamics of Flight*, §§3.9, 3.11).
//!
//! det A is a second statement, which has the terms of speed in it: where it is negative, a real root grows. Its being positive
//! proves nothing, as two real roots may grow. A slow spiral that grows is no matter of stiffness: the spiral condition stands apart.

use nalgebra::Matrix4;

use crate::flight::aircraft::aircraft_model::DerivativeModel;
use crate::flight::aircraft::axes::StabilityAxes;
use crate::flight::aircraft::plane::{Plane, PlaneModel};
use crate::flight::aircraft::states::{Lateral, Longitudinal, entry};
use crate::flight::modes::stability::Stability;

/// det A and its sign, neutral where rounding decides it: det A > 0 ⇔ an even number of real roots grow, so that none grows alone.
fn determinant_and_sign(a: &Matrix4<f64>) -> (f64, Stability) {
    let determinant = a.determinant();
    // Rounding of a 4×4 determinant: a few ulps of the product of the row lengths (Hadamard's bound).
    let rounding = 1e-13 * a.row_iter().map(|row| row.norm()).product::<f64>();
    let sign = if determinant.abs() <= rounding {
        Stability::Neutral
    } else if determinant > 0.0 {
        Stability::Stable
    } else {
        Stability::Unstable
    };
    (determinant, sign)
}

/// One stiffness: the moment that a displacement calls up, and whether it points back.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stiffness {
    /// The derivative \[1/(m·s)\].
    pub value: f64,
    /// Stable where the moment points back, neutral where it is zero.
    pub verdict: Stability,
}

impl Stiffness {
    fn new(value: f64, restoring: f64) -> Self {
        let verdict = match value * restoring {
            x if x > 0.0 => Stability::Stable,
            x if x < 0.0 => Stability::Unstable,
            _ => Stability::Neutral,
        };
        Self { value, verdict }
    }

    /// Pitch stiffness M_w of a bare matrix in stability axes. Its rows of q have M_u + M_ẇ Z_u and M_w + M_ẇ Z_w in one; a lag
    /// of the downwash (M_ẇ < 0) is taken out as if M_u were zero, and where that is none, nothing is.
    fn of_matrix(a: &Matrix4<f64>) -> Self {
        let of_row =
            |row| [Longitudinal::U, Longitudinal::W].map(|column: Longitudinal| entry(a, row, column));
        let ([z_u, z_w], [m_u, m_w]) = (of_row(Longitudinal::W), of_row(Longitudinal::Q));
        // M_ẇ = A_qu/Z_u,  M_w = A_qw − M_ẇ Z_w
        let folded = Some(m_u / z_u).filter(|lag| lag.is_finite() && *lag < 0.0).map_or(0.0, |lag| lag * z_w);
        let value = (m_w - folded).clamp(-f64::MAX, f64::MAX);
        // Rounding of the difference
        if value.abs() <= 1e-12 * (m_w.abs() + folded.abs()) {
            Self::new(0.0, -1.0)
        } else {
            Self::new(value, -1.0)
        }
    }
}

/// Static stability in one plane. It says nothing about oscillations.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlaneStaticStability {
    /// The verdict on the whole plane: of the pitch stiffness, or the worse of those in yaw and roll.
    pub verdict: Stability,
    /// det A = λ₁λ₂λ₃λ₄ = E \[1/s⁴\], the constant term of the characteristic polynomial.
    pub determinant: f64,
    /// What the sign of det A says: unstable where it is negative, so that a real root grows. Stable is necessary, not enough.
    pub of_determinant: Stability,
    /// The stiffnesses.
    pub stiffness: PlaneStiffness,
    /// Whether they are derivatives as such, in the axes of the source; or else found from A in stability axes: M_w as if M_u
    /// were zero, N_v and L_v with the product of inertia folded in.
    pub is_plain: bool,
}

/// The stiffnesses of one plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PlaneStiffness {
    /// Pitch.
    Longitudinal {
        /// Pitch stiffness M_w (the sign of Cm_α): negative is restoring.
        m_w: Stiffness,
        /// By how much M_w would have to grow to come to the manoeuvre point \[1/(m·s)\]: positive in front of it.
        ///
        /// There the stick force for each g is zero: Zw Mq − V Mw = 0. `None` without a speed.
        to_manoeuvre_point: Option<f64>,
    },
    /// Yaw and roll.
    Lateral {
        /// Weathercock stability N_v (the sign of Cn_β): positive is restoring.
        n_v: Stiffness,
        /// Dihedral effect L_v (the sign of Cl_β): negative is restoring.
        l_v: Stiffness,
        /// Spiral condition L'v N'r − N'v L'r \[1/(m·s²)\]: positive is a stable spiral, in level flight.
        spiral: Stiffness,
    },
}

/// Static stability of a model of either plane, with the `derivatives` that it follows from, where there are any.
///
/// det A = g (Zu Mw − Mu Zw) longitudinally and g (L'v N'r − N'v L'r) laterally, in level flight (Etkin & Reid, *Dynamics of
/// Flight*, §§6.5, 6.8: criterion E > 0).
pub fn plane_static_stability(
    model: &StabilityAxes,
    derivatives: Option<&DerivativeModel>,
) -> PlaneStaticStability {
    let PlaneModel { plane, a, .. } = model.model();
    let (determinant, of_determinant) = determinant_and_sign(a);
    let is_plain;
    let stiffness = match plane {
        Plane::Longitudinal => {
            let [w, q] = [Longitudinal::W, Longitudinal::Q].map(Longitudinal::index);
            let [z_w, v, m_w, m_q] = [a[(w, w)], a[(w, q)], a[(q, w)], a[(q, q)]];
            // Zw Mq − V (Mw + ΔMw) = 0, the same with ẇ terms folded in
            let to_manoeuvre_point = z_w * m_q / v - m_w;
            let plain = derivatives.and_then(|d| d.longitudinal).map(|d| d.m_w);
            is_plain = plain.is_some();
            PlaneStiffness::Longitudinal {
                m_w: plain.map_or_else(|| Stiffness::of_matrix(a), |plain| Stiffness::new(plain, -1.0)),
                to_manoeuvre_point: to_manoeuvre_point.is_finite().then_some(to_manoeuvre_point),
            }
        }
        Plane::Lateral => {
            let [v, p, r] = [Lateral::V, Lateral::P, Lateral::R].map(Lateral::index);
            let [l_v, l_r, n_v, n_r] = [a[(p, v)], a[(p, r)], a[(r, v)], a[(r, r)]];
            let condition = (l_v * n_r - n_v * l_r).clamp(-f64::MAX, f64::MAX);
            let plain = derivatives.and_then(|d| d.lateral).map(|d| (d.n_v, d.l_v));
            is_plain = plain.is_some();
            let (n_v, l_v) = plain.unwrap_or((n_v, l_v));
            PlaneStiffness::Lateral {
                n_v: Stiffness::new(n_v, 1.0),
                l_v: Stiffness::new(l_v, -1.0),
                spiral: Stiffness::new(condition, 1.0),
            }
        }
    };
    let verdict = match stiffness {
        PlaneStiffness::Longitudinal { m_w, .. } => m_w.verdict,
        PlaneStiffness::Lateral { n_v, l_v, .. } => n_v.verdict.max(l_v.verdict),
    };
    PlaneStaticStability { verdict, determinant, of_determinant, stiffness, is_plain }
}

/// Static margin H_n = −Cm_α/CL_α, in chords the neutral point is behind the centre of gravity; `None` if CL_α is zero.
pub fn static_margin(cm_alpha: f64, cl_alpha: f64) -> Option<f64> {
    let margin = -cm_alpha / cl_alpha;
    margin.is_finite().then_some(margin)
}

/// Manoeuvre margin H_m = H_n − ρSc Cm_q/(4m), in chords the manoeuvre point is behind the centre of gravity.
///
/// `cm_q` is ∂Cm/∂(qc/2V), negative when it damps; ρ \[kg/m³\], S \[m²\], c \[m\], m \[kg\] (Etkin & Reid, §3.1, without CD beside CL_α).
/// `None` without a mass.
pub fn manoeuvre_margin(
    static_margin: f64,
    cm_q: f64,
    density: f64,
    area: f64,
    chord: f64,
    mass: f64,
) -> Option<f64> {
    let margin = static_margin - density * area * chord * cm_q / (4.0 * mass);
    margin.is_finite().then_some(margin)
}
