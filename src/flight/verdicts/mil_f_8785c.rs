//! The limits of MIL-F-8785C, *Flying Qualities of Piloted Airplanes*, 5 November 1980, as tables.
//!
//! Page numbers are the printed ones. The slopes of figures 1–3 and "ωₙ > 0.6" are printed on them; the other floors of
//! figure 3 are read off the drawing, two of them (0.87 rad/s, 1.8 g/rad) rounded as later standards give them. Left out: the
//! relaxations by agreement (Level 3 damping above 20,000 ft; the starred ωₙ of Class III) and flight-path stability (3.2.1.3).

use crate::flight::modes::mode_name::ModeName;
use crate::key::keys;

/// The kind of aircraft (1.3, pp. 1–2).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Class {
    /// Small, light.
    I,
    /// Medium weight, low to medium manoeuvrability; land based.
    II,
    /// The same, carrier based.
    IICarrier,
    /// Large, heavy, low to medium manoeuvrability.
    III,
    /// High manoeuvrability.
    IV,
}

keys! {
    Class {
        I => "I",
        II => "II",
        IICarrier => "II-C",
        III => "III",
        IV => "IV",
    }
}

impl Class {
    /// Classes I, II-C and IV, which the tables set apart from II-L and III in the terminal phases.
    fn is_agile_in_terminal_phases(self) -> bool {
        matches!(self, Self::I | Self::IICarrier | Self::IV)
    }

    /// Classes I and IV, which the tables set apart from II and III in Category A.
    fn is_agile(self) -> bool {
        matches!(self, Self::I | Self::IV)
    }
}

/// The phase of flight (1.4, pp. 2–3).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Category {
    /// Air combat and ground attack, the phases of Category A with limits of their own.
    ACombat,
    /// Rapid manoeuvring, precision tracking or precise control of the flight path.
    A,
    /// Gradual manoeuvres without precision tracking: climb, cruise, loiter, descent.
    B,
    /// Take-off, approach and landing.
    C,
}

keys! {
    Category {
        ACombat => "A-combat",
        A => "A",
        B => "B",
        C => "C",
    }
}

impl Category {
    /// The letter of the category.
    pub const fn letter(self) -> &'static str {
        match self {
            Self::ACombat | Self::A => "A",
            Self::B => "B",
            Self::C => "C",
        }
    }

    fn is_a(self) -> bool {
        matches!(self, Self::A | Self::ACombat)
    }
}

/// A quantity that a limit is set on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// ζ.
    DampingRatio,
    /// ωₙ \[rad/s\].
    NaturalFrequency,
    /// ζωₙ \[rad/s\].
    DampingProduct,
    /// Control anticipation parameter ωₙ²/(n/α) \[rad/s² per g\].
    ControlAnticipation,
    /// n/α \[g/rad\].
    LoadFactorSlope,
    /// τ_R \[s\].
    TimeConstant,
    /// T₂ \[s\]; absent where nothing doubles, and then met.
    TimeToDouble,
    /// |φ/β| of the Dutch roll. No limit is set on it; above a size it raises the least ζωₙ.
    RollToSideslip,
}

/// One limit: a quantity has to be at least, or at most, so much.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Requirement {
    /// The quantity that is limited.
    pub quantity: Quantity,
    /// Whether the limit is the least value allowed; else it is the greatest.
    pub is_minimum: bool,
    /// The limit itself, in the unit of the quantity.
    pub limit: f64,
    /// The part of the limit that the table doesn't print: Δ(ζωₙ) of a Dutch roll that rolls much; zero elsewhere.
    pub raise: f64,
}

impl Requirement {
    pub(super) const fn at_least(quantity: Quantity, limit: f64) -> Self {
        Self { quantity, is_minimum: true, limit, raise: 0.0 }
    }

    pub(super) const fn at_most(quantity: Quantity, limit: f64) -> Self {
        Self { quantity, is_minimum: false, limit, raise: 0.0 }
    }
}

/// A requirement of the specification that is judged, with its paragraph.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Criterion {
    /// Airspeed that diverges without swinging.
    AirspeedDivergence,
    /// Pitch attitude or angle of attack that diverges without swinging.
    PitchDivergence,
    /// Phugoid damping.
    Phugoid,
    /// Short-period damping.
    ShortPeriodDamping,
    /// Short-period frequency and acceleration sensitivity.
    ShortPeriodFrequency,
    /// Dutch roll frequency and damping.
    DutchRoll,
    /// Roll mode time constant.
    RollMode,
    /// Spiral time to double.
    Spiral,
    /// Coupled roll–spiral oscillation.
    CoupledRollSpiral,
}

