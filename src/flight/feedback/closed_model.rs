//! The model of an aircraft under a law: its states with those of the law behind them, ẋ = A x.
//!
//! ```text
//! ẋ₄ = A₄ x₄ + Σ bᵢ δᵢ                       the aircraft; where its source has further states, those behind the four (further)
//! ḣ = …  or  ψ̇ = r/cos θ₀                    what of the path is measured (path_rates), where the source doesn't have it
//! ż = (y − z)/T,    y_washed = y − z         s/(s + 1/T) on the rate
//! δ̇ᵢ = (vᵢ − δᵢ)/τᵢ                          the lag of the actuator; without one δᵢ = vᵢ
//! vᵢ = Σ kᵢⱼ yⱼ                              what the law asks for
//! ```
//!
//! Where something is commanded, y is less by the command wherever it is used.
//!
//! A control that is a state of the source has its actuator there: the law commands that one, and appends none of its own. Without a
//! law, or with one whose gains are zero, this is the aircraft with its further states.

use nalgebra::{DMatrix, DVector, RowDVector, Vector2, Vector4};
use smallvec::SmallVec;

use super::appended::AppendedState;
use super::law::{Law, PATH, RATE, SIGNALS, signals};
use crate::flight::aircraft::aircraft_model::ModelError;
use crate::flight::aircraft::plane::PlaneModel;
use crate::flight::motion::inputs::Input;
use crate::flight::motion::outputs::Output;
use crate::flight::motion::path_rates::path_rates;
use crate::flight::motion::response::{DrivenSystem, Forcing};

/// States behind the four: those of the source first, then those of a law.
pub type Appended = SmallVec<[AppendedState; 4]>;

/// The states behind the four of a model under a law.
///
/// Behind those of the source, a state of the law is there only where something comes through it: a height or heading with a gain, a
/// washout with a time constant and a gain of its rate, an actuator with a time constant and a gain to its control.
pub fn appended_by(law: &Law, model: &PlaneModel) -> Appended {
    let plane = model.plane;
    let of_plane = &law.planes[plane];
    let is_used = |signal: usize| of_plane.gains().iter().any(|gains| gains[signal] != 0.0);
    let mut states = Appended::from_slice(model.further_states());
    let path = AppendedState::of_path(plane);
    if is_used(PATH) && !states.contains(&path) {
        states.push(path);
    }
    if of_plane.washout != 0.0 && is_used(RATE) {
        states.push(AppendedState::washout(plane));
    }
    let controls = AppendedState::controls(plane).into_iter().zip(law.lags(plane)).zip(of_plane.gains());
    for (input, ((control, lag), gains)) in controls.enumerate() {
        if model.actuator(input).is_none() && lag != 0.0 && gains.iter().any(|gain| *gain != 0.0) {
            states.push(control);
        }
    }
    states
}

/// An aircraft in one plane under a law.
#[derive(Clone, Debug, PartialEq)]
pub struct ClosedModel {
    /// The aircraft without the law.
    pub model: PlaneModel,
    /// The states behind the four.
    pub appended: Appended,
    /// State matrix of the whole.
    pub a: DMatrix<f64>,
    /// What the law asks of each input, v = K x: two rows.
    pub asked: DMatrix<f64>,
    /// Column by which what is asked of an input enters the rates: two columns.
    pub enters: DMatrix<f64>,
    /// Column by which the pilot's command of an input enters the rates: two columns.
    commands: DMatrix<f64>,
    /// Rows that read what is measured, after the washout, off the states.
    measured: [RowDVector<f64>; SIGNALS],
    gains: [[f64; SIGNALS]; 2],
}

impl ClosedModel {
    /// The model under a law, with the states that it appends.
    pub fn new(model: &PlaneModel, law: &Law) -> Result<Self, ModelError> {
        Self::with(model, law, appended_by(law, model))
    }

