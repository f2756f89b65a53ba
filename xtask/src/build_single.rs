//! One file to pass on: the program with its fonts, the course and a lesson in a single page, which opens from a stick or a chat
//! message where nothing can be fetched.
//!
//! Program and lessons stand in it as text, gzip in base64, and `web/single.js` unpacks them. A page from a file may load no
//! modules, so the program's own script is a classic one. What runs is allowed by its hash, and nothing else.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context as _, Result, bail, ensure};
use base64::Engine as _;
use base64::prelude::BASE64_STANDARD;
use flate2::Compression;
use flate2::write::GzEncoder;
use sha2::{Digest as _, Sha256};

use crate::process;
use crate::project::{Project, WASM_TARGET};
use crate::tools::{self, Tool};

/// The program's own name.
const PROGRAM: &str = "eigenwing";

/// What a lesson may have beside it.
const BESIDE: [&str; 2] = ["glossary.toml", "references.toml"];

/// What begins a line of the page that names a file beside it. There is none here: nothing to copy, to install or to keep for later.
const BESIDE_THE_PAGE: [&str; 4] = [
    "<link data-trunk rel=\"copy-",
    "<link rel=\"manifest\"",
    "<link rel=\"apple-touch-icon\"",
    "<script data-trunk src=\"web/offline.js\"",
];

/// Builds the page of a lesson, and says where it is.
pub fn build(project: &Project, lesson: &Path) -> Result<PathBuf> {
    let name = file_name(lesson)?;
    let stem =
        name.strip_suffix(".md").with_context(|| format!("{name} is no lesson: its name ends with .md"))?;
    process::run(
        process::cargo(project)
            .args(["run", "--quiet", "--locked", "--no-default-features", "--features=cli"])
            .args(["--bin=eigenwing-cli", "--", "check"])
            .arg(std::path::absolute(lesson).context("this folder has no name")?),
    )?;
    let [script, program] = program(project)?;
    let course = project.root.join("assets/lessons");
    let (link, files) = files(lesson, &course, stem)?;
    let read = |path: &str| read_text(&project.root.join(path));
    let notes =
        Notes { page: read("web/notes.html")?, style: read("web/notes.css")?, script: read("web/notes.js")? };
    let parts = Parts {
        page: read("index.html")?,
        icon: read("assets/favicon.svg")?,
        style: read("web/page.css")?,
        guard: read("web/page.js")?,
        start: read("web/single.js")?,
        script: read_text(&script)?,
        program: std::fs::read(&program).with_context(|| format!("cannot read {}", program.display()))?,
        files,
        notes,
        link,
    };
    let folder = project.target().join("single");
    std::fs::create_dir_all(&folder).with_context(|| format!("cannot make {}", folder.display()))?;
    let path = folder.join(format!("{stem}.html"));
    let page = parts.assembled()?;
    std::fs::write(&path, &page).with_context(|| format!("cannot write {}", path.display()))?;
    println!("The lesson is in {} ({:.1} MB)", path.display(), page.len() as f64 / 1e6);
    Ok(path)
}

/// The script and the WebAssembly of the release program.
fn program(project: &Project) -> Result<[PathBuf; 2]> {
    tools::add_wasm_target(project)?;
    process::run(
        process::cargo(project)
            .args(["build", "--quiet", "--locked", "--release", "--target", WASM_TARGET])
            .arg(format!("--bin={PROGRAM}")),
    )?;
    let built = project.target().join(WASM_TARGET).join("release").join(format!("{PROGRAM}.wasm"));
    let out = project.target().join("single").join("program");
    let wasm_bindgen = Tool::wasm_bindgen(project)?.installed(project)?.join("wasm-bindgen");
    process::run(
        Command::new(wasm_bindgen)
            .args(["--target", "no-modules", "--no-typescript", "--out-dir"])
            .arg(&out)
            .arg(built),
    )?;
    Ok([out.join(format!("{PROGRAM}.js")), out.join(format!("{PROGRAM}_bg.wasm"))])
}

