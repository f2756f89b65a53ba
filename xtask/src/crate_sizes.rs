//! The code of the page by crate, so that growth is seen where it happens.
//!
//! Measured on the program as cargo leaves it: its functions still have their names there, which wasm-opt takes out.
//! A function counts for the crate of its name, and for the type that it drops or implements a trait for. Code that
//! was inlined counts for the function that it went into.

use std::collections::BTreeMap;

use anyhow::{Context as _, Result};
use rustc_demangle::demangle;
use wasmparser::{KnownCustom, Name, Parser, Payload, TypeRef};

use crate::project::{Project, WASM_TARGET};

/// Crates with less than this share of the code are added up.
const LEAST_SHARE: f64 = 0.01;

/// Prints a table of the crates in the page's program.
pub fn print(project: &Project) -> Result<()> {
    let path = project.target().join(WASM_TARGET).join("release/eigenwing.wasm");
    let program = std::fs::read(&path).with_context(|| format!("cannot read {}", path.display()))?;
    let mut sizes = Vec::from_iter(by_crate(&program)?);
    sizes.sort_by_key(|(_, size)| std::cmp::Reverse(*size));
    let total: usize = sizes.iter().map(|(_, size)| size).sum();
    let share = |size: usize| size as f64 / total.max(1) as f64;
    let (large, small): (Vec<_>, Vec<_>) =
        sizes.into_iter().partition(|(_, size)| share(*size) >= LEAST_SHARE);

    println!("{:>10} {:>7}  code of the page by crate, before wasm-opt and compression", "bytes", "share");
    let row = |name: &str, size| println!("{size:>10} {:>5.1} %  {name}", 100.0 * share(size));
    large.iter().for_each(|(name, size)| row(name, *size));
    row(&format!("{} others", small.len()), small.iter().map(|(_, size)| size).sum());
    row("together", total);
    Ok(())
}

/// Bytes of code of each crate.
fn by_crate(program: &[u8]) -> Result<BTreeMap<String, usize>> {
    let mut sizes = Vec::new();
    let mut names = BTreeMap::new();
    // Imported functions are numbered before those with code.
    let mut imported = 0;
    for payload in Parser::new(0).parse_all(program) {
        match payload? {
            Payload::ImportSection(imports) => {
                for import in imports.into_imports() {
                    imported += u32::from(matches!(import?.ty, TypeRef::Func(_)));
                }
            }
            Payload::CodeSectionEntry(body) => sizes.push(body.as_bytes().len()),
            Payload::CustomSection(section) => {
                let KnownCustom::Name(section) = section.as_known() else { continue };
                for kind in section {
                    let Name::Function(functions) = kind? else { continue };
                    for function in functions {
                        let function = function?;
                        names.insert(function.index, function.name);
                    }
                }
            }
            _ => {}
        }
    }
    let mut by_crate = BTreeMap::new();
    for (index, size) in (imported..).zip(sizes) {
        let name = names.get(&index).map_or_else(|| NAMELESS.to_owned(), |name| crate_of(name));
        *by_crate.entry(name).or_default() += size;
    }
    Ok(by_crate)
}

/// Functions without a name, or with that of no crate: the allocator's, and those that copy memory.
const NAMELESS: &str = "runtime";

/// The crate of a symbol.
fn crate_of(symbol: &str) -> String {
    let path = format!("{:#}", demangle(symbol));
    // The code that drops a value belongs to the value's type.
    let path = path.strip_prefix("core::ptr::drop_in_place").unwrap_or(&path);
    // `<&mut [T] as egui::Widget>::ui` belongs to egui: the first name that begins a path.
    let is_part = |c: char| c.is_alphanumeric() || c == '_';
    let starts = path.match_indices("::").map(|(end, _)| &path[..end]);
    let mut names = starts.map(|start| &start[start.trim_end_matches(is_part).len()..]);
    names.find(|name| !name.is_empty()).unwrap_or(NAMELESS).to_owned()
}

#[cfg(test)]
mod tests {
    use super::{NAMELESS, crate_of};

    #[test]
    fn a_function_counts_for_its_crate_its_type_or_the_type_that_it_drops() {
        for (symbol, name) in [
            ("_ZN11toml_parser7decoder6scalar12is_any_digit17h479b9829facf6844E", "toml_parser"),
            (
                "_ZN59_$LT$egui..context..Context$u20$as$u20$core..fmt..Debug$GT$3fmt17h0123456789abcdefE",
                "egui",
            ),
            (
                "_ZN62_$LT$$RF$mut$u20$epaint..Shape$u20$as$u20$core..fmt..Debug$GT$3fmt17h0123456789abcdefE",
                "epaint",
            ),
            ("_ZN4core3ptr38drop_in_place$LT$glow..web..Shader$GT$17h0123456789abcdefE", "glow"),
            ("_ZN4core3fmt5write17h0123456789abcdefE", "core"),
            ("_ZN42_$LT$$RF$T$u20$as$u20$core..fmt..Debug$GT$3fmt17h0123456789abcdefE", "core"),
            ("memcpy", NAMELESS),
        ] {
            assert_eq!(crate_of(symbol), name, "{symbol}");
        }
    }
}
