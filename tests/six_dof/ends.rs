//! How far a flight goes: through the vertical, to where its model ends, and whatever is done to it.

use eigenwing::flight::aircraft::aircraft_model::AircraftModel;
use eigenwing::flight::aircraft::condition::FlightCondition;
use eigenwing::flight::aircraft::edits::EditedModel;
use eigenwing::flight::aircraft::knobs::Knobs;
use eigenwing::flight::motion::aerodynamics::Controls;
use eigenwing::flight::motion::flight_path::{Excitation, FlightPath, Reason, Stop};
use eigenwing::flight::motion::response::TimeGrid;
use eigenwing::flight::motion::rigid_body::Attitude;
use eigenwing::flight::motion::six_dof::{SixDof, SixDofError, Wind};
use nalgebra::Vector4;
use proptest::prelude::*;

use super::{Entry, GRID, edited, from_rest, off, ready, studies};

#[test]
fn a_trim_at_the_stall_or_at_the_end_of_the_mach_numbers_can_be_flown() {
    let mut edited = edited("navion");
    let AircraftModel::Coefficients(aircraft_model) = &mut edited.aircraft_model else {
        panic!("it starts from coefficients")
    };
    aircraft_model.validity.cl_max = aircraft_model.coefficients.longitudinal.cl;
    aircraft_model.validity.mach_max = aircraft_model.reference.mach();
    let path = ready(&edited).fly(&from_rest(), GRID);
    assert_eq!((path.stop, path.samples.len()), (None, 121));
}

#[test]
fn flight_goes_on_through_the_vertical_and_upside_down() {
    let flight = ready(&edited("a4d"));
    // almost straight up, and pulling
    let pull = |_: f64| Controls { elevator: -0.05, ..Controls::default() };
    let climbing = Excitation { controls: &pull, ..off([0.0, 0.0, 0.0, 1.3], [0.0; 4]) };
    let path = flight.fly(&climbing, TimeGrid { duration: 2.0, steps: 200 });
    let over = path.samples.iter().map(|s| s.euler[0].abs()).fold(0.0, f64::max);
    assert!(over > 3.0, "the bank beyond the vertical is 180°, {over}, {:?}", path.stop);
    assert!(path.samples.len() > 100, "{:?}", path.stop);
    // a whole roll
    let aileron = |_: f64| Controls { aileron: 0.05, ..Controls::default() };
    let excitation = Excitation { controls: &aileron, ..from_rest() };
    let path = flight.fly(&excitation, TimeGrid { duration: 8.0, steps: 800 });
    let bank: Vec<f64> = path.samples.iter().map(|s| s.euler[0]).collect();
    let turns = bank.windows(2).filter(|pair| (pair[1] - pair[0]).abs() > 3.0).count();
    assert!(turns >= 1, "{:?}, {:?}", path.stop, bank.last());
    for sample in &path.samples {
        assert!((sample.attitude.square() - 1.0).abs() < 1e-12);
    }
}

fn stop(path: FlightPath) -> Stop {
    path.stop.expect("it stops")
}

#[test]
fn a_flight_stops_with_a_sentence_where_the_model_ends() {
    let flight = ready(&edited("navion"));
    let grid = TimeGrid { duration: 60.0, steps: 600 };
    // C_L 1.4 at the stall, 0.41 in the trim, 4.44 a radian: 12.8° above the trim
    let stalled = stop(Entry::Elevator.fly(&flight, -0.3, grid));
    let Reason::AngleOfAttack(alpha) = stalled.reason else { panic!("{stalled}") };
    assert!((alpha - (1.4 - 0.41) / 4.44).abs() < 1e-8, "{alpha}");
    let text = stalled.to_string();
    assert!(text.contains("the angle of attack is 12.8° above the trim’s"), "{text}");
    assert!(stalled.time > 1.0 && stalled.time < 2.0);

    // A gust is felt at once.
    let blown = stop(Entry::SideWind.fly(&flight, 25.0, grid));
    assert_eq!(blown.time, 1.0);
    assert!(matches!(blown.reason, Reason::Sideslip(beta) if beta < 0.0), "{blown}");
    assert!(blown.to_string().contains("to the left"), "{blown}");

    // 0.158 in the trim, 0.3 where the coefficients end
    let diving = |_: f64| Controls { throttle: 0.6, ..Controls::default() };
    let dive = Excitation { controls: &diving, ..off([0.0, 0.0, 0.0, -0.5], [0.0; 4]) };
    let fast = stop(flight.fly(&dive, grid));
    assert!(matches!(fast.reason, Reason::Mach(mach) if (mach - 0.3).abs() < 1e-8), "{fast}");

    // Derivatives: half the trim speed away.
    let flight = ready(&edited("navion-nelson"));
    let slow = stop(flight.fly(&off([-30.0, 0.0, 0.0, 0.0], [0.0; 4]), grid));
    assert!(matches!(slow.reason, Reason::Airspeed(_)), "{slow}");
    assert_eq!(slow.time, 0.0);
}

