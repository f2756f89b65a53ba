//! The picture as a widget: drawn, turned by drag and keys, and told in a sentence.

use egui::accesskit::Role;
use egui::containers::menu::{MenuButton, MenuConfig};
use egui::style::StyleModifier;
use egui::{
    Align2, CornerRadius, Id, Key, PopupCloseBehavior, Pos2, Rect, Response, RichText, Sense, Shape, Stroke,
    StrokeKind, Ui, Vec2, WidgetInfo,
};

use super::landscape::Ground;
use super::overlays::OverlayPainter;
use super::picture::{Picture, finite};
use super::{airframe, landscape};
use crate::scenario::Lock;
use crate::scenario::view::{Camera, FlightView, StandardView, Turn};
use crate::shape::Point;
use crate::ui::curtain::Curtain;
use crate::ui::symbol::prose;
use crate::ui::theme::{self, Palette};
use crate::ui::{arrow_keys, finger};
use crate::words;

/// How much of what is under it a veil hides.
const VEIL: f32 = 0.6;
/// A drag over this many points turns the camera by 1 rad.
const DRAG: f32 = 160.0;
/// A drag of a label over one point turns the aircraft by so much \[°\].
const DEGREES: f32 = 0.5;
/// An arrow key turns it by so much \[rad\].
const STEP: f32 = 0.12;
/// A key zooms by so much.
const ZOOM_STEP: f32 = 1.15;
/// The aircraft strays no farther from the middle than this, in radii.
const FARTHEST_ASTRAY: f32 = 0.2;
/// In less room the buttons are closer to each other.
const NARROW: f32 = 260.0;
/// Width of a remark in the list of what is shown.
const REMARK: f32 = 200.0;
/// Radius of the aircraft seen from so far that it is a dot.
const DOT: f32 = 3.5;
/// Side of the polygon of forces.
const POLYGON: f32 = 84.0;

/// The picture as it was in the frame before: how a person looks at it is in [`FlightView`].
#[derive(Clone, Debug, Default, PartialEq)]
pub struct AircraftView {
    /// Whether one mode was flown alone in the frame before; `None` before the first one.
    was_one_mode: Option<bool>,
    /// Whether a person has ticked or unticked the forces.
    forces_chosen: bool,
    /// Whether the forces were shown before a mode was flown alone.
    forces_before: Option<bool>,
    /// What of the forces isn't in the aircraft's source.
    remark: Option<&'static str>,
    /// Distance at which the whole path is in the pane, over the one at which the aircraft fills it.
    whole: f32,
    /// The symbol on the picture that is pointed at or was tapped in this frame.
    pub pointed: Option<&'static str>,
    /// How far a label of the aircraft turned by hand was dragged in this frame: ψ, θ and φ \[°\].
    pub dragged: [f32; 3],
}

impl AircraftView {
    /// Draws the overlays next as they are, as a link or a file says, whatever is flown then.
    pub fn keep_overlays(&mut self) {
        self.was_one_mode = None;
    }

    /// Buttons of the standard views, and what to show.
    pub fn toolbar_ui(&mut self, ui: &mut Ui, FlightView { camera, overlays, turn, .. }: &mut FlightView) {
        ui.horizontal_wrapped(|ui| {
            let is_narrow = ui.available_width() < NARROW && !theme::is_for_fingers(ui);
            ui.spacing_mut().button_padding.x = if is_narrow { 3.0 } else { 6.0 };
            ui.spacing_mut().item_spacing.x = if is_narrow { 0.0 } else { 2.0 };
            ui.style_mut().override_font_id = Some(theme::small());
            for view in StandardView::ALL {
                let is_on = *camera == view.camera();
                let response = ui.selectable_label(is_on, words::view::standard_view(view));
                let name = words::view::standard_view_in_words(view);
                if response.accessible_name(name).on_hover_text(name).clicked() {
                    *camera = view.camera();
                }
            }
            let turned = ui.selectable_label(turn.is_some(), words::turn::BUTTON);
            let turned =
                turned.accessible_name(words::turn::BUTTON_IN_WORDS).on_hover_text(words::turn::HINT);
            if turned.clicked() {
                *turn = if turn.is_some() { None } else { Some(Turn::default()) };
            }
            // Stays open while boxes are ticked. They have their outline, which the style of menus takes away.
            let config = MenuConfig::new().style(StyleModifier::default());
            let config = config.close_behavior(PopupCloseBehavior::CloseOnClickOutside);
            let (menu, _) = MenuButton::new("Show ▾").config(config).ui(ui, |ui| {
                let forces = overlays.forces;
                for (words, is_shown) in overlays.boxes() {
                    ui.checkbox(is_shown, words);
                }
                if let Some(remark) = self.remark {
                    ui.set_max_width(REMARK);
                    ui.label(RichText::new(remark).font(theme::small()).color(Palette::of(ui).weak));
                }
                self.forces_chosen |= overlays.forces != forces;
                if ui.button("See the whole path").clicked() {
                    overlays.path = true;
                    *camera = Camera { distance: 1.0, ..StandardView::Side.camera() };
                    camera.zoom(1.0 / self.whole.max(1.0));
                    ui.close();
                }
            });
            menu.accessible_name("Shown on the picture").on_hover_text("What is drawn over the aircraft");
        });
    }

