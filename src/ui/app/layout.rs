//! Where the panes stand: on a wide screen, a tablet, a phone, and one of them alone beside the sliders.

use egui::{
    Button, CentralPanel, Frame, Id, Margin, Panel, Rect, RichText, ScrollArea, Sense, Ui, UiBuilder, Vec2,
};

use super::{Action, App, PhonePane};
use crate::scenario::view::Pane;
use crate::scenario::{Lock, Part, Stage};
use crate::ui::curtain::Curtain;
use crate::ui::derivatives::Rows;
use crate::ui::finger;
use crate::ui::take_along::take_pane;
use crate::ui::theme::{self, Palette};
use crate::words;

/// From this width on two panes of a tablet stand beside each other.
const BESIDE: f32 = 560.0;
/// From these heights on one row of panes alone, and two of them, have room for all that is in them.
const BARE: [f32; 2] = [360.0, 600.0];
/// Between panes.
const PANE_GAP: f32 = 10.0;
/// Height of an aircraft turned by hand with its sliders, on a phone.
const TURNED: f32 = 440.0;
/// Height of the pole map on a phone, with its choices.
const MAP_ON_PHONE: f32 = 276.0;
/// Least height of what stands below the pole map on a phone.
const BELOW_MAP: f32 = 180.0;
/// Of more tabs of a phone each is narrower.
const MOST_TABS: usize = 4;
/// In a narrower pane the heading has a row of its own.
const SLIM: f32 = 295.0;
/// At the right end of a heading, for the buttons that take the pane along and put it alone beside the sliders.
pub(super) const CORNER: f32 = 37.0;

impl App {
    /// Sliders on the left.
    pub(super) fn sliders_ui(&mut self, ui: &mut Ui, wide: bool) {
        let width = ui.available_width();
        Panel::left("derivatives")
            .exact_size(if wide {
                (0.26 * width).clamp(362.0, 460.0)
            } else {
                (0.35 * width).clamp(344.0, 362.0)
            })
            .resizable(false)
            .frame(side_frame(ui))
            .show(ui, |ui| {
                theme::landmark(ui, "Sliders");
                self.derivatives_ui(ui, Rows::Dense);
            });
    }

    /// Poles and responses in the middle, modes right or, on a tablet, below.
    pub(super) fn desk_ui(&mut self, ui: &mut Ui, wide: bool) -> Option<Action> {
        let palette = Palette::of(ui);
        let mut action = None;
        if wide && self.has_lesson() {
            // In the place of the modes, whose cards would give the answers away.
            Panel::right("lesson").exact_size(340.0).resizable(false).frame(side_frame(ui)).show(ui, |ui| {
                theme::landmark(ui, "Step of the lesson");
                self.lesson_ui(ui);
            });
        } else if wide && self.view.stage.has(Part::Modes) {
            action = Panel::right("modes")
                .exact_size(286.0)
                .resizable(false)
                .frame(side_frame(ui))
                .show(ui, |ui| {
                    theme::landmark(ui, "Verdicts and cards");
                    let area = ScrollArea::vertical().auto_shrink(false);
                    finger::scroll_area_ui(ui, "modes", area, |ui| self.modes_ui(ui))
                })
                .inner;
        }
        let ground = Frame::new().fill(palette.background).inner_margin(Margin::same(10));
        let middle = |ui: &mut Ui| {
            if let Some(pane) = self.view.maximised {
                let room = ui.available_rect_before_wrap();
                self.pane_ui(ui, pane, room);
                if pane != Pane::Response {
                    self.panes.responses.leave();
                }
                if pane != Pane::Aircraft {
                    self.play(ui);
                }
                return None;
            }
            if wide || self.is_bare(ui) {
                for (pane, place) in places(&self.view.stage, ui.available_rect_before_wrap()) {
                    self.pane_ui(ui, pane, place);
                }
                self.go_on_unseen(ui);
                return None;
            }
            let area = ScrollArea::vertical().auto_shrink(false);
            finger::scroll_area_ui(ui, "middle", area, |ui| {
                let with_modes = self.view.stage.has(Part::Modes) && !self.has_lesson();
                if self.has_lesson() {
                    theme::pane(Palette::of(ui)).show(ui, |ui| {
                        ui.set_width(ui.available_width());
                        self.step_ui(ui);
                    });
                    ui.add_space(PANE_GAP);
                }
                let action = if with_modes { self.verdicts_ui(ui) } else { None };
                let width = ui.available_width();
                let stage = &self.view.stage;
                let beside = width >= BESIDE && stage.has(Part::Poles) && stage.has(Part::Aircraft);
                if beside {
                    let (_, above) = ui.allocate_space(Vec2::new(width, 330.0));
                    let (poles, aircraft) = above.split_left_right_at_fraction(0.5);
                    let gap = 0.5 * PANE_GAP;
                    self.pane_ui(ui, Pane::Poles, inset(poles, [0.0, gap, 0.0, 0.0]));
                    self.pane_ui(ui, Pane::Aircraft, inset(aircraft, [gap, 0.0, 0.0, 0.0]));
                }
                let below: &[(Pane, f32)] = if beside {
                    &[(Pane::Response, 480.0), (Pane::Equations, 420.0)]
                } else {
                    &[
                        (Pane::Poles, 290.0),
                        (Pane::Response, 560.0),
                        (Pane::Aircraft, 360.0),
                        (Pane::Equations, 420.0),
                    ]
                };
                for &(pane, height) in below {
                    if !self.view.stage.has(pane.part()) {
                        continue;
                    }
                    let (_, room) = ui.allocate_space(Vec2::new(width, height));
                    self.pane_ui(ui, pane, room);
                }
                if with_modes {
                    let count = if width >= BESIDE { 2 } else { 1 };
                    ui.columns(count, |columns| {
                        self.cards_ui(|i| i % count, columns);
                    });
                    self.strongest_ui(ui);
                }
                self.go_on_unseen(ui);
                action
            })
        };
        CentralPanel::default().frame(ground).show(ui, middle).inner.or(action)
    }

