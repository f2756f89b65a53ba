//! Every linear motion is the sum of its modes.

use std::sync::Arc;

use eigenwing::content::embedded_aircraft;
use eigenwing::findings::Findings;
use eigenwing::flight::aircraft::plane::Plane;
use eigenwing::flight::analysis::Motion;
use eigenwing::flight::modes::mode::{Mode, modes};
use eigenwing::flight::motion::modal_decomposition::{SplitError, WORST_SPLIT};
use eigenwing::flight::motion::outputs::Output;
use eigenwing::scenario::{Parameter, Scenario, Source};
use eigenwing::words;

fn scenarios() -> impl Iterator<Item = Scenario> {
    let (aircraft, errors) = embedded_aircraft();
    assert!(errors.is_empty());
    aircraft.into_iter().map(|aircraft| Scenario::new(Arc::new(aircraft)))
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most: f64, x| most.max(x.abs()))
}

/// Calls `check` with the motion after every disturbance of every second aircraft.
fn for_every_motion(mut check: impl FnMut(&str, &Motion, &[Mode])) {
    for aircraft in scenarios().step_by(2) {
        for plane in Plane::ALL {
            for &source in Source::of(plane) {
                let mut scenario = aircraft.clone();
                scenario.plane = plane;
                scenario.disturbance.choices[plane].source = source;
                let shapes = source.shapes();
                for k in 0..shapes.len().max(1) {
                    if let Some(shape) = shapes.get(k) {
                        *scenario.disturbance.choices[plane].shape_mut() = *shape;
                    }
                    // Growing motions stay small enough for a sum to mean something.
                    scenario.disturbance.sizes.time = 20.0;
                    let analysis = scenario.analyse().expect("an analysis");
                    let (Some(Ok(analysed)), Some(motion)) = (&analysis.planes[plane], &analysis.motion)
                    else {
                        continue;
                    };
                    let name = format!(
                        "{} {}",
                        aircraft.aircraft.key,
                        words::disturbance::choice(&scenario.disturbance.choices[plane])
                    );
                    check(&name, motion, &analysed.modes);
                }
            }
        }
    }
}

#[test]
fn the_parts_and_the_rest_add_up_to_every_output_of_every_motion() {
    let mut splits = 0;
    for_every_motion(|name, motion, modes| {
        for &output in Output::of(motion.model.plane) {
            let whole = motion.values(output);
            let Ok(sum) = motion.split(modes, output) else { continue };
            splits += 1;
            for (k, value) in whole.iter().enumerate().step_by(7) {
                let parts: f64 = sum.parts.iter().map(|part| part[k]).sum();
                let off = (parts + sum.rest[k] - value).abs();
                assert!(off <= 1e-9 * largest(&whole), "{name} {output:?} at {k}: off by {off:e}");
            }
        }
    });
    assert!(splits > 1000, "{splits}");
}

/// The rest is no dustbin: of an output that is made of states alone nothing may be left over.
#[test]
fn of_the_states_the_modes_alone_are_the_whole() {
    let mut splits = 0;
    for_every_motion(|name, motion, modes| {
        let states = match motion.model.plane {
            Plane::Longitudinal => {
                [Output::ForwardSpeed, Output::DownSpeed, Output::PitchRate, Output::PitchAngle]
            }
            Plane::Lateral => [Output::SideSpeed, Output::RollRate, Output::YawRate, Output::BankAngle],
        };
        for output in states {
            let Ok(sum) = motion.split(modes, output) else { continue };
            splits += 1;
            let peak =
                largest(&motion.values(output)).max(sum.parts.iter().map(|p| largest(p)).fold(0.0, f64::max));
            assert!(
                largest(&sum.rest) <= 1e-9 * peak,
                "{name} {output:?}: {:e} of {peak:e}",
                largest(&sum.rest)
            );
        }
    });
    assert!(splits > 500, "{splits}");
}

