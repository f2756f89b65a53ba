//! The layer over the canvas: elements brought up to date after a frame, and what happens to them handed to egui before one.

use std::cell::RefCell;
use std::collections::{HashMap, HashSet};
use std::mem;
use std::time::Duration;

use egui::accesskit::{Action, ActionData, ActionRequest, NodeId, TreeId, TreeUpdate};
use wasm_bindgen::JsCast as _;
use wasm_bindgen::closure::Closure;
use web_sys::{Document, Element, Event, FocusOptions, HtmlElement, HtmlInputElement, KeyboardEvent};

use crate::answer::{Answer, Happened, answer};
use crate::element::Shown;
use crate::key::KeyStroke;
use crate::kind::Kind;
use crate::outline::Outline;
use crate::picture::Picture;

/// While frames come faster than this, egui doesn't make a tree for each.
const INTERVAL_MS: i32 = 100;

/// What a value becomes is said no more often than this, and the last of it is.
const SAID_MS: i32 = 700;

/// A delay that is over when the next frame is drawn: what is asked for with a delay is drawn once.
const ONE_FRAME: Duration = Duration::from_nanos(1);

/// Heard at the root, for all elements in it.
const EVENTS: [&str; 7] = ["click", "input", "change", "keydown", "keyup", "focusin", "focusout"];

thread_local! {
    // Not in the plugin: egui wants plugins to be `Send`, and elements belong to their thread.
    static PAGE: RefCell<Option<Page>> = const { RefCell::new(None) };
}

/// Begins to mirror this context, in a page that wants it.
pub fn open(ctx: &egui::Context) {
    let page = Page::find(ctx);
    if page.is_some() {
        ctx.enable_accesskit();
    }
    PAGE.set(page);
}

/// Takes the elements out of the page.
pub fn close() {
    PAGE.set(None);
}

/// Before a frame: gives egui what has happened to the elements.
pub fn pass_on(ctx: &egui::Context, input: &mut egui::RawInput) {
    with_page(|page| page.pass_on(ctx, input));
}

/// After a frame: writes its tree, if egui has made one.
pub fn receive(ctx: &egui::Context, output: &mut egui::FullOutput) {
    let tree = output.platform_output.accesskit_update.take();
    with_page(|page| match tree {
        Some(tree) => page.receive(&tree, f64::from(ctx.zoom_factor())),
        None => page.missed = true,
    });
}

/// Has a screen reader say this sentence when it next pauses.
pub fn announce(text: &str) {
    let document = web_sys::window().and_then(|window| window.document());
    if let Some(region) = document.and_then(|document| document.get_element_by_id("announcements")) {
        // A sentence that is there already would not be said again.
        let same = region.text_content().as_deref() == Some(text);
        let again = format!("{text}\u{a0}");
        region.set_text_content(Some(if same { &again } else { text }));
    }
}

/// Nothing happens when the page is busy already: an event that it caused itself.
fn with_page<R>(act: impl FnOnce(&mut Page) -> R) -> Option<R> {
    PAGE.with(|page| page.try_borrow_mut().ok()?.as_mut().map(act))
}

/// The layer over the canvas and what stands in it.
struct Page {
    ctx: egui::Context,
    document: Document,
    root: Element,
    shown: HashMap<NodeId, Shown>,
    /// What stands directly in the root, in order.
    children: Vec<NodeId>,
    /// The timeout after which egui is to make trees again.
    timer: Option<i32>,
    /// A frame was drawn without one.
    missed: bool,
    /// What egui is to hear of next: action requests, keys.
    events: Vec<egui::Event>,
    /// An element that the browser's focus has left, which egui has no request for.
    left: Option<NodeId>,
    /// What had egui's focus when the last frame began.
    focused: Option<egui::Id>,
    /// Something was chosen from a list, which is to close.
    chosen: bool,
    /// What has egui's focus, and its value: the last that was announced, or waits to be.
    told: (NodeId, String),
    /// A value that waits to be announced: people who hold a key want to hear where it has brought them, not the way.
    unsaid: Option<String>,
    /// The timeout after which it is.
    saying: Option<i32>,
    /// Of all [`EVENTS`]; what it does may cause another of them.
    listener: Closure<dyn Fn(Event)>,
    on_timer: Closure<dyn FnMut()>,
    on_said: Closure<dyn FnMut()>,
}

