//! Root locus: the path of all poles as one parameter goes through its range.
//!
//! Poles are followed from sample to sample, and solved for anew where two meet. Samples are set where the poles move most, and
//! branches are followed by matching each set of poles to the next as a whole, so that a branch goes through a meeting of two poles
//! without a jump.

use std::collections::BinaryHeap;

use nalgebra::{Complex, Matrix4};
use smallvec::SmallVec;

use super::eigen::eigenvalues;
use super::mode::modes_of;
use super::mode_name::ModeName;
use super::quartic::roots_near;
use crate::flight::aircraft::plane::Plane;

/// The most evaluations of the model that one locus may take.
pub const MOST_EVALUATIONS: usize = 200;

/// Evaluations on the even grid that adaptive sampling starts from.
const FIRST_EVALUATIONS: usize = 25;

/// A step of a pole is fine enough below this fraction of its own |λ| …
const FINE_STEP: f64 = 0.1;

/// … or of this fraction of the largest |λ| on the locus, where the pole is near zero.
const NEAR_ZERO: f64 = 2e-3;

/// Two neighbouring samples are never set closer than this fraction of the range.
const CLOSEST: f64 = 2e-5;

/// Poles, one a branch.
pub type Poles = SmallVec<[Complex<f64>; 4]>;

/// The poles at one value of the parameter.
#[derive(Clone, Debug, PartialEq)]
pub struct Sample {
    /// The parameter p.
    pub parameter: f64,
    /// The poles \[1/s\]; `None` where the model can't be had.
    pub poles: Option<Poles>,
}

/// The paths of the poles: four, and as many more as a law of feedback has states.
#[derive(Clone, Debug, PartialEq)]
pub struct Locus {
    /// By rising parameter; `poles[b]` is branch b in every sample. A branch starts anew behind a gap.
    pub samples: Vec<Sample>,
    /// The mode that each branch belongs to at the reference value; `None` if the model can't be had there.
    pub names: SmallVec<[Option<ModeName>; 4]>,
    /// Intervals of p in which poles meet: the number of oscillations changes between the two ends.
    pub meetings: Vec<(f64, f64)>,
    /// How often the model was evaluated.
    pub evaluations: usize,
}

/// The locus of `model` over `range` (ends in either order), named after the modes at `reference`.
///
/// `model` gives A for a value of the parameter, or `None` where there is no such aircraft. It is called `most` times at most,
/// itself held between 30 and [`MOST_EVALUATIONS`]; 60 draw a picture, 200 find meetings to 2·10⁻⁵ of the range. A range that is not
/// finite gives an empty locus.
pub fn locus(
    plane: Plane,
    model: impl Fn(f64) -> Option<Matrix4<f64>>,
    range: (f64, f64),
    reference: f64,
    most: usize,
) -> Locus {
    let poles = |parameter: f64, near: Option<&Poles>| poles_near(&model(parameter)?, near);
    let named = |parameter: f64| {
        let modes = modes_of(plane, &model(parameter)?).ok()?;
        Some(modes.iter().map(|mode| (mode.lambda, mode.naming.name)).collect())
    };
    locus_of(&poles, &named, range, reference, most)
}

/// Where each mode is, and what it is called.
pub type NamedPoles = Vec<(Complex<f64>, ModeName)>;

