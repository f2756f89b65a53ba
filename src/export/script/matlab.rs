//! A script for MATLAB with its Control System Toolbox, and for GNU Octave with its control package: what the Python script does.

use super::study::{Course, Driven, Entering, FrequencyStudy, MotionStudy, Study, WholeStudy};
use super::text::{joined, number, settings};
use crate::content::LengthUnit;
use crate::export::plane::WholeReport;
use crate::flight::motion::inputs::Input;

/// The script.
pub fn matlab(study: &Study) -> String {
    let mut text = format!("%% {}\n", study.title);
    for remark in &study.remarks {
        text += &format!("% {remark}\n");
    }
    text += "% SI units and radians. Needs MATLAB's Control System Toolbox, or GNU Octave with its package control.\n";
    text += "if exist('OCTAVE_VERSION', 'builtin'), pkg load control; end\n\n";
    text += &model(study);
    text += &modes(study);
    text += &study.whole.as_ref().map_or_else(String::new, whole);
    if let Some(motion) = &study.motion {
        text += &self::motion(motion);
        text += &compare_motion(motion);
    }
    if let Some(frequency) = &study.frequency {
        text += &self::frequency(frequency);
    }
    text + &pictures(study)
}

/// A matrix over several lines.
fn matrix<R: AsRef<[f64]>>(rows: &[R]) -> String {
    let rows: Vec<String> = rows.iter().map(|row| format!("     {}", joined(row.as_ref(), ", "))).collect();
    format!("[ ...\n{} ]", rows.join("; ...\n"))
}

fn vector(values: &[f64]) -> String {
    format!("[{}]", joined(values, ", "))
}

fn cell(words: &[&str]) -> String {
    let words: Vec<String> = words.iter().map(|word| format!("'{}'", word.replace('\'', "''"))).collect();
    format!("{{{}}}", words.join(", "))
}

fn model(study: &Study) -> String {
    let report = &study.report;
    let mut text = String::from("%% The model: x' = A x + B u\n");
    text += &settings(&study.trim, LengthUnit::Metre, "%");
    text += &format!("A = {};\nB = {};\n", matrix(&report.a), matrix(&report.b));
    text += &format!("states = {};\ninputs = {};\n", cell(&report.states), cell(&report.inputs));
    text + "aircraft = ss(A, B, eye(4), zeros(4, 2), 'StateName', states, 'InputName', inputs, 'OutputName', states)\n\n"
}

fn modes(study: &Study) -> String {
    let modes = &study.report.modes;
    let names: Vec<&str> = modes.iter().map(|mode| mode.name).collect();
    let complex = |re: f64, im: f64| format!("complex({})", joined(&[re, im], ", "));
    let values: Vec<String> = modes.iter().map(|mode| complex(mode.re, mode.im)).collect();
    let all: Vec<String> = study.report.eigenvalues.iter().map(|[re, im]| complex(*re, *im)).collect();
    let mut text =
        String::from("%% Its modes, compared with those of Eigenwing; of a pair the upper eigenvalue\n");
    text += &format!("names = {};\nvalues = [{}];\n", cell(&names), values.join(", "));
    text += &format!("expected = [{}];\n", all.join(", "));
    text + "\
found = eig(A);
for k = 1:numel(expected)
    [away, nearest] = min(abs(found - expected(k)));
    assert(away <= 1e-8 * max(abs(expected)), 'an eigenvalue is not that of Eigenwing');
    found(nearest) = [];
end
for k = 1:numel(values)
    value = values(k);
    fprintf('%s: lambda = %.4g %+.4gi', names{k}, real(value), imag(value));
    if imag(value) > 0
        fprintf(', wn = %.4g rad/s, zeta = %.4g, T = %.4g s', abs(value), -real(value) / abs(value), 2 * pi / imag(value));
    end
    fprintf('\\n');
end

"
}

