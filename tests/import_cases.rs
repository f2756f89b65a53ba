//! Several cases one after another in a file, and files that are cut off.

#[expect(dead_code, reason = "each test needs some of it")]
mod import_files;

use std::collections::BTreeMap;

use eigenwing::content::import::review::Review;
use eigenwing::content::import::{FileBytes, review};
use eigenwing::flight::aircraft::plane::Plane::{Lateral, Longitudinal};
use import_files::{model, open};

fn text(name: &str) -> String {
    String::from_utf8(import_files::bytes(name)).expect("a text")
}

fn read(name: &str, text: &str, fills: &[(&str, &str)]) -> Result<Review, String> {
    let fills: BTreeMap<String, String> =
        fills.iter().map(|(key, value)| ((*key).to_owned(), (*value).to_owned())).collect();
    review(&[FileBytes { name, bytes: text.as_bytes() }], &fills).map_err(|error| error.to_string())
}

fn opened(name: &str, text: &str, fills: &[(&str, &str)]) -> Review {
    read(name, text, fills).unwrap_or_else(|error| panic!("{error}"))
}

/// The words of the cases that are asked for; empty where nothing is.
fn cases(review: &Review) -> Vec<String> {
    let field = review.fields.iter().find(|field| field.key == "case");
    assert!(field.is_none_or(|field| field.required));
    field.map_or_else(Vec::new, |field| field.choices.iter().map(|choice| choice.words.clone()).collect())
}

#[test]
fn two_raw_logs_are_two_analyses_told_apart_by_line_and_eigenvalues() {
    let one = text("01-xflr5-raw-log.txt");
    let other = one.replace("-0.155991", "-0.355991").replace("-3.34412", "-5.5");
    let both = format!("{one}\n{other}");
    let waiting = opened("log.txt", &both, &[]);
    let words = cases(&waiting);
    assert_eq!(words.len(), 2);
    assert!(words[0].starts_with("line 2: eigenvalues −20.88 ± 10.57j, −0.07713"), "{words:?}");
    assert!(words[1].starts_with("line 15: eigenvalues −20.88 ± 10.57j, −0.1770"), "{words:?}");
    assert!(waiting.aircraft.is_none() && waiting.eigenvalues.is_empty());
    for (case, alone) in [("1", &one), ("2", &other)] {
        let chosen = opened("log.txt", &both, &[("case", case), ("speed", "8.6")]);
        let alone = opened("log.txt", alone, &[("speed", "8.6")]);
        for plane in [Longitudinal, Lateral] {
            assert_eq!(model(&chosen, plane), model(&alone, plane), "{case}");
        }
    }
    assert_eq!(cases(&opened("log.txt", &one, &[])), [""; 0], "one alone is no question");
}

/// Speed, mass and derivatives of one analysis are never those of another.
#[test]
fn two_whole_logs_are_told_apart_by_their_flight() {
    let one = text("navion-xflr5.txt");
    let other = one
        .replace("control position 0.00", "control position -2.00")
        .replace("VInf = 53.64480", "VInf = 60")
        .replace("Alpha=0.60000", "Alpha=0.25")
        .replace("Mw=      -666.8", "Mw=      -500.0")
        .replace("Mass=    1247.379018", "Mass=    1300.5");
    let both = opened("log.txt", &format!("{one}{other}"), &[]);
    assert_eq!(
        cases(&both),
        [
            "line 1: control position 0, V 53.64 m/s, α 0.6°".to_owned(),
            format!("line {}: control position −2, V 60 m/s, α 0.25°", one.lines().count() + 1)
        ]
    );
    let second = opened("log.txt", &format!("{one}{other}"), &[("case", "2")]);
    assert_eq!(model(&second, Longitudinal), model(&opened("log.txt", &other, &[]), Longitudinal));
    assert_eq!(second.read.iter().find(|read| read.key == "mass").and_then(|read| read.value), Some(1300.5));
    // Matrices alone, and a whole log behind them.
    let raw = text("01-xflr5-raw-log.txt");
    let mixed = opened("log.txt", &format!("{raw}\n{one}"), &[("case", "2")]);
    assert_eq!(model(&mixed, Longitudinal), model(&opened("log.txt", &one, &[]), Longitudinal));
}

#[test]
fn two_system_matrices_are_two_cases() {
    let one = text("navion.sys");
    let other = one.replace("-0.1297", "-0.2297");
    assert_ne!(one, other);
    let both = format!("{one}{other}");
    let waiting = opened("two.sys", &both, &[]);
    let words = cases(&waiting);
    assert_eq!(words.len(), 2);
    assert!(words[0].starts_with("line 2: eigenvalues −2.5"), "{words:?}");
    assert!(words[1].starts_with(&format!("line {}: eigenvalues ", one.lines().count() + 2)), "{words:?}");
    assert!(words[0][7..] != words[1][7..] && waiting.aircraft.is_none());
    for (case, alone) in [("1", &one), ("2", &other)] {
        let chosen = opened("two.sys", &both, &[("case", case)]);
        assert_eq!(model(&chosen, Longitudinal), model(&opened("one.sys", alone, &[]), Longitudinal));
    }
}

