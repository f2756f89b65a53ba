//! A frequency response as a table for people.

use eigenwing::export::{FrequencyReport, gain_unit};
use eigenwing::flight::modes::mode_name::ModeName;
use eigenwing::key::Keyed as _;
use eigenwing::words::frequency as words;

use crate::shown_units::ShownUnits;
use crate::tables::{heading, number, stride, table};

pub fn frequency(report: &FrequencyReport, units: ShownUnits) -> String {
    let FrequencyReport { aircraft, plane, input, output, frequency, gain, phase, .. } = report;
    let [(of, of_unit), (by, by_unit)] = [output.unit, input.unit].map(|unit| units.of_motion(unit));
    let (in_si, gain_unit) = (of / by, gain_unit(of_unit, by_unit));
    let step = stride(frequency.len());
    let values = frequency.iter().zip(gain).zip(phase).step_by(step);
    let rows = values.map(|((frequency, gain), phase)| {
        let gain = gain / in_si;
        let decibels = 20.0 * gain.log10();
        let decibels = if decibels.is_finite() { number(decibels) } else { String::new() };
        let radians = (units == ShownUnits::Si).then(|| number(*phase));
        let row = [number(*frequency), number(gain), decibels];
        row.into_iter().chain(radians).chain([number(phase.to_degrees())]).collect()
    });
    let gain_head = heading("gain", &gain_unit);
    let phase_heads: &[&str] = match units {
        ShownUnits::Si => &["phase [rad]", "°"],
        ShownUnits::Feet => &["phase [deg]"],
    };
    let head: Vec<&str> = ["ω [rad/s]", &gain_head, "dB"].iter().chain(phase_heads).copied().collect();
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
        let gain = peak.gain.map(|gain| format!("{} {gain_unit}", number(gain / in_si)));
        text += &format!("{}\n", words::peak(mode, gain.as_deref(), &number(peak.frequency)));
    }
    let functions = [
        ("G(s)", report.transfer_function.as_ref()),
        (
            "Under the law G(s)",
            report.closed_loop.as_ref().and_then(|closed| closed.transfer_function.as_ref()),
        ),
    ];
    for (name, function) in functions {
        let Some(function) = function else { continue };
        text += &format!("{name} = {}\n", function.line(in_si));
        if let Some(sentence) = &function.zeros_on_the_right {
            text += &format!("{sentence}\n");
        }
    }
    text
}