    /// Whether the stage has panes alone, and the room is high enough for them at once, as that of a projector is.
    fn is_bare(&self, ui: &Ui) -> bool {
        let stage = &self.view.stage;
        let beside = self.has_lesson() || stage.has(Part::Derivatives) || stage.has(Part::Modes);
        let has_any = |parts: [Part; 2]| parts.into_iter().any(|part| stage.has(part));
        let two = has_any([Part::Poles, Part::Aircraft]) && has_any([Part::Response, Part::Equations]);
        !beside && ui.available_height() >= BARE[usize::from(two)]
    }

    /// The least height of so many rows of panes that have room for all that is in them \[points\].
    pub(super) const fn height_of_rows(rows: usize) -> f32 {
        match rows {
            0 => 0.0,
            1 => BARE[0],
            _ => BARE[1],
        }
    }

    /// The height of what a phone shows below the bar, with the pole map or without \[points\].
    pub(super) const fn height_on_phone(has_map: bool) -> f32 {
        BARE[0] + if has_map { MAP_ON_PHONE } else { 0.0 }
    }

    /// What goes on in a pane that is not on the stage.
    fn go_on_unseen(&mut self, ui: &Ui) {
        if !self.view.stage.has(Part::Response) {
            self.panes.responses.leave();
        }
        if !self.view.stage.has(Part::Aircraft) {
            self.play(ui);
        }
    }

