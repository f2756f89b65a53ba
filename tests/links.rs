//! A link is the whole scene: it reads back exactly, stays short, and opens whatever was done to it.

mod opened;

use eigenwing::content::LengthUnit;
use eigenwing::flight::aircraft::plane::{ByPlane, Plane};
use eigenwing::flight::motion::outputs::Output;
use eigenwing::flight::verdicts::mil_f_8785c::{Category, Class};
use eigenwing::flight::verdicts::task::Task;
use eigenwing::key::Keyed as _;
use eigenwing::scenario::link::own::LONGEST_OWN;
use eigenwing::scenario::link::{self, LONGEST, Notice};
use eigenwing::scenario::view::{
    Camera, ChartView, Details, Entries, EquationsView, FlightView, Instant, Look, Marks, Overlays, Pace,
    Pane, ResponseView, StandardView, Tab, Turn, View,
};
use eigenwing::scenario::{
    Dimension, Hidden, Lock, Page, Parameter, Part, Scenario, Source, Stage, parameters,
};
use opened::{AIRCRAFT, assert_sound, open};
use proptest::prelude::*;
use proptest::sample::Index;

fn aircraft(key: &str) -> Scenario {
    let found = AIRCRAFT.iter().find(|aircraft| aircraft.key == key).expect("an aircraft of the list");
    Scenario::new(found.clone())
}

fn row(key: &str) -> &'static Parameter {
    Parameter::find(key).expect("a row of the table")
}

fn set(scenario: &mut Scenario, key: &str, value: f64) {
    row(key).set(scenario, value);
}

/// One edit as a person makes it: which row, how far along what is accepted, and how round the number is.
#[derive(Clone, Debug)]
struct Edit {
    row: Index,
    fraction: f64,
    typed: bool,
    digits: usize,
}

fn edits(most: usize) -> impl Strategy<Value = Vec<Edit>> {
    let edit = (any::<Index>(), 0.0..=1.0, any::<bool>(), 1_usize..18)
        .prop_map(|(row, fraction, typed, digits)| Edit { row, fraction, typed, digits });
    prop::collection::vec(edit, 0..most)
}

/// Applies edits the way the page does: in the shown unit, and only what is accepted.
fn apply(scenario: &mut Scenario, edits: &[Edit]) {
    let rows: Vec<&Parameter> = parameters().collect();
    for edit in edits {
        let p = edit.row.get(&rows);
        let range = p.range(scenario);
        let in_si = p.dimension.in_si(scenario.aircraft.length_unit);
        let width = range.end() - range.start();
        // What is typed may lie far outside the slider.
        let reach = if edit.typed { 20.0 * width } else { 0.0 };
        let value = range.start() - reach + edit.fraction * (width + 2.0 * reach);
        let shown: f64 = format!("{:.*e}", edit.digits, value / in_si).parse().expect("a number");
        if let Ok(value) = p.check(scenario, shown * in_si) {
            p.set(scenario, value);
        }
    }
}

/// In whole degrees and per cent.
fn camera(azimuth: i16, elevation: i16, distance: i16) -> Camera {
    let [azimuth, elevation] = [azimuth, elevation].map(|x| f32::from(x).to_radians());
    Camera::new(azimuth, elevation, f32::from(distance) / 100.0)
}

prop_compose! {
    fn cameras()(
        standard in any::<Option<Index>>(),
        azimuth in -180_i16..=180,
        elevation in -29_i16..=90,
        distance in 50_i16..=600,
    ) -> Camera {
        standard.map_or(camera(azimuth, elevation, distance), |standard| standard.get(&StandardView::ALL).camera())
    }
}

/// A value of the page as it opens as often as another: links are made of what differs.
fn outputs(plane: Plane, count: usize) -> impl Strategy<Value = Vec<Output>> {
    prop::collection::vec(prop::sample::select(Output::of(plane)), count)
}

fn by_plane<T>((longitudinal, lateral): (T, T)) -> ByPlane<T> {
    ByPlane { longitudinal, lateral }
}

