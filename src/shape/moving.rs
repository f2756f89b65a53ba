//! The parts of an aircraft that move, each about its hinge.

use nalgebra::{Rotation3, Unit};

use super::Control;
use super::face::{Face, Point};

/// Positions of the controls \[rad\].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Deflections {
    /// δe: trailing edge down positive, which pitches the nose down.
    pub elevator: f32,
    /// δa: the right aileron up and the left one down positive, which rolls to the right.
    pub aileron: f32,
    /// δr: trailing edge left positive, which turns the nose left.
    pub rudder: f32,
}

/// A part that turns about a hinge.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Moving {
    pub control: Control,
    /// A point of the hinge.
    pub hinge: Point,
    /// Direction of the hinge: turned about it by a positive angle, a trailing edge goes down, or left.
    pub axis: Point,
    pub is_left: bool,
    pub faces: Vec<Face>,
}

impl Moving {
    pub fn mirrored(&self) -> Self {
        let image = |p: &Point| Point::new(p.x, -p.y, p.z);
        Self {
            hinge: image(&self.hinge),
            axis: image(&self.axis),
            is_left: true,
            faces: self.faces.iter().map(Face::mirrored).collect(),
            ..*self
        }
    }

    pub fn placed(&self, cg: [f32; 2]) -> Self {
        let axis = turned(&self.axis);
        // To the right for what moves up and down; down for a rudder.
        let sense = if self.control == Control::Rudder { axis.z } else { axis.y };
        Self {
            hinge: in_body_axes(cg, &self.hinge),
            axis: if sense < 0.0 { -axis } else { axis },
            faces: self.faces.iter().map(|face| face.mapped(|p| in_body_axes(cg, p), turned)).collect(),
            ..*self
        }
    }

    /// Angle by which it turns about its axis \[rad\].
    pub fn angle(&self, deflections: Deflections) -> f32 {
        let Deflections { elevator, aileron, rudder } = deflections;
        // The right aileron goes up where the left one goes down.
        let aileron = if self.is_left { aileron } else { -aileron };
        match self.control {
            Control::Elevator => elevator,
            Control::Aileron => aileron,
            Control::Rudder => rudder,
            Control::Elevon => elevator + aileron,
        }
    }

    pub fn deflected(&self, angle: f32) -> impl Iterator<Item = Face> + '_ {
        let rotation = Rotation3::from_axis_angle(&Unit::new_unchecked(self.axis), angle);
        self.faces.iter().map(move |face| {
            face.mapped(|p| self.hinge + rotation * (p - self.hinge), |direction| rotation * direction)
        })
    }
}

/// From the axes of the drawing to those of the body: half a turn about y.
pub(super) fn in_body_axes(cg: [f32; 2], point: &Point) -> Point {
    turned(&Point::new(point.x - cg[0], point.y, point.z - cg[1]))
}

pub(super) fn turned(direction: &Point) -> Point {
    Point::new(-direction.x, direction.y, -direction.z)
}
