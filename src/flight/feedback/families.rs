//! Where each root under a law comes from: the roots of the aircraft and of the law apart, followed as all gains rise together from
//! zero to what they are, and with them what the further states of a source do to the four.
//!
//! Under a law shapes mix. A turn fills the washout, a fast actuator lends a damper its phase, and participation alone would call
//! the slow turn of a spiral now this and now that. What a course calls the spiral then is the root that the spiral has gone to, so that
//! is followed here. Where two real roots meet, the pair is of both, and where they part again each takes the side on which it was; what
//! has gone astray by that is set right by the shapes (`loop_modes`).

use nalgebra::{Complex, DMatrix};

use crate::flight::modes::eigen::EigenError;
use crate::flight::modes::eigen::eigenvalues;
use crate::flight::modes::mode::Mode;
use crate::flight::modes::mode_name::ModeName;
use crate::flight::modes::reason::StateSet;

/// What a root is of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Family {
    ShortPeriod,
    Phugoid,
    DutchRoll,
    Roll,
    Spiral,
    /// Of several lateral states, and of none of the families.
    Lateral,
    /// Of the appended state at this place behind the four.
    Appended(usize),
}

impl Family {
    /// The families of the roots of a mode of the aircraft alone, the further left first.
    fn of(name: ModeName) -> [Self; 2] {
        use ModeName as Name;
        match name {
            Name::ShortPeriod
            | Name::ShortPeriodFastRoot
            | Name::ShortPeriodSlowRoot
            | Name::PitchSubsidence
            | Name::PitchDivergence => [Self::ShortPeriod; 2],
            Name::ThirdOscillatory => [Self::ShortPeriod, Self::Phugoid],
            Name::Phugoid
            | Name::PhugoidFastRoot
            | Name::PhugoidSlowRoot
            | Name::SpeedSubsidence
            | Name::SpeedDivergence => [Self::Phugoid; 2],
            Name::DutchRoll
            | Name::DutchRollMoreStableRoot
            | Name::DutchRollLessStableRoot
            | Name::SideslipSubsidence
            | Name::DirectionalDivergence => [Self::DutchRoll; 2],
            Name::CoupledRollSpiral => [Self::Roll, Self::Spiral],
            Name::LateralOscillation => [Self::DutchRoll, Self::Lateral],
            Name::RollSubsidence | Name::RollDivergence => [Self::Roll; 2],
            Name::Spiral => [Self::Spiral; 2],
            Name::LateralSubsidence
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
            | Name::FurtherOscillation => [Self::Lateral; 2],
        }
    }
}

impl Family {
    /// The share of its states in a mode, from the participation of all.
    pub fn share(self, participation: &[f64]) -> f64 {
        let Some(four) = participation.first_chunk::<4>() else { return 0.0 };
        match self {
            Self::ShortPeriod => StateSet::AngleOfAttackAndPitchRate.share(four),
            Self::Phugoid => StateSet::SpeedAndPitchAngle.share(four),
            Self::DutchRoll => StateSet::SideslipAndYawRate.share(four),
            Self::Roll => StateSet::RollRate.share(four),
            Self::Spiral => StateSet::BankAngle.share(four),
            Self::Lateral => StateSet::LateralMix.share(four),
            Self::Appended(k) => participation.get(4 + k).copied().unwrap_or(0.0),
        }
    }
}

/// A root and what it is of. Of a pair, the upper root has the family that was further left before the two met.
pub(super) type Root = (Complex<f64>, Family);

/// First and longest step, as fractions of the gains.
const FIRST_STEP: f64 = 1.0 / 64.0;
const LONGEST_STEP: f64 = 1.0 / 16.0;
/// A step is short enough where every root is so much nearer to its own past than to another's …
const NEARER: f64 = 0.35;
/// … or where it is this short: roots are meeting.
const SHORTEST_STEP: f64 = 1e-4;
/// Roots that move by less than this fraction of the largest don't move.
const STILL: f64 = 1e-9;

