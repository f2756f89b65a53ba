//! Handling qualities: levels, what they are judged by, and each verdict in a sentence.

use crate::flight::modes::mode_name::ModeName;
use crate::flight::verdicts::handling_qualities::{Governing, Level, Remark, Verdict};
use crate::flight::verdicts::level_boundaries::Boundary;
use crate::flight::verdicts::mil_f_8785c::{Category, Class, Criterion, Quantity, Requirement, Source};
use crate::flight::verdicts::overall_level::OverallLevel;
use crate::flight::verdicts::task::Task;
use crate::number::{significant, trimmed};
use crate::words::mode;

/// A level.
pub const fn level(level: Level) -> &'static str {
    match level {
        Level::One => "Level 1",
        Level::Two => "Level 2",
        Level::Three => "Level 3",
        Level::Beyond => "Worse than Level 3",
    }
}

/// The levels that ask for a limit: "Level 1", or "Levels 2–3" where both ask the same.
pub const fn levels(boundary: &Boundary) -> &'static str {
    match (boundary.level, boundary.to) {
        (Level::One, Level::Two) => "Levels 1–2",
        (Level::One, Level::Three) => "Levels 1–3",
        (Level::Two, Level::Three) => "Levels 2–3",
        (best, _) => level(best),
    }
}

/// A criterion as a title.
pub const fn criterion(criterion: Criterion) -> &'static str {
    match criterion {
        Criterion::AirspeedDivergence => "Airspeed divergence",
        Criterion::PitchDivergence => "Pitch divergence",
        Criterion::Phugoid => "Phugoid damping",
        Criterion::ShortPeriodDamping => "Short-period damping",
        Criterion::ShortPeriodFrequency => "Short-period frequency",
        Criterion::DutchRoll => "Dutch roll",
        Criterion::RollMode => "Roll mode",
        Criterion::Spiral => "Spiral",
        Criterion::CoupledRollSpiral => "Coupled roll–spiral",
    }
}

/// A class of aircraft.
pub const fn class(class: Class) -> &'static str {
    match class {
        Class::I => "Class I",
        Class::II => "Class II",
        Class::IICarrier => "Class II, carrier based",
        Class::III => "Class III",
        Class::IV => "Class IV",
    }
}

/// A class with the aircraft that it stands for.
pub const fn class_with_aircraft(class: Class) -> &'static str {
    match class {
        Class::I => "Class I: small and light",
        Class::II => "Class II: medium weight, low to medium manoeuvrability",
        Class::IICarrier => "Class II, carrier based",
        Class::III => "Class III: large and heavy, low to medium manoeuvrability",
        Class::IV => "Class IV: high manoeuvrability",
    }
}

/// The class and category of a task.
pub fn task(task: Task) -> String {
    format!("{}, {}", class(task.class), category(task.category))
}

/// A category of flight phase.
pub const fn category(category: Category) -> &'static str {
    match category {
        Category::ACombat => "Category A, combat",
        Category::A => "Category A",
        Category::B => "Category B",
        Category::C => "Category C",
    }
}

/// A category with the phases of flight that it stands for.
pub const fn category_with_phases(category: Category) -> &'static str {
    match category {
        Category::ACombat => "Category A, combat: air combat and ground attack",
        Category::A => "Category A: rapid manoeuvring and precise tracking",
        Category::B => "Category B: climb, cruise, loiter and descent",
        Category::C => "Category C: take-off, approach and landing",
    }
}

/// Symbol of a quantity.
pub const fn symbol(quantity: Quantity) -> &'static str {
    match quantity {
        Quantity::DampingRatio => "ζ",
        Quantity::NaturalFrequency => "ωₙ",
        Quantity::DampingProduct => "ζωₙ",
        Quantity::ControlAnticipation => "CAP",
        Quantity::LoadFactorSlope => "n/α",
        Quantity::TimeConstant => "τ",
        Quantity::TimeToDouble => "T₂",
        Quantity::RollToSideslip => "|φ/β|",
    }
}

