//! Shapes: every aircraft can be drawn, in the right order, looks like none of the others, and moves its controls the
//! right way.

use eigenwing::content::shapes::{SHAPES, embedded_shape};
use eigenwing::content::{ContentError, embedded_aircraft};
use eigenwing::shape::{Deflections, Face, Material, Model, Point, Shape};
use proptest::prelude::*;
use std::sync::LazyLock;

fn shape(key: &str) -> Shape {
    embedded_shape(key).expect("it ships").expect("it reads")
}

/// All of them, built once.
fn models() -> impl Iterator<Item = (&'static str, &'static Shape, &'static Model)> {
    static MODELS: LazyLock<Vec<(&str, Shape, Model)>> = LazyLock::new(|| {
        let build = |(key, _): &(&'static str, &str)| {
            let shape = shape(key);
            let model = Model::new(&shape);
            (*key, shape, model)
        };
        SHAPES.iter().map(build).collect()
    });
    MODELS.iter().map(|(key, shape, model)| (*key, shape, model))
}

fn model(key: &str) -> &'static Model {
    models().find(|(known, ..)| *known == key).expect("it ships").2
}

/// What an eye sees, the farthest first.
fn seen(model: &Model, eye: Point, deflections: Deflections) -> Vec<Face> {
    let mut faces = Vec::new();
    model.back_to_front(&eye, deflections, 0.3, |face| faces.push(face.clone()));
    faces
}

/// Eyes all around, as far away as a camera is.
fn eyes(model: &Model) -> Vec<Point> {
    let radius = model.radius();
    [
        (1.0, 0.9, -0.6),
        (-1.0, 0.4, -0.3),
        (0.1, 1.2, 0.1),
        (-0.05, 0.1, -1.2),
        (0.7, -0.8, 0.7),
        (-1.1, -0.5, -0.1),
    ]
    .map(|(x, y, z)| Point::new(x, y, z) * (3.0 * radius))
    .to_vec()
}

const SIDE: usize = 128;

/// A picture of `SIDE` × `SIDE`: for each pixel what was last painted there and what is nearest, as depths.
struct Picture {
    painted: Vec<f32>,
    nearest: Vec<f32>,
}

impl Picture {
    fn of(model: &Model, eye: Point) -> Self {
        let forward = -eye.normalize();
        let right = forward.cross(&-Point::z()).try_normalize(1e-3).expect("not from straight above");
        let up = right.cross(&forward);
        let scale = 0.45 * SIDE as f32 * eye.norm() / model.radius() / 1.2;
        let mut picture = Self { painted: vec![f32::MAX; SIDE * SIDE], nearest: vec![f32::MAX; SIDE * SIDE] };
        for face in seen(model, eye, Deflections::default()) {
            if face.material == Material::Disc {
                continue; // seen through
            }
            let corners: Vec<[f32; 3]> = face
                .vertices
                .iter()
                .map(|corner| {
                    let d = corner.position - eye;
                    let depth = d.dot(&forward);
                    let half = 0.5 * SIDE as f32;
                    [half + scale * d.dot(&right) / depth, half - scale * d.dot(&up) / depth, 1.0 / depth]
                })
                .collect();
            for k in 1..corners.len() - 1 {
                picture.fill([corners[0], corners[k], corners[k + 1]]);
            }
        }
        picture
    }

    fn fill(&mut self, [a, b, c]: [[f32; 3]; 3]) {
        let cross = |p: [f32; 3], q: [f32; 3], x: f32, y: f32| {
            (q[0] - p[0]) * (y - p[1]) - (q[1] - p[1]) * (x - p[0])
        };
        let area = cross(a, b, c[0], c[1]);
        if area.abs() < 1e-9 {
            return;
        }
        let within = |low: f32, high: f32| (low.max(0.0) as usize, (high.max(0.0) as usize + 1).min(SIDE));
        let (x0, x1) = within(a[0].min(b[0]).min(c[0]), a[0].max(b[0]).max(c[0]));
        let (y0, y1) = within(a[1].min(b[1]).min(c[1]), a[1].max(b[1]).max(c[1]));
        for row in y0..y1 {
            for column in x0..x1 {
                let (x, y) = (column as f32 + 0.5, row as f32 + 0.5);
                let weights = [cross(b, c, x, y), cross(c, a, x, y), cross(a, b, x, y)].map(|w| w / area);
                if weights.iter().all(|w| *w >= 0.0) {
                    // 1/depth is linear on the screen.
                    let depth = 1.0 / (weights[0] * a[2] + weights[1] * b[2] + weights[2] * c[2]);
                    let at = row * SIDE + column;
                    self.painted[at] = depth;
                    self.nearest[at] = self.nearest[at].min(depth);
                }
            }
        }
    }

