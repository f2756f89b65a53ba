//! The loop of a control, cut before its actuator: over frequency, with its margins, and as Nyquist's curve around −1.

use std::f64::consts::PI;

use egui::{Color32, RichText, Ui};
use nalgebra::Complex;

use super::fraction::Laid;
use super::legend::{self, Entry, Mark};
use super::stack::Stack;
use super::time::tall_grid;
use super::{CacheKey, Canvas, kept};
use crate::findings::Findings;
use crate::flight::Channel;
use crate::flight::aircraft::plane::Plane;
use crate::flight::feedback::loop_curve::LoopCurve;
use crate::flight::modes::stability::Stability;
use crate::flight::motion::frequency_response::FrequencyPoint;
use crate::scenario::view::Tab;
use crate::scenario::{Hidden, Quantity};
use crate::ui::chart::{Curve, Pattern, PlotContent, PlotPoint, Scale, SmallPlot};
use crate::ui::derivatives::Rows;
use crate::ui::theme::{self, Palette};
use crate::words::loops as words;
use crate::words::transfer_function::{Fraction, fraction, zeros_on_the_right};

/// A loop that reaches no further is seen whole around −1.
const NEAR: f64 = 2.5;
/// A loop is shown as far as this, though an integrator goes on for ever.
const FAR: f64 = 30.0;
/// Points of a circle.
const CIRCLE: u32 = 96;

/// Both pictures of a loop.
#[derive(Debug, Default)]
pub struct LoopPlots {
    stack: Stack,
    plots: [SmallPlot; 2],
    sheet: Option<((CacheKey, usize), Sheet)>,
}

/// What is drawn and said of a loop.
#[derive(Debug)]
struct Sheet {
    bode: ([PlotContent; 2], Vec<Entry>),
    nyquist: (Vec<PlotContent>, Vec<Entry>),
    margins: Vec<String>,
    count: String,
    fraction: Option<Fraction>,
    remark: Option<String>,
}

/// The input whose loop is shown: the one asked for, or else the other.
pub fn input_shown(findings: &Findings, asks_second: bool) -> Option<usize> {
    let asked = usize::from(asks_second);
    let closed = &findings.closed_loop()?.as_ref().ok()?.closed;
    [asked, 1 - asked].into_iter().find(|&input| closed.is_driven(input))
}

/// Whose loop is cut, where there are two.
pub fn choosers_ui(ui: &mut Ui, findings: &Findings, cuts_second: &mut bool) {
    let plane = findings.scenario().plane;
    let input = input_shown(findings, *cuts_second);
    let name = |input: usize| control(plane, input).name;
    ui.label("Cut at the");
    if input_shown(findings, false) != input_shown(findings, true) {
        for second in [false, true] {
            let is_shown = input == Some(usize::from(second));
            if ui.selectable_label(is_shown, name(usize::from(second))).clicked() {
                *cuts_second = second;
            }
        }
    } else {
        ui.label(input.map_or("", name));
    }
}

/// A control by its place.
fn control(plane: Plane, input: usize) -> Quantity {
    Quantity::of_input(plane, if input == 0 { Channel::First } else { Channel::Second })
}

