//! The loops of a law in the pane of the responses, by role and name: their tabs, margins and Nyquist's count, and the map of gain and
//! washout that is worked by pointer and by keyboard.

mod page;

use egui::accesskit::Role;
use egui::{Key, Pos2, Rect, Vec2};
use egui_kittest::kittest::Queryable as _;
use page::{PHONE, Page, WIDE, app, open, page, value};

const DAMPER: &str = "v=1&ac=b747-cruise-etkin&plane=lateral&k.r_dr=1&washout=3&actuator=0.1";

fn opened(size: Vec2, more: &str) -> Page {
    let mut harness = page(size);
    open(&mut harness, &format!("{DAMPER}{more}"));
    if size == PHONE {
        harness.get_by_role_and_label(Role::Button, "Response").click();
        harness.run();
    }
    harness
}

fn tab(harness: &mut Page, name: &str) {
    harness.get_by_role_and_label(Role::Button, name).click();
    harness.run();
}

fn has_tab(harness: &Page, name: &str) -> bool {
    harness.query_by_role_and_label(Role::Button, name).is_some()
}

#[test]
fn tabs_of_loops_come_with_a_law_and_go_with_it() {
    for size in [WIDE, PHONE] {
        let mut harness = opened(size, "");
        for name in ["Loop", "Nyquist", "Gain map"] {
            assert!(has_tab(&harness, name), "{size}: {name}");
        }
        open(&mut harness, "v=1&ac=b747-cruise-etkin&plane=lateral&tab=nyquist");
        for name in ["Loop", "Nyquist", "Gain map"] {
            assert!(!has_tab(&harness, name), "{size}: {name}");
        }
        // What stands in for them is over frequency too.
        harness.get_by_label_contains("β/δ_r in dB of deg per deg against ω");
        // A law without the rate has loops and no map.
        open(&mut harness, "v=1&ac=navion&k.theta_de=0.3&tab=gain-map");
        assert!(has_tab(&harness, "Loop") && !has_tab(&harness, "Gain map"), "{size}");
    }
}

#[test]
fn a_loop_tells_its_margins_and_nyquist_counts_its_turns() {
    let mut harness = opened(WIDE, "&tab=loop");
    harness.get_by_label_contains("Gain margin: ×6.36 (16.1 dB) at 0.464 rad/s");
    harness.get_by_label_contains("Phase margin: 66.0° of lead at 0.781 rad/s");
    harness.get_by_label_contains("Sensitivity peak: 1.30 at 0.615 rad/s");
    harness.get_by_label_contains("L in dB against ω");
    harness.get_by_label_contains("L = 4.859 s ");
    harness.get_by_label_contains("Zeros lie in the right half-plane");
    tab(&mut harness, "Nyquist");
    harness.get_by_label("0 turns about −1, 0 unstable poles of the loop cut: stable");
    harness.get_by_label_contains("Im L near −1 against Re L");
    // Beyond its margin it is told what it takes to come back.
    open(&mut harness, &DAMPER.replace("k.r_dr=1", "k.r_dr=-1"));
    tab(&mut harness, "Nyquist");
    harness.get_by_label("2 turns clockwise about −1, 0 unstable poles of the loop cut: unstable, 2 closed");
    tab(&mut harness, "Loop");
    harness.get_by_label_contains("or ÷5.71 (−15.1 dB) at 0.962 rad/s");
}

#[test]
fn the_loop_that_is_cut_can_be_chosen_where_there_are_two() {
    let mut harness = opened(WIDE, "&k.phi_da=-0.5&tab=loop");
    harness.get_by_label_contains("L = 4.8");
    harness.get_by_role_and_label(Role::Button, "aileron").click();
    harness.run();
    assert!(harness.query_by_label_contains("L = 4.8").is_none());
    harness.get_by_label_contains("L = ");
}

#[test]
fn under_a_law_the_frequency_response_is_that_of_the_whole_with_the_aircraft_alone_beside_it() {
    let harness = opened(WIDE, "&lat.source=rudder&tab=frequency");
    harness.get_by_label_contains("Legend: with the law, full line; without, full line");
    harness.get_by_label_contains("Dutch roll peak: 1.46 deg per deg at 0.773 rad/s");
    harness.get_by_label_contains("A zero lies in the right half-plane");
}

#[test]
fn with_the_loop_shown_open_the_frequency_response_is_that_of_the_aircraft_alone() {
    let harness = opened(WIDE, "&lat.source=rudder&tab=frequency&feedback=open");
    harness.get_by_label_contains("Legend: linear, full line; ωₙ of the Dutch roll");
    // Its loops are still there to be looked at.
    assert!(has_tab(&harness, "Loop"));
}

