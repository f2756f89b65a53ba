//! The same model as other programs write it: read, or told in one sentence that names the cause.

use std::collections::BTreeMap;

use eigenwing::content::import::{FileBytes, review};
use eigenwing::flight::aircraft::plane::{Plane, PlaneModel};
use nalgebra::{Matrix4, Matrix4x2};

/// The Navion's longitudinal motion, to four digits.
fn expected() -> Matrix4<f64> {
    Matrix4::from_row_slice(&[
        -0.0451, 0.0362, 0.0, -9.80665, -0.3695, -2.0232, 53.64, 0.0, 0.0063, -0.1639, -2.9857, 0.0, 0.0,
        0.0, 1.0, 0.0,
    ])
}

fn read(name: &str, bytes: &[u8]) -> Result<PlaneModel, String> {
    let fills = BTreeMap::from([("all".to_owned(), "suggested".to_owned())]);
    let found = review(&[FileBytes { name, bytes }], &fills).map_err(|error| error.to_string())?;
    let aircraft = found.aircraft().map_err(|error| error.to_string())?;
    let models = aircraft.aircraft_model.models().map_err(|error| error.to_string())?;
    models.planes[Plane::Longitudinal].clone().ok_or_else(|| "no longitudinal model".to_owned())
}

const ROWS: [&str; 4] =
    ["-0.0451 0.0362 0 -9.80665", "-0.3695 -2.0232 53.64 0", "0.0063 -0.1639 -2.9857 0", "0 0 1 0"];

const HEAD: &str = "% units: SI\n% speed: 53.64\n% states: u w q theta\n";

fn by(between: &str, line: &str) -> String {
    ROWS.map(|row| row.replace(' ', between)).join(line)
}

