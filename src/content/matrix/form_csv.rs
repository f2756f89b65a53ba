//! Matrices as CSV: settings, a row of names, a row of numbers for each state. Cells are parted by commas, semicolons, tabs or upright
//! strokes; where it isn't by commas, a comma is a decimal comma.

use super::draft::{At, Draft, Entry, Problem, number, setting, setting_in_comment};
use super::state_names;

/// What stands between cells.
#[derive(Clone, Copy, PartialEq)]
pub(in crate::content) struct Separator(u8);

impl Separator {
    /// The one that parts most lines.
    fn of(text: &str) -> Self {
        let lines = |separator: char| text.lines().filter(|line| line.contains(separator)).count();
        Self(if lines(';') > lines(',') / 2 && lines(';') >= lines('\t') && lines(';') > 0 {
            b';'
        } else if lines('\t') > lines(',') / 2 {
            b'\t'
        } else if lines('|') > lines(',') / 2 {
            b'|'
        } else {
            b','
        })
    }

    /// The number in a cell.
    fn number(self, cell: &str) -> Option<f64> {
        let plain = |cell: &str| cell.parse().ok().or_else(|| number(cell));
        plain(cell).or_else(|| (self.0 != b',').then(|| plain(&cell.replace(',', ".")))?)
    }
}

/// The names in the head of the table.
struct Head {
    /// Whether the rows begin with the name of their state.
    is_labelled: bool,
    states: Vec<String>,
    inputs: Vec<String>,
}

pub(in crate::content) fn read(text: &str) -> Result<Draft, Problem> {
    let separator = Separator::of(text);
    let mut draft = Draft::default();
    let text_below = |line: usize| text.lines().skip(line);
    let mut head: Option<Head> = None;
    let (mut a, mut b) = (Vec::new(), Vec::new());
    // Line by line, so that every complaint has its line.
    for (line, text) in (1..).zip(text.lines()) {
        let cells = cells(separator, line, text)?;
        if cells.iter().all(String::is_empty) {
            continue;
        }
        let Some(head) = &head else {
            match read_setting(separator, &cells, text) {
                Some((key, entry)) => draft.set(key, line, entry)?,
                None if text.trim_start().starts_with('#') => {}
                None if cells.iter().filter(|cell| !cell.is_empty()).count() < 3 => {
                    let found = cells.iter().find(|cell| !cell.is_empty()).map_or("", String::as_str);
                    return Err((
                        line,
                        format!(
                            "expected a setting such as units or speed, or the names of the states, found \"{found}\""
                        ),
                    ));
                }
                None => {
                    let is_row = |line: &&str| !line.trim().is_empty() && !line.trim_start().starts_with('#');
                    let rows = text_below(line).filter(is_row).count();
                    head = Some(read_head(&mut draft, line, cells, rows)?);
                }
            }
            continue;
        };
        if text.trim_start().starts_with('#') {
            continue;
        }
        let numbers = row(separator, head, a.len(), line, &cells)?;
        let (of_a, of_b) = numbers.split_at(head.states.len().min(numbers.len()));
        a.push(At { line, value: of_a.to_vec() });
        b.push(At { line, value: of_b.to_vec() });
    }
    let Some(head) = head else {
        return Err((1, "expected a row with the names of the states and inputs, found none".to_owned()));
    };
    let line = a.first().map_or(1, |row| row.line);
    draft.set("A", line, Entry::Rows(a))?;
    if !head.inputs.is_empty() {
        draft.set("B", line, Entry::Rows(b))?;
    }
    Ok(draft)
}

/// The cells of one line.
fn cells(separator: Separator, line: usize, text: &str) -> Result<Vec<String>, Problem> {
    let mut reader = csv::ReaderBuilder::new()
        .has_headers(false)
        .delimiter(separator.0)
        .trim(csv::Trim::All)
        .from_reader(text.as_bytes());
    match reader.records().next() {
        None => Ok(Vec::new()),
        Some(Ok(record)) => Ok(record.iter().map(str::to_owned).collect()),
        Some(Err(error)) => Err((line, error.to_string())),
    }
}

/// `units,SI`, or the same as a comment, `# units: SI`.
fn read_setting(separator: Separator, cells: &[String], text: &str) -> Option<(&'static str, Entry)> {
    if let Some(comment) = text.trim_start().strip_prefix('#') {
        return setting_in_comment(comment.trim_end_matches([',', ';', '\t', ' ']))
            .filter(|(key, _)| !is_of_table(key));
    }
    // More cells are the head of the table, in which "V" would be the sideslip.
    if !cells.iter().skip(2).all(String::is_empty) {
        return None;
    }
    let (key, value) = (setting(cells.first()?)?, cells.get(1)?);
    let entry = separator.number(value).map_or_else(|| Entry::Text(value.clone()), Entry::Number);
    (!is_of_table(key)).then_some((key, entry))
}

/// Whether the table says it, and nothing else does.
fn is_of_table(key: &str) -> bool {
    matches!(key, "A" | "B" | "states" | "inputs")
}

/// The first cell is the name of a state, or stands above the names of the rows and means nothing. There are as many rows below.
fn read_head(draft: &mut Draft, line: usize, cells: Vec<String>, rows: usize) -> Result<Head, Problem> {
    let is_labelled = !state_names::is_known(&cells[0]);
    let mut named: Vec<String> = cells.into_iter().skip(usize::from(is_labelled)).collect();
    // Spreadsheets leave empty cells at the end.
    while named.last().is_some_and(String::is_empty) {
        named.pop();
    }
    // Heights, headings and lags may stand behind the four: those that are no controls, and whatever has a row.
    let further = named.iter().skip(4).take_while(|name| state_names::is_further(name)).count();
    let inputs = named.split_off((4 + further).max(rows).min(named.len()));
    draft.set("states", line, Entry::Names(named.clone()))?;
    if !inputs.is_empty() {
        draft.set("inputs", line, Entry::Names(inputs.clone()))?;
    }
    Ok(Head { is_labelled, states: named, inputs })
}

/// The numbers of row k.
fn row(
    separator: Separator,
    head: &Head,
    k: usize,
    line: usize,
    cells: &[String],
) -> Result<Vec<f64>, Problem> {
    let mut cells = cells;
    if head.is_labelled {
        let label = cells.first().map_or("", String::as_str);
        let expected = head.states.get(k).map_or("", String::as_str);
        if label != expected {
            let problem = match expected {
                "" => format!("expected no row after that of the last state, found \"{label}\""),
                expected => format!("expected the row of {expected} here, found \"{label}\""),
            };
            return Err((line, problem));
        }
        cells = &cells[1..];
    }
    let wanted = head.states.len() + head.inputs.len();
    while cells.len() > wanted && cells.last().is_some_and(String::is_empty) {
        cells = &cells[..cells.len() - 1];
    }
    if cells.len() != wanted {
        let problem = format!("expected {wanted} numbers, one a state and input, found {}", cells.len());
        return Err((line, problem));
    }
    let number = |cell: &String| {
        separator.number(cell).ok_or_else(|| (line, format!("expected a number, found \"{cell}\"")))
    };
    cells.iter().map(number).collect()
}
