//! The faces of an aircraft, sorted for drawing.

use super::face::{Face, Point};
use super::moving::{Deflections, Moving, in_body_axes, turned};
use super::tree::Tree;
use super::{Propeller, Shape, body, fittings, surface};

/// The faces of an aircraft in body axes, from the centre of gravity \[m\].
#[derive(Clone, Debug)]
pub struct Model {
    fixed: Tree,
    moving: Vec<Moving>,
    propellers: Vec<Propeller>,
    /// Number of triangles in all faces but those of propellers.
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
