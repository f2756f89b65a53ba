//! A page of HTML with nothing outside it: reports, the answers of a class, the page of paper.

use maud::{DOCTYPE, Markup, PreEscaped, html};

/// A document in a language (`en`), with its title as its first heading and a style sheet of its own.
pub(super) fn document(title: &str, language: &str, style: &str, body: &Markup) -> String {
    let page = html! {
        (DOCTYPE)
        html lang=(language) {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width";
                title { (title) }
                style { (PreEscaped(style)) }
            }
            body {
                h1 { (title) }
                (body)
            }
        }
    };
    page.into_string()
}
