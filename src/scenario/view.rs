//! How a person looks at a scenario. It is no part of what is studied: undo leaves it alone, but a link carries it.
//!
//! Only what outlasts a frame and can be told to others is here. Where the pointer is, what is held and pictures that are kept stay
//! with the panes.

use std::f32::consts::{FRAC_PI_2, PI};

use super::{Page, Parameter, Scenario, Stage, parameters};
use crate::flight::aircraft::plane::{ByPlane, Plane};
use crate::flight::motion::outputs::Output;
use crate::key::keys;

/// How a person looks at a scenario.
#[derive(Clone, Debug, PartialEq)]
pub struct View {
    /// What of the page is on.
    pub stage: Stage,
    /// Whether it fills the screen, for a room to look at.
    pub presents: bool,
    /// How the page looks where the link says so; otherwise as the person has chosen, or their system has it.
    pub look: Option<Look>,
    /// The page of sliders.
    pub page: Page,
    /// The pane alone beside the sliders.
    pub maximised: Option<Pane>,
    /// Whether the loop is shown open: the aircraft as it flies without its law of feedback.
    pub shows_open: bool,
    /// Marks on the pole map.
    pub marks: Marks,
    /// Details that the cards of the modes show.
    pub details: Details,
    /// How the motion is shown.
    pub response: ResponseView,
    /// How the aircraft in flight is shown.
    pub flight: FlightView,
    /// How the equations are written.
    pub equations: EquationsView,
}

impl View {
    /// The page as it opens with a scenario.
    pub fn of(scenario: &Scenario) -> Self {
        Self {
            stage: Stage::default(),
            presents: false,
            look: None,
            page: Page::of(scenario),
            maximised: None,
            shows_open: false,
            marks: Marks::default(),
            details: Details::default(),
            response: ResponseView::default(),
            flight: FlightView::default(),
            equations: EquationsView::default(),
        }
    }
}

/// How the page looks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Look {
    /// Dark on light.
    Light,
    /// Light on dark.
    Dark,
    /// Strong colours on white.
    Projector,
}

keys! {
    Look {
        Light => "light",
        Dark => "dark",
        Projector => "projector",
    }
}

/// A pane that can stand alone beside the sliders.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Pane {
    /// The pole map.
    Poles,
    /// The aircraft in flight.
    Aircraft,
    /// The responses.
    Response,
    /// The equations.
    Equations,
}

keys! {
    Pane {
        Poles => "poles",
        Aircraft => "aircraft",
        Response => "response",
        Equations => "equations",
    }
}

/// How the equations are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct EquationsView {
    /// As what their entries stand there.
    pub entries: Entries,
    /// The mode by whose sensitivity they are coloured, by its place among the modes; `None` for no colours.
    pub coloured: Option<usize>,
}

impl Default for EquationsView {
    fn default() -> Self {
        Self { entries: Entries::default(), coloured: Some(0) }
    }
}

/// As what the entries of A and B stand in the equations.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Entries {
    /// As numbers.
    #[default]
    Numbers,
    /// As the symbols of their sliders.
    Symbols,
    /// As what they are made of.
    Full,
}

keys! {
    Entries {
        Numbers => "numbers",
        Symbols => "symbols",
        Full => "full",
    }
}

/// Marks on the pole map beside the poles.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Marks {
    /// Where the textbook approximations put the poles.
    pub approximations: bool,
    /// The boundaries of the handling-quality levels.
    pub levels: bool,
}

/// Which details the cards of the modes show, of all modes alike, so that modes can be compared.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Details {
    /// The shape of the mode.
    pub shape: bool,
    /// The paragraphs that set its level.
    pub levels: bool,
    /// Its textbook approximations.
    pub approximations: bool,
}

/// How the motion is shown.
#[derive(Clone, Debug, PartialEq)]
pub struct ResponseView {
    /// In which way.
    pub tab: Tab,
    /// Whether the nonlinear flight is drawn beside the linear motion.
    pub nonlinear: bool,
    /// Shown over time, of each plane, in the order of its outputs; never nothing.
    pub shown: ByPlane<Vec<Output>>,
    /// Whether motions over time are split into modes.
    pub split: bool,
    /// Two phase portraits of each plane, (across, upward): one for the fast mode, one for the slow.
    pub portraits: ByPlane<[(Output, Output); 2]>,
    /// The output of the frequency response, of each plane.
    pub frequency_of: ByPlane<Output>,
    /// The input whose loop is cut, of each plane: whether it is the second, throttle or rudder.
    pub cuts_second: ByPlane<bool>,
    /// What is charted over a slider, of each plane.
    pub chart: ByPlane<ChartView>,
}

