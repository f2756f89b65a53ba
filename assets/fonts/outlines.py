#!/usr/bin/env python3
"""Makes outlines.txt, the letters of figures, of the fonts in this folder (at development time only; the result is committed).

    python3 -m venv venv && venv/bin/pip install fonttools==4.68.0
    venv/bin/python assets/fonts/outlines.py

A line has a letter, its advance, and its outline as a path of SVG in relative commands, each from the place where the letter stands;
between them are tabs. A unit is a thousandth of the letter's size, y is downward. A letter with a dot above it is one: two characters.
"""

from pathlib import Path

from fontTools.pens.boundsPen import BoundsPen
from fontTools.pens.recordingPen import DecomposingRecordingPen
from fontTools.ttLib import TTFont

from subset import ASCII, DOT_ABOVE, DOTTED, FRACTIONS, GREEK, HERE, LATIN_1, LOWERED, MATHS, RAISED

EM = 1000
# Of the punctuation of the page what words on paper have, and of its signs the arrow between two numbers.
PUNCTUATION = "\u2009\u202f‐‑–—…‘’“”′−"
CHARACTERS = "".join([ASCII, LATIN_1, GREEK, PUNCTUATION, MATHS, "→", RAISED, LOWERED, FRACTIONS, DOTTED])
# Letters that have a dot above in symbols, beside those that are one character with it.
UNDER_DOTS = "αβγδθφψωλquvrV"


class Pen:
    """Writes a path in whole numbers."""

    def __init__(self, em: int) -> None:
        self.text, self.at, self.scale = "", (0, 0), EM / em

    def place(self, point: tuple[float, float]) -> tuple[int, int]:
        return (round(point[0] * self.scale), round(-point[1] * self.scale))

    def put(self, command: str, *places: tuple[int, int]) -> None:
        numbers = [n - from_ for place in places for n, from_ in zip(place, self.at)]
        self.text += command + "".join(f"{'' if n < 0 or k == 0 else ' '}{n}" for k, n in enumerate(numbers))
        self.at = places[-1]

    def line(self, to: tuple[int, int]) -> None:
        across, down = to[0] - self.at[0], to[1] - self.at[1]
        if across and down:
            self.put("l", to)
        elif across or down:
            self.text += f"h{across}" if across else f"v{down}"
            self.at = to

    def draw(self, font: TTFont, glyph: str, shift: tuple[float, float] = (0, 0)) -> None:
        glyphs = font.getGlyphSet()
        recording = DecomposingRecordingPen(glyphs)
        glyphs[glyph].draw(recording)
        for command, points in recording.value:
            places = [self.place((x + shift[0], y + shift[1])) for x, y in points]
            if command == "moveTo":
                self.put("m", places[0])
                start = places[0]
            elif command == "lineTo":
                self.line(places[0])
            elif command == "qCurveTo":
                # Between two points off the curve the middle is on it.
                for k, off in enumerate(places[:-1]):
                    near = places[k + 1]
                    is_last = k == len(places) - 2
                    self.put("q", off, near if is_last else ((off[0] + near[0]) // 2, (off[1] + near[1]) // 2))
            elif command == "closePath":
                self.text += "z"
                self.at = start
            else:
                raise ValueError(f"{glyph}: {command}")


def bounds(font: TTFont, glyph: str) -> tuple[float, float, float, float]:
    glyphs = font.getGlyphSet()
    pen = BoundsPen(glyphs)
    glyphs[glyph].draw(pen)
    return pen.bounds


def main() -> None:
    fonts = [TTFont(HERE / file) for file in ("text-regular.ttf", "signs.ttf")]

    def found(character: str) -> tuple[TTFont, str]:
        return next((font, name) for font in fonts if (name := font.getBestCmap().get(ord(character))))

    rows, absent = [], []
    for character in dict.fromkeys(CHARACTERS):
        try:
            font, glyph = found(character)
        except StopIteration:
            absent.append(f"U+{ord(character):04X}")
            continue
        pen = Pen(font["head"].unitsPerEm)
        pen.draw(font, glyph)
        rows.append((character, round(font["hmtx"][glyph][0] * pen.scale), pen.text))
    font = fonts[0]
    dot, x_height = font.getBestCmap()[ord(DOT_ABOVE)], bounds(font, font.getBestCmap()[ord("x")])[3]
    middle = sum(bounds(font, dot)[::2]) / 2
    for character in UNDER_DOTS:
        glyph = font.getBestCmap()[ord(character)]
        left, _, right, top = bounds(font, glyph)
        pen = Pen(font["head"].unitsPerEm)
        pen.draw(font, glyph)
        # A path goes on where its last part began.
        pen.draw(font, dot, ((left + right) / 2 - middle, max(0, top - x_height)))
        rows.append((character + DOT_ABOVE, round(font["hmtx"][glyph][0] * pen.scale), pen.text))
    text = "".join(f"{character}\t{advance}\t{path}\n" for character, advance, path in rows)
    (HERE / "outlines.txt").write_text(text, encoding="utf-8")
    print(f"outlines.txt: {len(rows)} letters, {len(text.encode())} bytes; in no face:", absent or "none")


if __name__ == "__main__":
    main()
