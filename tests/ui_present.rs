//! Presenting: a slide fills the screen, is stepped by keys that edit nothing, and is read from the last row.

mod page;

use egui::accesskit::Role;
use egui::epaint::{ClippedShape, TextShape};
use egui::{FontFamily, FontId, Key, Modifiers, Pos2, Rect, Shape, Vec2};
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use eigenwing::ui::Presentation;
use page::{Page, app, open, page, value};

/// Screens of a lecture hall as they are in points: 1920 × 1080 and 1024 × 768.
const SCREENS: [Vec2; 2] = [Vec2::new(835.6, 470.0), Vec2::new(626.7, 470.0)];

/// Keys with which presenters and clickers step.
const STEPPING: [Key; 11] = [
    Key::PageDown,
    Key::PageUp,
    Key::ArrowRight,
    Key::ArrowLeft,
    Key::ArrowDown,
    Key::ArrowUp,
    Key::Space,
    Key::Enter,
    Key::Home,
    Key::End,
    Key::Backspace,
];

fn lecture(page: &Page) -> &Presentation {
    app(page).presentation().expect("a lecture is on")
}

fn press(page: &mut Page, key: Key) {
    page.key_press(key);
    page.step();
    page.step();
}

fn presented(screen: Vec2, link: &str) -> Page {
    let mut page = page(screen);
    page.state_mut().as_mut().expect("the page has been drawn").open(link);
    settle(&mut page);
    page
}

/// Lets axes ease and labels find their places.
fn settle(page: &mut Page) {
    (0..30).for_each(|_| page.step());
}

fn has(page: &Page, words: &str) -> bool {
    page.query_all_by_label_contains(words).next().is_some()
}

#[test]
fn no_stepping_key_edits_a_slider_a_pole_or_the_aircraft_that_has_the_focus() {
    let link = "v=1&ac=navion&stage=derivatives.poles.aircraft&offer=cm_alpha.cm_q&present=on";
    let mut page = presented(SCREENS[0], link);
    let before = app(&page).link();
    let targets =
        [(Role::Slider, "pitch stiffness"), (Role::Button, "Short period pole"), (Role::Image, "Navion")];
    for (role, label) in targets {
        let is_it = |node: &egui_kittest::Node<'_>| {
            node.accesskit_node().label().is_some_and(|text| text.contains(label))
        };
        for key in STEPPING {
            page.query_all_by_role(role).find(is_it).unwrap_or_else(|| panic!("{label}")).focus();
            page.step();
            page.key_press(key);
            page.step();
            page.key_press_modifiers(Modifiers::SHIFT, key);
            page.step();
            assert_eq!(app(&page).link(), before, "{key:?} on {label}");
        }
    }
}

#[test]
fn a_lecture_is_stepped_by_page_down_alone_and_asks_before_it_shows() {
    for (lesson, least) in [("lecture-modes", 12), ("lecture-matrix", 12)] {
        let mut page = presented(SCREENS[0], &format!("v=1&lesson={lesson}&present=on"));
        let count = lecture(&page).count;
        assert!(count >= least, "{count}");
        let mut answered = 0;
        for slide in 0..count {
            assert_eq!(lecture(&page).slide, slide);
            assert!(!has(&page, "; right"), "slide {slide} gives its answer away");
            let session = lecture(&page).revealed();
            press(&mut page, Key::PageDown);
            if lecture(&page).slide == slide && lecture(&page).revealed() > session {
                answered += 1;
                press(&mut page, Key::PageDown);
            }
        }
        assert!(answered >= least, "{answered} of {count}");
        assert_eq!(lecture(&page).slide, count - 1, "it stays at its end");
        press(&mut page, Key::Home);
        assert_eq!((lecture(&page).slide, lecture(&page).revealed()), (0, 1), "a slide is as it was left");
        press(&mut page, Key::End);
        assert_eq!(lecture(&page).slide, count - 1);
    }
}

#[test]
fn a_black_screen_shows_nothing_and_any_key_brings_the_slide_back_and_does_nothing_else() {
    let mut page = presented(SCREENS[0], "v=1&lesson=lecture-modes&present=on");
    let text = |page: &Page| texts(page).len();
    assert!(text(&page) > 5);
    for (blank, back) in [(Key::B, Key::B), (Key::Period, Key::PageDown), (Key::B, Key::Escape)] {
        press(&mut page, blank);
        assert!(lecture(&page).is_blank && text(&page) == 0);
        press(&mut page, back);
        assert!(!lecture(&page).is_blank && text(&page) > 5);
        assert_eq!((lecture(&page).slide, lecture(&page).revealed()), (0, 0), "{back:?}");
    }
}

