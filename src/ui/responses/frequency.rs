//! The frequency response of the input at work: gain above phase over one axis, with the peaks that the oscillations make, the zeros,
//! and the transfer function in factors. Where a law feeds back, it is that of the whole, and the aircraft alone is drawn faint.

use egui::{Color32, RichText, Ui};

use super::curves::units;
use super::fraction::Laid;
use super::legend::{self, Entry, Mark};
use super::stack::Stack;
use super::{CacheKey, Canvas, kept, note_ui, output_ui};
use crate::findings::{Findings, FrequencyResponse};
use crate::flight::aircraft::plane::Plane;
use crate::flight::modes::stability::Stability;
use crate::flight::motion::frequency_response::{FrequencyPoint, Peak};
use crate::flight::motion::outputs::Output;
use crate::number::significant;
use crate::scenario::{Hidden, Quantity};
use crate::ui::chart::{Curve, Pattern, PlotContent, PlotPoint, Scale};
use crate::ui::theme::{self, Palette};
use crate::words;
use crate::words::transfer_function::Fraction;

/// How much of its colour the aircraft without its law has.
const FAINT: f32 = 0.4;
/// Names of the whole and of what is drawn faint, under a law and where the source has further states.
const LAW: [&str; 2] = ["with the law", "without"];
const FURTHER: [&str; 2] = ["with all states", "the four alone"];

/// Gain and phase of one output.
#[derive(Debug, Default)]
pub struct FrequencyPlots {
    stack: Stack,
    sheet: Option<((CacheKey, Output), CachedPlots)>,
}

/// The pictures, and what is said of them.
#[derive(Debug)]
struct CachedPlots {
    shown: Shown,
    /// Output over input.
    symbol: String,
    pictures: [PlotContent; 2],
    entries: Vec<Entry>,
    fraction: Option<Fraction>,
    remark: Option<String>,
}

/// The units in which a frequency response is shown.
#[derive(Clone, Copy, Debug)]
struct Shown {
    /// Output over input: one shown unit of gain in SI.
    gain: f64,
    /// Symbols of the units of output and input.
    symbols: (&'static str, &'static str),
}

impl FrequencyPlots {
    /// Draws gain and phase.
    pub fn show(&mut self, ui: &mut Ui, canvas: Canvas<'_>) {
        let Canvas { findings, pinned, curtain, .. } = canvas;
        let output = canvas.view.frequency_of[findings.scenario().plane];
        let Some(alone) = findings.frequency(output) else { return };
        let flies = findings.flies_otherwise() && !findings.is_opened();
        let closed = if flies { findings.closed_frequency(output) } else { None };
        let response = closed.unwrap_or(alone);
        let key = (CacheKey::of(canvas), output);
        let CachedPlots { shown, symbol, pictures, entries, fraction, remark } =
            kept(&mut self.sheet, key, || CachedPlots::of(canvas, output, response, alone));
        let is_told = !curtain.hides_any(&[Hidden::Names, Hidden::Verdicts]);
        let growing = |findings: &Findings| {
            let modes = findings.flown_modes();
            let name = modes.iter().find(|mode| mode.stability == Stability::Unstable)?.naming.name;
            is_told.then(|| words::frequency::growing(name))
        };
        match growing(findings) {
            Some(growing) => note_ui(ui, &growing),
            None if curtain.hides_sentences() || curtain.hides(Hidden::Curves) => {}
            None => peaks_ui(ui, &response.peaks, *shown),
        }
        if let Some(growing) = pinned.and_then(|pinned| growing(pinned)) {
            note_ui(ui, &format!("Pinned: {growing}"));
        }
        legend::legend_ui(ui, entries, canvas.beside);
        let laid = fraction.as_ref().map(|fraction| Laid::of(ui, symbol, fraction, remark.as_deref()));
        let laid = laid.filter(|_| !theme::is_for_a_room(ui));
        let below = laid.as_ref().map_or(0.0, |laid| laid.height() + ui.spacing().item_spacing.y);
        self.stack.show(ui, pictures, canvas.rows, below);
        if let Some(laid) = laid {
            laid.show(ui);
        }
    }
}

