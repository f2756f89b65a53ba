//! One triangle: which pixels it covers, and with which colours.

use egui::epaint::Vertex;
use egui::{Pos2, Rect};
use image::{Rgba, RgbaImage};

use super::texture::Texture;

/// Steps of a pixel in which corners are placed, as on most GPUs. Also what a last digit of a sine, different on another machine,
/// disappears in.
const STEPS: i64 = 256;

/// Where may be drawn [pixels]: from the first of each pair to before the second.
#[derive(Clone, Copy)]
pub struct Area {
    x: [i64; 2],
    y: [i64; 2],
}

impl Area {
    /// The part of an image that a clip rectangle \[pixels\] leaves.
    pub fn of(clip: Rect, (width, height): (u32, u32)) -> Self {
        let within = |edge: f32, size: u32| (edge.round() as i64).clamp(0, size.into());
        Self {
            x: [within(clip.left(), width), within(clip.right(), width)],
            y: [within(clip.top(), height), within(clip.bottom(), height)],
        }
    }
}

/// A corner of a triangle.
#[derive(Clone, Copy)]
pub struct Corner {
    /// Steps from the left and from the top.
    x: i64,
    y: i64,
    uv: Pos2,
    /// Premultiplied, each channel from 0 to 1.
    color: [f32; 4],
}

impl Corner {
    /// A vertex of a mesh, its position in points of so many pixels.
    pub fn of(vertex: &Vertex, scale: f32) -> Self {
        let steps = |points: f32| (f64::from(points * scale) * STEPS as f64).round() as i64;
        Self {
            x: steps(vertex.pos.x),
            y: steps(vertex.pos.y),
            uv: vertex.uv,
            color: vertex.color.to_array().map(|channel| f32::from(channel) / 255.0),
        }
    }
}

/// The line from one corner to the next: `x` times `step` plus `start` is positive on the inner side of it, in a row of pixels.
struct Edge {
    step: i64,
    start: i64,
}

impl Edge {
    /// Along the middles of the pixels of row `y`, of a triangle whose corners go around clockwise on screen.
    fn of(a: Corner, b: Corner, y: i64) -> Self {
        let (dx, dy) = (b.x - a.x, b.y - a.y);
        let middle = STEPS / 2;
        // e = (b − a) × (p − a)
        let at_left = dx * (y * STEPS + middle - a.y) - dy * (middle - a.x);
        Self { step: -dy * STEPS, start: at_left }
    }

    fn at(&self, x: i64) -> i64 {
        self.start + x * self.step
    }
}

/// Whether middles of pixels on the line from `a` to `b` belong to the triangle: to one of two neighbours, never both.
fn has_its_edge(a: Corner, b: Corner) -> bool {
    let is_top = a.y == b.y && b.x > a.x;
    let is_left = b.y < a.y;
    is_top || is_left
}

/// Draws over what is in the image.
pub fn draw(image: &mut RgbaImage, area: Area, [a, b, c]: [Corner; 3], texture: &Texture) {
    let double_area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    let corners = match double_area {
        0 => return,
        1.. => [a, b, c],
        _ => [a, c, b],
    };
    let double_area = double_area.abs();
    let [a, b, c] = corners;
    // Each edge is opposite its corner.
    let sides = [(b, c), (c, a), (a, b)];
    let least = sides.map(|(from, to)| if has_its_edge(from, to) { 0 } else { 1 });
    let pixel = |steps: i64| steps.div_euclid(STEPS);
    let [top, bottom] = [a.y.min(b.y).min(c.y), a.y.max(b.y).max(c.y)].map(pixel);
    // Most of a page is plain ground, on which nothing needs to be blended.
    let is_plain = [b, c].iter().all(|corner| corner.uv == a.uv && corner.color == a.color);
    let plain = is_plain.then(|| times(texture.at(a.uv), a.color));
    for y in top.max(area.y[0])..(bottom + 1).min(area.y[1]) {
        let edges = sides.map(|(from, to)| Edge::of(from, to, y));
        let [mut left, mut right] = area.x;
        for (edge, least) in edges.iter().zip(least) {
            // edge.at(x) ≥ least
            let short = least - edge.start;
            match edge.step {
                0 if short > 0 => right = left,
                0 => {}
                1.. => left = left.max(-(-short).div_euclid(edge.step)),
                _ => right = right.min((-short).div_euclid(-edge.step) + 1),
            }
        }
        if let Some([r, g, b, 1.0]) = plain {
            let pixel = Rgba([r, g, b, 1.0].map(byte));
            for x in left..right {
                image.put_pixel(x as u32, y as u32, pixel);
            }
            continue;
        }
        for x in left..right {
            let source = plain.unwrap_or_else(|| {
                let [u, v, w] = edges.each_ref().map(|edge| edge.at(x) as f32 / double_area as f32);
                let uv = a.uv.to_vec2() * u + b.uv.to_vec2() * v + c.uv.to_vec2() * w;
                let color = std::array::from_fn(|k| a.color[k] * u + b.color[k] * v + c.color[k] * w);
                times(texture.at(uv.to_pos2()), color)
            });
            cover(image.get_pixel_mut(x as u32, y as u32), source);
        }
    }
}

fn times(texel: [f32; 4], color: [f32; 4]) -> [f32; 4] {
    std::array::from_fn(|k| texel[k] * color[k])
}

/// Draws a premultiplied colour over a pixel.
fn cover(Rgba(pixel): &mut Rgba<u8>, source: [f32; 4]) {
    let clear = 1.0 - source[3];
    *pixel = std::array::from_fn(|k| byte(source[k] + f32::from(pixel[k]) / 255.0 * clear));
}

fn byte(channel: f32) -> u8 {
    (channel * 255.0).round() as u8
}
