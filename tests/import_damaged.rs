//! Files of other programs as mails, spreadsheets and printers leave them: read as they were meant, or refused where they stand.

#[expect(dead_code, reason = "each test needs some of it")]
mod import_files;

use std::collections::BTreeMap;

use eigenwing::content::import::review::Review;
use eigenwing::content::import::{FileBytes, review};
use eigenwing::flight::aircraft::plane::Plane::{Lateral, Longitudinal};
use import_files::model;

fn text(name: &str) -> String {
    String::from_utf8(import_files::bytes(name)).expect("a text")
}

/// What is typed beside each file.
const AIRFRAME: [&str; 6] = ["mass=1247", "Ix=1420", "Iy=4067", "Iz=4786", "Ixz=0", "speed=53.64"];

const FILES: [(&str, &[&str]); 6] = [
    ("navion.st", &["length_unit=ft", "all=suggested"]),
    ("navion.sys", &[]),
    ("navion-xflr5.txt", &[]),
    ("navion-flow5.txt", &[]),
    ("navion.stab", &["case=3", "units=ft-slug-s", "ConGrp_1=elevator", "all=suggested"]),
    ("navion-datcom.out", &["case=2", "all=suggested"]),
];

fn read(name: &str, text: &str, fills: &[&str]) -> Result<Review, String> {
    let has_coefficients = fills.contains(&"all=suggested");
    let all = fills.iter().chain(AIRFRAME.iter().filter(|_| has_coefficients));
    let split = |fill: &&str| {
        let (key, value) = fill.split_once('=').expect("key=value");
        (key.to_owned(), value.to_owned())
    };
    let fills: BTreeMap<String, String> = all.map(split).collect();
    review(&[FileBytes { name, bytes: text.as_bytes() }], &fills).map_err(|error| error.to_string())
}

fn same(name: &str, fills: &[&str], damaged: &str, how: &str) {
    let [expected, found] = [&text(name), damaged].map(|text| {
        let review = read(name, text, fills).unwrap_or_else(|error| panic!("{name}, {how}: {error}"));
        [Longitudinal, Lateral].map(|plane| model(&review, plane))
    });
    assert_eq!(found, expected, "{name}, {how}");
}

#[test]
fn ends_of_lines_blanks_margins_and_signs_make_no_difference() {
    for (name, fills) in FILES {
        let text = text(name);
        let no_empty: String = text.split_inclusive('\n').filter(|line| !line.trim().is_empty()).collect();
        let margin: String = text
            .split_inclusive('\n')
            .map(|line| if line == "\n" { line.to_owned() } else { format!("   {line}") })
            .collect();
        for (how, damaged) in [
            ("CRLF", text.replace('\n', "\r\n")),
            ("without empty lines", no_empty),
            ("with a margin", margin),
            ("with blanks that don't break", text.replace(' ', "\u{a0}")),
            ("with the minus of a page", text.replace(" -", " −")),
        ] {
            same(name, fills, &damaged, how);
        }
    }
}

#[test]
fn decimal_commas_are_read_as_points_and_it_is_told() {
    for (name, fills) in FILES {
        let letters: Vec<char> = text(name).chars().collect();
        let digit = |k: Option<usize>| k.and_then(|k| letters.get(k)).is_some_and(char::is_ascii_digit);
        let commas: String = (0..letters.len())
            .map(|k| {
                if letters[k] == '.' && digit(k.checked_sub(1)) && digit(Some(k + 1)) {
                    ','
                } else {
                    letters[k]
                }
            })
            .collect();
        assert_ne!(commas, text(name));
        same(name, fills, &commas, "with commas");
        let review = read(name, &commas, fills).expect("it is read");
        assert!(
            review.remarks.contains(&"The commas in its numbers were read as points.".to_owned()),
            "{name}"
        );
    }
}

#[test]
fn a_number_that_is_none_is_told_with_its_line() {
    let st = text("navion.st");
    let wide = st.replace("CLq =   0.000000", "CLq = **********").replace("Cmq =-9.960000", "Cmq =      NaN");
    let line = |part: &str| wide.lines().position(|line| line.contains(part)).expect("it is there") + 1;
    let review = read("navion.st", &wide, &["length_unit=ft"]).expect("it is read");
    let told: Vec<&str> = review
        .doubts
        .iter()
        .filter(|doubt| doubt.key == "unreadable")
        .map(|doubt| doubt.sentence.as_str())
        .collect();
    let expected = [
        format!("CLq on line {} is “**********”, which is no number.", line("CLq =")),
        format!("Cmq on line {} is “NaN”, which is no number.", line("Cmq =")),
    ];
    assert_eq!(told, expected);
    assert!(review.fields.iter().any(|field| field.key == "Cm_q" && field.value.is_none()));
}

#[test]
fn a_log_that_is_cut_off_or_holds_no_numbers_says_where() {
    let log = text("navion-flow5.txt");
    let error = |text: &str| read("log.txt", text, &[]).expect_err("it is damaged");
    let row = "           -0.369401             -2.0227             53.6448                   0";
    assert!(log.contains(row));
    let line = log.lines().position(|line| line == row).expect("it is there") + 1;
    assert_eq!(
        error(&log.replace(
            row,
            "           -0.369401                 nan             53.6448                   0"
        )),
        format!(
            "log.txt, line {line}: expected four rows of numbers, found “-0.369401                 nan             53.6448                   0”"
        )
    );
    let control = log.find("          -0.221857").expect("it is there");
    assert!(
        error(&log[..control]).ends_with("expected a control matrix of four rows, found 2"),
        "{}",
        error(&log[..control])
    );
    let xflr5 = text("navion-xflr5.txt");
    let end = xflr5.find("      Zde=").expect("it is there");
    assert!(
        error(&xflr5[..end])
            .ends_with("expected six derivatives by a control, Xde to Nde, found 2; is the log cut off?"),
        "{}",
        error(&xflr5[..end])
    );
}

#[test]
fn a_table_that_is_cut_off_is_told_and_left_out() {
    let stab = text("navion.stab");
    let third = stab.rfind("\nCoef ").expect("three tables");
    let review = read("a.stab", &stab[..third], &[]).expect("it is read");
    let line = stab[..stab.rfind("Sref_").expect("a head")].lines().count() + 1;
    let told =
        format!("The table that begins on line {line} has no C_L by α, and is left out: is it cut off?");
    assert!(review.remarks.contains(&told), "{told} {:#?}", review.remarks);
    let case = review.fields.iter().find(|field| field.key == "case").expect("it is asked for");
    assert_eq!(case.choices.len(), 2);
    let json = text("navion-linearisation.json");
    let error = read("a.json", &json[..json.len() / 2], &[]).expect_err("it is cut");
    assert!(error.ends_with("the file is cut off: it ends in the middle of a linearisation"), "{error}");
}

/// Numbers that have left the columns of their names are another column's.
#[test]
fn a_table_of_datcom_whose_columns_have_moved_is_refused() {
    let text = text("navion-datcom.out");
    let row = text.lines().find(|line| line.trim_start().starts_with("0.0 ")).expect("a row");
    let together = row.split_whitespace().collect::<Vec<_>>().join(" ");
    let moved = text.replace(row, &format!("    {together}"));
    let error = read("a.out", &moved, &["case=2"]).expect_err("the columns have moved");
    assert!(error.contains("is not below the name of a column"), "{error}");
}
