//! Words set in a size of type and a width, before they have a place: so it is known what has room.

use std::sync::Arc;

use egui::accesskit::Role;
use egui::text::{LayoutJob, TextFormat};
use egui::{
    Align2, Color32, CornerRadius, FontId, Galley, Id, Pos2, Rect, Sense, Stroke, StrokeKind, Ui, Vec2,
    WidgetInfo,
};

use super::words::{Choice, Hands, Piece, Tone};
use crate::content::Aircraft;
use crate::findings::Findings;
use crate::lesson::{Span, Target, TextBlock, What};
use crate::ui::lesson::formula::Display;
use crate::ui::symbol::{Symbol, prose};
use crate::ui::theme::{self, Palette};
use crate::words;

/// The smallest type that a room can read \[points\].
const LEAST: f32 = 11.5;
/// Letters of the maths face are smaller than those of the text.
const MATHS: f32 = 1.15;
// In sizes of the type.
const QUESTION: f32 = 1.08;
const ASIDE: f32 = 0.86;
const GAP: f32 = 0.42;
const PADDING: Vec2 = Vec2::new(0.55, 0.3);
const LETTER: f32 = 1.25;
const COUNT: f32 = 1.5;
const INDENT: f32 = 1.1;
/// A choice of two lines is higher than this.
const ONE_LINE: f32 = 2.5;
/// From this width on choices may stand in pairs \[points\].
const IN_PAIRS: f32 = 480.0;
/// How much of its colour the bar of a choice has.
const BAR: f32 = 0.28;

/// What numbers in text are measured at.
#[derive(Clone, Copy, Debug)]
pub struct Measured<'a> {
    /// What follows from the scene of the slide at its start.
    pub start: &'a Findings,
    /// The aircraft that links may name.
    pub aircraft: &'a [Arc<Aircraft>],
}

/// What a person has pressed on a slide.
#[derive(Clone, Debug, PartialEq)]
pub enum Pressed {
    /// A word that leads to a scene.
    Scene(String),
    /// A choice.
    Choice(usize),
}

/// Words that are set.
#[derive(Default)]
pub struct Setting {
    /// Height of all of them \[points\].
    pub height: f32,
    inks: Vec<(Rect, Ink)>,
}

enum Ink {
    Text { galley: Arc<Galley>, told: String, is_question: bool, leads: Option<String> },
    Formula(Display),
    Choice(SetChoice),
}

/// A choice, or hands without one.
struct SetChoice {
    number: usize,
    letter: Arc<Galley>,
    says: Option<Arc<Galley>>,
    because: Option<Arc<Galley>>,
    told: String,
    is_right: Option<bool>,
    hands: Hands,
    size: f32,
}

impl Setting {
    /// Sets pieces in a size of type and a width, as many as a height has room for; says whether that is all.
    pub fn of(
        ui: &Ui,
        pieces: &[Piece<'_>],
        (size, width, most): (f32, f32, f32),
        measured: Measured<'_>,
    ) -> (Self, bool) {
        let mut setting = Self::default();
        let mut before = None;
        // Short choices stand in pairs where there is room, so that more is left for the panes.
        let half = 0.5 * (width - GAP * size);
        let is_short = |piece: &Piece<'_>| match piece {
            Piece::Choice(choice) => {
                let (place, _) = choice_ink(ui, choice, size, half, measured);
                choice.because.is_none() && place.height() < ONE_LINE * size
            }
            _ => true,
        };
        let in_pairs = width >= IN_PAIRS && pieces.iter().all(is_short);
        for piece in pieces {
            let gap = match (before, piece) {
                (None, _) => 0.0,
                (Some(is_choice), Piece::Choice(_) | Piece::Hands(..)) if is_choice => 0.8 * GAP,
                _ => 1.3 * GAP,
            };
            before = Some(matches!(piece, Piece::Choice(_) | Piece::Hands(..)));
            let top = setting.height + gap * size;
            if let (Piece::Choice(choice), true) = (piece, in_pairs) {
                let (place, ink) = choice_ink(ui, choice, size, half, measured);
                let is_right = choice.number % 2 == 1;
                let top = if is_right { setting.height - place.height() } else { top };
                if top + place.height() > most {
                    return (setting, false);
                }
                let left = if is_right { half + GAP * size } else { 0.0 };
                setting.inks.push((place.translate(Vec2::new(left, top)), ink));
                setting.height = top + place.height();
                continue;
            }
            let inks = inks(ui, piece, size, width, measured);
            let bottom = inks.iter().map(|(place, _)| place.bottom()).fold(0.0, f32::max);
            if top + bottom > most {
                return (setting, false);
            }
            setting
                .inks
                .extend(inks.into_iter().map(|(place, ink)| (place.translate(Vec2::new(0.0, top)), ink)));
            setting.height = top + bottom;
        }
        (setting, true)
    }

