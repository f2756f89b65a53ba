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
use eigenwing::scenario::view::{Pane, StandardView, Tab};
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
        assert_eq!(T::by_key(value.in_links()), Some(value));
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

#[test]
fn links_and_requests_understand_each_other() {
    for (link, request, source) in [
        ("gust", "vertical-gust", Source::VerticalGust),
        ("head_gust", "head-gust", Source::HeadGust),
        ("side_gust", "side-gust", Source::SideGust),
    ] {
        assert_eq!((source.in_links(), source.key()), (link, request));
    }
    assert_eq!((Shape::ThreeTwoOneOne.in_links(), Shape::ThreeTwoOneOne.key()), ("3211", "3-2-1-1"));
    assert_eq!((Shape::OneMinusCosine.in_links(), Shape::OneMinusCosine.key()), ("1-cos", "1-cosine"));
    assert_eq!(Plane::ALL.map(Keyed::in_links), ["lon", "lat"]);
}
