//! How a scene is looked at, in a link: what an instructor sets before sending it. Only what differs from the page as it opens is
//! written.
//!
//! A value that is no good is left out as a whole, with one sentence.

use super::super::view::{
    Camera, ChartView, Details, Entries, EquationsView, FlightView, Instant, Look, Marks, Overlays, Pace,
    Pane, ResponseView, StandardView, Tab, Turn, View,
};
use super::super::{Hidden, Lock, Page, Parameter, Part, Quantity, Scenario, Stage, parameters};
use super::notice::Notice;
use super::pieces::Pieces;
use super::words;
use crate::few;
use crate::flight::Channel;
use crate::flight::aircraft::plane::Plane;
use crate::flight::motion::outputs::Output;
use crate::key::Keyed;
use crate::number::shortest;

/// Longest time of a playback that a link may tell \[s\]: longer than any motion that is shown.
const LONGEST_TIME: f64 = 1e4;

/// The inputs whose loop can be cut.
const CUT: [Channel; 2] = [Channel::First, Channel::Second];

impl View {
    /// The pieces of a link that differ from the page as it opens.
    pub(super) fn write(&self, scenario: &Scenario) -> Vec<(String, String)> {
        let usual = Self::of(scenario);
        let page = if self.page.is_of(scenario) { self.page } else { usual.page };
        let usual = usual.pieces();
        let pieces = Self { page, ..self.clone() }.pieces();
        pieces.into_iter().filter(|piece| !usual.contains(piece)).collect()
    }

    /// All pieces, in their order.
    fn pieces(&self) -> Vec<(String, String)> {
        let Self {
            stage,
            presents,
            look,
            page,
            maximised,
            shows_open,
            marks,
            details,
            response,
            flight,
            equations,
        } = self;
        let word = |word: Option<&str>| word.unwrap_or_default().to_owned();
        let mut pieces: Vec<(String, String)> = [
            ("page", Some(page.key())),
            ("tab", Some(response.tab.key())),
            ("flight", words::word_of(&words::FLIGHTS, response.nonlinear)),
        ]
        .map(|(key, value)| (key.to_owned(), word(value)))
        .into();
        for plane in Plane::ALL {
            let mut of_plane = |key, outputs: &[Output]| {
                let keys: Vec<&str> = outputs.iter().map(|output| output.key()).collect();
                pieces.push((format!("{}.{key}", plane.short()), keys.join(".")));
            };
            of_plane("show", &response.shown[plane]);
            let portraits = response.portraits[plane].map(|(across, upward)| [across, upward]);
            of_plane("phase", portraits.as_flattened());
            of_plane("frequency_of", &[response.frequency_of[plane]]);
            let cut = Quantity::of_input(plane, CUT[usize::from(response.cuts_second[plane])]);
            pieces.push((format!("{}.loop_of", plane.short()), cut.key.to_owned()));
            let ChartView { measure, over, lines } = &response.chart[plane];
            let lines: Vec<String> = lines.iter().map(|line| shortest(*line)).collect();
            for (key, value) in [
                ("chart", measure.clone()),
                ("over", word(over.map(|parameter| parameter.key))),
                ("lines", lines.join("_")),
            ] {
                pieces.push((format!("{}.{key}", plane.short()), value));
            }
        }
        for (key, value) in [
            ("stage", keys_of(stage.parts())),
            ("offer", stage.offered.join(".")),
            ("hide", keys_of(stage.hidden())),
            ("lock", locks_text(stage)),
            ("type", hundredths(stage.type_size)),
            (words::PRESENT, word(words::word_of(&words::PRESENTS, *presents))),
            (words::LOOK, word(look.map(Keyed::key))),
            ("feedback", word(words::word_of(&words::FEEDBACKS, *shows_open))),
            ("split", word(words::word_of(&words::SPLITS, response.split))),
            ("marks", listed(&words::MARKS, marks.flags())),
            ("details", listed(&words::DETAILS, details.flags())),
            ("pane", word(maximised.map(Keyed::key))),
            ("camera", camera_text(flight.camera)),
            ("drawn", listed(&words::OVERLAYS, flight.overlays.flags())),
            ("turn", flight.turn.map_or_else(String::new, turn_text)),
            ("entries", equations.entries.key().to_owned()),
            ("coloured", word(words::word_of(&words::COLOURED, equations.coloured))),
            ("rate", word(words::word_of(&words::RATES, flight.pace.rate))),
            ("loop", word(words::word_of(&words::LOOPS, flight.pace.is_looping))),
            ("t", hundredths(flight.instant.time)),
            ("play", word(words::word_of(&words::PLAYS, flight.instant.is_playing))),
        ] {
            pieces.push((key.to_owned(), value));
        }
        pieces
    }

