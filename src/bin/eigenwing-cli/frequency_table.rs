//! A frequency response as a table for people.

use eigenwing::export::FrequencyReport;

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
    match report.growing_mode {
        Some(mode) => {
            text +=
                &format!("{mode} grows: no steady oscillation ever answers a sine, so there is no peak.\n");
        }
        None if report.peaks.is_empty() => text += "No peak: no oscillation of this output stands out.\n",
        None => {}
    }
    for peak in &report.peaks {
        let at = number(peak.frequency);
        text += &match peak.gain {
            Some(gain) => format!("{} peak: {} {gain_unit} at {at} rad/s\n", peak.mode, number(gain)),
            None => format!("{} peak: without bound at {at} rad/s\n", peak.mode),
        };
    }
    text
}