impl LoopPlots {
    /// Draws a loop as the tab has it.
    pub fn show(&mut self, ui: &mut Ui, canvas: Canvas<'_>) {
        let Canvas { findings, view, curtain, .. } = canvas;
        let plane = findings.scenario().plane;
        let Some(input) = input_shown(findings, view.cuts_second[plane]) else { return };
        let Some(curve) = findings.loop_curve(input) else { return };
        let sheet = kept(&mut self.sheet, (CacheKey::of(canvas), input), || Sheet::of(canvas, curve));
        let is_told = !curtain.hides_values() && !curtain.hides_any(&[Hidden::Verdicts, Hidden::Curves]);
        let said = |ui: &mut Ui, text: &str, color: Color32| {
            ui.label(RichText::new(text).font(theme::semibold(theme::sizes(ui).small)).color(color));
            ui.add_space(10.0);
        };
        let palette = Palette::of(ui);
        if is_told {
            let contents = |ui: &mut Ui| {
                if view.tab == Tab::Nyquist {
                    said(ui, &sheet.count, palette.text);
                    // The rest stands beside the curve over frequency.
                    said(ui, sheet.margins.last().map_or("", String::as_str), palette.weak);
                } else {
                    sheet.margins.iter().for_each(|margin| said(ui, margin, palette.text));
                }
            };
            match canvas.rows {
                Rows::Dense => ui.horizontal_wrapped(contents),
                Rows::Touch => ui.vertical(contents),
            };
        }
        if view.tab == Tab::Nyquist {
            let (pictures, entries) = &mut sheet.nyquist;
            legend::legend_ui(ui, entries, canvas.beside);
            let places = tall_grid(ui, pictures.len(), canvas.rows);
            for ((plot, picture), place) in self.plots.iter_mut().zip(pictures).zip(places) {
                plot.show(ui, place, picture, None);
            }
            return;
        }
        let (pictures, entries) = &mut sheet.bode;
        legend::legend_ui(ui, entries, canvas.beside);
        let fraction = sheet.fraction.as_ref().filter(|_| is_told && !theme::is_for_a_room(ui));
        let laid = fraction.map(|fraction| Laid::of(ui, "L", fraction, sheet.remark.as_deref()));
        let below = laid.as_ref().map_or(0.0, |laid| laid.height() + ui.spacing().item_spacing.y);
        self.stack.show(ui, pictures, canvas.rows, below);
        if let Some(laid) = laid {
            laid.show(ui);
        }
    }
}

impl Sheet {
    fn of(canvas: Canvas<'_>, curve: &LoopCurve) -> Self {
        let closed = canvas.findings.closed_loop().and_then(|closed| closed.as_ref().ok());
        let stability = closed.map_or(Stability::Neutral, |closed| closed.dynamic_stability);
        let is_stable = stability != Stability::Unstable;
        let LoopCurve { margins, transfer, function, .. } = curve;
        Self {
            bode: bode(canvas, curve),
            nyquist: nyquist(canvas, curve),
            margins: vec![
                words::gain_margin(margins, is_stable),
                words::phase_margin(margins.phase, is_stable),
                words::sensitivity(margins.sensitivity),
            ],
            count: words::nyquist(margins.turns, transfer.growing(), stability),
            fraction: function.as_ref().map(|function| fraction(function, 1.0)),
            remark: function.as_ref().and_then(zeros_on_the_right),
        }
    }
}

fn entry(mark: Mark, color: Color32, name: &str) -> Entry {
    Entry { mark, color, name: name.to_owned() }
}

/// |L| and the phase of L, with the margins as upright lines between the curves and what they must not reach.
fn bode(canvas: Canvas<'_>, of: &LoopCurve) -> ([PlotContent; 2], Vec<Entry>) {
    let Canvas { findings, palette, curtain, .. } = canvas;
    let margins = &of.margins;
    let (low, high) = findings.frequency_range();
    let fastest = of.transfer.poles.iter().map(|pole| pole.norm()).fold(high, f64::max);
    let range = (low.log10(), (2.0 * fastest).log10().ceil().min(4.0).max(high.log10()));
    let curve = |value: &dyn Fn(&FrequencyPoint) -> f64| {
        let points = of.points.iter().map(|point| PlotPoint::new(point.frequency.log10(), value(point)));
        let points = points.filter(|point| (range.0..=range.1).contains(&point.x)).collect();
        Curve::new("loop", points, palette.text, Pattern::Full)
    };
    let picture = |unit: &str, curve| PlotContent {
        against: ("ω", "rad/s"),
        x_range: Some(range.0..=range.1),
        scales: (Scale::Decades, Scale::Even),
        ..PlotContent::of_time("L", unit, vec![curve])
    };
    let decibels = |point: &FrequencyPoint| (20.0 * point.value.norm().log10()).clamp(-400.0, 400.0);
    let mut gain = picture("dB", curve(&decibels));
    let mut phase = picture("deg", curve(&|point| point.phase.to_degrees()));
    phase.with_zero = false;
    phase.scales.1 = Scale::RightAngles;
    let mut entries = vec![entry(Mark::Curve(Pattern::Full), palette.text, "loop")];
    if !curtain.hides_any(&[Hidden::Verdicts, Hidden::Numbers]) {
        let upright = |x: f64, from: f64, to: f64| {
            ([PlotPoint::new(x, from), PlotPoint::new(x, to)], palette.good, Pattern::Full)
        };
        for margin in [margins.raise, margins.lower].into_iter().flatten().filter(|m| m.frequency > 0.0) {
            gain.segments.push(upright(margin.frequency.log10(), 0.0, -20.0 * margin.factor.log10()));
        }
        if let Some(margin) = margins.phase {
            let x = margin.frequency.log10();
            if let Some(at) = phase.curves.first().and_then(|curve| curve.at(x)) {
                // The odd multiple of half a turn that the margin is counted from.
                let half = (at - margin.angle.to_degrees()).round();
                phase.segments.push(upright(x, half, at));
                let points = [range.0, range.1].map(|x| PlotPoint::new(x, half)).to_vec();
                phase.curves.push(Curve::new("−180°", points, palette.pinned, Pattern::Dashed));
                entries.push(entry(Mark::Curve(Pattern::Dashed), palette.pinned, "−180°, or a turn from it"));
            }
        }
        if !(gain.segments.is_empty() && phase.segments.is_empty()) {
            entries.push(entry(Mark::Curve(Pattern::Full), palette.good, "margins"));
        }
        if let Some(peak) = margins.sensitivity {
            let upright = (peak.frequency.log10(), palette.warning);
            gain.uprights.push(upright);
            phase.uprights.push(upright);
            entries.push(entry(Mark::Upright, palette.warning, "sensitivity peak"));
        }
    }
    ([gain, phase].map(|picture| canvas.veiled(picture)), entries)
}

