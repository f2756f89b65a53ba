//! The aircraft pane by role and name, without a window.

use std::sync::LazyLock;

use egui::accesskit::Role;
use egui::{Event, Key, Modifiers, Pos2, TouchPhase, Vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use eigenwing::content::shapes::embedded_shape;
use eigenwing::scenario::view::{FlightView, Overlays, Pace, StandardView};
use eigenwing::shape::{Deflections, Model, Shape};
use eigenwing::ui::App;
use eigenwing::ui::aircraft::{
    AircraftView, Attitude, Axis, Figures, Forces, Moment, Picture, Playback, transport_ui,
};

/// Built once.
static NAVION: LazyLock<(Shape, Model)> = LazyLock::new(|| {
    let shape = embedded_shape("navion").expect("it ships").expect("it reads");
    let model = Model::new(&shape);
    (shape, model)
});

struct Pane {
    attitude: Attitude,
    picture: AircraftView,
    view: FlightView,
    playback: Playback,
    is_installed: bool,
    is_one_mode: bool,
}

impl Pane {
    fn new(attitude: Attitude) -> Self {
        let view = FlightView { pace: Pace { rate: 1.0, is_looping: false }, ..FlightView::default() };
        let (picture, playback) = (AircraftView::default(), Playback::new(60.0));
        Self { attitude, picture, view, playback, is_installed: false, is_one_mode: false }
    }

    fn ui(&mut self, ui: &mut egui::Ui) {
        if !self.is_installed {
            // For its fonts.
            App::new(ui.ctx()).expect("an aircraft");
            self.is_installed = true;
        }
        let path: Vec<[f64; 3]> = (0..100).map(|k| [f64::from(k), 0.0, 0.0]).collect();
        let moments = [Moment { symbol: "M_α α", axis: Axis::Y, size: -0.5, color: egui::Color32::RED }];
        let picture = Picture {
            is_numbered: true,
            shows_path: true,
            name: "Navion",
            model: &NAVION.1,
            finish: NAVION.0.finish,
            attitude: self.attitude,
            figures: Figures { attitude: self.attitude, alpha: 0.05, beta: 0.02, height: 5.0 },
            position: [99.0, 0.0, -5.0],
            steady_position: [99.0, 0.0, 0.0],
            speed: 53.6,
            alpha: 0.05,
            beta: 0.02,
            steady_alpha: 0.05,
            is_turned: false,
            rates: [0.1, 0.1, 0.1],
            deflections: Deflections::default(),
            propeller_angle: 0.0,
            forces: Forces {
                lift: [0.0, 0.0, -1.0],
                weight: [0.0, 0.0, 1.0],
                thrust: [0.12, 0.0, 0.0],
                drag: [-0.12, 0.0, 0.0],
                unit: Some(12_233.0),
                is_drag_known: true,
            },
            path: &path,
            path_reach: 99.0,
            is_far: self.view.camera.is_far(),
            moments: &moments,
            is_one_mode: self.is_one_mode,
            note: Some("Phugoid alone, 8 × as large as it is"),
            is_dimmed: false,
        };
        self.picture.toolbar_ui(ui, &mut self.view);
        transport_ui(ui, &mut self.playback, &mut self.view.pace);
        self.picture.show(ui, &mut self.view, &picture);
    }
}

const BANKED: Attitude = Attitude { phi: -0.0873, theta: 0.0559, psi: 0.0 };

fn pane(attitude: Attitude) -> Harness<'static, Pane> {
    let mut harness = Harness::builder()
        .with_size(Vec2::new(600.0, 450.0))
        .build_ui_state(|ui, pane: &mut Pane| pane.ui(ui), Pane::new(attitude));
    harness.run();
    harness
}

#[test]
fn the_picture_is_told_in_a_sentence() {
    let harness = pane(BANKED);
    let image = harness.get_by_role(Role::Image);
    let sentence = image.accesskit_node().label().expect("a name");
    for words in
        ["Navion: pitch 3.2°, bank −5.0°", "angle of attack 2.9°", "altitude 5.00 m", "Phugoid alone, 8 ×"]
    {
        assert!(sentence.contains(words), "{sentence}");
    }
}

#[test]
fn a_drag_and_the_keys_turn_the_view() {
    let mut harness = pane(BANKED);
    let start = harness.state().view.camera;
    let center = harness.get_by_role(Role::Image).rect().center();
    harness.drag_at(center);
    harness.hover_at(center + Vec2::new(80.0, 20.0));
    harness.run();
    harness.drop_at(center + Vec2::new(80.0, 20.0));
    harness.run();
    let dragged = harness.state().view.camera;
    assert!(dragged.azimuth < start.azimuth && dragged.elevation > start.elevation);

    // It has focus now.
    harness.key_press(Key::ArrowRight);
    harness.key_press(Key::Plus);
    harness.run();
    let turned = harness.state().view.camera;
    assert!(turned.azimuth > dragged.azimuth && turned.distance < dragged.distance);
    harness.key_press(Key::Num2);
    harness.run();
    assert_eq!(harness.state().view.camera, StandardView::Chase.camera());
    harness.get_by_label("View from above").click();
    harness.run();
    assert_eq!(harness.state().view.camera, StandardView::Top.camera());
}

fn wheel(harness: &mut Harness<'_, Pane>, modifiers: Modifiers) {
    let center = harness.get_by_role(Role::Image).rect().center();
    harness.hover_at(center);
    harness.run();
    harness.event_modifiers(
        Event::MouseWheel {
            unit: egui::MouseWheelUnit::Line,
            delta: Vec2::new(0.0, 3.0),
            phase: TouchPhase::Move,
            source: egui::MouseWheelSource::Unknown,
            modifiers,
        },
        modifiers,
    );
    harness.run();
}

