//! The tokens of a script: words, numbers, texts and signs, line by line, with the comments apart.

use super::draft::{At, Problem, number};

/// A token of a script.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Token {
    Word(String),
    Number(f64),
    Text(String),
    Symbol(char),
    /// A minus sign in front of a name.
    Minus,
    /// The end of a line that goes on nowhere.
    End,
}

/// The tokens of one line, and the comment at its end.
pub(super) fn read_line<'t>(
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
        } else if rest.starts_with("...") || rest.trim() == "\\" {
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

/// A sign, digits with a point, an exponent: E, or the D of Fortran. Three dots behind a number are MATLAB's sign that the line goes on.
fn number_length(text: &str) -> usize {
    let digits = |from: usize| text[from..].bytes().take_while(u8::is_ascii_digit).count();
    let signed = |at: usize| usize::from(text[at..].starts_with(['+', '-']));
    let goes_on = |at: usize| text[at..].starts_with("...") && !text[at..].starts_with("....");
    let start = signed(0);
    let whole = start + digits(start);
    let mut mantissa = whole;
    if text[whole..].starts_with('.') && !goes_on(whole) {
        mantissa += 1 + digits(whole + 1);
    }
    // Two points are no number, and are told to be none.
    if text[mantissa..].starts_with('.') && !goes_on(mantissa) {
        let is_mantissa = |byte: &u8| byte.is_ascii_digit() || *byte == b'.';
        return mantissa + text[mantissa..].bytes().take_while(is_mantissa).count();
    }
    if !text[mantissa..].starts_with(['e', 'E', 'd', 'D']) {
        return mantissa;
    }
    let exponent = mantissa + 1 + signed(mantissa + 1);
    let end = exponent + digits(exponent);
    if end > exponent { end } else { mantissa }
}
