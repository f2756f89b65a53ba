//! The law of feedback on the page: its sliders, what flies under it, the switch that opens the loop.

mod page;

use egui::accesskit::Role;
use egui::{Key, Vec2};
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use eigenwing::content::TextFile;
use eigenwing::findings::Findings;
use eigenwing::flight::aircraft::plane::Plane;
use eigenwing::flight::modes::mode_name::ModeName;
use eigenwing::flight::verdicts::handling_qualities::Level;
use eigenwing::scenario::parameters;
use nalgebra::Complex;
use page::{PHONE, WIDE, app, open, page, value};

/// A yaw damper with an actuator on the 747 of Etkin.
const DAMPED: &str = "v=1&ac=b747-cruise-etkin&plane=lateral&k.r_dr=1&actuator=0.1&page=feedback";
const OPEN: &str = "v=1&ac=b747-cruise-etkin&plane=lateral&page=feedback";

#[test]
fn a_mode_of_the_law_is_flown_alone_by_its_key_and_by_its_place() {
    for mode in ["rudder_actuator", "5"] {
        let mut harness = page(WIDE);
        let link =
            DAMPED.replace("k.r_dr=1", "k.r_dr=0.3").replace("actuator=0.1", "actuator=0.1&washout=10");
        open(&mut harness, &format!("{link}&lat.source=mode&lat.mode={mode}"));
        assert!(shows(&harness, "Stop flying the mode of the rudder’s actuator alone"), "{mode}");
        assert!(app(&harness).link().contains("lat.mode=5"));
        // Without its law there is no such mode, and the last one is flown.
        harness.get_by_label("Open loop").click();
        harness.run();
        assert!(
            shows(&harness, "Stop flying the spiral mode alone")
                || shows(&harness, "Stop flying the spiral alone")
        );
    }
}

/// Damping ratio of the Dutch roll that is on screen.
fn damping(harness: &page::Page) -> f64 {
    let modes = app(harness).findings().flown_modes();
    let mode = modes.iter().find(|mode| mode.naming.name == ModeName::DutchRoll).expect("a Dutch roll");
    mode.damping_ratio().expect("it oscillates")
}

fn shows(harness: &page::Page, text: &str) -> bool {
    harness.query_all_by_label_contains(text).next().is_some()
}

#[test]
fn a_gain_is_a_slider_that_moves_the_poles_as_the_core_has_them() {
    let mut harness = page(WIDE);
    open(&mut harness, OPEN);
    assert_eq!(app(&harness).link().matches("page=feedback").count(), 1);
    let before = damping(&harness);
    let slider = harness
        .query_all_by_role(Role::Slider)
        .find(|node| node.accesskit_node().label().is_some_and(|label| label.contains("yaw rate to rudder")));
    slider.expect("a slider of the yaw damper").focus();
    harness.run();
    harness.key_press(Key::ArrowRight);
    harness.step();
    let gain = value(&harness, "k.r_dr");
    assert!(gain > 0.0);
    assert!(damping(&harness) > before, "in the same frame");
    harness.run();
    let alone = Findings::of(app(&harness).scenario().clone());
    let closed = alone.closed_loop().expect("a law").as_ref().expect("an analysis");
    let core: Vec<_> = closed.modes.iter().map(|mode| (mode.mode.naming.name, mode.mode.lambda)).collect();
    let shown = app(&harness).findings().flown_modes().iter().map(|mode| (mode.naming.name, mode.lambda));
    assert_eq!(shown.collect::<Vec<_>>(), core);
    harness.key_press(Key::Delete);
    harness.run();
    assert_eq!((value(&harness, "k.r_dr"), damping(&harness)), (0.0, before));
}

