//! One line of a list of links: where the link is, and what stands beside it.

use std::ops::Range;

use super::notes::minutes;
use crate::scenario::link;

/// What a line is.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Line {
    /// An empty line, or one that only rules a table.
    Nothing,
    /// Words without a link.
    Text(String),
    /// A link or more.
    Rows(Vec<Row>),
}

/// A link, and what the line says of it.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Row {
    /// What stands behind the `#`, or the whole of a link without one.
    pub link: String,
    /// Its heading; empty where the line has none.
    pub title: String,
    /// How long it takes \[min\], told with its unit.
    pub minutes: Option<f64>,
    /// A number that stands alone in its cell \[min\].
    pub begins: Option<f64>,
}

/// What ends an address besides a space: brackets, quotes, and the rules of a table.
const AROUND: &str = "<>()[]{}\"“”„‘’«»`|";

/// What no heading begins or ends with.
const BESIDE: &str = ":;,–—-|·>*_`→=\"“”„";

impl Line {
    /// Reads a line; any text is one.
    pub fn read(line: &str) -> Self {
        let line = line.trim();
        if line.is_empty() || line.chars().all(|c| "|-:+=`~ \t".contains(c)) {
            return Self::Nothing;
        }
        let spans = links(line);
        if spans.is_empty() {
            let words = tidy(without_marker(line));
            return if words.is_empty() { Self::Nothing } else { Self::Text(words) };
        }
        // The line without its links, in the cells of a table or in one.
        let (mut rest, mut end) = (String::new(), 0);
        for (whole, _) in &spans {
            rest.push_str(&line[end..whole.start]);
            rest.push(' ');
            end = whole.end;
        }
        rest.push_str(&line[end..]);
        let mut first = Row { link: String::new(), title: String::new(), minutes: None, begins: None };
        let mut titles = Vec::new();
        for cell in rest.split(['|', '\t']) {
            let cell = tidy(without_marker(cell.trim()));
            if let Some(number) = number(&cell) {
                first.begins = first.begins.or(Some(number));
            } else if let Some(minutes) = minutes(&cell) {
                first.minutes = first.minutes.or(Some(minutes));
            } else {
                let (cell, found) = without_minutes(&cell);
                first.minutes = first.minutes.or(found);
                titles.extend(Some(cell).filter(|cell| !cell.is_empty()));
            }
        }
        first.title = titles.join(" · ");
        let blank = Row { link: String::new(), title: String::new(), minutes: None, begins: None };
        let rows = spans.into_iter().enumerate().map(|(place, (_, link))| {
            // What the line says is said of its first link.
            let of = if place == 0 { &first } else { &blank };
            Row { link: line[link].to_owned(), ..of.clone() }
        });
        Self::Rows(rows.collect())
    }
}

/// The links in a text, a line, a space or a sign of a list apart, each without what stands before its scene.
pub(super) fn links_in(text: &str) -> impl Iterator<Item = &str> {
    links(text).into_iter().map(|(_, scene)| &text[scene])
}

/// The links of a line: where each stands with its address, and what of it is the scene.
fn links(line: &str) -> Vec<(Range<usize>, Range<usize>)> {
    let mut found = Vec::new();
    let mut start = None;
    let ends = |c: char| c.is_whitespace() || c.is_control() || AROUND.contains(c);
    // No scene has a comma or a semicolon, but an address before it may.
    let ends_scene =
        |from: usize, at: usize, c: char| ",;".contains(c) && scene_of(&line[from..at]).is_some();
    let chars = line.char_indices().map(|(at, c)| (at, Some(c))).chain([(line.len(), None)]);
    for (at, c) in chars {
        let is_end = c.is_none_or(|c| ends(c) || start.is_some_and(|from| ends_scene(from, at, c)));
        match (is_end, start) {
            (false, None) => start = Some(at),
            (true, Some(from)) => {
                let word = line[from..at].trim_end_matches(['.', ',', ';', ':', '!', '?', '*']);
                if let Some(scene) = scene_of(word) {
                    found.push((from..from + word.len(), from + scene..from + word.len()));
                }
                start = None;
            }
            _ => {}
        }
    }
    found
}

/// Where the scene of a word begins: behind the first `#`, or at its beginning.
fn scene_of(word: &str) -> Option<usize> {
    link::is_link(word).then(|| word.find('#').map_or(0, |at| at + 1))
}

/// A line without the mark or the number that makes it an item of a list.
fn without_marker(line: &str) -> &str {
    let marked = ["- ", "* ", "+ ", "• ", "– "].into_iter().find_map(|mark| line.strip_prefix(mark));
    let numbered = || {
        let rest = line.trim_start_matches(|c: char| c.is_ascii_digit());
        let rest = rest.strip_prefix(['.', ')']).filter(|_| rest.len() < line.len())?;
        rest.starts_with(' ').then_some(rest)
    };
    let hashes = line.trim_start_matches('#');
    let headed = (hashes.len() < line.len() && hashes.starts_with(' ')).then_some(hashes);
    marked.or_else(numbered).or(headed).unwrap_or(line).trim()
}

/// Words without what stood around a link.
fn tidy(text: &str) -> String {
    let clean: String = text.chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
    let mut clean = clean.split_whitespace().collect::<Vec<_>>().join(" ");
    for empty in ["( )", "[ ]", "< >", "()", "[]", "<>", "` `", "``"] {
        clean = clean.replace(empty, " ");
    }
    let is_beside = |c: char| c.is_whitespace() || BESIDE.contains(c);
    let words = clean.trim_matches(is_beside);
    // The end of a sentence that was a link.
    let words = words.strip_suffix(" .").unwrap_or(words).trim_matches(is_beside);
    // The words of a Markdown link.
    let inner = words.strip_prefix('[').and_then(|words| words.strip_suffix(']'));
    let words = inner.filter(|inner| !inner.contains(['[', ']'])).unwrap_or(words).trim_matches(is_beside);
    words.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// A number of minutes without its unit, as the first column of a table has it.
fn number(cell: &str) -> Option<f64> {
    let is_number = !cell.is_empty() && cell.chars().all(|c| c.is_ascii_digit() || c == '.');
    cell.parse().ok().filter(|number: &f64| is_number && number.is_finite() && *number < 1000.0)
}

/// A heading without the minutes that stand in brackets in it: "Phugoid (3 min)".
fn without_minutes(cell: &str) -> (String, Option<f64>) {
    let found = cell.match_indices('(').find_map(|(open, _)| {
        let close = open + cell[open..].find(')')?;
        let minutes = minutes(cell[open + 1..close].trim())?;
        Some((format!("{} {}", &cell[..open], &cell[close + 1..]), minutes))
    });
    match found {
        Some((rest, minutes)) => (tidy(&rest), Some(minutes)),
        None => (cell.to_owned(), None),
    }
}
