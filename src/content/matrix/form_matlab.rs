//! Matrices as MATLAB, Octave or Python text: assignments of plain numbers and names. Nothing is evaluated, but the name of a number
//! that was given before stands for it.
//!
//! ```text
//! % units: SI
//! U0 = 53.6;
//! states = {'u', 'w', 'q', 'theta'};   inputs = {'elevator'};
//! A = [ -0.045  0.036  0  -9.81
//!        …                      ];
//! ```
//!
//! Rows may stand in brackets of their own, as in `np.array([[…], […]])`; a matrix may be a field, `P.A = […]`, or stand as the
//! program printed it, `A =` and the rows below, `1.0e+03 *` before them. Statements about anything else are passed over.

use super::draft::{At, Draft, Entry, Problem, number, setting, setting_in_comment};
use crate::number::{significant, trimmed};

#[derive(Clone, Debug, PartialEq)]
enum Token {
    Word(String),
    Number(f64),
    Text(String),
    Symbol(char),
    /// A minus sign in front of a name.
    Minus,
    /// The end of a line that goes on nowhere.
    End,
}

/// The functions of Python, and that of Maple, that make a matrix of their argument.
const MAKERS: [&str; 6] = ["array", "asarray", "matrix", "asmatrix", "mat", "Matrix"];

pub(in crate::content) fn read(text: &str) -> Result<Draft, Problem> {
    let mut draft = Draft::default();
    let (mut tokens, mut comments) = (Vec::new(), Vec::new());
    let (mut depth, mut in_docstring) = (0, false);
    for (line, text) in (1..).zip(text.lines()) {
        // A comment of several lines, of MATLAB and of Python.
        match text.trim() {
            "%{" | "#{" => depth += 1,
            "%}" | "#}" if depth > 0 => {
                depth -= 1;
                continue;
            }
            _ => {}
        }
        let quotes = text.matches("\"\"\"").count();
        let is_comment = depth > 0 || in_docstring || quotes > 0;
        in_docstring ^= quotes % 2 == 1;
        if is_comment {
            continue;
        }
        if let Some(comment) = read_line(line, text, &mut tokens)? {
            comments.extend(setting_in_comment(comment).map(|(key, value)| (key, At { line, value })));
        }
    }
    let lines: Vec<&str> = text.lines().collect();
    let mut statements =
        Statements { tokens: &tokens, at: 0, lines: &lines, remarks: Vec::new(), numbers: Vec::new() };
    while let Some((name, line)) = statements.next_assignment() {
        if let Some(key) = setting(&name) {
            let entry = statements.value(key)?;
            if let Entry::Number(value) = entry {
                statements.numbers.push((name, value));
            }
            draft.set(key, line, entry)?;
            continue;
        }
        let before = statements.at;
        match statements.value(&name) {
            Ok(Entry::Rows(value)) => draft.strangers.push((name, At { line, value })),
            Ok(Entry::Number(value)) => statements.numbers.push((name, value)),
            // What is computed has no number here, and an earlier one of this name counts no more.
            _ => {
                statements.numbers.retain(|(known, _)| *known != name);
                statements.at = before;
            }
        }
    }
    draft.remarks = statements.remarks;
    // A comment counts only if no variable says the same.
    comments.retain(|(key, _)| !draft.has(key));
    for (key, At { line, value }) in comments {
        draft.set(key, line, value)?;
    }
    Ok(draft)
}

/// The tokens of one line, and the comment at its end.
fn read_line<'t>(
    line: usize,
    text: &'t str,
    tokens: &mut Vec<At<Token>>,
) -> Result<Option<&'t str>, Problem> {
    let mut rest = text;
    let mut comment = None;
    let mut push = |value| tokens.push(At { line, value });
    // Whether a quote transposes what stands before it and a sign is an operation on it.
    let mut after_operand = false;
    while let Some(c) = rest.chars().next() {
        let next_is_number =
            rest[c.len_utf8()..].starts_with(|next: char| next.is_ascii_digit() || next == '.');
        let length = if c == '%' || c == '#' {
            comment = Some(&rest[1..]);
            break;
        } else if rest.starts_with("...") {
            return Ok(None);
        } else if c.is_whitespace() {
            after_operand = false;
            rest = &rest[c.len_utf8()..];
            continue;
        } else if c.is_ascii_digit()
            || (c == '.' && next_is_number)
            || (matches!(c, '+' | '-') && next_is_number && !after_operand)
        {
            let length = number_length(rest);
            let found = &rest[..length];
            push(Token::Number(
                number(found).ok_or_else(|| (line, format!("expected a number, found \"{found}\"")))?,
            ));
            length
        } else if c.is_alphabetic() {
            let length = rest.find(|c: char| !(c.is_alphanumeric() || c == '_')).unwrap_or(rest.len());
            push(Token::Word(rest[..length].to_owned()));
            length
        } else if matches!(c, '\'' | '"') && !(c == '\'' && after_operand) {
            let end = rest[1..].find(c).ok_or_else(|| (line, "a text has no closing quote".to_owned()))?;
            push(Token::Text(rest[1..=end].to_owned()));
            end + 2
        } else if c == '-' && !after_operand && rest[1..].starts_with(char::is_alphabetic) {
            push(Token::Minus);
            1
        } else {
            push(Token::Symbol(c));
            c.len_utf8()
        };
        after_operand = !matches!(c, '[' | '{' | '(' | ',' | ';' | '=');
        rest = &rest[length..];
    }
    push(Token::End);
    Ok(comment)
}

