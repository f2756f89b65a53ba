//! The notes of a lecture in a window of their own, `notes.html`, which follows the lecture through a `BroadcastChannel`. Each page has a
//! channel of its own, so that lectures in several tabs don't meet.
//!
//! There is one kind of message, a text of JSON, which `web/notes.js` documents: `{ "eigenwing": 1, "says": … }`.

use std::cell::RefCell;
use std::rc::Rc;

use egui::{Context, Event, Key, Modifiers, RawInput};
use serde::Deserialize;
use wasm_bindgen::closure::Closure;
use wasm_bindgen::{JsCast as _, JsValue};
use web_sys::{BroadcastChannel, MessageEvent};

use crate::ui::{App, Cue};

/// Version of the messages.
const VERSION: u32 = 1;

/// Said where the browser opens no window. Notes never come onto the screen that the room sees.
const REFUSED: &str =
    "The browser opened no window for the notes: allow pop-ups for this page and press N again";

/// How the window is opened.
const FEATURES: &str = "popup,width=900,height=720";

/// The window of the notes, once it has been asked for.
#[derive(Debug, Default)]
pub struct NotesWindow {
    channel: Option<Channel>,
    /// What the window was told last: how the lecture stood, which began then by egui's time \[s\], or that there was none. Nothing as
    /// long as it waits to be told.
    told: Option<Option<(Cue, f64)>>,
}

#[derive(Debug)]
struct Channel {
    name: String,
    broadcast: BroadcastChannel,
    /// What the window says and nobody has heeded yet.
    heard: Rc<RefCell<Vec<String>>>,
    /// Hears it.
    _hears: Closure<dyn FnMut(MessageEvent)>,
}

/// What the window says.
#[derive(Deserialize)]
struct Said {
    eigenwing: u32,
    says: String,
}

impl NotesWindow {
    /// Does in the lecture what a button of the window asks for, by the key that does the same. Before a frame is drawn. Where
    /// nothing is presented no key is pressed: it would move what has the focus.
    pub fn press_keys(&mut self, input: &mut RawInput, presents: bool) {
        let Some(channel) = &self.channel else { return };
        for said in channel.heard.take() {
            let Ok(Said { eigenwing: VERSION, says }) = serde_json::from_str(&said) else { continue };
            let key = match says.as_str() {
                "next" => Key::PageDown,
                "back" => Key::PageUp,
                "blank" => Key::B,
                _ => {
                    // It has just opened, or was loaded again.
                    self.told = None;
                    continue;
                }
            };
            let press = |pressed| Event::Key {
                key,
                physical_key: None,
                pressed,
                repeat: false,
                modifiers: Modifiers::NONE,
            };
            if presents {
                input.events.extend([press(true), press(false)]);
            }
        }
    }

    /// Opens the window where it is asked for, and tells it how the lecture stands. After a frame was drawn.
    pub fn follow(&mut self, ctx: &Context, app: &mut App) {
        let standing = app.cue().zip(app.presentation().map(|lecture| lecture.started));
        if app.take_notes_wish() && self.open(ctx).is_err() {
            app.tell(REFUSED);
            ctx.request_repaint();
        }
        let Some(channel) = &self.channel else { return };
        if self.told.as_ref() == Some(&standing) {
            return;
        }
        let message = match &standing {
            Some((cue, began)) => {
                let since = 1e3 * (ctx.input(|input| input.time) - began);
                serde_json::json!({ "eigenwing": VERSION, "says": "cue", "since": since, "cue": cue })
            }
            None => serde_json::json!({ "eigenwing": VERSION, "says": "over" }),
        };
        // A window that isn't there any more misses nothing.
        let _ = channel.broadcast.post_message(&JsValue::from_str(&message.to_string()));
        self.told = Some(standing);
    }

    fn open(&mut self, ctx: &Context) -> Result<(), JsValue> {
        let channel = match self.channel.take() {
            Some(channel) => channel,
            None => Channel::new(ctx)?,
        };
        let name = self.channel.insert(channel).name.clone();
        let window = web_sys::window().ok_or("there is no window")?;
        let opened =
            window.open_with_url_and_target_and_features(&format!("notes.html#{name}"), &name, FEATURES)?;
        opened.map(|_| ()).ok_or_else(|| "refused".into())
    }
}

impl Channel {
    fn new(ctx: &Context) -> Result<Self, JsValue> {
        // As many names as a number can have.
        let name = format!("eigenwing-{}", (js_sys::Math::random() * 9e15) as u64);
        let broadcast = BroadcastChannel::new(&name)?;
        let heard = Rc::<RefCell<Vec<String>>>::default();
        let (hearing, ctx) = (heard.clone(), ctx.clone());
        let hears = Closure::<dyn FnMut(MessageEvent)>::new(move |event: MessageEvent| {
            if let Some(text) = event.data().as_string() {
                hearing.borrow_mut().push(text);
                ctx.request_repaint();
            }
        });
        broadcast.set_onmessage(Some(hears.as_ref().unchecked_ref()));
        Ok(Self { name, broadcast, heard, _hears: hears })
    }
}
