//! The straight way from one aircraft to another, and the part of each derivative in what changes along it.
//!
//! With p(s) = p₀ + s Δp, Δλ = ∫₀¹ dλ/ds ds = Σ ∫₀¹ (∂λ/∂pᵢ) Δpᵢ ds: exact sensitivities, integrated, add up to the change. No
//! derivative comes first or last. ωₙ and ζ of a pair are smooth even where its two roots meet on the real axis.

use nalgebra::Matrix4;

use super::subject::{Moved, Subject, find};
use crate::flight::aircraft::aircraft_model::{AircraftModel, DerivativeModel};
use crate::flight::aircraft::edits::{EditedModel, MatrixOffsets, Offsets};
use crate::flight::aircraft::plane::{Plane, PlaneModel};
use crate::flight::aircraft::real::{Dual64, Record as _, seeded};
use crate::flight::modes::mode::{Mode, modes};
use crate::flight::modes::second_order::{SecondOrder, second_order};
use crate::flight::modes::sensitivity::sensitivity;
use crate::scenario::{Page, Parameter, Scenario, parameters};

/// Key of Ixz/Ix, which no slider sets by itself.
pub const IXZ_OVER_IX: &str = "ixz_over_ix";
/// Key of Ixz/Iz.
pub const IXZ_OVER_IZ: &str = "ixz_over_iz";

/// Places and weights of Gauss and Legendre on −1 to 1, the negative half (Abramowitz & Stegun, table 25.4, n = 8).
const NODES: [(f64, f64); 4] = [
    (0.183_434_642_495_649_8, 0.362_683_783_378_362),
    (0.525_532_409_916_329, 0.313_706_645_877_887_3),
    (0.796_666_477_413_626_7, 0.222_381_034_453_374_5),
    (0.960_289_856_497_536_3, 0.101_228_536_290_376_3),
];

/// The way is cut into one, two and at most so many pieces: more are of use only next to where roots of two modes meet.
const MOST_PIECES: usize = 4;

/// Parts that miss the change by more than this fraction of it are none.
const MISSED: f64 = 1e-3;
/// Nor by this fraction of the number itself, which is rounding.
const ROUNDING: f64 = 1e-9;

/// The part of one derivative in the change of a mode.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Part {
    pub moved: Moved,
    /// In Δωₙ \[rad/s\].
    pub frequency: f64,
    /// In Δζ.
    pub damping_ratio: f64,
    /// In Δλ of a real root \[1/s\].
    pub root: f64,
}

/// One a subject; `None` where the way leads through a place at which it is no such mode.
pub(super) fn parts_along(from: &Scenario, to: &Scenario, subjects: &[Subject]) -> Vec<Option<Vec<Part>>> {
    let nothing = || vec![None; subjects.len()];
    let Some(path) = Path::between(from, to) else { return nothing() };
    let (Some(before), Some(after)) = (path.modes(0.0), path.modes(1.0)) else { return nothing() };
    let changes: Vec<Option<[Numbers; 2]>> =
        subjects.iter().map(|subject| Some([subject.numbers(&before)?, subject.numbers(&after)?])).collect();
    let mut found = nothing();
    let mut open: Vec<usize> = (0..subjects.len()).filter(|&k| changes[k].is_some()).collect();
    let mut pieces = 1;
    while pieces <= MOST_PIECES && !open.is_empty() {
        let asked: Vec<Subject> = open.iter().map(|&k| subjects[k]).collect();
        let sums = path.integrate(&asked, pieces);
        let mut left = Vec::new();
        for (k, sum) in open.into_iter().zip(sums) {
            // Where it is no such mode on the way, smaller pieces are of no use.
            if let (Some(change), Some(sum)) = (changes[k], sum) {
                found[k] = path.proved(&sum, change);
                left.extend(found[k].is_none().then_some(k));
            }
        }
        open = left;
        pieces *= 2;
    }
    found
}

/// ωₙ and ζ of a pair, or λ of a root twice: what is followed, and likewise its rates.
type Numbers = [f64; 2];

impl Subject {
    fn numbers(self, modes: &[Mode]) -> Option<Numbers> {
        match self {
            Self::Pair(family) => {
                let SecondOrder { natural_frequency, damping_ratio } = second_order(modes, family)?;
                Some([natural_frequency, damping_ratio])
            }
            Self::Root(name) => find(modes, name).map(|mode| [mode.lambda.re; 2]),
        }
    }