/// The same of any model, by its poles: as many at every value of the parameter. `poles` may take those at a value near by for a guess,
/// `named` gives the modes at the reference value.
pub fn locus_of(
    poles: &dyn Fn(f64, Option<&Poles>) -> Option<Poles>,
    named: &dyn Fn(f64) -> Option<NamedPoles>,
    range: (f64, f64),
    reference: f64,
    most: usize,
) -> Locus {
    // One is kept for the names.
    let most = most.clamp(30, MOST_EVALUATIONS) - 1;
    let (low, high) = (range.0.min(range.1), range.0.max(range.1));
    let width = high - low;
    let mut locus =
        Locus { samples: Vec::new(), names: SmallVec::from([None; 4]), meetings: Vec::new(), evaluations: 0 };
    if !(range.0.is_finite() && range.1.is_finite() && width.is_finite()) {
        return locus;
    }
    let evaluate = |parameter: f64, neighbour: Option<&Sample>| {
        let near = neighbour.and_then(|sample| sample.poles.as_ref());
        Sample { parameter, poles: poles(parameter, near) }
    };
    let last = (FIRST_EVALUATIONS - 1) as f64;
    let mut first: Vec<f64> = (0..FIRST_EVALUATIONS).map(|k| low + width * (k as f64 / last)).collect();
    if (low..=high).contains(&reference) {
        first.push(reference);
    }
    first.sort_by(f64::total_cmp);
    first.dedup();
    let mut samples: Vec<Sample> = Vec::with_capacity(most);
    for parameter in first {
        samples.push(evaluate(parameter, samples.last()));
    }

    // Halve the interval with the largest step until all are fine or the bound is reached.
    let all = samples.iter().filter_map(|sample| sample.poles.as_ref()).flatten();
    let radius = all.map(|pole| size(*pole)).fold(0.0, f64::max);
    let interval = |samples: &[Sample], low: usize, high: usize| {
        let (a, b) = (&samples[low], &samples[high]);
        let is_closest = b.parameter - a.parameter <= CLOSEST * width;
        let step = if is_closest { 0.0 } else { coarseness(a, b, radius) };
        // Numbers that are not negative have the order of their bits.
        (step.to_bits(), low, high)
    };
    let mut intervals: BinaryHeap<(u64, usize, usize)> =
        (1..samples.len()).map(|k| interval(&samples, k - 1, k)).collect();
    while let Some((step, low, high)) = intervals.pop() {
        let middle = 0.5 * samples[low].parameter + 0.5 * samples[high].parameter;
        let is_between = samples[low].parameter < middle && middle < samples[high].parameter;
        if samples.len() >= most || f64::from_bits(step) <= FINE_STEP || !is_between {
            break;
        }
        let new = samples.len();
        samples.push(evaluate(middle, samples.get(low)));
        intervals.push(interval(&samples, low, new));
        intervals.push(interval(&samples, new, high));
    }
    samples.sort_by(|a, b| a.parameter.total_cmp(&b.parameter));

    follow(&mut samples);
    locus.evaluations = samples.len();
    locus.meetings = samples.windows(2).filter_map(|pair| meeting(&pair[0], &pair[1])).collect();
    let at_reference = samples.iter().find(|s| s.parameter == reference).and_then(|s| s.poles.as_ref());
    let modes = named(reference);
    locus.evaluations += 1;
    if let (Some(poles), Some(modes)) = (at_reference, modes) {
        // Equal matrices have equal poles, so that the nearest is the same one.
        let name = |pole: &Complex<f64>| {
            let distance = |lambda: Complex<f64>| (lambda - pole).norm().min((lambda.conj() - pole).norm());
            modes.iter().min_by(|x, y| distance(x.0).total_cmp(&distance(y.0))).map(|(_, name)| *name)
        };
        locus.names = poles.iter().map(name).collect();
    } else if let Some(some) = samples.iter().find_map(|sample| sample.poles.as_ref()) {
        locus.names = SmallVec::from_elem(None, some.len());
    }
    locus.samples = samples;
    locus
}

/// The poles of a model that is not far from one with poles `near`, or from nothing; the solver's where following them fails.
fn poles_near(a: &Matrix4<f64>, near: Option<&Poles>) -> Option<Poles> {
    let near: Option<[Complex<f64>; 4]> = near.and_then(|near| near.as_slice().try_into().ok());
    let followed = near.and_then(|near| roots_near(a, &near));
    followed.or_else(|| eigenvalues(a).ok().map(Into::into)).map(Poles::from)
}

/// |z| without a care for overflow, several times as fast as `norm`: poles beyond 10¹⁵⁰ are matched in the order they have.
fn size(z: Complex<f64>) -> f64 {
    z.norm_sqr().sqrt()
}

