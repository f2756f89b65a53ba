//! Numbers that may carry their derivative along: exact differentiation of the chain from coefficients to A.
//!
//! ε² = 0, so f(x + ε) = f(x) + f′(x) ε (Griewank & Walther, *Evaluating Derivatives*, 2008, §3). There is no step size and
//! no cancellation. The chain is written once, for any [`Real`]: with `f64` it gives A, with [`Dual64`] A and ∂A/∂p.
//! Constants stand on the right, `x * 2.0`: Rust's `f64` has no product with a number of unknown type.

pub use num_dual::Dual64;
use num_dual::DualNum;

/// A real number, alone or with its derivative with respect to one parameter. Comparisons are of the numbers alone.
pub trait Real: DualNum<Primitive = f64> + Copy {
    /// Whether it has this value and stays there: a parameter that is moved through the value does not.
    fn is_constantly(self, value: f64) -> bool;

    /// The smaller of the two; where they are equal, with the rate just above the limit: none.
    fn at_most(self, limit: f64) -> Self {
        if self < limit { self } else { Self::from(limit) }
    }

    /// The larger of the two; where they are equal, with the rate just above the limit: its own.
    fn at_least(self, limit: f64) -> Self {
        if self >= limit { self } else { Self::from(limit) }
    }
}

impl Real for f64 {
    fn is_constantly(self, value: f64) -> bool {
        self == value
    }
}

impl Real for Dual64 {
    fn is_constantly(self, value: f64) -> bool {
        self.re == value && self.eps == 0.0
    }
}

/// A structure whose fields are all numbers of one type, and its siblings with numbers of another type.
pub trait Record {
    /// The type of the numbers.
    type Number: Copy;
    /// The same fields with numbers of type `T`.
    type Of<T: Copy>;
    /// Every field from that of two siblings.
    fn zip<U: Copy, V: Copy>(&self, other: &Self::Of<U>, f: impl Fn(Self::Number, U) -> V) -> Self::Of<V>;
}

/// Implements [`Record`] from the names of the fields, each once.
macro_rules! record {
    ($name:ident: $($field:ident)*) => {
        impl<T: Copy> crate::flight::aircraft::real::Record for $name<T> {
            type Number = T;
            type Of<U: Copy> = $name<U>;
            fn zip<U: Copy, V: Copy>(&self, other: &$name<U>, f: impl Fn(T, U) -> V) -> $name<V> {
                $name { $($field: f(self.$field, other.$field)),* }
            }
        }
    };
}
pub(crate) use record;

/// The same numbers as constants, whose rates are zero.
pub fn constant<R: Record<Number = f64, Of<f64> = R>>(values: &R) -> R::Of<Dual64> {
    values.zip(values, |value, _: f64| Dual64::from(value))
}

/// The same numbers, all constant but one, the parameter: it is seeded with a rate of one.
pub fn seeded<R: Record<Number = f64, Of<f64> = R>>(
    values: &R,
    parameter: fn(&mut R) -> &mut f64,
) -> R::Of<Dual64> {
    let mut rates = values.zip(values, |_, _: f64| 0.0);
    *parameter(&mut rates) = 1.0;
    values.zip(&rates, Dual64::new)
}
