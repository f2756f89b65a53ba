//! The inverse question: a pole is dragged; which parameters would have to change, and how little, to put it there?
//!
//! Two equations, λ(p) = λ*, and as many unknowns as there are parameters. First the pole is brought to the target, or as near
//! as it goes, by Levenberg–Marquardt steps within the bounds; then the parameters slide along λ(p) = λ* to the least change,
//! Σ((p − p₀)/s)² (Nocedal & Wright, *Numerical Optimization*, 2nd ed., §§10.3, 16.5, 18). The derivatives of λ are
//! exact. Both searches go downhill from where the aircraft is: a better place beyond a hill is not found.

use nalgebra::{Complex, DefaultAllocator, U4, Vector2};

use super::eigen::eigen;
use super::least_change::{Bounds, damped_step, least_change};
use super::locus::Poles;
use super::schur::{Room, Size, Square};

/// A target is reached within this fraction of the size of the pole.
const REACHED: f64 = 1e-11;
/// Bound on the steps towards the target, in one search.
const MOST_STEPS: usize = 80;
/// Bound on the steps along λ(p) = λ* towards the least change.
const MOST_SLIDES: usize = 30;

/// A parameter that may be changed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Adjustable {
    /// Its value now.
    pub value: f64,
    /// The least it may become, no greater than `value`.
    pub lower: f64,
    /// The most it may become, no less than `value`.
    pub upper: f64,
    /// The change that counts as one, positive: what is as hard to change as one scale of any other.
    pub scale: f64,
}

/// The model at values of the parameters, of four states or of N.
#[derive(Clone, Debug, PartialEq)]
pub struct Linearised<N: Size = U4>
where
    DefaultAllocator: Room<N>,
{
    /// A.
    pub a: Square<N>,
    /// ∂A/∂p, one a parameter; zero where there is none.
    pub rates: Vec<Square<N>>,
}

/// Which of some poles is meant.
pub type Choice<'a> = &'a dyn Fn(&[Complex<f64>]) -> Option<usize>;

/// The poles of a model, one of them, and how that moves.
#[derive(Clone, Debug, PartialEq)]
pub struct Solved {
    /// All poles, the largest first.
    pub poles: Poles,
    /// The place of the one that is meant.
    pub chosen: usize,
    /// dλ/dp of that, one a parameter.
    pub rates: Vec<Complex<f64>>,
}

impl<N: Size> Linearised<N>
where
    DefaultAllocator: Room<N>,
{
    /// Its poles, and how the one that `choice` means moves.
    pub fn solved(&self, choice: Choice<'_>) -> Option<Solved> {
        let solved = eigen(&self.a).ok()?;
        let poles: Poles = solved.values.iter().copied().collect();
        let chosen = choice(&poles)?;
        let (v, l) = (solved.right.column(chosen), solved.left.column(chosen));
        let product = l.dotc(&v);
        // dλ/dp = lᴴ (∂A/∂p) v / (lᴴ v)
        let rate = |rate: &Square<N>| l.dotc(&(rate.map(Complex::from) * v)) / product;
        Some(Solved { chosen, rates: self.rates.iter().map(rate).collect(), poles })
    }
}

/// In which direction a target is out of reach.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OutOfReach {
    /// The frequency can be had, the damping not.
    Damping,
    /// The damping can be had, the frequency not.
    Frequency,
    /// Neither.
    Both,
    /// A real root can't be brought there along the real axis.
    RealRoot,
    /// The target is no real number, and a real root leaves the real axis only where it meets another.
    OffTheAxis,
}

/// The answer.
#[derive(Clone, Debug, PartialEq)]
pub struct Placement {
    /// The parameters, within their bounds.
    pub values: Vec<f64>,
    /// The pole with these parameters \[1/s\].
    pub lambda: Complex<f64>,
    /// Where it was wanted \[1/s\], in the upper half plane.
    pub wanted: Complex<f64>,
    /// Size of the change, √Σ((p − p₀)/s)².
    pub change: f64,
    /// `None` if the pole is where it was wanted; else what is out of reach, the pole being as near as it goes.
    pub out_of_reach: Option<OutOfReach>,
    /// How often the model was evaluated.
    pub evaluations: usize,
}

/// Why the question has no answer at all.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum InverseError {
    /// A number of the question is not finite, a bound excludes the present value, or a scale is not positive.
    Question,
    /// There is no model at the present values.
    NoModel,
}

/// A place in the search: y = (p − p₀)/s, the pole there, and how it moves.
struct Place {
    y: Vec<f64>,
    lambda: Complex<f64>,
    /// dλ/dy, one a parameter, as (real, imaginary).
    rates: Vec<Vector2<f64>>,
    /// Distance from the pole to its nearest neighbour.
    gap: f64,
}

