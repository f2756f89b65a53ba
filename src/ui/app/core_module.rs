//! What the page asks of the core as a module of its own: writers and readers of files that few visitors need. A browser loads it
//! when the first is asked; elsewhere it is a part of the program and answers at once.

use super::App;
#[cfg(not(target_arch = "wasm32"))]
use crate::export::json;

/// A file as it comes from a person.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OwnFile {
    /// Its name, without a folder.
    pub name: String,
    /// What is in it.
    pub bytes: Vec<u8>,
}

/// Something that the core is asked. It answers with JSON: see `docs/JAVASCRIPT.md`.
#[derive(Clone, Debug)]
pub enum CoreRequest {
    /// `takeAlong`.
    TakeAlong {
        /// The request.
        request: String,
        /// The how manieth it is: an answer to an older one is out of date.
        number: u64,
    },
    /// The same, to be printed.
    Print(String),
    /// `readFile`.
    ReadFile {
        /// The file.
        file: OwnFile,
        /// The mass file beside it.
        mass: Option<OwnFile>,
        /// What was typed into the fields of its review, as JSON.
        fills: String,
        /// The how manieth question about files it is: an answer to an older one is out of date.
        number: u64,
    },
}

impl App {
    /// What is to be asked for the page next.
    pub fn take_core_request(&mut self) -> Option<CoreRequest> {
        self.panes.core_requests.pop()
    }

    /// Takes an answer of the core, or the sentence that says why there is none.
    pub fn answer(&mut self, request: &CoreRequest, answer: Result<String, String>) {
        match request {
            CoreRequest::TakeAlong { number, .. } => self.take(*number, answer),
            CoreRequest::Print(_) => self.take_page(answer),
            CoreRequest::ReadFile { number, .. } => self.take_review(*number, answer),
        }
    }

    pub(super) fn ask(&mut self, request: CoreRequest) {
        #[cfg(target_arch = "wasm32")]
        self.panes.core_requests.push(request);
        #[cfg(not(target_arch = "wasm32"))]
        {
            let answer = match &request {
                CoreRequest::TakeAlong { request, .. } | CoreRequest::Print(request) => {
                    json::take_along(request)
                }
                CoreRequest::ReadFile { file, mass, fills, .. } => {
                    let mass = mass.as_ref().map(|mass| mass.bytes.as_slice());
                    json::read_file(&file.name, &file.bytes, fills, mass)
                }
            };
            self.answer(&request, answer.map_err(|error| error.to_string()));
        }
    }
}
