//! Sorting of a few values, such as modes, causes or choices: never of samples or faces.
//!
//! The standard library's sort is compiled anew for each type and order, more than a kilobyte of the compressed page each time. This one
//! is a few instructions, and its time grows with the square of the count.

use std::cmp::Ordering;

/// Sorts a few values; equal ones keep their order.
pub fn sort_by<T>(few: &mut [T], order: impl Fn(&T, &T) -> Ordering) {
    for end in 1..few.len() {
        for at in (1..=end).rev() {
            if order(&few[at - 1], &few[at]) != Ordering::Greater {
                break;
            }
            few.swap(at - 1, at);
        }
    }
}

/// The same by a key of each.
pub fn sort_by_key<T, K: Ord>(few: &mut [T], key: impl Fn(&T) -> K) {
    sort_by(few, |a, b| key(a).cmp(&key(b)));
}

#[cfg(test)]
mod tests {
    use super::{sort_by, sort_by_key};

    #[test]
    fn few_are_sorted_as_the_standard_library_sorts_them() {
        // Every arrangement of up to five of four values, two of which are equal by their key.
        for count in 0..=5_u32 {
            for arrangement in 0..4_usize.pow(count) {
                let digit = |k: u32| arrangement / 4_usize.pow(k) % 4;
                let few: Vec<(usize, usize)> = (0..count).map(|k| (digit(k) / 2, digit(k))).collect();
                let (mut found, mut expected) = (few.clone(), few.clone());
                sort_by_key(&mut found, |pair| pair.0);
                expected.sort_by_key(|pair| pair.0);
                assert_eq!(found, expected, "{few:?}");
                sort_by(&mut found, |a, b| b.1.cmp(&a.1));
                expected.sort_by_key(|pair| std::cmp::Reverse(pair.1));
                assert_eq!(found, expected, "{few:?}");
            }
        }
    }
}
