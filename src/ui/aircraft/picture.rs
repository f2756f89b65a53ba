//! What the pane shows at one moment. Angles in radians, lengths in metres.

use egui::Color32;

use crate::number::{fixed, significant};
use crate::shape::{Deflections, Finish, Model, Point};
use nalgebra::Rotation3;

/// An aircraft at one moment of its flight.
#[derive(Clone, Copy, Debug)]
pub struct Picture<'a> {
    /// Its name.
    pub name: &'a str,
    /// Whether what is measured stands beside what is drawn.
    pub is_numbered: bool,
    /// Whether the path may be drawn.
    pub shows_path: bool,
    /// Its faces.
    pub model: &'a Model,
    /// Its paint.
    pub finish: Finish,
    /// Where it points, as drawn.
    pub attitude: Attitude,
    /// What its angles are, however much larger they are drawn.
    pub figures: Figures,
    /// Where it is: north, east, down from where the flight began \[m\].
    pub position: [f64; 3],
    /// Where undisturbed flight would have brought it: north, east, down \[m\].
    pub steady_position: [f64; 3],
    /// Speed of undisturbed flight \[m/s\]: sets the size of the fields below.
    pub speed: f64,
    /// Angle of attack α \[rad\] as drawn, positive where the air comes from below.
    pub alpha: f64,
    /// Sideslip β \[rad\] as drawn, positive where the air comes from the right.
    pub beta: f64,
    /// Angle of attack of the steady flight \[rad\].
    pub steady_alpha: f64,
    /// Whether it is turned by hand: then it shows axes and angles, and nothing of a flight.
    pub is_turned: bool,
    /// Roll, pitch and yaw rate p, q, r \[rad/s\].
    pub rates: [f64; 3],
    /// Positions of the controls.
    pub deflections: Deflections,
    /// How far the propellers have turned \[rad\].
    pub propeller_angle: f32,
    /// The four forces.
    pub forces: Forces,
    /// Where it has been: north, east, down, the oldest first, up to where it is \[m\].
    pub path: &'a [[f64; 3]],
    /// Half of the way from where the path of the whole motion begins to where it ends \[m\].
    pub path_reach: f64,
    /// Whether the path is all of it, seen from so far that the aircraft is a dot.
    pub is_far: bool,
    /// Moments to draw.
    pub moments: &'a [Moment<'a>],
    /// Whether it flies in one mode alone: then its moments are what is to be seen.
    pub is_one_mode: bool,
    /// A sentence on what is exaggerated, or why time stands still, shown on the picture.
    pub note: Option<&'a str>,
    /// Whether it is drawn under a veil: it isn't the aircraft of the time that the playback tells.
    pub is_dimmed: bool,
}

/// Attitude by Euler angles, in the order yaw, pitch, roll \[rad\].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Attitude {
    /// Bank φ, right wing down positive.
    pub phi: f64,
    /// Pitch θ of the fuselage above the horizon, nose-up positive: with the trim's own.
    pub theta: f64,
    /// Heading ψ from that of undisturbed flight, nose right positive.
    pub psi: f64,
}

/// What words and labels tell of a moment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Figures {
    /// Where it points.
    pub attitude: Attitude,
    /// Angle of attack α \[rad\], positive where the air comes from below.
    pub alpha: f64,
    /// Sideslip β \[rad\], positive where the air comes from the right.
    pub beta: f64,
    /// Height over that of undisturbed flight \[m\].
    pub height: f64,
}

/// The four forces, each over the weight, in body axes: x forward, y right, z down.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Forces {
    /// Lift L.
    pub lift: [f64; 3],
    /// Weight W.
    pub weight: [f64; 3],
    /// Thrust T.
    pub thrust: [f64; 3],
    /// Drag D.
    pub drag: [f64; 3],
    /// The weight that they are counted in \[N\], where it is known.
    pub unit: Option<f64>,
    /// Whether thrust and drag are numbers, or drawn for the eye.
    pub is_drag_known: bool,
}

impl Forces {
    /// All, each with its name and its size in words.
    pub(super) fn all(&self) -> [(&'static str, [f64; 3], Option<String>); 4] {
        let Self { lift, weight, thrust, drag, .. } = *self;
        let known = |force: [f64; 3]| Some(self.size(force));
        let for_the_eye = |force: [f64; 3]| self.is_drag_known.then(|| self.size(force));
        [
            ("lift", lift, known(lift)),
            ("weight", weight, known(weight)),
            ("thrust", thrust, for_the_eye(thrust)),
            ("drag", drag, for_the_eye(drag)),
        ]
    }

    /// In newtons; in weights where those are unknown.
    fn size(&self, force: [f64; 3]) -> String {
        let size = force.iter().map(|x| x * x).sum::<f64>().sqrt();
        match self.unit.map(|unit| size * unit) {
            Some(newtons) if newtons >= KILONEWTONS => format!("{} kN", significant(newtons / 1000.0, 3)),
            Some(newtons) => format!("{} N", significant(newtons, 3)),
            None => format!("{} W", fixed(size, 2)),
        }
    }

    /// What of them isn't in the aircraft's source.
    pub(super) fn remark(&self) -> Option<&'static str> {
        match (self.unit.is_some(), self.is_drag_known) {
            (true, true) => None,
            (false, true) => Some("The source gives no mass: forces are in weights W."),
            (true, false) => Some(
                "The source gives no drag: it is drawn as a tenth of the weight, and the thrust as its equal.",
            ),
            (false, false) => Some(
                "The source gives neither mass nor drag: forces are in weights W, and drag is drawn as a tenth \
                 of the weight, the thrust as its equal.",
            ),
        }
    }
}

