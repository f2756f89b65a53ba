//! One of the two maps: what is drawn on it, in which order, with labels that never collide.

use std::sync::Arc;

use egui::{Align2, Color32, FontId, Galley, Painter, Pos2, Rect, Stroke, StrokeKind, Ui, Vec2};
use nalgebra::Complex;

use super::drag::{DraggedPole, Outcome};
use super::trail::Trail;
use super::{NARROW, NARROWEST, PoleMapContent, boundaries, grid, marks};
use crate::flight::modes::locus::Locus;
use crate::flight::modes::mode::Mode;
use crate::flight::modes::mode_name::ModeName;
use crate::flight::modes::stability::Stability;
use crate::flight::verdicts::level_boundaries::Boundary;
use crate::number::{nice_step, round_up};
use crate::scenario::{Hidden, Parameter};
use crate::ui::chart::{Chart, View};
use crate::ui::curtain::Curtain;
use crate::ui::labels::{Place, Placement, RememberedPlace, Wanted, draw_leader};
use crate::ui::theme::{self, Palette};
use crate::words;

/// Room above a map for its name and its buttons.
pub const CAPTION: f32 = 18.0;

/// Round gains along the whole of a path, at first and at most; fewer numbers on a map than this are too few to go by.
const GAINS: f64 = 12.0;
const MOST_GAINS: f64 = 120.0;
const FEWEST: usize = 3;

/// What a leader costs beside its length: more than all else, so that a label stands beside its pole wherever it can.
const LEADER: f32 = 10_000.0;

/// How much of its colour a pole of the other state of a loop has.
const FAINT: f32 = 0.6;

/// Space that a mark keeps clear of labels.
const MARK: f32 = 14.0;

/// One of the two maps.
#[derive(Debug)]
pub struct Map<'a> {
    /// What it is called.
    pub captions: [&'static str; 3],
    /// With its caption.
    pub rect: Rect,
    /// Indices of the modes that its range is made for.
    pub ranged: Vec<usize>,
    /// Indices of the modes that are reached here by keyboard, and whose levels are drawn here.
    pub home: Vec<usize>,
    /// The modes.
    pub modes: &'a [Mode],
    /// Poles of the pinned state that stay in sight.
    pub pinned: Vec<Complex<f64>>,
}

/// What is drawn beside the poles.
#[derive(Clone, Copy, Debug)]
pub struct Extras<'a> {
    /// Where the poles came from.
    pub trail: &'a Trail,
    /// Whether approximations are marked.
    pub approximations: bool,
    /// Boundaries of levels.
    pub boundaries: &'a [Boundary],
    /// Poles of the other state of a loop, closed or open.
    pub other: &'a [&'a Mode],
    /// The pole that is held on this map.
    pub held: Option<&'a DraggedPole>,
    /// What came of it.
    pub outcome: Option<&'a Outcome>,
    /// The mode that stands out.
    pub lit: Option<usize>,
    /// What the other map shows, drawn as a frame in this one.
    pub inset: Option<View>,
    /// A place at the foot that a sentence takes.
    pub taken: Option<Rect>,
}

