//! Answers compared with the model, and goals with the way to them.

use std::sync::Arc;

use eigenwing::content::{Aircraft, embedded_aircraft};
use eigenwing::findings::Findings;
use eigenwing::lesson::{
    Answer, Answers, Comparison, Direction, End, Estimated, Features, Lesson, Place, PlaceCompared, Scene,
    progress,
};
use nalgebra::Complex;
use proptest::prelude::*;

fn aircraft() -> Vec<Arc<Aircraft>> {
    embedded_aircraft().0.into_iter().map(Arc::new).collect()
}

fn findings(link: &str) -> Findings {
    let scene = Scene { link: link.to_owned(), line: 1 };
    Findings::of(scene.open(&aircraft()).expect("an aircraft").scenario)
}

#[test]
fn an_estimate_is_judged_by_its_factor_and_its_way() {
    for (answer, before, compared) in [
        (10.5, None, Estimated::Near),
        (20.0, None, Estimated::RightOrder),
        (100.0, None, Estimated::Far),
        (-10.0, None, Estimated::WrongWay),
        (4.0, Some(5.0), Estimated::WrongWay),
        (7.0, Some(5.0), Estimated::RightOrder),
    ] {
        assert_eq!(Comparison::of_number(answer, 10.0, before), Comparison::Number(compared), "{answer}");
    }
}

#[test]
fn a_place_is_judged_by_its_distance_and_its_side_and_either_of_a_pair_is_meant() {
    let pole = Complex::new(-3.0, 4.0);
    for (re, im, compared) in [
        (-3.0, -4.2, PlaceCompared::Near),
        (-3.0, 3.0, PlaceCompared::RightRegion),
        (-30.0, 4.0, PlaceCompared::Far),
        (3.0, 4.0, PlaceCompared::WrongSide),
    ] {
        assert_eq!(
            Comparison::of_place(Complex::new(re, im), pole),
            Comparison::Place(compared),
            "{re} {im}"
        );
    }
}

fn curve(of: impl Fn(f64) -> f64) -> Vec<f64> {
    (0..400).map(|step| of(f64::from(step) / 20.0)).collect()
}

#[test]
fn a_sketch_is_judged_by_what_matters_and_not_by_its_scale() {
    let swing = |size: f64, pace: f64| curve(move |t| size * (pace * t).sin() * (-0.2 * t).exp());
    let settles = Features::of(&swing(1.0, 2.0));
    assert_eq!((settles.first, settles.ends), (Direction::Up, End::Back));
    assert!(settles.oscillates());
    assert!(Comparison::of_sketch(&swing(7.0, 2.2), &swing(1.0, 2.0)).is_right());
    let (down, rises) = (swing(-1.0, 2.0), curve(|t| 1.0 - (-t).exp()));
    let compared = |answer: &[f64]| Comparison::of_sketch(answer, &swing(1.0, 2.0));
    assert_eq!(compared(&down), Comparison::Sketch { first: false, swings: true, ends: true });
    assert_eq!(compared(&rises), Comparison::Sketch { first: true, swings: false, ends: false });
    let grows = Features::of(&curve(|t| (2.0 * t).sin() * (0.1 * t).exp()));
    assert!(grows.oscillates());
    for none in [&[][..], &[f64::NAN], &[1.0, 1.0]] {
        assert_eq!(Features::of(none).first, Direction::None);
    }
}

#[test]
fn an_order_is_judged_place_by_place() {
    let right = |answer: &[usize]| Comparison::of_order(answer, &[30.0, 10.0, 20.0]);
    assert_eq!(right(&[1, 2, 0]), Comparison::Order(vec![true, true, true]));
    assert_eq!(right(&[1, 0, 2]), Comparison::Order(vec![true, false, false]));
    assert!(!right(&[]).is_right());
}

#[test]
fn a_goal_comes_nearer_and_is_met_by_as_few_changes_as_are_allowed() {
    let text = "+++\ntitle = \"t\"\n+++\n## s\n```scene\nlink = \"#v=1&ac=navion\"\n```\n```task\ngoal = \"g\"\nchanges_at_most = 1\n\
        [[until]]\nmeasure = \"short_period.imaginary_part\"\nat_least = \"1.5 × start\"\n```\n";
    let lesson = Lesson::read("t.md", text).expect("a lesson");
    let task = lesson.steps[0].tasks().next().expect("a task");
    let start = findings("#v=1&ac=navion");
    let share = |link: &str| progress(task, &start, &findings(link), &aircraft())[0].share;
    assert_eq!(share("#v=1&ac=navion"), 0.0);
    let (some, more) = (share("#v=1&ac=navion&cm_alpha=-0.8"), share("#v=1&ac=navion&cm_alpha=-1.0"));
    assert!(0.0 < some && some < more && more < 1.0, "{some} {more}");
    let is_met = |link: &str| task.is_met(&start, &findings(link), &aircraft());
    assert!(is_met("#v=1&ac=navion&cm_alpha=-2"));
    assert!(!is_met("#v=1&ac=navion&cm_alpha=-2&cd=0.06"), "two changes");
}

