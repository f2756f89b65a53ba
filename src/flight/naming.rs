//! Names for the longitudinal modes, from their shape and never from a period.
//!
//! A mode's participation factors p_k = |l_k v_k| (left × right eigenvector) say how much each state belongs
//! to it. w and q together are the mark of the short period, u and θ of the phugoid. Thresholds on the period
//! name only half of the reference aircraft, so none is used.

use nalgebra::Complex;

use super::modes::DynamicStability;

/// What a longitudinal mode is called.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum ModeName {
    /// Fast oscillation of angle of attack and pitch rate at nearly constant speed.
    ShortPeriod,
    /// The faster of two real roots that an overdamped short period has become.
    ShortPeriodFastRoot,
    /// The slower of two real roots that an overdamped short period has become.
    ShortPeriodSlowRoot,
    /// Oscillation of an aircraft that diverges in pitch, mixing all four states.
    ThirdOscillatory,
    /// Slow exchange of speed and height at nearly constant angle of attack.
    Phugoid,
    /// The faster of two real roots that the phugoid has become.
    PhugoidFastRoot,
    /// The slower of two real roots that the phugoid has become.
    PhugoidSlowRoot,
    /// A real root that grows: the aircraft departs without oscillating.
    Divergence,
}

impl ModeName {
    /// The words on screen.
    pub const fn text(self) -> &'static str {
        match self {
            Self::ShortPeriod => "Short period",
            Self::ShortPeriodFastRoot => "Short period, fast root",
            Self::ShortPeriodSlowRoot => "Short period, slow root",
            Self::ThirdOscillatory => "Third oscillatory mode",
            Self::Phugoid => "Phugoid",
            Self::PhugoidFastRoot => "Phugoid, fast root",
            Self::PhugoidSlowRoot => "Phugoid, slow root",
            Self::Divergence => "Divergence",
        }
    }
}

/// A name, and why.
#[derive(Clone, Debug, PartialEq)]
pub struct Naming {
    /// What the mode is called.
    pub name: ModeName,
    /// Share of the mode in the states that gave it its name, 0 to 1. Near ½ the name is a matter of degree.
    pub confidence: f64,
    /// The reason in one sentence, with its numbers.
    pub reason: String,
}

/// An unnamed mode as far as naming needs it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Shape {
    pub lambda: Complex<f64>,
    pub participation: [f64; 4],
    pub stability: DynamicStability,
}

impl Shape {
    /// Share of w and q, the states of the short period; u and θ have the rest.
    fn short_period_share(&self) -> f64 {
        self.participation[1] + self.participation[2]
    }

    fn oscillates(&self) -> bool {
        self.lambda.im > 0.0
    }

    fn grows_without_oscillating(&self) -> bool {
        !self.oscillates() && self.stability == DynamicStability::Unstable
    }
}

/// Names all modes of one aircraft together, since what one is called depends on the others.
///
/// `shapes` holds each conjugate pair once: two, three or four modes. The names come in the same order.
pub(super) fn name_modes(shapes: &[Shape]) -> Vec<Naming> {
    let short_period = short_period_members(shapes);
    let fastest_root = |of_short_period: bool| {
        (0..shapes.len())
            .filter(|&i| short_period[i] == of_short_period && !shapes[i].oscillates())
            .max_by(|&i, &j| shapes[i].lambda.norm().total_cmp(&shapes[j].lambda.norm()))
    };
    let diverging = shapes.iter().any(Shape::grows_without_oscillating);

    (0..shapes.len())
        .map(|i| {
            let shape = &shapes[i];
            let name = match (short_period[i], shape.oscillates()) {
                _ if shape.grows_without_oscillating() => ModeName::Divergence,
                (true, true) => ModeName::ShortPeriod,
                (true, false) if fastest_root(true) == Some(i) => ModeName::ShortPeriodFastRoot,
                (true, false) => ModeName::ShortPeriodSlowRoot,
                (false, true) if diverging => ModeName::ThirdOscillatory,
                (false, true) => ModeName::Phugoid,
                (false, false) if fastest_root(false) == Some(i) => ModeName::PhugoidFastRoot,
                (false, false) => ModeName::PhugoidSlowRoot,
            };
            naming(name, shape)
        })
        .collect()
}

