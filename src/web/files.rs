//! Files for the page: those of the course and lessons beside the page are fetched, a person's own are chosen or dropped.

use std::cell::RefCell;
use std::rc::Rc;

use egui::Context;
use js_sys::{Array, Function, Promise, Reflect, Uint8Array};
use wasm_bindgen::closure::Closure;
use wasm_bindgen::{JsCast as _, JsValue};
use wasm_bindgen_futures::{JsFuture, spawn_local};
use web_sys::{Blob, BlobPropertyBag, File, HtmlAnchorElement, HtmlInputElement, Response, Url};

use crate::content::{TextFile, lessons};
use crate::ui::{App, FileRequest, OwnFile};

/// Folder of the course, below that of the page.
const FOLDER: &str = "lessons";

/// What a lesson may have beside it.
const BESIDE: [&str; 2] = ["glossary.toml", "references.toml"];

/// Files that are here and that the page hasn't got yet.
#[derive(Clone, Debug, Default)]
pub struct Files {
    here: Rc<RefCell<Vec<Delivery>>>,
}

/// What has come.
#[derive(Debug)]
enum Delivery {
    /// What was asked for, and what came of it.
    Asked(FileRequest, Result<Vec<TextFile>, String>),
    /// What a person has chosen or dropped.
    Own(Result<Vec<OwnFile>, String>),
    /// What has become of a picture.
    Told(String),
}

impl Files {
    /// Gives the page what has come. Before a frame is drawn.
    pub fn deliver(&self, app: &mut App) {
        for delivery in self.here.take() {
            match delivery {
                Delivery::Asked(request, files) => app.receive(&request, files),
                Delivery::Own(files) => app.open_own_files(files),
                Delivery::Told(sentence) => app.tell(&sentence),
            }
        }
    }

    /// Begins to read what the page asks for. After a frame was drawn; when it is here there is another frame.
    pub fn fetch(&self, ctx: &Context, app: &mut App) {
        while let Some(request) = app.take_file_request() {
            let (here, ctx) = (self.here.clone(), ctx.clone());
            let deliver = move |delivery| {
                here.borrow_mut().push(delivery);
                ctx.request_repaint();
            };
            match &request {
                FileRequest::Pick => {
                    pick(deliver);
                    continue;
                }
                FileRequest::Save(file) => {
                    // A browser that forbids it has said so to the person.
                    let _ = save(file);
                    continue;
                }
                FileRequest::Print(page) => {
                    let _ = called("eigenwingPrint", &Array::of1(&page.as_str().into()));
                    continue;
                }
                FileRequest::Course
                | FileRequest::Lesson(_)
                | FileRequest::Dropped(_)
                | FileRequest::Picture { .. } => {}
            }
            spawn_local(async move {
                let files = match &request {
                    FileRequest::Course => course().await,
                    FileRequest::Lesson(path) => lesson(path).await,
                    FileRequest::Dropped(files) => return deliver(Delivery::Own(dropped(files).await)),
                    FileRequest::Picture { svg, copies } => {
                        return deliver(Delivery::Told(picture(svg, *copies).await));
                    }
                    FileRequest::Pick | FileRequest::Save(_) | FileRequest::Print(_) => return,
                };
                deliver(Delivery::Asked(request, files));
            });
        }
    }
}

async fn course() -> Result<Vec<TextFile>, String> {
    let mut files = Vec::new();
    for name in lessons::NAMES {
        files.push(text_of(&format!("{FOLDER}/{name}")).await?);
    }
    Ok(files)
}

/// A lesson and what stands beside it; without these the lesson stands alone.
async fn lesson(path: &str) -> Result<Vec<TextFile>, String> {
    let mut files = vec![text_of(path).await?];
    let folder = path.rsplit_once('/').map_or(String::new(), |(folder, _)| format!("{folder}/"));
    for name in BESIDE {
        files.extend(text_of(&format!("{folder}{name}")).await.ok());
    }
    Ok(files)
}

