//! Sky and ground: a level horizon, and fields that pass below as fast as the aircraft flies.

use std::sync::Arc;

use egui::{Color32, Context, Mesh, Pos2, Rect, lerp};

use super::camera::Lens;
use crate::shape::Point;
use crate::ui::kept::kept;
use crate::ui::theme::Palette;

/// How many fields can be seen in each direction.
const FIELDS: i32 = 22;
/// Height over the ground, in fields.
const HEIGHT: f32 = 2.2;
/// Points over which the sky pales towards the horizon, over the height of the pane; the ground likewise.
const PALING: f32 = 0.75;

/// What the ground looks like from here.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Ground {
    /// Side of a field \[m\].
    pub field: f32,
    /// Place of the aircraft: north and east, in fields.
    pub place: [f64; 2],
    /// Height of the aircraft above it \[m\].
    pub height: f32,
}

impl Ground {
    /// Below an aircraft of a radius \[m\] and a speed \[m/s\], at a place \[m\], so much above steady flight \[m\].
    pub fn below(radius: f32, speed: f32, place: [f64; 2], climbed: f32) -> Self {
        // So large that no more than two or three pass in a second.
        let field = (6.0 * radius).max(0.4 * speed);
        let steady = HEIGHT * field;
        // True near steady flight, and always above the ground.
        let height = if climbed >= 0.0 { steady + climbed } else { steady / (1.0 - climbed / steady) };
        Self { field, place: place.map(|x| x / f64::from(field)), height }
    }
}

/// Sky and ground of a pane, as triangles; those of the frame before where it looks the same.
pub(super) fn kept_mesh(
    ctx: &Context,
    pane: Rect,
    lens: &Lens,
    ground: &Ground,
    palette: &'static Palette,
) -> Arc<Mesh> {
    kept(ctx, "landscape", (pane, *lens, *ground, palette), || mesh(pane, lens, ground, palette))
}

fn mesh(pane: Rect, lens: &Lens, ground: &Ground, palette: &Palette) -> Mesh {
    let mut mesh = Mesh::default();
    let horizon = lens.horizon();
    let fade = PALING * pane.height();
    let limit = horizon.clamp(pane.top(), pane.bottom());
    bands(&mut mesh, pane, (pane.top(), limit), |y| {
        mixed(palette.sky[1], palette.sky[0], (horizon - y) / fade)
    });
    bands(&mut mesh, pane, (limit, pane.bottom()), |y| {
        mixed(palette.ground[1], palette.ground[0], (y - horizon) / (0.6 * fade))
    });
    fields(&mut mesh, pane, lens, ground, palette);
    lines(&mut mesh, pane, lens, ground, palette);
    mesh
}

fn mixed(from: Color32, to: Color32, t: f32) -> Color32 {
    from.lerp_to_gamma(to, t.clamp(0.0, 1.0).sqrt())
}

/// A gradient from top to bottom.
fn bands(mesh: &mut Mesh, pane: Rect, (top, bottom): (f32, f32), color: impl Fn(f32) -> Color32) {
    const BANDS: usize = 8;
    if bottom <= top {
        return;
    }
    let first = mesh.vertices.len() as u32;
    for k in 0..=BANDS {
        let y = lerp(top..=bottom, k as f32 / BANDS as f32);
        mesh.colored_vertex(Pos2::new(pane.left(), y), color(y));
        mesh.colored_vertex(Pos2::new(pane.right(), y), color(y));
    }
    for k in 0..BANDS as u32 {
        let a = first + 2 * k;
        mesh.add_triangle(a, a + 1, a + 2);
        mesh.add_triangle(a + 1, a + 3, a + 2);
    }
}

impl Ground {
    /// A corner of fields, counted from the one below the aircraft, in Earth axes from the aircraft \[m\].
    fn corner(&self, i: i32, j: i32) -> Point {
        let part = self.place.map(|x| (x - x.floor()) as f32);
        Point::new((i as f32 - part[0]) * self.field, (j as f32 - part[1]) * self.field, self.height)
    }

    /// How clearly something on it is seen: 1 near, 0 as far as fields go.
    fn clearness(&self, p: &Point) -> f32 {
        let far = p.xy().norm() / (self.field * FIELDS as f32);
        (1.0 - far).clamp(0.0, 1.0).powi(2)
    }
}

/// Some fields are darker: which ones is always the same.
fn is_dark(i: i64, j: i64) -> u8 {
    let mut h = (i.wrapping_mul(0x9E37_79B9) ^ j.wrapping_mul(0x85EB_CA6B)) as u32;
    h ^= h >> 15;
    h = h.wrapping_mul(0x2C1B_3C6D);
    h ^= h >> 12;
    match h % 8 {
        0 => 2,
        1 | 2 => 1,
        _ => 0,
    }
}

