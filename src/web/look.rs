//! The look that a person has chosen, in the browser's storage; without one, the look that their system asks for. One that a link or the page around a frame puts in force isn't kept.

use egui::Context;

use super::address::storage;
use crate::key::Keyed as _;
use crate::ui::Look;

/// Name of the look in the browser's storage.
const LOOK: &str = "eigenwing.look";

/// The look as it is stored.
#[derive(Debug, Default)]
pub struct KeptLook(Option<Look>);

impl KeptLook {
    /// Puts the look of the last visit in force, where one was chosen then.
    pub fn start(ctx: &Context) -> Self {
        let stored = web_sys::window()
            .and_then(|window| storage(&window))
            .and_then(|storage| storage.get_item(LOOK).ok().flatten());
        let look = stored.as_deref().and_then(Look::by_key);
        if let Some(look) = look {
            look.set(ctx);
        } else if Look::lent(ctx).is_none() && wants_contrast() {
            Look::lend(Some(Look::Projector), ctx);
        }
        Self(look)
    }

    /// Stores the look if another has been chosen.
    pub fn follow(&mut self, ctx: &Context) {
        let chosen = Look::chosen(ctx);
        if chosen == self.0 {
            return;
        }
        self.0 = chosen;
        let storage = web_sys::window().and_then(|window| storage(&window));
        if let Some((storage, look)) = storage.zip(chosen) {
            // Full or forbidden: the next visit has the look of the system.
            let _ = storage.set_item(LOOK, look.key());
        }
    }
}

/// Whether the system asks for strong contrasts or for its own few colours, and for a light page: a dark one has them anyway.
fn wants_contrast() -> bool {
    let asks = |query: &str| {
        let window = web_sys::window();
        window
            .and_then(|window| window.match_media(query).ok().flatten())
            .is_some_and(|query| query.matches())
    };
    (asks("(forced-colors: active)") || asks("(prefers-contrast: more)"))
        && !asks("(prefers-color-scheme: dark)")
}
