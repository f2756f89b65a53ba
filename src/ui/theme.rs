//! Spacing and type in one place, and how the colours of a [`Palette`] dress every control.

use egui::accesskit::Role;
use egui::{
    Button, Color32, Context, CornerRadius, FontFamily, FontId, InnerResponse, Margin, Rect, Response,
    RichText, Sense, Stroke, StrokeKind, TextStyle, Theme, Ui, Vec2,
};

use egui_plot::Plot;

use super::fonts;
pub use super::palette::{Look, Palette};

/// Height of a control that a finger may have to hit \[points\].
pub const TOUCH_HEIGHT: f32 = 44.0;

/// The same for a mouse.
const MOUSE_HEIGHT: f32 = 26.0;
/// Radius of the corners of a control: from 6 on egui draws them with twice as many points, in every frame, and nobody sees it.
const CORNER: u8 = 5;

/// Makes every control as high as a finger needs it, lists included, or as a mouse does. Says whether that is a change.
pub fn make_room(ctx: &Context, fingers: bool) -> bool {
    let height = if fingers { TOUCH_HEIGHT } else { MOUSE_HEIGHT };
    let changes = ctx.style_of(ctx.theme()).spacing.interact_size.y != height;
    if changes {
        ctx.all_styles_mut(|style| style.spacing.interact_size.y = height);
    }
    changes
}

/// Whether controls are as high as a finger needs them.
pub fn is_for_fingers(ui: &Ui) -> bool {
    ui.spacing().interact_size.y >= TOUCH_HEIGHT
}

/// A height for a control that is smaller than others: not for a finger.
pub fn make_low(ui: &mut Ui, height: f32) {
    if !is_for_fingers(ui) {
        ui.spacing_mut().interact_size.y = height;
    }
}

/// Text of the page.
pub fn body() -> FontId {
    FontId::proportional(13.0)
}

/// Text that explains, one size down.
pub fn small() -> FontId {
    FontId::proportional(11.5)
}

/// Semibold text of a size.
pub fn semibold(size: f32) -> FontId {
    FontId::new(size, fonts::bold())
}

/// Sets fonts, type sizes, spacing and both palettes. Called once at the start.
pub fn install(ctx: &Context) {
    ctx.set_fonts(fonts::definitions());
    ctx.all_styles_mut(|style| {
        style.text_styles = [
            (TextStyle::Small, small()),
            (TextStyle::Body, body()),
            (TextStyle::Button, FontId::proportional(13.0)),
            (TextStyle::Heading, semibold(13.0)),
            (TextStyle::Monospace, FontId::new(13.0, FontFamily::Monospace)),
        ]
        .into();
        style.spacing.item_spacing = Vec2::new(6.0, 4.0);
        style.spacing.button_padding = Vec2::new(9.0, 5.0);
        style.spacing.interact_size.y = MOUSE_HEIGHT;
        // A list that opens may be taller than is usual: there are many aircraft.
        style.spacing.default_area_size.y = 640.0;
        style.spacing.menu_margin = Margin::same(6);
        // A list that goes on says so before a mouse is over it.
        style.spacing.scroll.dormant_handle_opacity = 0.35;
        style.visuals.interact_cursor = Some(egui::CursorIcon::PointingHand);
        style.interaction.selectable_labels = false;
    });
    for (theme, palette) in [(Theme::Light, Look::Light.palette()), (Theme::Dark, Look::Dark.palette())] {
        ctx.style_mut_of(theme, |style| paint_style(&mut style.visuals, palette));
    }
}