#[test]
fn modes_of_the_law_have_poles_and_cards_like_any_other() {
    let mut harness = page(WIDE);
    open(&mut harness, DAMPED);
    let map = harness.get_by_label_contains("Pole map, All modes").accesskit_node().label().expect("words");
    assert!(map.contains("Rudder actuator"), "{map}");
    assert!(shows(&harness, "Rudder actuator −9.48"), "it is told where its pole is beyond the map");
    assert!(shows(&harness, "Fly the mode of the rudder’s actuator alone"));
    assert!(shows(&harness, "rudder’s actuator "), "it participates");
    assert!(shows(&harness, "Under the law of feedback."));
    assert!(!shows(&harness, "Under the law of feedback this"));
}

#[test]
fn the_switch_shows_the_aircraft_without_its_law_and_keeps_the_gains() {
    let mut harness = page(WIDE);
    open(&mut harness, OPEN);
    let open_loop = damping(&harness);
    assert!(shows(&harness, "Nothing is fed back"), "and so there is no switch");
    assert_eq!(
        app(&harness).findings().poles_of_other(),
        Vec::<&eigenwing::flight::modes::mode::Mode>::new()
    );
    open(&mut harness, DAMPED);
    let closed_loop = damping(&harness);
    assert!(closed_loop > 2.0 * open_loop, "{closed_loop} {open_loop}");
    let others = app(&harness).findings().poles_of_other().len();
    assert_eq!(others, 3, "the aircraft’s own are marked beside them");
    assert!(shows(&harness, "under the law") && shows(&harness, "without it"), "and told apart in words");
    harness.get_by_label("Open loop").click();
    harness.run();
    assert_eq!((damping(&harness), value(&harness, "k.r_dr")), (open_loop, 1.0));
    assert!(shows(&harness, "The loop is shown open"));
    let link = app(&harness).link();
    assert!(link.contains("feedback=open"), "{link}");
    let mut other = page(WIDE);
    open(&mut other, &link);
    assert_eq!((app(&other).link(), damping(&other)), (link, open_loop));
    harness.get_by_label("Closed loop").click();
    harness.run();
    assert_eq!(damping(&harness), closed_loop);
}

#[test]
fn the_motion_is_that_under_the_law_and_says_what_the_law_does() {
    let mut harness = page(WIDE);
    open(&mut harness, DAMPED);
    let findings = app(&harness).findings();
    let (closed, alone) = (findings.flown_motion().expect("a motion"), findings.motion().expect("a motion"));
    assert_eq!(closed.response.states.len(), alone.response.states.len());
    assert_ne!(closed.response.states, alone.response.states);
    let by_law = closed.by_law.as_ref().expect("the law moves a control");
    assert!(by_law[1].at(5.0) != 0.0 && by_law[0].at(5.0) == 0.0, "the rudder alone");
    // The model itself is in other panes: those say so.
    open(&mut harness, &format!("{DAMPED}&page=matrix&tab=frequency"));
    assert!(shows(&harness, "Of the aircraft without its law of feedback"));
}

#[test]
fn on_a_phone_the_gains_are_there_too() {
    let mut harness = page(PHONE);
    open(&mut harness, DAMPED);
    let sliders = harness.query_all_by_role(Role::Slider).count();
    assert!(sliders >= 5, "{sliders}");
    assert!(shows(&harness, "Open loop") && shows(&harness, "under the law"));
}

#[test]
fn a_lesson_offers_hides_and_locks_gains_as_other_sliders() {
    let mut harness = page(WIDE);
    open(&mut harness, &format!("{DAMPED}&offer=k.r_dr.washout&lock=washout"));
    let names: Vec<String> = harness
        .query_all_by_role(Role::Slider)
        .filter_map(|node| node.accesskit_node().label())
        .filter(|label| label.contains("gain of") || label.contains("washout"))
        .collect();
    assert_eq!(names.len(), 1, "{names:?}");
    assert!(names[0].contains("yaw rate to rudder"));
    open(&mut harness, &format!("{DAMPED}&hide=numbers.names.reasons&lock=view"));
    assert!(!shows(&harness, "Rudder actuator") && !shows(&harness, "Dutch roll"));
    harness.get_by_label("Open loop").click();
    harness.run();
    assert!(!app(&harness).findings().is_opened(), "how it is looked at is locked");
}

