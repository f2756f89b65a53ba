//! What is taken along of a scene: that it opens again as it was, that it is well formed, and that nothing is left out unsaid.
//!
//! Whether the scripts run, and come to the same numbers, is proved by `export_scripts`.

use std::collections::BTreeMap;

use eigenwing::content::{Aircraft, FILES, MatrixFormat, lines_with_key};
use eigenwing::export::{
    DisturbanceRequest, PlaneOutcome, Report, Scene, Source, Subject, TakenAlong, Target, analyse, json,
    take_along,
};
use eigenwing::key::Keyed as _;
use eigenwing::scenario::{Parameter, Scenario, parameters};
use serde_json::Value;

fn keys() -> impl Iterator<Item = &'static str> {
    FILES.iter().filter_map(|(file, _)| file.strip_suffix(".toml"))
}

fn scene(source: Source) -> Scene {
    Subject { source, ..Subject::listed("") }.scene().expect("a scene")
}

fn linked(link: &str) -> Scene {
    scene(Source::Link(link.to_owned()))
}

fn taken(scene: &Scene, target: Target) -> TakenAlong {
    let key = target.key();
    take_along(scene, key, &DisturbanceRequest::default()).unwrap_or_else(|error| panic!("{key}: {error}"))
}

/// An edit of every third number of an aircraft, none of them round.
fn edits(scenario: &Scenario, start: usize) -> Vec<(String, f64)> {
    let of_aircraft = parameters().filter(|p| !p.is_of_disturbance() && p.applies(scenario));
    let edited = |p: &Parameter| {
        let range = p.range(scenario);
        let part = 1.0 / 3.0 + 0.05 * p.key.len() as f64 / 7.0;
        let value = p.get(scenario) + 0.02 * part * (range.end() - range.start());
        (p.key.to_owned(), value)
    };
    of_aircraft.skip(start).step_by(3).map(edited).collect()
}

/// A and B of a plane.
type Matrices = ([[f64; 4]; 4], [[f64; 2]; 4]);

#[test]
fn an_aircraft_file_that_is_taken_along_opens_to_the_last_bit() {
    let mut changed = 0;
    for key in keys() {
        for start in 0..3 {
            let plain = Subject::listed(key).scenario().expect("an aircraft");
            let subject = Subject { set: edits(&plain, start), ..Subject::listed(key) };
            // Not every aircraft can be flown with such edits.
            let Ok(edited) = subject.scene() else { continue };
            let text = taken(&edited, Target::Toml).text;
            let again = scene(Source::Toml { file: "again.toml".to_owned(), text: text.clone() });
            assert_eq!(again.notices, [""; 0], "{text}");
            assert_eq!(again.scenario.edited, edited.scenario.edited, "{key}");
            // A file's aircraft carries its text, and is the same otherwise.
            let aircraft = Aircraft { own: None, ..Aircraft::clone(&again.scenario.aircraft) };
            let unmarked = Scenario { aircraft: aircraft.into(), ..again.scenario.clone() };
            assert_eq!(unmarked, edited.scenario, "{key}");
            // And once more: what was changed is not told twice.
            assert_eq!(taken(&again, Target::Toml).text, text);
            changed += usize::from(edited.scenario.is_edited());
        }
        let (_, shipped) =
            FILES.iter().find(|(file, _)| file.strip_suffix(".toml") == Some(key)).expect("a file");
        assert_eq!(taken(&Subject::listed(key).scene().expect("an aircraft"), Target::Toml).text, *shipped);
    }
    assert!(changed > 40, "{changed}");
}

/// However the line is written, it is one line, and gone with the edits.
#[test]
fn edits_that_were_written_by_hand_are_replaced() {
    let (_, file) = FILES.iter().find(|(file, _)| *file == "navion.toml").expect("it ships");
    let open = |text: &str| scene(Source::Toml { file: "again.toml".to_owned(), text: text.to_owned() });
    for line in ["edits=\"cg=16\"", "  edits   = 'cg=16'", "\"edits\" = \"cg=16\" # aft"] {
        // Behind the first key, where a person may put it.
        let text = file.replacen("name =", &format!("{line}\nname ="), 1);
        let opened = open(&text);
        assert_eq!(Parameter::find("cg").expect("a row").get(&opened.scenario), 0.16, "{line}");
        let again = taken(&opened, Target::Toml).text;
        assert_eq!(open(&again).scenario.edited, opened.scenario.edited, "{again}");
        assert_eq!(again.matches("edits").count(), 1, "{again}");
        let mut reset = opened.clone();
        reset.scenario = Scenario::new(opened.scenario.aircraft.clone());
        assert_eq!(taken(&reset, Target::Toml).text, *file, "{line}");
    }
    // A table may have a key of that name.
    let text = format!("{file}\n[of-mine]\nedits = \"x\"\n");
    assert!(lines_with_key(&text, "edits").all(|(_, is_key)| !is_key));
}

