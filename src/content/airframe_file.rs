//! The blocks of numbers in an aircraft file: flight, airframe, coefficients or dimensional derivatives.

use super::aircraft::Particulars;
use super::reader::{Block, ContentError};
use super::units::UnitSystem;
use crate::flight::aircraft::aircraft_model::{AircraftModel, CoefficientModel, DerivativeModel};
use crate::flight::aircraft::atmosphere::standard_air;
use crate::flight::aircraft::coefficients::{
    Airframe, Coefficients, Field, Fin, HorizontalTail, InertiaAxes, LATERAL_COEFFICIENTS,
    LONGITUDINAL_COEFFICIENTS, LateralCoefficients, LongitudinalCoefficients, PlanarInertia,
};
use crate::flight::aircraft::condition::{FlightCondition, Reference, STEEPEST_PATH, Validity};
use crate::flight::aircraft::derivatives::{
    LATERAL_DERIVATIVES, LONGITUDINAL_DERIVATIVES, LateralDerivatives, LongitudinalDerivatives,
};
use crate::flight::aircraft::inertia::Inertia;
use crate::flight::aircraft::plane::Trim;

/// Axes in which a file's derivatives are given.
#[derive(Clone, Copy, PartialEq)]
enum Axes {
    Stability,
    Body,
}

const AXES: [(&str, Axes); 2] = [("stability", Axes::Stability), ("body", Axes::Body)];

const INERTIA_AXES: [(&str, InertiaAxes); 2] =
    [("body", InertiaAxes::Body), ("stability", InertiaAxes::Stability)];

/// The motion for a positive control as its source prints it, and whether that is our own sense.
const AILERONS: [(&str, bool); 2] = [("rolls right", true), ("rolls left", false)];
const RUDDERS: [(&str, bool); 2] = [("nose left", true), ("nose right", false)];

/// Factors on derivatives by aileron and rudder that turn the senses of a source into ours, with a remark for each that is turned.
struct Senses {
    aileron: f64,
    rudder: f64,
    remarks: Vec<String>,
}

impl Senses {
    fn read(lateral: &mut Block<'_>) -> Result<Self, ContentError> {
        let [aileron, rudder] =
            [lateral.choice("positive_aileron", &AILERONS)?, lateral.choice("positive_rudder", &RUDDERS)?];
        let turned = [
            (
                aileron,
                "The source’s positive aileron rolls to the left; here it is counted the other way, right wing down.",
            ),
            (
                rudder,
                "The source’s positive rudder turns the nose right; here it is counted the other way, trailing edge left.",
            ),
        ];
        let factor = |is_ours: bool| if is_ours { 1.0 } else { -1.0 };
        Ok(Self {
            aileron: factor(aileron),
            rudder: factor(rudder),
            remarks: turned
                .iter()
                .filter(|(is_ours, _)| !is_ours)
                .map(|(_, text)| (*text).to_owned())
                .collect(),
        })
    }

    /// The factor on the derivative with this key, as in "Cl_da", "Ldr" or "Ydr_star".
    fn factor(&self, key: &str) -> f64 {
        match key.trim_end_matches("_star") {
            key if key.ends_with("da") => self.aileron,
            key if key.ends_with("dr") => self.rudder,
            _ => 1.0,
        }
    }
}

/// Time unit of pitch rates in a source: c̄/2V, or c̄/V, which halves the coefficient.
const RATES: [(&str, f64); 2] = [("c/2V", 1.0), ("c/V", 2.0)];

/// The block `[flight]`, SI.
struct Flight {
    condition: FlightCondition,
    mach: Option<f64>,
    density: Option<f64>,
    alpha0: f64,
    gravity: f64,
}

fn read_flight(file: &mut Block<'_>, units: UnitSystem) -> Result<Flight, ContentError> {
    let mut block = file.block("flight")?;
    let altitude = block.number("altitude")? * units.length();
    if let Err(problem) = standard_air(altitude) {
        return Err(block.error("altitude", problem));
    }
    let gamma0 = block.optional_number("gamma0_deg")?.unwrap_or(0.0).to_radians();
    if gamma0.abs() > STEEPEST_PATH {
        return Err(block.error("gamma0_deg", "expected a flight path no steeper than 60°"));
    }
    let alpha0 = block.optional_number("alpha0_deg")?.unwrap_or(0.0).to_radians();
    if alpha0.abs() > 0.5 {
        return Err(block.error("alpha0_deg", "expected an angle of attack between −28° and 28°"));
    }
    let flight = Flight {
        condition: FlightCondition { altitude, speed: block.positive("speed")? * units.length(), gamma0 },
        mach: block.optional_positive("mach")?,
        density: block.optional_positive("density")?.map(|density| density * units.density()),
        alpha0,
        gravity: block.positive("gravity")? * units.length(),
    };
    if !(8.0..=11.0).contains(&flight.gravity) {
        let found = flight.gravity;
        let text = format!("expected free fall in the file's own unit of length; this is {found:.3} m/s²");
        return Err(block.error("gravity", text));
    }
    block.optional_text("source")?;
    block.finish()?;
    Ok(flight)
}

