//! Matrices and modes for a report, as LaTeX with amsmath and booktabs.

use super::study::Study;
use super::text::{number, settings};
use crate::content::LengthUnit;
use crate::export::mode::ModeReport;
use crate::export::plane::PlaneReport;
use crate::number::significant;
use crate::scenario::Dimension;

/// A document that compiles as it is, with its velocities in this unit of length a second; what stands in its body may be taken alone.
pub fn latex(study: &Study, length: LengthUnit) -> String {
    let report = &study.report;
    let (a, b) = in_length(report, length);
    let mut text =
        String::from("\\documentclass{article}\n\\usepackage[utf8]{inputenc}\n\\usepackage[T1]{fontenc}\n");
    text += "\\usepackage{amsmath,booktabs}\n\\begin{document}\n\n";
    text += &format!("\\section*{{{}}}\n{} motion. ", escaped(&study.title), escaped(study.plane));
    text += &study.remarks.iter().map(|remark| escaped(remark)).collect::<Vec<_>>().join("\n\n");
    let states = report.states.map(|key| format!("\\Delta {}", symbol(key))).join(" & ");
    let inputs = report.inputs.map(|key| format!("\\Delta {}", symbol(key))).join(" & ");
    text += "\n\n\\begin{equation*}\n\\dot{x} = A x + B \\delta, \\qquad ";
    text += &format!("x = \\begin{{bmatrix}} {states} \\end{{bmatrix}}^{{\\mathsf T}}, \\qquad ");
    text += &format!(
        "\\delta = \\begin{{bmatrix}} {inputs} \\end{{bmatrix}}^{{\\mathsf T}}\n\\end{{equation*}}\n"
    );
    text += &settings(&study.trim, length, "%");
    text += &format!("\\begin{{equation*}}\nA = {}\n\\end{{equation*}}\n", matrix(&a));
    text += &format!("\\begin{{equation*}}\nB = {}\n\\end{{equation*}}\n", matrix(&b));
    let has_speeds = report.states.iter().any(|key| is_speed(key));
    let speeds = if has_speeds { format!("{}, ", Dimension::Speed.symbol(length)) } else { String::new() };
    text += &format!("Units: {speeds}rad/s and rad; a throttle as a share of the weight.\n\n");
    text += "\\begin{center}\n\\begin{tabular}{lrrrrr}\n\\toprule\n";
    text += "Mode & $\\lambda$ [1/s] & $\\omega_n$ [rad/s] & $\\zeta$ & $T$ [s] & $t_{1/2}$ or $t_2$ [s] \\\\\n\\midrule\n";
    for mode in &report.modes {
        text += &row(mode);
    }
    text + "\\bottomrule\n\\end{tabular}\n\\end{center}\n\n\\end{document}\n"
}

/// Whether a state is a velocity; all others are angles or rates of angles.
fn is_speed(key: &str) -> bool {
    matches!(key, "u" | "w" | "v")
}

/// A and B with velocities in this unit of length a second: T A T⁻¹ and T B.
fn in_length(report: &PlaneReport, length: LengthUnit) -> ([[f64; 4]; 4], [[f64; 2]; 4]) {
    // One metre per second in the new unit is 1/l of it; l stays below the line, so that no digit is lost twice.
    let unit = report.states.map(|key| if is_speed(key) { length.metres() } else { 1.0 });
    let a = std::array::from_fn(|i| std::array::from_fn(|j| report.a[i][j] * (unit[j] / unit[i])));
    (a, std::array::from_fn(|i| report.b[i].map(|entry| entry / unit[i])))
}

fn row(mode: &ModeReport) -> String {
    let math = |x: Option<f64>| x.map_or_else(String::new, |x| format!("${}$", digits(x)));
    let lambda = if mode.im > 0.0 {
        format!("${} \\pm {}\\,\\mathrm{{i}}$", digits(mode.re), digits(mode.im))
    } else {
        math(Some(mode.re))
    };
    let cells = [
        escaped(mode.name),
        lambda,
        math(mode.natural_frequency),
        math(mode.damping_ratio),
        math(mode.period),
        math(mode.time_to_half.or(mode.time_to_double)),
    ];
    format!("{} \\\\\n", cells.join(" & "))
}