/// Unit of a quantity; empty for a pure number.
pub const fn unit(quantity: Quantity) -> &'static str {
    match quantity {
        Quantity::DampingRatio | Quantity::RollToSideslip => "",
        Quantity::NaturalFrequency | Quantity::DampingProduct => "rad/s",
        Quantity::ControlAnticipation => "rad/s² per g",
        Quantity::LoadFactorSlope => "g/rad",
        Quantity::TimeConstant | Quantity::TimeToDouble => "s",
    }
}

/// A number with the unit of its quantity.
fn with_unit(number: &str, quantity: Quantity) -> String {
    match unit(quantity) {
        "" => number.to_owned(),
        unit => format!("{number} {unit}"),
    }
}

/// Table, figure or page of the specification.
pub fn source(source: Source) -> String {
    match source {
        Source::Text { page } => format!("text, p. {page}"),
        Source::Table { number, page } => format!("Table {number}, p. {page}"),
        Source::Figure { number, page } => format!("Figure {number}, p. {page}"),
    }
}

/// Where the limits of a criterion stand.
pub fn citation(criterion: Criterion, category: Category) -> String {
    format!("MIL-F-8785C {}, {}", criterion.paragraph(), source(criterion.source(category)))
}

/// A limit as its line on the pole map has it: "Level 1: ζ 0.3".
pub fn boundary(boundary: &Boundary) -> String {
    let Requirement { quantity, limit, .. } = boundary.requirement;
    let limit = with_unit(&trimmed(limit, 3), quantity);
    format!("{}: {} {limit}", levels(boundary), symbol(quantity))
}

/// A verdict in a sentence or two, with its source and the task it is judged for.
pub fn sentence(verdict: &Verdict) -> String {
    let source = format!("({}; {})", citation(verdict.criterion, verdict.task.category), task(verdict.task));
    let Some(level) = level_or_boundary(verdict) else {
        return format!("{} {source}.", without_level(verdict));
    };
    match (comparison(verdict), verdict.remark.and_then(remark)) {
        (Some(comparison), Some(remark)) => format!("{level}: {comparison} {source}. {remark}"),
        (Some(comparison), None) => format!("{level}: {comparison} {source}."),
        (None, Some(remark)) => format!("{level} {source}. {remark}"),
        (None, None) => format!("{level} {source}."),
    }
}

/// Why a verdict has no level.
const fn without_level(verdict: &Verdict) -> &'static str {
    match verdict.remark {
        Some(Remark::NoRequirement) => "No level: it is an oscillation that this requirement isn’t on",
        Some(Remark::NoModeLeft) => "No level: no mode is left that this requirement is on",
        _ => {
            "Nothing to judge: its two real roots die away, so that no oscillation is left for this requirement"
        }
    }
}

/// The overall level with the criterion that sets it, and what no paragraph judges.
pub fn overall(overall: &OverallLevel<'_>) -> String {
    let OverallLevel { level: worst, governing, unjudged, left_open } = overall;
    match (worst, left_open) {
        (None, Some(verdict)) => match verdict.modes.first() {
            Some(name) => format!(
                "No level overall: {} is not judged, for the {}",
                criterion_in_a_sentence(verdict.criterion),
                mode::in_a_sentence(*name)
            ),
            None => {
                format!("No level overall: {} can’t be judged", criterion_in_a_sentence(verdict.criterion))
            }
        },
        (None, None) => format!("No level overall: {}", not_judged(unjudged)),
        (Some(Level::One), _) => format!("{} overall, every criterion is met", level(Level::One)),
        (Some(worst), _) => {
            format!("{} overall, set by {}", level(*worst), criterion_in_a_sentence(governing.criterion))
        }
    }
}

fn not_judged(names: &[ModeName]) -> String {
    let names: Vec<&str> = names.iter().map(|name| mode::in_a_sentence(*name)).collect();
    format!("no paragraph here judges the growing {}", names.join(" and the "))
}

/// A criterion within a sentence.
pub const fn criterion_in_a_sentence(criterion: Criterion) -> &'static str {
    match criterion {
        Criterion::AirspeedDivergence => "the divergence of airspeed",
        Criterion::PitchDivergence => "the divergence in pitch",
        Criterion::Phugoid => "the damping of the phugoid",
        Criterion::ShortPeriodDamping => "the damping of the short period",
        Criterion::ShortPeriodFrequency => "the frequency of the short period",
        Criterion::DutchRoll => "the Dutch roll",
        Criterion::RollMode => "the roll mode",
        Criterion::Spiral => "the spiral",
        Criterion::CoupledRollSpiral => "the coupled roll–spiral oscillation",
    }
}

