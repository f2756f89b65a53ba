//! How a scene is looked at: what an instructor sets before sending it. Only what differs from the page as it opens is written.
//!
//! A value that is no good is left out as a whole, with one sentence.

use super::notice::{Notice, quoted};
use super::pieces::Pieces;
use super::words;
use crate::flight::aircraft::plane::{ByPlane, Plane};
use crate::flight::motion::outputs::Output;
use crate::scenario::Quantity;

/// A pane that can stand alone beside the sliders.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Pane {
    /// The pole map.
    Poles,
    /// The aircraft in flight.
    Aircraft,
    /// The responses.
    Response,
}

/// From where the aircraft is seen.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Viewpoint {
    /// From the right, ahead and above.
    #[default]
    ThreeQuarter,
    /// From behind.
    Chase,
    /// From the right.
    Side,
    /// From above.
    Top,
    /// From anywhere else, rounded.
    From {
        /// Around the aircraft \[deg\]: 0 behind it, 90 on its right.
        azimuth: i16,
        /// Above the aircraft \[deg\].
        elevation: i16,
        /// Distance over the one at which the aircraft fills the pane \[%\].
        distance: i16,
    },
}

/// What is drawn over the aircraft.
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
        }
    }
}

/// What is marked on the pole map beside the poles.
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
    /// What sets its level.
    pub levels: bool,
    /// Its textbook approximations.
    pub approximations: bool,
}

/// How a person looks at a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Sight {
    /// What is shown over time, of each plane, in the order of its outputs; never nothing.
    pub shown: ByPlane<Vec<Output>>,
    /// Whether motions over time are split into modes.
    pub split: bool,
    /// Two phase portraits of each plane, (across, upward): one for the fast mode, one for the slow.
    pub portraits: ByPlane<[(Output, Output); 2]>,
    /// The output of the frequency response, of each plane.
    pub frequency_of: ByPlane<Output>,
    /// What is marked on the pole map.
    pub marks: Marks,
    /// What the cards of the modes show.
    pub details: Details,
    /// The pane alone beside the sliders.
    pub maximised: Option<Pane>,
    /// From where the aircraft is seen.
    pub viewpoint: Viewpoint,
    /// What is drawn over it.
    pub overlays: Overlays,
    /// Seconds of motion played in a second.
    pub rate: f64,
    /// Whether the playback begins again at its end.
    pub is_looping: bool,
}

impl Default for Sight {
    fn default() -> Self {
        use Output::{
            AngleOfAttack, BankAngle, ForwardSpeed, Heading, Height, PitchAngle, PitchRate, RollRate,
            Sideslip, YawRate,
        };
        Self {
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
            marks: Marks::default(),
            details: Details::default(),
            maximised: None,
            viewpoint: Viewpoint::default(),
            overlays: Overlays::default(),
            rate: 1.0,
            is_looping: true,
        }
    }
}

impl Sight {
    /// The pieces of a link that differ from the page as it opens.
    pub(super) fn write(&self) -> Vec<(String, String)> {
        let usual = Self::default();
        let pieces = |sight: &Self| {
            let mut pieces = Vec::new();
            for plane in Plane::ALL {
                let mut of_plane = |key, outputs: Vec<Output>| {
                    let keys: Vec<&str> =
                        outputs.into_iter().map(|output| Quantity::of(output).key).collect();
                    pieces.push((format!("{}.{key}", words::plane(plane)), keys.join(".")));
                };
                of_plane("show", sight.shown[plane].clone());
                of_plane(
                    "phase",
                    sight.portraits[plane].iter().flat_map(|&(across, upward)| [across, upward]).collect(),
                );
                of_plane("frequency_of", vec![sight.frequency_of[plane]]);
            }
            let word = |word: Option<&str>| word.unwrap_or_default().to_owned();
            for (key, value) in [
                ("split", word(words::word_of(&words::SPLITS, sight.split))),
                ("marks", listed(&words::MARKS, sight.marks.flags())),
                ("details", listed(&words::DETAILS, sight.details.flags())),
                ("pane", word(sight.maximised.and_then(|pane| words::word_of(&words::PANES, pane)))),
                ("camera", sight.viewpoint.text()),
                ("drawn", listed(&words::OVERLAYS, sight.overlays.flags())),
                ("rate", word(words::word_of(&words::RATES, sight.rate))),
                ("loop", word(words::word_of(&words::LOOPS, sight.is_looping))),
            ] {
                pieces.push((key.to_owned(), value));
            }
            pieces
        };
        let usual = pieces(&usual);
        pieces(self).into_iter().filter(|piece| !usual.contains(piece)).collect()
    }