impl Page {
    fn find(ctx: &egui::Context) -> Option<Self> {
        let document = web_sys::window()?.document()?;
        let root = document.get_element_by_id("mirror")?;
        root.set_text_content(None);
        let listener = Closure::<dyn Fn(Event)>::new(|event: Event| {
            with_page(|page| page.hear(&event));
        });
        for name in EVENTS {
            root.add_event_listener_with_callback(name, listener.as_ref().unchecked_ref()).ok()?;
        }
        let on_timer = Closure::new(|| {
            with_page(Page::resume);
        });
        let on_said = Closure::new(|| {
            with_page(Page::say);
        });
        Some(Self {
            ctx: ctx.clone(),
            document,
            root,
            shown: HashMap::new(),
            children: Vec::new(),
            timer: None,
            missed: false,
            events: Vec::new(),
            left: None,
            focused: None,
            chosen: false,
            told: (NodeId(0), String::new()),
            unsaid: None,
            saying: None,
            listener,
            on_timer,
            on_said,
        })
    }

    /// Gives egui what was asked for, and in the frame after it what follows from that.
    fn pass_on(&mut self, ctx: &egui::Context, input: &mut egui::RawInput) {
        // A widget without the page's focus would neither show its own nor hear a key.
        input.focused |= self.has_browser_focus();
        let focused = ctx.memory(|memory| memory.focused());
        let focused_before = mem::replace(&mut self.focused, focused);
        if !self.events.is_empty() {
            input.events.append(&mut self.events);
            if self.left.is_some() || self.chosen {
                ctx.request_repaint();
            }
            return;
        }
        if let Some(left) = self.left.take()
            && let Some(focused) = focused.filter(|id| id.accesskit_id() == left)
        {
            if focused_before == Some(focused) {
                ctx.memory_mut(|memory| memory.surrender_focus(focused));
            } else {
                // A widget hears that it has lost the focus only if it had it when a frame began.
                self.left = Some(left);
                ctx.request_repaint();
            }
        }
        if mem::take(&mut self.chosen) {
            egui::Popup::close_all(ctx);
        }
    }

    /// Writes the tree, and has egui make no other for a while: to make one takes longer than to write it.
    fn receive(&mut self, update: &TreeUpdate, zoom: f64) {
        self.missed = false;
        self.write(update, zoom);
        if self.timer.is_none() {
            self.timer = timeout(&self.on_timer, INTERVAL_MS);
        }
        if self.timer.is_some() {
            self.ctx.disable_accesskit();
        }
    }

    fn resume(&mut self) {
        self.timer = None;
        self.ctx.enable_accesskit();
        if mem::take(&mut self.missed) {
            // The page shows an older frame than the canvas. egui answers a plain request with two frames; the second would
            // have no tree, so this would be here again, and a page that draws fast would never rest.
            self.ctx.request_repaint_after(ONE_FRAME);
        }
    }

    fn write(&mut self, update: &TreeUpdate, zoom: f64) {
        let Some(Outline { pictures, orders }) = Outline::of(update, zoom) else {
            return;
        };
        let had_focus = self.has_browser_focus();
        let seen: HashSet<NodeId> = pictures.iter().map(|(id, _)| *id).collect();
        for (id, picture) in pictures {
            self.write_element(id, picture);
        }
        // Those gone leave first, so that none of those that stay has to be moved, which would lose it the focus.
        self.shown.retain(|id, shown| {
            let stays = seen.contains(id);
            if !stays {
                shown.element.remove();
            }
            stays
        });
        for (holder, children) in orders {
            self.order(holder, children);
        }
        if had_focus && !self.has_browser_focus() {
            // What had it is gone, and keys would reach nobody. eframe sees that the canvas has it in the next frame.
            self.focus_canvas();
            self.ctx.request_repaint();
        }
        self.announce_focus(update.focus);
    }

