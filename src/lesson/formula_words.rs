//! A formula read aloud: "u dot equals X sub u times u plus X sub w times w".

use super::formula::{Accent, Formula};

impl Formula {
    /// It in plain words, for a screen reader.
    pub fn in_words(&self) -> String {
        let words = spoken(self, true);
        words.split_whitespace().collect::<Vec<_>>().join(" ").replace(" ,", ",")
    }
}

/// What stands side by side is multiplied, but not within an index.
fn spoken(formula: &Formula, multiplies: bool) -> String {
    match formula {
        Formula::Row(pieces) => row(pieces, multiplies),
        Formula::Letter(character) => letter(*character),
        Formula::Number(text) | Formula::Words(text) => text.clone(),
        Formula::Function(name) => function(name).to_owned(),
        Formula::Sign(character) | Formula::Mark(character) => sign(*character),
        Formula::Space(_) => String::new(),
        Formula::Accent(accent, base) => format!("{} {}", spoken(base, multiplies), above(*accent)),
        Formula::Script { base, lowered, raised } => {
            let mut words = spoken(base, multiplies);
            if let Some(lowered) = lowered {
                words.push_str(" sub ");
                words.push_str(&spoken(lowered, false));
            }
            if let Some(raised) = raised {
                words.push(' ');
                words.push_str(&power(raised));
            }
            words
        }
        Formula::Fraction(top, bottom) if top.is_single() && bottom.is_single() => {
            format!("{} over {}", spoken(top, multiplies), spoken(bottom, multiplies))
        }
        Formula::Fraction(top, bottom) => {
            format!(
                "the fraction {} over {}, end of fraction,",
                spoken(top, multiplies),
                spoken(bottom, multiplies)
            )
        }
        Formula::Root(inner) if inner.is_single() => {
            format!("the square root of {}", spoken(inner, multiplies))
        }
        Formula::Root(inner) => format!("the square root of {}, end of root,", spoken(inner, multiplies)),
        Formula::Fenced(_, inner, _) if matches!(**inner, Formula::Matrix(_)) => spoken(inner, multiplies),
        Formula::Fenced(left, inner, right) => {
            let bracket = |bracket: &Option<char>| bracket.map_or_else(String::new, sign);
            format!("{} {} {}", bracket(left), spoken(inner, multiplies), bracket(right))
        }
        Formula::Matrix(rows) => {
            let columns = rows.first().map_or(0, Vec::len);
            let told = rows.iter().enumerate().map(|(number, row)| {
                let entries: Vec<String> = row.iter().map(|entry| spoken(entry, multiplies)).collect();
                format!("row {}: {}", number + 1, entries.join(", "))
            });
            let told: Vec<String> = told.collect();
            format!("the matrix of {} by {columns}, {}, end of matrix,", rows.len(), told.join("; "))
        }
    }
}

fn row(pieces: &[Formula], multiplies: bool) -> String {
    let mut words = String::new();
    let mut before: Option<&Formula> = None;
    for piece in pieces.iter().filter(|piece| !matches!(piece, Formula::Space(_))) {
        if multiplies && before.is_some_and(ends_a_factor) && begins_a_factor(piece) {
            words.push_str(" times");
        }
        words.push(' ');
        words.push_str(&spoken(piece, multiplies));
        before = Some(piece);
    }
    words
}

/// Whether what follows is multiplied by it: not by the sign of a derivative or of a difference.
fn ends_a_factor(piece: &Formula) -> bool {
    match piece {
        Formula::Letter(letter) => !matches!(letter, 'd' | 'Δ' | '∂'),
        Formula::Mark(mark) => matches!(mark, ')' | ']' | '′' | '°'),
        Formula::Sign(_) | Formula::Function(_) | Formula::Words(_) | Formula::Space(_) => false,
        Formula::Script { base, .. } => ends_a_factor(base),
        _ => true,
    }
}

fn begins_a_factor(piece: &Formula) -> bool {
    match piece {
        Formula::Mark(mark) => matches!(mark, '(' | '['),
        Formula::Sign(_) | Formula::Words(_) | Formula::Space(_) => false,
        _ => true,
    }
}

