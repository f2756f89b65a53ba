//! The pole map.

use maud::html;

use super::ink::{COLOURS, WEAK, n};
use super::letters::{self, Align};
use super::plot::{Axis, LEFT, Plot, RIGHT, Scale, TOP, WIDTH, document};
use crate::export::scene::Scene;
use crate::findings::Findings;
use crate::flight::analysis::PlaneAnalysis;
use crate::flight::modes::mode::Mode;
use crate::number::eigenvalue;
use crate::words;

/// Height of the frame.
const HEIGHT: f64 = 260.0;

/// Every eigenvalue of the plane on screen as it flies as a cross with its mode's name, those of the pinned state as rings, those of the
/// loop in its other state as squares.
pub fn poles(scene: &Scene, findings: &Findings, plane: &PlaneAnalysis) -> String {
    let pinned = scene.pinned.clone().map(Findings::of);
    let before: &[Mode] = pinned.as_ref().map_or(&[], Findings::flown_modes);
    let other = findings.poles_of_other();
    let all = || plane.modes.iter().chain(before).chain(other.iter().copied()).map(|mode| mode.lambda);
    let (low, high) = all().fold((0.0_f64, 0.0_f64), |(low, high), z| (low.min(z.re), high.max(z.re)));
    let span = (high - low).max(1e-6);
    let reach = all().fold(0.0_f64, |most, z| most.max(z.im.abs())).max(0.15 * span) * 1.2;
    let map = Plot {
        frame: [LEFT, TOP, WIDTH - LEFT - RIGHT, HEIGHT],
        axes: [
            Axis {
                range: (low - 0.1 * span, high + 0.2 * span),
                scale: Scale::Even,
                title: "Re λ [1/s]".to_owned(),
            },
            Axis { range: (-reach, reach), scale: Scale::Even, title: "Im λ [rad/s]".to_owned() },
        ],
    };
    let places = |mode: &Mode| {
        let both = if mode.is_oscillatory() { vec![mode.lambda.im, -mode.lambda.im] } else { vec![0.0] };
        both.into_iter().map(|im| map.place((mode.lambda.re, im))).collect::<Vec<_>>()
    };
    let drawn = html! {
        (map.ground())
        @for mode in before {
            @for (x, y) in places(mode) {
                circle cx=(n(x)) cy=(n(y)) r="4" fill="none" stroke=(WEAK) stroke-width="1.2" {}
            }
        }
        @for mode in &other {
            @for (x, y) in places(mode) {
                rect x=(n(x - 3.5)) y=(n(y - 3.5)) width="7" height="7" fill="none" stroke=(WEAK) stroke-width="1.2" {}
            }
        }
        @for (k, mode) in plane.modes.iter().enumerate() {
            @let colour = COLOURS[k % COLOURS.len()];
            @for (x, y) in places(mode) {
                path d={ "M" (n(x - 4.0)) " " (n(y - 4.0)) "l8 8m0 -8l-8 8" } fill="none" stroke=(colour) stroke-width="2" {}
            }
            @let (x, y) = map.place((mode.lambda.re, mode.lambda.im));
            // Names of real roots stand in turn above and below the axis: two of them may be near each other.
            @let below = !mode.is_oscillatory() && k % 2 == 1;
            @let near_right = x > WIDTH - 110.0;
            @let (x, align) = if near_right { (x - 8.0, Align::End) } else { (x + 8.0, Align::Start) };
            @let name = format!("{} {}", words::mode::title(mode.naming.name), eigenvalue(mode.lambda));
            (letters::words((x, if below { y + 16.0 } else { y - 7.0 }), align, colour, &name))
        }
    };
    let aircraft = &findings.scenario().aircraft;
    let plane = words::view::plane(findings.scenario().plane);
    let [shown, of_other] = words::feedback::legend(findings.is_opened(), findings.is_fed_back());
    let (about, squares) = if other.is_empty() {
        (format!("{plane} motion, eigenvalues of A"), String::new())
    } else {
        (format!("{plane} motion, eigenvalues {shown}"), format!("Squares: {of_other}."))
    };
    let rings = if before.is_empty() { "" } else { "Rings: the pinned state." };
    let note = format!("{squares} {rings}");
    document(
        TOP + HEIGHT + 32.0,
        &format!("{}: {}", aircraft.name, aircraft.condition),
        &about,
        note.trim(),
        &drawn,
    )
}