#[test]
fn edits_in_an_aircraft_file_that_cannot_be_used_are_told() {
    let text = format!("edits = \"cg=16&cm_alhpa=1\"\n{}", FILES[0].1);
    let opened = scene(Source::Toml { file: "own.toml".to_owned(), text });
    assert_eq!(opened.notices, ["“cm_alhpa” means nothing to this version and was left out."]);
    assert_eq!(Parameter::find("cg").expect("a row").get(&opened.scenario), 0.16);
}

#[test]
fn matrices_that_are_taken_along_are_the_same_matrices() {
    let a_and_b = |report: &Report| -> BTreeMap<&'static str, Matrices> {
        let planes = [("longitudinal", &report.longitudinal), ("lateral", &report.lateral)];
        let of = |(name, plane): (_, &Option<PlaneOutcome>)| {
            plane.as_ref().and_then(PlaneOutcome::report).map(|plane| (name, (plane.a, plane.b)))
        };
        planes.into_iter().filter_map(of).collect()
    };
    for key in keys() {
        let scene = Subject::listed(key).scene().expect("an aircraft");
        let report = analyse(&scene).expect("an analysis");
        for (plane, expected) in a_and_b(&report) {
            let request =
                DisturbanceRequest { plane: Some(plane.to_owned()), ..DisturbanceRequest::default() };
            let text = take_along(&scene, "json", &request).expect("matrices").text;
            let source = Source::Matrices { file: "a.json".to_owned(), text, format: MatrixFormat::Json };
            let again = analyse(&self::scene(source)).expect("an analysis");
            assert_eq!(a_and_b(&again)[plane], expected, "{key} {plane}");
        }
    }
}

#[test]
fn every_target_has_a_text_for_every_aircraft_and_says_its_file() {
    let mut flying = 0;
    for key in keys() {
        let scene = Subject::listed(key).scene().expect("an aircraft");
        for target in Target::VALUES {
            if *target == Target::Levels && scene.scenario.task.is_none() {
                let refused =
                    take_along(&scene, "levels", &DisturbanceRequest::default()).expect_err("no class");
                assert!(refused.to_string().starts_with(&format!("{key} has no class")), "{refused}");
                continue;
            }
            if *target == Target::Jsbsim {
                // It needs coefficients, which not every source has.
                match take_along(&scene, "jsbsim", &DisturbanceRequest::default()) {
                    Ok(taken) => {
                        flying += 1;
                        assert_eq!(taken.notices.len(), 1, "what JSBSim has no place for");
                        assert_eq!(
                            taken.text.matches("<axis ").count(),
                            taken.text.matches("</axis>").count()
                        );
                        assert!(taken.text.contains("<axis name=\"PITCH\">") && !taken.text.contains("NaN"));
                    }
                    Err(error) => {
                        assert!(error.to_string().starts_with("JSBSim needs coefficients"), "{error}")
                    }
                }
                continue;
            }
            let TakenAlong { text, file, notices, .. } = taken(&scene, *target);
            assert!(text.ends_with('\n') && text.len() > 50, "{key} {}: {text}", target.key());
            assert!(!text.contains("NaN") && !text.contains("inf,"), "{key} {}", target.key());
            assert_eq!(file, format!("{key}-{}.{}", target.key(), target.form().0));
            assert_eq!(notices, [""; 0]);
        }
    }
    assert_eq!(flying, 5, "sources with coefficients");
}