fn power(raised: &Formula) -> String {
    match spoken(raised, true).trim() {
        "2" => "squared".to_owned(),
        "3" => "cubed".to_owned(),
        "prime" => "prime".to_owned(),
        other => format!("to the power of {other}"),
    }
}

const fn above(accent: Accent) -> &'static str {
    match accent {
        Accent::Dot => "dot",
        Accent::TwoDots => "double dot",
        Accent::Bar => "bar",
        Accent::Hat => "hat",
        Accent::Arrow => "vector",
    }
}

fn function(name: &'static str) -> &'static str {
    match name {
        "sin" => "sine of",
        "cos" => "cosine of",
        "tan" => "tangent of",
        "exp" => "the exponential of",
        "ln" => "the natural logarithm of",
        "log" => "the logarithm of",
        "det" => "the determinant of",
        "max" => "the maximum of",
        "min" => "the minimum of",
        "Re" => "the real part of",
        "Im" => "the imaginary part of",
        other => other,
    }
}

fn letter(letter: char) -> String {
    let name = match letter {
        'α' => "alpha",
        'β' => "beta",
        'γ' => "gamma",
        'δ' => "delta",
        'ε' => "epsilon",
        'ζ' => "zeta",
        'η' => "eta",
        'θ' => "theta",
        'ι' => "iota",
        'κ' => "kappa",
        'λ' => "lambda",
        'μ' => "mu",
        'ν' => "nu",
        'ξ' => "xi",
        'π' => "pi",
        'ρ' => "rho",
        'σ' => "sigma",
        'τ' => "tau",
        'υ' => "upsilon",
        'φ' => "phi",
        'χ' => "chi",
        'ψ' => "psi",
        'ω' => "omega",
        'Γ' => "capital gamma",
        'Δ' => "delta",
        'Θ' => "capital theta",
        'Λ' => "capital lambda",
        'Ξ' => "capital xi",
        'Π' => "capital pi",
        'Σ' => "capital sigma",
        'Φ' => "capital phi",
        'Ψ' => "capital psi",
        'Ω' => "capital omega",
        '∂' => "partial",
        '∞' => "infinity",
        other => return other.to_string(),
    };
    name.to_owned()
}

fn sign(sign: char) -> String {
    let name = match sign {
        '+' => "plus",
        '−' => "minus",
        '=' => "equals",
        '·' | '×' => "times",
        '±' => "plus or minus",
        '≈' => "is about",
        '<' => "is less than",
        '>' => "is greater than",
        '≤' => "is at most",
        '≥' => "is at least",
        '≠' => "is not",
        '→' => "goes to",
        '⇒' => "hence",
        '/' => "over",
        '°' => "degrees",
        '′' => "prime",
        '∑' => "the sum of",
        '(' => "open bracket",
        ')' => "close bracket",
        '[' => "open square bracket",
        ']' => "close square bracket",
        '{' => "open brace",
        '}' => "close brace",
        '|' => "bar",
        '…' | '⋯' => "and so on",
        other => return other.to_string(),
    };
    name.to_owned()
}

#[cfg(test)]
mod tests {
    use super::super::formula_file::read;

    #[test]
    fn a_formula_is_read_in_plain_words() {
        for (written, words) in [
            (
                r"\dot{u} = X_u u + X_w w - g\cos\theta_0",
                "u dot equals X sub u times u plus X sub w times w minus g times cosine of theta sub 0",
            ),
            (r"\omega_0^2 = \sqrt{k}", "omega sub 0 squared equals the square root of k"),
            (r"C_{m\alpha} < 0", "C sub m alpha is less than 0"),
            (r"\frac{g}{U_0}t", "g over U sub 0 times t"),
            (r"\zeta = \frac{a+b}{2}", "zeta equals the fraction a plus b over 2, end of fraction,"),
            (r"\frac{dx}{dt}", "the fraction d x over d t, end of fraction,"),
            (
                r"A = \begin{bmatrix} a & -b \\ 0 & 1 \end{bmatrix}",
                "A equals the matrix of 2 by 2, row 1: a, minus b; row 2: 0, 1, end of matrix,",
            ),
            (r"\ddot\alpha", "alpha double dot"),
        ] {
            assert_eq!(read(written).map(|formula| formula.in_words()), Ok(words.to_owned()), "{written}");
        }
    }
}