#[test]
fn samples_end_where_the_flight_stops() {
    let flight = ready(&edited("navion"));
    let path = Entry::Elevator.fly(&flight, -0.3, TimeGrid { duration: 60.0, steps: 6000 });
    let time = stop(path.clone()).time;
    let last = (path.samples.len() - 1) as f64 * path.dt;
    assert!(last <= time && time < last + 1.001 * path.dt, "{last}, {time}");
    for sample in &path.samples {
        assert!(sample.alpha <= flight.limits.alpha[1] + 1e-8);
    }
}

/// Where the edges are and how dense the samples are changes nothing.
#[test]
fn samples_and_edges_do_not_move_the_flight() {
    let flight = ready(&edited("navion"));
    let controls = |_: f64| Controls { elevator: -0.01, aileron: 0.01, ..Controls::default() };
    let fly = |edges: &[f64], steps: usize| {
        let excitation = Excitation { controls: &controls, edges, ..from_rest() };
        flight.fly(&excitation, TimeGrid { duration: 5.0, steps }).samples.pop().expect("a sample")
    };
    let one = fly(&[], 1);
    for (edges, steps) in [(&[][..], 1000), (&[f64::NAN, 3.0, -1.0, 1.234, 3.0, 7.0][..], 7)] {
        let other = fly(edges, steps);
        assert!((one.longitudinal - other.longitudinal).amax() < 1e-6);
        assert!((one.lateral - other.lateral).amax() < 1e-6);
    }
}

#[test]
fn what_cannot_be_flown_says_so() {
    assert_eq!(SixDof::new(&edited("lesson")), Err(SixDofError::Matrices));
    assert!(SixDofError::Matrices.to_string().contains("small disturbances only"));
    let mut steep = edited("navion-nelson");
    let AircraftModel::Derivatives(aircraft_model) = &mut steep.aircraft_model else {
        panic!("it starts from derivatives")
    };
    aircraft_model.trim.gamma0 = 1.55;
    assert!(matches!(SixDof::new(&steep), Err(SixDofError::Trim { .. })));
    let mut heavy = edited("navion");
    let AircraftModel::Coefficients(aircraft_model) = &mut heavy.aircraft_model else {
        panic!("it starts from coefficients")
    };
    aircraft_model.condition.speed = 20.0;
    assert!(matches!(SixDof::new(&heavy), Err(SixDofError::AircraftModel(_))));
    let mut without = edited("a4d");
    let AircraftModel::Derivatives(aircraft_model) = &mut without.aircraft_model else {
        panic!("it starts from derivatives")
    };
    aircraft_model.inertia = None;
    assert_eq!(SixDof::new(&without), Err(SixDofError::NoInertia));
}

#[test]
fn without_lateral_data_it_flies_in_its_plane_and_not_out_of_it() {
    let mut flat = edited("navion");
    let AircraftModel::Coefficients(aircraft_model) = &mut flat.aircraft_model else {
        panic!("it starts from coefficients")
    };
    aircraft_model.coefficients.lateral = None;
    let flight = ready(&flat);
    assert_eq!(Entry::Elevator.fly(&flight, -0.01, GRID).stop, None);
    for entry in [Entry::Aileron, Entry::Rudder, Entry::SideWind] {
        let stopped = stop(entry.fly(&flight, 0.01, GRID));
        assert_eq!((stopped.time, stopped.reason), (1.0, Reason::NoLateralData), "{entry:?}");
    }
}

