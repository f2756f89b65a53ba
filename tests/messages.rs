//! Messages between the page in a frame and the page around it.

use eigenwing::export::{Event, Message, Request, Spot};
use eigenwing::lesson::{Answer, Records};
use eigenwing::scenario::view::Look;
use serde_json::{Value, json};

fn read(message: &Value) -> Option<Result<Request, String>> {
    Request::read(&message.to_string())
}

#[test]
fn every_request_is_read() {
    for (message, request) in [
        (
            json!({"eigenwing": 1, "type": "open", "link": "#v=1&ac=navion"}),
            Request::Open("#v=1&ac=navion".into()),
        ),
        (json!({"eigenwing": 1, "type": "look", "look": "dark"}), Request::Look(Some(Look::Dark))),
        (json!({"eigenwing": 1, "type": "look", "look": "system"}), Request::Look(None)),
        (json!({"eigenwing": 1, "type": "ask-report"}), Request::AskReport),
        (
            json!({"eigenwing": 1, "type": "take-up", "records": {"person": "", "lessons": {}}}),
            Request::TakeUp(Box::default()),
        ),
    ] {
        assert_eq!(read(&message), Some(Ok(request)), "{message}");
    }
}

#[test]
fn a_damaged_request_is_answered_by_one_sentence_and_what_is_of_others_by_none() {
    for message in [
        json!({"eigenwing": 2, "type": "open", "link": ""}),
        json!({"eigenwing": "1", "type": "open", "link": ""}),
        json!({"eigenwing": 1}),
        json!({"eigenwing": 1, "type": 3}),
        json!({"eigenwing": 1, "type": "opne", "link": ""}),
        json!({"eigenwing": 1, "type": "xyz"}),
        json!({"eigenwing": 1, "type": "open"}),
        json!({"eigenwing": 1, "type": "look", "look": "pink"}),
        json!({"eigenwing": 1, "type": "take-up"}),
        json!({"eigenwing": 1, "type": "take-up", "records": {"lessons": 5}}),
    ] {
        let Some(Err(sentence)) = read(&message) else { panic!("{message} is damaged") };
        assert!(sentence.ends_with(['.', '?']) && !sentence.contains('\n'), "{sentence}");
    }
    let Some(Err(sentence)) = read(&json!({"eigenwing": 1, "type": "opne"})) else { panic!("it is damaged") };
    assert!(sentence.contains("open"), "{sentence}");
    for message in [json!(null), json!("eigenwing"), json!([1]), json!({"type": "open", "link": ""})] {
        assert_eq!(read(&message), None, "{message}");
    }
    assert_eq!(Request::read("no JSON"), None);
}

#[test]
fn a_message_has_its_version_and_its_kind() {
    let at = || Spot { lesson: "longitudinal".into(), step: 2, steps: 9, done: 1 };
    let json = |event| serde_json::from_str::<Value>(&Message::new(event).to_json()).expect("JSON");
    let answered = Event::Answered { at: at(), part: 3, answer: Answer::Chosen(vec![1]), right: Some(true) };
    assert_eq!(
        json(answered),
        json!({"eigenwing": 1, "type": "answered", "lesson": "longitudinal", "step": 2, "steps": 9, "done": 1,
            "part": 3, "answer": {"chosen": [1]}, "right": true})
    );
    let reached = Event::GoalReached { at: at(), part: 1, unaided: true, link: "v=1".into() };
    assert_eq!(
        json(reached),
        json!({"eigenwing": 1, "type": "goal-reached", "lesson": "longitudinal", "step": 2, "steps": 9, "done": 1,
            "part": 1, "unaided": true, "link": "v=1"})
    );
    let report = json(Event::Report { records: Records::default() });
    assert_eq!(report["type"], "report");
    assert!(report["records"]["lessons"].is_object());
    assert_eq!(
        json(Event::Height { height: 480.0 }),
        json!({"eigenwing": 1, "type": "height", "height": 480.0})
    );
}
