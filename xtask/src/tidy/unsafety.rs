//! `unsafe` lives in one folder, and each use names the check that makes it sound. The one exception are attributes
//! that give an export of a WebAssembly module its name.

use super::finding::{Finding, Rule};
use super::tokens::{Scan, scan};
use super::tree::Tree;

/// The only folder in which the keyword may appear.
const FOLDER: &str = "crates/trigon/src/lanes/";

/// Modules whose functions are called by name from outside: there the attribute `#[unsafe(no_mangle)]` may stand.
const EXPORTS: [&str; 1] = ["tests/cross/wasm.rs"];

static PLACE: Rule = Rule {
    name: "unsafe-place",
    why: "soundness is reviewed in one folder; everywhere else it is a fact of the language",
    fix: "use a safe operation of crates/trigon/src/lanes, or add one there",
    excusable: false,
};

static REASON: Rule = Rule {
    name: "unsafe-reason",
    why: "an unsafe operation is right only because of a check somewhere else, which the next change may remove",
    fix: "write `// SAFETY: ..` right above, naming the check that makes the operation sound",
    excusable: false,
};

/// No `unsafe` outside the folder, but for the names of exports.
pub(crate) fn places(tree: &Tree) -> Vec<Finding> {
    let mut findings = Vec::new();
    for (path, text) in tree.rust().filter(|(path, _)| !path.starts_with(FOLDER)) {
        let scan = scan(text);
        for index in (0..scan.tokens.len()).filter(|index| scan.text(*index) == "unsafe") {
            let names_export = scan.is_at(index, &["unsafe", "(", "no_mangle", ")"]);
            if !(names_export && EXPORTS.contains(&path)) {
                let line = scan.tokens[index].line;
                findings.push(Finding::new(&PLACE, path, line, format!("`unsafe` outside {FOLDER}")));
            }
        }
    }
    findings
}

/// A SAFETY comment above each `unsafe` where it may stand.
pub(crate) fn reasons(tree: &Tree) -> Vec<Finding> {
    let mut findings = Vec::new();
    let may_stand = |path: &str| path.starts_with(FOLDER) || EXPORTS.contains(&path);
    for (path, text) in tree.rust().filter(|(path, _)| may_stand(path)) {
        let scan = scan(text);
        let lines: Vec<&str> = text.lines().collect();
        for token in scan.tokens.iter().filter(|token| token.text == "unsafe") {
            if !has_reason(&scan, &lines, token.line) {
                findings.push(Finding::new(&REASON, path, token.line, "`unsafe` without a SAFETY comment"));
            }
        }
    }
    findings
}

/// Whether a comment with `SAFETY:` (or a `# Safety` section) is on `line` or directly above it, where only comments,
/// attributes and the beginning of the same statement may stand in between.
fn has_reason(scan: &Scan<'_>, lines: &[&str], line: usize) -> bool {
    let is_reason = |text: &str| text.contains("SAFETY:") || text.contains("# Safety");
    let mut at = line;
    loop {
        if scan.comments.iter().any(|comment| comment.line == at && is_reason(comment.text)) {
            return true;
        }
        // Climb while the line above belongs to the same statement.
        let Some(above) = at.checked_sub(2).and_then(|index| lines.get(index)) else { return false };
        let above = above.trim_end();
        let ends_statement = above.ends_with([';', '{', '}']) && !above.trim_start().starts_with("//");
        if above.is_empty() || ends_statement {
            return false;
        }
        at -= 1;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn reasons_missing(text: &str) -> usize {
        reasons(&Tree::of(&[("crates/trigon/src/lanes/avx2.rs", text)])).len()
    }

    #[test]
    fn the_word_in_text_is_not_the_keyword() {
        let tree =
            Tree::of(&[("crates/trigon/src/raster/a.rs", "// unsafe\nconst A: &str = \"unsafe\"; // unsafe_code\n")]);
        assert!(places(&tree).is_empty());
    }

    #[test]
    fn the_keyword_belongs_into_lanes() {
        let text = "fn f() { unsafe { g() } }";
        let tree = Tree::of(&[("crates/trigon/src/raster/a.rs", text), ("crates/trigon/src/lanes/a.rs", text)]);
        assert_eq!(places(&tree).len(), 1);
    }

    #[test]
    fn only_names_of_exports_may_stand_in_their_file() {
        let text = "// SAFETY: unique.\n#[unsafe(no_mangle)]\npub extern \"C\" fn f() {}\nfn g() { unsafe { h() } }\n";
        let tree = Tree::of(&[("tests/cross/wasm.rs", text), ("tests/cross/other.rs", text)]);
        let found: Vec<_> = places(&tree).into_iter().map(|finding| (finding.path, finding.line)).collect();
        let expected = [("tests/cross/wasm.rs", 4), ("tests/cross/other.rs", 2), ("tests/cross/other.rs", 4)];
        assert_eq!(found, expected.map(|(path, line)| (path.to_owned(), line)));
        assert_eq!(reasons(&tree).len(), 1);
    }

    #[test]
    fn a_reason_stands_directly_above() {
        assert_eq!(reasons_missing("// SAFETY: checked.\n#[expect(unsafe_code)]\nlet a =\n    unsafe { f() };\n"), 0);
        assert_eq!(reasons_missing("let a = unsafe { f() }; // SAFETY: checked.\n"), 0);
        assert_eq!(reasons_missing("/// # Safety\n/// Needs AVX2.\npub unsafe fn f() {}\n"), 0);
    }

    #[test]
    fn a_reason_does_not_reach_past_a_statement() {
        assert_eq!(reasons_missing("// SAFETY: checked.\nunsafe { f() };\nunsafe { g() };\n"), 1);
        assert_eq!(reasons_missing("// SAFETY: checked.\n\nunsafe { f() };\n"), 1);
        assert_eq!(reasons_missing("unsafe { f() };\n"), 1);
    }
}
