//! A question for a place on the pole map: a mark that is put there by mouse, finger, arrow keys or two numbers.

use egui::{Rect, Sense, Stroke, Ui, WidgetInfo, accesskit::Role};
use nalgebra::Complex;

use super::pad;
use super::text::Context;
use crate::flight::modes::mode::Mode;
use crate::flight::modes::mode_name::ModeName;
use crate::lesson::{Answer, Given, Truth};
use crate::number::{eigenvalue, round_up, significant};
use crate::scenario::ValueError;
use crate::ui::chart::{Chart, Pattern, Primitive, View, paint};
use crate::ui::number_field::number_field_ui;
use crate::ui::poles::{both, cross};
use crate::ui::theme::{self, Palette};
use crate::ui::{arrow_keys, finger};
use crate::words;

/// Height of the pad.
const HEIGHT: f32 = 230.0;
/// An arrow key moves the mark by this part of the height.
const FINE: f64 = 1.0 / 80.0;
/// Half the size of the mark.
const MARK: f32 = 7.0;

/// Draws the map; once the answer is final, with the pole and a line to it. `moves` says whether the pole asked for is that of another
/// scene than the step's, so that where it is now gives nothing away.
pub fn place_ui(
    ui: &mut Ui,
    mode: ModeName,
    moves: bool,
    given: &mut Given,
    truth: Option<&Truth>,
    context: Context<'_>,
) {
    let palette = Palette::of(ui);
    let Some(Truth::Pole(pole)) = truth else { return };
    let poles = context.start.flown_modes();
    let before = poles.iter().find(|found| found.naming.name == mode).filter(|_| moves);
    let (rect, response) =
        pad::room(ui, HEIGHT, if given.is_final { Sense::HOVER } else { Sense::click_and_drag() });
    let chart = Chart { rect, view: view(*pole, before.map(|mode| mode.lambda)).shaped(rect) };
    let zero = chart.position(Complex::default()).x;
    let stable = Rect::from_x_y_ranges(rect.left()..=zero, rect.y_range());
    let unstable = Rect::from_x_y_ranges(zero..=rect.right(), rect.y_range());
    let grounds = [(stable, palette.stable_half), (unstable, palette.unstable_half)];
    let grounds = grounds.map(|(rect, color)| Primitive::Rectangle(rect, color)).to_vec();
    pad::axes(ui, &chart, grounds, ("Im λ", "rad/s"), ("Re λ", "1/s"));
    if !given.is_final {
        let mut mark = marked(given);
        if finger::works_on(ui, &response)
            && (response.dragged() || response.clicked())
            && let Some(at) = response.interact_pointer_pos()
        {
            response.request_focus();
            mark = Some(chart.at(at.clamp(rect.min, rect.max)).into());
        }
        if response.has_focus() {
            arrow_keys::keep(ui, &response);
            let step = FINE * (chart.view.top - chart.view.bottom);
            let (right, up) = pad::arrows(ui);
            if (right, up) != (0.0, 0.0) {
                // From the middle of the stable half, where no mark stands yet.
                let from = mark.unwrap_or(Complex::new(0.5 * chart.view.left, 0.0));
                mark = Some(from + Complex::new(right, up) * step);
            }
        }
        pad::focus(ui, &response);
        set(given, mark);
    }
    let mark = marked(given);
    let name = mark.map_or_else(|| "none yet".to_owned(), |mark| format!("{} 1/s", eigenvalue(mark)));
    let name = format!("Your {} pole: {name}", words::mode::in_a_sentence(mode));
    response.widget_info(|| WidgetInfo::labeled(Role::Button, !given.is_final, name.as_str()));
    ui.ctx().accesskit_node_builder(response.id, |node| {
        node.set_description("Arrow keys move it, with Shift further.");
    });
    let others: Vec<&Mode> = poles.iter().filter(|found| found.naming.name != mode).collect();
    draw(ui, &chart, palette, &others, before, mark, given.is_final.then_some((mode, *pole)));
    if given.is_final {
        outcome_ui(ui, mode, mark, *pole, before.is_some());
    } else {
        numbers_ui(ui, given);
    }
}

/// The mark, by the pole of a pair with the positive imaginary part.
fn marked(given: &Given) -> Option<Complex<f64>> {
    match given.answer {
        Some(Answer::Place { real, imaginary }) => Some(Complex::new(real, imaginary)),
        _ => None,
    }
}

