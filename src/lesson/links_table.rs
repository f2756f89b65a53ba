//! The table of a form in which links were handed in: CSV with commas, semicolons or tabs, as Google, Microsoft and others write it.
//!
//! A column with links is found by its links, the name by the head of its column, or else as whatever else stands in the row. Rows of
//! one name belong together.

use super::links_line::links_in;
use super::submission::{Submission, Work};
use super::vary::normalised;
use crate::content::import::decode;

/// Words of a head over names, the best first.
const NAMES: [&str; 7] = ["name", "nom", "nombre", "student", "number", "matrikel", "mail"];

/// Reads a table; one without a single link gives one submission that says so.
pub fn links_table(source: &str, bytes: &[u8]) -> Vec<Submission> {
    let none = |reason: &str| {
        vec![Submission { source: source.to_owned(), name: None, work: Err(reason.to_owned()) }]
    };
    let Some((text, _)) = decode(bytes) else { return none("this is no table") };
    if text.trim().is_empty() {
        return none("the file is empty");
    }
    // Excel names the delimiter in a line of its own.
    let text = match text.split_once('\n') {
        Some((first, rest)) if first.to_ascii_lowercase().starts_with("sep=") => rest,
        _ => &text,
    };
    let mut reader = csv::ReaderBuilder::new();
    let reader = reader.delimiter(delimiter(text)).has_headers(false).flexible(true);
    let rows = reader.from_reader(text.as_bytes()).into_records().filter_map(Result::ok);
    let rows: Vec<(u64, Vec<String>)> = rows
        .map(|row| {
            let line = row.position().map_or(0, csv::Position::line);
            (line, row.iter().map(|cell| cell.trim().to_owned()).collect())
        })
        .collect();
    let head = rows.first().filter(|(_, row)| !row.iter().any(|cell| is_link(cell)));
    let name_at = head.and_then(|(_, head)| {
        let heads: Vec<String> = head.iter().map(|cell| cell.to_lowercase()).collect();
        NAMES.iter().find_map(|name| heads.iter().position(|cell| cell.contains(name)))
    });
    let mut found: Vec<Submission> = Vec::new();
    for (line, row) in rows.iter().skip(usize::from(head.is_some())) {
        let links: Vec<String> = row.iter().flat_map(|cell| links_in(cell)).map(str::to_owned).collect();
        let name = match name_at.and_then(|at| row.get(at)).filter(|cell| !is_link(cell)) {
            Some(name) => name.clone(),
            None => {
                let others = row.iter().filter(|cell| !cell.is_empty() && !is_link(cell) && !is_time(cell));
                others.cloned().collect::<Vec<_>>().join(" ")
            }
        };
        if links.is_empty() && name.is_empty() {
            continue;
        }
        let name = Some(name).filter(|name| !name.is_empty());
        let key = name.as_deref().map(normalised).filter(|key| !key.is_empty());
        let same = key.and_then(|key| {
            found.iter_mut().find(|other| other.name.as_deref().is_some_and(|name| normalised(name) == key))
        });
        match same {
            Some(Submission { work: Ok(Work::Links(before)), .. }) => before.extend(links),
            Some(other) if !links.is_empty() => other.work = Ok(Work::Links(links)),
            Some(_) => {}
            None => found.push(Submission {
                source: format!("{source}, line {line}"),
                name,
                work: if links.is_empty() {
                    Err("there is no link in this line".to_owned())
                } else {
                    Ok(Work::Links(links))
                },
            }),
        }
    }
    if found.iter().all(|one| one.work.is_err()) { none("there is no link in this table") } else { found }
}

/// The sign between the cells, by the first line: of a comma, a semicolon and a tab the one that stands there most often.
fn delimiter(text: &str) -> u8 {
    let first = text.lines().next().unwrap_or_default();
    let mut inside = false;
    let mut counts = [(b',', 0_usize), (b';', 0), (b'\t', 0)];
    for byte in first.bytes() {
        inside ^= byte == b'"';
        if let Some((_, count)) = counts.iter_mut().find(|(sign, _)| *sign == byte && !inside) {
            *count += 1;
        }
    }
    // Of equals the last is taken, so the comma stands last.
    counts.reverse();
    counts.into_iter().max_by_key(|(_, count)| *count).map_or(b',', |(sign, _)| sign)
}

fn is_link(cell: &str) -> bool {
    links_in(cell).next().is_some()
}

/// Whether a cell is a time or a number rather than a name: it has more digits than letters.
fn is_time(cell: &str) -> bool {
    let digits = cell.chars().filter(char::is_ascii_digit).count();
    let letters = cell.chars().filter(|c| c.is_alphabetic()).count();
    cell.contains([':', '/']) && digits > letters
}