/// A of each text is that of the model, and where it has B, its elevator pitches as much.
#[test]
fn matrices_of_other_programs_are_read_to_the_last_digit() {
    let script = |a: &str| format!("{HEAD}{a}");
    let plain = script(&format!("A = [{}];\n", ROWS.join("; ")));
    let scripts = [
        ("latex.tex", format!("\\begin{{equation}}\nA = \\begin{{bmatrix}} {} \\end{{bmatrix}}\n\\end{{equation}}\n", by(" & ", " \\\\ "))),
        (
            "array.tex",
            format!("\\mathbf{{A}} = \\left[ \\begin{{array}}{{cccc}}\n{} \\\\\n\\end{{array}} \\right]\n", by(" & ", " \\\\\n")),
        ),
        ("mathematica.txt", format!("A = {{{{{}}}}};\nB = {{{{0}}, {{-8.59}}, {{-11.89}}, {{0}}}};\n", by(", ", "}, {"))),
        ("exponents.txt", format!("A = {{{{{}}}}};\n", by(", ", "}, {").replace("-0.0451", "-4.51*^-2"))),
        ("maple.txt", format!("A := Matrix([[{}]]);\n", by(", ", "], ["))),
        ("maxima.mac", format!("A: matrix([{}])$\n", by(", ", "], ["))),
        ("by-row.R", format!("A <- matrix(c({}), nrow=4, byrow=TRUE)\n", by(",", ","))),
        (
            "by-column.R",
            "A <- matrix(c(-0.0451,-0.3695,0.0063,0,\n 0.0362,-2.0232,-0.1639,0, 0,53.64,-2.9857,1, -9.80665,0,0,0), ncol = 4)\n".to_owned(),
        ),
        ("string.py", format!("A = np.matrix('{}')\nB = np.matrix('0; -8.59; -11.89; 0')\n", ROWS.join("; "))),
        (
            "julia.jl",
            format!("# speed = 53.64\nA = [{}]\nB = [0; -8.59; -11.89; 0;;]\nsys = ss(A, B, I, 0)\n", ROWS.join("\n     ")),
        ),
        ("julia.txt", format!("4×4 Matrix{{Float64}}:\n {}\n", ROWS.join("\n "))),
        (
            "names.m",
            script(
                "g = 9.80665; U0 = 53.64;\nXu = -0.0451; Mw = 0.1639;\n\
                 A = [Xu 0.0362 0 -g; -0.3695 -2.0232 U0 0; 0.0063 -Mw -2.9857 0; 0 0 1 0];\n",
            )
            .replace("% speed: 53.64\n", ""),
        ),
        (
            "names.py",
            "import numpy as np\nV = 53.64  # m/s\nA = np.array([\n    [-0.0451, 0.0362, 0., -9.80665],\n    [-0.3695, -2.0232, V, 0.],\n    \
             [0.0063, -0.1639, -2.9857, 0.],\n    [0., 0., 1., 0.],\n])\n"
                .to_owned(),
        ),
        (
            "octave.mat",
            format!(
                "# Created by Octave 6.4.0, Mon Jan 01 12:00:00 2024 UTC <a@b>\n# name: A\n# type: matrix\n# rows: 4\n# columns: 4\n {}\n\n\n\
                 # name: B\n# type: matrix\n# rows: 4\n# columns: 1\n 0\n -8.59\n -11.89\n 0\n\n\n",
                ROWS.join("\n ")
            ),
        ),
        (
            "control.txt",
            format!(
                "<StateSpace>: sys[0]\nInputs (1): ['elevator']\nOutputs (4): ['u', 'w', 'q', 'theta']\nStates (4): ['u', 'w', 'q', 'theta']\n\n\
                 A = [[{}]]\n\nB = [[  0.  ]\n     [ -8.59]\n     [-11.89]\n     [  0.  ]]\n\nC = [[1. 0. 0. 0.]]\n\nD = [[0.]]\n",
                ROWS.join("]\n     [")
            ),
        ),
        (
            "ss.txt",
            "sys =\n \n  A = \n                u        w        q    theta\n   u      -0.0451   0.0362        0 -9.80665\n   w      -0.3695  -2.0232    53.64        0\n   \
             q       0.0063  -0.1639  -2.9857        0\n   theta        0        0        1        0\n \n  B = \n          elevator\n   u             0\n   \
             w         -8.59\n   q        -11.89\n   theta         0\n \n  C = \n              u      w      q  theta\n   u          1      0      0      0\n   \
             w          0      1      0      0\n \n  D = \n      elevator\n   u         0\n   w         0\n \nContinuous-time state-space model.\n"
                .to_owned(),
        ),
        (
            "unnamed-ss.txt",
            "A = \n            x1       x2       x3       x4\n   x1  -0.0451   0.0362        0 -9.80665\n   x2  -0.3695  -2.0232    53.64        0\n   \
             x3   0.0063  -0.1639  -2.9857        0\n   x4        0        0        1        0\n"
                .to_owned(),
        ),
        (
            "pandas.txt",
            "            u       w        q     theta\nu     -0.0451  0.0362   0.0000  -9.80665\nw     -0.3695 -2.0232  53.6400   0.00000\n\
             q      0.0063 -0.1639  -2.9857   0.00000\ntheta  0.0000  0.0000   1.0000   0.00000\n"
                .to_owned(),
        ),
        (
            "table.md",
            "| | u | w | q | theta |\n|---|---|---|---|---|\n| u | -0.0451 | 0.0362 | 0 | -9.80665 |\n| w | -0.3695 | -2.0232 | 53.64 | 0 |\n\
             | q | 0.0063 | -0.1639 | -2.9857 | 0 |\n| theta | 0 | 0 | 1 | 0 |\n"
                .to_owned(),
        ),
        ("semicolons.csv", format!("{}\n", by(";", "\n").replace('.', ","))),
        ("tabs.txt", format!("{}\n", by("\t", "\n").replace('.', ",").replace('-', "\u{2212}"))),
        ("blanks.txt", format!("{}\n", by("  ", "\n").replace('.', ","))),
        ("carriage.m", plain.replace('\n', "\r")),
        ("windows.m", plain.replace('\n', "\r\n")),
        ("dashes.m", plain.replace('-', "\u{2013}")),
        ("no-break.m", plain.replace(' ', "\u{a0}").replace("%\u{a0}", "% ")),
        ("thin.txt", by("\u{2009}\u{2009}", "\n")),
        ("commented.m", script(&format!("A = [ {} ]; % theta\n", ROWS.map(|row| format!("{row}  % a row")).join("\n").replace("0 0 1 0  % a row", "0 0 1 0")))),
        ("dots.m", script(&format!("A=[{}];B=[0;-8.59;-11.89;0];inputs={{\"elevator\"}};\n", by(",", ";...\n")))),
        ("repr.txt", format!("array([[{}]])\n", by(", ", "],\n       ["))),
    ];
    for (name, text) in &scripts {
        let model = read(name, text.as_bytes()).unwrap_or_else(|error| panic!("{name}: {error}\n{text}"));
        assert!((model.a - expected()).amax() < 1e-15, "{name}: {}", model.a);
        assert!((model.trim.speed - 53.64).abs() < 1e-12, "{name}");
        let is_driven = model.b != Matrix4x2::zeros();
        assert!(!is_driven || model.b[(2, 0)] == -11.89, "{name}: {}", model.b);
        let has_b = text.contains("11.89");
        assert_eq!(is_driven, has_b, "{name}: {}", model.b);
    }
    assert_eq!(scripts.len(), 30);
    let big: Vec<u8> =
        [0xfe, 0xff].into_iter().chain(plain.encode_utf16().flat_map(u16::to_be_bytes)).collect();
    assert_eq!(read("big.m", &big).expect("it is read").a, expected());
}

