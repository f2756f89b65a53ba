//! Names for what a file of matrices leaves unnamed, as suggestions, and what its rows say of units and trim.

use super::review::Field;
use super::sheet::Sheet;
use super::system::System;
use crate::content::matrix::draft::{At, Draft, Problem, Rows};
use crate::content::matrix::state_names::{Meaning, control, plane_of_control, unit};
use crate::flight::aircraft::plane::Plane;
use crate::number::{significant, trimmed};

/// B with a row for each state; a single row of as many numbers is a column that was written down flat.
pub(super) fn upright(sheet: &mut Sheet, line: usize, b: Rows, n: usize) -> Result<At<Rows>, Problem> {
    if let [row] = b.as_slice()
        && row.value.len() == n
    {
        sheet.remark("B is one row of numbers, and read as a column.");
        let column = row.value.iter().map(|&x| At { line: row.line, value: vec![x] }).collect();
        return Ok(At { line, value: column });
    }
    let columns = b.first().map_or(0, |row| row.value.len());
    for (k, row) in b.iter().enumerate() {
        if row.value.len() != columns {
            let found = row.value.len();
            return Err((row.line, format!("B: expected {columns} numbers in row {}, found {found}", k + 1)));
        }
        if let Some(x) = row.value.iter().find(|x| !x.is_finite()) {
            return Err((row.line, format!("B: expected a finite number in row {}, found {x}", k + 1)));
        }
    }
    if b.len() == n {
        Ok(At { line, value: b })
    } else {
        Err((line, format!("B: expected {n} rows, one a state, found {}", b.len())))
    }
}

/// Names in a text: parted by commas where there are any, and by blanks otherwise; a unit in brackets belongs to the name before it.
pub(super) fn split(text: &str) -> Vec<String> {
    let is_list = text.contains([',', ';']);
    let parts = text.split(|c: char| if is_list { matches!(c, ',' | ';') } else { c.is_whitespace() });
    let mut names: Vec<String> = Vec::new();
    for part in parts.map(str::trim).filter(|name| !name.is_empty()) {
        match names.last_mut().filter(|_| part.starts_with(['[', '('])) {
            Some(name) => *name = format!("{name} {part}"),
            None => names.push(part.to_owned()),
        }
    }
    names
}

/// The names of the states: typed, said, or as A looks. `None` while a person has to say them.
pub(super) fn states(
    sheet: &mut Sheet,
    draft: &Draft,
    a: &[Vec<f64>],
) -> Result<Option<Vec<String>>, Problem> {
    let read = draft.names("states")?.map(|names| (names.line, names.value.join(", ")));
    let suggestion = guess(a).map(|names| (names, "that is what the rows of A look like".to_owned()));
    let mut field = Field::choice("states", "names of the states, in the order of A", &[]);
    field.required = true;
    let line = read.as_ref().map_or(1, |(line, _)| *line);
    let Some(text) = sheet.chosen(field, read.as_ref().map(|(_, names)| names.as_str()), suggestion)? else {
        return Ok(None);
    };
    let names = split(&text);
    if names.len() != a.len() {
        return Err((
            line,
            format!(
                "states: expected a name for each of the {} rows of A, found {}: {text}",
                a.len(),
                names.len()
            ),
        ));
    }
    Ok(Some(names))
}

