//! Why a mode has moved: what changed, by which derivatives, and the formula that has it. At most three sentences a mode.

use crate::findings::change::{
    Cause, Change, Formula, IXZ_OVER_IX, IXZ_OVER_IZ, Kind, Measured, ModeChange, Moved, Oscillation,
    SharedDamping, Shift, Terms,
};
use crate::flight::modes::approximations::ApproximationName;
use crate::number::significant;
use crate::scenario::{Convention, Notation, Parameter, Written};
use crate::words::approximation::signed_percent;
use crate::words::mode;

/// The head of the sentences.
pub const TITLE: &str = "Why it moved";
/// Where that is told under a law of feedback.
pub const UNDER_LAW: &str = "Why a mode moved is told of the aircraft without its law: show the loop open";
/// What it is compared with: the aircraft's file.
pub const SINCE_FILE: &str = "Compared with the aircraft as its source has it";
/// What it is compared with: the pinned state.
pub const SINCE_PIN: &str = "Compared with the pinned state";
/// Why it is compared with the file although something is pinned.
pub const OTHER_PINNED: &str =
    "The pinned state is another aircraft: this one is compared with its own source instead.";
/// What more there is.
pub const MORE_MEANING: &str =
    "The part of each derivative, which add up to the change, and the formula that has it";

/// A cause that has less than this fraction of the largest isn't named.
const MINOR: f64 = 0.15;
/// No more causes are named.
const MOST_NAMED: usize = 3;
/// Nor is a part of less than this fraction of the change.
const NOTHING: f64 = 0.02;
/// A change of 2ζωₙ by less than this fraction needs no account of where it came from.
const SHARED: f64 = 0.05;
/// Beside a term this many times larger the other isn't told.
const MUCH_LARGER: f64 = 100.0;

/// What moved the modes, in sentences.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Reasons {
    /// What changed and by what, in one sentence.
    pub headline: String,
    /// From what was moved to the derivatives and their parts; then the formula.
    pub more: Vec<String>,
}

/// Why a mode has moved; `None` where it hasn't.
pub fn reasons(change: &Change, mode: &ModeChange, convention: Convention) -> Option<Reasons> {
    let (headline, more) = match &mode.kind {
        Kind::Still => return None,
        Kind::New => (
            "No mode before was like it: roots have met on the way, or changed their shape.".to_owned(),
            Vec::new(),
        ),
        Kind::Root(shift) => {
            let headline = format!("λ\u{a0}{}\u{a0}1/s{}.", arrow(shift), by(&[shift], convention));
            (headline, vec![chain(change, &[("λ", shift)], convention), root_formula(shift, convention)])
        }
        Kind::Oscillation(oscillation) => {
            let headline = oscillation_headline(mode, oscillation, convention);
            let Oscillation { frequency, damping_ratio, .. } = oscillation;
            let chain = chain(change, &[("ωₙ", frequency), ("ζ", damping_ratio)], convention);
            (headline, vec![chain, oscillation_formula(oscillation, convention)])
        }
    };
    Some(Reasons { headline, more: more.into_iter().flatten().collect() })
}

fn oscillation_headline(mode: &ModeChange, oscillation: &Oscillation, convention: Convention) -> String {
    let Oscillation { oscillates, frequency, damping_ratio, period, .. } = oscillation;
    let mut told = Vec::new();
    if frequency.is_notable {
        told.push(format!("ωₙ\u{a0}{}", signed_percent(frequency.relative())));
    }
    if let Some([from, to]) = period
        && (to / from - 1.0).abs() > 0.01
    {
        told.push(format!("T\u{a0}{}\u{a0}s", arrow_of(*from, *to)));
    }
    if damping_ratio.is_notable {
        told.push(format!("ζ\u{a0}{}", arrow(damping_ratio)));
    }
    let shifts: Vec<&Shift> =
        [frequency, damping_ratio].into_iter().filter(|shift| shift.is_notable).collect();
    let told = format!("{}{}.", told.join(", "), by(&shifts, convention));
    match oscillates {
        [true, false] => format!("The oscillation has become two real roots; together, {told}"),
        [false, true] => {
            format!("Two real roots have become the {}; together, {told}", mode::in_a_sentence(mode.name))
        }
        _ => told,
    }
}

