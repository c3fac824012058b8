//! Nothing unfinished in the tree: no placeholder macro, no mark in a comment that says "later".

use super::finding::{Finding, Rule};
use super::tokens::scan;
use super::tree::Tree;

/// Split so that this file does not find itself.
const MARKS: [&str; 3] = [concat!("FIX", "ME"), concat!("TO", "DO"), concat!("XX", "X")];
const MACROS: [&str; 2] = ["todo", "unimplemented"];

static UNFINISHED: Rule = Rule {
    name: "unfinished",
    why: "a note in the code is read by nobody who plans the work, and a placeholder is a panic waiting for a user",
    fix: "finish it, return an error that says what is not supported, or open an issue and delete the note",
    excusable: false,
};

pub(crate) fn check(tree: &Tree) -> Vec<Finding> {
    let mut findings = Vec::new();
    for (path, text) in tree.rust() {
        let scan = scan(text);
        for (index, token) in scan.tokens.iter().enumerate() {
            if MACROS.contains(&token.text) && scan.text(index + 1) == "!" {
                findings.push(Finding::new(&UNFINISHED, path, token.line, format!("`{}!`", token.text)));
            }
        }
        for comment in &scan.comments {
            for (offset, line) in comment.text.lines().enumerate() {
                if let Some(mark) = mark_in(line) {
                    findings.push(Finding::new(&UNFINISHED, path, comment.line + offset, mark));
                }
            }
        }
    }
    for (path, text) in tree.texts().filter(|(path, _)| path.ends_with(".md") || path.ends_with(".toml")) {
        for (index, line) in text.lines().enumerate() {
            if let Some(mark) = mark_in(line) {
                findings.push(Finding::new(&UNFINISHED, path, index + 1, mark));
            }
        }
    }
    findings
}

/// The mark that `line` has as a whole word.
fn mark_in(line: &str) -> Option<&'static str> {
    let mut words = line.split(|character: char| !character.is_alphanumeric());
    words.find_map(|word| MARKS.iter().find(|mark| **mark == word)).copied()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn macros_and_marks_are_found() {
        let text = format!("fn f() {{ todo!() }}\n// {}: later\n/* a\n {} */\n", MARKS[0], MARKS[1]);
        let lines: Vec<usize> = check(&Tree::of(&[("a.rs", &text)])).iter().map(|finding| finding.line).collect();
        assert_eq!(lines, [1, 2, 4]);
    }

    #[test]
    fn names_that_only_contain_a_mark_are_not() {
        assert!(check(&Tree::of(&[("a.rs", "const TODO_LIST: u8 = 1; fn todo() {} // AXXXB\n")])).is_empty());
    }
}
