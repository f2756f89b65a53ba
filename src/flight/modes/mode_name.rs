//! The names that modes can have, and what naming needs of a mode without one.

use nalgebra::{Complex, Vector4};

use super::reason::{Fact, Reason, StateSet};
use super::stability::Stability;
use crate::flight::aircraft::plane::Trim;
use crate::flight::aircraft::states::Longitudinal;
use crate::key::keys;

/// The name of a mode.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum ModeName {
    /// Fast oscillation of angle of attack and pitch rate at nearly constant speed.
    ShortPeriod,
    /// The faster of two real roots that an overdamped short period has become.
    ShortPeriodFastRoot,
    /// The slower of two real roots that an overdamped short period has become.
    ShortPeriodSlowRoot,
    /// A real root of angle of attack and pitch rate that dies away, and is none of the short period's.
    PitchSubsidence,
    /// A real root of angle of attack and pitch rate that grows.
    PitchDivergence,
    /// Oscillation in which a root of the short period has met one of the phugoid, mixing all four states.
    ThirdOscillatory,
    /// Slow exchange of speed and height at nearly constant angle of attack.
    Phugoid,
    /// The faster of two real roots that the phugoid has become.
    PhugoidFastRoot,
    /// The slower of two real roots that the phugoid has become.
    PhugoidSlowRoot,
    /// A real root of speed and pitch angle that dies away, and is none of the phugoid's.
    SpeedSubsidence,
    /// A real root of speed and pitch angle that grows.
    SpeedDivergence,
    /// Oscillation in yaw and sideslip, with the wings rocking.
    DutchRoll,
    /// The further left of two real roots that the Dutch roll has become, both decaying or both growing.
    DutchRollMoreStableRoot,
    /// The further right of the same two.
    DutchRollLessStableRoot,
    /// A single real root of sideslip and yaw rate that dies away.
    SideslipSubsidence,
    /// A single real root of sideslip and yaw rate that grows: the nose turns out of the wind.
    DirectionalDivergence,
    /// Oscillation that roll subsidence and spiral have become together: the lateral phugoid.
    CoupledRollSpiral,
    /// Oscillation in which a root of the Dutch roll has met the roll or the spiral, mixing all four states.
    LateralOscillation,
    /// Fast dying away of a roll rate.
    RollSubsidence,
    /// Growth of a roll rate, driven by the wing.
    RollDivergence,
    /// Slow turning in or out of a banked turn.
    Spiral,
    /// A real root that dies away, of several lateral states and none of the above.
    LateralSubsidence,
    /// A real root that grows, of several lateral states and none of the above.
    LateralDivergence,
    /// A real root of height: what a height that was left does.
    Height,
    /// A real root of heading: what a heading that was left does.
    Heading,
    /// A real root of a position along or across the ground.
    Position,
    /// A real root of the washout, whose slow part forgets.
    Washout,
    /// A real root of the elevator's actuator.
    ElevatorActuator,
    /// A real root of the engine's lag.
    Engine,
    /// A real root of the aileron's actuator.
    AileronActuator,
    /// A real root of the rudder's actuator.
    RudderActuator,
    /// Oscillation of states of the feedback, with or without a root of the aircraft.
    FeedbackOscillation,
    /// A real root of another state that the source has beside the four.
    FurtherState,
    /// Oscillation of states that the source has beside the four, with or without a root of the four.
    FurtherOscillation,
}

