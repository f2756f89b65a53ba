//! The form of a shape file: an aircraft's geometry in metres, as on a drawing.

use super::reader::{Block, ContentError, with_file};
use crate::shape::{
    Body, Control, ControlSpan, Finish, Material, Patch, Point, Profile, Propeller, Section, Shape, Station,
    Strut, Surface, Wheel,
};

/// No aircraft is larger than this \[m\].
const LARGEST: f64 = 120.0;

/// More rows than this are a mistake, and slow to draw.
const MOST_ROWS: usize = 40;

impl Shape {
    /// Reads a shape from TOML text; `file` is its name for messages.
    pub fn from_toml(file: &str, text: &str) -> Result<Self, ContentError> {
        with_file(file, text, read)
    }
}

fn read(file: &mut Block<'_>) -> Result<Shape, ContentError> {
    let (key, name) = (file.text("key")?, file.text("name")?);
    file.text("note")?;
    let finish = file.choice("finish", &Finish::NAMES)?;
    let [x, z] = file.row::<2>("cg")?;
    let cg = [within(file, "cg", x)?, within(file, "cg", z)?];
    let struts = rows(file, "struts", "rows of x, y, z, x, y, z, chord, thickness")?
        .into_iter()
        .map(|[a, b, c, d, e, f, chord, thickness]| {
            let (from, to) = (Point::new(a, b, c), Point::new(d, e, f));
            (chord > 0.0 && thickness > 0.0 && (to - from).norm() > 0.01)
                .then_some(Strut { from, to, chord, thickness })
                .ok_or_else(|| {
                    file.error("struts", "expected two different ends, and a positive chord and thickness")
                })
        })
        .collect::<Result<_, _>>()?;
    let wheels = rows(file, "wheels", "rows of x, y, z, diameter, width")?
        .into_iter()
        .map(|[x, y, z, diameter, width]| {
            (diameter > 0.0 && width > 0.0)
                .then_some(Wheel { centre: Point::new(x, y, z), diameter, width })
                .ok_or_else(|| file.error("wheels", "expected a positive diameter and width"))
        })
        .collect::<Result<_, _>>()?;
    let propellers = rows(file, "propellers", "rows of x, y, z, diameter, blades")?
        .into_iter()
        .map(|[x, y, z, diameter, blades]| {
            (diameter > 0.0 && blades.fract() == 0.0 && (1.0..=6.0).contains(&blades))
                // Between one and six.
                .then_some(Propeller { hub: Point::new(x, y, z), diameter, blades: blades as u8 })
                .ok_or_else(|| file.error("propellers", "expected a positive diameter and 1 to 6 blades"))
        })
        .collect::<Result<_, _>>()?;
    let bodies = limited(file, "body")?.into_iter().map(read_body).collect::<Result<_, _>>()?;
    let surfaces: Vec<Surface> =
        limited(file, "surface")?.into_iter().map(read_surface).collect::<Result<_, _>>()?;
    let shape = Shape { key, name, finish, cg, bodies, surfaces, struts, wheels, propellers };
    if shape.span() <= 0.0 {
        return Err(file.error("surface", "expected at least one pair, the wing"));
    }
    file.finish()?;
    Ok(shape)
}

fn limited<'t>(file: &mut Block<'t>, key: &'t str) -> Result<Vec<Block<'t>>, ContentError> {
    let blocks = file.blocks(key)?;
    match blocks.len() {
        0..=MOST_ROWS => Ok(blocks),
        found => Err(file.error(key, format_args!("expected at most {MOST_ROWS}, found {found}"))),
    }
}

fn within(block: &Block<'_>, key: &str, number: f64) -> Result<f32, ContentError> {
    if number.abs() <= LARGEST {
        Ok(number as f32)
    } else {
        Err(block.error(key, format_args!("expected metres, at most {LARGEST}, found {number}")))
    }
}

/// Rows of N numbers of a sensible size; none where the key is missing.
fn rows<'t, const N: usize>(
    block: &mut Block<'t>,
    key: &'t str,
    expected: &str,
) -> Result<Vec<[f32; N]>, ContentError> {
    let rows = block.optional_rows::<N>(key, expected)?.unwrap_or_default();
    if rows.len() > MOST_ROWS {
        let found = rows.len();
        return Err(block.error(key, format_args!("expected at most {MOST_ROWS} rows, found {found}")));
    }
    let mut checked = Vec::with_capacity(rows.len());
    for row in rows {
        let mut numbers = [0.0; N];
        for (number, found) in numbers.iter_mut().zip(row) {
            *number = within(block, key, found)?;
        }
        checked.push(numbers);
    }
    Ok(checked)
}

