//! Why a mode has moved: parts that add up, the changes that students wonder at, and sentences that agree with the numbers.

use std::sync::Arc;

use eigenwing::content::embedded_aircraft;
use eigenwing::findings::Findings;
use eigenwing::findings::change::{Change, Kind, NewTrim, Oscillation, Shift, Terms, reference_of};
use eigenwing::flight::aircraft::plane::Plane;
use eigenwing::flight::modes::approximations::ApproximationName;
use eigenwing::flight::modes::mode_name::ModeName;
use eigenwing::scenario::{Convention, Parameter, Scenario, Shape, Source, parameters};
use eigenwing::words;

fn navion(plane: Plane) -> Scenario {
    let found = embedded_aircraft().0.into_iter().find(|aircraft| aircraft.key == "navion");
    Scenario { plane, ..Scenario::new(Arc::new(found.expect("it ships"))) }
}

fn with(mut scenario: Scenario, key: &str, value: f64) -> Findings {
    Parameter::find(key).expect("a row").set(&mut scenario, value);
    Findings::of(scenario)
}

fn since_reference(after: &Findings) -> Change {
    Change::between(&Findings::of(reference_of(after.scenario())), after).expect("something has changed")
}

fn oscillation(change: &Change, name: ModeName) -> &Oscillation {
    let mode = change.modes.iter().find(|mode| mode.name == name).expect("the mode is there");
    let Kind::Oscillation(oscillation) = &mode.kind else { panic!("{mode:?}") };
    oscillation
}

fn text(change: &Change, name: ModeName) -> String {
    let mode = change.modes.iter().find(|mode| mode.name == name).expect("the mode is there");
    let reasons = words::change::reasons(change, mode, Convention::SI).expect("it has moved");
    let sentences: Vec<String> = std::iter::once(reasons.headline).chain(reasons.more).collect();
    sentences.join(" ").replace('\u{a0}', " ")
}

/// Share of the largest cause, and its key.
fn first_cause(shift: &Shift) -> (&'static str, f64) {
    let cause = shift.causes.as_ref().and_then(|causes| causes.first()).expect("parts");
    (cause.moved.key, cause.part / shift.change())
}

/// Every slider of every aircraft in both planes, a quarter of its value or an eighth of its range to either side.
fn every_quarter(mut see: impl FnMut(&Findings, &Change)) -> usize {
    let mut seen = 0;
    for aircraft in embedded_aircraft().0.into_iter().map(Arc::new) {
        for plane in Plane::ALL {
            let scenario = Scenario { plane, ..Scenario::new(aircraft.clone()) };
            let before = Findings::of(reference_of(&scenario));
            for p in parameters().filter(|p| p.page.is_some() && p.applies(&scenario)) {
                let value = p.get(&scenario);
                let range = p.range(&scenario);
                let step = if value == 0.0 { (range.end() - range.start()) / 8.0 } else { value / 4.0 };
                for value in [value - step, value + step] {
                    let mut moved = scenario.clone();
                    p.set(&mut moved, value);
                    let after = Findings::of(moved);
                    if let Some(change) = Change::between(&before, &after) {
                        see(&after, &change);
                        seen += 1;
                    }
                }
            }
        }
    }
    seen
}

fn shifts(change: &Change) -> Vec<(ModeName, &Shift)> {
    let of = |kind| match kind {
        &Kind::Still | &Kind::New => Vec::new(),
        Kind::Root(shift) => vec![shift],
        Kind::Oscillation(oscillation) => vec![&oscillation.frequency, &oscillation.damping_ratio],
    };
    change.modes.iter().flat_map(|mode| of(&mode.kind).into_iter().map(|shift| (mode.name, shift))).collect()
}

