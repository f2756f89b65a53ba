//! The scene taken along from the page: the sheet, what it saves or copies, and where it doesn't open.

mod page;

use egui::accesskit::Role;
use egui::{Event, Key, Modifiers, OutputCommand, Pos2, Rect, Vec2};
use egui_kittest::kittest::Queryable as _;
use eigenwing::content::{Aircraft, FILES, TextFile};
use eigenwing::ui::{App, CoreRequest, FileRequest};
use page::{PHONE, Page, TABLET, WIDE, app, open, page};

fn state(page: &mut Page) -> &mut App {
    page.state_mut().as_mut().expect("the page has been drawn")
}

fn press(page: &mut Page, name: &str) {
    page.get_by_role_and_label(Role::Button, name).click_accesskit();
    page.run_steps(8);
}

fn has(page: &Page, words: &str) -> bool {
    page.query_all_by_label_contains(words).next().is_some()
}

fn saved(page: &mut Page) -> TextFile {
    match state(page).take_file_request() {
        Some(FileRequest::Save(file)) => file,
        other => panic!("{other:?}"),
    }
}

#[test]
fn the_scene_on_screen_is_saved_as_a_script_by_keyboard_at_every_size() {
    for size in [WIDE, TABLET, PHONE] {
        let mut page = page(size);
        state(&mut page).offer_files();
        open(&mut page, "v=1&ac=x15&m_q=-0.3");
        page.key_press(Key::X);
        page.run_steps(8);
        press(&mut page, "Python");
        assert!(has(&page, "Saved: x15-python.py"), "{size}");
        let file = saved(&mut page);
        assert_eq!(file.name, "x15-python.py");
        assert!(file.text.contains("control"), "{}", file.text);
        press(&mut page, "Aircraft file");
        let file = saved(&mut page);
        assert!(file.text.contains("edits = "), "what was changed goes along: {}", file.text);
        Aircraft::from_toml(&file.name, &file.text).expect("it opens again");
        page.key_press(Key::Escape);
        page.run_steps(8);
        assert!(!has(&page, "Jupyter") && !has(&page, "Save a file"), "{size}");
    }
}

/// In a browser the core answers later: the sheet may have been closed meanwhile, and opened again.
#[test]
fn an_answer_that_nobody_waits_for_any_more_is_not_taken() {
    let mut page = page(WIDE);
    state(&mut page).offer_files();
    open(&mut page, "v=1&ac=navion");
    page.key_press(Key::X);
    page.run_steps(8);
    press(&mut page, "Python");
    saved(&mut page);
    for key in [Key::Escape, Key::X] {
        page.key_press(key);
        page.run_steps(8);
    }
    let late = CoreRequest::TakeAlong { request: String::new(), number: 1 };
    let answer = r#"{"text": "late", "file": "late.py", "notices": []}"#;
    state(&mut page).answer(&late, Ok(answer.to_owned()));
    page.run_steps(8);
    assert!(state(&mut page).take_file_request().is_none());
    assert!(!has(&page, "late.py"));
}

#[test]
fn what_can_t_be_written_says_why_in_the_sheet() {
    let mut page = page(WIDE);
    state(&mut page).offer_files();
    open(&mut page, "v=1&ac=lesson");
    page.key_press(Key::X);
    page.run_steps(8);
    press(&mut page, "Derivatives");
    let _ = state(&mut page).take_file_request();
    open(&mut page, "v=1&ac=navion&speed=1");
    press(&mut page, "Python");
    assert!(has(&page, "⚠"), "it can't be flown");
    assert!(state(&mut page).take_file_request().is_none());
}

#[test]
fn the_text_is_copied_where_no_file_can_be_saved() {
    let mut page = page(WIDE);
    page.key_press(Key::X);
    page.run_steps(8);
    page.get_by_role_and_label(Role::Button, "MATLAB, Octave").click_accesskit();
    let mut copied = None;
    for _ in 0..5 {
        page.step();
        copied = copied.or(page.output().platform_output.commands.iter().find_map(|command| match command {
            OutputCommand::CopyText(text) => Some(text.clone()),
            _ => None,
        }));
    }
    assert!(copied.is_some_and(|text| text.contains("A = [")));
    assert!(has(&page, "Copied: navion-matlab.m"));
}

#[test]
fn the_word_after_a_copied_link_and_the_sheet_of_keys_lead_to_it() {
    let mut page = page(PHONE);
    page.key_press(Key::L);
    page.run_steps(3);
    page.get_by_role_and_label(Role::Button, "Take along …").click_accesskit();
    page.run_steps(3);
    assert!(has(&page, "for another program"));
    press(&mut page, "Close");
    page.key_press(Key::Questionmark);
    page.run_steps(8);
    press(&mut page, "Take along …");
    assert!(has(&page, "for another program"));
}

