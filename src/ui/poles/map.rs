//! One of the two maps: what is drawn on it, in which order, with labels that never collide.

use egui::{Align2, FontId, Painter, Pos2, Rect, Stroke, StrokeKind, Ui, Vec2};
use nalgebra::Complex;

use super::chart::{Chart, View};
use super::drag::{Held, Outcome};
use super::labels::Placement;
use super::trail::Trail;
use super::{NARROW, Seen, boundaries, grid, marks};
use crate::flight::level_boundaries::Boundary;
use crate::flight::modes::{DynamicStability, Mode};
use crate::number::{fixed, round_up, significant};
use crate::ui::theme::{self, Palette};

/// Room above a map for its name and its buttons.
pub const CAPTION: f32 = 18.0;

/// Space that a mark keeps clear of labels.
const MARK: f32 = 14.0;

/// One of the two maps.
#[derive(Debug)]
pub struct Map<'a> {
    /// What it is called.
    pub name: &'static str,
    /// With its caption.
    pub rect: Rect,
    /// Indices of the modes that its range is made for.
    pub ranged: Vec<usize>,
    /// Indices of the modes that are reached here by keyboard, and whose levels are drawn here.
    pub home: Vec<usize>,
    /// The modes.
    pub modes: &'a [Mode],
}

/// What is drawn beside the poles.
#[derive(Clone, Copy, Debug)]
pub struct Extras<'a> {
    /// Where the poles came from.
    pub trail: &'a Trail,
    /// Whether approximations are marked.
    pub approximations: bool,
    /// Boundaries of levels.
    pub boundaries: &'a [Boundary],
    /// The pole that is held on this map.
    pub held: Option<&'a Held>,
    /// What came of it.
    pub outcome: Option<&'a Outcome>,
    /// The mode that stands out.
    pub lit: Option<usize>,
    /// What the other map shows, drawn as a frame in this one.
    pub inset: Option<View>,
    /// A place at the foot that a sentence takes.
    pub taken: Option<Rect>,
}

impl Map<'_> {
    /// The map without its caption.
    pub fn plot_rect(&self) -> Rect {
        let mut rect = self.rect;
        rect.min.y += CAPTION;
        rect
    }

    /// The part of the plane that holds its modes with room for labels, in round numbers.
    pub fn wanted_view(&self) -> View {
        let largest =
            |part: fn(&Mode) -> f64| self.ranged.iter().map(|&i| part(&self.modes[i])).fold(0.0, f64::max);
        let (left, right) = (largest(|m| -m.lambda.re), largest(|m| m.lambda.re));
        let reach = left.max(right).max(largest(|m| m.lambda.im)).max(1e-3);
        let top = round_up((1.3 * largest(|m| m.lambda.im)).max(0.35 * reach));
        View {
            left: -round_up((1.25 * left).max(0.5 * reach)),
            right: round_up((1.3 * right).max(0.22 * reach)),
            bottom: -top,
            top,
        }
    }

    /// The boundaries that are drawn here.
    pub fn boundaries<'b>(&self, boundaries: &'b [Boundary]) -> impl Iterator<Item = &'b Boundary> {
        let here =
            |boundary: &&Boundary| self.home.iter().any(|&i| boundary.concerns(self.modes[i].naming.name));
        boundaries.iter().filter(here)
    }

    /// Draws it.
    pub fn draw(
        &self,
        ui: &Ui,
        palette: &'static Palette,
        chart: &Chart,
        seen: &Seen<'_>,
        extras: Extras<'_>,
    ) {
        let rect = chart.rect;
        let caption = self.rect.min + Vec2::new(0.0, 0.5 * CAPTION - 1.0);
        let name = self.name.split(',').next().filter(|_| rect.width() < NARROW).unwrap_or(self.name);
        ui.painter().text(caption, Align2::LEFT_CENTER, name, theme::small(), palette.weak);
        let painter = ui.painter_at(rect);
        let home = || self.boundaries(extras.boundaries);
        grid::draw(&painter, self.name, chart, palette);
        boundaries::draw(&painter, chart, palette, home());
        if let Some(inset) = extras.inset {
            frame(&painter, chart, palette, inset);
        }
        if let Some((_, locus)) = seen.locus {
            marks::path(&painter, chart, palette, locus);
        }
        extras.trail.draw(&painter, chart, palette);
        for mode in seen.ghost.into_iter().flatten() {
            marks::ring(&painter, chart, mode.lambda, palette.ghost);
        }
        let approximated =
            || marks::approximated(&seen.plane.approximations).filter(|_| extras.approximations);
        for (approximation, root) in approximated() {
            let color = palette.mode(approximation.name.concerns());
            marks::both(root, |root| marks::diamond(&painter, chart.position(root), color));
        }
        held(&painter, chart, palette, extras.held, extras.outcome);
        for (i, mode) in self.modes.iter().enumerate() {
            if extras.lit == Some(i) {
                let halo = palette.mode(mode.naming.name).gamma_multiply(0.18);
                marks::both(mode.lambda, |pole| {
                    painter.circle_filled(chart.position(pole), 12.0, halo);
                });
            }
            marks::mode(&painter, chart, palette, mode);
        }

        let mut placement = Placement::new(rect.shrink(3.0));
        let mut clear = |at: Complex<f64>| {
            marks::both(at, |at| {
                placement.keep_clear(Rect::from_center_size(chart.position(at), Vec2::splat(MARK)));
            });
        };
        self.modes.iter().for_each(|mode| clear(mode.lambda));
        seen.ghost.into_iter().flatten().for_each(|mode| clear(mode.lambda));
        approximated().for_each(|(_, root)| clear(root));
        // No label across the stability boundary.
        let origin = chart.position(Complex::from(0.0));
        placement.keep_clear(Rect::from_center_size(origin, Vec2::new(2.0, 4.0 * rect.height())));
        extras.taken.into_iter().for_each(|taken| placement.keep_clear(taken));
        boundaries::keep_clear(chart, &mut placement, home());
        if let Some((_, locus)) = seen.locus {
            marks::shun_path(chart, &mut placement, locus);
        }
        for mode in self.modes {
            let anchor = chart.position(mode.lambda);
            if rect.contains(anchor) {
                let brief = extras.inset.is_some_and(|inset| crowded(mode, chart.view, inset));
                label(&painter, palette, &mut placement, anchor, mode, brief);
            }
        }
        boundaries::labels(&painter, chart, palette, &mut placement, home());
        grid::labels(&painter, chart, palette, &mut placement);
        ui.painter().rect_stroke(rect, 4.0, Stroke::new(1.0, palette.hairline), StrokeKind::Inside);
    }

    /// What the map shows, in words.
    pub fn describe(&self) -> String {
        let words = |mode: &Mode| format!("{} {}", mode.naming.name.text(), numbers(mode));
        let modes: Vec<String> = self.modes.iter().map(words).collect();
        format!("Pole map, {}: {}", self.name, modes.join("; "))
    }
}

