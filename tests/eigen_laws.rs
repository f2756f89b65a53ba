//! What holds for the eigenvalues of every matrix (properties), and LAPACK's values for hard ones (validation).

use eigenwing::flight::modes::eigen::{Eigen, EigenError, eigen, eigenvalues};
use nalgebra::{Complex, Matrix4};
use proptest::prelude::*;
use serde::Deserialize;

/// Everything that must be true of an answer. Sizes are relative to ‖A‖ (Frobenius), so that 1e±150 can be squared.
fn assert_laws(a: &Matrix4<f64>) -> Eigen {
    let solved = eigen(a).expect("a finite matrix has eigenvalues");
    let size = a.amax().max(f64::MIN_POSITIVE);
    let unit = a / size;
    let (complex, norm) = (unit.map(Complex::from), unit.norm());
    let values = solved.values.map(|value| value / size);
    for (i, &scaled) in values.iter().enumerate() {
        let (v, l) = (solved.right.column(i), solved.left.column(i));
        assert!((v.norm() - 1.0).abs() < 1e-14 && (l.norm() - 1.0).abs() < 1e-14, "unit vectors of {a}");
        // A v = λ v,  Aᵀ l = λ̄ l
        let right = (complex * v - v * scaled).norm();
        let left = (complex.transpose() * l - l * scaled.conj()).norm();
        assert!(right <= 1e-12 * norm && left <= 1e-12 * norm, "residual {right:e}, {left:e} of {a}");
        let (value, participation) = (solved.values[i], solved.participation(i));
        assert!(participation.iter().all(|p| (0.0..=1.0).contains(p)));
        assert!((participation.iter().sum::<f64>() - 1.0).abs() < 1e-14);
        if value.im > 0.0 {
            assert_eq!(solved.values[i + 1], value.conj(), "pairs of {a}");
            assert_eq!(solved.right.column(i + 1), v.conjugate());
            assert_eq!(solved.left.column(i + 1), l.conjugate());
        } else if value.im < 0.0 {
            assert!(i > 0 && solved.values[i - 1] == value.conj(), "pairs of {a}");
        } else {
            assert!(v.iter().chain(l.iter()).all(|x| x.im == 0.0), "real vectors of {a}");
        }
    }
    // hypot may differ by a rounding from the norm the solver sorted by
    let sorted = values.as_slice().windows(2).all(|pair| pair[0].norm() >= pair[1].norm() * (1.0 - 1e-14));
    assert!(sorted, "largest first: {values:?}");
    // Σλ = tr A, Πλ = det A; A + E with ‖E‖ ≈ 1e-14‖A‖ moves det A by at most about 4‖A‖³‖E‖.
    let (sum, product): (Complex<f64>, Complex<f64>) = (values.iter().sum(), values.iter().product());
    assert!((sum - unit.trace()).norm() <= 1e-13 * norm, "trace of {a}");
    assert!((product - unit.determinant()).norm() <= 1e-12 * norm.powi(4), "determinant of {a}");
    solved
}

fn entries(entry: impl Strategy<Value = f64>) -> impl Strategy<Value = Matrix4<f64>> {
    proptest::collection::vec(entry, 16).prop_map(|entries| Matrix4::from_row_slice(&entries))
}

fn places() -> impl Strategy<Value = Vec<usize>> {
    Just(vec![0, 1, 2, 3]).prop_shuffle()
}

/// The printed lesson model in metres and radians.
fn aircraft() -> Matrix4<f64> {
    Matrix4::from_row_slice(&[
        -0.045, 0.036, 0.0, -9.81, -0.369, -2.02, 53.6, 0.0, 0.00627, -0.13, -2.98, 0.0, 0.0, 0.0, 1.0, 0.0,
    ])
}

fn upper(a: f64, b: f64, c: f64, couplings: &[f64]) -> Matrix4<f64> {
    Matrix4::from_fn(|i, j| match i.cmp(&j) {
        std::cmp::Ordering::Equal => [a, b, c, a][i],
        std::cmp::Ordering::Less => couplings[i + j],
        std::cmp::Ordering::Greater => 0.0,
    })
}

