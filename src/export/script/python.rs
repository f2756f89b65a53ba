//! A script for python-control: the model from its numbers, its modes, the motion on screen, and a comparison with our own numbers.

use super::study::{Course, Driven, Entering, FrequencyStudy, MotionStudy, Study, WholeStudy};
use super::text::{list, matrix, number, quoted, row, settings};
use crate::content::LengthUnit;
use crate::export::plane::WholeReport;
use crate::flight::motion::inputs::Input;

/// A part of a script, a cell of a notebook.
pub struct Section {
    /// What it does, in words.
    pub title: &'static str,
    /// The code.
    pub code: String,
}

/// The script, with the marks of cells that editors know.
pub fn python(study: &Study) -> String {
    let mut text = format!("\"\"\"{}\n\n", plain(&study.title));
    for remark in &study.remarks {
        text += &format!("{}\n", plain(remark));
    }
    text += "\nSI units and radians. Needs python-control and matplotlib: pip install control matplotlib\n\"\"\"\n";
    for section in sections(study) {
        text += &format!("\n# %% {}\n{}", section.title, section.code);
    }
    text
}

/// Text that stands between three quotes.
fn plain(text: &str) -> String {
    text.replace('\\', "/").replace("\"\"\"", "'''")
}

/// The parts of the script, in order.
pub fn sections(study: &Study) -> Vec<Section> {
    let mut sections = vec![
        Section { title: "The model: x' = A x + B u", code: model(study) },
        Section { title: "Its modes, compared with those of Eigenwing", code: modes(study) },
    ];
    if let Some(whole) = &study.whole {
        let code = self::whole(whole, &study.report.inputs);
        sections.push(Section { title: whole.title, code });
    }
    if let Some(motion) = &study.motion {
        sections.push(Section { title: "The motion, exact at every sample", code: self::motion(motion) });
        sections.push(Section { title: "Compared with Eigenwing", code: compare_motion(motion) });
    }
    if let Some(frequency) = &study.frequency {
        sections.push(Section { title: "The frequency response", code: self::frequency(frequency) });
        sections.push(Section { title: "Compared with Eigenwing", code: compare_frequency(frequency) });
    }
    sections.push(Section { title: "Pictures", code: pictures(study) });
    sections
}

fn model(study: &Study) -> String {
    let report = &study.report;
    let mut text = String::from(
        "import control as ct\nimport matplotlib.pyplot as plt\nimport numpy as np\n\
         from scipy.integrate import solve_ivp\nfrom scipy.linalg import expm\n\n",
    );
    text += &settings(&study.trim, LengthUnit::Metre, "#");
    text += &format!("A = np.array({}, dtype=float)\n", matrix(&report.a));
    text += &format!("B = np.array({}, dtype=float)\n", matrix(&report.b));
    text += &format!("states = {}\ninputs = {}\n", quoted(&report.states), quoted(&report.inputs));
    text +=
        "aircraft = ct.ss(A, B, np.eye(4), np.zeros((4, 2)), states=states, inputs=inputs, outputs=states)\n";
    text + "print(aircraft)\n"
}

fn modes(study: &Study) -> String {
    let mut text = String::from("# Name and eigenvalue; of a pair the upper one.\nmodes = [\n");
    for mode in &study.report.modes {
        text += &format!("    (\"{}\", {}),\n", mode.name, complex(mode.re, mode.im));
    }
    text += "]\n";
    let all: Vec<String> = study.report.eigenvalues.iter().map(|[re, im]| complex(*re, *im)).collect();
    text += &format!("expected = [{}]\n", all.join(", "));
    text + "\
eigenvalues = list(np.linalg.eigvals(A))
largest = max(abs(value) for value in expected)
for value in expected:
    nearest = min(eigenvalues, key=lambda other: abs(other - value))
    eigenvalues.remove(nearest)
    assert abs(nearest - value) <= 1e-8 * largest, f\"eigenvalue {nearest}, expected {value}\"
for name, value in modes:
    text = f\"{name}: lambda = {value:.4g}\"
    if value.imag > 0:
        text += f\", wn = {abs(value):.4g} rad/s, zeta = {-value.real / abs(value):.4g}, T = {2 * np.pi / value.imag:.4g} s\"
    if value.real != 0:
        text += f\", time to {'half' if value.real < 0 else 'double'} = {np.log(2) / abs(value.real):.4g} s\"
    print(text)
"
}

