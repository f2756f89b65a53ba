//! The search among the sliders: which of a page are listed, and where else one would be found.

use egui::{Button, Event, Key, Modifiers, RichText, TextEdit, Ui};

use super::arrow_keys;
use super::symbol::Symbol;
use super::theme::{self, Palette};
use crate::flight::aircraft::plane::Plane;
use crate::scenario::{Page, Parameter, Scenario, Stage, parameters};
use crate::words;

/// The key that goes to the search field.
const SEARCH_KEY: Key = Key::Slash;

/// A field that narrows the list, and the way to the equations; says whether they are asked for.
pub fn search_ui(ui: &mut Ui, search: &mut String) -> bool {
    let palette = Palette::of(ui);
    ui.horizontal(|ui| {
        let hint = RichText::new("Find a derivative (/)").font(theme::small()).color(palette.weak);
        let equations = Symbol::parse("ẋ = A x").job(theme::sizes(ui).inline_symbol, palette.text);
        let to_equations = ui.painter().layout_job(equations.clone()).size().x + 24.0;
        let width = ui.available_width() - to_equations - if search.is_empty() { 0.0 } else { 26.0 };
        let field = TextEdit::singleline(search)
            .hint_text(hint)
            .desired_width(width)
            .font(theme::small())
            .align(egui::Align2::LEFT_CENTER);
        let response = ui.add(field).accessible_name("Find a derivative");
        theme::focus_frame(ui, &response);
        if response.has_focus() {
            arrow_keys::keep(ui, &response);
        }
        // On many keyboards it is typed with Shift.
        let others = Modifiers { shift: false, ..ui.input(|input| input.modifiers) };
        let pressed = ui.input(|input| input.key_pressed(SEARCH_KEY)) && others.is_none();
        if pressed && !ui.text_edit_focused() {
            response.request_focus();
            // The key itself isn't meant for the field.
            ui.input_mut(|input| {
                input.events.retain(|event| !matches!(event, Event::Text(text) if text == "/"))
            });
        }
        if !search.is_empty()
            && theme::bare_button(ui, true, Button::new("✕")).accessible_name("Show all sliders").clicked()
        {
            search.clear();
        }
        let button = ui.add(Button::new(equations)).accessible_name(words::equations::TITLE);
        button.on_hover_text("The equations, alone and large (E)").clicked()
    })
    .inner
}

/// Of the sliders of a page, those that are wanted.
#[derive(Clone, Copy, Debug)]
pub struct Filter<'a> {
    /// Text that a slider has in its symbol, its name or what is said of it.
    pub search: &'a str,
    /// The stage, which may offer a few only.
    pub stage: &'a Stage,
}

/// Whether a slider is in the list of a page.
pub fn is_listed(parameter: &Parameter, scenario: &Scenario, page: Page, filter: Filter<'_>) -> bool {
    parameter.is_shown(scenario, page)
        && filter.stage.offers(parameter.key)
        && is_wanted(
            parameter,
            parameter.written(scenario.convention()).symbol,
            &filter.search.trim().to_lowercase(),
        )
}

/// A search of fewer letters is for symbols and names only: it would be found in nearly every sentence.
const FOR_SENTENCES: usize = 3;

/// Letters and figures alone, Greek ones as one would type them on a plain keyboard: `C_mα` is `cma`.
pub fn condensed(text: &str) -> String {
    let latin = |c: char| match c {
        'α' => 'a',
        'β' => 'b',
        'γ' | 'Γ' => 'g',
        'δ' | 'Δ' => 'd',
        'θ' => 't',
        'φ' => 'f',
        _ => c,
    };
    text.to_lowercase().chars().map(latin).filter(|c| c.is_alphanumeric()).collect()
}

/// Whether the symbol as plain text, the key or the name has the wanted letters in it, whatever stands between them, or what is
/// said of its meaning, sign and source has a word that begins with them. Who writes an underscore wants a symbol, not what
/// moves it.
fn is_wanted(parameter: &Parameter, shown: &str, wanted: &str) -> bool {
    let letters = condensed(wanted);
    if letters.is_empty() && !wanted.is_empty() {
        return false;
    }
    let begins_a_word = |text: &str| {
        let text = text.to_lowercase();
        let begins =
            |(i, _): (usize, &str)| !text[..i].chars().next_back().is_some_and(char::is_alphanumeric);
        text.match_indices(wanted).any(begins)
    };
    let in_sentences = || {
        wanted.chars().count() >= FOR_SENTENCES
            && !wanted.contains('_')
            && [parameter.meaning, parameter.sign, parameter.origin].into_iter().any(begins_a_word)
    };
    [parameter.symbol, shown]
        .iter()
        .any(|symbol| condensed(&Symbol::parse(symbol).plain()).contains(&letters))
        || condensed(parameter.key).contains(&letters)
        || parameter.name.to_lowercase().contains(wanted)
        || in_sentences()
}

/// What is searched for where the equations are wanted, condensed.
const EQUATIONS: [&str; 4] = ["equations", "matrices", "characteristicpolynomial", "eigenvalues"];

/// Where the equations are, if it is them that is searched for.
pub fn equations(search: &str) -> Option<&'static str> {
    let wanted = search.trim().to_lowercase();
    let is_long = wanted.chars().count() >= FOR_SENTENCES;
    let is_meant = is_long && EQUATIONS.iter().any(|word| word.starts_with(&wanted.replace(' ', "")));
    is_meant.then_some(words::sliders::EQUATIONS)
}

/// Where else the search would find something: the page and the plane of the first slider that it finds.
pub fn elsewhere(scenario: &Scenario, page: Page, filter: Filter<'_>) -> Option<String> {
    let other = match scenario.plane {
        Plane::Longitudinal => Plane::Lateral,
        Plane::Lateral => Plane::Longitudinal,
    };
    let turned = Scenario { plane: other, ..scenario.clone() };
    let first = |scenario: &Scenario, page: Page| parameters().find(|p| is_listed(p, scenario, page, filter));
    let on_page = |page: Page| first(scenario, page).map(|p| (p, words::sliders::page(page)));
    let in_plane = |page: Page| first(&turned, page).map(|p| (p, words::view::plane(other)));
    let found = in_plane(page)
        .or_else(|| Page::ALL.into_iter().find_map(on_page))
        .or_else(|| Page::ALL.into_iter().find_map(in_plane));
    found.map(|(p, place)| words::sliders::elsewhere(p.name, place))
}
