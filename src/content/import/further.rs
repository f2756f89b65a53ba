//! States beside the four of a plane in a file of matrices: which plane each belongs to, what it is, what it does to the four, and its
//! numbers in SI.

use nalgebra::DMatrix;

use super::part::{Further, Part};
use super::sheet::Sheet;
use super::system::{HARDLY, System, largest_shift, upper};
use crate::content::matrix::state_names::{Meaning, control, plane_of_control};
use crate::flight::aircraft::further::{AppendedState, MOST_FURTHER};
use crate::flight::aircraft::plane::{Plane, PlaneModel};
use crate::flight::aircraft::whole_model::{CommandMoves, with_further};
use crate::key::Keyed as _;
use crate::number::significant;

/// Mean radius of the Earth \[m\], by which latitude and longitude are lengths (IUGG).
const EARTH: f64 = 6_371_000.0;

/// What a state that isn't of the rigid body is, in a word.
pub(super) const fn word(meaning: Meaning) -> &'static str {
    match meaning {
        Meaning::Height | Meaning::Depth => "height",
        Meaning::Heading => "heading",
        Meaning::Place | Meaning::Geodetic => "place",
        Meaning::Engine => "engine",
        Meaning::Actuator(_) => "control",
        Meaning::Other => "a state of its own",
        Meaning::Rigid(..) | Meaning::Airspeed | Meaning::SpeedRatio | Meaning::PathAngle => {
            "a rigid-body state of no whole plane"
        }
    }
}

/// Gives each plane the states that are kept beside its four.
pub(super) fn share_out(system: &System, parts: &mut [Part]) {
    let mut later = Vec::new();
    for (place, meaning) in system.meanings.iter().enumerate() {
        let (plane, state) = match *meaning {
            Meaning::Height | Meaning::Depth => (Plane::Longitudinal, AppendedState::Height),
            Meaning::Heading => (Plane::Lateral, AppendedState::Heading),
            Meaning::Actuator(key) => {
                let states = AppendedState::controls(plane_of_control(key));
                let Some(state) = states.into_iter().find(|state| state.key() == key) else { continue };
                (plane_of_control(key), state)
            }
            Meaning::Place | Meaning::Geodetic | Meaning::Engine | Meaning::Other => {
                later.push(place);
                continue;
            }
            Meaning::Rigid(..) | Meaning::Airspeed | Meaning::SpeedRatio | Meaning::PathAngle => continue,
        };
        if let Some(part) = parts.iter_mut().find(|part| part.plane == plane) {
            let moves = part.states.iter().any(|&i| system.a[i][place] != 0.0);
            if moves || !matches!(meaning, Meaning::Actuator(_)) {
                add(part, place, state);
            }
        }
    }
    // These go where they have most to do with the rest; a place across the path follows the heading.
    for place in later {
        let weights: Vec<f64> = parts.iter().map(|part| weight(system, place, part)).collect();
        let most = weights.iter().copied().fold(0.0, f64::max);
        let Some(k) = weights.iter().position(|weight| *weight == most) else { continue };
        let part = &mut parts[k];
        let state = match (system.meanings[place], part.plane) {
            (Meaning::Place | Meaning::Geodetic, Plane::Longitudinal) => AppendedState::Distance,
            (Meaning::Place | Meaning::Geodetic, Plane::Lateral) => AppendedState::Offset,
            (Meaning::Engine, _) => AppendedState::Engine,
            _ => AppendedState::Other,
        };
        add(part, place, state);
    }
}

fn add(part: &mut Part, place: usize, state: AppendedState) {
    let is_there = part.further.iter().any(|other| other.state == state);
    let state = if is_there && !state.may_repeat() { AppendedState::Other } else { state };
    if part.further.len() < MOST_FURTHER {
        // In the order of the file.
        let before = part.further.iter().take_while(|other| other.place < place).count();
        part.further.insert(before, Further { place, state });
    }
}

/// How much a state has to do with those of a part, whatever the units: what it does to them, each beside all that moves the same one,
/// and what they do to it, each beside all that the same one moves.
fn weight(system: &System, place: usize, part: &Part) -> f64 {
    let n = system.a.len();
    let share = |entry: f64, all: f64| if all > 0.0 { entry.abs() / all } else { 0.0 };
    let of_others = |j: usize, sum: &dyn Fn(usize) -> f64| (0..n).filter(|&m| m != j).map(sum).sum::<f64>();
    let shares = part.all().into_iter().map(|j| {
        let moved = share(system.a[j][place], of_others(j, &|m| system.a[j][m].abs()));
        let moves = share(system.a[place][j], of_others(j, &|m| system.a[m][j].abs()));
        moved + moves
    });
    shares.sum()
}