fn set(given: &mut Given, mark: Option<Complex<f64>>) {
    if let Some(mark) = mark.filter(|mark| mark.re.is_finite() && mark.im.is_finite()) {
        given.answer = Some(Answer::Place { real: mark.re, imaginary: mark.im.abs() });
    }
}

/// What the map shows: enough for both poles, in round numbers that give neither away.
fn view(pole: Complex<f64>, before: Option<Complex<f64>>) -> View {
    let reach = pole.norm().max(before.map_or(0.0, Complex::norm)).max(1e-3);
    let reach = round_up(1.4 * reach);
    // A third of it is the unstable half.
    View { left: -1.4 * reach, right: 0.7 * reach, bottom: -reach, top: reach }
}

fn draw(
    ui: &Ui,
    chart: &Chart,
    palette: &Palette,
    others: &[&Mode],
    before: Option<&Mode>,
    mark: Option<Complex<f64>>,
    truth: Option<(ModeName, Complex<f64>)>,
) {
    let painter = ui.painter_at(chart.rect);
    for other in others {
        both(other.lambda, |pole| {
            cross(&painter, chart.position(pole), MARK - 2.0, 1.5, palette.mode(other.naming.name));
        });
    }
    if let Some(before) = before {
        both(before.lambda, |pole| {
            painter.circle_stroke(chart.position(pole), 5.0, Stroke::new(1.5, palette.pinned));
        });
    }
    if let (Some(mark), Some((_, pole))) = (mark, truth) {
        let stroke = Stroke::new(1.2, palette.weak);
        let ends = [(mark, pole), (mark.conj(), pole.conj())];
        let lines = ends.map(|(from, to)| {
            Primitive::line([chart.position(from), chart.position(to)], stroke, Pattern::Dashed)
        });
        paint(&painter, lines.to_vec());
    }
    if let Some(mark) = mark {
        both(mark, |mark| {
            let at = chart.position(mark);
            painter.circle_filled(at, MARK, palette.pane);
            painter.circle_stroke(at, MARK, Stroke::new(2.2, palette.accent));
            painter.circle_filled(at, 2.2, palette.accent);
        });
    }
    if let Some((name, pole)) = truth {
        both(pole, |pole| cross(&painter, chart.position(pole), MARK + 1.0, 2.6, palette.mode(name)));
    }
}

/// What each mark is, with its number.
fn outcome_ui(ui: &mut Ui, mode: ModeName, mark: Option<Complex<f64>>, pole: Complex<f64>, moves: bool) {
    let yours = mark.map(|mark| format!("Your mark, the ring with a dot: {} 1/s.", eigenvalue(mark)));
    let found = format!("The {}, a cross: {} 1/s.", words::mode::in_a_sentence(mode), eigenvalue(pole));
    let before = moves.then(|| "An empty ring: where it was before.".to_owned());
    for sentence in yours.into_iter().chain([found]).chain(before) {
        ui.label(egui::RichText::new(sentence).font(theme::small()));
    }
}

/// The same as two numbers, which can be typed.
fn numbers_ui(ui: &mut Ui, given: &mut Given) {
    let mark = marked(given);
    let mut typed = [None, None];
    let mut refusal = None;
    ui.horizontal_wrapped(|ui| {
        let parts =
            [("Re λ", "Real part of your pole", "1/s"), ("± Im λ", "Imaginary part of your pole", "rad/s")];
        for (number, (symbol, name, unit)) in parts.into_iter().enumerate() {
            ui.label(symbol);
            let shown = mark.map_or_else(String::new, |mark| significant([mark.re, mark.im][number], 3));
            let id = ui.scope_id().with(name);
            let field = number_field_ui(ui, id, name, &shown, (64.0, theme::sizes(ui).name), read);
            ui.label(unit);
            typed[number] = field.accepted;
            refusal = field.refusal.or(refusal.take());
        }
    });
    if let Some(refusal) = refusal {
        refusal.show(ui);
    }
    if typed != [None, None] {
        let from = mark.unwrap_or_default();
        set(given, Some(Complex::new(typed[0].unwrap_or(from.re), typed[1].unwrap_or(from.im))));
    }
}

/// A number as people write it: with a decimal comma or point, and any minus.
pub fn read(text: &str) -> Result<f64, ValueError> {
    let number = text.trim().replace(',', ".").replace('−', "-").parse::<f64>();
    let number = number.map_err(|_| ValueError::NotANumber(text.trim().to_owned()))?;
    if number.is_finite() { Ok(number) } else { Err(ValueError::NotFinite) }
}
