//! Published numbers beside the computed ones.

use eigenwing::content::aircraft::{Published, PublishedMode, Quantity};
use eigenwing::flight::aircraft::plane::PlaneModel;
use eigenwing::flight::modes::eigen::{EigenError, eigen};
use nalgebra::Complex;

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
