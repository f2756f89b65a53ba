#!/usr/bin/env python3
"""Makes the five fonts in this folder again (at development time only; the results are committed).

    python3 -m venv venv && venv/bin/pip install fonttools==4.68.0 brotli==1.2.1
    npm install inter-ui@4.1.1 @fontsource/stix-two-text@5.3.0 dejavu-fonts-ttf@2.37.3
    venv/bin/python assets/fonts/subset.py node_modules

| file               | from                                    | holds                                            |
|--------------------|-----------------------------------------|--------------------------------------------------|
| text-regular.ttf   | Inter 4.1 Regular                       | text; its tabular figures are the default ones   |
| text-semibold.ttf  | Inter 4.1 SemiBold                      | the same, for headings and values                |
| maths-italic.ttf   | STIX Two Text Italic                    | symbols: Latin and Greek letters, a dot above    |
| maths-upright.ttf  | STIX Two Text Regular                   | beside them: figures, operators, words ("cos")   |
| signs.ttf          | DejaVu Sans 2.37                        | only the signs that Inter lacks                  |

The faces are renamed (Eigenwing Text, Maths, Signs), because they are not the originals any more.
Licences: OFL-Inter.txt, OFL-STIX-Two.txt, LICENSE-DejaVu.txt beside this file.
"""

import copy
import shutil
import sys
from pathlib import Path

from fontTools.feaLib.builder import addOpenTypeFeaturesFromString
from fontTools.merge import Merger
from fontTools.pens.boundsPen import BoundsPen
from fontTools.pens.ttGlyphPen import TTGlyphPen
from fontTools.subset import Options, Subsetter
from fontTools.ttLib import TTFont
from fontTools.ttLib.tables import otTables

HERE = Path(__file__).resolve().parent

ASCII = "".join(map(chr, range(0x20, 0x7F)))
LATIN_1 = "".join(map(chr, range(0xA0, 0x100)))
GREEK = "αβγδεζηθικλμνξοπρσςτυφχψωΑΒΓΔΕΖΗΘΙΚΛΜΝΞΟΠΡΣΤΥΦΧΨΩϑϕϵ"
PUNCTUATION = "\u2009\u202f‐‑–—…‘’“”‹›′″‖−"
MATHS = "∞≈≤≥≠√∑∂∇∠∝∥⊥∫≡∈∆Δ"
ARROWS = "⇒→←↑↓↔↗↘↺↻↶↷"
SIGNS = "✓✗✕▶❚⏸⏮■□●○◆▲▼▾▴▸△⚠◐☀☾⟳★☰⋯"
RAISED = "⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁺ⁿ"
LOWERED = "₀₁₂₃₄₅₆₇₈₉₊₋ₐₑₖₘₙₚₛₜᵣ"
FRACTIONS = "½¼¾"
DOTTED = "ẇẋẏżṗṙḣ"
DOT_ABOVE = "\u0307"

TEXT = "".join(
    [ASCII, LATIN_1, GREEK, PUNCTUATION, MATHS, ARROWS, SIGNS, RAISED, LOWERED, FRACTIONS, DOTTED, DOT_ABOVE]
)
# A symbol is made of italic letters; its figures, operators and function names are upright.
MATHS_ITALIC = "".join([*filter(str.isalpha, ASCII), GREEK, DOTTED, DOT_ABOVE])
# Of the letters only those of the words that src/ui/symbol.rs sets upright; a test there has the list.
UPRIGHT_LETTERS = "acdefgilmnoprstxzIR"
MATHS_UPRIGHT = "".join(c for c in ASCII if not c.isalpha()) + UPRIGHT_LETTERS + "\u00a0·−–±×′″½¼"

# Made default: every figure and sign of one width, so that numbers stand still while they change.
TABULAR = "0123456789+−×÷=<>≤≥≈≠±.,:"

# In ems.
INTER_ASCENT = 1984 / 2048
INTER_DESCENT = 494 / 2048

# How far STIX Two Italic leans: the tangent of its 16 degrees.
SLANT = 0.287