/// The roots of `apart` + `back`, each followed from the root of `apart` that it comes from: one of the `open` modes of the aircraft, or
/// one of the appended states, which stand behind the four with their own roots on the diagonal.
pub(super) fn followed(
    open: &[Mode],
    apart: &DMatrix<f64>,
    back: &DMatrix<f64>,
) -> Result<Vec<Root>, EigenError> {
    let mut roots: Vec<Root> = Vec::with_capacity(apart.nrows());
    for mode in open {
        let [left, right] = Family::of(mode.naming.name);
        roots.push((mode.lambda, left));
        if mode.is_oscillatory() {
            roots.push((mode.lambda.conj(), right));
        }
    }
    let of_state = |k: usize| (Complex::from(apart[(k, k)]), Family::Appended(k - 4));
    roots.extend((4..apart.nrows()).map(of_state));
    let (mut done, mut step) = (0.0, FIRST_STEP);
    while done < 1.0 {
        let next = if done + step >= 1.0 - 1e-12 { 1.0 } else { done + step };
        let values = eigenvalues(&(apart + back * next))?;
        let (matched, is_sure) = matched(&roots, values.as_slice());
        if is_sure || step <= SHORTEST_STEP {
            roots = matched;
            done = next;
            if is_sure {
                step = (2.0 * step).min(LONGEST_STEP);
            }
        } else {
            step = (0.5 * step).max(SHORTEST_STEP);
        }
    }
    Ok(roots)
}

/// The values with the families of the roots that they continue, nearest first, and whether none could be of another.
fn matched(roots: &[Root], values: &[Complex<f64>]) -> (Vec<Root>, bool) {
    let n = roots.len();
    let radius = values.iter().map(|value| value.norm()).fold(0.0, f64::max);
    let mut near: Vec<(f64, usize, usize)> = (0..n)
        .flat_map(|i| (0..n).map(move |j| (i, j)))
        .map(|(i, j)| ((values[j] - roots[i].0).norm(), i, j))
        .collect();
    near.sort_by(|x, y| x.0.total_cmp(&y.0));
    let (mut from, mut taken) = (vec![None; n], vec![false; n]);
    for &(_, i, j) in &near {
        if from[j].is_none() && !taken[i] {
            (from[j], taken[i]) = (Some(i), true);
        }
    }
    let mut sources: Vec<usize> = from.into_iter().flatten().collect();
    let is_sure = (0..n).all(|j| {
        let moved = (values[j] - roots[sources[j]].0).norm();
        let others = (0..n).filter(|&i| i != sources[j] && roots[i].1 != roots[sources[j]].1);
        let next = others.map(|i| (values[j] - roots[i].0).norm()).fold(f64::INFINITY, f64::min);
        moved <= STILL * radius || moved <= NEARER * next
    });
    keep_sides(roots, values, &mut sources);
    let continued = values.iter().zip(&sources).map(|(value, &i)| (*value, roots[i].1)).collect();
    (continued, is_sure)
}

/// Where two real roots have become a pair, the left one goes to the upper; where a pair has become two, the upper one to the left.
fn keep_sides(roots: &[Root], values: &[Complex<f64>], sources: &mut [usize]) {
    for j in 0..values.len() {
        let source = roots[sources[j]].0;
        if values[j].im > 0.0 {
            let Some(lower) = values.iter().position(|value| *value == values[j].conj()) else { continue };
            let other = roots[sources[lower]].0;
            let crossed = source.im < 0.0 && other.im > 0.0;
            let met = source.im == 0.0 && other.im == 0.0 && source.re > other.re;
            if crossed || met {
                sources.swap(j, lower);
            }
        } else if values[j].im == 0.0 && source.im > 0.0 {
            let partner =
                (0..values.len()).find(|&k| values[k].im == 0.0 && roots[sources[k]].0 == source.conj());
            if let Some(k) = partner.filter(|&k| values[k].re < values[j].re) {
                sources.swap(j, k);
            }
        }
    }
}