impl Map<'_> {
    /// The map without its caption.
    pub fn plot_rect(&self) -> Rect {
        let mut rect = self.rect;
        rect.min.y += CAPTION;
        rect
    }

    /// The part of the plane that holds its modes and the pinned ones with room for labels, in round numbers.
    pub fn wanted_view(&self) -> View {
        let poles = || self.ranged.iter().map(|&i| self.modes[i].lambda).chain(self.pinned.iter().copied());
        let largest = |part: fn(Complex<f64>) -> f64| poles().map(part).fold(0.0, f64::max);
        let (left, right, high) = (largest(|l| -l.re), largest(|l| l.re), largest(|l| l.im));
        let reach = left.max(right).max(high).max(1e-3);
        let top = round_up((1.3 * high).max(0.35 * reach));
        View {
            left: -round_up((1.25 * left).max(0.5 * reach)),
            right: round_up((1.3 * right).max(0.22 * reach)),
            bottom: -top,
            top,
        }
    }

    /// The boundaries that are drawn here.
    pub fn boundaries<'b>(&self, boundaries: &'b [Boundary]) -> impl Iterator<Item = &'b Boundary> {
        let here =
            |boundary: &&Boundary| self.home.iter().any(|&i| boundary.concerns(self.modes[i].naming.name));
        boundaries.iter().filter(here)
    }

    /// Draws it.
    pub fn draw(
        &self,
        ui: &Ui,
        palette: &'static Palette,
        chart: &Chart,
        seen: &PoleMapContent<'_>,
        extras: Extras<'_>,
        stood: &mut RememberedLabels,
    ) {
        let rect = chart.rect;
        let caption = self.rect.min + Vec2::new(0.0, 0.5 * CAPTION - 1.0);
        let [long, short, shortest] = self.captions;
        let name = match rect.width() {
            width if width < NARROWEST => shortest,
            width if width < NARROW => short,
            _ => long,
        };
        ui.painter().text(caption, Align2::LEFT_CENTER, name, theme::small(), palette.weak);
        let painter = ui.painter_at(rect);
        let levels: Vec<_> =
            self.boundaries(extras.boundaries).map(|boundary| boundaries::drawn(boundary, chart)).collect();
        let paths = seen.locus.map_or_else(Vec::new, |(_, locus)| marks::paths(chart, locus));
        grid::draw(&painter, self.captions[0], chart, palette);
        boundaries::draw(&painter, palette, &levels);
        if let Some(inset) = extras.inset {
            frame(&painter, chart, palette, inset);
        }
        marks::dotted(&painter, palette, &paths);
        let gains =
            seen.locus.map_or_else(Vec::new, |(parameter, locus)| gains(chart, seen, parameter, locus));
        for gain in &gains {
            let color = gain.name.map_or(palette.pinned, |name| palette.mode(name));
            painter.circle_filled(gain.at, 2.4, color);
        }
        extras.trail.draw(&painter, chart, palette);
        for mode in seen.pinned.into_iter().flatten() {
            marks::ring(&painter, chart, mode.lambda, palette.pinned);
        }
        for mode in extras.other {
            let color = palette.mode(mode.naming.name).gamma_multiply(FAINT);
            marks::both(mode.lambda, |pole| marks::square(&painter, chart.position(pole), color));
        }
        let approximated =
            || marks::approximated(&seen.plane.approximations).filter(|_| extras.approximations);
        for (approximation, root) in approximated() {
            let color = palette.mode(approximation.name.concerns());
            marks::both(root, |root| marks::diamond(&painter, chart.position(root), color));
        }
        held(&painter, chart, palette, extras.held, extras.outcome);
        for (i, mode) in self.modes.iter().enumerate() {
            if extras.lit == Some(i) {
                let halo = palette.mode(mode.naming.name).gamma_multiply(0.18);
                marks::both(mode.lambda, |pole| {
                    painter.circle_filled(chart.position(pole), 12.0, halo);
                });
            }
            marks::mode(&painter, chart, palette, mode);
        }

        let rings =
            seen.pinned.into_iter().flatten().chain(extras.other.iter().copied()).map(|mode| mode.lambda);
        let others: Vec<Complex<f64>> = rings.chain(approximated().map(|(_, root)| root)).collect();
        let mut placement = self.occupied(chart, &others);
        let written = grid::scale(&painter, chart, palette, &mut placement);
        extras.taken.into_iter().for_each(|taken| placement.keep_clear(taken));
        boundaries::keep_clear(&mut placement, &levels);
        for gain in gains.iter().filter(|gain| !gain.text.is_empty()) {
            let font = FontId::proportional(theme::sizes(ui).tick);
            let galley = painter.layout_no_wrap(gain.text.clone(), font, palette.weak);
            let place = Rect::from_min_size(gain.at + Vec2::new(4.0, -galley.size().y), galley.size());
            placement.keep_clear(place);
            painter.galley(place.min, galley, palette.weak);
        }
        marks::shun(&mut placement, &paths);
        stood.rests = !ui.input(|input| input.pointer.any_down());
        for (_, label) in self.labels(&painter, palette, chart, &mut placement, extras.inset, stood) {
            label.draw(&painter, palette);
        }
        boundaries::labels(&painter, palette, &mut placement, &levels);
        grid::labels(&painter, chart, palette, &mut placement, written);
        ui.painter().rect_stroke(rect, 4.0, Stroke::new(1.0, palette.hairline), StrokeKind::Inside);
    }

    /// All poles and other marks, from which labels keep clear, and the boundary, which none crosses.
    fn occupied(&self, chart: &Chart, others: &[Complex<f64>]) -> Placement {
        let rect = chart.rect;
        let mut placement = Placement::new(rect.shrink(3.0));
        for root in self.modes.iter().map(|mode| mode.lambda).chain(others.iter().copied()) {
            marks::both(root, |at| {
                placement.keep_clear(Rect::from_center_size(chart.position(at), Vec2::splat(MARK)));
            });
        }
        let origin = chart.position(Complex::from(0.0));
        placement.keep_clear(Rect::from_center_size(origin, Vec2::new(2.0, 4.0 * rect.height())));
        placement
    }

    /// The labels of its modes, by their indices, at their places: with numbers if all have room then, else names alone.
    fn labels(
        &self,
        painter: &Painter,
        palette: &Palette,
        chart: &Chart,
        placement: &mut Placement,
        inset: Option<View>,
        stood: &mut RememberedLabels,
    ) -> Vec<(usize, Label)> {
        let on_map: Vec<(usize, Vec<Lines>, Wanted)> = (0..self.modes.len())
            .filter_map(|index| {
                let mode = &self.modes[index];
                let own = self.poles_on(chart, index);
                let others = (0..self.modes.len()).filter(|i| *i != index);
                let others = others.flat_map(|i| self.poles_on(chart, i)).collect();
                let texts = texts(painter, palette, mode);
                let sizes = texts.iter().map(|lines| extent(lines)).collect();
                let brief = inset.is_some_and(|inset| crowded(mode, chart.view, inset));
                let wanted = Wanted {
                    own,
                    others,
                    half: half(chart, mode),
                    sizes,
                    first: usize::from(brief),
                    towards: None,
                    leader: LEADER,
                };
                (!wanted.own.is_empty()).then_some((index, texts, wanted))
            })
            .collect();
        let name = |index: usize| self.modes[index].naming.name;
        let places = |placement: &mut Placement, on_map: &[(usize, Vec<Lines>, Wanted)]| {
            let place = |(index, _, wanted): &(usize, Vec<Lines>, Wanted)| {
                let kept = stood.kept.iter().find(|(of, _)| *of == name(*index)).map(|(_, kept)| *kept);
                placement.label(wanted, kept, stood.rests)
            };
            on_map.iter().map(place).collect::<Vec<Option<(Place, RememberedPlace)>>>()
        };
        let (free, mut on_map) = (placement.clone(), on_map);
        let mut found = places(placement, &on_map);
        if found.iter().any(Option::is_none) {
            on_map.iter_mut().for_each(|(.., wanted)| wanted.first = 1);
            *placement = free;
            found = places(placement, &on_map);
        }
        let mut labels = Vec::new();
        let mut kept_now = Vec::new();
        for ((index, mut texts, _), found) in on_map.into_iter().zip(found) {
            if let Some((place, kept)) = found {
                kept_now.push((name(index), kept));
                labels.push((index, Label { lines: texts.swap_remove(place.size), place }));
            }
        }
        stood.kept = kept_now;
        labels
    }

    /// Where the poles of a mode are on the map, the upper one of a pair first.
    fn poles_on(&self, chart: &Chart, index: usize) -> Vec<Pos2> {
        let mut poles = Vec::new();
        marks::both(self.modes[index].lambda, |pole| poles.push(chart.position(pole)));
        poles.retain(|pole| chart.rect.contains(*pole));
        poles
    }

    /// What the map shows, in words; with where the poles have gone since they `began` to move, and the hollow squares of an `other` state
    /// by what that is.
    pub fn describe(
        &self,
        curtain: &Curtain,
        began: &[(ModeName, Complex<f64>)],
        (of_other, other): (&str, &[&Mode]),
    ) -> String {
        let words = |index: usize| {
            let mode = &self.modes[index];
            let title = curtain.title(mode.naming.name);
            curtain.numbers(mode).map_or_else(|| title.to_owned(), |numbers| format!("{title} {numbers}"))
        };
        let modes: Vec<String> = curtain.order(self.modes).into_iter().map(words).collect();
        let [numbers, verdicts] = [Hidden::Numbers, Hidden::Verdicts].map(|hidden| !curtain.hides(hidden));
        let seen = words::pole_map::seen(self.modes, numbers, verdicts);
        let mut described = format!("Pole map, {}: {}. {seen}", self.captions[0], modes.join("; "));
        for mode in self.modes {
            let before = began.iter().find(|(name, _)| *name == mode.naming.name);
            if let Some(way) = before.and_then(|(_, before)| words::pole_map::moved(mode, *before)) {
                described.push_str(&format!(". {} has moved {way}", curtain.title(mode.naming.name)));
            }
        }
        if !other.is_empty() {
            let seen = words::pole_map::seen(other.iter().copied(), numbers, verdicts);
            described.push_str(&format!(". Hollow squares, {of_other}: {seen}"));
        }
        described
    }
}