/// The integral of the exact sensitivities over every derivative is the change: to 0.1 %, or to rounding of the number itself.
#[test]
fn the_parts_of_the_derivatives_add_up_to_the_change() {
    let (mut proved, mut unproved) = (0, 0);
    let seen = every_quarter(|after, change| {
        for (name, shift) in shifts(change) {
            let Some(causes) = &shift.causes else {
                unproved += 1;
                continue;
            };
            let sum: f64 = causes.iter().map(|cause| cause.part).sum();
            let allowed = 1e-3 * shift.change().abs() + 1e-9 * (shift.from.abs() + shift.to.abs());
            let aircraft = &after.scenario().aircraft.key;
            assert!((sum - shift.change()).abs() <= allowed, "{aircraft}, {name:?}: {sum}, {shift:?}");
            proved += 1;
        }
    });
    assert!(seen > 2000, "{seen}");
    // Where roots of two modes meet on the way there are no parts.
    assert!(proved > 2000 && 20 * unproved < proved, "{proved} and {unproved}");
}

/// A Gaussian rule is right to ten digits and more where nothing meets: no derivative is forgotten.
#[test]
fn the_parts_of_a_smooth_change_add_up_to_ten_digits() {
    for (plane, key, value) in [
        (Plane::Longitudinal, "speed", 60.0),
        (Plane::Longitudinal, "mass", 1.3),
        (Plane::Lateral, "gamma", 0.1),
        (Plane::Lateral, "mass", 1.3),
        (Plane::Lateral, "ix", 1.3),
    ] {
        let after = with(navion(plane), key, value);
        for (name, shift) in shifts(&since_reference(&after)) {
            let sum: f64 = shift.causes.as_ref().expect("nothing meets").iter().map(|cause| cause.part).sum();
            let error = (sum - shift.change()).abs();
            assert!(error <= 1e-8 * shift.from.abs(), "{key}, {name:?}: {sum} for {}", shift.change());
        }
    }
}

/// Twice C_mq: pitch damping lets α give way in the phugoid, so it slows; Lanchester and u, θ know nothing of it.
#[test]
fn pitch_damping_slows_the_phugoid_and_the_formula_with_it_is_told() {
    let change = since_reference(&with(navion(Plane::Longitudinal), "cm_q", -19.92));
    let phugoid = oscillation(&change, ModeName::Phugoid);
    let [from, to] = phugoid.period.expect("it oscillates");
    assert!((from - 29.5).abs() < 0.05 && (to - 34.0).abs() < 0.05, "{from} {to}");
    assert_eq!(first_cause(&phugoid.frequency).0, "m_q");
    let [before, after] = phugoid.frequency.formula.as_ref().expect("a formula has it");
    assert_eq!(before.name, ApproximationName::PhugoidResidualised);
    assert!(before.error.abs() < 0.01 && after.error.abs() < 0.01);
    let Terms::Quotient(_, [damping, stiffness]) = after.terms else { panic!("{after:?}") };
    assert!((stiffness / (damping + stiffness) - 0.511).abs() < 0.001);
    let said = text(&change, ModeName::Phugoid);
    assert!(said.contains("C_{mq} moves M_q −2.08 → −4.15 1/s"), "{said}");
    assert!(said.contains("T 29.5 → 34.0 s") && said.contains("68 → 51 %"), "{said}");
    let short = text(&change, ModeName::ShortPeriod);
    assert!(short.contains("= 4.20 + 8.79 → 8.40 + 8.79 1/s²"), "{short}");
}

/// The centre of gravity 10 % aft: the same formula, by M_w.
#[test]
fn less_pitch_stiffness_slows_the_phugoid_too() {
    let change = since_reference(&with(navion(Plane::Longitudinal), "cg", 0.1));
    let phugoid = oscillation(&change, ModeName::Phugoid);
    let (key, share) = first_cause(&phugoid.frequency);
    assert!(key == "m_w" && share > 0.95, "{key} {share}");
    let said = text(&change, ModeName::Phugoid);
    assert!(said.contains("T 29.5 → 37.5 s") && said.contains("68 → 43 %"), "{said}");
}