/// Which output.
pub fn choosers_ui(ui: &mut Ui, plane: Plane, output: &mut Output) {
    ui.label("Gain and phase of");
    output_ui(ui, "frequency", "Output of the frequency response", plane, output);
}

impl CachedPlots {
    fn of(
        canvas: Canvas<'_>,
        output: Output,
        response: &FrequencyResponse,
        alone: &FrequencyResponse,
    ) -> Self {
        let Canvas { findings, pinned, palette, curtain, .. } = canvas;
        let scenario = findings.scenario();
        let Quantity { symbol: input, dimension, .. } =
            Quantity::of_input(scenario.plane, scenario.driven_channel());
        let (quantity, unit, output_si) = units(output, scenario);
        let length = scenario.length_unit();
        let input_unit = dimension.symbol(length);
        let shown = Shown { gain: output_si / dimension.in_si(length), symbols: (unit, input_unit) };
        let range = findings.frequency_range();
        let of_pinned = pinned.and_then(|pinned| {
            let alone = pinned.frequency_over(output, range, alone.points.len());
            pinned.closed_frequency(output).cloned().or(alone)
        });

        let is_closed = !std::ptr::eq(response, alone);
        let mut drawn = vec![(response, "linear", palette.text, Pattern::Full)];
        if is_closed {
            let names = if findings.is_fed_back() { LAW } else { FURTHER };
            drawn[0].1 = names[0];
            drawn.push((alone, names[1], palette.text.gamma_multiply(FAINT), Pattern::Full));
        }
        if let Some(pinned) = &of_pinned {
            drawn.push((pinned, "pinned", palette.pinned, Pattern::Dashed));
        }
        let curves = |value: &dyn Fn(&FrequencyPoint) -> f64| -> Vec<Curve> {
            drawn.iter().map(|drawn| curve(*drawn, value)).collect()
        };
        let symbol = format!("{}/{input}", quantity.symbol);
        // Where the frequencies of the modes are, and the corners of roots without oscillation: they are read from the axis.
        let is_told = !curtain.hides_values();
        let marked: Vec<_> =
            findings.flown_modes().iter().filter(|mode| is_told && mode.lambda.norm() > range.0).collect();
        let uprights: Vec<_> =
            marked.iter().map(|mode| (mode.lambda.norm().log10(), palette.mode(mode.naming.name))).collect();
        let picture = |unit: String, curves| PlotContent {
            against: ("ω", "rad/s"),
            uprights: uprights.clone(),
            x_range: Some(range.0.log10()..=range.1.log10()),
            scales: (Scale::Decades, Scale::Even),
            with_zero: false,
            ..PlotContent::of_time(symbol.as_str(), unit, curves)
        };
        let decibels = |gain: f64| 20.0 * (gain / shown.gain).log10();
        let peak = |peak: &Peak| {
            let at = PlotPoint::new(peak.frequency.log10(), decibels(peak.gain?));
            Some((at, palette.mode(peak.mode)))
        };
        let mut dots: Vec<_> = response.peaks.iter().filter_map(peak).collect();
        // A gain of one means something only between like quantities.
        let is_ratio = is_told && quantity.dimension == dimension;
        let crossovers = if is_ratio { response.gain_crossovers() } else { Vec::new() };
        dots.extend(crossovers.iter().map(|at| (PlotPoint::new(at.log10(), 0.0), palette.weak)));
        let halves = if is_ratio { response.phase_crossovers() } else { Vec::new() };
        let gain_unit = format!("dB of {unit} per {input_unit}");
        let gains = curves(&|point| decibels(point.value.norm()));
        // Each zero at its corner.
        let mut rings: Vec<(PlotPoint, Color32)> = Vec::new();
        let function = response.function.as_ref().filter(|_| is_told);
        for zero in function.iter().flat_map(|function| &function.zeros).filter(|zero| zero.im >= 0.0) {
            let x = zero.norm().log10();
            if let Some(y) = gains.first().and_then(|gain| gain.at(x)) {
                rings.push((PlotPoint::new(x, y), if zero.re > 0.0 { palette.bad } else { palette.text }));
            }
        }
        let gain = PlotContent { dots, rings: rings.clone(), ..picture(gain_unit, gains) };
        let scales = (Scale::Decades, Scale::RightAngles);
        let phase = curves(&|point| point.phase.to_degrees());
        let half_dots =
            halves.iter().map(|(at, half)| (PlotPoint::new(at.log10(), half.to_degrees()), palette.weak));
        let phase = PlotContent { scales, dots: half_dots.collect(), ..picture("deg".to_owned(), phase) };
        let pictures = [gain, phase].map(|picture| canvas.veiled(picture));
        let mut entries = legend::curves(&pictures);
        let mut add = |mark, color, name: String| entries.push(Entry { mark, color, name });
        for mode in marked {
            let name = mode.naming.name;
            let head = if mode.is_oscillatory() { "ωₙ" } else { "corner" };
            add(Mark::Upright, palette.mode(name), format!("{head} of the {}", curtain.in_a_sentence(name)));
        }
        for (color, name) in [(palette.text, "zero"), (palette.bad, "zero in the right half-plane")] {
            if rings.iter().any(|(_, of)| *of == color) && !curtain.hides(Hidden::Curves) {
                add(Mark::Ring, color, name.to_owned());
            }
        }
        let fraction = function.map(|function| words::transfer_function::fraction(function, shown.gain));
        let remark = function.and_then(words::transfer_function::zeros_on_the_right);
        let places = |of: &[f64]| of.iter().map(|at| significant(*at, 3)).collect::<Vec<_>>().join(", ");
        let halves: Vec<f64> = halves.into_iter().map(|(at, _)| at).collect();
        for (name, at) in [("gain 1", &crossovers), ("phase ±180°", &halves)] {
            if !at.is_empty() && !curtain.hides(Hidden::Curves) {
                let name = format!("{name} at {} rad/s", places(at));
                entries.push(Entry { mark: Mark::Dot, color: palette.weak, name });
            }
        }
        Self { shown, symbol, pictures, entries, fraction, remark }
    }
}

