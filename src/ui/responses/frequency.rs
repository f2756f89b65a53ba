//! The frequency response of the input at work: gain and phase over frequency, with the peaks that the oscillations make.

use egui::{RichText, Ui};

use super::curves::units;
use super::legend::{self, Entry, Mark};
use super::time::grid;
use super::{CacheKey, Canvas, kept, note_ui, output_ui};
use crate::content::LengthUnit;
use crate::findings::{Findings, FrequencyResponse};
use crate::flight::aircraft::plane::Plane;
use crate::flight::motion::frequency_response::{FrequencyPoint, Peak};
use crate::flight::motion::outputs::Output;
use crate::number::significant;
use crate::scenario::{Hidden, Quantity};
use crate::ui::chart::{Curve, Pattern, PlotContent, PlotPoint, Scale, SmallPlot};
use crate::ui::theme::{self, Palette};
use crate::words;

/// Gain and phase of one output.
#[derive(Debug, Default)]
pub struct FrequencyPlots {
    plots: [SmallPlot; 2],
    sheet: Option<((CacheKey, Output), CachedPlots)>,
}

/// The pictures, and what is said of them.
#[derive(Debug)]
struct CachedPlots {
    shown: Shown,
    pictures: [PlotContent; 2],
    entries: Vec<Entry>,
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
        let Canvas { findings, pinned, .. } = canvas;
        let output = canvas.view.frequency_of[findings.scenario().plane];
        let Some(response) = findings.frequency(output) else { return };
        let key = (CacheKey::of(canvas), output);
        let CachedPlots { shown, pictures, entries } =
            kept(&mut self.sheet, key, || CachedPlots::of(canvas, output, response));
        let is_told = !canvas.curtain.hides_any(&[Hidden::Names, Hidden::Verdicts]);
        let growing = |findings: &Findings| {
            let name = findings.growing_mode().filter(|_| is_told)?.naming.name;
            Some(words::frequency::growing(name))
        };
        match growing(findings) {
            Some(growing) => note_ui(ui, &growing),
            None if canvas.curtain.hides_sentences() || canvas.curtain.hides(Hidden::Curves) => {}
            None => peaks_ui(ui, &response.peaks, *shown),
        }
        if let Some(growing) = pinned.and_then(|pinned| growing(pinned)) {
            note_ui(ui, &format!("Pinned: {growing}"));
        }
        legend::legend_ui(ui, entries, canvas.beside);
        let places = grid(ui, pictures.len(), canvas.rows);
        for ((plot, picture), place) in self.plots.iter_mut().zip(pictures).zip(places) {
            plot.show(ui, place, picture, None);
        }
    }
}

/// Which output.
pub fn choosers_ui(ui: &mut Ui, plane: Plane, output: &mut Output) {
    ui.label("Gain and phase of");
    output_ui(ui, "frequency", "Output of the frequency response", plane, output);
}

impl CachedPlots {
    fn of(canvas: Canvas<'_>, output: Output, response: &FrequencyResponse) -> Self {
        let Canvas { findings, pinned, palette, curtain, .. } = canvas;
        let scenario = findings.scenario();
        let Quantity { symbol: input, dimension, .. } =
            Quantity::of_input(scenario.plane, scenario.driven_channel());
        let (quantity, unit, output_si) = units(output, scenario);
        let input_unit = dimension.symbol(LengthUnit::Metre);
        let shown =
            Shown { gain: output_si / dimension.in_si(LengthUnit::Metre), symbols: (unit, input_unit) };
        let range = findings.frequency_range();
        let of_pinned = pinned.and_then(|pinned| pinned.frequency_over(output, range, response.points.len()));

        let decibels = |response: &FrequencyResponse, name, color, pattern| {
            curve(response, name, color, pattern, |point| 20.0 * (point.value.norm() / shown.gain).log10())
        };
        let degrees = |response: &FrequencyResponse, name, color, pattern| {
            curve(response, name, color, pattern, |point| point.phase.to_degrees())
        };
        let with_pinned = |of: &dyn Fn(&FrequencyResponse, &'static str, egui::Color32, Pattern) -> Curve| {
            let mut curves = vec![of(response, "linear", palette.text, Pattern::Full)];
            if let Some(pinned) = &of_pinned {
                curves.push(of(pinned, "pinned", palette.pinned, Pattern::Dashed));
            }
            curves
        };
        let symbol = format!("{}/{input}", quantity.symbol);
        // Where the frequencies of the modes are: they are read from the axis.
        let marked = findings.modes().iter().filter(|_| !curtain.hides_values());
        let uprights: Vec<_> = marked
            .clone()
            .filter_map(|mode| Some((mode.natural_frequency()?.log10(), palette.mode(mode.naming.name))))
            .collect();
        let picture = |unit: String, curves| PlotContent {
            against: ("ω", "rad/s"),
            uprights: uprights.clone(),
            x_range: Some(range.0.log10()..=range.1.log10()),
            scales: (Scale::Decades, Scale::Even),
            with_zero: false,
            ..PlotContent::of_time(symbol.as_str(), unit, curves)
        };
        let dots = response
            .peaks
            .iter()
            .filter_map(|peak| {
                let gain = 20.0 * (peak.gain? / shown.gain).log10();
                Some((PlotPoint::new(peak.frequency.log10(), gain), palette.mode(peak.mode)))
            })
            .collect();
        let gain_unit = format!("dB of {unit} per {input_unit}");
        let gain = PlotContent { dots, ..picture(gain_unit, with_pinned(&decibels)) };
        let scales = (Scale::Decades, Scale::RightAngles);
        let phase = PlotContent { scales, ..picture("deg".to_owned(), with_pinned(&degrees)) };
        let pictures = [gain, phase].map(|picture| canvas.veiled(picture));
        let mut entries = legend::curves(&pictures);
        entries.extend(marked.filter(|mode| mode.is_oscillatory()).map(|mode| {
            let name = mode.naming.name;
            Entry {
                mark: Mark::Upright,
                color: palette.mode(name),
                name: format!("ωₙ of the {}", curtain.in_a_sentence(name)),
            }
        }));
        Self { shown, pictures, entries }
    }
}

fn curve(
    response: &FrequencyResponse,
    name: &'static str,
    color: egui::Color32,
    pattern: Pattern,
    value: impl Fn(&FrequencyPoint) -> f64,
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