    fn covers(&self) -> Vec<bool> {
        self.nearest.iter().map(|depth| *depth < f32::MAX).collect()
    }
}

#[test]
fn every_shape_reads_and_every_aircraft_has_one() {
    let (aircraft, errors) = embedded_aircraft();
    assert!(errors.is_empty(), "{errors:?}");
    for one in &aircraft {
        let shape = shape(one.shape);
        assert_eq!(shape.key, one.shape);
        // The spans agree to the rounding of the sources.
        if let Some(span) = one.particulars.span {
            let drawn = f64::from(shape.span());
            assert!((drawn - span).abs() < 0.005 * span, "{}: {drawn} drawn, {span} in the data", one.key);
        }
    }
    for (key, _) in SHAPES {
        assert!(aircraft.iter().any(|one| one.shape == key), "no aircraft uses {key}");
    }
}

#[test]
fn every_asset_is_in_the_list() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/assets/shapes");
    let mut on_disk: Vec<String> = std::fs::read_dir(folder)
        .expect("the folder is there")
        .filter_map(|entry| entry.ok()?.file_name().into_string().ok())
        .collect();
    let mut listed: Vec<String> = SHAPES.iter().map(|(key, _)| format!("{key}.toml")).collect();
    on_disk.sort();
    listed.sort();
    assert_eq!(on_disk, listed);
}

#[test]
fn the_model_is_as_wide_as_its_shape() {
    for (key, shape, model) in models() {
        let (low, high) = model.bounds();
        // Tanks at the tips stand out.
        let widest = shape.bodies.iter().map(|body| 2.0 * body.y).fold(shape.span(), f32::max);
        assert!((high.y - low.y) >= 0.999 * shape.span(), "{key}");
        assert!((high.y - low.y) <= 1.06 * widest, "{key}");
        assert!((high.y + low.y).abs() < 1e-3, "{key} is not symmetric");
    }
}

#[test]
fn every_face_is_finite_and_a_frame_has_few() {
    for (key, _, model) in models() {
        for eye in eyes(model) {
            let faces = seen(model, eye, Deflections { elevator: 0.3, aileron: -0.2, rudder: 0.2 });
            let corners = faces.iter().flat_map(|face| &face.vertices);
            for corner in corners {
                assert!(corner.position.iter().all(|x| x.is_finite()), "{key}");
                assert!((corner.normal.norm() - 1.0).abs() < 1e-3, "{key}");
            }
            let triangles: usize = faces.iter().map(|face| face.vertices.len() - 2).sum();
            assert!((300..=6000).contains(&triangles), "{key}: {triangles} triangles");
        }
    }
}

/// Of a closed body as much is seen from one side as from the other: ∮ n dA = 0.
#[test]
fn nothing_has_a_hole() {
    for (key, _, model) in models() {
        for axis in [Point::x(), Point::y(), Point::z()] {
            let area_from = |side: f32| -> f32 {
                seen(model, axis * (side * 1e5), Deflections::default())
                    .iter()
                    .map(|face| {
                        let [a, rest @ ..] = &face.vertices[..] else { return 0.0 };
                        rest.windows(2)
                            .map(|pair| {
                                let (b, c) = (pair[0].position - a.position, pair[1].position - a.position);
                                0.5 * b.cross(&c).dot(&axis).abs()
                            })
                            .sum()
                    })
                    .sum()
            };
            let (one, other) = (area_from(1.0), area_from(-1.0));
            // Faces on edge to the eye count on neither side: 1 %.
            assert!((one - other).abs() < 0.01 * one.max(other), "{key} {axis:?}: {one} and {other} m²");
        }
    }
}

/// The order of drawing against a depth buffer.
#[test]
fn what_is_painted_last_is_nearest() {
    for (key, _, model) in models() {
        for eye in eyes(model) {
            let picture = Picture::of(model, eye);
            let tolerance = 0.01 * model.radius();
            let covered = picture.covers().iter().filter(|covered| **covered).count();
            let wrong =
                picture.painted.iter().zip(&picture.nearest).filter(|(p, n)| **p - **n > tolerance).count();
            assert!(covered > 300, "{key}: {covered} pixels");
            // A pixel in a few hundred may lie on a cut edge.
            assert!(wrong * 300 <= covered, "{key} from {eye:?}: {wrong} of {covered} pixels");
        }
    }
}

