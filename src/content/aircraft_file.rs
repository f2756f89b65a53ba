//! The form of an aircraft file: figures as printed in the source, in its units, converted here once to SI.

use nalgebra::{Matrix4, Matrix4x2, Vector4};

use super::aircraft::{Aircraft, Baseline, LengthUnit, Particulars, PlaneNotes, Status};
use super::airframe_file::{coefficient_model, derivative_model};
use super::matrix_file::matrix_model;
use super::published::read_published;
use super::reader::{Block, ContentError, with_file};
use super::shapes::{SHAPES, USUAL_SHAPE};
use super::units::UnitSystem;
use crate::flight::aircraft::aircraft_model::{AircraftModel, CoefficientModel, MatrixModel};
use crate::flight::aircraft::coefficients::Airframe;
use crate::flight::aircraft::inertia::Inertia;
use crate::flight::aircraft::plane::{ByPlane, Plane, PlaneModel, Trim};
use crate::flight::analysis::STANDARD_GRAVITY;
use crate::flight::motion::control_limits::{Control, NamedLimits};
use crate::flight::verdicts::mil_f_8785c::{Category, Class};
use crate::flight::verdicts::task::Task;

/// The numbers that a file starts from.
#[derive(Clone, Copy)]
enum Basis {
    Coefficients,
    Derivatives,
    Matrices,
}

const BASES: [(&str, Basis); 3] = [
    ("coefficients", Basis::Coefficients),
    ("derivatives", Basis::Derivatives),
    ("matrices", Basis::Matrices),
];

impl Aircraft {
    /// Reads one aircraft from TOML text and converts it to SI; `file` is its name for messages.
    pub fn from_toml(file: &str, text: &str) -> Result<Self, ContentError> {
        with_file(file, text, read)
    }

    /// A person's own aircraft from TOML text, which it keeps.
    pub fn own(file: &str, text: &str) -> Result<Self, ContentError> {
        Ok(Self { own: Some(text.into()), ..Self::from_toml(file, text)? })
    }
}

/// Key of what was changed on the aircraft since its source.
const EDITS: &str = "edits";

/// What an aircraft file says was changed on the aircraft, in the words and units of links.
pub fn edits_in(text: &str) -> Option<String> {
    let table: toml::Table = text.parse().ok()?;
    table.get(EDITS)?.as_str().map(str::to_owned)
}

/// The lines of an aircraft file, each with whether it gives this key of the file itself, and not of one of its tables.
pub fn lines_with_key<'t>(text: &'t str, key: &'t str) -> impl Iterator<Item = (&'t str, bool)> {
    const QUOTES: [char; 2] = ['"', '\''];
    let mut is_head = true;
    text.split_inclusive('\n').map(move |line| {
        let start = line.trim_start();
        is_head &= !start.starts_with('[');
        let rest = start.trim_start_matches(QUOTES).strip_prefix(key);
        let is_key = rest.is_some_and(|rest| rest.trim_start_matches(QUOTES).trim_start().starts_with('='));
        (line, is_head && is_key)
    })
}

/// An aircraft from its file. A file with `length_unit` is one of bare matrices; others say their `basis`.
fn read(file: &mut Block<'_>) -> Result<Aircraft, ContentError> {
    file.optional_text(EDITS)?;
    let aircraft = if file.has("length_unit") { read_matrices(file)? } else { read_data(file)? };
    file.finish()?;
    Ok(aircraft)
}

