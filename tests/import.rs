//! Files as people have them, each read rightly, or told in a sentence what it lacks; what looks wrong is told with its number and,
//! where it is certain, with what mends it.

mod import_files;

use eigenwing::flight::aircraft::further::AppendedState;
use eigenwing::flight::aircraft::plane::Plane::{Lateral, Longitudinal};
use eigenwing::flight::aircraft::plane::PlaneModel;
use import_files::{doubt, doubts, model, open, poles, remedy, try_open};

/// The fills without which a file says too little.
fn fills(file: &str) -> &'static [&'static str] {
    match file {
        "10-mae275-lat-no-beta-B.csv" => &[],
        _ => &[],
    }
}

/// By numpy, of the matrices as they stand in the files.
#[test]
fn eigenvalues_are_those_of_the_matrices_in_each_file() {
    let table = String::from_utf8(import_files::bytes("expected.csv")).expect("a table");
    let mut checked = 0;
    for line in table.lines().skip(1) {
        let cells: Vec<&str> = line.split(',').collect();
        let [file, re, im, ..] = cells[..] else { panic!("{line}") };
        // Three states are no plane of motion.
        if file == "05-ctms-pitch.m" {
            continue;
        }
        let review = open(&[file], fills(file));
        let [re, im]: [f64; 2] = [re, im].map(|text| text.parse().expect("a number"));
        let plane = if model_exists(&review, Longitudinal) { Longitudinal } else { Lateral };
        let found = poles(&review, plane)
            .into_iter()
            .map(|pole| (pole.re - re).hypot(pole.im - im))
            .fold(f64::INFINITY, f64::min);
        // The table has six digits.
        assert!(found < 1e-5 * re.hypot(im).max(1e-3), "{line}: {found}");
        checked += 1;
    }
    assert_eq!(checked, 33);
}

fn model_exists(
    review: &eigenwing::content::import::review::Review,
    plane: eigenwing::flight::aircraft::plane::Plane,
) -> bool {
    import_files::aircraft(review).plane_notes[plane].is_some()
}

/// The same model in every disguise: of Excel, a spreadsheet, a PDF, two encodings, Fortran.
#[test]
fn separators_signs_encodings_and_exponents_change_no_number() {
    let expected = model(&open(&["14-tabs-from-a-sheet.csv"], &[]), Longitudinal);
    assert_eq!(expected.a[(0, 0)], -0.0451);
    for file in [
        "14-german-excel.csv",
        "15-minus-from-a-pdf.csv",
        "15-minus-from-a-pdf.m",
        "16-utf16.m",
        "16-windows-1252.m",
        "17-fortran-exponents.m",
    ] {
        let review = open(&[file], &[]);
        assert_eq!(model(&review, Longitudinal).a, expected.a, "{file}");
        assert_eq!(doubts(&review), [""; 0], "{file}");
    }
    assert_eq!(open(&["16-utf16.m"], &[]).remarks, ["The text is in UTF-16."]);
    assert_eq!(open(&["16-windows-1252.m"], &[]).remarks, ["The text is in Windows-1252."]);
}

#[test]
fn a_log_with_matrices_alone_is_read_under_any_name_and_asks_for_its_speed() {
    for file in ["01-xflr5-raw-log.txt", "01-xflr5-raw-log.m", "01-xflr5-raw-log.csv"] {
        let review = open(&[file], &[]);
        let missing: Vec<&str> =
            review.fields.iter().filter(|field| field.value.is_none()).map(|field| &*field.key).collect();
        assert_eq!(missing, ["speed"], "{file}");
        assert_eq!(review.eigenvalues.len(), 2, "{file}");
        let error = review.aircraft().expect_err("it waits").to_string();
        assert_eq!(
            error,
            format!("{file}, line 1: the file doesn’t say speed (true airspeed in m/s; perhaps 7.11515)")
        );
        let review = open(&[file], &["speed=8.57402"]);
        let (fast, slow) = (poles(&review, Longitudinal)[0], poles(&review, Longitudinal)[1]);
        assert!((fast.re + 20.8757).abs() < 1e-4 && (fast.im - 10.5738).abs() < 1e-4, "{fast}");
        assert!((slow.re + 0.0771261).abs() < 1e-6 && (slow.im - 0.889137).abs() < 1e-6, "{slow}");
        assert!((poles(&review, Lateral)[2].re + 0.0104324).abs() < 1e-7);
    }
}

