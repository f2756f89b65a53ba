//! The user interface by role and label, without a window. A stand-in until there is one.

use egui_kittest::Harness;

#[test]
fn an_empty_user_interface_settles() {
    let mut harness = Harness::new_ui(|ui| {
        ui.separator();
    });
    harness.run();
}