/// Round gains on the path of a gain; nothing on other paths.
fn gains(
    chart: &Chart,
    seen: &PoleMapContent<'_>,
    parameter: &Parameter,
    locus: &Locus,
) -> Vec<marks::RoundValue> {
    if !parameter.is_gain() {
        return Vec::new();
    }
    let scenario = seen.findings.scenario();
    let unit = parameter.written(scenario.convention()).in_si;
    let range = parameter.range(scenario);
    let width = (range.end() - range.start()) / unit;
    let mut step = nice_step(width / GAINS);
    loop {
        let (values, written) = marks::round_values(chart, locus, (step * unit, unit));
        let finer = nice_step(0.4 * step);
        if written >= FEWEST || width / finer > MOST_GAINS {
            return values;
        }
        step = finer;
    }
}

/// Whether a mode belongs to the other map, where there is room for its numbers.
fn crowded(mode: &Mode, view: View, inset: View) -> bool {
    let within = |x: f64, low: f64, high: f64| low < x && x < high;
    inset.top - inset.bottom < 0.3 * (view.top - view.bottom)
        && within(mode.lambda.re, inset.left, inset.right)
        && within(mode.lambda.im, inset.bottom, inset.top)
}

/// The frame of what the other map shows.
fn frame(painter: &Painter, chart: &Chart, palette: &Palette, inset: View) {
    let corners = [(inset.left, inset.top), (inset.right, inset.bottom)];
    let [min, max] = corners.map(|(re, im)| chart.position(Complex::new(re, im)));
    painter.rect_stroke(
        Rect::from_min_max(min, max),
        0.0,
        Stroke::new(1.0, palette.pinned),
        StrokeKind::Middle,
    );
}

