//! The reference aircraft of `data/models.json`, for every test that walks them.

#![allow(dead_code, clippy::allow_attributes, reason = "each test file uses a part of it")]

use eigenwing::flight::aircraft::plane::{Plane, PlaneModel, Trim};
use nalgebra::{Complex, Matrix4, Matrix4x2};
use serde::Deserialize;

#[derive(Deserialize)]
struct File {
    models: Vec<Reference>,
}

/// One aircraft in one flight condition.
#[derive(Deserialize)]
pub struct Reference {
    pub id: String,
    pub status: String,
    pub published_modes: Option<serde_json::Value>,
    trim: TrimData,
    longitudinal: Matrices,
    lateral: Matrices,
}

#[derive(Deserialize)]
struct TrimData {
    speed: f64,
    alpha0: f64,
    gamma0: f64,
    gravity: f64,
}

#[derive(Deserialize)]
struct Matrices {
    a: [[f64; 4]; 4],
    b: [[f64; 2]; 4],
}

impl Reference {
    pub fn model(&self, plane: Plane) -> PlaneModel {
        let TrimData { speed, alpha0, gamma0, gravity } = self.trim;
        let matrices = match plane {
            Plane::Longitudinal => &self.longitudinal,
            Plane::Lateral => &self.lateral,
        };
        PlaneModel {
            plane,
            a: Matrix4::from_fn(|i, j| matrices.a[i][j]),
            b: Matrix4x2::from_fn(|i, j| matrices.b[i][j]),
            trim: Trim { speed, alpha0, gamma0, gravity },
            further: None,
        }
    }
}

pub fn references() -> Vec<Reference> {
    let file: File = serde_json::from_str(include_str!("../data/models.json")).expect("the data file reads");
    assert_eq!(file.models.len(), 16);
    file.models
}

pub fn reference(id: &str) -> Reference {
    references().into_iter().find(|r| r.id == id).expect("a reference of that id")
}

/// Every reference aircraft in both planes, with its name.
pub fn all_models() -> Vec<(String, PlaneModel)> {
    let both = |r: &Reference| Plane::ALL.map(|plane| (format!("{} {plane:?}", r.id), r.model(plane)));
    references().iter().flat_map(both).collect()
}

/// The Navion of the sweeps with its M_w, as the report counts it, multiplied by `factor`; ẇ stays as it is.
pub fn navion_with_m_w(factor: f64) -> Matrix4<f64> {
    let mut a = reference("navion_teper_sl").model(Plane::Longitudinal).a;
    a[(2, 1)] += (factor - 1.0) * NAVION_M_W;
    a
}

/// M_w of the Navion [1/(m·s)], printed −0.04997 1/(ft·s).
pub const NAVION_M_W: f64 = -0.04997 / 0.3048;

pub fn pole(pair: &[f64; 2]) -> Complex<f64> {
    Complex::new(pair[0], pair[1])
}

/// The sweeps of `data/navion_sweeps.json`.
#[derive(Deserialize)]
pub struct Sweeps {
    #[serde(rename = "Mw_sweep")]
    pub m_w: Vec<SweepPoint>,
    #[serde(rename = "Nbeta_sweep")]
    pub n_beta: Vec<SweepPoint>,
    #[serde(rename = "Lbeta_sweep")]
    pub l_beta: Vec<SweepPoint>,
    #[serde(rename = "manoeuvre_point_Mw")]
    pub manoeuvre_point_m_w: f64,
    pub changes_in_number_of_complex_pairs: Vec<Change>,
    #[serde(rename = "spiral_neutral_Lbeta_factor")]
    pub spiral_neutral_l_beta_factor: f64,
}

#[derive(Deserialize)]
pub struct SweepPoint {
    #[serde(alias = "factor_on_Mw", alias = "factor_on_Nbeta", alias = "factor_on_Lbeta")]
    pub factor: f64,
    pub eigs: Vec<[f64; 2]>,
}

#[derive(Deserialize)]
pub struct Change {
    #[serde(rename = "factor_on_Mw")]
    pub factor: f64,
    pub pairs_before: usize,
    pub pairs_after: usize,
}

pub fn sweeps() -> Sweeps {
    serde_json::from_str(include_str!("../data/navion_sweeps.json")).expect("the data file reads")
}
