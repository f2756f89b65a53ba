//! Handling-quality levels: what a pilot would say of each mode, after MIL-F-8785C.
//!
//! A verdict carries the limit that governs it and how far away that is. An aperiodic divergence in pitch gets none: paragraph 3.2.1.1
//! judges it, by numbers that are not in the tables here.

use super::mil_f_8785c::{
    Category, Class, Criterion, Levels, Quantity, Requirement, coupled_roll_spiral, dutch_roll, phugoid,
    roll_mode, short_period_damping, short_period_frequency, spiral,
};
use crate::flight::aircraft::axes::StabilityAxes;
use crate::flight::aircraft::plane::{Plane, PlaneModel};
use crate::flight::aircraft::states::Lateral::{Phi, V};
use crate::flight::aircraft::states::Longitudinal::{Q, W};
use crate::flight::aircraft::states::entry;
use crate::flight::modes::mode::Mode;
use crate::flight::modes::mode_name::ModeName;
use crate::flight::modes::second_order::{DUTCH_ROLL, PHUGOID, SHORT_PERIOD, SecondOrder, second_order};
use crate::key::keys;

/// How good the handling is (1.5, p. 4).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Level {
    /// Clearly adequate for the mission.
    One,
    /// Adequate, with more work for the pilot or less effect.
    Two,
    /// Controllable safely, with too much work or too little effect.
    Three,
    /// Worse than Level 3.
    Beyond,
}

keys! {
    Level {
        One => "level-1",
        Two => "level-2",
        Three => "level-3",
        Beyond => "worse-than-level-3",
    }
}

impl Level {
    const fn number(self) -> usize {
        self as usize
    }
}

/// The limit that governs a verdict.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Governing {
    /// The limit: of Level 1 if that is met, else of the next better level, which this one misses by most.
    pub requirement: Requirement,
    /// The level that the limit belongs to.
    pub of: Level,
    /// The limit on the other side of the same quantity, where that level sets one.
    pub other: Option<f64>,
    /// The value that the aircraft has.
    pub value: f64,
}

/// The verdict on one criterion.
#[derive(Clone, Debug, PartialEq)]
pub struct Verdict {
    /// What was judged.
    pub criterion: Criterion,
    /// The level, by the numbers as computed.
    pub level: Level,
    /// Whether a value equals a limit to three digits, so that the last digit would decide the level.
    pub on_boundary: bool,
    /// The values judged.
    pub values: Vec<(Quantity, f64)>,
    /// The governing limit; `None` where no number decides (a stable spiral, an oscillation that is not allowed).
    pub governing: Option<Governing>,
    /// The limit of Level 1 on a quantity that the mode doesn't have, and so meets: what never doubles has no time to double.
    pub met_by_absence: Option<Requirement>,
    /// What else is to be said of how it was judged.
    pub remark: Option<Remark>,
    /// The phase of flight whose limits these are.
    pub category: Category,
}

/// What a limit and a value don't say of a verdict.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Remark {
    /// Two real roots were judged as one motion, since the oscillation has become such.
    TwoRealRoots,
    /// A Dutch roll that diverges.
    Diverges,
    /// A roll rate that doesn't die away.
    RollGrows,
    /// A coupled roll–spiral oscillation in a category that allows none.
    NotAllowed,
}

/// All verdicts for the plane of `model`, whose modes are `modes`, for a class of aircraft in a phase of flight.
pub fn handling_qualities(
    model: &PlaneModel,
    modes: &[Mode],
    class: Class,
    category: Category,
) -> Vec<Verdict> {
    match model.plane {
        Plane::Longitudinal => longitudinal(model, modes, class, category),
        Plane::Lateral => lateral(model, modes, class, category),
    }
}

/// Load factor for angle of attack n/α \[g/rad\], positive where more angle of attack is more lift; `None` if not finite.
///
/// n/α = −V² A_ww/(g A_wq), which is −V Zw/g where Zq is zero (MIL-F-8785C 6.2.4).
pub fn load_factor_slope(model: &StabilityAxes) -> Option<f64> {
    let PlaneModel { a, trim, .. } = model.model();
    let slope = -trim.speed * trim.speed * entry(a, W, W) / (trim.gravity * entry(a, W, Q));
    slope.is_finite().then_some(slope)
}