    /// Takes its pieces out of a link.
    pub(super) fn read(pieces: &mut Pieces) -> Self {
        let mut sight = Self::default();
        for plane in Plane::ALL {
            let key = |key| format!("{}.{key}", words::plane(plane));
            if let Some(mut shown) = take(pieces, &key("show"), |text| outputs(plane, text)) {
                // In the order of the page, whatever the order of the link.
                shown.sort_by_key(|output| Output::of(plane).iter().position(|other| other == output));
                shown.dedup();
                sight.shown[plane] = shown;
            }
            let four = |text: &str| <[Output; 4]>::try_from(outputs(plane, text)?).ok();
            if let Some([a, b, c, d]) = take(pieces, &key("phase"), four) {
                sight.portraits[plane] = [(a, b), (c, d)];
            }
            let one = |text: &str| <[Output; 1]>::try_from(outputs(plane, text)?).ok();
            if let Some([output]) = take(pieces, &key("frequency_of"), one) {
                sight.frequency_of[plane] = output;
            }
        }
        sight.split = pieces.take_word("split", &words::SPLITS).unwrap_or(sight.split);
        if let Some([approximations, levels]) = take(pieces, "marks", |text| flags(&words::MARKS, text)) {
            sight.marks = Marks { approximations, levels };
        }
        if let Some([shape, levels, approximations]) =
            take(pieces, "details", |text| flags(&words::DETAILS, text))
        {
            sight.details = Details { shape, levels, approximations };
        }
        sight.maximised = pieces.take_word("pane", &words::PANES);
        sight.viewpoint = take(pieces, "camera", Viewpoint::read).unwrap_or_default();
        if let Some([body_axes, earth_axes, angles, rates, forces, flow, path, moments]) =
            take(pieces, "drawn", |text| flags(&words::OVERLAYS, text))
        {
            sight.overlays = Overlays { body_axes, earth_axes, angles, rates, forces, flow, path, moments };
        }
        sight.rate = pieces.take_word("rate", &words::RATES).unwrap_or(sight.rate);
        sight.is_looping = pieces.take_word("loop", &words::LOOPS).unwrap_or(sight.is_looping);
        sight
    }
}

impl Marks {
    const fn flags(self) -> [bool; 2] {
        [self.approximations, self.levels]
    }
}

impl Details {
    const fn flags(self) -> [bool; 3] {
        [self.shape, self.levels, self.approximations]
    }
}

impl Overlays {
    const fn flags(self) -> [bool; 8] {
        let Self { body_axes, earth_axes, angles, rates, forces, flow, path, moments } = self;
        [body_axes, earth_axes, angles, rates, forces, flow, path, moments]
    }
}

impl Viewpoint {
    fn text(self) -> String {
        match (words::word_of(&words::VIEWPOINTS, self), self) {
            (None, Self::From { azimuth, elevation, distance }) => {
                format!("{azimuth}.{elevation}.{distance}")
            }
            (word, _) => word.unwrap_or_default().to_owned(),
        }
    }

    fn read(text: &str) -> Option<Self> {
        if let Some(standard) = words::meaning_of(&words::VIEWPOINTS, text) {
            return Some(standard);
        }
        let numbers: Vec<i16> = text.split('.').map(|part| part.parse().ok()).collect::<Option<_>>()?;
        let [azimuth, elevation, distance] = numbers[..] else { return None };
        let fits = (-180..=180).contains(&azimuth)
            && (-29..=90).contains(&elevation)
            && (50..=600).contains(&distance);
        fits.then_some(Self::From { azimuth, elevation, distance })
    }
}

/// The value of a key as `read` understands it; one that it doesn't is left out and told.
fn take<T>(pieces: &mut Pieces, key: &str, read: impl Fn(&str) -> Option<T>) -> Option<T> {
    let text = pieces.take(key)?;
    let meant = read(&text);
    if meant.is_none() {
        pieces.notices.push(Notice::Word { key: quoted(key), word: quoted(&text) });
    }
    meant
}

/// Outputs of a plane, joined by points.
fn outputs(plane: Plane, text: &str) -> Option<Vec<Output>> {
    let output = |key| Output::of(plane).iter().find(|output| Quantity::of(**output).key == key).copied();
    text.split('.').map(output).collect()
}

/// The words of what is on, joined by points.
fn listed<const N: usize>(words: &[&str; N], flags: [bool; N]) -> String {
    let on: Vec<&str> = words.iter().zip(flags).filter(|(_, on)| *on).map(|(word, _)| *word).collect();
    if on.is_empty() { words::NOTHING.to_owned() } else { on.join(".") }
}

fn flags<const N: usize>(words: &[&str; N], text: &str) -> Option<[bool; N]> {
    let mut flags = [false; N];
    if text == words::NOTHING {
        return Some(flags);
    }
    for part in text.split('.') {
        flags[words.iter().position(|word| *word == part)?] = true;
    }
    Some(flags)
}