fn read_data(file: &mut Block<'_>) -> Result<Aircraft, ContentError> {
    let (key, name, condition) = (read_key(file)?, file.text("name")?, file.text("condition")?);
    let shape = read_shape(file)?;
    let basis = file.choice("basis", &BASES)?;
    let units = file.choice("units", &UnitSystem::NAMES)?;
    file.choice("angles", &[("rad", ())])?;
    let task = match (file.optional_key::<Class>("class")?, file.optional_key::<Category>("phase")?) {
        (Some(class), Some(category)) => Some(Task { class, category }),
        (None, None) => None,
        (Some(_), None) => return Err(file.error("class", "expected phase beside it: a level needs both")),
        (None, Some(_)) => return Err(file.error("phase", "expected class beside it: a level needs both")),
    };
    let limits = read_limits(file)?;
    let source = file.text("source")?;
    let mut notes = Vec::from_iter(file.optional_text("note")?);

    let mut lateral = file.optional_block("lateral")?;
    // Matrices may be of lateral motion alone.
    let mut longitudinal = match basis {
        Basis::Matrices if lateral.is_some() => file.optional_block("longitudinal")?,
        _ => Some(file.block("longitudinal")?),
    };
    let notes_of = |block: Option<&mut Block<'_>>| block.map(|block| read_notes(block, &source)).transpose();
    let plane_notes =
        ByPlane { longitudinal: notes_of(longitudinal.as_mut())?, lateral: notes_of(lateral.as_mut())? };
    let (aircraft_model, particulars, data_notes) = match (basis, &mut longitudinal) {
        (Basis::Coefficients, Some(longitudinal)) => {
            coefficient_model(file, units, longitudinal, lateral.as_mut())?
        }
        (Basis::Derivatives, Some(longitudinal)) => {
            derivative_model(file, units, longitudinal, lateral.as_mut())?
        }
        (_, longitudinal) => {
            let (aircraft_model, particulars) = matrix_model(units, longitudinal.as_mut(), lateral.as_mut())?;
            (aircraft_model, particulars, Vec::new())
        }
    };
    let doubt = inertia_doubt(&aircraft_model);
    notes.extend(data_notes);
    notes.extend(doubt.clone());
    for block in [&longitudinal, &lateral].into_iter().flatten() {
        block.finish()?;
    }

    let models = aircraft_model.models().map_err(|problem| file.error_here(problem))?;
    if let Some(problem) = models.problems.first() {
        return Err(file.error_here(problem));
    }
    if let (Some(block), None) = (&longitudinal, &models.planes.longitudinal) {
        return Err(block.error_here("no model follows from it"));
    }
    let verified = plane_notes.iter().flatten().all(|plane| plane.status == Status::Verified);
    Ok(Aircraft {
        key,
        own: None,
        name,
        condition,
        shape,
        length_unit: LengthUnit::Metre,
        status: if verified { Status::Verified } else { Status::Unverified },
        status_reason: joined(
            plane_notes.iter().flatten().map(|plane| plane.status_reason.as_str()).chain(doubt.as_deref()),
        ),
        source,
        baseline: Baseline::new(&aircraft_model),
        aircraft_model,
        plane_notes,
        particulars,
        limits,
        task,
        notes,
    })
}

/// Said of moments of inertia that no rigid body has; their limit, a body that is flat, is one of them.
fn inertia_doubt(aircraft_model: &AircraftModel) -> Option<String> {
    let inertia = match aircraft_model {
        AircraftModel::Coefficients(CoefficientModel {
            airframe: Airframe { ix, iy, iz, ixz, .. }, ..
        }) => Inertia { ix: *ix, iy: *iy, iz: *iz, ixz: *ixz },
        AircraftModel::Derivatives(aircraft_model) => aircraft_model.inertia?,
        AircraftModel::Matrices(_) => return None,
    };
    let flatness = inertia.flatness();
    (flatness > 1.0 - 1e-6).then(|| {
        format!(
            "No rigid body has these moments of inertia: the largest about a principal axis is {:.0} % of the sum of the other two, \
             and in every body it is less.",
            100.0 * flatness
        )
    })
}

/// The sentences one after the other, each once.
fn joined<'t>(sentences: impl Iterator<Item = &'t str>) -> String {
    let mut all: Vec<&str> = sentences.collect();
    all.dedup();
    all.join(" ")
}

/// The block `[limits]`, which a file may have: reach and rate of each control, in degrees, of the throttle in its own unit; in the
/// senses of [`crate::flight`].
fn read_limits(file: &mut Block<'_>) -> Result<NamedLimits, ContentError> {
    const KEYS: [(&str, &str); 4] = [
        ("elevator_deg", "elevator_rate_deg"),
        ("throttle", "throttle_rate"),
        ("aileron_deg", "aileron_rate_deg"),
        ("rudder_deg", "rudder_rate_deg"),
    ];
    let mut limits = NamedLimits::default();
    let Some(mut block) = file.optional_block("limits")? else { return Ok(limits) };
    for (control, (range, rate)) in Control::ALL.into_iter().zip(KEYS) {
        let unit = if control == Control::Throttle { 1.0 } else { 1_f64.to_radians() };
        if block.has(range) {
            let [low, high] = block.row::<2>(range)?;
            if !(low <= 0.0 && 0.0 <= high && low < high) {
                return Err(block.error(range, "expected the lowest and the highest, with zero between them"));
            }
            limits.ranges[control as usize] = Some([low, high].map(|x| x * unit));
        }
        limits.rates[control as usize] = block.optional_positive(rate)?.map(|rate| rate * unit);
    }
    block.finish()?;
    Ok(limits)
}

