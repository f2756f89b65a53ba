//! The review of a file for people: what was read as what, what is missing, what looks wrong.

use eigenwing::content::import::review::{Field, Review};
use eigenwing::number::{eigenvalue, trimmed};
use nalgebra::Complex;

use crate::tables::{heading, table};

/// Digits of a number that was read.
const DIGITS: usize = 6;

pub fn review(review: &Review) -> String {
    let mut said = format!("{}: {}\n{}\n", review.file, review.format_name, review.title);
    if !review.read.is_empty() {
        let rows = review.read.iter().map(|read| {
            let line = if read.line > 0 { read.line.to_string() } else { String::new() };
            let value = read.value.map_or_else(String::new, |value| trimmed(value, DIGITS));
            vec![line, read.text.clone(), read.key.clone(), heading(&read.meaning, read.unit), value]
        });
        said.push_str("\nRead\n");
        said.push_str(&table(4, &["line", "in the file", "key", "meaning", "value"], rows));
    }
    for plane in &review.eigenvalues {
        let upper = plane.values.iter().filter(|[_, im]| *im >= 0.0);
        let told: Vec<String> = upper.map(|&[re, im]| eigenvalue(Complex::new(re, im))).collect();
        said.push_str(&format!("\nEigenvalues, {}: {}\n", plane.plane, told.join(", ")));
    }
    let fields = |title: &str, wanted: fn(&Field) -> bool| {
        let fields: Vec<&Field> = review.fields.iter().filter(|field| wanted(field)).collect();
        if fields.is_empty() {
            return String::new();
        }
        format!(
            "\n{title}\n{}",
            table(4, &["key", "meaning", "values", "suggested"], fields.into_iter().map(row))
        )
    };
    said.push_str(&fields("Missing: give each as --fill key=value", |field| {
        field.required && field.value.is_none()
    }));
    said.push_str(&fields("Chosen", |field| field.value.is_some()));
    for (title, sentences) in [
        ("Remarks", review.remarks.clone()),
        ("Looks wrong", review.doubts.iter().map(eigenwing::content::import::review::Doubt::told).collect()),
    ] {
        if !sentences.is_empty() {
            said.push_str(&format!("\n{title}\n"));
            sentences.iter().for_each(|sentence| said.push_str(&format!(" · {sentence}\n")));
        }
    }
    said.push_str(if review.aircraft.is_some() {
        "\nReady: every command takes this file.\n"
    } else {
        "\nNot ready.\n"
    });
    said
}

fn row(field: &Field) -> Vec<String> {
    let values = match (&field.value, field.low, field.high) {
        (Some(value), ..) => value.clone(),
        (None, Some(low), Some(high)) => format!("{} to {}", trimmed(low, 4), trimmed(high, 4)),
        _ if field.choices.len() > 6 => {
            let ends = [field.choices.first(), field.choices.last()].map(|choice| {
                choice.map_or_else(String::new, |choice| format!("{} ({})", choice.key, choice.words))
            });
            ends.join(" to ")
        }
        _ => {
            let told = field.choices.iter().map(|choice| format!("{} ({})", choice.key, choice.words));
            told.collect::<Vec<_>>().join(", ")
        }
    };
    let suggested =
        field.suggested.as_ref().filter(|_| field.value.is_none()).map_or_else(String::new, |value| {
            let short = value.parse().map_or_else(|_| value.clone(), |x: f64| trimmed(x, DIGITS));
            format!("{short}: {}", field.reason.as_deref().unwrap_or_default())
        });
    vec![field.key.clone(), heading(&field.meaning, field.unit), values, suggested]
}
