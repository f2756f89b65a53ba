//! Figures look the same wherever they are: every word is an outline, and no font is asked for that isn't there.

use eigenwing::content::FILES;
use eigenwing::export::{DisturbanceRequest, Source, Subject, TakenAlong, Target, take_along};
use eigenwing::findings::measures::Measure;
use eigenwing::key::Keyed as _;
use eigenwing::scenario::{Source as Disturbance, parameters};

const FIGURES: [Target; 5] = [
    Target::PolesFigure,
    Target::ResponseFigure,
    Target::FrequencyFigure,
    Target::ChartFigure,
    Target::AircraftFigure,
];

fn keys() -> impl Iterator<Item = &'static str> {
    FILES.iter().filter_map(|(file, _)| file.strip_suffix(".toml"))
}

/// A scene taken along; `None` where it can't be.
fn taken(source: Source, target: Target) -> Option<TakenAlong> {
    let scene = Subject { source, ..Subject::listed("") }.scene().expect("a scene");
    take_along(&scene, target.key(), &DisturbanceRequest::default()).ok()
}

fn linked(link: &str, target: Target) -> Option<TakenAlong> {
    taken(Source::Link(link.to_owned()), target)
}

/// Words are there, and none of them asks for a font.
fn check(taken: &TakenAlong, what: &str) {
    let svg = &taken.text;
    assert!(svg.matches("<path transform").count() >= 1, "{what}: no words");
    for asking in ["<text", "<tspan", "font", "<style", "@import", "href"] {
        assert!(!svg.contains(asking), "{what}: {asking}: {:?}", taken.notices);
    }
}

#[test]
fn every_word_of_every_figure_is_an_outline() {
    let mut checked = 0;
    for key in keys() {
        for plane in ["", "&plane=lateral"] {
            for target in FIGURES {
                let link = format!("v=1&ac={key}{plane}");
                let Some(taken) = linked(&link, target) else { continue };
                check(&taken, &format!("{link} {}", target.key()));
                checked += 1;
            }
        }
    }
    for source in Disturbance::VALUES {
        for (plane, at) in [("lon", ""), ("lat", "&plane=lateral")] {
            for feedback in
                ["", "&k.q_de=0.3&k.r_dr=1.5&washout=3", "&flight=nonlinear&elevator=-5&rudder=20"]
            {
                let link = format!(
                    "v=1&ac=navion&{plane}.source={}{at}{feedback}&pin.ac=navion&units=ft",
                    source.key()
                );
                for target in [Target::PolesFigure, Target::ResponseFigure, Target::FrequencyFigure] {
                    let Some(taken) = linked(&link, target) else { continue };
                    check(&taken, &format!("{link} {}", target.key()));
                    checked += 1;
                }
            }
        }
    }
    assert!(checked > 300, "{checked}");
}

#[test]
fn every_word_of_every_chart_is_an_outline() {
    let mut checked = 0;
    let over = parameters().map(|parameter| ("static_margin".to_owned(), parameter.key));
    let of = Measure::all().map(|measure| (measure.key(), "speed"));
    for (measure, parameter) in over.chain(of) {
        for how in ["units=si", "units=ft&notation=alpha-beta&plane=lateral"] {
            let plane = if how.contains("lateral") { "lat" } else { "lon" };
            let link = format!("v=1&ac=navion&{how}&{plane}.chart={measure}&{plane}.over={parameter}");
            let Some(taken) = linked(&link, Target::ChartFigure) else { continue };
            check(&taken, &link);
            checked += 1;
        }
    }
    assert!(checked > 200, "{checked}");
}

/// The words stand beside their outlines, for who searches or edits the file.
#[test]
fn what_is_outlined_can_be_read_in_the_file() {
    let link = "v=1&ac=navion&notation=alpha-beta&lon.chart=parameter.m_wdot&lon.over=speed&units=ft";
    let chart = linked(link, Target::ChartFigure).expect("a chart").text;
    assert!(chart.contains("aria-label=\"airspeed V [ft/s]\""), "{chart}");
    let poles = linked("v=1&ac=navion", Target::PolesFigure).expect("a figure").text;
    assert!(poles.contains("aria-label=\"Phugoid −0.01"), "{poles}");
}

/// A name in letters that figures don't have can still be read, and it is said that it is left to the fonts of the machine.
#[test]
fn a_name_in_other_letters_stays_text_and_is_told() {
    let (_, text) = FILES.iter().find(|(file, _)| *file == "navion.toml").expect("it ships");
    let name = text.lines().find(|line| line.starts_with("name = ")).expect("a name");
    let text = text.replacen(name, "name = \"Як-18\"", 1);
    let own = |target| taken(Source::Toml { file: "own.toml".to_owned(), text: text.clone() }, target);
    let figure = own(Target::PolesFigure).expect("a figure");
    assert!(
        figure.text.contains("font-family=\"sans-serif\"") && figure.text.contains(">Як-18: "),
        "{}",
        figure.text
    );
    assert_eq!(figure.text.matches("<text").count(), 1, "all other words are outlines");
    assert!(
        figure.notices.iter().any(|notice| notice.starts_with("Words with Я к stay text")),
        "{:?}",
        figure.notices
    );
    assert_eq!(own(Target::Python).expect("a script").notices, [""; 0]);
    assert!(!own(Target::Page).expect("a page").notices.is_empty());
}
