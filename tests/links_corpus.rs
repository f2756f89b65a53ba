//! Links that were ever published, in `tests/links.txt`: what each must mean, for ever.

mod opened;

use eigenwing::flight::aircraft::plane::Plane;
use eigenwing::flight::motion::outputs::Output;
use eigenwing::key::Keyed as _;
use eigenwing::scenario::link::{Notice, Opened};
use eigenwing::scenario::view::{
    Camera, Details, Marks, Overlays, ResponseView, StandardView, Tab, Turn, View,
};
use eigenwing::scenario::{Parameter, Quantity, parameters};
use eigenwing::words;
use opened::{AIRCRAFT, assert_sound, open};

fn row(key: &str) -> &'static Parameter {
    Parameter::find(key).expect("a row of the table")
}

/// What `tests/links.txt` says.
struct Line {
    link: &'static str,
    values: Vec<(&'static str, &'static str)>,
    notices: Vec<&'static str>,
}

fn corpus() -> Vec<Line> {
    let lines = include_str!("links.txt").lines().filter(|line| !line.is_empty() && !line.starts_with("//"));
    lines
        .map(|line| {
            let (link, meaning) = line.split_once(" -> ").expect("link -> what it means");
            let mut parts = meaning.split(" | ").map(str::trim);
            let values = parts.next().unwrap_or_default().split(", ").filter(|value| !value.is_empty());
            let values = values.map(|value| value.split_once('=').expect("key=value")).collect();
            Line { link: link.trim(), values, notices: parts.collect() }
        })
        .collect()
}

/// A disturbance by the words that it had when the list of links began.
fn as_ever(choice: &str) -> &str {
    if choice == "Initial state" { "Released from" } else { choice }
}

fn assert_value(opened: &Opened, key: &str, expected: &str, link: &str) {
    let pinned = key.strip_prefix("pin.");
    let scenario = match pinned {
        Some(_) => opened.pinned.as_ref().expect("a pinned state"),
        None => &opened.scenario,
    };
    let of_plane = |plane| {
        format!(
            "{} of {}",
            as_ever(&words::disturbance::choice(&scenario.disturbance.choices[plane])),
            scenario.disturbance.choices[plane].mode + 1
        )
    };
    let View { response, flight, .. } = &opened.view;
    let found = match pinned.unwrap_or(key) {
        "ac" => scenario.aircraft.key.clone(),
        "plane" => format!("{:?}", scenario.plane).to_lowercase(),
        "class" => scenario.task.map_or("none", |task| task.class.key()).to_owned(),
        "category" => scenario.task.map_or("none", |task| task.category.key()).to_owned(),
        "lon" => of_plane(Plane::Longitudinal),
        "lat" => of_plane(Plane::Lateral),
        "page" => words::sliders::page(opened.view.page).to_owned(),
        "tab" => match response.tab {
            // As the link has always called it.
            Tab::Metrics => "Figures".to_owned(),
            tab => format!("{tab:?}"),
        },
        "nonlinear" => response.nonlinear.to_string(),
        "follows" => scenario.disturbance.follows.to_string(),
        // Everything but the page of sliders and the tab.
        "sight" => {
            let ResponseView { tab, nonlinear, .. } = *response;
            let usual = View::of(&opened.scenario);
            let response = ResponseView { tab, nonlinear, ..usual.response };
            let usual = View { page: opened.view.page, response, ..usual };
            format!("{:?}", opened.view == usual)
        }
        "shown" => {
            let keys = |outputs: &Vec<Output>| {
                outputs.iter().map(|output| Quantity::of(*output).key).collect::<Vec<_>>().join(" ")
            };
            response.shown.iter().map(keys).collect::<Vec<_>>().join(" / ")
        }
        "portraits" => {
            let pair = |(across, upward): &(Output, Output)| {
                format!("{} over {}", Quantity::of(*upward).key, Quantity::of(*across).key)
            };
            response.portraits.iter().flatten().map(pair).collect::<Vec<_>>().join(" / ")
        }
        "frequency of" => {
            let keys = response.frequency_of.iter().map(|output| Quantity::of(*output).key);
            keys.collect::<Vec<_>>().join(" / ")
        }
        "split" => response.split.to_string(),
        "marks" => {
            let Marks { approximations, levels } = opened.view.marks;
            format!("{approximations} {levels}")
        }
        "details" => {
            let Details { shape, levels, approximations } = opened.view.details;
            format!("{shape} {levels} {approximations}")
        }
        "pane" => format!("{:?}", opened.view.maximised),
        "stage" => opened.view.stage.parts().iter().map(|part| part.key()).collect::<Vec<_>>().join("."),
        "offer" => opened.view.stage.offered.join("."),
        "hide" => opened.view.stage.hidden().iter().map(|hidden| hidden.key()).collect::<Vec<_>>().join("."),
        "lock" => opened.view.stage.locks().iter().map(|lock| lock.key()).collect::<Vec<_>>().join("."),
        "locked" => opened.view.stage.locked.join("."),
        "present" => opened.view.presents.to_string(),
        "look" => opened.view.look.map_or_else(|| "own".to_owned(), |look| look.key().to_owned()),
        "type" => opened.view.stage.type_size.to_string(),
        "lesson" => opened.lesson.as_ref().map_or("none", |place| &place.address).to_owned(),
        "step" => opened.lesson.as_ref().map_or(0, |place| place.step + 1).to_string(),
        "begins" => opened.lesson.as_ref().is_some_and(|place| place.begins).to_string(),
        "camera" => {
            let Camera { azimuth, elevation, distance } = flight.camera;
            let standard = StandardView::ALL.into_iter().find(|view| view.camera() == flight.camera);
            let [azimuth, elevation] = [azimuth, elevation].map(|x| x.to_degrees().round());
            standard.map_or_else(
                || format!("{azimuth} {elevation} {}", (100.0 * distance).round()),
                |standard| format!("{standard:?}"),
            )
        }
        "drawn" => {
            let Overlays { body_axes, earth_axes, angles, rates, forces, flow, path, moments, .. } =
                flight.overlays;
            let all = [body_axes, earth_axes, angles, rates, forces, flow, path, moments];
            all.map(|on| if on { "1" } else { "0" }).concat()
        }
        "stability" => flight.overlays.stability_axes.to_string(),
        "turn" => {
            flight.turn.map_or("none".to_owned(), |Turn { psi, theta, phi }| format!("{psi} {theta} {phi}"))
        }
        "entries" => opened.view.equations.entries.key().to_owned(),
        "coloured" => opened.view.equations.coloured.map_or("none".to_owned(), |mode| mode.to_string()),
        "rate" => flight.pace.rate.to_string(),
        "loop" => flight.pace.is_looping.to_string(),
        "t" => flight.instant.time.to_string(),
        "play" => flight.instant.is_playing.to_string(),
        "units" => opened.scenario.units.key().to_owned(),
        "notation" => opened.scenario.notation.key().to_owned(),
        "pinned" => opened.pinned.is_some().to_string(),
        "edited" => scenario.is_edited().to_string(),
        key => {
            let (p, expected) =
                (row(key.trim_start_matches("add.")), expected.parse::<f64>().expect("a number"));
            let found =
                if key.starts_with("add.") { p.added(scenario).expect("an offset") } else { p.get(scenario) };
            assert!(
                (found - expected).abs() <= 1e-8 * expected.abs(),
                "{key} is {found}, not {expected}: {link}"
            );
            return;
        }
    };
    assert_eq!(found, expected, "{key}: {link}");
}

