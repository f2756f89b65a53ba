//! The core as a module of its own, `core/eigenwing-core.js` beside the page: readers and writers of files that few visitors need.
//! `eigenwingCore` of web/page.js loads it when the first is asked for.

use std::cell::RefCell;
use std::rc::Rc;

use egui::Context;
use js_sys::{Array, Error, Function, JSON, Promise, Reflect, Uint8Array};
use wasm_bindgen::{JsCast as _, JsValue};
use wasm_bindgen_futures::{JsFuture, spawn_local};

use crate::ui::{App, CoreRequest};

/// Name of the function on `window`.
const FUNCTION: &str = "eigenwingCore";

/// What was asked, and the answer or why there is none.
type Answered = (CoreRequest, Result<String, String>);

/// Answers that are here and that the page hasn't got yet.
#[derive(Clone, Debug, Default)]
pub struct CoreModule {
    here: Rc<RefCell<Vec<Answered>>>,
}

impl CoreModule {
    /// Gives the page what has come. Before a frame is drawn.
    pub fn deliver(&self, app: &mut App) {
        for (request, answer) in self.here.take() {
            app.answer(&request, answer);
        }
    }

    /// Asks what the page asks for. After a frame was drawn; when the answer is here there is another frame.
    pub fn ask(&self, ctx: &Context, app: &mut App) {
        while let Some(request) = app.take_core_request() {
            let (here, ctx) = (self.here.clone(), ctx.clone());
            spawn_local(async move {
                let answer = answer(&request).await.map_err(sentence);
                here.borrow_mut().push((request, answer));
                ctx.request_repaint();
            });
        }
    }
}

async fn answer(request: &CoreRequest) -> Result<String, JsValue> {
    let args = match request {
        CoreRequest::TakeAlong { request, .. } | CoreRequest::Print(request) => {
            Array::of2(&"takeAlong".into(), &JSON::parse(request)?)
        }
        CoreRequest::ReadFile { file, mass, fills, .. } => {
            let bytes = Uint8Array::from(file.bytes.as_slice());
            let args =
                Array::of4(&"readFile".into(), &file.name.as_str().into(), &bytes, &JSON::parse(fills)?);
            if let Some(mass) = mass {
                args.push(&Uint8Array::from(mass.bytes.as_slice()));
            }
            args
        }
    };
    let function: Function = Reflect::get(&js_sys::global(), &FUNCTION.into())?.dyn_into()?;
    let promise: Promise = function.apply(&JsValue::NULL, &args)?.dyn_into()?;
    let json = JsFuture::from(promise).await?;
    json.as_string().ok_or_else(|| "The answer is no text.".into())
}

/// What an error says.
fn sentence(error: JsValue) -> String {
    let said =
        error.dyn_ref::<Error>().map(|error| String::from(error.message())).or_else(|| error.as_string());
    said.unwrap_or_else(|| "The browser gave no reason.".to_owned())
}
