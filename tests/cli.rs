//! The command line as it is typed: its answers by snapshot, its complaints in one line each.
//!
//! Snapshots hold numbers to nine digits, on which platforms agree. `INSTA_UPDATE=always` writes them again.

use std::io::{BufRead as _, BufReader};
use std::path::PathBuf;
use std::process::{Command, Output, Stdio};

use eigenwing::content::FILES;

fn cli(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_eigenwing-cli"));
    command.current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data/matrices")).args(arguments);
    command
}

fn run(arguments: &[&str]) -> Output {
    cli(arguments).output().expect("the command line starts")
}

/// What an answer says, once it is one.
fn answer(arguments: &[&str]) -> String {
    let Output { status, stdout, stderr } = run(arguments);
    assert_eq!(String::from_utf8_lossy(&stderr), "", "{arguments:?}");
    assert!(status.success(), "{arguments:?}");
    String::from_utf8(stdout).expect("an answer is a text")
}

/// The text with every number to nine digits, and rounding of zero as zero.
fn rounded(text: &str) -> String {
    rounded_to(9, text)
}

fn rounded_to(digits: usize, text: &str) -> String {
    let mut out = String::new();
    let mut rest = text;
    while let Some(start) = rest.find(|c: char| c.is_ascii_digit()) {
        let mut before = ' ';
        let end = rest[start..].find(|c: char| {
            let part = c.is_ascii_digit() || c == '.' || c == 'e' || (c == '-' && before == 'e');
            before = c;
            !part
        });
        let end = end.map_or(rest.len(), |end| start + end);
        let token = &rest[start..end];
        out += &rest[..start];
        match token.parse::<f64>() {
            Ok(x) if token.contains('.') || token.contains('e') => {
                if x < 1e-12 {
                    out = out.strip_suffix('-').unwrap_or(&out).to_owned();
                    out += "0";
                } else {
                    let few = format!("{x:.*e}", digits - 1);
                    out += &few.parse::<f64>().expect("a number that was just written").to_string();
                }
            }
            _ => out += token,
        }
        rest = &rest[end..];
    }
    out + rest
}

#[test]
fn rounding_keeps_nine_digits_and_everything_else() {
    assert_eq!(rounded("x -1.23456789012e-3, 17; 3.14"), "x -0.00123456789, 17; 3.14");
    assert_eq!(rounded("[-1e-17, 0.30000000000000004]"), "[0, 0.3]");
}