#[test]
fn what_is_fed_back_in_one_plane_leaves_the_other_as_it_is() {
    let mut harness = page(WIDE);
    open(&mut harness, &DAMPED.replace("plane=lateral", "plane=longitudinal"));
    let findings = app(&harness).findings();
    assert!(findings.law_flown().is_none());
    assert_eq!(findings.flown_modes(), findings.modes());
    assert!(shows(&harness, "Nothing is fed back"));
    assert_eq!(app(&harness).findings().scenario().law.planes.lateral.to_second[2], 1.0);
}

fn dutch_roll(harness: &page::Page) -> Complex<f64> {
    let modes = app(harness).findings().flown_modes();
    modes.iter().find(|mode| mode.naming.name == ModeName::DutchRoll).expect("a Dutch roll").lambda
}

#[test]
fn a_pole_under_a_law_is_dragged_by_gains_on_any_page_and_undo_is_one_step() {
    for page_of in ["feedback", "coefficients"] {
        let mut harness = page(WIDE);
        open(
            &mut harness,
            &DAMPED
                .replace("b747-cruise-etkin", "navion")
                .replace("k.r_dr=1", "k.r_dr=0.1")
                .replace("page=feedback", &format!("page={page_of}")),
        );
        let (before, scenario) = (dutch_roll(&harness), app(&harness).scenario().clone());
        let from = harness.get_by_label_contains("Dutch roll pole, ").rect().center();
        harness.hover_at(from);
        harness.step();
        harness.drag_at(from);
        harness.step();
        for k in 1..=4 {
            harness.hover_at(from + Vec2::new(-2.0, -2.0) * k as f32);
            harness.step();
        }
        let held = dutch_roll(&harness);
        assert!(held.re < before.re && held.im > before.im, "{page_of}: {before} {held}");
        harness.drop_at(from + Vec2::new(-8.0, -8.0));
        harness.run();
        let now = app(&harness).scenario();
        assert_eq!(now.edited, scenario.edited, "{page_of}: the aircraft stays as it is");
        let (was, is) = (&scenario.law.planes.lateral, &now.law.planes.lateral);
        assert!(was.to_second[2] != is.to_second[2] && was.to_second[0] != is.to_second[0]);
        assert_eq!((was.to_first, now.law.actuator), (is.to_first, scenario.law.actuator));
        harness.get_by_label("Undo").click();
        harness.run();
        assert_eq!(app(&harness).scenario(), &scenario);
    }
}

#[test]
fn escape_gives_back_the_gains_of_a_drag() {
    let mut harness = page(WIDE);
    open(&mut harness, DAMPED);
    let law = app(&harness).scenario().law;
    let from = harness.get_by_label_contains("Dutch roll pole, ").rect().center();
    harness.hover_at(from);
    harness.step();
    harness.drag_at(from);
    harness.step();
    harness.hover_at(from + Vec2::new(-12.0, 0.0));
    harness.step();
    assert_ne!(app(&harness).scenario().law, law);
    harness.key_press(Key::Escape);
    harness.run();
    assert_eq!(app(&harness).scenario().law, law);
}

/// While the loop is shown open, or no gain is chosen, a pole stays and says which of the two it is.
#[test]
fn a_pole_of_the_open_loop_is_moved_by_no_gain_and_says_so() {
    let mut harness = page(WIDE);
    open(&mut harness, &format!("{DAMPED}&feedback=open"));
    let law = app(&harness).scenario().law;
    let from = harness.get_by_label_contains("Dutch roll pole, ").rect().center();
    harness.hover_at(from);
    harness.step();
    harness.drag_at(from);
    harness.step();
    harness.hover_at(from + Vec2::new(-12.0, 0.0));
    harness.step();
    harness.step();
    assert!(shows(&harness, "Dutch roll can’t follow: the loop is shown open, where no gain moves a pole"));
    assert!(!shows(&harness, "no derivative is chosen"));
    assert_eq!(app(&harness).scenario().law, law);
}

