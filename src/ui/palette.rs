//! Colours by meaning, for three looks of the page.
//!
//! The colours of the modes are those of Okabe & Ito (2008), told apart with any colour vision; in the dark
//! palette they are lightened. Colour never stands alone: a mode also has its name.

use egui::{Color32, Context, Theme, Ui};

use super::theme::paint_style;
use crate::flight::modes::DynamicStability;
use crate::flight::naming::ModeName;
use crate::shape::{Finish, Material};

/// The colours of one theme.
#[derive(Debug, PartialEq)]
pub struct Palette {
    /// Behind the panes.
    pub background: Color32,
    /// A pane.
    pub pane: Color32,
    /// A field or button on a pane.
    pub field: Color32,
    /// Lines between things.
    pub hairline: Color32,
    /// Rays and arcs on the pole map.
    pub grid: Color32,
    /// Text.
    pub text: Color32,
    /// Text that explains.
    pub weak: Color32,
    /// The chosen one of several; the handle of a slider.
    pub strong: Color32,
    /// Text on `strong`.
    pub on_strong: Color32,
    /// The filled part of a slider, what has focus.
    pub accent: Color32,
    /// The pinned state to compare with.
    pub ghost: Color32,
    /// The nonlinear flight beside the linear motion.
    pub nonlinear: Color32,
    /// Left half of the pole map.
    pub stable_half: Color32,
    /// Right half of the pole map.
    pub unstable_half: Color32,
    /// Good news, as text.
    pub good: Color32,
    /// Good news, as ground.
    pub good_ground: Color32,
    /// Bad news, as text.
    pub bad: Color32,
    /// Bad news, as ground.
    pub bad_ground: Color32,
    /// A warning, as text.
    pub warning: Color32,
    /// A warning, as ground.
    pub warning_ground: Color32,
    /// The sky high up, and above the horizon.
    pub sky: [Color32; 2],
    /// The ground near the viewer, and below the horizon.
    pub ground: [Color32; 2],
    /// A field on the ground, and the lines between fields.
    pub field_on_ground: Color32,
    /// Lines between fields.
    pub line_on_ground: Color32,
    /// Forces: lift, weight, thrust, drag.
    pub forces: [Color32; 4],
    /// Axes x, y, z of the body.
    pub axes: [Color32; 3],
    /// Axes of the Earth, and angles from them.
    pub earth_axes: Color32,
    /// Velocity, and the angles of the flow.
    pub velocity: Color32,
    /// The path flown.
    pub path: Color32,
    /// Paint: white, metal, black, drab.
    finishes: [Color32; 4],
    /// A stripe on the paint.
    stripe: Color32,
    /// What moves to steer.
    control: Color32,
    glass: Color32,
    engine: Color32,
    tyre: Color32,
    propeller_disc: Color32,
    pub(super) short_period: Color32,
    short_period_slow: Color32,
    phugoid: Color32,
    phugoid_slow: Color32,
    third_mode: Color32,
    divergence: Color32,
    dutch_roll: Color32,
    dutch_roll_slow: Color32,
    roll: Color32,
    spiral: Color32,
}