fn optional(block: &mut Block<'_>, key: &'static str, otherwise: f64) -> Result<f32, ContentError> {
    let number = block.optional_number(key)?.unwrap_or(otherwise);
    within(block, key, number)
}

fn read_body(mut block: Block<'_>) -> Result<Body, ContentError> {
    let material = block.optional_choice("material", &Material::NAMES)?.unwrap_or(Material::Skin);
    let y = optional(&mut block, "y", 0.0)?;
    let squareness = optional(&mut block, "square", 2.0)?;
    if !(1.0..=8.0).contains(&squareness) {
        return Err(block.error("square", "expected a number from 1 to 8; 2 is an ellipse"));
    }
    let front = block.optional_choice("front", &[("closed", false), ("intake", true)])?;
    let stations: Vec<Station> = rows(&mut block, "stations", "rows of x, width, height, z")?
        .into_iter()
        .map(|[x, width, height, z]| Station { x, width, height, z })
        .collect();
    if stations.len() < 2 || !stations.windows(2).all(|pair| pair[0].x + 0.005 <= pair[1].x) {
        return Err(block.error("stations", "expected at least two rows, from front to back"));
    }
    if stations.iter().any(|station| station.width < 0.0 || station.height < 0.0) {
        return Err(block.error("stations", "expected no negative width or height"));
    }
    let mut patches = Vec::new();
    for (key, material) in Material::NAMES {
        for [x0, x1, z0, z1] in rows(&mut block, key, "rows of x from, x to, z from, z to")? {
            if !(x0 < x1 && z0 < z1) {
                return Err(block.error(key, "expected each range from less to more"));
            }
            patches.push(Patch { material, x: [x0, x1], z: [z0, z1] });
        }
    }
    block.finish()?;
    Ok(Body { material, y, squareness, is_open: front.unwrap_or(false), stations, patches })
}

fn read_surface(mut block: Block<'_>) -> Result<Surface, ContentError> {
    let is_pair = block.choice("kind", &[("pair", true), ("single", false)])?;
    let profile = block.optional_choice("profile", &[("wing", Profile::Wing), ("wedge", Profile::Wedge)])?;
    let incidence = optional(&mut block, "incidence_deg", 0.0)?;
    if incidence.abs() > 20.0 {
        return Err(block.error("incidence_deg", "expected an angle between −20° and 20°"));
    }
    let rounding = optional(&mut block, "rounding", 0.0)?;
    if rounding < 0.0 {
        return Err(block.error("rounding", "expected no negative length"));
    }
    let sections: Vec<Section> = rows(&mut block, "sections", "rows of x, y, z, chord, thickness")?
        .into_iter()
        .map(|[x, y, z, chord, thickness]| Section { leading_edge: Point::new(x, y, z), chord, thickness })
        .collect();
    let parts = |pair: &[Section]| {
        let along = pair[1].leading_edge - pair[0].leading_edge;
        along.y.hypot(along.z) > 0.01
    };
    if sections.len() < 2 || !sections.windows(2).all(parts) {
        return Err(
            block.error("sections", "expected at least two rows, each at another place along the span")
        );
    }
    if sections.iter().any(|s| s.chord <= 0.01 || !(0.005..=0.5).contains(&s.thickness)) {
        let text = "expected a chord above 0.01 m and a thickness of 0.005 to 0.5 chords";
        return Err(block.error("sections", text));
    }
    let mut controls = Vec::new();
    for (key, control) in Control::NAMES {
        for [from, to, chord] in rows(&mut block, key, "rows of from, to, chord, as fractions")? {
            if !(0.0 <= from && from < to && to <= 1.0 && 0.05 < chord && chord <= 1.0) {
                return Err(block.error(key, "expected fractions: from less than to, and a chord above 0.05"));
            }
            controls.push(ControlSpan { control, from, to, chord });
        }
    }
    block.finish()?;
    let profile = profile.unwrap_or(Profile::Wing);
    Ok(Surface { is_pair, profile, incidence: incidence.to_radians(), rounding, sections, controls })
}
