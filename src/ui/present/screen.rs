//! The screen: how large type is on it, and where words and panes stand.

use egui::{Rect, Ui, Vec2};

use super::setting::{Measured, Setting};
use super::words::{LEVELS, Piece};
use crate::scenario::view::Pane;
use crate::scenario::{Part, View};
use crate::ui::responses::height_for_a_room;

/// Height of every screen \[points\]: text that explains then has letters of 1.78 % of it, and a curve is four pixels wide of 1080.
pub const HEIGHT: f32 = 470.0;
/// Width of the narrowest: a phone held upright has more below.
const NARROWEST: f32 = 360.0;
/// Smallest and largest zoom.
const ZOOMS: [f32; 2] = [0.4, 8.0];
/// Between words and panes, and between panes.
pub const GAP: f32 = 14.0;
/// Sizes of type that the words of a slide may have, the largest that has room first \[points\].
const SIZES: [f32; 8] = [24.0, 22.0, 20.0, 18.0, 16.5, 15.0, 14.0, 13.0];
/// The same of a slide that asks nothing.
const OF_TEXT: [f32; 5] = [18.0, 16.5, 15.0, 14.0, 13.0];
/// Words beside panes: their share of the width, and least and greatest width.
const BESIDE: f32 = 0.4;
const WIDTHS: [f32; 2] = [240.0, 400.0];
/// Least height that a response needs for its plots, however few.
const PLOTS: f32 = 168.0;
/// What a response needs above its plots: the words for the disturbance, the legend, and the sentence that tells where the linear model ends.
const ABOVE_PLOTS: [f32; 3] = [24.0, 18.0, 36.0];
/// Panes with less than this share of what they need are no use.
const USELESS: f32 = 0.62;
/// With this share they can be read well.
const ENOUGH: f32 = 0.9;
/// Words that are set for the answer too are no smaller than this \[points\].
const COMFORTABLE: f32 = 15.0;
/// Longest line, in sizes of the type.
const LONGEST: f32 = 40.0;

/// Zoom at which a screen has its height in points; `ui` has it at the zoom in force.
pub fn zoom(ui: &Ui) -> f32 {
    let size = ui.content_rect().size() * ui.zoom_factor();
    (size.y / HEIGHT).min(size.x / NARROWEST).clamp(ZOOMS[0], ZOOMS[1])
}

/// The panes of a stage for a room, no more than three.
pub fn panes(view: &View) -> Vec<Part> {
    if let Some(pane) = view.maximised {
        return vec![match pane {
            Pane::Poles => Part::Poles,
            Pane::Aircraft => Part::Aircraft,
            Pane::Response => Part::Response,
            Pane::Equations => Part::Equations,
        }];
    }
    let order = [Part::Equations, Part::Poles, Part::Aircraft, Part::Response, Part::Modes];
    order.into_iter().filter(|part| view.stage.has(*part)).take(3).collect()
}

/// Small plots of the response.
#[derive(Clone, Copy, Debug, Default)]
pub struct Plots {
    /// How many there are.
    pub count: usize,
    /// Whether a legend stands above them.
    pub has_legend: bool,
    /// Whether a sentence does that tells where the linear model ends.
    pub has_end: bool,
}

/// Least room that a pane needs to be read in a place of this size.
fn needs(part: Part, plots: Plots, size: Vec2) -> Vec2 {
    match part {
        Part::Equations => Vec2::new(400.0, 190.0),
        Part::Poles => Vec2::new(250.0, 190.0),
        Part::Aircraft => Vec2::new(220.0, 160.0),
        Part::Response => {
            let [caption, legend, end] = ABOVE_PLOTS;
            let above =
                caption + if plots.has_legend { legend } else { 0.0 } + if plots.has_end { end } else { 0.0 };
            let height = height_for_a_room(size - Vec2::new(0.0, above), plots.count).max(PLOTS);
            // All of them where the panes have enough.
            Vec2::new(230.0, (height + above) / ENOUGH)
        }
        Part::Modes => Vec2::new(200.0, 250.0),
        Part::Derivatives => Vec2::ZERO,
    }
}

