//! Wings, tailplanes and fins: lofted through cross-sections, with what moves cut out along its hinge.

use super::face::{Face, Material, Point, grid, outward};
use super::moving::Moving;
use super::{ControlSpan, Profile, Section, Surface};

/// Corners of a cross-section, as fractions of the chord.
const FRACTIONS: [f32; 6] = [0.0, 0.015, 0.09, 0.3, 0.65, 1.0];

/// The hinge of a surface that moves as a whole, as a fraction of the chord.
const ALL_MOVING_HINGE: f32 = 0.4;

/// Corners along a rounded tip, as fractions of its length.
const ROUNDING: [f32; 4] = [0.4, 0.7, 0.9, 0.99];

/// The fixed faces and the moving parts of a surface: of the right one, or of the only one.
pub(super) fn faces(surface: &Surface) -> (Vec<Face>, Vec<Moving>) {
    let (mut fixed, mut moving) = (Vec::new(), Vec::new());
    if surface.sections.len() < 2 {
        return (fixed, moving);
    }
    let cuts = cuts(surface);
    let mut k = 0;
    while k + 1 < cuts.len() {
        // As many cuts as share a control, or none, make one part.
        let control = control_between(surface, &cuts[k], &cuts[k + 1]);
        let mut end = k + 1;
        while end + 1 < cuts.len() && control_between(surface, &cuts[end], &cuts[end + 1]) == control {
            end += 1;
        }
        let run = &cuts[k..=end];
        match control {
            Some(control) if control.chord >= 1.0 => moving.extend(part(surface, run, control, 0.0)),
            Some(control) => {
                let hinge = 1.0 - control.chord;
                fixed.extend(between(surface, run, 0.0, hinge, Material::Skin));
                moving.extend(part(surface, run, control, hinge));
            }
            None => fixed.extend(between(surface, run, 0.0, 1.0, Material::Skin)),
        }
        k = end;
    }
    (fixed, moving)
}

/// A cross-section and how far it is along the way from root to tip.
#[derive(Clone, Copy)]
struct Cut {
    along: f32,
    section: Section,
    /// Direction from root to tip here, of unit length.
    outward: Point,
}

/// Cross-sections at those given, at the ends of controls, and along the rounded tip.
fn cuts(surface: &Surface) -> Vec<Cut> {
    let sections = &surface.sections;
    let steps: Vec<f32> = sections
        .windows(2)
        .map(|pair| {
            let d = pair[1].leading_edge - pair[0].leading_edge;
            d.y.hypot(d.z)
        })
        .collect();
    let length: f32 = steps.iter().sum::<f32>().max(1e-6);
    let mut ends = vec![0.0];
    for step in &steps {
        ends.push(ends[ends.len() - 1] + step);
    }
    let mut along: Vec<f32> = ends.iter().map(|end| end / length).collect();
    along.extend(surface.controls.iter().flat_map(|control| [control.from, control.to]));
    let round_from = 1.0 - (surface.rounding / length).min(1.0);
    if surface.rounding > 0.0 {
        along.push(round_from);
        along.extend(ROUNDING.map(|part| round_from + part * (1.0 - round_from)));
    }
    along.sort_by(f32::total_cmp);
    along.dedup_by(|a, b| (*a - *b).abs() < 1e-4);

    let at = |along: f32| {
        let place = along * length;
        let k = (1..steps.len()).rev().find(|&k| ends[k] <= place).unwrap_or(0);
        let (a, b) = (&sections[k], &sections[k + 1]);
        let t = ((place - ends[k]) / steps[k].max(1e-6)).clamp(0.0, 1.0);
        let mix = |a: f32, b: f32| a + (b - a) * t;
        let mut section = Section {
            leading_edge: a.leading_edge + (b.leading_edge - a.leading_edge) * t,
            chord: mix(a.chord, b.chord),
            thickness: mix(a.thickness, b.thickness),
        };
        if along > round_from {
            // A quarter of an ellipse about the middle of the chord.
            let u = (along - round_from) / (1.0 - round_from);
            let width = (1.0 - u * u).max(0.0).sqrt().max(0.12);
            section.leading_edge.x += 0.42 * (1.0 - width) * section.chord;
            section.chord *= width;
        }
        let d = b.leading_edge - a.leading_edge;
        let outward = Point::new(0.0, d.y, d.z).try_normalize(1e-6).unwrap_or(Point::y());
        Cut { along, section, outward }
    };
    along.into_iter().map(at).collect()
}