/// A measure over a slider, with lines of one's own.
fn charts() -> impl Strategy<Value = ChartView> {
    let sliders: Vec<&'static Parameter> = parameters().filter(|p| p.page.is_some()).collect();
    let measures =
        prop::sample::select(vec!["static_margin", "phugoid.period", "parameter.k.q_de", "peak.h"]);
    let lines = prop::collection::vec(-1e3..1e3_f64, 0..=ChartView::MOST_LINES);
    (measures, prop::option::of(prop::sample::select(sliders)), lines)
        .prop_map(|(measure, over, lines)| ChartView { measure: measure.to_owned(), over, lines })
}

prop_compose! {
    fn views()(
        shown in (prop::sample::subsequence(Output::of(Plane::Longitudinal), 1..10), prop::sample::subsequence(Output::of(Plane::Lateral), 1..9)),
        usual_shown in any::<bool>(),
        pairs in (outputs(Plane::Longitudinal, 5), outputs(Plane::Lateral, 5)),
        usual_pairs in any::<bool>(),
        flags in any::<[bool; 17]>(),
        pane in prop::option::of(prop::sample::select(Pane::VALUES)),
        camera in cameras(),
        page in any::<Index>(),
        tab in any::<Index>(),
        nonlinear in any::<bool>(),
        parts in prop::collection::vec(prop::sample::select(Part::VALUES), 0..4),
        hidden in prop::collection::vec(prop::sample::select(Hidden::VALUES), 0..4),
        locks in prop::collection::vec(prop::sample::select(Lock::VALUES), 0..3),
        type_size in prop::option::of(80_u16..=300),
        rate in prop::sample::select(&Pace::RATES),
        hundredths in 0_u32..30_000,
        playing in any::<bool>(),
        turn in prop::option::of((-180_i16..=180, -90_i16..=90, -180_i16..=180)),
        entries in prop::sample::select(Entries::VALUES),
        coloured in prop::option::of(0_usize..4),
        look in prop::option::of(prop::sample::select(Look::VALUES)),
        charts in (charts(), charts()),
    ) -> (View, Index) {
        let usual = ResponseView::default();
        let turn = turn.map(|(psi, theta, phi)| Turn { psi, theta, phi });
        let portraits = |of: &[Output]| [(of[0], of[1]), (of[2], of[3])];
        let [split, approximations, levels, shape, of_levels, of_books, is_looping, usual_overlays, ..] = flags;
        let [.., body_axes, earth_axes, angles, rates, forces, flow, path, moments, stability_axes] = flags;
        let overlays = Overlays { body_axes, earth_axes, angles, rates, forces, flow, path, moments, stability_axes };
        let instant = Instant { time: f64::from(hundredths) / 100.0, is_playing: playing };
        let response = ResponseView {
            tab: *tab.get(&Tab::ALL),
            nonlinear,
            shown: if usual_shown { usual.shown } else { by_plane(shown) },
            split,
            portraits: if usual_pairs { usual.portraits } else { by_plane((portraits(&pairs.0), portraits(&pairs.1))) },
            frequency_of: if usual_pairs { usual.frequency_of } else { by_plane((pairs.0[4], pairs.1[4])) },
            cuts_second: by_plane((usual_pairs, nonlinear)),
            chart: if usual_pairs { usual.chart } else { by_plane(charts) },
        };
        let overlays = if usual_overlays { Overlays::default() } else { overlays };
        let mut stage = Stage::with(parts).hiding(hidden).locking(locks);
        stage.type_size = type_size.map_or(1.0, |size| f64::from(size) / 100.0);
        let view = View {
            stage,
            presents: playing,
            look,
            page: Page::Matrix,
            maximised: pane,
            shows_open: nonlinear != split,
            marks: Marks { approximations, levels },
            details: Details { shape, levels: of_levels, approximations: of_books },
            response,
            flight: FlightView { camera, overlays, pace: Pace { rate, is_looping }, instant, turn },
            equations: EquationsView { entries, coloured },
        };
        (view, page)
    }
}

