//! A transfer function in factored form, as a fraction with its line, and what its zeros do.

use std::sync::Arc;

use egui::{FontId, Galley, Pos2, Sense, Stroke, Ui, Vec2, WidgetInfo, accesskit::Role};

use crate::ui::symbol::Symbol;
use crate::ui::theme::{self, Palette};
use crate::words::transfer_function::Fraction;

/// Between what stands before the line and the line, and between the line and what stands above and below it.
const GAPS: (f32, f32) = (6.0, 2.0);

/// A fraction laid out.
pub struct Laid {
    head: Arc<Galley>,
    parts: [Arc<Galley>; 2],
    remark: Option<Arc<Galley>>,
    said: String,
}

impl Laid {
    /// Lays out a fraction of this symbol, with a remark below it, over the width there is.
    pub fn of(ui: &Ui, symbol: &str, fraction: &Fraction, remark: Option<&str>) -> Self {
        let palette = Palette::of(ui);
        let font = FontId::proportional(theme::sizes(ui).small);
        let mut job = Symbol::parse(symbol).job(theme::sizes(ui).inline_symbol, palette.text);
        let format = egui::TextFormat::simple(font.clone(), palette.text);
        job.append(&format!(" = {}", fraction.gain), 0.0, format);
        let head = ui.painter().layout_job(job);
        let width = (ui.available_width() - head.size().x - GAPS.0 - 4.0).max(60.0);
        let part = |text: &str| ui.painter().layout(text.to_owned(), font.clone(), palette.text, width);
        let parts = [part(&fraction.above), part(&fraction.below)];
        let remark = remark.map(|remark| {
            let whole = ui.available_width();
            ui.painter().layout(remark.to_owned(), font.clone(), palette.warning, whole)
        });
        let said = format!("{} = {}", Symbol::parse(symbol).plain(), fraction.line());
        Self { head, parts, remark, said }
    }

    /// Height of the fraction alone.
    fn fraction_height(&self) -> f32 {
        self.parts.iter().map(|part| part.size().y).sum::<f32>() + 2.0 * GAPS.1 + 1.0
    }

    /// Height of all.
    pub fn height(&self) -> f32 {
        self.fraction_height() + self.remark.as_ref().map_or(0.0, |remark| remark.size().y + 2.0)
    }

    /// Draws it.
    pub fn show(self, ui: &mut Ui) {
        let palette = Palette::of(ui);
        let size = Vec2::new(ui.available_width(), self.height());
        let (area, response) = ui.allocate_exact_size(size, Sense::hover());
        let remark = self.remark.as_ref().map_or("", |remark| remark.text());
        let said = format!("{}\n{remark}", self.said);
        response.widget_info(|| WidgetInfo::labeled(Role::Label, true, said.trim_end()));
        let height = self.fraction_height();
        let [above, below] = &self.parts;
        let line = area.top() + above.size().y + GAPS.1;
        let left = area.left() + self.head.size().x + GAPS.0;
        let width = above.size().x.max(below.size().x);
        let painter = ui.painter();
        let head_at = Pos2::new(area.left(), line - 0.5 * self.head.size().y);
        painter.galley(head_at, self.head.clone(), palette.text);
        painter.hline(left..=left + width, line, Stroke::new(1.0, palette.text));
        for (part, top) in [(above, area.top()), (below, line + GAPS.1 + 1.0)] {
            let from = left + 0.5 * (width - part.size().x);
            painter.galley(Pos2::new(from, top), part.clone(), palette.text);
        }
        if let Some(remark) = self.remark {
            painter.galley(area.min + Vec2::new(0.0, height + 2.0), remark, palette.warning);
        }
    }
}
