//! The reader of a formula: the part of TeX that equations of flight need. Any text gives a formula, or a sentence that says what
//! was expected.

use super::formula::{Accent, Formula};
use super::number::unknown;

/// Letters and signs by their commands. All of them are in the faces of the page.
const LETTERS: [(&str, char); 37] = [
    ("alpha", 'α'),
    ("beta", 'β'),
    ("gamma", 'γ'),
    ("delta", 'δ'),
    ("epsilon", 'ε'),
    ("varepsilon", 'ε'),
    ("zeta", 'ζ'),
    ("eta", 'η'),
    ("theta", 'θ'),
    ("iota", 'ι'),
    ("kappa", 'κ'),
    ("lambda", 'λ'),
    ("mu", 'μ'),
    ("nu", 'ν'),
    ("xi", 'ξ'),
    ("pi", 'π'),
    ("rho", 'ρ'),
    ("sigma", 'σ'),
    ("tau", 'τ'),
    ("upsilon", 'υ'),
    ("phi", 'φ'),
    ("varphi", 'φ'),
    ("chi", 'χ'),
    ("psi", 'ψ'),
    ("omega", 'ω'),
    ("Gamma", 'Γ'),
    ("Delta", 'Δ'),
    ("Theta", 'Θ'),
    ("Lambda", 'Λ'),
    ("Xi", 'Ξ'),
    ("Pi", 'Π'),
    ("Sigma", 'Σ'),
    ("Phi", 'Φ'),
    ("Psi", 'Ψ'),
    ("Omega", 'Ω'),
    ("partial", '∂'),
    ("infty", '∞'),
];

const SIGNS: [(&str, char); 15] = [
    ("cdot", '·'),
    ("times", '×'),
    ("pm", '±'),
    ("approx", '≈'),
    ("le", '≤'),
    ("leq", '≤'),
    ("ge", '≥'),
    ("geq", '≥'),
    ("ne", '≠'),
    ("neq", '≠'),
    ("to", '→'),
    ("rightarrow", '→'),
    ("Rightarrow", '⇒'),
    ("lt", '<'),
    ("gt", '>'),
];

const MARKS: [(&str, char); 9] = [
    ("circ", '°'),
    ("degree", '°'),
    ("prime", '′'),
    ("sum", '∑'),
    ("ldots", '…'),
    ("dots", '…'),
    ("cdots", '⋯'),
    ("{", '{'),
    ("}", '}'),
];

const SPACES: [(&str, f32); 7] =
    [(",", 0.17), (":", 0.22), (";", 0.28), ("!", 0.0), (" ", 0.3), ("quad", 1.0), ("qquad", 2.0)];

const FUNCTIONS: [&str; 11] = ["sin", "cos", "tan", "exp", "ln", "log", "max", "min", "det", "Re", "Im"];

const ACCENTS: [(&str, Accent); 7] = [
    ("dot", Accent::Dot),
    ("ddot", Accent::TwoDots),
    ("bar", Accent::Bar),
    ("overline", Accent::Bar),
    ("hat", Accent::Hat),
    ("vec", Accent::Arrow),
    ("mathbf", Accent::Arrow),
];

/// Commands with a form of their own.
const OTHERS: [&str; 9] = ["frac", "dfrac", "tfrac", "sqrt", "left", "right", "begin", "text", "mathrm"];

/// Kinds of matrices, with their brackets.
const MATRICES: [(&str, Option<(char, char)>); 4] = [
    ("bmatrix", Some(('[', ']'))),
    ("pmatrix", Some(('(', ')'))),
    ("vmatrix", Some(('|', '|'))),
    ("matrix", None),
];

/// Formulas within formulas that are read at most.
const DEEPEST: usize = 24;
const TOO_DEEP: &str = "expected a formula that goes less deep";

/// Reads a formula. The error is a sentence, with the offset of what it is about.
pub(super) fn read(text: &str) -> Result<Formula, (usize, String)> {
    let mut reader = Reader { text, at: 0, depth: 0 };
    let formula = reader.row(&[])?;
    match reader.peek() {
        None if matches!(&formula, Formula::Row(pieces) if pieces.is_empty()) => {
            Err((0, "expected a formula, found nothing".to_owned()))
        }
        None => Ok(formula),
        Some(found) => Err((reader.at, format!("expected a formula, found {found}"))),
    }
}