#[test]
fn hands_are_counted_by_figures_and_stay_on_their_slide() {
    let mut page = presented(SCREENS[0], "v=1&lesson=lecture-modes&present=on");
    for key in [Key::Num2, Key::Num2, Key::Num3, Key::Num1, Key::Num2] {
        press(&mut page, key);
    }
    page.key_press_modifiers(Modifiers::SHIFT, Key::Num1);
    page.step();
    assert_eq!(lecture(&page).hands(0), [0, 3, 1]);
    press(&mut page, Key::PageDown);
    press(&mut page, Key::PageDown);
    assert_eq!(lecture(&page).slide, 1);
    assert!(lecture(&page).hands(0).is_empty());
    press(&mut page, Key::PageUp);
    assert_eq!(lecture(&page).hands(0), [0, 3, 1]);
    assert!(has(&page, "3 hands"));
    press(&mut page, Key::Num0);
    assert!(lecture(&page).hands(0).is_empty());
}

#[test]
fn names_and_numbers_are_hidden_and_shown_by_a_key() {
    let mut page = presented(SCREENS[0], "v=1&ac=navion&stage=poles&present=on");
    assert!(has(&page, "Short period pole, "));
    press(&mut page, Key::H);
    assert!(!has(&page, "Short period") && has(&page, "Mode 1"));
    press(&mut page, Key::H);
    assert!(has(&page, "Short period pole, "));
}

#[test]
fn what_a_scene_alone_hides_is_shown_by_the_next_key() {
    let mut page = presented(SCREENS[0], "v=1&ac=navion&stage=poles&hide=names.numbers&present=on");
    assert!(!has(&page, "Short period"));
    press(&mut page, Key::ArrowRight);
    assert!(has(&page, "Short period pole, "));
}

#[test]
fn leaving_keeps_the_scene_and_brings_the_workbench_back_at_its_size() {
    let link = "v=1&ac=navion&stage=derivatives.poles&offer=cm_alpha";
    let mut page = page(SCREENS[0]);
    open(&mut page, link);
    page.key_press(Key::F);
    settle(&mut page);
    assert!(app(&page).link().contains("present=on"));
    let before = value(&page, "cm_alpha");
    page.get_by_role(Role::Slider).increment_accesskit();
    page.step();
    let after = value(&page, "cm_alpha");
    assert_ne!(before, after, "what is offered can be moved");
    press(&mut page, Key::Escape);
    settle(&mut page);
    assert!(app(&page).presentation().is_none() && page.ctx.zoom_factor() == 1.0);
    assert_eq!(value(&page, "cm_alpha"), after);
    assert!(has(&page, "Share link"));
}

/// The pictures of a slide, each by what it is of, with its place.
fn pictures(page: &Page) -> Vec<(String, Rect)> {
    let pictures = page.query_all_by_role(Role::Image).filter_map(|node| {
        let told = node.accesskit_node().label()?;
        let what = told.split([':', ';']).next().unwrap_or_default().split(" against").next()?.to_owned();
        Some((what, node.rect()))
    });
    pictures.collect()
}

#[test]
fn what_is_on_a_slide_before_the_answer_is_there_after_it() {
    let mut plots = 0;
    for screen in SCREENS {
        for lesson in ["lecture-modes", "lecture-matrix"] {
            let mut page = presented(screen, &format!("v=1&lesson={lesson}&present=on"));
            for slide in 0..lecture(&page).count {
                assert_eq!(lecture(&page).slide, slide);
                let before = pictures(&page);
                plots += before.len();
                press(&mut page, Key::PageDown);
                settle(&mut page);
                let after = pictures(&page);
                for (what, _) in &before {
                    assert!(
                        after.iter().any(|(after, _)| after == what),
                        "{lesson} {slide} at {screen}: {what} in {after:?}"
                    );
                }
                press(&mut page, Key::PageDown);
                settle(&mut page);
            }
        }
    }
    assert!(plots > 60, "{plots}");
}

