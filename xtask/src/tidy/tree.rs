//! The working tree as the rules see it: paths, sizes and texts, from git or from strings in a test.
//!
//! Tracked files and new files that git does not ignore are both in it, so a finding appears before the first
//! `git add`.

use std::path::Path;
use std::process::Command;

/// All files, sorted by path.
#[derive(Debug, Default)]
pub(crate) struct Tree {
    pub(crate) files: Vec<File>,
}

/// One file of the tree.
#[derive(Debug)]
pub(crate) struct File {
    /// Relative to the workspace root, with forward slashes.
    pub(crate) path: String,
    pub(crate) size_bytes: usize,
    /// `None` where the bytes are not UTF-8.
    pub(crate) text: Option<String>,
}

impl Tree {
    /// Reads the tree below `root`.
    pub(crate) fn read(root: &Path) -> Result<Self, String> {
        let listing = Command::new("git")
            .current_dir(root)
            .args(["ls-files", "-z", "--cached", "--others", "--exclude-standard"])
            .output()
            .map_err(|error| format!("git does not start: {error}"))?;
        if !listing.status.success() {
            return Err(format!("git ls-files fails: {}", String::from_utf8_lossy(&listing.stderr).trim()));
        }
        let mut paths: Vec<String> = String::from_utf8_lossy(&listing.stdout)
            .split('\0')
            .filter(|path| !path.is_empty())
            .map(str::to_owned)
            .collect();
        paths.sort();
        paths.dedup();
        let mut files = Vec::with_capacity(paths.len());
        for path in paths {
            // A file that is deleted but still in the index has nothing to check.
            let Ok(bytes) = std::fs::read(root.join(&path)) else { continue };
            files.push(File { path, size_bytes: bytes.len(), text: String::from_utf8(bytes).ok() });
        }
        Ok(Self { files })
    }

    /// A tree of the given paths and texts.
    #[cfg(test)]
    pub(crate) fn of(files: &[(&str, &str)]) -> Self {
        let file = |&(path, text): &(&str, &str)| File {
            path: path.to_owned(),
            size_bytes: text.len(),
            text: Some(text.to_owned()),
        };
        Self { files: files.iter().map(file).collect() }
    }

    /// Paths and texts of the Rust sources.
    pub(crate) fn rust(&self) -> impl Iterator<Item = (&str, &str)> {
        self.texts().filter(|(path, _)| path.ends_with(".rs"))
    }

    /// Paths and texts of all files that are text.
    pub(crate) fn texts(&self) -> impl Iterator<Item = (&str, &str)> {
        self.files.iter().filter_map(|file| Some((file.path.as_str(), file.text.as_deref()?)))
    }

    /// The text of the file at `path`, if it exists and is text.
    pub(crate) fn text(&self, path: &str) -> Option<&str> {
        self.files.iter().find(|file| file.path == path)?.text.as_deref()
    }

    /// Whether `path` is a file of the tree, or a folder with one inside.
    pub(crate) fn contains(&self, path: &str) -> bool {
        self.files.iter().any(|file| {
            file.path == path
                || file.path.strip_prefix(path).is_some_and(|rest| path.is_empty() || rest.starts_with('/'))
        })
    }
}
