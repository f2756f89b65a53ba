//! Motions and frequency responses as other programs read them: that parts add up, that figures are those of the motion, that
//! what is flown without linearising is the same where it is small, and that gain and phase are those of the motion.

use eigenwing::content::MatrixFormat;
use eigenwing::export::{
    ExportError, FlightOutcome, FrequencyReport, FrequencyRequest, ModeReport, PlaneOutcome, ResponseReport,
    ResponseRequest, Signal, Source, SplitOutcome, Subject, analyse, json, list, respond,
};
use serde_json::Value;

/// The motion of an aircraft with parameters set.
fn motion(key: &str, set: &[(&str, f64)], request: &ResponseRequest) -> ResponseReport {
    let set = set.iter().map(|&(key, value)| (key.to_owned(), value)).collect();
    let scene = Subject { set, ..Subject::listed(key) }.scene().expect("an aircraft of the list");
    respond(&scene, request).expect("a motion")
}

fn frequency(subject: &Subject, request: &FrequencyRequest) -> Result<FrequencyReport, ExportError> {
    eigenwing::export::frequency(&subject.scene()?, request)
}

fn disturbed_by(disturbance: &str, shape: &str) -> ResponseRequest {
    ResponseRequest {
        disturbance: Some(disturbance.to_owned()),
        shape: Some(shape.to_owned()),
        ..ResponseRequest::default()
    }
}

fn values<'a>(signals: &'a [Signal], name: &str) -> &'a [f64] {
    &signals.iter().find(|signal| signal.name == name).expect("a signal of this name").values
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most, x| x.abs().max(most))
}

/// A number that is none would be written as null.
fn has_null(value: &Value) -> bool {
    match value {
        Value::Null => true,
        Value::Array(list) => list.iter().any(has_null),
        Value::Object(fields) => fields.values().any(has_null),
        _ => false,
    }
}

#[test]
fn the_parts_of_the_modes_and_the_rest_add_up_to_each_output() {
    for (key, disturbance, shape) in
        [("navion", "elevator", "doublet"), ("navion", "side-gust", "1-cosine"), ("x15", "rudder", "3-2-1-1")]
    {
        let request = ResponseRequest { split: Some(true), ..disturbed_by(disturbance, shape) };
        let report = motion(key, &[("time", 10.0)], &request);
        let splits = report.split.as_deref().expect("a split was asked for");
        assert_eq!(splits.len(), report.outputs.len());
        for (signal, split) in report.outputs.iter().zip(splits) {
            let split = split.split().expect("modes that can be told apart");
            assert_eq!((split.name, split.unit), (signal.name, signal.unit));
            let parts = split.parts.iter().map(|part| &part.values[..]);
            let all: Vec<&[f64]> = parts.chain([&split.rest[..]]).collect();
            let size = all.iter().map(|part| largest(part)).fold(0.0, f64::max);
            for (k, whole) in signal.values.iter().enumerate() {
                let sum: f64 = all.iter().map(|part| part[k]).sum();
                // Rounding of the parts, some of which are larger than what they add up to.
                assert!((sum - whole).abs() <= 1e-14 * size, "{key} {}: {sum} and {whole}", signal.name);
            }
        }
    }
}

#[test]
fn an_output_without_a_split_says_why_and_leaves_the_others_alone() {
    // det A = g (Z_u M_w − Z_w M_u) is zero without Z_u and M_u: a mode at zero, whose part in the path is like drift.
    let request = ResponseRequest { split: Some(true), ..ResponseRequest::default() };
    let report = motion("lesson", &[("a_wu", 0.0), ("a_qu", 0.0), ("time", 5.0)], &request);
    for split in report.split.as_deref().expect("a split was asked for") {
        match split {
            SplitOutcome::Refused { name, error } => {
                assert!(["h", "x"].contains(name), "{name}");
                assert!(error.contains("neither dies away nor grows"), "{error}");
            }
            SplitOutcome::Split(split) => assert!(!["h", "x"].contains(&split.name)),
        }
    }
}

