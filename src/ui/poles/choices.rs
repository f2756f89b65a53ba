//! What a person has asked the pole map for: approximations, levels, and which derivatives the drag of a pole moves.

use egui::style::StyleModifier;
use egui::text::LayoutJob;
use egui::{
    Button, Checkbox, Popup, PopupCloseBehavior, Rect, RichText, ScrollArea, TextFormat, TextWrapMode, Ui,
    Vec2,
};

use crate::findings::{Findings, by_strength};
use crate::flight::modes::mode::Mode;
use crate::flight::modes::mode_name::ModeName;
use crate::scenario::view::Marks;
use crate::scenario::{Convention, Hidden, Lock, Page, Parameter};
use crate::ui::curtain::Curtain;
use crate::ui::derivatives::Rows;
use crate::ui::influence;
use crate::ui::symbol::Symbol;
use crate::ui::theme::{self, Palette};

/// Symbols written on the button; of more, how many.
const WRITTEN: usize = 3;
/// Length of the longest bar of the list \[points\].
const BAR: f32 = 48.0;

/// What is asked for.
#[derive(Debug, Default)]
pub struct Choices {
    /// The mode that was last at hand, whose derivatives the button names.
    pub subject: Option<ModeName>,
    /// Keys that a person has chosen, by page and mode.
    chosen: Vec<((Page, ModeName), Vec<&'static str>)>,
}

impl Choices {
    /// Keys of what the drag of a mode moves.
    pub fn movers(&self, findings: &Findings, index: usize, page: Page) -> Vec<&'static str> {
        let name = findings.flown_modes().get(index).map(|mode| mode.naming.name);
        let chosen = self.chosen.iter().find(|((on, of), _)| *on == page && Some(*of) == name);
        chosen.map_or_else(|| findings.movers(index, page), |(_, keys)| keys.clone())
    }

    /// The same of what the stage leaves free; where that is none of them, what else moves the mode most.
    pub fn free_movers(&self, ui: &Ui, findings: &Findings, index: usize, page: Page) -> Vec<&'static str> {
        let curtain = Curtain::of(ui);
        let mut movers = self.movers(findings, index, page);
        let before = movers.len();
        movers.retain(|key| is_free(&curtain, key));
        if movers.is_empty() && before > 0 {
            let others = by_strength(findings.sensitivities(page), index).into_iter();
            movers = others.filter(|key| is_free(&curtain, key)).take(before).collect();
        }
        movers
    }

    fn choose(&mut self, page: Page, name: ModeName, keys: Vec<&'static str>) {
        self.chosen.retain(|(of, _)| *of != (page, name));
        self.chosen.push(((page, name), keys));
    }

    /// Draws the buttons into the heading of the pane.
    pub fn show(&mut self, ui: &mut Ui, findings: &Findings, page: Page, marks: &mut Marks, size: Rows) {
        if size == Rows::Dense {
            ui.spacing_mut().interact_size.y = 20.0;
            ui.spacing_mut().button_padding = Vec2::new(7.0, 1.0);
            ui.add_space(8.0);
        }
        let toggle = |ui: &mut Ui, on: &mut bool, text: &str, name: &str, hint: &str| {
            let button = Button::selectable(*on, RichText::new(text).font(theme::small()));
            let response = ui.add(button).accessible_name(name).on_hover_text(hint);
            if response.clicked() {
                *on = !*on;
            }
        };
        let curtain = Curtain::of(ui);
        curtain.lock_ui(ui, Lock::View, |ui| {
            if shows_approximations(&curtain) {
                toggle(
                    ui,
                    &mut marks.approximations,
                    "≈",
                    "Textbook approximations",
                    "Where the textbook approximations put the poles: hollow diamonds",
                );
            }
            if !shows_levels(&curtain) {
                return;
            }
            let task = findings.scenario().task;
            ui.add_enabled_ui(task.is_some(), |ui| {
                let hint = task.map_or("Choose a class of aircraft above the mode cards first: its source names none", |_| {
                    "Boundaries of the handling-quality levels of MIL-F-8785C, hatched on the side that fails"
                });
                toggle(ui, &mut marks.levels, "Levels", "Level boundaries", hint);
            });
        });
        // What moves a mode tells which it is.
        if !curtain.hides(Hidden::Reasons) {
            self.movers_ui(ui, findings, page);
        }
    }

    /// Names what the drag moves, and lets a person choose.
    fn movers_ui(&mut self, ui: &mut Ui, findings: &Findings, page: Page) {
        let modes = findings.flown_modes();
        let of_subject = modes.iter().position(|mode| Some(mode.naming.name) == self.subject);
        let mut index = of_subject.unwrap_or(0);
        let Some(mode) = modes.get(index) else { return };
        let palette = Palette::of(ui);
        let keys = self.free_movers(ui, findings, index, page);
        let curtain = Curtain::of(ui);
        let convention = findings.scenario().convention();
        let parameters: Vec<&'static Parameter> =
            keys.iter().filter_map(|key| Parameter::find(key)).collect();
        let job = |before: &str, written: usize| {
            let text = |color| TextFormat::simple(theme::small(), color);
            let mut job = LayoutJob::default();
            job.append(before, 0.0, text(palette.weak));
            for (i, p) in parameters.iter().take(written).enumerate() {
                job.append(if i > 0 { ", " } else { " " }, 0.0, text(palette.text));
                Symbol::parse(p.written(convention).symbol).append_to(
                    &mut job,
                    theme::sizes(ui).inline_symbol,
                    palette.text,
                );
            }
            match parameters.len() {
                0 => job.append(" nothing", 0.0, text(palette.text)),
                // Without room for any symbol a number of them says nothing.
                n if n > written && written > 0 => {
                    job.append(&format!(" +{}", n - written), 0.0, text(palette.text))
                }
                _ => {}
            }
            job.append(" ▾", 0.0, text(palette.weak));
            job
        };
        let room = ui.available_width() - 2.0 * ui.spacing().button_padding.x;
        let jobs = [("Drag moves", WRITTEN), ("Drag:", WRITTEN), ("Drag:", 1), ("Drag", 0)];
        let fits = |job: &LayoutJob| ui.painter().layout_job(job.clone()).size().x <= room;
        let [whole, shorter, shortest, least] = jobs.map(|(before, written)| job(before, written));
        let job = [whole, shorter, shortest].into_iter().find(fits).unwrap_or(least);
        let plain: Vec<String> =
            parameters.iter().map(|p| Symbol::parse(p.written(convention).symbol).plain()).collect();
        let name =
            format!("Drag of the {} moves {}", curtain.in_a_sentence(mode.naming.name), plain.join(", "));
        let button = ui.add(Button::new(job).frame_when_inactive(false)).accessible_name(name);
        let changed = if page == Page::Feedback {
            "Which gains change when a pole is dragged"
        } else {
            "Which derivatives change when a pole is dragged"
        };
        let button = button.on_hover_text(changed);
        let popup = Popup::menu(&button).close_behavior(PopupCloseBehavior::CloseOnClickOutside);
        // Boxes to tick have their outline, which the style of menus takes away.
        let popup = popup.style(StyleModifier::default());
        popup.show(|ui| {
            ui.set_width(268.0);
            ui.label(RichText::new("Dragging this pole changes").font(theme::small()).color(palette.weak));
            ui.horizontal_wrapped(|ui| {
                for i in curtain.order(modes) {
                    let mode = &modes[i];
                    let text = RichText::new(curtain.title(mode.naming.name)).font(theme::small());
                    let text =
                        if i == index { text } else { text.color(palette.mode_text(mode.naming.name)) };
                    if ui.add(Button::selectable(i == index, text)).clicked() {
                        index = i;
                        self.subject = Some(mode.naming.name);
                    }
                }
            });
            let Some(mode) = modes.get(index) else { return };
            let mut keys = self.free_movers(ui, findings, index, page);
            let before = keys.clone();
            let rows = findings.sensitivities(page);
            ScrollArea::vertical().max_height(300.0).auto_shrink([false, true]).show(ui, |ui| {
                for key in by_strength(rows, index).into_iter().filter(|key| is_free(&curtain, key)) {
                    let strength =
                        rows.iter().find(|row| row.key == key).and_then(|row| row.strengths[index]);
                    mover_ui(ui, (key, convention), strength, mode, &mut keys);
                }
            });
            if keys != before {
                self.choose(page, mode.naming.name, keys);
            }
        });
    }
}