async fn dropped(handles: &[egui::DroppedFileHandle]) -> Result<Vec<OwnFile>, String> {
    let mut files = Vec::new();
    for handle in handles {
        let name = handle.path().to_string_lossy().into_owned();
        let bytes = handle.bytes_async().await.map_err(|_| format!("“{name}” can’t be read."))?;
        files.push(OwnFile { name, bytes: bytes.to_vec() });
    }
    Ok(files)
}

/// The text at a path below the page's folder.
async fn text_of(path: &str) -> Result<TextFile, String> {
    let name = path.rsplit('/').next().unwrap_or(path);
    let failed = |_: JsValue| format!("“{path}” can’t be fetched. Is there a connection?");
    let window = web_sys::window().ok_or_else(|| "There is no window.".to_owned())?;
    let response = JsFuture::from(window.fetch_with_str(path)).await.map_err(failed)?;
    let response: Response = response.dyn_into().map_err(failed)?;
    if !response.ok() {
        return Err(format!("There is no file “{path}” beside this page."));
    }
    let bytes = JsFuture::from(response.array_buffer().map_err(failed)?).await.map_err(failed)?;
    TextFile::from_bytes(name, &Uint8Array::new(&bytes).to_vec()).map_err(|error| format!("{error}."))
}

/// Lets the person choose files.
fn pick(deliver: impl FnOnce(Delivery) + 'static) {
    let input = web_sys::window()
        .and_then(|window| window.document())
        .and_then(|document| document.create_element("input").ok())
        .and_then(|element| element.dyn_into::<HtmlInputElement>().ok());
    let Some(input) = input else { return };
    input.set_type("file");
    input.set_multiple(true);
    let chooser = input.clone();
    let changed = Closure::once_into_js(move || {
        let list = chooser.files();
        let chosen: Vec<File> =
            list.iter().flat_map(|list| (0..list.length()).filter_map(|index| list.get(index))).collect();
        spawn_local(async move { deliver(Delivery::Own(picked(&chosen).await)) });
    });
    input.set_onchange(Some(changed.unchecked_ref()));
    input.click();
}

/// Has the browser save a file.
fn save(file: &TextFile) -> Result<(), JsValue> {
    let document = web_sys::window().and_then(|window| window.document()).ok_or("there is no document")?;
    let kind = BlobPropertyBag::new();
    let is_page = file.name.ends_with(".html");
    kind.set_type(if is_page { "text/html;charset=utf-8" } else { "text/plain;charset=utf-8" });
    let parts = js_sys::Array::of1(&file.text.as_str().into());
    let url = Url::create_object_url_with_blob(&Blob::new_with_str_sequence_and_options(&parts, &kind)?)?;
    let anchor: HtmlAnchorElement = document.create_element("a")?.dyn_into()?;
    anchor.set_href(&url);
    anchor.set_download(&file.name);
    anchor.click();
    Url::revoke_object_url(&url)
}

/// Has the browser make a picture of a figure, and save or copy it; what came of it.
async fn picture(svg: &TextFile, copies: bool) -> String {
    let name = svg.name.replace(".svg", ".png");
    let args = Array::of3(&name.as_str().into(), &svg.text.as_str().into(), &copies.into());
    let made = match called("eigenwingPicture", &args).and_then(|made| made.dyn_into::<Promise>()) {
        Ok(promise) => JsFuture::from(promise).await,
        Err(error) => Err(error),
    };
    made.ok().and_then(|said| said.as_string()).unwrap_or_else(|| format!("⚠ {name} can’t be drawn"))
}

/// Calls a function of web/page.js.
fn called(name: &str, args: &Array) -> Result<JsValue, JsValue> {
    let function: Function = Reflect::get(&js_sys::global(), &name.into())?.dyn_into()?;
    function.apply(&JsValue::NULL, args)
}

async fn picked(chosen: &[File]) -> Result<Vec<OwnFile>, String> {
    let mut files = Vec::new();
    for file in chosen {
        let failed = |_: JsValue| format!("“{}” can’t be read.", file.name());
        let bytes = JsFuture::from(file.array_buffer()).await.map_err(failed)?;
        files.push(OwnFile { name: file.name(), bytes: Uint8Array::new(&bytes).to_vec() });
    }
    Ok(files)
}
