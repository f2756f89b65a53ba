//! Files under tests/data/import, opened as a person does.

use std::collections::BTreeMap;

use eigenwing::content::import::review::{Doubt, Review};
use eigenwing::content::import::{FileBytes, review};
use eigenwing::content::{Aircraft, ContentError};
use eigenwing::flight::aircraft::plane::{Plane, PlaneModel};
use eigenwing::flight::modes::eigen::eigenvalues;
use nalgebra::Complex;

/// What is in a file.
pub fn bytes(name: &str) -> Vec<u8> {
    let path = format!("{}/tests/data/import/{name}", env!("CARGO_MANIFEST_DIR"));
    std::fs::read(&path).unwrap_or_else(|error| panic!("{path}: {error}"))
}

/// Files and fills as they are typed: `units=SI`.
pub fn try_open(names: &[&str], fills: &[&str]) -> Result<Review, ContentError> {
    let contents: Vec<Vec<u8>> = names.iter().map(|name| bytes(name)).collect();
    let files: Vec<FileBytes<'_>> =
        names.iter().zip(&contents).map(|(name, bytes)| FileBytes { name, bytes }).collect();
    let split = |fill: &&str| {
        let (key, value) = fill.split_once('=').expect("key=value");
        (key.to_owned(), value.to_owned())
    };
    review(&files, &fills.iter().map(split).collect::<BTreeMap<_, _>>())
}

pub fn open(names: &[&str], fills: &[&str]) -> Review {
    try_open(names, fills).unwrap_or_else(|error| panic!("{error}"))
}

pub fn aircraft(review: &Review) -> Aircraft {
    review.aircraft().unwrap_or_else(|error| panic!("{error}\n{review:#?}"))
}

pub fn model(review: &Review, plane: Plane) -> PlaneModel {
    let models = aircraft(review).aircraft_model.models().expect("it flies");
    models.planes[plane].clone().unwrap_or_else(|| panic!("{} has no {plane:?} model", review.file))
}

/// The eigenvalues of a plane, the upper of each pair, the fastest first.
pub fn poles(review: &Review, plane: Plane) -> Vec<Complex<f64>> {
    let mut poles = eigenvalues(&model(review, plane).a).expect("they are found").as_slice().to_vec();
    poles.retain(|pole| pole.im >= 0.0);
    poles.sort_by(|x, y| y.norm().total_cmp(&x.norm()));
    poles
}

/// The sentences about what looks wrong.
pub fn doubts(review: &Review) -> Vec<&str> {
    review.doubts.iter().map(|doubt| doubt.sentence.as_str()).collect()
}

/// The one doubt of a kind.
pub fn doubt<'r>(review: &'r Review, key: &str) -> &'r Doubt {
    let found: Vec<&Doubt> = review.doubts.iter().filter(|doubt| doubt.key == key).collect();
    assert_eq!(found.len(), 1, "{key}: {:#?}", review.doubts);
    found[0]
}

/// The remedy of a doubt as it is typed.
pub fn remedy(doubt: &Doubt) -> Vec<String> {
    doubt.remedy.iter().map(|remedy| format!("{}={}", remedy.key, remedy.value)).collect()
}
