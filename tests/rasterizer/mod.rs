//! Draws what egui draws, without a GPU. Every position is brought to a fixed grid and every edge is decided in whole numbers,
//! so that equal shapes give equal pixels, wherever they are drawn.

mod texture;
mod triangle;

use std::cell::RefCell;
use std::collections::{HashMap, HashSet};
use std::rc::Rc;

use egui::epaint::{ClippedPrimitive, Primitive};
use egui::{Context, FullOutput, Mesh, Rect, TextureId, TexturesDelta};
use egui_kittest::TestRenderer;
use image::RgbaImage;

use texture::Texture;
use triangle::{Area, Corner};

/// The renderer of a harness, which gives it its textures; a clone of it draws.
#[derive(Clone, Default)]
pub struct Rasterizer(Rc<RefCell<Textures>>);

#[derive(Default)]
struct Textures {
    all: HashMap<TextureId, Texture>,
    /// No longer needed once the last output has been drawn.
    freed: HashSet<TextureId>,
}

impl TestRenderer for Rasterizer {
    fn handle_delta(&mut self, delta: &mut TexturesDelta) {
        let Textures { all, freed } = &mut *self.0.borrow_mut();
        for id in freed.drain() {
            all.remove(&id);
        }
        for (id, changes) in delta.set.drain() {
            for change in &changes {
                all.entry(id).or_default().change(change);
            }
        }
        freed.extend(delta.free.drain());
    }
}

impl Rasterizer {
    /// The last output as a picture.
    pub fn picture(&self, ctx: &Context, output: &FullOutput) -> Result<RgbaImage, String> {
        let scale = output.pixels_per_point;
        let size = ctx.content_rect().size() * scale;
        let mut image = RgbaImage::new(size.x.round() as u32, size.y.round() as u32);
        for ClippedPrimitive { clip_rect, primitive } in ctx.tessellate(output.shapes.clone(), scale) {
            match primitive {
                Primitive::Mesh(mesh) => self.draw(&mut image, clip_rect, &mesh, scale)?,
                Primitive::Callback(_) => return Err("a paint callback draws with a GPU only".to_owned()),
            }
        }
        Ok(image)
    }

    fn draw(&self, image: &mut RgbaImage, clip: Rect, mesh: &Mesh, scale: f32) -> Result<(), String> {
        let textures = self.0.borrow();
        let texture = textures.all.get(&mesh.texture_id).ok_or("a mesh has a texture that was never set")?;
        if mesh.vertices.iter().any(|vertex| !vertex.pos.is_finite()) {
            // GPUs don't agree on what they make of it.
            return Err("a corner of a triangle is nowhere".to_owned());
        }
        let area = Area::of(clip * scale, image.dimensions());
        for corners in mesh.triangles() {
            let corners = corners.map(|index| Corner::of(&mesh.vertices[index as usize], scale));
            triangle::draw(image, area, corners, texture);
        }
        Ok(())
    }
}