/// ", by M_q": the derivatives that have most of it.
fn by(shifts: &[&Shift], convention: Convention) -> String {
    let named = named(shifts);
    if named.is_empty() {
        return String::new();
    }
    let symbols: Vec<&str> = named.iter().map(|key| symbol(key, convention)).collect();
    let others = shifts.iter().filter_map(|shift| shift.causes.as_ref()).any(|causes| {
        causes.iter().any(|cause| !named.contains(&cause.moved.key) && is_notable_beside(cause, causes))
    });
    format!(", {}by {}", if others { "most of it " } else { "" }, list(&symbols))
}

/// Whether a cause has a twentieth of the largest.
fn is_notable_beside(cause: &Cause, causes: &[Cause]) -> bool {
    causes.first().is_some_and(|largest| cause.part.abs() > 0.05 * largest.part.abs())
}

/// Keys of the derivatives that have most of the shifts, the most first.
fn named(shifts: &[&Shift]) -> Vec<&'static str> {
    let mut named: Vec<&'static str> = Vec::new();
    for causes in shifts.iter().filter_map(|shift| shift.causes.as_ref()) {
        let largest = causes.first().map_or(0.0, |cause| cause.part.abs());
        for cause in causes.iter().filter(|cause| cause.part.abs() > MINOR * largest).take(MOST_NAMED) {
            if !named.contains(&cause.moved.key) {
                named.push(cause.moved.key);
            }
        }
    }
    named.truncate(MOST_NAMED);
    named
}

/// "C_mq moves M_q −2.08 → −4.15 1/s: ωₙ +15 %, ζ +0.16.": the chain with the exact parts, which add up.
fn chain(change: &Change, shifts: &[(&str, &Shift)], convention: Convention) -> Option<String> {
    let told: Vec<&(&str, &Shift)> = shifts.iter().filter(|(_, shift)| shift.is_notable).collect();
    let only: Vec<&Shift> = told.iter().map(|(_, shift)| *shift).collect();
    if only.iter().any(|shift| shift.causes.is_none()) {
        return Some("Roots meet on the way, so the change has no parts by derivatives.".to_owned());
    }
    let named = named(&only);
    let all: Vec<&Cause> = only.iter().filter_map(|shift| shift.causes.as_ref()).flatten().collect();
    let part = |key: &str, shift: &Shift| {
        let causes = shift.causes.iter().flatten();
        causes.filter(|cause| cause.moved.key == key).map(|cause| cause.part).sum::<f64>()
    };
    let parts = |of: &dyn Fn(&Shift) -> f64| {
        let each = told.iter().filter(|(_, shift)| of(shift).abs() >= NOTHING * shift.change().abs());
        let each = each.map(|(symbol, shift)| format!("{symbol}\u{a0}{}", part_of(symbol, shift, of(shift))));
        each.collect::<Vec<_>>().join(", ")
    };
    let edited: Vec<&str> = change.edits.iter().map(|edit| edit.key).collect();
    let mut pieces: Vec<String> = named
        .iter()
        .filter_map(|key| {
            let moved = all.iter().find(|cause| cause.moved.key == *key)?.moved;
            let range = if edited == [*key] && named.len() > 1 {
                format!("{} itself", symbol(key, convention))
            } else {
                format!("{} {}", symbol(key, convention), range(&moved, convention))
            };
            Some(if all.iter().all(|cause| cause.moved.key == *key) {
                format!("{range}, and that alone makes {}", parts(&|shift| part(key, shift)))
            } else {
                format!("{range} ({})", parts(&|shift| part(key, shift)))
            })
        })
        .collect();
    if all.iter().any(|cause| !named.contains(&cause.moved.key)) {
        let rest = |shift: &Shift| {
            let causes = shift.causes.iter().flatten();
            causes.filter(|cause| !named.contains(&cause.moved.key)).map(|cause| cause.part).sum::<f64>()
        };
        let rest = parts(&rest);
        pieces.extend((!rest.is_empty()).then(|| format!("the rest ({rest})")));
    }
    let subject = match edited.as_slice() {
        [only] if named.as_slice() != [*only] => format!("{} moves ", symbol(only, convention)),
        _ => String::new(),
    };
    (!pieces.is_empty()).then(|| format!("{subject}{}.", pieces.join("; ")))
}

