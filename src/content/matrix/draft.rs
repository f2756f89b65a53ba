//! The content of a file of matrices, whatever its form, and the aircraft that follows.

use crate::content::shapes::USUAL_SHAPE;
use nalgebra::{Matrix4, Matrix4x2};

use super::names::{self, INPUTS_EXPECTED, Input, Kind, STATES_EXPECTED, State};
use crate::content::aircraft::{Aircraft, Baseline, LengthUnit, Particulars, PlaneNotes, Status};
use crate::content::units::UnitSystem;
use crate::flight::aircraft::aircraft_model::{AircraftModel, MatrixModel};
use crate::flight::aircraft::plane::{ByPlane, Plane, PlaneModel, Trim};
use crate::flight::aircraft::states::{Lateral, entry};
use crate::flight::analysis::STANDARD_GRAVITY;
use crate::flight::motion::control_limits::NamedLimits;
use crate::number::significant;

/// A line, counted from 1, and what is wrong there.
pub(in crate::content) type Problem = (usize, String);

/// Something and the line on which it stands.
#[derive(Clone, Debug)]
pub(in crate::content) struct At<T> {
    pub line: usize,
    pub value: T,
}

/// Rows of numbers, each with its line.
pub(in crate::content) type Rows = Vec<At<Vec<f64>>>;

/// Value of a setting: the text after its name.
#[derive(Clone, Debug)]
pub(in crate::content) enum Entry {
    Number(f64),
    Text(String),
    Names(Vec<String>),
    Rows(Rows),
}

impl Entry {
    const fn kind(&self) -> &'static str {
        match self {
            Self::Number(_) => "a number",
            Self::Text(_) => "a text",
            Self::Names(_) => "a list of names",
            Self::Rows(_) => "a matrix",
        }
    }
}

/// A file as it was read, before anything is checked.
#[derive(Clone, Debug, Default)]
pub(in crate::content) struct Draft {
    entries: Vec<(&'static str, At<Entry>)>,
    /// Matrices under names that mean nothing here, as `F = [ … ]`.
    pub strangers: Vec<(String, At<Rows>)>,
    /// Those that are changed after they were given, which matters only of what is A or B.
    pub changed: Vec<(String, Problem)>,
    /// What a reader of the matrices must know, such as digits that were not printed.
    pub remarks: Vec<String>,
}

/// Every setting by each name that a file may give it.
const KEYS: [(&str, &[&str]); 10] = [
    ("units", &["units"]),
    ("angles", &["angles"]),
    ("speed", &["speed", "V", "V0", "V_0", "velocity", "airspeed", "TAS"]),
    ("u0", &["u0", "U0", "u_0", "U_0"]),
    ("alpha0_deg", &["alpha0_deg"]),
    ("gamma0_deg", &["gamma0_deg"]),
    ("states", &["states"]),
    ("inputs", &["inputs"]),
    ("A", &["A"]),
    ("B", &["B"]),
];

/// A setting in a comment, read as far as it makes sense: a comment about the speed in words is just a comment.
pub(super) fn setting_in_comment(comment: &str) -> Option<(&'static str, Entry)> {
    let (name, value) = comment.split_once([':', '='])?;
    let (key, value) = (setting(name.trim())?, value.trim());
    let entry = match key {
        "A" | "B" => return None,
        "speed" | "u0" | "alpha0_deg" | "gamma0_deg" => Entry::Number(number(value)?),
        "states" | "inputs" => Entry::Names(
            value.split([' ', ',', ';', '\t']).filter(|name| !name.is_empty()).map(str::to_owned).collect(),
        ),
        _ => Entry::Text(value.to_owned()),
    };
    Some((key, entry))
}

/// A number as people and programs write it: with a point, `1.5D-02` of Fortran, `+.5`; U+2212 was turned into a hyphen before.
pub(in crate::content) fn number(text: &str) -> Option<f64> {
    let text = text.trim();
    // "inf", "nan" and "infinity" are words.
    if !text.starts_with(|c: char| c.is_ascii_digit() || matches!(c, '+' | '-' | '.')) {
        return None;
    }
    text.parse().ok().or_else(|| text.replace(['D', 'd'], "e").parse().ok())
}

/// The setting that goes by this name; `name` itself is one, too.
pub(in crate::content) fn setting(name: &str) -> Option<&'static str> {
    if name == "name" {
        return Some("name");
    }
    KEYS.iter().find(|(_, names)| names.contains(&name)).map(|&(key, _)| key)
}