#[test]
fn hands_answers_and_minutes_are_gone_on_with() {
    let link = "v=1&lesson=lecture-modes&present=on";
    let mut page = presented(SCREENS[0], link);
    for key in [Key::Num2, Key::Num2, Key::Num3, Key::PageDown, Key::PageDown, Key::Num1] {
        press(&mut page, key);
    }
    let kept = lecture(&page).kept();
    let mut again = self::page::page(SCREENS[0]);
    let state = again.state_mut().as_mut().expect("the page has been drawn");
    assert!(!state.take_up_lecture(&kept, 600.0), "nothing is presented");
    state.open(&format!("{link}&step=2"));
    assert!(state.take_up_lecture(&kept, 600.0));
    settle(&mut again);
    assert_eq!((lecture(&again).slide, lecture(&again).hands(0)), (1, &[1][..]));
    assert!((lecture(&again).started - again.ctx.input(|input| input.time) + 600.0).abs() < 60.0);
    press(&mut again, Key::PageUp);
    assert_eq!((lecture(&again).revealed(), lecture(&again).hands(0)), (1, &[0, 2, 1][..]));
}

#[test]
fn nothing_of_a_lecture_goes_into_the_records() {
    let mut page = presented(SCREENS[0], "v=1&lesson=lecture-modes&present=on");
    for key in [Key::Num1, Key::PageDown, Key::PageDown, Key::PageDown, Key::PageDown] {
        press(&mut page, key);
    }
    let records = |page: &mut Page| page.state_mut().as_mut().expect("a page").take_changed_records();
    assert_eq!(records(&mut page), None);
    press(&mut page, Key::Escape);
    settle(&mut page);
    let kept = records(&mut page).unwrap_or_default();
    assert!(!kept.contains("chosen") && !kept.contains(r#""final":true"#), "{kept}");
}

#[test]
fn a_finger_steps_at_the_edges_and_plays_between_them() {
    let mut page = presented(SCREENS[0], "v=1&lesson=lecture-modes&present=on");
    let tap = |page: &mut Page, at: Pos2| {
        for phase in [egui::TouchPhase::Start, egui::TouchPhase::End] {
            let pressed = phase == egui::TouchPhase::Start;
            let (device_id, id) = (egui::TouchDeviceId(1), egui::TouchId(1));
            page.event(egui::Event::PointerMoved(at));
            page.event(egui::Event::Touch { device_id, id, phase, pos: at, force: None });
            let button = egui::PointerButton::Primary;
            page.event(egui::Event::PointerButton { pos: at, button, pressed, modifiers: Modifiers::NONE });
            page.step();
        }
        page.step();
    };
    let right = Pos2::new(SCREENS[0].x - 30.0, 440.0);
    tap(&mut page, right);
    assert_eq!((lecture(&page).slide, lecture(&page).revealed()), (0, 1));
    tap(&mut page, right);
    assert_eq!(lecture(&page).slide, 1);
    tap(&mut page, Pos2::new(30.0, 455.0));
    assert_eq!(lecture(&page).slide, 0);
}

/// All text that is drawn, with what clips it.
fn texts(page: &Page) -> Vec<(Rect, TextShape)> {
    fn collect(shape: &Shape, clip: Rect, texts: &mut Vec<(Rect, TextShape)>) {
        match shape {
            Shape::Text(text) if !text.galley.is_empty() => texts.push((clip, text.clone())),
            Shape::Vec(shapes) => shapes.iter().for_each(|shape| collect(shape, clip, texts)),
            _ => {}
        }
    }
    let mut found = Vec::new();
    for ClippedShape { clip_rect, shape, .. } in &page.output().shapes {
        collect(shape, *clip_rect, &mut found);
    }
    found
}

/// Height of a capital over the size of type, of each family, as the faces have it.
fn capitals(page: &Page) -> Vec<(FontFamily, f32)> {
    const SIZE: f32 = 400.0;
    let families = page.ctx.fonts(|fonts| fonts.definitions().families.keys().cloned().collect::<Vec<_>>());
    let height = |family: FontFamily| {
        let font = FontId::new(SIZE, family.clone());
        let galley =
            page.ctx.fonts_mut(|fonts| fonts.layout_no_wrap("H".to_owned(), font, egui::Color32::WHITE));
        (family, galley.rows[0].glyphs[0].uv_rect.size.y / SIZE)
    };
    families.into_iter().map(height).collect()
}

/// Letters of everything that is shown have this share of the height of the screen, but for indices, as in print.
const LETTERS: f32 = 0.0175;
const TITLES: f32 = 0.025;

/// Checks every text of a slide; gives how many there are.
fn check_texts(page: &Page, screen: Vec2, capitals: &[(FontFamily, f32)], told: &str) -> usize {
    let texts = texts(page);
    let whole = Rect::from_min_size(Pos2::ZERO, screen);
    for (number, (clip, TextShape { pos, galley, .. })) in texts.iter().enumerate() {
        let words = galley.text();
        for section in &galley.job.sections {
            let format = &section.format;
            let is_index = format.line_height.is_some();
            let (_, capital) = capitals
                .iter()
                .find(|(family, _)| *family == format.font_id.family)
                .expect("a family of the page");
            let share = capital * format.font_id.size / screen.y;
            let least = if number == 0 { TITLES } else { LETTERS };
            assert!(is_index || share >= least, "{told}: “{words}” has {share}");
        }
        let ink = galley.mesh_bounds.translate(pos.to_vec2());
        let seen = clip.intersect(whole).expand(1.5);
        assert!(!ink.is_positive() || seen.contains_rect(ink), "{told}: “{words}” at {ink} is cut by {seen}");
    }
    texts.len()
}

#[test]
fn every_letter_of_every_slide_can_be_read_from_the_last_row_and_none_is_cut_off() {
    for screen in SCREENS {
        for lesson in ["lecture-modes", "lecture-matrix"] {
            let mut page = presented(screen, &format!("v=1&lesson={lesson}&present=on"));
            let capitals = capitals(&page);
            assert!(capitals.iter().all(|(_, share)| (0.62..0.76).contains(share)), "{capitals:?}");
            let mut seen = 0;
            for _ in 0..2 * lecture(&page).count {
                settle(&mut page);
                let (slide, revealed) = (lecture(&page).slide, lecture(&page).revealed());
                let told = format!("{lesson}, slide {}, {revealed} revealed, {screen}", slide + 1);
                seen += check_texts(&page, screen, &capitals, &told);
                if revealed > 0 {
                    press(&mut page, Key::W);
                    check_texts(&page, screen, &capitals, &format!("{told}, with reasons"));
                }
                press(&mut page, Key::PageDown);
            }
            assert!(seen > 400, "{seen}");
        }
    }
}

/// Scenes without a lesson, of every pane alone and of the usual pairs.
const SCENES: [&str; 12] = [
    "ac=navion&stage=poles",
    "ac=navion&plane=lat&stage=poles",
    "ac=navion&stage=aircraft",
    "ac=b747-approach&plane=lat&stage=response",
    "ac=navion&stage=response&tab=phase",
    "ac=navion&stage=response&tab=frequency",
    "ac=navion&stage=poles.response",
    "ac=navion&stage=aircraft.response&lon.source=mode&lon.mode=1",
    "ac=navion&plane=lat&stage=modes",
    "ac=navion&stage=derivatives.poles&offer=cm_alpha.cm_q.cg.speed",
    "ac=navion&stage=equations",
    "ac=navion",
];

#[test]
fn every_pane_can_be_read_from_the_last_row_without_a_lesson_too() {
    for screen in SCREENS {
        for scene in SCENES {
            let page = presented(screen, &format!("v=1&{scene}&present=on"));
            let capitals = capitals(&page);
            let seen = check_texts(&page, screen, &capitals, &format!("{scene}, {screen}"));
            assert!(seen > 4, "{scene}: {seen}");
        }
    }
}

#[test]
fn curves_are_four_pixels_wide_and_crosses_are_24_of_1080() {
    let pixel = SCREENS[0].y / 1080.0;
    let link = "v=1&ac=navion&cm_q=-4&pin.ac=navion&stage=poles.response&split=modes&present=on";
    let page = presented(SCREENS[0], link);
    let (mut curves, mut arms) = (0, 0);
    for ClippedShape { shape, .. } in &page.output().shapes {
        match shape {
            Shape::Path(path) if path.points.len() > 12 && !path.closed => {
                curves += 1;
                assert!(path.stroke.width >= 4.0 * pixel, "{}", path.stroke.width / pixel);
            }
            Shape::LineSegment { points: [from, to], stroke } if stroke.width > 2.0 => {
                let way = *to - *from;
                if (way.x.abs() - way.y.abs()).abs() < 0.01 {
                    arms += 1;
                    assert!(way.length() >= 24.0 * pixel, "{}", way.length() / pixel);
                }
            }
            _ => {}
        }
    }
    assert!(curves >= 5 && arms >= 8, "{curves} curves, {arms} arms of crosses");
}
