//! Which crate may depend on which, from `cargo metadata`; normal, build and development dependencies alike.

use std::path::Path;
use std::process::Command;

use serde_json::Value;

use super::finding::{Finding, Rule};
use super::tree::Tree;

/// Each package of the workspace and the packages of the workspace that it may depend on.
const EDGES: [(&str, &[&str]); 11] = [
    ("trigon-image", &[]),
    ("trigon", &["trigon-image"]),
    ("trigon-scene", &["trigon", "trigon-image"]),
    ("trigon-svg", &["trigon", "trigon-image"]),
    // Its goldens are compared by the tests' package.
    ("trigon-cli", &["trigon", "trigon-image", "trigon-scene", "trigon-svg", "trigon-tests"]),
    ("trigon-viewer", &["trigon", "trigon-image", "trigon-scene", "trigon-svg"]),
    ("trigon-python", &["trigon", "trigon-image", "trigon-scene", "trigon-svg"]),
    ("trigon-tests", &["trigon", "trigon-image", "trigon-scene", "trigon-svg"]),
    ("trigon-bench", &["trigon", "trigon-image", "trigon-scene", "trigon-svg"]),
    ("trigon-fuzz", &["trigon", "trigon-image", "trigon-scene", "trigon-svg"]),
    ("xtask", &[]),
];

static EDGE: Rule = Rule {
    name: "crate-edge",
    why: "the rasterizer knows no file, scene or window, and the 3D and 2D front ends know nothing of each other",
    fix: "move what both need into the crate below, or pass it in from the crate above",
    excusable: false,
};

static LINTS: Rule = Rule {
    name: "lints",
    why: "a package without the workspace lints is checked by nobody",
    fix: "add `[lints]` with `workspace = true` to its Cargo.toml",
    excusable: false,
};

/// Runs `cargo metadata` for the workspace at `root`.
pub(crate) fn metadata(root: &Path) -> Result<Value, String> {
    let output = Command::new(env!("CARGO"))
        .current_dir(root)
        .args(["metadata", "--format-version", "1"])
        .output()
        .map_err(|error| format!("cargo does not start: {error}"))?;
    if !output.status.success() {
        return Err(format!("cargo metadata fails: {}", String::from_utf8_lossy(&output.stderr).trim()));
    }
    serde_json::from_slice(&output.stdout).map_err(|error| format!("cargo metadata is not JSON: {error}"))
}

/// Dependencies between the packages of the workspace, and that each package inherits the lints.
pub(crate) fn check(metadata: &Value, tree: &Tree) -> Vec<Finding> {
    let root = metadata["workspace_root"].as_str().unwrap_or_default();
    let members = members(metadata);
    let names: Vec<&str> = members.iter().filter_map(|package| package["name"].as_str()).collect();
    let mut findings = Vec::new();
    for package in members {
        let name = package["name"].as_str().unwrap_or_default();
        let manifest = manifest_path(package, root);
        let allowed = EDGES.iter().find(|(crate_name, _)| *crate_name == name).map(|(_, allowed)| *allowed);
        if allowed.is_none() {
            let message = format!("`{name}` is not in the table of crate edges in xtask/src/tidy/edges.rs");
            findings.push(Finding::new(&EDGE, &manifest, 0, message));
        }
        for dependency in package["dependencies"].as_array().into_iter().flatten() {
            let dependency = dependency["name"].as_str().unwrap_or_default();
            if names.contains(&dependency) && !allowed.unwrap_or_default().contains(&dependency) && dependency != name {
                let line = tree.text(&manifest).map_or(0, |text| line_of(text, dependency));
                let message = format!("`{name}` must not depend on `{dependency}`");
                findings.push(Finding::new(&EDGE, &manifest, line, message));
            }
        }
        if !tree.text(&manifest).is_some_and(inherits_lints) {
            findings.push(Finding::new(&LINTS, &manifest, 0, "does not inherit the workspace lints"));
        }
    }
    findings
}

