//! Colours by meaning, for three looks of the page.
//!
//! The colours of the modes are those of Okabe & Ito (2008), told apart with any colour vision; in the dark
//! palette they are lightened. Text in the colour of a mode has a darker tone of the same hue, since thin strokes need more
//! contrast than marks. Colour never stands alone: a mode also has its name.

use egui::{Color32, CornerRadius, Stroke, Ui, Visuals};

use super::curtain::Curtain;
use super::look::Look;
use crate::flight::modes::mode_name::ModeName;
use crate::flight::modes::stability::Stability;
use crate::scenario::Hidden;
use crate::shape::{Finish, Material};

/// Radius of the corners of a control: from 6 on egui draws them with twice as many points, in every frame, and nobody sees it.
pub const CORNER: u8 = 5;

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
    pub pinned: Color32,
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
    /// A field on the ground.
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
    short_period: Tone,
    short_period_slow: Tone,
    phugoid: Tone,
    phugoid_slow: Tone,
    third_mode: Tone,
    divergence: Tone,
    dutch_roll: Tone,
    dutch_roll_slow: Tone,
    roll: Tone,
    spiral: Tone,
}

/// The colour of a mode in its two tones.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Tone {
    /// Contrast of crosses, curves and bars: 3:1 on every ground.
    mark: Color32,
    /// Contrast of words and numbers: 4.5:1 on every ground.
    text: Color32,
}

impl Tone {
    /// One tone for both: light colours on dark grounds.
    const fn light(color: Color32) -> Self {
        Self { mark: color, text: color }
    }
}

/// How much of what is behind a word on the picture of the aircraft its ground hides.
const HIDES: f32 = 0.9;
/// Strength of the paler of two neighbouring bars.
const PALE: f32 = 0.4;

pub(super) const LIGHT: Palette = Palette {
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
    pinned: Color32::from_rgb(0x78, 0x86, 0x94),
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
        Color32::from_rgb(0x00, 0x6b, 0xa8),
        Color32::from_rgb(0x22, 0x30, 0x3c),
        Color32::from_rgb(0x6a, 0x5a, 0x00),
        Color32::from_rgb(0xae, 0x4c, 0x00),
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
    short_period: Tone {
        mark: Color32::from_rgb(0x00, 0x72, 0xb2),
        text: Color32::from_rgb(0x00, 0x6b, 0xa8),
    },
    short_period_slow: Tone {
        mark: Color32::from_rgb(0x2f, 0x8f, 0xcb),
        text: Color32::from_rgb(0x25, 0x6e, 0x9d),
    },
    phugoid: Tone { mark: Color32::from_rgb(0xd5, 0x5e, 0x00), text: Color32::from_rgb(0xae, 0x4c, 0x00) },
    phugoid_slow: Tone {
        mark: Color32::from_rgb(0xb8, 0x7a, 0x00),
        text: Color32::from_rgb(0x8c, 0x5e, 0x00),
    },
    third_mode: Tone { mark: Color32::from_rgb(0x00, 0x8a, 0x65), text: Color32::from_rgb(0x00, 0x77, 0x57) },
    divergence: Tone { mark: Color32::from_rgb(0xb0, 0x4a, 0x84), text: Color32::from_rgb(0xa6, 0x45, 0x7c) },
    dutch_roll: Tone { mark: Color32::from_rgb(0xb0, 0x4a, 0x84), text: Color32::from_rgb(0xa6, 0x45, 0x7c) },
    dutch_roll_slow: Tone {
        mark: Color32::from_rgb(0xbf, 0x6c, 0x9a),
        text: Color32::from_rgb(0x8f, 0x54, 0x74),
    },
    roll: Tone { mark: Color32::from_rgb(0x00, 0x8a, 0x65), text: Color32::from_rgb(0x00, 0x77, 0x57) },
    spiral: Tone { mark: Color32::from_rgb(0xb8, 0x7a, 0x00), text: Color32::from_rgb(0x8c, 0x5e, 0x00) },
};

