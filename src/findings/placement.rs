//! A pole is dragged: which derivatives move, how far they get it, and why no further.

use nalgebra::{Complex, Matrix4};
use thiserror::Error;

use super::Findings;
use super::sensitivities::{STILL, by_strength};
use crate::flight::modes::eigen::eigenvalues;
use crate::flight::modes::inverse::{
    Adjustable, InverseError, Linearised, OutOfReach, Placement, place_pole, place_pole_of,
};
use crate::flight::modes::locus::Poles;
use crate::flight::modes::mode::Mode;
use crate::flight::modes::mode_name::ModeName;
use crate::flight::modes::sensitivity::sensitivity;
use crate::scenario::{Page, Parameter, Scenario};

/// Nearer to the real axis than this fraction of |λ|, a pair is about to meet on it.
const ON_AXIS: f64 = 0.1;
/// Nearer to another real root than this fraction of the way that is left, the two are about to meet.
const MEETING: f64 = 0.1;
/// A value this fraction of its range from an end is at that end.
const AT_END: f64 = 1e-6;

/// Steps in which a pole is followed from where it was, and halvings of a way that it can't go to the end.
const FOLLOWED: u32 = 24;
const HALVINGS: u32 = 10;

/// The answer to a pole that is to be placed.
#[derive(Clone, Debug, PartialEq)]
pub struct Placed {
    /// The aircraft with the chosen derivatives changed, and nothing else.
    pub scenario: Scenario,
    /// Where the pole is now \[1/s\].
    pub lambda: Complex<f64>,
    /// Where it was wanted \[1/s\]; of a real root, on the real axis.
    pub wanted: Complex<f64>,
    /// Why it stopped before it was there.
    pub obstacle: Option<Obstacle>,
    /// How often the model was evaluated.
    pub evaluations: usize,
}

/// Derivatives that are negative in every aircraft: they damp a rotation or a motion across the flight.
const NEGATIVE: [&str; 14] = [
    "cm_q", "croll_p", "cn_r", "cy_beta", "m_q", "l_p", "n_r", "z_w", "y_v", "a_qq", "a_pp", "a_rr", "a_ww",
    "a_vv",
];
/// Derivatives that are positive in every aircraft: lift grows with the angle of attack, and drag holds back.
const POSITIVE: [&str; 2] = ["cl_alpha", "cd"];

