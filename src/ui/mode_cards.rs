//! A card for each mode, and the two verdicts above them.

use egui::{
    Align, Button, Color32, Frame, Id, Layout, Margin, Rect, Response, RichText, Stroke, Ui, Vec2,
    WidgetText, style::ScrollAnimation,
};

use super::copy;
use super::curtain::Curtain;
use super::phasors::phasors_ui;
use super::symbol::{Symbol, prose, symbol_ui};
use super::theme::{self, Palette};
use super::why::Why;
use crate::flight::aircraft::plane::Plane;
use crate::flight::aircraft::states::Lateral;
use crate::flight::analysis::{Margins, PlaneAnalysis};
use crate::flight::feedback::closed_model::ClosedModel;
use crate::flight::feedback::loop_modes::LoopMode;
use crate::flight::modes::approximations::Approximation;
use crate::flight::modes::mode::Mode;
use crate::flight::modes::mode_name::ModeName;
use crate::flight::modes::stability::Stability;
use crate::flight::verdicts::handling_qualities::{Level, Verdict};
use crate::flight::verdicts::task::Task;
use crate::key::Keyed as _;
use crate::number::{eigenvalue, significant};
use crate::scenario::view::Details;
use crate::scenario::{Convention, Hidden, Lock, Notation};
use crate::words;

/// The verdicts: dynamic, then static, each with its numbers where they aren't hidden.
pub fn verdicts_ui(ui: &mut Ui, plane: &PlaneAnalysis, margins: Option<Margins>, convention: Convention) {
    let curtain = Curtain::of(ui);
    if curtain.hides(Hidden::Verdicts) {
        return;
    }
    let is_brief = curtain.hides_sentences();
    let sentence = if is_brief {
        words::stability::dynamic_alone(plane).to_owned()
    } else {
        words::stability::dynamic_sentence(plane)
    };
    verdict_ui(ui, &sentence, plane.dynamic_stability).on_hover_text(words::stability::DYNAMIC_MEANING);
    let of_static = &plane.static_stability;
    // Amber where the stiffness points back and a real root grows all the same through the terms of speed.
    let tone = match (of_static.verdict, of_static.of_determinant) {
        (Stability::Stable, Stability::Unstable) if plane.model.plane == Plane::Longitudinal => {
            Stability::Neutral
        }
        (verdict, _) => verdict,
    };
    if is_brief {
        verdict_ui(ui, words::stability::static_alone(plane), tone);
    } else {
        verdict_ui(ui, &words::stability::static_sentence(plane, margins, convention), tone)
            .on_hover_text(words::stability::static_meaning(of_static, convention.notation));
    }
}

fn verdict_ui(ui: &mut Ui, text: &str, stability: Stability) -> Response {
    let (color, ground) = Palette::of(ui).verdict(stability);
    banner_ui(ui, text, color, ground)
}

/// A sentence on coloured ground, as wide as there is room.
pub fn banner_ui(ui: &mut Ui, text: &str, color: Color32, ground: Color32) -> Response {
    let frame = Frame::new().fill(ground).corner_radius(8).inner_margin(Margin::symmetric(10, 7));
    let banner = frame.show(ui, |ui| {
        ui.set_width(ui.available_width());
        ui.label(prose(text, theme::semibold(theme::sizes(ui).value), color))
    });
    banner.inner
}

/// One mode with what belongs on its card.
#[derive(Clone, Copy, Debug)]
pub struct Card<'a> {
    /// The plane that it is a mode of.
    pub plane: &'a PlaneAnalysis,
    /// The mode.
    pub mode: &'a Mode,
    /// The same with every state, where a law flies, and the states beside the four.
    pub whole: Option<(&'a LoopMode, &'a ClosedModel)>,
    /// The same mode of the pinned state.
    pub before: Option<&'a Mode>,
    /// Whether it is being flown alone.
    pub flown: bool,
    /// The notation of formulas.
    pub notation: Notation,
}

