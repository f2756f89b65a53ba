//! The marks of a pole map: crosses, rings, diamonds, dotted paths.

use egui::{Color32, Painter, Pos2, Rect, Shape, Stroke, StrokeKind, Vec2};
use nalgebra::Complex;

use crate::flight::modes::approximations::Approximation;
use crate::flight::modes::locus::Locus;
use crate::flight::modes::mode::Mode;
use crate::flight::modes::mode_name::ModeName;
use crate::number::trimmed;
use crate::ui::chart::{Chart, spaced};
use crate::ui::labels::Placement;
use crate::ui::theme::Palette;

/// Half the size of the cross of a pole.
pub const CROSS: f32 = 6.5;

/// Does the same for a pole and, of a pair, its conjugate.
pub fn both(pole: Complex<f64>, mut each: impl FnMut(Complex<f64>)) {
    each(pole);
    if pole.im != 0.0 {
        each(pole.conj());
    }
}

/// A cross.
pub fn cross(painter: &Painter, at: Pos2, size: f32, width: f32, color: Color32) {
    let arm = Vec2::splat(size * std::f32::consts::FRAC_1_SQRT_2);
    let other = Vec2::new(arm.x, -arm.y);
    painter.line_segment([at - arm, at + arm], Stroke::new(width, color));
    painter.line_segment([at - other, at + other], Stroke::new(width, color));
}

/// The crosses of a mode.
pub fn mode(painter: &Painter, chart: &Chart, palette: &Palette, mode: &Mode) {
    let color = palette.mode(mode.naming.name);
    both(mode.lambda, |pole| cross(painter, chart.position(pole), CROSS, 2.2, color));
}

/// A hollow ring: where a pole is or was in another state.
pub fn ring(painter: &Painter, chart: &Chart, pole: Complex<f64>, color: Color32) {
    both(pole, |pole| {
        painter.circle_stroke(chart.position(pole), 5.0, Stroke::new(1.5, color));
    });
}

/// Half the size of a hollow square.
const SQUARE: f32 = 4.5;

/// A hollow square: a pole of the other state of a loop, closed or open.
pub fn square(painter: &Painter, at: Pos2, color: Color32) {
    let place = Rect::from_center_size(at, Vec2::splat(2.0 * SQUARE));
    painter.rect_stroke(place, 0.0, Stroke::new(1.4, color), StrokeKind::Middle);
}

/// A hollow diamond: what an approximation says.
pub fn diamond(painter: &Painter, at: Pos2, color: Color32) {
    let corner = |x: f32, y: f32| at + Vec2::new(x, y) * 6.0;
    let corners = vec![corner(0.0, -1.0), corner(1.0, 0.0), corner(0.0, 1.0), corner(-1.0, 0.0)];
    painter.add(Shape::closed_line(corners, Stroke::new(1.5, color)));
}

/// The approximations that are marked: one a mode, where it gives a root.
pub fn approximated(
    approximations: &[Approximation],
) -> impl Iterator<Item = (&Approximation, Complex<f64>)> {
    approximations.iter().filter(|a| a.name.is_principal()).filter_map(|a| Some((a, a.root()?)))
}

/// What is to be seen of a pole's path, and the name of its mode at the reference value.
pub type Path = (Option<ModeName>, Vec<Pos2>);

/// What is to be seen of each pole's path, broken where there is no such aircraft.
pub fn paths(chart: &Chart, locus: &Locus) -> Vec<Path> {
    let of_branch = |(branch, name): (usize, &Option<ModeName>)| {
        let name = *name;
        let runs = locus.samples.split(|sample| sample.poles.is_none());
        runs.flat_map(move |run| {
            let poles = run.iter().filter_map(|sample| sample.poles.as_ref());
            let poles = poles.filter_map(move |poles| poles.get(branch).copied());
            chart.clipped(poles).into_iter().map(move |part| (name, part))
        })
    };
    locus.names.iter().enumerate().flat_map(of_branch).collect()
}

