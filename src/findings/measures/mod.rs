//! The one table of what can be read of a scenario, twin of [`parameters`]: goals of lessons, columns of sweeps, numbers in text,
//! the command line and JavaScript name what they read by these keys.
//!
//! A key is a subject and a quantity, joined by a point: `short_period.damping_ratio`, `peak.alpha`, `parameter.cm_alpha`; what is
//! of the whole aircraft has no subject: `static_margin`. Keys never change once published.

mod keys;
mod reading;

use crate::flight::aircraft::plane::Plane;
use crate::flight::modes::mode_name::ModeName;
use crate::flight::motion::outputs::Output;
use crate::key::keys;
use crate::scenario::{Dimension, Parameter, Quantity, parameters};

pub use reading::{Absence, Reading};

/// Something that can be read of a scenario.
#[derive(Clone, Copy, Debug)]
pub enum Measure {
    /// A quantity of the mode by a name.
    OfMode(ModeName, ModeQuantity),
    /// A quantity of a plane of motion.
    OfPlane(Plane, PlaneQuantity),
    /// A quantity of the loop of a control, of a law of feedback.
    OfLoop(LoopOf, LoopQuantity),
    /// A quantity of the aircraft as a whole.
    OfAircraft(AircraftQuantity),
    /// A metric of an output of the motion on screen.
    OfOutput(Output, Metric),
    /// The value of a parameter.
    OfParameter(&'static Parameter),
}

/// A quantity of a mode.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ModeQuantity {
    /// Real part σ of its eigenvalue \[1/s\], growth positive.
    RealPart,
    /// Imaginary part ω of its eigenvalue \[rad/s\], never negative.
    ImaginaryPart,
    /// Undamped natural frequency ωₙ \[rad/s\]; of an oscillation.
    NaturalFrequency,
    /// Damping ratio ζ, negative when it grows; of an oscillation.
    DampingRatio,
    /// Period T \[s\]; of an oscillation.
    Period,
    /// Time in which the amplitude halves \[s\]; of what dies away.
    TimeToHalf,
    /// Time in which the amplitude doubles \[s\]; of what grows.
    TimeToDouble,
    /// Periods until the amplitude has halved, or doubled where it grows; of an oscillation.
    Cycles,
    /// Time constant −1/λ \[s\]; of a real root that dies away.
    TimeConstant,
    /// Whether it dies away, stays or grows.
    Stability,
    /// Worst level of MIL-F-8785C.
    Level,
}

keys! {
    ModeQuantity {
        RealPart => "real_part",
        ImaginaryPart => "imaginary_part",
        NaturalFrequency => "natural_frequency",
        DampingRatio => "damping_ratio",
        Period => "period",
        TimeToHalf => "time_to_half",
        TimeToDouble => "time_to_double",
        Cycles => "cycles",
        TimeConstant => "time_constant",
        Stability => "stability",
        Level => "level",
    }
}

/// A quantity of a plane of motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PlaneQuantity {
    /// Dynamic stability: that of the worst mode.
    Stability,
    /// Static stability: of the stiffnesses.
    StaticStability,
    /// det A \[1/s⁴\].
    Determinant,
    /// How many modes oscillate.
    Oscillations,
}

keys! {
    PlaneQuantity {
        Stability => "stability",
        StaticStability => "static_stability",
        Determinant => "determinant",
        Oscillations => "oscillations",
    }
}

/// The loop of a control, cut before its actuator, the other of its plane closed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LoopOf {
    /// Of the elevator.
    Elevator,
    /// Of the throttle.
    Throttle,
    /// Of the aileron.
    Aileron,
    /// Of the rudder.
    Rudder,
}

keys! {
    LoopOf {
        Elevator => "elevator_loop",
        Throttle => "throttle_loop",
        Aileron => "aileron_loop",
        Rudder => "rudder_loop",
    }
}

impl LoopOf {
    /// The plane of its control, and the place of the control among the inputs there.
    pub const fn input(self) -> (Plane, usize) {
        match self {
            Self::Elevator => (Plane::Longitudinal, 0),
            Self::Throttle => (Plane::Longitudinal, 1),
            Self::Aileron => (Plane::Lateral, 0),
            Self::Rudder => (Plane::Lateral, 1),
        }
    }
}

/// A quantity of a loop.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LoopQuantity {
    /// The least factor above 1 on all gains to the control at which the loop is neutral.
    GainMargin,
    /// The greatest factor below 1 that makes it neutral: gains may be lowered so far.
    GainReduction,
    /// The lag \[rad\] at which it is neutral, negative of a lead: the smallest of all crossovers.
    PhaseMargin,
    /// The frequency of that crossover \[rad/s\].
    Crossover,
    /// Greatest of |1/(1 + L)| over frequency.
    SensitivityPeak,
}

keys! {
    LoopQuantity {
        GainMargin => "gain_margin",
        GainReduction => "gain_reduction",
        PhaseMargin => "phase_margin",
        Crossover => "crossover",
        SensitivityPeak => "sensitivity_peak",
    }
}