    /// Draws them; gives what is pressed.
    pub fn show(self, ui: &Ui, left_top: Pos2) -> Option<Pressed> {
        let palette = Palette::of(ui);
        let mut pressed = None;
        for (number, (place, ink)) in self.inks.into_iter().enumerate() {
            let place = place.translate(left_top.to_vec2());
            let id = Id::unique(("words of a slide", number));
            match ink {
                Ink::Formula(display) => display.show(ui, place.min, id),
                Ink::Text { galley, told, is_question, leads } => {
                    ui.painter().galley(place.min, galley, palette.text);
                    let sense = if leads.is_some() { Sense::click() } else { Sense::hover() };
                    let response = ui.interact(place, id, sense);
                    let role = if leads.is_some() { Role::Link } else { Role::Label };
                    response.widget_info(|| WidgetInfo::labeled(role, true, told.as_str()));
                    if is_question {
                        ui.ctx().accesskit_node_builder(response.id, |node| {
                            node.set_role(Role::Heading);
                            node.set_level(2);
                        });
                    }
                    theme::focus_ring(ui, &response);
                    if response.clicked() {
                        pressed = leads.map(Pressed::Scene).or(pressed);
                    }
                }
                Ink::Choice(choice) => {
                    if choice.show(ui, place, id) {
                        pressed = Some(Pressed::Choice(choice.number));
                    }
                }
            }
        }
        pressed
    }
}

impl SetChoice {
    /// Draws it; says whether it is pressed.
    fn show(&self, ui: &Ui, place: Rect, id: Id) -> bool {
        let palette = Palette::of(ui);
        let painter = ui.painter();
        let corner = CornerRadius::same(6);
        let ground = if self.is_right == Some(true) { palette.good_ground } else { palette.field };
        painter.rect_filled(place, corner, ground);
        if self.hands.count > 0 {
            let share = self.hands.count as f32 / self.hands.of.max(1) as f32;
            let bar = Rect::from_min_size(place.min, Vec2::new(share * place.width(), place.height()));
            let color = if self.is_right == Some(true) { palette.good } else { palette.accent };
            painter.rect_filled(bar, corner, color.gamma_multiply(BAR));
        }
        if self.is_right == Some(true) {
            painter.rect_stroke(place, corner, Stroke::new(2.0, palette.good), StrokeKind::Inside);
        }
        let padding = PADDING * self.size;
        let at = place.min + padding;
        // On the line of the first words, which is higher where a symbol stands in it.
        let first = self.says.as_ref().and_then(|says| says.rows.first()).map_or(0.0, |row| row.height());
        let down = (first - self.letter.size().y).max(0.0);
        painter.galley(at + Vec2::new(0.0, down), self.letter.clone(), palette.text);
        let beside = at + Vec2::new(LETTER * self.size, 0.0);
        let mut below = beside;
        if let Some(says) = &self.says {
            painter.galley(beside, says.clone(), palette.text);
            below.y += says.size().y;
        }
        if let Some(because) = &self.because {
            painter.galley(below + Vec2::new(0.0, 2.0), because.clone(), palette.text);
        }
        if self.hands.of > 0 {
            let font = theme::semibold(self.size);
            let corner = place.right_top() + Vec2::new(-padding.x, padding.y);
            painter.text(corner, Align2::RIGHT_TOP, self.hands.count.to_string(), font, palette.text);
        }
        let response = ui.interact(place, id, Sense::click());
        response.widget_info(|| WidgetInfo::labeled(Role::Button, true, self.told.as_str()));
        theme::focus_ring(ui, &response);
        response.clicked()
    }
}