/// The poles at values of the parameters, `None` where there is no such aircraft, and how the one that is meant moves.
pub type Model<'a> = &'a dyn Fn(&[f64], Choice<'_>) -> Option<Solved>;

struct Search<'a> {
    model: Model<'a>,
    parameters: &'a [Adjustable],
    bounds: Bounds,
    wanted: Complex<f64>,
    /// Whether the pole is a real root, and stays one.
    real: bool,
    tolerance: f64,
    evaluations: usize,
}

/// The least change of `parameters` that brings the pole now nearest to `from` to `to`, or as near as it goes.
///
/// `model` gives A and its derivatives for values of the parameters, `None` where there is no such aircraft. Conjugates count as one pole: both
/// `from` and `to` are taken in the upper half plane. The number of evaluations is bounded, some hundreds in practice.
pub fn place_pole(
    model: impl Fn(&[f64]) -> Option<Linearised>,
    parameters: &[Adjustable],
    from: Complex<f64>,
    to: Complex<f64>,
) -> Result<Placement, InverseError> {
    place_pole_of(&|values, choice| model(values)?.solved(choice), parameters, from, to)
}

/// The same of any model, by its poles: as many at all values.
pub fn place_pole_of(
    model: Model<'_>,
    parameters: &[Adjustable],
    from: Complex<f64>,
    to: Complex<f64>,
) -> Result<Placement, InverseError> {
    let finite = |z: Complex<f64>| z.re.is_finite() && z.im.is_finite() && z.norm() < 1e150;
    let sound = |p: &Adjustable| {
        let width = (p.upper - p.lower) / p.scale;
        p.lower <= p.value && p.value <= p.upper && p.scale > 0.0 && width.is_finite() && p.value.is_finite()
    };
    if !(finite(from) && finite(to) && parameters.iter().all(sound)) {
        return Err(InverseError::Question);
    }
    let upper_half = |z: Complex<f64>| Complex::new(z.re, z.im.abs());
    let (from, to) = (upper_half(from), upper_half(to));
    let mut search = Search {
        model,
        parameters,
        bounds: Bounds::new(
            parameters.iter().map(|p| ((p.lower - p.value) / p.scale, (p.upper - p.value) / p.scale)),
        ),
        wanted: to,
        real: false,
        tolerance: 0.0,
        evaluations: 0,
    };
    // The pole nearest to `from`, whichever kind it is.
    let start = vec![0.0; parameters.len()];
    let nearest = |poles: &[Complex<f64>]| {
        let distance = |i: usize| (poles[i] - from).norm();
        let upper = (0..poles.len()).filter(|&i| poles[i].im >= 0.0);
        upper.min_by(|&i, &j| distance(i).total_cmp(&distance(j)))
    };
    let solved = search.solve(&start, &nearest).ok_or(InverseError::NoModel)?;
    let pole = solved.poles[solved.chosen];
    let radius = solved.poles[0].norm();
    search.real = pole.im == 0.0;
    let off_the_axis = search.real && to.im > 0.0;
    if search.real {
        search.wanted = Complex::from(to.re);
    }
    search.tolerance = REACHED * to.norm().max(1e-3 * radius).max(f64::MIN_POSITIVE);
    let start = search.place(start, pole).ok_or(InverseError::NoModel)?;
    let mut place = search.approach(start);
    let reached = search.miss(&place) <= search.tolerance;
    if reached {
        place = search.slide(place);
    }
    let out_of_reach = if off_the_axis {
        Some(OutOfReach::OffTheAxis)
    } else if reached {
        None
    } else {
        Some(search.what_is_missing(&place))
    };
    Ok(Placement {
        values: search.values(&place.y),
        lambda: place.lambda,
        wanted: to,
        change: norm(&place.y),
        out_of_reach,
        evaluations: search.evaluations,
    })
}