/// |φ/β| of a lateral mode: bank angle about the flight path for sideslip angle, β = v/V; `None` if not finite.
pub fn phi_to_beta(model: &PlaneModel, mode: &Mode) -> Option<f64> {
    // φ in stability axes is φ cos θ₀/cos γ₀
    let phi = mode.component(Phi).norm() * (model.trim.theta0().cos() / model.trim.gamma0.cos()).abs();
    let ratio = phi * model.trim.speed / mode.component(V).norm();
    ratio.is_finite().then_some(ratio)
}

fn longitudinal(model: &PlaneModel, modes: &[Mode], class: Class, category: Category) -> Vec<Verdict> {
    let mut verdicts = Vec::new();
    if let Some(motion) = second_order(modes, SHORT_PERIOD) {
        let SecondOrder { natural_frequency: wn, damping_ratio: zeta } = motion;
        let remark = remark_on_roots(modes, ModeName::ShortPeriod);
        let values = vec![(Quantity::DampingRatio, zeta)];
        let damping = judge(Criterion::ShortPeriodDamping, category, values, &short_period_damping(category));
        verdicts.push(Verdict { remark, ..damping });
        // CAP = ωₙ²/(n/α)
        let slope = load_factor_slope(&StabilityAxes::of(model)).filter(|slope| *slope > 0.0);
        if let Some((slope, cap)) = slope.map(|slope| (slope, wn * wn / slope)).filter(|x| x.1.is_finite()) {
            let values = vec![
                (Quantity::ControlAnticipation, cap),
                (Quantity::NaturalFrequency, wn),
                (Quantity::LoadFactorSlope, slope),
            ];
            let levels = short_period_frequency(class, category);
            let frequency = judge(Criterion::ShortPeriodFrequency, category, values, &levels);
            verdicts.push(Verdict { remark, ..frequency });
        }
    }
    if let Some(motion) = second_order(modes, PHUGOID) {
        let mut values = vec![(Quantity::DampingRatio, motion.damping_ratio)];
        values.extend(find(modes, ModeName::Phugoid).and_then(time_to_double));
        let remark = remark_on_roots(modes, ModeName::Phugoid);
        verdicts.push(Verdict { remark, ..judge(Criterion::Phugoid, category, values, &phugoid()) });
    }
    verdicts
}

fn lateral(model: &PlaneModel, modes: &[Mode], class: Class, category: Category) -> Vec<Verdict> {
    let mut verdicts = Vec::new();
    if let Some(motion) = second_order(modes, DUTCH_ROLL) {
        let SecondOrder { natural_frequency: wn, damping_ratio: zeta } = motion;
        let phi_to_beta =
            find(modes, ModeName::DutchRoll).and_then(|mode| phi_to_beta(model, mode)).unwrap_or(0.0);
        let phi_rule = (wn * wn * phi_to_beta).min(f64::MAX);
        let values = vec![
            (Quantity::DampingRatio, zeta),
            (Quantity::DampingProduct, zeta * wn),
            (Quantity::NaturalFrequency, wn),
        ];
        let levels = dutch_roll(class, category, wn, phi_rule);
        let remark = remark_on_roots(modes, ModeName::DutchRoll);
        verdicts.push(Verdict { remark, ..judge(Criterion::DutchRoll, category, values, &levels) });
    } else if find(modes, ModeName::DirectionalDivergence).is_some() {
        verdicts.push(not_allowed(Criterion::DutchRoll, category, Vec::new(), Remark::Diverges));
    }
    if let Some(mode) = find(modes, ModeName::RollSubsidence).or(find(modes, ModeName::RollDivergence)) {
        verdicts.push(match mode.time_constant().filter(|tau| *tau > 0.0 && tau.is_finite()) {
            Some(tau) => judge(
                Criterion::RollMode,
                category,
                vec![(Quantity::TimeConstant, tau)],
                &roll_mode(class, category),
            ),
            None => not_allowed(Criterion::RollMode, category, Vec::new(), Remark::RollGrows),
        });
    }
    if let Some(mode) = find(modes, ModeName::Spiral) {
        let values = time_to_double(mode).into_iter().collect();
        verdicts.push(judge(Criterion::Spiral, category, values, &spiral(category)));
    }
    if let Some(mode) = find(modes, ModeName::CoupledRollSpiral) {
        // ζωₙ = −σ
        let values = vec![(Quantity::DampingProduct, -mode.lambda.re)];
        verdicts.push(match coupled_roll_spiral(category) {
            Some(levels) => judge(Criterion::CoupledRollSpiral, category, values, &levels),
            None => not_allowed(Criterion::CoupledRollSpiral, category, values, Remark::NotAllowed),
        });
    }
    verdicts
}