keys! {
    ModeName {
        ShortPeriod => "short-period",
        ShortPeriodFastRoot => "short-period-fast-root",
        ShortPeriodSlowRoot => "short-period-slow-root",
        PitchSubsidence => "pitch-subsidence",
        PitchDivergence => "pitch-divergence",
        ThirdOscillatory => "third-oscillatory" | "third-oscillatory-mode",
        Phugoid => "phugoid",
        PhugoidFastRoot => "phugoid-fast-root",
        PhugoidSlowRoot => "phugoid-slow-root",
        SpeedSubsidence => "speed-subsidence",
        SpeedDivergence => "speed-divergence",
        DutchRoll => "dutch-roll",
        DutchRollMoreStableRoot => "dutch-roll-more-stable-root",
        DutchRollLessStableRoot => "dutch-roll-less-stable-root",
        SideslipSubsidence => "sideslip-subsidence",
        DirectionalDivergence => "directional-divergence",
        CoupledRollSpiral => "coupled-roll-spiral",
        LateralOscillation => "lateral-oscillation",
        RollSubsidence => "roll-subsidence",
        RollDivergence => "roll-divergence",
        Spiral => "spiral",
        LateralSubsidence => "lateral-subsidence",
        LateralDivergence => "lateral-divergence",
        Height => "height",
        Heading => "heading",
        Position => "position",
        Washout => "washout",
        ElevatorActuator => "elevator-actuator",
        Engine => "engine",
        AileronActuator => "aileron-actuator",
        RudderActuator => "rudder-actuator",
        FeedbackOscillation => "feedback-oscillation",
        FurtherState => "further-state",
        FurtherOscillation => "further-oscillation",
    }
}

/// A name, and why.
#[derive(Clone, Debug, PartialEq)]
pub struct Naming {
    /// The name of the mode.
    pub name: ModeName,
    /// Share of the mode in the states that gave it its name, 0 to 1. Near ½ the name is a matter of degree.
    pub confidence: f64,
    /// Why.
    pub reason: Reason,
}

/// A mode without a name, as far as naming needs it.
#[derive(Clone, Copy, Debug)]
pub(in crate::flight) struct UnnamedMode {
    pub lambda: Complex<f64>,
    pub participation: [f64; 4],
    pub stability: Stability,
    /// Amplitudes of longitudinal motion, where the flight is known.
    pub amplitudes: Option<Amplitudes>,
}

impl UnnamedMode {
    pub fn oscillates(&self) -> bool {
        self.lambda.im > 0.0
    }

    pub fn grows(&self) -> bool {
        self.stability == Stability::Unstable
    }
}

/// Amplitudes of a longitudinal mode that a person can compare: angles and a ratio of speeds, in stability axes.
#[derive(Clone, Copy, Debug)]
pub(in crate::flight) struct Amplitudes {
    /// |u/V|.
    pub speed: f64,
    /// |α| \[rad\].
    pub alpha: f64,
    /// |θ| \[rad\].
    pub theta: f64,
}

impl Amplitudes {
    /// Amplitudes of the right eigenvector `shape` over \[u, w, q, θ\] in the axes of `trim`.
    pub fn of(trim: &Trim, shape: &Vector4<Complex<f64>>) -> Self {
        let (sin, cos) = trim.alpha0.sin_cos();
        let [u, w] = [Longitudinal::U, Longitudinal::W].map(|state| shape[state.index()]);
        // x along the steady velocity: u_s = u cos α₀ + w sin α₀,  w_s = w cos α₀ − u sin α₀
        Self {
            speed: (u * cos + w * sin).norm() / trim.speed,
            alpha: (w * cos - u * sin).norm() / trim.speed,
            theta: shape[Longitudinal::Theta.index()].norm(),
        }
    }

    /// |u/V| over |α|; infinite where α stays.
    pub fn speed_to_alpha(&self) -> f64 {
        self.speed / self.alpha
    }

    /// |α| over |θ|; infinite where θ stays.
    pub fn alpha_to_theta(&self) -> f64 {
        self.alpha / self.theta
    }
}

/// Below this confidence the shape is mixed.
pub(in crate::flight) const MIXED: f64 = 0.65;

/// The name of `mode`, for the participation of `states` and the facts beside it.
pub(super) fn naming(name: ModeName, mode: &UnnamedMode, states: StateSet, mut facts: Vec<Fact>) -> Naming {
    // Shares that add up to one do so but for rounding.
    let confidence = states.share(&mode.participation).clamp(0.0, 1.0);
    if confidence < MIXED {
        facts.push(Fact::MixedShape);
    }
    Naming { name, confidence, reason: Reason { states, facts } }
}
