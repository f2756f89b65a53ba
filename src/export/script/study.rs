//! What a script says, in no language yet: one plane of motion, its modes, and the motion on screen with our own numbers to compare with.
//!
//! The motion is that of six states, the four of the plane and the two of its path, under inputs that enter by a column and, air that
//! moves, by a column of their rate of change: ẋ = A x + B δ + Ḃ δ̇, y = C x + D δ + Ḋ δ̇. All in SI and radians.

use crate::content::LengthUnit;
use crate::export::plane::{PlaneReport, WholeReport};
use crate::export::scene::Scene;
use crate::findings::Findings;
use crate::flight::aircraft::plane::{Plane, Trim};
use crate::flight::analysis::{Motion, PlaneAnalysis};
use crate::flight::feedback::loop_modes::LoopMode;
use crate::flight::modes::mode::Mode;
use crate::flight::motion::experiment::Start;
use crate::flight::motion::experiment::{Channel, forced};
use crate::flight::motion::frequency_response::transfer;
use crate::flight::motion::inputs::Input;
use crate::flight::motion::outputs::{Output, OutputRow};
use crate::flight::motion::response::{DrivenSystem, Forcing};
use crate::key::Keyed as _;
use crate::scenario::view::Tab;
use crate::scenario::{Convention, Notation, Quantity, Scenario};
use crate::words;

/// Times and frequencies at which our own numbers are told.
const CHECKS: usize = 12;

/// A row of the six states of a motion.
pub type Row = [f64; 6];

/// One plane of motion as a script says it.
pub struct Study {
    /// The aircraft and its flight, in words.
    pub title: String,
    /// What a reader should know, a sentence each.
    pub remarks: Vec<String>,
    /// The plane in words.
    pub plane: &'static str,
    /// The steady flight.
    pub trim: Trim,
    /// Matrices, modes, eigenvalues.
    pub report: PlaneReport,
    /// The plane with all states of its source and under its law of feedback, where there is one or the other.
    pub whole: Option<WholeStudy>,
    /// The motion, where it is on screen.
    pub motion: Option<MotionStudy>,
    /// The frequency response, where that is on screen.
    pub frequency: Option<FrequencyStudy>,
}

