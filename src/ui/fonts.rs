//! The faces of the page, all embedded: nothing depends on the fonts of the machine.
//!
//! | family | faces, in the order in which they are asked | for |
//! |---|---|---|
//! | [`FontFamily::Proportional`], `Monospace` | Inter, signs | text and numbers |
//! | [`bold`] | Inter SemiBold, signs | headings, values that matter |
//! | [`maths`] | STIX Two Italic, STIX Two Regular, Inter, signs | symbols: letters lean, figures don't |
//! | [`maths_upright`] | STIX Two Regular, Inter, signs | "cos", "max" beside symbols |
//!
//! Figures are tabular in every family, so a number that changes doesn't shift what stands beside it. A combining dot
//! (α̇, q̇) finds its place in Inter and in STIX Two. All faces share Inter's ascent and descent, hence one baseline.
//! `assets/fonts/subset.py` made the files and lists their characters.

use egui::{FontData, FontDefinitions, FontFamily, FontTweak};

const FACES: [(&str, &[u8]); 5] = [
    ("text", include_bytes!("../../assets/fonts/text-regular.ttf")),
    ("text-semibold", include_bytes!("../../assets/fonts/text-semibold.ttf")),
    ("maths-italic", include_bytes!("../../assets/fonts/maths-italic.ttf")),
    ("maths-upright", include_bytes!("../../assets/fonts/maths-upright.ttf")),
    ("signs", include_bytes!("../../assets/fonts/signs.ttf")),
];

/// Semibold text.
pub fn bold() -> FontFamily {
    FontFamily::Name("bold".into())
}

/// Symbols such as C_mα: italic letters, upright figures.
pub fn maths() -> FontFamily {
    FontFamily::Name("maths".into())
}

/// Names of functions beside symbols: cos, max.
pub fn maths_upright() -> FontFamily {
    FontFamily::Name("maths-upright".into())
}

/// Every face and family, for `ctx.set_fonts`.
pub fn definitions() -> FontDefinitions {
    let mut fonts = FontDefinitions::empty();
    for (name, bytes) in FACES {
        // Hinting sets upright stems onto pixels, but it bends leaning ones, and grows a hat on θ.
        let hinting = (name == "maths-italic").then_some(false);
        let tweak = FontTweak { hinting, ..Default::default() };
        fonts.font_data.insert(name.to_owned(), FontData::from_static(bytes).tweak(tweak).into());
    }
    let families: [(FontFamily, &[&str]); 5] = [
        (FontFamily::Proportional, &["text", "signs"]),
        (FontFamily::Monospace, &["text", "signs"]),
        (bold(), &["text-semibold", "signs"]),
        (maths(), &["maths-italic", "maths-upright", "text", "signs"]),
        (maths_upright(), &["maths-upright", "text", "signs"]),
    ];
    for (family, faces) in families {
        let faces = faces.iter().map(|&face| face.to_owned()).collect();
        fonts.families.insert(family, faces);
    }
    fonts
}

#[cfg(test)]
mod tests {
    use egui::epaint::text::{Fonts, TextOptions};
    use egui::text::LayoutJob;
    use egui::{Color32, FontId};

    use super::*;

    const TEXT: &str = "×·°±−–—…‘’“”«»αβγδεζηθικλμνξοπρσςτυφχψω\
        ΑΒΓΔΕΖΗΘΙΚΛΜΝΞΟΠΡΣΤΥΦΧΨΩ′″∞≈≤≥≠√∑∂∇⇒→←↑↓↔↺↻↶↷✓✗▶❚⏸■●○▾▴▸⚠◐☀☾⟳½¼\
        ⁰¹²³⁴⁵⁶⁷⁸⁹⁻₀₁₂₃₄₅₆₇₈₉₊₋ₐₑₖₘₙₚₛₜᵣẇẋ\u{307}∠‖⏮☰⋯✕";

    fn fonts() -> Fonts {
        Fonts::new(TextOptions::default(), definitions())
    }

    fn latin() -> impl Iterator<Item = char> {
        ('\u{20}'..='\u{7e}').chain('\u{a0}'..='\u{ff}')
    }

    #[test]
    fn every_family_has_every_character() {
        let mut fonts = fonts();
        for family in [FontFamily::Proportional, FontFamily::Monospace, bold(), maths(), maths_upright()] {
            let id = FontId::new(14.0, family);
            let missing: String = latin().chain(TEXT.chars()).filter(|&c| !fonts.has_glyph(&id, c)).collect();
            assert_eq!(missing, "", "{:?}", id.family);
        }
    }

    #[test]
    fn figures_and_signs_are_of_one_width() {
        let mut fonts = fonts();
        let mut view = fonts.with_pixels_per_point(1.0);
        for family in [FontFamily::Proportional, bold()] {
            let id = FontId::new(64.0, family);
            let zero = view.glyph_width(&id, '0');
            for c in "123456789+−=±".chars() {
                assert!((view.glyph_width(&id, c) - zero).abs() < 1e-3, "{c} in {:?}", id.family);
            }
            // Nor does kerning part two figures differently.
            let mut width =
                |text: &str| view.layout_no_wrap(text.to_owned(), id.clone(), Color32::WHITE).size().x;
            let even = width("0.000");
            for text in ["1.111", "7.777", "4.174", "1.741"] {
                assert!((width(text) - even).abs() < 1e-3, "{text} in {:?}", id.family);
            }
        }
    }

    #[test]
    fn a_combining_dot_stands_above_its_letter() {
        let mut fonts = fonts();
        let mut view = fonts.with_pixels_per_point(1.0);
        for family in [FontFamily::Proportional, bold(), maths()] {
            for letter in ["α", "β", "θ", "φ", "ψ", "q", "p", "r", "u", "v", "w", "x"] {
                let id = FontId::new(64.0, family.clone());
                let galley = view.layout_no_wrap(format!("{letter}\u{307}"), id, Color32::WHITE);
                let ink: Vec<_> = galley.rows[0]
                    .glyphs
                    .iter()
                    .filter(|glyph| !glyph.uv_rect.is_nothing())
                    .map(|glyph| {
                        let left_top = glyph.pos + glyph.uv_rect.offset;
                        egui::Rect::from_min_size(left_top, glyph.uv_rect.size)
                    })
                    .collect();
                // ṗ, ṙ, ẇ and ẋ come as one precomposed glyph.
                if let [base, dot] = ink[..] {
                    let what = format!("{letter} in {family:?}: {base:?}, {dot:?}");
                    assert!(dot.bottom() <= base.top() + 6.0, "{what}");
                    assert!((dot.center().x - base.center().x).abs() < 12.0, "{what}");
                } else {
                    assert!(ink.len() == 1 && "prwx".contains(letter), "{letter} in {family:?}");
                }
            }
        }
    }

    #[test]
    fn all_families_share_one_baseline() {
        let mut fonts = fonts();
        let mut view = fonts.with_pixels_per_point(1.0);
        let mut job = LayoutJob::default();
        for family in [FontFamily::Proportional, bold(), maths(), maths_upright()] {
            job.append("z∇", 0.0, egui::TextFormat::simple(FontId::new(15.0, family), Color32::WHITE));
        }
        let galley = view.layout_job(job);
        let first = galley.rows[0].glyphs[0].pos.y;
        assert!(galley.rows[0].glyphs.iter().all(|glyph| glyph.pos.y == first));
    }
}
