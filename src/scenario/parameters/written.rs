//! How a slider's number is written: symbol and unit, in velocities or in angles of the flow.

use super::Parameter;
use crate::scenario::Dimension;
use crate::scenario::notation::{Convention, Notation};

/// A slider's number as it is written.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Written {
    /// The symbol.
    pub symbol: &'static str,
    /// The unit's symbol.
    pub unit: &'static str,
    /// One of the unit in the slider's own SI unit.
    pub in_si: f64,
    /// What the slider's own number \[SI\] is taken times to get that of the notation \[SI\]: V, 1/V or 1.
    pub factor: f64,
}

impl Parameter {
    /// How its number is written.
    pub fn written(&self, convention: Convention) -> Written {
        let Convention { length, notation, speed } = convention;
        let in_angles = (notation == Notation::Angles).then(|| in_angles(self.key)).flatten();
        let (symbol, dimension, power) = in_angles.unwrap_or((self.symbol, self.dimension, 0));
        let factor = self.plane.map_or(1.0, |plane| speed[plane].powi(power));
        Written { symbol, unit: dimension.symbol(length), in_si: dimension.in_si(length) / factor, factor }
    }
}

/// Symbol and dimension in angles, and the power of V that the number is taken times: M_α = V M_w, (Z_q + U₀)/V. `None` where they are
/// those of velocities.
fn in_angles(key: &str) -> Option<(&'static str, Dimension, i32)> {
    use Dimension::{Acceleration, Number, PerLength, PerSecond, PerSecondSquared, Speed};
    Some(match key {
        "x_w" => ("X_α", Acceleration, 1),
        "z_w" => ("Z_α", Acceleration, 1),
        "m_w" => ("M_α", PerSecondSquared, 1),
        "z_wdot" => ("Z_α\u{307}", Speed, 1),
        "m_wdot" => ("M_α\u{307}", PerSecond, 1),
        "y_v" => ("Y_β", Acceleration, 1),
        "l_v" => ("L_β", PerSecondSquared, 1),
        "n_v" => ("N_β", PerSecondSquared, 1),
        "a_wu" => ("Z′_u/V", PerLength, -1),
        "a_uw" => ("X_α", Acceleration, 1),
        "a_ww" => ("Z′_α/V", PerSecond, 0),
        "a_qw" => ("M′_α", PerSecondSquared, 1),
        "a_wq" => ("(Z_q + U_0)/V", Number, -1),
        "a_wtheta" => ("−g sin θ_0/V", PerSecond, -1),
        "b_w_de" => ("Z′_δe/V", PerSecond, -1),
        "b_w_dt" => ("Z′_δt/V", PerSecond, -1),
        "a_vv" => ("Y_β/V", PerSecond, 0),
        "a_pv" => ("L′_β", PerSecondSquared, 1),
        "a_rv" => ("N′_β", PerSecondSquared, 1),
        "a_vp" => ("(Y_p + W_0)/V", Number, -1),
        "a_vr" => ("(Y_r − U_0)/V", Number, -1),
        "a_vphi" => ("g cos θ_0/V", PerSecond, -1),
        "b_v_da" => ("Y_δa/V", PerSecond, -1),
        "b_v_dr" => ("Y_δr/V", PerSecond, -1),
        _ => return None,
    })
}
