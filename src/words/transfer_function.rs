//! Transfer functions in factored form.

use nalgebra::Complex;

use crate::flight::motion::transfer_function::TransferFunction;
use crate::number::{eigenvalue, significant};

/// A transfer function as a fraction.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fraction {
    /// The factor K before it.
    pub gain: String,
    /// The zeros; 1 where there is none.
    pub above: String,
    /// The poles.
    pub below: String,
}

/// A transfer function, with its gain in units of `unit` in SI.
pub fn fraction(function: &TransferFunction, unit: f64) -> Fraction {
    Fraction {
        gain: significant(function.gain / unit, 4),
        above: factors(&function.zeros),
        below: factors(&function.poles),
    }
}

impl Fraction {
    /// The same in one line.
    pub fn line(&self) -> String {
        let Self { gain, above, below } = self;
        match (above.as_str(), below.as_str()) {
            ("1", "1") => gain.clone(),
            ("1", below) => format!("{gain} / [{below}]"),
            (above, "1") => format!("{gain} {above}"),
            (above, below) => format!("{gain} {above} / [{below}]"),
        }
    }
}

/// A product of (s + a) and (s² + 2·ζ·ω s + ω²), the slowest first.
fn factors(roots: &[Complex<f64>]) -> String {
    let at_zero = roots.iter().filter(|root| **root == Complex::default()).count();
    let mut parts = match at_zero {
        0 => Vec::new(),
        1 => vec!["s".to_owned()],
        2 => vec!["s²".to_owned()],
        3 => vec!["s³".to_owned()],
        n => vec![format!("s^{n}")],
    };
    let mut left: Vec<Complex<f64>> =
        roots.iter().copied().filter(|root| root.im >= 0.0 && *root != Complex::default()).collect();
    while let Some(k) = (0..left.len()).min_by(|&a, &b| left[a].norm().total_cmp(&left[b].norm())) {
        parts.push(factor(left.swap_remove(k)));
    }
    if parts.is_empty() { "1".to_owned() } else { parts.join(" ") }
}

fn factor(root: Complex<f64>) -> String {
    let sign = if root.re > 0.0 { "−" } else { "+" };
    let size = root.norm();
    let omega = significant(size, 3);
    if root.im == 0.0 {
        format!("(s {sign} {omega})")
    } else if root.re == 0.0 {
        format!("(s² + {omega}²)")
    } else {
        format!("(s² {sign} 2·{}·{omega} s + {omega}²)", significant(root.re.abs() / size, 3))
    }
}

/// What zeros in the right half-plane do; `None` where there are none.
pub fn zeros_on_the_right(function: &TransferFunction) -> Option<String> {
    let zeros: Vec<Complex<f64>> = function.zeros_on_the_right().collect();
    let places: Vec<String> = zeros.iter().map(|zero| eigenvalue(*zero)).collect();
    let real = zeros.iter().filter(|zero| zero.im == 0.0).count();
    let head = match (zeros.len(), real) {
        (0, _) => return None,
        (1, 1) => "A zero lies",
        _ => "Zeros lie",
    };
    let is_settling = function.poles.iter().all(|pole| pole.re <= 0.0);
    let tail = if real % 2 == 1 && is_settling {
        "a step is answered the wrong way first"
    } else {
        "the phase falls further than the gain tells"
    };
    Some(format!("{head} in the right half-plane, at s = {}: {tail}", places.join(" and ")))
}