/// Where panes stand in a room: beside each other, below each other where it is high, the third below the second.
pub fn places(panes: &[Part], room: Rect, plots: Plots) -> Vec<(Part, Rect)> {
    match panes {
        [] => Vec::new(),
        [one] => vec![(*one, room)],
        [first, second] => {
            let [beside, below] = [halves(room, true), halves(room, false)];
            let least = |halves: [Rect; 2]| fit(*first, plots, halves[0]).min(fit(*second, plots, halves[1]));
            let [a, b] = if least(beside) >= least(below) { beside } else { below };
            vec![(*first, a), (*second, b)]
        }
        [first, rest @ ..] => {
            let is_wide = room.width() > 1.1 * room.height();
            let [a, b] = halves(room, is_wide);
            let mut places = vec![(*first, a)];
            let [c, d] = halves(b, !is_wide);
            places.extend(rest.iter().copied().zip([c, d]));
            places
        }
    }
}

fn halves(room: Rect, beside: bool) -> [Rect; 2] {
    let gap = 0.5 * GAP;
    if beside {
        let (a, b) = room.split_left_right_at_fraction(0.5);
        [a.with_max_x(a.right() - gap), b.with_min_x(b.left() + gap)]
    } else {
        let (a, b) = room.split_top_bottom_at_fraction(0.5);
        [a.with_max_y(a.bottom() - gap), b.with_min_y(b.top() + gap)]
    }
}

/// How much of the room that it needs something has.
fn fit(part: Part, plots: Plots, room: Rect) -> f32 {
    let needs = needs(part, plots, room.size());
    (room.width() / needs.x).min(room.height() / needs.y)
}

impl Content<'_> {
    /// Whether there is anything beside words.
    fn has_panes(&self) -> bool {
        !self.panes.is_empty() || self.sliders > 0
    }

    /// How much of what they need the panes have in a room.
    fn share(&self, scene: Rect) -> f32 {
        let sliders = super::sliders_height(self.sliders, scene.width());
        let room = scene.with_max_y(scene.bottom() - sliders);
        let each = places(self.panes, room, self.plots).into_iter();
        each.map(|(part, place)| fit(part, self.plots, place)).fold(f32::INFINITY, f32::min)
    }
}

/// Words that are set, where they stand, and the room of the panes.
pub struct Arranged {
    /// The words.
    pub words: Setting,
    /// Their room.
    pub at: Rect,
    /// Room of the panes; nothing where there are none.
    pub scene: Option<Rect>,
}

/// What is to be arranged on a screen.
#[derive(Clone, Copy, Debug)]
pub struct Content<'a> {
    /// The panes.
    pub panes: &'a [Part],
    /// Small plots of the response.
    pub plots: Plots,
    /// How many sliders there are.
    pub sliders: usize,
    /// Whether the slide asks something.
    pub asks: bool,
}

/// How words are arranged.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Plan {
    /// How much of what they need the panes have.
    share: f32,
    /// Size of type.
    size: f32,
    /// Whether they stand beside the panes, not above them.
    is_beside: bool,
    /// How much is written.
    level: usize,
}