fn matrix() -> impl Strategy<Value = Matrix4<f64>> {
    let many_scales = (-1.0..1.0_f64, -12.0..12.0_f64).prop_map(|(x, power)| x * 10_f64.powf(power));
    let sparse = prop_oneof![4 => Just(0.0), 1 => Just(1.0), 1 => Just(-1.0)];
    let permutation = (places(), proptest::collection::vec(prop_oneof![Just(1.0), Just(-1.0)], 4))
        .prop_map(|(place, sign)| Matrix4::from_fn(|i, j| if place[i] == j { sign[i] } else { 0.0 }));
    let triangle = (-2.0..2.0, prop_oneof![Just(0.0), -2.0..2.0], proptest::collection::vec(-9.0..9.0, 6));
    let defective = (triangle, places()).prop_map(|((a, b, couplings), place)| {
        let triangle = upper(a, a, b, &couplings);
        Matrix4::from_fn(|i, j| triangle[(place[i], place[j])])
    });
    let hidden_jordan = (-2.0..2.0, entries(-1.0..1.0)).prop_map(|(value, mix)| {
        let mix = mix + Matrix4::identity() * 3.0;
        let jordan = Matrix4::from_fn(|i, j| if i == j { value } else { f64::from(u8::from(j == i + 1)) });
        mix.try_inverse().map_or(jordan, |inverse| mix * jordan * inverse)
    });
    let companion =
        (-9.0..9.0, -9.0..9.0, -9.0..9.0, prop_oneof![Just(0.0), -9.0..9.0]).prop_map(companion_of);
    let crippled = (0..16_usize, 0..16_usize, -2.0..2.0).prop_map(|(zero, other, factor)| {
        let mut a = aircraft();
        a[other] *= factor;
        a[zero] = 0.0;
        a
    });
    let any = prop_oneof![
        entries(-1.0..1.0),
        entries(many_scales),
        entries(sparse),
        permutation,
        defective,
        hidden_jordan,
        companion,
        crippled,
    ];
    (any, prop_oneof![4 => Just(1.0), 1 => Just(1e150), 1 => Just(1e-150)]).prop_map(|(a, size)| a * size)
}

/// Companion matrix of s⁴ + a s³ + b s² + c s + d.
fn companion_of((a, b, c, d): (f64, f64, f64, f64)) -> Matrix4<f64> {
    Matrix4::from_row_slice(&[-a, -b, -c, -d, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0])
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 1500, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn every_finite_matrix_has_an_answer_that_obeys_the_laws(a in matrix()) {
        assert_laws(&a);
    }

    #[test]
    fn eigenvalues_alone_are_those_with_vectors(a in matrix()) {
        let (alone, with) = (eigenvalues(&a), eigen(&a).map(|eigen| eigen.values));
        // The few that `eigen` solves again without balancing are good to ‖A‖ only: both obey trace and determinant.
        if alone != with {
            let (unit, values) = (a / a.amax(), alone.expect("values").map(|value| value / a.amax()));
            let (sum, product): (Complex<f64>, Complex<f64>) = (values.iter().sum(), values.iter().product());
            prop_assert!((sum - unit.trace()).norm() <= 1e-13 * unit.norm());
            prop_assert!((product - unit.determinant()).norm() <= 1e-12 * unit.norm().powi(4));
        }
    }

    #[test]
    fn entries_of_any_size_at_all_have_an_answer(a in entries(prop_oneof![Just(0.0), -1e300..1e300, -1e-300..1e-300, any::<f64>()])) {
        match eigen(&a) {
            Ok(solved) => prop_assert!(solved.right.iter().chain(solved.left.iter()).all(|x| x.re.is_finite() && x.im.is_finite())),
            // any::<f64>() reaches infinity and numbers whose eigenvalues would
            Err(error) => prop_assert!(error == EigenError::NotFinite && !a.iter().all(|x| x.abs() < 1e307)),
        }
    }

    #[test]
    fn one_entry_that_is_not_finite_is_an_error(a in entries(-1.0..1.0), place in 0..16_usize, bad in prop_oneof![Just(f64::NAN), Just(f64::INFINITY), Just(f64::NEG_INFINITY)]) {
        let mut a = a;
        a[place] = bad;
        prop_assert_eq!(eigen(&a), Err(EigenError::NotFinite));
    }
}

#[test]
fn zero_and_identity_have_independent_vectors() {
    for a in [Matrix4::zeros(), Matrix4::identity(), Matrix4::identity() * -1e-150] {
        let solved = assert_laws(&a);
        assert!(solved.values.iter().all(|value| *value == Complex::from(a[0])));
        assert_eq!(solved.right.determinant().norm(), 1.0);
    }
}

#[test]
fn the_companion_matrix_that_hangs_others_has_the_eighth_roots() {
    let solved = assert_laws(&companion_of((0.0, 0.0, 0.0, 1.0)));
    for value in &solved.values {
        assert!(
            (value.re.abs() - 0.5_f64.sqrt()).abs() < 1e-15
                && (value.im.abs() - 0.5_f64.sqrt()).abs() < 1e-15
        );
    }
}

