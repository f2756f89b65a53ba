#![doc = include_str!("../README.md")]

// All that can be decided without a browser, so that it can be tested without one.
#[cfg(any(target_arch = "wasm32", test))]
mod answer;
#[cfg(any(target_arch = "wasm32", test))]
mod key;
#[cfg(any(target_arch = "wasm32", test))]
mod kind;
#[cfg(any(target_arch = "wasm32", test))]
mod outline;
#[cfg(any(target_arch = "wasm32", test))]
mod picture;

#[cfg(target_arch = "wasm32")]
mod element;
#[cfg(target_arch = "wasm32")]
mod page;

/// The plugin: `ctx.add_plugin(Mirror)`, once, when the application is made.
///
/// In a page without `<div id="mirror">`, and outside a browser, where eframe speaks to assistive technology itself, it does
/// nothing.
#[derive(Clone, Copy, Debug, Default)]
pub struct Mirror;

impl egui::Plugin for Mirror {
    fn debug_name(&self) -> &'static str {
        "accessibility mirror"
    }

    #[cfg(target_arch = "wasm32")]
    fn setup(&mut self, ctx: &egui::Context) {
        page::open(ctx);
    }

    #[cfg(target_arch = "wasm32")]
    fn on_exit(&mut self, _ctx: &egui::Context) {
        page::close();
    }

    #[cfg(target_arch = "wasm32")]
    fn input_hook(&mut self, ctx: &egui::Context, input: &mut egui::RawInput) {
        page::pass_on(ctx, input);
    }

    #[cfg(target_arch = "wasm32")]
    fn output_hook(&mut self, ctx: &egui::Context, output: &mut egui::FullOutput) {
        page::receive(ctx, output);
    }
}

/// Has a screen reader say this sentence when it next pauses, by way of `<div id="announcements" aria-live="polite">`.
///
/// It is for what happens without the keyboard's focus moving there: "Copied", "3 results". Outside a browser it does nothing.
#[cfg_attr(
    not(target_arch = "wasm32"),
    expect(unused_variables, reason = "nobody is told outside a browser")
)]
pub fn announce(sentence: &str) {
    #[cfg(target_arch = "wasm32")]
    page::announce(sentence);
}
