//! The form of a file, by what is in it; its name counts only where the text says nothing.

use super::review::Form;

/// A form that can be read, or a sentence about one that can't.
pub(super) enum Found {
    Form(Form),
    Other(&'static str),
}

/// A mass file of AVL: units, then rows of masses.
pub(super) fn is_mass_file(text: &str) -> bool {
    let sets =
        |name| text.lines().any(|line| line.split_once('=').is_some_and(|(key, _)| key.trim() == name));
    sets("Lunit") && sets("Munit")
}

/// An aircraft file of this program, whatever words stand in its notes.
pub(super) fn is_own_file(name: &str, text: &str) -> bool {
    let sets =
        |name| text.lines().any(|line| line.split_once('=').is_some_and(|(key, _)| key.trim() == name));
    name.to_lowercase().ends_with(".toml") || sets("key") && sets("basis")
}

/// The form of a text.
pub(super) fn form(name: &str, text: &str) -> Found {
    if is_own_file(name, text) {
        return Found::Form(Form::AircraftFile);
    }
    let has = |part: &str| text.contains(part);
    let ending = name.rsplit_once('.').map_or("", |(_, ending)| ending).to_lowercase();
    let first = text.trim_start();
    // What stands in an object may be anything, names of other forms too.
    let is_jsbsim = has("\"x_names\"") && has("\"A\"");
    let is_object = first.strip_prefix('{').is_some_and(|rest| rest.trim_start().starts_with(['"', '}']));
    if is_object || first.starts_with('[') && is_jsbsim {
        return Found::Form(if is_jsbsim { Form::JsbsimJson } else { Form::Json });
    }
    if has("STABILITY AND CONTROL METHODS PER APRIL 1976") {
        return Found::Form(Form::Datcom);
    }
    if has("Stability-axis derivatives") {
        return Found::Form(Form::AvlStability);
    }
    if has("Geometry-axis derivatives") || has("x force CX") {
        return Found::Other(
            "this is AVL’s file of derivatives in geometry axes (SB); save those in stability axes, with the command ST",
        );
    }
    if has("Run case") && has("Eigenvalue") {
        return Found::Other(
            "this is AVL’s list of eigenvalues; save the system matrix, with the command S of its MODE menu, or the derivatives, ST",
        );
    }
    if is_mass_file(text) {
        return Found::Other("this is AVL’s mass file; open it together with the stability derivatives (ST)");
    }
    if has("Run case") && has("->") {
        return Found::Other("this is AVL’s file of run cases; save the derivatives, with the command ST");
    }
    if has("(q + alpha_dot)") || has("CFx_p ") {
        return Found::Other("this is VSPAERO’s file of one rate (.pstab, .qstab, .rstab); open its .stab");
    }
    if has("Sref_") && has("Coef") && has("Total") {
        return Found::Form(Form::Vspaero);
    }
    if has("syslin('c'") || has("syslin(\"c\"") {
        return Found::Form(Form::JsbsimScicos);
    }
    let has_log =
        has("Longitudinal state matrix") || has("Lateral state matrix") || has("Longitudinal derivatives");
    if has_log || (has("State matrices") && has("state matrix")) {
        return Found::Form(Form::Xflr5);
    }
    if first.starts_with('[') && has("{") && has("\"A\"") {
        return Found::Other("this is a list of several models; open one of them, an object with \"A\"");
    }
    if is_avl_system(text) {
        return Found::Form(Form::AvlSystem);
    }
    let lines = || text.lines().map(str::trim);
    let is_setting =
        |line: &str, keys: &[&str]| line.split_once('=').is_some_and(|(key, _)| keys.contains(&key.trim()));
    if lines().any(|line| is_setting(line, &["basis", "length_unit"])) {
        return Found::Form(Form::AircraftFile);
    }
    if has("Damping") && has("Frequency") && (has("Pole") || has("Eigenvalue")) {
        return Found::Other(
            "this is a list of poles, as MATLAB’s damp prints it; a model needs the matrix A itself: print it with mat2str(A, 17)",
        );
    }
    if first.starts_with('<') {
        return Found::Other(
            "this is XML; of JSBSim, open a linearisation that it has made, not the aircraft’s file",
        );
    }
    let is_named = |line: &str| {
        let cells = line.split([',', ';', '\t', '|']).filter(|cell| !cell.trim().is_empty());
        let words = cells.filter(|cell| cell.trim().starts_with(|c: char| c.is_alphabetic()));
        words.count() >= 2
    };
    if matches!(ending.as_str(), "csv" | "tsv") && lines().any(is_named) {
        return Found::Form(Form::Table);
    }
    // An assignment in a line that is no comment.
    let assigns = lines().any(|line| !line.starts_with(['#', '%']) && line.contains('='));
    if matches!(ending.as_str(), "m" | "py") || assigns {
        return Found::Form(Form::Script);
    }
    if lines().filter(|line| is_named(line)).count() > 1 {
        return Found::Form(Form::Table);
    }
    if lines()
        .any(|line| line.starts_with(|c: char| c.is_ascii_digit() || matches!(c, '-' | '+' | '.' | '[')))
        || has("array(")
        || has("Matrix([")
    {
        return Found::Form(if lines().any(is_named) { Form::Table } else { Form::Numbers });
    }
    Found::Other(
        "this form of file is not known here; known are matrices (MATLAB, Python, JSON, CSV) and files of AVL, XFLR5, VSPAERO, Digital DATCOM \
         and JSBSim",
    )
}

/// A line of names, at least eight states, and rows of as many numbers below it.
fn is_avl_system(text: &str) -> bool {
    let Some(head) = text.lines().find(|line| !line.trim().is_empty() && !line.trim_start().starts_with('#'))
    else {
        return false;
    };
    let names: Vec<&str> = head.split('|').next().unwrap_or_default().split_whitespace().collect();
    names.len() >= 8 && names.starts_with(&["u", "w", "q"]) && names.contains(&"phi")
}