impl Draft {
    /// Notes a setting; one that is given twice is a mistake.
    pub fn set(&mut self, key: &'static str, line: usize, value: Entry) -> Result<(), Problem> {
        if let Some(before) = self.find(key) {
            return Err((line, format!("{key}: given twice, first on line {}", before.line)));
        }
        self.entries.push((key, At { line, value }));
        Ok(())
    }

    /// Whether a setting has been given.
    pub fn has(&self, key: &str) -> bool {
        self.find(key).is_some()
    }

    /// Notes a setting in place of whatever was said before.
    pub fn replace(&mut self, key: &'static str, line: usize, value: Entry) {
        self.entries.retain(|(name, _)| *name != key);
        self.entries.push((key, At { line, value }));
    }

    /// A setting, with its line.
    pub fn find(&self, key: &str) -> Option<&At<Entry>> {
        self.entries.iter().find(|(name, _)| *name == key).map(|(_, entry)| entry)
    }

    /// The line of a setting.
    pub fn line(&self, key: &str) -> Option<usize> {
        self.find(key).map(|entry| entry.line)
    }

    /// A setting that is a finite number.
    pub fn number(&self, key: &str) -> Result<Option<At<f64>>, Problem> {
        let Some(At { line, value }) = self.find(key) else { return Ok(None) };
        match value {
            Entry::Number(x) if x.is_finite() => Ok(Some(At { line: *line, value: *x })),
            Entry::Number(x) => Err((*line, format!("{key}: expected a finite number, found {x}"))),
            other => Err((*line, format!("{key}: expected a number, found {}", other.kind()))),
        }
    }

    /// A setting that is a text.
    pub fn text(&self, key: &str) -> Result<Option<At<&str>>, Problem> {
        let Some(At { line, value }) = self.find(key) else { return Ok(None) };
        match value {
            Entry::Text(text) => Ok(Some(At { line: *line, value: text })),
            other => Err((*line, format!("{key}: expected a text, found {}", other.kind()))),
        }
    }

    /// A setting that is a list of names.
    pub fn names(&self, key: &str) -> Result<Option<At<&[String]>>, Problem> {
        let Some(At { line, value }) = self.find(key) else { return Ok(None) };
        match value {
            Entry::Names(names) => Ok(Some(At { line: *line, value: names })),
            Entry::Text(name) => Ok(Some(At { line: *line, value: std::slice::from_ref(name) })),
            other => Err((*line, format!("{key}: expected a list of names, found {}", other.kind()))),
        }
    }

    /// Four rows of `columns` finite numbers.
    fn matrix(&self, key: &str, columns: usize) -> Result<Option<Vec<&[f64]>>, Problem> {
        let Some(At { line, value }) = self.find(key) else { return Ok(None) };
        let Entry::Rows(rows) = value else {
            return Err((*line, format!("{key}: expected a matrix, found {}", value.kind())));
        };
        for (k, row) in rows.iter().enumerate() {
            let found = row.value.len();
            if found != columns {
                let problem = format!("{key}: expected {columns} numbers in row {}, found {found}", k + 1);
                return Err((row.line, problem));
            }
            if let Some(x) = row.value.iter().find(|x| !x.is_finite()) {
                return Err((
                    row.line,
                    format!("{key}: expected a finite number in row {}, found {x}", k + 1),
                ));
            }
        }
        if rows.len() != 4 {
            return Err((*line, format!("{key}: expected 4 rows, one a state, found {}", rows.len())));
        }
        Ok(Some(rows.iter().map(|row| row.value.as_slice()).collect()))
    }