/// Words as large as they can be with panes that can be read: beside them, or above them. Where all of the words have no room in the
/// smallest type, there are fewer of them.
///
/// `pieces` are those at a level that are on screen; `whole` are those once the slide is answered, so that nothing moves then.
pub fn arranged<'a>(
    ui: &Ui,
    room: Rect,
    content: Content<'_>,
    pieces: impl Fn(usize) -> Vec<Piece<'a>>,
    whole: impl Fn(usize) -> Vec<Piece<'a>>,
    measured: Measured<'_>,
) -> Arranged {
    let of_whole = plan(ui, room, content, &whole, measured).filter(|plan| plan.size >= COMFORTABLE);
    let set = |plan: Plan| laid(ui, room, content, &pieces(plan.level), plan, measured);
    if let Some((plan, arranged)) = of_whole.and_then(|plan| Some((plan, set(plan)?))) {
        // The place of the answer is kept free, so that no plot has to leave for it.
        let whole = laid(ui, room, content, &whole(plan.level), plan, measured);
        return Arranged { scene: whole.map_or(arranged.scene, |whole| whole.scene), ..arranged };
    }
    if let Some(arranged) = plan(ui, room, content, &pieces, measured).and_then(set) {
        return arranged;
    }
    let pieces = pieces(LEVELS - 1);
    let has_panes = content.has_panes();
    if pieces.is_empty() {
        return Arranged { words: Setting::default(), at: room, scene: has_panes.then_some(room) };
    }
    // As many of them as there is room for.
    let (at, scene) = if has_panes { beside(room) } else { (room, room) };
    let (words, _) = Setting::of(ui, &pieces, (SIZES[SIZES.len() - 1], at.width(), at.height()), measured);
    Arranged { words, at, scene: has_panes.then_some(scene) }
}

/// The way to arrange words in the largest type that leaves the panes room enough; without one that which leaves them most.
fn plan<'a>(
    ui: &Ui,
    room: Rect,
    content: Content<'_>,
    pieces: impl Fn(usize) -> Vec<Piece<'a>>,
    measured: Measured<'_>,
) -> Option<Plan> {
    let sizes: &[f32] = if content.asks { &SIZES } else { &OF_TEXT };
    let mut best: Option<Plan> = None;
    for level in 0..LEVELS {
        let pieces = pieces(level);
        if pieces.is_empty() {
            continue;
        }
        for &size in sizes {
            let each = [true, false].map(|is_beside| Plan { share: 0.0, size, is_beside, level });
            for mut plan in each {
                let Some(arranged) = laid(ui, room, content, &pieces, plan, measured) else { continue };
                plan.share = arranged.scene.map_or(1.0, |scene| content.share(scene));
                if best.is_none_or(|best| plan.share > best.share) {
                    best = Some(plan);
                }
            }
            if best.is_some_and(|best| best.share >= ENOUGH) {
                return best;
            }
        }
        if best.is_some_and(|best| best.share >= USELESS) {
            return best;
        }
    }
    best
}

/// Words as a plan has them, if all of them have room.
fn laid(
    ui: &Ui,
    room: Rect,
    content: Content<'_>,
    pieces: &[Piece<'_>],
    plan: Plan,
    measured: Measured<'_>,
) -> Option<Arranged> {
    let set = |at: Rect| {
        let (words, is_all) = Setting::of(ui, pieces, (plan.size, at.width(), at.height()), measured);
        is_all.then_some(words)
    };
    if !content.has_panes() {
        // Lines that are too long are hard to read.
        let at = room.with_max_x(room.left() + room.width().min(LONGEST * plan.size));
        return set(at).map(|words| Arranged { words, at, scene: None });
    }
    if plan.is_beside {
        let (at, scene) = beside(room);
        return set(at).map(|words| Arranged { words, at, scene: Some(scene) });
    }
    let words = set(room)?;
    let (at, scene) = room.split_top_bottom_at_y(room.top() + words.height);
    let scene = scene.with_min_y(scene.top() + GAP);
    scene.is_positive().then_some(Arranged { words, at, scene: Some(scene) })
}

/// Words on the left, panes on the right; on a narrow screen below.
fn beside(room: Rect) -> (Rect, Rect) {
    let width = (BESIDE * room.width()).clamp(WIDTHS[0], WIDTHS[1]);
    let (at, scene) = room.split_left_right_at_x(room.left() + width);
    (at, scene.with_min_x(scene.left() + 1.4 * GAP))
}
