//! An aircraft from matrices that were read: their states named, parted into the two planes of motion, in SI.

use super::aircraft_text::AircraftText;
use super::checks::{self, Said};
use super::further;
use super::matrix_names;
use super::naming;
use super::part::Part;
use super::parting;
use super::review::{Basis, Field, Form, PlaneEigenvalues};
use super::sheet::Sheet;
use super::system::{System, eigenvalues};
use crate::content::matrix::draft::{At, Draft, Entry, Problem, Rows};
use crate::content::matrix::state_names::{self, Meaning};
use crate::content::units::UnitSystem;
use crate::flight::aircraft::plane::{Plane, PlaneModel};
use crate::key::Keyed as _;
use crate::number::{significant, trimmed};

/// Most states that are read.
const MOST_STATES: usize = 24;

const UNIT_CHOICES: [(&str, &str); 2] = [("SI", "metres and seconds"), ("ft-slug-s", "feet and seconds")];
const ANGLE_CHOICES: [(&str, &str); 3] =
    [("rad", "radians"), ("deg", "degrees"), ("crad", "hundredths of a radian")];
const ROW_CHOICES: [(&str, &str); 3] = [
    ("beta", "the rate of β"),
    ("v", "the row of v, Y_v first, though β is the state"),
    ("v-by-beta", "the rate of v, every entry by β"),
];

/// Completes the sheet and, where nothing is missing, writes the aircraft.
pub(super) fn complete(sheet: &mut Sheet, mut draft: Draft) -> Result<(), Problem> {
    sheet.set_basis(Basis::Matrices);
    draft.remarks.drain(..).for_each(|lost| sheet.warn("digits", lost, Vec::new()));
    if let Ok(Some(name)) = draft.text("name") {
        sheet.review.title = name.value.to_owned();
    }
    matrix_names::find(sheet, &mut draft)?;
    let At { line, value: a } = rows(&draft, "A")?
        .ok_or_else(|| (1, "A: missing; expected a line that begins with \"A = [\"".to_owned()))?;
    let n = a.len();
    square(&a, "A", line, n)?;
    let b = rows(&draft, "B")?;
    let b = b.map(|b| naming::upright(sheet, b.line, b.value, n)).transpose()?;
    let Some(names) = naming::states(sheet, &draft, &values(&a))? else { return Ok(()) };
    let known = state_names::meanings(&names);
    let Some(meanings) = naming::all_meanings(sheet, &names, &known) else {
        let stranger = names.iter().zip(&known).find(|(_, meaning)| meaning.is_none());
        let name = stranger.map_or("", |(name, _)| name);
        sheet.stop_on_line(draft.line("states").unwrap_or(line), "states", naming::unknown(name), Vec::new());
        return Ok(());
    };
    naming::say_states(sheet, line, &names, &meanings);
    let inputs = match &b {
        Some(At { line, value: b }) => {
            naming::inputs(sheet, &draft, *line, b.first().map_or(0, |row| row.value.len()), &meanings)?
        }
        None => Some(Vec::new()),
    };
    let Some(inputs) = inputs else { return Ok(()) };
    let b = b.map_or_else(|| vec![Vec::new(); n], |b| values(&b.value));
    let mut system = System { names, meanings, inputs, a: values(&a), b };

    sheet.review.eigenvalues = eigenvalues_of(&system);
    let mut unit_hint = naming::units_hint(&system);
    // AVL writes no unit, and everything that it says of the flight is in the matrix itself.
    if sheet.review.format == Form::AvlSystem.key()
        && draft.find("units").is_none()
        && let Some((units, why)) = unit_hint.take()
    {
        sheet.remark(format!("{units}: {why}."));
        draft.set("units", line, Entry::Text(units))?;
    }
    let units = setting(sheet, &draft, "units", "unit system of the file", &UNIT_CHOICES, unit_hint)?;
    let angles = setting(sheet, &draft, "angles", "unit of angles and rates", &ANGLE_CHOICES, None)?;
    let Some(units) = units else { return Ok(()) };
    let units_known = UnitSystem::NAMES.iter().find(|(name, _)| *name == units).map(|&(_, system)| system);
    let Some(unit_system) = units_known else { return Ok(()) };
    let length = unit_system.length();
    let angles = angles.unwrap_or_else(|| "rad".to_owned());
    naming::own_units(&mut system, length, &angles);

    let Some(trim) = trim(sheet, &draft, &system, length)? else { return Ok(()) };
    if let Some(k) = system.place(&[Meaning::SpeedRatio]) {
        // û = u/V
        system.rescale(k, 1.0 / trim.speed);
    }
    if let (Some(path), Some(alpha)) =
        (system.place(&[Meaning::PathAngle]), system.place(&[Meaning::Rigid(Plane::Longitudinal, "alpha")]))
    {
        system.pitch_for_path(path, alpha);
        sheet.remark("The pitch angle θ = γ + α takes the place of the flight-path angle γ.");
    }
    sideslip_row(sheet, &mut system, trim.speed)?;

    let parts = parting::part(sheet, &system, line);
    let mut models = Vec::new();
    for part in &parts {
        if !part.further.is_empty()
            && let Some(plane) =
                sheet.review.eigenvalues.iter_mut().find(|found| found.plane == part.plane.key())
        {
            let values = eigenvalues(&system.part(&part.all())).unwrap_or_default();
            plane.with_further = values.iter().map(|value| [value.re, value.im]).collect();
        }
        if let Some(model) = model_of(sheet, &system, part, &trim, line, &units, &angles) {
            let renamed = system.names.iter().zip(&system.meanings).map(|(name, meaning)| match meaning {
                Meaning::Rigid(Plane::Longitudinal, "alpha") => "w",
                Meaning::Rigid(Plane::Lateral, "v") => "beta",
                _ => name.as_str(),
            });
            let by_angle = matches!(
                system.meanings[part.states[usize::from(part.plane == Plane::Longitudinal)]],
                Meaning::Rigid(_, "alpha" | "beta")
            );
            let said = Said {
                is_si: unit_system == UnitSystem::Si,
                length,
                in_radians: angles == "rad",
                by_angle,
                renamed: renamed.collect::<Vec<_>>().join(", "),
            };
            checks::check(sheet, &model, &said);
            models.push(model);
        }
    }
    if sheet.waits() || models.is_empty() {
        return Ok(());
    }
    write(sheet, &models);
    Ok(())
}

