//! A broken rule and where: what every check of this folder returns.

/// One rule of the workspace.
#[derive(Debug, PartialEq, Eq, Clone, Copy)]
pub(crate) struct Rule {
    /// Short and hyphenated; what `tidy: allow(name): reason` refers to.
    pub(crate) name: &'static str,
    /// The harm that the rule prevents.
    pub(crate) why: &'static str,
    /// What to do about a finding.
    pub(crate) fix: &'static str,
    /// Whether a comment `tidy: allow(name): reason` on the line, or on the line above, excuses a finding.
    pub(crate) excusable: bool,
}

/// One place that breaks a rule.
#[derive(Debug, Clone)]
pub(crate) struct Finding {
    pub(crate) rule: &'static Rule,
    /// Relative to the workspace root, with forward slashes.
    pub(crate) path: String,
    /// Counted from 1; 0 where the finding is about the whole file.
    pub(crate) line: usize,
    pub(crate) message: String,
}

impl Finding {
    pub(crate) fn new(rule: &'static Rule, path: &str, line: usize, message: impl Into<String>) -> Self {
        Self { rule, path: path.to_owned(), line, message: message.into() }
    }

    /// `path:line: message`, in the form that editors and terminals turn into a link.
    pub(crate) fn place_and_message(&self) -> String {
        if self.line == 0 {
            format!("{}: {}", self.path, self.message)
        } else {
            format!("{}:{}: {}", self.path, self.line, self.message)
        }
    }
}
