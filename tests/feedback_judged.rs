//! What modes under a law are called, and that what a pilot feels of them is judged: what must hold of any law, over pairs and triples of
//! gains, washouts and lags. The rules are told here by shapes alone, and not as the program follows its roots.

mod reference;

use std::sync::Arc;

use eigenwing::content::embedded_aircraft;
use eigenwing::findings::Findings;
use eigenwing::flight::aircraft::plane::{Plane, PlaneModel};
use eigenwing::flight::feedback::appended::AppendedState;
use eigenwing::flight::feedback::loop_modes::LoopMode;
use eigenwing::flight::feedback::{Law, LoopAnalysis, analyse_loop};
use eigenwing::flight::modes::mode_name::ModeName;
use eigenwing::flight::modes::stability::Stability;
use eigenwing::flight::verdicts::handling_qualities::{Level, Verdict};
use eigenwing::flight::verdicts::mil_f_8785c::Criterion;
use eigenwing::flight::verdicts::overall_level::overall_level;
use eigenwing::flight::verdicts::task::Task;
use eigenwing::scenario::{Parameter, Scenario};

/// Gains of one plane as (input, signal, gain).
type Gains = Vec<(usize, usize, f64)>;

/// Pairs and triples of gains of a plane, of either sign and of several sizes; numbered so that a few of them can be taken.
fn some_gains(plane: Plane) -> Vec<Gains> {
    let size = |signal: usize| match plane {
        Plane::Longitudinal => [0.01, 1.0, 1.0, 1.0, 0.01][signal],
        Plane::Lateral => [1.0, 0.3, 2.0, 0.5, 0.3][signal],
    };
    let all: Vec<(usize, usize, f64)> = (0..2)
        .flat_map(|input| {
            (0..5).flat_map(move |signal| {
                [-1.0, 0.3, 1.0].map(move |share| (input, signal, share * size(signal)))
            })
        })
        .collect();
    let mut gains: Vec<Gains> = all.iter().map(|gain| vec![*gain]).collect();
    for (i, first) in all.iter().enumerate() {
        for (j, second) in all.iter().enumerate().skip(i + 1) {
            if (first.0, first.1) == (second.0, second.1) {
                continue;
            }
            gains.push(vec![*first, *second]);
            let third = all[(7 * i + 11 * j) % all.len()];
            if [first, second].iter().all(|of| (of.0, of.1) != (third.0, third.1)) {
                gains.push(vec![*first, *second, third]);
            }
        }
    }
    gains
}

fn law_of(plane: Plane, gains: &Gains, washout: f64, actuator: f64) -> Law {
    let mut law = Law { actuator, engine: 2.0 * actuator, ..Law::default() };
    let of_plane = &mut law.planes[plane];
    of_plane.washout = washout;
    for &(input, signal, gain) in gains {
        let to = if input == 0 { &mut of_plane.to_first } else { &mut of_plane.to_second };
        to[signal] = gain;
    }
    law
}

const LAGS: [(f64, f64); 4] = [(0.0, 0.1), (3.0, 0.1), (3.0, 1.0), (0.0, 1.0)];

/// Laws over several aircraft, every so many of all.
fn each_law(every: usize, mut told: impl FnMut(&str, &PlaneModel, Law)) {
    let mut count = 0;
    for reference in reference::references() {
        for plane in Plane::ALL {
            let model = reference.model(plane);
            for gains in some_gains(plane) {
                for (washout, actuator) in LAGS {
                    count += 1;
                    if count % every == 0 {
                        let what = format!(
                            "{} {plane:?} {gains:?} washout {washout} actuator {actuator}",
                            reference.id
                        );
                        told(&what, &model, law_of(plane, &gains, washout, actuator));
                    }
                }
            }
        }
    }
}

/// A real root that is nearly all of one state has the name of that state.
#[test]
fn a_root_that_is_nearly_all_of_one_state_has_its_name() {
    use AppendedState::{Aileron, Elevator, Heading, Height, Rudder, Throttle};
    let mut seen = 0;
    each_law(7, |what, model, law| {
        let analysis = analyse_loop(model, &law, None).expect("it can be analysed");
        for mode in analysis.modes.iter().filter(|mode| !mode.mode.is_oscillatory()) {
            let Some(state) = mode.participation.iter().position(|share| *share >= 0.85) else { continue };
            let names: &[ModeName] = match (model.plane, state) {
                (Plane::Lateral, 1) => &[ModeName::RollSubsidence, ModeName::RollDivergence],
                (Plane::Lateral, 3) => &[ModeName::Spiral],
                (_, 0..4) => continue,
                (_, k) => match analysis.closed.appended[k - 4] {
                    Heading => &[ModeName::Heading],
                    Height => &[ModeName::Height],
                    Elevator => &[ModeName::ElevatorActuator],
                    Throttle => &[ModeName::Engine],
                    Aileron => &[ModeName::AileronActuator],
                    Rudder => &[ModeName::RudderActuator],
                    _ => continue,
                },
            };
            let shares = &mode.participation;
            assert!(
                names.contains(&mode.mode.naming.name),
                "{what}: {} is {:?} {shares:?}",
                mode.mode.lambda,
                mode.mode.naming.name
            );
            seen += 1;
        }
    });
    assert!(seen > 2000, "{seen}");
}

