//! Bytes as text: UTF-8, UTF-16 of either order, and Windows-1252, which old Windows programs write.
//!
//! A crate for all encodings of the web carries tables of 190 kB for it; these are three of them.

use std::borrow::Cow;

/// An encoding that was not plain UTF-8, as it is told.
type Name = &'static str;

/// The characters 0x80 to 0x9F of Windows-1252; the five that it leaves out are shown as what they are not (WHATWG, index-windows-1252).
const WINDOWS_1252: [char; 32] = [
    '€', '\u{fffd}', '‚', 'ƒ', '„', '…', '†', '‡', 'ˆ', '‰', 'Š', '‹', 'Œ', '\u{fffd}', 'Ž', '\u{fffd}',
    '\u{fffd}', '‘', '’', '“', '”', '•', '–', '—', '˜', '™', 'š', '›', 'œ', '\u{fffd}', 'ž', 'Ÿ',
];

/// The text of a file and how it was encoded; `None` where it is no text.
pub(crate) fn decode(bytes: &[u8]) -> Option<(Cow<'_, str>, Option<Name>)> {
    if let Some(rest) = bytes.strip_prefix(&[0xff, 0xfe]) {
        return Some((utf16(rest, u16::from_le_bytes).into(), Some("UTF-16")));
    }
    if let Some(rest) = bytes.strip_prefix(&[0xfe, 0xff]) {
        return Some((utf16(rest, u16::from_be_bytes).into(), Some("UTF-16")));
    }
    let bytes = bytes.strip_prefix(&[0xef, 0xbb, 0xbf]).unwrap_or(bytes);
    let zeros =
        |first: usize| bytes.iter().skip(first).step_by(2).take(200).filter(|&&byte| byte == 0).count();
    // Latin text has every other byte zero.
    match (zeros(0), zeros(1)) {
        (0, 0) => {}
        (even, odd) if odd > 8 && even == 0 => {
            return Some((utf16(bytes, u16::from_le_bytes).into(), Some("UTF-16")));
        }
        (even, odd) if even > 8 && odd == 0 => {
            return Some((utf16(bytes, u16::from_be_bytes).into(), Some("UTF-16")));
        }
        _ => return None,
    }
    if let Ok(text) = std::str::from_utf8(bytes) {
        return Some((text.into(), None));
    }
    // Control characters beside those of lines and tabs are of no text.
    if bytes.iter().any(|byte| *byte < 0x20 && !matches!(byte, b'\t' | b'\n' | b'\r' | 0x0c | 0x1a)) {
        return None;
    }
    let character = |&byte: &u8| match byte {
        0x80..=0x9f => WINDOWS_1252[usize::from(byte - 0x80)],
        _ => char::from(byte),
    };
    Some((bytes.iter().map(character).collect::<String>().into(), Some("Windows-1252")))
}

fn utf16(bytes: &[u8], unit: impl Fn([u8; 2]) -> u16) -> String {
    let units = bytes.chunks_exact(2).map(|pair| unit([pair[0], pair[1]]));
    char::decode_utf16(units).map(|c| c.unwrap_or('\u{fffd}')).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_text_is_read_in_each_of_its_encodings() {
        let text = "Ângulo α = −1 … 50 €\n";
        let units = || text.encode_utf16();
        let little: Vec<u8> = [0xff, 0xfe].into_iter().chain(units().flat_map(u16::to_le_bytes)).collect();
        let big: Vec<u8> = [0xfe, 0xff].into_iter().chain(units().flat_map(u16::to_be_bytes)).collect();
        let marked = format!("\u{feff}{text}").into_bytes();
        for (bytes, name) in [
            (text.as_bytes(), None),
            (&marked[..], None),
            (&little[..], Some("UTF-16")),
            (&big[..], Some("UTF-16")),
        ] {
            assert_eq!(decode(bytes), Some((text.into(), name)));
        }
        // Without a mark, as some shells write it.
        let plain = "A = [1 0; 0 1]";
        let bare: Vec<u8> = plain.encode_utf16().flat_map(u16::to_le_bytes).collect();
        assert_eq!(decode(&bare), Some((plain.into(), Some("UTF-16"))));
        assert_eq!(decode(b"\xc2ngulo 50 \x80"), Some(("Ângulo 50 €".into(), Some("Windows-1252"))));
        assert_eq!(decode(b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR"), None);
    }
}
