//! The aircraft for JSBSim: constants as functions, in the stability axes of its trim, where α and δ are changes from the trim.
//!
//! Its body axes are those of the model, so the trim has α = 0 and θ = γ₀. What JSBSim has no place for is told.

use maud::{Markup, PreEscaped, html};

use super::text::number;
use crate::export::error::ExportError;
use crate::export::scene::Scene;
use crate::flight::aircraft::aircraft_model::{AircraftModel, TrimmedModel};
use crate::flight::aircraft::coefficients::{Airframe, LateralCoefficients, LongitudinalCoefficients};
use crate::flight::aircraft::edits::Offsets;

/// One newton in pounds-force.
const POUNDS: f64 = 1.0 / 4.448_221_615_260_5;

/// Full deflection of a control \[rad\], 20°.
const FULL: f64 = 0.349_065_850_398_865_9;

/// Factors of a term that JSBSim knows by these names.
const ALPHA: &str = "aero/alpha-rad";
const BETA: &str = "aero/beta-rad";
const ELEVATOR: &str = "fcs/elevator-pos-rad";
const AILERON: &str = "fcs/left-aileron-pos-rad";
const RUDDER: &str = "fcs/rudder-pos-rad";
const CHORD_TIME: &str = "aero/ci2vel";
const SPAN_TIME: &str = "aero/bi2vel";

/// A term of a coefficient: its name, its value, and what it is multiplied by.
type Term<'a> = (&'a str, f64, Vec<&'a str>);

/// The aircraft's file. What isn't represented is added to `notices`.
pub fn jsbsim(scene: &Scene, notices: &mut Vec<String>) -> Result<String, ExportError> {
    let scenario = &scene.scenario;
    let key = &scenario.aircraft.key;
    let no_coefficients =
        || ExportError::Request(format!("JSBSim needs coefficients, and the source of {key} has none"));
    let AircraftModel::Coefficients(model) = &scenario.edited.aircraft_model else {
        return Err(no_coefficients());
    };
    if scenario.edited.offsets != Offsets::default() {
        notices.push(
            "What was added to derivatives and to entries of A and B has no place in JSBSim.".to_owned(),
        );
    }
    notices.push(
        "JSBSim has its own air and gravity. There Cl_r and Cn_p don't follow the lift, a gust has no gradient along the aircraft, and the \
         data have no limits.".to_owned(),
    );
    let TrimmedModel { flight, airframe, coefficients, derivatives } = model.derive()?;
    let inertia = derivatives.inertia.ok_or_else(no_coefficients)?;
    let trim = &derivatives.trim;
    let c = &coefficients.longitudinal;
    let pressure_area = flight.dynamic_pressure * airframe.s;
    // The lift and the thrust that hold the weight, whatever the source has rounded.
    let weight = airframe.mass * trim.gravity;
    let lift = weight * trim.gamma0.cos() / pressure_area;
    let thrust = pressure_area * c.cd + weight * trim.gamma0.sin();
    let mach = Mach { of_trim: flight.mach };
    let text = html! {
        (PreEscaped("<?xml version=\"1.0\"?>\n"))
        fdm_config name=(key) version="2.0" release="ALPHA" {
            fileheader {
                author { "Eigenwing" }
                description { (scenario.aircraft.name) ": " (scenario.aircraft.condition) ". Source: " (scenario.aircraft.source)
                    " Trim: true airspeed " (number(trim.speed)) " m/s, altitude " (number(flight.condition.altitude))
                    " m, theta = gamma = " (number(trim.gamma0)) " rad, alpha = 0, all controls 0." }
            }
            metrics {
                (measure("wingarea", "M2", airframe.s))
                (measure("wingspan", "M", airframe.b))
                (measure("chord", "M", airframe.c))
                (at_origin("location", "AERORP"))
                (at_origin("location", "EYEPOINT"))
                (at_origin("location", "VRP"))
            }
            mass_balance negated_crossproduct_inertia="true" {
                (measure("ixx", "KG*M2", inertia.ix))
                (measure("iyy", "KG*M2", inertia.iy))
                (measure("izz", "KG*M2", inertia.iz))
                // With the sign of its inertia tensor: our ∫ x z dm there stands with a minus.
                (measure("ixz", "KG*M2", -inertia.ixz))
                (measure("emptywt", "KG", airframe.mass))
                (at_origin("location", "CG"))
            }
            ground_reactions {}
            external_reactions {
                force name="thrust" frame="BODY" {
                                        function {
                        @if airframe.thrust_exponent == 0.0 {
                            (thrust_of_throttle(thrust, &airframe))
                        } @else {
                            product {
                                (thrust_of_throttle(thrust, &airframe))
                                pow {
                                    quotient {
                                        property { "velocities/vt-fps" }
                                        value { (number(trim.speed / 0.3048)) }
                                    }
                                    value { (number(airframe.thrust_exponent)) }
                                }
                            }
                        }
                    }
                    location unit="M" { x { "0" } y { "0" } z { (number(-airframe.thrust_offset)) } }
                    direction { x { "1" } y { "0" } z { "0" } }
                }
            }
            propulsion {}
            flight_control name="FCS" {
                property value="0" { "fcs/thrust-change" }
                channel name="Controls" {
                    (surface("elevator", "fcs/elevator-cmd-norm", ELEVATOR))
                    (surface("aileron", "fcs/aileron-cmd-norm", AILERON))
                    (surface("rudder", "fcs/rudder-cmd-norm", RUDDER))
                }
            }
            aerodynamics {
                (longitudinal(c, lift, thrust, &airframe, pressure_area, mach))
                @if let Some(c) = &coefficients.lateral { (lateral(c)) }
            }
        }
    };
    Ok(text.into_string() + "\n")
}