/// Which modes make up the short period: the pair, or the two real roots, richest in w and q.
///
/// Four eigenvalues share out as two and two. A pair is one member that takes both places, so with one pair
/// and two real roots the pair is weighed against the two roots together.
fn short_period_members(shapes: &[Shape]) -> Vec<bool> {
    let mean_share = |oscillating: bool| {
        let shares: Vec<f64> =
            shapes.iter().filter(|s| s.oscillates() == oscillating).map(Shape::short_period_share).collect();
        shares.iter().sum::<f64>() / shares.len().max(1) as f64
    };
    if shapes.len() == 3 {
        let pair_is_short_period = mean_share(true) >= mean_share(false);
        return shapes.iter().map(|s| s.oscillates() == pair_is_short_period).collect();
    }
    // Two pairs: the richer one. Four real roots: the richer two.
    let mut order: Vec<usize> = (0..shapes.len()).collect();
    order.sort_by(|&i, &j| shapes[j].short_period_share().total_cmp(&shapes[i].short_period_share()));
    let members = &order[..shapes.len() / 2];
    (0..shapes.len()).map(|i| members.contains(&i)).collect()
}

fn naming(name: ModeName, shape: &Shape) -> Naming {
    let short_period_share = shape.short_period_share();
    let fast = percent(short_period_share);
    let slow = percent(1.0 - short_period_share);
    let (confidence, reason) = match name {
        ModeName::ShortPeriod => {
            (short_period_share, format!("α and q carry {fast} of it while speed hardly changes."))
        }
        ModeName::ShortPeriodFastRoot => (
            short_period_share,
            format!(
                "α and q carry {fast} of it. The short period is overdamped: two real roots, this is the faster."
            ),
        ),
        ModeName::ShortPeriodSlowRoot => (
            short_period_share,
            format!(
                "α and q carry {fast} of it. The short period is overdamped: two real roots, this is the slower."
            ),
        ),
        ModeName::Phugoid => (
            1.0 - short_period_share,
            format!("Speed and pitch attitude carry {slow} of it: they trade energy at nearly constant α."),
        ),
        ModeName::PhugoidFastRoot => (
            1.0 - short_period_share,
            format!(
                "Speed and pitch attitude carry {slow} of it. The phugoid no longer oscillates: two real roots, this is the faster."
            ),
        ),
        ModeName::PhugoidSlowRoot => (
            1.0 - short_period_share,
            format!(
                "Speed and pitch attitude carry {slow} of it. The phugoid no longer oscillates: two real roots, this is the slower."
            ),
        ),
        ModeName::ThirdOscillatory => (
            1.0 - short_period_share,
            format!(
                "An oscillation beside a real root that grows: neither phugoid nor short period (α and q {fast}, speed and attitude {slow})."
            ),
        ),
        ModeName::Divergence if short_period_share >= 0.5 => (
            short_period_share,
            format!("A real root that grows, with α and q carrying {fast} of it: the nose keeps going."),
        ),
        ModeName::Divergence => (
            1.0 - short_period_share,
            format!(
                "A real root that grows, with speed and pitch attitude carrying {slow} of it: the aircraft keeps leaving its speed."
            ),
        ),
    };
    let reason = if confidence < 0.65 {
        format!("{reason} The shape is mixed, so the name is a matter of degree.")
    } else {
        reason
    };
    Naming { name, confidence, reason }
}

/// A share as a person reads it: "99.7 %", "95 %".
fn percent(share: f64) -> String {
    let value = 100.0 * share;
    if (99.0..99.95).contains(&value) { format!("{value:.1} %") } else { format!("{value:.0} %") }
}