/// A key goes into links: small letters, digits and hyphens.
fn read_key(file: &mut Block<'_>) -> Result<String, ContentError> {
    let key = file.text("key")?;
    if key.bytes().all(|b| b.is_ascii_lowercase() || b.is_ascii_digit() || b == b'-') {
        Ok(key)
    } else {
        Err(file.error("key", format_args!("expected small letters, digits and hyphens, found \"{key}\"")))
    }
}

/// The shape that it is drawn with, one of those that ship; a light trainer where the file names none.
fn read_shape(file: &mut Block<'_>) -> Result<&'static str, ContentError> {
    Ok(file.optional_choice("shape", &SHAPES.map(|(key, _)| (key, key)))?.unwrap_or(USUAL_SHAPE))
}

fn read_notes(block: &mut Block<'_>, file_source: &str) -> Result<PlaneNotes, ContentError> {
    let notes = PlaneNotes {
        status: block.key("status")?,
        status_reason: block.text("status_reason")?,
        source: block.optional_text("source")?.unwrap_or_else(|| file_source.to_owned()),
        published: read_published(block)?,
    };
    if notes.status == Status::Verified && notes.published.is_empty() {
        return Err(block.error("status", "\"verified\" needs published modes to be verified by, found none"));
    }
    Ok(notes)
}

/// The lesson's form: A and the elevator column in a unit of length of their own.
fn read_matrices(file: &mut Block<'_>) -> Result<Aircraft, ContentError> {
    let length_unit = file.choice("length_unit", &LengthUnit::NAMES)?;
    let (key, name, condition) = (read_key(file)?, file.text("name")?, file.text("condition")?);
    let shape = read_shape(file)?;
    let (status, status_reason) = (file.key("status")?, file.text("status_reason")?);
    let source = file.text("source")?;
    let mut block = file.block("longitudinal")?;
    let (u0, a, b) = (block.positive("u0")?, block.matrix("a")?, block.row::<4>("b_elevator")?);
    if a[3] != [0.0, 0.0, 1.0, 0.0] {
        let text = "the last row of A must be 0, 0, 1, 0: pitch rate is the rate of pitch angle";
        return Err(block.error("a", text));
    }
    block.finish()?;
    // A_SI = T A T⁻¹, B_SI = T B with T = diag(l, l, 1, 1) and l the unit of length in metres
    let l = length_unit.metres();
    let scale = Vector4::new(l, l, 1.0, 1.0);
    let a = Matrix4::from_fn(|i, j| a[i][j] * (scale[i] / scale[j]));
    let b_elevator = Vector4::from(b).component_mul(&scale);
    let b = Matrix4x2::from_columns(&[b_elevator, Vector4::zeros()]);
    let trim = Trim { speed: u0 * l, alpha0: 0.0, gamma0: 0.0, gravity: STANDARD_GRAVITY };
    let model = PlaneModel { plane: Plane::Longitudinal, a, b, trim, further: None };
    let aircraft_model = AircraftModel::Matrices(MatrixModel { longitudinal: Some(model), lateral: None });
    let baseline = Baseline::new(&aircraft_model);
    if let Some(problem) = baseline.models.problems.first() {
        return Err(block.error("a", problem));
    }
    Ok(Aircraft {
        key,
        own: None,
        name,
        condition,
        shape,
        length_unit,
        status,
        plane_notes: ByPlane {
            longitudinal: Some(PlaneNotes {
                status,
                status_reason: status_reason.clone(),
                source: source.clone(),
                published: Vec::new(),
            }),
            lateral: None,
        },
        status_reason,
        source,
        aircraft_model,
        baseline,
        particulars: Particulars { speed: Some(u0 * l), ..Particulars::default() },
        limits: NamedLimits::default(),
        task: None,
        notes: Vec::new(),
    })
}