fn read_mass(block: &mut Block<'_>, units: UnitSystem, gravity: f64) -> Result<Option<f64>, ContentError> {
    match (block.optional_positive("weight")?, block.optional_positive("mass")?) {
        (Some(_), Some(_)) => Err(block.error("mass", "expected a weight or a mass, found both")),
        // m = W/g
        (Some(weight), None) => Ok(Some(weight * units.force() / gravity)),
        (None, mass) => Ok(mass.map(|mass| mass * units.mass())),
    }
}

/// An aircraft from coefficients: everything is needed.
pub(super) fn coefficient_model(
    file: &mut Block<'_>,
    units: UnitSystem,
    longitudinal: &mut Block<'_>,
    lateral: Option<&mut Block<'_>>,
) -> Result<(AircraftModel, Particulars, Vec<String>), ContentError> {
    file.choice("axes", &[("stability", ())])?;
    let per_half_time = file.choice("rates", &RATES)?;
    let flight = read_flight(file, units)?;
    let mut block = file.block("airframe")?;
    let mass = read_mass(&mut block, units, flight.gravity)?
        .ok_or_else(|| block.error("mass", "missing; expected a weight or a mass"))?;
    let (length, inertia) = (units.length(), units.inertia());
    let airframe = Airframe {
        mass,
        s: block.positive("S")? * length * length,
        c: block.positive("c")? * length,
        b: block.positive("b")? * length,
        ix: block.positive("Ix")? * inertia,
        iy: block.positive("Iy")? * inertia,
        iz: block.positive("Iz")? * inertia,
        ixz: block.number("Ixz")? * inertia,
        inertia_axes: block.choice("inertia_axes", &INERTIA_AXES)?,
        thrust_per_throttle: match block.optional_positive("thrust_per_throttle")? {
            Some(thrust) => thrust * units.force(),
            None => mass * flight.gravity,
        },
        thrust_exponent: block.optional_number("thrust_exponent")?.unwrap_or(0.0),
        thrust_offset: block.optional_number("thrust_offset")?.unwrap_or(0.0) * length,
        taper: block.optional_positive("taper")?,
        tail: read_tail(&mut block, length)?,
        fin: read_fin(&mut block, length)?,
    };
    let mut notes = Vec::from_iter(block.optional_text("source")?);
    notes.extend(block.optional_text("geometry_source")?);
    block.finish()?;
    if let Some(problem) = airframe.problem() {
        return Err(block.error(problem.key(), problem.to_string()));
    }

    let mut l = LongitudinalCoefficients::default();
    read_fields(longitudinal, &mut l, LONGITUDINAL_COEFFICIENTS.iter().map(|field| (*field, 1.0)))?;
    for number in [&mut l.cl_q, &mut l.cm_q, &mut l.cl_alphadot, &mut l.cm_alphadot] {
        *number *= per_half_time;
    }
    let lateral = lateral
        .map(|block| {
            let mut c = LateralCoefficients::default();
            let senses = Senses::read(block)?;
            let fields = LATERAL_COEFFICIENTS.iter().map(|field| (*field, senses.factor(field.key)));
            read_fields(block, &mut c, fields)?;
            notes.extend(senses.remarks);
            Ok(c)
        })
        .transpose()?;
    let coefficients = Coefficients { longitudinal: l, lateral };

    let air = standard_air(flight.condition.altitude).map_err(|problem| block.error_here(problem))?;
    let sound_speed = flight.mach.map_or(air.sound_speed, |mach| flight.condition.speed / mach);
    let density = flight.density.unwrap_or(air.density);
    check_lift(longitudinal, &airframe, &flight, density, l.cl)?;
    let reference = Reference {
        condition: flight.condition,
        density,
        sound_speed,
        alpha0: flight.alpha0,
        mass,
        gravity: flight.gravity,
    };
    let (validity, source) = read_validity(file, reference.mach(), l.cl)?;
    notes.push(format!("Limits of lift and Mach number. {source}"));
    let particulars = Particulars {
        mass: Some(mass),
        wing_area: Some(airframe.s),
        span: Some(airframe.b),
        chord: Some(airframe.c),
        speed: Some(flight.condition.speed),
        altitude: Some(flight.condition.altitude),
        mach: Some(reference.mach()),
    };
    let aircraft_model = CoefficientModel::new(airframe, reference, validity, coefficients);
    Ok((AircraftModel::Coefficients(aircraft_model), particulars, notes))
}

