//! An aircraft from coefficients that were read: what is missing is asked for, what can't be is told.

use super::aircraft_text::AircraftText;
use super::review::{Basis, Remedy};
use super::sheet::Sheet;
use crate::content::matrix::draft::Problem;
use crate::flight::aircraft::atmosphere::{CEILING, standard_air};
use crate::flight::aircraft::coefficients::{LATERAL_COEFFICIENTS, LONGITUDINAL_COEFFICIENTS};
use crate::flight::aircraft::inertia::Inertia;
use crate::flight::analysis::STANDARD_GRAVITY;
use crate::number::{fixed, significant, trimmed};

/// How far lift may be from carrying the weight: the room that an aircraft file leaves for rounding.
const LIFT_BAND: f64 = 0.05;

/// Completes the sheet and, where nothing is missing, writes the aircraft.
pub(super) fn complete(sheet: &mut Sheet) -> Result<(), Problem> {
    sheet.set_basis(Basis::Coefficients);
    let mass = sheet.needed("mass", None)?;
    // What stands in the file is not missing while it is open which part of it counts, or in which unit.
    let is_open = ["case", "units", "length_unit"].into_iter().any(|key| sheet.waits_for(key));
    let [s, c, b] = if is_open {
        [None; 3]
    } else {
        [sheet.needed("S", None)?, sheet.needed("c", None)?, sheet.needed("b", None)?]
    };
    let inertia = [sheet.needed("Ix", None)?, sheet.needed("Iy", None)?, sheet.needed("Iz", None)?];
    let none = "a symmetric mass fore and aft; it is small in most aircraft";
    let ixz = sheet.needed("Ixz", Some((0.0, none.to_owned())))?;
    if is_open {
        return Ok(());
    }
    let gravity = sheet.value("gravity")?.unwrap_or(STANDARD_GRAVITY);
    let alpha0 = sheet.value("alpha0_deg")?.unwrap_or(0.0);
    let gamma0 = sheet.value("gamma0_deg")?.unwrap_or(0.0);
    let (altitude, density) = air(sheet)?;
    let air_density = density.or(altitude.and_then(|h| Some(standard_air(h).ok()?.density)));

    let cl = sheet.needed("CL", None)?;
    let speed = {
        // V = √(2 m g cos γ₀/(ρ S C_L))
        let level =
            || Some((2.0 * mass? * gravity * gamma0.to_radians().cos() / (air_density? * s? * cl?)).sqrt());
        let why = "the lift then carries the weight";
        sheet.needed("speed", level().map(|speed| (speed, why.to_owned())))?
    };
    if let (Some(mass), Some(rho), Some(s), Some(cl), Some(speed)) = (mass, air_density, s, cl, speed) {
        check_lift(sheet, mass * gravity * gamma0.to_radians().cos(), rho, s, cl, speed);
    }
    let drag_rise = {
        // C_Dα = 2 C_L C_Lα/(π e A)
        let e = sheet.span_efficiency.filter(|e| (0.3..=1.5).contains(e)).unwrap_or(0.8);
        let (s, b) = (s.unwrap_or(f64::NAN), b.unwrap_or(f64::NAN));
        let slope = sheet.finds("CL_alpha").unwrap_or(f64::NAN);
        let rise = 2.0 * cl.unwrap_or(f64::NAN) * slope / (std::f64::consts::PI * e * b * b / s);
        let why = format!("2 C_L C_Lα/(π e A) with e = {}", trimmed(e, 3));
        rise.is_finite().then_some((rise, why))
    };

    let mut longitudinal = Vec::new();
    let mut zeros = Vec::new();
    for field in &LONGITUDINAL_COEFFICIENTS {
        let value = match field.key {
            "CL" => cl,
            "CD_alpha" => sheet.needed(field.key, drag_rise.clone())?,
            "Cm_de" => sheet.value(field.key)?.or(Some(0.0)),
            key if field.required => sheet.needed(key, None)?,
            key => sheet.value(key)?.or(Some(0.0)),
        };
        if value == Some(0.0) && sheet.finds(field.key).is_none() {
            zeros.push(field.key);
        }
        longitudinal.push((field.key, value));
    }
    turn_elevator(sheet, &mut longitudinal, "Cm_de");
    let has_lateral =
        LATERAL_COEFFICIENTS.iter().any(|field| field.required && sheet.finds(field.key).is_some());
    let mut lateral = Vec::new();
    for field in LATERAL_COEFFICIENTS.iter().filter(|_| has_lateral) {
        let value = if field.required {
            sheet.needed(field.key, None)?
        } else {
            sheet.value(field.key)?.or(Some(0.0))
        };
        if value == Some(0.0) && sheet.finds(field.key).is_none() {
            zeros.push(field.key);
        }
        lateral.push((field.key, value));
    }
    if !zeros.is_empty() {
        sheet.remark(format!("Not in the file, and taken as zero: {}.", zeros.join(", ")));
    }
    say_senses(sheet, &lateral, ["Cl_da", "Cn_dr"]);
    if let (Some(mass), Some(b), [Some(ix), Some(iy), Some(iz)], Some(ixz)) = (mass, b, inertia, ixz) {
        check_inertia(sheet, mass, b, &Inertia { ix, iy, iz, ixz });
    }
    let mach = sheet.value("mach")?.filter(|mach| *mach > 0.0);
    if sheet.waits() {
        return Ok(());
    }

    let ratio = altitude.and_then(|h| Some(standard_air(h).ok()?.sound_speed));
    let mach_now = mach.or(speed.zip(ratio).map(|(v, a)| v / a)).unwrap_or(0.1);
    let condition = format!(
        "{} m/s, {} m",
        trimmed(speed.unwrap_or_default(), 4),
        fixed(altitude.unwrap_or_default(), 0)
    );
    let review = &sheet.review;
    let mut text = AircraftText::new(&review.title, &condition, &review.file, &review.notes());
    text.word("basis", "coefficients");
    text.word("units", "SI");
    text.word("axes", "stability");
    text.word("rates", "c/2V");
    text.word("angles", "rad");
    text.block("flight");
    text.optional("altitude", altitude);
    text.optional("speed", speed);
    text.optional("mach", mach);
    text.optional("density", density);
    text.number("gravity", gravity);
    text.number("alpha0_deg", alpha0);
    text.number("gamma0_deg", gamma0);
    text.block("airframe");
    for (key, value) in [("mass", mass), ("S", s), ("c", c), ("b", b), ("Ixz", ixz)] {
        text.optional(key, value);
    }
    for (key, value) in ["Ix", "Iy", "Iz"].into_iter().zip(inertia) {
        text.optional(key, value);
    }
    text.word("inertia_axes", if sheet.inertia_in_body_axes { "body" } else { "stability" });
    text.block("validity");
    text.number("CL_max", (1.2 * cl.unwrap_or_default()).max(1.4));
    text.list("mach", &[(mach_now - 0.2).clamp(0.0, 0.5 * mach_now), mach_now + 0.2]);
    text.word(
        "source",
        "Our assumption: the file says nothing of the stall or of how far its Mach number holds.",
    );
    text.block("longitudinal");
    text.unverified();
    longitudinal.iter().for_each(|&(key, value)| text.optional(key, value));
    if has_lateral {
        let of = |key| {
            lateral.iter().find(|(other, _)| *other == key).and_then(|(_, value)| *value).unwrap_or(0.0)
        };
        text.block("lateral");
        text.unverified();
        text.word("positive_aileron", if of("Cl_da") < 0.0 { "rolls left" } else { "rolls right" });
        text.word("positive_rudder", if of("Cn_dr") > 0.0 { "nose right" } else { "nose left" });
        lateral.iter().for_each(|&(key, value)| text.optional(key, value));
    }
    sheet.review.aircraft = Some(text.finish());
    Ok(())
}

