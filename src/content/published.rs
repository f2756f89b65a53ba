//! What a source prints of an aircraft's modes, set beside what this program computes.

use nalgebra::Complex;

use super::reader::{Block, ContentError};
use crate::flight::aircraft::plane::PlaneModel;
use crate::flight::modes::eigen::{EigenError, eigen};

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

/// Which number of a mode.
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

/// One published number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Published {
    /// Of which mode.
    pub mode: PublishedMode,
    /// Which number; a pair printed as real and imaginary part is kept as ωn and ζ.
    pub quantity: Quantity,
    /// Its value.
    pub value: f64,
    /// How far half a unit of the last printed digit of every input moves it, where that is more than 3 %.
    pub rounding_band: Option<f64>,
}

/// A published number beside the computed one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Comparison {
    /// The published number.
    pub published: Published,
    /// The computed one; none where the model has no such mode.
    pub computed: Option<f64>,
}

/// Largest difference that counts as reproduced.
pub const TOLERANCE: f64 = 0.03;

impl Comparison {
    /// (computed − published)/|published|.
    pub fn relative_error(&self) -> Option<f64> {
        self.computed.map(|computed| (computed - self.published.value) / self.published.value.abs())
    }

    /// Whether the difference is within 3 %, or within the rounding band where one is stated.
    pub fn is_reproduced(&self) -> bool {
        let within = |computed: f64| {
            let error = (computed - self.published.value).abs();
            let allowed = TOLERANCE * self.published.value.abs();
            error <= allowed.max(self.published.rounding_band.unwrap_or(0.0))
        };
        self.computed.is_some_and(within)
    }
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

/// Every published number of a plane beside that of its model.
///
/// Which root is which is settled by structure, enough for published cases: of two pairs the faster is the short
/// period; of two real roots the faster is the roll.
pub fn compare(model: &PlaneModel, published: &[Published]) -> Result<Vec<Comparison>, EigenError> {
    let values = eigen(&model.a)?.values;
    let mut pairs: Vec<Complex<f64>> = values.iter().copied().filter(|value| value.im > 0.0).collect();
    let mut roots: Vec<f64> = values.iter().filter(|value| value.im == 0.0).map(|value| value.re).collect();
    pairs.sort_by(|a, b| b.norm().total_cmp(&a.norm()));
    roots.sort_by(|a, b| b.abs().total_cmp(&a.abs()));
    let has_real_short_period =
        published.iter().any(|p| p.mode == PublishedMode::ShortPeriod && p.quantity == Quantity::Root);
    let pair_of = |mode| match mode {
        PublishedMode::ShortPeriod | PublishedMode::DutchRoll => pairs.first(),
        PublishedMode::Phugoid if has_real_short_period => pairs.first(),
        PublishedMode::Phugoid => pairs.get(1),
        PublishedMode::Roll | PublishedMode::Spiral => None,
    };
    let root_of = |p: &Published| match p.mode {
        PublishedMode::Roll => roots.first().copied(),
        PublishedMode::Spiral => roots.last().copied(),
        // the nearest of the two
        _ => roots.iter().copied().min_by(|a, b| (a - p.value).abs().total_cmp(&(b - p.value).abs())),
    };
    let computed = |p: &Published| match p.quantity {
        Quantity::NaturalFrequency => pair_of(p.mode).map(|pair| pair.norm()),
        Quantity::DampingRatio => pair_of(p.mode).map(|pair| -pair.re / pair.norm()),
        Quantity::Root => root_of(p),
    };
    Ok(published.iter().map(|p| Comparison { published: *p, computed: computed(p) }).collect())
}
