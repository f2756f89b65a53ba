//! A face: a flat convex polygon with a normal at each corner, and how a plane cuts it.

use nalgebra::Vector3;
use smallvec::SmallVec;

/// A point or a direction.
pub type Point = Vector3<f32>;

/// Material of a face, for its colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Material {
    /// The paint of the airframe.
    Skin,
    /// A stripe on the paint.
    Stripe,
    /// A control surface.
    Control,
    /// Windows.
    Glass,
    /// Engines, struts.
    Metal,
    /// Tyres, intakes, nozzles.
    Dark,
    /// A turning propeller, seen through.
    Disc,
}

impl Material {
    /// The materials of bodies and patches by the name that a file gives them.
    pub const NAMES: [(&'static str, Self); 5] = [
        ("skin", Self::Skin),
        ("stripe", Self::Stripe),
        ("glass", Self::Glass),
        ("metal", Self::Metal),
        ("dark", Self::Dark),
    ];
}

/// A corner of a face.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vertex {
    /// Position \[m\].
    pub position: Point,
    /// Outward direction of the surface there, of unit length, for its light.
    pub normal: Point,
}

/// Corners of a face. Nearly all have three or four, or one more where a plane has cut them; thousands are visited in a frame, and
/// they are found faster where they stand in the face itself.
pub type Corners = SmallVec<[Vertex; 5]>;

/// A flat convex polygon, seen from its outer side.
#[derive(Clone, Debug, PartialEq)]
pub struct Face {
    /// Corners, anticlockwise as seen from outside in right-handed axes.
    pub vertices: Corners,
    /// Outward direction of its plane, of unit length.
    pub normal: Point,
    /// Its material.
    pub material: Material,
    /// Whether it is seen from behind as well.
    pub is_double_sided: bool,
}

/// A plane n·p = d.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Plane {
    pub normal: Point,
    pub offset: f32,
}

/// Closer to a plane than this a point lies in it \[m\].
const ON_PLANE: f32 = 2e-4;

/// A thinner face than this is none \[m²\].
const SMALLEST_AREA: f32 = 1e-7;

/// Side of a plane that a face is on: before it, behind it, or cut by it.
pub(super) enum Side {
    Front(Face),
    Back(Face),
    Both(Face, Face),
}

impl Plane {
    /// Signed distance of a point, positive before the plane \[m\].
    pub fn distance(&self, point: &Point) -> f32 {
        self.normal.dot(point) - self.offset
    }
}

impl Face {
    /// A face through points in order, all with its own normal; `None` where they span no area.
    pub(super) fn flat(points: &[Point], material: Material) -> Option<Self> {
        let normal = unit_normal(points)?;
        let vertices = points.iter().map(|&position| Vertex { position, normal }).collect();
        Some(Self { vertices, normal, material, is_double_sided: false })
    }

    /// A face through vertices in order; `None` where they span no area.
    pub(super) fn smooth(vertices: impl IntoIterator<Item = Vertex>, material: Material) -> Option<Self> {
        let vertices: Corners = vertices.into_iter().collect();
        let points: Vec<Point> = vertices.iter().map(|vertex| vertex.position).collect();
        let normal = unit_normal(&points)?;
        Some(Self { vertices, normal, material, is_double_sided: false })
    }

    pub(super) fn plane(&self) -> Plane {
        let offset = self.vertices.first().map_or(0.0, |vertex| self.normal.dot(&vertex.position));
        Plane { normal: self.normal, offset }
    }

    /// Its corners' mean.
    pub fn middle(&self) -> Point {
        let sum: Point = self.vertices.iter().map(|vertex| vertex.position).sum();
        sum / self.vertices.len().max(1) as f32
    }

    /// Whether an eye sees it.
    pub fn faces(&self, eye: &Point) -> bool {
        self.is_double_sided || self.plane().distance(eye) > 0.0
    }

    /// The same in other places; `map` must keep angles and handedness, and leave out what moves for directions.
    pub(super) fn mapped(
        &self,
        point: impl Fn(&Point) -> Point,
        direction: impl Fn(&Point) -> Point,
    ) -> Self {
        let vertices = self
            .vertices
            .iter()
            .map(|vertex| Vertex { position: point(&vertex.position), normal: direction(&vertex.normal) });
        Self { vertices: vertices.collect(), normal: direction(&self.normal), ..*self }
    }

    /// Its image on the other side of the plane of symmetry.
    pub(super) fn mirrored(&self) -> Self {
        let image = |p: &Point| Point::new(p.x, -p.y, p.z);
        let mut face = self.mapped(image, image);
        face.vertices.reverse();
        face
    }

    /// The same seen from the other side.
    pub(super) fn turned(mut self) -> Self {
        self.vertices.reverse();
        self.normal = -self.normal;
        for vertex in &mut self.vertices {
            vertex.normal = -vertex.normal;
        }
        self
    }

    /// Whether it lies in a plane.
    pub(super) fn is_in(&self, plane: &Plane) -> bool {
        self.vertices.iter().all(|vertex| plane.distance(&vertex.position).abs() <= ON_PLANE)
    }

