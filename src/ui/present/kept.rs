//! What was done on the slides of a lecture, as text that outlives a reload of the page: hands, and what was answered.
//!
//! The first line is where the lesson was opened from. Each of the others is a slide that has been on screen, counted from 0: its
//! number, how many of its questions have been answered, and for each question with hands its number and their counts: `3 1 0:2,5,1`.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use super::{MOST_CHOICES, Presentation, Slide};

/// Slides by their number, as they were kept.
pub type Slides = BTreeMap<usize, Slide>;

impl Presentation {
    /// What is kept of it.
    pub fn kept(&self) -> String {
        let mut text = self.address.clone();
        for (number, slide) in &self.slides {
            if slide.revealed == 0 && slide.hands.is_empty() {
                continue;
            }
            // Writing into text can't fail.
            let _ = write!(text, "\n{number} {}", slide.revealed);
            for (question, hands) in &slide.hands {
                let _ = write!(text, " {question}");
                for (choice, count) in hands.iter().enumerate() {
                    let _ = write!(text, "{}{count}", if choice == 0 { ':' } else { ',' });
                }
            }
        }
        text
    }

    /// The address and the slides of what was kept; what can't be read is left out.
    pub fn slides_of(kept: &str) -> (&str, Slides) {
        let mut lines = kept.lines();
        let address = lines.next().unwrap_or_default();
        (address, lines.filter_map(slide).collect())
    }
}

fn slide(line: &str) -> Option<(usize, Slide)> {
    let mut words = line.split(' ');
    let mut number = || words.next()?.parse::<usize>().ok();
    let (at, revealed) = (number()?, number()?);
    let hands = words.filter_map(|word| {
        let (question, counts) = word.split_once(':')?;
        let counts = counts.split(',').take(MOST_CHOICES).map(|count| count.parse().unwrap_or_default());
        Some((question.parse().ok()?, counts.collect()))
    });
    Some((at, Slide { revealed, hands: hands.collect(), ..Slide::default() }))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hands_and_answers_are_read_as_they_were_kept_and_nothing_else_is() {
        let mut lecture =
            Presentation { address: "class/week 3.md".to_owned(), slide: 2, ..Default::default() };
        for choice in [0, 1, 1, 3] {
            lecture.count_hand(1, choice, true);
        }
        lecture.current_mut().revealed = 1;
        lecture.current_mut().veil = Some(true);
        lecture.slide = 5;
        lecture.current_mut().reasons.insert(0);
        let kept = lecture.kept();
        let (address, slides) = Presentation::slides_of(&kept);
        assert_eq!(address, "class/week 3.md");
        let hands = [(1, vec![1, 2, 0, 1])].into();
        assert_eq!(slides, [(2, Slide { revealed: 1, hands, ..Slide::default() })].into());
    }

    #[test]
    fn what_was_kept_and_damaged_is_left_out() {
        let (address, slides) = Presentation::slides_of("a\n\nx 1\n4\n7 1 0:1,z,2 nonsense 1:\n");
        assert_eq!(address, "a");
        assert_eq!(slides.keys().collect::<Vec<_>>(), [&7]);
        assert_eq!(slides[&7].hands[&0], [1, 0, 2]);
    }
}
