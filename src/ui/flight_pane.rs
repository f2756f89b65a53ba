//! The aircraft pane: the motion on screen flown by the aircraft, played, paused and scrubbed.

use std::collections::HashMap;

use egui::Ui;

use super::aircraft::{
    AircraftView, Attitude, Axis, Figures, Forces, Moment, Picture, Playback, transport_height, transport_ui,
    turn_height, turn_ui,
};
use super::curtain::Curtain;
use super::theme::{self, Palette};
use crate::content::shapes::embedded_shape;
use crate::findings::{Pose, Trajectory};
use crate::number::trimmed;
use crate::scenario::view::{FlightView, Instant, Pace, Turn};
use crate::scenario::{Hidden, Lock};
use crate::shape::{Deflections, Finish, Model};
use crate::words;

/// Length of the path behind the aircraft \[s\].
const PATH: f64 = 8.0;
/// A frame that took longer than this \[s\] was none: the page was hidden.
const LONGEST_FRAME: f64 = 1.0;
/// Least height of the picture of an aircraft that is turned by hand \[points\]; in less room it scrolls with its sliders.
const LEAST_TURNED: f32 = 120.0;
/// The propeller turns so fast on screen \[rad/s\]: slowly enough to be seen turning.
const PROPELLER: f64 = 14.0;

/// Where the playback of the flight is, and what has been drawn of it.
#[derive(Debug)]
pub struct FlightPane {
    picture: AircraftView,
    playback: Playback,
    /// Real time at which it was last advanced \[s\], while it plays.
    advanced: Option<f64>,
    /// The faces of the shapes drawn so far.
    models: Models,
    /// The symbol that a sentence is said of, where it is turned by hand.
    explained: &'static str,
    /// What a drag has left of a whole degree of ψ, θ and φ.
    rest: [f32; 3],
}

impl Default for FlightPane {
    fn default() -> Self {
        Self {
            picture: AircraftView::default(),
            playback: Playback::new(0.0),
            advanced: None,
            models: HashMap::new(),
            explained: words::turn::EXPLAINED[0],
            rest: [0.0; 3],
        }
    }
}

impl FlightPane {
    /// Draws the overlays next as they are, as a link says.
    pub fn keep_overlays(&mut self) {
        self.picture.keep_overlays();
    }

    /// Time of the playback \[s\].
    pub fn time(&self) -> f64 {
        self.playback.time
    }

    /// Shows another moment \[s\], if it is not playing.
    pub fn seek(&mut self, time: f64) {
        if !self.playback.is_playing {
            self.playback.seek(time);
        }
    }

    /// Where it is: in a motion that plays, the beginning, where whoever opens the scene begins.
    pub fn instant(&self) -> Instant {
        let Playback { time, is_playing, .. } = self.playback;
        Instant { time: if is_playing { 0.0 } else { time }, is_playing }
    }

    /// Goes to an instant of another motion, or to its end where it is shorter.
    pub fn begin(&mut self, Instant { time, is_playing }: Instant) {
        self.playback.time = time;
        self.playback.is_playing = is_playing;
        self.advanced = None;
    }

    /// Plays from the beginning.
    pub fn start(&mut self) {
        self.playback.time = 0.0;
        self.playback.is_playing = true;
    }

    /// Stands still.
    pub fn pause(&mut self) {
        self.playback.is_playing = false;
    }

    /// Plays, or pauses.
    pub fn toggle(&mut self) {
        self.playback.toggle();
    }

    /// Lets time go on, where it is playing, through a motion that ends at `end` \[s\].
    pub fn advance(&mut self, ui: &Ui, pace: Pace, end: f64) {
        self.playback.end = end;
        self.playback.time = self.playback.time.min(end);
        if self.playback.is_playing {
            // By the clock, however long a frame takes; but a page that was hidden goes on where it was.
            let now = ui.input(|input| input.time);
            let passed = self.advanced.replace(now).map_or(0.0, |before| now - before);
            self.playback.advance(passed.min(LONGEST_FRAME), pace);
            ui.request_repaint();
        } else {
            self.advanced = None;
        }
    }

    /// Buttons of the standard views, and what to show.
    pub fn toolbar_ui(&mut self, ui: &mut Ui, view: &mut FlightView) {
        Curtain::of(ui).lock_ui(ui, Lock::View, |ui| self.picture.toolbar_ui(ui, view));
    }