    /// Takes its pieces out of a link.
    pub(super) fn read(pieces: &mut Pieces, scenario: &Scenario) -> Self {
        let mut view = Self::of(scenario);
        view.stage = read_stage(pieces, scenario);
        view.presents = pieces.take_word(words::PRESENT, &words::PRESENTS).unwrap_or(view.presents);
        view.look = pieces.take_as(words::LOOK, Look::by_key);
        view.shows_open = pieces.take_word("feedback", &words::FEEDBACKS).unwrap_or(view.shows_open);
        view.response.read(pieces);
        if let Some([approximations, levels]) = pieces.take_as("marks", |text| flags(&words::MARKS, text)) {
            view.marks = Marks { approximations, levels };
        }
        if let Some([shape, levels, approximations]) =
            pieces.take_as("details", |text| flags(&words::DETAILS, text))
        {
            view.details = Details { shape, levels, approximations };
        }
        view.maximised = pieces.take_as("pane", Pane::by_key);
        view.flight.read(pieces);
        let EquationsView { entries, coloured } = &mut view.equations;
        *entries = pieces.take_as("entries", Entries::by_key).unwrap_or(*entries);
        *coloured = pieces.take_word("coloured", &words::COLOURED).unwrap_or(*coloured);
        if let Some(page) = pieces.take_as("page", Page::by_key) {
            if page.is_of(scenario) {
                view.page = page;
            } else {
                let aircraft = scenario.aircraft.name.clone();
                pieces.notices.push(Notice::Page { page, aircraft });
            }
        }
        let response = &mut view.response;
        response.tab = pieces.take_as("tab", Tab::by_key).unwrap_or(response.tab);
        response.nonlinear = pieces.take_word("flight", &words::FLIGHTS).unwrap_or(response.nonlinear);
        view
    }
}

impl ResponseView {
    /// Takes what there is one a plane, and whether motions are split.
    fn read(&mut self, pieces: &mut Pieces) {
        for plane in Plane::ALL {
            let key = |key| format!("{}.{key}", plane.short());
            if let Some(mut shown) = pieces.take_as(&key("show"), |text| outputs(plane, text)) {
                // In the order of the page, whatever the order of the link.
                few::sort_by_key(&mut shown, |output| {
                    Output::of(plane).iter().position(|other| other == output)
                });
                shown.dedup();
                self.shown[plane] = shown;
            }
            let four = |text: &str| <[Output; 4]>::try_from(outputs(plane, text)?).ok();
            if let Some([a, b, c, d]) = pieces.take_as(&key("phase"), four) {
                self.portraits[plane] = [(a, b), (c, d)];
            }
            let one = |text: &str| <[Output; 1]>::try_from(outputs(plane, text)?).ok();
            if let Some([output]) = pieces.take_as(&key("frequency_of"), one) {
                self.frequency_of[plane] = output;
            }
            let input =
                |text: &str| CUT.iter().position(|&channel| Quantity::of_input(plane, channel).key == text);
            if let Some(input) = pieces.take_as(&key("loop_of"), input) {
                self.cuts_second[plane] = input == 1;
            }
            let chart = &mut self.chart[plane];
            let is_key = |c: char| c.is_ascii_alphanumeric() || matches!(c, '_' | '.' | '-');
            let measure =
                |text: &str| (!text.is_empty() && text.chars().all(is_key)).then(|| text.to_lowercase());
            chart.measure = pieces.take_as(&key("chart"), measure).unwrap_or_else(|| chart.measure.clone());
            let slider = |text: &str| Parameter::find(text).filter(|parameter| parameter.page.is_some());
            chart.over = pieces.take_as(&key("over"), slider);
            chart.lines = pieces.take_as(&key("lines"), read_lines).unwrap_or_default();
        }
        self.split = pieces.take_word("split", &words::SPLITS).unwrap_or(self.split);
    }
}

