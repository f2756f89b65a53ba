//! What a book prints of an aircraft: its mass and geometry, and its aerodynamic coefficients without dimension.
//!
//! Stability axes. Rates are made dimensionless with c̄/2V (pitch) and b/2V (roll and yaw), angles are radians:
//! Cm_q = ∂Cm/∂(q c̄/2V), Cl_p = ∂Cl/∂(p b/2V). A source that uses c̄/V prints half of these.

use thiserror::Error;

use super::real::{Dual64, Real, record};

/// Axes in which an airframe's moments of inertia are given.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum InertiaAxes {
    /// Body axes: the reference angle of attack turns them into stability axes.
    Body,
    /// Stability axes of the reference condition.
    Stability,
}

/// Horizontal tail: area for drawing, arm for the tail-size knob.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HorizontalTail {
    /// Area S_t \[m²\], positive.
    pub area: f64,
    /// Distance l_t from the reference centre of gravity aft to the tail's aerodynamic centre \[m\], positive.
    pub arm: f64,
}

/// Fin: area for drawing, arm and height for the fin-size knob.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fin {
    /// Area S_v \[m²\], positive.
    pub area: f64,
    /// Distance l_v from the reference centre of gravity aft to the fin's aerodynamic centre \[m\], positive.
    pub arm: f64,
    /// Height z_v of the fin's aerodynamic centre above the x axis \[m\], upward positive.
    pub height: f64,
}

/// Mass and geometry; what a knob moves is of type `T`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Airframe<T = f64> {
    /// Mass m \[kg\], positive.
    pub mass: T,
    /// Wing area S \[m²\], positive.
    pub s: f64,
    /// Mean aerodynamic chord c̄ \[m\], positive.
    pub c: f64,
    /// Wing span b \[m\], positive.
    pub b: f64,
    /// Moment of inertia in roll Ix \[kg m²\], positive.
    pub ix: T,
    /// Moment of inertia in pitch Iy \[kg m²\], positive.
    pub iy: T,
    /// Moment of inertia in yaw Iz \[kg m²\], positive.
    pub iz: T,
    /// Product of inertia Ixz = ∫ x z dm \[kg m²\]; positive when the nose carries its mass low and the tail high.
    pub ixz: f64,
    /// Axes of the four above.
    pub inertia_axes: InertiaAxes,
    /// Thrust by which throttle δt = 1 adds to the trim thrust \[N\]. Where a source says nothing of its engine, the
    /// reference weight, so that δt is the change of T/W.
    pub thrust_per_throttle: f64,
    /// n in thrust ∝ Vⁿ at a fixed throttle: 0 constant thrust (jet), −1 constant power (propeller).
    pub thrust_exponent: f64,
    /// Distance of the thrust line below the centre of gravity \[m\], below positive: thrust then lifts the nose.
    pub thrust_offset: f64,
    /// Taper ratio λ of the wing, tip chord over root chord; for the dihedral knob.
    pub taper: Option<f64>,
    /// Horizontal tail, where known.
    pub tail: Option<HorizontalTail>,
    /// Fin, where known.
    pub fin: Option<Fin>,
}

/// Moments of inertia in the x–z plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlanarInertia<T = f64> {
    /// Ix \[kg m²\].
    pub ix: T,
    /// Iz \[kg m²\].
    pub iz: T,
    /// Ixz \[kg m²\].
    pub ixz: T,
}

impl<T: Real> PlanarInertia<T> {
    /// In axes turned nose-down by α \[rad\] about y: from body to stability axes for the trim angle of attack α
    /// (the tensor turned about y; Etkin & Reid, *Dynamics of Flight*, 3rd ed., ch. 4).
    pub fn in_axes_at(&self, alpha: T) -> Self {
        let Self { ix, iz, ixz } = *self;
        let (sin2, cos2) = (alpha.sin().powi(2), alpha.cos().powi(2));
        let (sin_2a, cos_2a) = (alpha * 2.0).sin_cos();
        Self {
            // Ixˢ = Ix cos²α + Iz sin²α − Ixz sin 2α
            ix: ix * cos2 + iz * sin2 - ixz * sin_2a,
            // Izˢ = Ix sin²α + Iz cos²α + Ixz sin 2α
            iz: ix * sin2 + iz * cos2 + ixz * sin_2a,
            // Ixzˢ = ½ (Ix − Iz) sin 2α + Ixz cos 2α
            ixz: (ix - iz) * 0.5 * sin_2a + ixz * cos_2a,
        }
    }
}