/// A model with more than the four states, and its modes.
fn whole(whole: &WholeStudy, inputs: &[&str]) -> String {
    let WholeReport { states, a, b } = &whole.model;
    let mut text = format!("A_whole = np.array({}, dtype=float)\n", matrix(a));
    text += &format!("B_whole = np.array({}, dtype=float)\n", matrix(b));
    text += &format!("# {}\n", states.join(", "));
    text += &format!(
        "whole = ct.ss(A_whole, B_whole, np.eye({n}), np.zeros(({n}, 2)), inputs={inputs})\n",
        n = states.len(),
        inputs = quoted(inputs)
    );
    text += "modes_whole = [\n";
    for (name, re, im) in &whole.modes {
        text += &format!("    (\"{name}\", {}),\n", complex(*re, *im));
    }
    text + "\
]
found = np.linalg.eigvals(A_whole)
for name, value in modes_whole:
    nearest = min(found, key=lambda other: abs(other - value))
    # Integrals of each other are known to half the digits only.
    assert abs(nearest - value) <= 1e-6 * max(abs(found)), f\"eigenvalue {nearest}, expected {value}\"
    print(f\"{name}: lambda = {value:.4g}\")
"
}

fn complex(re: f64, im: f64) -> String {
    format!("complex({})", list(&[re, im]).trim_matches(['[', ']']))
}

fn motion(motion: &MotionStudy) -> String {
    let about = motion.about().iter().map(|line| format!("# {line}\n")).collect::<String>();
    let mut text = format!("{about}# Two states of the path stand behind the four.\n");
    text += &format!("A6 = np.array({}, dtype=float)\n", matrix(&motion.a));
    let Entering { names, columns, direct } = motion.entering();
    text += &format!("B6 = np.array({}, dtype=float)\n", matrix(&columns));
    let rows: Vec<[f64; 6]> = motion.outputs.iter().map(|output| output.states).collect();
    text += &format!("C6 = np.array({}, dtype=float)\n", matrix(&rows));
    text += &format!("D6 = np.array({}, dtype=float)\n", matrix(&direct));
    let outputs: Vec<&str> = motion.outputs.iter().map(|output| output.named.key).collect();
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    text += &format!(
        "motion = ct.ss(A6, B6, C6, D6, states={}, inputs={}, outputs={})\n",
        quoted(&motion.states),
        quoted(&names),
        quoted(&outputs)
    );
    text += &format!("x = np.array({}, dtype=float)  # at the start\n", list(&motion.start));
    text + &match motion.course {
        Course::Held => held(motion),
        Course::Smooth => smooth(motion),
        Course::Sampled(dt) => sampled(motion, dt),
    }
}

/// Lines before the loop over pieces of time, and those after it.
const PIECES: &str = "step = bounds[-1] / 1200
times, outputs, checked = [0.0], [C6 @ x + D6 @ at(0.0, 0.5 * bounds[1])], {}
for begin, end in zip(bounds, bounds[1:]):
    middle = 0.5 * (begin + end)
    piece = np.linspace(begin, end, max(2, int(np.ceil((end - begin) / step)) + 1))
";

fn held(motion: &MotionStudy) -> String {
    let mut text =
        format!("# Between these times [s] the input is constant.\nbounds = {}\n", list(&motion.bounds));
    text += &format!("held = {}\n\n\n", list(&motion.held()));
    text += "def at(time, middle):\n    return np.array([held[max(0, np.searchsorted(bounds, middle) - 1)]])\n\n\n";
    text += PIECES;
    text + "    \
    result = ct.forced_response(motion, piece - begin, np.full((1, piece.size), at(begin, middle)[0]), x)
    times += list(piece[1:])
    outputs += list(result.y[:, 1:].T)
    x = result.x[:, -1]
    checked[end] = outputs[-1]
times, outputs = np.array(times), np.array(outputs)
"
}

fn smooth(motion: &MotionStudy) -> String {
    let mut text =
        format!("# Between these times [s] the input is smooth.\nbounds = {}\n\n\n", list(&motion.bounds));
    text +=
        "def at(time, middle):\n    \"\"\"The inputs at a time; middle tells whether they are on.\"\"\"\n";
    let mut values = Vec::new();
    for (k, input) in motion.inputs.iter().enumerate() {
        let (on, value, rate) = course(input);
        let key = input.named.key;
        text += &format!("    on = {on}\n    {key} = {value} if on else 0.0\n");
        values.push(key.to_owned());
        if motion.has_rate(k) {
            text += &format!("    {key}_rate = {rate} if on else 0.0\n");
            values.push(format!("{key}_rate"));
        }
    }
    text += &format!("    return np.array([{}])\n\n\n", values.join(", "));
    text += PIECES;
    text + "    \
    result = solve_ivp(
        lambda time, x: A6 @ x + B6 @ at(time, middle), (begin, end), x,
        method=\"DOP853\", t_eval=piece, rtol=1e-12, atol=1e-15,
    )
    times += list(piece[1:])
    outputs += [C6 @ result.y[:, k] + D6 @ at(piece[k], middle) for k in range(1, piece.size)]
    x = result.y[:, -1]
    checked[end] = outputs[-1]
times, outputs = np.array(times), np.array(outputs)
"
}

