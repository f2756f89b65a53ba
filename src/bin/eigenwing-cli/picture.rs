//! Figures as pictures: as many dots as the page makes of them.

use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::{Options, Tree};

/// Dots of a picture for one of the drawing's pixels, 1/96 inch: 300 an inch.
const SCALE: f32 = 300.0 / 96.0;

/// A figure as PNG.
pub fn png(svg: &str) -> Result<Vec<u8>, String> {
    let tree = Tree::from_str(svg, &Options::default()).map_err(|error| error.to_string())?;
    let dots = |length: f32| (SCALE * length.round()).round();
    let (width, height) = (dots(tree.size().width()), dots(tree.size().height()));
    let mut picture = Pixmap::new(width as u32, height as u32).ok_or("it is too large")?;
    let scale = Transform::from_scale(width / tree.size().width(), height / tree.size().height());
    resvg::render(&tree, scale, &mut picture.as_mut());
    picture.encode_png().map_err(|error| error.to_string())
}