/// What no unit and no speed changes.
fn eigenvalues_of(system: &System) -> Vec<PlaneEigenvalues> {
    let of = |plane: Plane| {
        let states: Vec<usize> = system.plane(plane).into_iter().collect::<Option<_>>()?;
        let values = eigenvalues(&system.part(&states))?;
        Some(PlaneEigenvalues {
            plane: plane.key(),
            values: values.iter().map(|value| [value.re, value.im]).collect(),
            with_further: Vec::new(),
        })
    };
    Plane::ALL.into_iter().filter_map(of).collect()
}

/// The steady flight in the file's unit of length.
#[derive(Clone, Copy, Debug)]
struct FileTrim {
    speed: f64,
    alpha0_deg: f64,
    gamma0_deg: f64,
}

/// A matrix of the draft with its line.
fn rows(draft: &Draft, key: &str) -> Result<Option<At<Rows>>, Problem> {
    match draft.find(key) {
        None => Ok(None),
        Some(At { line, value: Entry::Rows(rows) }) if !rows.is_empty() => {
            Ok(Some(At { line: *line, value: rows.clone() }))
        }
        Some(At { line, .. }) => Err((*line, format!("{key}: expected a matrix in brackets"))),
    }
}

fn square(rows: &[At<Vec<f64>>], key: &str, line: usize, n: usize) -> Result<(), Problem> {
    for (k, row) in rows.iter().enumerate() {
        let found = row.value.len();
        if found != n {
            return Err((row.line, format!("{key}: expected {n} numbers in row {}, found {found}", k + 1)));
        }
        if let Some(x) = row.value.iter().find(|x| !x.is_finite()) {
            return Err((row.line, format!("{key}: expected a finite number in row {}, found {x}", k + 1)));
        }
    }
    if (3..=MOST_STATES).contains(&n) {
        Ok(())
    } else {
        Err((
            line,
            format!("{key}: expected 4 rows, one a state, or up to {MOST_STATES} with others; found {n}"),
        ))
    }
}

fn values(rows: &[At<Vec<f64>>]) -> Vec<Vec<f64>> {
    rows.iter().map(|row| row.value.clone()).collect()
}