    /// Brings the element of this node up to date, or makes one.
    fn write_element(&mut self, id: NodeId, picture: Picture) {
        match self.shown.get_mut(&id) {
            Some(shown) if shown.picture.kind.tag() == picture.kind.tag() => shown.update(picture),
            _ => {
                let Some(shown) = Shown::new(&self.document, id, picture) else {
                    return;
                };
                if let Some(old) = self.shown.insert(id, shown) {
                    old.element.remove();
                    // Its place among its siblings is to be found again, as are those of what it held.
                    self.children.clear();
                    self.shown.values_mut().for_each(|shown| shown.children.clear());
                }
            }
        }
    }

    /// Puts what this holder holds into order, if it isn't; without a holder, what stands in the root.
    fn order(&mut self, holder: Option<NodeId>, children: Vec<NodeId>) {
        let (element, old) = match holder {
            None => (&self.root, &self.children),
            Some(holder) => match self.shown.get(&holder) {
                Some(shown) => (&shown.element, &shown.children),
                None => return,
            },
        };
        if *old == children {
            return;
        }
        place(&self.shown, element, &children);
        match holder.and_then(|holder| self.shown.get_mut(&holder)) {
            Some(shown) => shown.children = children,
            None => self.children = children,
        }
    }

    /// Whether the browser's focus is on an element of the mirror.
    fn has_browser_focus(&self) -> bool {
        self.document.active_element().is_some_and(|active| self.root.contains(Some(&active)))
    }

    fn focus_canvas(&self) {
        let canvas = self.document.query_selector("canvas").ok().flatten();
        if let Some(canvas) = canvas.and_then(|canvas| canvas.dyn_into::<HtmlElement>().ok()) {
            let options = FocusOptions::new();
            options.set_prevent_scroll(true);
            // Without it the keys stay where they are.
            let _ = canvas.focus_with_options(&options);
        }
    }

    /// Says what the keyboard has reached on the canvas, or what it has made of that.
    fn announce_focus(&mut self, focus: NodeId) {
        let on_element = self.has_browser_focus();
        let pressed = self.ctx.input(|input| input.pointer.any_down());
        let focused = self.shown.get(&focus).filter(|shown| !shown.picture.kind.holds());
        let (name, value) = focused.map(|shown| shown.picture.spoken()).unwrap_or_default();
        if pressed {
            // Not while something is dragged; where that has brought it is said afterwards.
            return;
        }
        let told = mem::replace(&mut self.told, (focus, value.clone()));
        if on_element || name.is_empty() {
            self.unsaid = None;
            return;
        }
        if told.0 != focus {
            self.unsaid = None;
            announce(&format!("{name}, {value}"));
        } else if told.1 != value {
            self.unsaid = Some(value);
            if self.saying.is_none() {
                self.saying = timeout(&self.on_said, SAID_MS);
            }
        }
    }

    /// Says the value that waits, as it is by now.
    fn say(&mut self) {
        self.saying = None;
        if let Some(value) = self.unsaid.take() {
            announce(&value);
        }
    }

    fn hear(&mut self, event: &Event) {
        let target = event.target().and_then(|target| target.dyn_into::<Element>().ok());
        let Some(element) = target.and_then(|target| target.closest("[data-id]").ok().flatten()) else {
            return;
        };
        let id = element.get_attribute("data-id").and_then(|id| id.parse().ok()).map(NodeId);
        let Some((id, shown)) = id.and_then(|id| Some((id, self.shown.get_mut(&id)?))) else {
            return;
        };
        let (kind, focusable) = (shown.picture.kind, shown.picture.focusable);
        let key = event.dyn_ref::<KeyboardEvent>();
        let name = key.map(KeyboardEvent::key).unwrap_or_default();
        let value = element.dyn_ref::<HtmlInputElement>().map(HtmlInputElement::value).unwrap_or_default();
        let happened = match event.type_().as_str() {
            "click" => Happened::Click,
            "input" => Happened::Input(&value),
            "change" => Happened::Change,
            "keydown" => Happened::KeyDown(&name),
            "keyup" => Happened::KeyUp(&name),
            "focusin" => Happened::FocusIn,
            "focusout" => Happened::FocusOut,
            _ => return,
        };
        let with_shift = key.is_some_and(KeyboardEvent::shift_key);
        match answer(kind, focusable, with_shift, happened) {
            Answer::Nothing => return,
            Answer::Typing => return shown.begin_typing(),
            Answer::Done => {
                shown.finish_typing();
                self.left = Some(id);
            }
            Answer::Key => {
                if kind.is_typed() {
                    shown.finish_typing();
                }
                if let Some(key) = key {
                    self.hand_on(key);
                }
            }
            Answer::Ask(action, data) => {
                if matches!(action, Action::Increment | Action::Decrement) {
                    event.prevent_default();
                }
                self.ask(id, action, data);
            }
        }
        self.ctx.request_repaint();
    }

