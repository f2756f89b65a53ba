//! Words as outlines, so that a figure looks the same wherever it is, whatever fonts are there. Their text stays beside each as its label.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::sync::LazyLock;

use maud::{Markup, html};

use super::ink::{TEXT, n};

/// A line a letter: itself, its advance and its outline, in thousandths of its size, with tabs between them; `assets/fonts/outlines.py`
/// writes them.
const OUTLINES: &str = include_str!("../../../assets/fonts/outlines.txt");
/// Stands above the letter before it.
const DOT_ABOVE: char = '\u{307}';
/// Size of all words but those of a title, in units of the drawing.
const SIZE: f64 = 9.0;
/// How much wider the stems of headings are, and the room between their letters, in thousandths of their size: those of Inter SemiBold.
const BOLD: (u32, f64) = (38, 14.0);

static LETTERS: LazyLock<BTreeMap<&str, Letter>> = LazyLock::new(|| {
    let letter = |line: &'static str| {
        let mut parts = line.splitn(3, '\t');
        let (letter, advance, outline) = (parts.next()?, parts.next()?.parse().ok()?, parts.next()?);
        Some((letter, Letter { advance, outline }))
    };
    OUTLINES.lines().filter_map(letter).collect()
});

/// A letter, in thousandths of its size.
struct Letter {
    /// From its place to that of the next.
    advance: f64,
    /// Commands of a path, relative to its place.
    outline: &'static str,
}

/// Which part of the words stands at their place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Align {
    /// Their beginning.
    Start,
    /// Their middle.
    Middle,
    /// Their end.
    End,
}

/// Words in a colour, their baseline at a place.
pub fn words(place: (f64, f64), align: Align, colour: &str, words: &str) -> Markup {
    set(place, align, (SIZE, false), colour, words)
}

/// The title of a frame.
pub fn heading(place: (f64, f64), words: &str) -> Markup {
    set(place, Align::Start, (SIZE, true), TEXT, words)
}

/// The title of the figure.
pub fn title(place: (f64, f64), words: &str) -> Markup {
    set(place, Align::Start, (10.5, true), TEXT, words)
}

fn set((x, y): (f64, f64), align: Align, (size, is_bold): (f64, bool), colour: &str, words: &str) -> Markup {
    let (share, anchor) = match align {
        Align::Start => (0.0, "start"),
        Align::Middle => (0.5, "middle"),
        Align::End => (1.0, "end"),
    };
    let Some((outline, width)) = outline(words, if is_bold { BOLD.1 } else { 0.0 }) else {
        return html! {
            text x=(n(x)) y=(n(y)) text-anchor=(anchor) fill=(colour) font-family="sans-serif" font-size=(size)
                font-weight=[is_bold.then_some("600")] { (words) }
        };
    };
    let scale = size / 1000.0;
    html! {
        path transform={ "translate(" (n(x - share * scale * width)) " " (n(y)) ") scale(" (scale) ")" } fill=(colour)
            stroke=[is_bold.then_some(colour)] stroke-width=[is_bold.then_some(BOLD.0)] aria-label=(words) d=(outline) {}
    }
}

/// The outline of words and their width; `None` where a letter has none.
fn outline(words: &str, between: f64) -> Option<(String, f64)> {
    let (mut path, mut width) = (String::new(), 0.0);
    for letter in letters(words) {
        let Letter { advance, outline } = LETTERS.get(letter)?;
        if !outline.is_empty() {
            let _ = write!(path, "M{width} 0{outline}");
        }
        width += advance + between;
    }
    Some((path, width))
}

/// The letters of words: a character each, with the dot above it where it has one.
fn letters(words: &str) -> impl Iterator<Item = &str> {
    let mut rest = words;
    std::iter::from_fn(move || {
        let mut places = rest.char_indices().skip(1).skip_while(|(_, c)| *c == DOT_ABOVE);
        let end = places.next().map_or(rest.len(), |(end, _)| end);
        let (letter, after) = rest.split_at(end);
        rest = after;
        (!letter.is_empty()).then_some(letter)
    })
}

/// What of a figure's words has no outline, for which these words stay text.
pub fn without_outline(figure: &str) -> Vec<&str> {
    let texts =
        figure.split("<text").skip(1).filter_map(|rest| rest.split_once('>')?.1.split_once("</text>"));
    let mut all: Vec<&str> = texts.flat_map(|(words, _)| letters(words)).collect();
    all.retain(|letter| !LETTERS.contains_key(*letter));
    all.sort_unstable();
    all.dedup();
    all
}

#[cfg(test)]
mod tests {
    use super::{Align, LETTERS, OUTLINES, letters, outline, without_outline, words};

    #[test]
    fn every_line_of_the_outlines_is_a_letter_whose_path_begins_and_ends() {
        assert_eq!(LETTERS.len(), OUTLINES.lines().count());
        let mut drawn = 0;
        for (letter, of) in LETTERS.iter() {
            assert!(of.advance > 0.0, "{letter}");
            if of.outline.is_empty() {
                assert!(letter.chars().all(char::is_whitespace), "{letter:?} is drawn");
                continue;
            }
            assert!(of.outline.starts_with('m') && of.outline.ends_with('z'), "{letter}");
            assert_eq!(of.outline.matches('m').count(), of.outline.matches('z').count(), "{letter}");
            assert!(of.outline.chars().all(|c| "mlhvqz-0123456789 ".contains(c)), "{letter}");
            drawn += 1;
        }
        assert!(drawn > 300, "{drawn}");
    }

    #[test]
    fn a_dot_belongs_to_the_letter_before_it() {
        assert_eq!(letters("Z_α\u{307}/V").collect::<Vec<_>>(), ["Z", "_", "α\u{307}", "/", "V"]);
        assert_eq!(letters("").count(), 0);
        let (plain, dotted) =
            (outline("α", 0.0).expect("a letter"), outline("α\u{307}", 0.0).expect("a letter"));
        assert!(dotted.0.len() > plain.0.len() && dotted.1 == plain.1);
    }

    #[test]
    fn words_stand_at_their_place_by_beginning_middle_or_end() {
        let (_, width) = outline("0.05", 0.0).expect("figures");
        let start = |align| {
            let text = words((100.0, 7.0), align, "#000000", "0.05").into_string();
            let (_, rest) = text.split_once("translate(").expect("a place");
            rest.split_once(' ').expect("two numbers").0.parse::<f64>().expect("a number")
        };
        for (align, share) in [(Align::Start, 0.0), (Align::Middle, 0.5), (Align::End, 1.0)] {
            assert!((start(align) - (100.0 - share * 0.009 * width)).abs() < 0.006, "{align:?}");
        }
    }

    #[test]
    fn words_of_which_a_letter_has_no_outline_stay_text_as_a_whole() {
        let text = words((0.0, 0.0), Align::Start, "#000000", "Як-18 & others").into_string();
        assert!(text.contains(">Як-18 &amp; others</text>") && !text.contains("<path"), "{text}");
        assert_eq!(without_outline(&text), ["Я", "к"]);
        let outlined = words((0.0, 0.0), Align::Start, "#000000", "F-16 & others").into_string();
        assert!(outlined.contains("aria-label=\"F-16 &amp; others\"") && !outlined.contains("<text"));
    }
}