impl<T: Real> Airframe<T> {
    /// Inertia in stability axes where the body x axis stands at `alpha0` in the reference condition and at
    /// `alpha0 + alpha_change` now \[rad\].
    pub fn stability_inertia(&self, alpha0: f64, alpha_change: T) -> PlanarInertia<T> {
        let given = PlanarInertia { ix: self.ix, iz: self.iz, ixz: T::from(self.ixz) };
        given.in_axes_at(match self.inertia_axes {
            InertiaAxes::Body => alpha_change + alpha0,
            InertiaAxes::Stability => alpha_change,
        })
    }
}

impl Airframe {
    /// The same with numbers that are constant.
    pub fn constant(&self) -> Airframe<Dual64> {
        let [mass, ix, iy, iz] = [self.mass, self.ix, self.iy, self.iz].map(Dual64::from);
        let Self { s, c, b, ixz, inertia_axes, taper, tail, fin, .. } = *self;
        let Self { thrust_per_throttle, thrust_exponent, thrust_offset, .. } = *self;
        Airframe {
            mass,
            s,
            c,
            b,
            ix,
            iy,
            iz,
            ixz,
            inertia_axes,
            thrust_per_throttle,
            thrust_exponent,
            thrust_offset,
            taper,
            tail,
            fin,
        }
    }

    /// The first thing that no airframe can have.
    pub fn problem(&self) -> Option<AirframeError> {
        let positive = [
            ("mass", self.mass),
            ("S", self.s),
            ("c", self.c),
            ("b", self.b),
            ("Ix", self.ix),
            ("Iy", self.iy),
            ("Iz", self.iz),
        ];
        if let Some((key, value)) = positive.into_iter().find(|(_, x)| !(x.is_finite() && *x > 0.0)) {
            return Some(AirframeError::NotPositive { key, value });
        }
        let limit = (self.ix * self.iz).sqrt();
        let fits = self.ixz.is_finite() && self.ixz * self.ixz < self.ix * self.iz;
        (!fits).then_some(AirframeError::ProductOfInertia { ixz: self.ixz, limit })
    }
}

/// Something that no airframe can have.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum AirframeError {
    /// A mass, a length, an area or a moment of inertia that is not positive.
    NotPositive {
        /// Key of it in an aircraft file.
        key: &'static str,
        /// The value that is given, SI.
        value: f64,
    },
    /// Ixz as large as √(Ix Iz), or larger.
    ProductOfInertia {
        /// Ixz \[kg m²\].
        ixz: f64,
        /// √(Ix Iz) \[kg m²\].
        limit: f64,
    },
}

impl AirframeError {
    /// Key of what can't be, in an aircraft file.
    pub const fn key(&self) -> &'static str {
        match self {
            Self::NotPositive { key, .. } => key,
            Self::ProductOfInertia { .. } => "Ixz",
        }
    }
}

/// Longitudinal coefficients in one trim, stability axes, all per radian.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LongitudinalCoefficients<T = f64> {
    /// Trim lift coefficient C_L.
    pub cl: T,
    /// Trim drag coefficient C_D.
    pub cd: T,
    /// Lift-curve slope ∂C_L/∂α, positive.
    pub cl_alpha: T,
    /// ∂C_D/∂α, positive: lift costs drag.
    pub cd_alpha: T,
    /// ∂Cm/∂α, negative when a nose-up departure is met by a nose-down moment.
    pub cm_alpha: T,
    /// ∂C_L/∂(α̇ c̄/2V); from the downwash that reaches the tail late, positive by that source.
    pub cl_alphadot: T,
    /// ∂Cm/∂(α̇ c̄/2V), negative with a tail aft.
    pub cm_alphadot: T,
    /// ∂C_L/∂(q c̄/2V), positive with a tail aft.
    pub cl_q: T,
    /// ∂Cm/∂(q c̄/2V), pitch damping, negative.
    pub cm_q: T,
    /// ∂C_L/∂M at constant α.
    pub cl_m: T,
    /// ∂C_D/∂M at constant α.
    pub cd_m: T,
    /// ∂Cm/∂M at constant α; negative is tuck: faster pitches the nose down.
    pub cm_m: T,
    /// ∂C_L/∂δe, trailing edge down positive, so positive.
    pub cl_de: T,
    /// ∂C_D/∂δe.
    pub cd_de: T,
    /// ∂Cm/∂δe, elevator power, negative: trailing edge down pitches the nose down.
    pub cm_de: T,
}
record!(LongitudinalCoefficients:
    cl cd cl_alpha cd_alpha cm_alpha cl_alphadot cm_alphadot cl_q cm_q cl_m cd_m cm_m cl_de cd_de
    cm_de
);