/// Draws a mode's card. Says whether the person asked to fly it alone, or to stop.
pub fn card_ui(ui: &mut Ui, card: Card<'_>, details: &mut Details, why: &mut Why) -> bool {
    let Card { plane, mode, before, .. } = card;
    let palette = Palette::of(ui);
    let curtain = Curtain::of(ui);
    let color = palette.mode(mode.naming.name);
    let mut fly = false;
    let frame = Frame::new()
        .fill(palette.pane)
        .stroke(Stroke::new(1.0, palette.hairline))
        .corner_radius(8)
        .inner_margin(Margin { left: 15, right: 10, top: 8, bottom: 9 })
        .show(ui, |ui| {
            ui.set_width(ui.available_width());
            theme::make_low(ui, 19.0);
            title_ui(ui, plane, mode, details);
            numbers_ui(ui, mode);
            if !curtain.hides_any(&[Hidden::Reasons, Hidden::Numbers]) {
                participation_ui(ui, plane.model.plane, card);
            }
            if !curtain.hides_influence() {
                ui.label(RichText::new(words::naming::reason(mode)).font(theme::small()).color(palette.weak));
            }
            if let Some(before) = before.filter(|_| !curtain.hides(Hidden::Numbers)) {
                ui.label(RichText::new(change(before, mode)).font(theme::small()).color(palette.text));
            }
            why.show(ui, mode.naming.name);
            fly = buttons_ui(ui, card, details);
            if details.shape && offers_shape(&curtain) {
                phasors_ui(ui, &plane.model, mode, color);
            }
            if details.levels && tells_levels(&curtain) {
                levels_ui(ui, plane, mode);
            }
            if details.approximations && !curtain.hides_influence() {
                approximations_ui(ui, card);
            }
        });
    let rect = frame.response.rect;
    copy::offer(ui, rect, &|| {
        format!("{}: {}", words::mode::title(mode.naming.name), words::mode::numbers(mode))
    });
    let bar = Rect::from_min_size(rect.min, Vec2::new(4.0, rect.height()));
    ui.painter().rect_filled(bar, egui::CornerRadius { nw: 8, sw: 8, ne: 0, se: 0 }, color);
    fly
}

/// Whether the shape of a mode is shown: it is what the mode is made of, and in numbers.
fn offers_shape(curtain: &Curtain) -> bool {
    !curtain.hides_any(&[Hidden::Reasons, Hidden::Numbers])
}

/// Whether it is told what sets a level: it names the mode, and has its numbers.
fn tells_levels(curtain: &Curtain) -> bool {
    !curtain.hides(Hidden::Levels) && !curtain.hides_sentences()
}

/// The name with its chips at the right, or below it where they would lie on it.
fn title_ui(ui: &mut Ui, plane: &PlaneAnalysis, mode: &Mode, details: &mut Details) {
    let color = Palette::of(ui).mode_text(mode.naming.name);
    let curtain = Curtain::of(ui);
    let (name, font) = (curtain.title(mode.naming.name), theme::semibold(theme::sizes(ui).card));
    let chip = |text: String| {
        let font = theme::semibold(theme::sizes(ui).chip);
        ui.painter().layout_no_wrap(text, font, color).size().x
            + 2.0 * CHIP_MARGIN
            + ui.spacing().item_spacing.x
    };
    let chips: f32 = chip_texts(&curtain, plane, mode, *details).into_iter().flatten().map(chip).sum();
    let room = ui.available_width() - chips;
    let name_width = ui.painter().layout_no_wrap(name.to_owned(), font.clone(), color).size().x;
    let name = RichText::new(name).font(font).color(color);
    if name_width + ui.spacing().item_spacing.x <= room {
        ui.horizontal(|ui| {
            theme::heading(ui, name, 3);
            // At the right, and in the same order as below a name.
            ui.add_space(room - name_width - ui.spacing().item_spacing.x);
            chips_ui(ui, plane, mode, details);
        });
    } else {
        theme::heading(ui, name, 3);
        ui.horizontal(|ui| chips_ui(ui, plane, mode, details));
    }
}

