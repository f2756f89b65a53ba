//! What the command line takes along as a picture, and that tables, figures and sentences of one answer have one unit of length.

use std::path::PathBuf;
use std::process::{Command, Output};

use resvg::tiny_skia::Pixmap;

/// A page of A4 has so many dots between its margins: 160 mm at 300 dots an inch, rounded as browsers do.
const WIDTH: u32 = 1891;

fn run(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_eigenwing-cli"))
        .args(arguments)
        .output()
        .expect("the command line starts")
}

fn bytes(arguments: &[&str]) -> Vec<u8> {
    let Output { status, stdout, stderr } = run(arguments);
    assert!(status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&stderr));
    stdout
}

fn answer(arguments: &[&str]) -> String {
    String::from_utf8(bytes(arguments)).expect("a text")
}

fn complaint(arguments: &[&str]) -> String {
    let Output { status, stderr, .. } = run(arguments);
    assert_eq!(status.code(), Some(1), "{arguments:?}");
    String::from_utf8(stderr).expect("a text")
}

fn scratch(name: &str) -> (PathBuf, String) {
    let path = std::env::temp_dir().join(format!("eigenwing-{}-{name}", std::process::id()));
    let text = path.to_str().expect("a path that is a text").to_owned();
    (path, text)
}

/// The value of an attribute of the first element that has it.
fn attribute<'a>(svg: &'a str, name: &str) -> &'a str {
    let rest = svg.split_once(&format!("{name}=\"")).expect("the attribute").1;
    rest.split_once('"').expect("its end").0
}

#[test]
fn a_picture_has_the_dots_of_the_page_and_letters_where_the_figure_has_them() {
    let link = "#v=1&ac=navion&cm_q=-20&pin.ac=navion&lon.chart=static_margin&lon.over=cg";
    for figure in ["poles", "response", "frequency", "chart", "aircraft"] {
        let svg = answer(&["export", &format!("{figure}-figure"), link]);
        let png = bytes(&["export", &format!("{figure}-png"), link]);
        let picture = Pixmap::decode_png(&png).expect("a picture");
        let millimetres: f64 =
            attribute(&svg, "height").trim_end_matches("mm").parse().expect("a height in millimetres");
        // A browser draws on whole pixels, 96 an inch, and the page makes 300 dots an inch of them.
        let height = ((millimetres / 25.4 * 96.0).round() * 300.0 / 96.0).round() as u32;
        assert_eq!((picture.width(), picture.height()), (WIDTH, height), "{figure}");
        // On white, up to the edges.
        assert!(
            [0, WIDTH - 1].iter().all(|&x| picture.pixel(x, 0).expect("a corner").is_opaque()),
            "{figure}"
        );
        // The title, 10.5 points in semibold, below the edge.
        let ink = |from: f64, to: f64| {
            let dots = |points: f64| (points * 300.0 / 72.0) as u32;
            let rows = dots(from)..dots(to);
            let all = rows.flat_map(|y| (dots(54.0)..dots(150.0)).map(move |x| (x, y)));
            all.filter(|&(x, y)| picture.pixel(x, y).is_some_and(|dot| dot.red() < 160)).count()
        };
        assert!(ink(5.5, 14.0) > 3000, "{figure}: {}", ink(5.5, 14.0));
        assert_eq!(ink(0.0, 4.5), 0, "{figure}");
    }
}

#[test]
fn the_ending_of_a_file_makes_a_figure_a_picture_and_nothing_else_becomes_one() {
    let (path, name) = scratch("poles.png");
    assert_eq!(answer(&["export", "poles-figure", "navion", "--output", &name]), "");
    let written = std::fs::read(&path).expect("the file");
    std::fs::remove_file(&path).expect("the file goes");
    assert_eq!(written, bytes(&["export", "poles-png", "navion"]), "printed or written, it is the same");
    let refused = complaint(&["export", "python", "navion", "--output", &name]);
    assert!(refused.contains("only figures become pictures") && !path.exists(), "{refused}");
    assert!(complaint(&["export", "modes-png", "navion"]).contains("there is no target \"modes-png\""));
}