const LIGHT: Palette = Palette {
    background: Color32::from_rgb(0xf3, 0xf5, 0xf8),
    pane: Color32::WHITE,
    field: Color32::from_rgb(0xf6, 0xf8, 0xfa),
    hairline: Color32::from_rgb(0xdc, 0xe3, 0xea),
    grid: Color32::from_rgb(0xb9, 0xc8, 0xcc),
    text: Color32::from_rgb(0x1f, 0x2d, 0x3a),
    weak: Color32::from_rgb(0x5b, 0x68, 0x76),
    strong: Color32::from_rgb(0x22, 0x30, 0x3c),
    on_strong: Color32::WHITE,
    accent: Color32::from_rgb(0x7a, 0x9b, 0xb8),
    ghost: Color32::from_rgb(0x8a, 0x97, 0xa5),
    nonlinear: Color32::from_rgb(0xa3, 0x2a, 0x12),
    stable_half: Color32::from_rgb(0xed, 0xf7, 0xf3),
    unstable_half: Color32::from_rgb(0xfd, 0xf1, 0xec),
    good: Color32::from_rgb(0x0a, 0x5f, 0x45),
    good_ground: Color32::from_rgb(0xe3, 0xf4, 0xed),
    bad: Color32::from_rgb(0xa3, 0x2a, 0x12),
    bad_ground: Color32::from_rgb(0xfd, 0xe9, 0xe2),
    warning: Color32::from_rgb(0x7a, 0x4d, 0x00),
    warning_ground: Color32::from_rgb(0xff, 0xf3, 0xd9),
    sky: [Color32::from_rgb(0x8f, 0xbd, 0xe6), Color32::from_rgb(0xe9, 0xf2, 0xf8)],
    ground: [Color32::from_rgb(0xb9, 0xc9, 0xa4), Color32::from_rgb(0xdd, 0xe6, 0xdd)],
    field_on_ground: Color32::from_rgb(0x9f, 0xb6, 0x88),
    line_on_ground: Color32::from_rgb(0x8b, 0xa0, 0x7c),
    forces: [
        Color32::from_rgb(0x00, 0x72, 0xb2),
        Color32::from_rgb(0x22, 0x30, 0x3c),
        Color32::from_rgb(0x00, 0x8a, 0x65),
        Color32::from_rgb(0xd5, 0x5e, 0x00),
    ],
    axes: [
        Color32::from_rgb(0xb8, 0x32, 0x2a),
        Color32::from_rgb(0x1f, 0x7a, 0x3d),
        Color32::from_rgb(0x2a, 0x4f, 0xb8),
    ],
    earth_axes: Color32::from_rgb(0x3c, 0x4a, 0x58),
    velocity: Color32::from_rgb(0x8a, 0x2f, 0x78),
    path: Color32::from_rgb(0xd8, 0x7a, 0x1e),
    finishes: [
        Color32::from_rgb(0xfa, 0xfb, 0xfc),
        Color32::from_rgb(0xd3, 0xda, 0xe1),
        Color32::from_rgb(0x4a, 0x50, 0x59),
        Color32::from_rgb(0xa3, 0x9c, 0x72),
    ],
    stripe: Color32::from_rgb(0x2c, 0x62, 0xa0),
    control: Color32::from_rgb(0xf2, 0xa6, 0x3b),
    glass: Color32::from_rgb(0x5d, 0x86, 0xa8),
    engine: Color32::from_rgb(0x9a, 0xa3, 0xac),
    tyre: Color32::from_rgb(0x3a, 0x40, 0x48),
    propeller_disc: Color32::from_rgba_premultiplied(0x18, 0x1c, 0x20, 0x30),
    short_period: Color32::from_rgb(0x00, 0x72, 0xb2),
    short_period_slow: Color32::from_rgb(0x2f, 0x8f, 0xcb),
    phugoid: Color32::from_rgb(0xd5, 0x5e, 0x00),
    phugoid_slow: Color32::from_rgb(0xb8, 0x7a, 0x00),
    third_mode: Color32::from_rgb(0x00, 0x8a, 0x65),
    divergence: Color32::from_rgb(0xb0, 0x4a, 0x84),
    dutch_roll: Color32::from_rgb(0xb0, 0x4a, 0x84),
    dutch_roll_slow: Color32::from_rgb(0xcc, 0x79, 0xa7),
    roll: Color32::from_rgb(0x00, 0x8a, 0x65),
    spiral: Color32::from_rgb(0xb8, 0x7a, 0x00),
};

