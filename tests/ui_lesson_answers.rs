//! Answers to the questions of lessons, by mouse, by finger and by keyboard alone; and what stands beside them afterwards.

mod page;

use egui::accesskit::Role;
use egui::{Event, Key, Modifiers, PointerButton, Pos2, Rect, TouchDeviceId, TouchId, TouchPhase, Vec2};
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use eigenwing::content::TextFile;
use page::{PHONE, Page, WIDE, page, type_into, value};

/// A lesson of one step with these blocks.
fn lesson(size: Vec2, blocks: &str) -> Page {
    let mut harness = page(size);
    let text =
        format!("+++\ntitle = \"Own\"\n+++\n## A step\n```scene\nlink = \"#v=1&ac=navion\"\n```\n{blocks}\n");
    let app = harness.state_mut().as_mut().expect("the page has been drawn");
    app.open_files(&[TextFile { name: "own.md".to_owned(), text }]);
    harness.run();
    harness
}

fn click(harness: &mut Page, label: &str) {
    harness.get_by_role_and_label(Role::Button, label).click_accesskit();
    harness.run();
}

fn count(harness: &Page, label: &str) -> usize {
    harness.query_all_by_label_contains(label).count()
}

fn rect(harness: &Page, label: &str) -> Rect {
    harness.get_by_label_contains(label).rect()
}

/// A mouse or a finger that is put down, drawn along a path and lifted.
fn draw(harness: &mut Page, finger: bool, path: &[Pos2]) {
    let touch = |harness: &mut Page, phase, pos| {
        if finger {
            let (device_id, id) = (TouchDeviceId(0), TouchId(0));
            harness.input_mut().events.push(Event::Touch { device_id, id, phase, pos, force: None });
        }
    };
    let button = |harness: &mut Page, pos, pressed| {
        let (button, modifiers) = (PointerButton::Primary, Modifiers::NONE);
        harness.input_mut().events.push(Event::PointerButton { pos, button, pressed, modifiers });
    };
    let (Some(first), Some(last)) = (path.first().copied(), path.last().copied()) else { return };
    harness.input_mut().events.push(Event::PointerMoved(first));
    button(harness, first, true);
    touch(harness, TouchPhase::Start, first);
    harness.step();
    for at in &path[1..] {
        harness.input_mut().events.push(Event::PointerMoved(*at));
        touch(harness, TouchPhase::Move, *at);
        harness.step();
    }
    button(harness, last, false);
    if finger {
        harness.input_mut().events.push(Event::PointerGone);
    }
    touch(harness, TouchPhase::End, last);
    harness.run();
}

fn press(harness: &mut Page, key: Key, times: usize) {
    for _ in 0..times {
        harness.key_press(key);
        harness.run();
    }
}

const PLACE: &str = "```predict\nkind = \"place\"\nask = \"Where?\"\nmode = \"short-period\"\n\
    after = \"#v=1&ac=navion&cm_alpha=-1.4\"\nwrong_side = \"It stays stable.\"\nfar = \"It moves up.\"\n```\n```reveal\nSeen.\n```";

const YOUR_POLE: &str = "Your short period pole: ";

#[test]
fn a_pole_is_placed_by_mouse_and_by_finger_and_both_marks_stay_with_the_reason() {
    for (size, finger) in [(WIDE, false), (PHONE, true)] {
        let mut harness = lesson(size, PLACE);
        assert_eq!(count(&harness, "Your short period pole: none yet"), 1);
        let pad = rect(&harness, YOUR_POLE);
        draw(&mut harness, finger, &[pad.right_top() + Vec2::new(-20.0, 40.0)]);
        assert_eq!(count(&harness, "none yet"), 0, "{size}");
        click(&mut harness, "Answer");
        assert_eq!(count(&harness, "The other side."), 1, "{size}");
        assert_eq!(count(&harness, "It stays stable."), 1);
        assert_eq!(count(&harness, "It moves up."), 0);
        assert_eq!(count(&harness, "Your mark, the ring with a dot"), 1);
        assert_eq!(count(&harness, "The short period, a cross: −2.5"), 1);
        assert_eq!(count(&harness, "Seen."), 1);
    }
}

#[test]
fn a_finger_that_goes_up_over_the_map_of_a_question_scrolls_and_places_nothing() {
    let mut harness = lesson(PHONE, PLACE);
    let pad = rect(&harness, YOUR_POLE);
    let path: Vec<Pos2> = (0..9).map(|k| pad.center() - Vec2::new(0.0, 10.0 * k as f32)).collect();
    draw(&mut harness, true, &path);
    assert!(rect(&harness, YOUR_POLE).top() < pad.top());
    assert_eq!(count(&harness, "Your short period pole: none yet"), 1);
}