/// A sign, digits with a point, an exponent: E, or the D of Fortran.
fn number_length(text: &str) -> usize {
    let digits = |from: usize| text[from..].bytes().take_while(u8::is_ascii_digit).count();
    let signed = |at: usize| usize::from(text[at..].starts_with(['+', '-']));
    let is_mantissa = |byte: &u8| byte.is_ascii_digit() || *byte == b'.';
    let start = signed(0);
    let mantissa = start + text[start..].bytes().take_while(is_mantissa).count();
    if !text[mantissa..].starts_with(['e', 'E', 'd', 'D']) {
        return mantissa;
    }
    let exponent = mantissa + 1 + signed(mantissa + 1);
    let end = exponent + digits(exponent);
    if end > exponent { end } else { mantissa }
}

struct Statements<'t> {
    tokens: &'t [At<Token>],
    at: usize,
    lines: &'t [&'t str],
    remarks: Vec<String>,
    /// Numbers that were given a name, the last of a name last.
    numbers: Vec<(String, f64)>,
}

impl Statements<'_> {
    fn peek(&self) -> Option<&Token> {
        self.tokens.get(self.at).map(|token| &token.value)
    }

    fn line(&self) -> usize {
        self.tokens.get(self.at).or(self.tokens.last()).map_or(1, |token| token.line)
    }

    fn skip(&mut self, symbol: char) -> bool {
        let found = self.peek() == Some(&Token::Symbol(symbol));
        self.at += usize::from(found);
        found
    }

    /// Goes to the value of the next assignment; its name and line.
    fn next_assignment(&mut self) -> Option<(String, usize)> {
        let (mut depth, mut at_start) = (0_i32, true);
        while let Some(token) = self.peek() {
            let line = self.line();
            if let (true, Token::Word(name)) = (at_start && depth == 0, token) {
                let mut name = name.clone();
                self.at += 1;
                // A field goes by its own name: P.A is A.
                while self.skip('.') {
                    if let Some(Token::Word(field)) = self.peek() {
                        name = field.clone();
                        self.at += 1;
                    }
                }
                let assigns = self.skip('=') && !self.skip('=');
                if assigns {
                    return Some((name, line));
                }
                at_start = false;
                continue;
            }
            match token {
                Token::Symbol('[' | '{' | '(') => depth += 1,
                Token::Symbol(']' | '}' | ')') => depth -= 1,
                _ => {}
            }
            at_start = depth <= 0 && matches!(token, Token::End | Token::Symbol(';' | ','));
            self.at += 1;
        }
        None
    }

    /// The number of a token, or of a name with its sign; the place goes on past a name that a sign stands before.
    fn number(&mut self, token: Option<&Token>) -> Option<f64> {
        let known =
            |word: &str| self.numbers.iter().rev().find(|(name, _)| name == word).map(|(_, value)| *value);
        match token? {
            Token::Number(x) => Some(*x),
            Token::Word(word) => known(word),
            Token::Minus => {
                let Some(Token::Word(word)) = self.peek() else { return None };
                let value = known(word)?;
                self.at += 1;
                Some(-value)
            }
            _ => None,
        }
    }

    /// A number, a text, a list of texts or a matrix.
    fn value(&mut self, key: &str) -> Result<Entry, Problem> {
        let calls = self.skip_makers();
        let line = self.line();
        let token = self.peek().cloned();
        self.at += 1;
        let entry = match token {
            Some(Token::Number(x)) => Entry::Number(x),
            // numpy's matrix('1 2; 3 4')
            Some(Token::Text(text)) if calls > 0 => {
                let unread = || (line, format!("{key}: expected rows of numbers, found \"{text}\""));
                Entry::Rows(rows_of_text(&text, line).ok_or_else(unread)?)
            }
            Some(Token::Text(text)) => Entry::Text(text),
            Some(Token::Symbol('{')) => Entry::Names(self.names(key, '}')?),
            Some(Token::Symbol('[')) if matches!(self.peek(), Some(Token::Text(_))) => {
                Entry::Names(self.names(key, ']')?)
            }
            Some(Token::Symbol('[')) => Entry::Rows(self.rows(key)?),
            Some(Token::End) if calls == 0 => return self.printed(key, line),
            found => return Err((line, unexpected(key, found.as_ref()))),
        };
        let entry = self.leave(calls, entry);
        match self.peek() {
            None | Some(Token::End | Token::Symbol(';' | ',')) => Ok(entry),
            found => Err((self.line(), unexpected(key, found))),
        }
    }

    /// Goes into `np.array(` and its like; the number of brackets to come out of.
    fn skip_makers(&mut self) -> usize {
        let mut calls = 0;
        loop {
            let start = self.at;
            let mut made = false;
            while let Some(Token::Word(word)) = self.peek() {
                made = MAKERS.contains(&word.as_str());
                self.at += 1;
                if !self.skip('.') {
                    break;
                }
            }
            if !(made && self.skip('(')) {
                self.at = start;
                return calls;
            }
            calls += 1;
        }
    }

    /// Comes out of calls, past what else they are told; `.T` behind them turns rows into columns.
    fn leave(&mut self, mut calls: usize, entry: Entry) -> Entry {
        let called = calls > 0;
        while calls > 0 {
            match self.peek() {
                Some(Token::Symbol('(')) => calls += 1,
                Some(Token::Symbol(')')) => calls -= 1,
                None => break,
                Some(_) => {}
            }
            self.at += 1;
        }
        let turned = called
            && self.peek() == Some(&Token::Symbol('.'))
            && self.tokens.get(self.at + 1).is_some_and(|token| token.value == Token::Word("T".to_owned()));
        match entry {
            Entry::Rows(rows) if turned => {
                self.at += 2;
                Entry::Rows(transposed(&rows))
            }
            entry => entry,
        }
    }

    /// A matrix as the program prints it: empty lines, perhaps `1.0e+03 *`, and rows of numbers.
    fn printed(&mut self, key: &str, line: usize) -> Result<Entry, Problem> {
        self.skip_ends();
        let mut scale = 1.0;
        if let (Some(Token::Number(factor)), Some(Token::Symbol('*'))) =
            (self.peek().cloned(), self.tokens.get(self.at + 1).map(|token| &token.value))
        {
            scale = factor;
            self.at += 2;
            self.skip_ends();
        }
        let mut rows: Vec<At<Vec<f64>>> = Vec::new();
        while let Some(Token::Number(x)) = self.peek().cloned() {
            let line = self.line();
            match rows.last_mut() {
                Some(row) if row.line == line => row.value.push(x * scale),
                _ => rows.push(At { line, value: vec![x * scale] }),
            }
            self.at += 1;
            while matches!(self.peek(), Some(Token::End)) && self.is_row_below() {
                self.at += 1;
            }
        }
        let (Some(first), Some(last)) = (rows.first(), rows.last()) else {
            return Err((line, unexpected(key, Some(&Token::End))));
        };
        self.remarks.extend(lost_digits(key, scale, &self.lines[first.line - 1..last.line]));
        Ok(Entry::Rows(rows))
    }

    fn skip_ends(&mut self) {
        while self.peek() == Some(&Token::End) {
            self.at += 1;
        }
    }

    /// Whether the next line begins with a number.
    fn is_row_below(&self) -> bool {
        matches!(self.tokens.get(self.at + 1).map(|token| &token.value), Some(Token::Number(_)))
    }

    fn names(&mut self, key: &str, closing: char) -> Result<Vec<String>, Problem> {
        let mut names = Vec::new();
        loop {
            let line = self.line();
            let token = self.peek().cloned();
            self.at += 1;
            match token {
                Some(Token::Text(name)) => names.push(name),
                Some(Token::Symbol(',' | ';') | Token::End) => {}
                Some(Token::Symbol(c)) if c == closing => break,
                None => {
                    return Err((line, format!("{key}: \"{closing}\" is missing at the end of the list")));
                }
                found => return Err((line, unexpected(key, found.as_ref()))),
            }
        }
        // A column of names is as good as a row.
        self.skip('\'');
        Ok(names)
    }

    /// The numbers up to the bracket that closes them.
    fn row(&mut self, key: &str) -> Result<Vec<f64>, Problem> {
        let mut row = Vec::new();
        loop {
            let line = self.line();
            let token = self.peek().cloned();
            self.at += 1;
            if let Some(x) = self.number(token.as_ref()) {
                row.push(x);
                continue;
            }
            match token {
                Some(Token::Symbol(',') | Token::End) => {}
                Some(Token::Symbol(']')) => return Ok(row),
                None => return Err((line, format!("{key}: \"]\" is missing at the end of the row"))),
                found => return Err((line, unexpected(key, found.as_ref()))),
            }
        }
    }

    /// Rows end at a semicolon or at the end of a line.
    fn rows(&mut self, key: &str) -> Result<Vec<At<Vec<f64>>>, Problem> {
        let mut rows: Vec<At<Vec<f64>>> = Vec::new();
        let mut row = At { line: self.line(), value: Vec::new() };
        loop {
            let line = self.line();
            let token = self.peek().cloned();
            self.at += 1;
            if let Some(x) = self.number(token.as_ref()) {
                if row.value.is_empty() {
                    row.line = line;
                }
                row.value.push(x);
                continue;
            }
            let is_closed = match token {
                Some(Token::Symbol(',')) => continue,
                // A row in brackets of its own may go over several lines.
                Some(Token::Symbol('[')) if row.value.is_empty() => {
                    let value = self.row(key)?;
                    rows.push(At { line, value });
                    continue;
                }
                Some(Token::Symbol(';') | Token::End) => false,
                Some(Token::Symbol(']')) => true,
                None => return Err((line, format!("{key}: \"]\" is missing at the end of the matrix"))),
                found => return Err((line, unexpected(key, found.as_ref()))),
            };
            if !row.value.is_empty() {
                rows.push(std::mem::replace(&mut row, At { line, value: Vec::new() }));
            }
            if is_closed {
                return Ok(if self.skip('\'') { transposed(&rows) } else { rows });
            }
        }
    }
}