/// Draws paths dotted, each in the colour of its mode.
pub fn dotted(painter: &Painter, palette: &Palette, paths: &[Path]) {
    for (name, path) in paths {
        let color = name.map_or(palette.pinned, |name| palette.mode(name)).gamma_multiply(0.65);
        painter.extend(Shape::dotted_line(path, color, 4.0, 1.1));
    }
}

/// A round value of a parameter on its path.
#[derive(Debug)]
pub struct RoundValue {
    /// The value as it is written; empty where another branch has it.
    pub text: String,
    /// The mode at the reference value whose path it is on.
    pub name: Option<ModeName>,
    /// Where.
    pub at: Pos2,
}

/// Distance of numbers beside a path, so that each can be read \[points\].
const APART: f32 = 26.0;

/// Multiples of `step` \[SI\] on every branch that is on screen; the numbers, in units of `unit`, stand on the branch that goes
/// farthest. Also how many stand there.
pub fn round_values(chart: &Chart, locus: &Locus, (step, unit): (f64, f64)) -> (Vec<RoundValue>, usize) {
    let (Some(first), Some(last)) = (locus.samples.first(), locus.samples.last()) else {
        return (Vec::new(), 0);
    };
    let (from, to) = ((first.parameter / step).ceil() as i32, (last.parameter / step).floor() as i32);
    let mut found = Vec::new();
    let mut best: (f32, usize) = (0.0, 0);
    for (branch, name) in locus.names.iter().enumerate() {
        let at = |k: i32| {
            let value = f64::from(k) * step;
            let pair = locus.samples.windows(2).find(|pair| pair[1].parameter >= value)?;
            let (before, after) =
                (pair[0].poles.as_ref()?.get(branch)?, pair[1].poles.as_ref()?.get(branch)?);
            let share = (value - pair[0].parameter) / (pair[1].parameter - pair[0].parameter);
            let at = chart.position(before + (after - before) * share.clamp(0.0, 1.0));
            chart.rect.contains(at).then_some((k, at))
        };
        let on_branch: Vec<(i32, Pos2)> = (from..=to).filter_map(at).collect();
        let way: f32 = on_branch.windows(2).map(|pair| pair[0].1.distance(pair[1].1)).sum();
        let is_upper = on_branch.iter().all(|(_, at)| at.y <= chart.position(Complex::from(0.0)).y + 1.0);
        if way > best.0 && is_upper {
            best = (way, branch);
        }
        found.extend(
            on_branch
                .into_iter()
                .map(|(k, at)| (branch, k, RoundValue { text: String::new(), name: *name, at })),
        );
    }
    let mut written: Vec<Pos2> = Vec::new();
    for (_, k, value) in found.iter_mut().filter(|(branch, ..)| *branch == best.1) {
        if written.iter().all(|other| other.distance(value.at) >= APART) {
            value.text = trimmed(f64::from(*k) * step / unit, 3);
            written.push(value.at);
        }
    }
    (found.into_iter().map(|(_, _, value)| value).collect(), written.len())
}

/// Keeps labels off paths, where there is room elsewhere.
pub fn shun(placement: &mut Placement, paths: &[Path]) {
    for at in paths.iter().flat_map(|(_, path)| spaced(path, 6.0)) {
        placement.shun(Rect::from_center_size(at, Vec2::splat(3.0)));
    }
}

/// Where a drag wants the pole that could not follow: a dashed ring, and a dashed line to it.
pub fn target(painter: &Painter, from: Pos2, to: Pos2, color: Color32) {
    const RADIUS: f32 = 8.0;
    let way = to - from;
    if way.length() > RADIUS {
        let end = to - way.normalized() * RADIUS;
        painter.extend(Shape::dashed_line(&[from, end], Stroke::new(1.2, color), 3.0, 3.0));
    }
    let corner = |k: i32| to + RADIUS * Vec2::angled(std::f32::consts::TAU * k as f32 / 24.0);
    let circle: Vec<Pos2> = (0..=24).map(corner).collect();
    painter.extend(Shape::dashed_line(&circle, Stroke::new(1.4, color), 3.5, 2.5));
}
