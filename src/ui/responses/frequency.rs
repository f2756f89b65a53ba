//! The frequency response of the input at work: gain and phase over frequency, with the peaks that the oscillations make.

use egui::{RichText, Ui};

use super::legend::{self, Entry, Mark};
use super::studied::{Studied, input_words, units};
use super::time::grid;
use super::{Basis, Seen, kept, note_ui, output_ui};
use crate::content::LengthUnit;
use crate::flight::aircraft::plane::{ByPlane, Plane};
use crate::flight::modes::mode::Mode;
use crate::flight::modes::stability::Stability;
use crate::flight::motion::frequency_response::{
    FrequencyPoint, Peak, frequency_range, frequency_response, peaks,
};
use crate::flight::motion::outputs::Output;
use crate::number::significant;
use crate::scenario::link::Sight;
use crate::ui::chart::{Curve, Pattern, Picture, PlotPoint, Scale, SmallPlot};
use crate::ui::theme::{self, Palette};
use crate::words;

/// Points over all frequencies: finer than a screen can tell between peaks.
const POINTS: usize = 400;

/// Gain and phase of one output.
#[derive(Debug)]
pub struct FrequencyPlots {
    /// The output watched, of each plane.
    pub outputs: ByPlane<Output>,
    plots: [SmallPlot; 2],
    sheet: Option<((Basis, Output), Sheet)>,
}

impl Default for FrequencyPlots {
    fn default() -> Self {
        let outputs = Sight::default().frequency_of;
        Self { outputs, plots: Default::default(), sheet: None }
    }
}

/// What the plots show, and what is said of it.
#[derive(Debug)]
struct Sheet {
    bode: Bode,
    pictures: [Picture; 2],
    entries: Vec<Entry>,
}

/// A frequency response in shown units.
#[derive(Debug)]
struct Bode {
    points: Vec<FrequencyPoint>,
    peaks: Vec<Peak>,
    /// Output over input: one shown unit of gain in SI.
    unit: f64,
    /// Symbols of the units of output and input.
    symbols: (&'static str, &'static str),
}

impl FrequencyPlots {
    /// Which output.
    pub fn choosers_ui(&mut self, ui: &mut Ui, plane: Plane) {
        ui.label("Gain and phase of");
        output_ui(ui, "Output of the frequency response", plane, &mut self.outputs[plane]);
    }

    /// Draws gain and phase.
    pub fn show(&mut self, ui: &mut Ui, seen: Seen<'_>) {
        let Seen { studied, ghost, .. } = seen;
        let output = self.outputs[studied.plane()];
        let key = (Basis::of(seen), output);
        let Sheet { bode, pictures, entries } = kept(&mut self.sheet, key, || Sheet::of(seen, output));
        match unsteady(studied.modes) {
            Some(growing) => note_ui(ui, &growing),
            None => peaks_ui(ui, bode),
        }
        if let Some(growing) = ghost.and_then(|ghost| unsteady(ghost.modes)) {
            note_ui(ui, &format!("Pinned: {growing}"));
        }
        legend::legend_ui(ui, entries, seen.beside);
        let places = grid(ui, pictures.len(), seen.rows);
        for ((plot, picture), place) in self.plots.iter_mut().zip(pictures).zip(places) {
            plot.show(ui, place, picture, None);
        }
    }
}