#[test]
fn a_triangle_in_any_order_gives_its_diagonal_exactly() {
    for place in [[0, 1, 2, 3], [3, 2, 1, 0], [2, 0, 3, 1], [1, 3, 0, 2]] {
        let triangle = upper(0.1, 0.1, 0.1, &[7.0, 5.0, 3.0, 2.0, 1.0, -4.0]);
        let solved = assert_laws(&Matrix4::from_fn(|i, j| triangle[(place[i], place[j])]));
        assert_eq!(solved.values.as_slice(), [Complex::from(0.1); 4]);
    }
}

#[test]
fn jordan_blocks_of_every_size_obey_the_laws() {
    for value in [0.0, 1.0, -3.0] {
        for blocks in 0..8_u8 {
            let a = Matrix4::from_fn(|i, j| match j.wrapping_sub(i) {
                0 => value,
                1 => f64::from(blocks >> i & 1),
                _ => 0.0,
            });
            assert_laws(&a);
            assert_laws(&a.transpose());
        }
    }
}

#[test]
fn any_entry_of_an_aircraft_may_be_zero_huge_or_tiny() {
    for place in 0..16 {
        for other in 0..16 {
            for entry in [0.0, 1e-150, 1e-12, 1e12, 1e150] {
                let mut a = aircraft();
                a[other] = 0.0;
                a[place] = entry;
                assert_laws(&a);
            }
        }
    }
}

#[test]
fn participation_is_shared_where_left_and_right_have_nothing_in_common() {
    let mut a = Matrix4::zeros();
    a[(0, 1)] = 1.0;
    let mut solved = assert_laws(&a);
    solved.right = Matrix4::from_fn(|i, _| Complex::from(if i == 0 { 1.0 } else { 0.0 }));
    solved.left = Matrix4::from_fn(|i, _| Complex::from(if i == 1 { 1.0 } else { 0.0 }));
    assert_eq!(solved.participation(0).as_slice(), [0.5, 0.5, 0.0, 0.0]);
}

#[derive(Deserialize)]
struct HardMatrices {
    matrices: Vec<HardMatrix>,
}

#[derive(Deserialize)]
struct HardMatrix {
    name: String,
    a: [[f64; 4]; 4],
    /// Frobenius norm of the matrix as LAPACK balances it.
    balanced_norm: f64,
    eigenvalues: Vec<HardValue>,
}

#[derive(Deserialize)]
struct HardValue {
    re: f64,
    im: f64,
    /// 1/|lᴴv| of the balanced matrix, from LAPACK's vectors; null where they are orthogonal.
    condition: Option<f64>,
}

/// How far two backward-stable solvers may be apart.
///
/// Both find the eigenvalues of B + E, B being A balanced, ‖E‖ ≤ 2e-14‖B‖ (a hundred rounding errors, for both together).
/// To first order a simple eigenvalue then moves by ‖E‖/|lᴴv| (Golub & Van Loan §7.2.2). Any eigenvalue, also a defective
/// one, moves by at most (‖B‖ + ‖B + E‖)^(3/4) ‖E‖^(1/4) (Elsner 1985), whichever is less.
fn allowed(matrix: &HardMatrix, value: &HardValue) -> f64 {
    let error = 2e-14 * matrix.balanced_norm;
    let elsner = (2.0 * matrix.balanced_norm).powf(0.75) * error.powf(0.25);
    value.condition.map_or(elsner, |condition| elsner.min(condition * error))
}

#[test]
fn hard_matrices_have_lapacks_eigenvalues() {
    let hard: HardMatrices =
        serde_json::from_str(include_str!("data/hard_matrices.json")).expect("the data file reads");
    assert!(hard.matrices.len() >= 60);
    for matrix in &hard.matrices {
        let solved = assert_laws(&Matrix4::from_fn(|i, j| matrix.a[i][j]));
        let mut left: Vec<_> = solved.values.as_slice().to_vec();
        for value in &matrix.eigenvalues {
            let lapack = Complex::new(value.re, value.im);
            let distance = |mine: &Complex<f64>| (mine - lapack).norm();
            let nearest = (0..left.len()).min_by(|&i, &j| distance(&left[i]).total_cmp(&distance(&left[j])));
            let mine = left.swap_remove(nearest.expect("as many values as LAPACK's"));
            let (off, allowed) = (distance(&mine), allowed(matrix, value));
            assert!(
                off <= allowed,
                "{}: {mine} should be {lapack}: off by {off:e}, allowed {allowed:e}",
                matrix.name
            );
        }
    }
}