/// A model with more than the four states, and its modes.
fn whole(whole: &WholeStudy) -> String {
    let WholeReport { states, a, b } = &whole.model;
    let mut text = format!("%% {}\n", whole.title);
    text += &format!("A_whole = {};\nB_whole = {};\n% {}\n", matrix(a), matrix(b), states.join(", "));
    let names: Vec<&str> = whole.modes.iter().map(|(name, ..)| *name).collect();
    let values: Vec<String> =
        whole.modes.iter().map(|(_, re, im)| format!("complex({})", joined(&[*re, *im], ", "))).collect();
    text += &format!("names_whole = {};\nvalues_whole = [{}];\n", cell(&names), values.join(", "));
    text + "\
found = eig(A_whole);
for k = 1:numel(values_whole)
    % Integrals of each other are known to half the digits only.
    assert(min(abs(found - values_whole(k))) <= 1e-6 * max(abs(found)), 'an eigenvalue is not that of Eigenwing');
    fprintf('%s: lambda = %.4g %+.4gi\\n', names_whole{k}, real(values_whole(k)), imag(values_whole(k)));
end

"
}

fn motion(motion: &MotionStudy) -> String {
    let Entering { names, columns, direct } = motion.entering();
    let rows: Vec<[f64; 6]> = motion.outputs.iter().map(|output| output.states).collect();
    let outputs: Vec<&str> = motion.outputs.iter().map(|output| output.named.key).collect();
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    let mut text =
        String::from("%% The motion, exact at every sample; two states of the path stand behind the four\n");
    text += &motion.about().iter().map(|line| format!("% {line}\n")).collect::<String>();
    text += &format!("A6 = {};\nB6 = {};\n", matrix(&motion.a), matrix(&columns));
    text += &format!("C6 = {};\nD6 = {};\n", matrix(&rows), matrix(&direct));
    text += &format!(
        "motion = ss(A6, B6, C6, D6, 'StateName', {}, 'InputName', {}, 'OutputName', {});\n",
        cell(&motion.states),
        cell(&names),
        cell(&outputs)
    );
    text += &format!("x = {}';  % at the start\n", vector(&motion.start));
    text + &match motion.course {
        Course::Held => held(motion),
        Course::Smooth => smooth(motion),
        Course::Sampled(dt) => sampled(motion, dt),
    }
}

fn held(motion: &MotionStudy) -> String {
    let mut text =
        format!("% Between these times [s] the input is constant.\nbounds = {};\n", vector(&motion.bounds));
    text += &format!("held = {};\n", vector(&motion.held()));
    text + "\
times = 0; outputs = (C6 * x + D6 * held(1))'; ends = zeros(numel(held), size(C6, 1));
for k = 1:numel(held)
    length = bounds(k + 1) - bounds(k);
    piece = linspace(0, length, max(3, ceil(1200 * length / bounds(end)) + 1))';
    [y, ~, states_there] = lsim(motion, held(k) * ones(size(piece)), piece, x);
    times = [times; bounds(k) + piece(2:end)]; outputs = [outputs; y(2:end, :)];
    x = states_there(end, :)'; ends(k, :) = y(end, :);
end

"
}