/// Half of C_lp: no formula of v and r has it. The roots still add up to the trace.
#[test]
fn less_roll_damping_takes_damping_from_the_dutch_roll() {
    let change = since_reference(&with(navion(Plane::Lateral), "croll_p", -0.205));
    let dutch_roll = oscillation(&change, ModeName::DutchRoll);
    let zeta = &dutch_roll.damping_ratio;
    assert!((zeta.from - 0.204).abs() < 0.001 && (zeta.to - 0.147).abs() < 0.001, "{zeta:?}");
    let (key, share) = first_cause(zeta);
    assert!(key == "l_p" && (share - 1.0).abs() < 1e-6 && zeta.formula.is_none());
    let shared = dutch_roll.shared.expect("no formula has it");
    for k in 0..2 {
        let sum = shared.roll[k] + shared.spiral[k] - dutch_roll.damping[k];
        assert!((sum - shared.trace[k]).abs() < 1e-9 * shared.trace[k].abs(), "{shared:?}");
    }
    assert!(shared.bank[1] > shared.bank[0]);
    let said = text(&change, ModeName::DutchRoll);
    assert!(said.contains("it banks more for its sideslip"), "{said}");
}

/// Elevator 1° down: another trim, 6.13 m/s faster, and both balances add up to nothing.
#[test]
fn an_elevator_step_ends_at_another_speed() {
    let mut scenario = navion(Plane::Longitudinal);
    scenario.disturbance.choices.longitudinal.source = Source::Elevator;
    scenario.disturbance.choices.longitudinal.control_shape = Shape::Step;
    let findings = with(scenario.clone(), "elevator", 1_f64.to_radians());
    let trim = NewTrim::of(&findings).expect("it settles");
    assert!((trim.speed - 6.13).abs() < 0.01 && trim.alpha < 0.0, "{trim:?}");
    for (balance, control) in [(trim.moment, 0.195), (trim.lift, 0.150)] {
        assert!((balance.control.abs() - control).abs() < 0.01, "{balance:?}");
    }
    let said = words::new_trim::sentence(&trim, Convention::SI);
    assert!(said.contains("Δu = +6.1") && said.starts_with("A new elevator is a new trim"), "{said}");
    scenario.disturbance.choices.longitudinal.control_shape = Shape::Pulse;
    assert_eq!(NewTrim::of(&Findings::of(scenario)), None);
}

/// More thrust through the centre of gravity: the same speed, another path.
#[test]
fn a_thrust_without_moment_is_another_path_and_hardly_another_speed() {
    let mut scenario = navion(Plane::Longitudinal);
    scenario.disturbance.choices.longitudinal.source = Source::Throttle;
    scenario.disturbance.choices.longitudinal.control_shape = Shape::Step;
    let trim = NewTrim::of(&Findings::of(scenario)).expect("it settles");
    assert!(trim.speed.abs() < 1e-9 && trim.gamma > 0.01, "{trim:?}");
    let said = words::new_trim::sentence(&trim, Convention::SI);
    assert!(said.starts_with("A new thrust is a new path"), "{said}");
}

#[test]
fn nothing_is_said_where_nothing_has_moved() {
    let before = Findings::of(navion(Plane::Longitudinal));
    assert_eq!(Change::between(&before, &Findings::of(navion(Plane::Longitudinal))), None);
    // A thousandth of C_mα moves ωₙ by less than a thousandth.
    let change = since_reference(&with(navion(Plane::Longitudinal), "cm_alpha", -0.683 * 1.001));
    assert!(change.modes.iter().all(|mode| mode.kind == Kind::Still), "{change:?}");
    // The elevator moves no pole.
    let change = since_reference(&with(navion(Plane::Longitudinal), "m_de", -20.0));
    assert!(change.modes.iter().all(|mode| !mode.kind.is_told()), "{change:?}");
}

