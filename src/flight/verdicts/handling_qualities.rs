//! Handling-quality levels: what a pilot would say of each mode, after MIL-F-8785C.
//!
//! A verdict carries the limit that governs it and how far away that is. Where an oscillation has parted into two real roots that
//! both die away, a requirement on it has nothing left to judge; real roots that grow are judged as divergences. An oscillation of the
//! aircraft with states beside the four is judged as that whose states carry most of it. What no requirement is on, and a requirement
//! that has lost its mode to such an oscillation, are told as verdicts without a level.

use super::mil_f_8785c::{
    Criterion, LEAST_TIME_TO_DOUBLE_AIRSPEED, Levels, Quantity, Requirement, coupled_roll_spiral, dutch_roll,
    phugoid, roll_mode, short_period_damping, short_period_frequency, spiral,
};
use super::task::Task;
use crate::flight::aircraft::axes::StabilityAxes;
use crate::flight::aircraft::plane::{Plane, PlaneModel};
use crate::flight::aircraft::states::Lateral::{Phi, V};
use crate::flight::aircraft::states::Longitudinal::{Q, W};
use crate::flight::aircraft::states::entry;
use crate::flight::modes::mode::Mode;
use crate::flight::modes::mode_name::ModeName;
use crate::flight::modes::reason::StateSet;
use crate::flight::modes::second_order::{DUTCH_ROLL, PHUGOID, SHORT_PERIOD, SecondOrder, second_order};
use crate::flight::modes::stability::Stability;
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
    /// The criterion that was judged.
    pub criterion: Criterion,
    /// Names of the modes that were judged.
    pub modes: Vec<ModeName>,
    /// The level, by the numbers as computed; `None` where the oscillation that the requirement is on is gone, and where there
    /// [is no telling](Self::leaves_open).
    pub level: Option<Level>,
    /// Whether a value equals a limit to three digits, so that the last digit would decide the level.
    pub on_boundary: bool,
    /// The values judged.
    pub values: Vec<(Quantity, f64)>,
    /// The governing limit; `None` where no number decides (a stable spiral, an oscillation that is not allowed).
    pub governing: Option<Governing>,
    /// The limit of Level 1 on a quantity that the mode doesn't have, and so meets: what never doubles has no time to double.
    pub met_by_absence: Option<Requirement>,
    /// A remark on how it was judged.
    pub remark: Option<Remark>,
    /// Class of aircraft and phase of flight whose limits these are.
    pub task: Task,
}

impl Verdict {
    /// Whether flight has something in it that is not judged, so that the aircraft has no level.
    pub const fn leaves_open(&self) -> bool {
        matches!(self.remark, Some(Remark::NoRequirement | Remark::NoModeLeft))
    }
}

/// A remark on a verdict that a limit and a value don't make.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Remark {
    /// Two real roots were judged as one motion, since the oscillation has become such.
    TwoRealRoots,
    /// Two real roots that die away: nothing swings, so that a requirement on an oscillation has nothing to judge.
    NoOscillation,
    /// Airspeed that diverges, which Levels 1 and 2 don't allow.
    AirspeedDiverges,
    /// Pitch attitude and angle of attack that diverge, which no level allows.
    PitchDiverges,
    /// An oscillation in yaw and roll that grows, which no level allows.
    OscillationGrows,
    /// A Dutch roll that diverges.
    Diverges,
    /// A roll rate that doesn't die away.
    RollGrows,
    /// A coupled roll–spiral oscillation in a category that allows none.
    NotAllowed,
    /// An oscillation in which several roots have met, judged as that whose states carry most of it.
    StandsFor,
    /// An oscillation of the aircraft that no requirement is on.
    NoRequirement,
    /// No mode is left that the requirement is on.
    NoModeLeft,
}