#[test]
fn the_wheel_zooms_with_ctrl_only() {
    let mut harness = pane(BANKED);
    let start = harness.state().view.camera;
    wheel(&mut harness, Modifiers::NONE);
    assert_eq!(harness.state().view.camera, start);
    wheel(&mut harness, Modifiers::COMMAND);
    assert!(harness.state().view.camera.distance < start.distance);
}

#[test]
fn the_playback_is_worked_by_name_and_by_keyboard() {
    let mut harness = pane(BANKED);
    harness.get_by_label("Play").focus();
    harness.run();
    harness.key_press(Key::Space);
    harness.run();
    assert!(harness.state().playback.is_playing);
    harness.get_by_label("Pause").click();
    harness.run();
    assert!(!harness.state().playback.is_playing);
    harness.get_by_role_and_label(Role::Slider, "Time of the playback in s").focus();
    harness.run();
    harness.key_press(Key::ArrowRight);
    harness.run();
    let time = harness.state().playback.time;
    assert!(time > 0.0);
    harness.get_by_label("Back to the start").click();
    harness.get_by_label("Begin again at the end").click();
    harness.run();
    assert_eq!((harness.state().playback.time, harness.state().view.pace.is_looping), (0.0, true));
    harness.get_by_role_and_label(Role::ComboBox, "Speed of the playback").click();
    harness.run();
    harness.get_by_label("¼×").click();
    harness.run();
    assert_eq!(harness.state().view.pace.rate, 0.25);
}

#[test]
fn each_overlay_can_be_switched() {
    let mut harness = pane(BANKED);
    let before = harness.state().view.overlays;
    harness.get_by_label_contains("Show").click();
    harness.run();
    let mut all = before;
    for (words, _) in all.boxes() {
        harness.get_by_role_and_label(Role::CheckBox, words).click();
        harness.run();
    }
    let mut after = harness.state().view.overlays;
    let mut before = before;
    for ((words, before), (_, after)) in before.boxes().into_iter().zip(after.boxes()) {
        assert_ne!(before, after, "{words}");
    }
}

/// Whatever comes, a frame is drawn and the next one isn't asked for.
#[test]
fn any_attitude_any_view_and_any_overlay_is_drawn_and_rests() {
    for attitude in [
        Attitude { phi: 3.0, theta: std::f64::consts::FRAC_PI_2, psi: -2.0 },
        Attitude { phi: f64::NAN, theta: f64::INFINITY, psi: 1e300 },
    ] {
        for view in StandardView::ALL {
            let mut harness = pane(attitude);
            harness.state_mut().view.camera = view.camera();
            harness.state_mut().view.overlays = Overlays {
                body_axes: true,
                earth_axes: true,
                angles: true,
                rates: true,
                forces: true,
                flow: true,
                path: true,
                moments: true,
                stability_axes: true,
            };
            harness.run();
            for clipped in &harness.output().shapes {
                if let egui::Shape::Mesh(mesh) = &clipped.shape {
                    let finite = |p: Pos2| p.x.is_finite() && p.y.is_finite();
                    assert!(mesh.vertices.iter().all(|vertex| finite(vertex.pos)), "{attitude:?} {view:?}");
                }
            }
            let delay = harness.output().viewport_output.values().map(|v| v.repaint_delay).min();
            assert!(delay > Some(std::time::Duration::from_secs(1)), "{view:?}: {delay:?}");
        }
    }
}

#[test]
fn one_mode_alone_is_drawn_without_the_forces_unless_a_person_chose_them() {
    let mut harness = pane(BANKED);
    let forces = |harness: &Harness<'static, Pane>| harness.state().view.overlays.forces;
    let fly = |harness: &mut Harness<'static, Pane>, one_mode| {
        harness.state_mut().is_one_mode = one_mode;
        harness.run();
    };
    assert!(forces(&harness));
    fly(&mut harness, true);
    assert!(!forces(&harness));
    fly(&mut harness, false);
    assert!(forces(&harness));
    fly(&mut harness, true);
    harness.get_by_label("Shown on the picture").click();
    harness.run();
    harness.get_by_label("Forces").click();
    harness.run();
    assert!(forces(&harness));
    fly(&mut harness, false);
    fly(&mut harness, true);
    assert!(forces(&harness), "the choice stands");
}

#[test]
fn who_looks_without_forces_does_so_after_a_mode_was_flown_too() {
    let mut harness = pane(BANKED);
    let overlays = Overlays { forces: false, ..Overlays::default() };
    harness.state_mut().view.overlays = overlays;
    harness.state_mut().picture.keep_overlays();
    harness.run();
    for is_one_mode in [true, false] {
        harness.state_mut().is_one_mode = is_one_mode;
        harness.run();
        assert_eq!(harness.state().view.overlays, overlays);
    }
}

#[test]
fn the_whole_path_can_be_brought_into_the_picture() {
    let mut harness = pane(BANKED);
    harness.get_by_label("Shown on the picture").click();
    harness.run();
    harness.get_by_label("See the whole path").click();
    harness.run();
    let camera = harness.state().view.camera;
    // Half of the path has 99 m, the aircraft a radius of 5 to 6 m.
    assert!((15.0..22.0).contains(&camera.distance) && camera.is_far(), "{camera:?}");
    assert!(harness.state().view.overlays.path);
    // And back again.
    harness.get_by_label("View from the right").click();
    harness.run();
    assert!(!harness.state().view.camera.is_far());
}