/// Lateral–directional coefficients in one trim, stability axes, all per radian.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LateralCoefficients<T = f64> {
    /// Side force by sideslip ∂CY/∂β, negative.
    pub cy_beta: T,
    /// Dihedral effect ∂Cl/∂β, negative when sideslip to the right rolls to the left.
    pub cl_beta: T,
    /// Weathercock stability ∂Cn/∂β, positive when the nose turns into the wind.
    pub cn_beta: T,
    /// ∂CY/∂(p b/2V).
    pub cy_p: T,
    /// Roll damping ∂Cl/∂(p b/2V), negative.
    pub cl_p: T,
    /// Yaw by roll rate ∂Cn/∂(p b/2V), usually negative (adverse).
    pub cn_p: T,
    /// ∂CY/∂(r b/2V), positive with a fin aft.
    pub cy_r: T,
    /// Roll by yaw rate ∂Cl/∂(r b/2V), positive: the outer wing lifts more.
    pub cl_r: T,
    /// Yaw damping ∂Cn/∂(r b/2V), negative.
    pub cn_r: T,
    /// ∂CY/∂δa.
    pub cy_da: T,
    /// Aileron power ∂Cl/∂δa, positive: the right aileron up rolls right wing down.
    pub cl_da: T,
    /// Adverse (or proverse) yaw ∂Cn/∂δa.
    pub cn_da: T,
    /// ∂CY/∂δr, positive: rudder trailing edge left pushes the tail right.
    pub cy_dr: T,
    /// ∂Cl/∂δr.
    pub cl_dr: T,
    /// Rudder power ∂Cn/∂δr, negative.
    pub cn_dr: T,
}
record!(LateralCoefficients:
    cy_beta cl_beta cn_beta cy_p cl_p cn_p cy_r cl_r cn_r cy_da cl_da cn_da cy_dr cl_dr cn_dr
);

/// Both planes; a source may have only the longitudinal one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coefficients<T = f64> {
    /// Longitudinal.
    pub longitudinal: LongitudinalCoefficients<T>,
    /// Lateral–directional, where the source has it.
    pub lateral: Option<LateralCoefficients<T>>,
}

/// One coefficient by its key: a row of the tables below.
#[derive(Clone, Copy, Debug)]
pub struct Field<T> {
    /// Key in files, the book's symbol in plain letters.
    pub key: &'static str,
    /// Whether a source without it is of no use; others are zero where a source leaves them out.
    pub required: bool,
    /// The number in the structure.
    pub of: fn(&mut T) -> &mut f64,
}

impl<T: Copy> Field<T> {
    /// Its value.
    pub fn get(&self, from: &T) -> f64 {
        let mut copy = *from;
        *(self.of)(&mut copy)
    }
}

const fn field<T>(key: &'static str, required: bool, of: fn(&mut T) -> &mut f64) -> Field<T> {
    Field { key, required, of }
}

/// Every longitudinal coefficient by its key.
pub const LONGITUDINAL_COEFFICIENTS: [Field<LongitudinalCoefficients>; 15] = [
    field("CL", true, |c| &mut c.cl),
    field("CD", true, |c| &mut c.cd),
    field("CL_alpha", true, |c| &mut c.cl_alpha),
    field("CD_alpha", true, |c| &mut c.cd_alpha),
    field("Cm_alpha", true, |c| &mut c.cm_alpha),
    field("CL_alphadot", false, |c| &mut c.cl_alphadot),
    field("Cm_alphadot", false, |c| &mut c.cm_alphadot),
    field("CL_q", false, |c| &mut c.cl_q),
    field("Cm_q", true, |c| &mut c.cm_q),
    field("CL_M", false, |c| &mut c.cl_m),
    field("CD_M", false, |c| &mut c.cd_m),
    field("Cm_M", false, |c| &mut c.cm_m),
    field("CL_de", false, |c| &mut c.cl_de),
    field("CD_de", false, |c| &mut c.cd_de),
    field("Cm_de", true, |c| &mut c.cm_de),
];

/// Every lateral coefficient by its key.
pub const LATERAL_COEFFICIENTS: [Field<LateralCoefficients>; 15] = [
    field("CY_beta", true, |c| &mut c.cy_beta),
    field("Cl_beta", true, |c| &mut c.cl_beta),
    field("Cn_beta", true, |c| &mut c.cn_beta),
    field("CY_p", false, |c| &mut c.cy_p),
    field("Cl_p", true, |c| &mut c.cl_p),
    field("Cn_p", true, |c| &mut c.cn_p),
    field("CY_r", false, |c| &mut c.cy_r),
    field("Cl_r", true, |c| &mut c.cl_r),
    field("Cn_r", true, |c| &mut c.cn_r),
    field("CY_da", false, |c| &mut c.cy_da),
    field("Cl_da", false, |c| &mut c.cl_da),
    field("Cn_da", false, |c| &mut c.cn_da),
    field("CY_dr", false, |c| &mut c.cy_dr),
    field("Cl_dr", false, |c| &mut c.cl_dr),
    field("Cn_dr", false, |c| &mut c.cn_dr),
];
