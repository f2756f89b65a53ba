//! The equations ẋ = A x + B δ: both matrices, the chosen row in words, the characteristic polynomial. Beside the sliders of their
//! entries, or alone and large for a room.

mod formula;
mod matrix;

use egui::{Button, Color32, ComboBox, Label, RichText, TextFormat, Ui};

use self::formula::{Writing, factor, polynomial};
use self::matrix::{Matrices, NOWHERE, Picked, Place, matrices_ui};
use super::curtain::Curtain;
use super::feedback::without_law_ui;
use super::keys::notation_ui;
use super::symbol::{Symbol, prose};
use super::theme::{self, Palette};
use crate::findings::{Equations, Findings};
use crate::flight::modes::mode::Mode;
use crate::flight::modes::sensitivity::REPEATED_CONDITION;
use crate::key::Keyed as _;
use crate::number::trimmed;
use crate::scenario::view::{Entries, EquationsView};
use crate::scenario::{Hidden, Lock, Notation, Parameter};
use crate::words;

/// Significant digits of an entry where there is little room, and where it is alone in much.
const DIGITS: [usize; 2] = [3, 4];
/// Of the equations alone, smallest and largest type over that of the page, and the width and height that have the type of the page \[points\].
const LARGER: [f32; 2] = [1.0, 2.2];
const USUAL_WIDTH: f32 = 480.0;
const USUAL_HEIGHT: f32 = 270.0;

/// Where the equations stand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Size {
    /// Beside the sliders of their entries.
    Beside,
    /// Alone, for a room.
    Alone,
}

/// What a person asked for.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Wish {
    /// The slider of the entry that the pointer is over.
    pub touched: Option<&'static str>,
    /// The slider to go to.
    pub asked: Option<&'static Parameter>,
    /// Whether the equations are to stand alone.
    pub enlarge: bool,
    /// The notation to go on in.
    pub notation: Option<Notation>,
}

/// The equations as a person reads them.
#[derive(Debug, Default)]
pub struct EquationsPane {
    /// The entry at hand; its row is said in words.
    chosen: Place,
}

impl EquationsPane {
    /// Draws the equations of the plane on screen; whether they lead to sliders depends on whether there are any.
    pub fn show(
        &mut self,
        ui: &mut Ui,
        findings: &Findings,
        view: &mut EquationsView,
        (size, leads): (Size, bool),
    ) -> Wish {
        let mut wish = Wish::default();
        let Some(equations) = findings.equations() else { return wish };
        let modes = findings.modes();
        let curtain = Curtain::of(ui);
        let mut notation = equations.convention.notation;
        let choosers = |ui: &mut Ui| choosers_ui(ui, equations, modes, (view, &mut notation), size);
        without_law_ui(ui, findings);
        // A room has nothing to choose, and reads what is large.
        let is_for_a_room = theme::is_for_a_room(ui);
        if !is_for_a_room {
            wish.enlarge = curtain.lock_ui(ui, Lock::View, choosers);
            wish.notation = (notation != equations.convention.notation).then_some(notation);
        }
        let coloured = view.coloured.filter(|_| !curtain.hides_influence());
        let mode = coloured.and_then(|index| Some((index, modes.get(index)?)));
        let writing = Writing {
            equations,
            entries: view.entries,
            digits: DIGITS[usize::from(size == Size::Alone && ui.available_width() >= USUAL_WIDTH)],
        };
        let matrices = Matrices {
            writing,
            mode: mode
                .map(|(index, mode)| (index, mode.naming.name, curtain.in_a_sentence(mode.naming.name))),
            chosen: if is_for_a_room { NOWHERE } else { self.chosen },
            is_large: size == Size::Alone,
            by_finger: theme::is_for_fingers(ui),
        };
        let Picked { chosen, hovered, asked, .. } = matrices_ui(ui, matrices);
        self.chosen = chosen.unwrap_or(self.chosen);
        let slider = |(row, column): Place| equations.slider(row, column).map(|(parameter, _)| parameter);
        wish.touched = hovered.and_then(slider).map(|parameter| parameter.key);
        wish.asked = asked.filter(|_| leads).and_then(slider);
        let larger = enlargement(ui, size);
        // Before a room, no more than there is room for.
        let room = 4.0 * 1.35 * larger * theme::sizes(ui).symbol;
        let has_room = !is_for_a_room || ui.available_height() >= room;
        if let Some((_, mode)) = mode.filter(|_| has_room) {
            // Once understood it needs no large type.
            small_ui(ui, &legend(&curtain, mode), larger.min(1.3));
        }
        if !is_for_a_room {
            let of_derivative = self.row_ui(ui, findings, &writing, (larger, leads));
            wish.asked = of_derivative.or(wish.asked);
        }
        // As small as it would be beside the matrix, no room reads it.
        if !curtain.hides(Hidden::Numbers) && !is_for_a_room {
            polynomial_ui(ui, equations, modes, larger);
        }
        wish
    }

