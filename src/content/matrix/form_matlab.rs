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
//! program printed it, `A =` and the rows below, `1.0e+03 *` before them, in parts headed `Columns 1 through 8`. Statements about
//! anything else are passed over; one that changes an entry of a matrix is refused.

use super::decimal_commas;
use super::draft::{At, Draft, Entry, Problem, Rows, number, setting, setting_in_comment};
use super::script_tokens::{Token, read_line};
use crate::number::{significant, trimmed};

/// The functions of Python, and that of Maple, that make a matrix of their argument.
const MAKERS: [&str; 6] = ["array", "asarray", "matrix", "asmatrix", "mat", "Matrix"];

pub(in crate::content) fn read(text: &str) -> Result<Draft, Problem> {
    let mut draft = Draft::default();
    let text = &*decimal_commas::in_script(text);
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
    while let Some(Statement { name, line, changes }) = statements.next_statement() {
        let key = setting(&name);
        if changes {
            let problem = format!(
                "{name} is changed here after it was given; nothing is computed, so give it as it is in the end"
            );
            if key.is_some_and(|key| draft.has(key)) {
                return Err((line, problem));
            }
            if draft.strangers.iter().any(|(known, _)| *known == name) {
                draft.changed.push((name.clone(), (line, problem)));
            }
            statements.numbers.retain(|(known, _)| *known != name);
            continue;
        }
        if let Some(key) = key {
            let entry = statements.value(key)?;
            if let Entry::Number(value) = entry {
                statements.numbers.push((name, value));
            }
            draft.set(key, line, entry)?;
            continue;
        }
        let before = statements.at;
        let value = statements.value(&name);
        // What is given again, or computed, is not what it was.
        statements.numbers.retain(|(known, _)| *known != name);
        draft.strangers.retain(|(known, _)| *known != name);
        match value {
            Ok(Entry::Rows(value)) => draft.strangers.push((name, At { line, value })),
            Ok(Entry::Number(value)) => statements.numbers.push((name, value)),
            _ => {
                statements.at = before;
                statements.skip_statement();
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

/// The beginning of a statement about a name.
struct Statement {
    name: String,
    line: usize,
    /// Whether it changes what has the name, `A(3, 2) = …` or `A *= …`, and doesn't give it.
    changes: bool,
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

    /// Goes to the value of the next assignment, or past the beginning of one that changes something.
    fn next_statement(&mut self) -> Option<Statement> {
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
                if self.assigns(self.at) {
                    self.at += 1;
                    return Some(Statement { name, line, changes: false });
                }
                let operates = matches!(self.peek(), Some(Token::Symbol('+' | '-' | '*' | '/')));
                let changed = if operates { Some(self.at + 1) } else { self.after_index() };
                if let Some(at) = changed.filter(|&at| self.assigns(at)) {
                    self.at = at + 1;
                    self.skip_statement();
                    return Some(Statement { name, line, changes: true });
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

    /// Whether a sign of assignment, and none of comparison, stands there.
    fn assigns(&self, at: usize) -> bool {
        let is = |at: usize| self.tokens.get(at).is_some_and(|token| token.value == Token::Symbol('='));
        is(at) && !is(at + 1)
    }

    /// The place behind the brackets of an index, which begin here.
    fn after_index(&self) -> Option<usize> {
        let mut depth = 0_i32;
        for (at, token) in self.tokens.iter().enumerate().skip(self.at) {
            match token.value {
                Token::Symbol('[' | '{' | '(') => depth += 1,
                Token::Symbol(']' | '}' | ')') => depth -= 1,
                _ => {}
            }
            if depth <= 0 {
                return (at > self.at).then_some(at + 1);
            }
        }
        None
    }

    /// Goes to the end of a statement.
    fn skip_statement(&mut self) {
        let mut depth = 0_i32;
        while let Some(token) = self.peek() {
            match token {
                Token::Symbol('[' | '{' | '(') => depth += 1,
                Token::Symbol(']' | '}' | ')') => depth -= 1,
                Token::End | Token::Symbol(';' | ',') if depth <= 0 => return,
                _ => {}
            }
            self.at += 1;
        }
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
        let shape = if calls > 0 { self.shape_before() } else { None };
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
        let mut entry = self.leave(calls, entry);
        if let (Entry::Rows(rows), Some((m, n))) = (&entry, shape.or_else(|| self.shape_behind())) {
            entry = Entry::Rows(reshaped(key, line, rows, m, n)?);
        }
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

    /// The tokens here as numbers and signs, each number as its place in `pattern` that is a blank.
    fn numbers_in(&mut self, pattern: &str) -> Option<Vec<usize>> {
        let mut numbers = Vec::new();
        let mut at = self.at;
        for sign in pattern.chars() {
            match &self.tokens.get(at)?.value {
                Token::Number(x) if sign == ' ' && *x >= 1.0 && x.fract() == 0.0 => numbers.push(*x as usize),
                Token::Symbol(c) if *c == sign => {}
                _ => return None,
            }
            at += 1;
        }
        self.at = at;
        Some(numbers)
    }

    /// Rows and columns in front of a flat list: `Matrix(4, 4, […])`.
    fn shape_before(&mut self) -> Option<(usize, usize)> {
        let numbers = self.numbers_in(" , ,")?;
        Some((numbers[0], numbers[1]))
    }

    /// Rows and columns behind a flat list: `.reshape(4, 4)`.
    fn shape_behind(&mut self) -> Option<(usize, usize)> {
        let start = self.at;
        let is_reshape = self.skip('.') && self.peek() == Some(&Token::Word("reshape".to_owned()));
        self.at += usize::from(is_reshape);
        let numbers =
            if is_reshape { self.numbers_in("( , )").or_else(|| self.numbers_in("(( , ))")) } else { None };
        if numbers.is_none() {
            self.at = start;
        }
        numbers.map(|numbers| (numbers[0], numbers[1]))
    }

    /// A matrix as the program prints it: empty lines, perhaps `1.0e+03 *`, and rows of numbers, the columns in parts where it is wide.
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
        self.skip_title_of_columns();
        let mut rows = self.printed_rows(scale);
        let mut last_line = rows.last().map_or(line, |row| row.line);
        loop {
            let before = self.at;
            self.skip_ends();
            if !self.skip_title_of_columns() {
                self.at = before;
                break;
            }
            let title = self.line();
            let part = self.printed_rows(scale);
            if part.len() != rows.len() {
                let problem =
                    format!("{key}: expected {} rows in this part too, found {}", rows.len(), part.len());
                return Err((title, problem));
            }
            last_line = part.last().map_or(last_line, |row| row.line);
            for (row, part) in rows.iter_mut().zip(part) {
                row.value.extend(part.value);
            }
        }
        let Some(first) = rows.first() else {
            return Err((line, unexpected(key, Some(&Token::End))));
        };
        self.remarks.extend(lost_digits(key, scale, &self.lines[first.line - 1..last_line]));
        Ok(Entry::Rows(rows))
    }

    /// `Columns 1 through 8`, and the empty lines below it.
    fn skip_title_of_columns(&mut self) -> bool {
        let is_title =
            matches!(self.peek(), Some(Token::Word(word)) if matches!(word.as_str(), "Columns" | "Column"));
        if is_title {
            self.skip_statement();
            self.skip_ends();
        }
        is_title
    }

    fn printed_rows(&mut self, scale: f64) -> Rows {
        let mut rows: Rows = Vec::new();
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
        rows
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

/// A list of numbers as m rows of n.
fn reshaped(key: &str, line: usize, list: &Rows, m: usize, n: usize) -> Result<Rows, Problem> {
    let numbers: Vec<f64> = list.iter().flat_map(|row| row.value.iter().copied()).collect();
    if m.checked_mul(n) != Some(numbers.len()) {
        return Err((
            line,
            format!("{key}: expected {m} rows of {n} numbers, found {} numbers", numbers.len()),
        ));
    }
    Ok(numbers.chunks(n).map(|row| At { line, value: row.to_vec() }).collect())
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
