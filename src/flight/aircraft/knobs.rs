//! The knobs that people turn — mass, inertia, centre of gravity, tail, fin, dihedral — and what each moves.
//!
//! Each is a pure function of airframe and coefficients, the identity to the bit at its reference value. Stability
//! axes; `Nelson` is Nelson, *Flight Stability and Automatic Control*, 2nd ed. 1998; `Etkin & Reid` is *Dynamics of
//! Flight*, 3rd ed. 1996.

use thiserror::Error;

use super::coefficients::{Airframe, Coefficients};
use super::real::{Real, record};

/// Where every knob stands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Knobs<T = f64> {
    /// Mass over the reference mass, positive.
    pub mass_ratio: T,
    /// Ix over its reference, positive.
    pub ix_ratio: T,
    /// Iy over its reference, positive.
    pub iy_ratio: T,
    /// Iz over its reference, positive.
    pub iz_ratio: T,
    /// Centre of gravity aft of the reference, in mean chords Δx/c̄, aft positive.
    pub cg_shift: T,
    /// Horizontal-tail area over the reference area; the arm stays.
    pub tail_ratio: T,
    /// Fin and rudder area over the reference area; arm and height stay.
    pub fin_ratio: T,
    /// Dihedral angle more than the reference \[rad\], wing tips up positive.
    pub dihedral_change: T,
}
record!(Knobs: mass_ratio ix_ratio iy_ratio iz_ratio cg_shift tail_ratio fin_ratio dihedral_change);

impl Default for Knobs {
    fn default() -> Self {
        Self {
            mass_ratio: 1.0,
            ix_ratio: 1.0,
            iy_ratio: 1.0,
            iz_ratio: 1.0,
            cg_shift: 0.0,
            tail_ratio: 1.0,
            fin_ratio: 1.0,
            dihedral_change: 0.0,
        }
    }
}

/// One knob, to name what it moves. Speed, altitude and flight path are in [`super::condition`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Knob {
    /// [`Knobs::mass_ratio`].
    Mass,
    /// [`Knobs::ix_ratio`], [`Knobs::iy_ratio`] and [`Knobs::iz_ratio`].
    Inertia,
    /// [`Knobs::cg_shift`].
    CentreOfGravity,
    /// [`Knobs::tail_ratio`].
    Tail,
    /// [`Knobs::fin_ratio`].
    Fin,
    /// [`Knobs::dihedral_change`].
    Dihedral,
}

/// A knob that cannot be turned so.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum KnobError {
    /// The geometry that the knob needs is not in the aircraft's data.
    NoGeometry(Knob),
    /// A number outside what the knob can be.
    Range {
        /// The knob.
        knob: Knob,
        /// The value that was asked for.
        value: f64,
    },
}

impl Knob {
    /// All, in the order in which they are applied.
    pub const ALL: [Self; 6] =
        [Self::Mass, Self::Inertia, Self::Dihedral, Self::Tail, Self::Fin, Self::CentreOfGravity];
}

impl<T: Real> Knobs<T> {
    /// Airframe and coefficients with every knob applied, in the order of [`Knob::ALL`].
    pub fn apply(
        &self,
        airframe: &Airframe<T>,
        coefficients: &Coefficients<T>,
    ) -> Result<(Airframe<T>, Coefficients<T>), KnobError> {
        let mut now = (*airframe, *coefficients);
        for knob in Knob::ALL {
            now = self.apply_one(knob, &now.0, &now.1)?;
        }
        Ok(now)
    }

