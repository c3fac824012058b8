//! The order of the stages inside `trigon`: geometry, raster, shade, resolve; a stage never names a later one.
//!
//! Names are resolved as far as tokens allow: `crate::x`, `crate::{x, y}`, chains of `super`, and names that
//! `lib.rs` re-exports from a stage, so that `crate::Shader` counts as `crate::shade`.

use std::collections::HashMap;

use super::finding::{Finding, Rule};
use super::tokens::{Kind, Scan, scan};
use super::tree::Tree;

const SOURCE: &str = "crates/trigon/src/";
/// From first to last; the pipeline runs them all and comes after them.
const STAGES: [&str; 5] = ["geometry", "raster", "shade", "resolve", PIPELINE];
const PIPELINE: &str = "pipeline";
/// Modules that every stage stands on.
const FOUNDATIONS: [&str; 3] = ["explain", "lanes", "math"];

static STAGE: Rule = Rule {
    name: "stage-order",
    why: "each stage can be read, tested and replaced alone as long as it knows only what comes before it",
    fix: "let the earlier stage produce a type of its own and the later one consume it; what joins stages belongs \
          into pipeline.rs",
    excusable: false,
};

pub(crate) fn check(tree: &Tree) -> Vec<Finding> {
    let exports = tree.text("crates/trigon/src/lib.rs").map(|text| exported_stages(&scan(text))).unwrap_or_default();
    let mut findings = Vec::new();
    for (path, text) in tree.rust() {
        let Some(inside) = path.strip_prefix(SOURCE) else { continue };
        let modules = module_path(inside);
        let Some(first_forbidden) = modules.first().and_then(|module| first_forbidden(module)) else { continue };
        for (name, line) in names_from_the_crate_root(&scan(text), modules.len()) {
            let stage = exports.get(name).copied().unwrap_or(name);
            if STAGES[first_forbidden..].contains(&stage) {
                let message = format!("`{}` names `{name}`, which belongs to the later `{stage}`", modules[0]);
                findings.push(Finding::new(&STAGE, path, line, message));
            }
        }
    }
    findings
}

/// The index of the first stage that `module` must not name; `None` where it may name all.
fn first_forbidden(module: &str) -> Option<usize> {
    if FOUNDATIONS.contains(&module) {
        return Some(0);
    }
    STAGES.iter().position(|stage| *stage == module).map(|stage| stage + 1)
}

/// `raster/setup.rs` to `[raster, setup]`, `raster/mod.rs` to `[raster]`, `lib.rs` to nothing.
fn module_path(inside: &str) -> Vec<&str> {
    let mut modules: Vec<&str> = inside.trim_end_matches(".rs").split('/').collect();
    if matches!(modules.last(), Some(&("mod" | "lib"))) {
        modules.pop();
    }
    modules
}

/// Every name that follows the crate root in a path of the file, with its line. `depth` is the number of modules
/// that the file is inside of, so that as many `super` reach the root.
fn names_from_the_crate_root<'t>(scan: &Scan<'t>, depth: usize) -> Vec<(&'t str, usize)> {
    let mut names = Vec::new();
    let mut at = 0;
    while at < scan.tokens.len() {
        let supers = (0..).take_while(|step| scan.is_at(at + 2 * step, &["super", "::"])).count();
        if scan.is_at(at, &["crate", "::"]) {
            names.extend(names_at(scan, at + 2));
        } else if supers >= depth && supers > 0 {
            names.extend(names_at(scan, at + 2 * supers));
        }
        at += 1 + 2 * supers;
    }
    names
}

/// The first segments of the paths at `at`: one name, or those of a group `{a, b::c}`.
fn names_at<'t>(scan: &Scan<'t>, at: usize) -> Vec<(&'t str, usize)> {
    if scan.text(at) != "{" {
        return scan.tokens.get(at).map(|token| vec![(token.text, token.line)]).unwrap_or_default();
    }
    let mut names = Vec::new();
    let mut index = at + 1;
    let end = scan.closing(at);
    while index < end {
        let token = scan.tokens[index];
        match token.text {
            "{" => index = scan.closing(index),
            _ if token.kind == Kind::Ident && matches!(scan.text(index - 1), "{" | ",") => {
                names.push((token.text, token.line));
            }
            _ => {}
        }
        index += 1;
    }
    names
}

/// What `lib.rs` re-exports from the stages: name to stage.
fn exported_stages<'t>(scan: &Scan<'t>) -> HashMap<&'t str, &'t str> {
    let mut exports = HashMap::new();
    for start in 0..scan.tokens.len() {
        if scan.text(start) != "use" {
            continue;
        }
        let first = if scan.is_at(start + 1, &["crate", "::"]) { start + 3 } else { start + 1 };
        let stage = scan.text(first);
        if !STAGES.contains(&stage) {
            continue;
        }
        // Every name up to the semicolon that no `::` follows is one that the use brings in.
        for index in first + 1.. {
            match scan.tokens.get(index) {
                Some(token) if token.text != ";" => {
                    if token.kind == Kind::Ident && scan.text(index + 1) != "::" {
                        exports.insert(token.text, stage);
                    }
                }
                _ => break,
            }
        }
    }
    exports
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lines(path: &str, text: &str) -> Vec<usize> {
        let library = "pub mod raster;\npub use shade::{Shader, fragment::Fragment as Frag};\npub use raster::Mask;\n";
        let tree = Tree::of(&[("crates/trigon/src/lib.rs", library), (&format!("{SOURCE}{path}"), text)]);
        check(&tree).iter().map(|finding| finding.line).collect()
    }

    #[test]
    fn earlier_stages_and_foundations_may_be_named() {
        assert!(
            lines("shade/a.rs", "use crate::{geometry::Vertex, raster::Mask, lanes, math::sin};\nuse super::b;\n")
                .is_empty()
        );
        assert!(lines("pipeline.rs", "use crate::{geometry, raster, shade, resolve};\n").is_empty());
        assert!(lines("pipeline/frame.rs", "use crate::resolve::Store;\n").is_empty());
    }

    #[test]
    fn later_stages_may_not() {
        assert_eq!(lines("raster/a.rs", "\nuse crate::shade::Fragment;\n"), [2]);
        assert_eq!(
            lines("raster/a.rs", "use crate::{\n    geometry::{Vertex, shade},\n    resolve::Store,\n};\n"),
            [3]
        );
        assert_eq!(lines("geometry/a.rs", "fn f() { crate::pipeline::draw(); }\n"), [1]);
        assert_eq!(lines("resolve/mod.rs", "use crate::pipeline;\n"), [1]);
    }

    #[test]
    fn super_is_followed_to_the_root() {
        assert_eq!(lines("raster/a.rs", "use super::super::shade::Fragment;\n"), [1]);
        assert!(lines("raster/a.rs", "use super::shade::Fragment;\n").is_empty());
        assert_eq!(lines("raster/mod.rs", "use super::shade::Fragment;\n"), [1]);
    }

    #[test]
    fn re_exports_do_not_hide_a_stage() {
        assert_eq!(lines("raster/a.rs", "use crate::Shader;\n"), [1]);
        assert_eq!(lines("raster/a.rs", "use crate::Frag;\n"), [1]);
        assert!(lines("raster/a.rs", "use crate::Mask;\n").is_empty());
    }

    #[test]
    fn foundations_name_no_stage() {
        assert_eq!(lines("lanes/a.rs", "use crate::geometry::Vertex;\n"), [1]);
        assert_eq!(lines("math/a.rs", "use crate::lanes::Lanes;\nuse crate::raster::Mask;\n"), [2]);
    }
}
