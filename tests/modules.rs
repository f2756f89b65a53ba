//! The order of modules, as src/lib.rs and src/flight/mod.rs tell it, and no circles between the files of the core.
//!
//! An arrow is a path (`crate::…`, `super::…`, or the name of a module of one's own) in what is compiled outside tests.
//! It ends in the file that holds the item, whatever other modules pass its name on.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use syn::ext::IdentExt as _;
use syn::punctuated::Punctuated;
use syn::visit::{self, Visit};
use syn::{Attribute, Expr, Item, Macro, Token, UseTree, Visibility};

/// Path of a module below the crate's root: `["flight", "modes", "eigen"]`.
type Module = Vec<String>;

const SOURCES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/src");

/// What a file says of others, in names that are not yet followed to their files.
#[derive(Default)]
struct File {
    children: BTreeSet<String>,
    /// A name and the path that it stands for, of each `use`.
    names: Vec<(String, Module)>,
    /// The names that it passes on, of `pub use`.
    passed_on: BTreeSet<String>,
    /// Paths in expressions, types and patterns.
    paths: Vec<Module>,
}

fn is_test(attributes: &[Attribute]) -> bool {
    attributes.iter().any(|attribute| {
        attribute.path().is_ident("test")
            || attribute.path().is_ident("cfg")
                && attribute.parse_args::<syn::Path>().is_ok_and(|path| path.is_ident("test"))
    })
}

/// The names that a tree of `use` brings in, with their paths.
fn names(tree: &UseTree, before: &[String], names: &mut Vec<(String, Module)>) {
    let longer = |name: &syn::Ident| [before, &[name.unraw().to_string()]].concat();
    match tree {
        UseTree::Path(path) => self::names(&path.tree, &longer(&path.ident), names),
        UseTree::Group(group) => group.items.iter().for_each(|tree| self::names(tree, before, names)),
        UseTree::Name(name) if name.ident == "self" => {
            names.extend(before.last().map(|name| (name.clone(), before.to_vec())));
        }
        UseTree::Name(name) => names.push((name.ident.unraw().to_string(), longer(&name.ident))),
        UseTree::Rename(rename) => names.push((rename.rename.unraw().to_string(), longer(&rename.ident))),
        UseTree::Glob(_) => names.push(("*".to_owned(), before.to_vec())),
    }
}

impl<'ast> Visit<'ast> for File {
    fn visit_item(&mut self, item: &'ast Item) {
        match item {
            Item::Mod(module) if is_test(&module.attrs) => {}
            Item::Mod(module) if module.content.is_none() => {
                self.children.insert(module.ident.to_string());
            }
            Item::Fn(function) if is_test(&function.attrs) => {}
            Item::Use(item) => {
                let first = self.names.len();
                names(&item.tree, &[], &mut self.names);
                if !matches!(item.vis, Visibility::Inherited) {
                    self.passed_on.extend(self.names[first..].iter().map(|(name, _)| name.clone()));
                }
            }
            _ => visit::visit_item(self, item),
        }
    }

    /// `pub(super)` is no arrow.
    fn visit_visibility(&mut self, _: &'ast Visibility) {}

    fn visit_path(&mut self, path: &'ast syn::Path) {
        self.paths.push(path.segments.iter().map(|segment| segment.ident.unraw().to_string()).collect());
        visit::visit_path(self, path);
    }

    fn visit_macro(&mut self, makro: &'ast Macro) {
        if let Ok(arguments) = makro.parse_body_with(Punctuated::<Expr, Token![,]>::parse_terminated) {
            arguments.iter().for_each(|argument| self.visit_expr(argument));
        }
    }
}

struct Sources {
    root: &'static Path,
    files: BTreeMap<Module, File>,
}

impl Sources {
    fn read() -> Self {
        let root = Path::new(SOURCES);
        let mut sources = Self { root, files: BTreeMap::new() };
        sources.add(Vec::new());
        sources
    }

    /// The file of a module, below `src`.
    fn path(&self, module: &[String]) -> String {
        let path = module.join("/");
        let candidates = [format!("{path}.rs"), format!("{path}/mod.rs"), "lib.rs".to_owned()];
        candidates.into_iter().find(|path| self.root.join(path).is_file()).expect("the root is a file")
    }