/// A gain that moves nothing renames nothing.
#[test]
fn a_gain_next_to_nothing_leaves_the_names_of_all_roots_that_it_doesn_t_move() {
    let mut seen = 0;
    let references = reference::references();
    for (reference, plane) in references.iter().flat_map(|of| Plane::ALL.map(|plane| (of, plane))) {
        let model = reference.model(plane);
        let bases = some_gains(plane);
        for (n, gains) in bases.iter().enumerate().filter(|(n, _)| n % 23 == 3) {
            let (washout, actuator) = LAGS[n % LAGS.len()];
            let base = analyse_loop(&model, &law_of(plane, gains, washout, actuator), None)
                .expect("it can be analysed");
            for (input, signal) in (0..2).flat_map(|input| (0..5).map(move |signal| (input, signal))) {
                if gains.iter().any(|of| (of.0, of.1) == (input, signal)) {
                    continue;
                }
                let mut more = gains.clone();
                more.push((input, signal, -1e-7));
                let moved =
                    analyse_loop(&model, &law_of(plane, &more, washout, actuator), None).expect("likewise");
                for mode in &base.modes {
                    // Where a shape is mixed its name is a matter of the way on which its root was followed.
                    let is_clear = mode.participation.iter().any(|share| *share >= 0.75);
                    let Some(same) = unmoved(mode, &base, &moved).filter(|_| is_clear) else { continue };
                    let what = format!(
                        "{} {plane:?} {gains:?} {washout} {actuator} with {input} {signal}",
                        reference.id
                    );
                    assert_eq!(mode.mode.naming.name, same.mode.naming.name, "{what}: {}", mode.mode.lambda);
                    seen += 1;
                }
            }
        }
    }
    assert!(seen > 5000, "{seen}");
}

/// The same mode with a gain more: where it stands alone, with and without.
fn unmoved<'a>(mode: &LoopMode, base: &LoopAnalysis, moved: &'a LoopAnalysis) -> Option<&'a LoopMode> {
    let size = base.modes.iter().map(|other| other.mode.lambda.norm()).fold(0.0, f64::max);
    let near = |of: &LoopMode, within: f64| (of.mode.lambda - mode.mode.lambda).norm() < within * size;
    let is_alone = |of: &LoopAnalysis| of.modes.iter().filter(|other| near(other, 1e-2)).count() == 1;
    let is_alone = is_alone(base) && is_alone(moved);
    moved.modes.iter().find(|other| is_alone && near(other, 1e-5))
}

/// Task of the limits below: Class III in Category B.
fn class_three() -> Task {
    let found = embedded_aircraft()
        .0
        .into_iter()
        .find(|aircraft| aircraft.key == "b747-cruise-etkin")
        .expect("it ships");
    Scenario::new(Arc::new(found)).task.expect("a class")
}

fn level_of(closed: &LoopAnalysis) -> Option<Level> {
    let modes: Vec<_> = closed.modes.iter().map(|mode| mode.mode.clone()).collect();
    overall_level(std::iter::once((closed.levels.as_slice(), modes.as_slice())))?.level
}

