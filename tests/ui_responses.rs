//! The responses by role and name: what disturbs, how the motion is shown, and what is said of it.

mod page;

use egui::Key;
use egui::accesskit::Role;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use eigenwing::flight::motion::outputs::Output;
use page::{PHONE, TABLET, WIDE, app, choose, open, page, type_into};

fn motion(harness: &page::Page) -> eigenwing::flight::analysis::Motion {
    let analysis = app(harness).findings().analysis().as_ref().expect("an analysis");
    analysis.motion.clone().expect("a motion")
}

#[test]
fn each_disturbance_can_be_chosen_and_sized() {
    let mut harness = page(WIDE);
    for (source, shape, field) in [
        ("Elevator", Some("pulse"), "elevator pulse in deg"),
        ("Elevator", Some("doublet"), "length of a part in s"),
        ("Throttle", Some("3-2-1-1"), "throttle in % of weight"),
        ("Elevator", Some("sine"), "frequency in rad/s"),
        ("Elevator", Some("sweep"), "frequency at the end of the sweep in rad/s"),
        ("Vertical gust", Some("1 − cosine"), "speed of the rising air in m/s"),
        ("Head gust", Some("step"), "speed of the air from ahead in m/s"),
        ("Turbulence", None, "strength of the turbulence in m/s"),
        ("Initial state", None, "pitch rate at release in deg/s"),
        ("One mode", None, "size of the mode in deg"),
        ("Elevator", Some("step"), "factor on the disturbance"),
    ] {
        choose(&mut harness, "Disturbance", source);
        if let Some(shape) = shape {
            choose(&mut harness, "Shape of the disturbance", shape);
        }
        let before = motion(&harness);
        type_into(&mut harness, field, "2.5");
        assert!(motion(&harness) != before, "{source} {shape:?}");
    }
}

#[test]
fn one_mode_alone_is_chosen_by_name() {
    let mut harness = page(WIDE);
    choose(&mut harness, "Disturbance", "One mode");
    let before = motion(&harness);
    choose(&mut harness, "Mode flown alone", "Phugoid");
    assert!(motion(&harness) != before);
}

#[test]
fn the_motion_is_shown_over_time_as_portraits_over_frequency_and_in_numbers() {
    for size in [WIDE, TABLET, PHONE] {
        let mut harness = page(size);
        if size == PHONE {
            harness.get_by_role_and_label(Role::Button, "Response").click();
            harness.run();
        }
        harness.get_by_label_contains("Δu in m/s against time");
        harness.get_by_role_and_label(Role::CheckBox, "Split into modes").click();
        harness.run();
        harness.get_by_label_contains("Δu in m/s against time: between −10.9 and 0");
        let least = if size == PHONE { 1 } else { 4 };
        assert!(harness.query_all_by_label_contains("with Short period, Phugoid").count() >= least, "{size}");
        harness.get_by_role_and_label(Role::Button, "Phase").click();
        harness.run();
        harness.get_by_label_contains("q in deg/s against Δα");
        choose(&mut harness, "Left portrait, upward", "Δh · height gained");
        harness.get_by_label_contains("Δh in m against Δα");
        harness.get_by_role_and_label(Role::Button, "Frequency").click();
        harness.run();
        harness.get_by_label_contains("Short period peak: 2.54 deg/s per deg at 3.14 rad/s");
        choose(&mut harness, "Output of the frequency response", "Δn_z · normal load factor");
        harness.get_by_label_contains("dB of g per deg");
        harness.get_by_role_and_label(Role::Button, "Numbers").click();
        harness.run();
        harness.get_by_label_contains("Height from the phugoid’s first turning point");
    }
}

/// The whole text of the first label that has these words in it.
fn said(harness: &page::Page, words: &str) -> String {
    let node = harness.query_all_by_label_contains(words).next().expect("a label");
    let node = node.accesskit_node();
    node.label().or_else(|| node.value()).unwrap_or_default()
}

#[test]
fn metrics_end_where_the_linear_model_does() {
    let mut harness = page(WIDE);
    open(&mut harness, "v=1&ac=navion&cm_q=9.96&cl_alpha=2&time=60&tab=figures");
    let motion = motion(&harness);
    let end = motion.small_until.expect("it grows");
    assert!(end < 30.0, "{end}");
    let line = said(&harness, "load factor");
    assert!(line.ends_with("still growing where the linear model ends"), "{line}");
    let value =
        line.split(' ').find_map(|word| word.replace('−', "-").parse::<f64>().ok()).expect("a number");
    let small = &motion.values(Output::NormalLoad)[..motion.small_samples()];
    let most = small.iter().fold(0.0, |most: f64, load| most.max(load.abs()));
    assert!((0.97..=1.005).contains(&(value.abs() / most)), "{line}, {most} until {end}");
}

/// Nobody knows how far a motion goes on to grow that is cut off while it grows.
#[test]
fn a_peak_at_the_end_of_the_linear_model_is_no_peak() {
    let mut harness = page(WIDE);
    open(&mut harness, "v=1&ac=navion&cm_alpha=-0.25&tab=figures");
    harness.get_by_label("beyond 26.8");
    // θ has turned before, and has its peak.
    harness.get_by_label("−19.8");
}

