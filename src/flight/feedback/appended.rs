//! States appended to the four of a plane, by an aircraft's source or by a law, and the modes that live in them.

pub use crate::flight::aircraft::further::AppendedState;
use crate::flight::modes::mode_name::ModeName;

impl AppendedState {
    /// The name of a real root that lives in it.
    pub const fn mode(self) -> ModeName {
        match self {
            Self::Height => ModeName::Height,
            Self::Heading => ModeName::Heading,
            Self::Distance | Self::Offset => ModeName::Position,
            Self::PitchRateWashout | Self::YawRateWashout => ModeName::Washout,
            Self::Elevator => ModeName::ElevatorActuator,
            Self::Throttle | Self::Engine => ModeName::Engine,
            Self::Aileron => ModeName::AileronActuator,
            Self::Rudder => ModeName::RudderActuator,
            Self::Other => ModeName::FurtherState,
        }
    }
}