#[test]
fn hundredths_of_a_radian_are_told_and_mended_when_asked() {
    for (file, mended) in [
        ("03-boyd747-crad.m", &["angles=crad"][..]),
        ("03-boyd747-crad-alpha.m", &["angles=crad", "states=u, w, q, theta"][..]),
    ] {
        let review = open(&[file], &[]);
        let doubt = doubt(&review, "angles");
        assert!(
            doubt.sentence.starts_with("A(u, θ) is −0.09815 m/s², where −g cos θ₀ is −9.807 m/s²"),
            "{}",
            doubt.sentence
        );
        assert_eq!(remedy(doubt), mended, "{file}");
        assert!(!doubt.stops);
        let review = open(&[file], mended);
        assert_eq!(doubts(&review), [""; 0], "{file}");
        // In radians, and in metres.
        let a = model(&review, Longitudinal).a;
        assert!(
            (a[(0, 3)] + 32.2 * 0.3048).abs() < 1e-12 && (a[(1, 2)] - 774.0 * 0.3048).abs() < 1e-10,
            "{a}"
        );
    }
}

#[test]
fn rates_may_be_called_by_what_they_turn_and_the_row_of_phi_says_the_pitch_angle() {
    let named = open(&["04-jet-transport-747-lat.m"], &[]);
    let lettered = open(&["04-jet-transport-747-lat-rp.m"], &[]);
    assert_eq!(model(&named, Lateral), model(&lettered, Lateral));
    let meaning =
        |name: &str| named.read.iter().find(|read| read.text == name).map(|read| read.meaning.as_str());
    assert_eq!([meaning("yaw"), meaning("roll")], [Some("yaw rate r"), Some("roll rate p")]);
    let found = doubt(&named, "pitch-angle");
    assert_eq!(
        found.sentence,
        "The row of φ says φ̇ = p + 0.08050 r, so the x axis is pitched up by θ₀ = 4.6°; the file says 0°. A(v, p) says 4.6°, too."
    );
    let mended = remedy(found);
    let mended: Vec<&str> = mended.iter().map(String::as_str).collect();
    assert_eq!(doubts(&open(&["04-jet-transport-747-lat.m"], &mended)), [""; 0]);
    assert_eq!(doubts(&open(&["04-jet-transport-747-lat-rp-alpha0.m"], &[])), [""; 0]);
}

#[test]
fn three_states_are_told_what_is_missing_and_of_the_factor_in_the_row_of_theta() {
    let error = open(&["05-ctms-pitch.m"], &[]).aircraft().expect_err("no plane of motion").to_string();
    assert_eq!(
        error,
        "05-ctms-pitch.m, line 6: There are 3 states, alpha, q, theta. A plane of motion has four: the speed u is missing. And the row \
         of θ says θ̇ = 56.7 q, where pitch rate is the rate of pitch angle: θ̇ = q. Is the column of q in another unit of time?"
    );
}

#[test]
fn height_is_kept_beside_the_four_and_said_so() {
    let four = model(&open(&["07-boeing747-four.m"], &[]), Longitudinal);
    let of_four = |review| PlaneModel { further: None, ..model(&review, Longitudinal) };
    let named = open(&["07-boeing747-five-named.m"], &[]);
    assert_eq!(of_four(named.clone()), four);
    assert_eq!(model(&named, Longitudinal).further_states(), [AppendedState::Height]);
    assert_eq!(named.remarks, ["h (height) is kept as a state beside the four: nothing else depends on it."]);
    // Without names, and with letters of its own.
    let bare = open(&["07-boeing747-five-states.m"], &[]);
    assert_eq!(
        bare.aircraft().expect_err("it waits").problem,
        "the file doesn’t say states (names of the states, in the order of A; perhaps u w q theta h)"
    );
    assert_eq!(of_four(open(&["07-boeing747-five-states.m"], &["all=suggested"])), four);
}

#[test]
fn rows_of_sideslip_in_the_units_of_v_and_feet_called_metres_are_told_and_mended_when_asked() {
    let review = open(&["12-vant-beta-row-in-v-units.csv"], &[]);
    let found = doubt(&review, "sideslip-row");
    assert!(
        found.sentence.contains("A(v, φ) is 145.6 m/s², where g cos θ₀ is 9.691 m/s²"),
        "{}",
        found.sentence
    );
    assert_eq!(remedy(found), ["sideslip_row=v"]);
    let mended = poles(&open(&["12-vant-beta-row-in-v-units.csv"], &["sideslip_row=v"]), Lateral);
    let right = poles(&open(&["12-vant-consistent.csv"], &[]), Lateral);
    assert!(mended.iter().zip(&right).all(|(x, y)| (x - y).norm() < 1e-4), "{mended:?} {right:?}");

    // Columns of β under the name of v: the rows of the flight are right, and so small is no aircraft.
    let review = open(&["12-vant-mixed-called-v.csv"], &[]);
    let found = doubt(&review, "sideslip-columns");
    assert_eq!(
        found.sentence,
        "A(p, v) is −29.89 beside A(p, p) of −12.32, and A(r, v) 9.800 beside A(r, r) of −0.1441: so small is a wing of 0.078 m. With \
         columns of β under the name of v it is one of 1.2 m."
    );
    assert_eq!(remedy(found), ["states=beta, p, r, phi", "sideslip_row=v"]);
    let fills = ["states=beta, p, r, phi", "sideslip_row=v"];
    let mended = open(&["12-vant-mixed-called-v.csv"], &fills);
    assert_eq!(doubts(&mended), [""; 0]);
    let mended = poles(&mended, Lateral);
    assert!(mended.iter().zip(&right).all(|(x, y)| (x - y).norm() < 1e-4), "{mended:?} {right:?}");

    let review = open(&["12-lateral-feet-called-metres.csv"], &[]);
    let found = doubt(&review, "gravity");
    assert!(found.sentence.contains("A(v, φ) is 32.20 m/s²"), "{}", found.sentence);
    assert_eq!(remedy(found), ["units=ft-slug-s"]);
    assert_eq!(doubts(&open(&["12-lateral-feet-called-metres.csv"], &["units=ft-slug-s"])), [""; 0]);
}

