//! The core as a JavaScript module: `list`, `parameters`, `measures`, `analyse`, `respond`, `frequency`, `sweep`, `link` and `takeAlong`
//! on plain objects.
//!
//! `cargo xtask build` makes `dist/core/eigenwing-core.js`, its `.wasm` and its types; `docs/JAVASCRIPT.md` shows how to use them.
//! Requests and answers go through JSON, which keeps every bit of a number.

// The program itself does nothing: a page calls its exports.
fn main() {}

#[cfg(target_arch = "wasm32")]
mod exports {
    use eigenwing::export::{ExportError, json};
    use js_sys::{Error, JSON};
    use wasm_bindgen::JsValue;
    use wasm_bindgen::prelude::wasm_bindgen;

    // The types that the signatures below name; `src/export/typescript.rs` writes them.
    #[wasm_bindgen(typescript_custom_section)]
    const TYPES: &str = include_str!("types.d.ts");

    /// The aircraft of the list.
    #[wasm_bindgen(unchecked_return_type = "Aircraft[]")]
    pub fn list() -> Result<JsValue, JsValue> {
        read(json::list())
    }

    /// The parameters that can be set on an aircraft or swept.
    #[wasm_bindgen(unchecked_return_type = "Parameter[]")]
    pub fn parameters(
        #[wasm_bindgen(unchecked_param_type = "Subject")] request: JsValue,
    ) -> Result<JsValue, JsValue> {
        read(json::parameters(&written(&request)?))
    }

    /// What can be read of an aircraft, by key.
    #[wasm_bindgen(unchecked_return_type = "Measure[]")]
    pub fn measures(
        #[wasm_bindgen(unchecked_param_type = "Subject")] request: JsValue,
    ) -> Result<JsValue, JsValue> {
        read(json::measures(&written(&request)?))
    }

    /// Everything that follows for an aircraft: matrices, eigenvalues, named modes, verdicts, approximations.
    #[wasm_bindgen(unchecked_return_type = "Analysis")]
    pub fn analyse(
        #[wasm_bindgen(unchecked_param_type = "Subject")] request: JsValue,
    ) -> Result<JsValue, JsValue> {
        read(json::analyse(&written(&request)?))
    }

    /// The motion after a disturbance.
    #[wasm_bindgen(unchecked_return_type = "Motion")]
    pub fn respond(
        #[wasm_bindgen(unchecked_param_type = "Subject & ResponseRequest")] request: JsValue,
    ) -> Result<JsValue, JsValue> {
        read(json::respond(&written(&request)?))
    }

    /// Gain and phase over frequency.
    #[wasm_bindgen(unchecked_return_type = "FrequencyResponse")]
    pub fn frequency(
        #[wasm_bindgen(unchecked_param_type = "Subject & FrequencyRequest")] request: JsValue,
    ) -> Result<JsValue, JsValue> {
        read(json::frequency(&written(&request)?))
    }

    /// The modes along a range of one parameter.
    #[wasm_bindgen(unchecked_return_type = "Sweep")]
    pub fn sweep(
        #[wasm_bindgen(unchecked_param_type = "Subject & SweepRequest")] request: JsValue,
    ) -> Result<JsValue, JsValue> {
        read(json::sweep(&written(&request)?))
    }

    /// A scene of the page as a link.
    #[wasm_bindgen(unchecked_return_type = "Link")]
    pub fn link(
        #[wasm_bindgen(unchecked_param_type = "Subject & DisturbanceRequest & { address?: string }")] request: JsValue,
    ) -> Result<JsValue, JsValue> {
        read(json::link(&written(&request)?))
    }

    /// A scene in another program's form: a script, a file, data or a figure.
    #[wasm_bindgen(js_name = takeAlong, unchecked_return_type = "TakenAlong")]
    pub fn take_along(
        #[wasm_bindgen(unchecked_param_type = "Subject & DisturbanceRequest & { target: Target }")]
        request: JsValue,
    ) -> Result<JsValue, JsValue> {
        read(json::take_along(&written(&request)?))
    }

    /// What is in a file of another program or of matrices: what was read as what, what is missing, what looks wrong, and the
    /// aircraft as the text of an aircraft file, once nothing is missing. `fills` is what a person has typed into the fields,
    /// `mass` AVL's mass file beside its derivatives.
    #[wasm_bindgen(js_name = readFile, unchecked_return_type = "FileReview")]
    pub fn read_file(
        name: &str,
        bytes: &[u8],
        #[wasm_bindgen(unchecked_param_type = "Record<string, string> | undefined")] fills: JsValue,
        #[wasm_bindgen(unchecked_param_type = "Uint8Array | undefined")] mass: Option<Vec<u8>>,
    ) -> Result<JsValue, JsValue> {
        let fills = if fills.is_undefined() { "{}".to_owned() } else { written(&fills)? };
        read(json::read_file(name, bytes, &fills, mass.as_deref()))
    }

    /// A request as JSON text.
    fn written(request: &JsValue) -> Result<String, JsValue> {
        let text = JSON::stringify(request)?.as_string();
        text.ok_or_else(|| Error::new("expected a request such as { aircraft: \"navion\" }").into())
    }

    /// An answer as an object, or an `Error` with its sentence.
    fn read(answer: Result<String, ExportError>) -> Result<JsValue, JsValue> {
        JSON::parse(&answer.map_err(|error| Error::new(&error.to_string()))?)
    }
}
