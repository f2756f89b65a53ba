//! Names for the modes, from their shape, never from a period and never from their order along the real axis.
//!
//! A mode's participation factors p_k = |l_k v_k| (left × right eigenvector) say how much each state belongs to it: w and q
//! are the mark of the short period, u and θ of the phugoid; v and r of the Dutch roll, p of roll subsidence, φ of the spiral.
//! Thresholds on the period name only half of the reference aircraft, so none is used.
//!
//! 1. The number of pairs says which families of modes there can be. Of all ways to give them to the modes, the one counts
//!    in which the modes' own states carry most (an assignment problem, with a table of all its answers).
//! 2. A family is a name only where its states carry at least as much of the mode as those of any other family. Elsewhere
//!    the mode gets a name that says what it does: a divergence or subsidence of what carries most of it, or an oscillation
//!    that mixes.
//!
//! Participation is a continuous function of the derivatives but where roots meet. Along a sweep a name therefore changes
//! only where roots meet, part or cross zero, or where two shapes exchange their states.

use smallvec::SmallVec;

use super::mode_name::{ModeName, Naming, UnnamedMode};
use super::{naming_lateral, naming_longitudinal};
use crate::flight::aircraft::plane::Plane;

/// The names of all modes of one plane together, since what one is called depends on the others.
///
/// `modes` holds each conjugate pair once: two, three or four modes. The names come in the same order.
pub(super) fn name_modes(plane: Plane, modes: &[UnnamedMode]) -> SmallVec<[Naming; 4]> {
    match plane {
        Plane::Longitudinal => naming_longitudinal::name_modes(modes),
        Plane::Lateral => naming_lateral::name_modes(modes),
    }
}

/// The reasons for names that modes of one plane have already, in the same order.
pub(in crate::flight) fn explained(plane: Plane, modes: &[(UnnamedMode, ModeName)]) -> SmallVec<[Naming; 4]> {
    let (modes, names): (SmallVec<[UnnamedMode; 4]>, SmallVec<[ModeName; 4]>) = modes.iter().copied().unzip();
    let explain = |(mode, &name): (&UnnamedMode, &ModeName)| match plane {
        Plane::Longitudinal => naming_longitudinal::explain(name, mode, &modes, &names),
        Plane::Lateral => naming_lateral::explain(name, mode, &modes),
    };
    modes.iter().zip(&names).map(explain).collect()
}