fn is_free(curtain: &Curtain, key: &str) -> bool {
    Parameter::find(key).is_some_and(|parameter| curtain.frees(parameter) && !parameter.is_filter())
}

/// Whether approximations are marked: they have the name of a mode, and its numbers.
pub fn shows_approximations(curtain: &Curtain) -> bool {
    !curtain.hides_influence()
}

/// Whether boundaries of levels are drawn: they say of which mode they are.
pub fn shows_levels(curtain: &Curtain) -> bool {
    !curtain.hides_any(&[Hidden::Levels, Hidden::Names])
}

/// One derivative of the list: chosen or not, its name, and a bar for how strongly it moves the mode.
fn mover_ui(
    ui: &mut Ui,
    (key, convention): (&'static str, Convention),
    strength: Option<f64>,
    mode: &Mode,
    keys: &mut Vec<&'static str>,
) {
    let Some(parameter) = Parameter::find(key) else { return };
    let palette = Palette::of(ui);
    ui.horizontal(|ui| {
        let symbol = Symbol::parse(parameter.written(convention).symbol);
        let mut job = symbol.job(theme::sizes(ui).symbol, palette.text);
        let name = TextFormat::simple(theme::small(), palette.weak);
        job.append(&format!("  {}", parameter.name), 0.0, name);
        let mut chosen = keys.contains(&key);
        let text = |ui: &mut Ui| {
            ui.set_max_width(ui.available_width() - BAR - 8.0);
            ui.style_mut().wrap_mode = Some(TextWrapMode::Truncate);
            ui.add(Checkbox::new(&mut chosen, job))
        };
        let checkbox = ui.scope(text).inner;
        let checkbox = checkbox.accessible_name(format!("Drag moves {}", symbol.plain()));
        if checkbox.changed() {
            if chosen {
                keys.push(key);
            } else {
                keys.retain(|other| *other != key);
            }
        }
        let share = strength.map_or(1.0, influence::share);
        let place = checkbox.rect.right_center().y;
        let right = ui.max_rect().right();
        let start = egui::pos2(right - BAR, place - 2.0);
        let bar = Rect::from_min_size(start, Vec2::new((share * BAR).max(1.0), 4.0));
        ui.painter().rect_filled(bar, 1.0, palette.mode(mode.naming.name));
    });
}