    /// On which sides of a plane it is: (behind, before). In the plane counts as the side that it faces.
    pub(super) fn sides(&self, plane: &Plane) -> (bool, bool) {
        let distances = self.vertices.iter().map(|vertex| plane.distance(&vertex.position));
        let sides = distances.fold((false, false), |(is_behind, is_before), d| {
            (is_behind || d < -ON_PLANE, is_before || d > ON_PLANE)
        });
        match sides {
            (false, false) => {
                let is_before = self.normal.dot(&plane.normal) >= 0.0;
                (!is_before, is_before)
            }
            sides => sides,
        }
    }

    /// The side of a plane that it is on, cut in two where on both.
    pub(super) fn split(self, plane: &Plane) -> Side {
        match self.sides(plane) {
            (false, _) => return Side::Front(self),
            (true, false) => return Side::Back(self),
            (true, true) => {}
        }
        let (mut front, mut back) = (Corners::new(), Corners::new());
        for (k, a) in self.vertices.iter().enumerate() {
            let b = &self.vertices[(k + 1) % self.vertices.len()];
            let (da, db) = (plane.distance(&a.position), plane.distance(&b.position));
            if da >= -ON_PLANE {
                front.push(*a);
            }
            if da <= ON_PLANE {
                back.push(*a);
            }
            if (da > ON_PLANE && db < -ON_PLANE) || (da < -ON_PLANE && db > ON_PLANE) {
                // p = a + (b − a) dₐ/(dₐ − d_b)
                let t = da / (da - db);
                let normal = a.normal + (b.normal - a.normal) * t;
                let cut = Vertex {
                    position: a.position + (b.position - a.position) * t,
                    normal: normal.try_normalize(1e-6).unwrap_or(self.normal),
                };
                front.push(cut);
                back.push(cut);
            }
        }
        let part = |vertices: Corners| {
            let points: Vec<Point> = vertices.iter().map(|vertex| vertex.position).collect();
            unit_normal(&points).map(|_| Self { vertices, ..self.clone_head() })
        };
        match (part(front), part(back)) {
            (Some(front), Some(back)) => Side::Both(front, back),
            (Some(front), None) => Side::Front(front),
            (None, Some(back)) => Side::Back(back),
            (None, None) => Side::Front(self),
        }
    }

    fn clone_head(&self) -> Self {
        Self { vertices: Corners::new(), ..*self }
    }
}

/// Newell's normal of a polygon, of unit length; `None` where it has no area.
fn unit_normal(points: &[Point]) -> Option<Point> {
    let mut twice_area = Point::zeros();
    let origin = points.first()?;
    for (k, a) in points.iter().enumerate() {
        let b = &points[(k + 1) % points.len()];
        twice_area += (a - origin).cross(&(b - origin));
    }
    twice_area.try_normalize(2.0 * SMALLEST_AREA)
}

/// Faces over a grid of points, row after row, with normals smoothed over neighbours. Columns may close to a ring.
pub(super) fn grid(rows: &[Vec<Point>], is_ring: bool, material: Material) -> Vec<Face> {
    let columns = rows.first().map_or(0, Vec::len);
    let quads = if is_ring { columns } else { columns.saturating_sub(1) };
    let mut normals = vec![vec![Point::zeros(); columns]; rows.len()];
    let corners = |i: usize, j: usize| {
        let k = (j + 1) % columns;
        [(i, j), (i + 1, j), (i + 1, k), (i, k)]
    };
    for i in 0..rows.len().saturating_sub(1) {
        for j in 0..quads {
            let [a, b, c, d] = corners(i, j).map(|(i, j)| rows[i][j]);
            // Its length is twice the area, so that large faces count for more.
            let normal = (c - a).cross(&(d - b));
            for (i, j) in corners(i, j) {
                normals[i][j] += normal;
            }
        }
    }
    let vertex = |(i, j): (usize, usize), fallback: Point| Vertex {
        position: rows[i][j],
        normal: normals[i][j].try_normalize(1e-9).unwrap_or(fallback),
    };
    let mut faces = Vec::new();
    for i in 0..rows.len().saturating_sub(1) {
        for j in 0..quads {
            let at = corners(i, j);
            let [a, b, c, d] = at.map(|(i, j)| rows[i][j]);
            let Some(normal) = (c - a).cross(&(d - b)).try_normalize(2.0 * SMALLEST_AREA) else { continue };
            let [a, b, c, d] = at.map(|corner| vertex(corner, normal));
            let off =
                normal.dot(&(b.position - a.position)).abs() + normal.dot(&(d.position - a.position)).abs();
            if off < ON_PLANE {
                faces.extend(Face::smooth(vec![a, b, c, d], material));
            } else {
                faces.extend(Face::smooth(vec![a, b, c], material));
                faces.extend(Face::smooth(vec![a, c, d], material));
            }
        }
    }
    faces
}

/// Faces of a closed part, turned outwards: its volume is then positive.
pub(super) fn outward(faces: Vec<Face>) -> Vec<Face> {
    // V = ⅙ Σ a·(b × c) over triangles
    let volume: f32 = faces
        .iter()
        .flat_map(|face| face.vertices.windows(2).skip(1).map(move |pair| (face.vertices[0], pair)))
        .map(|(a, pair)| a.position.dot(&pair[0].position.cross(&pair[1].position)))
        .sum();
    if volume < 0.0 { faces.into_iter().map(Face::turned).collect() } else { faces }
}
