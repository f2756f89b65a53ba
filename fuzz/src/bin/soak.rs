//! Random scenarios through everything that follows from them: `cargo xtask soak 10000000`. Prints a report, and ends with an error if
//! anything stopped or broke a law; each such scene is a link.

#![forbid(unsafe_code)]

use std::collections::BTreeMap;
use std::ops::RangeInclusive;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::process::ExitCode;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::thread;
use std::time::{Duration, Instant};

use chacha20::ChaCha8Rng;
use chacha20::rand_core::{Rng as _, SeedableRng as _};
use eigenwing::content::{Aircraft, embedded_aircraft};
use eigenwing::findings::Findings;
use eigenwing::flight::analysis::PlaneAnalysis;
use eigenwing::flight::modes::stability::Stability;
use eigenwing::scenario::{Parameter, Scenario, View, link, parameters};

/// Of every so many scenarios the motion, the figures and the flight are found too.
const WHOLE: u64 = 64;

/// At most so many links are printed of one kind of fault.
const SHOWN: usize = 3;

/// So many scenes that took longest are timed again at the end, each so many times: beside other programs any scene may take long once.
const SLOWEST: usize = 20;
const TIMES: usize = 5;

/// Departure from Σλ = tr A that is a fault \[‖A‖\]; of modes that are neither stable nor unstable, whose real part is told as zero.
const TRACE: f64 = 1e-12;
const NEUTRAL_TRACE: f64 = 1e-8;

/// What was found.
#[derive(Default)]
struct Tally {
    /// Scenes by what came of them, in words.
    outcomes: BTreeMap<String, u64>,
    /// Links of scenes that broke a law, by the law.
    faults: BTreeMap<String, Vec<String>>,
    /// Modes by name.
    names: BTreeMap<String, u64>,
    /// The largest departure from Σλ = tr A, of modes that aren't neutral \[‖A‖\].
    worst_trace: f64,
    /// Scenes that took longest, the slowest first: how long, and their number.
    slowest: Vec<(Duration, u64)>,
}

struct Random(ChaCha8Rng);