#[test]
fn csv_has_as_many_cells_in_every_row_and_json_is_json() {
    let scene = linked("#v=1&ac=navion&plane=lateral&lat.source=aileron&lat.frequency_of=phi&cn_beta=0.1");
    for target in [Target::Derivatives, Target::Poles, Target::Modes, Target::Response, Target::Frequency] {
        let text = taken(&scene, target).text;
        let rows: Vec<csv::StringRecord> =
            csv::Reader::from_reader(text.as_bytes()).records().collect::<Result<_, _>>().expect("CSV");
        assert!(rows.len() >= 3, "{text}");
    }
    let poles = taken(&scene, Target::Poles).text;
    assert_eq!(poles.lines().count(), 5, "four eigenvalues: {poles}");
    assert!(
        taken(&scene, Target::Frequency)
            .text
            .starts_with("frequency [rad/s],gain of phi by aileron [rad per rad],phase [rad]\n")
    );
    let derivatives = taken(&scene, Target::Derivatives).text;
    assert!(
        derivatives.contains("\ncn_beta,coefficients,lateral,weathercock stability,0.1,0.0701,1/rad,"),
        "{derivatives}"
    );

    let levels: Value = serde_json::from_str(&taken(&scene, Target::Levels).text).expect("JSON");
    assert_eq!((&levels["class"], &levels["category"]), (&"I".into(), &"B".into()));
    let short_period = &levels["paragraphs"]["3.2.2.1.2"];
    assert_eq!(short_period[0]["criterion_key"], "short-period-damping", "{levels:#}");
    assert!(levels["overall"]["level_key"].is_string());

    let notebook: Value = serde_json::from_str(&taken(&scene, Target::Notebook).text).expect("JSON");
    assert_eq!((&notebook["nbformat"], &notebook["nbformat_minor"]), (&4.into(), &5.into()));
    let code = notebook["cells"].as_array().expect("cells").iter().filter(|cell| cell["cell_type"] == "code");
    let lines =
        code.flat_map(|cell| cell["source"].as_array().expect("lines").iter()).filter_map(Value::as_str);
    let sources: Vec<&str> = lines.map(str::trim_end).filter(|line| !line.is_empty()).collect();
    assert!(sources.len() > 60, "{}", sources.len());
    let script = taken(&scene, Target::Python).text;
    for line in sources {
        assert!(script.contains(line), "{line}");
    }
}

/// A figure is well-formed XML: every element that begins ends, in order.
#[test]
fn figures_are_well_formed_and_hold_what_is_on_screen() {
    for link in [
        "#v=1&ac=navion",
        "#v=1&ac=navion&cm_alpha=0.5&lon.show=u.alpha.q.theta.gamma.nz.h.x.w",
        "#v=1&ac=b747-fc9&plane=lateral&lat.source=turbulence&lat.show=beta.phi&pin.ac=b747-fc9&pin.cn_beta=0.3",
        "#v=1&ac=lesson-printed&lon.source=mode&lon.frequency_of=theta",
        "#v=1&ac=navion&flight=nonlinear&elevator=-5",
    ] {
        let scene = linked(link);
        for target in [Target::PolesFigure, Target::ResponseFigure, Target::FrequencyFigure] {
            let text = taken(&scene, target).text;
            let mut open: Vec<&str> = Vec::new();
            for piece in text.split('<').skip(1) {
                let (tag, _) = piece.split_once('>').unwrap_or_else(|| panic!("{link}: {piece}"));
                if let Some(name) = tag.strip_prefix('/') {
                    assert_eq!(open.pop(), Some(name), "{link}");
                } else if !tag.starts_with('?') && !tag.ends_with('/') {
                    open.push(tag.split_whitespace().next().expect("a name"));
                }
            }
            assert_eq!(open, [""; 0], "{link}");
            assert!(text.contains("width=\"159.98mm\"") && text.contains("role=\"img\""), "{}", &text[..400]);
            assert!(!text.contains("NaN") && !text.contains("inf "), "{link}");
        }
        let response = taken(&scene, Target::ResponseFigure).text;
        let plane = scene.scenario.plane;
        assert_eq!(response.matches("<clipPath").count(), scene.view.response.shown[plane].len(), "{link}");
    }
    let poles = taken(&linked("#v=1&ac=navion&cm_q=-15&pin.ac=navion"), Target::PolesFigure).text;
    assert_eq!((poles.matches("l8 8m0 -8l-8 8").count(), poles.matches("<circle").count()), (4, 4));
    assert!(poles.contains("Phugoid"));
}

#[test]
fn what_has_no_place_in_a_target_is_told() {
    let told = taken(&linked("#v=1&ac=navion&flight=nonlinear&oops=1"), Target::Python).notices;
    assert_eq!(told.len(), 2, "{told:?}");
    assert!(told[1].starts_with("The nonlinear flight isn't taken along"));
    let matrices = include_str!("data/matrices/lesson.json").to_owned();
    let source =
        Source::Matrices { file: "lesson.json".to_owned(), text: matrices, format: MatrixFormat::Json };
    let error =
        take_along(&scene(source), "toml", &DisturbanceRequest::default()).expect_err("no aircraft file");
    assert!(error.to_string().contains("bare matrices"), "{error}");
    let misspelt =
        take_along(&linked("#v=1"), "pyhton", &DisturbanceRequest::default()).expect_err("no target");
    assert_eq!(misspelt.to_string(), "there is no target \"pyhton\"; did you mean \"python\"?");
}

