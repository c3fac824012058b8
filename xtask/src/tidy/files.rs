//! Rules about files as such: headers, lengths, names, the documents every project has, sizes of golden pictures.

use super::finding::{Finding, Rule};
use super::tree::Tree;

const LONGEST_SOURCE: usize = 600;
const LONGEST_ARCHITECTURE: usize = 250;
const LARGEST_GOLDEN_BYTES: usize = 20 * 1024;
const DOCUMENTS: [&str; 6] =
    ["README.md", "ARCHITECTURE.md", "CONTRIBUTING.md", "CHANGELOG.md", "LICENSE-MIT", "LICENSE-APACHE"];
const VAGUE_NAMES: [&str; 10] =
    ["util", "utils", "manager", "data", "info", "helper", "helpers", "misc", "common", "stuff"];

static HEADER: Rule = Rule {
    name: "header",
    why: "a reader must learn from the first lines what goes in, what comes out and the one idea",
    fix: "begin the file with `//!` and three to fifteen lines that say so",
    excusable: false,
};

static LENGTH: Rule = Rule {
    name: "length",
    why: "what does not fit into a few screens is not read as a whole, and usually does two things",
    fix: "split it by what its parts produce; the longest part of ARCHITECTURE.md belongs into docs/",
    excusable: false,
};

static NAME: Rule = Rule {
    name: "name",
    why: "a name that fits everything says nothing: the listing of a folder is the architecture",
    fix: "name the file after the thing it produces, in the field's words",
    excusable: false,
};

static DOCUMENT: Rule = Rule {
    name: "document",
    why: "users and contributors look for these files by name",
    fix: "add the file at the root of the workspace",
    excusable: false,
};

static GOLDEN_SIZE: Rule = Rule {
    name: "golden-size",
    why: "golden pictures stay in the history for ever, and a small one shows its one idea better",
    fix: "draw the case smaller, or with fewer colours",
    excusable: false,
};

/// Every Rust file begins with inner documentation.
pub(crate) fn headers(tree: &Tree) -> Vec<Finding> {
    tree.rust()
        .filter(|(_, text)| !text.starts_with("//! "))
        .map(|(path, _)| Finding::new(&HEADER, path, 1, "does not begin with `//! `"))
        .collect()
}

/// No source file and no ARCHITECTURE.md beyond its limit.
pub(crate) fn lengths(tree: &Tree) -> Vec<Finding> {
    let mut findings = Vec::new();
    for (path, text) in tree.texts() {
        let longest = match path {
            "ARCHITECTURE.md" => LONGEST_ARCHITECTURE,
            _ if path.ends_with(".rs") => LONGEST_SOURCE,
            _ => continue,
        };
        let lines = text.lines().count();
        if lines > longest {
            findings.push(Finding::new(&LENGTH, path, longest + 1, format!("{lines} lines, at most {longest}")));
        }
    }
    findings
}

/// No source file or folder of sources with a name that could be anything.
pub(crate) fn names(tree: &Tree) -> Vec<Finding> {
    let mut findings = Vec::new();
    for (path, _) in tree.rust() {
        let vague = path.trim_end_matches(".rs").split('/').find(|part| VAGUE_NAMES.contains(part));
        if let Some(part) = vague {
            findings.push(Finding::new(&NAME, path, 0, format!("`{part}` does not say what is inside")));
        }
    }
    findings
}

/// The documents at the root exist.
pub(crate) fn documents(tree: &Tree) -> Vec<Finding> {
    DOCUMENTS
        .iter()
        .filter(|path| tree.text(path).is_none())
        .map(|path| Finding::new(&DOCUMENT, path, 0, "is missing"))
        .collect()
}

/// Golden pictures are small.
pub(crate) fn golden_sizes(tree: &Tree) -> Vec<Finding> {
    tree.files
        .iter()
        .filter(|file| file.path.starts_with("tests/golden/") && file.path.ends_with(".png"))
        .filter(|file| file.size_bytes > LARGEST_GOLDEN_BYTES)
        .map(|file| {
            let message = format!("{} bytes, at most {LARGEST_GOLDEN_BYTES}", file.size_bytes);
            Finding::new(&GOLDEN_SIZE, &file.path, 0, message)
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn header_is_the_first_line() {
        let tree = Tree::of(&[("a.rs", "//! Good.\n"), ("b.rs", "// Bad.\n"), ("c.rs", ""), ("d.rs", "\n//! Late.\n")]);
        let found: Vec<String> = headers(&tree).into_iter().map(|finding| finding.path).collect();
        assert_eq!(found, ["b.rs", "c.rs", "d.rs"]);
    }

    #[test]
    fn limits_are_inclusive() {
        let (just, over) = ("x\n".repeat(600), "x\n".repeat(601));
        let (just_doc, over_doc) = ("x\n".repeat(250), "x\n".repeat(251));
        assert!(lengths(&Tree::of(&[("a.rs", &just), ("ARCHITECTURE.md", &just_doc)])).is_empty());
        assert_eq!(lengths(&Tree::of(&[("a.rs", &over), ("ARCHITECTURE.md", &over_doc)])).len(), 2);
    }

    #[test]
    fn vague_names_are_whole_words() {
        let tree =
            Tree::of(&[("crates/a/src/data.rs", ""), ("crates/a/src/util/x.rs", ""), ("crates/a/src/metadata.rs", "")]);
        assert_eq!(names(&tree).len(), 2);
    }

    #[test]
    fn a_missing_document_is_found() {
        let tree = Tree::of(&[("README.md", ""), ("docs/CHANGELOG.md", "")]);
        assert_eq!(documents(&tree).len(), DOCUMENTS.len() - 1);
    }

    #[test]
    fn only_golden_pictures_have_a_size_limit() {
        let (small, large) = ("x".repeat(20 * 1024), "x".repeat(20 * 1024 + 1));
        let tree =
            Tree::of(&[("tests/golden/a/s.png", &small), ("tests/golden/a/l.png", &large), ("assets/l.png", &large)]);
        assert_eq!(golden_sizes(&tree).len(), 1);
    }
}
