//! A task: its goal, how near each of its conditions is, hints one at a time, and a solution last.

use std::time::Duration;

use egui::{RichText, Ui};

use super::Wish;
use super::solution::Played;
use super::text::{Context, text_ui};
use super::way::way_ui;
use crate::findings::Findings;
use crate::findings::measures::{Measure, Reading};
use crate::lesson::{Condition, Given, Move, Progress, SolutionAfter, Task, moves, progress, said};
use crate::scenario::Hidden;
use crate::ui::curtain::Curtain;
use crate::ui::symbol::prose;
use crate::ui::theme::{self, Palette};
use crate::words;

/// A scene is a try once it has been left as it is for so long \[s\].
const RESTS: f64 = 0.8;

/// A task on screen: what has been tried, and its solution where that is played.
#[derive(Debug, Default)]
pub struct Tried {
    /// What is moved, and since when it is as it is \[s\].
    last: Option<(Vec<Move>, f64)>,
    /// What was moved in the last try.
    counted: Vec<Move>,
    played: Option<Played>,
}

impl Tried {
    /// Counts a scene that is left as it is and doesn't reach the goal.
    fn count(&mut self, ui: &Ui, given: &mut Given, start: &Findings, now: &Findings) {
        let moved = moves(start.scenario(), now.scenario());
        let time = ui.input(|input| input.time);
        let since = match &self.last {
            Some((last, since)) if *last == moved => *since,
            _ => {
                self.last = Some((moved.clone(), time));
                time
            }
        };
        if moved.is_empty() || moved == self.counted {
            return;
        }
        let left = RESTS - (time - since);
        if left > 0.0 || ui.input(|input| input.pointer.any_down()) {
            ui.request_repaint_after(Duration::from_secs_f64(left.max(0.1)));
            return;
        }
        self.counted = moved;
        given.tries = given.tries.saturating_add(1);
    }
}

/// Draws a task; gives the scene that the person asks for, if they do.
pub fn task_ui(
    ui: &mut Ui,
    task: &Task,
    given: &mut Given,
    tried: &mut Tried,
    now: &Findings,
    context: Context<'_>,
) -> Option<Wish> {
    let palette = Palette::of(ui);
    let mut wish = text_ui(ui, &task.goal, context);
    for (condition, progress) in task.until.iter().zip(progress(task, context.start, now, context.aircraft)) {
        condition_ui(ui, condition, &progress, context);
    }
    if let Some(most) = task.changes {
        let text = match most {
            1 => "Only one slider may differ from the start.".to_owned(),
            most => format!("No more than {most} sliders may differ from the start."),
        };
        ui.label(RichText::new(text).font(theme::small()).color(palette.weak));
    }
    if let Some(worth) = said::worth_of_task(task, given) {
        ui.label(RichText::new(worth).font(theme::small()).color(palette.weak));
    }
    let is_met = task.is_met(context.start, now, context.aircraft);
    // What doesn't count is told where it would be taken for done.
    if !is_met
        && progress(task, context.start, now, context.aircraft).iter().all(|progress| progress.met)
        && let Some(unfit) = task.unfit(context.start, now)
    {
        ui.label(RichText::new(said::unfit(&unfit)).font(theme::small()).color(palette.warning));
    }
    if is_met {
        given.reached = true;
        let done = RichText::new("✓ Done").font(theme::semibold(theme::sizes(ui).value));
        ui.label(done.color(palette.good));
    } else if tried.played.is_none() {
        tried.count(ui, given, context.start, now);
    }
    for hint in task.hints.iter().take(given.hints) {
        wish = text_ui(ui, hint, context).or(wish);
    }
    if let Some(played) = &mut tried.played {
        let (scene, is_over) = played.ui(ui);
        if is_over {
            tried.played = None;
        }
        return scene.or(wish);
    }
    ui.horizontal_wrapped(|ui| {
        // Where a hint costs the points, nobody loses them by one that is of no use any more.
        let may_ask = given.hints < task.hints.len() && !(task.unaided && given.reached);
        if may_ask && ui.button("Give me a hint").clicked() {
            given.hints += 1;
        }
        wish = solution_ui(ui, task, given, tried, now, context).or(wish.take());
        if ui.button("Begin again").clicked() {
            wish = Some(Wish::Step);
        }
    });
    wish
}

/// The button that plays the solution, once all hints were shown and there have been tries enough; before, how many are to come.
fn solution_ui(
    ui: &mut Ui,
    task: &Task,
    given: &mut Given,
    tried: &mut Tried,
    now: &Findings,
    context: Context<'_>,
) -> Option<Wish> {
    let (SolutionAfter::Tries(tries), Some(solution)) = (task.solution_after, &task.solution) else {
        return None;
    };
    if given.hints < task.hints.len() {
        return None;
    }
    let left = tries.saturating_sub(given.tries);
    if left > 0 && !given.reached {
        let text = match left {
            1 => "A solution comes after one more try.".to_owned(),
            left => format!("A solution comes after {left} more tries."),
        };
        ui.label(RichText::new(text).font(theme::small()).color(Palette::of(ui).weak));
        return None;
    }
    if ui.button("Show a solution").clicked() {
        let solved = solution.open(context.aircraft)?.scenario;
        given.solution_shown |= !given.reached;
        tried.played = Some(Played::begin(ui, now, solved));
        ui.request_repaint();
    }
    None
}

/// A condition: what it measures, from where it comes, where it is and where it is to go.
fn condition_ui(ui: &mut Ui, condition: &Condition, progress: &Progress, context: Context<'_>) {
    let palette = Palette::of(ui);
    let convention = context.start.scenario().convention();
    let measure = condition.measure;
    let now = match &progress.now {
        Ok(reading) => words::measure::reading(measure, *reading, convention),
        Err(absence) => words::measure::absence(absence, convention.length),
    };
    let wanted = said::wanted(measure, &condition.wanted, progress, convention);
    let mark = if progress.met { "✓" } else { "○" };
    let color = if progress.met { palette.good } else { palette.text };
    // Of a number that is hidden only whether it is what is wanted.
    let hidden = match (measure, &progress.now) {
        (Measure::OfParameter(_), _) => None,
        (_, Ok(Reading::Stability(_))) => Some(Hidden::Verdicts),
        (_, Ok(Reading::Level(_))) => Some(Hidden::Levels),
        (_, Ok(Reading::Number(_)) | Err(_)) => Some(Hidden::Numbers),
    };
    let is_hidden = hidden.is_some_and(|hidden| Curtain::of(ui).hides(hidden));
    let text = if is_hidden {
        format!("{mark} {}: wanted {wanted}", words::measure::name(measure))
    } else {
        let name = words::measure::name(measure);
        let start = progress.start.as_ref().map(|start| words::measure::reading(measure, *start, convention));
        match &start {
            Ok(start) if *start != now => {
                format!("{mark} {name}: {now}, at the start {start}, wanted {wanted}")
            }
            _ => format!("{mark} {name}: {now}, wanted {wanted}"),
        }
    };
    ui.label(prose(&text, theme::small(), color));
    let numbers = (&progress.start, &progress.now, progress.wanted);
    if let (Ok(Reading::Number(start)), Ok(Reading::Number(now)), Some(wanted)) = numbers
        && !is_hidden
    {
        way_ui(ui, progress, *start, *now, wanted);
    }
}