/// Keeps a button where it is on screen when it opens something on every card: those above grow too, and push it down.
pub(super) fn hold_place(ui: &Ui, button: &Response, mode: ModeName, detail: &str) {
    let id = Id::unique(("held in place", mode.key(), detail));
    if button.clicked() {
        ui.data_mut(|data| data.insert_temp(id, button.rect.top()));
        ui.request_repaint();
    } else if let Some(top) = ui.data_mut(|data| data.remove_temp::<f32>(id))
        && top != button.rect.top()
    {
        let moved = Vec2::new(0.0, top - button.rect.top());
        ui.scroll_with_delta_animation(moved, ScrollAnimation::none());
        ui.request_discard("a card has been scrolled to where it was");
    }
}

/// What can be done with a mode and seen of it. Says whether it is to be flown alone, or no longer.
fn buttons_ui(ui: &mut Ui, card: Card<'_>, details: &mut Details) -> bool {
    let Card { mode, flown, .. } = card;
    let curtain = Curtain::of(ui);
    let name = curtain.in_a_sentence(mode.naming.name);
    let mut fly = false;
    ui.horizontal_wrapped(|ui| {
        // So that all three stand in one row of a card as a rule.
        ui.spacing_mut().button_padding = Vec2::new(5.0, 3.0);
        ui.spacing_mut().item_spacing.x = 5.0;
        let text = |text: &str| RichText::new(text).font(theme::small());
        let button = ui.add_enabled(
            !curtain.locks(Lock::Disturbance),
            Button::selectable(flown, text(if flown { "Flying alone" } else { "Fly this mode" }))
                .frame_when_inactive(true),
        );
        fly = button
            .accessible_name(if flown {
                format!("Stop flying the {name} alone")
            } else {
                format!("Fly the {name} alone")
            })
            .on_hover_text("Let the aircraft go in the shape of this mode: then nothing else moves")
            .on_disabled_hover_text(words::view::LOCKED)
            .clicked();
        let toggle =
            |ui: &mut Ui, on: &mut bool, words: &str, (detail, what): (&str, &str), hover: WidgetText| {
                let button = Button::selectable(*on, text(words)).frame_when_inactive(true);
                let response = ui.add(button).accessible_name(format!("{what} of the {name}"));
                hold_place(ui, &response, mode.naming.name, detail);
                if response.on_hover_text(hover).clicked() {
                    *on = !*on;
                }
            };
        if offers_shape(&curtain) {
            toggle(
                ui,
                &mut details.shape,
                "Shape",
                ("shape", "Shape"),
                "How large each quantity is in this mode, and how far ahead or behind it swings".into(),
            );
        }
        if let Some((text, hover)) = approximation_button(card).filter(|_| !curtain.hides_influence()) {
            toggle(
                ui,
                &mut details.approximations,
                &text,
                ("approximations", "Approximations"),
                prose(&hover, theme::body(), Palette::of(ui).text).into(),
            );
        }
    });
    fly
}

/// The textbook approximations of a mode.
fn approximations<'a>(plane: &'a PlaneAnalysis, mode: &Mode) -> impl Iterator<Item = &'a Approximation> {
    let name = mode.naming.name;
    plane.approximations.iter().filter(move |approximation| approximation.name.concerns() == name)
}

/// The button of the approximations, with the error of the first, and what it says on hover.
fn approximation_button(Card { plane, mode, whole, notation, .. }: Card<'_>) -> Option<(String, String)> {
    let first = approximations(plane, mode).next()?;
    let text = match first.error() {
        // Its error is beside the aircraft alone, not beside this mode.
        _ if whole.is_some_and(|(_, closed)| closed.is_fed_back()) => "Approx., open loop".to_owned(),
        Some(error) if error.abs() <= words::approximation::BEYOND_USE => {
            format!("Approx. {}", words::approximation::signed_percent(error))
        }
        Some(_) | None => "Approx. fails".to_owned(),
    };
    let hover = format!(
        "{}. {}\nLeaves out: {}\nPress to see all that the textbooks give.",
        words::approximation::values(first, notation),
        words::approximation::formula(first.name, notation),
        words::approximation::neglects(first.name, notation)
    );
    Some((text, hover))
}

/// Size of the text on a chip, and the room left and right of it.
const CHIP_MARGIN: f32 = 7.0;

/// What stands where a level would, where there is none.
const NO_LEVEL: &str = "no level";

