//! Files on the command line: in every encoding that the page reads, by names of every kind, and nothing typed beside them in vain.

use std::path::PathBuf;
use std::process::{Command, Output};

use eigenwing::content::FILES;

fn run(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_eigenwing-cli"))
        .current_dir(env!("CARGO_TARGET_TMPDIR"))
        .args(arguments)
        .output()
        .expect("the command line starts")
}

fn answer(arguments: &[&str]) -> String {
    let Output { status, stdout, stderr } = run(arguments);
    assert!(status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&stderr));
    String::from_utf8(stdout).expect("a text")
}

fn complaint(arguments: &[&str]) -> String {
    let Output { status, stderr, .. } = run(arguments);
    assert_eq!(status.code(), Some(1), "{arguments:?}");
    String::from_utf8(stderr).expect("a text").trim_end().to_owned()
}

/// Puts a file where the command line runs.
fn put(name: &str, bytes: &[u8]) -> PathBuf {
    let path = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    std::fs::write(&path, bytes).expect("it is written");
    path
}

fn shipped(key: &str) -> &'static str {
    FILES.iter().find(|(file, _)| file.strip_suffix(".toml") == Some(key)).expect("it ships").1
}

#[test]
fn an_aircraft_file_is_read_in_every_encoding() {
    let text = shipped("navion").replacen("name = \"Navion", "name = \"Flugzeug für Übungen", 1);
    let units = |to: fn(u16) -> [u8; 2]| text.encode_utf16().flat_map(to).collect::<Vec<u8>>();
    let little = [&[0xff, 0xfe][..], &units(u16::to_le_bytes)].concat();
    let big = [&[0xfe, 0xff][..], &units(u16::to_be_bytes)].concat();
    let marked = [&[0xef, 0xbb, 0xbf][..], text.as_bytes()].concat();
    put("files-plain.toml", text.as_bytes());
    let expected = answer(&["analyse", "files-plain.toml"]);
    assert!(expected.contains("Flugzeug für Übungen"), "{expected}");
    for (name, bytes) in [("little", little), ("big", big), ("marked", marked)] {
        let file = format!("files-{name}.toml");
        put(&file, &bytes);
        assert_eq!(answer(&["analyse", &file]).replace(&file, "files-plain.toml"), expected, "{name}");
    }
}

/// Every file that ships is itself when it is opened from a disk.
#[test]
fn a_file_that_ships_has_its_key_when_it_is_opened() {
    for (file, text) in FILES {
        put(&format!("files-shipped-{file}"), text.as_bytes());
        let key = file.strip_suffix(".toml").expect("an aircraft file");
        let link = answer(&["export", "toml", &format!("files-shipped-{file}")]);
        assert_eq!(link, *text, "{key}");
    }
}

#[test]
fn a_name_without_a_dot_is_that_of_a_file_where_the_list_has_none() {
    put("filesnavion", shipped("navion").as_bytes());
    assert_eq!(answer(&["analyse", "filesnavion"]), answer(&["analyse", "navion"]));
    let file = put("files-matrices", b"% units: SI\n% speed: 50\n% states: u w q theta\nA = [-0.05 0.04 0 -9.81; -0.37 -2 50 0; 0 -0.16 -3 0; 0 0 1 0];\n");
    assert!(answer(&["analyse", "files-matrices"]).contains("files-matrices"));
    std::fs::remove_file(file).expect("it is ours");
    assert!(
        complaint(&["analyse", "files-matrices"])
            .starts_with("error: there is no aircraft \"files-matrices\""),
        "{}",
        complaint(&["analyse", "files-matrices"])
    );
    // The list comes first.
    put("c47", b"nothing");
    assert!(answer(&["analyse", "c47"]).contains("C-47"), "{}", answer(&["analyse", "c47"]));
}

#[test]
fn what_is_typed_beside_a_file_that_has_everything_is_refused() {
    put("files-own.toml", shipped("navion").as_bytes());
    assert_eq!(
        complaint(&["analyse", "files-own.toml", "--fill", "mass=3"]),
        "error: files-own.toml, line 1: nothing in this file waits for “mass”"
    );
    for name in ["navion", "#v=1&ac=navion"] {
        assert_eq!(
            complaint(&["analyse", name, "--fill", "mass=3"]),
            "error: --fill and --mass-file belong to a file that is opened"
        );
    }
}
