//! The model of a plane as a whole, its four states with the further ones behind them, and which states beside the four are a plane's.

use std::sync::Arc;

use nalgebra::{DMatrix, DVector};

use super::further::{AppendedState, FurtherStates};
use super::plane::{Plane, PlaneModel, Trim};

impl AppendedState {
    /// The coordinate of the path that a plane can feed back.
    pub const fn of_path(plane: Plane) -> Self {
        match plane {
            Plane::Longitudinal => Self::Height,
            Plane::Lateral => Self::Heading,
        }
    }

    /// The washout of a plane's rate.
    pub const fn washout(plane: Plane) -> Self {
        match plane {
            Plane::Longitudinal => Self::PitchRateWashout,
            Plane::Lateral => Self::YawRateWashout,
        }
    }

    /// The controls of a plane behind their lags.
    pub const fn controls(plane: Plane) -> [Self; 2] {
        match plane {
            Plane::Longitudinal => [Self::Elevator, Self::Throttle],
            Plane::Lateral => [Self::Aileron, Self::Rudder],
        }
    }

    /// The plane in whose sources it stands; `None` where in either, or in none.
    pub const fn plane(self) -> Option<Plane> {
        match self {
            Self::Height | Self::Distance | Self::Elevator | Self::Throttle | Self::PitchRateWashout => {
                Some(Plane::Longitudinal)
            }
            Self::Heading | Self::Offset | Self::Aileron | Self::Rudder | Self::YawRateWashout => {
                Some(Plane::Lateral)
            }
            Self::Engine | Self::Other => None,
        }
    }
}

/// A control that is a state, and whose command moves the four states as well.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CommandMoves(pub AppendedState);

/// The model of A and B of all states, the four first.
///
/// A control that is a state moves the four through its column of A, which becomes its column of B; its command must not move them.
pub fn with_further(
    plane: Plane,
    trim: Trim,
    states: Vec<AppendedState>,
    a: &DMatrix<f64>,
    b: &DMatrix<f64>,
) -> Result<PlaneModel, CommandMoves> {
    let own = states.len();
    let mut model = PlaneModel {
        plane,
        a: a.fixed_view::<4, 4>(0, 0).into_owned(),
        b: b.fixed_view::<4, 2>(0, 0).into_owned(),
        trim,
        further: None,
    };
    if own == 0 {
        return Ok(model);
    }
    let mut to_four = a.view((0, 4), (4, own)).into_owned();
    for (input, control) in AppendedState::controls(plane).into_iter().enumerate() {
        let Some(k) = states.iter().position(|state| *state == control) else { continue };
        if model.b.column(input).iter().any(|x| *x != 0.0) {
            return Err(CommandMoves(control));
        }
        model.b.set_column(input, &to_four.column(k).fixed_rows::<4>(0));
        to_four.column_mut(k).fill(0.0);
    }
    model.further = Some(Arc::new(FurtherStates {
        of_four: a.view((4, 0), (own, 4)).into_owned(),
        to_four,
        among: a.view((4, 4), (own, own)).into_owned(),
        of_inputs: b.view((4, 0), (own, 2)).into_owned(),
        states,
    }));
    Ok(model)
}

impl PlaneModel {
    /// The further states; none in most models.
    pub fn further_states(&self) -> &[AppendedState] {
        self.further.as_ref().map_or(&[], |further| &further.states)
    }

    /// Place of a control among the further states, where it is one: 0 for the first input of the plane.
    pub fn actuator(&self, input: usize) -> Option<usize> {
        let control = AppendedState::controls(self.plane)[input];
        self.further.as_ref()?.place(control)
    }

    /// A of the four with their further states.
    pub fn whole_a(&self) -> DMatrix<f64> {
        let own = self.further_states().len();
        let mut a = DMatrix::zeros(4 + own, 4 + own);
        a.view_mut((0, 0), (4, 4)).copy_from(&self.a);
        if let Some(further) = &self.further {
            a.view_mut((4, 0), (own, 4)).copy_from(&further.of_four);
            a.view_mut((0, 4), (4, own)).copy_from(&further.to_four);
            a.view_mut((4, 4), (own, own)).copy_from(&further.among);
            for input in 0..2 {
                if let Some(k) = self.actuator(input) {
                    a.view_mut((0, 4 + k), (4, 1)).copy_from(&self.b.column(input));
                }
            }
        }
        a
    }

    /// Column by which the command of an input enters the rates of the four and of their further states.
    pub fn whole_b(&self, input: usize) -> DVector<f64> {
        let own = self.further_states().len();
        let mut column = DVector::zeros(4 + own);
        if self.actuator(input).is_none() {
            column.rows_mut(0, 4).copy_from(&self.b.column(input));
        }
        if let Some(further) = &self.further {
            column.rows_mut(4, own).copy_from(&further.of_inputs.column(input));
        }
        column
    }
}
