//! What A says whatever the aircraft: gravity turns with the pitch angle and the bank, and the axes turn with the rates. A model of
//! which that isn't true is in other units than its file says.

use super::review::Remedy;
use super::sheet::Sheet;
use crate::flight::aircraft::plane::{Plane, PlaneModel};
use crate::flight::aircraft::states::{Lateral, Longitudinal, entry};
use crate::number::{significant, trimmed};

/// How far an entry may be from what it stands for, either way: a climb, rounding, Z_q and Y_r let through, no confusion of units.
const PLAUSIBLE: std::ops::RangeInclusive<f64> = 0.5..=2.0;
/// How near a ratio must be to that of two units to be it.
const NEAR: f64 = 0.03;
/// No aircraft that people compute with has a shorter wing \[m\].
const SHORTEST: f64 = 0.25;
/// No aircraft flies with a lift that its slope is so many times: then the column of w is one of α.
const STEEPEST: f64 = 300.0;
/// Feet in a metre.
const FEET: f64 = 1.0 / 0.3048;
/// Units of speed in which a file may have it, beside those of its length \[m/s\].
const SPEED_UNITS: [(f64, &str); 5] = [
    (0.514_444_444_444_444_4, "knots"),
    (0.447_04, "miles an hour"),
    (1.0 / 3.6, "kilometres an hour"),
    (0.3048, "feet a second"),
    (1.0, "metres a second"),
];

fn is(ratio: f64, factor: f64) -> bool {
    (ratio / factor - 1.0).abs() < NEAR
}

/// What the file says of its units, as far as it concerns what may be wrong.
#[derive(Clone, Debug)]
pub(super) struct Said {
    /// Whether the units are SI, and not feet.
    pub is_si: bool,
    /// The file's unit of length in metres.
    pub length: f64,
    /// Whether angles are in radians.
    pub in_radians: bool,
    /// Whether the flow angle is the state: α or β, and not w or v.
    pub by_angle: bool,
    /// The names of the states with w for α, or β for v.
    pub renamed: String,
}

/// The doubts about one plane.
pub(super) fn check(sheet: &mut Sheet, model: &PlaneModel, said: &Said) {
    match model.plane {
        Plane::Longitudinal => longitudinal(sheet, model, said),
        Plane::Lateral => lateral(sheet, model, said),
    }
    signs(sheet, model);
}

fn longitudinal(sheet: &mut Sheet, model: &PlaneModel, said: &Said) {
    let (trim, a) = (&model.trim, &model.a);
    let g = trim.gravity * trim.theta0().cos();
    let (weight, turn) =
        (-entry(a, Longitudinal::U, Longitudinal::Theta), entry(a, Longitudinal::W, Longitudinal::Q));
    let [of_weight, of_turn] = [weight / g, turn / trim.u0()];
    let numbers = format!(
        "A(u, θ) is {} m/s², where −g cos θ₀ is {} m/s², and A(w, q) is {} m/s, where U₀ is {} m/s",
        significant(-weight, 4),
        significant(-g, 4),
        significant(turn, 4),
        significant(trim.u0(), 4)
    );
    if speed_in_other_units(sheet, model, said, [of_weight, of_turn], &numbers)
        || signs_of_axes(sheet, ["A(u, θ)", "A(w, q)"], [of_weight, of_turn], &numbers)
    {
        return;
    }
    if PLAUSIBLE.contains(&of_weight) && PLAUSIBLE.contains(&of_turn) {
        // Z_w = −(g/V) C_Lα/C_L
        let heave = entry(a, Longitudinal::W, Longitudinal::W);
        let slope = -heave * trim.speed / trim.gravity;
        if slope > STEEPEST && !said.by_angle {
            let sentence = format!(
                "A(w, w) is {} 1/s: lift would grow with each radian of α by {} times what it is. With a column of α under the name of w \
                 it would be {} times.",
                significant(heave, 4),
                significant(slope, 3),
                significant(slope / trim.speed, 3)
            );
            sheet.warn("alpha-columns", sentence, Vec::new());
        }
        return;
    }
    // In hundredths of a radian or degrees both are that much too small.
    let angles = [(0.01, "crad", "hundredths of a radian"), (1_f64.to_radians(), "deg", "degrees")];
    if said.in_radians {
        for (size, key, words) in angles {
            // A row of w under the name of α is U₀ times what it can be.
            let as_w = said.by_angle && is(of_weight, size) && is(of_turn, size * trim.u0() / said.length);
            if is(of_weight, size) && is(of_turn, size) && !said.by_angle {
                let sentence = format!("{numbers}: angles and rates are in {words}.");
                sheet.warn("angles", sentence, vec![Remedy::new("angles", key)]);
                return;
            }
            if as_w {
                let sentence =
                    format!("{numbers}: what is called α is w, and angles and rates are in {words}.");
                let remedy = vec![Remedy::new("angles", key), Remedy::new("states", &said.renamed)];
                sheet.warn("angles", sentence, remedy);
                return;
            }
        }
    }
    gravity(sheet, of_weight, PLAUSIBLE.contains(&of_turn), said, numbers);
}