    /// Airframe and coefficients with one knob applied.
    pub fn apply_one(
        &self,
        knob: Knob,
        airframe: &Airframe<T>,
        coefficients: &Coefficients<T>,
    ) -> Result<(Airframe<T>, Coefficients<T>), KnobError> {
        let (mut a, mut c) = (*airframe, *coefficients);
        match knob {
            Knob::Mass => a.mass *= positive(knob, self.mass_ratio)?,
            Knob::Inertia => {
                a.ix *= positive(knob, self.ix_ratio)?;
                a.iy *= positive(knob, self.iy_ratio)?;
                a.iz *= positive(knob, self.iz_ratio)?;
            }
            Knob::CentreOfGravity => c = with_cg_at(&a, &c, within(knob, self.cg_shift, FARTHEST_SHIFT)?),
            Knob::Tail if self.tail_ratio.is_constantly(1.0) => {}
            Knob::Tail => {
                let arm = a.tail.map(|tail| tail.arm / a.c).ok_or(KnobError::NoGeometry(knob))?;
                c = with_tail(&c, arm, not_negative(knob, self.tail_ratio)?);
            }
            Knob::Fin if self.fin_ratio.is_constantly(1.0) => {}
            Knob::Fin => {
                let fin = a.fin.map(|fin| (fin.arm / a.b, fin.height / a.b));
                let fin = fin.ok_or(KnobError::NoGeometry(knob))?;
                c = with_fin(&c, fin, not_negative(knob, self.fin_ratio)?);
            }
            Knob::Dihedral if self.dihedral_change.is_constantly(0.0) => {}
            Knob::Dihedral => {
                let taper = a.taper.ok_or(KnobError::NoGeometry(knob))?;
                c = with_dihedral(&c, taper, within(knob, self.dihedral_change, MOST_DIHEDRAL)?);
            }
        }
        Ok((a, c))
    }
}

/// Farthest that the centre of gravity is shifted, in mean chords.
pub const FARTHEST_SHIFT: f64 = 1.0;

/// Largest change of the dihedral \[rad\].
pub const MOST_DIHEDRAL: f64 = 0.6;

fn positive<T: Real>(knob: Knob, value: T) -> Result<T, KnobError> {
    let good = value.re().is_finite() && value > 0.0;
    if good { Ok(value) } else { Err(KnobError::Range { knob, value: value.re() }) }
}

fn not_negative<T: Real>(knob: Knob, value: T) -> Result<T, KnobError> {
    let good = value.re().is_finite() && value >= 0.0;
    if good { Ok(value) } else { Err(KnobError::Range { knob, value: value.re() }) }
}

fn within<T: Real>(knob: Knob, value: T, limit: f64) -> Result<T, KnobError> {
    if value.abs() <= limit { Ok(value) } else { Err(KnobError::Range { knob, value: value.re() }) }
}

/// Everything about a centre of gravity `shift` mean chords further aft.
///
/// A force at the old centre acts Δx ahead of the new one: Cm′ = Cm + C_L Δx/c̄ and Cn′ = Cn + CY Δx/b. Turning about the new
/// centre moves the old one: α = α′ − q Δx/V and β = β′ + r Δx/V (Etkin & Reid §2.3). The force along x, the height and the
/// inertias are left alone.
fn with_cg_at<T: Real>(airframe: &Airframe<T>, coefficients: &Coefficients<T>, shift: T) -> Coefficients<T> {
    let mut moved = *coefficients;
    let (l, h) = (&mut moved.longitudinal, shift);
    // in q c̄/2V: C_Lq′ = C_Lq − 2h C_Lα,  Cm_q′ = Cm_q − 2h Cm_α + h C_Lq′
    l.cl_q -= h * 2.0 * l.cl_alpha;
    l.cm_q += h * l.cl_q - h * 2.0 * l.cm_alpha;
    // Cm_α′ = Cm_α + h C_Lα, and so for α̇, M and δe
    l.cm_alpha += h * l.cl_alpha;
    l.cm_alphadot += h * l.cl_alphadot;
    l.cm_m += h * l.cl_m;
    l.cm_de += h * l.cl_de;
    if let Some(c) = &mut moved.lateral {
        let d = h * airframe.c / airframe.b;
        // in r b/2V: CY_r′ = CY_r + 2d CY_β,  Cl_r′ = Cl_r + 2d Cl_β,  Cn_r′ = Cn_r + 2d Cn_β + d CY_r′
        c.cy_r += d * 2.0 * c.cy_beta;
        c.cl_r += d * 2.0 * c.cl_beta;
        c.cn_r += d * 2.0 * c.cn_beta + d * c.cy_r;
        // Cn_β′ = Cn_β + d CY_β, and so for p, δa and δr
        c.cn_beta += d * c.cy_beta;
        c.cn_p += d * c.cy_p;
        c.cn_da += d * c.cy_da;
        c.cn_dr += d * c.cy_dr;
    }
    moved
}

