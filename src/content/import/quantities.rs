//! The numbers that an aircraft is made of, by their keys in an aircraft file: what they are, and between what they lie.

/// A quantity by its key.
#[derive(Clone, Copy, Debug)]
pub(super) struct Quantity {
    pub key: &'static str,
    pub meaning: &'static str,
    /// SI; degrees for angles of the trim.
    pub unit: &'static str,
    /// Least value that an aircraft, model aircraft included, has been seen with.
    pub low: f64,
    /// Greatest.
    pub high: f64,
}

const fn row(key: &'static str, meaning: &'static str, unit: &'static str, low: f64, high: f64) -> Quantity {
    Quantity { key, meaning, unit, low, high }
}

/// Every quantity, mass and flight first.
pub(super) const QUANTITIES: [Quantity; 77] = [
    row("mass", "mass", "kg", 0.005, 7e5),
    row("S", "wing area", "m²", 0.005, 1000.0),
    row("c", "mean chord", "m", 0.01, 25.0),
    row("b", "span", "m", 0.05, 130.0),
    row("Ix", "moment of inertia in roll", "kg m²", 1e-6, 1e9),
    row("Iy", "moment of inertia in pitch", "kg m²", 1e-6, 1e9),
    row("Iz", "moment of inertia in yaw", "kg m²", 1e-6, 1e9),
    row("Ixz", "product of inertia ∫ x z dm", "kg m²", -1e8, 1e8),
    row("speed", "true airspeed", "m/s", 1.0, 2500.0),
    row("altitude", "altitude", "m", 0.0, 20_000.0),
    row("density", "density of the air", "kg/m³", 0.05, 1.6),
    row("mach", "Mach number", "", 0.0, 7.0),
    row("alpha0_deg", "angle of attack of the x axis in the trim", "°", -20.0, 25.0),
    row("gamma0_deg", "flight-path angle", "°", -45.0, 45.0),
    row("gravity", "free fall", "m/s²", 9.7, 9.9),
    row("CL", "lift coefficient", "", 0.01, 2.5),
    row("CD", "drag coefficient", "", 0.003, 0.6),
    row("CL_alpha", "lift by angle of attack", "1/rad", 1.0, 12.0),
    row("CD_alpha", "drag by angle of attack", "1/rad", -0.3, 3.0),
    row("Cm_alpha", "pitching moment by angle of attack", "1/rad", -10.0, 3.0),
    row("CL_alphadot", "lift by rate of angle of attack, c̄/2V", "", -10.0, 20.0),
    row("Cm_alphadot", "pitching moment by rate of angle of attack, c̄/2V", "", -60.0, 5.0),
    row("CL_q", "lift by pitch rate, c̄/2V", "", -10.0, 60.0),
    row("Cm_q", "pitch damping, c̄/2V", "", -250.0, 0.0),
    row("CL_M", "lift by Mach number", "", -3.0, 6.0),
    row("CD_M", "drag by Mach number", "", -1.0, 2.0),
    row("Cm_M", "pitching moment by Mach number", "", -3.0, 3.0),
    row("CL_de", "lift by elevator", "1/rad", -4.0, 4.0),
    row("CD_de", "drag by elevator", "1/rad", -1.0, 1.0),
    row("Cm_de", "elevator power", "1/rad", -8.0, 8.0),
    row("CY_beta", "side force by sideslip", "1/rad", -4.0, 0.0),
    row("Cl_beta", "dihedral effect: roll by sideslip", "1/rad", -1.0, 0.4),
    row("Cn_beta", "weathercock stability: yaw by sideslip", "1/rad", -0.4, 1.0),
    row("CY_p", "side force by roll rate, b/2V", "", -3.0, 3.0),
    row("Cl_p", "roll damping, b/2V", "", -2.0, 0.0),
    row("Cn_p", "yaw by roll rate, b/2V", "", -1.0, 0.6),
    row("CY_r", "side force by yaw rate, b/2V", "", -1.0, 4.0),
    row("Cl_r", "roll by yaw rate, b/2V", "", -0.2, 1.5),
    row("Cn_r", "yaw damping, b/2V", "", -2.0, 0.0),
    row("CY_da", "side force by aileron", "1/rad", -1.0, 1.0),
    row("Cl_da", "aileron power", "1/rad", -1.5, 1.5),
    row("Cn_da", "yaw by aileron", "1/rad", -0.5, 0.5),
    row("CY_dr", "side force by rudder", "1/rad", -2.0, 2.0),
    row("Cl_dr", "roll by rudder", "1/rad", -0.5, 0.5),
    row("Cn_dr", "rudder power", "1/rad", -1.0, 1.0),
    row("Xu", "speed damping", "1/s", -10.0, 1.0),
    row("Xw", "forward force by w", "1/s", -20.0, 20.0),
    row("Xq", "forward force by pitch rate", "m/s", -50.0, 50.0),
    row("Xde", "forward force by elevator", "m/s²", -100.0, 100.0),
    row("Xdt", "forward force by throttle", "m/s²", -100.0, 100.0),
    row("Zu", "lift by speed", "1/s", -30.0, 2.0),
    row("Zw", "heave damping", "1/s", -200.0, 0.0),
    row("Zwdot", "lift by rate of w", "", -1.0, 0.5),
    row("Zq", "lift by pitch rate", "m/s", -100.0, 20.0),
    row("Zde", "lift by elevator", "m/s²", -500.0, 500.0),
    row("Zdt", "lift by throttle", "m/s²", -50.0, 50.0),
    row("Mu", "speed stability", "1/(m s)", -50.0, 50.0),
    row("Mw", "pitch stiffness", "1/(m s)", -500.0, 100.0),
    row("Mwdot", "pitch by rate of w", "1/m", -50.0, 5.0),
    row("Mq", "pitch damping", "1/s", -500.0, 0.0),
    row("Mde", "elevator power", "1/s²", -5000.0, 5000.0),
    row("Mdt", "pitch by throttle", "1/s²", -100.0, 100.0),
    row("Yv", "side force by v", "1/s", -50.0, 0.0),
    row("Yp", "side force by roll rate", "m/s", -20.0, 20.0),
    row("Yr", "side force by yaw rate", "m/s", -20.0, 50.0),
    row("Yda", "side force by aileron", "m/s²", -100.0, 100.0),
    row("Ydr", "side force by rudder", "m/s²", -100.0, 200.0),
    row("Lv", "dihedral effect", "1/(m s)", -500.0, 200.0),
    row("Lp", "roll damping", "1/s", -500.0, 0.0),
    row("Lr", "roll by yaw rate", "1/s", -50.0, 200.0),
    row("Lda", "aileron power", "1/s²", -3000.0, 3000.0),
    row("Ldr", "roll by rudder", "1/s²", -1000.0, 1000.0),
    row("Nv", "weathercock stability", "1/(m s)", -200.0, 500.0),
    row("Np", "yaw by roll rate", "1/s", -100.0, 50.0),
    row("Nr", "yaw damping", "1/s", -300.0, 0.0),
    row("Nda", "yaw by aileron", "1/s²", -500.0, 500.0),
    row("Ndr", "rudder power", "1/s²", -2000.0, 500.0),
];

/// The quantity of a key.
pub(super) fn quantity(key: &str) -> Option<&'static Quantity> {
    QUANTITIES.iter().find(|quantity| quantity.key == key)
}