const DARK: Palette = Palette {
    background: Color32::from_rgb(0x0e, 0x12, 0x17),
    pane: Color32::from_rgb(0x16, 0x1c, 0x23),
    field: Color32::from_rgb(0x1e, 0x26, 0x2f),
    hairline: Color32::from_rgb(0x2c, 0x36, 0x41),
    grid: Color32::from_rgb(0x3a, 0x4b, 0x4f),
    text: Color32::from_rgb(0xe4, 0xea, 0xf0),
    weak: Color32::from_rgb(0x9a, 0xa8, 0xb6),
    strong: Color32::from_rgb(0xd6, 0xe1, 0xec),
    on_strong: Color32::from_rgb(0x16, 0x1c, 0x23),
    accent: Color32::from_rgb(0x4f, 0x7d, 0xa3),
    ghost: Color32::from_rgb(0x7d, 0x8b, 0x9a),
    nonlinear: Color32::from_rgb(0xff, 0xa3, 0x8a),
    stable_half: Color32::from_rgb(0x14, 0x24, 0x22),
    unstable_half: Color32::from_rgb(0x2b, 0x1d, 0x1b),
    good: Color32::from_rgb(0x7d, 0xd9, 0xb5),
    good_ground: Color32::from_rgb(0x12, 0x32, 0x29),
    bad: Color32::from_rgb(0xff, 0xa3, 0x8a),
    bad_ground: Color32::from_rgb(0x40, 0x1f, 0x18),
    warning: Color32::from_rgb(0xf5, 0xc8, 0x6a),
    warning_ground: Color32::from_rgb(0x37, 0x2b, 0x12),
    sky: [Color32::from_rgb(0x14, 0x22, 0x3a), Color32::from_rgb(0x3a, 0x50, 0x68)],
    ground: [Color32::from_rgb(0x1d, 0x2b, 0x24), Color32::from_rgb(0x33, 0x44, 0x4c)],
    field_on_ground: Color32::from_rgb(0x27, 0x3b, 0x2c),
    line_on_ground: Color32::from_rgb(0x4a, 0x62, 0x55),
    forces: [
        Color32::from_rgb(0x56, 0xb4, 0xe9),
        Color32::from_rgb(0xe8, 0xee, 0xf4),
        Color32::from_rgb(0x2f, 0xc9, 0x9a),
        Color32::from_rgb(0xff, 0x8b, 0x3d),
    ],
    axes: [
        Color32::from_rgb(0xff, 0x8a, 0x80),
        Color32::from_rgb(0x7f, 0xd8, 0x96),
        Color32::from_rgb(0x9d, 0xb8, 0xff),
    ],
    earth_axes: Color32::from_rgb(0xc4, 0xd0, 0xdc),
    velocity: Color32::from_rgb(0xe3, 0x8f, 0xd2),
    path: Color32::from_rgb(0xf5, 0xb0, 0x5a),
    finishes: [
        Color32::from_rgb(0xdd, 0xe3, 0xea),
        Color32::from_rgb(0xae, 0xb8, 0xc3),
        Color32::from_rgb(0x66, 0x70, 0x7e),
        Color32::from_rgb(0x8e, 0x8a, 0x66),
    ],
    stripe: Color32::from_rgb(0x3f, 0x7c, 0xc0),
    control: Color32::from_rgb(0xe6, 0x9a, 0x35),
    glass: Color32::from_rgb(0x4c, 0x76, 0x9c),
    engine: Color32::from_rgb(0x80, 0x8a, 0x94),
    tyre: Color32::from_rgb(0x43, 0x4b, 0x54),
    propeller_disc: Color32::from_rgba_premultiplied(0x28, 0x2c, 0x30, 0x30),
    short_period: Color32::from_rgb(0x56, 0xb4, 0xe9),
    short_period_slow: Color32::from_rgb(0x8c, 0xcd, 0xf2),
    phugoid: Color32::from_rgb(0xff, 0x8b, 0x3d),
    phugoid_slow: Color32::from_rgb(0xe6, 0xb0, 0x2e),
    third_mode: Color32::from_rgb(0x2f, 0xc9, 0x9a),
    divergence: Color32::from_rgb(0xe3, 0x8f, 0xbe),
    dutch_roll: Color32::from_rgb(0xe3, 0x8f, 0xbe),
    dutch_roll_slow: Color32::from_rgb(0xf0, 0xb8, 0xd6),
    roll: Color32::from_rgb(0x2f, 0xc9, 0x9a),
    spiral: Color32::from_rgb(0xe6, 0xb0, 0x2e),
};