/// A setting of the file that is a choice: as typed, as the file says, or suggested.
fn setting(
    sheet: &mut Sheet,
    draft: &Draft,
    key: &str,
    meaning: &str,
    choices: &[(&str, &str)],
    suggestion: Option<(String, String)>,
) -> Result<Option<String>, Problem> {
    let read = draft.text(key)?;
    if let Some(At { line, value }) = read
        && !choices.iter().any(|(known, _)| *known == value)
    {
        let known: Vec<String> = choices.iter().map(|(key, words)| format!("\"{key}\" ({words})")).collect();
        return Err((line, format!("{key}: expected {}, found \"{value}\"", known.join(" or "))));
    }
    if let Some(At { line, value }) = read {
        sheet.read_as(line, value, key, meaning);
    }
    let mut field = Field::choice(key, meaning, choices);
    // Radians are meant where nothing is said.
    field.required = key != "angles";
    let usual = if key == "angles" { Some("rad") } else { None };
    sheet.chosen(field, read.map(|read| read.value).or(usual), suggestion)
}

/// Speed and angles of the trim: typed, said, or told by the rows of height and place.
fn trim(sheet: &mut Sheet, draft: &Draft, system: &System, length: f64) -> Result<Option<FileTrim>, Problem> {
    let told = naming::trim_of_places(system);
    let angle = |sheet: &mut Sheet, key: &'static str, told: Option<f64>| {
        let read = draft.number(key)?.map(|read| read.value);
        let angle = sheet.value(key)?.or(read).or(told).unwrap_or(0.0);
        if angle.abs() >= 90.0 {
            let line = draft.find(key).map_or(1, |entry| entry.line);
            return Err((line, format!("{key}: expected an angle between -90 and 90 degrees")));
        }
        Ok(angle)
    };
    let alpha0_deg = angle(sheet, "alpha0_deg", told.alpha0_deg)?;
    let gamma0_deg = angle(sheet, "gamma0_deg", told.gamma0_deg)?;
    let (speed, u0) = (draft.number("speed")?, draft.number("u0")?);
    if let (Some(_), Some(u0)) = (&speed, &u0) {
        return Err((u0.line, "u0: expected speed or u0, found both".to_owned()));
    }
    // U₀ = V cos α₀
    let read = speed.or(u0.map(|u0| At { line: u0.line, value: u0.value / alpha0_deg.to_radians().cos() }));
    if let Some(At { line, value }) = &read {
        if *value <= 0.0 {
            return Err((*line, format!("speed: expected a positive number, found {value}")));
        }
        let text = format!("{value}");
        sheet.find("speed", value * length, *line, &text);
    } else if let Some(speed) = told.speed.filter(|_| sheet.finds("speed").is_none()) {
        sheet.remark(format!(
            "The rows of height, place and bank say the speed, {} m/s, the angle of attack, {}°, and the flight path, {}°.",
            significant(speed * length, 5),
            trimmed(alpha0_deg, 4),
            trimmed(gamma0_deg, 4)
        ));
        sheet.find("speed", speed * length, 0, "rows of height and place");
    }
    let suggestion = naming::speed_hint(system).map(|(speed, why)| (speed * length, why));
    let Some(speed) = sheet.needed("speed", suggestion)? else { return Ok(None) };
    if speed <= 0.0 {
        return Err((1, format!("speed: expected a positive number, found {speed}")));
    }
    // What the file says in its own unit keeps its last digit.
    let own = read.filter(|read| read.value * length == speed).map_or(speed / length, |read| read.value);
    Ok(Some(FileTrim { speed: own, alpha0_deg, gamma0_deg }))
}

/// The row of β as a row of v, where a person says so: v̇ = V β̇. Its first entry is Y_v by v and by β alike.
fn sideslip_row(sheet: &mut Sheet, system: &mut System, speed: f64) -> Result<(), Problem> {
    let Some(k) = system.place(&[Meaning::Rigid(Plane::Lateral, "beta")]) else { return Ok(()) };
    let mut field = Field::choice("sideslip_row", "what the row of β is the rate of", &ROW_CHOICES);
    field.required = false;
    let chosen = sheet.chosen(field, Some("beta"), None)?.unwrap_or_default();
    if chosen == "beta" {
        return Ok(());
    }
    let damping = system.a[k][k];
    system.scale_row(k, 1.0 / speed);
    let mut said = "The row of β was read as one of v, and divided by the speed".to_owned();
    if chosen == "v" {
        system.a[k][k] = damping;
        said.push_str(", but for Y_v");
    }
    sheet.remark(said + ".");
    Ok(())
}