fn smooth(motion: &MotionStudy) -> String {
    let mut text =
        format!("% Between these times [s] the input is smooth.\nbounds = {};\n", vector(&motion.bounds));
    let mut places = Vec::new();
    for (k, input) in motion.inputs.iter().enumerate() {
        let (on, value, rate) = course(input);
        let key = input.named.key;
        text += &format!("is_on = @(middle) {on};\n{key} = @(time) {value};\n");
        places.push(format!("{key}(time)"));
        if motion.has_rate(k) {
            text += &format!("{key}_rate = @(time) {rate};\n");
            places.push(format!("{key}_rate(time)"));
        }
    }
    text += &format!("at = @(time, middle) is_on(middle) * [{}];\n", places.join("; "));
    text + "\
precise = odeset('RelTol', 1e-11, 'AbsTol', 1e-14);
times = 0; outputs = (C6 * x + D6 * at(0, bounds(2) / 2))'; ends = zeros(numel(bounds) - 1, size(C6, 1));
for k = 1:numel(bounds) - 1
    middle = 0.5 * (bounds(k) + bounds(k + 1));
    piece = linspace(bounds(k), bounds(k + 1), max(3, ceil(1200 * (bounds(k + 1) - bounds(k)) / bounds(end)) + 1));
    [~, states_there] = ode45(@(time, x) A6 * x + B6 * at(time, middle), piece, x, precise);
    for sample = 2:numel(piece)
        times(end + 1, 1) = piece(sample);
        outputs(end + 1, :) = (C6 * states_there(sample, :)' + D6 * at(piece(sample), middle))';
    end
    x = states_there(end, :)'; ends(k, :) = outputs(end, :);
end

"
}

/// When a smooth input is on, its value and its rate, as expressions of `time` and `middle`.
fn course(input: &Driven) -> (String, String, String) {
    let n = number;
    let when =
        |start: f64, duration: f64| format!("{} <= middle && middle < {}", n(start), n(start + duration));
    match input.input {
        Input::Sine { amplitude, start, duration, frequency } => {
            let amplitude = amplitude * input.sign;
            let angle = format!("{} * (time - {})", n(frequency), n(start));
            (
                when(start, duration),
                format!("{} * sin({angle})", n(amplitude)),
                format!("{} * cos({angle})", n(amplitude * frequency)),
            )
        }
        Input::Sweep { amplitude, start, duration, from, to } => {
            let amplitude = amplitude * input.sign;
            let since = format!("(time - {})", n(start));
            let slope = n((to - from) / duration);
            let angle = format!("{} * {since} + 0.5 * {slope} * {since}^2", n(from));
            (
                when(start, duration),
                format!("{} * sin({angle})", n(amplitude)),
                format!("{} * ({} + {slope} * {since}) * cos({angle})", n(amplitude), n(from)),
            )
        }
        Input::OneMinusCosine { amplitude, start, duration } => {
            let amplitude = amplitude * input.sign;
            let angle = format!("2 * pi * (time - {}) / {}", n(start), n(duration));
            (
                when(start, duration),
                format!("{} * (1 - cos({angle}))", n(0.5 * amplitude)),
                format!("{} * pi / {} * sin({angle})", n(amplitude), n(duration)),
            )
        }
        _ => ("false".to_owned(), "0".to_owned(), "0".to_owned()),
    }
}

fn sampled(motion: &MotionStudy, dt: f64) -> String {
    let mut text = format!("step = {};  % s, between the samples of the air\nair = [ ...\n", number(dt));
    for input in &motion.inputs {
        if let Input::Samples { values, .. } = &input.input {
            let values: Vec<f64> = values.iter().map(|x| x * input.sign).collect();
            text += &format!("{}; ...\n", joined(&values, " "));
        }
    }
    text += "];\nrates = [diff(air, 1, 2) / step, zeros(size(air, 1), 1)];\n";
    let mut places = Vec::new();
    for k in 0..motion.inputs.len() {
        places.push(format!("air({}, :)", k + 1));
        if motion.has_rate(k) {
            places.push(format!("rates({}, :)", k + 1));
        }
    }
    text += &format!("driven = [{}];\n", places.join("; "));
    text += "% Straight lines between the samples: exact by one exponential, of the states with the air and its rate behind them.\n";
    text += "m = size(air, 1); block = zeros(6 + 2 * m); block(1:6, 1:6) = A6;\n";
    let mut column = 1;
    for k in 1..=motion.inputs.len() {
        text += &format!("block(1:6, 6 + {k}) = B6(:, {column}); block(6 + {k}, 6 + m + {k}) = 1;\n");
        column += 1;
        if motion.has_rate(k - 1) {
            text += &format!("block(1:6, 6 + m + {k}) = B6(:, {column});\n");
            column += 1;
        }
    }
    text + "\
one_step = expm(block * step); one_step = one_step(1:6, :);
times = step * (0:size(air, 2) - 1)'; outputs = zeros(numel(times), size(C6, 1));
for k = 1:numel(times)
    outputs(k, :) = (C6 * x + D6 * driven(:, k))';
    x = one_step * [x; air(:, k); rates(:, k)];
end

"
}

fn compare_motion(motion: &MotionStudy) -> String {
    let mut text =
        String::from("%% Compared with Eigenwing: a row for each output, a column for each time\n");
    text += &format!("check_times = {};\n", vector(&motion.checks));
    let rows: Vec<&Vec<f64>> = motion.outputs.iter().map(|output| &output.checks).collect();
    let largest: Vec<f64> = motion.outputs.iter().map(|output| output.largest).collect();
    text += &format!("expected = {};\nlargest = {};\n", matrix(&rows), vector(&largest));
    text += "for k = 1:numel(check_times)\n";
    text += match motion.course {
        Course::Sampled(_) => "    found = outputs(round(check_times(k) / step) + 1, :);\n",
        Course::Held | Course::Smooth => "    found = ends(find(bounds == check_times(k)) - 1, :);\n",
    };
    text + "    \
    assert(numel(found) == numel(largest) && all(abs(found - expected(:, k)') <= 1e-8 * max(largest, 1e-12)), 'the motion is not that of Eigenwing');
end
fprintf('The motion is that of Eigenwing at %d times, to 1e-8.\\n', numel(check_times));

"
}

fn frequency(study: &FrequencyStudy) -> String {
    let columns: Vec<[f64; 2]> = (0..6).map(|i| [study.columns[0][i], study.columns[1][i]]).collect();
    let mut text = String::from("%% The frequency response; the second input is the rate of the first\n");
    text += &format!("A6 = {};\nB6 = {};\n", matrix(&study.a), matrix(&columns));
    text += &format!("C6 = {};\nD6 = {};\n", vector(&study.row), vector(&[study.direct.0, study.direct.1]));
    text += &format!(
        "system = ss(A6, B6, C6, D6, 'InputName', {{'{0}', '{0}_rate'}}, 'OutputName', {{'{1}'}});\n",
        study.input.key, study.output.key
    );
    text +=
        "response = @(frequency) (C6 * ((1i * frequency * eye(6) - A6) \\ B6) + D6) * [1; 1i * frequency];\n";
    let rows: Vec<[f64; 3]> = study.checks.iter().map(|&(frequency, re, im)| [frequency, re, im]).collect();
    text += &format!(
        "%% Compared with Eigenwing: frequency [rad/s], real and imaginary part\nexpected = {};\n",
        matrix(&rows)
    );
    text += "\
for k = 1:size(expected, 1)
    value = complex(expected(k, 2), expected(k, 3));
    assert(abs(response(expected(k, 1)) - value) <= 1e-8 * abs(value), 'the response is not that of Eigenwing');
end
fprintf('The frequency response is that of Eigenwing at %d frequencies, to 1e-8.\\n', size(expected, 1));
";
    text += &format!(
        "frequencies = logspace(log10({}), log10({}), 400);\n",
        number(study.range.0),
        number(study.range.1)
    );
    text + "values_there = arrayfun(response, frequencies);\n\n"
}

fn pictures(study: &Study) -> String {
    let mut text = String::from(
        "%% Pictures, where there is something to draw with\n\
         if exist('OCTAVE_VERSION', 'builtin') && isempty(available_graphics_toolkits()), return; end\n\
         figure; hold on;\nplot(real(values), imag(values), 'x', real(values), -imag(values), 'x', 'MarkerSize', 9, 'LineWidth', 2);\n\
         for k = 1:numel(values), text(real(values(k)), imag(values(k)), ['  ' names{k}]); end\n\
         grid on; xlabel('Re [1/s]'); ylabel('Im [rad/s]');\n",
    );
    if let Some(motion) = &study.motion {
        let labels: Vec<String> = motion
            .outputs
            .iter()
            .map(|output| match output.named.shown {
                "" => output.named.name.to_owned(),
                unit => format!("{} [{unit}]", output.named.name),
            })
            .collect();
        let labels: Vec<&str> = labels.iter().map(String::as_str).collect();
        let factors: Vec<f64> = motion.outputs.iter().map(|output| output.named.per_si).collect();
        text += &format!("labels = {};\nfactors = {};\nfigure;\n", cell(&labels), vector(&factors));
        if motion.portraits.is_empty() {
            text += "for k = 1:numel(labels), subplot(numel(labels), 1, k); plot(times, factors(k) * outputs(:, k)); \
                     grid on; ylabel(labels{k}); end\nxlabel('t [s]');\n";
        }
        for (place, (across, upward)) in motion.portraits.iter().enumerate() {
            let (x, y) = (across + 1, upward + 1);
            text += &format!(
                "subplot(1, {}, {}); plot(factors({x}) * outputs(:, {x}), factors({y}) * outputs(:, {y})); grid on; \
                 xlabel(labels{{{x}}}); ylabel(labels{{{y}}});\n",
                motion.portraits.len(),
                place + 1
            );
        }
    }
    if study.frequency.is_some() {
        text += "\
figure;
subplot(2, 1, 1); loglog(frequencies, abs(values_there)); grid on; ylabel('gain [SI]');
subplot(2, 1, 2); semilogx(frequencies, unwrap(angle(values_there)) * 180 / pi); grid on;
ylabel('phase [deg]'); xlabel('frequency [rad/s]');
";
    }
    text
}