#[test]
fn manual_and_completions_name_every_command() {
    let help = answer(&["--help"]);
    let lines = help.lines().skip_while(|line| *line != "Commands:").skip(1);
    let commands: Vec<&str> =
        lines.take_while(|line| !line.is_empty()).filter_map(|line| line.split_whitespace().next()).collect();
    assert!(commands.contains(&"analyse") && commands.contains(&"completions"), "{commands:?}");
    assert!(!commands.contains(&"manual"), "only packages ask for it");
    let folder = std::env::temp_dir().join(format!("eigenwing-manual-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder");
    assert_eq!(answer(&["manual", folder.to_str().expect("a path")]), "");
    let bash = answer(&["completions", "bash"]);
    for command in commands.into_iter().filter(|command| *command != "help") {
        let page = folder.join(format!("eigenwing-cli-{command}.1"));
        let page = std::fs::read_to_string(&page).unwrap_or_else(|error| panic!("{command}: {error}"));
        assert!(page.contains(".SH SYNOPSIS"), "{command}");
        assert!(bash.contains(&format!(" {command} ")) || bash.contains(&format!("{command})")), "{command}");
    }
    std::fs::remove_dir_all(&folder).expect("it is ours");
    for shell in ["zsh", "fish", "powershell"] {
        assert!(answer(&["completions", shell]).contains("analyse"), "{shell}");
    }
    let missing = run(&["manual", "/nowhere/at/all"]);
    assert_eq!(String::from_utf8_lossy(&missing.stderr).lines().count(), 1);
}

#[test]
fn every_aircraft_of_the_list_is_listed_and_can_be_analysed() {
    let list = answer(&["list"]);
    for (file, _) in FILES {
        let key = file.strip_suffix(".toml").expect("an aircraft file");
        assert!(list.contains(&format!("\n {key} ")), "{key}");
        answer(&["analyse", key]);
    }
}

#[test]
fn analyse_as_a_table() {
    insta::assert_snapshot!(answer(&["analyse", "navion", "--set", "cm_alpha=-0.5"]));
}

#[test]
fn why_says_what_moved_a_mode_and_gives_the_parts_by_key() {
    let said = answer(&["why", "navion", "--set", "cm_q=-19.92"]);
    assert!(said.contains("Moved: C_mq −9.96 → −19.9"), "{said}");
    assert!(said.contains("Phugoid: ωₙ −13 %, T 29.5 → 34.0 s, ζ 0.0801 → 0.101, by M_q."), "{said}");
    assert!(said.contains("A new elevator is a new trim"), "{said}");
    assert_eq!(said.matches("Moved").count(), 1, "nothing of the other plane has moved: {said}");
    let json = answer(&["why", "navion", "--set", "cm_q=-19.92", "--json"]);
    let report: serde_json::Value = serde_json::from_str(&json).expect("it is JSON");
    let phugoid = &report["planes"][0]["modes"][1];
    assert_eq!(phugoid["key"], "phugoid");
    let frequency = &phugoid["shifts"][0];
    assert_eq!(frequency["causes"][0]["key"], "m_q");
    assert_eq!(frequency["approximation"], "phugoid-residualised");
    let [part, from, to] = [&frequency["causes"][0]["part"], &frequency["from"], &frequency["to"]]
        .map(|x| x.as_f64().expect("a number"));
    assert!((part - (to - from)).abs() < 1e-9, "{part} of {from} to {to}");
    // Nothing is set: nothing has moved.
    assert!(!answer(&["why", "x15"]).contains("Moved"));
}

#[test]
fn analyse_as_json() {
    insta::assert_snapshot!(rounded(&answer(&["analyse", "b747-fc9", "--json"])));
}

#[test]
fn analyse_as_csv() {
    insta::assert_snapshot!(rounded(&answer(&["analyse", "c47", "--csv"])));
}

#[test]
fn analyse_matlab_text_in_feet() {
    insta::assert_snapshot!(rounded(&answer(&["analyse", "--matrix", "navion.m", "--csv"])));
}

#[test]
fn analyse_csv_with_the_sideslip_angle() {
    insta::assert_snapshot!(answer(&["analyse", "--matrix", "lateral.csv"]));
}

#[test]
fn analyse_matrices_from_json() {
    insta::assert_snapshot!(answer(&["analyse", "--matrix", "lesson.json"]));
}

#[test]
fn an_aircraft_file_from_disk_is_analysed_as_the_one_that_ships() {
    let from_disk = answer(&["analyse", "../../../assets/aircraft/navion.toml", "--json"]);
    assert_eq!(from_disk, answer(&["analyse", "navion", "--json"]));
}

#[test]
fn a_folder_that_was_handed_in_graded_as_a_table_and_as_csv() {
    for output in [None, Some("--csv")] {
        let handed_in = ["grade", "../homework/week-3.md", "../homework/handed-in"];
        let arguments: Vec<&str> = handed_in.into_iter().chain(output).collect();
        insta::assert_snapshot!(answer(&arguments));
    }
}

#[test]
fn respond_as_a_table() {
    insta::assert_snapshot!(answer(&["respond", "x15", "--set", "elevator=-0.02", "--set", "time=20"]));
}

#[test]
fn respond_as_json() {
    let arguments = ["respond", "navion", "--disturbance", "vertical-gust", "--steps", "6", "--json"];
    insta::assert_snapshot!(rounded(&answer(&arguments)));
}

#[test]
fn respond_as_csv() {
    let arguments = [
        "respond",
        "navion",
        "--disturbance",
        "rudder",
        "--shape",
        "doublet",
        "--set",
        "time=6",
        "--steps",
        "12",
        "--csv",
    ];
    insta::assert_snapshot!(rounded(&answer(&arguments)));
}

#[test]
fn respond_with_parts_and_nonlinear_flight_as_a_table() {
    let arguments = ["respond", "navion", "--split", "--nonlinear", "--set", "elevator=-0.25"];
    insta::assert_snapshot!(answer(&arguments));
}

#[test]
fn respond_with_the_parts_of_the_modes_as_csv() {
    let arguments = ["respond", "lesson", "--split", "--set", "time=6", "--steps", "6", "--csv"];
    insta::assert_snapshot!(rounded(&answer(&arguments)));
}

#[test]
fn a_nonlinear_flight_that_stops_leaves_cells_empty_and_says_why_beside_the_csv() {
    let arguments = ["respond", "navion", "--nonlinear", "--set", "elevator=-0.25", "--steps", "60", "--csv"];
    let Output { status, stdout, stderr } = run(&arguments);
    assert!(status.success());
    let said = String::from_utf8_lossy(&stderr);
    let notes: Vec<&str> = said.lines().collect();
    assert_eq!(notes.len(), 2, "{said}");
    assert!(notes[0].starts_with("note: After ") && notes[0].contains("no longer small"), "{said}");
    assert!(notes[1].starts_with("note: the nonlinear flight ends: at 1."), "{said}");
    let text = String::from_utf8(stdout).expect("an answer is a text");
    let rows: Vec<Vec<&str>> = text.lines().map(|line| line.split(',').collect()).collect();
    let flown = rows[0].iter().position(|head| *head == "q nonlinear [rad/s]").expect("a column");
    // Samples at 0 and 1 s, none at 2 s.
    let numbers = rows[1..4].iter().map(|row| row[flown].parse::<f64>().is_ok());
    assert_eq!(numbers.collect::<Vec<_>>(), [true, true, false]);
    assert!(rows.iter().all(|row| row.len() == rows[0].len()));
}

#[test]
fn matrices_that_cannot_be_flown_still_answer_and_say_so_beside_the_csv() {
    let arguments = ["respond", "--matrix", "lateral.csv", "--nonlinear", "--steps", "3"];
    let Output { status, stdout, stderr } = run(&[&arguments[..], &["--csv"]].concat());
    assert_eq!((status.success(), String::from_utf8_lossy(&stdout).lines().count()), (true, 5));
    let said = "no nonlinear flight: this aircraft is given by its matrices, which hold for small disturbances only: \
                flight far from the trim needs coefficients or derivatives";
    assert_eq!(String::from_utf8_lossy(&stderr), format!("note: {said}\n"));
    assert!(answer(&arguments).ends_with(&format!("\nN{}.\n", &said[1..])));
}

#[test]
fn frequency_as_a_table() {
    insta::assert_snapshot!(answer(&["frequency", "b747-fc9", "--output", "theta"]));
}

#[test]
fn frequency_as_json() {
    let arguments = ["frequency", "navion", "--disturbance", "aileron", "--points", "5", "--json"];
    // The place of a peak is known to seven digits or so: it is flat.
    insta::assert_snapshot!(rounded_to(6, &answer(&arguments)));
}

#[test]
fn frequency_as_csv() {
    let arguments = ["frequency", "navion", "--disturbance", "vertical-gust", "--output", "nz"];
    let range = ["--from", "0.5", "--to", "50", "--points", "9", "--csv"];
    insta::assert_snapshot!(rounded(&answer(&[&arguments[..], &range].concat())));
}

const SWEEP: [&str; 10] =
    ["sweep", "navion", "--parameter", "cm_alpha", "--from", "-0.7", "--to", "0.3", "--points", "6"];

#[test]
fn sweep_as_a_table() {
    insta::assert_snapshot!(answer(&SWEEP));
}

#[test]
fn sweep_as_json() {
    insta::assert_snapshot!(rounded(&answer(&[&SWEEP[..8], &["--points", "3", "--json"]].concat())));
}

#[test]
fn sweep_as_csv() {
    insta::assert_snapshot!(rounded(&answer(&[&SWEEP[..], &["--csv"]].concat())));
}

/// The static margin falls by as much as the centre of gravity goes back, and a period is empty where nothing oscillates.
#[test]
fn a_sweep_of_measures_has_a_column_for_each() {
    let asked = ["sweep", "navion", "--parameter", "cg", "--from", "0", "--to", "0.2", "--points", "5"];
    let measures = ["--measure", "static_margin", "--measure", "phugoid.period", "--measure", "level"];
    insta::assert_snapshot!(answer(&[&asked[..], &measures].concat()));
    insta::assert_snapshot!(rounded(&answer(&[&asked[..], &measures, &["--csv"]].concat())));
}

#[test]
fn measures_as_csv() {
    insta::assert_snapshot!(rounded(&answer(&["measures", "navion", "--csv"])));
}

#[test]
fn a_misspelt_measure_is_one_sentence() {
    let asked =
        ["sweep", "navion", "--parameter", "cg", "--from", "0", "--to", "0.1", "--measure", "phugoid.perid"];
    let run = run(&asked);
    assert_eq!(run.status.code(), Some(1));
    let said = String::from_utf8_lossy(&run.stderr);
    assert_eq!(said, "error: there is no measure \"phugoid.perid\"; did you mean \"phugoid.period\"?\n");
}

#[test]
fn a_long_sweep_draws_no_bar_where_there_is_no_terminal() {
    // `answer` sees to it that nothing else is printed.
    let text = answer(&[&SWEEP[..8], &["--points", "501", "--csv"]].concat());
    assert!(text.lines().count() > 1000);
}

#[test]
fn a_sweep_through_flights_that_are_none_says_so_at_each_point() {
    let arguments =
        ["sweep", "navion", "--parameter", "speed", "--from", "20", "--to", "50", "--points", "4"];
    insta::assert_snapshot!(answer(&arguments));
}

/// A file of a test's own; they run at the same time.
fn file(name: &str, content: &[u8]) -> String {
    let path = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    std::fs::write(&path, content).expect("a test may write in its folder");
    path.to_str().expect("the folder's name is a text").to_owned()
}

#[test]
fn bad_input_is_one_line_and_exit_code_1() {
    let matlab = include_str!("data/matrices/navion.m");
    let navion = FILES[0].1;
    let cases: [(&[&str], &str); 34] = [
        (&["analyse", "navoin"], "there is no aircraft \"navoin\" in the list; did you mean \"navion\"?"),
        (&["analyse", "zzz"], "there is no aircraft \"zzz\" in the list"),
        (
            &["analyse", "navion", "--set", "cm_alhpa=1"],
            "there is no parameter \"cm_alhpa\"; did you mean \"cm_alpha\"?",
        ),
        (
            &["analyse", "navion", "--set", "Cl_beta=-0.1"],
            "there is no parameter \"Cl_beta\"; did you mean \"croll_beta\"?",
        ),
        (
            &["analyse", "navion", "--set", "elevator=0.1"],
            "elevator (elevator) sizes a disturbance, which has no part in this answer; only \"respond\" uses it",
        ),
        (
            &["frequency", "navion", "--set", "time=10"],
            "time (time shown) sizes a disturbance, which has no part in this answer; only \"respond\" uses it",
        ),
        (
            &["respond", "navion", "--disturbance", "release", "--set", "from_beta=0.1"],
            "from_beta (sideslip at release) is no size of the disturbance \"release\" in longitudinal motion; \
             expected from_u, from_alpha, from_q, from_theta, times, time",
        ),
        (
            &["respond", "navion", "--disturbance", "elevator", "--shape", "pulse", "--set", "elevator=0.1"],
            "elevator (elevator) is no size of the disturbance \"elevator pulse\" in longitudinal motion; \
             expected elevator_pulse, part, times, time",
        ),
        (
            &["analyse", "lesson", "--set", "cm_alpha=1"],
            "lesson has no parameter cm_alpha (pitch stiffness): its source has no numbers for it",
        ),
        (
            &["analyse", "navion", "--set", "speed=25"],
            "the wing would need C_L 1.89 at 25.0 m/s; this aircraft is taken to stall at 1.40",
        ),
        (&["analyse", "navion", "--set", "speed=NaN"], "speed: expected a finite number"),
        (
            &["respond", "navion", "--set", "elevator=3"],
            "elevator: 3.000 rad is beyond what is accepted, −0.3500 to 0.3500 rad",
        ),
        (&["respond", "lesson", "--disturbance", "side-gust"], "lesson has no lateral data"),
        (
            &["respond", "navion", "--disturbance", "gale"],
            "there is no disturbance \"gale\"; expected one of elevator, throttle, vertical-gust, head-gust, rudder, aileron, side-gust, turbulence, release, mode, pitch-command, speed-command, height-command, bank-command, yaw-rate-command, heading-command",
        ),
        (&["respond", "navion", "--steps", "0"], "steps: expected 1 to 100000, found 0"),
        (
            &["frequency", "navion", "--output", "alhpa"],
            "there is no output \"alhpa\"; did you mean \"alpha\"?",
        ),
        (
            &["frequency", "navion", "--disturbance", "elevatr"],
            "there is no input \"elevatr\"; did you mean \"elevator\"?",
        ),
        (
            &["frequency", "navion", "--disturbance", "mode"],
            "there is no input \"mode\"; expected one of elevator, throttle, vertical-gust, head-gust, rudder, aileron, side-gust",
        ),
        (
            &["frequency", "navion", "--disturbance", "rudder", "--output", "q"],
            "q doesn't move in lateral motion",
        ),
        (&["frequency", "lesson", "--output", "beta"], "lesson has no lateral data"),
        (&["frequency", "navion", "--from", "0"], "from: expected 0.000001 to 1000000 rad/s, found 0"),
        (&["frequency", "navion", "--from", "2", "--to", "1"], "expected from below to, found 2 and 1 rad/s"),
        (
            &["sweep", "navion", "--parameter", "cg", "--from", "0", "--to", "0"],
            "a sweep from 0 to 0 goes nowhere",
        ),
        (
            &["sweep", "navion", "--parameter", "cg", "--from", "0", "--to", "9"],
            "cg: 9.000 is beyond what is accepted, −0.3000 to 0.4000",
        ),
        (
            &["sweep", "navion", "--parameter", "cg", "--from", "0", "--to", "0.1", "--points", "1"],
            "points: expected 2 to 100000, found 1",
        ),
        (
            &["sweep", "navion", "--parameter", "cm_de", "--from", "-1", "--to", "0"],
            "cm_de (elevator power) moves no mode: there is nothing to sweep",
        ),
        (&["analyse", "missing.toml"], "cannot read missing.toml: No such file or directory (os error 2)"),
        (
            &["analyse", "--matrix", "navion.txt"],
            "cannot read navion.txt: No such file or directory (os error 2)",
        ),
        (&["analyse", &file("bad.toml", navion.replace("cond", "= cond").as_bytes())], "bad.toml, line 4: "),
        (
            &["analyse", &file("empty.toml", b"")],
            "empty.toml, line 1: the file is empty; expected matrices A and B, or the output of a program",
        ),
        (
            &["analyse", "--matrix", &file("ragged.m", matlab.replace("176.0      0", "176.0").as_bytes())],
            "ragged.m, line 7: A: expected 4 numbers in row 2, found 3",
        ),
        (
            &["analyse", "--matrix", &file("nan.m", matlab.replace("-2.986", "NaN").as_bytes())],
            "nan.m, line 8: A: expected plain numbers or quoted names, found \"NaN\"; nothing is computed here",
        ),
        (
            &["analyse", "--matrix", &file("no-units.m", matlab.replace("units", "in").as_bytes())],
            "no-units.m, line 1: the file doesn’t say units (unit system of the file: SI or ft-slug-s; perhaps ft-slug-s)",
        ),
        (
            &["analyse", "--matrix", &file("binary.m", &[b'A', b'=', 0xff, 0xfe])],
            "binary.m, line 1: A: expected plain numbers or quoted names, found \"ÿþ\"; nothing is computed here",
        ),
    ];
    for (arguments, expected) in cases {
        let Output { status, stdout, stderr } = run(arguments);
        let said = String::from_utf8_lossy(&stderr).replace(concat!(env!("CARGO_TARGET_TMPDIR"), "/"), "");
        assert!(said.starts_with(&format!("error: {expected}")), "{arguments:?}: {said}");
        assert_eq!(said.matches('\n').count(), 1, "{said}");
        assert!(expected.ends_with(": ") || said.len() == "error: \n".len() + expected.len(), "{said}");
        assert_eq!((status.code(), stdout), (Some(1), Vec::new()), "{arguments:?}");
    }
}

#[test]
fn a_command_that_is_not_understood_is_one_line_and_exit_code_2() {
    let cases: [(&[&str], &str); 5] = [
        (&["fly"], "error: unrecognized subcommand 'fly'"),
        (&["analyse"], "error: the following required arguments were not provided: <AIRCRAFT>"),
        (
            &["analyse", "navion", "--jsn"],
            "error: unexpected argument '--jsn' found; a similar argument exists: '--json'",
        ),
        (
            &["analyse", "navion", "--json", "--csv"],
            "error: the argument '--json' cannot be used with '--csv'",
        ),
        (
            &["analyse", "navion", "--set", "cm_alpha"],
            "error: invalid value 'cm_alpha' for '--set <KEY=VALUE>': expected KEY=VALUE",
        ),
    ];
    for (arguments, expected) in cases {
        let Output { status, stdout, stderr } = run(arguments);
        assert_eq!(String::from_utf8_lossy(&stderr), format!("{expected}\n"));
        assert_eq!((status.code(), stdout), (Some(2), Vec::new()));
    }
}

#[test]
fn a_reader_that_stops_early_is_no_error() {
    let mut command = cli(&["respond", "navion", "--steps", "20000", "--csv"]);
    let mut child =
        command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("the command line starts");
    let mut head = String::new();
    // The reader is dropped after one line, and with it the pipe.
    BufReader::new(child.stdout.take().expect("its output is piped"))
        .read_line(&mut head)
        .expect("there is a first line");
    assert!(head.starts_with("time [s],elevator [rad],u [m/s]"), "{head}");
    let Output { status, stderr, .. } = child.wait_with_output().expect("it ends");
    assert_eq!((status.code(), stderr), (Some(0), Vec::new()));
}

#[test]
fn a_motion_that_is_no_longer_small_is_marked_in_a_column_and_beside_the_csv() {
    let arguments =
        ["respond", "navion", "--set", "cm_alpha=0.5", "--set", "time=6", "--steps", "60", "--csv"];
    let Output { status, stdout, stderr } = run(&arguments);
    assert!(status.success());
    let note = String::from_utf8_lossy(&stderr).into_owned();
    assert!(note.starts_with("note: After ") && note.contains("no longer small"), "{note}");
    let text = String::from_utf8(stdout).expect("a text");
    let column = |line: &str| line.rsplit(',').next().unwrap_or_default().to_owned();
    let small: Vec<String> = text.lines().map(column).collect();
    assert_eq!(small[0], "small");
    assert_eq!(small.len(), 62);
    let first_large = small.iter().position(|cell| cell == "0").expect("it grows");
    assert!(first_large > 10 && small[1..first_large].iter().all(|cell| cell == "1"));
    assert!(small[first_large..].iter().all(|cell| cell == "0"));
}

#[test]
fn lessons_are_checked_with_the_words_beside_them() {
    let said = answer(&["check", "../../../assets/lessons/longitudinal.md"]);
    assert_eq!(said, "../../../assets/lessons/longitudinal.md: holds what it promises\n");
    // Of a lecture, how long it takes.
    let lecture = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("lecture.md");
    let text = "+++\ntitle = \"t\"\nlecture = true\n+++\n## a\n```scene\nlink = \"#v=1&ac=navion\"\n```\n\
                ```notes 2.5 min\n30 s of silence\n```\n## b\n";
    std::fs::write(&lecture, text).expect("a file");
    let lecture = lecture.display().to_string();
    let expected = "holds what it promises; a lecture of 2.5 min in 2 slides, 1 of them without minutes";
    assert_eq!(answer(&["check", &lecture]), format!("{lecture}: {expected}\n"));
    // No lesson at all, as front matter tells.
    let Output { status, stderr, .. } = run(&["check", "../../../README.md"]);
    assert_eq!(status.code(), Some(1));
    let expected = "error: ../../../README.md, line 1: expected front matter, which begins with a line +++\n";
    assert_eq!(String::from_utf8_lossy(&stderr), expected);
}

#[test]
fn tables_are_in_feet_where_they_are_wanted_and_programs_get_si() {
    let parameters = answer(&["parameters", "navion", "--units", "ft"]);
    assert!(
        parameters.lines().any(|line| line.trim_start().starts_with("speed ") && line.contains("ft/s")),
        "{parameters}"
    );
    let analysis = answer(&["analyse", "navion", "--set", "speed=60", "--units", "ft"]);
    assert!(analysis.contains("speed = 196.9 ft/s") && analysis.contains("1/(ft·s)"), "{analysis}");
    assert!(answer(&["analyse", "#v=1&ac=navion&units=ft"]).contains("1/(ft·s)"), "a link tells them");
    assert!(answer(&["analyse", "#v=1&ac=navion&units=ft", "--units", "si"]).contains("1/(m·s)"));
    let motion = answer(&["respond", "navion", "--units", "ft"]);
    assert!(motion.contains("[ft/s]") && motion.contains("[deg]") && !motion.contains("[rad]"), "{motion}");
    let sweep =
        ["sweep", "navion", "--parameter", "speed", "--from", "30.48", "--to", "60.96", "--points", "2"];
    let swept = answer(&[&sweep[..], &["--measure", "phugoid.period", "--units", "ft"]].concat());
    assert!(
        swept.contains("speed [ft/s]") && swept.lines().any(|line| line.trim_start().starts_with("200")),
        "{swept}"
    );
    let refused = run(&["analyse", "navion", "--units", "ft", "--json"]);
    assert_eq!(refused.status.code(), Some(2));
}