    /// Draws the aircraft at the time of the playback, over all the room there is.
    pub fn show(&mut self, ui: &mut Ui, view: &mut FlightView, flown: Trajectory<'_>) {
        let palette = Palette::of(ui);
        let controls = match view.turn {
            _ if theme::is_for_a_room(ui) => 0.0,
            Some(_) => turn_height(ui),
            None => transport_height(ui),
        };
        let least = if view.turn.is_some() { LEAST_TURNED } else { 80.0 };
        let room = (ui.available_height() - controls).max(least);
        let (time, exaggeration) = (self.playback.time, flown.exaggeration());
        let pose = flown.pose(time, exaggeration);
        let own = if exaggeration == 1.0 { pose } else { flown.pose(time, 1.0) };
        let attitude = |[phi, theta, psi]: [f64; 3]| Attitude { phi, theta, psi };
        let Pose { rates, alpha, beta, position, steady_position, .. } = pose;
        let is_far = view.camera.is_far();
        let path = if is_far { flown.whole_path(exaggeration) } else { flown.path(time, PATH, exaggeration) };
        let moments: Vec<Moment<'_>> = flown
            .moments(time)
            .into_iter()
            .map(|moment| Moment {
                symbol: moment.symbol,
                axis: [Axis::X, Axis::Y, Axis::Z][moment.axis],
                size: moment.size,
                color: if moment.damps { palette.good } else { palette.warning },
            })
            .collect();
        let is_dimmed = time > flown.flown_until();
        let time = time.min(flown.flown_until());
        let exaggerated = (exaggeration != 1.0)
            .then(|| format!("Drawn {} times as large; the numbers are true", trimmed(exaggeration, 3)));
        let length = flown.scenario.length_unit();
        let stays =
            is_dimmed.then(|| words::small_disturbance::aircraft_stays(flown.motion, length)).flatten();
        let curtain = Curtain::of(ui);
        let note = stays.filter(|_| !curtain.hides_values()).or(exaggerated);
        let Self { picture: widget, playback, models, explained, rest, .. } = self;
        let Some((model, finish)) = model(models, flown.scenario.aircraft.shape) else { return };
        let [elevator, aileron, rudder] = pose.deflections.map(|x| x as f32);
        let picture = Picture {
            name: curtain.aircraft(&flown.scenario.aircraft.name),
            is_numbered: !curtain.hides(Hidden::Numbers),
            shows_path: !curtain.hides(Hidden::Curves),
            model,
            finish: *finish,
            attitude: attitude(pose.attitude),
            figures: Figures {
                attitude: attitude(own.attitude),
                alpha: own.alpha,
                beta: own.beta,
                height: own.steady_position[2] - own.position[2],
            },
            position,
            steady_position,
            speed: flown.motion.model.trim.speed,
            alpha,
            beta,
            steady_alpha: flown.steady_alpha(),
            is_turned: false,
            rates,
            deflections: Deflections { elevator, aileron, rudder },
            propeller_angle: (PROPELLER * time) as f32,
            forces: {
                let [lift, weight, thrust, drag] = pose.forces;
                let (unit, is_drag_known) = (flown.reference_weight(), flown.is_drag_known());
                Forces { lift, weight, thrust, drag, unit, is_drag_known }
            },
            path: &path,
            path_reach: flown.path_reach(exaggeration),
            is_far,
            moments: &moments,
            is_one_mode: flown.is_one_mode(),
            note: note.as_deref(),
            is_dimmed,
        };
        let picture = view.turn.map_or(picture, |turn| by_hand(picture, turn));
        let width = ui.available_width();
        ui.allocate_ui(egui::Vec2::new(width, room), |ui| {
            ui.set_min_height(room);
            widget.show(ui, view, &picture);
        });
        if let Some(turn) = &mut view.turn {
            *explained = widget.pointed.unwrap_or(explained);
            drag(turn, rest, widget.dragged);
        }
        match &mut view.turn {
            _ if theme::is_for_a_room(ui) => {}
            Some(turn) => {
                let locked = Curtain::of(ui);
                locked.lock_ui(ui, Lock::View, |ui| turn_ui(ui, turn, explained));
            }
            None => transport_ui(ui, playback, &mut view.pace),
        }
    }
}

/// Turns by a drag, in whole degrees.
fn drag(turn: &mut Turn, rest: &mut [f32; 3], dragged: [f32; 3]) {
    let Turn { psi, theta, phi } = turn;
    for (k, angle) in [psi, theta, phi].into_iter().enumerate() {
        rest[k] += dragged[k];
        let whole = rest[k].trunc();
        rest[k] -= whole;
        let largest = f32::from(Turn::LARGEST[k]);
        *angle = (f32::from(*angle) + whole).clamp(-largest, largest) as i16;
    }
}

/// The aircraft where it began, turned by hand, with nothing of its flight.
fn by_hand(picture: Picture<'_>, Turn { psi, theta, phi }: Turn) -> Picture<'_> {
    let [psi, theta, phi] = [psi, theta, phi].map(|angle| f64::from(angle).to_radians());
    let attitude = Attitude { phi, theta, psi };
    Picture {
        attitude,
        figures: Figures { attitude, alpha: 0.0, beta: 0.0, height: 0.0 },
        position: [0.0; 3],
        steady_position: [0.0; 3],
        deflections: Deflections::default(),
        propeller_angle: 0.0,
        path: &[],
        is_far: false,
        is_numbered: true,
        is_turned: true,
        note: Some(words::turn::NOTE),
        is_dimmed: false,
        ..picture
    }
}

type Models = HashMap<&'static str, (Model, Finish)>;

/// The faces of a shape, built when it is first drawn.
fn model<'a>(models: &'a mut Models, shape: &'static str) -> Option<&'a (Model, Finish)> {
    if !models.contains_key(shape) {
        let read = embedded_shape(shape)?.ok()?;
        models.insert(shape, (Model::new(&read), read.finish));
    }
    models.get(shape)
}
