//! How each entry of A and B is made of dimensional derivatives and the steady flight, as data: written out in the field's notation,
//! and evaluated, so that a test can hold what is written to what [`longitudinal_model`] and [`lateral_model`] compute.
//!
//! [`longitudinal_model`]: crate::flight::aircraft::derivatives::longitudinal_model
//! [`lateral_model`]: crate::flight::aircraft::derivatives::lateral_model

use crate::flight::aircraft::aircraft_model::DerivativeModel;
use crate::flight::aircraft::plane::Plane;
use crate::scenario::{Convention, Notation, Parameter, Scenario};

/// A number that entries are made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Atom {
    /// A dimensional derivative, by the key of its slider.
    Derivative(&'static str),
    /// U₀ = V cos α₀.
    U0,
    /// W₀ = V sin α₀.
    W0,
    /// V, by which w and v are divided to give α and β.
    Speed,
    /// g.
    Gravity,
    /// cos θ₀.
    CosPitch,
    /// sin θ₀.
    SinPitch,
    /// tan θ₀.
    TanPitch,
    /// D = 1 − Z_ẇ, by which the z equation is divided.
    Heave,
    /// Ixz/Ix.
    RollProduct,
    /// Ixz/Iz.
    YawProduct,
    /// G = 1/(1 − Ixz²/(Ix Iz)).
    Coupling,
    /// What a person has added to the entry itself.
    Added,
}