/// When a smooth input is on, its value and its rate, as expressions of `time` and `middle`.
fn course(input: &Driven) -> (String, String, String) {
    let n = number;
    let when = |start: f64, duration: f64| format!("{} <= middle < {}", n(start), n(start + duration));
    match input.input {
        Input::Sine { amplitude, start, duration, frequency } => {
            let amplitude = amplitude * input.sign;
            let angle = format!("{} * (time - {})", n(frequency), n(start));
            (
                when(start, duration),
                format!("{} * np.sin({angle})", n(amplitude)),
                format!("{} * np.cos({angle})", n(amplitude * frequency)),
            )
        }
        Input::Sweep { amplitude, start, duration, from, to } => {
            let amplitude = amplitude * input.sign;
            let since = format!("(time - {})", n(start));
            let slope = n((to - from) / duration);
            let angle = format!("{} * {since} + 0.5 * {slope} * {since} ** 2", n(from));
            (
                when(start, duration),
                format!("{} * np.sin({angle})", n(amplitude)),
                format!("{} * ({} + {slope} * {since}) * np.cos({angle})", n(amplitude), n(from)),
            )
        }
        Input::OneMinusCosine { amplitude, start, duration } => {
            let amplitude = amplitude * input.sign;
            let angle = format!("2 * np.pi * (time - {}) / {}", n(start), n(duration));
            (
                when(start, duration),
                format!("{} * (1 - np.cos({angle}))", n(0.5 * amplitude)),
                format!("{} * np.pi / {} * np.sin({angle})", n(amplitude), n(duration)),
            )
        }
        _ => ("False".to_owned(), "0.0".to_owned(), "0.0".to_owned()),
    }
}

fn sampled(motion: &MotionStudy, dt: f64) -> String {
    let mut text = format!("step = {}  # s, between the samples of the air\n", number(dt));
    text += "air = np.array([\n";
    for input in &motion.inputs {
        if let Input::Samples { values, .. } = &input.input {
            let values: Vec<f64> = values.iter().map(|x| x * input.sign).collect();
            text += &format!("    {},  # {}\n", list(&values), input.named.key);
        }
    }
    text += "])\nrates = np.hstack([np.diff(air) / step, np.zeros((len(air), 1))])\n";
    let mut places = Vec::new();
    for k in 0..motion.inputs.len() {
        places.push(format!("air[{k}]"));
        if motion.has_rate(k) {
            places.push(format!("rates[{k}]"));
        }
    }
    text += &format!("driven = np.array([{}])\n", places.join(", "));
    text += "\
# Straight lines between the samples: exact by one exponential, of the states with the air and its rate behind them.
n, m = 6, len(air)
block = np.zeros((n + 2 * m, n + 2 * m))
block[:n, :n] = A6
";
    let mut column = 0;
    for k in 0..motion.inputs.len() {
        text += &format!("block[:n, n + {k}] = B6[:, {column}]\nblock[n + {k}, n + m + {k}] = 1\n");
        column += 1;
        if motion.has_rate(k) {
            text += &format!("block[:n, n + m + {k}] = B6[:, {column}]\n");
            column += 1;
        }
    }
    text + "\
one_step = expm(block * step)[:n]
times, outputs = step * np.arange(air.shape[1]), []
for k in range(times.size):
    outputs.append(C6 @ x + D6 @ driven[:, k])
    x = one_step @ np.hstack([x, air[:, k], rates[:, k]])
outputs = np.array(outputs)
checked = {}
"
}

fn compare_motion(motion: &MotionStudy) -> String {
    let mut text = format!("check_times = {}\n", list(&motion.checks));
    text += "# Output, its values at these times, and its largest of all.\nexpected = [\n";
    for output in &motion.outputs {
        text += &format!(
            "    (\"{}\", {}, {}),\n",
            output.named.key,
            list(&output.checks),
            number(output.largest)
        );
    }
    text += "]\n";
    let found = match motion.course {
        Course::Sampled(_) => "outputs[int(round(time / step)), column]",
        Course::Held | Course::Smooth => "checked[time][column]",
    };
    text += "for column, (name, values, largest) in enumerate(expected):\n    for time, value in zip(check_times, values):\n";
    text += &format!("        found = {found}\n");
    text += "        assert abs(found - value) <= 1e-8 * max(largest, 1e-12), f\"{name} at {time} s: {found}, expected {value}\"\n";
    text + "print(f\"The motion is that of Eigenwing at {len(check_times)} times, to 1e-8.\")\n"
}

