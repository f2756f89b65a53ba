//! What is drawn over the aircraft: axes, angles, rates, forces, the flow, moments, and the path behind it.

use egui::{Color32, Mesh, Painter, Pos2, Rect, Vec2};
use nalgebra::Rotation3;

use super::arrows::{ArrowStyle, Tip, arc, plain, straight};
use super::camera::Lens;
use super::labels::{Labels, Words};
use super::landscape::stroke;
use super::picture::{Axis, Picture, degrees, finite, point};
use crate::scenario::view::Overlays;
use crate::shape::Point;
use crate::ui::theme::Palette;

// In lengths of the nose, from the centre of gravity.
const X_AXIS: f32 = 1.14;
const VELOCITY: f32 = 1.27;
const ANGLE_ARC: f32 = 1.04;
const FLOW_ARC: f32 = 1.2;
// In radii of the aircraft.
const Y_AXIS: f32 = 0.72;
const Z_AXIS: f32 = 0.5;
const EARTH_AXIS: f32 = 0.62;
const WEIGHT: f32 = 0.75;
const RATE_ARC: f32 = 0.2;
/// Of stability axes over body axes: beside each other their names would lie on each other.
const STABILITY_AXIS: f32 = 1.22;
/// Of a body axis, where the arrow of its rate stands.
const RATE_AT: f32 = 0.85;
const MOMENT_ARC: f32 = 0.42;
const MOMENT_STEP: f32 = 0.12;

/// A smaller angle has no arc \[rad\].
const SMALLEST_ANGLE: f64 = 0.002;
/// A rate of this size \[rad/s\] has an arrow of half a turn.
const RATE_OF_HALF_A_TURN: f64 = 0.5;
/// A moment of size 1 has an arrow of this angle \[rad\].
const FULL_MOMENT: f32 = 1.9;

impl Overlays {
    /// Each with its words, for boxes to tick.
    pub fn boxes(&mut self) -> [(&'static str, &mut bool); 9] {
        [
            ("Body axes", &mut self.body_axes),
            ("Stability axes", &mut self.stability_axes),
            ("Earth axes", &mut self.earth_axes),
            ("Roll, pitch and yaw", &mut self.angles),
            ("Angular rates", &mut self.rates),
            ("Forces", &mut self.forces),
            ("Velocity, α and β", &mut self.flow),
            ("Path flown", &mut self.path),
            ("Moments", &mut self.moments),
        ]
    }
}

/// All that overlays are drawn with.
pub(super) struct OverlayPainter<'a> {
    pub painter: &'a Painter,
    pub pane: Rect,
    pub lens: Lens,
    pub picture: &'a Picture<'a>,
    pub rotation: Rotation3<f32>,
    pub palette: &'static Palette,
    pub labels: Labels,
}