/// For a beamer that washes out all that is pale: black on white, every line and ground a step stronger.
const PROJECTOR: Palette = Palette {
    background: Color32::WHITE,
    pane: Color32::WHITE,
    field: Color32::from_rgb(0xee, 0xf1, 0xf4),
    hairline: Color32::from_rgb(0xa8, 0xb4, 0xc0),
    grid: Color32::from_rgb(0x86, 0x97, 0x9d),
    text: Color32::BLACK,
    weak: Color32::from_rgb(0x33, 0x3f, 0x4b),
    strong: Color32::BLACK,
    on_strong: Color32::WHITE,
    accent: Color32::from_rgb(0x3d, 0x6b, 0x94),
    ghost: Color32::from_rgb(0x55, 0x63, 0x72),
    nonlinear: Color32::from_rgb(0x8c, 0x10, 0x00),
    stable_half: Color32::from_rgb(0xdc, 0xf0, 0xe8),
    unstable_half: Color32::from_rgb(0xfb, 0xdf, 0xd3),
    good: Color32::from_rgb(0x00, 0x4d, 0x34),
    good_ground: Color32::from_rgb(0xcd, 0xec, 0xdf),
    bad: Color32::from_rgb(0x8c, 0x10, 0x00),
    bad_ground: Color32::from_rgb(0xfb, 0xd5, 0xc8),
    warning: Color32::from_rgb(0x5c, 0x38, 0x00),
    warning_ground: Color32::from_rgb(0xff, 0xe6, 0xb0),
    short_period: Color32::from_rgb(0x00, 0x5a, 0x92),
    short_period_slow: Color32::from_rgb(0x00, 0x72, 0xb2),
    phugoid: Color32::from_rgb(0xb8, 0x48, 0x00),
    phugoid_slow: Color32::from_rgb(0x94, 0x60, 0x00),
    third_mode: Color32::from_rgb(0x00, 0x6e, 0x50),
    divergence: Color32::from_rgb(0x93, 0x2f, 0x69),
    dutch_roll: Color32::from_rgb(0x93, 0x2f, 0x69),
    dutch_roll_slow: Color32::from_rgb(0xb0, 0x4a, 0x84),
    roll: Color32::from_rgb(0x00, 0x6e, 0x50),
    spiral: Color32::from_rgb(0x94, 0x60, 0x00),
    ..LIGHT
};

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

impl Look {
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
            paint_style(&mut style.visuals, palette);
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
}

fn projector_id() -> egui::Id {
    egui::Id::unique("projector look")
}

impl Palette {
    /// The palette of the look in force.
    pub fn of(ui: &Ui) -> &'static Self {
        Look::of(ui.ctx()).palette()
    }

    /// The one colour of a mode, wherever it is shown. Seven colours that all eyes can tell apart don't go round fourteen names: a
    /// few names share one, of which no two are ever on screen together.
    pub const fn mode(&self, name: ModeName) -> Color32 {
        match name {
            ModeName::ShortPeriod | ModeName::ShortPeriodFastRoot => self.short_period,
            ModeName::ShortPeriodSlowRoot => self.short_period_slow,
            ModeName::Phugoid | ModeName::PhugoidFastRoot | ModeName::CoupledRollSpiral => self.phugoid,
            ModeName::PhugoidSlowRoot => self.phugoid_slow,
            ModeName::ThirdOscillatory => self.third_mode,
            ModeName::Divergence => self.divergence,
            ModeName::DutchRoll | ModeName::DutchRollMoreStableRoot => self.dutch_roll,
            ModeName::DutchRollLessStableRoot => self.dutch_roll_slow,
            ModeName::RollSubsidence => self.roll,
            ModeName::Spiral => self.spiral,
        }
    }

    /// The colour of an aircraft's faces in full light.
    pub const fn airframe(&self, finish: Finish, material: Material) -> Color32 {
        match material {
            Material::Skin => self.finishes[finish as usize],
            Material::Stripe => self.stripe,
            Material::Control => self.control,
            Material::Glass => self.glass,
            Material::Metal => self.engine,
            Material::Dark => self.tyre,
            Material::Disc => self.propeller_disc,
        }
    }

    /// Text and ground of a verdict.
    pub const fn verdict(&self, stability: DynamicStability) -> (Color32, Color32) {
        match stability {
            DynamicStability::Stable => (self.good, self.good_ground),
            DynamicStability::Neutral => (self.warning, self.warning_ground),
            DynamicStability::Unstable => (self.bad, self.bad_ground),
        }
    }
}
