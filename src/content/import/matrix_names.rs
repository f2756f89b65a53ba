//! Which matrix of a file is A and which B, where they have other names: `F` and `G`, or `A_lon` and `A_lat` of the two planes.

use super::naming;
use super::sheet::Sheet;
use crate::content::matrix::draft::{At, Draft, Entry, Problem, Rows};

/// A matrix by the name that it has.
type Named = (String, At<Rows>);

/// A plane of motion: its matrix A, what its states look like, and its B.
struct OnePlane<'d> {
    square: &'d Named,
    states: Option<String>,
    inputs: Option<&'d Named>,
}

/// A and B where the file calls them something else: the only square matrix, and the only other one with as many rows; or the two planes
/// of an aircraft, each with its B.
pub(super) fn find(sheet: &mut Sheet, draft: &mut Draft) -> Result<(), Problem> {
    let strangers = std::mem::take(&mut draft.strangers);
    if draft.has("A") {
        return Ok(());
    }
    let changed = std::mem::take(&mut draft.changed);
    let as_given = |(name, rows): &Named| match changed.iter().find(|(other, _)| other == name) {
        Some((_, problem)) => Err(problem.clone()),
        None => Ok(At { line: rows.line, value: rows.value.clone() }),
    };
    let is_square =
        |rows: &[At<Vec<f64>>]| rows.len() >= 3 && rows.iter().all(|row| row.value.len() == rows.len());
    let mut squares: Vec<&Named> = strangers.iter().filter(|(_, rows)| is_square(&rows.value)).collect();
    // C, Q and the like may be square, too.
    if squares.len() > 1 && squares.iter().any(|(name, _)| name.starts_with(['A', 'a'])) {
        squares.retain(|(name, _)| name.starts_with(['A', 'a']));
    }
    let inputs_of = |n: usize, (name, _): &Named| {
        let named: String =
            [if name.starts_with('a') { 'b' } else { 'B' }].into_iter().chain(name.chars().skip(1)).collect();
        let fits = |rows: &Rows| {
            let columns = rows.first().map_or(0, |row| row.value.len());
            rows.len() == n && (1..n).contains(&columns) && rows.iter().all(|row| row.value.len() == columns)
        };
        let mut others = strangers.iter().filter(|(_, rows)| fits(&rows.value));
        let by_name = others.clone().find(|(other, _)| name.starts_with(['A', 'a']) && *other == named);
        by_name.or_else(|| others.next().filter(|_| squares.len() == 1 && others.next().is_none()))
    };
    match squares.as_slice() {
        [only] => {
            let At { line, value } = as_given(only)?;
            let n = value.len();
            draft.set("A", line, Entry::Rows(value))?;
            sheet.remark(format!("{} is read as A: it is the only square matrix that can be it.", only.0));
            if let (false, Some(found)) = (draft.has("B"), inputs_of(n, only)) {
                let At { line, value } = as_given(found)?;
                draft.set("B", line, Entry::Rows(value))?;
                sheet.remark(format!("{} is read as B: it has as many rows.", found.0));
            }
            Ok(())
        }
        [first, second] if !draft.has("B") => {
            let planes = [*first, *second].map(|square| {
                let rows: Vec<Vec<f64>> = square.1.value.iter().map(|row| row.value.clone()).collect();
                let states = naming::guess(&rows).filter(|_| rows.len() == 4);
                OnePlane { square, states, inputs: inputs_of(4, square) }
            });
            let are_both = |one: usize, other: usize| {
                let begins = |k: usize, is: bool| {
                    planes[k].states.as_ref().is_some_and(|names| names.starts_with("u ") == is)
                };
                begins(one, true) && begins(other, false)
            };
            if !(are_both(0, 1) || are_both(1, 0)) {
                return Err(several(&squares));
            }
            for used in planes.iter().flat_map(|plane| [Some(plane.square), plane.inputs]).flatten() {
                as_given(used)?;
            }
            both_planes(sheet, draft, &planes)
        }
        [] => Ok(()),
        _ => Err(several(&squares)),
    }
}

/// The sentence about matrices of which one could be A.
fn several(squares: &[&Named]) -> Problem {
    let names: Vec<&str> = squares.iter().map(|(name, _)| name.as_str()).collect();
    let line = squares.first().map_or(1, |(_, rows)| rows.line);
    (line, format!("{} could each be A; give the one that is meant the name A", names.join(" and ")))
}

/// A of both planes, which nothing couples: one matrix with the two on its diagonal, and B likewise.
fn both_planes(sheet: &mut Sheet, draft: &mut Draft, planes: &[OnePlane<'_>; 2]) -> Result<(), Problem> {
    let line = planes[0].square.1.line;
    let (mut a, mut b): (Rows, Rows) = (Vec::new(), Vec::new());
    let (mut states, mut inputs) = (Vec::new(), Vec::new());
    let columns: Vec<usize> =
        planes.iter().map(|plane| plane.inputs.map_or(0, |(_, rows)| rows.value[0].value.len())).collect();
    for (k, plane) in planes.iter().enumerate() {
        let (name, rows) = plane.square;
        states.extend(plane.states.iter().flat_map(|names| names.split(' ')).map(str::to_owned));
        let is_longitudinal = states[4 * k] == "u";
        let usual = if is_longitudinal { ["elevator", "throttle"] } else { ["aileron", "rudder"] };
        let Some(usual) = usual.get(..columns[k]) else {
            let problem = format!("B: expected at most two columns beside {name}, found {}", columns[k]);
            return Err((line, problem));
        };
        inputs.extend(usual.iter().map(|&name| name.to_owned()));
        let spread = |row: &[f64], before: usize, all: usize| {
            let mut spread = vec![0.0; all];
            spread[before..before + row.len()].copy_from_slice(row);
            spread
        };
        for i in 0..4 {
            let row = &rows.value[i];
            a.push(At { line: row.line, value: spread(&row.value, 4 * k, 8) });
            let of_inputs = plane.inputs.map_or(&[][..], |(_, rows)| &rows.value[i].value);
            let before = if k == 0 { 0 } else { columns[0] };
            b.push(At { line: row.line, value: spread(of_inputs, before, columns.iter().sum()) });
        }
    }
    let [first, second] = planes.each_ref().map(|plane| plane.square.0.as_str());
    sheet.remark(format!(
        "{first} and {second} are read as the two planes of one aircraft, with the states {} and the inputs {}: that is what their rows look \
         like, and the usual order.",
        states.join(", "),
        if inputs.is_empty() { "none".to_owned() } else { inputs.join(", ") }
    ));
    draft.set("A", line, Entry::Rows(a))?;
    if !inputs.is_empty() {
        draft.set("B", line, Entry::Rows(b))?;
        if !draft.has("inputs") {
            draft.set("inputs", line, Entry::Names(inputs))?;
        }
    }
    if draft.has("states") { Ok(()) } else { draft.set("states", line, Entry::Names(states)) }
}