/// A model with all states of its source, under the law of feedback.
pub struct WholeStudy {
    /// What it is, in words.
    pub title: &'static str,
    /// A and B.
    pub model: WholeReport,
    /// Name, real and imaginary part of each mode, each pair once.
    pub modes: Vec<(&'static str, f64, f64)>,
}

impl WholeStudy {
    fn of(findings: &Findings, report: &PlaneReport, scale: &Scale) -> Option<Self> {
        let analysis = findings.closed_loop()?.as_ref().ok()?;
        let (title, model) = if analysis.closed.is_fed_back() {
            ("The same under the law of feedback", scale.whole(WholeReport::under_law(&analysis.closed)))
        } else {
            ("The same with all states of the source", report.whole.clone()?)
        };
        let of_mode = |mode: &LoopMode| {
            let Mode { naming, lambda, .. } = &mode.mode;
            (words::mode::title(naming.name), lambda.re, lambda.im)
        };
        Some(Self { title, model, modes: analysis.modes.iter().map(of_mode).collect() })
    }
}

/// Something that is driven or watched.
pub struct Named {
    /// Its key.
    pub key: &'static str,
    /// Name in words.
    pub name: &'static str,
    /// SI unit; empty for a ratio.
    pub unit: &'static str,
    /// The unit of a picture.
    pub shown: &'static str,
    /// How many of it one SI unit is.
    pub per_si: f64,
}

/// A motion in six states.
pub struct MotionStudy {
    /// The disturbance in words.
    pub disturbance: String,
    /// Keys of the six states.
    pub states: [&'static str; 6],
    /// A of the six.
    pub a: [Row; 6],
    /// The state at t = 0.
    pub start: Row,
    /// What drives it.
    pub inputs: Vec<Driven>,
    /// What is watched.
    pub outputs: Vec<Watched>,
    /// Pairs of outputs, across and upward, by their places, where they are drawn over each other.
    pub portraits: Vec<(usize, usize)>,
    /// How the inputs go in time.
    pub course: Course,
    /// Times between which nothing jumps \[s\], from zero to the end; the checks are among them.
    pub bounds: Vec<f64>,
    /// Times of the values of [`Watched::checks`] \[s\].
    pub checks: Vec<f64>,
    /// Time from which it is no small disturbance any more, in a sentence.
    pub limit: Option<String>,
}

/// How inputs go in time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Course {
    /// Constant between the bounds.
    Held,
    /// Smooth between the bounds.
    Smooth,
    /// Samples joined by straight lines, so far apart \[s\].
    Sampled(f64),
}

/// An input, in the sense in which its size counts.
pub struct Driven {
    /// How it is called.
    pub named: Named,
    /// Its column.
    pub column: Row,
    /// The column of its rate of change.
    pub rate_column: Row,
    /// Its course in time, before [`Self::sign`].
    pub input: Input,
    /// Factor on the values of the course.
    pub sign: f64,
}

/// An output.
pub struct Watched {
    /// How it is called.
    pub named: Named,
    /// C.
    pub states: Row,
    /// D and Ḋ, for each input.
    pub inputs: Vec<(f64, f64)>,
    /// Our own values at the times that are checked.
    pub checks: Vec<f64>,
    /// The largest of the whole motion, to which an error is compared.
    pub largest: f64,
}

/// A frequency response of six states.
pub struct FrequencyStudy {
    /// A of the six.
    pub a: [Row; 6],
    /// The input.
    pub input: Named,
    /// Its column and that of its rate.
    pub columns: [Row; 2],
    /// The output.
    pub output: Named,
    /// C.
    pub row: Row,
    /// D and Ḋ.
    pub direct: (f64, f64),
    /// First and last frequency \[rad/s\].
    pub range: (f64, f64),
    /// ω and G(jω), real and imaginary part.
    pub checks: Vec<(f64, f64, f64)>,
}

impl Named {
    fn of(quantity: Quantity, length: LengthUnit) -> Self {
        let Quantity { key, name, dimension, .. } = quantity;
        let (shown, per_si) = (dimension.symbol(length), 1.0 / dimension.in_si(length));
        Self { key, name, unit: dimension.si_symbol(), shown, per_si }
    }
}

impl Study {
    /// The plane on screen with what is on screen of its motion; `None` where there is no model.
    pub fn of(scene: &Scene, findings: &Findings) -> Option<Self> {
        let analysis = findings.plane()?;
        let scenario = findings.scenario();
        let is_over_frequency = matches!(scene.view.response.tab, Tab::Frequency | Tab::Loop | Tab::Nyquist);
        let convention = scenario.convention();
        let scale = Scale::of(scenario.plane, convention);
        let report = scale.report(PlaneReport::of(analysis, scenario.notation));
        Some(Self {
            title: format!("{}: {}", scenario.aircraft.name, scenario.aircraft.condition),
            remarks: remarks(scene, scenario),
            plane: words::view::plane(scenario.plane),
            trim: analysis.model.trim,
            whole: WholeStudy::of(findings, &report, &scale),
            report,
            motion: (!is_over_frequency).then(|| MotionStudy::of(scene, findings)).flatten(),
            frequency: is_over_frequency.then(|| FrequencyStudy::of(scene, findings, analysis)).flatten(),
        })
    }
}

/// Where the numbers are from, and where the scene is.
fn remarks(scene: &Scene, scenario: &Scenario) -> Vec<String> {
    let aircraft = &scenario.aircraft;
    let mut remarks = vec![
        words::status::sentence(&aircraft.name, aircraft.status, scenario.is_edited()),
        format!("Source: {}", aircraft.source),
    ];
    remarks.extend(aircraft.notes.iter().cloned());
    if scenario.notation == Notation::Angles {
        remarks.push(words::notation::STATES.to_owned());
    }
    if !scenario.law.is_open(scenario.plane) {
        remarks.push(words::feedback::TAKEN_WITHOUT.to_owned());
    }
    remarks.extend(scene.link().map(|link| format!("Scene: {link}")));
    remarks
}

impl MotionStudy {
    fn of(scene: &Scene, findings: &Findings) -> Option<Self> {
        let scenario = findings.scenario();
        let plane = scenario.plane;
        let motion = findings.motion()?;
        let scale = Scale::of(plane, scenario.convention());
        let response = &scene.view.response;
        let (watched, portraits) = match response.tab {
            Tab::Phase => portraits(&response.portraits[plane]),
            _ => (response.shown[plane].clone(), Vec::new()),
        };
        let inputs: Vec<Driven> = motion
            .experiment
            .inputs
            .iter()
            .zip(&motion.forced.forcings)
            .map(|((channel, _), forcing)| Driven::of(plane, *channel, forcing, &scale))
            .collect();
        let course = match motion.experiment.inputs.first() {
            Some((_, Input::Samples { dt, .. })) => Course::Sampled(*dt),
            Some((_, input)) if !input.is_constant_between_edges() => Course::Smooth,
            _ => Course::Held,
        };
        let duration = motion.experiment.grid.duration;
        let mut edges: Vec<f64> = match course {
            Course::Sampled(_) => Vec::new(),
            Course::Held | Course::Smooth => {
                motion.experiment.inputs.iter().flat_map(|(_, input)| input.edges()).collect()
            }
        };
        edges.retain(|edge| (0.0..duration).contains(edge));
        let coarse = if course == Course::Held || course == Course::Smooth {
            findings.motion_in(CHECKS)?
        } else {
            // Samples of the motion fall on those of the air.
            motion.clone()
        };
        let places = checked(&coarse, &edges);
        let grid = coarse.experiment.grid;
        let checks: Vec<f64> = places.iter().map(|&k| grid.time(k)).collect();
        // Of an edge and a check at the same time the check stays, to the last bit.
        let end = motion.response.cut_at.is_none().then_some(duration);
        let is_apart = |time: &f64| checks.iter().all(|check| (check - time).abs() > 1e-9 * duration);
        let mut bounds: Vec<f64> = edges.into_iter().chain([0.0]).chain(end).filter(is_apart).collect();
        bounds.extend(&checks);
        bounds.sort_by(f64::total_cmp);
        bounds.dedup_by(|next, last| *next - *last < 1e-9 * duration);
        let signs: Vec<f64> = inputs.iter().map(|input| input.sign).collect();
        let outputs = watched.iter().map(|&output| {
            let row = output.row(&motion.model, &motion.forced);
            let all = coarse.values(output);
            let largest = motion.values(output).iter().fold(0.0_f64, |most, x| most.max(x.abs()));
            Watched::of(
                output,
                (&row, &scale),
                &signs,
                places.iter().filter_map(|&k| all.get(k).copied()).collect(),
                largest,
            )
        });
        Some(Self {
            disturbance: words::disturbance::choice(&scenario.disturbance.choices[plane]),
            states: scale.states(six_states(plane)),
            a: scale.matrix(six(&motion.forced)),
            start: scale.column(joined(&motion.forced.start.into(), &motion.forced.start_path.into())),
            outputs: outputs.collect(),
            portraits,
            inputs,
            course,
            bounds,
            checks,
            limit: words::small_disturbance::sentence(motion, LengthUnit::Metre),
        })
    }
}

/// How inputs enter a motion: of each its value, and its rate where that does anything.
pub struct Entering {
    /// Names of the columns.
    pub names: Vec<String>,
    /// B, row by row, with Ḃ among its columns.
    pub columns: [Vec<f64>; 6],
    /// D of each output, with Ḋ likewise.
    pub direct: Vec<Vec<f64>>,
}

impl MotionStudy {
    /// Whether the rate of an input does anything; at an edge it has none.
    pub fn has_rate(&self, input: usize) -> bool {
        let of_outputs = self.outputs.iter().any(|output| output.inputs[input].1 != 0.0);
        self.course != Course::Held && (self.inputs[input].rate_column != [0.0; 6] || of_outputs)
    }

