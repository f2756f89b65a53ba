//! Spacing and type in one place, and controls that are drawn alike everywhere.

use egui::accesskit::Role;
use egui::{
    Button, Context, CornerRadius, FontFamily, FontId, Id, InnerResponse, Margin, Response, RichText, Stroke,
    StrokeKind, TextStyle, Theme, Ui, Vec2,
};

use super::fonts;
pub use super::look::Look;
use super::palette::CORNER;
pub use super::palette::Palette;

/// Height of a control that a finger may have to hit \[points\].
pub const TOUCH_HEIGHT: f32 = 44.0;

/// The same for a mouse.
const MOUSE_HEIGHT: f32 = 26.0;

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

/// Sizes of type \[points\]. Letters of the maths face are smaller than those of the text, so symbols have sizes of their own.
#[derive(Debug)]
pub struct Sizes {
    /// Numbers on axes and in bars.
    pub tick: f32,
    /// Units beside numbers.
    pub unit: f32,
    /// Words on coloured chips, and numbers beside marks.
    pub chip: f32,
    /// Text that explains, and headings of groups.
    pub small: f32,
    /// Numbers and sentences that stand out.
    pub value: f32,
    /// Names of marks, and numbers that are typed.
    pub name: f32,
    /// Text of the page.
    pub body: f32,
    /// The name of a mode on its card.
    pub card: f32,
    /// The heading of a sheet.
    pub sheet: f32,
    /// The name of the page.
    pub brand: f32,
    /// Symbols on a picture of their own.
    pub small_symbol: f32,
    /// Symbols within a line of small text.
    pub inline_symbol: f32,
    /// Symbols beside a number.
    pub symbol: f32,
    /// Symbols as a title.
    pub title_symbol: f32,
    /// Symbols at the head of a row.
    pub row_symbol: f32,
}

const SIZES: Sizes = Sizes {
    tick: 10.0,
    unit: 10.5,
    chip: 11.0,
    small: 11.5,
    value: 12.0,
    name: 12.5,
    body: 13.0,
    card: 14.0,
    sheet: 16.0,
    brand: 17.0,
    small_symbol: 12.0,
    inline_symbol: 13.0,
    symbol: 14.0,
    title_symbol: 15.0,
    row_symbol: 16.0,
};

/// The same where a room looks on: nothing is smaller than text that explains.
const FOR_A_ROOM: Sizes = Sizes {
    tick: SIZES.small,
    unit: SIZES.small,
    chip: SIZES.small,
    small_symbol: SIZES.inline_symbol,
    ..SIZES
};

/// The sizes of type in force.
pub fn sizes(ctx: &Context) -> &'static Sizes {
    if is_for_a_room(ctx) { &FOR_A_ROOM } else { &SIZES }
}

/// Makes what is drawn next fit for a room to look at, or for one person again.
pub fn present(ctx: &Context, on: bool) {
    if is_for_a_room(ctx) != on {
        ctx.data_mut(|data| data.insert_temp(for_a_room(), on));
    }
}

/// Whether a room looks on: then there are pictures and words, and nothing to press.
pub fn is_for_a_room(ctx: &Context) -> bool {
    ctx.data(|data| data.get_temp(for_a_room())).unwrap_or(false)
}

fn for_a_room() -> Id {
    Id::unique("for a room")
}

/// Text of the page.
pub const fn body() -> FontId {
    FontId::proportional(SIZES.body)
}

/// Text that explains, one size down.
pub const fn small() -> FontId {
    FontId::proportional(SIZES.small)
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
            (TextStyle::Button, body()),
            (TextStyle::Heading, semibold(SIZES.body)),
            (TextStyle::Monospace, FontId::new(SIZES.body, FontFamily::Monospace)),
        ]
        .into();
        style.spacing.item_spacing = Vec2::new(6.0, 4.0);
        style.spacing.button_padding = Vec2::new(9.0, 5.0);
        style.spacing.interact_size.y = MOUSE_HEIGHT;
        // A list that opens may be taller than is usual: there are many aircraft.
        style.spacing.default_area_size.y = 640.0;
        style.spacing.menu_margin = Margin::same(6);
        // None of the short lists scrolls.
        style.spacing.combo_height = 420.0;
        // A list that goes on says so before a mouse is over it.
        style.spacing.scroll.dormant_handle_opacity = 0.35;
        style.visuals.interact_cursor = Some(egui::CursorIcon::PointingHand);
        style.interaction.selectable_labels = false;
    });
    for (theme, palette) in [(Theme::Light, Look::Light.palette()), (Theme::Dark, Look::Dark.palette())] {
        ctx.style_mut_of(theme, |style| palette.dress(&mut style.visuals));
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

/// Makes a part of the page one that a screen reader can jump to by its name.
pub fn landmark(ui: &Ui, name: &str) {
    ui.ctx().accesskit_node_builder(ui.unique_id(), |node| {
        node.set_role(Role::Region);
        node.set_label(name);
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