#[test]
fn a_small_disturbance_flown_without_linearising_is_the_linear_motion() {
    for name in ["elevator", "rudder"] {
        let request = ResponseRequest { nonlinear: Some(true), ..disturbed_by(name, "step") };
        let report = motion("navion", &[(name, 1e-4), ("time", 5.0)], &request);
        let flight = report.nonlinear.as_ref().and_then(FlightOutcome::flight).expect("a flight");
        assert_eq!((&flight.time, &flight.stop), (&report.time, &None));
        for (linear, flown) in report.outputs.iter().zip(&flight.outputs) {
            assert_eq!((linear.name, linear.unit), (flown.name, flown.unit));
            let size = largest(&linear.values);
            let away = linear.values.iter().zip(&flown.values).map(|(a, b)| (a - b).abs());
            let away = away.fold(0.0, f64::max);
            // Of second order: the square of angles below 10⁻³ rad, some of it gathered along the path.
            assert!(away < 2e-3 * size, "{name} {}: {away} of {size}", linear.name);
        }
    }
}

#[test]
fn a_flight_that_stops_ends_with_a_sentence_and_before_its_next_sample() {
    let request = ResponseRequest { nonlinear: Some(true), steps: Some(60), ..ResponseRequest::default() };
    let report = motion("navion", &[("elevator", -0.25), ("time", 6.0)], &request);
    let flight = report.nonlinear.as_ref().and_then(FlightOutcome::flight).expect("a flight");
    let stop = flight.stop.as_ref().expect("the wing stalls");
    assert!(stop.sentence.contains("the angle of attack is"), "{}", stop.sentence);
    let last = *flight.time.last().expect("samples");
    assert!(last <= stop.time && stop.time <= last + 0.1 + 1e-9, "{last} and {}", stop.time);
    assert!(flight.outputs.iter().all(|signal| signal.values.len() == flight.time.len()));
    assert_eq!(report.time.len(), 61);
}

#[test]
fn the_page_on_javascript_tells_the_motion_of_its_example() {
    let page = include_str!("../docs/JAVASCRIPT.md");
    let request =
        ResponseRequest { nonlinear: Some(true), split: Some(true), ..disturbed_by("elevator", "step") };
    let report = motion("navion", &[("elevator", -0.25)], &request);
    let peak = report.metrics.peak_load_factor.expect("a peak");
    let told =
        format!("// {{ value, time }}: {:.2} g more, {:.2} s after the step", peak.value, peak.time - 1.0);
    assert!(page.contains(&told), "{told}");
    let flight = report.nonlinear.as_ref().and_then(FlightOutcome::flight).expect("a flight");
    let sentence = &flight.stop.as_ref().expect("the wing stalls").sentence;
    let told = sentence.split(" the trim’s").next().expect("a beginning");
    assert!(page.contains(&format!("// {told} …")), "{told}");
    let request = FrequencyRequest { from: Some(0.01), to: Some(100.0), ..of_output("q") };
    let bode = frequency(&Subject::listed("navion"), &request).expect("a response");
    let modes: Vec<&str> = bode.peaks.iter().map(|peak| peak.mode).collect();
    assert!(page.contains(&format!("rad/s`)); // {}", modes.join(", "))), "{modes:?}");
}

#[test]
fn what_cannot_be_flown_says_so_and_still_moves() {
    let file = include_str!("data/matrices/lateral.csv").to_owned();
    let source = Source::Matrices { file: "lateral.csv".to_owned(), text: file, format: MatrixFormat::Csv };
    let request = ResponseRequest { nonlinear: Some(true), ..ResponseRequest::default() };
    let scene = Subject { source, ..Subject::listed("") }.scene().expect("bare matrices");
    let report = respond(&scene, &request).expect("a linear motion");
    let Some(FlightOutcome::Refused { error }) = &report.nonlinear else { panic!("{:?}", report.nonlinear) };
    assert!(error.starts_with("this aircraft is given by its matrices"), "{error}");
    assert!(largest(values(&report.outputs, "phi")) > 0.0);
}