/// A piece with its places below each other from 0.
fn inks(ui: &Ui, piece: &Piece<'_>, size: f32, width: f32, measured: Measured<'_>) -> Vec<(Rect, Ink)> {
    let palette = Palette::of(ui);
    match piece {
        Piece::Sentence(text, tone) => {
            let mut job = prose(text, font(*tone, size), color(*tone, palette));
            job.wrap.max_width = width;
            vec![text_ink(ui, job, text.clone(), *tone, None, 0.0)]
        }
        Piece::Block(TextBlock::Formula(formula), _) => {
            let display = Display::of(ui, formula, 0.92 * size, width);
            let left = 0.5 * (width - display.extent().x).max(0.0);
            let place = Rect::from_min_size(Pos2::new(left, 0.0), display.extent());
            vec![(place, Ink::Formula(display))]
        }
        Piece::Block(TextBlock::Code(code), tone) => {
            let mut job = LayoutJob::simple(code.clone(), font(*tone, size), palette.text, width);
            job.wrap.max_width = width;
            vec![text_ink(ui, job, code.clone(), *tone, None, 0.0)]
        }
        Piece::Block(TextBlock::Table(rows), tone) => table(ui, rows, *tone, (size, width), measured),
        Piece::Block(block, tone) => {
            let (depth, bullet) = match block {
                TextBlock::Item { depth, number: Some(number), .. } => (*depth, format!("{number}. ")),
                TextBlock::Item { depth, begins: true, .. } => (*depth, "• ".to_owned()),
                TextBlock::Item { depth, .. } => (*depth, String::new()),
                TextBlock::Quote(_) => (1, String::new()),
                _ => (0, String::new()),
            };
            let indent = INDENT * size * depth.saturating_sub(usize::from(!bullet.is_empty())) as f32;
            let tone_font = if matches!(block, TextBlock::Heading(_)) {
                theme::semibold(size)
            } else {
                font(*tone, size)
            };
            let mut line = Line::new(tone_font, color(*tone, palette));
            line.words(&bullet);
            line.spans(&block.spans(), measured, palette);
            line.job.wrap.max_width = width - indent;
            vec![text_ink(ui, line.job, line.told, *tone, line.leads, indent)]
        }
        Piece::Choice(choice) => vec![choice_ink(ui, choice, size, width, measured)],
        Piece::Hands(number, hands) => {
            let letter = plain(ui, &(number + 1).to_string(), theme::semibold(size), palette.text);
            let height = letter.size().y + 2.0 * PADDING.y * size;
            let told = format!("{}: {}", number + 1, said_hands(*hands));
            let (number, hands) = (*number, *hands);
            let choice =
                SetChoice { number, letter, says: None, because: None, told, is_right: None, hands, size };
            vec![(Rect::from_min_size(Pos2::ZERO, Vec2::new(width, height)), Ink::Choice(choice))]
        }
    }
}

fn choice_ink(ui: &Ui, choice: &Choice<'_>, size: f32, width: f32, measured: Measured<'_>) -> (Rect, Ink) {
    let palette = Palette::of(ui);
    let (ink, mark) = match choice.is_right {
        None => (palette.text, ""),
        Some(true) => (palette.good, "✓"),
        Some(false) => (palette.weak, ""),
    };
    let name = letter(choice.number);
    let lettered = if mark.is_empty() { name.to_string() } else { mark.to_owned() };
    let letter = plain(ui, &lettered, theme::semibold(size), ink);
    let room = width - (2.0 * PADDING.x + LETTER + COUNT) * size;
    let set = |text: &crate::lesson::Text, font: FontId, color: Color32| {
        let mut line = Line::new(font, color);
        for (number, block) in text.blocks.iter().enumerate() {
            line.words(if number > 0 { "\n" } else { "" });
            line.spans(&block.spans(), measured, palette);
        }
        line.job.wrap.max_width = room;
        (ui.painter().layout_job(line.job), line.told)
    };
    let (says, said) = set(choice.says, FontId::proportional(size), ink);
    let because =
        choice.because.map(|text| set(text, FontId::proportional((ASIDE * size).max(LEAST)), palette.text));
    let mut told = format!("{name}: {said}");
    match choice.is_right {
        Some(true) => told.push_str("; right"),
        Some(false) => told.push_str("; not right"),
        None => {}
    }
    if choice.hands.of > 0 {
        told.push_str(&format!("; {}", said_hands(choice.hands)));
    }
    if let Some((_, because)) = &because {
        told.push_str(&format!("; {because}"));
    }
    let because = because.map(|(galley, _)| galley);
    let height = says.size().y.max(letter.size().y)
        + because.as_ref().map_or(0.0, |because| 2.0 + because.size().y)
        + 2.0 * PADDING.y * size;
    let set = SetChoice {
        number: choice.number,
        letter,
        says: Some(says),
        because,
        told,
        is_right: choice.is_right,
        hands: choice.hands,
        size,
    };
    (Rect::from_min_size(Pos2::ZERO, Vec2::new(width, height)), Ink::Choice(set))
}

/// The letter of a choice.
fn letter(number: usize) -> char {
    char::from(b'A' + number.min(25) as u8)
}

fn said_hands(hands: Hands) -> String {
    match hands.count {
        1 => "1 hand".to_owned(),
        count => format!("{count} hands"),
    }
}