/// A curve of a response, by its name, colour and pattern.
fn curve(
    (response, name, color, pattern): (&FrequencyResponse, &'static str, Color32, Pattern),
    value: &dyn Fn(&FrequencyPoint) -> f64,
) -> Curve {
    let point =
        |point: &FrequencyPoint| PlotPoint::new(point.frequency.log10(), value(point).clamp(-400.0, 4e4));
    let points: Vec<PlotPoint> = response.points.iter().map(point).collect();
    Curve::new(name, points, color, pattern)
}

fn peaks_ui(ui: &mut Ui, peaks: &[Peak], shown: Shown) {
    let palette = Palette::of(ui);
    let (unit, input_unit) = shown.symbols;
    ui.horizontal_wrapped(|ui| {
        if peaks.is_empty() {
            ui.label(RichText::new(words::frequency::NO_PEAK).font(theme::small()));
        }
        for peak in peaks {
            let gain = peak
                .gain
                .map(|gain| format!("{} {unit} per {input_unit}", significant(gain / shown.gain, 3)));
            let text = words::frequency::peak(peak.mode, gain.as_deref(), &significant(peak.frequency, 3));
            ui.label(
                RichText::new(text)
                    .font(theme::semibold(theme::sizes(ui).small))
                    .color(palette.mode_text(peak.mode)),
            );
            ui.add_space(10.0);
        }
    });
}