/// Each part obeys the equation of its own mode, z̈ − 2σ ż + |λ|² z = 0, once the input has gone.
#[test]
fn a_part_moves_as_its_mode_does() {
    let mut scenario = scenarios().next().expect("the Navion");
    scenario.disturbance.choices.longitudinal.source = Source::Release;
    scenario.disturbance.sizes.time = 6.0;
    let analysis = scenario.analyse().expect("an analysis");
    let motion = analysis.motion.as_ref().expect("a motion");
    let modes = &analysis.planes[Plane::Longitudinal].as_ref().expect("data").as_ref().expect("modes").modes;
    for output in [Output::AngleOfAttack, Output::NormalLoad, Output::Height, Output::PathAngle] {
        let sum = motion.split(modes, output).expect("a split");
        for (mode, part) in modes.iter().zip(&sum.parts) {
            let lambda = mode.lambda;
            let dt = motion.response.dt;
            let decay = (lambda.re * dt).exp();
            for three in part.windows(3) {
                // Exactly: z(t+h) − 2 e^{σh} cos ωh z(t) + e^{2σh} z(t−h) = 0
                let off =
                    three[2] - 2.0 * decay * (lambda.im * dt).cos() * three[1] + decay * decay * three[0];
                assert!(off.abs() <= 1e-12 * largest(part).max(1e-9), "{output:?}: {off:e}");
            }
        }
    }
}

/// One mode flown alone stays alone: all the other parts are nothing.
#[test]
fn one_mode_alone_stays_alone() {
    for aircraft in scenarios() {
        for plane in Plane::ALL {
            let mut scenario = aircraft.clone();
            scenario.plane = plane;
            scenario.disturbance.choices[plane].source = Source::OneMode;
            let analysis = scenario.analyse().expect("an analysis");
            let Some(Ok(analysed)) = &analysis.planes[plane] else { continue };
            for index in 0..analysed.modes.len() {
                scenario.disturbance.choices[plane].mode = index;
                // Long enough to see it, short enough that rounding in a growing mode stays rounding.
                let slowest = analysed.modes[index].lambda.norm().max(1e-3);
                scenario.disturbance.sizes.time = (3.0 / slowest).clamp(2.0, 300.0);
                let analysis = scenario.analyse().expect("an analysis");
                let motion = analysis.motion.as_ref().expect("a motion");
                let Some(Ok(analysed)) = &analysis.planes[plane] else { unreachable!("it was there") };
                let Ok(sum) = motion.split(&analysed.modes, Output::of(plane)[2]) else { continue };
                let own = largest(&sum.parts[index]);
                for (other, part) in sum.parts.iter().enumerate() {
                    let growth =
                        (analysed.modes[other].lambda.re * scenario.disturbance.sizes.time).exp().max(1.0);
                    assert!(
                        other == index || largest(part) <= 1e-9 * own * growth,
                        "{} {}: {:e} of {own:e} in mode {other}",
                        aircraft.aircraft.key,
                        words::mode::title(analysed.modes[index].naming.name),
                        largest(part)
                    );
                }
            }
        }
    }
}

/// The largest of flow angle and attitude begins at the size asked for.
#[test]
fn one_mode_alone_begins_at_its_size() {
    let mut scenario = scenarios().next().expect("the Navion");
    scenario.disturbance.choices.longitudinal.source = Source::OneMode;
    for (mode, output) in [(0, Output::AngleOfAttack), (1, Output::PitchAngle)] {
        scenario.disturbance.choices.longitudinal.mode = mode;
        let analysis = scenario.analyse().expect("an analysis");
        let motion = analysis.motion.expect("a motion");
        // The short period's pitch angle is a little smaller than its angle of attack; the phugoid is all pitch.
        let start = motion.values(output)[0];
        assert!((start - scenario.disturbance.sizes.mode).abs() < 1e-12, "{output:?} begins at {start}");
    }
}