/// Dresses every control in the colours of a palette.
pub(super) fn paint_style(visuals: &mut egui::Visuals, palette: &Palette) {
    visuals.panel_fill = palette.background;
    visuals.window_fill = palette.pane;
    visuals.window_stroke = Stroke::new(1.0, palette.hairline);
    visuals.extreme_bg_color = palette.pane;
    visuals.faint_bg_color = palette.field;
    visuals.weak_text_color = Some(palette.weak);
    visuals.error_fg_color = palette.bad;
    visuals.warn_fg_color = palette.warning;
    visuals.hyperlink_color = palette.link();
    visuals.selection.bg_fill = palette.strong;
    visuals.selection.stroke = Stroke::new(1.0, palette.on_strong);
    visuals.popup_shadow.color = Color32::from_black_alpha(30);
    let widgets = &mut visuals.widgets;
    for (style, fill, line) in [
        (&mut widgets.noninteractive, palette.pane, palette.hairline),
        (&mut widgets.inactive, palette.pane, palette.hairline),
        (&mut widgets.hovered, palette.field, palette.accent),
        (&mut widgets.active, palette.field, palette.strong),
        (&mut widgets.open, palette.field, palette.accent),
    ] {
        style.bg_fill = fill;
        style.weak_bg_fill = fill;
        style.bg_stroke = Stroke::new(1.0, line);
        style.fg_stroke = Stroke::new(1.0, palette.text);
        style.corner_radius = CornerRadius::same(CORNER);
        style.expansion = 0.0;
    }
}

/// A button that is its words alone. A frame shows the focus of others; this one has a ring for it.
pub fn bare_button(ui: &mut Ui, enabled: bool, button: Button<'_>) -> Response {
    let response = ui.add_enabled(enabled, button.frame(false));
    focus_ring(ui, &response);
    response
}

/// Shows the focus of a button that has no outline of its own.
pub fn focus_ring(ui: &Ui, response: &Response) {
    if response.has_focus() {
        let ring = Stroke::new(2.0, Palette::of(ui).accent);
        ui.painter().rect_stroke(response.rect.expand(2.0), CornerRadius::same(4), ring, StrokeKind::Outside);
    }
}

/// A heading, for eyes and for screen readers.
pub fn heading(ui: &mut Ui, text: RichText, level: usize) {
    let words = text.text().to_owned();
    let response = ui.label(text);
    ui.ctx().accesskit_node_builder(response.id, |node| {
        node.set_role(Role::Heading);
        node.set_label(words);
        node.set_level(level);
    });
}

/// Gives a list to choose from its name, and tells screen readers whether it is open and what is chosen.
pub fn name_chooser<R>(chooser: InnerResponse<Option<R>>, name: &str, chosen: &str) -> Response {
    let response = chooser.response.accessible_name(name);
    response.ctx.accesskit_node_builder(response.id, |node| {
        node.set_value(chosen);
        node.set_expanded(chooser.inner.is_some());
    });
    response
}

/// A plot that fills `rect` and doesn't move under the hand: what it shows is set by its caller.
pub fn still_plot<'a>(id: impl egui::AsIdSalt, rect: Rect) -> Plot<'a> {
    Plot::new(id)
        // Not for the keyboard, which would find nothing to do there.
        .sense(Sense::CLICK | Sense::DRAG)
        .width(rect.width())
        .height(rect.height())
        .show_axes(false)
        .show_background(false)
        .show_grid(false)
        .allow_zoom(false)
        .allow_drag(false)
        .allow_scroll(false)
        .allow_boxed_zoom(false)
        .allow_double_click_reset(false)
        .show_crosshair(false)
        .label_formatter(|_| None)
}

/// The outline of a text field that has focus: its own has the colour of chosen text, which is that of the field.
pub fn focus_frame(ui: &Ui, field: &Response) {
    if field.has_focus() {
        let stroke = Stroke::new(1.5, Palette::of(ui).accent);
        ui.painter().rect_stroke(field.rect, CornerRadius::same(CORNER), stroke, StrokeKind::Inside);
    }
}

/// A pane: white ground with a hairline.
pub fn pane(palette: &Palette) -> egui::Frame {
    egui::Frame::new()
        .fill(palette.pane)
        .stroke(Stroke::new(1.0, palette.hairline))
        .corner_radius(8)
        .inner_margin(Margin::symmetric(12, 9))
}