/// A formula.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Form {
    /// A whole number: 0 or 1, by the structure of the equations.
    Whole(i8),
    /// A number with a symbol.
    Of(Atom),
    /// −x.
    Minus(&'static Form),
    /// x + y + …
    Sum(&'static [Form]),
    /// x y …
    Product(&'static [Form]),
    /// x/y.
    Quotient(&'static Form, &'static Form),
}

use Atom::{CosPitch, Coupling, Gravity, Heave, RollProduct, SinPitch, Speed, TanPitch, U0, W0, YawProduct};
use Form::{Minus, Of, Product, Quotient, Sum, Whole};

const fn d(key: &'static str) -> Form {
    Of(Atom::Derivative(key))
}

const V: Form = Of(Speed);
const D: Form = Of(Heave);
/// V D
const VD: Form = Product(&[V, D]);
const M_WDOT: Form = d("m_wdot");
const WEIGHT_ALONG: Form = Product(&[Of(Gravity), Of(CosPitch)]);
const WEIGHT_ACROSS: Form = Product(&[Of(Gravity), Of(SinPitch)]);

/// Rows of the longitudinal A and B: u̇, ẇ, q̇, θ̇ of u, w, q, θ, δe, δt. `$over` is what the z equation is divided by: D, and of α̇ V D.
macro_rules! longitudinal {
    ($over:ident) => {
        [
            [
                d("x_u"),
                d("x_w"),
                Sum(&[d("x_q"), Minus(&Of(W0))]),
                Minus(&WEIGHT_ALONG),
                d("x_de"),
                d("x_dt"),
            ],
            [
                Quotient(&d("z_u"), &$over),
                Quotient(&d("z_w"), &$over),
                Quotient(&Sum(&[Of(U0), d("z_q")]), &$over),
                Minus(&Quotient(&WEIGHT_ACROSS, &$over)),
                Quotient(&d("z_de"), &$over),
                Quotient(&d("z_dt"), &$over),
            ],
            [
                Sum(&[d("m_u"), Quotient(&Product(&[M_WDOT, d("z_u")]), &$over)]),
                Sum(&[d("m_w"), Quotient(&Product(&[M_WDOT, d("z_w")]), &$over)]),
                Sum(&[d("m_q"), Quotient(&Product(&[M_WDOT, Sum(&[Of(U0), d("z_q")])]), &$over)]),
                Minus(&Quotient(&Product(&[M_WDOT, WEIGHT_ACROSS]), &$over)),
                Sum(&[d("m_de"), Quotient(&Product(&[M_WDOT, d("z_de")]), &$over)]),
                Sum(&[d("m_dt"), Quotient(&Product(&[M_WDOT, d("z_dt")]), &$over)]),
            ],
            [Whole(0), Whole(0), Whole(1), Whole(0), Whole(0), Whole(0)],
        ]
    };
}

const LONGITUDINAL: [[Form; 6]; 4] = longitudinal!(D);
const LONGITUDINAL_IN_ANGLES: [[Form; 6]; 4] = longitudinal!(VD);

/// L′ = (L + (Ixz/Ix) N) G.
macro_rules! rolling {
    ($l:literal, $n:literal) => {
        Product(&[Sum(&[d($l), Product(&[Of(RollProduct), d($n)])]), Of(Coupling)])
    };
}

/// N′ = (N + (Ixz/Iz) L) G.
macro_rules! yawing {
    ($l:literal, $n:literal) => {
        Product(&[Sum(&[d($n), Product(&[Of(YawProduct), d($l)])]), Of(Coupling)])
    };
}

/// v̇ of v, p, r, φ, δa, δr.
const SIDEWAYS: [Form; 6] = [
    d("y_v"),
    Sum(&[d("y_p"), Of(W0)]),
    Sum(&[d("y_r"), Minus(&Of(U0))]),
    WEIGHT_ALONG,
    d("y_da"),
    d("y_dr"),
];

const ROLLING: [Form; 6] = [
    rolling!("l_v", "n_v"),
    rolling!("l_p", "n_p"),
    rolling!("l_r", "n_r"),
    Whole(0),
    rolling!("l_da", "n_da"),
    rolling!("l_dr", "n_dr"),
];

const YAWING: [Form; 6] = [
    yawing!("l_v", "n_v"),
    yawing!("l_p", "n_p"),
    yawing!("l_r", "n_r"),
    Whole(0),
    yawing!("l_da", "n_da"),
    yawing!("l_dr", "n_dr"),
];

const BANKING: [Form; 6] = [Whole(0), Whole(1), Of(TanPitch), Whole(0), Whole(0), Whole(0)];

/// Rows of the lateral A and B: v̇, ṗ, ṙ, φ̇ of v, p, r, φ, δa, δr.
const LATERAL: [[Form; 6]; 4] = [SIDEWAYS, ROLLING, YAWING, BANKING];
/// The same of β, whose rate is v̇ over V.
const LATERAL_IN_ANGLES: [[Form; 6]; 4] = [
    [
        Quotient(&SIDEWAYS[0], &V),
        Quotient(&SIDEWAYS[1], &V),
        Quotient(&SIDEWAYS[2], &V),
        Quotient(&SIDEWAYS[3], &V),
        Quotient(&SIDEWAYS[4], &V),
        Quotient(&SIDEWAYS[5], &V),
    ],
    ROLLING,
    YAWING,
    BANKING,
];

/// How the entry of a row and a column is made: columns 0 to 3 are those of A, 4 and 5 those of B.
pub fn form(plane: Plane, row: usize, column: usize, notation: Notation) -> Form {
    let rows = match (plane, notation) {
        (Plane::Longitudinal, Notation::Velocities) => &LONGITUDINAL,
        (Plane::Longitudinal, Notation::Angles) => &LONGITUDINAL_IN_ANGLES,
        (Plane::Lateral, Notation::Velocities) => &LATERAL,
        (Plane::Lateral, Notation::Angles) => &LATERAL_IN_ANGLES,
    };
    rows.get(row).and_then(|row| row.get(column)).copied().unwrap_or(Whole(0))
}

impl Atom {
    /// Its symbol, in the notation of the sliders' symbols.
    pub fn symbol(self, convention: Convention) -> &'static str {
        match self {
            Self::Derivative(key) => {
                Parameter::find(key).map_or("", |parameter| parameter.written(convention).symbol)
            }
            Self::U0 => "U_0",
            Self::W0 => "W_0",
            Self::Speed => "V",
            Self::Gravity => "g",
            Self::CosPitch => "cos θ_0",
            Self::SinPitch => "sin θ_0",
            Self::TanPitch => "tan θ_0",
            Self::Heave => "D",
            Self::RollProduct => "i_x",
            Self::YawProduct => "i_z",
            Self::Coupling => "G",
            Self::Added => "Δ",
        }
    }

    /// What it stands for, where its symbol is this page's own.
    pub fn definition(self, notation: Notation) -> Option<&'static str> {
        match self {
            Self::Heave if notation == Notation::Angles => Some("D = 1 − Z_α\u{307}/V"),
            Self::Heave => Some("D = 1 − Z_ẇ"),
            Self::RollProduct => Some("i_x = I_xz/I_x"),
            Self::YawProduct => Some("i_z = I_xz/I_z"),
            Self::Coupling => Some("G = 1/(1 − i_x i_z)"),
            _ => None,
        }
    }

    /// Its value \[SI\] in a notation; `None` for what is of one entry only, and of a plane that the source has nothing of.
    pub fn value(
        self,
        scenario: &Scenario,
        derived: &DerivativeModel,
        convention: Convention,
    ) -> Option<f64> {
        let DerivativeModel { trim, longitudinal, lateral, .. } = derived;
        let products = || lateral.as_ref().map(|d| (d.ixz_over_ix, d.ixz_over_iz));
        match self {
            Self::Derivative(key) => Parameter::find(key)
                .map(|parameter| parameter.get(scenario) * parameter.written(convention).factor),
            Self::U0 => Some(trim.u0()),
            Self::W0 => Some(trim.w0()),
            Self::Speed => Some(trim.speed),
            Self::Gravity => Some(trim.gravity),
            Self::CosPitch => Some(trim.theta0().cos()),
            Self::SinPitch => Some(trim.theta0().sin()),
            Self::TanPitch => Some(trim.theta0().tan()),
            Self::Heave => longitudinal.as_ref().map(|d| 1.0 - d.z_wdot),
            Self::RollProduct => products().map(|(roll, _)| roll),
            Self::YawProduct => products().map(|(_, yaw)| yaw),
            Self::Coupling => products().map(|(roll, yaw)| 1.0 / (1.0 - roll * yaw)),
            Self::Added => None,
        }
    }
}