/// A speed that the rates say in another unit than the file's, gravity being right.
fn speed_in_other_units(
    sheet: &mut Sheet,
    model: &PlaneModel,
    said: &Said,
    [of_weight, of_turn]: [f64; 2],
    numbers: &str,
) -> bool {
    let unit = SPEED_UNITS.iter().find(|(size, _)| *size != said.length && is(of_turn, size / said.length));
    let Some((size, words)) = unit.filter(|_| PLAUSIBLE.contains(&of_weight) && !said.by_angle) else {
        return false;
    };
    let speed = model.trim.speed * size / said.length;
    sheet.warn(
        "speed-unit",
        format!("{numbers}: the speed is in {words}."),
        vec![Remedy::new("speed", significant(speed, 6))],
    );
    true
}

/// Entries of the right size and the wrong sign: another sense of an axis, or a sign that got lost.
fn signs_of_axes(sheet: &mut Sheet, names: [&str; 2], ratios: [f64; 2], numbers: &str) -> bool {
    if !ratios.iter().all(|ratio| PLAUSIBLE.contains(&ratio.abs())) {
        return false;
    }
    let turned: Vec<&str> =
        names.into_iter().zip(ratios).filter(|(_, ratio)| *ratio < 0.0).map(|(name, _)| name).collect();
    if turned.is_empty() {
        return false;
    }
    let verb = if turned.len() == 1 { "has the wrong sign" } else { "have the wrong sign" };
    let sentence = format!(
        "{numbers}: {} {verb}. Here x points forward, y to the right and z down; turn the states that count the other way.",
        turned.join(" and ")
    );
    sheet.warn("axes", sentence, Vec::new());
    true
}

/// Gravity that is out by the ratio of a foot to a metre, the speed being right: the file is in the other unit.
fn gravity(sheet: &mut Sheet, of_weight: f64, turn_is_right: bool, said: &Said, numbers: String) {
    if turn_is_right && said.is_si && is(of_weight, FEET) {
        let sentence = format!("{numbers}: the file is in feet.");
        sheet.warn("gravity", sentence, vec![Remedy::new("units", "ft-slug-s")]);
    } else if turn_is_right && !said.is_si && is(of_weight, 1.0 / FEET) {
        let sentence = format!("{numbers}: the file is in metres.");
        sheet.warn("gravity", sentence, vec![Remedy::new("units", "SI")]);
    } else {
        let sentence = format!(
            "Gravity and length don’t belong to one unit system, or the speed to neither: {numbers}."
        );
        sheet.warn("gravity", sentence, Vec::new());
    }
}

fn lateral(sheet: &mut Sheet, model: &PlaneModel, said: &Said) {
    let (trim, a) = (&model.trim, &model.a);
    let g = trim.gravity * trim.theta0().cos();
    let (weight, turn) = (entry(a, Lateral::V, Lateral::Phi), -entry(a, Lateral::V, Lateral::R));
    let [of_weight, of_turn] = [weight / g, turn / trim.u0()];
    let numbers = format!(
        "A(v, φ) is {} m/s², where g cos θ₀ is {} m/s², and A(v, r) is {} m/s, where −U₀ is {} m/s",
        significant(weight, 4),
        significant(g, 4),
        significant(-turn, 4),
        significant(-trim.u0(), 4)
    );
    if speed_in_other_units(sheet, model, said, [of_weight, of_turn], &numbers)
        || signs_of_axes(sheet, ["A(v, φ)", "A(v, r)"], [of_weight, of_turn], &numbers)
    {
        return;
    }
    if PLAUSIBLE.contains(&of_weight) && PLAUSIBLE.contains(&of_turn) {
        pitch_angle(sheet, model);
        if !said.by_angle {
            columns_of_sideslip(sheet, model, said);
        }
        return;
    }
    let same_factor = of_weight > 0.0 && (of_turn / of_weight - 1.0).abs() < 0.5;
    if same_factor && said.by_angle && (0.8..1.25).contains(&(of_weight * said.length / trim.speed)) {
        let sentence = format!(
            "{numbers}: the row of β is one of v. With sideslip_row=v its first entry stays, as Y_v; with v-by-beta it is divided, too."
        );
        sheet.warn("sideslip-row", sentence, vec![Remedy::new("sideslip_row", "v")]);
    } else if same_factor && !said.by_angle && (0.8..1.25).contains(&(of_weight * trim.speed / said.length)) {
        let sentence = format!("{numbers}: what is called v is β.");
        sheet.warn("sideslip-row", sentence, vec![Remedy::new("states", &said.renamed)]);
    } else if same_factor && said.in_radians && (is(of_weight, 0.01) || is(of_weight, 1_f64.to_radians())) {
        let key = if is(of_weight, 0.01) { "crad" } else { "deg" };
        sheet.warn(
            "angles",
            format!("{numbers}: angles are in another unit."),
            vec![Remedy::new("angles", key)],
        );
    } else {
        gravity(sheet, of_weight, PLAUSIBLE.contains(&of_turn), said, numbers);
    }
}

