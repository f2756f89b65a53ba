//! Lines of the levels against the verdicts: a pole that crosses one changes its level.

use std::f64::consts::LN_2;
use std::sync::Arc;

use eigenwing::content::embedded_aircraft;
use eigenwing::flight::aircraft::plane::Plane;
use eigenwing::flight::analysis::PlaneAnalysis;
use eigenwing::flight::modes::approximations::{Approximation, ApproximationName, ModeValue};
use eigenwing::flight::modes::mode_name::ModeName;
use eigenwing::flight::verdicts::handling_qualities::{Level, handling_qualities};
use eigenwing::flight::verdicts::level_boundaries::{Boundary, Line, level_boundaries};
use eigenwing::flight::verdicts::mil_f_8785c::{Category, Class, Criterion, Quantity};
use eigenwing::flight::verdicts::task::Task;
use eigenwing::key::Keyed;
use eigenwing::scenario::Scenario;
use eigenwing::words;
use nalgebra::Complex;

const CRUISE: Task = Task { class: Class::I, category: Category::B };

fn analysed(plane: Plane) -> Vec<PlaneAnalysis> {
    let of = |aircraft| {
        let scenario = Scenario { plane, ..Scenario::new(Arc::new(aircraft)) };
        scenario.analyse().ok()?.planes[plane].as_ref()?.as_ref().ok().cloned()
    };
    embedded_aircraft().0.into_iter().filter_map(of).collect()
}

/// Distance inside a boundary, relative to its size: positive where the pole keeps the limit.
fn inside(boundary: &Boundary, lambda: Complex<f64>) -> f64 {
    let (value, limit) = match boundary.line {
        Line::DampingRatio(zeta) => (-lambda.re / lambda.norm(), zeta),
        Line::NaturalFrequency(wn) => (lambda.norm(), wn),
        Line::RealPart(sigma) => (lambda.re, sigma),
    };
    (if boundary.above { value - limit } else { limit - value }) / limit.abs().max(0.01)
}

/// The best level whose lines the pole keeps, among those of a criterion.
fn level_by_lines(boundaries: &[Boundary], criterion: Criterion, lambda: Complex<f64>) -> Level {
    [Level::One, Level::Two, Level::Three]
        .into_iter()
        .find(|level| {
            boundaries
                .iter()
                .filter(|b| b.criterion == criterion && (b.level..=b.to).contains(level))
                .all(|b| inside(b, lambda) >= 0.0)
        })
        .unwrap_or(Level::Beyond)
}

/// Poles of every aircraft, and the level that the specification's numbers give: the lines give the same. The two that the
/// plane can't show are left out: ζ above 1, which no pair has, and n/α.
#[test]
fn the_lines_give_the_levels_that_the_verdicts_give() {
    let mut compared = 0;
    for plane in Plane::ALL {
        for analysis in analysed(plane) {
            for &class in Class::VALUES {
                for &category in Category::VALUES {
                    let boundaries =
                        level_boundaries(&analysis.model, &analysis.modes, Task { class, category });
                    let task = Task { class, category };
                    for verdict in handling_qualities(&analysis.model, &analysis.modes, task) {
                        let name = verdict.criterion.concerns();
                        let Some(mode) = analysis.modes.iter().find(|mode| mode.naming.name == name) else {
                            continue;
                        };
                        let by_slope = verdict
                            .governing
                            .is_some_and(|g| g.requirement.quantity == Quantity::LoadFactorSlope);
                        if by_slope || verdict.on_boundary || verdict.governing.is_none() {
                            continue;
                        }
                        let level = level_by_lines(&boundaries, verdict.criterion, mode.lambda);
                        assert_eq!(
                            Some(level),
                            verdict.level,
                            "{name:?} {class:?} {category:?} {}",
                            words::verdict::sentence(&verdict)
                        );
                        compared += 1;
                    }
                }
            }
        }
    }
    assert!(compared > 500, "{compared}");
}

fn navion(plane: Plane) -> Vec<Boundary> {
    let aircraft = embedded_aircraft().0.into_iter().find(|aircraft| aircraft.key == "navion");
    let scenario = Scenario { plane, ..Scenario::new(Arc::new(aircraft.expect("the Navion"))) };
    let analysis = scenario.analyse().expect("an analysis");
    let Some(Ok(analysis)) = &analysis.planes[plane] else { panic!("an analysis") };
    level_boundaries(&analysis.model, &analysis.modes, CRUISE)
}

