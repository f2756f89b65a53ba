//! Symbols typeset: `C_mα` with an italic C and a lowered mα.
//!
//! The notation is what one would type in mail or TeX:
//!
//! | written | set as |
//! |---|---|
//! | letters, Greek or Latin | italic |
//! | figures, operators, brackets | upright |
//! | [words](WORDS) that stand alone | upright |
//! | `_mα`, `_{L max}` | the letters and figures that follow, or what braces hold, lowered and smaller |
//! | `^2`, `^{−1}` | the same, raised |
//! | `-` | − |
//! | a letter and U+0307, such as `α̇` | the letter with a dot above |

use std::sync::Arc;

use egui::accesskit::Role;
use egui::text::{LayoutJob, TextFormat};
use egui::{Align, Color32, FontId, Galley, Response, Sense, Ui, Vec2, WidgetInfo};

use super::{fonts, theme};

/// Set upright, when they stand between what aren't Latin letters.
const WORDS: [&str; 18] = [
    "cos", "sin", "tan", "exp", "ln", "log", "max", "min", "ref", "trim", "Re", "Im", "det", "deg", "for",
    "to", "sample", "size",
];

const DOT_ABOVE: char = '\u{307}';

// In sizes of the base.
const SCRIPT_SIZE: f32 = 0.7;
const SUBSCRIPT_DROP: f32 = 0.17;
const SUPERSCRIPT_RISE: f32 = 0.36;
/// Room that a line of the faces in [`fonts`] needs above and below its baseline.
const ASCENT: f32 = 0.969;
const DESCENT: f32 = 0.241;

/// What a symbol may be wider than its place: a slider begins with a margin of its own \[points\].
const OVERHANG: f32 = 8.0;

/// A symbol or a short formula in the notation of this module.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Symbol<'a>(&'a str);

/// A sentence with its symbols typeset: every word such as `C_mα` or `X_w`, and nothing else of it.
pub fn prose(text: &str, font: FontId, color: Color32) -> LayoutJob {
    let mut job = LayoutJob::default();
    let mut rest = text;
    while let Some(mark) = rest.find('_') {
        let is_letter = |c: &char| c.is_alphabetic() || matches!(*c, DOT_ABOVE | '′');
        let base: usize = rest[..mark].chars().rev().take_while(is_letter).map(char::len_utf8).sum();
        let (script, after) = script(&rest[mark + 1..]);
        let end = rest.len() - after.len();
        // A longer word is a name, such as that of a file's entry.
        let of_symbol = (1..=2).contains(&rest[mark - base..mark].chars().count()) && !script.is_empty();
        let plain = if of_symbol { mark - base } else { end };
        job.append(&rest[..plain], 0.0, TextFormat::simple(font.clone(), color));
        if of_symbol {
            // Letters of the maths face are smaller than those of the text.
            Symbol(&rest[plain..end]).append_to(&mut job, 1.15 * font.size, color);
        }
        rest = after;
    }
    job.append(rest, 0.0, TextFormat::simple(font, color));
    job
}

/// Draws a symbol beside text and controls of a row: on their middle, in its own width or a given one, in which it is smaller where it
/// has no room otherwise.
pub fn symbol_ui(
    ui: &mut Ui,
    symbol: &Symbol<'_>,
    size: f32,
    color: Color32,
    width: Option<f32>,
) -> Response {
    let galley = symbol.fitting(ui, size, color, width.map_or(f32::INFINITY, |width| width + OVERHANG));
    let room =
        Vec2::new(width.unwrap_or(galley.size().x), ui.spacing().interact_size.y.min(ui.available_height()));
    let (place, response) = ui.allocate_exact_size(room, Sense::hover());
    // Read with the control or the number that it stands beside, not a second time.
    response.widget_info(|| WidgetInfo::labeled(Role::Label, true, symbol.plain()));
    ui.ctx().accesskit_node_builder(response.id, |node| node.set_hidden());
    ui.painter().galley(place.left_center() - Vec2::new(0.0, 0.5 * galley.size().y), galley, color);
    response
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Level {
    Base,
    Lowered,
    Raised,
}

/// A piece that is set alike.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Piece {
    text: String,
    level: Level,
    upright: bool,
}

impl<'a> Symbol<'a> {
    /// Reads the notation of this module; every text is something.
    pub fn parse(text: &'a str) -> Self {
        Self(text)
    }

    /// Typeset, its base of this size.
    pub fn job(&self, size: f32, color: Color32) -> LayoutJob {
        let mut job = LayoutJob::default();
        self.append_to(&mut job, size, color);
        job
    }