/// The length that the rows of roll and yaw say: |A(p, p)/A(p, v)| and |A(r, r)/A(r, v)| are some spans each, and their mean between one
/// and two in every aircraft here. Columns of β under the name of v make it shorter by as much as the speed.
fn columns_of_sideslip(sheet: &mut Sheet, model: &PlaneModel, said: &Said) {
    let of = |rate| (entry(&model.a, rate, Lateral::V), entry(&model.a, rate, rate));
    let ((roll, roll_damping), (yaw, yaw_damping)) = (of(Lateral::P), of(Lateral::R));
    let length = ((roll_damping / roll) * (yaw_damping / yaw)).abs().sqrt();
    let by_angle = length * model.trim.speed;
    if !(length < SHORTEST && by_angle > 2.0 * SHORTEST) {
        return;
    }
    let [roll, roll_damping, yaw, yaw_damping] =
        [roll, roll_damping, yaw, yaw_damping].map(|x| significant(x, 4));
    let sentence = format!(
        "A(p, v) is {roll} beside A(p, p) of {roll_damping}, and A(r, v) {yaw} beside A(r, r) of {yaw_damping}: so small is a wing of {} m. \
         With columns of β under the name of v it is one of {} m.",
        significant(length, 2),
        significant(by_angle, 2)
    );
    let remedy = vec![Remedy::new("states", &said.renamed), Remedy::new("sideslip_row", "v")];
    sheet.warn("sideslip-columns", sentence, remedy);
}

/// φ̇ = p + r tan θ₀ says the pitch angle of the x axis, whatever the head of the file says.
fn pitch_angle(sheet: &mut Sheet, model: &PlaneModel) {
    let trim = &model.trim;
    let tangent = entry(&model.a, Lateral::Phi, Lateral::R);
    let found = tangent.atan().to_degrees();
    let said = trim.theta0().to_degrees();
    if (found - said).abs() < 0.3 {
        return;
    }
    // A(v, p) = Y_p + W₀, and Y_p is small.
    let by_speed =
        (entry(&model.a, Lateral::V, Lateral::P) / trim.speed).clamp(-1.0, 1.0).asin().to_degrees();
    let agrees = (by_speed - found).abs() < 0.15 * found.abs() + 0.3;
    let sentence = format!(
        "The row of φ says φ̇ = p + {} r, so the x axis is pitched up by θ₀ = {}°; the file says {}°{}.",
        significant(tangent, 4),
        trimmed(found, 3),
        trimmed(said, 3),
        if agrees { format!(". A(v, p) says {}°, too", trimmed(by_speed, 3)) } else { String::new() }
    );
    let remedy =
        if agrees && trim.gamma0 == 0.0 { vec![Remedy::new("alpha0_deg", found)] } else { Vec::new() };
    sheet.warn("pitch-angle", sentence, remedy);
}

/// Signs that no aircraft has.
fn signs(sheet: &mut Sheet, model: &PlaneModel) {
    let a = &model.a;
    let (damping, name, unit) = match model.plane {
        Plane::Longitudinal => {
            (entry(a, Longitudinal::W, Longitudinal::W), "A(w, w), the heave damping Z_w", "1/s")
        }
        Plane::Lateral => (entry(a, Lateral::V, Lateral::V), "A(v, v), the side force Y_v", "1/s"),
    };
    let rotation = match model.plane {
        Plane::Longitudinal => (entry(a, Longitudinal::Q, Longitudinal::Q), "A(q, q), the damping in pitch"),
        Plane::Lateral => (entry(a, Lateral::P, Lateral::P), "A(p, p), the damping in roll"),
    };
    for (value, name) in [(damping, name), rotation] {
        if value > 0.0 {
            let sentence = format!(
                "{name}, is {} {unit}; it is negative in every aircraft below the stall. Is a sign lost?",
                significant(value, 4)
            );
            sheet.warn("sign", sentence, Vec::new());
        }
    }
    let largest = a.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    if largest > 1e7 {
        let sentence = format!(
            "The largest entry of A is {}: a moment of inertia that is zero makes such numbers.",
            significant(largest, 2)
        );
        sheet.warn("inertia", sentence, Vec::new());
    }
}
