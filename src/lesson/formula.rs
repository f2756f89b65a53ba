//! A formula in text: what it consists of. It is written as in TeX, `$\dot{u} = X_u u$`; `formula_file` reads it.

/// A piece of a formula.
#[derive(Clone, Debug, PartialEq)]
pub enum Formula {
    /// Pieces one after the other.
    Row(Vec<Self>),
    /// A letter of a symbol, Latin or Greek, set italic.
    Letter(char),
    /// A number.
    Number(String),
    /// The name of a function, set upright.
    Function(&'static str),
    /// Words.
    Words(String),
    /// A sign between two things, such as = or +, with room on both sides.
    Sign(char),
    /// A mark without room around it: a bracket, a comma.
    Mark(char),
    /// Room, in sizes of the type.
    Space(f32),
    /// Something with a mark above it.
    Accent(Accent, Box<Self>),
    /// Something with what is lowered and raised beside it.
    Script {
        /// What it stands beside.
        base: Box<Self>,
        /// What is lowered.
        lowered: Option<Box<Self>>,
        /// What is raised.
        raised: Option<Box<Self>>,
    },
    /// A fraction.
    Fraction(Box<Self>, Box<Self>),
    /// A square root.
    Root(Box<Self>),
    /// Something in brackets as high as it is; no bracket where there is none.
    Fenced(Option<char>, Box<Self>, Option<char>),
    /// Rows of entries.
    Matrix(Vec<Vec<Self>>),
}

/// A mark above a letter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Accent {
    /// A time derivative.
    Dot,
    /// A second time derivative.
    TwoDots,
    /// A line: a mean.
    Bar,
    /// A hat.
    Hat,
    /// An arrow: a vector.
    Arrow,
}

impl Formula {
    /// Whether it is a single thing, which needs no brackets in a line.
    pub fn is_single(&self) -> bool {
        match self {
            Self::Row(pieces) => pieces.len() == 1 && pieces.iter().all(Self::is_single),
            Self::Letter(_) | Self::Number(_) | Self::Accent(..) | Self::Function(_) => true,
            Self::Script { base, .. } => base.is_single(),
            Self::Fenced(..) => true,
            _ => false,
        }
    }

    /// Whether it can be set within a line: [`Self::line`] has all of it.
    pub fn is_flat(&self) -> bool {
        match self {
            Self::Row(pieces) => pieces.iter().all(Self::is_flat),
            Self::Accent(accent, base) => *accent == Accent::Dot && matches!(**base, Self::Letter(_)),
            Self::Script { base, lowered, raised } => {
                let is_flat = |script: &Option<Box<Self>>| {
                    script.as_ref().is_none_or(|script| script.is_flat() && !script.has_scripts())
                };
                base.is_flat() && is_flat(lowered) && is_flat(raised)
            }
            Self::Fraction(one, other) => one.is_flat() && other.is_flat(),
            Self::Root(inner) | Self::Fenced(_, inner, _) => inner.is_flat(),
            Self::Matrix(_) => false,
            _ => true,
        }
    }

    fn has_scripts(&self) -> bool {
        match self {
            Self::Row(pieces) => pieces.iter().any(Self::has_scripts),
            Self::Script { .. } => true,
            _ => false,
        }
    }

    /// It in one line, in the notation of the page's symbols: `u̇ = X_u u`.
    pub fn line(&self) -> String {
        let grouped = |piece: &Self| {
            if piece.is_single() { piece.line() } else { format!("({})", piece.line()) }
        };
        match self {
            Self::Row(pieces) => pieces.iter().map(Self::line).collect(),
            Self::Letter(letter) | Self::Mark(letter) => letter.to_string(),
            Self::Number(text) | Self::Words(text) => text.clone(),
            Self::Function(name) => format!("{name} "),
            Self::Sign(sign) => format!(" {sign} "),
            Self::Space(_) => " ".to_owned(),
            Self::Accent(Accent::Dot, base) => format!("{}\u{307}", base.line()),
            Self::Accent(_, base) => base.line(),
            Self::Script { base, lowered, raised } => {
                let script = |mark: &str, piece: &Option<Box<Self>>| {
                    piece.as_ref().map_or_else(String::new, |piece| format!("{mark}{{{}}}", piece.line()))
                };
                format!("{}{}{}", base.line(), script("_", lowered), script("^", raised))
            }
            Self::Fraction(above, below) => format!("{}/{}", grouped(above), grouped(below)),
            Self::Root(inner) => format!("√{}", grouped(inner)),
            Self::Fenced(left, inner, right) => {
                let mark = |mark: &Option<char>| mark.map_or_else(String::new, String::from);
                format!("{}{}{}", mark(left), inner.line(), mark(right))
            }
            Self::Matrix(rows) => {
                let row = |row: &Vec<Self>| row.iter().map(Self::line).collect::<Vec<_>>().join(", ");
                rows.iter().map(row).collect::<Vec<_>>().join("; ")
            }
        }
    }
}