#[test]
fn a_request_in_json_takes_a_scene_along() {
    let asked = r##"{"link": "#v=1&ac=navion&cg=16", "target": "latex", "plane": "lateral"}"##;
    let answer: Value = serde_json::from_str(&json::take_along(asked).expect("an answer")).expect("JSON");
    assert_eq!(
        (&answer["file"], &answer["media_type"]),
        (&"navion-latex.tex".into(), &"application/x-tex".into())
    );
    assert!(answer["text"].as_str().expect("a text").contains("\\bottomrule"));
    for (request, sentence) in [
        (r#"{"aircraft": "navion"}"#, "target: missing"),
        (r#"{"aircraft": "navion", "target": 7}"#, "target: expected a text, found 7"),
    ] {
        assert_eq!(json::take_along(request).map_err(|error| error.to_string()), Err(sentence.to_owned()));
    }
    assert!(json::take_along(r#"{"aircraft": "navion", "target": "python", "shap": "step"}"#).is_err());
}

/// A figure is well formed as XML is: every element that begins ends.
#[test]
fn every_figure_and_the_page_of_paper_are_made_of_every_aircraft() {
    let figures = [Target::PolesFigure, Target::ChartFigure, Target::AircraftFigure];
    for key in keys() {
        let scene = linked(&format!("v=1&ac={key}"));
        for target in figures {
            let text = taken(&scene, target).text;
            assert!(text.starts_with("<?xml") && text.ends_with("</svg>\n"), "{key}");
            assert!(!text.contains("NaN") && !text.contains("inf"), "{key} {}", target.key());
        }
        let page = taken(&scene, Target::Page);
        assert!(page.file.ends_with("-page.html") && page.text.starts_with("<!DOCTYPE html>"), "{key}");
        assert_eq!(page.text.matches("<svg").count(), page.text.matches("</svg>").count(), "{key}");
        assert!(page.text.matches("<svg").count() == 3 && !page.text.contains("<?xml"), "{key}");
        assert!(page.text.contains(&format!("#v=1&amp;ac={key}")), "{key}: the link as text");
    }
}

/// Who reads paper types the address: it is all there where the link had it, and where it is not, or no link is, a sentence says so.
#[test]
fn a_page_of_paper_has_the_whole_address_or_says_what_is_missing() {
    let address = "https://example.org/flight/";
    let with = taken(&linked(&format!("{address}#v=1&ac=navion&cg=16")), Target::Page).text;
    assert!(with.contains(&format!("{address}#v=1&amp;ac=navion&amp;cg=16")), "{with}");
    assert!(!with.contains("behind the address"));
    let without = taken(&linked("#v=1&ac=navion&cg=16"), Target::Page).text;
    assert!(
        without.contains(">#v=1&amp;ac=navion&amp;cg=16") && without.contains("behind the address of a page")
    );
    let script = taken(&linked(&format!("{address}#v=1&ac=navion")), Target::Python).text;
    assert!(script.contains(&format!("Scene: {address}#v=1&ac=navion")), "{script}");
    let matrices = include_str!("data/matrices/lesson.json").to_owned();
    let source =
        Source::Matrices { file: "lesson.json".to_owned(), text: matrices, format: MatrixFormat::Json };
    let bare = taken(&scene(source), Target::Page).text;
    assert!(bare.contains("known by its matrices only") && !bare.contains("#v=1"), "{bare}");
}

/// The text of an aircraft file that no link has room for: its remarks can't be packed.
fn long_file() -> String {
    let noise: String =
        (0_u64..900).map(|k| format!("# {}\n", k.wrapping_mul(0x9e37_79b9_7f4a_7c15))).collect();
    let (_, text) = FILES.iter().find(|(file, _)| *file == "navion.toml").expect("it ships");
    noise + &text.replacen("key = \"navion\"", "key = \"own-long\"", 1)
}

#[test]
fn an_aircraft_too_long_for_a_link_is_taken_along_beside_it() {
    let own = long_file();
    let asked = |target: &str| {
        let link = "#v=1&ac=own-long&cm_q=-20";
        serde_json::json!({ "link": link, "toml": own, "target": target }).to_string()
    };
    let text = |target: &str| -> String {
        let answer: Value =
            serde_json::from_str(&json::take_along(&asked(target)).expect("an answer")).expect("JSON");
        answer["text"].as_str().expect("a text").to_owned()
    };
    let page = text("page");
    assert!(page.contains("too long for one") && page.contains("modified"), "{page}");
    assert!(!page.contains("ac=own-long"), "a link that leads nowhere isn't printed");
    let again = scene(Source::Toml { file: "again.toml".to_owned(), text: text("toml") });
    let cm_q = Parameter::find("cm_q").expect("a row");
    assert_eq!(cm_q.get(&again.scenario), -20.0);
    // The same aircraft as that of the list, but for its name and remarks.
    let shipped = linked("#v=1&ac=navion&cm_q=-20");
    assert_eq!(text("modes"), taken(&shipped, Target::Modes).text);
    assert!(text("python").contains("control") && !text("python").contains("Scene: #"));
    let alone = serde_json::json!({ "link": "#v=1&ac=own-long", "target": "page" }).to_string();
    assert!(json::take_along(&alone).is_err(), "without its file nobody knows it");
}

/// The numbers of a motion as a table: those of the answers, an empty cell where there is none.
#[test]
fn the_numbers_of_a_motion_are_taken_along() {
    let scene = linked("v=1&ac=navion&lon.source=elevator&lon.shape=step&elevator=1&time=60");
    let text = taken(&scene, Target::Metrics).text;
    let report = eigenwing::export::respond(&scene, &Default::default()).expect("a motion");
    let mut lines = text.lines();
    assert!(
        lines.next().is_some_and(|head| head.starts_with("output,unit,peak,peak_time [s],beyond,steady,"))
    );
    let rows: Vec<Vec<&str>> = lines.map(|line| line.split(',').collect()).collect();
    assert_eq!(rows.len(), report.metrics.outputs.len());
    let number = |cell: &str| cell.parse::<f64>().ok();
    let mut compared = 0;
    for (row, of) in rows.iter().zip(&report.metrics.outputs) {
        assert_eq!((row[0], row[1]), (of.name, of.unit));
        let told = [
            of.peak.map(|peak| peak.value),
            of.peak.map(|peak| peak.time),
            of.beyond,
            of.steady,
            of.rise_time,
            of.settling_time,
            of.overshoot,
            of.root_mean_square,
        ];
        assert_eq!(row[2..].iter().map(|cell| number(cell)).collect::<Vec<_>>(), told);
        compared += told.iter().flatten().count();
    }
    assert!(compared > 20, "{compared}");
}

#[test]
fn a_chart_taken_along_has_the_lines_of_a_person_and_the_units_on_screen() {
    let scene = linked("v=1&ac=navion&lon.chart=static_margin&lon.over=cg&lon.lines=0.05_0.1&units=ft");
    let text = taken(&scene, Target::ChartFigure).text;
    assert_eq!(text.matches("stroke-dasharray=\"1.5 2.5\"").count(), 2);
    let csv = taken(&scene, Target::Chart).text;
    assert!(csv.starts_with("cg,static_margin,stability\n-0.3,0.45"), "{csv}");
    let over_speed = linked("v=1&ac=navion&lon.over=speed&units=ft");
    assert!(taken(&over_speed, Target::ChartFigure).text.contains("airspeed V [ft/s]"));
    let unknown = linked("v=1&ac=navion&lon.chart=nonsense");
    let refused = take_along(&unknown, "chart", &DisturbanceRequest::default()).expect_err("no such measure");
    assert_eq!(refused.to_string(), "There is no measure “nonsense” that could be charted");
}

/// What flies is taken along: the five modes and the motion under the law, beside that without it.
#[test]
fn poles_motion_and_frequency_response_are_taken_along_under_the_law() {
    let scene = linked("v=1&ac=b747-fc9&plane=lateral&k.r_dr=1.5&washout=3&actuator=0.1");
    let poles = taken(&scene, Target::Poles).text;
    assert!(poles.contains("\nwashout,-0.4") && poles.contains("\nrudder-actuator,-9.19"), "{poles}");
    let head = |scene, target| taken(scene, target).text.lines().next().unwrap_or_default().to_owned();
    let motion = head(&scene, Target::Response);
    assert!(motion.contains(",beta [rad],") && motion.contains(",beta under the law [rad],"), "{motion}");
    assert!(head(&scene, Target::Frequency).ends_with(",phase [rad] under the law"));
    assert!(taken(&scene, Target::Latex).notices.iter().any(|notice| notice.contains("without its law")));
    let alone = linked("v=1&ac=b747-fc9&plane=lateral");
    assert!(!head(&alone, Target::Response).contains("under the law"));
    assert!(taken(&alone, Target::Latex).notices.is_empty());
}
