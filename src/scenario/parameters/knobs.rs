//! The knobs: centre of gravity, mass, flight condition, tail, fin, dihedral and inertia. What a beginner asks for comes first.

use super::{Extent, Group, Page, Parameter, Place};
use crate::flight::aircraft::plane::Plane;
use crate::scenario::Dimension;

pub(super) const ROWS: [Parameter; 11] = [
    Parameter {
        key: "cg",
        symbol: "Δx_{cg}/c",
        name: "shift of the centre of gravity",
        page: Some(Page::Coefficients),
        plane: None,
        group: Group::Aircraft,
        dimension: Dimension::Percent,
        meaning: "How far the centre of gravity lies behind that of the reference, in mean chords. It moves \
            C_mα, C_mq, C_mα̇, C_mM, C_mδe and C_Lq, and by less C_nβ, C_np, C_nr, C_nδa, C_nδr, C_Yr and \
            C_lr.",
        sign: "Positive is aft and takes pitch stiffness away; aft of the neutral point the aircraft is \
            statically unstable.",
        origin: "C_mα = C_Lα (x_cg − x_n)/c, x_n the neutral point; forces and velocities carried to the new centre as by a rigid body. \
            Inertias stay.",
        place: Place::Knob(|k| &mut k.cg_shift),
        extent: Extent::Fixed { low: -0.3, high: 0.4 },
    },
    Parameter {
        key: "mass",
        symbol: "m/m_0",
        name: "mass",
        page: Some(Page::Coefficients),
        plane: None,
        group: Group::Aircraft,
        dimension: Dimension::Percent,
        meaning: "Mass over that of the reference. It divides every force derivative, X, Y and Z, and raises \
            the trim lift, with drag, C_Dα, C_lr and C_np after it.",
        sign: "Above 100 % is heavier: flown at a higher C_L, with less heave damping.",
        origin: "C_L = W cos γ₀/(½ρV²S). The moments of inertia have their own sliders.",
        place: Place::Knob(|k| &mut k.mass_ratio),
        extent: Extent::Fixed { low: 0.5, high: 2.0 },
    },
    Parameter {
        key: "speed",
        symbol: "V",
        name: "airspeed",
        page: Some(Page::Coefficients),
        plane: None,
        group: Group::Aircraft,
        dimension: Dimension::AirSpeed,
        meaning: "True airspeed. It moves every dimensional derivative through the dynamic pressure, the \
            Mach number, and the trim lift, with drag, C_Dα, C_lr and C_np after it.",
        sign: "Positive. Faster stiffens and speeds up the short period and the roll, and slows the phugoid \
            down.",
        origin: "C_L = W cos γ₀/(½ρV²S); drag grows with C_L².",
        place: Place::Condition(|c| &mut c.speed),
        extent: Extent::Relative { low: 0.5, high: 1.6, floor: 10.0 },
    },
    Parameter {
        key: "altitude",
        symbol: "h",
        name: "altitude",
        page: Some(Page::Coefficients),
        plane: None,
        group: Group::Aircraft,
        dimension: Dimension::Length,
        meaning: "Height in the standard atmosphere. It moves every dimensional derivative through the \
            density, the Mach number through the speed of sound, and the trim lift, with drag, C_Dα, C_lr \
            and C_np after it.",
        sign: "Higher is thinner air at the same true airspeed: less damping in every fast mode.",
        origin: "International standard atmosphere; C_L = W cos γ₀/(½ρV²S).",
        place: Place::Condition(|c| &mut c.altitude),
        extent: Extent::Fixed { low: 0.0, high: 13_000.0 },
    },
    Parameter {
        key: "tail",
        symbol: "S_t/S_{t0}",
        name: "size of the horizontal tail",
        page: Some(Page::Coefficients),
        plane: Some(Plane::Longitudinal),
        group: Group::Aircraft,
        dimension: Dimension::Percent,
        meaning: "Area of the horizontal tail over that of the reference, its arm the same. It moves C_Lα, \
            C_mα, C_Lα̇, C_mα̇, C_Lq, C_mq, and the elevator's C_Lδe, C_Dδe and C_mδe.",
        sign: "Larger stiffens and damps the short period; at 0 % the tail is gone, and with it the \
            elevator.",
        origin: "C_mα = −η a_t V_H (1 − dε/dα) and C_mq = −2.2 η a_t V_H l_t/c, the tail's part of each. \
            Its own mass and drag are left out.",
        place: Place::Knob(|k| &mut k.tail_ratio),
        extent: Extent::Fixed { low: 0.0, high: 2.0 },
    },
    Parameter {
        key: "fin",
        symbol: "S_v/S_{v0}",
        name: "size of the fin",
        page: Some(Page::Coefficients),
        plane: Some(Plane::Lateral),
        group: Group::Aircraft,
        dimension: Dimension::Percent,
        meaning: "Area of fin and rudder over that of the reference, arm and height the same. It moves every \
            coefficient by β, p and r, most of all C_nβ and C_nr, and the rudder's C_Yδr, C_lδr and C_nδr.",
        sign: "Larger stiffens and damps the Dutch roll, and often lets the spiral diverge; at 0 % the fin \
            is gone, and with it the rudder.",
        origin: "C_nβ = −(l_v/b) C_Yβv, C_lβ = (z_v/b) C_Yβv and C_nr = 2 (l_v/b)² C_Yβv, the fin's part of \
            each. Its own mass and drag are left out.",
        place: Place::Knob(|k| &mut k.fin_ratio),
        extent: Extent::Fixed { low: 0.0, high: 2.0 },
    },
    Parameter {
        key: "dihedral",
        symbol: "ΔΓ",
        name: "change of dihedral",
        page: Some(Page::Coefficients),
        plane: Some(Plane::Lateral),
        group: Group::Aircraft,
        dimension: Dimension::Angle,
        meaning: "How much further the wing tips are bent up than in the reference. It moves C_lβ, the \
            dihedral effect.",
        sign: "Positive is tips up: it steadies the spiral and takes damping from the Dutch roll.",
        origin: "C_lβ = −(C_Lα/6) (1 + 2 taper)/(1 + taper) Γ, strip theory of a tapered wing.",
        place: Place::Knob(|k| &mut k.dihedral_change),
        extent: Extent::Fixed { low: -0.175, high: 0.175 },
    },
    Parameter {
        key: "gamma",
        symbol: "γ_0",
        name: "flight-path angle",
        page: Some(Page::Coefficients),
        plane: None,
        group: Group::Aircraft,
        dimension: Dimension::Angle,
        meaning: "Angle of the steady flight path above the horizon. It moves the gravity terms g cos θ₀ and \
            g sin θ₀, and tan θ₀ of the lateral motion; by a little also the trim lift and the thrust in X_u \
            and M_u.",
        sign: "Positive climbs, negative descends.",
        origin: "C_L = W cos γ₀/(½ρV²S), and thrust T = D + W sin γ₀.",
        place: Place::Condition(|c| &mut c.gamma0),
        extent: Extent::Fixed { low: -0.26, high: 0.26 },
    },
    Parameter {
        key: "iy",
        symbol: "I_y/I_{y0}",
        name: "pitch inertia",
        page: Some(Page::Coefficients),
        plane: Some(Plane::Longitudinal),
        group: Group::Aircraft,
        dimension: Dimension::Percent,
        meaning: "Moment of inertia in pitch over that of the reference. It divides every M derivative.",
        sign: "Above 100 % is more mass in nose and tail: the short period is slower, and pitch damping \
            weaker.",
        origin: "Pitching moments over Iy.",
        place: Place::Knob(|k| &mut k.iy_ratio),
        extent: Extent::Fixed { low: 0.5, high: 2.0 },
    },
    Parameter {
        key: "ix",
        symbol: "I_x/I_{x0}",
        name: "roll inertia",
        page: Some(Page::Coefficients),
        plane: Some(Plane::Lateral),
        group: Group::Aircraft,
        dimension: Dimension::Percent,
        meaning: "Moment of inertia in roll over that of the reference. It divides every L derivative, and \
            through the product of inertia it moves L′ and N′ too.",
        sign: "Above 100 % is more mass in the wings: the roll mode is slower.",
        origin: "Rolling moments over Ix; the product of inertia stays.",
        place: Place::Knob(|k| &mut k.ix_ratio),
        extent: Extent::Fixed { low: 0.5, high: 2.0 },
    },
    Parameter {
        key: "iz",
        symbol: "I_z/I_{z0}",
        name: "yaw inertia",
        page: Some(Page::Coefficients),
        plane: Some(Plane::Lateral),
        group: Group::Aircraft,
        dimension: Dimension::Percent,
        meaning: "Moment of inertia in yaw over that of the reference. It divides every N derivative, and \
            through the product of inertia it moves L′ and N′ too.",
        sign: "Above 100 % is more mass far from the centre: the Dutch roll is slower.",
        origin: "Yawing moments over Iz; the product of inertia stays.",
        place: Place::Knob(|k| &mut k.iz_ratio),
        extent: Extent::Fixed { low: 0.5, high: 2.0 },
    },
];
