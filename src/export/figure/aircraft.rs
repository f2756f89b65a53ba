//! The aircraft, as its pane shows it at first: from the right, ahead and above.

use maud::{Markup, html};

use super::ink::n;
use super::plot::{LEFT, RIGHT, TOP, WIDTH, document};
use crate::content::shapes::{USUAL_SHAPE, embedded_shape};
use crate::findings::Findings;
use crate::scenario::view::StandardView;
use crate::shape::{Deflections, Face, Finish, Material, Model, Point};

/// Height of the drawing.
const HEIGHT: f64 = 200.0;
/// The eye is so many times the aircraft's size away: as good as infinitely far.
const AWAY: f32 = 200.0;
/// Light from all around, and from the sun.
const LIGHT: [f32; 2] = [0.62, 0.38];

/// The figure of an aircraft; `None` where it has no shape.
pub fn aircraft(findings: &Findings) -> Option<String> {
    let scenario = findings.scenario();
    let aircraft = &scenario.aircraft;
    let drawn = drawing(aircraft.shape, [LEFT, TOP, WIDTH - LEFT - RIGHT, HEIGHT])?;
    let title = format!("{}: {}", aircraft.name, aircraft.condition);
    Some(document(TOP + HEIGHT + 8.0, &title, "", "", &drawn))
}

/// A shape in a frame of left, top, width and height.
pub fn drawing(shape: &str, [left, top, width, height]: [f64; 4]) -> Option<Markup> {
    let shape = embedded_shape(shape).or_else(|| embedded_shape(USUAL_SHAPE))?.ok()?;
    let model = Model::new(&shape);
    let camera = StandardView::ThreeQuarter.camera();
    let ((sin, cos), (high, level)) = (camera.azimuth.sin_cos(), camera.elevation.sin_cos());
    // Body axes: x forward, y right, z down. Azimuth zero is behind the aircraft, a quarter of a turn on its right.
    let to_eye = Point::new(-cos * level, sin * level, -high);
    let right = (-to_eye).cross(&-Point::z()).normalize();
    let up = right.cross(&-to_eye);
    let sun = (to_eye + 1.2 * up - 0.4 * right).normalize();
    let mut faces: Vec<(String, Vec<(f64, f64)>)> = Vec::new();
    let eye = AWAY * model.radius() * to_eye;
    model.back_to_front(&eye, Deflections::default(), 0.0, |face: &Face| {
        let lit = LIGHT[0] + LIGHT[1] * face.normal.dot(&sun).max(0.0);
        let on_paper = |point: &Point| (f64::from(point.dot(&right)), f64::from(-point.dot(&up)));
        let corners = face.vertices.iter().map(|corner| on_paper(&corner.position)).collect();
        faces.push((colour(shape.finish, face.material, lit), corners));
    });
    let ends = faces.iter().flat_map(|(_, corners)| corners).fold(
        [f64::INFINITY, f64::INFINITY, f64::NEG_INFINITY, f64::NEG_INFINITY],
        |[x0, y0, x1, y1], (x, y)| [x0.min(*x), y0.min(*y), x1.max(*x), y1.max(*y)],
    );
    let [x0, y0, x1, y1] = ends;
    let scale = 0.96 * (width / (x1 - x0)).min(height / (y1 - y0));
    let (middle_x, middle_y) = (left + 0.5 * width, top + 0.5 * height);
    let points = |corners: &[(f64, f64)]| {
        let place = |(x, y): &(f64, f64)| {
            let (x, y) = (x - 0.5 * (x0 + x1), y - 0.5 * (y0 + y1));
            format!("{},{}", n(middle_x + scale * x), n(middle_y + scale * y))
        };
        corners.iter().map(place).collect::<Vec<_>>().join(" ")
    };
    Some(html! {
        g stroke-width="0.35" stroke-linejoin="round" {
            @for (colour, corners) in &faces { polygon points=(points(corners)) fill=(colour) stroke=(colour) {} }
        }
    })
}

/// The colour of a face of a material in this light.
fn colour(finish: Finish, material: Material, light: f32) -> String {
    let base: [f32; 3] = match (material, finish) {
        (Material::Skin, Finish::White) => [238.0, 241.0, 245.0],
        (Material::Skin, Finish::Metal) => [200.0, 206.0, 212.0],
        (Material::Skin, Finish::Black) => [86.0, 92.0, 100.0],
        (Material::Skin, Finish::Drab) => [150.0, 158.0, 122.0],
        (Material::Stripe, _) => [44.0, 98.0, 160.0],
        (Material::Control, _) => [242.0, 166.0, 59.0],
        (Material::Glass, _) => [93.0, 134.0, 168.0],
        (Material::Metal, _) => [154.0, 163.0, 172.0],
        (Material::Dark, _) => [58.0, 64.0, 72.0],
        (Material::Disc, _) => [214.0, 219.0, 224.0],
    };
    let light = if material == Material::Disc { 1.0 } else { light };
    let [r, g, b] = base.map(|channel| (channel * light).clamp(0.0, 255.0) as u8);
    format!("#{r:02x}{g:02x}{b:02x}")
}