    /// Gives a key to egui.
    fn hand_on(&mut self, key: &KeyboardEvent) {
        let stroke = KeyStroke {
            name: key.key(),
            code: key.code(),
            pressed: key.type_() == "keydown",
            modifiers: egui::Modifiers {
                alt: key.alt_key(),
                ctrl: key.ctrl_key(),
                shift: key.shift_key(),
                mac_cmd: key.meta_key(),
                command: key.ctrl_key() || key.meta_key(),
            },
        };
        if stroke.pressed && stroke.name == "Tab" {
            // From here the canvas has the keyboard. egui's focus stays where it is until egui has gone on.
            self.focus_canvas();
        }
        if stroke.is_kept_from_the_page() {
            key.prevent_default();
        }
        self.events.append(&mut stroke.events());
    }

    /// Asks egui for an action on the widget of an element.
    fn ask(&mut self, id: NodeId, action: Action, data: Option<ActionData>) {
        let Some(shown) = self.shown.get_mut(&id) else { return };
        let kind = shown.picture.kind;
        if action == Action::Click {
            // egui closes a list only when the pointer clicks in it.
            self.chosen = matches!(kind, Kind::Item("option" | "menuitem"));
        }
        match action {
            Action::Increment | Action::Decrement => {}
            _ if kind.is_typed() => shown.begin_typing(),
            Action::Focus => {}
            // The browser has changed the element; egui may decide otherwise.
            _ => shown.forget_state(),
        }
        let mut ask = |action, data| {
            let request = ActionRequest { action, target_tree: TreeId::ROOT, target_node: id, data };
            self.events.push(egui::Event::AccessKitActionRequest(request));
        };
        let by_key = matches!(action, Action::Increment | Action::Decrement);
        if by_key || kind.is_typed() && action != Action::Focus {
            // A key has been pressed on it, so it has the focus again if Enter or Escape has taken it away.
            ask(Action::Focus, None);
        }
        ask(action, data);
    }
}

impl Drop for Page {
    fn drop(&mut self) {
        let window = web_sys::window();
        for timer in [self.timer, self.saying].into_iter().flatten() {
            if let Some(window) = &window {
                window.clear_timeout_with_handle(timer);
            }
        }
        for name in EVENTS {
            // If it can't be removed, it was never heard.
            let _ =
                self.root.remove_event_listener_with_callback(name, self.listener.as_ref().unchecked_ref());
        }
        self.root.set_text_content(None);
    }
}

/// Has the browser call back after so many milliseconds.
fn timeout(callback: &Closure<dyn FnMut()>, milliseconds: i32) -> Option<i32> {
    let callback = callback.as_ref().unchecked_ref();
    web_sys::window()?.set_timeout_with_callback_and_timeout_and_arguments_0(callback, milliseconds).ok()
}

/// Puts these into their order, touching only those out of place: a moved element loses the focus.
fn place(shown: &HashMap<NodeId, Shown>, holder: &Element, order: &[NodeId]) {
    let mut next = holder.first_element_child();
    for element in order.iter().filter_map(|id| shown.get(id)).map(|shown| &shown.element) {
        if next.as_ref() == Some(element) {
            next = element.next_element_sibling();
        } else {
            // Fails only for an element inside itself, which a tree doesn't have.
            let _ = holder.insert_before(element, next.as_deref());
        }
    }
}
