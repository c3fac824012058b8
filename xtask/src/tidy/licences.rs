//! The licences of everything we link to: only permissive ones, so that users of `trigon` owe nobody but a notice.
//!
//! Reads the SPDX expression of each package (`MIT OR Apache-2.0`, `(A OR B) AND C`, the older `A/B`) and asks
//! whether it can be satisfied with the licences below. What is not in the list needs a person to look at it.

use serde_json::Value;

use super::finding::{Finding, Rule};

const PERMISSIVE: [&str; 17] = [
    "0BSD",
    "Apache-2.0",
    "Apache-2.0 WITH LLVM-exception",
    "BSD-1-Clause",
    "BSD-2-Clause",
    "BSD-3-Clause",
    "BSL-1.0",
    "CC0-1.0",
    "IJG",
    "ISC",
    "MIT",
    "MIT-0",
    "NCSA",
    "Unicode-3.0",
    "Unicode-DFS-2016",
    "Unlicense",
    "Zlib",
];

static LICENCE: Rule = Rule {
    name: "licence",
    why: "a GPL, LGPL or AGPL dependency would bind everyone who links trigon, and an unknown one might",
    fix: "choose another crate; if the licence is permissive, add it to xtask/src/tidy/licences.rs",
    excusable: false,
};

pub(crate) fn check(metadata: &Value) -> Vec<Finding> {
    let mut findings = Vec::new();
    for package in metadata["packages"].as_array().into_iter().flatten() {
        let name = package["name"].as_str().unwrap_or_default();
        let version = package["version"].as_str().unwrap_or_default();
        let message = match package["license"].as_str() {
            Some(expression) if is_permissive(expression) => continue,
            Some(expression) => format!("{name} {version} is under `{expression}`"),
            None => format!("{name} {version} does not state its licence"),
        };
        findings.push(Finding::new(&LICENCE, "Cargo.lock", 0, message));
    }
    findings
}

/// Whether the SPDX expression can be satisfied with permissive licences alone.
fn is_permissive(expression: &str) -> bool {
    let spaced = expression.replace('/', " OR ").replace('(', " ( ").replace(')', " ) ");
    let words: Vec<&str> = spaced.split_whitespace().collect();
    let mut at = 0;
    let satisfied = alternatives(&words, &mut at);
    satisfied && at == words.len()
}

/// `term AND term OR term ..`: AND binds tighter.
fn alternatives(words: &[&str], at: &mut usize) -> bool {
    let mut any = conjunction(words, at);
    while words.get(*at) == Some(&"OR") {
        *at += 1;
        any |= conjunction(words, at);
    }
    any
}

fn conjunction(words: &[&str], at: &mut usize) -> bool {
    let mut all = licence(words, at);
    while words.get(*at) == Some(&"AND") {
        *at += 1;
        all &= licence(words, at);
    }
    all
}

fn licence(words: &[&str], at: &mut usize) -> bool {
    let Some(word) = words.get(*at) else { return false };
    *at += 1;
    if *word == "(" {
        let inside = alternatives(words, at);
        let closed = words.get(*at) == Some(&")");
        *at += 1;
        return inside && closed;
    }
    if words.get(*at) == Some(&"WITH") {
        let exception = words.get(*at + 1).copied().unwrap_or_default();
        *at += 2;
        return PERMISSIVE.contains(&format!("{word} WITH {exception}").as_str());
    }
    PERMISSIVE.contains(word)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_permissive_alternative_is_enough() {
        for expression in [
            "MIT",
            "MIT OR Apache-2.0",
            "MIT/GPL-3.0",
            "(GPL-2.0 OR MIT) AND Unicode-3.0",
            "Apache-2.0 WITH LLVM-exception",
        ] {
            assert!(is_permissive(expression), "{expression}");
        }
    }

    #[test]
    fn copyleft_and_unknown_are_not() {
        for expression in [
            "GPL-3.0",
            "LGPL-2.1-only",
            "AGPL-3.0-or-later",
            "MIT AND GPL-2.0",
            "MIT AND (LGPL-3.0 OR GPL-3.0)",
            "",
            "Acme",
            "(MIT",
            "MIT MIT",
        ] {
            assert!(!is_permissive(expression), "{expression}");
        }
    }

    #[test]
    fn a_package_without_licence_is_found() {
        let metadata = serde_json::json!({ "packages": [{ "name": "a", "version": "1.0.0", "license": null }, { "name": "b", "license": "MIT" }] });
        assert_eq!(check(&metadata).len(), 1);
    }
}
