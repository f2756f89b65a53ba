//! The modes of an aircraft as its source prints them.

use super::reader::{Block, ContentError};

/// The mode a published number belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PublishedMode {
    /// Short period, an oscillation or two real roots.
    ShortPeriod,
    /// Phugoid.
    Phugoid,
    /// Dutch roll.
    DutchRoll,
    /// Roll subsidence.
    Roll,
    /// Spiral.
    Spiral,
}

impl PublishedMode {
    /// The modes by the name that a file gives them.
    pub const NAMES: [(&'static str, Self); 5] = [
        ("short period", Self::ShortPeriod),
        ("phugoid", Self::Phugoid),
        ("Dutch roll", Self::DutchRoll),
        ("roll", Self::Roll),
        ("spiral", Self::Spiral),
    ];

    /// Its name.
    pub fn name(self) -> &'static str {
        Self::NAMES.iter().find(|(_, mode)| *mode == self).map_or("", |(name, _)| name)
    }
}

/// Printed quantity of a mode.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// Natural frequency ωn \[rad/s\].
    NaturalFrequency,
    /// Damping ratio ζ.
    DampingRatio,
    /// A real root λ \[1/s\].
    Root,
}

impl Quantity {
    /// Symbol with its unit.
    pub const fn symbol(self) -> &'static str {
        match self {
            Self::NaturalFrequency => "ωn (rad/s)",
            Self::DampingRatio => "ζ",
            Self::Root => "λ (1/s)",
        }
    }
}

/// A published number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Published {
    /// The mode.
    pub mode: PublishedMode,
    /// The quantity; a pair printed as real and imaginary part is kept as ωn and ζ.
    pub quantity: Quantity,
    /// Its value.
    pub value: f64,
    /// Change of the number when every input moves by half a unit of its last printed digit, where that is more than 3 %.
    pub rounding_band: Option<f64>,
}

/// The tables `[[….published]]` of a plane.
pub(super) fn read_published(plane: &mut Block<'_>) -> Result<Vec<Published>, ContentError> {
    let mut all = Vec::new();
    for mut block in plane.blocks("published")? {
        let mode = block.choice("mode", &PublishedMode::NAMES)?;
        let mut push = |quantity, value, rounding_band| {
            all.push(Published { mode, quantity, value, rounding_band });
        };
        if let Some(re) = block.optional_number("re")? {
            // ωn = |λ|,  ζ = −σ/ωn
            let frequency = re.hypot(block.positive("im")?);
            push(Quantity::NaturalFrequency, frequency, None);
            push(Quantity::DampingRatio, -re / frequency, None);
        } else if let Some(frequency) = block.optional_positive("wn")? {
            push(Quantity::NaturalFrequency, frequency, block.optional_positive("band_wn")?);
            let damping = block.number("zeta")?;
            push(Quantity::DampingRatio, damping, block.optional_positive("band_zeta")?);
        } else if block.has("roots") {
            block.numbers("roots")?.into_iter().for_each(|root| push(Quantity::Root, root, None));
        } else {
            return Err(block.error_here("expected wn and zeta, or re and im, or roots"));
        }
        block.finish()?;
    }
    if let Some(zero) = all.iter().find(|published| published.value == 0.0) {
        return Err(plane.error("published", format_args!("a number of the {} is zero", zero.mode.name())));
    }
    Ok(all)
}