/// The level of a verdict, and whether it is on a boundary.
fn level_or_boundary(verdict: &Verdict) -> Option<&'static str> {
    let found = verdict.level?;
    Some(if verdict.on_boundary { on_boundary(found) } else { level(found) })
}

/// A level that the last digit of a value decides.
const fn on_boundary(level: Level) -> &'static str {
    match level {
        Level::One => "Level 1, on the boundary",
        Level::Two => "Level 2, on the boundary",
        Level::Three => "Level 3, on the boundary",
        Level::Beyond => "Worse than Level 3, on the boundary",
    }
}

const fn remark(remark: Remark) -> Option<&'static str> {
    Some(match remark {
        Remark::TwoRealRoots => "Its two real roots are taken as one motion.",
        Remark::AirspeedDiverges => "Levels 1 and 2 allow no divergence of airspeed without oscillation.",
        Remark::PitchDiverges => {
            "No level allows pitch attitude or angle of attack to diverge without oscillation."
        }
        Remark::OscillationGrows => "No level allows an oscillation in yaw and roll to grow.",
        Remark::Diverges => "It diverges.",
        Remark::RollGrows => "The roll rate doesn’t die away.",
        Remark::NotAllowed => "No coupled oscillation of roll and spiral is allowed in this category.",
        Remark::StandsFor => {
            "Judged is an oscillation in which several roots have met, by what carries most of it."
        }
        Remark::NoOscillation | Remark::NoRequirement | Remark::NoModeLeft => return None,
    })
}

/// The value beside its limits; `None` where no number decides.
fn comparison(verdict: &Verdict) -> Option<String> {
    if let Some(Requirement { quantity, limit, .. }) = verdict.met_by_absence {
        let limit = with_unit(&significant(limit, 3), quantity);
        return Some(format!("it never doubles, Level 1 asks {} of at least {limit}", symbol(quantity)));
    }
    let Governing { requirement, of, other, value } = verdict.governing?;
    let Requirement { quantity, is_minimum, limit, raise } = requirement;
    if raise > 0.0 {
        return Some(raised(verdict, &requirement, of, value));
    }
    let [value, limit] = [value, limit].map(|x| significant(x, 3));
    let (symbol, of) = (symbol(quantity), level(of));
    let shown = with_unit(&value, quantity);
    let Some(other) = other.map(|other| significant(other, 3)) else {
        let limit = with_unit(&limit, quantity);
        return Some(if is_minimum {
            format!("{symbol} is {shown}, {of} asks at least {limit}")
        } else {
            format!("{symbol} is {shown}, {of} asks at most {limit}")
        });
    };
    let (low, high) = if is_minimum { (limit, other) } else { (other, limit) };
    let high = with_unit(&high, quantity);
    Some(if verdict.level == Some(Level::One) {
        format!("{symbol} {value} lies within {of}’s {low} to {high}")
    } else {
        format!("{symbol} is {shown}, {of} asks {low} to {high}")
    })
}

/// The value beside a limit that the rolling of a Dutch roll has raised: what the table prints, and what is added to it.
fn raised(verdict: &Verdict, requirement: &Requirement, of: Level, value: f64) -> String {
    let Requirement { quantity, limit, raise, .. } = *requirement;
    let find = |wanted: Quantity| {
        verdict.values.iter().find(|(quantity, _)| *quantity == wanted).map_or(0.0, |v| v.1)
    };
    let (wn, ratio) = (find(Quantity::NaturalFrequency), find(Quantity::RollToSideslip));
    let [printed, added, ratio, rule] =
        [limit - raise, raise, ratio, wn * wn * ratio].map(|x| significant(x, 3));
    format!(
        "{} is {}, {} asks at least {}: {printed} of the table and {added} more, since |φ/β| is {ratio} and ωₙ²|φ/β| is {rule}, \
         above 20",
        symbol(quantity),
        with_unit(&significant(value, 3), quantity),
        level(of),
        with_unit(&significant(limit, 3), quantity),
    )
}
