//! The application: a window natively, a canvas in a browser.

#[cfg(not(target_arch = "wasm32"))]
fn main() -> eframe::Result {
    let options = eframe::NativeOptions {
        viewport: egui::ViewportBuilder::default().with_title("Eigenwing").with_inner_size([1440.0, 900.0]),
        ..Default::default()
    };
    eframe::run_native(
        "eigenwing",
        options,
        Box::new(|cc| Ok(Box::new(Window(eigenwing::ui::App::new(&cc.egui_ctx)?)))),
    )
}

#[cfg(not(target_arch = "wasm32"))]
struct Window(eigenwing::ui::App);

#[cfg(not(target_arch = "wasm32"))]
impl eframe::App for Window {
    fn ui(&mut self, ui: &mut egui::Ui, _frame: &mut eframe::Frame) {
        self.0.ui(ui);
    }
}

#[cfg(target_arch = "wasm32")]
fn main() {
    eigenwing::web::start();
}
