//! Messages between the page in a frame and the page around it, its host: `docs/EMBEDDING.md` lists them.
//!
//! They go to any origin, for the page can't know its host's and tells nothing that the host couldn't make the person show it: no
//! name of theirs but the one they have typed for their report, no storage, nothing of other pages. They are taken from the host
//! alone. It may open links: it has chosen the address of the frame, and could choose another.

use std::cell::RefCell;
use std::rc::Rc;

use egui::{Context, Ui};
use wasm_bindgen::closure::Closure;
use wasm_bindgen::{JsCast as _, JsValue};
use web_sys::{MessageEvent, Window};

use super::address::host;
use crate::export::{Event, Message, Request};
use crate::ui::{App, Look};

/// A width or a height that differs by less is no other \[CSS pixels\].
const SAME: f32 = 2.0;

/// The page around the frame, if there is one.
#[derive(Debug, Default)]
pub struct Host {
    window: Option<Window>,
    /// What it has asked for.
    asked: Rc<RefCell<Vec<Result<Request, String>>>>,
    /// The width of the page, and the height that it has been told for that \[CSS pixels\].
    told: Option<[f32; 2]>,
}

impl Host {
    /// Listens to the page around the frame, if this is one.
    pub fn start(ctx: &Context, app: &mut App) -> Self {
        let (Some(window), Some(parent)) = (web_sys::window(), host()) else { return Self::default() };
        app.stand_in_frame();
        app.want_events();
        let host = Self { window: Some(parent.clone()), ..Self::default() };
        let (asked, ctx) = (host.asked.clone(), ctx.clone());
        let hear = Closure::<dyn Fn(MessageEvent)>::new(move |event: MessageEvent| {
            let is_from_host = event.source().is_some_and(|source| js_sys::Object::is(&source, &parent));
            let json = js_sys::JSON::stringify(&event.data()).ok().and_then(|json| json.as_string());
            if let Some(request) = json.filter(|_| is_from_host).and_then(|json| Request::read(&json)) {
                asked.borrow_mut().push(request);
                ctx.request_repaint();
            }
        });
        // A page that can't be listened to can still be told.
        let _ = window.add_event_listener_with_callback("message", hear.into_js_value().unchecked_ref());
        host
    }

    /// Does what the host has asked for. Before a frame is drawn.
    pub fn obey(&mut self, ctx: &Context, app: &mut App) {
        for asked in self.asked.take() {
            match asked {
                Ok(Request::Open(link)) => {
                    self.told = None;
                    app.open(&link);
                }
                Ok(Request::Look(look)) => Look::lend(look, ctx),
                Ok(Request::AskReport) => self.tell(app.report_event()),
                Ok(Request::TakeUp(records)) => app.go_on_with(*records),
                Err(sentence) => self.tell(Event::Error { sentence }),
            }
        }
    }

    /// Says that the page is there.
    pub fn greet(&self, app: &App) {
        self.tell(Event::Ready { link: app.link() });
    }

    /// Tells what has happened, and how high the page would like to be. After a frame was drawn.
    pub fn follow(&mut self, ui: &Ui, app: &mut App) {
        if self.window.is_none() {
            return;
        }
        for event in app.take_events() {
            if matches!(event, Event::StepOpened { .. }) {
                self.told = None;
            }
            self.tell(event);
        }
        let width = ui.content_rect().width() * ui.ctx().zoom_factor();
        let height = app.wished_height(ui.ctx());
        // What is shown at one width only grows: what is granted can change what is wished, and the two would never come to rest.
        let is_told = self.told.is_some_and(|[of, told]| (of - width).abs() < SAME && height < told + SAME);
        if !is_told && !ui.input(|input| input.pointer.any_down()) {
            self.told = Some([width, height]);
            self.tell(Event::Height { height });
        }
    }

    fn tell(&self, event: Event) {
        let Some(window) = &self.window else { return };
        // A host that has gone can't be told.
        let _ = js_sys::JSON::parse(&Message::new(event).to_json())
            .and_then(|message: JsValue| window.post_message(&message, "*"));
    }
}