impl FlightView {
    fn read(&mut self, pieces: &mut Pieces) {
        self.camera = pieces.take_as("camera", read_camera).unwrap_or_default();
        if let Some([body_axes, earth_axes, angles, rates, forces, flow, path, moments, stability_axes]) =
            pieces.take_as("drawn", |text| flags(&words::OVERLAYS, text))
        {
            self.overlays = Overlays {
                body_axes,
                earth_axes,
                angles,
                rates,
                forces,
                flow,
                path,
                moments,
                stability_axes,
            };
        }
        self.turn = pieces.take_as("turn", read_turn);
        let Pace { rate, is_looping } = &mut self.pace;
        *rate = pieces.take_word("rate", &words::RATES).unwrap_or(*rate);
        *is_looping = pieces.take_word("loop", &words::LOOPS).unwrap_or(*is_looping);
        let Instant { time, is_playing } = &mut self.instant;
        *time = pieces.take_as("t", read_time).unwrap_or(*time);
        *is_playing = pieces.take_word("play", &words::PLAYS).unwrap_or(*is_playing);
    }
}

impl Marks {
    const fn flags(self) -> [bool; 2] {
        [self.approximations, self.levels]
    }
}

impl Details {
    const fn flags(self) -> [bool; 3] {
        [self.shape, self.levels, self.approximations]
    }
}

impl Overlays {
    const fn flags(self) -> [bool; 9] {
        let Self { body_axes, earth_axes, angles, rates, forces, flow, path, moments, stability_axes } = self;
        [body_axes, earth_axes, angles, rates, forces, flow, path, moments, stability_axes]
    }
}

/// In hundredths: of a second, finer than a frame of a screen; of a factor on type, finer than a pixel.
fn hundredths(number: f64) -> String {
    ((100.0 * number).round() / 100.0).to_string()
}

fn read_time(text: &str) -> Option<f64> {
    text.parse().ok().filter(|time| (0.0..=LONGEST_TIME).contains(time))
}

fn read_type_size(text: &str) -> Option<f64> {
    let [least, most] = Stage::TYPE_SIZES;
    let size = text.parse().ok().filter(|size| (least..=most).contains(size))?;
    hundredths(size).parse().ok()
}

/// Values of a measure in SI; a point between them would be one of theirs.
fn read_lines(text: &str) -> Option<Vec<f64>> {
    let lines = text.split('_').map(|line| line.parse().ok().filter(|x: &f64| x.is_finite()));
    lines.collect::<Option<Vec<f64>>>().filter(|lines| lines.len() <= ChartView::MOST_LINES)
}

/// A standard view by its word, any other in whole degrees and per cent: short, and the same in every browser.
fn camera_text(camera: Camera) -> String {
    let standard = StandardView::ALL.into_iter().find(|view| view.camera() == camera);
    match standard {
        Some(view) => view.key().to_owned(),
        None => {
            let [azimuth, elevation] =
                [camera.azimuth, camera.elevation].map(|x| x.to_degrees().round() as i32);
            format!("{azimuth}.{elevation}.{}", (100.0 * camera.distance).round() as i32)
        }
    }
}

fn read_camera(text: &str) -> Option<Camera> {
    if let Some(standard) = StandardView::by_key(text) {
        return Some(standard.camera());
    }
    let numbers: Vec<i32> = text.split('.').map(|part| part.parse().ok()).collect::<Option<_>>()?;
    let [azimuth, elevation, distance] = numbers[..] else { return None };
    let fits = (-180..=180).contains(&azimuth)
        && (-29..=90).contains(&elevation)
        && (50..=100_000).contains(&distance);
    let [azimuth, elevation] = [azimuth, elevation].map(|x| (x as f32).to_radians());
    fits.then(|| Camera::new(azimuth, elevation, distance as f32 / 100.0))
}

/// ψ, θ and φ in the order in which they turn.
fn turn_text(Turn { psi, theta, phi }: Turn) -> String {
    format!("{psi}.{theta}.{phi}")
}

fn read_turn(text: &str) -> Option<Turn> {
    let angles: Vec<i16> = text.split('.').map(|part| part.parse().ok()).collect::<Option<_>>()?;
    let [psi, theta, phi] = angles[..] else { return None };
    let fits = |(angle, largest): (&i16, i16)| (-largest..=largest).contains(angle);
    angles.iter().zip(Turn::LARGEST).all(fits).then_some(Turn { psi, theta, phi })
}