/// Four digits, with an exponent as it is set.
fn digits(x: f64) -> String {
    let text = significant(x, 4).replace('−', "-");
    match text.split_once('e') {
        Some((mantissa, exponent)) => format!("{mantissa} \\cdot 10^{{{exponent}}}"),
        None => text,
    }
}

/// Every digit stands in a comment behind the row, four on paper.
fn matrix<const N: usize>(rows: &[[f64; N]; 4]) -> String {
    let row = |row: &[f64; N]| {
        let shown = row.map(digits).join(" & ");
        format!("  {shown} \\\\ % {}\n", row.map(number).join(", "))
    };
    format!("\\begin{{bmatrix}}\n{}\\end{{bmatrix}}", rows.iter().map(row).collect::<String>())
}

/// A state or input as a symbol.
fn symbol(key: &str) -> &'static str {
    match key {
        "u" => "u",
        "w" => "w",
        "alpha" => "\\alpha",
        "q" => "q",
        "theta" => "\\theta",
        "v" => "v",
        "beta" => "\\beta",
        "p" => "p",
        "r" => "r",
        "phi" => "\\phi",
        "elevator" => "\\delta_e",
        "throttle" => "\\delta_t",
        "aileron" => "\\delta_a",
        "rudder" => "\\delta_r",
        _ => "?",
    }
}

/// Text without anything that LaTeX takes for its own, or that its usual fonts don't have.
fn escaped(text: &str) -> String {
    let mut out = String::new();
    for c in text.chars() {
        match c {
            '&' | '%' | '$' | '#' | '_' | '{' | '}' => out.extend(['\\', c]),
            '\\' => out += "\\textbackslash{}",
            '~' => out += "\\textasciitilde{}",
            '^' => out += "\\textasciicircum{}",
            '−' => out += "$-$",
            '–' => out += "--",
            '’' => out.push('\''),
            '“' => out += "``",
            '”' => out += "''",
            '·' => out += "$\\cdot$",
            '±' => out += "$\\pm$",
            '°' => out += "$^\\circ$",
            '≈' => out += "$\\approx$",
            '≤' => out += "$\\le$",
            '≥' => out += "$\\ge$",
            '×' => out += "$\\times$",
            '√' => out += "$\\surd$",
            '²' => out += "$^2$",
            '³' => out += "$^3$",
            '⁴' => out += "$^4$",
            '₀' => out += "$_0$",
            '₁' => out += "$_1$",
            '₂' => out += "$_2$",
            '′' => out += "$'$",
            '½' => out += "$\\tfrac12$",
            '¼' => out += "$\\tfrac14$",
            '…' => out += "\\dots{}",
            '\u{a0}' => out.push('~'),
            'α'..='ω' | 'Α'..='Ω' | 'ϕ' => out += &greek(c),
            // The dot and the bar over the letter before.
            '\u{307}' | '\u{304}' | '\u{305}' => {}
            'ẇ' => out += "$\\dot w$",
            c if c.is_ascii() || ('\u{c0}'..='\u{17f}').contains(&c) => out.push(c),
            _ => out.push('?'),
        }
    }
    out
}

fn greek(c: char) -> String {
    let name = match c {
        'α' => "\\alpha",
        'β' => "\\beta",
        'γ' => "\\gamma",
        'δ' => "\\delta",
        'ε' => "\\epsilon",
        'ζ' => "\\zeta",
        'η' => "\\eta",
        'θ' => "\\theta",
        'λ' => "\\lambda",
        'μ' => "\\mu",
        'π' => "\\pi",
        'ρ' => "\\rho",
        'σ' => "\\sigma",
        'τ' => "\\tau",
        'φ' | 'ϕ' => "\\phi",
        'ψ' => "\\psi",
        'ω' => "\\omega",
        'Δ' => "\\Delta",
        'Γ' => "\\Gamma",
        'Λ' => "\\Lambda",
        'Φ' => "\\Phi",
        'Ω' => "\\Omega",
        _ => "?",
    };
    format!("${name}$")
}
