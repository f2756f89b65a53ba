//! The user interface by role and label, without a window.

use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;

#[test]
fn a_labelled_slider_is_found_by_its_name() {
    let mut value = 0.5;
    let harness = Harness::new_ui(|ui| {
        let name = ui.label("Value");
        ui.add(egui::Slider::new(&mut value, 0.0..=1.0))
            .labelled_by(name.id);
    });
    harness.get_by_role_and_label(egui::accesskit::Role::Slider, "Value");
}