/// Outputs of a plane, joined by points.
fn outputs(plane: Plane, text: &str) -> Option<Vec<Output>> {
    text.split('.').map(|key| Output::by_key(key).filter(|output| output.plane() == plane)).collect()
}

/// Keys joined by points.
fn keys_of<T: Keyed>(values: &[T]) -> String {
    values.iter().map(|value| value.key()).collect::<Vec<_>>().join(".")
}

/// What is locked: first what has a word, then single parameters.
fn locks_text(stage: &Stage) -> String {
    let words = stage.locks().iter().map(|lock| lock.key());
    words.chain(stage.locked.iter().copied()).collect::<Vec<_>>().join(".")
}

/// What of the page is on, hidden and locked.
fn read_stage(pieces: &mut Pieces, scenario: &Scenario) -> Stage {
    let is_slider = |p: &Parameter| !p.is_of_disturbance() && p.applies(scenario);
    let parts = pieces.take_list("stage", &words_of::<Part>(), Part::by_key);
    let offered = pieces
        .take_list("offer", &keys_where(is_slider), |key| Parameter::find(key).filter(|p| is_slider(p)));
    let hidden = pieces.take_list("hide", &words_of::<Hidden>(), Hidden::by_key);
    let can_lock = |p: &Parameter| Stage::can_lock(p, scenario);
    let known: Vec<&str> = words_of::<Lock>().into_iter().chain(keys_where(can_lock)).collect();
    let locked = pieces.take_list("lock", &known, |word| {
        let (lock, parameter) = (Lock::by_key(word), Parameter::find(word).filter(|p| can_lock(p)));
        (lock.is_some() || parameter.is_some()).then_some((lock, parameter))
    });
    let locks = locked.iter().filter_map(|(lock, _)| *lock).collect();
    let locked: Vec<&Parameter> = locked.iter().filter_map(|(_, parameter)| *parameter).collect();
    let mut stage = Stage::with(parts).hiding(hidden).locking(locks);
    stage.offered = in_order_of_table(&offered);
    stage.locked = in_order_of_table(&locked);
    stage.type_size = pieces.take_as("type", read_type_size).unwrap_or(stage.type_size);
    stage
}

fn words_of<T: Keyed>() -> Vec<&'static str> {
    T::VALUES.iter().map(|value| value.key()).collect()
}

fn keys_where(fits: impl Fn(&Parameter) -> bool) -> Vec<&'static str> {
    parameters().filter(|p| fits(p)).map(|p| p.key).collect()
}

/// Keys of parameters, each once.
fn in_order_of_table(named: &[&Parameter]) -> Vec<&'static str> {
    keys_where(|p| named.iter().any(|other| other.key == p.key))
}

/// The words of what is on, joined by points.
fn listed<const N: usize>(words: &[&str; N], flags: [bool; N]) -> String {
    let on: Vec<&str> = words.iter().zip(flags).filter(|(_, on)| *on).map(|(word, _)| *word).collect();
    if on.is_empty() { words::NOTHING.to_owned() } else { on.join(".") }
}

fn flags<const N: usize>(words: &[&str; N], text: &str) -> Option<[bool; N]> {
    let mut flags = [false; N];
    if text == words::NOTHING {
        return Some(flags);
    }
    for part in text.split('.') {
        flags[words.iter().position(|word| *word == part)?] = true;
    }
    Some(flags)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rounded once, a camera is the same however often it is sent on.
    #[test]
    fn a_camera_that_has_been_sent_stays_where_it_is() {
        let sent = |camera| read_camera(&camera_text(camera)).expect("a camera");
        let mut camera = Camera::default();
        for step in 0..200 {
            camera.orbit(0.37, if step % 40 < 20 { 0.13 } else { -0.19 });
            camera.zoom(if step % 14 < 7 { 1.4 } else { 0.7 });
            let once = sent(camera);
            assert_eq!(sent(once), once, "{camera:?}");
            assert!((once.elevation - camera.elevation).abs() < 0.01, "{camera:?} {once:?}");
            assert!((once.azimuth - camera.azimuth).abs() < 0.01, "{camera:?} {once:?}");
            assert!((once.distance - camera.distance).abs() < 0.006, "{camera:?} {once:?}");
        }
        for view in StandardView::ALL {
            assert_eq!(sent(view.camera()), view.camera());
        }
    }
}