/// Whether it dies away, and the level of handling qualities where there is one.
fn chip_texts(
    curtain: &Curtain,
    plane: &PlaneAnalysis,
    mode: &Mode,
    details: Details,
) -> [Option<String>; 2] {
    let stability = match mode.stability {
        Stability::Stable => "stable",
        Stability::Neutral => "neutral",
        Stability::Unstable => "unstable",
    };
    let mark = match (tells_levels(curtain), details.levels) {
        (false, _) => "",
        (true, true) => " ▾",
        (true, false) => " ▸",
    };
    let level = match worst(plane, mode) {
        Some((level, task)) => {
            Some(format!("{} · Cat {}{mark}", words::verdict::level(level), task.category.letter()))
        }
        None => (!plane.levels.is_empty()).then(|| NO_LEVEL.to_owned()),
    };
    [
        Some(stability.to_owned()).filter(|_| !curtain.hides(Hidden::Verdicts)),
        level.filter(|_| !curtain.hides(Hidden::Levels)),
    ]
}

/// The worst level that a mode has, and the task that it is judged for.
fn worst(plane: &PlaneAnalysis, mode: &Mode) -> Option<(Level, Task)> {
    judged(plane, mode).filter_map(|verdict| Some((verdict.level?, verdict.task))).max_by_key(|worst| worst.0)
}

fn chips_ui(ui: &mut Ui, plane: &PlaneAnalysis, mode: &Mode, details: &mut Details) {
    let curtain = Curtain::of(ui);
    let [stability, level_text] = chip_texts(&curtain, plane, mode, *details);
    if let Some(stability) = stability {
        chip_ui(ui, stability, Palette::of(ui).verdict(mode.stability));
    }
    let Some(level_text) = level_text else { return };
    if let Some((level, task)) = worst(plane, mode) {
        let (color, ground) = Palette::of(ui).verdict(tone(level));
        if !tells_levels(&curtain) {
            return chip_ui(ui, level_text, (color, ground));
        }
        let text = RichText::new(level_text).font(theme::semibold(theme::sizes(ui).chip)).color(color);
        ui.spacing_mut().button_padding = Vec2::new(CHIP_MARGIN, 2.0);
        let chip = ui.add(Button::new(text).fill(ground).stroke(Stroke::NONE).corner_radius(7));
        theme::focus_ring(ui, &chip);
        let chip = chip.accessible_name(format!("Level of the {}", curtain.in_a_sentence(mode.naming.name)));
        hold_place(ui, &chip, mode.naming.name, "levels");
        let hover = format!(
            "{}. {}. Press to see which paragraphs of MIL-F-8785C set the level.",
            words::verdict::class_with_aircraft(task.class),
            words::verdict::category_with_phases(task.category)
        );
        if chip.on_hover_text(hover).clicked() {
            details.levels = !details.levels;
        }
    } else {
        let text = RichText::new(level_text).font(theme::small()).color(Palette::of(ui).weak);
        if !tells_levels(&curtain) {
            ui.label(text);
            return;
        }
        let hover = judged(plane, mode).next().map_or_else(
            || "MIL-F-8785C has no requirement on a mode of this kind.".to_owned(),
            words::verdict::sentence,
        );
        ui.label(text).on_hover_text(hover);
    }
}

fn chip_ui(ui: &mut Ui, text: String, (color, ground): (Color32, Color32)) {
    Frame::new().fill(ground).corner_radius(7).inner_margin(Margin::symmetric(CHIP_MARGIN as i8, 2)).show(
        ui,
        |ui| {
            ui.label(RichText::new(text).font(theme::semibold(theme::sizes(ui).chip)).color(color));
        },
    );
}

/// The colour of a level, as that of a verdict on stability.
pub const fn tone(level: Level) -> Stability {
    match level {
        Level::One => Stability::Stable,
        Level::Two => Stability::Neutral,
        Level::Three | Level::Beyond => Stability::Unstable,
    }
}

/// The verdicts on handling qualities that concern a mode.
fn judged<'a>(plane: &'a PlaneAnalysis, mode: &Mode) -> impl Iterator<Item = &'a Verdict> {
    let name = mode.naming.name;
    plane.levels.iter().filter(move |verdict| verdict.modes.contains(&name))
}