impl Random {
    /// From 0 to 1.
    fn share(&mut self) -> f64 {
        (self.0.next_u64() >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn below(&mut self, end: usize) -> usize {
        (self.share() * end as f64) as usize
    }

    /// A value of a parameter, mostly within its slider, sometimes where nobody would put it.
    fn value(&mut self, parameter: &Parameter, scenario: &Scenario) -> f64 {
        let (slider, accepted) = (parameter.range(scenario), parameter.accepted(scenario));
        match self.below(20) {
            0..=9 => within(&slider, self.share()),
            10..=12 => within(&accepted, self.share()),
            13 => *slider.start(),
            14 => *slider.end(),
            15 => *accepted.start(),
            16 => *accepted.end(),
            17 => 0.0,
            18 => -parameter.get(scenario),
            _ => parameter.get(scenario) * 10_f64.powf(24.0 * self.share() - 12.0),
        }
    }
}

fn within(range: &RangeInclusive<f64>, share: f64) -> f64 {
    range.start() + share * (range.end() - range.start())
}

fn main() -> ExitCode {
    let argument = |place| std::env::args().nth(place).and_then(|text| text.parse::<u64>().ok());
    let (wanted, seed) = (argument(1).unwrap_or(1_000_000), argument(2).unwrap_or(1));
    let aircraft: Vec<Arc<Aircraft>> = embedded_aircraft().0.into_iter().map(Arc::new).collect();
    // A panic is counted, not printed.
    std::panic::set_hook(Box::new(|_| {}));
    let (next, start) = (AtomicU64::new(0), Instant::now());
    let threads = thread::available_parallelism().map_or(1, |count| count.get());
    let tallies: Vec<Tally> = thread::scope(|scope| {
        let work = || scope.spawn(|| work(&aircraft, &next, wanted, seed));
        let workers: Vec<_> = (0..threads).map(|_| work()).collect();
        workers.into_iter().filter_map(|worker| worker.join().ok()).collect()
    });
    let tally = tallies.into_iter().fold(Tally::default(), Tally::and);
    let time = start.elapsed();
    let again = tally.slowest.iter().map(|&(_, number)| {
        let scenario = scenario_of(number, seed, &aircraft);
        let times = (0..TIMES).map(|_| timed(&scenario, number).0);
        (times.min().unwrap_or_default(), link_of(&scenario))
    });
    let slowest = again.max_by_key(|(time, _)| *time).unwrap_or_default();
    tally.print(wanted, seed, time, &slowest);
    ExitCode::from(u8::from(!tally.faults.is_empty()))
}

fn work(aircraft: &[Arc<Aircraft>], next: &AtomicU64, wanted: u64, seed: u64) -> Tally {
    let mut tally = Tally::default();
    loop {
        let number = next.fetch_add(1, Ordering::Relaxed);
        if number >= wanted {
            return tally;
        }
        let scenario = scenario_of(number, seed, aircraft);
        let (time, found) = timed(&scenario, number);
        tally.took(time, number);
        match found {
            Ok(found) => tally.count(&scenario, found),
            Err(stopped) => {
                let said = stopped.downcast_ref::<String>().cloned();
                let said = said.or_else(|| stopped.downcast_ref::<&str>().map(|said| (*said).to_owned()));
                tally.fault(&format!("stopped: {}", said.unwrap_or_default()), &scenario);
            }
        }
    }
}

/// A scene by its number. Each has a stream of its own, so that any one can be had again.
fn scenario_of(number: u64, seed: u64, aircraft: &[Arc<Aircraft>]) -> Scenario {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    rng.set_stream(number);
    scenario(&mut Random(rng), aircraft)
}

/// What comes of a scene, and how long that takes.
fn timed(scenario: &Scenario, number: u64) -> (Duration, thread::Result<Found>) {
    let begin = Instant::now();
    let found = catch_unwind(AssertUnwindSafe(|| found(scenario, number.is_multiple_of(WHOLE))));
    (begin.elapsed(), found)
}

/// An aircraft of the list with up to a dozen of its parameters moved.
fn scenario(random: &mut Random, aircraft: &[Arc<Aircraft>]) -> Scenario {
    let mut scenario = Scenario::new(aircraft[random.below(aircraft.len())].clone());
    let all: Vec<&Parameter> = parameters().collect();
    for _ in 0..=random.below(12) {
        let parameter = all[random.below(all.len())];
        if parameter.applies(&scenario) {
            let value = random.value(parameter, &scenario);
            // What is refused isn't set, as on the page.
            if let Ok(value) = parameter.check(&scenario, value) {
                parameter.set(&mut scenario, value);
            }
        }
    }
    scenario
}

/// What came of a scenario.
#[derive(Default)]
struct Found {
    outcome: String,
    broken: Vec<&'static str>,
    names: Vec<String>,
    trace: f64,
}

fn found(scenario: &Scenario, whole: bool) -> Found {
    let mut found = Found { outcome: "analysed".to_owned(), ..Found::default() };
    let analysis = match scenario.analyse() {
        Ok(analysis) => analysis,
        Err(error) => {
            return Found { outcome: format!("refused: {}", kind(&format!("{error:?}"))), ..found };
        }
    };
    for plane in analysis.planes.iter().flatten() {
        match plane {
            Ok(plane) => {
                found.trace = found.trace.max(laws(plane, &mut found.broken));
                found.names.extend(plane.modes.iter().map(|mode| format!("{:?}", mode.naming.name)));
            }
            Err(error) => found.outcome = format!("one plane refused: {}", kind(&format!("{error:?}"))),
        }
    }
    if whole {
        let findings = Findings::of(scenario.clone());
        let states = findings.motion().map_or(&[][..], |motion| &motion.response.states);
        if states.iter().any(|state| state.iter().any(|x| !x.is_finite())) {
            found.broken.push("a state of the motion is no number");
        }
        findings.metrics();
        findings.flight();
        findings.remarks();
        if eigenwing::export::state(&findings).is_null() {
            found.broken.push("there is no state for programs");
        }
    }
    found
}

/// What holds for the modes of every matrix; the departure from Σλ = tr A.
fn laws(plane: &PlaneAnalysis, broken: &mut Vec<&'static str>) -> f64 {
    let a = &plane.model.a;
    if a.iter().chain(&plane.model.b).any(|x| !x.is_finite()) {
        broken.push("an entry of A or B is no number");
        return 0.0;
    }
    let (mut roots, mut sum) = (0, 0.0);
    for mode in &plane.modes {
        let shown = [
            mode.natural_frequency(),
            mode.damping_ratio(),
            mode.period(),
            mode.time_to_half(),
            mode.time_to_double(),
            mode.cycles(),
            mode.time_constant(),
        ];
        let lambda = mode.lambda;
        let numbers = shown.into_iter().flatten().chain([lambda.re, lambda.im, mode.condition]);
        if numbers.chain(mode.participation).any(|x| !x.is_finite()) {
            broken.push("a number of a mode is none");
        }
        let times = if lambda.im > 0.0 { 2 } else { 1 };
        roots += times;
        sum += f64::from(times) * lambda.re;
    }
    if roots != 4 {
        broken.push("the modes don't have four roots");
    }
    let size = a.amax().max(f64::MIN_POSITIVE);
    let off = ((sum / size) - (a / size).trace()).abs() / (a / size).norm();
    let is_neutral = plane.modes.iter().any(|mode| mode.stability == Stability::Neutral);
    if off > if is_neutral { NEUTRAL_TRACE } else { TRACE } {
        broken.push("the sum of the eigenvalues isn't the trace");
    }
    if is_neutral { 0.0 } else { off }
}

/// The kind of an error, without its numbers.
fn kind(error: &str) -> String {
    error.chars().take_while(|c| !c.is_ascii_digit() && *c != '-').collect()
}

fn link_of(scenario: &Scenario) -> String {
    format!("#{}", link::write(scenario, &View::of(scenario), None))
}

impl Tally {
    fn count(&mut self, scenario: &Scenario, found: Found) {
        *self.outcomes.entry(found.outcome).or_default() += 1;
        for name in found.names {
            *self.names.entry(name).or_default() += 1;
        }
        self.worst_trace = self.worst_trace.max(found.trace);
        for law in found.broken {
            self.fault(law, scenario);
        }
    }

    fn fault(&mut self, what: &str, scenario: &Scenario) {
        *self.outcomes.entry(format!("FAULT: {what}")).or_default() += 1;
        let links = self.faults.entry(what.to_owned()).or_default();
        if links.len() < SHOWN {
            links.push(link_of(scenario));
        }
    }

    fn took(&mut self, time: Duration, number: u64) {
        if self.slowest.len() < SLOWEST || self.slowest.last().is_some_and(|last| time > last.0) {
            self.slowest.push((time, number));
            self.slowest.sort_by(|a, b| b.cmp(a));
            self.slowest.truncate(SLOWEST);
        }
    }

    fn and(mut self, other: Self) -> Self {
        for (outcome, count) in other.outcomes {
            *self.outcomes.entry(outcome).or_default() += count;
        }
        for (name, count) in other.names {
            *self.names.entry(name).or_default() += count;
        }
        for (law, links) in other.faults {
            let all = self.faults.entry(law).or_default();
            all.extend(links);
            all.truncate(SHOWN);
        }
        self.worst_trace = self.worst_trace.max(other.worst_trace);
        for (time, number) in other.slowest {
            self.took(time, number);
        }
        self
    }

    fn print(&self, wanted: u64, seed: u64, time: Duration, (slowest, link): &(Duration, String)) {
        println!("{wanted} random scenarios of seed {seed} in {:.0} s\n", time.as_secs_f64());
        for (outcome, count) in &self.outcomes {
            println!("{count:>10}  {outcome}");
        }
        println!("\nmodes by name:");
        for (name, count) in &self.names {
            println!("{count:>10}  {name}");
        }
        println!("\nlargest departure from Σλ = tr A: {:.1e} ‖A‖", self.worst_trace);
        println!("slowest scene, alone: {:.0} ms, {link}", slowest.as_secs_f64() * 1e3);
        for (what, links) in &self.faults {
            println!("\nFAULT: {what}");
            links.iter().for_each(|link| println!("    {link}"));
        }
    }
}