/// The hollow squares are told to who doesn't see them, and where reasons are that a closed loop hides.
#[test]
fn poles_of_the_other_state_and_the_place_of_reasons_are_told_in_words() {
    let mut harness = page(WIDE);
    open(&mut harness, &format!("{DAMPED}&cn_beta=0.2"));
    let map = |harness: &page::Page| {
        let map = harness.get_by_label_contains("Pole map, All modes");
        map.accesskit_node().label().expect("words")
    };
    let closed = map(&harness);
    assert!(closed.contains("Hollow squares, without it: One pair, one"), "{closed}");
    let where_told = "Why a mode moved is told of the aircraft without its law";
    assert!(shows(&harness, where_told) && !shows(&harness, "Why it moved"));
    harness.get_by_label("Open loop").click();
    harness.run();
    let opened = map(&harness);
    assert!(opened.contains("Hollow squares, under it: One pair, one"), "{opened}");
    assert!(!shows(&harness, where_told) && shows(&harness, "Why it moved"), "there they are");
    open(&mut harness, DAMPED);
    assert!(!shows(&harness, where_told), "the aircraft itself is as its file has it");
}

/// A control so strong that its gain has no number: the loop can't be analysed, and one sentence says so above the aircraft alone.
#[test]
fn a_law_that_can_t_be_analysed_says_why_and_the_aircraft_without_it_is_shown() {
    let file = r#"
key = "own-strong"
name = "Strong elevator"
condition = "Bare matrices"
source = "A test"
basis = "matrices"
units = "SI"
angles = "rad"

[longitudinal]
status = "unverified"
status_reason = "Made up."
speed = 1.76
alpha0_deg = 0.0
gamma0_deg = 0.0
gravity = 9.80665
A = [[-0.045, 0.036, 0.0, -9.81], [-0.369, -2.02, 1.76, 0.0], [0.191, -3.96, -2.98, 0.0], [0.0, 0.0, 1.0, 0.0]]
B = [[0.0, 0.0], [0.0, 0.0], [-1.5e308, 0.0], [0.0, 0.0]]
"#;
    let mut harness = page(WIDE);
    let kept = serde_json::json!([TextFile::new("own-strong", file)]).to_string();
    harness.state_mut().as_mut().expect("the page").take_up_aircraft(&kept, "");
    open(&mut harness, "v=1&ac=own-strong&page=feedback&k.q_de=1");
    assert!(app(&harness).findings().loop_problem().is_none(), "as large as a number may be");
    open(&mut harness, "v=1&ac=own-strong&page=feedback&k.q_de=2");
    assert!(app(&harness).findings().loop_problem().is_some());
    let sentence = "Under the law of feedback this can’t be analysed: the longitudinal model has an entry that is not a \
                    finite number";
    assert_eq!(harness.query_all_by_label_contains(sentence).count(), 1);
    assert!(shows(&harness, "Shown is the aircraft without it."));
    let alone = app(&harness).findings().plane().expect("the aircraft").modes.len();
    assert_eq!(app(&harness).findings().flown_modes().len(), alone, "its poles and cards are there");
    assert_eq!(value(&harness, "k.q_de"), 2.0, "the gain can be taken back");
}

#[test]
fn the_least_gain_that_reaches_level_1_is_found_or_told_that_none_does() {
    let mut harness = page(WIDE);
    open(&mut harness, OPEN);
    let choose = |harness: &mut page::Page, gain: &str| {
        harness.get_by_label("Least gain for Level 1").click();
        harness.run();
        harness.get_by_role_and_label(Role::Button, gain).click_accesskit();
        harness.run();
    };
    choose(&mut harness, "gain of roll rate to aileron");
    assert!(shows(&harness, "no gain of this slider reaches Level 1; the best is"));
    assert_eq!(value(&harness, "k.p_da"), 0.0);
    // Its Dutch roll is of Level 2, and roll and spiral are good enough.
    const NEAR: &str = "v=1&ac=b747-fc7&plane=lateral&page=feedback&washout=3&actuator=0.1";
    open(&mut harness, NEAR);
    choose(&mut harness, "gain of yaw rate to rudder");
    let gain = value(&harness, "k.r_dr");
    let told = shows(&harness, "Level 1 from");
    let level =
        app(&harness).findings().flown().expect("it flies").levels.iter().filter_map(|of| of.level).max();
    assert!(gain > 0.0 && told, "{gain} {level:?}");
    assert_eq!(level, Some(Level::One));
    let less = format!("{NEAR}&k.r_dr={}", 0.98 * gain);
    open(&mut harness, &less);
    let level =
        app(&harness).findings().flown().expect("it flies").levels.iter().filter_map(|of| of.level).max();
    assert!(level > Some(Level::One), "and it is the least");
}

