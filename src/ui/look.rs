//! How the page looks: light, dark, or for a projector. Until a person chooses, as their system does; where a link or the page
//! around a frame says how, it looks so until the person chooses another.

use egui::{Context, Theme, ThemePreference};

use super::palette::{DARK, LIGHT, PROJECTOR, Palette};
pub use crate::scenario::view::Look;

/// Who wants which look.
#[derive(Clone, Copy, Debug, Default)]
struct Wanted {
    /// The person.
    chosen: Option<Look>,
    /// A link, or the page around a frame.
    lent: Option<Look>,
}

impl Look {
    /// The look that a person has chosen; `None` while it is that of the system.
    pub fn chosen(ctx: &Context) -> Option<Self> {
        Wanted::of(ctx).chosen
    }

    /// The look that a link or the page around a frame has put in force.
    pub fn lent(ctx: &Context) -> Option<Self> {
        Wanted::of(ctx).lent
    }

    /// The look in force. Until one is chosen it is that of the system.
    pub fn of(ctx: &Context) -> Self {
        let dark = ctx.theme() == Theme::Dark;
        let projector = Wanted::of(ctx).in_force() == Some(Self::Projector);
        match (dark, projector) {
            (true, _) => Self::Dark,
            (false, true) => Self::Projector,
            (false, false) => Self::Light,
        }
    }

    /// Puts a look in force that a person has chosen.
    pub fn set(self, ctx: &Context) {
        Wanted { chosen: Some(self), lent: None }.put(ctx);
    }

    /// Puts a look in force that the person hasn't chosen; with `None` theirs again.
    pub fn lend(look: Option<Self>, ctx: &Context) {
        Wanted { lent: look, ..Wanted::of(ctx) }.put(ctx);
    }

    /// The one that comes after it.
    pub const fn next(self) -> Self {
        match self {
            Self::Light => Self::Dark,
            Self::Dark => Self::Projector,
            Self::Projector => Self::Light,
        }
    }

    /// The words on screen.
    pub const fn text(self) -> &'static str {
        match self {
            Self::Light => "Light theme",
            Self::Dark => "Dark theme",
            Self::Projector => "Projector theme",
        }
    }

    /// Its sign.
    pub const fn sign(self) -> &'static str {
        match self {
            Self::Light => "☀",
            Self::Dark => "☾",
            Self::Projector => "◐",
        }
    }

    /// Its colours.
    pub const fn palette(self) -> &'static Palette {
        match self {
            Self::Light => &LIGHT,
            Self::Dark => &DARK,
            Self::Projector => &PROJECTOR,
        }
    }

    /// Its colours where the names of modes are hidden: one for all modes.
    pub(super) const fn unnamed_palette(self) -> &'static Palette {
        const UNNAMED: [Palette; 3] = [LIGHT.unnamed(), DARK.unnamed(), PROJECTOR.unnamed()];
        match self {
            Self::Light => &UNNAMED[0],
            Self::Dark => &UNNAMED[1],
            Self::Projector => &UNNAMED[2],
        }
    }
}

impl Wanted {
    fn of(ctx: &Context) -> Self {
        ctx.data(|data| data.get_temp(egui::Id::unique("look"))).unwrap_or_default()
    }

    fn in_force(self) -> Option<Look> {
        self.lent.or(self.chosen)
    }

    fn put(self, ctx: &Context) {
        ctx.data_mut(|data| data.insert_temp(egui::Id::unique("look"), self));
        let look = self.in_force();
        ctx.style_mut_of(Theme::Light, |style| {
            let palette = if look == Some(Look::Projector) { &PROJECTOR } else { &LIGHT };
            palette.dress(&mut style.visuals);
        });
        ctx.set_theme(match look {
            Some(Look::Dark) => ThemePreference::Dark,
            Some(Look::Light | Look::Projector) => ThemePreference::Light,
            None => ThemePreference::System,
        });
    }
}
