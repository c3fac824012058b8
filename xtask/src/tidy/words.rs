//! No path of somebody's machine, and no word about how the text came to be, in anything that is shipped.

use super::finding::{Finding, Rule};
use super::tree::Tree;

/// Beginnings of absolute paths; split so that this file does not find itself.
const PATHS: [&str; 6] = [
    concat!("/ho", "me/"),
    concat!("/ro", "ot/"),
    concat!("/Us", "ers/"),
    concat!("/wo", "rk/"),
    concat!("/mn", "t/"),
    concat!("C:\\Us", "ers"),
];

/// Whole words, in lower case; a plural `s` is understood.
const WORDS: [&str; 5] = [
    concat!("assis", "tant"),
    concat!("chat", "bot"),
    concat!("pro", "mpt"),
    concat!("sess", "ion"),
    concat!("ll", "m"),
];

static WORD: Rule = Rule {
    name: "words",
    why: "the text must mean the same on every machine and to every reader, and talk about the program only",
    fix: "write a path relative to the workspace, or say it without the word",
    excusable: true,
};

pub(crate) fn check(tree: &Tree) -> Vec<Finding> {
    let mut findings = Vec::new();
    for (path, text) in tree.texts().filter(|(path, _)| is_ours(path)) {
        for (index, line) in text.lines().enumerate() {
            if let Some(found) = path_in(line).or_else(|| word_in(line)) {
                findings.push(Finding::new(&WORD, path, index + 1, format!("`{found}`")));
            }
        }
    }
    findings
}

/// Lock files and licences are written by others.
fn is_ours(path: &str) -> bool {
    !path.ends_with("Cargo.lock") && !path.starts_with("LICENSE")
}

/// An absolute path: one of [`PATHS`] where no longer path leads up to it.
fn path_in(line: &str) -> Option<&'static str> {
    let leads_up = |before: &str| before.ends_with(|last: char| last.is_alphanumeric() || "._-/)}".contains(last));
    PATHS.into_iter().find(|path| line.match_indices(path).any(|(at, _)| !leads_up(&line[..at])))
}

fn word_in(line: &str) -> Option<&'static str> {
    let lower = line.to_lowercase();
    let mut words = lower.split(|character: char| !character.is_alphanumeric());
    words.find_map(|word| WORDS.into_iter().find(|known| word == *known || word.strip_suffix('s') == Some(known)))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn count(text: &str) -> usize {
        check(&Tree::of(&[("docs/a.md", text)])).len()
    }

    #[test]
    fn absolute_paths_are_found() {
        for path in PATHS {
            assert_eq!(count(&format!("see `{path}x`")), 1, "{path}");
        }
    }

    #[test]
    fn paths_inside_longer_ones_are_not() {
        assert_eq!(count(&format!("https://example.org{}x and ..{}x", PATHS[0], PATHS[3])), 0);
    }

    #[test]
    fn words_are_whole_and_in_any_case() {
        assert_eq!(count(&format!("An {}s", WORDS[0].to_uppercase())), 1);
        assert_eq!(count("promptly, obsession"), 0);
    }
}