#[test]
fn the_left_is_the_mirror_image_of_the_right() {
    for (key, _, model) in models() {
        let eye = Point::new(1.0, 0.0, -0.5) * (4.0 * model.radius());
        let covers = Picture::of(model, eye).covers();
        let differing = (0..SIDE * SIDE)
            .filter(|at| {
                let (row, column) = (at / SIDE, at % SIDE);
                covers[*at] != covers[row * SIDE + SIDE - 1 - column]
            })
            .count();
        // Blades of a propeller aren't symmetric.
        let covered = covers.iter().filter(|covered| **covered).count();
        assert!(differing * 25 <= covered, "{key}: {differing} of {covered}");
    }
}

#[test]
fn no_two_aircraft_have_the_same_outline() {
    let outlines: Vec<(&str, Vec<bool>)> = models()
        .map(|(key, _, model)| {
            let eye = Point::new(0.55, 0.8, -0.3) * (4.0 * model.radius());
            (key, Picture::of(model, eye).covers())
        })
        .collect();
    for (k, (key, one)) in outlines.iter().enumerate() {
        for (other_key, other) in &outlines[..k] {
            let count =
                |of: fn(bool, bool) -> bool| one.iter().zip(other).filter(|(a, b)| of(**a, **b)).count();
            let (differing, covered) = (count(|a, b| a != b), count(|a, b| a || b));
            let part = differing as f32 / covered as f32;
            // As large on the screen as each other, they share less than four fifths.
            assert!(part > 0.2, "{key} and {other_key} differ in {part:.2} of their outlines");
        }
    }
}

/// The rearmost corner of what moves, among those that `keep` keeps, wherever it is seen from.
fn rearmost(model: &Model, deflections: Deflections, keep: impl Fn(&Point) -> bool) -> Point {
    let controls = eyes(model)
        .into_iter()
        .flat_map(|eye| seen(model, eye, deflections))
        .filter(|face| face.material == Material::Control);
    controls
        .flat_map(|face| face.vertices.into_iter().map(|corner| corner.position))
        .filter(keep)
        .min_by(|a, b| a.x.total_cmp(&b.x))
        .expect("a control is there")
}

const STILL: Deflections = Deflections { elevator: 0.0, aileron: 0.0, rudder: 0.0 };

#[test]
fn controls_move_as_their_signs_say() {
    let model = model("navion");
    let tail = |p: &Point| p.x < -3.5 && p.y > 0.25;
    let fin = |p: &Point| p.x < -3.5 && p.y.abs() < 0.4 && p.z < -0.9;
    let wing = |side: f32| move |p: &Point| p.x > -2.0 && side * p.y > 2.0;
    // Axes: z down, y right. The chord behind the hinge is 0.3 m and more.
    let moved = |to: Deflections, keep: &dyn Fn(&Point) -> bool| {
        rearmost(model, to, keep) - rearmost(model, STILL, keep)
    };
    let elevator = Deflections { elevator: 0.3, ..STILL };
    assert!(moved(elevator, &tail).z > 0.05, "δe > 0: trailing edge down");
    let rudder = Deflections { rudder: 0.3, ..STILL };
    assert!(moved(rudder, &fin).y < -0.05, "δr > 0: trailing edge left");
    let aileron = Deflections { aileron: 0.3, ..STILL };
    assert!(moved(aileron, &wing(1.0)).z < -0.05, "δa > 0: right aileron up");
    assert!(moved(aileron, &wing(-1.0)).z > 0.05, "δa > 0: left aileron down");
}

#[test]
fn the_tail_of_the_x15_pitches_and_rolls() {
    let model = model("x15");
    let moved = |to: Deflections, side: f32| {
        let keep = |p: &Point| side * p.y > 1.2;
        (rearmost(model, to, keep) - rearmost(model, STILL, keep)).z
    };
    let (pitch, roll) = (Deflections { elevator: 0.3, ..STILL }, Deflections { aileron: 0.3, ..STILL });
    assert!(moved(pitch, 1.0) > 0.05 && moved(pitch, -1.0) > 0.05, "together in pitch");
    assert!(moved(roll, 1.0) < -0.05 && moved(roll, -1.0) > 0.05, "against each other in roll");
}