/// The model of a part, in SI; what can't be stops the sheet.
fn model_of(
    sheet: &mut Sheet,
    system: &System,
    part: &Part,
    trim: &FileTrim,
    line: usize,
    units: &str,
    angles: &str,
) -> Option<PlaneModel> {
    let by_airspeed = system.meanings[part.states[0]] == Meaning::Airspeed;
    let state = |k: usize| match system.meanings[k] {
        Meaning::Rigid(_, name) => name,
        Meaning::Airspeed | Meaning::SpeedRatio => "u",
        _ => "theta",
    };
    let named = |names: Vec<&str>| Entry::Names(names.into_iter().map(str::to_owned).collect());
    let matrix =
        |rows: &[Vec<f64>]| Entry::Rows(rows.iter().map(|row| At { line, value: row.clone() }).collect());
    let mut a = part.a.clone();
    parting::round_kinematics(sheet, part.plane, &mut a);
    // V and α are those of stability axes, whatever the angle of the body.
    let alpha0 = if by_airspeed { 0.0 } else { trim.alpha0_deg };
    let mut draft = Draft::default();
    draft.replace("units", line, Entry::Text(units.to_owned()));
    draft.replace("angles", line, Entry::Text(angles.to_owned()));
    draft.replace("speed", line, Entry::Number(trim.speed));
    draft.replace("alpha0_deg", line, Entry::Number(alpha0));
    draft.replace("gamma0_deg", line, Entry::Number(trim.gamma0_deg));
    draft.replace("states", line, named(part.states.iter().map(|&k| state(k)).collect()));
    draft.replace("A", line, matrix(&a));
    if !part.inputs.is_empty() {
        draft.replace("inputs", line, named(part.inputs.clone()));
        draft.replace("B", line, matrix(&part.b));
    }
    let length =
        UnitSystem::NAMES.iter().find(|(name, _)| *name == units).map_or(1.0, |(_, system)| system.length());
    let angle = naming::angle(angles);
    match draft.model() {
        Ok(model) => {
            let model = further::with_further_of(sheet, system, part, model, length, angle);
            let is_finite = |model: &PlaneModel| {
                model.whole_a().iter().chain(&model.b).all(|x| x.is_finite())
                    && model.further.as_ref().is_none_or(|further| further.is_finite())
            };
            if !is_finite(&model) {
                sheet.stop_on_line(
                    line,
                    "size",
                    "A has an entry that is too large to compute with.",
                    Vec::new(),
                );
                return None;
            }
            Some(model)
        }
        Err((_, problem)) => {
            sheet.stop_on_line(line, "matrix", problem, Vec::new());
            None
        }
    }
}

fn write(sheet: &mut Sheet, models: &[PlaneModel]) {
    let review = &sheet.review;
    let mut text = AircraftText::new(&review.title, "Bare matrices", &review.file, &review.notes());
    text.word("basis", "matrices");
    text.word("units", "SI");
    text.word("angles", "rad");
    for model in models {
        text.block(match model.plane {
            Plane::Longitudinal => "longitudinal",
            Plane::Lateral => "lateral",
        });
        text.unverified();
        text.number("speed", model.trim.speed);
        text.number("alpha0_deg", model.trim.alpha0.to_degrees());
        text.number("gamma0_deg", model.trim.gamma0.to_degrees());
        text.number("gravity", model.trim.gravity);
        let states: Vec<&str> = model.further_states().iter().map(|state| state.key()).collect();
        if !states.is_empty() {
            text.words("further_states", &states);
        }
        let (a, b) = (model.whole_a(), [0, 1].map(|input| model.whole_b(input)));
        text.rows("A", a.row_iter().map(|row| row.iter().copied().collect()));
        text.rows("B", (0..a.nrows()).map(|k| vec![b[0][k], b[1][k]]));
    }
    sheet.review.aircraft = Some(text.finish());
}
