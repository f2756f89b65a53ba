//! The disturbances a person can choose: what moves, in which shape, and how strongly, each remembered.

use crate::flight::aircraft::plane::{ByPlane, Plane};
use crate::flight::motion::command::Command;
use crate::flight::motion::inputs::Input;
use crate::flight::{Channel, Start};
use crate::key::keys;

/// Every disturbance begins here, so that the undisturbed flight before it can be seen \[s\].
pub const START: f64 = 1.0;

/// The source of a disturbance.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Source {
    /// The elevator.
    Elevator,
    /// More thrust.
    Throttle,
    /// Rising air.
    VerticalGust,
    /// Air that comes from ahead.
    HeadGust,
    /// The aileron.
    Aileron,
    /// The rudder.
    Rudder,
    /// Air that moves to the right.
    SideGust,
    /// Irregular air, of Dryden's form.
    Turbulence,
    /// Let go away from steady flight, controls fixed.
    Release,
    /// One mode alone, from its own shape.
    OneMode,
    /// The law of feedback is told another pitch angle.
    PitchCommand,
    /// Likewise, another speed.
    SpeedCommand,
    /// Likewise, another height.
    HeightCommand,
    /// Likewise, a bank angle.
    BankCommand,
    /// Likewise, a yaw rate.
    YawRateCommand,
    /// Likewise, another heading.
    HeadingCommand,
}

keys! {
    Source {
        Elevator => "elevator",
        Throttle => "throttle",
        VerticalGust => "vertical-gust" | "gust",
        HeadGust => "head-gust" | "head_gust",
        Rudder => "rudder",
        Aileron => "aileron",
        SideGust => "side-gust" | "side_gust",
        Turbulence => "turbulence",
        Release => "release",
        OneMode => "mode",
        PitchCommand => "pitch-command",
        SpeedCommand => "speed-command",
        HeightCommand => "height-command",
        BankCommand => "bank-command",
        YawRateCommand => "yaw-rate-command",
        HeadingCommand => "heading-command",
    }
}

/// The shape in time of a control or gust.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// At once, and stays.
    Step,
    /// At once, and soon back.
    Pulse,
    /// There, and as long to the other side.
    Doublet,
    /// Three, two, one and one units of time, to alternate sides.
    ThreeTwoOneOne,
    /// To and fro at one frequency.
    Sine,
    /// To and fro, faster and faster.
    Sweep,
    /// Swelling and dying away like a bell, ½(1 − cos).
    OneMinusCosine,
}

keys! {
    Shape {
        Step => "step",
        Pulse => "pulse",
        Doublet => "doublet",
        ThreeTwoOneOne => "3-2-1-1" | "3211",
        Sine => "sine",
        Sweep => "sweep",
        OneMinusCosine => "1-cosine" | "1-cos",
    }
}

/// The numbers that size disturbances, SI.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sizes {
    /// Elevator \[rad\], trailing edge down positive; of every shape but the pulse.
    pub elevator: f64,
    /// Elevator of the pulse \[rad\], trailing edge down positive.
    pub elevator_pulse: f64,
    /// Throttle, the change of thrust as a fraction of the weight.
    pub throttle: f64,
    /// Aileron \[rad\], in the source's sense.
    pub aileron: f64,
    /// Rudder \[rad\], trailing edge left positive.
    pub rudder: f64,
    /// Length of a pulse, of half a doublet, of a unit of the 3-2-1-1 \[s\].
    pub part: f64,
    /// Angular frequency of a sine, and of a sweep at its start \[rad/s\].
    pub frequency: f64,
    /// Angular frequency of a sweep at its end \[rad/s\].
    pub sweep_to: f64,
    /// How long a sine or a sweep lasts \[s\].
    pub lasting: f64,
    /// Speed of the rising air \[m/s\], upward positive.
    pub vertical_gust: f64,
    /// Speed of the air from ahead \[m/s\], against the flight positive.
    pub head_gust: f64,
    /// Speed of the air from the left \[m/s\], to the right positive.
    pub side_gust: f64,
    /// Length of a 1 − cosine gust \[s\].
    pub gust_length: f64,
    /// Root mean square of the vertical turbulence σ_w \[m/s\].
    pub turbulence: f64,
    /// Which sample of turbulence: a whole number.
    pub seed: f64,
    /// Released so far from steady flight: u, α, q, θ \[m/s, rad, rad/s, rad\] and β, p, r, φ \[rad, rad/s, rad/s, rad\].
    pub released: ByPlane<[f64; 4]>,
    /// Pitch angle that is commanded beyond the steady one \[rad\], nose-up positive.
    pub pitch_command: f64,
    /// Speed likewise \[m/s\], faster positive.
    pub speed_command: f64,
    /// Height likewise \[m\], upward positive.
    pub height_command: f64,
    /// Bank angle that is commanded \[rad\], right wing down positive.
    pub bank_command: f64,
    /// Yaw rate likewise \[rad/s\], nose right positive.
    pub yaw_rate_command: f64,
    /// Heading likewise \[rad\], nose right positive.
    pub heading_command: f64,
    /// Size of one mode alone: its flow angle or attitude, whichever is larger \[rad\].
    pub mode: f64,
    /// All of the above times this, to leave the small disturbances of the linear model.
    pub times: f64,
    /// Time shown \[s\]: where it follows, as it is at present.
    pub time: f64,
}

