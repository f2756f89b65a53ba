//! Phase portraits: one quantity over another, time only along the path.

use egui::Ui;

use super::legend::{self, Entry, Mark};
use super::studied::{Studied, units};
use super::time::grid;
use super::{Basis, Seen, kept, output_ui};
use crate::flight::aircraft::plane::{ByPlane, Plane};
use crate::flight::motion::outputs::Output;
use crate::scenario::link::Sight;
use crate::ui::chart::{Curve, Pattern, Picture, PlotPoint, SmallPlot};

/// Samples in a turn of the fastest mode: with fewer a portrait would look like a polygon, since it shows each turn large,
/// however many there are.
const SAMPLES_A_TURN: f64 = 128.0;
/// No sample is divided into more than these.
const MOST_PARTS: f64 = 16.0;

/// Two portraits of each plane.
#[derive(Debug)]
pub struct PhasePlots {
    /// (over, of): one for the fast mode, one for the slow.
    pub pairs: ByPlane<[(Output, Output); 2]>,
    plots: [SmallPlot; 2],
    pictures: Option<(Key, [Picture; 2])>,
}

type Key = (Basis, [(Output, Output); 2]);

impl Default for PhasePlots {
    fn default() -> Self {
        Self { pairs: Sight::default().portraits, plots: Default::default(), pictures: None }
    }
}

impl PhasePlots {
    /// Which pairs.
    pub fn choosers_ui(&mut self, ui: &mut Ui, plane: Plane) {
        let names = [
            ("Left portrait, upward", "Left portrait, across"),
            ("Right portrait, upward", "Right portrait, across"),
        ];
        for ((over, of), (upward, across)) in self.pairs[plane].iter_mut().zip(names) {
            output_ui(ui, upward, plane, of);
            ui.label("against");
            output_ui(ui, across, plane, over);
            ui.add_space(12.0);
        }
    }

    /// Draws both portraits, with a dot where the motion is at the time `cursor` \[s\].
    pub fn show(&mut self, ui: &mut Ui, seen: Seen<'_>, cursor: Option<f64>) {
        let Seen { studied, palette, .. } = seen;
        let pairs = self.pairs[studied.plane()];
        let key = (Basis::of(seen), pairs);
        let pictures = kept(&mut self.pictures, key, || pairs.map(|pair| portrait(seen, pair)));
        for picture in pictures.iter_mut() {
            let now = cursor.and_then(|time| {
                let k = (time / studied.motion.response.dt).round() as usize * parts(studied);
                picture.curves.first()?.drawn_part().get(k).copied()
            });
            picture.dots = vec![(PlotPoint::new(0.0, 0.0), palette.weak)];
            picture.dots.extend(now.map(|place| (place, palette.text)));
        }
        let mut entries = legend::curves(pictures);
        let dot = |color, name: &str| Entry { mark: Mark::Dot, color, name: name.to_owned() };
        entries.push(dot(palette.weak, "steady flight"));
        if pictures.iter().any(|picture| picture.dots.len() > 1) {
            entries.push(dot(palette.text, "at the cursor"));
        }
        legend::legend_ui(ui, &entries, seen.beside);
        let places = grid(ui, pairs.len(), seen.rows);
        for ((plot, picture), place) in self.plots.iter_mut().zip(pictures).zip(places) {
            plot.show(ui, place, picture, None);
        }
    }
}

/// One quantity over another, without its dots.
fn portrait(seen: Seen<'_>, (over, of): (Output, Output)) -> Picture {
    let Seen { studied, ghost, palette, .. } = seen;
    let (across, across_unit, across_si) = units(over, studied.scenario);
    let (upward, upward_unit, upward_si) = units(of, studied.scenario);
    let path = |studied: Studied<'_>, name, color, pattern| {
        let motion = &studied.motion.refined(parts(studied));
        let studied = Studied { motion, ..studied };
        let values = studied.motion.values(over).into_iter().zip(studied.motion.values(of));
        let points = values.map(|(x, y)| PlotPoint::new(x / across_si, y / upward_si)).collect();
        Curve::new(name, points, color, pattern).drawn_for(studied.small())
    };
    let mut curves = vec![path(studied, "linear", palette.text, Pattern::Full)];
    if let (Some(x), Some(y)) =
        (studied.flown(over, across_si, palette), studied.flown(of, upward_si, palette))
    {
        let points = x.points.iter().zip(&y.points).map(|(x, y)| PlotPoint::new(x.y, y.y)).collect();
        curves.push(Curve::new(x.name, points, x.color, x.pattern));
    }
    if let Some(ghost) = ghost {
        curves.push(path(ghost, "pinned", palette.ghost, Pattern::Dashed));
    }
    Picture { against: (across.symbol, across_unit), ..Picture::of_time(upward.symbol, upward_unit, curves) }
}

/// Into how many parts a sample is divided, so that the fastest mode is seen to turn.
fn parts(studied: Studied<'_>) -> usize {
    let fastest = studied.modes.iter().map(|mode| mode.lambda.norm()).fold(0.0, f64::max);
    let turns_a_sample = fastest * studied.motion.response.dt / std::f64::consts::TAU;
    (SAMPLES_A_TURN * turns_a_sample).ceil().clamp(1.0, MOST_PARTS) as usize
}