    /// The aircraft, in SI and in the order of our state vectors.
    pub(super) fn into_aircraft(self, file: &str) -> Result<Aircraft, Problem> {
        let model = self.model()?;
        let (plane, speed) = (model.plane, model.trim.speed);
        let doubts = if plane == Plane::Lateral { lateral_doubts(&model) } else { Vec::new() };
        let mut models = MatrixModel::default();
        models[plane] = Some(model);
        let aircraft_model = AircraftModel::Matrices(models);
        let line = self.find("A").map_or(1, |entry| entry.line);
        let models = aircraft_model.models().map_err(|problem| (line, problem.to_string()))?;
        if let Some(problem) = models.problems.first() {
            return Err((line, format!("A: {problem}")));
        }
        let name = self.text("name")?.map_or(file, |name| name.value);
        Ok(Aircraft { notes: doubts, ..aircraft(file, name, plane, aircraft_model, speed) })
    }

    /// The model of one plane of motion, in SI and in the order of its state vector: of four states and at most two inputs.
    pub fn model(&self) -> Result<PlaneModel, Problem> {
        let length = self.units()?.length();
        let angle = self.angle()?;
        let states = self.states()?;
        let plane = states[0].plane;
        let inputs = self.inputs(plane)?;
        let trim = self.trim(length)?;

        // The file's unit of each state and of each input, in SI: x_SI = T x, δ_SI = D δ
        let state_scale = states.map(|state| match (state.kind, plane) {
            (Kind::Velocity, _) => length,
            (Kind::FlowAngle, Plane::Longitudinal) => trim.u0() * angle,
            (Kind::FlowAngle, Plane::Lateral) => trim.speed * angle,
            (Kind::Angle, _) => angle,
        });
        let input_scale = |input: &Input| if input.is_angle { angle } else { 1.0 };
        let missing = || (1, "A: missing; expected four rows of four numbers".to_owned());
        let rows = self.matrix("A", 4)?.ok_or_else(missing)?;
        let (mut a, mut b) = (Matrix4::zeros(), Matrix4x2::zeros());
        for (i, row) in rows.iter().enumerate() {
            for (j, entry) in row.iter().enumerate() {
                // A_SI = T A T⁻¹
                a[(states[i].index, states[j].index)] = entry * (state_scale[i] / state_scale[j]);
            }
        }
        if let Some(rows) = self.matrix("B", inputs.len())? {
            for (i, row) in rows.iter().enumerate() {
                for (entry, input) in row.iter().zip(&inputs) {
                    // B_SI = T B D⁻¹
                    b[(states[i].index, input.column)] = entry * (state_scale[i] / input_scale(input));
                }
            }
        }
        self.check_kinematics(plane, &a)?;
        Ok(PlaneModel { plane, a, b, trim, further: None })
    }

    fn units(&self) -> Result<UnitSystem, Problem> {
        let expected = "\"SI\" (metres) or \"ft-slug-s\" (feet)";
        let units = self.text("units")?.ok_or_else(|| (1, format!("units: missing; expected {expected}")))?;
        let known = UnitSystem::NAMES.iter().find(|(name, _)| *name == units.value);
        known
            .map(|&(_, system)| system)
            .ok_or_else(|| (units.line, format!("units: expected {expected}, found \"{}\"", units.value)))
    }

    /// The file's unit of angle in radians.
    fn angle(&self) -> Result<f64, Problem> {
        match self.text("angles")? {
            None => Ok(1.0),
            Some(At { value: "rad", .. }) => Ok(1.0),
            Some(At { value: "deg", .. }) => Ok(1_f64.to_radians()),
            // Books of control engineering count angles in hundredths of a radian.
            Some(At { value: "crad", .. }) => Ok(0.01),
            Some(At { line, value }) => {
                Err((line, format!("angles: expected \"rad\", \"deg\" or \"crad\", found \"{value}\"")))
            }
        }
    }