    /// Typeset at the end of a text of the same size.
    pub fn append_to(&self, job: &mut LayoutJob, size: f32, color: Color32) {
        for Piece { text, level, upright } in self.pieces() {
            let family = if upright { fonts::maths_upright() } else { fonts::maths() };
            let font_size = if level == Level::Base { size } else { SCRIPT_SIZE * size };
            // egui puts a small section's line at the bottom or the top of the row, and its text into the middle of
            // that line: a line shorter than the text shifts it farther by half of the difference.
            let (valign, shift) = match level {
                Level::Base => (Align::BOTTOM, 0.0),
                Level::Lowered => (Align::BOTTOM, SUBSCRIPT_DROP - DESCENT * (1.0 - SCRIPT_SIZE)),
                Level::Raised => (Align::TOP, SUPERSCRIPT_RISE - ASCENT * (1.0 - SCRIPT_SIZE)),
            };
            let line_height = (shift != 0.0).then_some(font_size * (ASCENT + DESCENT) - 2.0 * shift * size);
            let font_id = FontId::new(font_size, family);
            job.append(&text, 0.0, TextFormat { font_id, color, valign, line_height, ..Default::default() });
        }
    }

    /// Typeset beside text and controls.
    pub fn galley(&self, ui: &Ui, size: f32, color: Color32) -> Arc<Galley> {
        if self.is_word() {
            return ui.painter().layout_no_wrap(self.0.to_owned(), theme::body(), color);
        }
        ui.painter().layout_job(self.job(size, color))
    }

    /// The same no wider than there is room.
    pub fn fitting(&self, ui: &Ui, size: f32, color: Color32, room: f32) -> Arc<Galley> {
        let galley = self.galley(ui, size, color);
        let width = galley.size().x;
        if width > room { self.galley(ui, size * room / width, color) } else { galley }
    }

    /// Whether it is a word, which belongs into the face of the text.
    fn is_word(&self) -> bool {
        WORDS.contains(&self.0)
    }

    /// As plain text, for an accessible name or a file: `C_mα`, `U_0 + Z_q`.
    pub fn plain(&self) -> String {
        let mut plain = String::new();
        for Piece { text, level, .. } in self.pieces() {
            match level {
                Level::Base => {}
                Level::Lowered => plain.push('_'),
                Level::Raised => plain.push('^'),
            }
            plain.push_str(&text);
        }
        plain
    }

    fn pieces(&self) -> Vec<Piece> {
        let mut pieces: Vec<Piece> = Vec::new();
        let mut rest = self.0;
        while let Some(first) = rest.chars().next() {
            let level = match first {
                '_' => Level::Lowered,
                '^' => Level::Raised,
                _ => {
                    let end = rest.find(['_', '^']).unwrap_or(rest.len());
                    set(&rest[..end], Level::Base, &mut pieces);
                    rest = &rest[end..];
                    continue;
                }
            };
            rest = &rest[1..];
            let (script, after) = script(rest);
            set(script, level, &mut pieces);
            rest = after;
        }
        pieces
    }
}

/// What is raised or lowered, and what follows it.
fn script(text: &str) -> (&str, &str) {
    if let Some((inner, after)) = text.strip_prefix('{').and_then(|text| text.split_once('}')) {
        return (inner, after);
    }
    let ends = |c: char| !(c.is_alphabetic() || c.is_ascii_digit() || c == DOT_ABOVE);
    text.split_at(text.find(ends).unwrap_or(text.len()))
}