/// The value of a key in a list, zero where it is missing.
pub(super) fn of(values: &[(&str, Option<f64>)], key: &str) -> f64 {
    values.iter().find(|(other, _)| *other == key).and_then(|(_, value)| *value).unwrap_or(0.0)
}

/// Aileron and rudder whose positive sense is the other one are told; the aircraft file turns them.
pub(super) fn say_senses(sheet: &mut Sheet, lateral: &[(&str, Option<f64>)], [aileron, rudder]: [&str; 2]) {
    if of(lateral, aileron) < 0.0 {
        sheet.remark("The file’s positive aileron rolls to the left; here it is counted the other way, right wing down.");
    }
    if of(lateral, rudder) > 0.0 {
        sheet.remark("The file’s positive rudder turns the nose right; here it is counted the other way, trailing edge left.");
    }
}

/// Altitude and, where the file has it, density; one follows from the other by the standard atmosphere.
fn air(sheet: &mut Sheet) -> Result<(Option<f64>, Option<f64>), Problem> {
    let density = sheet.value("density")?;
    if sheet.finds("altitude").is_none()
        && let Some(rho) = density
    {
        let height = altitude_of(rho);
        let reason = format!("the standard atmosphere has the file’s {} kg/m³ there", significant(rho, 4));
        return Ok((sheet.needed("altitude", Some((height, reason)))?, density));
    }
    let altitude = sheet.needed("altitude", Some((0.0, "sea level".to_owned())))?;
    Ok((altitude, density))
}

