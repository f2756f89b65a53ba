//! A word that leads somewhere: one of the glossary opens its sentence, a source its reference; a scene, a lesson or a page is gone to.

use egui::accesskit::Role;
use egui::{Label, OpenUrl, Popup, PopupCloseBehavior, RichText, Sense, Ui, WidgetInfo};

use super::Wish;
use super::text::Context;
use crate::lesson::Target;
use crate::ui::symbol::prose;
use crate::ui::theme::{self, Palette};

/// Width of what a word opens.
const WIDTH: f32 = 280.0;

/// Draws the word; gives what it leads to, if the person goes there. By tap, or by Enter on it; Escape or a tap elsewhere closes.
pub fn word_ui(
    ui: &mut Ui,
    words: &str,
    text: RichText,
    target: &Target,
    context: Context<'_>,
) -> Option<Wish> {
    let palette = Palette::of(ui);
    let label = Label::new(text.color(palette.link()).underline()).selectable(false);
    let response = ui.add(label.sense(Sense::click()));
    let told = told(target, context);
    let response = response.on_hover_cursor(egui::CursorIcon::PointingHand);
    response.widget_info(|| WidgetInfo::labeled(Role::Link, true, words));
    theme::focus_ring(ui, &response);
    if let Some((head, sentence)) = told {
        let popup = Popup::from_toggle_button_response(&response)
            .close_behavior(PopupCloseBehavior::CloseOnClickOutside)
            .width(WIDTH)
            .accessible_name(head.as_str());
        let is_open = popup.is_open();
        ui.ctx().accesskit_node_builder(response.id, |node| {
            node.set_description(sentence.as_str());
            node.set_expanded(is_open);
        });
        popup.show(|ui| {
            ui.label(RichText::new(&head).font(theme::semibold(theme::body().size)));
            ui.label(prose(&sentence, theme::body(), palette.text));
        });
        if !is_open {
            response.on_hover_text(sentence);
        }
        return None;
    }
    if !response.clicked() {
        return None;
    }
    match target {
        Target::Scene(link) => Some(Wish::Scene(link.clone())),
        Target::Lesson(key) => Some(Wish::Lesson(key.clone())),
        Target::Page(address) => {
            ui.ctx().open_url(OpenUrl::new_tab(address));
            None
        }
        Target::Glossary(_) | Target::Source(_) => None,
    }
}

/// What a word opens: a heading and what stands below it.
fn told(target: &Target, context: Context<'_>) -> Option<(String, String)> {
    match target {
        Target::Glossary(key) => {
            context.shelf.glossary.get(key).map(|entry| (entry.word.clone(), entry.says.clone()))
        }
        Target::Source(key) => context
            .shelf
            .references
            .get(key)
            .map(|source| (source.author.clone(), format!("{}. {}", source.title, source.published))),
        Target::Scene(_) | Target::Lesson(_) | Target::Page(_) => None,
    }
}