    /// Reads a module and all below it.
    fn add(&mut self, module: Module) {
        let path = self.root.join(self.path(&module));
        let text = std::fs::read_to_string(&path).expect("a source file can be read");
        let syntax = syn::parse_file(&text).expect("a source file is Rust");
        let mut file = File::default();
        file.visit_file(&syntax);
        for child in &file.children {
            self.add([&module[..], std::slice::from_ref(child)].concat());
        }
        self.files.insert(module, file);
    }

    /// The module whose file holds what a path in `module` names; `None` for other crates and local names.
    fn target(&self, module: &[String], path: &[String]) -> Option<Module> {
        let (first, mut rest) = path.split_first()?;
        let mut at = match first.as_str() {
            "crate" => Vec::new(),
            "self" => module.to_vec(),
            "super" => module[..module.len() - 1].to_vec(),
            // A name by itself is a local one.
            child if !rest.is_empty() && self.files[module].children.contains(child) => {
                [module, &[child.to_owned()]].concat()
            }
            _ => return None,
        };
        while let Some((name, further)) = rest.split_first() {
            let below = [&at[..], std::slice::from_ref(name)].concat();
            if name == "super" {
                at.pop();
            } else if self.files.contains_key(&below) {
                at = below;
            } else {
                let file = &self.files[&at];
                let passed =
                    file.names.iter().find(|(known, _)| known == name && file.passed_on.contains(name));
                return match passed {
                    Some((_, path)) => self.target(&at, path).or(Some(at)),
                    None => Some(at),
                };
            }
            rest = further;
        }
        Some(at)
    }