const ASKED: &str = "+++\ntitle = \"t\"\n+++\n## s\n```scene\nlink = \"#v=1&ac=navion\"\n```\n```predict\nkind = \"choose\"\n\
    ask = \"?\"\n[[choice]]\nsays = \"a\"\nbecause = \"b\"\n[[choice]]\nsays = \"c\"\nright = true\n```\n\
    ```write\nask = \"Explain it.\"\n```\n```task\ngoal = \"g\"\nhints = [\"h\"]\n[[until]]\n\
    measure = \"short_period.imaginary_part\"\nat_least = \"1.5 × start\"\n```\n";

/// As files of reports have it: once written, read for ever.
#[test]
fn what_was_given_is_kept_as_json_and_what_no_longer_fits_the_lesson_is_left_out() {
    let kept = r#"{"1.1":{"answer":{"chosen":[0]},"final":true,"hints":0,"tries":0,"solution_shown":false,"reached":false},"1.2":{"answer":{"text":"The tail."},"final":false,"hints":0,"tries":0,"solution_shown":false,"reached":false},"1.3":{"final":false,"hints":1,"tries":2,"solution_shown":false,"reached":true}}"#;
    let answers: Answers = serde_json::from_str(kept).expect("answers");
    assert_eq!(serde_json::to_string(&answers).expect("JSON"), kept);
    let lesson = Lesson::read("t.md", ASKED).expect("a lesson");
    assert_eq!(answers.clone().fitting(&lesson), answers);
    assert!(answers.get(Place { step: 0, part: 2 }).is_some_and(|given| given.is_unaided()));
    for (other, left) in [
        (r#"{"1.1":{"answer":{"chosen":[2]}}}"#, 0),
        (r#"{"1.1":{"answer":{"number":2.5}}}"#, 0),
        (r#"{"1.1":{"answer":{"chosen":[0,1]}}}"#, 0),
        (r#"{"1.1":{"answer":"dont_know","final":true}}"#, 1),
        (r#"{"1.2":{"answer":{"chosen":[0]}}}"#, 0),
        (r#"{"9.1":{"hints":1}}"#, 0),
        (r#"{"1.3":{"hints":99}}"#, 1),
    ] {
        let answers: Answers = serde_json::from_str(other).expect("answers");
        assert_eq!(answers.fitting(&lesson).iter().count(), left, "{other}");
    }
    for damaged in [r#"{"0.1":{}}"#, r#"{"1":{}}"#, r#"{"1.1":{"answer":{"number":null}}}"#, "[]", ""] {
        assert!(serde_json::from_str::<Answers>(damaged).is_err(), "{damaged}");
    }
}

#[test]
fn the_model_says_what_a_question_is_compared_with() {
    let ask = |block: &str| {
        let text = format!(
            "+++\ntitle = \"t\"\n+++\n## s\n```scene\nlink = \"#v=1&ac=navion\"\n```\n```predict\nask = \"?\"\n{block}\n```\n"
        );
        let lesson = Lesson::read("t.md", &text).expect("a lesson");
        lesson.steps[0].predictions().next().expect("a question").clone()
    };
    let start = findings("#v=1&ac=navion");
    let compare = |block: &str, answer: Answer| {
        let question = ask(block);
        let truth = question.truth(&start, &aircraft()).expect("a truth");
        assert!(answer.fits(&question.kind));
        truth.compare(&question.kind, &answer)
    };
    let place = "kind = \"place\"\nmode = \"short-period\"\nwrong_side = \"w\"\nfar = \"f\"";
    // Nelson: −2.51 ± 2.59i.
    let near = Answer::Place { real: -2.5, imaginary: -2.6 };
    assert!(compare(place, near).is_right());
    let sketch = "kind = \"sketch\"\noutput = \"theta\"\nfirst = \"a\"\noscillates = \"b\"\nends = \"c\"";
    let flat = compare(sketch, Answer::Sketch(vec![0.0; 40]));
    assert!(matches!(flat, Comparison::Sketch { first: false, .. }), "{flat:?}");
    let estimate = "kind = \"estimate\"\nmeasure = \"short_period.period\"\nwrong_way = \"w\"\nfar = \"f\"";
    assert_eq!(compare(estimate, Answer::Number(2.42)), Comparison::Number(Estimated::Near));
    assert_eq!(compare(estimate, Answer::DontKnow), Comparison::DontKnow);
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_text_is_answers_or_an_error(text in r#"(\{"[0-9]{1,2}\.[0-9]{1,20}":\{("answer":("dont_know"|\{"(chosen|sketch|order)":\[[0-9,]{0,5}\]\}))?\}\}|.*)"#) {
        if let Ok(answers) = serde_json::from_str::<Answers>(&text) {
            let lesson = Lesson::read("t.md", ASKED).expect("a lesson");
            let fitting = answers.fitting(&lesson);
            prop_assert_eq!(fitting.clone().fitting(&lesson), fitting);
        }
    }
}