/// Parts text into what is italic and what is upright.
fn set(text: &str, level: Level, pieces: &mut Vec<Piece>) {
    let mut rest = text;
    while !rest.is_empty() {
        let letters = rest.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(rest.len());
        let (part, upright) = if WORDS.contains(&&rest[..letters]) {
            (&rest[..letters], true)
        } else if letters > 0 {
            (&rest[..letters], false)
        } else {
            // Up to the next Latin letter. Of the maths faces only the italic one has Greek, only the upright figures.
            (&rest[..rest.find(|c: char| c.is_ascii_alphabetic()).unwrap_or(rest.len())], false)
        };
        rest = &rest[part.len()..];
        let part = part.replace('-', "−");
        match pieces.last_mut() {
            Some(last) if last.level == level && last.upright == upright => last.text.push_str(&part),
            _ => pieces.push(Piece { text: part, level, upright }),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pieces(text: &str) -> Vec<(String, Level, bool)> {
        Symbol(text).pieces().into_iter().map(|p| (p.text, p.level, p.upright)).collect()
    }

    #[test]
    fn a_subscript_is_letters_and_figures_or_what_braces_hold() {
        use Level::{Base, Lowered};
        assert_eq!(pieces("M_w"), [("M".into(), Base, false), ("w".into(), Lowered, false)]);
        assert_eq!(pieces("C_mα"), [("C".into(), Base, false), ("mα".into(), Lowered, false)]);
        assert_eq!(pieces("C_mα"), pieces("C_{mα}"));
        assert_eq!(
            pieces("U_0+Z_q"),
            [
                ("U".into(), Base, false),
                ("0".into(), Lowered, false),
                ("+Z".into(), Base, false),
                ("q".into(), Lowered, false)
            ]
        );
        assert_eq!(pieces("C_mα\u{307}")[1].0, "mα\u{307}");
        assert_eq!(pieces("e^{λt}")[1], ("λt".into(), Level::Raised, false));
    }

    #[test]
    fn names_of_functions_are_upright_and_letters_are_not() {
        use Level::{Base, Lowered};
        assert_eq!(
            pieces("g cos θ_0"),
            [
                ("g ".into(), Base, false),
                ("cos".into(), Base, true),
                (" θ".into(), Base, false),
                ("0".into(), Lowered, false)
            ]
        );
        assert_eq!(pieces("x_{cg}")[1], ("cg".into(), Lowered, false));
        assert_eq!(pieces("C_{L max}")[2], ("max".into(), Lowered, true));
    }

    #[test]
    fn the_symbols_of_a_sentence_are_set_and_the_rest_of_it_stays() {
        let set = |text: &str| prose(text, FontId::proportional(12.0), Color32::BLACK);
        let job = set("Lift: C_L = W cos γ₀/(½ρV²S), and C_L² of m_α\u{307}.");
        assert_eq!(job.text, "Lift: CL = W cos γ₀/(½ρV²S), and CL² of mα\u{307}.");
        let small = job.sections.iter().filter(|section| section.format.font_id.size < 11.0);
        let lowered: Vec<&str> =
            small.map(|section| &job.text[section.byte_range.start.0..section.byte_range.end.0]).collect();
        assert_eq!(lowered, ["L", "L", "α\u{307}"]);
        for plain in ["", "no symbol", "wing_area", "_", "a _ b", "C_", "thrust_per_throttle is missing"] {
            assert_eq!(set(plain).text, plain);
        }
    }

    #[test]
    fn damaged_notation_loses_its_marks_and_nothing_else() {
        for (text, set) in [
            ("", ""),
            ("_", ""),
            ("^", ""),
            ("_{}", ""),
            ("_{", "{"),
            ("C_", "C"),
            ("C_{m", "C{m"),
            ("C_}", "C}"),
            ("a__b", "ab"),
            ("α^^2", "α2"),
            ("é_é", "éé"),
        ] {
            assert_eq!(Symbol(text).job(14.0, Color32::BLACK).text, set, "{text}");
        }
    }

    #[test]
    fn the_plain_form_can_be_read_and_set_again() {
        for (text, plain) in [("C_{mα}", "C_mα"), ("g cos θ_0", "g cos θ_0"), ("Z_q - U_0^2", "Z_q − U_0^2")]
        {
            assert_eq!(Symbol(text).plain(), plain);
            assert_eq!(pieces(plain), pieces(text));
        }
    }

    /// The upright face has only these letters: another would be drawn in another face.
    #[test]
    fn the_upright_face_has_the_words_that_are_set_in_it() {
        let mut faces = fonts::definitions();
        faces.families.insert(fonts::maths_upright(), vec!["maths-upright".to_owned()]);
        let mut fonts = egui::epaint::text::Fonts::new(Default::default(), faces);
        let id = FontId::new(14.0, fonts::maths_upright());
        let missing: String =
            WORDS.iter().flat_map(|word| word.chars()).filter(|&c| !fonts.has_glyph(&id, c)).collect();
        assert_eq!(missing, "");
        assert!(!fonts.has_glyph(&id, 'Q'), "the test can tell");
    }

    #[test]
    fn a_symbol_is_no_taller_than_the_text_beside_it() {
        let mut fonts = egui::epaint::text::Fonts::new(Default::default(), fonts::definitions());
        let mut view = fonts.with_pixels_per_point(2.0);
        let mut baselines = |text: &str| {
            let galley = view.layout_job(Symbol(text).job(14.0, Color32::BLACK));
            let row = &galley.rows[0];
            (row.height(), row.glyphs.iter().map(|glyph| glyph.pos.y).collect::<Vec<_>>())
        };
        let (height, base) = baselines("C");
        let (height_with_script, with_script) = baselines("C_m^2");
        assert_eq!(height, height_with_script);
        assert_eq!(base[0], with_script[0]);
        assert!((with_script[1] - base[0] - SUBSCRIPT_DROP * 14.0).abs() <= 0.6, "{with_script:?}");
        assert!((base[0] - with_script[2] - SUPERSCRIPT_RISE * 14.0).abs() <= 0.6, "{with_script:?}");
    }
}
