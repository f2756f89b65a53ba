//! The whole aircraft in a link: the text of its file, deflated (RFC 1951) and written in the letters of base64url without padding
//! (RFC 4648). It comes back as the same text, so the aircraft is the same to the last bit.

use base64::Engine as _;
use base64::engine::general_purpose::URL_SAFE_NO_PAD;
use miniz_oxide::deflate::compress_to_vec;
use miniz_oxide::inflate::decompress_to_vec_with_limit;

use crate::content::Aircraft;

/// Most characters that an aircraft may take in a link; address bars and messages cut longer links.
pub const LONGEST_OWN: usize = 6000;

/// Longest text that is unpacked \[bytes\]: a short link could hold very much of the same.
const LONGEST_TEXT: usize = 1 << 18;

/// Hardest that is compressed.
const LEVEL: u8 = 10;

/// The aircraft as it is written in a link; `None` for one of those that ship, and where it is too long.
pub fn written(aircraft: &Aircraft) -> Option<String> {
    let packed = URL_SAFE_NO_PAD.encode(compress_to_vec(aircraft.own.as_ref()?.as_bytes(), LEVEL));
    (packed.len() <= LONGEST_OWN).then_some(packed)
}

/// Whether a link has room for an aircraft: it ships, or is short enough.
pub fn has_room(aircraft: &Aircraft) -> bool {
    aircraft.own.is_none() || written(aircraft).is_some()
}

/// The aircraft of a link, or what is wrong with it.
pub(super) fn read(packed: &str) -> Result<Aircraft, String> {
    let damaged = || "a part of it is missing or was changed".to_owned();
    // A link at the end of a sentence.
    let packed = packed.trim_end_matches(['.', ',', ')', '>', '=', ' ']);
    let bytes = URL_SAFE_NO_PAD.decode(packed).map_err(|_| damaged())?;
    let text = decompress_to_vec_with_limit(&bytes, LONGEST_TEXT).map_err(|_| damaged())?;
    let text = String::from_utf8(text).map_err(|_| damaged())?;
    Aircraft::own("link", &text).map_err(|error| error.to_string())
}