pub(super) const DARK: Palette = Palette {
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
    pinned: Color32::from_rgb(0x7d, 0x8b, 0x9a),
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
        Color32::from_rgb(0xe6, 0xd0, 0x4a),
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
    short_period: Tone::light(Color32::from_rgb(0x56, 0xb4, 0xe9)),
    short_period_slow: Tone::light(Color32::from_rgb(0x8c, 0xcd, 0xf2)),
    phugoid: Tone::light(Color32::from_rgb(0xff, 0x8b, 0x3d)),
    phugoid_slow: Tone::light(Color32::from_rgb(0xe6, 0xb0, 0x2e)),
    third_mode: Tone::light(Color32::from_rgb(0x2f, 0xc9, 0x9a)),
    divergence: Tone::light(Color32::from_rgb(0xe3, 0x8f, 0xbe)),
    dutch_roll: Tone::light(Color32::from_rgb(0xe3, 0x8f, 0xbe)),
    dutch_roll_slow: Tone::light(Color32::from_rgb(0xf0, 0xb8, 0xd6)),
    roll: Tone::light(Color32::from_rgb(0x2f, 0xc9, 0x9a)),
    spiral: Tone::light(Color32::from_rgb(0xe6, 0xb0, 0x2e)),
};

/// For a beamer that washes out all that is pale: black on white, every line and ground a step stronger.
pub(super) const PROJECTOR: Palette = Palette {
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
    pinned: Color32::from_rgb(0x55, 0x63, 0x72),
    nonlinear: Color32::from_rgb(0x8c, 0x10, 0x00),
    stable_half: Color32::from_rgb(0xdc, 0xf0, 0xe8),
    unstable_half: Color32::from_rgb(0xfb, 0xdf, 0xd3),
    good: Color32::from_rgb(0x00, 0x4d, 0x34),
    good_ground: Color32::from_rgb(0xcd, 0xec, 0xdf),
    bad: Color32::from_rgb(0x8c, 0x10, 0x00),
    bad_ground: Color32::from_rgb(0xfb, 0xd5, 0xc8),
    warning: Color32::from_rgb(0x5c, 0x38, 0x00),
    warning_ground: Color32::from_rgb(0xff, 0xe6, 0xb0),
    short_period: Tone {
        mark: Color32::from_rgb(0x00, 0x5a, 0x92),
        text: Color32::from_rgb(0x00, 0x5a, 0x92),
    },
    short_period_slow: Tone {
        mark: Color32::from_rgb(0x00, 0x72, 0xb2),
        text: Color32::from_rgb(0x00, 0x65, 0x9e),
    },
    phugoid: Tone { mark: Color32::from_rgb(0xb8, 0x48, 0x00), text: Color32::from_rgb(0xa3, 0x40, 0x00) },
    phugoid_slow: Tone {
        mark: Color32::from_rgb(0x94, 0x60, 0x00),
        text: Color32::from_rgb(0x84, 0x55, 0x00),
    },
    third_mode: Tone { mark: Color32::from_rgb(0x00, 0x6e, 0x50), text: Color32::from_rgb(0x00, 0x6e, 0x50) },
    divergence: Tone { mark: Color32::from_rgb(0x93, 0x2f, 0x69), text: Color32::from_rgb(0x93, 0x2f, 0x69) },
    dutch_roll: Tone { mark: Color32::from_rgb(0x93, 0x2f, 0x69), text: Color32::from_rgb(0x93, 0x2f, 0x69) },
    dutch_roll_slow: Tone {
        mark: Color32::from_rgb(0xb0, 0x4a, 0x84),
        text: Color32::from_rgb(0x9a, 0x41, 0x73),
    },
    roll: Tone { mark: Color32::from_rgb(0x00, 0x6e, 0x50), text: Color32::from_rgb(0x00, 0x6e, 0x50) },
    spiral: Tone { mark: Color32::from_rgb(0x94, 0x60, 0x00), text: Color32::from_rgb(0x84, 0x55, 0x00) },
    ..LIGHT
};