/// The link of the lesson, and all files of lessons by their paths below the page.
fn files(lesson: &Path, course: &Path, stem: &str) -> Result<(String, BTreeMap<String, String>)> {
    let mut files = BTreeMap::new();
    let entries = std::fs::read_dir(course).with_context(|| format!("cannot read {}", course.display()))?;
    for entry in entries {
        let path = entry?.path();
        files.insert(format!("lessons/{}", file_name(&path)?), read_text(&path)?);
    }
    let is_of_course = course.join(format!("{stem}.md")).canonicalize().ok() == lesson.canonicalize().ok();
    if is_of_course {
        return Ok((format!("v=1&lesson={stem}"), files));
    }
    ensure!(
        stem.chars().all(|c| c.is_ascii_alphanumeric() || "._-".contains(c)) && !stem.starts_with('.'),
        "a link can't name {stem}.md: give it a name of letters, digits, points and hyphens"
    );
    files.insert(format!("{stem}.md"), read_text(lesson)?);
    for name in BESIDE {
        let path = lesson.with_file_name(name);
        if path.is_file() {
            files.insert(name.to_owned(), read_text(&path)?);
        }
    }
    Ok((format!("v=1&lesson={stem}.md"), files))
}

/// What the page is made of.
struct Parts {
    page: String,
    icon: String,
    style: String,
    guard: String,
    start: String,
    script: String,
    program: Vec<u8>,
    files: BTreeMap<String, String>,
    notes: Notes,
    link: String,
}

/// The window of the notes. The page writes it, so that it has the page's policy and no address of its own.
struct Notes {
    page: String,
    style: String,
    script: String,
}

impl Notes {
    fn assembled(&self) -> Result<String> {
        ensure!(
            !self.script.contains("</script") && !self.style.contains("</style"),
            "the notes would end too early"
        );
        let mut page = self.page.clone();
        for (begins, new) in [
            ("<meta http-equiv=\"Content-Security-Policy\"", String::new()),
            ("<link rel=\"stylesheet\"", format!("<style>{}</style>", self.style)),
            ("<script src=", format!("<script>{}</script>", self.script)),
        ] {
            page = with_tag(&page, begins, &new)?;
        }
        Ok(without_comments(&page))
    }
}

impl Parts {
    fn assembled(&self) -> Result<String> {
        let mut files = self.files.clone();
        files.insert("notes.html".to_owned(), self.notes.assembled()?);
        let files = serde_json::to_vec(&files).context("the lessons are no text")?;
        let icon = format!("data:image/svg+xml;base64,{}", BASE64_STANDARD.encode(&self.icon));
        let scripts = [&self.guard, &self.script, &self.start];
        for script in scripts {
            ensure!(!script.contains("</script") && !script.contains("<!--"), "a script would end too early");
        }
        let mut start = String::new();
        for (id, packed) in [("program", packed(&self.program)?), ("files", packed(&files)?)] {
            write!(
                start,
                "<script type=\"application/gzip\" id=\"{id}\" data-link=\"{}\">{packed}</script>",
                escaped(&self.link)
            )?;
        }
        write!(start, "<script>{}</script><script>{}</script>", self.script, self.start)?;
        let policy = format!(
            "default-src 'none'; script-src 'wasm-unsafe-eval' {}; style-src {}; img-src data:; base-uri 'none'; form-action 'none'",
            [&self.guard, &self.script, &self.start, &self.notes.script].map(|script| hash(script)).join(" "),
            [&self.style, &self.notes.style].map(|style| hash(style)).join(" ")
        );
        let is_beside = |line: &&str| BESIDE_THE_PAGE.iter().any(|beside| line.contains(beside));
        let mut page = self
            .page
            .lines()
            .filter(|line| !is_beside(line))
            .fold(String::new(), |page, line| page + line + "\n");
        for (begins, new) in [
            (
                "<meta http-equiv=\"Content-Security-Policy\"",
                format!("<meta http-equiv=\"Content-Security-Policy\" content=\"{policy}\">"),
            ),
            ("<link data-trunk rel=\"icon\"", format!("<link rel=\"icon\" href=\"{icon}\">")),
            ("<link data-trunk rel=\"css\"", format!("<style>{}</style>", self.style)),
            ("<script data-trunk", format!("<script>{}</script>", self.guard)),
            ("<link data-trunk rel=\"rust\"", start),
        ] {
            page = with_tag(&page, begins, &new)?;
        }
        Ok(without_comments(&page))
    }
}

