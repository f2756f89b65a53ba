//! The browser: starting on the page's canvas, telling the page how it went, the address bar, the JavaScript handle.

mod address;
mod core_module;
mod files;
mod full_screen;
mod lecture;
mod look;
mod messages;
mod notes_window;
mod records;

use std::any::Any;

use eframe::{WebOptions, WebRunner};
use wasm_bindgen::closure::Closure;
use wasm_bindgen::{JsCast, JsValue};
use web_sys::{CustomEvent, CustomEventInit, Event, HtmlCanvasElement};

use address::AddressBar;
use core_module::CoreModule;
use files::Files;
use full_screen::FullScreen;
use lecture::KeptLecture;
use look::KeptLook;
use messages::Host;
use notes_window::NotesWindow;
use records::KeptRecords;

use crate::export;
use crate::ui::App;

/// Starts the application on `<canvas id="eigenwing">`.
///
/// The page hears of it by events on `window`: `eigenwing-ready` after the first frame, `eigenwing-failed` with a
/// sentence as its detail if the program can't start or stops. `window.eigenwing.state()` gives the state as JSON, and
/// `window.eigenwing.tell(sentence)` says a sentence near the foot of the page.
pub fn start() {
    std::panic::set_hook(Box::new(|panic| failed(&panic.to_string())));
    wasm_bindgen_futures::spawn_local(async {
        if let Err(error) = run().await {
            let reason =
                error.as_string().or_else(|| error.dyn_ref().map(|e: &js_sys::Error| e.message().into()));
            failed(&reason.unwrap_or_else(|| "the browser gave no reason".to_owned()));
        }
    });
}

async fn run() -> Result<(), JsValue> {
    let window = web_sys::window().ok_or("there is no window")?;
    let document = window.document().ok_or("there is no document")?;
    let canvas: HtmlCanvasElement = document
        .get_element_by_id("eigenwing")
        .ok_or("the page has no canvas named eigenwing")?
        .dyn_into()?;
    let reduced_motion =
        window.match_media("(prefers-reduced-motion: reduce)")?.is_some_and(|query| query.matches());

    // As `page.js` has found it, over that of most browsers.
    let type_size = document.document_element().and_then(|root| root.get_attribute("data-type"));
    let type_size =
        type_size.and_then(|size| size.parse::<f32>().ok()).filter(|size| (0.5..=3.0).contains(size));

    let runner = WebRunner::new();
    offer_handle(&runner)?;
    let create: eframe::AppCreator<'static> = Box::new(move |cc| {
        let mut app = App::new(&cc.egui_ctx)?;
        // Before the address, which may lead to a lesson that was begun.
        let records = KeptRecords::start(&cc.egui_ctx, &mut app);
        let address = AddressBar::start(&mut app);
        let look = KeptLook::start(&cc.egui_ctx);
        app.offer_files();
        app.offer_pictures();
        let host = Host::start(&cc.egui_ctx, &mut app);
        if let Some(larger) = type_size {
            cc.egui_ctx.set_zoom_factor(larger);
        }
        if reduced_motion {
            cc.egui_ctx.all_styles_mut(|style| style.animation_time = 0.0);
        }
        cc.egui_ctx.add_plugin(egui_dom_mirror::Mirror);
        let lecture = KeptLecture::start(&mut app);
        let (files, core, full_screen, notes) = Default::default();
        let ctx = cc.egui_ctx.clone();
        Ok(Box::new(Page {
            ctx,
            app,
            address,
            files,
            core,
            records,
            look,
            host,
            full_screen,
            lecture,
            notes,
            frames: 0,
        }))
    });
    runner.start(canvas, WebOptions::default(), create).await
}

/// Puts `window.eigenwing` there, with `state()` and `tell()`.
fn offer_handle(runner: &WebRunner) -> Result<(), JsValue> {
    let (asked, told) = (runner.clone(), runner.clone());
    let state = Closure::<dyn Fn() -> JsValue>::new(move || {
        let page = asked.app_mut::<Page>();
        page.map(|page| page.state()).map_or(JsValue::NULL, |state| JsValue::from_str(&state))
    });
    let tell = Closure::<dyn Fn(String)>::new(move |sentence: String| {
        if let Some(mut page) = told.app_mut::<Page>() {
            page.tell(&sentence);
        }
    });
    let handle = js_sys::Object::new();
    js_sys::Reflect::set(&handle, &"state".into(), &state.into_js_value())?;
    js_sys::Reflect::set(&handle, &"tell".into(), &tell.into_js_value())?;
    js_sys::Reflect::set(&js_sys::global(), &"eigenwing".into(), &handle)?;
    Ok(())
}

fn failed(sentence: &str) {
    let init = CustomEventInit::new();
    init.set_detail(&sentence.into());
    if let (Some(window), Ok(event)) =
        (web_sys::window(), CustomEvent::new_with_event_init_dict("eigenwing-failed", &init))
    {
        // A page that doesn't listen can't be told.
        let _ = window.dispatch_event(&event);
    }
}

struct Page {
    ctx: egui::Context,
    app: App,
    address: AddressBar,
    files: Files,
    core: CoreModule,
    records: KeptRecords,
    look: KeptLook,
    full_screen: FullScreen,
    lecture: KeptLecture,
    notes: NotesWindow,
    host: Host,
    frames: u32,
}

impl Page {
    fn state(&self) -> String {
        export::state(self.app.findings()).to_string()
    }

    /// Says what concerns the page as a whole; never on the screen of a lecture.
    fn tell(&mut self, sentence: &str) {
        if self.app.presentation().is_none() {
            self.app.tell(sentence);
            self.ctx.request_repaint();
        }
    }
}

impl eframe::App for Page {
    fn ui(&mut self, ui: &mut egui::Ui, _frame: &mut eframe::Frame) {
        self.address.read(&mut self.app);
        self.files.deliver(&mut self.app);
        self.core.deliver(&mut self.app);
        self.host.obey(ui.ctx(), &mut self.app);
        self.app.ui(ui);
        self.files.fetch(ui, &mut self.app);
        self.core.ask(ui, &mut self.app);
        self.address.follow(ui, &self.app);
        self.records.follow(ui, &mut self.app);
        self.look.follow(ui);
        self.full_screen.follow(ui, &mut self.app);
        self.lecture.follow(ui, &self.app);
        self.notes.follow(ui, &mut self.app);
        if let Some(sentence) = self.app.take_unsaid() {
            egui_dom_mirror::announce(&sentence);
        }
        // The second frame begins once the first is on screen.
        match self.frames {
            0 => ui.request_repaint(),
            1 => {
                if let (Some(window), Ok(event)) = (web_sys::window(), Event::new("eigenwing-ready")) {
                    let _ = window.dispatch_event(&event);
                }
                self.host.greet(&self.app);
            }
            _ => {}
        }
        if self.frames > 0 {
            self.host.follow(ui, &mut self.app);
        }
        self.frames = self.frames.saturating_add(1);
    }

    fn raw_input_hook(&mut self, _ctx: &egui::Context, input: &mut egui::RawInput) {
        self.notes.press_keys(input, self.app.presentation().is_some());
    }

    fn as_any_mut(&mut self) -> Option<&mut dyn Any> {
        Some(self)
    }
}