    /// What it is: the disturbance, what is watched and in which units, and until when it is small. A line each.
    pub fn about(&self) -> Vec<String> {
        let outputs = self.outputs.iter().map(|output| match output.named.unit {
            "" => output.named.key.to_owned(),
            unit => format!("{} [{unit}]", output.named.key),
        });
        let outputs = outputs.collect::<Vec<_>>().join(", ");
        let lines = [self.disturbance.clone(), format!("Outputs: {outputs}")];
        lines.into_iter().chain(self.limit.clone()).collect()
    }

    /// How its inputs enter; where it is let go, one that does nothing.
    pub fn entering(&self) -> Entering {
        let mut entering = Entering {
            names: Vec::new(),
            columns: Default::default(),
            direct: vec![Vec::new(); self.outputs.len()],
        };
        for (k, input) in self.inputs.iter().enumerate() {
            let direct =
                |of: fn(&(f64, f64)) -> f64| self.outputs.iter().map(move |output| of(&output.inputs[k]));
            entering.put(input.named.key.to_owned(), &input.column, direct(|(d, _)| *d));
            if self.has_rate(k) {
                let rate = format!("{}_rate", input.named.key);
                entering.put(rate, &input.rate_column, direct(|(_, of_rate)| *of_rate));
            }
        }
        if self.inputs.is_empty() {
            entering.put("nothing".to_owned(), &[0.0; 6], std::iter::repeat(0.0));
        }
        entering
    }