#[test]
fn a_pole_is_placed_by_keyboard_alone() {
    let mut harness = lesson(WIDE, PLACE);
    harness.get_by_label_contains(YOUR_POLE).focus();
    harness.run();
    press(&mut harness, Key::ArrowUp, 3);
    press(&mut harness, Key::ArrowRight, 1);
    assert_eq!(count(&harness, "none yet"), 0);
    // Or as two numbers, with a comma and any minus.
    type_into(&mut harness, "Real part of your pole", "−2,5");
    type_into(&mut harness, "Imaginary part of your pole", "4");
    assert_eq!(count(&harness, "Your short period pole: −2.500 ± 4.000j 1/s"), 1);
    harness.get_by_role_and_label(Role::Button, "Answer").focus();
    harness.run();
    press(&mut harness, Key::Enter, 1);
    assert_eq!(count(&harness, "That is the place."), 1);
}

const SKETCH: &str = "```predict\nkind = \"sketch\"\nask = \"Draw it.\"\noutput = \"theta\"\n\
    first = \"Down first.\"\noscillates = \"The phugoid swings.\"\nends = \"It ends lower.\"\n```\n```reveal\nSeen.\n```";

const YOUR_SKETCH: &str = "Your sketch of pitch angle";

fn can_answer(harness: &Page) -> bool {
    !harness.get_by_role_and_label(Role::Button, "Answer").accesskit_node().is_disabled()
}

#[test]
fn a_curve_is_drawn_by_mouse_and_by_finger_and_each_wrong_feature_has_its_reason() {
    for (size, finger) in [(WIDE, false), (PHONE, true)] {
        let mut harness = lesson(size, SKETCH);
        let pad = rect(&harness, YOUR_SKETCH);
        let at =
            |x: f32, y: f32| Pos2::new(pad.left() + x * pad.width(), pad.center().y - y * 0.5 * pad.height());
        // A finger that begins upward draws, and doesn't scroll.
        let rise: Vec<Pos2> = (0..=10).map(|k| at(0.001 * k as f32, 0.05 * k as f32)).collect();
        draw(&mut harness, finger, &rise);
        assert_eq!(rect(&harness, YOUR_SKETCH), pad, "{size}");
        assert!(!can_answer(&harness), "it isn't drawn to its end");
        let on: Vec<Pos2> = (0..=20).map(|k| at(0.01 + 0.0495 * k as f32, 0.5)).collect();
        draw(&mut harness, finger, &on);
        assert!(can_answer(&harness), "{size}");
        click(&mut harness, "Answer");
        for said in
            ["Down first.", "The phugoid swings.", "It ends lower.", "✗ It starts another way.", "Seen."]
        {
            assert_eq!(count(&harness, said), 1, "{said}");
        }
        assert_eq!(count(&harness, "Your sketch of pitch angle beside the model’s"), 1);
        assert_eq!(count(&harness, "your sketch"), 1, "{size}");
    }
}

#[test]
fn a_curve_is_drawn_by_keyboard_alone_and_cleared() {
    let mut harness = lesson(WIDE, SKETCH);
    harness.get_by_label_contains(YOUR_SKETCH).focus();
    harness.run();
    // Down, then from point to point around what it swings about.
    press(&mut harness, Key::ArrowRight, 1);
    press(&mut harness, Key::ArrowDown, 2);
    for point in 2..16 {
        press(&mut harness, Key::ArrowRight, 1);
        let swings = if point % 4 < 2 { Key::ArrowUp } else { Key::ArrowDown };
        press(&mut harness, swings, 3);
    }
    assert!(can_answer(&harness));
    click(&mut harness, "Clear the sketch");
    assert!(!can_answer(&harness));
    // As numbers too.
    harness.get_by_label("In numbers").click_accesskit();
    harness.run();
    type_into(&mut harness, "pitch angle at 4 s [deg]", "−3,5");
    type_into(&mut harness, "pitch angle at 60 s [deg]", "-3");
    assert!(can_answer(&harness));
    click(&mut harness, "Answer");
    assert_eq!(count(&harness, "✓ It starts the right way."), 1);
    assert_eq!(count(&harness, "Down first."), 0);
}