#[test]
fn inputs_that_are_no_numbers_stop_the_flight() {
    let flight = ready(&edited("navion"));
    for bad in [f64::NAN, f64::INFINITY] {
        for entry in Entry::ALL {
            let stopped = stop(entry.fly(&flight, bad, GRID));
            assert_eq!((stopped.time, stopped.reason), (1.0, Reason::Input), "{entry:?}");
        }
    }
    for duration in [f64::NAN, 0.0, -1.0, f64::INFINITY] {
        let path = flight.fly(&from_rest(), TimeGrid { duration, steps: 10 });
        assert_eq!((path.samples.len(), path.dt), (1, 0.0));
    }
}

fn is_finite(path: &FlightPath) -> bool {
    path.samples.iter().all(|s| {
        let Attitude { w, x, y, z } = s.attitude;
        let rest = [w, x, y, z, s.alpha, s.beta, s.airspeed, s.n_z, s.n_y];
        let all = s.longitudinal.iter().chain(&s.lateral).chain(&s.euler).chain(&s.position).chain(&rest);
        all.copied().all(f64::is_finite)
    }) && path.stop.is_none_or(|stop| stop.time.is_finite() && !stop.to_string().contains("NaN"))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    /// No piece is too short and no end is missed by rounding.
    #[test]
    fn every_flight_reaches_its_end(
        duration in 1e-9..20.0_f64,
        steps in 1..50_usize,
        edges in prop::collection::vec(0.0..20.0_f64, 0..6),
    ) {
        let path = ready(&edited("navion")).fly(&Excitation { edges: &edges, ..from_rest() }, TimeGrid { duration, steps });
        prop_assert_eq!(path.stop, None);
        prop_assert_eq!(path.samples.len(), steps + 1);
    }

    /// Whatever is turned and done: finite numbers, or a sentence.
    #[test]
    fn every_flight_is_finite(
        which in 0..18_usize,
        knobs in prop::array::uniform4(0.3..3.0_f64),
        cg_shift in -0.5..0.5_f64,
        (altitude, speed, gamma0) in (0.0..12e3_f64, 0.7..1.4_f64, -0.8..0.8_f64),
        entries in prop::array::uniform12(-30.0..30.0_f64),
        gain in prop::sample::select(vec![0.0, 1e-3, 1.0, 1e3, 1e8]),
        controls in prop::array::uniform4(-1.0..1.0_f64),
        wind in prop::array::uniform3(-20.0..20.0_f64),
        from in prop::array::uniform8(-1.0..1.0_f64),
    ) {
        let all = studies();
        let mut edited = EditedModel::new(all[which % all.len()].1.clone());
        if let AircraftModel::Coefficients(aircraft_model) = &mut edited.aircraft_model {
            let [mass_ratio, ix_ratio, iy_ratio, iz_ratio] = knobs;
            aircraft_model.knobs = Knobs { mass_ratio, ix_ratio, iy_ratio, iz_ratio, cg_shift, ..Knobs::default() };
            let speed = aircraft_model.condition.speed * speed;
            aircraft_model.condition = FlightCondition { altitude, speed, gamma0 };
        }
        for (k, entry) in entries.into_iter().enumerate() {
            edited.offsets.matrices.longitudinal.a[k] = gain * entry;
            edited.offsets.matrices.lateral.a[k] = gain * entry;
        }
        let Ok(flight) = SixDof::new(&edited) else { return Ok(()) };
        let [elevator, throttle, aileron, rudder] = controls;
        let moved = |t: f64| Controls { elevator: elevator * t.sin(), throttle, aileron, rudder };
        let blowing = |t: f64| Wind {
            velocity: wind.map(|w| w * (0.7 * t).cos()),
            rate: wind.map(|w| -0.7 * w * (0.7 * t).sin()),
        };
        let [u, w, q, theta, v, p, r, phi] = from;
        let excitation = Excitation {
            controls: &moved,
            wind: &blowing,
            edges: &[2.0],
            longitudinal: Vector4::new(u, w, q, theta),
            lateral: Vector4::new(v, p, r, phi),
            heading: 0.0,
            position: [0.0; 3],
        servos: None,
        };
        let path = flight.fly(&excitation, TimeGrid { duration: 10.0, steps: 50 });
        prop_assert!(is_finite(&path), "{:?}", path.stop);
        prop_assert!(path.stop.is_some() || path.samples.len() == 51);
    }
}