KEPT_NAMES = [0, 1, 2, 3, 4, 5, 6, 13, 14]


def main(node_modules: Path) -> None:
    inter = node_modules / "inter-ui" / "web"
    stix = node_modules / "@fontsource" / "stix-two-text"
    dejavu = node_modules / "dejavu-fonts-ttf"

    lacking = ""
    for weight, file in (("Regular", "text-regular.ttf"), ("SemiBold", "text-semibold.ttf")):
        font = TTFont(inter / f"Inter-{weight}.woff2")
        lacking = "".join(c for c in TEXT if ord(c) not in font.getBestCmap())
        freeze_tabular_figures(font)
        add_greek_to_dot_anchors(font)
        # Without `calt`: it turns "3x4" into a product and "->" into an arrow.
        cut(font, TEXT, ["kern", "mark"])
        rename(font, "Eigenwing Text", weight)
        save(font, file)

    signs = TTFont(dejavu / "ttf" / "DejaVuSans.ttf")
    draw_pause_and_start(signs)
    cut(signs, lacking, [])
    line_up(signs)
    rename(signs, "Eigenwing Signs", "Regular")
    save(signs, "signs.ttf")
    absent = [f"U+{ord(c):04X}" for c in lacking if ord(c) not in signs.getBestCmap()]

    maths = stix_italic(stix / "files")
    line_up(maths)
    rename(maths, "Eigenwing Maths", "Italic")
    save(maths, "maths-italic.ttf")
    absent += [f"italic U+{ord(c):04X}" for c in MATHS_ITALIC if ord(c) not in maths.getBestCmap()]

    upright = TTFont(stix / "files" / "stix-two-text-latin-400-normal.woff2")
    cut(upright, MATHS_UPRIGHT, ["kern"])
    line_up(upright)
    rename(upright, "Eigenwing Maths", "Regular")
    save(upright, "maths-upright.ttf")
    absent += [f"upright U+{ord(c):04X}" for c in MATHS_UPRIGHT if ord(c) not in upright.getBestCmap()]

    shutil.copy(node_modules / "inter-ui" / "LICENSE.txt", HERE / "OFL-Inter.txt")
    shutil.copy(stix / "LICENSE", HERE / "OFL-STIX-Two.txt")
    shutil.copy(dejavu / "LICENSE", HERE / "LICENSE-DejaVu.txt")
    print("not in Inter, so in signs.ttf:", lacking)
    print("in no face:", absent or "none")


def freeze_tabular_figures(font: TTFont) -> None:
    """Points the characters of TABULAR at the glyphs that the feature `tnum` would put there."""
    gsub = font["GSUB"].table
    tabular: dict[str, str] = {}
    for record in gsub.FeatureList.FeatureRecord:
        if record.FeatureTag == "tnum":
            for index in record.Feature.LookupListIndex:
                for subtable in gsub.LookupList.Lookup[index].SubTable:
                    tabular.update(getattr(subtable, "ExtSubTable", subtable).mapping)
    for table in font["cmap"].tables:
        for c in map(ord, TABULAR):
            if c in table.cmap:
                table.cmap[c] = tabular.get(table.cmap[c], table.cmap[c])


