//! How a parameter moves the modes.

use crate::findings::RowSensitivity;
use crate::flight::modes::mode::Mode;
use crate::flight::modes::sensitivity::Sensitivity;
use crate::number::significant;
use crate::words::mode;

/// A change of λ weaker than this fraction of |λ| is none.
pub const NOTHING: f64 = 1e-6;

/// A change of a parameter and below it a line for each mode that it moves; with the size in SI of the unit in which the
/// parameter is shown, and that unit.
pub fn of_row(row: &RowSensitivity, modes: &[Mode], (in_si, unit): (f64, &str)) -> String {
    let each = modes.iter().zip(row.strengths.iter().zip(&row.modes));
    let mut lines: Vec<String> = each
        .filter_map(|(mode, (strength, sensitivity))| {
            let name = mode::title(mode.naming.name);
            match strength {
                None => Some(format!("{name}: two roots meet here, so there is no rate")),
                Some(strength) if *strength < NOTHING => None,
                Some(_) => Some(line(name, mode, sensitivity, row.change)),
            }
        })
        .collect();
    if lines.is_empty() {
        lines.push("It moves no pole.".to_owned());
    }
    let more = significant(row.change / in_si, 2);
    format!("{more} {unit} more of this:\n{}", lines.join("\n"))
}

/// The effect of a change of the parameter on a mode, to first order.
fn line(name: &str, mode: &Mode, sensitivity: &Sensitivity, by: f64) -> String {
    let signed = |x: f64| format!("{}{}", if x >= 0.0 { "+" } else { "" }, significant(x, 2));
    let Some(rate) = sensitivity.rate() else { return format!("{name}: no rate") };
    match (rate.damping_ratio, rate.natural_frequency, mode.natural_frequency()) {
        (Some(zeta), Some(wn), Some(now)) => {
            format!("{name}: ζ {}, ωₙ {} %", signed(zeta * by), signed(100.0 * wn * by / now))
        }
        _ => format!("{name}: λ {} 1/s", signed(rate.sigma() * by)),
    }
}