/// Mach number of the trim, from which its terms count.
#[derive(Clone, Copy)]
struct Mach {
    of_trim: f64,
}

/// The thrust at the trim's speed \[lbf\].
fn thrust_of_throttle(thrust: f64, airframe: &Airframe) -> Markup {
    html! {
        sum {
            value { (number(thrust * POUNDS)) }
            product {
                property { "fcs/thrust-change" }
                value { (number(airframe.thrust_per_throttle * POUNDS)) }
            }
        }
    }
}

fn measure(name: &str, unit: &str, value: f64) -> Markup {
    PreEscaped(format!("<{name} unit=\"{unit}\">{}</{name}>", number(value)))
}

fn at_origin(element: &str, name: &str) -> Markup {
    PreEscaped(format!("<{element} name=\"{name}\" unit=\"M\"><x>0</x><y>0</y><z>0</z></{element}>"))
}

fn surface(name: &str, input: &str, output: &str) -> Markup {
    html! {
        aerosurface_scale name=(name) {
            input { (input) }
            range { min { (number(-FULL)) } max { (number(FULL)) } }
            output { (output) }
        }
    }
}

fn longitudinal(
    c: &LongitudinalCoefficients,
    lift: f64,
    thrust: f64,
    airframe: &Airframe,
    pressure_area: f64,
    mach: Mach,
) -> Markup {
    let pitch_rate = vec!["velocities/q-aero-rad_sec", CHORD_TIME];
    let alpha_rate = vec!["aero/alphadot-rad_sec", CHORD_TIME];
    // C_D on the parabola of C_L(α).
    let slope = c.cl * c.cl_alpha;
    let curvature = if slope == 0.0 { 0.0 } else { c.cd_alpha / (2.0 * slope) * c.cl_alpha * c.cl_alpha };
    let cm_trim = -thrust * airframe.thrust_offset / (pressure_area * airframe.c);
    html! {
        (axis("LIFT", "CL", None, mach, &[
            ("trim", lift, vec![]), ("alpha", c.cl_alpha, vec![ALPHA]), ("q", c.cl_q, pitch_rate.clone()),
            ("alphadot", c.cl_alphadot, alpha_rate.clone()), ("mach", c.cl_m, vec!["mach"]), ("elevator", c.cl_de, vec![ELEVATOR]),
        ]))
        (axis("DRAG", "CD", None, mach, &[
            ("trim", c.cd, vec![]), ("alpha", c.cd_alpha, vec![ALPHA]), ("alpha-alpha", curvature, vec![ALPHA, ALPHA]),
            ("mach", c.cd_m, vec!["mach"]), ("elevator", c.cd_de, vec![ELEVATOR]),
        ]))
        (axis("PITCH", "Cm", Some("metrics/cbarw-ft"), mach, &[
            ("trim", cm_trim, vec![]), ("alpha", c.cm_alpha, vec![ALPHA]), ("q", c.cm_q, pitch_rate),
            ("alphadot", c.cm_alphadot, alpha_rate), ("mach", c.cm_m, vec!["mach"]), ("elevator", c.cm_de, vec![ELEVATOR]),
        ]))
    }
}

fn lateral(c: &LateralCoefficients) -> Markup {
    let terms = |beta: f64, p: f64, r: f64, aileron: f64, rudder: f64| {
        [
            ("beta", beta, vec![BETA]),
            ("p", p, vec!["velocities/p-aero-rad_sec", SPAN_TIME]),
            ("r", r, vec!["velocities/r-aero-rad_sec", SPAN_TIME]),
            ("aileron", aileron, vec![AILERON]),
            ("rudder", rudder, vec![RUDDER]),
        ]
    };
    let span = Some("metrics/bw-ft");
    let none = Mach { of_trim: 0.0 };
    html! {
        (axis("SIDE", "CY", None, none, &terms(c.cy_beta, c.cy_p, c.cy_r, c.cy_da, c.cy_dr)))
        (axis("ROLL", "Cl", span, none, &terms(c.cl_beta, c.cl_p, c.cl_r, c.cl_da, c.cl_dr)))
        (axis("YAW", "Cn", span, none, &terms(c.cn_beta, c.cn_p, c.cn_r, c.cn_da, c.cn_dr)))
    }
}

/// An axis with its terms: dynamic pressure, area, for a moment a length, and the coefficient.
fn axis(name: &str, symbol: &str, length: Option<&str>, mach: Mach, terms: &[Term<'_>]) -> Markup {
    html! {
        axis name=(name) {
            @for (of, value, factors) in terms.iter().filter(|(_, value, _)| *value != 0.0) {
                function name={ "aero/coefficient/" (symbol) "-" (of) } {
                    product {
                        property { "aero/qbar-psf" }
                        property { "metrics/Sw-sqft" }
                        @if let Some(length) = length { property { (length) } }
                        @for factor in factors {
                            @if *factor == "mach" {
                                difference { property { "velocities/mach" } value { (number(mach.of_trim)) } }
                            } @else {
                                property { (factor) }
                            }
                        }
                        value { (number(*value)) }
                    }
                }
            }
        }
    }
}