#[test]
fn files_of_other_programs_are_read_with_their_b() {
    for (name, digits) in [("navion.tex", 1e-15), ("navion.R", 1e-15), ("navion-printed-system.txt", 1e-3)] {
        let path = format!("{}/tests/data/import/{name}", env!("CARGO_MANIFEST_DIR"));
        let model = read(name, &std::fs::read(&path).expect("it is there")).expect("it is read");
        assert!((model.a - expected()).amax() < digits, "{name}: {}", model.a);
        assert_eq!((model.b[(1, 0)], model.b[(2, 0)]), (-8.59, -11.89), "{name}");
    }
}

#[test]
fn what_can_t_be_read_is_told_with_its_line_and_what_to_do() {
    for (name, text, expected) in [
        (
            "damp.txt",
            "         Pole              Damping       Frequency       Time Constant\n -1.74e-02 + 2.19e-01i     7.91e-02       2.20e-01\n",
            "damp.txt, line 1: this is a list of poles, as MATLAB’s damp prints it; a model needs the matrix A itself: print it with mat2str(A, 17)",
        ),
        (
            "german.csv",
            "\u{feff}\"Einheiten\";\"SI\"\r\n;u;w;q;theta\r\n",
            "german.csv, line 1: expected a setting such as units or speed, or the names of the states, found \"Einheiten\"",
        ),
        (
            "notes.csv",
            "units;SI\nspeed;53,64\n;u;w;q;theta\nu;-0,0451;0,0362;0;-9,81\nw;-0,3695;-2,0232;53,64;0\nq;0,0063;-0,1639;-2,9857;0\n\
             theta;0;0;1;0\nNote;for the wing\n",
            "notes.csv, line 8: expected no row after that of the last state, found \"Note\"",
        ),
        (
            "zeros.m",
            "A = zeros(4, 4);\nA(1, :) = [-0.0451 0.0362 0 -9.80665];\n",
            "zeros.m, line 1: A: expected plain numbers or quoted names, found \"zeros\"; nothing is computed here",
        ),
        (
            "computed.m",
            "U0 = 50;\nA = [1 2 3 4; 5 6 2*U0 8; 1 2 3 4; 0 0 1 0];\n",
            "computed.m, line 2: A: expected plain numbers or quoted names, found \"*\"; nothing is computed here",
        ),
        (
            "difference.m",
            "U0 = 50; Zq = 3;\nA = [1 2 3 4; 5 6 U0-Zq 8; 1 2 3 4; 0 0 1 0];\n",
            "difference.m, line 2: A: expected plain numbers or quoted names, found \"-\"; nothing is computed here",
        ),
        (
            "made.m",
            "U0 = 50;\nU0 = sqrt(3);\nA = [1 2 3 4; 5 6 U0 8; 1 2 3 4; 0 0 1 0];\n",
            "made.m, line 2: u0: expected plain numbers or quoted names, found \"sqrt\"; nothing is computed here",
        ),
        (
            "unset.m",
            "Zw = 50;\nZw = sqrt(3);\nA = [1 2 3 4; 5 Zw 6 8; 1 2 3 4; 0 0 1 0];\n",
            "unset.m, line 3: A: expected plain numbers or quoted names, found \"Zw\"; nothing is computed here",
        ),
        ("comma.json", "{\"A\": [[1, 2],],}", "comma.json, line 1: trailing comma"),
    ] {
        assert_eq!(read(name, text.as_bytes()).expect_err(name), expected);
    }
}
