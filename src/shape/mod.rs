//! The looks of an aircraft: its geometry, the faces that follow, and the order in which to draw them.
//!
//! ```text
//! Shape ──► body, surface, fittings ──► faces ──► Tree ──► Model ──► back to front, for any eye
//! (data)          (lofted)                     (sorted once)
//! ```
//!
//! | axes | |
//! |---|---|
//! | of a [`Shape`] | as on a drawing: *x* aft of the nose, *y* right, *z* up, metres |
//! | of a [`Model`] | the body axes of [`flight`](crate::flight): *x* forward, *y* right, *z* down, from the centre of gravity |
//!
//! Knows nothing of files, colours, cameras and screens. Any finite shape gives a finite model.

mod body;
mod face;
mod fittings;
mod model;
mod moving;
mod surface;
mod tree;

pub use face::{Face, Material, Point, Vertex};
pub use model::Model;
pub use moving::Deflections;

/// The paint of an airframe.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Finish {
    /// White paint.
    White,
    /// Bare metal.
    Metal,
    /// Black paint, as on an airframe that gets hot.
    Black,
    /// Dull green camouflage.
    Drab,
}

impl Finish {
    /// The finishes by the name that a file gives them.
    pub const NAMES: [(&'static str, Self); 4] =
        [("white", Self::White), ("metal", Self::Metal), ("black", Self::Black), ("drab", Self::Drab)];
}

/// The geometry of an aircraft, as on a drawing.
#[derive(Clone, Debug, PartialEq)]
pub struct Shape {
    /// Name of its file.
    pub key: String,
    /// The aircraft that it is the shape of.
    pub name: String,
    /// Its paint.
    pub finish: Finish,
    /// Centre of gravity, x aft of the nose and z up \[m\]: about which it turns.
    pub cg: [f32; 2],
    /// Fuselage, canopy, nacelles, tanks.
    pub bodies: Vec<Body>,
    /// Wings, tails and fins.
    pub surfaces: Vec<Surface>,
    /// Struts and legs.
    pub struts: Vec<Strut>,
    /// Wheels.
    pub wheels: Vec<Wheel>,
    /// Propellers.
    pub propellers: Vec<Propeller>,
}

/// A body lofted through cross-sections, twice where it stands beside the plane of symmetry.
#[derive(Clone, Debug, PartialEq)]
pub struct Body {
    /// Its material.
    pub material: Material,
    /// Distance from the plane of symmetry \[m\].
    pub y: f32,
    /// Exponent of the cross-section |y|ⁿ + |z|ⁿ = 1: 2 is an ellipse, more has corners.
    pub squareness: f32,
    /// Whether air goes in at its front.
    pub is_open: bool,
    /// Cross-sections from front to back.
    pub stations: Vec<Station>,
    /// Windows and stripes.
    pub patches: Vec<Patch>,
}

/// A cross-section of a body \[m\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Station {
    /// Distance aft of the nose.
    pub x: f32,
    /// Width.
    pub width: f32,
    /// Height.
    pub height: f32,
    /// Height of its middle.
    pub z: f32,
}

/// Part of a body of another material: all that lies within the two ranges \[m\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Patch {
    /// Its material.
    pub material: Material,
    /// From and to, aft of the nose.
    pub x: [f32; 2],
    /// From and to, upwards.
    pub z: [f32; 2],
}

/// A wing, a tailplane or a fin.
#[derive(Clone, Debug, PartialEq)]
pub struct Surface {
    /// Whether it has a twin on the left.
    pub is_pair: bool,
    /// Form of its cross-section.
    pub profile: Profile,
    /// Angle of the chord to the fuselage, leading edge up positive \[rad\].
    pub incidence: f32,
    /// Length of the rounded tip along the span \[m\].
    pub rounding: f32,
    /// Cross-sections from root to tip.
    pub sections: Vec<Section>,
    /// Its parts that move.
    pub controls: Vec<ControlSpan>,
}

/// Form of a wing's cross-section.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Profile {
    /// Round in front, sharp behind.
    Wing,
    /// Sharp in front, blunt behind, as for hypersonic speed.
    Wedge,
}

/// A cross-section of a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Section {
    /// Leading edge: x aft, y right, z up \[m\].
    pub leading_edge: Point,
    /// Chord \[m\].
    pub chord: f32,
    /// Thickness over chord.
    pub thickness: f32,
}

/// Part of a surface that moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ControlSpan {
    /// The control that moves it.
    pub control: Control,
    /// Its inner end, as a fraction of the way from root to tip.
    pub from: f32,
    /// Its outer end, likewise.
    pub to: f32,
    /// Its chord over that of the surface: 1 where all of the surface moves.
    pub chord: f32,
}

/// The control that a moving surface follows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Control {
    /// The stick, fore and aft.
    Elevator,
    /// The stick, to the sides: left and right move against each other.
    Aileron,
    /// The pedals.
    Rudder,
    /// A tail that pitches and rolls: elevator, and aileron on top.
    Elevon,
}

impl Control {
    /// The controls by the name that a file gives them.
    pub const NAMES: [(&'static str, Self); 4] = [
        ("elevator", Self::Elevator),
        ("aileron", Self::Aileron),
        ("rudder", Self::Rudder),
        ("elevon", Self::Elevon),
    ];
}

/// A strut between two points, with a twin on the left where it isn't in the plane of symmetry \[m\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Strut {
    /// One end: x aft, y right, z up.
    pub from: Point,
    /// The other end.
    pub to: Point,
    /// Width fore and aft.
    pub chord: f32,
    /// Width across.
    pub thickness: f32,
}

/// A wheel, with a twin on the left where it isn't in the plane of symmetry \[m\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wheel {
    /// Its middle: x aft, y right, z up.
    pub centre: Point,
    /// Diameter.
    pub diameter: f32,
    /// Width of the tyre.
    pub width: f32,
}

/// A propeller, with a twin on the left where it isn't in the plane of symmetry.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Propeller {
    /// Its hub: x aft, y right, z up \[m\].
    pub hub: Point,
    /// Diameter \[m\].
    pub diameter: f32,
    /// Number of blades.
    pub blades: u8,
}

impl Shape {
    /// Span of the widest surface \[m\].
    pub fn span(&self) -> f32 {
        let tips = self
            .surfaces
            .iter()
            .filter(|surface| surface.is_pair)
            .flat_map(|surface| surface.sections.iter().map(|section| section.leading_edge.y));
        2.0 * tips.fold(0.0, f32::max)
    }
}