#[test]
fn what_is_hidden_is_not_taken_along() {
    let mut page = page(WIDE);
    open(&mut page, "v=1&ac=navion&hide=names");
    page.key_press(Key::X);
    page.run_steps(3);
    assert!(has(&page, "Nothing can be taken along while something is hidden"));
    assert!(!has(&page, "for another program"));
    assert!(app(&page).findings().is_analysed());
}

#[test]
fn a_pane_is_taken_along_with_its_figure_first_by_its_button_and_enter() {
    for (button, file) in [
        ("Save or copy the pole map", "navion-poles-figure.svg"),
        ("Save or copy the picture of the aircraft", "navion-aircraft-figure.svg"),
        ("Save or copy the response", "navion-chart-figure.svg"),
        ("Save or copy the response", "navion-metrics.csv"),
    ] {
        let mut page = page(WIDE);
        state(&mut page).offer_files();
        let tab = if file.ends_with(".csv") { "metrics" } else { "chart" };
        open(&mut page, &format!("v=1&ac=navion&tab={tab}"));
        press(&mut page, button);
        page.key_press(Key::Enter);
        page.run_steps(4);
        let saved = saved(&mut page);
        assert_eq!(saved.name, file);
        let begins = if file.ends_with(".csv") { "output,unit,peak" } else { "<?xml" };
        assert!(saved.text.starts_with(begins), "{}", saved.text);
    }
}

#[test]
fn a_figure_becomes_a_picture_where_there_is_a_browser() {
    let mut page = page(WIDE);
    state(&mut page).offer_files();
    page.key_press(Key::X);
    page.run_steps(8);
    assert!(!has(&page, "PNG"));
    state(&mut page).offer_pictures();
    page.run_steps(2);
    press(&mut page, "PNG");
    press(&mut page, "Figure of the pole map");
    match state(&mut page).take_file_request() {
        Some(FileRequest::Picture { svg, copies: false }) => assert_eq!(svg.name, "navion-poles-figure.svg"),
        other => panic!("{other:?}"),
    }
    // Data stay what they are.
    press(&mut page, "Modes");
    assert_eq!(saved(&mut page).name, "navion-modes.csv");
}

#[test]
fn the_scene_is_printed_by_keyboard_and_what_is_hidden_is_not() {
    let mut page = page(WIDE);
    state(&mut page).offer_pictures();
    open(&mut page, "v=1&ac=navion&cm_alpha=-0.5");
    page.key_press_modifiers(Modifiers::COMMAND, Key::P);
    page.run_steps(3);
    match state(&mut page).take_file_request() {
        Some(FileRequest::Print(html)) => {
            assert!(
                html.contains("<h1>Navion: ")
                    && html.contains("cm_alpha=-0.5")
                    && html.contains("Short period")
            );
        }
        other => panic!("{other:?}"),
    }
    assert!(!app(&page).link().contains("pane=poles"), "P alone maximises the pole map");
    open(&mut page, "v=1&ac=navion&hide=numbers");
    page.key_press_modifiers(Modifiers::COMMAND, Key::P);
    page.run_steps(3);
    assert!(state(&mut page).take_file_request().is_none());
    assert!(has(&page, "Nothing can be printed while something is hidden"));
}

#[test]
fn paper_has_the_address_of_the_page_and_an_aircraft_without_a_link_is_printed_too() {
    let mut page = page(WIDE);
    state(&mut page).offer_pictures();
    state(&mut page).set_address("https://example.org/flight/".to_owned());
    let printed = |page: &mut Page| {
        page.key_press_modifiers(Modifiers::COMMAND, Key::P);
        page.run_steps(3);
        match state(page).take_file_request() {
            Some(FileRequest::Print(html)) => html,
            other => panic!("{other:?}"),
        }
    };
    open(&mut page, "v=1&ac=navion&cg=16");
    assert!(printed(&mut page).contains("https://example.org/flight/#v=1&amp;ac=navion&amp;cg=16"));
    let (_, text) = FILES.iter().find(|(file, _)| *file == "navion.toml").expect("it ships");
    let noise: String =
        (0_u64..900).map(|k| format!("# {}\n", k.wrapping_mul(0x9e37_79b9_7f4a_7c15))).collect();
    let text = noise + &text.replacen("key = \"navion\"", "key = \"own-long\"", 1);
    let kept = serde_json::json!([TextFile::new("own-long", &text)]).to_string();
    state(&mut page).take_up_aircraft(&kept, "");
    open(&mut page, "v=1&ac=own-long&cg=16");
    assert_eq!(app(&page).scenario().aircraft.key, "own-long");
    let html = printed(&mut page);
    assert!(
        html.contains("Without a link") && html.contains("<svg") && !html.contains("own-long&amp;"),
        "{html}"
    );
    state(&mut page).offer_files();
    page.key_press(Key::X);
    page.run_steps(8);
    press(&mut page, "Modes");
    assert!(saved(&mut page).text.contains("phugoid"));
}