    /// The value of the input between each two bounds.
    pub fn held(&self) -> Vec<f64> {
        let value = |t: f64| self.inputs.first().map_or(0.0, |input| input.sign * input.input.at(t));
        self.bounds.windows(2).map(|pair| value(0.5 * (pair[0] + pair[1]))).collect()
    }
}

impl Entering {
    fn put(&mut self, name: String, column: &Row, direct: impl Iterator<Item = f64>) {
        self.names.push(name);
        self.columns.iter_mut().zip(column).for_each(|(row, x)| row.push(*x));
        self.direct.iter_mut().zip(direct).for_each(|(row, x)| row.push(x));
    }
}

/// The outputs of both portraits, each once, and the portraits by their places.
fn portraits(pairs: &[(Output, Output); 2]) -> (Vec<Output>, Vec<(usize, usize)>) {
    let mut outputs: Vec<Output> = Vec::new();
    let mut place = |output: Output| {
        outputs.iter().position(|other| *other == output).unwrap_or_else(|| {
            outputs.push(output);
            outputs.len() - 1
        })
    };
    let pairs = pairs.iter().map(|&(across, upward)| (place(across), place(upward))).collect();
    (outputs, pairs)
}

/// Places of some samples that are on no edge, where an output may jump.
fn checked(motion: &Motion, edges: &[f64]) -> Vec<usize> {
    let samples = motion.response.states.len();
    let grid = motion.experiment.grid;
    let near = 1e-6 * grid.duration;
    (1..=CHECKS)
        .map(|k| k * grid.steps / CHECKS)
        .filter(|&k| k < samples && edges.iter().all(|edge| (edge - grid.time(k)).abs() > near))
        .collect()
}

impl Driven {
    fn of(plane: Plane, channel: Channel, forcing: &Forcing, scale: &Scale) -> Self {
        let sign = Quantity::input_sign(plane, channel);
        let [column, rate_column] = [forcing.column, forcing.rate_column]
            .map(|column| scale.column(joined(&(column * sign).into(), &[0.0; 2])));
        let named = Named::of(Quantity::of_input(plane, channel), scale.length);
        Self { named, column, rate_column, input: forcing.input.clone(), sign }
    }
}

impl Watched {
    fn of(
        output: Output,
        (row, scale): (&OutputRow, &Scale),
        signs: &[f64],
        checks: Vec<f64>,
        largest: f64,
    ) -> Self {
        let inputs = row.inputs.iter().zip(signs).map(|(&(d, of_rate), sign)| (d * sign, of_rate * sign));
        Self {
            named: Named::of(Quantity::of(output), scale.length),
            states: scale.row(joined(&row.states.into(), &row.path.into())),
            inputs: inputs.collect(),
            checks,
            largest,
        }
    }
}

impl FrequencyStudy {
    fn of(scene: &Scene, findings: &Findings, analysis: &PlaneAnalysis) -> Option<Self> {
        let scenario = findings.scenario();
        let (plane, channel) = (scenario.plane, scenario.driven_channel());
        let output = scene.view.response.frequency_of[plane];
        let unit = Input::Step { amplitude: 1.0, start: 0.0 };
        let driven = forced(&scenario.edited, &analysis.model, &[(channel, unit)], Start::Rest, &[]);
        let row = output.row(&analysis.model, &driven);
        let sign = Quantity::input_sign(plane, channel);
        let scale = Scale::of(plane, scenario.convention());
        let forcing = Driven::of(plane, channel, driven.forcings.first()?, &scale);
        let &(d, of_rate) = row.inputs.first()?;
        let range = findings.frequency_range();
        let frequency = |k: usize| range.0 * (range.1 / range.0).powf(k as f64 / CHECKS as f64);
        let checks = (0..=CHECKS).filter_map(|k| {
            let value = transfer(&driven, &row, 0, frequency(k))? * sign;
            Some((frequency(k), value.re, value.im))
        });
        Some(Self {
            a: scale.matrix(six(&driven)),
            columns: [forcing.column, forcing.rate_column],
            input: forcing.named,
            output: Named::of(Quantity::of(output), scale.length),
            row: scale.row(joined(&row.states.into(), &row.path.into())),
            direct: (d * sign, of_rate * sign),
            range,
            checks: checks.collect(),
        })
    }
}

/// How what is written of the states of a plane, and of its path behind them, follows from what is found in u, w, q, θ and v, p, r, φ.
struct Scale {
    /// The factor on each of the four states.
    of_states: [f64; 4],
    /// Place and key of the state that is an angle of the flow.
    angle: Option<(usize, &'static str)>,
    /// The unit of length of pictures.
    length: LengthUnit,
}

impl Scale {
    fn of(plane: Plane, convention: Convention) -> Self {
        let key = match plane {
            Plane::Longitudinal => Output::AngleOfAttack.key(),
            Plane::Lateral => Output::Sideslip.key(),
        };
        Self {
            of_states: std::array::from_fn(|state| convention.of_state(plane, state)),
            angle: convention.angle(plane).map(|place| (place, key)),
            length: convention.length,
        }
    }