fn levels_ui(ui: &mut Ui, plane: &PlaneAnalysis, mode: &Mode) {
    for verdict in judged(plane, mode) {
        ui.label(RichText::new(words::verdict::sentence(verdict)).font(theme::small()));
    }
}

/// For each textbook approximation its formula and what it gives beside the exact value, and on hover what it leaves out.
fn approximations_ui(ui: &mut Ui, Card { plane, mode, whole, notation, .. }: Card<'_>) {
    let palette = Palette::of(ui);
    if let Some((_, closed)) = whole
        && closed.pushes_the_four()
    {
        let text = RichText::new(words::feedback::alone(closed.is_fed_back())).font(theme::small());
        ui.label(text.color(palette.warning));
    }
    for approximation in approximations(plane, mode) {
        let values =
            RichText::new(words::approximation::values(approximation, notation)).font(theme::small());
        let formula = words::approximation::formula(approximation.name, notation);
        let formula = prose(formula, theme::small(), palette.weak);
        let leaves_out = prose(
            &format!("Leaves out: {}", words::approximation::neglects(approximation.name, notation)),
            theme::body(),
            palette.text,
        );
        ui.label(values.color(palette.text)).on_hover_text(leaves_out.clone());
        ui.label(formula).on_hover_text(leaves_out);
        ui.add_space(2.0);
    }
}

/// Height of a number of a card.
const ENTRY_HEIGHT: f32 = 18.0;

/// One number of a card: symbol, text with its unit, and what it is.
type Entry = (&'static str, Option<String>, &'static str);

/// The numbers of a mode, two a line, where they aren't hidden.
pub fn numbers_ui(ui: &mut Ui, mode: &Mode) {
    if !Curtain::of(ui).hides(Hidden::Numbers) {
        ui.scope(|ui| entries_ui(ui, mode));
    }
}

fn entries_ui(ui: &mut Ui, mode: &Mode) {
    let seconds = |t: f64| format!("{} s", significant(t, 3));
    let rate = |w: f64| format!("{} rad/s", significant(w, 3));
    let growth: Entry = if mode.stability == Stability::Unstable {
        ("t_2", mode.time_to_double().map(seconds), "Time to double the amplitude, ln 2/σ")
    } else {
        ("t_½", mode.time_to_half().map(seconds), "Time to half the amplitude, ln 2/|σ|")
    };
    let cycles = if mode.stability == Stability::Unstable {
        ("N_2", "Oscillations until the amplitude has doubled")
    } else {
        ("N_½", "Oscillations until the amplitude has halved")
    };
    let entries: [Entry; 7] = [
        ("ω_n", mode.natural_frequency().map(rate), "Undamped natural frequency, |λ|"),
        (
            "ζ",
            mode.damping_ratio().map(|z| significant(z, 3)),
            "Damping ratio, −σ/ωₙ; negative when the motion grows",
        ),
        ("ω_d", mode.damped_frequency().map(rate), "Damped frequency, |Im λ|"),
        ("T", mode.period().map(seconds), "Period, 2π/|Im λ|"),
        growth,
        (cycles.0, mode.cycles().map(|n| significant(n, 2)), cycles.1),
        // Of a root that grows it would be negative; the time to double says it better.
        ("τ", mode.time_constant().filter(|tau| *tau > 0.0).map(seconds), "Time constant, −1/λ"),
    ];
    let eigenvalue = format!("{} 1/s", eigenvalue(mode.lambda));
    if theme::is_for_fingers(ui) {
        // They are only read: no finger has to hit them.
        ui.spacing_mut().interact_size.y = ENTRY_HEIGHT;
    }
    entry_ui(ui, ui.available_width(), &("λ", Some(eigenvalue), "Eigenvalue σ ± jω: growth and frequency"));
    let shown: Vec<&Entry> = entries.iter().filter(|entry| entry.1.is_some()).collect();
    for pair in shown.chunks(2) {
        ui.horizontal(|ui| {
            let width = 0.5 * (ui.available_width() - ui.spacing().item_spacing.x);
            for entry in pair {
                entry_ui(ui, width, entry);
            }
        });
    }
}