#[test]
fn near_a_repeated_root_the_response_is_exact_and_the_split_says_that_it_means_nothing() {
    let mut scenario = scenarios().next().expect("the Navion");
    let stiffness = Parameter::find("cm_alpha").expect("a parameter");
    // Where the two roots of the short period meet: bisected between a pair and two real roots.
    let condition_at = |scenario: &mut Scenario, value: f64| {
        stiffness.set(scenario, value);
        let model = scenario.edited.models().expect("models").planes.longitudinal.expect("data");
        let found = modes(&model).expect("modes");
        (found.len(), found.iter().map(|mode| mode.condition).fold(0.0, f64::max))
    };
    let (mut pair, mut apart) = (-0.683, -0.1);
    for _ in 0..60 {
        let middle = 0.5 * (pair + apart);
        if condition_at(&mut scenario, middle).0 == 2 { pair = middle } else { apart = middle }
    }
    let (_, condition) = condition_at(&mut scenario, pair);
    assert!(condition > 1e3 * WORST_SPLIT, "{condition:e}");
    let analysis = scenario.analyse().expect("an analysis");
    let motion = analysis.motion.as_ref().expect("a motion");
    let modes_here =
        &analysis.planes[Plane::Longitudinal].as_ref().expect("data").as_ref().expect("modes").modes;
    let error = motion.split(modes_here, Output::AngleOfAttack).expect_err("no split");
    assert!(matches!(error, SplitError::Dependent { .. }), "{error}");
    // The response itself passes smoothly through: it is the mean of its neighbours on either side.
    let at = |value: f64| {
        let mut scenario = scenario.clone();
        stiffness.set(&mut scenario, value);
        scenario.analyse().expect("an analysis").motion.expect("a motion").values(Output::AngleOfAttack)
    };
    let (before, here, after) = (at(pair - 1e-5), at(pair), at(pair + 1e-5));
    let peak = largest(&here);
    for k in 0..here.len() {
        assert!((0.5 * (before[k] + after[k]) - here[k]).abs() < 1e-8 * peak, "at {k}");
    }
}

/// The integral of a mode is that mode too: ψ = ∫ r dt/cos θ₀, y, h and x swing about zero with it and come back there, in linear
/// flight and, of a small one, in nonlinear flight.
#[test]
fn the_path_of_an_oscillation_alone_comes_back_to_zero() {
    let mut swung = 0;
    for mut scenario in scenarios() {
        for plane in [Plane::Longitudinal, Plane::Lateral] {
            scenario.plane = plane;
            let Ok(analysis) = scenario.analyse() else { continue };
            let Some(Ok(analysed)) = &analysis.planes[plane] else { continue };
            let modes = analysed.modes.clone();
            for (index, mode) in modes.iter().enumerate().filter(|(_, mode)| mode.is_oscillatory()) {
                let choice = &mut scenario.disturbance.choices[plane];
                (choice.source, choice.mode) = (Source::OneMode, index);
                scenario.disturbance.sizes.time = 2.0 * std::f64::consts::TAU / mode.lambda.im;
                let motion = scenario.analyse().expect("an analysis").motion.expect("a motion");
                let outputs = match plane {
                    Plane::Longitudinal => [Output::Height, Output::Distance],
                    Plane::Lateral => [Output::Heading, Output::Offset],
                };
                for output in outputs {
                    let values = motion.values(output);
                    // Two periods: half of one later it is on the other side, smaller or larger by e^{σT/2}.
                    let half = values.len() / 4;
                    let shrunk = (mode.lambda.re * half as f64 * motion.response.dt).exp();
                    let most = values.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
                    for k in 0..values.len() - half {
                        let off = (values[k + half] + shrunk * values[k]).abs();
                        assert!(
                            off < 1e-6 * most,
                            "{} {output:?} at {k}: {off} of {most}",
                            scenario.aircraft.key
                        );
                    }
                    swung += 1;
                }
                (scenario.disturbance.sizes.times, scenario.disturbance.sizes.time) = (1e-3, 0.1);
                let small = Findings::of(scenario.clone());
                let linear = small.motion().expect("a motion");
                if let Some(Ok(flight)) = small.flight() {
                    for output in outputs {
                        let first = output.of_flight(&linear.model, flight)[0];
                        let want = linear.values(output)[0];
                        assert!(
                            (first - want).abs() < 1e-9 * want.abs().max(1.0),
                            "{output:?}: {first} {want}"
                        );
                    }
                }
                scenario.disturbance.sizes.times = 1.0;
            }
        }
    }
    assert!(swung > 60, "{swung}");
}
