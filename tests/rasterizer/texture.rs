//! A texture, such as the atlas of all glyphs.

use egui::epaint::ImageDelta;
use egui::{Color32, Pos2};

/// Premultiplied colours, row by row from the top.
#[derive(Default)]
pub struct Texture {
    width: usize,
    height: usize,
    texels: Vec<Color32>,
}

impl Texture {
    /// Takes a new picture, or a new piece of the picture.
    pub fn change(&mut self, delta: &ImageDelta) {
        let egui::ImageData::Color(piece) = &delta.image;
        let Some([left, top]) = delta.pos else {
            [self.width, self.height] = piece.size;
            self.texels.clone_from(&piece.pixels);
            return;
        };
        for (row, texels) in piece.pixels.chunks_exact(piece.width()).enumerate() {
            let start = (top + row) * self.width + left;
            self.texels[start..start + texels.len()].copy_from_slice(texels);
        }
    }

    /// The colour at a place from (0, 0) to (1, 1), linear between the middles of texels, each channel from 0 to 1.
    pub fn at(&self, uv: Pos2) -> [f32; 4] {
        let (x, along) = between(uv.x, self.width);
        let (y, down) = between(uv.y, self.height);
        let row = |y: usize| mix(self.texel(x[0], y), self.texel(x[1], y), along);
        mix(row(y[0]), row(y[1]), down)
    }

    fn texel(&self, x: usize, y: usize) -> [f32; 4] {
        self.texels[y * self.width + x].to_array().map(|channel| f32::from(channel) / 255.0)
    }
}

/// The texels on both sides of a place, and how far it is from the first to the second, in the steps of most GPUs: so a glyph
/// looks the same wherever it is in its atlas.
fn between(place: f32, count: usize) -> ([usize; 2], f32) {
    const STEPS: f32 = 256.0;
    let last = (count - 1) as f32;
    let at = ((place * count as f32 - 0.5) * STEPS).round() / STEPS;
    let at = at.clamp(0.0, last);
    let first = at.floor();
    ([first as usize, (first + 1.0).min(last) as usize], at - first)
}

fn mix(a: [f32; 4], b: [f32; 4], part: f32) -> [f32; 4] {
    std::array::from_fn(|k| a[k] + (b[k] - a[k]) * part)
}