    fn rates(self, modes: &[Mode], a_rate: &Matrix4<f64>) -> Option<Numbers> {
        let moved = |mode: &Mode| sensitivity(mode, a_rate).rate().map(|rate| rate.lambda);
        match self {
            Self::Root(name) => find(modes, name).and_then(moved).map(|rate| [rate.re; 2]),
            Self::Pair(family) => {
                let [wn, zeta] = self.numbers(modes)?;
                // d = 2ζωₙ = −(λ₁ + λ₂),  k = ωₙ² = λ₁λ₂
                let (d_rate, k_rate) = if let Some(mode) = find(modes, family[0]) {
                    let rate = moved(mode)?;
                    (-2.0 * rate.re, 2.0 * (mode.lambda.conj() * rate).re)
                } else {
                    let [one, two] = [find(modes, family[1])?, find(modes, family[2])?];
                    let [one_rate, two_rate] = [moved(one)?.re, moved(two)?.re];
                    (-(one_rate + two_rate), one_rate * two.lambda.re + one.lambda.re * two_rate)
                };
                // ωₙ = √k,  ζ = d/(2ωₙ)
                let wn_rate = k_rate / (2.0 * wn);
                Some([wn_rate, (d_rate / 2.0 - zeta * wn_rate) / wn])
            }
        }
    }
}

/// The straight way.
struct Path {
    plane: Plane,
    ends: [EditedModel; 2],
    movers: Vec<Mover>,
}

/// A number that moves along the way.
struct Mover {
    moved: Moved,
    /// The change of p along the whole way, in the sense of ∂A/∂p.
    change: f64,
    of: Of,
}

enum Of {
    Parameter(&'static Parameter),
    Speed,
    PathAngle,
    IxzOverIx,
    IxzOverIz,
}

impl Path {
    fn between(from: &Scenario, to: &Scenario) -> Option<Self> {
        let plane = to.plane;
        let ends = [end(from)?, end(to)?];
        let mut movers: Vec<Mover> = parameters().filter_map(|p| moved_parameter(p, from, to)).collect();
        if let [AircraftModel::Derivatives(before), AircraftModel::Derivatives(after)] =
            ends.each_ref().map(|end| &end.aircraft_model)
        {
            let mut add = |key: &'static str, of: Of, from: f64, to: f64| {
                if from != to {
                    movers.push(Mover { moved: Moved { key, from, to }, change: to - from, of });
                }
            };
            add("speed", Of::Speed, before.trim.speed, after.trim.speed);
            add("gamma", Of::PathAngle, before.trim.gamma0, after.trim.gamma0);
            if let (Plane::Lateral, Some(before), Some(after)) = (plane, before.lateral, after.lateral) {
                add(IXZ_OVER_IX, Of::IxzOverIx, before.ixz_over_ix, after.ixz_over_ix);
                add(IXZ_OVER_IZ, Of::IxzOverIz, before.ixz_over_iz, after.ixz_over_iz);
            }
        }
        Some(Self { plane, ends, movers })
    }

    /// The aircraft at a place of the way, 0 to 1.
    fn at(&self, s: f64) -> Option<EditedModel> {
        let [from, to] = &self.ends;
        let line = |a: f64, b: f64| a + s * (b - a);
        let offsets = |plane: Plane| {
            let [from, to] = [from, to].map(|end| &end.offsets.matrices[plane]);
            MatrixOffsets { a: from.a + (to.a - from.a) * s, b: from.b }
        };
        let mut matrices = Offsets::default();
        matrices.matrices[self.plane] = offsets(self.plane);
        let aircraft_model = match (&from.aircraft_model, &to.aircraft_model) {
            (AircraftModel::Derivatives(from), AircraftModel::Derivatives(to)) => {
                let mut at = from.clone();
                at.trim.speed = line(from.trim.speed, to.trim.speed);
                at.trim.gamma0 = line(from.trim.gamma0, to.trim.gamma0);
                at.longitudinal =
                    from.longitudinal.zip(to.longitudinal).map(|(from, to)| from.zip(&to, line));
                at.lateral = from.lateral.zip(to.lateral).map(|(from, to)| from.zip(&to, line));
                AircraftModel::Derivatives(at)
            }
            (AircraftModel::Matrices(from), AircraftModel::Matrices(_)) => {
                AircraftModel::Matrices(from.clone())
            }
            _ => return None,
        };
        Some(EditedModel { aircraft_model, offsets: matrices })
    }

    fn modes(&self, s: f64) -> Option<Vec<Mode>> {
        modes_of(&self.at(s)?, self.plane)
    }