impl Form {
    /// Written out, in the notation of the sliders' symbols.
    pub fn text(&self, convention: Convention) -> String {
        match self {
            Whole(number) => number.to_string(),
            Of(atom) => atom.symbol(convention).to_owned(),
            Minus(form) => format!("−{}", form.as_factor(convention)),
            Sum(terms) => {
                let mut text = String::new();
                for term in *terms {
                    match term {
                        Minus(form) if !text.is_empty() => {
                            text.push_str(&format!(" − {}", form.as_factor(convention)))
                        }
                        _ if text.is_empty() => text.push_str(&term.text(convention)),
                        _ => text.push_str(&format!(" + {}", term.text(convention))),
                    }
                }
                text
            }
            Product(factors) => {
                factors.iter().map(|factor| factor.as_factor(convention)).collect::<Vec<_>>().join(" ")
            }
            Quotient(above, below) => {
                let below = match below {
                    Product(_) => format!("({})", below.text(convention)),
                    _ => below.as_factor(convention),
                };
                format!("{}/{below}", above.as_factor(convention))
            }
        }
    }

    /// In brackets where it is a sum.
    fn as_factor(&self, convention: Convention) -> String {
        let text = self.text(convention);
        if matches!(self, Sum(_)) { format!("({text})") } else { text }
    }

    /// What it is made of, in the order of writing, each once.
    pub fn atoms(&self) -> Vec<Atom> {
        let mut atoms = Vec::new();
        self.collect(&mut atoms);
        atoms
    }

    fn collect(&self, atoms: &mut Vec<Atom>) {
        match self {
            Whole(_) => {}
            Of(atom) if atoms.contains(atom) => {}
            Of(atom) => atoms.push(*atom),
            Minus(form) => form.collect(atoms),
            Sum(forms) | Product(forms) => forms.iter().for_each(|form| form.collect(atoms)),
            Quotient(above, below) => {
                above.collect(atoms);
                below.collect(atoms);
            }
        }
    }

    /// Its value \[SI\] with the values of its atoms.
    pub fn value(&self, of: &impl Fn(Atom) -> Option<f64>) -> Option<f64> {
        match self {
            Whole(number) => Some(f64::from(*number)),
            Of(atom) => of(*atom),
            Minus(form) => Some(-form.value(of)?),
            Sum(terms) => terms.iter().map(|term| term.value(of)).sum(),
            Product(factors) => factors.iter().map(|factor| factor.value(of)).product(),
            Quotient(above, below) => Some(above.value(of)? / below.value(of)?),
        }
    }
}