/// A tail `ratio` times as large on the same arm l_t/c̄: tail parts of the derivatives (Nelson, ch. 3), with η a_t and dε/dα
/// from the aircraft's own Cm_q and Cm_α̇. The tail's own mass and drag are left out.
fn with_tail<T: Real>(coefficients: &Coefficients<T>, arm: f64, ratio: T) -> Coefficients<T> {
    let mut moved = *coefficients;
    let (c, l) = (&coefficients.longitudinal, &mut moved.longitudinal);
    let (one, more) = (T::from(1.0), ratio - 1.0);
    // Cm_q = 1.1 Cm_qt, and Cm_qt = −2 η a_t (S_t/S)(l_t/c̄)²
    let cm_q_tail = c.cm_q.at_most(0.0) / 1.1;
    let lift_slope = -cm_q_tail / (2.0 * arm * arm);
    // dε/dα = Cm_α̇/Cm_qt
    let downwash =
        if cm_q_tail < 0.0 { (c.cm_alphadot / cm_q_tail).at_least(0.0).at_most(1.0) } else { T::from(0.0) };
    // C_Lαt = η a_t (S_t/S)(1 − dε/dα),  Cm_αt = −(l_t/c̄) C_Lαt
    l.cl_alpha += more * lift_slope * (one - downwash);
    l.cm_alpha -= more * arm * lift_slope * (one - downwash);
    // C_Lqt = 2 η a_t (S_t/S)(l_t/c̄),  C_Lα̇t = C_Lqt dε/dα
    l.cl_q += more * 2.0 * arm * lift_slope;
    l.cm_q += more * cm_q_tail;
    l.cl_alphadot += more * 2.0 * arm * lift_slope * downwash;
    l.cm_alphadot += more * cm_q_tail * downwash;
    // the elevator grows with the tail
    l.cl_de *= ratio;
    l.cd_de *= ratio;
    l.cm_de *= ratio;
    moved
}

/// A fin and rudder `ratio` times as large, with arm l_v/b and height z_v/b the same: fin parts of the derivatives (Nelson,
/// Table 3.4). The fin's own mass and drag are left out.
fn with_fin<T: Real>(coefficients: &Coefficients<T>, (arm, height): (f64, f64), ratio: T) -> Coefficients<T> {
    let mut moved = *coefficients;
    if let Some(c) = &mut moved.lateral {
        // Cn_r = 2 (l_v/b)² CY_βv
        let cy_beta_fin = c.cn_r.at_most(0.0) / (2.0 * arm * arm);
        let more = (ratio - 1.0) * cy_beta_fin;
        // at the fin β′ = β + 2 (z_v/b) p̂ − 2 (l_v/b) r̂;  Cl = (z_v/b) CY,  Cn = −(l_v/b) CY
        c.cy_beta += more;
        c.cl_beta += more * height;
        c.cn_beta -= more * arm;
        c.cy_p += more * 2.0 * height;
        c.cl_p += more * 2.0 * height * height;
        c.cn_p -= more * 2.0 * height * arm;
        c.cy_r -= more * 2.0 * arm;
        c.cl_r -= more * 2.0 * arm * height;
        c.cn_r += more * 2.0 * arm * arm;
        c.cy_dr *= ratio;
        c.cl_dr *= ratio;
        c.cn_dr *= ratio;
    }
    moved
}

/// Wing tips up by `change` \[rad\] more, on a wing of taper ratio λ: strip theory of a tapered wing (as in Perkins & Hage 1949).
fn with_dihedral<T: Real>(coefficients: &Coefficients<T>, taper: f64, change: T) -> Coefficients<T> {
    let mut moved = *coefficients;
    if let Some(c) = &mut moved.lateral {
        // ΔCl_β = −(C_Lα/6) (1 + 2λ)/(1 + λ) ΔΓ
        let slope = coefficients.longitudinal.cl_alpha / 6.0 * (1.0 + 2.0 * taper) / (1.0 + taper);
        c.cl_beta -= slope * change;
    }
    moved
}