    /// The same with given states behind those of the source: along the range of a gain, those of one end stay where it is zero.
    pub fn with(model: &PlaneModel, law: &Law, appended: Appended) -> Result<Self, ModelError> {
        let plane = model.plane;
        let of_plane = &law.planes[plane];
        let source = model.further_states();
        let own = source.len();
        let added = appended.strip_prefix(source).unwrap_or(&appended);
        let appended: Appended = source.iter().chain(added).copied().collect();
        let n = 4 + appended.len();
        let place = |state: AppendedState| appended.iter().position(|other| *other == state).map(|k| 4 + k);
        let of_law = |state: AppendedState| place(state).filter(|k| *k >= 4 + own);
        let path = place(AppendedState::of_path(plane));
        let washout = of_law(AppendedState::washout(plane));
        let controls = AppendedState::controls(plane).map(of_law);

        let mut a = model.whole_a().resize(n, n, 0.0);
        let mut commands = DMatrix::zeros(n, 2);
        for input in 0..2 {
            commands.view_mut((0, input), (4 + own, 1)).copy_from(&model.whole_b(input));
        }
        let coordinate = PATH_COORDINATE[plane as usize];
        if let Some(row) = of_law(AppendedState::of_path(plane)) {
            a.view_mut((row, 0), (1, 4)).copy_from(&path_rates(model).of_states.row(coordinate));
        }
        let still = still(model);
        let mut measured = signals(plane).map(|output| {
            let of = output.row(model, &still);
            let mut row = RowDVector::zeros(n);
            row.columns_mut(0, 4).copy_from(&of.states.transpose());
            if let Some(path) = path {
                row[path] = of.path[coordinate];
            }
            row
        });
        if let Some(z) = washout {
            // ż = (y − z)/T
            let filled = measured[RATE].clone() / of_plane.washout;
            a.row_mut(z).copy_from(&filled);
            a[(z, z)] = -1.0 / of_plane.washout;
            measured[RATE][z] -= 1.0;
        }
        let mut enters = DMatrix::zeros(n, 2);
        for (input, (lag, control)) in law.lags(plane).into_iter().zip(controls).enumerate() {
            match control {
                Some(state) => {
                    // δ̇ = (v − δ)/τ
                    a.set_column(state, &commands.column(input));
                    a[(state, state)] = -1.0 / lag;
                    enters[(state, input)] = 1.0 / lag;
                }
                None => enters.set_column(input, &commands.column(input)),
            }
        }
        let gains = of_plane.gains().map(|gains| *gains);
        let mut asked = DMatrix::zeros(2, n);
        for (input, gains) in gains.iter().enumerate() {
            for (gain, row) in gains.iter().zip(&measured) {
                let sum = asked.row(input) + row * *gain;
                asked.row_mut(input).copy_from(&sum);
            }
        }
        a += &enters * &asked;
        if !a.iter().all(|x| x.is_finite()) {
            return Err(ModelError::NotFinite { plane });
        }
        Ok(Self { model: model.clone(), appended, a, asked, enters, commands, measured, gains })
    }

    /// Number of states.
    pub fn size(&self) -> usize {
        self.a.nrows()
    }

    /// Columns by which a pilot's command of each input enters the rates.
    pub fn commands(&self) -> &DMatrix<f64> {
        &self.commands
    }

    /// The matrix with the way to one input cut: what is asked of it is not done.
    pub fn cut(&self, input: usize) -> DMatrix<f64> {
        &self.a - self.enters.column(input) * self.asked.row(input)
    }

    /// Whether anything is asked of an input.
    pub fn is_driven(&self, input: usize) -> bool {
        self.gains[input].iter().any(|gain| *gain != 0.0)
    }

    /// How many of the appended states are of the source.
    pub fn of_source(&self) -> usize {
        self.model.further_states().len()
    }

    /// Whether the law moves anything.
    pub fn is_fed_back(&self) -> bool {
        [0, 1].into_iter().any(|input| self.is_driven(input))
    }

    /// Whether the four states fly otherwise than alone: moved by the law, or pushed by a further state of the source.
    pub fn pushes_the_four(&self) -> bool {
        self.is_fed_back() || self.a.view((0, 4), (4, self.of_source())).iter().any(|x| *x != 0.0)
    }

    /// The matrix whose roots are those of the four states and of each appended state by itself: without what the law asks for, and
    /// without what the states of the source do to the four and to each other.
    pub fn apart(&self) -> DMatrix<f64> {
        let mut apart = &self.a - &self.enters * &self.asked;
        let own = self.of_source();
        for k in 4..4 + own {
            let root = apart[(k, k)];
            apart.view_mut((0, k), (4 + own, 1)).fill(0.0);
            apart[(k, k)] = root;
        }
        apart
    }