impl Default for ResponseView {
    fn default() -> Self {
        use Output::{
            AngleOfAttack, BankAngle, ForwardSpeed, Heading, Height, PitchAngle, PitchRate, RollRate,
            Sideslip, YawRate,
        };
        Self {
            tab: Tab::default(),
            nonlinear: false,
            shown: ByPlane {
                longitudinal: vec![ForwardSpeed, AngleOfAttack, PitchRate, PitchAngle, Height],
                lateral: vec![Sideslip, RollRate, YawRate, BankAngle, Heading],
            },
            split: false,
            portraits: ByPlane {
                longitudinal: [(AngleOfAttack, PitchRate), (ForwardSpeed, PitchAngle)],
                lateral: [(Sideslip, RollRate), (Sideslip, YawRate)],
            },
            frequency_of: ByPlane { longitudinal: PitchRate, lateral: Sideslip },
            cuts_second: ByPlane { longitudinal: false, lateral: true },
            chart: ByPlane {
                longitudinal: ChartView::of("short_period.damping_ratio"),
                lateral: ChartView::of("dutch_roll.damping_ratio"),
            },
        }
    }
}

/// A measure charted over the range of a slider.
#[derive(Clone, Debug, PartialEq)]
pub struct ChartView {
    /// Key of the measure.
    pub measure: String,
    /// The slider, where a person has chosen one.
    pub over: Option<&'static Parameter>,
    /// Lines of their own, at values of the measure \[SI\].
    pub lines: Vec<f64>,
}

impl ChartView {
    /// A chart has no more lines of one's own.
    pub const MOST_LINES: usize = 8;

    /// A measure by its key, over what stands to reason.
    fn of(measure: &str) -> Self {
        Self { measure: measure.to_owned(), over: None, lines: Vec::new() }
    }

    /// The slider that it is over: the chosen one, else the first of these that the aircraft has; `None` where it has no slider in the
    /// plane on screen.
    pub fn over(&self, scenario: &Scenario) -> Option<&'static Parameter> {
        let usual: &[&str] = match scenario.plane {
            Plane::Longitudinal => &["cg", "m_w", "a_qw"],
            Plane::Lateral => &["fin", "n_v", "a_rv"],
        };
        let usual = usual.iter().filter_map(|key| Parameter::find(key));
        self.over.into_iter().chain(usual).chain(parameters()).find(|p| Self::can_be_over(p, scenario))
    }

    /// Whether a chart can be over a parameter: it has a slider for the plane on screen.
    pub fn can_be_over(parameter: &Parameter, scenario: &Scenario) -> bool {
        parameter.page.is_some_and(|page| page.is_of(scenario) && parameter.is_shown(scenario, page))
    }
}

impl ResponseView {
    /// Whether the nonlinear flight is on screen.
    pub fn shows_flight(&self) -> bool {
        self.nonlinear && matches!(self.tab, Tab::Time | Tab::Phase)
    }
}

/// In which way the response is shown.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Tab {
    /// Over time.
    #[default]
    Time,
    /// One output over another.
    Phase,
    /// Over frequency.
    Frequency,
    /// The loop of a control cut before its actuator, over frequency; where a law feeds back.
    Loop,
    /// The same as a curve in the complex plane.
    Nyquist,
    /// The damping over the gain and the washout of a rate.
    Map,
    /// In numbers.
    Metrics,
    /// A measure over a slider.
    Chart,
}

keys! {
    Tab {
        Time => "time",
        Phase => "phase",
        Frequency => "frequency",
        Loop => "loop",
        Nyquist => "nyquist",
        Map => "gain-map",
        Metrics => "metrics" | "figures",
        Chart => "chart",
    }
}

impl Tab {
    /// All, in the order of the page.
    pub const ALL: [Self; 8] = [
        Self::Time,
        Self::Phase,
        Self::Frequency,
        Self::Loop,
        Self::Nyquist,
        Self::Map,
        Self::Metrics,
        Self::Chart,
    ];
}

/// How the aircraft in flight is shown.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FlightView {
    /// From where.
    pub camera: Camera,
    /// Arrows, axes and paths drawn over it.
    pub overlays: Overlays,
    /// How it is played.
    pub pace: Pace,
    /// Where the playback begins when the scene is opened.
    pub instant: Instant,
    /// The attitude that the aircraft is turned to by hand, instead of flying.
    pub turn: Option<Turn>,
}

/// An attitude by hand, in whole degrees: the Euler angles in the order in which they turn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Turn {
    /// Heading ψ \[°\], nose right positive: first, about the Earth's z axis.
    pub psi: i16,
    /// Pitch θ \[°\], nose-up positive: second, about the y axis as ψ has left it.
    pub theta: i16,
    /// Bank φ \[°\], right wing down positive: third, about the body's x axis.
    pub phi: i16,
}

impl Turn {
    /// Largest ψ, θ and φ either way \[°\].
    pub const LARGEST: [i16; 3] = [180, 90, 180];
}

/// An instant of a playback.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Instant {
    /// Time in the motion \[s\].
    pub time: f64,
    /// Whether it plays on from there, or is at rest.
    pub is_playing: bool,
}

/// How a motion is played.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pace {
    /// Seconds of motion in a second.
    pub rate: f64,
    /// Whether it begins again at its end.
    pub is_looping: bool,
}