/// The altitude at which the standard atmosphere has a density, by halving \[m\].
fn altitude_of(density: f64) -> f64 {
    let (mut low, mut high) = (0.0, CEILING);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        let is_below = standard_air(middle).is_ok_and(|air| air.density > density);
        if is_below { low = middle } else { high = middle }
    }
    (0.5 * (low + high)).round()
}

fn check_lift(sheet: &mut Sheet, weight: f64, density: f64, s: f64, cl: f64, speed: f64) {
    // C_L = W cos γ₀/(q̄ S)
    let needed = weight / (0.5 * density * speed * speed * s);
    if (cl - needed).abs() <= LIFT_BAND * needed {
        return;
    }
    let level = (2.0 * weight / (density * s * cl)).sqrt();
    let remedy = if level.is_finite() { vec![Remedy::new("speed", level)] } else { Vec::new() };
    let instead =
        if level.is_finite() { format!("; {} m/s would", trimmed(level, 4)) } else { String::new() };
    sheet.stop(
        "lift",
        format!(
            "C_L = {} does not carry the weight at {} m/s, which takes {}{instead}.",
            trimmed(cl, 4),
            trimmed(speed, 4),
            trimmed(needed, 4)
        ),
        remedy,
    );
}

/// An elevator whose positive sense is trailing edge up, by its pitching moment, is turned, and it is told.
pub(super) fn turn_elevator(sheet: &mut Sheet, longitudinal: &mut [(&str, Option<f64>)], moment: &str) {
    let is_up =
        longitudinal.iter().any(|(key, value)| *key == moment && value.is_some_and(|value| value > 0.0));
    if !is_up {
        return;
    }
    for (_, value) in longitudinal.iter_mut().filter(|(key, _)| key.ends_with("de")) {
        *value = value.map(|value| -value);
    }
    sheet.remark(
        "The file’s positive elevator lifts the nose; here it is counted the other way, trailing edge down.",
    );
}

fn check_inertia(sheet: &mut Sheet, mass: f64, span: f64, inertia: &Inertia) {
    let Inertia { ix, iy, iz, ixz } = *inertia;
    if ix <= 0.0 || iy <= 0.0 || iz <= 0.0 {
        let told = [ix, iy, iz].map(|x| significant(x, 4)).join(", ");
        sheet.stop(
            "inertia",
            format!("Ix, Iy, Iz are {told} kg m²; every body has more than 0."),
            Vec::new(),
        );
        return;
    }
    if ixz * ixz >= ix * iz {
        let limit = significant((ix * iz).sqrt(), 4);
        let found = significant(ixz, 4);
        sheet.stop(
            "inertia",
            format!("Ixz is {found} kg m²; in every body it is below √(Ix Iz) = {limit}."),
            Vec::new(),
        );
        return;
    }
    let flatness = inertia.flatness();
    if flatness > 1.0 - 1e-6 {
        sheet.warn(
            "inertia",
            format!(
                "No rigid body has these moments of inertia: the largest is {} % of the sum of the other two, and it must be less than \
                 100 %.",
                fixed(100.0 * flatness, 0)
            ),
            Vec::new(),
        );
    }
    // Radii of gyration over half the span: 0.2 to 0.5 in aircraft.
    for (name, moment) in [("Ix", ix), ("Iy", iy), ("Iz", iz)] {
        let radius = (moment / mass).sqrt() / (0.5 * span);
        if !(0.03..=1.6).contains(&radius) {
            sheet.warn(
                "inertia",
                format!(
                    "{name} = {} kg m² is that of the whole mass {} half spans away from the axis; aircraft have 0.1 to 1. Is its unit right?",
                    significant(moment, 4),
                    trimmed(radius, 3)
                ),
                Vec::new(),
            );
        }
    }
}