/// A part in the change of a number: of ωₙ in per cent of it as it was.
fn part_of(symbol: &str, shift: &Shift, part: f64) -> String {
    match symbol {
        "ωₙ" => signed_percent(part / shift.from.abs()),
        "λ" => format!("{} 1/s", signed(part)),
        _ => signed(part),
    }
}

fn signed(x: f64) -> String {
    format!("{}{}", if x >= 0.0 { "+" } else { "" }, significant(x, 2))
}

fn root_formula(shift: &Shift, convention: Convention) -> Option<String> {
    let [before, after] = shift.formula.as_ref()?;
    Some(format!("{} ({}).", formula(before, after, convention), within([before, after])))
}

/// The formula that has it: of ωₙ, of ζ or of both, with what it means where that is not in the formula.
fn oscillation_formula(oscillation: &Oscillation, convention: Convention) -> Option<String> {
    let Oscillation { frequency, damping_ratio, damping, shared, .. } = oscillation;
    // The end of the quartic says nothing that one could picture: only where there is nothing else.
    let is_plain = |pair: &&[Formula; 2]| {
        pair[0].name != ApproximationName::PhugoidQuartic || frequency.formula.is_none()
    };
    let mut told: Vec<String> = Vec::new();
    told.extend(frequency.formula.as_ref().map(|pair| with_error(pair, convention)));
    if let Some(pair) = damping_ratio.formula.as_ref().filter(is_plain) {
        told.push(with_error(pair, convention));
    } else if damping_ratio.is_notable && is_left_alone(damping, damping_ratio) {
        told.push(left_alone(damping, damping_ratio, frequency));
    } else if damping_ratio.is_notable
        && let Some(shared) = shared
        && (damping[1] - damping[0]).abs() > SHARED * damping[0].abs()
    {
        let the = if told.is_empty() { "The" } else { "the" };
        told.push(format!("{the} {}", shared_damping(shared, damping, convention.notation)));
    }
    if told.is_empty() && frequency.causes.is_some() && damping_ratio.causes.is_some() {
        told.push("No textbook formula here has this change; the parts are of the exact roots".to_owned());
    }
    (!told.is_empty()).then(|| format!("{}.", told.join("; ")))
}

/// Whether ζ has changed by ωₙ, and hardly by 2ζωₙ.
fn is_left_alone([from, to]: &[f64; 2], damping_ratio: &Shift) -> bool {
    let own = (to / from - 1.0).abs();
    own < 0.25 * damping_ratio.relative().abs()
}

/// ζ = 2ζωₙ/(2ωₙ) where the numerator has little of the change.
fn left_alone(damping: &[f64; 2], damping_ratio: &Shift, frequency: &Shift) -> String {
    let [zeta, wn] = [damping_ratio, frequency].map(|shift| goes(shift.change()));
    let [from, to] = damping.map(|x| significant(x, 3));
    if from == to {
        format!("2ζωₙ is {from} 1/s as before, so ζ {zeta} as ωₙ {wn}")
    } else {
        format!("2ζωₙ moves less, {from} → {to} 1/s: ζ {zeta} mostly because ωₙ {wn}")
    }
}

/// A direction in a word.
fn goes(change: f64) -> &'static str {
    if change > 0.0 { "rises" } else { "falls" }
}

fn with_error([before, after]: &[Formula; 2], convention: Convention) -> String {
    format!("{} ({})", formula(before, after, convention), within([before, after]))
}

/// "within 2 % of exact": the largest error before and after; of the change too, where that is smaller.
fn within(formulas: [&Formula; 2]) -> String {
    let worst = formulas.iter().map(|formula| formula.error.abs()).fold(0.0, f64::max);
    let missed = formulas[0].missed;
    if worst > 2.0 * missed && worst > 0.05 {
        format!("within {} of exact, the change within {}", percent(worst), percent(missed))
    } else {
        format!("within {} of exact", percent(worst))
    }
}

