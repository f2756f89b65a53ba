//! The faces of an aircraft, sorted for drawing, and what of it moves.

use nalgebra::{Rotation3, Unit};

use super::face::{Face, Point};
use super::tree::Tree;
use super::{Control, Propeller, Shape, body, fittings, surface};

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

/// The faces of an aircraft in body axes, from the centre of gravity \[m\].
#[derive(Clone, Debug)]
pub struct Model {
    fixed: Tree,
    moving: Vec<Moving>,
    propellers: Vec<Propeller>,
    /// Of all faces but those of propellers.
    triangles: usize,
    cg: [f32; 2],
    /// Least and greatest x, y, z of what is fixed or undeflected \[m\].
    low: Point,
    high: Point,
}

impl Model {
    /// Builds the faces of a shape.
    pub fn new(shape: &Shape) -> Self {
        let length =
            shape.bodies.iter().flat_map(|body| &body.stations).map(|station| station.x).fold(1.0, f32::max);
        let mut fixed = Vec::new();
        let mut moving: Vec<Moving> = Vec::new();
        let mut add = |faces: Vec<Face>, has_twin: bool| {
            if has_twin {
                fixed.extend(faces.iter().map(Face::mirrored));
            }
            fixed.extend(faces);
        };
        for body in &shape.bodies {
            add(body::faces(body, length), body.y != 0.0);
        }
        for surface in &shape.surfaces {
            let (faces, parts) = surface::faces(surface);
            add(faces, surface.is_pair);
            for part in parts {
                if surface.is_pair {
                    moving.push(part.mirrored());
                }
                moving.push(part);
            }
        }
        for strut in &shape.struts {
            add(fittings::strut(strut), strut.from.y != 0.0 || strut.to.y != 0.0);
        }
        for wheel in &shape.wheels {
            add(fittings::wheel(wheel), wheel.centre.y != 0.0);
        }
        let mut propellers = Vec::new();
        for propeller in &shape.propellers {
            propellers.push(*propeller);
            if propeller.hub.y != 0.0 {
                let hub = Point::new(propeller.hub.x, -propeller.hub.y, propeller.hub.z);
                propellers.push(Propeller { hub, ..*propeller });
            }
        }

        let place = |point: &Point| in_body_axes(shape.cg, point);
        let fixed: Vec<Face> = fixed.iter().map(|face| face.mapped(place, turned)).collect();
        let moving: Vec<Moving> = moving.iter().map(|part| part.placed(shape.cg)).collect();
        let mut low = Point::repeat(f32::INFINITY);
        let mut high = -low;
        for face in fixed.iter().chain(moving.iter().flat_map(|part| &part.faces)) {
            for vertex in &face.vertices {
                low = low.inf(&vertex.position);
                high = high.sup(&vertex.position);
            }
        }
        if low.x > high.x {
            (low, high) = (-Point::repeat(0.5), Point::repeat(0.5));
        }
        let fixed = Tree::new(fixed);
        let loose = moving.iter().flat_map(|part| &part.faces).map(|face| face.vertices.len() - 2);
        let triangles = fixed.triangles() + loose.sum::<usize>();
        Self { fixed, moving, propellers, triangles, cg: shape.cg, low, high }
    }

    /// Visits the faces that an eye may see, farthest first; the eye in body axes \[m\].
    pub fn back_to_front(
        &self,
        eye: &Point,
        deflections: Deflections,
        propeller_angle: f32,
        mut visit: impl FnMut(&Face),
    ) {
        let place = |point: &Point| in_body_axes(self.cg, point);
        let discs = self.propellers.iter().flat_map(|propeller| {
            fittings::propeller(propeller, propeller_angle).into_iter().map(|face| face.mapped(place, turned))
        });
        let parts = self.moving.iter().flat_map(|part| part.deflected(part.angle(deflections)));
        let loose = parts.chain(discs).filter(|face| face.faces(eye)).collect();
        self.fixed.back_to_front(eye, loose, &mut visit);
    }

    /// Least and greatest x, y, z in body axes \[m\].
    pub const fn bounds(&self) -> (Point, Point) {
        (self.low, self.high)
    }

    /// Half of the greatest extent \[m\].
    pub fn radius(&self) -> f32 {
        0.5 * (self.high - self.low).amax()
    }

    /// Triangles of all faces, seen or not.
    pub const fn triangles(&self) -> usize {
        self.triangles
    }
}

/// From the axes of the drawing to those of the body: half a turn about y.
fn in_body_axes(cg: [f32; 2], point: &Point) -> Point {
    turned(&Point::new(point.x - cg[0], point.y, point.z - cg[1]))
}

fn turned(direction: &Point) -> Point {
    Point::new(-direction.x, direction.y, -direction.z)
}

impl Moving {
    fn mirrored(&self) -> Self {
        let image = |p: &Point| Point::new(p.x, -p.y, p.z);
        Self {
            hinge: image(&self.hinge),
            axis: image(&self.axis),
            is_left: true,
            faces: self.faces.iter().map(Face::mirrored).collect(),
            ..*self
        }
    }

    fn placed(&self, cg: [f32; 2]) -> Self {
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

    /// How far it turns about its axis \[rad\].
    fn angle(&self, deflections: Deflections) -> f32 {
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

    fn deflected(&self, angle: f32) -> impl Iterator<Item = Face> + '_ {
        let rotation = Rotation3::from_axis_angle(&Unit::new_unchecked(self.axis), angle);
        self.faces.iter().map(move |face| {
            face.mapped(|p| self.hinge + rotation * (p - self.hinge), |direction| rotation * direction)
        })
    }
}
