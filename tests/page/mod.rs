//! The page without a window, for every test that looks at it.

#![allow(dead_code, clippy::allow_attributes, reason = "each test file uses a part of it")]

use egui::accesskit::Role;
use egui::{Key, Vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use eigenwing::scenario::Parameter;
use eigenwing::ui::App;

pub const WIDE: Vec2 = Vec2::new(1440.0, 900.0);
pub const TABLET: Vec2 = Vec2::new(1024.0, 768.0);
pub const PHONE: Vec2 = Vec2::new(390.0, 844.0);

pub type Page = Harness<'static, Option<App>>;

/// The page as it opens, at rest.
pub fn page(size: Vec2) -> Page {
    let mut harness = Harness::builder().with_size(size).build_ui_state(
        |ui, app: &mut Option<App>| {
            app.get_or_insert_with(|| App::new(ui.ctx()).expect("an aircraft")).ui(ui)
        },
        None,
    );
    harness.run();
    harness
}

pub fn app(page: &Page) -> &App {
    page.state().as_ref().expect("the page has been drawn")
}

/// Of the parameter with a key.
pub fn value(page: &Page, key: &str) -> f64 {
    Parameter::find(key).expect("a row").get(app(page).scenario())
}

/// Opens a link at the address.
pub fn open(page: &mut Page, link: &str) {
    page.state_mut().as_mut().expect("the page has been drawn").open(link);
    page.run();
}

/// Chooses from a list.
pub fn choose(page: &mut Page, chooser: &str, choice: &str) {
    page.get_by_role_and_label(Role::ComboBox, chooser).click();
    page.run();
    let exact = page
        .query_all_by_role(Role::Button)
        .find(|node| node.accesskit_node().label().is_some_and(|label| label == choice));
    // As a screen reader does, which doesn't have to scroll a long list on a phone.
    exact.unwrap_or_else(|| page.get_by_label_contains(choice)).click_accesskit();
    page.run();
    // A list stays open for it.
    page.key_press(Key::Escape);
    page.run();
}

/// Types into a field, and Enter.
pub fn type_into(page: &mut Page, field: &str, text: &str) {
    page.get_by_role_and_label(Role::TextInput, field).focus();
    page.run();
    page.get_by_role_and_label(Role::TextInput, field).type_text(text);
    page.run();
    page.key_press(Key::Enter);
    page.run();
}
