//! A number that each person has their own of: `vary = { cm_alpha = [-0.9, -0.5] }` in the block `scene`.
//!
//! It follows from the name or number that a person has typed once, by a hash that never changes, so that whoever grades finds it
//! again.

use super::number::unknown;
use crate::content::ContentError;
use crate::content::reader::Block;
use crate::number::nice_step;
use crate::scenario::{Dimension, Parameter, parameters};

/// A number that each person has their own of.
#[derive(Clone, Debug, PartialEq)]
pub struct Vary {
    /// Which number.
    pub parameter: &'static Parameter,
    /// The least, in the unit of links.
    pub low: f64,
    /// The greatest, in the unit of links.
    pub high: f64,
    /// Line of the file, counted from 1.
    pub line: usize,
}

/// About as many different numbers are enough, and each can be read off a slider.
const NUMBERS: f64 = 100.0;

impl Vary {
    /// From one number to the next: 1, 2 or 5 of some digit.
    fn step(&self) -> f64 {
        let step = nice_step((self.high - self.low) / NUMBERS);
        if self.parameter.dimension == Dimension::Count { step.max(1.0) } else { step }
    }

    /// How many steps it is from the least to the greatest.
    fn steps(&self) -> u32 {
        ((self.high - self.low) / self.step() + 1e-9) as u32
    }

    /// The number after so many steps, as it stands in a link.
    fn number(&self, steps: u32) -> String {
        let step = self.step();
        let decimals = [step, self.low].map(decimals).into_iter().max().unwrap_or(0);
        let number = format!("{:.decimals$}", self.low + f64::from(steps.min(self.steps())) * step);
        let number =
            if number.contains('.') { number.trim_end_matches('0').trim_end_matches('.') } else { &number };
        if number == "-0" { "0".to_owned() } else { number.to_owned() }
    }

    /// The number of a person.
    pub(super) fn number_of(&self, person: &str) -> String {
        let share = u128::from(hash(&format!("{}\0{}", normalised(person), self.parameter.key)));
        let steps = (share * (u128::from(self.steps()) + 1)) >> u64::BITS;
        self.number(steps as u32)
    }

    /// The number at a share of the way from the least to the greatest.
    pub(super) fn number_at(&self, share: f64) -> String {
        self.number((share * f64::from(self.steps())).round() as u32)
    }
}

/// How many digits behind the point a short decimal number has.
fn decimals(number: f64) -> usize {
    (0..=12).find(|&digits| format!("{number:.digits$}").parse() == Ok(number)).unwrap_or(12)
}

/// A name as it counts: without capitals, spaces and signs, so that nobody has to type it twice in the same way.
pub fn normalised(person: &str) -> String {
    person.chars().filter(|c| c.is_alphanumeric()).flat_map(char::to_lowercase).collect()
}

/// A number that is spread evenly over all 64 bits and the same on every machine: FNV-1a, then the last steps of SplitMix64, since
/// the high bits of FNV hardly differ between short texts.
pub(super) fn hash(text: &str) -> u64 {
    let fnv = text.bytes().fold(0xcbf2_9ce4_8422_2325_u64, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3)
    });
    let mixed = (fnv ^ (fnv >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    mixed ^ (mixed >> 31)
}

/// Reads the table `vary` of a scene; nothing where it has none.
pub(super) fn read(block: &mut Block<'_>) -> Result<Vec<Vary>, ContentError> {
    let Some(mut table) = block.optional_block("vary")? else { return Ok(Vec::new()) };
    table.names().into_iter().map(|key| read_one(&mut table, key)).collect()
}

fn read_one<'t>(table: &mut Block<'t>, key: &'t str) -> Result<Vary, ContentError> {
    let parameter = Parameter::find(key).ok_or_else(|| {
        table.error(key, unknown("parameter", key, parameters().map(|parameter| parameter.key)))
    })?;
    let [low, high] = table.row::<2>(key)?;
    if low >= high {
        let expected = "expected the least number and then the greatest, such as [-0.9, -0.5]";
        return Err(table.error(key, format!("{expected}, found [{low}, {high}]")));
    }
    Ok(Vary { parameter, low, high, line: table.line(key) })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// From these numbers those of every report follow: they never change.
    #[test]
    fn the_numbers_of_a_name_are_the_same_for_ever() {
        assert_eq!(hash(""), 0xf52a_15e9_a9b5_e89b);
        assert_eq!(normalised(" Ada  LOVELACE, 12 "), "adalovelace12");
    }

    #[test]
    fn a_number_is_short_and_between_its_ends() {
        let vary =
            |low, high| Vary { parameter: Parameter::find("cm_alpha").expect("a row"), low, high, line: 1 };
        let range = vary(-0.9, -0.5);
        assert_eq!([0.0, 0.5, 1.0].map(|share| range.number_at(share)), ["-0.9", "-0.7", "-0.5"]);
        let odd = vary(-0.683, 1.0);
        for person in ["a", "b", "Ada", "4711", ""] {
            let number: f64 = odd.number_of(person).parse().expect("a number");
            assert!((-0.683..=1.0).contains(&number), "{number}");
            assert!(odd.number_of(person).len() <= 6, "{}", odd.number_of(person));
        }
        assert_eq!(range.number_of("Ada"), range.number_of(" ada."));
        let different: std::collections::BTreeSet<String> =
            (0..1000).map(|number| range.number_of(&number.to_string())).collect();
        assert_eq!(different.len() as u32, range.steps() + 1, "each number has its persons");
    }
}