/// A law can't be flown where there is no steady flight to begin with: the page says that once, and goes on showing what it can.
#[test]
fn a_law_of_a_plane_without_an_analysis_says_one_sentence_and_its_gains_stay() {
    let mut harness = page(WIDE);
    open(&mut harness, "v=1&ac=lesson&plane=lateral&k.r_dr=1&page=feedback");
    assert!(app(&harness).findings().flown().is_some(), "of the plane that it has");
    assert!(shows(&harness, "gain of yaw rate to rudder"), "what is left out is told");
    open(&mut harness, "v=1&ac=navion&k.q_de=0.3&speed=10&page=feedback");
    assert!(app(&harness).findings().flown().is_none() && app(&harness).findings().closed_loop().is_none());
    assert_eq!(harness.query_all_by_label_contains("can't be analysed: ").count(), 1);
    assert_eq!(value(&harness, "k.q_de"), 0.3);
    assert!(app(&harness).link().contains("k.q_de=0.3"));
}

#[test]
fn a_split_under_a_law_has_a_curve_for_each_mode_that_flies() {
    let mut harness = page(WIDE);
    open(&mut harness, &format!("{DAMPED}&split=modes"));
    assert!(!shows(&harness, "No split into modes"));
    for name in ["Dutch roll", "Roll subsidence", "Spiral", "Rudder actuator"] {
        assert!(shows(&harness, name), "{name}");
    }
}

/// From end to end of every gain of some aircraft: whatever the page draws is drawn, and no name comes and goes from one frame to the
/// next.
#[test]
fn every_gain_is_swept_from_end_to_end_and_names_do_not_flicker() {
    let mut frames = 0;
    for (link, plane) in [
        ("v=1&ac=navion&page=feedback&plane=longitudinal&actuator=0.05&washout_q=3", Plane::Longitudinal),
        ("v=1&ac=navion&page=feedback&plane=lateral&actuator=0.1&washout=3", Plane::Lateral),
        ("v=1&ac=b747-cruise-etkin&page=feedback&plane=lateral", Plane::Lateral),
    ] {
        let mut harness = page(WIDE);
        let gains = parameters().filter(|p| p.is_gain() && p.plane == Some(plane));
        for gain in gains {
            let mut before: Vec<Vec<ModeName>> = Vec::new();
            for k in -10..=10 {
                let range = gain.range(app(&harness).scenario());
                let unit = gain.dimension.in_si(app(&harness).scenario().length_unit());
                let value = range.end() * f64::from(k) / 10.0 / unit;
                open(&mut harness, &format!("{link}&{}={value}", gain.key));
                let findings = app(&harness).findings();
                assert!(
                    findings.flown().is_some() && findings.loop_problem().is_none(),
                    "{} {value}",
                    gain.key
                );
                let mut names: Vec<ModeName> =
                    findings.flown_modes().iter().map(|mode| mode.naming.name).collect();
                names.sort();
                before.push(names);
                frames += 1;
            }
            // A set of names that is left for another for one frame only, and comes back.
            let flickers =
                before.windows(3).filter(|three| three[0] == three[2] && three[0] != three[1]).count();
            // At zero the states of the law are gone, and so are their names.
            assert!(flickers <= 1, "{link} {}: {before:?}", gain.key);
        }
    }
    assert_eq!(frames, 3 * 10 * 21);
}