    /// The chosen row in words and as an equation, and what the entry at hand is made of. Gives the derivative that is asked for.
    fn row_ui(
        &self,
        ui: &mut Ui,
        findings: &Findings,
        writing: &Writing<'_>,
        (larger, leads): (f32, bool),
    ) -> Option<&'static Parameter> {
        let (equations, palette) = (writing.equations, Palette::of(ui));
        let (row, column) = self.chosen;
        ui.add_space(4.0);
        let title = words::equations::row(equations.plane, row);
        ui.label(prose(title, theme::semibold(larger * theme::sizes(ui).value), palette.text));
        ui.label(Symbol::parse(&writing.row(row)).job(larger * theme::sizes(ui).symbol, palette.text));
        let Some(full) = writing.full(row, column) else {
            small_ui(ui, words::equations::ONLY_NUMBERS, larger);
            return None;
        };
        let mut asked = None;
        ui.horizontal_wrapped(|ui| {
            ui.spacing_mut().item_spacing.x = 4.0;
            theme::make_low(ui, 18.0);
            let (number, unit) = writing.number(row, column);
            // A symbol is what it stands for before anything is added.
            let made_of = full.strip_suffix(" + Δ").unwrap_or(&full);
            let symbol = writing.symbol(row, column).filter(|symbol| symbol != made_of);
            let symbol = symbol.map_or_else(String::new, |symbol| format!("{symbol} = "));
            let text = format!("{symbol}{full} = {number}");
            let mut job = Symbol::parse(&text).job(larger * theme::sizes(ui).inline_symbol, palette.text);
            let font = egui::FontId::proportional(larger * theme::sizes(ui).small);
            job.append(unit, 3.0, TextFormat::simple(font, palette.weak));
            ui.add(Label::new(job).extend());
            let derivatives = if leads { equations.derivatives(row, column) } else { Vec::new() };
            if !derivatives.is_empty() {
                let font = egui::FontId::proportional(larger * theme::sizes(ui).small);
                let words = RichText::new(words::equations::TO_SLIDERS).font(font).color(palette.weak);
                ui.add(Label::new(words).extend());
            }
            for parameter in derivatives {
                let symbol = Symbol::parse(parameter.written(equations.convention).symbol);
                let job = symbol.job(larger * theme::sizes(ui).inline_symbol, palette.link());
                let name = format!("To the slider of {} {}", parameter.name, symbol.plain());
                let button = theme::bare_button(ui, true, Button::new(job)).accessible_name(name);
                if button.on_hover_text(parameter.name).clicked() {
                    asked = Some(parameter);
                }
            }
        });
        if writing.entries == Entries::Full {
            let scenario = findings.scenario();
            let definition = |atom: crate::findings::equations::Atom| {
                let value = trimmed(equations.atom(scenario, atom)?, 4);
                Some(format!("{} = {value}", atom.definition(equations.convention.notation)?))
            };
            let mut definitions: Vec<String> =
                writing.definitions().into_iter().filter_map(definition).collect();
            let in_si = equations.dimension(row, column).in_si(equations.convention.length);
            let added = equations.added(row, column) / in_si;
            if added != 0.0 {
                definitions.push(words::equations::added(&trimmed(added, 4)));
            }
            if !definitions.is_empty() {
                let text = definitions.join(",  ");
                ui.label(Symbol::parse(&text).job(larger * theme::sizes(ui).inline_symbol, palette.weak));
            }
        }
        asked
    }
}

/// How much larger than on the rest of the page words and formulas are.
fn enlargement(ui: &Ui, size: Size) -> f32 {
    match size {
        Size::Beside => 1.0,
        Size::Alone => {
            let [across, down] = [ui.available_width() / USUAL_WIDTH, ui.clip_rect().height() / USUAL_HEIGHT];
            across.min(down).clamp(LARGER[0], LARGER[1])
        }
    }
}

