//! Phase portraits: one quantity over another, time only along the path; and the path that is flown.

use egui::Ui;

use super::curves::{self, units};
use super::legend::{self, Entry, Mark};
use super::time::grid;
use super::{CacheKey, Canvas, kept, output_ui};
use crate::findings::Findings;
use crate::flight::aircraft::plane::Plane;
use crate::flight::motion::outputs::Output;
use crate::ui::chart::{Curve, Pattern, PlotContent, PlotPoint, SmallPlot};

/// Samples in a turn of the fastest mode: with fewer a portrait would look like a polygon, since it shows each turn large,
/// however many there are.
const SAMPLES_A_TURN: f64 = 128.0;
/// No sample is divided into more than these.
const MOST_PARTS: f64 = 16.0;

/// Two portraits, one for the fast mode and one for the slow, and the path flown.
#[derive(Debug, Default)]
pub struct PhasePlots {
    plots: [SmallPlot; 3],
    pictures: Option<(Key, [PlotContent; 3])>,
}

type Key = (CacheKey, [(Output, Output); 2]);

impl PhasePlots {
    /// Draws both portraits and the path, with a dot where the motion is at the time `cursor` \[s\], and one where it ends.
    pub fn show(&mut self, ui: &mut Ui, canvas: Canvas<'_>, cursor: Option<f64>) {
        let Canvas { findings, palette, .. } = canvas;
        let Some(dt) = findings.flown_motion().map(|motion| motion.response.dt) else { return };
        let pairs = canvas.view.portraits[findings.scenario().plane];
        let key = (CacheKey::of(canvas), pairs);
        let pictures = kept(&mut self.pictures, key, || {
            let [left, right] = pairs.map(|pair| portrait(canvas, pair));
            [left, right, path(canvas)].map(|picture| canvas.veiled(picture))
        });
        for picture in pictures.iter_mut() {
            let now = cursor.and_then(|time| {
                let k = (time / dt).round() as usize * parts(findings);
                picture.curves.first()?.points.get(k).copied()
            });
            picture.dots = vec![(PlotPoint::new(0.0, 0.0), palette.weak)];
            let end = picture.curves.first().and_then(|curve| curve.full_part().last());
            picture.dots.extend(end.map(|place| (*place, palette.accent)));
            picture.dots.extend(now.map(|place| (place, palette.text)));
        }
        let mut entries = legend::curves(pictures);
        let dot = |color, name: &str| Entry { mark: Mark::Dot, color, name: name.to_owned() };
        entries.push(dot(palette.weak, "steady flight"));
        if pictures.iter().any(|picture| picture.dots.len() > 1) {
            entries.push(dot(palette.accent, "at the end"));
        }
        if pictures.iter().any(|picture| picture.dots.len() > 2) {
            entries.push(dot(palette.text, "at the cursor"));
        }
        legend::legend_ui(ui, &entries, canvas.beside);
        let places = grid(ui, pictures.len(), canvas.rows);
        for ((plot, picture), place) in self.plots.iter_mut().zip(pictures).zip(places) {
            plot.show(ui, place, picture, None);
        }
    }
}

/// Which pairs.
pub fn choosers_ui(ui: &mut Ui, plane: Plane, pairs: &mut [(Output, Output); 2]) {
    let choosers = [
        [("left-upward", "Left portrait, upward"), ("left-across", "Left portrait, across")],
        [("right-upward", "Right portrait, upward"), ("right-across", "Right portrait, across")],
    ];
    for ((over, of), [upward, across]) in pairs.iter_mut().zip(choosers) {
        output_ui(ui, upward.0, upward.1, plane, of);
        ui.label("against");
        output_ui(ui, across.0, across.1, plane, over);
        ui.add_space(12.0);
    }
}

/// One quantity over another, without its dots.
fn portrait(canvas: Canvas<'_>, pair: (Output, Output)) -> PlotContent {
    let Canvas { findings, pinned, view, palette, .. } = canvas;
    let (across, across_unit, across_si) = units(pair.0, findings.scenario());
    let (upward, upward_unit, upward_si) = units(pair.1, findings.scenario());
    let linear = |of: &Findings, pattern, color| {
        curves::portrait(of, parts(of), pair, (across_si, upward_si), pattern, color)
    };
    let mut drawn: Vec<Curve> = linear(findings, Pattern::Full, palette.text).into_iter().collect();
    let flown = |output, unit| curves::nonlinear(findings, output, unit, palette);
    if view.shows_flight()
        && let (Some(x), Some(y)) = (flown(pair.0, across_si), flown(pair.1, upward_si))
    {
        let points = x.points.iter().zip(&y.points).map(|(x, y)| PlotPoint::new(x.y, y.y)).collect();
        drawn.push(Curve::new(x.name, points, x.color, x.pattern));
    }
    drawn.extend(pinned.and_then(|pinned| linear(pinned, Pattern::Dashed, palette.pinned)));
    PlotContent {
        against: (across.symbol, across_unit),
        ..PlotContent::of_time(upward.symbol, upward_unit, drawn)
    }
}

/// The path over the Earth: the height over the distance flown, or the ground track.
fn path(canvas: Canvas<'_>) -> PlotContent {
    let Canvas { findings, pinned, palette, .. } = canvas;
    let path = |of: &Findings, pattern, color| curves::path(of, parts(of), pattern, color);
    let mut drawn: Vec<Curve> = path(findings, Pattern::Full, palette.text).into_iter().collect();
    if let Some(far) = drawn.first().and_then(|curve| curve.points.last()).map(|last| last.x) {
        drawn.extend(curves::ground(findings, 0.0..=far, 1.0, palette));
    }
    drawn.extend(pinned.and_then(|pinned| path(pinned, Pattern::Dashed, palette.pinned)));
    let symbol = match findings.scenario().plane {
        Plane::Longitudinal => "Δh",
        Plane::Lateral => "y",
    };
    PlotContent { against: ("x", "m"), ..PlotContent::of_time(symbol, "m", drawn) }
}

/// Into how many parts a sample is divided, so that the fastest mode is seen to turn.
fn parts(findings: &Findings) -> usize {
    let fastest = findings.flown_modes().iter().map(|mode| mode.lambda.norm()).fold(0.0, f64::max);
    let dt = findings.flown_motion().map_or(0.0, |motion| motion.response.dt);
    let turns_a_sample = fastest * dt / std::f64::consts::TAU;
    (SAMPLES_A_TURN * turns_a_sample).ceil().clamp(1.0, MOST_PARTS) as usize
}