    /// The integrals of the rates of each subject by each mover.
    fn integrate(&self, subjects: &[Subject], pieces: usize) -> Vec<Option<Vec<Numbers>>> {
        let mut sums = vec![Some(vec![[0.0; 2]; self.movers.len()]); subjects.len()];
        let width = 1.0 / pieces as f64;
        let nodes = NODES.iter().flat_map(|&(x, weight)| [(-x, weight), (x, weight)]);
        for (piece, (x, weight)) in (0..pieces).flat_map(|piece| nodes.clone().map(move |node| (piece, node)))
        {
            let s = width * (piece as f64 + 0.5 + 0.5 * x);
            let here = self.at(s).and_then(|here| Some((modes_of(&here, self.plane)?, here)));
            let Some((modes, here)) = here else { return vec![None; subjects.len()] };
            if sums.iter().all(Option::is_none) {
                break;
            }
            for (k, mover) in self.movers.iter().enumerate() {
                let rate = mover.a_rate(&here, self.plane);
                for (subject, sum) in subjects.iter().zip(&mut sums) {
                    let rates = rate.as_ref().and_then(|rate| subject.rates(&modes, rate));
                    match (rates, sum.as_mut()) {
                        (Some(rates), Some(sum)) => {
                            for (sum, rate) in sum[k].iter_mut().zip(rates) {
                                *sum += 0.5 * width * weight * rate * mover.change;
                            }
                        }
                        _ => *sum = None,
                    }
                }
            }
        }
        sums
    }

    /// Parts that add up to the change.
    fn proved(&self, sums: &[Numbers], [before, after]: [Numbers; 2]) -> Option<Vec<Part>> {
        for k in 0..2 {
            let missed = sums.iter().map(|sum| sum[k]).sum::<f64>() - (after[k] - before[k]);
            let size = before[k].abs() + after[k].abs();
            let allowed = MISSED * (after[k] - before[k]).abs() + ROUNDING * size;
            if missed.is_nan() || missed.abs() > allowed {
                return None;
            }
        }
        let part = |(mover, &[one, two]): (&Mover, &Numbers)| Part {
            moved: mover.moved,
            frequency: one,
            damping_ratio: two,
            root: one,
        };
        Some(
            self.movers
                .iter()
                .zip(sums)
                .map(part)
                .filter(|part| part.frequency != 0.0 || part.damping_ratio != 0.0)
                .collect(),
        )
    }
}

/// One end of the way: derivatives, or matrices where the source has nothing else, with what is added to entries of A.
fn end(scenario: &Scenario) -> Option<EditedModel> {
    let edited = &scenario.edited;
    let aircraft_model = match edited.derivatives().ok()? {
        Some(derivatives) => AircraftModel::Derivatives(derivatives),
        None => edited.aircraft_model.clone(),
    };
    let offsets = Offsets { matrices: edited.offsets.matrices, ..Offsets::default() };
    Some(EditedModel { aircraft_model, offsets })
}

/// A derivative that has moved, or an entry of A to which something was added.
fn moved_parameter(p: &'static Parameter, from: &Scenario, to: &Scenario) -> Option<Mover> {
    if p.plane != Some(to.plane) || !p.applies(to) {
        return None;
    }
    let [before, after] = [p.get(from), p.get(to)];
    let change = match p.page? {
        Page::Coefficients => 0.0,
        Page::Dimensional => after - before,
        Page::Matrix => p.added(to)? - p.added(from)?,
        // A law leaves the aircraft's own modes where they are.
        Page::Feedback => return None,
    };
    let moved = Moved { key: p.key, from: before, to: after };
    (change != 0.0).then_some(Mover { moved, change, of: Of::Parameter(p) })
}

impl Mover {
    /// ∂A/∂p.
    fn a_rate(&self, here: &EditedModel, plane: Plane) -> Option<Matrix4<f64>> {
        let of_dual = |seed: fn(&DerivativeModel, &mut DerivativeModel<Dual64>) -> Option<()>| {
            let AircraftModel::Derivatives(given) = &here.aircraft_model else { return None };
            let mut dual = given.constant();
            seed(given, &mut dual)?;
            Some(dual.models().planes[plane].as_ref()?.a.map(|x| x.eps))
        };
        match self.of {
            Of::Parameter(parameter) => parameter.matrix_rate(here, plane),
            Of::Speed => of_dual(|_, dual| {
                dual.trim.speed.eps = 1.0;
                Some(())
            }),
            Of::PathAngle => of_dual(|_, dual| {
                dual.trim.gamma0.eps = 1.0;
                Some(())
            }),
            Of::IxzOverIx => of_dual(|given, dual| {
                dual.lateral = Some(seeded(given.lateral.as_ref()?, |d| &mut d.ixz_over_ix));
                Some(())
            }),
            Of::IxzOverIz => of_dual(|given, dual| {
                dual.lateral = Some(seeded(given.lateral.as_ref()?, |d| &mut d.ixz_over_iz));
                Some(())
            }),
        }
    }
}

fn modes_of(edited: &EditedModel, plane: Plane) -> Option<Vec<Mode>> {
    let model: PlaneModel = edited.models().ok()?.planes[plane].take()?;
    modes(&model).ok()
}
