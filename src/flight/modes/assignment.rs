//! The assignment of families of modes to modes, by their shapes.

use crate::few;
use smallvec::SmallVec;

use super::mode_name::UnnamedMode;

/// The families of `modes` in their order: of the rows of `table`, which give families to pairs first and then to real
/// roots, the one with the largest sum of `fit`.
pub(super) fn best_assignment<F: Copy>(
    modes: &[UnnamedMode],
    table: &[&[F]],
    fit: impl Fn(&UnnamedMode, F) -> f64,
) -> SmallVec<[F; 4]> {
    let mut order: SmallVec<[usize; 4]> = (0..modes.len()).collect();
    few::sort_by_key(&mut order, |&i| !modes[i].oscillates());
    let sum = |row: &[F]| order.iter().zip(row).map(|(&i, &family)| fit(&modes[i], family)).sum::<f64>();
    let mut best: Option<(f64, &[F])> = None;
    for row in table {
        let sum = sum(row);
        if best.is_none_or(|(most, _)| sum > most) {
            best = Some((sum, row));
        }
    }
    let row = best.map_or(&[][..], |(_, row)| row);
    let mut families: SmallVec<[(usize, F); 4]> = order.into_iter().zip(row.iter().copied()).collect();
    few::sort_by_key(&mut families, |&(i, _)| i);
    families.into_iter().map(|(_, family)| family).collect()
}
