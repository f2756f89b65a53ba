//! Lessons: one Markdown file a lesson, which asks before it shows. Written as `docs/LESSONS.md` says.
//!
//! A step is data: a scene, text whose numbers are measured at that scene, questions, and tasks whose goals are measures.
//! Reading is total: any text gives a [`Lesson`] or an error with file, line and what was expected.
//!
//! | file | in one line |
//! |---|---|
//! | `file` | the reader of a lesson |
//! | `step` | a step and its parts |
//! | `scene` | a link, and where it stands |
//! | `vary` | a number that each person has their own of |
//! | `varied` | the lesson of one person |
//! | `text` | running text in blocks and spans |
//! | [`formula`] | a formula in text |
//! | `formula_words` | a formula read aloud |
//! | `formula_file` | the reader of a formula, as in TeX |
//! | `number` | a number in the text, measured at a scene |
//! | `prediction` | a question, its kinds and the reasons for wrong answers |
//! | `prediction_file` | the reader of a question |
//! | `writing` | something to write in one's own words |
//! | `notes` | notes for whoever presents, with their minutes |
//! | `links_list` | a lecture out of a list of links, written as a lesson |
//! | `links_line` | a line of such a list |
//! | `answer` | an answer compared with what the model does |
//! | `truth` | what the model says to a question |
//! | `given` | what a person has given to a lesson, to be kept |
//! | [`drawing`] | a curve as it is drawn by hand |
//! | `sketch` | what matters of a curve drawn by hand |
//! | `task` | a goal, what may be used, and its conditions |
//! | `task_file` | the reader of a task |
//! | `moves` | the movements of sliders from one scene to another |
//! | `goal` | conditions judged on a scene, with how near they are |
//! | `shelf` | the glossary and the references |
//! | `course` | lessons in their order, with what they share |
//! | `said` | what is said of answers and goals |
//! | `record` | what a person has done in their lessons |
//! | `alike` | what nobody else has by chance |
//! | `submission` | what a person hands in |
//! | `links_table` | the table of a form in which links were handed in |
//! | `grade` | what was handed in, graded |
//! | `remark` | what is to be told of what was handed in |
//! | `check` | the proof that a lesson holds what it promises |

mod alike;
mod answer;
mod check;
mod course;
pub mod drawing;
mod file;
pub mod formula;
mod formula_file;
mod formula_words;
mod given;
mod goal;
mod grade;
mod links_line;
mod links_list;
mod links_table;
mod moves;
mod notes;
mod number;
mod prediction;
mod prediction_file;
mod record;
mod remark;
pub mod said;
mod scene;
mod shelf;
mod sketch;
mod step;
mod submission;
mod task;
mod task_file;
mod text;
mod truth;
mod varied;
mod vary;
mod writing;

pub use answer::{Answer, Comparison, Estimated, PlaceCompared};
pub use course::Course;
pub use file::Lesson;
pub use given::{Answers, Given, Place};
pub use goal::{Progress, Unfit, progress};
pub use grade::{Grade, GradedPart, Grader, Grades, Mark, Model, Outcome};
pub use links_list::{LinkSlide, LinksList};
pub use links_table::links_table;
pub use moves::{Move, moves};
pub use notes::Notes;
pub use number::Number;
pub use prediction::{Choice, Item, Kind, Prediction};
pub use record::{Record, Records};
pub use remark::Remark;
pub use scene::Scene;
pub use shelf::{Entry, Reference, Shelf};
pub use sketch::{Direction, End, Features};
pub use step::{Part, Step};
pub use submission::{Submission, Work};
pub use task::{Amount, Condition, SolutionAfter, Task, Wanted};
pub use text::{Span, Target, Text, TextBlock, What};
pub use truth::Truth;
pub use vary::{Vary, normalised};
pub use writing::Writing;