#[test]
fn every_aircraft_is_split_and_flown_in_numbers_or_says_why_not() {
    for aircraft in list() {
        for plane in &aircraft.planes {
            let request = ResponseRequest {
                plane: Some((*plane).to_owned()),
                steps: Some(20),
                nonlinear: Some(true),
                split: Some(true),
                ..ResponseRequest::default()
            };
            let report = motion(&aircraft.key, &[("time", 4.0)], &request);
            let mut told = vec![serde_json::to_value(&report.split).expect("JSON")];
            if let Some(FlightOutcome::Flown(flight)) = &report.nonlinear {
                told.push(serde_json::to_value((&flight.time, &flight.outputs)).expect("JSON"));
                assert!(flight.stop.is_some() || flight.time == report.time, "{}", aircraft.key);
            }
            assert!(!told.iter().any(has_null), "{} {plane}", aircraft.key);
        }
    }
}

#[test]
fn metrics_do_not_depend_on_how_many_samples_are_asked_for() {
    let request = |steps| ResponseRequest { steps: Some(steps), ..ResponseRequest::default() };
    let [few, many] = [3, 1200].map(|steps| motion("navion", &[], &request(steps)));
    assert_eq!(few.metrics, many.metrics);
    assert_eq!((few.time.len(), many.time.len()), (4, 1201));
}

fn phugoid(key: &str) -> ModeReport {
    let scene = Subject::listed(key).scene().expect("an aircraft of the list");
    let report = analyse(&scene).expect("an analysis");
    let modes = &report.longitudinal.as_ref().and_then(PlaneOutcome::report).expect("its plane").modes;
    modes.iter().find(|mode| mode.key == "phugoid").expect("a phugoid").clone()
}

#[test]
fn a_peak_is_beside_the_largest_sample_and_a_steady_value_is_where_a_long_motion_ends() {
    let request = ResponseRequest { steps: Some(2400), ..disturbed_by("elevator", "step") };
    let report = motion("navion", &[("time", 300.0)], &request);
    let left = 2_f64.powf(-299.0 / phugoid("navion").time_to_half.expect("it dies away"));
    for (signal, metrics) in report.outputs.iter().zip(&report.metrics.outputs) {
        assert_eq!((signal.name, signal.unit), (metrics.name, metrics.unit));
        let peak = metrics.peak.expect("a peak");
        let size = largest(&signal.values);
        // Exact between the samples: none is beyond it, and the short period's curve bends by a fiftieth in an eighth of a second.
        assert!(peak.value.abs() >= size * (1.0 - 1e-9), "{}", signal.name);
        let beside = signal.values[(peak.time / 0.125).round() as usize];
        assert!((beside - peak.value).abs() <= 0.02 * size, "{}: {beside} {}", signal.name, peak.value);
        let is_of_path = ["h", "x"].contains(&signal.name);
        assert_eq!(metrics.steady.is_none(), is_of_path, "{}", signal.name);
        if let Some(steady) = metrics.steady {
            // What is left of the phugoid after 299 s; it begins no larger than twice the peak.
            let last = signal.values.last().expect("samples");
            assert!((last - steady).abs() < 2.0 * left * size, "{}: {last} and {steady}", signal.name);
        }
    }
    assert!(report.metrics.control_anticipation.is_some() && report.metrics.phugoid_swing.is_some());
    assert_eq!(report.metrics.time_to_bank, None);
}

#[test]
fn turbulence_has_no_first_swing() {
    let request =
        ResponseRequest { disturbance: Some("turbulence".to_owned()), ..ResponseRequest::default() };
    let metrics = motion("navion", &[], &request).metrics;
    assert_eq!(metrics.phugoid_swing, None);
    assert!(metrics.peak_load_factor.is_some());
}

