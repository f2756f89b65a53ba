//! Where a control leads that stays deflected: another steady flight, and what is in balance there.

use crate::findings::Findings;
use crate::flight::Channel;
use crate::flight::aircraft::axes::StabilityAxes;
use crate::flight::aircraft::plane::Plane;
use crate::flight::aircraft::states::Longitudinal::{self, Q, Theta, U, W};
use crate::flight::aircraft::states::{ELEVATOR, THROTTLE, entry};
use crate::flight::analysis::PlaneAnalysis;
use crate::flight::modes::approximations::DownwashLag;
use crate::flight::motion::inputs::Input;
use crate::flight::motion::response::steady_state;
use crate::scenario::Source;

/// The steady flight after a step of the elevator or the throttle, as changes from the one before: x = −A⁻¹ B δ.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NewTrim {
    /// What has been moved.
    pub source: Source,
    /// Speed \[m/s\].
    pub speed: f64,
    /// Angle of attack \[rad\].
    pub alpha: f64,
    /// Flight-path angle \[rad\].
    pub gamma: f64,
    /// Pitching moments over Iy \[1/s²\].
    pub moment: Balance,
    /// Forces across the flight path over m \[m/s²\], downward positive.
    pub lift: Balance,
    /// Forces along the flight path over m \[m/s²\], forward positive.
    pub thrust: Balance,
}

/// Terms that add up to nothing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Balance {
    /// By speed u.
    pub speed: f64,
    /// By angle of attack, w.
    pub attack: f64,
    /// By attitude θ: the weight.
    pub attitude: f64,
    /// By the control.
    pub control: f64,
}

impl NewTrim {
    /// Of the motion on screen; `None` where it is another, has no end, or is no small disturbance all the way. Nor under a law, where a
    /// control that is held is not the only one that moves.
    pub fn of(findings: &Findings) -> Option<Self> {
        if findings.flies_otherwise() {
            return None;
        }
        let scenario = findings.scenario();
        let source = scenario.disturbance.choices[scenario.plane].source;
        let (channel, input) = scenario.disturbance.input(scenario.plane)?;
        let column = match (source, channel, scenario.plane) {
            (Source::Elevator, Channel::First, Plane::Longitudinal) => ELEVATOR,
            (Source::Throttle, Channel::Second, Plane::Longitudinal) => THROTTLE,
            _ => return None,
        };
        let Input::Step { amplitude, .. } = input else { return None };
        if findings.growing_mode().is_some() || findings.metrics()?.steady_is_beyond {
            return None;
        }
        let PlaneAnalysis { model, .. } = findings.plane()?;
        let model = StabilityAxes::of(model);
        let model = model.model();
        let column = model.b.column(column) * amplitude;
        let x = steady_state(&model.a, &column)?;
        // Without the ẇ terms, of which a steady flight has none.
        let plain = DownwashLag::of(scenario.edited.derivatives().ok().flatten().as_ref()).unfold(&model.a);
        let balance = |row: Longitudinal| {
            let by = |state: Longitudinal| entry(&plain, row, state) * x[state.index()];
            let (speed, attack, attitude) = (by(U), by(W), by(Theta));
            Balance { speed, attack, attitude, control: -(speed + attack + attitude) }
        };
        let alpha = x[W.index()] / model.trim.speed;
        let trim = Self {
            source,
            speed: x[U.index()],
            alpha,
            gamma: x[Theta.index()] - alpha,
            moment: balance(Q),
            lift: balance(W),
            thrust: balance(U),
        };
        x.iter().all(|x| x.is_finite()).then_some(trim)
    }
}