    /// The pole map stays on top; one of the other panes is below it.
    pub(super) fn phone_ui(&mut self, ui: &mut Ui) -> Option<Action> {
        let palette = Palette::of(ui);
        let ground = Frame::new().fill(palette.pane).inner_margin(Margin::symmetric(10, 6));
        // A finger going up or down on the map scrolls what is below, as if the map were a part of it.
        let below = finger::last_background(ui);
        // Enlarged, or on its side, a phone may have no room for the map above the panes: then it is one of them.
        let is_low = ui.available_height() < MAP_ON_PHONE + BELOW_MAP;
        if self.view.stage.has(Part::Poles) && !is_low {
            Panel::top("poles").exact_size(MAP_ON_PHONE).resizable(false).frame(ground).show(ui, |ui| {
                theme::landmark(ui, words::view::landmark(Pane::Poles));
                ui.horizontal(|ui| self.pole_choices_ui(ui, Rows::Touch));
                finger::scrolls_ui(ui, below, |ui| self.poles_ui(ui));
            });
        }
        let panes = [
            (PhonePane::Derivatives, Part::Derivatives, "Derivatives"),
            (PhonePane::Poles, Part::Poles, "Poles"),
            (PhonePane::Modes, Part::Modes, "Modes"),
            (PhonePane::Response, Part::Response, "Response"),
            (PhonePane::Aircraft, Part::Aircraft, "Aircraft"),
            (PhonePane::Equations, Part::Equations, words::equations::TITLE),
        ];
        let enlarged = self.view.maximised == Some(Pane::Equations);
        let of_lesson = self.has_lesson().then_some((PhonePane::Lesson, "Lesson"));
        let staged = panes.iter().filter(|(pane, part, _)| {
            let is_on = match pane {
                PhonePane::Derivatives => self.has_sliders(),
                PhonePane::Poles => is_low,
                _ => true,
            };
            self.view.stage.has(*part) && is_on || *pane == PhonePane::Equations && enlarged
        });
        let staged: Vec<(PhonePane, &str)> =
            of_lesson.into_iter().chain(staged.map(|&(pane, _, text)| (pane, text))).collect();
        let Some(&(first, _)) = staged.first() else {
            self.go_on_unseen(ui);
            return None;
        };
        if !staged.iter().any(|(pane, _)| *pane == self.panes.phone_pane) {
            self.panes.phone_pane = first;
        }
        Panel::top("panes").frame(ground).show(ui, |ui| {
            ui.horizontal_wrapped(|ui| {
                if staged.len() > MOST_TABS {
                    ui.spacing_mut().button_padding.x = 6.0;
                    ui.spacing_mut().item_spacing.x = 2.0;
                }
                for &(pane, text) in &staged {
                    ui.selectable_value(&mut self.panes.phone_pane, pane, text);
                }
            });
        });
        if self.panes.phone_pane != PhonePane::Response {
            self.panes.responses.leave();
        }
        if self.panes.phone_pane != PhonePane::Derivatives {
            // Nobody is at a slider.
            self.panes.touched = None;
        }
        let pane = |ui: &mut Ui| match self.panes.phone_pane {
            PhonePane::Lesson => {
                self.lesson_ui(ui);
                self.play(ui);
                None
            }
            PhonePane::Derivatives => {
                self.derivatives_ui(ui, Rows::Touch);
                None
            }
            PhonePane::Poles => {
                let height = MAP_ON_PHONE.max(ui.available_height());
                let area = ScrollArea::vertical().auto_shrink(false);
                finger::scroll_area_ui(ui, "map", area, |ui| {
                    ui.set_max_height(height);
                    ui.horizontal(|ui| self.pole_choices_ui(ui, Rows::Touch));
                    self.poles_ui(ui);
                });
                self.play(ui);
                None
            }
            PhonePane::Modes => {
                let area = ScrollArea::vertical().auto_shrink(false);
                finger::scroll_area_ui(ui, "modes", area, |ui| self.modes_ui(ui))
            }
            PhonePane::Aircraft => {
                self.panes.flight.toolbar_ui(ui, &mut self.view.flight);
                if self.view.flight.turn.is_none() {
                    self.aircraft_ui(ui);
                    return None;
                }
                // The sliders that turn it leave no room for it: they stand below it, where a finger scrolls to them.
                let height = TURNED.max(ui.available_height());
                let area = ScrollArea::vertical().auto_shrink(false);
                finger::scroll_area_ui(ui, "aircraft", area, |ui| {
                    ui.set_max_height(height);
                    self.aircraft_ui(ui);
                });
                None
            }
            PhonePane::Equations => {
                let area = ScrollArea::vertical().auto_shrink(false);
                finger::scroll_area_ui(ui, "equations", area, |ui| self.equations_ui(ui));
                self.play(ui);
                None
            }
            PhonePane::Response => {
                let area = ScrollArea::vertical().auto_shrink(false);
                finger::scroll_area_ui(ui, "responses", area, |ui| self.responses_ui(ui, Rows::Touch));
                // The moment that a finger has pointed out stays when it has gone.
                self.play(ui);
                None
            }
        };
        CentralPanel::default().frame(ground).show(ui, pane).inner
    }