#[test]
fn the_time_to_bank_is_when_the_bank_angle_is_30_degrees() {
    let request = ResponseRequest { steps: Some(1200), ..disturbed_by("aileron", "step") };
    let report = motion("navion", &[("aileron", 0.1), ("time", 6.0)], &request);
    let time = report.metrics.time_to_bank.expect("an aileron that banks") + report.metrics.start;
    let bank = values(&report.outputs, "phi");
    let position = time / 0.005;
    let k = position.floor() as usize;
    let at = bank[k] + position.fract() * (bank[k + 1] - bank[k]);
    // The chord of five milliseconds is 2·10⁻⁷ off the curve.
    assert!((at.abs() - std::f64::consts::FRAC_PI_6).abs() < 1e-6, "{at}");
    // Let go at 0.7 rad of bank it is beyond from the beginning.
    let request = ResponseRequest {
        plane: Some("lateral".to_owned()),
        disturbance: Some("release".to_owned()),
        ..ResponseRequest::default()
    };
    let released = motion("navion", &[("from_phi", 0.7)], &request);
    assert_eq!((released.metrics.start, released.metrics.time_to_bank), (0.0, Some(0.0)));
}

fn of_output(output: &str) -> FrequencyRequest {
    FrequencyRequest { output: Some(output.to_owned()), ..FrequencyRequest::default() }
}

#[test]
fn at_low_frequency_the_gain_is_the_steady_value_for_one_of_the_input() {
    let step = motion("navion", &[("elevator", 0.01)], &disturbed_by("elevator", "step"));
    for name in ["u", "alpha", "theta"] {
        let request =
            FrequencyRequest { from: Some(1e-5), to: Some(1e-4), points: Some(2), ..of_output(name) };
        let bode = frequency(&Subject::listed("navion"), &request).expect("a frequency response");
        let metrics = step.metrics.outputs.iter().find(|of| of.name == name).expect("an output");
        let gain = metrics.steady.expect("a steady value") / 0.01;
        // 10⁻⁵ rad/s beside a phugoid of 0.2: the gain differs by the square of their ratio, the phase by the ratio.
        assert!((bode.gain[0] - gain.abs()).abs() < 1e-6 * gain.abs(), "{name}: {} and {gain}", bode.gain[0]);
        let sign = bode.phase[0].cos();
        assert!((sign - gain.signum()).abs() < 1e-6, "{name}: {sign} and {gain}");
    }
}

#[test]
fn a_frequency_response_has_its_ends_its_peaks_and_its_turns_however_few_its_points() {
    let request = |points| FrequencyRequest {
        from: Some(0.01),
        to: Some(100.0),
        points: Some(points),
        ..of_output("h")
    };
    let bode = |points| frequency(&Subject::listed("b747-fc9"), &request(points)).expect("a response");
    let (few, many) = (bode(5), bode(4001));
    assert_eq!((few.frequency.len(), many.frequency.len()), (5, 4001));
    for (k, expected) in [0.01, 0.1, 1.0, 10.0, 100.0].iter().enumerate() {
        assert!((few.frequency[k] - expected).abs() < 1e-14 * expected);
        let same = 1000 * k;
        assert_eq!((few.gain[k], few.phase[k]), (many.gain[same], many.phase[same]));
    }
    let [few, many] = [few, many].map(|bode| bode.peaks);
    assert_eq!((few.len(), few[0].mode_key), (many.len(), "phugoid"));
    assert!((few[0].frequency / many[0].frequency - 1.0).abs() < 1e-6);
    // ωₙ √(1 − 2ζ²) of an oscillation alone; the slope of the rest of the response moves the peak by a little.
    let natural = phugoid("b747-fc9").natural_frequency.expect("it oscillates");
    assert!((few[0].frequency / natural - 1.0).abs() < 0.02, "{} and {natural}", few[0].frequency);
}