fn find(modes: &[Mode], name: ModeName) -> Option<&Mode> {
    modes.iter().find(|mode| mode.naming.name == name)
}

fn time_to_double(mode: &Mode) -> Option<(Quantity, f64)> {
    mode.time_to_double().filter(|t| t.is_finite()).map(|t| (Quantity::TimeToDouble, t))
}

/// That two real roots were judged together, where the oscillation by this name has become such.
fn remark_on_roots(modes: &[Mode], pair: ModeName) -> Option<Remark> {
    find(modes, pair).is_none().then_some(Remark::TwoRealRoots)
}

fn not_allowed(
    criterion: Criterion,
    category: Category,
    values: Vec<(Quantity, f64)>,
    remark: Remark,
) -> Verdict {
    Verdict {
        criterion,
        level: Level::Beyond,
        on_boundary: false,
        values,
        governing: None,
        met_by_absence: None,
        remark: Some(remark),
        category,
    }
}

/// The best level all of whose requirements are met, and the limit that governs it.
fn judge(criterion: Criterion, category: Category, values: Vec<(Quantity, f64)>, levels: &Levels) -> Verdict {
    let value = |quantity: Quantity| values.iter().find(|(q, _)| *q == quantity).map(|(_, value)| *value);
    // A quantity that is absent is met: what never doubles has no time to double.
    let excess = |requirement: &Requirement| {
        value(requirement.quantity).map(|value| {
            if requirement.is_minimum { value - requirement.limit } else { requirement.limit - value }
        })
    };
    // The best level if each value may be off by `slack` roundings of the limit.
    let level_with = |slack: f64| {
        let met = |r: &Requirement| excess(r).is_none_or(|excess| excess >= slack * rounding(r.limit));
        [Level::One, Level::Two, Level::Three]
            .into_iter()
            .zip(levels)
            .find(|(_, requirements)| requirements.iter().all(met))
            .map_or(Level::Beyond, |(level, _)| level)
    };
    let level = level_with(0.0);
    // The limits of Level 1, or of the next better level; the one missed by most or met by least, for its size.
    let of = [Level::One, Level::One, Level::Two, Level::Three][level.number()];
    let relative = |r: &Requirement| excess(r).map(|excess| excess / r.limit.abs().max(0.01));
    let governing = levels[of.number()]
        .iter()
        .filter_map(|r| Some((relative(r)?, r)))
        .min_by(|x, y| x.0.total_cmp(&y.0))
        .and_then(|(_, r)| {
            let across = |o: &&Requirement| o.quantity == r.quantity && o.is_minimum != r.is_minimum;
            let other = levels[of.number()].iter().find(across).map(|o| o.limit);
            Some(Governing { requirement: *r, of, other, value: value(r.quantity)? })
        });
    let met_by_absence = governing.is_none().then(|| levels[0].first().copied()).flatten();
    Verdict {
        criterion,
        level,
        on_boundary: level_with(-1.0) != level_with(1.0),
        governing,
        met_by_absence,
        remark: None,
        category,
        values,
    }
}

/// Half a unit of the third significant digit of a limit; of a limit of zero, 0.0005.
fn rounding(limit: f64) -> f64 {
    let size = if limit == 0.0 { 0.1 } else { limit.abs() };
    0.5 * 10_f64.powf(size.log10().floor() - 2.0)
}