/// The disturbance of one plane.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Choice {
    /// The control or the air that moves.
    pub source: Source,
    /// The shape, if a control moves.
    pub control_shape: Shape,
    /// The shape, if the air moves.
    pub gust_shape: Shape,
    /// Place of the mode flown alone in the order of the modes.
    pub mode: usize,
}

/// A disturbance of each plane and its size.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Disturbance {
    /// The disturbance of each plane.
    pub choices: ByPlane<Choice>,
    /// How strongly, and for how long.
    pub sizes: Sizes,
    /// Whether the time shown follows the slowest mode that is seen, or stays as a person has set it.
    pub follows: bool,
}

impl Source {
    /// The sources of a plane, in the order of the chooser.
    pub const fn of(plane: Plane) -> &'static [Self] {
        match plane {
            Plane::Longitudinal => &[
                Self::Elevator,
                Self::Throttle,
                Self::VerticalGust,
                Self::HeadGust,
                Self::Turbulence,
                Self::Release,
                Self::OneMode,
                Self::PitchCommand,
                Self::SpeedCommand,
                Self::HeightCommand,
            ],
            Plane::Lateral => &[
                Self::Rudder,
                Self::Aileron,
                Self::SideGust,
                Self::Turbulence,
                Self::Release,
                Self::OneMode,
                Self::BankCommand,
                Self::YawRateCommand,
                Self::HeadingCommand,
            ],
        }
    }

    /// What it tells a law of feedback; `None` of what disturbs the aircraft itself.
    pub const fn command(self) -> Option<Command> {
        match self {
            Self::PitchCommand => Some(Command::PitchAngle),
            Self::SpeedCommand => Some(Command::Speed),
            Self::HeightCommand => Some(Command::Height),
            Self::BankCommand => Some(Command::BankAngle),
            Self::YawRateCommand => Some(Command::YawRate),
            Self::HeadingCommand => Some(Command::Heading),
            Self::Elevator
            | Self::Throttle
            | Self::VerticalGust
            | Self::HeadGust
            | Self::Aileron
            | Self::Rudder
            | Self::SideGust
            | Self::Turbulence
            | Self::Release
            | Self::OneMode => None,
        }
    }

    /// The shapes that it can have; none where it has a shape of its own.
    pub const fn shapes(self) -> &'static [Shape] {
        match self {
            Self::Elevator | Self::Throttle | Self::Aileron | Self::Rudder => {
                &[Shape::Step, Shape::Pulse, Shape::Doublet, Shape::ThreeTwoOneOne, Shape::Sine, Shape::Sweep]
            }
            Self::VerticalGust | Self::HeadGust | Self::SideGust => {
                &[Shape::OneMinusCosine, Shape::Step, Shape::Sine]
            }
            Self::PitchCommand
            | Self::SpeedCommand
            | Self::HeightCommand
            | Self::BankCommand
            | Self::YawRateCommand
            | Self::HeadingCommand => &[Shape::Step],
            Self::Turbulence | Self::Release | Self::OneMode => &[],
        }
    }

    /// Whether it is a control or air, whose frequency response can be had.
    pub fn has_frequencies(self) -> bool {
        !self.shapes().is_empty() && self.command().is_none()
    }

    /// Key of the parameter that is its size, with this shape.
    const fn size_key(self, shape: Shape) -> Option<&'static str> {
        match (self, shape) {
            (Self::Elevator, Shape::Pulse) => Some("elevator_pulse"),
            (Self::Elevator, _) => Some("elevator"),
            (Self::Throttle, _) => Some("throttle"),
            (Self::VerticalGust, _) => Some("gust"),
            (Self::HeadGust, _) => Some("head_gust"),
            (Self::Aileron, _) => Some("aileron"),
            (Self::Rudder, _) => Some("rudder"),
            (Self::SideGust, _) => Some("side_gust"),
            (Self::PitchCommand, _) => Some("to_theta"),
            (Self::SpeedCommand, _) => Some("to_u"),
            (Self::HeightCommand, _) => Some("to_h"),
            (Self::BankCommand, _) => Some("to_phi"),
            (Self::YawRateCommand, _) => Some("to_r"),
            (Self::HeadingCommand, _) => Some("to_psi"),
            (Self::Turbulence | Self::Release | Self::OneMode, _) => None,
        }
    }
}