/// C_L must carry the weight: W cos γ₀/(q̄S) to 5 %, room for the source's rounding.
fn check_lift(
    block: &Block<'_>,
    airframe: &Airframe,
    flight: &Flight,
    density: f64,
    cl: f64,
) -> Result<(), ContentError> {
    let FlightCondition { speed, gamma0, .. } = flight.condition;
    let needed = airframe.mass * flight.gravity * gamma0.cos() / (0.5 * density * speed * speed * airframe.s);
    if (cl - needed).abs() <= 0.05 * needed {
        Ok(())
    } else {
        Err(block.error("CL", format_args!("{cl} does not carry the weight; expected about {needed:.3}")))
    }
}

fn read_tail(airframe: &mut Block<'_>, length: f64) -> Result<Option<HorizontalTail>, ContentError> {
    let Some(mut block) = airframe.optional_block("tail")? else { return Ok(None) };
    let tail = HorizontalTail {
        area: block.positive("area")? * length * length,
        arm: block.positive("arm")? * length,
    };
    block.finish()?;
    Ok(Some(tail))
}

fn read_fin(airframe: &mut Block<'_>, length: f64) -> Result<Option<Fin>, ContentError> {
    let Some(mut block) = airframe.optional_block("fin")? else { return Ok(None) };
    let fin = Fin {
        area: block.positive("area")? * length * length,
        arm: block.positive("arm")? * length,
        height: block.number("height")? * length,
    };
    block.finish()?;
    Ok(Some(fin))
}

fn read_validity(file: &mut Block<'_>, mach: f64, cl: f64) -> Result<(Validity, String), ContentError> {
    let mut block = file.block("validity")?;
    let [mach_min, mach_max] = block.row::<2>("mach")?;
    if !(mach_min..=mach_max).contains(&mach) {
        let text = format!("expected two numbers around the flight's own Mach number {mach:.3}");
        return Err(block.error("mach", text));
    }
    let cl_max = block.positive("CL_max")?;
    if cl > cl_max {
        return Err(block.error("CL_max", format_args!("expected more than the flight's own C_L {cl}")));
    }
    let source = block.text("source")?;
    block.finish()?;
    Ok((Validity { cl_max, mach_min, mach_max }, source))
}

/// Each number of a table of fields, times its factor to SI.
fn read_fields<T: 'static>(
    block: &mut Block<'_>,
    into: &mut T,
    fields: impl Iterator<Item = (Field<T>, f64)>,
) -> Result<(), ContentError> {
    for (field, factor) in fields {
        let number = if field.required {
            block.number(field.key)?
        } else {
            block.optional_number(field.key)?.unwrap_or(0.0)
        };
        *(field.of)(into) = number * factor;
    }
    Ok(())
}

