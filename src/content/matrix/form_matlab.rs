//! Matrices as MATLAB or Octave text: assignments of plain numbers and names. Nothing is evaluated.
//!
//! ```text
//! % units: SI
//! U0 = 53.6;
//! states = {'u', 'w', 'q', 'theta'};   inputs = {'elevator'};
//! A = [ -0.045  0.036  0  -9.81
//!        …                      ];
//! ```
//!
//! Statements about anything else are passed over.

use super::draft::{At, Draft, Entry, Problem, setting, setting_in_comment};

#[derive(Clone, Debug, PartialEq)]
enum Token {
    Word(String),
    Number(f64),
    Text(String),
    Symbol(char),
    /// The end of a line that goes on nowhere.
    End,
}

pub(super) fn read(text: &str) -> Result<Draft, Problem> {
    let mut draft = Draft::default();
    let (mut tokens, mut comments) = (Vec::new(), Vec::new());
    for (line, text) in (1..).zip(text.lines()) {
        if let Some(comment) = read_line(line, text, &mut tokens)? {
            comments.extend(setting_in_comment(comment).map(|(key, value)| (key, At { line, value })));
        }
    }
    let mut statements = Statements { tokens: &tokens, at: 0 };
    while let Some((name, line)) = statements.next_assignment() {
        if let Some(key) = setting(&name) {
            let entry = statements.value(key)?;
            draft.set(key, line, entry)?;
        }
    }
    if !draft.has("A") {
        return Err((1, "A: missing; expected a line that begins with \"A = [\"".to_owned()));
    }
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
            let number = rest[..length].parse();
            push(Token::Number(
                number.map_err(|_| (line, format!("expected a number, found \"{}\"", &rest[..length])))?,
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

fn number_length(text: &str) -> usize {
    let mut before = '+';
    let part_of_number = |c: char| {
        let part = c.is_ascii_digit() || matches!(c, '.' | 'e' | 'E');
        let sign = matches!(c, '+' | '-') && matches!(before, 'e' | 'E');
        before = c;
        part || sign
    };
    // The sign in front is a part of it.
    1 + text[1..].find(not(part_of_number)).unwrap_or(text.len() - 1)
}

fn not(mut holds: impl FnMut(char) -> bool) -> impl FnMut(char) -> bool {
    move |c| !holds(c)
}

struct Statements<'t> {
    tokens: &'t [At<Token>],
    at: usize,
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
                let name = name.clone();
                self.at += 1;
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

    /// A number, a text, a list of texts or a matrix.
    fn value(&mut self, key: &str) -> Result<Entry, Problem> {
        let line = self.line();
        let token = self.peek().cloned();
        self.at += 1;
        let entry = match token {
            Some(Token::Number(x)) => Entry::Number(x),
            Some(Token::Text(text)) => Entry::Text(text),
            Some(Token::Symbol('{')) => Entry::Names(self.names(key, '}')?),
            Some(Token::Symbol('[')) if matches!(self.peek(), Some(Token::Text(_))) => {
                Entry::Names(self.names(key, ']')?)
            }
            Some(Token::Symbol('[')) => Entry::Rows(self.rows(key)?),
            found => return Err((line, unexpected(key, found.as_ref()))),
        };
        match self.peek() {
            None | Some(Token::End | Token::Symbol(';' | ',')) => Ok(entry),
            found => Err((self.line(), unexpected(key, found))),
        }
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

    /// Rows end at a semicolon or at the end of a line.
    fn rows(&mut self, key: &str) -> Result<Vec<At<Vec<f64>>>, Problem> {
        let mut rows: Vec<At<Vec<f64>>> = Vec::new();
        let mut row = At { line: self.line(), value: Vec::new() };
        loop {
            let line = self.line();
            let token = self.peek().cloned();
            self.at += 1;
            let is_closed = match token {
                Some(Token::Number(x)) => {
                    if row.value.is_empty() {
                        row.line = line;
                    }
                    row.value.push(x);
                    continue;
                }
                Some(Token::Symbol(',')) => continue,
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
        Some(Token::End) => "the end of the line".to_owned(),
        None => "the end of the file".to_owned(),
    };
    format!("{key}: expected plain numbers or quoted names, found {found}; nothing is computed here")
}