    fn states(&self) -> Result<[State; 4], Problem> {
        let missing =
            || (1, format!("states: missing; expected the names of four states, {STATES_EXPECTED}"));
        let At { line, value } = self.names("states")?.ok_or_else(missing)?;
        let mut states = Vec::with_capacity(4);
        for name in value {
            let unknown = || {
                (line, format!("states: \"{name}\" is not a state known here; expected {STATES_EXPECTED}"))
            };
            states.push(names::state(name).ok_or_else(unknown)?);
        }
        let found = states.len();
        let states: [State; 4] = states.try_into().map_err(|_| {
            (line, format!("states: expected four of one plane of motion, {STATES_EXPECTED}; found {found}"))
        })?;
        for (k, name) in value.iter().enumerate() {
            if states[k].plane != states[0].plane {
                return Err((
                    line,
                    format!(
                        "states: \"{}\" is longitudinal and \"{}\" is lateral, or the other way round; \
                         expected one plane of motion, {STATES_EXPECTED}",
                        value[0], name
                    ),
                ));
            }
            if let Some(twin) = (0..k).find(|&other| states[other].index == states[k].index) {
                return Err((line, format!("states: \"{}\" and \"{name}\" are the same state", value[twin])));
            }
        }
        Ok(states)
    }

    /// A value for each column of B.
    fn inputs(&self, plane: Plane) -> Result<Vec<Input>, Problem> {
        let Some(b) = self.find("B") else { return Ok(Vec::new()) };
        let missing =
            || (b.line, format!("inputs: missing; expected a name for each column of B: {INPUTS_EXPECTED}"));
        let At { line, value } = self.names("inputs")?.ok_or_else(missing)?;
        let mut inputs: Vec<Input> = Vec::with_capacity(2);
        for name in value {
            let known = names::input(name).filter(|input| input.plane == plane).ok_or_else(|| {
                let of_plane = match plane {
                    Plane::Longitudinal => "elevator or throttle",
                    Plane::Lateral => "aileron or rudder",
                };
                (line, format!("inputs: expected {of_plane} beside these states, found \"{name}\""))
            })?;
            if inputs.contains(&known) {
                return Err((line, format!("inputs: \"{name}\" stands there twice")));
            }
            inputs.push(known);
        }
        Ok(inputs)
    }

    fn trim(&self, length: f64) -> Result<Trim, Problem> {
        let degrees = |key| Ok::<_, Problem>(self.number(key)?.map_or(0.0, |angle| angle.value).to_radians());
        let (alpha0, gamma0) = (degrees("alpha0_deg")?, degrees("gamma0_deg")?);
        for (key, angle) in [("alpha0_deg", alpha0), ("gamma0_deg", gamma0)] {
            if angle.abs() >= std::f64::consts::FRAC_PI_2 {
                let line = self.find(key).map_or(1, |entry| entry.line);
                return Err((line, format!("{key}: expected an angle between -90 and 90 degrees")));
            }
        }
        let speed = match (self.number("speed")?, self.number("u0")?) {
            (Some(speed), None) => speed,
            // U₀ = V cos α₀
            (None, Some(u0)) => At { line: u0.line, value: u0.value / alpha0.cos() },
            (Some(_), Some(u0)) => {
                return Err((u0.line, "u0: expected speed or u0, found both".to_owned()));
            }
            (None, None) => {
                let problem = "speed: missing; expected the true airspeed, a positive number";
                return Err((1, problem.to_owned()));
            }
        };
        if speed.value <= 0.0 {
            let problem = format!("speed: expected a positive number, found {}", speed.value);
            return Err((speed.line, problem));
        }
        Ok(Trim { speed: speed.value * length, alpha0, gamma0, gravity: STANDARD_GRAVITY })
    }

