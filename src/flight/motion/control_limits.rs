//! How far and how fast controls can be moved, in nonlinear flight under a law of feedback.

use super::six_dof::SixDof;

/// The four controls of an aircraft, in the order in which they are listed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Control {
    /// Elevator.
    Elevator,
    /// Throttle.
    Throttle,
    /// Aileron.
    Aileron,
    /// Rudder.
    Rudder,
}

impl Control {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Elevator, Self::Throttle, Self::Aileron, Self::Rudder];
}

/// The limits of one control, away from the trim.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ControlLimit {
    /// Lowest and highest \[rad, or the unit of the throttle\].
    pub range: [f64; 2],
    /// Fastest that an actuator moves it either way \[per s\]; infinite where it has no limit.
    pub rate: f64,
}

/// The limits that an aircraft's file names, in the order of [`Control::ALL`].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct NamedLimits {
    /// Lowest and highest \[rad, or the unit of the throttle\].
    pub ranges: [Option<[f64; 2]>; 4],
    /// Fastest either way \[per s\].
    pub rates: [Option<f64>; 4],
}

/// The usual reach of elevator, aileron and rudder either way \[°\]. Ours, of the size of a fighter's: the F-16 of Stevens, Lewis &
/// Johnson, *Aircraft Control and Simulation*, has 25°, 21.5° and 30°.
const USUAL_REACH: [f64; 3] = [25.0, 25.0, 30.0];

/// Their usual rate \[°/s\]: that of the same aircraft's elevator.
const USUAL_RATE: f64 = 60.0;

/// Thrust over weight of a steady level flight where no source gives the drag: that of an aircraft that glides ten to one.
const USUAL_THRUST: f64 = 0.1;

impl NamedLimits {
    /// The limits of all controls: those of the file, and the usual ones where it names none. The thrust goes from none to twice that
    /// of the steady flight, at any rate.
    pub fn or_usual(&self, aircraft: &SixDof) -> [ControlLimit; 4] {
        let usual = |control: Control| {
            let surface = |k: usize| {
                let reach = USUAL_REACH[k].to_radians();
                ControlLimit { range: [-reach, reach], rate: USUAL_RATE.to_radians() }
            };
            match control {
                Control::Elevator => surface(0),
                Control::Aileron => surface(1),
                Control::Rudder => surface(2),
                Control::Throttle => {
                    let steady = aircraft.steady_throttle().unwrap_or(USUAL_THRUST);
                    ControlLimit { range: [-steady, steady], rate: f64::INFINITY }
                }
            }
        };
        Control::ALL.map(|control| {
            let k = control as usize;
            let ControlLimit { range, rate } = usual(control);
            ControlLimit { range: self.ranges[k].unwrap_or(range), rate: self.rates[k].unwrap_or(rate) }
        })
    }
}