/// The numbers of Tables IV, VI, VII and VIII for Class I, Category B, put in the plane by hand.
#[test]
fn the_lines_of_a_light_aircraft_in_cruise_are_those_of_the_tables() {
    let lines = |boundaries: &[Boundary], criterion: Criterion| -> Vec<(&str, Line)> {
        boundaries
            .iter()
            .filter(|b| b.criterion == criterion)
            .map(|b| (words::verdict::levels(b), b.line))
            .collect()
    };
    let level = |levels: &'static str, line: Line| (levels, line);
    let longitudinal = navion(Plane::Longitudinal);
    assert_eq!(
        lines(&longitudinal, Criterion::ShortPeriodDamping),
        [
            level("Level 1", Line::DampingRatio(0.30)),
            level("Level 2", Line::DampingRatio(0.20)),
            level("Level 3", Line::DampingRatio(0.15)),
        ]
    );
    assert_eq!(
        lines(&longitudinal, Criterion::Phugoid),
        [
            level("Level 1", Line::DampingRatio(0.04)),
            level("Level 2", Line::DampingRatio(0.0)),
            level("Level 3", Line::RealPart(LN_2 / 55.0)),
        ]
    );
    let lateral = navion(Plane::Lateral);
    assert_eq!(
        lines(&lateral, Criterion::RollMode),
        [
            level("Level 1", Line::RealPart(-1.0 / 1.4)),
            level("Level 2", Line::RealPart(-1.0 / 3.0)),
            level("Level 3", Line::RealPart(-0.1)),
        ]
    );
    assert_eq!(
        lines(&lateral, Criterion::Spiral),
        [
            level("Level 1", Line::RealPart(LN_2 / 20.0)),
            level("Level 2", Line::RealPart(LN_2 / 8.0)),
            level("Level 3", Line::RealPart(LN_2 / 4.0)),
        ]
    );
    let dutch_roll = lines(&lateral, Criterion::DutchRoll);
    assert!(dutch_roll.contains(&level("Level 1", Line::RealPart(-0.15))), "{dutch_roll:?}");
    assert!(dutch_roll.contains(&level("Levels 1–3", Line::NaturalFrequency(0.4))), "{dutch_roll:?}");
}

#[test]
fn an_approximation_gives_the_root_of_its_frequency_and_damping() {
    let of = |value| Approximation {
        name: ApproximationName::ShortPeriodTwoStates,
        value: Some(value),
        exact: None,
    };
    let second = |wn: f64, zeta: f64| {
        let value = ModeValue::SecondOrder { natural_frequency: wn, damping_ratio: Some(zeta) };
        of(value).root().expect("a root")
    };
    for (wn, zeta) in [(3.6, 0.69), (2.0, -0.3), (0.2, 0.0), (1.5, 2.0), (1.5, -2.0), (1.0, 1e6)] {
        let root = second(wn, zeta);
        // λ² + 2ζωₙλ + ωₙ² = 0, to rounding of its largest term
        let left = root * root + root * (2.0 * zeta * wn) + wn * wn;
        assert!(left.norm() <= 1e-15 * 4.0 * (wn * wn).max((root * zeta * wn).norm()), "{wn} {zeta}: {left}");
        assert!(root.im >= 0.0);
    }
    assert_eq!(of(ModeValue::Root(-0.3)).root(), Some(Complex::from(-0.3)));
    let undamped = ModeValue::SecondOrder { natural_frequency: 1.0, damping_ratio: None };
    assert_eq!(of(undamped).root(), None);
}

#[test]
fn every_mode_of_a_course_has_one_principal_approximation() {
    for plane in Plane::ALL {
        for analysis in analysed(plane) {
            for mode in &analysis.modes {
                let of_mode =
                    analysis.approximations.iter().filter(|a| a.name.concerns() == mode.naming.name);
                let principal = of_mode.filter(|a| a.name.is_principal()).count();
                let named = matches!(
                    mode.naming.name,
                    ModeName::ShortPeriod
                        | ModeName::Phugoid
                        | ModeName::DutchRoll
                        | ModeName::RollSubsidence
                        | ModeName::Spiral
                );
                assert_eq!(principal, usize::from(named), "{:?}", mode.naming.name);
            }
        }
    }
}
