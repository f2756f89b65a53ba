//! What a change of the aircraft did to each mode.

use super::formula::{Formula, Measured, with_change};
use super::path::{Part, parts_along};
use super::subject::{Moved, Side, Subject};
use crate::few;
use crate::findings::Findings;
use crate::flight::aircraft::states::Lateral::{Phi, V};
use crate::flight::modes::mode::Mode;
use crate::flight::modes::mode_name::ModeName;
use crate::flight::modes::second_order::{DUTCH_ROLL, second_order};
use crate::scenario::{Page, Parameter, Scenario, parameters};

/// A change of ωₙ or of a root by less than this fraction is none.
const STILL: f64 = 0.01;
/// Likewise of ζ, by this fraction of it and by this much.
const STILL_DAMPING: (f64, f64) = (0.02, 0.003);

/// What became of an aircraft in one plane of motion.
#[derive(Clone, Debug, PartialEq)]
pub struct Change {
    /// What a person has moved, in the order of the sliders.
    pub edits: Vec<Moved>,
    /// One a mode as it is now, in the order of the analysis.
    pub modes: Vec<ModeChange>,
}

/// What became of one mode.
#[derive(Clone, Debug, PartialEq)]
pub struct ModeChange {
    /// Its name now.
    pub name: ModeName,
    /// What became of it.
    pub kind: Kind,
}

/// What became of a mode.
#[derive(Clone, Debug, PartialEq)]
#[expect(clippy::large_enum_variant, reason = "there are four of them")]
pub enum Kind {
    /// Next to nothing.
    Still,
    /// There was no such mode: roots have met on the way, and parted otherwise.
    New,
    /// An oscillation, or the two real roots of one taken together.
    Oscillation(Oscillation),
    /// A real root λ \[1/s\].
    Root(Shift),
}

/// How an oscillation has moved.
#[derive(Clone, Debug, PartialEq)]
pub struct Oscillation {
    /// Whether it was an oscillation, and is.
    pub oscillates: [bool; 2],
    /// Natural frequency ωₙ \[rad/s\].
    pub frequency: Shift,
    /// Damping ratio ζ.
    pub damping_ratio: Shift,
    /// 2ζωₙ \[1/s\], before and after.
    pub damping: [f64; 2],
    /// Period \[s\], where it has one before and after.
    pub period: Option<[f64; 2]>,
    /// How the Dutch roll shares its damping with the roll mode and the spiral, where no formula of its own has the change.
    pub shared: Option<SharedDamping>,
}

/// A number of a mode before and after, and what moved it.
#[derive(Clone, Debug, PartialEq)]
pub struct Shift {
    /// Before.
    pub from: f64,
    /// After.
    pub to: f64,
    /// Whether it has changed by enough to speak of.
    pub is_notable: bool,
    /// What each derivative did to it, the most first; they add up to the change. `None` where roots meet on the way.
    pub causes: Option<Vec<Cause>>,
    /// The textbook formula that has the change, before and after; of a damping ratio it is one of 2ζωₙ.
    pub formula: Option<[Formula; 2]>,
}

/// The part of one derivative in a change.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cause {
    /// The derivative, before and after.
    pub moved: Moved,
    /// Its part, in the unit of what has changed: the integral of the exact sensitivity along the straight way.
    pub part: f64,
}

/// −2ζωₙ + λ_roll + λ_spiral = Y_v + L′_p + N′_r: the sum of all roots is the trace of A. Each before and after \[1/s\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SharedDamping {
    /// The trace of A.
    pub trace: [f64; 2],
    /// λ of the roll mode.
    pub roll: [f64; 2],
    /// λ of the spiral.
    pub spiral: [f64; 2],
    /// How far the Dutch roll banks for an angle of sideslip, |φ/β|.
    pub bank: [f64; 2],
}

impl Shift {
    /// After less before.
    pub fn change(&self) -> f64 {
        self.to - self.from
    }

    /// The change over the size before.
    pub fn relative(&self) -> f64 {
        self.change() / self.from.abs()
    }

    fn of(from: f64, to: f64, is_notable: bool, causes: Option<Vec<Cause>>) -> Self {
        Self { from, to, is_notable, causes, formula: None }
    }
}

impl Kind {
    /// Whether there is something to tell.
    pub fn is_told(&self) -> bool {
        *self != Self::Still
    }
}

impl Change {
    /// What became of the plane on screen between two states of one aircraft; `None` between aircraft, or where nothing was changed.
    pub fn between(before: &Findings, after: &Findings) -> Option<Self> {
        let (from, to) = (before.scenario(), after.scenario());
        if from.aircraft.key != to.aircraft.key || from.plane != to.plane || from.edited == to.edited {
            return None;
        }
        let sides =
            [Side { plane: before.plane()?, scenario: from }, Side { plane: after.plane()?, scenario: to }];
        let now = &sides[1].plane.modes;
        let subject = |mode: &Mode| Subject::of(mode, sides.map(|side| side.plane.modes.as_slice()));
        let subjects: Vec<Option<Subject>> = now.iter().map(subject).collect();
        let wanted: Vec<Subject> = subjects.iter().flatten().copied().collect();
        let mut parts = parts_along(from, to, &wanted).into_iter();
        let modes = now.iter().zip(subjects).map(|(mode, subject)| {
            let kind = subject.map_or(Kind::New, |subject| kind(subject, sides, parts.next().flatten()));
            ModeChange { name: mode.naming.name, kind }
        });
        Some(Self { edits: edits(from, to), modes: modes.collect() })
    }