#[test]
fn in_turbulence_metrics_are_averages() {
    let mut harness = page(WIDE);
    open(&mut harness, "v=1&ac=navion&tab=figures");
    assert_eq!(harness.query_all_by_label_contains("first turning point").count(), 1);
    assert_eq!(harness.query_all_by_label("r.m.s.").count(), 0);
    open(&mut harness, "v=1&ac=navion&lon.source=turbulence&tab=figures");
    assert_eq!(harness.query_all_by_label_contains("first turning point").count(), 0);
    assert_eq!(harness.query_all_by_label("r.m.s.").count(), 1);
    assert_eq!(harness.query_all_by_label("Rise").count(), 0);
}

#[test]
fn a_legend_names_every_line_that_is_drawn_and_no_other() {
    for size in [WIDE, PHONE] {
        let mut harness = page(size);
        if size == PHONE {
            harness.get_by_role_and_label(Role::Button, "Response").click();
            harness.run();
        }
        let legend = |harness: &page::Page| said(harness, "Legend: ");
        assert_eq!(legend(&harness), "Legend: linear, full line");
        harness.get_by_role_and_label(Role::CheckBox, "Split into modes").click();
        harness.get_by_role_and_label(Role::CheckBox, "Nonlinear").click();
        harness.get_by_label_contains("Pin this state").click();
        harness.run();
        let all = "Legend: linear, full line; nonlinear, dotted; pinned, dashed; Short period, filled; \
                   Phugoid, filled; no mode: input and drift, filled";
        assert_eq!(legend(&harness), all);
        harness.get_by_role_and_label(Role::Button, "Frequency").click();
        harness.run();
        let frequency = "Legend: linear, full line; pinned, dashed; ωₙ of the short period, upright line; \
                         ωₙ of the phugoid, upright line; zero, ring";
        assert_eq!(legend(&harness), frequency);
        let node = harness.get_by_label(frequency).rect();
        assert!(node.left() >= 0.0 && node.right() <= size.x, "{size}: {node}");
        harness.get_by_role_and_label(Role::Button, "Phase").click();
        harness.run();
        assert!(legend(&harness).ends_with("; steady flight, dot; at the end, dot"), "{}", legend(&harness));
    }
}

#[test]
fn over_frequency_a_growing_mode_has_no_peak_but_a_warning() {
    let mut harness = page(WIDE);
    open(&mut harness, "v=1&ac=navion&cm_q=9.96&cl_alpha=2&tab=frequency");
    harness.get_by_label_contains("The short period grows: no steady oscillation ever answers a sine");
    assert_eq!(harness.query_all_by_label_contains(" peak: ").count(), 0);
    open(&mut harness, "v=1&ac=navion&tab=frequency");
    assert_eq!(harness.query_all_by_label_contains("grows: ").count(), 0);
    assert!(harness.query_all_by_label_contains(" peak: ").count() > 0);
}

#[test]
fn which_outputs_are_shown_can_be_chosen() {
    let mut harness = page(WIDE);
    assert_eq!(harness.query_all_by_label_contains("Δn_z in g").count(), 0);
    harness.get_by_role_and_label(Role::Button, "Quantities shown").click();
    harness.run();
    harness.get_by_label("Δn_z · normal load factor").click();
    harness.run();
    harness.get_by_label_contains("Δn_z in g against time");
}

#[test]
fn nonlinear_flight_is_drawn_beside_the_linear_motion_and_says_where_it_ends() {
    let mut harness = page(WIDE);
    let computations = app(&harness).computations();
    harness.get_by_role_and_label(Role::CheckBox, "Nonlinear").click();
    harness.run();
    assert!(harness.query_all_by_label_contains("with nonlinear").count() >= 5);
    type_into(&mut harness, "factor on the disturbance", "15");
    harness.get_by_label_contains("Nonlinear flight ends: at ");
    assert_eq!(app(&harness).computations(), computations + 1, "only the new size");
    choose(&mut harness, "Aircraft", "Lesson 4, as printed");
    harness.get_by_label_contains("No nonlinear flight: this aircraft is given by its matrices");
}

/// What the pointer was on is forgotten with the plots, or nothing else could move the playback any more.
#[test]
fn the_playback_is_free_once_the_plots_are_gone() {
    let mut harness = page(WIDE);
    let plot = harness.get_by_label_contains("Δu in m/s against time").rect();
    harness.hover_at(plot.center());
    harness.run();
    let time = |harness: &page::Page| {
        let slider = harness.get_by_role_and_label(Role::Slider, "Time of the playback in s");
        slider.accesskit_node().numeric_value().expect("a time")
    };
    assert!(time(&harness) > 20.0);
    harness.key_press(Key::A);
    harness.run();
    harness.get_by_label("Back to the start").click_accesskit();
    harness.run();
    assert_eq!(time(&harness), 0.0);
}