/// Names that fit the rows of A, where the first four are of one plane.
pub(super) fn guess(a: &[Vec<f64>]) -> Option<String> {
    let near = |x: f64, expected: f64| (x - expected).abs() < 1e-3;
    let row = a.get(3)?;
    let is_one = |k: usize| row.iter().enumerate().all(|(j, &x)| near(x, if j == k { 1.0 } else { 0.0 }));
    let is_sideslip = a[0][1] < 0.0 && a[0][3] > 0.0 && near(a[0][2], 0.0);
    let mut names = if is_one(2) && is_sideslip {
        // Yaw before roll: φ̇ = p, v̇ = … − V r + g φ.
        let flow = if (0.8..1.2).contains(&-a[0][1]) { "beta" } else { "v" };
        vec![flow, "r", "p", "phi"]
    } else if is_one(2) {
        let flow = if near(a[1][2], 1.0) || (0.8..1.2).contains(&a[1][2]) { "alpha" } else { "w" };
        vec!["u", flow, "q", "theta"]
    } else if near(row[0], 0.0) && near(row[1], 1.0) && near(row[3], 0.0) {
        let flow = if (0.8..1.2).contains(&-a[0][2]) { "beta" } else { "v" };
        vec![flow, "p", "r", "phi"]
    } else {
        return None;
    };
    let is_longitudinal = names[0] == "u";
    for (k, row) in a.iter().enumerate().skip(4) {
        let depends_on_rest = row[4..].iter().any(|x| *x != 0.0);
        let name = if is_longitudinal {
            // ḣ = U₀ θ − w
            (!depends_on_rest && row[1] != 0.0 && row[3] != 0.0 && row[1] * row[3] < 0.0).then_some("h")
        } else {
            (!depends_on_rest && row[2] != 0.0 && near(row[0], 0.0) && near(row[3], 0.0)).then_some("psi")
        };
        names.push(name.filter(|name| !names.contains(name) && k < 6)?);
    }
    Some(names.join(" "))
}

/// Names that mean nothing here stand for states of their own where the file has all four states of a plane, and none of the other that
/// one of them could be; `None` where one can't.
pub(super) fn all_meanings(
    sheet: &mut Sheet,
    names: &[String],
    known: &[Option<Meaning>],
) -> Option<Vec<Meaning>> {
    let found = |plane: Plane| {
        let of_plane = known.iter().flatten().filter(|meaning| match meaning {
            Meaning::Rigid(of, _) => *of == plane,
            Meaning::Airspeed | Meaning::SpeedRatio | Meaning::PathAngle => plane == Plane::Longitudinal,
            _ => false,
        });
        of_plane.count()
    };
    let planes = Plane::ALL.map(found);
    let are_whole = planes.contains(&4) && planes.iter().all(|count| matches!(count, 0 | 4));
    let mut meanings = Vec::with_capacity(names.len());
    for (name, meaning) in names.iter().zip(known) {
        meanings.push(match meaning {
            Some(meaning) => *meaning,
            None if are_whole && !is_either(name) => {
                sheet.remark(format!("“{name}” is no state known here, and is kept as a state of its own."));
                Meaning::Other
            }
            None => return None,
        });
    }
    Some(meanings)
}

/// Whether a name may be an angle or its rate.
fn is_either(name: &str) -> bool {
    matches!(name.to_lowercase().as_str(), "pitch" | "roll")
}

/// The sentence about a name that means nothing here.
pub(super) fn unknown(name: &str) -> String {
    if is_either(name) {
        return format!("“{name}” may be the angle or its rate: call it theta or q, phi or p.");
    }
    format!(
        "“{name}” is not a state known here; known are u (or V), w (or alpha), q, theta, v (or beta), p, r, phi, and h, psi, x, y, thrust, \
         elevator and the like beside them."
    )
}

/// What each name was taken for, where the name isn't plain.
pub(super) fn say_states(sheet: &mut Sheet, line: usize, names: &[String], meanings: &[Meaning]) {
    for (name, meaning) in names.iter().zip(meanings) {
        let words = words(*meaning);
        sheet.read_as(line, name, "state", words);
    }
}

/// A state in words.
fn words(meaning: Meaning) -> &'static str {
    match meaning {
        Meaning::Rigid(_, "u") => "speed along x, u",
        Meaning::Rigid(_, "w") => "speed along z, w",
        Meaning::Rigid(_, "alpha") => "angle of attack α",
        Meaning::Rigid(_, "q") => "pitch rate q",
        Meaning::Rigid(_, "theta") => "pitch angle θ",
        Meaning::Rigid(_, "v") => "speed along y, v",
        Meaning::Rigid(_, "beta") => "sideslip angle β",
        Meaning::Rigid(_, "p") => "roll rate p",
        Meaning::Rigid(_, "r") => "yaw rate r",
        Meaning::Rigid(..) => "bank φ",
        Meaning::Airspeed => "airspeed V, which is u in stability axes",
        Meaning::SpeedRatio => "u over the speed of flight",
        Meaning::PathAngle => "flight-path angle γ",
        Meaning::Height => "height",
        Meaning::Depth => "height, counted downward",
        Meaning::Heading => "heading ψ",
        Meaning::Place => "place over the ground",
        Meaning::Geodetic => "latitude or longitude",
        Meaning::Engine => "thrust, or the speed of an engine",
        Meaning::Actuator(_) => "position of a control",
        Meaning::Other => "a state of its own",
    }
}

