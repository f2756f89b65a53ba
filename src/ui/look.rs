//! How the page looks: light, dark, or for a projector. Until a person chooses, as their system does.

use egui::{Context, Theme};

use super::palette::{DARK, LIGHT, PROJECTOR, Palette};
use crate::key::keys;

/// How the page looks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Look {
    /// Dark on light.
    Light,
    /// Light on dark.
    Dark,
    /// Strong colours on white.
    Projector,
}

keys! {
    Look {
        Light => "light",
        Dark => "dark",
        Projector => "projector",
    }
}

impl Look {
    /// The look that a person has chosen; `None` while it is that of the system.
    pub fn chosen(ctx: &Context) -> Option<Self> {
        ctx.data(|data| data.get_temp::<bool>(projector_id())).map(|_| Self::of(ctx))
    }

    /// The look in force. Until one is chosen it is that of the system.
    pub fn of(ctx: &Context) -> Self {
        let dark = ctx.theme() == Theme::Dark;
        let projector = ctx.data(|data| data.get_temp::<bool>(projector_id())).unwrap_or(false);
        match (dark, projector) {
            (true, _) => Self::Dark,
            (false, true) => Self::Projector,
            (false, false) => Self::Light,
        }
    }

    /// Puts a look in force.
    pub fn set(self, ctx: &Context) {
        ctx.data_mut(|data| data.insert_temp(projector_id(), self == Self::Projector));
        ctx.style_mut_of(Theme::Light, |style| {
            let palette = if self == Self::Projector { &PROJECTOR } else { &LIGHT };
            palette.dress(&mut style.visuals);
        });
        ctx.set_theme(if self == Self::Dark { Theme::Dark } else { Theme::Light });
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

fn projector_id() -> egui::Id {
    egui::Id::unique("projector look")
}
