//! A frame with round numbers on its axes, curves, and the document around it. A unit of the drawing is a point, 1/72 inch.

use maud::{Markup, PreEscaped, html};

use super::ink::{GRID, TEXT, WEAK, n};
use super::letters::{self, Align};
use crate::number::{fixed, nice_step};

/// Width of a figure: the text of an A4 page, 160 mm.
pub const WIDTH: f64 = 453.5;
/// Room for the numbers of the upward axis.
pub const LEFT: f64 = 54.0;
/// Room beside the frame on the right.
pub const RIGHT: f64 = 10.0;
/// Between one tick and the next, at least.
const APART: [f64; 2] = [55.0, 22.0];

/// How an axis is divided.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Scale {
    /// In steps of 1, 2 or 5 × 10ᵏ.
    Even,
    /// In parts of a right angle: degrees.
    Angles,
    /// By powers of ten; ends and places are logarithms to base ten.
    Decades,
}

/// An axis of a frame.
pub struct Axis {
    /// First and last value.
    pub range: (f64, f64),
    /// How it is divided.
    pub scale: Scale,
    /// What stands beside it; empty where the numbers are those of the plot below.
    pub title: String,
}

/// A frame on the figure, with its axes.
pub struct Plot {
    /// Left, top, width and height of the frame.
    pub frame: [f64; 4],
    /// Across, upward.
    pub axes: [Axis; 2],
}

/// A round number and its place.
struct Tick {
    value: f64,
    label: String,
}

impl Axis {
    fn ticks(&self, length: f64, apart: f64) -> Vec<Tick> {
        let (low, high) = self.range;
        let least = (high - low).max(f64::MIN_POSITIVE) * apart / length;
        let step = match self.scale {
            Scale::Even => nice_step(least),
            Scale::Angles => [15.0, 45.0, 90.0, 180.0, 360.0, 720.0]
                .into_iter()
                .find(|step| *step >= least)
                .unwrap_or_else(|| nice_step(least)),
            Scale::Decades => least.ceil().max(1.0),
        };
        let (first, last) = ((low / step - 1e-9).ceil(), (high / step + 1e-9).floor());
        let decimals = (-step.log10().floor()).clamp(0.0, 12.0) as usize;
        let label = |value: f64| match self.scale {
            Scale::Decades => power_of_ten(value),
            Scale::Even | Scale::Angles => fixed(value, decimals),
        };
        let values = (0..)
            .map(|k| (first + f64::from(k)) * step)
            .take_while(|value| *value <= last * step + 1e-9 * step);
        values.take(60).map(|value| Tick { value, label: label(value) }).collect()
    }
}

impl Plot {
    /// The place of a point on the figure.
    pub fn place(&self, (across, upward): (f64, f64)) -> (f64, f64) {
        let [left, top, width, height] = self.frame;
        let part = |axis: &Axis, value: f64| (value - axis.range.0) / (axis.range.1 - axis.range.0);
        (left + part(&self.axes[0], across) * width, top + (1.0 - part(&self.axes[1], upward)) * height)
    }

    /// Frame, grid, numbers and titles.
    pub fn ground(&self) -> Markup {
        let [left, top, width, height] = self.frame;
        let (right, bottom) = (left + width, top + height);
        let [across, upward] = &self.axes;
        let columns = across.ticks(width, APART[0]);
        let rows = upward.ticks(height, APART[1]);
        html! {
            g stroke=(GRID) stroke-width="0.7" {
                @for tick in &columns {
                    @let (x, _) = self.place((tick.value, upward.range.0));
                    line x1=(n(x)) x2=(n(x)) y1=(n(top)) y2=(n(bottom)) {}
                }
                @for tick in &rows {
                    @let (_, y) = self.place((across.range.0, tick.value));
                    line x1=(n(left)) x2=(n(right)) y1=(n(y)) y2=(n(y)) {}
                }
            }
            @for (axis, from, to) in [(across, (0.0, upward.range.0), (0.0, upward.range.1)), (upward, (across.range.0, 0.0), (across.range.1, 0.0))] {
                @if axis.scale != Scale::Decades && axis.range.0 < 0.0 && axis.range.1 > 0.0 {
                    @let ((x1, y1), (x2, y2)) = (self.place(from), self.place(to));
                    line x1=(n(x1)) y1=(n(y1)) x2=(n(x2)) y2=(n(y2)) stroke=(WEAK) stroke-width="0.9" {}
                }
            }
            rect x=(n(left)) y=(n(top)) width=(n(width)) height=(n(height)) fill="none" stroke=(WEAK) stroke-width="0.7" {}
            @for tick in &rows {
                @let (_, y) = self.place((across.range.0, tick.value));
                (letters::words((left - 5.0, y + 3.0), Align::End, TEXT, &tick.label))
            }
            @if !across.title.is_empty() {
                @for tick in &columns {
                    @let (x, _) = self.place((tick.value, upward.range.0));
                    (letters::words((x, bottom + 12.0), Align::Middle, TEXT, &tick.label))
                }
                (letters::words((left + 0.5 * width, bottom + 26.0), Align::Middle, TEXT, &across.title))
            }
            (letters::heading((left, top - 5.0), &upward.title))
        }
    }

