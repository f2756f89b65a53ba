//! A stand-in until the real application is in: a label and a slider in a browser canvas.

#[cfg(not(target_arch = "wasm32"))]
fn main() {
    println!("The stand-in runs in a browser: cargo xtask serve");
}

#[cfg(target_arch = "wasm32")]
fn main() {
    web::start();
}

#[cfg(target_arch = "wasm32")]
mod web {
    use std::cell::Cell;
    use std::rc::Rc;

    use eframe::egui;
    use wasm_bindgen::JsCast as _;
    use wasm_bindgen::closure::Closure;

    pub fn start() {
        std::panic::set_hook(Box::new(|panic| report_failure(&panic.to_string())));
        wasm_bindgen_futures::spawn_local(async {
            let canvas = web_sys::window()
                .and_then(|window| window.document())
                .and_then(|document| document.get_element_by_id("eigenwing"))
                .and_then(|element| element.dyn_into().ok())
                .expect("the page has a canvas named eigenwing");
            let started = eframe::WebRunner::new()
                .start(
                    canvas,
                    eframe::WebOptions::default(),
                    Box::new(|_| Ok(Box::new(StandIn::new()))),
                )
                .await;
            if let Err(error) = started {
                report_failure(&error.as_string().unwrap_or_default());
            }
        });
    }

    fn dispatch(event: &web_sys::Event) {
        if let Some(window) = web_sys::window() {
            window.dispatch_event(event).ok();
        }
    }

    fn report_failure(sentence: &str) {
        let init = web_sys::CustomEventInit::new();
        init.set_detail(&sentence.into());
        if let Ok(event) = web_sys::CustomEvent::new_with_event_init_dict("eigenwing-failed", &init)
        {
            dispatch(&event);
        }
    }

    struct StandIn {
        value: Rc<Cell<f64>>,
        frames: u32,
    }

    impl StandIn {
        fn new() -> Self {
            let value = Rc::new(Cell::new(0.5));
            let shown = Rc::clone(&value);
            let state = Closure::<dyn Fn() -> String>::new(move || {
                serde_json::json!({ "value": shown.get() }).to_string()
            });
            let handle = js_sys::Object::new();
            js_sys::Reflect::set(&handle, &"state".into(), &state.into_js_value()).ok();
            js_sys::Reflect::set(&js_sys::global(), &"eigenwing".into(), &handle).ok();
            Self { value, frames: 0 }
        }
    }

    impl eframe::App for StandIn {
        fn ui(&mut self, ui: &mut egui::Ui, _frame: &mut eframe::Frame) {
            egui::CentralPanel::default().show(ui, |ui| {
                ui.heading("Stand-in");
                let mut value = self.value.get();
                let name = ui.label("Value");
                ui.add(egui::Slider::new(&mut value, 0.0..=1.0))
                    .labelled_by(name.id);
                self.value.set(value);
            });
            self.frames += 1;
            match self.frames {
                1 => ui.request_repaint(),
                2 => {
                    if let Ok(event) = web_sys::Event::new("eigenwing-ready") {
                        dispatch(&event);
                    }
                }
                _ => {}
            }
        }
    }
}