def add_greek_to_dot_anchors(font: TTFont) -> None:
    """Inter puts marks on Latin letters only: gives its small Greek letters a place for the dot as well."""
    cmap, gpos = font.getBestCmap(), font["GPOS"].table
    dot, x = cmap[ord(DOT_ABOVE)], cmap[ord("x")]
    marks = [i for i, record in enumerate(gpos.FeatureList.FeatureRecord) if record.FeatureTag == "mark"]
    for record in gpos.ScriptList.ScriptRecord:
        if record.ScriptTag == "grek":
            language = record.Script.DefaultLangSys
            language.FeatureIndex = sorted({*language.FeatureIndex, *marks})
            language.FeatureCount = len(language.FeatureIndex)
    for lookup in gpos.LookupList.Lookup:
        for subtable in lookup.SubTable:
            subtable = getattr(subtable, "ExtSubTable", subtable)
            if subtable.LookupType != 4 or dot not in subtable.MarkCoverage.glyphs or x not in subtable.BaseCoverage.glyphs:
                continue
            kind = subtable.MarkArray.MarkRecord[subtable.MarkCoverage.glyphs.index(dot)].Class
            records = dict(zip(subtable.BaseCoverage.glyphs, subtable.BaseArray.BaseRecord))
            at_x = records[x].BaseAnchor[kind]
            for c in filter(str.islower, GREEK):
                name = cmap[ord(c)]
                left, _, right, top = box(font, name)
                anchor = copy.deepcopy(at_x)
                anchor.XCoordinate = round((left + right) / 2)
                anchor.YCoordinate = round(at_x.YCoordinate + max(0, top - box(font, x)[3]))
                record = otTables.BaseRecord()
                record.BaseAnchor = [None] * subtable.ClassCount
                record.BaseAnchor[kind] = anchor
                records.setdefault(name, record)
            names = sorted(records, key=font.getGlyphID)
            subtable.BaseCoverage.glyphs = names
            subtable.BaseArray.BaseRecord = [records[name] for name in names]
            subtable.BaseArray.BaseCount = len(names)


def box(font: TTFont, glyph: str) -> tuple[float, float, float, float]:
    """Left, bottom, right and top of its ink."""
    glyphs = font.getGlyphSet()
    pen = BoundsPen(glyphs)
    glyphs[glyph].draw(pen)
    return pen.bounds


def cut(font: TTFont, characters: str, features: list[str]) -> None:
    """Leaves only these characters and layout features, unhinted (egui hints by itself)."""
    options = Options()
    options.layout_features = features
    options.hinting = False
    options.notdef_outline = True
    options.glyph_names = False
    options.name_IDs = KEPT_NAMES
    options.name_languages = [0x409]
    options.drop_tables += ["FFTM", "STAT", "gasp", "meta", "DSIG"]
    subsetter = Subsetter(options)
    subsetter.populate(unicodes=map(ord, characters))
    subsetter.subset(font)


def line_up(font: TTFont) -> None:
    """Gives the face the ascent and descent of Inter: egui then puts all faces on one baseline."""
    em = font["head"].unitsPerEm
    ascent, descent = round(em * INTER_ASCENT), round(em * INTER_DESCENT)
    font["hhea"].ascent, font["hhea"].descent, font["hhea"].lineGap = ascent, -descent, 0
    os2 = font["OS/2"]
    os2.sTypoAscender, os2.sTypoDescender, os2.sTypoLineGap = ascent, -descent, 0
    os2.usWinAscent, os2.usWinDescent = ascent, descent


def draw_pause_and_start(font: TTFont) -> None:
    """⏸ and ⏮, which DejaVu Sans lacks: bars as tall as its ▶."""
    play = font.getBestCmap()[ord("▶")]
    left, bottom, right, top = box(font, play)
    width, tall = right - left, top - bottom
    middle = (bottom + top) / 2

    def bar(pen: TTGlyphPen, x0: float, x1: float) -> None:
        polygon(pen, [(x0, bottom), (x0, top), (x1, top), (x1, bottom)])

    pause = TTGlyphPen(None)
    bar(pause, left + 0.14 * width, left + 0.40 * width)
    bar(pause, left + 0.60 * width, left + 0.86 * width)
    start = TTGlyphPen(None)
    bar(start, left + 0.08 * width, left + 0.24 * width)
    polygon(start, [(left + 0.28 * width, middle), (right - 0.05 * width, middle + 0.45 * tall), (right - 0.05 * width, middle - 0.45 * tall)])

    for name, character, pen in (("pause", "⏸", pause), ("start", "⏮", start)):
        font.setGlyphOrder([*font.getGlyphOrder(), name])
        font["glyf"][name] = pen.glyph()
        font["hmtx"][name] = (font["hmtx"][play][0], round(left))
        for table in font["cmap"].tables:
            if table.isUnicode():
                table.cmap[ord(character)] = name


