//! Words for what follows: every name and sentence that a person reads of a mode, a verdict, a disturbance or an error is made here.
//!
//! The mathematics gives data (a name, a fact, a limit and the value beside it), and here each becomes a whole phrase, chosen by
//! `match`: none is made by cutting, joining or changing the case of another. Where the same thing is called differently at the
//! head of a card and within a sentence, both forms stand in the table.
//!
//! | module | words for |
//! |---|---|
//! | [`approximation`] | textbook approximations |
//! | [`change`] | why a mode has moved |
//! | [`disturbance`] | disturbances and their shapes |
//! | [`equations`] | the rows and entries of the equations |
//! | `errors` | why something can't be had: `Display` of the errors |
//! | [`frequency`] | frequency responses |
//! | [`lesson`] | what is said of answers to the questions of lessons |
//! | [`metrics`] | metrics of a motion as a whole |
//! | [`measure`] | what can be read of a scenario, and why it can't |
//! | [`mode`] | names of modes |
//! | [`naming`] | the reason for a name |
//! | [`new_trim`] | where a control leads that stays deflected |
//! | `notice` | what was left out of a link |
//! | `placement` | why a dragged pole stops |
//! | [`refusal`] | why a typed value was refused |
//! | [`sensitivity`] | how a parameter moves the modes |
//! | [`sliders`] | pages and groups of sliders |
//! | [`small_disturbance`] | where a motion is no small disturbance any more |
//! | [`stability`] | the verdicts on a plane as a whole |
//! | [`status`] | how far the numbers can be trusted |
//! | [`sweep`] | sweeps of a parameter |
//! | [`turn`] | axes and angles, and the aircraft turned by hand |
//! | [`verdict`] | levels of handling qualities and their verdicts |
//! | [`view`] | parts of the page |

pub mod approximation;
pub mod change;
pub mod disturbance;
pub mod equations;
mod errors;
pub mod frequency;
pub mod lesson;
pub mod measure;
pub mod metrics;
pub mod mode;
pub mod naming;
pub mod new_trim;
mod notice;
mod placement;
pub mod refusal;
pub mod sensitivity;
pub mod sliders;
pub mod small_disturbance;
pub mod stability;
pub mod status;
pub mod sweep;
pub mod turn;
pub mod verdict;
pub mod view;
