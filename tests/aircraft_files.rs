//! Files of aircraft: those that ship read, and a broken one says where and why.

use eigenwing::content::{Aircraft, embedded_aircraft};

const NAVION: &str = include_str!("../assets/aircraft/navion.toml");

#[test]
fn every_file_that_ships_reads() {
    let (aircraft, errors) = embedded_aircraft();
    assert_eq!(errors, []);
    assert_eq!(aircraft[0].key, "navion");
}

#[test]
fn a_broken_file_names_its_line_and_what_was_expected() {
    for (from, to, line, words) in [
        ("u0 = 53.6448", "u0 = \"fast\"", 12, "f64"),
        ("u0 = 53.6448", "u0 = -3.0", 12, "positive"),
        ("u0 = 53.6448", "speed = 53.6448", 12, "speed"),
        ("[0.0, 0.0, 1.0, 0.0]", "[0.0, 0.0, 2.0, 0.0]", 13, "last row"),
        ("-9.8066352", "nan", 13, "finite"),
        ("length_unit = \"m\"", "length_unit = \"furlong\"", 5, "furlong"),
    ] {
        let broken = NAVION.replacen(from, to, 1);
        assert_ne!(broken, NAVION, "{from}");
        let error = Aircraft::from_toml("broken.toml", &broken).expect_err("a broken file");
        assert_eq!((error.file.as_str(), error.line), ("broken.toml", line), "{error}");
        assert!(error.problem.contains(words), "{error}");
    }
}

/// A cut-off download, a slip of the finger: total, whatever comes.
#[test]
fn a_file_with_any_byte_changed_is_read_or_refused() {
    for i in 0..NAVION.len() {
        for byte in [b'0', b'"', b'\n', b']', b'e'] {
            let mut bytes = NAVION.as_bytes().to_vec();
            bytes[i] = byte;
            if let Ok(text) = String::from_utf8(bytes) {
                let _ = Aircraft::from_toml("changed.toml", &text);
            }
        }
    }
}