prop_compose! {
    fn scenes()(
        of in any::<Index>(),
        of_pinned in prop::option::of(any::<Index>()),
        on_scene in edits(40),
        on_pinned in edits(12),
        lateral in any::<bool>(),
        sources in prop::array::uniform2(any::<Index>()),
        shapes in prop::array::uniform4(any::<Index>()),
        modes in prop::array::uniform2(0_usize..4),
        follows in any::<bool>(),
        task in prop::option::of((any::<Index>(), any::<Index>())),
        (view, page) in views(),
    ) -> (Scenario, View, Option<Scenario>) {
        let mut scene = Scenario::new(of.get(&AIRCRAFT).clone());
        apply(&mut scene, &on_scene);
        if lateral && scene.aircraft.plane_notes[Plane::Lateral].is_some() {
            scene.plane = Plane::Lateral;
        }
        for (i, plane) in Plane::ALL.into_iter().enumerate() {
            let choice = &mut scene.disturbance.choices[plane];
            choice.control_shape = *shapes[i].get(Source::Elevator.shapes());
            choice.gust_shape = *shapes[2 + i].get(Source::SideGust.shapes());
            choice.source = *sources[i].get(Source::of(plane));
            choice.mode = modes[i];
        }
        scene.disturbance.follows = follows;
        if let Some((class, category)) = task {
            scene.task = Some(Task { class: *class.get(Class::VALUES), category: *category.get(Category::VALUES) });
        }
        let pinned = of_pinned.map(|of| {
            let mut pinned = Scenario::new(of.get(&AIRCRAFT).clone());
            apply(&mut pinned, &on_pinned);
            Scenario { disturbance: scene.disturbance, plane: scene.plane, ..pinned }
        });
        let pages: Vec<Page> = Page::ALL.into_iter().filter(|page| page.is_of(&scene)).collect();
        let mut view = View { page: *page.get(&pages), ..view };
        // Every other slider, or all.
        if !view.stage.parts().is_empty() {
            let sliders = parameters().filter(|p| !p.is_of_disturbance() && p.applies(&scene));
            view.stage.offered = sliders.map(|p| p.key).step_by(2).collect();
            let lockable = parameters().filter(|p| p.is_of_disturbance() || p.applies(&scene));
            view.stage.locked = lockable.map(|p| p.key).step_by(3).collect();
        }
        (scene, view, pinned)
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn every_scene_comes_back_exactly_as_it_was((scene, view, pinned) in scenes()) {
        let link = link::write(&scene, &view, pinned.as_ref());
        prop_assert!(link.bytes().all(|b| b.is_ascii_lowercase() || b.is_ascii_digit() || b"_.-=&".contains(&b)), "{link}");
        let opened = open(&link);
        prop_assert_eq!(&opened.notices, &[], "{}", link);
        prop_assert_eq!(&opened.scenario, &scene, "{}", link);
        prop_assert_eq!(&opened.view, &view, "{}", link);
        prop_assert_eq!(&opened.pinned, &pinned, "{}", link);
    }

    #[test]
    fn any_text_opens_a_scene_that_can_be_kept(text in ".{0,300}") {
        assert_sound(&open(&text), &text);
    }

    #[test]
    fn any_keys_and_numbers_open_a_scene_that_can_be_kept(
        pieces in prop::collection::vec((any::<Index>(), 0_usize..4, "(-?[0-9]{1,4}(\\.[0-9]{1,9})?(e-?[0-9]{1,3})?(si)?|nan|-inf|[a-z]{0,6})"), 0..60),
    ) {
        let keys: Vec<&str> = parameters().map(|p| p.key)
            .chain(["v", "ac", "plane", "page", "tab", "lon.source", "lon.shape", "lat.gust", "lat.mode", "follows", "lon.show",
                "lat.phase", "lon.frequency_of", "lat.loop_of", "split", "marks", "details", "pane", "camera", "drawn", "rate", "loop", "class", "category", "stage", "offer", "hide", "lock", "type", "lesson", "step", "turn", "entries", "coloured"]).collect();
        let pieces = pieces.iter().map(|(key, prefix, value)| {
            format!("{}{}={value}", ["", "add.", "pin.", "pin.add."][*prefix], key.get(&keys))
        });
        let link = pieces.collect::<Vec<_>>().join("&");
        assert_sound(&open(&link), &link);
    }
}

/// An aircraft, ten edited numbers, a disturbance, the state before it pinned, and the panes as an instructor sets them.
fn normal_scene() -> (Scenario, View, Scenario) {
    let mut pinned = aircraft("b747-approach");
    for (key, value) in [("speed", 92.0), ("cm_alpha", -0.9), ("cn_beta", 0.21)] {
        set(&mut pinned, key, value);
    }
    let mut scene = pinned.clone();
    for (key, value) in [
        ("speed", 88.5),
        ("altitude", 1200.0),
        ("gamma", -3_f64.to_radians()),
        ("mass", 1.15),
        ("cg", 0.06),
        ("cm_q", -24.3),
        ("cn_beta", 0.184),
        ("fin", 0.8),
        ("aileron", 2.5_f64.to_radians()),
        ("time", 120.0),
    ] {
        set(&mut scene, key, value);
    }
    scene.plane = Plane::Lateral;
    let choice = &mut scene.disturbance.choices[Plane::Lateral];
    choice.source = Source::Aileron;
    let pinned = Scenario { disturbance: scene.disturbance, plane: scene.plane, ..pinned };
    let usual = ResponseView::default();
    let response = ResponseView {
        tab: Tab::Phase,
        shown: ByPlane {
            lateral: vec![Output::Sideslip, Output::BankAngle, Output::SideLoad],
            ..usual.shown.clone()
        },
        portraits: ByPlane {
            lateral: [(Output::Sideslip, Output::YawRate), (Output::RollRate, Output::BankAngle)],
            ..usual.portraits
        },
        ..usual
    };
    let flight = FlightView {
        camera: camera(-40, 12, 140),
        overlays: Overlays { forces: false, rates: true, ..Overlays::default() },
        pace: Pace { rate: 0.5, ..Pace::default() },
        ..FlightView::default()
    };
    let view = View {
        marks: Marks { approximations: false, levels: true },
        details: Details { shape: true, ..Details::default() },
        response,
        flight,
        ..View::of(&scene)
    };
    (scene, view, pinned)
}

#[test]
fn a_normal_scene_is_shorter_than_500_characters() {
    let (scene, view, pinned) = normal_scene();
    let link = link::write(&scene, &view, Some(&pinned));
    assert!(link.len() < 450, "{}: {link}", link.len());
    assert_eq!((open(&link).scenario, open(&link).view, open(&link).pinned), (scene, view, Some(pinned)));
}

/// Offsets are differences of numbers that were computed, so they have all their digits.
#[test]
fn eight_edits_of_matrix_entries_and_a_pinned_state_are_shorter_than_500_characters() {
    let mut scene = aircraft("navion");
    let (mut pinned, keys) =
        (scene.clone(), ["a_uu", "a_wu", "a_qu", "a_uw", "a_ww", "a_qw", "a_wq", "a_qq"]);
    for key in keys {
        let value = row(key).get(&scene);
        set(&mut scene, key, 1.1 * value);
    }
    for key in &keys[..4] {
        let value = row(key).get(&pinned);
        set(&mut pinned, key, 0.9 * value);
    }
    let view = View { page: Page::Matrix, ..View::of(&scene) };
    let link = link::write(&scene, &view, Some(&pinned));
    assert!(link.len() < 500, "{}: {link}", link.len());
    assert_eq!(open(&link).scenario, scene);
}

#[test]
fn the_preset_is_nothing_but_its_name() {
    for aircraft in AIRCRAFT.iter() {
        let scene = Scenario::new(aircraft.clone());
        assert_eq!(link::write(&scene, &View::of(&scene), None), format!("v=1&ac={}", aircraft.key));
    }
}

#[test]
fn offsets_stay_exact_where_the_flight_cannot_be() {
    let mut scene = aircraft("navion");
    set(&mut scene, "m_w", -0.05);
    set(&mut scene, "a_qq", -1.7);
    set(&mut scene, "speed", 15.0);
    assert!(scene.analyse().is_err(), "the wing can't carry the aircraft at 15 m/s");
    let opened = open(&link::write(&scene, &View::of(&scene), None));
    assert_eq!((opened.scenario, opened.notices), (scene, vec![]));
}

#[test]
fn the_order_of_a_link_does_not_matter() {
    let (scene, view, pinned) = normal_scene();
    let link = link::write(&scene, &view, Some(&pinned));
    let mut pieces: Vec<&str> = link.split('&').collect();
    for _ in 0..pieces.len() {
        pieces.rotate_left(1);
        assert_eq!(open(&pieces.join("&")), open(&link));
    }
}

#[test]
fn a_derivative_without_add_is_the_value_itself() {
    let opened = open("v=1&ac=navion&m_w=-0.2&a_qq=-3&cm_alpha=-1");
    assert_eq!(opened.notices, []);
    for (key, value) in [("m_w", -0.2), ("a_qq", -3.0)] {
        let reached = row(key).get(&opened.scenario);
        assert!((reached - value).abs() < 1e-12, "{key}: {reached}");
    }
}

#[test]
fn a_whole_address_opens_like_its_fragment() {
    let fragment = open("v=1&ac=lesson&time=30");
    for link in [
        "#v=1&ac=lesson&time=30",
        "https://example.org/course/#v=1&ac=lesson&time=30",
        " #v=1&ac=lesson&time=30 ",
        "#v=1&amp;ac=lesson&amp;time=30",
        "v=1&ac=lesson&time=%33%30",
    ] {
        assert_eq!(open(link), fragment, "{link}");
    }
}

#[test]
fn a_link_longer_than_any_scene_is_cut_with_a_notice() {
    let long = format!("v=1&ac=navion&speed=60&{}", "é".repeat(2 * LONGEST));
    let opened = open(&long);
    assert!(opened.notices.contains(&Notice::TooLong));
    assert_eq!(row("speed").get(&opened.scenario), 60.0);
    assert_sound(&opened, "a long link");
}

/// Every number of the scene and of the pinned state edited, with all its digits.
#[test]
fn no_scene_is_too_long_for_a_link() {
    let mut scene = aircraft("navion");
    for p in parameters() {
        let range = p.range(&scene);
        let value = 0.3 / 7.0 * range.start() + (1.0 - 0.3 / 7.0) * range.end();
        let value = if p.dimension == Dimension::Count { value.round() } else { value };
        match p.added(&scene) {
            Some(_) => p.set_added(&mut scene, value),
            None => p.set(&mut scene, value),
        }
    }
    let shown = ByPlane::from_fn(|plane| Output::of(plane).to_vec());
    let response = ResponseView { shown, ..ResponseView::default() };
    let view = View { response, ..View::of(&scene) };
    let link = link::write(&scene, &view, Some(&scene));
    assert!(link.len() > 5000, "not the longest: {}", link.len());
    // A lesson and a name come behind it, and there is room for the two aircraft.
    let rest = LONGEST - 2 * LONGEST_OWN;
    assert!(link.len() + 700 <= rest, "{}", link.len());
    let opened = open(&link);
    assert_eq!(opened.pinned.as_ref(), Some(&scene));
    assert_eq!((opened.scenario, opened.view, opened.notices), (scene, view, vec![]));
}

/// Whatever is left of a scene can be drawn or says why not, and no number of it is infinite.
#[test]
fn what_a_damaged_link_opens_can_be_analysed() {
    let (scene, view, pinned) = normal_scene();
    let link = link::write(&scene, &view, Some(&pinned));
    for at in (0..link.len()).step_by(5) {
        let digits = link.replacen(|c: char| c.is_ascii_digit(), "9", at);
        let opened = open(&digits[..at]);
        if let Ok(analysis) = opened.scenario.analyse() {
            let mut states = analysis.motion.iter().flat_map(|motion| &motion.response.states);
            assert!(states.all(|x| x.iter().all(|v| v.is_finite())), "{digits}");
        }
    }
}

/// `docs/LINKS.md` has a row for every key of the table; its last part is this text.
#[test]
fn the_list_of_keys_is_that_of_the_table() {
    let mut list = String::from("| key | what | unit |\n|---|---|---|\n");
    for p in parameters() {
        let unit = match p.dimension.symbol(LengthUnit::Metre) {
            "" => "–",
            unit => unit,
        };
        let add = if p.added(&aircraft("navion")).is_some() { "add." } else { "" };
        list += &format!("| `{add}{}` | {} | {unit} |\n", p.key, p.name);
    }
    let written = include_str!("../docs/LINKS.md");
    assert!(written.ends_with(&list), "docs/LINKS.md should end with:\n{list}");
}