impl Palette {
    /// The palette of the look in force.
    pub fn of(ui: &Ui) -> &'static Self {
        let look = Look::of(ui.ctx());
        if Curtain::of(ui).hides(Hidden::Names) { look.unnamed_palette() } else { look.palette() }
    }

    /// The same with one colour for all modes, whose names are hidden.
    pub(super) const fn unnamed(self) -> Self {
        let tone = Tone { mark: self.weak, text: self.weak };
        Self {
            short_period: tone,
            short_period_slow: tone,
            phugoid: tone,
            phugoid_slow: tone,
            third_mode: tone,
            divergence: tone,
            dutch_roll: tone,
            dutch_roll_slow: tone,
            roll: tone,
            spiral: tone,
            ..self
        }
    }

    /// Dresses every control in these colours.
    pub fn dress(&self, visuals: &mut Visuals) {
        visuals.panel_fill = self.background;
        visuals.window_fill = self.pane;
        visuals.window_stroke = Stroke::new(1.0, self.hairline);
        visuals.extreme_bg_color = self.pane;
        visuals.faint_bg_color = self.field;
        visuals.weak_text_color = Some(self.weak);
        visuals.error_fg_color = self.bad;
        visuals.warn_fg_color = self.warning;
        visuals.hyperlink_color = self.link();
        visuals.selection.bg_fill = self.strong;
        visuals.selection.stroke = Stroke::new(1.0, self.on_strong);
        visuals.popup_shadow.color = Color32::from_black_alpha(30);
        let widgets = &mut visuals.widgets;
        for (style, fill, line) in [
            (&mut widgets.noninteractive, self.pane, self.hairline),
            (&mut widgets.inactive, self.pane, self.hairline),
            (&mut widgets.hovered, self.field, self.accent),
            (&mut widgets.active, self.field, self.strong),
            (&mut widgets.open, self.field, self.accent),
        ] {
            style.bg_fill = fill;
            style.weak_bg_fill = fill;
            style.bg_stroke = Stroke::new(1.0, line);
            style.fg_stroke = Stroke::new(1.0, self.text);
            style.corner_radius = CornerRadius::same(CORNER);
            style.expansion = 0.0;
        }
    }

    /// The one colour of a mode, wherever it is drawn. Seven colours that all eyes can tell apart don't go round fourteen names: a
    /// few names share one, of which no two are ever on screen together.
    pub const fn mode(&self, name: ModeName) -> Color32 {
        self.tone(name).mark
    }

    /// The colour of a mode where it is written.
    pub const fn mode_text(&self, name: ModeName) -> Color32 {
        self.tone(name).text
    }

    const fn tone(&self, name: ModeName) -> Tone {
        match name {
            ModeName::ShortPeriod | ModeName::ShortPeriodFastRoot => self.short_period,
            ModeName::ShortPeriodSlowRoot | ModeName::PitchSubsidence | ModeName::PitchDivergence => {
                self.short_period_slow
            }
            ModeName::Phugoid | ModeName::PhugoidFastRoot | ModeName::CoupledRollSpiral => self.phugoid,
            ModeName::PhugoidSlowRoot | ModeName::SpeedSubsidence => self.phugoid_slow,
            ModeName::ThirdOscillatory | ModeName::LateralOscillation => self.third_mode,
            ModeName::SpeedDivergence | ModeName::LateralSubsidence | ModeName::LateralDivergence => {
                self.divergence
            }
            ModeName::DutchRoll | ModeName::DutchRollMoreStableRoot | ModeName::SideslipSubsidence => {
                self.dutch_roll
            }
            ModeName::DutchRollLessStableRoot | ModeName::DirectionalDivergence => self.dutch_roll_slow,
            ModeName::RollSubsidence | ModeName::RollDivergence => self.roll,
            ModeName::Spiral | ModeName::Height => self.spiral,
            // Those of the feedback take what the other plane has, or what is seldom there in their own.
            ModeName::ElevatorActuator => self.roll,
            ModeName::Engine => self.dutch_roll_slow,
            ModeName::Heading | ModeName::Position => self.phugoid_slow,
            ModeName::AileronActuator => self.short_period_slow,
            ModeName::RudderActuator => self.short_period,
            ModeName::Washout => self.phugoid_slow,
            ModeName::FeedbackOscillation => self.short_period_slow,
            ModeName::FurtherState => self.third_mode,
            ModeName::FurtherOscillation => self.divergence,
        }
    }

    /// Two bars of a mode that stand beside each other, each with the colour of the words on it.
    pub fn bars(&self, name: ModeName) -> [(Color32, Color32); 2] {
        let Tone { mark, text } = self.tone(name);
        [(text, self.pane), (self.pane.blend(mark.gamma_multiply(PALE)), self.text)]
    }

    /// A link in a text.
    pub(super) const fn link(&self) -> Color32 {
        self.short_period.text
    }

    /// Ground of words on the picture of the aircraft, which shows through a little.
    pub fn label_ground(&self) -> Color32 {
        self.pane.gamma_multiply(HIDES)
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
    pub const fn verdict(&self, stability: Stability) -> (Color32, Color32) {
        match stability {
            Stability::Stable => (self.good, self.good_ground),
            Stability::Neutral => (self.warning, self.warning_ground),
            Stability::Unstable => (self.bad, self.bad_ground),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::key::Keyed as _;
    use crate::words;

    const MODES: [ModeName; 23] = [
        ModeName::ShortPeriod,
        ModeName::ShortPeriodFastRoot,
        ModeName::ShortPeriodSlowRoot,
        ModeName::ThirdOscillatory,
        ModeName::Phugoid,
        ModeName::PhugoidFastRoot,
        ModeName::PhugoidSlowRoot,
        ModeName::PitchSubsidence,
        ModeName::PitchDivergence,
        ModeName::SpeedSubsidence,
        ModeName::SpeedDivergence,
        ModeName::DutchRoll,
        ModeName::DutchRollMoreStableRoot,
        ModeName::DutchRollLessStableRoot,
        ModeName::SideslipSubsidence,
        ModeName::DirectionalDivergence,
        ModeName::CoupledRollSpiral,
        ModeName::LateralOscillation,
        ModeName::RollSubsidence,
        ModeName::RollDivergence,
        ModeName::Spiral,
        ModeName::LateralSubsidence,
        ModeName::LateralDivergence,
    ];

    /// Relative luminance of WCAG 2.2, 0 of black to 1 of white.
    fn luminance(color: Color32) -> f64 {
        let linear = |c: u8| {
            let c = f64::from(c) / 255.0;
            if c <= 0.04045 { c / 12.92 } else { ((c + 0.055) / 1.055).powf(2.4) }
        };
        0.2126 * linear(color.r()) + 0.7152 * linear(color.g()) + 0.0722 * linear(color.b())
    }

    /// Contrast ratio of WCAG 2.2, 1 to 21.
    fn contrast(a: Color32, b: Color32) -> f64 {
        let (a, b) = (luminance(a), luminance(b));
        (a.max(b) + 0.05) / (a.min(b) + 0.05)
    }

    fn check(look: Look, least: f64, what: &str, color: Color32, grounds: &[Color32]) {
        for ground in grounds {
            let ratio = contrast(color, *ground);
            assert!(ratio >= least, "{look:?}: {what} {color:?} on {ground:?}: {ratio:.2}");
        }
    }

    #[test]
    fn contrast_is_that_of_wcag() {
        assert!((contrast(Color32::BLACK, Color32::WHITE) - 21.0).abs() < 1e-9);
        // The grey that is known to just pass on white.
        assert!((contrast(Color32::from_gray(0x76), Color32::WHITE) - 4.54).abs() < 0.01);
    }

    #[test]
    fn every_text_stands_out_from_every_ground_that_it_is_on() {
        for look in [Look::Light, Look::Dark, Look::Projector] {
            let p = look.palette();
            let halves = [p.stable_half, p.unstable_half];
            let grounds = [p.pane, p.field, p.background, halves[0], halves[1]];
            check(look, 4.5, "text", p.text, &grounds);
            check(look, 4.5, "weak", p.weak, &grounds);
            check(look, 4.5, "on strong", p.on_strong, &[p.strong]);
            check(look, 4.5, "link", p.link(), &grounds);
            check(look, 4.5, "nonlinear", p.nonlinear, &[p.pane]);
            for (what, color, ground) in [
                ("good", p.good, p.good_ground),
                ("bad", p.bad, p.bad_ground),
                ("warning", p.warning, p.warning_ground),
            ] {
                check(look, 4.5, what, color, &[ground, p.pane, p.field, p.background]);
            }
            for (p, name) in [p, look.unnamed_palette()].into_iter().flat_map(|p| MODES.map(|name| (p, name)))
            {
                check(look, 4.5, words::mode::title(name), p.mode_text(name), &grounds);
                for (bar, words) in p.bars(name) {
                    check(look, 4.5, "words on a bar", words, &[bar]);
                }
            }
        }
    }

    #[test]
    fn every_word_on_the_picture_stands_out_from_land_sky_and_aircraft_behind_its_ground() {
        for look in [Look::Light, Look::Dark, Look::Projector] {
            let p = look.palette();
            let behind = [p.sky[0], p.sky[1], p.ground[0], p.ground[1], p.field_on_ground]
                .into_iter()
                .chain(p.finishes)
                .map(|behind| behind.blend(p.label_ground()));
            let behind: Vec<Color32> = behind.collect();
            let words = [p.earth_axes, p.velocity, p.good, p.warning, p.text];
            for color in words.into_iter().chain(p.forces).chain(p.axes) {
                check(look, 4.5, "words on the picture", color, &behind);
            }
        }
    }

    #[test]
    fn a_look_is_chosen_once_it_is_set_and_known_by_its_key() {
        let ctx = egui::Context::default();
        assert_eq!(Look::chosen(&ctx), None);
        for look in [Look::Projector, Look::Dark, Look::Light] {
            look.set(&ctx);
            assert_eq!(Look::chosen(&ctx), Some(look));
            assert_eq!(Look::by_key(look.key()), Some(look));
        }
    }

    #[test]
    fn no_colour_tells_the_name_of_a_mode_where_names_are_hidden() {
        for look in [Look::Light, Look::Dark, Look::Projector] {
            let p = look.unnamed_palette();
            for name in MODES {
                assert_eq!((p.mode(name), p.mode_text(name)), (p.mode(MODES[0]), p.mode_text(MODES[0])));
                assert_eq!(p.bars(name), p.bars(MODES[0]));
            }
            assert_eq!(
                (p.pane, p.text, p.good),
                (look.palette().pane, look.palette().text, look.palette().good)
            );
        }
    }

    #[test]
    fn every_mark_stands_out_from_every_ground_that_it_is_on() {
        for look in [Look::Light, Look::Dark, Look::Projector] {
            let p = look.palette();
            let grounds = [p.pane, p.field, p.stable_half, p.unstable_half];
            check(look, 3.0, "pinned", p.pinned, &grounds);
            check(look, 3.0, "stability boundary", p.strong, &grounds);
            for name in MODES {
                check(look, 3.0, words::mode::title(name), p.mode(name), &grounds);
            }
        }
    }
}