    /// A pane in its frame over all of `room`; its heading puts it alone beside the sliders by double click or its button.
    pub(super) fn pane_ui(&mut self, ui: &mut Ui, pane: Pane, room: Rect) {
        // A place of its own: what is put into it moves nothing outside.
        let ui = &mut ui.new_child(UiBuilder::new().id_salt(pane).max_rect(room));
        theme::landmark(ui, words::view::landmark(pane));
        let frame = theme::pane(Palette::of(ui));
        let inner = room - frame.total_margin();
        // Before what is drawn over it, so that controls on it come first. Not a stop of the Tab key: its button is.
        let heading = Rect::from_min_size(room.min, Vec2::new(room.width(), 34.0));
        let turned = ui.interact(heading, Id::unique(("heading", pane)), Sense::CLICK).double_clicked();
        ui.painter().add(frame.paint(inner));
        ui.scope_builder(UiBuilder::new().max_rect(inner), |ui| {
            ui.set_clip_rect(room.intersect(ui.clip_rect()));
            match pane {
                Pane::Poles => {
                    ui.horizontal(|ui| {
                        ui.set_max_width(ui.available_width() - CORNER);
                        theme::heading(ui, RichText::new("Pole map").heading(), 2);
                        self.pole_choices_ui(ui, Rows::Dense);
                    });
                    self.poles_ui(ui);
                }
                Pane::Aircraft => {
                    // The views have a row of their own, all in one.
                    let is_slim = inner.width() < SLIM;
                    ui.horizontal(|ui| {
                        ui.set_max_width(ui.available_width() - CORNER);
                        theme::heading(ui, RichText::new("Aircraft").heading(), 2);
                        ui.add_space(4.0);
                        if !is_slim {
                            self.panes.flight.toolbar_ui(ui, &mut self.view.flight);
                        }
                    });
                    if is_slim {
                        self.panes.flight.toolbar_ui(ui, &mut self.view.flight);
                    }
                    self.aircraft_ui(ui);
                }
                Pane::Response => self.responses_ui(ui, Rows::Dense),
                Pane::Equations => {
                    theme::heading(ui, RichText::new(words::equations::TITLE).heading(), 2);
                    let area = ScrollArea::vertical().auto_shrink(false);
                    finger::scroll_area_ui(ui, "equations", area, |ui| self.equations_ui(ui));
                }
            }
        });
        let maximised = self.view.maximised == Some(pane);
        if !Curtain::of(ui).keeps() {
            let corner = Rect::from_min_size(room.right_top() + Vec2::new(-50.0, 5.0), Vec2::new(18.0, 24.0));
            ui.spacing_mut().button_padding.x = 2.0;
            let sign = RichText::new("⋯").color(Palette::of(ui).weak);
            let name = take_pane(pane);
            let button = ui.put(corner, Button::selectable(false, sign)).accessible_name(name);
            if button.on_hover_text(format!("{name}: figure, data")).clicked() {
                self.take_pane_along(ui, pane);
            }
        }
        let corner = Rect::from_min_size(room.right_top() + Vec2::new(-32.0, 5.0), Vec2::splat(24.0));
        let name = words::view::maximise(pane);
        let sign = RichText::new(if maximised { "■" } else { "□" }).color(Palette::of(ui).weak);
        let button = Curtain::of(ui)
            .lock_ui(ui, Lock::View, |ui| ui.put(corner, Button::selectable(false, sign)))
            .accessible_name(name);
        let hover = if maximised {
            "Back to its place (Esc)".to_owned()
        } else {
            format!("{name} ({})", pane.shortcut())
        };
        if (button.on_hover_text(hover).clicked() || turned) && !Curtain::of(ui).locks(Lock::View) {
            self.view.maximised = (!maximised).then_some(pane);
        }
    }
}

impl Pane {
    /// The part of the stage that it is.
    pub(super) const fn part(self) -> Part {
        match self {
            Self::Poles => Part::Poles,
            Self::Aircraft => Part::Aircraft,
            Self::Response => Part::Response,
            Self::Equations => Part::Equations,
        }
    }
}

/// Where the panes of a stage stand on a wide screen: poles and aircraft beside each other, responses and equations below.
fn places(stage: &Stage, room: Rect) -> Vec<(Pane, Rect)> {
    let on = |panes: [Pane; 2]| panes.into_iter().filter(|pane| stage.has(pane.part())).collect::<Vec<_>>();
    let (above, below) = (on([Pane::Poles, Pane::Aircraft]), on([Pane::Response, Pane::Equations]));
    let (upper, lower) = if above.is_empty() || below.is_empty() {
        (room, room)
    } else {
        let (upper, lower) = room.split_top_bottom_at_y(room.top() + 0.47 * room.height());
        let gap = 0.5 * PANE_GAP;
        (inset(upper, [0.0, 0.0, 0.0, gap]), inset(lower, [0.0, 0.0, gap, 0.0]))
    };
    beside(&above, upper, 0.56).chain(beside(&below, lower, 0.5)).collect()
}

/// Panes beside each other, the first of two as wide as a share of the room.
fn beside(panes: &[Pane], room: Rect, share: f32) -> impl Iterator<Item = (Pane, Rect)> {
    let (left, right) = room.split_left_right_at_fraction(share);
    let gap = 0.5 * PANE_GAP;
    let places = match panes.len() {
        2 => [inset(left, [0.0, gap, 0.0, 0.0]), inset(right, [gap, 0.0, 0.0, 0.0])],
        _ => [room, room],
    };
    panes.iter().copied().zip(places)
}

/// The frame of what stands on the left and right.
fn side_frame(ui: &Ui) -> Frame {
    Frame::new().fill(Palette::of(ui).pane).inner_margin(Margin::symmetric(12, 10))
}

/// A rectangle smaller by so much on its left, right, top and bottom.
fn inset(rect: Rect, [left, right, top, bottom]: [f32; 4]) -> Rect {
    Rect::from_min_max(rect.min + Vec2::new(left, top), rect.max - Vec2::new(right, bottom))
}
