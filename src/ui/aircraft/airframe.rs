//! The aircraft itself: its faces back to front, lit.

use std::sync::Arc;

use egui::epaint::Vertex;
use egui::{Color32, Mesh, Rect, Ui};
use nalgebra::Rotation3;

use super::camera::Lens;
use super::picture::Picture;
use crate::shape::{Deflections, Face, Finish, Material, Model, Point};
use crate::ui::kept::kept;
use crate::ui::labels::Silhouette;
use crate::ui::theme::Palette;

// Parts of full light: from all around, from the sky above, from the sun.
const AMBIENT: f32 = 0.53;
const FROM_SKY: f32 = 0.17;
const FROM_SUN: f32 = 0.34;
/// The sky's reflection where a surface is seen at a glancing angle.
const REFLECTION: f32 = 0.32;
/// The sun stands so far to the right of the eye \[rad\], and so high over the level.
const SUN: (f32, f32) = (0.3, 1.0);

/// What the triangles follow from: it stays the same in most frames in which nothing is played.
#[derive(Clone, PartialEq)]
struct Key {
    name: String,
    triangles: usize,
    finish: Finish,
    deflections: Deflections,
    propeller_angle: f32,
    rotation: Rotation3<f32>,
    lens: Lens,
    palette: &'static Palette,
    pane: Rect,
}

/// The aircraft as it is drawn.
pub(super) struct Airframe {
    /// Triangles, in the order to draw them.
    pub mesh: Arc<Mesh>,
    /// What of the pane they cover.
    pub silhouette: Arc<Silhouette>,
}

/// The aircraft over a pane; that of the frame before where the picture is the same.
pub(super) fn kept_airframe(
    ui: &Ui,
    pane: Rect,
    picture: &Picture<'_>,
    rotation: &Rotation3<f32>,
    lens: &Lens,
    palette: &'static Palette,
) -> Arc<Airframe> {
    let key = Key {
        name: picture.name.to_owned(),
        triangles: picture.model.triangles(),
        finish: picture.finish,
        deflections: picture.deflections,
        propeller_angle: picture.propeller_angle,
        rotation: *rotation,
        lens: *lens,
        palette,
        pane,
    };
    let pose = (picture.deflections, picture.propeller_angle);
    kept(ui, "airframe", key, || {
        let mesh = mesh(picture.model, picture.finish, pose, rotation, lens, palette);
        Airframe { silhouette: Arc::new(Silhouette::of(&mesh, pane)), mesh: Arc::new(mesh) }
    })
}

fn mesh(
    model: &Model,
    finish: Finish,
    (deflections, propeller_angle): (Deflections, f32),
    rotation: &Rotation3<f32>,
    lens: &Lens,
    palette: &Palette,
) -> Mesh {
    // All in body axes, so that a corner is turned once.
    let to_body = rotation.inverse();
    let eye = to_body * lens.eye;
    let (right, up, forward) = (to_body * lens.right, to_body * lens.up, to_body * lens.forward);
    let light = Light {
        sun: to_body * sun(lens),
        above: to_body * -Point::z(),
        to_eye: -forward,
        sky: channels(palette.sky[1]),
    };
    let mut mesh = Mesh::default();
    // About half of the faces are seen.
    mesh.reserve_triangles(model.triangles() / 2);
    mesh.reserve_vertices(model.triangles());
    model.back_to_front(&eye, deflections, propeller_angle, |face: &Face| {
        let base = palette.airframe(finish, face.material);
        let first = mesh.vertices.len() as u32;
        for corner in &face.vertices {
            let d = corner.position - eye;
            let seen = Point::new(d.dot(&right), d.dot(&up), d.dot(&forward));
            let color = if face.material == Material::Disc {
                base
            } else {
                light.on(base, &corner.normal, face.material)
            };
            mesh.vertices.push(Vertex { pos: lens.on_screen(&seen), uv: egui::epaint::WHITE_UV, color });
        }
        for k in 1..(face.vertices.len() as u32).saturating_sub(1) {
            mesh.add_triangle(first, first + k, first + k + 1);
        }
    });
    mesh
}

/// Direction to the sun in Earth axes: it goes around with the eye, so that the aircraft is well lit from everywhere.
fn sun(lens: &Lens) -> Point {
    let to_eye = Point::new(-lens.right.y, lens.right.x, 0.0);
    let level = to_eye * SUN.0.cos() + lens.right * SUN.0.sin();
    (level - Point::z() * SUN.1).normalize()
}

struct Light {
    sun: Point,
    above: Point,
    to_eye: Point,
    sky: [f32; 3],
}

impl Light {
    fn on(&self, base: Color32, normal: &Point, material: Material) -> Color32 {
        let from_sun = normal.dot(&self.sun).max(0.0);
        let from_sky = 0.5 + 0.5 * normal.dot(&self.above);
        let light = AMBIENT + FROM_SKY * from_sky + FROM_SUN * from_sun;
        let glancing = 1.0 - normal.dot(&self.to_eye).abs();
        let shine = match material {
            Material::Glass => 0.15 + 1.4 * REFLECTION * glancing * glancing * from_sky,
            Material::Dark => 0.0,
            _ => REFLECTION * glancing * glancing * glancing * from_sky,
        };
        let base = channels(base);
        let [r, g, b] = [0, 1, 2].map(|k| {
            let lit = base[k] * light;
            (lit + (self.sky[k] - lit) * shine).clamp(0.0, 255.0) as u8
        });
        Color32::from_rgb(r, g, b)
    }
}

fn channels(color: Color32) -> [f32; 3] {
    let [r, g, b, _] = color.to_array();
    [r, g, b].map(f32::from)
}