keys! {
    Criterion {
        AirspeedDivergence => "airspeed-divergence",
        PitchDivergence => "pitch-divergence",
        Phugoid => "phugoid",
        ShortPeriodDamping => "short-period-damping",
        ShortPeriodFrequency => "short-period-frequency",
        DutchRoll => "dutch-roll",
        RollMode => "roll-mode",
        Spiral => "spiral",
        CoupledRollSpiral => "coupled-roll-spiral",
    }
}

impl Criterion {
    /// The mode that it judges, by the name of its oscillation where that has parted into two real roots.
    pub const fn concerns(self) -> ModeName {
        match self {
            Self::AirspeedDivergence => ModeName::SpeedDivergence,
            Self::PitchDivergence => ModeName::PitchDivergence,
            Self::Phugoid => ModeName::Phugoid,
            Self::ShortPeriodDamping | Self::ShortPeriodFrequency => ModeName::ShortPeriod,
            Self::DutchRoll => ModeName::DutchRoll,
            Self::RollMode => ModeName::RollSubsidence,
            Self::Spiral => ModeName::Spiral,
            Self::CoupledRollSpiral => ModeName::CoupledRollSpiral,
        }
    }

    /// Paragraph of MIL-F-8785C.
    pub const fn paragraph(self) -> &'static str {
        match self {
            Self::AirspeedDivergence => "3.2.1.1",
            Self::PitchDivergence => "3.2.2.2",
            Self::Phugoid => "3.2.1.2",
            Self::ShortPeriodDamping => "3.2.2.1.2",
            Self::ShortPeriodFrequency => "3.2.2.1.1",
            Self::DutchRoll => "3.3.1.1",
            Self::RollMode => "3.3.1.2",
            Self::Spiral => "3.3.1.3",
            Self::CoupledRollSpiral => "3.3.1.4",
        }
    }

    /// Where in MIL-F-8785C the limits stand.
    pub const fn source(self, category: Category) -> Source {
        match self {
            Self::AirspeedDivergence => Source::Text { page: 11 },
            Self::PitchDivergence => Source::Text { page: 13 },
            Self::Phugoid => Source::Text { page: 12 },
            Self::ShortPeriodDamping => Source::Table { number: "IV", page: 13 },
            Self::ShortPeriodFrequency => match category {
                Category::A | Category::ACombat => Source::Figure { number: 1, page: 14 },
                Category::B => Source::Figure { number: 2, page: 15 },
                Category::C => Source::Figure { number: 3, page: 16 },
            },
            Self::DutchRoll => Source::Table { number: "VI", page: 22 },
            Self::RollMode => Source::Table { number: "VII", page: 23 },
            Self::Spiral => Source::Table { number: "VIII", page: 23 },
            Self::CoupledRollSpiral => Source::Text { page: 23 },
        }
    }
}

/// A place in MIL-F-8785C, by its printed page.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Source {
    /// The text of the paragraph.
    Text {
        /// Page.
        page: u32,
    },
    /// A table.
    Table {
        /// Roman number of the table.
        number: &'static str,
        /// Page.
        page: u32,
    },
    /// A figure.
    Figure {
        /// Number of the figure.
        number: u32,
        /// Page.
        page: u32,
    },
}

/// The requirements of Levels 1, 2 and 3.
pub(super) type Levels = [Vec<Requirement>; 3];

use Quantity::{
    ControlAnticipation, DampingProduct, DampingRatio, LoadFactorSlope, NaturalFrequency, TimeConstant,
    TimeToDouble,
};

/// 3.2.1.1, p. 11: what Level 3 asks of a divergence of airspeed. Levels 1 and 2 allow none.
pub(super) const LEAST_TIME_TO_DOUBLE_AIRSPEED: Requirement = Requirement::at_least(TimeToDouble, 6.0);

/// 3.2.1.2, p. 12.
pub(super) fn phugoid() -> Levels {
    [
        vec![Requirement::at_least(DampingRatio, 0.04)],
        vec![Requirement::at_least(DampingRatio, 0.0)],
        vec![Requirement::at_least(TimeToDouble, 55.0)],
    ]
}

/// Table IV, p. 13.
pub(super) fn short_period_damping(category: Category) -> Levels {
    let within =
        |low, high| vec![Requirement::at_least(DampingRatio, low), Requirement::at_most(DampingRatio, high)];
    let level_3 = vec![Requirement::at_least(DampingRatio, 0.15)];
    match category {
        Category::B => [within(0.30, 2.00), within(0.20, 2.00), level_3],
        Category::A | Category::ACombat | Category::C => [within(0.35, 1.30), within(0.25, 2.00), level_3],
    }
}

