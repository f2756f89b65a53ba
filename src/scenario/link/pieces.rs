//! A link in its pieces: what stands between the `&`, each taken once.

use percent_encoding::percent_decode_str;

use super::super::{Parameter, ValueError};
use super::notice::{Notice, quoted};
use super::own::LONGEST_OWN;
use super::words;
use crate::flight::aircraft::plane::Plane;
use crate::key::{Keyed, nearest};

/// Longer links are cut \[characters\]. Every link that is written is shorter: one with an aircraft of a person's own in the scene and
/// another in the pinned state, every number of both edited, and a lesson with a name behind it.
pub const LONGEST: usize = 10_000 + 2 * LONGEST_OWN;

/// Before the point in the keys of gains.
const GAIN: &str = "k.";

/// The words of a list, which are joined by points; the point in the key of a gain joins nothing.
fn words_of_list(text: &str) -> impl Iterator<Item = &str> {
    let mut rest = Some(text);
    std::iter::from_fn(move || {
        let text = rest?;
        let of_key = if text.starts_with(GAIN) { GAIN.len() } else { 0 };
        let end = text[of_key..].find('.').map(|at| of_key + at);
        rest = end.map(|end| &text[end + 1..]);
        Some(end.map_or(text, |end| &text[..end]))
    })
}

/// Keys and values of a link that have not been taken yet, and what was found wrong.
pub(super) struct Pieces {
    rest: Vec<(String, String)>,
    pub notices: Vec<Notice>,
}

impl Pieces {
    /// Splits a link. Of a whole address it takes what follows the `#`.
    pub fn split(link: &str) -> Self {
        let link = link.trim();
        let link = link.split_once('#').map_or(link, |(_, fragment)| fragment);
        let mut pieces = Self { rest: Vec::new(), notices: Vec::new() };
        let mut end = link.len();
        if let Some((at, _)) = link.char_indices().nth(LONGEST) {
            end = at;
            pieces.notices.push(Notice::TooLong);
        }
        for piece in link[..end].split('&').filter(|piece| !piece.is_empty()) {
            // A link out of the text of a web page has its & written as &amp;.
            let piece = piece.strip_prefix("amp;").unwrap_or(piece);
            let (key, value) = piece.split_once('=').unwrap_or((piece, ""));
            let [key, value] =
                [key, value].map(|text| percent_decode_str(text).decode_utf8_lossy().into_owned());
            let key = in_short(key);
            let before = pieces.rest.len();
            pieces.rest.retain(|(other, _)| *other != key);
            let told = Notice::Twice { key: quoted(&key) };
            if pieces.rest.len() < before && !pieces.notices.contains(&told) {
                pieces.notices.push(told);
            }
            pieces.rest.push((key, value));
        }
        pieces
    }

    /// The value of a key.
    pub fn take(&mut self, key: &str) -> Option<String> {
        let at = self.rest.iter().position(|(other, _)| other == key)?;
        Some(self.rest.remove(at).1)
    }

    /// The value that the word of a key stands for.
    pub fn take_word<T: Copy>(&mut self, key: &str, words: &[(&str, T)]) -> Option<T> {
        self.take_as(key, |word| words::meaning_of(words, word))
    }

    /// The value of a key as `read` understands it; one that it doesn't is left out and told.
    pub fn take_as<T>(&mut self, key: &str, read: impl Fn(&str) -> Option<T>) -> Option<T> {
        let word = self.take(key)?;
        let meant = read(&word);
        if meant.is_none() {
            self.notices.push(Notice::Word { key: quoted(key), word: quoted(&word) });
        }
        meant
    }

    /// The values of a key that are joined by points, as `read` understands each. With one that it doesn't the list is left out,
    /// and told with the word of `known` that is most like it.
    pub fn take_list<T>(&mut self, key: &str, known: &[&str], read: impl Fn(&str) -> Option<T>) -> Vec<T> {
        let Some(text) = self.take(key) else { return Vec::new() };
        let mut values = Vec::new();
        for word in words_of_list(&text) {
            let Some(value) = read(word) else {
                let nearest = nearest(word, known.iter().copied());
                let [list, word] = [&text, word].map(quoted);
                self.notices.push(Notice::WordOfList { key: quoted(key), list, word, nearest });
                return Vec::new();
            };
            values.push(value);
        }
        values
    }

    /// A parameter's value; one that is refused becomes a notice.
    pub fn accept(
        &mut self,
        key: &str,
        parameter: &Parameter,
        checked: Result<f64, ValueError>,
    ) -> Option<f64> {
        checked
            .map_err(|error| {
                let (key, name) = (key.to_owned(), parameter.name);
                self.notices.push(Notice::Value { key, name, error });
            })
            .ok()
    }

    /// Whether any key begins so.
    pub fn has_prefix(&self, prefix: &str) -> bool {
        self.rest.iter().any(|(key, _)| key.starts_with(prefix))
    }

    /// Whether there is a key beside these.
    pub fn has_other_than(&self, keys: &[&str]) -> bool {
        self.rest.iter().any(|(key, _)| !keys.contains(&key.as_str()))
    }

    /// The notices of what was found wrong, and of what is left over.
    pub fn finish(mut self) -> Vec<Notice> {
        let unknown = self.rest.iter().map(|(key, _)| Notice::Unknown { key: quoted(key) });
        self.notices.extend(unknown);
        self.notices
    }
}

/// A key with its plane in short: `lon.source` for `longitudinal.source`.
fn in_short(key: String) -> String {
    let Some((plane, rest)) = key.split_once('.') else { return key };
    Plane::by_key(plane).map_or_else(|| key.clone(), |plane| format!("{}.{rest}", plane.short()))
}
