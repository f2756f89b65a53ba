//! Struts, wheels and propellers.

use std::f32::consts::TAU;

use super::face::{Face, Material, Point, grid, outward};
use super::{Propeller, Strut, Wheel};

/// Corners of a tyre and of a propeller's disc.
const WHEEL_SEGMENTS: usize = 14;
const DISC_SEGMENTS: usize = 28;

/// A blade: width over length at root and tip.
const BLADE: (f32, f32) = (0.13, 0.08);

/// The faces of a strut: four sides and two ends.
pub(super) fn strut(strut: &Strut) -> Vec<Face> {
    let along = strut.to - strut.from;
    let fore = (Point::x() - along * (along.x / along.norm_squared().max(1e-9)))
        .try_normalize(1e-3)
        .unwrap_or(Point::z());
    let across = along.cross(&fore).try_normalize(1e-6).unwrap_or(Point::y());
    let (fore, across) = (fore * (0.5 * strut.chord), across * (0.5 * strut.thickness));
    let ring = |end: Point| vec![end + fore, end + across, end - fore, end - across];
    let (from, mut to) = (ring(strut.from), ring(strut.to));
    let mut faces = grid(&[from.clone(), to.clone()], true, Material::Metal);
    to.reverse();
    faces.extend(Face::flat(&from, Material::Metal));
    faces.extend(Face::flat(&to, Material::Metal));
    outward(faces)
}

/// The faces of a wheel: a tyre about an axle across the aircraft.
pub(super) fn wheel(wheel: &Wheel) -> Vec<Face> {
    // (distance from the middle over half the width, radius over that of the wheel)
    let rings = [(-1.0, 0.45), (-1.0, 0.82), (-0.55, 1.0), (0.55, 1.0), (1.0, 0.82), (1.0, 0.45)];
    let rings: Vec<Vec<Point>> = rings
        .iter()
        .map(|&(across, radius)| {
            let (y, r) = (0.5 * wheel.width * across, 0.5 * wheel.diameter * radius);
            circle(WHEEL_SEGMENTS).map(|(sin, cos)| wheel.centre + Point::new(r * cos, y, r * sin)).collect()
        })
        .collect();
    let mut faces = grid(&rings, true, Material::Dark);
    if let [first, .., last] = &rings[..] {
        let mut last = last.clone();
        last.reverse();
        faces.extend(Face::flat(first, Material::Metal));
        faces.extend(Face::flat(&last, Material::Metal));
    }
    outward(faces)
}

fn circle(segments: usize) -> impl DoubleEndedIterator<Item = (f32, f32)> {
    (0..segments).map(move |k| (TAU * k as f32 / segments as f32).sin_cos())
}

/// The faces of a propeller: its disc and its blades, turned by an angle \[rad\].
pub(super) fn propeller(propeller: &Propeller, angle: f32) -> Vec<Face> {
    let radius = 0.5 * propeller.diameter;
    let disc: Vec<Point> =
        circle(DISC_SEGMENTS).map(|(sin, cos)| propeller.hub + radius * Point::new(0.0, sin, cos)).collect();
    let blades = (0..propeller.blades).flat_map(|k| {
        let (sin, cos) = (angle + TAU * f32::from(k) / f32::from(propeller.blades)).sin_cos();
        let (out, across) = (Point::new(0.0, sin, cos), Point::new(0.12, cos, -sin));
        let at = |part: f32, width: f32| propeller.hub + radius * (part * out + width * across);
        let (root, tip) = BLADE;
        let corners = [
            at(0.06, -0.5 * root),
            at(0.7, -0.5 * root),
            at(1.0, -0.4 * tip),
            at(1.0, 0.4 * tip),
            at(0.7, 0.5 * root),
            at(0.06, 0.5 * root),
        ];
        Face::flat(&corners, Material::Dark)
    });
    let seen_through = |face: Face| Face { is_double_sided: true, ..face };
    Face::flat(&disc, Material::Disc).into_iter().chain(blades).map(seen_through).collect()
}