/// A quantity of the aircraft as a whole.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AircraftQuantity {
    /// Dynamic stability: that of its worst mode in any plane.
    Stability,
    /// Static stability: the worse of its planes.
    StaticStability,
    /// Static margin \[mean chords\], positive where the neutral point is behind the centre of gravity.
    StaticMargin,
    /// Manoeuvre margin \[mean chords\].
    ManoeuvreMargin,
    /// Worst level of MIL-F-8785C.
    Level,
    /// Gravity of the model over speed as a multiple of Earth's: 1 where its units belong together.
    GravityRatio,
}

keys! {
    AircraftQuantity {
        Stability => "stability",
        StaticStability => "static_stability",
        StaticMargin => "static_margin",
        ManoeuvreMargin => "manoeuvre_margin",
        Level => "level",
        GravityRatio => "gravity_ratio",
    }
}

/// A metric of an output of the motion on screen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Metric {
    /// The value farthest from zero, with its sign.
    Peak,
    /// When that is \[s\] from the beginning of the plot.
    PeakTime,
    /// The value that it goes to after a step.
    Steady,
    /// Time from 10 % to 90 % of the steady value \[s\].
    RiseTime,
    /// Time after which it stays near the steady value for ever \[s\].
    SettlingTime,
    /// How far it goes beyond the steady value, as a fraction of it.
    Overshoot,
}

keys! {
    Metric {
        Peak => "peak",
        PeakTime => "peak_time",
        Steady => "steady",
        RiseTime => "rise_time",
        SettlingTime => "settling_time",
        Overshoot => "overshoot",
    }
}

impl Measure {
    /// Every measure there is, in the order of the documentation.
    pub fn all() -> impl Iterator<Item = Self> {
        use crate::key::Keyed;
        let of_aircraft = AircraftQuantity::VALUES.iter().map(|&quantity| Self::OfAircraft(quantity));
        let of_planes = Plane::ALL.into_iter().flat_map(|plane| {
            PlaneQuantity::VALUES.iter().map(move |&quantity| Self::OfPlane(plane, quantity))
        });
        let of_loops = LoopOf::VALUES
            .iter()
            .flat_map(|&of| LoopQuantity::VALUES.iter().map(move |&quantity| Self::OfLoop(of, quantity)));
        let of_modes = ModeName::VALUES
            .iter()
            .flat_map(|&name| ModeQuantity::VALUES.iter().map(move |&quantity| Self::OfMode(name, quantity)));
        let of_outputs = Output::VALUES
            .iter()
            .flat_map(|&output| Metric::VALUES.iter().map(move |&metric| Self::OfOutput(output, metric)));
        of_aircraft
            .chain(of_planes)
            .chain(of_loops)
            .chain(of_modes)
            .chain(of_outputs)
            .chain(parameters().map(Self::OfParameter))
    }

    /// The dimension of its number, for the unit; a verdict has none.
    pub fn dimension(self) -> Dimension {
        match self {
            Self::OfMode(_, quantity) => match quantity {
                ModeQuantity::RealPart => Dimension::PerSecond,
                ModeQuantity::ImaginaryPart | ModeQuantity::NaturalFrequency => Dimension::Frequency,
                ModeQuantity::Period
                | ModeQuantity::TimeToHalf
                | ModeQuantity::TimeToDouble
                | ModeQuantity::TimeConstant => Dimension::Time,
                ModeQuantity::DampingRatio
                | ModeQuantity::Cycles
                | ModeQuantity::Stability
                | ModeQuantity::Level => Dimension::Number,
            },
            Self::OfPlane(_, quantity) => match quantity {
                PlaneQuantity::Oscillations => Dimension::Count,
                PlaneQuantity::Determinant => Dimension::PerSecondFourth,
                PlaneQuantity::Stability | PlaneQuantity::StaticStability => Dimension::Number,
            },
            Self::OfLoop(_, quantity) => match quantity {
                LoopQuantity::PhaseMargin => Dimension::Angle,
                LoopQuantity::Crossover => Dimension::Frequency,
                LoopQuantity::GainMargin | LoopQuantity::GainReduction | LoopQuantity::SensitivityPeak => {
                    Dimension::Number
                }
            },
            Self::OfAircraft(quantity) => match quantity {
                AircraftQuantity::StaticMargin | AircraftQuantity::ManoeuvreMargin => Dimension::Percent,
                AircraftQuantity::Stability
                | AircraftQuantity::StaticStability
                | AircraftQuantity::Level
                | AircraftQuantity::GravityRatio => Dimension::Number,
            },
            Self::OfOutput(output, metric) => match metric {
                Metric::Peak | Metric::Steady => Quantity::of(output).dimension,
                Metric::PeakTime | Metric::RiseTime | Metric::SettlingTime => Dimension::Time,
                Metric::Overshoot => Dimension::Percent,
            },
            Self::OfParameter(parameter) => parameter.dimension,
        }
    }
}

impl PartialEq for Measure {
    fn eq(&self, other: &Self) -> bool {
        self.key() == other.key()
    }
}