/// From here on a force is in kilonewtons \[N\].
const KILONEWTONS: f64 = 1e4;

/// A moment that pushes or damps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moment<'a> {
    /// Its symbol, in the notation of typeset symbols, such as `M_α α`.
    pub symbol: &'a str,
    /// The axis that it turns about.
    pub axis: Axis,
    /// Its size, −1 to 1 in a unit of its caller's: positive turns as the right hand about the axis.
    pub size: f64,
    /// Its colour.
    pub color: Color32,
}

/// A body axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// Forward: roll, right wing down positive.
    X,
    /// Right: pitch, nose-up positive.
    Y,
    /// Down: yaw, nose right positive.
    Z,
}

impl Attitude {
    /// From body to Earth axes.
    pub(super) fn rotation(&self) -> Rotation3<f32> {
        Rotation3::from_euler_angles(finite(self.phi), finite(self.theta), finite(self.psi))
    }
}

/// As the graphics have it; what is no number is drawn as 0.
pub(super) fn finite(x: f64) -> f32 {
    let x = x as f32;
    if x.is_finite() { x } else { 0.0 }
}

pub(super) fn point(p: [f64; 3]) -> Point {
    Point::from(p.map(finite))
}

/// An angle in degrees, as a person reads it.
pub(super) fn degrees(angle: f64) -> String {
    format!("{}°", fixed(angle.to_degrees(), 1))
}

impl Picture<'_> {
    /// From the flight's start, relative to where the aircraft is \[m\].
    pub(super) fn seen_from_here(&self, place: [f64; 3]) -> Point {
        point([0, 1, 2].map(|k| place[k] - self.position[k]))
    }

    /// The picture in a sentence, for those who can't see it.
    pub fn sentence(&self) -> String {
        if !self.is_numbered {
            let note = self.note.map_or_else(String::new, |note| format!(": {note}"));
            return format!("{}{note}", self.name);
        }
        let Figures { attitude: Attitude { phi, theta, psi }, alpha, beta, height } = self.figures;
        if self.is_turned {
            let [psi, theta, phi] = [psi, theta, phi].map(degrees);
            return format!("{}, turned by hand: heading {psi}, pitch {theta}, bank {phi}", self.name);
        }
        let mut sentence = format!(
            "{}: pitch {}, bank {}, heading {}, angle of attack {}, sideslip {}, altitude {} m from steady flight",
            self.name,
            degrees(theta),
            degrees(phi),
            degrees(psi),
            degrees(alpha),
            degrees(beta),
            significant(height, 3),
        );
        for (name, _, size) in self.forces.all() {
            if let Some(size) = size {
                sentence.push_str(&format!(", {name} {size}"));
            }
        }
        if let Some(note) = self.note {
            sentence.push_str(". ");
            sentence.push_str(note);
        }
        sentence
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn attitudes_turn_as_their_signs_say() {
        let still = Attitude::default();
        // North, east, down.
        let right_wing = Attitude { phi: 0.1, ..still }.rotation() * Point::y();
        assert!(right_wing.z > 0.05, "φ > 0: right wing down");
        let nose = Attitude { theta: 0.1, ..still }.rotation() * Point::x();
        assert!(nose.z < -0.05, "θ > 0: nose up");
        let nose = Attitude { psi: 0.1, ..still }.rotation() * Point::x();
        assert!(nose.y > 0.05, "ψ > 0: nose right");
    }

    #[test]
    fn heading_turns_first_then_pitch_then_bank() {
        let (psi, theta, phi) = (0.7, -0.4, 1.1);
        let turned = Attitude { phi, theta, psi }.rotation();
        let about = |axis: nalgebra::Unit<Point>, angle: f64| Rotation3::from_axis_angle(&axis, angle as f32);
        // About z of the Earth; about y as that leaves it; about x as both leave it.
        let first = about(Point::z_axis(), psi);
        let second = about(first * Point::y_axis(), theta) * first;
        let third = about(second * Point::x_axis(), phi) * second;
        assert!((turned.matrix() - third.matrix()).norm() < 1e-6);
    }
}
