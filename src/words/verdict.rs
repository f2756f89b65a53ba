//! Handling qualities: levels, what they are judged by, and each verdict in a sentence.

use crate::flight::verdicts::handling_qualities::{Governing, Level, Remark, Verdict};
use crate::flight::verdicts::level_boundaries::Boundary;
use crate::flight::verdicts::mil_f_8785c::{Category, Criterion, Quantity, Requirement, Source};
use crate::number::{significant, trimmed};

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
        Criterion::Phugoid => "Phugoid damping",
        Criterion::ShortPeriodDamping => "Short-period damping",
        Criterion::ShortPeriodFrequency => "Short-period frequency",
        Criterion::DutchRoll => "Dutch roll",
        Criterion::RollMode => "Roll mode",
        Criterion::Spiral => "Spiral",
        Criterion::CoupledRollSpiral => "Coupled roll–spiral",
    }
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
        Category::ACombat => "Category A of flight: air combat and ground attack",
        Category::A => "Category A of flight: rapid manoeuvring and precise tracking",
        Category::B => "Category B of flight: climb, cruise, loiter and descent",
        Category::C => "Category C of flight: take-off, approach and landing",
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
    }
}

/// Unit of a quantity; empty for a pure number.
pub const fn unit(quantity: Quantity) -> &'static str {
    match quantity {
        Quantity::DampingRatio => "",
        Quantity::NaturalFrequency | Quantity::DampingProduct => "rad/s",
        Quantity::ControlAnticipation => "(rad/s)²/(g/rad)",
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

/// A verdict in a sentence or two, with its source.
pub fn sentence(verdict: &Verdict) -> String {
    let level = if verdict.on_boundary { on_boundary(verdict.level) } else { level(verdict.level) };
    let source =
        format!("({}, {})", citation(verdict.criterion, verdict.category), category(verdict.category));
    match (comparison(verdict), verdict.remark.map(remark)) {
        (Some(comparison), Some(remark)) => format!("{level}: {comparison} {source}. {remark}"),
        (Some(comparison), None) => format!("{level}: {comparison} {source}."),
        (None, Some(remark)) => format!("{level} {source}. {remark}"),
        (None, None) => format!("{level} {source}."),
    }
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

const fn remark(remark: Remark) -> &'static str {
    match remark {
        Remark::TwoRealRoots => "Its two real roots are taken as one motion.",
        Remark::Diverges => "It diverges.",
        Remark::RollGrows => "The roll rate doesn’t die away.",
        Remark::NotAllowed => "No coupled oscillation of roll and spiral is allowed in this category.",
    }
}

/// The value beside its limits; `None` where no number decides.
fn comparison(verdict: &Verdict) -> Option<String> {
    if let Some(Requirement { quantity, limit, .. }) = verdict.met_by_absence {
        let limit = with_unit(&significant(limit, 3), quantity);
        return Some(format!("it never doubles, Level 1 asks {} of at least {limit}", symbol(quantity)));
    }
    let Governing { requirement, of, other, value } = verdict.governing?;
    let Requirement { quantity, is_minimum, limit } = requirement;
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
    Some(if verdict.level == Level::One {
        format!("{symbol} {value} lies within {of}’s {low} to {high}")
    } else {
        format!("{symbol} is {shown}, {of} asks {low} to {high}")
    })
}