#[test]
fn things_are_put_in_order_by_arrow_keys_and_their_numbers_are_told_afterwards() {
    let order = "```predict\nkind = \"order\"\nask = \"By period\"\nmeasure = \"phugoid.period\"\nbecause = \"It grows with speed.\"\n\
        [[item]]\nsays = \"Slow\"\nlink = \"#v=1&ac=navion&speed=45\"\n[[item]]\nsays = \"Fast\"\nlink = \"#v=1&ac=navion&speed=70\"\n```";
    let mut harness = lesson(WIDE, order);
    // By their words at first, so that the order of the file gives nothing away.
    harness.get_by_label("1. Fast");
    harness.get_by_label("Move “Fast” down").focus();
    harness.run();
    press(&mut harness, Key::ArrowDown, 1);
    harness.get_by_label("2. Fast");
    assert!(harness.get_by_label("Move “Fast” down").is_focused(), "the focus goes with it");
    press(&mut harness, Key::ArrowUp, 1);
    harness.get_by_label("1. Fast");
    click(&mut harness, "Answer");
    assert_eq!(count(&harness, "✗ 1. Fast"), 1);
    assert_eq!(count(&harness, "By period of the phugoid: Slow (24.8"), 1);
    assert_eq!(count(&harness, "It grows with speed."), 1);
}

#[test]
fn an_estimate_takes_any_comma_and_minus_and_tells_by_what_factor_it_is_off() {
    let estimate = |measure: &str| {
        format!(
            "```predict\nkind = \"estimate\"\nask = \"How much?\"\nmeasure = \"{measure}\"\nwrong_way = \"w\"\nfar = \"f\"\n```"
        )
    };
    let mut harness = lesson(WIDE, &estimate("phugoid.period"));
    type_into(&mut harness, "Your estimate: period of the phugoid", "59,0");
    assert_eq!(count(&harness, "You said 59"), 1);
    assert_eq!(count(&harness, "too high by a factor of 2.0"), 1);
    let mut harness = lesson(WIDE, &estimate("short_period.real_part"));
    type_into(&mut harness, "Your estimate: real part of the short period", "−2,5");
    assert_eq!(count(&harness, "Within 10 %."), 1);
}

#[test]
fn what_is_written_is_kept_and_nothing_waits_for_it() {
    let blocks = format!("```write\nask = \"Explain it.\"\n```\n{SKETCH}");
    let mut harness = lesson(PHONE, &blocks);
    let field = harness.get_by_role_and_label(Role::MultilineTextInput, "Your words: Explain it.");
    field.focus();
    harness.run();
    harness.get_by_role(Role::MultilineTextInput).type_text("The tail.");
    harness.run();
    click(&mut harness, "I don’t know");
    assert_eq!(count(&harness, "Seen."), 1);
    let field = harness.get_by_role(Role::MultilineTextInput);
    assert_eq!(field.accesskit_node().value().as_deref(), Some("The tail."));
}

const WORDS: &str = "The [short period](glossary:sp) is damped, [as printed](source:book): $\\dot{q} = M_q q$.\n\n\
    ```math\n\\zeta = \\frac{a}{2\\omega_0}\n```\n";

/// A lesson with a glossary and references of its own.
fn words(size: Vec2) -> Page {
    let mut harness = page(size);
    let own = |name: &str, text: String| TextFile { name: name.to_owned(), text };
    let lesson =
        format!("+++\ntitle = \"Own\"\n+++\n## A step\n```scene\nlink = \"#v=1&ac=navion\"\n```\n{WORDS}\n");
    let glossary = "[sp]\nword = \"short period\"\nsays = \"The quick swing of the nose.\"\n";
    let references =
        "[book]\nauthor = \"R. Nelson\"\ntitle = \"Flight Stability\"\npublished = \"McGraw-Hill 1998\"\n";
    let app = harness.state_mut().as_mut().expect("the page has been drawn");
    app.open_files(&[
        own("own.md", lesson),
        own("glossary.toml", glossary.to_owned()),
        own("references.toml", references.to_owned()),
    ]);
    harness.run();
    harness
}

#[test]
fn a_word_of_the_glossary_opens_its_sentence_by_keyboard_and_a_source_its_reference_by_finger() {
    let mut harness = words(WIDE);
    harness.get_by_role_and_label(Role::Link, "short period").focus();
    harness.run();
    assert_eq!(count(&harness, "The quick swing of the nose."), 0);
    press(&mut harness, Key::Enter, 1);
    assert_eq!(count(&harness, "The quick swing of the nose."), 1);
    press(&mut harness, Key::Escape, 1);
    assert_eq!(count(&harness, "The quick swing of the nose."), 0);

    let mut harness = words(PHONE);
    let source = harness.get_by_role_and_label(Role::Link, "as printed").rect().center();
    draw(&mut harness, true, &[source]);
    assert!(count(&harness, "R. Nelson") > 0);
    assert_eq!(count(&harness, "Flight Stability. McGraw-Hill 1998"), 1);
    draw(&mut harness, true, &[Pos2::new(200.0, 820.0)]);
    assert_eq!(count(&harness, "Flight Stability. McGraw-Hill 1998"), 0, "a tap elsewhere closes it");
}