/// The level that a law is told to have is no better than what its oscillations would be judged as by hand, and the roll is among what
/// was judged.
#[test]
fn no_level_is_claimed_with_a_mode_of_flight_that_misses_it_or_is_not_judged() {
    let task = class_three();
    let (mut levels, mut without, mut of_feedback) = ([0; 3], 0, 0);
    each_law(5, |what, model, law| {
        let closed = analyse_loop(model, &law, Some(task)).expect("it can be analysed");
        let Some(level) = level_of(&closed) else {
            without += 1;
            return;
        };
        if level == Level::Beyond {
            return;
        }
        levels[level as usize] += 1;
        assert!(
            closed
                .modes
                .iter()
                .all(|mode| mode.mode.stability != Stability::Unstable || is_judged(&closed, mode)),
            "{what}"
        );
        for mode in closed.modes.iter().filter(|mode| mode.mode.is_oscillatory()) {
            let shares = &mode.participation;
            if shares.iter().take(4).sum::<f64>() < 0.5 {
                continue;
            }
            assert!(is_judged(&closed, mode), "{what}: {} {level:?}", mode.mode.lambda);
            of_feedback += usize::from(mode.mode.naming.name == ModeName::FeedbackOscillation);
            let (wn, product) = (mode.mode.lambda.norm(), -mode.mode.lambda.re);
            let zeta = product / wn;
            // Class III in Category B: Tables IV and VI, and 3.2.1.2.
            let least = match model.plane {
                Plane::Lateral
                    if shares[0] + shares[2] > shares[1].max(shares[3])
                        && mode.mode.naming.name != ModeName::CoupledRollSpiral =>
                {
                    let met = [zeta >= 0.08 && product >= 0.15, zeta >= 0.02 && product >= 0.05, zeta >= 0.0];
                    met.iter().position(|met| *met && wn >= 0.4)
                }
                Plane::Lateral => continue,
                Plane::Longitudinal if shares[1] + shares[2] > 2.0 * (shares[0] + shares[3]) => {
                    [0.3, 0.2, 0.15].iter().position(|least| zeta >= *least)
                }
                Plane::Longitudinal => [zeta >= 0.04, zeta >= 0.0, true].iter().position(|met| *met),
            };
            assert!(
                least.is_some_and(|least| level as usize >= least),
                "{what}: {} is no {level:?}",
                mode.mode.lambda
            );
        }
        let judged = |criteria: &[Criterion]| {
            closed
                .levels
                .iter()
                .any(|verdict| verdict.level.is_some() && criteria.contains(&verdict.criterion))
        };
        assert!(
            match model.plane {
                Plane::Lateral => judged(&[Criterion::RollMode, Criterion::CoupledRollSpiral]),
                Plane::Longitudinal => judged(&[Criterion::ShortPeriodDamping, Criterion::PitchDivergence]),
            },
            "{what}: {:?}",
            closed.levels
        );
    });
    assert!(
        levels.iter().all(|count| *count > 30) && without > 100 && of_feedback > 30,
        "{levels:?} {without} {of_feedback}"
    );
}

fn is_judged(closed: &LoopAnalysis, mode: &LoopMode) -> bool {
    let judges =
        |verdict: &Verdict| verdict.level.is_some() && verdict.modes.contains(&mode.mode.naming.name);
    closed.levels.iter().any(judges)
}

fn findings(key: &str, plane: Plane, values: &[(&str, f64)]) -> Findings {
    let found = embedded_aircraft().0.into_iter().find(|aircraft| aircraft.key == key);
    let mut scenario = Scenario::new(Arc::new(found.expect("it ships")));
    scenario.plane = plane;
    for (key, value) in values {
        Parameter::find(key).expect("a row").set(&mut scenario, *value);
    }
    Findings::of(scenario)
}

/// A yaw damper with a late actuator: its oscillation of 77 % aircraft misses Level 2, and the root of the roll rate is the roll mode.
#[test]
fn a_yaw_damper_whose_oscillation_misses_level_2_is_not_level_1() {
    let late = findings(
        "b747-cruise-etkin",
        Plane::Lateral,
        &[("k.r_dr", 5.0), ("washout", 3.0), ("actuator", 1.0)],
    );
    let closed = late.closed_loop().expect("a law").as_ref().expect("it can be analysed");
    let criterion = |criterion| closed.levels.iter().filter(move |verdict| verdict.criterion == criterion);
    assert_eq!(criterion(Criterion::DutchRoll).filter_map(|verdict| verdict.level).max(), Some(Level::Three));
    let roll = criterion(Criterion::RollMode).find_map(|verdict| verdict.level);
    assert_eq!(roll, Some(Level::Two), "{:?}", closed.levels);
    assert_eq!(late.overall_level_in_flight(), Some(Level::Three));
}

/// Roll and actuator oscillate together: no requirement is on that, so that there is no level, and the sentence says why.
#[test]
fn a_roll_mode_that_has_gone_into_an_oscillation_leaves_no_level() {
    let late = findings("navion", Plane::Lateral, &[("k.p_da", -1.0), ("actuator", 1.0)]);
    let overall = late.flown_level().expect("something is judged");
    assert_eq!((overall.level, overall.unjudged.as_slice()), (None, &[ModeName::FeedbackOscillation][..]));
    let sentence = eigenwing::words::verdict::overall(&overall);
    assert_eq!(
        sentence,
        "No level overall: the roll mode is not judged, for the oscillation of the feedback"
    );
}

/// What brings a heading back is called so, whichever root crosses another on the way there.
#[test]
fn the_root_of_the_heading_is_called_the_heading() {
    for (key, gain) in [("c47", -1e-6), ("cherokee-180", -0.3), ("navion", -0.01)] {
        let law = [("k.phi_da", -1.0), ("actuator", 0.1), ("k.psi_da", gain)];
        let held = findings(key, Plane::Lateral, &law);
        let closed = held.closed_loop().expect("a law").as_ref().expect("it can be analysed");
        let heading = closed
            .closed
            .appended
            .iter()
            .position(|state| *state == AppendedState::Heading)
            .expect("it is held");
        let most = closed
            .modes
            .iter()
            .max_by(|a, b| a.participation[4 + heading].total_cmp(&b.participation[4 + heading]));
        assert_eq!(most.expect("modes").mode.naming.name, ModeName::Heading, "{key}");
    }
}