impl Shape {
    const fn keys(self) -> &'static [&'static str] {
        match self {
            Self::Step => &[],
            Self::Pulse | Self::Doublet | Self::ThreeTwoOneOne => &["part"],
            Self::Sine => &["frequency", "lasting"],
            Self::Sweep => &["frequency", "sweep_to", "lasting"],
            Self::OneMinusCosine => &["gust_for"],
        }
    }
}

impl Choice {
    /// The shape that the source has now; `None` where it has one of its own.
    pub fn shape(&self) -> Option<Shape> {
        if self.source.command().is_some() {
            return Some(Shape::Step);
        }
        let own = if self.source.shapes().contains(&Shape::OneMinusCosine) {
            self.gust_shape
        } else {
            self.control_shape
        };
        self.source.shapes().contains(&own).then_some(own)
    }

    /// The shape of the source, to change.
    pub fn shape_mut(&mut self) -> &mut Shape {
        if self.source.shapes().contains(&Shape::OneMinusCosine) {
            &mut self.gust_shape
        } else {
            &mut self.control_shape
        }
    }

    /// Keys of the parameters that size it, besides the time shown and the factor on all.
    pub fn parameters(&self, plane: Plane) -> Vec<&'static str> {
        let shape = self.shape();
        let mut keys: Vec<&'static str> =
            shape.and_then(|shape| self.source.size_key(shape)).into_iter().collect();
        keys.extend(shape.map_or(&[][..], Shape::keys));
        keys.extend(match (self.source, plane) {
            (Source::Turbulence, _) => &["turbulence", "seed"][..],
            (Source::Release, Plane::Longitudinal) => &["from_u", "from_alpha", "from_q", "from_theta"],
            (Source::Release, Plane::Lateral) => &["from_beta", "from_p", "from_r", "from_phi"],
            (Source::OneMode, _) => &["mode_size"],
            _ => &[],
        });
        keys
    }
}

impl Default for Disturbance {
    /// The step of one degree, long enough to see a phugoid; the elevator's pulse is the lesson's, 0.1 rad for 0.2 s.
    fn default() -> Self {
        let choice = |source, control_shape| Choice {
            source,
            control_shape,
            gust_shape: Shape::OneMinusCosine,
            mode: 0,
        };
        Self {
            choices: ByPlane {
                longitudinal: choice(Source::Elevator, Shape::Step),
                lateral: choice(Source::Rudder, Shape::Pulse),
            },
            sizes: Sizes::default(),
            follows: true,
        }
    }
}

