//! Bodies lofted through cross-sections: fuselage, canopy, nacelles, tanks.

use super::face::{Face, Plane, Point, Side, grid, outward};
use super::{Body, Material, Patch, Station};

/// Corners of a cross-section of a large and of a small body.
const SEGMENTS: (usize, usize) = (20, 12);

/// A body wider than this part of the aircraft's length is large.
const LARGE: f32 = 0.07;

/// A smaller bulge between two cross-sections, over their width, is none.
const STRAIGHT: f32 = 0.015;

/// Inner edge of an intake's lip, over its outer one.
const LIP: f32 = 0.86;

/// The faces of the right one, or of the only one.
pub(super) fn faces(body: &Body, aircraft_length: f32) -> Vec<Face> {
    let widest = body.stations.iter().map(|station| station.width).fold(0.0, f32::max);
    let segments = if widest > LARGE * aircraft_length { SEGMENTS.0 } else { SEGMENTS.1 };
    let rings: Vec<Vec<Point>> = refined(&body.stations)
        .iter()
        .map(|station| ring(station, body.y, body.squareness, segments))
        .collect();
    let mut faces = grid(&rings, true, body.material);
    if let (Some(first), Some(last)) = (rings.first(), rings.last()) {
        let mut back = last.clone();
        back.reverse();
        // Their sense is set below, with the rest.
        faces.extend(Face::flat(&back, body.material));
        if body.is_open {
            faces.extend(intake(first));
        } else {
            faces.extend(Face::flat(first, body.material));
        }
    }
    let mut faces = outward(faces);
    for patch in &body.patches {
        faces = painted(faces, patch);
    }
    faces
}

/// The front of an open body: a lip, and darkness within.
fn intake(ring: &[Point]) -> Vec<Face> {
    let middle = ring.iter().sum::<Point>() / ring.len() as f32;
    let inner: Vec<Point> = ring.iter().map(|point| middle + (point - middle) * LIP).collect();
    let mut faces = grid(&[inner.clone(), ring.to_vec()], true, Material::Metal);
    faces.extend(Face::flat(&inner, Material::Dark));
    faces
}

fn ring(station: &Station, y: f32, squareness: f32, segments: usize) -> Vec<Point> {
    let power = 2.0 / squareness;
    let at = |k: usize| {
        let (sin, cos) = (std::f32::consts::TAU * k as f32 / segments as f32).sin_cos();
        // |y|ⁿ + |z|ⁿ = 1
        let (across, up) = (sin.signum() * sin.abs().powf(power), cos.signum() * cos.abs().powf(power));
        let (half_width, half_height) = (0.5 * station.width, 0.5 * station.height);
        Point::new(station.x, y + half_width * across, station.z + half_height * up)
    };
    (0..segments).map(at).collect()
}

/// Cross-sections with one more between each two where the body is curved, on a smooth curve without new bumps.
fn refined(stations: &[Station]) -> Vec<Station> {
    let x: Vec<f32> = stations.iter().map(|station| station.x).collect();
    let between = |of: fn(&Station) -> f32| midway(&x, &stations.iter().map(of).collect::<Vec<_>>());
    let (width, height, z) = (between(|s| s.width), between(|s| s.height), between(|s| s.z));
    let mut all = Vec::new();
    for (k, station) in stations.iter().enumerate() {
        all.push(*station);
        let Some(next) = stations.get(k + 1) else { break };
        let bulge = (width[k] - 0.5 * (station.width + next.width)).abs()
            + (height[k] - 0.5 * (station.height + next.height)).abs();
        if bulge > STRAIGHT * station.width.max(next.width) {
            let x = 0.5 * (station.x + next.x);
            all.push(Station { x, width: width[k], height: height[k], z: z[k] });
        }
    }
    all
}

/// Values halfway between each two, on a piecewise cubic that rises and falls where the values do.
///
/// Source: F.N. Fritsch, J. Butland, SIAM J. Sci. Stat. Comput. 5:300 (1984): slopes are harmonic means.
fn midway(x: &[f32], y: &[f32]) -> Vec<f32> {
    let steps: Vec<f32> = x.windows(2).map(|pair| (pair[1] - pair[0]).max(1e-6)).collect();
    let secants: Vec<f32> = y.windows(2).zip(&steps).map(|(pair, h)| (pair[1] - pair[0]) / h).collect();
    let slope = |k: usize| match (k.checked_sub(1).and_then(|k| secants.get(k)), secants.get(k)) {
        (Some(before), Some(after)) if before * after > 0.0 => 2.0 * before * after / (before + after),
        (Some(_), Some(_)) => 0.0,
        (Some(only), None) | (None, Some(only)) => *only,
        (None, None) => 0.0,
    };
    // (y₀ + y₁)/2 + h (m₀ − m₁)/8
    steps
        .iter()
        .enumerate()
        .map(|(k, h)| 0.5 * (y[k] + y[k + 1]) + h * (slope(k) - slope(k + 1)) / 8.0)
        .collect()
}

/// The faces cut along the borders of a patch, and those within it of its material.
fn painted(faces: Vec<Face>, patch: &Patch) -> Vec<Face> {
    let (x, z) = (Point::x(), Point::z());
    let borders = [
        Plane { normal: x, offset: patch.x[0] },
        Plane { normal: -x, offset: -patch.x[1] },
        Plane { normal: z, offset: patch.z[0] },
        Plane { normal: -z, offset: -patch.z[1] },
    ];
    let mut done = Vec::new();
    let mut inside = faces;
    for border in &borders {
        let mut still_inside = Vec::new();
        for face in inside {
            match face.split(border) {
                Side::Front(face) => still_inside.push(face),
                Side::Back(face) => done.push(face),
                Side::Both(front, back) => {
                    still_inside.push(front);
                    done.push(back);
                }
            }
        }
        inside = still_inside;
    }
    // An intake stays dark.
    let repainted = inside.into_iter().map(|face| match face.material {
        Material::Dark => face,
        _ => Face { material: patch.material, ..face },
    });
    done.extend(repainted);
    done
}
