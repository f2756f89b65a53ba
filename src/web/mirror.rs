//! The page for those who can't see a canvas: what egui draws, once more as real elements.
//!
//! egui describes each frame as an [AccessKit](accesskit) tree, which eframe drops in a browser. This plugin mirrors
//! the tree into `<div id="mirror">`, a transparent layer over the canvas, and hands what happens to those elements
//! back to egui. It serves screen readers, and browser tests, which find a slider by its name.
//!
//! ```text
//! egui ── output_hook ──► tree ──► elements ──► screen reader
//!   ▲                                             │
//!   └── input_hook ◄── action requests ◄── events ┘
//! ```
//!
//! * Elements persist, keyed by node, and only what changed is written: a focused one stays focused.
//! * They stand in the order of the tree, at the bounds of what they mirror. Roles that hold others (region, group,
//!   dialog, list box …) become elements around them; panels and rows without a name leave no trace.
//! * The keyboard stays with the canvas (`tabindex="-1"`). Something that focuses an element focuses egui's widget.
//!   What the keyboard reaches or changes on the canvas is announced, for the browser's own focus stays on the canvas.
//! * While an element has the browser's focus, egui has the page's, and gets the keys that the element has no use for: the
//!   canvas hears none of them. Tab, or the end of the element, gives the browser's focus back to the canvas.
//! * While frames come fast, egui makes a tree ten times a second only; after the last frame it makes one more.
//!
//! The page brings two elements and this style. Without `#mirror` the plugin does nothing.
//!
//! ```css
//! #mirror { position: absolute; inset: 0; overflow: hidden; pointer-events: none; }
//! #mirror [data-id]:not([data-holds]) { position: absolute; margin: 0; padding: 0; border: 0; overflow: hidden;
//!     box-sizing: border-box; opacity: 0; white-space: nowrap; pointer-events: none; }
//! #announcements { position: absolute; width: 1px; height: 1px; overflow: hidden; clip-path: inset(50%); }
//! ```
//! ```html
//! <div id="mirror"></div>
//! <div id="announcements" aria-live="polite"></div>
//! ```

mod element;
mod typed;

use std::cell::RefCell;
use std::collections::{HashMap, HashSet};
use std::mem;

use egui::accesskit::{self, Action, ActionData, ActionRequest, Node, NodeId, Role, TreeUpdate};
use wasm_bindgen::JsCast as _;
use wasm_bindgen::closure::Closure;
use web_sys::{Document, Element, Event, FocusOptions, HtmlElement, HtmlInputElement, KeyboardEvent};

use element::{Kind, Picture, Shown};

/// While frames come faster than this, egui doesn't make a tree for each.
const INTERVAL_MS: i32 = 100;

/// Heard at the root, for all elements in it.
const EVENTS: [&str; 7] = ["click", "input", "change", "keydown", "keyup", "focusin", "focusout"];

/// Add it with `ctx.add_plugin(Mirror)`.
#[derive(Clone, Copy, Debug, Default)]
pub struct Mirror;

thread_local! {
    // Not in the plugin: egui wants plugins to be `Send`, and elements belong to their thread.
    static PAGE: RefCell<Option<Page>> = const { RefCell::new(None) };
}

