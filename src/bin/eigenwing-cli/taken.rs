//! What is taken along of a scene: printed, or written into a file; a figure also as a picture.

use std::io::IsTerminal as _;
use std::path::Path;

use eigenwing::export::{self, DisturbanceRequest, Scene, Target};
use eigenwing::key::Keyed as _;

use crate::input::{self, InputError};
use crate::picture;

/// What is to be printed: nothing where it went into a file.
pub fn take(
    wanted: &str,
    scene: &Scene,
    request: &DisturbanceRequest,
    output: Option<&Path>,
) -> Result<Vec<u8>, InputError> {
    let figure = figure_of(wanted);
    let taken = export::take_along(scene, figure.unwrap_or(wanted), request)?;
    // Those of the link have been said.
    taken.notices.iter().skip(scene.notices.len()).for_each(|notice| eprintln!("note: {notice}"));
    let into_picture = output.filter(|path| path.extension().is_some_and(|ending| ending == "png"));
    let content = match into_picture {
        Some(path) if taken.media_type != SVG => {
            return Err(InputError::NoPicture { path: path.to_owned(), kind: taken.media_type });
        }
        None if figure.is_none() => taken.text.into_bytes(),
        _ => picture::png(&taken.text).map_err(InputError::Picture)?,
    };
    match output {
        Some(path) => input::write(path, content).map(|()| Vec::new()),
        None if figure.is_some() && std::io::stdout().is_terminal() => {
            Err(InputError::OnTerminal { file: taken.file.replace(".svg", ".png") })
        }
        None => Ok(content),
    }
}

/// The media type of figures.
const SVG: &str = "image/svg+xml";

/// Key of the figure that a target wants as a picture: `poles-png`.
fn figure_of(wanted: &str) -> Option<&'static str> {
    let name = wanted.strip_suffix("-png")?;
    Target::by_key(&format!("{name}-figure")).map(|target| target.key())
}