/// Where a held pole was, and where it is wanted but can't follow.
fn held(
    painter: &Painter,
    chart: &Chart,
    palette: &Palette,
    held: Option<&DraggedPole>,
    outcome: Option<&Outcome>,
) {
    let Some(held) = held else { return };
    marks::ring(painter, chart, held.mode.lambda, palette.mode(held.mode.naming.name).gamma_multiply(0.7));
    if let Some(outcome) = outcome.filter(|outcome| outcome.obstacle.is_some()) {
        let [from, to] = [outcome.lambda, outcome.wanted].map(|at| chart.position(held.side(at)));
        marks::target(painter, from, to, palette.mode(outcome.name));
    }
}

/// Where the labels of a map stood in the frame before, by the names of their modes.
#[derive(Debug, Default)]
pub struct RememberedLabels {
    kept: Vec<(ModeName, RememberedPlace)>,
    /// Whether nothing is under the hand, so that a label may go to a better place.
    rests: bool,
}

/// The label of a mode at its place.
#[derive(Debug)]
struct Label {
    lines: Lines,
    place: Place,
}

/// Lines of a label, one below the other.
type Lines = Vec<Arc<Galley>>;

fn extent(lines: &[Arc<Galley>]) -> Vec2 {
    let below = |size: Vec2, line: &Arc<Galley>| Vec2::new(size.x.max(line.size().x), size.y + line.size().y);
    lines.iter().fold(Vec2::ZERO, below)
}

