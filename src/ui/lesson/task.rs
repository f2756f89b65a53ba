//! A task: its goal, how near each of its conditions is, hints one at a time, and a solution last.

use egui::{ProgressBar, RichText, Ui};

use super::Wish;
use super::text::{Context, text_ui};
use crate::findings::Findings;
use crate::findings::measures::{Measure, Reading};
use crate::lesson::{Condition, Given, Progress, SolutionAfter, Task, Wanted, progress};
use crate::scenario::Hidden;
use crate::ui::curtain::Curtain;
use crate::ui::theme::{self, Palette};
use crate::words;

/// Draws a task; gives its solution as a scene, if the person asks for it.
pub fn task_ui(
    ui: &mut Ui,
    task: &Task,
    given: &mut Given,
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
    if task.is_met(context.start, now, context.aircraft) {
        let done = RichText::new("✓ Done").font(theme::semibold(theme::sizes(ui).value));
        ui.label(done.color(palette.good));
    }
    for hint in task.hints.iter().take(given.hints) {
        wish = text_ui(ui, hint, context).or(wish);
    }
    ui.horizontal_wrapped(|ui| {
        if given.hints < task.hints.len() && ui.button("Give me a hint").clicked() {
            given.hints += 1;
        }
        let may_see = task.solution_after != SolutionAfter::Never && given.hints == task.hints.len();
        if let Some(solution) = task.solution.as_ref().filter(|_| may_see)
            && ui.button("Show a solution").clicked()
        {
            wish = Some(Wish::Scene(solution.link.clone()));
        }
        if ui.button("Begin again").clicked() {
            wish = Some(Wish::Step);
        }
    });
    wish
}

/// A condition: what it measures, from where it comes, where it is and where it is to go.
fn condition_ui(ui: &mut Ui, condition: &Condition, progress: &Progress, context: Context<'_>) {
    let palette = Palette::of(ui);
    let length = context.start.scenario().aircraft.length_unit;
    let measure = condition.measure;
    let now = match &progress.now {
        Ok(reading) => words::measure::reading(measure, *reading, length),
        Err(absence) => words::measure::absence(absence),
    };
    let number = |value: f64| words::measure::number(measure.dimension(), value, length);
    let wanted = match (&condition.wanted, progress.wanted) {
        (Wanted::Stability(stability), _) => words::measure::word(*stability).to_owned(),
        (Wanted::Level(level), _) => format!("{} or better", words::verdict::level(*level)),
        (Wanted::Absent, _) => "none".to_owned(),
        (_, Some((low, high))) if high == f64::INFINITY => format!("at least {}", number(low)),
        (_, Some((low, high))) if low == f64::NEG_INFINITY => format!("at most {}", number(high)),
        (_, Some((low, high))) => format!("{} to {}", number(low), number(high)),
        (_, None) => "–".to_owned(),
    };
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
        format!("{mark} {}: {now}, wanted {wanted}", words::measure::name(measure))
    };
    ui.label(RichText::new(text).font(theme::small()).color(color));
    if progress.share > 0.0 && !progress.met && !is_hidden {
        ui.add(ProgressBar::new(progress.share as f32).desired_height(6.0));
    }
}