#[test]
fn digits_that_were_not_printed_are_told() {
    let review = open(&["17-printed-with-scale-factor.m"], &[]);
    assert_eq!(
        doubt(&review, "digits").sentence,
        "A stands as it was printed, with 4 decimals times 1000: an entry is known to ±0.050 only, and 3 that are not zero are printed \
         as 0. Print it with “format long g”, or as mat2str(A, 17)."
    );
    let a = model(&review, Longitudinal).a;
    assert!((a[(0, 3)] + 9.8).abs() < 1e-12 && (a[(1, 2)] - 53.6).abs() < 1e-12, "{a}");
}

#[test]
fn an_old_model_in_a_block_comment_is_not_read_and_fields_of_a_struct_are() {
    let a = model(&open(&["17-block-comment.m"], &[]), Longitudinal).a;
    assert_eq!((a[(0, 0)], a[(1, 2)]), (-0.05, 53.0));
    assert_eq!(
        model(&open(&["17-struct-fields.m"], &[]), Longitudinal),
        model(&open(&["17-struct-fields-plain.m"], &[]), Longitudinal)
    );
}

#[test]
fn what_is_no_model_is_told_in_a_sentence_with_its_line() {
    let told = |name: &str, text: &[u8]| {
        let file = eigenwing::content::import::FileBytes { name, bytes: text };
        let review = eigenwing::content::import::review(&[file], &Default::default());
        review.and_then(|review| review.aircraft()).expect_err("no aircraft").to_string()
    };
    for (name, text, expected) in [
        (
            "a.png",
            &b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR"[..],
            "a.png, line 1: this is no text file; expected matrices or the output of a program as text",
        ),
        (
            "a.m",
            b" \n",
            "a.m, line 1: the file is empty; expected matrices A and B, or the output of a program",
        ),
        (
            "a.txt",
            b"Dear diary",
            "a.txt, line 1: this form of file is not known here; known are matrices (MATLAB, Python, JSON, CSV) and files of AVL, XFLR5, VSPAERO, Digital DATCOM and JSBSim",
        ),
        (
            "a.m",
            b"units = 'SI'; speed = 50;\nA = [1 2 3 4\n5 6 7];",
            "a.m, line 2: A: expected 2 numbers in row 1, found 4",
        ),
        (
            "a.eig",
            b"# Navion\n#\n#   Run case     Eigenvalue\n 1 -0.29 1.9\n",
            "a.eig, line 1: this is AVL’s list of eigenvalues; save the system matrix, with the command S of its MODE menu, or the derivatives, ST",
        ),
        (
            "a.m",
            b"% units: SI\n% speed: 50\n% states: u w q quark\nA = [1 0 0 0; 0 1 0 0; 0 0 1 0; 0 0 1 0];",
            "a.m, line 3: “quark” is not a state known here; known are u (or V), w (or alpha), q, theta, v (or beta), p, r, phi, and h, psi, x, y, thrust, elevator and the like beside them.",
        ),
    ] {
        assert_eq!(told(name, text), expected);
    }
}

#[test]
fn a_value_that_nothing_waits_for_or_that_is_none_is_told() {
    let told = |fills: &[&str]| try_open(&["07-boeing747-four.m"], fills).expect_err("no value").problem;
    assert_eq!(told(&["spede=30"]), "nothing in this file waits for “spede”; did you mean “speed”?");
    assert_eq!(told(&["speed=fast"]), "speed: expected a number, found “fast”");
    assert_eq!(
        told(&["speed=80 furlong"]),
        "speed: furlong is not a unit known here; expected a number in m/s"
    );
    assert_eq!(told(&["units=cubits"]), "units: expected one of SI, ft-slug-s, found “cubits”");
    // Typed in another unit, and told beside what the file says.
    let review = open(&["07-boeing747-four.m"], &["speed=500 kt"]);
    assert!((model(&review, Longitudinal).trim.speed - 257.2222222).abs() < 1e-6);
    assert_eq!(review.remarks, ["speed: 257.222 m/s was typed; the file has 252.984 m/s."]);
}