/// Whether a mode belongs to the other map, where there is room for its numbers.
fn crowded(mode: &Mode, view: View, inset: View) -> bool {
    let within = |x: f64, low: f64, high: f64| low < x && x < high;
    inset.top - inset.bottom < 0.3 * (view.top - view.bottom)
        && within(mode.lambda.re, inset.left, inset.right)
        && within(mode.lambda.im, inset.bottom, inset.top)
}

/// The frame of what the other map shows.
fn frame(painter: &Painter, chart: &Chart, palette: &Palette, inset: View) {
    let corners = [(inset.left, inset.top), (inset.right, inset.bottom)];
    let [min, max] = corners.map(|(re, im)| chart.position(Complex::new(re, im)));
    painter.rect_stroke(
        Rect::from_min_max(min, max),
        0.0,
        Stroke::new(1.0, palette.ghost),
        StrokeKind::Middle,
    );
}

/// Where a held pole was, and where it is wanted but can't follow.
fn held(painter: &Painter, chart: &Chart, palette: &Palette, held: Option<&Held>, outcome: Option<&Outcome>) {
    let Some(held) = held else { return };
    marks::ring(painter, chart, held.mode.lambda, palette.mode(held.mode.naming.name).gamma_multiply(0.7));
    if let Some(outcome) = outcome.filter(|outcome| outcome.obstacle.is_some()) {
        let [from, to] = [outcome.lambda, outcome.wanted].map(|at| chart.position(held.side(at)));
        marks::target(painter, from, to, palette.mode(outcome.name));
    }
}

/// Name and the two numbers that matter most, beside a pole; the name alone where there is no room for more.
fn label(
    painter: &Painter,
    palette: &Palette,
    placement: &mut Placement,
    anchor: Pos2,
    mode: &Mode,
    brief: bool,
) {
    let color = palette.mode(mode.naming.name);
    let text = |text: String, font: FontId| painter.layout_no_wrap(text, font, color);
    if !brief {
        let name = text(mode.naming.name.text().to_owned(), theme::semibold(12.5));
        let numbers = text(numbers(mode), FontId::proportional(11.0));
        let size = Vec2::new(name.size().x.max(numbers.size().x), name.size().y + numbers.size().y);
        if let Some(place) = placement.beside(anchor, size) {
            let below = place.min + Vec2::new(0.0, name.size().y);
            painter.galley(place.min, name, color);
            painter.galley(below, numbers, color);
            return;
        }
    }
    let name = text(mode.naming.name.text().to_owned(), theme::semibold(11.5));
    if let Some(place) = placement.beside(anchor, name.size()) {
        painter.galley(place.min, name, color);
    }
}

/// "ζ 0.69 · 2.4 s" of an oscillation, the time to half or double of a real root.
fn numbers(mode: &Mode) -> String {
    let numbers = match (mode.damping_ratio(), mode.period()) {
        (Some(zeta), Some(period)) => format!("ζ {} · T {} s", fixed(zeta, 2), significant(period, 3)),
        _ => match (mode.time_to_half(), mode.time_to_double()) {
            (Some(t), _) => format!("halves in {} s", significant(t, 2)),
            (_, Some(t)) => format!("doubles in {} s", significant(t, 2)),
            _ => "neutral".to_owned(),
        },
    };
    if mode.is_oscillatory() && mode.stability == DynamicStability::Unstable {
        format!("{numbers} · unstable")
    } else {
        numbers
    }
}
