//! What is to be told of what was handed in, each in one sentence.

use std::fmt;

use serde::{Serialize, Serializer};

use super::given::Place;
use super::goal::Unfit;
use super::said;

/// A remark.
#[derive(Clone, Debug, PartialEq)]
pub enum Remark {
    /// It can't be read, and why.
    Unreadable(String),
    /// Nothing of the lesson is in it, but of these.
    OtherLessons(Vec<String>),
    /// It was done with another version of the lesson's file, and so many answers don't fit this one.
    OtherVersion(usize),
    /// So many answers can't be answers to this lesson, though it is the same version.
    Unfitting(usize),
    /// It has nobody's name.
    Nameless,
    /// The lesson was begun again so often, without what had been answered before.
    BegunAgain(u32),
    /// It holds the lesson so often, opened from different places.
    Several(usize),
    /// Its link says that it is another's.
    By(String),
    /// It was done with the numbers of another name.
    OtherNumbers(String),
    /// So many answers were typed and not given.
    NotGiven(usize),
    /// A question was answered more often than it may be.
    TooManyAnswers(Place),
    /// A goal is said to be reached, and there is no scene.
    NoScene(Place),
    /// Its link doesn't open as it says.
    Link(Place, String),
    /// A goal is said to be reached, and the scene doesn't meet it: the measure, what it is and what is wanted.
    NotMet(Place, [String; 3]),
    /// The scene doesn't count.
    Unfit(Place, Unfit),
    /// The scene begins with these numbers and not with the person's own.
    OtherStart(Place, [String; 2]),
    /// A link names no step, or one without a task.
    NoStep,
    /// A link whose step can't be read.
    BadLink(String),
    /// Links of another lesson.
    OtherLink(String),
    /// What nobody has by chance is the same as that of others.
    SameAs {
        /// The others.
        whose: Vec<String>,
        /// In which steps, counted from 0, and what it is.
        shared: Vec<(usize, &'static str)>,
    },
    /// Another of the same name was handed in before.
    Again,
}

impl fmt::Display for Remark {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unreadable(why) => write!(f, "{}", sentence(why)),
            Self::OtherLessons(titles) if titles.is_empty() => write!(f, "Nothing was done in it."),
            Self::OtherLessons(titles) => {
                write!(f, "It is of another lesson: {}.", titles.join(", "))
            }
            Self::OtherVersion(0) => {
                write!(f, "It was done with another version of the lesson’s file.")
            }
            Self::OtherVersion(left) => write!(
                f,
                "It was done with another version of the lesson’s file; {} fit this one.",
                counted(*left, "answer doesn’t", "answers don’t")
            ),
            Self::Unfitting(left) => {
                write!(
                    f,
                    "{} fit the lesson, so the report was edited.",
                    counted(*left, "answer doesn’t", "answers don’t")
                )
            }
            Self::Nameless => write!(f, "Nobody’s name is in it."),
            Self::BegunAgain(times) => {
                write!(f, "It was {}: what was answered before isn’t in it.", said::begun_again(*times))
            }
            Self::Several(count) => {
                write!(f, "The lesson is in it {count} times; what has come furthest is graded.")
            }
            Self::By(name) => write!(f, "Its link was made by “{name}”."),
            Self::OtherNumbers(name) => write!(f, "It was done with the numbers of “{name}”."),
            Self::NotGiven(count) => {
                write!(
                    f,
                    "{} begun and not given, so it doesn’t count.",
                    counted(*count, "answer was", "answers were")
                )
            }
            Self::TooManyAnswers(place) => write!(f, "{}: answered more often than it may be.", at(place)),
            Self::NoScene(place) => write!(f, "{}: said to be reached, but there is no scene.", at(place)),
            Self::Link(place, notice) => {
                write!(f, "{}: its link doesn’t open as it says: {notice}", at(place))
            }
            Self::NotMet(place, [measure, found, wanted]) => {
                write!(f, "{}: said to be reached, but {measure} {found}, wanted {wanted}.", at(place))
            }
            Self::Unfit(place, unfit) => write!(f, "{}: {}", at(place), said::unfit(unfit)),
            Self::OtherStart(place, [found, own]) => {
                write!(f, "{}: it begins with {found}; their own is {own}.", at(place))
            }
            Self::NoStep => write!(f, "A link names no step with a task."),
            Self::BadLink(notice) => write!(f, "A link doesn’t open as it says: {notice}"),
            Self::OtherLink(lesson) => write!(f, "A link is of another lesson, “{lesson}”."),
            Self::SameAs { whose, shared } => {
                let shared: Vec<String> =
                    shared.iter().map(|(step, what)| format!("{what} in step {}", step + 1)).collect();
                write!(f, "The same as {} has: {}.", whose.join(", "), shared.join(", "))
            }
            Self::Again => write!(f, "Another was handed in before under this name."),
        }
    }
}

impl Serialize for Remark {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

fn at(place: &Place) -> String {
    format!("Step {}", place.step + 1)
}

fn counted(count: usize, one: &str, more: &str) -> String {
    if count == 1 { format!("1 {one}") } else { format!("{count} {more}") }
}

/// With a capital and a full stop.
fn sentence(text: &str) -> String {
    let mut letters = text.chars();
    let first = letters.next().map(char::to_uppercase).into_iter().flatten();
    first.chain(letters).collect::<String>().trim_end_matches('.').to_owned() + "."
}