/// An error in per cent, rounded up.
fn percent(error: f64) -> String {
    let percent = (1000.0 * error).ceil() / 10.0;
    let percent = if percent >= 3.0 { percent.ceil() } else { percent.max(0.1) };
    format!("{}\u{a0}%", crate::number::trimmed(percent, 2))
}

/// A formula with its numbers before and after.
fn formula(before: &Formula, after: &Formula, convention: Convention) -> String {
    let text = match convention.notation {
        Notation::Velocities => written(before.name, before.measured),
        Notation::Angles => written_in_angles(before.name, before.measured),
    };
    match (&before.terms, &after.terms) {
        (Terms::Sum(from), Terms::Sum(to)) => {
            format!("{text} = {}", between(&sum(from), &sum(to), unit(before.measured)))
        }
        (Terms::Quotient(over, under), Terms::Quotient(over_to, under_to)) => {
            let is_phugoid = before.name == ApproximationName::PhugoidResidualised;
            let plain = |over: &[f64; 2]| MUCH_LARGER * over[1].abs() < over[0].abs();
            if is_phugoid && plain(over) && plain(over_to) && is_braked(under) && is_braked(under_to) {
                return yielding([over, over_to], [under, under_to], convention.notation);
            }
            // Both parts of the spiral's have L_v and N_v, so that V is in both.
            let is_spiral =
                matches!(before.name, ApproximationName::SpiralWithGravity | ApproximationName::SpiralQuick);
            let in_angles = is_spiral && convention.notation == Notation::Angles;
            let factor = if in_angles { convention.speed.lateral } else { 1.0 };
            let bracket = |terms: &[f64; 2]| bracket(&terms.map(|term| term * factor));
            let quotient =
                |over: &[f64; 2], under: &[f64; 2]| format!("{}/{}", bracket(over), bracket(under));
            let numbers = [quotient(over, under), quotient(over_to, under_to)];
            format!("{text} = {}", between(&numbers[0], &numbers[1], unit(before.measured)))
        }
        _ => text.to_owned(),
    }
}

/// Whether pitch damping adds to pitch stiffness, both restoring.
fn is_braked([damping, stiffness]: &[f64; 2]) -> bool {
    *damping > 0.0 && *stiffness > 0.0
}

/// The phugoid with the angle of attack that gives way: ωₙ² = (−Z_u g/V) (−V M_w)/(Z_w M_q − V M_w).
fn yielding(over: [&[f64; 2]; 2], under: [&[f64; 2]; 2], notation: Notation) -> String {
    let share = |[damping, stiffness]: &[f64; 2]| significant(100.0 * stiffness / (damping + stiffness), 2);
    // g M_w Z_u/(−V M_w) = −Z_u g/V
    let full = |k: usize| significant(over[k][0] / under[k][1], 3);
    let (moment, left) = match notation {
        Notation::Velocities => ("M_w w", "−V M_w/(Z_w M_q − V M_w)"),
        Notation::Angles => ("M_α α", "−M_α/(Z_α M_q/V − M_α)"),
    };
    format!(
        "As the path bends, the turn meets M_q q, and α gives way until {moment} balances it: of ωₙ² = −Z_u g/V, {}, \
         there is left {left}, {}",
        between(&full(0), &full(1), " 1/s²"),
        between(&share(under[0]), &share(under[1]), "\u{a0}%"),
    )
}

/// Where the damping of the Dutch roll goes that isn't in v and r.
fn shared_damping(shared: &SharedDamping, damping: &[f64; 2], notation: Notation) -> String {
    let SharedDamping { trace, roll, spiral, bank } = shared;
    let [of_trace, of_roll, of_spiral] = [trace, roll, spiral].map(|[from, to]| to - from);
    let of_yaw = damping[0] - damping[1];
    let least = NOTHING * of_yaw.abs();
    let sum = if of_trace.abs() < least {
        "stays".to_owned()
    } else {
        format!("moves by {} 1/s", signed(of_trace))
    };
    let spiral = if of_spiral.abs() < least {
        String::new()
    } else {
        format!("λ of the spiral {}, ", signed(of_spiral))
    };
    let more = if bank[1] > bank[0] { "more" } else { "less" };
    let side = match notation {
        Notation::Velocities => "Y_v",
        Notation::Angles => "Y_β/V",
    };
    format!(
        "roots add up to {side} + L′_p + N′_r, which {sum}: λ of the roll mode takes {}, {spiral}−2ζωₙ of the Dutch roll {}; \
         it banks {more} for its sideslip, |φ/β| {}",
        signed(of_roll),
        signed(of_yaw),
        arrow_of(bank[0], bank[1]),
    )
}

