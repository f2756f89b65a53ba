//! Figures as pictures: as many dots as the page makes of them, with the letters of the page.

use std::sync::Arc;

use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::{Options, Tree, fontdb::Database};

/// The faces: text, titles, and the signs that both lack.
const FACES: [&[u8]; 3] = [
    include_bytes!("../../../assets/fonts/text-regular.ttf"),
    include_bytes!("../../../assets/fonts/text-semibold.ttf"),
    include_bytes!("../../../assets/fonts/signs.ttf"),
];
/// What a figure's last choice of letters, any without serifs, is here.
const FAMILY: &str = "Eigenwing Text";
/// Dots of a picture for one of the drawing's pixels, 1/96 inch: 300 an inch.
const SCALE: f32 = 300.0 / 96.0;

/// A figure as PNG.
pub fn png(svg: &str) -> Result<Vec<u8>, String> {
    let mut faces = Database::new();
    FACES.iter().for_each(|face| faces.load_font_data(face.to_vec()));
    faces.set_sans_serif_family(FAMILY);
    let options = Options { fontdb: Arc::new(faces), ..Options::default() };
    let tree = Tree::from_str(svg, &options).map_err(|error| error.to_string())?;
    let dots = |length: f32| (SCALE * length.round()).round();
    let (width, height) = (dots(tree.size().width()), dots(tree.size().height()));
    let mut picture = Pixmap::new(width as u32, height as u32).ok_or("it is too large")?;
    let scale = Transform::from_scale(width / tree.size().width(), height / tree.size().height());
    resvg::render(&tree, scale, &mut picture.as_mut());
    picture.encode_png().map_err(|error| error.to_string())
}
