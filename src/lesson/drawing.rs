//! A curve as it is drawn by hand: values at equal steps of time from the first on, as far as it has been drawn.

/// How many values a whole curve has.
pub const POINTS: usize = 61;

/// How many points it has that are moved one by one, at equal times.
pub const KNOTS: usize = 16;

/// From one of them to the next.
const APART: usize = (POINTS - 1) / (KNOTS - 1);

/// Adds a stroke of the hand from one value to another, or from the end of the curve where the hand has just been put down.
pub fn stroke(values: &mut Vec<f64>, from: Option<(usize, f64)>, to: (usize, f64)) {
    let to = (to.0.min(POINTS - 1), to.1);
    // What lies between the end of the curve and the hand is drawn straight.
    let end = values.len().checked_sub(1).map(|last| (last, values[last]));
    let start = from.or(if to.0 >= values.len() { Some(end.unwrap_or((0, 0.0))) } else { None });
    let (first, last) = match start {
        Some(start) if start.0 <= to.0 => (start, to),
        Some(start) => (to, start),
        None => (to, to),
    };
    if values.len() <= last.0 {
        values.resize(last.0 + 1, last.1);
    }
    line(values, first, last);
}

/// Sets the values from one to another on a straight line.
fn line(values: &mut [f64], first: (usize, f64), last: (usize, f64)) {
    let steps = last.0.saturating_sub(first.0).max(1) as f64;
    for (number, value) in values.iter_mut().enumerate().take(last.0 + 1).skip(first.0) {
        *value = first.1 + (last.1 - first.1) * (number - first.0) as f64 / steps;
    }
    if first.0 == last.0
        && let Some(value) = values.get_mut(last.0)
    {
        *value = last.1;
    }
}

/// The time of a knot, as a share of the whole time.
pub fn share(knot: usize) -> f64 {
    knot as f64 / (KNOTS - 1) as f64
}

/// The value at a knot; the last one drawn where the curve doesn't reach it.
pub fn knot(values: &[f64], knot: usize) -> f64 {
    values.get(knot * APART).or(values.last()).copied().unwrap_or(0.0)
}

/// Moves a knot, with what lies between it and those beside it.
pub fn set_knot(values: &mut Vec<f64>, number: usize, value: f64) {
    let at = number.min(KNOTS - 1) * APART;
    let before = at.checked_sub(APART).map(|at| (at, knot(values, number - 1)));
    let after = (at + APART < values.len()).then(|| (at + APART, knot(values, number + 1)));
    if values.len() <= at {
        let last = values.last().copied().unwrap_or(0.0);
        values.resize(at + 1, last);
    }
    line(values, before.unwrap_or((at, value)), (at, value));
    if let Some(after) = after {
        line(values, (at, value), after);
    }
}

/// Whether a curve has been drawn to its end, or nearly.
pub fn is_whole(values: &[f64]) -> bool {
    10 * values.len() >= 9 * POINTS
}

/// The value at the end is held to the very end.
pub fn finish(values: &mut Vec<f64>) {
    if let Some(last) = values.last().copied() {
        values.resize(POINTS, last);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_stroke_is_straight_from_where_the_hand_was_and_ends_where_it_is() {
        let mut values = Vec::new();
        stroke(&mut values, None, (4, 2.0));
        assert_eq!(values, [0.0, 0.5, 1.0, 1.5, 2.0]);
        stroke(&mut values, Some((4, 2.0)), (6, 0.0));
        assert_eq!(values[4..], [2.0, 1.0, 0.0]);
        // Drawn over, backwards too.
        stroke(&mut values, None, (3, 9.0));
        stroke(&mut values, Some((3, 9.0)), (1, 7.0));
        assert_eq!(values, [0.0, 7.0, 8.0, 9.0, 2.0, 1.0, 0.0]);
        stroke(&mut values, Some((1, 7.0)), (999, 1.0));
        assert_eq!(values.len(), POINTS);
    }

    #[test]
    fn a_knot_takes_what_is_beside_it_along_and_the_end_is_held() {
        let mut values = Vec::new();
        set_knot(&mut values, 1, 4.0);
        assert_eq!(values, [0.0, 1.0, 2.0, 3.0, 4.0]);
        set_knot(&mut values, 2, 0.0);
        set_knot(&mut values, 0, 8.0);
        assert_eq!(values, [8.0, 7.0, 6.0, 5.0, 4.0, 3.0, 2.0, 1.0, 0.0]);
        assert!(!is_whole(&values));
        set_knot(&mut values, 15, 1.0);
        assert!(is_whole(&values));
        finish(&mut values);
        assert_eq!((values.len(), knot(&values, 15), knot(&[], 3)), (POINTS, 1.0, 0.0));
    }
}