/// Why a pole stops before it is where it was wanted.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum Obstacle {
    /// Sliders are at their ends.
    Ends(Vec<&'static Parameter>),
    /// Derivatives stand at zero, and no aircraft has them with the other sign.
    Sign(Vec<&'static Parameter>),
    /// The pair would come to the real axis, where it is no pair any more.
    RealAxis,
    /// The real root comes to another.
    Meeting,
    /// One derivative moves a pole along one line.
    OnePath(&'static Parameter),
    /// The nearest place.
    Nearest(Vec<&'static Parameter>),
}

/// Why nothing was tried.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum PlacementError {
    /// No derivative is chosen that this aircraft has.
    NothingChosen,
    /// No gain is chosen.
    NoGainChosen,
    /// Gains would move it, but the loop is shown open.
    ShownOpen,
    /// The chosen ones don't move it.
    NothingMoves(Vec<&'static Parameter>),
    /// The core has no answer.
    Inverse(#[from] InverseError),
}

impl Findings {
    /// Moves the parameters with these keys, as little as may be, so that the pole of `mode` comes to `target` \[1/s\], or as near as
    /// it goes. `mode` is one of this scenario in its plane.
    ///
    /// A pair stays a pair, and a real root stays on the real axis. No slider leaves its range, and no derivative takes a sign that no
    /// aircraft has; one that was typed outside may stay there. What counts as little is [`Parameter::notable_change`].
    pub fn place_pole(
        &self,
        mode: &Mode,
        target: Complex<f64>,
        keys: &[&str],
    ) -> Result<Placed, PlacementError> {
        let scenario = &self.scenario;
        let chosen: Vec<&'static Parameter> =
            keys.iter().filter_map(|key| Parameter::find(key)).filter(|p| p.applies(scenario)).collect();
        if chosen.is_empty() {
            return Err(PlacementError::NothingChosen);
        }
        let by_gains = chosen.iter().all(|parameter| parameter.is_gain());
        let is_moved = if by_gains {
            chosen.iter().any(|p| self.gain_moves(mode, p))
        } else {
            chosen.iter().any(|p| moves(scenario, mode, p))
        };
        if !is_moved {
            return Err(PlacementError::NothingMoves(chosen));
        }
        let wanted = if mode.is_oscillatory() {
            Complex::new(target.re, target.im.abs())
        } else {
            Complex::from(target.re)
        };
        let adjustable = |p: &&'static Parameter| {
            let (value, range) = (p.get(scenario), p.range(scenario));
            let (mut lower, mut upper) = (range.start().min(value), range.end().max(value));
            if NEGATIVE.contains(&p.key) && value < 0.0 {
                upper = upper.min(0.0);
            }
            if POSITIVE.contains(&p.key) && value > 0.0 {
                lower = lower.max(0.0);
            }
            Adjustable { value, lower, upper, scale: p.notable_change(scenario) }
        };
        let adjustables: Vec<Adjustable> = chosen.iter().map(adjustable).collect();
        let with = |values: &[f64]| with_values(scenario, &chosen, &adjustables, values);
        let matrix = |moved: &Scenario| Some(moved.edited.models().ok()?.planes[scenario.plane].as_ref()?.a);
        let model = &|values: &[f64]| matrix(&with(values));
        let linearised = &|values: &[f64]| {
            let moved = with(values);
            let rate = |p: &&'static Parameter| {
                p.matrix_rate(&moved.edited, moved.plane).unwrap_or_else(Matrix4::zeros)
            };
            Some(Linearised { a: matrix(&moved)?, rates: chosen.iter().map(rate).collect() })
        };
        let gained = if by_gains { self.gained(&chosen) } else { None };
        let place = |to: Complex<f64>| match &gained {
            Some(gained) => {
                place_pole_of(&|values, choice| gained.solved(values, choice), &adjustables, mode.lambda, to)
            }
            None => place_pole(linearised, &adjustables, mode.lambda, to),
        };
        let poles = &|values: &[f64]| match &gained {
            Some(gained) => gained.poles(values),
            None => eigenvalues(&model(values)?).ok().map(|poles| poles.iter().copied().collect()),
        };
        let (placement, lost) = placed_by_the_same_pole(&place, poles, &adjustables, mode.lambda, wanted)?;
        let scenario = with(&placement.values);
        let obstacle = placement
            .out_of_reach
            .and_then(|_| obstacle(&chosen, &adjustables, &placement, lost, poles(&placement.values)));
        let Placement { lambda, evaluations, .. } = placement;
        Ok(Placed { scenario, lambda, wanted, obstacle, evaluations })
    }

    /// The derivatives that a drag of a mode moves unless a person chooses others: those that a course would name. Where this
    /// aircraft's mode has no such name, the two that move it most.
    pub fn movers(&self, index: usize, page: Page) -> Vec<&'static str> {
        use ModeName as Name;
        let Some(mode) = self.flown_modes().get(index) else { return Vec::new() };
        let named: [&[&str]; 4] = match mode.naming.name {
            Name::ShortPeriod
            | Name::ShortPeriodFastRoot
            | Name::ShortPeriodSlowRoot
            | Name::PitchSubsidence
            | Name::PitchDivergence => {
                [&["cm_alpha", "cm_q"], &["m_w", "m_q"], &["a_qw", "a_qq"], &["k.alpha_de", "k.q_de"]]
            }
            Name::Phugoid | Name::PhugoidFastRoot | Name::PhugoidSlowRoot => {
                [&["cl", "cd"], &["z_u", "x_u"], &["a_wu", "a_uu"], &["k.u_de", "k.theta_de"]]
            }
            Name::DutchRoll
            | Name::DutchRollMoreStableRoot
            | Name::DutchRollLessStableRoot
            | Name::SideslipSubsidence
            | Name::DirectionalDivergence => {
                [&["cn_beta", "cn_r"], &["n_v", "n_r"], &["a_rv", "a_rr"], &["k.beta_dr", "k.r_dr"]]
            }
            Name::RollSubsidence | Name::RollDivergence => [&["croll_p"], &["l_p"], &["a_pp"], &["k.p_da"]],
            Name::Spiral => [&["croll_beta", "cn_r"], &["l_v", "n_r"], &["a_pv", "a_rr"], &["k.phi_da"]],
            Name::ThirdOscillatory
            | Name::SpeedSubsidence
            | Name::SpeedDivergence
            | Name::CoupledRollSpiral
            | Name::LateralOscillation
            | Name::LateralSubsidence
            | Name::LateralDivergence
            | Name::Height
            | Name::Heading
            | Name::Washout
            | Name::ElevatorActuator
            | Name::Engine
            | Name::AileronActuator
            | Name::RudderActuator
            | Name::Position
            | Name::FeedbackOscillation
            | Name::FurtherState
            | Name::FurtherOscillation => [&[], &[], &[], &[]],
        };
        let named = named[page as usize];
        let mut all = by_strength(self.sensitivities(page), index);
        // What a drag of a pole chooses is gains, not the filters on their way.
        all.retain(|key| Parameter::find(key).is_some_and(|parameter| !parameter.is_filter()));
        let known: Vec<&'static str> = all.iter().copied().filter(|key| named.contains(key)).collect();
        if known.is_empty() { all.into_iter().take(2).collect() } else { known }
    }
}

fn moves(scenario: &Scenario, mode: &Mode, parameter: &Parameter) -> bool {
    let Some(a_rate) = parameter.matrix_rate(&scenario.edited, scenario.plane) else { return false };
    let size = mode.lambda.norm().max(f64::MIN_POSITIVE);
    // Where two roots meet there is no rate, and every change moves them.
    sensitivity(mode, &a_rate)
        .rate()
        .is_none_or(|rate| rate.lambda.norm() * parameter.notable_change(scenario) > STILL * size)
}

/// A scenario with parameters at other values than their present ones.
fn with_values(
    scenario: &Scenario,
    parameters: &[&'static Parameter],
    present: &[Adjustable],
    values: &[f64],
) -> Scenario {
    let mut moved = scenario.clone();
    for (p, (before, value)) in parameters.iter().zip(present.iter().zip(values)) {
        if *value != before.value {
            p.shift(&mut moved, before.value, *value);
        }
    }
    moved
}

/// The placement, if it is the pole at `from` that has come there. Where that pole would have to part or meet another on the way,
/// and it is another one that the search has found, the farthest place towards `wanted` that it does come to, and true.
fn placed_by_the_same_pole(
    place: &dyn Fn(Complex<f64>) -> Result<Placement, InverseError>,
    poles: &dyn Fn(&[f64]) -> Option<Poles>,
    adjustables: &[Adjustable],
    from: Complex<f64>,
    wanted: Complex<f64>,
) -> Result<(Placement, bool), InverseError> {
    let followed = |placement: &Placement| {
        let end = follow(poles, adjustables, &placement.values, from);
        end.is_some_and(|end| (end - placement.lambda).norm() <= 1e-6 * placement.lambda.norm())
    };
    let whole = place(wanted)?;
    if followed(&whole) {
        return Ok((whole, false));
    }
    let (mut kept, mut reached, mut lost) = (place(from)?, 0.0, 1.0);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (reached + lost);
        let tried = place(from + (wanted - from) * middle)?;
        if followed(&tried) {
            (kept, reached) = (tried, middle);
        } else {
            lost = middle;
        }
    }
    // What is told is of the whole way.
    let out_of_reach = whole.out_of_reach.or(Some(OutOfReach::Both));
    Ok((Placement { wanted: whole.wanted, out_of_reach, ..kept }, true))
}

/// Where the pole at `from` goes while the parameters go straight to `values`; `None` where it leaves or meets the real axis.
fn follow(
    poles: &dyn Fn(&[f64]) -> Option<Poles>,
    adjustables: &[Adjustable],
    values: &[f64],
    from: Complex<f64>,
) -> Option<Complex<f64>> {
    let mut here = from;
    for k in 1..=FOLLOWED {
        let t = f64::from(k) / f64::from(FOLLOWED);
        let between: Vec<f64> =
            adjustables.iter().zip(values).map(|(p, end)| p.value + t * (end - p.value)).collect();
        let distance = |pole: &Complex<f64>| (pole - here).norm();
        let poles = poles(&between)?;
        let upper = poles.iter().copied().filter(|pole| pole.im >= 0.0);
        let next = upper.min_by(|a, b| distance(a).total_cmp(&distance(b)))?;
        if (next.im > 0.0) != (from.im > 0.0) {
            return None;
        }
        here = next;
    }
    Some(here)
}

/// What keeps the pole from the target; `None` if nothing worth a word does: it is there to four digits. `lost` says that
/// another pole would have come nearer, `poles` are all, with the pole where it came to.
fn obstacle(
    chosen: &[&'static Parameter],
    adjustables: &[Adjustable],
    placement: &Placement,
    lost: bool,
    poles: Option<Poles>,
) -> Option<Obstacle> {
    let Placement { values, lambda, wanted, .. } = placement;
    let left = (wanted - lambda).norm();
    if left <= 1e-4 * lambda.norm() {
        return None;
    }
    let pair = lambda.im > 0.0;
    let near_axis = lambda.im <= ON_AXIS * lambda.norm() && wanted.im <= lambda.im;
    if pair && (lost || near_axis) {
        return Some(Obstacle::RealAxis);
    }
    let gap = poles.and_then(|poles| gap_to_real_root(&poles, *lambda));
    if !pair && (lost || gap.is_some_and(|gap| gap < MEETING * left)) {
        return Some(Obstacle::Meeting);
    }
    let is_at_end = |(_, (value, p)): &(&&'static Parameter, (&f64, &Adjustable))| {
        let near = AT_END * (p.upper - p.lower);
        **value - p.lower <= near || p.upper - **value <= near
    };
    let all = chosen.iter().zip(values.iter().zip(adjustables));
    let ends: Vec<&'static Parameter> = all.filter(is_at_end).map(|(p, _)| *p).collect();
    let all = chosen.iter().zip(values.iter().zip(adjustables));
    let signs: Vec<&'static Parameter> = all
        .filter(|(p, (value, of))| {
            let one_sided = NEGATIVE.contains(&p.key) || POSITIVE.contains(&p.key);
            one_sided && value.abs() <= AT_END * (of.upper - of.lower)
        })
        .map(|(p, _)| *p)
        .collect();
    Some(match chosen {
        _ if !signs.is_empty() => Obstacle::Sign(signs),
        _ if !ends.is_empty() => Obstacle::Ends(ends),
        [only] if pair => Obstacle::OnePath(only),
        _ => Obstacle::Nearest(chosen.to_vec()),
    })
}

/// Distance from a real root to the nearest other one.
fn gap_to_real_root(poles: &Poles, lambda: Complex<f64>) -> Option<f64> {
    let real = poles.iter().filter(|other| other.im == 0.0);
    let mut gaps: Vec<f64> = real.map(|other| (other.re - lambda.re).abs()).collect();
    gaps.sort_by(f64::total_cmp);
    // The first is the root itself.
    gaps.get(1).copied()
}