impl Default for Sizes {
    fn default() -> Self {
        Self {
            elevator: 1_f64.to_radians(),
            elevator_pulse: 0.1,
            throttle: 0.02,
            aileron: 2_f64.to_radians(),
            rudder: 5_f64.to_radians(),
            part: 0.2,
            frequency: 1.0,
            sweep_to: 10.0,
            lasting: 40.0,
            vertical_gust: 3.0,
            head_gust: 3.0,
            side_gust: 3.0,
            gust_length: 2.0,
            turbulence: 1.0,
            seed: 1.0,
            released: ByPlane {
                longitudinal: [0.0, 2_f64.to_radians(), 0.0, 0.0],
                lateral: [5_f64.to_radians(), 0.0, 0.0, 0.0],
            },
            pitch_command: 2_f64.to_radians(),
            speed_command: 5.0,
            height_command: 20.0,
            bank_command: 10_f64.to_radians(),
            yaw_rate_command: 1_f64.to_radians(),
            heading_command: 10_f64.to_radians(),
            mode: 5_f64.to_radians(),
            times: 1.0,
            time: 60.0,
        }
    }
}

impl Disturbance {
    /// The control or gust that moves, with its shape in time; none in turbulence, released or in one mode.
    pub fn input(&self, plane: Plane) -> Option<(Channel, Input)> {
        let choice = &self.choices[plane];
        let shape = choice.shape()?;
        let sizes = &self.sizes;
        let (channel, size) = match (choice.source, shape) {
            (Source::Elevator, Shape::Pulse) => (Channel::First, sizes.elevator_pulse),
            (Source::Elevator, _) => (Channel::First, sizes.elevator),
            (Source::Throttle, _) => (Channel::Second, sizes.throttle),
            // Rising air moves against z, which points down, and air from ahead against x.
            (Source::VerticalGust, _) => (Channel::AirAcross, -sizes.vertical_gust),
            (Source::HeadGust, _) => (Channel::AirAlong, -sizes.head_gust),
            (Source::Aileron, _) => (Channel::First, sizes.aileron),
            (Source::Rudder, _) => (Channel::Second, sizes.rudder),
            (Source::SideGust, _) => (Channel::AirAcross, sizes.side_gust),
            (Source::PitchCommand, _) => (Channel::Command(Command::PitchAngle), sizes.pitch_command),
            (Source::SpeedCommand, _) => (Channel::Command(Command::Speed), sizes.speed_command),
            (Source::HeightCommand, _) => (Channel::Command(Command::Height), sizes.height_command),
            (Source::BankCommand, _) => (Channel::Command(Command::BankAngle), sizes.bank_command),
            (Source::YawRateCommand, _) => (Channel::Command(Command::YawRate), sizes.yaw_rate_command),
            (Source::HeadingCommand, _) => (Channel::Command(Command::Heading), sizes.heading_command),
            (Source::Turbulence | Source::Release | Source::OneMode, _) => return None,
        };
        let (amplitude, start) = (size * sizes.times, START);
        let input = match shape {
            Shape::Step => Input::Step { amplitude, start },
            Shape::Pulse => Input::Pulse { amplitude, start, duration: sizes.part },
            Shape::Doublet => Input::Doublet { amplitude, start, duration: sizes.part },
            Shape::ThreeTwoOneOne => Input::ThreeTwoOneOne { amplitude, start, unit: sizes.part },
            Shape::Sine => {
                Input::Sine { amplitude, start, duration: sizes.lasting, frequency: sizes.frequency }
            }
            Shape::Sweep => Input::Sweep {
                amplitude,
                start,
                duration: sizes.lasting,
                from: sizes.frequency,
                to: sizes.sweep_to,
            },
            Shape::OneMinusCosine => Input::OneMinusCosine { amplitude, start, duration: sizes.gust_length },
        };
        Some((channel, input))
    }

    /// How the motion of a plane begins.
    pub fn start(&self, plane: Plane) -> Start {
        let (choice, sizes) = (self.choices[plane], &self.sizes);
        match choice.source {
            Source::Release => Start::Released(sizes.released[plane].map(|x| x * sizes.times)),
            Source::OneMode => Start::Mode { index: choice.mode, amplitude: sizes.mode * sizes.times },
            _ => Start::Rest,
        }
    }
}