    /// All arrows from one file to another.
    fn arrows(&self) -> BTreeMap<Module, BTreeSet<Module>> {
        let arrows = |(module, file): (&Module, &File)| {
            let is_used = |name: &String| {
                !file.passed_on.contains(name) || file.paths.iter().any(|path| path.first() == Some(name))
            };
            let imported = file.names.iter().filter(|(name, _)| is_used(name)).map(|(_, path)| path);
            let ends = imported.chain(&file.paths).filter_map(|path| self.target(module, path));
            (module.clone(), ends.filter(|end| end != module).collect())
        };
        self.files.iter().map(arrows).collect()
    }
}

/// The rows of the table that begins with `heading` in a file's documentation, cell by cell.
fn table(file: &str, heading: &str) -> Vec<Vec<String>> {
    let path = Path::new(SOURCES).join(file);
    let text = std::fs::read_to_string(&path).expect("a source file can be read");
    let lines = text.lines().map(|line| line.trim_start_matches("//!").trim());
    // Below the heading stands a line of dashes.
    let rows = lines.skip_while(|line| !line.starts_with(heading)).skip(2);
    let rows = rows.take_while(|line| line.starts_with('|'));
    rows.map(|row| row.trim_matches('|').split('|').map(|cell| cell.trim().to_owned()).collect()).collect()
}

/// The names in backticks.
fn quoted(cell: &str) -> Vec<String> {
    cell.split('`').skip(1).step_by(2).map(str::to_owned).collect()
}

/// Modules in the order of a table, each with those above it that it may use.
fn order(
    rows: &[Vec<String>],
    uses: impl Fn(&[String]) -> Option<Vec<String>>,
) -> Vec<(String, Vec<String>)> {
    let mut above: Vec<String> = Vec::new();
    let mut order = Vec::new();
    for row in rows {
        let name = quoted(&row[0]).first().expect("a row begins with a name").clone();
        order.push((name.clone(), uses(row).unwrap_or_else(|| above.clone())));
        above.push(name);
    }
    order
}

/// The arrows from one module in `room` to another that the order doesn't allow.
fn forbidden(sources: &Sources, room: &[String], order: &[(String, Vec<String>)]) -> Vec<String> {
    let mut forbidden = Vec::new();
    for (from, ends) in sources.arrows() {
        for to in ends.iter().filter(|to| from.starts_with(room) && to.starts_with(room)) {
            let (Some(module), Some(used)) = (from.get(room.len()), to.get(room.len())) else { continue };
            let (_, uses) = order.iter().find(|(name, _)| name == module).expect("each has its row");
            if used != module && !uses.contains(used) {
                forbidden.push(format!("{} uses {}", sources.path(&from), sources.path(to)));
            }
        }
    }
    forbidden
}

fn sorted(names: impl IntoIterator<Item = String>) -> Vec<String> {
    BTreeSet::from_iter(names).into_iter().collect()
}

#[test]
fn a_module_uses_only_those_above_it_in_the_table_of_the_library() {
    let sources = Sources::read();
    let rows = table("lib.rs", "| module |");
    let order = order(&rows, |_| None);
    let missing: Vec<_> = sources.files[&Module::new()]
        .children
        .iter()
        .filter(|child| order.iter().all(|(name, _)| name != *child))
        .collect();
    assert!(missing.is_empty(), "without a row in src/lib.rs: {missing:?}");
    assert_eq!(forbidden(&sources, &[], &order), [""; 0]);
}

#[test]
fn a_room_of_flight_uses_only_what_its_row_names() {
    let sources = Sources::read();
    let flight = ["flight".to_owned()];
    let rows = table("flight/mod.rs", "| room |");
    let order = order(&rows, |row| match &row[2] {
        none if none == "–" => Some(Vec::new()),
        uses => Some(quoted(uses)).filter(|names| !names.is_empty()),
    });
    let names = sorted(order.iter().map(|(name, _)| name.clone()));
    assert_eq!(names, sorted(sources.files[&flight[..]].children.clone()), "the rows of src/flight/mod.rs");
    assert_eq!(forbidden(&sources, &flight, &order), [""; 0]);
}

#[test]
fn no_files_of_the_core_use_each_other_in_a_circle() {
    let sources = Sources::read();
    let arrows = sources.arrows();
    let reached = |start: &Module| {
        let (mut reached, mut next) = (BTreeSet::new(), vec![start.clone()]);
        while let Some(at) = next.pop() {
            next.extend(arrows[&at].iter().filter(|&end| reached.insert(end.clone())).cloned());
        }
        reached
    };
    let is_core = |module: &Module| module.first().is_some_and(|room| room != "ui" && room != "web");
    let reached: BTreeMap<_, _> =
        arrows.keys().filter(|module| is_core(module)).map(|module| (module, reached(module))).collect();
    let circles: BTreeSet<Vec<String>> = reached
        .iter()
        .map(|(module, ends)| ends.iter().filter(|end| reached[end].contains(*module)))
        .map(|circle| circle.map(|module| sources.path(module)).collect())
        .filter(|circle: &Vec<String>| !circle.is_empty())
        .collect();
    assert_eq!(circles, BTreeSet::new());
}

#[test]
fn every_path_in_the_architecture_leads_to_a_file() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(root.join("ARCHITECTURE.md")).expect("it stands at the top");
    let folders = ["assets/", "docs/", "src/", "tests/", "xtask/"];
    let is_path =
        |name: &String| folders.iter().any(|folder| name.starts_with(folder)) && !name.contains('*');
    let prose = text.split("```").step_by(2);
    let paths: Vec<String> = prose.flat_map(quoted).filter(is_path).collect();
    assert!(paths.len() > 30, "{paths:?}");
    let lost: Vec<_> = paths.iter().filter(|path| !root.join(path).exists()).collect();
    assert!(lost.is_empty(), "{lost:?}");
}

/// Lengths within a fifth, and what is named in a file stands in it.
#[test]
fn the_walk_tells_how_long_its_files_are_and_what_is_in_them() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let steps = table("../ARCHITECTURE.md", "| step |");
    assert!(steps.len() > 10, "{steps:?}");
    for step in steps {
        let [_, files, lengths, what] = &step[..] else { panic!("four columns: {step:?}") };
        let texts: Vec<String> = quoted(files)
            .iter()
            .map(|file| std::fs::read_to_string(root.join(file)).expect("a file of the walk"))
            .collect();
        let told: Vec<f64> =
            lengths.split(", ").map(|length| length.parse().expect("a number of lines")).collect();
        assert_eq!(told.len(), texts.len(), "{files}");
        for (told, text) in told.iter().zip(&texts) {
            let lines = text.lines().count() as f64;
            assert!((lines - told).abs() <= 0.2 * lines, "{files}: {told} lines are told, it has {lines}");
        }
        for name in quoted(what) {
            let name = name.rsplit("::").next().expect("a name").to_owned();
            assert!(texts.iter().any(|text| text.contains(&name)), "{files} has no {name}");
        }
    }
}