    /// Of a state, of the path, or of any other behind the four.
    fn factor(&self, state: usize) -> f64 {
        self.of_states.get(state).copied().unwrap_or(1.0)
    }

    fn states<const N: usize>(&self, mut states: [&'static str; N]) -> [&'static str; N] {
        if let Some((place, key)) = self.angle {
            states[place] = key;
        }
        states
    }

    /// T x
    fn column<const N: usize>(&self, column: [f64; N]) -> [f64; N] {
        std::array::from_fn(|i| column[i] * self.factor(i))
    }

    /// c T⁻¹
    fn row<const N: usize>(&self, row: [f64; N]) -> [f64; N] {
        std::array::from_fn(|j| row[j] / self.factor(j))
    }

    /// T A T⁻¹
    fn matrix<const N: usize>(&self, a: [[f64; N]; N]) -> [[f64; N]; N] {
        std::array::from_fn(|i| self.row(a[i]).map(|entry| entry * self.factor(i)))
    }

    fn report(&self, mut report: PlaneReport) -> PlaneReport {
        report.states = self.states(report.states);
        report.a = self.matrix(report.a);
        report.b = std::array::from_fn(|i| report.b[i].map(|entry| entry * self.factor(i)));
        report.whole = report.whole.map(|whole| self.whole(whole));
        report
    }

    fn whole(&self, mut whole: WholeReport) -> WholeReport {
        if let Some((place, key)) = self.angle {
            whole.states[place] = key;
        }
        for (i, (row, inputs)) in whole.a.iter_mut().zip(&mut whole.b).enumerate() {
            row.iter_mut().enumerate().for_each(|(j, entry)| *entry *= self.factor(i) / self.factor(j));
            inputs.iter_mut().for_each(|entry| *entry *= self.factor(i));
        }
        whole
    }
}

/// Keys of the states of a plane and of its path.
fn six_states(plane: Plane) -> [&'static str; 6] {
    match plane {
        Plane::Longitudinal => ["u", "w", "q", "theta", "x", "h"],
        Plane::Lateral => ["v", "p", "r", "phi", "psi", "y"],
    }
}

/// A of states and path together.
fn six(system: &DrivenSystem) -> [Row; 6] {
    std::array::from_fn(|i| {
        std::array::from_fn(|j| match (i, j) {
            (0..4, 0..4) => system.a[(i, j)],
            (4.., 0..4) => system.path.of_states[(i - 4, j)],
            (4.., 4..) => system.path.of_path[(i - 4, j - 4)],
            _ => 0.0,
        })
    })
}

fn joined(states: &[f64; 4], path: &[f64; 2]) -> Row {
    std::array::from_fn(|k| if k < 4 { states[k] } else { path[k - 4] })
}
