//! What a law of feedback is told to bring the aircraft to, as a change from the steady flight.

/// A quantity that is commanded: the law then feeds back how far it is from the command.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Command {
    /// Forward speed u \[m/s\], faster positive.
    Speed,
    /// Pitch angle θ \[rad\], nose-up positive.
    PitchAngle,
    /// Height h \[m\], upward positive.
    Height,
    /// Yaw rate r \[rad/s\], nose right positive.
    YawRate,
    /// Bank angle φ \[rad\], right wing down positive.
    BankAngle,
    /// Heading ψ \[rad\], nose right positive.
    Heading,
}
