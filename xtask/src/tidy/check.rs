//! Runs every rule on the tree and prints the findings, grouped by rule.

use std::path::Path;

use super::finding::{Finding, Rule};
use super::tree::Tree;
use super::{contents, edges, files, lanes, licences, markdown, stages, tokens, unfinished, unsafety, words};

/// Rules that look at the tree alone.
const TREE_RULES: [fn(&Tree) -> Vec<Finding>; 14] = [
    files::headers,
    files::lengths,
    files::names,
    files::documents,
    files::golden_sizes,
    contents::check,
    stages::check,
    unsafety::places,
    unsafety::reasons,
    unfinished::check,
    lanes::closures,
    lanes::fused,
    words::check,
    markdown::check,
];

static UNUSED_EXCUSE: Rule = Rule {
    name: "unused-excuse",
    why: "an excuse that excuses nothing hides the next finding on its line",
    fix: "delete the comment, or correct the rule's name, or give the reason after the colon",
    excusable: false,
};

/// Checks the tree at `root`; an error says how many findings were printed.
pub(crate) fn run(root: &Path) -> Result<(), String> {
    let tree = Tree::read(root)?;
    let metadata = edges::metadata(root)?;
    let mut findings: Vec<Finding> = TREE_RULES.iter().flat_map(|rule| rule(&tree)).collect();
    findings.extend(edges::check(&metadata, &tree));
    findings.extend(licences::check(&metadata));
    let findings = without_excused(&tree, findings);
    print(&findings);
    if findings.is_empty() {
        println!("tidy: {} files, no findings", tree.files.len());
        Ok(())
    } else {
        Err(format!("tidy: {} findings in {} files", findings.len(), tree.files.len()))
    }
}

fn print(findings: &[Finding]) {
    let mut rules: Vec<&'static Rule> = Vec::new();
    for finding in findings {
        if !rules.contains(&finding.rule) {
            rules.push(finding.rule);
        }
    }
    for rule in rules {
        println!("[{}]", rule.name);
        for finding in findings.iter().filter(|finding| finding.rule == rule) {
            println!("{}", finding.place_and_message());
        }
        println!("  why: {}\n  do:  {}\n", rule.why, rule.fix);
    }
}

/// A comment `tidy: allow(rule): reason`.
struct Excuse<'t> {
    path: &'t str,
    line: usize,
    rule: &'t str,
    used: bool,
}

/// Drops the findings that a comment excuses, and adds one for each excuse that was not needed.
fn without_excused(tree: &Tree, findings: Vec<Finding>) -> Vec<Finding> {
    let mut excuses: Vec<Excuse<'_>> = tree.rust().flat_map(|(path, text)| excuses_in(path, text)).collect();
    let mut kept = Vec::new();
    for finding in findings {
        let excuse = excuses.iter_mut().find(|excuse| {
            finding.rule.excusable
                && excuse.rule == finding.rule.name
                && excuse.path == finding.path
                && (excuse.line == finding.line || excuse.line + 1 == finding.line)
        });
        match excuse {
            Some(excuse) => excuse.used = true,
            None => kept.push(finding),
        }
    }
    for excuse in excuses.iter().filter(|excuse| !excuse.used) {
        let message = format!("`tidy: allow({})` excuses nothing here", excuse.rule);
        kept.push(Finding::new(&UNUSED_EXCUSE, excuse.path, excuse.line, message));
    }
    kept
}

fn excuses_in<'t>(path: &'t str, text: &'t str) -> Vec<Excuse<'t>> {
    let mut excuses = Vec::new();
    for comment in tokens::scan(text).comments {
        // Documentation may talk about excuses; only a plain comment is one.
        let Some(rest) = comment.text.strip_prefix("// tidy: allow(") else { continue };
        if let Some((rule, reason)) = rest.split_once("):") {
            let rule = if reason.trim().is_empty() { "" } else { rule };
            excuses.push(Excuse { path, line: comment.line, rule, used: false });
        }
    }
    excuses
}

#[cfg(test)]
mod tests {
    use super::*;

    fn kernel(comment: &str) -> Tree {
        let text = format!("fn f<L: Lanes>(l: L) {{\n    {comment}\n    (0..4).for_each(|i| g(i));\n}}\n");
        Tree::of(&[("crates/trigon/src/shade/x.rs", &text)])
    }

    #[test]
    fn a_reason_excuses_one_finding() {
        let tree = kernel("// tidy: allow(lane-closure): scalar loop over four levels");
        assert!(without_excused(&tree, lanes::closures(&tree)).is_empty());
    }

    #[test]
    fn an_excuse_without_reason_or_use_is_a_finding() {
        let tree = kernel("// tidy: allow(lane-closure):");
        assert_eq!(without_excused(&tree, lanes::closures(&tree)).len(), 2);
        let tree = Tree::of(&[("a.rs", "// tidy: allow(lane-closure): no closure here\n")]);
        assert_eq!(without_excused(&tree, Vec::new()).len(), 1);
    }
}
