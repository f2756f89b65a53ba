//! What the names of states and inputs in other people's files mean: `V`, `du`, `u_hat`, `pitch rate`, `psi`, `thrust`, ….

use crate::flight::aircraft::plane::Plane;

/// A state or an input as a file names it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::content) enum Meaning {
    /// One of the four of a plane, by the name that it has here.
    Rigid(Plane, &'static str),
    /// The airspeed V, which is u in stability axes.
    Airspeed,
    /// u over the speed of flight.
    SpeedRatio,
    /// Flight-path angle γ, in place of θ = γ + α.
    PathAngle,
    /// Height, upward.
    Height,
    /// Height, downward.
    Depth,
    /// Heading ψ.
    Heading,
    /// Place along or across the ground.
    Place,
    /// Latitude or longitude, an angle.
    Geodetic,
    /// Thrust, or the speed of an engine.
    Engine,
    /// Position of a control, by the name that it has here.
    Actuator(&'static str),
    /// A state that isn't known here.
    Other,
}

use Meaning::{Airspeed, Depth, Engine, Geodetic, Heading, Height, PathAngle, Place, Rigid, SpeedRatio};

const LONGITUDINAL: [(&str, &[&str]); 4] = [
    ("u", &["u", "ub", "ua", "forwardspeed", "forwardvelocity", "axialvelocity"]),
    ("w", &["w", "wb", "wa", "normalvelocity", "verticalvelocity", "heavevelocity"]),
    ("q", &["q", "qb", "pitchrate", "pitchvelocity", "thetadot"]),
    ("theta", &["theta", "the", "tht", "pitchangle", "pitchattitude"]),
];

const LATERAL: [(&str, &[&str]); 4] = [
    ("v", &["v", "vb", "sidevelocity", "sidespeed", "lateralvelocity", "sideslipvelocity"]),
    ("p", &["p", "pb", "rollrate", "rollvelocity"]),
    ("r", &["r", "rb", "yawrate", "yawvelocity"]),
    ("phi", &["phi", "bank", "bankangle", "rollangle", "rollattitude"]),
];

const ALPHA: [&str; 4] = ["alpha", "alfa", "aoa", "angleofattack"];
const BETA: [&str; 5] = ["beta", "bet", "sideslip", "sideslipangle", "aos"];

const OTHERS: [(Meaning, &[&str]); 9] = [
    (Airspeed, &["va", "vt", "vtas", "tas", "airspeed", "speed", "velocity", "vel", "vinf", "trueairspeed"]),
    (SpeedRatio, &["uhat", "ubar", "u/u0", "u/v", "u/v0", "uprime"]),
    (PathAngle, &["gamma", "flightpathangle", "pathangle"]),
    (Height, &["h", "alt", "altitude", "height", "he", "hp"]),
    (Depth, &["z", "ze", "zi", "down", "pd"]),
    (Heading, &["psi", "heading", "hdg", "yawangle", "headingangle", "azimuth"]),
    (
        Place,
        &[
            "x",
            "xe",
            "xi",
            "y",
            "ye",
            "yi",
            "north",
            "east",
            "pn",
            "pe",
            "distance",
            "range",
            "crossrange",
            "downrange",
        ],
    ),
    (Geodetic, &["latitude", "longitude", "lat", "lon", "long"]),
    (Engine, &["t", "thrust", "rpm", "rpm0", "rpm1", "n1", "n2", "engine", "enginespeed", "power"]),
];

const CONTROLS: [(&str, &[&str]); 4] = [
    (
        "elevator",
        &[
            "elevator",
            "elev",
            "ele",
            "de",
            "deltae",
            "eta",
            "stabilator",
            "stabiliser",
            "stabilizer",
            "decmd",
            "elevatorcmd",
        ],
    ),
    (
        "throttle",
        &[
            "throttle",
            "dt",
            "deltat",
            "dth",
            "deltath",
            "thr",
            "thrust",
            "thtlcmd",
            "throttlecmd",
            "power",
            "tau",
            "t",
        ],
    ),
    ("aileron", &["aileron", "ailerons", "ail", "da", "deltaa", "xi", "dacmd", "aileroncmd"]),
    ("rudder", &["rudder", "rud", "dr", "deltar", "zeta", "drcmd", "ruddercmd"]),
];

/// A name in small letters without signs, and the unit behind it: "Δα [deg]" is `alpha` in `deg`.
fn parts(name: &str) -> (String, Option<String>) {
    let name = name.trim();
    let (base, unit) = match name.find(['[', '(']) {
        Some(at) if at > 0 => {
            let unit = name[at + 1..].trim_end_matches([']', ')']).trim();
            (&name[..at], (!unit.is_empty()).then(|| unit.to_lowercase()))
        }
        _ => (name, None),
    };
    let mut plain = String::with_capacity(base.len());
    for c in base.trim().trim_start_matches(['Δ', '∆']).chars() {
        match c {
            'α' => plain.push_str("alpha"),
            'β' => plain.push_str("beta"),
            'γ' => plain.push_str("gamma"),
            'δ' | 'Δ' => plain.push_str("delta"),
            'η' => plain.push_str("eta"),
            'ζ' => plain.push_str("zeta"),
            'ξ' => plain.push_str("xi"),
            'θ' | 'ϑ' => plain.push_str("theta"),
            'φ' | 'ϕ' => plain.push_str("phi"),
            'ψ' => plain.push_str("psi"),
            c if c.is_alphanumeric() || c == '/' => plain.extend(c.to_lowercase()),
            _ => {}
        }
    }
    (plain, unit)
}

/// The unit that stands behind a name in brackets, in small letters.
pub(in crate::content) fn unit(name: &str) -> Option<String> {
    parts(name).1
}

/// The control that a name means.
pub(in crate::content) fn control(name: &str) -> Option<&'static str> {
    let plain = parts(name).0;
    let of = |plain: &str| CONTROLS.iter().find(|(_, names)| names.contains(&plain)).map(|&(key, _)| key);
    of(&plain).or_else(|| of(plain.strip_prefix("delta")?)).or_else(|| of(plain.strip_suffix("rad")?))
}