impl OverlayPainter<'_> {
    fn radius(&self) -> f32 {
        self.picture.model.radius()
    }

    /// From the centre of gravity to the nose \[m\], or what looks well where that is short.
    fn nose(&self) -> f32 {
        self.picture.model.bounds().1.x.max(0.6 * self.radius())
    }

    /// Lengths of the body axes as drawn \[m\].
    fn axis_length(&self, axis: Axis) -> f32 {
        match axis {
            Axis::X => X_AXIS * self.nose(),
            Axis::Y => Y_AXIS * self.radius(),
            Axis::Z => Z_AXIS * self.radius(),
        }
    }

    fn pen(&self, color: Color32, width: f32) -> ArrowStyle {
        ArrowStyle { color, width, halo: self.palette.pane.gamma_multiply(0.55), is_dashed: false }
    }

    fn name(&mut self, tip: Option<Tip>, symbol: &str, words: Words, color: Color32) {
        let words = if self.picture.is_numbered { words } else { words.without_numbers() };
        if let Some(tip) = tip {
            self.labels.add(symbol, words, color, tip);
        }
    }

    /// An arrow from the centre of gravity, in Earth axes.
    fn arrow(&mut self, along: Point, (color, width): (Color32, f32), (symbol, words): (&str, Words)) {
        let pen = self.pen(color, width);
        let tip = straight(self.painter, &self.lens, pen, Point::zeros(), along);
        self.name(tip, symbol, words, color);
    }

    /// An arc with its value: the angle as drawn, and as it is.
    fn angle(
        &mut self,
        frame: (Point, Point, Point),
        (angle, own): (f64, f64),
        symbol: &str,
        color: Color32,
    ) {
        if angle.abs() < SMALLEST_ANGLE {
            return;
        }
        let pen = self.pen(color, 1.6);
        let tip = arc(self.painter, &self.lens, pen, frame, finite(angle));
        self.name(tip, symbol, Words::Value(degrees(own)), color);
    }

    /// Everything that is chosen.
    pub fn draw(&mut self, overlays: &Overlays) {
        if self.picture.is_turned {
            return self.turned(overlays);
        }
        if overlays.earth_axes {
            self.earth_axes();
        }
        if overlays.angles {
            self.angles();
        }
        if overlays.body_axes {
            self.body_axes();
        }
        if overlays.stability_axes {
            self.stability_axes();
        }
        if overlays.flow {
            self.flow();
        }
        if overlays.forces {
            self.forces();
        }
        if overlays.rates {
            self.rates();
        }
        if overlays.moments {
            self.moments();
        }
    }

    fn body_axes(&mut self) {
        let axes = [(Axis::X, "x"), (Axis::Y, "y"), (Axis::Z, "z")];
        for ((axis, symbol), color) in axes.into_iter().zip(self.palette.axes) {
            self.axis(axis, color, (symbol, Words::None));
        }
    }

    /// A body axis.
    pub(super) fn axis(&mut self, axis: Axis, color: Color32, label: (&str, Words)) {
        let (along, ..) = self.frame(axis);
        self.arrow(along * self.axis_length(axis), (color, 1.8), label);
    }

    /// Around a body axis, at a share of its length, by an angle \[rad\] as the right hand turns.
    pub(super) fn ring(&mut self, axis: Axis, share: f32, angle: f32, color: Color32) -> Option<Tip> {
        let (along, from, to) = self.frame(axis);
        let r = RATE_ARC * self.radius();
        let middle = along * (share * self.axis_length(axis));
        arc(self.painter, &self.lens, self.pen(color, 2.2), (middle, from * r, to * r), angle)
    }

    /// The body axes turned about y until x lies along the steady flight.
    pub(super) fn stability_axes(&mut self) {
        let color = self.palette.velocity;
        let (sin, cos) = finite(self.picture.steady_alpha).sin_cos();
        for (axis, along, symbol) in
            [(Axis::X, Point::new(cos, 0.0, sin), "x_s"), (Axis::Z, Point::new(-sin, 0.0, cos), "z_s")]
        {
            let pen = ArrowStyle { is_dashed: true, ..self.pen(color, 1.8) };
            let along = self.rotation * along * (STABILITY_AXIS * self.axis_length(axis));
            let tip = straight(self.painter, &self.lens, pen, Point::zeros(), along);
            self.name(tip, symbol, Words::None, color);
        }
    }

    pub(super) fn earth_axes(&mut self) {
        let color = self.palette.earth_axes;
        let length = EARTH_AXIS * self.radius();
        let axes = [Point::x(), Point::y(), Point::z()];
        for (axis, symbol) in axes.iter().zip(["x_E", "y_E", "z_E"]) {
            self.arrow(axis * length, (color, 1.4), (symbol, Words::None));
        }
    }

    /// ψ in the level plane, θ in the upright one, φ about the body's x: each in the plane in which it turns.
    pub(super) fn angles(&mut self) {
        let Picture { attitude, figures, .. } = *self.picture;
        let own = figures.attitude;
        let color = self.palette.earth_axes;
        let r = ANGLE_ARC * self.nose();
        let (sin, cos) = finite(attitude.psi).sin_cos();
        let (north, east) = (Point::x(), Point::y());
        let (heading, side) = (north * cos + east * sin, east * cos - north * sin);
        let dashed = ArrowStyle { is_dashed: true, ..self.pen(color, 1.2) };
        if attitude.psi.abs() >= SMALLEST_ANGLE {
            plain(self.painter, &self.lens, dashed, Point::zeros(), north * r);
            self.angle((Point::zeros(), north * r, east * r), (attitude.psi, own.psi), "ψ", color);
        }
        if attitude.theta.abs() >= SMALLEST_ANGLE {
            plain(self.painter, &self.lens, dashed, Point::zeros(), heading * r);
            self.angle(
                (Point::zeros(), heading * r, -Point::z() * r),
                (attitude.theta, own.theta),
                "θ",
                color,
            );
        }
        if attitude.phi.abs() >= SMALLEST_ANGLE {
            // Level to the right, and what stands below it, across the body's x axis.
            let below = (self.rotation * Point::x()).cross(&side);
            plain(self.painter, &self.lens, dashed, Point::zeros(), side * r);
            self.angle((Point::zeros(), side * r, below * r), (attitude.phi, own.phi), "φ", color);
        }
    }

    /// V, its projection into the plane of symmetry, α from the x axis to that and β from that to V.
    fn flow(&mut self) {
        let Picture { alpha, beta, figures, .. } = *self.picture;
        let color = self.palette.velocity;
        let r = VELOCITY * self.nose();
        // V = (cos α cos β, sin β, sin α cos β)
        let (sin, cos) = finite(alpha).sin_cos();
        let in_plane = self.rotation * Point::new(cos, 0.0, sin);
        let (x, z) = (self.rotation * Point::x(), self.rotation * Point::z());
        let y = self.rotation * Point::y();
        let (sin, cos) = finite(beta).sin_cos();
        let velocity = in_plane * cos + y * sin;
        self.arrow(velocity * r, (color, 2.4), ("V", Words::None));
        let arc = FLOW_ARC * self.nose();
        self.angle((Point::zeros(), x * arc, z * arc), (alpha, figures.alpha), "α", color);
        if beta.abs() >= SMALLEST_ANGLE {
            let dashed = ArrowStyle { is_dashed: true, ..self.pen(color, 1.2) };
            plain(self.painter, &self.lens, dashed, Point::zeros(), in_plane * arc);
            self.angle((Point::zeros(), in_plane * arc, y * arc), (beta, figures.beta), "β", color);
        }
    }

    fn forces(&mut self) {
        let unit = WEIGHT * self.radius();
        for ((name, force, size), color) in self.picture.forces.all().into_iter().zip(self.palette.forces) {
            let along = self.rotation * point(force) * unit;
            if along.norm() > 0.01 * unit {
                // In words: L is a rolling moment too, and T a period.
                self.arrow(along, (color, 3.4), ("", Words::Force(name, size)));
            }
        }
    }

    fn rates(&mut self) {
        for (axis, symbol, color) in [
            (Axis::X, "p", self.palette.axes[0]),
            (Axis::Y, "q", self.palette.axes[1]),
            (Axis::Z, "r", self.palette.axes[2]),
        ] {
            let rate = self.picture.rates[axis as usize];
            if rate.abs() < 0.01 * RATE_OF_HALF_A_TURN {
                continue;
            }
            let turn = (rate / RATE_OF_HALF_A_TURN).clamp(-1.8, 1.8) * std::f64::consts::PI;
            let tip = self.ring(axis, RATE_AT, finite(turn), color);
            self.name(tip, symbol, Words::Value(format!("{}/s", degrees(rate))), color);
        }
    }

    /// Around one axis on rings of their own, so that what pushes and what damps can be compared.
    fn moments(&mut self) {
        let mut used = [0.0; 3];
        for moment in self.picture.moments {
            let size = finite(moment.size).clamp(-1.0, 1.0);
            let ring = &mut used[moment.axis as usize];
            let r = (MOMENT_ARC + *ring * MOMENT_STEP) * self.radius();
            *ring += 1.0;
            if size.abs() < 0.01 {
                continue;
            }
            let (_, from, to) = self.frame(moment.axis);
            let pen = self.pen(moment.color, 3.4);
            let tip =
                arc(self.painter, &self.lens, pen, (Point::zeros(), from * r, to * r), FULL_MOMENT * size);
            let about = match moment.axis {
                Axis::X => "roll",
                Axis::Y => "pitch",
                Axis::Z => "yaw",
            };
            self.name(tip, moment.symbol, Words::Name(about), moment.color);
        }
    }

    /// A body axis in Earth axes, where turning about it begins, and where that goes to.
    fn frame(&self, axis: Axis) -> (Point, Point, Point) {
        let [x, y, z] = [Point::x(), Point::y(), Point::z()].map(|axis| self.rotation * axis);
        match axis {
            // Right-handed: y to z, −z … x to −z, x to y.
            Axis::X => (x, y, z),
            Axis::Y => (y, x, -z),
            Axis::Z => (z, x, y),
        }
    }

    /// The path as a ribbon, its parts beyond the aircraft and those on this side of it.
    pub fn path(&self) -> (Mesh, Mesh) {
        let (mut beyond, mut before) = (Mesh::default(), Mesh::default());
        let points: Vec<Point> = self.picture.path.iter().map(|p| self.picture.seen_from_here(*p)).collect();
        let count = points.len().max(2) as f32;
        // It comes out from behind the tail.
        let tail = -self.picture.model.bounds().0.x;
        let depth = self.lens.seen(&Point::zeros()).z;
        let color = self.palette.path;
        // As wide as a hand's breadth of the wing, but never a hair nor a road.
        let least = if self.picture.is_far { 2.0 } else { 0.6 };
        let width = |p: &Point| (0.012 * self.radius() * self.lens.scale_at(p)).clamp(least, 3.0);
        for (k, pair) in points.windows(2).enumerate() {
            let [a, b] = [pair[0], pair[1]];
            if b.norm() < tail && !self.picture.is_far {
                continue;
            }
            let (Some(at_a), Some(at_b)) = (self.lens.project(&a), self.lens.project(&b)) else { continue };
            if !self.pane.expand(50.0).intersects(Rect::from_two_pos(at_a, at_b).expand(1.0))
                || at_a.distance(at_b) < 0.05
            {
                continue;
            }
            // Fresh at the aircraft, faint where it is old.
            let age = |k: usize| {
                let share = if self.picture.is_far { 1.0 } else { k as f32 / count };
                color.gamma_multiply(0.05 + 0.8 * share)
            };
            let mesh = if self.lens.seen(&a).z > depth { &mut beyond } else { &mut before };
            stroke(mesh, [at_a, at_b], width(&a), [age(k), age(k + 1)]);
        }
        (beyond, before)
    }

    /// Four vectors head to tail: in steady flight they close.
    pub fn force_polygon(&self, place: Rect) {
        let forces = self.picture.forces;
        // Seen from the right: x to the right, z downwards, in Earth's upright plane of the heading.
        let attitude = self.rotation;
        let (sin, cos) = finite(self.picture.attitude.psi).sin_cos();
        let flat = |force: [f64; 3]| {
            let f = attitude * point(force);
            Vec2::new(f.x * cos + f.y * sin, f.z)
        };
        let all = [forces.weight, forces.thrust, forces.lift, forces.drag].map(flat);
        let colors = [1, 2, 0, 3].map(|k| self.palette.forces[k]);
        let scale = 0.66 * place.height();
        let mut at = Pos2::new(place.center().x, place.top() + 0.26 * place.height());
        for (force, color) in all.into_iter().zip(colors) {
            let to = at + force * scale;
            self.painter.arrow(at, to - at, egui::Stroke::new(1.8, color));
            at = to;
        }
    }
}