def polygon(pen: TTGlyphPen, points: list[tuple[float, float]]) -> None:
    pen.moveTo(tuple(map(round, points[0])))
    for point in points[1:]:
        pen.lineTo(tuple(map(round, point)))
    pen.closePath()


def stix_italic(files: Path) -> TTFont:
    """The pieces of STIX Two Text Italic joined, with a dot that finds its place above any letter."""
    pieces = []
    for name in ("latin", "latin-ext", "greek"):
        piece = HERE / f"{name}.part.ttf"
        font = TTFont(files / f"stix-two-text-{name}-400-italic.woff2")
        font.flavor = None
        for table in ("GSUB", "GPOS", "GDEF", "STAT", "prep", "gasp"):
            if table in font:
                del font[table]
        font.save(piece)
        pieces.append(piece)
    font = Merger().merge([str(piece) for piece in pieces])
    for piece in pieces:
        piece.unlink()

    # The pieces hold the combining dot only as a part of ẇ and its like.
    dot = next(g for g in font.getGlyphOrder() if g.startswith("uni0307"))
    for table in font["cmap"].tables:
        if table.isUnicode():
            table.cmap[ord(DOT_ABOVE)] = dot
    add_dot_anchors(font, dot)
    cut(font, MATHS_ITALIC, ["mark"])
    return font


def add_dot_anchors(font: TTFont, dot: str) -> None:
    """Writes the `mark` feature: where ẇ has its dot, relative to the letter, every other letter gets it."""
    cmap = font.getBestCmap()

    def centre(name: str) -> float:
        left, _, right, _ = box(font, name)
        return (left + right) / 2

    x_height = box(font, cmap[ord("x")])[3]
    leans = []
    for dotted, letter in ("ẇw", "ẋx", "ẏy", "ṗp"):
        composite = font["glyf"][cmap[ord(dotted)]]
        shift = next(part.x for part in composite.components if part.glyphName == dot)
        leans.append(centre(dot) + shift - centre(cmap[ord(letter)]))
    lean = sum(leans) / len(leans)

    lines = [f"markClass {dot} <anchor {round(centre(dot))} {round(x_height)}> @DOT;"]
    bases = [c for c in ASCII + GREEK if c.isalpha()]
    rows = []
    for c in bases:
        name = cmap[ord(c)]
        top = max(box(font, name)[3], x_height)
        # The middle of a taller letter is half as far to the right as its top leans.
        x = centre(name) + lean + 0.5 * SLANT * (top - x_height)
        rows.append(f"  pos base {name} <anchor {round(x)} {round(top)}> mark @DOT;")
    classes = (
        f"table GDEF {{ GlyphClassDef [{' '.join(cmap[ord(c)] for c in bases)}], , [{dot}], ; }} GDEF;"
    )
    feature = "\n".join([*lines, "feature mark {", *rows, "} mark;", classes])
    addOpenTypeFeaturesFromString(font, feature)
    font["hmtx"][dot] = (0, font["hmtx"][dot][1])


def rename(font: TTFont, family: str, style: str) -> None:
    names = font["name"]
    copyright_line = names.getDebugName(0)
    postscript = f"{family.replace(' ', '')}-{style}"
    for identifier, text in ((1, family), (2, style), (3, postscript), (4, f"{family} {style}"), (6, postscript)):
        names.setName(text, identifier, 3, 1, 0x409)
    names.names = [n for n in names.names if n.platformID == 3 and n.nameID in KEPT_NAMES]
    assert copyright_line and names.getDebugName(0) == copyright_line


def save(font: TTFont, file: str) -> None:
    import brotli

    font.flavor = None
    # The same bytes from the same sources.
    font.recalcTimestamp = False
    font["head"].created = font["head"].modified = 0
    font.save(HERE / file)
    data = (HERE / file).read_bytes()
    print(f"{file}: {len(data)} bytes, {len(brotli.compress(data))} brotli, {len(font.getBestCmap())} characters")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
