//! Shapes: every aircraft can be drawn, looks like none of the others, and moves its controls the right way.
use eigenwing::content::embedded_aircraft;
use eigenwing::content::shapes::{SHAPES, embedded_shape};
use eigenwing::shape::Model;
#[test]
fn sizes() {
    for (key, _) in SHAPES {
        let shape = embedded_shape(key).expect("listed").unwrap_or_else(|e| panic!("{e}"));
        let t = std::time::Instant::now();
        let model = Model::new(&shape);
        println!("{key}: {} triangles, span {}, {:?} {:?}", model.triangles(), shape.span(), model.bounds(), t.elapsed());
    }
    println!("{}", embedded_aircraft().1.len());
}
