//! Keys: the names of values for programs, in files, links, requests, answers and ids of widgets. A key never changes once it is
//! published; the words that a person reads for the same value stand elsewhere and may.

/// A value out of a list whose members have keys. Written with `keys!`.
pub trait Keyed: Copy + PartialEq + 'static {
    /// The list, in the order in which it is shown.
    const VALUES: &'static [Self];

    /// The key of this value.
    fn key(self) -> &'static str;

    /// Other spellings of the key that were published too: they are read, never written.
    fn aliases(self) -> &'static [&'static str];

    /// How links spell it: the key, in small letters.
    fn in_links(self) -> String {
        self.key().to_lowercase()
    }

    /// The value of a key or another spelling of it. Case doesn't matter, nor what stands between letters and digits, so that a
    /// name in words is read as well: "Dutch roll, less stable root" for `dutch-roll-less-stable-root`.
    fn by_key(text: &str) -> Option<Self> {
        let wanted = hyphenated(text);
        let is_spelt_so = |value: &Self| {
            std::iter::once(value.key())
                .chain(value.aliases().iter().copied())
                .any(|key| hyphenated(key) == wanted)
        };
        Self::VALUES.iter().copied().find(is_spelt_so)
    }
}

/// Small letters and digits, with one hyphen for whatever is between them.
fn hyphenated(text: &str) -> String {
    let words = text.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty());
    words.map(str::to_lowercase).collect::<Vec<_>>().join("-")
}

/// The name most like a misspelt one, if any is like it.
pub(crate) fn nearest<'n>(name: &str, names: impl Iterator<Item = &'n str>) -> Option<String> {
    let likeness = |other: &str| strsim::jaro_winkler(&name.to_lowercase(), other);
    names
        .map(|other| (likeness(other), other))
        .filter(|(likeness, _)| *likeness > 0.75)
        .max_by(|x, y| x.0.total_cmp(&y.0))
        .map(|(_, other)| other.to_owned())
}

/// Gives an enum its keys: `Variant => "key"`, or `"key" | "other spelling"`, a line for every variant in the order of the list.
macro_rules! keys {
    ($type:ty { $($variant:ident => $key:literal $(| $alias:literal)*,)+ }) => {
        impl $crate::key::Keyed for $type {
            const VALUES: &'static [Self] = &[$(Self::$variant),+];

            fn key(self) -> &'static str {
                match self {
                    $(Self::$variant => $key,)+
                }
            }

            fn aliases(self) -> &'static [&'static str] {
                match self {
                    $(Self::$variant => &[$($alias),*],)+
                }
            }
        }
    };
}

pub(crate) use keys;

#[cfg(test)]
mod tests {
    use super::*;

    #[derive(Clone, Copy, Debug, PartialEq)]
    enum Air {
        Rising,
        Ahead,
    }

    keys! {
        Air {
            Rising => "rising-air" | "gust" | "up draught",
            Ahead => "air-ahead",
        }
    }

    #[test]
    fn a_value_is_found_by_every_spelling_and_by_no_part_of_one() {
        for text in ["rising-air", "gust", "Rising air", "RISING_AIR", "up-draught"] {
            assert_eq!(Air::by_key(text), Some(Air::Rising), "{text}");
        }
        for text in ["rising", "", "-", "air", "rising-air-ahead"] {
            assert_eq!(Air::by_key(text), None, "{text}");
        }
    }

    #[test]
    fn links_write_the_key_whatever_other_spellings_there_are() {
        assert_eq!([Air::Rising, Air::Ahead].map(Keyed::in_links), ["rising-air", "air-ahead"]);
    }
}
