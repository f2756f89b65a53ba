//! The look that a person has chosen, in the browser's storage. It is no part of a link: whoever opens one keeps their own.

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