/// An aircraft from dimensional derivatives: the airframe is only for the product of inertia and for drawing.
pub(super) fn derivative_model(
    file: &mut Block<'_>,
    units: UnitSystem,
    longitudinal: &mut Block<'_>,
    lateral: Option<&mut Block<'_>>,
) -> Result<(AircraftModel, Particulars, Vec<String>), ContentError> {
    let axes = file.choice("axes", &AXES)?;
    let flight = read_flight(file, units)?;
    let FlightCondition { altitude, speed, gamma0 } = flight.condition;
    let length = units.length();
    let mut block = file.block("airframe")?;
    let particulars = Particulars {
        mass: read_mass(&mut block, units, flight.gravity)?,
        wing_area: block.optional_positive("S")?.map(|area| area * length * length),
        span: block.optional_positive("b")?.map(|span| span * length),
        chord: block.optional_positive("c")?.map(|chord| chord * length),
        speed: Some(speed),
        altitude: Some(altitude),
        mach: flight.mach,
    };
    let iy = block.optional_positive("Iy")?.map(|iy| iy * units.inertia());
    let inertia = read_inertia(&mut block, units)?;
    let mut notes = Vec::from_iter(block.optional_text("source")?);
    block.finish()?;
    // Turn the inertia into the axes of the derivatives.
    let inertia = inertia.map(|(inertia, given)| match (given, axes) {
        (InertiaAxes::Body, Axes::Stability) => inertia.in_axes_at(flight.alpha0),
        (InertiaAxes::Stability, Axes::Body) => inertia.in_axes_at(-flight.alpha0),
        _ => inertia,
    });

    let mut d = LongitudinalDerivatives::default();
    read_fields(
        longitudinal,
        &mut d,
        LONGITUDINAL_DERIVATIVES.iter().map(|row| (row.field, length.powi(row.length_power))),
    )?;
    let alpha0 = if axes == Axes::Body { flight.alpha0 } else { 0.0 };
    if !longitudinal.has("Xdt") {
        // Nothing is known of the engine: δt is then the change of T/W, along the x axis.
        d.x_dt = flight.gravity;
    }
    let lateral = lateral
        .map(|block| {
            let senses = Senses::read(block)?;
            let d = read_lateral(block, length, speed, inertia, &senses)?;
            notes.extend(senses.remarks);
            Ok(d)
        })
        .transpose()?;
    let trim = Trim { speed, alpha0, gamma0, gravity: flight.gravity };
    let inertia = inertia.zip(iy).map(|(PlanarInertia { ix, iz, ixz }, iy)| Inertia { ix, iy, iz, ixz });
    let aircraft_model = DerivativeModel { trim, inertia, longitudinal: Some(d), lateral };
    Ok((AircraftModel::Derivatives(aircraft_model), particulars, notes))
}

/// Ix, Iz and Ixz with their axes: all or none.
fn read_inertia(
    block: &mut Block<'_>,
    units: UnitSystem,
) -> Result<Option<(PlanarInertia, InertiaAxes)>, ContentError> {
    let unit = units.inertia();
    if !block.has("Ixz") {
        block.optional_positive("Ix")?;
        block.optional_positive("Iz")?;
        return Ok(None);
    }
    let inertia = PlanarInertia {
        ix: block.positive("Ix")? * unit,
        iz: block.positive("Iz")? * unit,
        ixz: block.number("Ixz")? * unit,
    };
    let (limit, found) = ((inertia.ix * inertia.iz).sqrt() / unit, inertia.ixz / unit);
    if found.abs() < limit {
        Ok(Some((inertia, block.choice("inertia_axes", &INERTIA_AXES)?)))
    } else {
        Err(block.error("Ixz", format_args!("{found} is not below √(Ix Iz) = {limit:.4e}, as in any body")))
    }
}

/// Lateral derivatives: primed or not, by v or by β, side forces of controls with or without the star (Y* = Y/V).
fn read_lateral(
    block: &mut Block<'_>,
    length: f64,
    speed: f64,
    inertia: Option<PlanarInertia>,
    senses: &Senses,
) -> Result<LateralDerivatives, ContentError> {
    let is_primed = block.choice("form", &[("primed", true), ("unprimed", false)])?;
    let mut d = LateralDerivatives::default();
    for row in &LATERAL_DERIVATIVES {
        // L_v = L_β/V,  Y = Y* V: the key of the other form, its power of length, and the power of V to come back
        let other = match row.field.key {
            "Lv" => Some(("Lbeta", 0, -1)),
            "Nv" => Some(("Nbeta", 0, -1)),
            "Yda" => Some(("Yda_star", 0, 1)),
            "Ydr" => Some(("Ydr_star", 0, 1)),
            _ => None,
        };
        let (key, length_power, speed_power) = match other {
            Some(other) if block.has(other.0) => other,
            _ => (row.field.key, row.length_power, 0),
        };
        let factor = length.powi(length_power) * speed.powi(speed_power) * senses.factor(key);
        let field = Field { key, ..row.field };
        read_fields(block, &mut d, std::iter::once((field, factor)))?;
    }
    match inertia {
        Some(inertia) => {
            d.ixz_over_ix = inertia.ixz / inertia.ix;
            d.ixz_over_iz = inertia.ixz / inertia.iz;
        }
        None if is_primed => {}
        None => {
            return Err(block.error("form", "unprimed derivatives need Ix, Iz and Ixz in [airframe]"));
        }
    }
    Ok(if is_primed { LateralDerivatives::from_primed(&d) } else { d })
}