#[test]
fn every_output_of_every_aircraft_answers_in_numbers() {
    // Each output with one input or another: an unoptimised build takes its time.
    let longitudinal = ["u", "w", "alpha", "q", "theta", "gamma", "nz", "h", "x"].into_iter();
    let longitudinal =
        longitudinal.zip(["elevator", "throttle", "vertical-gust", "head-gust"].into_iter().cycle());
    let lateral = ["v", "beta", "p", "r", "phi", "ny", "psi", "y"].into_iter();
    let lateral = lateral.zip(["rudder", "aileron", "side-gust"].into_iter().cycle());
    let of_planes = longitudinal.map(|of| ("longitudinal", of)).chain(lateral.map(|of| ("lateral", of)));
    let of_planes: Vec<_> = of_planes.collect();
    for aircraft in list() {
        for &(plane, (output, input)) in &of_planes {
            let request = FrequencyRequest {
                disturbance: Some(input.to_owned()),
                points: Some(2),
                ..of_output(output)
            };
            let answer = frequency(&Subject::listed(&aircraft.key), &request);
            assert_eq!(answer.is_ok(), aircraft.planes.contains(&plane), "{} {answer:?}", aircraft.key);
            let Ok(answer) = answer else { continue };
            assert_eq!((answer.plane, answer.output.name), (plane, output));
            let told = (&answer.frequency, &answer.gain, &answer.phase, &answer.peaks);
            assert!(!has_null(&serde_json::to_value(told).expect("JSON")), "{} {output}", aircraft.key);
        }
    }
}

#[test]
fn a_frequency_response_asked_for_in_json_is_the_same() {
    let told = json::frequency(r#"{"aircraft": "navion", "output": "beta", "points": 2}"#);
    let request = FrequencyRequest { points: Some(2), ..of_output("beta") };
    let report = frequency(&Subject::listed("navion"), &request).expect("a response");
    assert_eq!((report.plane, report.disturbance, report.input.name), ("lateral", "rudder", "rudder"));
    assert_eq!(told, Ok(serde_json::to_string(&report).expect("JSON")));
}

/// Far elevator takes the Navion to a steady speed that the linear model gives but doesn't hold for.
#[test]
fn a_steady_value_beyond_the_linear_model_is_not_told() {
    let report = |elevator: f64| {
        let subject = Subject { set: vec![("elevator".to_owned(), elevator)], ..Subject::listed("navion") };
        let request = ResponseRequest { shape: Some("step".to_owned()), ..ResponseRequest::default() };
        respond(&subject.scene().expect("an aircraft"), &request).expect("a motion").metrics
    };
    let (near, far) = (report(0.01), report(-0.25));
    assert!(!near.steady_is_beyond && near.outputs[0].steady.is_some());
    assert!(far.steady_is_beyond && far.outputs.iter().all(|of| of.steady.is_none()), "{far:?}");
}

/// Air that stays carries the aircraft along: rising air against z, air from ahead against x, air to the right along y.
#[test]
fn moving_air_counts_in_the_sense_of_its_parameter() {
    for (air, key, input, output, along) in [
        ("vertical-gust", "gust", "w_gust", "w", -1.0),
        ("head-gust", "head_gust", "u_gust", "u", -1.0),
        ("side-gust", "side_gust", "v_gust", "v", 1.0),
    ] {
        let told = motion("navion", &[(key, 2.0)], &disturbed_by(air, "step"));
        assert_eq!(values(&told.inputs, input).last(), Some(&2.0), "{air}");
        let request = FrequencyRequest {
            disturbance: Some(air.to_owned()),
            from: Some(1e-4),
            to: Some(2e-4),
            points: Some(2),
            ..of_output(output)
        };
        let bode = frequency(&Subject::listed("navion"), &request).expect("a frequency response");
        assert!((bode.phase[0].cos() - along).abs() < 0.02, "{air}: {}", bode.phase[0]);
        assert!(bode.phase[0].abs() <= std::f64::consts::PI, "{air}: {}", bode.phase[0]);
    }
}

#[test]
fn the_moment_from_which_a_motion_is_no_longer_small_is_told_with_its_limit() {
    let request = disturbed_by("elevator", "step");
    let report = motion("navion", &[("elevator", -0.02), ("cm_alpha", 0.5)], &request);
    let end = report.small_until.expect("it diverges");
    let limit = report.small_limit.as_deref().expect("the limit");
    assert!(limit.starts_with(&format!("After {end:.2} s")) && limit.contains(" is more than "), "{limit}");
    assert!(report.time.last().is_some_and(|last| *last > end), "the samples go on");
    let calm = motion("navion", &[], &request);
    assert_eq!((calm.small_until, calm.small_limit), (None, None));
}