#[test]
fn every_link_of_the_corpus_means_what_it_meant() {
    for Line { link, values, notices } in corpus() {
        let opened = open(link);
        for (key, expected) in values {
            assert_value(&opened, key, expected, link);
        }
        let told: Vec<String> = opened.notices.iter().map(Notice::to_string).collect();
        assert_eq!(told.len(), notices.len(), "{link}: {told:#?}");
        for notice in notices {
            assert!(
                told.iter().any(|sentence| sentence.contains(notice)),
                "{link}: {notice} not in {told:#?}"
            );
        }
        assert_sound(&opened, link);
    }
}

#[test]
fn the_corpus_has_every_key_and_every_aircraft() {
    let corpus = corpus();
    let pieces: Vec<&str> =
        corpus.iter().filter(|line| line.notices.is_empty()).flat_map(|line| line.link.split('&')).collect();
    for p in parameters() {
        let start = format!("{}=", p.key);
        let found = pieces.iter().any(|piece| piece.trim_start_matches("add.").starts_with(&start));
        assert!(found, "no link with {}", p.key);
    }
    for aircraft in AIRCRAFT.iter() {
        assert!(pieces.contains(&format!("ac={}", aircraft.key).as_str()), "no link with {}", aircraft.key);
    }
}

#[test]
fn a_damaged_link_opens_what_it_can() {
    for (i, Line { link, .. }) in corpus().into_iter().enumerate().filter(|(_, line)| !line.link.is_empty()) {
        let letters: Vec<char> = link.chars().collect();
        for at in 0..letters.len() {
            let cut: String = letters[..at].iter().collect();
            let mut swapped = letters.clone();
            swapped.swap(at, (at + 1) % letters.len());
            let mut lost = letters.clone();
            lost.remove(at);
            let mut changed = letters.clone();
            changed[at] = ['%', '=', '&', '-', 'e', '\u{fffd}', '9'][(at + i) % 7];
            for damaged in [cut, swapped.iter().collect(), lost.iter().collect(), changed.iter().collect()] {
                let opened = open(&damaged);
                assert!(AIRCRAFT.contains(&opened.scenario.aircraft));
                if (at + i) % 11 == 0 {
                    assert_sound(&opened, &damaged);
                }
            }
        }
    }
}