impl Label {
    /// Draws it, with its leader.
    fn draw(&self, painter: &Painter, palette: &Palette) {
        if let Some(leader) = self.place.leader {
            draw_leader(painter, leader, palette);
        }
        let mut at = self.place.rect.min;
        for line in &self.lines {
            painter.galley(at, line.clone(), Color32::PLACEHOLDER);
            at.y += line.size().y;
        }
    }
}

/// What a label can say, the most first: name and the two numbers that matter most, the name alone, the name in several lines.
fn texts(painter: &Painter, palette: &Palette, mode: &Mode) -> Vec<Lines> {
    let color = palette.mode_text(mode.naming.name);
    let text = |text: String, font: FontId| painter.layout_no_wrap(text, font, color);
    let curtain = Curtain::on(painter.ctx());
    let name = curtain.title(mode.naming.name);
    let sizes = theme::sizes(painter.ctx());
    let numbers = curtain.numbers(mode).map(|numbers| text(numbers, FontId::proportional(sizes.chip)));
    let whole = [Some(text(name.to_owned(), theme::semibold(sizes.name))), numbers];
    let mut texts = vec![whole.into_iter().flatten().collect()];
    let font = || theme::semibold(sizes.small);
    let whole = text(name.to_owned(), font());
    let width = whole.size().x;
    texts.push(vec![whole]);
    let longest = name.split(' ').map(|word| text(word.to_owned(), font()).size().x).fold(0.0, f32::max);
    for narrow in [(0.62 * width).max(longest), longest] {
        let wrapped = painter.layout(name.to_owned(), font(), color, narrow.ceil() + 1.0);
        if wrapped.size().x < 0.9 * width {
            texts.push(vec![wrapped]);
        }
    }
    texts
}

