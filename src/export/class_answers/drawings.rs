//! Estimates, places and sketches of a class, drawn over each other beside what the model says.

use std::fmt::Write as _;
use std::rc::Rc;

use maud::{Markup, html};

use crate::findings::measures::Measure;
use crate::lesson::{Answer, Model, Place, Truth};
use crate::number::significant;
use crate::scenario::Convention;
use crate::words;

/// An answer with whose it is, and the model with that person's numbers.
pub(super) struct One<'a> {
    /// Who answered.
    pub name: &'a str,
    /// What they answered.
    pub answer: &'a Answer,
    /// What it is compared with.
    pub model: Rc<Model>,
}

/// Width and height of a drawing, in units of its own.
const WIDTH: f64 = 800.0;
const HEIGHT: f64 = 320.0;
/// Room at its edges.
const EDGE: f64 = 40.0;

/// A strip of marks by the factor over the model's number, from a tenth to ten times.
pub(super) fn estimates(
    names: bool,
    measure: Measure,
    place: Place,
    answered: &[One<'_>],
    varies: bool,
) -> Markup {
    let x = |factor: f64| WIDTH / 2.0 + (WIDTH / 2.0 - EDGE) * factor.log10().clamp(-1.0, 1.0);
    let mut marks: Vec<(f64, &str)> = Vec::new();
    let mut others = 0;
    let mut told = None;
    for one in answered {
        let (Answer::Number(said), Some(Truth::Number { found, .. })) = (one.answer, one.model.truth(place))
        else {
            continue;
        };
        let convention =
            one.model.start(place.step).map_or(Convention::SI, |start| start.scenario().convention());
        told.get_or_insert((*found, convention));
        let factor = said / found;
        if factor.is_finite() && factor > 0.0 { marks.push((x(factor), one.name)) } else { others += 1 }
    }
    let Some((found, convention)) = told else { return html! {} };
    let tick = |factor: f64, name: &str| {
        if varies { name.to_owned() } else { words::measure::value(measure, factor * found, convention) }
    };
    let ticks = [(0.1, "a tenth"), (1.0 / 3.0, "a third"), (1.0, "the model"), (3.0, "3 ×"), (10.0, "10 ×")];
    html! {
        svg viewBox=(format!("0 0 {WIDTH} 110")) role="img" {
            title { "Each answer as a mark, by its factor over the model’s number" }
            path class="axis" d=(format!("M{EDGE} 60H{}", WIDTH - EDGE)) {}
            path class="model" d=(format!("M{} 30V70", WIDTH / 2.0)) {}
            @for (factor, name) in ticks {
                text x=(x(factor)) y="95" text-anchor="middle" { (tick(factor, name)) }
            }
            @for (x, name) in &marks {
                circle class="one" cx=(format!("{x:.1}")) cy="50" r="7" { @if names { title { (name) } } }
            }
        }
        @if others > 0 { p class="weak" { (others) " of the other sign, or zero" } }
    }
}

/// A small map of poles.
pub(super) fn places(names: bool, place: Place, answered: &[One<'_>]) -> Markup {
    let placed = |one: &One<'_>| match one.answer {
        Answer::Place { real, imaginary } => Some((*real, imaginary.abs())),
        _ => None,
    };
    let poles: Vec<(f64, f64)> = answered
        .iter()
        .filter_map(|one| match one.model.truth(place) {
            Some(Truth::Pole(pole)) => Some((pole.re, pole.im.abs())),
            _ => None,
        })
        .collect();
    let Some(model) = poles.first() else { return html! {} };
    // Whoever is far off doesn't make the others small.
    let reach = 3.0 * model.0.hypot(model.1).max(1e-9);
    let all = answered.iter().filter_map(placed).chain(poles.iter().copied());
    let (mut side, mut up) = (1e-9_f64, 1e-9_f64);
    for (re, im) in all {
        side = side.max(re.abs().min(reach));
        up = up.max(im.min(reach));
    }
    let scale = ((WIDTH / 2.0 - EDGE) / side).min((HEIGHT - 2.0 * EDGE) / up);
    let at = |(re, im): (f64, f64)| {
        (WIDTH / 2.0 + scale * re.clamp(-reach, reach), HEIGHT - EDGE - scale * im.min(reach))
    };
    let mut crosses: Vec<(f64, f64)> = poles.iter().map(|pole| at(*pole)).collect();
    crosses.dedup();
    html! {
        svg viewBox=(format!("0 0 {WIDTH} {HEIGHT}")) role="img" {
            title { "Each answer as a mark, the model’s pole as a cross" }
            path class="axis" d=(format!("M{EDGE} {0}H{1}M{2} {EDGE}V{0}", HEIGHT - EDGE, WIDTH - EDGE, WIDTH / 2.0)) {}
            text x=(WIDTH - EDGE) y=(HEIGHT - EDGE + 20.0) text-anchor="end" { "unstable" }
            text x=(EDGE) y=(HEIGHT - EDGE + 20.0) { "stable" }
            text x=(WIDTH / 2.0 + 6.0) y=(EDGE + 4.0) { (significant(up, 2)) " rad/s" }
            @for one in answered {
                @if let Some((x, y)) = placed(one).map(at) {
                    circle class="one" cx=(format!("{x:.1}")) cy=(format!("{y:.1}")) r="7" { @if names { title { (one.name) } } }
                }
            }
            @for (x, y) in &crosses {
                path class="model" d=(format!("M{:.1} {:.1}l16 16m0 -16l-16 16", x - 8.0, y - 8.0)) {}
            }
        }
    }
}

/// All sketches over each other, with the model's curve.
pub(super) fn sketches(names: bool, place: Place, answered: &[One<'_>], varies: bool) -> Markup {
    // With numbers of one's own each stands by the height of its own curve.
    let curve = |one: &One<'_>| match one.model.truth(place) {
        Some(Truth::Curve { values, .. }) => Some(values.clone()),
        _ => None,
    };
    let Some(model) = answered.iter().find_map(curve) else { return html! {} };
    let peak = |values: &[f64]| values.iter().fold(1e-12_f64, |most, value| most.max(value.abs()));
    let path = |values: &[f64], of: f64| {
        let last = values.len().saturating_sub(1).max(1) as f64;
        let mut path = String::new();
        for (number, value) in values.iter().enumerate() {
            let x = EDGE + (WIDTH - 2.0 * EDGE) * number as f64 / last;
            // The pad on which it was drawn reaches a little beyond the model's curve.
            let y = HEIGHT / 2.0 - (HEIGHT / 2.0 - EDGE / 2.0) * (value / of / 1.5).clamp(-1.0, 1.0);
            let _ = write!(path, "{}{x:.1} {y:.1}", if number == 0 { "M" } else { "L" });
        }
        path
    };
    html! {
        svg viewBox=(format!("0 0 {WIDTH} {HEIGHT}")) role="img" {
            title { "Every sketch, and the model’s curve, thick" }
            path class="axis" d=(format!("M{EDGE} {0}H{1}M{EDGE} 10V{2}", HEIGHT / 2.0, WIDTH - EDGE, HEIGHT - 10.0)) {}
            @for one in answered {
                @if let Answer::Sketch(values) = one.answer {
                    path class="one" d=(path(values, curve(one).map_or(1.0, |own| peak(&own)))) { @if names { title { (one.name) } } }
                }
            }
            path class="model" d=(path(&model, peak(&model))) {}
            text x=(WIDTH - EDGE) y=(HEIGHT / 2.0 + 18.0) text-anchor="end" { "time" }
        }
        @if varies { p class="weak" { "Everybody had numbers of their own: each sketch is drawn by the height of its own curve." } }
    }
}
