//! What one frame of the interface costs while a slider is dragged, as the page opens and with everything open:
//! the frame itself with all that follows from the slider, and its triangles.

use criterion::{Criterion, criterion_group, criterion_main};
use egui::accesskit::Role;
use egui::{Pos2, Rect, Vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use eigenwing::ui::App;

type Page = Harness<'static, Option<App>>;

fn page() -> Page {
    let mut harness = Harness::builder().with_size(Vec2::new(1440.0, 900.0)).build_ui_state(
        |ui, app: &mut Option<App>| {
            app.get_or_insert_with(|| App::new(ui.ctx()).expect("an aircraft")).ui(ui)
        },
        None,
    );
    harness.run();
    harness
}

/// Presses a button or ticks a box.
fn press(page: &mut Page, label: &str) {
    page.get_all_by_label(label).last().expect("it is on the page").click();
    page.run_ok();
}

fn everything() -> Page {
    let mut page = page();
    page.key_press(egui::Key::G);
    page.run_ok();
    for mode in ["Short period", "Phugoid"] {
        for what in ["Shape of the", "Level of the", "Approximations of the"] {
            press(&mut page, &format!("{what} {mode}"));
        }
    }
    for what in ["Level boundaries", "Textbook approximations", "Nonlinear", "Split into modes"] {
        press(&mut page, what);
    }
    page
}

/// Puts the pointer on a slider and holds it; gives its place.
fn hold(page: &mut Page) -> Rect {
    let place = page.get_by_role_and_label(Role::Slider, "pitch stiffness C_mα").rect();
    page.drag_at(place.center());
    page.run_ok();
    place
}

fn frames(criterion: &mut Criterion) {
    for (name, mut page) in [("as opened", page()), ("everything open", everything())] {
        let place = hold(&mut page);
        let mut k = 0.0_f32;
        let mut frame = |page: &mut Page| {
            k += 1.0;
            let x = place.center().x + 0.25 * place.width() * (k / 5.0).sin();
            page.input_mut().events.push(egui::Event::PointerMoved(Pos2::new(x, place.center().y)));
            page.step();
        };
        criterion
            .bench_function(&format!("frame of a drag, {name}"), |bench| bench.iter(|| frame(&mut page)));
        frame(&mut page);
        let shapes = page.output().shapes.clone();
        let triangles = page.ctx.tessellate(shapes.clone(), 1.0);
        let vertices: usize = triangles
            .iter()
            .map(|part| match &part.primitive {
                egui::epaint::Primitive::Mesh(mesh) => mesh.vertices.len(),
                egui::epaint::Primitive::Callback(_) => 0,
            })
            .sum();
        println!(
            "{} shapes, {vertices} vertices, {} nodes",
            shapes.len(),
            page.root().children_recursive().count()
        );
        criterion.bench_function(&format!("triangles, {name}"), |bench| {
            bench.iter_batched(
                || shapes.clone(),
                |shapes| page.ctx.tessellate(shapes, 1.0),
                criterion::BatchSize::LargeInput,
            );
        });
    }
}

criterion_group!(benches, frames);
criterion_main!(benches);