/// The formula of what is measured, without its numbers.
const fn written(name: ApproximationName, measured: Measured) -> &'static str {
    use ApproximationName as Name;
    match (name, measured) {
        (Name::ShortPeriodTwoStates, Measured::Frequency) => "ωₙ² = Z_w M_q − V M_w",
        (Name::ShortPeriodTwoStates, _) => "2ζωₙ = −(Z_w + M_q + V M_ẇ)",
        (Name::ShortPeriodPitchOnly, Measured::Frequency) => "ωₙ² = −V M_w",
        (Name::ShortPeriodPitchOnly, _) => "2ζωₙ = −(M_q + V M_ẇ)",
        (Name::PhugoidLanchester, _) => "ωₙ = √2 g/V",
        (Name::PhugoidTwoStates, Measured::Frequency) => "ωₙ² = −Z_u g/V",
        (Name::PhugoidTwoStates, _) => "2ζωₙ = −X_u",
        (Name::PhugoidResidualised, Measured::Frequency) => "ωₙ² = g (M_w Z_u − M_u Z_w)/(Z_w M_q − V M_w)",
        (Name::PhugoidResidualised, _) => "2ζωₙ = −tr Aᵣ",
        (Name::PhugoidQuartic, Measured::Frequency) => "ωₙ² = E/C of the characteristic polynomial",
        (Name::PhugoidQuartic, _) => "2ζωₙ = D/C − B E/C² of the characteristic polynomial",
        (Name::DutchRollTwoStates, Measured::Frequency) => "ωₙ² = V N′_v + Y_v N′_r",
        (Name::DutchRollTwoStates, _) => "2ζωₙ = −(Y_v + N′_r)",
        (Name::DutchRollYawOnly, Measured::Frequency) => "ωₙ² = V N′_v",
        (Name::DutchRollYawOnly, _) => "2ζωₙ = −N′_r",
        (Name::RollDamping, _) => "λ = L′_p",
        (Name::SpiralPolynomial, _) => "λ = −E/D of the characteristic polynomial",
        (Name::SpiralWithGravity, _) => "λ = −(g/V)(L′_v N′_r − N′_v L′_r)/(L′_v (N′_p − g/V) − N′_v L′_p)",
        (Name::SpiralQuick, _) => "λ = (L′_v N′_r − N′_v L′_r)/L′_v",
    }
}

/// The same in α and β, with the same numbers but for those of the spiral.
const fn written_in_angles(name: ApproximationName, measured: Measured) -> &'static str {
    use ApproximationName as Name;
    match (name, measured) {
        (Name::ShortPeriodTwoStates, Measured::Frequency) => "ωₙ² = Z_α M_q/V − M_α",
        (Name::ShortPeriodTwoStates, _) => "2ζωₙ = −(Z_α/V + M_q + M_α\u{307})",
        (Name::ShortPeriodPitchOnly, Measured::Frequency) => "ωₙ² = −M_α",
        (Name::ShortPeriodPitchOnly, _) => "2ζωₙ = −(M_q + M_α\u{307})",
        (Name::PhugoidResidualised, Measured::Frequency) => {
            "ωₙ² = (g/V)(M_α Z_u − M_u Z_α)/(Z_α M_q/V − M_α)"
        }
        (Name::DutchRollTwoStates, Measured::Frequency) => "ωₙ² = N′_β + Y_β N′_r/V",
        (Name::DutchRollTwoStates, _) => "2ζωₙ = −(Y_β/V + N′_r)",
        (Name::DutchRollYawOnly, Measured::Frequency) => "ωₙ² = N′_β",
        (Name::SpiralWithGravity, _) => "λ = −(g/V)(L′_β N′_r − N′_β L′_r)/(L′_β (N′_p − g/V) − N′_β L′_p)",
        (Name::SpiralQuick, _) => "λ = (L′_β N′_r − N′_β L′_r)/L′_β",
        (
            Name::PhugoidLanchester
            | Name::PhugoidTwoStates
            | Name::PhugoidResidualised
            | Name::PhugoidQuartic
            | Name::DutchRollYawOnly
            | Name::RollDamping
            | Name::SpiralPolynomial,
            _,
        ) => written(name, measured),
    }
}