/// The clock goes on where the plots are alone beside the sliders.
#[test]
fn the_motion_is_played_beside_the_sliders_too() {
    let mut harness = page(WIDE);
    open(&mut harness, "v=1&ac=navion&pane=response");
    let cursor = |harness: &page::Page| harness.query_all_by_label_contains("against time").count();
    assert!(cursor(&harness) > 3);
    harness.key_press(Key::Space);
    harness.run_steps(20);
    harness.key_press(Key::Space);
    harness.run();
    harness.key_press(Key::Escape);
    harness.run();
    let slider = harness.get_by_role_and_label(Role::Slider, "Time of the playback in s");
    let time = slider.accesskit_node().numeric_value().expect("a time");
    assert!(time > 1.0, "{time}");
}

/// Where a motion grows out of what is small, its picture goes on, but not its words.
#[test]
fn words_of_a_motion_end_where_the_linear_model_does() {
    let mut harness = page(WIDE);
    open(&mut harness, "v=1&ac=navion&cm_q=9.96&cl_alpha=2&time=60");
    let end = motion(&harness).small_until.expect("it grows");
    let values = motion(&harness).values(Output::PitchAngle);
    let until = (end / motion(&harness).response.dt).round() as usize;
    let largest = values[..=until].iter().fold(0.0_f64, |most, value| most.max(value.abs())).to_degrees();
    let words = said(&harness, "Δθ in deg against time");
    let numbers: Vec<f64> = words
        .split([' ', ','])
        .filter_map(|word| word.replace('−', "-").parse::<f64>().ok())
        .map(f64::abs)
        .collect();
    assert!(numbers.len() >= 3 && numbers.iter().all(|x| *x <= 1.02 * largest), "{words}, at most {largest}");
}

#[test]
fn an_overshoot_is_told_once_there_can_be_no_more_of_it() {
    let mut harness = page(WIDE);
    // The speed has settled after minutes only.
    open(&mut harness, "v=1&ac=navion&cd=0.3&time=5&tab=figures");
    assert_eq!(harness.query_all_by_label("0 %").count(), 0);
}

/// A mode flown alone is played as fast as it can be watched, and afterwards as before.
#[test]
fn a_mode_is_played_as_fast_as_it_can_be_watched() {
    let mut harness = page(WIDE);
    let rate = |harness: &page::Page| {
        let chooser = harness.get_by_role_and_label(Role::ComboBox, "Speed of the playback");
        chooser.accesskit_node().value().unwrap_or_default()
    };
    assert_eq!(rate(&harness), "1×");
    // A turn of the Navion's phugoid takes 29.5 s: eight times as fast it takes 3.7.
    harness.get_by_label("Fly the phugoid alone").click();
    harness.run_steps(4);
    assert_eq!(rate(&harness), "8×");
    harness.get_by_label("Stop flying the phugoid alone").click();
    harness.run();
    assert_eq!(rate(&harness), "1×");
    // Its short period turns in 2.4 s.
    harness.get_by_label("Fly the short period alone").click();
    harness.run_steps(4);
    assert_eq!(rate(&harness), "½×");
}

/// The criterion is told with its number, and the nonlinear flight is offered where there is one.
#[test]
fn where_a_disturbance_is_no_longer_small_the_limit_is_told_and_the_nonlinear_flight_offered() {
    let mut harness = page(WIDE);
    open(&mut harness, "v=1&ac=navion&cg=25");
    let line = said(&harness, "no longer small");
    let end = motion(&harness).small_until.expect("it grows");
    assert!(line.starts_with(&format!("After {end:.2} s")), "{line}");
    assert!(line.contains("Δθ is more than 57.3\u{a0}deg"), "{line}");
    assert!(line.ends_with("the linear curve goes on, faded."), "{line}");
    harness.get_by_label("Draw the nonlinear flight").click();
    harness.run();
    assert_eq!(harness.query_all_by_label("Draw the nonlinear flight").count(), 0);
    assert!(app(&harness).link().contains("flight=nonlinear"));
    open(&mut harness, "v=1&ac=navion&cg=10");
    let line = said(&harness, "no longer small");
    assert!(line.contains("Δu is more than 26.8\u{a0}m/s, 50 % of the flight speed"), "{line}");
    // Of bare matrices there is none.
    open(&mut harness, "v=1&ac=lesson-printed&elevator=-3");
    assert!(said(&harness, "no longer small").contains("Δ"));
    assert_eq!(harness.query_all_by_label("Draw the nonlinear flight").count(), 0);
}

/// The page opens with a climb. Stick forward at sea level the height falls below the ground, and the plot says so.
#[test]
fn a_height_below_sea_level_is_told() {
    let mut harness = page(WIDE);
    let told = |harness: &page::Page| harness.query_all_by_label_contains("falls below sea level").count();
    let heights = motion(&harness).values(Output::Height);
    assert!(heights.iter().fold(0.0, |most: f64, h| most.max(*h)) > 50.0);
    assert_eq!(told(&harness), 0);
    open(&mut harness, "v=1&ac=navion&elevator=1");
    assert_eq!(told(&harness), 1);
    assert!(said(&harness, "Legend: ").contains("sea level, dashed"));
    // At 40,000 ft there is air enough below.
    open(&mut harness, "v=1&ac=b747-fc9&elevator=1");
    assert_eq!(told(&harness), 0);
}