struct Reader<'t> {
    text: &'t str,
    at: usize,
    depth: usize,
}

type Read<T> = Result<T, (usize, String)>;

impl<'t> Reader<'t> {
    fn rest(&self) -> &'t str {
        &self.text[self.at..]
    }

    fn peek(&self) -> Option<char> {
        self.rest().chars().next()
    }

    fn take(&mut self) -> Option<char> {
        let next = self.peek()?;
        self.at += next.len_utf8();
        Some(next)
    }

    fn skip_space(&mut self) {
        while self.peek().is_some_and(char::is_whitespace) {
            self.take();
        }
    }

    fn eat(&mut self, what: &str) -> bool {
        let eaten = self.rest().starts_with(what);
        if eaten {
            self.at += what.len();
        }
        eaten
    }

    fn fail<T>(&self, problem: impl Into<String>) -> Read<T> {
        Err((self.at, problem.into()))
    }

    /// Pieces up to the end, a closing brace, or one of these, none of which is taken.
    fn row(&mut self, ends: &[&str]) -> Read<Formula> {
        self.depth += 1;
        if self.depth > DEEPEST {
            return self.fail(TOO_DEEP);
        }
        let mut pieces: Vec<Formula> = Vec::new();
        loop {
            self.skip_space();
            let stops = self.peek().is_none_or(|next| next == '}');
            if stops || ends.iter().any(|end| self.rest().starts_with(end)) {
                break;
            }
            let piece = self.piece()?;
            pieces.push(self.scripts(piece)?);
        }
        self.depth -= 1;
        Ok(Formula::Row(pieces))
    }

    /// What is lowered and raised beside a piece.
    fn scripts(&mut self, base: Formula) -> Read<Formula> {
        let (mut lowered, mut raised) = (None, None);
        loop {
            self.skip_space();
            match self.peek() {
                Some('_') if lowered.is_none() => {
                    self.take();
                    lowered = Some(Box::new(self.argument()?));
                }
                Some('^') if raised.is_none() => {
                    self.take();
                    raised = Some(Box::new(self.argument()?));
                }
                Some('\'') if raised.is_none() => {
                    self.take();
                    raised = Some(Box::new(Formula::Mark('′')));
                }
                Some('_' | '^' | '\'') => return self.fail("expected one _ and one ^ beside a symbol"),
                _ => break,
            }
        }
        if lowered.is_none() && raised.is_none() {
            return Ok(base);
        }
        Ok(Formula::Script { base: Box::new(base), lowered, raised })
    }

    /// What braces hold, or a single piece.
    fn argument(&mut self) -> Read<Formula> {
        self.skip_space();
        self.depth += 1;
        if self.depth > DEEPEST {
            return self.fail(TOO_DEEP);
        }
        let argument = self.bare_argument();
        self.depth -= 1;
        argument
    }

    fn bare_argument(&mut self) -> Read<Formula> {
        match self.peek() {
            Some('{') => self.group(),
            None | Some('}' | '_' | '^' | '&') => self.fail("expected a symbol or { and }"),
            Some(_) => {
                // As in TeX, a single figure.
                let before = self.at;
                match self.piece()? {
                    Formula::Number(text) if text.len() > 1 => {
                        self.at = before + 1;
                        Ok(Formula::Number(text[..1].to_owned()))
                    }
                    piece => Ok(piece),
                }
            }
        }
    }

    fn group(&mut self) -> Read<Formula> {
        self.skip_space();
        if !self.eat("{") {
            return self.fail("expected {");
        }
        let row = self.row(&[])?;
        if !self.eat("}") {
            return self.fail("expected }");
        }
        Ok(match row {
            // Braces around one piece are that piece.
            Formula::Row(mut pieces) if pieces.len() == 1 => pieces.remove(0),
            row => row,
        })
    }

    /// Plain text in braces.
    fn words(&mut self) -> Read<&'t str> {
        self.skip_space();
        if !self.eat("{") {
            return self.fail("expected {");
        }
        let Some(end) = self.rest().find('}') else { return self.fail("expected }") };
        let words = &self.rest()[..end];
        self.at += end + 1;
        Ok(words)
    }

    fn piece(&mut self) -> Read<Formula> {
        let start = self.at;
        let Some(first) = self.take() else { return self.fail("expected a symbol") };
        Ok(match first {
            '\\' => return self.command(start),
            '{' => {
                self.at = start;
                return self.group();
            }
            '0'..='9' | '.' => {
                while self.peek().is_some_and(|next| next.is_ascii_digit() || next == '.') {
                    self.take();
                }
                Formula::Number(self.text[start..self.at].to_owned())
            }
            '-' | '−' => Formula::Sign('−'),
            '+' | '=' | '<' | '>' | '±' | '×' | '·' | '≈' | '≤' | '≥' | '≠' | '→' | '⇒' => {
                Formula::Sign(first)
            }
            '(' | ')' | '[' | ']' | '|' | ',' | ';' | ':' | '!' | '/' | '°' | '′' | '…' | '%' | '?' => {
                Formula::Mark(first)
            }
            letter if letter.is_alphabetic() || matches!(letter, '∂' | '∞' | '∑' | '√') => {
                let letter = Formula::Letter(letter);
                // A letter and a combining dot.
                if self.eat("\u{307}") { Formula::Accent(Accent::Dot, Box::new(letter)) } else { letter }
            }
            '&' => return Err((start, "expected & within a matrix only".to_owned())),
            other => return Err((start, format!("expected a formula, found {other:?}"))),
        })
    }

    fn command(&mut self, start: usize) -> Read<Formula> {
        let name = self.rest();
        let letters = name.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(name.len());
        let length = if letters > 0 { letters } else { name.chars().next().map_or(0, char::len_utf8) };
        let name = &name[..length];
        self.at += length;
        if let Some(&(_, letter)) = LETTERS.iter().find(|(known, _)| *known == name) {
            return Ok(Formula::Letter(letter));
        }
        if let Some(&(_, sign)) = SIGNS.iter().find(|(known, _)| *known == name) {
            return Ok(Formula::Sign(sign));
        }
        if let Some(&(_, mark)) = MARKS.iter().find(|(known, _)| *known == name) {
            return Ok(Formula::Mark(mark));
        }
        if let Some(&(_, room)) = SPACES.iter().find(|(known, _)| *known == name) {
            return Ok(Formula::Space(room));
        }
        if let Some(function) = FUNCTIONS.into_iter().find(|known| *known == name) {
            return Ok(Formula::Function(function));
        }
        if let Some(&(_, accent)) = ACCENTS.iter().find(|(known, _)| *known == name) {
            return Ok(Formula::Accent(accent, Box::new(self.argument()?)));
        }
        match name {
            "frac" | "dfrac" | "tfrac" => {
                Ok(Formula::Fraction(Box::new(self.argument()?), Box::new(self.argument()?)))
            }
            "sqrt" => Ok(Formula::Root(Box::new(self.argument()?))),
            "text" | "mathrm" => Ok(Formula::Words(self.words()?.to_owned())),
            "left" => self.fenced(),
            "begin" => self.matrix(),
            "right" | "end" => Err((start, format!("\\{name} has no beginning"))),
            _ => {
                let tables = [LETTERS.map(|(name, _)| name).to_vec(), SIGNS.map(|(name, _)| name).to_vec()];
                let all = tables.into_iter().flatten().chain(MARKS.map(|(name, _)| name)).chain(FUNCTIONS);
                let all = all.chain(ACCENTS.map(|(name, _)| name)).chain(OTHERS);
                Err((start, unknown("command in formulas", name, all)))
            }
        }
    }

    /// A bracket after \left or \right; none for a point.
    fn bracket(&mut self) -> Read<Option<char>> {
        self.skip_space();
        self.eat("\\");
        match self.peek() {
            Some(bracket @ ('(' | ')' | '[' | ']' | '|' | '{' | '}')) => {
                self.take();
                Ok(Some(bracket))
            }
            Some('.') => {
                self.take();
                Ok(None)
            }
            _ => self.fail("expected a bracket, or . for none"),
        }
    }

    fn fenced(&mut self) -> Read<Formula> {
        let left = self.bracket()?;
        let inner = self.row(&["\\right"])?;
        if !self.eat("\\right") {
            return self.fail("expected \\right");
        }
        Ok(Formula::Fenced(left, Box::new(inner), self.bracket()?))
    }

    fn matrix(&mut self) -> Read<Formula> {
        let kind = self.words()?;
        let Some(&(_, brackets)) = MATRICES.iter().find(|(known, _)| *known == kind) else {
            return self.fail(unknown("kind of matrix", kind, MATRICES.iter().map(|(name, _)| *name)));
        };
        let mut rows = vec![Vec::new()];
        loop {
            let entry = self.row(&["&", "\\\\", "\\end"])?;
            if let Some(row) = rows.last_mut() {
                row.push(entry);
            }
            if self.eat("&") {
                continue;
            }
            if self.eat("\\\\") {
                self.skip_space();
                // After the last row it begins none.
                if !self.rest().starts_with("\\end") {
                    rows.push(Vec::new());
                    continue;
                }
            }
            break;
        }
        if !self.eat("\\end") || self.words()? != kind {
            return self.fail(format!("expected \\end{{{kind}}}"));
        }
        let columns = rows.first().map_or(0, Vec::len);
        if rows.iter().any(|row| row.len() != columns) {
            return self.fail(format!("expected {columns} entries in each row of the matrix"));
        }
        let matrix = Formula::Matrix(rows);
        Ok(match brackets {
            Some((left, right)) => Formula::Fenced(Some(left), Box::new(matrix), Some(right)),
            None => matrix,
        })
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn a_formula_in_one_line_is_what_was_written() {
        for (written, line) in [
            (r"\dot{u} = X_u u + X_w w - g\theta", "u̇ = X_{u}u + X_{w}w − gθ"),
            (r"\omega_0 = \sqrt{2}\,\frac{g}{U_0}", "ω_{0} = √2 g/U_{0}"),
            (r"x^2_{mα}", "x_{mα}^{2}"),
            (r"\frac12 \rho V^2", "1/2ρV^{2}"),
            (r"e^{\lambda t}\cos\theta_0", "e^{λt}cos θ_{0}"),
            (r"\left(\frac{a+b}{c}\right)", "((a + b)/c)"),
            (r"\begin{bmatrix} a & b \\ c & 0 \end{bmatrix}", "[a, b; c, 0]"),
            ("θ\u{307} = q", "θ\u{307} = q"),
        ] {
            assert_eq!(read(written).map(|formula| formula.line()), Ok(line.to_owned()), "{written}");
        }
    }

    #[test]
    fn what_can_t_be_read_is_told_with_its_place() {
        for (written, at, said) in [
            ("", 0, "expected a formula, found nothing"),
            (r"a + \lamda", 4, "there is no command in formulas \"lamda\"; did you mean \"lambda\"?"),
            (r"\frac{a}", 8, "expected a symbol or { and }"),
            ("{a", 2, "expected }"),
            ("a}", 1, "expected a formula, found }"),
            ("a_b_c", 3, "expected one _ and one ^ beside a symbol"),
            (r"\begin{bmatrix} a & b \\ c \end{bmatrix}", 40, "expected 2 entries in each row of the matrix"),
            (r"\left( a", 8, "expected \\right"),
            ("a & b", 2, "expected & within a matrix only"),
            ("a # b", 2, "expected a formula, found '#'"),
        ] {
            assert_eq!(read(written), Err((at, said.to_owned())), "{written}");
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

        #[test]
        fn any_text_is_a_formula_or_a_sentence(
            text in r"(\\(frac|sqrt|left|right|begin\{bmatrix\}|end\{bmatrix\}|dot|x|\\)|[{}()_^&a-z0-9 '.]|\PC){0,40}"
        ) {
            match read(&text) {
                Ok(formula) => prop_assert!(!formula.line().contains('\\')),
                Err((at, _)) => prop_assert!(text.is_char_boundary(at)),
            }
        }

        #[test]
        fn depth_is_no_danger(depth in 0..5000_usize, kind in 0..3_usize) {
            let _ = read(&["{", r"\frac", r"\left("][kind].repeat(depth));
        }
    }
}
