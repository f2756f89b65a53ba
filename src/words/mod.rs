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
//! | [`chart`] | a measure over a slider |
//! | [`disturbance`] | disturbances and their shapes |
//! | [`equations`] | the rows and entries of the equations |
//! | `errors` | why something can't be had: `Display` of the errors, and [`Told`] in a unit of length |
//! | [`feedback`] | the law of feedback |
//! | [`frequency`] | frequency responses |
//! | [`lesson`] | what is said of answers to the questions of lessons |
//! | [`limits`] | where limits of the controls hold a law of feedback back |
//! | [`loops`] | loops of a law and their margins |
//! | [`metrics`] | metrics of a motion as a whole |
//! | [`measure`] | what can be read of a scenario, and why it can't |
//! | [`mode`] | names of modes |
//! | [`naming`] | the reason for a name |
//! | [`new_trim`] | where a control leads that stays deflected |
//! | `notice` | what was left out of a link |
//! | `placement` | why a dragged pole stops |
//! | [`pole_map`] | what a sighted person sees on a pole map |
//! | [`refusal`] | why a typed value was refused |
//! | [`scene`] | a scene in a few words |
//! | [`sensitivity`] | how a parameter moves the modes |
//! | [`sliders`] | pages and groups of sliders |
//! | [`small_disturbance`] | where a motion is no small disturbance any more |
//! | [`stability`] | the verdicts on a plane as a whole |
//! | [`stage`] | what of the page is on, hidden and locked |
//! | [`status`] | how far the numbers can be trusted |
//! | [`sweep`] | sweeps of a parameter |
//! | [`transfer_function`] | transfer functions in factored form |
//! | [`turn`] | axes and angles, and the aircraft turned by hand |
//! | [`verdict`] | levels of handling qualities and their verdicts |
//! | [`view`] | parts of the page |

pub mod approximation;
pub mod change;
pub mod chart;
pub mod disturbance;
pub mod equations;
mod errors;
pub mod feedback;
pub mod frequency;
pub mod lesson;
pub mod limits;
pub mod loops;
pub mod measure;
pub mod metrics;
pub mod mode;
pub mod naming;
pub mod new_trim;
pub mod notation;
mod notice;
mod placement;
pub mod pole_map;
pub mod refusal;
pub mod scene;
pub mod sensitivity;
pub mod sliders;
pub mod small_disturbance;
pub mod stability;
pub mod stage;
pub mod status;
pub mod sweep;
pub mod transfer_function;
pub mod turn;
pub mod verdict;
pub mod view;

pub use errors::Told;