    /// The same since the aircraft was as its file has it.
    pub fn since_reference(after: &Findings) -> Option<Self> {
        Self::between(&Findings::of(reference_of(after.scenario())), after)
    }
}

/// The aircraft of a scenario as its file has it, in the same plane.
pub fn reference_of(scenario: &Scenario) -> Scenario {
    scenario.with_reference_model()
}

/// What a person has moved.
fn edits(from: &Scenario, to: &Scenario) -> Vec<Moved> {
    let shown = |p: &&Parameter| {
        p.page.is_some_and(|page| page != Page::Feedback)
            && p.plane.is_none_or(|plane| plane == to.plane)
            && p.applies(to)
    };
    let moved = |p: &'static Parameter| {
        let differs = match (p.added(from), p.added(to)) {
            (Some(before), Some(after)) => before != after,
            _ => p.get(from) != p.get(to),
        };
        differs.then(|| Moved { key: p.key, from: p.get(from), to: p.get(to) })
    };
    parameters().filter(shown).filter_map(moved).collect()
}

fn kind(subject: Subject, sides: [Side<'_>; 2], parts: Option<Vec<Part>>) -> Kind {
    let causes = |of: fn(&Part) -> f64| {
        let mut causes: Vec<Cause> =
            parts.as_ref()?.iter().map(|part| Cause { moved: part.moved, part: of(part) }).collect();
        few::sort_by(&mut causes, |a, b| b.part.abs().total_cmp(&a.part.abs()));
        Some(causes)
    };
    match subject {
        Subject::Root(name) => {
            let [Some(from), Some(to)] = sides.map(|side| side.find(name).map(|mode| mode.lambda.re)) else {
                return Kind::New;
            };
            // Of a root near zero a small part of the others says whether it has moved.
            let least = 1e-5 * sides[1].plane.modes.iter().map(|mode| mode.lambda.norm()).fold(0.0, f64::max);
            let is_notable = (to - from).abs() > (STILL * from.abs()).max(least);
            if !is_notable {
                return Kind::Still;
            }
            let mut shift = Shift::of(from, to, is_notable, causes(|part| part.root));
            shift.formula = with_change(sides, name, Measured::Root, [from, to]);
            Kind::Root(shift)
        }
        Subject::Pair(family) => {
            let [Some(before), Some(after)] = sides.map(|side| second_order(&side.plane.modes, family))
            else {
                return Kind::New;
            };
            let [from, to] = [before.natural_frequency, after.natural_frequency];
            let [zeta_from, zeta_to] = [before.damping_ratio, after.damping_ratio];
            let (share, least) = STILL_DAMPING;
            let damping_is_notable = (zeta_to - zeta_from).abs() > (share * zeta_from.abs()).max(least);
            let frequency_is_notable = (to - from).abs() > STILL * from;
            let pairs = sides.each_ref().map(|side| side.find(family[0]));
            let oscillates = pairs.map(|pair| pair.is_some_and(Mode::is_oscillatory));
            if !damping_is_notable && !frequency_is_notable && oscillates[0] == oscillates[1] {
                return Kind::Still;
            }
            let mut frequency = Shift::of(from, to, frequency_is_notable, causes(|part| part.frequency));
            let mut damping_ratio =
                Shift::of(zeta_from, zeta_to, damping_is_notable, causes(|part| part.damping_ratio));
            let damping = [2.0 * zeta_from * from, 2.0 * zeta_to * to];
            if frequency_is_notable {
                frequency.formula = with_change(sides, family[0], Measured::Frequency, [from, to]);
            }
            if damping_is_notable {
                damping_ratio.formula = with_change(sides, family[0], Measured::Damping, damping);
            }
            let period = pairs[0].and_then(Mode::period).zip(pairs[1].and_then(Mode::period));
            let shared = (family == DUTCH_ROLL && damping_is_notable && damping_ratio.formula.is_none())
                .then(|| shared_damping(sides))
                .flatten();
            let period = period.map(|(before, after)| [before, after]);
            Kind::Oscillation(Oscillation { oscillates, frequency, damping_ratio, damping, period, shared })
        }
    }
}

fn shared_damping(sides: [Side<'_>; 2]) -> Option<SharedDamping> {
    let of = |side: Side<'_>| {
        let (roll, spiral) = (side.find(ModeName::RollSubsidence)?, side.find(ModeName::Spiral)?);
        let yaw = side.find(ModeName::DutchRoll)?;
        // |φ/β|, β = v/V
        let bank = yaw.component(Phi).norm() / (yaw.component(V).norm() / side.plane.model.trim.speed);
        bank.is_finite().then_some([side.plane.model.a.trace(), roll.lambda.re, spiral.lambda.re, bank])
    };
    let [before, after] = [of(sides[0])?, of(sides[1])?];
    let at = |k: usize| [before[k], after[k]];
    Some(SharedDamping { trace: at(0), roll: at(1), spiral: at(2), bank: at(3) })
}