/// The names of the inputs. `None` while a person has to say them.
pub(super) fn inputs(
    sheet: &mut Sheet,
    draft: &Draft,
    line: usize,
    columns: usize,
    meanings: &[Meaning],
) -> Result<Option<Vec<String>>, Problem> {
    let read = draft.names("inputs")?.map(|names| names.value.join(", "));
    let has = |plane| meanings.iter().any(|meaning| matches!(meaning, Meaning::Rigid(of, _) if *of == plane));
    let usual: &[&str] = match (has(Plane::Longitudinal), has(Plane::Lateral)) {
        (true, true) => &["elevator", "throttle", "aileron", "rudder"],
        (_, false) => &["elevator", "throttle"],
        (false, true) => &["aileron", "rudder"],
    };
    let suggestion = usual.get(..columns).map(|names| (names.join(", "), "the usual order".to_owned()));
    let field = Field::choice("inputs", "names of the columns of B", &[]);
    let Some(text) = sheet.chosen(field, read.as_deref(), suggestion)? else { return Ok(None) };
    let names = split(&text);
    if names.len() != columns {
        let found = names.len();
        return Err((
            line,
            format!("inputs: expected a name for each of the {columns} columns of B, found {found}: {text}"),
        ));
    }
    for name in &names {
        let words = control(name).map_or("not a control known here", |key| match plane_of_control(key) {
            Plane::Longitudinal if key == "elevator" => "elevator",
            Plane::Longitudinal => "throttle",
            Plane::Lateral if key == "aileron" => "aileron",
            Plane::Lateral => "rudder",
        });
        sheet.read_as(line, name, "input", words);
    }
    Ok(Some(names))
}

/// The unit system, where gravity in A says it or the names of the states do.
pub(super) fn units_hint(system: &System) -> Option<(String, String)> {
    let named = |wanted: &[&str]| {
        system.names.iter().filter_map(|name| unit(name)).any(|unit| wanted.contains(&unit.as_str()))
    };
    if named(&["ft/s", "ft", "fps"]) {
        return Some(("ft-slug-s".to_owned(), "the names of the states say feet".to_owned()));
    }
    if named(&["m/s", "m"]) {
        return Some(("SI".to_owned(), "the names of the states say metres".to_owned()));
    }
    let [u, _, _, theta] = system.plane(Plane::Longitudinal);
    let [v, _, _, phi] = system.plane(Plane::Lateral);
    let is_velocity = |k: usize| system.meanings[k] == Meaning::Rigid(Plane::Lateral, "v");
    let gravity = match (u.zip(theta), v.filter(|&k| is_velocity(k)).zip(phi)) {
        (Some((u, theta)), _) => -system.a[u][theta],
        (_, Some((v, phi))) => system.a[v][phi],
        _ => return None,
    };
    let is_near = |g: f64| (gravity / g - 1.0).abs() < 0.03;
    let told = significant(gravity.abs(), 4);
    if is_near(9.81) {
        Some(("SI".to_owned(), format!("gravity in A is {told}, as in metres")))
    } else if is_near(32.17) {
        Some(("ft-slug-s".to_owned(), format!("gravity in A is {told}, as in feet")))
    } else {
        None
    }
}

/// The file's unit of angle in radians.
pub(super) fn angle(angles: &str) -> f64 {
    match angles {
        "deg" => 1_f64.to_radians(),
        "crad" => 0.01,
        _ => 1.0,
    }
}