impl Sheet {
    fn of(seen: Seen<'_>, output: Output) -> Self {
        let Seen { studied, ghost, palette, .. } = seen;
        let (input, _, dimension, _) = input_words(studied.plane(), studied.scenario.driven_channel());
        let (quantity, unit, _) = units(output, studied.scenario);
        let input_unit = dimension.symbol(LengthUnit::Metre);
        let range = frequency_range(studied.modes);
        let pinned = ghost.map(|ghost| bode(ghost, output, range));
        let bode = bode(studied, output, range);

        let decibels = |bode: &Bode, name, color, pattern| {
            curve(bode, name, color, pattern, |point| 20.0 * (point.value.norm() / bode.unit).log10())
        };
        let degrees = |bode: &Bode, name, color, pattern| {
            curve(bode, name, color, pattern, |point| point.phase.to_degrees())
        };
        let with_ghost = |of: &dyn Fn(&Bode, &'static str, egui::Color32, Pattern) -> Curve| {
            let mut curves = vec![of(&bode, "linear", palette.text, Pattern::Full)];
            if let Some(pinned) = &pinned {
                curves.push(of(pinned, "pinned", palette.ghost, Pattern::Dashed));
            }
            curves
        };
        let symbol = format!("{}/{input}", quantity.symbol);
        let uprights: Vec<_> = studied
            .modes
            .iter()
            .filter_map(|mode| Some((mode.natural_frequency()?.log10(), palette.mode(mode.naming.name))))
            .collect();
        let picture = |unit: String, curves| Picture {
            against: ("ω", "rad/s"),
            uprights: uprights.clone(),
            x_range: Some(range.0.log10()..=range.1.log10()),
            scales: (Scale::Decades, Scale::Even),
            with_zero: false,
            ..Picture::of_time(symbol.as_str(), unit, curves)
        };
        let dots = bode
            .peaks
            .iter()
            .filter_map(|peak| {
                let gain = 20.0 * (peak.gain? / bode.unit).log10();
                Some((PlotPoint::new(peak.frequency.log10(), gain), palette.mode(peak.mode)))
            })
            .collect();
        let gain_unit = format!("dB of {unit} per {input_unit}");
        let gain = Picture { dots, ..picture(gain_unit, with_ghost(&decibels)) };
        let scales = (Scale::Decades, Scale::RightAngles);
        let phase = Picture { scales, ..picture("deg".to_owned(), with_ghost(&degrees)) };
        let pictures = [gain, phase];
        let mut entries = legend::curves(&pictures);
        entries.extend(studied.modes.iter().filter(|mode| mode.is_oscillatory()).map(|mode| {
            let name = mode.naming.name;
            Entry {
                mark: Mark::Upright,
                color: palette.mode(name),
                name: format!("ωₙ of the {}", words::mode::in_a_sentence(name)),
            }
        }));
        Self { bode, pictures, entries }
    }
}

/// Why no steady oscillation answers a sine, where a mode grows.
fn unsteady(modes: &[Mode]) -> Option<String> {
    let growing = modes.iter().find(|mode| mode.stability == Stability::Unstable)?;
    Some(format!(
        "The {} grows: no steady oscillation ever answers a sine. The curves are only the transfer function at s = jω.",
        words::mode::in_a_sentence(growing.naming.name)
    ))
}

fn bode(studied: Studied<'_>, output: Output, range: (f64, f64)) -> Bode {
    let forced = studied.scenario.driven(studied.motion);
    let row = output.row(&studied.motion.model, &forced);
    let points = frequency_response(&forced, &row, 0, range, POINTS);
    let mut peaks = peaks(&forced, &row, 0, &points, studied.modes);
    if unsteady(studied.modes).is_some() {
        peaks.clear();
    }
    let (_, _, dimension, _) = input_words(studied.plane(), studied.scenario.driven_channel());
    let (_, symbol, unit) = units(output, studied.scenario);
    let symbols = (symbol, dimension.symbol(LengthUnit::Metre));
    Bode { points, peaks, unit: unit / dimension.in_si(LengthUnit::Metre), symbols }
}

fn curve(
    bode: &Bode,
    name: &'static str,
    color: egui::Color32,
    pattern: Pattern,
    value: impl Fn(&FrequencyPoint) -> f64,
) -> Curve {
    let point =
        |point: &FrequencyPoint| PlotPoint::new(point.frequency.log10(), value(point).clamp(-400.0, 4e4));
    let points: Vec<PlotPoint> = bode.points.iter().map(point).collect();
    Curve::new(name, points, color, pattern)
}

fn peaks_ui(ui: &mut Ui, bode: &Bode) {
    let palette = Palette::of(ui);
    let (unit, input_unit) = bode.symbols;
    ui.horizontal_wrapped(|ui| {
        if bode.peaks.is_empty() {
            ui.label(
                RichText::new("No peak: no oscillation of this output stands out.").font(theme::small()),
            );
        }
        for peak in &bode.peaks {
            let gain = peak.gain.map_or_else(
                || "without bound".to_owned(),
                |gain| format!("{} {unit} per {input_unit}", significant(gain / bode.unit, 3)),
            );
            let text = format!(
                "{} peak: {gain} at {} rad/s",
                words::mode::title(peak.mode),
                significant(peak.frequency, 3)
            );
            ui.label(
                RichText::new(text)
                    .font(theme::semibold(theme::sizes(ui).small))
                    .color(palette.mode_text(peak.mode)),
            );
            ui.add_space(10.0);
        }
    });
}