fn small_ui(ui: &mut Ui, text: &str, larger: f32) {
    let font = egui::FontId::proportional(larger * theme::sizes(ui).small);
    ui.label(RichText::new(text).font(font).color(Palette::of(ui).weak));
}

fn legend(curtain: &Curtain, mode: &Mode) -> String {
    if mode.condition > REPEATED_CONDITION {
        words::equations::NO_RATE.to_owned()
    } else {
        words::equations::legend(curtain.in_a_sentence(mode.naming.name))
    }
}

/// As what entries stand, in which notation, the mode that colours them, and the way to large type. Says whether that is asked for.
fn choosers_ui(
    ui: &mut Ui,
    equations: &Equations,
    modes: &[Mode],
    (view, notation): (&mut EquationsView, &mut Notation),
    size: Size,
) -> bool {
    let mut enlarge = false;
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().button_padding.x = 6.0;
        ui.spacing_mut().item_spacing.x = 3.0;
        let small = |text: &str| RichText::new(text).font(theme::small());
        let has_forms = equations.form(0, 0).is_some();
        ui.add_enabled_ui(has_forms, |ui| {
            for &entries in Entries::VALUES {
                // Of bare matrices there are numbers only, whatever is chosen for others.
                let is_on = if has_forms { view.entries } else { Entries::Numbers } == entries;
                let button = Button::selectable(is_on, small(words::view::entries(entries)));
                let name = words::view::entries_in_words(entries);
                let response = ui.add(button).accessible_name(name);
                if response
                    .on_hover_text(name)
                    .on_disabled_hover_text(words::equations::ONLY_NUMBERS)
                    .clicked()
                {
                    view.entries = entries;
                }
            }
        });
        ui.separator();
        notation_ui(ui, notation, &theme::small());
        if !Curtain::of(ui).hides_influence() {
            coloured_ui(ui, modes, view, size);
        }
        if size == Size::Beside {
            let button = Button::selectable(false, "□");
            let name = words::view::maximise(crate::scenario::view::Pane::Equations);
            enlarge = ui.add(button).accessible_name(name).on_hover_text(name).clicked();
        }
    });
    enlarge
}

/// The mode that colours the entries.
fn coloured_ui(ui: &mut Ui, modes: &[Mode], view: &mut EquationsView, size: Size) {
    let curtain = Curtain::of(ui);
    let title = |mode: &Mode| curtain.title(mode.naming.name);
    let chosen = view.coloured.and_then(|index| modes.get(index)).map_or(words::equations::NO_MODE, title);
    let chooser = ComboBox::from_id_salt(("coloured", size == Size::Alone))
        .selected_text(RichText::new(chosen).font(theme::small()));
    let chooser = chooser.show_ui(ui, |ui| {
        for index in curtain.order(modes) {
            ui.selectable_value(&mut view.coloured, Some(index), title(&modes[index]));
        }
        ui.selectable_value(&mut view.coloured, None, words::equations::NO_MODE);
    });
    theme::name_chooser(chooser, words::equations::COLOURED_BY, chosen)
        .on_hover_text("The mode by whose sensitivity the entries are coloured");
}

/// The characteristic polynomial, and its factors in the colours of their modes, none of them broken.
fn polynomial_ui(ui: &mut Ui, equations: &Equations, modes: &[Mode], larger: f32) {
    let palette = Palette::of(ui);
    let of_type = larger * theme::sizes(ui).symbol;
    ui.add_space(4.0);
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing.x = 0.35 * of_type;
        ui.spacing_mut().item_spacing.y = 0.0;
        ui.spacing_mut().interact_size.y = 0.0;
        let whole = format!("{} =", polynomial(equations));
        let formula = |ui: &mut Ui, text: &str, color: Color32| {
            let label = Label::new(Symbol::parse(text).job(of_type, color));
            ui.add(label.extend()).on_hover_text(words::equations::POLYNOMIAL);
        };
        formula(ui, &whole, palette.text);
        for index in Curtain::of(ui).order(modes) {
            if let (Some(of_mode), Some(mode)) = (equations.factors.get(index), modes.get(index)) {
                formula(ui, &factor(*of_mode), palette.mode_text(mode.naming.name));
            }
        }
    });
}
