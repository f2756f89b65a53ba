//! Equations as text in the notation of symbols: an entry, a row, the polynomial and its factors.

use crate::findings::Equations;
use crate::findings::equations::{Atom, COLUMNS, Factor, Form};
use crate::number::trimmed;
use crate::scenario::view::Entries;
use crate::words;

/// The equations as they are written.
#[derive(Clone, Copy, Debug)]
pub(super) struct Writing<'a> {
    pub equations: &'a Equations,
    pub entries: Entries,
    /// Significant digits of an entry.
    pub digits: usize,
}

impl Writing<'_> {
    /// The value of an entry in the unit on screen, and that unit.
    pub fn number(&self, row: usize, column: usize) -> (String, &'static str) {
        let dimension = self.equations.dimension(row, column);
        let length = self.equations.convention.length;
        let shown = self.equations.value(row, column) / dimension.in_si(length);
        (trimmed(shown, self.digits), dimension.symbol(length))
    }

    /// An entry as a symbol: that of its slider where that has a prime, or else what it is made of.
    pub fn symbol(&self, row: usize, column: usize) -> Option<String> {
        let form = self.equations.form(row, column)?;
        let convention = self.equations.convention;
        let slider =
            self.equations.slider(row, column).map(|(parameter, _)| parameter.written(convention).symbol);
        let of_slider = slider.filter(|symbol| symbol.contains('′'));
        Some(of_slider.map_or_else(|| form.text(convention), str::to_owned))
    }

    /// An entry as what it is made of.
    pub fn full(&self, row: usize, column: usize) -> Option<String> {
        let text = self.equations.form(row, column)?.text(self.equations.convention);
        Some(if self.equations.added(row, column) == 0.0 { text } else { format!("{text} + Δ") })
    }

    /// An entry as it stands in its matrix. Of bare matrices there are numbers only.
    pub fn entry(&self, row: usize, column: usize) -> String {
        let text = match self.entries {
            Entries::Numbers => None,
            Entries::Symbols => self.symbol(row, column),
            Entries::Full => self.full(row, column),
        };
        text.unwrap_or_else(|| self.number(row, column).0)
    }

    /// Whether an entry is written as a sum.
    fn is_sum(&self, row: usize, column: usize) -> bool {
        let Some(form) = self.equations.form(row, column) else { return false };
        match self.entries {
            Entries::Numbers => false,
            Entries::Symbols => {
                matches!(form, Form::Sum(_))
                    && self.entry(row, column) == form.text(self.equations.convention)
            }
            Entries::Full => matches!(form, Form::Sum(_)) || self.equations.added(row, column) != 0.0,
        }
    }

    /// A row as an equation: `u̇ = X_u u + X_w w + …`.
    pub fn row(&self, row: usize) -> String {
        let (plane, notation) = (self.equations.plane, self.equations.convention.notation);
        let mut text = format!("{} =", words::equations::rates(plane, notation)[row]);
        let mut is_first = true;
        for (column, state) in
            words::equations::columns(plane, notation).into_iter().enumerate().take(COLUMNS)
        {
            let form = self.equations.form(row, column);
            let is_fixed = self.equations.slider(row, column).is_none();
            if form == Some(Form::Whole(0)) || is_fixed && self.equations.value(row, column) == 0.0 {
                continue;
            }
            let entry = self.entry(row, column);
            // What is over V stands by itself: (Z_u/V) u.
            let factor = |text: &str| if text.contains("/V") { format!("({text})") } else { text.to_owned() };
            let (sign, size) = match entry.strip_prefix('−') {
                _ if self.is_sum(row, column) => ("+", format!("({entry})")),
                Some(size) => ("−", factor(size)),
                None => ("+", factor(&entry)),
            };
            match (is_first, sign) {
                (true, "+") => text.push(' '),
                (true, _) => text.push_str(" −"),
                (false, sign) => text.push_str(&format!(" {sign} ")),
            }
            text.push_str(&if size == "1" { state.to_owned() } else { format!("{size} {state}") });
            is_first = false;
        }
        text
    }

    /// What the symbols that are this page's own stand for, of all entries that are seen.
    pub fn definitions(&self) -> Vec<Atom> {
        let mut defined: Vec<Atom> = Vec::new();
        let forms =
            (0..4).flat_map(|row| (0..COLUMNS).filter_map(move |column| self.equations.form(row, column)));
        for atom in forms.flat_map(|form| form.atoms()) {
            if atom.definition(self.equations.convention.notation).is_some() && !defined.contains(&atom) {
                defined.push(atom);
            }
        }
        defined
    }
}

/// λ⁴ + a₃λ³ + a₂λ² + a₁λ + a₀.
pub(super) fn polynomial(equations: &Equations) -> String {
    let [a3, a2, a1, a0] = equations.polynomial;
    let mut text = "λ^4".to_owned();
    for (coefficient, power) in [(a3, " λ^3"), (a2, " λ^2"), (a1, " λ"), (a0, "")] {
        text.push_str(&term(coefficient, power));
    }
    text
}

/// λ + c, or λ² + 2ζωₙλ + ωₙ².
pub(super) fn factor(factor: Factor) -> String {
    match factor {
        Factor::Root { c } => format!("(λ{})", term(c, "")),
        Factor::Pair { damping, stiffness } => {
            format!("(λ^2{}{})", term(damping, " λ"), term(stiffness, ""))
        }
    }
}

/// A term after others, with its sign.
fn term(coefficient: f64, power: &str) -> String {
    let sign = if coefficient < 0.0 { "−" } else { "+" };
    format!(" {sign} {}{power}", trimmed(coefficient.abs(), 4))
}