/// What is kept beside the four, and what difference it makes to them.
pub(super) fn say_kept(sheet: &mut Sheet, system: &System, parts: &[Part]) {
    let mut plain = Vec::new();
    let mut hardly = Vec::new();
    for part in parts {
        for further in &part.further {
            // A control is told with its lag.
            if further.control().is_some() {
                continue;
            }
            let k = further.place;
            let told = format!("{} ({})", system.names[k], word(system.meanings[k]));
            if part.all().iter().all(|&i| i == k || system.a[i][k] == 0.0) {
                plain.push(told);
                continue;
            }
            // By itself, beside the four.
            let with: Vec<usize> = part.states.into_iter().chain([k]).collect();
            let shift = largest_shift(&[system.part(&part.states)], &system.part(&with));
            match shift {
                Some(shift) if shift.relative >= HARDLY => sheet.remark(format!(
                    "{told} is kept as a state beside the four. With it alone the eigenvalue {} becomes {}: {} %, the most that any moves.",
                    upper(shift.alone),
                    upper(shift.together),
                    significant(100.0 * shift.relative, 2)
                )),
                Some(_) => hardly.push(told),
                None => sheet.remark(format!("{told} is kept as a state beside the four.")),
            }
        }
    }
    for (told, cost) in [
        (plain, "nothing else depends on"),
        (hardly, "no eigenvalue of the four moves by more than 0.01 % with"),
    ] {
        match told.as_slice() {
            [] => {}
            [one] => sheet.remark(format!("{one} is kept as a state beside the four: {cost} it.")),
            many => {
                sheet.remark(format!("{} are kept as states beside the four: {cost} them.", many.join(", ")));
            }
        }
    }
}

/// A model of four states, in SI, with the states that are kept beside them.
pub(super) fn with_further_of(
    sheet: &mut Sheet,
    system: &System,
    part: &Part,
    model: PlaneModel,
    length: f64,
    angle: f64,
) -> PlaneModel {
    if part.further.is_empty() {
        return model;
    }
    let n = 4 + part.further.len();
    let all = part.all();
    let scale_of = |k: usize, state: Option<AppendedState>| match (system.meanings[k], state) {
        // x_SI = s x
        (Meaning::Rigid(_, "alpha"), _) => model.trim.u0() * angle,
        (Meaning::Rigid(_, "beta"), _) => model.trim.speed * angle,
        (Meaning::Rigid(_, "u" | "w" | "v") | Meaning::Airspeed | Meaning::SpeedRatio, _) => length,
        (Meaning::Rigid(..) | Meaning::PathAngle, _) => angle,
        (Meaning::Depth, Some(AppendedState::Height)) => -length,
        (Meaning::Geodetic, Some(AppendedState::Distance | AppendedState::Offset)) => EARTH,
        (_, Some(AppendedState::Height | AppendedState::Distance | AppendedState::Offset)) => length,
        (_, Some(AppendedState::Throttle | AppendedState::Engine | AppendedState::Other) | None) => 1.0,
        (_, Some(_)) => angle,
    };
    let states: Vec<Option<AppendedState>> =
        [None; 4].into_iter().chain(part.further.iter().map(|further| Some(further.state))).collect();
    let scale: Vec<f64> = all.iter().zip(&states).map(|(&k, &state)| scale_of(k, state)).collect();
    let mut a = DMatrix::from_fn(n, n, |i, j| {
        if i < 4 && j < 4 { model.a[(i, j)] } else { system.a[all[i]][all[j]] * (scale[i] / scale[j]) }
    });
    let kinematics = (4..n).map(|j| a[(3, j)].abs()).fold(0.0, f64::max);
    if kinematics > 0.0 && kinematics < 1e-6 {
        a.view_mut((3, 4), (1, n - 4)).fill(0.0);
    }
    let mut b = DMatrix::from_fn(n, 2, |i, j| if i < 4 { model.b[(i, j)] } else { 0.0 });
    for (column, state) in AppendedState::controls(model.plane).into_iter().enumerate() {
        let input_scale = if state == AppendedState::Throttle { 1.0 } else { angle };
        let inputs = (0..system.inputs.len()).find(|&j| control(&system.inputs[j]) == Some(state.key()));
        if let Some(j) = inputs {
            for i in 4..n {
                b[(i, column)] = system.b[all[i]][j] * (scale[i] / input_scale);
            }
        }
        let Some(i) = states.iter().position(|other| *other == Some(state)) else { continue };
        // It is moved through its state, and by a command in any case.
        b.view_mut((0, column), (4, 1)).fill(0.0);
        if b[(i, column)] == 0.0 && a[(i, i)] < 0.0 {
            b[(i, column)] = -a[(i, i)];
        }
    }
    if part.further.iter().any(|further| {
        system.meanings[further.place] == Meaning::Geodetic && further.state != AppendedState::Other
    }) {
        sheet.remark(
            "Latitude and longitude are counted in metres here, with a radius of the Earth of 6371 km.",
        );
    }
    let states: Vec<AppendedState> = states.into_iter().flatten().collect();
    match with_further(model.plane, model.trim, states, &a, &b) {
        Ok(whole) => whole,
        Err(CommandMoves(_)) => model,
    }
}