fn frequency(study: &FrequencyStudy) -> String {
    let columns: Vec<[f64; 2]> = (0..6).map(|i| [study.columns[0][i], study.columns[1][i]]).collect();
    let mut text = String::from(
        "# Two states of the path stand behind the four; the second input is the rate of the first.\n",
    );
    text += &format!("A6 = np.array({}, dtype=float)\n", matrix(&study.a));
    text += &format!("B6 = np.array({}, dtype=float)\n", matrix(&columns));
    text += &format!("C6 = np.array([{}], dtype=float)\n", row(&study.row));
    text += &format!("D6 = np.array([{}], dtype=float)\n", row(&[study.direct.0, study.direct.1]));
    text += &format!(
        "system = ct.ss(A6, B6, C6, D6, inputs=[\"{0}\", \"{0}_rate\"], outputs=[\"{1}\"])\n\n\n",
        study.input.key, study.output.key
    );
    text += &format!(
        "def response(frequency):\n    \"\"\"G(jw): {} for a unit of {}.\"\"\"\n",
        study.output.key, study.input.key
    );
    text += "    s = 1j * frequency\n    of_value, of_rate = np.atleast_2d(system(s))[0]\n    return of_value + s * of_rate\n\n\n";
    text += &format!(
        "frequencies = np.geomspace({}, 400)\n",
        list(&[study.range.0, study.range.1]).trim_matches(['[', ']'])
    );
    text + "values = np.array([response(frequency) for frequency in frequencies])\n"
}

fn compare_frequency(study: &FrequencyStudy) -> String {
    let mut text = String::from("# Frequency [rad/s], real and imaginary part of G.\nexpected = [\n");
    for (frequency, re, im) in &study.checks {
        text += &format!("    ({}),\n", row(&[*frequency, *re, *im]).trim_matches(['[', ']']));
    }
    text += "]\nfor frequency, real, imaginary in expected:\n    value = complex(real, imaginary)\n    found = response(frequency)\n";
    text += "    assert abs(found - value) <= 1e-8 * abs(value), f\"G at {frequency} rad/s: {found}, expected {value}\"\n";
    text + "print(f\"The frequency response is that of Eigenwing at {len(expected)} frequencies, to 1e-8.\")\n"
}

fn pictures(study: &Study) -> String {
    let mut text = String::from(
        "figure, axes = plt.subplots()\nfor name, value in modes:\n    \
         line, = axes.plot([value.real] * 2, [value.imag, -value.imag], \"x\", markersize=9, markeredgewidth=2)\n    \
         axes.annotate(name, (value.real, value.imag), xytext=(6, 6), textcoords=\"offset points\")\n\
         axes.axvline(0, color=\"gray\", linewidth=1)\naxes.set(xlabel=\"Re [1/s]\", ylabel=\"Im [rad/s]\")\naxes.grid(True)\n",
    );
    if let Some(motion) = &study.motion {
        text += "\n# Name, unit, and how many of it one SI unit is.\nshown = [\n";
        for output in &motion.outputs {
            let named = &output.named;
            text += &format!("    (\"{}\", \"{}\", {}),\n", named.name, named.shown, number(named.per_si));
        }
        text += "]\n";
        if motion.portraits.is_empty() {
            text += "\
figure, axes = plt.subplots(len(shown), sharex=True, squeeze=False)
for column, (name, unit, factor) in enumerate(shown):
    axes[column, 0].plot(times, outputs[:, column] * factor)
    axes[column, 0].set_ylabel(f\"{name} [{unit}]\" if unit else name)
    axes[column, 0].grid(True)
axes[-1, 0].set_xlabel(\"t [s]\")
";
        } else {
            let pairs: Vec<String> = motion.portraits.iter().map(|(x, y)| format!("({x}, {y})")).collect();
            text += &format!(
                "figure, axes = plt.subplots(1, {}, squeeze=False)\nfor axis, pair in zip(axes[0], [{}]):\n    \
                     (x_name, x_unit, x_factor), (y_name, y_unit, y_factor) = [shown[k] for k in pair]\n    \
                     axis.plot(outputs[:, pair[0]] * x_factor, outputs[:, pair[1]] * y_factor)\n    \
                     axis.set(xlabel=f\"{{x_name}} [{{x_unit}}]\", ylabel=f\"{{y_name}} [{{y_unit}}]\")\n    axis.grid(True)\n",
                pairs.len(),
                pairs.join(", ")
            );
        }
    }
    if study.frequency.is_some() {
        text += "
figure, (upper, lower) = plt.subplots(2, sharex=True)
upper.loglog(frequencies, abs(values))
upper.set_ylabel(\"gain [SI]\")
lower.semilogx(frequencies, np.degrees(np.unwrap(np.angle(values))))
lower.set(xlabel=\"frequency [rad/s]\", ylabel=\"phase [deg]\")
upper.grid(True)
lower.grid(True)
";
    }
    text + "plt.show()\n"
}