/// The sentence about a printed matrix whose digits are not all there: it has so many decimals times a scale.
fn lost_digits(key: &str, scale: f64, lines: &[&str]) -> Option<String> {
    let words = || lines.iter().flat_map(|line| line.split_whitespace());
    let decimals = |word: &str| word.rsplit_once('.').map_or(0, |(_, digits)| digits.len());
    if words().any(|word| word.contains(['e', 'E'])) {
        return None;
    }
    let most = words().map(decimals).max()?;
    let band = 0.5 * scale * 10_f64.powi(-i32::try_from(most).ok()?);
    // An exact zero is printed as 0; what has decimals and no digits was not zero.
    let gone = words().filter(|word| decimals(word) > 0 && number(word) == Some(0.0)).count();
    let told = significant(band, 2);
    (gone > 0 || scale != 1.0).then(|| {
        format!(
            "{key} stands as it was printed, with {most} decimals{}: an entry is known to ±{told} only, and {gone} that are not \
             zero are printed as 0. Print it with “format long g”, or as mat2str(A, 17).",
            if scale == 1.0 { String::new() } else { format!(" times {}", trimmed(scale, 4)) },
        )
    })
}

/// Rows of numbers, parted by semicolons.
fn rows_of_text(text: &str, line: usize) -> Option<Vec<At<Vec<f64>>>> {
    let row = |row: &str| {
        let words = row.split([' ', ',']).filter(|word| !word.is_empty());
        Some(At { line, value: words.map(number).collect::<Option<Vec<f64>>>()? })
    };
    text.split(';').map(row).collect()
}

/// Columns as rows; a row too short leaves its columns short, which is found later.
fn transposed(rows: &[At<Vec<f64>>]) -> Vec<At<Vec<f64>>> {
    let columns = rows.iter().map(|row| row.value.len()).max().unwrap_or(0);
    (0..columns)
        .map(|k| At {
            line: rows[0].line,
            value: rows.iter().filter_map(|row| row.value.get(k).copied()).collect(),
        })
        .collect()
}

fn unexpected(key: &str, found: Option<&Token>) -> String {
    let found = match found {
        Some(Token::Word(word)) => format!("\"{word}\""),
        Some(Token::Number(x)) => x.to_string(),
        Some(Token::Text(text)) => format!("'{text}'"),
        Some(Token::Symbol(c)) => format!("\"{c}\""),
        Some(Token::Minus) => "\"-\"".to_owned(),
        Some(Token::End) => "the end of the line".to_owned(),
        None => "the end of the file".to_owned(),
    };
    format!("{key}: expected plain numbers or quoted names, found {found}; nothing is computed here")
}