/// L(jω) in the complex plane, whole and around −1, or once where that is the same.
fn nyquist(canvas: Canvas<'_>, of: &LoopCurve) -> (Vec<PlotContent>, Vec<Entry>) {
    let Canvas { palette, curtain, .. } = canvas;
    let margins = &of.margins;
    let farthest = of.points.iter().map(|point| point.value.norm()).fold(0.0, f64::max);
    let line = |name, color, pattern, sign: f64| {
        let points = of.points.iter().map(|point| PlotPoint::new(point.value.re, sign * point.value.im));
        Curve::new(name, points.collect(), color, pattern)
    };
    let circle = |name, color, middle: f64, radius: f64| {
        let points = (0..=CIRCLE).map(|k| {
            let place = Complex::from_polar(radius, 2.0 * PI * f64::from(k) / f64::from(CIRCLE)) + middle;
            PlotPoint::from(place)
        });
        Curve::new(name, points.collect(), color, Pattern::Dotted)
    };
    let mut curves = vec![
        line("ω > 0", palette.text, Pattern::Full, 1.0).directed(),
        line("ω < 0", palette.weak, Pattern::Dashed, -1.0),
        circle("|L| = 1", palette.pinned, 0.0, 1.0),
    ];
    let mut dots = vec![(PlotPoint::new(-1.0, 0.0), palette.bad)];
    let mut entries = Vec::new();
    if !curtain.hides_any(&[Hidden::Verdicts, Hidden::Numbers]) {
        if let Some(peak) = margins.sensitivity {
            curves.push(circle("sensitivity peak", palette.warning, -1.0, 1.0 / peak.value));
        }
        let of_gain = [margins.raise, margins.lower].into_iter().flatten().map(|margin| -1.0 / margin.factor);
        dots.extend(of_gain.map(|x| (PlotPoint::new(x, 0.0), palette.good)));
        if let Some(phase) = margins.phase {
            dots.push((Complex::from_polar(1.0, phase.angle - PI).into(), palette.good));
        }
    }
    entries.push(entry(Mark::Dot, palette.bad, "−1"));
    if dots.len() > 1 {
        entries.push(entry(Mark::Dot, palette.good, "margins"));
    }
    let picture = |symbol: &str, middle: f64, reach: f64| PlotContent {
        against: ("Re L", ""),
        dots: dots.clone(),
        x_range: Some(middle - reach..=middle + reach),
        y_range: Some(-reach..=reach),
        has_one_scale: true,
        ..PlotContent::of_time(symbol, "", curves.clone())
    };
    let mut pictures = Vec::new();
    if farthest > NEAR {
        pictures.push(picture("Im L", 0.0, 1.1 * farthest.min(FAR)));
    }
    pictures.push(picture("Im L near −1", -1.0, 1.6));
    let pictures: Vec<PlotContent> = pictures.into_iter().map(|picture| canvas.veiled(picture)).collect();
    let mut all = legend::curves(&pictures[..1]);
    all.extend(entries.into_iter().filter(|_| !curtain.hides(Hidden::Curves)));
    (pictures, all)
}