const fn unit(measured: Measured) -> &'static str {
    match measured {
        Measured::Frequency => " 1/s²",
        Measured::Damping | Measured::Root => " 1/s",
    }
}

/// Terms as they are added: "4.19 + 8.83", "0.031 − 0.002". Terms that are nothing beside the largest are left out.
fn sum(terms: &[f64]) -> String {
    let largest = terms.iter().fold(0.0, |largest: f64, term| largest.max(term.abs()));
    let told = terms.iter().filter(|term| MUCH_LARGER * term.abs() >= largest);
    let mut text = String::new();
    for term in told {
        match (text.is_empty(), *term < 0.0) {
            (true, _) => text += &significant(*term, 3),
            (false, true) => text += &format!(" − {}", significant(-term, 3)),
            (false, false) => text += &format!(" + {}", significant(*term, 3)),
        }
    }
    text
}

fn bracket(terms: &[f64; 2]) -> String {
    let text = sum(terms);
    if text.contains(' ') { format!("({text})") } else { text }
}

/// "a → b", or once what is the same.
fn between(from: &str, to: &str, unit: &str) -> String {
    // Two numbers stand in one line, two sums may be too long for one.
    let space = if from.contains(' ') { " " } else { "\u{a0}" };
    if from == to { format!("{from}{unit} as before") } else { format!("{from}{space}→{space}{to}{unit}") }
}

fn arrow(shift: &Shift) -> String {
    arrow_of(shift.from, shift.to)
}

/// "0.080 → 0.186", with as many digits as it takes to see the change.
fn arrow_of(from: f64, to: f64) -> String {
    let digits = digits(from, to);
    // In one line: it may break before and after.
    format!("{}\u{a0}→\u{a0}{}", significant(from, digits), significant(to, digits))
}

fn digits(from: f64, to: f64) -> usize {
    (3..6).find(|&digits| significant(from, digits) != significant(to, digits)).unwrap_or(6)
}

/// From and to, with the unit in which the slider shows it.
fn range(moved: &Moved, convention: Convention) -> String {
    let Moved { key, from, to } = *moved;
    match Parameter::find(key) {
        Some(parameter) => {
            let digits = digits(from, to);
            let Written { unit, in_si, .. } = parameter.written(convention);
            let [from, to] = [from, to].map(|x| significant(x / in_si, digits));
            let space = if unit.is_empty() { "" } else { "\u{a0}" };
            format!("{from}\u{a0}→\u{a0}{to}{space}{unit}")
        }
        None => arrow_of(from, to),
    }
}

/// The symbol of a parameter, or of a ratio of inertias.
fn symbol(key: &str, convention: Convention) -> &'static str {
    match key {
        IXZ_OVER_IX => "I_xz/I_x",
        IXZ_OVER_IZ => "I_xz/I_z",
        _ => Parameter::find(key).map_or("", |parameter| parameter.written(convention).symbol),
    }
}

/// "M_w", "M_w and M_q", "M_w, M_q and Z_w".
fn list(symbols: &[&str]) -> String {
    match symbols {
        [] => String::new(),
        [only] => (*only).to_owned(),
        [first @ .., last] => format!("{} and {last}", first.join(", ")),
    }
}

/// What was moved, for the head of it all: "C_mq −9.96 → −19.9 1/rad".
pub fn edits(change: &Change, convention: Convention) -> String {
    let each: Vec<String> = change
        .edits
        .iter()
        .map(|edit| format!("{} {}", symbol(edit.key, convention), range(edit, convention)))
        .collect();
    each.join("; ")
}