#[test]
fn formulas_are_told_in_words_and_text_can_be_selected_and_copied() {
    let mut harness = words(WIDE);
    harness.get_by_label(": q dot equals M sub q times q.");
    harness.get_by_label("zeta equals the fraction a over 2 times omega sub 0, end of fraction,");
    let text = rect(&harness, " is damped, ");
    let (from, to) = (text.left_center() + Vec2::new(1.0, 0.0), text.right_center() - Vec2::new(1.0, 0.0));
    draw(&mut harness, false, &[from, from.lerp(to, 0.5), to]);
    harness.input_mut().events.push(Event::Copy);
    harness.step();
    let commands = &harness.output().platform_output.commands;
    let copied = commands.iter().find_map(|command| match command {
        egui::OutputCommand::CopyText(text) => Some(text.clone()),
        _ => None,
    });
    assert!(copied.is_some_and(|text| text.contains("is damped")), "{commands:?}");
}

const TASK: &str = "```task\ngoal = \"Make it swing faster.\"\noffer = [\"cm_alpha\", \"cd\"]\nsolution_after = 3\nhints = [\"Stiffness.\"]\n\
    solution = \"#v=1&ac=navion&cm_alpha=-2.5&cd=0.06\"\n[[until]]\nmeasure = \"short_period.imaginary_part\"\nat_least = \"1.5 × start\"\n```";

/// The slider of the stiffness is moved by so many arrows, and left so long that this is a try.
fn try_stiffness(harness: &mut Page, arrows: usize) {
    let slider = harness
        .query_all_by_role(Role::Slider)
        .find(|node| node.accesskit_node().label().is_some_and(|label| label.contains("C_mα")));
    slider.expect("the slider that is offered").focus();
    harness.run();
    press(harness, Key::ArrowLeft, arrows);
    harness.run_steps(8);
}

#[test]
fn a_task_tells_the_way_and_its_solution_comes_after_hints_and_tries() {
    let mut harness = lesson(WIDE, TASK);
    harness.get_by_label("0 % of the way");
    assert_eq!(
        count(&harness, "Show a solution") + count(&harness, "A solution comes"),
        0,
        "hints come first"
    );
    click(&mut harness, "Give me a hint");
    // A hint is no try.
    harness.get_by_label("A solution comes after 3 more tries.");
    try_stiffness(&mut harness, 1);
    harness.get_by_label("A solution comes after 2 more tries.");
    // However many arrows, what is left as it is is one try.
    try_stiffness(&mut harness, 3);
    harness.get_by_label("A solution comes after one more try.");
    assert_eq!(count(&harness, "0 % of the way"), 0, "it has come nearer");
    assert_eq!(count(&harness, " % of the way"), 1);
    harness.run_steps(20);
    harness.get_by_label("A solution comes after one more try.");
    try_stiffness(&mut harness, 1);
    harness.get_by_role_and_label(Role::Button, "Show a solution");
}

#[test]
fn a_solution_is_played_slider_by_slider_and_one_s_own_scene_comes_back() {
    let mut harness = lesson(WIDE, &TASK.replace("solution_after = 3", "solution_after = 1"));
    click(&mut harness, "Give me a hint");
    try_stiffness(&mut harness, 2);
    let mine = (value(&harness, "cm_alpha"), value(&harness, "cd"));
    // As on a page with motion.
    harness.ctx.all_styles_mut(|style| style.animation_time = 0.1);
    harness.get_by_role_and_label(Role::Button, "Show a solution").click_accesskit();
    let mut seen = Vec::new();
    for _ in 0..400 {
        harness.step();
        let now = (value(&harness, "cm_alpha"), value(&harness, "cd"));
        if seen.last() != Some(&now) {
            seen.push(now);
        }
    }
    assert!(seen.len() > 4, "it can be followed: {seen:?}");
    assert_eq!(seen.last(), Some(&(-2.5, 0.06)));
    assert!(seen.windows(2).all(|pair| pair[0].0 == pair[1].0 || pair[0].1 == pair[1].1), "one at a time");
    assert_eq!(count(&harness, "✓ Done"), 1);
    harness.ctx.all_styles_mut(|style| style.animation_time = 0.0);
    click(&mut harness, "Back to my scene");
    assert_eq!((value(&harness, "cm_alpha"), value(&harness, "cd")), mine);
    harness.get_by_role_and_label(Role::Button, "Show a solution");

    // There with reduced motion at once.
    click(&mut harness, "Show a solution");
    assert_eq!(value(&harness, "cm_alpha"), -2.5);
}
