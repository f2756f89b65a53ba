//! Grades as a table for people and as CSV.

use eigenwing::lesson::{Grade, Grades, Mark, Outcome};
use eigenwing::number::trimmed;

use crate::csv_output::records;
use crate::tables::table as table_of;

/// A row for each person, a column for each step.
pub fn table(grades: &Grades) -> String {
    let mut steps: Vec<usize> = grades.parts.iter().map(|part| part.place.step).collect();
    steps.dedup();
    let points = format!("of {}", trimmed(grades.points, 4));
    let numbers: Vec<String> = steps.iter().map(|step| (step + 1).to_string()).collect();
    let mut head = vec!["name", points.as_str()];
    head.extend(numbers.iter().map(String::as_str));
    head.extend(["tries", "hints", "remarks"]);
    let row = |grade: &Grade| {
        let marks = |step: &usize| {
            let of_step = grades.parts.iter().zip(&grade.marks).filter(|(part, _)| part.place.step == *step);
            of_step.map(|(_, mark)| sign(mark)).collect::<String>()
        };
        let mut row = vec![name(grade).to_owned(), trimmed(grade.points, 4)];
        row.extend(steps.iter().map(marks));
        row.extend([tries(grade).to_string(), hints(grade).to_string(), remarks(grade)]);
        row
    };
    // All are words, so that signs stand below their step.
    let text = table_of(head.len(), &head, grades.grades.iter().map(row));
    format!(
        "{}: {} handed in\n{text}\n✓ right  ○ reached with help that cost its points  ✗ not right  – not done; a sign for each question and task of a step\n",
        grades.lesson,
        grades.grades.len()
    )
}

/// A row for each person, a column for each question and task.
pub fn csv(grades: &Grades) -> String {
    let mut head: Vec<String> = ["name", "source", "points", "of"].map(str::to_owned).to_vec();
    head.extend(grades.parts.iter().map(|part| format!("{} {}", part.place, plain(&part.step))));
    head.extend(["tries", "hints", "remarks"].map(str::to_owned));
    let row = |grade: &Grade| {
        let [points, of] = [grade.points, grades.points].map(|points| points.to_string());
        let mut row = vec![plain(name(grade)), plain(&grade.source), points, of];
        let points = |mark: &Mark| match mark.outcome {
            Outcome::Open => String::new(),
            Outcome::Right | Outcome::Wrong => mark.points.to_string(),
        };
        row.extend(grade.marks.iter().map(points));
        row.extend([tries(grade).to_string(), hints(grade).to_string(), plain(&remarks(grade))]);
        row
    };
    records(head, grades.grades.iter().map(row))
}

fn name(grade: &Grade) -> &str {
    if grade.name.trim().is_empty() { &grade.source } else { &grade.name }
}

const fn sign(mark: &Mark) -> char {
    match mark.outcome {
        Outcome::Right if mark.points == 0.0 && (mark.hints > 0 || mark.solution_shown) => '○',
        Outcome::Right => '✓',
        Outcome::Wrong => '✗',
        Outcome::Open => '–',
    }
}

fn tries(grade: &Grade) -> u32 {
    grade.marks.iter().map(|mark| mark.tries).fold(0, u32::saturating_add)
}

fn hints(grade: &Grade) -> usize {
    grade.marks.iter().map(|mark| mark.hints).sum()
}

fn remarks(grade: &Grade) -> String {
    grade.remarks.iter().map(ToString::to_string).collect::<Vec<_>>().join(" ")
}

/// Text of others that no program for tables takes for a formula.
fn plain(text: &str) -> String {
    if text.starts_with(['=', '+', '-', '@', '\t', '\r']) { format!("'{text}") } else { text.to_owned() }
}