/// All verdicts for the plane of `model`, whose modes are `modes`, for a class of aircraft in a phase of flight.
pub fn handling_qualities(model: &PlaneModel, modes: &[Mode], task: Task) -> Vec<Verdict> {
    match model.plane {
        Plane::Longitudinal => longitudinal(model, modes, task),
        Plane::Lateral => lateral(model, modes, task),
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

fn longitudinal(model: &PlaneModel, modes: &[Mode], task: Task) -> Vec<Verdict> {
    let mut verdicts = divergences(modes, task);
    if let Some(motion) = second_order(modes, SHORT_PERIOD) {
        let remark = remark_on_roots(modes, ModeName::ShortPeriod);
        verdicts.extend(short_period(model, motion, (remark, &present(modes, &SHORT_PERIOD)), task));
    }
    if let Some(mode) = find(modes, ModeName::Phugoid) {
        verdicts.push(Verdict { remark: None, ..of_phugoid(mode, task) });
    } else if let roots = present(modes, &PHUGOID)
        && die_away(modes, &roots)
    {
        verdicts.push(without_level(Criterion::Phugoid, task, roots, Remark::NoOscillation));
    }
    for mode in modes {
        let fast = StateSet::AngleOfAttackAndPitchRate.share(&mode.participation);
        let name = [mode.naming.name];
        match mode.naming.name {
            ModeName::FeedbackOscillation | ModeName::FurtherOscillation if fast >= 0.5 => {
                let motion = SecondOrder::of(-2.0 * mode.lambda.re, mode.lambda.norm_sqr());
                let judged = |motion| short_period(model, motion, (Some(Remark::StandsFor), &name), task);
                verdicts.extend(motion.into_iter().flat_map(judged));
            }
            ModeName::FeedbackOscillation | ModeName::FurtherOscillation => {
                verdicts.push(of_phugoid(mode, task))
            }
            ModeName::ThirdOscillatory => {
                let verdict =
                    without_level(Criterion::ShortPeriodDamping, task, name.to_vec(), Remark::NoRequirement);
                verdicts.push(verdict);
            }
            _ => {}
        }
    }
    let criteria = [Criterion::ShortPeriodDamping, Criterion::PitchDivergence];
    verdicts.extend(without_mode(&verdicts, &criteria, modes, task));
    verdicts
}

/// The verdicts on a motion that is the short period, or stands for it.
fn short_period(
    model: &PlaneModel,
    motion: SecondOrder,
    (remark, judged): (Option<Remark>, &[ModeName]),
    task: Task,
) -> Vec<Verdict> {
    let Task { class, category } = task;
    let SecondOrder { natural_frequency: wn, damping_ratio: zeta } = motion;
    let values = vec![(Quantity::DampingRatio, zeta)];
    let damping = judge(Criterion::ShortPeriodDamping, task, values, &short_period_damping(category));
    let mut verdicts = vec![Verdict { remark, modes: judged.to_vec(), ..damping }];
    // CAP = ωₙ²/(n/α)
    let slope = load_factor_slope(&StabilityAxes::of(model)).filter(|slope| *slope > 0.0);
    if let Some((slope, cap)) = slope.map(|slope| (slope, wn * wn / slope)).filter(|x| x.1.is_finite()) {
        let values = vec![
            (Quantity::ControlAnticipation, cap),
            (Quantity::NaturalFrequency, wn),
            (Quantity::LoadFactorSlope, slope),
        ];
        let levels = short_period_frequency(class, category);
        let frequency = judge(Criterion::ShortPeriodFrequency, task, values, &levels);
        verdicts.push(Verdict { remark, modes: judged.to_vec(), ..frequency });
    }
    verdicts
}

/// The verdict on an oscillation that stands for the phugoid.
fn of_phugoid(mode: &Mode, task: Task) -> Verdict {
    let damping = mode.damping_ratio().map(|zeta| (Quantity::DampingRatio, zeta));
    let values = damping.into_iter().chain(time_to_double(mode)).collect();
    let verdict = judge(Criterion::Phugoid, task, values, &phugoid());
    Verdict { remark: Some(Remark::StandsFor), modes: vec![mode.naming.name], ..verdict }
}

/// Real roots that grow: of airspeed after 3.2.1.1, of pitch attitude and angle of attack after 3.2.2.2.
fn divergences(modes: &[Mode], task: Task) -> Vec<Verdict> {
    let growing = |names: &[ModeName]| {
        let grows = |mode: &&Mode| {
            !mode.is_oscillatory()
                && mode.stability == Stability::Unstable
                && names.contains(&mode.naming.name)
        };
        modes.iter().filter(grows).collect::<Vec<_>>()
    };
    let names = |modes: &[&Mode]| modes.iter().map(|mode| mode.naming.name).collect::<Vec<_>>();
    let mut verdicts = Vec::new();
    let of_pitch = growing(&[ModeName::PitchDivergence, SHORT_PERIOD[1], SHORT_PERIOD[2]]);
    if !of_pitch.is_empty() {
        let values = of_pitch.iter().filter_map(|mode| time_to_double(mode)).collect();
        let verdict = not_allowed(Criterion::PitchDivergence, task, values, Remark::PitchDiverges);
        verdicts.push(Verdict { modes: names(&of_pitch), ..verdict });
    }
    let of_speed = growing(&[ModeName::SpeedDivergence, PHUGOID[1], PHUGOID[2]]);
    // The one that doubles first
    let first = of_speed.iter().filter_map(|mode| time_to_double(mode)).min_by(|x, y| x.1.total_cmp(&y.1));
    if let Some(fastest) = first {
        let limits = vec![LEAST_TIME_TO_DOUBLE_AIRSPEED];
        let found = judge(
            Criterion::AirspeedDivergence,
            task,
            vec![fastest],
            &[limits.clone(), limits.clone(), limits],
        );
        verdicts.push(Verdict {
            level: found.level.map(|level| level.max(Level::Three)),
            governing: found.governing.map(|governing| Governing { of: Level::Three, ..governing }),
            remark: Some(Remark::AirspeedDiverges),
            modes: names(&of_speed),
            ..found
        });
    }
    verdicts
}

fn lateral(model: &PlaneModel, modes: &[Mode], task: Task) -> Vec<Verdict> {
    let Task { class, category } = task;
    let mut verdicts = Vec::new();
    let of_dutch_roll = present(modes, &DUTCH_ROLL);
    if die_away(modes, &of_dutch_roll) {
        verdicts.push(without_level(Criterion::DutchRoll, task, of_dutch_roll, Remark::NoOscillation));
    } else if let Some(motion) = second_order(modes, DUTCH_ROLL) {
        let phi_to_beta = find(modes, ModeName::DutchRoll).and_then(|mode| phi_to_beta(model, mode));
        let remark = remark_on_roots(modes, ModeName::DutchRoll);
        verdicts.push(Verdict { remark, modes: of_dutch_roll, ..yawing(motion, phi_to_beta, task) });
    } else if find(modes, ModeName::DirectionalDivergence).is_some() {
        let verdict = not_allowed(Criterion::DutchRoll, task, Vec::new(), Remark::Diverges);
        verdicts.push(Verdict { modes: vec![ModeName::DirectionalDivergence], ..verdict });
    }
    let roll = find(modes, ModeName::RollSubsidence).or(find(modes, ModeName::RollDivergence));
    let spiral_mode = find(modes, ModeName::Spiral);
    let is_apart =
        roll.is_some() || spiral_mode.is_some() || find(modes, ModeName::CoupledRollSpiral).is_some();
    for mode in modes.iter().filter(|mode| is_of_several(mode)) {
        verdicts.push(oscillation(model, mode, is_apart, task));
    }
    if let Some(mode) = roll {
        let verdict = match mode.time_constant().filter(|tau| *tau > 0.0 && tau.is_finite()) {
            Some(tau) => {
                let values = vec![(Quantity::TimeConstant, tau)];
                judge(Criterion::RollMode, task, values, &roll_mode(class, category))
            }
            None => not_allowed(Criterion::RollMode, task, Vec::new(), Remark::RollGrows),
        };
        verdicts.push(Verdict { modes: vec![mode.naming.name], ..verdict });
    }
    if let Some(mode) = spiral_mode {
        let values = time_to_double(mode).into_iter().collect();
        let verdict = judge(Criterion::Spiral, task, values, &spiral(category));
        verdicts.push(Verdict { modes: vec![ModeName::Spiral], ..verdict });
    }
    if let Some(mode) = find(modes, ModeName::CoupledRollSpiral) {
        verdicts.push(rolling(mode, task));
    }
    verdicts.extend(without_mode(
        &verdicts,
        &[Criterion::RollMode, Criterion::CoupledRollSpiral],
        modes,
        task,
    ));
    verdicts
}

/// The verdict on a lateral oscillation that has no name of its own: roots of several modes have met in it, or states beside the four.
fn oscillation(model: &PlaneModel, mode: &Mode, is_apart: bool, task: Task) -> Verdict {
    let [yaw, roll, bank] = [StateSet::SideslipAndYawRate, StateSet::RollRate, StateSet::BankAngle]
        .map(|states| states.share(&mode.participation));
    let judged = vec![mode.naming.name];
    let motion = SecondOrder::of(-2.0 * mode.lambda.re, mode.lambda.norm_sqr());
    match motion {
        // It may be no Dutch roll any more, but it is an oscillation after a disturbance in yaw, and no level lets that grow.
        _ if mode.stability == Stability::Unstable => {
            let values =
                mode.damping_ratio().map(|zeta| (Quantity::DampingRatio, zeta)).into_iter().collect();
            let verdict = not_allowed(Criterion::DutchRoll, task, values, Remark::OscillationGrows);
            Verdict { modes: judged, ..verdict }
        }
        Some(motion) if yaw >= roll && yaw >= bank => {
            let verdict = yawing(motion, phi_to_beta(model, mode), task);
            Verdict { remark: Some(Remark::StandsFor), modes: judged, ..verdict }
        }
        // Neither of the two is there by itself.
        _ if !is_apart => {
            let verdict = rolling(mode, task);
            Verdict { remark: verdict.remark.or(Some(Remark::StandsFor)), ..verdict }
        }
        _ => {
            let criterion = if roll >= bank { Criterion::RollMode } else { Criterion::Spiral };
            without_level(criterion, task, judged, Remark::NoRequirement)
        }
    }
}

/// The verdict of the requirement on oscillations in yaw.
fn yawing(motion: SecondOrder, phi_to_beta: Option<f64>, task: Task) -> Verdict {
    let SecondOrder { natural_frequency: wn, damping_ratio: zeta } = motion;
    let phi_rule = (wn * wn * phi_to_beta.unwrap_or(0.0)).min(f64::MAX);
    let mut values = vec![
        (Quantity::DampingRatio, zeta),
        (Quantity::DampingProduct, zeta * wn),
        (Quantity::NaturalFrequency, wn),
    ];
    values.extend(phi_to_beta.map(|ratio| (Quantity::RollToSideslip, ratio)));
    judge(Criterion::DutchRoll, task, values, &dutch_roll(task.class, task.category, wn, phi_rule))
}

/// The verdict on an oscillation that roll and spiral have become.
fn rolling(mode: &Mode, task: Task) -> Verdict {
    // ζωₙ = −σ
    let values = vec![(Quantity::DampingProduct, -mode.lambda.re)];
    let verdict = match coupled_roll_spiral(task.category) {
        Some(levels) => judge(Criterion::CoupledRollSpiral, task, values, &levels),
        None => not_allowed(Criterion::CoupledRollSpiral, task, values, Remark::NotAllowed),
    };
    Verdict { modes: vec![mode.naming.name], ..verdict }
}

/// Whether a mode is an oscillation in which roots of several modes have met, or states beside the four.
fn is_of_several(mode: &Mode) -> bool {
    use ModeName::{FeedbackOscillation, FurtherOscillation, LateralOscillation, ThirdOscillatory};
    matches!(
        mode.naming.name,
        LateralOscillation | ThirdOscillatory | FeedbackOscillation | FurtherOscillation
    )
}

/// That nothing was judged by any of some criteria, told of the first: the roots of its mode are in an oscillation with others.
fn without_mode(verdicts: &[Verdict], criteria: &[Criterion], modes: &[Mode], task: Task) -> Option<Verdict> {
    let is_judged = |verdict: &Verdict| verdict.level.is_some() && criteria.contains(&verdict.criterion);
    let met = || modes.iter().filter(|mode| is_of_several(mode)).map(|mode| mode.naming.name).collect();
    let criterion = criteria.first().filter(|_| !verdicts.iter().any(is_judged))?;
    Some(without_level(*criterion, task, met(), Remark::NoModeLeft))
}

/// The `names` among them that modes have.
fn present(modes: &[Mode], names: &[ModeName]) -> Vec<ModeName> {
    names.iter().copied().filter(|name| find(modes, *name).is_some()).collect()
}

/// Whether these `names` are of the two real roots that an oscillation has parted into, and neither grows.
fn die_away(modes: &[Mode], names: &[ModeName]) -> bool {
    let grows =
        |name: &ModeName| find(modes, *name).is_some_and(|mode| mode.stability == Stability::Unstable);
    names.len() == 2 && !names.iter().any(grows)
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

fn not_allowed(criterion: Criterion, task: Task, values: Vec<(Quantity, f64)>, remark: Remark) -> Verdict {
    Verdict {
        criterion,
        modes: Vec::new(),
        level: Some(Level::Beyond),
        on_boundary: false,
        values,
        governing: None,
        met_by_absence: None,
        remark: Some(remark),
        task,
    }
}

/// The verdict of a requirement that has nothing to judge.
fn without_level(criterion: Criterion, task: Task, modes: Vec<ModeName>, remark: Remark) -> Verdict {
    let verdict = not_allowed(criterion, task, Vec::new(), remark);
    Verdict { level: None, modes, ..verdict }
}

/// The best level all of whose requirements are met, and the limit that governs it.
fn judge(criterion: Criterion, task: Task, values: Vec<(Quantity, f64)>, levels: &Levels) -> Verdict {
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
        modes: Vec::new(),
        level: Some(level),
        on_boundary: level_with(-1.0) != level_with(1.0),
        governing,
        met_by_absence,
        remark: None,
        task,
        values,
    }
}

/// Half a unit of the third significant digit of a limit; of a limit of zero, 0.0005.
fn rounding(limit: f64) -> f64 {
    let size = if limit == 0.0 { 0.1 } else { limit.abs() };
    0.5 * 10_f64.powf(size.log10().floor() - 2.0)
}