    /// Draws a moment of flight into all that is left of `ui`.
    ///
    /// Drag turns the view; so do the arrow keys where it has focus, `+` and `−` zoom, 1 to 4 are the standard views.
    /// Two fingers turn it and zoom, and so does the wheel with Ctrl; the wheel alone, or one finger going up or down,
    /// scrolls the page as everywhere.
    pub fn show(&mut self, ui: &mut Ui, view: &mut FlightView, picture: &Picture<'_>) -> Response {
        let (pane, response) = ui.allocate_exact_size(ui.available_size(), Sense::click_and_drag());
        if !Curtain::of(ui).locks(Lock::View) {
            steer(ui, &response, &mut view.camera);
        }
        self.remark = picture.forces.remark();
        self.whole = finite(picture.path_reach) / picture.model.radius();
        // The forces would hide what a mode does; but what a person has chosen stands.
        let before = self.was_one_mode.replace(picture.is_one_mode);
        if before.is_some_and(|before| before != picture.is_one_mode) && !self.forces_chosen {
            let shown = view.overlays.forces;
            view.overlays.forces = if picture.is_one_mode {
                self.forces_before = Some(shown);
                false
            } else {
                self.forces_before.take().unwrap_or(true)
            };
        }
        if ui.is_rect_visible(pane) {
            self.explain(ui, draw(ui, pane, view, picture), picture.is_turned);
            if response.has_focus() {
                let stroke = Stroke::new(2.0, Palette::of(ui).accent);
                ui.painter().rect_stroke(pane, CornerRadius::same(4), stroke, StrokeKind::Inside);
            }
        }
        response.widget_info(|| WidgetInfo::labeled(Role::Image, true, picture.sentence()));
        response
    }
}

impl AircraftView {
    /// Says what the label under the pointer means; turns the aircraft by hand where the label of an angle or its axis is dragged.
    fn explain(&mut self, ui: &Ui, labels: Vec<(String, Rect)>, is_turned: bool) {
        (self.pointed, self.dragged) = (None, [0.0; 3]);
        for (symbol, place) in labels {
            let Some(sentence) = words::turn::sentence(&symbol) else { continue };
            let turns =
                words::turn::angle(&symbol).filter(|_| is_turned && !Curtain::of(ui).locks(Lock::View));
            let sense = if turns.is_some() { Sense::CLICK | Sense::DRAG } else { Sense::CLICK };
            let label = ui.interact(place, Id::unique(("label on the aircraft", &symbol)), sense);
            if let Some(angle) = turns.filter(|_| label.dragged()) {
                let Vec2 { x, y } = label.drag_delta();
                // Up is nose-up; to the right is nose right, and right wing down.
                self.dragged[angle] += DEGREES * if angle == 1 { -y } else { x };
            }
            if label.hovered() || label.dragged() || label.clicked() {
                let is_of = |explained: &&str| words::turn::sentence(explained) == Some(sentence);
                self.pointed = words::turn::EXPLAINED.into_iter().find(is_of);
            }
            label.on_hover_text(prose(sentence, theme::body(), Palette::of(ui).text));
        }
    }
}

/// Turns the camera by drag, fingers and keys.
fn steer(ui: &Ui, response: &Response, camera: &mut Camera) {
    let held = finger::works_on(ui, response);
    if response.clicked() || (held && response.drag_started()) {
        response.request_focus();
    }
    let pinch = finger::pinch(ui, response);
    let drag = match pinch {
        Some(pinch) => pinch.translation_delta,
        None if held && response.dragged() => response.drag_delta(),
        None => Vec2::ZERO,
    };
    camera.orbit(-drag.x / DRAG, drag.y / DRAG);
    if pinch.is_some() || response.hovered() {
        camera.zoom(ui.input(|input| input.zoom_delta()));
    }
    if !response.has_focus() {
        return;
    }
    arrow_keys::keep(ui, response);
    ui.input(|input| {
        let pressed = |key| input.num_presses(key) as f32;
        camera.orbit(
            STEP * (pressed(Key::ArrowRight) - pressed(Key::ArrowLeft)),
            STEP * (pressed(Key::ArrowUp) - pressed(Key::ArrowDown)),
        );
        let nearer = pressed(Key::Plus) + pressed(Key::Equals) - pressed(Key::Minus);
        camera.zoom(ZOOM_STEP.powf(nearer));
        let keys = [Key::Num1, Key::Num2, Key::Num3, Key::Num4];
        for (key, view) in keys.into_iter().zip(StandardView::ALL) {
            if input.key_pressed(key) {
                *camera = view.camera();
            }
        }
    });
}

