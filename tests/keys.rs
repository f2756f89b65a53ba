//! Keys: names for programs, each of one value only, and readable in every spelling that was ever published.

use std::collections::HashMap;
use std::fmt::Debug;

use eigenwing::content::Status;
use eigenwing::flight::aircraft::plane::Plane;
use eigenwing::flight::modes::approximations::ApproximationName;
use eigenwing::flight::modes::mode_name::ModeName;
use eigenwing::flight::modes::stability::Stability;
use eigenwing::flight::motion::outputs::Output;
use eigenwing::flight::verdicts::handling_qualities::Level;
use eigenwing::flight::verdicts::mil_f_8785c::{Category, Class, Criterion};
use eigenwing::key::Keyed;
use eigenwing::scenario::view::{Look, Pane, StandardView, Tab};
use eigenwing::scenario::{Page, Shape, Source};
use eigenwing::words;

/// The keys of a list, after every spelling of it has led back to its own value.
fn keys<T: Keyed + Debug>() -> Vec<&'static str> {
    let mut spellings = HashMap::new();
    for &value in T::VALUES {
        for spelling in std::iter::once(value.key()).chain(value.aliases().iter().copied()) {
            assert_eq!(T::by_key(spelling), Some(value), "{spelling}");
            let other = spellings.insert(spelling, value);
            assert!(other.is_none(), "{spelling} is {value:?} and {other:?}");
        }
        assert_eq!(T::by_key(&value.in_links()), Some(value));
    }
    assert_eq!(T::by_key("no-such-key"), None);
    T::VALUES.iter().map(|value| value.key()).collect()
}

#[test]
fn every_spelling_leads_to_one_value_and_keys_are_small_letters_digits_and_hyphens() {
    let written_by_us = [
        keys::<Plane>(),
        keys::<ModeName>(),
        keys::<Stability>(),
        keys::<ApproximationName>(),
        keys::<Level>(),
        keys::<Criterion>(),
        keys::<Output>(),
        keys::<Source>(),
        keys::<Shape>(),
        keys::<Status>(),
        keys::<Page>(),
        keys::<Tab>(),
        keys::<Pane>(),
        keys::<StandardView>(),
        keys::<Look>(),
    ];
    for key in written_by_us.iter().flatten() {
        let is_of_key = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-';
        assert!(key.chars().all(is_of_key), "{key}");
    }
    // Those of the specification are its own names.
    assert_eq!(keys::<Class>(), ["I", "II", "II-C", "III", "IV"]);
    assert_eq!(keys::<Category>(), ["A-combat", "A", "B", "C"]);
}

/// Requests named a mode by its words before it had a key.
#[test]
fn a_mode_and_a_level_are_found_by_their_words_too() {
    for &name in ModeName::VALUES {
        assert_eq!(ModeName::by_key(words::mode::title(name)), Some(name));
    }
    for &level in Level::VALUES {
        assert_eq!(Level::by_key(words::verdict::level(level)), Some(level));
    }
    assert_eq!(ModeName::by_key("DUTCH ROLL"), Some(ModeName::DutchRoll));
}

/// What links wrote before they and requests had one vocabulary.
#[test]
fn links_write_the_words_of_requests_and_both_read_the_older_ones() {
    let sources = [
        ("gust", "vertical-gust", Source::VerticalGust),
        ("head_gust", "head-gust", Source::HeadGust),
        ("side_gust", "side-gust", Source::SideGust),
    ];
    let shapes = [("3211", "3-2-1-1", Shape::ThreeTwoOneOne), ("1-cos", "1-cosine", Shape::OneMinusCosine)];
    fn check<T: Keyed + Debug>((older, key, value): (&str, &str, T)) {
        assert_eq!((value.key(), value.in_links().as_str()), (key, key));
        assert_eq!(T::by_key(older), Some(value), "{older}");
    }
    sources.into_iter().for_each(check);
    shapes.into_iter().for_each(check);
    check(("figures", "metrics", Tab::Metrics));
    check(("lon", "longitudinal", Plane::Longitudinal));
    check(("lat", "lateral", Plane::Lateral));
    // Small letters only, for an address.
    assert_eq!(
        (Class::IICarrier.in_links(), Category::ACombat.in_links()),
        ("ii-c".to_owned(), "a-combat".to_owned())
    );
}