/// A table whose columns are as wide as they need; one that is wider than the room is left out.
fn table(
    ui: &Ui,
    rows: &[Vec<Vec<Span>>],
    tone: Tone,
    (size, width): (f32, f32),
    measured: Measured<'_>,
) -> Vec<(Rect, Ink)> {
    let palette = Palette::of(ui);
    let cells: Vec<Vec<(Arc<Galley>, String)>> = rows
        .iter()
        .enumerate()
        .map(|(row, cells)| {
            let font = if row == 0 { theme::semibold(0.92 * size) } else { font(tone, size) };
            let cell = |cell: &Vec<Span>| {
                let mut line = Line::new(font.clone(), palette.text);
                line.spans(&cell.iter().collect::<Vec<_>>(), measured, palette);
                (ui.painter().layout_job(line.job), line.told)
            };
            cells.iter().map(cell).collect()
        })
        .collect();
    let columns = cells.iter().map(Vec::len).max().unwrap_or(0);
    let wide = |column: usize| {
        cells.iter().filter_map(|row| row.get(column)).map(|cell| cell.0.size().x).fold(0.0, f32::max)
    };
    let widths: Vec<f32> = (0..columns).map(|column| wide(column) + 1.2 * size).collect();
    if widths.iter().sum::<f32>() > width {
        return Vec::new();
    }
    let mut inks = Vec::new();
    let mut y = 0.0;
    for row in cells {
        let mut x = 0.0;
        let height = row.iter().map(|cell| cell.0.size().y).fold(0.0, f32::max);
        for ((galley, told), width) in row.into_iter().zip(&widths) {
            let place = Rect::from_min_size(Pos2::new(x, y), galley.size());
            inks.push((place, Ink::Text { galley, told, is_question: false, leads: None }));
            x += width;
        }
        y += height + 0.25 * size;
    }
    inks
}

fn text_ink(
    ui: &Ui,
    job: LayoutJob,
    told: String,
    tone: Tone,
    leads: Option<String>,
    indent: f32,
) -> (Rect, Ink) {
    let galley = ui.painter().layout_job(job);
    let place = Rect::from_min_size(Pos2::new(indent, 0.0), galley.size());
    (place, Ink::Text { galley, told, is_question: tone == Tone::Question, leads })
}

fn plain(ui: &Ui, text: &str, font: FontId, color: Color32) -> Arc<Galley> {
    ui.painter().layout_no_wrap(text.to_owned(), font, color)
}

fn font(tone: Tone, size: f32) -> FontId {
    match tone {
        Tone::Question => theme::semibold(QUESTION * size),
        Tone::Answer => theme::semibold(size),
        Tone::Plain => FontId::proportional((0.95 * size).max(LEAST)),
    }
}

fn color(tone: Tone, palette: &Palette) -> Color32 {
    if tone == Tone::Answer { palette.good } else { palette.text }
}

/// Text that is being put together.
struct Line {
    job: LayoutJob,
    /// The same for a screen reader, which hears formulas in words.
    told: String,
    /// The scene that a word of it leads to.
    leads: Option<String>,
    font: FontId,
    color: Color32,
}

impl Line {
    fn new(font: FontId, color: Color32) -> Self {
        Self { job: LayoutJob::default(), told: String::new(), leads: None, font, color }
    }

    fn words(&mut self, words: &str) {
        self.job.append(words, 0.0, TextFormat::simple(self.font.clone(), self.color));
        self.told.push_str(words);
    }

    fn spans(&mut self, spans: &[&Span], measured: Measured<'_>, palette: &Palette) {
        for span in spans {
            let words = match &span.what {
                What::Words(words) => words.clone(),
                What::Symbol(symbol) => {
                    self.symbol(symbol);
                    self.told.push_str(&Symbol::parse(symbol).plain());
                    continue;
                }
                What::Formula(formula) => {
                    self.symbol(&formula.line());
                    self.told.push_str(&formula.in_words());
                    continue;
                }
                What::Number(number) => match number.value(measured.start, measured.aircraft) {
                    Some(Ok(value)) => value,
                    Some(Err(absence)) => {
                        let length = measured.start.scenario().length_unit();
                        format!("({})", words::measure::absence(&absence, length))
                    }
                    None => String::new(),
                },
                What::Break => "\n".to_owned(),
            };
            let mut color = self.color;
            if let Some(Target::Scene(link)) = &span.target {
                self.leads.get_or_insert_with(|| link.clone());
                color = palette.link();
            }
            let font = if span.strong { theme::semibold(self.font.size) } else { self.font.clone() };
            let mut part = prose(&words, font, color);
            for section in &mut part.sections {
                section.format.italics |= span.emphasis;
                let (from, to) = (section.byte_range.start.0, section.byte_range.end.0);
                self.job.append(&part.text[from..to], section.leading_space, section.format.clone());
            }
            self.told.push_str(&words);
        }
    }

    fn symbol(&mut self, symbol: &str) {
        Symbol::parse(symbol).append_to(&mut self.job, MATHS * self.font.size, self.color);
    }
}