/// A page with the one tag that begins so replaced, and the end of a script with it.
fn with_tag(page: &str, begins: &str, new: &str) -> Result<String> {
    let Some((before, rest)) = page.split_once(begins) else { bail!("index.html has no {begins}") };
    let (_, after) = rest.split_once('>').with_context(|| format!("{begins} has no end"))?;
    ensure!(!after.contains(begins), "index.html has more than one {begins}");
    Ok(format!("{before}{new}{}", after.strip_prefix("</script>").unwrap_or(after)))
}

/// A page without the comments of its source; scripts and data hold none.
fn without_comments(page: &str) -> String {
    let mut parts = page.split("<!--");
    let first = parts.next().unwrap_or_default().to_owned();
    parts.fold(first, |page, part| page + part.split_once("-->").map_or("", |(_, rest)| rest.trim_start()))
}

fn packed(bytes: &[u8]) -> Result<String> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::best());
    encoder.write_all(bytes)?;
    Ok(BASE64_STANDARD.encode(encoder.finish()?))
}

fn hash(text: &str) -> String {
    format!("'sha256-{}'", BASE64_STANDARD.encode(Sha256::digest(text)))
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('"', "&quot;")
}

fn file_name(path: &Path) -> Result<&str> {
    path.file_name().and_then(|name| name.to_str()).with_context(|| format!("{} has no name", path.display()))
}

fn read_text(path: &Path) -> Result<String> {
    std::fs::read_to_string(path).with_context(|| format!("cannot read {}", path.display()))
}

#[cfg(test)]
mod tests {
    use super::{Notes, Parts, hash};

    fn parts() -> Parts {
        Parts {
            page: include_str!("../../index.html").to_owned(),
            icon: "<svg/>".to_owned(),
            style: "p{}".to_owned(),
            guard: "guard()".to_owned(),
            start: "start()".to_owned(),
            script: "program()".to_owned(),
            program: vec![1, 2, 3],
            files: [("a.md".to_owned(), "</script>".to_owned())].into(),
            notes: Notes {
                page: include_str!("../../web/notes.html").to_owned(),
                style: "b{}".to_owned(),
                script: "notes()".to_owned(),
            },
            link: "v=1&lesson=a.md".to_owned(),
        }
    }

    #[test]
    fn a_single_page_loads_nothing_and_runs_nothing_but_its_own_scripts() {
        let page = parts().assembled().expect("a page");
        for outside in ["data-trunk", "src=", "'self'", "<!--", "manifest", ".png"] {
            assert!(!page.contains(outside), "{outside}");
        }
        for script in ["guard()", "program()", "start()"] {
            assert!(page.contains(&hash(script)), "{script}");
        }
        // Two of data, three that run, and no lesson can end one of them.
        assert_eq!(page.matches("</script>").count(), 5);
        assert!(page.contains("data-link=\"v=1&amp;lesson=a.md\""));
    }

    #[test]
    fn the_notes_come_along_and_load_nothing_either() {
        let notes = parts().notes.assembled().expect("a page");
        for outside in ["src=", "Policy", "stylesheet", "<!--"] {
            assert!(!notes.contains(outside), "{outside}");
        }
        assert!(notes.contains("<style>b{}</style>") && notes.contains("<script>notes()</script>"));
        let page = parts().assembled().expect("a page");
        assert!(page.contains(&hash("notes()")) && page.contains(&hash("b{}")));
    }

    #[test]
    fn a_script_that_would_end_too_early_is_refused() {
        let script = "'</script>'".to_owned();
        assert!(Parts { script, ..parts() }.assembled().is_err());
    }
}