fn pairs(poles: &Poles) -> usize {
    poles.iter().filter(|pole| pole.im > 0.0).count()
}

fn meeting(a: &Sample, b: &Sample) -> Option<(f64, f64)> {
    let (before, after) = (a.poles.as_ref()?, b.poles.as_ref()?);
    (pairs(before) != pairs(after)).then_some((a.parameter, b.parameter))
}

/// How far the poles go from one sample to the next, in units of their own size; large where poles meet or the model ends.
fn coarseness(a: &Sample, b: &Sample, radius: f64) -> f64 {
    match (&a.poles, &b.poles) {
        (Some(from), Some(to)) => {
            let order = matched(from, to);
            let step = |(x, j): (&Complex<f64>, usize)| {
                let (x, y) = (*x, to[j]);
                // 2|λ − λ'|/(|λ| + |λ'|), and no finer near zero than a 500th of the picture
                size(y - x) / (0.5 * (size(x) + size(y))).max(NEAR_ZERO * radius).max(f64::MIN_POSITIVE)
            };
            let step = from.iter().zip(order).map(step).fold(0.0, f64::max);
            if pairs(from) == pairs(to) { step } else { step.max(2.0 * FINE_STEP) }
        }
        (None, None) => 0.0,
        // The edge of what is possible is worth finding, after the rest is smooth.
        _ => 1.5 * FINE_STEP,
    }
}

/// Puts the poles of every sample into the order of the branches.
fn follow(samples: &mut [Sample]) {
    let mut before: Option<Poles> = None;
    for sample in samples {
        if let (Some(from), Some(to)) = (&before, &sample.poles) {
            sample.poles = Some(matched(from, to).into_iter().map(|j| to[j]).collect());
        }
        before.clone_from(&sample.poles);
    }
}

/// The order of `to` that makes the sum of the distances from `from` least: `to[order[i]]` continues `from[i]`.
///
/// Of four all 24 orders are tried. Among equals (a pair parting into two real roots) the first wins. Of more the nearest are taken first.
fn matched(from: &Poles, to: &Poles) -> SmallVec<[usize; 4]> {
    match (<[Complex<f64>; 4]>::try_from(from.as_slice()), <[Complex<f64>; 4]>::try_from(to.as_slice())) {
        (Ok(from), Ok(to)) => SmallVec::from(matched_four(&from, &to)),
        _ => nearest_first(from, to),
    }
}

fn nearest_first(from: &Poles, to: &Poles) -> SmallVec<[usize; 4]> {
    let mut order: SmallVec<[usize; 4]> = SmallVec::from_elem(usize::MAX, from.len());
    let mut taken: SmallVec<[bool; 8]> = SmallVec::from_elem(false, to.len());
    for _ in 0..from.len().min(to.len()) {
        let (mut least, mut best) = (f64::INFINITY, (0, 0));
        for (i, x) in from.iter().enumerate().filter(|(i, _)| order[*i] == usize::MAX) {
            for (j, y) in to.iter().enumerate().filter(|(j, _)| !taken[*j]) {
                let distance = size(y - x);
                if distance < least || least == f64::INFINITY {
                    (least, best) = (distance, (i, j));
                }
            }
        }
        order[best.0] = best.1;
        taken[best.1] = true;
    }
    // All models of a locus have as many poles.
    order.retain(|j| *j < to.len());
    order
}

fn matched_four(from: &[Complex<f64>; 4], to: &[Complex<f64>; 4]) -> [usize; 4] {
    let distance: [[f64; 4]; 4] = std::array::from_fn(|i| std::array::from_fn(|j| size(to[j] - from[i])));
    let (mut best, mut least) = ([0, 1, 2, 3], f64::INFINITY);
    for a in 0..4 {
        for b in (0..4).filter(|&b| b != a) {
            for c in (0..4).filter(|&c| c != a && c != b) {
                let d = 6 - a - b - c;
                let sum = distance[0][a] + distance[1][b] + distance[2][c] + distance[3][d];
                if sum < least {
                    (best, least) = ([a, b, c, d], sum);
                }
            }
        }
    }
    best
}