fn fields(mesh: &mut Mesh, pane: Rect, lens: &Lens, ground: &Ground, palette: &Palette) {
    let near = 0.02 * ground.height;
    let [north, east] = ground.place.map(|x| x.floor() as i64);
    for i in -FIELDS..FIELDS {
        for j in -FIELDS..FIELDS {
            let shade = is_dark(north.wrapping_add(i64::from(i)), east.wrapping_add(i64::from(j)));
            if shade == 0 {
                continue;
            }
            let corners = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)].map(|(i, j)| ground.corner(i, j));
            let seen = corners.map(|corner| lens.seen(&corner));
            if seen.iter().any(|p| p.z < near) {
                continue;
            }
            let places = seen.map(|seen| lens.on_screen(&seen));
            let strength = if shade == 2 { 0.8 } else { 0.4 };
            let colors = corners
                .map(|corner| palette.field_on_ground.gamma_multiply(strength * ground.clearness(&corner)));
            if !pane.intersects(Rect::from_points(&places)) || colors == [Color32::TRANSPARENT; 4] {
                continue;
            }
            let first = mesh.vertices.len() as u32;
            for (place, color) in places.into_iter().zip(colors) {
                mesh.colored_vertex(place, color);
            }
            mesh.add_triangle(first, first + 1, first + 2);
            mesh.add_triangle(first, first + 2, first + 3);
        }
    }
}

fn lines(mesh: &mut Mesh, pane: Rect, lens: &Lens, ground: &Ground, palette: &Palette) {
    const PIECE: i32 = 4;
    let near = 0.02 * ground.height;
    let mut piece = |a: Point, b: Point| {
        let (mut seen_a, mut seen_b) = (lens.seen(&a), lens.seen(&b));
        if seen_a.z < near && seen_b.z < near {
            return;
        }
        // Cut before the eye.
        if seen_a.z < near {
            seen_a += (seen_b - seen_a) * ((near - seen_a.z) / (seen_b.z - seen_a.z));
        }
        if seen_b.z < near {
            seen_b += (seen_a - seen_b) * ((near - seen_b.z) / (seen_a.z - seen_b.z));
        }
        let at = [lens.on_screen(&seen_a), lens.on_screen(&seen_b)];
        if !pane.intersects(Rect::from_two_pos(at[0], at[1])) {
            return;
        }
        let color = [a, b].map(|p| palette.line_on_ground.gamma_multiply(0.75 * ground.clearness(&p)));
        if color != [Color32::TRANSPARENT; 2] {
            stroke(mesh, at, 0.6, color);
        }
    };
    for i in -FIELDS..=FIELDS {
        for j in (-FIELDS..FIELDS).step_by(PIECE as usize) {
            piece(ground.corner(i, j), ground.corner(i, j + PIECE));
            piece(ground.corner(j, i), ground.corner(j + PIECE, i));
        }
    }
}

/// A soft-edged line whose colour changes along it.
pub(super) fn stroke(mesh: &mut Mesh, at: [Pos2; 2], half_width: f32, color: [Color32; 2]) {
    let across = (at[1] - at[0]).normalized().rot90();
    let first = mesh.vertices.len() as u32;
    for (at, color) in at.into_iter().zip(color) {
        for (offset, color) in [
            (-half_width - 0.7, Color32::TRANSPARENT),
            (-half_width, color),
            (half_width, color),
            (half_width + 0.7, Color32::TRANSPARENT),
        ] {
            mesh.colored_vertex(at + across * offset, color);
        }
    }
    for k in 0..3 {
        let a = first + k;
        mesh.add_triangle(a, a + 1, a + 4);
        mesh.add_triangle(a + 1, a + 5, a + 4);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_ground_is_farther_below_the_higher_and_never_above() {
        let height = |climbed: f32| Ground::below(5.0, 50.0, [0.0, 0.0], climbed).height;
        let heights = [-1e6, -1000.0, -10.0, 0.0, 10.0, 1000.0, 1e6].map(height);
        assert!(heights[0] > 0.0);
        assert!(heights.windows(2).all(|pair| pair[0] < pair[1]), "{heights:?}");
        // True to scale near steady flight.
        assert!((height(1.0) - height(0.0) - 1.0).abs() < 1e-3);
        assert!((height(0.0) - height(-1.0) - 1.0).abs() < 0.02);
    }
}
