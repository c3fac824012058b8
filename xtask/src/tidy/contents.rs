//! `mod.rs` is a table of contents: documentation, `mod`, `use` and attributes, nothing else.

use super::finding::{Finding, Rule};
use super::tokens::{Scan, scan};
use super::tree::Tree;

static CONTENTS: Rule = Rule {
    name: "table-of-contents",
    why: "who opens a folder reads `mod.rs` to see what is in it; code there is found by nobody",
    fix: "move the item into a file named after it, and `pub use` it here",
    excusable: false,
};

pub(crate) fn check(tree: &Tree) -> Vec<Finding> {
    let mut findings = Vec::new();
    for (path, text) in tree.rust().filter(|(path, _)| path.ends_with("/mod.rs")) {
        let scan = scan(text);
        if let Some(line) = first_line_of_code(&scan) {
            findings.push(Finding::new(&CONTENTS, path, line, "holds more than `mod` and `use`"));
        }
    }
    findings
}

/// The line of the first item that is neither `mod name;` nor `use ..;`.
fn first_line_of_code(scan: &Scan<'_>) -> Option<usize> {
    let mut at = 0;
    while at < scan.tokens.len() {
        at = after_attributes_and_visibility(scan, at);
        let line = scan.tokens.get(at)?.line;
        match scan.text(at) {
            "mod" if scan.text(at + 2) == ";" => at += 3,
            "use" => at = (at..scan.tokens.len()).find(|index| scan.text(*index) == ";").map_or(at, |end| end + 1),
            _ => return Some(line),
        }
    }
    None
}

fn after_attributes_and_visibility(scan: &Scan<'_>, mut at: usize) -> usize {
    loop {
        if scan.is_at(at, &["#", "!", "["]) {
            at = scan.closing(at + 2) + 1;
        } else if scan.is_at(at, &["#", "["]) || scan.is_at(at, &["pub", "("]) {
            at = scan.closing(at + 1) + 1;
        } else if scan.text(at) == "pub" {
            at += 1;
        } else {
            return at;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line(text: &str) -> Option<usize> {
        check(&Tree::of(&[("crates/a/src/b/mod.rs", text)])).first().map(|finding| finding.line)
    }

    #[test]
    fn modules_uses_and_attributes_are_contents() {
        let text = "//! Doc.\n#![expect(x)]\n#[macro_use]\nmod a;\npub mod b;\npub(crate) use a::{C, d::E};\n#[cfg(test)]\nmod tests;\n";
        assert_eq!(line(text), None);
    }

    #[test]
    fn anything_else_is_code() {
        assert_eq!(line("//! Doc.\nmod a;\nfn f() {}\n"), Some(3));
        assert_eq!(line("//! Doc.\n#[cfg(test)]\nmod tests { use super::*; }\n"), Some(3));
        assert_eq!(line("//! Doc.\npub struct A;\nmod a;\n"), Some(2));
        assert_eq!(line("//! Doc.\nmacro_rules! m { () => {} }\n"), Some(2));
    }

    #[test]
    fn other_files_may_hold_code() {
        assert!(check(&Tree::of(&[("src/lib.rs", "fn f() {}"), ("src/model.rs", "fn f() {}")])).is_empty());
    }
}
