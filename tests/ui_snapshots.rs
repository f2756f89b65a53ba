//! Every pane as a picture, compared with that in `tests/snapshots`. A picture that was meant to change is accepted with
//! `UPDATE_SNAPSHOTS=1`, after a look at it.

mod rasterizer;

use std::ops::{Deref, DerefMut};
use std::path::{Path, PathBuf};

use egui::accesskit::Role;
use egui::{Key, Pos2, Rect, Theme, UiBuilder, Vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use eigenwing::ui::App;
use image::codecs::png::{CompressionType, FilterType, PngEncoder};
use image::{Rgba, RgbaImage, imageops};

use rasterizer::Rasterizer;

/// The page with what draws it.
struct Page {
    harness: Harness<'static, Option<App>>,
    rasterizer: Rasterizer,
}

impl Deref for Page {
    type Target = Harness<'static, Option<App>>;

    fn deref(&self) -> &Self::Target {
        &self.harness
    }
}

impl DerefMut for Page {
    fn deref_mut(&mut self) -> &mut Self::Target {
        &mut self.harness
    }
}

/// In the order in which the key T goes through them.
const SCREENS: &[&str] = &["light", "dark"];
const ALL_LOOKS: &[&str] = &["light", "dark", "projector"];

/// A page on which one pane and the sliders have all the room.
const ONE_PANE: Vec2 = Vec2::new(1000.0, 520.0);
/// A page with all panes.
const ALL_PANES: Vec2 = Vec2::new(1200.0, 720.0);
const PHONE: Vec2 = Vec2::new(390.0, 844.0);

/// Between panes, and around them.
const GAP: f32 = 10.0;

fn page(size: Vec2, link: impl Into<String>) -> Page {
    let link = link.into();
    let start = move |ui: &egui::Ui| {
        let mut app = App::new(ui.ctx()).expect("an aircraft");
        app.open(&link);
        app
    };
    let rasterizer = Rasterizer::default();
    let builder = Harness::builder().with_size(size).with_theme(Theme::Light).renderer(rasterizer.clone());
    let mut harness = builder.build_ui_state(
        move |ui, app: &mut Option<App>| {
            // The harness leaves a margin, a browser doesn't.
            let window = UiBuilder::new().max_rect(ui.content_rect());
            ui.scope_builder(window, |ui| app.get_or_insert_with(|| start(ui)).ui(ui));
        },
        None,
    );
    harness.run();
    Page { harness, rasterizer }
}

fn press(page: &mut Page, key: Key) {
    page.key_press(key);
    page.run();
}

/// Without a pointer, which would leave its mark.
fn click(page: &mut Page, label: &str) {
    page.get_by_label(label).click_accesskit();
    page.run();
}

/// Another machine's sines may differ in the last digit, which may bring a corner to the next of the 256 places in a pixel. A soft edge
/// then changes by one shade of 256, two over each other by two.
const SHADES: u8 = 2;
/// A hard edge of the aircraft may then change a pixel altogether, if its middle is within that step: a few in thousands.
const PIXELS: usize = 4;

/// Compares a part of the page in several looks.
fn compare(name: &str, looks: &[&str], mut page: Page, part: impl Fn(&Page) -> Rect) {
    let mut changed = Vec::new();
    for look in looks {
        let part = part(&page).round();
        let [x, y, width, height] =
            [part.left(), part.top(), part.width(), part.height()].map(|side| side as u32);
        let picture = page.rasterizer.picture(&page.ctx, page.output()).expect("meshes of known textures");
        let picture = imageops::crop_imm(&picture, x, y, width, height).to_image();
        let name = format!("{name}_{look}");
        if !is_as_before(&name, &picture) {
            changed.push(name);
        }
        press(&mut page, Key::T);
    }
    assert!(
        changed.is_empty(),
        "changed, or new: {changed:?}; see *.new.png and *.diff.png in tests/snapshots"
    );
}

fn file(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/snapshots").join(format!("{name}.png"))
}

/// Whether a picture is that of the file, or is now.
fn is_as_before(name: &str, picture: &RgbaImage) -> bool {
    let [new, difference] = ["new", "diff"].map(|what| file(&format!("{name}.{what}")));
    for left in [&new, &difference] {
        std::fs::remove_file(left).ok();
    }
    let before = image::open(file(name)).ok().map(|before| before.to_rgba8());
    if let Some(before) = before.filter(|before| before.dimensions() == picture.dimensions()) {
        let differs =
            |(a, b): (&Rgba<u8>, &Rgba<u8>)| a.0.iter().zip(b.0).any(|(a, b)| a.abs_diff(b) > SHADES);
        let red = |both| Rgba(if differs(both) { [255, 0, 0, 255] } else { [0, 0, 0, 255] });
        if before.pixels().zip(picture.pixels()).filter(|both| differs(*both)).count() <= PIXELS {
            return true;
        }
        let (width, height) = picture.dimensions();
        let marked =
            RgbaImage::from_fn(width, height, |x, y| red((before.get_pixel(x, y), picture.get_pixel(x, y))));
        write(&difference, &marked);
    }
    let accepts = std::env::var_os("UPDATE_SNAPSHOTS").is_some();
    if accepts {
        std::fs::remove_file(&difference).ok();
    }
    write(&if accepts { file(name) } else { new }, picture);
    accepts
}

/// In few bytes, since all pictures stay in the history.
fn write(path: &Path, picture: &RgbaImage) {
    let file = std::fs::File::create(path).expect("a folder that can be written to");
    let encoder = PngEncoder::new_with_quality(file, CompressionType::Best, FilterType::NoFilter);
    let picture = image::DynamicImage::from(picture.clone()).to_rgb8();
    picture.write_with_encoder(encoder).expect("room on the disk");
}

fn window(page: &Page) -> Rect {
    page.ctx.content_rect()
}

/// A pane that reaches down to the end of the window, with the ground around it.
fn pane(page: &Page, heading: &str, name: &str) -> Rect {
    let heading = page.get_by_role_and_label(Role::Heading, heading).rect();
    let corner = page.get_by_label(&format!("Maximise the {name}")).rect();
    let top_left = Pos2::new(heading.left() - 12.0, corner.top() - 5.0);
    let top_right = Pos2::new(corner.right() + 8.0, top_left.y);
    Rect::from_two_pos(top_left, top_right).expand(GAP).with_max_y(window(page).bottom())
}

fn poles(page: &Page) -> Rect {
    pane(page, "Pole map", "pole map")
}

fn responses(page: &Page) -> Rect {
    pane(page, "Response to", "response")
}

fn sliders(page: &Page) -> Rect {
    window(page).with_max_x(poles(page).left()).with_min_y(poles(page).top())
}

fn aircraft(page: &Page) -> Rect {
    pane(page, "Aircraft", "aircraft")
}

fn modes(page: &Page) -> Rect {
    window(page).with_min_x(responses(page).right()).with_min_y(poles(page).top())
}

/// A page with the response over all of it.
fn response_page(link: impl Into<String>) -> Page {
    let mut page = page(ONE_PANE, link);
    press(&mut page, Key::R);
    page
}

#[test]
fn the_sliders_look_as_they_did() {
    let mut page = page(ALL_PANES, "v=1&ac=navion&cm_alpha=-0.45&cg=5&speed=60");
    page.get_by_role_and_label(Role::Slider, "pitch stiffness C_mα").focus();
    page.run();
    compare("sliders", SCREENS, page, sliders);
}

#[test]
fn the_pole_map_looks_as_it_did() {
    let mut page = page(ONE_PANE, "v=1&ac=navion&cm_alpha=-0.45&pin.ac=navion");
    page.get_by_role_and_label(Role::Slider, "pitch stiffness C_mα").focus();
    page.run();
    click(&mut page, "Textbook approximations");
    click(&mut page, "Level boundaries");
    press(&mut page, Key::P);
    compare("pole_map", ALL_LOOKS, page, poles);
}

#[test]
fn the_modes_look_as_they_did() {
    let mut page = page(Vec2::new(1200.0, 860.0), "v=1&ac=navion&cm_alpha=-0.45&pin.ac=navion");
    for what in ["Shape", "Level", "Approximations"] {
        click(&mut page, &format!("{what} of the short period"));
    }
    compare("modes", SCREENS, page, modes);
}

#[test]
fn a_warning_and_a_mode_that_grows_look_as_they_did() {
    let page = page(ALL_PANES, "v=1&ac=lesson-printed");
    compare("warning", SCREENS, page, modes);
}

#[test]
fn motion_over_time_looks_as_it_did() {
    let page =
        response_page("v=1&ac=navion&cm_alpha=-0.45&elevator=-2&time=40&flight=nonlinear&pin.ac=navion");
    compare("response_time", SCREENS, page, responses);
}

#[test]
fn motion_split_into_modes_looks_as_it_did() {
    let mut page = response_page("v=1&ac=b747-approach&plane=lat");
    click(&mut page, "Split into modes");
    compare("response_split", SCREENS, page, responses);
}

#[test]
fn phase_portraits_look_as_they_did() {
    let page = response_page("v=1&ac=navion&cm_alpha=-0.45&tab=phase&pin.ac=navion");
    compare("response_phase", SCREENS, page, responses);
}

#[test]
fn motion_over_frequency_looks_as_it_did() {
    let page = response_page("v=1&ac=navion&cm_alpha=-0.45&tab=frequency&pin.ac=navion");
    compare("response_frequency", SCREENS, page, responses);
}

/// A yaw damper with washout and actuator.
const DAMPED: &str = "v=1&ac=b747-fc9&plane=lateral&k.r_dr=1.5&washout=3&actuator=0.1&page=feedback";

#[test]
fn a_law_of_feedback_looks_as_it_did() {
    compare("feedback_sliders", SCREENS, page(ALL_PANES, DAMPED), sliders);
    compare("feedback_poles", SCREENS, page(ALL_PANES, DAMPED), poles);
}

#[test]
fn the_loops_of_a_law_look_as_they_did() {
    for tab in ["loop", "nyquist", "gain-map"] {
        let page = response_page(format!("{DAMPED}&tab={tab}"));
        compare(&format!("feedback_{tab}"), SCREENS, page, responses);
    }
}

#[test]
fn a_chart_looks_as_it_did() {
    let link = "v=1&ac=navion&tab=chart&lon.chart=short_period.damping_ratio&lon.over=cg&pin.ac=navion";
    compare("response_chart", SCREENS, response_page(link), responses);
}

#[test]
fn figures_look_as_they_did() {
    let page = response_page("v=1&ac=navion&cm_alpha=-0.45&tab=figures&pin.ac=navion");
    compare("response_figures", SCREENS, page, responses);
}

#[test]
fn the_aircraft_looks_as_it_did() {
    let mut page = page(ONE_PANE, "v=1&ac=navion&lon.shape=doublet&elevator=-4");
    press(&mut page, Key::A);
    page.get_by_role_and_label(Role::Slider, "Time of the playback in s").set_value_accesskit(4.0);
    page.run();
    compare("aircraft", SCREENS, page, aircraft);
}

#[test]
fn a_mode_flown_alone_looks_as_it_did() {
    let mut page = page(ONE_PANE, "v=1&ac=b747-approach&plane=lat&lat.source=mode&lat.mode=2");
    press(&mut page, Key::A);
    click(&mut page, "Shown on the picture");
    compare("aircraft_in_one_mode", SCREENS, page, aircraft);
}

#[test]
fn the_top_bar_looks_as_it_did() {
    let page = page(Vec2::new(1200.0, 400.0), "v=1&ac=navion&cm_alpha=-0.45&pin.ac=navion");
    compare("top_bar", SCREENS, page, |page| window(page).with_max_y(poles(page).top()));
}

#[test]
fn the_sheet_of_keys_looks_as_it_did() {
    // Too low for all of it.
    let mut page = page(ONE_PANE, "v=1&ac=navion");
    press(&mut page, Key::Questionmark);
    compare("keys", SCREENS, page, |page| {
        let heading = page.get_by_role_and_label(Role::Heading, "Keys").rect();
        let close = page.get_by_label("Close").rect();
        let middle = window(page).center().x;
        heading.union(close).with_max_x(2.0 * middle - heading.left()).expand(16.0 + GAP)
    });
}

#[test]
fn a_phone_looks_as_it_did() {
    let page = page(PHONE, "v=1&ac=navion&cm_alpha=-0.45&pin.ac=navion");
    compare("phone", SCREENS, page, window);
}