/// The plane of motion that a control moves.
pub(in crate::content) fn plane_of_control(key: &str) -> Plane {
    if matches!(key, "elevator" | "throttle") { Plane::Longitudinal } else { Plane::Lateral }
}

/// What a name of a state alone means; names that mean one of two things are told apart by [`meanings`].
fn state(plain: &str) -> Option<Meaning> {
    if ALPHA.contains(&plain) {
        return Some(Rigid(Plane::Longitudinal, "alpha"));
    }
    if BETA.contains(&plain) {
        return Some(Rigid(Plane::Lateral, "beta"));
    }
    let of = |plane, names: &[(&'static str, &[&str])]| {
        names.iter().find(|(_, names)| names.contains(&plain)).map(|&(key, _)| Rigid(plane, key))
    };
    of(Plane::Longitudinal, &LONGITUDINAL)
        .or_else(|| of(Plane::Lateral, &LATERAL))
        .or_else(|| OTHERS.iter().find(|(_, names)| names.contains(&plain)).map(|&(meaning, _)| meaning))
        .or_else(|| {
            CONTROLS.iter().find(|(_, names)| names.contains(&plain)).map(|&(key, _)| Meaning::Actuator(key))
        })
}

/// The two things that a name may mean, the rate first.
const EITHER: [(&str, Meaning, Meaning); 3] = [
    ("pitch", Rigid(Plane::Longitudinal, "q"), Rigid(Plane::Longitudinal, "theta")),
    ("roll", Rigid(Plane::Lateral, "p"), Rigid(Plane::Lateral, "phi")),
    ("yaw", Rigid(Plane::Lateral, "r"), Heading),
];

/// What each name of a file's states means beside the others; `None` for one that isn't known.
pub(in crate::content) fn meanings(names: &[String]) -> Vec<Option<Meaning>> {
    let mut plain: Vec<String> = names.iter().map(|name| parts(name).0).collect();
    // Every name with a d or a delta in front is one of small disturbances: du, dv, dr.
    for prefix in ["delta", "d"] {
        if plain.iter().all(|name| name.strip_prefix(prefix).is_some_and(|rest| state(rest).is_some())) {
            plain.iter_mut().for_each(|name| *name = name[prefix.len()..].to_owned());
        }
    }
    let known = |name: &String| {
        let without = |prefix| name.strip_prefix(prefix).and_then(state);
        state(name).or_else(|| without("delta")).or_else(|| without("d"))
    };
    let mut meanings: Vec<Option<Meaning>> = plain.iter().map(known).collect();
    let has = |meanings: &[Option<Meaning>], meaning| meanings.contains(&Some(meaning));
    // V is the airspeed where nothing else is the speed, and the sideslip otherwise.
    let has_speed =
        [Rigid(Plane::Longitudinal, "u"), Airspeed, SpeedRatio].iter().any(|&m| has(&meanings, m));
    let has_pitching =
        ["alpha", "w", "q", "theta"].iter().any(|&key| has(&meanings, Rigid(Plane::Longitudinal, key)));
    if !has_speed && has_pitching {
        let slip = Some(Rigid(Plane::Lateral, "v"));
        if let Some(at) = (0..plain.len()).find(|&k| meanings[k] == slip) {
            meanings[at] = Some(Airspeed);
        }
    }
    for (name, rate, angle) in EITHER {
        let Some(at) = plain.iter().position(|other| other == name) else { continue };
        let meaning = if has(&meanings, rate) { angle } else { rate };
        // Without the angle's own name beside it, a name alone says nothing of which it is.
        let is_told = has(&meanings, rate) || has(&meanings, angle) || angle == Heading;
        meanings[at] = is_told.then_some(meaning);
    }
    meanings
}

/// Whether a name is one of a state that is neither rigid-body motion nor a control.
pub(in crate::content) fn is_further(name: &str) -> bool {
    let plain = parts(name).0;
    control(name).is_none() && state(&plain).is_some_and(|meaning| !matches!(meaning, Meaning::Actuator(_)))
}

/// Whether a name is one of a state or a control.
pub(in crate::content) fn is_known(name: &str) -> bool {
    let plain = parts(name).0;
    state(&plain).is_some() || EITHER.iter().any(|(either, ..)| *either == plain) || control(name).is_some()
}