impl egui::Plugin for Mirror {
    fn debug_name(&self) -> &'static str {
        "accessibility mirror"
    }

    fn setup(&mut self, ctx: &egui::Context) {
        let page = Page::find(ctx);
        if page.is_some() {
            ctx.enable_accesskit();
        }
        PAGE.set(page);
    }

    fn on_exit(&mut self, _ctx: &egui::Context) {
        PAGE.set(None);
    }

    fn input_hook(&mut self, ctx: &egui::Context, input: &mut egui::RawInput) {
        with_page(|page| page.pass_on(ctx, input));
    }

    fn output_hook(&mut self, ctx: &egui::Context, output: &mut egui::FullOutput) {
        let tree = output.platform_output.accesskit_update.take();
        with_page(|page| match tree {
            Some(tree) => page.receive(&tree, f64::from(ctx.zoom_factor())),
            None => page.missed = true,
        });
    }
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
    /// What has egui's focus, and its value: the last that was announced.
    told: (NodeId, String),
    /// Of all [`EVENTS`]; what it does may cause another of them.
    listener: Closure<dyn Fn(Event)>,
    on_timer: Closure<dyn FnMut()>,
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
            listener,
            on_timer,
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
            self.timer = web_sys::window().and_then(|window| {
                let callback = self.on_timer.as_ref().unchecked_ref();
                window.set_timeout_with_callback_and_timeout_and_arguments_0(callback, INTERVAL_MS).ok()
            });
        }
        if self.timer.is_some() {
            self.ctx.disable_accesskit();
        }
    }

    fn resume(&mut self) {
        self.timer = None;
        self.ctx.enable_accesskit();
        if mem::take(&mut self.missed) {
            // The page shows an older frame than the canvas.
            self.ctx.request_repaint();
        }
    }

    fn write(&mut self, update: &TreeUpdate, zoom: f64) {
        let Some(root) = update.tree.as_ref().map(|tree| tree.root) else {
            return;
        };
        let mut tree = Tree {
            nodes: update.nodes.iter().map(|(id, node)| (*id, node)).collect(),
            zoom,
            seen: HashSet::new(),
            orders: Vec::new(),
        };
        let mut children = Vec::new();
        let had_focus = self.has_browser_focus();
        self.write_node(&mut tree, root, None, &mut children);
        // Those gone leave first, so that none of those that stay has to be moved, which would lose it the focus.
        self.shown.retain(|id, shown| {
            let stays = tree.seen.contains(id);
            if !stays {
                shown.element.remove();
            }
            stays
        });
        for (holder, children) in tree.orders {
            if let Some(shown) = self.shown.get(&holder).filter(|shown| shown.children != children) {
                place(&self.shown, &shown.element, &children);
            }
            if let Some(shown) = self.shown.get_mut(&holder) {
                shown.children = children;
            }
        }
        if self.children != children {
            place(&self.shown, &self.root, &children);
            self.children = children;
        }
        if had_focus && !self.has_browser_focus() {
            // What had it is gone, and keys would reach nobody. eframe sees that the canvas has it in the next frame.
            self.focus_canvas();
            self.ctx.request_repaint();
        }
        self.announce_focus(update.focus);
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
        let told = mem::replace(&mut self.told, (focus, value.clone()));
        if on_element || pressed || name.is_empty() {
            return;
        }
        if told.0 != focus {
            announce(&format!("{name}, {value}"));
        } else if told.1 != value {
            announce(&value);
        }
    }

    /// Brings the element of this node up to date, if it has one, and names it in `siblings`; then those inside it.
    fn write_node(
        &mut self,
        tree: &mut Tree<'_>,
        id: NodeId,
        holder: Option<Kind>,
        siblings: &mut Vec<NodeId>,
    ) {
        let Some(&node) = tree.nodes.get(&id) else {
            return;
        };
        if node.is_hidden() || node.role() == Role::TextRun || tree.seen.contains(&id) {
            return;
        }
        let Some(picture) = Picture::of(node, holder, &tree.name(node), tree.zoom) else {
            for &child in node.children() {
                self.write_node(tree, child, holder, siblings);
            }
            return;
        };
        let kind = picture.kind;
        tree.seen.insert(id);
        siblings.push(id);
        match self.shown.get_mut(&id) {
            Some(shown) if shown.picture.kind.tag() == kind.tag() => shown.update(picture),
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
        if kind.holds() {
            let mut children = Vec::new();
            for &child in node.children() {
                self.write_node(tree, child, Some(kind), &mut children);
            }
            tree.orders.push((id, children));
        } else {
            // What lies inside a widget comes after it.
            for &child in node.children() {
                self.write_node(tree, child, holder, siblings);
            }
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
        let kind = shown.picture.kind;
        if let Some(key) = event.dyn_ref::<KeyboardEvent>()
            && !kind.uses_key(&key.key())
        {
            if kind.is_typed() {
                shown.finish_typing();
            }
            if key.key() == "Tab" && event.type_() == "keydown" {
                // From here the canvas has the keyboard. egui's focus stays where it is until egui has gone on.
                self.focus_canvas();
            }
            typed::hear(key, &mut self.events);
            return self.ctx.request_repaint();
        }
        let is_enter = || event.dyn_ref::<KeyboardEvent>().is_some_and(|key| key.key() == "Enter");
        let ends = match event.type_().as_str() {
            "focusout" => true,
            "change" => kind.is_typed(),
            "keydown" => kind.is_typed() && is_enter(),
            _ => false,
        };
        if ends {
            // As Enter or Tab would do in egui: what was typed counts from here.
            shown.finish_typing();
            self.left = Some(id);
            return self.ctx.request_repaint();
        }
        let typed = || element.dyn_ref::<HtmlInputElement>().map(HtmlInputElement::value).unwrap_or_default();
        let (action, data) = match (event.type_().as_str(), kind) {
            ("focusin", kind) if shown.picture.focusable => {
                if kind.is_typed() {
                    shown.begin_typing();
                }
                (Action::Focus, None)
            }
            ("click", kind) if kind.is_pressed() => {
                // egui closes a list only when the pointer clicks in it.
                self.chosen = matches!(kind, Kind::Item("option" | "menuitem"));
                (Action::Click, None)
            }
            // The widget knows its steps; the browser would take a hundredth of the range.
            ("keydown", Kind::Slider) => {
                match event.dyn_ref::<KeyboardEvent>().map(KeyboardEvent::key).as_deref() {
                    Some("ArrowRight" | "ArrowUp") => (Action::Increment, None),
                    Some("ArrowLeft" | "ArrowDown") => (Action::Decrement, None),
                    _ => return,
                }
            }
            ("input", Kind::Slider | Kind::SpinButton) => match number(&typed()) {
                Some(number) => (Action::SetValue, Some(ActionData::NumericValue(number))),
                None => return shown.begin_typing(),
            },
            ("input", Kind::Text) => (Action::SetValue, Some(ActionData::Value(typed().into()))),
            _ => return,
        };
        match action {
            Action::Focus => {}
            Action::Increment | Action::Decrement => event.prevent_default(),
            _ if kind.is_typed() => shown.begin_typing(),
            // The browser has changed the element; egui may decide otherwise.
            _ => shown.forget_state(),
        }
        let target_tree = accesskit::TreeId::ROOT;
        let mut ask = |action, data| {
            let request = ActionRequest { action, target_tree, target_node: id, data };
            self.events.push(egui::Event::AccessKitActionRequest(request));
        };
        let by_key = matches!(action, Action::Increment | Action::Decrement);
        if by_key || kind.is_typed() && action != Action::Focus {
            // A key has been pressed on it, so it has the focus again if Enter or Escape has taken it away.
            ask(Action::Focus, None);
        }
        ask(action, data);
        self.ctx.request_repaint();
    }
}

impl Drop for Page {
    fn drop(&mut self) {
        if let (Some(timer), Some(window)) = (self.timer, web_sys::window()) {
            window.clear_timeout_with_handle(timer);
        }
        for name in EVENTS {
            // If it can't be removed, it was never heard.
            let _ =
                self.root.remove_event_listener_with_callback(name, self.listener.as_ref().unchecked_ref());
        }
        self.root.set_text_content(None);
    }
}

/// What a person typed: `−0.68`, or `42.5 kg` with its unit.
fn number(typed: &str) -> Option<f64> {
    typed.split_whitespace().next()?.replace('−', "-").parse().ok()
}

/// One frame's description.
struct Tree<'a> {
    nodes: HashMap<NodeId, &'a Node>,
    /// CSS pixels a point.
    zoom: f64,
    seen: HashSet<NodeId>,
    /// What each element holds, in order.
    orders: Vec<(NodeId, Vec<NodeId>)>,
}

impl Tree<'_> {
    /// The accessible name: its own, or those of its labels.
    fn name(&self, node: &Node) -> String {
        if let Some(label) = node.label() {
            return label.to_owned();
        }
        let labels = node.labelled_by().iter().filter_map(|id| self.nodes.get(id));
        let names: Vec<&str> = labels.filter_map(|label| label.value().or(label.label())).collect();
        names.join(" ")
    }
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