fn entry_ui(ui: &mut Ui, width: f32, (symbol, text, meaning): &Entry) {
    let Some(text) = text else { return };
    let palette = Palette::of(ui);
    let size = Vec2::new(width, ENTRY_HEIGHT);
    let response = ui
        .allocate_ui_with_layout(size, Layout::left_to_right(Align::Center), |ui| {
            ui.set_min_width(width);
            ui.spacing_mut().item_spacing.x = 0.0;
            symbol_ui(ui, &Symbol::parse(symbol), theme::sizes(ui).symbol, palette.weak, Some(26.0));
            ui.label(RichText::new(text).font(theme::semibold(theme::sizes(ui).value)));
        })
        .response;
    let told = || format!("{} = {text}", Symbol::parse(symbol).plain());
    copy::offer(ui, response.rect, &told);
    response.on_hover_text(*meaning);
}

/// Segments as wide as the participation of each state.
fn participation_ui(ui: &mut Ui, plane: Plane, Card { mode, whole, .. }: Card<'_>) {
    let bars = Palette::of(ui).bars(mode.naming.name);
    let (rect, response) =
        ui.allocate_exact_size(Vec2::new(ui.available_width(), 15.0), egui::Sense::hover());
    let mut x = rect.left();
    let mut words = Vec::new();
    let (shares, appended) = whole.map_or((&mode.participation[..], &[][..]), |(whole, closed)| {
        (&whole.participation[..], &closed.appended[..])
    });
    // Neighbours differ, and what a mode is known by is dark: of the phugoid's near halves always the same.
    let yaws = plane == Plane::Lateral && mode.share(Lateral::V) + mode.share(Lateral::R) > 0.5;
    let symbols = match plane {
        Plane::Longitudinal => ["u", "α", "q", "θ"],
        Plane::Lateral => ["β", "p", "r", "φ"],
    };
    let four = symbols.map(|symbol| [symbol, symbol]);
    let states = four.into_iter().chain(appended.iter().map(|state| words::feedback::state(*state)));
    for (i, ([symbol, name], share)) in states.zip(shares).enumerate() {
        let (bar, ink) = bars[(i + usize::from(!yaws)) % 2];
        let width = rect.width() * *share as f32;
        let segment =
            Rect::from_min_size(egui::pos2(x, rect.top()), Vec2::new((width - 1.0).max(0.0), rect.height()));
        ui.painter().rect_filled(segment, 3.0, bar);
        if width > 26.0 {
            let text = format!("{symbol} {:.0}", 100.0 * share);
            let galley = ui.painter().layout_no_wrap(text, theme::semibold(theme::sizes(ui).tick), ink);
            if galley.size().x <= width {
                ui.painter().galley(segment.center() - 0.5 * galley.size(), galley, ink);
            }
        }
        words.push(format!("{name} {:.1} %", 100.0 * share));
        x += width;
    }
    let words = format!("Participation of the states: {}", words.join(", "));
    response.widget_info(|| egui::WidgetInfo::labeled(egui::accesskit::Role::Image, true, words.as_str()));
    response.on_hover_text(words.clone());
}

/// What became of a mode since it was pinned, in its two telling numbers.
fn change(before: &Mode, now: &Mode) -> String {
    let arrow = |symbol: &str, unit: &str, a: f64, b: f64| {
        // In one line: only between them it may break.
        format!("{symbol} {} → {}{unit}", significant(a, 3), significant(b, 3)).replace(' ', "\u{a0}")
    };
    let zeta = before.damping_ratio().zip(now.damping_ratio()).map(|(a, b)| arrow("ζ", "", a, b));
    let period = before.period().zip(now.period()).map(|(a, b)| arrow("T", " s", a, b));
    let real = (zeta.is_none()).then(|| arrow("σ", " 1/s", before.lambda.re, now.lambda.re));
    let parts: Vec<String> = [zeta, period, real].into_iter().flatten().collect();
    format!("Pinned → now: {}", parts.join(", "))
}