    /// A curve through points, within the frame.
    pub fn curve(&self, points: impl Iterator<Item = (f64, f64)>, colour: &str, dashes: &str) -> Markup {
        let mut path = String::new();
        for point in points.filter(|(x, y)| x.is_finite() && y.is_finite()) {
            let (x, y) = self.place(point);
            // Far outside there is nothing to be seen, and a number with twenty digits.
            let y = y.clamp(-1e5, 1e5);
            path += if path.is_empty() { "M" } else { "L" };
            path += &format!("{} {}", n(x), n(y));
        }
        let [left, top, ..] = self.frame;
        html! {
            path d=(path) fill="none" stroke=(colour) stroke-width="1.4" stroke-linejoin="round"
                stroke-dasharray=[(!dashes.is_empty()).then_some(dashes)] clip-path={ "url(#frame-" (n(left)) "-" (n(top)) ")" } {}
        }
    }

    /// What keeps curves in the frame.
    pub fn clip(&self) -> Markup {
        let [left, top, width, height] = self.frame;
        html! {
            clipPath id={ "frame-" (n(left)) "-" (n(top)) } {
                rect x=(n(left)) y=(n(top)) width=(n(width)) height=(n(height)) {}
            }
        }
    }
}

/// 0.01, 1, 100; beyond that 10⁻⁶.
fn power_of_ten(exponent: f64) -> String {
    if exponent.abs() <= 3.0 {
        return 10_f64.powf(exponent).to_string();
    }
    let raised = |c: char| match c {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        '0' | '4'..='9' => char::from_u32('⁰' as u32 + c as u32 - '0' as u32).unwrap_or(c),
        c => c,
    };
    format!("10{}", format!("{exponent:.0}").chars().map(raised).collect::<String>())
}

/// A range around values, with some room, and never empty.
pub fn around(values: impl Iterator<Item = f64>) -> (f64, f64) {
    let finite = values.filter(|x| x.is_finite());
    let (low, high) = finite.fold((0.0_f64, 0.0_f64), |(low, high), x| (low.min(x), high.max(x)));
    let span = high - low;
    if span > 0.0 { (low - 0.08 * span, high + 0.08 * span) } else { (-1.0, 1.0) }
}

/// Top of the first frame: below the titles of the document and its own.
pub const TOP: f64 = 50.0;
/// Characters of a note that have room on a line.
const LINE: usize = 96;

/// Words of a text on lines.
fn lines(text: &str) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        match lines.last_mut() {
            Some(line) if line.chars().count() + word.chars().count() < LINE => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

/// The document: its title above what is drawn down to `bottom`, a note below it.
pub fn document(bottom: f64, title: &str, about: &str, note: &str, drawn: &Markup) -> String {
    let millimetres = |points: f64| format!("{}mm", n(points / 72.0 * 25.4));
    let notes = lines(note);
    let height = bottom + 12.0 * notes.len() as f64 + 6.0;
    let svg = html! {
        (PreEscaped("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"))
        svg xmlns="http://www.w3.org/2000/svg" width=(millimetres(WIDTH)) height=(millimetres(height))
            viewBox={ "0 0 " (n(WIDTH)) " " (n(height)) } role="img" aria-label={ (title) ". " (about) ". " (note) } {
            title { (title) }
            rect width="100%" height="100%" fill="#ffffff" {}
            (letters::title((LEFT, 14.0), title))
            (letters::words((LEFT, 27.0), Align::Start, WEAK, about))
            (drawn)
            @for (k, line) in notes.iter().enumerate() {
                (letters::words((LEFT, bottom + 8.0 + 12.0 * k as f64), Align::Start, WEAK, line))
            }
        }
    };
    svg.into_string() + "\n"
}