/// Figures 1–3, pp. 14–16.
pub(super) fn short_period_frequency(class: Class, category: Category) -> Levels {
    let cap = |low, high| {
        vec![Requirement::at_least(ControlAnticipation, low), Requirement::at_most(ControlAnticipation, high)]
    };
    let cap_3 = |low| vec![Requirement::at_least(ControlAnticipation, low)];
    let with = |mut requirements: Vec<Requirement>, wn: f64, n_alpha: Option<f64>| {
        requirements.push(Requirement::at_least(NaturalFrequency, wn));
        requirements.extend(n_alpha.map(|slope| Requirement::at_least(LoadFactorSlope, slope)));
        requirements
    };
    match category {
        Category::A | Category::ACombat => {
            [with(cap(0.28, 3.6), 1.0, None), with(cap(0.16, 10.0), 0.6, None), cap_3(0.16)]
        }
        Category::B => [cap(0.085, 3.6), cap(0.038, 10.0), cap_3(0.038)],
        Category::C if class.is_agile_in_terminal_phases() => [
            with(cap(0.16, 3.6), 0.87, Some(2.7)),
            with(cap(0.096, 10.0), 0.6, Some(1.8)),
            with(cap_3(0.096), 0.6, None),
        ],
        Category::C => {
            [with(cap(0.16, 3.6), 0.7, Some(2.0)), with(cap(0.096, 10.0), 0.4, Some(1.0)), cap_3(0.096)]
        }
    }
}

/// Table VI, p. 22. `phi_rule` is ωₙ²|φ/β|, which above 20 raises the least ζωₙ; `wn` is ωₙ \[rad/s\].
pub(super) fn dutch_roll(class: Class, category: Category, wn: f64, phi_rule: f64) -> Levels {
    // (ζ, ζωₙ, ωₙ) of Level 1
    let (zeta, product, frequency) = match category {
        Category::ACombat if class == Class::IV => (0.4, None, 1.0),
        Category::A | Category::ACombat if class.is_agile() => (0.19, Some(0.35), 1.0),
        Category::A | Category::ACombat => (0.19, Some(0.35), 0.4),
        Category::B => (0.08, Some(0.15), 0.4),
        Category::C if class.is_agile_in_terminal_phases() => (0.08, Some(0.15), 1.0),
        Category::C => (0.08, Some(0.10), 0.4),
    };
    let row = |zeta: f64, product: Option<f64>, frequency: f64, k: f64| {
        // Δ(ζωₙ) = k (ωₙ²|φ/β| − 20)
        let raise = k * (phi_rule - 20.0).max(0.0);
        let product = match product {
            Some(product) => Some(product + raise),
            None => (raise > 0.0).then_some(raise),
        };
        let mut requirements = vec![Requirement::at_least(DampingRatio, zeta)];
        if let Some(product) = product {
            // Never more than ζ = 0.7 of Class III
            requirements.push(if class == Class::III && product > 0.7 * wn {
                Requirement::at_least(DampingRatio, 0.7)
            } else {
                Requirement { raise, ..Requirement::at_least(DampingProduct, product) }
            });
        }
        requirements.push(Requirement::at_least(NaturalFrequency, frequency));
        requirements
    };
    [row(zeta, product, frequency, 0.014), row(0.02, Some(0.05), 0.4, 0.009), row(0.0, None, 0.4, 0.005)]
}

/// Table VII, p. 23.
pub(super) fn roll_mode(class: Class, category: Category) -> Levels {
    let agile = match category {
        Category::A | Category::ACombat => class.is_agile(),
        Category::B => false,
        Category::C => class.is_agile_in_terminal_phases(),
    };
    let [one, two] = if agile { [1.0, 1.4] } else { [1.4, 3.0] };
    [one, two, 10.0].map(|limit| vec![Requirement::at_most(TimeConstant, limit)])
}

/// Table VIII, p. 23, from bank disturbances up to 20°.
pub(super) fn spiral(category: Category) -> Levels {
    let one = if category == Category::B { 20.0 } else { 12.0 };
    [one, 8.0, 4.0].map(|limit| vec![Requirement::at_least(TimeToDouble, limit)])
}

/// 3.3.1.4, p. 23; `None` in Category A, where the oscillation is not allowed.
pub(super) fn coupled_roll_spiral(category: Category) -> Option<Levels> {
    (!category.is_a())
        .then(|| [0.5, 0.3, 0.15].map(|limit| vec![Requirement::at_least(DampingProduct, limit)]))
}