impl Search<'_> {
    /// p = p₀ + s y, within the bounds to the last bit.
    fn values(&self, y: &[f64]) -> Vec<f64> {
        let value = |(p, y): (&Adjustable, &f64)| (p.value + p.scale * y).clamp(p.lower, p.upper);
        self.parameters.iter().zip(y).map(value).collect()
    }

    /// The poles at `y`.
    fn solve(&mut self, y: &[f64], choice: Choice<'_>) -> Option<Solved> {
        self.evaluations += 1;
        (self.model)(&self.values(y), choice)
    }

    /// The place at `y`, its pole being the one of the same kind nearest to `expected`.
    fn place(&mut self, y: Vec<f64>, expected: Complex<f64>) -> Option<Place> {
        let real = self.real;
        let of_kind = |poles: &[Complex<f64>]| {
            let distance = |i: usize| (poles[i] - expected).norm();
            let kind = |i: &usize| if real { poles[*i].im == 0.0 } else { poles[*i].im > 0.0 };
            (0..poles.len()).filter(kind).min_by(|&i, &j| distance(i).total_cmp(&distance(j)))
        };
        let Solved { poles, chosen, rates } = self.solve(&y, &of_kind)?;
        let lambda = poles[chosen];
        let others = poles.iter().enumerate().filter(|(j, _)| *j != chosen);
        let gap = others.map(|(_, other)| (other - lambda).norm()).fold(f64::INFINITY, f64::min);
        let rate = |(parameter, rate): (&Adjustable, &Complex<f64>)| {
            // dλ/dy = s dλ/dp
            let rate = rate * parameter.scale;
            let rate = Vector2::new(rate.re, if real { 0.0 } else { rate.im });
            if rate.norm() < 1e150 { rate } else { Vector2::zeros() }
        };
        let rates = self.parameters.iter().zip(&rates).map(rate).collect();
        Some(Place { y, lambda, rates, gap })
    }

    fn miss(&self, place: &Place) -> f64 {
        (self.wanted - place.lambda).norm()
    }

    fn residual(&self, place: &Place) -> Vector2<f64> {
        let r = self.wanted - place.lambda;
        Vector2::new(r.re, r.im)
    }

    /// Levenberg–Marquardt within the bounds, until the target is reached or nothing nearer is found.
    fn approach(&mut self, start: Place) -> Place {
        let mut place = start;
        let size: f64 = place.rates.iter().map(Vector2::norm_squared).sum();
        let (least, most) = (1e-14 * size, 1e8 * size);
        let mut damping = 1e-6 * size;
        for _ in 0..MOST_STEPS {
            let residual = self.residual(&place);
            if residual.norm() <= self.tolerance {
                // Nothing to win from another step but rounding.
                break;
            }
            let mut step = damped_step(&place.rates, &residual, damping, &place.y, &self.bounds);
            // No further than half-way to the next pole, so that the pole is not mistaken for another.
            let expected = first_order_move(&place.rates, &step);
            let far = expected.norm() / (0.5 * place.gap).max(self.tolerance);
            if far > 1.0 {
                step.iter_mut().for_each(|d| *d /= far);
            }
            if expected.norm() <= 0.1 * self.tolerance {
                break;
            }
            let y = self.bounds.clamped(place.y.iter().zip(&step).map(|(y, d)| y + d));
            let expected = expected / far.max(1.0);
            let aim = place.lambda + Complex::new(expected.x, expected.y);
            match self.place(y, aim).filter(|next| self.miss(next) < residual.norm()) {
                Some(next) => {
                    place = next;
                    damping = (damping / 8.0).max(least);
                }
                None if damping < most => damping *= 8.0,
                None => break,
            }
        }
        place
    }

    /// Slides along λ(p) = λ* towards the least change.
    fn slide(&mut self, start: Place) -> Place {
        let mut place = start;
        let mut fraction = 1.0;
        for _ in 0..MOST_SLIDES {
            let goal = least_change(&place.rates, &self.residual(&place), &place.y, &self.bounds);
            let step: Vec<f64> = goal.iter().zip(&place.y).map(|(goal, y)| fraction * (goal - y)).collect();
            if norm(&step) <= 1e-10 * norm(&place.y) {
                break;
            }
            let y = self.bounds.clamped(place.y.iter().zip(&step).map(|(y, d)| y + d));
            let next = self.place(y, place.lambda).map(|next| self.approach(next));
            let better = |next: &Place| {
                self.miss(next) <= self.tolerance && norm(&next.y) < norm(&place.y) * (1.0 - 1e-13)
            };
            match next.filter(better) {
                Some(next) => {
                    place = next;
                    fraction = (2.0 * fraction).min(1.0);
                }
                None if fraction > 0.01 => fraction *= 0.25,
                None => break,
            }
        }
        place
    }

    /// Frequency is the distance of the pole from zero, damping its direction: which part of what is left is greater.
    fn what_is_missing(&self, place: &Place) -> OutOfReach {
        if self.real {
            return OutOfReach::RealRoot;
        }
        let (left, here) = (self.wanted - place.lambda, place.lambda / place.lambda.norm());
        let frequency = (left * here.conj()).re.abs() / left.norm();
        if frequency > 0.9 {
            OutOfReach::Frequency
        } else if frequency < 0.436 {
            // √(1 − 0.9²)
            OutOfReach::Damping
        } else {
            OutOfReach::Both
        }
    }
}

fn first_order_move(rates: &[Vector2<f64>], step: &[f64]) -> Vector2<f64> {
    rates.iter().zip(step).map(|(rate, d)| rate * *d).sum()
}

fn norm(y: &[f64]) -> f64 {
    y.iter().map(|y| y * y).sum::<f64>().sqrt()
}