fn control_between(surface: &Surface, a: &Cut, b: &Cut) -> Option<ControlSpan> {
    let middle = 0.5 * (a.along + b.along);
    surface.controls.iter().copied().find(|control| (control.from..control.to).contains(&middle))
}

/// Half of the thickness over the chord, at a fraction of the chord.
fn half_thickness(profile: Profile, thickness: f32, x: f32) -> f32 {
    match profile {
        // NACA four-digit: y = 5t (0.2969 √x − 0.1260 x − 0.3516 x² + 0.2843 x³ − 0.1036 x⁴)
        Profile::Wing => {
            let polynomial = -0.1260 + x * (-0.3516 + x * (0.2843 - x * 0.1036));
            5.0 * thickness * (0.2969 * x.sqrt() + x * polynomial).max(0.0)
        }
        Profile::Wedge => 0.5 * thickness * x,
    }
}

impl Cut {
    /// A point of the surface: at a fraction of the chord, above (1) or below (−1) the chord, or on it (0).
    fn point(&self, surface: &Surface, x: f32, side: f32) -> Point {
        let Section { leading_edge, chord, thickness } = self.section;
        let (sin, cos) = surface.incidence.sin_cos();
        // Aft along the chord, whose trailing edge is low where the incidence is positive.
        let aft = Point::new(cos, 0.0, -sin);
        let up = Point::x().cross(&self.outward);
        leading_edge + chord * (x * aft + side * half_thickness(surface.profile, thickness, x) * up)
    }

    /// From the rear over the top to the front and back below.
    fn ring(&self, surface: &Surface, from: f32, to: f32) -> Vec<Point> {
        let inner = FRACTIONS.into_iter().filter(|x| *x > from + 0.02 && *x < to - 0.02);
        let mut fractions = vec![from];
        if from == 0.0 {
            fractions.extend(FRACTIONS.into_iter().filter(|x| (0.001..0.02).contains(x)));
        }
        fractions.extend(inner);
        fractions.push(to);
        let above = fractions.iter().rev().map(|&x| self.point(surface, x, 1.0));
        let below = fractions.iter().map(|&x| self.point(surface, x, -1.0));
        above.chain(below.skip(usize::from(from == 0.0))).collect()
    }
}

/// A closed part between two fractions of the chord.
fn between(surface: &Surface, run: &[Cut], from: f32, to: f32, material: Material) -> Vec<Face> {
    let rings: Vec<Vec<Point>> = run.iter().map(|cut| cut.ring(surface, from, to)).collect();
    let mut faces = grid(&rings, false, material);
    for pair in rings.windows(2) {
        if let ([a, .., b], [c, .., d]) = (&pair[0][..], &pair[1][..]) {
            faces.extend(flat_pair([*a, *b, *d, *c], material));
        }
    }
    if let (Some(first), Some(last)) = (rings.first(), rings.last()) {
        let mut tip = last.clone();
        tip.reverse();
        faces.extend(cap(first, material));
        faces.extend(cap(&tip, material));
    }
    outward(faces)
}

/// A four-cornered face as two flat triangles.
fn flat_pair([a, b, c, d]: [Point; 4], material: Material) -> impl Iterator<Item = Face> {
    [Face::flat(&[a, b, c], material), Face::flat(&[a, c, d], material)].into_iter().flatten()
}

/// The end of a part, as strips from top to bottom: a cross-section need not be convex.
fn cap(ring: &[Point], material: Material) -> Vec<Face> {
    let half = ring.len() / 2;
    (0..half)
        .flat_map(|k| {
            let last = ring.len() - 1;
            flat_pair([ring[k], ring[k + 1], ring[last - k - 1], ring[last - k]], material)
        })
        .collect()
}

/// The part that moves: from its hinge to the trailing edge.
fn part(surface: &Surface, run: &[Cut], control: ControlSpan, from: f32) -> Option<Moving> {
    let hinge = if control.chord >= 1.0 { ALL_MOVING_HINGE } else { from };
    let (first, last) = (run.first()?, run.last()?);
    let (a, b) = (first.point(surface, hinge, 0.0), last.point(surface, hinge, 0.0));
    Some(Moving {
        control: control.control,
        hinge: a,
        axis: (b - a).try_normalize(1e-6)?,
        is_left: false,
        faces: between(surface, run, from, 1.0, Material::Control),
    })
}