#[test]
fn frequency_responses_are_in_the_units_that_were_chosen() {
    let gust = ["--disturbance", "vertical-gust", "--output", "theta"];
    let of = |units: &[&str]| answer(&[&["frequency", "navion"][..], &gust, units].concat());
    let (metres, feet) = (of(&[]), of(&["--units", "ft"]));
    assert!(metres.contains("gain [rad per m/s]") && metres.contains("phase [rad]"), "{metres}");
    assert!(feet.contains("gain [deg per ft/s]") && !feet.contains("[rad]"), "{feet}");
    let peak = |text: &str| -> f64 {
        let line = text.lines().find(|line| line.contains(" peak: ")).expect("a peak");
        let number = line.split_once(": ").expect("its gain").1.split(' ').next().expect("a number");
        number.parse().expect("a number")
    };
    // A radian for a metre a second is 57.3° for 3.28 ft/s; four digits are told.
    let ratio = peak(&feet) / peak(&metres);
    assert!((ratio / (0.3048 * 1_f64.to_degrees()) - 1.0).abs() < 1e-3, "{ratio}");
    let gain = |text: &str| -> f64 {
        let line = text.lines().find(|line| line.starts_with("G(s) = ")).expect("the transfer function");
        let number = line.trim_start_matches("G(s) = ").split(' ').next().expect("its gain");
        number.replace('−', "-").parse().expect("a number")
    };
    let ratio = gain(&feet) / gain(&metres);
    assert!((ratio / (0.3048 * 1_f64.to_degrees()) - 1.0).abs() < 1e-3, "{ratio}");
    // A rate is in degrees, as on the page; the frequency beside it never is.
    let rates = answer(&["frequency", "navion", "--units", "ft"]);
    assert!(rates.contains("gain [deg/s per deg]") && rates.contains("ω [rad/s]"), "{rates}");

    let link = "#v=1&ac=navion&lon.source=vertical-gust&tab=frequency&lon.frequency_of=u";
    let figure = |units: &str| answer(&["export", "frequency-figure", &format!("{link}{units}")]);
    assert!(figure("&units=si").contains("gain [m/s per m/s]"), "{}", figure("&units=si"));
    assert!(figure("&units=ft").contains("gain [ft/s per ft/s]"));
}

#[test]
fn sentences_have_the_units_of_the_numbers_beside_them() {
    let slow = ["analyse", "navion", "--set", "speed=20"];
    assert!(complaint(&slow).contains("at 20.0 m/s"));
    let feet = complaint(&[&slow[..], &["--units", "ft"]].concat());
    assert!(feet.contains("at 65.6 ft/s") && !feet.contains("m/s"), "{feet}");
    let motion = ["respond", "navion", "--set", "elevator=0.05", "--set", "time=60"];
    let metres = answer(&motion);
    assert!(metres.contains("Δu is more than 26.8\u{a0}m/s"), "{metres}");
    let feet = answer(&[&motion[..], &["--units", "ft"]].concat());
    assert!(feet.contains("Δu is more than 88\u{a0}ft/s"), "{feet}");
    let swing = |units: &str| {
        let text =
            answer(&["respond", "navion", "--set", "elevator=0.01", "--set", "time=300", "--units", units]);
        let line = text.lines().find(|line| line.starts_with("Height from the phugoid")).expect("the swing");
        let words: Vec<&str> = line.rsplitn(3, ' ').collect();
        (words[1].parse::<f64>().expect("a number"), words[0].to_owned())
    };
    let ((metres, m), (feet, ft)) = (swing("si"), swing("ft"));
    assert_eq!((m.as_str(), ft.as_str()), ("m", "ft"));
    assert!((feet * 0.3048 / metres - 1.0).abs() < 1e-3, "{feet} ft, {metres} m");
}