/// The half of the map that a mode belongs to; of a neutral one both.
fn half(chart: &Chart, mode: &Mode) -> Rect {
    let boundary = chart.position(Complex::from(0.0)).x;
    match mode.stability {
        Stability::Stable => Rect::everything_left_of(boundary),
        Stability::Unstable => Rect::everything_right_of(boundary),
        Stability::Neutral => Rect::EVERYTHING,
    }
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;

    use egui::{Context, RawInput};

    use super::*;
    use crate::content::embedded_aircraft;
    use crate::flight::aircraft::plane::Plane;
    use crate::scenario::{Parameter, Scenario};
    use crate::ui::poles::range::MapRange;
    use crate::ui::poles::{CAPTIONS, slow_modes};
    use crate::ui::theme::Look;
    use crate::words;

    /// Both maps of a desk, a tablet, a phone and a whole page.
    const SIZES: [[Vec2; 2]; 4] = [
        [Vec2::new(236.0, 338.0), Vec2::new(155.0, 338.0)],
        [Vec2::new(174.0, 280.0), Vec2::new(115.0, 280.0)],
        [Vec2::new(216.0, 190.0), Vec2::new(144.0, 190.0)],
        [Vec2::new(420.0, 700.0), Vec2::new(270.0, 700.0)],
    ];

    /// The labels of both maps are given to `check`, with the map and whether it is the one where the modes are at home.
    fn each_map(scenario: &Scenario, check: impl Fn(&Map<'_>, &Chart, &[(usize, Label)])) {
        let analysis = scenario.analyse();
        let Some(plane) = analysis.ok().and_then(|analysis| analysis.planes[scenario.plane].clone()?.ok())
        else {
            return;
        };
        let modes = &plane.modes;
        let slow = slow_modes(modes);
        let ctx = Context::default();
        theme::install(&ctx);
        for sizes in SIZES {
            let draw = |ui: &mut Ui| {
                let rects = sizes.map(|size| Rect::from_min_size(Pos2::new(7.0, 9.0), size));
                let fast: Vec<usize> = (0..modes.len()).filter(|i| !slow.contains(i)).collect();
                let all = (0..modes.len()).collect();
                let maps = [
                    Map {
                        captions: CAPTIONS[0],
                        rect: rects[0],
                        ranged: all,
                        home: fast,
                        modes,
                        pinned: Vec::new(),
                    },
                    Map {
                        captions: CAPTIONS[1],
                        rect: rects[1],
                        ranged: slow.clone(),
                        home: slow.clone(),
                        modes,
                        pinned: Vec::new(),
                    },
                ];
                let charts = [0, 1].map(|i: usize| {
                    MapRange::default().chart(ui, maps[i].wanted_view(), maps[i].plot_rect(), false)
                });
                for (i, (map, chart)) in maps.iter().zip(&charts).enumerate() {
                    let palette = Look::Light.palette();
                    let mut placement = map.occupied(chart, &[]);
                    grid::scale(ui.painter(), chart, palette, &mut placement);
                    let inset = (i == 0).then_some(charts[1].view);
                    let labels = map.labels(
                        ui.painter(),
                        palette,
                        chart,
                        &mut placement,
                        inset,
                        &mut RememberedLabels { rests: true, ..RememberedLabels::default() },
                    );
                    check(map, chart, &labels);
                }
            };
            ctx.run_ui(RawInput::default(), draw).textures_delta.clear();
        }
    }

    fn scenarios() -> Vec<Scenario> {
        let mut scenarios = Vec::new();
        for aircraft in embedded_aircraft().0 {
            for plane in Plane::ALL {
                let mut scenario = Scenario::new(Arc::new(aircraft.clone()));
                scenario.plane = plane;
                scenarios.push(scenario);
            }
        }
        // Real roots that meet, and a growing one.
        for cm_alpha in [0.3, 0.05, 0.0, -0.02, -0.05, -0.14] {
            let mut scenario = scenarios[0].clone();
            Parameter::find("cm_alpha").expect("a row").set(&mut scenario, cm_alpha);
            scenarios.push(scenario);
        }
        scenarios
    }

    #[test]
    fn every_label_is_nearer_to_its_own_pole_than_to_any_other_or_has_a_leader_to_it() {
        let (with, without) = (Cell::new(0), Cell::new(0));
        for scenario in scenarios() {
            each_map(&scenario, |map, chart, labels| {
                for (mode, label) in labels {
                    let name = words::mode::title(map.modes[*mode].naming.name);
                    let nearest = |index: usize| {
                        let poles = map.poles_on(chart, index).into_iter();
                        poles.map(|pole| label.place.rect.distance_to_pos(pole)).fold(f32::INFINITY, f32::min)
                    };
                    let others = (0..map.modes.len()).filter(|i| i != mode).map(nearest);
                    let other = others.fold(f32::INFINITY, f32::min);
                    let told = format!("{} {:?} {name}", scenario.aircraft.key, scenario.plane);
                    match label.place.leader {
                        None => {
                            without.set(without.get() + 1);
                            let own = nearest(*mode);
                            assert!(
                                own < 20.0 && own < other,
                                "{told}: {own} from its own, {other} from another"
                            );
                            let half = half(chart, &map.modes[*mode]);
                            assert!(half.contains_rect(label.place.rect), "{told}: in the other half");
                        }
                        Some([from, to]) => {
                            with.set(with.get() + 1);
                            let own = map.poles_on(chart, *mode);
                            let end = own.iter().map(|pole| pole.distance(to)).fold(f32::INFINITY, f32::min);
                            assert!(end < 9.0, "{told}: the leader ends {end} from its pole");
                            assert!(label.place.rect.expand(0.1).contains(from), "{told}");
                        }
                    }
                }
            });
        }
        assert!(without.get() > 5 * with.get(), "{} beside, {} with leaders", without.get(), with.get());
    }

    #[test]
    fn every_mode_is_named_on_the_map_where_it_is_at_home() {
        for scenario in scenarios() {
            each_map(&scenario, |map, chart, labels| {
                for &index in &map.home {
                    let on_map = !map.poles_on(chart, index).is_empty();
                    let named = labels.iter().any(|(mode, _)| *mode == index);
                    let name = words::mode::title(map.modes[index].naming.name);
                    let told = format!("{} {:?} {name} {}", scenario.aircraft.key, scenario.plane, map.rect);
                    assert!(named || !on_map, "{told}");
                }
            });
        }
    }
}
