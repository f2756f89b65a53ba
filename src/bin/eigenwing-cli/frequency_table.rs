//! A frequency response as a table for people.

use eigenwing::export::FrequencyReport;
use eigenwing::flight::modes::mode_name::ModeName;
use eigenwing::key::Keyed as _;
use eigenwing::words::frequency as words;

use crate::tables::{heading, number, stride, table};

pub fn frequency(report: &FrequencyReport) -> String {
    let FrequencyReport { aircraft, plane, input, output, gain_unit, frequency, gain, phase, .. } = report;
    let step = stride(frequency.len());
    let values = frequency.iter().zip(gain).zip(phase).step_by(step);
    let rows = values.map(|((frequency, gain), phase)| {
        let decibels = 20.0 * gain.log10();
        let decibels = if decibels.is_finite() { number(decibels) } else { String::new() };
        vec![number(*frequency), number(*gain), decibels, number(*phase), number(phase.to_degrees())]
    });
    let head = ["ω [rad/s]", &heading("gain", gain_unit), "dB", "phase [rad]", "°"];
    let mut text = format!("{}: {plane}, {} of {}\n", aircraft.name, output.name, input.name);
    text += &table(0, &head, rows);
    if step > 1 {
        text += &format!("Every {step}th of {} frequencies; --csv and --json give all.\n", frequency.len());
    }
    let name = |key: &str| ModeName::by_key(key);
    match report.growing_mode_key.and_then(name) {
        Some(mode) => text += &format!("{}\n", words::growing(mode)),
        None if report.peaks.is_empty() => text += &format!("{}\n", words::NO_PEAK),
        None => {}
    }
    for peak in &report.peaks {
        let Some(mode) = name(peak.mode_key) else { continue };
        let gain = peak.gain.map(|gain| format!("{} {gain_unit}", number(gain)));
        text += &format!("{}\n", words::peak(mode, gain.as_deref(), &number(peak.frequency)));
    }
    text
}