#[test]
fn a_system_matrix_that_is_cut_off_says_where_it_ends() {
    let whole = text("navion.sys");
    let lines: Vec<&str> = whole.lines().collect();
    let cut = |count: usize| lines[..count].join("\n");
    let error = |text: &str| read("cut.sys", text, &[]).expect_err("it is cut");
    assert_eq!(error(&cut(9)), "cut.sys, line 9: the matrix is cut off: 12 states, 7 rows");
    assert_eq!(error(&cut(2)), "cut.sys, line 2: the matrix is cut off: 12 states, 0 rows");
    // In the middle of a row.
    let half = format!("{}\n{}", cut(9), &lines[9][..60]);
    assert_eq!(
        error(&half),
        "cut.sys, line 10: the matrix is cut off: 12 states, 8 rows, the last of 6 numbers"
    );
    let last = &lines[13][..lines[13].trim_end().len() - 10];
    let end = format!("{}\n{last}", cut(13));
    assert_eq!(error(&end), "cut.sys, line 14: the matrix is cut off: its last row has 14 numbers, not 15");
    // The cut one of two is no reason to refuse the other.
    let both = format!("{}\n{whole}", cut(9));
    assert_eq!(cases(&opened("two.sys", &both, &[]))[0], "line 2: not whole");
    assert_eq!(
        read("two.sys", &both, &[("case", "1")]).expect_err("it is cut"),
        "two.sys, line 9: the matrix is cut off: 12 states, 7 rows"
    );
    let second = opened("two.sys", &both, &[("case", "2")]);
    assert_eq!(model(&second, Lateral), model(&opened("one.sys", &whole, &[]), Lateral));
}

/// Fields of AVL are ten wide: a number of nine places and a sign touches the one before.
#[test]
fn numbers_of_a_system_matrix_that_touch_are_parted() {
    let whole = text("navion.sys");
    let touching = whole.replace("-2.0227    53.6448", "-2.0227-1053.6448");
    let parted = whole.replace("-2.0227    53.6448", "-2.0227 -1053.6448");
    assert_ne!(touching, whole);
    let of = |text: &str| opened("one.sys", text, &[]).eigenvalues;
    assert_eq!(of(&touching), of(&parted));
}

#[test]
fn a_second_run_case_without_its_head_is_still_another_case() {
    let whole = text("navion-two-cases.st");
    let bare: String =
        whole.split_inclusive('\n').filter(|line| !line.contains("Vortex Lattice Output")).collect();
    let review = opened("two.st", &bare, &[]);
    assert_eq!(cases(&review), ["slow, α 5.5°", "cruise, α 0.6°"]);
}

#[test]
fn linearisations_one_after_another_are_cases() {
    let json = text("navion-linearisation.json");
    let other = json.replace("176.0", "186.0");
    assert_ne!(json, other);
    for both in [format!("{json}{other}"), format!("[{json},{other}]")] {
        let words = cases(&opened("two.json", &both, &[]));
        assert_eq!(words, ["Vt 176 ft/s, Alpha 0 rad, Alt 5000 ft", "Vt 186 ft/s, Alpha 0 rad, Alt 5000 ft"]);
        let second = opened("two.json", &both, &[("case", "2")]);
        assert_eq!(model(&second, Longitudinal), model(&opened("one.json", &other, &[]), Longitudinal));
    }
    let scicos = text("navion.sce");
    let other = scicos.replace("navion.", "slower.").replace("1.7600000000e+02", "1.6600000000e+02");
    let both = format!("{scicos}{other}");
    let words = cases(&opened("two.sce", &both, &[]));
    assert_eq!(words, ["navion, line 1".to_owned(), format!("slower, line {}", scicos.lines().count() + 1)]);
    let second = opened("two.sce", &both, &[("case", "2")]);
    assert_eq!(model(&second, Longitudinal), model(&opened("one.sce", &other, &[]), Longitudinal));
}

#[test]
fn tables_of_vspaero_without_stars_between_them_are_cases() {
    let stab = text("navion.stab");
    let bare: String = stab.split_inclusive('\n').filter(|line| !line.starts_with("****")).collect();
    assert_eq!(cases(&opened("a.stab", &bare, &[])), cases(&open(&["navion.stab"], &[])));
    // A row that is cut short is no row of zeros.
    let line = stab.lines().position(|line| line.starts_with("CMm ")).expect("it is there");
    let cut: String = stab.lines().take(line).map(|line| format!("{line}\n")).collect::<String>()
        + "CMm     0.0000000   -0.6830000";
    assert_eq!(
        read("a.stab", &cut, &[]).expect_err("it is cut"),
        format!("a.stab, line {}: CMm: expected 11 numbers, one a column, found 2", line + 1)
    );
}