/// Where the short period parts into two real roots, both are told of as one motion.
#[test]
fn an_oscillation_that_parts_is_told_of_as_one_motion() {
    let change = since_reference(&with(navion(Plane::Longitudinal), "cg", 0.13));
    let told: Vec<_> = change.modes.iter().filter(|mode| mode.name != ModeName::Phugoid).collect();
    assert_eq!(told.len(), 2);
    for mode in told {
        let Kind::Oscillation(Oscillation { oscillates, damping_ratio, .. }) = &mode.kind else { panic!() };
        assert_eq!(*oscillates, [true, false]);
        assert!(damping_ratio.to > 1.0 && damping_ratio.causes.is_some());
    }
}

/// No sentence says the opposite of a number: the sign of a part in per cent, rises and falls, and the change of a formula.
#[test]
fn no_sentence_contradicts_the_numbers() {
    let mut told = 0;
    every_quarter(|after, change| {
        let at = |name: ModeName| format!("{}, {name:?}, {:?}", after.scenario().aircraft.key, change.edits);
        for mode in &change.modes {
            let Some(reasons) = words::change::reasons(change, mode, Convention::SI) else { continue };
            told += 1;
            assert!(reasons.more.len() <= 2, "{}: {reasons:?}", at(mode.name));
            let all: Vec<&String> = std::iter::once(&reasons.headline).chain(&reasons.more).collect();
            let all: Vec<String> = all.iter().map(|text| text.replace('\u{a0}', " ")).collect();
            for text in &all {
                assert!(text.ends_with('.') && !text.contains("  ") && !text.contains("()"), "{text}");
                assert!(!text.contains("NaN") && !text.contains("inf") && !text.contains("−0 "), "{text}");
            }
            if let Kind::Oscillation(Oscillation { frequency, damping_ratio, .. }) = &mode.kind {
                if frequency.is_notable {
                    let sign = if frequency.change() > 0.0 { "ωₙ +" } else { "ωₙ −" };
                    assert!(all[0].contains(sign), "{}: {}", at(mode.name), reasons.headline);
                }
                if let Some(last) = all.last() {
                    let opposite = |shift: &Shift| if shift.change() > 0.0 { "falls" } else { "rises" };
                    for (symbol, shift) in [("ζ", damping_ratio), ("ωₙ", frequency)] {
                        let wrong = format!("{symbol} {}", opposite(shift));
                        assert!(!last.contains(&wrong), "{}: {last}", at(mode.name));
                    }
                }
            }
        }
        for (name, shift) in shifts(change) {
            let Some([formula, _]) = &shift.formula else { continue };
            // What misses less than the whole change goes the same way.
            assert!(formula.missed <= 0.3, "{}: {formula:?}", at(name));
        }
    });
    assert!(told > 1500, "{told}");
}

/// Terms are those that make up the number the approximation gives, exact number and error beside it.
#[test]
fn the_terms_of_a_formula_make_up_what_it_gives() {
    let mut proved = 0;
    every_quarter(|after, change| {
        for mode in &change.modes {
            let (exact, shift) = match &mode.kind {
                Kind::Oscillation(oscillation) => (oscillation.frequency.to.powi(2), &oscillation.frequency),
                Kind::Root(shift) => (shift.to, shift),
                Kind::Still | Kind::New => continue,
            };
            let Some([_, now]) = &shift.formula else { continue };
            let given = now.terms.value();
            let error = given / exact - 1.0;
            // Along a sloping path, in body axes and with entries of A changed by themselves the formula as written leaves out a little.
            let trim = after.plane().expect("it is analysed").model.trim;
            let is_plain = trim.gamma0 == 0.0 && trim.alpha0 == 0.0;
            let of_derivatives =
                change.edits.iter().all(|edit| !edit.key.starts_with("a_") && edit.key != "g");
            let allowed = if is_plain && of_derivatives { 1e-6 } else { 0.03 };
            assert!(
                (error - now.error).abs() <= allowed,
                "{}, {:?}, {:?}: {error}, {}",
                after.scenario().aircraft.key,
                mode.name,
                change.edits,
                now.error
            );
            proved += 1;
        }
    });
    assert!(proved > 500, "{proved}");
}