/// States and inputs whose names tell a unit of their own, in the units of the file.
pub(super) fn own_units(system: &mut System, length: f64, angles: &str) {
    let angle = angle(angles);
    // x in the file's unit is size/base of ours: x′ = (size/base) x
    let factor = |name: &str| {
        let (size, base) = match unit(name)?.as_str() {
            "deg" | "deg/s" | "degree" | "degrees" | "°" | "°/s" => (1_f64.to_radians(), angle),
            "rad" | "rad/s" => (1.0, angle),
            "ft" | "ft/s" | "fps" => (0.3048, length),
            "m" | "m/s" => (1.0, length),
            "kt" | "kts" | "kn" => (0.514_444_444_444_444_4, length),
            "%" | "percent" => (0.01, 1.0),
            _ => return None,
        };
        (size != base).then_some(size / base)
    };
    for k in 0..system.names.len() {
        if let Some(factor) = factor(&system.names[k]) {
            system.rescale(k, 1.0 / factor);
        }
    }
    for k in 0..system.inputs.len() {
        if let Some(factor) = factor(&system.inputs[k]) {
            system.b.iter_mut().for_each(|row| row[k] /= factor);
        }
    }
}

/// What the rows of height and place say of the trim.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct ToldTrim {
    /// In the file's unit.
    pub speed: Option<f64>,
    pub alpha0_deg: Option<f64>,
    pub gamma0_deg: Option<f64>,
}

/// ż = w − U₀ θ and ẋ = u + W₀ θ in level flight, or ḣ = V (θ − α): their column of θ.
pub(super) fn trim_of_places(system: &System) -> ToldTrim {
    let [u, w, _, theta] = system.plane(Plane::Longitudinal);
    let (Some(u), Some(w), Some(theta)) = (u, w, theta) else { return ToldTrim::default() };
    let Some(vertical) = system.place(&[Meaning::Height, Meaning::Depth]) else { return ToldTrim::default() };
    let climb = system.a[vertical][theta].abs();
    let by_angle = system.meanings[w] == Meaning::Rigid(Plane::Longitudinal, "alpha");
    let of_w = system.a[vertical][w].abs();
    // The row must be one of height: −1 of w, or −V of α.
    let fits = if by_angle { (of_w / climb - 1.0).abs() < 0.02 } else { (of_w - 1.0).abs() < 0.02 };
    if !(climb.is_finite() && climb > 0.0 && fits) {
        return ToldTrim::default();
    }
    let along = (0..system.names.len())
        .find(|&k| system.meanings[k] == Meaning::Place && (system.a[k][u] - 1.0).abs() < 0.02);
    match along {
        Some(x) if !by_angle => {
            let w0 = system.a[x][theta];
            let alpha0 = w0.atan2(climb).to_degrees();
            // φ̇ = p + r tan θ₀
            let [_, _, r, phi] = system.plane(Plane::Lateral);
            let theta0 = phi.zip(r).map(|(phi, r)| system.a[phi][r].atan().to_degrees());
            let gamma0_deg = theta0.map(|theta0| theta0 - alpha0).filter(|gamma0| gamma0.abs() > 1e-6);
            ToldTrim { speed: Some(climb.hypot(w0)), alpha0_deg: Some(alpha0), gamma0_deg }
        }
        _ => ToldTrim { speed: Some(climb), ..ToldTrim::default() },
    }
}

/// The speed that the rates in A say, in the file's unit: the larger of the two, for Z_q and Y_r take away from it in most aircraft.
pub(super) fn speed_hint(system: &System) -> Option<(f64, String)> {
    let turn = |plane, flow: usize, rate: usize, name: &'static str| {
        let places = system.plane(plane);
        let (flow, rate) = places[flow].zip(places[rate])?;
        (system.meanings[flow] == Meaning::Rigid(plane, name)).then(|| system.a[flow][rate].abs())
    };
    let by_pitch = turn(Plane::Longitudinal, 1, 2, "w")
        .map(|turn| (turn, format!("A(w, q) is {}, which is U₀ + Z_q", trimmed(turn, 5))));
    let by_yaw = turn(Plane::Lateral, 0, 2, "v")
        .map(|turn| (turn, format!("A(v, r) is −{}, which is Y_r − U₀", trimmed(turn, 5))));
    let hints = [by_pitch, by_yaw].into_iter().flatten().filter(|(turn, _)| *turn > 1.0);
    hints.max_by(|x, y| x.0.total_cmp(&y.0))
}
