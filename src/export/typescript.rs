//! TypeScript types of requests and answers, written from the Rust types that serde reads and writes.
//!
//! `src/bin/eigenwing-core/types.d.ts` is this text. After a change of what is exported:
//!
//! ```text
//! UPDATE_TYPES=1 cargo test --no-default-features --features cli --lib typescript
//! ```

use std::collections::BTreeMap;
use std::fs;

use ts_rs::{Config, TS, TypeVisitor};

use super::{
    AircraftReport, DisturbanceRequest, FrequencyReport, FrequencyRequest, LinkReport, MeasureReport,
    Message, ParameterReport, Report, ResponseReport, ResponseRequest, SweepReport, SweepRequest, TakenAlong,
    Target, json, sweep,
};
use crate::content::import::review::Review;
use crate::content::{MatrixFormat, Status};
use crate::flight::aircraft::plane::Plane;
use crate::flight::modes::approximations::ApproximationName;
use crate::flight::modes::mode_name::ModeName;
use crate::flight::modes::stability::Stability;
use crate::flight::verdicts::handling_qualities::Level;
use crate::flight::verdicts::mil_f_8785c::{Category, Class, Criterion};
use crate::key::Keyed;
use crate::scenario::{Shape, Source};

const HEAD: &str =
    "// Written by a test of src/export/typescript.rs from the Rust types, whose comments these are.\n";

const COMMITTED: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/src/bin/eigenwing-core/types.d.ts");

#[test]
fn the_committed_types_are_those_of_the_structs() {
    let mut types = Types::default();
    types.visit::<json::SubjectForm>();
    types.visit::<ResponseRequest>();
    types.visit::<FrequencyRequest>();
    types.visit::<SweepRequest>();
    types.visit::<DisturbanceRequest>();
    types.visit::<AircraftReport>();
    types.visit::<ParameterReport>();
    types.visit::<MeasureReport>();
    types.visit::<Report>();
    types.visit::<ResponseReport>();
    types.visit::<FrequencyReport>();
    types.visit::<SweepReport>();
    types.visit::<LinkReport>();
    types.visit::<TakenAlong>();
    types.visit::<Message>();
    types.visit::<Review>();

    let with_channel = Source::VALUES.iter().filter(|source| source.has_frequencies());
    types.union("PlaneName", keys::<Plane>());
    types.union("Target", keys::<Target>());
    types.union("Disturbance", keys::<Source>());
    types.union("ControlOrGust", with_channel.map(|source| source.key()));
    types.union("Shape", keys::<Shape>());
    types.union("MatrixFormat", MatrixFormat::NAMES.map(|(name, _)| name));
    types.union("Status", keys::<Status>());
    types.union("AircraftClass", keys::<Class>());
    types.union("FlightPhase", keys::<Category>());
    types.union("Stability", keys::<Stability>());
    types.union("ModeKey", keys::<ModeName>());
    types.union("ApproximationKey", keys::<ApproximationName>());
    types.union("CriterionKey", keys::<Criterion>());
    types.union("LevelKey", keys::<Level>());
    types.union("StabilityKind", sweep::Verdict::ALL.map(sweep::Verdict::key));

    if std::env::var_os("UPDATE_TYPES").is_some() {
        fs::write(COMMITTED, types.text()).expect("the sources can be written to");
    }
    let committed = fs::read_to_string(COMMITTED).expect("the types are committed");
    assert!(
        committed == types.text(),
        "{COMMITTED} is not current; the head of {} says how to write it",
        file!()
    );
    assert_eq!(types.unknown(), [""; 0], "types that are used and not there");
}

/// Declarations by name: a derive lists what a type is made of in no order.
#[derive(Default)]
struct Types(BTreeMap<String, String>);

impl TypeVisitor for Types {
    fn visit<T: TS + 'static + ?Sized>(&mut self) {
        let config = Config::default();
        let name = T::name(&config);
        if T::output_path().is_some() && !self.0.contains_key(&name) {
            let docs = T::docs().unwrap_or_default();
            self.0.insert(name, laid_out(&format!("{docs}export {}", T::decl(&config))));
            T::visit_dependencies(self);
        }
    }
}

impl Types {
    /// A type of words, from the table that requests are read by.
    fn union(&mut self, name: &str, words: impl IntoIterator<Item = &'static str>) {
        let words: Vec<String> = words.into_iter().map(|word| format!("\"{word}\"")).collect();
        self.0.insert(name.to_owned(), format!("export type {name} = {};\n", words.join(" | ")));
    }

    fn text(&self) -> String {
        let declarations = self.0.values().map(String::as_str);
        [HEAD].into_iter().chain(declarations).collect::<Vec<_>>().join("\n")
    }

    /// Names outside comments and strings that begin like those of types and are none.
    fn unknown(&self) -> Vec<&str> {
        let code = self
            .0
            .values()
            .flat_map(|text| text.lines())
            .filter(|line| !line.trim_start().starts_with(['/', '*']));
        code.flat_map(|line| line.split('"').step_by(2))
            .flat_map(|code| code.split(|c: char| !c.is_alphanumeric()))
            .filter(|word| word.starts_with(char::is_uppercase) && !["Array", "Record"].contains(word))
            .filter(|word| !self.0.contains_key(*word))
            .collect()
    }
}

fn keys<T: Keyed>() -> impl Iterator<Item = &'static str> {
    T::VALUES.iter().map(|value| value.key())
}

/// One field a line, indented, its comment before it.
fn laid_out(declaration: &str) -> String {
    let text = declaration
        .replace("/**\n * ", "/** ")
        .replace("\n */", " */")
        .replace(", }", ",\n}")
        .replace("\\[", "[")
        .replace("\\]", "]")
        .replace("[`", "`")
        .replace("`]", "`");
    let mut is_inside = false;
    let mut lines = String::new();
    for line in text.lines().map(str::trim_end) {
        is_inside &= !line.starts_with('}');
        lines += if is_inside && !line.is_empty() { "  " } else { "" };
        lines += line;
        lines += "\n";
        is_inside |= line.ends_with('{');
    }
    lines
}