/// The packages of the workspace.
pub(crate) fn members(metadata: &Value) -> Vec<&Value> {
    let ids = metadata["workspace_members"].as_array();
    let is_member = |package: &&Value| ids.is_some_and(|ids| ids.contains(&package["id"]));
    metadata["packages"].as_array().into_iter().flatten().filter(is_member).collect()
}

/// The path of a package's Cargo.toml, relative to the workspace, with forward slashes.
fn manifest_path(package: &Value, root: &str) -> String {
    let path = package["manifest_path"].as_str().unwrap_or_default();
    path.strip_prefix(root).unwrap_or(path).replace('\\', "/").trim_start_matches('/').to_owned()
}

/// The line on which a key of that name begins, or 0.
fn line_of(manifest: &str, key: &str) -> usize {
    let begins = |line: &str| {
        line.strip_prefix(key).is_some_and(|rest| rest.starts_with(['.', ' ', '=']))
            || line.trim_end().strip_suffix(']').is_some_and(|section| section.ends_with(&format!(".{key}")))
    };
    manifest.lines().position(begins).map_or(0, |index| index + 1)
}

fn inherits_lints(manifest: &str) -> bool {
    let mut lines = manifest.lines().map(str::trim);
    lines.any(|line| line == "[lints]") && lines.next() == Some("workspace = true")
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    /// A workspace of the packages, each with the names of its dependencies.
    fn workspace(packages: &[(&str, &[&str])]) -> (Value, Tree) {
        let package = |(name, dependencies): &(&str, &[&str])| {
            let dependencies: Vec<Value> = dependencies.iter().map(|name| json!({ "name": name })).collect();
            json!({ "name": name, "id": name, "manifest_path": format!("/w/{name}/Cargo.toml"), "dependencies": dependencies })
        };
        let ids: Vec<&str> = packages.iter().map(|(name, _)| *name).collect();
        let values: Vec<Value> = packages.iter().map(package).collect();
        let metadata = json!({ "workspace_root": "/w", "workspace_members": ids, "packages": values });
        let paths: Vec<String> = ids.iter().map(|name| format!("{name}/Cargo.toml")).collect();
        let manifest = "[lints]\nworkspace = true\n[dependencies]\ntrigon.workspace = true\n";
        let files: Vec<(&str, &str)> = paths.iter().map(|path| (path.as_str(), manifest)).collect();
        (metadata, Tree::of(&files))
    }

    #[test]
    fn the_designed_edges_are_allowed() {
        let (metadata, tree) = workspace(&EDGES);
        assert!(check(&metadata, &tree).is_empty());
    }

    #[test]
    fn an_edge_upwards_or_across_is_found() {
        for (from, to) in [("trigon-image", "trigon"), ("trigon", "trigon-scene"), ("trigon-svg", "trigon-scene")] {
            let (metadata, tree) = workspace(&[(from, &[to, "png"]), (to, &[])]);
            assert_eq!(check(&metadata, &tree).len(), 1, "{from} on {to}");
        }
    }

    #[test]
    fn the_finding_names_the_line() {
        let (metadata, tree) = workspace(&[("trigon-image", &["trigon"]), ("trigon", &[])]);
        assert_eq!(
            check(&metadata, &tree)[0].place_and_message(),
            "trigon-image/Cargo.toml:4: `trigon-image` must not depend on `trigon`"
        );
    }

    #[test]
    fn a_new_package_must_be_placed() {
        let (metadata, tree) = workspace(&[("trigon-audio", &[])]);
        assert_eq!(check(&metadata, &tree).len(), 1);
    }

    #[test]
    fn lints_are_inherited() {
        let (metadata, _) = workspace(&[("xtask", &[])]);
        let tree = Tree::of(&[("xtask/Cargo.toml", "[package]\nname = \"xtask\"\n")]);
        assert_eq!(check(&metadata, &tree).len(), 1);
    }
}