#[test]
fn where_input_and_output_are_alike_crossovers_are_marked() {
    let mut harness = page(WIDE);
    open(&mut harness, "v=1&ac=navion&tab=frequency&lon.frequency_of=theta");
    harness.get_by_label_contains("gain 1 at 2.45 rad/s, dot; phase ±180° at 0.210 rad/s, dot");
    open(&mut harness, "v=1&ac=navion&tab=frequency&lon.frequency_of=q");
    assert!(harness.query_by_label_contains("gain 1 at").is_none());
}

#[test]
fn limits_of_the_levels_come_to_the_map_once_it_is_judged() {
    let mut harness = page(WIDE);
    open(
        &mut harness,
        "v=1&ac=b747-fc7&plane=lateral&page=feedback&k.r_dr=0.5&washout=3&actuator=0.1&tab=gain-map",
    );
    // One washout a frame.
    (0..30).for_each(|_| harness.step());
    harness.get_by_label_contains("limit of Level 1, dashed; limit of Level 2, dotted");
}

#[test]
fn a_transfer_function_stands_in_factors_below_its_plots() {
    let mut harness = page(WIDE);
    tab(&mut harness, "Frequency");
    let fraction = harness.get_by_label_contains("q/δ_e = −11.06 s (s + 0.0523) (s + 1.91) / [");
    let plot = harness.get_by_label_contains("q/δ_e in deg against ω");
    assert!(fraction.rect().top() >= plot.rect().bottom());
    let above = harness.get_by_label_contains("q/δ_e in dB of deg/s per deg against ω").rect();
    assert!(above.bottom() < plot.rect().top() && above.x_range() == plot.rect().x_range());
}

fn point(harness: &Page) -> Rect {
    harness.get_by_label_contains("The law on the map: gain").rect()
}

fn drag(harness: &mut Page, from: Pos2, by: Vec2) {
    harness.hover_at(from);
    harness.step();
    harness.drag_at(from);
    harness.step();
    for k in 1..=4 {
        harness.hover_at(from + by * (k as f32 / 4.0));
        harness.step();
    }
    harness.drop_at(from + by);
    harness.run();
}

#[test]
fn dragging_the_point_of_the_map_edits_gain_and_washout_and_undo_is_one_step() {
    let mut harness = opened(WIDE, "&tab=gain-map&pane=response");
    harness.get_by_label_contains(
        "Least damped oscillation: ζ = 0.240 at k = 1.00; best with a washout of 3.00 s",
    );
    let before = app(&harness).scenario().clone();
    let from = point(&harness).center();
    drag(&mut harness, from, Vec2::new(100.0, -80.0));
    let (gain, washout) = (value(&harness, "k.r_dr"), value(&harness, "washout"));
    assert!(gain > 1.1 && gain < 2.0 && washout > 3.5 && washout < 20.0, "{gain} {washout}");
    assert_eq!(value(&harness, "actuator"), 0.1);
    harness.get_by_label("Undo").click();
    harness.run();
    assert_eq!(app(&harness).scenario(), &before);
    // To the top of the map there is no washout any more.
    drag(&mut harness, from, Vec2::new(0.0, -1000.0));
    assert_eq!(value(&harness, "washout"), 0.0);
    harness.get_by_label_contains("best without washout");
    // However far it goes to the left, some gain is left.
    let at = point(&harness).center();
    drag(&mut harness, at, Vec2::new(-2000.0, 0.0));
    let least = value(&harness, "k.r_dr");
    assert!(least > 0.0 && least < 0.02, "{least}");
}

#[test]
fn arrow_keys_move_the_point_of_the_map() {
    let mut harness = opened(WIDE, "&tab=gain-map");
    harness.get_by_label_contains("The law on the map: gain").focus();
    harness.run();
    harness.key_press(Key::ArrowRight);
    harness.run();
    let gain = value(&harness, "k.r_dr");
    assert!(gain > 1.0 && gain < 1.05, "{gain}");
    assert_eq!(value(&harness, "washout"), 3.0);
    harness.key_press(Key::ArrowDown);
    harness.run();
    let washout = value(&harness, "washout");
    assert!(washout < 3.0 && washout > 2.0, "{washout}");
    assert!(harness.get_by_label_contains("The law on the map: gain").is_focused());
}

#[test]
fn a_gain_that_is_locked_stays_where_it_is_on_the_map() {
    let mut harness = opened(WIDE, "&tab=gain-map&pane=response&lock=k.r_dr");
    let from = point(&harness).center();
    drag(&mut harness, from, Vec2::new(100.0, -80.0));
    assert_eq!((value(&harness, "k.r_dr"), value(&harness, "washout")), (1.0, 3.0));
}

#[test]
fn what_a_stage_hides_is_told_by_no_loop() {
    for hidden in ["numbers", "verdicts"] {
        let mut harness = opened(WIDE, &format!("&tab=loop&hide={hidden}"));
        for name in ["Loop", "Nyquist", "Gain map"] {
            tab(&mut harness, name);
            for told in ["margin", "turns about", "Least damped", "L = "] {
                assert!(harness.query_by_label_contains(told).is_none(), "{hidden} {name}: {told}");
            }
        }
    }
}