impl Pace {
    /// Rates that a person can choose.
    pub const RATES: [f64; 9] = [0.125, 0.25, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0, 32.0];

    /// The rate nearest to one that is wanted, by its ratio; real time where none is.
    pub fn nearest_rate(wanted: f64) -> f64 {
        let distance = |rate: &f64| (rate / wanted).ln().abs();
        let nearest = Self::RATES.into_iter().min_by(|x, y| distance(x).total_cmp(&distance(y)));
        nearest.filter(|_| wanted.is_finite() && wanted > 0.0).unwrap_or(1.0)
    }
}

impl Default for Pace {
    fn default() -> Self {
        Self { rate: 1.0, is_looping: true }
    }
}

/// From where the aircraft is seen: around it at a distance, always upright, so that the horizon stays level.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// Around the aircraft \[rad\]: 0 behind it, a quarter of a turn on its right.
    pub azimuth: f32,
    /// Above the aircraft \[rad\].
    pub elevation: f32,
    /// Distance over the one at which the aircraft fills the pane.
    pub distance: f32,
}

/// Nearest and farthest distance, over the one at which the aircraft fills the pane; never within the aircraft, and so far that a
/// wave of the phugoid is seen whole.
const ZOOM: (f32, f32) = (0.5, 1000.0);
/// Beyond this distance the aircraft is a dot on its path.
const FAR: f32 = 10.0;
/// It looks up no more than this, and down no more than nearly upright \[rad\].
const LOWEST: f32 = -0.5;
const STEEPEST: f32 = FRAC_PI_2 - 0.001;

/// The views that have a button and a key.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StandardView {
    /// From the right, ahead and above.
    ThreeQuarter,
    /// From behind.
    Chase,
    /// From the right.
    Side,
    /// From above.
    Top,
}

keys! {
    StandardView {
        ThreeQuarter => "three-quarter",
        Chase => "chase",
        Side => "side",
        Top => "top",
    }
}

impl StandardView {
    /// All, in the order of their keys 1 to 4.
    pub const ALL: [Self; 4] = [Self::ThreeQuarter, Self::Chase, Self::Side, Self::Top];

    /// Its camera.
    pub const fn camera(self) -> Camera {
        let (azimuth, elevation, distance) = match self {
            Self::ThreeQuarter => (2.2, 0.27, 1.0),
            Self::Chase => (0.0, 0.22, 1.0),
            Self::Side => (FRAC_PI_2, 0.04, 1.0),
            // Its length stands upright, where there is less room.
            Self::Top => (0.0, STEEPEST, 1.5),
        };
        Camera { azimuth, elevation, distance }
    }
}

impl Default for Camera {
    fn default() -> Self {
        StandardView::ThreeQuarter.camera()
    }
}

impl Camera {
    /// A camera within its limits.
    pub fn new(azimuth: f32, elevation: f32, distance: f32) -> Self {
        Self {
            azimuth,
            elevation: elevation.clamp(LOWEST, STEEPEST),
            distance: distance.clamp(ZOOM.0, ZOOM.1),
        }
    }

    /// Turned around the aircraft \[rad\].
    pub fn orbit(&mut self, around: f32, up: f32) {
        if around == 0.0 && up == 0.0 {
            // Not even by rounding: a standard view is known by its numbers.
            return;
        }
        self.azimuth = (self.azimuth + around + PI).rem_euclid(2.0 * PI) - PI;
        self.elevation = (self.elevation + up).clamp(LOWEST, STEEPEST);
    }

    /// Whether it is so far away that the path is what is to be seen, not the aircraft.
    pub fn is_far(&self) -> bool {
        self.distance > FAR
    }

    /// Nearer by a factor above 1, farther by one below.
    pub fn zoom(&mut self, factor: f32) {
        if factor > 0.0 {
            self.distance = (self.distance / factor).clamp(ZOOM.0, ZOOM.1);
        }
    }
}

/// Arrows, axes and paths drawn over the aircraft.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Overlays {
    /// Axes of the body x, y, z.
    pub body_axes: bool,
    /// Axes of the Earth: north as flown, east, down.
    pub earth_axes: bool,
    /// Roll, pitch and yaw φ, θ, ψ.
    pub angles: bool,
    /// Angular rates p, q, r.
    pub rates: bool,
    /// Lift, weight, thrust, drag.
    pub forces: bool,
    /// Velocity, angle of attack and sideslip.
    pub flow: bool,
    /// The path flown.
    pub path: bool,
    /// The moments that push and damp.
    pub moments: bool,
    /// Stability axes: the body's, turned about y until x lies along the steady flight.
    pub stability_axes: bool,
}

impl Default for Overlays {
    fn default() -> Self {
        Self {
            body_axes: true,
            earth_axes: false,
            angles: true,
            rates: false,
            forces: true,
            flow: true,
            path: true,
            moments: true,
            stability_axes: false,
        }
    }
}