/// Tells where the labels are.
fn draw(
    ui: &Ui,
    pane: Rect,
    FlightView { camera, overlays, .. }: &FlightView,
    picture: &Picture<'_>,
) -> Vec<(String, Rect)> {
    let palette = Palette::of(ui);
    let painter = ui.painter_at(pane);
    let radius = picture.model.radius();
    let lens = camera.lens(pane, radius, target(picture));
    let [north, east, _] = picture.position;
    let climbed = finite(picture.steady_position[2] - picture.position[2]);
    let ground = Ground::below(radius, finite(picture.speed), [north, east], climbed);
    painter.add(Shape::mesh(landscape::kept_mesh(ui, pane, &lens, &ground, palette)));

    let rotation = picture.attitude.rotation();
    let mut easel = OverlayPainter {
        painter: &painter,
        pane,
        lens,
        picture,
        rotation,
        palette,
        labels: Default::default(),
    };
    let (beyond, before) =
        if overlays.path && picture.shows_path { easel.path() } else { Default::default() };
    painter.add(Shape::mesh(beyond));
    let airframe = airframe::kept_airframe(ui, pane, picture, &rotation, &lens, palette);
    painter.add(Shape::mesh(airframe.mesh.clone()));
    painter.add(Shape::mesh(before));
    if picture.is_far {
        // A dot on the path; arrows as small as it is would hide it.
        painter.circle_filled(lens.on_screen(&lens.seen(&Point::zeros())), DOT, palette.text);
    } else {
        easel.draw(overlays);
    }

    let mut taken = Vec::new();
    if overlays.forces && !picture.is_turned && !picture.is_far && pane.width() > 4.0 * POLYGON {
        let corner = pane.left_bottom() + Vec2::new(8.0, -8.0 - POLYGON);
        let place = Rect::from_min_size(corner, Vec2::splat(POLYGON));
        painter.rect_filled(place, CornerRadius::same(4), palette.pane.gamma_multiply(0.78));
        easel.force_polygon(place);
        let corner = place.min + Vec2::new(5.0, 3.0);
        painter.text(corner, Align2::LEFT_TOP, "Balance", theme::small(), palette.weak);
        taken.push(place);
    }
    if let Some(note) = picture.note {
        taken.push(note_ui(&painter, pane, note, palette));
    }
    let OverlayPainter { labels, .. } = easel;
    let places = labels.paint(&painter, pane, &taken, &airframe.silhouette, palette);
    if picture.is_dimmed {
        painter.rect_filled(pane, CornerRadius::ZERO, palette.pane.gamma_multiply(VEIL));
        // Over the veil, which the labels are under.
        if let Some(note) = picture.note {
            note_ui(&painter, pane, note, palette);
        }
    }
    places
}

/// Where to look, from the aircraft: at the middle of it and its arrows, but towards where steady flight would have
/// brought it, so that it is seen to stray, though never far. From far away, at the middle of the path.
fn target(picture: &Picture<'_>) -> Point {
    if picture.is_far
        && let (Some(start), Some(end)) = (picture.path.first(), picture.path.last())
    {
        return (picture.seen_from_here(*start) + picture.seen_from_here(*end)) * 0.5;
    }
    let (low, high) = picture.model.bounds();
    let middle = Point::x() * (0.5 * (low.x + 1.2 * high.x));
    let back = picture.seen_from_here(picture.steady_position);
    let limit = FARTHEST_ASTRAY * picture.model.radius();
    middle + back * (limit / (limit + back.norm()))
}

/// A sentence at the top, and the place that it takes.
fn note_ui(painter: &egui::Painter, pane: Rect, note: &str, palette: &Palette) -> Rect {
    let wrap = pane.width() - 24.0;
    let galley = painter.layout(note.to_owned(), theme::small(), palette.text, wrap);
    let margin = Vec2::new(6.0, 3.0);
    let corner = Pos2::new(pane.left() + 8.0, pane.top() + 8.0);
    let place = Rect::from_min_size(corner, galley.size() + 2.0 * margin);
    painter.rect_filled(place, CornerRadius::same(4), palette.pane.gamma_multiply(0.85));
    painter.galley(corner + margin, galley, palette.text);
    place
}
