//! Names for the modes, from their shape and their place among the others, never from a period.
//!
//! A mode's participation factors p_k = |l_k v_k| (left × right eigenvector) say how much each state belongs
//! to it: w and q are the mark of the short period, u and θ of the phugoid; v and r of the Dutch roll, p of roll
//! subsidence, φ of the spiral. Thresholds on the period name only half of the reference aircraft, so none is used.
//!
//! A name must not flicker while a slider moves. Two real roots can't pass each other on the real axis without
//! meeting, so roots are told apart by their order there; names then change only where roots meet, part or cross zero.
//! Two oscillations can pass one another in the plane without meeting: there a name changes once, where their |λ| are
//! equal, and the confidence says so before.

use super::mode_name::{Naming, Shape};
use super::{naming_lateral, naming_longitudinal};
use crate::flight::aircraft::plane::Plane;

/// Names all modes of one plane together, since what one is called depends on the others.
///
/// `shapes` holds each conjugate pair once: two, three or four modes. The names come in the same order.
pub(super) fn name_modes(plane: Plane, shapes: &[Shape]) -> Vec<Naming> {
    match plane {
        Plane::Longitudinal => naming_longitudinal::name_modes(shapes),
        Plane::Lateral => naming_lateral::name_modes(shapes),
    }
}
