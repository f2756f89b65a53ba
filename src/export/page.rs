//! The scene as a page of paper: poles, aircraft, modes, what is on screen of the motion, and the link, in the colours of the light page.
//! It fits on A4 and on Letter.

use maud::{Markup, PreEscaped, html};

use super::document::document;
use super::figure;
use super::scene::Scene;
use crate::findings::Findings;
use crate::flight::analysis::PlaneAnalysis;
use crate::flight::modes::mode::Mode;
use crate::number::{eigenvalue, significant};
use crate::words;

/// The style of the page. A frame that a browser prints is without a document type, so that tables would have type of their own. Heights are such that both papers have room: 273 mm and 255 mm between the margins.
const STYLE: &str = "@page{margin:12mm}*{box-sizing:border-box}\
body{font:9.5pt/1.35 Inter,Helvetica,Arial,sans-serif;color:#1f2d3a;background:#fff;max-width:186mm;margin:0 auto;padding:4mm;\
-webkit-print-color-adjust:exact;print-color-adjust:exact}\
h1{font-size:14pt;margin:0}p{margin:1mm 0}svg{display:block;width:100%;height:auto}\
.above{display:grid;grid-template-columns:1fr 1fr;gap:4mm;align-items:center;margin:2mm 0}.above svg{max-height:66mm}\
table{font:inherit;color:inherit;border-collapse:collapse;width:100%;margin:2mm 0;break-inside:avoid}\
td,th{border-bottom:.3mm solid #ccd3dc;padding:.6mm 1.5mm;text-align:left;vertical-align:top}th{font-weight:600}\
.motion svg{max-height:125mm}.motion{break-inside:avoid}\
.remark{font-size:8pt;color:#5a6773}\
.link{font:7pt/1.3 ui-monospace,monospace;overflow-wrap:anywhere;color:#5a6773}\
@media print{body{padding:0;max-width:none}}";

/// The page. `motion` is the figure of what is on screen beside poles and aircraft, where something moves.
pub fn page(scene: &Scene, findings: &Findings, plane: &PlaneAnalysis, motion: Option<&str>) -> String {
    let scenario = findings.scenario();
    let aircraft = &scenario.aircraft;
    let title = format!("{}: {}", aircraft.name, aircraft.condition);
    let convention = scenario.convention();
    let margins = findings.analysis().as_ref().ok().and_then(|analysis| analysis.margins);
    let edited = if scenario.is_edited() { ", modified" } else { "" };
    let link = scene.link();
    let poles = figure::poles(scene, findings, plane);
    let drawn = figure::aircraft(findings);
    let body = html! {
        p { (words::view::plane(scenario.plane)) " motion" (edited) ". "
            (words::stability::dynamic_sentence(plane)) ". "
            (figure::plain(&words::stability::static_sentence(plane, margins, convention))) "."
            @if findings.is_fed_back() { " " (words::feedback::UNDER_LAW) } }
        div.above {
            (svg(&poles))
            @if let Some(drawn) = &drawn { (svg(drawn)) }
        }
        table {
            tr { th { "Mode" } th { "λ, 1/s" } th { "ωₙ, rad/s" } th { "ζ" } th { "T, s" } th { "half or double, s" } th { "Level" } }
            @for mode in &plane.modes { (row(mode, plane)) }
        }
        @if let Some(motion) = motion { div.motion { (svg(motion)) } }
        @if let Some(link) = &link { p.link { (link) } }
        @if let Some(remark) = words::scene::printed(link.as_deref(), aircraft.own.is_some()) { p.remark { (remark) } }
    };
    document(&title, "en", STYLE, &body) + "\n"
}

/// A figure within the page.
fn svg(figure: &str) -> Markup {
    let start = figure.find("<svg").unwrap_or_default();
    PreEscaped(figure.get(start..).unwrap_or_default().to_owned())
}

/// The numbers of a mode.
fn row(mode: &Mode, plane: &PlaneAnalysis) -> Markup {
    let number = |value: Option<f64>| value.map_or_else(String::new, |value| significant(value, 3));
    let time = mode.time_to_half().or_else(|| mode.time_to_double());
    let sense = if mode.time_to_half().is_some() { "½" } else { "×2" };
    let judged = plane.levels.iter().filter(|verdict| verdict.modes.contains(&mode.naming.name));
    let level = judged.filter_map(|verdict| verdict.level).max();
    html! {
        tr {
            td { (words::mode::title(mode.naming.name)) }
            td { (eigenvalue(mode.lambda)) }
            td { (number(mode.natural_frequency())) }
            td { (number(mode.damping_ratio())) }
            td { (number(mode.period())) }
            td { @if let Some(time) = time { (number(Some(time))) " " (sense) } }
            td { @if let Some(level) = level { (words::verdict::level(level)) } }
        }
    }
}
