//! Links in Markdown that point into the tree resolve: to a file, to a folder, and to a heading where one is named.
//!
//! Understood: `[text](target)`, `![text](target)`, `[label]: target`, `src="target"` and `href="target"`. Links to
//! other hosts are not looked up; fenced blocks and code spans are not Markdown.

use super::finding::{Finding, Rule};
use super::tree::Tree;

static LINK: Rule = Rule {
    name: "link",
    why: "a reader who follows a link to nowhere stops trusting the page",
    fix: "correct the target; it is relative to the Markdown file",
    excusable: false,
};

pub(crate) fn check(tree: &Tree) -> Vec<Finding> {
    let mut findings = Vec::new();
    for (path, text) in tree.texts().filter(|(path, _)| path.ends_with(".md")) {
        for (line, prose) in prose_lines(text) {
            for target in targets(&prose) {
                if let Some(problem) = problem(tree, path, &target) {
                    findings.push(Finding::new(&LINK, path, line, problem));
                }
            }
        }
    }
    findings
}

/// The lines outside fenced blocks, with code spans blanked, numbered from 1.
fn prose_lines(text: &str) -> Vec<(usize, String)> {
    let mut fenced = false;
    let mut lines = Vec::new();
    for (index, line) in text.lines().enumerate() {
        if line.trim_start().starts_with("```") {
            fenced = !fenced;
        } else if !fenced {
            lines.push((index + 1, without_code_spans(line)));
        }
    }
    lines
}

fn without_code_spans(line: &str) -> String {
    let parts: Vec<&str> = line.split('`').collect();
    // An odd backtick at the end opens nothing.
    let closed = if parts.len().is_multiple_of(2) { parts.len() - 1 } else { parts.len() };
    let prose = |(index, part): (usize, &&str)| {
        if index % 2 == 1 && index < closed { String::new() } else { (*part).to_owned() }
    };
    parts.iter().enumerate().map(prose).collect()
}

/// Everything on the line that is the target of a link.
fn targets(line: &str) -> Vec<String> {
    let mut targets = Vec::new();
    for opening in ["](", "src=\"", "href=\""] {
        let closing = if opening == "](" { ')' } else { '"' };
        for (at, _) in line.match_indices(opening) {
            let rest = &line[at + opening.len()..];
            let target = rest.split(closing).next().unwrap_or_default();
            // A title may follow the target.
            let target = target.split(" \"").next().unwrap_or_default();
            targets.push(target.trim_matches(['<', '>', ' ']).to_owned());
        }
    }
    if let Some((label, target)) = line.split_once("]: ")
        && label.starts_with('[')
        && !label.starts_with("[^")
    {
        targets.push(target.split_whitespace().next().unwrap_or_default().to_owned());
    }
    targets
}

/// What is wrong with `target` as written in the file at `path`, if anything.
fn problem(tree: &Tree, path: &str, target: &str) -> Option<String> {
    // `crate::Item` is a link of rustdoc, which checks it itself.
    let is_elsewhere = target.contains("://") || target.starts_with("mailto:") || target.contains("::");
    if is_elsewhere || target.is_empty() {
        return None;
    }
    let (file, heading) = target.split_once('#').map_or((target, None), |(file, heading)| (file, Some(heading)));
    let resolved = if file.is_empty() { path.to_owned() } else { resolve(path, file)? };
    if !tree.contains(&resolved) {
        return Some(format!("`{target}` is not in the tree"));
    }
    let heading = heading.filter(|_| resolved.ends_with(".md"))?;
    let headings = headings(tree.text(&resolved)?);
    (!headings.iter().any(|known| known == heading)).then(|| format!("`{target}`: no such heading"))
}

/// `file` as seen from the folder of `path`; `None` where it leaves the tree, as data beside the workspace does.
fn resolve(path: &str, file: &str) -> Option<String> {
    let mut parts: Vec<&str> = path.split('/').collect();
    parts.pop();
    if file.starts_with('/') {
        parts.clear();
    }
    for part in file.split('/') {
        match part {
            "" | "." => {}
            ".." => {
                parts.pop()?;
            }
            _ => parts.push(part),
        }
    }
    Some(parts.join("/"))
}

/// The anchors of the headings, as GitHub makes them: lower case, punctuation dropped, blanks to hyphens.
fn headings(text: &str) -> Vec<String> {
    let mut anchors: Vec<String> = Vec::new();
    for (_, line) in heading_lines(text) {
        let kept =
            line.to_lowercase().chars().filter(|c| c.is_alphanumeric() || " -_".contains(*c)).collect::<String>();
        let anchor = kept.trim().replace(' ', "-");
        let repeated = anchors.iter().filter(|known| **known == anchor).count();
        anchors.push(if repeated == 0 { anchor } else { format!("{anchor}-{repeated}") });
    }
    anchors
}

fn heading_lines(text: &str) -> Vec<(usize, &str)> {
    let mut fenced = false;
    let mut lines = Vec::new();
    for (index, line) in text.lines().enumerate() {
        if line.trim_start().starts_with("```") {
            fenced = !fenced;
        } else if !fenced && line.starts_with('#') {
            lines.push((index + 1, line.trim_start_matches('#').trim()));
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    fn broken(text: &str) -> usize {
        let tree = Tree::of(&[
            ("docs/a.md", text),
            ("docs/b.md", "# One `two`, three!\n"),
            ("README.md", ""),
            ("src/x.rs", ""),
        ]);
        check(&tree).len()
    }

    #[test]
    fn files_folders_and_headings_resolve() {
        assert_eq!(
            broken("[a](b.md) [b](../README.md) [c](../src) ![d](/src/x.rs) [e](b.md#one-two-three)\n[l]: b.md\n"),
            0
        );
        assert_eq!(
            broken("# Here\n[f](#here) [g](https://example.org/x) [h](mailto:a@example.org) [i](crate::Item)\n"),
            0
        );
    }

    #[test]
    fn dead_targets_are_found() {
        assert_eq!(broken("[a](c.md) ![b](x.png \"title\")\n[l]: d.md\n<img src=\"e.png\">\n"), 4);
        assert_eq!(broken("[a](b.md#four) [b](#nowhere)\n"), 2);
    }

    #[test]
    fn code_is_not_a_link() {
        assert_eq!(broken("`[a](c.md)`\n```text\n[a](c.md)\n```\n"), 0);
    }
}
