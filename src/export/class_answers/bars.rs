//! How many chose what, as bars.

use maud::{Markup, html};

/// One of the things that were chosen.
pub(super) struct Bar<'a> {
    /// What it says.
    pub says: String,
    /// Whether it is right.
    pub is_right: bool,
    /// Why it isn't.
    pub because: Option<String>,
    /// Who chose it.
    pub names: Vec<&'a str>,
}

/// The bars, each as long as its share of all that answered.
pub(super) fn bars(names: bool, all: usize, bars: Vec<Bar<'_>>) -> Markup {
    html! {
        @for bar in &bars {
            @let share = 100.0 * bar.names.len() as f64 / all.max(1) as f64;
            div class="bar" {
                span class=[bar.is_right.then_some("good")] { (if bar.is_right { "✓ " } else { "" }) (bar.says) }
                i class=[bar.is_right.then_some("good")] style=(format!("width:{share:.1}%")) {}
                span { (bar.names.len()) }
                @if let Some(because) = bar.because.as_ref().filter(|_| !bar.names.is_empty()) { p class="weak" { (because) } }
                @if names && !bar.names.is_empty() { p class="weak" { (bar.names.join(", ")) } }
            }
        }
    }
}