    /// Columns by which a disturbance of the aircraft, and its rate of change, enter the whole: `forcing` is that of the four states.
    pub fn columns(&self, forcing: &Forcing) -> [DVector<f64>; 2] {
        let felt = self.felt(forcing);
        let extended = |column: &Vector4<f64>| {
            let mut long = DVector::zeros(self.size());
            long.rows_mut(0, 4).copy_from(column);
            long
        };
        let base = match forcing.control {
            Some(input) => self.commands.column(input).into_owned(),
            None => extended(&forcing.column),
        };
        let mut column = base + &self.enters * felt;
        let washout = AppendedState::washout(self.model.plane);
        if let Some(z) = self.appended.iter().position(|state| *state == washout)
            && self.commanded(forcing) == Some(RATE)
        {
            // ż = (y − command − z)/T with −1/T on the diagonal
            column[4 + z] += self.a[(4 + z, 4 + z)];
        }
        [column, extended(&forcing.rate_column)]
    }

    /// Which of the signals a forcing commands, if one.
    fn commanded(&self, forcing: &Forcing) -> Option<usize> {
        let output = Output::commanded(forcing.command?);
        signals(self.model.plane).iter().position(|signal| *signal == output)
    }

    /// What the law asks of each input at once for a unit of a disturbance: a vane feels the air that a gust moves, and a command
    /// counts against what is measured.
    pub fn felt(&self, forcing: &Forcing) -> Vector2<f64> {
        let disturbed = DrivenSystem { forcings: vec![forcing.clone()], ..still(&self.model) };
        let mut at_once = signals(self.model.plane).map(|output| {
            output.row(&self.model, &disturbed).inputs.first().map_or(0.0, |(of_value, _)| *of_value)
        });
        if let Some(signal) = self.commanded(forcing) {
            at_once[signal] -= 1.0;
        }
        let asked = |gains: &[f64; SIGNALS]| gains.iter().zip(&at_once).map(|(k, d)| k * d).sum();
        Vector2::new(asked(&self.gains[0]), asked(&self.gains[1]))
    }

    /// Rows that read what the law moves each control by off the states, and whether what is [felt](Self::felt) comes to it at once. Of a
    /// control that is a state of the source it is the command.
    pub fn controls(&self) -> [(RowDVector<f64>, bool); 2] {
        let controls = AppendedState::controls(self.model.plane);
        let own = self.of_source();
        [0, 1].map(|input| {
            let state = self.appended.iter().skip(own).position(|state| *state == controls[input]);
            match state {
                Some(k) => {
                    let mut row = RowDVector::zeros(self.size());
                    row[4 + own + k] = 1.0;
                    (row, false)
                }
                None => (self.asked.row(input).into_owned(), true),
            }
        })
    }

    /// The aircraft's own equations with what disturbs it, and behind that what moves it beside: a forcing for what the law moves each
    /// control by, then one for each further state of the source. Their courses are for the caller to know.
    pub fn with_courses(
        &self,
        forced: &DrivenSystem,
        controls: [Input; 2],
        further: impl Fn(usize) -> Input,
    ) -> DrivenSystem {
        let at_once = |input: usize| match self.model.actuator(input) {
            Some(_) => Vector4::zeros(),
            None => self.model.b.column(input).into_owned(),
        };
        let mut whole = forced.clone();
        for forcing in &mut whole.forcings {
            if let Some(input) = forcing.control {
                forcing.column = at_once(input);
            }
        }
        for (input, course) in controls.into_iter().enumerate() {
            whole.forcings.push(Forcing::new(at_once(input), course));
        }
        for k in 0..self.of_source() {
            whole.forcings.push(Forcing::new(self.a.fixed_view::<4, 1>(0, 4 + k).into_owned(), further(k)));
        }
        whole
    }

    /// ∂A/∂k for the gain of a signal to an input.
    pub fn gain_rate(&self, input: usize, signal: usize) -> DMatrix<f64> {
        self.enters.column(input) * &self.measured[signal]
    }
}

/// A model that nothing drives, at rest.
fn still(model: &PlaneModel) -> DrivenSystem {
    DrivenSystem {
        a: model.a,
        path: path_rates(model),
        forcings: Vec::new(),
        start: Vector4::zeros(),
        start_path: Vector2::zeros(),
    }
}

/// Coordinate of the path that is measured, by plane: height, heading (see [`path_rates`]).
const PATH_COORDINATE: [usize; 2] = [1, 0];