fn error(text: &str) -> ContentError {
    Shape::from_toml("mine.toml", text).expect_err("it must not read")
}

#[test]
fn a_malformed_shape_names_file_line_field_and_what_was_expected() {
    let text = SHAPES.iter().find(|(key, _)| *key == "navion").expect("it ships").1;
    for (from, to, words) in [
        ("finish = \"metal\"", "finish = \"gold\"", "finish: expected \"white\" or \"metal\""),
        ("cg = [2.75, -0.05]", "cg = [2.75]", "cg: expected 2 numbers, found 1"),
        ("cg = [2.75, -0.05]", "cg = [275.0, 0.0]", "cg: expected metres, at most 120, found 275"),
        (
            "[0.0, 0.0, 0.0, 0.0], [0.1,",
            "[0.2, 0.0, 0.0, 0.0], [0.1,",
            "body.stations: expected at least two rows, from front",
        ),
        (
            "[0.1, 0.24, 0.24, 0.0]",
            "[0.1, 0.24, 0.24]",
            "body.stations: expected rows of x, width, height, z, found a row of 3",
        ),
        ("[0.1, 0.24, 0.24, 0.0]", "[0.1, -0.24, 0.24, 0.0]", "body.stations: expected no negative width"),
        ("square = 2.5", "square = 25", "body.square: expected a number from 1 to 8"),
        ("rounding = 0.35", "rounded = 0.35", "surface.rounded: not a field of this table"),
        ("kind = \"single\"", "kind = \"one\"", "surface.kind: expected \"pair\" or \"single\""),
        ("2.3, 0.15]", "-2.3, 0.15]", "surface.sections: expected a chord above 0.01 m"),
        ("aileron = [[0.6,", "aileron = [[0.96,", "surface.aileron: expected fractions"),
        ("2.1, 2]]", "2.1, 2.5]]", "propellers: expected a positive diameter and 1 to 6 blades"),
    ] {
        assert!(text.contains(from), "{from}");
        let message = error(&text.replacen(from, to, 1)).to_string();
        assert!(message.starts_with("mine.toml, line "), "{message}");
        assert!(message.contains(words), "{message}\nshould say\n{words}");
    }
}

fn check(text: &str) {
    if let Ok(shape) = Shape::from_toml("mutated.toml", text) {
        let model = Model::new(&shape);
        let (low, high) = model.bounds();
        assert!(low.iter().chain(&high).all(|x| x.is_finite()));
        assert!(model.radius() > 0.0);
        let faces = seen(&model, Point::new(1.0, 2.0, -1.0) * 50.0, Deflections::default());
        assert!(
            faces.iter().flat_map(|face| &face.vertices).all(|v| v.position.iter().all(|x| x.is_finite()))
        );
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(8))]

    #[test]
    fn no_changed_digit_makes_a_panic(file in 0..SHAPES.len(), at: prop::sample::Index, byte in "[-0-9e.]") {
        let mut bytes = SHAPES[file].1.as_bytes().to_vec();
        let digits: Vec<usize> = (0..bytes.len()).filter(|&i| bytes[i].is_ascii_digit()).collect();
        bytes[digits[at.index(digits.len())]] = byte.as_bytes()[0];
        check(&String::from_utf8_lossy(&bytes));
    }

    #[test]
    fn no_missing_end_makes_a_panic(file in 0..SHAPES.len(), at: prop::sample::Index) {
        let bytes = SHAPES[file].1.as_bytes();
        check(&String::from_utf8_lossy(&bytes[..at.index(bytes.len())]));
    }
}

#[test]
fn a_shape_with_next_to_nothing_in_it_is_drawn_as_such() {
    let mut shape = shape("trainer");
    for surface in &mut shape.surfaces {
        surface.sections.truncate(1);
    }
    for body in &mut shape.bodies {
        body.stations.truncate(1);
    }
    let (low, high) = Model::new(&shape).bounds();
    assert!(low.iter().chain(&high).all(|x| x.is_finite()));
    (shape.bodies, shape.surfaces) = (Vec::new(), Vec::new());
    (shape.struts, shape.wheels, shape.propellers) = (Vec::new(), Vec::new(), Vec::new());
    assert!(Model::new(&shape).radius() > 0.0);
}