/// What the bar has no room for is behind one sign, at every width.
#[test]
fn presenting_and_taking_along_are_reached_by_pointer_at_every_width() {
    for size in
        [WIDE, TABLET, Vec2::new(1200.0, 800.0), Vec2::new(768.0, 1024.0), PHONE, Vec2::new(320.0, 640.0)]
    {
        for (tool, leads_to) in [("Take the scene along", "for another program"), ("Present the scene", "")] {
            let mut page = page(size);
            let screen = Rect::from_min_size(Pos2::ZERO, size);
            if page.query_by_role_and_label(Role::Button, tool).is_none() {
                let more = page.get_by_role_and_label(Role::Button, "More").rect();
                assert!(screen.contains_rect(more), "{size}: {more}");
                page.get_by_role_and_label(Role::Button, "More").click();
                page.run_steps(4);
            }
            let button = page.get_by_role_and_label(Role::Button, tool);
            assert!(screen.contains_rect(button.rect()), "{size}: {tool}");
            button.click();
            page.run_steps(8);
            if leads_to.is_empty() {
                assert!(app(&page).link().contains("present=on"), "{size}");
            } else {
                assert!(has(&page, leads_to), "{size}");
            }
        }
    }
}

/// What the key C copies where the pointer is.
fn copied_at(page: &mut Page, at: Pos2) -> Option<String> {
    page.hover_at(at);
    page.run();
    // One event: a step has a frame for each, and shows what came of the last.
    let (key, modifiers) = (Key::C, Modifiers::NONE);
    page.event(Event::Key { key, physical_key: None, pressed: true, repeat: false, modifiers });
    let mut copied = None;
    for _ in 0..4 {
        page.step();
        copied = copied.or(page.output().platform_output.commands.iter().find_map(|command| match command {
            OutputCommand::CopyText(text) => Some(text.clone()),
            _ => None,
        }));
    }
    copied
}

#[test]
fn the_key_c_copies_what_is_under_the_pointer() {
    let mut page = page(WIDE);
    open(&mut page, "v=1&ac=navion");
    let centre = |page: &Page, label: &str| {
        page.query_all_by_label_contains(label).next().expect("something on the page").rect().center()
    };
    let at = centre(&page, "0.696");
    assert_eq!(copied_at(&mut page, at).as_deref(), Some("ζ = 0.696"));
    assert!(has(&page, "Copied: ζ = 0.696"));
    let at = centre(&page, "pitch stiffness C_mα");
    assert_eq!(copied_at(&mut page, at).as_deref(), Some("C_mα = −0.683 1/rad"));
    let at = centre(&page, "Δu in m/s against time");
    let table = copied_at(&mut page, at).expect("a table");
    let lines: Vec<&str> = table.lines().collect();
    assert_eq!(lines[0], "t [s]\tlinear Δu [m/s]");
    assert!(lines.len() > 100 && lines.iter().all(|line| line.split('\t').count() == 2));
    let words = format!("Copied: a table of {} lines", lines.len());
    assert!(has(&page, &words));
    open(&mut page, "v=1&ac=navion&tab=metrics");
    let at = centre(&page, "Height from the phugoid");
    let sentence = copied_at(&mut page, at).expect("a sentence");
    assert!(sentence.starts_with("Height from the phugoid’s first turning point"), "{sentence}");
    let at = centre(&page, "Overshoot");
    let table = copied_at(&mut page, at).expect("a table");
    let lines: Vec<&str> = table.lines().collect();
    assert_eq!(lines[0], "output\tunit\tpeak\tat [s]\tsteady\trise [s]\tsettled [s]\tovershoot [%]");
    assert_eq!(lines.len(), 1 + app(&page).findings().flown_metrics().expect("a motion").outputs.len());
    assert!(lines.iter().all(|line| line.split('\t').count() == 8), "{table}");
    // The bar has nothing to copy.
    assert_eq!(copied_at(&mut page, Pos2::new(720.0, 2.0)), None);
    assert!(has(&page, "Point at a number"));
    open(&mut page, "v=1&ac=navion&hide=names");
    let at = centre(&page, "pitch stiffness C_mα");
    assert_eq!(copied_at(&mut page, at), None);
    assert!(has(&page, "Nothing can be copied while something is hidden"));
}