    /// θ̇ = q, and φ̇ = p + r tan θ₀: a row that says otherwise is a row of another state.
    fn check_kinematics(&self, plane: Plane, a: &Matrix4<f64>) -> Result<(), Problem> {
        let row = a.row(3);
        let near = |x: f64, expected: f64| (x - expected).abs() <= 1e-9;
        let (holds, expected) = match plane {
            Plane::Longitudinal => (
                near(row[0], 0.0) && near(row[1], 0.0) && near(row[2], 1.0) && near(row[3], 0.0),
                "row of theta: expected 1 for q and 0 for u, w and theta, for pitch rate is the rate of pitch angle",
            ),
            Plane::Lateral => (
                near(row[0], 0.0) && near(row[1], 1.0) && near(row[3], 0.0),
                "row of phi: expected 1 for p and 0 for v and phi, for roll rate is the rate of bank angle",
            ),
        };
        let line = self.find("A").map_or(1, |entry| entry.line);
        if holds { Ok(()) } else { Err((line, format!("A: {expected}; is the order of the states right?"))) }
    }
}

/// How far an entry may be from what it stands for, either way: a climb, rounding and Y_r let through, no confusion of units.
const PLAUSIBLE: std::ops::RangeInclusive<f64> = 0.5..=2.0;

/// The v row of A says g cos θ₀ φ and −U₀ r, whatever the aircraft: a sentence for each that this file says otherwise.
fn lateral_doubts(model: &PlaneModel) -> Vec<String> {
    let trim = &model.trim;
    let [turn, weight] =
        [-entry(&model.a, Lateral::V, Lateral::R), entry(&model.a, Lateral::V, Lateral::Phi)];
    let (speed, fall) = (trim.u0(), trim.gravity * trim.theta0().cos());
    let [of_turn, of_weight] = [turn / speed, weight / fall];
    let is_plausible = |share: f64| PLAUSIBLE.contains(&share);
    if is_plausible(of_turn) && is_plausible(of_weight) {
        return Vec::new();
    }
    if (of_turn / of_weight - 1.0).abs() < 0.5 && of_weight > 0.0 {
        // Both by the same factor: the row is one of another state.
        return vec![format!(
            "The row of sideslip is {} times what it can be: A(v, r) is −{} m/s beside a speed of {} m/s, A(v, φ) {} m/s² beside \
             g cos θ₀ of {} m/s². Is it a row of v under the name of β, or of β under that of v?",
            significant(of_weight, 3),
            significant(turn, 4),
            significant(speed, 4),
            significant(weight, 4),
            significant(fall, 4)
        )];
    }
    let mut doubts = Vec::new();
    if !is_plausible(of_weight) {
        doubts.push(format!(
            "Gravity and length don’t belong to one unit system: A(v, φ) is {} m/s², where g cos θ₀ is {} m/s². Are feet called metres?",
            significant(weight, 4),
            significant(fall, 4)
        ));
    }
    if !is_plausible(of_turn) {
        doubts.push(format!(
            "The row of sideslip doesn’t belong to the speed: A(v, r) is {} m/s, where −U₀ is {} m/s.",
            significant(-turn, 4),
            significant(-speed, 4)
        ));
    }
    doubts
}

fn aircraft(file: &str, name: &str, plane: Plane, aircraft_model: AircraftModel, speed: f64) -> Aircraft {
    let status_reason = "Bare matrices from a file: there are no published modes to compare with.".to_owned();
    let mut plane_notes = ByPlane::default();
    plane_notes[plane] = Some(PlaneNotes {
        status: Status::Unverified,
        status_reason: status_reason.clone(),
        source: file.to_owned(),
        published: Vec::new(),
    });
    Aircraft {
        key: "file".to_owned(),
        own: None,
        name: name.to_owned(),
        condition: "Bare matrices".to_owned(),
        shape: USUAL_SHAPE,
        length_unit: LengthUnit::Metre,
        status: Status::Unverified,
        source: file.to_owned(),
        baseline: Baseline::new(&aircraft_model),
        aircraft_model,
        plane_notes,
        status_reason,
        particulars: Particulars { speed: Some(speed), ..Particulars::default() },
        limits: NamedLimits::default(),
        task: None,
        notes: Vec::new(),
    }
}
