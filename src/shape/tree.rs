//! The order in which to draw faces so that nearer ones cover farther ones, exactly, for any eye.
//!
//! Planes part space again and again until each part holds few faces; faces that a plane cuts are cut. From an eye,
//! what lies on the far side of a plane is drawn before what lies on the near side.
//!
//! Source: H. Fuchs, Z.M. Kedem, B.F. Naylor, Computer Graphics (SIGGRAPH) 14:124 (1980).

use super::face::{Face, Plane, Point, Side};

/// More faces than this are parted by a plane across an axis, if one parts them well; fewer by planes of their own.
const FEW: usize = 60;

/// Planes tried at each step.
const CANDIDATES: usize = 12;

/// A cut face counts for as many as these on the wrong side.
const COST_OF_A_CUT: usize = 8;

/// Faces sorted in space.
#[derive(Clone, Debug, Default)]
pub(super) struct Tree(Option<Box<Node>>);

#[derive(Clone, Debug)]
struct Node {
    plane: Plane,
    /// In the plane.
    here: Vec<Face>,
    front: Tree,
    back: Tree,
}

impl Tree {
    /// Sorts faces, cutting where planes need it.
    pub fn new(mut faces: Vec<Face>) -> Self {
        if faces.is_empty() {
            return Self(None);
        }
        let (plane, here) = match across(&faces) {
            Some(plane) => (plane, Vec::new()),
            None => {
                // Taken out, so that the rest is always fewer.
                let face = faces.swap_remove(of_their_own(&faces));
                let plane = face.plane();
                let (here, rest) = faces.into_iter().partition(|face| face.is_in(&plane));
                faces = rest;
                (plane, [vec![face], here].concat())
            }
        };
        let mut node = Node { plane, here, front: Self(None), back: Self(None) };
        let (mut front, mut back) = (Vec::new(), Vec::new());
        for face in faces {
            part(face, &plane, &mut front, &mut back);
        }
        node.front = Self::new(front);
        node.back = Self::new(back);
        Self(Some(Box::new(node)))
    }

    /// Visits every face that an eye may see, the farthest first, and all `loose` ones among them at their
    /// place.
    pub fn back_to_front(&self, eye: &Point, loose: Vec<Face>, visit: &mut impl FnMut(&Face)) {
        let Some(node) = &self.0 else {
            return by_distance(loose, eye, visit);
        };
        let (mut front, mut back) = (Vec::new(), Vec::new());
        for face in loose {
            part(face, &node.plane, &mut front, &mut back);
        }
        let is_before = node.plane.distance(eye) >= 0.0;
        let (far, near) = if is_before { (&node.back, &node.front) } else { (&node.front, &node.back) };
        let (loose_far, loose_near) = if is_before { (back, front) } else { (front, back) };
        far.back_to_front(eye, loose_far, visit);
        for face in node.here.iter().filter(|face| face.faces(eye)) {
            visit(face);
        }
        near.back_to_front(eye, loose_near, visit);
    }

    /// Number of triangles to draw from all sides.
    pub fn triangles(&self) -> usize {
        self.0.as_ref().map_or(0, |node| {
            let here: usize = node.here.iter().map(|face| face.vertices.len() - 2).sum();
            here + node.front.triangles() + node.back.triangles()
        })
    }
}

fn part(face: Face, plane: &Plane, front: &mut Vec<Face>, back: &mut Vec<Face>) {
    match face.split(plane) {
        Side::Front(face) => front.push(face),
        Side::Back(face) => back.push(face),
        Side::Both(before, behind) => {
            front.push(before);
            back.push(behind);
        }
    }
}

fn by_distance(mut faces: Vec<Face>, eye: &Point, visit: &mut impl FnMut(&Face)) {
    let distance = |face: &Face| (face.middle() - eye).norm_squared();
    faces.sort_by(|a, b| distance(b).total_cmp(&distance(a)));
    faces.iter().for_each(visit);
}

/// Cost of parting faces by a plane: the faces that it cuts, and the inequality of the two sides.
fn cost(faces: &[Face], plane: &Plane) -> (usize, usize, usize) {
    let (mut front, mut back) = (0, 0);
    for face in faces {
        let (is_behind, is_before) = face.sides(plane);
        back += usize::from(is_behind);
        front += usize::from(is_before);
    }
    let cut = front + back - faces.len();
    (COST_OF_A_CUT * cut + usize::abs_diff(front, back), front, back)
}

/// The plane across an axis that parts many faces best; `None` where there are few, or none parts them well.
fn across(faces: &[Face]) -> Option<Plane> {
    if faces.len() <= FEW {
        return None;
    }
    let planes = [Point::x(), Point::y(), Point::z()].into_iter().flat_map(|normal| {
        let corners = faces.iter().flat_map(|face| &face.vertices);
        let mut offsets: Vec<f32> = corners.map(|vertex| normal.dot(&vertex.position)).collect();
        offsets.sort_by(f32::total_cmp);
        (1..CANDIDATES)
            .map(|k| Plane { normal, offset: offsets[k * (offsets.len() - 1) / CANDIDATES] })
            .collect::<Vec<_>>()
    });
    planes
        .map(|plane| (plane, cost(faces, &plane)))
        // Both sides must be clearly fewer, so that this ends, and few faces cut.
        .filter(|(_, (_, front, back))| {
            10 * front.max(back) <= 8 * faces.len() && 4 * (front + back) <= 5 * faces.len()
        })
        .min_by_key(|(_, (cost, ..))| *cost)
        .map(|(plane, _)| plane)
}

/// The face whose own plane parts the others best.
fn of_their_own(faces: &[Face]) -> usize {
    let step = faces.len().div_ceil(CANDIDATES);
    (0..faces.len()).step_by(step.max(1)).min_by_key(|&k| cost(faces, &faces[k].plane()).0).unwrap_or(0)
}
