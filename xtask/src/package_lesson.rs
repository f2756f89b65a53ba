//! A lesson as a package for a learning platform, by SCORM 1.2: the single page of the lesson in a frame of a page that tells the
//! platform what is done in it (`web/scorm.js`).
//!
//! SCORM 1.2, not 2004: every platform takes it, and status, score and a note to go on with are all that a lesson has to tell. Not
//! xAPI: a platform gives a package no address to send statements to without a launch protocol of its own.

use std::io::Write as _;
use std::path::{Path, PathBuf};

use anyhow::{Context as _, Result};
use zip::ZipWriter;
use zip::write::SimpleFileOptions;

use crate::build_single;
use crate::project::Project;

/// The pages of a package, below its manifest.
const FILES: [&str; 3] = ["index.html", "lesson.html", "scorm.js"];

/// Builds the package, beside a folder with its files; gives the folder.
pub fn build(project: &Project, lesson: &Path) -> Result<PathBuf> {
    let single = build_single::build(project, lesson)?;
    let stem = single.file_stem().and_then(|stem| stem.to_str()).context("the page has no name")?;
    let text =
        std::fs::read_to_string(lesson).with_context(|| format!("cannot read {}", lesson.display()))?;
    let title = title(&text).unwrap_or(stem.to_owned());
    let scorm = project.root.join("web/scorm.js");
    let read = |path: &Path| std::fs::read(path).with_context(|| format!("cannot read {}", path.display()));
    let contents = [page(&title).into_bytes(), read(&single)?, read(&scorm)?];
    let manifest = ("imsmanifest.xml", manifest(stem, &title).into_bytes());
    let files: Vec<(&str, Vec<u8>)> =
        std::iter::once(manifest).chain(FILES.into_iter().zip(contents)).collect();

    let folder = single.with_file_name(format!("{stem}-scorm"));
    std::fs::create_dir_all(&folder).with_context(|| format!("cannot make {}", folder.display()))?;
    let path = folder.with_extension("zip");
    let package = std::fs::File::create(&path).with_context(|| format!("cannot write {}", path.display()))?;
    let mut zip = ZipWriter::new(package);
    // Not compressed: what is large in it is.
    let stored = SimpleFileOptions::default().compression_method(zip::CompressionMethod::Stored);
    for (name, content) in &files {
        std::fs::write(folder.join(name), content).with_context(|| format!("cannot write {name}"))?;
        zip.start_file(*name, stored)?;
        zip.write_all(content)?;
    }
    zip.finish()?;
    println!("The package is {}", path.display());
    Ok(folder)
}

/// The title in the front matter of a lesson.
fn title(lesson: &str) -> Option<String> {
    let front = lesson.split("+++").nth(1)?.parse::<toml::Table>().ok()?;
    Some(front.get("title")?.as_str()?.to_owned())
}

fn page(title: &str) -> String {
    let title = escaped(title);
    format!(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<title>{title}</title>\n\
        <style>html,body{{margin:0;height:100%}}iframe{{display:block;width:100%;height:100%;border:0}}</style>\n</head>\n<body>\n\
        <iframe id=\"lesson\" title=\"{title}\" allow=\"clipboard-write; fullscreen\"></iframe>\n\
        <script src=\"scorm.js\"></script>\n</body>\n</html>\n"
    )
}

fn manifest(stem: &str, title: &str) -> String {
    let title = escaped(title);
    let files: String = FILES.map(|file| format!("      <file href=\"{file}\"/>\n")).concat();
    let page = FILES[0];
    format!(
        r#"<?xml version="1.0" encoding="UTF-8"?>
<manifest identifier="eigenwing-{stem}" version="1.2"
    xmlns="http://www.imsproject.org/xsd/imscp_rootv1p1p2"
    xmlns:adlcp="http://www.adlnet.org/xsd/adlcp_rootv1p2"
    xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance"
    xsi:schemaLocation="http://www.imsproject.org/xsd/imscp_rootv1p1p2 imscp_rootv1p1p2.xsd http://www.adlnet.org/xsd/adlcp_rootv1p2 adlcp_rootv1p2.xsd">
  <metadata>
    <schema>ADL SCORM</schema>
    <schemaversion>1.2</schemaversion>
  </metadata>
  <organizations default="course">
    <organization identifier="course">
      <title>{title}</title>
      <item identifier="lesson" identifierref="page" isvisible="true">
        <title>{title}</title>
      </item>
    </organization>
  </organizations>
  <resources>
    <resource identifier="page" type="webcontent" adlcp:scormtype="sco" href="{page}">
{files}    </resource>
  </resources>
</manifest>
"#
    )
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::{manifest, page, title};

    #[test]
    fn a_title_is_told_by_the_front_matter_and_can_hold_any_sign() {
        let lesson = "+++\ntitle = \"α < β & \\\"γ\\\"\"\n+++\n## A step\n";
        let title = title(lesson).expect("a title");
        for text in [manifest("a", &title), page(&title)] {
            assert!(text.contains("α &lt; β &amp; &quot;γ&quot;"), "{text}");
        }
        assert_eq!(super::title("## A step"), None);
    }
}
